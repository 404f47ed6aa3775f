; sources 0f45e8418fdf4a8099c3caf70171f91929c540be4d5390e0eab3fe4c65bcc786
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

183:                                              ; preds = %1924, %75
  %184 = phi double [ undef, %75 ], [ %1906, %1924 ]
  %185 = phi i32 [ undef, %75 ], [ %1907, %1924 ]
  %186 = phi i64 [ undef, %75 ], [ %1908, %1924 ]
  %187 = phi i64 [ undef, %75 ], [ %1909, %1924 ]
  %188 = load ptr, ptr %79, align 8
  %189 = load ptr, ptr %80, align 8
  %190 = load ptr, ptr %81, align 8
  %191 = load ptr, ptr %78, align 8
  %192 = getelementptr inbounds i8, ptr %190, i64 56
  %193 = load i64, ptr %192, align 8
  %194 = icmp eq i64 %193, 0
  br i1 %194, label %1905, label %195

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
  br label %1905

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
  br i1 %303, label %1905, label %304

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

369:                                              ; preds = %1902, %330
  %370 = phi double [ %184, %330 ], [ %1894, %1902 ]
  %371 = phi i32 [ %185, %330 ], [ %1895, %1902 ]
  %372 = phi i64 [ %186, %330 ], [ %1896, %1902 ]
  %373 = phi i64 [ %187, %330 ], [ %1897, %1902 ]
  %374 = phi double [ %331, %330 ], [ %1898, %1902 ]
  store double %374, ptr %225, align 8
  br label %1905

375:                                              ; preds = %334, %1902
  %376 = phi i64 [ %332, %334 ], [ %1903, %1902 ]
  %377 = phi i64 [ undef, %334 ], [ %1901, %1902 ]
  %378 = phi double [ %224, %334 ], [ %1899, %1902 ]
  %379 = phi double [ %331, %334 ], [ %1898, %1902 ]
  %380 = phi i64 [ %187, %334 ], [ %1897, %1902 ]
  %381 = phi i64 [ %186, %334 ], [ %1896, %1902 ]
  %382 = phi i32 [ %185, %334 ], [ %1895, %1902 ]
  %383 = phi double [ %184, %334 ], [ %1894, %1902 ]
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
  br label %1905

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
  br label %1905

405:                                              ; preds = %397
  %406 = load double, ptr %338, align 8
  %407 = fcmp olt double %379, %406
  %408 = select i1 %407, double %379, double %406
  %409 = fadd double %378, %408
  %410 = fmul double %408, 1.000000e-03
  %411 = fsub double %203, %410
  %412 = fcmp ule double %409, %411
  %413 = fsub double %203, %378
  %414 = select i1 %412, double %408, double %413
  %415 = select i1 %412, double %409, double %203
  %416 = fmul double %414, 6.250000e-02
  %417 = fadd double %378, %416
  %418 = fcmp ule double %417, %378
  %419 = fcmp une double %415, %203
  %420 = and i1 %419, %418
  br i1 %420, label %421, label %422

421:                                              ; preds = %405
  store double %414, ptr %225, align 8
  br label %1893

422:                                              ; preds = %405
  %423 = load i64, ptr %339, align 8
  %424 = icmp eq i64 %423, 1
  br i1 %424, label %425, label %543

425:                                              ; preds = %422
  %426 = load ptr, ptr %81, align 8
  %427 = getelementptr inbounds i8, ptr %426, i64 32
  %428 = load i64, ptr %427, align 8
  %429 = add nsw i64 %428, 1
  store i64 %429, ptr %427, align 8
  %430 = load ptr, ptr %76, align 8
  %431 = getelementptr inbounds i8, ptr %430, i64 8
  %432 = load i64, ptr %431, align 8
  %433 = load ptr, ptr %78, align 8
  %434 = load i64, ptr %433, align 8
  %435 = icmp eq i64 %434, 0
  br i1 %435, label %436, label %438

436:                                              ; preds = %425
  %437 = icmp sgt i64 %432, 0
  br i1 %437, label %456, label %454

438:                                              ; preds = %425
  %439 = load ptr, ptr %95, align 8
  store double %378, ptr %439, align 8
  %440 = load i64, ptr %96, align 8
  %441 = icmp sgt i64 %440, 0
  br i1 %441, label %442, label %443

442:                                              ; preds = %438
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %443

443:                                              ; preds = %442, %438
  %444 = load ptr, ptr %78, align 8
  %445 = load i64, ptr %444, align 8
  %446 = load ptr, ptr %97, align 8
  %447 = load ptr, ptr %77, align 8
  %448 = load ptr, ptr %98, align 8
  %449 = load ptr, ptr %99, align 8
  %450 = load ptr, ptr %94, align 8
  %451 = inttoptr i64 %445 to ptr
  %452 = tail call i32 %451(ptr noundef %446, ptr noundef %447, ptr noundef %448, ptr noundef %449, ptr noundef %450) #11
  %453 = sext i32 %452 to i64
  br label %524

454:                                              ; preds = %456, %436
  %455 = icmp sgt i64 %432, 0
  br i1 %455, label %468, label %524

456:                                              ; preds = %436, %456
  %457 = phi i64 [ %463, %456 ], [ 0, %436 ]
  %458 = load ptr, ptr %77, align 8
  %459 = getelementptr inbounds double, ptr %458, i64 %457
  %460 = load double, ptr %459, align 8
  %461 = load ptr, ptr %100, align 8
  %462 = getelementptr inbounds double, ptr %461, i64 %457
  store double %460, ptr %462, align 8
  %463 = add nuw nsw i64 %457, 1
  %464 = icmp eq i64 %463, %432
  br i1 %464, label %454, label %456, !llvm.loop !11

465:                                              ; preds = %522
  %466 = add nuw nsw i64 %470, 1
  %467 = icmp eq i64 %466, %432
  br i1 %467, label %524, label %468, !llvm.loop !12

468:                                              ; preds = %454, %465
  %469 = phi i64 [ %523, %465 ], [ undef, %454 ]
  %470 = phi i64 [ %466, %465 ], [ 0, %454 ]
  %471 = load ptr, ptr %77, align 8
  %472 = getelementptr inbounds double, ptr %471, i64 %470
  %473 = load double, ptr %472, align 8
  %474 = tail call double @llvm.fabs.f64(double %473)
  %475 = fcmp olt double %474, 1.000000e-05
  %476 = select i1 %475, double 1.000000e-05, double %474
  %477 = fmul double %476, 1.500000e-08
  %478 = fadd double %473, %477
  %479 = load ptr, ptr %101, align 8
  %480 = getelementptr inbounds double, ptr %479, i64 %470
  store double %478, ptr %480, align 8
  %481 = load ptr, ptr %81, align 8
  %482 = getelementptr inbounds i8, ptr %481, i64 24
  %483 = load i64, ptr %482, align 8
  %484 = add nsw i64 %483, 1
  store i64 %484, ptr %482, align 8
  %485 = load ptr, ptr %101, align 8
  %486 = load ptr, ptr %102, align 8
  %487 = load ptr, ptr %103, align 8
  store double %378, ptr %487, align 8
  %488 = load i64, ptr %104, align 8
  %489 = icmp sgt i64 %488, 0
  br i1 %489, label %490, label %491

490:                                              ; preds = %468
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %491

491:                                              ; preds = %490, %468
  %492 = load ptr, ptr %76, align 8
  %493 = load i64, ptr %492, align 8
  %494 = load ptr, ptr %103, align 8
  %495 = load ptr, ptr %105, align 8
  %496 = load ptr, ptr %106, align 8
  %497 = inttoptr i64 %493 to ptr
  %498 = tail call i32 %497(ptr noundef %494, ptr noundef %485, ptr noundef %495, ptr noundef %496, ptr noundef %486) #11
  %499 = sext i32 %498 to i64
  %500 = icmp eq i32 %498, 0
  br i1 %500, label %501, label %522

501:                                              ; preds = %491
  %502 = fsub double %478, %473
  br label %506

503:                                              ; preds = %506
  %504 = load ptr, ptr %101, align 8
  %505 = getelementptr inbounds double, ptr %504, i64 %470
  store double %473, ptr %505, align 8
  br label %522

506:                                              ; preds = %501, %506
  %507 = phi i64 [ 0, %501 ], [ %520, %506 ]
  %508 = load ptr, ptr %102, align 8
  %509 = getelementptr inbounds double, ptr %508, i64 %507
  %510 = load double, ptr %509, align 8
  %511 = load ptr, ptr %107, align 8
  %512 = getelementptr inbounds double, ptr %511, i64 %507
  %513 = load double, ptr %512, align 8
  %514 = fsub double %510, %513
  %515 = fdiv double %514, %502
  %516 = load ptr, ptr %94, align 8
  %517 = mul nuw nsw i64 %507, %432
  %518 = getelementptr double, ptr %516, i64 %517
  %519 = getelementptr double, ptr %518, i64 %470
  store double %515, ptr %519, align 8
  %520 = add nuw nsw i64 %507, 1
  %521 = icmp eq i64 %520, %432
  br i1 %521, label %503, label %506, !llvm.loop !13

522:                                              ; preds = %503, %491
  %523 = phi i64 [ %469, %503 ], [ %499, %491 ]
  br i1 %500, label %465, label %524

524:                                              ; preds = %522, %465, %454, %443
  %525 = phi i64 [ %453, %443 ], [ 0, %454 ], [ 0, %465 ], [ %523, %522 ]
  %526 = load i64, ptr %108, align 8
  %527 = icmp sgt i64 %526, 0
  br i1 %527, label %528, label %540

528:                                              ; preds = %524, %536
  %529 = phi i64 [ %537, %536 ], [ 0, %524 ]
  %530 = load ptr, ptr %94, align 8
  %531 = getelementptr inbounds double, ptr %530, i64 %529
  %532 = load double, ptr %531, align 8
  %533 = tail call double @llvm.fabs.f64(double %532)
  %534 = fcmp ueq double %533, 0x7FF0000000000000
  br i1 %534, label %535, label %536

535:                                              ; preds = %528
  store double 0.000000e+00, ptr %531, align 8
  br label %536

536:                                              ; preds = %535, %528
  %537 = add nuw nsw i64 %529, 1
  %538 = load i64, ptr %108, align 8
  %539 = icmp slt i64 %537, %538
  br i1 %539, label %528, label %540, !llvm.loop !14

540:                                              ; preds = %536, %524
  %541 = icmp slt i64 %525, 0
  br i1 %541, label %1893, label %542

542:                                              ; preds = %540
  store i64 0, ptr %339, align 8
  store i64 1, ptr %340, align 8
  store i64 0, ptr %341, align 8
  br label %543

543:                                              ; preds = %542, %422
  %544 = load i64, ptr %342, align 8
  %545 = icmp eq i64 %544, 0
  br i1 %545, label %549, label %546

546:                                              ; preds = %543
  %547 = load double, ptr %189, align 8
  %548 = fcmp une double %414, %547
  br i1 %548, label %549, label %612

549:                                              ; preds = %546, %543
  %550 = load i64, ptr %343, align 8
  %551 = add nsw i64 %550, 1
  store i64 %551, ptr %343, align 8
  %552 = load i64, ptr %110, align 8
  %553 = load ptr, ptr %111, align 8
  %554 = load ptr, ptr %112, align 8
  %555 = icmp sgt i64 %552, 0
  br i1 %555, label %556, label %564

556:                                              ; preds = %549
  %557 = fdiv double 0x400D1A48D83E731D, %414
  %558 = add nuw i64 %552, 1
  %559 = fdiv double 0x400572DB93E0C672, %414
  %560 = fdiv double 0x40086747F2C3FCB6, %414
  br label %561

561:                                              ; preds = %556, %568
  %562 = phi i64 [ 0, %556 ], [ %579, %568 ]
  %563 = mul nuw nsw i64 %562, %552
  br label %581

564:                                              ; preds = %568, %549
  %565 = load ptr, ptr %109, align 8
  %566 = tail call fastcc i32 @real_factorise(ptr noundef %553, i64 noundef %552, ptr noundef %565) #10
  %567 = icmp eq i32 %566, 0
  br i1 %567, label %602, label %597

568:                                              ; preds = %581
  %569 = mul i64 %562, %558
  %570 = getelementptr inbounds double, ptr %553, i64 %569
  %571 = load double, ptr %570, align 8
  %572 = fadd double %557, %571
  store double %572, ptr %570, align 8
  %573 = getelementptr inbounds { double, double }, ptr %554, i64 %569
  %574 = load double, ptr %573, align 8
  %575 = getelementptr inbounds i8, ptr %573, i64 8
  %576 = load double, ptr %575, align 8
  %577 = fadd double %559, %574
  %578 = fsub double %576, %560
  store double %577, ptr %573, align 8
  store double %578, ptr %575, align 8
  %579 = add nuw nsw i64 %562, 1
  %580 = icmp eq i64 %579, %552
  br i1 %580, label %564, label %561, !llvm.loop !15

581:                                              ; preds = %561, %581
  %582 = phi i64 [ 0, %561 ], [ %595, %581 ]
  %583 = load ptr, ptr %113, align 8
  %584 = add nuw nsw i64 %582, %563
  %585 = getelementptr inbounds double, ptr %583, i64 %584
  %586 = load double, ptr %585, align 8
  %587 = fneg double %586
  %588 = getelementptr inbounds double, ptr %553, i64 %584
  store double %587, ptr %588, align 8
  %589 = load ptr, ptr %113, align 8
  %590 = getelementptr inbounds double, ptr %589, i64 %584
  %591 = load double, ptr %590, align 8
  %592 = fneg double %591
  %593 = getelementptr inbounds { double, double }, ptr %554, i64 %584
  %594 = getelementptr inbounds i8, ptr %593, i64 8
  store double %592, ptr %593, align 8
  store double 0.000000e+00, ptr %594, align 8
  %595 = add nuw nsw i64 %582, 1
  %596 = icmp eq i64 %595, %552
  br i1 %596, label %568, label %581, !llvm.loop !16

