; sources 2b85f0b5af5ea83830739df0bda38c3ec3c50cea02be4ea8559fa53f3f6384eb
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Part = type { %struct.Words, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, i64 }
%struct.Words = type { ptr, ptr, ptr, ptr, i64, i64, i64, i64, i64, i64, i64, i64 }

define zeroext i1 @nlp_cost(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, ptr noundef writeonly %3, ptr noundef readonly %4) #0 {
  %6 = getelementptr inbounds i8, ptr %4, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %11

9:                                                ; preds = %5
  %10 = getelementptr inbounds i8, ptr %4, i64 56
  br label %18

11:                                               ; preds = %88, %5
  %12 = phi double [ 0.000000e+00, %5 ], [ %90, %88 ]
  %13 = getelementptr inbounds i8, ptr %4, i64 136
  %14 = load double, ptr %13, align 8
  %15 = fdiv double %12, %14
  store double %15, ptr %3, align 8
  %16 = fsub double %15, %15
  %17 = fcmp oeq double %16, 0.000000e+00
  ret i1 %17

18:                                               ; preds = %9, %88
  %19 = phi double [ 0.000000e+00, %9 ], [ %90, %88 ]
  %20 = phi i64 [ 0, %9 ], [ %91, %88 ]
  %21 = load ptr, ptr %10, align 8
  %22 = getelementptr inbounds %struct.Part, ptr %21, i64 %20
  %23 = getelementptr inbounds i8, ptr %22, i64 136
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %22, i64 72
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds i8, ptr %22, i64 32
  %28 = load i64, ptr %27, align 8
  %29 = mul nsw i64 %28, %26
  %30 = getelementptr inbounds i8, ptr %22, i64 96
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %22, i64 104
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds i8, ptr %22, i64 128
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %22, i64 152
  %37 = load ptr, ptr %36, align 8
  %38 = icmp sgt i64 %29, 0
  br i1 %38, label %41, label %39

39:                                               ; preds = %41, %18
  %40 = icmp sgt i64 %26, 0
  br i1 %40, label %64, label %53

41:                                               ; preds = %18, %41
  %42 = phi i64 [ %51, %41 ], [ 0, %18 ]
  %43 = getelementptr inbounds i64, ptr %31, i64 %42
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr inbounds double, ptr %1, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %33, i64 %42
  %48 = load double, ptr %47, align 8
  %49 = fmul double %46, %48
  %50 = getelementptr inbounds double, ptr %35, i64 %42
  store double %49, ptr %50, align 8
  %51 = add nuw nsw i64 %42, 1
  %52 = icmp eq i64 %51, %29
  br i1 %52, label %39, label %41, !llvm.loop !3

53:                                               ; preds = %64, %39
  %54 = getelementptr inbounds i8, ptr %22, i64 24
  %55 = load ptr, ptr %54, align 8
  %56 = load ptr, ptr %34, align 8
  %57 = getelementptr inbounds i8, ptr %22, i64 112
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %22, i64 120
  %60 = load ptr, ptr %59, align 8
  %61 = load ptr, ptr %36, align 8
  %62 = getelementptr inbounds i8, ptr %22, i64 144
  %63 = load ptr, ptr %62, align 8
  tail call void %55(ptr noundef %22, ptr noundef %56, ptr noundef %56, ptr noundef %58, ptr noundef %60, ptr noundef %24, ptr noundef %61, ptr noundef %63) #3
  br i1 %40, label %72, label %81

64:                                               ; preds = %39, %64
  %65 = phi i64 [ %67, %64 ], [ 0, %39 ]
  %66 = getelementptr inbounds i8, ptr %37, i64 %65
  store i8 0, ptr %66, align 1
  %67 = add nuw nsw i64 %65, 1
  %68 = icmp eq i64 %67, %26
  br i1 %68, label %53, label %64, !llvm.loop !6

69:                                               ; preds = %72
  %70 = icmp eq i32 %78, 0
  %71 = zext i1 %70 to i32
  br label %81

72:                                               ; preds = %53, %72
  %73 = phi i64 [ %79, %72 ], [ 0, %53 ]
  %74 = phi i32 [ %78, %72 ], [ 0, %53 ]
  %75 = getelementptr inbounds i8, ptr %37, i64 %73
  %76 = load i8, ptr %75, align 1
  %77 = zext i8 %76 to i32
  %78 = or i32 %74, %77
  %79 = add nuw nsw i64 %73, 1
  %80 = icmp eq i64 %79, %26
  br i1 %80, label %69, label %72, !llvm.loop !7

