; sources a696c3e560dfeaa710451b1159119a6edfecbcc8e652bf89f27531ba4bbf3146
; Made by tools/solvers_ir.py with ziglang 0.14.1.

@NODES = internal unnamed_addr constant [3 x double] [double 0x3FC3D8B64657CAEA, double 0x3FE4A36C0803A6DF, double 1.000000e+00], align 16
@TO_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x4010B70201A79C46, double 0x3FD4F8C15DA84E86, double 0x3FE0BF7FF59D56EF], [3 x double] [double 0xC010B70201A79C46, double 0xBFD4F8C15DA84E86, double 0x3FDE810014C55221], [3 x double] [double 0x3FE017885A24A7F2, double 0xC004934E6FCAA598, double 0x3FE312C0CF7BDFD1]], align 16
@FROM_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x3FB82D23845D677B, double 0xBFC214A74C403BF7, double 0x3F9EBFF91A6D688E], [3 x double] [double 0x3FD0037DE70AA1ED, double 0x3FCA20E91E20B551, double 0xBFD8821FA2A36DED], [3 x double] [double 1.000000e+00, double 1.000000e+00, double 0.000000e+00]], align 16
@POLYNOMIAL = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x402418FD8BAFFE05, double 0xC039A12CE7B30915, double 0x402F295C43B61425], [3 x double] [double 0xBFF61D41B2D54580, double 0x402497AF24BB677E, double 0xC021D406EE60BECF], [3 x double] [double 0x3FD5555555555555, double 0xC005555555555555, double 0x400AAAAAAAAAAAAB]], align 16

define i64 @advance_implicit(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [3 x double], align 16
  %5 = alloca [1 x double], align 8
  %6 = alloca [1 x double], align 8
  %7 = alloca [1 x double], align 8
  %8 = alloca [1 x double], align 8
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = icmp eq i64 %2, 1
  br i1 %11, label %12, label %76

12:                                               ; preds = %3
  %13 = getelementptr inbounds i8, ptr %0, i64 144
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %14, i64 8
  %16 = load i64, ptr %15, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %20

18:                                               ; preds = %12
  %19 = getelementptr inbounds i8, ptr %0, i64 360
  br label %27

20:                                               ; preds = %27, %12
  %21 = getelementptr inbounds i8, ptr %0, i64 632
  %22 = load i64, ptr %21, align 8
  %23 = icmp sgt i64 %22, 0
  br i1 %23, label %24, label %38

24:                                               ; preds = %20
  %25 = getelementptr inbounds i8, ptr %0, i64 624
  %26 = getelementptr inbounds i8, ptr %0, i64 1272
  br label %45

27:                                               ; preds = %18, %27
  %28 = phi i64 [ 0, %18 ], [ %33, %27 ]
  %29 = getelementptr inbounds double, ptr %1, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = load ptr, ptr %19, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %28
  store double %30, ptr %32, align 8
  %33 = add nuw nsw i64 %28, 1
  %34 = load ptr, ptr %13, align 8
  %35 = getelementptr inbounds i8, ptr %34, i64 8
  %36 = load i64, ptr %35, align 8
  %37 = icmp slt i64 %33, %36
  br i1 %37, label %27, label %20, !llvm.loop !3

38:                                               ; preds = %45, %20
  %39 = getelementptr inbounds i8, ptr %0, i64 656
  %40 = load i64, ptr %39, align 8
  %41 = icmp sgt i64 %40, 0
  br i1 %41, label %42, label %55

42:                                               ; preds = %38
  %43 = getelementptr inbounds i8, ptr %0, i64 648
  %44 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %61

45:                                               ; preds = %24, %45
  %46 = phi i64 [ 0, %24 ], [ %52, %45 ]
  %47 = load ptr, ptr %26, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %46
  %49 = load double, ptr %48, align 8
  %50 = load ptr, ptr %25, align 8
  %51 = getelementptr inbounds double, ptr %50, i64 %46
  store double %49, ptr %51, align 8
  %52 = add nuw nsw i64 %46, 1
  %53 = load i64, ptr %21, align 8
  %54 = icmp slt i64 %52, %53
  br i1 %54, label %45, label %38, !llvm.loop !6

55:                                               ; preds = %61, %38
  %56 = getelementptr inbounds i8, ptr %0, i64 768
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i8, ptr %57, i64 8
  %59 = load i64, ptr %58, align 8
  %60 = icmp sgt i64 %59, 0
  br i1 %60, label %71, label %76

61:                                               ; preds = %42, %61
  %62 = phi i64 [ 0, %42 ], [ %68, %61 ]
  %63 = load ptr, ptr %44, align 8
  %64 = getelementptr inbounds i64, ptr %63, i64 %62
  %65 = load i64, ptr %64, align 8
  %66 = load ptr, ptr %43, align 8
  %67 = getelementptr inbounds i64, ptr %66, i64 %62
  store i64 %65, ptr %67, align 8
  %68 = add nuw nsw i64 %62, 1
  %69 = load i64, ptr %39, align 8
  %70 = icmp slt i64 %68, %69
  br i1 %70, label %61, label %55, !llvm.loop !7

71:                                               ; preds = %55
  %72 = getelementptr inbounds i8, ptr %0, i64 984
  %73 = load ptr, ptr %72, align 8
  %74 = mul i64 %59, 88
  %75 = getelementptr inbounds i8, ptr %73, i64 %74
  store double 0x7FF8000000000000, ptr %75, align 8
  br label %76

76:                                               ; preds = %71, %55, %3
  %77 = getelementptr inbounds i8, ptr %0, i64 144
  %78 = getelementptr inbounds i8, ptr %0, i64 360
  %79 = getelementptr inbounds i8, ptr %0, i64 1368
  %80 = getelementptr inbounds i8, ptr %0, i64 576
  %81 = getelementptr inbounds i8, ptr %0, i64 624
  %82 = getelementptr inbounds i8, ptr %0, i64 648
  %83 = getelementptr inbounds i8, ptr %0, i64 672
  %84 = getelementptr inbounds i8, ptr %0, i64 680
  %85 = getelementptr inbounds i8, ptr %0, i64 696
  %86 = getelementptr inbounds i8, ptr %0, i64 768
  %87 = getelementptr inbounds i8, ptr %0, i64 320
  %88 = getelementptr inbounds i8, ptr %0, i64 312
  %89 = getelementptr inbounds i8, ptr %0, i64 336
  %90 = getelementptr inbounds i8, ptr %0, i64 528
  %91 = getelementptr inbounds i8, ptr %0, i64 168
  %92 = getelementptr inbounds i8, ptr %0, i64 248
  %93 = getelementptr inbounds i8, ptr %0, i64 192
  %94 = getelementptr inbounds i8, ptr %0, i64 216
  %95 = getelementptr inbounds i8, ptr %0, i64 1392
  %96 = getelementptr inbounds i8, ptr %0, i64 528
  %97 = getelementptr inbounds i8, ptr %0, i64 1320
  %98 = getelementptr inbounds i8, ptr %0, i64 320
  %99 = getelementptr inbounds i8, ptr %0, i64 312
  %100 = getelementptr inbounds i8, ptr %0, i64 336
  %101 = getelementptr inbounds i8, ptr %0, i64 1440
  %102 = getelementptr inbounds i8, ptr %0, i64 1464
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 248
  %105 = getelementptr inbounds i8, ptr %0, i64 192
  %106 = getelementptr inbounds i8, ptr %0, i64 1416
  %107 = getelementptr inbounds i8, ptr %0, i64 408
  %108 = getelementptr inbounds i8, ptr %0, i64 408
  %109 = getelementptr inbounds i8, ptr %0, i64 384
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 248
  %112 = getelementptr inbounds i8, ptr %0, i64 192
  %113 = getelementptr inbounds i8, ptr %0, i64 216
  %114 = getelementptr inbounds i8, ptr %0, i64 528
  %115 = getelementptr inbounds i8, ptr %0, i64 1448
  %116 = getelementptr inbounds i8, ptr %0, i64 1392
  %117 = getelementptr inbounds i8, ptr %0, i64 1544
  %118 = getelementptr inbounds i8, ptr %0, i64 1488
  %119 = getelementptr inbounds i8, ptr %0, i64 1512
  %120 = getelementptr inbounds i8, ptr %0, i64 1440
  %121 = getelementptr inbounds i8, ptr %0, i64 1536
  %122 = getelementptr inbounds i8, ptr %0, i64 1560
  %123 = getelementptr inbounds i8, ptr %0, i64 1656
  %124 = getelementptr inbounds i8, ptr %0, i64 1584
  %125 = getelementptr inbounds i8, ptr %0, i64 1608
  %126 = getelementptr inbounds i8, ptr %0, i64 408
  %127 = getelementptr inbounds i8, ptr %0, i64 1632
  %128 = getelementptr inbounds i8, ptr %0, i64 408
  %129 = getelementptr inbounds i8, ptr %0, i64 168
  %130 = getelementptr inbounds i8, ptr %0, i64 248
  %131 = getelementptr inbounds i8, ptr %0, i64 192
  %132 = getelementptr inbounds i8, ptr %0, i64 216
  %133 = getelementptr inbounds i8, ptr %0, i64 1632
  %134 = getelementptr inbounds i8, ptr %0, i64 1680
  %135 = getelementptr inbounds i8, ptr %0, i64 1704
  %136 = getelementptr inbounds i8, ptr %0, i64 600
  %137 = getelementptr inbounds i8, ptr %0, i64 1536
  %138 = getelementptr inbounds i8, ptr %0, i64 1544
  %139 = getelementptr inbounds i8, ptr %0, i64 1680
  %140 = getelementptr inbounds i8, ptr %0, i64 1704
  %141 = getelementptr inbounds i8, ptr %0, i64 1488
  %142 = getelementptr inbounds i8, ptr %0, i64 1512
  %143 = getelementptr inbounds i8, ptr %0, i64 1560
  %144 = getelementptr inbounds i8, ptr %0, i64 600
  %145 = getelementptr inbounds i8, ptr %4, i64 8
  %146 = getelementptr inbounds i8, ptr %4, i64 16
  %147 = getelementptr inbounds i8, ptr %0, i64 1448
  %148 = getelementptr inbounds i8, ptr %0, i64 1440
  %149 = getelementptr inbounds i8, ptr %0, i64 384
  %150 = getelementptr inbounds i8, ptr %0, i64 1536
  %151 = getelementptr inbounds i8, ptr %0, i64 1544
  %152 = getelementptr inbounds i8, ptr %0, i64 1728
  %153 = getelementptr inbounds i8, ptr %0, i64 1680
  %154 = getelementptr inbounds i8, ptr %0, i64 528
  %155 = getelementptr inbounds i8, ptr %0, i64 1488
  %156 = getelementptr inbounds i8, ptr %0, i64 384
  %157 = getelementptr inbounds i8, ptr %0, i64 408
  %158 = getelementptr inbounds i8, ptr %0, i64 408
  %159 = getelementptr inbounds i8, ptr %0, i64 1632
  %160 = getelementptr inbounds i8, ptr %0, i64 168
  %161 = getelementptr inbounds i8, ptr %0, i64 248
  %162 = getelementptr inbounds i8, ptr %0, i64 192
  %163 = getelementptr inbounds i8, ptr %0, i64 216
  %164 = getelementptr inbounds i8, ptr %0, i64 384
  %165 = getelementptr inbounds i8, ptr %0, i64 1392
  %166 = getelementptr inbounds i8, ptr %0, i64 368
  %167 = getelementptr inbounds i8, ptr %0, i64 1584
  %168 = getelementptr inbounds i8, ptr %0, i64 552
  %169 = getelementptr inbounds i8, ptr %0, i64 1656
  %170 = getelementptr inbounds i8, ptr %0, i64 1392
  %171 = getelementptr inbounds i8, ptr %9, i64 8
  %172 = getelementptr inbounds i8, ptr %9, i64 16
  %173 = getelementptr inbounds i8, ptr %10, i64 8
  %174 = getelementptr inbounds i8, ptr %10, i64 16
  %175 = getelementptr inbounds i8, ptr %0, i64 384
  %176 = getelementptr inbounds i8, ptr %0, i64 1344
  %177 = getelementptr inbounds i8, ptr %0, i64 1360
  %178 = getelementptr inbounds i8, ptr %0, i64 384
  %179 = getelementptr inbounds i8, ptr %0, i64 552
  %180 = getelementptr inbounds i8, ptr %0, i64 368
  %181 = getelementptr inbounds i8, ptr %0, i64 888
  %182 = getelementptr inbounds i8, ptr %0, i64 1584
  %183 = getelementptr inbounds i8, ptr %0, i64 384
  %184 = getelementptr inbounds i8, ptr %0, i64 168
  %185 = getelementptr inbounds i8, ptr %0, i64 984
  %186 = getelementptr inbounds i8, ptr %0, i64 912
  %187 = getelementptr inbounds i8, ptr %0, i64 864
  %188 = getelementptr inbounds i8, ptr %0, i64 936
  %189 = getelementptr inbounds i8, ptr %0, i64 456
  %190 = getelementptr inbounds i8, ptr %0, i64 408
  %191 = getelementptr inbounds i8, ptr %0, i64 456
  %192 = getelementptr inbounds i8, ptr %0, i64 368
  %193 = getelementptr inbounds i8, ptr %0, i64 384
  %194 = getelementptr inbounds i8, ptr %0, i64 384
  %195 = getelementptr inbounds i8, ptr %0, i64 384
  %196 = getelementptr inbounds i8, ptr %0, i64 368
  %197 = getelementptr inbounds i8, ptr %0, i64 384
  %198 = getelementptr inbounds i8, ptr %0, i64 384
  %199 = getelementptr inbounds i8, ptr %0, i64 336
  %200 = getelementptr inbounds i8, ptr %0, i64 528
  %201 = getelementptr inbounds i8, ptr %0, i64 168
  %202 = getelementptr inbounds i8, ptr %0, i64 248
  %203 = getelementptr inbounds i8, ptr %0, i64 192
  %204 = getelementptr inbounds i8, ptr %0, i64 216
  %205 = getelementptr inbounds i8, ptr %0, i64 768
  br label %206

206:                                              ; preds = %2265, %76
  %207 = phi double [ undef, %76 ], [ %2245, %2265 ]
  %208 = phi double [ undef, %76 ], [ %2246, %2265 ]
  %209 = phi double [ undef, %76 ], [ %2247, %2265 ]
  %210 = phi i64 [ undef, %76 ], [ %2248, %2265 ]
  %211 = phi i64 [ undef, %76 ], [ %2249, %2265 ]
  %212 = phi i64 [ undef, %76 ], [ %2250, %2265 ]
  %213 = load ptr, ptr %80, align 8, !noalias !8
  %214 = load double, ptr %213, align 8, !noalias !8
  %215 = load ptr, ptr %77, align 8
  %216 = getelementptr inbounds i8, ptr %215, i64 8
  %217 = load i64, ptr %216, align 8
  %218 = icmp sgt i64 %217, 0
  br i1 %218, label %219, label %228

219:                                              ; preds = %206, %219
  %220 = phi i64 [ %226, %219 ], [ 0, %206 ]
  %221 = phi double [ %225, %219 ], [ %214, %206 ]
  %222 = getelementptr inbounds double, ptr %213, i64 %220
  %223 = load double, ptr %222, align 8, !noalias !8
  %224 = fcmp olt double %223, %221
  %225 = select i1 %224, double %223, double %221
  %226 = add nuw nsw i64 %220, 1
  %227 = icmp eq i64 %226, %217
  br i1 %227, label %228, label %219, !llvm.loop !11

228:                                              ; preds = %219, %206
  %229 = phi double [ %214, %206 ], [ %225, %219 ]
  %230 = load ptr, ptr %81, align 8
  %231 = load ptr, ptr %82, align 8
  %232 = getelementptr inbounds i8, ptr %231, i64 56
  %233 = load i64, ptr %232, align 8
  %234 = icmp eq i64 %233, 0
  br i1 %234, label %2244, label %235

235:                                              ; preds = %228
  %236 = load ptr, ptr %83, align 8
  %237 = load i64, ptr %84, align 8
  %238 = getelementptr double, ptr %236, i64 %237
  %239 = getelementptr i8, ptr %238, i64 -8
  %240 = load double, ptr %239, align 8
  %241 = load ptr, ptr %85, align 8
  %242 = load i64, ptr %241, align 8
  %243 = icmp eq i64 %242, 1
  %244 = load ptr, ptr %86, align 8
  %245 = getelementptr inbounds i8, ptr %244, i64 8
  %246 = load i64, ptr %245, align 8
  %247 = icmp sgt i64 %246, 0
  %248 = load double, ptr %230, align 8
  %249 = getelementptr inbounds i8, ptr %230, i64 8
  %250 = load double, ptr %249, align 8
  %251 = load i64, ptr %231, align 8
  %252 = icmp eq i64 %251, 0
  br i1 %252, label %253, label %401

253:                                              ; preds = %235
  %254 = load i64, ptr %87, align 8
  %255 = icmp eq i64 %254, 0
  br i1 %255, label %285, label %256

256:                                              ; preds = %253
  %257 = icmp sgt i64 %254, 0
  br i1 %257, label %258, label %273

258:                                              ; preds = %256
  %259 = load ptr, ptr %88, align 8
  br label %260

260:                                              ; preds = %258, %260
  %261 = phi i64 [ 0, %258 ], [ %271, %260 ]
  %262 = phi i64 [ %254, %258 ], [ %270, %260 ]
  %263 = add nuw nsw i64 %261, %262
  %264 = lshr i64 %263, 1
  %265 = mul i64 %264, 24
  %266 = getelementptr inbounds i8, ptr %259, i64 %265
  %267 = load double, ptr %266, align 8
  %268 = fcmp ogt double %267, %248
  %269 = add nuw nsw i64 %264, 1
  %270 = select i1 %268, i64 %264, i64 %262
  %271 = select i1 %268, i64 %261, i64 %269
  %272 = icmp slt i64 %271, %270
  br i1 %272, label %260, label %273, !llvm.loop !12

273:                                              ; preds = %260, %256
  %274 = phi i64 [ 0, %256 ], [ %271, %260 ]
  %275 = icmp slt i64 %274, %254
  br i1 %275, label %276, label %282

276:                                              ; preds = %273
  %277 = load ptr, ptr %88, align 8
  %278 = mul i64 %274, 24
  %279 = getelementptr inbounds i8, ptr %277, i64 %278
  %280 = getelementptr inbounds i8, ptr %279, i64 8
  %281 = load double, ptr %280, align 8
  br label %282

282:                                              ; preds = %276, %273
  %283 = phi double [ %281, %276 ], [ 0x7FF0000000000000, %273 ]
  %284 = load ptr, ptr %89, align 8
  store double %283, ptr %284, align 8
  br label %285

285:                                              ; preds = %282, %253
  %286 = getelementptr inbounds i8, ptr %231, i64 24
  %287 = load i64, ptr %286, align 8
  %288 = add nsw i64 %287, 1
  store i64 %288, ptr %286, align 8
  %289 = load ptr, ptr %78, align 8
  %290 = load ptr, ptr %90, align 8
  %291 = load ptr, ptr %91, align 8
  store double %248, ptr %291, align 8
  %292 = load ptr, ptr %77, align 8
  %293 = getelementptr inbounds i8, ptr %292, i64 40
  %294 = load i64, ptr %293, align 8
  %295 = icmp eq i64 %294, 0
  br i1 %295, label %297, label %296

296:                                              ; preds = %285
  tail call fastcc void @settle(ptr noundef nonnull %77) #8
  br label %297

297:                                              ; preds = %296, %285
  %298 = load i64, ptr %92, align 8
  %299 = icmp sgt i64 %298, 0
  br i1 %299, label %300, label %301

300:                                              ; preds = %297
  tail call fastcc void @sample(ptr noundef nonnull %77) #8
  br label %301

301:                                              ; preds = %297, %300
  %302 = load ptr, ptr %77, align 8
  %303 = load i64, ptr %302, align 8
  %304 = load ptr, ptr %91, align 8
  %305 = load ptr, ptr %93, align 8
  %306 = load ptr, ptr %94, align 8
  %307 = inttoptr i64 %303 to ptr
  %308 = load ptr, ptr %307, align 8
  %309 = tail call i32 %308(ptr noundef %304, ptr noundef %289, ptr noundef %305, ptr noundef %306, ptr noundef %290) #9
  %310 = icmp eq i32 %309, 0
  br i1 %310, label %315, label %311

311:                                              ; preds = %301
  %312 = getelementptr inbounds i8, ptr %231, i64 72
  store i64 3, ptr %312, align 8
  %313 = icmp slt i32 %309, 0
  %314 = select i1 %313, i64 -4, i64 2
  br label %2244

315:                                              ; preds = %301
  store i64 1, ptr %231, align 8
  %316 = load ptr, ptr %79, align 8
  %317 = getelementptr inbounds i8, ptr %316, i64 16
  %318 = load i64, ptr %317, align 8
  %319 = and i64 %318, -2
  store i64 %319, ptr %317, align 8
  %320 = load ptr, ptr %79, align 8
  %321 = getelementptr inbounds i8, ptr %320, i64 32
  %322 = load i64, ptr %321, align 8
  %323 = or i64 %322, 1
  store i64 %323, ptr %321, align 8
  %324 = load ptr, ptr %79, align 8
  %325 = getelementptr inbounds i8, ptr %324, i64 8
  %326 = load i64, ptr %325, align 8
  %327 = and i64 %326, -2
  %328 = getelementptr inbounds i8, ptr %324, i64 16
  %329 = load i64, ptr %328, align 8
  %330 = and i64 %329, 1
  %331 = or disjoint i64 %330, %327
  %332 = xor i64 %331, 1
  store i64 %332, ptr %325, align 8
  %333 = load ptr, ptr %95, align 8
  %334 = getelementptr inbounds i8, ptr %333, i64 8
  store double 0.000000e+00, ptr %334, align 8
  %335 = load ptr, ptr %95, align 8
  %336 = getelementptr inbounds i8, ptr %335, i64 24
  store double 0.000000e+00, ptr %336, align 8
  %337 = load ptr, ptr %78, align 8
  %338 = load ptr, ptr %77, align 8
  %339 = getelementptr inbounds i8, ptr %338, i64 8
  %340 = load i64, ptr %339, align 8
  %341 = load i64, ptr %84, align 8
  %342 = load ptr, ptr %83, align 8
  %343 = load ptr, ptr %82, align 8
  %344 = getelementptr inbounds i8, ptr %343, i64 48
  %345 = load i64, ptr %344, align 8
  %346 = icmp slt i64 %345, %341
  br i1 %346, label %347, label %370

347:                                              ; preds = %315
  %348 = icmp sgt i64 %340, 0
  br label %349

349:                                              ; preds = %347, %360
  %350 = phi i64 [ %345, %347 ], [ %361, %360 ]
  %351 = getelementptr inbounds double, ptr %342, i64 %350
  %352 = load double, ptr %351, align 8
  %353 = load ptr, ptr %81, align 8
  %354 = load double, ptr %353, align 8
  %355 = fcmp ugt double %352, %354
  br i1 %355, label %370, label %356

356:                                              ; preds = %349
  br i1 %348, label %357, label %360

357:                                              ; preds = %356
  %358 = mul nsw i64 %350, %340
  %359 = getelementptr double, ptr %1, i64 %358
  br label %363

360:                                              ; preds = %363, %356
  %361 = add i64 %350, 1
  %362 = icmp eq i64 %361, %341
  br i1 %362, label %370, label %349, !llvm.loop !13

363:                                              ; preds = %357, %363
  %364 = phi i64 [ 0, %357 ], [ %368, %363 ]
  %365 = getelementptr inbounds double, ptr %337, i64 %364
  %366 = load double, ptr %365, align 8
  %367 = getelementptr double, ptr %359, i64 %364
  store double %366, ptr %367, align 8
  %368 = add nuw nsw i64 %364, 1
  %369 = icmp eq i64 %368, %340
  br i1 %369, label %360, label %363, !llvm.loop !14

370:                                              ; preds = %349, %360, %315
  %371 = phi i64 [ %345, %315 ], [ %350, %349 ], [ %341, %360 ]
  %372 = load ptr, ptr %82, align 8
  %373 = getelementptr inbounds i8, ptr %372, i64 48
  store i64 %371, ptr %373, align 8
  %374 = icmp eq i64 %371, %341
  br i1 %374, label %2244, label %375

375:                                              ; preds = %370
  %376 = fcmp oeq double %250, 0.000000e+00
  br i1 %376, label %377, label %401

377:                                              ; preds = %375
  %378 = getelementptr inbounds i8, ptr %230, i64 16
  %379 = load double, ptr %378, align 8
  %380 = load ptr, ptr %78, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %380, ptr noundef %380, ptr noundef nonnull %78, i64 noundef %217) #8
  %381 = load double, ptr %7, align 8
  %382 = load ptr, ptr %96, align 8
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %382, ptr noundef %380, ptr noundef nonnull %78, i64 noundef %217) #8
  %383 = load double, ptr %8, align 8
  %384 = fcmp uge double %381, 1.000000e-05
  %385 = fcmp uge double %383, 1.000000e-05
  %386 = and i1 %384, %385
  %387 = fmul double %381, 1.000000e-02
  %388 = fdiv double %387, %383
  %389 = select i1 %386, double %388, double 0x3EB0C6F7A0B5ED8D
  %390 = fcmp olt double %379, %389
  %391 = select i1 %390, double %379, double %389
  %392 = tail call double @llvm.fabs.f64(double %248)
  %393 = fmul double %392, 0x3D30000000000000
  %394 = fcmp ogt double %393, %391
  %395 = select i1 %394, double %393, double %391
  %396 = fcmp olt double %379, %395
  %397 = select i1 %396, double %379, double %395
  %398 = tail call i1 @llvm.is.fpclass.f64(double %397, i32 639)
  br i1 %398, label %399, label %401

