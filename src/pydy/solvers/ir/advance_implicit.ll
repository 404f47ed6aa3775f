; sources 4da5790c9f15c38de3be0883a4dc8bcbbca1a11f5bb7c8cd24edefaed129ceef
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
  %206 = getelementptr inbounds i8, ptr %0, i64 384
  %207 = getelementptr inbounds i8, ptr %0, i64 336
  %208 = getelementptr inbounds i8, ptr %0, i64 528
  %209 = getelementptr inbounds i8, ptr %0, i64 168
  %210 = getelementptr inbounds i8, ptr %0, i64 248
  %211 = getelementptr inbounds i8, ptr %0, i64 192
  %212 = getelementptr inbounds i8, ptr %0, i64 216
  %213 = getelementptr inbounds i8, ptr %0, i64 768
  br label %214

214:                                              ; preds = %2626, %80
  %215 = phi double [ undef, %80 ], [ %2606, %2626 ]
  %216 = phi double [ undef, %80 ], [ %2607, %2626 ]
  %217 = phi double [ undef, %80 ], [ %2608, %2626 ]
  %218 = phi i64 [ undef, %80 ], [ %2609, %2626 ]
  %219 = phi i64 [ undef, %80 ], [ %2610, %2626 ]
  %220 = phi i64 [ undef, %80 ], [ %2611, %2626 ]
  %221 = load ptr, ptr %84, align 8
  %222 = load ptr, ptr %85, align 8
  %223 = getelementptr inbounds i8, ptr %222, i64 56
  %224 = load i64, ptr %223, align 8
  %225 = icmp eq i64 %224, 0
  br i1 %225, label %2605, label %226

226:                                              ; preds = %214
  %227 = load ptr, ptr %81, align 8
  %228 = getelementptr inbounds i8, ptr %227, i64 8
  %229 = load i64, ptr %228, align 8
  %230 = load ptr, ptr %86, align 8
  %231 = load i64, ptr %87, align 8
  %232 = getelementptr double, ptr %230, i64 %231
  %233 = getelementptr i8, ptr %232, i64 -8
  %234 = load double, ptr %233, align 8
  %235 = load double, ptr %230, align 8
  %236 = fsub double %234, %235
  %237 = fmul double %236, 0x3D70000000000000
  %238 = load ptr, ptr %88, align 8, !noalias !8
  %239 = load double, ptr %238, align 8, !noalias !8
  %240 = icmp sgt i64 %229, 0
  br i1 %240, label %241, label %250

241:                                              ; preds = %226, %241
  %242 = phi i64 [ %248, %241 ], [ 0, %226 ]
  %243 = phi double [ %247, %241 ], [ %239, %226 ]
  %244 = getelementptr inbounds double, ptr %238, i64 %242
  %245 = load double, ptr %244, align 8, !noalias !8
  %246 = fcmp olt double %245, %243
  %247 = select i1 %246, double %245, double %243
  %248 = add nuw nsw i64 %242, 1
  %249 = icmp eq i64 %248, %229
  br i1 %249, label %250, label %241, !llvm.loop !11

250:                                              ; preds = %241, %226
  %251 = phi double [ %239, %226 ], [ %247, %241 ]
  %252 = load ptr, ptr %89, align 8
  %253 = load i64, ptr %252, align 8
  %254 = icmp eq i64 %253, 1
  %255 = load ptr, ptr %90, align 8
  %256 = getelementptr inbounds i8, ptr %255, i64 8
  %257 = load i64, ptr %256, align 8
  %258 = icmp sgt i64 %257, 0
  %259 = load double, ptr %221, align 8
  %260 = getelementptr inbounds i8, ptr %221, i64 8
  %261 = load double, ptr %260, align 8
  %262 = load i64, ptr %222, align 8
  %263 = icmp eq i64 %262, 0
  br i1 %263, label %264, label %415

264:                                              ; preds = %250
  %265 = load i64, ptr %91, align 8
  %266 = icmp eq i64 %265, 0
  br i1 %266, label %296, label %267

267:                                              ; preds = %264
  %268 = icmp sgt i64 %265, 0
  br i1 %268, label %269, label %284

269:                                              ; preds = %267
  %270 = load ptr, ptr %92, align 8
  br label %271

271:                                              ; preds = %269, %271
  %272 = phi i64 [ 0, %269 ], [ %282, %271 ]
  %273 = phi i64 [ %265, %269 ], [ %281, %271 ]
  %274 = add nuw nsw i64 %272, %273
  %275 = lshr i64 %274, 1
  %276 = mul i64 %275, 24
  %277 = getelementptr inbounds i8, ptr %270, i64 %276
  %278 = load double, ptr %277, align 8
  %279 = fcmp ogt double %278, %259
  %280 = add nuw nsw i64 %275, 1
  %281 = select i1 %279, i64 %275, i64 %273
  %282 = select i1 %279, i64 %272, i64 %280
  %283 = icmp slt i64 %282, %281
  br i1 %283, label %271, label %284, !llvm.loop !12

284:                                              ; preds = %271, %267
  %285 = phi i64 [ 0, %267 ], [ %282, %271 ]
  %286 = icmp slt i64 %285, %265
  br i1 %286, label %287, label %293

287:                                              ; preds = %284
  %288 = load ptr, ptr %92, align 8
  %289 = mul i64 %285, 24
  %290 = getelementptr inbounds i8, ptr %288, i64 %289
  %291 = getelementptr inbounds i8, ptr %290, i64 8
  %292 = load double, ptr %291, align 8
  br label %293

293:                                              ; preds = %287, %284
  %294 = phi double [ %292, %287 ], [ 0x7FF0000000000000, %284 ]
  %295 = load ptr, ptr %93, align 8
  store double %294, ptr %295, align 8
  br label %296

296:                                              ; preds = %293, %264
  %297 = getelementptr inbounds i8, ptr %222, i64 24
  %298 = load i64, ptr %297, align 8
  %299 = add nsw i64 %298, 1
  store i64 %299, ptr %297, align 8
  %300 = load ptr, ptr %82, align 8
  %301 = load ptr, ptr %94, align 8
  %302 = load ptr, ptr %95, align 8
  store double %259, ptr %302, align 8
  %303 = load ptr, ptr %81, align 8
  %304 = getelementptr inbounds i8, ptr %303, i64 40
  %305 = load i64, ptr %304, align 8
  %306 = icmp eq i64 %305, 0
  br i1 %306, label %308, label %307

307:                                              ; preds = %296
  tail call fastcc void @settle(ptr noundef nonnull %81) #9
  br label %308

308:                                              ; preds = %307, %296
  %309 = load i64, ptr %96, align 8
  %310 = icmp sgt i64 %309, 0
  br i1 %310, label %311, label %312

311:                                              ; preds = %308
  tail call fastcc void @sample(ptr noundef nonnull %81) #9
  br label %312

312:                                              ; preds = %308, %311
  %313 = load ptr, ptr %81, align 8
  %314 = load i64, ptr %313, align 8
  %315 = load ptr, ptr %95, align 8
  %316 = load ptr, ptr %97, align 8
  %317 = load ptr, ptr %98, align 8
  %318 = inttoptr i64 %314 to ptr
  %319 = load ptr, ptr %318, align 8
  %320 = tail call i32 %319(ptr noundef %315, ptr noundef %300, ptr noundef %316, ptr noundef %317, ptr noundef %301) #10
  %321 = icmp eq i32 %320, 0
  br i1 %321, label %326, label %322

322:                                              ; preds = %312
  %323 = getelementptr inbounds i8, ptr %222, i64 72
  store i64 3, ptr %323, align 8
  %324 = icmp slt i32 %320, 0
  %325 = select i1 %324, i64 -4, i64 2
  br label %2605

326:                                              ; preds = %312
  store i64 1, ptr %222, align 8
  %327 = load ptr, ptr %83, align 8
  %328 = getelementptr inbounds i8, ptr %327, i64 16
  %329 = load i64, ptr %328, align 8
  %330 = and i64 %329, -2
  store i64 %330, ptr %328, align 8
  %331 = load ptr, ptr %83, align 8
  %332 = getelementptr inbounds i8, ptr %331, i64 32
  %333 = load i64, ptr %332, align 8
  %334 = or i64 %333, 1
  store i64 %334, ptr %332, align 8
  %335 = load ptr, ptr %83, align 8
  %336 = getelementptr inbounds i8, ptr %335, i64 8
  %337 = load i64, ptr %336, align 8
  %338 = and i64 %337, -2
  %339 = getelementptr inbounds i8, ptr %335, i64 16
  %340 = load i64, ptr %339, align 8
  %341 = and i64 %340, 1
  %342 = or disjoint i64 %341, %338
  %343 = xor i64 %342, 1
  store i64 %343, ptr %336, align 8
  %344 = load ptr, ptr %99, align 8
  %345 = getelementptr inbounds i8, ptr %344, i64 8
  store double 0.000000e+00, ptr %345, align 8
  %346 = load ptr, ptr %99, align 8
  %347 = getelementptr inbounds i8, ptr %346, i64 24
  store double 0.000000e+00, ptr %347, align 8
  %348 = load ptr, ptr %82, align 8
  %349 = load ptr, ptr %81, align 8
  %350 = getelementptr inbounds i8, ptr %349, i64 8
  %351 = load i64, ptr %350, align 8
  %352 = load i64, ptr %87, align 8
  %353 = load ptr, ptr %86, align 8
  %354 = load ptr, ptr %85, align 8
  %355 = getelementptr inbounds i8, ptr %354, i64 48
  %356 = load i64, ptr %355, align 8
  %357 = icmp slt i64 %356, %352
  br i1 %357, label %358, label %381

358:                                              ; preds = %326
  %359 = icmp sgt i64 %351, 0
  br label %360

360:                                              ; preds = %358, %371
  %361 = phi i64 [ %356, %358 ], [ %372, %371 ]
  %362 = getelementptr inbounds double, ptr %353, i64 %361
  %363 = load double, ptr %362, align 8
  %364 = load ptr, ptr %84, align 8
  %365 = load double, ptr %364, align 8
  %366 = fcmp ugt double %363, %365
  br i1 %366, label %381, label %367

367:                                              ; preds = %360
  br i1 %359, label %368, label %371

368:                                              ; preds = %367
  %369 = mul nsw i64 %361, %351
  %370 = getelementptr double, ptr %1, i64 %369
  br label %374

371:                                              ; preds = %374, %367
  %372 = add i64 %361, 1
  %373 = icmp eq i64 %372, %352
  br i1 %373, label %381, label %360, !llvm.loop !13

374:                                              ; preds = %368, %374
  %375 = phi i64 [ 0, %368 ], [ %379, %374 ]
  %376 = getelementptr inbounds double, ptr %348, i64 %375
  %377 = load double, ptr %376, align 8
  %378 = getelementptr double, ptr %370, i64 %375
  store double %377, ptr %378, align 8
  %379 = add nuw nsw i64 %375, 1
  %380 = icmp eq i64 %379, %351
  br i1 %380, label %371, label %374, !llvm.loop !14

381:                                              ; preds = %360, %371, %326
  %382 = phi i64 [ %356, %326 ], [ %361, %360 ], [ %352, %371 ]
  %383 = load ptr, ptr %85, align 8
  %384 = getelementptr inbounds i8, ptr %383, i64 48
  store i64 %382, ptr %384, align 8
  %385 = icmp eq i64 %382, %352
  br i1 %385, label %2605, label %386

386:                                              ; preds = %381
  %387 = fcmp oeq double %261, 0.000000e+00
  br i1 %387, label %388, label %415

388:                                              ; preds = %386
  %389 = load ptr, ptr %81, align 8
  %390 = getelementptr inbounds i8, ptr %389, i64 24
  %391 = load i64, ptr %390, align 8
  %392 = getelementptr inbounds i8, ptr %221, i64 16
  %393 = load double, ptr %392, align 8
  %394 = load ptr, ptr %82, align 8
  call fastcc void @norm_to(ptr noundef nonnull %11, ptr noundef %394, ptr noundef %394, ptr noundef nonnull %82, i64 noundef %391) #9
  %395 = load double, ptr %11, align 8
  %396 = load ptr, ptr %100, align 8
  call fastcc void @norm_to(ptr noundef nonnull %12, ptr noundef %396, ptr noundef %394, ptr noundef nonnull %82, i64 noundef %391) #9
  %397 = load double, ptr %12, align 8
  %398 = fcmp uge double %395, 1.000000e-05
  %399 = fcmp uge double %397, 1.000000e-05
  %400 = and i1 %398, %399
  %401 = fmul double %395, 1.000000e-02
  %402 = fdiv double %401, %397
  %403 = select i1 %400, double %402, double 0x3EB0C6F7A0B5ED8D
  %404 = fcmp olt double %393, %403
  %405 = select i1 %404, double %393, double %403
  %406 = tail call double @llvm.fabs.f64(double %259)
  %407 = fmul double %406, 0x3D30000000000000
  %408 = fcmp ogt double %407, %405
  %409 = select i1 %408, double %407, double %405
  %410 = fcmp olt double %393, %409
  %411 = select i1 %410, double %393, double %409
  %412 = tail call i1 @llvm.is.fpclass.f64(double %411, i32 639)
  br i1 %412, label %413, label %415

413:                                              ; preds = %388
  %414 = getelementptr inbounds i8, ptr %222, i64 72
  store i64 4, ptr %414, align 8
  br label %415

415:                                              ; preds = %388, %413, %386, %250
  %416 = phi double [ %261, %386 ], [ %261, %250 ], [ %411, %413 ], [ %411, %388 ]
  %417 = load i64, ptr %223, align 8
  %418 = icmp eq i64 %417, 0
  br i1 %418, label %445, label %419

419:                                              ; preds = %415
  %420 = getelementptr inbounds i8, ptr %222, i64 8
  %421 = getelementptr inbounds i8, ptr %222, i64 16
  %422 = getelementptr inbounds i8, ptr %222, i64 64
  %423 = getelementptr inbounds i8, ptr %221, i64 16
  %424 = fcmp ogt double %251, 0x3CB0000000000000
  %425 = select i1 %424, double %251, double 0x3CB0000000000000
  %426 = fdiv double 0x3CE4000000000000, %425
  %427 = tail call double @llvm.sqrt.f64(double %251)
  %428 = fcmp olt double %427, 3.000000e-02
  %429 = select i1 %428, double %427, double 3.000000e-02
  %430 = fcmp ogt double %429, %426
  %431 = select i1 %430, double %429, double %426
  %432 = fmul double %251, %431
  %433 = fmul double %432, %432
  %434 = getelementptr inbounds i8, ptr %222, i64 24
  %435 = getelementptr inbounds i8, ptr %222, i64 32
  %436 = getelementptr inbounds i8, ptr %222, i64 40
  %437 = getelementptr inbounds i8, ptr %222, i64 72
  %438 = getelementptr inbounds i8, ptr %221, i64 32
  %439 = getelementptr inbounds i8, ptr %222, i64 48
  %440 = icmp sgt i64 %229, 0
  %441 = getelementptr inbounds i8, ptr %222, i64 72
  %442 = getelementptr inbounds i8, ptr %222, i64 48
  %443 = getelementptr inbounds i8, ptr %222, i64 72
  %444 = getelementptr inbounds i8, ptr %222, i64 72
  br label %453

445:                                              ; preds = %2602, %415
  %446 = phi double [ %215, %415 ], [ %2592, %2602 ]
  %447 = phi double [ %216, %415 ], [ %2593, %2602 ]
  %448 = phi double [ %217, %415 ], [ %2594, %2602 ]
  %449 = phi i64 [ %218, %415 ], [ %2595, %2602 ]
  %450 = phi i64 [ %219, %415 ], [ %2596, %2602 ]
  %451 = phi i64 [ %220, %415 ], [ %2597, %2602 ]
  %452 = phi double [ %416, %415 ], [ %2598, %2602 ]
  store double %452, ptr %260, align 8
  br label %2605

453:                                              ; preds = %419, %2602
  %454 = phi i64 [ %417, %419 ], [ %2603, %2602 ]
  %455 = phi i64 [ undef, %419 ], [ %2601, %2602 ]
  %456 = phi double [ %259, %419 ], [ %2599, %2602 ]
  %457 = phi double [ %416, %419 ], [ %2598, %2602 ]
  %458 = phi i64 [ %220, %419 ], [ %2597, %2602 ]
  %459 = phi i64 [ %219, %419 ], [ %2596, %2602 ]
  %460 = phi i64 [ %218, %419 ], [ %2595, %2602 ]
  %461 = phi double [ %217, %419 ], [ %2594, %2602 ]
  %462 = phi double [ %216, %419 ], [ %2593, %2602 ]
  %463 = phi double [ %215, %419 ], [ %2592, %2602 ]
  %464 = load ptr, ptr %101, align 8
  %465 = getelementptr inbounds i8, ptr %464, i64 8
  %466 = load i64, ptr %465, align 8
  %467 = icmp sgt i64 %466, 0
  br i1 %467, label %468, label %473

468:                                              ; preds = %453
  %469 = load i64, ptr %464, align 8
  %470 = add nsw i64 %469, 3
  %471 = icmp slt i64 %466, %470
  %472 = zext i1 %471 to i32
  br label %473

473:                                              ; preds = %453, %468
  %474 = phi i32 [ 0, %453 ], [ %472, %468 ]
  %475 = icmp eq i32 %474, 0
  br i1 %475, label %477, label %476

476:                                              ; preds = %473
  store double %457, ptr %260, align 8
  br label %2605

477:                                              ; preds = %473
  %478 = add nsw i64 %454, -1
  store i64 %478, ptr %223, align 8
  %479 = load i64, ptr %420, align 8
  %480 = load i64, ptr %421, align 8
  %481 = add nsw i64 %480, %479
  %482 = load i64, ptr %422, align 8
  %483 = icmp slt i64 %481, %482
  br i1 %483, label %485, label %484

484:                                              ; preds = %477
  store double %457, ptr %260, align 8
  br label %2605

485:                                              ; preds = %477
  %486 = load i64, ptr %102, align 8
  %487 = icmp eq i64 %486, 0
  br i1 %487, label %521, label %488

488:                                              ; preds = %485
  %489 = icmp sgt i64 %486, 0
  br i1 %489, label %490, label %505

490:                                              ; preds = %488
  %491 = load ptr, ptr %103, align 8
  br label %492

492:                                              ; preds = %490, %492
  %493 = phi i64 [ 0, %490 ], [ %503, %492 ]
  %494 = phi i64 [ %486, %490 ], [ %502, %492 ]
  %495 = add nuw nsw i64 %493, %494
  %496 = lshr i64 %495, 1
  %497 = mul i64 %496, 24
  %498 = getelementptr inbounds i8, ptr %491, i64 %497
  %499 = load double, ptr %498, align 8
  %500 = fcmp ogt double %499, %456
  %501 = add nuw nsw i64 %496, 1
  %502 = select i1 %500, i64 %496, i64 %494
  %503 = select i1 %500, i64 %493, i64 %501
  %504 = icmp slt i64 %503, %502
  br i1 %504, label %492, label %505, !llvm.loop !12

505:                                              ; preds = %492, %488
  %506 = phi i64 [ 0, %488 ], [ %503, %492 ]
  %507 = load ptr, ptr %103, align 8
  %508 = mul i64 %506, 24
  %509 = getelementptr inbounds i8, ptr %507, i64 %508
  %510 = icmp slt i64 %506, %486
  br i1 %510, label %511, label %514

511:                                              ; preds = %505
  %512 = getelementptr inbounds i8, ptr %509, i64 8
  %513 = load double, ptr %512, align 8
  br label %514

514:                                              ; preds = %511, %505
  %515 = phi double [ %513, %511 ], [ 0x7FF0000000000000, %505 ]
  %516 = load ptr, ptr %104, align 8
  store double %515, ptr %516, align 8
  %517 = load i64, ptr %102, align 8
  %518 = icmp slt i64 %506, %517
  br i1 %518, label %519, label %521

519:                                              ; preds = %514
  %520 = load double, ptr %509, align 8
  br label %521

521:                                              ; preds = %485, %514, %519
  %522 = phi double [ 0x7FF0000000000000, %485 ], [ %520, %519 ], [ 0x7FF0000000000000, %514 ]
  %523 = fcmp olt double %234, %522
  %524 = select i1 %523, double %234, double %522
  %525 = load double, ptr %423, align 8
  %526 = fcmp olt double %457, %525
  %527 = select i1 %526, double %457, double %525
  %528 = fadd double %456, %527
  %529 = fmul double %527, 1.000000e-03
  %530 = fsub double %524, %529
  %531 = fcmp ule double %528, %530
  %532 = select i1 %531, double %528, double %524
  %533 = fsub double %532, %456
  %534 = fmul double %533, 6.250000e-02
  %535 = fadd double %456, %534
  %536 = fcmp ule double %535, %456
  %537 = fcmp une double %532, %524
  %538 = and i1 %537, %536
  br i1 %538, label %539, label %540

539:                                              ; preds = %521
  store double %533, ptr %260, align 8
  br label %2591

