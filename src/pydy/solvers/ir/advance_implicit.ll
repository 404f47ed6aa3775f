; sources 1318f92e8c0dead211c7912bacf5e972cab60ed9580edf00ca8f3630f4d76818
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

183:                                              ; preds = %1936, %75
  %184 = phi double [ undef, %75 ], [ %1918, %1936 ]
  %185 = phi i32 [ undef, %75 ], [ %1919, %1936 ]
  %186 = phi i64 [ undef, %75 ], [ %1920, %1936 ]
  %187 = phi i64 [ undef, %75 ], [ %1921, %1936 ]
  %188 = load ptr, ptr %79, align 8
  %189 = load ptr, ptr %80, align 8
  %190 = load ptr, ptr %81, align 8
  %191 = load ptr, ptr %78, align 8
  %192 = getelementptr inbounds i8, ptr %190, i64 56
  %193 = load i64, ptr %192, align 8
  %194 = icmp eq i64 %193, 0
  br i1 %194, label %1917, label %195

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
  br i1 %228, label %238, label %331

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
  %255 = load ptr, ptr %254, align 8
  %256 = tail call i32 %255(ptr noundef %251, ptr noundef %242, ptr noundef %252, ptr noundef %253, ptr noundef %243) #11
  %257 = icmp eq i32 %256, 0
  br i1 %257, label %262, label %258

258:                                              ; preds = %248
  %259 = getelementptr inbounds i8, ptr %190, i64 72
  store i64 3, ptr %259, align 8
  %260 = icmp slt i32 %256, 0
  %261 = select i1 %260, i64 -4, i64 2
  br label %1917

262:                                              ; preds = %248
  store i64 1, ptr %190, align 8
  %263 = getelementptr inbounds i8, ptr %188, i64 24
  store double 0.000000e+00, ptr %263, align 8
  %264 = getelementptr inbounds i8, ptr %191, i64 32
  store i64 1, ptr %264, align 8
  %265 = getelementptr inbounds i8, ptr %191, i64 8
  store i64 1, ptr %265, align 8
  %266 = getelementptr inbounds i8, ptr %189, i64 8
  store double 0.000000e+00, ptr %266, align 8
  %267 = load ptr, ptr %77, align 8
  %268 = load ptr, ptr %76, align 8
  %269 = getelementptr inbounds i8, ptr %268, i64 8
  %270 = load i64, ptr %269, align 8
  %271 = load i64, ptr %83, align 8
  %272 = load ptr, ptr %82, align 8
  %273 = load ptr, ptr %81, align 8
  %274 = getelementptr inbounds i8, ptr %273, i64 48
  %275 = load i64, ptr %274, align 8
  %276 = icmp slt i64 %275, %271
  br i1 %276, label %277, label %300

277:                                              ; preds = %262
  %278 = icmp sgt i64 %270, 0
  br label %279

279:                                              ; preds = %277, %290
  %280 = phi i64 [ %275, %277 ], [ %291, %290 ]
  %281 = getelementptr inbounds double, ptr %272, i64 %280
  %282 = load double, ptr %281, align 8
  %283 = load ptr, ptr %79, align 8
  %284 = load double, ptr %283, align 8
  %285 = fcmp ugt double %282, %284
  br i1 %285, label %300, label %286

286:                                              ; preds = %279
  br i1 %278, label %287, label %290

287:                                              ; preds = %286
  %288 = mul nsw i64 %280, %270
  %289 = getelementptr double, ptr %1, i64 %288
  br label %293

290:                                              ; preds = %293, %286
  %291 = add i64 %280, 1
  %292 = icmp eq i64 %291, %271
  br i1 %292, label %300, label %279, !llvm.loop !9

293:                                              ; preds = %287, %293
  %294 = phi i64 [ 0, %287 ], [ %298, %293 ]
  %295 = getelementptr inbounds double, ptr %267, i64 %294
  %296 = load double, ptr %295, align 8
  %297 = getelementptr double, ptr %289, i64 %294
  store double %296, ptr %297, align 8
  %298 = add nuw nsw i64 %294, 1
  %299 = icmp eq i64 %298, %270
  br i1 %299, label %290, label %293, !llvm.loop !10

300:                                              ; preds = %279, %290, %262
  %301 = phi i64 [ %275, %262 ], [ %280, %279 ], [ %271, %290 ]
  %302 = load ptr, ptr %81, align 8
  %303 = getelementptr inbounds i8, ptr %302, i64 48
  store i64 %301, ptr %303, align 8
  %304 = icmp eq i64 %301, %271
  br i1 %304, label %1917, label %305

305:                                              ; preds = %300
  %306 = fcmp oeq double %226, 0.000000e+00
  br i1 %306, label %307, label %331

307:                                              ; preds = %305
  %308 = getelementptr inbounds i8, ptr %188, i64 16
  %309 = load double, ptr %308, align 8
  %310 = load ptr, ptr %77, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %310, ptr noundef %310, ptr noundef nonnull %77, i64 noundef %198) #10
  %311 = load double, ptr %4, align 8
  %312 = load ptr, ptr %92, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %312, ptr noundef %310, ptr noundef nonnull %77, i64 noundef %198) #10
  %313 = load double, ptr %5, align 8
  %314 = fcmp uge double %311, 1.000000e-05
  %315 = fcmp uge double %313, 1.000000e-05
  %316 = and i1 %314, %315
  %317 = fmul double %311, 1.000000e-02
  %318 = fdiv double %317, %313
  %319 = select i1 %316, double %318, double 0x3EB0C6F7A0B5ED8D
  %320 = fcmp olt double %309, %319
  %321 = select i1 %320, double %309, double %319
  %322 = tail call double @llvm.fabs.f64(double %224)
  %323 = fmul double %322, 0x3D30000000000000
  %324 = fcmp ogt double %323, %321
  %325 = select i1 %324, double %323, double %321
  %326 = fcmp olt double %309, %325
  %327 = select i1 %326, double %309, double %325
  %328 = tail call i1 @llvm.is.fpclass.f64(double %327, i32 639)
  br i1 %328, label %329, label %331

329:                                              ; preds = %307
  %330 = getelementptr inbounds i8, ptr %190, i64 72
  store i64 4, ptr %330, align 8
  br label %331

331:                                              ; preds = %307, %329, %305, %214
  %332 = phi double [ %226, %305 ], [ %226, %214 ], [ %327, %329 ], [ %327, %307 ]
  %333 = load i64, ptr %192, align 8
  %334 = icmp eq i64 %333, 0
  br i1 %334, label %370, label %335

335:                                              ; preds = %331
  %336 = getelementptr inbounds i8, ptr %190, i64 8
  %337 = getelementptr inbounds i8, ptr %190, i64 16
  %338 = getelementptr inbounds i8, ptr %190, i64 64
  %339 = getelementptr inbounds i8, ptr %188, i64 16
  %340 = getelementptr inbounds i8, ptr %191, i64 8
  %341 = getelementptr inbounds i8, ptr %191, i64 16
  %342 = getelementptr inbounds i8, ptr %191, i64 24
  %343 = getelementptr inbounds i8, ptr %191, i64 24
  %344 = getelementptr inbounds i8, ptr %190, i64 40
  %345 = getelementptr inbounds i8, ptr %189, i64 8
  %346 = fmul double %215, %223
  %347 = fmul double %346, %346
  %348 = icmp sgt i64 %198, 0
  %349 = shl i64 %198, 4
  %350 = getelementptr inbounds i8, ptr %191, i64 32
  %351 = getelementptr inbounds i8, ptr %190, i64 72
  %352 = getelementptr inbounds i8, ptr %191, i64 16
  %353 = getelementptr inbounds i8, ptr %190, i64 72
  %354 = getelementptr inbounds i8, ptr %191, i64 16
  %355 = getelementptr inbounds i8, ptr %188, i64 24
  %356 = getelementptr inbounds i8, ptr %188, i64 32
  %357 = getelementptr inbounds i8, ptr %188, i64 32
  %358 = getelementptr inbounds i8, ptr %190, i64 48
  %359 = icmp sgt i64 %198, 0
  %360 = getelementptr inbounds i8, ptr %190, i64 24
  %361 = getelementptr inbounds i8, ptr %190, i64 72
  %362 = getelementptr inbounds i8, ptr %191, i64 16
  %363 = getelementptr inbounds i8, ptr %190, i64 48
  %364 = getelementptr inbounds i8, ptr %191, i64 16
  %365 = getelementptr inbounds i8, ptr %190, i64 72
  %366 = getelementptr inbounds i8, ptr %190, i64 72
  %367 = getelementptr inbounds i8, ptr %191, i64 16
  %368 = getelementptr inbounds i8, ptr %190, i64 72
  %369 = getelementptr inbounds i8, ptr %191, i64 16
  br label %376

370:                                              ; preds = %1914, %331
  %371 = phi double [ %184, %331 ], [ %1906, %1914 ]
  %372 = phi i32 [ %185, %331 ], [ %1907, %1914 ]
  %373 = phi i64 [ %186, %331 ], [ %1908, %1914 ]
  %374 = phi i64 [ %187, %331 ], [ %1909, %1914 ]
  %375 = phi double [ %332, %331 ], [ %1910, %1914 ]
  store double %375, ptr %225, align 8
  br label %1917

376:                                              ; preds = %335, %1914
  %377 = phi i64 [ %333, %335 ], [ %1915, %1914 ]
  %378 = phi i64 [ undef, %335 ], [ %1913, %1914 ]
  %379 = phi double [ %224, %335 ], [ %1911, %1914 ]
  %380 = phi double [ %332, %335 ], [ %1910, %1914 ]
  %381 = phi i64 [ %187, %335 ], [ %1909, %1914 ]
  %382 = phi i64 [ %186, %335 ], [ %1908, %1914 ]
  %383 = phi i32 [ %185, %335 ], [ %1907, %1914 ]
  %384 = phi double [ %184, %335 ], [ %1906, %1914 ]
  %385 = load ptr, ptr %93, align 8
  %386 = getelementptr inbounds i8, ptr %385, i64 8
  %387 = load i64, ptr %386, align 8
  %388 = icmp sgt i64 %387, 0
  br i1 %388, label %389, label %394

389:                                              ; preds = %376
  %390 = load i64, ptr %385, align 8
  %391 = add nsw i64 %390, 3
  %392 = icmp slt i64 %387, %391
  %393 = zext i1 %392 to i32
  br label %394

394:                                              ; preds = %376, %389
  %395 = phi i32 [ 0, %376 ], [ %393, %389 ]
  %396 = icmp eq i32 %395, 0
  br i1 %396, label %398, label %397

397:                                              ; preds = %394
  store double %380, ptr %225, align 8
  br label %1917

398:                                              ; preds = %394
  %399 = add nsw i64 %377, -1
  store i64 %399, ptr %192, align 8
  %400 = load i64, ptr %336, align 8
  %401 = load i64, ptr %337, align 8
  %402 = add nsw i64 %401, %400
  %403 = load i64, ptr %338, align 8
  %404 = icmp slt i64 %402, %403
  br i1 %404, label %406, label %405

405:                                              ; preds = %398
  store double %380, ptr %225, align 8
  br label %1917

406:                                              ; preds = %398
  %407 = load double, ptr %339, align 8
  %408 = fcmp olt double %380, %407
  %409 = select i1 %408, double %380, double %407
  %410 = fadd double %379, %409
  %411 = fmul double %409, 1.000000e-03
  %412 = fsub double %203, %411
  %413 = fcmp ule double %410, %412
  %414 = select i1 %413, double %410, double %203
  %415 = fsub double %414, %379
  %416 = fmul double %415, 6.250000e-02
  %417 = fadd double %379, %416
  %418 = fcmp ule double %417, %379
  %419 = fcmp une double %414, %203
  %420 = and i1 %419, %418
  br i1 %420, label %421, label %422

421:                                              ; preds = %406
  store double %415, ptr %225, align 8
  br label %1905

422:                                              ; preds = %406
  %423 = load i64, ptr %340, align 8
  %424 = icmp eq i64 %423, 1
  br i1 %424, label %425, label %545

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
  br i1 %437, label %457, label %455

438:                                              ; preds = %425
  %439 = load ptr, ptr %95, align 8
  store double %379, ptr %439, align 8
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
  %452 = load ptr, ptr %451, align 8
  %453 = tail call i32 %452(ptr noundef %446, ptr noundef %447, ptr noundef %448, ptr noundef %449, ptr noundef %450) #11
  %454 = sext i32 %453 to i64
  br label %526

455:                                              ; preds = %457, %436
  %456 = icmp sgt i64 %432, 0
  br i1 %456, label %469, label %526

457:                                              ; preds = %436, %457
  %458 = phi i64 [ %464, %457 ], [ 0, %436 ]
  %459 = load ptr, ptr %77, align 8
  %460 = getelementptr inbounds double, ptr %459, i64 %458
  %461 = load double, ptr %460, align 8
  %462 = load ptr, ptr %100, align 8
  %463 = getelementptr inbounds double, ptr %462, i64 %458
  store double %461, ptr %463, align 8
  %464 = add nuw nsw i64 %458, 1
  %465 = icmp eq i64 %464, %432
  br i1 %465, label %455, label %457, !llvm.loop !11

466:                                              ; preds = %524
  %467 = add nuw nsw i64 %471, 1
  %468 = icmp eq i64 %467, %432
  br i1 %468, label %526, label %469, !llvm.loop !12

469:                                              ; preds = %455, %466
  %470 = phi i64 [ %525, %466 ], [ undef, %455 ]
  %471 = phi i64 [ %467, %466 ], [ 0, %455 ]
  %472 = load ptr, ptr %77, align 8
  %473 = getelementptr inbounds double, ptr %472, i64 %471
  %474 = load double, ptr %473, align 8
  %475 = tail call double @llvm.fabs.f64(double %474)
  %476 = fcmp olt double %475, 1.000000e-05
  %477 = select i1 %476, double 1.000000e-05, double %475
  %478 = fmul double %477, 1.500000e-08
  %479 = fadd double %474, %478
  %480 = load ptr, ptr %101, align 8
  %481 = getelementptr inbounds double, ptr %480, i64 %471
  store double %479, ptr %481, align 8
  %482 = load ptr, ptr %81, align 8
  %483 = getelementptr inbounds i8, ptr %482, i64 24
  %484 = load i64, ptr %483, align 8
  %485 = add nsw i64 %484, 1
  store i64 %485, ptr %483, align 8
  %486 = load ptr, ptr %101, align 8
  %487 = load ptr, ptr %102, align 8
  %488 = load ptr, ptr %103, align 8
  store double %379, ptr %488, align 8
  %489 = load i64, ptr %104, align 8
  %490 = icmp sgt i64 %489, 0
  br i1 %490, label %491, label %492

