; sources 9f89f83febff8289c7a0c89484881cace54beb9420a13dacacd2396ead3ab208
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
  %18 = getelementptr inbounds i8, ptr %0, i64 360
  br label %26

19:                                               ; preds = %26, %11
  %20 = getelementptr inbounds i8, ptr %0, i64 632
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %37

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 624
  %25 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %38 = getelementptr inbounds i8, ptr %0, i64 656
  %39 = load i64, ptr %38, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %54

41:                                               ; preds = %37
  %42 = getelementptr inbounds i8, ptr %0, i64 648
  %43 = getelementptr inbounds i8, ptr %0, i64 1296
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
  %55 = getelementptr inbounds i8, ptr %0, i64 768
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
  %71 = getelementptr inbounds i8, ptr %0, i64 984
  %72 = load ptr, ptr %71, align 8
  %73 = mul i64 %58, 88
  %74 = getelementptr inbounds i8, ptr %72, i64 %73
  store double 0x7FF8000000000000, ptr %74, align 8
  br label %75

75:                                               ; preds = %70, %54, %3
  %76 = getelementptr inbounds i8, ptr %0, i64 144
  %77 = getelementptr inbounds i8, ptr %0, i64 360
  %78 = getelementptr inbounds i8, ptr %0, i64 1368
  %79 = getelementptr inbounds i8, ptr %0, i64 624
  %80 = getelementptr inbounds i8, ptr %0, i64 1392
  %81 = getelementptr inbounds i8, ptr %0, i64 648
  %82 = getelementptr inbounds i8, ptr %0, i64 672
  %83 = getelementptr inbounds i8, ptr %0, i64 680
  %84 = getelementptr inbounds i8, ptr %0, i64 696
  %85 = getelementptr inbounds i8, ptr %0, i64 768
  %86 = getelementptr inbounds i8, ptr %0, i64 576
  %87 = getelementptr inbounds i8, ptr %0, i64 312
  %88 = getelementptr inbounds i8, ptr %0, i64 320
  %89 = getelementptr inbounds i8, ptr %0, i64 336
  %90 = getelementptr inbounds i8, ptr %0, i64 528
  %91 = getelementptr inbounds i8, ptr %0, i64 168
  %92 = getelementptr inbounds i8, ptr %0, i64 248
  %93 = getelementptr inbounds i8, ptr %0, i64 192
  %94 = getelementptr inbounds i8, ptr %0, i64 216
  %95 = getelementptr inbounds i8, ptr %0, i64 528
  %96 = getelementptr inbounds i8, ptr %0, i64 1320
  %97 = getelementptr inbounds i8, ptr %0, i64 312
  %98 = getelementptr inbounds i8, ptr %0, i64 320
  %99 = getelementptr inbounds i8, ptr %0, i64 336
  %100 = getelementptr inbounds i8, ptr %0, i64 1440
  %101 = getelementptr inbounds i8, ptr %0, i64 168
  %102 = getelementptr inbounds i8, ptr %0, i64 248
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 1416
  %106 = getelementptr inbounds i8, ptr %0, i64 408
  %107 = getelementptr inbounds i8, ptr %0, i64 408
  %108 = getelementptr inbounds i8, ptr %0, i64 384
  %109 = getelementptr inbounds i8, ptr %0, i64 168
  %110 = getelementptr inbounds i8, ptr %0, i64 248
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = getelementptr inbounds i8, ptr %0, i64 216
  %113 = getelementptr inbounds i8, ptr %0, i64 528
  %114 = getelementptr inbounds i8, ptr %0, i64 1448
  %115 = getelementptr inbounds i8, ptr %0, i64 1512
  %116 = getelementptr inbounds i8, ptr %0, i64 1520
  %117 = getelementptr inbounds i8, ptr %0, i64 1464
  %118 = getelementptr inbounds i8, ptr %0, i64 1488
  %119 = getelementptr inbounds i8, ptr %0, i64 1440
  %120 = getelementptr inbounds i8, ptr %0, i64 1536
  %121 = getelementptr inbounds i8, ptr %0, i64 1632
  %122 = getelementptr inbounds i8, ptr %0, i64 1560
  %123 = getelementptr inbounds i8, ptr %0, i64 1584
  %124 = getelementptr inbounds i8, ptr %0, i64 1608
  %125 = getelementptr inbounds i8, ptr %0, i64 1656
  %126 = getelementptr inbounds i8, ptr %0, i64 1680
  %127 = getelementptr inbounds i8, ptr %0, i64 408
  %128 = getelementptr inbounds i8, ptr %0, i64 168
  %129 = getelementptr inbounds i8, ptr %0, i64 248
  %130 = getelementptr inbounds i8, ptr %0, i64 408
  %131 = getelementptr inbounds i8, ptr %0, i64 192
  %132 = getelementptr inbounds i8, ptr %0, i64 216
  %133 = getelementptr inbounds i8, ptr %0, i64 600
  %134 = getelementptr inbounds i8, ptr %0, i64 576
  %135 = getelementptr inbounds i8, ptr %0, i64 1512
  %136 = getelementptr inbounds i8, ptr %0, i64 1520
  %137 = getelementptr inbounds i8, ptr %0, i64 1464
  %138 = getelementptr inbounds i8, ptr %0, i64 1488
  %139 = getelementptr inbounds i8, ptr %0, i64 1536
  %140 = getelementptr inbounds i8, ptr %0, i64 600
  %141 = getelementptr inbounds i8, ptr %0, i64 576
  %142 = getelementptr inbounds i8, ptr %0, i64 1520
  %143 = getelementptr inbounds i8, ptr %0, i64 1584
  %144 = getelementptr inbounds i8, ptr %0, i64 1600
  %145 = getelementptr inbounds i8, ptr %0, i64 1656
  %146 = getelementptr inbounds i8, ptr %0, i64 1680
  %147 = getelementptr inbounds i8, ptr %0, i64 384
  %148 = getelementptr inbounds i8, ptr %0, i64 1512
  %149 = getelementptr inbounds i8, ptr %0, i64 1520
  %150 = getelementptr inbounds i8, ptr %0, i64 1704
  %151 = getelementptr inbounds i8, ptr %0, i64 528
  %152 = getelementptr inbounds i8, ptr %0, i64 1464
  %153 = getelementptr inbounds i8, ptr %0, i64 384
  %154 = getelementptr inbounds i8, ptr %0, i64 408
  %155 = getelementptr inbounds i8, ptr %0, i64 408
  %156 = getelementptr inbounds i8, ptr %0, i64 168
  %157 = getelementptr inbounds i8, ptr %0, i64 248
  %158 = getelementptr inbounds i8, ptr %0, i64 192
  %159 = getelementptr inbounds i8, ptr %0, i64 216
  %160 = getelementptr inbounds i8, ptr %0, i64 368
  %161 = getelementptr inbounds i8, ptr %0, i64 552
  %162 = getelementptr inbounds i8, ptr %8, i64 8
  %163 = getelementptr inbounds i8, ptr %8, i64 16
  %164 = getelementptr inbounds i8, ptr %9, i64 8
  %165 = getelementptr inbounds i8, ptr %9, i64 16
  %166 = getelementptr inbounds i8, ptr %0, i64 1344
  %167 = getelementptr inbounds i8, ptr %0, i64 1360
  %168 = getelementptr inbounds i8, ptr %0, i64 888
  %169 = getelementptr inbounds i8, ptr %0, i64 168
  %170 = getelementptr inbounds i8, ptr %0, i64 984
  %171 = getelementptr inbounds i8, ptr %0, i64 912
  %172 = getelementptr inbounds i8, ptr %0, i64 864
  %173 = getelementptr inbounds i8, ptr %0, i64 936
  %174 = getelementptr inbounds i8, ptr %0, i64 456
  %175 = getelementptr inbounds i8, ptr %0, i64 552
  %176 = getelementptr inbounds i8, ptr %0, i64 368
  %177 = getelementptr inbounds i8, ptr %0, i64 408
  %178 = getelementptr inbounds i8, ptr %0, i64 456
  %179 = getelementptr inbounds i8, ptr %0, i64 552
  %180 = getelementptr inbounds i8, ptr %0, i64 368
  %181 = getelementptr inbounds i8, ptr %0, i64 336
  %182 = getelementptr inbounds i8, ptr %0, i64 528
  %183 = getelementptr inbounds i8, ptr %0, i64 168
  %184 = getelementptr inbounds i8, ptr %0, i64 248
  %185 = getelementptr inbounds i8, ptr %0, i64 192
  %186 = getelementptr inbounds i8, ptr %0, i64 216
  %187 = getelementptr inbounds i8, ptr %0, i64 1440
  %188 = getelementptr inbounds i8, ptr %0, i64 1448
  %189 = getelementptr inbounds i8, ptr %0, i64 768
  br label %190

190:                                              ; preds = %2021, %75
  %191 = phi double [ undef, %75 ], [ %2003, %2021 ]
  %192 = phi i32 [ undef, %75 ], [ %2004, %2021 ]
  %193 = phi i64 [ undef, %75 ], [ %2005, %2021 ]
  %194 = phi i64 [ undef, %75 ], [ %2006, %2021 ]
  %195 = load ptr, ptr %79, align 8
  %196 = load ptr, ptr %80, align 8
  %197 = load ptr, ptr %81, align 8
  %198 = load ptr, ptr %78, align 8
  %199 = getelementptr inbounds i8, ptr %197, i64 56
  %200 = load i64, ptr %199, align 8
  %201 = icmp eq i64 %200, 0
  br i1 %201, label %2002, label %202

202:                                              ; preds = %190
  %203 = load ptr, ptr %76, align 8
  %204 = getelementptr inbounds i8, ptr %203, i64 8
  %205 = load i64, ptr %204, align 8
  %206 = load ptr, ptr %82, align 8
  %207 = load i64, ptr %83, align 8
  %208 = getelementptr double, ptr %206, i64 %207
  %209 = getelementptr i8, ptr %208, i64 -8
  %210 = load double, ptr %209, align 8
  %211 = load ptr, ptr %84, align 8
  %212 = load i64, ptr %211, align 8
  %213 = icmp eq i64 %212, 1
  %214 = load ptr, ptr %85, align 8
  %215 = getelementptr inbounds i8, ptr %214, i64 8
  %216 = load i64, ptr %215, align 8
  %217 = icmp sgt i64 %216, 0
  %218 = load ptr, ptr %86, align 8
  %219 = load double, ptr %218, align 8
  %220 = icmp sgt i64 %205, 0
  br i1 %220, label %236, label %221

221:                                              ; preds = %236, %202
  %222 = phi double [ %219, %202 ], [ %242, %236 ]
  %223 = tail call double @llvm.sqrt.f64(double %222)
  %224 = fcmp olt double %223, 3.000000e-02
  %225 = select i1 %224, double %223, double 3.000000e-02
  %226 = fcmp olt double %222, 0x3CB0000000000000
  %227 = select i1 %226, double 0x3CB0000000000000, double %222
  %228 = fdiv double 0x3CE4000000000000, %227
  %229 = fcmp ogt double %225, %228
  %230 = select i1 %229, double %225, double %228
  %231 = load double, ptr %195, align 8
  %232 = getelementptr inbounds i8, ptr %195, i64 8
  %233 = load double, ptr %232, align 8
  %234 = load i64, ptr %197, align 8
  %235 = icmp eq i64 %234, 0
  br i1 %235, label %245, label %368

236:                                              ; preds = %202, %236
  %237 = phi double [ %242, %236 ], [ %219, %202 ]
  %238 = phi i64 [ %243, %236 ], [ 0, %202 ]
  %239 = getelementptr inbounds double, ptr %218, i64 %238
  %240 = load double, ptr %239, align 8
  %241 = fcmp olt double %240, %237
  %242 = select i1 %241, double %240, double %237
  %243 = add nuw nsw i64 %238, 1
  %244 = icmp eq i64 %243, %205
  br i1 %244, label %221, label %236, !llvm.loop !8

245:                                              ; preds = %221
  %246 = load ptr, ptr %87, align 8
  %247 = load i64, ptr %88, align 8
  %248 = icmp eq i64 %247, 0
  br i1 %248, label %275, label %249

249:                                              ; preds = %245
  %250 = icmp sgt i64 %247, 0
  br i1 %250, label %251, label %264

251:                                              ; preds = %249, %251
  %252 = phi i64 [ %262, %251 ], [ %247, %249 ]
  %253 = phi i64 [ %261, %251 ], [ 0, %249 ]
  %254 = add nuw nsw i64 %252, %253
  %255 = lshr i64 %254, 1
  %256 = and i64 %254, -2
  %257 = getelementptr inbounds double, ptr %246, i64 %256
  %258 = load double, ptr %257, align 8
  %259 = fcmp ogt double %258, %231
  %260 = add nuw nsw i64 %255, 1
  %261 = select i1 %259, i64 %253, i64 %260
  %262 = select i1 %259, i64 %255, i64 %252
  %263 = icmp slt i64 %261, %262
  br i1 %263, label %251, label %264, !llvm.loop !9

264:                                              ; preds = %251, %249
  %265 = phi i64 [ 0, %249 ], [ %261, %251 ]
  %266 = icmp slt i64 %265, %247
  br i1 %266, label %267, label %272

267:                                              ; preds = %264
  %268 = shl nuw nsw i64 %265, 1
  %269 = or disjoint i64 %268, 1
  %270 = getelementptr inbounds double, ptr %246, i64 %269
  %271 = load double, ptr %270, align 8
  br label %272

272:                                              ; preds = %267, %264
  %273 = phi double [ %271, %267 ], [ 0x7FF0000000000000, %264 ]
  %274 = load ptr, ptr %89, align 8
  store double %273, ptr %274, align 8
  br label %275

275:                                              ; preds = %272, %245
  %276 = getelementptr inbounds i8, ptr %197, i64 24
  %277 = load i64, ptr %276, align 8
  %278 = add nsw i64 %277, 1
  store i64 %278, ptr %276, align 8
  %279 = load ptr, ptr %77, align 8
  %280 = load ptr, ptr %90, align 8
  %281 = load ptr, ptr %91, align 8
  store double %231, ptr %281, align 8
  %282 = load i64, ptr %92, align 8
  %283 = icmp sgt i64 %282, 0
  br i1 %283, label %284, label %285

284:                                              ; preds = %275
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %285

285:                                              ; preds = %275, %284
  %286 = load ptr, ptr %76, align 8
  %287 = load i64, ptr %286, align 8
  %288 = load ptr, ptr %91, align 8
  %289 = load ptr, ptr %93, align 8
  %290 = load ptr, ptr %94, align 8
  %291 = inttoptr i64 %287 to ptr
  %292 = load ptr, ptr %291, align 8
  %293 = tail call i32 %292(ptr noundef %288, ptr noundef %279, ptr noundef %289, ptr noundef %290, ptr noundef %280) #11
  %294 = icmp eq i32 %293, 0
  br i1 %294, label %299, label %295

295:                                              ; preds = %285
  %296 = getelementptr inbounds i8, ptr %197, i64 72
  store i64 3, ptr %296, align 8
  %297 = icmp slt i32 %293, 0
  %298 = select i1 %297, i64 -4, i64 2
  br label %2002

299:                                              ; preds = %285
  store i64 1, ptr %197, align 8
  %300 = getelementptr inbounds i8, ptr %195, i64 24
  store double 0.000000e+00, ptr %300, align 8
  %301 = getelementptr inbounds i8, ptr %198, i64 32
  store i64 1, ptr %301, align 8
  %302 = getelementptr inbounds i8, ptr %198, i64 8
  store i64 1, ptr %302, align 8
  %303 = getelementptr inbounds i8, ptr %196, i64 8
  store double 0.000000e+00, ptr %303, align 8
  %304 = load ptr, ptr %77, align 8
  %305 = load ptr, ptr %76, align 8
  %306 = getelementptr inbounds i8, ptr %305, i64 8
  %307 = load i64, ptr %306, align 8
  %308 = load i64, ptr %83, align 8
  %309 = load ptr, ptr %82, align 8
  %310 = load ptr, ptr %81, align 8
  %311 = getelementptr inbounds i8, ptr %310, i64 48
  %312 = load i64, ptr %311, align 8
  %313 = icmp slt i64 %312, %308
  br i1 %313, label %314, label %337

314:                                              ; preds = %299
  %315 = icmp sgt i64 %307, 0
  br label %316

316:                                              ; preds = %314, %327
  %317 = phi i64 [ %312, %314 ], [ %328, %327 ]
  %318 = getelementptr inbounds double, ptr %309, i64 %317
  %319 = load double, ptr %318, align 8
  %320 = load ptr, ptr %79, align 8
  %321 = load double, ptr %320, align 8
  %322 = fcmp ugt double %319, %321
  br i1 %322, label %337, label %323

323:                                              ; preds = %316
  br i1 %315, label %324, label %327

324:                                              ; preds = %323
  %325 = mul nsw i64 %317, %307
  %326 = getelementptr double, ptr %1, i64 %325
  br label %330

327:                                              ; preds = %330, %323
  %328 = add i64 %317, 1
  %329 = icmp eq i64 %328, %308
  br i1 %329, label %337, label %316, !llvm.loop !10

330:                                              ; preds = %324, %330
  %331 = phi i64 [ 0, %324 ], [ %335, %330 ]
  %332 = getelementptr inbounds double, ptr %304, i64 %331
  %333 = load double, ptr %332, align 8
  %334 = getelementptr double, ptr %326, i64 %331
  store double %333, ptr %334, align 8
  %335 = add nuw nsw i64 %331, 1
  %336 = icmp eq i64 %335, %307
  br i1 %336, label %327, label %330, !llvm.loop !11

337:                                              ; preds = %316, %327, %299
  %338 = phi i64 [ %312, %299 ], [ %317, %316 ], [ %308, %327 ]
  %339 = load ptr, ptr %81, align 8
  %340 = getelementptr inbounds i8, ptr %339, i64 48
  store i64 %338, ptr %340, align 8
  %341 = icmp eq i64 %338, %308
  br i1 %341, label %2002, label %342

