; sources a39e03bbed7f224b68ed082df06b8ce13f2794b94d41d1b6f0e1bfb8032cc142
; Made by tools/solvers_ir.py with ziglang 0.14.1.

@NODES = internal unnamed_addr constant [3 x double] [double 0x3FC3D8B64657CAEA, double 0x3FE4A36C0803A6DF, double 1.000000e+00], align 16
@TO_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x4010B70201A79C46, double 0x3FD4F8C15DA84E86, double 0x3FE0BF7FF59D56EF], [3 x double] [double 0xC010B70201A79C46, double 0xBFD4F8C15DA84E86, double 0x3FDE810014C55221], [3 x double] [double 0x3FE017885A24A7F2, double 0xC004934E6FCAA598, double 0x3FE312C0CF7BDFD1]], align 16
@FROM_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x3FB82D23845D677B, double 0xBFC214A74C403BF7, double 0x3F9EBFF91A6D688E], [3 x double] [double 0x3FD0037DE70AA1ED, double 0x3FCA20E91E20B551, double 0xBFD8821FA2A36DED], [3 x double] [double 1.000000e+00, double 1.000000e+00, double 0.000000e+00]], align 16
@POLYNOMIAL = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x402418FD8BAFFE05, double 0xC039A12CE7B30915, double 0x402F295C43B61425], [3 x double] [double 0xBFF61D41B2D54580, double 0x402497AF24BB677E, double 0xC021D406EE60BECF], [3 x double] [double 0x3FD5555555555555, double 0xC005555555555555, double 0x400AAAAAAAAAAAAB]], align 16

define i64 @advance_implicit(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [1 x double], align 8
  %5 = alloca [1 x double], align 8
  %6 = alloca [1 x double], align 8
  %7 = alloca [1 x double], align 8
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = icmp eq i64 %2, 1
  br i1 %10, label %11, label %75

11:                                               ; preds = %3
  %12 = getelementptr inbounds i8, ptr %0, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %19

17:                                               ; preds = %11
  %18 = getelementptr inbounds i8, ptr %0, i64 312
  br label %26

19:                                               ; preds = %26, %11
  %20 = getelementptr inbounds i8, ptr %0, i64 584
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %37

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 576
  %25 = getelementptr inbounds i8, ptr %0, i64 1224
  br label %44

26:                                               ; preds = %17, %26
  %27 = phi i64 [ 0, %17 ], [ %32, %26 ]
  %28 = getelementptr inbounds double, ptr %1, i64 %27
  %29 = load double, ptr %28, align 8
  %30 = load ptr, ptr %18, align 8
  %31 = getelementptr inbounds double, ptr %30, i64 %27
  store double %29, ptr %31, align 8
  %32 = add nuw nsw i64 %27, 1
  %33 = load ptr, ptr %12, align 8
  %34 = getelementptr inbounds i8, ptr %33, i64 8
  %35 = load i64, ptr %34, align 8
  %36 = icmp slt i64 %32, %35
  br i1 %36, label %26, label %19, !llvm.loop !3

37:                                               ; preds = %44, %19
  %38 = getelementptr inbounds i8, ptr %0, i64 608
  %39 = load i64, ptr %38, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %54

41:                                               ; preds = %37
  %42 = getelementptr inbounds i8, ptr %0, i64 600
  %43 = getelementptr inbounds i8, ptr %0, i64 1248
  br label %60

44:                                               ; preds = %23, %44
  %45 = phi i64 [ 0, %23 ], [ %51, %44 ]
  %46 = load ptr, ptr %25, align 8
  %47 = getelementptr inbounds double, ptr %46, i64 %45
  %48 = load double, ptr %47, align 8
  %49 = load ptr, ptr %24, align 8
  %50 = getelementptr inbounds double, ptr %49, i64 %45
  store double %48, ptr %50, align 8
  %51 = add nuw nsw i64 %45, 1
  %52 = load i64, ptr %20, align 8
  %53 = icmp slt i64 %51, %52
  br i1 %53, label %44, label %37, !llvm.loop !6

54:                                               ; preds = %60, %37
  %55 = getelementptr inbounds i8, ptr %0, i64 720
  %56 = load ptr, ptr %55, align 8
  %57 = getelementptr inbounds i8, ptr %56, i64 8
  %58 = load i64, ptr %57, align 8
  %59 = icmp sgt i64 %58, 0
  br i1 %59, label %70, label %75

60:                                               ; preds = %41, %60
  %61 = phi i64 [ 0, %41 ], [ %67, %60 ]
  %62 = load ptr, ptr %43, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %61
  %64 = load i64, ptr %63, align 8
  %65 = load ptr, ptr %42, align 8
  %66 = getelementptr inbounds i64, ptr %65, i64 %61
  store i64 %64, ptr %66, align 8
  %67 = add nuw nsw i64 %61, 1
  %68 = load i64, ptr %38, align 8
  %69 = icmp slt i64 %67, %68
  br i1 %69, label %60, label %54, !llvm.loop !7

70:                                               ; preds = %54
  %71 = getelementptr inbounds i8, ptr %0, i64 936
  %72 = load ptr, ptr %71, align 8
  %73 = mul i64 %58, 88
  %74 = getelementptr inbounds i8, ptr %72, i64 %73
  store double 0x7FF8000000000000, ptr %74, align 8
  br label %75

75:                                               ; preds = %70, %54, %3
  %76 = getelementptr inbounds i8, ptr %0, i64 144
  %77 = getelementptr inbounds i8, ptr %0, i64 312
  %78 = getelementptr inbounds i8, ptr %0, i64 1320
  %79 = getelementptr inbounds i8, ptr %0, i64 576
  %80 = getelementptr inbounds i8, ptr %0, i64 1344
  %81 = getelementptr inbounds i8, ptr %0, i64 600
  %82 = getelementptr inbounds i8, ptr %0, i64 624
  %83 = getelementptr inbounds i8, ptr %0, i64 632
  %84 = getelementptr inbounds i8, ptr %0, i64 648
  %85 = getelementptr inbounds i8, ptr %0, i64 720
  %86 = getelementptr inbounds i8, ptr %0, i64 528
  %87 = getelementptr inbounds i8, ptr %0, i64 480
  %88 = getelementptr inbounds i8, ptr %0, i64 168
  %89 = getelementptr inbounds i8, ptr %0, i64 248
  %90 = getelementptr inbounds i8, ptr %0, i64 192
  %91 = getelementptr inbounds i8, ptr %0, i64 216
  %92 = getelementptr inbounds i8, ptr %0, i64 480
  %93 = getelementptr inbounds i8, ptr %0, i64 1272
  %94 = getelementptr inbounds i8, ptr %0, i64 1392
  %95 = getelementptr inbounds i8, ptr %0, i64 168
  %96 = getelementptr inbounds i8, ptr %0, i64 248
  %97 = getelementptr inbounds i8, ptr %0, i64 168
  %98 = getelementptr inbounds i8, ptr %0, i64 192
  %99 = getelementptr inbounds i8, ptr %0, i64 1368
  %100 = getelementptr inbounds i8, ptr %0, i64 360
  %101 = getelementptr inbounds i8, ptr %0, i64 360
  %102 = getelementptr inbounds i8, ptr %0, i64 336
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 248
  %105 = getelementptr inbounds i8, ptr %0, i64 192
  %106 = getelementptr inbounds i8, ptr %0, i64 216
  %107 = getelementptr inbounds i8, ptr %0, i64 480
  %108 = getelementptr inbounds i8, ptr %0, i64 1400
  %109 = getelementptr inbounds i8, ptr %0, i64 1464
  %110 = getelementptr inbounds i8, ptr %0, i64 1472
  %111 = getelementptr inbounds i8, ptr %0, i64 1416
  %112 = getelementptr inbounds i8, ptr %0, i64 1440
  %113 = getelementptr inbounds i8, ptr %0, i64 1392
  %114 = getelementptr inbounds i8, ptr %0, i64 1488
  %115 = getelementptr inbounds i8, ptr %0, i64 1584
  %116 = getelementptr inbounds i8, ptr %0, i64 1512
  %117 = getelementptr inbounds i8, ptr %0, i64 1536
  %118 = getelementptr inbounds i8, ptr %0, i64 1560
  %119 = getelementptr inbounds i8, ptr %0, i64 1608
  %120 = getelementptr inbounds i8, ptr %0, i64 1632
  %121 = getelementptr inbounds i8, ptr %0, i64 360
  %122 = getelementptr inbounds i8, ptr %0, i64 168
  %123 = getelementptr inbounds i8, ptr %0, i64 248
  %124 = getelementptr inbounds i8, ptr %0, i64 360
  %125 = getelementptr inbounds i8, ptr %0, i64 192
  %126 = getelementptr inbounds i8, ptr %0, i64 216
  %127 = getelementptr inbounds i8, ptr %0, i64 552
  %128 = getelementptr inbounds i8, ptr %0, i64 528
  %129 = getelementptr inbounds i8, ptr %0, i64 1464
  %130 = getelementptr inbounds i8, ptr %0, i64 1472
  %131 = getelementptr inbounds i8, ptr %0, i64 1416
  %132 = getelementptr inbounds i8, ptr %0, i64 1440
  %133 = getelementptr inbounds i8, ptr %0, i64 1488
  %134 = getelementptr inbounds i8, ptr %0, i64 552
  %135 = getelementptr inbounds i8, ptr %0, i64 528
  %136 = getelementptr inbounds i8, ptr %0, i64 1472
  %137 = getelementptr inbounds i8, ptr %0, i64 1536
  %138 = getelementptr inbounds i8, ptr %0, i64 1552
  %139 = getelementptr inbounds i8, ptr %0, i64 1608
  %140 = getelementptr inbounds i8, ptr %0, i64 1632
  %141 = getelementptr inbounds i8, ptr %0, i64 336
  %142 = getelementptr inbounds i8, ptr %0, i64 1464
  %143 = getelementptr inbounds i8, ptr %0, i64 1472
  %144 = getelementptr inbounds i8, ptr %0, i64 1656
  %145 = getelementptr inbounds i8, ptr %0, i64 480
  %146 = getelementptr inbounds i8, ptr %0, i64 1416
  %147 = getelementptr inbounds i8, ptr %0, i64 336
  %148 = getelementptr inbounds i8, ptr %0, i64 360
  %149 = getelementptr inbounds i8, ptr %0, i64 360
  %150 = getelementptr inbounds i8, ptr %0, i64 168
  %151 = getelementptr inbounds i8, ptr %0, i64 248
  %152 = getelementptr inbounds i8, ptr %0, i64 192
  %153 = getelementptr inbounds i8, ptr %0, i64 216
  %154 = getelementptr inbounds i8, ptr %0, i64 320
  %155 = getelementptr inbounds i8, ptr %0, i64 504
  %156 = getelementptr inbounds i8, ptr %8, i64 8
  %157 = getelementptr inbounds i8, ptr %8, i64 16
  %158 = getelementptr inbounds i8, ptr %9, i64 8
  %159 = getelementptr inbounds i8, ptr %9, i64 16
  %160 = getelementptr inbounds i8, ptr %0, i64 1296
  %161 = getelementptr inbounds i8, ptr %0, i64 1312
  %162 = getelementptr inbounds i8, ptr %0, i64 840
  %163 = getelementptr inbounds i8, ptr %0, i64 168
  %164 = getelementptr inbounds i8, ptr %0, i64 936
  %165 = getelementptr inbounds i8, ptr %0, i64 864
  %166 = getelementptr inbounds i8, ptr %0, i64 816
  %167 = getelementptr inbounds i8, ptr %0, i64 888
  %168 = getelementptr inbounds i8, ptr %0, i64 408
  %169 = getelementptr inbounds i8, ptr %0, i64 504
  %170 = getelementptr inbounds i8, ptr %0, i64 320
  %171 = getelementptr inbounds i8, ptr %0, i64 360
  %172 = getelementptr inbounds i8, ptr %0, i64 408
  %173 = getelementptr inbounds i8, ptr %0, i64 504
  %174 = getelementptr inbounds i8, ptr %0, i64 320
  %175 = getelementptr inbounds i8, ptr %0, i64 480
  %176 = getelementptr inbounds i8, ptr %0, i64 168
  %177 = getelementptr inbounds i8, ptr %0, i64 248
  %178 = getelementptr inbounds i8, ptr %0, i64 192
  %179 = getelementptr inbounds i8, ptr %0, i64 216
  %180 = getelementptr inbounds i8, ptr %0, i64 1392
  %181 = getelementptr inbounds i8, ptr %0, i64 1400
  %182 = getelementptr inbounds i8, ptr %0, i64 720
  br label %183

183:                                              ; preds = %1929, %75
  %184 = phi double [ undef, %75 ], [ %1911, %1929 ]
  %185 = phi i32 [ undef, %75 ], [ %1912, %1929 ]
  %186 = phi i64 [ undef, %75 ], [ %1913, %1929 ]
  %187 = phi i64 [ undef, %75 ], [ %1914, %1929 ]
  %188 = load ptr, ptr %79, align 8
  %189 = load ptr, ptr %80, align 8
  %190 = load ptr, ptr %81, align 8
  %191 = load ptr, ptr %78, align 8
  %192 = getelementptr inbounds i8, ptr %190, i64 56
  %193 = load i64, ptr %192, align 8
  %194 = icmp eq i64 %193, 0
  br i1 %194, label %1910, label %195

195:                                              ; preds = %183
  %196 = load ptr, ptr %76, align 8
  %197 = getelementptr inbounds i8, ptr %196, i64 8
  %198 = load i64, ptr %197, align 8
  %199 = load ptr, ptr %82, align 8
  %200 = load i64, ptr %83, align 8
  %201 = getelementptr double, ptr %199, i64 %200
  %202 = getelementptr i8, ptr %201, i64 -8
  %203 = load double, ptr %202, align 8
  %204 = load ptr, ptr %84, align 8
  %205 = load i64, ptr %204, align 8
  %206 = icmp eq i64 %205, 1
  %207 = load ptr, ptr %85, align 8
  %208 = getelementptr inbounds i8, ptr %207, i64 8
  %209 = load i64, ptr %208, align 8
  %210 = icmp sgt i64 %209, 0
  %211 = load ptr, ptr %86, align 8
  %212 = load double, ptr %211, align 8
  %213 = icmp sgt i64 %198, 0
  br i1 %213, label %229, label %214

214:                                              ; preds = %229, %195
  %215 = phi double [ %212, %195 ], [ %235, %229 ]
  %216 = tail call double @llvm.sqrt.f64(double %215)
  %217 = fcmp olt double %216, 3.000000e-02
  %218 = select i1 %217, double %216, double 3.000000e-02
  %219 = fcmp olt double %215, 0x3CB0000000000000
  %220 = select i1 %219, double 0x3CB0000000000000, double %215
  %221 = fdiv double 0x3CE4000000000000, %220
  %222 = fcmp ogt double %218, %221
  %223 = select i1 %222, double %218, double %221
  %224 = load double, ptr %188, align 8
  %225 = getelementptr inbounds i8, ptr %188, i64 8
  %226 = load double, ptr %225, align 8
  %227 = load i64, ptr %190, align 8
  %228 = icmp eq i64 %227, 0
  br i1 %228, label %238, label %330

229:                                              ; preds = %195, %229
  %230 = phi double [ %235, %229 ], [ %212, %195 ]
  %231 = phi i64 [ %236, %229 ], [ 0, %195 ]
  %232 = getelementptr inbounds double, ptr %211, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = fcmp olt double %233, %230
  %235 = select i1 %234, double %233, double %230
  %236 = add nuw nsw i64 %231, 1
  %237 = icmp eq i64 %236, %198
  br i1 %237, label %214, label %229, !llvm.loop !8

238:                                              ; preds = %214
  %239 = getelementptr inbounds i8, ptr %190, i64 24
  %240 = load i64, ptr %239, align 8
  %241 = add nsw i64 %240, 1
  store i64 %241, ptr %239, align 8
  %242 = load ptr, ptr %77, align 8
  %243 = load ptr, ptr %87, align 8
  %244 = load ptr, ptr %88, align 8
  store double %224, ptr %244, align 8
  %245 = load i64, ptr %89, align 8
  %246 = icmp sgt i64 %245, 0
  br i1 %246, label %247, label %248

247:                                              ; preds = %238
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %248

248:                                              ; preds = %238, %247
  %249 = load ptr, ptr %76, align 8
  %250 = load i64, ptr %249, align 8
  %251 = load ptr, ptr %88, align 8
  %252 = load ptr, ptr %90, align 8
  %253 = load ptr, ptr %91, align 8
  %254 = inttoptr i64 %250 to ptr
  %255 = tail call i32 %254(ptr noundef %251, ptr noundef %242, ptr noundef %252, ptr noundef %253, ptr noundef %243) #11
  %256 = icmp eq i32 %255, 0
  br i1 %256, label %261, label %257

257:                                              ; preds = %248
  %258 = getelementptr inbounds i8, ptr %190, i64 72
  store i64 3, ptr %258, align 8
  %259 = icmp slt i32 %255, 0
  %260 = select i1 %259, i64 -4, i64 2
  br label %1910

261:                                              ; preds = %248
  store i64 1, ptr %190, align 8
  %262 = getelementptr inbounds i8, ptr %188, i64 24
  store double 0.000000e+00, ptr %262, align 8
  %263 = getelementptr inbounds i8, ptr %191, i64 32
  store i64 1, ptr %263, align 8
  %264 = getelementptr inbounds i8, ptr %191, i64 8
  store i64 1, ptr %264, align 8
  %265 = getelementptr inbounds i8, ptr %189, i64 8
  store double 0.000000e+00, ptr %265, align 8
  %266 = load ptr, ptr %77, align 8
  %267 = load ptr, ptr %76, align 8
  %268 = getelementptr inbounds i8, ptr %267, i64 8
  %269 = load i64, ptr %268, align 8
  %270 = load i64, ptr %83, align 8
  %271 = load ptr, ptr %82, align 8
  %272 = load ptr, ptr %81, align 8
  %273 = getelementptr inbounds i8, ptr %272, i64 48
  %274 = load i64, ptr %273, align 8
  %275 = icmp slt i64 %274, %270
  br i1 %275, label %276, label %299

276:                                              ; preds = %261
  %277 = icmp sgt i64 %269, 0
  br label %278

278:                                              ; preds = %276, %289
  %279 = phi i64 [ %274, %276 ], [ %290, %289 ]
  %280 = getelementptr inbounds double, ptr %271, i64 %279
  %281 = load double, ptr %280, align 8
  %282 = load ptr, ptr %79, align 8
  %283 = load double, ptr %282, align 8
  %284 = fcmp ugt double %281, %283
  br i1 %284, label %299, label %285

285:                                              ; preds = %278
  br i1 %277, label %286, label %289

286:                                              ; preds = %285
  %287 = mul nsw i64 %279, %269
  %288 = getelementptr double, ptr %1, i64 %287
  br label %292

289:                                              ; preds = %292, %285
  %290 = add i64 %279, 1
  %291 = icmp eq i64 %290, %270
  br i1 %291, label %299, label %278, !llvm.loop !9

292:                                              ; preds = %286, %292
  %293 = phi i64 [ 0, %286 ], [ %297, %292 ]
  %294 = getelementptr inbounds double, ptr %266, i64 %293
  %295 = load double, ptr %294, align 8
  %296 = getelementptr double, ptr %288, i64 %293
  store double %295, ptr %296, align 8
  %297 = add nuw nsw i64 %293, 1
  %298 = icmp eq i64 %297, %269
  br i1 %298, label %289, label %292, !llvm.loop !10

299:                                              ; preds = %278, %289, %261
  %300 = phi i64 [ %274, %261 ], [ %279, %278 ], [ %270, %289 ]
  %301 = load ptr, ptr %81, align 8
  %302 = getelementptr inbounds i8, ptr %301, i64 48
  store i64 %300, ptr %302, align 8
  %303 = icmp eq i64 %300, %270
  br i1 %303, label %1910, label %304

304:                                              ; preds = %299
  %305 = fcmp oeq double %226, 0.000000e+00
  br i1 %305, label %306, label %330

306:                                              ; preds = %304
  %307 = getelementptr inbounds i8, ptr %188, i64 16
  %308 = load double, ptr %307, align 8
  %309 = load ptr, ptr %77, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %309, ptr noundef %309, ptr noundef nonnull %77, i64 noundef %198) #10
  %310 = load double, ptr %4, align 8
  %311 = load ptr, ptr %92, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %311, ptr noundef %309, ptr noundef nonnull %77, i64 noundef %198) #10
  %312 = load double, ptr %5, align 8
  %313 = fcmp uge double %310, 1.000000e-05
  %314 = fcmp uge double %312, 1.000000e-05
  %315 = and i1 %313, %314
  %316 = fmul double %310, 1.000000e-02
  %317 = fdiv double %316, %312
  %318 = select i1 %315, double %317, double 0x3EB0C6F7A0B5ED8D
  %319 = fcmp olt double %308, %318
  %320 = select i1 %319, double %308, double %318
  %321 = tail call double @llvm.fabs.f64(double %224)
  %322 = fmul double %321, 0x3D30000000000000
  %323 = fcmp ogt double %322, %320
  %324 = select i1 %323, double %322, double %320
  %325 = fcmp olt double %308, %324
  %326 = select i1 %325, double %308, double %324
  %327 = tail call i1 @llvm.is.fpclass.f64(double %326, i32 639)
  br i1 %327, label %328, label %330

328:                                              ; preds = %306
  %329 = getelementptr inbounds i8, ptr %190, i64 72
  store i64 4, ptr %329, align 8
  br label %330

330:                                              ; preds = %306, %328, %304, %214
  %331 = phi double [ %226, %304 ], [ %226, %214 ], [ %326, %328 ], [ %326, %306 ]
  %332 = load i64, ptr %192, align 8
  %333 = icmp eq i64 %332, 0
  br i1 %333, label %369, label %334