540:                                              ; preds = %521
  %541 = load ptr, ptr %81, align 8, !noalias !15
  %542 = getelementptr inbounds i8, ptr %541, i64 8
  %543 = load i64, ptr %542, align 8, !noalias !15
  %544 = load ptr, ptr %83, align 8, !noalias !15
  %545 = getelementptr inbounds i8, ptr %544, i64 8
  %546 = load i64, ptr %545, align 8, !noalias !15
  %547 = and i64 %546, 1
  %548 = icmp eq i64 %547, 0
  br i1 %548, label %680, label %549

549:                                              ; preds = %540
  %550 = load ptr, ptr %106, align 8, !noalias !15
  %551 = load i64, ptr %544, align 8, !noalias !15
  %552 = icmp eq i64 %551, 0
  br i1 %552, label %553, label %555

553:                                              ; preds = %549
  %554 = icmp sgt i64 %543, 0
  br i1 %554, label %579, label %577

555:                                              ; preds = %549
  %556 = load ptr, ptr %107, align 8, !noalias !15
  store double %456, ptr %556, align 8, !noalias !15
  %557 = load ptr, ptr %81, align 8, !noalias !15
  %558 = getelementptr inbounds i8, ptr %557, i64 40
  %559 = load i64, ptr %558, align 8, !noalias !15
  %560 = icmp eq i64 %559, 0
  br i1 %560, label %562, label %561

561:                                              ; preds = %555
  tail call fastcc void @settle(ptr noundef nonnull %81) #9, !noalias !15
  br label %562

562:                                              ; preds = %561, %555
  %563 = load i64, ptr %108, align 8, !noalias !15
  %564 = icmp sgt i64 %563, 0
  br i1 %564, label %565, label %566

565:                                              ; preds = %562
  tail call fastcc void @sample(ptr noundef nonnull %81) #9, !noalias !15
  br label %566

566:                                              ; preds = %565, %562
  %567 = load ptr, ptr %83, align 8, !noalias !15
  %568 = load i64, ptr %567, align 8, !noalias !15
  %569 = load ptr, ptr %107, align 8, !noalias !15
  %570 = load ptr, ptr %82, align 8, !noalias !15
  %571 = load ptr, ptr %109, align 8, !noalias !15
  %572 = load ptr, ptr %110, align 8, !noalias !15
  %573 = inttoptr i64 %568 to ptr
  %574 = load ptr, ptr %573, align 8, !noalias !15
  %575 = tail call i32 %574(ptr noundef %569, ptr noundef %570, ptr noundef %571, ptr noundef %572, ptr noundef %550) #10, !noalias !15
  %576 = sext i32 %575 to i64
  br label %651

577:                                              ; preds = %579, %553
  %578 = icmp sgt i64 %543, 0
  br i1 %578, label %591, label %651

579:                                              ; preds = %553, %579
  %580 = phi i64 [ %586, %579 ], [ 0, %553 ]
  %581 = load ptr, ptr %82, align 8, !noalias !15
  %582 = getelementptr inbounds double, ptr %581, i64 %580
  %583 = load double, ptr %582, align 8, !noalias !15
  %584 = load ptr, ptr %111, align 8, !noalias !15
  %585 = getelementptr inbounds double, ptr %584, i64 %580
  store double %583, ptr %585, align 8, !noalias !15
  %586 = add nuw nsw i64 %580, 1
  %587 = icmp eq i64 %586, %543
  br i1 %587, label %577, label %579, !llvm.loop !18

588:                                              ; preds = %649
  %589 = add nuw nsw i64 %593, 1
  %590 = icmp eq i64 %589, %543
  br i1 %590, label %651, label %591, !llvm.loop !19

591:                                              ; preds = %577, %588
  %592 = phi i64 [ %650, %588 ], [ undef, %577 ]
  %593 = phi i64 [ %589, %588 ], [ 0, %577 ]
  %594 = phi double [ %605, %588 ], [ 0.000000e+00, %577 ]
  %595 = load ptr, ptr %82, align 8, !noalias !15
  %596 = getelementptr inbounds double, ptr %595, i64 %593
  %597 = load double, ptr %596, align 8, !noalias !15
  %598 = tail call double @llvm.fabs.f64(double %597)
  %599 = fcmp olt double %598, 1.000000e-05
  %600 = select i1 %599, double 1.000000e-05, double %598
  %601 = fmul double %600, 1.500000e-08
  %602 = fadd double %597, %601
  %603 = load ptr, ptr %112, align 8, !noalias !15
  %604 = getelementptr inbounds double, ptr %603, i64 %593
  store double %602, ptr %604, align 8, !noalias !15
  %605 = fadd double %594, 1.000000e+00
  %606 = load ptr, ptr %112, align 8, !noalias !15
  %607 = load ptr, ptr %113, align 8, !noalias !15
  %608 = load ptr, ptr %114, align 8, !noalias !15
  store double %456, ptr %608, align 8, !noalias !15
  %609 = load ptr, ptr %81, align 8, !noalias !15
  %610 = getelementptr inbounds i8, ptr %609, i64 40
  %611 = load i64, ptr %610, align 8, !noalias !15
  %612 = icmp eq i64 %611, 0
  br i1 %612, label %614, label %613

613:                                              ; preds = %591
  tail call fastcc void @settle(ptr noundef nonnull %81) #9, !noalias !15
  br label %614

614:                                              ; preds = %613, %591
  %615 = load i64, ptr %115, align 8, !noalias !15
  %616 = icmp sgt i64 %615, 0
  br i1 %616, label %617, label %618

617:                                              ; preds = %614
  tail call fastcc void @sample(ptr noundef nonnull %81) #9, !noalias !15
  br label %618

618:                                              ; preds = %617, %614
  %619 = load ptr, ptr %81, align 8, !noalias !15
  %620 = load i64, ptr %619, align 8, !noalias !15
  %621 = load ptr, ptr %114, align 8, !noalias !15
  %622 = load ptr, ptr %116, align 8, !noalias !15
  %623 = load ptr, ptr %117, align 8, !noalias !15
  %624 = inttoptr i64 %620 to ptr
  %625 = load ptr, ptr %624, align 8, !noalias !15
  %626 = tail call i32 %625(ptr noundef %621, ptr noundef %606, ptr noundef %622, ptr noundef %623, ptr noundef %607) #10, !noalias !15
  %627 = sext i32 %626 to i64
  %628 = icmp eq i32 %626, 0
  br i1 %628, label %629, label %649

629:                                              ; preds = %618
  %630 = getelementptr double, ptr %550, i64 %593
  %631 = fsub double %602, %597
  br label %635

632:                                              ; preds = %635
  %633 = load ptr, ptr %112, align 8, !noalias !15
  %634 = getelementptr inbounds double, ptr %633, i64 %593
  store double %597, ptr %634, align 8, !noalias !15
  br label %649

635:                                              ; preds = %629, %635
  %636 = phi i64 [ 0, %629 ], [ %647, %635 ]
  %637 = load ptr, ptr %113, align 8, !noalias !15
  %638 = getelementptr inbounds double, ptr %637, i64 %636
  %639 = load double, ptr %638, align 8, !noalias !15
  %640 = load ptr, ptr %118, align 8, !noalias !15
  %641 = getelementptr inbounds double, ptr %640, i64 %636
  %642 = load double, ptr %641, align 8, !noalias !15
  %643 = fsub double %639, %642
  %644 = fdiv double %643, %631
  %645 = mul nuw nsw i64 %636, %543
  %646 = getelementptr double, ptr %630, i64 %645
  store double %644, ptr %646, align 8, !noalias !15
  %647 = add nuw nsw i64 %636, 1
  %648 = icmp eq i64 %647, %543
  br i1 %648, label %632, label %635, !llvm.loop !20

649:                                              ; preds = %632, %618
  %650 = phi i64 [ %592, %632 ], [ %627, %618 ]
  br i1 %628, label %588, label %651

651:                                              ; preds = %649, %588, %577, %566
  %652 = phi double [ 0.000000e+00, %566 ], [ 0.000000e+00, %577 ], [ %605, %588 ], [ %605, %649 ]
  %653 = phi i64 [ %576, %566 ], [ 0, %577 ], [ %650, %649 ], [ 0, %588 ]
  %654 = load i64, ptr %119, align 8, !noalias !15
  %655 = icmp sgt i64 %654, 0
  br i1 %655, label %656, label %669

656:                                              ; preds = %651, %656
  %657 = phi i64 [ %666, %656 ], [ 0, %651 ]
  %658 = load ptr, ptr %106, align 8, !noalias !15
  %659 = getelementptr inbounds double, ptr %658, i64 %657
  %660 = load double, ptr %659, align 8, !noalias !15
  %661 = tail call double @llvm.fabs.f64(double %660)
  %662 = fcmp ueq double %661, 0x7FF0000000000000
  %663 = select i1 %662, double 0.000000e+00, double %660
  %664 = load ptr, ptr %105, align 8, !noalias !15
  %665 = getelementptr inbounds double, ptr %664, i64 %657
  store double %663, ptr %665, align 8, !noalias !15
  %666 = add nuw nsw i64 %657, 1
  %667 = load i64, ptr %119, align 8, !noalias !15
  %668 = icmp slt i64 %666, %667
  br i1 %668, label %656, label %669, !llvm.loop !21

669:                                              ; preds = %656, %651
  %670 = icmp slt i64 %653, 0
  br i1 %670, label %1981, label %671

671:                                              ; preds = %669
  %672 = load i64, ptr %545, align 8, !noalias !15
  %673 = and i64 %672, -2
  store i64 %673, ptr %545, align 8, !noalias !15
  %674 = getelementptr inbounds i8, ptr %544, i64 16
  %675 = load i64, ptr %674, align 8, !noalias !15
  %676 = or i64 %675, 1
  store i64 %676, ptr %674, align 8, !noalias !15
  %677 = getelementptr inbounds i8, ptr %544, i64 24
  %678 = load i64, ptr %677, align 8, !noalias !15
  %679 = and i64 %678, -2
  store i64 %679, ptr %677, align 8, !noalias !15
  br label %680

680:                                              ; preds = %671, %540
  %681 = phi double [ 0.000000e+00, %540 ], [ %652, %671 ]
  %682 = load ptr, ptr %83, align 8, !noalias !15
  %683 = load ptr, ptr %120, align 8, !noalias !15
  %684 = load double, ptr %683, align 8, !noalias !15
  %685 = fsub double %533, %684
  %686 = tail call double @llvm.fabs.f64(double %685)
  %687 = tail call double @llvm.fabs.f64(double %532)
  %688 = fmul double %687, 0x3CB0000000000000
  %689 = fcmp ogt double %686, %688
  %690 = getelementptr inbounds i8, ptr %682, i64 24
  %691 = load i64, ptr %690, align 8, !noalias !15
  %692 = trunc i64 %691 to i1
  %693 = xor i1 %692, true
  %694 = or i1 %689, %693
  %695 = zext i1 %694 to i64
  br i1 %694, label %696, label %756

696:                                              ; preds = %680
  store double %533, ptr %683, align 8, !noalias !15
  %697 = load i64, ptr %121, align 8, !noalias !15
  %698 = load ptr, ptr %122, align 8, !noalias !15
  %699 = load ptr, ptr %123, align 8, !noalias !15
  %700 = icmp sgt i64 %697, 0
  br i1 %700, label %701, label %731

701:                                              ; preds = %696
  %702 = fdiv double 0x400D1A48D83E731D, %533
  %703 = fdiv double 0x400572DB93E0C672, %533
  %704 = fdiv double 0xC0086747F2C3FCB6, %533
  br label %705

705:                                              ; preds = %701, %708
  %706 = phi i64 [ 0, %701 ], [ %709, %708 ]
  %707 = mul nuw nsw i64 %706, %697
  br label %711

708:                                              ; preds = %711
  %709 = add nuw nsw i64 %706, 1
  %710 = icmp eq i64 %709, %697
  br i1 %710, label %731, label %705, !llvm.loop !22

711:                                              ; preds = %705, %711
  %712 = phi i64 [ 0, %705 ], [ %729, %711 ]
  %713 = load ptr, ptr %124, align 8, !noalias !15
  %714 = add nuw nsw i64 %712, %707
  %715 = getelementptr inbounds double, ptr %713, i64 %714
  %716 = load double, ptr %715, align 8, !noalias !15
  %717 = fneg double %716
  %718 = icmp eq i64 %706, %712
  %719 = fsub double %702, %716
  %720 = select i1 %718, double %719, double %717
  %721 = fsub double %703, %716
  %722 = select i1 %718, double %721, double %717
  %723 = getelementptr inbounds double, ptr %698, i64 %714
  store double %720, ptr %723, align 8, !noalias !15
  %724 = select i1 %718, double %704, double 0.000000e+00
  %725 = shl nuw nsw i64 %714, 1
  %726 = getelementptr inbounds double, ptr %699, i64 %725
  store double %722, ptr %726, align 8, !noalias !15
  %727 = or disjoint i64 %725, 1
  %728 = getelementptr inbounds double, ptr %699, i64 %727
  store double %724, ptr %728, align 8, !noalias !15
  %729 = add nuw nsw i64 %712, 1
  %730 = icmp eq i64 %729, %697
  br i1 %730, label %708, label %711, !llvm.loop !23

731:                                              ; preds = %708, %696
  %732 = load ptr, ptr %125, align 8, !noalias !15
  %733 = tail call fastcc i64 @real_factorise(ptr noundef %698, i64 noundef %697, ptr noundef %732) #9, !noalias !15
  %734 = load ptr, ptr %126, align 8, !noalias !15
  %735 = tail call fastcc i64 @pair_factorise(ptr noundef %699, i64 noundef %697, ptr noundef %734) #9, !noalias !15
  %736 = or i64 %735, %733
  %737 = and i64 %736, %695
  %738 = load i64, ptr %690, align 8, !noalias !15
  %739 = or i64 %738, %695
  %740 = xor i64 %737, -1
  %741 = xor i64 %737, %739
  store i64 %741, ptr %690, align 8, !noalias !15
  %742 = icmp eq i64 %737, 0
  %743 = select i1 %742, double 2.000000e+00, double 4.000000e+00
  %744 = fmul double %533, 5.000000e-01
  %745 = select i1 %742, double %457, double %744
  %746 = load ptr, ptr %83, align 8, !noalias !15
  %747 = getelementptr inbounds i8, ptr %746, i64 8
  %748 = load i64, ptr %747, align 8, !noalias !15
  %749 = and i64 %748, %740
  %750 = getelementptr inbounds i8, ptr %746, i64 16
  %751 = load i64, ptr %750, align 8, !noalias !15
  %752 = xor i64 %751, -1
  %753 = and i64 %737, %752
  %754 = or disjoint i64 %753, %749
  store i64 %754, ptr %747, align 8, !noalias !15
  %755 = and i64 %740, 1
  br label %756

756:                                              ; preds = %680, %731
  %757 = phi double [ %457, %680 ], [ %745, %731 ]
  %758 = phi double [ 2.000000e+00, %680 ], [ %743, %731 ]
  %759 = phi i64 [ 1, %680 ], [ %755, %731 ]
  %760 = icmp eq i64 %759, 0
  br i1 %760, label %1981, label %761

761:                                              ; preds = %756
  %762 = load ptr, ptr %120, align 8, !noalias !15
  %763 = getelementptr inbounds i8, ptr %762, i64 8
  %764 = load double, ptr %763, align 8, !noalias !15
  %765 = load ptr, ptr %81, align 8, !noalias !15
  %766 = getelementptr inbounds i8, ptr %765, i64 8
  %767 = load i64, ptr %766, align 8, !noalias !15
  %768 = load ptr, ptr %127, align 8, !noalias !15
  %769 = load ptr, ptr %82, align 8, !noalias !15
  %770 = load ptr, ptr %128, align 8, !noalias !15
  %771 = load ptr, ptr %129, align 8, !noalias !15
  %772 = fcmp ule double %764, 0.000000e+00
  %773 = icmp sgt i64 %767, 0
  %774 = shl i64 %767, 4
  %775 = getelementptr i8, ptr %768, i64 %774
  %776 = mul i64 %767, 24
  %777 = getelementptr i8, ptr %768, i64 %776
  %778 = getelementptr double, ptr %768, i64 %767
  br label %784

779:                                              ; preds = %795
  %780 = icmp sgt i64 %767, 0
  %781 = getelementptr double, ptr %770, i64 %767
  %782 = shl i64 %767, 4
  %783 = getelementptr i8, ptr %770, i64 %782
  br label %821

784:                                              ; preds = %761, %795
  %785 = phi i64 [ 0, %761 ], [ %796, %795 ]
  %786 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %785
  %787 = load double, ptr %786, align 8, !noalias !15
  %788 = fmul double %533, %787
  %789 = fdiv double %788, %764
  %790 = fadd double %789, 1.000000e+00
  br i1 %773, label %791, label %795

791:                                              ; preds = %784
  %792 = fsub double 1.000000e+00, %790
  %793 = mul nuw nsw i64 %767, %785
  %794 = getelementptr double, ptr %770, i64 %793
  br label %798

795:                                              ; preds = %798, %784
  %796 = add nuw nsw i64 %785, 1
  %797 = icmp eq i64 %796, 3
  br i1 %797, label %779, label %784, !llvm.loop !24

798:                                              ; preds = %791, %798
  %799 = phi i64 [ 0, %791 ], [ %819, %798 ]
  %800 = getelementptr double, ptr %775, i64 %799
  %801 = load double, ptr %800, align 8, !noalias !15
  %802 = getelementptr double, ptr %777, i64 %799
  %803 = load double, ptr %802, align 8, !noalias !15
  %804 = fmul double %790, %803
  %805 = fadd double %801, %804
  %806 = fmul double %792, %805
  %807 = getelementptr inbounds double, ptr %768, i64 %799
  %808 = load double, ptr %807, align 8, !noalias !15
  %809 = getelementptr double, ptr %778, i64 %799
  %810 = load double, ptr %809, align 8, !noalias !15
  %811 = fadd double %810, %806
  %812 = fmul double %790, %811
  %813 = fadd double %808, %812
  %814 = getelementptr inbounds double, ptr %769, i64 %799
  %815 = load double, ptr %814, align 8, !noalias !15
  %816 = fsub double %813, %815
  %817 = select i1 %772, double 0.000000e+00, double %816
  %818 = getelementptr double, ptr %794, i64 %799
  store double %817, ptr %818, align 8, !noalias !15
  %819 = add nuw nsw i64 %799, 1
  %820 = icmp eq i64 %819, %767
  br i1 %820, label %795, label %798, !llvm.loop !25

821:                                              ; preds = %779, %832
  %822 = phi i64 [ 0, %779 ], [ %833, %832 ]
  br i1 %780, label %823, label %832

823:                                              ; preds = %821
  %824 = mul nuw nsw i64 %767, %822
  %825 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %822
  %826 = load double, ptr %825, align 8, !noalias !15
  %827 = getelementptr inbounds i8, ptr %825, i64 8
  %828 = load double, ptr %827, align 8, !noalias !15
  %829 = getelementptr inbounds i8, ptr %825, i64 16
  %830 = load double, ptr %829, align 8, !noalias !15
  %831 = getelementptr double, ptr %771, i64 %824
  br label %835

832:                                              ; preds = %835, %821
  %833 = add nuw nsw i64 %822, 1
  %834 = icmp eq i64 %833, 3
  br i1 %834, label %851, label %821, !llvm.loop !26

835:                                              ; preds = %823, %835
  %836 = phi i64 [ 0, %823 ], [ %849, %835 ]
  %837 = getelementptr inbounds double, ptr %770, i64 %836
  %838 = load double, ptr %837, align 8, !noalias !15
  %839 = fmul double %826, %838
  %840 = getelementptr double, ptr %781, i64 %836
  %841 = load double, ptr %840, align 8, !noalias !15
  %842 = fmul double %828, %841
  %843 = fadd double %839, %842
  %844 = getelementptr double, ptr %783, i64 %836
  %845 = load double, ptr %844, align 8, !noalias !15
  %846 = fmul double %830, %845
  %847 = fadd double %843, %846
  %848 = getelementptr double, ptr %831, i64 %836
  store double %847, ptr %848, align 8, !noalias !15
  %849 = add nuw nsw i64 %836, 1
  %850 = icmp eq i64 %849, %767
  br i1 %850, label %832, label %835, !llvm.loop !27

851:                                              ; preds = %832
  %852 = load ptr, ptr %83, align 8, !noalias !28
  %853 = getelementptr inbounds i8, ptr %852, i64 40
  %854 = load i64, ptr %853, align 8, !noalias !28
  %855 = icmp sgt i64 %854, 0
  %856 = select i1 %855, i64 10, i64 6
  %857 = fdiv double 0x400572DB93E0C672, %533
  %858 = fdiv double 0xC0086747F2C3FCB6, %533
  %859 = fdiv double 0x400D1A48D83E731D, %533
  %860 = fneg double %858
  br label %864