342:                                              ; preds = %337
  %343 = fcmp oeq double %233, 0.000000e+00
  br i1 %343, label %344, label %368

344:                                              ; preds = %342
  %345 = getelementptr inbounds i8, ptr %195, i64 16
  %346 = load double, ptr %345, align 8
  %347 = load ptr, ptr %77, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %347, ptr noundef %347, ptr noundef nonnull %77, i64 noundef %205) #10
  %348 = load double, ptr %4, align 8
  %349 = load ptr, ptr %95, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %349, ptr noundef %347, ptr noundef nonnull %77, i64 noundef %205) #10
  %350 = load double, ptr %5, align 8
  %351 = fcmp uge double %348, 1.000000e-05
  %352 = fcmp uge double %350, 1.000000e-05
  %353 = and i1 %351, %352
  %354 = fmul double %348, 1.000000e-02
  %355 = fdiv double %354, %350
  %356 = select i1 %353, double %355, double 0x3EB0C6F7A0B5ED8D
  %357 = fcmp olt double %346, %356
  %358 = select i1 %357, double %346, double %356
  %359 = tail call double @llvm.fabs.f64(double %231)
  %360 = fmul double %359, 0x3D30000000000000
  %361 = fcmp ogt double %360, %358
  %362 = select i1 %361, double %360, double %358
  %363 = fcmp olt double %346, %362
  %364 = select i1 %363, double %346, double %362
  %365 = tail call i1 @llvm.is.fpclass.f64(double %364, i32 639)
  br i1 %365, label %366, label %368

366:                                              ; preds = %344
  %367 = getelementptr inbounds i8, ptr %197, i64 72
  store i64 4, ptr %367, align 8
  br label %368

368:                                              ; preds = %344, %366, %342, %221
  %369 = phi double [ %233, %342 ], [ %233, %221 ], [ %364, %366 ], [ %364, %344 ]
  %370 = load i64, ptr %199, align 8
  %371 = icmp eq i64 %370, 0
  br i1 %371, label %407, label %372

372:                                              ; preds = %368
  %373 = getelementptr inbounds i8, ptr %197, i64 8
  %374 = getelementptr inbounds i8, ptr %197, i64 16
  %375 = getelementptr inbounds i8, ptr %197, i64 64
  %376 = getelementptr inbounds i8, ptr %195, i64 16
  %377 = getelementptr inbounds i8, ptr %198, i64 8
  %378 = getelementptr inbounds i8, ptr %198, i64 16
  %379 = getelementptr inbounds i8, ptr %198, i64 24
  %380 = getelementptr inbounds i8, ptr %198, i64 24
  %381 = getelementptr inbounds i8, ptr %197, i64 40
  %382 = getelementptr inbounds i8, ptr %196, i64 8
  %383 = fmul double %222, %230
  %384 = fmul double %383, %383
  %385 = icmp sgt i64 %205, 0
  %386 = shl i64 %205, 4
  %387 = getelementptr inbounds i8, ptr %198, i64 32
  %388 = getelementptr inbounds i8, ptr %197, i64 72
  %389 = getelementptr inbounds i8, ptr %198, i64 16
  %390 = getelementptr inbounds i8, ptr %197, i64 72
  %391 = getelementptr inbounds i8, ptr %198, i64 16
  %392 = getelementptr inbounds i8, ptr %195, i64 24
  %393 = getelementptr inbounds i8, ptr %195, i64 32
  %394 = getelementptr inbounds i8, ptr %195, i64 32
  %395 = getelementptr inbounds i8, ptr %197, i64 48
  %396 = icmp sgt i64 %205, 0
  %397 = getelementptr inbounds i8, ptr %197, i64 24
  %398 = getelementptr inbounds i8, ptr %197, i64 72
  %399 = getelementptr inbounds i8, ptr %198, i64 16
  %400 = getelementptr inbounds i8, ptr %197, i64 48
  %401 = getelementptr inbounds i8, ptr %198, i64 16
  %402 = getelementptr inbounds i8, ptr %197, i64 72
  %403 = getelementptr inbounds i8, ptr %197, i64 72
  %404 = getelementptr inbounds i8, ptr %198, i64 16
  %405 = getelementptr inbounds i8, ptr %197, i64 72
  %406 = getelementptr inbounds i8, ptr %198, i64 16
  br label %413

407:                                              ; preds = %1999, %368
  %408 = phi double [ %191, %368 ], [ %1991, %1999 ]
  %409 = phi i32 [ %192, %368 ], [ %1992, %1999 ]
  %410 = phi i64 [ %193, %368 ], [ %1993, %1999 ]
  %411 = phi i64 [ %194, %368 ], [ %1994, %1999 ]
  %412 = phi double [ %369, %368 ], [ %1995, %1999 ]
  store double %412, ptr %232, align 8
  br label %2002

413:                                              ; preds = %372, %1999
  %414 = phi i64 [ %370, %372 ], [ %2000, %1999 ]
  %415 = phi i64 [ undef, %372 ], [ %1998, %1999 ]
  %416 = phi double [ %231, %372 ], [ %1996, %1999 ]
  %417 = phi double [ %369, %372 ], [ %1995, %1999 ]
  %418 = phi i64 [ %194, %372 ], [ %1994, %1999 ]
  %419 = phi i64 [ %193, %372 ], [ %1993, %1999 ]
  %420 = phi i32 [ %192, %372 ], [ %1992, %1999 ]
  %421 = phi double [ %191, %372 ], [ %1991, %1999 ]
  %422 = load ptr, ptr %96, align 8
  %423 = getelementptr inbounds i8, ptr %422, i64 8
  %424 = load i64, ptr %423, align 8
  %425 = icmp sgt i64 %424, 0
  br i1 %425, label %426, label %431

426:                                              ; preds = %413
  %427 = load i64, ptr %422, align 8
  %428 = add nsw i64 %427, 3
  %429 = icmp slt i64 %424, %428
  %430 = zext i1 %429 to i32
  br label %431

431:                                              ; preds = %413, %426
  %432 = phi i32 [ 0, %413 ], [ %430, %426 ]
  %433 = icmp eq i32 %432, 0
  br i1 %433, label %435, label %434

434:                                              ; preds = %431
  store double %417, ptr %232, align 8
  br label %2002

435:                                              ; preds = %431
  %436 = add nsw i64 %414, -1
  store i64 %436, ptr %199, align 8
  %437 = load i64, ptr %373, align 8
  %438 = load i64, ptr %374, align 8
  %439 = add nsw i64 %438, %437
  %440 = load i64, ptr %375, align 8
  %441 = icmp slt i64 %439, %440
  br i1 %441, label %443, label %442

442:                                              ; preds = %435
  store double %417, ptr %232, align 8
  br label %2002

443:                                              ; preds = %435
  %444 = load ptr, ptr %97, align 8
  %445 = load i64, ptr %98, align 8
  %446 = icmp eq i64 %445, 0
  br i1 %446, label %479, label %447

447:                                              ; preds = %443
  %448 = icmp sgt i64 %445, 0
  br i1 %448, label %449, label %462

449:                                              ; preds = %447, %449
  %450 = phi i64 [ %460, %449 ], [ %445, %447 ]
  %451 = phi i64 [ %459, %449 ], [ 0, %447 ]
  %452 = add nuw nsw i64 %450, %451
  %453 = lshr i64 %452, 1
  %454 = and i64 %452, -2
  %455 = getelementptr inbounds double, ptr %444, i64 %454
  %456 = load double, ptr %455, align 8
  %457 = fcmp ogt double %456, %416
  %458 = add nuw nsw i64 %453, 1
  %459 = select i1 %457, i64 %451, i64 %458
  %460 = select i1 %457, i64 %453, i64 %450
  %461 = icmp slt i64 %459, %460
  br i1 %461, label %449, label %462, !llvm.loop !9

462:                                              ; preds = %449, %447
  %463 = phi i64 [ 0, %447 ], [ %459, %449 ]
  %464 = icmp slt i64 %463, %445
  br i1 %464, label %465, label %470

465:                                              ; preds = %462
  %466 = shl nuw nsw i64 %463, 1
  %467 = or disjoint i64 %466, 1
  %468 = getelementptr inbounds double, ptr %444, i64 %467
  %469 = load double, ptr %468, align 8
  br label %470

470:                                              ; preds = %465, %462
  %471 = phi double [ %469, %465 ], [ 0x7FF0000000000000, %462 ]
  %472 = load ptr, ptr %99, align 8
  store double %471, ptr %472, align 8
  %473 = load i64, ptr %98, align 8
  %474 = icmp slt i64 %463, %473
  br i1 %474, label %475, label %479

475:                                              ; preds = %470
  %476 = shl nsw i64 %463, 4
  %477 = getelementptr inbounds i8, ptr %444, i64 %476
  %478 = load double, ptr %477, align 8
  br label %479

479:                                              ; preds = %443, %470, %475
  %480 = phi double [ 0x7FF0000000000000, %443 ], [ %478, %475 ], [ 0x7FF0000000000000, %470 ]
  %481 = fcmp olt double %210, %480
  %482 = select i1 %481, double %210, double %480
  %483 = load double, ptr %376, align 8
  %484 = fcmp olt double %417, %483
  %485 = select i1 %484, double %417, double %483
  %486 = fadd double %416, %485
  %487 = fmul double %485, 1.000000e-03
  %488 = fsub double %482, %487
  %489 = fcmp ule double %486, %488
  %490 = select i1 %489, double %486, double %482
  %491 = fsub double %490, %416
  %492 = fmul double %491, 6.250000e-02
  %493 = fadd double %416, %492
  %494 = fcmp ule double %493, %416
  %495 = fcmp une double %490, %482
  %496 = and i1 %495, %494
  br i1 %496, label %497, label %498

497:                                              ; preds = %479
  store double %491, ptr %232, align 8
  br label %1990

498:                                              ; preds = %479
  %499 = load i64, ptr %377, align 8
  %500 = icmp eq i64 %499, 1
  br i1 %500, label %501, label %621

501:                                              ; preds = %498
  %502 = load ptr, ptr %81, align 8
  %503 = getelementptr inbounds i8, ptr %502, i64 32
  %504 = load i64, ptr %503, align 8
  %505 = add nsw i64 %504, 1
  store i64 %505, ptr %503, align 8
  %506 = load ptr, ptr %76, align 8
  %507 = getelementptr inbounds i8, ptr %506, i64 8
  %508 = load i64, ptr %507, align 8
  %509 = load ptr, ptr %78, align 8
  %510 = load i64, ptr %509, align 8
  %511 = icmp eq i64 %510, 0
  br i1 %511, label %512, label %514

512:                                              ; preds = %501
  %513 = icmp sgt i64 %508, 0
  br i1 %513, label %533, label %531

514:                                              ; preds = %501
  %515 = load ptr, ptr %101, align 8
  store double %416, ptr %515, align 8
  %516 = load i64, ptr %102, align 8
  %517 = icmp sgt i64 %516, 0
  br i1 %517, label %518, label %519

518:                                              ; preds = %514
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %519

519:                                              ; preds = %518, %514
  %520 = load ptr, ptr %78, align 8
  %521 = load i64, ptr %520, align 8
  %522 = load ptr, ptr %103, align 8
  %523 = load ptr, ptr %77, align 8
  %524 = load ptr, ptr %104, align 8
  %525 = load ptr, ptr %105, align 8
  %526 = load ptr, ptr %100, align 8
  %527 = inttoptr i64 %521 to ptr
  %528 = load ptr, ptr %527, align 8
  %529 = tail call i32 %528(ptr noundef %522, ptr noundef %523, ptr noundef %524, ptr noundef %525, ptr noundef %526) #11
  %530 = sext i32 %529 to i64
  br label %602

531:                                              ; preds = %533, %512
  %532 = icmp sgt i64 %508, 0
  br i1 %532, label %545, label %602

533:                                              ; preds = %512, %533
  %534 = phi i64 [ %540, %533 ], [ 0, %512 ]
  %535 = load ptr, ptr %77, align 8
  %536 = getelementptr inbounds double, ptr %535, i64 %534
  %537 = load double, ptr %536, align 8
  %538 = load ptr, ptr %106, align 8
  %539 = getelementptr inbounds double, ptr %538, i64 %534
  store double %537, ptr %539, align 8
  %540 = add nuw nsw i64 %534, 1
  %541 = icmp eq i64 %540, %508
  br i1 %541, label %531, label %533, !llvm.loop !12

542:                                              ; preds = %600
  %543 = add nuw nsw i64 %547, 1
  %544 = icmp eq i64 %543, %508
  br i1 %544, label %602, label %545, !llvm.loop !13

545:                                              ; preds = %531, %542
  %546 = phi i64 [ %601, %542 ], [ undef, %531 ]
  %547 = phi i64 [ %543, %542 ], [ 0, %531 ]
  %548 = load ptr, ptr %77, align 8
  %549 = getelementptr inbounds double, ptr %548, i64 %547
  %550 = load double, ptr %549, align 8
  %551 = tail call double @llvm.fabs.f64(double %550)
  %552 = fcmp olt double %551, 1.000000e-05
  %553 = select i1 %552, double 1.000000e-05, double %551
  %554 = fmul double %553, 1.500000e-08
  %555 = fadd double %550, %554
  %556 = load ptr, ptr %107, align 8
  %557 = getelementptr inbounds double, ptr %556, i64 %547
  store double %555, ptr %557, align 8
  %558 = load ptr, ptr %81, align 8
  %559 = getelementptr inbounds i8, ptr %558, i64 24
  %560 = load i64, ptr %559, align 8
  %561 = add nsw i64 %560, 1
  store i64 %561, ptr %559, align 8
  %562 = load ptr, ptr %107, align 8
  %563 = load ptr, ptr %108, align 8
  %564 = load ptr, ptr %109, align 8
  store double %416, ptr %564, align 8
  %565 = load i64, ptr %110, align 8
  %566 = icmp sgt i64 %565, 0
  br i1 %566, label %567, label %568

567:                                              ; preds = %545
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %568

568:                                              ; preds = %567, %545
  %569 = load ptr, ptr %76, align 8
  %570 = load i64, ptr %569, align 8
  %571 = load ptr, ptr %109, align 8
  %572 = load ptr, ptr %111, align 8
  %573 = load ptr, ptr %112, align 8
  %574 = inttoptr i64 %570 to ptr
  %575 = load ptr, ptr %574, align 8
  %576 = tail call i32 %575(ptr noundef %571, ptr noundef %562, ptr noundef %572, ptr noundef %573, ptr noundef %563) #11
  %577 = sext i32 %576 to i64
  %578 = icmp eq i32 %576, 0
  br i1 %578, label %579, label %600

579:                                              ; preds = %568
  %580 = fsub double %555, %550
  br label %584

581:                                              ; preds = %584
  %582 = load ptr, ptr %107, align 8
  %583 = getelementptr inbounds double, ptr %582, i64 %547
  store double %550, ptr %583, align 8
  br label %600

584:                                              ; preds = %579, %584
  %585 = phi i64 [ 0, %579 ], [ %598, %584 ]
  %586 = load ptr, ptr %108, align 8
  %587 = getelementptr inbounds double, ptr %586, i64 %585
  %588 = load double, ptr %587, align 8
  %589 = load ptr, ptr %113, align 8
  %590 = getelementptr inbounds double, ptr %589, i64 %585
  %591 = load double, ptr %590, align 8
  %592 = fsub double %588, %591
  %593 = fdiv double %592, %580
  %594 = load ptr, ptr %100, align 8
  %595 = mul nuw nsw i64 %585, %508
  %596 = getelementptr double, ptr %594, i64 %595
  %597 = getelementptr double, ptr %596, i64 %547
  store double %593, ptr %597, align 8
  %598 = add nuw nsw i64 %585, 1
  %599 = icmp eq i64 %598, %508
  br i1 %599, label %581, label %584, !llvm.loop !14

600:                                              ; preds = %581, %568
  %601 = phi i64 [ %546, %581 ], [ %577, %568 ]
  br i1 %578, label %542, label %602

602:                                              ; preds = %600, %542, %531, %519
  %603 = phi i64 [ %530, %519 ], [ 0, %531 ], [ 0, %542 ], [ %601, %600 ]
  %604 = load i64, ptr %114, align 8
  %605 = icmp sgt i64 %604, 0
  br i1 %605, label %606, label %618

606:                                              ; preds = %602, %614
  %607 = phi i64 [ %615, %614 ], [ 0, %602 ]
  %608 = load ptr, ptr %100, align 8
  %609 = getelementptr inbounds double, ptr %608, i64 %607
  %610 = load double, ptr %609, align 8
  %611 = tail call double @llvm.fabs.f64(double %610)
  %612 = fcmp ueq double %611, 0x7FF0000000000000
  br i1 %612, label %613, label %614

613:                                              ; preds = %606
  store double 0.000000e+00, ptr %609, align 8
  br label %614

614:                                              ; preds = %613, %606
  %615 = add nuw nsw i64 %607, 1
  %616 = load i64, ptr %114, align 8
  %617 = icmp slt i64 %615, %616
  br i1 %617, label %606, label %618, !llvm.loop !15

618:                                              ; preds = %614, %602
  %619 = icmp slt i64 %603, 0
  br i1 %619, label %1990, label %620

620:                                              ; preds = %618
  store i64 0, ptr %377, align 8
  store i64 1, ptr %378, align 8
  store i64 0, ptr %379, align 8
  br label %621

621:                                              ; preds = %620, %498
  %622 = load i64, ptr %380, align 8
  %623 = icmp eq i64 %622, 0
  br i1 %623, label %631, label %624

624:                                              ; preds = %621
  %625 = tail call double @llvm.fabs.f64(double %490)
  %626 = fmul double %625, 0x3CB0000000000000
  %627 = load double, ptr %196, align 8
  %628 = fsub double %491, %627
  %629 = tail call double @llvm.fabs.f64(double %628)
  %630 = fcmp ogt double %629, %626
  br i1 %630, label %631, label %694

