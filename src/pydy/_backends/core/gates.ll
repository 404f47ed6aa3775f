; sources 1af17be90229e4bb79d793fd129ea07d66995c317234f24ca098d3c81923b514
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Words = type { ptr, ptr, ptr, ptr, i64, i64, i64, i64, i64, i64, i64, i64, %struct.Distances, %struct.Distances, %struct.Distances }
%struct.Distances = type { i64, i64 }

@PyFloat_Type = external global i8, align 1
@_Py_TrueStruct = external global i8, align 1

define range(i64 0, 2) i64 @sweep_1(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
  %9 = getelementptr inbounds i8, ptr %0, i64 8
  %10 = load ptr, ptr %9, align 8
  tail call void %10(ptr noundef %4, ptr noundef %7) #5
  %11 = getelementptr inbounds i8, ptr %0, i64 88
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %22

14:                                               ; preds = %8
  %15 = getelementptr inbounds i8, ptr %0, i64 128
  %16 = getelementptr inbounds i8, ptr %0, i64 96
  %17 = getelementptr inbounds i8, ptr %0, i64 112
  %18 = getelementptr inbounds i8, ptr %0, i64 64
  br label %24

19:                                               ; preds = %43
  %20 = icmp eq i64 %44, 0
  %21 = zext i1 %20 to i64
  br label %22

22:                                               ; preds = %19, %8
  %23 = phi i64 [ 1, %8 ], [ %21, %19 ]
  ret i64 %23

24:                                               ; preds = %14, %43
  %25 = phi i64 [ 0, %14 ], [ %44, %43 ]
  %26 = phi i64 [ 0, %14 ], [ %45, %43 ]
  %27 = load i64, ptr %15, align 8
  %28 = mul nsw i64 %27, %26
  %29 = getelementptr inbounds double, ptr %5, i64 %28
  %30 = load ptr, ptr %0, align 8
  %31 = getelementptr inbounds double, ptr %1, i64 %26
  %32 = load i64, ptr %16, align 8
  %33 = mul nsw i64 %32, %26
  %34 = getelementptr inbounds double, ptr %2, i64 %33
  %35 = load i64, ptr %17, align 8
  %36 = mul nsw i64 %35, %26
  %37 = getelementptr inbounds double, ptr %3, i64 %36
  %38 = tail call i32 %30(ptr noundef %31, ptr noundef %34, ptr noundef %37, ptr noundef %7, ptr noundef %29) #5
  %39 = trunc i32 %38 to i8
  %40 = getelementptr inbounds i8, ptr %6, i64 %26
  store i8 %39, ptr %40, align 1
  %41 = load i64, ptr %18, align 8
  %42 = icmp sgt i64 %41, 0
  br i1 %42, label %48, label %43

43:                                               ; preds = %48, %24
  %44 = phi i64 [ %25, %24 ], [ %55, %48 ]
  %45 = add nuw nsw i64 %26, 1
  %46 = load i64, ptr %11, align 8
  %47 = icmp slt i64 %45, %46
  br i1 %47, label %24, label %19, !llvm.loop !3

48:                                               ; preds = %24, %48
  %49 = phi i64 [ %55, %48 ], [ %25, %24 ]
  %50 = phi i64 [ %56, %48 ], [ 0, %24 ]
  %51 = getelementptr inbounds double, ptr %29, i64 %50
  %52 = load double, ptr %51, align 8
  %53 = fsub double %52, %52
  %54 = bitcast double %53 to i64
  %55 = or i64 %49, %54
  %56 = add nuw nsw i64 %50, 1
  %57 = icmp eq i64 %56, %41
  br i1 %57, label %43, label %48, !llvm.loop !6
}