399:                                              ; preds = %377
  %400 = getelementptr inbounds i8, ptr %231, i64 72
  store i64 4, ptr %400, align 8
  br label %401

401:                                              ; preds = %377, %399, %375, %235
  %402 = phi double [ %250, %375 ], [ %250, %235 ], [ %397, %399 ], [ %397, %377 ]
  %403 = load i64, ptr %232, align 8
  %404 = icmp eq i64 %403, 0
  br i1 %404, label %431, label %405

405:                                              ; preds = %401
  %406 = getelementptr inbounds i8, ptr %231, i64 8
  %407 = getelementptr inbounds i8, ptr %231, i64 16
  %408 = getelementptr inbounds i8, ptr %231, i64 64
  %409 = getelementptr inbounds i8, ptr %230, i64 16
  %410 = fcmp ogt double %229, 0x3CB0000000000000
  %411 = select i1 %410, double %229, double 0x3CB0000000000000
  %412 = fdiv double 0x3CE4000000000000, %411
  %413 = tail call double @llvm.sqrt.f64(double %229)
  %414 = fcmp olt double %413, 3.000000e-02
  %415 = select i1 %414, double %413, double 3.000000e-02
  %416 = fcmp ogt double %415, %412
  %417 = select i1 %416, double %415, double %412
  %418 = fmul double %229, %417
  %419 = fmul double %418, %418
  %420 = getelementptr inbounds i8, ptr %231, i64 24
  %421 = getelementptr inbounds i8, ptr %231, i64 32
  %422 = getelementptr inbounds i8, ptr %231, i64 40
  %423 = getelementptr inbounds i8, ptr %231, i64 72
  %424 = getelementptr inbounds i8, ptr %230, i64 32
  %425 = getelementptr inbounds i8, ptr %231, i64 48
  %426 = icmp sgt i64 %217, 0
  %427 = getelementptr inbounds i8, ptr %231, i64 72
  %428 = getelementptr inbounds i8, ptr %231, i64 48
  %429 = getelementptr inbounds i8, ptr %231, i64 72
  %430 = getelementptr inbounds i8, ptr %231, i64 72
  br label %439

431:                                              ; preds = %2241, %401
  %432 = phi double [ %207, %401 ], [ %2231, %2241 ]
  %433 = phi double [ %208, %401 ], [ %2232, %2241 ]
  %434 = phi double [ %209, %401 ], [ %2233, %2241 ]
  %435 = phi i64 [ %210, %401 ], [ %2234, %2241 ]
  %436 = phi i64 [ %211, %401 ], [ %2235, %2241 ]
  %437 = phi i64 [ %212, %401 ], [ %2236, %2241 ]
  %438 = phi double [ %402, %401 ], [ %2237, %2241 ]
  store double %438, ptr %249, align 8
  br label %2244

439:                                              ; preds = %405, %2241
  %440 = phi i64 [ %403, %405 ], [ %2242, %2241 ]
  %441 = phi i64 [ undef, %405 ], [ %2240, %2241 ]
  %442 = phi double [ %248, %405 ], [ %2238, %2241 ]
  %443 = phi double [ %402, %405 ], [ %2237, %2241 ]
  %444 = phi i64 [ %212, %405 ], [ %2236, %2241 ]
  %445 = phi i64 [ %211, %405 ], [ %2235, %2241 ]
  %446 = phi i64 [ %210, %405 ], [ %2234, %2241 ]
  %447 = phi double [ %209, %405 ], [ %2233, %2241 ]
  %448 = phi double [ %208, %405 ], [ %2232, %2241 ]
  %449 = phi double [ %207, %405 ], [ %2231, %2241 ]
  %450 = load ptr, ptr %97, align 8
  %451 = getelementptr inbounds i8, ptr %450, i64 8
  %452 = load i64, ptr %451, align 8
  %453 = icmp sgt i64 %452, 0
  br i1 %453, label %454, label %459

454:                                              ; preds = %439
  %455 = load i64, ptr %450, align 8
  %456 = add nsw i64 %455, 3
  %457 = icmp slt i64 %452, %456
  %458 = zext i1 %457 to i32
  br label %459

459:                                              ; preds = %439, %454
  %460 = phi i32 [ 0, %439 ], [ %458, %454 ]
  %461 = icmp eq i32 %460, 0
  br i1 %461, label %463, label %462

462:                                              ; preds = %459
  store double %443, ptr %249, align 8
  br label %2244

463:                                              ; preds = %459
  %464 = add nsw i64 %440, -1
  store i64 %464, ptr %232, align 8
  %465 = load i64, ptr %406, align 8
  %466 = load i64, ptr %407, align 8
  %467 = add nsw i64 %466, %465
  %468 = load i64, ptr %408, align 8
  %469 = icmp slt i64 %467, %468
  br i1 %469, label %471, label %470

470:                                              ; preds = %463
  store double %443, ptr %249, align 8
  br label %2244

471:                                              ; preds = %463
  %472 = load i64, ptr %98, align 8
  %473 = icmp eq i64 %472, 0
  br i1 %473, label %507, label %474

474:                                              ; preds = %471
  %475 = icmp sgt i64 %472, 0
  br i1 %475, label %476, label %491

476:                                              ; preds = %474
  %477 = load ptr, ptr %99, align 8
  br label %478

478:                                              ; preds = %476, %478
  %479 = phi i64 [ 0, %476 ], [ %489, %478 ]
  %480 = phi i64 [ %472, %476 ], [ %488, %478 ]
  %481 = add nuw nsw i64 %479, %480
  %482 = lshr i64 %481, 1
  %483 = mul i64 %482, 24
  %484 = getelementptr inbounds i8, ptr %477, i64 %483
  %485 = load double, ptr %484, align 8
  %486 = fcmp ogt double %485, %442
  %487 = add nuw nsw i64 %482, 1
  %488 = select i1 %486, i64 %482, i64 %480
  %489 = select i1 %486, i64 %479, i64 %487
  %490 = icmp slt i64 %489, %488
  br i1 %490, label %478, label %491, !llvm.loop !12

491:                                              ; preds = %478, %474
  %492 = phi i64 [ 0, %474 ], [ %489, %478 ]
  %493 = load ptr, ptr %99, align 8
  %494 = mul i64 %492, 24
  %495 = getelementptr inbounds i8, ptr %493, i64 %494
  %496 = icmp slt i64 %492, %472
  br i1 %496, label %497, label %500

497:                                              ; preds = %491
  %498 = getelementptr inbounds i8, ptr %495, i64 8
  %499 = load double, ptr %498, align 8
  br label %500

500:                                              ; preds = %497, %491
  %501 = phi double [ %499, %497 ], [ 0x7FF0000000000000, %491 ]
  %502 = load ptr, ptr %100, align 8
  store double %501, ptr %502, align 8
  %503 = load i64, ptr %98, align 8
  %504 = icmp slt i64 %492, %503
  br i1 %504, label %505, label %507

505:                                              ; preds = %500
  %506 = load double, ptr %495, align 8
  br label %507

507:                                              ; preds = %471, %500, %505
  %508 = phi double [ 0x7FF0000000000000, %471 ], [ %506, %505 ], [ 0x7FF0000000000000, %500 ]
  %509 = fcmp olt double %240, %508
  %510 = select i1 %509, double %240, double %508
  %511 = load double, ptr %409, align 8
  %512 = fcmp olt double %443, %511
  %513 = select i1 %512, double %443, double %511
  %514 = fadd double %442, %513
  %515 = fmul double %513, 1.000000e-03
  %516 = fsub double %510, %515
  %517 = fcmp ule double %514, %516
  %518 = select i1 %517, double %514, double %510
  %519 = fsub double %518, %442
  %520 = fmul double %519, 6.250000e-02
  %521 = fadd double %442, %520
  %522 = fcmp ule double %521, %442
  %523 = fcmp une double %518, %510
  %524 = and i1 %523, %522
  br i1 %524, label %525, label %526

525:                                              ; preds = %507
  store double %519, ptr %249, align 8
  br label %2230

526:                                              ; preds = %507
  %527 = load ptr, ptr %77, align 8, !noalias !15
  %528 = getelementptr inbounds i8, ptr %527, i64 8
  %529 = load i64, ptr %528, align 8, !noalias !15
  %530 = load ptr, ptr %79, align 8, !noalias !15
  %531 = getelementptr inbounds i8, ptr %530, i64 8
  %532 = load i64, ptr %531, align 8, !noalias !15
  %533 = and i64 %532, 1
  %534 = icmp eq i64 %533, 0
  br i1 %534, label %666, label %535

535:                                              ; preds = %526
  %536 = load ptr, ptr %102, align 8, !noalias !15
  %537 = load i64, ptr %530, align 8, !noalias !15
  %538 = icmp eq i64 %537, 0
  br i1 %538, label %539, label %541

539:                                              ; preds = %535
  %540 = icmp sgt i64 %529, 0
  br i1 %540, label %565, label %563

541:                                              ; preds = %535
  %542 = load ptr, ptr %103, align 8, !noalias !15
  store double %442, ptr %542, align 8, !noalias !15
  %543 = load ptr, ptr %77, align 8, !noalias !15
  %544 = getelementptr inbounds i8, ptr %543, i64 40
  %545 = load i64, ptr %544, align 8, !noalias !15
  %546 = icmp eq i64 %545, 0
  br i1 %546, label %548, label %547

547:                                              ; preds = %541
  tail call fastcc void @settle(ptr noundef nonnull %77) #8, !noalias !15
  br label %548

548:                                              ; preds = %547, %541
  %549 = load i64, ptr %104, align 8, !noalias !15
  %550 = icmp sgt i64 %549, 0
  br i1 %550, label %551, label %552

551:                                              ; preds = %548
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !15
  br label %552

552:                                              ; preds = %551, %548
  %553 = load ptr, ptr %79, align 8, !noalias !15
  %554 = load i64, ptr %553, align 8, !noalias !15
  %555 = load ptr, ptr %103, align 8, !noalias !15
  %556 = load ptr, ptr %78, align 8, !noalias !15
  %557 = load ptr, ptr %105, align 8, !noalias !15
  %558 = load ptr, ptr %106, align 8, !noalias !15
  %559 = inttoptr i64 %554 to ptr
  %560 = load ptr, ptr %559, align 8, !noalias !15
  %561 = tail call i32 %560(ptr noundef %555, ptr noundef %556, ptr noundef %557, ptr noundef %558, ptr noundef %536) #9, !noalias !15
  %562 = sext i32 %561 to i64
  br label %637

563:                                              ; preds = %565, %539
  %564 = icmp sgt i64 %529, 0
  br i1 %564, label %577, label %637

565:                                              ; preds = %539, %565
  %566 = phi i64 [ %572, %565 ], [ 0, %539 ]
  %567 = load ptr, ptr %78, align 8, !noalias !15
  %568 = getelementptr inbounds double, ptr %567, i64 %566
  %569 = load double, ptr %568, align 8, !noalias !15
  %570 = load ptr, ptr %107, align 8, !noalias !15
  %571 = getelementptr inbounds double, ptr %570, i64 %566
  store double %569, ptr %571, align 8, !noalias !15
  %572 = add nuw nsw i64 %566, 1
  %573 = icmp eq i64 %572, %529
  br i1 %573, label %563, label %565, !llvm.loop !18

574:                                              ; preds = %635
  %575 = add nuw nsw i64 %579, 1
  %576 = icmp eq i64 %575, %529
  br i1 %576, label %637, label %577, !llvm.loop !19

577:                                              ; preds = %563, %574
  %578 = phi i64 [ %636, %574 ], [ undef, %563 ]
  %579 = phi i64 [ %575, %574 ], [ 0, %563 ]
  %580 = phi double [ %591, %574 ], [ 0.000000e+00, %563 ]
  %581 = load ptr, ptr %78, align 8, !noalias !15
  %582 = getelementptr inbounds double, ptr %581, i64 %579
  %583 = load double, ptr %582, align 8, !noalias !15
  %584 = tail call double @llvm.fabs.f64(double %583)
  %585 = fcmp olt double %584, 1.000000e-05
  %586 = select i1 %585, double 1.000000e-05, double %584
  %587 = fmul double %586, 1.500000e-08
  %588 = fadd double %583, %587
  %589 = load ptr, ptr %108, align 8, !noalias !15
  %590 = getelementptr inbounds double, ptr %589, i64 %579
  store double %588, ptr %590, align 8, !noalias !15
  %591 = fadd double %580, 1.000000e+00
  %592 = load ptr, ptr %108, align 8, !noalias !15
  %593 = load ptr, ptr %109, align 8, !noalias !15
  %594 = load ptr, ptr %110, align 8, !noalias !15
  store double %442, ptr %594, align 8, !noalias !15
  %595 = load ptr, ptr %77, align 8, !noalias !15
  %596 = getelementptr inbounds i8, ptr %595, i64 40
  %597 = load i64, ptr %596, align 8, !noalias !15
  %598 = icmp eq i64 %597, 0
  br i1 %598, label %600, label %599

599:                                              ; preds = %577
  tail call fastcc void @settle(ptr noundef nonnull %77) #8, !noalias !15
  br label %600

600:                                              ; preds = %599, %577
  %601 = load i64, ptr %111, align 8, !noalias !15
  %602 = icmp sgt i64 %601, 0
  br i1 %602, label %603, label %604

603:                                              ; preds = %600
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !15
  br label %604

604:                                              ; preds = %603, %600
  %605 = load ptr, ptr %77, align 8, !noalias !15
  %606 = load i64, ptr %605, align 8, !noalias !15
  %607 = load ptr, ptr %110, align 8, !noalias !15
  %608 = load ptr, ptr %112, align 8, !noalias !15
  %609 = load ptr, ptr %113, align 8, !noalias !15
  %610 = inttoptr i64 %606 to ptr
  %611 = load ptr, ptr %610, align 8, !noalias !15
  %612 = tail call i32 %611(ptr noundef %607, ptr noundef %592, ptr noundef %608, ptr noundef %609, ptr noundef %593) #9, !noalias !15
  %613 = sext i32 %612 to i64
  %614 = icmp eq i32 %612, 0
  br i1 %614, label %615, label %635

615:                                              ; preds = %604
  %616 = getelementptr double, ptr %536, i64 %579
  %617 = fsub double %588, %583
  br label %621

