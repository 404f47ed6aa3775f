; sources 5d0fb52540a62247e5133fd577f4147a4533e505791d4ea41c2d313fabdf44cd
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
  %87 = getelementptr inbounds i8, ptr %0, i64 312
  %88 = getelementptr inbounds i8, ptr %0, i64 320
  %89 = getelementptr inbounds i8, ptr %0, i64 336
  %90 = getelementptr inbounds i8, ptr %0, i64 528
  %91 = getelementptr inbounds i8, ptr %0, i64 168
  %92 = getelementptr inbounds i8, ptr %0, i64 248
  %93 = getelementptr inbounds i8, ptr %0, i64 192
  %94 = getelementptr inbounds i8, ptr %0, i64 216
  %95 = getelementptr inbounds i8, ptr %0, i64 1392
  %96 = getelementptr inbounds i8, ptr %0, i64 528
  %97 = getelementptr inbounds i8, ptr %0, i64 1320
  %98 = getelementptr inbounds i8, ptr %0, i64 312
  %99 = getelementptr inbounds i8, ptr %0, i64 320
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

206:                                              ; preds = %2227, %76
  %207 = phi double [ undef, %76 ], [ %2207, %2227 ]
  %208 = phi double [ undef, %76 ], [ %2208, %2227 ]
  %209 = phi double [ undef, %76 ], [ %2209, %2227 ]
  %210 = phi i64 [ undef, %76 ], [ %2210, %2227 ]
  %211 = phi i64 [ undef, %76 ], [ %2211, %2227 ]
  %212 = phi i64 [ undef, %76 ], [ %2212, %2227 ]
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
  br i1 %234, label %2206, label %235

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
  br i1 %252, label %253, label %393

253:                                              ; preds = %235
  %254 = load ptr, ptr %87, align 8
  %255 = load i64, ptr %88, align 8
  %256 = icmp eq i64 %255, 0
  br i1 %256, label %283, label %257

257:                                              ; preds = %253
  %258 = icmp sgt i64 %255, 0
  br i1 %258, label %259, label %272

259:                                              ; preds = %257, %259
  %260 = phi i64 [ %270, %259 ], [ %255, %257 ]
  %261 = phi i64 [ %269, %259 ], [ 0, %257 ]
  %262 = add nuw nsw i64 %260, %261
  %263 = lshr i64 %262, 1
  %264 = and i64 %262, -2
  %265 = getelementptr inbounds double, ptr %254, i64 %264
  %266 = load double, ptr %265, align 8
  %267 = fcmp ogt double %266, %248
  %268 = add nuw nsw i64 %263, 1
  %269 = select i1 %267, i64 %261, i64 %268
  %270 = select i1 %267, i64 %263, i64 %260
  %271 = icmp slt i64 %269, %270
  br i1 %271, label %259, label %272, !llvm.loop !12

272:                                              ; preds = %259, %257
  %273 = phi i64 [ 0, %257 ], [ %269, %259 ]
  %274 = icmp slt i64 %273, %255
  br i1 %274, label %275, label %280

275:                                              ; preds = %272
  %276 = shl nuw nsw i64 %273, 1
  %277 = or disjoint i64 %276, 1
  %278 = getelementptr inbounds double, ptr %254, i64 %277
  %279 = load double, ptr %278, align 8
  br label %280

280:                                              ; preds = %275, %272
  %281 = phi double [ %279, %275 ], [ 0x7FF0000000000000, %272 ]
  %282 = load ptr, ptr %89, align 8
  store double %281, ptr %282, align 8
  br label %283

283:                                              ; preds = %280, %253
  %284 = getelementptr inbounds i8, ptr %231, i64 24
  %285 = load i64, ptr %284, align 8
  %286 = add nsw i64 %285, 1
  store i64 %286, ptr %284, align 8
  %287 = load ptr, ptr %78, align 8
  %288 = load ptr, ptr %90, align 8
  %289 = load ptr, ptr %91, align 8
  store double %248, ptr %289, align 8
  %290 = load i64, ptr %92, align 8
  %291 = icmp sgt i64 %290, 0
  br i1 %291, label %292, label %293

292:                                              ; preds = %283
  tail call fastcc void @sample(ptr noundef nonnull %77) #8
  br label %293

293:                                              ; preds = %283, %292
  %294 = load ptr, ptr %77, align 8
  %295 = load i64, ptr %294, align 8
  %296 = load ptr, ptr %91, align 8
  %297 = load ptr, ptr %93, align 8
  %298 = load ptr, ptr %94, align 8
  %299 = inttoptr i64 %295 to ptr
  %300 = load ptr, ptr %299, align 8
  %301 = tail call i32 %300(ptr noundef %296, ptr noundef %287, ptr noundef %297, ptr noundef %298, ptr noundef %288) #9
  %302 = icmp eq i32 %301, 0
  br i1 %302, label %307, label %303

303:                                              ; preds = %293
  %304 = getelementptr inbounds i8, ptr %231, i64 72
  store i64 3, ptr %304, align 8
  %305 = icmp slt i32 %301, 0
  %306 = select i1 %305, i64 -4, i64 2
  br label %2206

307:                                              ; preds = %293
  store i64 1, ptr %231, align 8
  %308 = load ptr, ptr %79, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 16
  %310 = load i64, ptr %309, align 8
  %311 = and i64 %310, -2
  store i64 %311, ptr %309, align 8
  %312 = load ptr, ptr %79, align 8
  %313 = getelementptr inbounds i8, ptr %312, i64 32
  %314 = load i64, ptr %313, align 8
  %315 = or i64 %314, 1
  store i64 %315, ptr %313, align 8
  %316 = load ptr, ptr %79, align 8
  %317 = getelementptr inbounds i8, ptr %316, i64 8
  %318 = load i64, ptr %317, align 8
  %319 = and i64 %318, -2
  %320 = getelementptr inbounds i8, ptr %316, i64 16
  %321 = load i64, ptr %320, align 8
  %322 = and i64 %321, 1
  %323 = or disjoint i64 %322, %319
  %324 = xor i64 %323, 1
  store i64 %324, ptr %317, align 8
  %325 = load ptr, ptr %95, align 8
  %326 = getelementptr inbounds i8, ptr %325, i64 8
  store double 0.000000e+00, ptr %326, align 8
  %327 = load ptr, ptr %95, align 8
  %328 = getelementptr inbounds i8, ptr %327, i64 24
  store double 0.000000e+00, ptr %328, align 8
  %329 = load ptr, ptr %78, align 8
  %330 = load ptr, ptr %77, align 8
  %331 = getelementptr inbounds i8, ptr %330, i64 8
  %332 = load i64, ptr %331, align 8
  %333 = load i64, ptr %84, align 8
  %334 = load ptr, ptr %83, align 8
  %335 = load ptr, ptr %82, align 8
  %336 = getelementptr inbounds i8, ptr %335, i64 48
  %337 = load i64, ptr %336, align 8
  %338 = icmp slt i64 %337, %333
  br i1 %338, label %339, label %362

339:                                              ; preds = %307
  %340 = icmp sgt i64 %332, 0
  br label %341

341:                                              ; preds = %339, %352
  %342 = phi i64 [ %337, %339 ], [ %353, %352 ]
  %343 = getelementptr inbounds double, ptr %334, i64 %342
  %344 = load double, ptr %343, align 8
  %345 = load ptr, ptr %81, align 8
  %346 = load double, ptr %345, align 8
  %347 = fcmp ugt double %344, %346
  br i1 %347, label %362, label %348

348:                                              ; preds = %341
  br i1 %340, label %349, label %352

349:                                              ; preds = %348
  %350 = mul nsw i64 %342, %332
  %351 = getelementptr double, ptr %1, i64 %350
  br label %355

352:                                              ; preds = %355, %348
  %353 = add i64 %342, 1
  %354 = icmp eq i64 %353, %333
  br i1 %354, label %362, label %341, !llvm.loop !13

355:                                              ; preds = %349, %355
  %356 = phi i64 [ 0, %349 ], [ %360, %355 ]
  %357 = getelementptr inbounds double, ptr %329, i64 %356
  %358 = load double, ptr %357, align 8
  %359 = getelementptr double, ptr %351, i64 %356
  store double %358, ptr %359, align 8
  %360 = add nuw nsw i64 %356, 1
  %361 = icmp eq i64 %360, %332
  br i1 %361, label %352, label %355, !llvm.loop !14

362:                                              ; preds = %341, %352, %307
  %363 = phi i64 [ %337, %307 ], [ %342, %341 ], [ %333, %352 ]
  %364 = load ptr, ptr %82, align 8
  %365 = getelementptr inbounds i8, ptr %364, i64 48
  store i64 %363, ptr %365, align 8
  %366 = icmp eq i64 %363, %333
  br i1 %366, label %2206, label %367

367:                                              ; preds = %362
  %368 = fcmp oeq double %250, 0.000000e+00
  br i1 %368, label %369, label %393

369:                                              ; preds = %367
  %370 = getelementptr inbounds i8, ptr %230, i64 16
  %371 = load double, ptr %370, align 8
  %372 = load ptr, ptr %78, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %372, ptr noundef %372, ptr noundef nonnull %78, i64 noundef %217) #8
  %373 = load double, ptr %7, align 8
  %374 = load ptr, ptr %96, align 8
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %374, ptr noundef %372, ptr noundef nonnull %78, i64 noundef %217) #8
  %375 = load double, ptr %8, align 8
  %376 = fcmp uge double %373, 1.000000e-05
  %377 = fcmp uge double %375, 1.000000e-05
  %378 = and i1 %376, %377
  %379 = fmul double %373, 1.000000e-02
  %380 = fdiv double %379, %375
  %381 = select i1 %378, double %380, double 0x3EB0C6F7A0B5ED8D
  %382 = fcmp olt double %371, %381
  %383 = select i1 %382, double %371, double %381
  %384 = tail call double @llvm.fabs.f64(double %248)
  %385 = fmul double %384, 0x3D30000000000000
  %386 = fcmp ogt double %385, %383
  %387 = select i1 %386, double %385, double %383
  %388 = fcmp olt double %371, %387
  %389 = select i1 %388, double %371, double %387
  %390 = tail call i1 @llvm.is.fpclass.f64(double %389, i32 639)
  br i1 %390, label %391, label %393

391:                                              ; preds = %369
  %392 = getelementptr inbounds i8, ptr %231, i64 72
  store i64 4, ptr %392, align 8
  br label %393

393:                                              ; preds = %369, %391, %367, %235
  %394 = phi double [ %250, %367 ], [ %250, %235 ], [ %389, %391 ], [ %389, %369 ]
  %395 = load i64, ptr %232, align 8
  %396 = icmp eq i64 %395, 0
  br i1 %396, label %423, label %397

397:                                              ; preds = %393
  %398 = getelementptr inbounds i8, ptr %231, i64 8
  %399 = getelementptr inbounds i8, ptr %231, i64 16
  %400 = getelementptr inbounds i8, ptr %231, i64 64
  %401 = getelementptr inbounds i8, ptr %230, i64 16
  %402 = fcmp ogt double %229, 0x3CB0000000000000
  %403 = select i1 %402, double %229, double 0x3CB0000000000000
  %404 = fdiv double 0x3CE4000000000000, %403
  %405 = tail call double @llvm.sqrt.f64(double %229)
  %406 = fcmp olt double %405, 3.000000e-02
  %407 = select i1 %406, double %405, double 3.000000e-02
  %408 = fcmp ogt double %407, %404
  %409 = select i1 %408, double %407, double %404
  %410 = fmul double %229, %409
  %411 = fmul double %410, %410
  %412 = getelementptr inbounds i8, ptr %231, i64 24
  %413 = getelementptr inbounds i8, ptr %231, i64 32
  %414 = getelementptr inbounds i8, ptr %231, i64 40
  %415 = getelementptr inbounds i8, ptr %231, i64 72
  %416 = getelementptr inbounds i8, ptr %230, i64 32
  %417 = getelementptr inbounds i8, ptr %231, i64 48
  %418 = icmp sgt i64 %217, 0
  %419 = getelementptr inbounds i8, ptr %231, i64 72
  %420 = getelementptr inbounds i8, ptr %231, i64 48
  %421 = getelementptr inbounds i8, ptr %231, i64 72
  %422 = getelementptr inbounds i8, ptr %231, i64 72
  br label %431

423:                                              ; preds = %2203, %393
  %424 = phi double [ %207, %393 ], [ %2193, %2203 ]
  %425 = phi double [ %208, %393 ], [ %2194, %2203 ]
  %426 = phi double [ %209, %393 ], [ %2195, %2203 ]
  %427 = phi i64 [ %210, %393 ], [ %2196, %2203 ]
  %428 = phi i64 [ %211, %393 ], [ %2197, %2203 ]
  %429 = phi i64 [ %212, %393 ], [ %2198, %2203 ]
  %430 = phi double [ %394, %393 ], [ %2199, %2203 ]
  store double %430, ptr %249, align 8
  br label %2206

431:                                              ; preds = %397, %2203
  %432 = phi i64 [ %395, %397 ], [ %2204, %2203 ]
  %433 = phi i64 [ undef, %397 ], [ %2202, %2203 ]
  %434 = phi double [ %248, %397 ], [ %2200, %2203 ]
  %435 = phi double [ %394, %397 ], [ %2199, %2203 ]
  %436 = phi i64 [ %212, %397 ], [ %2198, %2203 ]
  %437 = phi i64 [ %211, %397 ], [ %2197, %2203 ]
  %438 = phi i64 [ %210, %397 ], [ %2196, %2203 ]
  %439 = phi double [ %209, %397 ], [ %2195, %2203 ]
  %440 = phi double [ %208, %397 ], [ %2194, %2203 ]
  %441 = phi double [ %207, %397 ], [ %2193, %2203 ]
  %442 = load ptr, ptr %97, align 8
  %443 = getelementptr inbounds i8, ptr %442, i64 8
  %444 = load i64, ptr %443, align 8
  %445 = icmp sgt i64 %444, 0
  br i1 %445, label %446, label %451

446:                                              ; preds = %431
  %447 = load i64, ptr %442, align 8
  %448 = add nsw i64 %447, 3
  %449 = icmp slt i64 %444, %448
  %450 = zext i1 %449 to i32
  br label %451

451:                                              ; preds = %431, %446
  %452 = phi i32 [ 0, %431 ], [ %450, %446 ]
  %453 = icmp eq i32 %452, 0
  br i1 %453, label %455, label %454

454:                                              ; preds = %451
  store double %435, ptr %249, align 8
  br label %2206

455:                                              ; preds = %451
  %456 = add nsw i64 %432, -1
  store i64 %456, ptr %232, align 8
  %457 = load i64, ptr %398, align 8
  %458 = load i64, ptr %399, align 8
  %459 = add nsw i64 %458, %457
  %460 = load i64, ptr %400, align 8
  %461 = icmp slt i64 %459, %460
  br i1 %461, label %463, label %462

462:                                              ; preds = %455
  store double %435, ptr %249, align 8
  br label %2206

463:                                              ; preds = %455
  %464 = load ptr, ptr %98, align 8
  %465 = load i64, ptr %99, align 8
  %466 = icmp eq i64 %465, 0
  br i1 %466, label %499, label %467

467:                                              ; preds = %463
  %468 = icmp sgt i64 %465, 0
  br i1 %468, label %469, label %482

469:                                              ; preds = %467, %469
  %470 = phi i64 [ %480, %469 ], [ %465, %467 ]
  %471 = phi i64 [ %479, %469 ], [ 0, %467 ]
  %472 = add nuw nsw i64 %470, %471
  %473 = lshr i64 %472, 1
  %474 = and i64 %472, -2
  %475 = getelementptr inbounds double, ptr %464, i64 %474
  %476 = load double, ptr %475, align 8
  %477 = fcmp ogt double %476, %434
  %478 = add nuw nsw i64 %473, 1
  %479 = select i1 %477, i64 %471, i64 %478
  %480 = select i1 %477, i64 %473, i64 %470
  %481 = icmp slt i64 %479, %480
  br i1 %481, label %469, label %482, !llvm.loop !12

482:                                              ; preds = %469, %467
  %483 = phi i64 [ 0, %467 ], [ %479, %469 ]
  %484 = icmp slt i64 %483, %465
  br i1 %484, label %485, label %490

485:                                              ; preds = %482
  %486 = shl nuw nsw i64 %483, 1
  %487 = or disjoint i64 %486, 1
  %488 = getelementptr inbounds double, ptr %464, i64 %487
  %489 = load double, ptr %488, align 8
  br label %490

490:                                              ; preds = %485, %482
  %491 = phi double [ %489, %485 ], [ 0x7FF0000000000000, %482 ]
  %492 = load ptr, ptr %100, align 8
  store double %491, ptr %492, align 8
  %493 = load i64, ptr %99, align 8
  %494 = icmp slt i64 %483, %493
  br i1 %494, label %495, label %499

495:                                              ; preds = %490
  %496 = shl nsw i64 %483, 4
  %497 = getelementptr inbounds i8, ptr %464, i64 %496
  %498 = load double, ptr %497, align 8
  br label %499

