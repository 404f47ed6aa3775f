; sources 5d595339b19d20fe76576b1cf111e0860a366f03e969b35c8485e8eb7265b469
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
  br i1 %15, label %16, label %189

16:                                               ; preds = %3
  %17 = getelementptr inbounds i8, ptr %0, i64 144
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %18, i64 8
  %20 = load i64, ptr %19, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %24

22:                                               ; preds = %16
  %23 = getelementptr inbounds i8, ptr %0, i64 360
  br label %32

24:                                               ; preds = %32, %16
  %25 = getelementptr inbounds i8, ptr %0, i64 144
  %26 = getelementptr inbounds i8, ptr %0, i64 632
  %27 = load i64, ptr %26, align 8
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %29, label %43

29:                                               ; preds = %24
  %30 = getelementptr inbounds i8, ptr %0, i64 624
  %31 = getelementptr inbounds i8, ptr %0, i64 1272
  br label %50

32:                                               ; preds = %22, %32
  %33 = phi i64 [ 0, %22 ], [ %38, %32 ]
  %34 = getelementptr inbounds double, ptr %1, i64 %33
  %35 = load double, ptr %34, align 8
  %36 = load ptr, ptr %23, align 8
  %37 = getelementptr inbounds double, ptr %36, i64 %33
  store double %35, ptr %37, align 8
  %38 = add nuw nsw i64 %33, 1
  %39 = load ptr, ptr %17, align 8
  %40 = getelementptr inbounds i8, ptr %39, i64 8
  %41 = load i64, ptr %40, align 8
  %42 = icmp slt i64 %38, %41
  br i1 %42, label %32, label %24, !llvm.loop !3

43:                                               ; preds = %50, %24
  %44 = getelementptr inbounds i8, ptr %0, i64 648
  %45 = getelementptr inbounds i8, ptr %0, i64 656
  %46 = load i64, ptr %45, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %60

48:                                               ; preds = %43
  %49 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %66

50:                                               ; preds = %29, %50
  %51 = phi i64 [ 0, %29 ], [ %57, %50 ]
  %52 = load ptr, ptr %31, align 8
  %53 = getelementptr inbounds double, ptr %52, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = load ptr, ptr %30, align 8
  %56 = getelementptr inbounds double, ptr %55, i64 %51
  store double %54, ptr %56, align 8
  %57 = add nuw nsw i64 %51, 1
  %58 = load i64, ptr %26, align 8
  %59 = icmp slt i64 %57, %58
  br i1 %59, label %50, label %43, !llvm.loop !6

60:                                               ; preds = %66, %43
  %61 = getelementptr inbounds i8, ptr %0, i64 768
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 8
  %64 = load i64, ptr %63, align 8
  %65 = icmp sgt i64 %64, 0
  br i1 %65, label %76, label %81

66:                                               ; preds = %48, %66
  %67 = phi i64 [ 0, %48 ], [ %73, %66 ]
  %68 = load ptr, ptr %49, align 8
  %69 = getelementptr inbounds i64, ptr %68, i64 %67
  %70 = load i64, ptr %69, align 8
  %71 = load ptr, ptr %44, align 8
  %72 = getelementptr inbounds i64, ptr %71, i64 %67
  store i64 %70, ptr %72, align 8
  %73 = add nuw nsw i64 %67, 1
  %74 = load i64, ptr %45, align 8
  %75 = icmp slt i64 %73, %74
  br i1 %75, label %66, label %60, !llvm.loop !7

76:                                               ; preds = %60
  %77 = getelementptr inbounds i8, ptr %0, i64 984
  %78 = load ptr, ptr %77, align 8
  %79 = mul i64 %64, 88
  %80 = getelementptr inbounds i8, ptr %78, i64 %79
  store double 0x7FF8000000000000, ptr %80, align 8
  br label %81

81:                                               ; preds = %76, %60
  %82 = load ptr, ptr %44, align 8
  %83 = getelementptr inbounds i8, ptr %82, i64 56
  %84 = load i64, ptr %83, align 8
  %85 = icmp sgt i64 %84, 0
  br i1 %85, label %86, label %2884

86:                                               ; preds = %81
  %87 = load ptr, ptr %61, align 8
  %88 = getelementptr inbounds i8, ptr %87, i64 8
  %89 = load i64, ptr %88, align 8
  %90 = icmp eq i64 %89, 0
  br i1 %90, label %189, label %91

91:                                               ; preds = %86
  %92 = getelementptr inbounds i8, ptr %0, i64 248
  %93 = load i64, ptr %92, align 8
  %94 = icmp sgt i64 %93, 0
  br i1 %94, label %2884, label %95

95:                                               ; preds = %91
  %96 = load ptr, ptr %25, align 8
  %97 = getelementptr inbounds i8, ptr %96, i64 40
  %98 = load i64, ptr %97, align 8
  %99 = icmp eq i64 %98, 0
  br i1 %99, label %100, label %2884

100:                                              ; preds = %95
  %101 = getelementptr inbounds i8, ptr %0, i64 624
  %102 = load ptr, ptr %101, align 8
  %103 = load double, ptr %102, align 8
  %104 = getelementptr inbounds i8, ptr %0, i64 168
  %105 = load ptr, ptr %104, align 8
  store double %103, ptr %105, align 8
  %106 = load ptr, ptr %61, align 8
  %107 = load i64, ptr %106, align 8
  %108 = load ptr, ptr %104, align 8
  %109 = getelementptr inbounds i8, ptr %0, i64 360
  %110 = load ptr, ptr %109, align 8
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = load ptr, ptr %111, align 8
  %113 = getelementptr inbounds i8, ptr %0, i64 792
  %114 = load ptr, ptr %113, align 8
  %115 = getelementptr inbounds i8, ptr %0, i64 984
  %116 = load ptr, ptr %115, align 8
  %117 = inttoptr i64 %107 to ptr
  %118 = load ptr, ptr %117, align 8
  %119 = tail call i32 %118(ptr noundef %108, ptr noundef %110, ptr noundef %112, ptr noundef %114, ptr noundef %116) #10
  %120 = load ptr, ptr %61, align 8
  %121 = getelementptr inbounds i8, ptr %120, i64 56
  %122 = load i64, ptr %121, align 8
  %123 = load ptr, ptr %104, align 8
  %124 = load ptr, ptr %109, align 8
  %125 = load ptr, ptr %111, align 8
  %126 = getelementptr inbounds i8, ptr %0, i64 1152
  %127 = load ptr, ptr %126, align 8
  %128 = getelementptr inbounds i8, ptr %0, i64 1200
  %129 = load ptr, ptr %128, align 8
  %130 = inttoptr i64 %122 to ptr
  %131 = load ptr, ptr %130, align 8
  %132 = tail call i32 %131(ptr noundef %123, ptr noundef %124, ptr noundef %125, ptr noundef %127, ptr noundef %129) #10
  %133 = getelementptr inbounds i8, ptr %0, i64 864
  %134 = icmp slt i64 %89, 1
  br i1 %134, label %187, label %135

135:                                              ; preds = %100
  %136 = getelementptr inbounds i8, ptr %0, i64 984
  %137 = getelementptr inbounds i8, ptr %0, i64 1200
  %138 = getelementptr inbounds i8, ptr %0, i64 1200
  %139 = getelementptr inbounds i8, ptr %0, i64 936
  %140 = getelementptr inbounds i8, ptr %0, i64 960
  br label %141

141:                                              ; preds = %135, %172
  %142 = phi i1 [ %134, %135 ], [ %185, %172 ]
  %143 = phi i64 [ 0, %135 ], [ %184, %172 ]
  %144 = load ptr, ptr %136, align 8
  %145 = getelementptr inbounds double, ptr %144, i64 %143
  %146 = load double, ptr %145, align 8
  %147 = fcmp oeq double %146, 0.000000e+00
  br i1 %147, label %148, label %152

148:                                              ; preds = %141
  %149 = load ptr, ptr %137, align 8
  %150 = getelementptr inbounds double, ptr %149, i64 %143
  %151 = load double, ptr %150, align 8
  br label %152

152:                                              ; preds = %148, %141
  %153 = phi double [ %151, %148 ], [ %146, %141 ]
  br i1 %147, label %163, label %154

154:                                              ; preds = %152
  %155 = load ptr, ptr %138, align 8
  %156 = getelementptr double, ptr %155, i64 %89
  %157 = getelementptr double, ptr %156, i64 %143
  %158 = load double, ptr %157, align 8
  %159 = tail call double @llvm.fabs.f64(double %146)
  %160 = fmul double %158, 0x3CE0000000000000
  %161 = fcmp ole double %159, %160
  %162 = zext i1 %161 to i32
  br label %163

163:                                              ; preds = %152, %154
  %164 = phi i32 [ 1, %152 ], [ %162, %154 ]
  %165 = icmp eq i32 %164, 0
  br i1 %165, label %172, label %166

166:                                              ; preds = %163
  %167 = load ptr, ptr %133, align 8
  %168 = getelementptr inbounds i64, ptr %167, i64 %143
  %169 = load i64, ptr %168, align 8
  %170 = and i64 %169, 2
  %171 = icmp eq i64 %170, 0
  br i1 %171, label %187, label %172

172:                                              ; preds = %166, %163
  %173 = tail call double @llvm.fabs.f64(double %153)
  %174 = fcmp ueq double %173, 0x7FF0000000000000
  %175 = fcmp ogt double %153, 0.000000e+00
  %176 = fcmp olt double %153, 0.000000e+00
  %177 = sext i1 %176 to i64
  %178 = select i1 %175, i64 1, i64 %177
  %179 = select i1 %174, i64 0, i64 %178
  %180 = load ptr, ptr %139, align 8
  %181 = getelementptr inbounds i64, ptr %180, i64 %143
  store i64 %179, ptr %181, align 8
  %182 = load ptr, ptr %140, align 8
  %183 = getelementptr inbounds i64, ptr %182, i64 %143
  store i64 0, ptr %183, align 8
  %184 = add nuw nsw i64 %143, 1
  %185 = icmp sge i64 %184, %89
  %186 = icmp eq i64 %184, %89
  br i1 %186, label %187, label %141, !llvm.loop !8

187:                                              ; preds = %166, %172, %100
  %188 = phi i1 [ %134, %100 ], [ %185, %172 ], [ %142, %166 ]
  br i1 %188, label %189, label %2884

189:                                              ; preds = %86, %187, %3
  %190 = getelementptr inbounds i8, ptr %0, i64 144
  %191 = getelementptr inbounds i8, ptr %0, i64 360
  %192 = getelementptr inbounds i8, ptr %0, i64 1368
  %193 = getelementptr inbounds i8, ptr %0, i64 624
  %194 = getelementptr inbounds i8, ptr %0, i64 648
  %195 = getelementptr inbounds i8, ptr %0, i64 672
  %196 = getelementptr inbounds i8, ptr %0, i64 680
  %197 = getelementptr inbounds i8, ptr %0, i64 576
  %198 = getelementptr inbounds i8, ptr %0, i64 696
  %199 = getelementptr inbounds i8, ptr %0, i64 768
  %200 = getelementptr inbounds i8, ptr %0, i64 320
  %201 = getelementptr inbounds i8, ptr %0, i64 312
  %202 = getelementptr inbounds i8, ptr %0, i64 336
  %203 = getelementptr inbounds i8, ptr %0, i64 528
  %204 = getelementptr inbounds i8, ptr %0, i64 168
  %205 = getelementptr inbounds i8, ptr %0, i64 248
  %206 = getelementptr inbounds i8, ptr %0, i64 192
  %207 = getelementptr inbounds i8, ptr %0, i64 216
  %208 = getelementptr inbounds i8, ptr %0, i64 1392
  %209 = getelementptr inbounds i8, ptr %0, i64 528
  %210 = getelementptr inbounds i8, ptr %0, i64 1320
  %211 = getelementptr inbounds i8, ptr %0, i64 320
  %212 = getelementptr inbounds i8, ptr %0, i64 312
  %213 = getelementptr inbounds i8, ptr %0, i64 336
  %214 = getelementptr inbounds i8, ptr %0, i64 1440
  %215 = getelementptr inbounds i8, ptr %0, i64 1464
  %216 = getelementptr inbounds i8, ptr %0, i64 168
  %217 = getelementptr inbounds i8, ptr %0, i64 248
  %218 = getelementptr inbounds i8, ptr %0, i64 192
  %219 = getelementptr inbounds i8, ptr %0, i64 1416
  %220 = getelementptr inbounds i8, ptr %0, i64 408
  %221 = getelementptr inbounds i8, ptr %0, i64 408
  %222 = getelementptr inbounds i8, ptr %0, i64 384
  %223 = getelementptr inbounds i8, ptr %0, i64 168
  %224 = getelementptr inbounds i8, ptr %0, i64 248
  %225 = getelementptr inbounds i8, ptr %0, i64 192
  %226 = getelementptr inbounds i8, ptr %0, i64 216
  %227 = getelementptr inbounds i8, ptr %0, i64 528
  %228 = getelementptr inbounds i8, ptr %0, i64 1448
  %229 = getelementptr inbounds i8, ptr %0, i64 1392
  %230 = getelementptr inbounds i8, ptr %0, i64 1544
  %231 = getelementptr inbounds i8, ptr %0, i64 1488
  %232 = getelementptr inbounds i8, ptr %0, i64 1512
  %233 = getelementptr inbounds i8, ptr %0, i64 1440
  %234 = getelementptr inbounds i8, ptr %0, i64 1536
  %235 = getelementptr inbounds i8, ptr %0, i64 1560
  %236 = getelementptr inbounds i8, ptr %0, i64 1656
  %237 = getelementptr inbounds i8, ptr %0, i64 1584
  %238 = getelementptr inbounds i8, ptr %0, i64 1608
  %239 = getelementptr inbounds i8, ptr %0, i64 408
  %240 = getelementptr inbounds i8, ptr %0, i64 1632
  %241 = getelementptr inbounds i8, ptr %0, i64 408
  %242 = getelementptr inbounds i8, ptr %0, i64 168
  %243 = getelementptr inbounds i8, ptr %0, i64 248
  %244 = getelementptr inbounds i8, ptr %0, i64 192
  %245 = getelementptr inbounds i8, ptr %0, i64 216
  %246 = getelementptr inbounds i8, ptr %0, i64 1632
  %247 = getelementptr inbounds i8, ptr %0, i64 1680
  %248 = getelementptr inbounds i8, ptr %0, i64 1704
  %249 = getelementptr inbounds i8, ptr %0, i64 600
  %250 = getelementptr inbounds i8, ptr %0, i64 1536
  %251 = getelementptr inbounds i8, ptr %0, i64 1544
  %252 = getelementptr inbounds i8, ptr %0, i64 1680
  %253 = getelementptr inbounds i8, ptr %0, i64 1704
  %254 = getelementptr inbounds i8, ptr %0, i64 1488
  %255 = getelementptr inbounds i8, ptr %0, i64 1512
  %256 = getelementptr inbounds i8, ptr %0, i64 1560
  %257 = getelementptr inbounds i8, ptr %0, i64 600
  %258 = getelementptr inbounds i8, ptr %10, i64 8
  %259 = getelementptr inbounds i8, ptr %10, i64 16
  %260 = getelementptr inbounds i8, ptr %0, i64 1448
  %261 = getelementptr inbounds i8, ptr %0, i64 1440
  %262 = getelementptr inbounds i8, ptr %0, i64 384
  %263 = getelementptr inbounds i8, ptr %0, i64 1728
  %264 = getelementptr inbounds i8, ptr %0, i64 1680
  %265 = getelementptr inbounds i8, ptr %0, i64 528
  %266 = getelementptr inbounds i8, ptr %0, i64 1536
  %267 = getelementptr inbounds i8, ptr %0, i64 1544
  %268 = getelementptr inbounds i8, ptr %0, i64 1488
  %269 = getelementptr inbounds i8, ptr %0, i64 384
  %270 = getelementptr inbounds i8, ptr %0, i64 600
  %271 = getelementptr inbounds i8, ptr %0, i64 600
  %272 = getelementptr inbounds i8, ptr %0, i64 408
  %273 = getelementptr inbounds i8, ptr %0, i64 408
  %274 = getelementptr inbounds i8, ptr %0, i64 1632
  %275 = getelementptr inbounds i8, ptr %0, i64 168
  %276 = getelementptr inbounds i8, ptr %0, i64 248
  %277 = getelementptr inbounds i8, ptr %0, i64 192
  %278 = getelementptr inbounds i8, ptr %0, i64 216
  %279 = getelementptr inbounds i8, ptr %0, i64 600
  %280 = getelementptr inbounds i8, ptr %0, i64 600
  %281 = getelementptr inbounds i8, ptr %0, i64 384
  %282 = getelementptr inbounds i8, ptr %0, i64 1392
  %283 = getelementptr inbounds i8, ptr %0, i64 368
  %284 = getelementptr inbounds i8, ptr %0, i64 1584
  %285 = getelementptr inbounds i8, ptr %0, i64 552
  %286 = getelementptr inbounds i8, ptr %0, i64 1656
  %287 = getelementptr inbounds i8, ptr %0, i64 1392
  %288 = getelementptr inbounds i8, ptr %13, i64 8
  %289 = getelementptr inbounds i8, ptr %13, i64 16
  %290 = getelementptr inbounds i8, ptr %14, i64 8
  %291 = getelementptr inbounds i8, ptr %14, i64 16
  %292 = getelementptr inbounds i8, ptr %0, i64 384
  %293 = getelementptr inbounds i8, ptr %0, i64 1344
  %294 = getelementptr inbounds i8, ptr %0, i64 1360
  %295 = getelementptr inbounds i8, ptr %0, i64 384
  %296 = getelementptr inbounds i8, ptr %0, i64 552
  %297 = getelementptr inbounds i8, ptr %0, i64 368
  %298 = getelementptr inbounds i8, ptr %0, i64 888
  %299 = getelementptr inbounds i8, ptr %0, i64 1584
  %300 = getelementptr inbounds i8, ptr %0, i64 384
  %301 = getelementptr inbounds i8, ptr %0, i64 168
  %302 = getelementptr inbounds i8, ptr %0, i64 984
  %303 = getelementptr inbounds i8, ptr %0, i64 912
  %304 = getelementptr inbounds i8, ptr %0, i64 864
  %305 = getelementptr inbounds i8, ptr %0, i64 936
  %306 = getelementptr inbounds i8, ptr %0, i64 456
  %307 = getelementptr inbounds i8, ptr %0, i64 408
  %308 = getelementptr inbounds i8, ptr %0, i64 456
  %309 = getelementptr inbounds i8, ptr %0, i64 368
  %310 = getelementptr inbounds i8, ptr %0, i64 384
  %311 = getelementptr inbounds i8, ptr %0, i64 384
  %312 = getelementptr inbounds i8, ptr %0, i64 384
  %313 = getelementptr inbounds i8, ptr %0, i64 368
  %314 = getelementptr inbounds i8, ptr %0, i64 384
  %315 = getelementptr inbounds i8, ptr %0, i64 248
  %316 = getelementptr inbounds i8, ptr %0, i64 384
  %317 = getelementptr inbounds i8, ptr %0, i64 336
  %318 = getelementptr inbounds i8, ptr %0, i64 528
  %319 = getelementptr inbounds i8, ptr %0, i64 168
  %320 = getelementptr inbounds i8, ptr %0, i64 248
  %321 = getelementptr inbounds i8, ptr %0, i64 192
  %322 = getelementptr inbounds i8, ptr %0, i64 216
  %323 = getelementptr inbounds i8, ptr %0, i64 248
  %324 = getelementptr inbounds i8, ptr %0, i64 768
  br label %325

325:                                              ; preds = %2781, %189
  %326 = phi double [ undef, %189 ], [ %2761, %2781 ]
  %327 = phi double [ undef, %189 ], [ %2762, %2781 ]
  %328 = phi double [ undef, %189 ], [ %2763, %2781 ]
  %329 = phi i64 [ undef, %189 ], [ %2764, %2781 ]
  %330 = phi i64 [ undef, %189 ], [ %2765, %2781 ]
  %331 = phi i64 [ undef, %189 ], [ %2766, %2781 ]
  %332 = load ptr, ptr %193, align 8
  %333 = load ptr, ptr %194, align 8
  %334 = getelementptr inbounds i8, ptr %333, i64 56
  %335 = load i64, ptr %334, align 8
  %336 = icmp eq i64 %335, 0
  br i1 %336, label %2760, label %337

337:                                              ; preds = %325
  %338 = load ptr, ptr %190, align 8
  %339 = getelementptr inbounds i8, ptr %338, i64 8
  %340 = load i64, ptr %339, align 8
  %341 = load ptr, ptr %195, align 8
  %342 = load i64, ptr %196, align 8
  %343 = getelementptr double, ptr %341, i64 %342
  %344 = getelementptr i8, ptr %343, i64 -8
  %345 = load double, ptr %344, align 8
  %346 = load double, ptr %341, align 8
  %347 = fsub double %345, %346
  %348 = fmul double %347, 0x3D70000000000000
  %349 = load ptr, ptr %197, align 8, !noalias !9
  %350 = load double, ptr %349, align 8, !noalias !9
  %351 = icmp sgt i64 %340, 0
  br i1 %351, label %352, label %361

352:                                              ; preds = %337, %352
  %353 = phi i64 [ %359, %352 ], [ 0, %337 ]
  %354 = phi double [ %358, %352 ], [ %350, %337 ]
  %355 = getelementptr inbounds double, ptr %349, i64 %353
  %356 = load double, ptr %355, align 8, !noalias !9
  %357 = fcmp olt double %356, %354
  %358 = select i1 %357, double %356, double %354
  %359 = add nuw nsw i64 %353, 1
  %360 = icmp eq i64 %359, %340
  br i1 %360, label %361, label %352, !llvm.loop !12

361:                                              ; preds = %352, %337
  %362 = phi double [ %350, %337 ], [ %358, %352 ]
  %363 = load ptr, ptr %198, align 8
  %364 = load i64, ptr %363, align 8
  %365 = icmp eq i64 %364, 1
  %366 = load ptr, ptr %199, align 8
  %367 = getelementptr inbounds i8, ptr %366, i64 8
  %368 = load i64, ptr %367, align 8
  %369 = icmp sgt i64 %368, 0
  %370 = load double, ptr %332, align 8
  %371 = getelementptr inbounds i8, ptr %332, i64 8
  %372 = load double, ptr %371, align 8
  %373 = load i64, ptr %333, align 8
  %374 = icmp eq i64 %373, 0
  br i1 %374, label %375, label %526

375:                                              ; preds = %361
  %376 = load i64, ptr %200, align 8
  %377 = icmp eq i64 %376, 0
  br i1 %377, label %407, label %378

378:                                              ; preds = %375
  %379 = icmp sgt i64 %376, 0
  br i1 %379, label %380, label %395

380:                                              ; preds = %378
  %381 = load ptr, ptr %201, align 8
  br label %382

382:                                              ; preds = %380, %382
  %383 = phi i64 [ 0, %380 ], [ %393, %382 ]
  %384 = phi i64 [ %376, %380 ], [ %392, %382 ]
  %385 = add nuw nsw i64 %383, %384
  %386 = lshr i64 %385, 1
  %387 = mul i64 %386, 24
  %388 = getelementptr inbounds i8, ptr %381, i64 %387
  %389 = load double, ptr %388, align 8
  %390 = fcmp ogt double %389, %370
  %391 = add nuw nsw i64 %386, 1
  %392 = select i1 %390, i64 %386, i64 %384
  %393 = select i1 %390, i64 %383, i64 %391
  %394 = icmp slt i64 %393, %392
  br i1 %394, label %382, label %395, !llvm.loop !13

395:                                              ; preds = %382, %378
  %396 = phi i64 [ 0, %378 ], [ %393, %382 ]
  %397 = icmp slt i64 %396, %376
  br i1 %397, label %398, label %404

398:                                              ; preds = %395
  %399 = load ptr, ptr %201, align 8
  %400 = mul i64 %396, 24
  %401 = getelementptr inbounds i8, ptr %399, i64 %400
  %402 = getelementptr inbounds i8, ptr %401, i64 8
  %403 = load double, ptr %402, align 8
  br label %404

404:                                              ; preds = %398, %395
  %405 = phi double [ %403, %398 ], [ 0x7FF0000000000000, %395 ]
  %406 = load ptr, ptr %202, align 8
  store double %405, ptr %406, align 8
  br label %407

407:                                              ; preds = %404, %375
  %408 = getelementptr inbounds i8, ptr %333, i64 24
  %409 = load i64, ptr %408, align 8
  %410 = add nsw i64 %409, 1
  store i64 %410, ptr %408, align 8
  %411 = load ptr, ptr %191, align 8
  %412 = load ptr, ptr %203, align 8
  %413 = load ptr, ptr %204, align 8
  store double %370, ptr %413, align 8
  %414 = load ptr, ptr %190, align 8
  %415 = getelementptr inbounds i8, ptr %414, i64 40
  %416 = load i64, ptr %415, align 8
  %417 = icmp eq i64 %416, 0
  br i1 %417, label %419, label %418

418:                                              ; preds = %407
  tail call fastcc void @settle(ptr noundef nonnull %190) #11
  br label %419

419:                                              ; preds = %418, %407
  %420 = load i64, ptr %205, align 8
  %421 = icmp sgt i64 %420, 0
  br i1 %421, label %422, label %423

422:                                              ; preds = %419
  tail call fastcc void @sample(ptr noundef nonnull %190) #11
  br label %423