define ptr @sweep_gate(ptr noundef readnone %0, ptr noundef readonly %1, i64 noundef %2) #0 {
  %4 = alloca %struct.Words, align 8
  %5 = load ptr, ptr %1, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 16
  %7 = load ptr, ptr %6, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(144) %4, ptr noundef nonnull align 8 dereferenceable(144) %7, i64 144, i1 false)
  %8 = getelementptr inbounds i8, ptr %1, i64 8
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 32
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %4, i64 88
  store i64 %12, ptr %13, align 8
  %14 = getelementptr inbounds i8, ptr %4, i64 96
  %15 = getelementptr inbounds i8, ptr %1, i64 16
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %16, i64 40
  %18 = load ptr, ptr %17, align 8
  %19 = load i64, ptr %18, align 8
  %20 = sdiv i64 %19, 8
  %21 = getelementptr inbounds i8, ptr %18, i64 8
  %22 = load i64, ptr %21, align 8
  %23 = sdiv i64 %22, 8
  store i64 %20, ptr %14, align 8
  %24 = getelementptr inbounds i8, ptr %4, i64 104
  store i64 %23, ptr %24, align 8
  %25 = getelementptr inbounds i8, ptr %4, i64 112
  %26 = getelementptr inbounds i8, ptr %1, i64 24
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 40
  %29 = load ptr, ptr %28, align 8
  %30 = load i64, ptr %29, align 8
  %31 = sdiv i64 %30, 8
  %32 = getelementptr inbounds i8, ptr %29, i64 8
  %33 = load i64, ptr %32, align 8
  %34 = sdiv i64 %33, 8
  store i64 %31, ptr %25, align 8
  %35 = getelementptr inbounds i8, ptr %4, i64 120
  store i64 %34, ptr %35, align 8
  %36 = getelementptr inbounds i8, ptr %4, i64 128
  %37 = getelementptr inbounds i8, ptr %1, i64 40
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %38, i64 40
  %40 = load ptr, ptr %39, align 8
  %41 = load i64, ptr %40, align 8
  %42 = sdiv i64 %41, 8
  %43 = getelementptr inbounds i8, ptr %40, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = sdiv i64 %44, 8
  store i64 %42, ptr %36, align 8
  %46 = getelementptr inbounds i8, ptr %4, i64 136
  store i64 %45, ptr %46, align 8
  %47 = getelementptr inbounds i8, ptr %27, i64 32
  %48 = load ptr, ptr %47, align 8
  %49 = load i64, ptr %48, align 8
  %50 = icmp eq i64 %49, 1
  br i1 %50, label %51, label %52

51:                                               ; preds = %3
  store i64 0, ptr %25, align 8
  br label %52

52:                                               ; preds = %51, %3
  %53 = tail call ptr @PyEval_SaveThread() #5
  %54 = getelementptr inbounds i8, ptr %4, i64 24
  %55 = load ptr, ptr %54, align 8
  %56 = load ptr, ptr %8, align 8
  %57 = getelementptr inbounds i8, ptr %56, i64 16
  %58 = load ptr, ptr %57, align 8
  %59 = load ptr, ptr %15, align 8
  %60 = getelementptr inbounds i8, ptr %59, i64 16
  %61 = load ptr, ptr %60, align 8
  %62 = load ptr, ptr %26, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 16
  %64 = load ptr, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %1, i64 32
  %66 = load ptr, ptr %65, align 8
  %67 = getelementptr inbounds i8, ptr %66, i64 16
  %68 = load ptr, ptr %67, align 8
  %69 = load ptr, ptr %37, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 16
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %1, i64 48
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 16
  %75 = load ptr, ptr %74, align 8
  %76 = getelementptr inbounds i8, ptr %1, i64 56
  %77 = load ptr, ptr %76, align 8
  %78 = getelementptr inbounds i8, ptr %77, i64 16
  %79 = load ptr, ptr %78, align 8
  %80 = call i64 %55(ptr noundef nonnull %4, ptr noundef %58, ptr noundef %61, ptr noundef %64, ptr noundef %68, ptr noundef %71, ptr noundef %75, ptr noundef %79) #5
  call void @PyEval_RestoreThread(ptr noundef %53) #5
  %81 = call ptr @PyLong_FromLongLong(i64 noundef %80) #5
  ret ptr %81
}