597:                                              ; preds = %564
  %598 = load ptr, ptr %114, align 8
  %599 = tail call fastcc i32 @pair_factorise(ptr noundef %554, i64 noundef %552, ptr noundef %598) #10
  %600 = icmp ne i32 %599, 0
  %601 = zext i1 %600 to i32
  br label %602

602:                                              ; preds = %564, %597
  %603 = phi i32 [ 0, %564 ], [ %601, %597 ]
  %604 = icmp eq i32 %603, 0
  br i1 %604, label %605, label %611

605:                                              ; preds = %602
  store i64 4, ptr %367, align 8
  %606 = load i64, ptr %336, align 8
  %607 = add nsw i64 %606, 1
  store i64 %607, ptr %336, align 8
  %608 = fmul double %414, 5.000000e-01
  %609 = load i64, ptr %368, align 8
  %610 = sub nsw i64 1, %609
  store i64 %610, ptr %339, align 8
  store i64 0, ptr %342, align 8
  br label %1893, !llvm.loop !17

611:                                              ; preds = %602
  store i64 1, ptr %342, align 8
  store double %414, ptr %189, align 8
  br label %612

612:                                              ; preds = %611, %546
  %613 = load double, ptr %344, align 8
  %614 = load ptr, ptr %76, align 8
  %615 = getelementptr inbounds i8, ptr %614, i64 8
  %616 = load i64, ptr %615, align 8
  %617 = load ptr, ptr %115, align 8
  %618 = load ptr, ptr %77, align 8
  %619 = load ptr, ptr %116, align 8
  %620 = load ptr, ptr %117, align 8
  %621 = fcmp ogt double %613, 0.000000e+00
  %622 = icmp sgt i64 %616, 0
  %623 = shl i64 %616, 4
  %624 = getelementptr i8, ptr %617, i64 %623
  %625 = mul i64 %616, 24
  %626 = getelementptr i8, ptr %617, i64 %625
  %627 = getelementptr double, ptr %617, i64 %616
  br label %633

628:                                              ; preds = %647
  %629 = icmp sgt i64 %616, 0
  %630 = getelementptr double, ptr %619, i64 %616
  %631 = shl i64 %616, 4
  %632 = getelementptr i8, ptr %619, i64 %631
  br label %674

633:                                              ; preds = %612, %647
  %634 = phi i64 [ 0, %612 ], [ %648, %647 ]
  br i1 %621, label %635, label %641

635:                                              ; preds = %633
  %636 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %634
  %637 = load double, ptr %636, align 8
  %638 = fmul double %414, %637
  %639 = fdiv double %638, %613
  %640 = fadd double %639, 1.000000e+00
  br label %641

641:                                              ; preds = %635, %633
  %642 = phi double [ %640, %635 ], [ 0.000000e+00, %633 ]
  br i1 %622, label %643, label %647

643:                                              ; preds = %641
  %644 = mul nuw nsw i64 %616, %634
  %645 = getelementptr double, ptr %619, i64 %644
  %646 = fsub double 1.000000e+00, %642
  br label %650

647:                                              ; preds = %671, %641
  %648 = add nuw nsw i64 %634, 1
  %649 = icmp eq i64 %648, 3
  br i1 %649, label %628, label %633, !llvm.loop !18

650:                                              ; preds = %643, %671
  %651 = phi i64 [ 0, %643 ], [ %672, %671 ]
  %652 = getelementptr double, ptr %645, i64 %651
  store double 0.000000e+00, ptr %652, align 8
  br i1 %621, label %653, label %671

653:                                              ; preds = %650
  %654 = getelementptr double, ptr %624, i64 %651
  %655 = load double, ptr %654, align 8
  %656 = getelementptr double, ptr %626, i64 %651
  %657 = load double, ptr %656, align 8
  %658 = fmul double %642, %657
  %659 = fadd double %655, %658
  %660 = fmul double %646, %659
  %661 = getelementptr inbounds double, ptr %617, i64 %651
  %662 = load double, ptr %661, align 8
  %663 = getelementptr double, ptr %627, i64 %651
  %664 = load double, ptr %663, align 8
  %665 = fadd double %664, %660
  %666 = fmul double %642, %665
  %667 = fadd double %662, %666
  %668 = getelementptr inbounds double, ptr %618, i64 %651
  %669 = load double, ptr %668, align 8
  %670 = fsub double %667, %669
  store double %670, ptr %652, align 8
  br label %671

671:                                              ; preds = %653, %650
  %672 = add nuw nsw i64 %651, 1
  %673 = icmp eq i64 %672, %616
  br i1 %673, label %647, label %650, !llvm.loop !19

674:                                              ; preds = %628, %685
  %675 = phi i64 [ 0, %628 ], [ %686, %685 ]
  br i1 %629, label %676, label %685

676:                                              ; preds = %674
  %677 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %675
  %678 = load double, ptr %677, align 8
  %679 = getelementptr inbounds i8, ptr %677, i64 8
  %680 = load double, ptr %679, align 8
  %681 = getelementptr inbounds i8, ptr %677, i64 16
  %682 = load double, ptr %681, align 8
  %683 = mul nuw nsw i64 %616, %675
  %684 = getelementptr double, ptr %620, i64 %683
  br label %688

685:                                              ; preds = %688, %674
  %686 = add nuw nsw i64 %675, 1
  %687 = icmp eq i64 %686, 3
  br i1 %687, label %704, label %674, !llvm.loop !20

688:                                              ; preds = %676, %688
  %689 = phi i64 [ 0, %676 ], [ %702, %688 ]
  %690 = getelementptr inbounds double, ptr %619, i64 %689
  %691 = load double, ptr %690, align 8
  %692 = fmul double %678, %691
  %693 = getelementptr double, ptr %630, i64 %689
  %694 = load double, ptr %693, align 8
  %695 = fmul double %680, %694
  %696 = fadd double %692, %695
  %697 = getelementptr double, ptr %632, i64 %689
  %698 = load double, ptr %697, align 8
  %699 = fmul double %682, %698
  %700 = fadd double %696, %699
  %701 = getelementptr double, ptr %684, i64 %689
  store double %700, ptr %701, align 8
  %702 = add nuw nsw i64 %689, 1
  %703 = icmp eq i64 %702, %616
  br i1 %703, label %685, label %688, !llvm.loop !21

704:                                              ; preds = %685
  %705 = load ptr, ptr %76, align 8, !noalias !22
  %706 = getelementptr inbounds i8, ptr %705, i64 8
  %707 = load i64, ptr %706, align 8, !noalias !22
  %708 = load ptr, ptr %78, align 8, !noalias !22
  %709 = getelementptr inbounds i8, ptr %708, i64 40
  %710 = load i64, ptr %709, align 8, !noalias !22
  %711 = load ptr, ptr %116, align 8, !noalias !22
  %712 = load ptr, ptr %117, align 8, !noalias !22
  %713 = load ptr, ptr %118, align 8, !noalias !22
  %714 = load ptr, ptr %119, align 8, !noalias !22
  %715 = load ptr, ptr %120, align 8, !noalias !22
  %716 = icmp sgt i64 %710, 0
  %717 = select i1 %716, i64 10, i64 6
  %718 = icmp sgt i64 %707, 0
  %719 = fdiv double 0x400D1A48D83E731D, %414
  %720 = fdiv double 0x400572DB93E0C672, %414
  %721 = fdiv double 0xC0086747F2C3FCB6, %414
  %722 = icmp sgt i64 %707, 0
  %723 = getelementptr double, ptr %712, i64 %707
  %724 = shl i64 %707, 4
  %725 = getelementptr i8, ptr %712, i64 %724
  %726 = icmp eq i64 %710, 0
  br label %727

727:                                              ; preds = %704, %1130
  %728 = phi double [ -1.000000e+00, %704 ], [ %1129, %1130 ]
  %729 = phi double [ 0.000000e+00, %704 ], [ %1128, %1130 ]
  %730 = phi i64 [ 0, %704 ], [ %1127, %1130 ]
  %731 = phi i64 [ 0, %704 ], [ %1131, %1130 ]
  %732 = phi i64 [ %380, %704 ], [ %1124, %1130 ]
  %733 = phi i64 [ %381, %704 ], [ %1123, %1130 ]
  %734 = phi i32 [ %382, %704 ], [ %1122, %1130 ]
  %735 = phi double [ %383, %704 ], [ %1121, %1130 ]
  %736 = icmp ugt i64 %731, 5
  %737 = icmp eq i64 %730, 0
  %738 = select i1 %736, i1 %737, i1 false
  br i1 %738, label %1133, label %743

739:                                              ; preds = %765
  %740 = add nuw nsw i64 %744, 1
  %741 = icmp ugt i64 %744, 1
  %742 = icmp eq i64 %740, 3
  br i1 %742, label %788, label %743, !llvm.loop !25

743:                                              ; preds = %727, %739
  %744 = phi i64 [ %740, %739 ], [ 0, %727 ]
  %745 = phi i1 [ %741, %739 ], [ false, %727 ]
  br i1 %718, label %746, label %749

746:                                              ; preds = %743
  %747 = mul nuw nsw i64 %707, %744
  %748 = getelementptr double, ptr %711, i64 %747
  br label %774

749:                                              ; preds = %774, %743
  %750 = load ptr, ptr %81, align 8, !noalias !22
  %751 = getelementptr inbounds i8, ptr %750, i64 24
  %752 = load i64, ptr %751, align 8, !noalias !22
  %753 = add nsw i64 %752, 1
  store i64 %753, ptr %751, align 8, !noalias !22
  %754 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %744
  %755 = load double, ptr %754, align 8, !noalias !22
  %756 = fmul double %414, %755
  %757 = fadd double %378, %756
  %758 = load ptr, ptr %121, align 8, !noalias !22
  %759 = mul nsw i64 %707, %744
  %760 = getelementptr inbounds double, ptr %713, i64 %759
  %761 = load ptr, ptr %122, align 8, !noalias !22
  store double %757, ptr %761, align 8, !noalias !22
  %762 = load i64, ptr %123, align 8, !noalias !22
  %763 = icmp sgt i64 %762, 0
  br i1 %763, label %764, label %765

764:                                              ; preds = %749
  tail call fastcc void @sample(ptr noundef nonnull %76) #10, !noalias !22
  br label %765

765:                                              ; preds = %749, %764
  %766 = load ptr, ptr %76, align 8, !noalias !22
  %767 = load i64, ptr %766, align 8, !noalias !22
  %768 = load ptr, ptr %122, align 8, !noalias !22
  %769 = load ptr, ptr %125, align 8, !noalias !22
  %770 = load ptr, ptr %126, align 8, !noalias !22
  %771 = inttoptr i64 %767 to ptr
  %772 = tail call i32 %771(ptr noundef %768, ptr noundef %758, ptr noundef %769, ptr noundef %770, ptr noundef %760) #11, !noalias !22
  %773 = icmp eq i32 %772, 0
  br i1 %773, label %739, label %786

774:                                              ; preds = %746, %774
  %775 = phi i64 [ 0, %746 ], [ %784, %774 ]
  %776 = load ptr, ptr %77, align 8, !noalias !22
  %777 = getelementptr inbounds double, ptr %776, i64 %775
  %778 = load double, ptr %777, align 8, !noalias !22
  %779 = getelementptr double, ptr %748, i64 %775
  %780 = load double, ptr %779, align 8, !noalias !22
  %781 = fadd double %778, %780
  %782 = load ptr, ptr %124, align 8, !noalias !22
  %783 = getelementptr inbounds double, ptr %782, i64 %775
  store double %781, ptr %783, align 8, !noalias !22
  %784 = add nuw nsw i64 %775, 1
  %785 = icmp eq i64 %784, %707
  br i1 %785, label %749, label %774, !llvm.loop !26

786:                                              ; preds = %765
  %787 = sext i32 %772 to i64
  br label %788

788:                                              ; preds = %739, %786
  %789 = phi i1 [ %745, %786 ], [ %741, %739 ]
  %790 = phi double [ 0.000000e+00, %786 ], [ %735, %739 ]
  %791 = phi i32 [ 0, %786 ], [ %734, %739 ]
  %792 = phi i64 [ %731, %786 ], [ %733, %739 ]
  %793 = phi i64 [ %787, %786 ], [ %732, %739 ]
  %794 = phi i32 [ 1, %786 ], [ 5, %739 ]
  br i1 %789, label %795, label %1133

795:                                              ; preds = %788
  %796 = load ptr, ptr %76, align 8, !noalias !22
  %797 = getelementptr inbounds i8, ptr %796, i64 8
  %798 = load i64, ptr %797, align 8, !noalias !22
  %799 = load ptr, ptr %118, align 8, !noalias !22
  %800 = load ptr, ptr %117, align 8, !noalias !22
  %801 = load ptr, ptr %119, align 8, !noalias !22
  %802 = load ptr, ptr %120, align 8, !noalias !22
  %803 = icmp sgt i64 %798, 0
  br i1 %803, label %804, label %909