423:                                              ; preds = %419, %422
  %424 = load ptr, ptr %190, align 8
  %425 = load i64, ptr %424, align 8
  %426 = load ptr, ptr %204, align 8
  %427 = load ptr, ptr %206, align 8
  %428 = load ptr, ptr %207, align 8
  %429 = inttoptr i64 %425 to ptr
  %430 = load ptr, ptr %429, align 8
  %431 = tail call i32 %430(ptr noundef %426, ptr noundef %411, ptr noundef %427, ptr noundef %428, ptr noundef %412) #10
  %432 = icmp eq i32 %431, 0
  br i1 %432, label %437, label %433

433:                                              ; preds = %423
  %434 = getelementptr inbounds i8, ptr %333, i64 72
  store i64 3, ptr %434, align 8
  %435 = icmp slt i32 %431, 0
  %436 = select i1 %435, i64 -4, i64 2
  br label %2760

437:                                              ; preds = %423
  store i64 1, ptr %333, align 8
  %438 = load ptr, ptr %192, align 8
  %439 = getelementptr inbounds i8, ptr %438, i64 16
  %440 = load i64, ptr %439, align 8
  %441 = and i64 %440, -2
  store i64 %441, ptr %439, align 8
  %442 = load ptr, ptr %192, align 8
  %443 = getelementptr inbounds i8, ptr %442, i64 32
  %444 = load i64, ptr %443, align 8
  %445 = or i64 %444, 1
  store i64 %445, ptr %443, align 8
  %446 = load ptr, ptr %192, align 8
  %447 = getelementptr inbounds i8, ptr %446, i64 8
  %448 = load i64, ptr %447, align 8
  %449 = and i64 %448, -2
  %450 = getelementptr inbounds i8, ptr %446, i64 16
  %451 = load i64, ptr %450, align 8
  %452 = and i64 %451, 1
  %453 = or disjoint i64 %452, %449
  %454 = xor i64 %453, 1
  store i64 %454, ptr %447, align 8
  %455 = load ptr, ptr %208, align 8
  %456 = getelementptr inbounds i8, ptr %455, i64 8
  store double 0.000000e+00, ptr %456, align 8
  %457 = load ptr, ptr %208, align 8
  %458 = getelementptr inbounds i8, ptr %457, i64 24
  store double 0.000000e+00, ptr %458, align 8
  %459 = load ptr, ptr %191, align 8
  %460 = load ptr, ptr %190, align 8
  %461 = getelementptr inbounds i8, ptr %460, i64 8
  %462 = load i64, ptr %461, align 8
  %463 = load i64, ptr %196, align 8
  %464 = load ptr, ptr %195, align 8
  %465 = load ptr, ptr %194, align 8
  %466 = getelementptr inbounds i8, ptr %465, i64 48
  %467 = load i64, ptr %466, align 8
  %468 = icmp slt i64 %467, %463
  br i1 %468, label %469, label %492

469:                                              ; preds = %437
  %470 = icmp sgt i64 %462, 0
  br label %471

471:                                              ; preds = %469, %482
  %472 = phi i64 [ %467, %469 ], [ %483, %482 ]
  %473 = getelementptr inbounds double, ptr %464, i64 %472
  %474 = load double, ptr %473, align 8
  %475 = load ptr, ptr %193, align 8
  %476 = load double, ptr %475, align 8
  %477 = fcmp ugt double %474, %476
  br i1 %477, label %492, label %478

478:                                              ; preds = %471
  br i1 %470, label %479, label %482

479:                                              ; preds = %478
  %480 = mul nsw i64 %472, %462
  %481 = getelementptr double, ptr %1, i64 %480
  br label %485

482:                                              ; preds = %485, %478
  %483 = add i64 %472, 1
  %484 = icmp eq i64 %483, %463
  br i1 %484, label %492, label %471, !llvm.loop !14

485:                                              ; preds = %479, %485
  %486 = phi i64 [ 0, %479 ], [ %490, %485 ]
  %487 = getelementptr inbounds double, ptr %459, i64 %486
  %488 = load double, ptr %487, align 8
  %489 = getelementptr double, ptr %481, i64 %486
  store double %488, ptr %489, align 8
  %490 = add nuw nsw i64 %486, 1
  %491 = icmp eq i64 %490, %462
  br i1 %491, label %482, label %485, !llvm.loop !15

492:                                              ; preds = %471, %482, %437
  %493 = phi i64 [ %467, %437 ], [ %472, %471 ], [ %463, %482 ]
  %494 = load ptr, ptr %194, align 8
  %495 = getelementptr inbounds i8, ptr %494, i64 48
  store i64 %493, ptr %495, align 8
  %496 = icmp eq i64 %493, %463
  br i1 %496, label %2760, label %497

497:                                              ; preds = %492
  %498 = fcmp oeq double %372, 0.000000e+00
  br i1 %498, label %499, label %526

499:                                              ; preds = %497
  %500 = load ptr, ptr %190, align 8
  %501 = getelementptr inbounds i8, ptr %500, i64 24
  %502 = load i64, ptr %501, align 8
  %503 = getelementptr inbounds i8, ptr %332, i64 16
  %504 = load double, ptr %503, align 8
  %505 = load ptr, ptr %191, align 8
  call fastcc void @norm_to(ptr noundef nonnull %11, ptr noundef %505, ptr noundef %505, ptr noundef nonnull %191, i64 noundef %502) #11
  %506 = load double, ptr %11, align 8
  %507 = load ptr, ptr %209, align 8
  call fastcc void @norm_to(ptr noundef nonnull %12, ptr noundef %507, ptr noundef %505, ptr noundef nonnull %191, i64 noundef %502) #11
  %508 = load double, ptr %12, align 8
  %509 = fcmp uge double %506, 1.000000e-05
  %510 = fcmp uge double %508, 1.000000e-05
  %511 = and i1 %509, %510
  %512 = fmul double %506, 1.000000e-02
  %513 = fdiv double %512, %508
  %514 = select i1 %511, double %513, double 0x3EB0C6F7A0B5ED8D
  %515 = fcmp olt double %504, %514
  %516 = select i1 %515, double %504, double %514
  %517 = tail call double @llvm.fabs.f64(double %370)
  %518 = fmul double %517, 0x3D30000000000000
  %519 = fcmp ogt double %518, %516
  %520 = select i1 %519, double %518, double %516
  %521 = fcmp olt double %504, %520
  %522 = select i1 %521, double %504, double %520
  %523 = tail call i1 @llvm.is.fpclass.f64(double %522, i32 639)
  br i1 %523, label %524, label %526

524:                                              ; preds = %499
  %525 = getelementptr inbounds i8, ptr %333, i64 72
  store i64 4, ptr %525, align 8
  br label %526

526:                                              ; preds = %499, %524, %497, %361
  %527 = phi double [ %372, %497 ], [ %372, %361 ], [ %522, %524 ], [ %522, %499 ]
  %528 = load i64, ptr %334, align 8
  %529 = icmp eq i64 %528, 0
  br i1 %529, label %556, label %530

530:                                              ; preds = %526
  %531 = getelementptr inbounds i8, ptr %333, i64 8
  %532 = getelementptr inbounds i8, ptr %333, i64 16
  %533 = getelementptr inbounds i8, ptr %333, i64 64
  %534 = getelementptr inbounds i8, ptr %332, i64 16
  %535 = fcmp ogt double %362, 0x3CB0000000000000
  %536 = select i1 %535, double %362, double 0x3CB0000000000000
  %537 = fdiv double 0x3CE4000000000000, %536
  %538 = tail call double @llvm.sqrt.f64(double %362)
  %539 = fcmp olt double %538, 3.000000e-02
  %540 = select i1 %539, double %538, double 3.000000e-02
  %541 = fcmp ogt double %540, %537
  %542 = select i1 %541, double %540, double %537
  %543 = fmul double %362, %542
  %544 = fmul double %543, %543
  %545 = getelementptr inbounds i8, ptr %333, i64 24
  %546 = getelementptr inbounds i8, ptr %333, i64 32
  %547 = getelementptr inbounds i8, ptr %333, i64 40
  %548 = getelementptr inbounds i8, ptr %333, i64 72
  %549 = getelementptr inbounds i8, ptr %332, i64 32
  %550 = getelementptr inbounds i8, ptr %333, i64 48
  %551 = icmp sgt i64 %340, 0
  %552 = getelementptr inbounds i8, ptr %333, i64 72
  %553 = getelementptr inbounds i8, ptr %333, i64 48
  %554 = getelementptr inbounds i8, ptr %333, i64 72
  %555 = getelementptr inbounds i8, ptr %333, i64 72
  br label %564

556:                                              ; preds = %2757, %526
  %557 = phi double [ %326, %526 ], [ %2747, %2757 ]
  %558 = phi double [ %327, %526 ], [ %2748, %2757 ]
  %559 = phi double [ %328, %526 ], [ %2749, %2757 ]
  %560 = phi i64 [ %329, %526 ], [ %2750, %2757 ]
  %561 = phi i64 [ %330, %526 ], [ %2751, %2757 ]
  %562 = phi i64 [ %331, %526 ], [ %2752, %2757 ]
  %563 = phi double [ %527, %526 ], [ %2753, %2757 ]
  store double %563, ptr %371, align 8
  br label %2760

564:                                              ; preds = %530, %2757
  %565 = phi i64 [ %528, %530 ], [ %2758, %2757 ]
  %566 = phi i64 [ undef, %530 ], [ %2756, %2757 ]
  %567 = phi double [ %370, %530 ], [ %2754, %2757 ]
  %568 = phi double [ %527, %530 ], [ %2753, %2757 ]
  %569 = phi i64 [ %331, %530 ], [ %2752, %2757 ]
  %570 = phi i64 [ %330, %530 ], [ %2751, %2757 ]
  %571 = phi i64 [ %329, %530 ], [ %2750, %2757 ]
  %572 = phi double [ %328, %530 ], [ %2749, %2757 ]
  %573 = phi double [ %327, %530 ], [ %2748, %2757 ]
  %574 = phi double [ %326, %530 ], [ %2747, %2757 ]
  %575 = load ptr, ptr %210, align 8
  %576 = getelementptr inbounds i8, ptr %575, i64 8
  %577 = load i64, ptr %576, align 8
  %578 = icmp sgt i64 %577, 0
  br i1 %578, label %579, label %584

579:                                              ; preds = %564
  %580 = load i64, ptr %575, align 8
  %581 = add nsw i64 %580, 3
  %582 = icmp slt i64 %577, %581
  %583 = zext i1 %582 to i32
  br label %584

584:                                              ; preds = %564, %579
  %585 = phi i32 [ 0, %564 ], [ %583, %579 ]
  %586 = icmp eq i32 %585, 0
  br i1 %586, label %588, label %587

587:                                              ; preds = %584
  store double %568, ptr %371, align 8
  br label %2760

588:                                              ; preds = %584
  %589 = add nsw i64 %565, -1
  store i64 %589, ptr %334, align 8
  %590 = load i64, ptr %531, align 8
  %591 = load i64, ptr %532, align 8
  %592 = add nsw i64 %591, %590
  %593 = load i64, ptr %533, align 8
  %594 = icmp slt i64 %592, %593
  br i1 %594, label %596, label %595

595:                                              ; preds = %588
  store double %568, ptr %371, align 8
  br label %2760

596:                                              ; preds = %588
  %597 = load i64, ptr %211, align 8
  %598 = icmp eq i64 %597, 0
  br i1 %598, label %632, label %599

599:                                              ; preds = %596
  %600 = icmp sgt i64 %597, 0
  br i1 %600, label %601, label %616

601:                                              ; preds = %599
  %602 = load ptr, ptr %212, align 8
  br label %603

603:                                              ; preds = %601, %603
  %604 = phi i64 [ 0, %601 ], [ %614, %603 ]
  %605 = phi i64 [ %597, %601 ], [ %613, %603 ]
  %606 = add nuw nsw i64 %604, %605
  %607 = lshr i64 %606, 1
  %608 = mul i64 %607, 24
  %609 = getelementptr inbounds i8, ptr %602, i64 %608
  %610 = load double, ptr %609, align 8
  %611 = fcmp ogt double %610, %567
  %612 = add nuw nsw i64 %607, 1
  %613 = select i1 %611, i64 %607, i64 %605
  %614 = select i1 %611, i64 %604, i64 %612
  %615 = icmp slt i64 %614, %613
  br i1 %615, label %603, label %616, !llvm.loop !13

616:                                              ; preds = %603, %599
  %617 = phi i64 [ 0, %599 ], [ %614, %603 ]
  %618 = load ptr, ptr %212, align 8
  %619 = mul i64 %617, 24
  %620 = getelementptr inbounds i8, ptr %618, i64 %619
  %621 = icmp slt i64 %617, %597
  br i1 %621, label %622, label %625

622:                                              ; preds = %616
  %623 = getelementptr inbounds i8, ptr %620, i64 8
  %624 = load double, ptr %623, align 8
  br label %625

625:                                              ; preds = %622, %616
  %626 = phi double [ %624, %622 ], [ 0x7FF0000000000000, %616 ]
  %627 = load ptr, ptr %213, align 8
  store double %626, ptr %627, align 8
  %628 = load i64, ptr %211, align 8
  %629 = icmp slt i64 %617, %628
  br i1 %629, label %630, label %632

630:                                              ; preds = %625
  %631 = load double, ptr %620, align 8
  br label %632

632:                                              ; preds = %596, %625, %630
  %633 = phi double [ 0x7FF0000000000000, %596 ], [ %631, %630 ], [ 0x7FF0000000000000, %625 ]
  %634 = fcmp olt double %345, %633
  %635 = select i1 %634, double %345, double %633
  %636 = load double, ptr %534, align 8
  %637 = fcmp olt double %568, %636
  %638 = select i1 %637, double %568, double %636
  %639 = fadd double %567, %638
  %640 = fmul double %638, 1.000000e-03
  %641 = fsub double %635, %640
  %642 = fcmp ule double %639, %641
  %643 = select i1 %642, double %639, double %635
  %644 = fsub double %643, %567
  %645 = fmul double %644, 6.250000e-02
  %646 = fadd double %567, %645
  %647 = fcmp ule double %646, %567
  %648 = fcmp une double %643, %635
  %649 = and i1 %648, %647
  br i1 %649, label %650, label %651

650:                                              ; preds = %632
  store double %644, ptr %371, align 8
  br label %2746

651:                                              ; preds = %632
  %652 = load ptr, ptr %190, align 8, !noalias !16
  %653 = getelementptr inbounds i8, ptr %652, i64 8
  %654 = load i64, ptr %653, align 8, !noalias !16
  %655 = load ptr, ptr %192, align 8, !noalias !16
  %656 = getelementptr inbounds i8, ptr %655, i64 8
  %657 = load i64, ptr %656, align 8, !noalias !16
  %658 = and i64 %657, 1
  %659 = getelementptr inbounds i8, ptr %655, i64 32
  %660 = load i64, ptr %659, align 8, !noalias !16
  %661 = and i64 %660, 1
  %662 = icmp eq i64 %658, 0
  br i1 %662, label %794, label %663

663:                                              ; preds = %651
  %664 = load ptr, ptr %215, align 8, !noalias !16
  %665 = load i64, ptr %655, align 8, !noalias !16
  %666 = icmp eq i64 %665, 0
  br i1 %666, label %667, label %669

667:                                              ; preds = %663
  %668 = icmp sgt i64 %654, 0
  br i1 %668, label %693, label %691

669:                                              ; preds = %663
  %670 = load ptr, ptr %216, align 8, !noalias !16
  store double %567, ptr %670, align 8, !noalias !16
  %671 = load ptr, ptr %190, align 8, !noalias !16
  %672 = getelementptr inbounds i8, ptr %671, i64 40
  %673 = load i64, ptr %672, align 8, !noalias !16
  %674 = icmp eq i64 %673, 0
  br i1 %674, label %676, label %675

675:                                              ; preds = %669
  tail call fastcc void @settle(ptr noundef nonnull %190) #11, !noalias !16
  br label %676

676:                                              ; preds = %675, %669
  %677 = load i64, ptr %217, align 8, !noalias !16
  %678 = icmp sgt i64 %677, 0
  br i1 %678, label %679, label %680

679:                                              ; preds = %676
  tail call fastcc void @sample(ptr noundef nonnull %190) #11, !noalias !16
  br label %680

680:                                              ; preds = %679, %676
  %681 = load ptr, ptr %192, align 8, !noalias !16
  %682 = load i64, ptr %681, align 8, !noalias !16
  %683 = load ptr, ptr %216, align 8, !noalias !16
  %684 = load ptr, ptr %191, align 8, !noalias !16
  %685 = load ptr, ptr %218, align 8, !noalias !16
  %686 = load ptr, ptr %219, align 8, !noalias !16
  %687 = inttoptr i64 %682 to ptr
  %688 = load ptr, ptr %687, align 8, !noalias !16
  %689 = tail call i32 %688(ptr noundef %683, ptr noundef %684, ptr noundef %685, ptr noundef %686, ptr noundef %664) #10, !noalias !16
  %690 = sext i32 %689 to i64
  br label %765

691:                                              ; preds = %693, %667
  %692 = icmp sgt i64 %654, 0
  br i1 %692, label %705, label %765

693:                                              ; preds = %667, %693
  %694 = phi i64 [ %700, %693 ], [ 0, %667 ]
  %695 = load ptr, ptr %191, align 8, !noalias !16
  %696 = getelementptr inbounds double, ptr %695, i64 %694
  %697 = load double, ptr %696, align 8, !noalias !16
  %698 = load ptr, ptr %220, align 8, !noalias !16
  %699 = getelementptr inbounds double, ptr %698, i64 %694
  store double %697, ptr %699, align 8, !noalias !16
  %700 = add nuw nsw i64 %694, 1
  %701 = icmp eq i64 %700, %654
  br i1 %701, label %691, label %693, !llvm.loop !19

702:                                              ; preds = %763
  %703 = add nuw nsw i64 %707, 1
  %704 = icmp eq i64 %703, %654
  br i1 %704, label %765, label %705, !llvm.loop !20

705:                                              ; preds = %691, %702
  %706 = phi i64 [ %764, %702 ], [ undef, %691 ]
  %707 = phi i64 [ %703, %702 ], [ 0, %691 ]
  %708 = phi double [ %719, %702 ], [ 0.000000e+00, %691 ]
  %709 = load ptr, ptr %191, align 8, !noalias !16
  %710 = getelementptr inbounds double, ptr %709, i64 %707
  %711 = load double, ptr %710, align 8, !noalias !16
  %712 = tail call double @llvm.fabs.f64(double %711)
  %713 = fcmp olt double %712, 1.000000e-05
  %714 = select i1 %713, double 1.000000e-05, double %712
  %715 = fmul double %714, 1.500000e-08
  %716 = fadd double %711, %715
  %717 = load ptr, ptr %221, align 8, !noalias !16
  %718 = getelementptr inbounds double, ptr %717, i64 %707
  store double %716, ptr %718, align 8, !noalias !16
  %719 = fadd double %708, 1.000000e+00
  %720 = load ptr, ptr %221, align 8, !noalias !16
  %721 = load ptr, ptr %222, align 8, !noalias !16
  %722 = load ptr, ptr %223, align 8, !noalias !16
  store double %567, ptr %722, align 8, !noalias !16
  %723 = load ptr, ptr %190, align 8, !noalias !16
  %724 = getelementptr inbounds i8, ptr %723, i64 40
  %725 = load i64, ptr %724, align 8, !noalias !16
  %726 = icmp eq i64 %725, 0
  br i1 %726, label %728, label %727

727:                                              ; preds = %705
  tail call fastcc void @settle(ptr noundef nonnull %190) #11, !noalias !16
  br label %728

728:                                              ; preds = %727, %705
  %729 = load i64, ptr %224, align 8, !noalias !16
  %730 = icmp sgt i64 %729, 0
  br i1 %730, label %731, label %732

731:                                              ; preds = %728
  tail call fastcc void @sample(ptr noundef nonnull %190) #11, !noalias !16
  br label %732

732:                                              ; preds = %731, %728
  %733 = load ptr, ptr %190, align 8, !noalias !16
  %734 = load i64, ptr %733, align 8, !noalias !16
  %735 = load ptr, ptr %223, align 8, !noalias !16
  %736 = load ptr, ptr %225, align 8, !noalias !16
  %737 = load ptr, ptr %226, align 8, !noalias !16
  %738 = inttoptr i64 %734 to ptr
  %739 = load ptr, ptr %738, align 8, !noalias !16
  %740 = tail call i32 %739(ptr noundef %735, ptr noundef %720, ptr noundef %736, ptr noundef %737, ptr noundef %721) #10, !noalias !16
  %741 = sext i32 %740 to i64
  %742 = icmp eq i32 %740, 0
  br i1 %742, label %743, label %763

743:                                              ; preds = %732
  %744 = getelementptr double, ptr %664, i64 %707
  %745 = fsub double %716, %711
  br label %749

746:                                              ; preds = %749
  %747 = load ptr, ptr %221, align 8, !noalias !16
  %748 = getelementptr inbounds double, ptr %747, i64 %707
  store double %711, ptr %748, align 8, !noalias !16
  br label %763

749:                                              ; preds = %743, %749
  %750 = phi i64 [ 0, %743 ], [ %761, %749 ]
  %751 = load ptr, ptr %222, align 8, !noalias !16
  %752 = getelementptr inbounds double, ptr %751, i64 %750
  %753 = load double, ptr %752, align 8, !noalias !16
  %754 = load ptr, ptr %227, align 8, !noalias !16
  %755 = getelementptr inbounds double, ptr %754, i64 %750
  %756 = load double, ptr %755, align 8, !noalias !16
  %757 = fsub double %753, %756
  %758 = fdiv double %757, %745
  %759 = mul nuw nsw i64 %750, %654
  %760 = getelementptr double, ptr %744, i64 %759
  store double %758, ptr %760, align 8, !noalias !16
  %761 = add nuw nsw i64 %750, 1
  %762 = icmp eq i64 %761, %654
  br i1 %762, label %746, label %749, !llvm.loop !21

763:                                              ; preds = %746, %732
  %764 = phi i64 [ %706, %746 ], [ %741, %732 ]
  br i1 %742, label %702, label %765

765:                                              ; preds = %763, %702, %691, %680
  %766 = phi double [ 0.000000e+00, %680 ], [ 0.000000e+00, %691 ], [ %719, %702 ], [ %719, %763 ]
  %767 = phi i64 [ %690, %680 ], [ 0, %691 ], [ %764, %763 ], [ 0, %702 ]
  %768 = load i64, ptr %228, align 8, !noalias !16
  %769 = icmp sgt i64 %768, 0
  br i1 %769, label %770, label %783

770:                                              ; preds = %765, %770
  %771 = phi i64 [ %780, %770 ], [ 0, %765 ]
  %772 = load ptr, ptr %215, align 8, !noalias !16
  %773 = getelementptr inbounds double, ptr %772, i64 %771
  %774 = load double, ptr %773, align 8, !noalias !16
  %775 = tail call double @llvm.fabs.f64(double %774)
  %776 = fcmp ueq double %775, 0x7FF0000000000000
  %777 = select i1 %776, double 0.000000e+00, double %774
  %778 = load ptr, ptr %214, align 8, !noalias !16
  %779 = getelementptr inbounds double, ptr %778, i64 %771
  store double %777, ptr %779, align 8, !noalias !16
  %780 = add nuw nsw i64 %771, 1
  %781 = load i64, ptr %228, align 8, !noalias !16
  %782 = icmp slt i64 %780, %781
  br i1 %782, label %770, label %783, !llvm.loop !22

783:                                              ; preds = %770, %765
  %784 = icmp slt i64 %767, 0
  br i1 %784, label %2094, label %785

785:                                              ; preds = %783
  %786 = load i64, ptr %656, align 8, !noalias !16
  %787 = and i64 %786, -2
  store i64 %787, ptr %656, align 8, !noalias !16
  %788 = getelementptr inbounds i8, ptr %655, i64 16
  %789 = load i64, ptr %788, align 8, !noalias !16
  %790 = or i64 %789, 1
  store i64 %790, ptr %788, align 8, !noalias !16
  %791 = getelementptr inbounds i8, ptr %655, i64 24
  %792 = load i64, ptr %791, align 8, !noalias !16
  %793 = and i64 %792, -2
  store i64 %793, ptr %791, align 8, !noalias !16
  br label %794

794:                                              ; preds = %785, %651
  %795 = phi double [ 0.000000e+00, %651 ], [ %766, %785 ]
  %796 = load ptr, ptr %192, align 8, !noalias !16
  %797 = load ptr, ptr %229, align 8, !noalias !16
  %798 = load double, ptr %797, align 8, !noalias !16
  %799 = fsub double %644, %798
  %800 = tail call double @llvm.fabs.f64(double %799)
  %801 = tail call double @llvm.fabs.f64(double %643)
  %802 = fmul double %801, 0x3CB0000000000000
  %803 = fcmp ogt double %800, %802
  %804 = getelementptr inbounds i8, ptr %796, i64 24
  %805 = load i64, ptr %804, align 8, !noalias !16
  %806 = trunc i64 %805 to i1
  %807 = xor i1 %806, true
  %808 = or i1 %803, %807
  %809 = zext i1 %808 to i64
  br i1 %808, label %810, label %870