491:                                              ; preds = %469
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %492

492:                                              ; preds = %491, %469
  %493 = load ptr, ptr %76, align 8
  %494 = load i64, ptr %493, align 8
  %495 = load ptr, ptr %103, align 8
  %496 = load ptr, ptr %105, align 8
  %497 = load ptr, ptr %106, align 8
  %498 = inttoptr i64 %494 to ptr
  %499 = load ptr, ptr %498, align 8
  %500 = tail call i32 %499(ptr noundef %495, ptr noundef %486, ptr noundef %496, ptr noundef %497, ptr noundef %487) #11
  %501 = sext i32 %500 to i64
  %502 = icmp eq i32 %500, 0
  br i1 %502, label %503, label %524

503:                                              ; preds = %492
  %504 = fsub double %479, %474
  br label %508

505:                                              ; preds = %508
  %506 = load ptr, ptr %101, align 8
  %507 = getelementptr inbounds double, ptr %506, i64 %471
  store double %474, ptr %507, align 8
  br label %524

508:                                              ; preds = %503, %508
  %509 = phi i64 [ 0, %503 ], [ %522, %508 ]
  %510 = load ptr, ptr %102, align 8
  %511 = getelementptr inbounds double, ptr %510, i64 %509
  %512 = load double, ptr %511, align 8
  %513 = load ptr, ptr %107, align 8
  %514 = getelementptr inbounds double, ptr %513, i64 %509
  %515 = load double, ptr %514, align 8
  %516 = fsub double %512, %515
  %517 = fdiv double %516, %504
  %518 = load ptr, ptr %94, align 8
  %519 = mul nuw nsw i64 %509, %432
  %520 = getelementptr double, ptr %518, i64 %519
  %521 = getelementptr double, ptr %520, i64 %471
  store double %517, ptr %521, align 8
  %522 = add nuw nsw i64 %509, 1
  %523 = icmp eq i64 %522, %432
  br i1 %523, label %505, label %508, !llvm.loop !13

524:                                              ; preds = %505, %492
  %525 = phi i64 [ %470, %505 ], [ %501, %492 ]
  br i1 %502, label %466, label %526

526:                                              ; preds = %524, %466, %455, %443
  %527 = phi i64 [ %454, %443 ], [ 0, %455 ], [ 0, %466 ], [ %525, %524 ]
  %528 = load i64, ptr %108, align 8
  %529 = icmp sgt i64 %528, 0
  br i1 %529, label %530, label %542

530:                                              ; preds = %526, %538
  %531 = phi i64 [ %539, %538 ], [ 0, %526 ]
  %532 = load ptr, ptr %94, align 8
  %533 = getelementptr inbounds double, ptr %532, i64 %531
  %534 = load double, ptr %533, align 8
  %535 = tail call double @llvm.fabs.f64(double %534)
  %536 = fcmp ueq double %535, 0x7FF0000000000000
  br i1 %536, label %537, label %538

537:                                              ; preds = %530
  store double 0.000000e+00, ptr %533, align 8
  br label %538

538:                                              ; preds = %537, %530
  %539 = add nuw nsw i64 %531, 1
  %540 = load i64, ptr %108, align 8
  %541 = icmp slt i64 %539, %540
  br i1 %541, label %530, label %542, !llvm.loop !14

542:                                              ; preds = %538, %526
  %543 = icmp slt i64 %527, 0
  br i1 %543, label %1905, label %544

544:                                              ; preds = %542
  store i64 0, ptr %340, align 8
  store i64 1, ptr %341, align 8
  store i64 0, ptr %342, align 8
  br label %545

545:                                              ; preds = %544, %422
  %546 = load i64, ptr %343, align 8
  %547 = icmp eq i64 %546, 0
  br i1 %547, label %555, label %548

548:                                              ; preds = %545
  %549 = tail call double @llvm.fabs.f64(double %414)
  %550 = fmul double %549, 0x3CB0000000000000
  %551 = load double, ptr %189, align 8
  %552 = fsub double %415, %551
  %553 = tail call double @llvm.fabs.f64(double %552)
  %554 = fcmp ogt double %553, %550
  br i1 %554, label %555, label %618

555:                                              ; preds = %548, %545
  %556 = load i64, ptr %344, align 8
  %557 = add nsw i64 %556, 1
  store i64 %557, ptr %344, align 8
  %558 = load i64, ptr %110, align 8
  %559 = load ptr, ptr %111, align 8
  %560 = load ptr, ptr %112, align 8
  %561 = icmp sgt i64 %558, 0
  br i1 %561, label %562, label %570

562:                                              ; preds = %555
  %563 = fdiv double 0x400D1A48D83E731D, %415
  %564 = add nuw i64 %558, 1
  %565 = fdiv double 0x400572DB93E0C672, %415
  %566 = fdiv double 0x40086747F2C3FCB6, %415
  br label %567

567:                                              ; preds = %562, %574
  %568 = phi i64 [ 0, %562 ], [ %585, %574 ]
  %569 = mul nuw nsw i64 %568, %558
  br label %587

570:                                              ; preds = %574, %555
  %571 = load ptr, ptr %109, align 8
  %572 = tail call fastcc i32 @real_factorise(ptr noundef %559, i64 noundef %558, ptr noundef %571) #10
  %573 = icmp eq i32 %572, 0
  br i1 %573, label %608, label %603

574:                                              ; preds = %587
  %575 = mul i64 %568, %564
  %576 = getelementptr inbounds double, ptr %559, i64 %575
  %577 = load double, ptr %576, align 8
  %578 = fadd double %563, %577
  store double %578, ptr %576, align 8
  %579 = getelementptr inbounds { double, double }, ptr %560, i64 %575
  %580 = load double, ptr %579, align 8
  %581 = getelementptr inbounds i8, ptr %579, i64 8
  %582 = load double, ptr %581, align 8
  %583 = fadd double %565, %580
  %584 = fsub double %582, %566
  store double %583, ptr %579, align 8
  store double %584, ptr %581, align 8
  %585 = add nuw nsw i64 %568, 1
  %586 = icmp eq i64 %585, %558
  br i1 %586, label %570, label %567, !llvm.loop !15

587:                                              ; preds = %567, %587
  %588 = phi i64 [ 0, %567 ], [ %601, %587 ]
  %589 = load ptr, ptr %113, align 8
  %590 = add nuw nsw i64 %588, %569
  %591 = getelementptr inbounds double, ptr %589, i64 %590
  %592 = load double, ptr %591, align 8
  %593 = fneg double %592
  %594 = getelementptr inbounds double, ptr %559, i64 %590
  store double %593, ptr %594, align 8
  %595 = load ptr, ptr %113, align 8
  %596 = getelementptr inbounds double, ptr %595, i64 %590
  %597 = load double, ptr %596, align 8
  %598 = fneg double %597
  %599 = getelementptr inbounds { double, double }, ptr %560, i64 %590
  %600 = getelementptr inbounds i8, ptr %599, i64 8
  store double %598, ptr %599, align 8
  store double 0.000000e+00, ptr %600, align 8
  %601 = add nuw nsw i64 %588, 1
  %602 = icmp eq i64 %601, %558
  br i1 %602, label %574, label %587, !llvm.loop !16

603:                                              ; preds = %570
  %604 = load ptr, ptr %114, align 8
  %605 = tail call fastcc i32 @pair_factorise(ptr noundef %560, i64 noundef %558, ptr noundef %604) #10
  %606 = icmp ne i32 %605, 0
  %607 = zext i1 %606 to i32
  br label %608

608:                                              ; preds = %570, %603
  %609 = phi i32 [ 0, %570 ], [ %607, %603 ]
  %610 = icmp eq i32 %609, 0
  br i1 %610, label %611, label %617

611:                                              ; preds = %608
  store i64 4, ptr %368, align 8
  %612 = load i64, ptr %337, align 8
  %613 = add nsw i64 %612, 1
  store i64 %613, ptr %337, align 8
  %614 = fmul double %415, 5.000000e-01
  %615 = load i64, ptr %369, align 8
  %616 = sub nsw i64 1, %615
  store i64 %616, ptr %340, align 8
  store i64 0, ptr %343, align 8
  br label %1905, !llvm.loop !17

617:                                              ; preds = %608
  store i64 1, ptr %343, align 8
  store double %415, ptr %189, align 8
  br label %618

618:                                              ; preds = %617, %548
  %619 = load double, ptr %345, align 8
  %620 = load ptr, ptr %76, align 8
  %621 = getelementptr inbounds i8, ptr %620, i64 8
  %622 = load i64, ptr %621, align 8
  %623 = load ptr, ptr %115, align 8
  %624 = load ptr, ptr %77, align 8
  %625 = load ptr, ptr %116, align 8
  %626 = load ptr, ptr %117, align 8
  %627 = fcmp ogt double %619, 0.000000e+00
  %628 = icmp sgt i64 %622, 0
  %629 = shl i64 %622, 4
  %630 = getelementptr i8, ptr %623, i64 %629
  %631 = mul i64 %622, 24
  %632 = getelementptr i8, ptr %623, i64 %631
  %633 = getelementptr double, ptr %623, i64 %622
  br label %639

634:                                              ; preds = %653
  %635 = icmp sgt i64 %622, 0
  %636 = getelementptr double, ptr %625, i64 %622
  %637 = shl i64 %622, 4
  %638 = getelementptr i8, ptr %625, i64 %637
  br label %680

639:                                              ; preds = %618, %653
  %640 = phi i64 [ 0, %618 ], [ %654, %653 ]
  br i1 %627, label %641, label %647

641:                                              ; preds = %639
  %642 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %640
  %643 = load double, ptr %642, align 8
  %644 = fmul double %415, %643
  %645 = fdiv double %644, %619
  %646 = fadd double %645, 1.000000e+00
  br label %647

647:                                              ; preds = %641, %639
  %648 = phi double [ %646, %641 ], [ 0.000000e+00, %639 ]
  br i1 %628, label %649, label %653

649:                                              ; preds = %647
  %650 = mul nuw nsw i64 %622, %640
  %651 = getelementptr double, ptr %625, i64 %650
  %652 = fsub double 1.000000e+00, %648
  br label %656

653:                                              ; preds = %677, %647
  %654 = add nuw nsw i64 %640, 1
  %655 = icmp eq i64 %654, 3
  br i1 %655, label %634, label %639, !llvm.loop !18

656:                                              ; preds = %649, %677
  %657 = phi i64 [ 0, %649 ], [ %678, %677 ]
  %658 = getelementptr double, ptr %651, i64 %657
  store double 0.000000e+00, ptr %658, align 8
  br i1 %627, label %659, label %677

659:                                              ; preds = %656
  %660 = getelementptr double, ptr %630, i64 %657
  %661 = load double, ptr %660, align 8
  %662 = getelementptr double, ptr %632, i64 %657
  %663 = load double, ptr %662, align 8
  %664 = fmul double %648, %663
  %665 = fadd double %661, %664
  %666 = fmul double %652, %665
  %667 = getelementptr inbounds double, ptr %623, i64 %657
  %668 = load double, ptr %667, align 8
  %669 = getelementptr double, ptr %633, i64 %657
  %670 = load double, ptr %669, align 8
  %671 = fadd double %670, %666
  %672 = fmul double %648, %671
  %673 = fadd double %668, %672
  %674 = getelementptr inbounds double, ptr %624, i64 %657
  %675 = load double, ptr %674, align 8
  %676 = fsub double %673, %675
  store double %676, ptr %658, align 8
  br label %677

677:                                              ; preds = %659, %656
  %678 = add nuw nsw i64 %657, 1
  %679 = icmp eq i64 %678, %622
  br i1 %679, label %653, label %656, !llvm.loop !19

680:                                              ; preds = %634, %691
  %681 = phi i64 [ 0, %634 ], [ %692, %691 ]
  br i1 %635, label %682, label %691

682:                                              ; preds = %680
  %683 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %681
  %684 = load double, ptr %683, align 8
  %685 = getelementptr inbounds i8, ptr %683, i64 8
  %686 = load double, ptr %685, align 8
  %687 = getelementptr inbounds i8, ptr %683, i64 16
  %688 = load double, ptr %687, align 8
  %689 = mul nuw nsw i64 %622, %681
  %690 = getelementptr double, ptr %626, i64 %689
  br label %694

691:                                              ; preds = %694, %680
  %692 = add nuw nsw i64 %681, 1
  %693 = icmp eq i64 %692, 3
  br i1 %693, label %710, label %680, !llvm.loop !20

694:                                              ; preds = %682, %694
  %695 = phi i64 [ 0, %682 ], [ %708, %694 ]
  %696 = getelementptr inbounds double, ptr %625, i64 %695
  %697 = load double, ptr %696, align 8
  %698 = fmul double %684, %697
  %699 = getelementptr double, ptr %636, i64 %695
  %700 = load double, ptr %699, align 8
  %701 = fmul double %686, %700
  %702 = fadd double %698, %701
  %703 = getelementptr double, ptr %638, i64 %695
  %704 = load double, ptr %703, align 8
  %705 = fmul double %688, %704
  %706 = fadd double %702, %705
  %707 = getelementptr double, ptr %690, i64 %695
  store double %706, ptr %707, align 8
  %708 = add nuw nsw i64 %695, 1
  %709 = icmp eq i64 %708, %622
  br i1 %709, label %691, label %694, !llvm.loop !21

710:                                              ; preds = %691
  %711 = load ptr, ptr %76, align 8, !noalias !22
  %712 = getelementptr inbounds i8, ptr %711, i64 8
  %713 = load i64, ptr %712, align 8, !noalias !22
  %714 = load ptr, ptr %78, align 8, !noalias !22
  %715 = getelementptr inbounds i8, ptr %714, i64 40
  %716 = load i64, ptr %715, align 8, !noalias !22
  %717 = load ptr, ptr %116, align 8, !noalias !22
  %718 = load ptr, ptr %117, align 8, !noalias !22
  %719 = load ptr, ptr %118, align 8, !noalias !22
  %720 = load ptr, ptr %119, align 8, !noalias !22
  %721 = load ptr, ptr %120, align 8, !noalias !22
  %722 = icmp sgt i64 %716, 0
  %723 = select i1 %722, i64 10, i64 6
  %724 = icmp sgt i64 %713, 0
  %725 = fdiv double 0x400D1A48D83E731D, %415
  %726 = fdiv double 0x400572DB93E0C672, %415
  %727 = fdiv double 0xC0086747F2C3FCB6, %415
  %728 = icmp sgt i64 %713, 0
  %729 = getelementptr double, ptr %718, i64 %713
  %730 = shl i64 %713, 4
  %731 = getelementptr i8, ptr %718, i64 %730
  %732 = icmp eq i64 %716, 0
  br label %733