81:                                               ; preds = %53, %69
  %82 = phi i32 [ 1, %53 ], [ %71, %69 ]
  %83 = icmp eq i32 %82, 0
  br i1 %83, label %88, label %84

84:                                               ; preds = %81
  %85 = load ptr, ptr %23, align 8
  %86 = load i64, ptr %25, align 8
  %87 = tail call fastcc double @sum(ptr noundef %85, i64 noundef %86) #4
  br label %88

88:                                               ; preds = %81, %84
  %89 = phi double [ %87, %84 ], [ 0x7FF8000000000000, %81 ]
  %90 = fadd double %19, %89
  %91 = add nuw nsw i64 %20, 1
  %92 = load i64, ptr %6, align 8
  %93 = icmp slt i64 %91, %92
  br i1 %93, label %18, label %11, !llvm.loop !8
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
  br i1 %26, label %5, label %19, !llvm.loop !9

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
  br i1 %37, label %28, label %31, !llvm.loop !10

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
  br i1 %47, label %48, label %38, !llvm.loop !11

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
  br i1 %80, label %81, label %73, !llvm.loop !12

81:                                               ; preds = %73, %48
  %82 = phi double [ %71, %48 ], [ %78, %73 ]
  br label %5
}


define zeroext i1 @nlp_rows(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, i32 noundef %3, ptr noundef %4, ptr noundef readonly %5) #0 {
  %7 = tail call fastcc i32 @written(ptr noundef %5, i32 noundef 1, ptr noundef %1, ptr noundef %4) #4
  %8 = getelementptr inbounds i8, ptr %5, i64 96
  %9 = load ptr, ptr %8, align 8
  %10 = icmp sgt i32 %3, 0
  br i1 %10, label %11, label %13

11:                                               ; preds = %6
  %12 = zext nneg i32 %3 to i64
  br label %17

13:                                               ; preds = %17, %6
  %14 = icmp sgt i32 %3, 0
  br i1 %14, label %15, label %26

15:                                               ; preds = %13
  %16 = zext nneg i32 %3 to i64
  br label %29

17:                                               ; preds = %11, %17
  %18 = phi i64 [ 0, %11 ], [ %24, %17 ]
  %19 = getelementptr inbounds double, ptr %9, i64 %18
  %20 = load double, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %4, i64 %18
  %22 = load double, ptr %21, align 8
  %23 = fdiv double %22, %20
  store double %23, ptr %21, align 8
  %24 = add nuw nsw i64 %18, 1
  %25 = icmp eq i64 %24, %12
  br i1 %25, label %13, label %17, !llvm.loop !13

26:                                               ; preds = %29, %13
  %27 = phi i32 [ %7, %13 ], [ %36, %29 ]
  %28 = icmp ne i32 %27, 0
  ret i1 %28

29:                                               ; preds = %15, %29
  %30 = phi i64 [ 0, %15 ], [ %37, %29 ]
  %31 = phi i32 [ %7, %15 ], [ %36, %29 ]
  %32 = getelementptr inbounds double, ptr %4, i64 %30
  %33 = load double, ptr %32, align 8
  %34 = fsub double %33, %33
  %35 = fcmp oeq double %34, 0.000000e+00
  %36 = select i1 %35, i32 %31, i32 0
  %37 = add nuw nsw i64 %30, 1
  %38 = icmp eq i64 %37, %16
  br i1 %38, label %26, label %29, !llvm.loop !14
}