618:                                              ; preds = %621
  %619 = load ptr, ptr %108, align 8, !noalias !15
  %620 = getelementptr inbounds double, ptr %619, i64 %579
  store double %583, ptr %620, align 8, !noalias !15
  br label %635

621:                                              ; preds = %615, %621
  %622 = phi i64 [ 0, %615 ], [ %633, %621 ]
  %623 = load ptr, ptr %109, align 8, !noalias !15
  %624 = getelementptr inbounds double, ptr %623, i64 %622
  %625 = load double, ptr %624, align 8, !noalias !15
  %626 = load ptr, ptr %114, align 8, !noalias !15
  %627 = getelementptr inbounds double, ptr %626, i64 %622
  %628 = load double, ptr %627, align 8, !noalias !15
  %629 = fsub double %625, %628
  %630 = fdiv double %629, %617
  %631 = mul nuw nsw i64 %622, %529
  %632 = getelementptr double, ptr %616, i64 %631
  store double %630, ptr %632, align 8, !noalias !15
  %633 = add nuw nsw i64 %622, 1
  %634 = icmp eq i64 %633, %529
  br i1 %634, label %618, label %621, !llvm.loop !20

635:                                              ; preds = %618, %604
  %636 = phi i64 [ %578, %618 ], [ %613, %604 ]
  br i1 %614, label %574, label %637

637:                                              ; preds = %635, %574, %563, %552
  %638 = phi double [ 0.000000e+00, %552 ], [ 0.000000e+00, %563 ], [ %591, %574 ], [ %591, %635 ]
  %639 = phi i64 [ %562, %552 ], [ 0, %563 ], [ %636, %635 ], [ 0, %574 ]
  %640 = load i64, ptr %115, align 8, !noalias !15
  %641 = icmp sgt i64 %640, 0
  br i1 %641, label %642, label %655

642:                                              ; preds = %637, %642
  %643 = phi i64 [ %652, %642 ], [ 0, %637 ]
  %644 = load ptr, ptr %102, align 8, !noalias !15
  %645 = getelementptr inbounds double, ptr %644, i64 %643
  %646 = load double, ptr %645, align 8, !noalias !15
  %647 = tail call double @llvm.fabs.f64(double %646)
  %648 = fcmp ueq double %647, 0x7FF0000000000000
  %649 = select i1 %648, double 0.000000e+00, double %646
  %650 = load ptr, ptr %101, align 8, !noalias !15
  %651 = getelementptr inbounds double, ptr %650, i64 %643
  store double %649, ptr %651, align 8, !noalias !15
  %652 = add nuw nsw i64 %643, 1
  %653 = load i64, ptr %115, align 8, !noalias !15
  %654 = icmp slt i64 %652, %653
  br i1 %654, label %642, label %655, !llvm.loop !21

655:                                              ; preds = %642, %637
  %656 = icmp slt i64 %639, 0
  br i1 %656, label %1620, label %657

657:                                              ; preds = %655
  %658 = load i64, ptr %531, align 8, !noalias !15
  %659 = and i64 %658, -2
  store i64 %659, ptr %531, align 8, !noalias !15
  %660 = getelementptr inbounds i8, ptr %530, i64 16
  %661 = load i64, ptr %660, align 8, !noalias !15
  %662 = or i64 %661, 1
  store i64 %662, ptr %660, align 8, !noalias !15
  %663 = getelementptr inbounds i8, ptr %530, i64 24
  %664 = load i64, ptr %663, align 8, !noalias !15
  %665 = and i64 %664, -2
  store i64 %665, ptr %663, align 8, !noalias !15
  br label %666

666:                                              ; preds = %657, %526
  %667 = phi double [ 0.000000e+00, %526 ], [ %638, %657 ]
  %668 = load ptr, ptr %79, align 8, !noalias !15
  %669 = load ptr, ptr %116, align 8, !noalias !15
  %670 = load double, ptr %669, align 8, !noalias !15
  %671 = fsub double %519, %670
  %672 = tail call double @llvm.fabs.f64(double %671)
  %673 = tail call double @llvm.fabs.f64(double %518)
  %674 = fmul double %673, 0x3CB0000000000000
  %675 = fcmp ogt double %672, %674
  %676 = getelementptr inbounds i8, ptr %668, i64 24
  %677 = load i64, ptr %676, align 8, !noalias !15
  %678 = trunc i64 %677 to i1
  %679 = xor i1 %678, true
  %680 = or i1 %675, %679
  %681 = zext i1 %680 to i64
  br i1 %680, label %682, label %742

682:                                              ; preds = %666
  store double %519, ptr %669, align 8, !noalias !15
  %683 = load i64, ptr %117, align 8, !noalias !15
  %684 = load ptr, ptr %118, align 8, !noalias !15
  %685 = load ptr, ptr %119, align 8, !noalias !15
  %686 = icmp sgt i64 %683, 0
  br i1 %686, label %687, label %717

687:                                              ; preds = %682
  %688 = fdiv double 0x400D1A48D83E731D, %519
  %689 = fdiv double 0x400572DB93E0C672, %519
  %690 = fdiv double 0xC0086747F2C3FCB6, %519
  br label %691

691:                                              ; preds = %687, %694
  %692 = phi i64 [ 0, %687 ], [ %695, %694 ]
  %693 = mul nuw nsw i64 %692, %683
  br label %697

694:                                              ; preds = %697
  %695 = add nuw nsw i64 %692, 1
  %696 = icmp eq i64 %695, %683
  br i1 %696, label %717, label %691, !llvm.loop !22

697:                                              ; preds = %691, %697
  %698 = phi i64 [ 0, %691 ], [ %715, %697 ]
  %699 = load ptr, ptr %120, align 8, !noalias !15
  %700 = add nuw nsw i64 %698, %693
  %701 = getelementptr inbounds double, ptr %699, i64 %700
  %702 = load double, ptr %701, align 8, !noalias !15
  %703 = fneg double %702
  %704 = icmp eq i64 %692, %698
  %705 = fsub double %688, %702
  %706 = select i1 %704, double %705, double %703
  %707 = fsub double %689, %702
  %708 = select i1 %704, double %707, double %703
  %709 = getelementptr inbounds double, ptr %684, i64 %700
  store double %706, ptr %709, align 8, !noalias !15
  %710 = select i1 %704, double %690, double 0.000000e+00
  %711 = shl nuw nsw i64 %700, 1
  %712 = getelementptr inbounds double, ptr %685, i64 %711
  store double %708, ptr %712, align 8, !noalias !15
  %713 = or disjoint i64 %711, 1
  %714 = getelementptr inbounds double, ptr %685, i64 %713
  store double %710, ptr %714, align 8, !noalias !15
  %715 = add nuw nsw i64 %698, 1
  %716 = icmp eq i64 %715, %683
  br i1 %716, label %694, label %697, !llvm.loop !23

717:                                              ; preds = %694, %682
  %718 = load ptr, ptr %121, align 8, !noalias !15
  %719 = tail call fastcc i64 @real_factorise(ptr noundef %684, i64 noundef %683, ptr noundef %718) #8, !noalias !15
  %720 = load ptr, ptr %122, align 8, !noalias !15
  %721 = tail call fastcc i64 @pair_factorise(ptr noundef %685, i64 noundef %683, ptr noundef %720) #8, !noalias !15
  %722 = or i64 %721, %719
  %723 = and i64 %722, %681
  %724 = load i64, ptr %676, align 8, !noalias !15
  %725 = or i64 %724, %681
  %726 = xor i64 %723, -1
  %727 = xor i64 %723, %725
  store i64 %727, ptr %676, align 8, !noalias !15
  %728 = icmp eq i64 %723, 0
  %729 = select i1 %728, double 2.000000e+00, double 4.000000e+00
  %730 = fmul double %519, 5.000000e-01
  %731 = select i1 %728, double %443, double %730
  %732 = load ptr, ptr %79, align 8, !noalias !15
  %733 = getelementptr inbounds i8, ptr %732, i64 8
  %734 = load i64, ptr %733, align 8, !noalias !15
  %735 = and i64 %734, %726
  %736 = getelementptr inbounds i8, ptr %732, i64 16
  %737 = load i64, ptr %736, align 8, !noalias !15
  %738 = xor i64 %737, -1
  %739 = and i64 %723, %738
  %740 = or disjoint i64 %739, %735
  store i64 %740, ptr %733, align 8, !noalias !15
  %741 = and i64 %726, 1
  br label %742

742:                                              ; preds = %666, %717
  %743 = phi double [ %443, %666 ], [ %731, %717 ]
  %744 = phi double [ 2.000000e+00, %666 ], [ %729, %717 ]
  %745 = phi i64 [ 1, %666 ], [ %741, %717 ]
  %746 = icmp eq i64 %745, 0
  br i1 %746, label %1620, label %747

747:                                              ; preds = %742
  %748 = load ptr, ptr %116, align 8, !noalias !15
  %749 = getelementptr inbounds i8, ptr %748, i64 8
  %750 = load double, ptr %749, align 8, !noalias !15
  %751 = load ptr, ptr %77, align 8, !noalias !15
  %752 = getelementptr inbounds i8, ptr %751, i64 8
  %753 = load i64, ptr %752, align 8, !noalias !15
  %754 = load ptr, ptr %123, align 8, !noalias !15
  %755 = load ptr, ptr %78, align 8, !noalias !15
  %756 = load ptr, ptr %124, align 8, !noalias !15
  %757 = load ptr, ptr %125, align 8, !noalias !15
  %758 = fcmp ule double %750, 0.000000e+00
  %759 = icmp sgt i64 %753, 0
  %760 = shl i64 %753, 4
  %761 = getelementptr i8, ptr %754, i64 %760
  %762 = mul i64 %753, 24
  %763 = getelementptr i8, ptr %754, i64 %762
  %764 = getelementptr double, ptr %754, i64 %753
  br label %770

765:                                              ; preds = %781
  %766 = icmp sgt i64 %753, 0
  %767 = getelementptr double, ptr %756, i64 %753
  %768 = shl i64 %753, 4
  %769 = getelementptr i8, ptr %756, i64 %768
  br label %807

770:                                              ; preds = %747, %781
  %771 = phi i64 [ 0, %747 ], [ %782, %781 ]
  %772 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %771
  %773 = load double, ptr %772, align 8, !noalias !15
  %774 = fmul double %519, %773
  %775 = fdiv double %774, %750
  %776 = fadd double %775, 1.000000e+00
  br i1 %759, label %777, label %781

777:                                              ; preds = %770
  %778 = fsub double 1.000000e+00, %776
  %779 = mul nuw nsw i64 %753, %771
  %780 = getelementptr double, ptr %756, i64 %779
  br label %784

781:                                              ; preds = %784, %770
  %782 = add nuw nsw i64 %771, 1
  %783 = icmp eq i64 %782, 3
  br i1 %783, label %765, label %770, !llvm.loop !24

784:                                              ; preds = %777, %784
  %785 = phi i64 [ 0, %777 ], [ %805, %784 ]
  %786 = getelementptr double, ptr %761, i64 %785
  %787 = load double, ptr %786, align 8, !noalias !15
  %788 = getelementptr double, ptr %763, i64 %785
  %789 = load double, ptr %788, align 8, !noalias !15
  %790 = fmul double %776, %789
  %791 = fadd double %787, %790
  %792 = fmul double %778, %791
  %793 = getelementptr inbounds double, ptr %754, i64 %785
  %794 = load double, ptr %793, align 8, !noalias !15
  %795 = getelementptr double, ptr %764, i64 %785
  %796 = load double, ptr %795, align 8, !noalias !15
  %797 = fadd double %796, %792
  %798 = fmul double %776, %797
  %799 = fadd double %794, %798
  %800 = getelementptr inbounds double, ptr %755, i64 %785
  %801 = load double, ptr %800, align 8, !noalias !15
  %802 = fsub double %799, %801
  %803 = select i1 %758, double 0.000000e+00, double %802
  %804 = getelementptr double, ptr %780, i64 %785
  store double %803, ptr %804, align 8, !noalias !15
  %805 = add nuw nsw i64 %785, 1
  %806 = icmp eq i64 %805, %753
  br i1 %806, label %781, label %784, !llvm.loop !25

807:                                              ; preds = %765, %818
  %808 = phi i64 [ 0, %765 ], [ %819, %818 ]
  br i1 %766, label %809, label %818

809:                                              ; preds = %807
  %810 = mul nuw nsw i64 %753, %808
  %811 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %808
  %812 = load double, ptr %811, align 8, !noalias !15
  %813 = getelementptr inbounds i8, ptr %811, i64 8
  %814 = load double, ptr %813, align 8, !noalias !15
  %815 = getelementptr inbounds i8, ptr %811, i64 16
  %816 = load double, ptr %815, align 8, !noalias !15
  %817 = getelementptr double, ptr %757, i64 %810
  br label %821

818:                                              ; preds = %821, %807
  %819 = add nuw nsw i64 %808, 1
  %820 = icmp eq i64 %819, 3
  br i1 %820, label %837, label %807, !llvm.loop !26

821:                                              ; preds = %809, %821
  %822 = phi i64 [ 0, %809 ], [ %835, %821 ]
  %823 = getelementptr inbounds double, ptr %756, i64 %822
  %824 = load double, ptr %823, align 8, !noalias !15
  %825 = fmul double %812, %824
  %826 = getelementptr double, ptr %767, i64 %822
  %827 = load double, ptr %826, align 8, !noalias !15
  %828 = fmul double %814, %827
  %829 = fadd double %825, %828
  %830 = getelementptr double, ptr %769, i64 %822
  %831 = load double, ptr %830, align 8, !noalias !15
  %832 = fmul double %816, %831
  %833 = fadd double %829, %832
  %834 = getelementptr double, ptr %817, i64 %822
  store double %833, ptr %834, align 8, !noalias !15
  %835 = add nuw nsw i64 %822, 1
  %836 = icmp eq i64 %835, %753
  br i1 %836, label %818, label %821, !llvm.loop !27

837:                                              ; preds = %818
  %838 = load ptr, ptr %79, align 8, !noalias !28
  %839 = getelementptr inbounds i8, ptr %838, i64 40
  %840 = load i64, ptr %839, align 8, !noalias !28
  %841 = icmp sgt i64 %840, 0
  %842 = select i1 %841, i64 10, i64 6
  %843 = fdiv double 0x400572DB93E0C672, %519
  %844 = fdiv double 0xC0086747F2C3FCB6, %519
  %845 = fdiv double 0x400D1A48D83E731D, %519
  %846 = fneg double %844
  br label %850

847:                                              ; preds = %1307
  %848 = add nuw nsw i64 %854, 1
  %849 = icmp eq i64 %848, %842
  br i1 %849, label %1322, label %850, !llvm.loop !31

850:                                              ; preds = %837, %847
  %851 = phi double [ -1.000000e+00, %837 ], [ %1320, %847 ]
  %852 = phi i64 [ %745, %837 ], [ %1319, %847 ]
  %853 = phi i64 [ 0, %837 ], [ %1318, %847 ]
  %854 = phi i64 [ 0, %837 ], [ %848, %847 ]
  %855 = phi i64 [ 0, %837 ], [ %1316, %847 ]
  %856 = phi i64 [ 0, %837 ], [ %944, %847 ]
  %857 = phi i64 [ 0, %837 ], [ %943, %847 ]
  %858 = phi double [ 0.000000e+00, %837 ], [ %1315, %847 ]
  %859 = phi double [ 0.000000e+00, %837 ], [ %1314, %847 ]
  %860 = phi double [ 0.000000e+00, %837 ], [ %942, %847 ]
  %861 = phi i64 [ %444, %837 ], [ %1313, %847 ]
  %862 = phi i64 [ %445, %837 ], [ %1312, %847 ]
  %863 = phi i64 [ %446, %837 ], [ %1311, %847 ]
  %864 = phi double [ %447, %837 ], [ %1310, %847 ]
  %865 = phi double [ %448, %837 ], [ %1309, %847 ]
  %866 = phi double [ %449, %837 ], [ %1308, %847 ]
  %867 = icmp ugt i64 %854, 5
  %868 = select i1 %867, i64 %855, i64 -1
  %869 = and i64 %852, %868
  %870 = load ptr, ptr %77, align 8, !noalias !28
  %871 = getelementptr inbounds i8, ptr %870, i64 8
  %872 = load i64, ptr %871, align 8, !noalias !28
  %873 = load ptr, ptr %124, align 8, !noalias !28
  %874 = icmp eq i64 %869, 0
  br i1 %874, label %941, label %875

875:                                              ; preds = %850
  %876 = icmp sgt i64 %872, 0
  br label %877

877:                                              ; preds = %875, %909
  %878 = phi i64 [ %869, %875 ], [ %924, %909 ]
  %879 = phi i64 [ 0, %875 ], [ %925, %909 ]
  %880 = phi i64 [ %856, %875 ], [ %922, %909 ]
  %881 = phi i64 [ %857, %875 ], [ %920, %909 ]
  %882 = phi double [ %860, %875 ], [ %890, %909 ]
  br i1 %876, label %883, label %886

883:                                              ; preds = %877
  %884 = mul nuw nsw i64 %879, %872
  %885 = getelementptr double, ptr %873, i64 %884
  br label %929

886:                                              ; preds = %929, %877
  %887 = and i64 %878, 4294967295
  %888 = icmp eq i64 %887, 0
  %889 = select i1 %888, double 0.000000e+00, double 1.000000e+00
  %890 = fadd double %882, %889
  %891 = load ptr, ptr %127, align 8, !noalias !28
  %892 = mul nsw i64 %879, %872
  %893 = getelementptr inbounds double, ptr %891, i64 %892
  %894 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %879
  %895 = load double, ptr %894, align 8, !noalias !28
  %896 = fmul double %519, %895
  %897 = fadd double %442, %896
  %898 = load ptr, ptr %128, align 8, !noalias !28
  %899 = load ptr, ptr %129, align 8, !noalias !28
  store double %897, ptr %899, align 8, !noalias !28
  %900 = load ptr, ptr %77, align 8, !noalias !28
  %901 = getelementptr inbounds i8, ptr %900, i64 40
  %902 = load i64, ptr %901, align 8, !noalias !28
  %903 = icmp eq i64 %902, 0
  br i1 %903, label %905, label %904

904:                                              ; preds = %886
  tail call fastcc void @settle(ptr noundef nonnull %77) #8, !noalias !28
  br label %905

905:                                              ; preds = %904, %886
  %906 = load i64, ptr %130, align 8, !noalias !28
  %907 = icmp sgt i64 %906, 0
  br i1 %907, label %908, label %909

908:                                              ; preds = %905
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !28
  br label %909

909:                                              ; preds = %908, %905
  %910 = load ptr, ptr %77, align 8, !noalias !28
  %911 = load i64, ptr %910, align 8, !noalias !28
  %912 = load ptr, ptr %129, align 8, !noalias !28
  %913 = load ptr, ptr %131, align 8, !noalias !28
  %914 = load ptr, ptr %132, align 8, !noalias !28
  %915 = inttoptr i64 %911 to ptr
  %916 = load ptr, ptr %915, align 8, !noalias !28
  %917 = tail call i32 %916(ptr noundef %912, ptr noundef %898, ptr noundef %913, ptr noundef %914, ptr noundef %893) #9, !noalias !28
  %918 = sext i32 %917 to i64
  %919 = icmp slt i32 %917, 0
  %920 = select i1 %919, i64 %918, i64 %881
  %921 = and i64 %878, %918
  %922 = or i64 %921, %880
  %923 = xor i64 %918, -1
  %924 = and i64 %878, %923
  %925 = add nuw nsw i64 %879, 1
  %926 = icmp ult i64 %879, 2
  %927 = icmp ne i64 %924, 0
  %928 = select i1 %926, i1 %927, i1 false
  br i1 %928, label %877, label %941, !llvm.loop !32

929:                                              ; preds = %883, %929
  %930 = phi i64 [ 0, %883 ], [ %939, %929 ]
  %931 = load ptr, ptr %126, align 8, !noalias !28
  %932 = load ptr, ptr %78, align 8, !noalias !28
  %933 = getelementptr inbounds double, ptr %932, i64 %930
  %934 = load double, ptr %933, align 8, !noalias !28
  %935 = getelementptr double, ptr %885, i64 %930
  %936 = load double, ptr %935, align 8, !noalias !28
  %937 = fadd double %934, %936
  %938 = getelementptr inbounds double, ptr %931, i64 %930
  store double %937, ptr %938, align 8, !noalias !28
  %939 = add nuw nsw i64 %930, 1
  %940 = icmp eq i64 %939, %872
  br i1 %940, label %886, label %929, !llvm.loop !33