861:                                              ; preds = %1327
  %862 = add nuw nsw i64 %868, 1
  %863 = icmp eq i64 %862, %856
  br i1 %863, label %1342, label %864, !llvm.loop !31

864:                                              ; preds = %851, %861
  %865 = phi double [ -1.000000e+00, %851 ], [ %1340, %861 ]
  %866 = phi i64 [ %759, %851 ], [ %1339, %861 ]
  %867 = phi i64 [ 0, %851 ], [ %1338, %861 ]
  %868 = phi i64 [ 0, %851 ], [ %862, %861 ]
  %869 = phi i64 [ 0, %851 ], [ %1336, %861 ]
  %870 = phi i64 [ 0, %851 ], [ %958, %861 ]
  %871 = phi i64 [ 0, %851 ], [ %957, %861 ]
  %872 = phi double [ 0.000000e+00, %851 ], [ %1335, %861 ]
  %873 = phi double [ 0.000000e+00, %851 ], [ %1334, %861 ]
  %874 = phi double [ 0.000000e+00, %851 ], [ %956, %861 ]
  %875 = phi i64 [ %458, %851 ], [ %1333, %861 ]
  %876 = phi i64 [ %459, %851 ], [ %1332, %861 ]
  %877 = phi i64 [ %460, %851 ], [ %1331, %861 ]
  %878 = phi double [ %461, %851 ], [ %1330, %861 ]
  %879 = phi double [ %462, %851 ], [ %1329, %861 ]
  %880 = phi double [ %463, %851 ], [ %1328, %861 ]
  %881 = icmp ugt i64 %868, 5
  %882 = select i1 %881, i64 %869, i64 -1
  %883 = and i64 %866, %882
  %884 = load ptr, ptr %81, align 8, !noalias !28
  %885 = getelementptr inbounds i8, ptr %884, i64 8
  %886 = load i64, ptr %885, align 8, !noalias !28
  %887 = load ptr, ptr %128, align 8, !noalias !28
  %888 = icmp eq i64 %883, 0
  br i1 %888, label %955, label %889

889:                                              ; preds = %864
  %890 = icmp sgt i64 %886, 0
  br label %891

891:                                              ; preds = %889, %923
  %892 = phi i64 [ %883, %889 ], [ %938, %923 ]
  %893 = phi i64 [ 0, %889 ], [ %939, %923 ]
  %894 = phi i64 [ %870, %889 ], [ %936, %923 ]
  %895 = phi i64 [ %871, %889 ], [ %934, %923 ]
  %896 = phi double [ %874, %889 ], [ %904, %923 ]
  br i1 %890, label %897, label %900

897:                                              ; preds = %891
  %898 = mul nuw nsw i64 %893, %886
  %899 = getelementptr double, ptr %887, i64 %898
  br label %943

900:                                              ; preds = %943, %891
  %901 = and i64 %892, 4294967295
  %902 = icmp eq i64 %901, 0
  %903 = select i1 %902, double 0.000000e+00, double 1.000000e+00
  %904 = fadd double %896, %903
  %905 = load ptr, ptr %131, align 8, !noalias !28
  %906 = mul nsw i64 %893, %886
  %907 = getelementptr inbounds double, ptr %905, i64 %906
  %908 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %893
  %909 = load double, ptr %908, align 8, !noalias !28
  %910 = fmul double %533, %909
  %911 = fadd double %456, %910
  %912 = load ptr, ptr %132, align 8, !noalias !28
  %913 = load ptr, ptr %133, align 8, !noalias !28
  store double %911, ptr %913, align 8, !noalias !28
  %914 = load ptr, ptr %81, align 8, !noalias !28
  %915 = getelementptr inbounds i8, ptr %914, i64 40
  %916 = load i64, ptr %915, align 8, !noalias !28
  %917 = icmp eq i64 %916, 0
  br i1 %917, label %919, label %918

918:                                              ; preds = %900
  tail call fastcc void @settle(ptr noundef nonnull %81) #9, !noalias !28
  br label %919

919:                                              ; preds = %918, %900
  %920 = load i64, ptr %134, align 8, !noalias !28
  %921 = icmp sgt i64 %920, 0
  br i1 %921, label %922, label %923

922:                                              ; preds = %919
  tail call fastcc void @sample(ptr noundef nonnull %81) #9, !noalias !28
  br label %923

923:                                              ; preds = %922, %919
  %924 = load ptr, ptr %81, align 8, !noalias !28
  %925 = load i64, ptr %924, align 8, !noalias !28
  %926 = load ptr, ptr %133, align 8, !noalias !28
  %927 = load ptr, ptr %135, align 8, !noalias !28
  %928 = load ptr, ptr %136, align 8, !noalias !28
  %929 = inttoptr i64 %925 to ptr
  %930 = load ptr, ptr %929, align 8, !noalias !28
  %931 = tail call i32 %930(ptr noundef %926, ptr noundef %912, ptr noundef %927, ptr noundef %928, ptr noundef %907) #10, !noalias !28
  %932 = sext i32 %931 to i64
  %933 = icmp slt i32 %931, 0
  %934 = select i1 %933, i64 %932, i64 %895
  %935 = and i64 %892, %932
  %936 = or i64 %935, %894
  %937 = xor i64 %932, -1
  %938 = and i64 %892, %937
  %939 = add nuw nsw i64 %893, 1
  %940 = icmp ult i64 %893, 2
  %941 = icmp ne i64 %938, 0
  %942 = select i1 %940, i1 %941, i1 false
  br i1 %942, label %891, label %955, !llvm.loop !32

943:                                              ; preds = %897, %943
  %944 = phi i64 [ 0, %897 ], [ %953, %943 ]
  %945 = load ptr, ptr %130, align 8, !noalias !28
  %946 = load ptr, ptr %82, align 8, !noalias !28
  %947 = getelementptr inbounds double, ptr %946, i64 %944
  %948 = load double, ptr %947, align 8, !noalias !28
  %949 = getelementptr double, ptr %899, i64 %944
  %950 = load double, ptr %949, align 8, !noalias !28
  %951 = fadd double %948, %950
  %952 = getelementptr inbounds double, ptr %945, i64 %944
  store double %951, ptr %952, align 8, !noalias !28
  %953 = add nuw nsw i64 %944, 1
  %954 = icmp eq i64 %953, %886
  br i1 %954, label %900, label %943, !llvm.loop !33

955:                                              ; preds = %923, %864
  %956 = phi double [ %874, %864 ], [ %904, %923 ]
  %957 = phi i64 [ %871, %864 ], [ %934, %923 ]
  %958 = phi i64 [ %870, %864 ], [ %936, %923 ]
  %959 = phi i64 [ %883, %864 ], [ %938, %923 ]
  %960 = icmp eq i64 %959, 0
  br i1 %960, label %961, label %965

961:                                              ; preds = %955
  %962 = or i64 %883, %867
  %963 = xor i64 %962, -1
  %964 = and i64 %869, %963
  br label %1327

965:                                              ; preds = %955
  %966 = load ptr, ptr %81, align 8, !noalias !28
  %967 = getelementptr inbounds i8, ptr %966, i64 8
  %968 = load i64, ptr %967, align 8, !noalias !28
  %969 = getelementptr inbounds i8, ptr %966, i64 24
  %970 = load i64, ptr %969, align 8, !noalias !28
  %971 = load ptr, ptr %137, align 8, !noalias !28
  %972 = load ptr, ptr %129, align 8, !noalias !28
  %973 = icmp sgt i64 %968, 0
  br i1 %973, label %974, label %1056

974:                                              ; preds = %965
  %975 = shl nuw nsw i64 %968, 1
  br label %976

976:                                              ; preds = %974, %1052
  %977 = phi i32 [ 1, %974 ], [ %992, %1052 ]
  %978 = phi i64 [ 0, %974 ], [ %1054, %1052 ]
  %979 = phi double [ 0.000000e+00, %974 ], [ %1053, %1052 ]
  %980 = getelementptr inbounds double, ptr %971, i64 %978
  %981 = load double, ptr %980, align 8, !noalias !28
  %982 = add nuw nsw i64 %978, %968
  %983 = getelementptr inbounds double, ptr %971, i64 %982
  %984 = load double, ptr %983, align 8, !noalias !28
  %985 = fadd double %981, %984
  %986 = add nuw nsw i64 %978, %975
  %987 = getelementptr inbounds double, ptr %971, i64 %986
  %988 = load double, ptr %987, align 8, !noalias !28
  %989 = fadd double %985, %988
  %990 = tail call double @llvm.fabs.f64(double %989)
  %991 = fcmp one double %990, 0x7FF0000000000000
  %992 = select i1 %991, i32 %977, i32 0
  %993 = getelementptr inbounds double, ptr %972, i64 %982
  %994 = load double, ptr %993, align 8, !noalias !28
  %995 = getelementptr inbounds double, ptr %972, i64 %986
  %996 = load double, ptr %995, align 8, !noalias !28
  %997 = fmul double %981, 0xC010B70201A79C46
  %998 = fmul double %984, 0x3FD4F8C15DA84E86
  %999 = fsub double %997, %998
  %1000 = fmul double %988, 0x3FDE810014C55221
  %1001 = fadd double %999, %1000
  %1002 = fmul double %981, 0x3FE017885A24A7F2
  %1003 = fmul double %984, 0x4004934E6FCAA598
  %1004 = fsub double %1002, %1003
  %1005 = fmul double %988, 0x3FE312C0CF7BDFD1
  %1006 = fadd double %1004, %1005
  %1007 = fmul double %981, 0x4010B70201A79C46
  %1008 = fmul double %984, 0x3FD4F8C15DA84E86
  %1009 = fadd double %1007, %1008
  %1010 = fmul double %988, 0x3FE0BF7FF59D56EF
  %1011 = fadd double %1009, %1010
  %1012 = getelementptr inbounds double, ptr %972, i64 %978
  %1013 = load double, ptr %1012, align 8, !noalias !28
  %1014 = fmul double %859, %1013
  %1015 = fsub double %1011, %1014
  %1016 = fmul double %996, %860
  %1017 = tail call double @llvm.fma.f64(double %857, double %994, double %1016)
  %1018 = fmul double %858, %994
  %1019 = tail call double @llvm.fma.f64(double %857, double %996, double %1018)
  %1020 = fsub double %1001, %1017
  %1021 = fsub double %1006, %1019
  %1022 = load ptr, ptr %138, align 8, !noalias !28
  %1023 = getelementptr inbounds double, ptr %1022, i64 %978
  store double %1015, ptr %1023, align 8, !noalias !28
  %1024 = load ptr, ptr %139, align 8, !noalias !28
  %1025 = shl nuw nsw i64 %978, 1
  %1026 = getelementptr inbounds double, ptr %1024, i64 %1025
  store double %1020, ptr %1026, align 8, !noalias !28
  %1027 = or disjoint i64 %1025, 1
  %1028 = getelementptr inbounds double, ptr %1024, i64 %1027
  store double %1021, ptr %1028, align 8, !noalias !28
  %1029 = icmp slt i64 %978, %970
  br i1 %1029, label %1030, label %1052

1030:                                             ; preds = %976
  %1031 = load ptr, ptr %82, align 8, !noalias !28
  %1032 = getelementptr inbounds double, ptr %1031, i64 %978
  %1033 = load double, ptr %1032, align 8, !noalias !28
  %1034 = tail call double @llvm.fabs.f64(double %1015)
  %1035 = tail call double @llvm.fabs.f64(double %1020)
  %1036 = tail call double @llvm.fabs.f64(double %1021)
  %1037 = fadd double %1036, %1035
  %1038 = fadd double %1034, %1037
  %1039 = fmul double %533, %1038
  %1040 = load ptr, ptr %140, align 8, !noalias !28
  %1041 = getelementptr inbounds double, ptr %1040, i64 %978
  %1042 = load double, ptr %1041, align 8, !noalias !28
  %1043 = load ptr, ptr %88, align 8, !noalias !28
  %1044 = getelementptr inbounds double, ptr %1043, i64 %978
  %1045 = load double, ptr %1044, align 8, !noalias !28
  %1046 = tail call double @llvm.fabs.f64(double %1033)
  %1047 = fmul double %1046, %1045
  %1048 = fadd double %1042, %1047
  %1049 = fdiv double %1039, %1048
  %1050 = fmul double %1049, %1049
  %1051 = fadd double %979, %1050
  br label %1052

1052:                                             ; preds = %1030, %976
  %1053 = phi double [ %1051, %1030 ], [ %979, %976 ]
  %1054 = add nuw nsw i64 %978, 1
  %1055 = icmp eq i64 %1054, %968
  br i1 %1055, label %1056, label %976, !llvm.loop !34

1056:                                             ; preds = %1052, %965
  %1057 = phi double [ 0.000000e+00, %965 ], [ %1053, %1052 ]
  %1058 = phi i32 [ 1, %965 ], [ %992, %1052 ]
  %1059 = zext nneg i32 %1058 to i64
  %1060 = xor i64 %1059, 4294967295
  %1061 = and i64 %959, %1060
  %1062 = icmp eq i64 %1061, 0
  %1063 = select i1 %1062, double %873, double 0x7FF0000000000000
  %1064 = load ptr, ptr %81, align 8, !noalias !28
  %1065 = getelementptr inbounds i8, ptr %1064, i64 24
  %1066 = load i64, ptr %1065, align 8, !noalias !28
  %1067 = load i64, ptr %142, align 8, !noalias !28
  %1068 = load ptr, ptr %83, align 8, !noalias !28
  %1069 = getelementptr inbounds i8, ptr %1068, i64 40
  %1070 = load i64, ptr %1069, align 8, !noalias !28
  %1071 = load ptr, ptr %143, align 8, !noalias !28
  %1072 = load ptr, ptr %144, align 8, !noalias !28
  %1073 = load ptr, ptr %145, align 8, !noalias !28
  %1074 = load ptr, ptr %141, align 8, !noalias !28
  tail call fastcc void @real_solve(ptr noundef %1073, i64 noundef %1067, ptr noundef %1074, ptr noundef %1071) #9, !noalias !28
  %1075 = load ptr, ptr %146, align 8, !noalias !28
  %1076 = load ptr, ptr %147, align 8, !noalias !28
  tail call fastcc void @pair_solve(ptr noundef %1075, i64 noundef %1067, ptr noundef %1076, ptr noundef %1072) #9, !noalias !28
  %1077 = icmp sgt i64 %1070, 0
  br i1 %1077, label %1078, label %1086

1078:                                             ; preds = %1056
  %1079 = load ptr, ptr %145, align 8, !noalias !28
  %1080 = load ptr, ptr %141, align 8, !noalias !28
  %1081 = getelementptr inbounds double, ptr %1071, i64 %1067
  tail call fastcc void @real_solve_columns(ptr noundef %1079, i64 noundef %1067, ptr noundef %1080, ptr noundef %1081, i64 noundef %1070) #9, !noalias !28
  %1082 = load ptr, ptr %146, align 8, !noalias !28
  %1083 = load ptr, ptr %147, align 8, !noalias !28
  %1084 = shl nsw i64 %1067, 4
  %1085 = getelementptr inbounds i8, ptr %1072, i64 %1084
  tail call fastcc void @pair_solve_columns(ptr noundef %1082, i64 noundef %1067, ptr noundef %1083, ptr noundef %1085, i64 noundef %1070) #9, !noalias !28
  br label %1086

1086:                                             ; preds = %1078, %1056
  %1087 = icmp sgt i64 %1066, 0
  br i1 %1087, label %1088, label %1123

1088:                                             ; preds = %1086
  %1089 = load ptr, ptr %82, align 8, !noalias !28
  %1090 = load ptr, ptr %148, align 8, !noalias !28
  %1091 = load ptr, ptr %88, align 8, !noalias !28
  br label %1092

1092:                                             ; preds = %1088, %1092
  %1093 = phi double [ 0.000000e+00, %1088 ], [ %1120, %1092 ]
  %1094 = phi i64 [ 0, %1088 ], [ %1121, %1092 ]
  %1095 = getelementptr inbounds double, ptr %1089, i64 %1094
  %1096 = load double, ptr %1095, align 8, !noalias !28
  %1097 = getelementptr inbounds double, ptr %1090, i64 %1094
  %1098 = load double, ptr %1097, align 8, !noalias !28
  %1099 = getelementptr inbounds double, ptr %1091, i64 %1094
  %1100 = load double, ptr %1099, align 8, !noalias !28
  %1101 = tail call double @llvm.fabs.f64(double %1096)
  %1102 = fmul double %1101, %1100
  %1103 = fadd double %1098, %1102
  %1104 = getelementptr inbounds double, ptr %1071, i64 %1094
  %1105 = load double, ptr %1104, align 8, !noalias !28
  %1106 = fdiv double %1105, %1103
  %1107 = shl nuw nsw i64 %1094, 1
  %1108 = getelementptr inbounds double, ptr %1072, i64 %1107
  %1109 = load double, ptr %1108, align 8, !noalias !28
  %1110 = or disjoint i64 %1107, 1
  %1111 = getelementptr inbounds double, ptr %1072, i64 %1110
  %1112 = load double, ptr %1111, align 8, !noalias !28
  %1113 = fdiv double %1109, %1103
  %1114 = fdiv double %1112, %1103
  %1115 = fmul double %1106, %1106
  %1116 = fmul double %1113, %1113
  %1117 = fadd double %1115, %1116
  %1118 = fmul double %1114, %1114
  %1119 = fadd double %1117, %1118
  %1120 = fadd double %1093, %1119
  %1121 = add nuw nsw i64 %1094, 1
  %1122 = icmp eq i64 %1121, %1066
  br i1 %1122, label %1123, label %1092, !llvm.loop !35

1123:                                             ; preds = %1092, %1086
  %1124 = phi double [ 0.000000e+00, %1086 ], [ %1120, %1092 ]
  %1125 = mul nsw i64 %1066, 3
  %1126 = sitofp i64 %1125 to double
  %1127 = fdiv double %1124, %1126
  %1128 = tail call double @llvm.sqrt.f64(double %1127)
  %1129 = fcmp oeq double %1128, 0.000000e+00
  %1130 = fcmp ogt double %1057, 0.000000e+00
  %1131 = and i1 %1130, %1129
  %1132 = zext i1 %1131 to i64
  %1133 = xor i64 %1132, -1
  %1134 = and i64 %1059, %1133
  %1135 = and i64 %1134, %959
  %1136 = xor i64 %869, -1
  %1137 = and i64 %1135, %1136
  %1138 = trunc nuw nsw i64 %1137 to i32
  %1139 = fcmp ogt double %865, 0.000000e+00
  %1140 = and i32 %1138, 1
  %1141 = select i1 %1139, i32 %1140, i32 0
  %1142 = fdiv double %1128, %865
  %1143 = icmp eq i32 %1141, 0
  %1144 = select i1 %1143, double %1063, double %1142
  %1145 = fsub double 1.000000e+00, %1144
  %1146 = fdiv double %1128, %1145
  %1147 = icmp ult i64 %868, 5
  br i1 %1147, label %1240, label %1148

1148:                                             ; preds = %1240, %1123
  %1149 = phi double [ %1146, %1123 ], [ %1243, %1240 ]
  %1150 = fcmp oge double %1144, 1.000000e+00
  %1151 = fcmp ogt double %1149, %431
  %1152 = or i1 %1150, %1151
  %1153 = xor i32 %1141, -1
  %1154 = zext i32 %1153 to i64
  %1155 = select i1 %1152, i64 %1154, i64 2147483647
  %1156 = and i64 %1155, %1135
  %1157 = xor i64 %1156, -1
  %1158 = and i64 %883, %1157
  %1159 = or i64 %1158, %867
  %1160 = load ptr, ptr %81, align 8, !noalias !28
  %1161 = getelementptr inbounds i8, ptr %1160, i64 8
  %1162 = load i64, ptr %1161, align 8, !noalias !28
  %1163 = load ptr, ptr %128, align 8, !noalias !28
  %1164 = load ptr, ptr %129, align 8, !noalias !28
  %1165 = icmp sgt i64 %1162, 0
  br i1 %1165, label %1166, label %1226

1166:                                             ; preds = %1148
  %1167 = icmp eq i64 %1156, 0
  %1168 = getelementptr double, ptr %1164, i64 %1162
  %1169 = shl i64 %1162, 4
  %1170 = getelementptr i8, ptr %1164, i64 %1169
  %1171 = icmp eq i64 %1156, 0
  br label %1172

1172:                                             ; preds = %1166, %1201
  %1173 = phi i64 [ 0, %1166 ], [ %1202, %1201 ]
  %1174 = load ptr, ptr %144, align 8, !noalias !28
  %1175 = shl nuw nsw i64 %1173, 1
  %1176 = getelementptr inbounds double, ptr %1174, i64 %1175
  %1177 = load double, ptr %1176, align 8, !noalias !28
  %1178 = or disjoint i64 %1175, 1
  %1179 = getelementptr inbounds double, ptr %1174, i64 %1178
  %1180 = load double, ptr %1179, align 8, !noalias !28
  %1181 = load ptr, ptr %143, align 8, !noalias !28
  %1182 = getelementptr inbounds double, ptr %1181, i64 %1173
  %1183 = load double, ptr %1182, align 8, !noalias !28
  store double %1183, ptr %10, align 16, !noalias !28
  store double %1177, ptr %149, align 8, !noalias !28
  store double %1180, ptr %150, align 16, !noalias !28
  %1184 = getelementptr double, ptr %1164, i64 %1173
  br label %1190