733:                                              ; preds = %710, %1137
  %734 = phi double [ -1.000000e+00, %710 ], [ %1136, %1137 ]
  %735 = phi double [ 0.000000e+00, %710 ], [ %1135, %1137 ]
  %736 = phi i64 [ 0, %710 ], [ %1134, %1137 ]
  %737 = phi i64 [ 0, %710 ], [ %1138, %1137 ]
  %738 = phi i64 [ %381, %710 ], [ %1131, %1137 ]
  %739 = phi i64 [ %382, %710 ], [ %1130, %1137 ]
  %740 = phi i32 [ %383, %710 ], [ %1129, %1137 ]
  %741 = phi double [ %384, %710 ], [ %1128, %1137 ]
  %742 = icmp ugt i64 %737, 5
  %743 = icmp eq i64 %736, 0
  %744 = select i1 %742, i1 %743, i1 false
  br i1 %744, label %1140, label %749

745:                                              ; preds = %771
  %746 = add nuw nsw i64 %750, 1
  %747 = icmp ugt i64 %750, 1
  %748 = icmp eq i64 %746, 3
  br i1 %748, label %795, label %749, !llvm.loop !25

749:                                              ; preds = %733, %745
  %750 = phi i64 [ %746, %745 ], [ 0, %733 ]
  %751 = phi i1 [ %747, %745 ], [ false, %733 ]
  br i1 %724, label %752, label %755

752:                                              ; preds = %749
  %753 = mul nuw nsw i64 %713, %750
  %754 = getelementptr double, ptr %717, i64 %753
  br label %781

755:                                              ; preds = %781, %749
  %756 = load ptr, ptr %81, align 8, !noalias !22
  %757 = getelementptr inbounds i8, ptr %756, i64 24
  %758 = load i64, ptr %757, align 8, !noalias !22
  %759 = add nsw i64 %758, 1
  store i64 %759, ptr %757, align 8, !noalias !22
  %760 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %750
  %761 = load double, ptr %760, align 8, !noalias !22
  %762 = fmul double %415, %761
  %763 = fadd double %379, %762
  %764 = load ptr, ptr %121, align 8, !noalias !22
  %765 = mul nsw i64 %713, %750
  %766 = getelementptr inbounds double, ptr %719, i64 %765
  %767 = load ptr, ptr %122, align 8, !noalias !22
  store double %763, ptr %767, align 8, !noalias !22
  %768 = load i64, ptr %123, align 8, !noalias !22
  %769 = icmp sgt i64 %768, 0
  br i1 %769, label %770, label %771

770:                                              ; preds = %755
  tail call fastcc void @sample(ptr noundef nonnull %76) #10, !noalias !22
  br label %771

771:                                              ; preds = %755, %770
  %772 = load ptr, ptr %76, align 8, !noalias !22
  %773 = load i64, ptr %772, align 8, !noalias !22
  %774 = load ptr, ptr %122, align 8, !noalias !22
  %775 = load ptr, ptr %125, align 8, !noalias !22
  %776 = load ptr, ptr %126, align 8, !noalias !22
  %777 = inttoptr i64 %773 to ptr
  %778 = load ptr, ptr %777, align 8, !noalias !22
  %779 = tail call i32 %778(ptr noundef %774, ptr noundef %764, ptr noundef %775, ptr noundef %776, ptr noundef %766) #11, !noalias !22
  %780 = icmp eq i32 %779, 0
  br i1 %780, label %745, label %793

781:                                              ; preds = %752, %781
  %782 = phi i64 [ 0, %752 ], [ %791, %781 ]
  %783 = load ptr, ptr %77, align 8, !noalias !22
  %784 = getelementptr inbounds double, ptr %783, i64 %782
  %785 = load double, ptr %784, align 8, !noalias !22
  %786 = getelementptr double, ptr %754, i64 %782
  %787 = load double, ptr %786, align 8, !noalias !22
  %788 = fadd double %785, %787
  %789 = load ptr, ptr %124, align 8, !noalias !22
  %790 = getelementptr inbounds double, ptr %789, i64 %782
  store double %788, ptr %790, align 8, !noalias !22
  %791 = add nuw nsw i64 %782, 1
  %792 = icmp eq i64 %791, %713
  br i1 %792, label %755, label %781, !llvm.loop !26

793:                                              ; preds = %771
  %794 = sext i32 %779 to i64
  br label %795

795:                                              ; preds = %745, %793
  %796 = phi i1 [ %751, %793 ], [ %747, %745 ]
  %797 = phi double [ 0.000000e+00, %793 ], [ %741, %745 ]
  %798 = phi i32 [ 0, %793 ], [ %740, %745 ]
  %799 = phi i64 [ %737, %793 ], [ %739, %745 ]
  %800 = phi i64 [ %794, %793 ], [ %738, %745 ]
  %801 = phi i32 [ 1, %793 ], [ 5, %745 ]
  br i1 %796, label %802, label %1140

802:                                              ; preds = %795
  %803 = load ptr, ptr %76, align 8, !noalias !22
  %804 = getelementptr inbounds i8, ptr %803, i64 8
  %805 = load i64, ptr %804, align 8, !noalias !22
  %806 = load ptr, ptr %118, align 8, !noalias !22
  %807 = load ptr, ptr %117, align 8, !noalias !22
  %808 = load ptr, ptr %119, align 8, !noalias !22
  %809 = load ptr, ptr %120, align 8, !noalias !22
  %810 = icmp sgt i64 %805, 0
  br i1 %810, label %811, label %916

811:                                              ; preds = %802
  %812 = shl nuw nsw i64 %805, 1
  %813 = getelementptr double, ptr %806, i64 %805
  %814 = shl i64 %805, 4
  %815 = getelementptr i8, ptr %806, i64 %814
  %816 = load double, ptr %806, align 8, !noalias !22
  %817 = getelementptr inbounds double, ptr %806, i64 %805
  %818 = load double, ptr %817, align 8, !noalias !22
  %819 = fadd double %816, %818
  %820 = getelementptr inbounds double, ptr %806, i64 %812
  %821 = load double, ptr %820, align 8, !noalias !22
  %822 = fadd double %819, %821
  %823 = tail call double @llvm.fabs.f64(double %822)
  %824 = fcmp ueq double %823, 0x7FF0000000000000
  br i1 %824, label %913, label %825

825:                                              ; preds = %811
  %826 = getelementptr double, ptr %807, i64 %805
  %827 = getelementptr inbounds double, ptr %807, i64 %812
  %828 = getelementptr double, ptr %806, i64 %805
  %829 = getelementptr inbounds double, ptr %806, i64 %812
  br label %841

830:                                              ; preds = %841
  %831 = getelementptr inbounds double, ptr %806, i64 %909
  %832 = load double, ptr %831, align 8, !noalias !22
  %833 = getelementptr double, ptr %828, i64 %909
  %834 = load double, ptr %833, align 8, !noalias !22
  %835 = fadd double %832, %834
  %836 = getelementptr inbounds double, ptr %829, i64 %909
  %837 = load double, ptr %836, align 8, !noalias !22
  %838 = fadd double %835, %837
  %839 = tail call double @llvm.fabs.f64(double %838)
  %840 = fcmp ueq double %839, 0x7FF0000000000000
  br i1 %840, label %911, label %841, !llvm.loop !27

841:                                              ; preds = %825, %830
  %842 = phi double [ %832, %830 ], [ %816, %825 ]
  %843 = phi double [ %908, %830 ], [ 0.000000e+00, %825 ]
  %844 = phi i64 [ %909, %830 ], [ 0, %825 ]
  %845 = getelementptr inbounds double, ptr %806, i64 %844
  %846 = fmul double %842, 0x4010B70201A79C46
  %847 = getelementptr double, ptr %813, i64 %844
  %848 = load double, ptr %847, align 8, !noalias !22
  %849 = fmul double %848, 0x3FD4F8C15DA84E86
  %850 = fadd double %846, %849
  %851 = getelementptr double, ptr %815, i64 %844
  %852 = load double, ptr %851, align 8, !noalias !22
  %853 = fmul double %852, 0x3FE0BF7FF59D56EF
  %854 = fadd double %850, %853
  %855 = getelementptr inbounds double, ptr %807, i64 %844
  %856 = load double, ptr %855, align 8, !noalias !22
  %857 = fmul double %725, %856
  %858 = fsub double %854, %857
  %859 = getelementptr inbounds double, ptr %808, i64 %844
  store double %858, ptr %859, align 8, !noalias !22
  %860 = load double, ptr %845, align 8, !noalias !22
  %861 = fmul double %860, 0xC010B70201A79C46
  %862 = load double, ptr %847, align 8, !noalias !22
  %863 = fmul double %862, 0x3FD4F8C15DA84E86
  %864 = fsub double %861, %863
  %865 = load double, ptr %851, align 8, !noalias !22
  %866 = fmul double %865, 0x3FDE810014C55221
  %867 = fadd double %864, %866
  %868 = fmul double %860, 0x3FE017885A24A7F2
  %869 = fmul double %862, 0x4004934E6FCAA598
  %870 = fsub double %868, %869
  %871 = fmul double %865, 0x3FE312C0CF7BDFD1
  %872 = fadd double %870, %871
  %873 = getelementptr double, ptr %826, i64 %844
  %874 = load double, ptr %873, align 8, !noalias !22
  %875 = getelementptr inbounds double, ptr %827, i64 %844
  %876 = load double, ptr %875, align 8, !noalias !22
  %877 = fmul double %726, %874
  %878 = fmul double %727, %876
  %879 = fmul double %726, %876
  %880 = fmul double %727, %874
  %881 = fsub double %877, %878
  %882 = fadd double %880, %879
  %883 = fsub double %867, %881
  %884 = fsub double %872, %882
  %885 = getelementptr inbounds { double, double }, ptr %809, i64 %844
  %886 = getelementptr inbounds i8, ptr %885, i64 8
  store double %883, ptr %885, align 8, !noalias !22
  store double %884, ptr %886, align 8, !noalias !22
  %887 = load double, ptr %859, align 8, !noalias !22
  %888 = tail call double @llvm.fabs.f64(double %887)
  %889 = tail call double @llvm.fabs.f64(double %883)
  %890 = fadd double %888, %889
  %891 = tail call double @llvm.fabs.f64(double %884)
  %892 = fadd double %891, %890
  %893 = fmul double %415, %892
  %894 = load ptr, ptr %77, align 8, !noalias !22
  %895 = getelementptr inbounds double, ptr %894, i64 %844
  %896 = load double, ptr %895, align 8, !noalias !22
  %897 = load ptr, ptr %127, align 8, !noalias !22
  %898 = getelementptr inbounds double, ptr %897, i64 %844
  %899 = load double, ptr %898, align 8, !noalias !22
  %900 = load ptr, ptr %128, align 8, !noalias !22
  %901 = getelementptr inbounds double, ptr %900, i64 %844
  %902 = load double, ptr %901, align 8, !noalias !22
  %903 = tail call double @llvm.fabs.f64(double %896)
  %904 = fmul double %903, %902
  %905 = fadd double %899, %904
  %906 = fdiv double %893, %905
  %907 = fmul double %906, %906
  %908 = fadd double %843, %907
  %909 = add nuw nsw i64 %844, 1
  %910 = icmp eq i64 %909, %805
  br i1 %910, label %916, label %830, !llvm.loop !27

911:                                              ; preds = %830
  %912 = icmp slt i64 %909, %805
  br label %913

913:                                              ; preds = %911, %811
  %914 = phi i1 [ %912, %911 ], [ %810, %811 ]
  %915 = phi double [ %908, %911 ], [ 0.000000e+00, %811 ]
  br i1 %914, label %1140, label %916

916:                                              ; preds = %841, %802, %913
  %917 = phi double [ %915, %913 ], [ 0.000000e+00, %802 ], [ %908, %841 ]
  %918 = load ptr, ptr %76, align 8, !noalias !22
  %919 = getelementptr inbounds i8, ptr %918, i64 8
  %920 = load i64, ptr %919, align 8, !noalias !22
  %921 = load i64, ptr %130, align 8, !noalias !22
  %922 = load ptr, ptr %78, align 8, !noalias !22
  %923 = getelementptr inbounds i8, ptr %922, i64 40
  %924 = load i64, ptr %923, align 8, !noalias !22
  %925 = load ptr, ptr %119, align 8, !noalias !22
  %926 = load ptr, ptr %120, align 8, !noalias !22
  %927 = load ptr, ptr %131, align 8, !noalias !22
  %928 = load ptr, ptr %129, align 8, !noalias !22
  tail call fastcc void @real_solve(ptr noundef %927, i64 noundef %921, ptr noundef %928, ptr noundef %925) #10, !noalias !22
  %929 = load ptr, ptr %132, align 8, !noalias !22
  %930 = load ptr, ptr %133, align 8, !noalias !22
  tail call fastcc void @pair_solve(ptr noundef %929, i64 noundef %921, ptr noundef %930, ptr noundef %926) #10, !noalias !22
  %931 = icmp sgt i64 %924, 0
  br i1 %931, label %932, label %937

932:                                              ; preds = %916
  %933 = load ptr, ptr %131, align 8, !noalias !22
  %934 = load ptr, ptr %129, align 8, !noalias !22
  tail call fastcc void @real_solve_columns(ptr noundef %933, i64 noundef %921, ptr noundef %934, ptr noundef %925, i64 noundef %924) #10, !noalias !22
  %935 = load ptr, ptr %132, align 8, !noalias !22
  %936 = load ptr, ptr %133, align 8, !noalias !22
  tail call fastcc void @pair_solve_columns(ptr noundef %935, i64 noundef %921, ptr noundef %936, ptr noundef %926, i64 noundef %924) #10, !noalias !22
  br label %937

937:                                              ; preds = %932, %916
  %938 = icmp sgt i64 %920, 0
  br i1 %938, label %939, label %972

939:                                              ; preds = %937
  %940 = load ptr, ptr %77, align 8, !noalias !22
  %941 = load ptr, ptr %134, align 8, !noalias !22
  %942 = load ptr, ptr %135, align 8, !noalias !22
  br label %943

