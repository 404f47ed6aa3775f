; sources d07328dc3493161394a75329f5eac0fd3f1fcc41f52814ce3f4a51b22a99ac59
; Made by tools/solvers_ir.py with ziglang 0.14.1.

@NODES = internal unnamed_addr constant [3 x double] [double 0x3FC3D8B64657CAEA, double 0x3FE4A36C0803A6DF, double 1.000000e+00], align 16
@TO_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x4010B70201A79C46, double 0x3FD4F8C15DA84E86, double 0x3FE0BF7FF59D56EF], [3 x double] [double 0xC010B70201A79C46, double 0xBFD4F8C15DA84E86, double 0x3FDE810014C55221], [3 x double] [double 0x3FE017885A24A7F2, double 0xC004934E6FCAA598, double 0x3FE312C0CF7BDFD1]], align 16
@FROM_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x3FB82D23845D677B, double 0xBFC214A74C403BF7, double 0x3F9EBFF91A6D688E], [3 x double] [double 0x3FD0037DE70AA1ED, double 0x3FCA20E91E20B551, double 0xBFD8821FA2A36DED], [3 x double] [double 1.000000e+00, double 1.000000e+00, double 0.000000e+00]], align 16
@POLYNOMIAL = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x402418FD8BAFFE05, double 0xC039A12CE7B30915, double 0x402F295C43B61425], [3 x double] [double 0xBFF61D41B2D54580, double 0x402497AF24BB677E, double 0xC021D406EE60BECF], [3 x double] [double 0x3FD5555555555555, double 0xC005555555555555, double 0x400AAAAAAAAAAAAB]], align 16