1185:                                             ; preds = %1190
  %1186 = getelementptr inbounds double, ptr %1164, i64 %1173
  %1187 = getelementptr double, ptr %1168, i64 %1173
  %1188 = getelementptr double, ptr %1170, i64 %1173
  %1189 = getelementptr double, ptr %1163, i64 %1173
  br label %1204

1190:                                             ; preds = %1172, %1190
  %1191 = phi i64 [ 0, %1172 ], [ %1199, %1190 ]
  %1192 = mul nuw nsw i64 %1162, %1191
  %1193 = getelementptr double, ptr %1184, i64 %1192
  %1194 = load double, ptr %1193, align 8, !noalias !28
  %1195 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %1191
  %1196 = load double, ptr %1195, align 8, !noalias !28
  %1197 = fadd double %1194, %1196
  %1198 = select i1 %1167, double %1194, double %1197
  store double %1198, ptr %1193, align 8, !noalias !28
  %1199 = add nuw nsw i64 %1191, 1
  %1200 = icmp eq i64 %1199, 3
  br i1 %1200, label %1185, label %1190, !llvm.loop !36

1201:                                             ; preds = %1204
  %1202 = add nuw nsw i64 %1173, 1
  %1203 = icmp eq i64 %1202, %1162
  br i1 %1203, label %1226, label %1172, !llvm.loop !37

1204:                                             ; preds = %1185, %1204
  %1205 = phi i64 [ 0, %1185 ], [ %1224, %1204 ]
  %1206 = mul nuw nsw i64 %1162, %1205
  %1207 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1205
  %1208 = load double, ptr %1207, align 8, !noalias !28
  %1209 = load double, ptr %1186, align 8, !noalias !28
  %1210 = fmul double %1208, %1209
  %1211 = getelementptr inbounds i8, ptr %1207, i64 8
  %1212 = load double, ptr %1211, align 8, !noalias !28
  %1213 = load double, ptr %1187, align 8, !noalias !28
  %1214 = fmul double %1212, %1213
  %1215 = fadd double %1210, %1214
  %1216 = getelementptr inbounds i8, ptr %1207, i64 16
  %1217 = load double, ptr %1216, align 8, !noalias !28
  %1218 = load double, ptr %1188, align 8, !noalias !28
  %1219 = fmul double %1217, %1218
  %1220 = fadd double %1215, %1219
  %1221 = getelementptr double, ptr %1189, i64 %1206
  %1222 = load double, ptr %1221, align 8, !noalias !28
  %1223 = select i1 %1171, double %1222, double %1220
  store double %1223, ptr %1221, align 8, !noalias !28
  %1224 = add nuw nsw i64 %1205, 1
  %1225 = icmp eq i64 %1224, 3
  br i1 %1225, label %1201, label %1204, !llvm.loop !38

1226:                                             ; preds = %1201, %1148
  %1227 = fdiv double %1144, %1145
  %1228 = fmul double %1128, %1227
  %1229 = fcmp olt double %1228, %431
  %1230 = and i1 %1139, %1229
  %1231 = or i1 %1129, %1230
  %1232 = and i64 %1136, 1
  %1233 = select i1 %1231, i64 %1232, i64 0
  %1234 = and i64 %1156, %1233
  %1235 = add nuw nsw i64 %868, 1
  %1236 = uitofp nneg i64 %1235 to double
  %1237 = icmp eq i64 %1234, 0
  %1238 = select i1 %1237, double %872, double %1236
  %1239 = or i64 %1234, %869
  br i1 %855, label %1246, label %1320

1240:                                             ; preds = %1123, %1240
  %1241 = phi i64 [ %1244, %1240 ], [ %868, %1123 ]
  %1242 = phi double [ %1243, %1240 ], [ %1146, %1123 ]
  %1243 = fmul double %1144, %1242
  %1244 = add nuw nsw i64 %1241, 1
  %1245 = icmp ult i64 %1241, 4
  br i1 %1245, label %1240, label %1148, !llvm.loop !39

1246:                                             ; preds = %1226
  %1247 = load i64, ptr %142, align 8, !noalias !28
  %1248 = load ptr, ptr %83, align 8, !noalias !28
  %1249 = getelementptr inbounds i8, ptr %1248, i64 40
  %1250 = load i64, ptr %1249, align 8, !noalias !28
  %1251 = load ptr, ptr %81, align 8, !noalias !28
  %1252 = getelementptr inbounds i8, ptr %1251, i64 8
  %1253 = load i64, ptr %1252, align 8, !noalias !28
  %1254 = load ptr, ptr %129, align 8, !noalias !28
  %1255 = icmp sgt i64 %1250, 0
  br i1 %1255, label %1256, label %1315

1256:                                             ; preds = %1246
  %1257 = icmp sgt i64 %1247, 0
  br label %1258

1258:                                             ; preds = %1256, %1266
  %1259 = phi double [ 0.000000e+00, %1256 ], [ %1274, %1266 ]
  %1260 = phi i64 [ 0, %1256 ], [ %1275, %1266 ]
  br i1 %1257, label %1261, label %1266

1261:                                             ; preds = %1258
  %1262 = add nuw i64 %1260, %1247
  %1263 = load ptr, ptr %143, align 8, !noalias !28
  %1264 = load ptr, ptr %82, align 8, !noalias !28
  %1265 = load ptr, ptr %144, align 8, !noalias !28
  br label %1277

1266:                                             ; preds = %1301, %1258
  %1267 = phi double [ 0.000000e+00, %1258 ], [ %1312, %1301 ]
  %1268 = phi double [ 0.000000e+00, %1258 ], [ %1302, %1301 ]
  %1269 = fcmp ule double %1267, 0.000000e+00
  %1270 = fdiv double %1268, %1267
  %1271 = select i1 %1269, double 1.000000e+00, double %1270
  %1272 = fmul double %1259, %1267
  %1273 = fcmp ule double %1268, %1272
  %1274 = select i1 %1273, double %1259, double %1271
  %1275 = add nuw nsw i64 %1260, 1
  %1276 = icmp eq i64 %1275, %1250
  br i1 %1276, label %1315, label %1258, !llvm.loop !40

1277:                                             ; preds = %1261, %1301
  %1278 = phi double [ 0.000000e+00, %1261 ], [ %1302, %1301 ]
  %1279 = phi double [ 0.000000e+00, %1261 ], [ %1312, %1301 ]
  %1280 = phi i64 [ 0, %1261 ], [ %1303, %1301 ]
  %1281 = mul nuw nsw i64 %1280, %1250
  %1282 = add i64 %1262, %1281
  %1283 = getelementptr inbounds double, ptr %1263, i64 %1282
  %1284 = load double, ptr %1283, align 8, !noalias !28
  %1285 = getelementptr inbounds double, ptr %1264, i64 %1282
  %1286 = load double, ptr %1285, align 8, !noalias !28
  %1287 = shl nsw i64 %1282, 1
  %1288 = getelementptr inbounds double, ptr %1265, i64 %1287
  %1289 = load double, ptr %1288, align 8, !noalias !28
  %1290 = or disjoint i64 %1287, 1
  %1291 = getelementptr inbounds double, ptr %1265, i64 %1290
  %1292 = load double, ptr %1291, align 8, !noalias !28
  %1293 = fmul double %1284, %1284
  %1294 = fmul double %1289, %1289
  %1295 = fmul double %1292, %1292
  %1296 = fadd double %1294, %1295
  %1297 = fadd double %1293, %1296
  %1298 = fmul double %1286, %1286
  %1299 = fadd double %1279, %1298
  %1300 = getelementptr double, ptr %1254, i64 %1282
  br label %1305

1301:                                             ; preds = %1305
  %1302 = fadd double %1278, %1297
  %1303 = add nuw nsw i64 %1280, 1
  %1304 = icmp eq i64 %1303, %1247
  br i1 %1304, label %1266, label %1277, !llvm.loop !41

1305:                                             ; preds = %1277, %1305
  %1306 = phi i64 [ 0, %1277 ], [ %1313, %1305 ]
  %1307 = phi double [ %1299, %1277 ], [ %1312, %1305 ]
  %1308 = mul nsw i64 %1253, %1306
  %1309 = getelementptr double, ptr %1300, i64 %1308
  %1310 = load double, ptr %1309, align 8, !noalias !28
  %1311 = fmul double %1310, %1310
  %1312 = fadd double %1307, %1311
  %1313 = add nuw nsw i64 %1306, 1
  %1314 = icmp eq i64 %1313, 3
  br i1 %1314, label %1301, label %1305, !llvm.loop !42

1315:                                             ; preds = %1266, %1246
  %1316 = phi double [ 0.000000e+00, %1246 ], [ %1274, %1266 ]
  %1317 = fcmp ole double %1316, %433
  %1318 = and i64 %1239, 1
  %1319 = select i1 %1317, i64 %1318, i64 0
  br label %1320

1320:                                             ; preds = %1315, %1226
  %1321 = phi i64 [ %1319, %1315 ], [ %1239, %1226 ]
  %1322 = xor i64 %1321, -1
  %1323 = and i64 %1156, %1322
  %1324 = icmp eq i64 %1323, 0
  %1325 = select i1 %1324, i32 2, i32 0
  %1326 = select i1 %1324, double %865, double %1128
  br label %1327

1327:                                             ; preds = %1320, %961
  %1328 = phi double [ %956, %961 ], [ %880, %1320 ]
  %1329 = phi double [ %873, %961 ], [ %879, %1320 ]
  %1330 = phi double [ %872, %961 ], [ %878, %1320 ]
  %1331 = phi i64 [ %957, %961 ], [ %877, %1320 ]
  %1332 = phi i64 [ %958, %961 ], [ %876, %1320 ]
  %1333 = phi i64 [ %964, %961 ], [ %875, %1320 ]
  %1334 = phi double [ %873, %961 ], [ %1144, %1320 ]
  %1335 = phi double [ %872, %961 ], [ %1238, %1320 ]
  %1336 = phi i64 [ %964, %961 ], [ %1239, %1320 ]
  %1337 = phi i32 [ 1, %961 ], [ %1325, %1320 ]
  %1338 = phi i64 [ %867, %961 ], [ %1159, %1320 ]
  %1339 = phi i64 [ %883, %961 ], [ %1323, %1320 ]
  %1340 = phi double [ %865, %961 ], [ %1326, %1320 ]
  %1341 = icmp eq i32 %1337, 0
  br i1 %1341, label %861, label %1342

1342:                                             ; preds = %1327, %861
  %1343 = phi i32 [ %1337, %1327 ], [ 2, %861 ]
  %1344 = icmp eq i32 %1343, 2
  br i1 %1344, label %1345, label %1348

1345:                                             ; preds = %1342
  %1346 = xor i64 %1338, -1
  %1347 = and i64 %1336, %1346
  br label %1348

1348:                                             ; preds = %1342, %1345
  %1349 = phi double [ %956, %1345 ], [ %1328, %1342 ]
  %1350 = phi double [ %1334, %1345 ], [ %1329, %1342 ]
  %1351 = phi double [ %1335, %1345 ], [ %1330, %1342 ]
  %1352 = phi i64 [ %957, %1345 ], [ %1331, %1342 ]
  %1353 = phi i64 [ %958, %1345 ], [ %1332, %1342 ]
  %1354 = phi i64 [ %1347, %1345 ], [ %1333, %1342 ]
  %1355 = fadd double %681, %1349
  %1356 = fcmp ogt double %1351, 2.000000e+00
  %1357 = fcmp ogt double %1350, 1.000000e-03
  %1358 = and i1 %1357, %1356
  %1359 = icmp eq i64 %1354, %759
  br i1 %1359, label %1427, label %1360

1360:                                             ; preds = %1348
  %1361 = xor i64 %1354, -1
  %1362 = and i64 %759, %1361
  %1363 = load ptr, ptr %83, align 8, !noalias !15
  %1364 = getelementptr inbounds i8, ptr %1363, i64 16
  %1365 = load i64, ptr %1364, align 8, !noalias !15
  %1366 = xor i64 %1353, -1
  %1367 = and i64 %1365, %1366
  %1368 = and i64 %1367, %1362
  %1369 = tail call double @llvm.fabs.f64(double %1350)
  %1370 = fcmp ueq double %1369, 0x7FF0000000000000
  %1371 = select i1 %1370, double 4.000000e+00, double 7.000000e+00
  %1372 = and i64 %1353, 4294967295
  %1373 = icmp eq i64 %1372, 0
  %1374 = select i1 %1373, double %1371, double 3.000000e+00
  %1375 = icmp eq i64 %1362, 0
  %1376 = select i1 %1375, double %758, double %1374
  %1377 = icmp eq i64 %1368, 0
  br i1 %1377, label %1398, label %1378

1378:                                             ; preds = %1360
  %1379 = load i64, ptr %151, align 8, !noalias !15
  %1380 = icmp sgt i64 %1379, 0
  br i1 %1380, label %1381, label %1393

1381:                                             ; preds = %1378, %1381
  %1382 = phi i32 [ %1389, %1381 ], [ 0, %1378 ]
  %1383 = phi i64 [ %1390, %1381 ], [ 0, %1378 ]
  %1384 = load ptr, ptr %152, align 8, !noalias !15
  %1385 = getelementptr inbounds double, ptr %1384, i64 %1383
  %1386 = load double, ptr %1385, align 8, !noalias !15
  %1387 = fcmp une double %1386, 0.000000e+00
  %1388 = zext i1 %1387 to i32
  %1389 = or i32 %1382, %1388
  store double 0.000000e+00, ptr %1385, align 8, !noalias !15
  %1390 = add nuw nsw i64 %1383, 1
  %1391 = load i64, ptr %151, align 8, !noalias !15
  %1392 = icmp slt i64 %1390, %1391
  br i1 %1392, label %1381, label %1393, !llvm.loop !43

1393:                                             ; preds = %1381, %1378
  %1394 = phi i32 [ 0, %1378 ], [ %1389, %1381 ]
  %1395 = zext nneg i32 %1394 to i64
  %1396 = and i64 %1368, %1395
  %1397 = xor i64 %1396, -1
  br label %1398

1398:                                             ; preds = %1360, %1393
  %1399 = phi i64 [ %1397, %1393 ], [ -1, %1360 ]
  %1400 = and i64 %1399, %1368
  %1401 = getelementptr inbounds i8, ptr %1363, i64 24
  %1402 = load i64, ptr %1401, align 8, !noalias !15
  %1403 = and i64 %1402, %1399
  store i64 %1403, ptr %1401, align 8, !noalias !15
  %1404 = xor i64 %1400, -1
  %1405 = load i64, ptr %1364, align 8, !noalias !15
  %1406 = and i64 %1405, %1404
  store i64 %1406, ptr %1364, align 8, !noalias !15
  %1407 = fmul double %533, 5.000000e-01
  %1408 = icmp eq i64 %1400, 0
  %1409 = select i1 %1408, double %757, double %1407
  %1410 = fmul double %533, 2.500000e-01
  %1411 = select i1 %1373, double %1409, double %1410
  %1412 = load ptr, ptr %120, align 8, !noalias !15
  %1413 = getelementptr inbounds i8, ptr %1412, i64 8
  %1414 = load double, ptr %1413, align 8, !noalias !15
  %1415 = select i1 %1373, double %1414, double 0.000000e+00
  store double %1415, ptr %1413, align 8, !noalias !15
  %1416 = and i64 %1399, %1362
  %1417 = load ptr, ptr %83, align 8, !noalias !15
  %1418 = getelementptr inbounds i8, ptr %1417, i64 8
  %1419 = load i64, ptr %1418, align 8, !noalias !15
  %1420 = xor i64 %1416, -1
  %1421 = and i64 %1419, %1420
  %1422 = getelementptr inbounds i8, ptr %1417, i64 16
  %1423 = load i64, ptr %1422, align 8, !noalias !15
  %1424 = xor i64 %1423, -1
  %1425 = and i64 %1416, %1424
  %1426 = or disjoint i64 %1425, %1421
  store i64 %1426, ptr %1418, align 8, !noalias !15
  br label %1427

1427:                                             ; preds = %1398, %1348
  %1428 = phi double [ %757, %1348 ], [ %1411, %1398 ]
  %1429 = phi double [ %758, %1348 ], [ %1376, %1398 ]
  %1430 = icmp eq i64 %1354, 0
  %1431 = icmp ne i64 %1352, 0
  %1432 = select i1 %1430, i1 true, i1 %1431
  br i1 %1432, label %1981, label %1433

1433:                                             ; preds = %1427
  %1434 = icmp sgt i64 %543, 0
  br i1 %1434, label %1435, label %1437

1435:                                             ; preds = %1433
  %1436 = shl i64 %543, 4
  br label %1967

1437:                                             ; preds = %1967, %1433
  %1438 = getelementptr inbounds i8, ptr %544, i64 32
  %1439 = load i64, ptr %1438, align 8, !noalias !15
  %1440 = load ptr, ptr %81, align 8, !noalias !15
  %1441 = getelementptr inbounds i8, ptr %1440, i64 8
  %1442 = load i64, ptr %1441, align 8, !noalias !15
  %1443 = load ptr, ptr %154, align 8, !noalias !15
  %1444 = load ptr, ptr %155, align 8, !noalias !15
  %1445 = icmp sgt i64 %1442, 0
  br i1 %1445, label %1446, label %1448

1446:                                             ; preds = %1437
  %1447 = shl i64 %1442, 4
  br label %1633

1448:                                             ; preds = %1633, %1437
  %1449 = load i64, ptr %158, align 8, !noalias !15
  %1450 = load ptr, ptr %83, align 8, !noalias !15
  %1451 = getelementptr inbounds i8, ptr %1450, i64 40
  %1452 = load i64, ptr %1451, align 8, !noalias !15
  %1453 = load ptr, ptr %159, align 8, !noalias !15
  %1454 = load ptr, ptr %157, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1453, i64 noundef %1449, ptr noundef %1454, ptr noundef %1444) #9, !noalias !15
  %1455 = icmp sgt i64 %1452, 0
  br i1 %1455, label %1456, label %1460

1456:                                             ; preds = %1448
  %1457 = load ptr, ptr %159, align 8, !noalias !15
  %1458 = load ptr, ptr %157, align 8, !noalias !15
  %1459 = getelementptr inbounds double, ptr %1444, i64 %1449
  tail call fastcc void @real_solve_columns(ptr noundef %1457, i64 noundef %1449, ptr noundef %1458, ptr noundef %1459, i64 noundef %1452) #9, !noalias !15
  br label %1460

1460:                                             ; preds = %1448, %1456
  %1461 = load ptr, ptr %81, align 8, !noalias !15
  %1462 = getelementptr inbounds i8, ptr %1461, i64 24
  %1463 = load i64, ptr %1462, align 8, !noalias !15
  %1464 = load ptr, ptr %160, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %1444, ptr noundef %1464, ptr noundef nonnull %82, i64 noundef %1463) #9, !noalias !15
  %1465 = load double, ptr %8, align 8, !noalias !15
  %1466 = getelementptr inbounds i8, ptr %1461, i64 8
  %1467 = load i64, ptr %1466, align 8, !noalias !15
  %1468 = add nsw i64 %1467, -3
  %1469 = getelementptr i8, ptr %1464, i64 8
  %1470 = getelementptr i8, ptr %1464, i64 16
  %1471 = getelementptr i8, ptr %1464, i64 24
  %1472 = icmp slt i64 %1463, %1468
  br i1 %1472, label %1480, label %1473

1473:                                             ; preds = %1480, %1460
  %1474 = phi double [ 0.000000e+00, %1460 ], [ %1489, %1480 ]
  %1475 = phi double [ 0.000000e+00, %1460 ], [ %1493, %1480 ]
  %1476 = phi double [ 0.000000e+00, %1460 ], [ %1497, %1480 ]
  %1477 = phi double [ 0.000000e+00, %1460 ], [ %1501, %1480 ]
  %1478 = phi i64 [ %1463, %1460 ], [ %1502, %1480 ]
  %1479 = icmp slt i64 %1478, %1467
  br i1 %1479, label %1504, label %1513