334:                                              ; preds = %330
  %335 = getelementptr inbounds i8, ptr %190, i64 8
  %336 = getelementptr inbounds i8, ptr %190, i64 16
  %337 = getelementptr inbounds i8, ptr %190, i64 64
  %338 = getelementptr inbounds i8, ptr %188, i64 16
  %339 = getelementptr inbounds i8, ptr %191, i64 8
  %340 = getelementptr inbounds i8, ptr %191, i64 16
  %341 = getelementptr inbounds i8, ptr %191, i64 24
  %342 = getelementptr inbounds i8, ptr %191, i64 24
  %343 = getelementptr inbounds i8, ptr %190, i64 40
  %344 = getelementptr inbounds i8, ptr %189, i64 8
  %345 = fmul double %215, %223
  %346 = fmul double %345, %345
  %347 = icmp sgt i64 %198, 0
  %348 = shl i64 %198, 4
  %349 = getelementptr inbounds i8, ptr %191, i64 32
  %350 = getelementptr inbounds i8, ptr %190, i64 72
  %351 = getelementptr inbounds i8, ptr %191, i64 16
  %352 = getelementptr inbounds i8, ptr %190, i64 72
  %353 = getelementptr inbounds i8, ptr %191, i64 16
  %354 = getelementptr inbounds i8, ptr %188, i64 24
  %355 = getelementptr inbounds i8, ptr %188, i64 32
  %356 = getelementptr inbounds i8, ptr %188, i64 32
  %357 = getelementptr inbounds i8, ptr %190, i64 48
  %358 = icmp sgt i64 %198, 0
  %359 = getelementptr inbounds i8, ptr %190, i64 24
  %360 = getelementptr inbounds i8, ptr %190, i64 72
  %361 = getelementptr inbounds i8, ptr %191, i64 16
  %362 = getelementptr inbounds i8, ptr %190, i64 48
  %363 = getelementptr inbounds i8, ptr %191, i64 16
  %364 = getelementptr inbounds i8, ptr %190, i64 72
  %365 = getelementptr inbounds i8, ptr %190, i64 72
  %366 = getelementptr inbounds i8, ptr %191, i64 16
  %367 = getelementptr inbounds i8, ptr %190, i64 72
  %368 = getelementptr inbounds i8, ptr %191, i64 16
  br label %375

369:                                              ; preds = %1907, %330
  %370 = phi double [ %184, %330 ], [ %1899, %1907 ]
  %371 = phi i32 [ %185, %330 ], [ %1900, %1907 ]
  %372 = phi i64 [ %186, %330 ], [ %1901, %1907 ]
  %373 = phi i64 [ %187, %330 ], [ %1902, %1907 ]
  %374 = phi double [ %331, %330 ], [ %1903, %1907 ]
  store double %374, ptr %225, align 8
  br label %1910

375:                                              ; preds = %334, %1907
  %376 = phi i64 [ %332, %334 ], [ %1908, %1907 ]
  %377 = phi i64 [ undef, %334 ], [ %1906, %1907 ]
  %378 = phi double [ %224, %334 ], [ %1904, %1907 ]
  %379 = phi double [ %331, %334 ], [ %1903, %1907 ]
  %380 = phi i64 [ %187, %334 ], [ %1902, %1907 ]
  %381 = phi i64 [ %186, %334 ], [ %1901, %1907 ]
  %382 = phi i32 [ %185, %334 ], [ %1900, %1907 ]
  %383 = phi double [ %184, %334 ], [ %1899, %1907 ]
  %384 = load ptr, ptr %93, align 8
  %385 = getelementptr inbounds i8, ptr %384, i64 8
  %386 = load i64, ptr %385, align 8
  %387 = icmp sgt i64 %386, 0
  br i1 %387, label %388, label %393

388:                                              ; preds = %375
  %389 = load i64, ptr %384, align 8
  %390 = add nsw i64 %389, 3
  %391 = icmp slt i64 %386, %390
  %392 = zext i1 %391 to i32
  br label %393

393:                                              ; preds = %375, %388
  %394 = phi i32 [ 0, %375 ], [ %392, %388 ]
  %395 = icmp eq i32 %394, 0
  br i1 %395, label %397, label %396

396:                                              ; preds = %393
  store double %379, ptr %225, align 8
  br label %1910

397:                                              ; preds = %393
  %398 = add nsw i64 %376, -1
  store i64 %398, ptr %192, align 8
  %399 = load i64, ptr %335, align 8
  %400 = load i64, ptr %336, align 8
  %401 = add nsw i64 %400, %399
  %402 = load i64, ptr %337, align 8
  %403 = icmp slt i64 %401, %402
  br i1 %403, label %405, label %404

404:                                              ; preds = %397
  store double %379, ptr %225, align 8
  br label %1910

405:                                              ; preds = %397
  %406 = load double, ptr %338, align 8
  %407 = fcmp olt double %379, %406
  %408 = select i1 %407, double %379, double %406
  %409 = fadd double %378, %408
  %410 = fmul double %408, 1.000000e-03
  %411 = fsub double %203, %410
  %412 = fcmp ule double %409, %411
  %413 = select i1 %412, double %409, double %203
  %414 = fsub double %413, %378
  %415 = fmul double %414, 6.250000e-02
  %416 = fadd double %378, %415
  %417 = fcmp ule double %416, %378
  %418 = fcmp une double %413, %203
  %419 = and i1 %418, %417
  br i1 %419, label %420, label %421

420:                                              ; preds = %405
  store double %414, ptr %225, align 8
  br label %1898

421:                                              ; preds = %405
  %422 = load i64, ptr %339, align 8
  %423 = icmp eq i64 %422, 1
  br i1 %423, label %424, label %542

424:                                              ; preds = %421
  %425 = load ptr, ptr %81, align 8
  %426 = getelementptr inbounds i8, ptr %425, i64 32
  %427 = load i64, ptr %426, align 8
  %428 = add nsw i64 %427, 1
  store i64 %428, ptr %426, align 8
  %429 = load ptr, ptr %76, align 8
  %430 = getelementptr inbounds i8, ptr %429, i64 8
  %431 = load i64, ptr %430, align 8
  %432 = load ptr, ptr %78, align 8
  %433 = load i64, ptr %432, align 8
  %434 = icmp eq i64 %433, 0
  br i1 %434, label %435, label %437

435:                                              ; preds = %424
  %436 = icmp sgt i64 %431, 0
  br i1 %436, label %455, label %453

437:                                              ; preds = %424
  %438 = load ptr, ptr %95, align 8
  store double %378, ptr %438, align 8
  %439 = load i64, ptr %96, align 8
  %440 = icmp sgt i64 %439, 0
  br i1 %440, label %441, label %442

441:                                              ; preds = %437
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %442

442:                                              ; preds = %441, %437
  %443 = load ptr, ptr %78, align 8
  %444 = load i64, ptr %443, align 8
  %445 = load ptr, ptr %97, align 8
  %446 = load ptr, ptr %77, align 8
  %447 = load ptr, ptr %98, align 8
  %448 = load ptr, ptr %99, align 8
  %449 = load ptr, ptr %94, align 8
  %450 = inttoptr i64 %444 to ptr
  %451 = tail call i32 %450(ptr noundef %445, ptr noundef %446, ptr noundef %447, ptr noundef %448, ptr noundef %449) #11
  %452 = sext i32 %451 to i64
  br label %523

453:                                              ; preds = %455, %435
  %454 = icmp sgt i64 %431, 0
  br i1 %454, label %467, label %523

455:                                              ; preds = %435, %455
  %456 = phi i64 [ %462, %455 ], [ 0, %435 ]
  %457 = load ptr, ptr %77, align 8
  %458 = getelementptr inbounds double, ptr %457, i64 %456
  %459 = load double, ptr %458, align 8
  %460 = load ptr, ptr %100, align 8
  %461 = getelementptr inbounds double, ptr %460, i64 %456
  store double %459, ptr %461, align 8
  %462 = add nuw nsw i64 %456, 1
  %463 = icmp eq i64 %462, %431
  br i1 %463, label %453, label %455, !llvm.loop !11

464:                                              ; preds = %521
  %465 = add nuw nsw i64 %469, 1
  %466 = icmp eq i64 %465, %431
  br i1 %466, label %523, label %467, !llvm.loop !12

467:                                              ; preds = %453, %464
  %468 = phi i64 [ %522, %464 ], [ undef, %453 ]
  %469 = phi i64 [ %465, %464 ], [ 0, %453 ]
  %470 = load ptr, ptr %77, align 8
  %471 = getelementptr inbounds double, ptr %470, i64 %469
  %472 = load double, ptr %471, align 8
  %473 = tail call double @llvm.fabs.f64(double %472)
  %474 = fcmp olt double %473, 1.000000e-05
  %475 = select i1 %474, double 1.000000e-05, double %473
  %476 = fmul double %475, 1.500000e-08
  %477 = fadd double %472, %476
  %478 = load ptr, ptr %101, align 8
  %479 = getelementptr inbounds double, ptr %478, i64 %469
  store double %477, ptr %479, align 8
  %480 = load ptr, ptr %81, align 8
  %481 = getelementptr inbounds i8, ptr %480, i64 24
  %482 = load i64, ptr %481, align 8
  %483 = add nsw i64 %482, 1
  store i64 %483, ptr %481, align 8
  %484 = load ptr, ptr %101, align 8
  %485 = load ptr, ptr %102, align 8
  %486 = load ptr, ptr %103, align 8
  store double %378, ptr %486, align 8
  %487 = load i64, ptr %104, align 8
  %488 = icmp sgt i64 %487, 0
  br i1 %488, label %489, label %490

489:                                              ; preds = %467
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %490

490:                                              ; preds = %489, %467
  %491 = load ptr, ptr %76, align 8
  %492 = load i64, ptr %491, align 8
  %493 = load ptr, ptr %103, align 8
  %494 = load ptr, ptr %105, align 8
  %495 = load ptr, ptr %106, align 8
  %496 = inttoptr i64 %492 to ptr
  %497 = tail call i32 %496(ptr noundef %493, ptr noundef %484, ptr noundef %494, ptr noundef %495, ptr noundef %485) #11
  %498 = sext i32 %497 to i64
  %499 = icmp eq i32 %497, 0
  br i1 %499, label %500, label %521

500:                                              ; preds = %490
  %501 = fsub double %477, %472
  br label %505

502:                                              ; preds = %505
  %503 = load ptr, ptr %101, align 8
  %504 = getelementptr inbounds double, ptr %503, i64 %469
  store double %472, ptr %504, align 8
  br label %521

505:                                              ; preds = %500, %505
  %506 = phi i64 [ 0, %500 ], [ %519, %505 ]
  %507 = load ptr, ptr %102, align 8
  %508 = getelementptr inbounds double, ptr %507, i64 %506
  %509 = load double, ptr %508, align 8
  %510 = load ptr, ptr %107, align 8
  %511 = getelementptr inbounds double, ptr %510, i64 %506
  %512 = load double, ptr %511, align 8
  %513 = fsub double %509, %512
  %514 = fdiv double %513, %501
  %515 = load ptr, ptr %94, align 8
  %516 = mul nuw nsw i64 %506, %431
  %517 = getelementptr double, ptr %515, i64 %516
  %518 = getelementptr double, ptr %517, i64 %469
  store double %514, ptr %518, align 8
  %519 = add nuw nsw i64 %506, 1
  %520 = icmp eq i64 %519, %431
  br i1 %520, label %502, label %505, !llvm.loop !13

521:                                              ; preds = %502, %490
  %522 = phi i64 [ %468, %502 ], [ %498, %490 ]
  br i1 %499, label %464, label %523

523:                                              ; preds = %521, %464, %453, %442
  %524 = phi i64 [ %452, %442 ], [ 0, %453 ], [ 0, %464 ], [ %522, %521 ]
  %525 = load i64, ptr %108, align 8
  %526 = icmp sgt i64 %525, 0
  br i1 %526, label %527, label %539

527:                                              ; preds = %523, %535
  %528 = phi i64 [ %536, %535 ], [ 0, %523 ]
  %529 = load ptr, ptr %94, align 8
  %530 = getelementptr inbounds double, ptr %529, i64 %528
  %531 = load double, ptr %530, align 8
  %532 = tail call double @llvm.fabs.f64(double %531)
  %533 = fcmp ueq double %532, 0x7FF0000000000000
  br i1 %533, label %534, label %535

534:                                              ; preds = %527
  store double 0.000000e+00, ptr %530, align 8
  br label %535

535:                                              ; preds = %534, %527
  %536 = add nuw nsw i64 %528, 1
  %537 = load i64, ptr %108, align 8
  %538 = icmp slt i64 %536, %537
  br i1 %538, label %527, label %539, !llvm.loop !14

539:                                              ; preds = %535, %523
  %540 = icmp slt i64 %524, 0
  br i1 %540, label %1898, label %541

541:                                              ; preds = %539
  store i64 0, ptr %339, align 8
  store i64 1, ptr %340, align 8
  store i64 0, ptr %341, align 8
  br label %542

542:                                              ; preds = %541, %421
  %543 = load i64, ptr %342, align 8
  %544 = icmp eq i64 %543, 0
  br i1 %544, label %552, label %545

545:                                              ; preds = %542
  %546 = tail call double @llvm.fabs.f64(double %413)
  %547 = fmul double %546, 0x3CB0000000000000
  %548 = load double, ptr %189, align 8
  %549 = fsub double %414, %548
  %550 = tail call double @llvm.fabs.f64(double %549)
  %551 = fcmp ogt double %550, %547
  br i1 %551, label %552, label %615

552:                                              ; preds = %545, %542
  %553 = load i64, ptr %343, align 8
  %554 = add nsw i64 %553, 1
  store i64 %554, ptr %343, align 8
  %555 = load i64, ptr %110, align 8
  %556 = load ptr, ptr %111, align 8
  %557 = load ptr, ptr %112, align 8
  %558 = icmp sgt i64 %555, 0
  br i1 %558, label %559, label %567

559:                                              ; preds = %552
  %560 = fdiv double 0x400D1A48D83E731D, %414
  %561 = add nuw i64 %555, 1
  %562 = fdiv double 0x400572DB93E0C672, %414
  %563 = fdiv double 0x40086747F2C3FCB6, %414
  br label %564

564:                                              ; preds = %559, %571
  %565 = phi i64 [ 0, %559 ], [ %582, %571 ]
  %566 = mul nuw nsw i64 %565, %555
  br label %584

567:                                              ; preds = %571, %552
  %568 = load ptr, ptr %109, align 8
  %569 = tail call fastcc i32 @real_factorise(ptr noundef %556, i64 noundef %555, ptr noundef %568) #10
  %570 = icmp eq i32 %569, 0
  br i1 %570, label %605, label %600

571:                                              ; preds = %584
  %572 = mul i64 %565, %561
  %573 = getelementptr inbounds double, ptr %556, i64 %572
  %574 = load double, ptr %573, align 8
  %575 = fadd double %560, %574
  store double %575, ptr %573, align 8
  %576 = getelementptr inbounds { double, double }, ptr %557, i64 %572
  %577 = load double, ptr %576, align 8
  %578 = getelementptr inbounds i8, ptr %576, i64 8
  %579 = load double, ptr %578, align 8
  %580 = fadd double %562, %577
  %581 = fsub double %579, %563
  store double %580, ptr %576, align 8
  store double %581, ptr %578, align 8
  %582 = add nuw nsw i64 %565, 1
  %583 = icmp eq i64 %582, %555
  br i1 %583, label %567, label %564, !llvm.loop !15

584:                                              ; preds = %564, %584
  %585 = phi i64 [ 0, %564 ], [ %598, %584 ]
  %586 = load ptr, ptr %113, align 8
  %587 = add nuw nsw i64 %585, %566
  %588 = getelementptr inbounds double, ptr %586, i64 %587
  %589 = load double, ptr %588, align 8
  %590 = fneg double %589
  %591 = getelementptr inbounds double, ptr %556, i64 %587
  store double %590, ptr %591, align 8
  %592 = load ptr, ptr %113, align 8
  %593 = getelementptr inbounds double, ptr %592, i64 %587
  %594 = load double, ptr %593, align 8
  %595 = fneg double %594
  %596 = getelementptr inbounds { double, double }, ptr %557, i64 %587
  %597 = getelementptr inbounds i8, ptr %596, i64 8
  store double %595, ptr %596, align 8
  store double 0.000000e+00, ptr %597, align 8
  %598 = add nuw nsw i64 %585, 1
  %599 = icmp eq i64 %598, %555
  br i1 %599, label %571, label %584, !llvm.loop !16

600:                                              ; preds = %567
  %601 = load ptr, ptr %114, align 8
  %602 = tail call fastcc i32 @pair_factorise(ptr noundef %557, i64 noundef %555, ptr noundef %601) #10
  %603 = icmp ne i32 %602, 0
  %604 = zext i1 %603 to i32
  br label %605

605:                                              ; preds = %567, %600
  %606 = phi i32 [ 0, %567 ], [ %604, %600 ]
  %607 = icmp eq i32 %606, 0
  br i1 %607, label %608, label %614

608:                                              ; preds = %605
  store i64 4, ptr %367, align 8
  %609 = load i64, ptr %336, align 8
  %610 = add nsw i64 %609, 1
  store i64 %610, ptr %336, align 8
  %611 = fmul double %414, 5.000000e-01
  %612 = load i64, ptr %368, align 8
  %613 = sub nsw i64 1, %612
  store i64 %613, ptr %339, align 8
  store i64 0, ptr %342, align 8
  br label %1898, !llvm.loop !17

614:                                              ; preds = %605
  store i64 1, ptr %342, align 8
  store double %414, ptr %189, align 8
  br label %615

615:                                              ; preds = %614, %545
  %616 = load double, ptr %344, align 8
  %617 = load ptr, ptr %76, align 8
  %618 = getelementptr inbounds i8, ptr %617, i64 8
  %619 = load i64, ptr %618, align 8
  %620 = load ptr, ptr %115, align 8
  %621 = load ptr, ptr %77, align 8
  %622 = load ptr, ptr %116, align 8
  %623 = load ptr, ptr %117, align 8
  %624 = fcmp ogt double %616, 0.000000e+00
  %625 = icmp sgt i64 %619, 0
  %626 = shl i64 %619, 4
  %627 = getelementptr i8, ptr %620, i64 %626
  %628 = mul i64 %619, 24
  %629 = getelementptr i8, ptr %620, i64 %628
  %630 = getelementptr double, ptr %620, i64 %619
  br label %636

631:                                              ; preds = %650
  %632 = icmp sgt i64 %619, 0
  %633 = getelementptr double, ptr %622, i64 %619
  %634 = shl i64 %619, 4
  %635 = getelementptr i8, ptr %622, i64 %634
  br label %677

636:                                              ; preds = %615, %650
  %637 = phi i64 [ 0, %615 ], [ %651, %650 ]
  br i1 %624, label %638, label %644

638:                                              ; preds = %636
  %639 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %637
  %640 = load double, ptr %639, align 8
  %641 = fmul double %414, %640
  %642 = fdiv double %641, %616
  %643 = fadd double %642, 1.000000e+00
  br label %644

644:                                              ; preds = %638, %636
  %645 = phi double [ %643, %638 ], [ 0.000000e+00, %636 ]
  br i1 %625, label %646, label %650

646:                                              ; preds = %644
  %647 = mul nuw nsw i64 %619, %637
  %648 = getelementptr double, ptr %622, i64 %647
  %649 = fsub double 1.000000e+00, %645
  br label %653

650:                                              ; preds = %674, %644
  %651 = add nuw nsw i64 %637, 1
  %652 = icmp eq i64 %651, 3
  br i1 %652, label %631, label %636, !llvm.loop !18

653:                                              ; preds = %646, %674
  %654 = phi i64 [ 0, %646 ], [ %675, %674 ]
  %655 = getelementptr double, ptr %648, i64 %654
  store double 0.000000e+00, ptr %655, align 8
  br i1 %624, label %656, label %674

656:                                              ; preds = %653
  %657 = getelementptr double, ptr %627, i64 %654
  %658 = load double, ptr %657, align 8
  %659 = getelementptr double, ptr %629, i64 %654
  %660 = load double, ptr %659, align 8
  %661 = fmul double %645, %660
  %662 = fadd double %658, %661
  %663 = fmul double %649, %662
  %664 = getelementptr inbounds double, ptr %620, i64 %654
  %665 = load double, ptr %664, align 8
  %666 = getelementptr double, ptr %630, i64 %654
  %667 = load double, ptr %666, align 8
  %668 = fadd double %667, %663
  %669 = fmul double %645, %668
  %670 = fadd double %665, %669
  %671 = getelementptr inbounds double, ptr %621, i64 %654
  %672 = load double, ptr %671, align 8
  %673 = fsub double %670, %672
  store double %673, ptr %655, align 8
  br label %674

674:                                              ; preds = %656, %653
  %675 = add nuw nsw i64 %654, 1
  %676 = icmp eq i64 %675, %619
  br i1 %676, label %650, label %653, !llvm.loop !19

677:                                              ; preds = %631, %688
  %678 = phi i64 [ 0, %631 ], [ %689, %688 ]
  br i1 %632, label %679, label %688

679:                                              ; preds = %677
  %680 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %678
  %681 = load double, ptr %680, align 8
  %682 = getelementptr inbounds i8, ptr %680, i64 8
  %683 = load double, ptr %682, align 8
  %684 = getelementptr inbounds i8, ptr %680, i64 16
  %685 = load double, ptr %684, align 8
  %686 = mul nuw nsw i64 %619, %678
  %687 = getelementptr double, ptr %623, i64 %686
  br label %691

688:                                              ; preds = %691, %677
  %689 = add nuw nsw i64 %678, 1
  %690 = icmp eq i64 %689, 3
  br i1 %690, label %707, label %677, !llvm.loop !20

691:                                              ; preds = %679, %691
  %692 = phi i64 [ 0, %679 ], [ %705, %691 ]
  %693 = getelementptr inbounds double, ptr %622, i64 %692
  %694 = load double, ptr %693, align 8
  %695 = fmul double %681, %694
  %696 = getelementptr double, ptr %633, i64 %692
  %697 = load double, ptr %696, align 8
  %698 = fmul double %683, %697
  %699 = fadd double %695, %698
  %700 = getelementptr double, ptr %635, i64 %692
  %701 = load double, ptr %700, align 8
  %702 = fmul double %685, %701
  %703 = fadd double %699, %702
  %704 = getelementptr double, ptr %687, i64 %692
  store double %703, ptr %704, align 8
  %705 = add nuw nsw i64 %692, 1
  %706 = icmp eq i64 %705, %619
  br i1 %706, label %688, label %691, !llvm.loop !21