499:                                              ; preds = %463, %490, %495
  %500 = phi double [ 0x7FF0000000000000, %463 ], [ %498, %495 ], [ 0x7FF0000000000000, %490 ]
  %501 = fcmp olt double %240, %500
  %502 = select i1 %501, double %240, double %500
  %503 = load double, ptr %401, align 8
  %504 = fcmp olt double %435, %503
  %505 = select i1 %504, double %435, double %503
  %506 = fadd double %434, %505
  %507 = fmul double %505, 1.000000e-03
  %508 = fsub double %502, %507
  %509 = fcmp ule double %506, %508
  %510 = select i1 %509, double %506, double %502
  %511 = fsub double %510, %434
  %512 = fmul double %511, 6.250000e-02
  %513 = fadd double %434, %512
  %514 = fcmp ule double %513, %434
  %515 = fcmp une double %510, %502
  %516 = and i1 %515, %514
  br i1 %516, label %517, label %518

517:                                              ; preds = %499
  store double %511, ptr %249, align 8
  br label %2192

518:                                              ; preds = %499
  %519 = load ptr, ptr %77, align 8, !noalias !15
  %520 = getelementptr inbounds i8, ptr %519, i64 8
  %521 = load i64, ptr %520, align 8, !noalias !15
  %522 = load ptr, ptr %79, align 8, !noalias !15
  %523 = getelementptr inbounds i8, ptr %522, i64 8
  %524 = load i64, ptr %523, align 8, !noalias !15
  %525 = and i64 %524, 1
  %526 = icmp eq i64 %525, 0
  br i1 %526, label %646, label %527

527:                                              ; preds = %518
  %528 = load ptr, ptr %102, align 8, !noalias !15
  %529 = load i64, ptr %522, align 8, !noalias !15
  %530 = icmp eq i64 %529, 0
  br i1 %530, label %531, label %533

531:                                              ; preds = %527
  %532 = icmp sgt i64 %521, 0
  br i1 %532, label %551, label %549

533:                                              ; preds = %527
  %534 = load ptr, ptr %103, align 8, !noalias !15
  store double %434, ptr %534, align 8, !noalias !15
  %535 = load i64, ptr %104, align 8, !noalias !15
  %536 = icmp sgt i64 %535, 0
  br i1 %536, label %537, label %538

537:                                              ; preds = %533
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !15
  br label %538

538:                                              ; preds = %537, %533
  %539 = load ptr, ptr %79, align 8, !noalias !15
  %540 = load i64, ptr %539, align 8, !noalias !15
  %541 = load ptr, ptr %103, align 8, !noalias !15
  %542 = load ptr, ptr %78, align 8, !noalias !15
  %543 = load ptr, ptr %105, align 8, !noalias !15
  %544 = load ptr, ptr %106, align 8, !noalias !15
  %545 = inttoptr i64 %540 to ptr
  %546 = load ptr, ptr %545, align 8, !noalias !15
  %547 = tail call i32 %546(ptr noundef %541, ptr noundef %542, ptr noundef %543, ptr noundef %544, ptr noundef %528) #9, !noalias !15
  %548 = sext i32 %547 to i64
  br label %617

549:                                              ; preds = %551, %531
  %550 = icmp sgt i64 %521, 0
  br i1 %550, label %563, label %617

551:                                              ; preds = %531, %551
  %552 = phi i64 [ %558, %551 ], [ 0, %531 ]
  %553 = load ptr, ptr %78, align 8, !noalias !15
  %554 = getelementptr inbounds double, ptr %553, i64 %552
  %555 = load double, ptr %554, align 8, !noalias !15
  %556 = load ptr, ptr %107, align 8, !noalias !15
  %557 = getelementptr inbounds double, ptr %556, i64 %552
  store double %555, ptr %557, align 8, !noalias !15
  %558 = add nuw nsw i64 %552, 1
  %559 = icmp eq i64 %558, %521
  br i1 %559, label %549, label %551, !llvm.loop !18

560:                                              ; preds = %615
  %561 = add nuw nsw i64 %565, 1
  %562 = icmp eq i64 %561, %521
  br i1 %562, label %617, label %563, !llvm.loop !19

563:                                              ; preds = %549, %560
  %564 = phi i64 [ %616, %560 ], [ undef, %549 ]
  %565 = phi i64 [ %561, %560 ], [ 0, %549 ]
  %566 = phi double [ %577, %560 ], [ 0.000000e+00, %549 ]
  %567 = load ptr, ptr %78, align 8, !noalias !15
  %568 = getelementptr inbounds double, ptr %567, i64 %565
  %569 = load double, ptr %568, align 8, !noalias !15
  %570 = tail call double @llvm.fabs.f64(double %569)
  %571 = fcmp olt double %570, 1.000000e-05
  %572 = select i1 %571, double 1.000000e-05, double %570
  %573 = fmul double %572, 1.500000e-08
  %574 = fadd double %569, %573
  %575 = load ptr, ptr %108, align 8, !noalias !15
  %576 = getelementptr inbounds double, ptr %575, i64 %565
  store double %574, ptr %576, align 8, !noalias !15
  %577 = fadd double %566, 1.000000e+00
  %578 = load ptr, ptr %108, align 8, !noalias !15
  %579 = load ptr, ptr %109, align 8, !noalias !15
  %580 = load ptr, ptr %110, align 8, !noalias !15
  store double %434, ptr %580, align 8, !noalias !15
  %581 = load i64, ptr %111, align 8, !noalias !15
  %582 = icmp sgt i64 %581, 0
  br i1 %582, label %583, label %584

583:                                              ; preds = %563
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !15
  br label %584

584:                                              ; preds = %583, %563
  %585 = load ptr, ptr %77, align 8, !noalias !15
  %586 = load i64, ptr %585, align 8, !noalias !15
  %587 = load ptr, ptr %110, align 8, !noalias !15
  %588 = load ptr, ptr %112, align 8, !noalias !15
  %589 = load ptr, ptr %113, align 8, !noalias !15
  %590 = inttoptr i64 %586 to ptr
  %591 = load ptr, ptr %590, align 8, !noalias !15
  %592 = tail call i32 %591(ptr noundef %587, ptr noundef %578, ptr noundef %588, ptr noundef %589, ptr noundef %579) #9, !noalias !15
  %593 = sext i32 %592 to i64
  %594 = icmp eq i32 %592, 0
  br i1 %594, label %595, label %615

595:                                              ; preds = %584
  %596 = getelementptr double, ptr %528, i64 %565
  %597 = fsub double %574, %569
  br label %601

598:                                              ; preds = %601
  %599 = load ptr, ptr %108, align 8, !noalias !15
  %600 = getelementptr inbounds double, ptr %599, i64 %565
  store double %569, ptr %600, align 8, !noalias !15
  br label %615

601:                                              ; preds = %595, %601
  %602 = phi i64 [ 0, %595 ], [ %613, %601 ]
  %603 = load ptr, ptr %109, align 8, !noalias !15
  %604 = getelementptr inbounds double, ptr %603, i64 %602
  %605 = load double, ptr %604, align 8, !noalias !15
  %606 = load ptr, ptr %114, align 8, !noalias !15
  %607 = getelementptr inbounds double, ptr %606, i64 %602
  %608 = load double, ptr %607, align 8, !noalias !15
  %609 = fsub double %605, %608
  %610 = fdiv double %609, %597
  %611 = mul nuw nsw i64 %602, %521
  %612 = getelementptr double, ptr %596, i64 %611
  store double %610, ptr %612, align 8, !noalias !15
  %613 = add nuw nsw i64 %602, 1
  %614 = icmp eq i64 %613, %521
  br i1 %614, label %598, label %601, !llvm.loop !20

615:                                              ; preds = %598, %584
  %616 = phi i64 [ %564, %598 ], [ %593, %584 ]
  br i1 %594, label %560, label %617

617:                                              ; preds = %615, %560, %549, %538
  %618 = phi double [ 0.000000e+00, %538 ], [ 0.000000e+00, %549 ], [ %577, %560 ], [ %577, %615 ]
  %619 = phi i64 [ %548, %538 ], [ 0, %549 ], [ %616, %615 ], [ 0, %560 ]
  %620 = load i64, ptr %115, align 8, !noalias !15
  %621 = icmp sgt i64 %620, 0
  br i1 %621, label %622, label %635

622:                                              ; preds = %617, %622
  %623 = phi i64 [ %632, %622 ], [ 0, %617 ]
  %624 = load ptr, ptr %102, align 8, !noalias !15
  %625 = getelementptr inbounds double, ptr %624, i64 %623
  %626 = load double, ptr %625, align 8, !noalias !15
  %627 = tail call double @llvm.fabs.f64(double %626)
  %628 = fcmp ueq double %627, 0x7FF0000000000000
  %629 = select i1 %628, double 0.000000e+00, double %626
  %630 = load ptr, ptr %101, align 8, !noalias !15
  %631 = getelementptr inbounds double, ptr %630, i64 %623
  store double %629, ptr %631, align 8, !noalias !15
  %632 = add nuw nsw i64 %623, 1
  %633 = load i64, ptr %115, align 8, !noalias !15
  %634 = icmp slt i64 %632, %633
  br i1 %634, label %622, label %635, !llvm.loop !21

635:                                              ; preds = %622, %617
  %636 = icmp slt i64 %619, 0
  br i1 %636, label %1588, label %637

637:                                              ; preds = %635
  %638 = load i64, ptr %523, align 8, !noalias !15
  %639 = and i64 %638, -2
  store i64 %639, ptr %523, align 8, !noalias !15
  %640 = getelementptr inbounds i8, ptr %522, i64 16
  %641 = load i64, ptr %640, align 8, !noalias !15
  %642 = or i64 %641, 1
  store i64 %642, ptr %640, align 8, !noalias !15
  %643 = getelementptr inbounds i8, ptr %522, i64 24
  %644 = load i64, ptr %643, align 8, !noalias !15
  %645 = and i64 %644, -2
  store i64 %645, ptr %643, align 8, !noalias !15
  br label %646

646:                                              ; preds = %637, %518
  %647 = phi double [ 0.000000e+00, %518 ], [ %618, %637 ]
  %648 = load ptr, ptr %79, align 8, !noalias !15
  %649 = load ptr, ptr %116, align 8, !noalias !15
  %650 = load double, ptr %649, align 8, !noalias !15
  %651 = fsub double %511, %650
  %652 = tail call double @llvm.fabs.f64(double %651)
  %653 = tail call double @llvm.fabs.f64(double %510)
  %654 = fmul double %653, 0x3CB0000000000000
  %655 = fcmp ogt double %652, %654
  %656 = getelementptr inbounds i8, ptr %648, i64 24
  %657 = load i64, ptr %656, align 8, !noalias !15
  %658 = trunc i64 %657 to i1
  %659 = xor i1 %658, true
  %660 = or i1 %655, %659
  %661 = zext i1 %660 to i64
  br i1 %660, label %662, label %722

662:                                              ; preds = %646
  store double %511, ptr %649, align 8, !noalias !15
  %663 = load i64, ptr %117, align 8, !noalias !15
  %664 = load ptr, ptr %118, align 8, !noalias !15
  %665 = load ptr, ptr %119, align 8, !noalias !15
  %666 = icmp sgt i64 %663, 0
  br i1 %666, label %667, label %697

667:                                              ; preds = %662
  %668 = fdiv double 0x400D1A48D83E731D, %511
  %669 = fdiv double 0x400572DB93E0C672, %511
  %670 = fdiv double 0xC0086747F2C3FCB6, %511
  br label %671

671:                                              ; preds = %667, %674
  %672 = phi i64 [ 0, %667 ], [ %675, %674 ]
  %673 = mul nuw nsw i64 %672, %663
  br label %677

674:                                              ; preds = %677
  %675 = add nuw nsw i64 %672, 1
  %676 = icmp eq i64 %675, %663
  br i1 %676, label %697, label %671, !llvm.loop !22

677:                                              ; preds = %671, %677
  %678 = phi i64 [ 0, %671 ], [ %695, %677 ]
  %679 = load ptr, ptr %120, align 8, !noalias !15
  %680 = add nuw nsw i64 %678, %673
  %681 = getelementptr inbounds double, ptr %679, i64 %680
  %682 = load double, ptr %681, align 8, !noalias !15
  %683 = fneg double %682
  %684 = icmp eq i64 %672, %678
  %685 = fsub double %668, %682
  %686 = select i1 %684, double %685, double %683
  %687 = fsub double %669, %682
  %688 = select i1 %684, double %687, double %683
  %689 = getelementptr inbounds double, ptr %664, i64 %680
  store double %686, ptr %689, align 8, !noalias !15
  %690 = select i1 %684, double %670, double 0.000000e+00
  %691 = shl nuw nsw i64 %680, 1
  %692 = getelementptr inbounds double, ptr %665, i64 %691
  store double %688, ptr %692, align 8, !noalias !15
  %693 = or disjoint i64 %691, 1
  %694 = getelementptr inbounds double, ptr %665, i64 %693
  store double %690, ptr %694, align 8, !noalias !15
  %695 = add nuw nsw i64 %678, 1
  %696 = icmp eq i64 %695, %663
  br i1 %696, label %674, label %677, !llvm.loop !23

697:                                              ; preds = %674, %662
  %698 = load ptr, ptr %121, align 8, !noalias !15
  %699 = tail call fastcc i64 @real_factorise(ptr noundef %664, i64 noundef %663, ptr noundef %698) #8, !noalias !15
  %700 = load ptr, ptr %122, align 8, !noalias !15
  %701 = tail call fastcc i64 @pair_factorise(ptr noundef %665, i64 noundef %663, ptr noundef %700) #8, !noalias !15
  %702 = or i64 %701, %699
  %703 = and i64 %702, %661
  %704 = load i64, ptr %656, align 8, !noalias !15
  %705 = or i64 %704, %661
  %706 = xor i64 %703, -1
  %707 = xor i64 %703, %705
  store i64 %707, ptr %656, align 8, !noalias !15
  %708 = icmp eq i64 %703, 0
  %709 = select i1 %708, double 2.000000e+00, double 4.000000e+00
  %710 = fmul double %511, 5.000000e-01
  %711 = select i1 %708, double %435, double %710
  %712 = load ptr, ptr %79, align 8, !noalias !15
  %713 = getelementptr inbounds i8, ptr %712, i64 8
  %714 = load i64, ptr %713, align 8, !noalias !15
  %715 = and i64 %714, %706
  %716 = getelementptr inbounds i8, ptr %712, i64 16
  %717 = load i64, ptr %716, align 8, !noalias !15
  %718 = xor i64 %717, -1
  %719 = and i64 %703, %718
  %720 = or disjoint i64 %719, %715
  store i64 %720, ptr %713, align 8, !noalias !15
  %721 = and i64 %706, 1
  br label %722

722:                                              ; preds = %646, %697
  %723 = phi double [ %435, %646 ], [ %711, %697 ]
  %724 = phi double [ 2.000000e+00, %646 ], [ %709, %697 ]
  %725 = phi i64 [ 1, %646 ], [ %721, %697 ]
  %726 = icmp eq i64 %725, 0
  br i1 %726, label %1588, label %727

727:                                              ; preds = %722
  %728 = load ptr, ptr %116, align 8, !noalias !15
  %729 = getelementptr inbounds i8, ptr %728, i64 8
  %730 = load double, ptr %729, align 8, !noalias !15
  %731 = load ptr, ptr %77, align 8, !noalias !15
  %732 = getelementptr inbounds i8, ptr %731, i64 8
  %733 = load i64, ptr %732, align 8, !noalias !15
  %734 = load ptr, ptr %123, align 8, !noalias !15
  %735 = load ptr, ptr %78, align 8, !noalias !15
  %736 = load ptr, ptr %124, align 8, !noalias !15
  %737 = load ptr, ptr %125, align 8, !noalias !15
  %738 = fcmp ule double %730, 0.000000e+00
  %739 = icmp sgt i64 %733, 0
  %740 = shl i64 %733, 4
  %741 = getelementptr i8, ptr %734, i64 %740
  %742 = mul i64 %733, 24
  %743 = getelementptr i8, ptr %734, i64 %742
  %744 = getelementptr double, ptr %734, i64 %733
  br label %750

745:                                              ; preds = %761
  %746 = icmp sgt i64 %733, 0
  %747 = getelementptr double, ptr %736, i64 %733
  %748 = shl i64 %733, 4
  %749 = getelementptr i8, ptr %736, i64 %748
  br label %787

750:                                              ; preds = %727, %761
  %751 = phi i64 [ 0, %727 ], [ %762, %761 ]
  %752 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %751
  %753 = load double, ptr %752, align 8, !noalias !15
  %754 = fmul double %511, %753
  %755 = fdiv double %754, %730
  %756 = fadd double %755, 1.000000e+00
  br i1 %739, label %757, label %761

757:                                              ; preds = %750
  %758 = fsub double 1.000000e+00, %756
  %759 = mul nuw nsw i64 %733, %751
  %760 = getelementptr double, ptr %736, i64 %759
  br label %764

761:                                              ; preds = %764, %750
  %762 = add nuw nsw i64 %751, 1
  %763 = icmp eq i64 %762, 3
  br i1 %763, label %745, label %750, !llvm.loop !24