1480:                                             ; preds = %1460, %1480
  %1481 = phi i64 [ %1502, %1480 ], [ %1463, %1460 ]
  %1482 = phi double [ %1501, %1480 ], [ 0.000000e+00, %1460 ]
  %1483 = phi double [ %1497, %1480 ], [ 0.000000e+00, %1460 ]
  %1484 = phi double [ %1493, %1480 ], [ 0.000000e+00, %1460 ]
  %1485 = phi double [ %1489, %1480 ], [ 0.000000e+00, %1460 ]
  %1486 = getelementptr inbounds double, ptr %1464, i64 %1481
  %1487 = load double, ptr %1486, align 8, !noalias !15
  %1488 = fmul double %1487, 0.000000e+00
  %1489 = fadd double %1485, %1488
  %1490 = getelementptr double, ptr %1469, i64 %1481
  %1491 = load double, ptr %1490, align 8, !noalias !15
  %1492 = fmul double %1491, 0.000000e+00
  %1493 = fadd double %1484, %1492
  %1494 = getelementptr double, ptr %1470, i64 %1481
  %1495 = load double, ptr %1494, align 8, !noalias !15
  %1496 = fmul double %1495, 0.000000e+00
  %1497 = fadd double %1483, %1496
  %1498 = getelementptr double, ptr %1471, i64 %1481
  %1499 = load double, ptr %1498, align 8, !noalias !15
  %1500 = fmul double %1499, 0.000000e+00
  %1501 = fadd double %1482, %1500
  %1502 = add nsw i64 %1481, 4
  %1503 = icmp slt i64 %1502, %1468
  br i1 %1503, label %1480, label %1473, !llvm.loop !44

1504:                                             ; preds = %1473, %1504
  %1505 = phi i64 [ %1511, %1504 ], [ %1478, %1473 ]
  %1506 = phi double [ %1510, %1504 ], [ %1474, %1473 ]
  %1507 = getelementptr inbounds double, ptr %1464, i64 %1505
  %1508 = load double, ptr %1507, align 8, !noalias !15
  %1509 = fmul double %1508, 0.000000e+00
  %1510 = fadd double %1506, %1509
  %1511 = add nsw i64 %1505, 1
  %1512 = icmp eq i64 %1511, %1467
  br i1 %1512, label %1513, label %1504, !llvm.loop !45

1513:                                             ; preds = %1504, %1473
  %1514 = phi double [ %1474, %1473 ], [ %1510, %1504 ]
  %1515 = fadd double %1475, %1514
  %1516 = fadd double %1476, %1477
  %1517 = fadd double %1516, %1515
  %1518 = fadd double %1465, %1517
  %1519 = getelementptr inbounds i8, ptr %1461, i64 48
  %1520 = load i64, ptr %1519, align 8, !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %6, i8 0, i64 64, i1 false), !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %7, i8 0, i64 64, i1 false), !noalias !15
  %1521 = icmp eq i64 %1520, 0
  br i1 %1521, label %1622, label %1522

1522:                                             ; preds = %1513
  %1523 = add nsw i64 %1463, 7
  %1524 = sdiv i64 %1523, 8
  %1525 = shl nsw i64 %1524, 3
  %1526 = tail call i64 @llvm.smin.i64(i64 %1525, i64 %1520)
  %1527 = icmp slt i64 %1463, %1526
  br i1 %1527, label %1528, label %1562

1528:                                             ; preds = %1522
  %1529 = load ptr, ptr %82, align 8, !noalias !15
  %1530 = load ptr, ptr %161, align 8, !noalias !15
  %1531 = load ptr, ptr %88, align 8, !noalias !15
  br label %1532

1532:                                             ; preds = %1528, %1532
  %1533 = phi i64 [ %1463, %1528 ], [ %1560, %1532 ]
  %1534 = getelementptr inbounds double, ptr %1529, i64 %1533
  %1535 = load double, ptr %1534, align 8, !noalias !15
  %1536 = tail call double @llvm.fabs.f64(double %1535)
  %1537 = getelementptr inbounds double, ptr %1464, i64 %1533
  %1538 = load double, ptr %1537, align 8, !noalias !15
  %1539 = tail call double @llvm.fabs.f64(double %1538)
  %1540 = fcmp ogt double %1536, %1539
  %1541 = select i1 %1540, double %1536, double %1539
  %1542 = getelementptr inbounds double, ptr %1530, i64 %1533
  %1543 = load double, ptr %1542, align 8, !noalias !15
  %1544 = getelementptr inbounds double, ptr %1531, i64 %1533
  %1545 = load double, ptr %1544, align 8, !noalias !15
  %1546 = fmul double %1541, %1545
  %1547 = fadd double %1543, %1546
  %1548 = fdiv double 1.000000e+00, %1547
  %1549 = getelementptr inbounds double, ptr %1444, i64 %1533
  %1550 = load double, ptr %1549, align 8, !noalias !15
  %1551 = fmul double %1550, %1548
  %1552 = srem i64 %1533, 8
  %1553 = getelementptr inbounds double, ptr %6, i64 %1552
  %1554 = load double, ptr %1553, align 8, !noalias !15
  %1555 = fmul double %1551, %1551
  %1556 = fadd double %1554, %1555
  store double %1556, ptr %1553, align 8, !noalias !15
  %1557 = getelementptr inbounds double, ptr %7, i64 %1552
  %1558 = load double, ptr %1557, align 8, !noalias !15
  %1559 = fadd double %1558, %1555
  store double %1559, ptr %1557, align 8, !noalias !15
  %1560 = add nsw i64 %1533, 1
  %1561 = icmp eq i64 %1560, %1526
  br i1 %1561, label %1562, label %1532, !llvm.loop !46

1562:                                             ; preds = %1532, %1522
  %1563 = phi i64 [ %1463, %1522 ], [ %1560, %1532 ]
  %1564 = load <8 x double>, ptr %6, align 16, !noalias !15
  %1565 = load <8 x double>, ptr %7, align 16, !noalias !15
  %1566 = icmp slt i64 %1563, %1520
  br i1 %1566, label %1567, label %1602

1567:                                             ; preds = %1562
  %1568 = load ptr, ptr %82, align 8, !noalias !15
  %1569 = load ptr, ptr %162, align 8, !noalias !15
  %1570 = load ptr, ptr %88, align 8, !noalias !15
  br label %1571

1571:                                             ; preds = %1567, %1571
  %1572 = phi i64 [ %1563, %1567 ], [ %1600, %1571 ]
  %1573 = phi <8 x double> [ %1564, %1567 ], [ %1598, %1571 ]
  %1574 = phi <8 x double> [ %1565, %1567 ], [ %1599, %1571 ]
  %1575 = getelementptr inbounds double, ptr %1568, i64 %1572
  %1576 = load <8 x double>, ptr %1575, align 8, !noalias !15
  %1577 = fneg <8 x double> %1576
  %1578 = fcmp ogt <8 x double> %1576, zeroinitializer
  %1579 = select <8 x i1> %1578, <8 x double> %1576, <8 x double> %1577
  %1580 = getelementptr inbounds double, ptr %1464, i64 %1572
  %1581 = load <8 x double>, ptr %1580, align 8, !noalias !15
  %1582 = fneg <8 x double> %1581
  %1583 = fcmp ogt <8 x double> %1581, zeroinitializer
  %1584 = select <8 x i1> %1583, <8 x double> %1581, <8 x double> %1582
  %1585 = fcmp ogt <8 x double> %1579, %1584
  %1586 = select <8 x i1> %1585, <8 x double> %1579, <8 x double> %1584
  %1587 = getelementptr inbounds double, ptr %1569, i64 %1572
  %1588 = load <8 x double>, ptr %1587, align 8, !noalias !15
  %1589 = getelementptr inbounds double, ptr %1570, i64 %1572
  %1590 = load <8 x double>, ptr %1589, align 8, !noalias !15
  %1591 = fmul <8 x double> %1590, %1586
  %1592 = fadd <8 x double> %1588, %1591
  %1593 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1592
  %1594 = getelementptr inbounds double, ptr %1444, i64 %1572
  %1595 = load <8 x double>, ptr %1594, align 8, !noalias !15
  %1596 = fmul <8 x double> %1595, %1593
  %1597 = fmul <8 x double> %1596, %1596
  %1598 = fadd <8 x double> %1573, %1597
  %1599 = fadd <8 x double> %1574, %1597
  %1600 = add nsw i64 %1572, 8
  %1601 = icmp slt i64 %1600, %1520
  br i1 %1601, label %1571, label %1602, !llvm.loop !47

1602:                                             ; preds = %1571, %1562
  %1603 = phi <8 x double> [ %1565, %1562 ], [ %1599, %1571 ]
  %1604 = phi <8 x double> [ %1564, %1562 ], [ %1598, %1571 ]
  store <8 x double> %1604, ptr %6, align 16, !noalias !15
  store <8 x double> %1603, ptr %7, align 16, !noalias !15
  br label %1614

1605:                                             ; preds = %1614
  %1606 = sub nsw i64 %1520, %1463
  %1607 = sitofp i64 %1606 to double
  %1608 = fdiv double %1619, %1607
  %1609 = tail call double @llvm.sqrt.f64(double %1608)
  %1610 = fcmp ule double %533, %237
  %1611 = fcmp ogt double %1609, %1518
  %1612 = select i1 %1611, double %1609, double %1518
  %1613 = select i1 %1610, double %1518, double %1612
  br label %1622

1614:                                             ; preds = %1602, %1614
  %1615 = phi i64 [ 0, %1602 ], [ %1620, %1614 ]
  %1616 = phi double [ 0.000000e+00, %1602 ], [ %1619, %1614 ]
  %1617 = getelementptr inbounds double, ptr %6, i64 %1615
  %1618 = load double, ptr %1617, align 8, !noalias !15
  %1619 = fadd double %1616, %1618
  %1620 = add nuw nsw i64 %1615, 1
  %1621 = icmp eq i64 %1620, 8
  br i1 %1621, label %1605, label %1614, !llvm.loop !48

1622:                                             ; preds = %1513, %1605
  %1623 = phi double [ %1613, %1605 ], [ %1518, %1513 ]
  %1624 = fcmp olt double %1623, 1.000000e+00
  %1625 = zext i1 %1624 to i64
  %1626 = xor i64 %1625, -1
  %1627 = and i64 %1439, %1626
  %1628 = and i64 %1627, %1354
  %1629 = and i64 %1354, %1625
  %1630 = icmp eq i64 %1628, 0
  br i1 %1630, label %1900, label %1631

1631:                                             ; preds = %1622
  %1632 = icmp sgt i64 %1442, 0
  br i1 %1632, label %1692, label %1658

1633:                                             ; preds = %1446, %1633
  %1634 = phi i64 [ 0, %1446 ], [ %1656, %1633 ]
  %1635 = load ptr, ptr %128, align 8, !noalias !15
  %1636 = getelementptr inbounds double, ptr %1635, i64 %1634
  %1637 = load double, ptr %1636, align 8, !noalias !15
  %1638 = fmul double %1637, 0x402418FD8BAFFE05
  %1639 = getelementptr double, ptr %1635, i64 %1442
  %1640 = getelementptr double, ptr %1639, i64 %1634
  %1641 = load double, ptr %1640, align 8, !noalias !15
  %1642 = fmul double %1641, 0x3FF61D41B2D54580
  %1643 = fsub double %1642, %1638
  %1644 = getelementptr i8, ptr %1635, i64 %1447
  %1645 = getelementptr double, ptr %1644, i64 %1634
  %1646 = load double, ptr %1645, align 8, !noalias !15
  %1647 = fmul double %1646, 0x3FD5555555555555
  %1648 = fsub double %1643, %1647
  %1649 = fdiv double %1648, %533
  %1650 = getelementptr inbounds double, ptr %1443, i64 %1634
  store double %1649, ptr %1650, align 8, !noalias !15
  %1651 = load ptr, ptr %156, align 8, !noalias !15
  %1652 = getelementptr inbounds double, ptr %1651, i64 %1634
  %1653 = load double, ptr %1652, align 8, !noalias !15
  %1654 = fadd double %1653, %1649
  %1655 = getelementptr inbounds double, ptr %1444, i64 %1634
  store double %1654, ptr %1655, align 8, !noalias !15
  %1656 = add nuw nsw i64 %1634, 1
  %1657 = icmp eq i64 %1656, %1442
  br i1 %1657, label %1448, label %1633, !llvm.loop !49

1658:                                             ; preds = %1692, %1631
  %1659 = and i64 %1628, 4294967295
  %1660 = icmp eq i64 %1659, 0
  %1661 = select i1 %1660, double 0.000000e+00, double 1.000000e+00
  %1662 = fadd double %1355, %1661
  %1663 = load ptr, ptr %164, align 8, !noalias !15
  %1664 = load ptr, ptr %165, align 8, !noalias !15
  %1665 = load ptr, ptr %166, align 8, !noalias !15
  store double %456, ptr %1665, align 8, !noalias !15
  %1666 = load ptr, ptr %81, align 8, !noalias !15
  %1667 = getelementptr inbounds i8, ptr %1666, i64 40
  %1668 = load i64, ptr %1667, align 8, !noalias !15
  %1669 = icmp eq i64 %1668, 0
  br i1 %1669, label %1671, label %1670

1670:                                             ; preds = %1658
  tail call fastcc void @settle(ptr noundef nonnull %81) #9, !noalias !15
  br label %1671

1671:                                             ; preds = %1670, %1658
  %1672 = load i64, ptr %167, align 8, !noalias !15
  %1673 = icmp sgt i64 %1672, 0
  br i1 %1673, label %1674, label %1675

1674:                                             ; preds = %1671
  tail call fastcc void @sample(ptr noundef nonnull %81) #9, !noalias !15
  br label %1675

1675:                                             ; preds = %1674, %1671
  %1676 = load ptr, ptr %81, align 8, !noalias !15
  %1677 = load i64, ptr %1676, align 8, !noalias !15
  %1678 = load ptr, ptr %166, align 8, !noalias !15
  %1679 = load ptr, ptr %168, align 8, !noalias !15
  %1680 = load ptr, ptr %169, align 8, !noalias !15
  %1681 = inttoptr i64 %1677 to ptr
  %1682 = load ptr, ptr %1681, align 8, !noalias !15
  %1683 = tail call i32 %1682(ptr noundef %1678, ptr noundef %1663, ptr noundef %1679, ptr noundef %1680, ptr noundef %1664) #10, !noalias !15
  %1684 = sext i32 %1683 to i64
  %1685 = icmp slt i32 %1683, 0
  %1686 = select i1 %1685, i64 %1684, i64 %1352
  %1687 = trunc i64 %1628 to i32
  %1688 = and i32 %1683, %1687
  %1689 = icmp eq i32 %1688, 0
  %1690 = select i1 %1689, double %1429, double 3.000000e+00
  %1691 = icmp sgt i64 %1442, 0
  br i1 %1691, label %1889, label %1704

1692:                                             ; preds = %1631, %1692
  %1693 = phi i64 [ %1702, %1692 ], [ 0, %1631 ]
  %1694 = load ptr, ptr %163, align 8, !noalias !15
  %1695 = load ptr, ptr %82, align 8, !noalias !15
  %1696 = getelementptr inbounds double, ptr %1695, i64 %1693
  %1697 = load double, ptr %1696, align 8, !noalias !15
  %1698 = getelementptr inbounds double, ptr %1444, i64 %1693
  %1699 = load double, ptr %1698, align 8, !noalias !15
  %1700 = fadd double %1697, %1699
  %1701 = getelementptr inbounds double, ptr %1694, i64 %1693
  store double %1700, ptr %1701, align 8, !noalias !15
  %1702 = add nuw nsw i64 %1693, 1
  %1703 = icmp eq i64 %1702, %1442
  br i1 %1703, label %1658, label %1692, !llvm.loop !50

1704:                                             ; preds = %1889, %1675
  %1705 = load i64, ptr %158, align 8, !noalias !15
  %1706 = load ptr, ptr %83, align 8, !noalias !15
  %1707 = getelementptr inbounds i8, ptr %1706, i64 40
  %1708 = load i64, ptr %1707, align 8, !noalias !15
  %1709 = load ptr, ptr %159, align 8, !noalias !15
  %1710 = load ptr, ptr %157, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1709, i64 noundef %1705, ptr noundef %1710, ptr noundef %1444) #9, !noalias !15
  %1711 = icmp sgt i64 %1708, 0
  br i1 %1711, label %1712, label %1716

1712:                                             ; preds = %1704
  %1713 = load ptr, ptr %159, align 8, !noalias !15
  %1714 = load ptr, ptr %157, align 8, !noalias !15
  %1715 = getelementptr inbounds double, ptr %1444, i64 %1705
  tail call fastcc void @real_solve_columns(ptr noundef %1713, i64 noundef %1705, ptr noundef %1714, ptr noundef %1715, i64 noundef %1708) #9, !noalias !15
  br label %1716

1716:                                             ; preds = %1704, %1712
  %1717 = load ptr, ptr %81, align 8, !noalias !15
  %1718 = getelementptr inbounds i8, ptr %1717, i64 24
  %1719 = load i64, ptr %1718, align 8, !noalias !15
  %1720 = load ptr, ptr %160, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %9, ptr noundef %1444, ptr noundef %1720, ptr noundef nonnull %82, i64 noundef %1719) #9, !noalias !15
  %1721 = load double, ptr %9, align 8, !noalias !15
  %1722 = getelementptr inbounds i8, ptr %1717, i64 8
  %1723 = load i64, ptr %1722, align 8, !noalias !15
  %1724 = add nsw i64 %1723, -3
  %1725 = getelementptr i8, ptr %1720, i64 8
  %1726 = getelementptr i8, ptr %1720, i64 16
  %1727 = getelementptr i8, ptr %1720, i64 24
  %1728 = icmp slt i64 %1719, %1724
  br i1 %1728, label %1736, label %1729

1729:                                             ; preds = %1736, %1716
  %1730 = phi double [ 0.000000e+00, %1716 ], [ %1745, %1736 ]
  %1731 = phi double [ 0.000000e+00, %1716 ], [ %1749, %1736 ]
  %1732 = phi double [ 0.000000e+00, %1716 ], [ %1753, %1736 ]
  %1733 = phi double [ 0.000000e+00, %1716 ], [ %1757, %1736 ]
  %1734 = phi i64 [ %1719, %1716 ], [ %1758, %1736 ]
  %1735 = icmp slt i64 %1734, %1723
  br i1 %1735, label %1760, label %1769

1736:                                             ; preds = %1716, %1736
  %1737 = phi i64 [ %1758, %1736 ], [ %1719, %1716 ]
  %1738 = phi double [ %1757, %1736 ], [ 0.000000e+00, %1716 ]
  %1739 = phi double [ %1753, %1736 ], [ 0.000000e+00, %1716 ]
  %1740 = phi double [ %1749, %1736 ], [ 0.000000e+00, %1716 ]
  %1741 = phi double [ %1745, %1736 ], [ 0.000000e+00, %1716 ]
  %1742 = getelementptr inbounds double, ptr %1720, i64 %1737
  %1743 = load double, ptr %1742, align 8, !noalias !15
  %1744 = fmul double %1743, 0.000000e+00
  %1745 = fadd double %1741, %1744
  %1746 = getelementptr double, ptr %1725, i64 %1737
  %1747 = load double, ptr %1746, align 8, !noalias !15
  %1748 = fmul double %1747, 0.000000e+00
  %1749 = fadd double %1740, %1748
  %1750 = getelementptr double, ptr %1726, i64 %1737
  %1751 = load double, ptr %1750, align 8, !noalias !15
  %1752 = fmul double %1751, 0.000000e+00
  %1753 = fadd double %1739, %1752
  %1754 = getelementptr double, ptr %1727, i64 %1737
  %1755 = load double, ptr %1754, align 8, !noalias !15
  %1756 = fmul double %1755, 0.000000e+00
  %1757 = fadd double %1738, %1756
  %1758 = add nsw i64 %1737, 4
  %1759 = icmp slt i64 %1758, %1724
  br i1 %1759, label %1736, label %1729, !llvm.loop !44

1760:                                             ; preds = %1729, %1760
  %1761 = phi i64 [ %1767, %1760 ], [ %1734, %1729 ]
  %1762 = phi double [ %1766, %1760 ], [ %1730, %1729 ]
  %1763 = getelementptr inbounds double, ptr %1720, i64 %1761
  %1764 = load double, ptr %1763, align 8, !noalias !15
  %1765 = fmul double %1764, 0.000000e+00
  %1766 = fadd double %1762, %1765
  %1767 = add nsw i64 %1761, 1
  %1768 = icmp eq i64 %1767, %1723
  br i1 %1768, label %1769, label %1760, !llvm.loop !45

1769:                                             ; preds = %1760, %1729
  %1770 = phi double [ %1730, %1729 ], [ %1766, %1760 ]
  %1771 = fadd double %1731, %1770
  %1772 = fadd double %1732, %1733
  %1773 = fadd double %1772, %1771
  %1774 = fadd double %1721, %1773
  %1775 = getelementptr inbounds i8, ptr %1717, i64 48
  %1776 = load i64, ptr %1775, align 8, !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %4, i8 0, i64 64, i1 false), !noalias !15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %5, i8 0, i64 64, i1 false), !noalias !15
  %1777 = icmp eq i64 %1776, 0
  br i1 %1777, label %1878, label %1778

1778:                                             ; preds = %1769
  %1779 = add nsw i64 %1719, 7
  %1780 = sdiv i64 %1779, 8
  %1781 = shl nsw i64 %1780, 3
  %1782 = tail call i64 @llvm.smin.i64(i64 %1781, i64 %1776)
  %1783 = icmp slt i64 %1719, %1782
  br i1 %1783, label %1784, label %1818