707:                                              ; preds = %688
  %708 = load ptr, ptr %76, align 8, !noalias !22
  %709 = getelementptr inbounds i8, ptr %708, i64 8
  %710 = load i64, ptr %709, align 8, !noalias !22
  %711 = load ptr, ptr %78, align 8, !noalias !22
  %712 = getelementptr inbounds i8, ptr %711, i64 40
  %713 = load i64, ptr %712, align 8, !noalias !22
  %714 = load ptr, ptr %116, align 8, !noalias !22
  %715 = load ptr, ptr %117, align 8, !noalias !22
  %716 = load ptr, ptr %118, align 8, !noalias !22
  %717 = load ptr, ptr %119, align 8, !noalias !22
  %718 = load ptr, ptr %120, align 8, !noalias !22
  %719 = icmp sgt i64 %713, 0
  %720 = select i1 %719, i64 10, i64 6
  %721 = icmp sgt i64 %710, 0
  %722 = fdiv double 0x400D1A48D83E731D, %414
  %723 = fdiv double 0x400572DB93E0C672, %414
  %724 = fdiv double 0xC0086747F2C3FCB6, %414
  %725 = icmp sgt i64 %710, 0
  %726 = getelementptr double, ptr %715, i64 %710
  %727 = shl i64 %710, 4
  %728 = getelementptr i8, ptr %715, i64 %727
  %729 = icmp eq i64 %713, 0
  br label %730

730:                                              ; preds = %707, %1133
  %731 = phi double [ -1.000000e+00, %707 ], [ %1132, %1133 ]
  %732 = phi double [ 0.000000e+00, %707 ], [ %1131, %1133 ]
  %733 = phi i64 [ 0, %707 ], [ %1130, %1133 ]
  %734 = phi i64 [ 0, %707 ], [ %1134, %1133 ]
  %735 = phi i64 [ %380, %707 ], [ %1127, %1133 ]
  %736 = phi i64 [ %381, %707 ], [ %1126, %1133 ]
  %737 = phi i32 [ %382, %707 ], [ %1125, %1133 ]
  %738 = phi double [ %383, %707 ], [ %1124, %1133 ]
  %739 = icmp ugt i64 %734, 5
  %740 = icmp eq i64 %733, 0
  %741 = select i1 %739, i1 %740, i1 false
  br i1 %741, label %1136, label %746

742:                                              ; preds = %768
  %743 = add nuw nsw i64 %747, 1
  %744 = icmp ugt i64 %747, 1
  %745 = icmp eq i64 %743, 3
  br i1 %745, label %791, label %746, !llvm.loop !25

746:                                              ; preds = %730, %742
  %747 = phi i64 [ %743, %742 ], [ 0, %730 ]
  %748 = phi i1 [ %744, %742 ], [ false, %730 ]
  br i1 %721, label %749, label %752

749:                                              ; preds = %746
  %750 = mul nuw nsw i64 %710, %747
  %751 = getelementptr double, ptr %714, i64 %750
  br label %777

752:                                              ; preds = %777, %746
  %753 = load ptr, ptr %81, align 8, !noalias !22
  %754 = getelementptr inbounds i8, ptr %753, i64 24
  %755 = load i64, ptr %754, align 8, !noalias !22
  %756 = add nsw i64 %755, 1
  store i64 %756, ptr %754, align 8, !noalias !22
  %757 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %747
  %758 = load double, ptr %757, align 8, !noalias !22
  %759 = fmul double %414, %758
  %760 = fadd double %378, %759
  %761 = load ptr, ptr %121, align 8, !noalias !22
  %762 = mul nsw i64 %710, %747
  %763 = getelementptr inbounds double, ptr %716, i64 %762
  %764 = load ptr, ptr %122, align 8, !noalias !22
  store double %760, ptr %764, align 8, !noalias !22
  %765 = load i64, ptr %123, align 8, !noalias !22
  %766 = icmp sgt i64 %765, 0
  br i1 %766, label %767, label %768

767:                                              ; preds = %752
  tail call fastcc void @sample(ptr noundef nonnull %76) #10, !noalias !22
  br label %768

768:                                              ; preds = %752, %767
  %769 = load ptr, ptr %76, align 8, !noalias !22
  %770 = load i64, ptr %769, align 8, !noalias !22
  %771 = load ptr, ptr %122, align 8, !noalias !22
  %772 = load ptr, ptr %125, align 8, !noalias !22
  %773 = load ptr, ptr %126, align 8, !noalias !22
  %774 = inttoptr i64 %770 to ptr
  %775 = tail call i32 %774(ptr noundef %771, ptr noundef %761, ptr noundef %772, ptr noundef %773, ptr noundef %763) #11, !noalias !22
  %776 = icmp eq i32 %775, 0
  br i1 %776, label %742, label %789

777:                                              ; preds = %749, %777
  %778 = phi i64 [ 0, %749 ], [ %787, %777 ]
  %779 = load ptr, ptr %77, align 8, !noalias !22
  %780 = getelementptr inbounds double, ptr %779, i64 %778
  %781 = load double, ptr %780, align 8, !noalias !22
  %782 = getelementptr double, ptr %751, i64 %778
  %783 = load double, ptr %782, align 8, !noalias !22
  %784 = fadd double %781, %783
  %785 = load ptr, ptr %124, align 8, !noalias !22
  %786 = getelementptr inbounds double, ptr %785, i64 %778
  store double %784, ptr %786, align 8, !noalias !22
  %787 = add nuw nsw i64 %778, 1
  %788 = icmp eq i64 %787, %710
  br i1 %788, label %752, label %777, !llvm.loop !26

789:                                              ; preds = %768
  %790 = sext i32 %775 to i64
  br label %791

791:                                              ; preds = %742, %789
  %792 = phi i1 [ %748, %789 ], [ %744, %742 ]
  %793 = phi double [ 0.000000e+00, %789 ], [ %738, %742 ]
  %794 = phi i32 [ 0, %789 ], [ %737, %742 ]
  %795 = phi i64 [ %734, %789 ], [ %736, %742 ]
  %796 = phi i64 [ %790, %789 ], [ %735, %742 ]
  %797 = phi i32 [ 1, %789 ], [ 5, %742 ]
  br i1 %792, label %798, label %1136

798:                                              ; preds = %791
  %799 = load ptr, ptr %76, align 8, !noalias !22
  %800 = getelementptr inbounds i8, ptr %799, i64 8
  %801 = load i64, ptr %800, align 8, !noalias !22
  %802 = load ptr, ptr %118, align 8, !noalias !22
  %803 = load ptr, ptr %117, align 8, !noalias !22
  %804 = load ptr, ptr %119, align 8, !noalias !22
  %805 = load ptr, ptr %120, align 8, !noalias !22
  %806 = icmp sgt i64 %801, 0
  br i1 %806, label %807, label %912

807:                                              ; preds = %798
  %808 = shl nuw nsw i64 %801, 1
  %809 = getelementptr double, ptr %802, i64 %801
  %810 = shl i64 %801, 4
  %811 = getelementptr i8, ptr %802, i64 %810
  %812 = load double, ptr %802, align 8, !noalias !22
  %813 = getelementptr inbounds double, ptr %802, i64 %801
  %814 = load double, ptr %813, align 8, !noalias !22
  %815 = fadd double %812, %814
  %816 = getelementptr inbounds double, ptr %802, i64 %808
  %817 = load double, ptr %816, align 8, !noalias !22
  %818 = fadd double %815, %817
  %819 = tail call double @llvm.fabs.f64(double %818)
  %820 = fcmp ueq double %819, 0x7FF0000000000000
  br i1 %820, label %909, label %821

821:                                              ; preds = %807
  %822 = getelementptr double, ptr %803, i64 %801
  %823 = getelementptr inbounds double, ptr %803, i64 %808
  %824 = getelementptr double, ptr %802, i64 %801
  %825 = getelementptr inbounds double, ptr %802, i64 %808
  br label %837

826:                                              ; preds = %837
  %827 = getelementptr inbounds double, ptr %802, i64 %905
  %828 = load double, ptr %827, align 8, !noalias !22
  %829 = getelementptr double, ptr %824, i64 %905
  %830 = load double, ptr %829, align 8, !noalias !22
  %831 = fadd double %828, %830
  %832 = getelementptr inbounds double, ptr %825, i64 %905
  %833 = load double, ptr %832, align 8, !noalias !22
  %834 = fadd double %831, %833
  %835 = tail call double @llvm.fabs.f64(double %834)
  %836 = fcmp ueq double %835, 0x7FF0000000000000
  br i1 %836, label %907, label %837, !llvm.loop !27

837:                                              ; preds = %821, %826
  %838 = phi double [ %828, %826 ], [ %812, %821 ]
  %839 = phi double [ %904, %826 ], [ 0.000000e+00, %821 ]
  %840 = phi i64 [ %905, %826 ], [ 0, %821 ]
  %841 = getelementptr inbounds double, ptr %802, i64 %840
  %842 = fmul double %838, 0x4010B70201A79C46
  %843 = getelementptr double, ptr %809, i64 %840
  %844 = load double, ptr %843, align 8, !noalias !22
  %845 = fmul double %844, 0x3FD4F8C15DA84E86
  %846 = fadd double %842, %845
  %847 = getelementptr double, ptr %811, i64 %840
  %848 = load double, ptr %847, align 8, !noalias !22
  %849 = fmul double %848, 0x3FE0BF7FF59D56EF
  %850 = fadd double %846, %849
  %851 = getelementptr inbounds double, ptr %803, i64 %840
  %852 = load double, ptr %851, align 8, !noalias !22
  %853 = fmul double %722, %852
  %854 = fsub double %850, %853
  %855 = getelementptr inbounds double, ptr %804, i64 %840
  store double %854, ptr %855, align 8, !noalias !22
  %856 = load double, ptr %841, align 8, !noalias !22
  %857 = fmul double %856, 0xC010B70201A79C46
  %858 = load double, ptr %843, align 8, !noalias !22
  %859 = fmul double %858, 0x3FD4F8C15DA84E86
  %860 = fsub double %857, %859
  %861 = load double, ptr %847, align 8, !noalias !22
  %862 = fmul double %861, 0x3FDE810014C55221
  %863 = fadd double %860, %862
  %864 = fmul double %856, 0x3FE017885A24A7F2
  %865 = fmul double %858, 0x4004934E6FCAA598
  %866 = fsub double %864, %865
  %867 = fmul double %861, 0x3FE312C0CF7BDFD1
  %868 = fadd double %866, %867
  %869 = getelementptr double, ptr %822, i64 %840
  %870 = load double, ptr %869, align 8, !noalias !22
  %871 = getelementptr inbounds double, ptr %823, i64 %840
  %872 = load double, ptr %871, align 8, !noalias !22
  %873 = fmul double %723, %870
  %874 = fmul double %724, %872
  %875 = fmul double %723, %872
  %876 = fmul double %724, %870
  %877 = fsub double %873, %874
  %878 = fadd double %876, %875
  %879 = fsub double %863, %877
  %880 = fsub double %868, %878
  %881 = getelementptr inbounds { double, double }, ptr %805, i64 %840
  %882 = getelementptr inbounds i8, ptr %881, i64 8
  store double %879, ptr %881, align 8, !noalias !22
  store double %880, ptr %882, align 8, !noalias !22
  %883 = load double, ptr %855, align 8, !noalias !22
  %884 = tail call double @llvm.fabs.f64(double %883)
  %885 = tail call double @llvm.fabs.f64(double %879)
  %886 = fadd double %884, %885
  %887 = tail call double @llvm.fabs.f64(double %880)
  %888 = fadd double %887, %886
  %889 = fmul double %414, %888
  %890 = load ptr, ptr %77, align 8, !noalias !22
  %891 = getelementptr inbounds double, ptr %890, i64 %840
  %892 = load double, ptr %891, align 8, !noalias !22
  %893 = load ptr, ptr %127, align 8, !noalias !22
  %894 = getelementptr inbounds double, ptr %893, i64 %840
  %895 = load double, ptr %894, align 8, !noalias !22
  %896 = load ptr, ptr %128, align 8, !noalias !22
  %897 = getelementptr inbounds double, ptr %896, i64 %840
  %898 = load double, ptr %897, align 8, !noalias !22
  %899 = tail call double @llvm.fabs.f64(double %892)
  %900 = fmul double %899, %898
  %901 = fadd double %895, %900
  %902 = fdiv double %889, %901
  %903 = fmul double %902, %902
  %904 = fadd double %839, %903
  %905 = add nuw nsw i64 %840, 1
  %906 = icmp eq i64 %905, %801
  br i1 %906, label %912, label %826, !llvm.loop !27

907:                                              ; preds = %826
  %908 = icmp slt i64 %905, %801
  br label %909

909:                                              ; preds = %907, %807
  %910 = phi i1 [ %908, %907 ], [ %806, %807 ]
  %911 = phi double [ %904, %907 ], [ 0.000000e+00, %807 ]
  br i1 %910, label %1136, label %912

912:                                              ; preds = %837, %798, %909
  %913 = phi double [ %911, %909 ], [ 0.000000e+00, %798 ], [ %904, %837 ]
  %914 = load ptr, ptr %76, align 8, !noalias !22
  %915 = getelementptr inbounds i8, ptr %914, i64 8
  %916 = load i64, ptr %915, align 8, !noalias !22
  %917 = load i64, ptr %130, align 8, !noalias !22
  %918 = load ptr, ptr %78, align 8, !noalias !22
  %919 = getelementptr inbounds i8, ptr %918, i64 40
  %920 = load i64, ptr %919, align 8, !noalias !22
  %921 = load ptr, ptr %119, align 8, !noalias !22
  %922 = load ptr, ptr %120, align 8, !noalias !22
  %923 = load ptr, ptr %131, align 8, !noalias !22
  %924 = load ptr, ptr %129, align 8, !noalias !22
  tail call fastcc void @real_solve(ptr noundef %923, i64 noundef %917, ptr noundef %924, ptr noundef %921) #10, !noalias !22
  %925 = load ptr, ptr %132, align 8, !noalias !22
  %926 = load ptr, ptr %133, align 8, !noalias !22
  tail call fastcc void @pair_solve(ptr noundef %925, i64 noundef %917, ptr noundef %926, ptr noundef %922) #10, !noalias !22
  %927 = icmp sgt i64 %920, 0
  br i1 %927, label %928, label %933

928:                                              ; preds = %912
  %929 = load ptr, ptr %131, align 8, !noalias !22
  %930 = load ptr, ptr %129, align 8, !noalias !22
  tail call fastcc void @real_solve_columns(ptr noundef %929, i64 noundef %917, ptr noundef %930, ptr noundef %921, i64 noundef %920) #10, !noalias !22
  %931 = load ptr, ptr %132, align 8, !noalias !22
  %932 = load ptr, ptr %133, align 8, !noalias !22
  tail call fastcc void @pair_solve_columns(ptr noundef %931, i64 noundef %917, ptr noundef %932, ptr noundef %922, i64 noundef %920) #10, !noalias !22
  br label %933

933:                                              ; preds = %928, %912
  %934 = icmp sgt i64 %916, 0
  br i1 %934, label %935, label %968

935:                                              ; preds = %933
  %936 = load ptr, ptr %77, align 8, !noalias !22
  %937 = load ptr, ptr %134, align 8, !noalias !22
  %938 = load ptr, ptr %135, align 8, !noalias !22
  br label %939

939:                                              ; preds = %935, %939
  %940 = phi double [ 0.000000e+00, %935 ], [ %965, %939 ]
  %941 = phi i64 [ 0, %935 ], [ %966, %939 ]
  %942 = getelementptr inbounds double, ptr %936, i64 %941
  %943 = load double, ptr %942, align 8, !noalias !22
  %944 = getelementptr inbounds double, ptr %937, i64 %941
  %945 = load double, ptr %944, align 8, !noalias !22
  %946 = getelementptr inbounds double, ptr %938, i64 %941
  %947 = load double, ptr %946, align 8, !noalias !22
  %948 = tail call double @llvm.fabs.f64(double %943)
  %949 = fmul double %948, %947
  %950 = fadd double %945, %949
  %951 = getelementptr inbounds double, ptr %921, i64 %941
  %952 = load double, ptr %951, align 8, !noalias !22
  %953 = fdiv double %952, %950
  %954 = getelementptr inbounds { double, double }, ptr %922, i64 %941
  %955 = load double, ptr %954, align 8, !noalias !22
  %956 = getelementptr inbounds i8, ptr %954, i64 8
  %957 = fdiv double %955, %950
  %958 = load double, ptr %956, align 8, !noalias !22
  %959 = fdiv double %958, %950
  %960 = fmul double %953, %953
  %961 = fmul double %957, %957
  %962 = fadd double %960, %961
  %963 = fmul double %959, %959
  %964 = fadd double %962, %963
  %965 = fadd double %940, %964
  %966 = add nuw nsw i64 %941, 1
  %967 = icmp eq i64 %966, %916
  br i1 %967, label %968, label %939, !llvm.loop !28

968:                                              ; preds = %939, %933
  %969 = phi double [ 0.000000e+00, %933 ], [ %965, %939 ]
  %970 = mul nsw i64 %916, 3
  %971 = sitofp i64 %970 to double
  %972 = fdiv double %969, %971
  %973 = tail call double @llvm.sqrt.f64(double %972)
  %974 = fcmp oeq double %973, 0.000000e+00
  %975 = fcmp ogt double %913, 0.000000e+00
  %976 = select i1 %974, i1 %975, i1 false
  br i1 %976, label %977, label %979

977:                                              ; preds = %968
  %978 = add nuw nsw i64 %734, 1
  br label %1123

979:                                              ; preds = %968
  %980 = fcmp ogt double %731, 0.000000e+00
  %981 = select i1 %980, i1 %740, i1 false
  br i1 %981, label %982, label %995

982:                                              ; preds = %979
  %983 = fdiv double %973, %731
  %984 = fcmp ult double %983, 1.000000e+00
  br i1 %984, label %985, label %993

985:                                              ; preds = %982
  %986 = sub nsw i64 5, %734
  %987 = sitofp i64 %986 to double
  %988 = tail call double @llvm.pow.f64(double %983, double %987)
  %989 = fsub double 1.000000e+00, %983
  %990 = fdiv double %988, %989
  %991 = fmul double %973, %990
  %992 = fcmp ogt double %991, %223
  br i1 %992, label %993, label %995

993:                                              ; preds = %985, %982
  %994 = add nuw nsw i64 %734, 1
  br label %1123

995:                                              ; preds = %985, %979
  %996 = phi double [ %732, %979 ], [ %983, %985 ]
  br i1 %725, label %1008, label %997

997:                                              ; preds = %1026, %995
  %998 = fsub double 1.000000e+00, %996
  %999 = fdiv double %996, %998
  %1000 = fmul double %973, %999
  %1001 = fcmp olt double %1000, %223
  %1002 = select i1 %980, i1 %1001, i1 false
  %1003 = select i1 %974, i1 true, i1 %1002
  %1004 = add nuw nsw i64 %734, 1
  %1005 = select i1 %1003, i64 %1004, i64 0
  %1006 = select i1 %740, i64 %1005, i64 %733
  %1007 = icmp sgt i64 %1006, 0
  br i1 %1007, label %1049, label %1122

1008:                                             ; preds = %995, %1026
  %1009 = phi i64 [ %1027, %1026 ], [ 0, %995 ]
  %1010 = getelementptr inbounds double, ptr %717, i64 %1009
  %1011 = load double, ptr %1010, align 8, !noalias !22
  %1012 = getelementptr inbounds double, ptr %715, i64 %1009
  %1013 = load double, ptr %1012, align 8, !noalias !22
  %1014 = fadd double %1011, %1013
  store double %1014, ptr %1012, align 8, !noalias !22
  %1015 = getelementptr inbounds { double, double }, ptr %718, i64 %1009
  %1016 = load double, ptr %1015, align 8, !noalias !22
  %1017 = getelementptr inbounds i8, ptr %1015, i64 8
  %1018 = getelementptr double, ptr %726, i64 %1009
  %1019 = load double, ptr %1018, align 8, !noalias !22
  %1020 = fadd double %1016, %1019
  store double %1020, ptr %1018, align 8, !noalias !22
  %1021 = load double, ptr %1017, align 8, !noalias !22
  %1022 = getelementptr double, ptr %728, i64 %1009
  %1023 = load double, ptr %1022, align 8, !noalias !22
  %1024 = fadd double %1021, %1023
  store double %1024, ptr %1022, align 8, !noalias !22
  %1025 = getelementptr double, ptr %714, i64 %1009
  br label %1029

1026:                                             ; preds = %1029
  %1027 = add nuw nsw i64 %1009, 1
  %1028 = icmp eq i64 %1027, %710
  br i1 %1028, label %997, label %1008, !llvm.loop !29

1029:                                             ; preds = %1008, %1029
  %1030 = phi i64 [ 0, %1008 ], [ %1047, %1029 ]
  %1031 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1030
  %1032 = load double, ptr %1031, align 8, !noalias !22
  %1033 = load double, ptr %1012, align 8, !noalias !22
  %1034 = fmul double %1032, %1033
  %1035 = getelementptr inbounds i8, ptr %1031, i64 8
  %1036 = load double, ptr %1035, align 8, !noalias !22
  %1037 = load double, ptr %1018, align 8, !noalias !22
  %1038 = fmul double %1036, %1037
  %1039 = fadd double %1034, %1038
  %1040 = getelementptr inbounds i8, ptr %1031, i64 16
  %1041 = load double, ptr %1040, align 8, !noalias !22
  %1042 = load double, ptr %1022, align 8, !noalias !22
  %1043 = fmul double %1041, %1042
  %1044 = fadd double %1039, %1043
  %1045 = mul nuw nsw i64 %710, %1030
  %1046 = getelementptr double, ptr %1025, i64 %1045
  store double %1044, ptr %1046, align 8, !noalias !22
  %1047 = add nuw nsw i64 %1030, 1
  %1048 = icmp eq i64 %1047, 3
  br i1 %1048, label %1026, label %1029, !llvm.loop !30