631:                                              ; preds = %624, %621
  %632 = load i64, ptr %381, align 8
  %633 = add nsw i64 %632, 1
  store i64 %633, ptr %381, align 8
  %634 = load i64, ptr %116, align 8
  %635 = load ptr, ptr %117, align 8
  %636 = load ptr, ptr %118, align 8
  %637 = icmp sgt i64 %634, 0
  br i1 %637, label %638, label %646

638:                                              ; preds = %631
  %639 = fdiv double 0x400D1A48D83E731D, %491
  %640 = add nuw i64 %634, 1
  %641 = fdiv double 0x400572DB93E0C672, %491
  %642 = fdiv double 0x40086747F2C3FCB6, %491
  br label %643

643:                                              ; preds = %638, %650
  %644 = phi i64 [ 0, %638 ], [ %661, %650 ]
  %645 = mul nuw nsw i64 %644, %634
  br label %663

646:                                              ; preds = %650, %631
  %647 = load ptr, ptr %115, align 8
  %648 = tail call fastcc i32 @real_factorise(ptr noundef %635, i64 noundef %634, ptr noundef %647) #10
  %649 = icmp eq i32 %648, 0
  br i1 %649, label %684, label %679

650:                                              ; preds = %663
  %651 = mul i64 %644, %640
  %652 = getelementptr inbounds double, ptr %635, i64 %651
  %653 = load double, ptr %652, align 8
  %654 = fadd double %639, %653
  store double %654, ptr %652, align 8
  %655 = getelementptr inbounds { double, double }, ptr %636, i64 %651
  %656 = load double, ptr %655, align 8
  %657 = getelementptr inbounds i8, ptr %655, i64 8
  %658 = load double, ptr %657, align 8
  %659 = fadd double %641, %656
  %660 = fsub double %658, %642
  store double %659, ptr %655, align 8
  store double %660, ptr %657, align 8
  %661 = add nuw nsw i64 %644, 1
  %662 = icmp eq i64 %661, %634
  br i1 %662, label %646, label %643, !llvm.loop !16

663:                                              ; preds = %643, %663
  %664 = phi i64 [ 0, %643 ], [ %677, %663 ]
  %665 = load ptr, ptr %119, align 8
  %666 = add nuw nsw i64 %664, %645
  %667 = getelementptr inbounds double, ptr %665, i64 %666
  %668 = load double, ptr %667, align 8
  %669 = fneg double %668
  %670 = getelementptr inbounds double, ptr %635, i64 %666
  store double %669, ptr %670, align 8
  %671 = load ptr, ptr %119, align 8
  %672 = getelementptr inbounds double, ptr %671, i64 %666
  %673 = load double, ptr %672, align 8
  %674 = fneg double %673
  %675 = getelementptr inbounds { double, double }, ptr %636, i64 %666
  %676 = getelementptr inbounds i8, ptr %675, i64 8
  store double %674, ptr %675, align 8
  store double 0.000000e+00, ptr %676, align 8
  %677 = add nuw nsw i64 %664, 1
  %678 = icmp eq i64 %677, %634
  br i1 %678, label %650, label %663, !llvm.loop !17

679:                                              ; preds = %646
  %680 = load ptr, ptr %120, align 8
  %681 = tail call fastcc i32 @pair_factorise(ptr noundef %636, i64 noundef %634, ptr noundef %680) #10
  %682 = icmp ne i32 %681, 0
  %683 = zext i1 %682 to i32
  br label %684

684:                                              ; preds = %646, %679
  %685 = phi i32 [ 0, %646 ], [ %683, %679 ]
  %686 = icmp eq i32 %685, 0
  br i1 %686, label %687, label %693

687:                                              ; preds = %684
  store i64 4, ptr %405, align 8
  %688 = load i64, ptr %374, align 8
  %689 = add nsw i64 %688, 1
  store i64 %689, ptr %374, align 8
  %690 = fmul double %491, 5.000000e-01
  %691 = load i64, ptr %406, align 8
  %692 = sub nsw i64 1, %691
  store i64 %692, ptr %377, align 8
  store i64 0, ptr %380, align 8
  br label %1990, !llvm.loop !18

693:                                              ; preds = %684
  store i64 1, ptr %380, align 8
  store double %491, ptr %196, align 8
  br label %694

694:                                              ; preds = %693, %624
  %695 = load double, ptr %382, align 8
  %696 = load ptr, ptr %76, align 8
  %697 = getelementptr inbounds i8, ptr %696, i64 8
  %698 = load i64, ptr %697, align 8
  %699 = load ptr, ptr %121, align 8
  %700 = load ptr, ptr %77, align 8
  %701 = load ptr, ptr %122, align 8
  %702 = load ptr, ptr %123, align 8
  %703 = fcmp ogt double %695, 0.000000e+00
  %704 = icmp sgt i64 %698, 0
  %705 = shl i64 %698, 4
  %706 = getelementptr i8, ptr %699, i64 %705
  %707 = mul i64 %698, 24
  %708 = getelementptr i8, ptr %699, i64 %707
  %709 = getelementptr double, ptr %699, i64 %698
  br label %715

710:                                              ; preds = %729
  %711 = icmp sgt i64 %698, 0
  %712 = getelementptr double, ptr %701, i64 %698
  %713 = shl i64 %698, 4
  %714 = getelementptr i8, ptr %701, i64 %713
  br label %756

715:                                              ; preds = %694, %729
  %716 = phi i64 [ 0, %694 ], [ %730, %729 ]
  br i1 %703, label %717, label %723

717:                                              ; preds = %715
  %718 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %716
  %719 = load double, ptr %718, align 8
  %720 = fmul double %491, %719
  %721 = fdiv double %720, %695
  %722 = fadd double %721, 1.000000e+00
  br label %723

723:                                              ; preds = %717, %715
  %724 = phi double [ %722, %717 ], [ 0.000000e+00, %715 ]
  br i1 %704, label %725, label %729

725:                                              ; preds = %723
  %726 = mul nuw nsw i64 %698, %716
  %727 = getelementptr double, ptr %701, i64 %726
  %728 = fsub double 1.000000e+00, %724
  br label %732

729:                                              ; preds = %753, %723
  %730 = add nuw nsw i64 %716, 1
  %731 = icmp eq i64 %730, 3
  br i1 %731, label %710, label %715, !llvm.loop !19

732:                                              ; preds = %725, %753
  %733 = phi i64 [ 0, %725 ], [ %754, %753 ]
  %734 = getelementptr double, ptr %727, i64 %733
  store double 0.000000e+00, ptr %734, align 8
  br i1 %703, label %735, label %753

735:                                              ; preds = %732
  %736 = getelementptr double, ptr %706, i64 %733
  %737 = load double, ptr %736, align 8
  %738 = getelementptr double, ptr %708, i64 %733
  %739 = load double, ptr %738, align 8
  %740 = fmul double %724, %739
  %741 = fadd double %737, %740
  %742 = fmul double %728, %741
  %743 = getelementptr inbounds double, ptr %699, i64 %733
  %744 = load double, ptr %743, align 8
  %745 = getelementptr double, ptr %709, i64 %733
  %746 = load double, ptr %745, align 8
  %747 = fadd double %746, %742
  %748 = fmul double %724, %747
  %749 = fadd double %744, %748
  %750 = getelementptr inbounds double, ptr %700, i64 %733
  %751 = load double, ptr %750, align 8
  %752 = fsub double %749, %751
  store double %752, ptr %734, align 8
  br label %753

753:                                              ; preds = %735, %732
  %754 = add nuw nsw i64 %733, 1
  %755 = icmp eq i64 %754, %698
  br i1 %755, label %729, label %732, !llvm.loop !20

756:                                              ; preds = %710, %767
  %757 = phi i64 [ 0, %710 ], [ %768, %767 ]
  br i1 %711, label %758, label %767

758:                                              ; preds = %756
  %759 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %757
  %760 = load double, ptr %759, align 8
  %761 = getelementptr inbounds i8, ptr %759, i64 8
  %762 = load double, ptr %761, align 8
  %763 = getelementptr inbounds i8, ptr %759, i64 16
  %764 = load double, ptr %763, align 8
  %765 = mul nuw nsw i64 %698, %757
  %766 = getelementptr double, ptr %702, i64 %765
  br label %770

767:                                              ; preds = %770, %756
  %768 = add nuw nsw i64 %757, 1
  %769 = icmp eq i64 %768, 3
  br i1 %769, label %786, label %756, !llvm.loop !21

770:                                              ; preds = %758, %770
  %771 = phi i64 [ 0, %758 ], [ %784, %770 ]
  %772 = getelementptr inbounds double, ptr %701, i64 %771
  %773 = load double, ptr %772, align 8
  %774 = fmul double %760, %773
  %775 = getelementptr double, ptr %712, i64 %771
  %776 = load double, ptr %775, align 8
  %777 = fmul double %762, %776
  %778 = fadd double %774, %777
  %779 = getelementptr double, ptr %714, i64 %771
  %780 = load double, ptr %779, align 8
  %781 = fmul double %764, %780
  %782 = fadd double %778, %781
  %783 = getelementptr double, ptr %766, i64 %771
  store double %782, ptr %783, align 8
  %784 = add nuw nsw i64 %771, 1
  %785 = icmp eq i64 %784, %698
  br i1 %785, label %767, label %770, !llvm.loop !22

786:                                              ; preds = %767
  %787 = load ptr, ptr %76, align 8, !noalias !23
  %788 = getelementptr inbounds i8, ptr %787, i64 8
  %789 = load i64, ptr %788, align 8, !noalias !23
  %790 = load ptr, ptr %78, align 8, !noalias !23
  %791 = getelementptr inbounds i8, ptr %790, i64 40
  %792 = load i64, ptr %791, align 8, !noalias !23
  %793 = load ptr, ptr %122, align 8, !noalias !23
  %794 = load ptr, ptr %123, align 8, !noalias !23
  %795 = load ptr, ptr %124, align 8, !noalias !23
  %796 = load ptr, ptr %125, align 8, !noalias !23
  %797 = load ptr, ptr %126, align 8, !noalias !23
  %798 = icmp sgt i64 %792, 0
  %799 = select i1 %798, i64 10, i64 6
  %800 = icmp sgt i64 %789, 0
  %801 = fdiv double 0x400D1A48D83E731D, %491
  %802 = fdiv double 0x400572DB93E0C672, %491
  %803 = fdiv double 0xC0086747F2C3FCB6, %491
  %804 = icmp sgt i64 %789, 0
  %805 = getelementptr double, ptr %794, i64 %789
  %806 = shl i64 %789, 4
  %807 = getelementptr i8, ptr %794, i64 %806
  %808 = icmp eq i64 %792, 0
  br label %809

809:                                              ; preds = %786, %1213
  %810 = phi double [ -1.000000e+00, %786 ], [ %1212, %1213 ]
  %811 = phi double [ 0.000000e+00, %786 ], [ %1211, %1213 ]
  %812 = phi i64 [ 0, %786 ], [ %1210, %1213 ]
  %813 = phi i64 [ 0, %786 ], [ %1214, %1213 ]
  %814 = phi i64 [ %418, %786 ], [ %1207, %1213 ]
  %815 = phi i64 [ %419, %786 ], [ %1206, %1213 ]
  %816 = phi i32 [ %420, %786 ], [ %1205, %1213 ]
  %817 = phi double [ %421, %786 ], [ %1204, %1213 ]
  %818 = icmp ugt i64 %813, 5
  %819 = icmp eq i64 %812, 0
  %820 = select i1 %818, i1 %819, i1 false
  br i1 %820, label %1216, label %825

821:                                              ; preds = %847
  %822 = add nuw nsw i64 %826, 1
  %823 = icmp ugt i64 %826, 1
  %824 = icmp eq i64 %822, 3
  br i1 %824, label %871, label %825, !llvm.loop !26

825:                                              ; preds = %809, %821
  %826 = phi i64 [ %822, %821 ], [ 0, %809 ]
  %827 = phi i1 [ %823, %821 ], [ false, %809 ]
  br i1 %800, label %828, label %831

828:                                              ; preds = %825
  %829 = mul nuw nsw i64 %789, %826
  %830 = getelementptr double, ptr %793, i64 %829
  br label %857

831:                                              ; preds = %857, %825
  %832 = load ptr, ptr %81, align 8, !noalias !23
  %833 = getelementptr inbounds i8, ptr %832, i64 24
  %834 = load i64, ptr %833, align 8, !noalias !23
  %835 = add nsw i64 %834, 1
  store i64 %835, ptr %833, align 8, !noalias !23
  %836 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %826
  %837 = load double, ptr %836, align 8, !noalias !23
  %838 = fmul double %491, %837
  %839 = fadd double %416, %838
  %840 = load ptr, ptr %127, align 8, !noalias !23
  %841 = mul nsw i64 %789, %826
  %842 = getelementptr inbounds double, ptr %795, i64 %841
  %843 = load ptr, ptr %128, align 8, !noalias !23
  store double %839, ptr %843, align 8, !noalias !23
  %844 = load i64, ptr %129, align 8, !noalias !23
  %845 = icmp sgt i64 %844, 0
  br i1 %845, label %846, label %847

846:                                              ; preds = %831
  tail call fastcc void @sample(ptr noundef nonnull %76) #10, !noalias !23
  br label %847

847:                                              ; preds = %831, %846
  %848 = load ptr, ptr %76, align 8, !noalias !23
  %849 = load i64, ptr %848, align 8, !noalias !23
  %850 = load ptr, ptr %128, align 8, !noalias !23
  %851 = load ptr, ptr %131, align 8, !noalias !23
  %852 = load ptr, ptr %132, align 8, !noalias !23
  %853 = inttoptr i64 %849 to ptr
  %854 = load ptr, ptr %853, align 8, !noalias !23
  %855 = tail call i32 %854(ptr noundef %850, ptr noundef %840, ptr noundef %851, ptr noundef %852, ptr noundef %842) #11, !noalias !23
  %856 = icmp eq i32 %855, 0
  br i1 %856, label %821, label %869

857:                                              ; preds = %828, %857
  %858 = phi i64 [ 0, %828 ], [ %867, %857 ]
  %859 = load ptr, ptr %77, align 8, !noalias !23
  %860 = getelementptr inbounds double, ptr %859, i64 %858
  %861 = load double, ptr %860, align 8, !noalias !23
  %862 = getelementptr double, ptr %830, i64 %858
  %863 = load double, ptr %862, align 8, !noalias !23
  %864 = fadd double %861, %863
  %865 = load ptr, ptr %130, align 8, !noalias !23
  %866 = getelementptr inbounds double, ptr %865, i64 %858
  store double %864, ptr %866, align 8, !noalias !23
  %867 = add nuw nsw i64 %858, 1
  %868 = icmp eq i64 %867, %789
  br i1 %868, label %831, label %857, !llvm.loop !27

869:                                              ; preds = %847
  %870 = sext i32 %855 to i64
  br label %871

871:                                              ; preds = %821, %869
  %872 = phi i1 [ %827, %869 ], [ %823, %821 ]
  %873 = phi double [ 0.000000e+00, %869 ], [ %817, %821 ]
  %874 = phi i32 [ 0, %869 ], [ %816, %821 ]
  %875 = phi i64 [ %813, %869 ], [ %815, %821 ]
  %876 = phi i64 [ %870, %869 ], [ %814, %821 ]
  %877 = phi i32 [ 1, %869 ], [ 5, %821 ]
  br i1 %872, label %878, label %1216

878:                                              ; preds = %871
  %879 = load ptr, ptr %76, align 8, !noalias !23
  %880 = getelementptr inbounds i8, ptr %879, i64 8
  %881 = load i64, ptr %880, align 8, !noalias !23
  %882 = load ptr, ptr %124, align 8, !noalias !23
  %883 = load ptr, ptr %123, align 8, !noalias !23
  %884 = load ptr, ptr %125, align 8, !noalias !23
  %885 = load ptr, ptr %126, align 8, !noalias !23
  %886 = icmp sgt i64 %881, 0
  br i1 %886, label %887, label %992

887:                                              ; preds = %878
  %888 = shl nuw nsw i64 %881, 1
  %889 = getelementptr double, ptr %882, i64 %881
  %890 = shl i64 %881, 4
  %891 = getelementptr i8, ptr %882, i64 %890
  %892 = load double, ptr %882, align 8, !noalias !23
  %893 = getelementptr inbounds double, ptr %882, i64 %881
  %894 = load double, ptr %893, align 8, !noalias !23
  %895 = fadd double %892, %894
  %896 = getelementptr inbounds double, ptr %882, i64 %888
  %897 = load double, ptr %896, align 8, !noalias !23
  %898 = fadd double %895, %897
  %899 = tail call double @llvm.fabs.f64(double %898)
  %900 = fcmp ueq double %899, 0x7FF0000000000000
  br i1 %900, label %989, label %901

901:                                              ; preds = %887
  %902 = getelementptr double, ptr %883, i64 %881
  %903 = getelementptr inbounds double, ptr %883, i64 %888
  %904 = getelementptr double, ptr %882, i64 %881
  %905 = getelementptr inbounds double, ptr %882, i64 %888
  br label %917

906:                                              ; preds = %917
  %907 = getelementptr inbounds double, ptr %882, i64 %985
  %908 = load double, ptr %907, align 8, !noalias !23
  %909 = getelementptr double, ptr %904, i64 %985
  %910 = load double, ptr %909, align 8, !noalias !23
  %911 = fadd double %908, %910
  %912 = getelementptr inbounds double, ptr %905, i64 %985
  %913 = load double, ptr %912, align 8, !noalias !23
  %914 = fadd double %911, %913
  %915 = tail call double @llvm.fabs.f64(double %914)
  %916 = fcmp ueq double %915, 0x7FF0000000000000
  br i1 %916, label %987, label %917, !llvm.loop !28