943:                                              ; preds = %939, %943
  %944 = phi double [ 0.000000e+00, %939 ], [ %969, %943 ]
  %945 = phi i64 [ 0, %939 ], [ %970, %943 ]
  %946 = getelementptr inbounds double, ptr %940, i64 %945
  %947 = load double, ptr %946, align 8, !noalias !22
  %948 = getelementptr inbounds double, ptr %941, i64 %945
  %949 = load double, ptr %948, align 8, !noalias !22
  %950 = getelementptr inbounds double, ptr %942, i64 %945
  %951 = load double, ptr %950, align 8, !noalias !22
  %952 = tail call double @llvm.fabs.f64(double %947)
  %953 = fmul double %952, %951
  %954 = fadd double %949, %953
  %955 = getelementptr inbounds double, ptr %925, i64 %945
  %956 = load double, ptr %955, align 8, !noalias !22
  %957 = fdiv double %956, %954
  %958 = getelementptr inbounds { double, double }, ptr %926, i64 %945
  %959 = load double, ptr %958, align 8, !noalias !22
  %960 = getelementptr inbounds i8, ptr %958, i64 8
  %961 = fdiv double %959, %954
  %962 = load double, ptr %960, align 8, !noalias !22
  %963 = fdiv double %962, %954
  %964 = fmul double %957, %957
  %965 = fmul double %961, %961
  %966 = fadd double %964, %965
  %967 = fmul double %963, %963
  %968 = fadd double %966, %967
  %969 = fadd double %944, %968
  %970 = add nuw nsw i64 %945, 1
  %971 = icmp eq i64 %970, %920
  br i1 %971, label %972, label %943, !llvm.loop !28

972:                                              ; preds = %943, %937
  %973 = phi double [ 0.000000e+00, %937 ], [ %969, %943 ]
  %974 = mul nsw i64 %920, 3
  %975 = sitofp i64 %974 to double
  %976 = fdiv double %973, %975
  %977 = tail call double @llvm.sqrt.f64(double %976)
  %978 = fcmp oeq double %977, 0.000000e+00
  %979 = fcmp ogt double %917, 0.000000e+00
  %980 = select i1 %978, i1 %979, i1 false
  br i1 %980, label %981, label %983

981:                                              ; preds = %972
  %982 = add nuw nsw i64 %737, 1
  br label %1127

983:                                              ; preds = %972
  %984 = fcmp ogt double %734, 0.000000e+00
  %985 = select i1 %984, i1 %743, i1 false
  br i1 %985, label %986, label %999

986:                                              ; preds = %983
  %987 = fdiv double %977, %734
  %988 = fcmp ult double %987, 1.000000e+00
  br i1 %988, label %989, label %997

989:                                              ; preds = %986
  %990 = sub nsw i64 5, %737
  %991 = sitofp i64 %990 to double
  %992 = tail call double @llvm.pow.f64(double %987, double %991)
  %993 = fsub double 1.000000e+00, %987
  %994 = fdiv double %992, %993
  %995 = fmul double %977, %994
  %996 = fcmp ogt double %995, %223
  br i1 %996, label %997, label %999

997:                                              ; preds = %989, %986
  %998 = add nuw nsw i64 %737, 1
  br label %1127

999:                                              ; preds = %989, %983
  %1000 = phi double [ %735, %983 ], [ %987, %989 ]
  br i1 %728, label %1012, label %1001

1001:                                             ; preds = %1030, %999
  %1002 = fsub double 1.000000e+00, %1000
  %1003 = fdiv double %1000, %1002
  %1004 = fmul double %977, %1003
  %1005 = fcmp olt double %1004, %223
  %1006 = select i1 %984, i1 %1005, i1 false
  %1007 = select i1 %978, i1 true, i1 %1006
  %1008 = add nuw nsw i64 %737, 1
  %1009 = select i1 %1007, i64 %1008, i64 0
  %1010 = select i1 %743, i64 %1009, i64 %736
  %1011 = icmp sgt i64 %1010, 0
  br i1 %1011, label %1053, label %1126

1012:                                             ; preds = %999, %1030
  %1013 = phi i64 [ %1031, %1030 ], [ 0, %999 ]
  %1014 = getelementptr inbounds double, ptr %720, i64 %1013
  %1015 = load double, ptr %1014, align 8, !noalias !22
  %1016 = getelementptr inbounds double, ptr %718, i64 %1013
  %1017 = load double, ptr %1016, align 8, !noalias !22
  %1018 = fadd double %1015, %1017
  store double %1018, ptr %1016, align 8, !noalias !22
  %1019 = getelementptr inbounds { double, double }, ptr %721, i64 %1013
  %1020 = load double, ptr %1019, align 8, !noalias !22
  %1021 = getelementptr inbounds i8, ptr %1019, i64 8
  %1022 = getelementptr double, ptr %729, i64 %1013
  %1023 = load double, ptr %1022, align 8, !noalias !22
  %1024 = fadd double %1020, %1023
  store double %1024, ptr %1022, align 8, !noalias !22
  %1025 = load double, ptr %1021, align 8, !noalias !22
  %1026 = getelementptr double, ptr %731, i64 %1013
  %1027 = load double, ptr %1026, align 8, !noalias !22
  %1028 = fadd double %1025, %1027
  store double %1028, ptr %1026, align 8, !noalias !22
  %1029 = getelementptr double, ptr %717, i64 %1013
  br label %1033

1030:                                             ; preds = %1033
  %1031 = add nuw nsw i64 %1013, 1
  %1032 = icmp eq i64 %1031, %713
  br i1 %1032, label %1001, label %1012, !llvm.loop !29

1033:                                             ; preds = %1012, %1033
  %1034 = phi i64 [ 0, %1012 ], [ %1051, %1033 ]
  %1035 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1034
  %1036 = load double, ptr %1035, align 8, !noalias !22
  %1037 = load double, ptr %1016, align 8, !noalias !22
  %1038 = fmul double %1036, %1037
  %1039 = getelementptr inbounds i8, ptr %1035, i64 8
  %1040 = load double, ptr %1039, align 8, !noalias !22
  %1041 = load double, ptr %1022, align 8, !noalias !22
  %1042 = fmul double %1040, %1041
  %1043 = fadd double %1038, %1042
  %1044 = getelementptr inbounds i8, ptr %1035, i64 16
  %1045 = load double, ptr %1044, align 8, !noalias !22
  %1046 = load double, ptr %1026, align 8, !noalias !22
  %1047 = fmul double %1045, %1046
  %1048 = fadd double %1043, %1047
  %1049 = mul nuw nsw i64 %713, %1034
  %1050 = getelementptr double, ptr %1029, i64 %1049
  store double %1048, ptr %1050, align 8, !noalias !22
  %1051 = add nuw nsw i64 %1034, 1
  %1052 = icmp eq i64 %1051, 3
  br i1 %1052, label %1030, label %1033, !llvm.loop !30

1053:                                             ; preds = %1001
  br i1 %732, label %1127, label %1054

1054:                                             ; preds = %1053
  %1055 = load i64, ptr %136, align 8, !noalias !22
  %1056 = load ptr, ptr %78, align 8, !noalias !22
  %1057 = getelementptr inbounds i8, ptr %1056, i64 40
  %1058 = load i64, ptr %1057, align 8, !noalias !22
  %1059 = load ptr, ptr %139, align 8, !noalias !22
  %1060 = load ptr, ptr %137, align 8, !noalias !22
  %1061 = load ptr, ptr %140, align 8, !noalias !22
  %1062 = icmp sgt i64 %1058, 0
  br i1 %1062, label %1063, label %1123

1063:                                             ; preds = %1054
  %1064 = load i64, ptr %138, align 8, !noalias !22
  %1065 = icmp sgt i64 %1055, 0
  %1066 = getelementptr double, ptr %1060, i64 %1064
  %1067 = shl i64 %1064, 4
  %1068 = getelementptr i8, ptr %1060, i64 %1067
  br label %1069

1069:                                             ; preds = %1063, %1119
  %1070 = phi double [ 0.000000e+00, %1063 ], [ %1120, %1119 ]
  %1071 = phi i64 [ 0, %1063 ], [ %1121, %1119 ]
  br i1 %1065, label %1072, label %1075

1072:                                             ; preds = %1069
  %1073 = add nuw i64 %1071, %1055
  %1074 = load ptr, ptr %77, align 8, !noalias !22
  br label %1080

1075:                                             ; preds = %1080, %1069
  %1076 = phi double [ 0.000000e+00, %1069 ], [ %1112, %1080 ]
  %1077 = phi double [ 0.000000e+00, %1069 ], [ %1096, %1080 ]
  %1078 = fmul double %1070, %1076
  %1079 = fcmp ogt double %1077, %1078
  br i1 %1079, label %1115, label %1119

1080:                                             ; preds = %1072, %1080
  %1081 = phi double [ 0.000000e+00, %1072 ], [ %1096, %1080 ]
  %1082 = phi double [ 0.000000e+00, %1072 ], [ %1112, %1080 ]
  %1083 = phi i64 [ 0, %1072 ], [ %1113, %1080 ]
  %1084 = mul nuw nsw i64 %1083, %1058
  %1085 = add i64 %1073, %1084
  %1086 = getelementptr inbounds double, ptr %1059, i64 %1085
  %1087 = load double, ptr %1086, align 8, !noalias !22
  %1088 = fmul double %1087, %1087
  %1089 = getelementptr inbounds { double, double }, ptr %1061, i64 %1085
  %1090 = load double, ptr %1089, align 8, !noalias !22
  %1091 = getelementptr inbounds i8, ptr %1089, i64 8
  %1092 = load double, ptr %1091, align 8, !noalias !22
  %1093 = tail call double @hypot(double noundef %1090, double noundef %1092) #13
  %1094 = fmul double %1093, %1093
  %1095 = fadd double %1088, %1094
  %1096 = fadd double %1081, %1095
  %1097 = getelementptr inbounds double, ptr %1074, i64 %1085
  %1098 = load double, ptr %1097, align 8, !noalias !22
  %1099 = fmul double %1098, %1098
  %1100 = fadd double %1082, %1099
  %1101 = getelementptr inbounds double, ptr %1060, i64 %1085
  %1102 = load double, ptr %1101, align 8, !noalias !22
  %1103 = fmul double %1102, %1102
  %1104 = getelementptr double, ptr %1066, i64 %1085
  %1105 = load double, ptr %1104, align 8, !noalias !22
  %1106 = fmul double %1105, %1105
  %1107 = fadd double %1103, %1106
  %1108 = getelementptr double, ptr %1068, i64 %1085
  %1109 = load double, ptr %1108, align 8, !noalias !22
  %1110 = fmul double %1109, %1109
  %1111 = fadd double %1107, %1110
  %1112 = fadd double %1100, %1111
  %1113 = add nuw nsw i64 %1083, 1
  %1114 = icmp eq i64 %1113, %1055
  br i1 %1114, label %1075, label %1080, !llvm.loop !31

1115:                                             ; preds = %1075
  %1116 = fcmp ogt double %1076, 0.000000e+00
  %1117 = fdiv double %1077, %1076
  %1118 = select i1 %1116, double %1117, double 1.000000e+00
  br label %1119

1119:                                             ; preds = %1115, %1075
  %1120 = phi double [ %1118, %1115 ], [ %1070, %1075 ]
  %1121 = add nuw nsw i64 %1071, 1
  %1122 = icmp eq i64 %1121, %1058
  br i1 %1122, label %1123, label %1069, !llvm.loop !32

1123:                                             ; preds = %1119, %1054
  %1124 = phi double [ 0.000000e+00, %1054 ], [ %1120, %1119 ]
  %1125 = fcmp ugt double %1124, %347
  br i1 %1125, label %1126, label %1127

1126:                                             ; preds = %1123, %1001
  br label %1127

1127:                                             ; preds = %1126, %1123, %1053, %997, %981
  %1128 = phi double [ %735, %981 ], [ %987, %997 ], [ %797, %1053 ], [ %797, %1126 ], [ %797, %1123 ]
  %1129 = phi i32 [ 0, %981 ], [ 0, %997 ], [ %798, %1053 ], [ %798, %1126 ], [ %798, %1123 ]
  %1130 = phi i64 [ %982, %981 ], [ %998, %997 ], [ %799, %1053 ], [ %799, %1126 ], [ %799, %1123 ]
  %1131 = phi i64 [ 0, %981 ], [ 0, %997 ], [ %800, %1053 ], [ %800, %1126 ], [ %800, %1123 ]
  %1132 = phi i1 [ false, %981 ], [ false, %997 ], [ false, %1053 ], [ true, %1126 ], [ false, %1123 ]
  %1133 = phi i32 [ 1, %981 ], [ 1, %997 ], [ 2, %1053 ], [ 0, %1126 ], [ 2, %1123 ]
  %1134 = phi i64 [ %736, %981 ], [ 0, %997 ], [ %1010, %1053 ], [ %1010, %1126 ], [ %1010, %1123 ]
  %1135 = phi double [ %735, %981 ], [ %987, %997 ], [ %1000, %1053 ], [ %1000, %1126 ], [ %1000, %1123 ]
  %1136 = phi double [ %734, %981 ], [ %734, %997 ], [ %734, %1053 ], [ %977, %1126 ], [ %734, %1123 ]
  br i1 %1132, label %1137, label %1140

1137:                                             ; preds = %1127
  %1138 = add nuw nsw i64 %737, 1
  %1139 = icmp eq i64 %1138, %723
  br i1 %1139, label %1140, label %733, !llvm.loop !33

1140:                                             ; preds = %913, %1127, %795, %733, %1137
  %1141 = phi double [ %741, %733 ], [ %1128, %1127 ], [ %797, %795 ], [ %1128, %1137 ], [ 0x7FF0000000000000, %913 ]
  %1142 = phi i32 [ %740, %733 ], [ %1129, %1127 ], [ %798, %795 ], [ %1129, %1137 ], [ 0, %913 ]
  %1143 = phi i64 [ %739, %733 ], [ %1130, %1127 ], [ %799, %795 ], [ %1130, %1137 ], [ %737, %913 ]
  %1144 = phi i64 [ %738, %733 ], [ %1131, %1127 ], [ %800, %795 ], [ %1131, %1137 ], [ 0, %913 ]
  %1145 = phi i32 [ 2, %733 ], [ %1133, %1127 ], [ %801, %795 ], [ 2, %1137 ], [ 1, %913 ]
  %1146 = phi i64 [ 0, %733 ], [ %1134, %1127 ], [ %736, %795 ], [ %1134, %1137 ], [ %736, %913 ]
  %1147 = phi double [ %735, %733 ], [ %1135, %1127 ], [ %735, %795 ], [ %1135, %1137 ], [ %735, %913 ]
  %1148 = icmp eq i32 %1145, 2
  br i1 %1148, label %1149, label %1153