1784:                                             ; preds = %1778
  %1785 = load ptr, ptr %82, align 8, !noalias !15
  %1786 = load ptr, ptr %170, align 8, !noalias !15
  %1787 = load ptr, ptr %88, align 8, !noalias !15
  br label %1788

1788:                                             ; preds = %1784, %1788
  %1789 = phi i64 [ %1719, %1784 ], [ %1816, %1788 ]
  %1790 = getelementptr inbounds double, ptr %1785, i64 %1789
  %1791 = load double, ptr %1790, align 8, !noalias !15
  %1792 = tail call double @llvm.fabs.f64(double %1791)
  %1793 = getelementptr inbounds double, ptr %1720, i64 %1789
  %1794 = load double, ptr %1793, align 8, !noalias !15
  %1795 = tail call double @llvm.fabs.f64(double %1794)
  %1796 = fcmp ogt double %1792, %1795
  %1797 = select i1 %1796, double %1792, double %1795
  %1798 = getelementptr inbounds double, ptr %1786, i64 %1789
  %1799 = load double, ptr %1798, align 8, !noalias !15
  %1800 = getelementptr inbounds double, ptr %1787, i64 %1789
  %1801 = load double, ptr %1800, align 8, !noalias !15
  %1802 = fmul double %1797, %1801
  %1803 = fadd double %1799, %1802
  %1804 = fdiv double 1.000000e+00, %1803
  %1805 = getelementptr inbounds double, ptr %1444, i64 %1789
  %1806 = load double, ptr %1805, align 8, !noalias !15
  %1807 = fmul double %1806, %1804
  %1808 = srem i64 %1789, 8
  %1809 = getelementptr inbounds double, ptr %4, i64 %1808
  %1810 = load double, ptr %1809, align 8, !noalias !15
  %1811 = fmul double %1807, %1807
  %1812 = fadd double %1810, %1811
  store double %1812, ptr %1809, align 8, !noalias !15
  %1813 = getelementptr inbounds double, ptr %5, i64 %1808
  %1814 = load double, ptr %1813, align 8, !noalias !15
  %1815 = fadd double %1814, %1811
  store double %1815, ptr %1813, align 8, !noalias !15
  %1816 = add nsw i64 %1789, 1
  %1817 = icmp eq i64 %1816, %1782
  br i1 %1817, label %1818, label %1788, !llvm.loop !46

1818:                                             ; preds = %1788, %1778
  %1819 = phi i64 [ %1719, %1778 ], [ %1816, %1788 ]
  %1820 = load <8 x double>, ptr %4, align 16, !noalias !15
  %1821 = load <8 x double>, ptr %5, align 16, !noalias !15
  %1822 = icmp slt i64 %1819, %1776
  br i1 %1822, label %1823, label %1858

1823:                                             ; preds = %1818
  %1824 = load ptr, ptr %82, align 8, !noalias !15
  %1825 = load ptr, ptr %171, align 8, !noalias !15
  %1826 = load ptr, ptr %88, align 8, !noalias !15
  br label %1827

1827:                                             ; preds = %1823, %1827
  %1828 = phi i64 [ %1819, %1823 ], [ %1856, %1827 ]
  %1829 = phi <8 x double> [ %1820, %1823 ], [ %1854, %1827 ]
  %1830 = phi <8 x double> [ %1821, %1823 ], [ %1855, %1827 ]
  %1831 = getelementptr inbounds double, ptr %1824, i64 %1828
  %1832 = load <8 x double>, ptr %1831, align 8, !noalias !15
  %1833 = fneg <8 x double> %1832
  %1834 = fcmp ogt <8 x double> %1832, zeroinitializer
  %1835 = select <8 x i1> %1834, <8 x double> %1832, <8 x double> %1833
  %1836 = getelementptr inbounds double, ptr %1720, i64 %1828
  %1837 = load <8 x double>, ptr %1836, align 8, !noalias !15
  %1838 = fneg <8 x double> %1837
  %1839 = fcmp ogt <8 x double> %1837, zeroinitializer
  %1840 = select <8 x i1> %1839, <8 x double> %1837, <8 x double> %1838
  %1841 = fcmp ogt <8 x double> %1835, %1840
  %1842 = select <8 x i1> %1841, <8 x double> %1835, <8 x double> %1840
  %1843 = getelementptr inbounds double, ptr %1825, i64 %1828
  %1844 = load <8 x double>, ptr %1843, align 8, !noalias !15
  %1845 = getelementptr inbounds double, ptr %1826, i64 %1828
  %1846 = load <8 x double>, ptr %1845, align 8, !noalias !15
  %1847 = fmul <8 x double> %1846, %1842
  %1848 = fadd <8 x double> %1844, %1847
  %1849 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1848
  %1850 = getelementptr inbounds double, ptr %1444, i64 %1828
  %1851 = load <8 x double>, ptr %1850, align 8, !noalias !15
  %1852 = fmul <8 x double> %1851, %1849
  %1853 = fmul <8 x double> %1852, %1852
  %1854 = fadd <8 x double> %1829, %1853
  %1855 = fadd <8 x double> %1830, %1853
  %1856 = add nsw i64 %1828, 8
  %1857 = icmp slt i64 %1856, %1776
  br i1 %1857, label %1827, label %1858, !llvm.loop !47

1858:                                             ; preds = %1827, %1818
  %1859 = phi <8 x double> [ %1821, %1818 ], [ %1855, %1827 ]
  %1860 = phi <8 x double> [ %1820, %1818 ], [ %1854, %1827 ]
  store <8 x double> %1860, ptr %4, align 16, !noalias !15
  store <8 x double> %1859, ptr %5, align 16, !noalias !15
  br label %1870

1861:                                             ; preds = %1870
  %1862 = sub nsw i64 %1776, %1719
  %1863 = sitofp i64 %1862 to double
  %1864 = fdiv double %1875, %1863
  %1865 = tail call double @llvm.sqrt.f64(double %1864)
  %1866 = fcmp ule double %533, %237
  %1867 = fcmp ogt double %1865, %1774
  %1868 = select i1 %1867, double %1865, double %1774
  %1869 = select i1 %1866, double %1774, double %1868
  br label %1878

1870:                                             ; preds = %1858, %1870
  %1871 = phi i64 [ 0, %1858 ], [ %1876, %1870 ]
  %1872 = phi double [ 0.000000e+00, %1858 ], [ %1875, %1870 ]
  %1873 = getelementptr inbounds double, ptr %4, i64 %1871
  %1874 = load double, ptr %1873, align 8, !noalias !15
  %1875 = fadd double %1872, %1874
  %1876 = add nuw nsw i64 %1871, 1
  %1877 = icmp eq i64 %1876, 8
  br i1 %1877, label %1861, label %1870, !llvm.loop !48

1878:                                             ; preds = %1769, %1861
  %1879 = phi double [ %1869, %1861 ], [ %1774, %1769 ]
  %1880 = xor i64 %1684, -1
  %1881 = and i64 %1628, %1880
  %1882 = fcmp olt double %1879, 1.000000e+00
  %1883 = and i64 %1881, 1
  %1884 = select i1 %1882, i64 %1883, i64 0
  %1885 = or i64 %1884, %1629
  %1886 = and i64 %1881, 4294967295
  %1887 = icmp eq i64 %1886, 0
  %1888 = select i1 %1887, double %1623, double %1879
  br label %1900

1889:                                             ; preds = %1675, %1889
  %1890 = phi i64 [ %1898, %1889 ], [ 0, %1675 ]
  %1891 = load ptr, ptr %165, align 8, !noalias !15
  %1892 = getelementptr inbounds double, ptr %1891, i64 %1890
  %1893 = load double, ptr %1892, align 8, !noalias !15
  %1894 = getelementptr inbounds double, ptr %1443, i64 %1890
  %1895 = load double, ptr %1894, align 8, !noalias !15
  %1896 = fadd double %1893, %1895
  %1897 = getelementptr inbounds double, ptr %1444, i64 %1890
  store double %1896, ptr %1897, align 8, !noalias !15
  %1898 = add nuw nsw i64 %1890, 1
  %1899 = icmp eq i64 %1898, %1442
  br i1 %1899, label %1704, label %1889, !llvm.loop !51

1900:                                             ; preds = %1622, %1878
  %1901 = phi double [ %1355, %1622 ], [ %1662, %1878 ]
  %1902 = phi i64 [ %1352, %1622 ], [ %1686, %1878 ]
  %1903 = phi i64 [ %1629, %1622 ], [ %1885, %1878 ]
  %1904 = phi double [ %1429, %1622 ], [ %1690, %1878 ]
  %1905 = phi double [ %1623, %1622 ], [ %1888, %1878 ]
  %1906 = fcmp olt double %1905, 1.000000e-10
  %1907 = select i1 %1906, double 1.000000e-10, double %1905
  %1908 = load ptr, ptr %120, align 8, !noalias !15
  %1909 = getelementptr inbounds i8, ptr %1908, i64 24
  %1910 = load double, ptr %1909, align 8, !noalias !15
  %1911 = fadd double %1351, 1.200000e+01
  %1912 = fdiv double 0x4027666666666667, %1911
  %1913 = tail call double @llvm.sqrt.f64(double %1907)
  %1914 = tail call double @llvm.sqrt.f64(double %1913)
  %1915 = fdiv double 1.000000e+00, %1914
  %1916 = fmul double %1912, %1915
  %1917 = fcmp ogt double %1916, 2.000000e-01
  %1918 = select i1 %1917, double %1916, double 2.000000e-01
  %1919 = tail call double @llvm.fabs.f64(double %1905)
  %1920 = fcmp ueq double %1919, 0x7FF0000000000000
  %1921 = select i1 %1920, double 2.500000e-01, double %1918
  %1922 = fmul double %533, %1921
  %1923 = getelementptr inbounds i8, ptr %1908, i64 16
  %1924 = load double, ptr %1923, align 8, !noalias !15
  %1925 = fdiv double %533, %1924
  %1926 = fdiv double %1910, %1907
  %1927 = tail call double @llvm.sqrt.f64(double %1926)
  %1928 = tail call double @llvm.sqrt.f64(double %1927)
  %1929 = fmul double %1925, %1928
  %1930 = fcmp ule double %1910, 0.000000e+00
  %1931 = fcmp olt double %1929, 1.000000e+00
  %1932 = select i1 %1931, double %1929, double 1.000000e+00
  %1933 = select i1 %1930, double 1.000000e+00, double %1932
  %1934 = fmul double %1916, %1933
  %1935 = fcmp olt double %1934, 1.000000e+01
  %1936 = select i1 %1935, double %1934, double 1.000000e+01
  %1937 = fcmp ule double %1936, 1.000000e+00
  %1938 = fcmp uge double %1936, 1.200000e+00
  %1939 = or i1 %1937, %1938
  %1940 = select i1 %1939, i1 true, i1 %1358
  %1941 = load double, ptr %1908, align 8, !noalias !15
  %1942 = fcmp ogt double %1936, 2.000000e-01
  %1943 = select i1 %1942, double %1936, double 2.000000e-01
  %1944 = fmul double %533, %1943
  %1945 = select i1 %1940, double %1944, double %1941
  %1946 = icmp eq i64 %1903, 0
  %1947 = select i1 %1946, double %1922, double %1945
  %1948 = and i64 %1354, 4294967295
  %1949 = icmp eq i64 %1948, 0
  %1950 = select i1 %1949, double %1428, double %1947
  %1951 = xor i64 %1903, -1
  %1952 = and i64 %1354, %1951
  %1953 = load ptr, ptr %83, align 8, !noalias !15
  %1954 = getelementptr inbounds i8, ptr %1953, i64 32
  %1955 = load i64, ptr %1954, align 8, !noalias !15
  %1956 = or i64 %1955, %1952
  store i64 %1956, ptr %1954, align 8, !noalias !15
  %1957 = load ptr, ptr %83, align 8, !noalias !15
  %1958 = getelementptr inbounds i8, ptr %1957, i64 8
  %1959 = load i64, ptr %1958, align 8, !noalias !15
  %1960 = xor i64 %1952, -1
  %1961 = and i64 %1959, %1960
  %1962 = getelementptr inbounds i8, ptr %1957, i64 16
  %1963 = load i64, ptr %1962, align 8, !noalias !15
  %1964 = xor i64 %1963, -1
  %1965 = and i64 %1952, %1964
  %1966 = or disjoint i64 %1965, %1961
  store i64 %1966, ptr %1958, align 8, !noalias !15
  br label %1981

1967:                                             ; preds = %1435, %1967
  %1968 = phi i64 [ 0, %1435 ], [ %1979, %1967 ]
  %1969 = load ptr, ptr %153, align 8, !noalias !15
  %1970 = load ptr, ptr %82, align 8, !noalias !15
  %1971 = getelementptr inbounds double, ptr %1970, i64 %1968
  %1972 = load double, ptr %1971, align 8, !noalias !15
  %1973 = load ptr, ptr %128, align 8, !noalias !15
  %1974 = getelementptr i8, ptr %1973, i64 %1436
  %1975 = getelementptr double, ptr %1974, i64 %1968
  %1976 = load double, ptr %1975, align 8, !noalias !15
  %1977 = fadd double %1972, %1976
  %1978 = getelementptr inbounds double, ptr %1969, i64 %1968
  store double %1977, ptr %1978, align 8, !noalias !15
  %1979 = add nuw nsw i64 %1968, 1
  %1980 = icmp eq i64 %1979, %543
  br i1 %1980, label %1437, label %1967, !llvm.loop !52

1981:                                             ; preds = %1900, %1427, %756, %669
  %1982 = phi double [ %463, %669 ], [ %463, %756 ], [ %1349, %1427 ], [ %1349, %1900 ]
  %1983 = phi double [ %462, %669 ], [ %462, %756 ], [ %1350, %1427 ], [ %1350, %1900 ]
  %1984 = phi double [ %461, %669 ], [ %461, %756 ], [ %1351, %1427 ], [ %1351, %1900 ]
  %1985 = phi i64 [ %460, %669 ], [ %460, %756 ], [ %1352, %1427 ], [ %1352, %1900 ]
  %1986 = phi i64 [ %459, %669 ], [ %459, %756 ], [ %1353, %1427 ], [ %1353, %1900 ]
  %1987 = phi i64 [ %458, %669 ], [ %458, %756 ], [ %1354, %1427 ], [ %1354, %1900 ]
  %1988 = phi i1 [ false, %669 ], [ false, %756 ], [ %1358, %1427 ], [ %1358, %1900 ]
  %1989 = phi double [ 2.000000e+00, %669 ], [ %758, %756 ], [ %1429, %1427 ], [ %1904, %1900 ]
  %1990 = phi double [ 0.000000e+00, %669 ], [ 0.000000e+00, %756 ], [ 0.000000e+00, %1427 ], [ %1905, %1900 ]
  %1991 = phi double [ %457, %669 ], [ %757, %756 ], [ %1428, %1427 ], [ %1950, %1900 ]
  %1992 = phi double [ %652, %669 ], [ %681, %756 ], [ %1355, %1427 ], [ %1901, %1900 ]
  %1993 = phi i64 [ 0, %669 ], [ %695, %756 ], [ %695, %1427 ], [ %695, %1900 ]
  %1994 = phi i64 [ 1, %669 ], [ 0, %756 ], [ %1352, %1427 ], [ %1902, %1900 ]
  %1995 = phi i64 [ 0, %669 ], [ 0, %756 ], [ 0, %1427 ], [ %1903, %1900 ]
  %1996 = zext i1 %1988 to i64
  %1997 = fptosi double %1992 to i64
  %1998 = load i64, ptr %434, align 8
  %1999 = add nsw i64 %1998, %1997
  store i64 %1999, ptr %434, align 8
  %2000 = load i64, ptr %435, align 8
  %2001 = add nsw i64 %2000, %547
  store i64 %2001, ptr %435, align 8
  %2002 = load i64, ptr %436, align 8
  %2003 = add nsw i64 %2002, %1993
  store i64 %2003, ptr %436, align 8
  %2004 = icmp eq i64 %1994, 0
  br i1 %2004, label %2005, label %2591

2005:                                             ; preds = %1981
  %2006 = icmp eq i64 %1995, 0
  br i1 %2006, label %2007, label %2011

2007:                                             ; preds = %2005
  %2008 = load i64, ptr %421, align 8
  %2009 = add nsw i64 %2008, 1
  store i64 %2009, ptr %421, align 8
  %2010 = fptosi double %1989 to i64
  store i64 %2010, ptr %444, align 8
  br label %2591, !llvm.loop !53

2011:                                             ; preds = %2005
  br i1 %254, label %2012, label %2040

2012:                                             ; preds = %2011
  %2013 = load ptr, ptr %172, align 8
  %2014 = load ptr, ptr %82, align 8
  %2015 = load ptr, ptr %89, align 8
  %2016 = getelementptr inbounds i8, ptr %2015, i64 56
  %2017 = load i64, ptr %2016, align 8
  %2018 = inttoptr i64 %2017 to ptr
  %2019 = tail call i64 %2018(ptr noundef %0, double noundef %532, ptr noundef %2013, ptr noundef %2014) #10
  %2020 = icmp eq i64 %2019, 0
  br i1 %2020, label %2040, label %2021

2021:                                             ; preds = %2012
  %2022 = load i64, ptr %421, align 8
  %2023 = add nsw i64 %2022, 1
  store i64 %2023, ptr %421, align 8
  store i64 6, ptr %437, align 8
  %2024 = fmul double %533, 2.500000e-01
  %2025 = load ptr, ptr %83, align 8
  %2026 = getelementptr inbounds i8, ptr %2025, i64 32
  %2027 = load i64, ptr %2026, align 8
  %2028 = or i64 %2027, 1
  store i64 %2028, ptr %2026, align 8
  %2029 = load ptr, ptr %83, align 8
  %2030 = getelementptr inbounds i8, ptr %2029, i64 8
  %2031 = load i64, ptr %2030, align 8
  %2032 = and i64 %2031, -2
  %2033 = getelementptr inbounds i8, ptr %2029, i64 16
  %2034 = load i64, ptr %2033, align 8
  %2035 = and i64 %2034, 1
  %2036 = or disjoint i64 %2035, %2032
  %2037 = xor i64 %2036, 1
  store i64 %2037, ptr %2030, align 8
  %2038 = load ptr, ptr %173, align 8
  %2039 = getelementptr inbounds i8, ptr %2038, i64 8
  store double 0.000000e+00, ptr %2039, align 8
  br label %2591, !llvm.loop !53

2040:                                             ; preds = %2012, %2011
  %2041 = load i64, ptr %420, align 8
  %2042 = add nsw i64 %2041, 1
  store i64 %2042, ptr %420, align 8
  store double %532, ptr %221, align 8
  store double %533, ptr %438, align 8
  %2043 = load ptr, ptr %81, align 8
  %2044 = getelementptr inbounds i8, ptr %2043, i64 8
  %2045 = load i64, ptr %2044, align 8
  %2046 = load i64, ptr %174, align 8
  %2047 = load ptr, ptr %175, align 8
  %2048 = load ptr, ptr %176, align 8
  %2049 = load ptr, ptr %177, align 8
  %2050 = load ptr, ptr %178, align 8
  br label %2066

2051:                                             ; preds = %2066
  %2052 = icmp sgt i64 %2045, 0
  br i1 %2052, label %2053, label %2126

2053:                                             ; preds = %2051
  %2054 = load double, ptr %13, align 16
  %2055 = load double, ptr %179, align 8
  %2056 = getelementptr double, ptr %2047, i64 %2045
  %2057 = load double, ptr %180, align 16
  %2058 = shl i64 %2045, 4
  %2059 = getelementptr i8, ptr %2047, i64 %2058
  %2060 = load double, ptr %14, align 16
  %2061 = load double, ptr %181, align 8
  %2062 = load double, ptr %182, align 16
  %2063 = getelementptr inbounds double, ptr %2048, i64 %2046
  %2064 = shl nsw i64 %2046, 4
  %2065 = getelementptr inbounds i8, ptr %2048, i64 %2064
  br label %2077

2066:                                             ; preds = %2040, %2066
  %2067 = phi i64 [ 0, %2040 ], [ %2075, %2066 ]
  %2068 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %2067
  %2069 = getelementptr inbounds i8, ptr %2068, i64 8
  %2070 = load double, ptr %2069, align 8
  %2071 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %2067
  store double %2070, ptr %2071, align 8
  %2072 = getelementptr inbounds i8, ptr %2068, i64 16
  %2073 = load double, ptr %2072, align 8
  %2074 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %2067
  store double %2073, ptr %2074, align 8
  %2075 = add nuw nsw i64 %2067, 1
  %2076 = icmp eq i64 %2075, 3
  br i1 %2076, label %2051, label %2066, !llvm.loop !54