917:                                              ; preds = %901, %906
  %918 = phi double [ %908, %906 ], [ %892, %901 ]
  %919 = phi double [ %984, %906 ], [ 0.000000e+00, %901 ]
  %920 = phi i64 [ %985, %906 ], [ 0, %901 ]
  %921 = getelementptr inbounds double, ptr %882, i64 %920
  %922 = fmul double %918, 0x4010B70201A79C46
  %923 = getelementptr double, ptr %889, i64 %920
  %924 = load double, ptr %923, align 8, !noalias !23
  %925 = fmul double %924, 0x3FD4F8C15DA84E86
  %926 = fadd double %922, %925
  %927 = getelementptr double, ptr %891, i64 %920
  %928 = load double, ptr %927, align 8, !noalias !23
  %929 = fmul double %928, 0x3FE0BF7FF59D56EF
  %930 = fadd double %926, %929
  %931 = getelementptr inbounds double, ptr %883, i64 %920
  %932 = load double, ptr %931, align 8, !noalias !23
  %933 = fmul double %801, %932
  %934 = fsub double %930, %933
  %935 = getelementptr inbounds double, ptr %884, i64 %920
  store double %934, ptr %935, align 8, !noalias !23
  %936 = load double, ptr %921, align 8, !noalias !23
  %937 = fmul double %936, 0xC010B70201A79C46
  %938 = load double, ptr %923, align 8, !noalias !23
  %939 = fmul double %938, 0x3FD4F8C15DA84E86
  %940 = fsub double %937, %939
  %941 = load double, ptr %927, align 8, !noalias !23
  %942 = fmul double %941, 0x3FDE810014C55221
  %943 = fadd double %940, %942
  %944 = fmul double %936, 0x3FE017885A24A7F2
  %945 = fmul double %938, 0x4004934E6FCAA598
  %946 = fsub double %944, %945
  %947 = fmul double %941, 0x3FE312C0CF7BDFD1
  %948 = fadd double %946, %947
  %949 = getelementptr double, ptr %902, i64 %920
  %950 = load double, ptr %949, align 8, !noalias !23
  %951 = getelementptr inbounds double, ptr %903, i64 %920
  %952 = load double, ptr %951, align 8, !noalias !23
  %953 = fmul double %802, %950
  %954 = fmul double %803, %952
  %955 = fmul double %802, %952
  %956 = fmul double %803, %950
  %957 = fsub double %953, %954
  %958 = fadd double %956, %955
  %959 = fsub double %943, %957
  %960 = fsub double %948, %958
  %961 = getelementptr inbounds { double, double }, ptr %885, i64 %920
  %962 = getelementptr inbounds i8, ptr %961, i64 8
  store double %959, ptr %961, align 8, !noalias !23
  store double %960, ptr %962, align 8, !noalias !23
  %963 = load double, ptr %935, align 8, !noalias !23
  %964 = tail call double @llvm.fabs.f64(double %963)
  %965 = tail call double @llvm.fabs.f64(double %959)
  %966 = fadd double %964, %965
  %967 = tail call double @llvm.fabs.f64(double %960)
  %968 = fadd double %967, %966
  %969 = fmul double %491, %968
  %970 = load ptr, ptr %77, align 8, !noalias !23
  %971 = getelementptr inbounds double, ptr %970, i64 %920
  %972 = load double, ptr %971, align 8, !noalias !23
  %973 = load ptr, ptr %133, align 8, !noalias !23
  %974 = getelementptr inbounds double, ptr %973, i64 %920
  %975 = load double, ptr %974, align 8, !noalias !23
  %976 = load ptr, ptr %134, align 8, !noalias !23
  %977 = getelementptr inbounds double, ptr %976, i64 %920
  %978 = load double, ptr %977, align 8, !noalias !23
  %979 = tail call double @llvm.fabs.f64(double %972)
  %980 = fmul double %979, %978
  %981 = fadd double %975, %980
  %982 = fdiv double %969, %981
  %983 = fmul double %982, %982
  %984 = fadd double %919, %983
  %985 = add nuw nsw i64 %920, 1
  %986 = icmp eq i64 %985, %881
  br i1 %986, label %992, label %906, !llvm.loop !28

987:                                              ; preds = %906
  %988 = icmp slt i64 %985, %881
  br label %989

989:                                              ; preds = %987, %887
  %990 = phi i1 [ %988, %987 ], [ %886, %887 ]
  %991 = phi double [ %984, %987 ], [ 0.000000e+00, %887 ]
  br i1 %990, label %1216, label %992

992:                                              ; preds = %917, %878, %989
  %993 = phi double [ %991, %989 ], [ 0.000000e+00, %878 ], [ %984, %917 ]
  %994 = load ptr, ptr %76, align 8, !noalias !23
  %995 = getelementptr inbounds i8, ptr %994, i64 8
  %996 = load i64, ptr %995, align 8, !noalias !23
  %997 = load i64, ptr %136, align 8, !noalias !23
  %998 = load ptr, ptr %78, align 8, !noalias !23
  %999 = getelementptr inbounds i8, ptr %998, i64 40
  %1000 = load i64, ptr %999, align 8, !noalias !23
  %1001 = load ptr, ptr %125, align 8, !noalias !23
  %1002 = load ptr, ptr %126, align 8, !noalias !23
  %1003 = load ptr, ptr %137, align 8, !noalias !23
  %1004 = load ptr, ptr %135, align 8, !noalias !23
  tail call fastcc void @real_solve(ptr noundef %1003, i64 noundef %997, ptr noundef %1004, ptr noundef %1001) #10, !noalias !23
  %1005 = load ptr, ptr %138, align 8, !noalias !23
  %1006 = load ptr, ptr %139, align 8, !noalias !23
  tail call fastcc void @pair_solve(ptr noundef %1005, i64 noundef %997, ptr noundef %1006, ptr noundef %1002) #10, !noalias !23
  %1007 = icmp sgt i64 %1000, 0
  br i1 %1007, label %1008, label %1013

1008:                                             ; preds = %992
  %1009 = load ptr, ptr %137, align 8, !noalias !23
  %1010 = load ptr, ptr %135, align 8, !noalias !23
  tail call fastcc void @real_solve_columns(ptr noundef %1009, i64 noundef %997, ptr noundef %1010, ptr noundef %1001, i64 noundef %1000) #10, !noalias !23
  %1011 = load ptr, ptr %138, align 8, !noalias !23
  %1012 = load ptr, ptr %139, align 8, !noalias !23
  tail call fastcc void @pair_solve_columns(ptr noundef %1011, i64 noundef %997, ptr noundef %1012, ptr noundef %1002, i64 noundef %1000) #10, !noalias !23
  br label %1013

1013:                                             ; preds = %1008, %992
  %1014 = icmp sgt i64 %996, 0
  br i1 %1014, label %1015, label %1048

1015:                                             ; preds = %1013
  %1016 = load ptr, ptr %77, align 8, !noalias !23
  %1017 = load ptr, ptr %140, align 8, !noalias !23
  %1018 = load ptr, ptr %141, align 8, !noalias !23
  br label %1019

1019:                                             ; preds = %1015, %1019
  %1020 = phi double [ 0.000000e+00, %1015 ], [ %1045, %1019 ]
  %1021 = phi i64 [ 0, %1015 ], [ %1046, %1019 ]
  %1022 = getelementptr inbounds double, ptr %1016, i64 %1021
  %1023 = load double, ptr %1022, align 8, !noalias !23
  %1024 = getelementptr inbounds double, ptr %1017, i64 %1021
  %1025 = load double, ptr %1024, align 8, !noalias !23
  %1026 = getelementptr inbounds double, ptr %1018, i64 %1021
  %1027 = load double, ptr %1026, align 8, !noalias !23
  %1028 = tail call double @llvm.fabs.f64(double %1023)
  %1029 = fmul double %1028, %1027
  %1030 = fadd double %1025, %1029
  %1031 = getelementptr inbounds double, ptr %1001, i64 %1021
  %1032 = load double, ptr %1031, align 8, !noalias !23
  %1033 = fdiv double %1032, %1030
  %1034 = getelementptr inbounds { double, double }, ptr %1002, i64 %1021
  %1035 = load double, ptr %1034, align 8, !noalias !23
  %1036 = getelementptr inbounds i8, ptr %1034, i64 8
  %1037 = fdiv double %1035, %1030
  %1038 = load double, ptr %1036, align 8, !noalias !23
  %1039 = fdiv double %1038, %1030
  %1040 = fmul double %1033, %1033
  %1041 = fmul double %1037, %1037
  %1042 = fadd double %1040, %1041
  %1043 = fmul double %1039, %1039
  %1044 = fadd double %1042, %1043
  %1045 = fadd double %1020, %1044
  %1046 = add nuw nsw i64 %1021, 1
  %1047 = icmp eq i64 %1046, %996
  br i1 %1047, label %1048, label %1019, !llvm.loop !29

1048:                                             ; preds = %1019, %1013
  %1049 = phi double [ 0.000000e+00, %1013 ], [ %1045, %1019 ]
  %1050 = mul nsw i64 %996, 3
  %1051 = sitofp i64 %1050 to double
  %1052 = fdiv double %1049, %1051
  %1053 = tail call double @llvm.sqrt.f64(double %1052)
  %1054 = fcmp oeq double %1053, 0.000000e+00
  %1055 = fcmp ogt double %993, 0.000000e+00
  %1056 = select i1 %1054, i1 %1055, i1 false
  br i1 %1056, label %1057, label %1059

1057:                                             ; preds = %1048
  %1058 = add nuw nsw i64 %813, 1
  br label %1203

1059:                                             ; preds = %1048
  %1060 = fcmp ogt double %810, 0.000000e+00
  %1061 = select i1 %1060, i1 %819, i1 false
  br i1 %1061, label %1062, label %1075

1062:                                             ; preds = %1059
  %1063 = fdiv double %1053, %810
  %1064 = fcmp ult double %1063, 1.000000e+00
  br i1 %1064, label %1065, label %1073

1065:                                             ; preds = %1062
  %1066 = sub nsw i64 5, %813
  %1067 = sitofp i64 %1066 to double
  %1068 = tail call double @llvm.pow.f64(double %1063, double %1067)
  %1069 = fsub double 1.000000e+00, %1063
  %1070 = fdiv double %1068, %1069
  %1071 = fmul double %1053, %1070
  %1072 = fcmp ogt double %1071, %230
  br i1 %1072, label %1073, label %1075

1073:                                             ; preds = %1065, %1062
  %1074 = add nuw nsw i64 %813, 1
  br label %1203

1075:                                             ; preds = %1065, %1059
  %1076 = phi double [ %811, %1059 ], [ %1063, %1065 ]
  br i1 %804, label %1088, label %1077

1077:                                             ; preds = %1106, %1075
  %1078 = fsub double 1.000000e+00, %1076
  %1079 = fdiv double %1076, %1078
  %1080 = fmul double %1053, %1079
  %1081 = fcmp olt double %1080, %230
  %1082 = select i1 %1060, i1 %1081, i1 false
  %1083 = select i1 %1054, i1 true, i1 %1082
  %1084 = add nuw nsw i64 %813, 1
  %1085 = select i1 %1083, i64 %1084, i64 0
  %1086 = select i1 %819, i64 %1085, i64 %812
  %1087 = icmp sgt i64 %1086, 0
  br i1 %1087, label %1129, label %1202

1088:                                             ; preds = %1075, %1106
  %1089 = phi i64 [ %1107, %1106 ], [ 0, %1075 ]
  %1090 = getelementptr inbounds double, ptr %796, i64 %1089
  %1091 = load double, ptr %1090, align 8, !noalias !23
  %1092 = getelementptr inbounds double, ptr %794, i64 %1089
  %1093 = load double, ptr %1092, align 8, !noalias !23
  %1094 = fadd double %1091, %1093
  store double %1094, ptr %1092, align 8, !noalias !23
  %1095 = getelementptr inbounds { double, double }, ptr %797, i64 %1089
  %1096 = load double, ptr %1095, align 8, !noalias !23
  %1097 = getelementptr inbounds i8, ptr %1095, i64 8
  %1098 = getelementptr double, ptr %805, i64 %1089
  %1099 = load double, ptr %1098, align 8, !noalias !23
  %1100 = fadd double %1096, %1099
  store double %1100, ptr %1098, align 8, !noalias !23
  %1101 = load double, ptr %1097, align 8, !noalias !23
  %1102 = getelementptr double, ptr %807, i64 %1089
  %1103 = load double, ptr %1102, align 8, !noalias !23
  %1104 = fadd double %1101, %1103
  store double %1104, ptr %1102, align 8, !noalias !23
  %1105 = getelementptr double, ptr %793, i64 %1089
  br label %1109

1106:                                             ; preds = %1109
  %1107 = add nuw nsw i64 %1089, 1
  %1108 = icmp eq i64 %1107, %789
  br i1 %1108, label %1077, label %1088, !llvm.loop !30

1109:                                             ; preds = %1088, %1109
  %1110 = phi i64 [ 0, %1088 ], [ %1127, %1109 ]
  %1111 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1110
  %1112 = load double, ptr %1111, align 8, !noalias !23
  %1113 = load double, ptr %1092, align 8, !noalias !23
  %1114 = fmul double %1112, %1113
  %1115 = getelementptr inbounds i8, ptr %1111, i64 8
  %1116 = load double, ptr %1115, align 8, !noalias !23
  %1117 = load double, ptr %1098, align 8, !noalias !23
  %1118 = fmul double %1116, %1117
  %1119 = fadd double %1114, %1118
  %1120 = getelementptr inbounds i8, ptr %1111, i64 16
  %1121 = load double, ptr %1120, align 8, !noalias !23
  %1122 = load double, ptr %1102, align 8, !noalias !23
  %1123 = fmul double %1121, %1122
  %1124 = fadd double %1119, %1123
  %1125 = mul nuw nsw i64 %789, %1110
  %1126 = getelementptr double, ptr %1105, i64 %1125
  store double %1124, ptr %1126, align 8, !noalias !23
  %1127 = add nuw nsw i64 %1110, 1
  %1128 = icmp eq i64 %1127, 3
  br i1 %1128, label %1106, label %1109, !llvm.loop !31

1129:                                             ; preds = %1077
  br i1 %808, label %1203, label %1130

1130:                                             ; preds = %1129
  %1131 = load i64, ptr %142, align 8, !noalias !23
  %1132 = load ptr, ptr %78, align 8, !noalias !23
  %1133 = getelementptr inbounds i8, ptr %1132, i64 40
  %1134 = load i64, ptr %1133, align 8, !noalias !23
  %1135 = load ptr, ptr %145, align 8, !noalias !23
  %1136 = load ptr, ptr %143, align 8, !noalias !23
  %1137 = load ptr, ptr %146, align 8, !noalias !23
  %1138 = icmp sgt i64 %1134, 0
  br i1 %1138, label %1139, label %1199

1139:                                             ; preds = %1130
  %1140 = load i64, ptr %144, align 8, !noalias !23
  %1141 = icmp sgt i64 %1131, 0
  %1142 = getelementptr double, ptr %1136, i64 %1140
  %1143 = shl i64 %1140, 4
  %1144 = getelementptr i8, ptr %1136, i64 %1143
  br label %1145

1145:                                             ; preds = %1139, %1195
  %1146 = phi double [ 0.000000e+00, %1139 ], [ %1196, %1195 ]
  %1147 = phi i64 [ 0, %1139 ], [ %1197, %1195 ]
  br i1 %1141, label %1148, label %1151

1148:                                             ; preds = %1145
  %1149 = add nuw i64 %1147, %1131
  %1150 = load ptr, ptr %77, align 8, !noalias !23
  br label %1156

1151:                                             ; preds = %1156, %1145
  %1152 = phi double [ 0.000000e+00, %1145 ], [ %1188, %1156 ]
  %1153 = phi double [ 0.000000e+00, %1145 ], [ %1172, %1156 ]
  %1154 = fmul double %1146, %1152
  %1155 = fcmp ogt double %1153, %1154
  br i1 %1155, label %1191, label %1195

1156:                                             ; preds = %1148, %1156
  %1157 = phi double [ 0.000000e+00, %1148 ], [ %1172, %1156 ]
  %1158 = phi double [ 0.000000e+00, %1148 ], [ %1188, %1156 ]
  %1159 = phi i64 [ 0, %1148 ], [ %1189, %1156 ]
  %1160 = mul nuw nsw i64 %1159, %1134
  %1161 = add i64 %1149, %1160
  %1162 = getelementptr inbounds double, ptr %1135, i64 %1161
  %1163 = load double, ptr %1162, align 8, !noalias !23
  %1164 = fmul double %1163, %1163
  %1165 = getelementptr inbounds { double, double }, ptr %1137, i64 %1161
  %1166 = load double, ptr %1165, align 8, !noalias !23
  %1167 = getelementptr inbounds i8, ptr %1165, i64 8
  %1168 = load double, ptr %1167, align 8, !noalias !23
  %1169 = tail call double @hypot(double noundef %1166, double noundef %1168) #13
  %1170 = fmul double %1169, %1169
  %1171 = fadd double %1164, %1170
  %1172 = fadd double %1157, %1171
  %1173 = getelementptr inbounds double, ptr %1150, i64 %1161
  %1174 = load double, ptr %1173, align 8, !noalias !23
  %1175 = fmul double %1174, %1174
  %1176 = fadd double %1158, %1175
  %1177 = getelementptr inbounds double, ptr %1136, i64 %1161
  %1178 = load double, ptr %1177, align 8, !noalias !23
  %1179 = fmul double %1178, %1178
  %1180 = getelementptr double, ptr %1142, i64 %1161
  %1181 = load double, ptr %1180, align 8, !noalias !23
  %1182 = fmul double %1181, %1181
  %1183 = fadd double %1179, %1182
  %1184 = getelementptr double, ptr %1144, i64 %1161
  %1185 = load double, ptr %1184, align 8, !noalias !23
  %1186 = fmul double %1185, %1185
  %1187 = fadd double %1183, %1186
  %1188 = fadd double %1176, %1187
  %1189 = add nuw nsw i64 %1159, 1
  %1190 = icmp eq i64 %1189, %1131
  br i1 %1190, label %1151, label %1156, !llvm.loop !32