804:                                              ; preds = %795
  %805 = shl nuw nsw i64 %798, 1
  %806 = getelementptr double, ptr %799, i64 %798
  %807 = shl i64 %798, 4
  %808 = getelementptr i8, ptr %799, i64 %807
  %809 = load double, ptr %799, align 8, !noalias !22
  %810 = getelementptr inbounds double, ptr %799, i64 %798
  %811 = load double, ptr %810, align 8, !noalias !22
  %812 = fadd double %809, %811
  %813 = getelementptr inbounds double, ptr %799, i64 %805
  %814 = load double, ptr %813, align 8, !noalias !22
  %815 = fadd double %812, %814
  %816 = tail call double @llvm.fabs.f64(double %815)
  %817 = fcmp ueq double %816, 0x7FF0000000000000
  br i1 %817, label %906, label %818

818:                                              ; preds = %804
  %819 = getelementptr double, ptr %800, i64 %798
  %820 = getelementptr inbounds double, ptr %800, i64 %805
  %821 = getelementptr double, ptr %799, i64 %798
  %822 = getelementptr inbounds double, ptr %799, i64 %805
  br label %834

823:                                              ; preds = %834
  %824 = getelementptr inbounds double, ptr %799, i64 %902
  %825 = load double, ptr %824, align 8, !noalias !22
  %826 = getelementptr double, ptr %821, i64 %902
  %827 = load double, ptr %826, align 8, !noalias !22
  %828 = fadd double %825, %827
  %829 = getelementptr inbounds double, ptr %822, i64 %902
  %830 = load double, ptr %829, align 8, !noalias !22
  %831 = fadd double %828, %830
  %832 = tail call double @llvm.fabs.f64(double %831)
  %833 = fcmp ueq double %832, 0x7FF0000000000000
  br i1 %833, label %904, label %834, !llvm.loop !27

834:                                              ; preds = %818, %823
  %835 = phi double [ %825, %823 ], [ %809, %818 ]
  %836 = phi double [ %901, %823 ], [ 0.000000e+00, %818 ]
  %837 = phi i64 [ %902, %823 ], [ 0, %818 ]
  %838 = getelementptr inbounds double, ptr %799, i64 %837
  %839 = fmul double %835, 0x4010B70201A79C46
  %840 = getelementptr double, ptr %806, i64 %837
  %841 = load double, ptr %840, align 8, !noalias !22
  %842 = fmul double %841, 0x3FD4F8C15DA84E86
  %843 = fadd double %839, %842
  %844 = getelementptr double, ptr %808, i64 %837
  %845 = load double, ptr %844, align 8, !noalias !22
  %846 = fmul double %845, 0x3FE0BF7FF59D56EF
  %847 = fadd double %843, %846
  %848 = getelementptr inbounds double, ptr %800, i64 %837
  %849 = load double, ptr %848, align 8, !noalias !22
  %850 = fmul double %719, %849
  %851 = fsub double %847, %850
  %852 = getelementptr inbounds double, ptr %801, i64 %837
  store double %851, ptr %852, align 8, !noalias !22
  %853 = load double, ptr %838, align 8, !noalias !22
  %854 = fmul double %853, 0xC010B70201A79C46
  %855 = load double, ptr %840, align 8, !noalias !22
  %856 = fmul double %855, 0x3FD4F8C15DA84E86
  %857 = fsub double %854, %856
  %858 = load double, ptr %844, align 8, !noalias !22
  %859 = fmul double %858, 0x3FDE810014C55221
  %860 = fadd double %857, %859
  %861 = fmul double %853, 0x3FE017885A24A7F2
  %862 = fmul double %855, 0x4004934E6FCAA598
  %863 = fsub double %861, %862
  %864 = fmul double %858, 0x3FE312C0CF7BDFD1
  %865 = fadd double %863, %864
  %866 = getelementptr double, ptr %819, i64 %837
  %867 = load double, ptr %866, align 8, !noalias !22
  %868 = getelementptr inbounds double, ptr %820, i64 %837
  %869 = load double, ptr %868, align 8, !noalias !22
  %870 = fmul double %720, %867
  %871 = fmul double %721, %869
  %872 = fmul double %720, %869
  %873 = fmul double %721, %867
  %874 = fsub double %870, %871
  %875 = fadd double %873, %872
  %876 = fsub double %860, %874
  %877 = fsub double %865, %875
  %878 = getelementptr inbounds { double, double }, ptr %802, i64 %837
  %879 = getelementptr inbounds i8, ptr %878, i64 8
  store double %876, ptr %878, align 8, !noalias !22
  store double %877, ptr %879, align 8, !noalias !22
  %880 = load double, ptr %852, align 8, !noalias !22
  %881 = tail call double @llvm.fabs.f64(double %880)
  %882 = tail call double @llvm.fabs.f64(double %876)
  %883 = fadd double %881, %882
  %884 = tail call double @llvm.fabs.f64(double %877)
  %885 = fadd double %884, %883
  %886 = fmul double %414, %885
  %887 = load ptr, ptr %77, align 8, !noalias !22
  %888 = getelementptr inbounds double, ptr %887, i64 %837
  %889 = load double, ptr %888, align 8, !noalias !22
  %890 = load ptr, ptr %127, align 8, !noalias !22
  %891 = getelementptr inbounds double, ptr %890, i64 %837
  %892 = load double, ptr %891, align 8, !noalias !22
  %893 = load ptr, ptr %128, align 8, !noalias !22
  %894 = getelementptr inbounds double, ptr %893, i64 %837
  %895 = load double, ptr %894, align 8, !noalias !22
  %896 = tail call double @llvm.fabs.f64(double %889)
  %897 = fmul double %896, %895
  %898 = fadd double %892, %897
  %899 = fdiv double %886, %898
  %900 = fmul double %899, %899
  %901 = fadd double %836, %900
  %902 = add nuw nsw i64 %837, 1
  %903 = icmp eq i64 %902, %798
  br i1 %903, label %909, label %823, !llvm.loop !27

904:                                              ; preds = %823
  %905 = icmp slt i64 %902, %798
  br label %906

906:                                              ; preds = %904, %804
  %907 = phi i1 [ %905, %904 ], [ %803, %804 ]
  %908 = phi double [ %901, %904 ], [ 0.000000e+00, %804 ]
  br i1 %907, label %1133, label %909

909:                                              ; preds = %834, %795, %906
  %910 = phi double [ %908, %906 ], [ 0.000000e+00, %795 ], [ %901, %834 ]
  %911 = load ptr, ptr %76, align 8, !noalias !22
  %912 = getelementptr inbounds i8, ptr %911, i64 8
  %913 = load i64, ptr %912, align 8, !noalias !22
  %914 = load i64, ptr %130, align 8, !noalias !22
  %915 = load ptr, ptr %78, align 8, !noalias !22
  %916 = getelementptr inbounds i8, ptr %915, i64 40
  %917 = load i64, ptr %916, align 8, !noalias !22
  %918 = load ptr, ptr %119, align 8, !noalias !22
  %919 = load ptr, ptr %120, align 8, !noalias !22
  %920 = load ptr, ptr %131, align 8, !noalias !22
  %921 = load ptr, ptr %129, align 8, !noalias !22
  tail call fastcc void @real_solve(ptr noundef %920, i64 noundef %914, ptr noundef %921, ptr noundef %918) #10, !noalias !22
  %922 = load ptr, ptr %132, align 8, !noalias !22
  %923 = load ptr, ptr %133, align 8, !noalias !22
  tail call fastcc void @pair_solve(ptr noundef %922, i64 noundef %914, ptr noundef %923, ptr noundef %919) #10, !noalias !22
  %924 = icmp sgt i64 %917, 0
  br i1 %924, label %925, label %930

925:                                              ; preds = %909
  %926 = load ptr, ptr %131, align 8, !noalias !22
  %927 = load ptr, ptr %129, align 8, !noalias !22
  tail call fastcc void @real_solve_columns(ptr noundef %926, i64 noundef %914, ptr noundef %927, ptr noundef %918, i64 noundef %917) #10, !noalias !22
  %928 = load ptr, ptr %132, align 8, !noalias !22
  %929 = load ptr, ptr %133, align 8, !noalias !22
  tail call fastcc void @pair_solve_columns(ptr noundef %928, i64 noundef %914, ptr noundef %929, ptr noundef %919, i64 noundef %917) #10, !noalias !22
  br label %930

930:                                              ; preds = %925, %909
  %931 = icmp sgt i64 %913, 0
  br i1 %931, label %932, label %965

932:                                              ; preds = %930
  %933 = load ptr, ptr %77, align 8, !noalias !22
  %934 = load ptr, ptr %134, align 8, !noalias !22
  %935 = load ptr, ptr %135, align 8, !noalias !22
  br label %936

936:                                              ; preds = %932, %936
  %937 = phi double [ 0.000000e+00, %932 ], [ %962, %936 ]
  %938 = phi i64 [ 0, %932 ], [ %963, %936 ]
  %939 = getelementptr inbounds double, ptr %933, i64 %938
  %940 = load double, ptr %939, align 8, !noalias !22
  %941 = getelementptr inbounds double, ptr %934, i64 %938
  %942 = load double, ptr %941, align 8, !noalias !22
  %943 = getelementptr inbounds double, ptr %935, i64 %938
  %944 = load double, ptr %943, align 8, !noalias !22
  %945 = tail call double @llvm.fabs.f64(double %940)
  %946 = fmul double %945, %944
  %947 = fadd double %942, %946
  %948 = getelementptr inbounds double, ptr %918, i64 %938
  %949 = load double, ptr %948, align 8, !noalias !22
  %950 = fdiv double %949, %947
  %951 = getelementptr inbounds { double, double }, ptr %919, i64 %938
  %952 = load double, ptr %951, align 8, !noalias !22
  %953 = getelementptr inbounds i8, ptr %951, i64 8
  %954 = fdiv double %952, %947
  %955 = load double, ptr %953, align 8, !noalias !22
  %956 = fdiv double %955, %947
  %957 = fmul double %950, %950
  %958 = fmul double %954, %954
  %959 = fadd double %957, %958
  %960 = fmul double %956, %956
  %961 = fadd double %959, %960
  %962 = fadd double %937, %961
  %963 = add nuw nsw i64 %938, 1
  %964 = icmp eq i64 %963, %913
  br i1 %964, label %965, label %936, !llvm.loop !28

965:                                              ; preds = %936, %930
  %966 = phi double [ 0.000000e+00, %930 ], [ %962, %936 ]
  %967 = mul nsw i64 %913, 3
  %968 = sitofp i64 %967 to double
  %969 = fdiv double %966, %968
  %970 = tail call double @llvm.sqrt.f64(double %969)
  %971 = fcmp oeq double %970, 0.000000e+00
  %972 = fcmp ogt double %910, 0.000000e+00
  %973 = select i1 %971, i1 %972, i1 false
  br i1 %973, label %974, label %976

974:                                              ; preds = %965
  %975 = add nuw nsw i64 %731, 1
  br label %1120

976:                                              ; preds = %965
  %977 = fcmp ogt double %728, 0.000000e+00
  %978 = select i1 %977, i1 %737, i1 false
  br i1 %978, label %979, label %992

979:                                              ; preds = %976
  %980 = fdiv double %970, %728
  %981 = fcmp ult double %980, 1.000000e+00
  br i1 %981, label %982, label %990

982:                                              ; preds = %979
  %983 = sub nsw i64 5, %731
  %984 = sitofp i64 %983 to double
  %985 = tail call double @llvm.pow.f64(double %980, double %984)
  %986 = fsub double 1.000000e+00, %980
  %987 = fdiv double %985, %986
  %988 = fmul double %970, %987
  %989 = fcmp ogt double %988, %223
  br i1 %989, label %990, label %992

990:                                              ; preds = %982, %979
  %991 = add nuw nsw i64 %731, 1
  br label %1120

992:                                              ; preds = %982, %976
  %993 = phi double [ %729, %976 ], [ %980, %982 ]
  br i1 %722, label %1005, label %994

994:                                              ; preds = %1023, %992
  %995 = fsub double 1.000000e+00, %993
  %996 = fdiv double %993, %995
  %997 = fmul double %970, %996
  %998 = fcmp olt double %997, %223
  %999 = select i1 %977, i1 %998, i1 false
  %1000 = select i1 %971, i1 true, i1 %999
  %1001 = add nuw nsw i64 %731, 1
  %1002 = select i1 %1000, i64 %1001, i64 0
  %1003 = select i1 %737, i64 %1002, i64 %730
  %1004 = icmp sgt i64 %1003, 0
  br i1 %1004, label %1046, label %1119

1005:                                             ; preds = %992, %1023
  %1006 = phi i64 [ %1024, %1023 ], [ 0, %992 ]
  %1007 = getelementptr inbounds double, ptr %714, i64 %1006
  %1008 = load double, ptr %1007, align 8, !noalias !22
  %1009 = getelementptr inbounds double, ptr %712, i64 %1006
  %1010 = load double, ptr %1009, align 8, !noalias !22
  %1011 = fadd double %1008, %1010
  store double %1011, ptr %1009, align 8, !noalias !22
  %1012 = getelementptr inbounds { double, double }, ptr %715, i64 %1006
  %1013 = load double, ptr %1012, align 8, !noalias !22
  %1014 = getelementptr inbounds i8, ptr %1012, i64 8
  %1015 = getelementptr double, ptr %723, i64 %1006
  %1016 = load double, ptr %1015, align 8, !noalias !22
  %1017 = fadd double %1013, %1016
  store double %1017, ptr %1015, align 8, !noalias !22
  %1018 = load double, ptr %1014, align 8, !noalias !22
  %1019 = getelementptr double, ptr %725, i64 %1006
  %1020 = load double, ptr %1019, align 8, !noalias !22
  %1021 = fadd double %1018, %1020
  store double %1021, ptr %1019, align 8, !noalias !22
  %1022 = getelementptr double, ptr %711, i64 %1006
  br label %1026