810:                                              ; preds = %794
  store double %644, ptr %797, align 8, !noalias !16
  %811 = load i64, ptr %230, align 8, !noalias !16
  %812 = load ptr, ptr %231, align 8, !noalias !16
  %813 = load ptr, ptr %232, align 8, !noalias !16
  %814 = icmp sgt i64 %811, 0
  br i1 %814, label %815, label %845

815:                                              ; preds = %810
  %816 = fdiv double 0x400D1A48D83E731D, %644
  %817 = fdiv double 0x400572DB93E0C672, %644
  %818 = fdiv double 0xC0086747F2C3FCB6, %644
  br label %819

819:                                              ; preds = %815, %822
  %820 = phi i64 [ 0, %815 ], [ %823, %822 ]
  %821 = mul nuw nsw i64 %820, %811
  br label %825

822:                                              ; preds = %825
  %823 = add nuw nsw i64 %820, 1
  %824 = icmp eq i64 %823, %811
  br i1 %824, label %845, label %819, !llvm.loop !23

825:                                              ; preds = %819, %825
  %826 = phi i64 [ 0, %819 ], [ %843, %825 ]
  %827 = load ptr, ptr %233, align 8, !noalias !16
  %828 = add nuw nsw i64 %826, %821
  %829 = getelementptr inbounds double, ptr %827, i64 %828
  %830 = load double, ptr %829, align 8, !noalias !16
  %831 = fneg double %830
  %832 = icmp eq i64 %820, %826
  %833 = fsub double %816, %830
  %834 = select i1 %832, double %833, double %831
  %835 = fsub double %817, %830
  %836 = select i1 %832, double %835, double %831
  %837 = getelementptr inbounds double, ptr %812, i64 %828
  store double %834, ptr %837, align 8, !noalias !16
  %838 = select i1 %832, double %818, double 0.000000e+00
  %839 = shl nuw nsw i64 %828, 1
  %840 = getelementptr inbounds double, ptr %813, i64 %839
  store double %836, ptr %840, align 8, !noalias !16
  %841 = or disjoint i64 %839, 1
  %842 = getelementptr inbounds double, ptr %813, i64 %841
  store double %838, ptr %842, align 8, !noalias !16
  %843 = add nuw nsw i64 %826, 1
  %844 = icmp eq i64 %843, %811
  br i1 %844, label %822, label %825, !llvm.loop !24

845:                                              ; preds = %822, %810
  %846 = load ptr, ptr %234, align 8, !noalias !16
  %847 = tail call fastcc i64 @real_factorise(ptr noundef %812, i64 noundef %811, ptr noundef %846) #11, !noalias !16
  %848 = load ptr, ptr %235, align 8, !noalias !16
  %849 = tail call fastcc i64 @pair_factorise(ptr noundef %813, i64 noundef %811, ptr noundef %848) #11, !noalias !16
  %850 = or i64 %849, %847
  %851 = and i64 %850, %809
  %852 = load i64, ptr %804, align 8, !noalias !16
  %853 = or i64 %852, %809
  %854 = xor i64 %851, -1
  %855 = xor i64 %851, %853
  store i64 %855, ptr %804, align 8, !noalias !16
  %856 = icmp eq i64 %851, 0
  %857 = select i1 %856, double 2.000000e+00, double 4.000000e+00
  %858 = fmul double %644, 5.000000e-01
  %859 = select i1 %856, double %568, double %858
  %860 = load ptr, ptr %192, align 8, !noalias !16
  %861 = getelementptr inbounds i8, ptr %860, i64 8
  %862 = load i64, ptr %861, align 8, !noalias !16
  %863 = and i64 %862, %854
  %864 = getelementptr inbounds i8, ptr %860, i64 16
  %865 = load i64, ptr %864, align 8, !noalias !16
  %866 = xor i64 %865, -1
  %867 = and i64 %851, %866
  %868 = or disjoint i64 %867, %863
  store i64 %868, ptr %861, align 8, !noalias !16
  %869 = and i64 %854, 1
  br label %870

870:                                              ; preds = %794, %845
  %871 = phi double [ %568, %794 ], [ %859, %845 ]
  %872 = phi double [ 2.000000e+00, %794 ], [ %857, %845 ]
  %873 = phi i64 [ 1, %794 ], [ %869, %845 ]
  %874 = icmp eq i64 %873, 0
  br i1 %874, label %2094, label %875

875:                                              ; preds = %870
  %876 = load ptr, ptr %229, align 8, !noalias !16
  %877 = getelementptr inbounds i8, ptr %876, i64 8
  %878 = load double, ptr %877, align 8, !noalias !16
  %879 = load ptr, ptr %190, align 8, !noalias !16
  %880 = getelementptr inbounds i8, ptr %879, i64 8
  %881 = load i64, ptr %880, align 8, !noalias !16
  %882 = load ptr, ptr %236, align 8, !noalias !16
  %883 = load ptr, ptr %191, align 8, !noalias !16
  %884 = load ptr, ptr %237, align 8, !noalias !16
  %885 = load ptr, ptr %238, align 8, !noalias !16
  %886 = fcmp ule double %878, 0.000000e+00
  %887 = icmp sgt i64 %881, 0
  %888 = shl i64 %881, 4
  %889 = getelementptr i8, ptr %882, i64 %888
  %890 = mul i64 %881, 24
  %891 = getelementptr i8, ptr %882, i64 %890
  %892 = getelementptr double, ptr %882, i64 %881
  br label %898

893:                                              ; preds = %909
  %894 = icmp sgt i64 %881, 0
  %895 = getelementptr double, ptr %884, i64 %881
  %896 = shl i64 %881, 4
  %897 = getelementptr i8, ptr %884, i64 %896
  br label %935

898:                                              ; preds = %875, %909
  %899 = phi i64 [ 0, %875 ], [ %910, %909 ]
  %900 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %899
  %901 = load double, ptr %900, align 8, !noalias !16
  %902 = fmul double %644, %901
  %903 = fdiv double %902, %878
  %904 = fadd double %903, 1.000000e+00
  br i1 %887, label %905, label %909

905:                                              ; preds = %898
  %906 = fsub double 1.000000e+00, %904
  %907 = mul nuw nsw i64 %881, %899
  %908 = getelementptr double, ptr %884, i64 %907
  br label %912

909:                                              ; preds = %912, %898
  %910 = add nuw nsw i64 %899, 1
  %911 = icmp eq i64 %910, 3
  br i1 %911, label %893, label %898, !llvm.loop !25

912:                                              ; preds = %905, %912
  %913 = phi i64 [ 0, %905 ], [ %933, %912 ]
  %914 = getelementptr double, ptr %889, i64 %913
  %915 = load double, ptr %914, align 8, !noalias !16
  %916 = getelementptr double, ptr %891, i64 %913
  %917 = load double, ptr %916, align 8, !noalias !16
  %918 = fmul double %904, %917
  %919 = fadd double %915, %918
  %920 = fmul double %906, %919
  %921 = getelementptr inbounds double, ptr %882, i64 %913
  %922 = load double, ptr %921, align 8, !noalias !16
  %923 = getelementptr double, ptr %892, i64 %913
  %924 = load double, ptr %923, align 8, !noalias !16
  %925 = fadd double %924, %920
  %926 = fmul double %904, %925
  %927 = fadd double %922, %926
  %928 = getelementptr inbounds double, ptr %883, i64 %913
  %929 = load double, ptr %928, align 8, !noalias !16
  %930 = fsub double %927, %929
  %931 = select i1 %886, double 0.000000e+00, double %930
  %932 = getelementptr double, ptr %908, i64 %913
  store double %931, ptr %932, align 8, !noalias !16
  %933 = add nuw nsw i64 %913, 1
  %934 = icmp eq i64 %933, %881
  br i1 %934, label %909, label %912, !llvm.loop !26

935:                                              ; preds = %893, %946
  %936 = phi i64 [ 0, %893 ], [ %947, %946 ]
  br i1 %894, label %937, label %946

937:                                              ; preds = %935
  %938 = mul nuw nsw i64 %881, %936
  %939 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %936
  %940 = load double, ptr %939, align 8, !noalias !16
  %941 = getelementptr inbounds i8, ptr %939, i64 8
  %942 = load double, ptr %941, align 8, !noalias !16
  %943 = getelementptr inbounds i8, ptr %939, i64 16
  %944 = load double, ptr %943, align 8, !noalias !16
  %945 = getelementptr double, ptr %885, i64 %938
  br label %949

946:                                              ; preds = %949, %935
  %947 = add nuw nsw i64 %936, 1
  %948 = icmp eq i64 %947, 3
  br i1 %948, label %965, label %935, !llvm.loop !27

949:                                              ; preds = %937, %949
  %950 = phi i64 [ 0, %937 ], [ %963, %949 ]
  %951 = getelementptr inbounds double, ptr %884, i64 %950
  %952 = load double, ptr %951, align 8, !noalias !16
  %953 = fmul double %940, %952
  %954 = getelementptr double, ptr %895, i64 %950
  %955 = load double, ptr %954, align 8, !noalias !16
  %956 = fmul double %942, %955
  %957 = fadd double %953, %956
  %958 = getelementptr double, ptr %897, i64 %950
  %959 = load double, ptr %958, align 8, !noalias !16
  %960 = fmul double %944, %959
  %961 = fadd double %957, %960
  %962 = getelementptr double, ptr %945, i64 %950
  store double %961, ptr %962, align 8, !noalias !16
  %963 = add nuw nsw i64 %950, 1
  %964 = icmp eq i64 %963, %881
  br i1 %964, label %946, label %949, !llvm.loop !28

965:                                              ; preds = %946
  %966 = load ptr, ptr %192, align 8, !noalias !29
  %967 = getelementptr inbounds i8, ptr %966, i64 40
  %968 = load i64, ptr %967, align 8, !noalias !29
  %969 = icmp sgt i64 %968, 0
  %970 = select i1 %969, i64 10, i64 6
  %971 = fdiv double 0x400572DB93E0C672, %644
  %972 = fdiv double 0xC0086747F2C3FCB6, %644
  %973 = fdiv double 0x400D1A48D83E731D, %644
  %974 = fneg double %972
  br label %978

975:                                              ; preds = %1441
  %976 = add nuw nsw i64 %982, 1
  %977 = icmp eq i64 %976, %970
  br i1 %977, label %1456, label %978, !llvm.loop !32

978:                                              ; preds = %965, %975
  %979 = phi double [ -1.000000e+00, %965 ], [ %1454, %975 ]
  %980 = phi i64 [ %873, %965 ], [ %1453, %975 ]
  %981 = phi i64 [ 0, %965 ], [ %1452, %975 ]
  %982 = phi i64 [ 0, %965 ], [ %976, %975 ]
  %983 = phi i64 [ 0, %965 ], [ %1450, %975 ]
  %984 = phi i64 [ 0, %965 ], [ %1072, %975 ]
  %985 = phi i64 [ 0, %965 ], [ %1071, %975 ]
  %986 = phi double [ 0.000000e+00, %965 ], [ %1449, %975 ]
  %987 = phi double [ 0.000000e+00, %965 ], [ %1448, %975 ]
  %988 = phi double [ 0.000000e+00, %965 ], [ %1070, %975 ]
  %989 = phi i64 [ %569, %965 ], [ %1447, %975 ]
  %990 = phi i64 [ %570, %965 ], [ %1446, %975 ]
  %991 = phi i64 [ %571, %965 ], [ %1445, %975 ]
  %992 = phi double [ %572, %965 ], [ %1444, %975 ]
  %993 = phi double [ %573, %965 ], [ %1443, %975 ]
  %994 = phi double [ %574, %965 ], [ %1442, %975 ]
  %995 = icmp ugt i64 %982, 5
  %996 = select i1 %995, i64 %983, i64 -1
  %997 = and i64 %980, %996
  %998 = load ptr, ptr %190, align 8, !noalias !29
  %999 = getelementptr inbounds i8, ptr %998, i64 8
  %1000 = load i64, ptr %999, align 8, !noalias !29
  %1001 = load ptr, ptr %237, align 8, !noalias !29
  %1002 = icmp eq i64 %997, 0
  br i1 %1002, label %1069, label %1003

1003:                                             ; preds = %978
  %1004 = icmp sgt i64 %1000, 0
  br label %1005

1005:                                             ; preds = %1003, %1037
  %1006 = phi i64 [ %997, %1003 ], [ %1052, %1037 ]
  %1007 = phi i64 [ 0, %1003 ], [ %1053, %1037 ]
  %1008 = phi i64 [ %984, %1003 ], [ %1050, %1037 ]
  %1009 = phi i64 [ %985, %1003 ], [ %1048, %1037 ]
  %1010 = phi double [ %988, %1003 ], [ %1018, %1037 ]
  br i1 %1004, label %1011, label %1014

1011:                                             ; preds = %1005
  %1012 = mul nuw nsw i64 %1007, %1000
  %1013 = getelementptr double, ptr %1001, i64 %1012
  br label %1057

1014:                                             ; preds = %1057, %1005
  %1015 = and i64 %1006, 4294967295
  %1016 = icmp eq i64 %1015, 0
  %1017 = select i1 %1016, double 0.000000e+00, double 1.000000e+00
  %1018 = fadd double %1010, %1017
  %1019 = load ptr, ptr %240, align 8, !noalias !29
  %1020 = mul nsw i64 %1007, %1000
  %1021 = getelementptr inbounds double, ptr %1019, i64 %1020
  %1022 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %1007
  %1023 = load double, ptr %1022, align 8, !noalias !29
  %1024 = fmul double %644, %1023
  %1025 = fadd double %567, %1024
  %1026 = load ptr, ptr %241, align 8, !noalias !29
  %1027 = load ptr, ptr %242, align 8, !noalias !29
  store double %1025, ptr %1027, align 8, !noalias !29
  %1028 = load ptr, ptr %190, align 8, !noalias !29
  %1029 = getelementptr inbounds i8, ptr %1028, i64 40
  %1030 = load i64, ptr %1029, align 8, !noalias !29
  %1031 = icmp eq i64 %1030, 0
  br i1 %1031, label %1033, label %1032

1032:                                             ; preds = %1014
  tail call fastcc void @settle(ptr noundef nonnull %190) #11, !noalias !29
  br label %1033

1033:                                             ; preds = %1032, %1014
  %1034 = load i64, ptr %243, align 8, !noalias !29
  %1035 = icmp sgt i64 %1034, 0
  br i1 %1035, label %1036, label %1037

1036:                                             ; preds = %1033
  tail call fastcc void @sample(ptr noundef nonnull %190) #11, !noalias !29
  br label %1037

1037:                                             ; preds = %1036, %1033
  %1038 = load ptr, ptr %190, align 8, !noalias !29
  %1039 = load i64, ptr %1038, align 8, !noalias !29
  %1040 = load ptr, ptr %242, align 8, !noalias !29
  %1041 = load ptr, ptr %244, align 8, !noalias !29
  %1042 = load ptr, ptr %245, align 8, !noalias !29
  %1043 = inttoptr i64 %1039 to ptr
  %1044 = load ptr, ptr %1043, align 8, !noalias !29
  %1045 = tail call i32 %1044(ptr noundef %1040, ptr noundef %1026, ptr noundef %1041, ptr noundef %1042, ptr noundef %1021) #10, !noalias !29
  %1046 = sext i32 %1045 to i64
  %1047 = icmp slt i32 %1045, 0
  %1048 = select i1 %1047, i64 %1046, i64 %1009
  %1049 = and i64 %1006, %1046
  %1050 = or i64 %1049, %1008
  %1051 = xor i64 %1046, -1
  %1052 = and i64 %1006, %1051
  %1053 = add nuw nsw i64 %1007, 1
  %1054 = icmp ult i64 %1007, 2
  %1055 = icmp ne i64 %1052, 0
  %1056 = select i1 %1054, i1 %1055, i1 false
  br i1 %1056, label %1005, label %1069, !llvm.loop !33

1057:                                             ; preds = %1011, %1057
  %1058 = phi i64 [ 0, %1011 ], [ %1067, %1057 ]
  %1059 = load ptr, ptr %239, align 8, !noalias !29
  %1060 = load ptr, ptr %191, align 8, !noalias !29
  %1061 = getelementptr inbounds double, ptr %1060, i64 %1058
  %1062 = load double, ptr %1061, align 8, !noalias !29
  %1063 = getelementptr double, ptr %1013, i64 %1058
  %1064 = load double, ptr %1063, align 8, !noalias !29
  %1065 = fadd double %1062, %1064
  %1066 = getelementptr inbounds double, ptr %1059, i64 %1058
  store double %1065, ptr %1066, align 8, !noalias !29
  %1067 = add nuw nsw i64 %1058, 1
  %1068 = icmp eq i64 %1067, %1000
  br i1 %1068, label %1014, label %1057, !llvm.loop !34

1069:                                             ; preds = %1037, %978
  %1070 = phi double [ %988, %978 ], [ %1018, %1037 ]
  %1071 = phi i64 [ %985, %978 ], [ %1048, %1037 ]
  %1072 = phi i64 [ %984, %978 ], [ %1050, %1037 ]
  %1073 = phi i64 [ %997, %978 ], [ %1052, %1037 ]
  %1074 = icmp eq i64 %1073, 0
  br i1 %1074, label %1075, label %1079

1075:                                             ; preds = %1069
  %1076 = or i64 %997, %981
  %1077 = xor i64 %1076, -1
  %1078 = and i64 %983, %1077
  br label %1441

1079:                                             ; preds = %1069
  %1080 = load ptr, ptr %190, align 8, !noalias !29
  %1081 = getelementptr inbounds i8, ptr %1080, i64 8
  %1082 = load i64, ptr %1081, align 8, !noalias !29
  %1083 = getelementptr inbounds i8, ptr %1080, i64 24
  %1084 = load i64, ptr %1083, align 8, !noalias !29
  %1085 = load ptr, ptr %246, align 8, !noalias !29
  %1086 = load ptr, ptr %238, align 8, !noalias !29
  %1087 = icmp sgt i64 %1082, 0
  br i1 %1087, label %1088, label %1170

1088:                                             ; preds = %1079
  %1089 = shl nuw nsw i64 %1082, 1
  br label %1090

1090:                                             ; preds = %1088, %1166
  %1091 = phi i32 [ 1, %1088 ], [ %1106, %1166 ]
  %1092 = phi i64 [ 0, %1088 ], [ %1168, %1166 ]
  %1093 = phi double [ 0.000000e+00, %1088 ], [ %1167, %1166 ]
  %1094 = getelementptr inbounds double, ptr %1085, i64 %1092
  %1095 = load double, ptr %1094, align 8, !noalias !29
  %1096 = add nuw nsw i64 %1092, %1082
  %1097 = getelementptr inbounds double, ptr %1085, i64 %1096
  %1098 = load double, ptr %1097, align 8, !noalias !29
  %1099 = fadd double %1095, %1098
  %1100 = add nuw nsw i64 %1092, %1089
  %1101 = getelementptr inbounds double, ptr %1085, i64 %1100
  %1102 = load double, ptr %1101, align 8, !noalias !29
  %1103 = fadd double %1099, %1102
  %1104 = tail call double @llvm.fabs.f64(double %1103)
  %1105 = fcmp one double %1104, 0x7FF0000000000000
  %1106 = select i1 %1105, i32 %1091, i32 0
  %1107 = getelementptr inbounds double, ptr %1086, i64 %1096
  %1108 = load double, ptr %1107, align 8, !noalias !29
  %1109 = getelementptr inbounds double, ptr %1086, i64 %1100
  %1110 = load double, ptr %1109, align 8, !noalias !29
  %1111 = fmul double %1095, 0xC010B70201A79C46
  %1112 = fmul double %1098, 0x3FD4F8C15DA84E86
  %1113 = fsub double %1111, %1112
  %1114 = fmul double %1102, 0x3FDE810014C55221
  %1115 = fadd double %1113, %1114
  %1116 = fmul double %1095, 0x3FE017885A24A7F2
  %1117 = fmul double %1098, 0x4004934E6FCAA598
  %1118 = fsub double %1116, %1117
  %1119 = fmul double %1102, 0x3FE312C0CF7BDFD1
  %1120 = fadd double %1118, %1119
  %1121 = fmul double %1095, 0x4010B70201A79C46
  %1122 = fmul double %1098, 0x3FD4F8C15DA84E86
  %1123 = fadd double %1121, %1122
  %1124 = fmul double %1102, 0x3FE0BF7FF59D56EF
  %1125 = fadd double %1123, %1124
  %1126 = getelementptr inbounds double, ptr %1086, i64 %1092
  %1127 = load double, ptr %1126, align 8, !noalias !29
  %1128 = fmul double %973, %1127
  %1129 = fsub double %1125, %1128
  %1130 = fmul double %1110, %974
  %1131 = tail call double @llvm.fma.f64(double %971, double %1108, double %1130)
  %1132 = fmul double %972, %1108
  %1133 = tail call double @llvm.fma.f64(double %971, double %1110, double %1132)
  %1134 = fsub double %1115, %1131
  %1135 = fsub double %1120, %1133
  %1136 = load ptr, ptr %247, align 8, !noalias !29
  %1137 = getelementptr inbounds double, ptr %1136, i64 %1092
  store double %1129, ptr %1137, align 8, !noalias !29
  %1138 = load ptr, ptr %248, align 8, !noalias !29
  %1139 = shl nuw nsw i64 %1092, 1
  %1140 = getelementptr inbounds double, ptr %1138, i64 %1139
  store double %1134, ptr %1140, align 8, !noalias !29
  %1141 = or disjoint i64 %1139, 1
  %1142 = getelementptr inbounds double, ptr %1138, i64 %1141
  store double %1135, ptr %1142, align 8, !noalias !29
  %1143 = icmp slt i64 %1092, %1084
  br i1 %1143, label %1144, label %1166

1144:                                             ; preds = %1090
  %1145 = load ptr, ptr %191, align 8, !noalias !29
  %1146 = getelementptr inbounds double, ptr %1145, i64 %1092
  %1147 = load double, ptr %1146, align 8, !noalias !29
  %1148 = tail call double @llvm.fabs.f64(double %1129)
  %1149 = tail call double @llvm.fabs.f64(double %1134)
  %1150 = tail call double @llvm.fabs.f64(double %1135)
  %1151 = fadd double %1150, %1149
  %1152 = fadd double %1148, %1151
  %1153 = fmul double %644, %1152
  %1154 = load ptr, ptr %249, align 8, !noalias !29
  %1155 = getelementptr inbounds double, ptr %1154, i64 %1092
  %1156 = load double, ptr %1155, align 8, !noalias !29
  %1157 = load ptr, ptr %197, align 8, !noalias !29
  %1158 = getelementptr inbounds double, ptr %1157, i64 %1092
  %1159 = load double, ptr %1158, align 8, !noalias !29
  %1160 = tail call double @llvm.fabs.f64(double %1147)
  %1161 = fmul double %1160, %1159
  %1162 = fadd double %1156, %1161
  %1163 = fdiv double %1153, %1162
  %1164 = fmul double %1163, %1163
  %1165 = fadd double %1093, %1164
  br label %1166

1166:                                             ; preds = %1144, %1090
  %1167 = phi double [ %1165, %1144 ], [ %1093, %1090 ]
  %1168 = add nuw nsw i64 %1092, 1
  %1169 = icmp eq i64 %1168, %1082
  br i1 %1169, label %1170, label %1090, !llvm.loop !35

1170:                                             ; preds = %1166, %1079
  %1171 = phi double [ 0.000000e+00, %1079 ], [ %1167, %1166 ]
  %1172 = phi i32 [ 1, %1079 ], [ %1106, %1166 ]
  %1173 = zext nneg i32 %1172 to i64
  %1174 = xor i64 %1173, 4294967295
  %1175 = and i64 %1073, %1174
  %1176 = icmp eq i64 %1175, 0
  %1177 = select i1 %1176, double %987, double 0x7FF0000000000000
  %1178 = load ptr, ptr %190, align 8, !noalias !29
  %1179 = getelementptr inbounds i8, ptr %1178, i64 24
  %1180 = load i64, ptr %1179, align 8, !noalias !29
  %1181 = load i64, ptr %251, align 8, !noalias !29
  %1182 = load ptr, ptr %192, align 8, !noalias !29
  %1183 = getelementptr inbounds i8, ptr %1182, i64 40
  %1184 = load i64, ptr %1183, align 8, !noalias !29
  %1185 = load ptr, ptr %252, align 8, !noalias !29
  %1186 = load ptr, ptr %253, align 8, !noalias !29
  %1187 = load ptr, ptr %254, align 8, !noalias !29
  %1188 = load ptr, ptr %250, align 8, !noalias !29
  tail call fastcc void @real_solve(ptr noundef %1187, i64 noundef %1181, ptr noundef %1188, ptr noundef %1185) #11, !noalias !29
  %1189 = load ptr, ptr %255, align 8, !noalias !29
  %1190 = load ptr, ptr %256, align 8, !noalias !29
  tail call fastcc void @pair_solve(ptr noundef %1189, i64 noundef %1181, ptr noundef %1190, ptr noundef %1186) #11, !noalias !29
  %1191 = icmp sgt i64 %1184, 0
  br i1 %1191, label %1192, label %1200