1049:                                             ; preds = %997
  br i1 %729, label %1123, label %1050

1050:                                             ; preds = %1049
  %1051 = load i64, ptr %136, align 8, !noalias !22
  %1052 = load ptr, ptr %78, align 8, !noalias !22
  %1053 = getelementptr inbounds i8, ptr %1052, i64 40
  %1054 = load i64, ptr %1053, align 8, !noalias !22
  %1055 = load ptr, ptr %139, align 8, !noalias !22
  %1056 = load ptr, ptr %137, align 8, !noalias !22
  %1057 = load ptr, ptr %140, align 8, !noalias !22
  %1058 = icmp sgt i64 %1054, 0
  br i1 %1058, label %1059, label %1119

1059:                                             ; preds = %1050
  %1060 = load i64, ptr %138, align 8, !noalias !22
  %1061 = icmp sgt i64 %1051, 0
  %1062 = getelementptr double, ptr %1056, i64 %1060
  %1063 = shl i64 %1060, 4
  %1064 = getelementptr i8, ptr %1056, i64 %1063
  br label %1065

1065:                                             ; preds = %1059, %1115
  %1066 = phi double [ 0.000000e+00, %1059 ], [ %1116, %1115 ]
  %1067 = phi i64 [ 0, %1059 ], [ %1117, %1115 ]
  br i1 %1061, label %1068, label %1071

1068:                                             ; preds = %1065
  %1069 = add nuw i64 %1067, %1051
  %1070 = load ptr, ptr %77, align 8, !noalias !22
  br label %1076

1071:                                             ; preds = %1076, %1065
  %1072 = phi double [ 0.000000e+00, %1065 ], [ %1108, %1076 ]
  %1073 = phi double [ 0.000000e+00, %1065 ], [ %1092, %1076 ]
  %1074 = fmul double %1066, %1072
  %1075 = fcmp ogt double %1073, %1074
  br i1 %1075, label %1111, label %1115

1076:                                             ; preds = %1068, %1076
  %1077 = phi double [ 0.000000e+00, %1068 ], [ %1092, %1076 ]
  %1078 = phi double [ 0.000000e+00, %1068 ], [ %1108, %1076 ]
  %1079 = phi i64 [ 0, %1068 ], [ %1109, %1076 ]
  %1080 = mul nuw nsw i64 %1079, %1054
  %1081 = add i64 %1069, %1080
  %1082 = getelementptr inbounds double, ptr %1055, i64 %1081
  %1083 = load double, ptr %1082, align 8, !noalias !22
  %1084 = fmul double %1083, %1083
  %1085 = getelementptr inbounds { double, double }, ptr %1057, i64 %1081
  %1086 = load double, ptr %1085, align 8, !noalias !22
  %1087 = getelementptr inbounds i8, ptr %1085, i64 8
  %1088 = load double, ptr %1087, align 8, !noalias !22
  %1089 = tail call double @hypot(double noundef %1086, double noundef %1088) #13
  %1090 = fmul double %1089, %1089
  %1091 = fadd double %1084, %1090
  %1092 = fadd double %1077, %1091
  %1093 = getelementptr inbounds double, ptr %1070, i64 %1081
  %1094 = load double, ptr %1093, align 8, !noalias !22
  %1095 = fmul double %1094, %1094
  %1096 = fadd double %1078, %1095
  %1097 = getelementptr inbounds double, ptr %1056, i64 %1081
  %1098 = load double, ptr %1097, align 8, !noalias !22
  %1099 = fmul double %1098, %1098
  %1100 = getelementptr double, ptr %1062, i64 %1081
  %1101 = load double, ptr %1100, align 8, !noalias !22
  %1102 = fmul double %1101, %1101
  %1103 = fadd double %1099, %1102
  %1104 = getelementptr double, ptr %1064, i64 %1081
  %1105 = load double, ptr %1104, align 8, !noalias !22
  %1106 = fmul double %1105, %1105
  %1107 = fadd double %1103, %1106
  %1108 = fadd double %1096, %1107
  %1109 = add nuw nsw i64 %1079, 1
  %1110 = icmp eq i64 %1109, %1051
  br i1 %1110, label %1071, label %1076, !llvm.loop !31

1111:                                             ; preds = %1071
  %1112 = fcmp ogt double %1072, 0.000000e+00
  %1113 = fdiv double %1073, %1072
  %1114 = select i1 %1112, double %1113, double 1.000000e+00
  br label %1115

1115:                                             ; preds = %1111, %1071
  %1116 = phi double [ %1114, %1111 ], [ %1066, %1071 ]
  %1117 = add nuw nsw i64 %1067, 1
  %1118 = icmp eq i64 %1117, %1054
  br i1 %1118, label %1119, label %1065, !llvm.loop !32

1119:                                             ; preds = %1115, %1050
  %1120 = phi double [ 0.000000e+00, %1050 ], [ %1116, %1115 ]
  %1121 = fcmp ugt double %1120, %346
  br i1 %1121, label %1122, label %1123

1122:                                             ; preds = %1119, %997
  br label %1123

1123:                                             ; preds = %1122, %1119, %1049, %993, %977
  %1124 = phi double [ %732, %977 ], [ %983, %993 ], [ %793, %1049 ], [ %793, %1122 ], [ %793, %1119 ]
  %1125 = phi i32 [ 0, %977 ], [ 0, %993 ], [ %794, %1049 ], [ %794, %1122 ], [ %794, %1119 ]
  %1126 = phi i64 [ %978, %977 ], [ %994, %993 ], [ %795, %1049 ], [ %795, %1122 ], [ %795, %1119 ]
  %1127 = phi i64 [ 0, %977 ], [ 0, %993 ], [ %796, %1049 ], [ %796, %1122 ], [ %796, %1119 ]
  %1128 = phi i1 [ false, %977 ], [ false, %993 ], [ false, %1049 ], [ true, %1122 ], [ false, %1119 ]
  %1129 = phi i32 [ 1, %977 ], [ 1, %993 ], [ 2, %1049 ], [ 0, %1122 ], [ 2, %1119 ]
  %1130 = phi i64 [ %733, %977 ], [ 0, %993 ], [ %1006, %1049 ], [ %1006, %1122 ], [ %1006, %1119 ]
  %1131 = phi double [ %732, %977 ], [ %983, %993 ], [ %996, %1049 ], [ %996, %1122 ], [ %996, %1119 ]
  %1132 = phi double [ %731, %977 ], [ %731, %993 ], [ %731, %1049 ], [ %973, %1122 ], [ %731, %1119 ]
  br i1 %1128, label %1133, label %1136

1133:                                             ; preds = %1123
  %1134 = add nuw nsw i64 %734, 1
  %1135 = icmp eq i64 %1134, %720
  br i1 %1135, label %1136, label %730, !llvm.loop !33

1136:                                             ; preds = %909, %1123, %791, %730, %1133
  %1137 = phi double [ %738, %730 ], [ %1124, %1123 ], [ %793, %791 ], [ %1124, %1133 ], [ 0x7FF0000000000000, %909 ]
  %1138 = phi i32 [ %737, %730 ], [ %1125, %1123 ], [ %794, %791 ], [ %1125, %1133 ], [ 0, %909 ]
  %1139 = phi i64 [ %736, %730 ], [ %1126, %1123 ], [ %795, %791 ], [ %1126, %1133 ], [ %734, %909 ]
  %1140 = phi i64 [ %735, %730 ], [ %1127, %1123 ], [ %796, %791 ], [ %1127, %1133 ], [ 0, %909 ]
  %1141 = phi i32 [ 2, %730 ], [ %1129, %1123 ], [ %797, %791 ], [ 2, %1133 ], [ 1, %909 ]
  %1142 = phi i64 [ 0, %730 ], [ %1130, %1123 ], [ %733, %791 ], [ %1130, %1133 ], [ %733, %909 ]
  %1143 = phi double [ %732, %730 ], [ %1131, %1123 ], [ %732, %791 ], [ %1131, %1133 ], [ %732, %909 ]
  %1144 = icmp eq i32 %1141, 2
  br i1 %1144, label %1145, label %1149

1145:                                             ; preds = %1136
  %1146 = icmp sgt i64 %1142, 0
  %1147 = select i1 %1146, i64 %1142, i64 6
  %1148 = zext i1 %1146 to i32
  br label %1149

1149:                                             ; preds = %1136, %1145
  %1150 = phi double [ %1143, %1145 ], [ %1137, %1136 ]
  %1151 = phi i32 [ %1148, %1145 ], [ %1138, %1136 ]
  %1152 = phi i64 [ %1147, %1145 ], [ %1139, %1136 ]
  %1153 = phi i64 [ 0, %1145 ], [ %1140, %1136 ]
  %1154 = icmp slt i64 %1153, 0
  br i1 %1154, label %1898, label %1155

1155:                                             ; preds = %1149
  %1156 = icmp eq i32 %1151, 0
  br i1 %1156, label %1158, label %1157

1157:                                             ; preds = %1155
  br i1 %347, label %1309, label %1208

1158:                                             ; preds = %1155
  %1159 = load i64, ptr %336, align 8
  %1160 = add nsw i64 %1159, 1
  store i64 %1160, ptr %336, align 8
  %1161 = tail call double @llvm.fabs.f64(double %1150)
  %1162 = fcmp ueq double %1161, 0x7FF0000000000000
  %1163 = select i1 %1162, i64 4, i64 7
  %1164 = icmp eq i64 %1153, 0
  %1165 = select i1 %1164, i64 %1163, i64 3
  store i64 %1165, ptr %365, align 8
  %1166 = load i64, ptr %366, align 8
  %1167 = icmp eq i64 %1166, 1
  %1168 = and i1 %1164, %1167
  br i1 %1168, label %1169, label %1195

1169:                                             ; preds = %1158
  %1170 = load i64, ptr %181, align 8
  %1171 = icmp sgt i64 %1170, 0
  br i1 %1171, label %1172, label %1189

1172:                                             ; preds = %1169, %1181
  %1173 = phi i64 [ %1186, %1181 ], [ 0, %1169 ]
  %1174 = phi i32 [ %1183, %1181 ], [ 0, %1169 ]
  %1175 = icmp eq i32 %1174, 0
  br i1 %1175, label %1176, label %1181

1176:                                             ; preds = %1172
  %1177 = load ptr, ptr %180, align 8
  %1178 = getelementptr inbounds double, ptr %1177, i64 %1173
  %1179 = load double, ptr %1178, align 8
  %1180 = fcmp une double %1179, 0.000000e+00
  br label %1181

1181:                                             ; preds = %1176, %1172
  %1182 = phi i1 [ true, %1172 ], [ %1180, %1176 ]
  %1183 = zext i1 %1182 to i32
  %1184 = load ptr, ptr %180, align 8
  %1185 = getelementptr inbounds double, ptr %1184, i64 %1173
  store double 0.000000e+00, ptr %1185, align 8
  %1186 = add nuw nsw i64 %1173, 1
  %1187 = load i64, ptr %181, align 8
  %1188 = icmp slt i64 %1186, %1187
  br i1 %1188, label %1172, label %1189, !llvm.loop !34

1189:                                             ; preds = %1181, %1169
  %1190 = phi i32 [ 0, %1169 ], [ %1183, %1181 ]
  %1191 = icmp eq i32 %1190, 0
  br i1 %1191, label %1193, label %1192

1192:                                             ; preds = %1189
  store i64 0, ptr %342, align 8
  br label %1898, !llvm.loop !17

1193:                                             ; preds = %1189
  store i64 0, ptr %366, align 8
  %1194 = fmul double %414, 5.000000e-01
  br label %1195

1195:                                             ; preds = %1193, %1158
  %1196 = phi double [ %1194, %1193 ], [ %379, %1158 ]
  %1197 = load i64, ptr %366, align 8
  %1198 = icmp eq i64 %1197, 1
  %1199 = icmp ne i64 %1153, 0
  %1200 = or i1 %1199, %1198
  br i1 %1200, label %1201, label %1204

1201:                                             ; preds = %1195
  %1202 = select i1 %1164, double 5.000000e-01, double 2.500000e-01
  %1203 = fmul double %414, %1202
  store double 0.000000e+00, ptr %344, align 8
  br label %1204

1204:                                             ; preds = %1201, %1195
  %1205 = phi double [ %1203, %1201 ], [ %1196, %1195 ]
  %1206 = load i64, ptr %366, align 8
  %1207 = sub nsw i64 1, %1206
  store i64 %1207, ptr %339, align 8
  br label %1898, !llvm.loop !17

1208:                                             ; preds = %1309, %1157
  %1209 = load i64, ptr %349, align 8
  %1210 = icmp eq i64 %1209, 1
  %1211 = load ptr, ptr %76, align 8
  %1212 = getelementptr inbounds i8, ptr %1211, i64 8
  %1213 = load i64, ptr %1212, align 8
  %1214 = load i64, ptr %143, align 8
  %1215 = load ptr, ptr %144, align 8
  %1216 = load ptr, ptr %119, align 8
  %1217 = icmp sgt i64 %1213, 0
  br i1 %1217, label %1218, label %1220

1218:                                             ; preds = %1208
  %1219 = shl i64 %1213, 4
  br label %1229

1220:                                             ; preds = %1229, %1208
  %1221 = load ptr, ptr %146, align 8
  %1222 = load ptr, ptr %142, align 8
  tail call fastcc void @real_solve(ptr noundef %1221, i64 noundef %1214, ptr noundef %1222, ptr noundef %1216) #10
  %1223 = load ptr, ptr %147, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1216, ptr noundef %1223, ptr noundef nonnull %77, i64 noundef %1213) #10
  %1224 = load double, ptr %6, align 8
  %1225 = fcmp uge double %1224, 1.000000e+00
  %1226 = and i1 %1210, %1225
  br i1 %1226, label %1227, label %1305

1227:                                             ; preds = %1220
  %1228 = icmp sgt i64 %1213, 0
  br i1 %1228, label %1277, label %1254

1229:                                             ; preds = %1218, %1229
  %1230 = phi i64 [ 0, %1218 ], [ %1252, %1229 ]
  %1231 = load ptr, ptr %116, align 8
  %1232 = getelementptr inbounds double, ptr %1231, i64 %1230
  %1233 = load double, ptr %1232, align 8
  %1234 = fmul double %1233, 0x402418FD8BAFFE05
  %1235 = getelementptr double, ptr %1231, i64 %1213
  %1236 = getelementptr double, ptr %1235, i64 %1230
  %1237 = load double, ptr %1236, align 8
  %1238 = fmul double %1237, 0x3FF61D41B2D54580
  %1239 = fsub double %1238, %1234
  %1240 = getelementptr i8, ptr %1231, i64 %1219
  %1241 = getelementptr double, ptr %1240, i64 %1230
  %1242 = load double, ptr %1241, align 8
  %1243 = fmul double %1242, 0x3FD5555555555555
  %1244 = fsub double %1239, %1243
  %1245 = fdiv double %1244, %414
  %1246 = getelementptr inbounds double, ptr %1215, i64 %1230
  store double %1245, ptr %1246, align 8
  %1247 = load ptr, ptr %145, align 8
  %1248 = getelementptr inbounds double, ptr %1247, i64 %1230
  %1249 = load double, ptr %1248, align 8
  %1250 = fadd double %1249, %1245
  %1251 = getelementptr inbounds double, ptr %1216, i64 %1230
  store double %1250, ptr %1251, align 8
  %1252 = add nuw nsw i64 %1230, 1
  %1253 = icmp eq i64 %1252, %1213
  br i1 %1253, label %1220, label %1229, !llvm.loop !35

1254:                                             ; preds = %1277, %1227
  %1255 = load ptr, ptr %81, align 8
  %1256 = getelementptr inbounds i8, ptr %1255, i64 24
  %1257 = load i64, ptr %1256, align 8
  %1258 = add nsw i64 %1257, 1
  store i64 %1258, ptr %1256, align 8
  %1259 = load ptr, ptr %149, align 8
  %1260 = load ptr, ptr %118, align 8
  %1261 = load ptr, ptr %150, align 8
  store double %378, ptr %1261, align 8
  %1262 = load i64, ptr %151, align 8
  %1263 = icmp sgt i64 %1262, 0
  br i1 %1263, label %1264, label %1265

1264:                                             ; preds = %1254
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1265

1265:                                             ; preds = %1254, %1264
  %1266 = load ptr, ptr %76, align 8
  %1267 = load i64, ptr %1266, align 8
  %1268 = load ptr, ptr %150, align 8
  %1269 = load ptr, ptr %152, align 8
  %1270 = load ptr, ptr %153, align 8
  %1271 = inttoptr i64 %1267 to ptr
  %1272 = tail call i32 %1271(ptr noundef %1268, ptr noundef %1259, ptr noundef %1269, ptr noundef %1270, ptr noundef %1260) #11
  %1273 = sext i32 %1272 to i64
  %1274 = icmp eq i32 %1272, 0
  br i1 %1274, label %1275, label %1305

1275:                                             ; preds = %1265
  %1276 = icmp sgt i64 %1213, 0
  br i1 %1276, label %1294, label %1289

1277:                                             ; preds = %1227, %1277
  %1278 = phi i64 [ %1287, %1277 ], [ 0, %1227 ]
  %1279 = load ptr, ptr %77, align 8
  %1280 = getelementptr inbounds double, ptr %1279, i64 %1278
  %1281 = load double, ptr %1280, align 8
  %1282 = getelementptr inbounds double, ptr %1216, i64 %1278
  %1283 = load double, ptr %1282, align 8
  %1284 = fadd double %1281, %1283
  %1285 = load ptr, ptr %148, align 8
  %1286 = getelementptr inbounds double, ptr %1285, i64 %1278
  store double %1284, ptr %1286, align 8
  %1287 = add nuw nsw i64 %1278, 1
  %1288 = icmp eq i64 %1287, %1213
  br i1 %1288, label %1254, label %1277, !llvm.loop !36

1289:                                             ; preds = %1294, %1275
  %1290 = load ptr, ptr %146, align 8
  %1291 = load ptr, ptr %142, align 8
  tail call fastcc void @real_solve(ptr noundef %1290, i64 noundef %1214, ptr noundef %1291, ptr noundef %1216) #10
  %1292 = load ptr, ptr %147, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1216, ptr noundef %1292, ptr noundef nonnull %77, i64 noundef %1213) #10
  %1293 = load double, ptr %7, align 8
  br label %1305

1294:                                             ; preds = %1275, %1294
  %1295 = phi i64 [ %1303, %1294 ], [ 0, %1275 ]
  %1296 = load ptr, ptr %118, align 8
  %1297 = getelementptr inbounds double, ptr %1296, i64 %1295
  %1298 = load double, ptr %1297, align 8
  %1299 = getelementptr inbounds double, ptr %1215, i64 %1295
  %1300 = load double, ptr %1299, align 8
  %1301 = fadd double %1298, %1300
  %1302 = getelementptr inbounds double, ptr %1216, i64 %1295
  store double %1301, ptr %1302, align 8
  %1303 = add nuw nsw i64 %1295, 1
  %1304 = icmp eq i64 %1303, %1213
  br i1 %1304, label %1289, label %1294, !llvm.loop !37

1305:                                             ; preds = %1220, %1265, %1289
  %1306 = phi double [ %1293, %1289 ], [ %1224, %1265 ], [ %1224, %1220 ]
  %1307 = phi i64 [ 0, %1289 ], [ %1273, %1265 ], [ 0, %1220 ]
  %1308 = icmp slt i64 %1307, 0
  br i1 %1308, label %1898, label %1323

1309:                                             ; preds = %1157, %1309
  %1310 = phi i64 [ %1321, %1309 ], [ 0, %1157 ]
  %1311 = load ptr, ptr %77, align 8
  %1312 = getelementptr inbounds double, ptr %1311, i64 %1310
  %1313 = load double, ptr %1312, align 8
  %1314 = load ptr, ptr %116, align 8
  %1315 = getelementptr i8, ptr %1314, i64 %348
  %1316 = getelementptr double, ptr %1315, i64 %1310
  %1317 = load double, ptr %1316, align 8
  %1318 = fadd double %1313, %1317
  %1319 = load ptr, ptr %141, align 8
  %1320 = getelementptr inbounds double, ptr %1319, i64 %1310
  store double %1318, ptr %1320, align 8
  %1321 = add nuw nsw i64 %1310, 1
  %1322 = icmp eq i64 %1321, %198
  br i1 %1322, label %1208, label %1309, !llvm.loop !38

1323:                                             ; preds = %1305
  %1324 = add nsw i64 %1152, 12
  %1325 = sitofp i64 %1324 to double
  %1326 = fdiv double 0x4027666666666667, %1325
  %1327 = fcmp olt double %1306, 1.000000e-10
  %1328 = select i1 %1327, double 1.000000e-10, double %1306
  %1329 = tail call double @llvm.pow.f64(double %1328, double -2.500000e-01)
  %1330 = icmp eq i64 %1307, 0
  %1331 = fcmp olt double %1306, 1.000000e+00
  %1332 = select i1 %1330, i1 %1331, i1 false
  br i1 %1332, label %1348, label %1333

1333:                                             ; preds = %1323
  %1334 = load i64, ptr %336, align 8
  %1335 = add nsw i64 %1334, 1
  store i64 %1335, ptr %336, align 8
  %1336 = select i1 %1330, i64 2, i64 3
  store i64 %1336, ptr %350, align 8
  %1337 = tail call double @llvm.fabs.f64(double %1306)
  %1338 = fcmp ueq double %1337, 0x7FF0000000000000
  br i1 %1338, label %1343, label %1339

1339:                                             ; preds = %1333
  %1340 = fmul double %1326, %1329
  %1341 = fcmp ogt double %1340, 2.000000e-01
  %1342 = select i1 %1341, double %1340, double 2.000000e-01
  br label %1343