1023:                                             ; preds = %1026
  %1024 = add nuw nsw i64 %1006, 1
  %1025 = icmp eq i64 %1024, %707
  br i1 %1025, label %994, label %1005, !llvm.loop !29

1026:                                             ; preds = %1005, %1026
  %1027 = phi i64 [ 0, %1005 ], [ %1044, %1026 ]
  %1028 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1027
  %1029 = load double, ptr %1028, align 8, !noalias !22
  %1030 = load double, ptr %1009, align 8, !noalias !22
  %1031 = fmul double %1029, %1030
  %1032 = getelementptr inbounds i8, ptr %1028, i64 8
  %1033 = load double, ptr %1032, align 8, !noalias !22
  %1034 = load double, ptr %1015, align 8, !noalias !22
  %1035 = fmul double %1033, %1034
  %1036 = fadd double %1031, %1035
  %1037 = getelementptr inbounds i8, ptr %1028, i64 16
  %1038 = load double, ptr %1037, align 8, !noalias !22
  %1039 = load double, ptr %1019, align 8, !noalias !22
  %1040 = fmul double %1038, %1039
  %1041 = fadd double %1036, %1040
  %1042 = mul nuw nsw i64 %707, %1027
  %1043 = getelementptr double, ptr %1022, i64 %1042
  store double %1041, ptr %1043, align 8, !noalias !22
  %1044 = add nuw nsw i64 %1027, 1
  %1045 = icmp eq i64 %1044, 3
  br i1 %1045, label %1023, label %1026, !llvm.loop !30

1046:                                             ; preds = %994
  br i1 %726, label %1120, label %1047

1047:                                             ; preds = %1046
  %1048 = load i64, ptr %136, align 8, !noalias !22
  %1049 = load ptr, ptr %78, align 8, !noalias !22
  %1050 = getelementptr inbounds i8, ptr %1049, i64 40
  %1051 = load i64, ptr %1050, align 8, !noalias !22
  %1052 = load ptr, ptr %139, align 8, !noalias !22
  %1053 = load ptr, ptr %137, align 8, !noalias !22
  %1054 = load ptr, ptr %140, align 8, !noalias !22
  %1055 = icmp sgt i64 %1051, 0
  br i1 %1055, label %1056, label %1116

1056:                                             ; preds = %1047
  %1057 = load i64, ptr %138, align 8, !noalias !22
  %1058 = icmp sgt i64 %1048, 0
  %1059 = getelementptr double, ptr %1053, i64 %1057
  %1060 = shl i64 %1057, 4
  %1061 = getelementptr i8, ptr %1053, i64 %1060
  br label %1062

1062:                                             ; preds = %1056, %1112
  %1063 = phi double [ 0.000000e+00, %1056 ], [ %1113, %1112 ]
  %1064 = phi i64 [ 0, %1056 ], [ %1114, %1112 ]
  br i1 %1058, label %1065, label %1068

1065:                                             ; preds = %1062
  %1066 = add nuw i64 %1064, %1048
  %1067 = load ptr, ptr %77, align 8, !noalias !22
  br label %1073

1068:                                             ; preds = %1073, %1062
  %1069 = phi double [ 0.000000e+00, %1062 ], [ %1105, %1073 ]
  %1070 = phi double [ 0.000000e+00, %1062 ], [ %1089, %1073 ]
  %1071 = fmul double %1063, %1069
  %1072 = fcmp ogt double %1070, %1071
  br i1 %1072, label %1108, label %1112

1073:                                             ; preds = %1065, %1073
  %1074 = phi double [ 0.000000e+00, %1065 ], [ %1089, %1073 ]
  %1075 = phi double [ 0.000000e+00, %1065 ], [ %1105, %1073 ]
  %1076 = phi i64 [ 0, %1065 ], [ %1106, %1073 ]
  %1077 = mul nuw nsw i64 %1076, %1051
  %1078 = add i64 %1066, %1077
  %1079 = getelementptr inbounds double, ptr %1052, i64 %1078
  %1080 = load double, ptr %1079, align 8, !noalias !22
  %1081 = fmul double %1080, %1080
  %1082 = getelementptr inbounds { double, double }, ptr %1054, i64 %1078
  %1083 = load double, ptr %1082, align 8, !noalias !22
  %1084 = getelementptr inbounds i8, ptr %1082, i64 8
  %1085 = load double, ptr %1084, align 8, !noalias !22
  %1086 = tail call double @hypot(double noundef %1083, double noundef %1085) #13
  %1087 = fmul double %1086, %1086
  %1088 = fadd double %1081, %1087
  %1089 = fadd double %1074, %1088
  %1090 = getelementptr inbounds double, ptr %1067, i64 %1078
  %1091 = load double, ptr %1090, align 8, !noalias !22
  %1092 = fmul double %1091, %1091
  %1093 = fadd double %1075, %1092
  %1094 = getelementptr inbounds double, ptr %1053, i64 %1078
  %1095 = load double, ptr %1094, align 8, !noalias !22
  %1096 = fmul double %1095, %1095
  %1097 = getelementptr double, ptr %1059, i64 %1078
  %1098 = load double, ptr %1097, align 8, !noalias !22
  %1099 = fmul double %1098, %1098
  %1100 = fadd double %1096, %1099
  %1101 = getelementptr double, ptr %1061, i64 %1078
  %1102 = load double, ptr %1101, align 8, !noalias !22
  %1103 = fmul double %1102, %1102
  %1104 = fadd double %1100, %1103
  %1105 = fadd double %1093, %1104
  %1106 = add nuw nsw i64 %1076, 1
  %1107 = icmp eq i64 %1106, %1048
  br i1 %1107, label %1068, label %1073, !llvm.loop !31

1108:                                             ; preds = %1068
  %1109 = fcmp ogt double %1069, 0.000000e+00
  %1110 = fdiv double %1070, %1069
  %1111 = select i1 %1109, double %1110, double 1.000000e+00
  br label %1112

1112:                                             ; preds = %1108, %1068
  %1113 = phi double [ %1111, %1108 ], [ %1063, %1068 ]
  %1114 = add nuw nsw i64 %1064, 1
  %1115 = icmp eq i64 %1114, %1051
  br i1 %1115, label %1116, label %1062, !llvm.loop !32

1116:                                             ; preds = %1112, %1047
  %1117 = phi double [ 0.000000e+00, %1047 ], [ %1113, %1112 ]
  %1118 = fcmp ugt double %1117, %346
  br i1 %1118, label %1119, label %1120

1119:                                             ; preds = %1116, %994
  br label %1120

1120:                                             ; preds = %1119, %1116, %1046, %990, %974
  %1121 = phi double [ %729, %974 ], [ %980, %990 ], [ %790, %1046 ], [ %790, %1119 ], [ %790, %1116 ]
  %1122 = phi i32 [ 0, %974 ], [ 0, %990 ], [ %791, %1046 ], [ %791, %1119 ], [ %791, %1116 ]
  %1123 = phi i64 [ %975, %974 ], [ %991, %990 ], [ %792, %1046 ], [ %792, %1119 ], [ %792, %1116 ]
  %1124 = phi i64 [ 0, %974 ], [ 0, %990 ], [ %793, %1046 ], [ %793, %1119 ], [ %793, %1116 ]
  %1125 = phi i1 [ false, %974 ], [ false, %990 ], [ false, %1046 ], [ true, %1119 ], [ false, %1116 ]
  %1126 = phi i32 [ 1, %974 ], [ 1, %990 ], [ 2, %1046 ], [ 0, %1119 ], [ 2, %1116 ]
  %1127 = phi i64 [ %730, %974 ], [ 0, %990 ], [ %1003, %1046 ], [ %1003, %1119 ], [ %1003, %1116 ]
  %1128 = phi double [ %729, %974 ], [ %980, %990 ], [ %993, %1046 ], [ %993, %1119 ], [ %993, %1116 ]
  %1129 = phi double [ %728, %974 ], [ %728, %990 ], [ %728, %1046 ], [ %970, %1119 ], [ %728, %1116 ]
  br i1 %1125, label %1130, label %1133

1130:                                             ; preds = %1120
  %1131 = add nuw nsw i64 %731, 1
  %1132 = icmp eq i64 %1131, %717
  br i1 %1132, label %1133, label %727, !llvm.loop !33

1133:                                             ; preds = %906, %1120, %788, %727, %1130
  %1134 = phi double [ %735, %727 ], [ %1121, %1120 ], [ %790, %788 ], [ %1121, %1130 ], [ 0x7FF0000000000000, %906 ]
  %1135 = phi i32 [ %734, %727 ], [ %1122, %1120 ], [ %791, %788 ], [ %1122, %1130 ], [ 0, %906 ]
  %1136 = phi i64 [ %733, %727 ], [ %1123, %1120 ], [ %792, %788 ], [ %1123, %1130 ], [ %731, %906 ]
  %1137 = phi i64 [ %732, %727 ], [ %1124, %1120 ], [ %793, %788 ], [ %1124, %1130 ], [ 0, %906 ]
  %1138 = phi i32 [ 2, %727 ], [ %1126, %1120 ], [ %794, %788 ], [ 2, %1130 ], [ 1, %906 ]
  %1139 = phi i64 [ 0, %727 ], [ %1127, %1120 ], [ %730, %788 ], [ %1127, %1130 ], [ %730, %906 ]
  %1140 = phi double [ %729, %727 ], [ %1128, %1120 ], [ %729, %788 ], [ %1128, %1130 ], [ %729, %906 ]
  %1141 = icmp eq i32 %1138, 2
  br i1 %1141, label %1142, label %1146

1142:                                             ; preds = %1133
  %1143 = icmp sgt i64 %1139, 0
  %1144 = select i1 %1143, i64 %1139, i64 6
  %1145 = zext i1 %1143 to i32
  br label %1146

1146:                                             ; preds = %1133, %1142
  %1147 = phi double [ %1140, %1142 ], [ %1134, %1133 ]
  %1148 = phi i32 [ %1145, %1142 ], [ %1135, %1133 ]
  %1149 = phi i64 [ %1144, %1142 ], [ %1136, %1133 ]
  %1150 = phi i64 [ 0, %1142 ], [ %1137, %1133 ]
  %1151 = icmp slt i64 %1150, 0
  br i1 %1151, label %1893, label %1152

1152:                                             ; preds = %1146
  %1153 = icmp eq i32 %1148, 0
  br i1 %1153, label %1155, label %1154

1154:                                             ; preds = %1152
  br i1 %347, label %1306, label %1205

1155:                                             ; preds = %1152
  %1156 = load i64, ptr %336, align 8
  %1157 = add nsw i64 %1156, 1
  store i64 %1157, ptr %336, align 8
  %1158 = tail call double @llvm.fabs.f64(double %1147)
  %1159 = fcmp ueq double %1158, 0x7FF0000000000000
  %1160 = select i1 %1159, i64 4, i64 7
  %1161 = icmp eq i64 %1150, 0
  %1162 = select i1 %1161, i64 %1160, i64 3
  store i64 %1162, ptr %365, align 8
  %1163 = load i64, ptr %366, align 8
  %1164 = icmp eq i64 %1163, 1
  %1165 = and i1 %1161, %1164
  br i1 %1165, label %1166, label %1192

1166:                                             ; preds = %1155
  %1167 = load i64, ptr %181, align 8
  %1168 = icmp sgt i64 %1167, 0
  br i1 %1168, label %1169, label %1186

1169:                                             ; preds = %1166, %1178
  %1170 = phi i64 [ %1183, %1178 ], [ 0, %1166 ]
  %1171 = phi i32 [ %1180, %1178 ], [ 0, %1166 ]
  %1172 = icmp eq i32 %1171, 0
  br i1 %1172, label %1173, label %1178

1173:                                             ; preds = %1169
  %1174 = load ptr, ptr %180, align 8
  %1175 = getelementptr inbounds double, ptr %1174, i64 %1170
  %1176 = load double, ptr %1175, align 8
  %1177 = fcmp une double %1176, 0.000000e+00
  br label %1178

1178:                                             ; preds = %1173, %1169
  %1179 = phi i1 [ true, %1169 ], [ %1177, %1173 ]
  %1180 = zext i1 %1179 to i32
  %1181 = load ptr, ptr %180, align 8
  %1182 = getelementptr inbounds double, ptr %1181, i64 %1170
  store double 0.000000e+00, ptr %1182, align 8
  %1183 = add nuw nsw i64 %1170, 1
  %1184 = load i64, ptr %181, align 8
  %1185 = icmp slt i64 %1183, %1184
  br i1 %1185, label %1169, label %1186, !llvm.loop !34

1186:                                             ; preds = %1178, %1166
  %1187 = phi i32 [ 0, %1166 ], [ %1180, %1178 ]
  %1188 = icmp eq i32 %1187, 0
  br i1 %1188, label %1190, label %1189

1189:                                             ; preds = %1186
  store i64 0, ptr %342, align 8
  br label %1893, !llvm.loop !17

1190:                                             ; preds = %1186
  store i64 0, ptr %366, align 8
  %1191 = fmul double %414, 5.000000e-01
  br label %1192

1192:                                             ; preds = %1190, %1155
  %1193 = phi double [ %1191, %1190 ], [ %379, %1155 ]
  %1194 = load i64, ptr %366, align 8
  %1195 = icmp eq i64 %1194, 1
  %1196 = icmp ne i64 %1150, 0
  %1197 = or i1 %1196, %1195
  br i1 %1197, label %1198, label %1201