764:                                              ; preds = %757, %764
  %765 = phi i64 [ 0, %757 ], [ %785, %764 ]
  %766 = getelementptr double, ptr %741, i64 %765
  %767 = load double, ptr %766, align 8, !noalias !15
  %768 = getelementptr double, ptr %743, i64 %765
  %769 = load double, ptr %768, align 8, !noalias !15
  %770 = fmul double %756, %769
  %771 = fadd double %767, %770
  %772 = fmul double %758, %771
  %773 = getelementptr inbounds double, ptr %734, i64 %765
  %774 = load double, ptr %773, align 8, !noalias !15
  %775 = getelementptr double, ptr %744, i64 %765
  %776 = load double, ptr %775, align 8, !noalias !15
  %777 = fadd double %776, %772
  %778 = fmul double %756, %777
  %779 = fadd double %774, %778
  %780 = getelementptr inbounds double, ptr %735, i64 %765
  %781 = load double, ptr %780, align 8, !noalias !15
  %782 = fsub double %779, %781
  %783 = select i1 %738, double 0.000000e+00, double %782
  %784 = getelementptr double, ptr %760, i64 %765
  store double %783, ptr %784, align 8, !noalias !15
  %785 = add nuw nsw i64 %765, 1
  %786 = icmp eq i64 %785, %733
  br i1 %786, label %761, label %764, !llvm.loop !25

787:                                              ; preds = %745, %798
  %788 = phi i64 [ 0, %745 ], [ %799, %798 ]
  br i1 %746, label %789, label %798

789:                                              ; preds = %787
  %790 = mul nuw nsw i64 %733, %788
  %791 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %788
  %792 = load double, ptr %791, align 8, !noalias !15
  %793 = getelementptr inbounds i8, ptr %791, i64 8
  %794 = load double, ptr %793, align 8, !noalias !15
  %795 = getelementptr inbounds i8, ptr %791, i64 16
  %796 = load double, ptr %795, align 8, !noalias !15
  %797 = getelementptr double, ptr %737, i64 %790
  br label %801

798:                                              ; preds = %801, %787
  %799 = add nuw nsw i64 %788, 1
  %800 = icmp eq i64 %799, 3
  br i1 %800, label %817, label %787, !llvm.loop !26

801:                                              ; preds = %789, %801
  %802 = phi i64 [ 0, %789 ], [ %815, %801 ]
  %803 = getelementptr inbounds double, ptr %736, i64 %802
  %804 = load double, ptr %803, align 8, !noalias !15
  %805 = fmul double %792, %804
  %806 = getelementptr double, ptr %747, i64 %802
  %807 = load double, ptr %806, align 8, !noalias !15
  %808 = fmul double %794, %807
  %809 = fadd double %805, %808
  %810 = getelementptr double, ptr %749, i64 %802
  %811 = load double, ptr %810, align 8, !noalias !15
  %812 = fmul double %796, %811
  %813 = fadd double %809, %812
  %814 = getelementptr double, ptr %797, i64 %802
  store double %813, ptr %814, align 8, !noalias !15
  %815 = add nuw nsw i64 %802, 1
  %816 = icmp eq i64 %815, %733
  br i1 %816, label %798, label %801, !llvm.loop !27

817:                                              ; preds = %798
  %818 = load ptr, ptr %79, align 8, !noalias !28
  %819 = getelementptr inbounds i8, ptr %818, i64 40
  %820 = load i64, ptr %819, align 8, !noalias !28
  %821 = icmp sgt i64 %820, 0
  %822 = select i1 %821, i64 10, i64 6
  %823 = fdiv double 0x400572DB93E0C672, %511
  %824 = fdiv double 0xC0086747F2C3FCB6, %511
  %825 = fdiv double 0x400D1A48D83E731D, %511
  %826 = fneg double %824
  br label %830

827:                                              ; preds = %1281
  %828 = add nuw nsw i64 %834, 1
  %829 = icmp eq i64 %828, %822
  br i1 %829, label %1296, label %830, !llvm.loop !31

830:                                              ; preds = %817, %827
  %831 = phi double [ -1.000000e+00, %817 ], [ %1294, %827 ]
  %832 = phi i64 [ %725, %817 ], [ %1293, %827 ]
  %833 = phi i64 [ 0, %817 ], [ %1292, %827 ]
  %834 = phi i64 [ 0, %817 ], [ %828, %827 ]
  %835 = phi i64 [ 0, %817 ], [ %1290, %827 ]
  %836 = phi i64 [ 0, %817 ], [ %918, %827 ]
  %837 = phi i64 [ 0, %817 ], [ %917, %827 ]
  %838 = phi double [ 0.000000e+00, %817 ], [ %1289, %827 ]
  %839 = phi double [ 0.000000e+00, %817 ], [ %1288, %827 ]
  %840 = phi double [ 0.000000e+00, %817 ], [ %916, %827 ]
  %841 = phi i64 [ %436, %817 ], [ %1287, %827 ]
  %842 = phi i64 [ %437, %817 ], [ %1286, %827 ]
  %843 = phi i64 [ %438, %817 ], [ %1285, %827 ]
  %844 = phi double [ %439, %817 ], [ %1284, %827 ]
  %845 = phi double [ %440, %817 ], [ %1283, %827 ]
  %846 = phi double [ %441, %817 ], [ %1282, %827 ]
  %847 = icmp ugt i64 %834, 5
  %848 = select i1 %847, i64 %835, i64 -1
  %849 = and i64 %832, %848
  %850 = load ptr, ptr %77, align 8, !noalias !28
  %851 = getelementptr inbounds i8, ptr %850, i64 8
  %852 = load i64, ptr %851, align 8, !noalias !28
  %853 = load ptr, ptr %124, align 8, !noalias !28
  %854 = icmp eq i64 %849, 0
  br i1 %854, label %915, label %855

855:                                              ; preds = %830
  %856 = icmp sgt i64 %852, 0
  br label %857

857:                                              ; preds = %855, %883
  %858 = phi i64 [ %849, %855 ], [ %898, %883 ]
  %859 = phi i64 [ 0, %855 ], [ %899, %883 ]
  %860 = phi i64 [ %836, %855 ], [ %896, %883 ]
  %861 = phi i64 [ %837, %855 ], [ %894, %883 ]
  %862 = phi double [ %840, %855 ], [ %870, %883 ]
  br i1 %856, label %863, label %866

863:                                              ; preds = %857
  %864 = mul nuw nsw i64 %859, %852
  %865 = getelementptr double, ptr %853, i64 %864
  br label %903

866:                                              ; preds = %903, %857
  %867 = and i64 %858, 4294967295
  %868 = icmp eq i64 %867, 0
  %869 = select i1 %868, double 0.000000e+00, double 1.000000e+00
  %870 = fadd double %862, %869
  %871 = load ptr, ptr %127, align 8, !noalias !28
  %872 = mul nsw i64 %859, %852
  %873 = getelementptr inbounds double, ptr %871, i64 %872
  %874 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %859
  %875 = load double, ptr %874, align 8, !noalias !28
  %876 = fmul double %511, %875
  %877 = fadd double %434, %876
  %878 = load ptr, ptr %128, align 8, !noalias !28
  %879 = load ptr, ptr %129, align 8, !noalias !28
  store double %877, ptr %879, align 8, !noalias !28
  %880 = load i64, ptr %130, align 8, !noalias !28
  %881 = icmp sgt i64 %880, 0
  br i1 %881, label %882, label %883

882:                                              ; preds = %866
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !28
  br label %883

883:                                              ; preds = %882, %866
  %884 = load ptr, ptr %77, align 8, !noalias !28
  %885 = load i64, ptr %884, align 8, !noalias !28
  %886 = load ptr, ptr %129, align 8, !noalias !28
  %887 = load ptr, ptr %131, align 8, !noalias !28
  %888 = load ptr, ptr %132, align 8, !noalias !28
  %889 = inttoptr i64 %885 to ptr
  %890 = load ptr, ptr %889, align 8, !noalias !28
  %891 = tail call i32 %890(ptr noundef %886, ptr noundef %878, ptr noundef %887, ptr noundef %888, ptr noundef %873) #9, !noalias !28
  %892 = sext i32 %891 to i64
  %893 = icmp slt i32 %891, 0
  %894 = select i1 %893, i64 %892, i64 %861
  %895 = and i64 %858, %892
  %896 = or i64 %895, %860
  %897 = xor i64 %892, -1
  %898 = and i64 %858, %897
  %899 = add nuw nsw i64 %859, 1
  %900 = icmp ult i64 %859, 2
  %901 = icmp ne i64 %898, 0
  %902 = select i1 %900, i1 %901, i1 false
  br i1 %902, label %857, label %915, !llvm.loop !32

903:                                              ; preds = %863, %903
  %904 = phi i64 [ 0, %863 ], [ %913, %903 ]
  %905 = load ptr, ptr %126, align 8, !noalias !28
  %906 = load ptr, ptr %78, align 8, !noalias !28
  %907 = getelementptr inbounds double, ptr %906, i64 %904
  %908 = load double, ptr %907, align 8, !noalias !28
  %909 = getelementptr double, ptr %865, i64 %904
  %910 = load double, ptr %909, align 8, !noalias !28
  %911 = fadd double %908, %910
  %912 = getelementptr inbounds double, ptr %905, i64 %904
  store double %911, ptr %912, align 8, !noalias !28
  %913 = add nuw nsw i64 %904, 1
  %914 = icmp eq i64 %913, %852
  br i1 %914, label %866, label %903, !llvm.loop !33

915:                                              ; preds = %883, %830
  %916 = phi double [ %840, %830 ], [ %870, %883 ]
  %917 = phi i64 [ %837, %830 ], [ %894, %883 ]
  %918 = phi i64 [ %836, %830 ], [ %896, %883 ]
  %919 = phi i64 [ %849, %830 ], [ %898, %883 ]
  %920 = icmp eq i64 %919, 0
  br i1 %920, label %921, label %925

921:                                              ; preds = %915
  %922 = or i64 %849, %833
  %923 = xor i64 %922, -1
  %924 = and i64 %835, %923
  br label %1281

925:                                              ; preds = %915
  %926 = load ptr, ptr %77, align 8, !noalias !28
  %927 = getelementptr inbounds i8, ptr %926, i64 8
  %928 = load i64, ptr %927, align 8, !noalias !28
  %929 = load ptr, ptr %133, align 8, !noalias !28
  %930 = load ptr, ptr %125, align 8, !noalias !28
  %931 = icmp sgt i64 %928, 0
  br i1 %931, label %932, label %1010

932:                                              ; preds = %925
  %933 = shl nuw nsw i64 %928, 1
  br label %934

934:                                              ; preds = %932, %934
  %935 = phi i32 [ 1, %932 ], [ %950, %934 ]
  %936 = phi i64 [ 0, %932 ], [ %1008, %934 ]
  %937 = phi double [ 0.000000e+00, %932 ], [ %1007, %934 ]
  %938 = getelementptr inbounds double, ptr %929, i64 %936
  %939 = load double, ptr %938, align 8, !noalias !28
  %940 = add nuw nsw i64 %936, %928
  %941 = getelementptr inbounds double, ptr %929, i64 %940
  %942 = load double, ptr %941, align 8, !noalias !28
  %943 = fadd double %939, %942
  %944 = add nuw nsw i64 %936, %933
  %945 = getelementptr inbounds double, ptr %929, i64 %944
  %946 = load double, ptr %945, align 8, !noalias !28
  %947 = fadd double %943, %946
  %948 = tail call double @llvm.fabs.f64(double %947)
  %949 = fcmp one double %948, 0x7FF0000000000000
  %950 = select i1 %949, i32 %935, i32 0
  %951 = getelementptr inbounds double, ptr %930, i64 %940
  %952 = load double, ptr %951, align 8, !noalias !28
  %953 = getelementptr inbounds double, ptr %930, i64 %944
  %954 = load double, ptr %953, align 8, !noalias !28
  %955 = fmul double %939, 0xC010B70201A79C46
  %956 = fmul double %942, 0x3FD4F8C15DA84E86
  %957 = fsub double %955, %956
  %958 = fmul double %946, 0x3FDE810014C55221
  %959 = fadd double %957, %958
  %960 = fmul double %939, 0x3FE017885A24A7F2
  %961 = fmul double %942, 0x4004934E6FCAA598
  %962 = fsub double %960, %961
  %963 = fmul double %946, 0x3FE312C0CF7BDFD1
  %964 = fadd double %962, %963
  %965 = fmul double %939, 0x4010B70201A79C46
  %966 = fmul double %942, 0x3FD4F8C15DA84E86
  %967 = fadd double %965, %966
  %968 = fmul double %946, 0x3FE0BF7FF59D56EF
  %969 = fadd double %967, %968
  %970 = getelementptr inbounds double, ptr %930, i64 %936
  %971 = load double, ptr %970, align 8, !noalias !28
  %972 = fmul double %825, %971
  %973 = fsub double %969, %972
  %974 = fmul double %954, %826
  %975 = tail call double @llvm.fma.f64(double %823, double %952, double %974)
  %976 = fmul double %824, %952
  %977 = tail call double @llvm.fma.f64(double %823, double %954, double %976)
  %978 = fsub double %959, %975
  %979 = fsub double %964, %977
  %980 = load ptr, ptr %134, align 8, !noalias !28
  %981 = getelementptr inbounds double, ptr %980, i64 %936
  store double %973, ptr %981, align 8, !noalias !28
  %982 = load ptr, ptr %135, align 8, !noalias !28
  %983 = shl nuw nsw i64 %936, 1
  %984 = getelementptr inbounds double, ptr %982, i64 %983
  store double %978, ptr %984, align 8, !noalias !28
  %985 = or disjoint i64 %983, 1
  %986 = getelementptr inbounds double, ptr %982, i64 %985
  store double %979, ptr %986, align 8, !noalias !28
  %987 = load ptr, ptr %78, align 8, !noalias !28
  %988 = getelementptr inbounds double, ptr %987, i64 %936
  %989 = load double, ptr %988, align 8, !noalias !28
  %990 = tail call double @llvm.fabs.f64(double %973)
  %991 = tail call double @llvm.fabs.f64(double %978)
  %992 = tail call double @llvm.fabs.f64(double %979)
  %993 = fadd double %992, %991
  %994 = fadd double %990, %993
  %995 = fmul double %511, %994
  %996 = load ptr, ptr %136, align 8, !noalias !28
  %997 = getelementptr inbounds double, ptr %996, i64 %936
  %998 = load double, ptr %997, align 8, !noalias !28
  %999 = load ptr, ptr %80, align 8, !noalias !28
  %1000 = getelementptr inbounds double, ptr %999, i64 %936
  %1001 = load double, ptr %1000, align 8, !noalias !28
  %1002 = tail call double @llvm.fabs.f64(double %989)
  %1003 = fmul double %1002, %1001
  %1004 = fadd double %998, %1003
  %1005 = fdiv double %995, %1004
  %1006 = fmul double %1005, %1005
  %1007 = fadd double %937, %1006
  %1008 = add nuw nsw i64 %936, 1
  %1009 = icmp eq i64 %1008, %928
  br i1 %1009, label %1010, label %934, !llvm.loop !34

1010:                                             ; preds = %934, %925
  %1011 = phi double [ 0.000000e+00, %925 ], [ %1007, %934 ]
  %1012 = phi i32 [ 1, %925 ], [ %950, %934 ]
  %1013 = zext nneg i32 %1012 to i64
  %1014 = xor i64 %1013, 4294967295
  %1015 = and i64 %919, %1014
  %1016 = icmp eq i64 %1015, 0
  %1017 = select i1 %1016, double %839, double 0x7FF0000000000000
  %1018 = load ptr, ptr %77, align 8, !noalias !28
  %1019 = getelementptr inbounds i8, ptr %1018, i64 8
  %1020 = load i64, ptr %1019, align 8, !noalias !28
  %1021 = load i64, ptr %138, align 8, !noalias !28
  %1022 = load ptr, ptr %79, align 8, !noalias !28
  %1023 = getelementptr inbounds i8, ptr %1022, i64 40
  %1024 = load i64, ptr %1023, align 8, !noalias !28
  %1025 = load ptr, ptr %139, align 8, !noalias !28
  %1026 = load ptr, ptr %140, align 8, !noalias !28
  %1027 = load ptr, ptr %141, align 8, !noalias !28
  %1028 = load ptr, ptr %137, align 8, !noalias !28
  tail call fastcc void @real_solve(ptr noundef %1027, i64 noundef %1021, ptr noundef %1028, ptr noundef %1025) #8, !noalias !28
  %1029 = load ptr, ptr %142, align 8, !noalias !28
  %1030 = load ptr, ptr %143, align 8, !noalias !28
  tail call fastcc void @pair_solve(ptr noundef %1029, i64 noundef %1021, ptr noundef %1030, ptr noundef %1026) #8, !noalias !28
  %1031 = icmp sgt i64 %1024, 0
  br i1 %1031, label %1032, label %1040