1343:                                             ; preds = %1333, %1339
  %1344 = phi double [ %1342, %1339 ], [ 2.500000e-01, %1333 ]
  %1345 = fmul double %414, %1344
  store i64 1, ptr %349, align 8
  %1346 = load i64, ptr %351, align 8
  %1347 = sub nsw i64 1, %1346
  store i64 %1347, ptr %339, align 8
  br label %1898, !llvm.loop !17

1348:                                             ; preds = %1323
  br i1 %206, label %1349, label %1364

1349:                                             ; preds = %1348
  %1350 = load ptr, ptr %147, align 8
  %1351 = load ptr, ptr %77, align 8
  %1352 = load ptr, ptr %84, align 8
  %1353 = getelementptr inbounds i8, ptr %1352, i64 56
  %1354 = load i64, ptr %1353, align 8
  %1355 = inttoptr i64 %1354 to ptr
  %1356 = tail call i64 %1355(ptr noundef %0, double noundef %413, ptr noundef %1350, ptr noundef %1351) #11
  %1357 = icmp eq i64 %1356, 0
  br i1 %1357, label %1364, label %1358

1358:                                             ; preds = %1349
  %1359 = load i64, ptr %336, align 8
  %1360 = add nsw i64 %1359, 1
  store i64 %1360, ptr %336, align 8
  store i64 6, ptr %352, align 8
  %1361 = fmul double %414, 2.500000e-01
  store i64 1, ptr %349, align 8
  %1362 = load i64, ptr %353, align 8
  %1363 = sub nsw i64 1, %1362
  store i64 %1363, ptr %339, align 8
  br label %1898, !llvm.loop !17

1364:                                             ; preds = %1349, %1348
  %1365 = load i64, ptr %335, align 8
  %1366 = add nsw i64 %1365, 1
  store i64 %1366, ptr %335, align 8
  %1367 = load double, ptr %354, align 8
  %1368 = fcmp ogt double %1367, 0.000000e+00
  br i1 %1368, label %1369, label %1378

1369:                                             ; preds = %1364
  %1370 = fdiv double %1367, %1328
  %1371 = tail call double @llvm.pow.f64(double %1370, double 2.500000e-01)
  %1372 = load double, ptr %355, align 8
  %1373 = fdiv double %414, %1372
  %1374 = fmul double %1371, %1373
  %1375 = fcmp olt double %1374, 1.000000e+00
  %1376 = select i1 %1375, double %1374, double 1.000000e+00
  %1377 = fmul double %1329, %1376
  br label %1378

1378:                                             ; preds = %1369, %1364
  %1379 = phi double [ %1377, %1369 ], [ %1329, %1364 ]
  %1380 = fmul double %1326, %1379
  %1381 = fcmp olt double %1380, 1.000000e+01
  store double %413, ptr %188, align 8
  store double %414, ptr %356, align 8
  store double %1328, ptr %354, align 8
  %1382 = load ptr, ptr %76, align 8
  %1383 = getelementptr inbounds i8, ptr %1382, i64 8
  %1384 = load i64, ptr %1383, align 8
  %1385 = load i64, ptr %154, align 8
  %1386 = load ptr, ptr %116, align 8
  %1387 = load ptr, ptr %155, align 8
  %1388 = load ptr, ptr %115, align 8
  br label %1405

1389:                                             ; preds = %1405
  %1390 = select i1 %1381, double %1380, double 1.000000e+01
  %1391 = icmp sgt i64 %1384, 0
  br i1 %1391, label %1392, label %1465

1392:                                             ; preds = %1389
  %1393 = load double, ptr %8, align 16
  %1394 = load double, ptr %156, align 8
  %1395 = getelementptr double, ptr %1386, i64 %1384
  %1396 = load double, ptr %157, align 16
  %1397 = shl i64 %1384, 4
  %1398 = getelementptr i8, ptr %1386, i64 %1397
  %1399 = load double, ptr %9, align 16
  %1400 = load double, ptr %158, align 8
  %1401 = load double, ptr %159, align 16
  %1402 = getelementptr double, ptr %1387, i64 %1385
  %1403 = shl i64 %1385, 4
  %1404 = getelementptr i8, ptr %1387, i64 %1403
  br label %1416

1405:                                             ; preds = %1378, %1405
  %1406 = phi i64 [ 0, %1378 ], [ %1414, %1405 ]
  %1407 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1406
  %1408 = getelementptr inbounds i8, ptr %1407, i64 8
  %1409 = load double, ptr %1408, align 8
  %1410 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1406
  store double %1409, ptr %1410, align 8
  %1411 = getelementptr inbounds i8, ptr %1407, i64 16
  %1412 = load double, ptr %1411, align 8
  %1413 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1406
  store double %1412, ptr %1413, align 8
  %1414 = add nuw nsw i64 %1406, 1
  %1415 = icmp eq i64 %1414, 3
  br i1 %1415, label %1389, label %1405, !llvm.loop !39

1416:                                             ; preds = %1392, %1453
  %1417 = phi i64 [ 0, %1392 ], [ %1454, %1453 ]
  %1418 = getelementptr inbounds double, ptr %1386, i64 %1417
  %1419 = load double, ptr %1418, align 8
  %1420 = fmul double %1393, %1419
  %1421 = getelementptr double, ptr %1395, i64 %1417
  %1422 = load double, ptr %1421, align 8
  %1423 = fmul double %1394, %1422
  %1424 = fadd double %1420, %1423
  %1425 = getelementptr double, ptr %1398, i64 %1417
  %1426 = load double, ptr %1425, align 8
  %1427 = fmul double %1396, %1426
  %1428 = fadd double %1424, %1427
  %1429 = fmul double %1419, %1399
  %1430 = fmul double %1422, %1400
  %1431 = fadd double %1429, %1430
  %1432 = fmul double %1426, %1401
  %1433 = fadd double %1431, %1432
  %1434 = load ptr, ptr %147, align 8
  %1435 = getelementptr inbounds double, ptr %1434, i64 %1417
  %1436 = load double, ptr %1435, align 8
  %1437 = load ptr, ptr %77, align 8
  %1438 = getelementptr inbounds double, ptr %1437, i64 %1417
  %1439 = load double, ptr %1438, align 8
  %1440 = fsub double %1436, %1439
  %1441 = getelementptr inbounds double, ptr %1387, i64 %1417
  store double %1440, ptr %1441, align 8
  %1442 = fneg double %1428
  %1443 = fsub double %1442, %1433
  %1444 = getelementptr double, ptr %1402, i64 %1417
  store double %1443, ptr %1444, align 8
  %1445 = fneg double %1433
  %1446 = getelementptr double, ptr %1404, i64 %1417
  store double %1445, ptr %1446, align 8
  %1447 = load ptr, ptr %77, align 8
  %1448 = getelementptr inbounds double, ptr %1447, i64 %1417
  %1449 = load double, ptr %1448, align 8
  %1450 = getelementptr inbounds double, ptr %1388, i64 %1417
  store double %1449, ptr %1450, align 8
  %1451 = getelementptr double, ptr %1387, i64 %1417
  %1452 = getelementptr double, ptr %1388, i64 %1417
  br label %1456

1453:                                             ; preds = %1456
  %1454 = add nuw nsw i64 %1417, 1
  %1455 = icmp eq i64 %1454, %1384
  br i1 %1455, label %1465, label %1416, !llvm.loop !40

1456:                                             ; preds = %1416, %1456
  %1457 = phi i64 [ 0, %1416 ], [ %1461, %1456 ]
  %1458 = mul nsw i64 %1385, %1457
  %1459 = getelementptr double, ptr %1451, i64 %1458
  %1460 = load double, ptr %1459, align 8
  %1461 = add nuw nsw i64 %1457, 1
  %1462 = mul nuw nsw i64 %1384, %1461
  %1463 = getelementptr double, ptr %1452, i64 %1462
  store double %1460, ptr %1463, align 8
  %1464 = icmp eq i64 %1461, 3
  br i1 %1464, label %1453, label %1456, !llvm.loop !41

1465:                                             ; preds = %1453, %1389
  store double %414, ptr %344, align 8
  %1466 = load ptr, ptr %0, align 8
  %1467 = getelementptr inbounds i8, ptr %1466, i64 24
  %1468 = load i64, ptr %1467, align 8
  %1469 = load ptr, ptr %93, align 8
  %1470 = getelementptr inbounds i8, ptr %1469, i64 8
  %1471 = load i64, ptr %1470, align 8
  %1472 = icmp eq i64 %1471, 0
  br i1 %1472, label %1519, label %1473

1473:                                             ; preds = %1465
  %1474 = load i64, ptr %1469, align 8
  %1475 = load ptr, ptr %76, align 8
  %1476 = getelementptr inbounds i8, ptr %1475, i64 8
  %1477 = load i64, ptr %1476, align 8
  %1478 = load ptr, ptr %160, align 8
  %1479 = load i64, ptr %161, align 8
  %1480 = mul nsw i64 %1479, %1474
  %1481 = getelementptr inbounds double, ptr %1478, i64 %1480
  %1482 = getelementptr inbounds double, ptr %1481, i64 %1479
  store double %378, ptr %1481, align 8
  %1483 = getelementptr inbounds i8, ptr %1481, i64 8
  store double %414, ptr %1483, align 8
  store double %413, ptr %1482, align 8
  %1484 = getelementptr inbounds i8, ptr %1482, i64 8
  store double 0.000000e+00, ptr %1484, align 8
  %1485 = icmp sgt i64 %1477, 0
  br i1 %1485, label %1486, label %1489

1486:                                             ; preds = %1473
  %1487 = getelementptr i8, ptr %1481, i64 16
  %1488 = icmp sgt i64 %1468, 0
  br label %1492

1489:                                             ; preds = %1504, %1473
  %1490 = add nsw i64 %1474, 1
  %1491 = load ptr, ptr %93, align 8
  store i64 %1490, ptr %1491, align 8
  br label %1519

1492:                                             ; preds = %1486, %1504
  %1493 = phi i64 [ 0, %1486 ], [ %1505, %1504 ]
  %1494 = load ptr, ptr %77, align 8
  %1495 = getelementptr inbounds double, ptr %1494, i64 %1493
  %1496 = load double, ptr %1495, align 8
  %1497 = add nuw nsw i64 %1493, 2
  %1498 = getelementptr inbounds double, ptr %1481, i64 %1497
  store double %1496, ptr %1498, align 8
  %1499 = load ptr, ptr %147, align 8
  %1500 = getelementptr inbounds double, ptr %1499, i64 %1493
  %1501 = load double, ptr %1500, align 8
  %1502 = getelementptr inbounds double, ptr %1482, i64 %1497
  store double %1501, ptr %1502, align 8
  %1503 = getelementptr double, ptr %1487, i64 %1493
  br i1 %1488, label %1507, label %1504

1504:                                             ; preds = %1507, %1492
  %1505 = add nuw nsw i64 %1493, 1
  %1506 = icmp eq i64 %1505, %1477
  br i1 %1506, label %1489, label %1492, !llvm.loop !42

1507:                                             ; preds = %1492, %1507
  %1508 = phi i64 [ %1515, %1507 ], [ 0, %1492 ]
  %1509 = load ptr, ptr %155, align 8
  %1510 = load i64, ptr %154, align 8
  %1511 = mul nsw i64 %1510, %1508
  %1512 = getelementptr double, ptr %1509, i64 %1511
  %1513 = getelementptr double, ptr %1512, i64 %1493
  %1514 = load double, ptr %1513, align 8
  %1515 = add nuw nsw i64 %1508, 1
  %1516 = mul nuw nsw i64 %1515, %1477
  %1517 = getelementptr double, ptr %1503, i64 %1516
  store double %1514, ptr %1517, align 8
  %1518 = icmp eq i64 %1515, %1468
  br i1 %1518, label %1504, label %1507, !llvm.loop !43

1519:                                             ; preds = %1465, %1489
  br i1 %210, label %1520, label %1627

1520:                                             ; preds = %1519
  %1521 = load ptr, ptr %85, align 8
  %1522 = load ptr, ptr %76, align 8
  %1523 = getelementptr inbounds i8, ptr %1522, i64 8
  %1524 = load i64, ptr %1523, align 8
  %1525 = load ptr, ptr %162, align 8
  %1526 = getelementptr inbounds i8, ptr %1521, i64 32
  %1527 = load i64, ptr %1526, align 8
  %1528 = getelementptr inbounds double, ptr %1525, i64 %1527
  %1529 = load ptr, ptr %116, align 8
  %1530 = getelementptr inbounds i8, ptr %1521, i64 24
  %1531 = load i64, ptr %1530, align 8
  %1532 = icmp eq i64 %1531, 0
  br i1 %1532, label %1624, label %1533

1533:                                             ; preds = %1520
  %1534 = getelementptr inbounds i8, ptr %1521, i64 40
  %1535 = load i64, ptr %1534, align 8
  %1536 = icmp sgt i64 %1535, 0
  br i1 %1536, label %1537, label %1541

1537:                                             ; preds = %1533
  %1538 = getelementptr double, ptr %1529, i64 %1524
  %1539 = shl i64 %1524, 4
  %1540 = getelementptr i8, ptr %1529, i64 %1539
  br label %1594

1541:                                             ; preds = %1594, %1533
  %1542 = load ptr, ptr %163, align 8
  %1543 = load ptr, ptr %85, align 8
  %1544 = getelementptr inbounds i8, ptr %1543, i64 8
  %1545 = load i64, ptr %1544, align 8
  %1546 = load ptr, ptr %164, align 8
  %1547 = load ptr, ptr %162, align 8
  %1548 = getelementptr inbounds i8, ptr %1543, i64 32
  %1549 = load i64, ptr %1548, align 8
  %1550 = getelementptr inbounds i8, ptr %1543, i64 40
  %1551 = load i64, ptr %1550, align 8
  %1552 = getelementptr double, ptr %1547, i64 %1549
  %1553 = getelementptr double, ptr %1552, i64 %1551
  store double %414, ptr %1553, align 8
  %1554 = load ptr, ptr %163, align 8
  store double %378, ptr %1554, align 8
  %1555 = load ptr, ptr %85, align 8
  %1556 = getelementptr inbounds i8, ptr %1555, i64 24
  %1557 = load i64, ptr %1556, align 8
  %1558 = load ptr, ptr %77, align 8
  %1559 = load ptr, ptr %162, align 8
  %1560 = load ptr, ptr %165, align 8
  %1561 = inttoptr i64 %1557 to ptr
  %1562 = tail call i32 %1561(ptr noundef %1542, ptr noundef %1558, ptr noundef %1559, ptr noundef %1560, ptr noundef %1546) #11
  %1563 = icmp eq i32 %1562, 0
  br i1 %1563, label %1564, label %1624

1564:                                             ; preds = %1541
  %1565 = icmp slt i64 %1545, 1
  br i1 %1565, label %1591, label %1566

1566:                                             ; preds = %1564
  %1567 = load ptr, ptr %166, align 8
  %1568 = getelementptr double, ptr %1546, i64 %1545
  br label %1569

1569:                                             ; preds = %1566, %1587
  %1570 = phi i1 [ %1565, %1566 ], [ %1589, %1587 ]
  %1571 = phi i64 [ 0, %1566 ], [ %1588, %1587 ]
  %1572 = getelementptr inbounds i64, ptr %1567, i64 %1571
  %1573 = load i64, ptr %1572, align 8
  %1574 = and i64 %1573, 2
  %1575 = icmp eq i64 %1574, 0
  br i1 %1575, label %1576, label %1587

1576:                                             ; preds = %1569
  %1577 = getelementptr inbounds double, ptr %1546, i64 %1571
  %1578 = load double, ptr %1577, align 8
  %1579 = load ptr, ptr %167, align 8
  %1580 = getelementptr inbounds i64, ptr %1579, i64 %1571
  %1581 = load i64, ptr %1580, align 8
  %1582 = sitofp i64 %1581 to double
  %1583 = fmul double %1578, %1582
  %1584 = getelementptr double, ptr %1568, i64 %1571
  %1585 = load double, ptr %1584, align 8
  %1586 = fcmp ogt double %1583, %1585
  br i1 %1586, label %1587, label %1591

1587:                                             ; preds = %1576, %1569
  %1588 = add nuw nsw i64 %1571, 1
  %1589 = icmp sge i64 %1588, %1545
  %1590 = icmp eq i64 %1588, %1545
  br i1 %1590, label %1591, label %1569, !llvm.loop !44

1591:                                             ; preds = %1587, %1576, %1564
  %1592 = phi i1 [ %1565, %1564 ], [ %1589, %1587 ], [ %1570, %1576 ]
  %1593 = zext i1 %1592 to i32
  br label %1624

1594:                                             ; preds = %1537, %1594
  %1595 = phi i64 [ 0, %1537 ], [ %1621, %1594 ]
  %1596 = load ptr, ptr %147, align 8
  %1597 = getelementptr inbounds double, ptr %1596, i64 %1595
  %1598 = load double, ptr %1597, align 8
  %1599 = load ptr, ptr %77, align 8
  %1600 = getelementptr inbounds double, ptr %1599, i64 %1595
  %1601 = load double, ptr %1600, align 8
  %1602 = fsub double %1598, %1601
  %1603 = tail call double @llvm.fabs.f64(double %1602)
  %1604 = getelementptr inbounds double, ptr %1529, i64 %1595
  %1605 = load double, ptr %1604, align 8
  %1606 = tail call double @llvm.fabs.f64(double %1605)
  %1607 = getelementptr double, ptr %1538, i64 %1595
  %1608 = load double, ptr %1607, align 8
  %1609 = tail call double @llvm.fabs.f64(double %1608)
  %1610 = fcmp ogt double %1606, %1609
  %1611 = select i1 %1610, double %1606, double %1609
  %1612 = getelementptr double, ptr %1540, i64 %1595
  %1613 = load double, ptr %1612, align 8
  %1614 = tail call double @llvm.fabs.f64(double %1613)
  %1615 = fcmp ogt double %1611, %1614
  %1616 = select i1 %1615, double %1611, double %1614
  %1617 = fcmp ogt double %1616, %1603
  %1618 = select i1 %1617, double %1616, double %1603
  %1619 = fmul double %1618, 8.000000e+00
  %1620 = getelementptr inbounds double, ptr %1528, i64 %1595
  store double %1619, ptr %1620, align 8
  %1621 = add nuw nsw i64 %1595, 1
  %1622 = load i64, ptr %1534, align 8
  %1623 = icmp slt i64 %1621, %1622
  br i1 %1623, label %1594, label %1541, !llvm.loop !45

1624:                                             ; preds = %1591, %1541, %1520
  %1625 = phi i32 [ 0, %1520 ], [ 0, %1541 ], [ %1593, %1591 ]
  %1626 = icmp eq i32 %1625, 0
  br label %1627

1627:                                             ; preds = %1624, %1519
  %1628 = phi i1 [ false, %1519 ], [ %1626, %1624 ]
  br i1 %1628, label %1634, label %1629

1629:                                             ; preds = %1627
  %1630 = load i64, ptr %357, align 8
  %1631 = getelementptr inbounds double, ptr %199, i64 %1630
  %1632 = load double, ptr %1631, align 8
  %1633 = fcmp ugt double %1632, %413
  br i1 %1633, label %1846, label %1634

1634:                                             ; preds = %1629, %1627
  %1635 = load ptr, ptr %79, align 8
  br i1 %1628, label %1636, label %1647

1636:                                             ; preds = %1634
  %1637 = load ptr, ptr %85, align 8
  %1638 = getelementptr inbounds i8, ptr %1637, i64 16
  %1639 = load i64, ptr %1638, align 8
  %1640 = inttoptr i64 %1639 to ptr
  %1641 = tail call i64 %1640(ptr noundef %0, double noundef %378, double noundef %414) #11
  %1642 = icmp eq i64 %1641, -6
  br i1 %1642, label %1643, label %1644

1643:                                             ; preds = %1636
  store double %378, ptr %1635, align 8
  br label %1822

1644:                                             ; preds = %1636
  %1645 = getelementptr inbounds i8, ptr %1635, i64 48
  %1646 = load double, ptr %1645, align 8
  br label %1647

1647:                                             ; preds = %1644, %1634
  %1648 = phi double [ %1646, %1644 ], [ 1.000000e+00, %1634 ]
  %1649 = phi i64 [ %1641, %1644 ], [ 0, %1634 ]
  %1650 = fcmp oeq double %1648, 1.000000e+00
  br i1 %1650, label %1651, label %1653

1651:                                             ; preds = %1647
  %1652 = load double, ptr %1635, align 8
  br label %1656

1653:                                             ; preds = %1647
  %1654 = fmul double %414, %1648
  %1655 = fadd double %378, %1654
  br label %1656

1656:                                             ; preds = %1653, %1651
  %1657 = phi double [ %1652, %1651 ], [ %1655, %1653 ]
  %1658 = icmp eq i64 %1649, -4
  %1659 = select i1 %1658, i64 -4, i64 0
  br i1 %1658, label %1717, label %1660

1660:                                             ; preds = %1656
  %1661 = fcmp olt double %1648, 1.000000e+00
  %1662 = load ptr, ptr %76, align 8
  %1663 = getelementptr inbounds i8, ptr %1662, i64 8
  %1664 = load i64, ptr %1663, align 8
  %1665 = load i64, ptr %83, align 8
  %1666 = load ptr, ptr %82, align 8
  %1667 = load ptr, ptr %81, align 8
  %1668 = getelementptr inbounds i8, ptr %1667, i64 48
  %1669 = load i64, ptr %1668, align 8
  %1670 = icmp slt i64 %1669, %1665
  br i1 %1670, label %1671, label %1713

1671:                                             ; preds = %1660, %1709
  %1672 = phi i64 [ %1710, %1709 ], [ undef, %1660 ]
  %1673 = phi i64 [ %1711, %1709 ], [ %1669, %1660 ]
  %1674 = getelementptr inbounds double, ptr %1666, i64 %1673
  %1675 = load double, ptr %1674, align 8
  %1676 = fcmp olt double %1675, %1657
  %1677 = fcmp oeq double %1675, %1657
  %1678 = and i1 %1661, %1677
  %1679 = or i1 %1676, %1678
  br i1 %1679, label %1680, label %1713