1192:                                             ; preds = %1170
  %1193 = load ptr, ptr %254, align 8, !noalias !29
  %1194 = load ptr, ptr %250, align 8, !noalias !29
  %1195 = getelementptr inbounds double, ptr %1185, i64 %1181
  tail call fastcc void @real_solve_columns(ptr noundef %1193, i64 noundef %1181, ptr noundef %1194, ptr noundef %1195, i64 noundef %1184) #11, !noalias !29
  %1196 = load ptr, ptr %255, align 8, !noalias !29
  %1197 = load ptr, ptr %256, align 8, !noalias !29
  %1198 = shl nsw i64 %1181, 4
  %1199 = getelementptr inbounds i8, ptr %1186, i64 %1198
  tail call fastcc void @pair_solve_columns(ptr noundef %1196, i64 noundef %1181, ptr noundef %1197, ptr noundef %1199, i64 noundef %1184) #11, !noalias !29
  br label %1200

1200:                                             ; preds = %1192, %1170
  %1201 = icmp sgt i64 %1180, 0
  br i1 %1201, label %1202, label %1237

1202:                                             ; preds = %1200
  %1203 = load ptr, ptr %191, align 8, !noalias !29
  %1204 = load ptr, ptr %257, align 8, !noalias !29
  %1205 = load ptr, ptr %197, align 8, !noalias !29
  br label %1206

1206:                                             ; preds = %1202, %1206
  %1207 = phi double [ 0.000000e+00, %1202 ], [ %1234, %1206 ]
  %1208 = phi i64 [ 0, %1202 ], [ %1235, %1206 ]
  %1209 = getelementptr inbounds double, ptr %1203, i64 %1208
  %1210 = load double, ptr %1209, align 8, !noalias !29
  %1211 = getelementptr inbounds double, ptr %1204, i64 %1208
  %1212 = load double, ptr %1211, align 8, !noalias !29
  %1213 = getelementptr inbounds double, ptr %1205, i64 %1208
  %1214 = load double, ptr %1213, align 8, !noalias !29
  %1215 = tail call double @llvm.fabs.f64(double %1210)
  %1216 = fmul double %1215, %1214
  %1217 = fadd double %1212, %1216
  %1218 = getelementptr inbounds double, ptr %1185, i64 %1208
  %1219 = load double, ptr %1218, align 8, !noalias !29
  %1220 = fdiv double %1219, %1217
  %1221 = shl nuw nsw i64 %1208, 1
  %1222 = getelementptr inbounds double, ptr %1186, i64 %1221
  %1223 = load double, ptr %1222, align 8, !noalias !29
  %1224 = or disjoint i64 %1221, 1
  %1225 = getelementptr inbounds double, ptr %1186, i64 %1224
  %1226 = load double, ptr %1225, align 8, !noalias !29
  %1227 = fdiv double %1223, %1217
  %1228 = fdiv double %1226, %1217
  %1229 = fmul double %1220, %1220
  %1230 = fmul double %1227, %1227
  %1231 = fadd double %1229, %1230
  %1232 = fmul double %1228, %1228
  %1233 = fadd double %1231, %1232
  %1234 = fadd double %1207, %1233
  %1235 = add nuw nsw i64 %1208, 1
  %1236 = icmp eq i64 %1235, %1180
  br i1 %1236, label %1237, label %1206, !llvm.loop !36

1237:                                             ; preds = %1206, %1200
  %1238 = phi double [ 0.000000e+00, %1200 ], [ %1234, %1206 ]
  %1239 = mul nsw i64 %1180, 3
  %1240 = sitofp i64 %1239 to double
  %1241 = fdiv double %1238, %1240
  %1242 = tail call double @llvm.sqrt.f64(double %1241)
  %1243 = fcmp oeq double %1242, 0.000000e+00
  %1244 = fcmp ogt double %1171, 0.000000e+00
  %1245 = and i1 %1244, %1243
  %1246 = zext i1 %1245 to i64
  %1247 = xor i64 %1246, -1
  %1248 = and i64 %1173, %1247
  %1249 = and i64 %1248, %1073
  %1250 = xor i64 %983, -1
  %1251 = and i64 %1249, %1250
  %1252 = trunc nuw nsw i64 %1251 to i32
  %1253 = fcmp ogt double %979, 0.000000e+00
  %1254 = and i32 %1252, 1
  %1255 = select i1 %1253, i32 %1254, i32 0
  %1256 = fdiv double %1242, %979
  %1257 = icmp eq i32 %1255, 0
  %1258 = select i1 %1257, double %1177, double %1256
  %1259 = fsub double 1.000000e+00, %1258
  %1260 = fdiv double %1242, %1259
  %1261 = icmp ult i64 %982, 5
  br i1 %1261, label %1354, label %1262

1262:                                             ; preds = %1354, %1237
  %1263 = phi double [ %1260, %1237 ], [ %1357, %1354 ]
  %1264 = fcmp oge double %1258, 1.000000e+00
  %1265 = fcmp ogt double %1263, %542
  %1266 = or i1 %1264, %1265
  %1267 = xor i32 %1255, -1
  %1268 = zext i32 %1267 to i64
  %1269 = select i1 %1266, i64 %1268, i64 2147483647
  %1270 = and i64 %1269, %1249
  %1271 = xor i64 %1270, -1
  %1272 = and i64 %997, %1271
  %1273 = or i64 %1272, %981
  %1274 = load ptr, ptr %190, align 8, !noalias !29
  %1275 = getelementptr inbounds i8, ptr %1274, i64 8
  %1276 = load i64, ptr %1275, align 8, !noalias !29
  %1277 = load ptr, ptr %237, align 8, !noalias !29
  %1278 = load ptr, ptr %238, align 8, !noalias !29
  %1279 = icmp sgt i64 %1276, 0
  br i1 %1279, label %1280, label %1340

1280:                                             ; preds = %1262
  %1281 = icmp eq i64 %1270, 0
  %1282 = getelementptr double, ptr %1278, i64 %1276
  %1283 = shl i64 %1276, 4
  %1284 = getelementptr i8, ptr %1278, i64 %1283
  %1285 = icmp eq i64 %1270, 0
  br label %1286

1286:                                             ; preds = %1280, %1315
  %1287 = phi i64 [ 0, %1280 ], [ %1316, %1315 ]
  %1288 = load ptr, ptr %253, align 8, !noalias !29
  %1289 = shl nuw nsw i64 %1287, 1
  %1290 = getelementptr inbounds double, ptr %1288, i64 %1289
  %1291 = load double, ptr %1290, align 8, !noalias !29
  %1292 = or disjoint i64 %1289, 1
  %1293 = getelementptr inbounds double, ptr %1288, i64 %1292
  %1294 = load double, ptr %1293, align 8, !noalias !29
  %1295 = load ptr, ptr %252, align 8, !noalias !29
  %1296 = getelementptr inbounds double, ptr %1295, i64 %1287
  %1297 = load double, ptr %1296, align 8, !noalias !29
  store double %1297, ptr %10, align 16, !noalias !29
  store double %1291, ptr %258, align 8, !noalias !29
  store double %1294, ptr %259, align 16, !noalias !29
  %1298 = getelementptr double, ptr %1278, i64 %1287
  br label %1304

1299:                                             ; preds = %1304
  %1300 = getelementptr inbounds double, ptr %1278, i64 %1287
  %1301 = getelementptr double, ptr %1282, i64 %1287
  %1302 = getelementptr double, ptr %1284, i64 %1287
  %1303 = getelementptr double, ptr %1277, i64 %1287
  br label %1318

1304:                                             ; preds = %1286, %1304
  %1305 = phi i64 [ 0, %1286 ], [ %1313, %1304 ]
  %1306 = mul nuw nsw i64 %1276, %1305
  %1307 = getelementptr double, ptr %1298, i64 %1306
  %1308 = load double, ptr %1307, align 8, !noalias !29
  %1309 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %1305
  %1310 = load double, ptr %1309, align 8, !noalias !29
  %1311 = fadd double %1308, %1310
  %1312 = select i1 %1281, double %1308, double %1311
  store double %1312, ptr %1307, align 8, !noalias !29
  %1313 = add nuw nsw i64 %1305, 1
  %1314 = icmp eq i64 %1313, 3
  br i1 %1314, label %1299, label %1304, !llvm.loop !37

1315:                                             ; preds = %1318
  %1316 = add nuw nsw i64 %1287, 1
  %1317 = icmp eq i64 %1316, %1276
  br i1 %1317, label %1340, label %1286, !llvm.loop !38

1318:                                             ; preds = %1299, %1318
  %1319 = phi i64 [ 0, %1299 ], [ %1338, %1318 ]
  %1320 = mul nuw nsw i64 %1276, %1319
  %1321 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1319
  %1322 = load double, ptr %1321, align 8, !noalias !29
  %1323 = load double, ptr %1300, align 8, !noalias !29
  %1324 = fmul double %1322, %1323
  %1325 = getelementptr inbounds i8, ptr %1321, i64 8
  %1326 = load double, ptr %1325, align 8, !noalias !29
  %1327 = load double, ptr %1301, align 8, !noalias !29
  %1328 = fmul double %1326, %1327
  %1329 = fadd double %1324, %1328
  %1330 = getelementptr inbounds i8, ptr %1321, i64 16
  %1331 = load double, ptr %1330, align 8, !noalias !29
  %1332 = load double, ptr %1302, align 8, !noalias !29
  %1333 = fmul double %1331, %1332
  %1334 = fadd double %1329, %1333
  %1335 = getelementptr double, ptr %1303, i64 %1320
  %1336 = load double, ptr %1335, align 8, !noalias !29
  %1337 = select i1 %1285, double %1336, double %1334
  store double %1337, ptr %1335, align 8, !noalias !29
  %1338 = add nuw nsw i64 %1319, 1
  %1339 = icmp eq i64 %1338, 3
  br i1 %1339, label %1315, label %1318, !llvm.loop !39

1340:                                             ; preds = %1315, %1262
  %1341 = fdiv double %1258, %1259
  %1342 = fmul double %1242, %1341
  %1343 = fcmp olt double %1342, %542
  %1344 = and i1 %1253, %1343
  %1345 = or i1 %1243, %1344
  %1346 = and i64 %1250, 1
  %1347 = select i1 %1345, i64 %1346, i64 0
  %1348 = and i64 %1270, %1347
  %1349 = add nuw nsw i64 %982, 1
  %1350 = uitofp nneg i64 %1349 to double
  %1351 = icmp eq i64 %1348, 0
  %1352 = select i1 %1351, double %986, double %1350
  %1353 = or i64 %1348, %983
  br i1 %969, label %1360, label %1434

1354:                                             ; preds = %1237, %1354
  %1355 = phi i64 [ %1358, %1354 ], [ %982, %1237 ]
  %1356 = phi double [ %1357, %1354 ], [ %1260, %1237 ]
  %1357 = fmul double %1258, %1356
  %1358 = add nuw nsw i64 %1355, 1
  %1359 = icmp ult i64 %1355, 4
  br i1 %1359, label %1354, label %1262, !llvm.loop !40

1360:                                             ; preds = %1340
  %1361 = load i64, ptr %251, align 8, !noalias !29
  %1362 = load ptr, ptr %192, align 8, !noalias !29
  %1363 = getelementptr inbounds i8, ptr %1362, i64 40
  %1364 = load i64, ptr %1363, align 8, !noalias !29
  %1365 = load ptr, ptr %190, align 8, !noalias !29
  %1366 = getelementptr inbounds i8, ptr %1365, i64 8
  %1367 = load i64, ptr %1366, align 8, !noalias !29
  %1368 = load ptr, ptr %238, align 8, !noalias !29
  %1369 = icmp sgt i64 %1364, 0
  br i1 %1369, label %1370, label %1429

1370:                                             ; preds = %1360
  %1371 = icmp sgt i64 %1361, 0
  br label %1372

1372:                                             ; preds = %1370, %1380
  %1373 = phi double [ 0.000000e+00, %1370 ], [ %1388, %1380 ]
  %1374 = phi i64 [ 0, %1370 ], [ %1389, %1380 ]
  br i1 %1371, label %1375, label %1380

1375:                                             ; preds = %1372
  %1376 = add nuw i64 %1374, %1361
  %1377 = load ptr, ptr %252, align 8, !noalias !29
  %1378 = load ptr, ptr %191, align 8, !noalias !29
  %1379 = load ptr, ptr %253, align 8, !noalias !29
  br label %1391

1380:                                             ; preds = %1415, %1372
  %1381 = phi double [ 0.000000e+00, %1372 ], [ %1426, %1415 ]
  %1382 = phi double [ 0.000000e+00, %1372 ], [ %1416, %1415 ]
  %1383 = fcmp ule double %1381, 0.000000e+00
  %1384 = fdiv double %1382, %1381
  %1385 = select i1 %1383, double 1.000000e+00, double %1384
  %1386 = fmul double %1373, %1381
  %1387 = fcmp ule double %1382, %1386
  %1388 = select i1 %1387, double %1373, double %1385
  %1389 = add nuw nsw i64 %1374, 1
  %1390 = icmp eq i64 %1389, %1364
  br i1 %1390, label %1429, label %1372, !llvm.loop !41

1391:                                             ; preds = %1375, %1415
  %1392 = phi double [ 0.000000e+00, %1375 ], [ %1416, %1415 ]
  %1393 = phi double [ 0.000000e+00, %1375 ], [ %1426, %1415 ]
  %1394 = phi i64 [ 0, %1375 ], [ %1417, %1415 ]
  %1395 = mul nuw nsw i64 %1394, %1364
  %1396 = add i64 %1376, %1395
  %1397 = getelementptr inbounds double, ptr %1377, i64 %1396
  %1398 = load double, ptr %1397, align 8, !noalias !29
  %1399 = getelementptr inbounds double, ptr %1378, i64 %1396
  %1400 = load double, ptr %1399, align 8, !noalias !29
  %1401 = shl nsw i64 %1396, 1
  %1402 = getelementptr inbounds double, ptr %1379, i64 %1401
  %1403 = load double, ptr %1402, align 8, !noalias !29
  %1404 = or disjoint i64 %1401, 1
  %1405 = getelementptr inbounds double, ptr %1379, i64 %1404
  %1406 = load double, ptr %1405, align 8, !noalias !29
  %1407 = fmul double %1398, %1398
  %1408 = fmul double %1403, %1403
  %1409 = fmul double %1406, %1406
  %1410 = fadd double %1408, %1409
  %1411 = fadd double %1407, %1410
  %1412 = fmul double %1400, %1400
  %1413 = fadd double %1393, %1412
  %1414 = getelementptr double, ptr %1368, i64 %1396
  br label %1419

1415:                                             ; preds = %1419
  %1416 = fadd double %1392, %1411
  %1417 = add nuw nsw i64 %1394, 1
  %1418 = icmp eq i64 %1417, %1361
  br i1 %1418, label %1380, label %1391, !llvm.loop !42

1419:                                             ; preds = %1391, %1419
  %1420 = phi i64 [ 0, %1391 ], [ %1427, %1419 ]
  %1421 = phi double [ %1413, %1391 ], [ %1426, %1419 ]
  %1422 = mul nsw i64 %1367, %1420
  %1423 = getelementptr double, ptr %1414, i64 %1422
  %1424 = load double, ptr %1423, align 8, !noalias !29
  %1425 = fmul double %1424, %1424
  %1426 = fadd double %1421, %1425
  %1427 = add nuw nsw i64 %1420, 1
  %1428 = icmp eq i64 %1427, 3
  br i1 %1428, label %1415, label %1419, !llvm.loop !43

1429:                                             ; preds = %1380, %1360
  %1430 = phi double [ 0.000000e+00, %1360 ], [ %1388, %1380 ]
  %1431 = fcmp ole double %1430, %544
  %1432 = and i64 %1353, 1
  %1433 = select i1 %1431, i64 %1432, i64 0
  br label %1434

1434:                                             ; preds = %1429, %1340
  %1435 = phi i64 [ %1433, %1429 ], [ %1353, %1340 ]
  %1436 = xor i64 %1435, -1
  %1437 = and i64 %1270, %1436
  %1438 = icmp eq i64 %1437, 0
  %1439 = select i1 %1438, i32 2, i32 0
  %1440 = select i1 %1438, double %979, double %1242
  br label %1441

1441:                                             ; preds = %1434, %1075
  %1442 = phi double [ %1070, %1075 ], [ %994, %1434 ]
  %1443 = phi double [ %987, %1075 ], [ %993, %1434 ]
  %1444 = phi double [ %986, %1075 ], [ %992, %1434 ]
  %1445 = phi i64 [ %1071, %1075 ], [ %991, %1434 ]
  %1446 = phi i64 [ %1072, %1075 ], [ %990, %1434 ]
  %1447 = phi i64 [ %1078, %1075 ], [ %989, %1434 ]
  %1448 = phi double [ %987, %1075 ], [ %1258, %1434 ]
  %1449 = phi double [ %986, %1075 ], [ %1352, %1434 ]
  %1450 = phi i64 [ %1078, %1075 ], [ %1353, %1434 ]
  %1451 = phi i32 [ 1, %1075 ], [ %1439, %1434 ]
  %1452 = phi i64 [ %981, %1075 ], [ %1273, %1434 ]
  %1453 = phi i64 [ %997, %1075 ], [ %1437, %1434 ]
  %1454 = phi double [ %979, %1075 ], [ %1440, %1434 ]
  %1455 = icmp eq i32 %1451, 0
  br i1 %1455, label %975, label %1456

1456:                                             ; preds = %1441, %975
  %1457 = phi i32 [ %1451, %1441 ], [ 2, %975 ]
  %1458 = icmp eq i32 %1457, 2
  br i1 %1458, label %1459, label %1462

1459:                                             ; preds = %1456
  %1460 = xor i64 %1452, -1
  %1461 = and i64 %1450, %1460
  br label %1462

1462:                                             ; preds = %1456, %1459
  %1463 = phi double [ %1070, %1459 ], [ %1442, %1456 ]
  %1464 = phi double [ %1448, %1459 ], [ %1443, %1456 ]
  %1465 = phi double [ %1449, %1459 ], [ %1444, %1456 ]
  %1466 = phi i64 [ %1071, %1459 ], [ %1445, %1456 ]
  %1467 = phi i64 [ %1072, %1459 ], [ %1446, %1456 ]
  %1468 = phi i64 [ %1461, %1459 ], [ %1447, %1456 ]
  %1469 = fadd double %795, %1463
  %1470 = fcmp ogt double %1465, 2.000000e+00
  %1471 = fcmp ogt double %1464, 1.000000e-03
  %1472 = and i1 %1471, %1470
  %1473 = icmp eq i64 %1468, %873
  br i1 %1473, label %1541, label %1474

1474:                                             ; preds = %1462
  %1475 = xor i64 %1468, -1
  %1476 = and i64 %873, %1475
  %1477 = load ptr, ptr %192, align 8, !noalias !16
  %1478 = getelementptr inbounds i8, ptr %1477, i64 16
  %1479 = load i64, ptr %1478, align 8, !noalias !16
  %1480 = xor i64 %1467, -1
  %1481 = and i64 %1479, %1480
  %1482 = and i64 %1481, %1476
  %1483 = tail call double @llvm.fabs.f64(double %1464)
  %1484 = fcmp ueq double %1483, 0x7FF0000000000000
  %1485 = select i1 %1484, double 4.000000e+00, double 7.000000e+00
  %1486 = and i64 %1467, 4294967295
  %1487 = icmp eq i64 %1486, 0
  %1488 = select i1 %1487, double %1485, double 3.000000e+00
  %1489 = icmp eq i64 %1476, 0
  %1490 = select i1 %1489, double %872, double %1488
  %1491 = icmp eq i64 %1482, 0
  br i1 %1491, label %1512, label %1492

1492:                                             ; preds = %1474
  %1493 = load i64, ptr %260, align 8, !noalias !16
  %1494 = icmp sgt i64 %1493, 0
  br i1 %1494, label %1495, label %1507

1495:                                             ; preds = %1492, %1495
  %1496 = phi i32 [ %1503, %1495 ], [ 0, %1492 ]
  %1497 = phi i64 [ %1504, %1495 ], [ 0, %1492 ]
  %1498 = load ptr, ptr %261, align 8, !noalias !16
  %1499 = getelementptr inbounds double, ptr %1498, i64 %1497
  %1500 = load double, ptr %1499, align 8, !noalias !16
  %1501 = fcmp une double %1500, 0.000000e+00
  %1502 = zext i1 %1501 to i32
  %1503 = or i32 %1496, %1502
  store double 0.000000e+00, ptr %1499, align 8, !noalias !16
  %1504 = add nuw nsw i64 %1497, 1
  %1505 = load i64, ptr %260, align 8, !noalias !16
  %1506 = icmp slt i64 %1504, %1505
  br i1 %1506, label %1495, label %1507, !llvm.loop !44

1507:                                             ; preds = %1495, %1492
  %1508 = phi i32 [ 0, %1492 ], [ %1503, %1495 ]
  %1509 = zext nneg i32 %1508 to i64
  %1510 = and i64 %1482, %1509
  %1511 = xor i64 %1510, -1
  br label %1512

1512:                                             ; preds = %1474, %1507
  %1513 = phi i64 [ %1511, %1507 ], [ -1, %1474 ]
  %1514 = and i64 %1513, %1482
  %1515 = getelementptr inbounds i8, ptr %1477, i64 24
  %1516 = load i64, ptr %1515, align 8, !noalias !16
  %1517 = and i64 %1516, %1513
  store i64 %1517, ptr %1515, align 8, !noalias !16
  %1518 = xor i64 %1514, -1
  %1519 = load i64, ptr %1478, align 8, !noalias !16
  %1520 = and i64 %1519, %1518
  store i64 %1520, ptr %1478, align 8, !noalias !16
  %1521 = fmul double %644, 5.000000e-01
  %1522 = icmp eq i64 %1514, 0
  %1523 = select i1 %1522, double %871, double %1521
  %1524 = fmul double %644, 2.500000e-01
  %1525 = select i1 %1487, double %1523, double %1524
  %1526 = load ptr, ptr %229, align 8, !noalias !16
  %1527 = getelementptr inbounds i8, ptr %1526, i64 8
  %1528 = load double, ptr %1527, align 8, !noalias !16
  %1529 = select i1 %1487, double %1528, double 0.000000e+00
  store double %1529, ptr %1527, align 8, !noalias !16
  %1530 = and i64 %1513, %1476
  %1531 = load ptr, ptr %192, align 8, !noalias !16
  %1532 = getelementptr inbounds i8, ptr %1531, i64 8
  %1533 = load i64, ptr %1532, align 8, !noalias !16
  %1534 = xor i64 %1530, -1
  %1535 = and i64 %1533, %1534
  %1536 = getelementptr inbounds i8, ptr %1531, i64 16
  %1537 = load i64, ptr %1536, align 8, !noalias !16
  %1538 = xor i64 %1537, -1
  %1539 = and i64 %1530, %1538
  %1540 = or disjoint i64 %1539, %1535
  store i64 %1540, ptr %1532, align 8, !noalias !16
  br label %1541

1541:                                             ; preds = %1512, %1462
  %1542 = phi double [ %871, %1462 ], [ %1525, %1512 ]
  %1543 = phi double [ %872, %1462 ], [ %1490, %1512 ]
  %1544 = icmp eq i64 %1468, 0
  %1545 = icmp ne i64 %1466, 0
  %1546 = select i1 %1544, i1 true, i1 %1545
  br i1 %1546, label %2094, label %1547

1547:                                             ; preds = %1541
  %1548 = icmp sgt i64 %654, 0
  br i1 %1548, label %1549, label %1551

1549:                                             ; preds = %1547
  %1550 = shl i64 %654, 4
  br label %2080

1551:                                             ; preds = %2080, %1547
  %1552 = load i64, ptr %659, align 8, !noalias !16
  %1553 = load ptr, ptr %190, align 8, !noalias !16
  %1554 = getelementptr inbounds i8, ptr %1553, i64 8
  %1555 = load i64, ptr %1554, align 8, !noalias !16
  %1556 = load ptr, ptr %263, align 8, !noalias !16
  %1557 = load ptr, ptr %264, align 8, !noalias !16
  %1558 = icmp sgt i64 %1555, 0
  br i1 %1558, label %1559, label %1561

1559:                                             ; preds = %1551
  %1560 = shl i64 %1555, 4
  br label %1746

1561:                                             ; preds = %1746, %1551
  %1562 = load i64, ptr %267, align 8, !noalias !16
  %1563 = load ptr, ptr %192, align 8, !noalias !16
  %1564 = getelementptr inbounds i8, ptr %1563, i64 40
  %1565 = load i64, ptr %1564, align 8, !noalias !16
  %1566 = load ptr, ptr %268, align 8, !noalias !16
  %1567 = load ptr, ptr %266, align 8, !noalias !16
  tail call fastcc void @real_solve(ptr noundef %1566, i64 noundef %1562, ptr noundef %1567, ptr noundef %1557) #11, !noalias !16
  %1568 = icmp sgt i64 %1565, 0
  br i1 %1568, label %1569, label %1573

1569:                                             ; preds = %1561
  %1570 = load ptr, ptr %268, align 8, !noalias !16
  %1571 = load ptr, ptr %266, align 8, !noalias !16
  %1572 = getelementptr inbounds double, ptr %1557, i64 %1562
  tail call fastcc void @real_solve_columns(ptr noundef %1570, i64 noundef %1562, ptr noundef %1571, ptr noundef %1572, i64 noundef %1565) #11, !noalias !16
  br label %1573