1032:                                             ; preds = %1010
  %1033 = load ptr, ptr %141, align 8, !noalias !28
  %1034 = load ptr, ptr %137, align 8, !noalias !28
  %1035 = getelementptr inbounds double, ptr %1025, i64 %1021
  tail call fastcc void @real_solve_columns(ptr noundef %1033, i64 noundef %1021, ptr noundef %1034, ptr noundef %1035, i64 noundef %1024) #8, !noalias !28
  %1036 = load ptr, ptr %142, align 8, !noalias !28
  %1037 = load ptr, ptr %143, align 8, !noalias !28
  %1038 = shl nsw i64 %1021, 4
  %1039 = getelementptr inbounds i8, ptr %1026, i64 %1038
  tail call fastcc void @pair_solve_columns(ptr noundef %1036, i64 noundef %1021, ptr noundef %1037, ptr noundef %1039, i64 noundef %1024) #8, !noalias !28
  br label %1040

1040:                                             ; preds = %1032, %1010
  %1041 = icmp sgt i64 %1020, 0
  br i1 %1041, label %1042, label %1077

1042:                                             ; preds = %1040
  %1043 = load ptr, ptr %78, align 8, !noalias !28
  %1044 = load ptr, ptr %144, align 8, !noalias !28
  %1045 = load ptr, ptr %80, align 8, !noalias !28
  br label %1046

1046:                                             ; preds = %1042, %1046
  %1047 = phi double [ 0.000000e+00, %1042 ], [ %1074, %1046 ]
  %1048 = phi i64 [ 0, %1042 ], [ %1075, %1046 ]
  %1049 = getelementptr inbounds double, ptr %1043, i64 %1048
  %1050 = load double, ptr %1049, align 8, !noalias !28
  %1051 = getelementptr inbounds double, ptr %1044, i64 %1048
  %1052 = load double, ptr %1051, align 8, !noalias !28
  %1053 = getelementptr inbounds double, ptr %1045, i64 %1048
  %1054 = load double, ptr %1053, align 8, !noalias !28
  %1055 = tail call double @llvm.fabs.f64(double %1050)
  %1056 = fmul double %1055, %1054
  %1057 = fadd double %1052, %1056
  %1058 = getelementptr inbounds double, ptr %1025, i64 %1048
  %1059 = load double, ptr %1058, align 8, !noalias !28
  %1060 = fdiv double %1059, %1057
  %1061 = shl nuw nsw i64 %1048, 1
  %1062 = getelementptr inbounds double, ptr %1026, i64 %1061
  %1063 = load double, ptr %1062, align 8, !noalias !28
  %1064 = or disjoint i64 %1061, 1
  %1065 = getelementptr inbounds double, ptr %1026, i64 %1064
  %1066 = load double, ptr %1065, align 8, !noalias !28
  %1067 = fdiv double %1063, %1057
  %1068 = fdiv double %1066, %1057
  %1069 = fmul double %1060, %1060
  %1070 = fmul double %1067, %1067
  %1071 = fadd double %1069, %1070
  %1072 = fmul double %1068, %1068
  %1073 = fadd double %1071, %1072
  %1074 = fadd double %1047, %1073
  %1075 = add nuw nsw i64 %1048, 1
  %1076 = icmp eq i64 %1075, %1020
  br i1 %1076, label %1077, label %1046, !llvm.loop !35

1077:                                             ; preds = %1046, %1040
  %1078 = phi double [ 0.000000e+00, %1040 ], [ %1074, %1046 ]
  %1079 = mul nsw i64 %1020, 3
  %1080 = sitofp i64 %1079 to double
  %1081 = fdiv double %1078, %1080
  %1082 = tail call double @llvm.sqrt.f64(double %1081)
  %1083 = fcmp oeq double %1082, 0.000000e+00
  %1084 = fcmp ogt double %1011, 0.000000e+00
  %1085 = and i1 %1084, %1083
  %1086 = zext i1 %1085 to i64
  %1087 = xor i64 %1086, -1
  %1088 = and i64 %1013, %1087
  %1089 = and i64 %1088, %919
  %1090 = xor i64 %835, -1
  %1091 = and i64 %1089, %1090
  %1092 = trunc nuw nsw i64 %1091 to i32
  %1093 = fcmp ogt double %831, 0.000000e+00
  %1094 = and i32 %1092, 1
  %1095 = select i1 %1093, i32 %1094, i32 0
  %1096 = fdiv double %1082, %831
  %1097 = icmp eq i32 %1095, 0
  %1098 = select i1 %1097, double %1017, double %1096
  %1099 = fsub double 1.000000e+00, %1098
  %1100 = fdiv double %1082, %1099
  %1101 = icmp ult i64 %834, 5
  br i1 %1101, label %1194, label %1102

1102:                                             ; preds = %1194, %1077
  %1103 = phi double [ %1100, %1077 ], [ %1197, %1194 ]
  %1104 = fcmp oge double %1098, 1.000000e+00
  %1105 = fcmp ogt double %1103, %409
  %1106 = or i1 %1104, %1105
  %1107 = xor i32 %1095, -1
  %1108 = zext i32 %1107 to i64
  %1109 = select i1 %1106, i64 %1108, i64 2147483647
  %1110 = and i64 %1109, %1089
  %1111 = xor i64 %1110, -1
  %1112 = and i64 %849, %1111
  %1113 = or i64 %1112, %833
  %1114 = load ptr, ptr %77, align 8, !noalias !28
  %1115 = getelementptr inbounds i8, ptr %1114, i64 8
  %1116 = load i64, ptr %1115, align 8, !noalias !28
  %1117 = load ptr, ptr %124, align 8, !noalias !28
  %1118 = load ptr, ptr %125, align 8, !noalias !28
  %1119 = icmp sgt i64 %1116, 0
  br i1 %1119, label %1120, label %1180

1120:                                             ; preds = %1102
  %1121 = icmp eq i64 %1110, 0
  %1122 = getelementptr double, ptr %1118, i64 %1116
  %1123 = shl i64 %1116, 4
  %1124 = getelementptr i8, ptr %1118, i64 %1123
  %1125 = icmp eq i64 %1110, 0
  br label %1126

1126:                                             ; preds = %1120, %1155
  %1127 = phi i64 [ 0, %1120 ], [ %1156, %1155 ]
  %1128 = load ptr, ptr %140, align 8, !noalias !28
  %1129 = shl nuw nsw i64 %1127, 1
  %1130 = getelementptr inbounds double, ptr %1128, i64 %1129
  %1131 = load double, ptr %1130, align 8, !noalias !28
  %1132 = or disjoint i64 %1129, 1
  %1133 = getelementptr inbounds double, ptr %1128, i64 %1132
  %1134 = load double, ptr %1133, align 8, !noalias !28
  %1135 = load ptr, ptr %139, align 8, !noalias !28
  %1136 = getelementptr inbounds double, ptr %1135, i64 %1127
  %1137 = load double, ptr %1136, align 8, !noalias !28
  store double %1137, ptr %4, align 16, !noalias !28
  store double %1131, ptr %145, align 8, !noalias !28
  store double %1134, ptr %146, align 16, !noalias !28
  %1138 = getelementptr double, ptr %1118, i64 %1127
  br label %1144

1139:                                             ; preds = %1144
  %1140 = getelementptr inbounds double, ptr %1118, i64 %1127
  %1141 = getelementptr double, ptr %1122, i64 %1127
  %1142 = getelementptr double, ptr %1124, i64 %1127
  %1143 = getelementptr double, ptr %1117, i64 %1127
  br label %1158

1144:                                             ; preds = %1126, %1144
  %1145 = phi i64 [ 0, %1126 ], [ %1153, %1144 ]
  %1146 = mul nuw nsw i64 %1116, %1145
  %1147 = getelementptr double, ptr %1138, i64 %1146
  %1148 = load double, ptr %1147, align 8, !noalias !28
  %1149 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %1145
  %1150 = load double, ptr %1149, align 8, !noalias !28
  %1151 = fadd double %1148, %1150
  %1152 = select i1 %1121, double %1148, double %1151
  store double %1152, ptr %1147, align 8, !noalias !28
  %1153 = add nuw nsw i64 %1145, 1
  %1154 = icmp eq i64 %1153, 3
  br i1 %1154, label %1139, label %1144, !llvm.loop !36

1155:                                             ; preds = %1158
  %1156 = add nuw nsw i64 %1127, 1
  %1157 = icmp eq i64 %1156, %1116
  br i1 %1157, label %1180, label %1126, !llvm.loop !37

1158:                                             ; preds = %1139, %1158
  %1159 = phi i64 [ 0, %1139 ], [ %1178, %1158 ]
  %1160 = mul nuw nsw i64 %1116, %1159
  %1161 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1159
  %1162 = load double, ptr %1161, align 8, !noalias !28
  %1163 = load double, ptr %1140, align 8, !noalias !28
  %1164 = fmul double %1162, %1163
  %1165 = getelementptr inbounds i8, ptr %1161, i64 8
  %1166 = load double, ptr %1165, align 8, !noalias !28
  %1167 = load double, ptr %1141, align 8, !noalias !28
  %1168 = fmul double %1166, %1167
  %1169 = fadd double %1164, %1168
  %1170 = getelementptr inbounds i8, ptr %1161, i64 16
  %1171 = load double, ptr %1170, align 8, !noalias !28
  %1172 = load double, ptr %1142, align 8, !noalias !28
  %1173 = fmul double %1171, %1172
  %1174 = fadd double %1169, %1173
  %1175 = getelementptr double, ptr %1143, i64 %1160
  %1176 = load double, ptr %1175, align 8, !noalias !28
  %1177 = select i1 %1125, double %1176, double %1174
  store double %1177, ptr %1175, align 8, !noalias !28
  %1178 = add nuw nsw i64 %1159, 1
  %1179 = icmp eq i64 %1178, 3
  br i1 %1179, label %1155, label %1158, !llvm.loop !38

1180:                                             ; preds = %1155, %1102
  %1181 = fdiv double %1098, %1099
  %1182 = fmul double %1082, %1181
  %1183 = fcmp olt double %1182, %409
  %1184 = and i1 %1093, %1183
  %1185 = or i1 %1083, %1184
  %1186 = and i64 %1090, 1
  %1187 = select i1 %1185, i64 %1186, i64 0
  %1188 = and i64 %1110, %1187
  %1189 = add nuw nsw i64 %834, 1
  %1190 = uitofp nneg i64 %1189 to double
  %1191 = icmp eq i64 %1188, 0
  %1192 = select i1 %1191, double %838, double %1190
  %1193 = or i64 %1188, %835
  br i1 %821, label %1200, label %1274

1194:                                             ; preds = %1077, %1194
  %1195 = phi i64 [ %1198, %1194 ], [ %834, %1077 ]
  %1196 = phi double [ %1197, %1194 ], [ %1100, %1077 ]
  %1197 = fmul double %1098, %1196
  %1198 = add nuw nsw i64 %1195, 1
  %1199 = icmp ult i64 %1195, 4
  br i1 %1199, label %1194, label %1102, !llvm.loop !39

1200:                                             ; preds = %1180
  %1201 = load i64, ptr %138, align 8, !noalias !28
  %1202 = load ptr, ptr %79, align 8, !noalias !28
  %1203 = getelementptr inbounds i8, ptr %1202, i64 40
  %1204 = load i64, ptr %1203, align 8, !noalias !28
  %1205 = load ptr, ptr %77, align 8, !noalias !28
  %1206 = getelementptr inbounds i8, ptr %1205, i64 8
  %1207 = load i64, ptr %1206, align 8, !noalias !28
  %1208 = load ptr, ptr %125, align 8, !noalias !28
  %1209 = icmp sgt i64 %1204, 0
  br i1 %1209, label %1210, label %1269

1210:                                             ; preds = %1200
  %1211 = icmp sgt i64 %1201, 0
  br label %1212

1212:                                             ; preds = %1210, %1220
  %1213 = phi double [ 0.000000e+00, %1210 ], [ %1228, %1220 ]
  %1214 = phi i64 [ 0, %1210 ], [ %1229, %1220 ]
  br i1 %1211, label %1215, label %1220

1215:                                             ; preds = %1212
  %1216 = add nuw i64 %1214, %1201
  %1217 = load ptr, ptr %139, align 8, !noalias !28
  %1218 = load ptr, ptr %78, align 8, !noalias !28
  %1219 = load ptr, ptr %140, align 8, !noalias !28
  br label %1231

1220:                                             ; preds = %1255, %1212
  %1221 = phi double [ 0.000000e+00, %1212 ], [ %1266, %1255 ]
  %1222 = phi double [ 0.000000e+00, %1212 ], [ %1256, %1255 ]
  %1223 = fcmp ule double %1221, 0.000000e+00
  %1224 = fdiv double %1222, %1221
  %1225 = select i1 %1223, double 1.000000e+00, double %1224
  %1226 = fmul double %1213, %1221
  %1227 = fcmp ule double %1222, %1226
  %1228 = select i1 %1227, double %1213, double %1225
  %1229 = add nuw nsw i64 %1214, 1
  %1230 = icmp eq i64 %1229, %1204
  br i1 %1230, label %1269, label %1212, !llvm.loop !40

1231:                                             ; preds = %1215, %1255
  %1232 = phi double [ 0.000000e+00, %1215 ], [ %1256, %1255 ]
  %1233 = phi double [ 0.000000e+00, %1215 ], [ %1266, %1255 ]
  %1234 = phi i64 [ 0, %1215 ], [ %1257, %1255 ]
  %1235 = mul nuw nsw i64 %1234, %1204
  %1236 = add i64 %1216, %1235
  %1237 = getelementptr inbounds double, ptr %1217, i64 %1236
  %1238 = load double, ptr %1237, align 8, !noalias !28
  %1239 = getelementptr inbounds double, ptr %1218, i64 %1236
  %1240 = load double, ptr %1239, align 8, !noalias !28
  %1241 = shl nsw i64 %1236, 1
  %1242 = getelementptr inbounds double, ptr %1219, i64 %1241
  %1243 = load double, ptr %1242, align 8, !noalias !28
  %1244 = or disjoint i64 %1241, 1
  %1245 = getelementptr inbounds double, ptr %1219, i64 %1244
  %1246 = load double, ptr %1245, align 8, !noalias !28
  %1247 = fmul double %1238, %1238
  %1248 = fmul double %1243, %1243
  %1249 = fmul double %1246, %1246
  %1250 = fadd double %1248, %1249
  %1251 = fadd double %1247, %1250
  %1252 = fmul double %1240, %1240
  %1253 = fadd double %1233, %1252
  %1254 = getelementptr double, ptr %1208, i64 %1236
  br label %1259

1255:                                             ; preds = %1259
  %1256 = fadd double %1232, %1251
  %1257 = add nuw nsw i64 %1234, 1
  %1258 = icmp eq i64 %1257, %1201
  br i1 %1258, label %1220, label %1231, !llvm.loop !41

1259:                                             ; preds = %1231, %1259
  %1260 = phi i64 [ 0, %1231 ], [ %1267, %1259 ]
  %1261 = phi double [ %1253, %1231 ], [ %1266, %1259 ]
  %1262 = mul nsw i64 %1207, %1260
  %1263 = getelementptr double, ptr %1254, i64 %1262
  %1264 = load double, ptr %1263, align 8, !noalias !28
  %1265 = fmul double %1264, %1264
  %1266 = fadd double %1261, %1265
  %1267 = add nuw nsw i64 %1260, 1
  %1268 = icmp eq i64 %1267, 3
  br i1 %1268, label %1255, label %1259, !llvm.loop !42

1269:                                             ; preds = %1220, %1200
  %1270 = phi double [ 0.000000e+00, %1200 ], [ %1228, %1220 ]
  %1271 = fcmp ole double %1270, %411
  %1272 = and i64 %1193, 1
  %1273 = select i1 %1271, i64 %1272, i64 0
  br label %1274

1274:                                             ; preds = %1269, %1180
  %1275 = phi i64 [ %1273, %1269 ], [ %1193, %1180 ]
  %1276 = xor i64 %1275, -1
  %1277 = and i64 %1110, %1276
  %1278 = icmp eq i64 %1277, 0
  %1279 = select i1 %1278, i32 2, i32 0
  %1280 = select i1 %1278, double %831, double %1082
  br label %1281

1281:                                             ; preds = %1274, %921
  %1282 = phi double [ %916, %921 ], [ %846, %1274 ]
  %1283 = phi double [ %839, %921 ], [ %845, %1274 ]
  %1284 = phi double [ %838, %921 ], [ %844, %1274 ]
  %1285 = phi i64 [ %917, %921 ], [ %843, %1274 ]
  %1286 = phi i64 [ %918, %921 ], [ %842, %1274 ]
  %1287 = phi i64 [ %924, %921 ], [ %841, %1274 ]
  %1288 = phi double [ %839, %921 ], [ %1098, %1274 ]
  %1289 = phi double [ %838, %921 ], [ %1192, %1274 ]
  %1290 = phi i64 [ %924, %921 ], [ %1193, %1274 ]
  %1291 = phi i32 [ 1, %921 ], [ %1279, %1274 ]
  %1292 = phi i64 [ %833, %921 ], [ %1113, %1274 ]
  %1293 = phi i64 [ %849, %921 ], [ %1277, %1274 ]
  %1294 = phi double [ %831, %921 ], [ %1280, %1274 ]
  %1295 = icmp eq i32 %1291, 0
  br i1 %1295, label %827, label %1296