941:                                              ; preds = %909, %850
  %942 = phi double [ %860, %850 ], [ %890, %909 ]
  %943 = phi i64 [ %857, %850 ], [ %920, %909 ]
  %944 = phi i64 [ %856, %850 ], [ %922, %909 ]
  %945 = phi i64 [ %869, %850 ], [ %924, %909 ]
  %946 = icmp eq i64 %945, 0
  br i1 %946, label %947, label %951

947:                                              ; preds = %941
  %948 = or i64 %869, %853
  %949 = xor i64 %948, -1
  %950 = and i64 %855, %949
  br label %1307

951:                                              ; preds = %941
  %952 = load ptr, ptr %77, align 8, !noalias !28
  %953 = getelementptr inbounds i8, ptr %952, i64 8
  %954 = load i64, ptr %953, align 8, !noalias !28
  %955 = load ptr, ptr %133, align 8, !noalias !28
  %956 = load ptr, ptr %125, align 8, !noalias !28
  %957 = icmp sgt i64 %954, 0
  br i1 %957, label %958, label %1036

958:                                              ; preds = %951
  %959 = shl nuw nsw i64 %954, 1
  br label %960

960:                                              ; preds = %958, %960
  %961 = phi i32 [ 1, %958 ], [ %976, %960 ]
  %962 = phi i64 [ 0, %958 ], [ %1034, %960 ]
  %963 = phi double [ 0.000000e+00, %958 ], [ %1033, %960 ]
  %964 = getelementptr inbounds double, ptr %955, i64 %962
  %965 = load double, ptr %964, align 8, !noalias !28
  %966 = add nuw nsw i64 %962, %954
  %967 = getelementptr inbounds double, ptr %955, i64 %966
  %968 = load double, ptr %967, align 8, !noalias !28
  %969 = fadd double %965, %968
  %970 = add nuw nsw i64 %962, %959
  %971 = getelementptr inbounds double, ptr %955, i64 %970
  %972 = load double, ptr %971, align 8, !noalias !28
  %973 = fadd double %969, %972
  %974 = tail call double @llvm.fabs.f64(double %973)
  %975 = fcmp one double %974, 0x7FF0000000000000
  %976 = select i1 %975, i32 %961, i32 0
  %977 = getelementptr inbounds double, ptr %956, i64 %966
  %978 = load double, ptr %977, align 8, !noalias !28
  %979 = getelementptr inbounds double, ptr %956, i64 %970
  %980 = load double, ptr %979, align 8, !noalias !28
  %981 = fmul double %965, 0xC010B70201A79C46
  %982 = fmul double %968, 0x3FD4F8C15DA84E86
  %983 = fsub double %981, %982
  %984 = fmul double %972, 0x3FDE810014C55221
  %985 = fadd double %983, %984
  %986 = fmul double %965, 0x3FE017885A24A7F2
  %987 = fmul double %968, 0x4004934E6FCAA598
  %988 = fsub double %986, %987
  %989 = fmul double %972, 0x3FE312C0CF7BDFD1
  %990 = fadd double %988, %989
  %991 = fmul double %965, 0x4010B70201A79C46
  %992 = fmul double %968, 0x3FD4F8C15DA84E86
  %993 = fadd double %991, %992
  %994 = fmul double %972, 0x3FE0BF7FF59D56EF
  %995 = fadd double %993, %994
  %996 = getelementptr inbounds double, ptr %956, i64 %962
  %997 = load double, ptr %996, align 8, !noalias !28
  %998 = fmul double %845, %997
  %999 = fsub double %995, %998
  %1000 = fmul double %980, %846
  %1001 = tail call double @llvm.fma.f64(double %843, double %978, double %1000)
  %1002 = fmul double %844, %978
  %1003 = tail call double @llvm.fma.f64(double %843, double %980, double %1002)
  %1004 = fsub double %985, %1001
  %1005 = fsub double %990, %1003
  %1006 = load ptr, ptr %134, align 8, !noalias !28
  %1007 = getelementptr inbounds double, ptr %1006, i64 %962
  store double %999, ptr %1007, align 8, !noalias !28
  %1008 = load ptr, ptr %135, align 8, !noalias !28
  %1009 = shl nuw nsw i64 %962, 1
  %1010 = getelementptr inbounds double, ptr %1008, i64 %1009
  store double %1004, ptr %1010, align 8, !noalias !28
  %1011 = or disjoint i64 %1009, 1
  %1012 = getelementptr inbounds double, ptr %1008, i64 %1011
  store double %1005, ptr %1012, align 8, !noalias !28
  %1013 = load ptr, ptr %78, align 8, !noalias !28
  %1014 = getelementptr inbounds double, ptr %1013, i64 %962
  %1015 = load double, ptr %1014, align 8, !noalias !28
  %1016 = tail call double @llvm.fabs.f64(double %999)
  %1017 = tail call double @llvm.fabs.f64(double %1004)
  %1018 = tail call double @llvm.fabs.f64(double %1005)
  %1019 = fadd double %1018, %1017
  %1020 = fadd double %1016, %1019
  %1021 = fmul double %519, %1020
  %1022 = load ptr, ptr %136, align 8, !noalias !28
  %1023 = getelementptr inbounds double, ptr %1022, i64 %962
  %1024 = load double, ptr %1023, align 8, !noalias !28
  %1025 = load ptr, ptr %80, align 8, !noalias !28
  %1026 = getelementptr inbounds double, ptr %1025, i64 %962
  %1027 = load double, ptr %1026, align 8, !noalias !28
  %1028 = tail call double @llvm.fabs.f64(double %1015)
  %1029 = fmul double %1028, %1027
  %1030 = fadd double %1024, %1029
  %1031 = fdiv double %1021, %1030
  %1032 = fmul double %1031, %1031
  %1033 = fadd double %963, %1032
  %1034 = add nuw nsw i64 %962, 1
  %1035 = icmp eq i64 %1034, %954
  br i1 %1035, label %1036, label %960, !llvm.loop !34

1036:                                             ; preds = %960, %951
  %1037 = phi double [ 0.000000e+00, %951 ], [ %1033, %960 ]
  %1038 = phi i32 [ 1, %951 ], [ %976, %960 ]
  %1039 = zext nneg i32 %1038 to i64
  %1040 = xor i64 %1039, 4294967295
  %1041 = and i64 %945, %1040
  %1042 = icmp eq i64 %1041, 0
  %1043 = select i1 %1042, double %859, double 0x7FF0000000000000
  %1044 = load ptr, ptr %77, align 8, !noalias !28
  %1045 = getelementptr inbounds i8, ptr %1044, i64 8
  %1046 = load i64, ptr %1045, align 8, !noalias !28
  %1047 = load i64, ptr %138, align 8, !noalias !28
  %1048 = load ptr, ptr %79, align 8, !noalias !28
  %1049 = getelementptr inbounds i8, ptr %1048, i64 40
  %1050 = load i64, ptr %1049, align 8, !noalias !28
  %1051 = load ptr, ptr %139, align 8, !noalias !28
  %1052 = load ptr, ptr %140, align 8, !noalias !28
  %1053 = load ptr, ptr %141, align 8, !noalias !28
  %1054 = load ptr, ptr %137, align 8, !noalias !28
  tail call fastcc void @real_solve(ptr noundef %1053, i64 noundef %1047, ptr noundef %1054, ptr noundef %1051) #8, !noalias !28
  %1055 = load ptr, ptr %142, align 8, !noalias !28
  %1056 = load ptr, ptr %143, align 8, !noalias !28
  tail call fastcc void @pair_solve(ptr noundef %1055, i64 noundef %1047, ptr noundef %1056, ptr noundef %1052) #8, !noalias !28
  %1057 = icmp sgt i64 %1050, 0
  br i1 %1057, label %1058, label %1066

1058:                                             ; preds = %1036
  %1059 = load ptr, ptr %141, align 8, !noalias !28
  %1060 = load ptr, ptr %137, align 8, !noalias !28
  %1061 = getelementptr inbounds double, ptr %1051, i64 %1047
  tail call fastcc void @real_solve_columns(ptr noundef %1059, i64 noundef %1047, ptr noundef %1060, ptr noundef %1061, i64 noundef %1050) #8, !noalias !28
  %1062 = load ptr, ptr %142, align 8, !noalias !28
  %1063 = load ptr, ptr %143, align 8, !noalias !28
  %1064 = shl nsw i64 %1047, 4
  %1065 = getelementptr inbounds i8, ptr %1052, i64 %1064
  tail call fastcc void @pair_solve_columns(ptr noundef %1062, i64 noundef %1047, ptr noundef %1063, ptr noundef %1065, i64 noundef %1050) #8, !noalias !28
  br label %1066

1066:                                             ; preds = %1058, %1036
  %1067 = icmp sgt i64 %1046, 0
  br i1 %1067, label %1068, label %1103

1068:                                             ; preds = %1066
  %1069 = load ptr, ptr %78, align 8, !noalias !28
  %1070 = load ptr, ptr %144, align 8, !noalias !28
  %1071 = load ptr, ptr %80, align 8, !noalias !28
  br label %1072

1072:                                             ; preds = %1068, %1072
  %1073 = phi double [ 0.000000e+00, %1068 ], [ %1100, %1072 ]
  %1074 = phi i64 [ 0, %1068 ], [ %1101, %1072 ]
  %1075 = getelementptr inbounds double, ptr %1069, i64 %1074
  %1076 = load double, ptr %1075, align 8, !noalias !28
  %1077 = getelementptr inbounds double, ptr %1070, i64 %1074
  %1078 = load double, ptr %1077, align 8, !noalias !28
  %1079 = getelementptr inbounds double, ptr %1071, i64 %1074
  %1080 = load double, ptr %1079, align 8, !noalias !28
  %1081 = tail call double @llvm.fabs.f64(double %1076)
  %1082 = fmul double %1081, %1080
  %1083 = fadd double %1078, %1082
  %1084 = getelementptr inbounds double, ptr %1051, i64 %1074
  %1085 = load double, ptr %1084, align 8, !noalias !28
  %1086 = fdiv double %1085, %1083
  %1087 = shl nuw nsw i64 %1074, 1
  %1088 = getelementptr inbounds double, ptr %1052, i64 %1087
  %1089 = load double, ptr %1088, align 8, !noalias !28
  %1090 = or disjoint i64 %1087, 1
  %1091 = getelementptr inbounds double, ptr %1052, i64 %1090
  %1092 = load double, ptr %1091, align 8, !noalias !28
  %1093 = fdiv double %1089, %1083
  %1094 = fdiv double %1092, %1083
  %1095 = fmul double %1086, %1086
  %1096 = fmul double %1093, %1093
  %1097 = fadd double %1095, %1096
  %1098 = fmul double %1094, %1094
  %1099 = fadd double %1097, %1098
  %1100 = fadd double %1073, %1099
  %1101 = add nuw nsw i64 %1074, 1
  %1102 = icmp eq i64 %1101, %1046
  br i1 %1102, label %1103, label %1072, !llvm.loop !35

1103:                                             ; preds = %1072, %1066
  %1104 = phi double [ 0.000000e+00, %1066 ], [ %1100, %1072 ]
  %1105 = mul nsw i64 %1046, 3
  %1106 = sitofp i64 %1105 to double
  %1107 = fdiv double %1104, %1106
  %1108 = tail call double @llvm.sqrt.f64(double %1107)
  %1109 = fcmp oeq double %1108, 0.000000e+00
  %1110 = fcmp ogt double %1037, 0.000000e+00
  %1111 = and i1 %1110, %1109
  %1112 = zext i1 %1111 to i64
  %1113 = xor i64 %1112, -1
  %1114 = and i64 %1039, %1113
  %1115 = and i64 %1114, %945
  %1116 = xor i64 %855, -1
  %1117 = and i64 %1115, %1116
  %1118 = trunc nuw nsw i64 %1117 to i32
  %1119 = fcmp ogt double %851, 0.000000e+00
  %1120 = and i32 %1118, 1
  %1121 = select i1 %1119, i32 %1120, i32 0
  %1122 = fdiv double %1108, %851
  %1123 = icmp eq i32 %1121, 0
  %1124 = select i1 %1123, double %1043, double %1122
  %1125 = fsub double 1.000000e+00, %1124
  %1126 = fdiv double %1108, %1125
  %1127 = icmp ult i64 %854, 5
  br i1 %1127, label %1220, label %1128

1128:                                             ; preds = %1220, %1103
  %1129 = phi double [ %1126, %1103 ], [ %1223, %1220 ]
  %1130 = fcmp oge double %1124, 1.000000e+00
  %1131 = fcmp ogt double %1129, %417
  %1132 = or i1 %1130, %1131
  %1133 = xor i32 %1121, -1
  %1134 = zext i32 %1133 to i64
  %1135 = select i1 %1132, i64 %1134, i64 2147483647
  %1136 = and i64 %1135, %1115
  %1137 = xor i64 %1136, -1
  %1138 = and i64 %869, %1137
  %1139 = or i64 %1138, %853
  %1140 = load ptr, ptr %77, align 8, !noalias !28
  %1141 = getelementptr inbounds i8, ptr %1140, i64 8
  %1142 = load i64, ptr %1141, align 8, !noalias !28
  %1143 = load ptr, ptr %124, align 8, !noalias !28
  %1144 = load ptr, ptr %125, align 8, !noalias !28
  %1145 = icmp sgt i64 %1142, 0
  br i1 %1145, label %1146, label %1206

1146:                                             ; preds = %1128
  %1147 = icmp eq i64 %1136, 0
  %1148 = getelementptr double, ptr %1144, i64 %1142
  %1149 = shl i64 %1142, 4
  %1150 = getelementptr i8, ptr %1144, i64 %1149
  %1151 = icmp eq i64 %1136, 0
  br label %1152

1152:                                             ; preds = %1146, %1181
  %1153 = phi i64 [ 0, %1146 ], [ %1182, %1181 ]
  %1154 = load ptr, ptr %140, align 8, !noalias !28
  %1155 = shl nuw nsw i64 %1153, 1
  %1156 = getelementptr inbounds double, ptr %1154, i64 %1155
  %1157 = load double, ptr %1156, align 8, !noalias !28
  %1158 = or disjoint i64 %1155, 1
  %1159 = getelementptr inbounds double, ptr %1154, i64 %1158
  %1160 = load double, ptr %1159, align 8, !noalias !28
  %1161 = load ptr, ptr %139, align 8, !noalias !28
  %1162 = getelementptr inbounds double, ptr %1161, i64 %1153
  %1163 = load double, ptr %1162, align 8, !noalias !28
  store double %1163, ptr %4, align 16, !noalias !28
  store double %1157, ptr %145, align 8, !noalias !28
  store double %1160, ptr %146, align 16, !noalias !28
  %1164 = getelementptr double, ptr %1144, i64 %1153
  br label %1170

1165:                                             ; preds = %1170
  %1166 = getelementptr inbounds double, ptr %1144, i64 %1153
  %1167 = getelementptr double, ptr %1148, i64 %1153
  %1168 = getelementptr double, ptr %1150, i64 %1153
  %1169 = getelementptr double, ptr %1143, i64 %1153
  br label %1184

1170:                                             ; preds = %1152, %1170
  %1171 = phi i64 [ 0, %1152 ], [ %1179, %1170 ]
  %1172 = mul nuw nsw i64 %1142, %1171
  %1173 = getelementptr double, ptr %1164, i64 %1172
  %1174 = load double, ptr %1173, align 8, !noalias !28
  %1175 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %1171
  %1176 = load double, ptr %1175, align 8, !noalias !28
  %1177 = fadd double %1174, %1176
  %1178 = select i1 %1147, double %1174, double %1177
  store double %1178, ptr %1173, align 8, !noalias !28
  %1179 = add nuw nsw i64 %1171, 1
  %1180 = icmp eq i64 %1179, 3
  br i1 %1180, label %1165, label %1170, !llvm.loop !36

1181:                                             ; preds = %1184
  %1182 = add nuw nsw i64 %1153, 1
  %1183 = icmp eq i64 %1182, %1142
  br i1 %1183, label %1206, label %1152, !llvm.loop !37

1184:                                             ; preds = %1165, %1184
  %1185 = phi i64 [ 0, %1165 ], [ %1204, %1184 ]
  %1186 = mul nuw nsw i64 %1142, %1185
  %1187 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1185
  %1188 = load double, ptr %1187, align 8, !noalias !28
  %1189 = load double, ptr %1166, align 8, !noalias !28
  %1190 = fmul double %1188, %1189
  %1191 = getelementptr inbounds i8, ptr %1187, i64 8
  %1192 = load double, ptr %1191, align 8, !noalias !28
  %1193 = load double, ptr %1167, align 8, !noalias !28
  %1194 = fmul double %1192, %1193
  %1195 = fadd double %1190, %1194
  %1196 = getelementptr inbounds i8, ptr %1187, i64 16
  %1197 = load double, ptr %1196, align 8, !noalias !28
  %1198 = load double, ptr %1168, align 8, !noalias !28
  %1199 = fmul double %1197, %1198
  %1200 = fadd double %1195, %1199
  %1201 = getelementptr double, ptr %1169, i64 %1186
  %1202 = load double, ptr %1201, align 8, !noalias !28
  %1203 = select i1 %1151, double %1202, double %1200
  store double %1203, ptr %1201, align 8, !noalias !28
  %1204 = add nuw nsw i64 %1185, 1
  %1205 = icmp eq i64 %1204, 3
  br i1 %1205, label %1181, label %1184, !llvm.loop !38

1206:                                             ; preds = %1181, %1128
  %1207 = fdiv double %1124, %1125
  %1208 = fmul double %1108, %1207
  %1209 = fcmp olt double %1208, %417
  %1210 = and i1 %1119, %1209
  %1211 = or i1 %1109, %1210
  %1212 = and i64 %1116, 1
  %1213 = select i1 %1211, i64 %1212, i64 0
  %1214 = and i64 %1136, %1213
  %1215 = add nuw nsw i64 %854, 1
  %1216 = uitofp nneg i64 %1215 to double
  %1217 = icmp eq i64 %1214, 0
  %1218 = select i1 %1217, double %858, double %1216
  %1219 = or i64 %1214, %855
  br i1 %841, label %1226, label %1300

1220:                                             ; preds = %1103, %1220
  %1221 = phi i64 [ %1224, %1220 ], [ %854, %1103 ]
  %1222 = phi double [ %1223, %1220 ], [ %1126, %1103 ]
  %1223 = fmul double %1124, %1222
  %1224 = add nuw nsw i64 %1221, 1
  %1225 = icmp ult i64 %1221, 4
  br i1 %1225, label %1220, label %1128, !llvm.loop !39

1226:                                             ; preds = %1206
  %1227 = load i64, ptr %138, align 8, !noalias !28
  %1228 = load ptr, ptr %79, align 8, !noalias !28
  %1229 = getelementptr inbounds i8, ptr %1228, i64 40
  %1230 = load i64, ptr %1229, align 8, !noalias !28
  %1231 = load ptr, ptr %77, align 8, !noalias !28
  %1232 = getelementptr inbounds i8, ptr %1231, i64 8
  %1233 = load i64, ptr %1232, align 8, !noalias !28
  %1234 = load ptr, ptr %125, align 8, !noalias !28
  %1235 = icmp sgt i64 %1230, 0
  br i1 %1235, label %1236, label %1295

1236:                                             ; preds = %1226
  %1237 = icmp sgt i64 %1227, 0
  br label %1238

1238:                                             ; preds = %1236, %1246
  %1239 = phi double [ 0.000000e+00, %1236 ], [ %1254, %1246 ]
  %1240 = phi i64 [ 0, %1236 ], [ %1255, %1246 ]
  br i1 %1237, label %1241, label %1246