1573:                                             ; preds = %1561, %1569
  %1574 = load ptr, ptr %190, align 8, !noalias !16
  %1575 = getelementptr inbounds i8, ptr %1574, i64 24
  %1576 = load i64, ptr %1575, align 8, !noalias !16
  %1577 = load ptr, ptr %269, align 8, !noalias !16
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %1557, ptr noundef %1577, ptr noundef nonnull %191, i64 noundef %1576) #11, !noalias !16
  %1578 = load double, ptr %8, align 8, !noalias !16
  %1579 = getelementptr inbounds i8, ptr %1574, i64 8
  %1580 = load i64, ptr %1579, align 8, !noalias !16
  %1581 = add nsw i64 %1580, -3
  %1582 = getelementptr i8, ptr %1577, i64 8
  %1583 = getelementptr i8, ptr %1577, i64 16
  %1584 = getelementptr i8, ptr %1577, i64 24
  %1585 = icmp slt i64 %1576, %1581
  br i1 %1585, label %1593, label %1586

1586:                                             ; preds = %1593, %1573
  %1587 = phi double [ 0.000000e+00, %1573 ], [ %1602, %1593 ]
  %1588 = phi double [ 0.000000e+00, %1573 ], [ %1606, %1593 ]
  %1589 = phi double [ 0.000000e+00, %1573 ], [ %1610, %1593 ]
  %1590 = phi double [ 0.000000e+00, %1573 ], [ %1614, %1593 ]
  %1591 = phi i64 [ %1576, %1573 ], [ %1615, %1593 ]
  %1592 = icmp slt i64 %1591, %1580
  br i1 %1592, label %1617, label %1626

1593:                                             ; preds = %1573, %1593
  %1594 = phi i64 [ %1615, %1593 ], [ %1576, %1573 ]
  %1595 = phi double [ %1614, %1593 ], [ 0.000000e+00, %1573 ]
  %1596 = phi double [ %1610, %1593 ], [ 0.000000e+00, %1573 ]
  %1597 = phi double [ %1606, %1593 ], [ 0.000000e+00, %1573 ]
  %1598 = phi double [ %1602, %1593 ], [ 0.000000e+00, %1573 ]
  %1599 = getelementptr inbounds double, ptr %1577, i64 %1594
  %1600 = load double, ptr %1599, align 8, !noalias !16
  %1601 = fmul double %1600, 0.000000e+00
  %1602 = fadd double %1598, %1601
  %1603 = getelementptr double, ptr %1582, i64 %1594
  %1604 = load double, ptr %1603, align 8, !noalias !16
  %1605 = fmul double %1604, 0.000000e+00
  %1606 = fadd double %1597, %1605
  %1607 = getelementptr double, ptr %1583, i64 %1594
  %1608 = load double, ptr %1607, align 8, !noalias !16
  %1609 = fmul double %1608, 0.000000e+00
  %1610 = fadd double %1596, %1609
  %1611 = getelementptr double, ptr %1584, i64 %1594
  %1612 = load double, ptr %1611, align 8, !noalias !16
  %1613 = fmul double %1612, 0.000000e+00
  %1614 = fadd double %1595, %1613
  %1615 = add nsw i64 %1594, 4
  %1616 = icmp slt i64 %1615, %1581
  br i1 %1616, label %1593, label %1586, !llvm.loop !45

1617:                                             ; preds = %1586, %1617
  %1618 = phi i64 [ %1624, %1617 ], [ %1591, %1586 ]
  %1619 = phi double [ %1623, %1617 ], [ %1587, %1586 ]
  %1620 = getelementptr inbounds double, ptr %1577, i64 %1618
  %1621 = load double, ptr %1620, align 8, !noalias !16
  %1622 = fmul double %1621, 0.000000e+00
  %1623 = fadd double %1619, %1622
  %1624 = add nsw i64 %1618, 1
  %1625 = icmp eq i64 %1624, %1580
  br i1 %1625, label %1626, label %1617, !llvm.loop !46

1626:                                             ; preds = %1617, %1586
  %1627 = phi double [ %1587, %1586 ], [ %1623, %1617 ]
  %1628 = fadd double %1588, %1627
  %1629 = fadd double %1589, %1590
  %1630 = fadd double %1629, %1628
  %1631 = fadd double %1578, %1630
  %1632 = getelementptr inbounds i8, ptr %1574, i64 48
  %1633 = load i64, ptr %1632, align 8, !noalias !16
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %6, i8 0, i64 64, i1 false), !noalias !16
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %7, i8 0, i64 64, i1 false), !noalias !16
  %1634 = icmp eq i64 %1633, 0
  br i1 %1634, label %1735, label %1635

1635:                                             ; preds = %1626
  %1636 = add nsw i64 %1576, 7
  %1637 = sdiv i64 %1636, 8
  %1638 = shl nsw i64 %1637, 3
  %1639 = tail call i64 @llvm.smin.i64(i64 %1638, i64 %1633)
  %1640 = icmp slt i64 %1576, %1639
  br i1 %1640, label %1641, label %1675

1641:                                             ; preds = %1635
  %1642 = load ptr, ptr %191, align 8, !noalias !16
  %1643 = load ptr, ptr %270, align 8, !noalias !16
  %1644 = load ptr, ptr %197, align 8, !noalias !16
  br label %1645

1645:                                             ; preds = %1641, %1645
  %1646 = phi i64 [ %1576, %1641 ], [ %1673, %1645 ]
  %1647 = getelementptr inbounds double, ptr %1642, i64 %1646
  %1648 = load double, ptr %1647, align 8, !noalias !16
  %1649 = tail call double @llvm.fabs.f64(double %1648)
  %1650 = getelementptr inbounds double, ptr %1577, i64 %1646
  %1651 = load double, ptr %1650, align 8, !noalias !16
  %1652 = tail call double @llvm.fabs.f64(double %1651)
  %1653 = fcmp ogt double %1649, %1652
  %1654 = select i1 %1653, double %1649, double %1652
  %1655 = getelementptr inbounds double, ptr %1643, i64 %1646
  %1656 = load double, ptr %1655, align 8, !noalias !16
  %1657 = getelementptr inbounds double, ptr %1644, i64 %1646
  %1658 = load double, ptr %1657, align 8, !noalias !16
  %1659 = fmul double %1654, %1658
  %1660 = fadd double %1656, %1659
  %1661 = fdiv double 1.000000e+00, %1660
  %1662 = getelementptr inbounds double, ptr %1557, i64 %1646
  %1663 = load double, ptr %1662, align 8, !noalias !16
  %1664 = fmul double %1663, %1661
  %1665 = srem i64 %1646, 8
  %1666 = getelementptr inbounds double, ptr %6, i64 %1665
  %1667 = load double, ptr %1666, align 8, !noalias !16
  %1668 = fmul double %1664, %1664
  %1669 = fadd double %1667, %1668
  store double %1669, ptr %1666, align 8, !noalias !16
  %1670 = getelementptr inbounds double, ptr %7, i64 %1665
  %1671 = load double, ptr %1670, align 8, !noalias !16
  %1672 = fadd double %1671, %1668
  store double %1672, ptr %1670, align 8, !noalias !16
  %1673 = add nsw i64 %1646, 1
  %1674 = icmp eq i64 %1673, %1639
  br i1 %1674, label %1675, label %1645, !llvm.loop !47

1675:                                             ; preds = %1645, %1635
  %1676 = phi i64 [ %1576, %1635 ], [ %1673, %1645 ]
  %1677 = load <8 x double>, ptr %6, align 16, !noalias !16
  %1678 = load <8 x double>, ptr %7, align 16, !noalias !16
  %1679 = icmp slt i64 %1676, %1633
  br i1 %1679, label %1680, label %1715

1680:                                             ; preds = %1675
  %1681 = load ptr, ptr %191, align 8, !noalias !16
  %1682 = load ptr, ptr %271, align 8, !noalias !16
  %1683 = load ptr, ptr %197, align 8, !noalias !16
  br label %1684

1684:                                             ; preds = %1680, %1684
  %1685 = phi i64 [ %1676, %1680 ], [ %1713, %1684 ]
  %1686 = phi <8 x double> [ %1677, %1680 ], [ %1711, %1684 ]
  %1687 = phi <8 x double> [ %1678, %1680 ], [ %1712, %1684 ]
  %1688 = getelementptr inbounds double, ptr %1681, i64 %1685
  %1689 = load <8 x double>, ptr %1688, align 8, !noalias !16
  %1690 = fneg <8 x double> %1689
  %1691 = fcmp ogt <8 x double> %1689, zeroinitializer
  %1692 = select <8 x i1> %1691, <8 x double> %1689, <8 x double> %1690
  %1693 = getelementptr inbounds double, ptr %1577, i64 %1685
  %1694 = load <8 x double>, ptr %1693, align 8, !noalias !16
  %1695 = fneg <8 x double> %1694
  %1696 = fcmp ogt <8 x double> %1694, zeroinitializer
  %1697 = select <8 x i1> %1696, <8 x double> %1694, <8 x double> %1695
  %1698 = fcmp ogt <8 x double> %1692, %1697
  %1699 = select <8 x i1> %1698, <8 x double> %1692, <8 x double> %1697
  %1700 = getelementptr inbounds double, ptr %1682, i64 %1685
  %1701 = load <8 x double>, ptr %1700, align 8, !noalias !16
  %1702 = getelementptr inbounds double, ptr %1683, i64 %1685
  %1703 = load <8 x double>, ptr %1702, align 8, !noalias !16
  %1704 = fmul <8 x double> %1703, %1699
  %1705 = fadd <8 x double> %1701, %1704
  %1706 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1705
  %1707 = getelementptr inbounds double, ptr %1557, i64 %1685
  %1708 = load <8 x double>, ptr %1707, align 8, !noalias !16
  %1709 = fmul <8 x double> %1708, %1706
  %1710 = fmul <8 x double> %1709, %1709
  %1711 = fadd <8 x double> %1686, %1710
  %1712 = fadd <8 x double> %1687, %1710
  %1713 = add nsw i64 %1685, 8
  %1714 = icmp slt i64 %1713, %1633
  br i1 %1714, label %1684, label %1715, !llvm.loop !48

1715:                                             ; preds = %1684, %1675
  %1716 = phi <8 x double> [ %1678, %1675 ], [ %1712, %1684 ]
  %1717 = phi <8 x double> [ %1677, %1675 ], [ %1711, %1684 ]
  store <8 x double> %1717, ptr %6, align 16, !noalias !16
  store <8 x double> %1716, ptr %7, align 16, !noalias !16
  br label %1727

1718:                                             ; preds = %1727
  %1719 = sub nsw i64 %1633, %1576
  %1720 = sitofp i64 %1719 to double
  %1721 = fdiv double %1732, %1720
  %1722 = tail call double @llvm.sqrt.f64(double %1721)
  %1723 = fcmp ule double %644, %348
  %1724 = fcmp ogt double %1722, %1631
  %1725 = select i1 %1724, double %1722, double %1631
  %1726 = select i1 %1723, double %1631, double %1725
  br label %1735

1727:                                             ; preds = %1715, %1727
  %1728 = phi i64 [ 0, %1715 ], [ %1733, %1727 ]
  %1729 = phi double [ 0.000000e+00, %1715 ], [ %1732, %1727 ]
  %1730 = getelementptr inbounds double, ptr %6, i64 %1728
  %1731 = load double, ptr %1730, align 8, !noalias !16
  %1732 = fadd double %1729, %1731
  %1733 = add nuw nsw i64 %1728, 1
  %1734 = icmp eq i64 %1733, 8
  br i1 %1734, label %1718, label %1727, !llvm.loop !49

1735:                                             ; preds = %1626, %1718
  %1736 = phi double [ %1726, %1718 ], [ %1631, %1626 ]
  %1737 = fcmp olt double %1736, 1.000000e+00
  %1738 = zext i1 %1737 to i64
  %1739 = xor i64 %1738, -1
  %1740 = and i64 %1552, %1739
  %1741 = and i64 %1740, %1468
  %1742 = and i64 %1468, %1738
  %1743 = icmp eq i64 %1741, 0
  br i1 %1743, label %2013, label %1744

1744:                                             ; preds = %1735
  %1745 = icmp sgt i64 %1555, 0
  br i1 %1745, label %1805, label %1771

1746:                                             ; preds = %1559, %1746
  %1747 = phi i64 [ 0, %1559 ], [ %1769, %1746 ]
  %1748 = load ptr, ptr %237, align 8, !noalias !16
  %1749 = getelementptr inbounds double, ptr %1748, i64 %1747
  %1750 = load double, ptr %1749, align 8, !noalias !16
  %1751 = fmul double %1750, 0x402418FD8BAFFE05
  %1752 = getelementptr double, ptr %1748, i64 %1555
  %1753 = getelementptr double, ptr %1752, i64 %1747
  %1754 = load double, ptr %1753, align 8, !noalias !16
  %1755 = fmul double %1754, 0x3FF61D41B2D54580
  %1756 = fsub double %1755, %1751
  %1757 = getelementptr i8, ptr %1748, i64 %1560
  %1758 = getelementptr double, ptr %1757, i64 %1747
  %1759 = load double, ptr %1758, align 8, !noalias !16
  %1760 = fmul double %1759, 0x3FD5555555555555
  %1761 = fsub double %1756, %1760
  %1762 = fdiv double %1761, %644
  %1763 = getelementptr inbounds double, ptr %1556, i64 %1747
  store double %1762, ptr %1763, align 8, !noalias !16
  %1764 = load ptr, ptr %265, align 8, !noalias !16
  %1765 = getelementptr inbounds double, ptr %1764, i64 %1747
  %1766 = load double, ptr %1765, align 8, !noalias !16
  %1767 = fadd double %1766, %1762
  %1768 = getelementptr inbounds double, ptr %1557, i64 %1747
  store double %1767, ptr %1768, align 8, !noalias !16
  %1769 = add nuw nsw i64 %1747, 1
  %1770 = icmp eq i64 %1769, %1555
  br i1 %1770, label %1561, label %1746, !llvm.loop !50

1771:                                             ; preds = %1805, %1744
  %1772 = and i64 %1741, 4294967295
  %1773 = icmp eq i64 %1772, 0
  %1774 = select i1 %1773, double 0.000000e+00, double 1.000000e+00
  %1775 = fadd double %1469, %1774
  %1776 = load ptr, ptr %273, align 8, !noalias !16
  %1777 = load ptr, ptr %274, align 8, !noalias !16
  %1778 = load ptr, ptr %275, align 8, !noalias !16
  store double %567, ptr %1778, align 8, !noalias !16
  %1779 = load ptr, ptr %190, align 8, !noalias !16
  %1780 = getelementptr inbounds i8, ptr %1779, i64 40
  %1781 = load i64, ptr %1780, align 8, !noalias !16
  %1782 = icmp eq i64 %1781, 0
  br i1 %1782, label %1784, label %1783

1783:                                             ; preds = %1771
  tail call fastcc void @settle(ptr noundef nonnull %190) #11, !noalias !16
  br label %1784

1784:                                             ; preds = %1783, %1771
  %1785 = load i64, ptr %276, align 8, !noalias !16
  %1786 = icmp sgt i64 %1785, 0
  br i1 %1786, label %1787, label %1788

1787:                                             ; preds = %1784
  tail call fastcc void @sample(ptr noundef nonnull %190) #11, !noalias !16
  br label %1788

1788:                                             ; preds = %1787, %1784
  %1789 = load ptr, ptr %190, align 8, !noalias !16
  %1790 = load i64, ptr %1789, align 8, !noalias !16
  %1791 = load ptr, ptr %275, align 8, !noalias !16
  %1792 = load ptr, ptr %277, align 8, !noalias !16
  %1793 = load ptr, ptr %278, align 8, !noalias !16
  %1794 = inttoptr i64 %1790 to ptr
  %1795 = load ptr, ptr %1794, align 8, !noalias !16
  %1796 = tail call i32 %1795(ptr noundef %1791, ptr noundef %1776, ptr noundef %1792, ptr noundef %1793, ptr noundef %1777) #10, !noalias !16
  %1797 = sext i32 %1796 to i64
  %1798 = icmp slt i32 %1796, 0
  %1799 = select i1 %1798, i64 %1797, i64 %1466
  %1800 = trunc i64 %1741 to i32
  %1801 = and i32 %1796, %1800
  %1802 = icmp eq i32 %1801, 0
  %1803 = select i1 %1802, double %1543, double 3.000000e+00
  %1804 = icmp sgt i64 %1555, 0
  br i1 %1804, label %2002, label %1817

1805:                                             ; preds = %1744, %1805
  %1806 = phi i64 [ %1815, %1805 ], [ 0, %1744 ]
  %1807 = load ptr, ptr %272, align 8, !noalias !16
  %1808 = load ptr, ptr %191, align 8, !noalias !16
  %1809 = getelementptr inbounds double, ptr %1808, i64 %1806
  %1810 = load double, ptr %1809, align 8, !noalias !16
  %1811 = getelementptr inbounds double, ptr %1557, i64 %1806
  %1812 = load double, ptr %1811, align 8, !noalias !16
  %1813 = fadd double %1810, %1812
  %1814 = getelementptr inbounds double, ptr %1807, i64 %1806
  store double %1813, ptr %1814, align 8, !noalias !16
  %1815 = add nuw nsw i64 %1806, 1
  %1816 = icmp eq i64 %1815, %1555
  br i1 %1816, label %1771, label %1805, !llvm.loop !51

1817:                                             ; preds = %2002, %1788
  %1818 = load i64, ptr %267, align 8, !noalias !16
  %1819 = load ptr, ptr %192, align 8, !noalias !16
  %1820 = getelementptr inbounds i8, ptr %1819, i64 40
  %1821 = load i64, ptr %1820, align 8, !noalias !16
  %1822 = load ptr, ptr %268, align 8, !noalias !16
  %1823 = load ptr, ptr %266, align 8, !noalias !16
  tail call fastcc void @real_solve(ptr noundef %1822, i64 noundef %1818, ptr noundef %1823, ptr noundef %1557) #11, !noalias !16
  %1824 = icmp sgt i64 %1821, 0
  br i1 %1824, label %1825, label %1829

1825:                                             ; preds = %1817
  %1826 = load ptr, ptr %268, align 8, !noalias !16
  %1827 = load ptr, ptr %266, align 8, !noalias !16
  %1828 = getelementptr inbounds double, ptr %1557, i64 %1818
  tail call fastcc void @real_solve_columns(ptr noundef %1826, i64 noundef %1818, ptr noundef %1827, ptr noundef %1828, i64 noundef %1821) #11, !noalias !16
  br label %1829

1829:                                             ; preds = %1817, %1825
  %1830 = load ptr, ptr %190, align 8, !noalias !16
  %1831 = getelementptr inbounds i8, ptr %1830, i64 24
  %1832 = load i64, ptr %1831, align 8, !noalias !16
  %1833 = load ptr, ptr %269, align 8, !noalias !16
  call fastcc void @norm_to(ptr noundef nonnull %9, ptr noundef %1557, ptr noundef %1833, ptr noundef nonnull %191, i64 noundef %1832) #11, !noalias !16
  %1834 = load double, ptr %9, align 8, !noalias !16
  %1835 = getelementptr inbounds i8, ptr %1830, i64 8
  %1836 = load i64, ptr %1835, align 8, !noalias !16
  %1837 = add nsw i64 %1836, -3
  %1838 = getelementptr i8, ptr %1833, i64 8
  %1839 = getelementptr i8, ptr %1833, i64 16
  %1840 = getelementptr i8, ptr %1833, i64 24
  %1841 = icmp slt i64 %1832, %1837
  br i1 %1841, label %1849, label %1842

1842:                                             ; preds = %1849, %1829
  %1843 = phi double [ 0.000000e+00, %1829 ], [ %1858, %1849 ]
  %1844 = phi double [ 0.000000e+00, %1829 ], [ %1862, %1849 ]
  %1845 = phi double [ 0.000000e+00, %1829 ], [ %1866, %1849 ]
  %1846 = phi double [ 0.000000e+00, %1829 ], [ %1870, %1849 ]
  %1847 = phi i64 [ %1832, %1829 ], [ %1871, %1849 ]
  %1848 = icmp slt i64 %1847, %1836
  br i1 %1848, label %1873, label %1882

1849:                                             ; preds = %1829, %1849
  %1850 = phi i64 [ %1871, %1849 ], [ %1832, %1829 ]
  %1851 = phi double [ %1870, %1849 ], [ 0.000000e+00, %1829 ]
  %1852 = phi double [ %1866, %1849 ], [ 0.000000e+00, %1829 ]
  %1853 = phi double [ %1862, %1849 ], [ 0.000000e+00, %1829 ]
  %1854 = phi double [ %1858, %1849 ], [ 0.000000e+00, %1829 ]
  %1855 = getelementptr inbounds double, ptr %1833, i64 %1850
  %1856 = load double, ptr %1855, align 8, !noalias !16
  %1857 = fmul double %1856, 0.000000e+00
  %1858 = fadd double %1854, %1857
  %1859 = getelementptr double, ptr %1838, i64 %1850
  %1860 = load double, ptr %1859, align 8, !noalias !16
  %1861 = fmul double %1860, 0.000000e+00
  %1862 = fadd double %1853, %1861
  %1863 = getelementptr double, ptr %1839, i64 %1850
  %1864 = load double, ptr %1863, align 8, !noalias !16
  %1865 = fmul double %1864, 0.000000e+00
  %1866 = fadd double %1852, %1865
  %1867 = getelementptr double, ptr %1840, i64 %1850
  %1868 = load double, ptr %1867, align 8, !noalias !16
  %1869 = fmul double %1868, 0.000000e+00
  %1870 = fadd double %1851, %1869
  %1871 = add nsw i64 %1850, 4
  %1872 = icmp slt i64 %1871, %1837
  br i1 %1872, label %1849, label %1842, !llvm.loop !45

1873:                                             ; preds = %1842, %1873
  %1874 = phi i64 [ %1880, %1873 ], [ %1847, %1842 ]
  %1875 = phi double [ %1879, %1873 ], [ %1843, %1842 ]
  %1876 = getelementptr inbounds double, ptr %1833, i64 %1874
  %1877 = load double, ptr %1876, align 8, !noalias !16
  %1878 = fmul double %1877, 0.000000e+00
  %1879 = fadd double %1875, %1878
  %1880 = add nsw i64 %1874, 1
  %1881 = icmp eq i64 %1880, %1836
  br i1 %1881, label %1882, label %1873, !llvm.loop !46

1882:                                             ; preds = %1873, %1842
  %1883 = phi double [ %1843, %1842 ], [ %1879, %1873 ]
  %1884 = fadd double %1844, %1883
  %1885 = fadd double %1845, %1846
  %1886 = fadd double %1885, %1884
  %1887 = fadd double %1834, %1886
  %1888 = getelementptr inbounds i8, ptr %1830, i64 48
  %1889 = load i64, ptr %1888, align 8, !noalias !16
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %4, i8 0, i64 64, i1 false), !noalias !16
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %5, i8 0, i64 64, i1 false), !noalias !16
  %1890 = icmp eq i64 %1889, 0
  br i1 %1890, label %1991, label %1891

1891:                                             ; preds = %1882
  %1892 = add nsw i64 %1832, 7
  %1893 = sdiv i64 %1892, 8
  %1894 = shl nsw i64 %1893, 3
  %1895 = tail call i64 @llvm.smin.i64(i64 %1894, i64 %1889)
  %1896 = icmp slt i64 %1832, %1895
  br i1 %1896, label %1897, label %1931

1897:                                             ; preds = %1891
  %1898 = load ptr, ptr %191, align 8, !noalias !16
  %1899 = load ptr, ptr %279, align 8, !noalias !16
  %1900 = load ptr, ptr %197, align 8, !noalias !16
  br label %1901

1901:                                             ; preds = %1897, %1901
  %1902 = phi i64 [ %1832, %1897 ], [ %1929, %1901 ]
  %1903 = getelementptr inbounds double, ptr %1898, i64 %1902
  %1904 = load double, ptr %1903, align 8, !noalias !16
  %1905 = tail call double @llvm.fabs.f64(double %1904)
  %1906 = getelementptr inbounds double, ptr %1833, i64 %1902
  %1907 = load double, ptr %1906, align 8, !noalias !16
  %1908 = tail call double @llvm.fabs.f64(double %1907)
  %1909 = fcmp ogt double %1905, %1908
  %1910 = select i1 %1909, double %1905, double %1908
  %1911 = getelementptr inbounds double, ptr %1899, i64 %1902
  %1912 = load double, ptr %1911, align 8, !noalias !16
  %1913 = getelementptr inbounds double, ptr %1900, i64 %1902
  %1914 = load double, ptr %1913, align 8, !noalias !16
  %1915 = fmul double %1910, %1914
  %1916 = fadd double %1912, %1915
  %1917 = fdiv double 1.000000e+00, %1916
  %1918 = getelementptr inbounds double, ptr %1557, i64 %1902
  %1919 = load double, ptr %1918, align 8, !noalias !16
  %1920 = fmul double %1919, %1917
  %1921 = srem i64 %1902, 8
  %1922 = getelementptr inbounds double, ptr %4, i64 %1921
  %1923 = load double, ptr %1922, align 8, !noalias !16
  %1924 = fmul double %1920, %1920
  %1925 = fadd double %1923, %1924
  store double %1925, ptr %1922, align 8, !noalias !16
  %1926 = getelementptr inbounds double, ptr %5, i64 %1921
  %1927 = load double, ptr %1926, align 8, !noalias !16
  %1928 = fadd double %1927, %1924
  store double %1928, ptr %1926, align 8, !noalias !16
  %1929 = add nsw i64 %1902, 1
  %1930 = icmp eq i64 %1929, %1895
  br i1 %1930, label %1931, label %1901, !llvm.loop !47