define i64 @advance_implicit(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [8 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca [8 x double], align 16
  %8 = alloca [1 x double], align 8
  %9 = alloca [1 x double], align 8
  %10 = alloca [3 x double], align 16
  %11 = alloca [1 x double], align 8
  %12 = alloca [1 x double], align 8
  %13 = alloca [3 x double], align 16
  %14 = alloca [3 x double], align 16
  %15 = icmp eq i64 %2, 1
  br i1 %15, label %16, label %80

16:                                               ; preds = %3
  %17 = getelementptr inbounds i8, ptr %0, i64 144
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %18, i64 8
  %20 = load i64, ptr %19, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %24

22:                                               ; preds = %16
  %23 = getelementptr inbounds i8, ptr %0, i64 360
  br label %31

24:                                               ; preds = %31, %16
  %25 = getelementptr inbounds i8, ptr %0, i64 632
  %26 = load i64, ptr %25, align 8
  %27 = icmp sgt i64 %26, 0
  br i1 %27, label %28, label %42

28:                                               ; preds = %24
  %29 = getelementptr inbounds i8, ptr %0, i64 624
  %30 = getelementptr inbounds i8, ptr %0, i64 1272
  br label %49

31:                                               ; preds = %22, %31
  %32 = phi i64 [ 0, %22 ], [ %37, %31 ]
  %33 = getelementptr inbounds double, ptr %1, i64 %32
  %34 = load double, ptr %33, align 8
  %35 = load ptr, ptr %23, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %32
  store double %34, ptr %36, align 8
  %37 = add nuw nsw i64 %32, 1
  %38 = load ptr, ptr %17, align 8
  %39 = getelementptr inbounds i8, ptr %38, i64 8
  %40 = load i64, ptr %39, align 8
  %41 = icmp slt i64 %37, %40
  br i1 %41, label %31, label %24, !llvm.loop !3

42:                                               ; preds = %49, %24
  %43 = getelementptr inbounds i8, ptr %0, i64 656
  %44 = load i64, ptr %43, align 8
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %59

46:                                               ; preds = %42
  %47 = getelementptr inbounds i8, ptr %0, i64 648
  %48 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %65

49:                                               ; preds = %28, %49
  %50 = phi i64 [ 0, %28 ], [ %56, %49 ]
  %51 = load ptr, ptr %30, align 8
  %52 = getelementptr inbounds double, ptr %51, i64 %50
  %53 = load double, ptr %52, align 8
  %54 = load ptr, ptr %29, align 8
  %55 = getelementptr inbounds double, ptr %54, i64 %50
  store double %53, ptr %55, align 8
  %56 = add nuw nsw i64 %50, 1
  %57 = load i64, ptr %25, align 8
  %58 = icmp slt i64 %56, %57
  br i1 %58, label %49, label %42, !llvm.loop !6

59:                                               ; preds = %65, %42
  %60 = getelementptr inbounds i8, ptr %0, i64 768
  %61 = load ptr, ptr %60, align 8
  %62 = getelementptr inbounds i8, ptr %61, i64 8
  %63 = load i64, ptr %62, align 8
  %64 = icmp sgt i64 %63, 0
  br i1 %64, label %75, label %80

65:                                               ; preds = %46, %65
  %66 = phi i64 [ 0, %46 ], [ %72, %65 ]
  %67 = load ptr, ptr %48, align 8
  %68 = getelementptr inbounds i64, ptr %67, i64 %66
  %69 = load i64, ptr %68, align 8
  %70 = load ptr, ptr %47, align 8
  %71 = getelementptr inbounds i64, ptr %70, i64 %66
  store i64 %69, ptr %71, align 8
  %72 = add nuw nsw i64 %66, 1
  %73 = load i64, ptr %43, align 8
  %74 = icmp slt i64 %72, %73
  br i1 %74, label %65, label %59, !llvm.loop !7

75:                                               ; preds = %59
  %76 = getelementptr inbounds i8, ptr %0, i64 984
  %77 = load ptr, ptr %76, align 8
  %78 = mul i64 %63, 88
  %79 = getelementptr inbounds i8, ptr %77, i64 %78
  store double 0x7FF8000000000000, ptr %79, align 8
  br label %80

80:                                               ; preds = %75, %59, %3
  %81 = getelementptr inbounds i8, ptr %0, i64 144
  %82 = getelementptr inbounds i8, ptr %0, i64 360
  %83 = getelementptr inbounds i8, ptr %0, i64 1368
  %84 = getelementptr inbounds i8, ptr %0, i64 624
  %85 = getelementptr inbounds i8, ptr %0, i64 648
  %86 = getelementptr inbounds i8, ptr %0, i64 672
  %87 = getelementptr inbounds i8, ptr %0, i64 680
  %88 = getelementptr inbounds i8, ptr %0, i64 576
  %89 = getelementptr inbounds i8, ptr %0, i64 696
  %90 = getelementptr inbounds i8, ptr %0, i64 768
  %91 = getelementptr inbounds i8, ptr %0, i64 320
  %92 = getelementptr inbounds i8, ptr %0, i64 312
  %93 = getelementptr inbounds i8, ptr %0, i64 336
  %94 = getelementptr inbounds i8, ptr %0, i64 528
  %95 = getelementptr inbounds i8, ptr %0, i64 168
  %96 = getelementptr inbounds i8, ptr %0, i64 248
  %97 = getelementptr inbounds i8, ptr %0, i64 192
  %98 = getelementptr inbounds i8, ptr %0, i64 216
  %99 = getelementptr inbounds i8, ptr %0, i64 1392
  %100 = getelementptr inbounds i8, ptr %0, i64 528
  %101 = getelementptr inbounds i8, ptr %0, i64 1320
  %102 = getelementptr inbounds i8, ptr %0, i64 320
  %103 = getelementptr inbounds i8, ptr %0, i64 312
  %104 = getelementptr inbounds i8, ptr %0, i64 336
  %105 = getelementptr inbounds i8, ptr %0, i64 1440
  %106 = getelementptr inbounds i8, ptr %0, i64 1464
  %107 = getelementptr inbounds i8, ptr %0, i64 168
  %108 = getelementptr inbounds i8, ptr %0, i64 248
  %109 = getelementptr inbounds i8, ptr %0, i64 192
  %110 = getelementptr inbounds i8, ptr %0, i64 1416
  %111 = getelementptr inbounds i8, ptr %0, i64 408
  %112 = getelementptr inbounds i8, ptr %0, i64 408
  %113 = getelementptr inbounds i8, ptr %0, i64 384
  %114 = getelementptr inbounds i8, ptr %0, i64 168
  %115 = getelementptr inbounds i8, ptr %0, i64 248
  %116 = getelementptr inbounds i8, ptr %0, i64 192
  %117 = getelementptr inbounds i8, ptr %0, i64 216
  %118 = getelementptr inbounds i8, ptr %0, i64 528
  %119 = getelementptr inbounds i8, ptr %0, i64 1448
  %120 = getelementptr inbounds i8, ptr %0, i64 1392
  %121 = getelementptr inbounds i8, ptr %0, i64 1544
  %122 = getelementptr inbounds i8, ptr %0, i64 1488
  %123 = getelementptr inbounds i8, ptr %0, i64 1512
  %124 = getelementptr inbounds i8, ptr %0, i64 1440
  %125 = getelementptr inbounds i8, ptr %0, i64 1536
  %126 = getelementptr inbounds i8, ptr %0, i64 1560
  %127 = getelementptr inbounds i8, ptr %0, i64 1656
  %128 = getelementptr inbounds i8, ptr %0, i64 1584
  %129 = getelementptr inbounds i8, ptr %0, i64 1608
  %130 = getelementptr inbounds i8, ptr %0, i64 408
  %131 = getelementptr inbounds i8, ptr %0, i64 1632
  %132 = getelementptr inbounds i8, ptr %0, i64 408
  %133 = getelementptr inbounds i8, ptr %0, i64 168
  %134 = getelementptr inbounds i8, ptr %0, i64 248
  %135 = getelementptr inbounds i8, ptr %0, i64 192
  %136 = getelementptr inbounds i8, ptr %0, i64 216
  %137 = getelementptr inbounds i8, ptr %0, i64 1632
  %138 = getelementptr inbounds i8, ptr %0, i64 1680
  %139 = getelementptr inbounds i8, ptr %0, i64 1704
  %140 = getelementptr inbounds i8, ptr %0, i64 600
  %141 = getelementptr inbounds i8, ptr %0, i64 1536
  %142 = getelementptr inbounds i8, ptr %0, i64 1544
  %143 = getelementptr inbounds i8, ptr %0, i64 1680
  %144 = getelementptr inbounds i8, ptr %0, i64 1704
  %145 = getelementptr inbounds i8, ptr %0, i64 1488
  %146 = getelementptr inbounds i8, ptr %0, i64 1512
  %147 = getelementptr inbounds i8, ptr %0, i64 1560
  %148 = getelementptr inbounds i8, ptr %0, i64 600
  %149 = getelementptr inbounds i8, ptr %10, i64 8
  %150 = getelementptr inbounds i8, ptr %10, i64 16
  %151 = getelementptr inbounds i8, ptr %0, i64 1448
  %152 = getelementptr inbounds i8, ptr %0, i64 1440
  %153 = getelementptr inbounds i8, ptr %0, i64 384
  %154 = getelementptr inbounds i8, ptr %0, i64 1728
  %155 = getelementptr inbounds i8, ptr %0, i64 1680
  %156 = getelementptr inbounds i8, ptr %0, i64 528
  %157 = getelementptr inbounds i8, ptr %0, i64 1536
  %158 = getelementptr inbounds i8, ptr %0, i64 1544
  %159 = getelementptr inbounds i8, ptr %0, i64 1488
  %160 = getelementptr inbounds i8, ptr %0, i64 384
  %161 = getelementptr inbounds i8, ptr %0, i64 600
  %162 = getelementptr inbounds i8, ptr %0, i64 600
  %163 = getelementptr inbounds i8, ptr %0, i64 408
  %164 = getelementptr inbounds i8, ptr %0, i64 408
  %165 = getelementptr inbounds i8, ptr %0, i64 1632
  %166 = getelementptr inbounds i8, ptr %0, i64 168
  %167 = getelementptr inbounds i8, ptr %0, i64 248
  %168 = getelementptr inbounds i8, ptr %0, i64 192
  %169 = getelementptr inbounds i8, ptr %0, i64 216
  %170 = getelementptr inbounds i8, ptr %0, i64 600
  %171 = getelementptr inbounds i8, ptr %0, i64 600
  %172 = getelementptr inbounds i8, ptr %0, i64 384
  %173 = getelementptr inbounds i8, ptr %0, i64 1392
  %174 = getelementptr inbounds i8, ptr %0, i64 368
  %175 = getelementptr inbounds i8, ptr %0, i64 1584
  %176 = getelementptr inbounds i8, ptr %0, i64 552
  %177 = getelementptr inbounds i8, ptr %0, i64 1656
  %178 = getelementptr inbounds i8, ptr %0, i64 1392
  %179 = getelementptr inbounds i8, ptr %13, i64 8
  %180 = getelementptr inbounds i8, ptr %13, i64 16
  %181 = getelementptr inbounds i8, ptr %14, i64 8
  %182 = getelementptr inbounds i8, ptr %14, i64 16
  %183 = getelementptr inbounds i8, ptr %0, i64 384
  %184 = getelementptr inbounds i8, ptr %0, i64 1344
  %185 = getelementptr inbounds i8, ptr %0, i64 1360
  %186 = getelementptr inbounds i8, ptr %0, i64 384
  %187 = getelementptr inbounds i8, ptr %0, i64 552
  %188 = getelementptr inbounds i8, ptr %0, i64 368
  %189 = getelementptr inbounds i8, ptr %0, i64 888
  %190 = getelementptr inbounds i8, ptr %0, i64 1584
  %191 = getelementptr inbounds i8, ptr %0, i64 384
  %192 = getelementptr inbounds i8, ptr %0, i64 168
  %193 = getelementptr inbounds i8, ptr %0, i64 984
  %194 = getelementptr inbounds i8, ptr %0, i64 912
  %195 = getelementptr inbounds i8, ptr %0, i64 864
  %196 = getelementptr inbounds i8, ptr %0, i64 936
  %197 = getelementptr inbounds i8, ptr %0, i64 456
  %198 = getelementptr inbounds i8, ptr %0, i64 408
  %199 = getelementptr inbounds i8, ptr %0, i64 456
  %200 = getelementptr inbounds i8, ptr %0, i64 368
  %201 = getelementptr inbounds i8, ptr %0, i64 384
  %202 = getelementptr inbounds i8, ptr %0, i64 384
  %203 = getelementptr inbounds i8, ptr %0, i64 384
  %204 = getelementptr inbounds i8, ptr %0, i64 368
  %205 = getelementptr inbounds i8, ptr %0, i64 384
  %206 = getelementptr inbounds i8, ptr %0, i64 248
  %207 = getelementptr inbounds i8, ptr %0, i64 384
  %208 = getelementptr inbounds i8, ptr %0, i64 336
  %209 = getelementptr inbounds i8, ptr %0, i64 528
  %210 = getelementptr inbounds i8, ptr %0, i64 168
  %211 = getelementptr inbounds i8, ptr %0, i64 248
  %212 = getelementptr inbounds i8, ptr %0, i64 192
  %213 = getelementptr inbounds i8, ptr %0, i64 216
  %214 = getelementptr inbounds i8, ptr %0, i64 248
  %215 = getelementptr inbounds i8, ptr %0, i64 768
  br label %216

216:                                              ; preds = %2672, %80
  %217 = phi double [ undef, %80 ], [ %2652, %2672 ]
  %218 = phi double [ undef, %80 ], [ %2653, %2672 ]
  %219 = phi double [ undef, %80 ], [ %2654, %2672 ]
  %220 = phi i64 [ undef, %80 ], [ %2655, %2672 ]
  %221 = phi i64 [ undef, %80 ], [ %2656, %2672 ]
  %222 = phi i64 [ undef, %80 ], [ %2657, %2672 ]
  %223 = load ptr, ptr %84, align 8
  %224 = load ptr, ptr %85, align 8
  %225 = getelementptr inbounds i8, ptr %224, i64 56
  %226 = load i64, ptr %225, align 8
  %227 = icmp eq i64 %226, 0
  br i1 %227, label %2651, label %228

228:                                              ; preds = %216
  %229 = load ptr, ptr %81, align 8
  %230 = getelementptr inbounds i8, ptr %229, i64 8
  %231 = load i64, ptr %230, align 8
  %232 = load ptr, ptr %86, align 8
  %233 = load i64, ptr %87, align 8
  %234 = getelementptr double, ptr %232, i64 %233
  %235 = getelementptr i8, ptr %234, i64 -8
  %236 = load double, ptr %235, align 8
  %237 = load double, ptr %232, align 8
  %238 = fsub double %236, %237
  %239 = fmul double %238, 0x3D70000000000000
  %240 = load ptr, ptr %88, align 8, !noalias !8
  %241 = load double, ptr %240, align 8, !noalias !8
  %242 = icmp sgt i64 %231, 0
  br i1 %242, label %243, label %252

243:                                              ; preds = %228, %243
  %244 = phi i64 [ %250, %243 ], [ 0, %228 ]
  %245 = phi double [ %249, %243 ], [ %241, %228 ]
  %246 = getelementptr inbounds double, ptr %240, i64 %244
  %247 = load double, ptr %246, align 8, !noalias !8
  %248 = fcmp olt double %247, %245
  %249 = select i1 %248, double %247, double %245
  %250 = add nuw nsw i64 %244, 1
  %251 = icmp eq i64 %250, %231
  br i1 %251, label %252, label %243, !llvm.loop !11

252:                                              ; preds = %243, %228
  %253 = phi double [ %241, %228 ], [ %249, %243 ]
  %254 = load ptr, ptr %89, align 8
  %255 = load i64, ptr %254, align 8
  %256 = icmp eq i64 %255, 1
  %257 = load ptr, ptr %90, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 8
  %259 = load i64, ptr %258, align 8
  %260 = icmp sgt i64 %259, 0
  %261 = load double, ptr %223, align 8
  %262 = getelementptr inbounds i8, ptr %223, i64 8
  %263 = load double, ptr %262, align 8
  %264 = load i64, ptr %224, align 8
  %265 = icmp eq i64 %264, 0
  br i1 %265, label %266, label %417

266:                                              ; preds = %252
  %267 = load i64, ptr %91, align 8
  %268 = icmp eq i64 %267, 0
  br i1 %268, label %298, label %269

269:                                              ; preds = %266
  %270 = icmp sgt i64 %267, 0
  br i1 %270, label %271, label %286

271:                                              ; preds = %269
  %272 = load ptr, ptr %92, align 8
  br label %273

273:                                              ; preds = %271, %273
  %274 = phi i64 [ 0, %271 ], [ %284, %273 ]
  %275 = phi i64 [ %267, %271 ], [ %283, %273 ]
  %276 = add nuw nsw i64 %274, %275
  %277 = lshr i64 %276, 1
  %278 = mul i64 %277, 24
  %279 = getelementptr inbounds i8, ptr %272, i64 %278
  %280 = load double, ptr %279, align 8
  %281 = fcmp ogt double %280, %261
  %282 = add nuw nsw i64 %277, 1
  %283 = select i1 %281, i64 %277, i64 %275
  %284 = select i1 %281, i64 %274, i64 %282
  %285 = icmp slt i64 %284, %283
  br i1 %285, label %273, label %286, !llvm.loop !12

286:                                              ; preds = %273, %269
  %287 = phi i64 [ 0, %269 ], [ %284, %273 ]
  %288 = icmp slt i64 %287, %267
  br i1 %288, label %289, label %295

289:                                              ; preds = %286
  %290 = load ptr, ptr %92, align 8
  %291 = mul i64 %287, 24
  %292 = getelementptr inbounds i8, ptr %290, i64 %291
  %293 = getelementptr inbounds i8, ptr %292, i64 8
  %294 = load double, ptr %293, align 8
  br label %295

295:                                              ; preds = %289, %286
  %296 = phi double [ %294, %289 ], [ 0x7FF0000000000000, %286 ]
  %297 = load ptr, ptr %93, align 8
  store double %296, ptr %297, align 8
  br label %298

298:                                              ; preds = %295, %266
  %299 = getelementptr inbounds i8, ptr %224, i64 24
  %300 = load i64, ptr %299, align 8
  %301 = add nsw i64 %300, 1
  store i64 %301, ptr %299, align 8
  %302 = load ptr, ptr %82, align 8
  %303 = load ptr, ptr %94, align 8
  %304 = load ptr, ptr %95, align 8
  store double %261, ptr %304, align 8
  %305 = load ptr, ptr %81, align 8
  %306 = getelementptr inbounds i8, ptr %305, i64 40
  %307 = load i64, ptr %306, align 8
  %308 = icmp eq i64 %307, 0
  br i1 %308, label %310, label %309

309:                                              ; preds = %298
  tail call fastcc void @settle(ptr noundef nonnull %81) #10
  br label %310

310:                                              ; preds = %309, %298
  %311 = load i64, ptr %96, align 8
  %312 = icmp sgt i64 %311, 0
  br i1 %312, label %313, label %314

313:                                              ; preds = %310
  tail call fastcc void @sample(ptr noundef nonnull %81) #10
  br label %314

314:                                              ; preds = %310, %313
  %315 = load ptr, ptr %81, align 8
  %316 = load i64, ptr %315, align 8
  %317 = load ptr, ptr %95, align 8
  %318 = load ptr, ptr %97, align 8
  %319 = load ptr, ptr %98, align 8
  %320 = inttoptr i64 %316 to ptr
  %321 = load ptr, ptr %320, align 8
  %322 = tail call i32 %321(ptr noundef %317, ptr noundef %302, ptr noundef %318, ptr noundef %319, ptr noundef %303) #11
  %323 = icmp eq i32 %322, 0
  br i1 %323, label %328, label %324

324:                                              ; preds = %314
  %325 = getelementptr inbounds i8, ptr %224, i64 72
  store i64 3, ptr %325, align 8
  %326 = icmp slt i32 %322, 0
  %327 = select i1 %326, i64 -4, i64 2
  br label %2651

328:                                              ; preds = %314
  store i64 1, ptr %224, align 8
  %329 = load ptr, ptr %83, align 8
  %330 = getelementptr inbounds i8, ptr %329, i64 16
  %331 = load i64, ptr %330, align 8
  %332 = and i64 %331, -2
  store i64 %332, ptr %330, align 8
  %333 = load ptr, ptr %83, align 8
  %334 = getelementptr inbounds i8, ptr %333, i64 32
  %335 = load i64, ptr %334, align 8
  %336 = or i64 %335, 1
  store i64 %336, ptr %334, align 8
  %337 = load ptr, ptr %83, align 8
  %338 = getelementptr inbounds i8, ptr %337, i64 8
  %339 = load i64, ptr %338, align 8
  %340 = and i64 %339, -2
  %341 = getelementptr inbounds i8, ptr %337, i64 16
  %342 = load i64, ptr %341, align 8
  %343 = and i64 %342, 1
  %344 = or disjoint i64 %343, %340
  %345 = xor i64 %344, 1
  store i64 %345, ptr %338, align 8
  %346 = load ptr, ptr %99, align 8
  %347 = getelementptr inbounds i8, ptr %346, i64 8
  store double 0.000000e+00, ptr %347, align 8
  %348 = load ptr, ptr %99, align 8
  %349 = getelementptr inbounds i8, ptr %348, i64 24
  store double 0.000000e+00, ptr %349, align 8
  %350 = load ptr, ptr %82, align 8
  %351 = load ptr, ptr %81, align 8
  %352 = getelementptr inbounds i8, ptr %351, i64 8
  %353 = load i64, ptr %352, align 8
  %354 = load i64, ptr %87, align 8
  %355 = load ptr, ptr %86, align 8
  %356 = load ptr, ptr %85, align 8
  %357 = getelementptr inbounds i8, ptr %356, i64 48
  %358 = load i64, ptr %357, align 8
  %359 = icmp slt i64 %358, %354
  br i1 %359, label %360, label %383

360:                                              ; preds = %328
  %361 = icmp sgt i64 %353, 0
  br label %362

362:                                              ; preds = %360, %373
  %363 = phi i64 [ %358, %360 ], [ %374, %373 ]
  %364 = getelementptr inbounds double, ptr %355, i64 %363
  %365 = load double, ptr %364, align 8
  %366 = load ptr, ptr %84, align 8
  %367 = load double, ptr %366, align 8
  %368 = fcmp ugt double %365, %367
  br i1 %368, label %383, label %369

369:                                              ; preds = %362
  br i1 %361, label %370, label %373

370:                                              ; preds = %369
  %371 = mul nsw i64 %363, %353
  %372 = getelementptr double, ptr %1, i64 %371
  br label %376

373:                                              ; preds = %376, %369
  %374 = add i64 %363, 1
  %375 = icmp eq i64 %374, %354
  br i1 %375, label %383, label %362, !llvm.loop !13

376:                                              ; preds = %370, %376
  %377 = phi i64 [ 0, %370 ], [ %381, %376 ]
  %378 = getelementptr inbounds double, ptr %350, i64 %377
  %379 = load double, ptr %378, align 8
  %380 = getelementptr double, ptr %372, i64 %377
  store double %379, ptr %380, align 8
  %381 = add nuw nsw i64 %377, 1
  %382 = icmp eq i64 %381, %353
  br i1 %382, label %373, label %376, !llvm.loop !14

383:                                              ; preds = %362, %373, %328
  %384 = phi i64 [ %358, %328 ], [ %363, %362 ], [ %354, %373 ]
  %385 = load ptr, ptr %85, align 8
  %386 = getelementptr inbounds i8, ptr %385, i64 48
  store i64 %384, ptr %386, align 8
  %387 = icmp eq i64 %384, %354
  br i1 %387, label %2651, label %388

388:                                              ; preds = %383
  %389 = fcmp oeq double %263, 0.000000e+00
  br i1 %389, label %390, label %417

390:                                              ; preds = %388
  %391 = load ptr, ptr %81, align 8
  %392 = getelementptr inbounds i8, ptr %391, i64 24
  %393 = load i64, ptr %392, align 8
  %394 = getelementptr inbounds i8, ptr %223, i64 16
  %395 = load double, ptr %394, align 8
  %396 = load ptr, ptr %82, align 8
  call fastcc void @norm_to(ptr noundef nonnull %11, ptr noundef %396, ptr noundef %396, ptr noundef nonnull %82, i64 noundef %393) #10
  %397 = load double, ptr %11, align 8
  %398 = load ptr, ptr %100, align 8
  call fastcc void @norm_to(ptr noundef nonnull %12, ptr noundef %398, ptr noundef %396, ptr noundef nonnull %82, i64 noundef %393) #10
  %399 = load double, ptr %12, align 8
  %400 = fcmp uge double %397, 1.000000e-05
  %401 = fcmp uge double %399, 1.000000e-05
  %402 = and i1 %400, %401
  %403 = fmul double %397, 1.000000e-02
  %404 = fdiv double %403, %399
  %405 = select i1 %402, double %404, double 0x3EB0C6F7A0B5ED8D
  %406 = fcmp olt double %395, %405
  %407 = select i1 %406, double %395, double %405
  %408 = tail call double @llvm.fabs.f64(double %261)
  %409 = fmul double %408, 0x3D30000000000000
  %410 = fcmp ogt double %409, %407
  %411 = select i1 %410, double %409, double %407
  %412 = fcmp olt double %395, %411
  %413 = select i1 %412, double %395, double %411
  %414 = tail call i1 @llvm.is.fpclass.f64(double %413, i32 639)
  br i1 %414, label %415, label %417

415:                                              ; preds = %390
  %416 = getelementptr inbounds i8, ptr %224, i64 72
  store i64 4, ptr %416, align 8
  br label %417

417:                                              ; preds = %390, %415, %388, %252
  %418 = phi double [ %263, %388 ], [ %263, %252 ], [ %413, %415 ], [ %413, %390 ]
  %419 = load i64, ptr %225, align 8
  %420 = icmp eq i64 %419, 0
  br i1 %420, label %447, label %421

421:                                              ; preds = %417
  %422 = getelementptr inbounds i8, ptr %224, i64 8
  %423 = getelementptr inbounds i8, ptr %224, i64 16
  %424 = getelementptr inbounds i8, ptr %224, i64 64
  %425 = getelementptr inbounds i8, ptr %223, i64 16
  %426 = fcmp ogt double %253, 0x3CB0000000000000
  %427 = select i1 %426, double %253, double 0x3CB0000000000000
  %428 = fdiv double 0x3CE4000000000000, %427
  %429 = tail call double @llvm.sqrt.f64(double %253)
  %430 = fcmp olt double %429, 3.000000e-02
  %431 = select i1 %430, double %429, double 3.000000e-02
  %432 = fcmp ogt double %431, %428
  %433 = select i1 %432, double %431, double %428
  %434 = fmul double %253, %433
  %435 = fmul double %434, %434
  %436 = getelementptr inbounds i8, ptr %224, i64 24
  %437 = getelementptr inbounds i8, ptr %224, i64 32
  %438 = getelementptr inbounds i8, ptr %224, i64 40
  %439 = getelementptr inbounds i8, ptr %224, i64 72
  %440 = getelementptr inbounds i8, ptr %223, i64 32
  %441 = getelementptr inbounds i8, ptr %224, i64 48
  %442 = icmp sgt i64 %231, 0
  %443 = getelementptr inbounds i8, ptr %224, i64 72
  %444 = getelementptr inbounds i8, ptr %224, i64 48
  %445 = getelementptr inbounds i8, ptr %224, i64 72
  %446 = getelementptr inbounds i8, ptr %224, i64 72
  br label %455

447:                                              ; preds = %2648, %417
  %448 = phi double [ %217, %417 ], [ %2638, %2648 ]
  %449 = phi double [ %218, %417 ], [ %2639, %2648 ]
  %450 = phi double [ %219, %417 ], [ %2640, %2648 ]
  %451 = phi i64 [ %220, %417 ], [ %2641, %2648 ]
  %452 = phi i64 [ %221, %417 ], [ %2642, %2648 ]
  %453 = phi i64 [ %222, %417 ], [ %2643, %2648 ]
  %454 = phi double [ %418, %417 ], [ %2644, %2648 ]
  store double %454, ptr %262, align 8
  br label %2651

455:                                              ; preds = %421, %2648
  %456 = phi i64 [ %419, %421 ], [ %2649, %2648 ]
  %457 = phi i64 [ undef, %421 ], [ %2647, %2648 ]
  %458 = phi double [ %261, %421 ], [ %2645, %2648 ]
  %459 = phi double [ %418, %421 ], [ %2644, %2648 ]
  %460 = phi i64 [ %222, %421 ], [ %2643, %2648 ]
  %461 = phi i64 [ %221, %421 ], [ %2642, %2648 ]
  %462 = phi i64 [ %220, %421 ], [ %2641, %2648 ]
  %463 = phi double [ %219, %421 ], [ %2640, %2648 ]
  %464 = phi double [ %218, %421 ], [ %2639, %2648 ]
  %465 = phi double [ %217, %421 ], [ %2638, %2648 ]
  %466 = load ptr, ptr %101, align 8
  %467 = getelementptr inbounds i8, ptr %466, i64 8
  %468 = load i64, ptr %467, align 8
  %469 = icmp sgt i64 %468, 0
  br i1 %469, label %470, label %475

470:                                              ; preds = %455
  %471 = load i64, ptr %466, align 8
  %472 = add nsw i64 %471, 3
  %473 = icmp slt i64 %468, %472
  %474 = zext i1 %473 to i32
  br label %475

475:                                              ; preds = %455, %470
  %476 = phi i32 [ 0, %455 ], [ %474, %470 ]
  %477 = icmp eq i32 %476, 0
  br i1 %477, label %479, label %478

478:                                              ; preds = %475
  store double %459, ptr %262, align 8
  br label %2651

479:                                              ; preds = %475
  %480 = add nsw i64 %456, -1
  store i64 %480, ptr %225, align 8
  %481 = load i64, ptr %422, align 8
  %482 = load i64, ptr %423, align 8
  %483 = add nsw i64 %482, %481
  %484 = load i64, ptr %424, align 8
  %485 = icmp slt i64 %483, %484
  br i1 %485, label %487, label %486

486:                                              ; preds = %479
  store double %459, ptr %262, align 8
  br label %2651

487:                                              ; preds = %479
  %488 = load i64, ptr %102, align 8
  %489 = icmp eq i64 %488, 0
  br i1 %489, label %523, label %490

490:                                              ; preds = %487
  %491 = icmp sgt i64 %488, 0
  br i1 %491, label %492, label %507

492:                                              ; preds = %490
  %493 = load ptr, ptr %103, align 8
  br label %494

494:                                              ; preds = %492, %494
  %495 = phi i64 [ 0, %492 ], [ %505, %494 ]
  %496 = phi i64 [ %488, %492 ], [ %504, %494 ]
  %497 = add nuw nsw i64 %495, %496
  %498 = lshr i64 %497, 1
  %499 = mul i64 %498, 24
  %500 = getelementptr inbounds i8, ptr %493, i64 %499
  %501 = load double, ptr %500, align 8
  %502 = fcmp ogt double %501, %458
  %503 = add nuw nsw i64 %498, 1
  %504 = select i1 %502, i64 %498, i64 %496
  %505 = select i1 %502, i64 %495, i64 %503
  %506 = icmp slt i64 %505, %504
  br i1 %506, label %494, label %507, !llvm.loop !12

507:                                              ; preds = %494, %490
  %508 = phi i64 [ 0, %490 ], [ %505, %494 ]
  %509 = load ptr, ptr %103, align 8
  %510 = mul i64 %508, 24
  %511 = getelementptr inbounds i8, ptr %509, i64 %510
  %512 = icmp slt i64 %508, %488
  br i1 %512, label %513, label %516

513:                                              ; preds = %507
  %514 = getelementptr inbounds i8, ptr %511, i64 8
  %515 = load double, ptr %514, align 8
  br label %516

516:                                              ; preds = %513, %507
  %517 = phi double [ %515, %513 ], [ 0x7FF0000000000000, %507 ]
  %518 = load ptr, ptr %104, align 8
  store double %517, ptr %518, align 8
  %519 = load i64, ptr %102, align 8
  %520 = icmp slt i64 %508, %519
  br i1 %520, label %521, label %523

521:                                              ; preds = %516
  %522 = load double, ptr %511, align 8
  br label %523

523:                                              ; preds = %487, %516, %521
  %524 = phi double [ 0x7FF0000000000000, %487 ], [ %522, %521 ], [ 0x7FF0000000000000, %516 ]
  %525 = fcmp olt double %236, %524
  %526 = select i1 %525, double %236, double %524
  %527 = load double, ptr %425, align 8
  %528 = fcmp olt double %459, %527
  %529 = select i1 %528, double %459, double %527
  %530 = fadd double %458, %529
  %531 = fmul double %529, 1.000000e-03
  %532 = fsub double %526, %531
  %533 = fcmp ule double %530, %532
  %534 = select i1 %533, double %530, double %526
  %535 = fsub double %534, %458
  %536 = fmul double %535, 6.250000e-02
  %537 = fadd double %458, %536
  %538 = fcmp ule double %537, %458
  %539 = fcmp une double %534, %526
  %540 = and i1 %539, %538
  br i1 %540, label %541, label %542

541:                                              ; preds = %523
  store double %535, ptr %262, align 8
  br label %2637

542:                                              ; preds = %523
  %543 = load ptr, ptr %81, align 8, !noalias !15
  %544 = getelementptr inbounds i8, ptr %543, i64 8
  %545 = load i64, ptr %544, align 8, !noalias !15
  %546 = load ptr, ptr %83, align 8, !noalias !15
  %547 = getelementptr inbounds i8, ptr %546, i64 8
  %548 = load i64, ptr %547, align 8, !noalias !15
  %549 = and i64 %548, 1
  %550 = getelementptr inbounds i8, ptr %546, i64 32
  %551 = load i64, ptr %550, align 8, !noalias !15
  %552 = and i64 %551, 1
  %553 = icmp eq i64 %549, 0
  br i1 %553, label %685, label %554

554:                                              ; preds = %542
  %555 = load ptr, ptr %106, align 8, !noalias !15
  %556 = load i64, ptr %546, align 8, !noalias !15
  %557 = icmp eq i64 %556, 0
  br i1 %557, label %558, label %560

558:                                              ; preds = %554
  %559 = icmp sgt i64 %545, 0
  br i1 %559, label %584, label %582

560:                                              ; preds = %554
  %561 = load ptr, ptr %107, align 8, !noalias !15
  store double %458, ptr %561, align 8, !noalias !15
  %562 = load ptr, ptr %81, align 8, !noalias !15
  %563 = getelementptr inbounds i8, ptr %562, i64 40
  %564 = load i64, ptr %563, align 8, !noalias !15
  %565 = icmp eq i64 %564, 0
  br i1 %565, label %567, label %566

566:                                              ; preds = %560
  tail call fastcc void @settle(ptr noundef nonnull %81) #10, !noalias !15
  br label %567

567:                                              ; preds = %566, %560
  %568 = load i64, ptr %108, align 8, !noalias !15
  %569 = icmp sgt i64 %568, 0
  br i1 %569, label %570, label %571

570:                                              ; preds = %567
  tail call fastcc void @sample(ptr noundef nonnull %81) #10, !noalias !15
  br label %571

571:                                              ; preds = %570, %567
  %572 = load ptr, ptr %83, align 8, !noalias !15
  %573 = load i64, ptr %572, align 8, !noalias !15
  %574 = load ptr, ptr %107, align 8, !noalias !15
  %575 = load ptr, ptr %82, align 8, !noalias !15
  %576 = load ptr, ptr %109, align 8, !noalias !15
  %577 = load ptr, ptr %110, align 8, !noalias !15
  %578 = inttoptr i64 %573 to ptr
  %579 = load ptr, ptr %578, align 8, !noalias !15
  %580 = tail call i32 %579(ptr noundef %574, ptr noundef %575, ptr noundef %576, ptr noundef %577, ptr noundef %555) #11, !noalias !15
  %581 = sext i32 %580 to i64
  br label %656

582:                                              ; preds = %584, %558
  %583 = icmp sgt i64 %545, 0
  br i1 %583, label %596, label %656

584:                                              ; preds = %558, %584
  %585 = phi i64 [ %591, %584 ], [ 0, %558 ]
  %586 = load ptr, ptr %82, align 8, !noalias !15
  %587 = getelementptr inbounds double, ptr %586, i64 %585
  %588 = load double, ptr %587, align 8, !noalias !15
  %589 = load ptr, ptr %111, align 8, !noalias !15
  %590 = getelementptr inbounds double, ptr %589, i64 %585
  store double %588, ptr %590, align 8, !noalias !15
  %591 = add nuw nsw i64 %585, 1
  %592 = icmp eq i64 %591, %545
  br i1 %592, label %582, label %584, !llvm.loop !18

593:                                              ; preds = %654
  %594 = add nuw nsw i64 %598, 1
  %595 = icmp eq i64 %594, %545
  br i1 %595, label %656, label %596, !llvm.loop !19

596:                                              ; preds = %582, %593
  %597 = phi i64 [ %655, %593 ], [ undef, %582 ]
  %598 = phi i64 [ %594, %593 ], [ 0, %582 ]
  %599 = phi double [ %610, %593 ], [ 0.000000e+00, %582 ]
  %600 = load ptr, ptr %82, align 8, !noalias !15
  %601 = getelementptr inbounds double, ptr %600, i64 %598
  %602 = load double, ptr %601, align 8, !noalias !15
  %603 = tail call double @llvm.fabs.f64(double %602)
  %604 = fcmp olt double %603, 1.000000e-05
  %605 = select i1 %604, double 1.000000e-05, double %603
  %606 = fmul double %605, 1.500000e-08
  %607 = fadd double %602, %606
  %608 = load ptr, ptr %112, align 8, !noalias !15
  %609 = getelementptr inbounds double, ptr %608, i64 %598
  store double %607, ptr %609, align 8, !noalias !15
  %610 = fadd double %599, 1.000000e+00
  %611 = load ptr, ptr %112, align 8, !noalias !15
  %612 = load ptr, ptr %113, align 8, !noalias !15
  %613 = load ptr, ptr %114, align 8, !noalias !15
  store double %458, ptr %613, align 8, !noalias !15
  %614 = load ptr, ptr %81, align 8, !noalias !15
  %615 = getelementptr inbounds i8, ptr %614, i64 40
  %616 = load i64, ptr %615, align 8, !noalias !15
  %617 = icmp eq i64 %616, 0
  br i1 %617, label %619, label %618

618:                                              ; preds = %596
  tail call fastcc void @settle(ptr noundef nonnull %81) #10, !noalias !15
  br label %619

619:                                              ; preds = %618, %596
  %620 = load i64, ptr %115, align 8, !noalias !15
  %621 = icmp sgt i64 %620, 0
  br i1 %621, label %622, label %623

622:                                              ; preds = %619
  tail call fastcc void @sample(ptr noundef nonnull %81) #10, !noalias !15
  br label %623

623:                                              ; preds = %622, %619
  %624 = load ptr, ptr %81, align 8, !noalias !15
  %625 = load i64, ptr %624, align 8, !noalias !15
  %626 = load ptr, ptr %114, align 8, !noalias !15
  %627 = load ptr, ptr %116, align 8, !noalias !15
  %628 = load ptr, ptr %117, align 8, !noalias !15
  %629 = inttoptr i64 %625 to ptr
  %630 = load ptr, ptr %629, align 8, !noalias !15
  %631 = tail call i32 %630(ptr noundef %626, ptr noundef %611, ptr noundef %627, ptr noundef %628, ptr noundef %612) #11, !noalias !15
  %632 = sext i32 %631 to i64
  %633 = icmp eq i32 %631, 0
  br i1 %633, label %634, label %654

634:                                              ; preds = %623
  %635 = getelementptr double, ptr %555, i64 %598
  %636 = fsub double %607, %602
  br label %640

637:                                              ; preds = %640
  %638 = load ptr, ptr %112, align 8, !noalias !15
  %639 = getelementptr inbounds double, ptr %638, i64 %598
  store double %602, ptr %639, align 8, !noalias !15
  br label %654

640:                                              ; preds = %634, %640
  %641 = phi i64 [ 0, %634 ], [ %652, %640 ]
  %642 = load ptr, ptr %113, align 8, !noalias !15
  %643 = getelementptr inbounds double, ptr %642, i64 %641
  %644 = load double, ptr %643, align 8, !noalias !15
  %645 = load ptr, ptr %118, align 8, !noalias !15
  %646 = getelementptr inbounds double, ptr %645, i64 %641
  %647 = load double, ptr %646, align 8, !noalias !15
  %648 = fsub double %644, %647
  %649 = fdiv double %648, %636
  %650 = mul nuw nsw i64 %641, %545
  %651 = getelementptr double, ptr %635, i64 %650
  store double %649, ptr %651, align 8, !noalias !15
  %652 = add nuw nsw i64 %641, 1
  %653 = icmp eq i64 %652, %545
  br i1 %653, label %637, label %640, !llvm.loop !20

654:                                              ; preds = %637, %623
  %655 = phi i64 [ %597, %637 ], [ %632, %623 ]
  br i1 %633, label %593, label %656

656:                                              ; preds = %654, %593, %582, %571
  %657 = phi double [ 0.000000e+00, %571 ], [ 0.000000e+00, %582 ], [ %610, %593 ], [ %610, %654 ]
  %658 = phi i64 [ %581, %571 ], [ 0, %582 ], [ %655, %654 ], [ 0, %593 ]
  %659 = load i64, ptr %119, align 8, !noalias !15
  %660 = icmp sgt i64 %659, 0
  br i1 %660, label %661, label %674

661:                                              ; preds = %656, %661
  %662 = phi i64 [ %671, %661 ], [ 0, %656 ]
  %663 = load ptr, ptr %106, align 8, !noalias !15
  %664 = getelementptr inbounds double, ptr %663, i64 %662
  %665 = load double, ptr %664, align 8, !noalias !15
  %666 = tail call double @llvm.fabs.f64(double %665)
  %667 = fcmp ueq double %666, 0x7FF0000000000000
  %668 = select i1 %667, double 0.000000e+00, double %665
  %669 = load ptr, ptr %105, align 8, !noalias !15
  %670 = getelementptr inbounds double, ptr %669, i64 %662
  store double %668, ptr %670, align 8, !noalias !15
  %671 = add nuw nsw i64 %662, 1
  %672 = load i64, ptr %119, align 8, !noalias !15
  %673 = icmp slt i64 %671, %672
  br i1 %673, label %661, label %674, !llvm.loop !21

674:                                              ; preds = %661, %656
  %675 = icmp slt i64 %658, 0
  br i1 %675, label %1985, label %676

676:                                              ; preds = %674
  %677 = load i64, ptr %547, align 8, !noalias !15
  %678 = and i64 %677, -2
  store i64 %678, ptr %547, align 8, !noalias !15
  %679 = getelementptr inbounds i8, ptr %546, i64 16
  %680 = load i64, ptr %679, align 8, !noalias !15
  %681 = or i64 %680, 1
  store i64 %681, ptr %679, align 8, !noalias !15
  %682 = getelementptr inbounds i8, ptr %546, i64 24
  %683 = load i64, ptr %682, align 8, !noalias !15
  %684 = and i64 %683, -2
  store i64 %684, ptr %682, align 8, !noalias !15
  br label %685

685:                                              ; preds = %676, %542
  %686 = phi double [ 0.000000e+00, %542 ], [ %657, %676 ]
  %687 = load ptr, ptr %83, align 8, !noalias !15
  %688 = load ptr, ptr %120, align 8, !noalias !15
  %689 = load double, ptr %688, align 8, !noalias !15
  %690 = fsub double %535, %689
  %691 = tail call double @llvm.fabs.f64(double %690)
  %692 = tail call double @llvm.fabs.f64(double %534)
  %693 = fmul double %692, 0x3CB0000000000000
  %694 = fcmp ogt double %691, %693
  %695 = getelementptr inbounds i8, ptr %687, i64 24
  %696 = load i64, ptr %695, align 8, !noalias !15
  %697 = trunc i64 %696 to i1
  %698 = xor i1 %697, true
  %699 = or i1 %694, %698
  %700 = zext i1 %699 to i64
  br i1 %699, label %701, label %761

701:                                              ; preds = %685
  store double %535, ptr %688, align 8, !noalias !15
  %702 = load i64, ptr %121, align 8, !noalias !15
  %703 = load ptr, ptr %122, align 8, !noalias !15
  %704 = load ptr, ptr %123, align 8, !noalias !15
  %705 = icmp sgt i64 %702, 0
  br i1 %705, label %706, label %736

706:                                              ; preds = %701
  %707 = fdiv double 0x400D1A48D83E731D, %535
  %708 = fdiv double 0x400572DB93E0C672, %535
  %709 = fdiv double 0xC0086747F2C3FCB6, %535
  br label %710

710:                                              ; preds = %706, %713
  %711 = phi i64 [ 0, %706 ], [ %714, %713 ]
  %712 = mul nuw nsw i64 %711, %702
  br label %716

713:                                              ; preds = %716
  %714 = add nuw nsw i64 %711, 1
  %715 = icmp eq i64 %714, %702
  br i1 %715, label %736, label %710, !llvm.loop !22

716:                                              ; preds = %710, %716
  %717 = phi i64 [ 0, %710 ], [ %734, %716 ]
  %718 = load ptr, ptr %124, align 8, !noalias !15
  %719 = add nuw nsw i64 %717, %712
  %720 = getelementptr inbounds double, ptr %718, i64 %719
  %721 = load double, ptr %720, align 8, !noalias !15
  %722 = fneg double %721
  %723 = icmp eq i64 %711, %717
  %724 = fsub double %707, %721
  %725 = select i1 %723, double %724, double %722
  %726 = fsub double %708, %721
  %727 = select i1 %723, double %726, double %722
  %728 = getelementptr inbounds double, ptr %703, i64 %719
  store double %725, ptr %728, align 8, !noalias !15
  %729 = select i1 %723, double %709, double 0.000000e+00
  %730 = shl nuw nsw i64 %719, 1
  %731 = getelementptr inbounds double, ptr %704, i64 %730
  store double %727, ptr %731, align 8, !noalias !15
  %732 = or disjoint i64 %730, 1
  %733 = getelementptr inbounds double, ptr %704, i64 %732
  store double %729, ptr %733, align 8, !noalias !15
  %734 = add nuw nsw i64 %717, 1
  %735 = icmp eq i64 %734, %702
  br i1 %735, label %713, label %716, !llvm.loop !23

736:                                              ; preds = %713, %701
  %737 = load ptr, ptr %125, align 8, !noalias !15
  %738 = tail call fastcc i64 @real_factorise(ptr noundef %703, i64 noundef %702, ptr noundef %737) #10, !noalias !15
  %739 = load ptr, ptr %126, align 8, !noalias !15
  %740 = tail call fastcc i64 @pair_factorise(ptr noundef %704, i64 noundef %702, ptr noundef %739) #10, !noalias !15
  %741 = or i64 %740, %738
  %742 = and i64 %741, %700
  %743 = load i64, ptr %695, align 8, !noalias !15
  %744 = or i64 %743, %700
  %745 = xor i64 %742, -1
  %746 = xor i64 %742, %744
  store i64 %746, ptr %695, align 8, !noalias !15
  %747 = icmp eq i64 %742, 0
  %748 = select i1 %747, double 2.000000e+00, double 4.000000e+00
  %749 = fmul double %535, 5.000000e-01
  %750 = select i1 %747, double %459, double %749
  %751 = load ptr, ptr %83, align 8, !noalias !15
  %752 = getelementptr inbounds i8, ptr %751, i64 8
  %753 = load i64, ptr %752, align 8, !noalias !15
  %754 = and i64 %753, %745
  %755 = getelementptr inbounds i8, ptr %751, i64 16
  %756 = load i64, ptr %755, align 8, !noalias !15
  %757 = xor i64 %756, -1
  %758 = and i64 %742, %757
  %759 = or disjoint i64 %758, %754
  store i64 %759, ptr %752, align 8, !noalias !15
  %760 = and i64 %745, 1
  br label %761

761:                                              ; preds = %685, %736
  %762 = phi double [ %459, %685 ], [ %750, %736 ]
  %763 = phi double [ 2.000000e+00, %685 ], [ %748, %736 ]
  %764 = phi i64 [ 1, %685 ], [ %760, %736 ]
  %765 = icmp eq i64 %764, 0
  br i1 %765, label %1985, label %766

766:                                              ; preds = %761
  %767 = load ptr, ptr %120, align 8, !noalias !15
  %768 = getelementptr inbounds i8, ptr %767, i64 8
  %769 = load double, ptr %768, align 8, !noalias !15
  %770 = load ptr, ptr %81, align 8, !noalias !15
  %771 = getelementptr inbounds i8, ptr %770, i64 8
  %772 = load i64, ptr %771, align 8, !noalias !15
  %773 = load ptr, ptr %127, align 8, !noalias !15
  %774 = load ptr, ptr %82, align 8, !noalias !15
  %775 = load ptr, ptr %128, align 8, !noalias !15
  %776 = load ptr, ptr %129, align 8, !noalias !15
  %777 = fcmp ule double %769, 0.000000e+00
  %778 = icmp sgt i64 %772, 0
  %779 = shl i64 %772, 4
  %780 = getelementptr i8, ptr %773, i64 %779
  %781 = mul i64 %772, 24
  %782 = getelementptr i8, ptr %773, i64 %781
  %783 = getelementptr double, ptr %773, i64 %772
  br label %789

784:                                              ; preds = %800
  %785 = icmp sgt i64 %772, 0
  %786 = getelementptr double, ptr %775, i64 %772
  %787 = shl i64 %772, 4
  %788 = getelementptr i8, ptr %775, i64 %787
  br label %826

789:                                              ; preds = %766, %800
  %790 = phi i64 [ 0, %766 ], [ %801, %800 ]
  %791 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %790
  %792 = load double, ptr %791, align 8, !noalias !15
  %793 = fmul double %535, %792
  %794 = fdiv double %793, %769
  %795 = fadd double %794, 1.000000e+00
  br i1 %778, label %796, label %800

796:                                              ; preds = %789
  %797 = fsub double 1.000000e+00, %795
  %798 = mul nuw nsw i64 %772, %790
  %799 = getelementptr double, ptr %775, i64 %798
  br label %803

800:                                              ; preds = %803, %789
  %801 = add nuw nsw i64 %790, 1
  %802 = icmp eq i64 %801, 3
  br i1 %802, label %784, label %789, !llvm.loop !24

803:                                              ; preds = %796, %803
  %804 = phi i64 [ 0, %796 ], [ %824, %803 ]
  %805 = getelementptr double, ptr %780, i64 %804
  %806 = load double, ptr %805, align 8, !noalias !15
  %807 = getelementptr double, ptr %782, i64 %804
  %808 = load double, ptr %807, align 8, !noalias !15
  %809 = fmul double %795, %808
  %810 = fadd double %806, %809
  %811 = fmul double %797, %810
  %812 = getelementptr inbounds double, ptr %773, i64 %804
  %813 = load double, ptr %812, align 8, !noalias !15
  %814 = getelementptr double, ptr %783, i64 %804
  %815 = load double, ptr %814, align 8, !noalias !15
  %816 = fadd double %815, %811
  %817 = fmul double %795, %816
  %818 = fadd double %813, %817
  %819 = getelementptr inbounds double, ptr %774, i64 %804
  %820 = load double, ptr %819, align 8, !noalias !15
  %821 = fsub double %818, %820
  %822 = select i1 %777, double 0.000000e+00, double %821
  %823 = getelementptr double, ptr %799, i64 %804
  store double %822, ptr %823, align 8, !noalias !15
  %824 = add nuw nsw i64 %804, 1
  %825 = icmp eq i64 %824, %772
  br i1 %825, label %800, label %803, !llvm.loop !25

826:                                              ; preds = %784, %837
  %827 = phi i64 [ 0, %784 ], [ %838, %837 ]
  br i1 %785, label %828, label %837

828:                                              ; preds = %826
  %829 = mul nuw nsw i64 %772, %827
  %830 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %827
  %831 = load double, ptr %830, align 8, !noalias !15
  %832 = getelementptr inbounds i8, ptr %830, i64 8
  %833 = load double, ptr %832, align 8, !noalias !15
  %834 = getelementptr inbounds i8, ptr %830, i64 16
  %835 = load double, ptr %834, align 8, !noalias !15
  %836 = getelementptr double, ptr %776, i64 %829
  br label %840

837:                                              ; preds = %840, %826
  %838 = add nuw nsw i64 %827, 1
  %839 = icmp eq i64 %838, 3
  br i1 %839, label %856, label %826, !llvm.loop !26

840:                                              ; preds = %828, %840
  %841 = phi i64 [ 0, %828 ], [ %854, %840 ]
  %842 = getelementptr inbounds double, ptr %775, i64 %841
  %843 = load double, ptr %842, align 8, !noalias !15
  %844 = fmul double %831, %843
  %845 = getelementptr double, ptr %786, i64 %841
  %846 = load double, ptr %845, align 8, !noalias !15
  %847 = fmul double %833, %846
  %848 = fadd double %844, %847
  %849 = getelementptr double, ptr %788, i64 %841
  %850 = load double, ptr %849, align 8, !noalias !15
  %851 = fmul double %835, %850
  %852 = fadd double %848, %851
  %853 = getelementptr double, ptr %836, i64 %841
  store double %852, ptr %853, align 8, !noalias !15
  %854 = add nuw nsw i64 %841, 1
  %855 = icmp eq i64 %854, %772
  br i1 %855, label %837, label %840, !llvm.loop !27

856:                                              ; preds = %837
  %857 = load ptr, ptr %83, align 8, !noalias !28
  %858 = getelementptr inbounds i8, ptr %857, i64 40
  %859 = load i64, ptr %858, align 8, !noalias !28
  %860 = icmp sgt i64 %859, 0
  %861 = select i1 %860, i64 10, i64 6
  %862 = fdiv double 0x400572DB93E0C672, %535
  %863 = fdiv double 0xC0086747F2C3FCB6, %535
  %864 = fdiv double 0x400D1A48D83E731D, %535
  %865 = fneg double %863
  br label %869

866:                                              ; preds = %1332
  %867 = add nuw nsw i64 %873, 1
  %868 = icmp eq i64 %867, %861
  br i1 %868, label %1347, label %869, !llvm.loop !31

869:                                              ; preds = %856, %866
  %870 = phi double [ -1.000000e+00, %856 ], [ %1345, %866 ]
  %871 = phi i64 [ %764, %856 ], [ %1344, %866 ]
  %872 = phi i64 [ 0, %856 ], [ %1343, %866 ]
  %873 = phi i64 [ 0, %856 ], [ %867, %866 ]
  %874 = phi i64 [ 0, %856 ], [ %1341, %866 ]
  %875 = phi i64 [ 0, %856 ], [ %963, %866 ]
  %876 = phi i64 [ 0, %856 ], [ %962, %866 ]
  %877 = phi double [ 0.000000e+00, %856 ], [ %1340, %866 ]
  %878 = phi double [ 0.000000e+00, %856 ], [ %1339, %866 ]
  %879 = phi double [ 0.000000e+00, %856 ], [ %961, %866 ]
  %880 = phi i64 [ %460, %856 ], [ %1338, %866 ]
  %881 = phi i64 [ %461, %856 ], [ %1337, %866 ]
  %882 = phi i64 [ %462, %856 ], [ %1336, %866 ]
  %883 = phi double [ %463, %856 ], [ %1335, %866 ]
  %884 = phi double [ %464, %856 ], [ %1334, %866 ]
  %885 = phi double [ %465, %856 ], [ %1333, %866 ]
  %886 = icmp ugt i64 %873, 5
  %887 = select i1 %886, i64 %874, i64 -1
  %888 = and i64 %871, %887
  %889 = load ptr, ptr %81, align 8, !noalias !28
  %890 = getelementptr inbounds i8, ptr %889, i64 8
  %891 = load i64, ptr %890, align 8, !noalias !28
  %892 = load ptr, ptr %128, align 8, !noalias !28
  %893 = icmp eq i64 %888, 0
  br i1 %893, label %960, label %894

894:                                              ; preds = %869
  %895 = icmp sgt i64 %891, 0
  br label %896

896:                                              ; preds = %894, %928
  %897 = phi i64 [ %888, %894 ], [ %943, %928 ]
  %898 = phi i64 [ 0, %894 ], [ %944, %928 ]
  %899 = phi i64 [ %875, %894 ], [ %941, %928 ]
  %900 = phi i64 [ %876, %894 ], [ %939, %928 ]
  %901 = phi double [ %879, %894 ], [ %909, %928 ]
  br i1 %895, label %902, label %905

902:                                              ; preds = %896
  %903 = mul nuw nsw i64 %898, %891
  %904 = getelementptr double, ptr %892, i64 %903
  br label %948

905:                                              ; preds = %948, %896
  %906 = and i64 %897, 4294967295
  %907 = icmp eq i64 %906, 0
  %908 = select i1 %907, double 0.000000e+00, double 1.000000e+00
  %909 = fadd double %901, %908
  %910 = load ptr, ptr %131, align 8, !noalias !28
  %911 = mul nsw i64 %898, %891
  %912 = getelementptr inbounds double, ptr %910, i64 %911
  %913 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %898
  %914 = load double, ptr %913, align 8, !noalias !28
  %915 = fmul double %535, %914
  %916 = fadd double %458, %915
  %917 = load ptr, ptr %132, align 8, !noalias !28
  %918 = load ptr, ptr %133, align 8, !noalias !28
  store double %916, ptr %918, align 8, !noalias !28
  %919 = load ptr, ptr %81, align 8, !noalias !28
  %920 = getelementptr inbounds i8, ptr %919, i64 40
  %921 = load i64, ptr %920, align 8, !noalias !28
  %922 = icmp eq i64 %921, 0
  br i1 %922, label %924, label %923

923:                                              ; preds = %905
  tail call fastcc void @settle(ptr noundef nonnull %81) #10, !noalias !28
  br label %924

924:                                              ; preds = %923, %905
  %925 = load i64, ptr %134, align 8, !noalias !28
  %926 = icmp sgt i64 %925, 0
  br i1 %926, label %927, label %928

927:                                              ; preds = %924
  tail call fastcc void @sample(ptr noundef nonnull %81) #10, !noalias !28
  br label %928

928:                                              ; preds = %927, %924
  %929 = load ptr, ptr %81, align 8, !noalias !28
  %930 = load i64, ptr %929, align 8, !noalias !28
  %931 = load ptr, ptr %133, align 8, !noalias !28
  %932 = load ptr, ptr %135, align 8, !noalias !28
  %933 = load ptr, ptr %136, align 8, !noalias !28
  %934 = inttoptr i64 %930 to ptr
  %935 = load ptr, ptr %934, align 8, !noalias !28
  %936 = tail call i32 %935(ptr noundef %931, ptr noundef %917, ptr noundef %932, ptr noundef %933, ptr noundef %912) #11, !noalias !28
  %937 = sext i32 %936 to i64
  %938 = icmp slt i32 %936, 0
  %939 = select i1 %938, i64 %937, i64 %900
  %940 = and i64 %897, %937
  %941 = or i64 %940, %899
  %942 = xor i64 %937, -1
  %943 = and i64 %897, %942
  %944 = add nuw nsw i64 %898, 1
  %945 = icmp ult i64 %898, 2
  %946 = icmp ne i64 %943, 0
  %947 = select i1 %945, i1 %946, i1 false
  br i1 %947, label %896, label %960, !llvm.loop !32

948:                                              ; preds = %902, %948
  %949 = phi i64 [ 0, %902 ], [ %958, %948 ]
  %950 = load ptr, ptr %130, align 8, !noalias !28
  %951 = load ptr, ptr %82, align 8, !noalias !28
  %952 = getelementptr inbounds double, ptr %951, i64 %949
  %953 = load double, ptr %952, align 8, !noalias !28
  %954 = getelementptr double, ptr %904, i64 %949
  %955 = load double, ptr %954, align 8, !noalias !28
  %956 = fadd double %953, %955
  %957 = getelementptr inbounds double, ptr %950, i64 %949
  store double %956, ptr %957, align 8, !noalias !28
  %958 = add nuw nsw i64 %949, 1
  %959 = icmp eq i64 %958, %891
  br i1 %959, label %905, label %948, !llvm.loop !33

960:                                              ; preds = %928, %869
  %961 = phi double [ %879, %869 ], [ %909, %928 ]
  %962 = phi i64 [ %876, %869 ], [ %939, %928 ]
  %963 = phi i64 [ %875, %869 ], [ %941, %928 ]
  %964 = phi i64 [ %888, %869 ], [ %943, %928 ]
  %965 = icmp eq i64 %964, 0
  br i1 %965, label %966, label %970

966:                                              ; preds = %960
  %967 = or i64 %888, %872
  %968 = xor i64 %967, -1
  %969 = and i64 %874, %968
  br label %1332

970:                                              ; preds = %960
  %971 = load ptr, ptr %81, align 8, !noalias !28
  %972 = getelementptr inbounds i8, ptr %971, i64 8
  %973 = load i64, ptr %972, align 8, !noalias !28
  %974 = getelementptr inbounds i8, ptr %971, i64 24
  %975 = load i64, ptr %974, align 8, !noalias !28
  %976 = load ptr, ptr %137, align 8, !noalias !28
  %977 = load ptr, ptr %129, align 8, !noalias !28
  %978 = icmp sgt i64 %973, 0
  br i1 %978, label %979, label %1061

979:                                              ; preds = %970
  %980 = shl nuw nsw i64 %973, 1
  br label %981

981:                                              ; preds = %979, %1057
  %982 = phi i32 [ 1, %979 ], [ %997, %1057 ]
  %983 = phi i64 [ 0, %979 ], [ %1059, %1057 ]
  %984 = phi double [ 0.000000e+00, %979 ], [ %1058, %1057 ]
  %985 = getelementptr inbounds double, ptr %976, i64 %983
  %986 = load double, ptr %985, align 8, !noalias !28
  %987 = add nuw nsw i64 %983, %973
  %988 = getelementptr inbounds double, ptr %976, i64 %987
  %989 = load double, ptr %988, align 8, !noalias !28
  %990 = fadd double %986, %989
  %991 = add nuw nsw i64 %983, %980
  %992 = getelementptr inbounds double, ptr %976, i64 %991
  %993 = load double, ptr %992, align 8, !noalias !28
  %994 = fadd double %990, %993
  %995 = tail call double @llvm.fabs.f64(double %994)
  %996 = fcmp one double %995, 0x7FF0000000000000
  %997 = select i1 %996, i32 %982, i32 0
  %998 = getelementptr inbounds double, ptr %977, i64 %987
  %999 = load double, ptr %998, align 8, !noalias !28
  %1000 = getelementptr inbounds double, ptr %977, i64 %991
  %1001 = load double, ptr %1000, align 8, !noalias !28
  %1002 = fmul double %986, 0xC010B70201A79C46
  %1003 = fmul double %989, 0x3FD4F8C15DA84E86
  %1004 = fsub double %1002, %1003
  %1005 = fmul double %993, 0x3FDE810014C55221
  %1006 = fadd double %1004, %1005
  %1007 = fmul double %986, 0x3FE017885A24A7F2
  %1008 = fmul double %989, 0x4004934E6FCAA598
  %1009 = fsub double %1007, %1008
  %1010 = fmul double %993, 0x3FE312C0CF7BDFD1
  %1011 = fadd double %1009, %1010
  %1012 = fmul double %986, 0x4010B70201A79C46
  %1013 = fmul double %989, 0x3FD4F8C15DA84E86
  %1014 = fadd double %1012, %1013
  %1015 = fmul double %993, 0x3FE0BF7FF59D56EF
  %1016 = fadd double %1014, %1015
  %1017 = getelementptr inbounds double, ptr %977, i64 %983
  %1018 = load double, ptr %1017, align 8, !noalias !28
  %1019 = fmul double %864, %1018
  %1020 = fsub double %1016, %1019
  %1021 = fmul double %1001, %865
  %1022 = tail call double @llvm.fma.f64(double %862, double %999, double %1021)
  %1023 = fmul double %863, %999
  %1024 = tail call double @llvm.fma.f64(double %862, double %1001, double %1023)
  %1025 = fsub double %1006, %1022
  %1026 = fsub double %1011, %1024
  %1027 = load ptr, ptr %138, align 8, !noalias !28
  %1028 = getelementptr inbounds double, ptr %1027, i64 %983
  store double %1020, ptr %1028, align 8, !noalias !28
  %1029 = load ptr, ptr %139, align 8, !noalias !28
  %1030 = shl nuw nsw i64 %983, 1
  %1031 = getelementptr inbounds double, ptr %1029, i64 %1030
  store double %1025, ptr %1031, align 8, !noalias !28
  %1032 = or disjoint i64 %1030, 1
  %1033 = getelementptr inbounds double, ptr %1029, i64 %1032
  store double %1026, ptr %1033, align 8, !noalias !28
  %1034 = icmp slt i64 %983, %975
  br i1 %1034, label %1035, label %1057

1035:                                             ; preds = %981
  %1036 = load ptr, ptr %82, align 8, !noalias !28
  %1037 = getelementptr inbounds double, ptr %1036, i64 %983
  %1038 = load double, ptr %1037, align 8, !noalias !28
  %1039 = tail call double @llvm.fabs.f64(double %1020)
  %1040 = tail call double @llvm.fabs.f64(double %1025)
  %1041 = tail call double @llvm.fabs.f64(double %1026)
  %1042 = fadd double %1041, %1040
  %1043 = fadd double %1039, %1042
  %1044 = fmul double %535, %1043
  %1045 = load ptr, ptr %140, align 8, !noalias !28
  %1046 = getelementptr inbounds double, ptr %1045, i64 %983
  %1047 = load double, ptr %1046, align 8, !noalias !28
  %1048 = load ptr, ptr %88, align 8, !noalias !28
  %1049 = getelementptr inbounds double, ptr %1048, i64 %983
  %1050 = load double, ptr %1049, align 8, !noalias !28
  %1051 = tail call double @llvm.fabs.f64(double %1038)
  %1052 = fmul double %1051, %1050
  %1053 = fadd double %1047, %1052
  %1054 = fdiv double %1044, %1053
  %1055 = fmul double %1054, %1054
  %1056 = fadd double %984, %1055
  br label %1057

1057:                                             ; preds = %1035, %981
  %1058 = phi double [ %1056, %1035 ], [ %984, %981 ]
  %1059 = add nuw nsw i64 %983, 1
  %1060 = icmp eq i64 %1059, %973
  br i1 %1060, label %1061, label %981, !llvm.loop !34

1061:                                             ; preds = %1057, %970
  %1062 = phi double [ 0.000000e+00, %970 ], [ %1058, %1057 ]
  %1063 = phi i32 [ 1, %970 ], [ %997, %1057 ]
  %1064 = zext nneg i32 %1063 to i64
  %1065 = xor i64 %1064, 4294967295
  %1066 = and i64 %964, %1065
  %1067 = icmp eq i64 %1066, 0
  %1068 = select i1 %1067, double %878, double 0x7FF0000000000000
  %1069 = load ptr, ptr %81, align 8, !noalias !28
  %1070 = getelementptr inbounds i8, ptr %1069, i64 24
  %1071 = load i64, ptr %1070, align 8, !noalias !28
  %1072 = load i64, ptr %142, align 8, !noalias !28
  %1073 = load ptr, ptr %83, align 8, !noalias !28
  %1074 = getelementptr inbounds i8, ptr %1073, i64 40
  %1075 = load i64, ptr %1074, align 8, !noalias !28
  %1076 = load ptr, ptr %143, align 8, !noalias !28
  %1077 = load ptr, ptr %144, align 8, !noalias !28
  %1078 = load ptr, ptr %145, align 8, !noalias !28
  %1079 = load ptr, ptr %141, align 8, !noalias !28
  tail call fastcc void @real_solve(ptr noundef %1078, i64 noundef %1072, ptr noundef %1079, ptr noundef %1076) #10, !noalias !28
  %1080 = load ptr, ptr %146, align 8, !noalias !28
  %1081 = load ptr, ptr %147, align 8, !noalias !28
  tail call fastcc void @pair_solve(ptr noundef %1080, i64 noundef %1072, ptr noundef %1081, ptr noundef %1077) #10, !noalias !28
  %1082 = icmp sgt i64 %1075, 0
  br i1 %1082, label %1083, label %1091

1083:                                             ; preds = %1061
  %1084 = load ptr, ptr %145, align 8, !noalias !28
  %1085 = load ptr, ptr %141, align 8, !noalias !28
  %1086 = getelementptr inbounds double, ptr %1076, i64 %1072
  tail call fastcc void @real_solve_columns(ptr noundef %1084, i64 noundef %1072, ptr noundef %1085, ptr noundef %1086, i64 noundef %1075) #10, !noalias !28
  %1087 = load ptr, ptr %146, align 8, !noalias !28
  %1088 = load ptr, ptr %147, align 8, !noalias !28
  %1089 = shl nsw i64 %1072, 4
  %1090 = getelementptr inbounds i8, ptr %1077, i64 %1089
  tail call fastcc void @pair_solve_columns(ptr noundef %1087, i64 noundef %1072, ptr noundef %1088, ptr noundef %1090, i64 noundef %1075) #10, !noalias !28
  br label %1091

1091:                                             ; preds = %1083, %1061
  %1092 = icmp sgt i64 %1071, 0
  br i1 %1092, label %1093, label %1128

1093:                                             ; preds = %1091
  %1094 = load ptr, ptr %82, align 8, !noalias !28
  %1095 = load ptr, ptr %148, align 8, !noalias !28
  %1096 = load ptr, ptr %88, align 8, !noalias !28
  br label %1097

1097:                                             ; preds = %1093, %1097
  %1098 = phi double [ 0.000000e+00, %1093 ], [ %1125, %1097 ]
  %1099 = phi i64 [ 0, %1093 ], [ %1126, %1097 ]
  %1100 = getelementptr inbounds double, ptr %1094, i64 %1099
  %1101 = load double, ptr %1100, align 8, !noalias !28
  %1102 = getelementptr inbounds double, ptr %1095, i64 %1099
  %1103 = load double, ptr %1102, align 8, !noalias !28
  %1104 = getelementptr inbounds double, ptr %1096, i64 %1099
  %1105 = load double, ptr %1104, align 8, !noalias !28
  %1106 = tail call double @llvm.fabs.f64(double %1101)
  %1107 = fmul double %1106, %1105
  %1108 = fadd double %1103, %1107
  %1109 = getelementptr inbounds double, ptr %1076, i64 %1099
  %1110 = load double, ptr %1109, align 8, !noalias !28
  %1111 = fdiv double %1110, %1108
  %1112 = shl nuw nsw i64 %1099, 1
  %1113 = getelementptr inbounds double, ptr %1077, i64 %1112
  %1114 = load double, ptr %1113, align 8, !noalias !28
  %1115 = or disjoint i64 %1112, 1
  %1116 = getelementptr inbounds double, ptr %1077, i64 %1115
  %1117 = load double, ptr %1116, align 8, !noalias !28
  %1118 = fdiv double %1114, %1108
  %1119 = fdiv double %1117, %1108
  %1120 = fmul double %1111, %1111
  %1121 = fmul double %1118, %1118
  %1122 = fadd double %1120, %1121
  %1123 = fmul double %1119, %1119
  %1124 = fadd double %1122, %1123
  %1125 = fadd double %1098, %1124
  %1126 = add nuw nsw i64 %1099, 1
  %1127 = icmp eq i64 %1126, %1071
  br i1 %1127, label %1128, label %1097, !llvm.loop !35

1128:                                             ; preds = %1097, %1091
  %1129 = phi double [ 0.000000e+00, %1091 ], [ %1125, %1097 ]
  %1130 = mul nsw i64 %1071, 3
  %1131 = sitofp i64 %1130 to double
  %1132 = fdiv double %1129, %1131
  %1133 = tail call double @llvm.sqrt.f64(double %1132)
  %1134 = fcmp oeq double %1133, 0.000000e+00
  %1135 = fcmp ogt double %1062, 0.000000e+00
  %1136 = and i1 %1135, %1134
  %1137 = zext i1 %1136 to i64
  %1138 = xor i64 %1137, -1
  %1139 = and i64 %1064, %1138
  %1140 = and i64 %1139, %964
  %1141 = xor i64 %874, -1
  %1142 = and i64 %1140, %1141
  %1143 = trunc nuw nsw i64 %1142 to i32
  %1144 = fcmp ogt double %870, 0.000000e+00
  %1145 = and i32 %1143, 1
  %1146 = select i1 %1144, i32 %1145, i32 0
  %1147 = fdiv double %1133, %870
  %1148 = icmp eq i32 %1146, 0
  %1149 = select i1 %1148, double %1068, double %1147
  %1150 = fsub double 1.000000e+00, %1149
  %1151 = fdiv double %1133, %1150
  %1152 = icmp ult i64 %873, 5
  br i1 %1152, label %1245, label %1153

1153:                                             ; preds = %1245, %1128
  %1154 = phi double [ %1151, %1128 ], [ %1248, %1245 ]
  %1155 = fcmp oge double %1149, 1.000000e+00
  %1156 = fcmp ogt double %1154, %433
  %1157 = or i1 %1155, %1156
  %1158 = xor i32 %1146, -1
  %1159 = zext i32 %1158 to i64
  %1160 = select i1 %1157, i64 %1159, i64 2147483647
  %1161 = and i64 %1160, %1140
  %1162 = xor i64 %1161, -1
  %1163 = and i64 %888, %1162
  %1164 = or i64 %1163, %872
  %1165 = load ptr, ptr %81, align 8, !noalias !28
  %1166 = getelementptr inbounds i8, ptr %1165, i64 8
  %1167 = load i64, ptr %1166, align 8, !noalias !28
  %1168 = load ptr, ptr %128, align 8, !noalias !28
  %1169 = load ptr, ptr %129, align 8, !noalias !28
  %1170 = icmp sgt i64 %1167, 0
  br i1 %1170, label %1171, label %1231

1171:                                             ; preds = %1153
  %1172 = icmp eq i64 %1161, 0
  %1173 = getelementptr double, ptr %1169, i64 %1167
  %1174 = shl i64 %1167, 4
  %1175 = getelementptr i8, ptr %1169, i64 %1174
  %1176 = icmp eq i64 %1161, 0
  br label %1177

1177:                                             ; preds = %1171, %1206
  %1178 = phi i64 [ 0, %1171 ], [ %1207, %1206 ]
  %1179 = load ptr, ptr %144, align 8, !noalias !28
  %1180 = shl nuw nsw i64 %1178, 1
  %1181 = getelementptr inbounds double, ptr %1179, i64 %1180
  %1182 = load double, ptr %1181, align 8, !noalias !28
  %1183 = or disjoint i64 %1180, 1
  %1184 = getelementptr inbounds double, ptr %1179, i64 %1183
  %1185 = load double, ptr %1184, align 8, !noalias !28
  %1186 = load ptr, ptr %143, align 8, !noalias !28
  %1187 = getelementptr inbounds double, ptr %1186, i64 %1178
  %1188 = load double, ptr %1187, align 8, !noalias !28
  store double %1188, ptr %10, align 16, !noalias !28
  store double %1182, ptr %149, align 8, !noalias !28
  store double %1185, ptr %150, align 16, !noalias !28
  %1189 = getelementptr double, ptr %1169, i64 %1178
  br label %1195

1190:                                             ; preds = %1195
  %1191 = getelementptr inbounds double, ptr %1169, i64 %1178
  %1192 = getelementptr double, ptr %1173, i64 %1178
  %1193 = getelementptr double, ptr %1175, i64 %1178
  %1194 = getelementptr double, ptr %1168, i64 %1178
  br label %1209

1195:                                             ; preds = %1177, %1195
  %1196 = phi i64 [ 0, %1177 ], [ %1204, %1195 ]
  %1197 = mul nuw nsw i64 %1167, %1196
  %1198 = getelementptr double, ptr %1189, i64 %1197
  %1199 = load double, ptr %1198, align 8, !noalias !28
  %1200 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %1196
  %1201 = load double, ptr %1200, align 8, !noalias !28
  %1202 = fadd double %1199, %1201
  %1203 = select i1 %1172, double %1199, double %1202
  store double %1203, ptr %1198, align 8, !noalias !28
  %1204 = add nuw nsw i64 %1196, 1
  %1205 = icmp eq i64 %1204, 3
  br i1 %1205, label %1190, label %1195, !llvm.loop !36

1206:                                             ; preds = %1209
  %1207 = add nuw nsw i64 %1178, 1
  %1208 = icmp eq i64 %1207, %1167
  br i1 %1208, label %1231, label %1177, !llvm.loop !37

1209:                                             ; preds = %1190, %1209
  %1210 = phi i64 [ 0, %1190 ], [ %1229, %1209 ]
  %1211 = mul nuw nsw i64 %1167, %1210
  %1212 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1210
  %1213 = load double, ptr %1212, align 8, !noalias !28
  %1214 = load double, ptr %1191, align 8, !noalias !28
  %1215 = fmul double %1213, %1214
  %1216 = getelementptr inbounds i8, ptr %1212, i64 8
  %1217 = load double, ptr %1216, align 8, !noalias !28
  %1218 = load double, ptr %1192, align 8, !noalias !28
  %1219 = fmul double %1217, %1218
  %1220 = fadd double %1215, %1219
  %1221 = getelementptr inbounds i8, ptr %1212, i64 16
  %1222 = load double, ptr %1221, align 8, !noalias !28
  %1223 = load double, ptr %1193, align 8, !noalias !28
  %1224 = fmul double %1222, %1223
  %1225 = fadd double %1220, %1224
  %1226 = getelementptr double, ptr %1194, i64 %1211
  %1227 = load double, ptr %1226, align 8, !noalias !28
  %1228 = select i1 %1176, double %1227, double %1225
  store double %1228, ptr %1226, align 8, !noalias !28
  %1229 = add nuw nsw i64 %1210, 1
  %1230 = icmp eq i64 %1229, 3
  br i1 %1230, label %1206, label %1209, !llvm.loop !38

1231:                                             ; preds = %1206, %1153
  %1232 = fdiv double %1149, %1150
  %1233 = fmul double %1133, %1232
  %1234 = fcmp olt double %1233, %433
  %1235 = and i1 %1144, %1234
  %1236 = or i1 %1134, %1235
  %1237 = and i64 %1141, 1
  %1238 = select i1 %1236, i64 %1237, i64 0
  %1239 = and i64 %1161, %1238
  %1240 = add nuw nsw i64 %873, 1
  %1241 = uitofp nneg i64 %1240 to double
  %1242 = icmp eq i64 %1239, 0
  %1243 = select i1 %1242, double %877, double %1241
  %1244 = or i64 %1239, %874
  br i1 %860, label %1251, label %1325

1245:                                             ; preds = %1128, %1245
  %1246 = phi i64 [ %1249, %1245 ], [ %873, %1128 ]
  %1247 = phi double [ %1248, %1245 ], [ %1151, %1128 ]
  %1248 = fmul double %1149, %1247
  %1249 = add nuw nsw i64 %1246, 1
  %1250 = icmp ult i64 %1246, 4
  br i1 %1250, label %1245, label %1153, !llvm.loop !39

1251:                                             ; preds = %1231
  %1252 = load i64, ptr %142, align 8, !noalias !28
  %1253 = load ptr, ptr %83, align 8, !noalias !28
  %1254 = getelementptr inbounds i8, ptr %1253, i64 40
  %1255 = load i64, ptr %1254, align 8, !noalias !28
  %1256 = load ptr, ptr %81, align 8, !noalias !28
  %1257 = getelementptr inbounds i8, ptr %1256, i64 8
  %1258 = load i64, ptr %1257, align 8, !noalias !28
  %1259 = load ptr, ptr %129, align 8, !noalias !28
  %1260 = icmp sgt i64 %1255, 0
  br i1 %1260, label %1261, label %1320

1261:                                             ; preds = %1251
  %1262 = icmp sgt i64 %1252, 0
  br label %1263

1263:                                             ; preds = %1261, %1271
  %1264 = phi double [ 0.000000e+00, %1261 ], [ %1279, %1271 ]
  %1265 = phi i64 [ 0, %1261 ], [ %1280, %1271 ]
  br i1 %1262, label %1266, label %1271

1266:                                             ; preds = %1263
  %1267 = add nuw i64 %1265, %1252
  %1268 = load ptr, ptr %143, align 8, !noalias !28
  %1269 = load ptr, ptr %82, align 8, !noalias !28
  %1270 = load ptr, ptr %144, align 8, !noalias !28
  br label %1282

1271:                                             ; preds = %1306, %1263
  %1272 = phi double [ 0.000000e+00, %1263 ], [ %1317, %1306 ]
  %1273 = phi double [ 0.000000e+00, %1263 ], [ %1307, %1306 ]
  %1274 = fcmp ule double %1272, 0.000000e+00
  %1275 = fdiv double %1273, %1272
  %1276 = select i1 %1274, double 1.000000e+00, double %1275
  %1277 = fmul double %1264, %1272
  %1278 = fcmp ule double %1273, %1277
  %1279 = select i1 %1278, double %1264, double %1276
  %1280 = add nuw nsw i64 %1265, 1
  %1281 = icmp eq i64 %1280, %1255
  br i1 %1281, label %1320, label %1263, !llvm.loop !40

1282:                                             ; preds = %1266, %1306
  %1283 = phi double [ 0.000000e+00, %1266 ], [ %1307, %1306 ]
  %1284 = phi double [ 0.000000e+00, %1266 ], [ %1317, %1306 ]
  %1285 = phi i64 [ 0, %1266 ], [ %1308, %1306 ]
  %1286 = mul nuw nsw i64 %1285, %1255
  %1287 = add i64 %1267, %1286
  %1288 = getelementptr inbounds double, ptr %1268, i64 %1287
  %1289 = load double, ptr %1288, align 8, !noalias !28
  %1290 = getelementptr inbounds double, ptr %1269, i64 %1287
  %1291 = load double, ptr %1290, align 8, !noalias !28
  %1292 = shl nsw i64 %1287, 1
  %1293 = getelementptr inbounds double, ptr %1270, i64 %1292
  %1294 = load double, ptr %1293, align 8, !noalias !28
  %1295 = or disjoint i64 %1292, 1
  %1296 = getelementptr inbounds double, ptr %1270, i64 %1295
  %1297 = load double, ptr %1296, align 8, !noalias !28
  %1298 = fmul double %1289, %1289
  %1299 = fmul double %1294, %1294
  %1300 = fmul double %1297, %1297
  %1301 = fadd double %1299, %1300
  %1302 = fadd double %1298, %1301
  %1303 = fmul double %1291, %1291
  %1304 = fadd double %1284, %1303
  %1305 = getelementptr double, ptr %1259, i64 %1287
  br label %1310

1306:                                             ; preds = %1310
  %1307 = fadd double %1283, %1302
  %1308 = add nuw nsw i64 %1285, 1
  %1309 = icmp eq i64 %1308, %1252
  br i1 %1309, label %1271, label %1282, !llvm.loop !41

1310:                                             ; preds = %1282, %1310
  %1311 = phi i64 [ 0, %1282 ], [ %1318, %1310 ]
  %1312 = phi double [ %1304, %1282 ], [ %1317, %1310 ]
  %1313 = mul nsw i64 %1258, %1311
  %1314 = getelementptr double, ptr %1305, i64 %1313
  %1315 = load double, ptr %1314, align 8, !noalias !28
  %1316 = fmul double %1315, %1315
  %1317 = fadd double %1312, %1316
  %1318 = add nuw nsw i64 %1311, 1
  %1319 = icmp eq i64 %1318, 3
  br i1 %1319, label %1306, label %1310, !llvm.loop !42

1320:                                             ; preds = %1271, %1251
  %1321 = phi double [ 0.000000e+00, %1251 ], [ %1279, %1271 ]
  %1322 = fcmp ole double %1321, %435
  %1323 = and i64 %1244, 1
  %1324 = select i1 %1322, i64 %1323, i64 0
  br label %1325

1325:                                             ; preds = %1320, %1231
  %1326 = phi i64 [ %1324, %1320 ], [ %1244, %1231 ]
  %1327 = xor i64 %1326, -1
  %1328 = and i64 %1161, %1327
  %1329 = icmp eq i64 %1328, 0
  %1330 = select i1 %1329, i32 2, i32 0
  %1331 = select i1 %1329, double %870, double %1133
  br label %1332

1332:                                             ; preds = %1325, %966
  %1333 = phi double [ %961, %966 ], [ %885, %1325 ]
  %1334 = phi double [ %878, %966 ], [ %884, %1325 ]
  %1335 = phi double [ %877, %966 ], [ %883, %1325 ]
  %1336 = phi i64 [ %962, %966 ], [ %882, %1325 ]
  %1337 = phi i64 [ %963, %966 ], [ %881, %1325 ]
  %1338 = phi i64 [ %969, %966 ], [ %880, %1325 ]
  %1339 = phi double [ %878, %966 ], [ %1149, %1325 ]
  %1340 = phi double [ %877, %966 ], [ %1243, %1325 ]
  %1341 = phi i64 [ %969, %966 ], [ %1244, %1325 ]
  %1342 = phi i32 [ 1, %966 ], [ %1330, %1325 ]
  %1343 = phi i64 [ %872, %966 ], [ %1164, %1325 ]
  %1344 = phi i64 [ %888, %966 ], [ %1328, %1325 ]
  %1345 = phi double [ %870, %966 ], [ %1331, %1325 ]
  %1346 = icmp eq i32 %1342, 0
  br i1 %1346, label %866, label %1347

1347:                                             ; preds = %1332, %866
  %1348 = phi i32 [ %1342, %1332 ], [ 2, %866 ]
  %1349 = icmp eq i32 %1348, 2
  br i1 %1349, label %1350, label %1353

1350:                                             ; preds = %1347
  %1351 = xor i64 %1343, -1
  %1352 = and i64 %1341, %1351
  br label %1353

1353:                                             ; preds = %1347, %1350
  %1354 = phi double [ %961, %1350 ], [ %1333, %1347 ]
  %1355 = phi double [ %1339, %1350 ], [ %1334, %1347 ]
  %1356 = phi double [ %1340, %1350 ], [ %1335, %1347 ]
  %1357 = phi i64 [ %962, %1350 ], [ %1336, %1347 ]
  %1358 = phi i64 [ %963, %1350 ], [ %1337, %1347 ]
  %1359 = phi i64 [ %1352, %1350 ], [ %1338, %1347 ]
  %1360 = fadd double %686, %1354
  %1361 = fcmp ogt double %1356, 2.000000e+00
  %1362 = fcmp ogt double %1355, 1.000000e-03
  %1363 = and i1 %1362, %1361
  %1364 = icmp eq i64 %1359, %764
  br i1 %1364, label %1432, label %1365

1365:                                             ; preds = %1353
  %1366 = xor i64 %1359, -1
  %1367 = and i64 %764, %1366
  %1368 = load ptr, ptr %83, align 8, !noalias !15
  %1369 = getelementptr inbounds i8, ptr %1368, i64 16
  %1370 = load i64, ptr %1369, align 8, !noalias !15
  %1371 = xor i64 %1358, -1
  %1372 = and i64 %1370, %1371
  %1373 = and i64 %1372, %1367
  %1374 = tail call double @llvm.fabs.f64(double %1355)
  %1375 = fcmp ueq double %1374, 0x7FF0000000000000
  %1376 = select i1 %1375, double 4.000000e+00, double 7.000000e+00
  %1377 = and i64 %1358, 4294967295
  %1378 = icmp eq i64 %1377, 0
  %1379 = select i1 %1378, double %1376, double 3.000000e+00
  %1380 = icmp eq i64 %1367, 0
  %1381 = select i1 %1380, double %763, double %1379
  %1382 = icmp eq i64 %1373, 0
  br i1 %1382, label %1403, label %1383

1383:                                             ; preds = %1365
  %1384 = load i64, ptr %151, align 8, !noalias !15
  %1385 = icmp sgt i64 %1384, 0
  br i1 %1385, label %1386, label %1398

1386:                                             ; preds = %1383, %1386
  %1387 = phi i32 [ %1394, %1386 ], [ 0, %1383 ]
  %1388 = phi i64 [ %1395, %1386 ], [ 0, %1383 ]
  %1389 = load ptr, ptr %152, align 8, !noalias !15
  %1390 = getelementptr inbounds double, ptr %1389, i64 %1388
  %1391 = load double, ptr %1390, align 8, !noalias !15
  %1392 = fcmp une double %1391, 0.000000e+00
  %1393 = zext i1 %1392 to i32
  %1394 = or i32 %1387, %1393
  store double 0.000000e+00, ptr %1390, align 8, !noalias !15
  %1395 = add nuw nsw i64 %1388, 1
  %1396 = load i64, ptr %151, align 8, !noalias !15
  %1397 = icmp slt i64 %1395, %1396
  br i1 %1397, label %1386, label %1398, !llvm.loop !43

1398:                                             ; preds = %1386, %1383
  %1399 = phi i32 [ 0, %1383 ], [ %1394, %1386 ]
  %1400 = zext nneg i32 %1399 to i64
  %1401 = and i64 %1373, %1400
  %1402 = xor i64 %1401, -1
  br label %1403

1403:                                             ; preds = %1365, %1398
  %1404 = phi i64 [ %1402, %1398 ], [ -1, %1365 ]
  %1405 = and i64 %1404, %1373
  %1406 = getelementptr inbounds i8, ptr %1368, i64 24
  %1407 = load i64, ptr %1406, align 8, !noalias !15
  %1408 = and i64 %1407, %1404
  store i64 %1408, ptr %1406, align 8, !noalias !15
  %1409 = xor i64 %1405, -1
  %1410 = load i64, ptr %1369, align 8, !noalias !15
  %1411 = and i64 %1410, %1409
  store i64 %1411, ptr %1369, align 8, !noalias !15
  %1412 = fmul double %535, 5.000000e-01
  %1413 = icmp eq i64 %1405, 0
  %1414 = select i1 %1413, double %762, double %1412
  %1415 = fmul double %535, 2.500000e-01
  %1416 = select i1 %1378, double %1414, double %1415
  %1417 = load ptr, ptr %120, align 8, !noalias !15
  %1418 = getelementptr inbounds i8, ptr %1417, i64 8
  %1419 = load double, ptr %1418, align 8, !noalias !15
  %1420 = select i1 %1378, double %1419, double 0.000000e+00
  store double %1420, ptr %1418, align 8, !noalias !15
  %1421 = and i64 %1404, %1367
  %1422 = load ptr, ptr %83, align 8, !noalias !15
  %1423 = getelementptr inbounds i8, ptr %1422, i64 8
  %1424 = load i64, ptr %1423, align 8, !noalias !15
  %1425 = xor i64 %1421, -1
  %1426 = and i64 %1424, %1425
  %1427 = getelementptr inbounds i8, ptr %1422, i64 16
  %1428 = load i64, ptr %1427, align 8, !noalias !15
  %1429 = xor i64 %1428, -1
  %1430 = and i64 %1421, %1429
  %1431 = or disjoint i64 %1430, %1426
  store i64 %1431, ptr %1423, align 8, !noalias !15
  br label %1432

1432:                                             ; preds = %1403, %1353
  %1433 = phi double [ %762, %1353 ], [ %1416, %1403 ]
  %1434 = phi double [ %763, %1353 ], [ %1381, %1403 ]
  %1435 = icmp eq i64 %1359, 0
  %1436 = icmp ne i64 %1357, 0
  %1437 = select i1 %1435, i1 true, i1 %1436
  br i1 %1437, label %1985, label %1438

1438:                                             ; preds = %1432
  %1439 = icmp sgt i64 %545, 0
  br i1 %1439, label %1440, label %1442

1440:                                             ; preds = %1438
  %1441 = shl i64 %545, 4
  br label %1971

1442:                                             ; preds = %1971, %1438
  %1443 = load i64, ptr %550, align 8, !noalias !15
  %1444 = load ptr, ptr %81, align 8, !noalias !15
  %1445 = getelementptr inbounds i8, ptr %1444, i64 8
  %1446 = load i64, ptr %1445, align 8, !noalias !15
  %1447 = load ptr, ptr %154, align 8, !noalias !15
  %1448 = load ptr, ptr %155, align 8, !noalias !15
  %1449 = icmp sgt i64 %1446, 0
  br i1 %1449, label %1450, label %1452

1450:                                             ; preds = %1442
  %1451 = shl i64 %1446, 4
  br label %1637

1452:                                             ; preds = %1637, %1442
  %1453 = load i64, ptr %158, align 8, !noalias !15
  %1454 = load ptr, ptr %83, align 8, !noalias !15
  %1455 = getelementptr inbounds i8, ptr %1454, i64 40
  %1456 = load i64, ptr %1455, align 8, !noalias !15
  %1457 = load ptr, ptr %159, align 8, !noalias !15
  %1458 = load ptr, ptr %157, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1457, i64 noundef %1453, ptr noundef %1458, ptr noundef %1448) #10, !noalias !15
  %1459 = icmp sgt i64 %1456, 0
  br i1 %1459, label %1460, label %1464

1460:                                             ; preds = %1452
  %1461 = load ptr, ptr %159, align 8, !noalias !15
  %1462 = load ptr, ptr %157, align 8, !noalias !15
  %1463 = getelementptr inbounds double, ptr %1448, i64 %1453
  tail call fastcc void @real_solve_columns(ptr noundef %1461, i64 noundef %1453, ptr noundef %1462, ptr noundef %1463, i64 noundef %1456) #10, !noalias !15
  br label %1464

1464:                                             ; preds = %1452, %1460
  %1465 = load ptr, ptr %81, align 8, !noalias !15
  %1466 = getelementptr inbounds i8, ptr %1465, i64 24
  %1467 = load i64, ptr %1466, align 8, !noalias !15
  %1468 = load ptr, ptr %160, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %1448, ptr noundef %1468, ptr noundef nonnull %82, i64 noundef %1467) #10, !noalias !15
  %1469 = load double, ptr %8, align 8, !noalias !15
  %1470 = getelementptr inbounds i8, ptr %1465, i64 8
  %1471 = load i64, ptr %1470, align 8, !noalias !15
  %1472 = add nsw i64 %1471, -3
  %1473 = getelementptr i8, ptr %1468, i64 8
  %1474 = getelementptr i8, ptr %1468, i64 16
  %1475 = getelementptr i8, ptr %1468, i64 24
  %1476 = icmp slt i64 %1467, %1472
  br i1 %1476, label %1484, label %1477

