; sources 8a2819da873f0747ba18a73d33b0d3ee5efc8cd4c9f743bb51e0e6fb6c8fb8b7
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i32 @reflect(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef %4) #0 {
  %6 = alloca double, align 8
  %7 = load double, ptr %0, align 8
  %8 = fneg double %7
  store double %8, ptr %6, align 8
  %9 = load i64, ptr %3, align 8
  %10 = getelementptr inbounds i8, ptr %3, i64 64
  %11 = inttoptr i64 %9 to ptr
  %12 = load ptr, ptr %11, align 8
  %13 = call i32 %12(ptr noundef nonnull %6, ptr noundef %1, ptr noundef %2, ptr noundef nonnull %10, ptr noundef %4) #3
  %14 = getelementptr inbounds i8, ptr %3, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %18, label %17

17:                                               ; preds = %18, %5
  ret i32 %13

18:                                               ; preds = %5, %18
  %19 = phi i64 [ %23, %18 ], [ 0, %5 ]
  %20 = getelementptr inbounds double, ptr %4, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = fneg double %21
  store double %22, ptr %20, align 8
  %23 = add nuw nsw i64 %19, 1
  %24 = load i64, ptr %14, align 8
  %25 = icmp slt i64 %23, %24
  br i1 %25, label %18, label %17, !llvm.loop !3
}



attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind }
attributes #3 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