1931:                                             ; preds = %1901, %1891
  %1932 = phi i64 [ %1832, %1891 ], [ %1929, %1901 ]
  %1933 = load <8 x double>, ptr %4, align 16, !noalias !16
  %1934 = load <8 x double>, ptr %5, align 16, !noalias !16
  %1935 = icmp slt i64 %1932, %1889
  br i1 %1935, label %1936, label %1971

1936:                                             ; preds = %1931
  %1937 = load ptr, ptr %191, align 8, !noalias !16
  %1938 = load ptr, ptr %280, align 8, !noalias !16
  %1939 = load ptr, ptr %197, align 8, !noalias !16
  br label %1940

1940:                                             ; preds = %1936, %1940
  %1941 = phi i64 [ %1932, %1936 ], [ %1969, %1940 ]
  %1942 = phi <8 x double> [ %1933, %1936 ], [ %1967, %1940 ]
  %1943 = phi <8 x double> [ %1934, %1936 ], [ %1968, %1940 ]
  %1944 = getelementptr inbounds double, ptr %1937, i64 %1941
  %1945 = load <8 x double>, ptr %1944, align 8, !noalias !16
  %1946 = fneg <8 x double> %1945
  %1947 = fcmp ogt <8 x double> %1945, zeroinitializer
  %1948 = select <8 x i1> %1947, <8 x double> %1945, <8 x double> %1946
  %1949 = getelementptr inbounds double, ptr %1833, i64 %1941
  %1950 = load <8 x double>, ptr %1949, align 8, !noalias !16
  %1951 = fneg <8 x double> %1950
  %1952 = fcmp ogt <8 x double> %1950, zeroinitializer
  %1953 = select <8 x i1> %1952, <8 x double> %1950, <8 x double> %1951
  %1954 = fcmp ogt <8 x double> %1948, %1953
  %1955 = select <8 x i1> %1954, <8 x double> %1948, <8 x double> %1953
  %1956 = getelementptr inbounds double, ptr %1938, i64 %1941
  %1957 = load <8 x double>, ptr %1956, align 8, !noalias !16
  %1958 = getelementptr inbounds double, ptr %1939, i64 %1941
  %1959 = load <8 x double>, ptr %1958, align 8, !noalias !16
  %1960 = fmul <8 x double> %1959, %1955
  %1961 = fadd <8 x double> %1957, %1960
  %1962 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1961
  %1963 = getelementptr inbounds double, ptr %1557, i64 %1941
  %1964 = load <8 x double>, ptr %1963, align 8, !noalias !16
  %1965 = fmul <8 x double> %1964, %1962
  %1966 = fmul <8 x double> %1965, %1965
  %1967 = fadd <8 x double> %1942, %1966
  %1968 = fadd <8 x double> %1943, %1966
  %1969 = add nsw i64 %1941, 8
  %1970 = icmp slt i64 %1969, %1889
  br i1 %1970, label %1940, label %1971, !llvm.loop !48

1971:                                             ; preds = %1940, %1931
  %1972 = phi <8 x double> [ %1934, %1931 ], [ %1968, %1940 ]
  %1973 = phi <8 x double> [ %1933, %1931 ], [ %1967, %1940 ]
  store <8 x double> %1973, ptr %4, align 16, !noalias !16
  store <8 x double> %1972, ptr %5, align 16, !noalias !16
  br label %1983

1974:                                             ; preds = %1983
  %1975 = sub nsw i64 %1889, %1832
  %1976 = sitofp i64 %1975 to double
  %1977 = fdiv double %1988, %1976
  %1978 = tail call double @llvm.sqrt.f64(double %1977)
  %1979 = fcmp ule double %644, %348
  %1980 = fcmp ogt double %1978, %1887
  %1981 = select i1 %1980, double %1978, double %1887
  %1982 = select i1 %1979, double %1887, double %1981
  br label %1991

1983:                                             ; preds = %1971, %1983
  %1984 = phi i64 [ 0, %1971 ], [ %1989, %1983 ]
  %1985 = phi double [ 0.000000e+00, %1971 ], [ %1988, %1983 ]
  %1986 = getelementptr inbounds double, ptr %4, i64 %1984
  %1987 = load double, ptr %1986, align 8, !noalias !16
  %1988 = fadd double %1985, %1987
  %1989 = add nuw nsw i64 %1984, 1
  %1990 = icmp eq i64 %1989, 8
  br i1 %1990, label %1974, label %1983, !llvm.loop !49

1991:                                             ; preds = %1882, %1974
  %1992 = phi double [ %1982, %1974 ], [ %1887, %1882 ]
  %1993 = xor i64 %1797, -1
  %1994 = and i64 %1741, %1993
  %1995 = fcmp olt double %1992, 1.000000e+00
  %1996 = and i64 %1994, 1
  %1997 = select i1 %1995, i64 %1996, i64 0
  %1998 = or i64 %1997, %1742
  %1999 = and i64 %1994, 4294967295
  %2000 = icmp eq i64 %1999, 0
  %2001 = select i1 %2000, double %1736, double %1992
  br label %2013

2002:                                             ; preds = %1788, %2002
  %2003 = phi i64 [ %2011, %2002 ], [ 0, %1788 ]
  %2004 = load ptr, ptr %274, align 8, !noalias !16
  %2005 = getelementptr inbounds double, ptr %2004, i64 %2003
  %2006 = load double, ptr %2005, align 8, !noalias !16
  %2007 = getelementptr inbounds double, ptr %1556, i64 %2003
  %2008 = load double, ptr %2007, align 8, !noalias !16
  %2009 = fadd double %2006, %2008
  %2010 = getelementptr inbounds double, ptr %1557, i64 %2003
  store double %2009, ptr %2010, align 8, !noalias !16
  %2011 = add nuw nsw i64 %2003, 1
  %2012 = icmp eq i64 %2011, %1555
  br i1 %2012, label %1817, label %2002, !llvm.loop !52

2013:                                             ; preds = %1735, %1991
  %2014 = phi double [ %1469, %1735 ], [ %1775, %1991 ]
  %2015 = phi i64 [ %1466, %1735 ], [ %1799, %1991 ]
  %2016 = phi i64 [ %1742, %1735 ], [ %1998, %1991 ]
  %2017 = phi double [ %1543, %1735 ], [ %1803, %1991 ]
  %2018 = phi double [ %1736, %1735 ], [ %2001, %1991 ]
  %2019 = fcmp olt double %2018, 1.000000e-10
  %2020 = select i1 %2019, double 1.000000e-10, double %2018
  %2021 = load ptr, ptr %229, align 8, !noalias !16
  %2022 = getelementptr inbounds i8, ptr %2021, i64 24
  %2023 = load double, ptr %2022, align 8, !noalias !16
  %2024 = fadd double %1465, 1.200000e+01
  %2025 = fdiv double 0x4027666666666667, %2024
  %2026 = tail call double @llvm.sqrt.f64(double %2020)
  %2027 = tail call double @llvm.sqrt.f64(double %2026)
  %2028 = fdiv double 1.000000e+00, %2027
  %2029 = fmul double %2025, %2028
  %2030 = fcmp ogt double %2029, 2.000000e-01
  %2031 = select i1 %2030, double %2029, double 2.000000e-01
  %2032 = tail call double @llvm.fabs.f64(double %2018)
  %2033 = fcmp ueq double %2032, 0x7FF0000000000000
  %2034 = select i1 %2033, double 2.500000e-01, double %2031
  %2035 = fmul double %644, %2034
  %2036 = getelementptr inbounds i8, ptr %2021, i64 16
  %2037 = load double, ptr %2036, align 8, !noalias !16
  %2038 = fdiv double %644, %2037
  %2039 = fdiv double %2023, %2020
  %2040 = tail call double @llvm.sqrt.f64(double %2039)
  %2041 = tail call double @llvm.sqrt.f64(double %2040)
  %2042 = fmul double %2038, %2041
  %2043 = fcmp ule double %2023, 0.000000e+00
  %2044 = fcmp olt double %2042, 1.000000e+00
  %2045 = select i1 %2044, double %2042, double 1.000000e+00
  %2046 = select i1 %2043, double 1.000000e+00, double %2045
  %2047 = fmul double %2029, %2046
  %2048 = fcmp olt double %2047, 1.000000e+01
  %2049 = select i1 %2048, double %2047, double 1.000000e+01
  %2050 = fcmp ule double %2049, 1.000000e+00
  %2051 = fcmp uge double %2049, 1.200000e+00
  %2052 = or i1 %2050, %2051
  %2053 = select i1 %2052, i1 true, i1 %1472
  %2054 = load double, ptr %2021, align 8, !noalias !16
  %2055 = fcmp ogt double %2049, 2.000000e-01
  %2056 = select i1 %2055, double %2049, double 2.000000e-01
  %2057 = fmul double %644, %2056
  %2058 = select i1 %2053, double %2057, double %2054
  %2059 = icmp eq i64 %2016, 0
  %2060 = select i1 %2059, double %2035, double %2058
  %2061 = and i64 %1468, 4294967295
  %2062 = icmp eq i64 %2061, 0
  %2063 = select i1 %2062, double %1542, double %2060
  %2064 = xor i64 %2016, -1
  %2065 = and i64 %1468, %2064
  %2066 = load ptr, ptr %192, align 8, !noalias !16
  %2067 = getelementptr inbounds i8, ptr %2066, i64 32
  %2068 = load i64, ptr %2067, align 8, !noalias !16
  %2069 = or i64 %2068, %2065
  store i64 %2069, ptr %2067, align 8, !noalias !16
  %2070 = load ptr, ptr %192, align 8, !noalias !16
  %2071 = getelementptr inbounds i8, ptr %2070, i64 8
  %2072 = load i64, ptr %2071, align 8, !noalias !16
  %2073 = xor i64 %2065, -1
  %2074 = and i64 %2072, %2073
  %2075 = getelementptr inbounds i8, ptr %2070, i64 16
  %2076 = load i64, ptr %2075, align 8, !noalias !16
  %2077 = xor i64 %2076, -1
  %2078 = and i64 %2065, %2077
  %2079 = or disjoint i64 %2078, %2074
  store i64 %2079, ptr %2071, align 8, !noalias !16
  br label %2094

2080:                                             ; preds = %1549, %2080
  %2081 = phi i64 [ 0, %1549 ], [ %2092, %2080 ]
  %2082 = load ptr, ptr %262, align 8, !noalias !16
  %2083 = load ptr, ptr %191, align 8, !noalias !16
  %2084 = getelementptr inbounds double, ptr %2083, i64 %2081
  %2085 = load double, ptr %2084, align 8, !noalias !16
  %2086 = load ptr, ptr %237, align 8, !noalias !16
  %2087 = getelementptr i8, ptr %2086, i64 %1550
  %2088 = getelementptr double, ptr %2087, i64 %2081
  %2089 = load double, ptr %2088, align 8, !noalias !16
  %2090 = fadd double %2085, %2089
  %2091 = getelementptr inbounds double, ptr %2082, i64 %2081
  store double %2090, ptr %2091, align 8, !noalias !16
  %2092 = add nuw nsw i64 %2081, 1
  %2093 = icmp eq i64 %2092, %654
  br i1 %2093, label %1551, label %2080, !llvm.loop !53

2094:                                             ; preds = %2013, %1541, %870, %783
  %2095 = phi double [ %574, %783 ], [ %574, %870 ], [ %1463, %1541 ], [ %1463, %2013 ]
  %2096 = phi double [ %573, %783 ], [ %573, %870 ], [ %1464, %1541 ], [ %1464, %2013 ]
  %2097 = phi double [ %572, %783 ], [ %572, %870 ], [ %1465, %1541 ], [ %1465, %2013 ]
  %2098 = phi i64 [ %571, %783 ], [ %571, %870 ], [ %1466, %1541 ], [ %1466, %2013 ]
  %2099 = phi i64 [ %570, %783 ], [ %570, %870 ], [ %1467, %1541 ], [ %1467, %2013 ]
  %2100 = phi i64 [ %569, %783 ], [ %569, %870 ], [ %1468, %1541 ], [ %1468, %2013 ]
  %2101 = phi i1 [ false, %783 ], [ false, %870 ], [ %1472, %1541 ], [ %1472, %2013 ]
  %2102 = phi double [ 2.000000e+00, %783 ], [ %872, %870 ], [ %1543, %1541 ], [ %2017, %2013 ]
  %2103 = phi double [ 0.000000e+00, %783 ], [ 0.000000e+00, %870 ], [ 0.000000e+00, %1541 ], [ %2018, %2013 ]
  %2104 = phi double [ %568, %783 ], [ %871, %870 ], [ %1542, %1541 ], [ %2063, %2013 ]
  %2105 = phi double [ %766, %783 ], [ %795, %870 ], [ %1469, %1541 ], [ %2014, %2013 ]
  %2106 = phi i64 [ 0, %783 ], [ %809, %870 ], [ %809, %1541 ], [ %809, %2013 ]
  %2107 = phi i64 [ 1, %783 ], [ 0, %870 ], [ %1466, %1541 ], [ %2015, %2013 ]
  %2108 = phi i64 [ 0, %783 ], [ 0, %870 ], [ 0, %1541 ], [ %2016, %2013 ]
  %2109 = zext i1 %2101 to i64
  %2110 = fptosi double %2105 to i64
  %2111 = load i64, ptr %545, align 8
  %2112 = add nsw i64 %2111, %2110
  store i64 %2112, ptr %545, align 8
  %2113 = load i64, ptr %546, align 8
  %2114 = add nsw i64 %2113, %658
  store i64 %2114, ptr %546, align 8
  %2115 = load i64, ptr %547, align 8
  %2116 = add nsw i64 %2115, %2106
  store i64 %2116, ptr %547, align 8
  %2117 = icmp eq i64 %2107, 0
  br i1 %2117, label %2118, label %2746

2118:                                             ; preds = %2094
  %2119 = icmp eq i64 %2108, 0
  br i1 %2119, label %2120, label %2144

2120:                                             ; preds = %2118
  %2121 = load i64, ptr %532, align 8
  %2122 = add nsw i64 %2121, 1
  store i64 %2122, ptr %532, align 8
  %2123 = fptosi double %2102 to i64
  store i64 %2123, ptr %555, align 8
  %2124 = fcmp ult double %2103, 1.000000e+00
  %2125 = fcmp ueq double %2103, 0x7FF0000000000000
  %2126 = or i1 %2124, %2125
  br i1 %2126, label %2746, label %2127, !llvm.loop !54

2127:                                             ; preds = %2120
  %2128 = load i64, ptr %323, align 8
  %2129 = icmp eq i64 %2128, 0
  br i1 %2129, label %2746, label %2130, !llvm.loop !54

2130:                                             ; preds = %2127
  %2131 = tail call fastcc double @knot_after(ptr noundef nonnull %190, double noundef %567) #11
  %2132 = fmul double %644, 1.000000e-03
  %2133 = fsub double %643, %2132
  %2134 = tail call double @llvm.fabs.f64(double %643)
  %2135 = fmul double %2134, 0x3D10000000000000
  %2136 = fsub double %2133, %2135
  %2137 = fcmp ogt double %2136, %2131
  br i1 %2137, label %2138, label %2746, !llvm.loop !54

2138:                                             ; preds = %2130
  %2139 = tail call fastcc double @knot_after(ptr noundef nonnull %190, double noundef %2131) #11
  %2140 = fadd double %567, %2104
  %2141 = fcmp ugt double %2139, %2140
  br i1 %2141, label %2142, label %2746, !llvm.loop !54

2142:                                             ; preds = %2138
  %2143 = fsub double %2131, %567
  br label %2746, !llvm.loop !54

2144:                                             ; preds = %2118
  br i1 %365, label %2145, label %2173

2145:                                             ; preds = %2144
  %2146 = load ptr, ptr %281, align 8
  %2147 = load ptr, ptr %191, align 8
  %2148 = load ptr, ptr %198, align 8
  %2149 = getelementptr inbounds i8, ptr %2148, i64 56
  %2150 = load i64, ptr %2149, align 8
  %2151 = inttoptr i64 %2150 to ptr
  %2152 = tail call i64 %2151(ptr noundef %0, double noundef %643, ptr noundef %2146, ptr noundef %2147) #10
  %2153 = icmp eq i64 %2152, 0
  br i1 %2153, label %2173, label %2154

2154:                                             ; preds = %2145
  %2155 = load i64, ptr %532, align 8
  %2156 = add nsw i64 %2155, 1
  store i64 %2156, ptr %532, align 8
  store i64 6, ptr %548, align 8
  %2157 = fmul double %644, 2.500000e-01
  %2158 = load ptr, ptr %192, align 8
  %2159 = getelementptr inbounds i8, ptr %2158, i64 32
  %2160 = load i64, ptr %2159, align 8
  %2161 = or i64 %2160, 1
  store i64 %2161, ptr %2159, align 8
  %2162 = load ptr, ptr %192, align 8
  %2163 = getelementptr inbounds i8, ptr %2162, i64 8
  %2164 = load i64, ptr %2163, align 8
  %2165 = and i64 %2164, -2
  %2166 = getelementptr inbounds i8, ptr %2162, i64 16
  %2167 = load i64, ptr %2166, align 8
  %2168 = and i64 %2167, 1
  %2169 = or disjoint i64 %2168, %2165
  %2170 = xor i64 %2169, 1
  store i64 %2170, ptr %2163, align 8
  %2171 = load ptr, ptr %282, align 8
  %2172 = getelementptr inbounds i8, ptr %2171, i64 8
  store double 0.000000e+00, ptr %2172, align 8
  br label %2746, !llvm.loop !54

2173:                                             ; preds = %2145, %2144
  %2174 = load i64, ptr %531, align 8
  %2175 = add nsw i64 %2174, 1
  store i64 %2175, ptr %531, align 8
  store double %643, ptr %332, align 8
  store double %644, ptr %549, align 8
  %2176 = load ptr, ptr %190, align 8
  %2177 = getelementptr inbounds i8, ptr %2176, i64 8
  %2178 = load i64, ptr %2177, align 8
  %2179 = load i64, ptr %283, align 8
  %2180 = load ptr, ptr %284, align 8
  %2181 = load ptr, ptr %285, align 8
  %2182 = load ptr, ptr %286, align 8
  %2183 = load ptr, ptr %287, align 8
  br label %2199

2184:                                             ; preds = %2199
  %2185 = icmp sgt i64 %2178, 0
  br i1 %2185, label %2186, label %2259

2186:                                             ; preds = %2184
  %2187 = load double, ptr %13, align 16
  %2188 = load double, ptr %288, align 8
  %2189 = getelementptr double, ptr %2180, i64 %2178
  %2190 = load double, ptr %289, align 16
  %2191 = shl i64 %2178, 4
  %2192 = getelementptr i8, ptr %2180, i64 %2191
  %2193 = load double, ptr %14, align 16
  %2194 = load double, ptr %290, align 8
  %2195 = load double, ptr %291, align 16
  %2196 = getelementptr inbounds double, ptr %2181, i64 %2179
  %2197 = shl nsw i64 %2179, 4
  %2198 = getelementptr inbounds i8, ptr %2181, i64 %2197
  br label %2210

2199:                                             ; preds = %2173, %2199
  %2200 = phi i64 [ 0, %2173 ], [ %2208, %2199 ]
  %2201 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %2200
  %2202 = getelementptr inbounds i8, ptr %2201, i64 8
  %2203 = load double, ptr %2202, align 8
  %2204 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %2200
  store double %2203, ptr %2204, align 8
  %2205 = getelementptr inbounds i8, ptr %2201, i64 16
  %2206 = load double, ptr %2205, align 8
  %2207 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %2200
  store double %2206, ptr %2207, align 8
  %2208 = add nuw nsw i64 %2200, 1
  %2209 = icmp eq i64 %2208, 3
  br i1 %2209, label %2184, label %2199, !llvm.loop !55

2210:                                             ; preds = %2186, %2247
  %2211 = phi i64 [ 0, %2186 ], [ %2248, %2247 ]
  %2212 = getelementptr inbounds double, ptr %2180, i64 %2211
  %2213 = load double, ptr %2212, align 8
  %2214 = fmul double %2187, %2213
  %2215 = getelementptr double, ptr %2189, i64 %2211
  %2216 = load double, ptr %2215, align 8
  %2217 = fmul double %2188, %2216
  %2218 = fadd double %2214, %2217
  %2219 = getelementptr double, ptr %2192, i64 %2211
  %2220 = load double, ptr %2219, align 8
  %2221 = fmul double %2190, %2220
  %2222 = fadd double %2218, %2221
  %2223 = fmul double %2213, %2193
  %2224 = fmul double %2216, %2194
  %2225 = fadd double %2223, %2224
  %2226 = fmul double %2220, %2195
  %2227 = fadd double %2225, %2226
  %2228 = load ptr, ptr %292, align 8
  %2229 = getelementptr inbounds double, ptr %2228, i64 %2211
  %2230 = load double, ptr %2229, align 8
  %2231 = load ptr, ptr %191, align 8
  %2232 = getelementptr inbounds double, ptr %2231, i64 %2211
  %2233 = load double, ptr %2232, align 8
  %2234 = fsub double %2230, %2233
  %2235 = getelementptr inbounds double, ptr %2181, i64 %2211
  store double %2234, ptr %2235, align 8
  %2236 = fneg double %2222
  %2237 = fsub double %2236, %2227
  %2238 = getelementptr inbounds double, ptr %2196, i64 %2211
  store double %2237, ptr %2238, align 8
  %2239 = fneg double %2227
  %2240 = getelementptr inbounds double, ptr %2198, i64 %2211
  store double %2239, ptr %2240, align 8
  %2241 = load ptr, ptr %191, align 8
  %2242 = getelementptr inbounds double, ptr %2241, i64 %2211
  %2243 = load double, ptr %2242, align 8
  %2244 = getelementptr inbounds double, ptr %2182, i64 %2211
  store double %2243, ptr %2244, align 8
  %2245 = getelementptr double, ptr %2181, i64 %2211
  %2246 = getelementptr double, ptr %2182, i64 %2211
  br label %2250

2247:                                             ; preds = %2250
  %2248 = add nuw nsw i64 %2211, 1
  %2249 = icmp eq i64 %2248, %2178
  br i1 %2249, label %2259, label %2210, !llvm.loop !56

2250:                                             ; preds = %2210, %2250
  %2251 = phi i64 [ 0, %2210 ], [ %2252, %2250 ]
  %2252 = add nuw nsw i64 %2251, 1
  %2253 = mul nuw nsw i64 %2178, %2252
  %2254 = mul nsw i64 %2179, %2251
  %2255 = getelementptr double, ptr %2245, i64 %2254
  %2256 = load double, ptr %2255, align 8
  %2257 = getelementptr double, ptr %2246, i64 %2253
  store double %2256, ptr %2257, align 8
  %2258 = icmp eq i64 %2252, 3
  br i1 %2258, label %2247, label %2250, !llvm.loop !57

2259:                                             ; preds = %2247, %2184
  %2260 = fcmp olt double %2103, 1.000000e-10
  %2261 = select i1 %2260, double 1.000000e-10, double %2103
  %2262 = getelementptr inbounds i8, ptr %2183, i64 8
  store double %644, ptr %2262, align 8
  %2263 = getelementptr inbounds i8, ptr %2183, i64 16
  store double %644, ptr %2263, align 8
  %2264 = getelementptr inbounds i8, ptr %2183, i64 24
  store double %2261, ptr %2264, align 8
  %2265 = load ptr, ptr %192, align 8
  %2266 = getelementptr inbounds i8, ptr %2265, i64 8
  %2267 = load i64, ptr %2266, align 8
  %2268 = and i64 %2267, -2
  %2269 = or disjoint i64 %2268, %2109
  store i64 %2269, ptr %2266, align 8
  %2270 = load ptr, ptr %192, align 8
  %2271 = getelementptr inbounds i8, ptr %2270, i64 16
  %2272 = load i64, ptr %2271, align 8
  %2273 = and i64 %2272, -2
  store i64 %2273, ptr %2271, align 8
  %2274 = load ptr, ptr %192, align 8
  %2275 = getelementptr inbounds i8, ptr %2274, i64 32
  %2276 = load i64, ptr %2275, align 8
  %2277 = and i64 %2276, -2
  store i64 %2277, ptr %2275, align 8
  %2278 = load ptr, ptr %0, align 8
  %2279 = getelementptr inbounds i8, ptr %2278, i64 24
  %2280 = load i64, ptr %2279, align 8
  %2281 = load ptr, ptr %210, align 8
  %2282 = getelementptr inbounds i8, ptr %2281, i64 8
  %2283 = load i64, ptr %2282, align 8
  %2284 = icmp eq i64 %2283, 0
  br i1 %2284, label %2331, label %2285

2285:                                             ; preds = %2259
  %2286 = load i64, ptr %2281, align 8
  %2287 = load ptr, ptr %190, align 8
  %2288 = getelementptr inbounds i8, ptr %2287, i64 8
  %2289 = load i64, ptr %2288, align 8
  %2290 = load ptr, ptr %293, align 8
  %2291 = load i64, ptr %294, align 8
  %2292 = mul nsw i64 %2291, %2286
  %2293 = getelementptr inbounds double, ptr %2290, i64 %2292
  %2294 = getelementptr inbounds double, ptr %2293, i64 %2291
  store double %567, ptr %2293, align 8
  %2295 = getelementptr inbounds i8, ptr %2293, i64 8
  store double %644, ptr %2295, align 8
  store double %643, ptr %2294, align 8
  %2296 = getelementptr inbounds i8, ptr %2294, i64 8
  store double 0.000000e+00, ptr %2296, align 8
  %2297 = icmp sgt i64 %2289, 0
  br i1 %2297, label %2298, label %2301