define internal fastcc range(i32 0, 2) i32 @written(ptr noundef readonly %0, i32 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #0 {
  %5 = getelementptr inbounds i8, ptr %0, i64 16
  %6 = zext nneg i32 %1 to i64
  %7 = getelementptr inbounds [5 x i64], ptr %5, i64 0, i64 %6
  %8 = load i64, ptr %7, align 8
  %9 = icmp sgt i64 %8, 0
  br i1 %9, label %10, label %13

10:                                               ; preds = %4
  %11 = getelementptr inbounds i8, ptr %0, i64 56
  %12 = getelementptr inbounds [5 x ptr], ptr %11, i64 0, i64 %6
  br label %15

13:                                               ; preds = %77, %4
  %14 = phi i32 [ 1, %4 ], [ %79, %77 ]
  ret i32 %14

15:                                               ; preds = %10, %77
  %16 = phi i32 [ 1, %10 ], [ %79, %77 ]
  %17 = phi i64 [ 0, %10 ], [ %85, %77 ]
  %18 = phi ptr [ %3, %10 ], [ %84, %77 ]
  %19 = load ptr, ptr %12, align 8
  %20 = getelementptr inbounds %struct.Part, ptr %19, i64 %17
  %21 = getelementptr inbounds i8, ptr %20, i64 72
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr inbounds i8, ptr %20, i64 32
  %24 = load i64, ptr %23, align 8
  %25 = mul nsw i64 %24, %22
  %26 = getelementptr inbounds i8, ptr %20, i64 96
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %20, i64 104
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %20, i64 128
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %20, i64 152
  %33 = load ptr, ptr %32, align 8
  %34 = icmp sgt i64 %25, 0
  br i1 %34, label %37, label %35

35:                                               ; preds = %37, %15
  %36 = icmp sgt i64 %22, 0
  br i1 %36, label %60, label %49

37:                                               ; preds = %15, %37
  %38 = phi i64 [ %47, %37 ], [ 0, %15 ]
  %39 = getelementptr inbounds i64, ptr %27, i64 %38
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %2, i64 %40
  %42 = load double, ptr %41, align 8
  %43 = getelementptr inbounds double, ptr %29, i64 %38
  %44 = load double, ptr %43, align 8
  %45 = fmul double %42, %44
  %46 = getelementptr inbounds double, ptr %31, i64 %38
  store double %45, ptr %46, align 8
  %47 = add nuw nsw i64 %38, 1
  %48 = icmp eq i64 %47, %25
  br i1 %48, label %35, label %37, !llvm.loop !3

49:                                               ; preds = %60, %35
  %50 = getelementptr inbounds i8, ptr %20, i64 24
  %51 = load ptr, ptr %50, align 8
  %52 = load ptr, ptr %30, align 8
  %53 = getelementptr inbounds i8, ptr %20, i64 112
  %54 = load ptr, ptr %53, align 8
  %55 = getelementptr inbounds i8, ptr %20, i64 120
  %56 = load ptr, ptr %55, align 8
  %57 = load ptr, ptr %32, align 8
  %58 = getelementptr inbounds i8, ptr %20, i64 144
  %59 = load ptr, ptr %58, align 8
  tail call void %51(ptr noundef %20, ptr noundef %52, ptr noundef %52, ptr noundef %54, ptr noundef %56, ptr noundef %18, ptr noundef %57, ptr noundef %59) #3
  br i1 %36, label %68, label %77

60:                                               ; preds = %35, %60
  %61 = phi i64 [ %63, %60 ], [ 0, %35 ]
  %62 = getelementptr inbounds i8, ptr %33, i64 %61
  store i8 0, ptr %62, align 1
  %63 = add nuw nsw i64 %61, 1
  %64 = icmp eq i64 %63, %22
  br i1 %64, label %49, label %60, !llvm.loop !6

65:                                               ; preds = %68
  %66 = icmp eq i32 %74, 0
  %67 = zext i1 %66 to i32
  br label %77

68:                                               ; preds = %49, %68
  %69 = phi i64 [ %75, %68 ], [ 0, %49 ]
  %70 = phi i32 [ %74, %68 ], [ 0, %49 ]
  %71 = getelementptr inbounds i8, ptr %33, i64 %69
  %72 = load i8, ptr %71, align 1
  %73 = zext i8 %72 to i32
  %74 = or i32 %70, %73
  %75 = add nuw nsw i64 %69, 1
  %76 = icmp eq i64 %75, %22
  br i1 %76, label %65, label %68, !llvm.loop !7

77:                                               ; preds = %49, %65
  %78 = phi i32 [ 1, %49 ], [ %67, %65 ]
  %79 = and i32 %78, %16
  %80 = getelementptr inbounds i8, ptr %20, i64 64
  %81 = load i64, ptr %80, align 8
  %82 = load i64, ptr %21, align 8
  %83 = mul nsw i64 %82, %81
  %84 = getelementptr inbounds double, ptr %18, i64 %83
  %85 = add nuw nsw i64 %17, 1
  %86 = load i64, ptr %7, align 8
  %87 = icmp slt i64 %85, %86
  br i1 %87, label %15, label %13, !llvm.loop !15
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
  br i1 %27, label %13, label %23, !llvm.loop !16

28:                                               ; preds = %126
  %29 = icmp ne i32 %105, 0
  br label %30

30:                                               ; preds = %28, %13
  %31 = phi i1 [ true, %13 ], [ %29, %28 ]
  %32 = icmp sgt i32 %0, 0
  br i1 %32, label %33, label %139

33:                                               ; preds = %30
  %34 = zext nneg i32 %0 to i64
  br label %140

35:                                               ; preds = %17, %126
  %36 = phi i32 [ 1, %17 ], [ %105, %126 ]
  %37 = phi i64 [ 0, %17 ], [ %127, %126 ]
  %38 = load ptr, ptr %18, align 8
  %39 = getelementptr inbounds %struct.Part, ptr %38, i64 %37
  %40 = getelementptr inbounds i8, ptr %39, i64 64
  %41 = load i64, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %39, i64 72
  %43 = load i64, ptr %42, align 8
  %44 = mul i64 %43, %41
  %45 = getelementptr inbounds i8, ptr %39, i64 160
  %46 = load ptr, ptr %45, align 8
  %47 = getelementptr inbounds i8, ptr %39, i64 136
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds i8, ptr %39, i64 32
  %50 = load i64, ptr %49, align 8
  %51 = mul nsw i64 %50, %43
  %52 = getelementptr inbounds i8, ptr %39, i64 96
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds i8, ptr %39, i64 104
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds i8, ptr %39, i64 128
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i8, ptr %39, i64 152
  %59 = load ptr, ptr %58, align 8
  %60 = icmp sgt i64 %51, 0
  br i1 %60, label %63, label %61

61:                                               ; preds = %63, %35
  %62 = icmp sgt i64 %43, 0
  br i1 %62, label %86, label %75

63:                                               ; preds = %35, %63
  %64 = phi i64 [ %73, %63 ], [ 0, %35 ]
  %65 = getelementptr inbounds i64, ptr %53, i64 %64
  %66 = load i64, ptr %65, align 8
  %67 = getelementptr inbounds double, ptr %1, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %55, i64 %64
  %70 = load double, ptr %69, align 8
  %71 = fmul double %68, %70
  %72 = getelementptr inbounds double, ptr %57, i64 %64
  store double %71, ptr %72, align 8
  %73 = add nuw nsw i64 %64, 1
  %74 = icmp eq i64 %73, %51
  br i1 %74, label %61, label %63, !llvm.loop !3

75:                                               ; preds = %86, %61
  %76 = getelementptr inbounds i8, ptr %39, i64 24
  %77 = load ptr, ptr %76, align 8
  %78 = load ptr, ptr %56, align 8
  %79 = getelementptr inbounds i8, ptr %39, i64 112
  %80 = load ptr, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %39, i64 120
  %82 = load ptr, ptr %81, align 8
  %83 = load ptr, ptr %58, align 8
  %84 = getelementptr inbounds i8, ptr %39, i64 144
  %85 = load ptr, ptr %84, align 8
  tail call void %77(ptr noundef %39, ptr noundef %78, ptr noundef %78, ptr noundef %80, ptr noundef %82, ptr noundef %48, ptr noundef %83, ptr noundef %85) #3
  br i1 %62, label %94, label %103

86:                                               ; preds = %61, %86
  %87 = phi i64 [ %89, %86 ], [ 0, %61 ]
  %88 = getelementptr inbounds i8, ptr %59, i64 %87
  store i8 0, ptr %88, align 1
  %89 = add nuw nsw i64 %87, 1
  %90 = icmp eq i64 %89, %43
  br i1 %90, label %75, label %86, !llvm.loop !6

91:                                               ; preds = %94
  %92 = icmp eq i32 %100, 0
  %93 = zext i1 %92 to i32
  br label %103

94:                                               ; preds = %75, %94
  %95 = phi i64 [ %101, %94 ], [ 0, %75 ]
  %96 = phi i32 [ %100, %94 ], [ 0, %75 ]
  %97 = getelementptr inbounds i8, ptr %59, i64 %95
  %98 = load i8, ptr %97, align 1
  %99 = zext i8 %98 to i32
  %100 = or i32 %96, %99
  %101 = add nuw nsw i64 %95, 1
  %102 = icmp eq i64 %101, %43
  br i1 %102, label %91, label %94, !llvm.loop !7

103:                                              ; preds = %75, %91
  %104 = phi i32 [ 1, %75 ], [ %93, %91 ]
  %105 = and i32 %104, %36
  %106 = load ptr, ptr %47, align 8
  br i1 %19, label %109, label %107

107:                                              ; preds = %109, %103
  %108 = icmp sgt i64 %44, 0
  br i1 %108, label %115, label %114

109:                                              ; preds = %103, %109
  %110 = phi i64 [ %112, %109 ], [ 0, %103 ]
  %111 = getelementptr inbounds double, ptr %7, i64 %110
  store double 0.000000e+00, ptr %111, align 8
  %112 = add nuw nsw i64 %110, 1
  %113 = icmp eq i64 %112, %21
  br i1 %113, label %107, label %109, !llvm.loop !17

114:                                              ; preds = %115, %107
  br i1 %20, label %130, label %126

115:                                              ; preds = %107, %115
  %116 = phi i64 [ %124, %115 ], [ 0, %107 ]
  %117 = getelementptr inbounds double, ptr %106, i64 %116
  %118 = load double, ptr %117, align 8
  %119 = getelementptr inbounds i64, ptr %46, i64 %116
  %120 = load i64, ptr %119, align 8
  %121 = getelementptr inbounds double, ptr %7, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = fadd double %118, %122
  store double %123, ptr %121, align 8
  %124 = add nuw nsw i64 %116, 1
  %125 = icmp eq i64 %124, %44
  br i1 %125, label %114, label %115, !llvm.loop !18

126:                                              ; preds = %130, %114
  %127 = add nuw nsw i64 %37, 1
  %128 = load i64, ptr %14, align 8
  %129 = icmp slt i64 %127, %128
  br i1 %129, label %35, label %28, !llvm.loop !19

130:                                              ; preds = %114, %130
  %131 = phi i64 [ %137, %130 ], [ 0, %114 ]
  %132 = getelementptr inbounds double, ptr %7, i64 %131
  %133 = load double, ptr %132, align 8
  %134 = getelementptr inbounds double, ptr %3, i64 %131
  %135 = load double, ptr %134, align 8
  %136 = fadd double %133, %135
  store double %136, ptr %134, align 8
  %137 = add nuw nsw i64 %131, 1
  %138 = icmp eq i64 %137, %22
  br i1 %138, label %126, label %130, !llvm.loop !20

139:                                              ; preds = %140, %30
  ret i1 %31

140:                                              ; preds = %33, %140
  %141 = phi i64 [ 0, %33 ], [ %147, %140 ]
  %142 = getelementptr inbounds double, ptr %9, i64 %141
  %143 = load double, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %3, i64 %141
  %145 = load double, ptr %144, align 8
  %146 = fmul double %143, %145
  store double %146, ptr %144, align 8
  %147 = add nuw nsw i64 %141, 1
  %148 = icmp eq i64 %147, %34
  br i1 %148, label %139, label %140, !llvm.loop !21
}