declare void @llvm.memcpy.p0.p0.i64(ptr noalias writeonly, ptr noalias readonly, i64, i1 immarg) #2

declare ptr @PyEval_SaveThread() #3

declare void @PyEval_RestoreThread(ptr noundef) #3

declare ptr @PyLong_FromLongLong(i64 noundef) #3

define ptr @kernel_gate(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) #0 {
  %4 = alloca double, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 16
  %6 = load ptr, ptr %5, align 8
  %7 = icmp eq i64 %2, 5
  br i1 %7, label %8, label %104

8:                                                ; preds = %3
  %9 = load ptr, ptr %6, align 8
  %10 = icmp eq ptr %9, null
  br i1 %10, label %104, label %11

11:                                               ; preds = %8
  %12 = load ptr, ptr %1, align 8
  %13 = getelementptr inbounds i8, ptr %1, i64 32
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %6, i64 16
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %12, i64 8
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %14, i64 8
  %20 = load ptr, ptr %19, align 8
  %21 = icmp eq ptr %18, %20
  br i1 %21, label %22, label %104

22:                                               ; preds = %11
  %23 = getelementptr inbounds i8, ptr %12, i64 56
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %14, i64 56
  %26 = load ptr, ptr %25, align 8
  %27 = icmp eq ptr %24, %26
  br i1 %27, label %28, label %104

28:                                               ; preds = %22
  %29 = getelementptr inbounds i8, ptr %12, i64 24
  %30 = load i32, ptr %29, align 4
  %31 = icmp eq i32 %30, 1
  br i1 %31, label %32, label %104

32:                                               ; preds = %28
  %33 = getelementptr inbounds i8, ptr %12, i64 64
  %34 = load i32, ptr %33, align 4
  %35 = and i32 %34, 257
  %36 = icmp eq i32 %35, 257
  br i1 %36, label %37, label %104

37:                                               ; preds = %32
  %38 = getelementptr inbounds i8, ptr %12, i64 32
  %39 = load ptr, ptr %38, align 8
  %40 = load i64, ptr %39, align 8
  %41 = icmp eq i64 %40, %16
  br i1 %41, label %42, label %104

42:                                               ; preds = %37
  %43 = getelementptr inbounds i8, ptr %1, i64 8
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds i8, ptr %44, i64 8
  %46 = load ptr, ptr %45, align 8
  %47 = icmp eq ptr %46, @PyFloat_Type
  br i1 %47, label %48, label %104

48:                                               ; preds = %42
  %49 = getelementptr inbounds i8, ptr %1, i64 16
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %6, i64 24
  %52 = load i64, ptr %51, align 8
  %53 = getelementptr inbounds i8, ptr %50, i64 8
  %54 = load ptr, ptr %53, align 8
  %55 = icmp eq ptr %54, %20
  br i1 %55, label %56, label %104

56:                                               ; preds = %48
  %57 = getelementptr inbounds i8, ptr %50, i64 56
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %14, i64 56
  %60 = load ptr, ptr %59, align 8
  %61 = icmp eq ptr %58, %60
  br i1 %61, label %62, label %104

62:                                               ; preds = %56
  %63 = getelementptr inbounds i8, ptr %50, i64 24
  %64 = load i32, ptr %63, align 4
  %65 = icmp eq i32 %64, 1
  br i1 %65, label %66, label %104

66:                                               ; preds = %62
  %67 = getelementptr inbounds i8, ptr %50, i64 64
  %68 = load i32, ptr %67, align 4
  %69 = and i32 %68, 257
  %70 = icmp eq i32 %69, 257
  br i1 %70, label %71, label %104