1296:                                             ; preds = %1281, %827
  %1297 = phi i32 [ %1291, %1281 ], [ 2, %827 ]
  %1298 = icmp eq i32 %1297, 2
  br i1 %1298, label %1299, label %1302

1299:                                             ; preds = %1296
  %1300 = xor i64 %1292, -1
  %1301 = and i64 %1290, %1300
  br label %1302

1302:                                             ; preds = %1296, %1299
  %1303 = phi double [ %916, %1299 ], [ %1282, %1296 ]
  %1304 = phi double [ %1288, %1299 ], [ %1283, %1296 ]
  %1305 = phi double [ %1289, %1299 ], [ %1284, %1296 ]
  %1306 = phi i64 [ %917, %1299 ], [ %1285, %1296 ]
  %1307 = phi i64 [ %918, %1299 ], [ %1286, %1296 ]
  %1308 = phi i64 [ %1301, %1299 ], [ %1287, %1296 ]
  %1309 = fadd double %647, %1303
  %1310 = fcmp ogt double %1305, 2.000000e+00
  %1311 = fcmp ogt double %1304, 1.000000e-03
  %1312 = and i1 %1311, %1310
  %1313 = icmp eq i64 %1308, %725
  br i1 %1313, label %1381, label %1314

1314:                                             ; preds = %1302
  %1315 = xor i64 %1308, -1
  %1316 = and i64 %725, %1315
  %1317 = load ptr, ptr %79, align 8, !noalias !15
  %1318 = getelementptr inbounds i8, ptr %1317, i64 16
  %1319 = load i64, ptr %1318, align 8, !noalias !15
  %1320 = xor i64 %1307, -1
  %1321 = and i64 %1319, %1320
  %1322 = and i64 %1321, %1316
  %1323 = tail call double @llvm.fabs.f64(double %1304)
  %1324 = fcmp ueq double %1323, 0x7FF0000000000000
  %1325 = select i1 %1324, double 4.000000e+00, double 7.000000e+00
  %1326 = and i64 %1307, 4294967295
  %1327 = icmp eq i64 %1326, 0
  %1328 = select i1 %1327, double %1325, double 3.000000e+00
  %1329 = icmp eq i64 %1316, 0
  %1330 = select i1 %1329, double %724, double %1328
  %1331 = icmp eq i64 %1322, 0
  br i1 %1331, label %1352, label %1332

1332:                                             ; preds = %1314
  %1333 = load i64, ptr %147, align 8, !noalias !15
  %1334 = icmp sgt i64 %1333, 0
  br i1 %1334, label %1335, label %1347

1335:                                             ; preds = %1332, %1335
  %1336 = phi i32 [ %1343, %1335 ], [ 0, %1332 ]
  %1337 = phi i64 [ %1344, %1335 ], [ 0, %1332 ]
  %1338 = load ptr, ptr %148, align 8, !noalias !15
  %1339 = getelementptr inbounds double, ptr %1338, i64 %1337
  %1340 = load double, ptr %1339, align 8, !noalias !15
  %1341 = fcmp une double %1340, 0.000000e+00
  %1342 = zext i1 %1341 to i32
  %1343 = or i32 %1336, %1342
  store double 0.000000e+00, ptr %1339, align 8, !noalias !15
  %1344 = add nuw nsw i64 %1337, 1
  %1345 = load i64, ptr %147, align 8, !noalias !15
  %1346 = icmp slt i64 %1344, %1345
  br i1 %1346, label %1335, label %1347, !llvm.loop !43

1347:                                             ; preds = %1335, %1332
  %1348 = phi i32 [ 0, %1332 ], [ %1343, %1335 ]
  %1349 = zext nneg i32 %1348 to i64
  %1350 = and i64 %1322, %1349
  %1351 = xor i64 %1350, -1
  br label %1352

1352:                                             ; preds = %1314, %1347
  %1353 = phi i64 [ %1351, %1347 ], [ -1, %1314 ]
  %1354 = and i64 %1353, %1322
  %1355 = getelementptr inbounds i8, ptr %1317, i64 24
  %1356 = load i64, ptr %1355, align 8, !noalias !15
  %1357 = and i64 %1356, %1353
  store i64 %1357, ptr %1355, align 8, !noalias !15
  %1358 = xor i64 %1354, -1
  %1359 = load i64, ptr %1318, align 8, !noalias !15
  %1360 = and i64 %1359, %1358
  store i64 %1360, ptr %1318, align 8, !noalias !15
  %1361 = fmul double %511, 5.000000e-01
  %1362 = icmp eq i64 %1354, 0
  %1363 = select i1 %1362, double %723, double %1361
  %1364 = fmul double %511, 2.500000e-01
  %1365 = select i1 %1327, double %1363, double %1364
  %1366 = load ptr, ptr %116, align 8, !noalias !15
  %1367 = getelementptr inbounds i8, ptr %1366, i64 8
  %1368 = load double, ptr %1367, align 8, !noalias !15
  %1369 = select i1 %1327, double %1368, double 0.000000e+00
  store double %1369, ptr %1367, align 8, !noalias !15
  %1370 = and i64 %1353, %1316
  %1371 = load ptr, ptr %79, align 8, !noalias !15
  %1372 = getelementptr inbounds i8, ptr %1371, i64 8
  %1373 = load i64, ptr %1372, align 8, !noalias !15
  %1374 = xor i64 %1370, -1
  %1375 = and i64 %1373, %1374
  %1376 = getelementptr inbounds i8, ptr %1371, i64 16
  %1377 = load i64, ptr %1376, align 8, !noalias !15
  %1378 = xor i64 %1377, -1
  %1379 = and i64 %1370, %1378
  %1380 = or disjoint i64 %1379, %1375
  store i64 %1380, ptr %1372, align 8, !noalias !15
  br label %1381

1381:                                             ; preds = %1352, %1302
  %1382 = phi double [ %723, %1302 ], [ %1365, %1352 ]
  %1383 = phi double [ %724, %1302 ], [ %1330, %1352 ]
  %1384 = icmp eq i64 %1308, 0
  %1385 = icmp ne i64 %1306, 0
  %1386 = select i1 %1384, i1 true, i1 %1385
  br i1 %1386, label %1588, label %1387

1387:                                             ; preds = %1381
  %1388 = icmp sgt i64 %521, 0
  br i1 %1388, label %1389, label %1391

1389:                                             ; preds = %1387
  %1390 = shl i64 %521, 4
  br label %1574

1391:                                             ; preds = %1574, %1387
  %1392 = getelementptr inbounds i8, ptr %522, i64 32
  %1393 = load i64, ptr %1392, align 8, !noalias !15
  %1394 = load ptr, ptr %77, align 8, !noalias !15
  %1395 = getelementptr inbounds i8, ptr %1394, i64 8
  %1396 = load i64, ptr %1395, align 8, !noalias !15
  %1397 = load i64, ptr %151, align 8, !noalias !15
  %1398 = load ptr, ptr %152, align 8, !noalias !15
  %1399 = load ptr, ptr %153, align 8, !noalias !15
  %1400 = icmp sgt i64 %1396, 0
  br i1 %1400, label %1401, label %1403

1401:                                             ; preds = %1391
  %1402 = shl i64 %1396, 4
  br label %1417

1403:                                             ; preds = %1417, %1391
  %1404 = load ptr, ptr %155, align 8, !noalias !15
  %1405 = load ptr, ptr %150, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1404, i64 noundef %1397, ptr noundef %1405, ptr noundef %1399) #8, !noalias !15
  %1406 = load ptr, ptr %156, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %1399, ptr noundef %1406, ptr noundef nonnull %78, i64 noundef %1396) #8, !noalias !15
  %1407 = load double, ptr %5, align 8, !noalias !15
  %1408 = fcmp olt double %1407, 1.000000e+00
  %1409 = zext i1 %1408 to i64
  %1410 = xor i64 %1409, -1
  %1411 = and i64 %1393, %1410
  %1412 = and i64 %1411, %1308
  %1413 = and i64 %1308, %1409
  %1414 = icmp eq i64 %1412, 0
  br i1 %1414, label %1507, label %1415

1415:                                             ; preds = %1403
  %1416 = icmp sgt i64 %1396, 0
  br i1 %1416, label %1470, label %1442

1417:                                             ; preds = %1401, %1417
  %1418 = phi i64 [ 0, %1401 ], [ %1440, %1417 ]
  %1419 = load ptr, ptr %124, align 8, !noalias !15
  %1420 = getelementptr inbounds double, ptr %1419, i64 %1418
  %1421 = load double, ptr %1420, align 8, !noalias !15
  %1422 = fmul double %1421, 0x402418FD8BAFFE05
  %1423 = getelementptr double, ptr %1419, i64 %1396
  %1424 = getelementptr double, ptr %1423, i64 %1418
  %1425 = load double, ptr %1424, align 8, !noalias !15
  %1426 = fmul double %1425, 0x3FF61D41B2D54580
  %1427 = fsub double %1426, %1422
  %1428 = getelementptr i8, ptr %1419, i64 %1402
  %1429 = getelementptr double, ptr %1428, i64 %1418
  %1430 = load double, ptr %1429, align 8, !noalias !15
  %1431 = fmul double %1430, 0x3FD5555555555555
  %1432 = fsub double %1427, %1431
  %1433 = fdiv double %1432, %511
  %1434 = getelementptr inbounds double, ptr %1398, i64 %1418
  store double %1433, ptr %1434, align 8, !noalias !15
  %1435 = load ptr, ptr %154, align 8, !noalias !15
  %1436 = getelementptr inbounds double, ptr %1435, i64 %1418
  %1437 = load double, ptr %1436, align 8, !noalias !15
  %1438 = fadd double %1437, %1433
  %1439 = getelementptr inbounds double, ptr %1399, i64 %1418
  store double %1438, ptr %1439, align 8, !noalias !15
  %1440 = add nuw nsw i64 %1418, 1
  %1441 = icmp eq i64 %1440, %1396
  br i1 %1441, label %1403, label %1417, !llvm.loop !44

1442:                                             ; preds = %1470, %1415
  %1443 = and i64 %1412, 4294967295
  %1444 = icmp eq i64 %1443, 0
  %1445 = select i1 %1444, double 0.000000e+00, double 1.000000e+00
  %1446 = fadd double %1309, %1445
  %1447 = load ptr, ptr %158, align 8, !noalias !15
  %1448 = load ptr, ptr %159, align 8, !noalias !15
  %1449 = load ptr, ptr %160, align 8, !noalias !15
  store double %434, ptr %1449, align 8, !noalias !15
  %1450 = load i64, ptr %161, align 8, !noalias !15
  %1451 = icmp sgt i64 %1450, 0
  br i1 %1451, label %1452, label %1453

1452:                                             ; preds = %1442
  tail call fastcc void @sample(ptr noundef nonnull %77) #8, !noalias !15
  br label %1453

1453:                                             ; preds = %1452, %1442
  %1454 = load ptr, ptr %77, align 8, !noalias !15
  %1455 = load i64, ptr %1454, align 8, !noalias !15
  %1456 = load ptr, ptr %160, align 8, !noalias !15
  %1457 = load ptr, ptr %162, align 8, !noalias !15
  %1458 = load ptr, ptr %163, align 8, !noalias !15
  %1459 = inttoptr i64 %1455 to ptr
  %1460 = load ptr, ptr %1459, align 8, !noalias !15
  %1461 = tail call i32 %1460(ptr noundef %1456, ptr noundef %1447, ptr noundef %1457, ptr noundef %1458, ptr noundef %1448) #9, !noalias !15
  %1462 = sext i32 %1461 to i64
  %1463 = icmp slt i32 %1461, 0
  %1464 = select i1 %1463, i64 %1462, i64 %1306
  %1465 = trunc i64 %1412 to i32
  %1466 = and i32 %1461, %1465
  %1467 = icmp eq i32 %1466, 0
  %1468 = select i1 %1467, double %1383, double 3.000000e+00
  %1469 = icmp sgt i64 %1396, 0
  br i1 %1469, label %1496, label %1482

1470:                                             ; preds = %1415, %1470
  %1471 = phi i64 [ %1480, %1470 ], [ 0, %1415 ]
  %1472 = load ptr, ptr %157, align 8, !noalias !15
  %1473 = load ptr, ptr %78, align 8, !noalias !15
  %1474 = getelementptr inbounds double, ptr %1473, i64 %1471
  %1475 = load double, ptr %1474, align 8, !noalias !15
  %1476 = getelementptr inbounds double, ptr %1399, i64 %1471
  %1477 = load double, ptr %1476, align 8, !noalias !15
  %1478 = fadd double %1475, %1477
  %1479 = getelementptr inbounds double, ptr %1472, i64 %1471
  store double %1478, ptr %1479, align 8, !noalias !15
  %1480 = add nuw nsw i64 %1471, 1
  %1481 = icmp eq i64 %1480, %1396
  br i1 %1481, label %1442, label %1470, !llvm.loop !45

1482:                                             ; preds = %1496, %1453
  %1483 = load ptr, ptr %155, align 8, !noalias !15
  %1484 = load ptr, ptr %150, align 8, !noalias !15
  tail call fastcc void @real_solve(ptr noundef %1483, i64 noundef %1397, ptr noundef %1484, ptr noundef %1399) #8, !noalias !15
  %1485 = load ptr, ptr %156, align 8, !noalias !15
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1399, ptr noundef %1485, ptr noundef nonnull %78, i64 noundef %1396) #8, !noalias !15
  %1486 = load double, ptr %6, align 8, !noalias !15
  %1487 = xor i64 %1462, -1
  %1488 = and i64 %1412, %1487
  %1489 = fcmp olt double %1486, 1.000000e+00
  %1490 = and i64 %1488, 1
  %1491 = select i1 %1489, i64 %1490, i64 0
  %1492 = or i64 %1491, %1413
  %1493 = and i64 %1488, 4294967295
  %1494 = icmp eq i64 %1493, 0
  %1495 = select i1 %1494, double %1407, double %1486
  br label %1507

1496:                                             ; preds = %1453, %1496
  %1497 = phi i64 [ %1505, %1496 ], [ 0, %1453 ]
  %1498 = load ptr, ptr %159, align 8, !noalias !15
  %1499 = getelementptr inbounds double, ptr %1498, i64 %1497
  %1500 = load double, ptr %1499, align 8, !noalias !15
  %1501 = getelementptr inbounds double, ptr %1398, i64 %1497
  %1502 = load double, ptr %1501, align 8, !noalias !15
  %1503 = fadd double %1500, %1502
  %1504 = getelementptr inbounds double, ptr %1399, i64 %1497
  store double %1503, ptr %1504, align 8, !noalias !15
  %1505 = add nuw nsw i64 %1497, 1
  %1506 = icmp eq i64 %1505, %1396
  br i1 %1506, label %1482, label %1496, !llvm.loop !46

1507:                                             ; preds = %1403, %1482
  %1508 = phi double [ %1309, %1403 ], [ %1446, %1482 ]
  %1509 = phi i64 [ %1306, %1403 ], [ %1464, %1482 ]
  %1510 = phi i64 [ %1413, %1403 ], [ %1492, %1482 ]
  %1511 = phi double [ %1383, %1403 ], [ %1468, %1482 ]
  %1512 = phi double [ %1407, %1403 ], [ %1495, %1482 ]
  %1513 = fcmp olt double %1512, 1.000000e-10
  %1514 = select i1 %1513, double 1.000000e-10, double %1512
  %1515 = load ptr, ptr %116, align 8, !noalias !15
  %1516 = getelementptr inbounds i8, ptr %1515, i64 24
  %1517 = load double, ptr %1516, align 8, !noalias !15
  %1518 = fadd double %1305, 1.200000e+01
  %1519 = fdiv double 0x4027666666666667, %1518
  %1520 = tail call double @llvm.sqrt.f64(double %1514)
  %1521 = tail call double @llvm.sqrt.f64(double %1520)
  %1522 = fdiv double 1.000000e+00, %1521
  %1523 = fmul double %1519, %1522
  %1524 = fcmp ogt double %1523, 2.000000e-01
  %1525 = select i1 %1524, double %1523, double 2.000000e-01
  %1526 = tail call double @llvm.fabs.f64(double %1512)
  %1527 = fcmp ueq double %1526, 0x7FF0000000000000
  %1528 = select i1 %1527, double 2.500000e-01, double %1525
  %1529 = fmul double %511, %1528
  %1530 = getelementptr inbounds i8, ptr %1515, i64 16
  %1531 = load double, ptr %1530, align 8, !noalias !15
  %1532 = fdiv double %511, %1531
  %1533 = fdiv double %1517, %1514
  %1534 = tail call double @llvm.sqrt.f64(double %1533)
  %1535 = tail call double @llvm.sqrt.f64(double %1534)
  %1536 = fmul double %1532, %1535
  %1537 = fcmp ule double %1517, 0.000000e+00
  %1538 = fcmp olt double %1536, 1.000000e+00
  %1539 = select i1 %1538, double %1536, double 1.000000e+00
  %1540 = select i1 %1537, double 1.000000e+00, double %1539
  %1541 = fmul double %1523, %1540
  %1542 = fcmp olt double %1541, 1.000000e+01
  %1543 = select i1 %1542, double %1541, double 1.000000e+01
  %1544 = fcmp ule double %1543, 1.000000e+00
  %1545 = fcmp uge double %1543, 1.200000e+00
  %1546 = or i1 %1544, %1545
  %1547 = select i1 %1546, i1 true, i1 %1312
  %1548 = load double, ptr %1515, align 8, !noalias !15
  %1549 = fcmp ogt double %1543, 2.000000e-01
  %1550 = select i1 %1549, double %1543, double 2.000000e-01
  %1551 = fmul double %511, %1550
  %1552 = select i1 %1547, double %1551, double %1548
  %1553 = icmp eq i64 %1510, 0
  %1554 = select i1 %1553, double %1529, double %1552
  %1555 = and i64 %1308, 4294967295
  %1556 = icmp eq i64 %1555, 0
  %1557 = select i1 %1556, double %1382, double %1554
  %1558 = xor i64 %1510, -1
  %1559 = and i64 %1308, %1558
  %1560 = load ptr, ptr %79, align 8, !noalias !15
  %1561 = getelementptr inbounds i8, ptr %1560, i64 32
  %1562 = load i64, ptr %1561, align 8, !noalias !15
  %1563 = or i64 %1562, %1559
  store i64 %1563, ptr %1561, align 8, !noalias !15
  %1564 = load ptr, ptr %79, align 8, !noalias !15
  %1565 = getelementptr inbounds i8, ptr %1564, i64 8
  %1566 = load i64, ptr %1565, align 8, !noalias !15
  %1567 = xor i64 %1559, -1
  %1568 = and i64 %1566, %1567
  %1569 = getelementptr inbounds i8, ptr %1564, i64 16
  %1570 = load i64, ptr %1569, align 8, !noalias !15
  %1571 = xor i64 %1570, -1
  %1572 = and i64 %1559, %1571
  %1573 = or disjoint i64 %1572, %1568
  store i64 %1573, ptr %1565, align 8, !noalias !15
  br label %1588