1241:                                             ; preds = %1238
  %1242 = add nuw i64 %1240, %1227
  %1243 = load ptr, ptr %139, align 8, !noalias !28
  %1244 = load ptr, ptr %78, align 8, !noalias !28
  %1245 = load ptr, ptr %140, align 8, !noalias !28
  br label %1257

1246:                                             ; preds = %1281, %1238
  %1247 = phi double [ 0.000000e+00, %1238 ], [ %1292, %1281 ]
  %1248 = phi double [ 0.000000e+00, %1238 ], [ %1282, %1281 ]
  %1249 = fcmp ule double %1247, 0.000000e+00
  %1250 = fdiv double %1248, %1247
  %1251 = select i1 %1249, double 1.000000e+00, double %1250
  %1252 = fmul double %1239, %1247
  %1253 = fcmp ule double %1248, %1252
  %1254 = select i1 %1253, double %1239, double %1251
  %1255 = add nuw nsw i64 %1240, 1
  %1256 = icmp eq i64 %1255, %1230
  br i1 %1256, label %1295, label %1238, !llvm.loop !40

1257:                                             ; preds = %1241, %1281
  %1258 = phi double [ 0.000000e+00, %1241 ], [ %1282, %1281 ]
  %1259 = phi double [ 0.000000e+00, %1241 ], [ %1292, %1281 ]
  %1260 = phi i64 [ 0, %1241 ], [ %1283, %1281 ]
  %1261 = mul nuw nsw i64 %1260, %1230
  %1262 = add i64 %1242, %1261
  %1263 = getelementptr inbounds double, ptr %1243, i64 %1262
  %1264 = load double, ptr %1263, align 8, !noalias !28
  %1265 = getelementptr inbounds double, ptr %1244, i64 %1262
  %1266 = load double, ptr %1265, align 8, !noalias !28
  %1267 = shl nsw i64 %1262, 1
  %1268 = getelementptr inbounds double, ptr %1245, i64 %1267
  %1269 = load double, ptr %1268, align 8, !noalias !28
  %1270 = or disjoint i64 %1267, 1
  %1271 = getelementptr inbounds double, ptr %1245, i64 %1270
  %1272 = load double, ptr %1271, align 8, !noalias !28
  %1273 = fmul double %1264, %1264
  %1274 = fmul double %1269, %1269
  %1275 = fmul double %1272, %1272
  %1276 = fadd double %1274, %1275
  %1277 = fadd double %1273, %1276
  %1278 = fmul double %1266, %1266
  %1279 = fadd double %1259, %1278
  %1280 = getelementptr double, ptr %1234, i64 %1262
  br label %1285

1281:                                             ; preds = %1285
  %1282 = fadd double %1258, %1277
  %1283 = add nuw nsw i64 %1260, 1
  %1284 = icmp eq i64 %1283, %1227
  br i1 %1284, label %1246, label %1257, !llvm.loop !41

1285:                                             ; preds = %1257, %1285
  %1286 = phi i64 [ 0, %1257 ], [ %1293, %1285 ]
  %1287 = phi double [ %1279, %1257 ], [ %1292, %1285 ]
  %1288 = mul nsw i64 %1233, %1286
  %1289 = getelementptr double, ptr %1280, i64 %1288
  %1290 = load double, ptr %1289, align 8, !noalias !28
  %1291 = fmul double %1290, %1290
  %1292 = fadd double %1287, %1291
  %1293 = add nuw nsw i64 %1286, 1
  %1294 = icmp eq i64 %1293, 3
  br i1 %1294, label %1281, label %1285, !llvm.loop !42

1295:                                             ; preds = %1246, %1226
  %1296 = phi double [ 0.000000e+00, %1226 ], [ %1254, %1246 ]
  %1297 = fcmp ole double %1296, %419
  %1298 = and i64 %1219, 1
  %1299 = select i1 %1297, i64 %1298, i64 0
  br label %1300

1300:                                             ; preds = %1295, %1206
  %1301 = phi i64 [ %1299, %1295 ], [ %1219, %1206 ]
  %1302 = xor i64 %1301, -1
  %1303 = and i64 %1136, %1302
  %1304 = icmp eq i64 %1303, 0
  %1305 = select i1 %1304, i32 2, i32 0
  %1306 = select i1 %1304, double %851, double %1108
  br label %1307

1307:                                             ; preds = %1300, %947
  %1308 = phi double [ %942, %947 ], [ %866, %1300 ]
  %1309 = phi double [ %859, %947 ], [ %865, %1300 ]
  %1310 = phi double [ %858, %947 ], [ %864, %1300 ]
  %1311 = phi i64 [ %943, %947 ], [ %863, %1300 ]
  %1312 = phi i64 [ %944, %947 ], [ %862, %1300 ]
  %1313 = phi i64 [ %950, %947 ], [ %861, %1300 ]
  %1314 = phi double [ %859, %947 ], [ %1124, %1300 ]
  %1315 = phi double [ %858, %947 ], [ %1218, %1300 ]
  %1316 = phi i64 [ %950, %947 ], [ %1219, %1300 ]
  %1317 = phi i32 [ 1, %947 ], [ %1305, %1300 ]
  %1318 = phi i64 [ %853, %947 ], [ %1139, %1300 ]
  %1319 = phi i64 [ %869, %947 ], [ %1303, %1300 ]
  %1320 = phi double [ %851, %947 ], [ %1306, %1300 ]
  %1321 = icmp eq i32 %1317, 0
  br i1 %1321, label %847, label %1322

1322:                                             ; preds = %1307, %847
  %1323 = phi i32 [ %1317, %1307 ], [ 2, %847 ]
  %1324 = icmp eq i32 %1323, 2
  br i1 %1324, label %1325, label %1328

1325:                                             ; preds = %1322
  %1326 = xor i64 %1318, -1
  %1327 = and i64 %1316, %1326
  br label %1328

1328:                                             ; preds = %1322, %1325
  %1329 = phi double [ %942, %1325 ], [ %1308, %1322 ]
  %1330 = phi double [ %1314, %1325 ], [ %1309, %1322 ]
  %1331 = phi double [ %1315, %1325 ], [ %1310, %1322 ]
  %1332 = phi i64 [ %943, %1325 ], [ %1311, %1322 ]
  %1333 = phi i64 [ %944, %1325 ], [ %1312, %1322 ]
  %1334 = phi i64 [ %1327, %1325 ], [ %1313, %1322 ]
  %1335 = fadd double %667, %1329
  %1336 = fcmp ogt double %1331, 2.000000e+00
  %1337 = fcmp ogt double %1330, 1.000000e-03
  %1338 = and i1 %1337, %1336
  %1339 = icmp eq i64 %1334, %745
  br i1 %1339, label %1407, label %1340

1340:                                             ; preds = %1328
  %1341 = xor i64 %1334, -1
  %1342 = and i64 %745, %1341
  %1343 = load ptr, ptr %79, align 8, !noalias !15
  %1344 = getelementptr inbounds i8, ptr %1343, i64 16
  %1345 = load i64, ptr %1344, align 8, !noalias !15
  %1346 = xor i64 %1333, -1
  %1347 = and i64 %1345, %1346
  %1348 = and i64 %1347, %1342
  %1349 = tail call double @llvm.fabs.f64(double %1330)
  %1350 = fcmp ueq double %1349, 0x7FF0000000000000
  %1351 = select i1 %1350, double 4.000000e+00, double 7.000000e+00
  %1352 = and i64 %1333, 4294967295
  %1353 = icmp eq i64 %1352, 0
  %1354 = select i1 %1353, double %1351, double 3.000000e+00
  %1355 = icmp eq i64 %1342, 0
  %1356 = select i1 %1355, double %744, double %1354
  %1357 = icmp eq i64 %1348, 0
  br i1 %1357, label %1378, label %1358

1358:                                             ; preds = %1340
  %1359 = load i64, ptr %147, align 8, !noalias !15
  %1360 = icmp sgt i64 %1359, 0
  br i1 %1360, label %1361, label %1373

1361:                                             ; preds = %1358, %1361
  %1362 = phi i32 [ %1369, %1361 ], [ 0, %1358 ]
  %1363 = phi i64 [ %1370, %1361 ], [ 0, %1358 ]
  %1364 = load ptr, ptr %148, align 8, !noalias !15
  %1365 = getelementptr inbounds double, ptr %1364, i64 %1363
  %1366 = load double, ptr %1365, align 8, !noalias !15
  %1367 = fcmp une double %1366, 0.000000e+00
  %1368 = zext i1 %1367 to i32
  %1369 = or i32 %1362, %1368
  store double 0.000000e+00, ptr %1365, align 8, !noalias !15
  %1370 = add nuw nsw i64 %1363, 1
  %1371 = load i64, ptr %147, align 8, !noalias !15
  %1372 = icmp slt i64 %1370, %1371
  br i1 %1372, label %1361, label %1373, !llvm.loop !43

1373:                                             ; preds = %1361, %1358
  %1374 = phi i32 [ 0, %1358 ], [ %1369, %1361 ]
  %1375 = zext nneg i32 %1374 to i64
  %1376 = and i64 %1348, %1375
  %1377 = xor i64 %1376, -1
  br label %1378

1378:                                             ; preds = %1340, %1373
  %1379 = phi i64 [ %1377, %1373 ], [ -1, %1340 ]
  %1380 = and i64 %1379, %1348
  %1381 = getelementptr inbounds i8, ptr %1343, i64 24
  %1382 = load i64, ptr %1381, align 8, !noalias !15
  %1383 = and i64 %1382, %1379
  store i64 %1383, ptr %1381, align 8, !noalias !15
  %1384 = xor i64 %1380, -1
  %1385 = load i64, ptr %1344, align 8, !noalias !15
  %1386 = and i64 %1385, %1384
  store i64 %1386, ptr %1344, align 8, !noalias !15
  %1387 = fmul double %519, 5.000000e-01
  %1388 = icmp eq i64 %1380, 0
  %1389 = select i1 %1388, double %743, double %1387
  %1390 = fmul double %519, 2.500000e-01
  %1391 = select i1 %1353, double %1389, double %1390
  %1392 = load ptr, ptr %116, align 8, !noalias !15
  %1393 = getelementptr inbounds i8, ptr %1392, i64 8
  %1394 = load double, ptr %1393, align 8, !noalias !15
  %1395 = select i1 %1353, double %1394, double 0.000000e+00
  store double %1395, ptr %1393, align 8, !noalias !15
  %1396 = and i64 %1379, %1342
  %1397 = load ptr, ptr %79, align 8, !noalias !15
  %1398 = getelementptr inbounds i8, ptr %1397, i64 8
  %1399 = load i64, ptr %1398, align 8, !noalias !15
  %1400 = xor i64 %1396, -1
  %1401 = and i64 %1399, %1400
  %1402 = getelementptr inbounds i8, ptr %1397, i64 16
  %1403 = load i64, ptr %1402, align 8, !noalias !15
  %1404 = xor i64 %1403, -1
  %1405 = and i64 %1396, %1404
  %1406 = or disjoint i64 %1405, %1401
  store i64 %1406, ptr %1398, align 8, !noalias !15
  br label %1407

1407:                                             ; preds = %1378, %1328
  %1408 = phi double [ %743, %1328 ], [ %1391, %1378 ]
  %1409 = phi double [ %744, %1328 ], [ %1356, %1378 ]
  %1410 = icmp eq i64 %1334, 0
  %1411 = icmp ne i64 %1332, 0
  %1412 = select i1 %1410, i1 true, i1 %1411
  br i1 %1412, label %1620, label %1413

1413:                                             ; preds = %1407
  %1414 = icmp sgt i64 %529, 0
  br i1 %1414, label %1415, label %1417

1415:                                             ; preds = %1413
  %1416 = shl i64 %529, 4
  br label %1606

1417:                                             ; preds = %1606, %1413
  %1418 = getelementptr inbounds i8, ptr %530, i64 32
  %1419 = load i64, ptr %1418, align 8, !noalias !15
  %1420 = load ptr, ptr %77, align 8, !noalias !15
  %1421 = getelementptr inbounds i8, ptr %1420, i64 8
  %1422 = load i64, ptr %1421, align 8, !noalias !15
  %1423 = load i64, ptr %151, align 8, !noalias !15
  %1424 = load ptr, ptr %152, align 8, !noalias !15
  %1425 = load ptr, ptr %153, align 8, !noalias !15
  %1426 = icmp sgt i64 %1422, 0
  br i1 %1426, label %1427, label %1429

1427:                                             ; preds = %1417
  %1428 = shl i64 %1422, 4
  br label %1443

1429:                                             ; preds = %1443, %1417
  %1430 = load ptr, ptr %155, align 8, !noalias !15
  %1431 = load ptr, ptr %150, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1430, i64 noundef %1423, ptr noundef %1431, ptr noundef %1425) #8, !noalias !15
  %1432 = load ptr, ptr %156, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %1425, ptr noundef %1432, ptr noundef nonnull %78, i64 noundef %1422) #8, !noalias !15
  %1433 = load double, ptr %5, align 8, !noalias !15
  %1434 = fcmp olt double %1433, 1.000000e+00
  %1435 = zext i1 %1434 to i64
  %1436 = xor i64 %1435, -1
  %1437 = and i64 %1419, %1436
  %1438 = and i64 %1437, %1334
  %1439 = and i64 %1334, %1435
  %1440 = icmp eq i64 %1438, 0
  br i1 %1440, label %1539, label %1441

1441:                                             ; preds = %1429
  %1442 = icmp sgt i64 %1422, 0
  br i1 %1442, label %1502, label %1468

1443:                                             ; preds = %1427, %1443
  %1444 = phi i64 [ 0, %1427 ], [ %1466, %1443 ]
  %1445 = load ptr, ptr %124, align 8, !noalias !15
  %1446 = getelementptr inbounds double, ptr %1445, i64 %1444
  %1447 = load double, ptr %1446, align 8, !noalias !15
  %1448 = fmul double %1447, 0x402418FD8BAFFE05
  %1449 = getelementptr double, ptr %1445, i64 %1422
  %1450 = getelementptr double, ptr %1449, i64 %1444
  %1451 = load double, ptr %1450, align 8, !noalias !15
  %1452 = fmul double %1451, 0x3FF61D41B2D54580
  %1453 = fsub double %1452, %1448
  %1454 = getelementptr i8, ptr %1445, i64 %1428
  %1455 = getelementptr double, ptr %1454, i64 %1444
  %1456 = load double, ptr %1455, align 8, !noalias !15
  %1457 = fmul double %1456, 0x3FD5555555555555
  %1458 = fsub double %1453, %1457
  %1459 = fdiv double %1458, %519
  %1460 = getelementptr inbounds double, ptr %1424, i64 %1444
  store double %1459, ptr %1460, align 8, !noalias !15
  %1461 = load ptr, ptr %154, align 8, !noalias !15
  %1462 = getelementptr inbounds double, ptr %1461, i64 %1444
  %1463 = load double, ptr %1462, align 8, !noalias !15
  %1464 = fadd double %1463, %1459
  %1465 = getelementptr inbounds double, ptr %1425, i64 %1444
  store double %1464, ptr %1465, align 8, !noalias !15
  %1466 = add nuw nsw i64 %1444, 1
  %1467 = icmp eq i64 %1466, %1422
  br i1 %1467, label %1429, label %1443, !llvm.loop !44

1468:                                             ; preds = %1502, %1441
  %1469 = and i64 %1438, 4294967295
  %1470 = icmp eq i64 %1469, 0
  %1471 = select i1 %1470, double 0.000000e+00, double 1.000000e+00
  %1472 = fadd double %1335, %1471
  %1473 = load ptr, ptr %158, align 8, !noalias !15
  %1474 = load ptr, ptr %159, align 8, !noalias !15
  %1475 = load ptr, ptr %160, align 8, !noalias !15
  store double %442, ptr %1475, align 8, !noalias !15
  %1476 = load ptr, ptr %77, align 8, !noalias !15
  %1477 = getelementptr inbounds i8, ptr %1476, i64 40
  %1478 = load i64, ptr %1477, align 8, !noalias !15
  %1479 = icmp eq i64 %1478, 0
  br i1 %1479, label %1481, label %1480

1480:                                             ; preds = %1468
  tail call fastcc void @settle(ptr noundef nonnull %77) #8, !noalias !15
  br label %1481

1481:                                             ; preds = %1480, %1468
  %1482 = load i64, ptr %161, align 8, !noalias !15
  %1483 = icmp sgt i64 %1482, 0
  br i1 %1483, label %1484, label %1485

1484:                                             ; preds = %1481
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !15
  br label %1485

1485:                                             ; preds = %1484, %1481
  %1486 = load ptr, ptr %77, align 8, !noalias !15
  %1487 = load i64, ptr %1486, align 8, !noalias !15
  %1488 = load ptr, ptr %160, align 8, !noalias !15
  %1489 = load ptr, ptr %162, align 8, !noalias !15
  %1490 = load ptr, ptr %163, align 8, !noalias !15
  %1491 = inttoptr i64 %1487 to ptr
  %1492 = load ptr, ptr %1491, align 8, !noalias !15
  %1493 = tail call i32 %1492(ptr noundef %1488, ptr noundef %1473, ptr noundef %1489, ptr noundef %1490, ptr noundef %1474) #9, !noalias !15
  %1494 = sext i32 %1493 to i64
  %1495 = icmp slt i32 %1493, 0
  %1496 = select i1 %1495, i64 %1494, i64 %1332
  %1497 = trunc i64 %1438 to i32
  %1498 = and i32 %1493, %1497
  %1499 = icmp eq i32 %1498, 0
  %1500 = select i1 %1499, double %1409, double 3.000000e+00
  %1501 = icmp sgt i64 %1422, 0
  br i1 %1501, label %1528, label %1514

1502:                                             ; preds = %1441, %1502
  %1503 = phi i64 [ %1512, %1502 ], [ 0, %1441 ]
  %1504 = load ptr, ptr %157, align 8, !noalias !15
  %1505 = load ptr, ptr %78, align 8, !noalias !15
  %1506 = getelementptr inbounds double, ptr %1505, i64 %1503
  %1507 = load double, ptr %1506, align 8, !noalias !15
  %1508 = getelementptr inbounds double, ptr %1425, i64 %1503
  %1509 = load double, ptr %1508, align 8, !noalias !15
  %1510 = fadd double %1507, %1509
  %1511 = getelementptr inbounds double, ptr %1504, i64 %1503
  store double %1510, ptr %1511, align 8, !noalias !15
  %1512 = add nuw nsw i64 %1503, 1
  %1513 = icmp eq i64 %1512, %1422
  br i1 %1513, label %1468, label %1502, !llvm.loop !45

1514:                                             ; preds = %1528, %1485
  %1515 = load ptr, ptr %155, align 8, !noalias !15
  %1516 = load ptr, ptr %150, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1515, i64 noundef %1423, ptr noundef %1516, ptr noundef %1425) #8, !noalias !15
  %1517 = load ptr, ptr %156, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1425, ptr noundef %1517, ptr noundef nonnull %78, i64 noundef %1422) #8, !noalias !15
  %1518 = load double, ptr %6, align 8, !noalias !15
  %1519 = xor i64 %1494, -1
  %1520 = and i64 %1438, %1519
  %1521 = fcmp olt double %1518, 1.000000e+00
  %1522 = and i64 %1520, 1
  %1523 = select i1 %1521, i64 %1522, i64 0
  %1524 = or i64 %1523, %1439
  %1525 = and i64 %1520, 4294967295
  %1526 = icmp eq i64 %1525, 0
  %1527 = select i1 %1526, double %1433, double %1518
  br label %1539

1528:                                             ; preds = %1485, %1528
  %1529 = phi i64 [ %1537, %1528 ], [ 0, %1485 ]
  %1530 = load ptr, ptr %159, align 8, !noalias !15
  %1531 = getelementptr inbounds double, ptr %1530, i64 %1529
  %1532 = load double, ptr %1531, align 8, !noalias !15
  %1533 = getelementptr inbounds double, ptr %1424, i64 %1529
  %1534 = load double, ptr %1533, align 8, !noalias !15
  %1535 = fadd double %1532, %1534
  %1536 = getelementptr inbounds double, ptr %1425, i64 %1529
  store double %1535, ptr %1536, align 8, !noalias !15
  %1537 = add nuw nsw i64 %1529, 1
  %1538 = icmp eq i64 %1537, %1422
  br i1 %1538, label %1514, label %1528, !llvm.loop !46