1477:                                             ; preds = %1484, %1464
  %1478 = phi double [ 0.000000e+00, %1464 ], [ %1493, %1484 ]
  %1479 = phi double [ 0.000000e+00, %1464 ], [ %1497, %1484 ]
  %1480 = phi double [ 0.000000e+00, %1464 ], [ %1501, %1484 ]
  %1481 = phi double [ 0.000000e+00, %1464 ], [ %1505, %1484 ]
  %1482 = phi i64 [ %1467, %1464 ], [ %1506, %1484 ]
  %1483 = icmp slt i64 %1482, %1471
  br i1 %1483, label %1508, label %1517

1484:                                             ; preds = %1464, %1484
  %1485 = phi i64 [ %1506, %1484 ], [ %1467, %1464 ]
  %1486 = phi double [ %1505, %1484 ], [ 0.000000e+00, %1464 ]
  %1487 = phi double [ %1501, %1484 ], [ 0.000000e+00, %1464 ]
  %1488 = phi double [ %1497, %1484 ], [ 0.000000e+00, %1464 ]
  %1489 = phi double [ %1493, %1484 ], [ 0.000000e+00, %1464 ]
  %1490 = getelementptr inbounds double, ptr %1468, i64 %1485
  %1491 = load double, ptr %1490, align 8, !noalias !15
  %1492 = fmul double %1491, 0.000000e+00
  %1493 = fadd double %1489, %1492
  %1494 = getelementptr double, ptr %1473, i64 %1485
  %1495 = load double, ptr %1494, align 8, !noalias !15
  %1496 = fmul double %1495, 0.000000e+00
  %1497 = fadd double %1488, %1496
  %1498 = getelementptr double, ptr %1474, i64 %1485
  %1499 = load double, ptr %1498, align 8, !noalias !15
  %1500 = fmul double %1499, 0.000000e+00
  %1501 = fadd double %1487, %1500
  %1502 = getelementptr double, ptr %1475, i64 %1485
  %1503 = load double, ptr %1502, align 8, !noalias !15
  %1504 = fmul double %1503, 0.000000e+00
  %1505 = fadd double %1486, %1504
  %1506 = add nsw i64 %1485, 4
  %1507 = icmp slt i64 %1506, %1472
  br i1 %1507, label %1484, label %1477, !llvm.loop !44