1574:                                             ; preds = %1389, %1574
  %1575 = phi i64 [ 0, %1389 ], [ %1586, %1574 ]
  %1576 = load ptr, ptr %149, align 8, !noalias !15
  %1577 = load ptr, ptr %78, align 8, !noalias !15
  %1578 = getelementptr inbounds double, ptr %1577, i64 %1575
  %1579 = load double, ptr %1578, align 8, !noalias !15
  %1580 = load ptr, ptr %124, align 8, !noalias !15
  %1581 = getelementptr i8, ptr %1580, i64 %1390
  %1582 = getelementptr double, ptr %1581, i64 %1575
  %1583 = load double, ptr %1582, align 8, !noalias !15
  %1584 = fadd double %1579, %1583
  %1585 = getelementptr inbounds double, ptr %1576, i64 %1575
  store double %1584, ptr %1585, align 8, !noalias !15
  %1586 = add nuw nsw i64 %1575, 1
  %1587 = icmp eq i64 %1586, %521
  br i1 %1587, label %1391, label %1574, !llvm.loop !47

1588:                                             ; preds = %1507, %1381, %722, %635
  %1589 = phi double [ %441, %635 ], [ %441, %722 ], [ %1303, %1381 ], [ %1303, %1507 ]
  %1590 = phi double [ %440, %635 ], [ %440, %722 ], [ %1304, %1381 ], [ %1304, %1507 ]
  %1591 = phi double [ %439, %635 ], [ %439, %722 ], [ %1305, %1381 ], [ %1305, %1507 ]
  %1592 = phi i64 [ %438, %635 ], [ %438, %722 ], [ %1306, %1381 ], [ %1306, %1507 ]
  %1593 = phi i64 [ %437, %635 ], [ %437, %722 ], [ %1307, %1381 ], [ %1307, %1507 ]
  %1594 = phi i64 [ %436, %635 ], [ %436, %722 ], [ %1308, %1381 ], [ %1308, %1507 ]
  %1595 = phi i1 [ false, %635 ], [ false, %722 ], [ %1312, %1381 ], [ %1312, %1507 ]
  %1596 = phi double [ 2.000000e+00, %635 ], [ %724, %722 ], [ %1383, %1381 ], [ %1511, %1507 ]
  %1597 = phi double [ 0.000000e+00, %635 ], [ 0.000000e+00, %722 ], [ 0.000000e+00, %1381 ], [ %1512, %1507 ]
  %1598 = phi double [ %435, %635 ], [ %723, %722 ], [ %1382, %1381 ], [ %1557, %1507 ]
  %1599 = phi double [ %618, %635 ], [ %647, %722 ], [ %1309, %1381 ], [ %1508, %1507 ]
  %1600 = phi i64 [ 0, %635 ], [ %661, %722 ], [ %661, %1381 ], [ %661, %1507 ]
  %1601 = phi i64 [ 1, %635 ], [ 0, %722 ], [ %1306, %1381 ], [ %1509, %1507 ]
  %1602 = phi i64 [ 0, %635 ], [ 0, %722 ], [ 0, %1381 ], [ %1510, %1507 ]
  %1603 = zext i1 %1595 to i64
  %1604 = fptosi double %1599 to i64
  %1605 = load i64, ptr %412, align 8
  %1606 = add nsw i64 %1605, %1604
  store i64 %1606, ptr %412, align 8
  %1607 = load i64, ptr %413, align 8
  %1608 = add nsw i64 %1607, %525
  store i64 %1608, ptr %413, align 8
  %1609 = load i64, ptr %414, align 8
  %1610 = add nsw i64 %1609, %1600
  store i64 %1610, ptr %414, align 8
  %1611 = icmp eq i64 %1601, 0
  br i1 %1611, label %1612, label %2192

1612:                                             ; preds = %1588
  %1613 = icmp eq i64 %1602, 0
  br i1 %1613, label %1614, label %1618

1614:                                             ; preds = %1612
  %1615 = load i64, ptr %399, align 8
  %1616 = add nsw i64 %1615, 1
  store i64 %1616, ptr %399, align 8
  %1617 = fptosi double %1596 to i64
  store i64 %1617, ptr %422, align 8
  br label %2192, !llvm.loop !48

1618:                                             ; preds = %1612
  br i1 %243, label %1619, label %1647

1619:                                             ; preds = %1618
  %1620 = load ptr, ptr %164, align 8
  %1621 = load ptr, ptr %78, align 8
  %1622 = load ptr, ptr %85, align 8
  %1623 = getelementptr inbounds i8, ptr %1622, i64 56
  %1624 = load i64, ptr %1623, align 8
  %1625 = inttoptr i64 %1624 to ptr
  %1626 = tail call i64 %1625(ptr noundef %0, double noundef %510, ptr noundef %1620, ptr noundef %1621) #9
  %1627 = icmp eq i64 %1626, 0
  br i1 %1627, label %1647, label %1628

1628:                                             ; preds = %1619
  %1629 = load i64, ptr %399, align 8
  %1630 = add nsw i64 %1629, 1
  store i64 %1630, ptr %399, align 8
  store i64 6, ptr %415, align 8
  %1631 = fmul double %511, 2.500000e-01
  %1632 = load ptr, ptr %79, align 8
  %1633 = getelementptr inbounds i8, ptr %1632, i64 32
  %1634 = load i64, ptr %1633, align 8
  %1635 = or i64 %1634, 1
  store i64 %1635, ptr %1633, align 8
  %1636 = load ptr, ptr %79, align 8
  %1637 = getelementptr inbounds i8, ptr %1636, i64 8
  %1638 = load i64, ptr %1637, align 8
  %1639 = and i64 %1638, -2
  %1640 = getelementptr inbounds i8, ptr %1636, i64 16
  %1641 = load i64, ptr %1640, align 8
  %1642 = and i64 %1641, 1
  %1643 = or disjoint i64 %1642, %1639
  %1644 = xor i64 %1643, 1
  store i64 %1644, ptr %1637, align 8
  %1645 = load ptr, ptr %165, align 8
  %1646 = getelementptr inbounds i8, ptr %1645, i64 8
  store double 0.000000e+00, ptr %1646, align 8
  br label %2192, !llvm.loop !48

1647:                                             ; preds = %1619, %1618
  %1648 = load i64, ptr %398, align 8
  %1649 = add nsw i64 %1648, 1
  store i64 %1649, ptr %398, align 8
  store double %510, ptr %230, align 8
  store double %511, ptr %416, align 8
  %1650 = load ptr, ptr %77, align 8
  %1651 = getelementptr inbounds i8, ptr %1650, i64 8
  %1652 = load i64, ptr %1651, align 8
  %1653 = load i64, ptr %166, align 8
  %1654 = load ptr, ptr %167, align 8
  %1655 = load ptr, ptr %168, align 8
  %1656 = load ptr, ptr %169, align 8
  %1657 = load ptr, ptr %170, align 8
  br label %1673

1658:                                             ; preds = %1673
  %1659 = icmp sgt i64 %1652, 0
  br i1 %1659, label %1660, label %1733

1660:                                             ; preds = %1658
  %1661 = load double, ptr %9, align 16
  %1662 = load double, ptr %171, align 8
  %1663 = getelementptr double, ptr %1654, i64 %1652
  %1664 = load double, ptr %172, align 16
  %1665 = shl i64 %1652, 4
  %1666 = getelementptr i8, ptr %1654, i64 %1665
  %1667 = load double, ptr %10, align 16
  %1668 = load double, ptr %173, align 8
  %1669 = load double, ptr %174, align 16
  %1670 = getelementptr inbounds double, ptr %1655, i64 %1653
  %1671 = shl nsw i64 %1653, 4
  %1672 = getelementptr inbounds i8, ptr %1655, i64 %1671
  br label %1684

1673:                                             ; preds = %1647, %1673
  %1674 = phi i64 [ 0, %1647 ], [ %1682, %1673 ]
  %1675 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1674
  %1676 = getelementptr inbounds i8, ptr %1675, i64 8
  %1677 = load double, ptr %1676, align 8
  %1678 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1674
  store double %1677, ptr %1678, align 8
  %1679 = getelementptr inbounds i8, ptr %1675, i64 16
  %1680 = load double, ptr %1679, align 8
  %1681 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %1674
  store double %1680, ptr %1681, align 8
  %1682 = add nuw nsw i64 %1674, 1
  %1683 = icmp eq i64 %1682, 3
  br i1 %1683, label %1658, label %1673, !llvm.loop !49

1684:                                             ; preds = %1660, %1721
  %1685 = phi i64 [ 0, %1660 ], [ %1722, %1721 ]
  %1686 = getelementptr inbounds double, ptr %1654, i64 %1685
  %1687 = load double, ptr %1686, align 8
  %1688 = fmul double %1661, %1687
  %1689 = getelementptr double, ptr %1663, i64 %1685
  %1690 = load double, ptr %1689, align 8
  %1691 = fmul double %1662, %1690
  %1692 = fadd double %1688, %1691
  %1693 = getelementptr double, ptr %1666, i64 %1685
  %1694 = load double, ptr %1693, align 8
  %1695 = fmul double %1664, %1694
  %1696 = fadd double %1692, %1695
  %1697 = fmul double %1687, %1667
  %1698 = fmul double %1690, %1668
  %1699 = fadd double %1697, %1698
  %1700 = fmul double %1694, %1669
  %1701 = fadd double %1699, %1700
  %1702 = load ptr, ptr %175, align 8
  %1703 = getelementptr inbounds double, ptr %1702, i64 %1685
  %1704 = load double, ptr %1703, align 8
  %1705 = load ptr, ptr %78, align 8
  %1706 = getelementptr inbounds double, ptr %1705, i64 %1685
  %1707 = load double, ptr %1706, align 8
  %1708 = fsub double %1704, %1707
  %1709 = getelementptr inbounds double, ptr %1655, i64 %1685
  store double %1708, ptr %1709, align 8
  %1710 = fneg double %1696
  %1711 = fsub double %1710, %1701
  %1712 = getelementptr inbounds double, ptr %1670, i64 %1685
  store double %1711, ptr %1712, align 8
  %1713 = fneg double %1701
  %1714 = getelementptr inbounds double, ptr %1672, i64 %1685
  store double %1713, ptr %1714, align 8
  %1715 = load ptr, ptr %78, align 8
  %1716 = getelementptr inbounds double, ptr %1715, i64 %1685
  %1717 = load double, ptr %1716, align 8
  %1718 = getelementptr inbounds double, ptr %1656, i64 %1685
  store double %1717, ptr %1718, align 8
  %1719 = getelementptr double, ptr %1655, i64 %1685
  %1720 = getelementptr double, ptr %1656, i64 %1685
  br label %1724

1721:                                             ; preds = %1724
  %1722 = add nuw nsw i64 %1685, 1
  %1723 = icmp eq i64 %1722, %1652
  br i1 %1723, label %1733, label %1684, !llvm.loop !50

1724:                                             ; preds = %1684, %1724
  %1725 = phi i64 [ 0, %1684 ], [ %1726, %1724 ]
  %1726 = add nuw nsw i64 %1725, 1
  %1727 = mul nuw nsw i64 %1652, %1726
  %1728 = mul nsw i64 %1653, %1725
  %1729 = getelementptr double, ptr %1719, i64 %1728
  %1730 = load double, ptr %1729, align 8
  %1731 = getelementptr double, ptr %1720, i64 %1727
  store double %1730, ptr %1731, align 8
  %1732 = icmp eq i64 %1726, 3
  br i1 %1732, label %1721, label %1724, !llvm.loop !51

1733:                                             ; preds = %1721, %1658
  %1734 = fcmp olt double %1597, 1.000000e-10
  %1735 = select i1 %1734, double 1.000000e-10, double %1597
  %1736 = getelementptr inbounds i8, ptr %1657, i64 8
  store double %511, ptr %1736, align 8
  %1737 = getelementptr inbounds i8, ptr %1657, i64 16
  store double %511, ptr %1737, align 8
  %1738 = getelementptr inbounds i8, ptr %1657, i64 24
  store double %1735, ptr %1738, align 8
  %1739 = load ptr, ptr %79, align 8
  %1740 = getelementptr inbounds i8, ptr %1739, i64 8
  %1741 = load i64, ptr %1740, align 8
  %1742 = and i64 %1741, -2
  %1743 = or disjoint i64 %1742, %1603
  store i64 %1743, ptr %1740, align 8
  %1744 = load ptr, ptr %79, align 8
  %1745 = getelementptr inbounds i8, ptr %1744, i64 16
  %1746 = load i64, ptr %1745, align 8
  %1747 = and i64 %1746, -2
  store i64 %1747, ptr %1745, align 8
  %1748 = load ptr, ptr %79, align 8
  %1749 = getelementptr inbounds i8, ptr %1748, i64 32
  %1750 = load i64, ptr %1749, align 8
  %1751 = and i64 %1750, -2
  store i64 %1751, ptr %1749, align 8
  %1752 = load ptr, ptr %0, align 8
  %1753 = getelementptr inbounds i8, ptr %1752, i64 24
  %1754 = load i64, ptr %1753, align 8
  %1755 = load ptr, ptr %97, align 8
  %1756 = getelementptr inbounds i8, ptr %1755, i64 8
  %1757 = load i64, ptr %1756, align 8
  %1758 = icmp eq i64 %1757, 0
  br i1 %1758, label %1805, label %1759

1759:                                             ; preds = %1733
  %1760 = load i64, ptr %1755, align 8
  %1761 = load ptr, ptr %77, align 8
  %1762 = getelementptr inbounds i8, ptr %1761, i64 8
  %1763 = load i64, ptr %1762, align 8
  %1764 = load ptr, ptr %176, align 8
  %1765 = load i64, ptr %177, align 8
  %1766 = mul nsw i64 %1765, %1760
  %1767 = getelementptr inbounds double, ptr %1764, i64 %1766
  %1768 = getelementptr inbounds double, ptr %1767, i64 %1765
  store double %434, ptr %1767, align 8
  %1769 = getelementptr inbounds i8, ptr %1767, i64 8
  store double %511, ptr %1769, align 8
  store double %510, ptr %1768, align 8
  %1770 = getelementptr inbounds i8, ptr %1768, i64 8
  store double 0.000000e+00, ptr %1770, align 8
  %1771 = icmp sgt i64 %1763, 0
  br i1 %1771, label %1772, label %1775

1772:                                             ; preds = %1759
  %1773 = getelementptr i8, ptr %1767, i64 16
  %1774 = icmp sgt i64 %1754, 0
  br label %1778

1775:                                             ; preds = %1790, %1759
  %1776 = add nsw i64 %1760, 1
  %1777 = load ptr, ptr %97, align 8
  store i64 %1776, ptr %1777, align 8
  br label %1805

1778:                                             ; preds = %1772, %1790
  %1779 = phi i64 [ 0, %1772 ], [ %1791, %1790 ]
  %1780 = load ptr, ptr %78, align 8
  %1781 = getelementptr inbounds double, ptr %1780, i64 %1779
  %1782 = load double, ptr %1781, align 8
  %1783 = add nuw nsw i64 %1779, 2
  %1784 = getelementptr inbounds double, ptr %1767, i64 %1783
  store double %1782, ptr %1784, align 8
  %1785 = load ptr, ptr %178, align 8
  %1786 = getelementptr inbounds double, ptr %1785, i64 %1779
  %1787 = load double, ptr %1786, align 8
  %1788 = getelementptr inbounds double, ptr %1768, i64 %1783
  store double %1787, ptr %1788, align 8
  %1789 = getelementptr double, ptr %1773, i64 %1779
  br i1 %1774, label %1793, label %1790