71:                                               ; preds = %66
  %72 = getelementptr inbounds i8, ptr %50, i64 32
  %73 = load ptr, ptr %72, align 8
  %74 = load i64, ptr %73, align 8
  %75 = icmp eq i64 %74, %52
  br i1 %75, label %76, label %104

76:                                               ; preds = %71
  %77 = getelementptr inbounds i8, ptr %1, i64 24
  %78 = load ptr, ptr %77, align 8
  %79 = getelementptr inbounds i8, ptr %6, i64 32
  %80 = load i64, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %78, i64 8
  %82 = load ptr, ptr %81, align 8
  %83 = icmp eq ptr %82, %20
  br i1 %83, label %84, label %104

84:                                               ; preds = %76
  %85 = getelementptr inbounds i8, ptr %78, i64 56
  %86 = load ptr, ptr %85, align 8
  %87 = getelementptr inbounds i8, ptr %14, i64 56
  %88 = load ptr, ptr %87, align 8
  %89 = icmp eq ptr %86, %88
  br i1 %89, label %90, label %104

90:                                               ; preds = %84
  %91 = getelementptr inbounds i8, ptr %78, i64 24
  %92 = load i32, ptr %91, align 4
  %93 = icmp eq i32 %92, 1
  br i1 %93, label %94, label %104

94:                                               ; preds = %90
  %95 = getelementptr inbounds i8, ptr %78, i64 64
  %96 = load i32, ptr %95, align 4
  %97 = and i32 %96, 257
  %98 = icmp eq i32 %97, 257
  br i1 %98, label %99, label %104

99:                                               ; preds = %94
  %100 = getelementptr inbounds i8, ptr %78, i64 32
  %101 = load ptr, ptr %100, align 8
  %102 = load i64, ptr %101, align 8
  %103 = icmp eq i64 %102, %80
  br i1 %103, label %106, label %104

104:                                              ; preds = %94, %90, %84, %76, %66, %62, %56, %48, %32, %28, %22, %11, %99, %71, %42, %37, %8, %3
  %105 = tail call ptr @PyLong_FromLongLong(i64 noundef -1) #5
  br label %141

106:                                              ; preds = %99
  %107 = getelementptr inbounds i8, ptr %44, i64 16
  %108 = load double, ptr %107, align 8
  store double %108, ptr %4, align 8
  %109 = getelementptr inbounds i8, ptr %78, i64 16
  %110 = load ptr, ptr %109, align 8
  %111 = getelementptr inbounds i8, ptr %6, i64 64
  %112 = getelementptr inbounds double, ptr %111, i64 %80
  %113 = shl i64 %80, 3
  %114 = tail call i32 @memcmp(ptr noundef nonnull %111, ptr noundef %110, i64 noundef %113) #5
  %115 = icmp eq i32 %114, 0
  br i1 %115, label %116, label %122

116:                                              ; preds = %106
  %117 = getelementptr inbounds i8, ptr %6, i64 56
  %118 = load ptr, ptr %117, align 8
  %119 = getelementptr inbounds i8, ptr %6, i64 8
  %120 = load ptr, ptr %119, align 8
  %121 = icmp eq ptr %118, %120
  br i1 %121, label %127, label %122

122:                                              ; preds = %116, %106
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %111, ptr align 8 %110, i64 %113, i1 false)
  %123 = getelementptr inbounds i8, ptr %6, i64 8
  %124 = load ptr, ptr %123, align 8
  tail call void %124(ptr noundef nonnull %111, ptr noundef nonnull %112) #5
  %125 = load ptr, ptr %123, align 8
  %126 = getelementptr inbounds i8, ptr %6, i64 56
  store ptr %125, ptr %126, align 8
  br label %127