1508:                                             ; preds = %1477, %1508
  %1509 = phi i64 [ %1515, %1508 ], [ %1482, %1477 ]
  %1510 = phi double [ %1514, %1508 ], [ %1478, %1477 ]
  %1511 = getelementptr inbounds double, ptr %1468, i64 %1509
  %1512 = load double, ptr %1511, align 8, !noalias !15
  %1513 = fmul double %1512, 0.000000e+00
  %1514 = fadd double %1510, %1513
  %1515 = add nsw i64 %1509, 1
  %1516 = icmp eq i64 %1515, %1471
  br i1 %1516, label %1517, label %1508, !llvm.loop !45

1517:                                             ; preds = %1508, %1477
  %1518 = phi double [ %1478, %1477 ], [ %1514, %1508 ]
  %1519 = fadd double %1479, %1518
  %1520 = fadd double %1480, %1481
  %1521 = fadd double %1520, %1519
  %1522 = fadd double %1469, %1521
  %1523 = getelementptr inbounds i8, ptr %1465, i64 48
  %1524 = load i64, ptr %1523, align 8, !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %6, i8 0, i64 64, i1 false), !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %7, i8 0, i64 64, i1 false), !noalias !15
  %1525 = icmp eq i64 %1524, 0
  br i1 %1525, label %1626, label %1526

1526:                                             ; preds = %1517
  %1527 = add nsw i64 %1467, 7
  %1528 = sdiv i64 %1527, 8
  %1529 = shl nsw i64 %1528, 3
  %1530 = tail call i64 @llvm.smin.i64(i64 %1529, i64 %1524)
  %1531 = icmp slt i64 %1467, %1530
  br i1 %1531, label %1532, label %1566

1532:                                             ; preds = %1526
  %1533 = load ptr, ptr %82, align 8, !noalias !15
  %1534 = load ptr, ptr %161, align 8, !noalias !15
  %1535 = load ptr, ptr %88, align 8, !noalias !15
  br label %1536

1536:                                             ; preds = %1532, %1536
  %1537 = phi i64 [ %1467, %1532 ], [ %1564, %1536 ]
  %1538 = getelementptr inbounds double, ptr %1533, i64 %1537
  %1539 = load double, ptr %1538, align 8, !noalias !15
  %1540 = tail call double @llvm.fabs.f64(double %1539)
  %1541 = getelementptr inbounds double, ptr %1468, i64 %1537
  %1542 = load double, ptr %1541, align 8, !noalias !15
  %1543 = tail call double @llvm.fabs.f64(double %1542)
  %1544 = fcmp ogt double %1540, %1543
  %1545 = select i1 %1544, double %1540, double %1543
  %1546 = getelementptr inbounds double, ptr %1534, i64 %1537
  %1547 = load double, ptr %1546, align 8, !noalias !15
  %1548 = getelementptr inbounds double, ptr %1535, i64 %1537
  %1549 = load double, ptr %1548, align 8, !noalias !15
  %1550 = fmul double %1545, %1549
  %1551 = fadd double %1547, %1550
  %1552 = fdiv double 1.000000e+00, %1551
  %1553 = getelementptr inbounds double, ptr %1448, i64 %1537
  %1554 = load double, ptr %1553, align 8, !noalias !15
  %1555 = fmul double %1554, %1552
  %1556 = srem i64 %1537, 8
  %1557 = getelementptr inbounds double, ptr %6, i64 %1556
  %1558 = load double, ptr %1557, align 8, !noalias !15
  %1559 = fmul double %1555, %1555
  %1560 = fadd double %1558, %1559
  store double %1560, ptr %1557, align 8, !noalias !15
  %1561 = getelementptr inbounds double, ptr %7, i64 %1556
  %1562 = load double, ptr %1561, align 8, !noalias !15
  %1563 = fadd double %1562, %1559
  store double %1563, ptr %1561, align 8, !noalias !15
  %1564 = add nsw i64 %1537, 1
  %1565 = icmp eq i64 %1564, %1530
  br i1 %1565, label %1566, label %1536, !llvm.loop !46

1566:                                             ; preds = %1536, %1526
  %1567 = phi i64 [ %1467, %1526 ], [ %1564, %1536 ]
  %1568 = load <8 x double>, ptr %6, align 16, !noalias !15
  %1569 = load <8 x double>, ptr %7, align 16, !noalias !15
  %1570 = icmp slt i64 %1567, %1524
  br i1 %1570, label %1571, label %1606

1571:                                             ; preds = %1566
  %1572 = load ptr, ptr %82, align 8, !noalias !15
  %1573 = load ptr, ptr %162, align 8, !noalias !15
  %1574 = load ptr, ptr %88, align 8, !noalias !15
  br label %1575

1575:                                             ; preds = %1571, %1575
  %1576 = phi i64 [ %1567, %1571 ], [ %1604, %1575 ]
  %1577 = phi <8 x double> [ %1568, %1571 ], [ %1602, %1575 ]
  %1578 = phi <8 x double> [ %1569, %1571 ], [ %1603, %1575 ]
  %1579 = getelementptr inbounds double, ptr %1572, i64 %1576
  %1580 = load <8 x double>, ptr %1579, align 8, !noalias !15
  %1581 = fneg <8 x double> %1580
  %1582 = fcmp ogt <8 x double> %1580, zeroinitializer
  %1583 = select <8 x i1> %1582, <8 x double> %1580, <8 x double> %1581
  %1584 = getelementptr inbounds double, ptr %1468, i64 %1576
  %1585 = load <8 x double>, ptr %1584, align 8, !noalias !15
  %1586 = fneg <8 x double> %1585
  %1587 = fcmp ogt <8 x double> %1585, zeroinitializer
  %1588 = select <8 x i1> %1587, <8 x double> %1585, <8 x double> %1586
  %1589 = fcmp ogt <8 x double> %1583, %1588
  %1590 = select <8 x i1> %1589, <8 x double> %1583, <8 x double> %1588
  %1591 = getelementptr inbounds double, ptr %1573, i64 %1576
  %1592 = load <8 x double>, ptr %1591, align 8, !noalias !15
  %1593 = getelementptr inbounds double, ptr %1574, i64 %1576
  %1594 = load <8 x double>, ptr %1593, align 8, !noalias !15
  %1595 = fmul <8 x double> %1594, %1590
  %1596 = fadd <8 x double> %1592, %1595
  %1597 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1596
  %1598 = getelementptr inbounds double, ptr %1448, i64 %1576
  %1599 = load <8 x double>, ptr %1598, align 8, !noalias !15
  %1600 = fmul <8 x double> %1599, %1597
  %1601 = fmul <8 x double> %1600, %1600
  %1602 = fadd <8 x double> %1577, %1601
  %1603 = fadd <8 x double> %1578, %1601
  %1604 = add nsw i64 %1576, 8
  %1605 = icmp slt i64 %1604, %1524
  br i1 %1605, label %1575, label %1606, !llvm.loop !47

1606:                                             ; preds = %1575, %1566
  %1607 = phi <8 x double> [ %1569, %1566 ], [ %1603, %1575 ]
  %1608 = phi <8 x double> [ %1568, %1566 ], [ %1602, %1575 ]
  store <8 x double> %1608, ptr %6, align 16, !noalias !15
  store <8 x double> %1607, ptr %7, align 16, !noalias !15
  br label %1618

1609:                                             ; preds = %1618
  %1610 = sub nsw i64 %1524, %1467
  %1611 = sitofp i64 %1610 to double
  %1612 = fdiv double %1623, %1611
  %1613 = tail call double @llvm.sqrt.f64(double %1612)
  %1614 = fcmp ule double %535, %239
  %1615 = fcmp ogt double %1613, %1522
  %1616 = select i1 %1615, double %1613, double %1522
  %1617 = select i1 %1614, double %1522, double %1616
  br label %1626

1618:                                             ; preds = %1606, %1618
  %1619 = phi i64 [ 0, %1606 ], [ %1624, %1618 ]
  %1620 = phi double [ 0.000000e+00, %1606 ], [ %1623, %1618 ]
  %1621 = getelementptr inbounds double, ptr %6, i64 %1619
  %1622 = load double, ptr %1621, align 8, !noalias !15
  %1623 = fadd double %1620, %1622
  %1624 = add nuw nsw i64 %1619, 1
  %1625 = icmp eq i64 %1624, 8
  br i1 %1625, label %1609, label %1618, !llvm.loop !48

1626:                                             ; preds = %1517, %1609
  %1627 = phi double [ %1617, %1609 ], [ %1522, %1517 ]
  %1628 = fcmp olt double %1627, 1.000000e+00
  %1629 = zext i1 %1628 to i64
  %1630 = xor i64 %1629, -1
  %1631 = and i64 %1443, %1630
  %1632 = and i64 %1631, %1359
  %1633 = and i64 %1359, %1629
  %1634 = icmp eq i64 %1632, 0
  br i1 %1634, label %1904, label %1635

1635:                                             ; preds = %1626
  %1636 = icmp sgt i64 %1446, 0
  br i1 %1636, label %1696, label %1662

1637:                                             ; preds = %1450, %1637
  %1638 = phi i64 [ 0, %1450 ], [ %1660, %1637 ]
  %1639 = load ptr, ptr %128, align 8, !noalias !15
  %1640 = getelementptr inbounds double, ptr %1639, i64 %1638
  %1641 = load double, ptr %1640, align 8, !noalias !15
  %1642 = fmul double %1641, 0x402418FD8BAFFE05
  %1643 = getelementptr double, ptr %1639, i64 %1446
  %1644 = getelementptr double, ptr %1643, i64 %1638
  %1645 = load double, ptr %1644, align 8, !noalias !15
  %1646 = fmul double %1645, 0x3FF61D41B2D54580
  %1647 = fsub double %1646, %1642
  %1648 = getelementptr i8, ptr %1639, i64 %1451
  %1649 = getelementptr double, ptr %1648, i64 %1638
  %1650 = load double, ptr %1649, align 8, !noalias !15
  %1651 = fmul double %1650, 0x3FD5555555555555
  %1652 = fsub double %1647, %1651
  %1653 = fdiv double %1652, %535
  %1654 = getelementptr inbounds double, ptr %1447, i64 %1638
  store double %1653, ptr %1654, align 8, !noalias !15
  %1655 = load ptr, ptr %156, align 8, !noalias !15
  %1656 = getelementptr inbounds double, ptr %1655, i64 %1638
  %1657 = load double, ptr %1656, align 8, !noalias !15
  %1658 = fadd double %1657, %1653
  %1659 = getelementptr inbounds double, ptr %1448, i64 %1638
  store double %1658, ptr %1659, align 8, !noalias !15
  %1660 = add nuw nsw i64 %1638, 1
  %1661 = icmp eq i64 %1660, %1446
  br i1 %1661, label %1452, label %1637, !llvm.loop !49

1662:                                             ; preds = %1696, %1635
  %1663 = and i64 %1632, 4294967295
  %1664 = icmp eq i64 %1663, 0
  %1665 = select i1 %1664, double 0.000000e+00, double 1.000000e+00
  %1666 = fadd double %1360, %1665
  %1667 = load ptr, ptr %164, align 8, !noalias !15
  %1668 = load ptr, ptr %165, align 8, !noalias !15
  %1669 = load ptr, ptr %166, align 8, !noalias !15
  store double %458, ptr %1669, align 8, !noalias !15
  %1670 = load ptr, ptr %81, align 8, !noalias !15
  %1671 = getelementptr inbounds i8, ptr %1670, i64 40
  %1672 = load i64, ptr %1671, align 8, !noalias !15
  %1673 = icmp eq i64 %1672, 0
  br i1 %1673, label %1675, label %1674

1674:                                             ; preds = %1662
  tail call fastcc void @settle(ptr noundef nonnull %81) #10, !noalias !15
  br label %1675

1675:                                             ; preds = %1674, %1662
  %1676 = load i64, ptr %167, align 8, !noalias !15
  %1677 = icmp sgt i64 %1676, 0
  br i1 %1677, label %1678, label %1679

1678:                                             ; preds = %1675
  tail call fastcc void @sample(ptr noundef nonnull %81) #10, !noalias !15
  br label %1679

1679:                                             ; preds = %1678, %1675
  %1680 = load ptr, ptr %81, align 8, !noalias !15
  %1681 = load i64, ptr %1680, align 8, !noalias !15
  %1682 = load ptr, ptr %166, align 8, !noalias !15
  %1683 = load ptr, ptr %168, align 8, !noalias !15
  %1684 = load ptr, ptr %169, align 8, !noalias !15
  %1685 = inttoptr i64 %1681 to ptr
  %1686 = load ptr, ptr %1685, align 8, !noalias !15
  %1687 = tail call i32 %1686(ptr noundef %1682, ptr noundef %1667, ptr noundef %1683, ptr noundef %1684, ptr noundef %1668) #11, !noalias !15
  %1688 = sext i32 %1687 to i64
  %1689 = icmp slt i32 %1687, 0
  %1690 = select i1 %1689, i64 %1688, i64 %1357
  %1691 = trunc i64 %1632 to i32
  %1692 = and i32 %1687, %1691
  %1693 = icmp eq i32 %1692, 0
  %1694 = select i1 %1693, double %1434, double 3.000000e+00
  %1695 = icmp sgt i64 %1446, 0
  br i1 %1695, label %1893, label %1708

1696:                                             ; preds = %1635, %1696
  %1697 = phi i64 [ %1706, %1696 ], [ 0, %1635 ]
  %1698 = load ptr, ptr %163, align 8, !noalias !15
  %1699 = load ptr, ptr %82, align 8, !noalias !15
  %1700 = getelementptr inbounds double, ptr %1699, i64 %1697
  %1701 = load double, ptr %1700, align 8, !noalias !15
  %1702 = getelementptr inbounds double, ptr %1448, i64 %1697
  %1703 = load double, ptr %1702, align 8, !noalias !15
  %1704 = fadd double %1701, %1703
  %1705 = getelementptr inbounds double, ptr %1698, i64 %1697
  store double %1704, ptr %1705, align 8, !noalias !15
  %1706 = add nuw nsw i64 %1697, 1
  %1707 = icmp eq i64 %1706, %1446
  br i1 %1707, label %1662, label %1696, !llvm.loop !50

1708:                                             ; preds = %1893, %1679
  %1709 = load i64, ptr %158, align 8, !noalias !15
  %1710 = load ptr, ptr %83, align 8, !noalias !15
  %1711 = getelementptr inbounds i8, ptr %1710, i64 40
  %1712 = load i64, ptr %1711, align 8, !noalias !15
  %1713 = load ptr, ptr %159, align 8, !noalias !15
  %1714 = load ptr, ptr %157, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1713, i64 noundef %1709, ptr noundef %1714, ptr noundef %1448) #10, !noalias !15
  %1715 = icmp sgt i64 %1712, 0
  br i1 %1715, label %1716, label %1720

1716:                                             ; preds = %1708
  %1717 = load ptr, ptr %159, align 8, !noalias !15
  %1718 = load ptr, ptr %157, align 8, !noalias !15
  %1719 = getelementptr inbounds double, ptr %1448, i64 %1709
  tail call fastcc void @real_solve_columns(ptr noundef %1717, i64 noundef %1709, ptr noundef %1718, ptr noundef %1719, i64 noundef %1712) #10, !noalias !15
  br label %1720

1720:                                             ; preds = %1708, %1716
  %1721 = load ptr, ptr %81, align 8, !noalias !15
  %1722 = getelementptr inbounds i8, ptr %1721, i64 24
  %1723 = load i64, ptr %1722, align 8, !noalias !15
  %1724 = load ptr, ptr %160, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %9, ptr noundef %1448, ptr noundef %1724, ptr noundef nonnull %82, i64 noundef %1723) #10, !noalias !15
  %1725 = load double, ptr %9, align 8, !noalias !15
  %1726 = getelementptr inbounds i8, ptr %1721, i64 8
  %1727 = load i64, ptr %1726, align 8, !noalias !15
  %1728 = add nsw i64 %1727, -3
  %1729 = getelementptr i8, ptr %1724, i64 8
  %1730 = getelementptr i8, ptr %1724, i64 16
  %1731 = getelementptr i8, ptr %1724, i64 24
  %1732 = icmp slt i64 %1723, %1728
  br i1 %1732, label %1740, label %1733

1733:                                             ; preds = %1740, %1720
  %1734 = phi double [ 0.000000e+00, %1720 ], [ %1749, %1740 ]
  %1735 = phi double [ 0.000000e+00, %1720 ], [ %1753, %1740 ]
  %1736 = phi double [ 0.000000e+00, %1720 ], [ %1757, %1740 ]
  %1737 = phi double [ 0.000000e+00, %1720 ], [ %1761, %1740 ]
  %1738 = phi i64 [ %1723, %1720 ], [ %1762, %1740 ]
  %1739 = icmp slt i64 %1738, %1727
  br i1 %1739, label %1764, label %1773

1740:                                             ; preds = %1720, %1740
  %1741 = phi i64 [ %1762, %1740 ], [ %1723, %1720 ]
  %1742 = phi double [ %1761, %1740 ], [ 0.000000e+00, %1720 ]
  %1743 = phi double [ %1757, %1740 ], [ 0.000000e+00, %1720 ]
  %1744 = phi double [ %1753, %1740 ], [ 0.000000e+00, %1720 ]
  %1745 = phi double [ %1749, %1740 ], [ 0.000000e+00, %1720 ]
  %1746 = getelementptr inbounds double, ptr %1724, i64 %1741
  %1747 = load double, ptr %1746, align 8, !noalias !15
  %1748 = fmul double %1747, 0.000000e+00
  %1749 = fadd double %1745, %1748
  %1750 = getelementptr double, ptr %1729, i64 %1741
  %1751 = load double, ptr %1750, align 8, !noalias !15
  %1752 = fmul double %1751, 0.000000e+00
  %1753 = fadd double %1744, %1752
  %1754 = getelementptr double, ptr %1730, i64 %1741
  %1755 = load double, ptr %1754, align 8, !noalias !15
  %1756 = fmul double %1755, 0.000000e+00
  %1757 = fadd double %1743, %1756
  %1758 = getelementptr double, ptr %1731, i64 %1741
  %1759 = load double, ptr %1758, align 8, !noalias !15
  %1760 = fmul double %1759, 0.000000e+00
  %1761 = fadd double %1742, %1760
  %1762 = add nsw i64 %1741, 4
  %1763 = icmp slt i64 %1762, %1728
  br i1 %1763, label %1740, label %1733, !llvm.loop !44