1191:                                             ; preds = %1151
  %1192 = fcmp ogt double %1152, 0.000000e+00
  %1193 = fdiv double %1153, %1152
  %1194 = select i1 %1192, double %1193, double 1.000000e+00
  br label %1195

1195:                                             ; preds = %1191, %1151
  %1196 = phi double [ %1194, %1191 ], [ %1146, %1151 ]
  %1197 = add nuw nsw i64 %1147, 1
  %1198 = icmp eq i64 %1197, %1134
  br i1 %1198, label %1199, label %1145, !llvm.loop !33

1199:                                             ; preds = %1195, %1130
  %1200 = phi double [ 0.000000e+00, %1130 ], [ %1196, %1195 ]
  %1201 = fcmp ugt double %1200, %384
  br i1 %1201, label %1202, label %1203

1202:                                             ; preds = %1199, %1077
  br label %1203

1203:                                             ; preds = %1202, %1199, %1129, %1073, %1057
  %1204 = phi double [ %811, %1057 ], [ %1063, %1073 ], [ %873, %1129 ], [ %873, %1202 ], [ %873, %1199 ]
  %1205 = phi i32 [ 0, %1057 ], [ 0, %1073 ], [ %874, %1129 ], [ %874, %1202 ], [ %874, %1199 ]
  %1206 = phi i64 [ %1058, %1057 ], [ %1074, %1073 ], [ %875, %1129 ], [ %875, %1202 ], [ %875, %1199 ]
  %1207 = phi i64 [ 0, %1057 ], [ 0, %1073 ], [ %876, %1129 ], [ %876, %1202 ], [ %876, %1199 ]
  %1208 = phi i1 [ false, %1057 ], [ false, %1073 ], [ false, %1129 ], [ true, %1202 ], [ false, %1199 ]
  %1209 = phi i32 [ 1, %1057 ], [ 1, %1073 ], [ 2, %1129 ], [ 0, %1202 ], [ 2, %1199 ]
  %1210 = phi i64 [ %812, %1057 ], [ 0, %1073 ], [ %1086, %1129 ], [ %1086, %1202 ], [ %1086, %1199 ]
  %1211 = phi double [ %811, %1057 ], [ %1063, %1073 ], [ %1076, %1129 ], [ %1076, %1202 ], [ %1076, %1199 ]
  %1212 = phi double [ %810, %1057 ], [ %810, %1073 ], [ %810, %1129 ], [ %1053, %1202 ], [ %810, %1199 ]
  br i1 %1208, label %1213, label %1216

1213:                                             ; preds = %1203
  %1214 = add nuw nsw i64 %813, 1
  %1215 = icmp eq i64 %1214, %799
  br i1 %1215, label %1216, label %809, !llvm.loop !34

1216:                                             ; preds = %989, %1203, %871, %809, %1213
  %1217 = phi double [ %817, %809 ], [ %1204, %1203 ], [ %873, %871 ], [ %1204, %1213 ], [ 0x7FF0000000000000, %989 ]
  %1218 = phi i32 [ %816, %809 ], [ %1205, %1203 ], [ %874, %871 ], [ %1205, %1213 ], [ 0, %989 ]
  %1219 = phi i64 [ %815, %809 ], [ %1206, %1203 ], [ %875, %871 ], [ %1206, %1213 ], [ %813, %989 ]
  %1220 = phi i64 [ %814, %809 ], [ %1207, %1203 ], [ %876, %871 ], [ %1207, %1213 ], [ 0, %989 ]
  %1221 = phi i32 [ 2, %809 ], [ %1209, %1203 ], [ %877, %871 ], [ 2, %1213 ], [ 1, %989 ]
  %1222 = phi i64 [ 0, %809 ], [ %1210, %1203 ], [ %812, %871 ], [ %1210, %1213 ], [ %812, %989 ]
  %1223 = phi double [ %811, %809 ], [ %1211, %1203 ], [ %811, %871 ], [ %1211, %1213 ], [ %811, %989 ]
  %1224 = icmp eq i32 %1221, 2
  br i1 %1224, label %1225, label %1229

1225:                                             ; preds = %1216
  %1226 = icmp sgt i64 %1222, 0
  %1227 = select i1 %1226, i64 %1222, i64 6
  %1228 = zext i1 %1226 to i32
  br label %1229

1229:                                             ; preds = %1216, %1225
  %1230 = phi double [ %1223, %1225 ], [ %1217, %1216 ]
  %1231 = phi i32 [ %1228, %1225 ], [ %1218, %1216 ]
  %1232 = phi i64 [ %1227, %1225 ], [ %1219, %1216 ]
  %1233 = phi i64 [ 0, %1225 ], [ %1220, %1216 ]
  %1234 = icmp slt i64 %1233, 0
  br i1 %1234, label %1990, label %1235

1235:                                             ; preds = %1229
  %1236 = icmp eq i32 %1231, 0
  br i1 %1236, label %1238, label %1237

1237:                                             ; preds = %1235
  br i1 %385, label %1390, label %1288

1238:                                             ; preds = %1235
  %1239 = load i64, ptr %374, align 8
  %1240 = add nsw i64 %1239, 1
  store i64 %1240, ptr %374, align 8
  %1241 = tail call double @llvm.fabs.f64(double %1230)
  %1242 = fcmp ueq double %1241, 0x7FF0000000000000
  %1243 = select i1 %1242, i64 4, i64 7
  %1244 = icmp eq i64 %1233, 0
  %1245 = select i1 %1244, i64 %1243, i64 3
  store i64 %1245, ptr %403, align 8
  %1246 = load i64, ptr %404, align 8
  %1247 = icmp eq i64 %1246, 1
  %1248 = and i1 %1244, %1247
  br i1 %1248, label %1249, label %1275

1249:                                             ; preds = %1238
  %1250 = load i64, ptr %188, align 8
  %1251 = icmp sgt i64 %1250, 0
  br i1 %1251, label %1252, label %1269

1252:                                             ; preds = %1249, %1261
  %1253 = phi i64 [ %1266, %1261 ], [ 0, %1249 ]
  %1254 = phi i32 [ %1263, %1261 ], [ 0, %1249 ]
  %1255 = icmp eq i32 %1254, 0
  br i1 %1255, label %1256, label %1261

1256:                                             ; preds = %1252
  %1257 = load ptr, ptr %187, align 8
  %1258 = getelementptr inbounds double, ptr %1257, i64 %1253
  %1259 = load double, ptr %1258, align 8
  %1260 = fcmp une double %1259, 0.000000e+00
  br label %1261

1261:                                             ; preds = %1256, %1252
  %1262 = phi i1 [ true, %1252 ], [ %1260, %1256 ]
  %1263 = zext i1 %1262 to i32
  %1264 = load ptr, ptr %187, align 8
  %1265 = getelementptr inbounds double, ptr %1264, i64 %1253
  store double 0.000000e+00, ptr %1265, align 8
  %1266 = add nuw nsw i64 %1253, 1
  %1267 = load i64, ptr %188, align 8
  %1268 = icmp slt i64 %1266, %1267
  br i1 %1268, label %1252, label %1269, !llvm.loop !35

1269:                                             ; preds = %1261, %1249
  %1270 = phi i32 [ 0, %1249 ], [ %1263, %1261 ]
  %1271 = icmp eq i32 %1270, 0
  br i1 %1271, label %1273, label %1272

1272:                                             ; preds = %1269
  store i64 0, ptr %380, align 8
  br label %1990, !llvm.loop !18

1273:                                             ; preds = %1269
  store i64 0, ptr %404, align 8
  %1274 = fmul double %491, 5.000000e-01
  br label %1275

1275:                                             ; preds = %1273, %1238
  %1276 = phi double [ %1274, %1273 ], [ %417, %1238 ]
  %1277 = load i64, ptr %404, align 8
  %1278 = icmp eq i64 %1277, 1
  %1279 = icmp ne i64 %1233, 0
  %1280 = or i1 %1279, %1278
  br i1 %1280, label %1281, label %1284

1281:                                             ; preds = %1275
  %1282 = select i1 %1244, double 5.000000e-01, double 2.500000e-01
  %1283 = fmul double %491, %1282
  store double 0.000000e+00, ptr %382, align 8
  br label %1284

1284:                                             ; preds = %1281, %1275
  %1285 = phi double [ %1283, %1281 ], [ %1276, %1275 ]
  %1286 = load i64, ptr %404, align 8
  %1287 = sub nsw i64 1, %1286
  store i64 %1287, ptr %377, align 8
  br label %1990, !llvm.loop !18

1288:                                             ; preds = %1390, %1237
  %1289 = load i64, ptr %387, align 8
  %1290 = icmp eq i64 %1289, 1
  %1291 = load ptr, ptr %76, align 8
  %1292 = getelementptr inbounds i8, ptr %1291, i64 8
  %1293 = load i64, ptr %1292, align 8
  %1294 = load i64, ptr %149, align 8
  %1295 = load ptr, ptr %150, align 8
  %1296 = load ptr, ptr %125, align 8
  %1297 = icmp sgt i64 %1293, 0
  br i1 %1297, label %1298, label %1300

1298:                                             ; preds = %1288
  %1299 = shl i64 %1293, 4
  br label %1309

1300:                                             ; preds = %1309, %1288
  %1301 = load ptr, ptr %152, align 8
  %1302 = load ptr, ptr %148, align 8
  tail call fastcc void @real_solve(ptr noundef %1301, i64 noundef %1294, ptr noundef %1302, ptr noundef %1296) #10
  %1303 = load ptr, ptr %153, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1296, ptr noundef %1303, ptr noundef nonnull %77, i64 noundef %1293) #10
  %1304 = load double, ptr %6, align 8
  %1305 = fcmp uge double %1304, 1.000000e+00
  %1306 = and i1 %1290, %1305
  br i1 %1306, label %1307, label %1386

1307:                                             ; preds = %1300
  %1308 = icmp sgt i64 %1293, 0
  br i1 %1308, label %1358, label %1334

1309:                                             ; preds = %1298, %1309
  %1310 = phi i64 [ 0, %1298 ], [ %1332, %1309 ]
  %1311 = load ptr, ptr %122, align 8
  %1312 = getelementptr inbounds double, ptr %1311, i64 %1310
  %1313 = load double, ptr %1312, align 8
  %1314 = fmul double %1313, 0x402418FD8BAFFE05
  %1315 = getelementptr double, ptr %1311, i64 %1293
  %1316 = getelementptr double, ptr %1315, i64 %1310
  %1317 = load double, ptr %1316, align 8
  %1318 = fmul double %1317, 0x3FF61D41B2D54580
  %1319 = fsub double %1318, %1314
  %1320 = getelementptr i8, ptr %1311, i64 %1299
  %1321 = getelementptr double, ptr %1320, i64 %1310
  %1322 = load double, ptr %1321, align 8
  %1323 = fmul double %1322, 0x3FD5555555555555
  %1324 = fsub double %1319, %1323
  %1325 = fdiv double %1324, %491
  %1326 = getelementptr inbounds double, ptr %1295, i64 %1310
  store double %1325, ptr %1326, align 8
  %1327 = load ptr, ptr %151, align 8
  %1328 = getelementptr inbounds double, ptr %1327, i64 %1310
  %1329 = load double, ptr %1328, align 8
  %1330 = fadd double %1329, %1325
  %1331 = getelementptr inbounds double, ptr %1296, i64 %1310
  store double %1330, ptr %1331, align 8
  %1332 = add nuw nsw i64 %1310, 1
  %1333 = icmp eq i64 %1332, %1293
  br i1 %1333, label %1300, label %1309, !llvm.loop !36

1334:                                             ; preds = %1358, %1307
  %1335 = load ptr, ptr %81, align 8
  %1336 = getelementptr inbounds i8, ptr %1335, i64 24
  %1337 = load i64, ptr %1336, align 8
  %1338 = add nsw i64 %1337, 1
  store i64 %1338, ptr %1336, align 8
  %1339 = load ptr, ptr %155, align 8
  %1340 = load ptr, ptr %124, align 8
  %1341 = load ptr, ptr %156, align 8
  store double %416, ptr %1341, align 8
  %1342 = load i64, ptr %157, align 8
  %1343 = icmp sgt i64 %1342, 0
  br i1 %1343, label %1344, label %1345

1344:                                             ; preds = %1334
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1345

1345:                                             ; preds = %1334, %1344
  %1346 = load ptr, ptr %76, align 8
  %1347 = load i64, ptr %1346, align 8
  %1348 = load ptr, ptr %156, align 8
  %1349 = load ptr, ptr %158, align 8
  %1350 = load ptr, ptr %159, align 8
  %1351 = inttoptr i64 %1347 to ptr
  %1352 = load ptr, ptr %1351, align 8
  %1353 = tail call i32 %1352(ptr noundef %1348, ptr noundef %1339, ptr noundef %1349, ptr noundef %1350, ptr noundef %1340) #11
  %1354 = sext i32 %1353 to i64
  %1355 = icmp eq i32 %1353, 0
  br i1 %1355, label %1356, label %1386

1356:                                             ; preds = %1345
  %1357 = icmp sgt i64 %1293, 0
  br i1 %1357, label %1375, label %1370

1358:                                             ; preds = %1307, %1358
  %1359 = phi i64 [ %1368, %1358 ], [ 0, %1307 ]
  %1360 = load ptr, ptr %77, align 8
  %1361 = getelementptr inbounds double, ptr %1360, i64 %1359
  %1362 = load double, ptr %1361, align 8
  %1363 = getelementptr inbounds double, ptr %1296, i64 %1359
  %1364 = load double, ptr %1363, align 8
  %1365 = fadd double %1362, %1364
  %1366 = load ptr, ptr %154, align 8
  %1367 = getelementptr inbounds double, ptr %1366, i64 %1359
  store double %1365, ptr %1367, align 8
  %1368 = add nuw nsw i64 %1359, 1
  %1369 = icmp eq i64 %1368, %1293
  br i1 %1369, label %1334, label %1358, !llvm.loop !37

1370:                                             ; preds = %1375, %1356
  %1371 = load ptr, ptr %152, align 8
  %1372 = load ptr, ptr %148, align 8
  tail call fastcc void @real_solve(ptr noundef %1371, i64 noundef %1294, ptr noundef %1372, ptr noundef %1296) #10
  %1373 = load ptr, ptr %153, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1296, ptr noundef %1373, ptr noundef nonnull %77, i64 noundef %1293) #10
  %1374 = load double, ptr %7, align 8
  br label %1386

1375:                                             ; preds = %1356, %1375
  %1376 = phi i64 [ %1384, %1375 ], [ 0, %1356 ]
  %1377 = load ptr, ptr %124, align 8
  %1378 = getelementptr inbounds double, ptr %1377, i64 %1376
  %1379 = load double, ptr %1378, align 8
  %1380 = getelementptr inbounds double, ptr %1295, i64 %1376
  %1381 = load double, ptr %1380, align 8
  %1382 = fadd double %1379, %1381
  %1383 = getelementptr inbounds double, ptr %1296, i64 %1376
  store double %1382, ptr %1383, align 8
  %1384 = add nuw nsw i64 %1376, 1
  %1385 = icmp eq i64 %1384, %1293
  br i1 %1385, label %1370, label %1375, !llvm.loop !38

1386:                                             ; preds = %1300, %1345, %1370
  %1387 = phi double [ %1374, %1370 ], [ %1304, %1345 ], [ %1304, %1300 ]
  %1388 = phi i64 [ 0, %1370 ], [ %1354, %1345 ], [ 0, %1300 ]
  %1389 = icmp slt i64 %1388, 0
  br i1 %1389, label %1990, label %1404

1390:                                             ; preds = %1237, %1390
  %1391 = phi i64 [ %1402, %1390 ], [ 0, %1237 ]
  %1392 = load ptr, ptr %77, align 8
  %1393 = getelementptr inbounds double, ptr %1392, i64 %1391
  %1394 = load double, ptr %1393, align 8
  %1395 = load ptr, ptr %122, align 8
  %1396 = getelementptr i8, ptr %1395, i64 %386
  %1397 = getelementptr double, ptr %1396, i64 %1391
  %1398 = load double, ptr %1397, align 8
  %1399 = fadd double %1394, %1398
  %1400 = load ptr, ptr %147, align 8
  %1401 = getelementptr inbounds double, ptr %1400, i64 %1391
  store double %1399, ptr %1401, align 8
  %1402 = add nuw nsw i64 %1391, 1
  %1403 = icmp eq i64 %1402, %205
  br i1 %1403, label %1288, label %1390, !llvm.loop !39

1404:                                             ; preds = %1386
  %1405 = add nsw i64 %1232, 12
  %1406 = sitofp i64 %1405 to double
  %1407 = fdiv double 0x4027666666666667, %1406
  %1408 = fcmp olt double %1387, 1.000000e-10
  %1409 = select i1 %1408, double 1.000000e-10, double %1387
  %1410 = tail call double @llvm.pow.f64(double %1409, double -2.500000e-01)
  %1411 = icmp eq i64 %1388, 0
  %1412 = fcmp olt double %1387, 1.000000e+00
  %1413 = select i1 %1411, i1 %1412, i1 false
  br i1 %1413, label %1429, label %1414

1414:                                             ; preds = %1404
  %1415 = load i64, ptr %374, align 8
  %1416 = add nsw i64 %1415, 1
  store i64 %1416, ptr %374, align 8
  %1417 = select i1 %1411, i64 2, i64 3
  store i64 %1417, ptr %388, align 8
  %1418 = tail call double @llvm.fabs.f64(double %1387)
  %1419 = fcmp ueq double %1418, 0x7FF0000000000000
  br i1 %1419, label %1424, label %1420

1420:                                             ; preds = %1414
  %1421 = fmul double %1407, %1410
  %1422 = fcmp ogt double %1421, 2.000000e-01
  %1423 = select i1 %1422, double %1421, double 2.000000e-01
  br label %1424