1198:                                             ; preds = %1192
  %1199 = select i1 %1161, double 5.000000e-01, double 2.500000e-01
  %1200 = fmul double %414, %1199
  store double 0.000000e+00, ptr %344, align 8
  br label %1201

1201:                                             ; preds = %1198, %1192
  %1202 = phi double [ %1200, %1198 ], [ %1193, %1192 ]
  %1203 = load i64, ptr %366, align 8
  %1204 = sub nsw i64 1, %1203
  store i64 %1204, ptr %339, align 8
  br label %1893, !llvm.loop !17

1205:                                             ; preds = %1306, %1154
  %1206 = load i64, ptr %349, align 8
  %1207 = icmp eq i64 %1206, 1
  %1208 = load ptr, ptr %76, align 8
  %1209 = getelementptr inbounds i8, ptr %1208, i64 8
  %1210 = load i64, ptr %1209, align 8
  %1211 = load i64, ptr %143, align 8
  %1212 = load ptr, ptr %144, align 8
  %1213 = load ptr, ptr %119, align 8
  %1214 = icmp sgt i64 %1210, 0
  br i1 %1214, label %1215, label %1217

1215:                                             ; preds = %1205
  %1216 = shl i64 %1210, 4
  br label %1226

1217:                                             ; preds = %1226, %1205
  %1218 = load ptr, ptr %146, align 8
  %1219 = load ptr, ptr %142, align 8
  tail call fastcc void @real_solve(ptr noundef %1218, i64 noundef %1211, ptr noundef %1219, ptr noundef %1213) #10
  %1220 = load ptr, ptr %147, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1213, ptr noundef %1220, ptr noundef nonnull %77, i64 noundef %1210) #10
  %1221 = load double, ptr %6, align 8
  %1222 = fcmp uge double %1221, 1.000000e+00
  %1223 = and i1 %1207, %1222
  br i1 %1223, label %1224, label %1302

1224:                                             ; preds = %1217
  %1225 = icmp sgt i64 %1210, 0
  br i1 %1225, label %1274, label %1251

1226:                                             ; preds = %1215, %1226
  %1227 = phi i64 [ 0, %1215 ], [ %1249, %1226 ]
  %1228 = load ptr, ptr %116, align 8
  %1229 = getelementptr inbounds double, ptr %1228, i64 %1227
  %1230 = load double, ptr %1229, align 8
  %1231 = fmul double %1230, 0x402418FD8BAFFE05
  %1232 = getelementptr double, ptr %1228, i64 %1210
  %1233 = getelementptr double, ptr %1232, i64 %1227
  %1234 = load double, ptr %1233, align 8
  %1235 = fmul double %1234, 0x3FF61D41B2D54580
  %1236 = fsub double %1235, %1231
  %1237 = getelementptr i8, ptr %1228, i64 %1216
  %1238 = getelementptr double, ptr %1237, i64 %1227
  %1239 = load double, ptr %1238, align 8
  %1240 = fmul double %1239, 0x3FD5555555555555
  %1241 = fsub double %1236, %1240
  %1242 = fdiv double %1241, %414
  %1243 = getelementptr inbounds double, ptr %1212, i64 %1227
  store double %1242, ptr %1243, align 8
  %1244 = load ptr, ptr %145, align 8
  %1245 = getelementptr inbounds double, ptr %1244, i64 %1227
  %1246 = load double, ptr %1245, align 8
  %1247 = fadd double %1246, %1242
  %1248 = getelementptr inbounds double, ptr %1213, i64 %1227
  store double %1247, ptr %1248, align 8
  %1249 = add nuw nsw i64 %1227, 1
  %1250 = icmp eq i64 %1249, %1210
  br i1 %1250, label %1217, label %1226, !llvm.loop !35

1251:                                             ; preds = %1274, %1224
  %1252 = load ptr, ptr %81, align 8
  %1253 = getelementptr inbounds i8, ptr %1252, i64 24
  %1254 = load i64, ptr %1253, align 8
  %1255 = add nsw i64 %1254, 1
  store i64 %1255, ptr %1253, align 8
  %1256 = load ptr, ptr %149, align 8
  %1257 = load ptr, ptr %118, align 8
  %1258 = load ptr, ptr %150, align 8
  store double %378, ptr %1258, align 8
  %1259 = load i64, ptr %151, align 8
  %1260 = icmp sgt i64 %1259, 0
  br i1 %1260, label %1261, label %1262

1261:                                             ; preds = %1251
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1262

1262:                                             ; preds = %1251, %1261
  %1263 = load ptr, ptr %76, align 8
  %1264 = load i64, ptr %1263, align 8
  %1265 = load ptr, ptr %150, align 8
  %1266 = load ptr, ptr %152, align 8
  %1267 = load ptr, ptr %153, align 8
  %1268 = inttoptr i64 %1264 to ptr
  %1269 = tail call i32 %1268(ptr noundef %1265, ptr noundef %1256, ptr noundef %1266, ptr noundef %1267, ptr noundef %1257) #11
  %1270 = sext i32 %1269 to i64
  %1271 = icmp eq i32 %1269, 0
  br i1 %1271, label %1272, label %1302

1272:                                             ; preds = %1262
  %1273 = icmp sgt i64 %1210, 0
  br i1 %1273, label %1291, label %1286

1274:                                             ; preds = %1224, %1274
  %1275 = phi i64 [ %1284, %1274 ], [ 0, %1224 ]
  %1276 = load ptr, ptr %77, align 8
  %1277 = getelementptr inbounds double, ptr %1276, i64 %1275
  %1278 = load double, ptr %1277, align 8
  %1279 = getelementptr inbounds double, ptr %1213, i64 %1275
  %1280 = load double, ptr %1279, align 8
  %1281 = fadd double %1278, %1280
  %1282 = load ptr, ptr %148, align 8
  %1283 = getelementptr inbounds double, ptr %1282, i64 %1275
  store double %1281, ptr %1283, align 8
  %1284 = add nuw nsw i64 %1275, 1
  %1285 = icmp eq i64 %1284, %1210
  br i1 %1285, label %1251, label %1274, !llvm.loop !36

1286:                                             ; preds = %1291, %1272
  %1287 = load ptr, ptr %146, align 8
  %1288 = load ptr, ptr %142, align 8
  tail call fastcc void @real_solve(ptr noundef %1287, i64 noundef %1211, ptr noundef %1288, ptr noundef %1213) #10
  %1289 = load ptr, ptr %147, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1213, ptr noundef %1289, ptr noundef nonnull %77, i64 noundef %1210) #10
  %1290 = load double, ptr %7, align 8
  br label %1302

1291:                                             ; preds = %1272, %1291
  %1292 = phi i64 [ %1300, %1291 ], [ 0, %1272 ]
  %1293 = load ptr, ptr %118, align 8
  %1294 = getelementptr inbounds double, ptr %1293, i64 %1292
  %1295 = load double, ptr %1294, align 8
  %1296 = getelementptr inbounds double, ptr %1212, i64 %1292
  %1297 = load double, ptr %1296, align 8
  %1298 = fadd double %1295, %1297
  %1299 = getelementptr inbounds double, ptr %1213, i64 %1292
  store double %1298, ptr %1299, align 8
  %1300 = add nuw nsw i64 %1292, 1
  %1301 = icmp eq i64 %1300, %1210
  br i1 %1301, label %1286, label %1291, !llvm.loop !37

1302:                                             ; preds = %1217, %1262, %1286
  %1303 = phi double [ %1290, %1286 ], [ %1221, %1262 ], [ %1221, %1217 ]
  %1304 = phi i64 [ 0, %1286 ], [ %1270, %1262 ], [ 0, %1217 ]
  %1305 = icmp slt i64 %1304, 0
  br i1 %1305, label %1893, label %1320

1306:                                             ; preds = %1154, %1306
  %1307 = phi i64 [ %1318, %1306 ], [ 0, %1154 ]
  %1308 = load ptr, ptr %77, align 8
  %1309 = getelementptr inbounds double, ptr %1308, i64 %1307
  %1310 = load double, ptr %1309, align 8
  %1311 = load ptr, ptr %116, align 8
  %1312 = getelementptr i8, ptr %1311, i64 %348
  %1313 = getelementptr double, ptr %1312, i64 %1307
  %1314 = load double, ptr %1313, align 8
  %1315 = fadd double %1310, %1314
  %1316 = load ptr, ptr %141, align 8
  %1317 = getelementptr inbounds double, ptr %1316, i64 %1307
  store double %1315, ptr %1317, align 8
  %1318 = add nuw nsw i64 %1307, 1
  %1319 = icmp eq i64 %1318, %198
  br i1 %1319, label %1205, label %1306, !llvm.loop !38

1320:                                             ; preds = %1302
  %1321 = add nsw i64 %1149, 12
  %1322 = sitofp i64 %1321 to double
  %1323 = fdiv double 0x4027666666666667, %1322
  %1324 = fcmp olt double %1303, 1.000000e-10
  %1325 = select i1 %1324, double 1.000000e-10, double %1303
  %1326 = tail call double @llvm.pow.f64(double %1325, double -2.500000e-01)
  %1327 = icmp eq i64 %1304, 0
  %1328 = fcmp olt double %1303, 1.000000e+00
  %1329 = select i1 %1327, i1 %1328, i1 false
  br i1 %1329, label %1345, label %1330

1330:                                             ; preds = %1320
  %1331 = load i64, ptr %336, align 8
  %1332 = add nsw i64 %1331, 1
  store i64 %1332, ptr %336, align 8
  %1333 = select i1 %1327, i64 2, i64 3
  store i64 %1333, ptr %350, align 8
  %1334 = tail call double @llvm.fabs.f64(double %1303)
  %1335 = fcmp ueq double %1334, 0x7FF0000000000000
  br i1 %1335, label %1340, label %1336

1336:                                             ; preds = %1330
  %1337 = fmul double %1323, %1326
  %1338 = fcmp ogt double %1337, 2.000000e-01
  %1339 = select i1 %1338, double %1337, double 2.000000e-01
  br label %1340

1340:                                             ; preds = %1330, %1336
  %1341 = phi double [ %1339, %1336 ], [ 2.500000e-01, %1330 ]
  %1342 = fmul double %414, %1341
  store i64 1, ptr %349, align 8
  %1343 = load i64, ptr %351, align 8
  %1344 = sub nsw i64 1, %1343
  store i64 %1344, ptr %339, align 8
  br label %1893, !llvm.loop !17

1345:                                             ; preds = %1320
  br i1 %206, label %1346, label %1361

1346:                                             ; preds = %1345
  %1347 = load ptr, ptr %147, align 8
  %1348 = load ptr, ptr %77, align 8
  %1349 = load ptr, ptr %84, align 8
  %1350 = getelementptr inbounds i8, ptr %1349, i64 56
  %1351 = load i64, ptr %1350, align 8
  %1352 = inttoptr i64 %1351 to ptr
  %1353 = tail call i64 %1352(ptr noundef %0, double noundef %415, ptr noundef %1347, ptr noundef %1348) #11
  %1354 = icmp eq i64 %1353, 0
  br i1 %1354, label %1361, label %1355

1355:                                             ; preds = %1346
  %1356 = load i64, ptr %336, align 8
  %1357 = add nsw i64 %1356, 1
  store i64 %1357, ptr %336, align 8
  store i64 6, ptr %352, align 8
  %1358 = fmul double %414, 2.500000e-01
  store i64 1, ptr %349, align 8
  %1359 = load i64, ptr %353, align 8
  %1360 = sub nsw i64 1, %1359
  store i64 %1360, ptr %339, align 8
  br label %1893, !llvm.loop !17

1361:                                             ; preds = %1346, %1345
  %1362 = load i64, ptr %335, align 8
  %1363 = add nsw i64 %1362, 1
  store i64 %1363, ptr %335, align 8
  %1364 = load double, ptr %354, align 8
  %1365 = fcmp ogt double %1364, 0.000000e+00
  br i1 %1365, label %1366, label %1375

1366:                                             ; preds = %1361
  %1367 = fdiv double %1364, %1325
  %1368 = tail call double @llvm.pow.f64(double %1367, double 2.500000e-01)
  %1369 = load double, ptr %355, align 8
  %1370 = fdiv double %414, %1369
  %1371 = fmul double %1368, %1370
  %1372 = fcmp olt double %1371, 1.000000e+00
  %1373 = select i1 %1372, double %1371, double 1.000000e+00
  %1374 = fmul double %1326, %1373
  br label %1375

1375:                                             ; preds = %1366, %1361
  %1376 = phi double [ %1374, %1366 ], [ %1326, %1361 ]
  %1377 = fmul double %1323, %1376
  %1378 = fcmp olt double %1377, 1.000000e+01
  store double %415, ptr %188, align 8
  store double %414, ptr %356, align 8
  store double %1325, ptr %354, align 8
  %1379 = load ptr, ptr %76, align 8
  %1380 = getelementptr inbounds i8, ptr %1379, i64 8
  %1381 = load i64, ptr %1380, align 8
  %1382 = load i64, ptr %154, align 8
  %1383 = load ptr, ptr %116, align 8
  %1384 = load ptr, ptr %155, align 8
  %1385 = load ptr, ptr %115, align 8
  br label %1402

1386:                                             ; preds = %1402
  %1387 = select i1 %1378, double %1377, double 1.000000e+01
  %1388 = icmp sgt i64 %1381, 0
  br i1 %1388, label %1389, label %1462