1764:                                             ; preds = %1733, %1764
  %1765 = phi i64 [ %1771, %1764 ], [ %1738, %1733 ]
  %1766 = phi double [ %1770, %1764 ], [ %1734, %1733 ]
  %1767 = getelementptr inbounds double, ptr %1724, i64 %1765
  %1768 = load double, ptr %1767, align 8, !noalias !15
  %1769 = fmul double %1768, 0.000000e+00
  %1770 = fadd double %1766, %1769
  %1771 = add nsw i64 %1765, 1
  %1772 = icmp eq i64 %1771, %1727
  br i1 %1772, label %1773, label %1764, !llvm.loop !45

1773:                                             ; preds = %1764, %1733
  %1774 = phi double [ %1734, %1733 ], [ %1770, %1764 ]
  %1775 = fadd double %1735, %1774
  %1776 = fadd double %1736, %1737
  %1777 = fadd double %1776, %1775
  %1778 = fadd double %1725, %1777
  %1779 = getelementptr inbounds i8, ptr %1721, i64 48
  %1780 = load i64, ptr %1779, align 8, !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %4, i8 0, i64 64, i1 false), !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %5, i8 0, i64 64, i1 false), !noalias !15
  %1781 = icmp eq i64 %1780, 0
  br i1 %1781, label %1882, label %1782

1782:                                             ; preds = %1773
  %1783 = add nsw i64 %1723, 7
  %1784 = sdiv i64 %1783, 8
  %1785 = shl nsw i64 %1784, 3
  %1786 = tail call i64 @llvm.smin.i64(i64 %1785, i64 %1780)
  %1787 = icmp slt i64 %1723, %1786
  br i1 %1787, label %1788, label %1822

1788:                                             ; preds = %1782
  %1789 = load ptr, ptr %82, align 8, !noalias !15
  %1790 = load ptr, ptr %170, align 8, !noalias !15
  %1791 = load ptr, ptr %88, align 8, !noalias !15
  br label %1792

1792:                                             ; preds = %1788, %1792
  %1793 = phi i64 [ %1723, %1788 ], [ %1820, %1792 ]
  %1794 = getelementptr inbounds double, ptr %1789, i64 %1793
  %1795 = load double, ptr %1794, align 8, !noalias !15
  %1796 = tail call double @llvm.fabs.f64(double %1795)
  %1797 = getelementptr inbounds double, ptr %1724, i64 %1793
  %1798 = load double, ptr %1797, align 8, !noalias !15
  %1799 = tail call double @llvm.fabs.f64(double %1798)
  %1800 = fcmp ogt double %1796, %1799
  %1801 = select i1 %1800, double %1796, double %1799
  %1802 = getelementptr inbounds double, ptr %1790, i64 %1793
  %1803 = load double, ptr %1802, align 8, !noalias !15
  %1804 = getelementptr inbounds double, ptr %1791, i64 %1793
  %1805 = load double, ptr %1804, align 8, !noalias !15
  %1806 = fmul double %1801, %1805
  %1807 = fadd double %1803, %1806
  %1808 = fdiv double 1.000000e+00, %1807
  %1809 = getelementptr inbounds double, ptr %1448, i64 %1793
  %1810 = load double, ptr %1809, align 8, !noalias !15
  %1811 = fmul double %1810, %1808
  %1812 = srem i64 %1793, 8
  %1813 = getelementptr inbounds double, ptr %4, i64 %1812
  %1814 = load double, ptr %1813, align 8, !noalias !15
  %1815 = fmul double %1811, %1811
  %1816 = fadd double %1814, %1815
  store double %1816, ptr %1813, align 8, !noalias !15
  %1817 = getelementptr inbounds double, ptr %5, i64 %1812
  %1818 = load double, ptr %1817, align 8, !noalias !15
  %1819 = fadd double %1818, %1815
  store double %1819, ptr %1817, align 8, !noalias !15
  %1820 = add nsw i64 %1793, 1
  %1821 = icmp eq i64 %1820, %1786
  br i1 %1821, label %1822, label %1792, !llvm.loop !46

1822:                                             ; preds = %1792, %1782
  %1823 = phi i64 [ %1723, %1782 ], [ %1820, %1792 ]
  %1824 = load <8 x double>, ptr %4, align 16, !noalias !15
  %1825 = load <8 x double>, ptr %5, align 16, !noalias !15
  %1826 = icmp slt i64 %1823, %1780
  br i1 %1826, label %1827, label %1862

1827:                                             ; preds = %1822
  %1828 = load ptr, ptr %82, align 8, !noalias !15
  %1829 = load ptr, ptr %171, align 8, !noalias !15
  %1830 = load ptr, ptr %88, align 8, !noalias !15
  br label %1831

1831:                                             ; preds = %1827, %1831
  %1832 = phi i64 [ %1823, %1827 ], [ %1860, %1831 ]
  %1833 = phi <8 x double> [ %1824, %1827 ], [ %1858, %1831 ]
  %1834 = phi <8 x double> [ %1825, %1827 ], [ %1859, %1831 ]
  %1835 = getelementptr inbounds double, ptr %1828, i64 %1832
  %1836 = load <8 x double>, ptr %1835, align 8, !noalias !15
  %1837 = fneg <8 x double> %1836
  %1838 = fcmp ogt <8 x double> %1836, zeroinitializer
  %1839 = select <8 x i1> %1838, <8 x double> %1836, <8 x double> %1837
  %1840 = getelementptr inbounds double, ptr %1724, i64 %1832
  %1841 = load <8 x double>, ptr %1840, align 8, !noalias !15
  %1842 = fneg <8 x double> %1841
  %1843 = fcmp ogt <8 x double> %1841, zeroinitializer
  %1844 = select <8 x i1> %1843, <8 x double> %1841, <8 x double> %1842
  %1845 = fcmp ogt <8 x double> %1839, %1844
  %1846 = select <8 x i1> %1845, <8 x double> %1839, <8 x double> %1844
  %1847 = getelementptr inbounds double, ptr %1829, i64 %1832
  %1848 = load <8 x double>, ptr %1847, align 8, !noalias !15
  %1849 = getelementptr inbounds double, ptr %1830, i64 %1832
  %1850 = load <8 x double>, ptr %1849, align 8, !noalias !15
  %1851 = fmul <8 x double> %1850, %1846
  %1852 = fadd <8 x double> %1848, %1851
  %1853 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1852
  %1854 = getelementptr inbounds double, ptr %1448, i64 %1832
  %1855 = load <8 x double>, ptr %1854, align 8, !noalias !15
  %1856 = fmul <8 x double> %1855, %1853
  %1857 = fmul <8 x double> %1856, %1856
  %1858 = fadd <8 x double> %1833, %1857
  %1859 = fadd <8 x double> %1834, %1857
  %1860 = add nsw i64 %1832, 8
  %1861 = icmp slt i64 %1860, %1780
  br i1 %1861, label %1831, label %1862, !llvm.loop !47

1862:                                             ; preds = %1831, %1822
  %1863 = phi <8 x double> [ %1825, %1822 ], [ %1859, %1831 ]
  %1864 = phi <8 x double> [ %1824, %1822 ], [ %1858, %1831 ]
  store <8 x double> %1864, ptr %4, align 16, !noalias !15
  store <8 x double> %1863, ptr %5, align 16, !noalias !15
  br label %1874

1865:                                             ; preds = %1874
  %1866 = sub nsw i64 %1780, %1723
  %1867 = sitofp i64 %1866 to double
  %1868 = fdiv double %1879, %1867
  %1869 = tail call double @llvm.sqrt.f64(double %1868)
  %1870 = fcmp ule double %535, %239
  %1871 = fcmp ogt double %1869, %1778
  %1872 = select i1 %1871, double %1869, double %1778
  %1873 = select i1 %1870, double %1778, double %1872
  br label %1882

1874:                                             ; preds = %1862, %1874
  %1875 = phi i64 [ 0, %1862 ], [ %1880, %1874 ]
  %1876 = phi double [ 0.000000e+00, %1862 ], [ %1879, %1874 ]
  %1877 = getelementptr inbounds double, ptr %4, i64 %1875
  %1878 = load double, ptr %1877, align 8, !noalias !15
  %1879 = fadd double %1876, %1878
  %1880 = add nuw nsw i64 %1875, 1
  %1881 = icmp eq i64 %1880, 8
  br i1 %1881, label %1865, label %1874, !llvm.loop !48

1882:                                             ; preds = %1773, %1865
  %1883 = phi double [ %1873, %1865 ], [ %1778, %1773 ]
  %1884 = xor i64 %1688, -1
  %1885 = and i64 %1632, %1884
  %1886 = fcmp olt double %1883, 1.000000e+00
  %1887 = and i64 %1885, 1
  %1888 = select i1 %1886, i64 %1887, i64 0
  %1889 = or i64 %1888, %1633
  %1890 = and i64 %1885, 4294967295
  %1891 = icmp eq i64 %1890, 0
  %1892 = select i1 %1891, double %1627, double %1883
  br label %1904

1893:                                             ; preds = %1679, %1893
  %1894 = phi i64 [ %1902, %1893 ], [ 0, %1679 ]
  %1895 = load ptr, ptr %165, align 8, !noalias !15
  %1896 = getelementptr inbounds double, ptr %1895, i64 %1894
  %1897 = load double, ptr %1896, align 8, !noalias !15
  %1898 = getelementptr inbounds double, ptr %1447, i64 %1894
  %1899 = load double, ptr %1898, align 8, !noalias !15
  %1900 = fadd double %1897, %1899
  %1901 = getelementptr inbounds double, ptr %1448, i64 %1894
  store double %1900, ptr %1901, align 8, !noalias !15
  %1902 = add nuw nsw i64 %1894, 1
  %1903 = icmp eq i64 %1902, %1446
  br i1 %1903, label %1708, label %1893, !llvm.loop !51

1904:                                             ; preds = %1626, %1882
  %1905 = phi double [ %1360, %1626 ], [ %1666, %1882 ]
  %1906 = phi i64 [ %1357, %1626 ], [ %1690, %1882 ]
  %1907 = phi i64 [ %1633, %1626 ], [ %1889, %1882 ]
  %1908 = phi double [ %1434, %1626 ], [ %1694, %1882 ]
  %1909 = phi double [ %1627, %1626 ], [ %1892, %1882 ]
  %1910 = fcmp olt double %1909, 1.000000e-10
  %1911 = select i1 %1910, double 1.000000e-10, double %1909
  %1912 = load ptr, ptr %120, align 8, !noalias !15
  %1913 = getelementptr inbounds i8, ptr %1912, i64 24
  %1914 = load double, ptr %1913, align 8, !noalias !15
  %1915 = fadd double %1356, 1.200000e+01
  %1916 = fdiv double 0x4027666666666667, %1915
  %1917 = tail call double @llvm.sqrt.f64(double %1911)
  %1918 = tail call double @llvm.sqrt.f64(double %1917)
  %1919 = fdiv double 1.000000e+00, %1918
  %1920 = fmul double %1916, %1919
  %1921 = fcmp ogt double %1920, 2.000000e-01
  %1922 = select i1 %1921, double %1920, double 2.000000e-01
  %1923 = tail call double @llvm.fabs.f64(double %1909)
  %1924 = fcmp ueq double %1923, 0x7FF0000000000000
  %1925 = select i1 %1924, double 2.500000e-01, double %1922
  %1926 = fmul double %535, %1925
  %1927 = getelementptr inbounds i8, ptr %1912, i64 16
  %1928 = load double, ptr %1927, align 8, !noalias !15
  %1929 = fdiv double %535, %1928
  %1930 = fdiv double %1914, %1911
  %1931 = tail call double @llvm.sqrt.f64(double %1930)
  %1932 = tail call double @llvm.sqrt.f64(double %1931)
  %1933 = fmul double %1929, %1932
  %1934 = fcmp ule double %1914, 0.000000e+00
  %1935 = fcmp olt double %1933, 1.000000e+00
  %1936 = select i1 %1935, double %1933, double 1.000000e+00
  %1937 = select i1 %1934, double 1.000000e+00, double %1936
  %1938 = fmul double %1920, %1937
  %1939 = fcmp olt double %1938, 1.000000e+01
  %1940 = select i1 %1939, double %1938, double 1.000000e+01
  %1941 = fcmp ule double %1940, 1.000000e+00
  %1942 = fcmp uge double %1940, 1.200000e+00
  %1943 = or i1 %1941, %1942
  %1944 = select i1 %1943, i1 true, i1 %1363
  %1945 = load double, ptr %1912, align 8, !noalias !15
  %1946 = fcmp ogt double %1940, 2.000000e-01
  %1947 = select i1 %1946, double %1940, double 2.000000e-01
  %1948 = fmul double %535, %1947
  %1949 = select i1 %1944, double %1948, double %1945
  %1950 = icmp eq i64 %1907, 0
  %1951 = select i1 %1950, double %1926, double %1949
  %1952 = and i64 %1359, 4294967295
  %1953 = icmp eq i64 %1952, 0
  %1954 = select i1 %1953, double %1433, double %1951
  %1955 = xor i64 %1907, -1
  %1956 = and i64 %1359, %1955
  %1957 = load ptr, ptr %83, align 8, !noalias !15
  %1958 = getelementptr inbounds i8, ptr %1957, i64 32
  %1959 = load i64, ptr %1958, align 8, !noalias !15
  %1960 = or i64 %1959, %1956
  store i64 %1960, ptr %1958, align 8, !noalias !15
  %1961 = load ptr, ptr %83, align 8, !noalias !15
  %1962 = getelementptr inbounds i8, ptr %1961, i64 8
  %1963 = load i64, ptr %1962, align 8, !noalias !15
  %1964 = xor i64 %1956, -1
  %1965 = and i64 %1963, %1964
  %1966 = getelementptr inbounds i8, ptr %1961, i64 16
  %1967 = load i64, ptr %1966, align 8, !noalias !15
  %1968 = xor i64 %1967, -1
  %1969 = and i64 %1956, %1968
  %1970 = or disjoint i64 %1969, %1965
  store i64 %1970, ptr %1962, align 8, !noalias !15
  br label %1985

1971:                                             ; preds = %1440, %1971
  %1972 = phi i64 [ 0, %1440 ], [ %1983, %1971 ]
  %1973 = load ptr, ptr %153, align 8, !noalias !15
  %1974 = load ptr, ptr %82, align 8, !noalias !15
  %1975 = getelementptr inbounds double, ptr %1974, i64 %1972
  %1976 = load double, ptr %1975, align 8, !noalias !15
  %1977 = load ptr, ptr %128, align 8, !noalias !15
  %1978 = getelementptr i8, ptr %1977, i64 %1441
  %1979 = getelementptr double, ptr %1978, i64 %1972
  %1980 = load double, ptr %1979, align 8, !noalias !15
  %1981 = fadd double %1976, %1980
  %1982 = getelementptr inbounds double, ptr %1973, i64 %1972
  store double %1981, ptr %1982, align 8, !noalias !15
  %1983 = add nuw nsw i64 %1972, 1
  %1984 = icmp eq i64 %1983, %545
  br i1 %1984, label %1442, label %1971, !llvm.loop !52

1985:                                             ; preds = %1904, %1432, %761, %674
  %1986 = phi double [ %465, %674 ], [ %465, %761 ], [ %1354, %1432 ], [ %1354, %1904 ]
  %1987 = phi double [ %464, %674 ], [ %464, %761 ], [ %1355, %1432 ], [ %1355, %1904 ]
  %1988 = phi double [ %463, %674 ], [ %463, %761 ], [ %1356, %1432 ], [ %1356, %1904 ]
  %1989 = phi i64 [ %462, %674 ], [ %462, %761 ], [ %1357, %1432 ], [ %1357, %1904 ]
  %1990 = phi i64 [ %461, %674 ], [ %461, %761 ], [ %1358, %1432 ], [ %1358, %1904 ]
  %1991 = phi i64 [ %460, %674 ], [ %460, %761 ], [ %1359, %1432 ], [ %1359, %1904 ]
  %1992 = phi i1 [ false, %674 ], [ false, %761 ], [ %1363, %1432 ], [ %1363, %1904 ]
  %1993 = phi double [ 2.000000e+00, %674 ], [ %763, %761 ], [ %1434, %1432 ], [ %1908, %1904 ]
  %1994 = phi double [ 0.000000e+00, %674 ], [ 0.000000e+00, %761 ], [ 0.000000e+00, %1432 ], [ %1909, %1904 ]
  %1995 = phi double [ %459, %674 ], [ %762, %761 ], [ %1433, %1432 ], [ %1954, %1904 ]
  %1996 = phi double [ %657, %674 ], [ %686, %761 ], [ %1360, %1432 ], [ %1905, %1904 ]
  %1997 = phi i64 [ 0, %674 ], [ %700, %761 ], [ %700, %1432 ], [ %700, %1904 ]
  %1998 = phi i64 [ 1, %674 ], [ 0, %761 ], [ %1357, %1432 ], [ %1906, %1904 ]
  %1999 = phi i64 [ 0, %674 ], [ 0, %761 ], [ 0, %1432 ], [ %1907, %1904 ]
  %2000 = zext i1 %1992 to i64
  %2001 = fptosi double %1996 to i64
  %2002 = load i64, ptr %436, align 8
  %2003 = add nsw i64 %2002, %2001
  store i64 %2003, ptr %436, align 8
  %2004 = load i64, ptr %437, align 8
  %2005 = add nsw i64 %2004, %549
  store i64 %2005, ptr %437, align 8
  %2006 = load i64, ptr %438, align 8
  %2007 = add nsw i64 %2006, %1997
  store i64 %2007, ptr %438, align 8
  %2008 = icmp eq i64 %1998, 0
  br i1 %2008, label %2009, label %2637

2009:                                             ; preds = %1985
  %2010 = icmp eq i64 %1999, 0
  br i1 %2010, label %2011, label %2035

2011:                                             ; preds = %2009
  %2012 = load i64, ptr %423, align 8
  %2013 = add nsw i64 %2012, 1
  store i64 %2013, ptr %423, align 8
  %2014 = fptosi double %1993 to i64
  store i64 %2014, ptr %446, align 8
  %2015 = fcmp ult double %1994, 1.000000e+00
  %2016 = fcmp ueq double %1994, 0x7FF0000000000000
  %2017 = or i1 %2015, %2016
  br i1 %2017, label %2637, label %2018, !llvm.loop !53

2018:                                             ; preds = %2011
  %2019 = load i64, ptr %214, align 8
  %2020 = icmp eq i64 %2019, 0
  br i1 %2020, label %2637, label %2021, !llvm.loop !53

2021:                                             ; preds = %2018
  %2022 = tail call fastcc double @knot_after(ptr noundef nonnull %81, double noundef %458) #10
  %2023 = fmul double %535, 1.000000e-03
  %2024 = fsub double %534, %2023
  %2025 = tail call double @llvm.fabs.f64(double %534)
  %2026 = fmul double %2025, 0x3D10000000000000
  %2027 = fsub double %2024, %2026
  %2028 = fcmp ogt double %2027, %2022
  br i1 %2028, label %2029, label %2637, !llvm.loop !53

2029:                                             ; preds = %2021
  %2030 = tail call fastcc double @knot_after(ptr noundef nonnull %81, double noundef %2022) #10
  %2031 = fadd double %458, %1995
  %2032 = fcmp ugt double %2030, %2031
  br i1 %2032, label %2033, label %2637, !llvm.loop !53

2033:                                             ; preds = %2029
  %2034 = fsub double %2022, %458
  br label %2637, !llvm.loop !53

2035:                                             ; preds = %2009
  br i1 %256, label %2036, label %2064

2036:                                             ; preds = %2035
  %2037 = load ptr, ptr %172, align 8
  %2038 = load ptr, ptr %82, align 8
  %2039 = load ptr, ptr %89, align 8
  %2040 = getelementptr inbounds i8, ptr %2039, i64 56
  %2041 = load i64, ptr %2040, align 8
  %2042 = inttoptr i64 %2041 to ptr
  %2043 = tail call i64 %2042(ptr noundef %0, double noundef %534, ptr noundef %2037, ptr noundef %2038) #11
  %2044 = icmp eq i64 %2043, 0
  br i1 %2044, label %2064, label %2045

2045:                                             ; preds = %2036
  %2046 = load i64, ptr %423, align 8
  %2047 = add nsw i64 %2046, 1
  store i64 %2047, ptr %423, align 8
  store i64 6, ptr %439, align 8
  %2048 = fmul double %535, 2.500000e-01
  %2049 = load ptr, ptr %83, align 8
  %2050 = getelementptr inbounds i8, ptr %2049, i64 32
  %2051 = load i64, ptr %2050, align 8
  %2052 = or i64 %2051, 1
  store i64 %2052, ptr %2050, align 8
  %2053 = load ptr, ptr %83, align 8
  %2054 = getelementptr inbounds i8, ptr %2053, i64 8
  %2055 = load i64, ptr %2054, align 8
  %2056 = and i64 %2055, -2
  %2057 = getelementptr inbounds i8, ptr %2053, i64 16
  %2058 = load i64, ptr %2057, align 8
  %2059 = and i64 %2058, 1
  %2060 = or disjoint i64 %2059, %2056
  %2061 = xor i64 %2060, 1
  store i64 %2061, ptr %2054, align 8
  %2062 = load ptr, ptr %173, align 8
  %2063 = getelementptr inbounds i8, ptr %2062, i64 8
  store double 0.000000e+00, ptr %2063, align 8
  br label %2637, !llvm.loop !53

2064:                                             ; preds = %2036, %2035
  %2065 = load i64, ptr %422, align 8
  %2066 = add nsw i64 %2065, 1
  store i64 %2066, ptr %422, align 8
  store double %534, ptr %223, align 8
  store double %535, ptr %440, align 8
  %2067 = load ptr, ptr %81, align 8
  %2068 = getelementptr inbounds i8, ptr %2067, i64 8
  %2069 = load i64, ptr %2068, align 8
  %2070 = load i64, ptr %174, align 8
  %2071 = load ptr, ptr %175, align 8
  %2072 = load ptr, ptr %176, align 8
  %2073 = load ptr, ptr %177, align 8
  %2074 = load ptr, ptr %178, align 8
  br label %2090

2075:                                             ; preds = %2090
  %2076 = icmp sgt i64 %2069, 0
  br i1 %2076, label %2077, label %2150

2077:                                             ; preds = %2075
  %2078 = load double, ptr %13, align 16
  %2079 = load double, ptr %179, align 8
  %2080 = getelementptr double, ptr %2071, i64 %2069
  %2081 = load double, ptr %180, align 16
  %2082 = shl i64 %2069, 4
  %2083 = getelementptr i8, ptr %2071, i64 %2082
  %2084 = load double, ptr %14, align 16
  %2085 = load double, ptr %181, align 8
  %2086 = load double, ptr %182, align 16
  %2087 = getelementptr inbounds double, ptr %2072, i64 %2070
  %2088 = shl nsw i64 %2070, 4
  %2089 = getelementptr inbounds i8, ptr %2072, i64 %2088
  br label %2101

2090:                                             ; preds = %2064, %2090
  %2091 = phi i64 [ 0, %2064 ], [ %2099, %2090 ]
  %2092 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %2091
  %2093 = getelementptr inbounds i8, ptr %2092, i64 8
  %2094 = load double, ptr %2093, align 8
  %2095 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %2091
  store double %2094, ptr %2095, align 8
  %2096 = getelementptr inbounds i8, ptr %2092, i64 16
  %2097 = load double, ptr %2096, align 8
  %2098 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %2091
  store double %2097, ptr %2098, align 8
  %2099 = add nuw nsw i64 %2091, 1
  %2100 = icmp eq i64 %2099, 3
  br i1 %2100, label %2075, label %2090, !llvm.loop !54

2101:                                             ; preds = %2077, %2138
  %2102 = phi i64 [ 0, %2077 ], [ %2139, %2138 ]
  %2103 = getelementptr inbounds double, ptr %2071, i64 %2102
  %2104 = load double, ptr %2103, align 8
  %2105 = fmul double %2078, %2104
  %2106 = getelementptr double, ptr %2080, i64 %2102
  %2107 = load double, ptr %2106, align 8
  %2108 = fmul double %2079, %2107
  %2109 = fadd double %2105, %2108
  %2110 = getelementptr double, ptr %2083, i64 %2102
  %2111 = load double, ptr %2110, align 8
  %2112 = fmul double %2081, %2111
  %2113 = fadd double %2109, %2112
  %2114 = fmul double %2104, %2084
  %2115 = fmul double %2107, %2085
  %2116 = fadd double %2114, %2115
  %2117 = fmul double %2111, %2086
  %2118 = fadd double %2116, %2117
  %2119 = load ptr, ptr %183, align 8
  %2120 = getelementptr inbounds double, ptr %2119, i64 %2102
  %2121 = load double, ptr %2120, align 8
  %2122 = load ptr, ptr %82, align 8
  %2123 = getelementptr inbounds double, ptr %2122, i64 %2102
  %2124 = load double, ptr %2123, align 8
  %2125 = fsub double %2121, %2124
  %2126 = getelementptr inbounds double, ptr %2072, i64 %2102
  store double %2125, ptr %2126, align 8
  %2127 = fneg double %2113
  %2128 = fsub double %2127, %2118
  %2129 = getelementptr inbounds double, ptr %2087, i64 %2102
  store double %2128, ptr %2129, align 8
  %2130 = fneg double %2118
  %2131 = getelementptr inbounds double, ptr %2089, i64 %2102
  store double %2130, ptr %2131, align 8
  %2132 = load ptr, ptr %82, align 8
  %2133 = getelementptr inbounds double, ptr %2132, i64 %2102
  %2134 = load double, ptr %2133, align 8
  %2135 = getelementptr inbounds double, ptr %2073, i64 %2102
  store double %2134, ptr %2135, align 8
  %2136 = getelementptr double, ptr %2072, i64 %2102
  %2137 = getelementptr double, ptr %2073, i64 %2102
  br label %2141

2138:                                             ; preds = %2141
  %2139 = add nuw nsw i64 %2102, 1
  %2140 = icmp eq i64 %2139, %2069
  br i1 %2140, label %2150, label %2101, !llvm.loop !55

2141:                                             ; preds = %2101, %2141
  %2142 = phi i64 [ 0, %2101 ], [ %2143, %2141 ]
  %2143 = add nuw nsw i64 %2142, 1
  %2144 = mul nuw nsw i64 %2069, %2143
  %2145 = mul nsw i64 %2070, %2142
  %2146 = getelementptr double, ptr %2136, i64 %2145
  %2147 = load double, ptr %2146, align 8
  %2148 = getelementptr double, ptr %2137, i64 %2144
  store double %2147, ptr %2148, align 8
  %2149 = icmp eq i64 %2143, 3
  br i1 %2149, label %2138, label %2141, !llvm.loop !56

2150:                                             ; preds = %2138, %2075
  %2151 = fcmp olt double %1994, 1.000000e-10
  %2152 = select i1 %2151, double 1.000000e-10, double %1994
  %2153 = getelementptr inbounds i8, ptr %2074, i64 8
  store double %535, ptr %2153, align 8
  %2154 = getelementptr inbounds i8, ptr %2074, i64 16
  store double %535, ptr %2154, align 8
  %2155 = getelementptr inbounds i8, ptr %2074, i64 24
  store double %2152, ptr %2155, align 8
  %2156 = load ptr, ptr %83, align 8
  %2157 = getelementptr inbounds i8, ptr %2156, i64 8
  %2158 = load i64, ptr %2157, align 8
  %2159 = and i64 %2158, -2
  %2160 = or disjoint i64 %2159, %2000
  store i64 %2160, ptr %2157, align 8
  %2161 = load ptr, ptr %83, align 8
  %2162 = getelementptr inbounds i8, ptr %2161, i64 16
  %2163 = load i64, ptr %2162, align 8
  %2164 = and i64 %2163, -2
  store i64 %2164, ptr %2162, align 8
  %2165 = load ptr, ptr %83, align 8
  %2166 = getelementptr inbounds i8, ptr %2165, i64 32
  %2167 = load i64, ptr %2166, align 8
  %2168 = and i64 %2167, -2
  store i64 %2168, ptr %2166, align 8
  %2169 = load ptr, ptr %0, align 8
  %2170 = getelementptr inbounds i8, ptr %2169, i64 24
  %2171 = load i64, ptr %2170, align 8
  %2172 = load ptr, ptr %101, align 8
  %2173 = getelementptr inbounds i8, ptr %2172, i64 8
  %2174 = load i64, ptr %2173, align 8
  %2175 = icmp eq i64 %2174, 0
  br i1 %2175, label %2222, label %2176