1149:                                             ; preds = %1140
  %1150 = icmp sgt i64 %1146, 0
  %1151 = select i1 %1150, i64 %1146, i64 6
  %1152 = zext i1 %1150 to i32
  br label %1153

1153:                                             ; preds = %1140, %1149
  %1154 = phi double [ %1147, %1149 ], [ %1141, %1140 ]
  %1155 = phi i32 [ %1152, %1149 ], [ %1142, %1140 ]
  %1156 = phi i64 [ %1151, %1149 ], [ %1143, %1140 ]
  %1157 = phi i64 [ 0, %1149 ], [ %1144, %1140 ]
  %1158 = icmp slt i64 %1157, 0
  br i1 %1158, label %1905, label %1159

1159:                                             ; preds = %1153
  %1160 = icmp eq i32 %1155, 0
  br i1 %1160, label %1162, label %1161

1161:                                             ; preds = %1159
  br i1 %348, label %1314, label %1212

1162:                                             ; preds = %1159
  %1163 = load i64, ptr %337, align 8
  %1164 = add nsw i64 %1163, 1
  store i64 %1164, ptr %337, align 8
  %1165 = tail call double @llvm.fabs.f64(double %1154)
  %1166 = fcmp ueq double %1165, 0x7FF0000000000000
  %1167 = select i1 %1166, i64 4, i64 7
  %1168 = icmp eq i64 %1157, 0
  %1169 = select i1 %1168, i64 %1167, i64 3
  store i64 %1169, ptr %366, align 8
  %1170 = load i64, ptr %367, align 8
  %1171 = icmp eq i64 %1170, 1
  %1172 = and i1 %1168, %1171
  br i1 %1172, label %1173, label %1199

1173:                                             ; preds = %1162
  %1174 = load i64, ptr %181, align 8
  %1175 = icmp sgt i64 %1174, 0
  br i1 %1175, label %1176, label %1193

1176:                                             ; preds = %1173, %1185
  %1177 = phi i64 [ %1190, %1185 ], [ 0, %1173 ]
  %1178 = phi i32 [ %1187, %1185 ], [ 0, %1173 ]
  %1179 = icmp eq i32 %1178, 0
  br i1 %1179, label %1180, label %1185

1180:                                             ; preds = %1176
  %1181 = load ptr, ptr %180, align 8
  %1182 = getelementptr inbounds double, ptr %1181, i64 %1177
  %1183 = load double, ptr %1182, align 8
  %1184 = fcmp une double %1183, 0.000000e+00
  br label %1185

1185:                                             ; preds = %1180, %1176
  %1186 = phi i1 [ true, %1176 ], [ %1184, %1180 ]
  %1187 = zext i1 %1186 to i32
  %1188 = load ptr, ptr %180, align 8
  %1189 = getelementptr inbounds double, ptr %1188, i64 %1177
  store double 0.000000e+00, ptr %1189, align 8
  %1190 = add nuw nsw i64 %1177, 1
  %1191 = load i64, ptr %181, align 8
  %1192 = icmp slt i64 %1190, %1191
  br i1 %1192, label %1176, label %1193, !llvm.loop !34

1193:                                             ; preds = %1185, %1173
  %1194 = phi i32 [ 0, %1173 ], [ %1187, %1185 ]
  %1195 = icmp eq i32 %1194, 0
  br i1 %1195, label %1197, label %1196

1196:                                             ; preds = %1193
  store i64 0, ptr %343, align 8
  br label %1905, !llvm.loop !17

1197:                                             ; preds = %1193
  store i64 0, ptr %367, align 8
  %1198 = fmul double %415, 5.000000e-01
  br label %1199

1199:                                             ; preds = %1197, %1162
  %1200 = phi double [ %1198, %1197 ], [ %380, %1162 ]
  %1201 = load i64, ptr %367, align 8
  %1202 = icmp eq i64 %1201, 1
  %1203 = icmp ne i64 %1157, 0
  %1204 = or i1 %1203, %1202
  br i1 %1204, label %1205, label %1208

1205:                                             ; preds = %1199
  %1206 = select i1 %1168, double 5.000000e-01, double 2.500000e-01
  %1207 = fmul double %415, %1206
  store double 0.000000e+00, ptr %345, align 8
  br label %1208

1208:                                             ; preds = %1205, %1199
  %1209 = phi double [ %1207, %1205 ], [ %1200, %1199 ]
  %1210 = load i64, ptr %367, align 8
  %1211 = sub nsw i64 1, %1210
  store i64 %1211, ptr %340, align 8
  br label %1905, !llvm.loop !17

1212:                                             ; preds = %1314, %1161
  %1213 = load i64, ptr %350, align 8
  %1214 = icmp eq i64 %1213, 1
  %1215 = load ptr, ptr %76, align 8
  %1216 = getelementptr inbounds i8, ptr %1215, i64 8
  %1217 = load i64, ptr %1216, align 8
  %1218 = load i64, ptr %143, align 8
  %1219 = load ptr, ptr %144, align 8
  %1220 = load ptr, ptr %119, align 8
  %1221 = icmp sgt i64 %1217, 0
  br i1 %1221, label %1222, label %1224

1222:                                             ; preds = %1212
  %1223 = shl i64 %1217, 4
  br label %1233

1224:                                             ; preds = %1233, %1212
  %1225 = load ptr, ptr %146, align 8
  %1226 = load ptr, ptr %142, align 8
  tail call fastcc void @real_solve(ptr noundef %1225, i64 noundef %1218, ptr noundef %1226, ptr noundef %1220) #10
  %1227 = load ptr, ptr %147, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1220, ptr noundef %1227, ptr noundef nonnull %77, i64 noundef %1217) #10
  %1228 = load double, ptr %6, align 8
  %1229 = fcmp uge double %1228, 1.000000e+00
  %1230 = and i1 %1214, %1229
  br i1 %1230, label %1231, label %1310

1231:                                             ; preds = %1224
  %1232 = icmp sgt i64 %1217, 0
  br i1 %1232, label %1282, label %1258

1233:                                             ; preds = %1222, %1233
  %1234 = phi i64 [ 0, %1222 ], [ %1256, %1233 ]
  %1235 = load ptr, ptr %116, align 8
  %1236 = getelementptr inbounds double, ptr %1235, i64 %1234
  %1237 = load double, ptr %1236, align 8
  %1238 = fmul double %1237, 0x402418FD8BAFFE05
  %1239 = getelementptr double, ptr %1235, i64 %1217
  %1240 = getelementptr double, ptr %1239, i64 %1234
  %1241 = load double, ptr %1240, align 8
  %1242 = fmul double %1241, 0x3FF61D41B2D54580
  %1243 = fsub double %1242, %1238
  %1244 = getelementptr i8, ptr %1235, i64 %1223
  %1245 = getelementptr double, ptr %1244, i64 %1234
  %1246 = load double, ptr %1245, align 8
  %1247 = fmul double %1246, 0x3FD5555555555555
  %1248 = fsub double %1243, %1247
  %1249 = fdiv double %1248, %415
  %1250 = getelementptr inbounds double, ptr %1219, i64 %1234
  store double %1249, ptr %1250, align 8
  %1251 = load ptr, ptr %145, align 8
  %1252 = getelementptr inbounds double, ptr %1251, i64 %1234
  %1253 = load double, ptr %1252, align 8
  %1254 = fadd double %1253, %1249
  %1255 = getelementptr inbounds double, ptr %1220, i64 %1234
  store double %1254, ptr %1255, align 8
  %1256 = add nuw nsw i64 %1234, 1
  %1257 = icmp eq i64 %1256, %1217
  br i1 %1257, label %1224, label %1233, !llvm.loop !35

1258:                                             ; preds = %1282, %1231
  %1259 = load ptr, ptr %81, align 8
  %1260 = getelementptr inbounds i8, ptr %1259, i64 24
  %1261 = load i64, ptr %1260, align 8
  %1262 = add nsw i64 %1261, 1
  store i64 %1262, ptr %1260, align 8
  %1263 = load ptr, ptr %149, align 8
  %1264 = load ptr, ptr %118, align 8
  %1265 = load ptr, ptr %150, align 8
  store double %379, ptr %1265, align 8
  %1266 = load i64, ptr %151, align 8
  %1267 = icmp sgt i64 %1266, 0
  br i1 %1267, label %1268, label %1269

1268:                                             ; preds = %1258
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1269

1269:                                             ; preds = %1258, %1268
  %1270 = load ptr, ptr %76, align 8
  %1271 = load i64, ptr %1270, align 8
  %1272 = load ptr, ptr %150, align 8
  %1273 = load ptr, ptr %152, align 8
  %1274 = load ptr, ptr %153, align 8
  %1275 = inttoptr i64 %1271 to ptr
  %1276 = load ptr, ptr %1275, align 8
  %1277 = tail call i32 %1276(ptr noundef %1272, ptr noundef %1263, ptr noundef %1273, ptr noundef %1274, ptr noundef %1264) #11
  %1278 = sext i32 %1277 to i64
  %1279 = icmp eq i32 %1277, 0
  br i1 %1279, label %1280, label %1310

1280:                                             ; preds = %1269
  %1281 = icmp sgt i64 %1217, 0
  br i1 %1281, label %1299, label %1294

1282:                                             ; preds = %1231, %1282
  %1283 = phi i64 [ %1292, %1282 ], [ 0, %1231 ]
  %1284 = load ptr, ptr %77, align 8
  %1285 = getelementptr inbounds double, ptr %1284, i64 %1283
  %1286 = load double, ptr %1285, align 8
  %1287 = getelementptr inbounds double, ptr %1220, i64 %1283
  %1288 = load double, ptr %1287, align 8
  %1289 = fadd double %1286, %1288
  %1290 = load ptr, ptr %148, align 8
  %1291 = getelementptr inbounds double, ptr %1290, i64 %1283
  store double %1289, ptr %1291, align 8
  %1292 = add nuw nsw i64 %1283, 1
  %1293 = icmp eq i64 %1292, %1217
  br i1 %1293, label %1258, label %1282, !llvm.loop !36

1294:                                             ; preds = %1299, %1280
  %1295 = load ptr, ptr %146, align 8
  %1296 = load ptr, ptr %142, align 8
  tail call fastcc void @real_solve(ptr noundef %1295, i64 noundef %1218, ptr noundef %1296, ptr noundef %1220) #10
  %1297 = load ptr, ptr %147, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1220, ptr noundef %1297, ptr noundef nonnull %77, i64 noundef %1217) #10
  %1298 = load double, ptr %7, align 8
  br label %1310

1299:                                             ; preds = %1280, %1299
  %1300 = phi i64 [ %1308, %1299 ], [ 0, %1280 ]
  %1301 = load ptr, ptr %118, align 8
  %1302 = getelementptr inbounds double, ptr %1301, i64 %1300
  %1303 = load double, ptr %1302, align 8
  %1304 = getelementptr inbounds double, ptr %1219, i64 %1300
  %1305 = load double, ptr %1304, align 8
  %1306 = fadd double %1303, %1305
  %1307 = getelementptr inbounds double, ptr %1220, i64 %1300
  store double %1306, ptr %1307, align 8
  %1308 = add nuw nsw i64 %1300, 1
  %1309 = icmp eq i64 %1308, %1217
  br i1 %1309, label %1294, label %1299, !llvm.loop !37

1310:                                             ; preds = %1224, %1269, %1294
  %1311 = phi double [ %1298, %1294 ], [ %1228, %1269 ], [ %1228, %1224 ]
  %1312 = phi i64 [ 0, %1294 ], [ %1278, %1269 ], [ 0, %1224 ]
  %1313 = icmp slt i64 %1312, 0
  br i1 %1313, label %1905, label %1328

1314:                                             ; preds = %1161, %1314
  %1315 = phi i64 [ %1326, %1314 ], [ 0, %1161 ]
  %1316 = load ptr, ptr %77, align 8
  %1317 = getelementptr inbounds double, ptr %1316, i64 %1315
  %1318 = load double, ptr %1317, align 8
  %1319 = load ptr, ptr %116, align 8
  %1320 = getelementptr i8, ptr %1319, i64 %349
  %1321 = getelementptr double, ptr %1320, i64 %1315
  %1322 = load double, ptr %1321, align 8
  %1323 = fadd double %1318, %1322
  %1324 = load ptr, ptr %141, align 8
  %1325 = getelementptr inbounds double, ptr %1324, i64 %1315
  store double %1323, ptr %1325, align 8
  %1326 = add nuw nsw i64 %1315, 1
  %1327 = icmp eq i64 %1326, %198
  br i1 %1327, label %1212, label %1314, !llvm.loop !38

1328:                                             ; preds = %1310
  %1329 = add nsw i64 %1156, 12
  %1330 = sitofp i64 %1329 to double
  %1331 = fdiv double 0x4027666666666667, %1330
  %1332 = fcmp olt double %1311, 1.000000e-10
  %1333 = select i1 %1332, double 1.000000e-10, double %1311
  %1334 = tail call double @llvm.pow.f64(double %1333, double -2.500000e-01)
  %1335 = icmp eq i64 %1312, 0
  %1336 = fcmp olt double %1311, 1.000000e+00
  %1337 = select i1 %1335, i1 %1336, i1 false
  br i1 %1337, label %1353, label %1338

1338:                                             ; preds = %1328
  %1339 = load i64, ptr %337, align 8
  %1340 = add nsw i64 %1339, 1
  store i64 %1340, ptr %337, align 8
  %1341 = select i1 %1335, i64 2, i64 3
  store i64 %1341, ptr %351, align 8
  %1342 = tail call double @llvm.fabs.f64(double %1311)
  %1343 = fcmp ueq double %1342, 0x7FF0000000000000
  br i1 %1343, label %1348, label %1344

1344:                                             ; preds = %1338
  %1345 = fmul double %1331, %1334
  %1346 = fcmp ogt double %1345, 2.000000e-01
  %1347 = select i1 %1346, double %1345, double 2.000000e-01
  br label %1348

1348:                                             ; preds = %1338, %1344
  %1349 = phi double [ %1347, %1344 ], [ 2.500000e-01, %1338 ]
  %1350 = fmul double %415, %1349
  store i64 1, ptr %350, align 8
  %1351 = load i64, ptr %352, align 8
  %1352 = sub nsw i64 1, %1351
  store i64 %1352, ptr %340, align 8
  br label %1905, !llvm.loop !17

1353:                                             ; preds = %1328
  br i1 %206, label %1354, label %1369