define zeroext i1 @nlp_jacobian(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, i32 noundef %3, i32 noundef %4, ptr noundef writeonly %5, ptr noundef writeonly %6, ptr noundef %7, ptr noundef readonly %8) #0 {
  %10 = icmp eq ptr %7, null
  br i1 %10, label %11, label %31

11:                                               ; preds = %9
  %12 = getelementptr inbounds i8, ptr %8, i64 176
  %13 = load i64, ptr %12, align 8
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %15, label %49

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
  br i1 %30, label %18, label %49, !llvm.loop !22

31:                                               ; preds = %9
  %32 = tail call fastcc i32 @written(ptr noundef %8, i32 noundef 3, ptr noundef %1, ptr noundef nonnull %7) #4
  %33 = getelementptr inbounds i8, ptr %8, i64 112
  %34 = load ptr, ptr %33, align 8
  %35 = icmp sgt i32 %4, 0
  br i1 %35, label %36, label %38

36:                                               ; preds = %31
  %37 = zext nneg i32 %4 to i64
  br label %40

38:                                               ; preds = %40, %31
  %39 = icmp ne i32 %32, 0
  br label %49

40:                                               ; preds = %36, %40
  %41 = phi i64 [ 0, %36 ], [ %47, %40 ]
  %42 = getelementptr inbounds double, ptr %34, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds double, ptr %7, i64 %41
  %45 = load double, ptr %44, align 8
  %46 = fdiv double %45, %43
  store double %46, ptr %44, align 8
  %47 = add nuw nsw i64 %41, 1
  %48 = icmp eq i64 %47, %37
  br i1 %48, label %38, label %40, !llvm.loop !23