127:                                              ; preds = %122, %116
  %128 = load ptr, ptr %6, align 8
  %129 = load ptr, ptr %1, align 8
  %130 = getelementptr inbounds i8, ptr %129, i64 16
  %131 = load ptr, ptr %130, align 8
  %132 = load ptr, ptr %49, align 8
  %133 = getelementptr inbounds i8, ptr %132, i64 16
  %134 = load ptr, ptr %133, align 8
  %135 = load ptr, ptr %13, align 8
  %136 = getelementptr inbounds i8, ptr %135, i64 16
  %137 = load ptr, ptr %136, align 8
  %138 = call i32 %128(ptr noundef nonnull %4, ptr noundef %131, ptr noundef %134, ptr noundef nonnull %112, ptr noundef %137) #5
  %139 = sext i32 %138 to i64
  %140 = call ptr @PyLong_FromLongLong(i64 noundef %139) #5
  br label %141

141:                                              ; preds = %127, %104
  %142 = phi ptr [ %105, %104 ], [ %140, %127 ]
  ret ptr %142
}

declare i32 @memcmp(ptr noundef, ptr noundef, i64 noundef) #4

define ptr @step_gate(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) #0 {
  %4 = getelementptr inbounds i8, ptr %0, i64 16
  %5 = load ptr, ptr %4, align 8
  %6 = load i64, ptr %5, align 8
  %7 = inttoptr i64 %6 to ptr
  %8 = tail call ptr @PyEval_SaveThread() #5
  %9 = getelementptr inbounds i8, ptr %5, i64 8
  %10 = load i64, ptr %9, align 8
  %11 = load ptr, ptr %1, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 16
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %1, i64 8
  %15 = load ptr, ptr %14, align 8
  %16 = icmp eq ptr %15, @_Py_TrueStruct
  %17 = zext i1 %16 to i64
  %18 = tail call i64 %7(i64 noundef %10, ptr noundef %13, i64 noundef %17) #5
  tail call void @PyEval_RestoreThread(ptr noundef %8) #5
  %19 = tail call ptr @PyLong_FromLongLong(i64 noundef %18) #5
  ret ptr %19
}

define range(i32 -1, 1) i32 @call_python(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef readnone %2, ptr noundef readonly %3, ptr noundef writeonly %4) #0 {
  %6 = tail call ptr @PyErr_Occurred() #5
  %7 = icmp eq ptr %6, null
  br i1 %7, label %8, label %28

8:                                                ; preds = %5
  %9 = load double, ptr %0, align 8
  %10 = getelementptr inbounds i8, ptr %3, i64 8
  %11 = load ptr, ptr %10, align 8
  store double %9, ptr %11, align 8
  %12 = load ptr, ptr %10, align 8
  %13 = getelementptr inbounds i8, ptr %12, i64 8
  %14 = getelementptr inbounds i8, ptr %3, i64 16
  %15 = load i64, ptr %14, align 8
  %16 = shl i64 %15, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %13, ptr align 8 %1, i64 %16, i1 false)
  %17 = load ptr, ptr %3, align 8
  %18 = tail call ptr @PyObject_CallNoArgs(ptr noundef %17) #5
  %19 = icmp eq ptr %18, null
  br i1 %19, label %28, label %20

20:                                               ; preds = %8
  tail call void @Py_DecRef(ptr noundef nonnull %18) #5
  %21 = load ptr, ptr %10, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 8
  %23 = load i64, ptr %14, align 8
  %24 = getelementptr inbounds double, ptr %22, i64 %23
  %25 = getelementptr inbounds i8, ptr %3, i64 24
  %26 = load i64, ptr %25, align 8
  %27 = shl i64 %26, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %4, ptr nonnull align 8 %24, i64 %27, i1 false)
  br label %28

28:                                               ; preds = %20, %8, %5
  %29 = phi i32 [ -1, %5 ], [ 0, %20 ], [ -1, %8 ]
  ret i32 %29
}

declare ptr @PyErr_Occurred() #3

declare ptr @PyObject_CallNoArgs(ptr noundef) #3

declare void @Py_DecRef(ptr noundef) #3

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn }
attributes #3 = { nounwind }
attributes #4 = { nounwind }
attributes #5 = { nounwind }
attributes #6 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