1790:                                             ; preds = %1793, %1778
  %1791 = add nuw nsw i64 %1779, 1
  %1792 = icmp eq i64 %1791, %1763
  br i1 %1792, label %1775, label %1778, !llvm.loop !52

1793:                                             ; preds = %1778, %1793
  %1794 = phi i64 [ %1801, %1793 ], [ 0, %1778 ]
  %1795 = load ptr, ptr %179, align 8
  %1796 = load i64, ptr %180, align 8
  %1797 = mul nsw i64 %1796, %1794
  %1798 = getelementptr double, ptr %1795, i64 %1797
  %1799 = getelementptr double, ptr %1798, i64 %1779
  %1800 = load double, ptr %1799, align 8
  %1801 = add nuw nsw i64 %1794, 1
  %1802 = mul nuw nsw i64 %1801, %1763
  %1803 = getelementptr double, ptr %1789, i64 %1802
  store double %1800, ptr %1803, align 8
  %1804 = icmp eq i64 %1801, %1754
  br i1 %1804, label %1790, label %1793, !llvm.loop !53

1805:                                             ; preds = %1733, %1775
  br i1 %247, label %1806, label %1914

1806:                                             ; preds = %1805
  %1807 = load ptr, ptr %86, align 8
  %1808 = load ptr, ptr %77, align 8
  %1809 = getelementptr inbounds i8, ptr %1808, i64 8
  %1810 = load i64, ptr %1809, align 8
  %1811 = load ptr, ptr %181, align 8
  %1812 = getelementptr inbounds i8, ptr %1807, i64 32
  %1813 = load i64, ptr %1812, align 8
  %1814 = getelementptr inbounds double, ptr %1811, i64 %1813
  %1815 = load ptr, ptr %182, align 8
  %1816 = getelementptr inbounds i8, ptr %1807, i64 24
  %1817 = load i64, ptr %1816, align 8
  %1818 = icmp eq i64 %1817, 0
  br i1 %1818, label %1911, label %1819

1819:                                             ; preds = %1806
  %1820 = getelementptr inbounds i8, ptr %1807, i64 40
  %1821 = load i64, ptr %1820, align 8
  %1822 = icmp sgt i64 %1821, 0
  br i1 %1822, label %1823, label %1827

1823:                                             ; preds = %1819
  %1824 = getelementptr double, ptr %1815, i64 %1810
  %1825 = shl i64 %1810, 4
  %1826 = getelementptr i8, ptr %1815, i64 %1825
  br label %1881

1827:                                             ; preds = %1881, %1819
  %1828 = load ptr, ptr %184, align 8
  %1829 = load ptr, ptr %86, align 8
  %1830 = getelementptr inbounds i8, ptr %1829, i64 8
  %1831 = load i64, ptr %1830, align 8
  %1832 = load ptr, ptr %185, align 8
  %1833 = load ptr, ptr %181, align 8
  %1834 = getelementptr inbounds i8, ptr %1829, i64 32
  %1835 = load i64, ptr %1834, align 8
  %1836 = getelementptr inbounds i8, ptr %1829, i64 40
  %1837 = load i64, ptr %1836, align 8
  %1838 = getelementptr double, ptr %1833, i64 %1835
  %1839 = getelementptr double, ptr %1838, i64 %1837
  store double %511, ptr %1839, align 8
  %1840 = load ptr, ptr %184, align 8
  store double %434, ptr %1840, align 8
  %1841 = load ptr, ptr %86, align 8
  %1842 = getelementptr inbounds i8, ptr %1841, i64 24
  %1843 = load i64, ptr %1842, align 8
  %1844 = load ptr, ptr %78, align 8
  %1845 = load ptr, ptr %181, align 8
  %1846 = load ptr, ptr %186, align 8
  %1847 = inttoptr i64 %1843 to ptr
  %1848 = load ptr, ptr %1847, align 8
  %1849 = tail call i32 %1848(ptr noundef %1828, ptr noundef %1844, ptr noundef %1845, ptr noundef %1846, ptr noundef %1832) #9
  %1850 = icmp eq i32 %1849, 0
  br i1 %1850, label %1851, label %1911

1851:                                             ; preds = %1827
  %1852 = icmp slt i64 %1831, 1
  br i1 %1852, label %1878, label %1853

1853:                                             ; preds = %1851
  %1854 = load ptr, ptr %187, align 8
  %1855 = getelementptr double, ptr %1832, i64 %1831
  br label %1856

1856:                                             ; preds = %1853, %1874
  %1857 = phi i1 [ %1852, %1853 ], [ %1876, %1874 ]
  %1858 = phi i64 [ 0, %1853 ], [ %1875, %1874 ]
  %1859 = getelementptr inbounds i64, ptr %1854, i64 %1858
  %1860 = load i64, ptr %1859, align 8
  %1861 = and i64 %1860, 2
  %1862 = icmp eq i64 %1861, 0
  br i1 %1862, label %1863, label %1874

1863:                                             ; preds = %1856
  %1864 = getelementptr inbounds double, ptr %1832, i64 %1858
  %1865 = load double, ptr %1864, align 8
  %1866 = load ptr, ptr %188, align 8
  %1867 = getelementptr inbounds i64, ptr %1866, i64 %1858
  %1868 = load i64, ptr %1867, align 8
  %1869 = sitofp i64 %1868 to double
  %1870 = fmul double %1865, %1869
  %1871 = getelementptr double, ptr %1855, i64 %1858
  %1872 = load double, ptr %1871, align 8
  %1873 = fcmp ogt double %1870, %1872
  br i1 %1873, label %1874, label %1878

1874:                                             ; preds = %1863, %1856
  %1875 = add nuw nsw i64 %1858, 1
  %1876 = icmp sge i64 %1875, %1831
  %1877 = icmp eq i64 %1875, %1831
  br i1 %1877, label %1878, label %1856, !llvm.loop !54

1878:                                             ; preds = %1874, %1863, %1851
  %1879 = phi i1 [ %1852, %1851 ], [ %1876, %1874 ], [ %1857, %1863 ]
  %1880 = zext i1 %1879 to i32
  br label %1911

1881:                                             ; preds = %1823, %1881
  %1882 = phi i64 [ 0, %1823 ], [ %1908, %1881 ]
  %1883 = load ptr, ptr %183, align 8
  %1884 = getelementptr inbounds double, ptr %1883, i64 %1882
  %1885 = load double, ptr %1884, align 8
  %1886 = load ptr, ptr %78, align 8
  %1887 = getelementptr inbounds double, ptr %1886, i64 %1882
  %1888 = load double, ptr %1887, align 8
  %1889 = fsub double %1885, %1888
  %1890 = tail call double @llvm.fabs.f64(double %1889)
  %1891 = getelementptr inbounds double, ptr %1815, i64 %1882
  %1892 = load double, ptr %1891, align 8
  %1893 = tail call double @llvm.fabs.f64(double %1892)
  %1894 = getelementptr double, ptr %1824, i64 %1882
  %1895 = load double, ptr %1894, align 8
  %1896 = tail call double @llvm.fabs.f64(double %1895)
  %1897 = fcmp ogt double %1893, %1896
  %1898 = select i1 %1897, double %1893, double %1896
  %1899 = getelementptr double, ptr %1826, i64 %1882
  %1900 = load double, ptr %1899, align 8
  %1901 = tail call double @llvm.fabs.f64(double %1900)
  %1902 = fcmp ogt double %1898, %1901
  %1903 = select i1 %1902, double %1898, double %1901
  %1904 = fcmp ogt double %1903, %1890
  %1905 = select i1 %1904, double %1903, double %1890
  %1906 = fmul double %1905, 8.000000e+00
  %1907 = getelementptr inbounds double, ptr %1814, i64 %1882
  store double %1906, ptr %1907, align 8
  %1908 = add nuw nsw i64 %1882, 1
  %1909 = load i64, ptr %1820, align 8
  %1910 = icmp slt i64 %1908, %1909
  br i1 %1910, label %1881, label %1827, !llvm.loop !55

1911:                                             ; preds = %1878, %1827, %1806
  %1912 = phi i32 [ 0, %1806 ], [ 0, %1827 ], [ %1880, %1878 ]
  %1913 = icmp eq i32 %1912, 0
  br label %1914

1914:                                             ; preds = %1911, %1805
  %1915 = phi i1 [ false, %1805 ], [ %1913, %1911 ]
  br i1 %1915, label %1921, label %1916

1916:                                             ; preds = %1914
  %1917 = load i64, ptr %417, align 8
  %1918 = getelementptr inbounds double, ptr %236, i64 %1917
  %1919 = load double, ptr %1918, align 8
  %1920 = fcmp ugt double %1919, %510
  br i1 %1920, label %2146, label %1921

1921:                                             ; preds = %1916, %1914
  %1922 = load ptr, ptr %81, align 8
  br i1 %1915, label %1923, label %1934

1923:                                             ; preds = %1921
  %1924 = load ptr, ptr %86, align 8
  %1925 = getelementptr inbounds i8, ptr %1924, i64 16
  %1926 = load i64, ptr %1925, align 8
  %1927 = inttoptr i64 %1926 to ptr
  %1928 = tail call i64 %1927(ptr noundef %0, double noundef %434, double noundef %511) #9
  %1929 = icmp eq i64 %1928, -6
  br i1 %1929, label %1930, label %1931

1930:                                             ; preds = %1923
  store double %434, ptr %1922, align 8
  br label %2109

1931:                                             ; preds = %1923
  %1932 = getelementptr inbounds i8, ptr %1922, i64 48
  %1933 = load double, ptr %1932, align 8
  br label %1934

1934:                                             ; preds = %1931, %1921
  %1935 = phi double [ %1933, %1931 ], [ 1.000000e+00, %1921 ]
  %1936 = phi i64 [ %1928, %1931 ], [ 0, %1921 ]
  %1937 = fcmp oeq double %1935, 1.000000e+00
  br i1 %1937, label %1938, label %1940

1938:                                             ; preds = %1934
  %1939 = load double, ptr %1922, align 8
  br label %1943

1940:                                             ; preds = %1934
  %1941 = fmul double %511, %1935
  %1942 = fadd double %434, %1941
  br label %1943

1943:                                             ; preds = %1940, %1938
  %1944 = phi double [ %1939, %1938 ], [ %1942, %1940 ]
  %1945 = icmp eq i64 %1936, -4
  %1946 = select i1 %1945, i64 -4, i64 0
  br i1 %1945, label %2004, label %1947

1947:                                             ; preds = %1943
  %1948 = fcmp olt double %1935, 1.000000e+00
  %1949 = load ptr, ptr %77, align 8
  %1950 = getelementptr inbounds i8, ptr %1949, i64 8
  %1951 = load i64, ptr %1950, align 8
  %1952 = load i64, ptr %84, align 8
  %1953 = load ptr, ptr %83, align 8
  %1954 = load ptr, ptr %82, align 8
  %1955 = getelementptr inbounds i8, ptr %1954, i64 48
  %1956 = load i64, ptr %1955, align 8
  %1957 = icmp slt i64 %1956, %1952
  br i1 %1957, label %1958, label %2000

1958:                                             ; preds = %1947, %1996
  %1959 = phi i64 [ %1997, %1996 ], [ undef, %1947 ]
  %1960 = phi i64 [ %1998, %1996 ], [ %1956, %1947 ]
  %1961 = getelementptr inbounds double, ptr %1953, i64 %1960
  %1962 = load double, ptr %1961, align 8
  %1963 = fcmp olt double %1962, %1944
  %1964 = fcmp oeq double %1962, %1944
  %1965 = and i1 %1948, %1964
  %1966 = or i1 %1963, %1965
  br i1 %1966, label %1967, label %2000

1967:                                             ; preds = %1958
  %1968 = fsub double %1962, %434
  %1969 = fdiv double %1968, %511
  %1970 = mul nsw i64 %1960, %1951
  %1971 = getelementptr inbounds double, ptr %1, i64 %1970
  %1972 = load ptr, ptr %189, align 8
  %1973 = insertelement <8 x double> poison, double %1969, i64 0
  %1974 = shufflevector <8 x double> %1973, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1974, ptr %1972, align 8
  %1975 = load ptr, ptr %78, align 8
  %1976 = load ptr, ptr %168, align 8
  %1977 = load i64, ptr %166, align 8
  %1978 = load ptr, ptr %0, align 8
  %1979 = getelementptr inbounds i8, ptr %1978, i64 24
  %1980 = load i64, ptr %1979, align 8
  %1981 = load ptr, ptr %189, align 8
  %1982 = load ptr, ptr %77, align 8
  %1983 = getelementptr inbounds i8, ptr %1982, i64 16
  %1984 = load i64, ptr %1983, align 8
  tail call fastcc void @nested(ptr noundef %1971, ptr noundef %1975, ptr noundef %1976, i64 noundef %1977, i64 noundef %1980, ptr noundef %1981, i64 noundef %1984) #8
  %1985 = load ptr, ptr %85, align 8
  %1986 = load i64, ptr %1985, align 8
  %1987 = icmp eq i64 %1986, 1
  br i1 %1987, label %1988, label %1996

1988:                                             ; preds = %1967
  %1989 = load double, ptr %1961, align 8
  %1990 = getelementptr inbounds i8, ptr %1985, i64 56
  %1991 = load i64, ptr %1990, align 8
  %1992 = inttoptr i64 %1991 to ptr
  %1993 = tail call i64 %1992(ptr noundef %0, double noundef %1989, ptr noundef %1971, ptr noundef null) #9
  %1994 = icmp eq i64 %1993, 0
  %1995 = select i1 %1994, i64 %1959, i64 %1993
  br i1 %1994, label %1996, label %2004

1996:                                             ; preds = %1988, %1967
  %1997 = phi i64 [ %1995, %1988 ], [ %1959, %1967 ]
  %1998 = add i64 %1960, 1
  %1999 = icmp eq i64 %1998, %1952
  br i1 %1999, label %2000, label %1958, !llvm.loop !56

2000:                                             ; preds = %1996, %1958, %1947
  %2001 = phi i64 [ %1956, %1947 ], [ %1952, %1996 ], [ %1960, %1958 ]
  %2002 = load ptr, ptr %82, align 8
  %2003 = getelementptr inbounds i8, ptr %2002, i64 48
  store i64 %2001, ptr %2003, align 8
  br label %2004

2004:                                             ; preds = %1988, %2000, %1943
  %2005 = phi i64 [ %1946, %1943 ], [ 0, %2000 ], [ %1995, %1988 ]
  %2006 = icmp eq i64 %2005, 0
  %2007 = icmp ne i64 %1936, 0
  %2008 = fcmp olt double %1935, 1.000000e+00
  %2009 = and i1 %2008, %2006
  %2010 = and i1 %2007, %2009
  br i1 %2010, label %2011, label %2048

2011:                                             ; preds = %2004
  %2012 = load ptr, ptr %190, align 8
  %2013 = load ptr, ptr %191, align 8
  %2014 = insertelement <8 x double> poison, double %1935, i64 0
  %2015 = shufflevector <8 x double> %2014, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2015, ptr %2013, align 8
  %2016 = load ptr, ptr %78, align 8
  %2017 = load ptr, ptr %168, align 8
  %2018 = load i64, ptr %166, align 8
  %2019 = load ptr, ptr %0, align 8
  %2020 = getelementptr inbounds i8, ptr %2019, i64 24
  %2021 = load i64, ptr %2020, align 8
  %2022 = load ptr, ptr %191, align 8
  %2023 = load ptr, ptr %77, align 8
  %2024 = getelementptr inbounds i8, ptr %2023, i64 16
  %2025 = load i64, ptr %2024, align 8
  tail call fastcc void @nested(ptr noundef %2012, ptr noundef %2016, ptr noundef %2017, i64 noundef %2018, i64 noundef %2021, ptr noundef %2022, i64 noundef %2025) #8
  %2026 = load i64, ptr %192, align 8
  %2027 = icmp sgt i64 %2026, 0
  br i1 %2027, label %2032, label %2028

2028:                                             ; preds = %2032, %2011
  %2029 = load ptr, ptr %85, align 8
  %2030 = load i64, ptr %2029, align 8
  %2031 = icmp eq i64 %2030, 1
  br i1 %2031, label %2042, label %2048

2032:                                             ; preds = %2011, %2032
  %2033 = phi i64 [ %2039, %2032 ], [ 0, %2011 ]
  %2034 = load ptr, ptr %190, align 8
  %2035 = getelementptr inbounds double, ptr %2034, i64 %2033
  %2036 = load double, ptr %2035, align 8
  %2037 = load ptr, ptr %193, align 8
  %2038 = getelementptr inbounds double, ptr %2037, i64 %2033
  store double %2036, ptr %2038, align 8
  %2039 = add nuw nsw i64 %2033, 1
  %2040 = load i64, ptr %192, align 8
  %2041 = icmp slt i64 %2039, %2040
  br i1 %2041, label %2032, label %2028, !llvm.loop !57