49:                                               ; preds = %18, %11, %38
  %50 = phi i1 [ %39, %38 ], [ true, %11 ], [ true, %18 ]
  ret i1 %50
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
  br label %49

22:                                               ; preds = %12
  %23 = getelementptr inbounds i8, ptr %11, i64 184
  %24 = load i64, ptr %23, align 8
  %25 = icmp sgt i64 %24, 0
  br i1 %25, label %26, label %110

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
  br i1 %41, label %29, label %110, !llvm.loop !22

42:                                               ; preds = %89, %14
  %43 = tail call fastcc i32 @written(ptr noundef %11, i32 noundef 4, ptr noundef %1, ptr noundef nonnull %10) #4
  %44 = getelementptr inbounds i8, ptr %11, i64 120
  %45 = load ptr, ptr %44, align 8
  %46 = icmp sgt i32 %7, 0
  br i1 %46, label %47, label %99

47:                                               ; preds = %42
  %48 = zext nneg i32 %7 to i64
  br label %101

49:                                               ; preds = %18, %89
  %50 = phi i64 [ 0, %18 ], [ %90, %89 ]
  %51 = phi i64 [ 0, %18 ], [ %91, %89 ]
  %52 = load ptr, ptr %19, align 8
  %53 = getelementptr inbounds %struct.Part, ptr %52, i64 %51
  %54 = getelementptr inbounds i8, ptr %53, i64 72
  %55 = load i64, ptr %54, align 8
  %56 = getelementptr inbounds i8, ptr %53, i64 168
  %57 = load i64, ptr %56, align 8
  %58 = mul nsw i64 %57, %55
  %59 = getelementptr inbounds i8, ptr %53, i64 176
  %60 = load i64, ptr %59, align 8
  %61 = add i64 %60, %57
  %62 = mul i64 %61, %55
  %63 = getelementptr inbounds i8, ptr %53, i64 112
  %64 = load ptr, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %53, i64 40
  %66 = load i64, ptr %65, align 8
  %67 = mul nsw i64 %66, %55
  %68 = getelementptr inbounds double, ptr %64, i64 %67
  %69 = sub i64 0, %62
  %70 = getelementptr inbounds double, ptr %68, i64 %69
  %71 = getelementptr inbounds double, ptr %5, i64 %50
  %72 = load ptr, ptr %20, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %50
  %74 = load double, ptr %21, align 8
  %75 = fdiv double %3, %74
  %76 = icmp sgt i64 %58, 0
  br i1 %76, label %79, label %77