1424:                                             ; preds = %1414, %1420
  %1425 = phi double [ %1423, %1420 ], [ 2.500000e-01, %1414 ]
  %1426 = fmul double %491, %1425
  store i64 1, ptr %387, align 8
  %1427 = load i64, ptr %389, align 8
  %1428 = sub nsw i64 1, %1427
  store i64 %1428, ptr %377, align 8
  br label %1990, !llvm.loop !18

1429:                                             ; preds = %1404
  br i1 %213, label %1430, label %1445

1430:                                             ; preds = %1429
  %1431 = load ptr, ptr %153, align 8
  %1432 = load ptr, ptr %77, align 8
  %1433 = load ptr, ptr %84, align 8
  %1434 = getelementptr inbounds i8, ptr %1433, i64 56
  %1435 = load i64, ptr %1434, align 8
  %1436 = inttoptr i64 %1435 to ptr
  %1437 = tail call i64 %1436(ptr noundef %0, double noundef %490, ptr noundef %1431, ptr noundef %1432) #11
  %1438 = icmp eq i64 %1437, 0
  br i1 %1438, label %1445, label %1439

1439:                                             ; preds = %1430
  %1440 = load i64, ptr %374, align 8
  %1441 = add nsw i64 %1440, 1
  store i64 %1441, ptr %374, align 8
  store i64 6, ptr %390, align 8
  %1442 = fmul double %491, 2.500000e-01
  store i64 1, ptr %387, align 8
  %1443 = load i64, ptr %391, align 8
  %1444 = sub nsw i64 1, %1443
  store i64 %1444, ptr %377, align 8
  br label %1990, !llvm.loop !18

1445:                                             ; preds = %1430, %1429
  %1446 = load i64, ptr %373, align 8
  %1447 = add nsw i64 %1446, 1
  store i64 %1447, ptr %373, align 8
  %1448 = load double, ptr %392, align 8
  %1449 = fcmp ogt double %1448, 0.000000e+00
  br i1 %1449, label %1450, label %1459

1450:                                             ; preds = %1445
  %1451 = fdiv double %1448, %1409
  %1452 = tail call double @llvm.pow.f64(double %1451, double 2.500000e-01)
  %1453 = load double, ptr %393, align 8
  %1454 = fdiv double %491, %1453
  %1455 = fmul double %1452, %1454
  %1456 = fcmp olt double %1455, 1.000000e+00
  %1457 = select i1 %1456, double %1455, double 1.000000e+00
  %1458 = fmul double %1410, %1457
  br label %1459

1459:                                             ; preds = %1450, %1445
  %1460 = phi double [ %1458, %1450 ], [ %1410, %1445 ]
  %1461 = fmul double %1407, %1460
  %1462 = fcmp olt double %1461, 1.000000e+01
  store double %490, ptr %195, align 8
  store double %491, ptr %394, align 8
  store double %1409, ptr %392, align 8
  %1463 = load ptr, ptr %76, align 8
  %1464 = getelementptr inbounds i8, ptr %1463, i64 8
  %1465 = load i64, ptr %1464, align 8
  %1466 = load i64, ptr %160, align 8
  %1467 = load ptr, ptr %122, align 8
  %1468 = load ptr, ptr %161, align 8
  %1469 = load ptr, ptr %121, align 8
  br label %1486

1470:                                             ; preds = %1486
  %1471 = select i1 %1462, double %1461, double 1.000000e+01
  %1472 = icmp sgt i64 %1465, 0
  br i1 %1472, label %1473, label %1546

1473:                                             ; preds = %1470
  %1474 = load double, ptr %8, align 16
  %1475 = load double, ptr %162, align 8
  %1476 = getelementptr double, ptr %1467, i64 %1465
  %1477 = load double, ptr %163, align 16
  %1478 = shl i64 %1465, 4
  %1479 = getelementptr i8, ptr %1467, i64 %1478
  %1480 = load double, ptr %9, align 16
  %1481 = load double, ptr %164, align 8
  %1482 = load double, ptr %165, align 16
  %1483 = getelementptr double, ptr %1468, i64 %1466
  %1484 = shl i64 %1466, 4
  %1485 = getelementptr i8, ptr %1468, i64 %1484
  br label %1497

1486:                                             ; preds = %1459, %1486
  %1487 = phi i64 [ 0, %1459 ], [ %1495, %1486 ]
  %1488 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1487
  %1489 = getelementptr inbounds i8, ptr %1488, i64 8
  %1490 = load double, ptr %1489, align 8
  %1491 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1487
  store double %1490, ptr %1491, align 8
  %1492 = getelementptr inbounds i8, ptr %1488, i64 16
  %1493 = load double, ptr %1492, align 8
  %1494 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1487
  store double %1493, ptr %1494, align 8
  %1495 = add nuw nsw i64 %1487, 1
  %1496 = icmp eq i64 %1495, 3
  br i1 %1496, label %1470, label %1486, !llvm.loop !40

1497:                                             ; preds = %1473, %1534
  %1498 = phi i64 [ 0, %1473 ], [ %1535, %1534 ]
  %1499 = getelementptr inbounds double, ptr %1467, i64 %1498
  %1500 = load double, ptr %1499, align 8
  %1501 = fmul double %1474, %1500
  %1502 = getelementptr double, ptr %1476, i64 %1498
  %1503 = load double, ptr %1502, align 8
  %1504 = fmul double %1475, %1503
  %1505 = fadd double %1501, %1504
  %1506 = getelementptr double, ptr %1479, i64 %1498
  %1507 = load double, ptr %1506, align 8
  %1508 = fmul double %1477, %1507
  %1509 = fadd double %1505, %1508
  %1510 = fmul double %1500, %1480
  %1511 = fmul double %1503, %1481
  %1512 = fadd double %1510, %1511
  %1513 = fmul double %1507, %1482
  %1514 = fadd double %1512, %1513
  %1515 = load ptr, ptr %153, align 8
  %1516 = getelementptr inbounds double, ptr %1515, i64 %1498
  %1517 = load double, ptr %1516, align 8
  %1518 = load ptr, ptr %77, align 8
  %1519 = getelementptr inbounds double, ptr %1518, i64 %1498
  %1520 = load double, ptr %1519, align 8
  %1521 = fsub double %1517, %1520
  %1522 = getelementptr inbounds double, ptr %1468, i64 %1498
  store double %1521, ptr %1522, align 8
  %1523 = fneg double %1509
  %1524 = fsub double %1523, %1514
  %1525 = getelementptr double, ptr %1483, i64 %1498
  store double %1524, ptr %1525, align 8
  %1526 = fneg double %1514
  %1527 = getelementptr double, ptr %1485, i64 %1498
  store double %1526, ptr %1527, align 8
  %1528 = load ptr, ptr %77, align 8
  %1529 = getelementptr inbounds double, ptr %1528, i64 %1498
  %1530 = load double, ptr %1529, align 8
  %1531 = getelementptr inbounds double, ptr %1469, i64 %1498
  store double %1530, ptr %1531, align 8
  %1532 = getelementptr double, ptr %1468, i64 %1498
  %1533 = getelementptr double, ptr %1469, i64 %1498
  br label %1537

1534:                                             ; preds = %1537
  %1535 = add nuw nsw i64 %1498, 1
  %1536 = icmp eq i64 %1535, %1465
  br i1 %1536, label %1546, label %1497, !llvm.loop !41

1537:                                             ; preds = %1497, %1537
  %1538 = phi i64 [ 0, %1497 ], [ %1542, %1537 ]
  %1539 = mul nsw i64 %1466, %1538
  %1540 = getelementptr double, ptr %1532, i64 %1539
  %1541 = load double, ptr %1540, align 8
  %1542 = add nuw nsw i64 %1538, 1
  %1543 = mul nuw nsw i64 %1465, %1542
  %1544 = getelementptr double, ptr %1533, i64 %1543
  store double %1541, ptr %1544, align 8
  %1545 = icmp eq i64 %1542, 3
  br i1 %1545, label %1534, label %1537, !llvm.loop !42

1546:                                             ; preds = %1534, %1470
  store double %491, ptr %382, align 8
  %1547 = load ptr, ptr %0, align 8
  %1548 = getelementptr inbounds i8, ptr %1547, i64 24
  %1549 = load i64, ptr %1548, align 8
  %1550 = load ptr, ptr %96, align 8
  %1551 = getelementptr inbounds i8, ptr %1550, i64 8
  %1552 = load i64, ptr %1551, align 8
  %1553 = icmp eq i64 %1552, 0
  br i1 %1553, label %1600, label %1554

1554:                                             ; preds = %1546
  %1555 = load i64, ptr %1550, align 8
  %1556 = load ptr, ptr %76, align 8
  %1557 = getelementptr inbounds i8, ptr %1556, i64 8
  %1558 = load i64, ptr %1557, align 8
  %1559 = load ptr, ptr %166, align 8
  %1560 = load i64, ptr %167, align 8
  %1561 = mul nsw i64 %1560, %1555
  %1562 = getelementptr inbounds double, ptr %1559, i64 %1561
  %1563 = getelementptr inbounds double, ptr %1562, i64 %1560
  store double %416, ptr %1562, align 8
  %1564 = getelementptr inbounds i8, ptr %1562, i64 8
  store double %491, ptr %1564, align 8
  store double %490, ptr %1563, align 8
  %1565 = getelementptr inbounds i8, ptr %1563, i64 8
  store double 0.000000e+00, ptr %1565, align 8
  %1566 = icmp sgt i64 %1558, 0
  br i1 %1566, label %1567, label %1570

1567:                                             ; preds = %1554
  %1568 = getelementptr i8, ptr %1562, i64 16
  %1569 = icmp sgt i64 %1549, 0
  br label %1573

1570:                                             ; preds = %1585, %1554
  %1571 = add nsw i64 %1555, 1
  %1572 = load ptr, ptr %96, align 8
  store i64 %1571, ptr %1572, align 8
  br label %1600

1573:                                             ; preds = %1567, %1585
  %1574 = phi i64 [ 0, %1567 ], [ %1586, %1585 ]
  %1575 = load ptr, ptr %77, align 8
  %1576 = getelementptr inbounds double, ptr %1575, i64 %1574
  %1577 = load double, ptr %1576, align 8
  %1578 = add nuw nsw i64 %1574, 2
  %1579 = getelementptr inbounds double, ptr %1562, i64 %1578
  store double %1577, ptr %1579, align 8
  %1580 = load ptr, ptr %153, align 8
  %1581 = getelementptr inbounds double, ptr %1580, i64 %1574
  %1582 = load double, ptr %1581, align 8
  %1583 = getelementptr inbounds double, ptr %1563, i64 %1578
  store double %1582, ptr %1583, align 8
  %1584 = getelementptr double, ptr %1568, i64 %1574
  br i1 %1569, label %1588, label %1585

1585:                                             ; preds = %1588, %1573
  %1586 = add nuw nsw i64 %1574, 1
  %1587 = icmp eq i64 %1586, %1558
  br i1 %1587, label %1570, label %1573, !llvm.loop !43

1588:                                             ; preds = %1573, %1588
  %1589 = phi i64 [ %1596, %1588 ], [ 0, %1573 ]
  %1590 = load ptr, ptr %161, align 8
  %1591 = load i64, ptr %160, align 8
  %1592 = mul nsw i64 %1591, %1589
  %1593 = getelementptr double, ptr %1590, i64 %1592
  %1594 = getelementptr double, ptr %1593, i64 %1574
  %1595 = load double, ptr %1594, align 8
  %1596 = add nuw nsw i64 %1589, 1
  %1597 = mul nuw nsw i64 %1596, %1558
  %1598 = getelementptr double, ptr %1584, i64 %1597
  store double %1595, ptr %1598, align 8
  %1599 = icmp eq i64 %1596, %1549
  br i1 %1599, label %1585, label %1588, !llvm.loop !44

1600:                                             ; preds = %1546, %1570
  br i1 %217, label %1601, label %1709

1601:                                             ; preds = %1600
  %1602 = load ptr, ptr %85, align 8
  %1603 = load ptr, ptr %76, align 8
  %1604 = getelementptr inbounds i8, ptr %1603, i64 8
  %1605 = load i64, ptr %1604, align 8
  %1606 = load ptr, ptr %168, align 8
  %1607 = getelementptr inbounds i8, ptr %1602, i64 32
  %1608 = load i64, ptr %1607, align 8
  %1609 = getelementptr inbounds double, ptr %1606, i64 %1608
  %1610 = load ptr, ptr %122, align 8
  %1611 = getelementptr inbounds i8, ptr %1602, i64 24
  %1612 = load i64, ptr %1611, align 8
  %1613 = icmp eq i64 %1612, 0
  br i1 %1613, label %1706, label %1614

1614:                                             ; preds = %1601
  %1615 = getelementptr inbounds i8, ptr %1602, i64 40
  %1616 = load i64, ptr %1615, align 8
  %1617 = icmp sgt i64 %1616, 0
  br i1 %1617, label %1618, label %1622

1618:                                             ; preds = %1614
  %1619 = getelementptr double, ptr %1610, i64 %1605
  %1620 = shl i64 %1605, 4
  %1621 = getelementptr i8, ptr %1610, i64 %1620
  br label %1676

1622:                                             ; preds = %1676, %1614
  %1623 = load ptr, ptr %169, align 8
  %1624 = load ptr, ptr %85, align 8
  %1625 = getelementptr inbounds i8, ptr %1624, i64 8
  %1626 = load i64, ptr %1625, align 8
  %1627 = load ptr, ptr %170, align 8
  %1628 = load ptr, ptr %168, align 8
  %1629 = getelementptr inbounds i8, ptr %1624, i64 32
  %1630 = load i64, ptr %1629, align 8
  %1631 = getelementptr inbounds i8, ptr %1624, i64 40
  %1632 = load i64, ptr %1631, align 8
  %1633 = getelementptr double, ptr %1628, i64 %1630
  %1634 = getelementptr double, ptr %1633, i64 %1632
  store double %491, ptr %1634, align 8
  %1635 = load ptr, ptr %169, align 8
  store double %416, ptr %1635, align 8
  %1636 = load ptr, ptr %85, align 8
  %1637 = getelementptr inbounds i8, ptr %1636, i64 24
  %1638 = load i64, ptr %1637, align 8
  %1639 = load ptr, ptr %77, align 8
  %1640 = load ptr, ptr %168, align 8
  %1641 = load ptr, ptr %171, align 8
  %1642 = inttoptr i64 %1638 to ptr
  %1643 = load ptr, ptr %1642, align 8
  %1644 = tail call i32 %1643(ptr noundef %1623, ptr noundef %1639, ptr noundef %1640, ptr noundef %1641, ptr noundef %1627) #11
  %1645 = icmp eq i32 %1644, 0
  br i1 %1645, label %1646, label %1706

1646:                                             ; preds = %1622
  %1647 = icmp slt i64 %1626, 1
  br i1 %1647, label %1673, label %1648

1648:                                             ; preds = %1646
  %1649 = load ptr, ptr %172, align 8
  %1650 = getelementptr double, ptr %1627, i64 %1626
  br label %1651

1651:                                             ; preds = %1648, %1669
  %1652 = phi i1 [ %1647, %1648 ], [ %1671, %1669 ]
  %1653 = phi i64 [ 0, %1648 ], [ %1670, %1669 ]
  %1654 = getelementptr inbounds i64, ptr %1649, i64 %1653
  %1655 = load i64, ptr %1654, align 8
  %1656 = and i64 %1655, 2
  %1657 = icmp eq i64 %1656, 0
  br i1 %1657, label %1658, label %1669

1658:                                             ; preds = %1651
  %1659 = getelementptr inbounds double, ptr %1627, i64 %1653
  %1660 = load double, ptr %1659, align 8
  %1661 = load ptr, ptr %173, align 8
  %1662 = getelementptr inbounds i64, ptr %1661, i64 %1653
  %1663 = load i64, ptr %1662, align 8
  %1664 = sitofp i64 %1663 to double
  %1665 = fmul double %1660, %1664
  %1666 = getelementptr double, ptr %1650, i64 %1653
  %1667 = load double, ptr %1666, align 8
  %1668 = fcmp ogt double %1665, %1667
  br i1 %1668, label %1669, label %1673

1669:                                             ; preds = %1658, %1651
  %1670 = add nuw nsw i64 %1653, 1
  %1671 = icmp sge i64 %1670, %1626
  %1672 = icmp eq i64 %1670, %1626
  br i1 %1672, label %1673, label %1651, !llvm.loop !45

1673:                                             ; preds = %1669, %1658, %1646
  %1674 = phi i1 [ %1647, %1646 ], [ %1671, %1669 ], [ %1652, %1658 ]
  %1675 = zext i1 %1674 to i32
  br label %1706

1676:                                             ; preds = %1618, %1676
  %1677 = phi i64 [ 0, %1618 ], [ %1703, %1676 ]
  %1678 = load ptr, ptr %153, align 8
  %1679 = getelementptr inbounds double, ptr %1678, i64 %1677
  %1680 = load double, ptr %1679, align 8
  %1681 = load ptr, ptr %77, align 8
  %1682 = getelementptr inbounds double, ptr %1681, i64 %1677
  %1683 = load double, ptr %1682, align 8
  %1684 = fsub double %1680, %1683
  %1685 = tail call double @llvm.fabs.f64(double %1684)
  %1686 = getelementptr inbounds double, ptr %1610, i64 %1677
  %1687 = load double, ptr %1686, align 8
  %1688 = tail call double @llvm.fabs.f64(double %1687)
  %1689 = getelementptr double, ptr %1619, i64 %1677
  %1690 = load double, ptr %1689, align 8
  %1691 = tail call double @llvm.fabs.f64(double %1690)
  %1692 = fcmp ogt double %1688, %1691
  %1693 = select i1 %1692, double %1688, double %1691
  %1694 = getelementptr double, ptr %1621, i64 %1677
  %1695 = load double, ptr %1694, align 8
  %1696 = tail call double @llvm.fabs.f64(double %1695)
  %1697 = fcmp ogt double %1693, %1696
  %1698 = select i1 %1697, double %1693, double %1696
  %1699 = fcmp ogt double %1698, %1685
  %1700 = select i1 %1699, double %1698, double %1685
  %1701 = fmul double %1700, 8.000000e+00
  %1702 = getelementptr inbounds double, ptr %1609, i64 %1677
  store double %1701, ptr %1702, align 8
  %1703 = add nuw nsw i64 %1677, 1
  %1704 = load i64, ptr %1615, align 8
  %1705 = icmp slt i64 %1703, %1704
  br i1 %1705, label %1676, label %1622, !llvm.loop !46