1539:                                             ; preds = %1429, %1514
  %1540 = phi double [ %1335, %1429 ], [ %1472, %1514 ]
  %1541 = phi i64 [ %1332, %1429 ], [ %1496, %1514 ]
  %1542 = phi i64 [ %1439, %1429 ], [ %1524, %1514 ]
  %1543 = phi double [ %1409, %1429 ], [ %1500, %1514 ]
  %1544 = phi double [ %1433, %1429 ], [ %1527, %1514 ]
  %1545 = fcmp olt double %1544, 1.000000e-10
  %1546 = select i1 %1545, double 1.000000e-10, double %1544
  %1547 = load ptr, ptr %116, align 8, !noalias !15
  %1548 = getelementptr inbounds i8, ptr %1547, i64 24
  %1549 = load double, ptr %1548, align 8, !noalias !15
  %1550 = fadd double %1331, 1.200000e+01
  %1551 = fdiv double 0x4027666666666667, %1550
  %1552 = tail call double @llvm.sqrt.f64(double %1546)
  %1553 = tail call double @llvm.sqrt.f64(double %1552)
  %1554 = fdiv double 1.000000e+00, %1553
  %1555 = fmul double %1551, %1554
  %1556 = fcmp ogt double %1555, 2.000000e-01
  %1557 = select i1 %1556, double %1555, double 2.000000e-01
  %1558 = tail call double @llvm.fabs.f64(double %1544)
  %1559 = fcmp ueq double %1558, 0x7FF0000000000000
  %1560 = select i1 %1559, double 2.500000e-01, double %1557
  %1561 = fmul double %519, %1560
  %1562 = getelementptr inbounds i8, ptr %1547, i64 16
  %1563 = load double, ptr %1562, align 8, !noalias !15
  %1564 = fdiv double %519, %1563
  %1565 = fdiv double %1549, %1546
  %1566 = tail call double @llvm.sqrt.f64(double %1565)
  %1567 = tail call double @llvm.sqrt.f64(double %1566)
  %1568 = fmul double %1564, %1567
  %1569 = fcmp ule double %1549, 0.000000e+00
  %1570 = fcmp olt double %1568, 1.000000e+00
  %1571 = select i1 %1570, double %1568, double 1.000000e+00
  %1572 = select i1 %1569, double 1.000000e+00, double %1571
  %1573 = fmul double %1555, %1572
  %1574 = fcmp olt double %1573, 1.000000e+01
  %1575 = select i1 %1574, double %1573, double 1.000000e+01
  %1576 = fcmp ule double %1575, 1.000000e+00
  %1577 = fcmp uge double %1575, 1.200000e+00
  %1578 = or i1 %1576, %1577
  %1579 = select i1 %1578, i1 true, i1 %1338
  %1580 = load double, ptr %1547, align 8, !noalias !15
  %1581 = fcmp ogt double %1575, 2.000000e-01
  %1582 = select i1 %1581, double %1575, double 2.000000e-01
  %1583 = fmul double %519, %1582
  %1584 = select i1 %1579, double %1583, double %1580
  %1585 = icmp eq i64 %1542, 0
  %1586 = select i1 %1585, double %1561, double %1584
  %1587 = and i64 %1334, 4294967295
  %1588 = icmp eq i64 %1587, 0
  %1589 = select i1 %1588, double %1408, double %1586
  %1590 = xor i64 %1542, -1
  %1591 = and i64 %1334, %1590
  %1592 = load ptr, ptr %79, align 8, !noalias !15
  %1593 = getelementptr inbounds i8, ptr %1592, i64 32
  %1594 = load i64, ptr %1593, align 8, !noalias !15
  %1595 = or i64 %1594, %1591
  store i64 %1595, ptr %1593, align 8, !noalias !15
  %1596 = load ptr, ptr %79, align 8, !noalias !15
  %1597 = getelementptr inbounds i8, ptr %1596, i64 8
  %1598 = load i64, ptr %1597, align 8, !noalias !15
  %1599 = xor i64 %1591, -1
  %1600 = and i64 %1598, %1599
  %1601 = getelementptr inbounds i8, ptr %1596, i64 16
  %1602 = load i64, ptr %1601, align 8, !noalias !15
  %1603 = xor i64 %1602, -1
  %1604 = and i64 %1591, %1603
  %1605 = or disjoint i64 %1604, %1600
  store i64 %1605, ptr %1597, align 8, !noalias !15
  br label %1620

1606:                                             ; preds = %1415, %1606
  %1607 = phi i64 [ 0, %1415 ], [ %1618, %1606 ]
  %1608 = load ptr, ptr %149, align 8, !noalias !15
  %1609 = load ptr, ptr %78, align 8, !noalias !15
  %1610 = getelementptr inbounds double, ptr %1609, i64 %1607
  %1611 = load double, ptr %1610, align 8, !noalias !15
  %1612 = load ptr, ptr %124, align 8, !noalias !15
  %1613 = getelementptr i8, ptr %1612, i64 %1416
  %1614 = getelementptr double, ptr %1613, i64 %1607
  %1615 = load double, ptr %1614, align 8, !noalias !15
  %1616 = fadd double %1611, %1615
  %1617 = getelementptr inbounds double, ptr %1608, i64 %1607
  store double %1616, ptr %1617, align 8, !noalias !15
  %1618 = add nuw nsw i64 %1607, 1
  %1619 = icmp eq i64 %1618, %529
  br i1 %1619, label %1417, label %1606, !llvm.loop !47

1620:                                             ; preds = %1539, %1407, %742, %655
  %1621 = phi double [ %449, %655 ], [ %449, %742 ], [ %1329, %1407 ], [ %1329, %1539 ]
  %1622 = phi double [ %448, %655 ], [ %448, %742 ], [ %1330, %1407 ], [ %1330, %1539 ]
  %1623 = phi double [ %447, %655 ], [ %447, %742 ], [ %1331, %1407 ], [ %1331, %1539 ]
  %1624 = phi i64 [ %446, %655 ], [ %446, %742 ], [ %1332, %1407 ], [ %1332, %1539 ]
  %1625 = phi i64 [ %445, %655 ], [ %445, %742 ], [ %1333, %1407 ], [ %1333, %1539 ]
  %1626 = phi i64 [ %444, %655 ], [ %444, %742 ], [ %1334, %1407 ], [ %1334, %1539 ]
  %1627 = phi i1 [ false, %655 ], [ false, %742 ], [ %1338, %1407 ], [ %1338, %1539 ]
  %1628 = phi double [ 2.000000e+00, %655 ], [ %744, %742 ], [ %1409, %1407 ], [ %1543, %1539 ]
  %1629 = phi double [ 0.000000e+00, %655 ], [ 0.000000e+00, %742 ], [ 0.000000e+00, %1407 ], [ %1544, %1539 ]
  %1630 = phi double [ %443, %655 ], [ %743, %742 ], [ %1408, %1407 ], [ %1589, %1539 ]
  %1631 = phi double [ %638, %655 ], [ %667, %742 ], [ %1335, %1407 ], [ %1540, %1539 ]
  %1632 = phi i64 [ 0, %655 ], [ %681, %742 ], [ %681, %1407 ], [ %681, %1539 ]
  %1633 = phi i64 [ 1, %655 ], [ 0, %742 ], [ %1332, %1407 ], [ %1541, %1539 ]
  %1634 = phi i64 [ 0, %655 ], [ 0, %742 ], [ 0, %1407 ], [ %1542, %1539 ]
  %1635 = zext i1 %1627 to i64
  %1636 = fptosi double %1631 to i64
  %1637 = load i64, ptr %420, align 8
  %1638 = add nsw i64 %1637, %1636
  store i64 %1638, ptr %420, align 8
  %1639 = load i64, ptr %421, align 8
  %1640 = add nsw i64 %1639, %533
  store i64 %1640, ptr %421, align 8
  %1641 = load i64, ptr %422, align 8
  %1642 = add nsw i64 %1641, %1632
  store i64 %1642, ptr %422, align 8
  %1643 = icmp eq i64 %1633, 0
  br i1 %1643, label %1644, label %2230

1644:                                             ; preds = %1620
  %1645 = icmp eq i64 %1634, 0
  br i1 %1645, label %1646, label %1650

1646:                                             ; preds = %1644
  %1647 = load i64, ptr %407, align 8
  %1648 = add nsw i64 %1647, 1
  store i64 %1648, ptr %407, align 8
  %1649 = fptosi double %1628 to i64
  store i64 %1649, ptr %430, align 8
  br label %2230, !llvm.loop !48

1650:                                             ; preds = %1644
  br i1 %243, label %1651, label %1679

1651:                                             ; preds = %1650
  %1652 = load ptr, ptr %164, align 8
  %1653 = load ptr, ptr %78, align 8
  %1654 = load ptr, ptr %85, align 8
  %1655 = getelementptr inbounds i8, ptr %1654, i64 56
  %1656 = load i64, ptr %1655, align 8
  %1657 = inttoptr i64 %1656 to ptr
  %1658 = tail call i64 %1657(ptr noundef %0, double noundef %518, ptr noundef %1652, ptr noundef %1653) #9
  %1659 = icmp eq i64 %1658, 0
  br i1 %1659, label %1679, label %1660

1660:                                             ; preds = %1651
  %1661 = load i64, ptr %407, align 8
  %1662 = add nsw i64 %1661, 1
  store i64 %1662, ptr %407, align 8
  store i64 6, ptr %423, align 8
  %1663 = fmul double %519, 2.500000e-01
  %1664 = load ptr, ptr %79, align 8
  %1665 = getelementptr inbounds i8, ptr %1664, i64 32
  %1666 = load i64, ptr %1665, align 8
  %1667 = or i64 %1666, 1
  store i64 %1667, ptr %1665, align 8
  %1668 = load ptr, ptr %79, align 8
  %1669 = getelementptr inbounds i8, ptr %1668, i64 8
  %1670 = load i64, ptr %1669, align 8
  %1671 = and i64 %1670, -2
  %1672 = getelementptr inbounds i8, ptr %1668, i64 16
  %1673 = load i64, ptr %1672, align 8
  %1674 = and i64 %1673, 1
  %1675 = or disjoint i64 %1674, %1671
  %1676 = xor i64 %1675, 1
  store i64 %1676, ptr %1669, align 8
  %1677 = load ptr, ptr %165, align 8
  %1678 = getelementptr inbounds i8, ptr %1677, i64 8
  store double 0.000000e+00, ptr %1678, align 8
  br label %2230, !llvm.loop !48

1679:                                             ; preds = %1651, %1650
  %1680 = load i64, ptr %406, align 8
  %1681 = add nsw i64 %1680, 1
  store i64 %1681, ptr %406, align 8
  store double %518, ptr %230, align 8
  store double %519, ptr %424, align 8
  %1682 = load ptr, ptr %77, align 8
  %1683 = getelementptr inbounds i8, ptr %1682, i64 8
  %1684 = load i64, ptr %1683, align 8
  %1685 = load i64, ptr %166, align 8
  %1686 = load ptr, ptr %167, align 8
  %1687 = load ptr, ptr %168, align 8
  %1688 = load ptr, ptr %169, align 8
  %1689 = load ptr, ptr %170, align 8
  br label %1705

1690:                                             ; preds = %1705
  %1691 = icmp sgt i64 %1684, 0
  br i1 %1691, label %1692, label %1765

1692:                                             ; preds = %1690
  %1693 = load double, ptr %9, align 16
  %1694 = load double, ptr %171, align 8
  %1695 = getelementptr double, ptr %1686, i64 %1684
  %1696 = load double, ptr %172, align 16
  %1697 = shl i64 %1684, 4
  %1698 = getelementptr i8, ptr %1686, i64 %1697
  %1699 = load double, ptr %10, align 16
  %1700 = load double, ptr %173, align 8
  %1701 = load double, ptr %174, align 16
  %1702 = getelementptr inbounds double, ptr %1687, i64 %1685
  %1703 = shl nsw i64 %1685, 4
  %1704 = getelementptr inbounds i8, ptr %1687, i64 %1703
  br label %1716

1705:                                             ; preds = %1679, %1705
  %1706 = phi i64 [ 0, %1679 ], [ %1714, %1705 ]
  %1707 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1706
  %1708 = getelementptr inbounds i8, ptr %1707, i64 8
  %1709 = load double, ptr %1708, align 8
  %1710 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1706
  store double %1709, ptr %1710, align 8
  %1711 = getelementptr inbounds i8, ptr %1707, i64 16
  %1712 = load double, ptr %1711, align 8
  %1713 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %1706
  store double %1712, ptr %1713, align 8
  %1714 = add nuw nsw i64 %1706, 1
  %1715 = icmp eq i64 %1714, 3
  br i1 %1715, label %1690, label %1705, !llvm.loop !49

1716:                                             ; preds = %1692, %1753
  %1717 = phi i64 [ 0, %1692 ], [ %1754, %1753 ]
  %1718 = getelementptr inbounds double, ptr %1686, i64 %1717
  %1719 = load double, ptr %1718, align 8
  %1720 = fmul double %1693, %1719
  %1721 = getelementptr double, ptr %1695, i64 %1717
  %1722 = load double, ptr %1721, align 8
  %1723 = fmul double %1694, %1722
  %1724 = fadd double %1720, %1723
  %1725 = getelementptr double, ptr %1698, i64 %1717
  %1726 = load double, ptr %1725, align 8
  %1727 = fmul double %1696, %1726
  %1728 = fadd double %1724, %1727
  %1729 = fmul double %1719, %1699
  %1730 = fmul double %1722, %1700
  %1731 = fadd double %1729, %1730
  %1732 = fmul double %1726, %1701
  %1733 = fadd double %1731, %1732
  %1734 = load ptr, ptr %175, align 8
  %1735 = getelementptr inbounds double, ptr %1734, i64 %1717
  %1736 = load double, ptr %1735, align 8
  %1737 = load ptr, ptr %78, align 8
  %1738 = getelementptr inbounds double, ptr %1737, i64 %1717
  %1739 = load double, ptr %1738, align 8
  %1740 = fsub double %1736, %1739
  %1741 = getelementptr inbounds double, ptr %1687, i64 %1717
  store double %1740, ptr %1741, align 8
  %1742 = fneg double %1728
  %1743 = fsub double %1742, %1733
  %1744 = getelementptr inbounds double, ptr %1702, i64 %1717
  store double %1743, ptr %1744, align 8
  %1745 = fneg double %1733
  %1746 = getelementptr inbounds double, ptr %1704, i64 %1717
  store double %1745, ptr %1746, align 8
  %1747 = load ptr, ptr %78, align 8
  %1748 = getelementptr inbounds double, ptr %1747, i64 %1717
  %1749 = load double, ptr %1748, align 8
  %1750 = getelementptr inbounds double, ptr %1688, i64 %1717
  store double %1749, ptr %1750, align 8
  %1751 = getelementptr double, ptr %1687, i64 %1717
  %1752 = getelementptr double, ptr %1688, i64 %1717
  br label %1756

1753:                                             ; preds = %1756
  %1754 = add nuw nsw i64 %1717, 1
  %1755 = icmp eq i64 %1754, %1684
  br i1 %1755, label %1765, label %1716, !llvm.loop !50

1756:                                             ; preds = %1716, %1756
  %1757 = phi i64 [ 0, %1716 ], [ %1758, %1756 ]
  %1758 = add nuw nsw i64 %1757, 1
  %1759 = mul nuw nsw i64 %1684, %1758
  %1760 = mul nsw i64 %1685, %1757
  %1761 = getelementptr double, ptr %1751, i64 %1760
  %1762 = load double, ptr %1761, align 8
  %1763 = getelementptr double, ptr %1752, i64 %1759
  store double %1762, ptr %1763, align 8
  %1764 = icmp eq i64 %1758, 3
  br i1 %1764, label %1753, label %1756, !llvm.loop !51

1765:                                             ; preds = %1753, %1690
  %1766 = fcmp olt double %1629, 1.000000e-10
  %1767 = select i1 %1766, double 1.000000e-10, double %1629
  %1768 = getelementptr inbounds i8, ptr %1689, i64 8
  store double %519, ptr %1768, align 8
  %1769 = getelementptr inbounds i8, ptr %1689, i64 16
  store double %519, ptr %1769, align 8
  %1770 = getelementptr inbounds i8, ptr %1689, i64 24
  store double %1767, ptr %1770, align 8
  %1771 = load ptr, ptr %79, align 8
  %1772 = getelementptr inbounds i8, ptr %1771, i64 8
  %1773 = load i64, ptr %1772, align 8
  %1774 = and i64 %1773, -2
  %1775 = or disjoint i64 %1774, %1635
  store i64 %1775, ptr %1772, align 8
  %1776 = load ptr, ptr %79, align 8
  %1777 = getelementptr inbounds i8, ptr %1776, i64 16
  %1778 = load i64, ptr %1777, align 8
  %1779 = and i64 %1778, -2
  store i64 %1779, ptr %1777, align 8
  %1780 = load ptr, ptr %79, align 8
  %1781 = getelementptr inbounds i8, ptr %1780, i64 32
  %1782 = load i64, ptr %1781, align 8
  %1783 = and i64 %1782, -2
  store i64 %1783, ptr %1781, align 8
  %1784 = load ptr, ptr %0, align 8
  %1785 = getelementptr inbounds i8, ptr %1784, i64 24
  %1786 = load i64, ptr %1785, align 8
  %1787 = load ptr, ptr %97, align 8
  %1788 = getelementptr inbounds i8, ptr %1787, i64 8
  %1789 = load i64, ptr %1788, align 8
  %1790 = icmp eq i64 %1789, 0
  br i1 %1790, label %1837, label %1791

1791:                                             ; preds = %1765
  %1792 = load i64, ptr %1787, align 8
  %1793 = load ptr, ptr %77, align 8
  %1794 = getelementptr inbounds i8, ptr %1793, i64 8
  %1795 = load i64, ptr %1794, align 8
  %1796 = load ptr, ptr %176, align 8
  %1797 = load i64, ptr %177, align 8
  %1798 = mul nsw i64 %1797, %1792
  %1799 = getelementptr inbounds double, ptr %1796, i64 %1798
  %1800 = getelementptr inbounds double, ptr %1799, i64 %1797
  store double %442, ptr %1799, align 8
  %1801 = getelementptr inbounds i8, ptr %1799, i64 8
  store double %519, ptr %1801, align 8
  store double %518, ptr %1800, align 8
  %1802 = getelementptr inbounds i8, ptr %1800, i64 8
  store double 0.000000e+00, ptr %1802, align 8
  %1803 = icmp sgt i64 %1795, 0
  br i1 %1803, label %1804, label %1807

1804:                                             ; preds = %1791
  %1805 = getelementptr i8, ptr %1799, i64 16
  %1806 = icmp sgt i64 %1786, 0
  br label %1810

1807:                                             ; preds = %1822, %1791
  %1808 = add nsw i64 %1792, 1
  %1809 = load ptr, ptr %97, align 8
  store i64 %1808, ptr %1809, align 8
  br label %1837

1810:                                             ; preds = %1804, %1822
  %1811 = phi i64 [ 0, %1804 ], [ %1823, %1822 ]
  %1812 = load ptr, ptr %78, align 8
  %1813 = getelementptr inbounds double, ptr %1812, i64 %1811
  %1814 = load double, ptr %1813, align 8
  %1815 = add nuw nsw i64 %1811, 2
  %1816 = getelementptr inbounds double, ptr %1799, i64 %1815
  store double %1814, ptr %1816, align 8
  %1817 = load ptr, ptr %178, align 8
  %1818 = getelementptr inbounds double, ptr %1817, i64 %1811
  %1819 = load double, ptr %1818, align 8
  %1820 = getelementptr inbounds double, ptr %1800, i64 %1815
  store double %1819, ptr %1820, align 8
  %1821 = getelementptr double, ptr %1805, i64 %1811
  br i1 %1806, label %1825, label %1822