2077:                                             ; preds = %2053, %2114
  %2078 = phi i64 [ 0, %2053 ], [ %2115, %2114 ]
  %2079 = getelementptr inbounds double, ptr %2047, i64 %2078
  %2080 = load double, ptr %2079, align 8
  %2081 = fmul double %2054, %2080
  %2082 = getelementptr double, ptr %2056, i64 %2078
  %2083 = load double, ptr %2082, align 8
  %2084 = fmul double %2055, %2083
  %2085 = fadd double %2081, %2084
  %2086 = getelementptr double, ptr %2059, i64 %2078
  %2087 = load double, ptr %2086, align 8
  %2088 = fmul double %2057, %2087
  %2089 = fadd double %2085, %2088
  %2090 = fmul double %2080, %2060
  %2091 = fmul double %2083, %2061
  %2092 = fadd double %2090, %2091
  %2093 = fmul double %2087, %2062
  %2094 = fadd double %2092, %2093
  %2095 = load ptr, ptr %183, align 8
  %2096 = getelementptr inbounds double, ptr %2095, i64 %2078
  %2097 = load double, ptr %2096, align 8
  %2098 = load ptr, ptr %82, align 8
  %2099 = getelementptr inbounds double, ptr %2098, i64 %2078
  %2100 = load double, ptr %2099, align 8
  %2101 = fsub double %2097, %2100
  %2102 = getelementptr inbounds double, ptr %2048, i64 %2078
  store double %2101, ptr %2102, align 8
  %2103 = fneg double %2089
  %2104 = fsub double %2103, %2094
  %2105 = getelementptr inbounds double, ptr %2063, i64 %2078
  store double %2104, ptr %2105, align 8
  %2106 = fneg double %2094
  %2107 = getelementptr inbounds double, ptr %2065, i64 %2078
  store double %2106, ptr %2107, align 8
  %2108 = load ptr, ptr %82, align 8
  %2109 = getelementptr inbounds double, ptr %2108, i64 %2078
  %2110 = load double, ptr %2109, align 8
  %2111 = getelementptr inbounds double, ptr %2049, i64 %2078
  store double %2110, ptr %2111, align 8
  %2112 = getelementptr double, ptr %2048, i64 %2078
  %2113 = getelementptr double, ptr %2049, i64 %2078
  br label %2117

2114:                                             ; preds = %2117
  %2115 = add nuw nsw i64 %2078, 1
  %2116 = icmp eq i64 %2115, %2045
  br i1 %2116, label %2126, label %2077, !llvm.loop !55

2117:                                             ; preds = %2077, %2117
  %2118 = phi i64 [ 0, %2077 ], [ %2119, %2117 ]
  %2119 = add nuw nsw i64 %2118, 1
  %2120 = mul nuw nsw i64 %2045, %2119
  %2121 = mul nsw i64 %2046, %2118
  %2122 = getelementptr double, ptr %2112, i64 %2121
  %2123 = load double, ptr %2122, align 8
  %2124 = getelementptr double, ptr %2113, i64 %2120
  store double %2123, ptr %2124, align 8
  %2125 = icmp eq i64 %2119, 3
  br i1 %2125, label %2114, label %2117, !llvm.loop !56

2126:                                             ; preds = %2114, %2051
  %2127 = fcmp olt double %1990, 1.000000e-10
  %2128 = select i1 %2127, double 1.000000e-10, double %1990
  %2129 = getelementptr inbounds i8, ptr %2050, i64 8
  store double %533, ptr %2129, align 8
  %2130 = getelementptr inbounds i8, ptr %2050, i64 16
  store double %533, ptr %2130, align 8
  %2131 = getelementptr inbounds i8, ptr %2050, i64 24
  store double %2128, ptr %2131, align 8
  %2132 = load ptr, ptr %83, align 8
  %2133 = getelementptr inbounds i8, ptr %2132, i64 8
  %2134 = load i64, ptr %2133, align 8
  %2135 = and i64 %2134, -2
  %2136 = or disjoint i64 %2135, %1996
  store i64 %2136, ptr %2133, align 8
  %2137 = load ptr, ptr %83, align 8
  %2138 = getelementptr inbounds i8, ptr %2137, i64 16
  %2139 = load i64, ptr %2138, align 8
  %2140 = and i64 %2139, -2
  store i64 %2140, ptr %2138, align 8
  %2141 = load ptr, ptr %83, align 8
  %2142 = getelementptr inbounds i8, ptr %2141, i64 32
  %2143 = load i64, ptr %2142, align 8
  %2144 = and i64 %2143, -2
  store i64 %2144, ptr %2142, align 8
  %2145 = load ptr, ptr %0, align 8
  %2146 = getelementptr inbounds i8, ptr %2145, i64 24
  %2147 = load i64, ptr %2146, align 8
  %2148 = load ptr, ptr %101, align 8
  %2149 = getelementptr inbounds i8, ptr %2148, i64 8
  %2150 = load i64, ptr %2149, align 8
  %2151 = icmp eq i64 %2150, 0
  br i1 %2151, label %2198, label %2152

2152:                                             ; preds = %2126
  %2153 = load i64, ptr %2148, align 8
  %2154 = load ptr, ptr %81, align 8
  %2155 = getelementptr inbounds i8, ptr %2154, i64 8
  %2156 = load i64, ptr %2155, align 8
  %2157 = load ptr, ptr %184, align 8
  %2158 = load i64, ptr %185, align 8
  %2159 = mul nsw i64 %2158, %2153
  %2160 = getelementptr inbounds double, ptr %2157, i64 %2159
  %2161 = getelementptr inbounds double, ptr %2160, i64 %2158
  store double %456, ptr %2160, align 8
  %2162 = getelementptr inbounds i8, ptr %2160, i64 8
  store double %533, ptr %2162, align 8
  store double %532, ptr %2161, align 8
  %2163 = getelementptr inbounds i8, ptr %2161, i64 8
  store double 0.000000e+00, ptr %2163, align 8
  %2164 = icmp sgt i64 %2156, 0
  br i1 %2164, label %2165, label %2168

2165:                                             ; preds = %2152
  %2166 = getelementptr i8, ptr %2160, i64 16
  %2167 = icmp sgt i64 %2147, 0
  br label %2171

2168:                                             ; preds = %2183, %2152
  %2169 = add nsw i64 %2153, 1
  %2170 = load ptr, ptr %101, align 8
  store i64 %2169, ptr %2170, align 8
  br label %2198

2171:                                             ; preds = %2165, %2183
  %2172 = phi i64 [ 0, %2165 ], [ %2184, %2183 ]
  %2173 = load ptr, ptr %82, align 8
  %2174 = getelementptr inbounds double, ptr %2173, i64 %2172
  %2175 = load double, ptr %2174, align 8
  %2176 = add nuw nsw i64 %2172, 2
  %2177 = getelementptr inbounds double, ptr %2160, i64 %2176
  store double %2175, ptr %2177, align 8
  %2178 = load ptr, ptr %186, align 8
  %2179 = getelementptr inbounds double, ptr %2178, i64 %2172
  %2180 = load double, ptr %2179, align 8
  %2181 = getelementptr inbounds double, ptr %2161, i64 %2176
  store double %2180, ptr %2181, align 8
  %2182 = getelementptr double, ptr %2166, i64 %2172
  br i1 %2167, label %2186, label %2183

2183:                                             ; preds = %2186, %2171
  %2184 = add nuw nsw i64 %2172, 1
  %2185 = icmp eq i64 %2184, %2156
  br i1 %2185, label %2168, label %2171, !llvm.loop !57

2186:                                             ; preds = %2171, %2186
  %2187 = phi i64 [ %2194, %2186 ], [ 0, %2171 ]
  %2188 = load ptr, ptr %187, align 8
  %2189 = load i64, ptr %188, align 8
  %2190 = mul nsw i64 %2189, %2187
  %2191 = getelementptr double, ptr %2188, i64 %2190
  %2192 = getelementptr double, ptr %2191, i64 %2172
  %2193 = load double, ptr %2192, align 8
  %2194 = add nuw nsw i64 %2187, 1
  %2195 = mul nuw nsw i64 %2194, %2156
  %2196 = getelementptr double, ptr %2182, i64 %2195
  store double %2193, ptr %2196, align 8
  %2197 = icmp eq i64 %2194, %2147
  br i1 %2197, label %2183, label %2186, !llvm.loop !58

2198:                                             ; preds = %2126, %2168
  br i1 %258, label %2199, label %2307

2199:                                             ; preds = %2198
  %2200 = load ptr, ptr %90, align 8
  %2201 = load ptr, ptr %81, align 8
  %2202 = getelementptr inbounds i8, ptr %2201, i64 8
  %2203 = load i64, ptr %2202, align 8
  %2204 = load ptr, ptr %189, align 8
  %2205 = getelementptr inbounds i8, ptr %2200, i64 32
  %2206 = load i64, ptr %2205, align 8
  %2207 = getelementptr inbounds double, ptr %2204, i64 %2206
  %2208 = load ptr, ptr %190, align 8
  %2209 = getelementptr inbounds i8, ptr %2200, i64 24
  %2210 = load i64, ptr %2209, align 8
  %2211 = icmp eq i64 %2210, 0
  br i1 %2211, label %2304, label %2212

2212:                                             ; preds = %2199
  %2213 = getelementptr inbounds i8, ptr %2200, i64 40
  %2214 = load i64, ptr %2213, align 8
  %2215 = icmp sgt i64 %2214, 0
  br i1 %2215, label %2216, label %2220

2216:                                             ; preds = %2212
  %2217 = getelementptr double, ptr %2208, i64 %2203
  %2218 = shl i64 %2203, 4
  %2219 = getelementptr i8, ptr %2208, i64 %2218
  br label %2274

2220:                                             ; preds = %2274, %2212
  %2221 = load ptr, ptr %192, align 8
  %2222 = load ptr, ptr %90, align 8
  %2223 = getelementptr inbounds i8, ptr %2222, i64 8
  %2224 = load i64, ptr %2223, align 8
  %2225 = load ptr, ptr %193, align 8
  %2226 = load ptr, ptr %189, align 8
  %2227 = getelementptr inbounds i8, ptr %2222, i64 32
  %2228 = load i64, ptr %2227, align 8
  %2229 = getelementptr inbounds i8, ptr %2222, i64 40
  %2230 = load i64, ptr %2229, align 8
  %2231 = getelementptr double, ptr %2226, i64 %2228
  %2232 = getelementptr double, ptr %2231, i64 %2230
  store double %533, ptr %2232, align 8
  %2233 = load ptr, ptr %192, align 8
  store double %456, ptr %2233, align 8
  %2234 = load ptr, ptr %90, align 8
  %2235 = getelementptr inbounds i8, ptr %2234, i64 24
  %2236 = load i64, ptr %2235, align 8
  %2237 = load ptr, ptr %82, align 8
  %2238 = load ptr, ptr %189, align 8
  %2239 = load ptr, ptr %194, align 8
  %2240 = inttoptr i64 %2236 to ptr
  %2241 = load ptr, ptr %2240, align 8
  %2242 = tail call i32 %2241(ptr noundef %2221, ptr noundef %2237, ptr noundef %2238, ptr noundef %2239, ptr noundef %2225) #10
  %2243 = icmp eq i32 %2242, 0
  br i1 %2243, label %2244, label %2304

2244:                                             ; preds = %2220
  %2245 = icmp slt i64 %2224, 1
  br i1 %2245, label %2271, label %2246

2246:                                             ; preds = %2244
  %2247 = load ptr, ptr %195, align 8
  %2248 = getelementptr double, ptr %2225, i64 %2224
  br label %2249

2249:                                             ; preds = %2246, %2267
  %2250 = phi i1 [ %2245, %2246 ], [ %2269, %2267 ]
  %2251 = phi i64 [ 0, %2246 ], [ %2268, %2267 ]
  %2252 = getelementptr inbounds i64, ptr %2247, i64 %2251
  %2253 = load i64, ptr %2252, align 8
  %2254 = and i64 %2253, 2
  %2255 = icmp eq i64 %2254, 0
  br i1 %2255, label %2256, label %2267

2256:                                             ; preds = %2249
  %2257 = getelementptr inbounds double, ptr %2225, i64 %2251
  %2258 = load double, ptr %2257, align 8
  %2259 = load ptr, ptr %196, align 8
  %2260 = getelementptr inbounds i64, ptr %2259, i64 %2251
  %2261 = load i64, ptr %2260, align 8
  %2262 = sitofp i64 %2261 to double
  %2263 = fmul double %2258, %2262
  %2264 = getelementptr double, ptr %2248, i64 %2251
  %2265 = load double, ptr %2264, align 8
  %2266 = fcmp ogt double %2263, %2265
  br i1 %2266, label %2267, label %2271

2267:                                             ; preds = %2256, %2249
  %2268 = add nuw nsw i64 %2251, 1
  %2269 = icmp sge i64 %2268, %2224
  %2270 = icmp eq i64 %2268, %2224
  br i1 %2270, label %2271, label %2249, !llvm.loop !59

2271:                                             ; preds = %2267, %2256, %2244
  %2272 = phi i1 [ %2245, %2244 ], [ %2269, %2267 ], [ %2250, %2256 ]
  %2273 = zext i1 %2272 to i32
  br label %2304

2274:                                             ; preds = %2216, %2274
  %2275 = phi i64 [ 0, %2216 ], [ %2301, %2274 ]
  %2276 = load ptr, ptr %191, align 8
  %2277 = getelementptr inbounds double, ptr %2276, i64 %2275
  %2278 = load double, ptr %2277, align 8
  %2279 = load ptr, ptr %82, align 8
  %2280 = getelementptr inbounds double, ptr %2279, i64 %2275
  %2281 = load double, ptr %2280, align 8
  %2282 = fsub double %2278, %2281
  %2283 = tail call double @llvm.fabs.f64(double %2282)
  %2284 = getelementptr inbounds double, ptr %2208, i64 %2275
  %2285 = load double, ptr %2284, align 8
  %2286 = tail call double @llvm.fabs.f64(double %2285)
  %2287 = getelementptr double, ptr %2217, i64 %2275
  %2288 = load double, ptr %2287, align 8
  %2289 = tail call double @llvm.fabs.f64(double %2288)
  %2290 = fcmp ogt double %2286, %2289
  %2291 = select i1 %2290, double %2286, double %2289
  %2292 = getelementptr double, ptr %2219, i64 %2275
  %2293 = load double, ptr %2292, align 8
  %2294 = tail call double @llvm.fabs.f64(double %2293)
  %2295 = fcmp ogt double %2291, %2294
  %2296 = select i1 %2295, double %2291, double %2294
  %2297 = fcmp ogt double %2296, %2283
  %2298 = select i1 %2297, double %2296, double %2283
  %2299 = fmul double %2298, 8.000000e+00
  %2300 = getelementptr inbounds double, ptr %2207, i64 %2275
  store double %2299, ptr %2300, align 8
  %2301 = add nuw nsw i64 %2275, 1
  %2302 = load i64, ptr %2213, align 8
  %2303 = icmp slt i64 %2301, %2302
  br i1 %2303, label %2274, label %2220, !llvm.loop !60

2304:                                             ; preds = %2271, %2220, %2199
  %2305 = phi i32 [ 0, %2199 ], [ 0, %2220 ], [ %2273, %2271 ]
  %2306 = icmp eq i32 %2305, 0
  br label %2307

2307:                                             ; preds = %2304, %2198
  %2308 = phi i1 [ false, %2198 ], [ %2306, %2304 ]
  br i1 %2308, label %2314, label %2309

2309:                                             ; preds = %2307
  %2310 = load i64, ptr %439, align 8
  %2311 = getelementptr inbounds double, ptr %230, i64 %2310
  %2312 = load double, ptr %2311, align 8
  %2313 = fcmp ugt double %2312, %532
  br i1 %2313, label %2539, label %2314

2314:                                             ; preds = %2309, %2307
  %2315 = load ptr, ptr %84, align 8
  br i1 %2308, label %2316, label %2327

2316:                                             ; preds = %2314
  %2317 = load ptr, ptr %90, align 8
  %2318 = getelementptr inbounds i8, ptr %2317, i64 16
  %2319 = load i64, ptr %2318, align 8
  %2320 = inttoptr i64 %2319 to ptr
  %2321 = tail call i64 %2320(ptr noundef %0, double noundef %456, double noundef %533) #10
  %2322 = icmp eq i64 %2321, -6
  br i1 %2322, label %2323, label %2324

2323:                                             ; preds = %2316
  store double %456, ptr %2315, align 8
  br label %2502

2324:                                             ; preds = %2316
  %2325 = getelementptr inbounds i8, ptr %2315, i64 48
  %2326 = load double, ptr %2325, align 8
  br label %2327

2327:                                             ; preds = %2324, %2314
  %2328 = phi double [ %2326, %2324 ], [ 1.000000e+00, %2314 ]
  %2329 = phi i64 [ %2321, %2324 ], [ 0, %2314 ]
  %2330 = fcmp oeq double %2328, 1.000000e+00
  br i1 %2330, label %2331, label %2333

2331:                                             ; preds = %2327
  %2332 = load double, ptr %2315, align 8
  br label %2336

2333:                                             ; preds = %2327
  %2334 = fmul double %533, %2328
  %2335 = fadd double %456, %2334
  br label %2336

2336:                                             ; preds = %2333, %2331
  %2337 = phi double [ %2332, %2331 ], [ %2335, %2333 ]
  %2338 = icmp eq i64 %2329, -4
  %2339 = select i1 %2338, i64 -4, i64 0
  br i1 %2338, label %2397, label %2340

2340:                                             ; preds = %2336
  %2341 = fcmp olt double %2328, 1.000000e+00
  %2342 = load ptr, ptr %81, align 8
  %2343 = getelementptr inbounds i8, ptr %2342, i64 8
  %2344 = load i64, ptr %2343, align 8
  %2345 = load i64, ptr %87, align 8
  %2346 = load ptr, ptr %86, align 8
  %2347 = load ptr, ptr %85, align 8
  %2348 = getelementptr inbounds i8, ptr %2347, i64 48
  %2349 = load i64, ptr %2348, align 8
  %2350 = icmp slt i64 %2349, %2345
  br i1 %2350, label %2351, label %2393

2351:                                             ; preds = %2340, %2389
  %2352 = phi i64 [ %2390, %2389 ], [ undef, %2340 ]
  %2353 = phi i64 [ %2391, %2389 ], [ %2349, %2340 ]
  %2354 = getelementptr inbounds double, ptr %2346, i64 %2353
  %2355 = load double, ptr %2354, align 8
  %2356 = fcmp olt double %2355, %2337
  %2357 = fcmp oeq double %2355, %2337
  %2358 = and i1 %2341, %2357
  %2359 = or i1 %2356, %2358
  br i1 %2359, label %2360, label %2393

2360:                                             ; preds = %2351
  %2361 = fsub double %2355, %456
  %2362 = fdiv double %2361, %533
  %2363 = mul nsw i64 %2353, %2344
  %2364 = getelementptr inbounds double, ptr %1, i64 %2363
  %2365 = load ptr, ptr %197, align 8
  %2366 = insertelement <8 x double> poison, double %2362, i64 0
  %2367 = shufflevector <8 x double> %2366, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2367, ptr %2365, align 8
  %2368 = load ptr, ptr %82, align 8
  %2369 = load ptr, ptr %176, align 8
  %2370 = load i64, ptr %174, align 8
  %2371 = load ptr, ptr %0, align 8
  %2372 = getelementptr inbounds i8, ptr %2371, i64 24
  %2373 = load i64, ptr %2372, align 8
  %2374 = load ptr, ptr %197, align 8
  %2375 = load ptr, ptr %81, align 8
  %2376 = getelementptr inbounds i8, ptr %2375, i64 16
  %2377 = load i64, ptr %2376, align 8
  tail call fastcc void @nested(ptr noundef %2364, ptr noundef %2368, ptr noundef %2369, i64 noundef %2370, i64 noundef %2373, ptr noundef %2374, i64 noundef %2377) #9
  %2378 = load ptr, ptr %89, align 8
  %2379 = load i64, ptr %2378, align 8
  %2380 = icmp eq i64 %2379, 1
  br i1 %2380, label %2381, label %2389

2381:                                             ; preds = %2360
  %2382 = load double, ptr %2354, align 8
  %2383 = getelementptr inbounds i8, ptr %2378, i64 56
  %2384 = load i64, ptr %2383, align 8
  %2385 = inttoptr i64 %2384 to ptr
  %2386 = tail call i64 %2385(ptr noundef %0, double noundef %2382, ptr noundef %2364, ptr noundef null) #10
  %2387 = icmp eq i64 %2386, 0
  %2388 = select i1 %2387, i64 %2352, i64 %2386
  br i1 %2387, label %2389, label %2397

2389:                                             ; preds = %2381, %2360
  %2390 = phi i64 [ %2388, %2381 ], [ %2352, %2360 ]
  %2391 = add i64 %2353, 1
  %2392 = icmp eq i64 %2391, %2345
  br i1 %2392, label %2393, label %2351, !llvm.loop !61