1680:                                             ; preds = %1671
  %1681 = fsub double %1675, %378
  %1682 = fdiv double %1681, %414
  %1683 = mul nsw i64 %1673, %1664
  %1684 = getelementptr inbounds double, ptr %1, i64 %1683
  %1685 = load ptr, ptr %168, align 8
  %1686 = insertelement <8 x double> poison, double %1682, i64 0
  %1687 = shufflevector <8 x double> %1686, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1687, ptr %1685, align 8
  %1688 = load ptr, ptr %77, align 8
  %1689 = load ptr, ptr %169, align 8
  %1690 = load i64, ptr %170, align 8
  %1691 = load ptr, ptr %0, align 8
  %1692 = getelementptr inbounds i8, ptr %1691, i64 24
  %1693 = load i64, ptr %1692, align 8
  %1694 = load ptr, ptr %168, align 8
  %1695 = load ptr, ptr %76, align 8
  %1696 = getelementptr inbounds i8, ptr %1695, i64 16
  %1697 = load i64, ptr %1696, align 8
  tail call fastcc void @nested(ptr noundef %1684, ptr noundef %1688, ptr noundef %1689, i64 noundef %1690, i64 noundef %1693, ptr noundef %1694, i64 noundef %1697) #10
  %1698 = load ptr, ptr %84, align 8
  %1699 = load i64, ptr %1698, align 8
  %1700 = icmp eq i64 %1699, 1
  br i1 %1700, label %1701, label %1709

1701:                                             ; preds = %1680
  %1702 = load double, ptr %1674, align 8
  %1703 = getelementptr inbounds i8, ptr %1698, i64 56
  %1704 = load i64, ptr %1703, align 8
  %1705 = inttoptr i64 %1704 to ptr
  %1706 = tail call i64 %1705(ptr noundef %0, double noundef %1702, ptr noundef %1684, ptr noundef null) #11
  %1707 = icmp eq i64 %1706, 0
  %1708 = select i1 %1707, i64 %1672, i64 %1706
  br i1 %1707, label %1709, label %1717

1709:                                             ; preds = %1701, %1680
  %1710 = phi i64 [ %1708, %1701 ], [ %1672, %1680 ]
  %1711 = add i64 %1673, 1
  %1712 = icmp eq i64 %1711, %1665
  br i1 %1712, label %1713, label %1671, !llvm.loop !46

1713:                                             ; preds = %1709, %1671, %1660
  %1714 = phi i64 [ %1669, %1660 ], [ %1665, %1709 ], [ %1673, %1671 ]
  %1715 = load ptr, ptr %81, align 8
  %1716 = getelementptr inbounds i8, ptr %1715, i64 48
  store i64 %1714, ptr %1716, align 8
  br label %1717

1717:                                             ; preds = %1701, %1713, %1656
  %1718 = phi i64 [ %1659, %1656 ], [ 0, %1713 ], [ %1708, %1701 ]
  %1719 = icmp eq i64 %1718, 0
  %1720 = icmp ne i64 %1649, 0
  %1721 = fcmp olt double %1648, 1.000000e+00
  %1722 = and i1 %1721, %1719
  %1723 = and i1 %1720, %1722
  br i1 %1723, label %1724, label %1761

1724:                                             ; preds = %1717
  %1725 = load ptr, ptr %171, align 8
  %1726 = load ptr, ptr %172, align 8
  %1727 = insertelement <8 x double> poison, double %1648, i64 0
  %1728 = shufflevector <8 x double> %1727, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1728, ptr %1726, align 8
  %1729 = load ptr, ptr %77, align 8
  %1730 = load ptr, ptr %173, align 8
  %1731 = load i64, ptr %174, align 8
  %1732 = load ptr, ptr %0, align 8
  %1733 = getelementptr inbounds i8, ptr %1732, i64 24
  %1734 = load i64, ptr %1733, align 8
  %1735 = load ptr, ptr %172, align 8
  %1736 = load ptr, ptr %76, align 8
  %1737 = getelementptr inbounds i8, ptr %1736, i64 16
  %1738 = load i64, ptr %1737, align 8
  tail call fastcc void @nested(ptr noundef %1725, ptr noundef %1729, ptr noundef %1730, i64 noundef %1731, i64 noundef %1734, ptr noundef %1735, i64 noundef %1738) #10
  %1739 = load i64, ptr %154, align 8
  %1740 = icmp sgt i64 %1739, 0
  br i1 %1740, label %1745, label %1741

1741:                                             ; preds = %1745, %1724
  %1742 = load ptr, ptr %84, align 8
  %1743 = load i64, ptr %1742, align 8
  %1744 = icmp eq i64 %1743, 1
  br i1 %1744, label %1755, label %1761

1745:                                             ; preds = %1724, %1745
  %1746 = phi i64 [ %1752, %1745 ], [ 0, %1724 ]
  %1747 = load ptr, ptr %171, align 8
  %1748 = getelementptr inbounds double, ptr %1747, i64 %1746
  %1749 = load double, ptr %1748, align 8
  %1750 = load ptr, ptr %147, align 8
  %1751 = getelementptr inbounds double, ptr %1750, i64 %1746
  store double %1749, ptr %1751, align 8
  %1752 = add nuw nsw i64 %1746, 1
  %1753 = load i64, ptr %154, align 8
  %1754 = icmp slt i64 %1752, %1753
  br i1 %1754, label %1745, label %1741, !llvm.loop !47

1755:                                             ; preds = %1741
  %1756 = load ptr, ptr %147, align 8
  %1757 = getelementptr inbounds i8, ptr %1742, i64 56
  %1758 = load i64, ptr %1757, align 8
  %1759 = inttoptr i64 %1758 to ptr
  %1760 = tail call i64 %1759(ptr noundef %0, double noundef %1657, ptr noundef %1756, ptr noundef null) #11
  br label %1761

1761:                                             ; preds = %1755, %1741, %1717
  %1762 = phi i64 [ %1760, %1755 ], [ 0, %1741 ], [ %1718, %1717 ]
  %1763 = icmp eq i64 %1762, 0
  br i1 %1763, label %1766, label %1764

1764:                                             ; preds = %1761
  store double %378, ptr %1635, align 8
  %1765 = getelementptr inbounds i8, ptr %1635, i64 8
  store double %414, ptr %1765, align 8
  br label %1822

1766:                                             ; preds = %1761
  br i1 %1650, label %1767, label %1805

1767:                                             ; preds = %1766
  %1768 = load ptr, ptr %147, align 8
  %1769 = load ptr, ptr %76, align 8
  %1770 = getelementptr inbounds i8, ptr %1769, i64 8
  %1771 = load i64, ptr %1770, align 8
  %1772 = load i64, ptr %83, align 8
  %1773 = load ptr, ptr %82, align 8
  %1774 = load ptr, ptr %81, align 8
  %1775 = getelementptr inbounds i8, ptr %1774, i64 48
  %1776 = load i64, ptr %1775, align 8
  %1777 = icmp slt i64 %1776, %1772
  br i1 %1777, label %1778, label %1801

1778:                                             ; preds = %1767
  %1779 = icmp sgt i64 %1771, 0
  br label %1780

1780:                                             ; preds = %1778, %1791
  %1781 = phi i64 [ %1776, %1778 ], [ %1792, %1791 ]
  %1782 = getelementptr inbounds double, ptr %1773, i64 %1781
  %1783 = load double, ptr %1782, align 8
  %1784 = load ptr, ptr %79, align 8
  %1785 = load double, ptr %1784, align 8
  %1786 = fcmp ugt double %1783, %1785
  br i1 %1786, label %1801, label %1787

1787:                                             ; preds = %1780
  br i1 %1779, label %1788, label %1791

1788:                                             ; preds = %1787
  %1789 = mul nsw i64 %1781, %1771
  %1790 = getelementptr double, ptr %1, i64 %1789
  br label %1794

1791:                                             ; preds = %1794, %1787
  %1792 = add i64 %1781, 1
  %1793 = icmp eq i64 %1792, %1772
  br i1 %1793, label %1801, label %1780, !llvm.loop !9

1794:                                             ; preds = %1788, %1794
  %1795 = phi i64 [ 0, %1788 ], [ %1799, %1794 ]
  %1796 = getelementptr inbounds double, ptr %1768, i64 %1795
  %1797 = load double, ptr %1796, align 8
  %1798 = getelementptr double, ptr %1790, i64 %1795
  store double %1797, ptr %1798, align 8
  %1799 = add nuw nsw i64 %1795, 1
  %1800 = icmp eq i64 %1799, %1771
  br i1 %1800, label %1791, label %1794, !llvm.loop !10

1801:                                             ; preds = %1791, %1780, %1767
  %1802 = phi i64 [ %1776, %1767 ], [ %1772, %1791 ], [ %1781, %1780 ]
  %1803 = load ptr, ptr %81, align 8
  %1804 = getelementptr inbounds i8, ptr %1803, i64 48
  store i64 %1802, ptr %1804, align 8
  br label %1805

1805:                                             ; preds = %1801, %1766
  br i1 %1720, label %1806, label %1822

1806:                                             ; preds = %1805
  %1807 = load i64, ptr %154, align 8
  %1808 = icmp sgt i64 %1807, 0
  br i1 %1808, label %1812, label %1809

1809:                                             ; preds = %1812, %1806
  store double %1657, ptr %1635, align 8
  %1810 = getelementptr inbounds i8, ptr %1635, i64 8
  store double 0.000000e+00, ptr %1810, align 8
  %1811 = load ptr, ptr %81, align 8
  store i64 0, ptr %1811, align 8
  br label %1822

1812:                                             ; preds = %1806, %1812
  %1813 = phi i64 [ %1819, %1812 ], [ 0, %1806 ]
  %1814 = load ptr, ptr %147, align 8
  %1815 = getelementptr inbounds double, ptr %1814, i64 %1813
  %1816 = load double, ptr %1815, align 8
  %1817 = load ptr, ptr %77, align 8
  %1818 = getelementptr inbounds double, ptr %1817, i64 %1813
  store double %1816, ptr %1818, align 8
  %1819 = add nuw nsw i64 %1813, 1
  %1820 = load i64, ptr %154, align 8
  %1821 = icmp slt i64 %1819, %1820
  br i1 %1821, label %1812, label %1809, !llvm.loop !48

1822:                                             ; preds = %1643, %1764, %1805, %1809
  %1823 = phi i64 [ -6, %1643 ], [ %1762, %1764 ], [ %1649, %1809 ], [ %1649, %1805 ]
  %1824 = icmp eq i64 %1823, -6
  br i1 %1824, label %1828, label %1825

1825:                                             ; preds = %1822
  %1826 = icmp ne i64 %1823, 6
  %1827 = select i1 %1826, i1 true, i1 %210
  br i1 %1827, label %1840, label %1828

1828:                                             ; preds = %1825, %1822
  %1829 = phi i64 [ %1823, %1825 ], [ 2, %1822 ]
  %1830 = load i64, ptr %335, align 8
  %1831 = add nsw i64 %1830, -1
  store i64 %1831, ptr %335, align 8
  %1832 = load ptr, ptr %93, align 8
  %1833 = load i64, ptr %1832, align 8
  %1834 = add nsw i64 %1833, -1
  store i64 %1834, ptr %1832, align 8
  store i64 1, ptr %349, align 8
  %1835 = load i64, ptr %363, align 8
  %1836 = sub nsw i64 1, %1835
  store i64 %1836, ptr %339, align 8
  store double 0.000000e+00, ptr %344, align 8
  %1837 = load i64, ptr %336, align 8
  %1838 = add nsw i64 %1837, 1
  store i64 %1838, ptr %336, align 8
  store i64 %1829, ptr %364, align 8
  %1839 = fmul double %414, 2.500000e-01
  br label %1898, !llvm.loop !17

1840:                                             ; preds = %1825
  %1841 = icmp eq i64 %1823, 0
  br i1 %1841, label %1846, label %1842

1842:                                             ; preds = %1840
  %1843 = load ptr, ptr %93, align 8
  %1844 = load i64, ptr %1843, align 8
  %1845 = add nsw i64 %1844, 1
  store i64 %1845, ptr %1843, align 8
  br label %1898

1846:                                             ; preds = %1840, %1629
  br i1 %358, label %1865, label %1847

1847:                                             ; preds = %1865, %1846
  %1848 = load i64, ptr %359, align 8
  %1849 = add nsw i64 %1848, 1
  store i64 %1849, ptr %359, align 8
  %1850 = load ptr, ptr %77, align 8
  %1851 = load ptr, ptr %175, align 8
  %1852 = load ptr, ptr %176, align 8
  store double %413, ptr %1852, align 8
  %1853 = load i64, ptr %177, align 8
  %1854 = icmp sgt i64 %1853, 0
  br i1 %1854, label %1855, label %1856

1855:                                             ; preds = %1847
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1856

1856:                                             ; preds = %1847, %1855
  %1857 = load ptr, ptr %76, align 8
  %1858 = load i64, ptr %1857, align 8
  %1859 = load ptr, ptr %176, align 8
  %1860 = load ptr, ptr %178, align 8
  %1861 = load ptr, ptr %179, align 8
  %1862 = inttoptr i64 %1858 to ptr
  %1863 = tail call i32 %1862(ptr noundef %1859, ptr noundef %1850, ptr noundef %1860, ptr noundef %1861, ptr noundef %1851) #11
  %1864 = icmp eq i32 %1863, 0
  br i1 %1864, label %1877, label %1874

1865:                                             ; preds = %1846, %1865
  %1866 = phi i64 [ %1872, %1865 ], [ 0, %1846 ]
  %1867 = load ptr, ptr %147, align 8
  %1868 = getelementptr inbounds double, ptr %1867, i64 %1866
  %1869 = load double, ptr %1868, align 8
  %1870 = load ptr, ptr %77, align 8
  %1871 = getelementptr inbounds double, ptr %1870, i64 %1866
  store double %1869, ptr %1871, align 8
  %1872 = add nuw nsw i64 %1866, 1
  %1873 = icmp eq i64 %1872, %198
  br i1 %1873, label %1847, label %1865, !llvm.loop !49

1874:                                             ; preds = %1856
  store i64 3, ptr %360, align 8
  store double %414, ptr %225, align 8
  %1875 = icmp slt i32 %1863, 0
  %1876 = select i1 %1875, i64 -4, i64 2
  br label %1898

1877:                                             ; preds = %1856
  %1878 = icmp sgt i64 %1152, 2
  %1879 = fcmp ogt double %1150, 1.000000e-03
  %1880 = select i1 %1878, i1 %1879, i1 false
  %1881 = zext i1 %1880 to i64
  store i64 %1881, ptr %339, align 8
  store i64 0, ptr %361, align 8
  store i64 0, ptr %349, align 8
  %1882 = fcmp ule double %1390, 1.000000e+00
  %1883 = fcmp uge double %1390, 1.200000e+00
  %1884 = or i1 %1882, %1883
  %1885 = select i1 %1884, i1 true, i1 %1880
  br i1 %1885, label %1888, label %1886

1886:                                             ; preds = %1877
  %1887 = load double, ptr %189, align 8
  br label %1892

1888:                                             ; preds = %1877
  %1889 = fcmp ogt double %1390, 2.000000e-01
  %1890 = select i1 %1889, double %1390, double 2.000000e-01
  %1891 = fmul double %414, %1890
  br label %1892

1892:                                             ; preds = %1888, %1886
  %1893 = phi double [ %1887, %1886 ], [ %1891, %1888 ]
  %1894 = load i64, ptr %362, align 8
  %1895 = load i64, ptr %83, align 8
  %1896 = icmp eq i64 %1894, %1895
  br i1 %1896, label %1897, label %1898

1897:                                             ; preds = %1892
  store double %1893, ptr %225, align 8
  br label %1898

1898:                                             ; preds = %1149, %1192, %1204, %1897, %1892, %1874, %1842, %1828, %1358, %1343, %1305, %608, %539, %420
  %1899 = phi double [ %383, %420 ], [ %383, %539 ], [ %383, %608 ], [ %1150, %1305 ], [ %1150, %1343 ], [ %1150, %1358 ], [ %1150, %1828 ], [ %1150, %1842 ], [ %1150, %1874 ], [ %1150, %1892 ], [ %1150, %1897 ], [ %1150, %1204 ], [ %1150, %1192 ], [ %1150, %1149 ]
  %1900 = phi i32 [ %382, %420 ], [ %382, %539 ], [ %382, %608 ], [ %1151, %1305 ], [ %1151, %1343 ], [ %1151, %1358 ], [ %1151, %1828 ], [ %1151, %1842 ], [ %1151, %1874 ], [ %1151, %1892 ], [ %1151, %1897 ], [ %1151, %1204 ], [ %1151, %1192 ], [ %1151, %1149 ]
  %1901 = phi i64 [ %381, %420 ], [ %381, %539 ], [ %381, %608 ], [ %1152, %1305 ], [ %1152, %1343 ], [ %1152, %1358 ], [ %1152, %1828 ], [ %1152, %1842 ], [ %1152, %1874 ], [ %1152, %1892 ], [ %1152, %1897 ], [ %1152, %1204 ], [ %1152, %1192 ], [ %1152, %1149 ]
  %1902 = phi i64 [ %380, %420 ], [ %380, %539 ], [ %380, %608 ], [ %1153, %1305 ], [ %1153, %1343 ], [ %1153, %1358 ], [ %1153, %1828 ], [ %1153, %1842 ], [ %1153, %1874 ], [ %1153, %1892 ], [ %1153, %1897 ], [ %1153, %1204 ], [ %1153, %1192 ], [ %1153, %1149 ]
  %1903 = phi double [ %379, %420 ], [ %379, %539 ], [ %611, %608 ], [ %379, %1305 ], [ %1345, %1343 ], [ %1361, %1358 ], [ %1839, %1828 ], [ %379, %1842 ], [ %379, %1874 ], [ %1893, %1892 ], [ %1893, %1897 ], [ %1205, %1204 ], [ %379, %1192 ], [ %379, %1149 ]
  %1904 = phi double [ %378, %420 ], [ %378, %539 ], [ %378, %608 ], [ %378, %1305 ], [ %378, %1343 ], [ %378, %1358 ], [ %378, %1828 ], [ %378, %1842 ], [ %413, %1874 ], [ %413, %1892 ], [ %413, %1897 ], [ %378, %1204 ], [ %378, %1192 ], [ %378, %1149 ]
  %1905 = phi i32 [ 1, %420 ], [ 1, %539 ], [ 6, %608 ], [ 1, %1305 ], [ 6, %1343 ], [ 6, %1358 ], [ 6, %1828 ], [ 1, %1842 ], [ 1, %1874 ], [ 0, %1892 ], [ 1, %1897 ], [ 6, %1204 ], [ 6, %1192 ], [ 1, %1149 ]
  %1906 = phi i64 [ 2, %420 ], [ -4, %539 ], [ %377, %608 ], [ -4, %1305 ], [ %377, %1343 ], [ %377, %1358 ], [ %377, %1828 ], [ %1823, %1842 ], [ %1876, %1874 ], [ %377, %1892 ], [ 0, %1897 ], [ %377, %1204 ], [ %377, %1192 ], [ -4, %1149 ]
  switch i32 %1905, label %1910 [
    i32 0, label %1907
    i32 6, label %1907
  ]

1907:                                             ; preds = %1898, %1898
  %1908 = load i64, ptr %192, align 8
  %1909 = icmp eq i64 %1908, 0
  br i1 %1909, label %369, label %375, !llvm.loop !17

1910:                                             ; preds = %1898, %183, %257, %299, %369, %396, %404
  %1911 = phi double [ %184, %183 ], [ %370, %369 ], [ %383, %404 ], [ %383, %396 ], [ %184, %299 ], [ %184, %257 ], [ %1899, %1898 ]
  %1912 = phi i32 [ %185, %183 ], [ %371, %369 ], [ %382, %404 ], [ %382, %396 ], [ %185, %299 ], [ %185, %257 ], [ %1900, %1898 ]
  %1913 = phi i64 [ %186, %183 ], [ %372, %369 ], [ %381, %404 ], [ %381, %396 ], [ %186, %299 ], [ %186, %257 ], [ %1901, %1898 ]
  %1914 = phi i64 [ %187, %183 ], [ %373, %369 ], [ %380, %404 ], [ %380, %396 ], [ %187, %299 ], [ %187, %257 ], [ %1902, %1898 ]
  %1915 = phi i64 [ -1, %183 ], [ -1, %369 ], [ 1, %404 ], [ -5, %396 ], [ 0, %299 ], [ %260, %257 ], [ %1906, %1898 ]
  %1916 = load ptr, ptr %182, align 8
  %1917 = getelementptr inbounds i8, ptr %1916, i64 48
  %1918 = load i64, ptr %1917, align 8
  %1919 = icmp ne i64 %1915, -2
  %1920 = icmp eq i64 %1918, 0
  %1921 = select i1 %1919, i1 true, i1 %1920
  br i1 %1921, label %1929, label %1922

1922:                                             ; preds = %1910
  %1923 = inttoptr i64 %1918 to ptr
  %1924 = tail call i64 %1923(ptr noundef %0) #11
  %1925 = icmp eq i64 %1924, 8
  %1926 = select i1 %1925, i64 8, i64 %1915
  %1927 = icmp eq i64 %1924, 1
  %1928 = zext i1 %1927 to i32
  br label %1929

1929:                                             ; preds = %1910, %1922
  %1930 = phi i64 [ %1915, %1910 ], [ %1926, %1922 ]
  %1931 = phi i32 [ 0, %1910 ], [ %1928, %1922 ]
  %1932 = icmp eq i32 %1931, 0
  br i1 %1932, label %1933, label %183, !llvm.loop !50

1933:                                             ; preds = %1929
  ret i64 %1930
}



declare double @llvm.sqrt.f64(double) #2

declare double @llvm.fabs.f64(double) #2