1354:                                             ; preds = %1353
  %1355 = load ptr, ptr %147, align 8
  %1356 = load ptr, ptr %77, align 8
  %1357 = load ptr, ptr %84, align 8
  %1358 = getelementptr inbounds i8, ptr %1357, i64 56
  %1359 = load i64, ptr %1358, align 8
  %1360 = inttoptr i64 %1359 to ptr
  %1361 = tail call i64 %1360(ptr noundef %0, double noundef %414, ptr noundef %1355, ptr noundef %1356) #11
  %1362 = icmp eq i64 %1361, 0
  br i1 %1362, label %1369, label %1363

1363:                                             ; preds = %1354
  %1364 = load i64, ptr %337, align 8
  %1365 = add nsw i64 %1364, 1
  store i64 %1365, ptr %337, align 8
  store i64 6, ptr %353, align 8
  %1366 = fmul double %415, 2.500000e-01
  store i64 1, ptr %350, align 8
  %1367 = load i64, ptr %354, align 8
  %1368 = sub nsw i64 1, %1367
  store i64 %1368, ptr %340, align 8
  br label %1905, !llvm.loop !17

1369:                                             ; preds = %1354, %1353
  %1370 = load i64, ptr %336, align 8
  %1371 = add nsw i64 %1370, 1
  store i64 %1371, ptr %336, align 8
  %1372 = load double, ptr %355, align 8
  %1373 = fcmp ogt double %1372, 0.000000e+00
  br i1 %1373, label %1374, label %1383

1374:                                             ; preds = %1369
  %1375 = fdiv double %1372, %1333
  %1376 = tail call double @llvm.pow.f64(double %1375, double 2.500000e-01)
  %1377 = load double, ptr %356, align 8
  %1378 = fdiv double %415, %1377
  %1379 = fmul double %1376, %1378
  %1380 = fcmp olt double %1379, 1.000000e+00
  %1381 = select i1 %1380, double %1379, double 1.000000e+00
  %1382 = fmul double %1334, %1381
  br label %1383

1383:                                             ; preds = %1374, %1369
  %1384 = phi double [ %1382, %1374 ], [ %1334, %1369 ]
  %1385 = fmul double %1331, %1384
  %1386 = fcmp olt double %1385, 1.000000e+01
  store double %414, ptr %188, align 8
  store double %415, ptr %357, align 8
  store double %1333, ptr %355, align 8
  %1387 = load ptr, ptr %76, align 8
  %1388 = getelementptr inbounds i8, ptr %1387, i64 8
  %1389 = load i64, ptr %1388, align 8
  %1390 = load i64, ptr %154, align 8
  %1391 = load ptr, ptr %116, align 8
  %1392 = load ptr, ptr %155, align 8
  %1393 = load ptr, ptr %115, align 8
  br label %1410

1394:                                             ; preds = %1410
  %1395 = select i1 %1386, double %1385, double 1.000000e+01
  %1396 = icmp sgt i64 %1389, 0
  br i1 %1396, label %1397, label %1470

1397:                                             ; preds = %1394
  %1398 = load double, ptr %8, align 16
  %1399 = load double, ptr %156, align 8
  %1400 = getelementptr double, ptr %1391, i64 %1389
  %1401 = load double, ptr %157, align 16
  %1402 = shl i64 %1389, 4
  %1403 = getelementptr i8, ptr %1391, i64 %1402
  %1404 = load double, ptr %9, align 16
  %1405 = load double, ptr %158, align 8
  %1406 = load double, ptr %159, align 16
  %1407 = getelementptr double, ptr %1392, i64 %1390
  %1408 = shl i64 %1390, 4
  %1409 = getelementptr i8, ptr %1392, i64 %1408
  br label %1421

1410:                                             ; preds = %1383, %1410
  %1411 = phi i64 [ 0, %1383 ], [ %1419, %1410 ]
  %1412 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1411
  %1413 = getelementptr inbounds i8, ptr %1412, i64 8
  %1414 = load double, ptr %1413, align 8
  %1415 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1411
  store double %1414, ptr %1415, align 8
  %1416 = getelementptr inbounds i8, ptr %1412, i64 16
  %1417 = load double, ptr %1416, align 8
  %1418 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1411
  store double %1417, ptr %1418, align 8
  %1419 = add nuw nsw i64 %1411, 1
  %1420 = icmp eq i64 %1419, 3
  br i1 %1420, label %1394, label %1410, !llvm.loop !39

1421:                                             ; preds = %1397, %1458
  %1422 = phi i64 [ 0, %1397 ], [ %1459, %1458 ]
  %1423 = getelementptr inbounds double, ptr %1391, i64 %1422
  %1424 = load double, ptr %1423, align 8
  %1425 = fmul double %1398, %1424
  %1426 = getelementptr double, ptr %1400, i64 %1422
  %1427 = load double, ptr %1426, align 8
  %1428 = fmul double %1399, %1427
  %1429 = fadd double %1425, %1428
  %1430 = getelementptr double, ptr %1403, i64 %1422
  %1431 = load double, ptr %1430, align 8
  %1432 = fmul double %1401, %1431
  %1433 = fadd double %1429, %1432
  %1434 = fmul double %1424, %1404
  %1435 = fmul double %1427, %1405
  %1436 = fadd double %1434, %1435
  %1437 = fmul double %1431, %1406
  %1438 = fadd double %1436, %1437
  %1439 = load ptr, ptr %147, align 8
  %1440 = getelementptr inbounds double, ptr %1439, i64 %1422
  %1441 = load double, ptr %1440, align 8
  %1442 = load ptr, ptr %77, align 8
  %1443 = getelementptr inbounds double, ptr %1442, i64 %1422
  %1444 = load double, ptr %1443, align 8
  %1445 = fsub double %1441, %1444
  %1446 = getelementptr inbounds double, ptr %1392, i64 %1422
  store double %1445, ptr %1446, align 8
  %1447 = fneg double %1433
  %1448 = fsub double %1447, %1438
  %1449 = getelementptr double, ptr %1407, i64 %1422
  store double %1448, ptr %1449, align 8
  %1450 = fneg double %1438
  %1451 = getelementptr double, ptr %1409, i64 %1422
  store double %1450, ptr %1451, align 8
  %1452 = load ptr, ptr %77, align 8
  %1453 = getelementptr inbounds double, ptr %1452, i64 %1422
  %1454 = load double, ptr %1453, align 8
  %1455 = getelementptr inbounds double, ptr %1393, i64 %1422
  store double %1454, ptr %1455, align 8
  %1456 = getelementptr double, ptr %1392, i64 %1422
  %1457 = getelementptr double, ptr %1393, i64 %1422
  br label %1461

1458:                                             ; preds = %1461
  %1459 = add nuw nsw i64 %1422, 1
  %1460 = icmp eq i64 %1459, %1389
  br i1 %1460, label %1470, label %1421, !llvm.loop !40

1461:                                             ; preds = %1421, %1461
  %1462 = phi i64 [ 0, %1421 ], [ %1466, %1461 ]
  %1463 = mul nsw i64 %1390, %1462
  %1464 = getelementptr double, ptr %1456, i64 %1463
  %1465 = load double, ptr %1464, align 8
  %1466 = add nuw nsw i64 %1462, 1
  %1467 = mul nuw nsw i64 %1389, %1466
  %1468 = getelementptr double, ptr %1457, i64 %1467
  store double %1465, ptr %1468, align 8
  %1469 = icmp eq i64 %1466, 3
  br i1 %1469, label %1458, label %1461, !llvm.loop !41

1470:                                             ; preds = %1458, %1394
  store double %415, ptr %345, align 8
  %1471 = load ptr, ptr %0, align 8
  %1472 = getelementptr inbounds i8, ptr %1471, i64 24
  %1473 = load i64, ptr %1472, align 8
  %1474 = load ptr, ptr %93, align 8
  %1475 = getelementptr inbounds i8, ptr %1474, i64 8
  %1476 = load i64, ptr %1475, align 8
  %1477 = icmp eq i64 %1476, 0
  br i1 %1477, label %1524, label %1478

1478:                                             ; preds = %1470
  %1479 = load i64, ptr %1474, align 8
  %1480 = load ptr, ptr %76, align 8
  %1481 = getelementptr inbounds i8, ptr %1480, i64 8
  %1482 = load i64, ptr %1481, align 8
  %1483 = load ptr, ptr %160, align 8
  %1484 = load i64, ptr %161, align 8
  %1485 = mul nsw i64 %1484, %1479
  %1486 = getelementptr inbounds double, ptr %1483, i64 %1485
  %1487 = getelementptr inbounds double, ptr %1486, i64 %1484
  store double %379, ptr %1486, align 8
  %1488 = getelementptr inbounds i8, ptr %1486, i64 8
  store double %415, ptr %1488, align 8
  store double %414, ptr %1487, align 8
  %1489 = getelementptr inbounds i8, ptr %1487, i64 8
  store double 0.000000e+00, ptr %1489, align 8
  %1490 = icmp sgt i64 %1482, 0
  br i1 %1490, label %1491, label %1494

1491:                                             ; preds = %1478
  %1492 = getelementptr i8, ptr %1486, i64 16
  %1493 = icmp sgt i64 %1473, 0
  br label %1497

1494:                                             ; preds = %1509, %1478
  %1495 = add nsw i64 %1479, 1
  %1496 = load ptr, ptr %93, align 8
  store i64 %1495, ptr %1496, align 8
  br label %1524

1497:                                             ; preds = %1491, %1509
  %1498 = phi i64 [ 0, %1491 ], [ %1510, %1509 ]
  %1499 = load ptr, ptr %77, align 8
  %1500 = getelementptr inbounds double, ptr %1499, i64 %1498
  %1501 = load double, ptr %1500, align 8
  %1502 = add nuw nsw i64 %1498, 2
  %1503 = getelementptr inbounds double, ptr %1486, i64 %1502
  store double %1501, ptr %1503, align 8
  %1504 = load ptr, ptr %147, align 8
  %1505 = getelementptr inbounds double, ptr %1504, i64 %1498
  %1506 = load double, ptr %1505, align 8
  %1507 = getelementptr inbounds double, ptr %1487, i64 %1502
  store double %1506, ptr %1507, align 8
  %1508 = getelementptr double, ptr %1492, i64 %1498
  br i1 %1493, label %1512, label %1509

1509:                                             ; preds = %1512, %1497
  %1510 = add nuw nsw i64 %1498, 1
  %1511 = icmp eq i64 %1510, %1482
  br i1 %1511, label %1494, label %1497, !llvm.loop !42

1512:                                             ; preds = %1497, %1512
  %1513 = phi i64 [ %1520, %1512 ], [ 0, %1497 ]
  %1514 = load ptr, ptr %155, align 8
  %1515 = load i64, ptr %154, align 8
  %1516 = mul nsw i64 %1515, %1513
  %1517 = getelementptr double, ptr %1514, i64 %1516
  %1518 = getelementptr double, ptr %1517, i64 %1498
  %1519 = load double, ptr %1518, align 8
  %1520 = add nuw nsw i64 %1513, 1
  %1521 = mul nuw nsw i64 %1520, %1482
  %1522 = getelementptr double, ptr %1508, i64 %1521
  store double %1519, ptr %1522, align 8
  %1523 = icmp eq i64 %1520, %1473
  br i1 %1523, label %1509, label %1512, !llvm.loop !43

1524:                                             ; preds = %1470, %1494
  br i1 %210, label %1525, label %1633

1525:                                             ; preds = %1524
  %1526 = load ptr, ptr %85, align 8
  %1527 = load ptr, ptr %76, align 8
  %1528 = getelementptr inbounds i8, ptr %1527, i64 8
  %1529 = load i64, ptr %1528, align 8
  %1530 = load ptr, ptr %162, align 8
  %1531 = getelementptr inbounds i8, ptr %1526, i64 32
  %1532 = load i64, ptr %1531, align 8
  %1533 = getelementptr inbounds double, ptr %1530, i64 %1532
  %1534 = load ptr, ptr %116, align 8
  %1535 = getelementptr inbounds i8, ptr %1526, i64 24
  %1536 = load i64, ptr %1535, align 8
  %1537 = icmp eq i64 %1536, 0
  br i1 %1537, label %1630, label %1538

1538:                                             ; preds = %1525
  %1539 = getelementptr inbounds i8, ptr %1526, i64 40
  %1540 = load i64, ptr %1539, align 8
  %1541 = icmp sgt i64 %1540, 0
  br i1 %1541, label %1542, label %1546

1542:                                             ; preds = %1538
  %1543 = getelementptr double, ptr %1534, i64 %1529
  %1544 = shl i64 %1529, 4
  %1545 = getelementptr i8, ptr %1534, i64 %1544
  br label %1600

1546:                                             ; preds = %1600, %1538
  %1547 = load ptr, ptr %163, align 8
  %1548 = load ptr, ptr %85, align 8
  %1549 = getelementptr inbounds i8, ptr %1548, i64 8
  %1550 = load i64, ptr %1549, align 8
  %1551 = load ptr, ptr %164, align 8
  %1552 = load ptr, ptr %162, align 8
  %1553 = getelementptr inbounds i8, ptr %1548, i64 32
  %1554 = load i64, ptr %1553, align 8
  %1555 = getelementptr inbounds i8, ptr %1548, i64 40
  %1556 = load i64, ptr %1555, align 8
  %1557 = getelementptr double, ptr %1552, i64 %1554
  %1558 = getelementptr double, ptr %1557, i64 %1556
  store double %415, ptr %1558, align 8
  %1559 = load ptr, ptr %163, align 8
  store double %379, ptr %1559, align 8
  %1560 = load ptr, ptr %85, align 8
  %1561 = getelementptr inbounds i8, ptr %1560, i64 24
  %1562 = load i64, ptr %1561, align 8
  %1563 = load ptr, ptr %77, align 8
  %1564 = load ptr, ptr %162, align 8
  %1565 = load ptr, ptr %165, align 8
  %1566 = inttoptr i64 %1562 to ptr
  %1567 = load ptr, ptr %1566, align 8
  %1568 = tail call i32 %1567(ptr noundef %1547, ptr noundef %1563, ptr noundef %1564, ptr noundef %1565, ptr noundef %1551) #11
  %1569 = icmp eq i32 %1568, 0
  br i1 %1569, label %1570, label %1630

1570:                                             ; preds = %1546
  %1571 = icmp slt i64 %1550, 1
  br i1 %1571, label %1597, label %1572

1572:                                             ; preds = %1570
  %1573 = load ptr, ptr %166, align 8
  %1574 = getelementptr double, ptr %1551, i64 %1550
  br label %1575