2393:                                             ; preds = %2389, %2351, %2340
  %2394 = phi i64 [ %2349, %2340 ], [ %2345, %2389 ], [ %2353, %2351 ]
  %2395 = load ptr, ptr %85, align 8
  %2396 = getelementptr inbounds i8, ptr %2395, i64 48
  store i64 %2394, ptr %2396, align 8
  br label %2397

2397:                                             ; preds = %2381, %2393, %2336
  %2398 = phi i64 [ %2339, %2336 ], [ 0, %2393 ], [ %2388, %2381 ]
  %2399 = icmp eq i64 %2398, 0
  %2400 = icmp ne i64 %2329, 0
  %2401 = fcmp olt double %2328, 1.000000e+00
  %2402 = and i1 %2401, %2399
  %2403 = and i1 %2400, %2402
  br i1 %2403, label %2404, label %2441

2404:                                             ; preds = %2397
  %2405 = load ptr, ptr %198, align 8
  %2406 = load ptr, ptr %199, align 8
  %2407 = insertelement <8 x double> poison, double %2328, i64 0
  %2408 = shufflevector <8 x double> %2407, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2408, ptr %2406, align 8
  %2409 = load ptr, ptr %82, align 8
  %2410 = load ptr, ptr %176, align 8
  %2411 = load i64, ptr %174, align 8
  %2412 = load ptr, ptr %0, align 8
  %2413 = getelementptr inbounds i8, ptr %2412, i64 24
  %2414 = load i64, ptr %2413, align 8
  %2415 = load ptr, ptr %199, align 8
  %2416 = load ptr, ptr %81, align 8
  %2417 = getelementptr inbounds i8, ptr %2416, i64 16
  %2418 = load i64, ptr %2417, align 8
  tail call fastcc void @nested(ptr noundef %2405, ptr noundef %2409, ptr noundef %2410, i64 noundef %2411, i64 noundef %2414, ptr noundef %2415, i64 noundef %2418) #9
  %2419 = load i64, ptr %200, align 8
  %2420 = icmp sgt i64 %2419, 0
  br i1 %2420, label %2425, label %2421

2421:                                             ; preds = %2425, %2404
  %2422 = load ptr, ptr %89, align 8
  %2423 = load i64, ptr %2422, align 8
  %2424 = icmp eq i64 %2423, 1
  br i1 %2424, label %2435, label %2441

2425:                                             ; preds = %2404, %2425
  %2426 = phi i64 [ %2432, %2425 ], [ 0, %2404 ]
  %2427 = load ptr, ptr %198, align 8
  %2428 = getelementptr inbounds double, ptr %2427, i64 %2426
  %2429 = load double, ptr %2428, align 8
  %2430 = load ptr, ptr %201, align 8
  %2431 = getelementptr inbounds double, ptr %2430, i64 %2426
  store double %2429, ptr %2431, align 8
  %2432 = add nuw nsw i64 %2426, 1
  %2433 = load i64, ptr %200, align 8
  %2434 = icmp slt i64 %2432, %2433
  br i1 %2434, label %2425, label %2421, !llvm.loop !62

2435:                                             ; preds = %2421
  %2436 = load ptr, ptr %202, align 8
  %2437 = getelementptr inbounds i8, ptr %2422, i64 56
  %2438 = load i64, ptr %2437, align 8
  %2439 = inttoptr i64 %2438 to ptr
  %2440 = tail call i64 %2439(ptr noundef %0, double noundef %2337, ptr noundef %2436, ptr noundef null) #10
  br label %2441

2441:                                             ; preds = %2435, %2421, %2397
  %2442 = phi i64 [ %2440, %2435 ], [ 0, %2421 ], [ %2398, %2397 ]
  %2443 = icmp eq i64 %2442, 0
  br i1 %2443, label %2446, label %2444

2444:                                             ; preds = %2441
  store double %456, ptr %2315, align 8
  %2445 = getelementptr inbounds i8, ptr %2315, i64 8
  store double %533, ptr %2445, align 8
  br label %2502

2446:                                             ; preds = %2441
  br i1 %2330, label %2447, label %2485

2447:                                             ; preds = %2446
  %2448 = load ptr, ptr %203, align 8
  %2449 = load ptr, ptr %81, align 8
  %2450 = getelementptr inbounds i8, ptr %2449, i64 8
  %2451 = load i64, ptr %2450, align 8
  %2452 = load i64, ptr %87, align 8
  %2453 = load ptr, ptr %86, align 8
  %2454 = load ptr, ptr %85, align 8
  %2455 = getelementptr inbounds i8, ptr %2454, i64 48
  %2456 = load i64, ptr %2455, align 8
  %2457 = icmp slt i64 %2456, %2452
  br i1 %2457, label %2458, label %2481

2458:                                             ; preds = %2447
  %2459 = icmp sgt i64 %2451, 0
  br label %2460

2460:                                             ; preds = %2458, %2471
  %2461 = phi i64 [ %2456, %2458 ], [ %2472, %2471 ]
  %2462 = getelementptr inbounds double, ptr %2453, i64 %2461
  %2463 = load double, ptr %2462, align 8
  %2464 = load ptr, ptr %84, align 8
  %2465 = load double, ptr %2464, align 8
  %2466 = fcmp ugt double %2463, %2465
  br i1 %2466, label %2481, label %2467

2467:                                             ; preds = %2460
  br i1 %2459, label %2468, label %2471

2468:                                             ; preds = %2467
  %2469 = mul nsw i64 %2461, %2451
  %2470 = getelementptr double, ptr %1, i64 %2469
  br label %2474

2471:                                             ; preds = %2474, %2467
  %2472 = add i64 %2461, 1
  %2473 = icmp eq i64 %2472, %2452
  br i1 %2473, label %2481, label %2460, !llvm.loop !13

2474:                                             ; preds = %2468, %2474
  %2475 = phi i64 [ 0, %2468 ], [ %2479, %2474 ]
  %2476 = getelementptr inbounds double, ptr %2448, i64 %2475
  %2477 = load double, ptr %2476, align 8
  %2478 = getelementptr double, ptr %2470, i64 %2475
  store double %2477, ptr %2478, align 8
  %2479 = add nuw nsw i64 %2475, 1
  %2480 = icmp eq i64 %2479, %2451
  br i1 %2480, label %2471, label %2474, !llvm.loop !14

2481:                                             ; preds = %2471, %2460, %2447
  %2482 = phi i64 [ %2456, %2447 ], [ %2452, %2471 ], [ %2461, %2460 ]
  %2483 = load ptr, ptr %85, align 8
  %2484 = getelementptr inbounds i8, ptr %2483, i64 48
  store i64 %2482, ptr %2484, align 8
  br label %2485

2485:                                             ; preds = %2481, %2446
  br i1 %2400, label %2486, label %2502

2486:                                             ; preds = %2485
  %2487 = load i64, ptr %204, align 8
  %2488 = icmp sgt i64 %2487, 0
  br i1 %2488, label %2492, label %2489

2489:                                             ; preds = %2492, %2486
  store double %2337, ptr %2315, align 8
  %2490 = getelementptr inbounds i8, ptr %2315, i64 8
  store double 0.000000e+00, ptr %2490, align 8
  %2491 = load ptr, ptr %85, align 8
  store i64 0, ptr %2491, align 8
  br label %2502

2492:                                             ; preds = %2486, %2492
  %2493 = phi i64 [ %2499, %2492 ], [ 0, %2486 ]
  %2494 = load ptr, ptr %205, align 8
  %2495 = getelementptr inbounds double, ptr %2494, i64 %2493
  %2496 = load double, ptr %2495, align 8
  %2497 = load ptr, ptr %82, align 8
  %2498 = getelementptr inbounds double, ptr %2497, i64 %2493
  store double %2496, ptr %2498, align 8
  %2499 = add nuw nsw i64 %2493, 1
  %2500 = load i64, ptr %204, align 8
  %2501 = icmp slt i64 %2499, %2500
  br i1 %2501, label %2492, label %2489, !llvm.loop !63

2502:                                             ; preds = %2323, %2444, %2485, %2489
  %2503 = phi i64 [ -6, %2323 ], [ %2442, %2444 ], [ %2329, %2489 ], [ %2329, %2485 ]
  %2504 = icmp eq i64 %2503, -6
  br i1 %2504, label %2508, label %2505

2505:                                             ; preds = %2502
  %2506 = icmp ne i64 %2503, 6
  %2507 = select i1 %2506, i1 true, i1 %258
  br i1 %2507, label %2533, label %2508

2508:                                             ; preds = %2505, %2502
  %2509 = phi i64 [ %2503, %2505 ], [ 2, %2502 ]
  %2510 = load i64, ptr %420, align 8
  %2511 = add nsw i64 %2510, -1
  store i64 %2511, ptr %420, align 8
  %2512 = load ptr, ptr %101, align 8
  %2513 = load i64, ptr %2512, align 8
  %2514 = add nsw i64 %2513, -1
  store i64 %2514, ptr %2512, align 8
  %2515 = load ptr, ptr %83, align 8
  %2516 = getelementptr inbounds i8, ptr %2515, i64 32
  %2517 = load i64, ptr %2516, align 8
  %2518 = or i64 %2517, 1
  store i64 %2518, ptr %2516, align 8
  %2519 = load ptr, ptr %83, align 8
  %2520 = getelementptr inbounds i8, ptr %2519, i64 8
  %2521 = load i64, ptr %2520, align 8
  %2522 = and i64 %2521, -2
  %2523 = getelementptr inbounds i8, ptr %2519, i64 16
  %2524 = load i64, ptr %2523, align 8
  %2525 = and i64 %2524, 1
  %2526 = or disjoint i64 %2525, %2522
  %2527 = xor i64 %2526, 1
  store i64 %2527, ptr %2520, align 8
  %2528 = load ptr, ptr %178, align 8
  %2529 = getelementptr inbounds i8, ptr %2528, i64 8
  store double 0.000000e+00, ptr %2529, align 8
  %2530 = load i64, ptr %421, align 8
  %2531 = add nsw i64 %2530, 1
  store i64 %2531, ptr %421, align 8
  store i64 %2509, ptr %443, align 8
  %2532 = fmul double %533, 2.500000e-01
  br label %2591, !llvm.loop !53

2533:                                             ; preds = %2505
  %2534 = icmp eq i64 %2503, 0
  br i1 %2534, label %2539, label %2535

2535:                                             ; preds = %2533
  %2536 = load ptr, ptr %101, align 8
  %2537 = load i64, ptr %2536, align 8
  %2538 = add nsw i64 %2537, 1
  store i64 %2538, ptr %2536, align 8
  br label %2591

2539:                                             ; preds = %2533, %2309
  br i1 %440, label %2570, label %2540

2540:                                             ; preds = %2570, %2539
  %2541 = load i64, ptr %102, align 8
  %2542 = icmp sgt i64 %2541, 0
  br i1 %2542, label %2543, label %2545

2543:                                             ; preds = %2540
  %2544 = load ptr, ptr %207, align 8
  store double 0x7FF0000000000000, ptr %2544, align 8
  br label %2545

2545:                                             ; preds = %2540, %2543
  %2546 = load i64, ptr %434, align 8
  %2547 = add nsw i64 %2546, 1
  store i64 %2547, ptr %434, align 8
  %2548 = load ptr, ptr %82, align 8
  %2549 = load ptr, ptr %208, align 8
  %2550 = load ptr, ptr %209, align 8
  store double %532, ptr %2550, align 8
  %2551 = load ptr, ptr %81, align 8
  %2552 = getelementptr inbounds i8, ptr %2551, i64 40
  %2553 = load i64, ptr %2552, align 8
  %2554 = icmp eq i64 %2553, 0
  br i1 %2554, label %2556, label %2555

2555:                                             ; preds = %2545
  tail call fastcc void @settle(ptr noundef nonnull %81) #9
  br label %2556

2556:                                             ; preds = %2555, %2545
  %2557 = load i64, ptr %210, align 8
  %2558 = icmp sgt i64 %2557, 0
  br i1 %2558, label %2559, label %2560

2559:                                             ; preds = %2556
  tail call fastcc void @sample(ptr noundef nonnull %81) #9
  br label %2560

2560:                                             ; preds = %2556, %2559
  %2561 = load ptr, ptr %81, align 8
  %2562 = load i64, ptr %2561, align 8
  %2563 = load ptr, ptr %209, align 8
  %2564 = load ptr, ptr %211, align 8
  %2565 = load ptr, ptr %212, align 8
  %2566 = inttoptr i64 %2562 to ptr
  %2567 = load ptr, ptr %2566, align 8
  %2568 = tail call i32 %2567(ptr noundef %2563, ptr noundef %2548, ptr noundef %2564, ptr noundef %2565, ptr noundef %2549) #10
  %2569 = icmp eq i32 %2568, 0
  br i1 %2569, label %2582, label %2579

2570:                                             ; preds = %2539, %2570
  %2571 = phi i64 [ %2577, %2570 ], [ 0, %2539 ]
  %2572 = load ptr, ptr %206, align 8
  %2573 = getelementptr inbounds double, ptr %2572, i64 %2571
  %2574 = load double, ptr %2573, align 8
  %2575 = load ptr, ptr %82, align 8
  %2576 = getelementptr inbounds double, ptr %2575, i64 %2571
  store double %2574, ptr %2576, align 8
  %2577 = add nuw nsw i64 %2571, 1
  %2578 = icmp eq i64 %2577, %229
  br i1 %2578, label %2540, label %2570, !llvm.loop !64

2579:                                             ; preds = %2560
  store i64 3, ptr %441, align 8
  store double %533, ptr %260, align 8
  %2580 = icmp slt i32 %2568, 0
  %2581 = select i1 %2580, i64 -4, i64 2
  br label %2591

2582:                                             ; preds = %2560
  %2583 = fcmp oeq double %532, %522
  %2584 = fcmp ogt double %457, %1991
  %2585 = select i1 %2583, i1 %2584, i1 false
  %2586 = select i1 %2585, double %457, double %1991
  %2587 = load i64, ptr %442, align 8
  %2588 = load i64, ptr %87, align 8
  %2589 = icmp eq i64 %2587, %2588
  br i1 %2589, label %2590, label %2591

2590:                                             ; preds = %2582
  store double %2586, ptr %260, align 8
  br label %2591

2591:                                             ; preds = %1981, %2007, %2021, %2508, %2535, %2579, %2582, %2590, %539
  %2592 = phi double [ %463, %539 ], [ %1982, %2590 ], [ %1982, %2582 ], [ %1982, %2579 ], [ %1982, %2535 ], [ %1982, %2508 ], [ %1982, %2021 ], [ %1982, %2007 ], [ %1982, %1981 ]
  %2593 = phi double [ %462, %539 ], [ %1983, %2590 ], [ %1983, %2582 ], [ %1983, %2579 ], [ %1983, %2535 ], [ %1983, %2508 ], [ %1983, %2021 ], [ %1983, %2007 ], [ %1983, %1981 ]
  %2594 = phi double [ %461, %539 ], [ %1984, %2590 ], [ %1984, %2582 ], [ %1984, %2579 ], [ %1984, %2535 ], [ %1984, %2508 ], [ %1984, %2021 ], [ %1984, %2007 ], [ %1984, %1981 ]
  %2595 = phi i64 [ %460, %539 ], [ %1985, %2590 ], [ %1985, %2582 ], [ %1985, %2579 ], [ %1985, %2535 ], [ %1985, %2508 ], [ %1985, %2021 ], [ %1985, %2007 ], [ %1985, %1981 ]
  %2596 = phi i64 [ %459, %539 ], [ %1986, %2590 ], [ %1986, %2582 ], [ %1986, %2579 ], [ %1986, %2535 ], [ %1986, %2508 ], [ %1986, %2021 ], [ %1986, %2007 ], [ %1986, %1981 ]
  %2597 = phi i64 [ %458, %539 ], [ %1987, %2590 ], [ %1987, %2582 ], [ %1987, %2579 ], [ %1987, %2535 ], [ %1987, %2508 ], [ %1987, %2021 ], [ %1987, %2007 ], [ %1987, %1981 ]
  %2598 = phi double [ %457, %539 ], [ %2586, %2590 ], [ %2586, %2582 ], [ %1991, %2579 ], [ %1991, %2535 ], [ %2532, %2508 ], [ %2024, %2021 ], [ %1991, %2007 ], [ %457, %1981 ]
  %2599 = phi double [ %456, %539 ], [ %532, %2590 ], [ %532, %2582 ], [ %532, %2579 ], [ %456, %2535 ], [ %456, %2508 ], [ %456, %2021 ], [ %456, %2007 ], [ %456, %1981 ]
  %2600 = phi i32 [ 1, %539 ], [ 1, %2590 ], [ 0, %2582 ], [ 1, %2579 ], [ 1, %2535 ], [ 3, %2508 ], [ 3, %2021 ], [ 3, %2007 ], [ 1, %1981 ]
  %2601 = phi i64 [ 2, %539 ], [ 0, %2590 ], [ %455, %2582 ], [ %2581, %2579 ], [ %2503, %2535 ], [ %455, %2508 ], [ %455, %2021 ], [ %455, %2007 ], [ -4, %1981 ]
  switch i32 %2600, label %2605 [
    i32 0, label %2602
    i32 3, label %2602
  ]

2602:                                             ; preds = %2591, %2591
  %2603 = load i64, ptr %223, align 8
  %2604 = icmp eq i64 %2603, 0
  br i1 %2604, label %445, label %453, !llvm.loop !53

2605:                                             ; preds = %2591, %322, %381, %445, %476, %484, %214
  %2606 = phi double [ %215, %214 ], [ %446, %445 ], [ %463, %484 ], [ %463, %476 ], [ %215, %381 ], [ %215, %322 ], [ %2592, %2591 ]
  %2607 = phi double [ %216, %214 ], [ %447, %445 ], [ %462, %484 ], [ %462, %476 ], [ %216, %381 ], [ %216, %322 ], [ %2593, %2591 ]
  %2608 = phi double [ %217, %214 ], [ %448, %445 ], [ %461, %484 ], [ %461, %476 ], [ %217, %381 ], [ %217, %322 ], [ %2594, %2591 ]
  %2609 = phi i64 [ %218, %214 ], [ %449, %445 ], [ %460, %484 ], [ %460, %476 ], [ %218, %381 ], [ %218, %322 ], [ %2595, %2591 ]
  %2610 = phi i64 [ %219, %214 ], [ %450, %445 ], [ %459, %484 ], [ %459, %476 ], [ %219, %381 ], [ %219, %322 ], [ %2596, %2591 ]
  %2611 = phi i64 [ %220, %214 ], [ %451, %445 ], [ %458, %484 ], [ %458, %476 ], [ %220, %381 ], [ %220, %322 ], [ %2597, %2591 ]
  %2612 = phi i64 [ -1, %214 ], [ -1, %445 ], [ 1, %484 ], [ -5, %476 ], [ 0, %381 ], [ %325, %322 ], [ %2601, %2591 ]
  %2613 = load ptr, ptr %213, align 8
  %2614 = getelementptr inbounds i8, ptr %2613, i64 48
  %2615 = load i64, ptr %2614, align 8
  %2616 = icmp ne i64 %2612, -2
  %2617 = icmp eq i64 %2615, 0
  %2618 = select i1 %2616, i1 true, i1 %2617
  br i1 %2618, label %2626, label %2619

2619:                                             ; preds = %2605
  %2620 = inttoptr i64 %2615 to ptr
  %2621 = tail call i64 %2620(ptr noundef %0) #10
  %2622 = icmp eq i64 %2621, 8
  %2623 = select i1 %2622, i64 8, i64 %2612
  %2624 = icmp eq i64 %2621, 1
  %2625 = zext i1 %2624 to i32
  br label %2626

2626:                                             ; preds = %2605, %2619
  %2627 = phi i64 [ %2612, %2605 ], [ %2623, %2619 ]
  %2628 = phi i32 [ 0, %2605 ], [ %2625, %2619 ]
  %2629 = icmp eq i32 %2628, 0
  br i1 %2629, label %2630, label %214, !llvm.loop !65

2630:                                             ; preds = %2626
  %2631 = getelementptr inbounds i8, ptr %0, i64 320
  %2632 = load i64, ptr %2631, align 8
  %2633 = icmp sgt i64 %2632, 0
  br i1 %2633, label %2634, label %2637

2634:                                             ; preds = %2630
  %2635 = getelementptr inbounds i8, ptr %0, i64 336
  %2636 = load ptr, ptr %2635, align 8
  store double 0x7FF0000000000000, ptr %2636, align 8
  br label %2637

2637:                                             ; preds = %2630, %2634
  ret i64 %2627
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

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #7 {
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
  br i1 %31, label %20, label %19, !llvm.loop !104

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
  br i1 %43, label %32, label %24, !llvm.loop !105
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #8

declare i64 @llvm.smin.i64(i64, i64) #8

declare i64 @llvm.umax.i64(i64, i64) #8

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn }
attributes #7 = { noinline nounwind }
attributes #8 = { nounwind willreturn memory(none) }
attributes #9 = { nounwind }
attributes #10 = { nounwind }
attributes #11 = { nounwind }


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