1822:                                             ; preds = %1825, %1810
  %1823 = add nuw nsw i64 %1811, 1
  %1824 = icmp eq i64 %1823, %1795
  br i1 %1824, label %1807, label %1810, !llvm.loop !52

1825:                                             ; preds = %1810, %1825
  %1826 = phi i64 [ %1833, %1825 ], [ 0, %1810 ]
  %1827 = load ptr, ptr %179, align 8
  %1828 = load i64, ptr %180, align 8
  %1829 = mul nsw i64 %1828, %1826
  %1830 = getelementptr double, ptr %1827, i64 %1829
  %1831 = getelementptr double, ptr %1830, i64 %1811
  %1832 = load double, ptr %1831, align 8
  %1833 = add nuw nsw i64 %1826, 1
  %1834 = mul nuw nsw i64 %1833, %1795
  %1835 = getelementptr double, ptr %1821, i64 %1834
  store double %1832, ptr %1835, align 8
  %1836 = icmp eq i64 %1833, %1786
  br i1 %1836, label %1822, label %1825, !llvm.loop !53

1837:                                             ; preds = %1765, %1807
  br i1 %247, label %1838, label %1946

1838:                                             ; preds = %1837
  %1839 = load ptr, ptr %86, align 8
  %1840 = load ptr, ptr %77, align 8
  %1841 = getelementptr inbounds i8, ptr %1840, i64 8
  %1842 = load i64, ptr %1841, align 8
  %1843 = load ptr, ptr %181, align 8
  %1844 = getelementptr inbounds i8, ptr %1839, i64 32
  %1845 = load i64, ptr %1844, align 8
  %1846 = getelementptr inbounds double, ptr %1843, i64 %1845
  %1847 = load ptr, ptr %182, align 8
  %1848 = getelementptr inbounds i8, ptr %1839, i64 24
  %1849 = load i64, ptr %1848, align 8
  %1850 = icmp eq i64 %1849, 0
  br i1 %1850, label %1943, label %1851

1851:                                             ; preds = %1838
  %1852 = getelementptr inbounds i8, ptr %1839, i64 40
  %1853 = load i64, ptr %1852, align 8
  %1854 = icmp sgt i64 %1853, 0
  br i1 %1854, label %1855, label %1859

1855:                                             ; preds = %1851
  %1856 = getelementptr double, ptr %1847, i64 %1842
  %1857 = shl i64 %1842, 4
  %1858 = getelementptr i8, ptr %1847, i64 %1857
  br label %1913

1859:                                             ; preds = %1913, %1851
  %1860 = load ptr, ptr %184, align 8
  %1861 = load ptr, ptr %86, align 8
  %1862 = getelementptr inbounds i8, ptr %1861, i64 8
  %1863 = load i64, ptr %1862, align 8
  %1864 = load ptr, ptr %185, align 8
  %1865 = load ptr, ptr %181, align 8
  %1866 = getelementptr inbounds i8, ptr %1861, i64 32
  %1867 = load i64, ptr %1866, align 8
  %1868 = getelementptr inbounds i8, ptr %1861, i64 40
  %1869 = load i64, ptr %1868, align 8
  %1870 = getelementptr double, ptr %1865, i64 %1867
  %1871 = getelementptr double, ptr %1870, i64 %1869
  store double %519, ptr %1871, align 8
  %1872 = load ptr, ptr %184, align 8
  store double %442, ptr %1872, align 8
  %1873 = load ptr, ptr %86, align 8
  %1874 = getelementptr inbounds i8, ptr %1873, i64 24
  %1875 = load i64, ptr %1874, align 8
  %1876 = load ptr, ptr %78, align 8
  %1877 = load ptr, ptr %181, align 8
  %1878 = load ptr, ptr %186, align 8
  %1879 = inttoptr i64 %1875 to ptr
  %1880 = load ptr, ptr %1879, align 8
  %1881 = tail call i32 %1880(ptr noundef %1860, ptr noundef %1876, ptr noundef %1877, ptr noundef %1878, ptr noundef %1864) #9
  %1882 = icmp eq i32 %1881, 0
  br i1 %1882, label %1883, label %1943

1883:                                             ; preds = %1859
  %1884 = icmp slt i64 %1863, 1
  br i1 %1884, label %1910, label %1885

1885:                                             ; preds = %1883
  %1886 = load ptr, ptr %187, align 8
  %1887 = getelementptr double, ptr %1864, i64 %1863
  br label %1888

1888:                                             ; preds = %1885, %1906
  %1889 = phi i1 [ %1884, %1885 ], [ %1908, %1906 ]
  %1890 = phi i64 [ 0, %1885 ], [ %1907, %1906 ]
  %1891 = getelementptr inbounds i64, ptr %1886, i64 %1890
  %1892 = load i64, ptr %1891, align 8
  %1893 = and i64 %1892, 2
  %1894 = icmp eq i64 %1893, 0
  br i1 %1894, label %1895, label %1906

1895:                                             ; preds = %1888
  %1896 = getelementptr inbounds double, ptr %1864, i64 %1890
  %1897 = load double, ptr %1896, align 8
  %1898 = load ptr, ptr %188, align 8
  %1899 = getelementptr inbounds i64, ptr %1898, i64 %1890
  %1900 = load i64, ptr %1899, align 8
  %1901 = sitofp i64 %1900 to double
  %1902 = fmul double %1897, %1901
  %1903 = getelementptr double, ptr %1887, i64 %1890
  %1904 = load double, ptr %1903, align 8
  %1905 = fcmp ogt double %1902, %1904
  br i1 %1905, label %1906, label %1910

1906:                                             ; preds = %1895, %1888
  %1907 = add nuw nsw i64 %1890, 1
  %1908 = icmp sge i64 %1907, %1863
  %1909 = icmp eq i64 %1907, %1863
  br i1 %1909, label %1910, label %1888, !llvm.loop !54

1910:                                             ; preds = %1906, %1895, %1883
  %1911 = phi i1 [ %1884, %1883 ], [ %1908, %1906 ], [ %1889, %1895 ]
  %1912 = zext i1 %1911 to i32
  br label %1943

1913:                                             ; preds = %1855, %1913
  %1914 = phi i64 [ 0, %1855 ], [ %1940, %1913 ]
  %1915 = load ptr, ptr %183, align 8
  %1916 = getelementptr inbounds double, ptr %1915, i64 %1914
  %1917 = load double, ptr %1916, align 8
  %1918 = load ptr, ptr %78, align 8
  %1919 = getelementptr inbounds double, ptr %1918, i64 %1914
  %1920 = load double, ptr %1919, align 8
  %1921 = fsub double %1917, %1920
  %1922 = tail call double @llvm.fabs.f64(double %1921)
  %1923 = getelementptr inbounds double, ptr %1847, i64 %1914
  %1924 = load double, ptr %1923, align 8
  %1925 = tail call double @llvm.fabs.f64(double %1924)
  %1926 = getelementptr double, ptr %1856, i64 %1914
  %1927 = load double, ptr %1926, align 8
  %1928 = tail call double @llvm.fabs.f64(double %1927)
  %1929 = fcmp ogt double %1925, %1928
  %1930 = select i1 %1929, double %1925, double %1928
  %1931 = getelementptr double, ptr %1858, i64 %1914
  %1932 = load double, ptr %1931, align 8
  %1933 = tail call double @llvm.fabs.f64(double %1932)
  %1934 = fcmp ogt double %1930, %1933
  %1935 = select i1 %1934, double %1930, double %1933
  %1936 = fcmp ogt double %1935, %1922
  %1937 = select i1 %1936, double %1935, double %1922
  %1938 = fmul double %1937, 8.000000e+00
  %1939 = getelementptr inbounds double, ptr %1846, i64 %1914
  store double %1938, ptr %1939, align 8
  %1940 = add nuw nsw i64 %1914, 1
  %1941 = load i64, ptr %1852, align 8
  %1942 = icmp slt i64 %1940, %1941
  br i1 %1942, label %1913, label %1859, !llvm.loop !55

1943:                                             ; preds = %1910, %1859, %1838
  %1944 = phi i32 [ 0, %1838 ], [ 0, %1859 ], [ %1912, %1910 ]
  %1945 = icmp eq i32 %1944, 0
  br label %1946

1946:                                             ; preds = %1943, %1837
  %1947 = phi i1 [ false, %1837 ], [ %1945, %1943 ]
  br i1 %1947, label %1953, label %1948

1948:                                             ; preds = %1946
  %1949 = load i64, ptr %425, align 8
  %1950 = getelementptr inbounds double, ptr %236, i64 %1949
  %1951 = load double, ptr %1950, align 8
  %1952 = fcmp ugt double %1951, %518
  br i1 %1952, label %2178, label %1953

1953:                                             ; preds = %1948, %1946
  %1954 = load ptr, ptr %81, align 8
  br i1 %1947, label %1955, label %1966

1955:                                             ; preds = %1953
  %1956 = load ptr, ptr %86, align 8
  %1957 = getelementptr inbounds i8, ptr %1956, i64 16
  %1958 = load i64, ptr %1957, align 8
  %1959 = inttoptr i64 %1958 to ptr
  %1960 = tail call i64 %1959(ptr noundef %0, double noundef %442, double noundef %519) #9
  %1961 = icmp eq i64 %1960, -6
  br i1 %1961, label %1962, label %1963

1962:                                             ; preds = %1955
  store double %442, ptr %1954, align 8
  br label %2141

1963:                                             ; preds = %1955
  %1964 = getelementptr inbounds i8, ptr %1954, i64 48
  %1965 = load double, ptr %1964, align 8
  br label %1966

1966:                                             ; preds = %1963, %1953
  %1967 = phi double [ %1965, %1963 ], [ 1.000000e+00, %1953 ]
  %1968 = phi i64 [ %1960, %1963 ], [ 0, %1953 ]
  %1969 = fcmp oeq double %1967, 1.000000e+00
  br i1 %1969, label %1970, label %1972

1970:                                             ; preds = %1966
  %1971 = load double, ptr %1954, align 8
  br label %1975

1972:                                             ; preds = %1966
  %1973 = fmul double %519, %1967
  %1974 = fadd double %442, %1973
  br label %1975

1975:                                             ; preds = %1972, %1970
  %1976 = phi double [ %1971, %1970 ], [ %1974, %1972 ]
  %1977 = icmp eq i64 %1968, -4
  %1978 = select i1 %1977, i64 -4, i64 0
  br i1 %1977, label %2036, label %1979

1979:                                             ; preds = %1975
  %1980 = fcmp olt double %1967, 1.000000e+00
  %1981 = load ptr, ptr %77, align 8
  %1982 = getelementptr inbounds i8, ptr %1981, i64 8
  %1983 = load i64, ptr %1982, align 8
  %1984 = load i64, ptr %84, align 8
  %1985 = load ptr, ptr %83, align 8
  %1986 = load ptr, ptr %82, align 8
  %1987 = getelementptr inbounds i8, ptr %1986, i64 48
  %1988 = load i64, ptr %1987, align 8
  %1989 = icmp slt i64 %1988, %1984
  br i1 %1989, label %1990, label %2032

1990:                                             ; preds = %1979, %2028
  %1991 = phi i64 [ %2029, %2028 ], [ undef, %1979 ]
  %1992 = phi i64 [ %2030, %2028 ], [ %1988, %1979 ]
  %1993 = getelementptr inbounds double, ptr %1985, i64 %1992
  %1994 = load double, ptr %1993, align 8
  %1995 = fcmp olt double %1994, %1976
  %1996 = fcmp oeq double %1994, %1976
  %1997 = and i1 %1980, %1996
  %1998 = or i1 %1995, %1997
  br i1 %1998, label %1999, label %2032

1999:                                             ; preds = %1990
  %2000 = fsub double %1994, %442
  %2001 = fdiv double %2000, %519
  %2002 = mul nsw i64 %1992, %1983
  %2003 = getelementptr inbounds double, ptr %1, i64 %2002
  %2004 = load ptr, ptr %189, align 8
  %2005 = insertelement <8 x double> poison, double %2001, i64 0
  %2006 = shufflevector <8 x double> %2005, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2006, ptr %2004, align 8
  %2007 = load ptr, ptr %78, align 8
  %2008 = load ptr, ptr %168, align 8
  %2009 = load i64, ptr %166, align 8
  %2010 = load ptr, ptr %0, align 8
  %2011 = getelementptr inbounds i8, ptr %2010, i64 24
  %2012 = load i64, ptr %2011, align 8
  %2013 = load ptr, ptr %189, align 8
  %2014 = load ptr, ptr %77, align 8
  %2015 = getelementptr inbounds i8, ptr %2014, i64 16
  %2016 = load i64, ptr %2015, align 8
  tail call fastcc void @nested(ptr noundef %2003, ptr noundef %2007, ptr noundef %2008, i64 noundef %2009, i64 noundef %2012, ptr noundef %2013, i64 noundef %2016) #8
  %2017 = load ptr, ptr %85, align 8
  %2018 = load i64, ptr %2017, align 8
  %2019 = icmp eq i64 %2018, 1
  br i1 %2019, label %2020, label %2028

2020:                                             ; preds = %1999
  %2021 = load double, ptr %1993, align 8
  %2022 = getelementptr inbounds i8, ptr %2017, i64 56
  %2023 = load i64, ptr %2022, align 8
  %2024 = inttoptr i64 %2023 to ptr
  %2025 = tail call i64 %2024(ptr noundef %0, double noundef %2021, ptr noundef %2003, ptr noundef null) #9
  %2026 = icmp eq i64 %2025, 0
  %2027 = select i1 %2026, i64 %1991, i64 %2025
  br i1 %2026, label %2028, label %2036

2028:                                             ; preds = %2020, %1999
  %2029 = phi i64 [ %2027, %2020 ], [ %1991, %1999 ]
  %2030 = add i64 %1992, 1
  %2031 = icmp eq i64 %2030, %1984
  br i1 %2031, label %2032, label %1990, !llvm.loop !56

2032:                                             ; preds = %2028, %1990, %1979
  %2033 = phi i64 [ %1988, %1979 ], [ %1984, %2028 ], [ %1992, %1990 ]
  %2034 = load ptr, ptr %82, align 8
  %2035 = getelementptr inbounds i8, ptr %2034, i64 48
  store i64 %2033, ptr %2035, align 8
  br label %2036

2036:                                             ; preds = %2020, %2032, %1975
  %2037 = phi i64 [ %1978, %1975 ], [ 0, %2032 ], [ %2027, %2020 ]
  %2038 = icmp eq i64 %2037, 0
  %2039 = icmp ne i64 %1968, 0
  %2040 = fcmp olt double %1967, 1.000000e+00
  %2041 = and i1 %2040, %2038
  %2042 = and i1 %2039, %2041
  br i1 %2042, label %2043, label %2080

2043:                                             ; preds = %2036
  %2044 = load ptr, ptr %190, align 8
  %2045 = load ptr, ptr %191, align 8
  %2046 = insertelement <8 x double> poison, double %1967, i64 0
  %2047 = shufflevector <8 x double> %2046, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2047, ptr %2045, align 8
  %2048 = load ptr, ptr %78, align 8
  %2049 = load ptr, ptr %168, align 8
  %2050 = load i64, ptr %166, align 8
  %2051 = load ptr, ptr %0, align 8
  %2052 = getelementptr inbounds i8, ptr %2051, i64 24
  %2053 = load i64, ptr %2052, align 8
  %2054 = load ptr, ptr %191, align 8
  %2055 = load ptr, ptr %77, align 8
  %2056 = getelementptr inbounds i8, ptr %2055, i64 16
  %2057 = load i64, ptr %2056, align 8
  tail call fastcc void @nested(ptr noundef %2044, ptr noundef %2048, ptr noundef %2049, i64 noundef %2050, i64 noundef %2053, ptr noundef %2054, i64 noundef %2057) #8
  %2058 = load i64, ptr %192, align 8
  %2059 = icmp sgt i64 %2058, 0
  br i1 %2059, label %2064, label %2060

2060:                                             ; preds = %2064, %2043
  %2061 = load ptr, ptr %85, align 8
  %2062 = load i64, ptr %2061, align 8
  %2063 = icmp eq i64 %2062, 1
  br i1 %2063, label %2074, label %2080

2064:                                             ; preds = %2043, %2064
  %2065 = phi i64 [ %2071, %2064 ], [ 0, %2043 ]
  %2066 = load ptr, ptr %190, align 8
  %2067 = getelementptr inbounds double, ptr %2066, i64 %2065
  %2068 = load double, ptr %2067, align 8
  %2069 = load ptr, ptr %193, align 8
  %2070 = getelementptr inbounds double, ptr %2069, i64 %2065
  store double %2068, ptr %2070, align 8
  %2071 = add nuw nsw i64 %2065, 1
  %2072 = load i64, ptr %192, align 8
  %2073 = icmp slt i64 %2071, %2072
  br i1 %2073, label %2064, label %2060, !llvm.loop !57

2074:                                             ; preds = %2060
  %2075 = load ptr, ptr %194, align 8
  %2076 = getelementptr inbounds i8, ptr %2061, i64 56
  %2077 = load i64, ptr %2076, align 8
  %2078 = inttoptr i64 %2077 to ptr
  %2079 = tail call i64 %2078(ptr noundef %0, double noundef %1976, ptr noundef %2075, ptr noundef null) #9
  br label %2080

2080:                                             ; preds = %2074, %2060, %2036
  %2081 = phi i64 [ %2079, %2074 ], [ 0, %2060 ], [ %2037, %2036 ]
  %2082 = icmp eq i64 %2081, 0
  br i1 %2082, label %2085, label %2083

2083:                                             ; preds = %2080
  store double %442, ptr %1954, align 8
  %2084 = getelementptr inbounds i8, ptr %1954, i64 8
  store double %519, ptr %2084, align 8
  br label %2141

2085:                                             ; preds = %2080
  br i1 %1969, label %2086, label %2124

2086:                                             ; preds = %2085
  %2087 = load ptr, ptr %195, align 8
  %2088 = load ptr, ptr %77, align 8
  %2089 = getelementptr inbounds i8, ptr %2088, i64 8
  %2090 = load i64, ptr %2089, align 8
  %2091 = load i64, ptr %84, align 8
  %2092 = load ptr, ptr %83, align 8
  %2093 = load ptr, ptr %82, align 8
  %2094 = getelementptr inbounds i8, ptr %2093, i64 48
  %2095 = load i64, ptr %2094, align 8
  %2096 = icmp slt i64 %2095, %2091
  br i1 %2096, label %2097, label %2120

2097:                                             ; preds = %2086
  %2098 = icmp sgt i64 %2090, 0
  br label %2099

2099:                                             ; preds = %2097, %2110
  %2100 = phi i64 [ %2095, %2097 ], [ %2111, %2110 ]
  %2101 = getelementptr inbounds double, ptr %2092, i64 %2100
  %2102 = load double, ptr %2101, align 8
  %2103 = load ptr, ptr %81, align 8
  %2104 = load double, ptr %2103, align 8
  %2105 = fcmp ugt double %2102, %2104
  br i1 %2105, label %2120, label %2106

2106:                                             ; preds = %2099
  br i1 %2098, label %2107, label %2110

2107:                                             ; preds = %2106
  %2108 = mul nsw i64 %2100, %2090
  %2109 = getelementptr double, ptr %1, i64 %2108
  br label %2113

2110:                                             ; preds = %2113, %2106
  %2111 = add i64 %2100, 1
  %2112 = icmp eq i64 %2111, %2091
  br i1 %2112, label %2120, label %2099, !llvm.loop !13

2113:                                             ; preds = %2107, %2113
  %2114 = phi i64 [ 0, %2107 ], [ %2118, %2113 ]
  %2115 = getelementptr inbounds double, ptr %2087, i64 %2114
  %2116 = load double, ptr %2115, align 8
  %2117 = getelementptr double, ptr %2109, i64 %2114
  store double %2116, ptr %2117, align 8
  %2118 = add nuw nsw i64 %2114, 1
  %2119 = icmp eq i64 %2118, %2090
  br i1 %2119, label %2110, label %2113, !llvm.loop !14