2042:                                             ; preds = %2028
  %2043 = load ptr, ptr %194, align 8
  %2044 = getelementptr inbounds i8, ptr %2029, i64 56
  %2045 = load i64, ptr %2044, align 8
  %2046 = inttoptr i64 %2045 to ptr
  %2047 = tail call i64 %2046(ptr noundef %0, double noundef %1944, ptr noundef %2043, ptr noundef null) #9
  br label %2048

2048:                                             ; preds = %2042, %2028, %2004
  %2049 = phi i64 [ %2047, %2042 ], [ 0, %2028 ], [ %2005, %2004 ]
  %2050 = icmp eq i64 %2049, 0
  br i1 %2050, label %2053, label %2051

2051:                                             ; preds = %2048
  store double %434, ptr %1922, align 8
  %2052 = getelementptr inbounds i8, ptr %1922, i64 8
  store double %511, ptr %2052, align 8
  br label %2109

2053:                                             ; preds = %2048
  br i1 %1937, label %2054, label %2092

2054:                                             ; preds = %2053
  %2055 = load ptr, ptr %195, align 8
  %2056 = load ptr, ptr %77, align 8
  %2057 = getelementptr inbounds i8, ptr %2056, i64 8
  %2058 = load i64, ptr %2057, align 8
  %2059 = load i64, ptr %84, align 8
  %2060 = load ptr, ptr %83, align 8
  %2061 = load ptr, ptr %82, align 8
  %2062 = getelementptr inbounds i8, ptr %2061, i64 48
  %2063 = load i64, ptr %2062, align 8
  %2064 = icmp slt i64 %2063, %2059
  br i1 %2064, label %2065, label %2088

2065:                                             ; preds = %2054
  %2066 = icmp sgt i64 %2058, 0
  br label %2067

2067:                                             ; preds = %2065, %2078
  %2068 = phi i64 [ %2063, %2065 ], [ %2079, %2078 ]
  %2069 = getelementptr inbounds double, ptr %2060, i64 %2068
  %2070 = load double, ptr %2069, align 8
  %2071 = load ptr, ptr %81, align 8
  %2072 = load double, ptr %2071, align 8
  %2073 = fcmp ugt double %2070, %2072
  br i1 %2073, label %2088, label %2074

2074:                                             ; preds = %2067
  br i1 %2066, label %2075, label %2078

2075:                                             ; preds = %2074
  %2076 = mul nsw i64 %2068, %2058
  %2077 = getelementptr double, ptr %1, i64 %2076
  br label %2081

2078:                                             ; preds = %2081, %2074
  %2079 = add i64 %2068, 1
  %2080 = icmp eq i64 %2079, %2059
  br i1 %2080, label %2088, label %2067, !llvm.loop !13

2081:                                             ; preds = %2075, %2081
  %2082 = phi i64 [ 0, %2075 ], [ %2086, %2081 ]
  %2083 = getelementptr inbounds double, ptr %2055, i64 %2082
  %2084 = load double, ptr %2083, align 8
  %2085 = getelementptr double, ptr %2077, i64 %2082
  store double %2084, ptr %2085, align 8
  %2086 = add nuw nsw i64 %2082, 1
  %2087 = icmp eq i64 %2086, %2058
  br i1 %2087, label %2078, label %2081, !llvm.loop !14

2088:                                             ; preds = %2078, %2067, %2054
  %2089 = phi i64 [ %2063, %2054 ], [ %2059, %2078 ], [ %2068, %2067 ]
  %2090 = load ptr, ptr %82, align 8
  %2091 = getelementptr inbounds i8, ptr %2090, i64 48
  store i64 %2089, ptr %2091, align 8
  br label %2092

2092:                                             ; preds = %2088, %2053
  br i1 %2007, label %2093, label %2109

2093:                                             ; preds = %2092
  %2094 = load i64, ptr %196, align 8
  %2095 = icmp sgt i64 %2094, 0
  br i1 %2095, label %2099, label %2096

2096:                                             ; preds = %2099, %2093
  store double %1944, ptr %1922, align 8
  %2097 = getelementptr inbounds i8, ptr %1922, i64 8
  store double 0.000000e+00, ptr %2097, align 8
  %2098 = load ptr, ptr %82, align 8
  store i64 0, ptr %2098, align 8
  br label %2109

2099:                                             ; preds = %2093, %2099
  %2100 = phi i64 [ %2106, %2099 ], [ 0, %2093 ]
  %2101 = load ptr, ptr %197, align 8
  %2102 = getelementptr inbounds double, ptr %2101, i64 %2100
  %2103 = load double, ptr %2102, align 8
  %2104 = load ptr, ptr %78, align 8
  %2105 = getelementptr inbounds double, ptr %2104, i64 %2100
  store double %2103, ptr %2105, align 8
  %2106 = add nuw nsw i64 %2100, 1
  %2107 = load i64, ptr %196, align 8
  %2108 = icmp slt i64 %2106, %2107
  br i1 %2108, label %2099, label %2096, !llvm.loop !58

2109:                                             ; preds = %1930, %2051, %2092, %2096
  %2110 = phi i64 [ -6, %1930 ], [ %2049, %2051 ], [ %1936, %2096 ], [ %1936, %2092 ]
  %2111 = icmp eq i64 %2110, -6
  br i1 %2111, label %2115, label %2112

2112:                                             ; preds = %2109
  %2113 = icmp ne i64 %2110, 6
  %2114 = select i1 %2113, i1 true, i1 %247
  br i1 %2114, label %2140, label %2115

2115:                                             ; preds = %2112, %2109
  %2116 = phi i64 [ %2110, %2112 ], [ 2, %2109 ]
  %2117 = load i64, ptr %398, align 8
  %2118 = add nsw i64 %2117, -1
  store i64 %2118, ptr %398, align 8
  %2119 = load ptr, ptr %97, align 8
  %2120 = load i64, ptr %2119, align 8
  %2121 = add nsw i64 %2120, -1
  store i64 %2121, ptr %2119, align 8
  %2122 = load ptr, ptr %79, align 8
  %2123 = getelementptr inbounds i8, ptr %2122, i64 32
  %2124 = load i64, ptr %2123, align 8
  %2125 = or i64 %2124, 1
  store i64 %2125, ptr %2123, align 8
  %2126 = load ptr, ptr %79, align 8
  %2127 = getelementptr inbounds i8, ptr %2126, i64 8
  %2128 = load i64, ptr %2127, align 8
  %2129 = and i64 %2128, -2
  %2130 = getelementptr inbounds i8, ptr %2126, i64 16
  %2131 = load i64, ptr %2130, align 8
  %2132 = and i64 %2131, 1
  %2133 = or disjoint i64 %2132, %2129
  %2134 = xor i64 %2133, 1
  store i64 %2134, ptr %2127, align 8
  %2135 = load ptr, ptr %170, align 8
  %2136 = getelementptr inbounds i8, ptr %2135, i64 8
  store double 0.000000e+00, ptr %2136, align 8
  %2137 = load i64, ptr %399, align 8
  %2138 = add nsw i64 %2137, 1
  store i64 %2138, ptr %399, align 8
  store i64 %2116, ptr %421, align 8
  %2139 = fmul double %511, 2.500000e-01
  br label %2192, !llvm.loop !48

2140:                                             ; preds = %2112
  %2141 = icmp eq i64 %2110, 0
  br i1 %2141, label %2146, label %2142

2142:                                             ; preds = %2140
  %2143 = load ptr, ptr %97, align 8
  %2144 = load i64, ptr %2143, align 8
  %2145 = add nsw i64 %2144, 1
  store i64 %2145, ptr %2143, align 8
  br label %2192

2146:                                             ; preds = %2140, %1916
  br i1 %418, label %2171, label %2147

2147:                                             ; preds = %2171, %2146
  %2148 = load i64, ptr %99, align 8
  %2149 = icmp sgt i64 %2148, 0
  br i1 %2149, label %2150, label %2152

2150:                                             ; preds = %2147
  %2151 = load ptr, ptr %199, align 8
  store double 0x7FF0000000000000, ptr %2151, align 8
  br label %2152

2152:                                             ; preds = %2147, %2150
  %2153 = load i64, ptr %412, align 8
  %2154 = add nsw i64 %2153, 1
  store i64 %2154, ptr %412, align 8
  %2155 = load ptr, ptr %78, align 8
  %2156 = load ptr, ptr %200, align 8
  %2157 = load ptr, ptr %201, align 8
  store double %510, ptr %2157, align 8
  %2158 = load i64, ptr %202, align 8
  %2159 = icmp sgt i64 %2158, 0
  br i1 %2159, label %2160, label %2161

2160:                                             ; preds = %2152
  tail call fastcc void @sample(ptr noundef nonnull %77) #8
  br label %2161

2161:                                             ; preds = %2152, %2160
  %2162 = load ptr, ptr %77, align 8
  %2163 = load i64, ptr %2162, align 8
  %2164 = load ptr, ptr %201, align 8
  %2165 = load ptr, ptr %203, align 8
  %2166 = load ptr, ptr %204, align 8
  %2167 = inttoptr i64 %2163 to ptr
  %2168 = load ptr, ptr %2167, align 8
  %2169 = tail call i32 %2168(ptr noundef %2164, ptr noundef %2155, ptr noundef %2165, ptr noundef %2166, ptr noundef %2156) #9
  %2170 = icmp eq i32 %2169, 0
  br i1 %2170, label %2183, label %2180

2171:                                             ; preds = %2146, %2171
  %2172 = phi i64 [ %2178, %2171 ], [ 0, %2146 ]
  %2173 = load ptr, ptr %198, align 8
  %2174 = getelementptr inbounds double, ptr %2173, i64 %2172
  %2175 = load double, ptr %2174, align 8
  %2176 = load ptr, ptr %78, align 8
  %2177 = getelementptr inbounds double, ptr %2176, i64 %2172
  store double %2175, ptr %2177, align 8
  %2178 = add nuw nsw i64 %2172, 1
  %2179 = icmp eq i64 %2178, %217
  br i1 %2179, label %2147, label %2171, !llvm.loop !59

2180:                                             ; preds = %2161
  store i64 3, ptr %419, align 8
  store double %511, ptr %249, align 8
  %2181 = icmp slt i32 %2169, 0
  %2182 = select i1 %2181, i64 -4, i64 2
  br label %2192

2183:                                             ; preds = %2161
  %2184 = fcmp oeq double %510, %500
  %2185 = fcmp ogt double %435, %1598
  %2186 = select i1 %2184, i1 %2185, i1 false
  %2187 = select i1 %2186, double %435, double %1598
  %2188 = load i64, ptr %420, align 8
  %2189 = load i64, ptr %84, align 8
  %2190 = icmp eq i64 %2188, %2189
  br i1 %2190, label %2191, label %2192

2191:                                             ; preds = %2183
  store double %2187, ptr %249, align 8
  br label %2192

2192:                                             ; preds = %1588, %1614, %1628, %2115, %2142, %2180, %2183, %2191, %517
  %2193 = phi double [ %441, %517 ], [ %1589, %2191 ], [ %1589, %2183 ], [ %1589, %2180 ], [ %1589, %2142 ], [ %1589, %2115 ], [ %1589, %1628 ], [ %1589, %1614 ], [ %1589, %1588 ]
  %2194 = phi double [ %440, %517 ], [ %1590, %2191 ], [ %1590, %2183 ], [ %1590, %2180 ], [ %1590, %2142 ], [ %1590, %2115 ], [ %1590, %1628 ], [ %1590, %1614 ], [ %1590, %1588 ]
  %2195 = phi double [ %439, %517 ], [ %1591, %2191 ], [ %1591, %2183 ], [ %1591, %2180 ], [ %1591, %2142 ], [ %1591, %2115 ], [ %1591, %1628 ], [ %1591, %1614 ], [ %1591, %1588 ]
  %2196 = phi i64 [ %438, %517 ], [ %1592, %2191 ], [ %1592, %2183 ], [ %1592, %2180 ], [ %1592, %2142 ], [ %1592, %2115 ], [ %1592, %1628 ], [ %1592, %1614 ], [ %1592, %1588 ]
  %2197 = phi i64 [ %437, %517 ], [ %1593, %2191 ], [ %1593, %2183 ], [ %1593, %2180 ], [ %1593, %2142 ], [ %1593, %2115 ], [ %1593, %1628 ], [ %1593, %1614 ], [ %1593, %1588 ]
  %2198 = phi i64 [ %436, %517 ], [ %1594, %2191 ], [ %1594, %2183 ], [ %1594, %2180 ], [ %1594, %2142 ], [ %1594, %2115 ], [ %1594, %1628 ], [ %1594, %1614 ], [ %1594, %1588 ]
  %2199 = phi double [ %435, %517 ], [ %2187, %2191 ], [ %2187, %2183 ], [ %1598, %2180 ], [ %1598, %2142 ], [ %2139, %2115 ], [ %1631, %1628 ], [ %1598, %1614 ], [ %435, %1588 ]
  %2200 = phi double [ %434, %517 ], [ %510, %2191 ], [ %510, %2183 ], [ %510, %2180 ], [ %434, %2142 ], [ %434, %2115 ], [ %434, %1628 ], [ %434, %1614 ], [ %434, %1588 ]
  %2201 = phi i32 [ 1, %517 ], [ 1, %2191 ], [ 0, %2183 ], [ 1, %2180 ], [ 1, %2142 ], [ 3, %2115 ], [ 3, %1628 ], [ 3, %1614 ], [ 1, %1588 ]
  %2202 = phi i64 [ 2, %517 ], [ 0, %2191 ], [ %433, %2183 ], [ %2182, %2180 ], [ %2110, %2142 ], [ %433, %2115 ], [ %433, %1628 ], [ %433, %1614 ], [ -4, %1588 ]
  switch i32 %2201, label %2206 [
    i32 0, label %2203
    i32 3, label %2203
  ]

2203:                                             ; preds = %2192, %2192
  %2204 = load i64, ptr %232, align 8
  %2205 = icmp eq i64 %2204, 0
  br i1 %2205, label %423, label %431, !llvm.loop !48

2206:                                             ; preds = %2192, %228, %303, %362, %423, %454, %462
  %2207 = phi double [ %207, %228 ], [ %424, %423 ], [ %441, %462 ], [ %441, %454 ], [ %207, %362 ], [ %207, %303 ], [ %2193, %2192 ]
  %2208 = phi double [ %208, %228 ], [ %425, %423 ], [ %440, %462 ], [ %440, %454 ], [ %208, %362 ], [ %208, %303 ], [ %2194, %2192 ]
  %2209 = phi double [ %209, %228 ], [ %426, %423 ], [ %439, %462 ], [ %439, %454 ], [ %209, %362 ], [ %209, %303 ], [ %2195, %2192 ]
  %2210 = phi i64 [ %210, %228 ], [ %427, %423 ], [ %438, %462 ], [ %438, %454 ], [ %210, %362 ], [ %210, %303 ], [ %2196, %2192 ]
  %2211 = phi i64 [ %211, %228 ], [ %428, %423 ], [ %437, %462 ], [ %437, %454 ], [ %211, %362 ], [ %211, %303 ], [ %2197, %2192 ]
  %2212 = phi i64 [ %212, %228 ], [ %429, %423 ], [ %436, %462 ], [ %436, %454 ], [ %212, %362 ], [ %212, %303 ], [ %2198, %2192 ]
  %2213 = phi i64 [ -1, %228 ], [ -1, %423 ], [ 1, %462 ], [ -5, %454 ], [ 0, %362 ], [ %306, %303 ], [ %2202, %2192 ]
  %2214 = load ptr, ptr %205, align 8
  %2215 = getelementptr inbounds i8, ptr %2214, i64 48
  %2216 = load i64, ptr %2215, align 8
  %2217 = icmp ne i64 %2213, -2
  %2218 = icmp eq i64 %2216, 0
  %2219 = select i1 %2217, i1 true, i1 %2218
  br i1 %2219, label %2227, label %2220

2220:                                             ; preds = %2206
  %2221 = inttoptr i64 %2216 to ptr
  %2222 = tail call i64 %2221(ptr noundef %0) #9
  %2223 = icmp eq i64 %2222, 8
  %2224 = select i1 %2223, i64 8, i64 %2213
  %2225 = icmp eq i64 %2222, 1
  %2226 = zext i1 %2225 to i32
  br label %2227

2227:                                             ; preds = %2206, %2220
  %2228 = phi i64 [ %2213, %2206 ], [ %2224, %2220 ]
  %2229 = phi i32 [ 0, %2206 ], [ %2226, %2220 ]
  %2230 = icmp eq i32 %2229, 0
  br i1 %2230, label %2231, label %206, !llvm.loop !60

2231:                                             ; preds = %2227
  %2232 = getelementptr inbounds i8, ptr %0, i64 320
  %2233 = load i64, ptr %2232, align 8
  %2234 = icmp sgt i64 %2233, 0
  br i1 %2234, label %2235, label %2238

2235:                                             ; preds = %2231
  %2236 = getelementptr inbounds i8, ptr %0, i64 336
  %2237 = load ptr, ptr %2236, align 8
  store double 0x7FF0000000000000, ptr %2237, align 8
  br label %2238

2238:                                             ; preds = %2231, %2235
  ret i64 %2228
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