declare double @llvm.pow.f64(double, double) #2

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
  br i1 %55, label %44, label %56, !llvm.loop !51

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
  br i1 %83, label %13, label %12, !llvm.loop !52
}

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #4 {
  %6 = icmp sgt i64 %4, 0
  br i1 %6, label %7, label %13

7:                                                ; preds = %5
  %8 = load ptr, ptr %3, align 8
  %9 = getelementptr inbounds i8, ptr %3, i64 240
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %3, i64 216
  %12 = load ptr, ptr %11, align 8
  br label %18

13:                                               ; preds = %18, %5
  %14 = phi double [ 0.000000e+00, %5 ], [ %39, %18 ]
  %15 = sitofp i64 %4 to double
  %16 = fdiv double %14, %15
  %17 = tail call double @llvm.sqrt.f64(double %16)
  store double %17, ptr %0, align 8
  ret void

18:                                               ; preds = %7, %18
  %19 = phi double [ 0.000000e+00, %7 ], [ %39, %18 ]
  %20 = phi i64 [ 0, %7 ], [ %40, %18 ]
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %8, i64 %20
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %2, i64 %20
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %10, i64 %20
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %12, i64 %20
  %30 = load double, ptr %29, align 8
  %31 = tail call double @llvm.fabs.f64(double %24)
  %32 = tail call double @llvm.fabs.f64(double %26)
  %33 = fcmp ogt double %31, %32
  %34 = select i1 %33, double %31, double %32
  %35 = fmul double %34, %30
  %36 = fadd double %28, %35
  %37 = fdiv double %22, %36
  %38 = fmul double %37, %37
  %39 = fadd double %19, %38
  %40 = add nuw nsw i64 %20, 1
  %41 = icmp eq i64 %40, %4
  br i1 %41, label %13, label %18, !llvm.loop !53
}

define internal fastcc i32 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp slt i64 %1, 1
  br i1 %4, label %76, label %8

5:                                                ; preds = %73, %50
  %6 = icmp sge i64 %16, %1
  %7 = icmp eq i64 %16, %1
  br i1 %7, label %76, label %8, !llvm.loop !54

8:                                                ; preds = %3, %5
  %9 = phi i1 [ %6, %5 ], [ %4, %3 ]
  %10 = phi i64 [ %16, %5 ], [ 0, %3 ]
  %11 = mul nuw nsw i64 %10, %1
  %12 = getelementptr double, ptr %0, i64 %11
  %13 = getelementptr double, ptr %12, i64 %10
  %14 = load double, ptr %13, align 8
  %15 = tail call double @llvm.fabs.f64(double %14)
  %16 = add nuw nsw i64 %10, 1
  %17 = getelementptr double, ptr %0, i64 %10
  %18 = icmp slt i64 %16, %1
  br i1 %18, label %24, label %19

19:                                               ; preds = %24, %8
  %20 = phi double [ %15, %8 ], [ %33, %24 ]
  %21 = phi i64 [ %10, %8 ], [ %34, %24 ]
  %22 = getelementptr inbounds i64, ptr %2, i64 %10
  store i64 %21, ptr %22, align 8
  %23 = fcmp ueq double %20, 0.000000e+00
  br i1 %23, label %76, label %37

24:                                               ; preds = %8, %24
  %25 = phi i64 [ %34, %24 ], [ %10, %8 ]
  %26 = phi i64 [ %35, %24 ], [ %16, %8 ]
  %27 = phi double [ %33, %24 ], [ %15, %8 ]
  %28 = mul nuw nsw i64 %26, %1
  %29 = getelementptr double, ptr %17, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = tail call double @llvm.fabs.f64(double %30)
  %32 = fcmp ogt double %31, %27
  %33 = select i1 %32, double %31, double %27
  %34 = select i1 %32, i64 %26, i64 %25
  %35 = add nuw nsw i64 %26, 1
  %36 = icmp slt i64 %35, %1
  br i1 %36, label %24, label %19, !llvm.loop !55

37:                                               ; preds = %19
  %38 = icmp eq i64 %21, %10
  br i1 %38, label %50, label %39

39:                                               ; preds = %37
  %40 = mul nsw i64 %21, %1
  %41 = getelementptr double, ptr %0, i64 %40
  br label %42

42:                                               ; preds = %39, %42
  %43 = phi i64 [ 0, %39 ], [ %48, %42 ]
  %44 = getelementptr double, ptr %12, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = getelementptr double, ptr %41, i64 %43
  %47 = load double, ptr %46, align 8
  store double %47, ptr %44, align 8
  store double %45, ptr %46, align 8
  %48 = add nuw nsw i64 %43, 1
  %49 = icmp eq i64 %48, %1
  br i1 %49, label %50, label %42, !llvm.loop !56

50:                                               ; preds = %42, %37
  %51 = load double, ptr %13, align 8
  %52 = fdiv double 1.000000e+00, %51
  %53 = icmp slt i64 %16, %1
  br i1 %53, label %54, label %5

54:                                               ; preds = %50, %73
  %55 = phi i64 [ %74, %73 ], [ %16, %50 ]
  %56 = mul nuw nsw i64 %55, %1
  %57 = getelementptr double, ptr %0, i64 %56
  %58 = getelementptr double, ptr %57, i64 %10
  %59 = load double, ptr %58, align 8
  %60 = fcmp une double %59, 0.000000e+00
  br i1 %60, label %61, label %73

61:                                               ; preds = %54
  %62 = fmul double %52, %59
  store double %62, ptr %58, align 8
  br label %63

63:                                               ; preds = %61, %63
  %64 = phi i64 [ %16, %61 ], [ %71, %63 ]
  %65 = getelementptr double, ptr %12, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = fmul double %62, %66
  %68 = getelementptr double, ptr %57, i64 %64
  %69 = load double, ptr %68, align 8
  %70 = fsub double %69, %67
  store double %70, ptr %68, align 8
  %71 = add nuw nsw i64 %64, 1
  %72 = icmp slt i64 %71, %1
  br i1 %72, label %63, label %73, !llvm.loop !57

73:                                               ; preds = %63, %54
  %74 = add nuw nsw i64 %55, 1
  %75 = icmp slt i64 %74, %1
  br i1 %75, label %54, label %5, !llvm.loop !58

76:                                               ; preds = %5, %19, %3
  %77 = phi i1 [ %4, %3 ], [ %6, %5 ], [ %9, %19 ]
  %78 = zext i1 %77 to i32
  ret i32 %78
}

define internal fastcc i32 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #6 {
  %4 = icmp slt i64 %1, 1
  br i1 %4, label %127, label %8

5:                                                ; preds = %124, %82
  %6 = icmp sge i64 %18, %1
  %7 = icmp eq i64 %18, %1
  br i1 %7, label %127, label %8, !llvm.loop !59

8:                                                ; preds = %3, %5
  %9 = phi i1 [ %6, %5 ], [ %4, %3 ]
  %10 = phi i64 [ %18, %5 ], [ 0, %3 ]
  %11 = mul nuw nsw i64 %10, %1
  %12 = getelementptr { double, double }, ptr %0, i64 %11
  %13 = getelementptr { double, double }, ptr %12, i64 %10
  %14 = load double, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %13, i64 8
  %16 = load double, ptr %15, align 8
  %17 = tail call double @hypot(double noundef %14, double noundef %16) #13
  %18 = add nuw nsw i64 %10, 1
  %19 = getelementptr { double, double }, ptr %0, i64 %10
  %20 = icmp slt i64 %18, %1
  br i1 %20, label %26, label %21

21:                                               ; preds = %26, %8
  %22 = phi double [ %17, %8 ], [ %37, %26 ]
  %23 = phi i64 [ %10, %8 ], [ %38, %26 ]
  %24 = getelementptr inbounds i64, ptr %2, i64 %10
  store i64 %23, ptr %24, align 8
  %25 = fcmp ueq double %22, 0.000000e+00
  br i1 %25, label %127, label %41

26:                                               ; preds = %8, %26
  %27 = phi i64 [ %38, %26 ], [ %10, %8 ]
  %28 = phi double [ %37, %26 ], [ %17, %8 ]
  %29 = phi i64 [ %39, %26 ], [ %18, %8 ]
  %30 = mul nuw nsw i64 %29, %1
  %31 = getelementptr { double, double }, ptr %19, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %31, i64 8
  %34 = load double, ptr %33, align 8
  %35 = tail call double @hypot(double noundef %32, double noundef %34) #13
  %36 = fcmp ogt double %35, %28
  %37 = select i1 %36, double %35, double %28
  %38 = select i1 %36, i64 %29, i64 %27
  %39 = add nuw nsw i64 %29, 1
  %40 = icmp slt i64 %39, %1
  br i1 %40, label %26, label %21, !llvm.loop !60

41:                                               ; preds = %21
  %42 = icmp eq i64 %23, %10
  br i1 %42, label %58, label %43

43:                                               ; preds = %41
  %44 = mul nsw i64 %23, %1
  %45 = getelementptr { double, double }, ptr %0, i64 %44
  br label %46

46:                                               ; preds = %43, %46
  %47 = phi i64 [ 0, %43 ], [ %56, %46 ]
  %48 = getelementptr { double, double }, ptr %12, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = getelementptr inbounds i8, ptr %48, i64 8
  %51 = load double, ptr %50, align 8
  %52 = getelementptr { double, double }, ptr %45, i64 %47
  %53 = load double, ptr %52, align 8
  %54 = getelementptr inbounds i8, ptr %52, i64 8
  %55 = load double, ptr %54, align 8
  store double %53, ptr %48, align 8
  store double %55, ptr %50, align 8
  store double %49, ptr %52, align 8
  store double %51, ptr %54, align 8
  %56 = add nuw nsw i64 %47, 1
  %57 = icmp eq i64 %56, %1
  br i1 %57, label %58, label %46, !llvm.loop !61

58:                                               ; preds = %46, %41
  %59 = load double, ptr %13, align 8
  %60 = load double, ptr %15, align 8
  %61 = tail call double @llvm.fabs.f64(double %59)
  %62 = tail call double @llvm.fabs.f64(double %60)
  %63 = fcmp ult double %61, %62
  br i1 %63, label %73, label %64

64:                                               ; preds = %58
  %65 = fdiv double %60, %59
  %66 = fmul double %60, %65
  %67 = fadd double %59, %66
  %68 = fmul double %65, 0.000000e+00
  %69 = fadd double %68, 1.000000e+00
  %70 = fdiv double %69, %67
  %71 = fsub double 0.000000e+00, %65
  %72 = fdiv double %71, %67
  br label %82

73:                                               ; preds = %58
  %74 = fdiv double %59, %60
  %75 = fmul double %59, %74
  %76 = fadd double %60, %75
  %77 = fadd double %74, 0.000000e+00
  %78 = fdiv double %77, %76
  %79 = fmul double %74, 0.000000e+00
  %80 = fadd double %79, -1.000000e+00
  %81 = fdiv double %80, %76
  br label %82

82:                                               ; preds = %64, %73
  %83 = phi double [ %70, %64 ], [ %78, %73 ]
  %84 = phi double [ %72, %64 ], [ %81, %73 ]
  %85 = icmp slt i64 %18, %1
  br i1 %85, label %86, label %5

86:                                               ; preds = %82, %124
  %87 = phi i64 [ %125, %124 ], [ %18, %82 ]
  %88 = mul nuw nsw i64 %87, %1
  %89 = getelementptr { double, double }, ptr %0, i64 %88
  %90 = getelementptr { double, double }, ptr %89, i64 %10
  %91 = load double, ptr %90, align 8
  %92 = getelementptr inbounds i8, ptr %90, i64 8
  %93 = load double, ptr %92, align 8
  %94 = fcmp une double %91, 0.000000e+00
  %95 = fcmp une double %93, 0.000000e+00
  %96 = or i1 %94, %95
  br i1 %96, label %97, label %124

97:                                               ; preds = %86
  %98 = fmul double %83, %91
  %99 = fmul double %84, %93
  %100 = fmul double %84, %91
  %101 = fmul double %83, %93
  %102 = fsub double %98, %99
  %103 = fadd double %100, %101
  store double %102, ptr %90, align 8
  store double %103, ptr %92, align 8
  br label %104

104:                                              ; preds = %97, %104
  %105 = phi i64 [ %18, %97 ], [ %122, %104 ]
  %106 = getelementptr { double, double }, ptr %12, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = getelementptr inbounds i8, ptr %106, i64 8
  %109 = load double, ptr %108, align 8
  %110 = fmul double %102, %107
  %111 = fmul double %103, %109
  %112 = fmul double %102, %109
  %113 = fmul double %103, %107
  %114 = fsub double %110, %111
  %115 = fadd double %113, %112
  %116 = getelementptr { double, double }, ptr %89, i64 %105
  %117 = load double, ptr %116, align 8
  %118 = getelementptr inbounds i8, ptr %116, i64 8
  %119 = load double, ptr %118, align 8
  %120 = fsub double %117, %114
  %121 = fsub double %119, %115
  store double %120, ptr %116, align 8
  store double %121, ptr %118, align 8
  %122 = add nuw nsw i64 %105, 1
  %123 = icmp slt i64 %122, %1
  br i1 %123, label %104, label %124, !llvm.loop !62

124:                                              ; preds = %104, %86
  %125 = add nuw nsw i64 %87, 1
  %126 = icmp slt i64 %125, %1
  br i1 %126, label %86, label %5, !llvm.loop !63

127:                                              ; preds = %5, %21, %3
  %128 = phi i1 [ %4, %3 ], [ %6, %5 ], [ %9, %21 ]
  %129 = zext i1 %128 to i32
  ret i32 %129
}

declare double @hypot(double noundef, double noundef) #7

define internal fastcc void @real_solve(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #5 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %8, %4
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %24, label %20

8:                                                ; preds = %4, %8
  %9 = phi i64 [ %18, %8 ], [ 0, %4 ]
  %10 = getelementptr inbounds double, ptr %3, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds i64, ptr %2, i64 %9
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds double, ptr %3, i64 %13
  %15 = load double, ptr %14, align 8
  store double %15, ptr %10, align 8
  %16 = load i64, ptr %12, align 8
  %17 = getelementptr inbounds double, ptr %3, i64 %16
  store double %11, ptr %17, align 8
  %18 = add nuw nsw i64 %9, 1
  %19 = icmp eq i64 %18, %1
  br i1 %19, label %6, label %8, !llvm.loop !64

20:                                               ; preds = %32, %6
  %21 = icmp sgt i64 %1, 0
  br i1 %21, label %22, label %47

22:                                               ; preds = %20
  %23 = add nuw i64 %1, 1
  br label %48

24:                                               ; preds = %6, %32
  %25 = phi i64 [ %34, %32 ], [ 0, %6 ]
  %26 = getelementptr inbounds double, ptr %3, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = icmp eq i64 %25, 0
  br i1 %28, label %32, label %29

29:                                               ; preds = %24
  %30 = mul nuw nsw i64 %25, %1
  %31 = getelementptr double, ptr %0, i64 %30
  br label %36

32:                                               ; preds = %36, %24
  %33 = phi double [ %27, %24 ], [ %44, %36 ]
  store double %33, ptr %26, align 8
  %34 = add nuw nsw i64 %25, 1
  %35 = icmp eq i64 %34, %1
  br i1 %35, label %20, label %24, !llvm.loop !65

36:                                               ; preds = %29, %36
  %37 = phi i64 [ 0, %29 ], [ %45, %36 ]
  %38 = phi double [ %27, %29 ], [ %44, %36 ]
  %39 = getelementptr double, ptr %31, i64 %37
  %40 = load double, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %3, i64 %37
  %42 = load double, ptr %41, align 8
  %43 = fmul double %40, %42
  %44 = fsub double %38, %43
  %45 = add nuw nsw i64 %37, 1
  %46 = icmp eq i64 %45, %25
  br i1 %46, label %32, label %36, !llvm.loop !66

47:                                               ; preds = %57, %20
  ret void

48:                                               ; preds = %22, %57
  %49 = phi i64 [ %1, %22 ], [ %50, %57 ]
  %50 = add nsw i64 %49, -1
  %51 = getelementptr inbounds double, ptr %3, i64 %50
  %52 = load double, ptr %51, align 8
  %53 = icmp slt i64 %49, %1
  br i1 %53, label %54, label %57

54:                                               ; preds = %48
  %55 = mul nsw i64 %50, %1
  %56 = getelementptr double, ptr %0, i64 %55
  br label %64

57:                                               ; preds = %64, %48
  %58 = phi double [ %52, %48 ], [ %72, %64 ]
  %59 = mul i64 %50, %23
  %60 = getelementptr inbounds double, ptr %0, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = fdiv double %58, %61
  store double %62, ptr %51, align 8
  %63 = icmp sgt i64 %49, 1
  br i1 %63, label %48, label %47, !llvm.loop !67

64:                                               ; preds = %54, %64
  %65 = phi i64 [ %49, %54 ], [ %73, %64 ]
  %66 = phi double [ %52, %54 ], [ %72, %64 ]
  %67 = getelementptr double, ptr %56, i64 %65
  %68 = load double, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %3, i64 %65
  %70 = load double, ptr %69, align 8
  %71 = fmul double %68, %70
  %72 = fsub double %66, %71
  %73 = add nuw nsw i64 %65, 1
  %74 = icmp eq i64 %73, %1
  br i1 %74, label %57, label %64, !llvm.loop !68
}

define internal fastcc void @pair_solve(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #5 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %8, %4
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %29, label %25

8:                                                ; preds = %4, %8
  %9 = phi i64 [ %23, %8 ], [ 0, %4 ]
  %10 = getelementptr inbounds { double, double }, ptr %3, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %10, i64 8
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds i64, ptr %2, i64 %9
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr inbounds { double, double }, ptr %3, i64 %15
  %17 = load double, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %16, i64 8
  %19 = load double, ptr %18, align 8
  store double %17, ptr %10, align 8
  store double %19, ptr %12, align 8
  %20 = load i64, ptr %14, align 8
  %21 = getelementptr inbounds { double, double }, ptr %3, i64 %20
  %22 = getelementptr inbounds i8, ptr %21, i64 8
  store double %11, ptr %21, align 8
  store double %13, ptr %22, align 8
  %23 = add nuw nsw i64 %9, 1
  %24 = icmp eq i64 %23, %1
  br i1 %24, label %6, label %8, !llvm.loop !69

25:                                               ; preds = %39, %6
  %26 = icmp sgt i64 %1, 0
  br i1 %26, label %27, label %66

27:                                               ; preds = %25
  %28 = add nuw i64 %1, 1
  br label %67

29:                                               ; preds = %6, %39
  %30 = phi i64 [ %42, %39 ], [ 0, %6 ]
  %31 = getelementptr inbounds { double, double }, ptr %3, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %31, i64 8
  %34 = load double, ptr %33, align 8
  %35 = icmp eq i64 %30, 0
  br i1 %35, label %39, label %36

36:                                               ; preds = %29
  %37 = mul nuw nsw i64 %30, %1
  %38 = getelementptr { double, double }, ptr %0, i64 %37
  br label %44

39:                                               ; preds = %44, %29
  %40 = phi double [ %32, %29 ], [ %62, %44 ]
  %41 = phi double [ %34, %29 ], [ %63, %44 ]
  store double %40, ptr %31, align 8
  store double %41, ptr %33, align 8
  %42 = add nuw nsw i64 %30, 1
  %43 = icmp eq i64 %42, %1
  br i1 %43, label %25, label %29, !llvm.loop !70

44:                                               ; preds = %36, %44
  %45 = phi double [ %34, %36 ], [ %63, %44 ]
  %46 = phi i64 [ 0, %36 ], [ %64, %44 ]
  %47 = phi double [ %32, %36 ], [ %62, %44 ]
  %48 = getelementptr { double, double }, ptr %38, i64 %46
  %49 = load double, ptr %48, align 8
  %50 = getelementptr inbounds i8, ptr %48, i64 8
  %51 = load double, ptr %50, align 8
  %52 = getelementptr inbounds { double, double }, ptr %3, i64 %46
  %53 = load double, ptr %52, align 8
  %54 = getelementptr inbounds i8, ptr %52, i64 8
  %55 = load double, ptr %54, align 8
  %56 = fmul double %49, %53
  %57 = fmul double %51, %55
  %58 = fmul double %49, %55
  %59 = fmul double %51, %53
  %60 = fsub double %56, %57
  %61 = fadd double %59, %58
  %62 = fsub double %47, %60
  %63 = fsub double %45, %61
  %64 = add nuw nsw i64 %46, 1
  %65 = icmp eq i64 %64, %30
  br i1 %65, label %39, label %44, !llvm.loop !71

66:                                               ; preds = %109, %25
  ret void

67:                                               ; preds = %27, %109
  %68 = phi i64 [ %1, %27 ], [ %69, %109 ]
  %69 = add nsw i64 %68, -1
  %70 = getelementptr inbounds { double, double }, ptr %3, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %70, i64 8
  %73 = load double, ptr %72, align 8
  %74 = icmp slt i64 %68, %1
  br i1 %74, label %75, label %78

75:                                               ; preds = %67
  %76 = mul nsw i64 %69, %1
  %77 = getelementptr { double, double }, ptr %0, i64 %76
  br label %113

78:                                               ; preds = %113, %67
  %79 = phi double [ %73, %67 ], [ %132, %113 ]
  %80 = phi double [ %71, %67 ], [ %131, %113 ]
  %81 = mul i64 %69, %28
  %82 = getelementptr inbounds { double, double }, ptr %0, i64 %81
  %83 = load double, ptr %82, align 8
  %84 = getelementptr inbounds i8, ptr %82, i64 8
  %85 = load double, ptr %84, align 8
  %86 = tail call double @llvm.fabs.f64(double %83)
  %87 = tail call double @llvm.fabs.f64(double %85)
  %88 = fcmp ult double %86, %87
  br i1 %88, label %99, label %89

89:                                               ; preds = %78
  %90 = fdiv double %85, %83
  %91 = fmul double %85, %90
  %92 = fadd double %83, %91
  %93 = fmul double %79, %90
  %94 = fadd double %80, %93
  %95 = fdiv double %94, %92
  %96 = fmul double %80, %90
  %97 = fsub double %79, %96
  %98 = fdiv double %97, %92
  br label %109

99:                                               ; preds = %78
  %100 = fdiv double %83, %85
  %101 = fmul double %83, %100
  %102 = fadd double %85, %101
  %103 = fmul double %80, %100
  %104 = fadd double %79, %103
  %105 = fdiv double %104, %102
  %106 = fmul double %79, %100
  %107 = fsub double %106, %80
  %108 = fdiv double %107, %102
  br label %109

109:                                              ; preds = %89, %99
  %110 = phi double [ %95, %89 ], [ %105, %99 ]
  %111 = phi double [ %98, %89 ], [ %108, %99 ]
  store double %110, ptr %70, align 8
  store double %111, ptr %72, align 8
  %112 = icmp sgt i64 %68, 1
  br i1 %112, label %67, label %66, !llvm.loop !72

113:                                              ; preds = %75, %113
  %114 = phi i64 [ %68, %75 ], [ %133, %113 ]
  %115 = phi double [ %71, %75 ], [ %131, %113 ]
  %116 = phi double [ %73, %75 ], [ %132, %113 ]
  %117 = getelementptr { double, double }, ptr %77, i64 %114
  %118 = load double, ptr %117, align 8
  %119 = getelementptr inbounds i8, ptr %117, i64 8
  %120 = load double, ptr %119, align 8
  %121 = getelementptr inbounds { double, double }, ptr %3, i64 %114
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %121, i64 8
  %124 = load double, ptr %123, align 8
  %125 = fmul double %118, %122
  %126 = fmul double %120, %124
  %127 = fmul double %118, %124
  %128 = fmul double %120, %122
  %129 = fsub double %125, %126
  %130 = fadd double %128, %127
  %131 = fsub double %115, %129
  %132 = fsub double %116, %130
  %133 = add nuw nsw i64 %114, 1
  %134 = icmp eq i64 %133, %1
  br i1 %134, label %78, label %113, !llvm.loop !73
}