2298:                                             ; preds = %2285
  %2299 = getelementptr i8, ptr %2293, i64 16
  %2300 = icmp sgt i64 %2280, 0
  br label %2304

2301:                                             ; preds = %2316, %2285
  %2302 = add nsw i64 %2286, 1
  %2303 = load ptr, ptr %210, align 8
  store i64 %2302, ptr %2303, align 8
  br label %2331

2304:                                             ; preds = %2298, %2316
  %2305 = phi i64 [ 0, %2298 ], [ %2317, %2316 ]
  %2306 = load ptr, ptr %191, align 8
  %2307 = getelementptr inbounds double, ptr %2306, i64 %2305
  %2308 = load double, ptr %2307, align 8
  %2309 = add nuw nsw i64 %2305, 2
  %2310 = getelementptr inbounds double, ptr %2293, i64 %2309
  store double %2308, ptr %2310, align 8
  %2311 = load ptr, ptr %295, align 8
  %2312 = getelementptr inbounds double, ptr %2311, i64 %2305
  %2313 = load double, ptr %2312, align 8
  %2314 = getelementptr inbounds double, ptr %2294, i64 %2309
  store double %2313, ptr %2314, align 8
  %2315 = getelementptr double, ptr %2299, i64 %2305
  br i1 %2300, label %2319, label %2316

2316:                                             ; preds = %2319, %2304
  %2317 = add nuw nsw i64 %2305, 1
  %2318 = icmp eq i64 %2317, %2289
  br i1 %2318, label %2301, label %2304, !llvm.loop !58

2319:                                             ; preds = %2304, %2319
  %2320 = phi i64 [ %2327, %2319 ], [ 0, %2304 ]
  %2321 = load ptr, ptr %296, align 8
  %2322 = load i64, ptr %297, align 8
  %2323 = mul nsw i64 %2322, %2320
  %2324 = getelementptr double, ptr %2321, i64 %2323
  %2325 = getelementptr double, ptr %2324, i64 %2305
  %2326 = load double, ptr %2325, align 8
  %2327 = add nuw nsw i64 %2320, 1
  %2328 = mul nuw nsw i64 %2327, %2289
  %2329 = getelementptr double, ptr %2315, i64 %2328
  store double %2326, ptr %2329, align 8
  %2330 = icmp eq i64 %2327, %2280
  br i1 %2330, label %2316, label %2319, !llvm.loop !59

2331:                                             ; preds = %2259, %2301
  br i1 %369, label %2332, label %2440

2332:                                             ; preds = %2331
  %2333 = load ptr, ptr %199, align 8
  %2334 = load ptr, ptr %190, align 8
  %2335 = getelementptr inbounds i8, ptr %2334, i64 8
  %2336 = load i64, ptr %2335, align 8
  %2337 = load ptr, ptr %298, align 8
  %2338 = getelementptr inbounds i8, ptr %2333, i64 32
  %2339 = load i64, ptr %2338, align 8
  %2340 = getelementptr inbounds double, ptr %2337, i64 %2339
  %2341 = load ptr, ptr %299, align 8
  %2342 = getelementptr inbounds i8, ptr %2333, i64 24
  %2343 = load i64, ptr %2342, align 8
  %2344 = icmp eq i64 %2343, 0
  br i1 %2344, label %2437, label %2345

2345:                                             ; preds = %2332
  %2346 = getelementptr inbounds i8, ptr %2333, i64 40
  %2347 = load i64, ptr %2346, align 8
  %2348 = icmp sgt i64 %2347, 0
  br i1 %2348, label %2349, label %2353

2349:                                             ; preds = %2345
  %2350 = getelementptr double, ptr %2341, i64 %2336
  %2351 = shl i64 %2336, 4
  %2352 = getelementptr i8, ptr %2341, i64 %2351
  br label %2407

2353:                                             ; preds = %2407, %2345
  %2354 = load ptr, ptr %301, align 8
  %2355 = load ptr, ptr %199, align 8
  %2356 = getelementptr inbounds i8, ptr %2355, i64 8
  %2357 = load i64, ptr %2356, align 8
  %2358 = load ptr, ptr %302, align 8
  %2359 = load ptr, ptr %298, align 8
  %2360 = getelementptr inbounds i8, ptr %2355, i64 32
  %2361 = load i64, ptr %2360, align 8
  %2362 = getelementptr inbounds i8, ptr %2355, i64 40
  %2363 = load i64, ptr %2362, align 8
  %2364 = getelementptr double, ptr %2359, i64 %2361
  %2365 = getelementptr double, ptr %2364, i64 %2363
  store double %644, ptr %2365, align 8
  %2366 = load ptr, ptr %301, align 8
  store double %567, ptr %2366, align 8
  %2367 = load ptr, ptr %199, align 8
  %2368 = getelementptr inbounds i8, ptr %2367, i64 24
  %2369 = load i64, ptr %2368, align 8
  %2370 = load ptr, ptr %191, align 8
  %2371 = load ptr, ptr %298, align 8
  %2372 = load ptr, ptr %303, align 8
  %2373 = inttoptr i64 %2369 to ptr
  %2374 = load ptr, ptr %2373, align 8
  %2375 = tail call i32 %2374(ptr noundef %2354, ptr noundef %2370, ptr noundef %2371, ptr noundef %2372, ptr noundef %2358) #10
  %2376 = icmp eq i32 %2375, 0
  br i1 %2376, label %2377, label %2437

2377:                                             ; preds = %2353
  %2378 = icmp slt i64 %2357, 1
  br i1 %2378, label %2404, label %2379

2379:                                             ; preds = %2377
  %2380 = load ptr, ptr %304, align 8
  %2381 = getelementptr double, ptr %2358, i64 %2357
  br label %2382

2382:                                             ; preds = %2379, %2400
  %2383 = phi i1 [ %2378, %2379 ], [ %2402, %2400 ]
  %2384 = phi i64 [ 0, %2379 ], [ %2401, %2400 ]
  %2385 = getelementptr inbounds i64, ptr %2380, i64 %2384
  %2386 = load i64, ptr %2385, align 8
  %2387 = and i64 %2386, 2
  %2388 = icmp eq i64 %2387, 0
  br i1 %2388, label %2389, label %2400

2389:                                             ; preds = %2382
  %2390 = getelementptr inbounds double, ptr %2358, i64 %2384
  %2391 = load double, ptr %2390, align 8
  %2392 = load ptr, ptr %305, align 8
  %2393 = getelementptr inbounds i64, ptr %2392, i64 %2384
  %2394 = load i64, ptr %2393, align 8
  %2395 = sitofp i64 %2394 to double
  %2396 = fmul double %2391, %2395
  %2397 = getelementptr double, ptr %2381, i64 %2384
  %2398 = load double, ptr %2397, align 8
  %2399 = fcmp ogt double %2396, %2398
  br i1 %2399, label %2400, label %2404

2400:                                             ; preds = %2389, %2382
  %2401 = add nuw nsw i64 %2384, 1
  %2402 = icmp sge i64 %2401, %2357
  %2403 = icmp eq i64 %2401, %2357
  br i1 %2403, label %2404, label %2382, !llvm.loop !60

2404:                                             ; preds = %2400, %2389, %2377
  %2405 = phi i1 [ %2378, %2377 ], [ %2402, %2400 ], [ %2383, %2389 ]
  %2406 = zext i1 %2405 to i32
  br label %2437

2407:                                             ; preds = %2349, %2407
  %2408 = phi i64 [ 0, %2349 ], [ %2434, %2407 ]
  %2409 = load ptr, ptr %300, align 8
  %2410 = getelementptr inbounds double, ptr %2409, i64 %2408
  %2411 = load double, ptr %2410, align 8
  %2412 = load ptr, ptr %191, align 8
  %2413 = getelementptr inbounds double, ptr %2412, i64 %2408
  %2414 = load double, ptr %2413, align 8
  %2415 = fsub double %2411, %2414
  %2416 = tail call double @llvm.fabs.f64(double %2415)
  %2417 = getelementptr inbounds double, ptr %2341, i64 %2408
  %2418 = load double, ptr %2417, align 8
  %2419 = tail call double @llvm.fabs.f64(double %2418)
  %2420 = getelementptr double, ptr %2350, i64 %2408
  %2421 = load double, ptr %2420, align 8
  %2422 = tail call double @llvm.fabs.f64(double %2421)
  %2423 = fcmp ogt double %2419, %2422
  %2424 = select i1 %2423, double %2419, double %2422
  %2425 = getelementptr double, ptr %2352, i64 %2408
  %2426 = load double, ptr %2425, align 8
  %2427 = tail call double @llvm.fabs.f64(double %2426)
  %2428 = fcmp ogt double %2424, %2427
  %2429 = select i1 %2428, double %2424, double %2427
  %2430 = fcmp ogt double %2429, %2416
  %2431 = select i1 %2430, double %2429, double %2416
  %2432 = fmul double %2431, 8.000000e+00
  %2433 = getelementptr inbounds double, ptr %2340, i64 %2408
  store double %2432, ptr %2433, align 8
  %2434 = add nuw nsw i64 %2408, 1
  %2435 = load i64, ptr %2346, align 8
  %2436 = icmp slt i64 %2434, %2435
  br i1 %2436, label %2407, label %2353, !llvm.loop !61

2437:                                             ; preds = %2404, %2353, %2332
  %2438 = phi i32 [ 0, %2332 ], [ 0, %2353 ], [ %2406, %2404 ]
  %2439 = icmp eq i32 %2438, 0
  br label %2440

2440:                                             ; preds = %2437, %2331
  %2441 = phi i1 [ false, %2331 ], [ %2439, %2437 ]
  br i1 %2441, label %2447, label %2442

2442:                                             ; preds = %2440
  %2443 = load i64, ptr %550, align 8
  %2444 = getelementptr inbounds double, ptr %341, i64 %2443
  %2445 = load double, ptr %2444, align 8
  %2446 = fcmp ugt double %2445, %643
  br i1 %2446, label %2672, label %2447

2447:                                             ; preds = %2442, %2440
  %2448 = load ptr, ptr %193, align 8
  br i1 %2441, label %2449, label %2460

2449:                                             ; preds = %2447
  %2450 = load ptr, ptr %199, align 8
  %2451 = getelementptr inbounds i8, ptr %2450, i64 16
  %2452 = load i64, ptr %2451, align 8
  %2453 = inttoptr i64 %2452 to ptr
  %2454 = tail call i64 %2453(ptr noundef %0, double noundef %567, double noundef %644) #10
  %2455 = icmp eq i64 %2454, -6
  br i1 %2455, label %2456, label %2457

2456:                                             ; preds = %2449
  store double %567, ptr %2448, align 8
  br label %2635

2457:                                             ; preds = %2449
  %2458 = getelementptr inbounds i8, ptr %2448, i64 48
  %2459 = load double, ptr %2458, align 8
  br label %2460

2460:                                             ; preds = %2457, %2447
  %2461 = phi double [ %2459, %2457 ], [ 1.000000e+00, %2447 ]
  %2462 = phi i64 [ %2454, %2457 ], [ 0, %2447 ]
  %2463 = fcmp oeq double %2461, 1.000000e+00
  br i1 %2463, label %2464, label %2466

2464:                                             ; preds = %2460
  %2465 = load double, ptr %2448, align 8
  br label %2469

2466:                                             ; preds = %2460
  %2467 = fmul double %644, %2461
  %2468 = fadd double %567, %2467
  br label %2469

2469:                                             ; preds = %2466, %2464
  %2470 = phi double [ %2465, %2464 ], [ %2468, %2466 ]
  %2471 = icmp eq i64 %2462, -4
  %2472 = select i1 %2471, i64 -4, i64 0
  br i1 %2471, label %2530, label %2473

2473:                                             ; preds = %2469
  %2474 = fcmp olt double %2461, 1.000000e+00
  %2475 = load ptr, ptr %190, align 8
  %2476 = getelementptr inbounds i8, ptr %2475, i64 8
  %2477 = load i64, ptr %2476, align 8
  %2478 = load i64, ptr %196, align 8
  %2479 = load ptr, ptr %195, align 8
  %2480 = load ptr, ptr %194, align 8
  %2481 = getelementptr inbounds i8, ptr %2480, i64 48
  %2482 = load i64, ptr %2481, align 8
  %2483 = icmp slt i64 %2482, %2478
  br i1 %2483, label %2484, label %2526

2484:                                             ; preds = %2473, %2522
  %2485 = phi i64 [ %2523, %2522 ], [ undef, %2473 ]
  %2486 = phi i64 [ %2524, %2522 ], [ %2482, %2473 ]
  %2487 = getelementptr inbounds double, ptr %2479, i64 %2486
  %2488 = load double, ptr %2487, align 8
  %2489 = fcmp olt double %2488, %2470
  %2490 = fcmp oeq double %2488, %2470
  %2491 = and i1 %2474, %2490
  %2492 = or i1 %2489, %2491
  br i1 %2492, label %2493, label %2526

2493:                                             ; preds = %2484
  %2494 = fsub double %2488, %567
  %2495 = fdiv double %2494, %644
  %2496 = mul nsw i64 %2486, %2477
  %2497 = getelementptr inbounds double, ptr %1, i64 %2496
  %2498 = load ptr, ptr %306, align 8
  %2499 = insertelement <8 x double> poison, double %2495, i64 0
  %2500 = shufflevector <8 x double> %2499, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2500, ptr %2498, align 8
  %2501 = load ptr, ptr %191, align 8
  %2502 = load ptr, ptr %285, align 8
  %2503 = load i64, ptr %283, align 8
  %2504 = load ptr, ptr %0, align 8
  %2505 = getelementptr inbounds i8, ptr %2504, i64 24
  %2506 = load i64, ptr %2505, align 8
  %2507 = load ptr, ptr %306, align 8
  %2508 = load ptr, ptr %190, align 8
  %2509 = getelementptr inbounds i8, ptr %2508, i64 16
  %2510 = load i64, ptr %2509, align 8
  tail call fastcc void @nested(ptr noundef %2497, ptr noundef %2501, ptr noundef %2502, i64 noundef %2503, i64 noundef %2506, ptr noundef %2507, i64 noundef %2510) #11
  %2511 = load ptr, ptr %198, align 8
  %2512 = load i64, ptr %2511, align 8
  %2513 = icmp eq i64 %2512, 1
  br i1 %2513, label %2514, label %2522

2514:                                             ; preds = %2493
  %2515 = load double, ptr %2487, align 8
  %2516 = getelementptr inbounds i8, ptr %2511, i64 56
  %2517 = load i64, ptr %2516, align 8
  %2518 = inttoptr i64 %2517 to ptr
  %2519 = tail call i64 %2518(ptr noundef %0, double noundef %2515, ptr noundef %2497, ptr noundef null) #10
  %2520 = icmp eq i64 %2519, 0
  %2521 = select i1 %2520, i64 %2485, i64 %2519
  br i1 %2520, label %2522, label %2530

2522:                                             ; preds = %2514, %2493
  %2523 = phi i64 [ %2521, %2514 ], [ %2485, %2493 ]
  %2524 = add i64 %2486, 1
  %2525 = icmp eq i64 %2524, %2478
  br i1 %2525, label %2526, label %2484, !llvm.loop !62

2526:                                             ; preds = %2522, %2484, %2473
  %2527 = phi i64 [ %2482, %2473 ], [ %2478, %2522 ], [ %2486, %2484 ]
  %2528 = load ptr, ptr %194, align 8
  %2529 = getelementptr inbounds i8, ptr %2528, i64 48
  store i64 %2527, ptr %2529, align 8
  br label %2530

2530:                                             ; preds = %2514, %2526, %2469
  %2531 = phi i64 [ %2472, %2469 ], [ 0, %2526 ], [ %2521, %2514 ]
  %2532 = icmp eq i64 %2531, 0
  %2533 = icmp ne i64 %2462, 0
  %2534 = fcmp olt double %2461, 1.000000e+00
  %2535 = and i1 %2534, %2532
  %2536 = and i1 %2533, %2535
  br i1 %2536, label %2537, label %2574

2537:                                             ; preds = %2530
  %2538 = load ptr, ptr %307, align 8
  %2539 = load ptr, ptr %308, align 8
  %2540 = insertelement <8 x double> poison, double %2461, i64 0
  %2541 = shufflevector <8 x double> %2540, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %2541, ptr %2539, align 8
  %2542 = load ptr, ptr %191, align 8
  %2543 = load ptr, ptr %285, align 8
  %2544 = load i64, ptr %283, align 8
  %2545 = load ptr, ptr %0, align 8
  %2546 = getelementptr inbounds i8, ptr %2545, i64 24
  %2547 = load i64, ptr %2546, align 8
  %2548 = load ptr, ptr %308, align 8
  %2549 = load ptr, ptr %190, align 8
  %2550 = getelementptr inbounds i8, ptr %2549, i64 16
  %2551 = load i64, ptr %2550, align 8
  tail call fastcc void @nested(ptr noundef %2538, ptr noundef %2542, ptr noundef %2543, i64 noundef %2544, i64 noundef %2547, ptr noundef %2548, i64 noundef %2551) #11
  %2552 = load i64, ptr %309, align 8
  %2553 = icmp sgt i64 %2552, 0
  br i1 %2553, label %2558, label %2554

2554:                                             ; preds = %2558, %2537
  %2555 = load ptr, ptr %198, align 8
  %2556 = load i64, ptr %2555, align 8
  %2557 = icmp eq i64 %2556, 1
  br i1 %2557, label %2568, label %2574

2558:                                             ; preds = %2537, %2558
  %2559 = phi i64 [ %2565, %2558 ], [ 0, %2537 ]
  %2560 = load ptr, ptr %307, align 8
  %2561 = getelementptr inbounds double, ptr %2560, i64 %2559
  %2562 = load double, ptr %2561, align 8
  %2563 = load ptr, ptr %310, align 8
  %2564 = getelementptr inbounds double, ptr %2563, i64 %2559
  store double %2562, ptr %2564, align 8
  %2565 = add nuw nsw i64 %2559, 1
  %2566 = load i64, ptr %309, align 8
  %2567 = icmp slt i64 %2565, %2566
  br i1 %2567, label %2558, label %2554, !llvm.loop !63

2568:                                             ; preds = %2554
  %2569 = load ptr, ptr %311, align 8
  %2570 = getelementptr inbounds i8, ptr %2555, i64 56
  %2571 = load i64, ptr %2570, align 8
  %2572 = inttoptr i64 %2571 to ptr
  %2573 = tail call i64 %2572(ptr noundef %0, double noundef %2470, ptr noundef %2569, ptr noundef null) #10
  br label %2574

2574:                                             ; preds = %2568, %2554, %2530
  %2575 = phi i64 [ %2573, %2568 ], [ 0, %2554 ], [ %2531, %2530 ]
  %2576 = icmp eq i64 %2575, 0
  br i1 %2576, label %2579, label %2577

2577:                                             ; preds = %2574
  store double %567, ptr %2448, align 8
  %2578 = getelementptr inbounds i8, ptr %2448, i64 8
  store double %644, ptr %2578, align 8
  br label %2635

2579:                                             ; preds = %2574
  br i1 %2463, label %2580, label %2618

2580:                                             ; preds = %2579
  %2581 = load ptr, ptr %312, align 8
  %2582 = load ptr, ptr %190, align 8
  %2583 = getelementptr inbounds i8, ptr %2582, i64 8
  %2584 = load i64, ptr %2583, align 8
  %2585 = load i64, ptr %196, align 8
  %2586 = load ptr, ptr %195, align 8
  %2587 = load ptr, ptr %194, align 8
  %2588 = getelementptr inbounds i8, ptr %2587, i64 48
  %2589 = load i64, ptr %2588, align 8
  %2590 = icmp slt i64 %2589, %2585
  br i1 %2590, label %2591, label %2614

2591:                                             ; preds = %2580
  %2592 = icmp sgt i64 %2584, 0
  br label %2593

2593:                                             ; preds = %2591, %2604
  %2594 = phi i64 [ %2589, %2591 ], [ %2605, %2604 ]
  %2595 = getelementptr inbounds double, ptr %2586, i64 %2594
  %2596 = load double, ptr %2595, align 8
  %2597 = load ptr, ptr %193, align 8
  %2598 = load double, ptr %2597, align 8
  %2599 = fcmp ugt double %2596, %2598
  br i1 %2599, label %2614, label %2600

2600:                                             ; preds = %2593
  br i1 %2592, label %2601, label %2604

2601:                                             ; preds = %2600
  %2602 = mul nsw i64 %2594, %2584
  %2603 = getelementptr double, ptr %1, i64 %2602
  br label %2607

2604:                                             ; preds = %2607, %2600
  %2605 = add i64 %2594, 1
  %2606 = icmp eq i64 %2605, %2585
  br i1 %2606, label %2614, label %2593, !llvm.loop !14

2607:                                             ; preds = %2601, %2607
  %2608 = phi i64 [ 0, %2601 ], [ %2612, %2607 ]
  %2609 = getelementptr inbounds double, ptr %2581, i64 %2608
  %2610 = load double, ptr %2609, align 8
  %2611 = getelementptr double, ptr %2603, i64 %2608
  store double %2610, ptr %2611, align 8
  %2612 = add nuw nsw i64 %2608, 1
  %2613 = icmp eq i64 %2612, %2584
  br i1 %2613, label %2604, label %2607, !llvm.loop !15

2614:                                             ; preds = %2604, %2593, %2580
  %2615 = phi i64 [ %2589, %2580 ], [ %2585, %2604 ], [ %2594, %2593 ]
  %2616 = load ptr, ptr %194, align 8
  %2617 = getelementptr inbounds i8, ptr %2616, i64 48
  store i64 %2615, ptr %2617, align 8
  br label %2618

2618:                                             ; preds = %2614, %2579
  br i1 %2533, label %2619, label %2635

2619:                                             ; preds = %2618
  %2620 = load i64, ptr %313, align 8
  %2621 = icmp sgt i64 %2620, 0
  br i1 %2621, label %2625, label %2622

2622:                                             ; preds = %2625, %2619
  store double %2470, ptr %2448, align 8
  %2623 = getelementptr inbounds i8, ptr %2448, i64 8
  store double 0.000000e+00, ptr %2623, align 8
  %2624 = load ptr, ptr %194, align 8
  store i64 0, ptr %2624, align 8
  br label %2635

2625:                                             ; preds = %2619, %2625
  %2626 = phi i64 [ %2632, %2625 ], [ 0, %2619 ]
  %2627 = load ptr, ptr %314, align 8
  %2628 = getelementptr inbounds double, ptr %2627, i64 %2626
  %2629 = load double, ptr %2628, align 8
  %2630 = load ptr, ptr %191, align 8
  %2631 = getelementptr inbounds double, ptr %2630, i64 %2626
  store double %2629, ptr %2631, align 8
  %2632 = add nuw nsw i64 %2626, 1
  %2633 = load i64, ptr %313, align 8
  %2634 = icmp slt i64 %2632, %2633
  br i1 %2634, label %2625, label %2622, !llvm.loop !64

2635:                                             ; preds = %2456, %2577, %2618, %2622
  %2636 = phi i64 [ -6, %2456 ], [ %2575, %2577 ], [ %2462, %2622 ], [ %2462, %2618 ]
  %2637 = icmp eq i64 %2636, -6
  br i1 %2637, label %2641, label %2638

2638:                                             ; preds = %2635
  %2639 = icmp ne i64 %2636, 6
  %2640 = select i1 %2639, i1 true, i1 %369
  br i1 %2640, label %2666, label %2641

2641:                                             ; preds = %2638, %2635
  %2642 = phi i64 [ %2636, %2638 ], [ 2, %2635 ]
  %2643 = load i64, ptr %531, align 8
  %2644 = add nsw i64 %2643, -1
  store i64 %2644, ptr %531, align 8
  %2645 = load ptr, ptr %210, align 8
  %2646 = load i64, ptr %2645, align 8
  %2647 = add nsw i64 %2646, -1
  store i64 %2647, ptr %2645, align 8
  %2648 = load ptr, ptr %192, align 8
  %2649 = getelementptr inbounds i8, ptr %2648, i64 32
  %2650 = load i64, ptr %2649, align 8
  %2651 = or i64 %2650, 1
  store i64 %2651, ptr %2649, align 8
  %2652 = load ptr, ptr %192, align 8
  %2653 = getelementptr inbounds i8, ptr %2652, i64 8
  %2654 = load i64, ptr %2653, align 8
  %2655 = and i64 %2654, -2
  %2656 = getelementptr inbounds i8, ptr %2652, i64 16
  %2657 = load i64, ptr %2656, align 8
  %2658 = and i64 %2657, 1
  %2659 = or disjoint i64 %2658, %2655
  %2660 = xor i64 %2659, 1
  store i64 %2660, ptr %2653, align 8
  %2661 = load ptr, ptr %287, align 8
  %2662 = getelementptr inbounds i8, ptr %2661, i64 8
  store double 0.000000e+00, ptr %2662, align 8
  %2663 = load i64, ptr %532, align 8
  %2664 = add nsw i64 %2663, 1
  store i64 %2664, ptr %532, align 8
  store i64 %2642, ptr %554, align 8
  %2665 = fmul double %644, 2.500000e-01
  br label %2746, !llvm.loop !54