1706:                                             ; preds = %1673, %1622, %1601
  %1707 = phi i32 [ 0, %1601 ], [ 0, %1622 ], [ %1675, %1673 ]
  %1708 = icmp eq i32 %1707, 0
  br label %1709

1709:                                             ; preds = %1706, %1600
  %1710 = phi i1 [ false, %1600 ], [ %1708, %1706 ]
  br i1 %1710, label %1716, label %1711

1711:                                             ; preds = %1709
  %1712 = load i64, ptr %395, align 8
  %1713 = getelementptr inbounds double, ptr %206, i64 %1712
  %1714 = load double, ptr %1713, align 8
  %1715 = fcmp ugt double %1714, %490
  br i1 %1715, label %1928, label %1716

1716:                                             ; preds = %1711, %1709
  %1717 = load ptr, ptr %79, align 8
  br i1 %1710, label %1718, label %1729

1718:                                             ; preds = %1716
  %1719 = load ptr, ptr %85, align 8
  %1720 = getelementptr inbounds i8, ptr %1719, i64 16
  %1721 = load i64, ptr %1720, align 8
  %1722 = inttoptr i64 %1721 to ptr
  %1723 = tail call i64 %1722(ptr noundef %0, double noundef %416, double noundef %491) #11
  %1724 = icmp eq i64 %1723, -6
  br i1 %1724, label %1725, label %1726

1725:                                             ; preds = %1718
  store double %416, ptr %1717, align 8
  br label %1904

1726:                                             ; preds = %1718
  %1727 = getelementptr inbounds i8, ptr %1717, i64 48
  %1728 = load double, ptr %1727, align 8
  br label %1729

1729:                                             ; preds = %1726, %1716
  %1730 = phi double [ %1728, %1726 ], [ 1.000000e+00, %1716 ]
  %1731 = phi i64 [ %1723, %1726 ], [ 0, %1716 ]
  %1732 = fcmp oeq double %1730, 1.000000e+00
  br i1 %1732, label %1733, label %1735

1733:                                             ; preds = %1729
  %1734 = load double, ptr %1717, align 8
  br label %1738

1735:                                             ; preds = %1729
  %1736 = fmul double %491, %1730
  %1737 = fadd double %416, %1736
  br label %1738

1738:                                             ; preds = %1735, %1733
  %1739 = phi double [ %1734, %1733 ], [ %1737, %1735 ]
  %1740 = icmp eq i64 %1731, -4
  %1741 = select i1 %1740, i64 -4, i64 0
  br i1 %1740, label %1799, label %1742

1742:                                             ; preds = %1738
  %1743 = fcmp olt double %1730, 1.000000e+00
  %1744 = load ptr, ptr %76, align 8
  %1745 = getelementptr inbounds i8, ptr %1744, i64 8
  %1746 = load i64, ptr %1745, align 8
  %1747 = load i64, ptr %83, align 8
  %1748 = load ptr, ptr %82, align 8
  %1749 = load ptr, ptr %81, align 8
  %1750 = getelementptr inbounds i8, ptr %1749, i64 48
  %1751 = load i64, ptr %1750, align 8
  %1752 = icmp slt i64 %1751, %1747
  br i1 %1752, label %1753, label %1795

1753:                                             ; preds = %1742, %1791
  %1754 = phi i64 [ %1792, %1791 ], [ undef, %1742 ]
  %1755 = phi i64 [ %1793, %1791 ], [ %1751, %1742 ]
  %1756 = getelementptr inbounds double, ptr %1748, i64 %1755
  %1757 = load double, ptr %1756, align 8
  %1758 = fcmp olt double %1757, %1739
  %1759 = fcmp oeq double %1757, %1739
  %1760 = and i1 %1743, %1759
  %1761 = or i1 %1758, %1760
  br i1 %1761, label %1762, label %1795

1762:                                             ; preds = %1753
  %1763 = fsub double %1757, %416
  %1764 = fdiv double %1763, %491
  %1765 = mul nsw i64 %1755, %1746
  %1766 = getelementptr inbounds double, ptr %1, i64 %1765
  %1767 = load ptr, ptr %174, align 8
  %1768 = insertelement <8 x double> poison, double %1764, i64 0
  %1769 = shufflevector <8 x double> %1768, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1769, ptr %1767, align 8
  %1770 = load ptr, ptr %77, align 8
  %1771 = load ptr, ptr %175, align 8
  %1772 = load i64, ptr %176, align 8
  %1773 = load ptr, ptr %0, align 8
  %1774 = getelementptr inbounds i8, ptr %1773, i64 24
  %1775 = load i64, ptr %1774, align 8
  %1776 = load ptr, ptr %174, align 8
  %1777 = load ptr, ptr %76, align 8
  %1778 = getelementptr inbounds i8, ptr %1777, i64 16
  %1779 = load i64, ptr %1778, align 8
  tail call fastcc void @nested(ptr noundef %1766, ptr noundef %1770, ptr noundef %1771, i64 noundef %1772, i64 noundef %1775, ptr noundef %1776, i64 noundef %1779) #10
  %1780 = load ptr, ptr %84, align 8
  %1781 = load i64, ptr %1780, align 8
  %1782 = icmp eq i64 %1781, 1
  br i1 %1782, label %1783, label %1791

1783:                                             ; preds = %1762
  %1784 = load double, ptr %1756, align 8
  %1785 = getelementptr inbounds i8, ptr %1780, i64 56
  %1786 = load i64, ptr %1785, align 8
  %1787 = inttoptr i64 %1786 to ptr
  %1788 = tail call i64 %1787(ptr noundef %0, double noundef %1784, ptr noundef %1766, ptr noundef null) #11
  %1789 = icmp eq i64 %1788, 0
  %1790 = select i1 %1789, i64 %1754, i64 %1788
  br i1 %1789, label %1791, label %1799

1791:                                             ; preds = %1783, %1762
  %1792 = phi i64 [ %1790, %1783 ], [ %1754, %1762 ]
  %1793 = add i64 %1755, 1
  %1794 = icmp eq i64 %1793, %1747
  br i1 %1794, label %1795, label %1753, !llvm.loop !47

1795:                                             ; preds = %1791, %1753, %1742
  %1796 = phi i64 [ %1751, %1742 ], [ %1747, %1791 ], [ %1755, %1753 ]
  %1797 = load ptr, ptr %81, align 8
  %1798 = getelementptr inbounds i8, ptr %1797, i64 48
  store i64 %1796, ptr %1798, align 8
  br label %1799

1799:                                             ; preds = %1783, %1795, %1738
  %1800 = phi i64 [ %1741, %1738 ], [ 0, %1795 ], [ %1790, %1783 ]
  %1801 = icmp eq i64 %1800, 0
  %1802 = icmp ne i64 %1731, 0
  %1803 = fcmp olt double %1730, 1.000000e+00
  %1804 = and i1 %1803, %1801
  %1805 = and i1 %1802, %1804
  br i1 %1805, label %1806, label %1843

1806:                                             ; preds = %1799
  %1807 = load ptr, ptr %177, align 8
  %1808 = load ptr, ptr %178, align 8
  %1809 = insertelement <8 x double> poison, double %1730, i64 0
  %1810 = shufflevector <8 x double> %1809, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1810, ptr %1808, align 8
  %1811 = load ptr, ptr %77, align 8
  %1812 = load ptr, ptr %179, align 8
  %1813 = load i64, ptr %180, align 8
  %1814 = load ptr, ptr %0, align 8
  %1815 = getelementptr inbounds i8, ptr %1814, i64 24
  %1816 = load i64, ptr %1815, align 8
  %1817 = load ptr, ptr %178, align 8
  %1818 = load ptr, ptr %76, align 8
  %1819 = getelementptr inbounds i8, ptr %1818, i64 16
  %1820 = load i64, ptr %1819, align 8
  tail call fastcc void @nested(ptr noundef %1807, ptr noundef %1811, ptr noundef %1812, i64 noundef %1813, i64 noundef %1816, ptr noundef %1817, i64 noundef %1820) #10
  %1821 = load i64, ptr %160, align 8
  %1822 = icmp sgt i64 %1821, 0
  br i1 %1822, label %1827, label %1823

1823:                                             ; preds = %1827, %1806
  %1824 = load ptr, ptr %84, align 8
  %1825 = load i64, ptr %1824, align 8
  %1826 = icmp eq i64 %1825, 1
  br i1 %1826, label %1837, label %1843

1827:                                             ; preds = %1806, %1827
  %1828 = phi i64 [ %1834, %1827 ], [ 0, %1806 ]
  %1829 = load ptr, ptr %177, align 8
  %1830 = getelementptr inbounds double, ptr %1829, i64 %1828
  %1831 = load double, ptr %1830, align 8
  %1832 = load ptr, ptr %153, align 8
  %1833 = getelementptr inbounds double, ptr %1832, i64 %1828
  store double %1831, ptr %1833, align 8
  %1834 = add nuw nsw i64 %1828, 1
  %1835 = load i64, ptr %160, align 8
  %1836 = icmp slt i64 %1834, %1835
  br i1 %1836, label %1827, label %1823, !llvm.loop !48

1837:                                             ; preds = %1823
  %1838 = load ptr, ptr %153, align 8
  %1839 = getelementptr inbounds i8, ptr %1824, i64 56
  %1840 = load i64, ptr %1839, align 8
  %1841 = inttoptr i64 %1840 to ptr
  %1842 = tail call i64 %1841(ptr noundef %0, double noundef %1739, ptr noundef %1838, ptr noundef null) #11
  br label %1843

1843:                                             ; preds = %1837, %1823, %1799
  %1844 = phi i64 [ %1842, %1837 ], [ 0, %1823 ], [ %1800, %1799 ]
  %1845 = icmp eq i64 %1844, 0
  br i1 %1845, label %1848, label %1846

1846:                                             ; preds = %1843
  store double %416, ptr %1717, align 8
  %1847 = getelementptr inbounds i8, ptr %1717, i64 8
  store double %491, ptr %1847, align 8
  br label %1904

1848:                                             ; preds = %1843
  br i1 %1732, label %1849, label %1887

1849:                                             ; preds = %1848
  %1850 = load ptr, ptr %153, align 8
  %1851 = load ptr, ptr %76, align 8
  %1852 = getelementptr inbounds i8, ptr %1851, i64 8
  %1853 = load i64, ptr %1852, align 8
  %1854 = load i64, ptr %83, align 8
  %1855 = load ptr, ptr %82, align 8
  %1856 = load ptr, ptr %81, align 8
  %1857 = getelementptr inbounds i8, ptr %1856, i64 48
  %1858 = load i64, ptr %1857, align 8
  %1859 = icmp slt i64 %1858, %1854
  br i1 %1859, label %1860, label %1883

1860:                                             ; preds = %1849
  %1861 = icmp sgt i64 %1853, 0
  br label %1862

1862:                                             ; preds = %1860, %1873
  %1863 = phi i64 [ %1858, %1860 ], [ %1874, %1873 ]
  %1864 = getelementptr inbounds double, ptr %1855, i64 %1863
  %1865 = load double, ptr %1864, align 8
  %1866 = load ptr, ptr %79, align 8
  %1867 = load double, ptr %1866, align 8
  %1868 = fcmp ugt double %1865, %1867
  br i1 %1868, label %1883, label %1869

1869:                                             ; preds = %1862
  br i1 %1861, label %1870, label %1873

1870:                                             ; preds = %1869
  %1871 = mul nsw i64 %1863, %1853
  %1872 = getelementptr double, ptr %1, i64 %1871
  br label %1876

1873:                                             ; preds = %1876, %1869
  %1874 = add i64 %1863, 1
  %1875 = icmp eq i64 %1874, %1854
  br i1 %1875, label %1883, label %1862, !llvm.loop !10

1876:                                             ; preds = %1870, %1876
  %1877 = phi i64 [ 0, %1870 ], [ %1881, %1876 ]
  %1878 = getelementptr inbounds double, ptr %1850, i64 %1877
  %1879 = load double, ptr %1878, align 8
  %1880 = getelementptr double, ptr %1872, i64 %1877
  store double %1879, ptr %1880, align 8
  %1881 = add nuw nsw i64 %1877, 1
  %1882 = icmp eq i64 %1881, %1853
  br i1 %1882, label %1873, label %1876, !llvm.loop !11

1883:                                             ; preds = %1873, %1862, %1849
  %1884 = phi i64 [ %1858, %1849 ], [ %1854, %1873 ], [ %1863, %1862 ]
  %1885 = load ptr, ptr %81, align 8
  %1886 = getelementptr inbounds i8, ptr %1885, i64 48
  store i64 %1884, ptr %1886, align 8
  br label %1887

1887:                                             ; preds = %1883, %1848
  br i1 %1802, label %1888, label %1904

1888:                                             ; preds = %1887
  %1889 = load i64, ptr %160, align 8
  %1890 = icmp sgt i64 %1889, 0
  br i1 %1890, label %1894, label %1891

1891:                                             ; preds = %1894, %1888
  store double %1739, ptr %1717, align 8
  %1892 = getelementptr inbounds i8, ptr %1717, i64 8
  store double 0.000000e+00, ptr %1892, align 8
  %1893 = load ptr, ptr %81, align 8
  store i64 0, ptr %1893, align 8
  br label %1904

1894:                                             ; preds = %1888, %1894
  %1895 = phi i64 [ %1901, %1894 ], [ 0, %1888 ]
  %1896 = load ptr, ptr %153, align 8
  %1897 = getelementptr inbounds double, ptr %1896, i64 %1895
  %1898 = load double, ptr %1897, align 8
  %1899 = load ptr, ptr %77, align 8
  %1900 = getelementptr inbounds double, ptr %1899, i64 %1895
  store double %1898, ptr %1900, align 8
  %1901 = add nuw nsw i64 %1895, 1
  %1902 = load i64, ptr %160, align 8
  %1903 = icmp slt i64 %1901, %1902
  br i1 %1903, label %1894, label %1891, !llvm.loop !49

1904:                                             ; preds = %1725, %1846, %1887, %1891
  %1905 = phi i64 [ -6, %1725 ], [ %1844, %1846 ], [ %1731, %1891 ], [ %1731, %1887 ]
  %1906 = icmp eq i64 %1905, -6
  br i1 %1906, label %1910, label %1907

1907:                                             ; preds = %1904
  %1908 = icmp ne i64 %1905, 6
  %1909 = select i1 %1908, i1 true, i1 %217
  br i1 %1909, label %1922, label %1910

1910:                                             ; preds = %1907, %1904
  %1911 = phi i64 [ %1905, %1907 ], [ 2, %1904 ]
  %1912 = load i64, ptr %373, align 8
  %1913 = add nsw i64 %1912, -1
  store i64 %1913, ptr %373, align 8
  %1914 = load ptr, ptr %96, align 8
  %1915 = load i64, ptr %1914, align 8
  %1916 = add nsw i64 %1915, -1
  store i64 %1916, ptr %1914, align 8
  store i64 1, ptr %387, align 8
  %1917 = load i64, ptr %401, align 8
  %1918 = sub nsw i64 1, %1917
  store i64 %1918, ptr %377, align 8
  store double 0.000000e+00, ptr %382, align 8
  %1919 = load i64, ptr %374, align 8
  %1920 = add nsw i64 %1919, 1
  store i64 %1920, ptr %374, align 8
  store i64 %1911, ptr %402, align 8
  %1921 = fmul double %491, 2.500000e-01
  br label %1990, !llvm.loop !18

1922:                                             ; preds = %1907
  %1923 = icmp eq i64 %1905, 0
  br i1 %1923, label %1928, label %1924

1924:                                             ; preds = %1922
  %1925 = load ptr, ptr %96, align 8
  %1926 = load i64, ptr %1925, align 8
  %1927 = add nsw i64 %1926, 1
  store i64 %1927, ptr %1925, align 8
  br label %1990

1928:                                             ; preds = %1922, %1711
  br i1 %396, label %1953, label %1929

1929:                                             ; preds = %1953, %1928
  %1930 = load i64, ptr %98, align 8
  %1931 = icmp sgt i64 %1930, 0
  br i1 %1931, label %1932, label %1934

1932:                                             ; preds = %1929
  %1933 = load ptr, ptr %181, align 8
  store double 0x7FF0000000000000, ptr %1933, align 8
  br label %1934

1934:                                             ; preds = %1929, %1932
  %1935 = load i64, ptr %397, align 8
  %1936 = add nsw i64 %1935, 1
  store i64 %1936, ptr %397, align 8
  %1937 = load ptr, ptr %77, align 8
  %1938 = load ptr, ptr %182, align 8
  %1939 = load ptr, ptr %183, align 8
  store double %490, ptr %1939, align 8
  %1940 = load i64, ptr %184, align 8
  %1941 = icmp sgt i64 %1940, 0
  br i1 %1941, label %1942, label %1943

1942:                                             ; preds = %1934
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1943

1943:                                             ; preds = %1934, %1942
  %1944 = load ptr, ptr %76, align 8
  %1945 = load i64, ptr %1944, align 8
  %1946 = load ptr, ptr %183, align 8
  %1947 = load ptr, ptr %185, align 8
  %1948 = load ptr, ptr %186, align 8
  %1949 = inttoptr i64 %1945 to ptr
  %1950 = load ptr, ptr %1949, align 8
  %1951 = tail call i32 %1950(ptr noundef %1946, ptr noundef %1937, ptr noundef %1947, ptr noundef %1948, ptr noundef %1938) #11
  %1952 = icmp eq i32 %1951, 0
  br i1 %1952, label %1965, label %1962