1389:                                             ; preds = %1386
  %1390 = load double, ptr %8, align 16
  %1391 = load double, ptr %156, align 8
  %1392 = getelementptr double, ptr %1383, i64 %1381
  %1393 = load double, ptr %157, align 16
  %1394 = shl i64 %1381, 4
  %1395 = getelementptr i8, ptr %1383, i64 %1394
  %1396 = load double, ptr %9, align 16
  %1397 = load double, ptr %158, align 8
  %1398 = load double, ptr %159, align 16
  %1399 = getelementptr double, ptr %1384, i64 %1382
  %1400 = shl i64 %1382, 4
  %1401 = getelementptr i8, ptr %1384, i64 %1400
  br label %1413

1402:                                             ; preds = %1375, %1402
  %1403 = phi i64 [ 0, %1375 ], [ %1411, %1402 ]
  %1404 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1403
  %1405 = getelementptr inbounds i8, ptr %1404, i64 8
  %1406 = load double, ptr %1405, align 8
  %1407 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1403
  store double %1406, ptr %1407, align 8
  %1408 = getelementptr inbounds i8, ptr %1404, i64 16
  %1409 = load double, ptr %1408, align 8
  %1410 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1403
  store double %1409, ptr %1410, align 8
  %1411 = add nuw nsw i64 %1403, 1
  %1412 = icmp eq i64 %1411, 3
  br i1 %1412, label %1386, label %1402, !llvm.loop !39

1413:                                             ; preds = %1389, %1450
  %1414 = phi i64 [ 0, %1389 ], [ %1451, %1450 ]
  %1415 = getelementptr inbounds double, ptr %1383, i64 %1414
  %1416 = load double, ptr %1415, align 8
  %1417 = fmul double %1390, %1416
  %1418 = getelementptr double, ptr %1392, i64 %1414
  %1419 = load double, ptr %1418, align 8
  %1420 = fmul double %1391, %1419
  %1421 = fadd double %1417, %1420
  %1422 = getelementptr double, ptr %1395, i64 %1414
  %1423 = load double, ptr %1422, align 8
  %1424 = fmul double %1393, %1423
  %1425 = fadd double %1421, %1424
  %1426 = fmul double %1416, %1396
  %1427 = fmul double %1419, %1397
  %1428 = fadd double %1426, %1427
  %1429 = fmul double %1423, %1398
  %1430 = fadd double %1428, %1429
  %1431 = load ptr, ptr %147, align 8
  %1432 = getelementptr inbounds double, ptr %1431, i64 %1414
  %1433 = load double, ptr %1432, align 8
  %1434 = load ptr, ptr %77, align 8
  %1435 = getelementptr inbounds double, ptr %1434, i64 %1414
  %1436 = load double, ptr %1435, align 8
  %1437 = fsub double %1433, %1436
  %1438 = getelementptr inbounds double, ptr %1384, i64 %1414
  store double %1437, ptr %1438, align 8
  %1439 = fneg double %1425
  %1440 = fsub double %1439, %1430
  %1441 = getelementptr double, ptr %1399, i64 %1414
  store double %1440, ptr %1441, align 8
  %1442 = fneg double %1430
  %1443 = getelementptr double, ptr %1401, i64 %1414
  store double %1442, ptr %1443, align 8
  %1444 = load ptr, ptr %77, align 8
  %1445 = getelementptr inbounds double, ptr %1444, i64 %1414
  %1446 = load double, ptr %1445, align 8
  %1447 = getelementptr inbounds double, ptr %1385, i64 %1414
  store double %1446, ptr %1447, align 8
  %1448 = getelementptr double, ptr %1384, i64 %1414
  %1449 = getelementptr double, ptr %1385, i64 %1414
  br label %1453

1450:                                             ; preds = %1453
  %1451 = add nuw nsw i64 %1414, 1
  %1452 = icmp eq i64 %1451, %1381
  br i1 %1452, label %1462, label %1413, !llvm.loop !40

1453:                                             ; preds = %1413, %1453
  %1454 = phi i64 [ 0, %1413 ], [ %1458, %1453 ]
  %1455 = mul nsw i64 %1382, %1454
  %1456 = getelementptr double, ptr %1448, i64 %1455
  %1457 = load double, ptr %1456, align 8
  %1458 = add nuw nsw i64 %1454, 1
  %1459 = mul nuw nsw i64 %1381, %1458
  %1460 = getelementptr double, ptr %1449, i64 %1459
  store double %1457, ptr %1460, align 8
  %1461 = icmp eq i64 %1458, 3
  br i1 %1461, label %1450, label %1453, !llvm.loop !41

1462:                                             ; preds = %1450, %1386
  store double %414, ptr %344, align 8
  %1463 = load ptr, ptr %0, align 8
  %1464 = getelementptr inbounds i8, ptr %1463, i64 24
  %1465 = load i64, ptr %1464, align 8
  %1466 = load ptr, ptr %93, align 8
  %1467 = getelementptr inbounds i8, ptr %1466, i64 8
  %1468 = load i64, ptr %1467, align 8
  %1469 = icmp eq i64 %1468, 0
  br i1 %1469, label %1516, label %1470

1470:                                             ; preds = %1462
  %1471 = load i64, ptr %1466, align 8
  %1472 = load ptr, ptr %76, align 8
  %1473 = getelementptr inbounds i8, ptr %1472, i64 8
  %1474 = load i64, ptr %1473, align 8
  %1475 = load ptr, ptr %160, align 8
  %1476 = load i64, ptr %161, align 8
  %1477 = mul nsw i64 %1476, %1471
  %1478 = getelementptr inbounds double, ptr %1475, i64 %1477
  %1479 = getelementptr inbounds double, ptr %1478, i64 %1476
  store double %378, ptr %1478, align 8
  %1480 = getelementptr inbounds i8, ptr %1478, i64 8
  store double %414, ptr %1480, align 8
  store double %415, ptr %1479, align 8
  %1481 = getelementptr inbounds i8, ptr %1479, i64 8
  store double 0.000000e+00, ptr %1481, align 8
  %1482 = icmp sgt i64 %1474, 0
  br i1 %1482, label %1483, label %1486

1483:                                             ; preds = %1470
  %1484 = getelementptr i8, ptr %1478, i64 16
  %1485 = icmp sgt i64 %1465, 0
  br label %1489

1486:                                             ; preds = %1501, %1470
  %1487 = add nsw i64 %1471, 1
  %1488 = load ptr, ptr %93, align 8
  store i64 %1487, ptr %1488, align 8
  br label %1516

1489:                                             ; preds = %1483, %1501
  %1490 = phi i64 [ 0, %1483 ], [ %1502, %1501 ]
  %1491 = load ptr, ptr %77, align 8
  %1492 = getelementptr inbounds double, ptr %1491, i64 %1490
  %1493 = load double, ptr %1492, align 8
  %1494 = add nuw nsw i64 %1490, 2
  %1495 = getelementptr inbounds double, ptr %1478, i64 %1494
  store double %1493, ptr %1495, align 8
  %1496 = load ptr, ptr %147, align 8
  %1497 = getelementptr inbounds double, ptr %1496, i64 %1490
  %1498 = load double, ptr %1497, align 8
  %1499 = getelementptr inbounds double, ptr %1479, i64 %1494
  store double %1498, ptr %1499, align 8
  %1500 = getelementptr double, ptr %1484, i64 %1490
  br i1 %1485, label %1504, label %1501

1501:                                             ; preds = %1504, %1489
  %1502 = add nuw nsw i64 %1490, 1
  %1503 = icmp eq i64 %1502, %1474
  br i1 %1503, label %1486, label %1489, !llvm.loop !42

1504:                                             ; preds = %1489, %1504
  %1505 = phi i64 [ %1512, %1504 ], [ 0, %1489 ]
  %1506 = load ptr, ptr %155, align 8
  %1507 = load i64, ptr %154, align 8
  %1508 = mul nsw i64 %1507, %1505
  %1509 = getelementptr double, ptr %1506, i64 %1508
  %1510 = getelementptr double, ptr %1509, i64 %1490
  %1511 = load double, ptr %1510, align 8
  %1512 = add nuw nsw i64 %1505, 1
  %1513 = mul nuw nsw i64 %1512, %1474
  %1514 = getelementptr double, ptr %1500, i64 %1513
  store double %1511, ptr %1514, align 8
  %1515 = icmp eq i64 %1512, %1465
  br i1 %1515, label %1501, label %1504, !llvm.loop !43

1516:                                             ; preds = %1462, %1486
  br i1 %210, label %1517, label %1624

1517:                                             ; preds = %1516
  %1518 = load ptr, ptr %85, align 8
  %1519 = load ptr, ptr %76, align 8
  %1520 = getelementptr inbounds i8, ptr %1519, i64 8
  %1521 = load i64, ptr %1520, align 8
  %1522 = load ptr, ptr %162, align 8
  %1523 = getelementptr inbounds i8, ptr %1518, i64 32
  %1524 = load i64, ptr %1523, align 8
  %1525 = getelementptr inbounds double, ptr %1522, i64 %1524
  %1526 = load ptr, ptr %116, align 8
  %1527 = getelementptr inbounds i8, ptr %1518, i64 24
  %1528 = load i64, ptr %1527, align 8
  %1529 = icmp eq i64 %1528, 0
  br i1 %1529, label %1621, label %1530

1530:                                             ; preds = %1517
  %1531 = getelementptr inbounds i8, ptr %1518, i64 40
  %1532 = load i64, ptr %1531, align 8
  %1533 = icmp sgt i64 %1532, 0
  br i1 %1533, label %1534, label %1538

1534:                                             ; preds = %1530
  %1535 = getelementptr double, ptr %1526, i64 %1521
  %1536 = shl i64 %1521, 4
  %1537 = getelementptr i8, ptr %1526, i64 %1536
  br label %1591

1538:                                             ; preds = %1591, %1530
  %1539 = load ptr, ptr %163, align 8
  %1540 = load ptr, ptr %85, align 8
  %1541 = getelementptr inbounds i8, ptr %1540, i64 8
  %1542 = load i64, ptr %1541, align 8
  %1543 = load ptr, ptr %164, align 8
  %1544 = load ptr, ptr %162, align 8
  %1545 = getelementptr inbounds i8, ptr %1540, i64 32
  %1546 = load i64, ptr %1545, align 8
  %1547 = getelementptr inbounds i8, ptr %1540, i64 40
  %1548 = load i64, ptr %1547, align 8
  %1549 = getelementptr double, ptr %1544, i64 %1546
  %1550 = getelementptr double, ptr %1549, i64 %1548
  store double %414, ptr %1550, align 8
  %1551 = load ptr, ptr %163, align 8
  store double %378, ptr %1551, align 8
  %1552 = load ptr, ptr %85, align 8
  %1553 = getelementptr inbounds i8, ptr %1552, i64 24
  %1554 = load i64, ptr %1553, align 8
  %1555 = load ptr, ptr %77, align 8
  %1556 = load ptr, ptr %162, align 8
  %1557 = load ptr, ptr %165, align 8
  %1558 = inttoptr i64 %1554 to ptr
  %1559 = tail call i32 %1558(ptr noundef %1539, ptr noundef %1555, ptr noundef %1556, ptr noundef %1557, ptr noundef %1543) #11
  %1560 = icmp eq i32 %1559, 0
  br i1 %1560, label %1561, label %1621

1561:                                             ; preds = %1538
  %1562 = icmp slt i64 %1542, 1
  br i1 %1562, label %1588, label %1563

1563:                                             ; preds = %1561
  %1564 = load ptr, ptr %166, align 8
  %1565 = getelementptr double, ptr %1543, i64 %1542
  br label %1566

1566:                                             ; preds = %1563, %1584
  %1567 = phi i1 [ %1562, %1563 ], [ %1586, %1584 ]
  %1568 = phi i64 [ 0, %1563 ], [ %1585, %1584 ]
  %1569 = getelementptr inbounds i64, ptr %1564, i64 %1568
  %1570 = load i64, ptr %1569, align 8
  %1571 = and i64 %1570, 2
  %1572 = icmp eq i64 %1571, 0
  br i1 %1572, label %1573, label %1584

1573:                                             ; preds = %1566
  %1574 = getelementptr inbounds double, ptr %1543, i64 %1568
  %1575 = load double, ptr %1574, align 8
  %1576 = load ptr, ptr %167, align 8
  %1577 = getelementptr inbounds i64, ptr %1576, i64 %1568
  %1578 = load i64, ptr %1577, align 8
  %1579 = sitofp i64 %1578 to double
  %1580 = fmul double %1575, %1579
  %1581 = getelementptr double, ptr %1565, i64 %1568
  %1582 = load double, ptr %1581, align 8
  %1583 = fcmp ogt double %1580, %1582
  br i1 %1583, label %1584, label %1588

1584:                                             ; preds = %1573, %1566
  %1585 = add nuw nsw i64 %1568, 1
  %1586 = icmp sge i64 %1585, %1542
  %1587 = icmp eq i64 %1585, %1542
  br i1 %1587, label %1588, label %1566, !llvm.loop !44

1588:                                             ; preds = %1584, %1573, %1561
  %1589 = phi i1 [ %1562, %1561 ], [ %1586, %1584 ], [ %1567, %1573 ]
  %1590 = zext i1 %1589 to i32
  br label %1621