2120:                                             ; preds = %2110, %2099, %2086
  %2121 = phi i64 [ %2095, %2086 ], [ %2091, %2110 ], [ %2100, %2099 ]
  %2122 = load ptr, ptr %82, align 8
  %2123 = getelementptr inbounds i8, ptr %2122, i64 48
  store i64 %2121, ptr %2123, align 8
  br label %2124

2124:                                             ; preds = %2120, %2085
  br i1 %2039, label %2125, label %2141

2125:                                             ; preds = %2124
  %2126 = load i64, ptr %196, align 8
  %2127 = icmp sgt i64 %2126, 0
  br i1 %2127, label %2131, label %2128

2128:                                             ; preds = %2131, %2125
  store double %1976, ptr %1954, align 8
  %2129 = getelementptr inbounds i8, ptr %1954, i64 8
  store double 0.000000e+00, ptr %2129, align 8
  %2130 = load ptr, ptr %82, align 8
  store i64 0, ptr %2130, align 8
  br label %2141

2131:                                             ; preds = %2125, %2131
  %2132 = phi i64 [ %2138, %2131 ], [ 0, %2125 ]
  %2133 = load ptr, ptr %197, align 8
  %2134 = getelementptr inbounds double, ptr %2133, i64 %2132
  %2135 = load double, ptr %2134, align 8
  %2136 = load ptr, ptr %78, align 8
  %2137 = getelementptr inbounds double, ptr %2136, i64 %2132
  store double %2135, ptr %2137, align 8
  %2138 = add nuw nsw i64 %2132, 1
  %2139 = load i64, ptr %196, align 8
  %2140 = icmp slt i64 %2138, %2139
  br i1 %2140, label %2131, label %2128, !llvm.loop !58

2141:                                             ; preds = %1962, %2083, %2124, %2128
  %2142 = phi i64 [ -6, %1962 ], [ %2081, %2083 ], [ %1968, %2128 ], [ %1968, %2124 ]
  %2143 = icmp eq i64 %2142, -6
  br i1 %2143, label %2147, label %2144

2144:                                             ; preds = %2141
  %2145 = icmp ne i64 %2142, 6
  %2146 = select i1 %2145, i1 true, i1 %247
  br i1 %2146, label %2172, label %2147

2147:                                             ; preds = %2144, %2141
  %2148 = phi i64 [ %2142, %2144 ], [ 2, %2141 ]
  %2149 = load i64, ptr %406, align 8
  %2150 = add nsw i64 %2149, -1
  store i64 %2150, ptr %406, align 8
  %2151 = load ptr, ptr %97, align 8
  %2152 = load i64, ptr %2151, align 8
  %2153 = add nsw i64 %2152, -1
  store i64 %2153, ptr %2151, align 8
  %2154 = load ptr, ptr %79, align 8
  %2155 = getelementptr inbounds i8, ptr %2154, i64 32
  %2156 = load i64, ptr %2155, align 8
  %2157 = or i64 %2156, 1
  store i64 %2157, ptr %2155, align 8
  %2158 = load ptr, ptr %79, align 8
  %2159 = getelementptr inbounds i8, ptr %2158, i64 8
  %2160 = load i64, ptr %2159, align 8
  %2161 = and i64 %2160, -2
  %2162 = getelementptr inbounds i8, ptr %2158, i64 16
  %2163 = load i64, ptr %2162, align 8
  %2164 = and i64 %2163, 1
  %2165 = or disjoint i64 %2164, %2161
  %2166 = xor i64 %2165, 1
  store i64 %2166, ptr %2159, align 8
  %2167 = load ptr, ptr %170, align 8
  %2168 = getelementptr inbounds i8, ptr %2167, i64 8
  store double 0.000000e+00, ptr %2168, align 8
  %2169 = load i64, ptr %407, align 8
  %2170 = add nsw i64 %2169, 1
  store i64 %2170, ptr %407, align 8
  store i64 %2148, ptr %429, align 8
  %2171 = fmul double %519, 2.500000e-01
  br label %2230, !llvm.loop !48

2172:                                             ; preds = %2144
  %2173 = icmp eq i64 %2142, 0
  br i1 %2173, label %2178, label %2174

2174:                                             ; preds = %2172
  %2175 = load ptr, ptr %97, align 8
  %2176 = load i64, ptr %2175, align 8
  %2177 = add nsw i64 %2176, 1
  store i64 %2177, ptr %2175, align 8
  br label %2230

2178:                                             ; preds = %2172, %1948
  br i1 %426, label %2209, label %2179

2179:                                             ; preds = %2209, %2178
  %2180 = load i64, ptr %98, align 8
  %2181 = icmp sgt i64 %2180, 0
  br i1 %2181, label %2182, label %2184

2182:                                             ; preds = %2179
  %2183 = load ptr, ptr %199, align 8
  store double 0x7FF0000000000000, ptr %2183, align 8
  br label %2184

2184:                                             ; preds = %2179, %2182
  %2185 = load i64, ptr %420, align 8
  %2186 = add nsw i64 %2185, 1
  store i64 %2186, ptr %420, align 8
  %2187 = load ptr, ptr %78, align 8
  %2188 = load ptr, ptr %200, align 8
  %2189 = load ptr, ptr %201, align 8
  store double %518, ptr %2189, align 8
  %2190 = load ptr, ptr %77, align 8
  %2191 = getelementptr inbounds i8, ptr %2190, i64 40
  %2192 = load i64, ptr %2191, align 8
  %2193 = icmp eq i64 %2192, 0
  br i1 %2193, label %2195, label %2194

2194:                                             ; preds = %2184
  tail call fastcc void @settle(ptr noundef nonnull %77) #8
  br label %2195

2195:                                             ; preds = %2194, %2184
  %2196 = load i64, ptr %202, align 8
  %2197 = icmp sgt i64 %2196, 0
  br i1 %2197, label %2198, label %2199

2198:                                             ; preds = %2195
  tail call fastcc void @sample(ptr noundef nonnull %77) #8
  br label %2199

2199:                                             ; preds = %2195, %2198
  %2200 = load ptr, ptr %77, align 8
  %2201 = load i64, ptr %2200, align 8
  %2202 = load ptr, ptr %201, align 8
  %2203 = load ptr, ptr %203, align 8
  %2204 = load ptr, ptr %204, align 8
  %2205 = inttoptr i64 %2201 to ptr
  %2206 = load ptr, ptr %2205, align 8
  %2207 = tail call i32 %2206(ptr noundef %2202, ptr noundef %2187, ptr noundef %2203, ptr noundef %2204, ptr noundef %2188) #9
  %2208 = icmp eq i32 %2207, 0
  br i1 %2208, label %2221, label %2218

2209:                                             ; preds = %2178, %2209
  %2210 = phi i64 [ %2216, %2209 ], [ 0, %2178 ]
  %2211 = load ptr, ptr %198, align 8
  %2212 = getelementptr inbounds double, ptr %2211, i64 %2210
  %2213 = load double, ptr %2212, align 8
  %2214 = load ptr, ptr %78, align 8
  %2215 = getelementptr inbounds double, ptr %2214, i64 %2210
  store double %2213, ptr %2215, align 8
  %2216 = add nuw nsw i64 %2210, 1
  %2217 = icmp eq i64 %2216, %217
  br i1 %2217, label %2179, label %2209, !llvm.loop !59

2218:                                             ; preds = %2199
  store i64 3, ptr %427, align 8
  store double %519, ptr %249, align 8
  %2219 = icmp slt i32 %2207, 0
  %2220 = select i1 %2219, i64 -4, i64 2
  br label %2230

2221:                                             ; preds = %2199
  %2222 = fcmp oeq double %518, %508
  %2223 = fcmp ogt double %443, %1630
  %2224 = select i1 %2222, i1 %2223, i1 false
  %2225 = select i1 %2224, double %443, double %1630
  %2226 = load i64, ptr %428, align 8
  %2227 = load i64, ptr %84, align 8
  %2228 = icmp eq i64 %2226, %2227
  br i1 %2228, label %2229, label %2230

2229:                                             ; preds = %2221
  store double %2225, ptr %249, align 8
  br label %2230

2230:                                             ; preds = %1620, %1646, %1660, %2147, %2174, %2218, %2221, %2229, %525
  %2231 = phi double [ %449, %525 ], [ %1621, %2229 ], [ %1621, %2221 ], [ %1621, %2218 ], [ %1621, %2174 ], [ %1621, %2147 ], [ %1621, %1660 ], [ %1621, %1646 ], [ %1621, %1620 ]
  %2232 = phi double [ %448, %525 ], [ %1622, %2229 ], [ %1622, %2221 ], [ %1622, %2218 ], [ %1622, %2174 ], [ %1622, %2147 ], [ %1622, %1660 ], [ %1622, %1646 ], [ %1622, %1620 ]
  %2233 = phi double [ %447, %525 ], [ %1623, %2229 ], [ %1623, %2221 ], [ %1623, %2218 ], [ %1623, %2174 ], [ %1623, %2147 ], [ %1623, %1660 ], [ %1623, %1646 ], [ %1623, %1620 ]
  %2234 = phi i64 [ %446, %525 ], [ %1624, %2229 ], [ %1624, %2221 ], [ %1624, %2218 ], [ %1624, %2174 ], [ %1624, %2147 ], [ %1624, %1660 ], [ %1624, %1646 ], [ %1624, %1620 ]
  %2235 = phi i64 [ %445, %525 ], [ %1625, %2229 ], [ %1625, %2221 ], [ %1625, %2218 ], [ %1625, %2174 ], [ %1625, %2147 ], [ %1625, %1660 ], [ %1625, %1646 ], [ %1625, %1620 ]
  %2236 = phi i64 [ %444, %525 ], [ %1626, %2229 ], [ %1626, %2221 ], [ %1626, %2218 ], [ %1626, %2174 ], [ %1626, %2147 ], [ %1626, %1660 ], [ %1626, %1646 ], [ %1626, %1620 ]
  %2237 = phi double [ %443, %525 ], [ %2225, %2229 ], [ %2225, %2221 ], [ %1630, %2218 ], [ %1630, %2174 ], [ %2171, %2147 ], [ %1663, %1660 ], [ %1630, %1646 ], [ %443, %1620 ]
  %2238 = phi double [ %442, %525 ], [ %518, %2229 ], [ %518, %2221 ], [ %518, %2218 ], [ %442, %2174 ], [ %442, %2147 ], [ %442, %1660 ], [ %442, %1646 ], [ %442, %1620 ]
  %2239 = phi i32 [ 1, %525 ], [ 1, %2229 ], [ 0, %2221 ], [ 1, %2218 ], [ 1, %2174 ], [ 3, %2147 ], [ 3, %1660 ], [ 3, %1646 ], [ 1, %1620 ]
  %2240 = phi i64 [ 2, %525 ], [ 0, %2229 ], [ %441, %2221 ], [ %2220, %2218 ], [ %2142, %2174 ], [ %441, %2147 ], [ %441, %1660 ], [ %441, %1646 ], [ -4, %1620 ]
  switch i32 %2239, label %2244 [
    i32 0, label %2241
    i32 3, label %2241
  ]

2241:                                             ; preds = %2230, %2230
  %2242 = load i64, ptr %232, align 8
  %2243 = icmp eq i64 %2242, 0
  br i1 %2243, label %431, label %439, !llvm.loop !48

2244:                                             ; preds = %2230, %228, %311, %370, %431, %462, %470
  %2245 = phi double [ %207, %228 ], [ %432, %431 ], [ %449, %470 ], [ %449, %462 ], [ %207, %370 ], [ %207, %311 ], [ %2231, %2230 ]
  %2246 = phi double [ %208, %228 ], [ %433, %431 ], [ %448, %470 ], [ %448, %462 ], [ %208, %370 ], [ %208, %311 ], [ %2232, %2230 ]
  %2247 = phi double [ %209, %228 ], [ %434, %431 ], [ %447, %470 ], [ %447, %462 ], [ %209, %370 ], [ %209, %311 ], [ %2233, %2230 ]
  %2248 = phi i64 [ %210, %228 ], [ %435, %431 ], [ %446, %470 ], [ %446, %462 ], [ %210, %370 ], [ %210, %311 ], [ %2234, %2230 ]
  %2249 = phi i64 [ %211, %228 ], [ %436, %431 ], [ %445, %470 ], [ %445, %462 ], [ %211, %370 ], [ %211, %311 ], [ %2235, %2230 ]
  %2250 = phi i64 [ %212, %228 ], [ %437, %431 ], [ %444, %470 ], [ %444, %462 ], [ %212, %370 ], [ %212, %311 ], [ %2236, %2230 ]
  %2251 = phi i64 [ -1, %228 ], [ -1, %431 ], [ 1, %470 ], [ -5, %462 ], [ 0, %370 ], [ %314, %311 ], [ %2240, %2230 ]
  %2252 = load ptr, ptr %205, align 8
  %2253 = getelementptr inbounds i8, ptr %2252, i64 48
  %2254 = load i64, ptr %2253, align 8
  %2255 = icmp ne i64 %2251, -2
  %2256 = icmp eq i64 %2254, 0
  %2257 = select i1 %2255, i1 true, i1 %2256
  br i1 %2257, label %2265, label %2258

2258:                                             ; preds = %2244
  %2259 = inttoptr i64 %2254 to ptr
  %2260 = tail call i64 %2259(ptr noundef %0) #9
  %2261 = icmp eq i64 %2260, 8
  %2262 = select i1 %2261, i64 8, i64 %2251
  %2263 = icmp eq i64 %2260, 1
  %2264 = zext i1 %2263 to i32
  br label %2265

2265:                                             ; preds = %2244, %2258
  %2266 = phi i64 [ %2251, %2244 ], [ %2262, %2258 ]
  %2267 = phi i32 [ 0, %2244 ], [ %2264, %2258 ]
  %2268 = icmp eq i32 %2267, 0
  br i1 %2268, label %2269, label %206, !llvm.loop !60

2269:                                             ; preds = %2265
  %2270 = getelementptr inbounds i8, ptr %0, i64 320
  %2271 = load i64, ptr %2270, align 8
  %2272 = icmp sgt i64 %2271, 0
  br i1 %2272, label %2273, label %2276

2273:                                             ; preds = %2269
  %2274 = getelementptr inbounds i8, ptr %0, i64 336
  %2275 = load ptr, ptr %2274, align 8
  store double 0x7FF0000000000000, ptr %2275, align 8
  br label %2276

2276:                                             ; preds = %2269, %2273
  ret i64 %2266
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
  br i1 %60, label %49, label %61, !llvm.loop !61

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
  br i1 %88, label %14, label %13, !llvm.loop !62
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
  br i1 %41, label %13, label %18, !llvm.loop !63
}

declare double @llvm.sqrt.f64(double) #4

declare double @llvm.fabs.f64(double) #4

define internal fastcc range(i64 -2147483648, 2147483648) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %11, label %9

5:                                                ; preds = %98, %49
  %6 = icmp eq i64 %20, %1
  br i1 %6, label %7, label %11, !llvm.loop !64

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
  br i1 %48, label %35, label %23, !llvm.loop !65

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
  br i1 %66, label %49, label %56, !llvm.loop !66

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
  br i1 %77, label %67, label %63, !llvm.loop !67

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
  br i1 %97, label %88, label %98, !llvm.loop !68

98:                                               ; preds = %88, %78
  %99 = add nuw nsw i64 %79, 1
  %100 = icmp slt i64 %99, %1
  br i1 %100, label %78, label %5, !llvm.loop !69
}

define internal fastcc range(i64 -2147483648, 2147483648) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %11, label %9

5:                                                ; preds = %156, %59
  %6 = icmp eq i64 %26, %1
  br i1 %6, label %7, label %11, !llvm.loop !70

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
  br i1 %58, label %38, label %28, !llvm.loop !71

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
  br i1 %85, label %59, label %76, !llvm.loop !72

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
  br i1 %108, label %86, label %82, !llvm.loop !73

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
  br i1 %155, label %130, label %156, !llvm.loop !74

156:                                              ; preds = %130, %109
  %157 = add nuw nsw i64 %110, 1
  %158 = icmp slt i64 %157, %1
  br i1 %158, label %109, label %5, !llvm.loop !75
}

declare double @llvm.fma.f64(double, double, double) #4

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
  br i1 %16, label %6, label %8, !llvm.loop !76

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
  br i1 %38, label %23, label %27, !llvm.loop !77

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
  br i1 %49, label %35, label %39, !llvm.loop !78

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
  br i1 %66, label %51, label %50, !llvm.loop !79

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
  br i1 %77, label %60, label %67, !llvm.loop !80
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
  br i1 %16, label %6, label %8, !llvm.loop !76

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
  br i1 %30, label %23, label %14, !llvm.loop !81

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
  br i1 %51, label %31, label %36, !llvm.loop !83

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
  br i1 %77, label %47, label %52, !llvm.loop !84

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
  br i1 %105, label %79, label %78, !llvm.loop !85

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
  br i1 %131, label %91, label %106, !llvm.loop !86
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
  br i1 %21, label %9, label %13, !llvm.loop !76

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
  br i1 %35, label %19, label %28, !llvm.loop !81

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
  br i1 %52, label %44, label %36, !llvm.loop !87

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
  br i1 %69, label %70, label %61, !llvm.loop !88

70:                                               ; preds = %61, %53
  %71 = add nuw nsw i64 %54, 1
  %72 = icmp eq i64 %71, %37
  br i1 %72, label %50, label %53, !llvm.loop !89

73:                                               ; preds = %111, %85
  %74 = icmp sgt i64 %76, 1
  br i1 %74, label %75, label %84, !llvm.loop !90

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
  br i1 %107, label %108, label %99, !llvm.loop !88

108:                                              ; preds = %99, %91
  %109 = add nuw nsw i64 %92, 1
  %110 = icmp eq i64 %109, %1
  br i1 %110, label %85, label %91, !llvm.loop !91

111:                                              ; preds = %86, %111
  %112 = phi i64 [ 0, %86 ], [ %117, %111 ]
  %113 = getelementptr double, ptr %88, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = load double, ptr %90, align 8
  %116 = fmul double %114, %115
  store double %116, ptr %113, align 8
  %117 = add nuw nsw i64 %112, 1
  %118 = icmp eq i64 %117, %4
  br i1 %118, label %73, label %111, !llvm.loop !92
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
  br i1 %23, label %11, label %15, !llvm.loop !76

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
  br i1 %37, label %21, label %30, !llvm.loop !81

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
  br i1 %53, label %44, label %38, !llvm.loop !93

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
  br i1 %89, label %90, label %66, !llvm.loop !94

90:                                               ; preds = %66, %54
  %91 = add nuw nsw i64 %55, 1
  %92 = icmp eq i64 %91, %39
  br i1 %92, label %51, label %54, !llvm.loop !95

93:                                               ; preds = %149, %103
  %94 = icmp sgt i64 %96, 1
  br i1 %94, label %95, label %102, !llvm.loop !96

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
  br i1 %145, label %146, label %122, !llvm.loop !94

146:                                              ; preds = %122, %110
  %147 = add nuw nsw i64 %111, 1
  %148 = icmp eq i64 %147, %1
  br i1 %148, label %103, label %110, !llvm.loop !97

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
  br i1 %166, label %93, label %149, !llvm.loop !98
}

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #6 {
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
  br i1 %31, label %20, label %19, !llvm.loop !99

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
  br i1 %43, label %32, label %24, !llvm.loop !100
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #7

declare i64 @llvm.umax.i64(i64, i64) #7

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { noinline nounwind }
attributes #7 = { nounwind willreturn memory(none) }
attributes #8 = { nounwind }
attributes #9 = { nounwind }
attributes #10 = { nounwind }


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
!48 = distinct !{!48, !5}
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
!81 = distinct !{!81, !4, !5, !82}
!82 = !{!"llvm.loop.vectorize.width", i32 1}
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
!93 = distinct !{!93, !4, !5}
!94 = distinct !{!94, !4, !5}
!95 = distinct !{!95, !4, !5}
!96 = distinct !{!96, !4, !5}
!97 = distinct !{!97, !4, !5}
!98 = distinct !{!98, !4, !5}
!99 = distinct !{!99, !4, !5}
!100 = distinct !{!100, !4, !5}