2176:                                             ; preds = %2150
  %2177 = load i64, ptr %2172, align 8
  %2178 = load ptr, ptr %81, align 8
  %2179 = getelementptr inbounds i8, ptr %2178, i64 8
  %2180 = load i64, ptr %2179, align 8
  %2181 = load ptr, ptr %184, align 8
  %2182 = load i64, ptr %185, align 8
  %2183 = mul nsw i64 %2182, %2177
  %2184 = getelementptr inbounds double, ptr %2181, i64 %2183
  %2185 = getelementptr inbounds double, ptr %2184, i64 %2182
  store double %458, ptr %2184, align 8
  %2186 = getelementptr inbounds i8, ptr %2184, i64 8
  store double %535, ptr %2186, align 8
  store double %534, ptr %2185, align 8
  %2187 = getelementptr inbounds i8, ptr %2185, i64 8
  store double 0.000000e+00, ptr %2187, align 8
  %2188 = icmp sgt i64 %2180, 0
  br i1 %2188, label %2189, label %2192

2189:                                             ; preds = %2176
  %2190 = getelementptr i8, ptr %2184, i64 16
  %2191 = icmp sgt i64 %2171, 0
  br label %2195

2192:                                             ; preds = %2207, %2176
  %2193 = add nsw i64 %2177, 1
  %2194 = load ptr, ptr %101, align 8
  store i64 %2193, ptr %2194, align 8
  br label %2222

2195:                                             ; preds = %2189, %2207
  %2196 = phi i64 [ 0, %2189 ], [ %2208, %2207 ]
  %2197 = load ptr, ptr %82, align 8
  %2198 = getelementptr inbounds double, ptr %2197, i64 %2196
  %2199 = load double, ptr %2198, align 8
  %2200 = add nuw nsw i64 %2196, 2
  %2201 = getelementptr inbounds double, ptr %2184, i64 %2200
  store double %2199, ptr %2201, align 8
  %2202 = load ptr, ptr %186, align 8
  %2203 = getelementptr inbounds double, ptr %2202, i64 %2196
  %2204 = load double, ptr %2203, align 8
  %2205 = getelementptr inbounds double, ptr %2185, i64 %2200
  store double %2204, ptr %2205, align 8
  %2206 = getelementptr double, ptr %2190, i64 %2196
  br i1 %2191, label %2210, label %2207

2207:                                             ; preds = %2210, %2195
  %2208 = add nuw nsw i64 %2196, 1
  %2209 = icmp eq i64 %2208, %2180
  br i1 %2209, label %2192, label %2195, !llvm.loop !57

2210:                                             ; preds = %2195, %2210
  %2211 = phi i64 [ %2218, %2210 ], [ 0, %2195 ]
  %2212 = load ptr, ptr %187, align 8
  %2213 = load i64, ptr %188, align 8
  %2214 = mul nsw i64 %2213, %2211
  %2215 = getelementptr double, ptr %2212, i64 %2214
  %2216 = getelementptr double, ptr %2215, i64 %2196
  %2217 = load double, ptr %2216, align 8
  %2218 = add nuw nsw i64 %2211, 1
  %2219 = mul nuw nsw i64 %2218, %2180
  %2220 = getelementptr double, ptr %2206, i64 %2219
  store double %2217, ptr %2220, align 8
  %2221 = icmp eq i64 %2218, %2171
  br i1 %2221, label %2207, label %2210, !llvm.loop !58

2222:                                             ; preds = %2150, %2192
  br i1 %260, label %2223, label %2331

2223:                                             ; preds = %2222
  %2224 = load ptr, ptr %90, align 8
  %2225 = load ptr, ptr %81, align 8
  %2226 = getelementptr inbounds i8, ptr %2225, i64 8
  %2227 = load i64, ptr %2226, align 8
  %2228 = load ptr, ptr %189, align 8
  %2229 = getelementptr inbounds i8, ptr %2224, i64 32
  %2230 = load i64, ptr %2229, align 8
  %2231 = getelementptr inbounds double, ptr %2228, i64 %2230
  %2232 = load ptr, ptr %190, align 8
  %2233 = getelementptr inbounds i8, ptr %2224, i64 24
  %2234 = load i64, ptr %2233, align 8
  %2235 = icmp eq i64 %2234, 0
  br i1 %2235, label %2328, label %2236

2236:                                             ; preds = %2223
  %2237 = getelementptr inbounds i8, ptr %2224, i64 40
  %2238 = load i64, ptr %2237, align 8
  %2239 = icmp sgt i64 %2238, 0
  br i1 %2239, label %2240, label %2244

2240:                                             ; preds = %2236
  %2241 = getelementptr double, ptr %2232, i64 %2227
  %2242 = shl i64 %2227, 4
  %2243 = getelementptr i8, ptr %2232, i64 %2242
  br label %2298

2244:                                             ; preds = %2298, %2236
  %2245 = load ptr, ptr %192, align 8
  %2246 = load ptr, ptr %90, align 8
  %2247 = getelementptr inbounds i8, ptr %2246, i64 8
  %2248 = load i64, ptr %2247, align 8
  %2249 = load ptr, ptr %193, align 8
  %2250 = load ptr, ptr %189, align 8
  %2251 = getelementptr inbounds i8, ptr %2246, i64 32
  %2252 = load i64, ptr %2251, align 8
  %2253 = getelementptr inbounds i8, ptr %2246, i64 40
  %2254 = load i64, ptr %2253, align 8
  %2255 = getelementptr double, ptr %2250, i64 %2252
  %2256 = getelementptr double, ptr %2255, i64 %2254
  store double %535, ptr %2256, align 8
  %2257 = load ptr, ptr %192, align 8
  store double %458, ptr %2257, align 8
  %2258 = load ptr, ptr %90, align 8
  %2259 = getelementptr inbounds i8, ptr %2258, i64 24
  %2260 = load i64, ptr %2259, align 8
  %2261 = load ptr, ptr %82, align 8
  %2262 = load ptr, ptr %189, align 8
  %2263 = load ptr, ptr %194, align 8
  %2264 = inttoptr i64 %2260 to ptr
  %2265 = load ptr, ptr %2264, align 8
  %2266 = tail call i32 %2265(ptr noundef %2245, ptr noundef %2261, ptr noundef %2262, ptr noundef %2263, ptr noundef %2249) #11
  %2267 = icmp eq i32 %2266, 0
  br i1 %2267, label %2268, label %2328

2268:                                             ; preds = %2244
  %2269 = icmp slt i64 %2248, 1
  br i1 %2269, label %2295, label %2270

2270:                                             ; preds = %2268
  %2271 = load ptr, ptr %195, align 8
  %2272 = getelementptr double, ptr %2249, i64 %2248
  br label %2273

2273:                                             ; preds = %2270, %2291
  %2274 = phi i1 [ %2269, %2270 ], [ %2293, %2291 ]
  %2275 = phi i64 [ 0, %2270 ], [ %2292, %2291 ]
  %2276 = getelementptr inbounds i64, ptr %2271, i64 %2275
  %2277 = load i64, ptr %2276, align 8
  %2278 = and i64 %2277, 2
  %2279 = icmp eq i64 %2278, 0
  br i1 %2279, label %2280, label %2291

2280:                                             ; preds = %2273
  %2281 = getelementptr inbounds double, ptr %2249, i64 %2275
  %2282 = load double, ptr %2281, align 8
  %2283 = load ptr, ptr %196, align 8
  %2284 = getelementptr inbounds i64, ptr %2283, i64 %2275
  %2285 = load i64, ptr %2284, align 8
  %2286 = sitofp i64 %2285 to double
  %2287 = fmul double %2282, %2286
  %2288 = getelementptr double, ptr %2272, i64 %2275
  %2289 = load double, ptr %2288, align 8
  %2290 = fcmp ogt double %2287, %2289
  br i1 %2290, label %2291, label %2295

2291:                                             ; preds = %2280, %2273
  %2292 = add nuw nsw i64 %2275, 1
  %2293 = icmp sge i64 %2292, %2248
  %2294 = icmp eq i64 %2292, %2248
  br i1 %2294, label %2295, label %2273, !llvm.loop !59

2295:                                             ; preds = %2291, %2280, %2268
  %2296 = phi i1 [ %2269, %2268 ], [ %2293, %2291 ], [ %2274, %2280 ]
  %2297 = zext i1 %2296 to i32
  br label %2328

2298:                                             ; preds = %2240, %2298
  %2299 = phi i64 [ 0, %2240 ], [ %2325, %2298 ]
  %2300 = load ptr, ptr %191, align 8
  %2301 = getelementptr inbounds double, ptr %2300, i64 %2299
  %2302 = load double, ptr %2301, align 8
  %2303 = load ptr, ptr %82, align 8
  %2304 = getelementptr inbounds double, ptr %2303, i64 %2299
  %2305 = load double, ptr %2304, align 8
  %2306 = fsub double %2302, %2305
  %2307 = tail call double @llvm.fabs.f64(double %2306)
  %2308 = getelementptr inbounds double, ptr %2232, i64 %2299
  %2309 = load double, ptr %2308, align 8
  %2310 = tail call double @llvm.fabs.f64(double %2309)
  %2311 = getelementptr double, ptr %2241, i64 %2299
  %2312 = load double, ptr %2311, align 8
  %2313 = tail call double @llvm.fabs.f64(double %2312)
  %2314 = fcmp ogt double %2310, %2313
  %2315 = select i1 %2314, double %2310, double %2313
  %2316 = getelementptr double, ptr %2243, i64 %2299
  %2317 = load double, ptr %2316, align 8
  %2318 = tail call double @llvm.fabs.f64(double %2317)
  %2319 = fcmp ogt double %2315, %2318
  %2320 = select i1 %2319, double %2315, double %2318
  %2321 = fcmp ogt double %2320, %2307
  %2322 = select i1 %2321, double %2320, double %2307
  %2323 = fmul double %2322, 8.000000e+00
  %2324 = getelementptr inbounds double, ptr %2231, i64 %2299
  store double %2323, ptr %2324, align 8
  %2325 = add nuw nsw i64 %2299, 1
  %2326 = load i64, ptr %2237, align 8
  %2327 = icmp slt i64 %2325, %2326
  br i1 %2327, label %2298, label %2244, !llvm.loop !60

2328:                                             ; preds = %2295, %2244, %2223
  %2329 = phi i32 [ 0, %2223 ], [ 0, %2244 ], [ %2297, %2295 ]
  %2330 = icmp eq i32 %2329, 0
  br label %2331

2331:                                             ; preds = %2328, %2222
  %2332 = phi i1 [ false, %2222 ], [ %2330, %2328 ]
  br i1 %2332, label %2338, label %2333

2333:                                             ; preds = %2331
  %2334 = load i64, ptr %441, align 8
  %2335 = getelementptr inbounds double, ptr %232, i64 %2334
  %2336 = load double, ptr %2335, align 8
  %2337 = fcmp ugt double %2336, %534
  br i1 %2337, label %2563, label %2338

2338:                                             ; preds = %2333, %2331
  %2339 = load ptr, ptr %84, align 8
  br i1 %2332, label %2340, label %2351

2340:                                             ; preds = %2338
  %2341 = load ptr, ptr %90, align 8
  %2342 = getelementptr inbounds i8, ptr %2341, i64 16
  %2343 = load i64, ptr %2342, align 8
  %2344 = inttoptr i64 %2343 to ptr
  %2345 = tail call i64 %2344(ptr noundef %0, double noundef %458, double noundef %535) #11
  %2346 = icmp eq i64 %2345, -6
  br i1 %2346, label %2347, label %2348

2347:                                             ; preds = %2340
  store double %458, ptr %2339, align 8
  br label %2526

2348:                                             ; preds = %2340
  %2349 = getelementptr inbounds i8, ptr %2339, i64 48
  %2350 = load double, ptr %2349, align 8
  br label %2351

2351:                                             ; preds = %2348, %2338
  %2352 = phi double [ %2350, %2348 ], [ 1.000000e+00, %2338 ]
  %2353 = phi i64 [ %2345, %2348 ], [ 0, %2338 ]
  %2354 = fcmp oeq double %2352, 1.000000e+00
  br i1 %2354, label %2355, label %2357

2355:                                             ; preds = %2351
  %2356 = load double, ptr %2339, align 8
  br label %2360

2357:                                             ; preds = %2351
  %2358 = fmul double %535, %2352
  %2359 = fadd double %458, %2358
  br label %2360

2360:                                             ; preds = %2357, %2355
  %2361 = phi double [ %2356, %2355 ], [ %2359, %2357 ]
  %2362 = icmp eq i64 %2353, -4
  %2363 = select i1 %2362, i64 -4, i64 0
  br i1 %2362, label %2421, label %2364

2364:                                             ; preds = %2360
  %2365 = fcmp olt double %2352, 1.000000e+00
  %2366 = load ptr, ptr %81, align 8
  %2367 = getelementptr inbounds i8, ptr %2366, i64 8
  %2368 = load i64, ptr %2367, align 8
  %2369 = load i64, ptr %87, align 8
  %2370 = load ptr, ptr %86, align 8
  %2371 = load ptr, ptr %85, align 8
  %2372 = getelementptr inbounds i8, ptr %2371, i64 48
  %2373 = load i64, ptr %2372, align 8
  %2374 = icmp slt i64 %2373, %2369
  br i1 %2374, label %2375, label %2417

2375:                                             ; preds = %2364, %2413
  %2376 = phi i64 [ %2414, %2413 ], [ undef, %2364 ]
  %2377 = phi i64 [ %2415, %2413 ], [ %2373, %2364 ]
  %2378 = getelementptr inbounds double, ptr %2370, i64 %2377
  %2379 = load double, ptr %2378, align 8
  %2380 = fcmp olt double %2379, %2361
  %2381 = fcmp oeq double %2379, %2361
  %2382 = and i1 %2365, %2381
  %2383 = or i1 %2380, %2382
  br i1 %2383, label %2384, label %2417

2384:                                             ; preds = %2375
  %2385 = fsub double %2379, %458
  %2386 = fdiv double %2385, %535
  %2387 = mul nsw i64 %2377, %2368
  %2388 = getelementptr inbounds double, ptr %1, i64 %2387
  %2389 = load ptr, ptr %197, align 8
  %2390 = insertelement <8 x double> poison, double %2386, i64 0
  %2391 = shufflevector <8 x double> %2390, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2391, ptr %2389, align 8
  %2392 = load ptr, ptr %82, align 8
  %2393 = load ptr, ptr %176, align 8
  %2394 = load i64, ptr %174, align 8
  %2395 = load ptr, ptr %0, align 8
  %2396 = getelementptr inbounds i8, ptr %2395, i64 24
  %2397 = load i64, ptr %2396, align 8
  %2398 = load ptr, ptr %197, align 8
  %2399 = load ptr, ptr %81, align 8
  %2400 = getelementptr inbounds i8, ptr %2399, i64 16
  %2401 = load i64, ptr %2400, align 8
  tail call fastcc void @nested(ptr noundef %2388, ptr noundef %2392, ptr noundef %2393, i64 noundef %2394, i64 noundef %2397, ptr noundef %2398, i64 noundef %2401) #10
  %2402 = load ptr, ptr %89, align 8
  %2403 = load i64, ptr %2402, align 8
  %2404 = icmp eq i64 %2403, 1
  br i1 %2404, label %2405, label %2413

2405:                                             ; preds = %2384
  %2406 = load double, ptr %2378, align 8
  %2407 = getelementptr inbounds i8, ptr %2402, i64 56
  %2408 = load i64, ptr %2407, align 8
  %2409 = inttoptr i64 %2408 to ptr
  %2410 = tail call i64 %2409(ptr noundef %0, double noundef %2406, ptr noundef %2388, ptr noundef null) #11
  %2411 = icmp eq i64 %2410, 0
  %2412 = select i1 %2411, i64 %2376, i64 %2410
  br i1 %2411, label %2413, label %2421

2413:                                             ; preds = %2405, %2384
  %2414 = phi i64 [ %2412, %2405 ], [ %2376, %2384 ]
  %2415 = add i64 %2377, 1
  %2416 = icmp eq i64 %2415, %2369
  br i1 %2416, label %2417, label %2375, !llvm.loop !61

2417:                                             ; preds = %2413, %2375, %2364
  %2418 = phi i64 [ %2373, %2364 ], [ %2369, %2413 ], [ %2377, %2375 ]
  %2419 = load ptr, ptr %85, align 8
  %2420 = getelementptr inbounds i8, ptr %2419, i64 48
  store i64 %2418, ptr %2420, align 8
  br label %2421

2421:                                             ; preds = %2405, %2417, %2360
  %2422 = phi i64 [ %2363, %2360 ], [ 0, %2417 ], [ %2412, %2405 ]
  %2423 = icmp eq i64 %2422, 0
  %2424 = icmp ne i64 %2353, 0
  %2425 = fcmp olt double %2352, 1.000000e+00
  %2426 = and i1 %2425, %2423
  %2427 = and i1 %2424, %2426
  br i1 %2427, label %2428, label %2465

2428:                                             ; preds = %2421
  %2429 = load ptr, ptr %198, align 8
  %2430 = load ptr, ptr %199, align 8
  %2431 = insertelement <8 x double> poison, double %2352, i64 0
  %2432 = shufflevector <8 x double> %2431, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2432, ptr %2430, align 8
  %2433 = load ptr, ptr %82, align 8
  %2434 = load ptr, ptr %176, align 8
  %2435 = load i64, ptr %174, align 8
  %2436 = load ptr, ptr %0, align 8
  %2437 = getelementptr inbounds i8, ptr %2436, i64 24
  %2438 = load i64, ptr %2437, align 8
  %2439 = load ptr, ptr %199, align 8
  %2440 = load ptr, ptr %81, align 8
  %2441 = getelementptr inbounds i8, ptr %2440, i64 16
  %2442 = load i64, ptr %2441, align 8
  tail call fastcc void @nested(ptr noundef %2429, ptr noundef %2433, ptr noundef %2434, i64 noundef %2435, i64 noundef %2438, ptr noundef %2439, i64 noundef %2442) #10
  %2443 = load i64, ptr %200, align 8
  %2444 = icmp sgt i64 %2443, 0
  br i1 %2444, label %2449, label %2445

2445:                                             ; preds = %2449, %2428
  %2446 = load ptr, ptr %89, align 8
  %2447 = load i64, ptr %2446, align 8
  %2448 = icmp eq i64 %2447, 1
  br i1 %2448, label %2459, label %2465

2449:                                             ; preds = %2428, %2449
  %2450 = phi i64 [ %2456, %2449 ], [ 0, %2428 ]
  %2451 = load ptr, ptr %198, align 8
  %2452 = getelementptr inbounds double, ptr %2451, i64 %2450
  %2453 = load double, ptr %2452, align 8
  %2454 = load ptr, ptr %201, align 8
  %2455 = getelementptr inbounds double, ptr %2454, i64 %2450
  store double %2453, ptr %2455, align 8
  %2456 = add nuw nsw i64 %2450, 1
  %2457 = load i64, ptr %200, align 8
  %2458 = icmp slt i64 %2456, %2457
  br i1 %2458, label %2449, label %2445, !llvm.loop !62

2459:                                             ; preds = %2445
  %2460 = load ptr, ptr %202, align 8
  %2461 = getelementptr inbounds i8, ptr %2446, i64 56
  %2462 = load i64, ptr %2461, align 8
  %2463 = inttoptr i64 %2462 to ptr
  %2464 = tail call i64 %2463(ptr noundef %0, double noundef %2361, ptr noundef %2460, ptr noundef null) #11
  br label %2465

2465:                                             ; preds = %2459, %2445, %2421
  %2466 = phi i64 [ %2464, %2459 ], [ 0, %2445 ], [ %2422, %2421 ]
  %2467 = icmp eq i64 %2466, 0
  br i1 %2467, label %2470, label %2468

2468:                                             ; preds = %2465
  store double %458, ptr %2339, align 8
  %2469 = getelementptr inbounds i8, ptr %2339, i64 8
  store double %535, ptr %2469, align 8
  br label %2526

2470:                                             ; preds = %2465
  br i1 %2354, label %2471, label %2509

2471:                                             ; preds = %2470
  %2472 = load ptr, ptr %203, align 8
  %2473 = load ptr, ptr %81, align 8
  %2474 = getelementptr inbounds i8, ptr %2473, i64 8
  %2475 = load i64, ptr %2474, align 8
  %2476 = load i64, ptr %87, align 8
  %2477 = load ptr, ptr %86, align 8
  %2478 = load ptr, ptr %85, align 8
  %2479 = getelementptr inbounds i8, ptr %2478, i64 48
  %2480 = load i64, ptr %2479, align 8
  %2481 = icmp slt i64 %2480, %2476
  br i1 %2481, label %2482, label %2505

2482:                                             ; preds = %2471
  %2483 = icmp sgt i64 %2475, 0
  br label %2484

2484:                                             ; preds = %2482, %2495
  %2485 = phi i64 [ %2480, %2482 ], [ %2496, %2495 ]
  %2486 = getelementptr inbounds double, ptr %2477, i64 %2485
  %2487 = load double, ptr %2486, align 8
  %2488 = load ptr, ptr %84, align 8
  %2489 = load double, ptr %2488, align 8
  %2490 = fcmp ugt double %2487, %2489
  br i1 %2490, label %2505, label %2491

2491:                                             ; preds = %2484
  br i1 %2483, label %2492, label %2495

2492:                                             ; preds = %2491
  %2493 = mul nsw i64 %2485, %2475
  %2494 = getelementptr double, ptr %1, i64 %2493
  br label %2498

2495:                                             ; preds = %2498, %2491
  %2496 = add i64 %2485, 1
  %2497 = icmp eq i64 %2496, %2476
  br i1 %2497, label %2505, label %2484, !llvm.loop !13

2498:                                             ; preds = %2492, %2498
  %2499 = phi i64 [ 0, %2492 ], [ %2503, %2498 ]
  %2500 = getelementptr inbounds double, ptr %2472, i64 %2499
  %2501 = load double, ptr %2500, align 8
  %2502 = getelementptr double, ptr %2494, i64 %2499
  store double %2501, ptr %2502, align 8
  %2503 = add nuw nsw i64 %2499, 1
  %2504 = icmp eq i64 %2503, %2475
  br i1 %2504, label %2495, label %2498, !llvm.loop !14

2505:                                             ; preds = %2495, %2484, %2471
  %2506 = phi i64 [ %2480, %2471 ], [ %2476, %2495 ], [ %2485, %2484 ]
  %2507 = load ptr, ptr %85, align 8
  %2508 = getelementptr inbounds i8, ptr %2507, i64 48
  store i64 %2506, ptr %2508, align 8
  br label %2509

2509:                                             ; preds = %2505, %2470
  br i1 %2424, label %2510, label %2526

2510:                                             ; preds = %2509
  %2511 = load i64, ptr %204, align 8
  %2512 = icmp sgt i64 %2511, 0
  br i1 %2512, label %2516, label %2513

2513:                                             ; preds = %2516, %2510
  store double %2361, ptr %2339, align 8
  %2514 = getelementptr inbounds i8, ptr %2339, i64 8
  store double 0.000000e+00, ptr %2514, align 8
  %2515 = load ptr, ptr %85, align 8
  store i64 0, ptr %2515, align 8
  br label %2526

2516:                                             ; preds = %2510, %2516
  %2517 = phi i64 [ %2523, %2516 ], [ 0, %2510 ]
  %2518 = load ptr, ptr %205, align 8
  %2519 = getelementptr inbounds double, ptr %2518, i64 %2517
  %2520 = load double, ptr %2519, align 8
  %2521 = load ptr, ptr %82, align 8
  %2522 = getelementptr inbounds double, ptr %2521, i64 %2517
  store double %2520, ptr %2522, align 8
  %2523 = add nuw nsw i64 %2517, 1
  %2524 = load i64, ptr %204, align 8
  %2525 = icmp slt i64 %2523, %2524
  br i1 %2525, label %2516, label %2513, !llvm.loop !63

2526:                                             ; preds = %2347, %2468, %2509, %2513
  %2527 = phi i64 [ -6, %2347 ], [ %2466, %2468 ], [ %2353, %2513 ], [ %2353, %2509 ]
  %2528 = icmp eq i64 %2527, -6
  br i1 %2528, label %2532, label %2529

2529:                                             ; preds = %2526
  %2530 = icmp ne i64 %2527, 6
  %2531 = select i1 %2530, i1 true, i1 %260
  br i1 %2531, label %2557, label %2532

2532:                                             ; preds = %2529, %2526
  %2533 = phi i64 [ %2527, %2529 ], [ 2, %2526 ]
  %2534 = load i64, ptr %422, align 8
  %2535 = add nsw i64 %2534, -1
  store i64 %2535, ptr %422, align 8
  %2536 = load ptr, ptr %101, align 8
  %2537 = load i64, ptr %2536, align 8
  %2538 = add nsw i64 %2537, -1
  store i64 %2538, ptr %2536, align 8
  %2539 = load ptr, ptr %83, align 8
  %2540 = getelementptr inbounds i8, ptr %2539, i64 32
  %2541 = load i64, ptr %2540, align 8
  %2542 = or i64 %2541, 1
  store i64 %2542, ptr %2540, align 8
  %2543 = load ptr, ptr %83, align 8
  %2544 = getelementptr inbounds i8, ptr %2543, i64 8
  %2545 = load i64, ptr %2544, align 8
  %2546 = and i64 %2545, -2
  %2547 = getelementptr inbounds i8, ptr %2543, i64 16
  %2548 = load i64, ptr %2547, align 8
  %2549 = and i64 %2548, 1
  %2550 = or disjoint i64 %2549, %2546
  %2551 = xor i64 %2550, 1
  store i64 %2551, ptr %2544, align 8
  %2552 = load ptr, ptr %178, align 8
  %2553 = getelementptr inbounds i8, ptr %2552, i64 8
  store double 0.000000e+00, ptr %2553, align 8
  %2554 = load i64, ptr %423, align 8
  %2555 = add nsw i64 %2554, 1
  store i64 %2555, ptr %423, align 8
  store i64 %2533, ptr %445, align 8
  %2556 = fmul double %535, 2.500000e-01
  br label %2637, !llvm.loop !53

2557:                                             ; preds = %2529
  %2558 = icmp eq i64 %2527, 0
  br i1 %2558, label %2563, label %2559

2559:                                             ; preds = %2557
  %2560 = load ptr, ptr %101, align 8
  %2561 = load i64, ptr %2560, align 8
  %2562 = add nsw i64 %2561, 1
  store i64 %2562, ptr %2560, align 8
  br label %2637

2563:                                             ; preds = %2557, %2333
  %2564 = icmp eq i64 %552, 0
  br i1 %2564, label %2584, label %2565

2565:                                             ; preds = %2563
  %2566 = load i64, ptr %206, align 8
  %2567 = icmp eq i64 %2566, 0
  br i1 %2567, label %2584, label %2568

2568:                                             ; preds = %2565
  %2569 = tail call fastcc double @knot_after(ptr noundef nonnull %81, double noundef %458) #10
  %2570 = fmul double %535, 1.000000e-03
  %2571 = fsub double %534, %2570
  %2572 = tail call double @llvm.fabs.f64(double %534)
  %2573 = fmul double %2572, 0x3D10000000000000
  %2574 = fsub double %2571, %2573
  %2575 = fcmp ogt double %2574, %2569
  %2576 = fadd double %534, %2573
  %2577 = fcmp ogt double %2569, %2576
  %2578 = or i1 %2575, %2577
  br i1 %2578, label %2584, label %2579

2579:                                             ; preds = %2568
  %2580 = tail call fastcc double @knot_after(ptr noundef nonnull %81, double noundef %534) #10
  %2581 = fsub double %2580, %534
  %2582 = fcmp olt double %2581, %1995
  %2583 = select i1 %2582, double %2581, double %1995
  br label %2584

2584:                                             ; preds = %2579, %2568, %2565, %2563
  %2585 = phi double [ %1995, %2563 ], [ %1995, %2565 ], [ %2583, %2579 ], [ %1995, %2568 ]
  br i1 %442, label %2616, label %2586

2586:                                             ; preds = %2616, %2584
  %2587 = load i64, ptr %102, align 8
  %2588 = icmp sgt i64 %2587, 0
  br i1 %2588, label %2589, label %2591

2589:                                             ; preds = %2586
  %2590 = load ptr, ptr %208, align 8
  store double 0x7FF0000000000000, ptr %2590, align 8
  br label %2591

2591:                                             ; preds = %2586, %2589
  %2592 = load i64, ptr %436, align 8
  %2593 = add nsw i64 %2592, 1
  store i64 %2593, ptr %436, align 8
  %2594 = load ptr, ptr %82, align 8
  %2595 = load ptr, ptr %209, align 8
  %2596 = load ptr, ptr %210, align 8
  store double %534, ptr %2596, align 8
  %2597 = load ptr, ptr %81, align 8
  %2598 = getelementptr inbounds i8, ptr %2597, i64 40
  %2599 = load i64, ptr %2598, align 8
  %2600 = icmp eq i64 %2599, 0
  br i1 %2600, label %2602, label %2601

2601:                                             ; preds = %2591
  tail call fastcc void @settle(ptr noundef nonnull %81) #10
  br label %2602

2602:                                             ; preds = %2601, %2591
  %2603 = load i64, ptr %211, align 8
  %2604 = icmp sgt i64 %2603, 0
  br i1 %2604, label %2605, label %2606

2605:                                             ; preds = %2602
  tail call fastcc void @sample(ptr noundef nonnull %81) #10
  br label %2606