1591:                                             ; preds = %1534, %1591
  %1592 = phi i64 [ 0, %1534 ], [ %1618, %1591 ]
  %1593 = load ptr, ptr %147, align 8
  %1594 = getelementptr inbounds double, ptr %1593, i64 %1592
  %1595 = load double, ptr %1594, align 8
  %1596 = load ptr, ptr %77, align 8
  %1597 = getelementptr inbounds double, ptr %1596, i64 %1592
  %1598 = load double, ptr %1597, align 8
  %1599 = fsub double %1595, %1598
  %1600 = tail call double @llvm.fabs.f64(double %1599)
  %1601 = getelementptr inbounds double, ptr %1526, i64 %1592
  %1602 = load double, ptr %1601, align 8
  %1603 = tail call double @llvm.fabs.f64(double %1602)
  %1604 = getelementptr double, ptr %1535, i64 %1592
  %1605 = load double, ptr %1604, align 8
  %1606 = tail call double @llvm.fabs.f64(double %1605)
  %1607 = fcmp ogt double %1603, %1606
  %1608 = select i1 %1607, double %1603, double %1606
  %1609 = getelementptr double, ptr %1537, i64 %1592
  %1610 = load double, ptr %1609, align 8
  %1611 = tail call double @llvm.fabs.f64(double %1610)
  %1612 = fcmp ogt double %1608, %1611
  %1613 = select i1 %1612, double %1608, double %1611
  %1614 = fcmp ogt double %1613, %1600
  %1615 = select i1 %1614, double %1613, double %1600
  %1616 = fmul double %1615, 8.000000e+00
  %1617 = getelementptr inbounds double, ptr %1525, i64 %1592
  store double %1616, ptr %1617, align 8
  %1618 = add nuw nsw i64 %1592, 1
  %1619 = load i64, ptr %1531, align 8
  %1620 = icmp slt i64 %1618, %1619
  br i1 %1620, label %1591, label %1538, !llvm.loop !45

1621:                                             ; preds = %1588, %1538, %1517
  %1622 = phi i32 [ 0, %1517 ], [ 0, %1538 ], [ %1590, %1588 ]
  %1623 = icmp eq i32 %1622, 0
  br label %1624

1624:                                             ; preds = %1621, %1516
  %1625 = phi i1 [ false, %1516 ], [ %1623, %1621 ]
  br i1 %1625, label %1631, label %1626

1626:                                             ; preds = %1624
  %1627 = load i64, ptr %357, align 8
  %1628 = getelementptr inbounds double, ptr %199, i64 %1627
  %1629 = load double, ptr %1628, align 8
  %1630 = fcmp ugt double %1629, %415
  br i1 %1630, label %1843, label %1631

1631:                                             ; preds = %1626, %1624
  %1632 = load ptr, ptr %79, align 8
  br i1 %1625, label %1633, label %1644

1633:                                             ; preds = %1631
  %1634 = load ptr, ptr %85, align 8
  %1635 = getelementptr inbounds i8, ptr %1634, i64 16
  %1636 = load i64, ptr %1635, align 8
  %1637 = inttoptr i64 %1636 to ptr
  %1638 = tail call i64 %1637(ptr noundef %0, double noundef %378, double noundef %414) #11
  %1639 = icmp eq i64 %1638, -6
  br i1 %1639, label %1640, label %1641

1640:                                             ; preds = %1633
  store double %378, ptr %1632, align 8
  br label %1819

1641:                                             ; preds = %1633
  %1642 = getelementptr inbounds i8, ptr %1632, i64 48
  %1643 = load double, ptr %1642, align 8
  br label %1644

1644:                                             ; preds = %1641, %1631
  %1645 = phi double [ %1643, %1641 ], [ 1.000000e+00, %1631 ]
  %1646 = phi i64 [ %1638, %1641 ], [ 0, %1631 ]
  %1647 = fcmp oeq double %1645, 1.000000e+00
  br i1 %1647, label %1648, label %1650

1648:                                             ; preds = %1644
  %1649 = load double, ptr %1632, align 8
  br label %1653

1650:                                             ; preds = %1644
  %1651 = fmul double %414, %1645
  %1652 = fadd double %378, %1651
  br label %1653

1653:                                             ; preds = %1650, %1648
  %1654 = phi double [ %1649, %1648 ], [ %1652, %1650 ]
  %1655 = icmp eq i64 %1646, -4
  %1656 = select i1 %1655, i64 -4, i64 0
  br i1 %1655, label %1714, label %1657

1657:                                             ; preds = %1653
  %1658 = fcmp olt double %1645, 1.000000e+00
  %1659 = load ptr, ptr %76, align 8
  %1660 = getelementptr inbounds i8, ptr %1659, i64 8
  %1661 = load i64, ptr %1660, align 8
  %1662 = load i64, ptr %83, align 8
  %1663 = load ptr, ptr %82, align 8
  %1664 = load ptr, ptr %81, align 8
  %1665 = getelementptr inbounds i8, ptr %1664, i64 48
  %1666 = load i64, ptr %1665, align 8
  %1667 = icmp slt i64 %1666, %1662
  br i1 %1667, label %1668, label %1710

1668:                                             ; preds = %1657, %1706
  %1669 = phi i64 [ %1707, %1706 ], [ undef, %1657 ]
  %1670 = phi i64 [ %1708, %1706 ], [ %1666, %1657 ]
  %1671 = getelementptr inbounds double, ptr %1663, i64 %1670
  %1672 = load double, ptr %1671, align 8
  %1673 = fcmp olt double %1672, %1654
  %1674 = fcmp oeq double %1672, %1654
  %1675 = and i1 %1658, %1674
  %1676 = or i1 %1673, %1675
  br i1 %1676, label %1677, label %1710

1677:                                             ; preds = %1668
  %1678 = fsub double %1672, %378
  %1679 = fdiv double %1678, %414
  %1680 = mul nsw i64 %1670, %1661
  %1681 = getelementptr inbounds double, ptr %1, i64 %1680
  %1682 = load ptr, ptr %168, align 8
  %1683 = insertelement <8 x double> poison, double %1679, i64 0
  %1684 = shufflevector <8 x double> %1683, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1684, ptr %1682, align 8
  %1685 = load ptr, ptr %77, align 8
  %1686 = load ptr, ptr %169, align 8
  %1687 = load i64, ptr %170, align 8
  %1688 = load ptr, ptr %0, align 8
  %1689 = getelementptr inbounds i8, ptr %1688, i64 24
  %1690 = load i64, ptr %1689, align 8
  %1691 = load ptr, ptr %168, align 8
  %1692 = load ptr, ptr %76, align 8
  %1693 = getelementptr inbounds i8, ptr %1692, i64 16
  %1694 = load i64, ptr %1693, align 8
  tail call fastcc void @nested(ptr noundef %1681, ptr noundef %1685, ptr noundef %1686, i64 noundef %1687, i64 noundef %1690, ptr noundef %1691, i64 noundef %1694) #10
  %1695 = load ptr, ptr %84, align 8
  %1696 = load i64, ptr %1695, align 8
  %1697 = icmp eq i64 %1696, 1
  br i1 %1697, label %1698, label %1706

1698:                                             ; preds = %1677
  %1699 = load double, ptr %1671, align 8
  %1700 = getelementptr inbounds i8, ptr %1695, i64 56
  %1701 = load i64, ptr %1700, align 8
  %1702 = inttoptr i64 %1701 to ptr
  %1703 = tail call i64 %1702(ptr noundef %0, double noundef %1699, ptr noundef %1681, ptr noundef null) #11
  %1704 = icmp eq i64 %1703, 0
  %1705 = select i1 %1704, i64 %1669, i64 %1703
  br i1 %1704, label %1706, label %1714

1706:                                             ; preds = %1698, %1677
  %1707 = phi i64 [ %1705, %1698 ], [ %1669, %1677 ]
  %1708 = add i64 %1670, 1
  %1709 = icmp eq i64 %1708, %1662
  br i1 %1709, label %1710, label %1668, !llvm.loop !46

1710:                                             ; preds = %1706, %1668, %1657
  %1711 = phi i64 [ %1666, %1657 ], [ %1662, %1706 ], [ %1670, %1668 ]
  %1712 = load ptr, ptr %81, align 8
  %1713 = getelementptr inbounds i8, ptr %1712, i64 48
  store i64 %1711, ptr %1713, align 8
  br label %1714

1714:                                             ; preds = %1698, %1710, %1653
  %1715 = phi i64 [ %1656, %1653 ], [ 0, %1710 ], [ %1705, %1698 ]
  %1716 = icmp eq i64 %1715, 0
  %1717 = icmp ne i64 %1646, 0
  %1718 = fcmp olt double %1645, 1.000000e+00
  %1719 = and i1 %1718, %1716
  %1720 = and i1 %1717, %1719
  br i1 %1720, label %1721, label %1758

1721:                                             ; preds = %1714
  %1722 = load ptr, ptr %171, align 8
  %1723 = load ptr, ptr %172, align 8
  %1724 = insertelement <8 x double> poison, double %1645, i64 0
  %1725 = shufflevector <8 x double> %1724, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1725, ptr %1723, align 8
  %1726 = load ptr, ptr %77, align 8
  %1727 = load ptr, ptr %173, align 8
  %1728 = load i64, ptr %174, align 8
  %1729 = load ptr, ptr %0, align 8
  %1730 = getelementptr inbounds i8, ptr %1729, i64 24
  %1731 = load i64, ptr %1730, align 8
  %1732 = load ptr, ptr %172, align 8
  %1733 = load ptr, ptr %76, align 8
  %1734 = getelementptr inbounds i8, ptr %1733, i64 16
  %1735 = load i64, ptr %1734, align 8
  tail call fastcc void @nested(ptr noundef %1722, ptr noundef %1726, ptr noundef %1727, i64 noundef %1728, i64 noundef %1731, ptr noundef %1732, i64 noundef %1735) #10
  %1736 = load i64, ptr %154, align 8
  %1737 = icmp sgt i64 %1736, 0
  br i1 %1737, label %1742, label %1738

1738:                                             ; preds = %1742, %1721
  %1739 = load ptr, ptr %84, align 8
  %1740 = load i64, ptr %1739, align 8
  %1741 = icmp eq i64 %1740, 1
  br i1 %1741, label %1752, label %1758

1742:                                             ; preds = %1721, %1742
  %1743 = phi i64 [ %1749, %1742 ], [ 0, %1721 ]
  %1744 = load ptr, ptr %171, align 8
  %1745 = getelementptr inbounds double, ptr %1744, i64 %1743
  %1746 = load double, ptr %1745, align 8
  %1747 = load ptr, ptr %147, align 8
  %1748 = getelementptr inbounds double, ptr %1747, i64 %1743
  store double %1746, ptr %1748, align 8
  %1749 = add nuw nsw i64 %1743, 1
  %1750 = load i64, ptr %154, align 8
  %1751 = icmp slt i64 %1749, %1750
  br i1 %1751, label %1742, label %1738, !llvm.loop !47

1752:                                             ; preds = %1738
  %1753 = load ptr, ptr %147, align 8
  %1754 = getelementptr inbounds i8, ptr %1739, i64 56
  %1755 = load i64, ptr %1754, align 8
  %1756 = inttoptr i64 %1755 to ptr
  %1757 = tail call i64 %1756(ptr noundef %0, double noundef %1654, ptr noundef %1753, ptr noundef null) #11
  br label %1758

1758:                                             ; preds = %1752, %1738, %1714
  %1759 = phi i64 [ %1757, %1752 ], [ 0, %1738 ], [ %1715, %1714 ]
  %1760 = icmp eq i64 %1759, 0
  br i1 %1760, label %1763, label %1761

1761:                                             ; preds = %1758
  store double %378, ptr %1632, align 8
  %1762 = getelementptr inbounds i8, ptr %1632, i64 8
  store double %414, ptr %1762, align 8
  br label %1819

1763:                                             ; preds = %1758
  br i1 %1647, label %1764, label %1802

1764:                                             ; preds = %1763
  %1765 = load ptr, ptr %147, align 8
  %1766 = load ptr, ptr %76, align 8
  %1767 = getelementptr inbounds i8, ptr %1766, i64 8
  %1768 = load i64, ptr %1767, align 8
  %1769 = load i64, ptr %83, align 8
  %1770 = load ptr, ptr %82, align 8
  %1771 = load ptr, ptr %81, align 8
  %1772 = getelementptr inbounds i8, ptr %1771, i64 48
  %1773 = load i64, ptr %1772, align 8
  %1774 = icmp slt i64 %1773, %1769
  br i1 %1774, label %1775, label %1798

1775:                                             ; preds = %1764
  %1776 = icmp sgt i64 %1768, 0
  br label %1777

1777:                                             ; preds = %1775, %1788
  %1778 = phi i64 [ %1773, %1775 ], [ %1789, %1788 ]
  %1779 = getelementptr inbounds double, ptr %1770, i64 %1778
  %1780 = load double, ptr %1779, align 8
  %1781 = load ptr, ptr %79, align 8
  %1782 = load double, ptr %1781, align 8
  %1783 = fcmp ugt double %1780, %1782
  br i1 %1783, label %1798, label %1784

1784:                                             ; preds = %1777
  br i1 %1776, label %1785, label %1788

1785:                                             ; preds = %1784
  %1786 = mul nsw i64 %1778, %1768
  %1787 = getelementptr double, ptr %1, i64 %1786
  br label %1791

1788:                                             ; preds = %1791, %1784
  %1789 = add i64 %1778, 1
  %1790 = icmp eq i64 %1789, %1769
  br i1 %1790, label %1798, label %1777, !llvm.loop !9

1791:                                             ; preds = %1785, %1791
  %1792 = phi i64 [ 0, %1785 ], [ %1796, %1791 ]
  %1793 = getelementptr inbounds double, ptr %1765, i64 %1792
  %1794 = load double, ptr %1793, align 8
  %1795 = getelementptr double, ptr %1787, i64 %1792
  store double %1794, ptr %1795, align 8
  %1796 = add nuw nsw i64 %1792, 1
  %1797 = icmp eq i64 %1796, %1768
  br i1 %1797, label %1788, label %1791, !llvm.loop !10