1575:                                             ; preds = %1572, %1593
  %1576 = phi i1 [ %1571, %1572 ], [ %1595, %1593 ]
  %1577 = phi i64 [ 0, %1572 ], [ %1594, %1593 ]
  %1578 = getelementptr inbounds i64, ptr %1573, i64 %1577
  %1579 = load i64, ptr %1578, align 8
  %1580 = and i64 %1579, 2
  %1581 = icmp eq i64 %1580, 0
  br i1 %1581, label %1582, label %1593

1582:                                             ; preds = %1575
  %1583 = getelementptr inbounds double, ptr %1551, i64 %1577
  %1584 = load double, ptr %1583, align 8
  %1585 = load ptr, ptr %167, align 8
  %1586 = getelementptr inbounds i64, ptr %1585, i64 %1577
  %1587 = load i64, ptr %1586, align 8
  %1588 = sitofp i64 %1587 to double
  %1589 = fmul double %1584, %1588
  %1590 = getelementptr double, ptr %1574, i64 %1577
  %1591 = load double, ptr %1590, align 8
  %1592 = fcmp ogt double %1589, %1591
  br i1 %1592, label %1593, label %1597

1593:                                             ; preds = %1582, %1575
  %1594 = add nuw nsw i64 %1577, 1
  %1595 = icmp sge i64 %1594, %1550
  %1596 = icmp eq i64 %1594, %1550
  br i1 %1596, label %1597, label %1575, !llvm.loop !44

1597:                                             ; preds = %1593, %1582, %1570
  %1598 = phi i1 [ %1571, %1570 ], [ %1595, %1593 ], [ %1576, %1582 ]
  %1599 = zext i1 %1598 to i32
  br label %1630

1600:                                             ; preds = %1542, %1600
  %1601 = phi i64 [ 0, %1542 ], [ %1627, %1600 ]
  %1602 = load ptr, ptr %147, align 8
  %1603 = getelementptr inbounds double, ptr %1602, i64 %1601
  %1604 = load double, ptr %1603, align 8
  %1605 = load ptr, ptr %77, align 8
  %1606 = getelementptr inbounds double, ptr %1605, i64 %1601
  %1607 = load double, ptr %1606, align 8
  %1608 = fsub double %1604, %1607
  %1609 = tail call double @llvm.fabs.f64(double %1608)
  %1610 = getelementptr inbounds double, ptr %1534, i64 %1601
  %1611 = load double, ptr %1610, align 8
  %1612 = tail call double @llvm.fabs.f64(double %1611)
  %1613 = getelementptr double, ptr %1543, i64 %1601
  %1614 = load double, ptr %1613, align 8
  %1615 = tail call double @llvm.fabs.f64(double %1614)
  %1616 = fcmp ogt double %1612, %1615
  %1617 = select i1 %1616, double %1612, double %1615
  %1618 = getelementptr double, ptr %1545, i64 %1601
  %1619 = load double, ptr %1618, align 8
  %1620 = tail call double @llvm.fabs.f64(double %1619)
  %1621 = fcmp ogt double %1617, %1620
  %1622 = select i1 %1621, double %1617, double %1620
  %1623 = fcmp ogt double %1622, %1609
  %1624 = select i1 %1623, double %1622, double %1609
  %1625 = fmul double %1624, 8.000000e+00
  %1626 = getelementptr inbounds double, ptr %1533, i64 %1601
  store double %1625, ptr %1626, align 8
  %1627 = add nuw nsw i64 %1601, 1
  %1628 = load i64, ptr %1539, align 8
  %1629 = icmp slt i64 %1627, %1628
  br i1 %1629, label %1600, label %1546, !llvm.loop !45

1630:                                             ; preds = %1597, %1546, %1525
  %1631 = phi i32 [ 0, %1525 ], [ 0, %1546 ], [ %1599, %1597 ]
  %1632 = icmp eq i32 %1631, 0
  br label %1633

1633:                                             ; preds = %1630, %1524
  %1634 = phi i1 [ false, %1524 ], [ %1632, %1630 ]
  br i1 %1634, label %1640, label %1635

1635:                                             ; preds = %1633
  %1636 = load i64, ptr %358, align 8
  %1637 = getelementptr inbounds double, ptr %199, i64 %1636
  %1638 = load double, ptr %1637, align 8
  %1639 = fcmp ugt double %1638, %414
  br i1 %1639, label %1852, label %1640

1640:                                             ; preds = %1635, %1633
  %1641 = load ptr, ptr %79, align 8
  br i1 %1634, label %1642, label %1653

1642:                                             ; preds = %1640
  %1643 = load ptr, ptr %85, align 8
  %1644 = getelementptr inbounds i8, ptr %1643, i64 16
  %1645 = load i64, ptr %1644, align 8
  %1646 = inttoptr i64 %1645 to ptr
  %1647 = tail call i64 %1646(ptr noundef %0, double noundef %379, double noundef %415) #11
  %1648 = icmp eq i64 %1647, -6
  br i1 %1648, label %1649, label %1650

1649:                                             ; preds = %1642
  store double %379, ptr %1641, align 8
  br label %1828

1650:                                             ; preds = %1642
  %1651 = getelementptr inbounds i8, ptr %1641, i64 48
  %1652 = load double, ptr %1651, align 8
  br label %1653

1653:                                             ; preds = %1650, %1640
  %1654 = phi double [ %1652, %1650 ], [ 1.000000e+00, %1640 ]
  %1655 = phi i64 [ %1647, %1650 ], [ 0, %1640 ]
  %1656 = fcmp oeq double %1654, 1.000000e+00
  br i1 %1656, label %1657, label %1659

1657:                                             ; preds = %1653
  %1658 = load double, ptr %1641, align 8
  br label %1662

1659:                                             ; preds = %1653
  %1660 = fmul double %415, %1654
  %1661 = fadd double %379, %1660
  br label %1662

1662:                                             ; preds = %1659, %1657
  %1663 = phi double [ %1658, %1657 ], [ %1661, %1659 ]
  %1664 = icmp eq i64 %1655, -4
  %1665 = select i1 %1664, i64 -4, i64 0
  br i1 %1664, label %1723, label %1666

1666:                                             ; preds = %1662
  %1667 = fcmp olt double %1654, 1.000000e+00
  %1668 = load ptr, ptr %76, align 8
  %1669 = getelementptr inbounds i8, ptr %1668, i64 8
  %1670 = load i64, ptr %1669, align 8
  %1671 = load i64, ptr %83, align 8
  %1672 = load ptr, ptr %82, align 8
  %1673 = load ptr, ptr %81, align 8
  %1674 = getelementptr inbounds i8, ptr %1673, i64 48
  %1675 = load i64, ptr %1674, align 8
  %1676 = icmp slt i64 %1675, %1671
  br i1 %1676, label %1677, label %1719

1677:                                             ; preds = %1666, %1715
  %1678 = phi i64 [ %1716, %1715 ], [ undef, %1666 ]
  %1679 = phi i64 [ %1717, %1715 ], [ %1675, %1666 ]
  %1680 = getelementptr inbounds double, ptr %1672, i64 %1679
  %1681 = load double, ptr %1680, align 8
  %1682 = fcmp olt double %1681, %1663
  %1683 = fcmp oeq double %1681, %1663
  %1684 = and i1 %1667, %1683
  %1685 = or i1 %1682, %1684
  br i1 %1685, label %1686, label %1719

1686:                                             ; preds = %1677
  %1687 = fsub double %1681, %379
  %1688 = fdiv double %1687, %415
  %1689 = mul nsw i64 %1679, %1670
  %1690 = getelementptr inbounds double, ptr %1, i64 %1689
  %1691 = load ptr, ptr %168, align 8
  %1692 = insertelement <8 x double> poison, double %1688, i64 0
  %1693 = shufflevector <8 x double> %1692, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1693, ptr %1691, align 8
  %1694 = load ptr, ptr %77, align 8
  %1695 = load ptr, ptr %169, align 8
  %1696 = load i64, ptr %170, align 8
  %1697 = load ptr, ptr %0, align 8
  %1698 = getelementptr inbounds i8, ptr %1697, i64 24
  %1699 = load i64, ptr %1698, align 8
  %1700 = load ptr, ptr %168, align 8
  %1701 = load ptr, ptr %76, align 8
  %1702 = getelementptr inbounds i8, ptr %1701, i64 16
  %1703 = load i64, ptr %1702, align 8
  tail call fastcc void @nested(ptr noundef %1690, ptr noundef %1694, ptr noundef %1695, i64 noundef %1696, i64 noundef %1699, ptr noundef %1700, i64 noundef %1703) #10
  %1704 = load ptr, ptr %84, align 8
  %1705 = load i64, ptr %1704, align 8
  %1706 = icmp eq i64 %1705, 1
  br i1 %1706, label %1707, label %1715

1707:                                             ; preds = %1686
  %1708 = load double, ptr %1680, align 8
  %1709 = getelementptr inbounds i8, ptr %1704, i64 56
  %1710 = load i64, ptr %1709, align 8
  %1711 = inttoptr i64 %1710 to ptr
  %1712 = tail call i64 %1711(ptr noundef %0, double noundef %1708, ptr noundef %1690, ptr noundef null) #11
  %1713 = icmp eq i64 %1712, 0
  %1714 = select i1 %1713, i64 %1678, i64 %1712
  br i1 %1713, label %1715, label %1723

1715:                                             ; preds = %1707, %1686
  %1716 = phi i64 [ %1714, %1707 ], [ %1678, %1686 ]
  %1717 = add i64 %1679, 1
  %1718 = icmp eq i64 %1717, %1671
  br i1 %1718, label %1719, label %1677, !llvm.loop !46

1719:                                             ; preds = %1715, %1677, %1666
  %1720 = phi i64 [ %1675, %1666 ], [ %1671, %1715 ], [ %1679, %1677 ]
  %1721 = load ptr, ptr %81, align 8
  %1722 = getelementptr inbounds i8, ptr %1721, i64 48
  store i64 %1720, ptr %1722, align 8
  br label %1723

1723:                                             ; preds = %1707, %1719, %1662
  %1724 = phi i64 [ %1665, %1662 ], [ 0, %1719 ], [ %1714, %1707 ]
  %1725 = icmp eq i64 %1724, 0
  %1726 = icmp ne i64 %1655, 0
  %1727 = fcmp olt double %1654, 1.000000e+00
  %1728 = and i1 %1727, %1725
  %1729 = and i1 %1726, %1728
  br i1 %1729, label %1730, label %1767

1730:                                             ; preds = %1723
  %1731 = load ptr, ptr %171, align 8
  %1732 = load ptr, ptr %172, align 8
  %1733 = insertelement <8 x double> poison, double %1654, i64 0
  %1734 = shufflevector <8 x double> %1733, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1734, ptr %1732, align 8
  %1735 = load ptr, ptr %77, align 8
  %1736 = load ptr, ptr %173, align 8
  %1737 = load i64, ptr %174, align 8
  %1738 = load ptr, ptr %0, align 8
  %1739 = getelementptr inbounds i8, ptr %1738, i64 24
  %1740 = load i64, ptr %1739, align 8
  %1741 = load ptr, ptr %172, align 8
  %1742 = load ptr, ptr %76, align 8
  %1743 = getelementptr inbounds i8, ptr %1742, i64 16
  %1744 = load i64, ptr %1743, align 8
  tail call fastcc void @nested(ptr noundef %1731, ptr noundef %1735, ptr noundef %1736, i64 noundef %1737, i64 noundef %1740, ptr noundef %1741, i64 noundef %1744) #10
  %1745 = load i64, ptr %154, align 8
  %1746 = icmp sgt i64 %1745, 0
  br i1 %1746, label %1751, label %1747

1747:                                             ; preds = %1751, %1730
  %1748 = load ptr, ptr %84, align 8
  %1749 = load i64, ptr %1748, align 8
  %1750 = icmp eq i64 %1749, 1
  br i1 %1750, label %1761, label %1767

1751:                                             ; preds = %1730, %1751
  %1752 = phi i64 [ %1758, %1751 ], [ 0, %1730 ]
  %1753 = load ptr, ptr %171, align 8
  %1754 = getelementptr inbounds double, ptr %1753, i64 %1752
  %1755 = load double, ptr %1754, align 8
  %1756 = load ptr, ptr %147, align 8
  %1757 = getelementptr inbounds double, ptr %1756, i64 %1752
  store double %1755, ptr %1757, align 8
  %1758 = add nuw nsw i64 %1752, 1
  %1759 = load i64, ptr %154, align 8
  %1760 = icmp slt i64 %1758, %1759
  br i1 %1760, label %1751, label %1747, !llvm.loop !47

1761:                                             ; preds = %1747
  %1762 = load ptr, ptr %147, align 8
  %1763 = getelementptr inbounds i8, ptr %1748, i64 56
  %1764 = load i64, ptr %1763, align 8
  %1765 = inttoptr i64 %1764 to ptr
  %1766 = tail call i64 %1765(ptr noundef %0, double noundef %1663, ptr noundef %1762, ptr noundef null) #11
  br label %1767

1767:                                             ; preds = %1761, %1747, %1723
  %1768 = phi i64 [ %1766, %1761 ], [ 0, %1747 ], [ %1724, %1723 ]
  %1769 = icmp eq i64 %1768, 0
  br i1 %1769, label %1772, label %1770

1770:                                             ; preds = %1767
  store double %379, ptr %1641, align 8
  %1771 = getelementptr inbounds i8, ptr %1641, i64 8
  store double %415, ptr %1771, align 8
  br label %1828

1772:                                             ; preds = %1767
  br i1 %1656, label %1773, label %1811

1773:                                             ; preds = %1772
  %1774 = load ptr, ptr %147, align 8
  %1775 = load ptr, ptr %76, align 8
  %1776 = getelementptr inbounds i8, ptr %1775, i64 8
  %1777 = load i64, ptr %1776, align 8
  %1778 = load i64, ptr %83, align 8
  %1779 = load ptr, ptr %82, align 8
  %1780 = load ptr, ptr %81, align 8
  %1781 = getelementptr inbounds i8, ptr %1780, i64 48
  %1782 = load i64, ptr %1781, align 8
  %1783 = icmp slt i64 %1782, %1778
  br i1 %1783, label %1784, label %1807

1784:                                             ; preds = %1773
  %1785 = icmp sgt i64 %1777, 0
  br label %1786

1786:                                             ; preds = %1784, %1797
  %1787 = phi i64 [ %1782, %1784 ], [ %1798, %1797 ]
  %1788 = getelementptr inbounds double, ptr %1779, i64 %1787
  %1789 = load double, ptr %1788, align 8
  %1790 = load ptr, ptr %79, align 8
  %1791 = load double, ptr %1790, align 8
  %1792 = fcmp ugt double %1789, %1791
  br i1 %1792, label %1807, label %1793