2606:                                             ; preds = %2602, %2605
  %2607 = load ptr, ptr %81, align 8
  %2608 = load i64, ptr %2607, align 8
  %2609 = load ptr, ptr %210, align 8
  %2610 = load ptr, ptr %212, align 8
  %2611 = load ptr, ptr %213, align 8
  %2612 = inttoptr i64 %2608 to ptr
  %2613 = load ptr, ptr %2612, align 8
  %2614 = tail call i32 %2613(ptr noundef %2609, ptr noundef %2594, ptr noundef %2610, ptr noundef %2611, ptr noundef %2595) #11
  %2615 = icmp eq i32 %2614, 0
  br i1 %2615, label %2628, label %2625

2616:                                             ; preds = %2584, %2616
  %2617 = phi i64 [ %2623, %2616 ], [ 0, %2584 ]
  %2618 = load ptr, ptr %207, align 8
  %2619 = getelementptr inbounds double, ptr %2618, i64 %2617
  %2620 = load double, ptr %2619, align 8
  %2621 = load ptr, ptr %82, align 8
  %2622 = getelementptr inbounds double, ptr %2621, i64 %2617
  store double %2620, ptr %2622, align 8
  %2623 = add nuw nsw i64 %2617, 1
  %2624 = icmp eq i64 %2623, %231
  br i1 %2624, label %2586, label %2616, !llvm.loop !64

2625:                                             ; preds = %2606
  store i64 3, ptr %443, align 8
  store double %535, ptr %262, align 8
  %2626 = icmp slt i32 %2614, 0
  %2627 = select i1 %2626, i64 -4, i64 2
  br label %2637

2628:                                             ; preds = %2606
  %2629 = fcmp oeq double %534, %524
  %2630 = fcmp ogt double %459, %2585
  %2631 = select i1 %2629, i1 %2630, i1 false
  %2632 = select i1 %2631, double %459, double %2585
  %2633 = load i64, ptr %444, align 8
  %2634 = load i64, ptr %87, align 8
  %2635 = icmp eq i64 %2633, %2634
  br i1 %2635, label %2636, label %2637

2636:                                             ; preds = %2628
  store double %2632, ptr %262, align 8
  br label %2637

2637:                                             ; preds = %1985, %2011, %2045, %2532, %2559, %2625, %2628, %2636, %2018, %2021, %2029, %2033, %541
  %2638 = phi double [ %465, %541 ], [ %1986, %2033 ], [ %1986, %2029 ], [ %1986, %2021 ], [ %1986, %2018 ], [ %1986, %2636 ], [ %1986, %2628 ], [ %1986, %2625 ], [ %1986, %2559 ], [ %1986, %2532 ], [ %1986, %2045 ], [ %1986, %2011 ], [ %1986, %1985 ]
  %2639 = phi double [ %464, %541 ], [ %1987, %2033 ], [ %1987, %2029 ], [ %1987, %2021 ], [ %1987, %2018 ], [ %1987, %2636 ], [ %1987, %2628 ], [ %1987, %2625 ], [ %1987, %2559 ], [ %1987, %2532 ], [ %1987, %2045 ], [ %1987, %2011 ], [ %1987, %1985 ]
  %2640 = phi double [ %463, %541 ], [ %1988, %2033 ], [ %1988, %2029 ], [ %1988, %2021 ], [ %1988, %2018 ], [ %1988, %2636 ], [ %1988, %2628 ], [ %1988, %2625 ], [ %1988, %2559 ], [ %1988, %2532 ], [ %1988, %2045 ], [ %1988, %2011 ], [ %1988, %1985 ]
  %2641 = phi i64 [ %462, %541 ], [ %1989, %2033 ], [ %1989, %2029 ], [ %1989, %2021 ], [ %1989, %2018 ], [ %1989, %2636 ], [ %1989, %2628 ], [ %1989, %2625 ], [ %1989, %2559 ], [ %1989, %2532 ], [ %1989, %2045 ], [ %1989, %2011 ], [ %1989, %1985 ]
  %2642 = phi i64 [ %461, %541 ], [ %1990, %2033 ], [ %1990, %2029 ], [ %1990, %2021 ], [ %1990, %2018 ], [ %1990, %2636 ], [ %1990, %2628 ], [ %1990, %2625 ], [ %1990, %2559 ], [ %1990, %2532 ], [ %1990, %2045 ], [ %1990, %2011 ], [ %1990, %1985 ]
  %2643 = phi i64 [ %460, %541 ], [ %1991, %2033 ], [ %1991, %2029 ], [ %1991, %2021 ], [ %1991, %2018 ], [ %1991, %2636 ], [ %1991, %2628 ], [ %1991, %2625 ], [ %1991, %2559 ], [ %1991, %2532 ], [ %1991, %2045 ], [ %1991, %2011 ], [ %1991, %1985 ]
  %2644 = phi double [ %459, %541 ], [ %2034, %2033 ], [ %1995, %2029 ], [ %1995, %2021 ], [ %1995, %2018 ], [ %2632, %2636 ], [ %2632, %2628 ], [ %2585, %2625 ], [ %1995, %2559 ], [ %2556, %2532 ], [ %2048, %2045 ], [ %1995, %2011 ], [ %459, %1985 ]
  %2645 = phi double [ %458, %541 ], [ %458, %2033 ], [ %458, %2029 ], [ %458, %2021 ], [ %458, %2018 ], [ %534, %2636 ], [ %534, %2628 ], [ %534, %2625 ], [ %458, %2559 ], [ %458, %2532 ], [ %458, %2045 ], [ %458, %2011 ], [ %458, %1985 ]
  %2646 = phi i32 [ 1, %541 ], [ 3, %2033 ], [ 3, %2029 ], [ 3, %2021 ], [ 3, %2018 ], [ 1, %2636 ], [ 0, %2628 ], [ 1, %2625 ], [ 1, %2559 ], [ 3, %2532 ], [ 3, %2045 ], [ 3, %2011 ], [ 1, %1985 ]
  %2647 = phi i64 [ 2, %541 ], [ %457, %2033 ], [ %457, %2029 ], [ %457, %2021 ], [ %457, %2018 ], [ 0, %2636 ], [ %457, %2628 ], [ %2627, %2625 ], [ %2527, %2559 ], [ %457, %2532 ], [ %457, %2045 ], [ %457, %2011 ], [ -4, %1985 ]
  switch i32 %2646, label %2651 [
    i32 0, label %2648
    i32 3, label %2648
  ]

2648:                                             ; preds = %2637, %2637
  %2649 = load i64, ptr %225, align 8
  %2650 = icmp eq i64 %2649, 0
  br i1 %2650, label %447, label %455, !llvm.loop !53

2651:                                             ; preds = %2637, %324, %383, %447, %478, %486, %216
  %2652 = phi double [ %217, %216 ], [ %448, %447 ], [ %465, %486 ], [ %465, %478 ], [ %217, %383 ], [ %217, %324 ], [ %2638, %2637 ]
  %2653 = phi double [ %218, %216 ], [ %449, %447 ], [ %464, %486 ], [ %464, %478 ], [ %218, %383 ], [ %218, %324 ], [ %2639, %2637 ]
  %2654 = phi double [ %219, %216 ], [ %450, %447 ], [ %463, %486 ], [ %463, %478 ], [ %219, %383 ], [ %219, %324 ], [ %2640, %2637 ]
  %2655 = phi i64 [ %220, %216 ], [ %451, %447 ], [ %462, %486 ], [ %462, %478 ], [ %220, %383 ], [ %220, %324 ], [ %2641, %2637 ]
  %2656 = phi i64 [ %221, %216 ], [ %452, %447 ], [ %461, %486 ], [ %461, %478 ], [ %221, %383 ], [ %221, %324 ], [ %2642, %2637 ]
  %2657 = phi i64 [ %222, %216 ], [ %453, %447 ], [ %460, %486 ], [ %460, %478 ], [ %222, %383 ], [ %222, %324 ], [ %2643, %2637 ]
  %2658 = phi i64 [ -1, %216 ], [ -1, %447 ], [ 1, %486 ], [ -5, %478 ], [ 0, %383 ], [ %327, %324 ], [ %2647, %2637 ]
  %2659 = load ptr, ptr %215, align 8
  %2660 = getelementptr inbounds i8, ptr %2659, i64 48
  %2661 = load i64, ptr %2660, align 8
  %2662 = icmp ne i64 %2658, -2
  %2663 = icmp eq i64 %2661, 0
  %2664 = select i1 %2662, i1 true, i1 %2663
  br i1 %2664, label %2672, label %2665

2665:                                             ; preds = %2651
  %2666 = inttoptr i64 %2661 to ptr
  %2667 = tail call i64 %2666(ptr noundef %0) #11
  %2668 = icmp eq i64 %2667, 8
  %2669 = select i1 %2668, i64 8, i64 %2658
  %2670 = icmp eq i64 %2667, 1
  %2671 = zext i1 %2670 to i32
  br label %2672

2672:                                             ; preds = %2651, %2665
  %2673 = phi i64 [ %2658, %2651 ], [ %2669, %2665 ]
  %2674 = phi i32 [ 0, %2651 ], [ %2671, %2665 ]
  %2675 = icmp eq i32 %2674, 0
  br i1 %2675, label %2676, label %216, !llvm.loop !65

2676:                                             ; preds = %2672
  %2677 = getelementptr inbounds i8, ptr %0, i64 320
  %2678 = load i64, ptr %2677, align 8
  %2679 = icmp sgt i64 %2678, 0
  br i1 %2679, label %2680, label %2683

2680:                                             ; preds = %2676
  %2681 = getelementptr inbounds i8, ptr %0, i64 336
  %2682 = load ptr, ptr %2681, align 8
  store double 0x7FF0000000000000, ptr %2682, align 8
  br label %2683

2683:                                             ; preds = %2676, %2680
  ret i64 %2673
}



define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 192
  %3 = load ptr, ptr %2, align 8
  %4 = load double, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 24
  %6 = load ptr, ptr %5, align 8
  %7 = load double, ptr %6, align 8
  %8 = fcmp olt double %7, %4
  %9 = select i1 %8, double %7, double %4
  %10 = getelementptr inbounds i8, ptr %0, i64 168
  %11 = getelementptr inbounds i8, ptr %0, i64 176
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %29

14:                                               ; preds = %1
  %15 = load ptr, ptr %10, align 8
  br label %16

16:                                               ; preds = %14, %16
  %17 = phi i64 [ 0, %14 ], [ %27, %16 ]
  %18 = phi i64 [ %12, %14 ], [ %26, %16 ]
  %19 = add nuw nsw i64 %17, %18
  %20 = lshr i64 %19, 1
  %21 = mul i64 %20, 24
  %22 = getelementptr inbounds i8, ptr %15, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fcmp ogt double %23, %9
  %25 = add nuw nsw i64 %20, 1
  %26 = select i1 %24, i64 %20, i64 %18
  %27 = select i1 %24, i64 %17, i64 %25
  %28 = icmp slt i64 %27, %26
  br i1 %28, label %16, label %29, !llvm.loop !12

29:                                               ; preds = %16, %1
  %30 = phi i64 [ 0, %1 ], [ %27, %16 ]
  %31 = load ptr, ptr %10, align 8
  %32 = mul i64 %30, 24
  %33 = getelementptr inbounds i8, ptr %31, i64 %32
  %34 = icmp eq i64 %30, 0
  br i1 %34, label %39, label %35

35:                                               ; preds = %29
  %36 = getelementptr inbounds i8, ptr %33, i64 -8
  %37 = load double, ptr %36, align 8
  %38 = fcmp olt double %9, %37
  br i1 %38, label %46, label %39

39:                                               ; preds = %35, %29
  %40 = icmp slt i64 %30, %12
  br i1 %40, label %41, label %45

41:                                               ; preds = %39
  %42 = getelementptr inbounds i8, ptr %33, i64 8
  %43 = load double, ptr %42, align 8
  %44 = fcmp ogt double %9, %43
  br i1 %44, label %46, label %45

45:                                               ; preds = %41, %39
  br label %46

46:                                               ; preds = %45, %41, %35
  %47 = phi double [ %37, %35 ], [ %9, %45 ], [ %43, %41 ]
  store double %47, ptr %6, align 8
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #2 {
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
  br i1 %60, label %49, label %61, !llvm.loop !66

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
  br i1 %88, label %14, label %13, !llvm.loop !67
}

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #3 {
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
  br i1 %41, label %13, label %18, !llvm.loop !68
}

declare double @llvm.sqrt.f64(double) #4

declare double @llvm.fabs.f64(double) #4

define internal fastcc range(i64 -2147483648, 2147483648) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %11, label %9

5:                                                ; preds = %98, %49
  %6 = icmp eq i64 %20, %1
  br i1 %6, label %7, label %11, !llvm.loop !69

7:                                                ; preds = %5
  %8 = zext nneg i32 %29 to i64
  br label %9

9:                                                ; preds = %7, %3
  %10 = phi i64 [ 0, %3 ], [ %8, %7 ]
  ret i64 %10

11:                                               ; preds = %3, %5
  %12 = phi i32 [ %29, %5 ], [ 0, %3 ]
  %13 = phi i64 [ %20, %5 ], [ 0, %3 ]
  %14 = uitofp nneg i64 %13 to double
  %15 = mul nuw nsw i64 %13, %1
  %16 = getelementptr double, ptr %0, i64 %15
  %17 = getelementptr double, ptr %16, i64 %13
  %18 = load double, ptr %17, align 8
  %19 = tail call double @llvm.fabs.f64(double %18)
  %20 = add nuw nsw i64 %13, 1
  %21 = getelementptr double, ptr %0, i64 %13
  %22 = icmp slt i64 %20, %1
  br i1 %22, label %35, label %23

23:                                               ; preds = %35, %11
  %24 = phi double [ %19, %11 ], [ %46, %35 ]
  %25 = phi double [ %14, %11 ], [ %45, %35 ]
  %26 = getelementptr inbounds double, ptr %2, i64 %13
  store double %25, ptr %26, align 8
  %27 = fcmp ueq double %24, 0.000000e+00
  %28 = zext i1 %27 to i32
  %29 = or i32 %12, %28
  %30 = fcmp oeq double %25, %14
  %31 = icmp sge i64 %20, %1
  %32 = select i1 %31, i1 true, i1 %30
  br i1 %32, label %49, label %33

33:                                               ; preds = %23
  %34 = getelementptr double, ptr %0, i64 %15
  br label %56

35:                                               ; preds = %11, %35
  %36 = phi double [ %45, %35 ], [ %14, %11 ]
  %37 = phi double [ %46, %35 ], [ %19, %11 ]
  %38 = phi i64 [ %47, %35 ], [ %20, %11 ]
  %39 = mul nuw nsw i64 %38, %1
  %40 = getelementptr double, ptr %21, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = tail call double @llvm.fabs.f64(double %41)
  %43 = fcmp ule double %42, %37
  %44 = uitofp nneg i64 %38 to double
  %45 = select i1 %43, double %36, double %44
  %46 = select i1 %43, double %37, double %42
  %47 = add nuw nsw i64 %38, 1
  %48 = icmp slt i64 %47, %1
  br i1 %48, label %35, label %23, !llvm.loop !70

49:                                               ; preds = %63, %23
  %50 = load double, ptr %17, align 8
  %51 = fdiv double 1.000000e+00, %50
  store double %51, ptr %17, align 8
  %52 = getelementptr double, ptr %0, i64 %13
  %53 = icmp slt i64 %20, %1
  br i1 %53, label %54, label %5

54:                                               ; preds = %49
  %55 = getelementptr double, ptr %0, i64 %15
  br label %78

56:                                               ; preds = %33, %63
  %57 = phi i64 [ %20, %33 ], [ %64, %63 ]
  %58 = uitofp nneg i64 %57 to double
  %59 = fcmp oeq double %25, %58
  br i1 %59, label %60, label %63

60:                                               ; preds = %56
  %61 = mul nuw nsw i64 %57, %1
  %62 = getelementptr double, ptr %0, i64 %61
  br label %67

63:                                               ; preds = %67, %56
  %64 = add nuw nsw i64 %57, 1
  %65 = icmp sge i64 %64, %1
  %66 = select i1 %65, i1 true, i1 %30
  br i1 %66, label %49, label %56, !llvm.loop !71

67:                                               ; preds = %60, %67
  %68 = phi i64 [ 0, %60 ], [ %75, %67 ]
  %69 = getelementptr double, ptr %34, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr double, ptr %62, i64 %68
  %72 = load double, ptr %71, align 8
  %73 = select i1 %59, double %72, double %70
  store double %73, ptr %69, align 8
  %74 = select i1 %59, double %70, double %72
  store double %74, ptr %71, align 8
  %75 = add nuw nsw i64 %68, 1
  %76 = icmp slt i64 %75, %1
  %77 = and i1 %76, %59
  br i1 %77, label %67, label %63, !llvm.loop !72

78:                                               ; preds = %54, %98
  %79 = phi i64 [ %20, %54 ], [ %99, %98 ]
  %80 = mul nuw nsw i64 %79, %1
  %81 = getelementptr double, ptr %52, i64 %80
  %82 = load double, ptr %81, align 8
  %83 = fcmp oeq double %82, 0.000000e+00
  br i1 %83, label %98, label %84

84:                                               ; preds = %78
  %85 = fmul double %51, %82
  store double %85, ptr %81, align 8
  %86 = getelementptr double, ptr %0, i64 %80
  %87 = fneg double %85
  br label %88

88:                                               ; preds = %84, %88
  %89 = phi i64 [ %20, %84 ], [ %96, %88 ]
  %90 = getelementptr double, ptr %86, i64 %89
  %91 = load double, ptr %90, align 8
  %92 = getelementptr double, ptr %55, i64 %89
  %93 = load double, ptr %92, align 8
  %94 = tail call double @llvm.fma.f64(double %87, double %93, double %91)
  %95 = select i1 %83, double %91, double %94
  store double %95, ptr %90, align 8
  %96 = add nuw nsw i64 %89, 1
  %97 = icmp slt i64 %96, %1
  br i1 %97, label %88, label %98, !llvm.loop !73

98:                                               ; preds = %88, %78
  %99 = add nuw nsw i64 %79, 1
  %100 = icmp slt i64 %99, %1
  br i1 %100, label %78, label %5, !llvm.loop !74
}

define internal fastcc range(i64 -2147483648, 2147483648) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %11, label %9

5:                                                ; preds = %156, %59
  %6 = icmp eq i64 %26, %1
  br i1 %6, label %7, label %11, !llvm.loop !75

7:                                                ; preds = %5
  %8 = zext nneg i32 %34 to i64
  br label %9

9:                                                ; preds = %7, %3
  %10 = phi i64 [ 0, %3 ], [ %8, %7 ]
  ret i64 %10

11:                                               ; preds = %3, %5
  %12 = phi i32 [ %34, %5 ], [ 0, %3 ]
  %13 = phi i64 [ %26, %5 ], [ 0, %3 ]
  %14 = uitofp nneg i64 %13 to double
  %15 = mul nuw nsw i64 %13, %1
  %16 = add nuw nsw i64 %15, %13
  %17 = shl nuw nsw i64 %16, 1
  %18 = getelementptr inbounds double, ptr %0, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = or disjoint i64 %17, 1
  %21 = getelementptr inbounds double, ptr %0, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = tail call double @llvm.fabs.f64(double %19)
  %24 = tail call double @llvm.fabs.f64(double %22)
  %25 = fadd double %23, %24
  %26 = add nuw nsw i64 %13, 1
  %27 = icmp slt i64 %26, %1
  br i1 %27, label %38, label %28

28:                                               ; preds = %38, %11
  %29 = phi double [ %25, %11 ], [ %56, %38 ]
  %30 = phi double [ %14, %11 ], [ %55, %38 ]
  %31 = getelementptr inbounds double, ptr %2, i64 %13
  store double %30, ptr %31, align 8
  %32 = fcmp ueq double %29, 0.000000e+00
  %33 = zext i1 %32 to i32
  %34 = or i32 %12, %33
  %35 = fcmp oeq double %30, %14
  %36 = icmp sge i64 %26, %1
  %37 = select i1 %36, i1 true, i1 %35
  br i1 %37, label %59, label %76

38:                                               ; preds = %11, %38
  %39 = phi double [ %55, %38 ], [ %14, %11 ]
  %40 = phi double [ %56, %38 ], [ %25, %11 ]
  %41 = phi i64 [ %57, %38 ], [ %26, %11 ]
  %42 = mul nuw nsw i64 %41, %1
  %43 = add nuw nsw i64 %42, %13
  %44 = shl nuw nsw i64 %43, 1
  %45 = getelementptr inbounds double, ptr %0, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = or disjoint i64 %44, 1
  %48 = getelementptr inbounds double, ptr %0, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = tail call double @llvm.fabs.f64(double %46)
  %51 = tail call double @llvm.fabs.f64(double %49)
  %52 = fadd double %50, %51
  %53 = fcmp ule double %52, %40
  %54 = uitofp nneg i64 %41 to double
  %55 = select i1 %53, double %39, double %54
  %56 = select i1 %53, double %40, double %52
  %57 = add nuw nsw i64 %41, 1
  %58 = icmp slt i64 %57, %1
  br i1 %58, label %38, label %28, !llvm.loop !76

59:                                               ; preds = %82, %28
  %60 = load double, ptr %18, align 8
  %61 = load double, ptr %21, align 8
  %62 = tail call double @llvm.fabs.f64(double %60)
  %63 = tail call double @llvm.fabs.f64(double %61)
  %64 = fcmp ult double %62, %63
  %65 = select i1 %64, double %61, double %60
  %66 = select i1 %64, double %60, double %61
  %67 = fdiv double %66, %65
  %68 = fmul double %66, %67
  %69 = fadd double %65, %68
  %70 = select i1 %64, double %67, double 1.000000e+00
  %71 = fdiv double %70, %69
  %72 = fneg double %67
  %73 = select i1 %64, double -1.000000e+00, double %72
  %74 = fdiv double %73, %69
  store double %71, ptr %18, align 8
  store double %74, ptr %21, align 8
  %75 = icmp slt i64 %26, %1
  br i1 %75, label %109, label %5

76:                                               ; preds = %28, %82
  %77 = phi i64 [ %83, %82 ], [ %26, %28 ]
  %78 = uitofp nneg i64 %77 to double
  %79 = fcmp oeq double %30, %78
  br i1 %79, label %80, label %82

80:                                               ; preds = %76
  %81 = mul nuw nsw i64 %77, %1
  br label %86

82:                                               ; preds = %86, %76
  %83 = add nuw nsw i64 %77, 1
  %84 = icmp sge i64 %83, %1
  %85 = select i1 %84, i1 true, i1 %35
  br i1 %85, label %59, label %76, !llvm.loop !77

86:                                               ; preds = %80, %86
  %87 = phi i64 [ 0, %80 ], [ %106, %86 ]
  %88 = add nuw nsw i64 %87, %15
  %89 = shl nuw nsw i64 %88, 1
  %90 = getelementptr inbounds double, ptr %0, i64 %89
  %91 = load double, ptr %90, align 8
  %92 = or disjoint i64 %89, 1
  %93 = getelementptr inbounds double, ptr %0, i64 %92
  %94 = load double, ptr %93, align 8
  %95 = add nuw nsw i64 %87, %81
  %96 = shl nuw nsw i64 %95, 1
  %97 = getelementptr inbounds double, ptr %0, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = or disjoint i64 %96, 1
  %100 = getelementptr inbounds double, ptr %0, i64 %99
  %101 = load double, ptr %100, align 8
  %102 = select i1 %79, double %98, double %91
  %103 = select i1 %79, double %101, double %94
  store double %102, ptr %90, align 8
  store double %103, ptr %93, align 8
  %104 = select i1 %79, double %91, double %98
  %105 = select i1 %79, double %94, double %101
  store double %104, ptr %97, align 8
  store double %105, ptr %100, align 8
  %106 = add nuw nsw i64 %87, 1
  %107 = icmp slt i64 %106, %1
  %108 = and i1 %107, %79
  br i1 %108, label %86, label %82, !llvm.loop !78

109:                                              ; preds = %59, %156
  %110 = phi i64 [ %157, %156 ], [ %26, %59 ]
  %111 = mul nuw nsw i64 %110, %1
  %112 = add nuw nsw i64 %111, %13
  %113 = shl nuw nsw i64 %112, 1
  %114 = getelementptr inbounds double, ptr %0, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = or disjoint i64 %113, 1
  %117 = getelementptr inbounds double, ptr %0, i64 %116
  %118 = load double, ptr %117, align 8
  %119 = tail call double @llvm.fabs.f64(double %115)
  %120 = tail call double @llvm.fabs.f64(double %118)
  %121 = fadd double %119, %120
  %122 = fcmp oeq double %121, 0.000000e+00
  br i1 %122, label %156, label %123

123:                                              ; preds = %109
  %124 = fneg double %118
  %125 = fmul double %74, %124
  %126 = tail call double @llvm.fma.f64(double %115, double %71, double %125)
  %127 = fmul double %71, %118
  %128 = tail call double @llvm.fma.f64(double %115, double %74, double %127)
  store double %126, ptr %114, align 8
  store double %128, ptr %117, align 8
  %129 = fneg double %128
  br label %130

130:                                              ; preds = %123, %130
  %131 = phi i64 [ %26, %123 ], [ %154, %130 ]
  %132 = add nuw nsw i64 %131, %111
  %133 = shl nuw nsw i64 %132, 1
  %134 = getelementptr inbounds double, ptr %0, i64 %133
  %135 = load double, ptr %134, align 8
  %136 = or disjoint i64 %133, 1
  %137 = getelementptr inbounds double, ptr %0, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = add nuw nsw i64 %131, %15
  %140 = shl nuw nsw i64 %139, 1
  %141 = getelementptr inbounds double, ptr %0, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = or disjoint i64 %140, 1
  %144 = getelementptr inbounds double, ptr %0, i64 %143
  %145 = load double, ptr %144, align 8
  %146 = fmul double %145, %129
  %147 = tail call double @llvm.fma.f64(double %126, double %142, double %146)
  %148 = fmul double %128, %142
  %149 = tail call double @llvm.fma.f64(double %126, double %145, double %148)
  %150 = fsub double %135, %147
  %151 = fsub double %138, %149
  %152 = select i1 %122, double %135, double %150
  %153 = select i1 %122, double %138, double %151
  store double %152, ptr %134, align 8
  store double %153, ptr %137, align 8
  %154 = add nuw nsw i64 %131, 1
  %155 = icmp slt i64 %154, %1
  br i1 %155, label %130, label %156, !llvm.loop !79

156:                                              ; preds = %130, %109
  %157 = add nuw nsw i64 %110, 1
  %158 = icmp slt i64 %157, %1
  br i1 %158, label %109, label %5, !llvm.loop !80
}

declare double @llvm.fma.f64(double, double, double) #4

declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg) #6

define internal fastcc void @real_solve(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #5 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %14, %4
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %27, label %23

8:                                                ; preds = %4, %14
  %9 = phi i64 [ %15, %14 ], [ 0, %4 ]
  %10 = getelementptr inbounds double, ptr %2, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = uitofp nneg i64 %9 to double
  %13 = fcmp oeq double %11, %12
  br i1 %13, label %14, label %17

14:                                               ; preds = %17, %8
  %15 = add nuw nsw i64 %9, 1
  %16 = icmp eq i64 %15, %1
  br i1 %16, label %6, label %8, !llvm.loop !81

17:                                               ; preds = %8
  %18 = getelementptr inbounds double, ptr %3, i64 %9
  %19 = fptosi double %11 to i64
  %20 = getelementptr inbounds double, ptr %3, i64 %19
  %21 = load double, ptr %18, align 8
  %22 = load double, ptr %20, align 8
  store double %22, ptr %18, align 8
  store double %21, ptr %20, align 8
  br label %14

23:                                               ; preds = %35, %6
  %24 = icmp sgt i64 %1, 0
  br i1 %24, label %25, label %50

25:                                               ; preds = %23
  %26 = add nuw i64 %1, 1
  br label %51

27:                                               ; preds = %6, %35
  %28 = phi i64 [ %37, %35 ], [ 0, %6 ]
  %29 = getelementptr inbounds double, ptr %3, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = icmp eq i64 %28, 0
  br i1 %31, label %35, label %32

32:                                               ; preds = %27
  %33 = mul nuw nsw i64 %28, %1
  %34 = getelementptr double, ptr %0, i64 %33
  br label %39

35:                                               ; preds = %39, %27
  %36 = phi double [ %30, %27 ], [ %47, %39 ]
  store double %36, ptr %29, align 8
  %37 = add nuw nsw i64 %28, 1
  %38 = icmp eq i64 %37, %1
  br i1 %38, label %23, label %27, !llvm.loop !82

39:                                               ; preds = %32, %39
  %40 = phi i64 [ 0, %32 ], [ %48, %39 ]
  %41 = phi double [ %30, %32 ], [ %47, %39 ]
  %42 = getelementptr double, ptr %34, i64 %40
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds double, ptr %3, i64 %40
  %45 = load double, ptr %44, align 8
  %46 = fneg double %43
  %47 = tail call double @llvm.fma.f64(double %46, double %45, double %41)
  %48 = add nuw nsw i64 %40, 1
  %49 = icmp eq i64 %48, %28
  br i1 %49, label %35, label %39, !llvm.loop !83

50:                                               ; preds = %60, %23
  ret void

51:                                               ; preds = %25, %60
  %52 = phi i64 [ %1, %25 ], [ %53, %60 ]
  %53 = add nsw i64 %52, -1
  %54 = getelementptr inbounds double, ptr %3, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = icmp slt i64 %52, %1
  br i1 %56, label %57, label %60

57:                                               ; preds = %51
  %58 = mul nsw i64 %53, %1
  %59 = getelementptr double, ptr %0, i64 %58
  br label %67

60:                                               ; preds = %67, %51
  %61 = phi double [ %55, %51 ], [ %75, %67 ]
  %62 = mul i64 %53, %26
  %63 = getelementptr inbounds double, ptr %0, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fmul double %61, %64
  store double %65, ptr %54, align 8
  %66 = icmp sgt i64 %52, 1
  br i1 %66, label %51, label %50, !llvm.loop !84

67:                                               ; preds = %57, %67
  %68 = phi i64 [ %52, %57 ], [ %76, %67 ]
  %69 = phi double [ %55, %57 ], [ %75, %67 ]
  %70 = getelementptr double, ptr %59, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = getelementptr inbounds double, ptr %3, i64 %68
  %73 = load double, ptr %72, align 8
  %74 = fneg double %71
  %75 = tail call double @llvm.fma.f64(double %74, double %73, double %69)
  %76 = add nuw nsw i64 %68, 1
  %77 = icmp eq i64 %76, %1
  br i1 %77, label %60, label %67, !llvm.loop !85
}