define internal fastcc void @real_solve_columns(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3, i64 noundef %4) unnamed_addr #5 {
  %6 = getelementptr inbounds double, ptr %3, i64 %1
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %10

8:                                                ; preds = %5
  %9 = icmp slt i64 %4, 1
  br label %14

10:                                               ; preds = %38, %5
  %11 = icmp sgt i64 %1, 0
  br i1 %11, label %12, label %49

12:                                               ; preds = %10
  %13 = icmp sgt i64 %4, 0
  br label %41

14:                                               ; preds = %8, %38
  %15 = phi i64 [ 0, %8 ], [ %39, %38 ]
  %16 = getelementptr inbounds i64, ptr %2, i64 %15
  %17 = load i64, ptr %16, align 8
  %18 = icmp eq i64 %17, %15
  %19 = or i1 %18, %9
  br i1 %19, label %38, label %20

20:                                               ; preds = %14
  %21 = mul nuw nsw i64 %15, %4
  %22 = getelementptr double, ptr %6, i64 %21
  br label %23

23:                                               ; preds = %20, %23
  %24 = phi i64 [ 0, %20 ], [ %36, %23 ]
  %25 = getelementptr double, ptr %22, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = load i64, ptr %16, align 8
  %28 = mul nsw i64 %27, %4
  %29 = getelementptr double, ptr %6, i64 %28
  %30 = getelementptr double, ptr %29, i64 %24
  %31 = load double, ptr %30, align 8
  store double %31, ptr %25, align 8
  %32 = load i64, ptr %16, align 8
  %33 = mul nsw i64 %32, %4
  %34 = getelementptr double, ptr %6, i64 %33
  %35 = getelementptr double, ptr %34, i64 %24
  store double %26, ptr %35, align 8
  %36 = add nuw nsw i64 %24, 1
  %37 = icmp eq i64 %36, %4
  br i1 %37, label %38, label %23, !llvm.loop !74

38:                                               ; preds = %23, %14
  %39 = add nuw nsw i64 %15, 1
  %40 = icmp eq i64 %39, %1
  br i1 %40, label %10, label %14, !llvm.loop !75

41:                                               ; preds = %12, %55
  %42 = phi i64 [ 0, %12 ], [ %56, %55 ]
  %43 = icmp eq i64 %42, 0
  br i1 %43, label %55, label %44

44:                                               ; preds = %41
  %45 = mul nsw i64 %42, %4
  %46 = getelementptr inbounds double, ptr %6, i64 %45
  %47 = mul nuw nsw i64 %42, %1
  %48 = getelementptr double, ptr %0, i64 %47
  br label %58

49:                                               ; preds = %55, %10
  %50 = icmp sgt i64 %1, 0
  br i1 %50, label %51, label %88

51:                                               ; preds = %49
  %52 = icmp sgt i64 %4, 0
  %53 = add nuw i64 %1, 1
  %54 = icmp sgt i64 %4, 0
  br label %79

55:                                               ; preds = %74, %41
  %56 = add nuw nsw i64 %42, 1
  %57 = icmp eq i64 %56, %1
  br i1 %57, label %49, label %41, !llvm.loop !76

58:                                               ; preds = %44, %74
  %59 = phi i64 [ 0, %44 ], [ %75, %74 ]
  %60 = getelementptr double, ptr %48, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = mul nsw i64 %59, %4
  %63 = getelementptr inbounds double, ptr %6, i64 %62
  br i1 %13, label %64, label %74

64:                                               ; preds = %58, %64
  %65 = phi i64 [ %72, %64 ], [ 0, %58 ]
  %66 = getelementptr inbounds double, ptr %63, i64 %65
  %67 = load double, ptr %66, align 8
  %68 = fmul double %61, %67
  %69 = getelementptr inbounds double, ptr %46, i64 %65
  %70 = load double, ptr %69, align 8
  %71 = fsub double %70, %68
  store double %71, ptr %69, align 8
  %72 = add nuw nsw i64 %65, 1
  %73 = icmp eq i64 %72, %4
  br i1 %73, label %74, label %64, !llvm.loop !77

74:                                               ; preds = %64, %58
  %75 = add nuw nsw i64 %59, 1
  %76 = icmp eq i64 %75, %42
  br i1 %76, label %55, label %58, !llvm.loop !78

77:                                               ; preds = %116, %89
  %78 = icmp sgt i64 %80, 1
  br i1 %78, label %79, label %88, !llvm.loop !79

79:                                               ; preds = %51, %77
  %80 = phi i64 [ %1, %51 ], [ %81, %77 ]
  %81 = add nsw i64 %80, -1
  %82 = icmp slt i64 %80, %1
  br i1 %82, label %83, label %89

83:                                               ; preds = %79
  %84 = mul nsw i64 %81, %4
  %85 = getelementptr inbounds double, ptr %6, i64 %84
  %86 = mul nsw i64 %81, %1
  %87 = getelementptr double, ptr %0, i64 %86
  br label %97

88:                                               ; preds = %77, %49
  ret void

89:                                               ; preds = %113, %79
  %90 = mul i64 %81, %53
  %91 = getelementptr inbounds double, ptr %0, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = fdiv double 1.000000e+00, %92
  br i1 %54, label %94, label %77

94:                                               ; preds = %89
  %95 = mul nsw i64 %81, %4
  %96 = getelementptr double, ptr %6, i64 %95
  br label %116

97:                                               ; preds = %83, %113
  %98 = phi i64 [ %80, %83 ], [ %114, %113 ]
  %99 = getelementptr double, ptr %87, i64 %98
  %100 = load double, ptr %99, align 8
  %101 = mul nsw i64 %98, %4
  %102 = getelementptr inbounds double, ptr %6, i64 %101
  br i1 %52, label %103, label %113

103:                                              ; preds = %97, %103
  %104 = phi i64 [ %111, %103 ], [ 0, %97 ]
  %105 = getelementptr inbounds double, ptr %102, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = fmul double %100, %106
  %108 = getelementptr inbounds double, ptr %85, i64 %104
  %109 = load double, ptr %108, align 8
  %110 = fsub double %109, %107
  store double %110, ptr %108, align 8
  %111 = add nuw nsw i64 %104, 1
  %112 = icmp eq i64 %111, %4
  br i1 %112, label %113, label %103, !llvm.loop !77

113:                                              ; preds = %103, %97
  %114 = add nuw nsw i64 %98, 1
  %115 = icmp eq i64 %114, %1
  br i1 %115, label %89, label %97, !llvm.loop !80

116:                                              ; preds = %94, %116
  %117 = phi i64 [ 0, %94 ], [ %121, %116 ]
  %118 = getelementptr double, ptr %96, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fmul double %93, %119
  store double %120, ptr %118, align 8
  %121 = add nuw nsw i64 %117, 1
  %122 = icmp eq i64 %121, %4
  br i1 %122, label %77, label %116, !llvm.loop !81
}

define internal fastcc void @pair_solve_columns(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3, i64 noundef %4) unnamed_addr #5 {
  %6 = getelementptr inbounds { double, double }, ptr %3, i64 %1
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %10

8:                                                ; preds = %5
  %9 = icmp slt i64 %4, 1
  br label %14

10:                                               ; preds = %43, %5
  %11 = icmp sgt i64 %1, 0
  br i1 %11, label %12, label %54

12:                                               ; preds = %10
  %13 = icmp sgt i64 %4, 0
  br label %46

14:                                               ; preds = %8, %43
  %15 = phi i64 [ 0, %8 ], [ %44, %43 ]
  %16 = getelementptr inbounds i64, ptr %2, i64 %15
  %17 = load i64, ptr %16, align 8
  %18 = icmp eq i64 %17, %15
  %19 = or i1 %18, %9
  br i1 %19, label %43, label %20

20:                                               ; preds = %14
  %21 = mul nuw nsw i64 %15, %4
  %22 = getelementptr { double, double }, ptr %6, i64 %21
  br label %23

23:                                               ; preds = %20, %23
  %24 = phi i64 [ 0, %20 ], [ %41, %23 ]
  %25 = getelementptr { double, double }, ptr %22, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds i8, ptr %25, i64 8
  %28 = load double, ptr %27, align 8
  %29 = load i64, ptr %16, align 8
  %30 = mul nsw i64 %29, %4
  %31 = getelementptr { double, double }, ptr %6, i64 %30
  %32 = getelementptr { double, double }, ptr %31, i64 %24
  %33 = load double, ptr %32, align 8
  %34 = getelementptr inbounds i8, ptr %32, i64 8
  %35 = load double, ptr %34, align 8
  store double %33, ptr %25, align 8
  store double %35, ptr %27, align 8
  %36 = load i64, ptr %16, align 8
  %37 = mul nsw i64 %36, %4
  %38 = getelementptr { double, double }, ptr %6, i64 %37
  %39 = getelementptr { double, double }, ptr %38, i64 %24
  %40 = getelementptr inbounds i8, ptr %39, i64 8
  store double %26, ptr %39, align 8
  store double %28, ptr %40, align 8
  %41 = add nuw nsw i64 %24, 1
  %42 = icmp eq i64 %41, %4
  br i1 %42, label %43, label %23, !llvm.loop !82

43:                                               ; preds = %23, %14
  %44 = add nuw nsw i64 %15, 1
  %45 = icmp eq i64 %44, %1
  br i1 %45, label %10, label %14, !llvm.loop !83

46:                                               ; preds = %12, %60
  %47 = phi i64 [ 0, %12 ], [ %61, %60 ]
  %48 = icmp eq i64 %47, 0
  br i1 %48, label %60, label %49

49:                                               ; preds = %46
  %50 = mul nsw i64 %47, %4
  %51 = getelementptr inbounds { double, double }, ptr %6, i64 %50
  %52 = mul nuw nsw i64 %47, %1
  %53 = getelementptr { double, double }, ptr %0, i64 %52
  br label %63

54:                                               ; preds = %60, %10
  %55 = icmp sgt i64 %1, 0
  br i1 %55, label %56, label %105

56:                                               ; preds = %54
  %57 = icmp sgt i64 %4, 0
  %58 = add nuw i64 %1, 1
  %59 = icmp sgt i64 %4, 0
  br label %96

60:                                               ; preds = %91, %46
  %61 = add nuw nsw i64 %47, 1
  %62 = icmp eq i64 %61, %1
  br i1 %62, label %54, label %46, !llvm.loop !84

63:                                               ; preds = %49, %91
  %64 = phi i64 [ 0, %49 ], [ %92, %91 ]
  %65 = getelementptr { double, double }, ptr %53, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = getelementptr inbounds i8, ptr %65, i64 8
  %68 = load double, ptr %67, align 8
  %69 = mul nsw i64 %64, %4
  %70 = getelementptr inbounds { double, double }, ptr %6, i64 %69
  br i1 %13, label %71, label %91

71:                                               ; preds = %63, %71
  %72 = phi i64 [ %89, %71 ], [ 0, %63 ]
  %73 = getelementptr inbounds { double, double }, ptr %70, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %73, i64 8
  %76 = load double, ptr %75, align 8
  %77 = fmul double %66, %74
  %78 = fmul double %68, %76
  %79 = fmul double %66, %76
  %80 = fmul double %68, %74
  %81 = fsub double %77, %78
  %82 = fadd double %80, %79
  %83 = getelementptr inbounds { double, double }, ptr %51, i64 %72
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds i8, ptr %83, i64 8
  %86 = load double, ptr %85, align 8
  %87 = fsub double %84, %81
  %88 = fsub double %86, %82
  store double %87, ptr %83, align 8
  store double %88, ptr %85, align 8
  %89 = add nuw nsw i64 %72, 1
  %90 = icmp eq i64 %89, %4
  br i1 %90, label %91, label %71, !llvm.loop !85

91:                                               ; preds = %71, %63
  %92 = add nuw nsw i64 %64, 1
  %93 = icmp eq i64 %92, %47
  br i1 %93, label %60, label %63, !llvm.loop !86

94:                                               ; preds = %170, %133
  %95 = icmp sgt i64 %97, 1
  br i1 %95, label %96, label %105, !llvm.loop !87

96:                                               ; preds = %56, %94
  %97 = phi i64 [ %1, %56 ], [ %98, %94 ]
  %98 = add nsw i64 %97, -1
  %99 = icmp slt i64 %97, %1
  br i1 %99, label %100, label %106

100:                                              ; preds = %96
  %101 = mul nsw i64 %98, %4
  %102 = getelementptr inbounds { double, double }, ptr %6, i64 %101
  %103 = mul nsw i64 %98, %1
  %104 = getelementptr { double, double }, ptr %0, i64 %103
  br label %139

105:                                              ; preds = %94, %54
  ret void

106:                                              ; preds = %167, %96
  %107 = mul i64 %98, %58
  %108 = getelementptr inbounds { double, double }, ptr %0, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = getelementptr inbounds i8, ptr %108, i64 8
  %111 = load double, ptr %110, align 8
  %112 = tail call double @llvm.fabs.f64(double %109)
  %113 = tail call double @llvm.fabs.f64(double %111)
  %114 = fcmp ult double %112, %113
  br i1 %114, label %124, label %115

115:                                              ; preds = %106
  %116 = fdiv double %111, %109
  %117 = fmul double %111, %116
  %118 = fadd double %109, %117
  %119 = fmul double %116, 0.000000e+00
  %120 = fadd double %119, 1.000000e+00
  %121 = fdiv double %120, %118
  %122 = fsub double 0.000000e+00, %116
  %123 = fdiv double %122, %118
  br label %133

124:                                              ; preds = %106
  %125 = fdiv double %109, %111
  %126 = fmul double %109, %125
  %127 = fadd double %111, %126
  %128 = fadd double %125, 0.000000e+00
  %129 = fdiv double %128, %127
  %130 = fmul double %125, 0.000000e+00
  %131 = fadd double %130, -1.000000e+00
  %132 = fdiv double %131, %127
  br label %133

133:                                              ; preds = %115, %124
  %134 = phi double [ %121, %115 ], [ %129, %124 ]
  %135 = phi double [ %123, %115 ], [ %132, %124 ]
  br i1 %59, label %136, label %94

136:                                              ; preds = %133
  %137 = mul nsw i64 %98, %4
  %138 = getelementptr { double, double }, ptr %6, i64 %137
  br label %170

139:                                              ; preds = %100, %167
  %140 = phi i64 [ %97, %100 ], [ %168, %167 ]
  %141 = getelementptr { double, double }, ptr %104, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = getelementptr inbounds i8, ptr %141, i64 8
  %144 = load double, ptr %143, align 8
  %145 = mul nsw i64 %140, %4
  %146 = getelementptr inbounds { double, double }, ptr %6, i64 %145
  br i1 %57, label %147, label %167

147:                                              ; preds = %139, %147
  %148 = phi i64 [ %165, %147 ], [ 0, %139 ]
  %149 = getelementptr inbounds { double, double }, ptr %146, i64 %148
  %150 = load double, ptr %149, align 8
  %151 = getelementptr inbounds i8, ptr %149, i64 8
  %152 = load double, ptr %151, align 8
  %153 = fmul double %142, %150
  %154 = fmul double %144, %152
  %155 = fmul double %142, %152
  %156 = fmul double %144, %150
  %157 = fsub double %153, %154
  %158 = fadd double %156, %155
  %159 = getelementptr inbounds { double, double }, ptr %102, i64 %148
  %160 = load double, ptr %159, align 8
  %161 = getelementptr inbounds i8, ptr %159, i64 8
  %162 = load double, ptr %161, align 8
  %163 = fsub double %160, %157
  %164 = fsub double %162, %158
  store double %163, ptr %159, align 8
  store double %164, ptr %161, align 8
  %165 = add nuw nsw i64 %148, 1
  %166 = icmp eq i64 %165, %4
  br i1 %166, label %167, label %147, !llvm.loop !85

167:                                              ; preds = %147, %139
  %168 = add nuw nsw i64 %140, 1
  %169 = icmp eq i64 %168, %1
  br i1 %169, label %106, label %139, !llvm.loop !88

170:                                              ; preds = %136, %170
  %171 = phi i64 [ 0, %136 ], [ %182, %170 ]
  %172 = getelementptr { double, double }, ptr %138, i64 %171
  %173 = load double, ptr %172, align 8
  %174 = getelementptr inbounds i8, ptr %172, i64 8
  %175 = load double, ptr %174, align 8
  %176 = fmul double %134, %173
  %177 = fmul double %135, %175
  %178 = fmul double %135, %173
  %179 = fmul double %134, %175
  %180 = fsub double %176, %177
  %181 = fadd double %178, %179
  store double %180, ptr %172, align 8
  store double %181, ptr %174, align 8
  %182 = add nuw nsw i64 %171, 1
  %183 = icmp eq i64 %182, %4
  br i1 %183, label %94, label %170, !llvm.loop !89
}

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #8 {
  %8 = load <8 x double>, ptr %5, align 8
  %9 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %8
  %10 = shl nsw i64 %6, 3
  %11 = icmp sgt i64 %6, 0
  br i1 %11, label %12, label %19

12:                                               ; preds = %7
  %13 = add nsw i64 %4, -1
  %14 = mul nsw i64 %13, %3
  %15 = getelementptr double, ptr %2, i64 %14
  %16 = add nsw i64 %4, -2
  %17 = icmp sgt i64 %4, 1
  %18 = sub i64 0, %3
  br label %20

19:                                               ; preds = %24, %7
  ret void

20:                                               ; preds = %12, %24
  %21 = phi i64 [ 0, %12 ], [ %30, %24 ]
  %22 = getelementptr double, ptr %15, i64 %21
  %23 = load <8 x double>, ptr %22, align 8
  br i1 %17, label %32, label %24

24:                                               ; preds = %32, %20
  %25 = phi <8 x double> [ %23, %20 ], [ %41, %32 ]
  %26 = getelementptr inbounds double, ptr %0, i64 %21
  %27 = getelementptr inbounds double, ptr %1, i64 %21
  %28 = load <8 x double>, ptr %27, align 8
  %29 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %8, <8 x double> %25, <8 x double> %28)
  store <8 x double> %29, ptr %26, align 8
  %30 = add nuw nsw i64 %21, 8
  %31 = icmp slt i64 %30, %10
  br i1 %31, label %20, label %19, !llvm.loop !90

32:                                               ; preds = %20, %32
  %33 = phi i64 [ %42, %32 ], [ %16, %20 ]
  %34 = phi <8 x double> [ %41, %32 ], [ %23, %20 ]
  %35 = phi ptr [ %36, %32 ], [ %22, %20 ]
  %36 = getelementptr inbounds double, ptr %35, i64 %18
  %37 = and i64 %33, 1
  %38 = icmp eq i64 %37, 0
  %39 = select i1 %38, <8 x double> %9, <8 x double> %8
  %40 = load <8 x double>, ptr %36, align 8
  %41 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %39, <8 x double> %34, <8 x double> %40)
  %42 = add nsw i64 %33, -1
  %43 = icmp sgt i64 %33, 0
  br i1 %43, label %32, label %24, !llvm.loop !91
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { noinline nounwind }
attributes #6 = { noinline nounwind }
attributes #7 = { nounwind willreturn memory(none) }
attributes #8 = { noinline nounwind }
attributes #9 = { nounwind willreturn memory(none) }
attributes #10 = { nounwind }
attributes #11 = { nounwind }
attributes #12 = { nounwind }
attributes #13 = { nounwind willreturn memory(none) }


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
!17 = distinct !{!17, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = !{!23}
!23 = distinct !{!23, !24, !"solve_stages: argument 0"}
!24 = distinct !{!24, !"solve_stages"}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
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
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5}
!54 = distinct !{!54, !4, !5}
!55 = distinct !{!55, !4, !5}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5}
!60 = distinct !{!60, !4, !5}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5}
!64 = distinct !{!64, !4, !5}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
!84 = distinct !{!84, !4, !5}
!85 = distinct !{!85, !4, !5}
!86 = distinct !{!86, !4, !5}
!87 = distinct !{!87, !4, !5}
!88 = distinct !{!88, !4, !5}
!89 = distinct !{!89, !4, !5}
!90 = distinct !{!90, !4, !5}
!91 = distinct !{!91, !4, !5}