2666:                                             ; preds = %2638
  %2667 = icmp eq i64 %2636, 0
  br i1 %2667, label %2672, label %2668

2668:                                             ; preds = %2666
  %2669 = load ptr, ptr %210, align 8
  %2670 = load i64, ptr %2669, align 8
  %2671 = add nsw i64 %2670, 1
  store i64 %2671, ptr %2669, align 8
  br label %2746

2672:                                             ; preds = %2666, %2442
  %2673 = icmp eq i64 %661, 0
  br i1 %2673, label %2693, label %2674

2674:                                             ; preds = %2672
  %2675 = load i64, ptr %315, align 8
  %2676 = icmp eq i64 %2675, 0
  br i1 %2676, label %2693, label %2677

2677:                                             ; preds = %2674
  %2678 = tail call fastcc double @knot_after(ptr noundef nonnull %190, double noundef %567) #11
  %2679 = fmul double %644, 1.000000e-03
  %2680 = fsub double %643, %2679
  %2681 = tail call double @llvm.fabs.f64(double %643)
  %2682 = fmul double %2681, 0x3D10000000000000
  %2683 = fsub double %2680, %2682
  %2684 = fcmp ogt double %2683, %2678
  %2685 = fadd double %643, %2682
  %2686 = fcmp ogt double %2678, %2685
  %2687 = or i1 %2684, %2686
  br i1 %2687, label %2693, label %2688

2688:                                             ; preds = %2677
  %2689 = tail call fastcc double @knot_after(ptr noundef nonnull %190, double noundef %643) #11
  %2690 = fsub double %2689, %643
  %2691 = fcmp olt double %2690, %2104
  %2692 = select i1 %2691, double %2690, double %2104
  br label %2693

2693:                                             ; preds = %2688, %2677, %2674, %2672
  %2694 = phi double [ %2104, %2672 ], [ %2104, %2674 ], [ %2692, %2688 ], [ %2104, %2677 ]
  br i1 %551, label %2725, label %2695

2695:                                             ; preds = %2725, %2693
  %2696 = load i64, ptr %211, align 8
  %2697 = icmp sgt i64 %2696, 0
  br i1 %2697, label %2698, label %2700

2698:                                             ; preds = %2695
  %2699 = load ptr, ptr %317, align 8
  store double 0x7FF0000000000000, ptr %2699, align 8
  br label %2700

2700:                                             ; preds = %2695, %2698
  %2701 = load i64, ptr %545, align 8
  %2702 = add nsw i64 %2701, 1
  store i64 %2702, ptr %545, align 8
  %2703 = load ptr, ptr %191, align 8
  %2704 = load ptr, ptr %318, align 8
  %2705 = load ptr, ptr %319, align 8
  store double %643, ptr %2705, align 8
  %2706 = load ptr, ptr %190, align 8
  %2707 = getelementptr inbounds i8, ptr %2706, i64 40
  %2708 = load i64, ptr %2707, align 8
  %2709 = icmp eq i64 %2708, 0
  br i1 %2709, label %2711, label %2710

2710:                                             ; preds = %2700
  tail call fastcc void @settle(ptr noundef nonnull %190) #11
  br label %2711

2711:                                             ; preds = %2710, %2700
  %2712 = load i64, ptr %320, align 8
  %2713 = icmp sgt i64 %2712, 0
  br i1 %2713, label %2714, label %2715

2714:                                             ; preds = %2711
  tail call fastcc void @sample(ptr noundef nonnull %190) #11
  br label %2715

2715:                                             ; preds = %2711, %2714
  %2716 = load ptr, ptr %190, align 8
  %2717 = load i64, ptr %2716, align 8
  %2718 = load ptr, ptr %319, align 8
  %2719 = load ptr, ptr %321, align 8
  %2720 = load ptr, ptr %322, align 8
  %2721 = inttoptr i64 %2717 to ptr
  %2722 = load ptr, ptr %2721, align 8
  %2723 = tail call i32 %2722(ptr noundef %2718, ptr noundef %2703, ptr noundef %2719, ptr noundef %2720, ptr noundef %2704) #10
  %2724 = icmp eq i32 %2723, 0
  br i1 %2724, label %2737, label %2734

2725:                                             ; preds = %2693, %2725
  %2726 = phi i64 [ %2732, %2725 ], [ 0, %2693 ]
  %2727 = load ptr, ptr %316, align 8
  %2728 = getelementptr inbounds double, ptr %2727, i64 %2726
  %2729 = load double, ptr %2728, align 8
  %2730 = load ptr, ptr %191, align 8
  %2731 = getelementptr inbounds double, ptr %2730, i64 %2726
  store double %2729, ptr %2731, align 8
  %2732 = add nuw nsw i64 %2726, 1
  %2733 = icmp eq i64 %2732, %340
  br i1 %2733, label %2695, label %2725, !llvm.loop !65

2734:                                             ; preds = %2715
  store i64 3, ptr %552, align 8
  store double %644, ptr %371, align 8
  %2735 = icmp slt i32 %2723, 0
  %2736 = select i1 %2735, i64 -4, i64 2
  br label %2746

2737:                                             ; preds = %2715
  %2738 = fcmp oeq double %643, %633
  %2739 = fcmp ogt double %568, %2694
  %2740 = select i1 %2738, i1 %2739, i1 false
  %2741 = select i1 %2740, double %568, double %2694
  %2742 = load i64, ptr %553, align 8
  %2743 = load i64, ptr %196, align 8
  %2744 = icmp eq i64 %2742, %2743
  br i1 %2744, label %2745, label %2746

2745:                                             ; preds = %2737
  store double %2741, ptr %371, align 8
  br label %2746

2746:                                             ; preds = %2094, %2120, %2154, %2641, %2668, %2734, %2737, %2745, %2127, %2130, %2138, %2142, %650
  %2747 = phi double [ %574, %650 ], [ %2095, %2142 ], [ %2095, %2138 ], [ %2095, %2130 ], [ %2095, %2127 ], [ %2095, %2745 ], [ %2095, %2737 ], [ %2095, %2734 ], [ %2095, %2668 ], [ %2095, %2641 ], [ %2095, %2154 ], [ %2095, %2120 ], [ %2095, %2094 ]
  %2748 = phi double [ %573, %650 ], [ %2096, %2142 ], [ %2096, %2138 ], [ %2096, %2130 ], [ %2096, %2127 ], [ %2096, %2745 ], [ %2096, %2737 ], [ %2096, %2734 ], [ %2096, %2668 ], [ %2096, %2641 ], [ %2096, %2154 ], [ %2096, %2120 ], [ %2096, %2094 ]
  %2749 = phi double [ %572, %650 ], [ %2097, %2142 ], [ %2097, %2138 ], [ %2097, %2130 ], [ %2097, %2127 ], [ %2097, %2745 ], [ %2097, %2737 ], [ %2097, %2734 ], [ %2097, %2668 ], [ %2097, %2641 ], [ %2097, %2154 ], [ %2097, %2120 ], [ %2097, %2094 ]
  %2750 = phi i64 [ %571, %650 ], [ %2098, %2142 ], [ %2098, %2138 ], [ %2098, %2130 ], [ %2098, %2127 ], [ %2098, %2745 ], [ %2098, %2737 ], [ %2098, %2734 ], [ %2098, %2668 ], [ %2098, %2641 ], [ %2098, %2154 ], [ %2098, %2120 ], [ %2098, %2094 ]
  %2751 = phi i64 [ %570, %650 ], [ %2099, %2142 ], [ %2099, %2138 ], [ %2099, %2130 ], [ %2099, %2127 ], [ %2099, %2745 ], [ %2099, %2737 ], [ %2099, %2734 ], [ %2099, %2668 ], [ %2099, %2641 ], [ %2099, %2154 ], [ %2099, %2120 ], [ %2099, %2094 ]
  %2752 = phi i64 [ %569, %650 ], [ %2100, %2142 ], [ %2100, %2138 ], [ %2100, %2130 ], [ %2100, %2127 ], [ %2100, %2745 ], [ %2100, %2737 ], [ %2100, %2734 ], [ %2100, %2668 ], [ %2100, %2641 ], [ %2100, %2154 ], [ %2100, %2120 ], [ %2100, %2094 ]
  %2753 = phi double [ %568, %650 ], [ %2143, %2142 ], [ %2104, %2138 ], [ %2104, %2130 ], [ %2104, %2127 ], [ %2741, %2745 ], [ %2741, %2737 ], [ %2694, %2734 ], [ %2104, %2668 ], [ %2665, %2641 ], [ %2157, %2154 ], [ %2104, %2120 ], [ %568, %2094 ]
  %2754 = phi double [ %567, %650 ], [ %567, %2142 ], [ %567, %2138 ], [ %567, %2130 ], [ %567, %2127 ], [ %643, %2745 ], [ %643, %2737 ], [ %643, %2734 ], [ %567, %2668 ], [ %567, %2641 ], [ %567, %2154 ], [ %567, %2120 ], [ %567, %2094 ]
  %2755 = phi i32 [ 1, %650 ], [ 3, %2142 ], [ 3, %2138 ], [ 3, %2130 ], [ 3, %2127 ], [ 1, %2745 ], [ 0, %2737 ], [ 1, %2734 ], [ 1, %2668 ], [ 3, %2641 ], [ 3, %2154 ], [ 3, %2120 ], [ 1, %2094 ]
  %2756 = phi i64 [ 2, %650 ], [ %566, %2142 ], [ %566, %2138 ], [ %566, %2130 ], [ %566, %2127 ], [ 0, %2745 ], [ %566, %2737 ], [ %2736, %2734 ], [ %2636, %2668 ], [ %566, %2641 ], [ %566, %2154 ], [ %566, %2120 ], [ -4, %2094 ]
  switch i32 %2755, label %2760 [
    i32 0, label %2757
    i32 3, label %2757
  ]

2757:                                             ; preds = %2746, %2746
  %2758 = load i64, ptr %334, align 8
  %2759 = icmp eq i64 %2758, 0
  br i1 %2759, label %556, label %564, !llvm.loop !54

2760:                                             ; preds = %2746, %433, %492, %556, %587, %595, %325
  %2761 = phi double [ %326, %325 ], [ %557, %556 ], [ %574, %595 ], [ %574, %587 ], [ %326, %492 ], [ %326, %433 ], [ %2747, %2746 ]
  %2762 = phi double [ %327, %325 ], [ %558, %556 ], [ %573, %595 ], [ %573, %587 ], [ %327, %492 ], [ %327, %433 ], [ %2748, %2746 ]
  %2763 = phi double [ %328, %325 ], [ %559, %556 ], [ %572, %595 ], [ %572, %587 ], [ %328, %492 ], [ %328, %433 ], [ %2749, %2746 ]
  %2764 = phi i64 [ %329, %325 ], [ %560, %556 ], [ %571, %595 ], [ %571, %587 ], [ %329, %492 ], [ %329, %433 ], [ %2750, %2746 ]
  %2765 = phi i64 [ %330, %325 ], [ %561, %556 ], [ %570, %595 ], [ %570, %587 ], [ %330, %492 ], [ %330, %433 ], [ %2751, %2746 ]
  %2766 = phi i64 [ %331, %325 ], [ %562, %556 ], [ %569, %595 ], [ %569, %587 ], [ %331, %492 ], [ %331, %433 ], [ %2752, %2746 ]
  %2767 = phi i64 [ -1, %325 ], [ -1, %556 ], [ 1, %595 ], [ -5, %587 ], [ 0, %492 ], [ %436, %433 ], [ %2756, %2746 ]
  %2768 = load ptr, ptr %324, align 8
  %2769 = getelementptr inbounds i8, ptr %2768, i64 48
  %2770 = load i64, ptr %2769, align 8
  %2771 = icmp ne i64 %2767, -2
  %2772 = icmp eq i64 %2770, 0
  %2773 = select i1 %2771, i1 true, i1 %2772
  br i1 %2773, label %2781, label %2774

2774:                                             ; preds = %2760
  %2775 = inttoptr i64 %2770 to ptr
  %2776 = tail call i64 %2775(ptr noundef %0) #10
  %2777 = icmp eq i64 %2776, 8
  %2778 = select i1 %2777, i64 8, i64 %2767
  %2779 = icmp eq i64 %2776, 1
  %2780 = zext i1 %2779 to i32
  br label %2781

2781:                                             ; preds = %2760, %2774
  %2782 = phi i64 [ %2767, %2760 ], [ %2778, %2774 ]
  %2783 = phi i32 [ 0, %2760 ], [ %2780, %2774 ]
  %2784 = icmp eq i32 %2783, 0
  br i1 %2784, label %2785, label %325, !llvm.loop !66

2785:                                             ; preds = %2781
  %2786 = getelementptr inbounds i8, ptr %0, i64 768
  %2787 = getelementptr inbounds i8, ptr %0, i64 320
  %2788 = load i64, ptr %2787, align 8
  %2789 = icmp sgt i64 %2788, 0
  br i1 %2789, label %2790, label %2793

2790:                                             ; preds = %2785
  %2791 = getelementptr inbounds i8, ptr %0, i64 336
  %2792 = load ptr, ptr %2791, align 8
  store double 0x7FF0000000000000, ptr %2792, align 8
  br label %2793

2793:                                             ; preds = %2785, %2790
  %2794 = icmp eq i64 %2782, 0
  %2795 = and i1 %15, %2794
  br i1 %2795, label %2796, label %2883

2796:                                             ; preds = %2793
  %2797 = load ptr, ptr %2786, align 8
  %2798 = getelementptr inbounds i8, ptr %2797, i64 8
  %2799 = load i64, ptr %2798, align 8
  %2800 = load ptr, ptr %193, align 8
  %2801 = load double, ptr %2800, align 8
  %2802 = tail call double @llvm.fabs.f64(double %2801)
  %2803 = fmul double %2802, 0x3CC0000000000000
  %2804 = icmp eq i64 %2799, 0
  br i1 %2804, label %2883, label %2805

2805:                                             ; preds = %2796
  %2806 = getelementptr inbounds i8, ptr %0, i64 248
  %2807 = load i64, ptr %2806, align 8
  %2808 = icmp sgt i64 %2807, 0
  br i1 %2808, label %2884, label %2809

2809:                                             ; preds = %2805
  %2810 = load ptr, ptr %190, align 8
  %2811 = getelementptr inbounds i8, ptr %2810, i64 40
  %2812 = load i64, ptr %2811, align 8
  %2813 = icmp eq i64 %2812, 0
  br i1 %2813, label %2814, label %2884

2814:                                             ; preds = %2809
  %2815 = getelementptr inbounds i8, ptr %0, i64 168
  %2816 = load ptr, ptr %2815, align 8
  store double %2801, ptr %2816, align 8
  %2817 = load ptr, ptr %2786, align 8
  %2818 = load i64, ptr %2817, align 8
  %2819 = load ptr, ptr %2815, align 8
  %2820 = load ptr, ptr %191, align 8
  %2821 = getelementptr inbounds i8, ptr %0, i64 192
  %2822 = load ptr, ptr %2821, align 8
  %2823 = getelementptr inbounds i8, ptr %0, i64 792
  %2824 = load ptr, ptr %2823, align 8
  %2825 = getelementptr inbounds i8, ptr %0, i64 984
  %2826 = load ptr, ptr %2825, align 8
  %2827 = inttoptr i64 %2818 to ptr
  %2828 = load ptr, ptr %2827, align 8
  %2829 = tail call i32 %2828(ptr noundef %2819, ptr noundef %2820, ptr noundef %2822, ptr noundef %2824, ptr noundef %2826) #10
  %2830 = load ptr, ptr %2786, align 8
  %2831 = getelementptr inbounds i8, ptr %2830, i64 56
  %2832 = load i64, ptr %2831, align 8
  %2833 = load ptr, ptr %2815, align 8
  %2834 = load ptr, ptr %191, align 8
  %2835 = load ptr, ptr %2821, align 8
  %2836 = getelementptr inbounds i8, ptr %0, i64 1152
  %2837 = load ptr, ptr %2836, align 8
  %2838 = getelementptr inbounds i8, ptr %0, i64 1200
  %2839 = load ptr, ptr %2838, align 8
  %2840 = inttoptr i64 %2832 to ptr
  %2841 = load ptr, ptr %2840, align 8
  %2842 = tail call i32 %2841(ptr noundef %2833, ptr noundef %2834, ptr noundef %2835, ptr noundef %2837, ptr noundef %2839) #10
  %2843 = icmp sgt i64 %2799, 0
  br i1 %2843, label %2844, label %2883

2844:                                             ; preds = %2814
  %2845 = getelementptr inbounds i8, ptr %0, i64 984
  %2846 = load ptr, ptr %2845, align 8
  %2847 = getelementptr inbounds i8, ptr %0, i64 936
  %2848 = load ptr, ptr %2847, align 8
  %2849 = getelementptr inbounds i8, ptr %0, i64 1200
  %2850 = load ptr, ptr %2849, align 8
  %2851 = load double, ptr %2846, align 8
  %2852 = load i64, ptr %2848, align 8
  %2853 = sitofp i64 %2852 to double
  %2854 = fmul double %2851, %2853
  %2855 = load double, ptr %2850, align 8
  %2856 = tail call double @llvm.fabs.f64(double %2855)
  %2857 = fmul double %2803, %2856
  %2858 = fcmp ogt double %2854, %2857
  %2859 = fcmp olt double %2854, 0.000000e+00
  %2860 = or i1 %2859, %2858
  br i1 %2860, label %2861, label %2881

2861:                                             ; preds = %2844, %2865
  %2862 = phi i64 [ %2863, %2865 ], [ 0, %2844 ]
  %2863 = add nuw nsw i64 %2862, 1
  %2864 = icmp eq i64 %2863, %2799
  br i1 %2864, label %2883, label %2865, !llvm.loop !67

2865:                                             ; preds = %2861
  %2866 = getelementptr inbounds double, ptr %2846, i64 %2863
  %2867 = load double, ptr %2866, align 8
  %2868 = getelementptr inbounds i64, ptr %2848, i64 %2863
  %2869 = load i64, ptr %2868, align 8
  %2870 = sitofp i64 %2869 to double
  %2871 = fmul double %2867, %2870
  %2872 = getelementptr inbounds double, ptr %2850, i64 %2863
  %2873 = load double, ptr %2872, align 8
  %2874 = tail call double @llvm.fabs.f64(double %2873)
  %2875 = fmul double %2803, %2874
  %2876 = fcmp ogt double %2871, %2875
  %2877 = fcmp olt double %2871, 0.000000e+00
  %2878 = or i1 %2877, %2876
  br i1 %2878, label %2861, label %2879, !llvm.loop !67

2879:                                             ; preds = %2865
  %2880 = icmp slt i64 %2863, %2799
  br label %2881

2881:                                             ; preds = %2879, %2844
  %2882 = phi i1 [ %2880, %2879 ], [ %2843, %2844 ]
  br i1 %2882, label %2884, label %2883

2883:                                             ; preds = %2861, %2814, %2796, %2881, %2793
  br label %2884

2884:                                             ; preds = %91, %95, %81, %2805, %2809, %2883, %2881, %187
  %2885 = phi i64 [ -7, %187 ], [ %2782, %2883 ], [ -8, %2881 ], [ -8, %2809 ], [ -8, %2805 ], [ -7, %81 ], [ -7, %95 ], [ -7, %91 ]
  ret i64 %2885
}



declare double @llvm.fabs.f64(double) #2

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #3 {
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
  br i1 %28, label %16, label %29, !llvm.loop !13

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
  br i1 %60, label %49, label %61, !llvm.loop !68

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
  br i1 %88, label %14, label %13, !llvm.loop !69
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
  br i1 %41, label %13, label %18, !llvm.loop !70
}

declare double @llvm.sqrt.f64(double) #2

define internal fastcc range(i64 -2147483648, 2147483648) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %11, label %9

5:                                                ; preds = %98, %49
  %6 = icmp eq i64 %20, %1
  br i1 %6, label %7, label %11, !llvm.loop !71

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
  br i1 %48, label %35, label %23, !llvm.loop !72

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
  br i1 %66, label %49, label %56, !llvm.loop !73

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
  br i1 %77, label %67, label %63, !llvm.loop !74

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
  br i1 %97, label %88, label %98, !llvm.loop !75

98:                                               ; preds = %88, %78
  %99 = add nuw nsw i64 %79, 1
  %100 = icmp slt i64 %99, %1
  br i1 %100, label %78, label %5, !llvm.loop !76
}

define internal fastcc range(i64 -2147483648, 2147483648) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %11, label %9

5:                                                ; preds = %156, %59
  %6 = icmp eq i64 %26, %1
  br i1 %6, label %7, label %11, !llvm.loop !77

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
  br i1 %58, label %38, label %28, !llvm.loop !78

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
  br i1 %85, label %59, label %76, !llvm.loop !79

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
  br i1 %108, label %86, label %82, !llvm.loop !80

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
  br i1 %155, label %130, label %156, !llvm.loop !81

156:                                              ; preds = %130, %109
  %157 = add nuw nsw i64 %110, 1
  %158 = icmp slt i64 %157, %1
  br i1 %158, label %109, label %5, !llvm.loop !82
}

declare double @llvm.fma.f64(double, double, double) #2

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
  br i1 %16, label %6, label %8, !llvm.loop !83

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
  br i1 %38, label %23, label %27, !llvm.loop !84

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
  br i1 %49, label %35, label %39, !llvm.loop !85

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
  br i1 %66, label %51, label %50, !llvm.loop !86

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
  br i1 %77, label %60, label %67, !llvm.loop !87
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
  br i1 %16, label %6, label %8, !llvm.loop !83

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
  br i1 %30, label %23, label %14, !llvm.loop !88

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
  br i1 %51, label %31, label %36, !llvm.loop !90

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
  br i1 %77, label %47, label %52, !llvm.loop !91

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
  br i1 %105, label %79, label %78, !llvm.loop !92

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
  br i1 %131, label %91, label %106, !llvm.loop !93
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
  br i1 %21, label %9, label %13, !llvm.loop !83

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
  br i1 %35, label %19, label %28, !llvm.loop !88

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
  br i1 %52, label %44, label %36, !llvm.loop !94

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
  br i1 %69, label %70, label %61, !llvm.loop !95

70:                                               ; preds = %61, %53
  %71 = add nuw nsw i64 %54, 1
  %72 = icmp eq i64 %71, %37
  br i1 %72, label %50, label %53, !llvm.loop !96

73:                                               ; preds = %111, %85
  %74 = icmp sgt i64 %76, 1
  br i1 %74, label %75, label %84, !llvm.loop !97

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
  br i1 %107, label %108, label %99, !llvm.loop !95

108:                                              ; preds = %99, %91
  %109 = add nuw nsw i64 %92, 1
  %110 = icmp eq i64 %109, %1
  br i1 %110, label %85, label %91, !llvm.loop !98

111:                                              ; preds = %86, %111
  %112 = phi i64 [ 0, %86 ], [ %117, %111 ]
  %113 = getelementptr double, ptr %88, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = load double, ptr %90, align 8
  %116 = fmul double %114, %115
  store double %116, ptr %113, align 8
  %117 = add nuw nsw i64 %112, 1
  %118 = icmp eq i64 %117, %4
  br i1 %118, label %73, label %111, !llvm.loop !99
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
  br i1 %23, label %11, label %15, !llvm.loop !83

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
  br i1 %37, label %21, label %30, !llvm.loop !88

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
  br i1 %53, label %44, label %38, !llvm.loop !100

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
  br i1 %89, label %90, label %66, !llvm.loop !101

90:                                               ; preds = %66, %54
  %91 = add nuw nsw i64 %55, 1
  %92 = icmp eq i64 %91, %39
  br i1 %92, label %51, label %54, !llvm.loop !102

93:                                               ; preds = %149, %103
  %94 = icmp sgt i64 %96, 1
  br i1 %94, label %95, label %102, !llvm.loop !103

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
  br i1 %145, label %146, label %122, !llvm.loop !101

146:                                              ; preds = %122, %110
  %147 = add nuw nsw i64 %111, 1
  %148 = icmp eq i64 %147, %1
  br i1 %148, label %103, label %110, !llvm.loop !104

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
  br i1 %166, label %93, label %149, !llvm.loop !105
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
  br i1 %54, label %43, label %55, !llvm.loop !68

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
  br i1 %71, label %16, label %18, !llvm.loop !106
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
  br i1 %31, label %20, label %19, !llvm.loop !107

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
  br i1 %43, label %32, label %24, !llvm.loop !108
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #9

declare i64 @llvm.smin.i64(i64, i64) #9

declare i64 @llvm.umax.i64(i64, i64) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
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
!8 = distinct !{!8, !4, !5}
!9 = !{!10}
!10 = distinct !{!10, !11, !"implicit_of: argument 0"}
!11 = distinct !{!11, !"implicit_of"}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = !{!17}
!17 = distinct !{!17, !18, !"try_step: argument 0"}
!18 = distinct !{!18, !"try_step"}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = !{!30, !17}
!30 = distinct !{!30, !31, !"solve_stages: argument 0"}
!31 = distinct !{!31, !"solve_stages"}
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
!54 = distinct !{!54, !5}
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
!88 = distinct !{!88, !4, !5, !89}
!89 = !{!"llvm.loop.vectorize.width", i32 1}
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
!107 = distinct !{!107, !4, !5}
!108 = distinct !{!108, !4, !5}