define internal fastcc void @pair_solve(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #5 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %14, %4
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %36, label %31

8:                                                ; preds = %4, %14
  %9 = phi i64 [ %15, %14 ], [ 0, %4 ]
  %10 = getelementptr inbounds double, ptr %2, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = uitofp nneg i64 %9 to double
  %13 = fcmp oeq double %11, %12
  br i1 %13, label %14, label %17

14:                                               ; preds = %23, %8
  %15 = add nuw nsw i64 %9, 1
  %16 = icmp eq i64 %15, %1
  br i1 %16, label %6, label %8, !llvm.loop !81

17:                                               ; preds = %8
  %18 = shl nsw i64 %9, 4
  %19 = getelementptr inbounds i8, ptr %3, i64 %18
  %20 = fptosi double %11 to i64
  %21 = shl nsw i64 %20, 4
  %22 = getelementptr inbounds i8, ptr %3, i64 %21
  br label %23

23:                                               ; preds = %17, %23
  %24 = phi i64 [ 0, %17 ], [ %29, %23 ]
  %25 = getelementptr inbounds double, ptr %19, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %22, i64 %24
  %28 = load double, ptr %27, align 8
  store double %28, ptr %25, align 8
  store double %26, ptr %27, align 8
  %29 = add nuw nsw i64 %24, 1
  %30 = icmp eq i64 %24, 0
  br i1 %30, label %23, label %14, !llvm.loop !86

31:                                               ; preds = %47, %6
  %32 = icmp sgt i64 %1, 0
  br i1 %32, label %33, label %78

33:                                               ; preds = %31
  %34 = shl nuw i64 %1, 1
  %35 = add i64 %34, 2
  br label %79

36:                                               ; preds = %6, %47
  %37 = phi i64 [ %50, %47 ], [ 0, %6 ]
  %38 = shl nuw nsw i64 %37, 1
  %39 = getelementptr inbounds double, ptr %3, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = or disjoint i64 %38, 1
  %42 = getelementptr inbounds double, ptr %3, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = icmp eq i64 %37, 0
  br i1 %44, label %47, label %45

45:                                               ; preds = %36
  %46 = mul nuw nsw i64 %37, %1
  br label %52

47:                                               ; preds = %52, %36
  %48 = phi double [ %40, %36 ], [ %74, %52 ]
  %49 = phi double [ %43, %36 ], [ %75, %52 ]
  store double %48, ptr %39, align 8
  store double %49, ptr %42, align 8
  %50 = add nuw nsw i64 %37, 1
  %51 = icmp eq i64 %50, %1
  br i1 %51, label %31, label %36, !llvm.loop !88

52:                                               ; preds = %45, %52
  %53 = phi double [ %43, %45 ], [ %75, %52 ]
  %54 = phi double [ %40, %45 ], [ %74, %52 ]
  %55 = phi i64 [ 0, %45 ], [ %76, %52 ]
  %56 = add nuw nsw i64 %55, %46
  %57 = shl nuw nsw i64 %56, 1
  %58 = getelementptr inbounds double, ptr %0, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = or disjoint i64 %57, 1
  %61 = getelementptr inbounds double, ptr %0, i64 %60
  %62 = load double, ptr %61, align 8
  %63 = shl nuw nsw i64 %55, 1
  %64 = getelementptr inbounds double, ptr %3, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = or disjoint i64 %63, 1
  %67 = getelementptr inbounds double, ptr %3, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = fneg double %62
  %70 = fmul double %68, %69
  %71 = tail call double @llvm.fma.f64(double %59, double %65, double %70)
  %72 = fmul double %62, %65
  %73 = tail call double @llvm.fma.f64(double %59, double %68, double %72)
  %74 = fsub double %54, %71
  %75 = fsub double %53, %73
  %76 = add nuw nsw i64 %55, 1
  %77 = icmp eq i64 %76, %37
  br i1 %77, label %47, label %52, !llvm.loop !89

78:                                               ; preds = %91, %31
  ret void

79:                                               ; preds = %33, %91
  %80 = phi i64 [ %1, %33 ], [ %81, %91 ]
  %81 = add nsw i64 %80, -1
  %82 = shl nsw i64 %81, 1
  %83 = getelementptr inbounds double, ptr %3, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = or disjoint i64 %82, 1
  %86 = getelementptr inbounds double, ptr %3, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = icmp slt i64 %80, %1
  br i1 %88, label %89, label %91

89:                                               ; preds = %79
  %90 = mul nsw i64 %81, %1
  br label %106

91:                                               ; preds = %106, %79
  %92 = phi double [ %84, %79 ], [ %128, %106 ]
  %93 = phi double [ %87, %79 ], [ %129, %106 ]
  %94 = mul i64 %35, %81
  %95 = getelementptr inbounds double, ptr %0, i64 %94
  %96 = load double, ptr %95, align 8
  %97 = or disjoint i64 %94, 1
  %98 = getelementptr inbounds double, ptr %0, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = fneg double %93
  %101 = fmul double %99, %100
  %102 = tail call double @llvm.fma.f64(double %92, double %96, double %101)
  %103 = fmul double %93, %96
  %104 = tail call double @llvm.fma.f64(double %92, double %99, double %103)
  store double %102, ptr %83, align 8
  store double %104, ptr %86, align 8
  %105 = icmp sgt i64 %80, 1
  br i1 %105, label %79, label %78, !llvm.loop !90

106:                                              ; preds = %89, %106
  %107 = phi double [ %87, %89 ], [ %129, %106 ]
  %108 = phi double [ %84, %89 ], [ %128, %106 ]
  %109 = phi i64 [ %80, %89 ], [ %130, %106 ]
  %110 = add nsw i64 %109, %90
  %111 = shl nsw i64 %110, 1
  %112 = getelementptr inbounds double, ptr %0, i64 %111
  %113 = load double, ptr %112, align 8
  %114 = or disjoint i64 %111, 1
  %115 = getelementptr inbounds double, ptr %0, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = shl nuw nsw i64 %109, 1
  %118 = getelementptr inbounds double, ptr %3, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = or disjoint i64 %117, 1
  %121 = getelementptr inbounds double, ptr %3, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = fneg double %116
  %124 = fmul double %122, %123
  %125 = tail call double @llvm.fma.f64(double %113, double %119, double %124)
  %126 = fmul double %116, %119
  %127 = tail call double @llvm.fma.f64(double %113, double %122, double %126)
  %128 = fsub double %108, %125
  %129 = fsub double %107, %127
  %130 = add nuw nsw i64 %109, 1
  %131 = icmp eq i64 %130, %1
  br i1 %131, label %91, label %106, !llvm.loop !91
}

define internal fastcc void @real_solve_columns(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3, i64 noundef %4) unnamed_addr #5 {
  %6 = icmp sgt i64 %1, 0
  br i1 %6, label %7, label %9

7:                                                ; preds = %5
  %8 = icmp sgt i64 %4, 0
  br label %13

9:                                                ; preds = %19, %5
  %10 = icmp sgt i64 %1, 0
  br i1 %10, label %11, label %44

11:                                               ; preds = %9
  %12 = icmp sgt i64 %4, 0
  br label %36

13:                                               ; preds = %7, %19
  %14 = phi i64 [ 0, %7 ], [ %20, %19 ]
  %15 = getelementptr inbounds double, ptr %2, i64 %14
  %16 = load double, ptr %15, align 8
  %17 = uitofp nneg i64 %14 to double
  %18 = fcmp oeq double %16, %17
  br i1 %18, label %19, label %22

19:                                               ; preds = %28, %22, %13
  %20 = add nuw nsw i64 %14, 1
  %21 = icmp eq i64 %20, %1
  br i1 %21, label %9, label %13, !llvm.loop !81

22:                                               ; preds = %13
  %23 = mul nsw i64 %14, %4
  %24 = getelementptr inbounds double, ptr %3, i64 %23
  %25 = fptosi double %16 to i64
  %26 = mul nsw i64 %25, %4
  %27 = getelementptr inbounds double, ptr %3, i64 %26
  br i1 %8, label %28, label %19

28:                                               ; preds = %22, %28
  %29 = phi i64 [ %34, %28 ], [ 0, %22 ]
  %30 = getelementptr inbounds double, ptr %24, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %27, i64 %29
  %33 = load double, ptr %32, align 8
  store double %33, ptr %30, align 8
  store double %31, ptr %32, align 8
  %34 = add nuw nsw i64 %29, 1
  %35 = icmp eq i64 %34, %4
  br i1 %35, label %19, label %28, !llvm.loop !86

36:                                               ; preds = %11, %50
  %37 = phi i64 [ 0, %11 ], [ %51, %50 ]
  %38 = icmp eq i64 %37, 0
  br i1 %38, label %50, label %39

39:                                               ; preds = %36
  %40 = mul nuw nsw i64 %37, %1
  %41 = getelementptr double, ptr %0, i64 %40
  %42 = mul nsw i64 %37, %4
  %43 = getelementptr double, ptr %3, i64 %42
  br label %53

44:                                               ; preds = %50, %9
  %45 = icmp sgt i64 %1, 0
  br i1 %45, label %46, label %84

46:                                               ; preds = %44
  %47 = icmp sgt i64 %4, 0
  %48 = icmp sgt i64 %4, 0
  %49 = add nuw i64 %1, 1
  br label %75

50:                                               ; preds = %70, %36
  %51 = add nuw nsw i64 %37, 1
  %52 = icmp eq i64 %51, %1
  br i1 %52, label %44, label %36, !llvm.loop !92

53:                                               ; preds = %39, %70
  %54 = phi i64 [ 0, %39 ], [ %71, %70 ]
  br i1 %12, label %55, label %70

55:                                               ; preds = %53
  %56 = getelementptr double, ptr %41, i64 %54
  %57 = load double, ptr %56, align 8
  %58 = mul nuw nsw i64 %54, %4
  %59 = getelementptr double, ptr %3, i64 %58
  %60 = fneg double %57
  br label %61

61:                                               ; preds = %55, %61
  %62 = phi i64 [ 0, %55 ], [ %68, %61 ]
  %63 = getelementptr double, ptr %43, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = getelementptr double, ptr %59, i64 %62
  %66 = load double, ptr %65, align 8
  %67 = tail call double @llvm.fma.f64(double %60, double %66, double %64)
  store double %67, ptr %63, align 8
  %68 = add nuw nsw i64 %62, 1
  %69 = icmp eq i64 %68, %4
  br i1 %69, label %70, label %61, !llvm.loop !93

70:                                               ; preds = %61, %53
  %71 = add nuw nsw i64 %54, 1
  %72 = icmp eq i64 %71, %37
  br i1 %72, label %50, label %53, !llvm.loop !94

73:                                               ; preds = %111, %85
  %74 = icmp sgt i64 %76, 1
  br i1 %74, label %75, label %84, !llvm.loop !95

75:                                               ; preds = %46, %73
  %76 = phi i64 [ %1, %46 ], [ %77, %73 ]
  %77 = add nsw i64 %76, -1
  %78 = icmp slt i64 %76, %1
  br i1 %78, label %79, label %85

79:                                               ; preds = %75
  %80 = mul nsw i64 %77, %1
  %81 = getelementptr double, ptr %0, i64 %80
  %82 = mul nsw i64 %77, %4
  %83 = getelementptr double, ptr %3, i64 %82
  br label %91

84:                                               ; preds = %73, %44
  ret void

85:                                               ; preds = %108, %75
  br i1 %48, label %86, label %73

86:                                               ; preds = %85
  %87 = mul nsw i64 %77, %4
  %88 = getelementptr double, ptr %3, i64 %87
  %89 = mul i64 %77, %49
  %90 = getelementptr inbounds double, ptr %0, i64 %89
  br label %111

91:                                               ; preds = %79, %108
  %92 = phi i64 [ %76, %79 ], [ %109, %108 ]
  br i1 %47, label %93, label %108

93:                                               ; preds = %91
  %94 = getelementptr double, ptr %81, i64 %92
  %95 = load double, ptr %94, align 8
  %96 = mul nsw i64 %92, %4
  %97 = getelementptr double, ptr %3, i64 %96
  %98 = fneg double %95
  br label %99

99:                                               ; preds = %93, %99
  %100 = phi i64 [ 0, %93 ], [ %106, %99 ]
  %101 = getelementptr double, ptr %83, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = getelementptr double, ptr %97, i64 %100
  %104 = load double, ptr %103, align 8
  %105 = tail call double @llvm.fma.f64(double %98, double %104, double %102)
  store double %105, ptr %101, align 8
  %106 = add nuw nsw i64 %100, 1
  %107 = icmp eq i64 %106, %4
  br i1 %107, label %108, label %99, !llvm.loop !93

108:                                              ; preds = %99, %91
  %109 = add nuw nsw i64 %92, 1
  %110 = icmp eq i64 %109, %1
  br i1 %110, label %85, label %91, !llvm.loop !96

111:                                              ; preds = %86, %111
  %112 = phi i64 [ 0, %86 ], [ %117, %111 ]
  %113 = getelementptr double, ptr %88, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = load double, ptr %90, align 8
  %116 = fmul double %114, %115
  store double %116, ptr %113, align 8
  %117 = add nuw nsw i64 %112, 1
  %118 = icmp eq i64 %117, %4
  br i1 %118, label %73, label %111, !llvm.loop !97
}

define internal fastcc void @pair_solve_columns(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3, i64 noundef %4) unnamed_addr #5 {
  %6 = shl i64 %4, 1
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %11

8:                                                ; preds = %5
  %9 = icmp eq i64 %4, 0
  %10 = tail call i64 @llvm.umax.i64(i64 %6, i64 1)
  br label %15

11:                                               ; preds = %21, %5
  %12 = icmp sgt i64 %1, 0
  br i1 %12, label %13, label %44

13:                                               ; preds = %11
  %14 = icmp sgt i64 %4, 0
  br label %38

15:                                               ; preds = %8, %21
  %16 = phi i64 [ 0, %8 ], [ %22, %21 ]
  %17 = getelementptr inbounds double, ptr %2, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = uitofp nneg i64 %16 to double
  %20 = fcmp oeq double %18, %19
  br i1 %20, label %21, label %24

21:                                               ; preds = %30, %24, %15
  %22 = add nuw nsw i64 %16, 1
  %23 = icmp eq i64 %22, %1
  br i1 %23, label %11, label %15, !llvm.loop !81

24:                                               ; preds = %15
  %25 = mul nuw nsw i64 %16, %6
  %26 = getelementptr inbounds double, ptr %3, i64 %25
  %27 = fptosi double %18 to i64
  %28 = mul nsw i64 %6, %27
  %29 = getelementptr inbounds double, ptr %3, i64 %28
  br i1 %9, label %21, label %30

30:                                               ; preds = %24, %30
  %31 = phi i64 [ %36, %30 ], [ 0, %24 ]
  %32 = getelementptr inbounds double, ptr %26, i64 %31
  %33 = load double, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %29, i64 %31
  %35 = load double, ptr %34, align 8
  store double %35, ptr %32, align 8
  store double %33, ptr %34, align 8
  %36 = add nuw nsw i64 %31, 1
  %37 = icmp eq i64 %36, %10
  br i1 %37, label %21, label %30, !llvm.loop !86

38:                                               ; preds = %13, %51
  %39 = phi i64 [ 0, %13 ], [ %52, %51 ]
  %40 = icmp eq i64 %39, 0
  br i1 %40, label %51, label %41

41:                                               ; preds = %38
  %42 = mul nuw nsw i64 %39, %1
  %43 = mul nsw i64 %39, %4
  br label %54

44:                                               ; preds = %51, %11
  %45 = icmp sgt i64 %1, 0
  br i1 %45, label %46, label %102

46:                                               ; preds = %44
  %47 = icmp sgt i64 %4, 0
  %48 = icmp sgt i64 %4, 0
  %49 = shl nuw i64 %1, 1
  %50 = add i64 %49, 2
  br label %95

51:                                               ; preds = %90, %38
  %52 = add nuw nsw i64 %39, 1
  %53 = icmp eq i64 %52, %1
  br i1 %53, label %44, label %38, !llvm.loop !98

54:                                               ; preds = %41, %90
  %55 = phi i64 [ 0, %41 ], [ %91, %90 ]
  %56 = add nuw nsw i64 %55, %42
  %57 = shl nuw nsw i64 %56, 1
  %58 = getelementptr inbounds double, ptr %0, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = or disjoint i64 %57, 1
  %61 = getelementptr inbounds double, ptr %0, i64 %60
  %62 = load double, ptr %61, align 8
  br i1 %14, label %63, label %90

63:                                               ; preds = %54
  %64 = mul nuw nsw i64 %55, %4
  %65 = fneg double %62
  br label %66

66:                                               ; preds = %63, %66
  %67 = phi i64 [ 0, %63 ], [ %88, %66 ]
  %68 = add nuw nsw i64 %67, %43
  %69 = shl nuw nsw i64 %68, 1
  %70 = getelementptr inbounds double, ptr %3, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = or disjoint i64 %69, 1
  %73 = getelementptr inbounds double, ptr %3, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = add nuw nsw i64 %67, %64
  %76 = shl nuw nsw i64 %75, 1
  %77 = getelementptr inbounds double, ptr %3, i64 %76
  %78 = load double, ptr %77, align 8
  %79 = or disjoint i64 %76, 1
  %80 = getelementptr inbounds double, ptr %3, i64 %79
  %81 = load double, ptr %80, align 8
  %82 = fmul double %81, %65
  %83 = tail call double @llvm.fma.f64(double %59, double %78, double %82)
  %84 = fmul double %62, %78
  %85 = tail call double @llvm.fma.f64(double %59, double %81, double %84)
  %86 = fsub double %71, %83
  %87 = fsub double %74, %85
  store double %86, ptr %70, align 8
  store double %87, ptr %73, align 8
  %88 = add nuw nsw i64 %67, 1
  %89 = icmp eq i64 %88, %4
  br i1 %89, label %90, label %66, !llvm.loop !99

90:                                               ; preds = %66, %54
  %91 = add nuw nsw i64 %55, 1
  %92 = icmp eq i64 %91, %39
  br i1 %92, label %51, label %54, !llvm.loop !100

93:                                               ; preds = %149, %103
  %94 = icmp sgt i64 %96, 1
  br i1 %94, label %95, label %102, !llvm.loop !101

95:                                               ; preds = %46, %93
  %96 = phi i64 [ %1, %46 ], [ %97, %93 ]
  %97 = add nsw i64 %96, -1
  %98 = icmp slt i64 %96, %1
  br i1 %98, label %99, label %103

99:                                               ; preds = %95
  %100 = mul nsw i64 %97, %1
  %101 = mul nsw i64 %97, %4
  br label %110

102:                                              ; preds = %93, %44
  ret void

103:                                              ; preds = %146, %95
  br i1 %48, label %104, label %93

104:                                              ; preds = %103
  %105 = mul i64 %50, %97
  %106 = mul nsw i64 %97, %4
  %107 = getelementptr inbounds double, ptr %0, i64 %105
  %108 = or disjoint i64 %105, 1
  %109 = getelementptr inbounds double, ptr %0, i64 %108
  br label %149

110:                                              ; preds = %99, %146
  %111 = phi i64 [ %96, %99 ], [ %147, %146 ]
  %112 = add nuw nsw i64 %111, %100
  %113 = shl nsw i64 %112, 1
  %114 = getelementptr inbounds double, ptr %0, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = or disjoint i64 %113, 1
  %117 = getelementptr inbounds double, ptr %0, i64 %116
  %118 = load double, ptr %117, align 8
  br i1 %47, label %119, label %146

119:                                              ; preds = %110
  %120 = mul nsw i64 %111, %4
  %121 = fneg double %118
  br label %122

122:                                              ; preds = %119, %122
  %123 = phi i64 [ 0, %119 ], [ %144, %122 ]
  %124 = add nsw i64 %123, %101
  %125 = shl nsw i64 %124, 1
  %126 = getelementptr inbounds double, ptr %3, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = or disjoint i64 %125, 1
  %129 = getelementptr inbounds double, ptr %3, i64 %128
  %130 = load double, ptr %129, align 8
  %131 = add nsw i64 %123, %120
  %132 = shl nsw i64 %131, 1
  %133 = getelementptr inbounds double, ptr %3, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = or disjoint i64 %132, 1
  %136 = getelementptr inbounds double, ptr %3, i64 %135
  %137 = load double, ptr %136, align 8
  %138 = fmul double %137, %121
  %139 = tail call double @llvm.fma.f64(double %115, double %134, double %138)
  %140 = fmul double %118, %134
  %141 = tail call double @llvm.fma.f64(double %115, double %137, double %140)
  %142 = fsub double %127, %139
  %143 = fsub double %130, %141
  store double %142, ptr %126, align 8
  store double %143, ptr %129, align 8
  %144 = add nuw nsw i64 %123, 1
  %145 = icmp eq i64 %144, %4
  br i1 %145, label %146, label %122, !llvm.loop !99

146:                                              ; preds = %122, %110
  %147 = add nuw nsw i64 %111, 1
  %148 = icmp eq i64 %147, %1
  br i1 %148, label %103, label %110, !llvm.loop !102

149:                                              ; preds = %104, %149
  %150 = phi i64 [ 0, %104 ], [ %165, %149 ]
  %151 = add nsw i64 %150, %106
  %152 = shl nsw i64 %151, 1
  %153 = getelementptr inbounds double, ptr %3, i64 %152
  %154 = load double, ptr %153, align 8
  %155 = or disjoint i64 %152, 1
  %156 = getelementptr inbounds double, ptr %3, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = load double, ptr %107, align 8
  %159 = load double, ptr %109, align 8
  %160 = fneg double %157
  %161 = fmul double %159, %160
  %162 = tail call double @llvm.fma.f64(double %154, double %158, double %161)
  %163 = fmul double %157, %158
  %164 = tail call double @llvm.fma.f64(double %154, double %159, double %163)
  store double %162, ptr %153, align 8
  store double %164, ptr %156, align 8
  %165 = add nuw nsw i64 %150, 1
  %166 = icmp eq i64 %165, %4
  br i1 %166, label %93, label %149, !llvm.loop !103
}

define internal fastcc double @knot_after(ptr noundef readonly %0, double noundef %1) unnamed_addr #7 {
  %3 = tail call double @llvm.fabs.f64(double %1)
  %4 = fmul double %3, 0x3D10000000000000
  %5 = fadd double %4, %1
  %6 = getelementptr inbounds i8, ptr %0, i64 104
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %16

9:                                                ; preds = %2
  %10 = getelementptr inbounds i8, ptr %0, i64 96
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 112
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 120
  %15 = load ptr, ptr %14, align 8
  br label %18

16:                                               ; preds = %68, %2
  %17 = phi double [ 0x7FF0000000000000, %2 ], [ %69, %68 ]
  ret double %17

18:                                               ; preds = %9, %68
  %19 = phi double [ 0x7FF0000000000000, %9 ], [ %69, %68 ]
  %20 = phi i64 [ 0, %9 ], [ %70, %68 ]
  %21 = mul nsw i64 %13, %20
  %22 = getelementptr inbounds i64, ptr %11, i64 %21
  %23 = getelementptr inbounds i8, ptr %22, i64 8
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %15, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %5
  br i1 %27, label %58, label %28

28:                                               ; preds = %18
  %29 = getelementptr inbounds i8, ptr %22, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = fcmp ugt double %26, %5
  br i1 %31, label %40, label %32

32:                                               ; preds = %28
  %33 = icmp eq i64 %30, 1
  br i1 %33, label %55, label %34

34:                                               ; preds = %32
  %35 = getelementptr i8, ptr %25, i64 8
  %36 = load double, ptr %35, align 8
  %37 = fcmp ule double %36, %5
  %38 = icmp sgt i64 %30, 1
  %39 = select i1 %37, i1 %38, i1 false
  br i1 %39, label %42, label %55

40:                                               ; preds = %28
  %41 = icmp sgt i64 %30, 1
  br i1 %41, label %42, label %55

42:                                               ; preds = %40, %34
  br label %43

43:                                               ; preds = %42, %43
  %44 = phi i64 [ %52, %43 ], [ %30, %42 ]
  %45 = phi i64 [ %51, %43 ], [ 0, %42 ]
  %46 = add nsw i64 %44, %45
  %47 = sdiv i64 %46, 2
  %48 = getelementptr inbounds double, ptr %25, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = fcmp ugt double %49, %5
  %51 = select i1 %50, i64 %45, i64 %47
  %52 = select i1 %50, i64 %47, i64 %44
  %53 = sub nsw i64 %52, %51
  %54 = icmp sgt i64 %53, 1
  br i1 %54, label %43, label %55, !llvm.loop !66

55:                                               ; preds = %43, %40, %32, %34
  %56 = phi i64 [ 0, %34 ], [ 0, %32 ], [ 0, %40 ], [ %51, %43 ]
  %57 = add nsw i64 %56, 1
  br label %58

58:                                               ; preds = %18, %55
  %59 = phi i64 [ %57, %55 ], [ 0, %18 ]
  %60 = getelementptr inbounds i8, ptr %22, i64 16
  %61 = load i64, ptr %60, align 8
  %62 = icmp slt i64 %59, %61
  br i1 %62, label %63, label %68

63:                                               ; preds = %58
  %64 = getelementptr inbounds double, ptr %25, i64 %59
  %65 = load double, ptr %64, align 8
  %66 = fcmp olt double %65, %19
  br i1 %66, label %67, label %68

67:                                               ; preds = %63
  br label %68

68:                                               ; preds = %67, %63, %58
  %69 = phi double [ %65, %67 ], [ %19, %63 ], [ %19, %58 ]
  %70 = add nuw nsw i64 %20, 1
  %71 = icmp eq i64 %70, %7
  br i1 %71, label %16, label %18, !llvm.loop !104
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
  br i1 %31, label %20, label %19, !llvm.loop !105

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
  br i1 %43, label %32, label %24, !llvm.loop !106
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #9

declare i64 @llvm.smin.i64(i64, i64) #9

declare i64 @llvm.umax.i64(i64, i64) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn }
attributes #7 = { noinline nounwind }
attributes #8 = { noinline nounwind }
attributes #9 = { nounwind willreturn memory(none) }
attributes #10 = { nounwind }
attributes #11 = { nounwind }
attributes #12 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5}
!8 = !{!9}
!9 = distinct !{!9, !10, !"implicit_of: argument 0"}
!10 = distinct !{!10, !"implicit_of"}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = !{!16}
!16 = distinct !{!16, !17, !"try_step: argument 0"}
!17 = distinct !{!17, !"try_step"}
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
!28 = !{!29, !16}
!29 = distinct !{!29, !30, !"solve_stages: argument 0"}
!30 = distinct !{!30, !"solve_stages"}
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
!53 = distinct !{!53, !5}
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
!86 = distinct !{!86, !4, !5, !87}
!87 = !{!"llvm.loop.vectorize.width", i32 1}
!88 = distinct !{!88, !4, !5}
!89 = distinct !{!89, !4, !5}
!90 = distinct !{!90, !4, !5}
!91 = distinct !{!91, !4, !5}
!92 = distinct !{!92, !4, !5}
!93 = distinct !{!93, !4, !5}
!94 = distinct !{!94, !4, !5}
!95 = distinct !{!95, !4, !5}
!96 = distinct !{!96, !4, !5}
!97 = distinct !{!97, !4, !5}
!98 = distinct !{!98, !4, !5}
!99 = distinct !{!99, !4, !5}
!100 = distinct !{!100, !4, !5}
!101 = distinct !{!101, !4, !5}
!102 = distinct !{!102, !4, !5}
!103 = distinct !{!103, !4, !5}
!104 = distinct !{!104, !4, !5}
!105 = distinct !{!105, !4, !5}
!106 = distinct !{!106, !4, !5}