1793:                                             ; preds = %1786
  br i1 %1785, label %1794, label %1797

1794:                                             ; preds = %1793
  %1795 = mul nsw i64 %1787, %1777
  %1796 = getelementptr double, ptr %1, i64 %1795
  br label %1800

1797:                                             ; preds = %1800, %1793
  %1798 = add i64 %1787, 1
  %1799 = icmp eq i64 %1798, %1778
  br i1 %1799, label %1807, label %1786, !llvm.loop !9

1800:                                             ; preds = %1794, %1800
  %1801 = phi i64 [ 0, %1794 ], [ %1805, %1800 ]
  %1802 = getelementptr inbounds double, ptr %1774, i64 %1801
  %1803 = load double, ptr %1802, align 8
  %1804 = getelementptr double, ptr %1796, i64 %1801
  store double %1803, ptr %1804, align 8
  %1805 = add nuw nsw i64 %1801, 1
  %1806 = icmp eq i64 %1805, %1777
  br i1 %1806, label %1797, label %1800, !llvm.loop !10

1807:                                             ; preds = %1797, %1786, %1773
  %1808 = phi i64 [ %1782, %1773 ], [ %1778, %1797 ], [ %1787, %1786 ]
  %1809 = load ptr, ptr %81, align 8
  %1810 = getelementptr inbounds i8, ptr %1809, i64 48
  store i64 %1808, ptr %1810, align 8
  br label %1811

1811:                                             ; preds = %1807, %1772
  br i1 %1726, label %1812, label %1828

1812:                                             ; preds = %1811
  %1813 = load i64, ptr %154, align 8
  %1814 = icmp sgt i64 %1813, 0
  br i1 %1814, label %1818, label %1815

1815:                                             ; preds = %1818, %1812
  store double %1663, ptr %1641, align 8
  %1816 = getelementptr inbounds i8, ptr %1641, i64 8
  store double 0.000000e+00, ptr %1816, align 8
  %1817 = load ptr, ptr %81, align 8
  store i64 0, ptr %1817, align 8
  br label %1828

1818:                                             ; preds = %1812, %1818
  %1819 = phi i64 [ %1825, %1818 ], [ 0, %1812 ]
  %1820 = load ptr, ptr %147, align 8
  %1821 = getelementptr inbounds double, ptr %1820, i64 %1819
  %1822 = load double, ptr %1821, align 8
  %1823 = load ptr, ptr %77, align 8
  %1824 = getelementptr inbounds double, ptr %1823, i64 %1819
  store double %1822, ptr %1824, align 8
  %1825 = add nuw nsw i64 %1819, 1
  %1826 = load i64, ptr %154, align 8
  %1827 = icmp slt i64 %1825, %1826
  br i1 %1827, label %1818, label %1815, !llvm.loop !48

1828:                                             ; preds = %1649, %1770, %1811, %1815
  %1829 = phi i64 [ -6, %1649 ], [ %1768, %1770 ], [ %1655, %1815 ], [ %1655, %1811 ]
  %1830 = icmp eq i64 %1829, -6
  br i1 %1830, label %1834, label %1831

1831:                                             ; preds = %1828
  %1832 = icmp ne i64 %1829, 6
  %1833 = select i1 %1832, i1 true, i1 %210
  br i1 %1833, label %1846, label %1834

1834:                                             ; preds = %1831, %1828
  %1835 = phi i64 [ %1829, %1831 ], [ 2, %1828 ]
  %1836 = load i64, ptr %336, align 8
  %1837 = add nsw i64 %1836, -1
  store i64 %1837, ptr %336, align 8
  %1838 = load ptr, ptr %93, align 8
  %1839 = load i64, ptr %1838, align 8
  %1840 = add nsw i64 %1839, -1
  store i64 %1840, ptr %1838, align 8
  store i64 1, ptr %350, align 8
  %1841 = load i64, ptr %364, align 8
  %1842 = sub nsw i64 1, %1841
  store i64 %1842, ptr %340, align 8
  store double 0.000000e+00, ptr %345, align 8
  %1843 = load i64, ptr %337, align 8
  %1844 = add nsw i64 %1843, 1
  store i64 %1844, ptr %337, align 8
  store i64 %1835, ptr %365, align 8
  %1845 = fmul double %415, 2.500000e-01
  br label %1905, !llvm.loop !17

1846:                                             ; preds = %1831
  %1847 = icmp eq i64 %1829, 0
  br i1 %1847, label %1852, label %1848

1848:                                             ; preds = %1846
  %1849 = load ptr, ptr %93, align 8
  %1850 = load i64, ptr %1849, align 8
  %1851 = add nsw i64 %1850, 1
  store i64 %1851, ptr %1849, align 8
  br label %1905

1852:                                             ; preds = %1846, %1635
  br i1 %359, label %1872, label %1853

1853:                                             ; preds = %1872, %1852
  %1854 = load i64, ptr %360, align 8
  %1855 = add nsw i64 %1854, 1
  store i64 %1855, ptr %360, align 8
  %1856 = load ptr, ptr %77, align 8
  %1857 = load ptr, ptr %175, align 8
  %1858 = load ptr, ptr %176, align 8
  store double %414, ptr %1858, align 8
  %1859 = load i64, ptr %177, align 8
  %1860 = icmp sgt i64 %1859, 0
  br i1 %1860, label %1861, label %1862

1861:                                             ; preds = %1853
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1862

1862:                                             ; preds = %1853, %1861
  %1863 = load ptr, ptr %76, align 8
  %1864 = load i64, ptr %1863, align 8
  %1865 = load ptr, ptr %176, align 8
  %1866 = load ptr, ptr %178, align 8
  %1867 = load ptr, ptr %179, align 8
  %1868 = inttoptr i64 %1864 to ptr
  %1869 = load ptr, ptr %1868, align 8
  %1870 = tail call i32 %1869(ptr noundef %1865, ptr noundef %1856, ptr noundef %1866, ptr noundef %1867, ptr noundef %1857) #11
  %1871 = icmp eq i32 %1870, 0
  br i1 %1871, label %1884, label %1881

1872:                                             ; preds = %1852, %1872
  %1873 = phi i64 [ %1879, %1872 ], [ 0, %1852 ]
  %1874 = load ptr, ptr %147, align 8
  %1875 = getelementptr inbounds double, ptr %1874, i64 %1873
  %1876 = load double, ptr %1875, align 8
  %1877 = load ptr, ptr %77, align 8
  %1878 = getelementptr inbounds double, ptr %1877, i64 %1873
  store double %1876, ptr %1878, align 8
  %1879 = add nuw nsw i64 %1873, 1
  %1880 = icmp eq i64 %1879, %198
  br i1 %1880, label %1853, label %1872, !llvm.loop !49

1881:                                             ; preds = %1862
  store i64 3, ptr %361, align 8
  store double %415, ptr %225, align 8
  %1882 = icmp slt i32 %1870, 0
  %1883 = select i1 %1882, i64 -4, i64 2
  br label %1905

1884:                                             ; preds = %1862
  %1885 = icmp sgt i64 %1156, 2
  %1886 = fcmp ogt double %1154, 1.000000e-03
  %1887 = select i1 %1885, i1 %1886, i1 false
  %1888 = zext i1 %1887 to i64
  store i64 %1888, ptr %340, align 8
  store i64 0, ptr %362, align 8
  store i64 0, ptr %350, align 8
  %1889 = fcmp ule double %1395, 1.000000e+00
  %1890 = fcmp uge double %1395, 1.200000e+00
  %1891 = or i1 %1889, %1890
  %1892 = select i1 %1891, i1 true, i1 %1887
  br i1 %1892, label %1895, label %1893

1893:                                             ; preds = %1884
  %1894 = load double, ptr %189, align 8
  br label %1899

1895:                                             ; preds = %1884
  %1896 = fcmp ogt double %1395, 2.000000e-01
  %1897 = select i1 %1896, double %1395, double 2.000000e-01
  %1898 = fmul double %415, %1897
  br label %1899

1899:                                             ; preds = %1895, %1893
  %1900 = phi double [ %1894, %1893 ], [ %1898, %1895 ]
  %1901 = load i64, ptr %363, align 8
  %1902 = load i64, ptr %83, align 8
  %1903 = icmp eq i64 %1901, %1902
  br i1 %1903, label %1904, label %1905

1904:                                             ; preds = %1899
  store double %1900, ptr %225, align 8
  br label %1905

1905:                                             ; preds = %1153, %1196, %1208, %1904, %1899, %1881, %1848, %1834, %1363, %1348, %1310, %611, %542, %421
  %1906 = phi double [ %384, %421 ], [ %384, %542 ], [ %384, %611 ], [ %1154, %1310 ], [ %1154, %1348 ], [ %1154, %1363 ], [ %1154, %1834 ], [ %1154, %1848 ], [ %1154, %1881 ], [ %1154, %1899 ], [ %1154, %1904 ], [ %1154, %1208 ], [ %1154, %1196 ], [ %1154, %1153 ]
  %1907 = phi i32 [ %383, %421 ], [ %383, %542 ], [ %383, %611 ], [ %1155, %1310 ], [ %1155, %1348 ], [ %1155, %1363 ], [ %1155, %1834 ], [ %1155, %1848 ], [ %1155, %1881 ], [ %1155, %1899 ], [ %1155, %1904 ], [ %1155, %1208 ], [ %1155, %1196 ], [ %1155, %1153 ]
  %1908 = phi i64 [ %382, %421 ], [ %382, %542 ], [ %382, %611 ], [ %1156, %1310 ], [ %1156, %1348 ], [ %1156, %1363 ], [ %1156, %1834 ], [ %1156, %1848 ], [ %1156, %1881 ], [ %1156, %1899 ], [ %1156, %1904 ], [ %1156, %1208 ], [ %1156, %1196 ], [ %1156, %1153 ]
  %1909 = phi i64 [ %381, %421 ], [ %381, %542 ], [ %381, %611 ], [ %1157, %1310 ], [ %1157, %1348 ], [ %1157, %1363 ], [ %1157, %1834 ], [ %1157, %1848 ], [ %1157, %1881 ], [ %1157, %1899 ], [ %1157, %1904 ], [ %1157, %1208 ], [ %1157, %1196 ], [ %1157, %1153 ]
  %1910 = phi double [ %380, %421 ], [ %380, %542 ], [ %614, %611 ], [ %380, %1310 ], [ %1350, %1348 ], [ %1366, %1363 ], [ %1845, %1834 ], [ %380, %1848 ], [ %380, %1881 ], [ %1900, %1899 ], [ %1900, %1904 ], [ %1209, %1208 ], [ %380, %1196 ], [ %380, %1153 ]
  %1911 = phi double [ %379, %421 ], [ %379, %542 ], [ %379, %611 ], [ %379, %1310 ], [ %379, %1348 ], [ %379, %1363 ], [ %379, %1834 ], [ %379, %1848 ], [ %414, %1881 ], [ %414, %1899 ], [ %414, %1904 ], [ %379, %1208 ], [ %379, %1196 ], [ %379, %1153 ]
  %1912 = phi i32 [ 1, %421 ], [ 1, %542 ], [ 6, %611 ], [ 1, %1310 ], [ 6, %1348 ], [ 6, %1363 ], [ 6, %1834 ], [ 1, %1848 ], [ 1, %1881 ], [ 0, %1899 ], [ 1, %1904 ], [ 6, %1208 ], [ 6, %1196 ], [ 1, %1153 ]
  %1913 = phi i64 [ 2, %421 ], [ -4, %542 ], [ %378, %611 ], [ -4, %1310 ], [ %378, %1348 ], [ %378, %1363 ], [ %378, %1834 ], [ %1829, %1848 ], [ %1883, %1881 ], [ %378, %1899 ], [ 0, %1904 ], [ %378, %1208 ], [ %378, %1196 ], [ -4, %1153 ]
  switch i32 %1912, label %1917 [
    i32 0, label %1914
    i32 6, label %1914
  ]

1914:                                             ; preds = %1905, %1905
  %1915 = load i64, ptr %192, align 8
  %1916 = icmp eq i64 %1915, 0
  br i1 %1916, label %370, label %376, !llvm.loop !17

1917:                                             ; preds = %1905, %183, %258, %300, %370, %397, %405
  %1918 = phi double [ %184, %183 ], [ %371, %370 ], [ %384, %405 ], [ %384, %397 ], [ %184, %300 ], [ %184, %258 ], [ %1906, %1905 ]
  %1919 = phi i32 [ %185, %183 ], [ %372, %370 ], [ %383, %405 ], [ %383, %397 ], [ %185, %300 ], [ %185, %258 ], [ %1907, %1905 ]
  %1920 = phi i64 [ %186, %183 ], [ %373, %370 ], [ %382, %405 ], [ %382, %397 ], [ %186, %300 ], [ %186, %258 ], [ %1908, %1905 ]
  %1921 = phi i64 [ %187, %183 ], [ %374, %370 ], [ %381, %405 ], [ %381, %397 ], [ %187, %300 ], [ %187, %258 ], [ %1909, %1905 ]
  %1922 = phi i64 [ -1, %183 ], [ -1, %370 ], [ 1, %405 ], [ -5, %397 ], [ 0, %300 ], [ %261, %258 ], [ %1913, %1905 ]
  %1923 = load ptr, ptr %182, align 8
  %1924 = getelementptr inbounds i8, ptr %1923, i64 48
  %1925 = load i64, ptr %1924, align 8
  %1926 = icmp ne i64 %1922, -2
  %1927 = icmp eq i64 %1925, 0
  %1928 = select i1 %1926, i1 true, i1 %1927
  br i1 %1928, label %1936, label %1929

1929:                                             ; preds = %1917
  %1930 = inttoptr i64 %1925 to ptr
  %1931 = tail call i64 %1930(ptr noundef %0) #11
  %1932 = icmp eq i64 %1931, 8
  %1933 = select i1 %1932, i64 8, i64 %1922
  %1934 = icmp eq i64 %1931, 1
  %1935 = zext i1 %1934 to i32
  br label %1936

1936:                                             ; preds = %1917, %1929
  %1937 = phi i64 [ %1922, %1917 ], [ %1933, %1929 ]
  %1938 = phi i32 [ 0, %1917 ], [ %1935, %1929 ]
  %1939 = icmp eq i32 %1938, 0
  br i1 %1939, label %1940, label %183, !llvm.loop !50

1940:                                             ; preds = %1936
  ret i64 %1937
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