1953:                                             ; preds = %1928, %1953
  %1954 = phi i64 [ %1960, %1953 ], [ 0, %1928 ]
  %1955 = load ptr, ptr %153, align 8
  %1956 = getelementptr inbounds double, ptr %1955, i64 %1954
  %1957 = load double, ptr %1956, align 8
  %1958 = load ptr, ptr %77, align 8
  %1959 = getelementptr inbounds double, ptr %1958, i64 %1954
  store double %1957, ptr %1959, align 8
  %1960 = add nuw nsw i64 %1954, 1
  %1961 = icmp eq i64 %1960, %205
  br i1 %1961, label %1929, label %1953, !llvm.loop !50

1962:                                             ; preds = %1943
  store i64 3, ptr %398, align 8
  store double %491, ptr %232, align 8
  %1963 = icmp slt i32 %1951, 0
  %1964 = select i1 %1963, i64 -4, i64 2
  br label %1990

1965:                                             ; preds = %1943
  %1966 = icmp sgt i64 %1232, 2
  %1967 = fcmp ogt double %1230, 1.000000e-03
  %1968 = select i1 %1966, i1 %1967, i1 false
  %1969 = zext i1 %1968 to i64
  store i64 %1969, ptr %377, align 8
  store i64 0, ptr %399, align 8
  store i64 0, ptr %387, align 8
  %1970 = fcmp ule double %1471, 1.000000e+00
  %1971 = fcmp uge double %1471, 1.200000e+00
  %1972 = or i1 %1970, %1971
  %1973 = select i1 %1972, i1 true, i1 %1968
  br i1 %1973, label %1976, label %1974

1974:                                             ; preds = %1965
  %1975 = load double, ptr %196, align 8
  br label %1980

1976:                                             ; preds = %1965
  %1977 = fcmp ogt double %1471, 2.000000e-01
  %1978 = select i1 %1977, double %1471, double 2.000000e-01
  %1979 = fmul double %491, %1978
  br label %1980

1980:                                             ; preds = %1976, %1974
  %1981 = phi double [ %1975, %1974 ], [ %1979, %1976 ]
  %1982 = fcmp oeq double %490, %480
  %1983 = fcmp ogt double %417, %1981
  %1984 = select i1 %1982, i1 %1983, i1 false
  %1985 = select i1 %1984, double %417, double %1981
  %1986 = load i64, ptr %400, align 8
  %1987 = load i64, ptr %83, align 8
  %1988 = icmp eq i64 %1986, %1987
  br i1 %1988, label %1989, label %1990

1989:                                             ; preds = %1980
  store double %1985, ptr %232, align 8
  br label %1990

1990:                                             ; preds = %1229, %1272, %1284, %1989, %1980, %1962, %1924, %1910, %1439, %1424, %1386, %687, %618, %497
  %1991 = phi double [ %421, %497 ], [ %421, %618 ], [ %421, %687 ], [ %1230, %1386 ], [ %1230, %1424 ], [ %1230, %1439 ], [ %1230, %1910 ], [ %1230, %1924 ], [ %1230, %1962 ], [ %1230, %1980 ], [ %1230, %1989 ], [ %1230, %1284 ], [ %1230, %1272 ], [ %1230, %1229 ]
  %1992 = phi i32 [ %420, %497 ], [ %420, %618 ], [ %420, %687 ], [ %1231, %1386 ], [ %1231, %1424 ], [ %1231, %1439 ], [ %1231, %1910 ], [ %1231, %1924 ], [ %1231, %1962 ], [ %1231, %1980 ], [ %1231, %1989 ], [ %1231, %1284 ], [ %1231, %1272 ], [ %1231, %1229 ]
  %1993 = phi i64 [ %419, %497 ], [ %419, %618 ], [ %419, %687 ], [ %1232, %1386 ], [ %1232, %1424 ], [ %1232, %1439 ], [ %1232, %1910 ], [ %1232, %1924 ], [ %1232, %1962 ], [ %1232, %1980 ], [ %1232, %1989 ], [ %1232, %1284 ], [ %1232, %1272 ], [ %1232, %1229 ]
  %1994 = phi i64 [ %418, %497 ], [ %418, %618 ], [ %418, %687 ], [ %1233, %1386 ], [ %1233, %1424 ], [ %1233, %1439 ], [ %1233, %1910 ], [ %1233, %1924 ], [ %1233, %1962 ], [ %1233, %1980 ], [ %1233, %1989 ], [ %1233, %1284 ], [ %1233, %1272 ], [ %1233, %1229 ]
  %1995 = phi double [ %417, %497 ], [ %417, %618 ], [ %690, %687 ], [ %417, %1386 ], [ %1426, %1424 ], [ %1442, %1439 ], [ %1921, %1910 ], [ %417, %1924 ], [ %417, %1962 ], [ %1985, %1980 ], [ %1985, %1989 ], [ %1285, %1284 ], [ %417, %1272 ], [ %417, %1229 ]
  %1996 = phi double [ %416, %497 ], [ %416, %618 ], [ %416, %687 ], [ %416, %1386 ], [ %416, %1424 ], [ %416, %1439 ], [ %416, %1910 ], [ %416, %1924 ], [ %490, %1962 ], [ %490, %1980 ], [ %490, %1989 ], [ %416, %1284 ], [ %416, %1272 ], [ %416, %1229 ]
  %1997 = phi i32 [ 1, %497 ], [ 1, %618 ], [ 6, %687 ], [ 1, %1386 ], [ 6, %1424 ], [ 6, %1439 ], [ 6, %1910 ], [ 1, %1924 ], [ 1, %1962 ], [ 0, %1980 ], [ 1, %1989 ], [ 6, %1284 ], [ 6, %1272 ], [ 1, %1229 ]
  %1998 = phi i64 [ 2, %497 ], [ -4, %618 ], [ %415, %687 ], [ -4, %1386 ], [ %415, %1424 ], [ %415, %1439 ], [ %415, %1910 ], [ %1905, %1924 ], [ %1964, %1962 ], [ %415, %1980 ], [ 0, %1989 ], [ %415, %1284 ], [ %415, %1272 ], [ -4, %1229 ]
  switch i32 %1997, label %2002 [
    i32 0, label %1999
    i32 6, label %1999
  ]

1999:                                             ; preds = %1990, %1990
  %2000 = load i64, ptr %199, align 8
  %2001 = icmp eq i64 %2000, 0
  br i1 %2001, label %407, label %413, !llvm.loop !18

2002:                                             ; preds = %1990, %190, %295, %337, %407, %434, %442
  %2003 = phi double [ %191, %190 ], [ %408, %407 ], [ %421, %442 ], [ %421, %434 ], [ %191, %337 ], [ %191, %295 ], [ %1991, %1990 ]
  %2004 = phi i32 [ %192, %190 ], [ %409, %407 ], [ %420, %442 ], [ %420, %434 ], [ %192, %337 ], [ %192, %295 ], [ %1992, %1990 ]
  %2005 = phi i64 [ %193, %190 ], [ %410, %407 ], [ %419, %442 ], [ %419, %434 ], [ %193, %337 ], [ %193, %295 ], [ %1993, %1990 ]
  %2006 = phi i64 [ %194, %190 ], [ %411, %407 ], [ %418, %442 ], [ %418, %434 ], [ %194, %337 ], [ %194, %295 ], [ %1994, %1990 ]
  %2007 = phi i64 [ -1, %190 ], [ -1, %407 ], [ 1, %442 ], [ -5, %434 ], [ 0, %337 ], [ %298, %295 ], [ %1998, %1990 ]
  %2008 = load ptr, ptr %189, align 8
  %2009 = getelementptr inbounds i8, ptr %2008, i64 48
  %2010 = load i64, ptr %2009, align 8
  %2011 = icmp ne i64 %2007, -2
  %2012 = icmp eq i64 %2010, 0
  %2013 = select i1 %2011, i1 true, i1 %2012
  br i1 %2013, label %2021, label %2014

2014:                                             ; preds = %2002
  %2015 = inttoptr i64 %2010 to ptr
  %2016 = tail call i64 %2015(ptr noundef %0) #11
  %2017 = icmp eq i64 %2016, 8
  %2018 = select i1 %2017, i64 8, i64 %2007
  %2019 = icmp eq i64 %2016, 1
  %2020 = zext i1 %2019 to i32
  br label %2021

2021:                                             ; preds = %2002, %2014
  %2022 = phi i64 [ %2007, %2002 ], [ %2018, %2014 ]
  %2023 = phi i32 [ 0, %2002 ], [ %2020, %2014 ]
  %2024 = icmp eq i32 %2023, 0
  br i1 %2024, label %2025, label %190, !llvm.loop !51

2025:                                             ; preds = %2021
  %2026 = getelementptr inbounds i8, ptr %0, i64 320
  %2027 = load i64, ptr %2026, align 8
  %2028 = icmp sgt i64 %2027, 0
  br i1 %2028, label %2029, label %2032

2029:                                             ; preds = %2025
  %2030 = getelementptr inbounds i8, ptr %0, i64 336
  %2031 = load ptr, ptr %2030, align 8
  store double 0x7FF0000000000000, ptr %2031, align 8
  br label %2032

2032:                                             ; preds = %2025, %2029
  ret i64 %2022
}



declare double @llvm.sqrt.f64(double) #2

declare double @llvm.fabs.f64(double) #2

declare double @llvm.pow.f64(double, double) #2

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 192
  %10 = getelementptr inbounds i8, ptr %0, i64 120
  %11 = getelementptr inbounds i8, ptr %0, i64 144
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  br label %14

13:                                               ; preds = %61, %1
  ret void

14:                                               ; preds = %5, %61
  %15 = phi i64 [ 0, %5 ], [ %86, %61 ]
  %16 = load ptr, ptr %6, align 8
  %17 = load i64, ptr %7, align 8
  %18 = mul nsw i64 %17, %15
  %19 = getelementptr inbounds i64, ptr %16, i64 %18
  %20 = getelementptr inbounds i8, ptr %19, i64 24
  %21 = load ptr, ptr %8, align 8
  %22 = load double, ptr %21, align 8
  %23 = load ptr, ptr %9, align 8
  %24 = load double, ptr %23, align 8
  %25 = fcmp olt double %22, %24
  %26 = select i1 %25, double %22, double %24
  %27 = getelementptr inbounds i8, ptr %19, i64 8
  %28 = load i64, ptr %27, align 8
  %29 = load ptr, ptr %10, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %28
  %31 = load double, ptr %30, align 8
  %32 = fcmp ogt double %31, %26
  %33 = select i1 %32, double %31, double %26
  %34 = getelementptr inbounds i8, ptr %19, i64 16
  %35 = load i64, ptr %34, align 8
  %36 = load i64, ptr %20, align 8
  %37 = getelementptr inbounds double, ptr %30, i64 %36
  %38 = load double, ptr %37, align 8
  %39 = fcmp ugt double %38, %33
  br i1 %39, label %47, label %40

40:                                               ; preds = %14
  %41 = add nsw i64 %35, -1
  %42 = icmp eq i64 %41, %36
  br i1 %42, label %61, label %43

43:                                               ; preds = %40
  %44 = getelementptr i8, ptr %37, i64 8
  %45 = load double, ptr %44, align 8
  %46 = fcmp ogt double %45, %33
  br i1 %46, label %61, label %47

47:                                               ; preds = %43, %14
  %48 = icmp sgt i64 %35, 1
  br i1 %48, label %49, label %61

49:                                               ; preds = %47, %49
  %50 = phi i64 [ %58, %49 ], [ %35, %47 ]
  %51 = phi i64 [ %57, %49 ], [ 0, %47 ]
  %52 = add nsw i64 %50, %51
  %53 = sdiv i64 %52, 2
  %54 = getelementptr inbounds double, ptr %30, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = fcmp ugt double %55, %33
  %57 = select i1 %56, i64 %51, i64 %53
  %58 = select i1 %56, i64 %53, i64 %50
  %59 = sub nsw i64 %58, %57
  %60 = icmp sgt i64 %59, 1
  br i1 %60, label %49, label %61, !llvm.loop !52

61:                                               ; preds = %49, %47, %40, %43
  %62 = phi i64 [ %36, %43 ], [ %36, %40 ], [ 0, %47 ], [ %57, %49 ]
  store i64 %62, ptr %20, align 8
  %63 = getelementptr inbounds double, ptr %30, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fsub double %33, %64
  %66 = load ptr, ptr %11, align 8
  %67 = add nsw i64 %62, %28
  %68 = shl nsw i64 %67, 5
  %69 = getelementptr inbounds i8, ptr %66, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %69, i64 8
  %72 = load double, ptr %71, align 8
  %73 = getelementptr inbounds i8, ptr %69, i64 16
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %69, i64 24
  %76 = load double, ptr %75, align 8
  %77 = fmul double %65, %76
  %78 = fadd double %74, %77
  %79 = fmul double %65, %78
  %80 = fadd double %72, %79
  %81 = fmul double %65, %80
  %82 = fadd double %70, %81
  %83 = load ptr, ptr %12, align 8
  %84 = load i64, ptr %19, align 8
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  store double %82, ptr %85, align 8
  %86 = add nuw nsw i64 %15, 1
  %87 = load i64, ptr %2, align 8
  %88 = icmp slt i64 %86, %87
  br i1 %88, label %14, label %13, !llvm.loop !53
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
  br i1 %41, label %13, label %18, !llvm.loop !54
}

define internal fastcc i32 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp slt i64 %1, 1
  br i1 %4, label %76, label %8

5:                                                ; preds = %73, %50
  %6 = icmp sge i64 %16, %1
  %7 = icmp eq i64 %16, %1
  br i1 %7, label %76, label %8, !llvm.loop !55

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
  br i1 %36, label %24, label %19, !llvm.loop !56

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
  br i1 %49, label %50, label %42, !llvm.loop !57

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
  br i1 %72, label %63, label %73, !llvm.loop !58

73:                                               ; preds = %63, %54
  %74 = add nuw nsw i64 %55, 1
  %75 = icmp slt i64 %74, %1
  br i1 %75, label %54, label %5, !llvm.loop !59

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
  br i1 %7, label %127, label %8, !llvm.loop !60

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
  br i1 %40, label %26, label %21, !llvm.loop !61

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
  br i1 %57, label %58, label %46, !llvm.loop !62

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
  br i1 %123, label %104, label %124, !llvm.loop !63

124:                                              ; preds = %104, %86
  %125 = add nuw nsw i64 %87, 1
  %126 = icmp slt i64 %125, %1
  br i1 %126, label %86, label %5, !llvm.loop !64

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
  br i1 %19, label %6, label %8, !llvm.loop !65

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
  br i1 %35, label %20, label %24, !llvm.loop !66

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
  br i1 %46, label %32, label %36, !llvm.loop !67

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
  br i1 %63, label %48, label %47, !llvm.loop !68

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
  br i1 %74, label %57, label %64, !llvm.loop !69
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
  br i1 %24, label %6, label %8, !llvm.loop !70

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
  br i1 %43, label %25, label %29, !llvm.loop !71

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
  br i1 %65, label %39, label %44, !llvm.loop !72

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
  br i1 %112, label %67, label %66, !llvm.loop !73

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
  br i1 %134, label %78, label %113, !llvm.loop !74
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
  br i1 %37, label %38, label %23, !llvm.loop !75

38:                                               ; preds = %23, %14
  %39 = add nuw nsw i64 %15, 1
  %40 = icmp eq i64 %39, %1
  br i1 %40, label %10, label %14, !llvm.loop !76

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
  br i1 %57, label %49, label %41, !llvm.loop !77

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
  br i1 %73, label %74, label %64, !llvm.loop !78

74:                                               ; preds = %64, %58
  %75 = add nuw nsw i64 %59, 1
  %76 = icmp eq i64 %75, %42
  br i1 %76, label %55, label %58, !llvm.loop !79

77:                                               ; preds = %116, %89
  %78 = icmp sgt i64 %80, 1
  br i1 %78, label %79, label %88, !llvm.loop !80

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
  br i1 %112, label %113, label %103, !llvm.loop !78

113:                                              ; preds = %103, %97
  %114 = add nuw nsw i64 %98, 1
  %115 = icmp eq i64 %114, %1
  br i1 %115, label %89, label %97, !llvm.loop !81

116:                                              ; preds = %94, %116
  %117 = phi i64 [ 0, %94 ], [ %121, %116 ]
  %118 = getelementptr double, ptr %96, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fmul double %93, %119
  store double %120, ptr %118, align 8
  %121 = add nuw nsw i64 %117, 1
  %122 = icmp eq i64 %121, %4
  br i1 %122, label %77, label %116, !llvm.loop !82
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
  br i1 %42, label %43, label %23, !llvm.loop !83

43:                                               ; preds = %23, %14
  %44 = add nuw nsw i64 %15, 1
  %45 = icmp eq i64 %44, %1
  br i1 %45, label %10, label %14, !llvm.loop !84

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
  br i1 %62, label %54, label %46, !llvm.loop !85

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
  br i1 %90, label %91, label %71, !llvm.loop !86

91:                                               ; preds = %71, %63
  %92 = add nuw nsw i64 %64, 1
  %93 = icmp eq i64 %92, %47
  br i1 %93, label %60, label %63, !llvm.loop !87

94:                                               ; preds = %170, %133
  %95 = icmp sgt i64 %97, 1
  br i1 %95, label %96, label %105, !llvm.loop !88

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
  br i1 %166, label %167, label %147, !llvm.loop !86

167:                                              ; preds = %147, %139
  %168 = add nuw nsw i64 %140, 1
  %169 = icmp eq i64 %168, %1
  br i1 %169, label %106, label %139, !llvm.loop !89

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
  br i1 %183, label %94, label %170, !llvm.loop !90
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
  br i1 %31, label %20, label %19, !llvm.loop !91

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
  br i1 %43, label %32, label %24, !llvm.loop !92
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
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = !{!24}
!24 = distinct !{!24, !25, !"solve_stages: argument 0"}
!25 = distinct !{!25, !"solve_stages"}
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
!92 = distinct !{!92, !4, !5}