1798:                                             ; preds = %1788, %1777, %1764
  %1799 = phi i64 [ %1773, %1764 ], [ %1769, %1788 ], [ %1778, %1777 ]
  %1800 = load ptr, ptr %81, align 8
  %1801 = getelementptr inbounds i8, ptr %1800, i64 48
  store i64 %1799, ptr %1801, align 8
  br label %1802

1802:                                             ; preds = %1798, %1763
  br i1 %1717, label %1803, label %1819

1803:                                             ; preds = %1802
  %1804 = load i64, ptr %154, align 8
  %1805 = icmp sgt i64 %1804, 0
  br i1 %1805, label %1809, label %1806

1806:                                             ; preds = %1809, %1803
  store double %1654, ptr %1632, align 8
  %1807 = getelementptr inbounds i8, ptr %1632, i64 8
  store double 0.000000e+00, ptr %1807, align 8
  %1808 = load ptr, ptr %81, align 8
  store i64 0, ptr %1808, align 8
  br label %1819

1809:                                             ; preds = %1803, %1809
  %1810 = phi i64 [ %1816, %1809 ], [ 0, %1803 ]
  %1811 = load ptr, ptr %147, align 8
  %1812 = getelementptr inbounds double, ptr %1811, i64 %1810
  %1813 = load double, ptr %1812, align 8
  %1814 = load ptr, ptr %77, align 8
  %1815 = getelementptr inbounds double, ptr %1814, i64 %1810
  store double %1813, ptr %1815, align 8
  %1816 = add nuw nsw i64 %1810, 1
  %1817 = load i64, ptr %154, align 8
  %1818 = icmp slt i64 %1816, %1817
  br i1 %1818, label %1809, label %1806, !llvm.loop !48

1819:                                             ; preds = %1640, %1761, %1802, %1806
  %1820 = phi i64 [ -6, %1640 ], [ %1759, %1761 ], [ %1646, %1806 ], [ %1646, %1802 ]
  %1821 = icmp eq i64 %1820, -6
  br i1 %1821, label %1825, label %1822

1822:                                             ; preds = %1819
  %1823 = icmp ne i64 %1820, 6
  %1824 = select i1 %1823, i1 true, i1 %210
  br i1 %1824, label %1837, label %1825

1825:                                             ; preds = %1822, %1819
  %1826 = phi i64 [ %1820, %1822 ], [ 2, %1819 ]
  %1827 = load i64, ptr %335, align 8
  %1828 = add nsw i64 %1827, -1
  store i64 %1828, ptr %335, align 8
  %1829 = load ptr, ptr %93, align 8
  %1830 = load i64, ptr %1829, align 8
  %1831 = add nsw i64 %1830, -1
  store i64 %1831, ptr %1829, align 8
  store i64 1, ptr %349, align 8
  %1832 = load i64, ptr %363, align 8
  %1833 = sub nsw i64 1, %1832
  store i64 %1833, ptr %339, align 8
  store double 0.000000e+00, ptr %344, align 8
  %1834 = load i64, ptr %336, align 8
  %1835 = add nsw i64 %1834, 1
  store i64 %1835, ptr %336, align 8
  store i64 %1826, ptr %364, align 8
  %1836 = fmul double %414, 2.500000e-01
  br label %1893, !llvm.loop !17

1837:                                             ; preds = %1822
  %1838 = icmp eq i64 %1820, 0
  br i1 %1838, label %1843, label %1839

1839:                                             ; preds = %1837
  %1840 = load ptr, ptr %93, align 8
  %1841 = load i64, ptr %1840, align 8
  %1842 = add nsw i64 %1841, 1
  store i64 %1842, ptr %1840, align 8
  br label %1893

1843:                                             ; preds = %1837, %1626
  br i1 %358, label %1862, label %1844

1844:                                             ; preds = %1862, %1843
  %1845 = load i64, ptr %359, align 8
  %1846 = add nsw i64 %1845, 1
  store i64 %1846, ptr %359, align 8
  %1847 = load ptr, ptr %77, align 8
  %1848 = load ptr, ptr %175, align 8
  %1849 = load ptr, ptr %176, align 8
  store double %415, ptr %1849, align 8
  %1850 = load i64, ptr %177, align 8
  %1851 = icmp sgt i64 %1850, 0
  br i1 %1851, label %1852, label %1853

1852:                                             ; preds = %1844
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1853

1853:                                             ; preds = %1844, %1852
  %1854 = load ptr, ptr %76, align 8
  %1855 = load i64, ptr %1854, align 8
  %1856 = load ptr, ptr %176, align 8
  %1857 = load ptr, ptr %178, align 8
  %1858 = load ptr, ptr %179, align 8
  %1859 = inttoptr i64 %1855 to ptr
  %1860 = tail call i32 %1859(ptr noundef %1856, ptr noundef %1847, ptr noundef %1857, ptr noundef %1858, ptr noundef %1848) #11
  %1861 = icmp eq i32 %1860, 0
  br i1 %1861, label %1874, label %1871

1862:                                             ; preds = %1843, %1862
  %1863 = phi i64 [ %1869, %1862 ], [ 0, %1843 ]
  %1864 = load ptr, ptr %147, align 8
  %1865 = getelementptr inbounds double, ptr %1864, i64 %1863
  %1866 = load double, ptr %1865, align 8
  %1867 = load ptr, ptr %77, align 8
  %1868 = getelementptr inbounds double, ptr %1867, i64 %1863
  store double %1866, ptr %1868, align 8
  %1869 = add nuw nsw i64 %1863, 1
  %1870 = icmp eq i64 %1869, %198
  br i1 %1870, label %1844, label %1862, !llvm.loop !49

1871:                                             ; preds = %1853
  store i64 3, ptr %360, align 8
  store double %414, ptr %225, align 8
  %1872 = icmp slt i32 %1860, 0
  %1873 = select i1 %1872, i64 -4, i64 2
  br label %1893

1874:                                             ; preds = %1853
  %1875 = icmp sgt i64 %1149, 2
  %1876 = fcmp ogt double %1147, 1.000000e-03
  %1877 = select i1 %1875, i1 %1876, i1 false
  %1878 = zext i1 %1877 to i64
  store i64 %1878, ptr %339, align 8
  store i64 0, ptr %361, align 8
  store i64 0, ptr %349, align 8
  %1879 = fcmp ule double %1387, 1.000000e+00
  %1880 = fcmp uge double %1387, 1.200000e+00
  %1881 = or i1 %1879, %1880
  %1882 = select i1 %1881, i1 true, i1 %1877
  br i1 %1882, label %1883, label %1887

1883:                                             ; preds = %1874
  %1884 = fcmp ogt double %1387, 2.000000e-01
  %1885 = select i1 %1884, double %1387, double 2.000000e-01
  %1886 = fmul double %414, %1885
  br label %1887

1887:                                             ; preds = %1874, %1883
  %1888 = phi double [ %1886, %1883 ], [ %414, %1874 ]
  %1889 = load i64, ptr %362, align 8
  %1890 = load i64, ptr %83, align 8
  %1891 = icmp eq i64 %1889, %1890
  br i1 %1891, label %1892, label %1893

1892:                                             ; preds = %1887
  store double %1888, ptr %225, align 8
  br label %1893

1893:                                             ; preds = %1146, %1189, %1201, %1892, %1887, %1871, %1839, %1825, %1355, %1340, %1302, %605, %540, %421
  %1894 = phi double [ %383, %421 ], [ %383, %540 ], [ %383, %605 ], [ %1147, %1302 ], [ %1147, %1340 ], [ %1147, %1355 ], [ %1147, %1825 ], [ %1147, %1839 ], [ %1147, %1871 ], [ %1147, %1887 ], [ %1147, %1892 ], [ %1147, %1201 ], [ %1147, %1189 ], [ %1147, %1146 ]
  %1895 = phi i32 [ %382, %421 ], [ %382, %540 ], [ %382, %605 ], [ %1148, %1302 ], [ %1148, %1340 ], [ %1148, %1355 ], [ %1148, %1825 ], [ %1148, %1839 ], [ %1148, %1871 ], [ %1148, %1887 ], [ %1148, %1892 ], [ %1148, %1201 ], [ %1148, %1189 ], [ %1148, %1146 ]
  %1896 = phi i64 [ %381, %421 ], [ %381, %540 ], [ %381, %605 ], [ %1149, %1302 ], [ %1149, %1340 ], [ %1149, %1355 ], [ %1149, %1825 ], [ %1149, %1839 ], [ %1149, %1871 ], [ %1149, %1887 ], [ %1149, %1892 ], [ %1149, %1201 ], [ %1149, %1189 ], [ %1149, %1146 ]
  %1897 = phi i64 [ %380, %421 ], [ %380, %540 ], [ %380, %605 ], [ %1150, %1302 ], [ %1150, %1340 ], [ %1150, %1355 ], [ %1150, %1825 ], [ %1150, %1839 ], [ %1150, %1871 ], [ %1150, %1887 ], [ %1150, %1892 ], [ %1150, %1201 ], [ %1150, %1189 ], [ %1150, %1146 ]
  %1898 = phi double [ %379, %421 ], [ %379, %540 ], [ %608, %605 ], [ %379, %1302 ], [ %1342, %1340 ], [ %1358, %1355 ], [ %1836, %1825 ], [ %379, %1839 ], [ %379, %1871 ], [ %1888, %1887 ], [ %1888, %1892 ], [ %1202, %1201 ], [ %379, %1189 ], [ %379, %1146 ]
  %1899 = phi double [ %378, %421 ], [ %378, %540 ], [ %378, %605 ], [ %378, %1302 ], [ %378, %1340 ], [ %378, %1355 ], [ %378, %1825 ], [ %378, %1839 ], [ %415, %1871 ], [ %415, %1887 ], [ %415, %1892 ], [ %378, %1201 ], [ %378, %1189 ], [ %378, %1146 ]
  %1900 = phi i32 [ 1, %421 ], [ 1, %540 ], [ 6, %605 ], [ 1, %1302 ], [ 6, %1340 ], [ 6, %1355 ], [ 6, %1825 ], [ 1, %1839 ], [ 1, %1871 ], [ 0, %1887 ], [ 1, %1892 ], [ 6, %1201 ], [ 6, %1189 ], [ 1, %1146 ]
  %1901 = phi i64 [ 2, %421 ], [ -4, %540 ], [ %377, %605 ], [ -4, %1302 ], [ %377, %1340 ], [ %377, %1355 ], [ %377, %1825 ], [ %1820, %1839 ], [ %1873, %1871 ], [ %377, %1887 ], [ 0, %1892 ], [ %377, %1201 ], [ %377, %1189 ], [ -4, %1146 ]
  switch i32 %1900, label %1905 [
    i32 0, label %1902
    i32 6, label %1902
  ]

1902:                                             ; preds = %1893, %1893
  %1903 = load i64, ptr %192, align 8
  %1904 = icmp eq i64 %1903, 0
  br i1 %1904, label %369, label %375, !llvm.loop !17

1905:                                             ; preds = %1893, %183, %257, %299, %369, %396, %404
  %1906 = phi double [ %184, %183 ], [ %370, %369 ], [ %383, %404 ], [ %383, %396 ], [ %184, %299 ], [ %184, %257 ], [ %1894, %1893 ]
  %1907 = phi i32 [ %185, %183 ], [ %371, %369 ], [ %382, %404 ], [ %382, %396 ], [ %185, %299 ], [ %185, %257 ], [ %1895, %1893 ]
  %1908 = phi i64 [ %186, %183 ], [ %372, %369 ], [ %381, %404 ], [ %381, %396 ], [ %186, %299 ], [ %186, %257 ], [ %1896, %1893 ]
  %1909 = phi i64 [ %187, %183 ], [ %373, %369 ], [ %380, %404 ], [ %380, %396 ], [ %187, %299 ], [ %187, %257 ], [ %1897, %1893 ]
  %1910 = phi i64 [ -1, %183 ], [ -1, %369 ], [ 1, %404 ], [ -5, %396 ], [ 0, %299 ], [ %260, %257 ], [ %1901, %1893 ]
  %1911 = load ptr, ptr %182, align 8
  %1912 = getelementptr inbounds i8, ptr %1911, i64 48
  %1913 = load i64, ptr %1912, align 8
  %1914 = icmp ne i64 %1910, -2
  %1915 = icmp eq i64 %1913, 0
  %1916 = select i1 %1914, i1 true, i1 %1915
  br i1 %1916, label %1924, label %1917

1917:                                             ; preds = %1905
  %1918 = inttoptr i64 %1913 to ptr
  %1919 = tail call i64 %1918(ptr noundef %0) #11
  %1920 = icmp eq i64 %1919, 8
  %1921 = select i1 %1920, i64 8, i64 %1910
  %1922 = icmp eq i64 %1919, 1
  %1923 = zext i1 %1922 to i32
  br label %1924

1924:                                             ; preds = %1905, %1917
  %1925 = phi i64 [ %1910, %1905 ], [ %1921, %1917 ]
  %1926 = phi i32 [ 0, %1905 ], [ %1923, %1917 ]
  %1927 = icmp eq i32 %1926, 0
  br i1 %1927, label %1928, label %183, !llvm.loop !50

1928:                                             ; preds = %1924
  ret i64 %1925
}



declare double @llvm.sqrt.f64(double) #2

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

declare double @llvm.fabs.f64(double) #2

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