77:                                               ; preds = %79, %49
  %78 = icmp slt i64 %58, %62
  br i1 %78, label %94, label %89

79:                                               ; preds = %49, %79
  %80 = phi i64 [ %87, %79 ], [ 0, %49 ]
  %81 = getelementptr inbounds double, ptr %71, i64 %80
  %82 = load double, ptr %81, align 8
  %83 = getelementptr inbounds double, ptr %73, i64 %80
  %84 = load double, ptr %83, align 8
  %85 = fdiv double %82, %84
  %86 = getelementptr inbounds double, ptr %70, i64 %80
  store double %85, ptr %86, align 8
  %87 = add nuw nsw i64 %80, 1
  %88 = icmp eq i64 %87, %58
  br i1 %88, label %77, label %79, !llvm.loop !24

89:                                               ; preds = %94, %77
  %90 = add nsw i64 %58, %50
  %91 = add nuw nsw i64 %51, 1
  %92 = load i64, ptr %15, align 8
  %93 = icmp slt i64 %91, %92
  br i1 %93, label %49, label %42, !llvm.loop !25

94:                                               ; preds = %77, %94
  %95 = phi i64 [ %97, %94 ], [ %58, %77 ]
  %96 = getelementptr inbounds double, ptr %70, i64 %95
  store double %75, ptr %96, align 8
  %97 = add nsw i64 %95, 1
  %98 = icmp eq i64 %97, %62
  br i1 %98, label %89, label %94, !llvm.loop !26

99:                                               ; preds = %101, %42
  %100 = icmp ne i32 %43, 0
  br label %110

101:                                              ; preds = %47, %101
  %102 = phi i64 [ 0, %47 ], [ %108, %101 ]
  %103 = getelementptr inbounds double, ptr %45, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = getelementptr inbounds double, ptr %10, i64 %102
  %106 = load double, ptr %105, align 8
  %107 = fmul double %104, %106
  store double %107, ptr %105, align 8
  %108 = add nuw nsw i64 %102, 1
  %109 = icmp eq i64 %108, %48
  br i1 %109, label %99, label %101, !llvm.loop !27

110:                                              ; preds = %29, %22, %99
  %111 = phi i1 [ %100, %99 ], [ true, %22 ], [ true, %29 ]
  ret i1 %111
}

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind }
attributes #3 = { nounwind }
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
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
