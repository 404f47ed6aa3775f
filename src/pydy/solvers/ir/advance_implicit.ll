; sources 8e98cf9582cbf7553797a2ec8468706ed6e8138a770a11a762f569d69ea8e9e2
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
  %25 = getelementptr inbounds i8, ptr %0, i64 1056
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
  %43 = getelementptr inbounds i8, ptr %0, i64 1080
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
  %71 = getelementptr inbounds i8, ptr %0, i64 912
  %72 = load ptr, ptr %71, align 8
  %73 = mul i64 %58, 88
  %74 = getelementptr inbounds i8, ptr %72, i64 %73
  store double 0x7FF8000000000000, ptr %74, align 8
  br label %75

75:                                               ; preds = %70, %54, %3
  %76 = getelementptr inbounds i8, ptr %0, i64 144
  %77 = getelementptr inbounds i8, ptr %0, i64 312
  %78 = getelementptr inbounds i8, ptr %0, i64 1152
  %79 = getelementptr inbounds i8, ptr %0, i64 576
  %80 = load ptr, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %0, i64 1176
  %82 = load ptr, ptr %81, align 8
  %83 = getelementptr inbounds i8, ptr %0, i64 600
  %84 = load ptr, ptr %83, align 8
  %85 = load ptr, ptr %78, align 8
  %86 = getelementptr inbounds i8, ptr %84, i64 56
  %87 = load i64, ptr %86, align 8
  %88 = icmp eq i64 %87, 0
  br i1 %88, label %1780, label %89

89:                                               ; preds = %75
  %90 = load ptr, ptr %76, align 8
  %91 = getelementptr inbounds i8, ptr %90, i64 8
  %92 = load i64, ptr %91, align 8
  %93 = getelementptr inbounds i8, ptr %0, i64 624
  %94 = load ptr, ptr %93, align 8
  %95 = getelementptr inbounds i8, ptr %0, i64 632
  %96 = load i64, ptr %95, align 8
  %97 = getelementptr double, ptr %94, i64 %96
  %98 = getelementptr i8, ptr %97, i64 -8
  %99 = load double, ptr %98, align 8
  %100 = getelementptr inbounds i8, ptr %0, i64 648
  %101 = load ptr, ptr %100, align 8
  %102 = load i64, ptr %101, align 8
  %103 = icmp eq i64 %102, 1
  %104 = getelementptr inbounds i8, ptr %0, i64 720
  %105 = load ptr, ptr %104, align 8
  %106 = getelementptr inbounds i8, ptr %105, i64 8
  %107 = load i64, ptr %106, align 8
  %108 = icmp sgt i64 %107, 0
  %109 = getelementptr inbounds i8, ptr %0, i64 528
  %110 = load ptr, ptr %109, align 8
  %111 = load double, ptr %110, align 8
  %112 = icmp sgt i64 %92, 0
  br i1 %112, label %128, label %113

113:                                              ; preds = %128, %89
  %114 = phi double [ %111, %89 ], [ %134, %128 ]
  %115 = tail call double @llvm.sqrt.f64(double %114)
  %116 = fcmp olt double %115, 3.000000e-02
  %117 = select i1 %116, double %115, double 3.000000e-02
  %118 = fcmp olt double %114, 0x3CB0000000000000
  %119 = select i1 %118, double 0x3CB0000000000000, double %114
  %120 = fdiv double 0x3CE4000000000000, %119
  %121 = fcmp ogt double %117, %120
  %122 = select i1 %121, double %117, double %120
  %123 = load double, ptr %80, align 8
  %124 = getelementptr inbounds i8, ptr %80, i64 8
  %125 = load double, ptr %124, align 8
  %126 = load i64, ptr %84, align 8
  %127 = icmp eq i64 %126, 0
  br i1 %127, label %137, label %235

128:                                              ; preds = %89, %128
  %129 = phi double [ %134, %128 ], [ %111, %89 ]
  %130 = phi i64 [ %135, %128 ], [ 0, %89 ]
  %131 = getelementptr inbounds double, ptr %110, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = fcmp olt double %132, %129
  %134 = select i1 %133, double %132, double %129
  %135 = add nuw nsw i64 %130, 1
  %136 = icmp eq i64 %135, %92
  br i1 %136, label %113, label %128, !llvm.loop !8

137:                                              ; preds = %113
  %138 = getelementptr inbounds i8, ptr %84, i64 24
  %139 = load i64, ptr %138, align 8
  %140 = add nsw i64 %139, 1
  store i64 %140, ptr %138, align 8
  %141 = load ptr, ptr %77, align 8
  %142 = getelementptr inbounds i8, ptr %0, i64 480
  %143 = load ptr, ptr %142, align 8
  %144 = getelementptr inbounds i8, ptr %0, i64 168
  %145 = load ptr, ptr %144, align 8
  store double %123, ptr %145, align 8
  %146 = getelementptr inbounds i8, ptr %0, i64 248
  %147 = load i64, ptr %146, align 8
  %148 = icmp sgt i64 %147, 0
  br i1 %148, label %149, label %150

149:                                              ; preds = %137
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %150

150:                                              ; preds = %137, %149
  %151 = load ptr, ptr %76, align 8
  %152 = load i64, ptr %151, align 8
  %153 = load ptr, ptr %144, align 8
  %154 = getelementptr inbounds i8, ptr %0, i64 192
  %155 = load ptr, ptr %154, align 8
  %156 = getelementptr inbounds i8, ptr %0, i64 216
  %157 = load ptr, ptr %156, align 8
  %158 = inttoptr i64 %152 to ptr
  %159 = tail call i32 %158(ptr noundef %153, ptr noundef %141, ptr noundef %155, ptr noundef %157, ptr noundef %143) #11
  %160 = icmp eq i32 %159, 0
  br i1 %160, label %165, label %161

161:                                              ; preds = %150
  %162 = getelementptr inbounds i8, ptr %84, i64 72
  store i64 3, ptr %162, align 8
  %163 = icmp slt i32 %159, 0
  %164 = select i1 %163, i64 -4, i64 2
  br label %1780

165:                                              ; preds = %150
  store i64 1, ptr %84, align 8
  %166 = getelementptr inbounds i8, ptr %80, i64 24
  store double 0.000000e+00, ptr %166, align 8
  %167 = getelementptr inbounds i8, ptr %85, i64 32
  store i64 1, ptr %167, align 8
  %168 = getelementptr inbounds i8, ptr %85, i64 8
  store i64 1, ptr %168, align 8
  %169 = getelementptr inbounds i8, ptr %82, i64 8
  store double 0.000000e+00, ptr %169, align 8
  %170 = load ptr, ptr %77, align 8
  %171 = load ptr, ptr %76, align 8
  %172 = getelementptr inbounds i8, ptr %171, i64 8
  %173 = load i64, ptr %172, align 8
  %174 = load i64, ptr %95, align 8
  %175 = load ptr, ptr %93, align 8
  %176 = load ptr, ptr %83, align 8
  %177 = getelementptr inbounds i8, ptr %176, i64 48
  %178 = load i64, ptr %177, align 8
  %179 = icmp slt i64 %178, %174
  br i1 %179, label %180, label %203

180:                                              ; preds = %165
  %181 = icmp sgt i64 %173, 0
  br label %182

182:                                              ; preds = %180, %193
  %183 = phi i64 [ %178, %180 ], [ %194, %193 ]
  %184 = getelementptr inbounds double, ptr %175, i64 %183
  %185 = load double, ptr %184, align 8
  %186 = load ptr, ptr %79, align 8
  %187 = load double, ptr %186, align 8
  %188 = fcmp ugt double %185, %187
  br i1 %188, label %203, label %189

189:                                              ; preds = %182
  br i1 %181, label %190, label %193

190:                                              ; preds = %189
  %191 = mul nsw i64 %183, %173
  %192 = getelementptr double, ptr %1, i64 %191
  br label %196

193:                                              ; preds = %196, %189
  %194 = add i64 %183, 1
  %195 = icmp eq i64 %194, %174
  br i1 %195, label %203, label %182, !llvm.loop !9

196:                                              ; preds = %190, %196
  %197 = phi i64 [ 0, %190 ], [ %201, %196 ]
  %198 = getelementptr inbounds double, ptr %170, i64 %197
  %199 = load double, ptr %198, align 8
  %200 = getelementptr double, ptr %192, i64 %197
  store double %199, ptr %200, align 8
  %201 = add nuw nsw i64 %197, 1
  %202 = icmp eq i64 %201, %173
  br i1 %202, label %193, label %196, !llvm.loop !10

203:                                              ; preds = %182, %193, %165
  %204 = phi i64 [ %178, %165 ], [ %183, %182 ], [ %174, %193 ]
  %205 = load ptr, ptr %83, align 8
  %206 = getelementptr inbounds i8, ptr %205, i64 48
  store i64 %204, ptr %206, align 8
  %207 = icmp eq i64 %204, %174
  br i1 %207, label %1780, label %208

208:                                              ; preds = %203
  %209 = fcmp oeq double %125, 0.000000e+00
  br i1 %209, label %210, label %235

210:                                              ; preds = %208
  %211 = getelementptr inbounds i8, ptr %80, i64 16
  %212 = load double, ptr %211, align 8
  %213 = load ptr, ptr %77, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %213, ptr noundef %213, ptr noundef nonnull %77, i64 noundef %92) #10
  %214 = load double, ptr %4, align 8
  %215 = getelementptr inbounds i8, ptr %0, i64 480
  %216 = load ptr, ptr %215, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %216, ptr noundef %213, ptr noundef nonnull %77, i64 noundef %92) #10
  %217 = load double, ptr %5, align 8
  %218 = fcmp uge double %214, 1.000000e-05
  %219 = fcmp uge double %217, 1.000000e-05
  %220 = and i1 %218, %219
  %221 = fmul double %214, 1.000000e-02
  %222 = fdiv double %221, %217
  %223 = select i1 %220, double %222, double 0x3EB0C6F7A0B5ED8D
  %224 = fcmp olt double %212, %223
  %225 = select i1 %224, double %212, double %223
  %226 = tail call double @llvm.fabs.f64(double %123)
  %227 = fmul double %226, 0x3D30000000000000
  %228 = fcmp ogt double %227, %225
  %229 = select i1 %228, double %227, double %225
  %230 = fcmp olt double %212, %229
  %231 = select i1 %230, double %212, double %229
  %232 = tail call i1 @llvm.is.fpclass.f64(double %231, i32 639)
  br i1 %232, label %233, label %235

233:                                              ; preds = %210
  %234 = getelementptr inbounds i8, ptr %84, i64 72
  store i64 4, ptr %234, align 8
  br label %235

235:                                              ; preds = %210, %233, %208, %113
  %236 = phi double [ %125, %208 ], [ %125, %113 ], [ %231, %233 ], [ %231, %210 ]
  %237 = load i64, ptr %86, align 8
  %238 = icmp eq i64 %237, 0
  br i1 %238, label %357, label %239

239:                                              ; preds = %235
  %240 = getelementptr inbounds i8, ptr %0, i64 1104
  %241 = getelementptr inbounds i8, ptr %84, i64 8
  %242 = getelementptr inbounds i8, ptr %84, i64 16
  %243 = getelementptr inbounds i8, ptr %84, i64 64
  %244 = getelementptr inbounds i8, ptr %80, i64 16
  %245 = getelementptr inbounds i8, ptr %85, i64 8
  %246 = getelementptr inbounds i8, ptr %0, i64 1224
  %247 = getelementptr inbounds i8, ptr %0, i64 168
  %248 = getelementptr inbounds i8, ptr %0, i64 248
  %249 = getelementptr inbounds i8, ptr %0, i64 168
  %250 = getelementptr inbounds i8, ptr %0, i64 192
  %251 = getelementptr inbounds i8, ptr %0, i64 1200
  %252 = getelementptr inbounds i8, ptr %0, i64 360
  %253 = getelementptr inbounds i8, ptr %0, i64 360
  %254 = getelementptr inbounds i8, ptr %0, i64 336
  %255 = getelementptr inbounds i8, ptr %0, i64 168
  %256 = getelementptr inbounds i8, ptr %0, i64 248
  %257 = getelementptr inbounds i8, ptr %0, i64 192
  %258 = getelementptr inbounds i8, ptr %0, i64 216
  %259 = getelementptr inbounds i8, ptr %0, i64 480
  %260 = getelementptr inbounds i8, ptr %0, i64 1232
  %261 = getelementptr inbounds i8, ptr %85, i64 16
  %262 = getelementptr inbounds i8, ptr %85, i64 24
  %263 = getelementptr inbounds i8, ptr %85, i64 24
  %264 = getelementptr inbounds i8, ptr %84, i64 40
  %265 = getelementptr inbounds i8, ptr %0, i64 1296
  %266 = getelementptr inbounds i8, ptr %0, i64 1304
  %267 = getelementptr inbounds i8, ptr %0, i64 1248
  %268 = getelementptr inbounds i8, ptr %0, i64 1272
  %269 = getelementptr inbounds i8, ptr %0, i64 1224
  %270 = getelementptr inbounds i8, ptr %0, i64 1320
  %271 = getelementptr inbounds i8, ptr %82, i64 8
  %272 = getelementptr inbounds i8, ptr %0, i64 1416
  %273 = getelementptr inbounds i8, ptr %0, i64 1344
  %274 = getelementptr inbounds i8, ptr %0, i64 1368
  %275 = fmul double %114, %122
  %276 = getelementptr inbounds i8, ptr %0, i64 1392
  %277 = getelementptr inbounds i8, ptr %0, i64 1440
  %278 = getelementptr inbounds i8, ptr %0, i64 1464
  %279 = getelementptr inbounds i8, ptr %0, i64 360
  %280 = getelementptr inbounds i8, ptr %0, i64 168
  %281 = getelementptr inbounds i8, ptr %0, i64 248
  %282 = getelementptr inbounds i8, ptr %0, i64 360
  %283 = getelementptr inbounds i8, ptr %0, i64 192
  %284 = getelementptr inbounds i8, ptr %0, i64 216
  %285 = getelementptr inbounds i8, ptr %0, i64 552
  %286 = getelementptr inbounds i8, ptr %0, i64 528
  %287 = getelementptr inbounds i8, ptr %0, i64 1296
  %288 = getelementptr inbounds i8, ptr %0, i64 1304
  %289 = getelementptr inbounds i8, ptr %0, i64 1248
  %290 = getelementptr inbounds i8, ptr %0, i64 1272
  %291 = getelementptr inbounds i8, ptr %0, i64 1320
  %292 = getelementptr inbounds i8, ptr %0, i64 552
  %293 = getelementptr inbounds i8, ptr %0, i64 528
  %294 = getelementptr inbounds i8, ptr %0, i64 1304
  %295 = getelementptr inbounds i8, ptr %0, i64 1368
  %296 = getelementptr inbounds i8, ptr %0, i64 1384
  %297 = getelementptr inbounds i8, ptr %0, i64 1440
  %298 = getelementptr inbounds i8, ptr %0, i64 1464
  %299 = fmul double %275, %275
  %300 = icmp sgt i64 %92, 0
  %301 = shl i64 %92, 4
  %302 = getelementptr inbounds i8, ptr %0, i64 336
  %303 = getelementptr inbounds i8, ptr %85, i64 32
  %304 = getelementptr inbounds i8, ptr %0, i64 1296
  %305 = getelementptr inbounds i8, ptr %0, i64 1304
  %306 = getelementptr inbounds i8, ptr %0, i64 1488
  %307 = getelementptr inbounds i8, ptr %0, i64 480
  %308 = getelementptr inbounds i8, ptr %0, i64 1248
  %309 = getelementptr inbounds i8, ptr %0, i64 336
  %310 = getelementptr inbounds i8, ptr %0, i64 360
  %311 = getelementptr inbounds i8, ptr %0, i64 360
  %312 = getelementptr inbounds i8, ptr %0, i64 168
  %313 = getelementptr inbounds i8, ptr %0, i64 248
  %314 = getelementptr inbounds i8, ptr %0, i64 192
  %315 = getelementptr inbounds i8, ptr %0, i64 216
  %316 = getelementptr inbounds i8, ptr %84, i64 72
  %317 = getelementptr inbounds i8, ptr %85, i64 16
  %318 = getelementptr inbounds i8, ptr %84, i64 72
  %319 = getelementptr inbounds i8, ptr %85, i64 16
  %320 = getelementptr inbounds i8, ptr %80, i64 24
  %321 = getelementptr inbounds i8, ptr %80, i64 32
  %322 = getelementptr inbounds i8, ptr %80, i64 32
  %323 = getelementptr inbounds i8, ptr %0, i64 320
  %324 = getelementptr inbounds i8, ptr %0, i64 504
  %325 = getelementptr inbounds i8, ptr %8, i64 8
  %326 = getelementptr inbounds i8, ptr %8, i64 16
  %327 = getelementptr inbounds i8, ptr %9, i64 8
  %328 = getelementptr inbounds i8, ptr %9, i64 16
  %329 = getelementptr inbounds i8, ptr %0, i64 1128
  %330 = getelementptr inbounds i8, ptr %0, i64 1144
  %331 = getelementptr inbounds i8, ptr %84, i64 48
  %332 = getelementptr inbounds i8, ptr %0, i64 408
  %333 = getelementptr inbounds i8, ptr %0, i64 504
  %334 = getelementptr inbounds i8, ptr %0, i64 320
  %335 = getelementptr inbounds i8, ptr %0, i64 360
  %336 = getelementptr inbounds i8, ptr %0, i64 408
  %337 = getelementptr inbounds i8, ptr %0, i64 504
  %338 = getelementptr inbounds i8, ptr %0, i64 320
  %339 = icmp sgt i64 %92, 0
  %340 = getelementptr inbounds i8, ptr %84, i64 24
  %341 = getelementptr inbounds i8, ptr %0, i64 480
  %342 = getelementptr inbounds i8, ptr %0, i64 168
  %343 = getelementptr inbounds i8, ptr %0, i64 248
  %344 = getelementptr inbounds i8, ptr %0, i64 192
  %345 = getelementptr inbounds i8, ptr %0, i64 216
  %346 = getelementptr inbounds i8, ptr %84, i64 72
  %347 = getelementptr inbounds i8, ptr %85, i64 16
  %348 = getelementptr inbounds i8, ptr %84, i64 48
  %349 = getelementptr inbounds i8, ptr %85, i64 16
  %350 = getelementptr inbounds i8, ptr %84, i64 72
  %351 = getelementptr inbounds i8, ptr %84, i64 72
  %352 = getelementptr inbounds i8, ptr %85, i64 16
  %353 = getelementptr inbounds i8, ptr %0, i64 1224
  %354 = getelementptr inbounds i8, ptr %0, i64 1232
  %355 = getelementptr inbounds i8, ptr %84, i64 72
  %356 = getelementptr inbounds i8, ptr %85, i64 16
  br label %359

357:                                              ; preds = %1777, %235
  %358 = phi double [ %236, %235 ], [ %1773, %1777 ]
  store double %358, ptr %124, align 8
  br label %1780

359:                                              ; preds = %239, %1777
  %360 = phi i64 [ %237, %239 ], [ %1778, %1777 ]
  %361 = phi i64 [ undef, %239 ], [ %1776, %1777 ]
  %362 = phi double [ %123, %239 ], [ %1774, %1777 ]
  %363 = phi double [ %236, %239 ], [ %1773, %1777 ]
  %364 = phi i64 [ undef, %239 ], [ %1772, %1777 ]
  %365 = phi i64 [ undef, %239 ], [ %1771, %1777 ]
  %366 = phi i32 [ undef, %239 ], [ %1770, %1777 ]
  %367 = phi double [ undef, %239 ], [ %1769, %1777 ]
  %368 = load ptr, ptr %240, align 8
  %369 = getelementptr inbounds i8, ptr %368, i64 8
  %370 = load i64, ptr %369, align 8
  %371 = icmp sgt i64 %370, 0
  br i1 %371, label %372, label %377

372:                                              ; preds = %359
  %373 = load i64, ptr %368, align 8
  %374 = add nsw i64 %373, 3
  %375 = icmp slt i64 %370, %374
  %376 = zext i1 %375 to i32
  br label %377

377:                                              ; preds = %359, %372
  %378 = phi i32 [ 0, %359 ], [ %376, %372 ]
  %379 = icmp eq i32 %378, 0
  br i1 %379, label %381, label %380

380:                                              ; preds = %377
  store double %363, ptr %124, align 8
  br label %1780

381:                                              ; preds = %377
  %382 = add nsw i64 %360, -1
  store i64 %382, ptr %86, align 8
  %383 = load i64, ptr %241, align 8
  %384 = load i64, ptr %242, align 8
  %385 = add nsw i64 %384, %383
  %386 = load i64, ptr %243, align 8
  %387 = icmp slt i64 %385, %386
  br i1 %387, label %389, label %388

388:                                              ; preds = %381
  store double %363, ptr %124, align 8
  br label %1780

389:                                              ; preds = %381
  %390 = load double, ptr %244, align 8
  %391 = fcmp olt double %363, %390
  %392 = select i1 %391, double %363, double %390
  %393 = fadd double %362, %392
  %394 = fmul double %392, 1.000000e-03
  %395 = fsub double %99, %394
  %396 = fcmp ule double %393, %395
  %397 = fsub double %99, %362
  %398 = select i1 %396, double %392, double %397
  %399 = select i1 %396, double %393, double %99
  %400 = fmul double %398, 6.250000e-02
  %401 = fadd double %362, %400
  %402 = fcmp ule double %401, %362
  %403 = fcmp une double %399, %99
  %404 = and i1 %403, %402
  br i1 %404, label %405, label %406

405:                                              ; preds = %389
  store double %398, ptr %124, align 8
  br label %1768

406:                                              ; preds = %389
  %407 = load i64, ptr %245, align 8
  %408 = icmp eq i64 %407, 1
  br i1 %408, label %409, label %527

409:                                              ; preds = %406
  %410 = load ptr, ptr %83, align 8
  %411 = getelementptr inbounds i8, ptr %410, i64 32
  %412 = load i64, ptr %411, align 8
  %413 = add nsw i64 %412, 1
  store i64 %413, ptr %411, align 8
  %414 = load ptr, ptr %76, align 8
  %415 = getelementptr inbounds i8, ptr %414, i64 8
  %416 = load i64, ptr %415, align 8
  %417 = load ptr, ptr %78, align 8
  %418 = load i64, ptr %417, align 8
  %419 = icmp eq i64 %418, 0
  br i1 %419, label %420, label %422

420:                                              ; preds = %409
  %421 = icmp sgt i64 %416, 0
  br i1 %421, label %440, label %438

422:                                              ; preds = %409
  %423 = load ptr, ptr %247, align 8
  store double %362, ptr %423, align 8
  %424 = load i64, ptr %248, align 8
  %425 = icmp sgt i64 %424, 0
  br i1 %425, label %426, label %427

426:                                              ; preds = %422
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %427

427:                                              ; preds = %426, %422
  %428 = load ptr, ptr %78, align 8
  %429 = load i64, ptr %428, align 8
  %430 = load ptr, ptr %249, align 8
  %431 = load ptr, ptr %77, align 8
  %432 = load ptr, ptr %250, align 8
  %433 = load ptr, ptr %251, align 8
  %434 = load ptr, ptr %246, align 8
  %435 = inttoptr i64 %429 to ptr
  %436 = tail call i32 %435(ptr noundef %430, ptr noundef %431, ptr noundef %432, ptr noundef %433, ptr noundef %434) #11
  %437 = sext i32 %436 to i64
  br label %508

438:                                              ; preds = %440, %420
  %439 = icmp sgt i64 %416, 0
  br i1 %439, label %452, label %508

440:                                              ; preds = %420, %440
  %441 = phi i64 [ %447, %440 ], [ 0, %420 ]
  %442 = load ptr, ptr %77, align 8
  %443 = getelementptr inbounds double, ptr %442, i64 %441
  %444 = load double, ptr %443, align 8
  %445 = load ptr, ptr %252, align 8
  %446 = getelementptr inbounds double, ptr %445, i64 %441
  store double %444, ptr %446, align 8
  %447 = add nuw nsw i64 %441, 1
  %448 = icmp eq i64 %447, %416
  br i1 %448, label %438, label %440, !llvm.loop !11

449:                                              ; preds = %506
  %450 = add nuw nsw i64 %454, 1
  %451 = icmp eq i64 %450, %416
  br i1 %451, label %508, label %452, !llvm.loop !12

452:                                              ; preds = %438, %449
  %453 = phi i64 [ %507, %449 ], [ undef, %438 ]
  %454 = phi i64 [ %450, %449 ], [ 0, %438 ]
  %455 = load ptr, ptr %77, align 8
  %456 = getelementptr inbounds double, ptr %455, i64 %454
  %457 = load double, ptr %456, align 8
  %458 = tail call double @llvm.fabs.f64(double %457)
  %459 = fcmp olt double %458, 1.000000e-05
  %460 = select i1 %459, double 1.000000e-05, double %458
  %461 = fmul double %460, 1.500000e-08
  %462 = fadd double %457, %461
  %463 = load ptr, ptr %253, align 8
  %464 = getelementptr inbounds double, ptr %463, i64 %454
  store double %462, ptr %464, align 8
  %465 = load ptr, ptr %83, align 8
  %466 = getelementptr inbounds i8, ptr %465, i64 24
  %467 = load i64, ptr %466, align 8
  %468 = add nsw i64 %467, 1
  store i64 %468, ptr %466, align 8
  %469 = load ptr, ptr %253, align 8
  %470 = load ptr, ptr %254, align 8
  %471 = load ptr, ptr %255, align 8
  store double %362, ptr %471, align 8
  %472 = load i64, ptr %256, align 8
  %473 = icmp sgt i64 %472, 0
  br i1 %473, label %474, label %475

474:                                              ; preds = %452
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %475

475:                                              ; preds = %474, %452
  %476 = load ptr, ptr %76, align 8
  %477 = load i64, ptr %476, align 8
  %478 = load ptr, ptr %255, align 8
  %479 = load ptr, ptr %257, align 8
  %480 = load ptr, ptr %258, align 8
  %481 = inttoptr i64 %477 to ptr
  %482 = tail call i32 %481(ptr noundef %478, ptr noundef %469, ptr noundef %479, ptr noundef %480, ptr noundef %470) #11
  %483 = sext i32 %482 to i64
  %484 = icmp eq i32 %482, 0
  br i1 %484, label %485, label %506

485:                                              ; preds = %475
  %486 = fsub double %462, %457
  br label %490

487:                                              ; preds = %490
  %488 = load ptr, ptr %253, align 8
  %489 = getelementptr inbounds double, ptr %488, i64 %454
  store double %457, ptr %489, align 8
  br label %506

490:                                              ; preds = %485, %490
  %491 = phi i64 [ 0, %485 ], [ %504, %490 ]
  %492 = load ptr, ptr %254, align 8
  %493 = getelementptr inbounds double, ptr %492, i64 %491
  %494 = load double, ptr %493, align 8
  %495 = load ptr, ptr %259, align 8
  %496 = getelementptr inbounds double, ptr %495, i64 %491
  %497 = load double, ptr %496, align 8
  %498 = fsub double %494, %497
  %499 = fdiv double %498, %486
  %500 = load ptr, ptr %246, align 8
  %501 = mul nuw nsw i64 %491, %416
  %502 = getelementptr double, ptr %500, i64 %501
  %503 = getelementptr double, ptr %502, i64 %454
  store double %499, ptr %503, align 8
  %504 = add nuw nsw i64 %491, 1
  %505 = icmp eq i64 %504, %416
  br i1 %505, label %487, label %490, !llvm.loop !13

506:                                              ; preds = %487, %475
  %507 = phi i64 [ %453, %487 ], [ %483, %475 ]
  br i1 %484, label %449, label %508

508:                                              ; preds = %506, %449, %438, %427
  %509 = phi i64 [ %437, %427 ], [ 0, %438 ], [ 0, %449 ], [ %507, %506 ]
  %510 = load i64, ptr %260, align 8
  %511 = icmp sgt i64 %510, 0
  br i1 %511, label %512, label %524

512:                                              ; preds = %508, %520
  %513 = phi i64 [ %521, %520 ], [ 0, %508 ]
  %514 = load ptr, ptr %246, align 8
  %515 = getelementptr inbounds double, ptr %514, i64 %513
  %516 = load double, ptr %515, align 8
  %517 = tail call double @llvm.fabs.f64(double %516)
  %518 = fcmp ueq double %517, 0x7FF0000000000000
  br i1 %518, label %519, label %520

519:                                              ; preds = %512
  store double 0.000000e+00, ptr %515, align 8
  br label %520

520:                                              ; preds = %519, %512
  %521 = add nuw nsw i64 %513, 1
  %522 = load i64, ptr %260, align 8
  %523 = icmp slt i64 %521, %522
  br i1 %523, label %512, label %524, !llvm.loop !14

524:                                              ; preds = %520, %508
  %525 = icmp slt i64 %509, 0
  br i1 %525, label %1768, label %526

526:                                              ; preds = %524
  store i64 0, ptr %245, align 8
  store i64 1, ptr %261, align 8
  store i64 0, ptr %262, align 8
  br label %527

527:                                              ; preds = %526, %406
  %528 = load i64, ptr %263, align 8
  %529 = icmp eq i64 %528, 0
  br i1 %529, label %533, label %530

530:                                              ; preds = %527
  %531 = load double, ptr %82, align 8
  %532 = fcmp une double %398, %531
  br i1 %532, label %533, label %596

533:                                              ; preds = %530, %527
  %534 = load i64, ptr %264, align 8
  %535 = add nsw i64 %534, 1
  store i64 %535, ptr %264, align 8
  %536 = load i64, ptr %266, align 8
  %537 = load ptr, ptr %267, align 8
  %538 = load ptr, ptr %268, align 8
  %539 = icmp sgt i64 %536, 0
  br i1 %539, label %540, label %548

540:                                              ; preds = %533
  %541 = fdiv double 0x400D1A48D83E731D, %398
  %542 = add nuw i64 %536, 1
  %543 = fdiv double 0x400572DB93E0C672, %398
  %544 = fdiv double 0x40086747F2C3FCB6, %398
  br label %545

545:                                              ; preds = %540, %552
  %546 = phi i64 [ 0, %540 ], [ %563, %552 ]
  %547 = mul nuw nsw i64 %546, %536
  br label %565

548:                                              ; preds = %552, %533
  %549 = load ptr, ptr %265, align 8
  %550 = tail call fastcc i32 @real_factorise(ptr noundef %537, i64 noundef %536, ptr noundef %549) #10
  %551 = icmp eq i32 %550, 0
  br i1 %551, label %586, label %581

552:                                              ; preds = %565
  %553 = mul i64 %546, %542
  %554 = getelementptr inbounds double, ptr %537, i64 %553
  %555 = load double, ptr %554, align 8
  %556 = fadd double %541, %555
  store double %556, ptr %554, align 8
  %557 = getelementptr inbounds { double, double }, ptr %538, i64 %553
  %558 = load double, ptr %557, align 8
  %559 = getelementptr inbounds i8, ptr %557, i64 8
  %560 = load double, ptr %559, align 8
  %561 = fadd double %543, %558
  %562 = fsub double %560, %544
  store double %561, ptr %557, align 8
  store double %562, ptr %559, align 8
  %563 = add nuw nsw i64 %546, 1
  %564 = icmp eq i64 %563, %536
  br i1 %564, label %548, label %545, !llvm.loop !15

565:                                              ; preds = %545, %565
  %566 = phi i64 [ 0, %545 ], [ %579, %565 ]
  %567 = load ptr, ptr %269, align 8
  %568 = add nuw nsw i64 %566, %547
  %569 = getelementptr inbounds double, ptr %567, i64 %568
  %570 = load double, ptr %569, align 8
  %571 = fneg double %570
  %572 = getelementptr inbounds double, ptr %537, i64 %568
  store double %571, ptr %572, align 8
  %573 = load ptr, ptr %269, align 8
  %574 = getelementptr inbounds double, ptr %573, i64 %568
  %575 = load double, ptr %574, align 8
  %576 = fneg double %575
  %577 = getelementptr inbounds { double, double }, ptr %538, i64 %568
  %578 = getelementptr inbounds i8, ptr %577, i64 8
  store double %576, ptr %577, align 8
  store double 0.000000e+00, ptr %578, align 8
  %579 = add nuw nsw i64 %566, 1
  %580 = icmp eq i64 %579, %536
  br i1 %580, label %552, label %565, !llvm.loop !16

581:                                              ; preds = %548
  %582 = load ptr, ptr %270, align 8
  %583 = tail call fastcc i32 @pair_factorise(ptr noundef %538, i64 noundef %536, ptr noundef %582) #10
  %584 = icmp ne i32 %583, 0
  %585 = zext i1 %584 to i32
  br label %586

586:                                              ; preds = %548, %581
  %587 = phi i32 [ 0, %548 ], [ %585, %581 ]
  %588 = icmp eq i32 %587, 0
  br i1 %588, label %589, label %595

589:                                              ; preds = %586
  store i64 4, ptr %355, align 8
  %590 = load i64, ptr %242, align 8
  %591 = add nsw i64 %590, 1
  store i64 %591, ptr %242, align 8
  %592 = fmul double %398, 5.000000e-01
  %593 = load i64, ptr %356, align 8
  %594 = sub nsw i64 1, %593
  store i64 %594, ptr %245, align 8
  store i64 0, ptr %263, align 8
  br label %1768, !llvm.loop !17

595:                                              ; preds = %586
  store i64 1, ptr %263, align 8
  store double %398, ptr %82, align 8
  br label %596

596:                                              ; preds = %595, %530
  %597 = load double, ptr %271, align 8
  %598 = load ptr, ptr %76, align 8
  %599 = getelementptr inbounds i8, ptr %598, i64 8
  %600 = load i64, ptr %599, align 8
  %601 = load ptr, ptr %272, align 8
  %602 = load ptr, ptr %77, align 8
  %603 = load ptr, ptr %273, align 8
  %604 = load ptr, ptr %274, align 8
  %605 = fcmp ogt double %597, 0.000000e+00
  %606 = icmp sgt i64 %600, 0
  %607 = shl i64 %600, 4
  %608 = getelementptr i8, ptr %601, i64 %607
  %609 = mul i64 %600, 24
  %610 = getelementptr i8, ptr %601, i64 %609
  %611 = getelementptr double, ptr %601, i64 %600
  br label %617

612:                                              ; preds = %631
  %613 = icmp sgt i64 %600, 0
  %614 = getelementptr double, ptr %603, i64 %600
  %615 = shl i64 %600, 4
  %616 = getelementptr i8, ptr %603, i64 %615
  br label %658

617:                                              ; preds = %596, %631
  %618 = phi i64 [ 0, %596 ], [ %632, %631 ]
  br i1 %605, label %619, label %625

619:                                              ; preds = %617
  %620 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %618
  %621 = load double, ptr %620, align 8
  %622 = fmul double %398, %621
  %623 = fdiv double %622, %597
  %624 = fadd double %623, 1.000000e+00
  br label %625

625:                                              ; preds = %619, %617
  %626 = phi double [ %624, %619 ], [ 0.000000e+00, %617 ]
  br i1 %606, label %627, label %631

627:                                              ; preds = %625
  %628 = mul nuw nsw i64 %600, %618
  %629 = getelementptr double, ptr %603, i64 %628
  %630 = fsub double 1.000000e+00, %626
  br label %634

631:                                              ; preds = %655, %625
  %632 = add nuw nsw i64 %618, 1
  %633 = icmp eq i64 %632, 3
  br i1 %633, label %612, label %617, !llvm.loop !18

634:                                              ; preds = %627, %655
  %635 = phi i64 [ 0, %627 ], [ %656, %655 ]
  %636 = getelementptr double, ptr %629, i64 %635
  store double 0.000000e+00, ptr %636, align 8
  br i1 %605, label %637, label %655

637:                                              ; preds = %634
  %638 = getelementptr double, ptr %608, i64 %635
  %639 = load double, ptr %638, align 8
  %640 = getelementptr double, ptr %610, i64 %635
  %641 = load double, ptr %640, align 8
  %642 = fmul double %626, %641
  %643 = fadd double %639, %642
  %644 = fmul double %630, %643
  %645 = getelementptr inbounds double, ptr %601, i64 %635
  %646 = load double, ptr %645, align 8
  %647 = getelementptr double, ptr %611, i64 %635
  %648 = load double, ptr %647, align 8
  %649 = fadd double %648, %644
  %650 = fmul double %626, %649
  %651 = fadd double %646, %650
  %652 = getelementptr inbounds double, ptr %602, i64 %635
  %653 = load double, ptr %652, align 8
  %654 = fsub double %651, %653
  store double %654, ptr %636, align 8
  br label %655

655:                                              ; preds = %637, %634
  %656 = add nuw nsw i64 %635, 1
  %657 = icmp eq i64 %656, %600
  br i1 %657, label %631, label %634, !llvm.loop !19

658:                                              ; preds = %612, %669
  %659 = phi i64 [ 0, %612 ], [ %670, %669 ]
  br i1 %613, label %660, label %669

660:                                              ; preds = %658
  %661 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %659
  %662 = load double, ptr %661, align 8
  %663 = getelementptr inbounds i8, ptr %661, i64 8
  %664 = load double, ptr %663, align 8
  %665 = getelementptr inbounds i8, ptr %661, i64 16
  %666 = load double, ptr %665, align 8
  %667 = mul nuw nsw i64 %600, %659
  %668 = getelementptr double, ptr %604, i64 %667
  br label %672

669:                                              ; preds = %672, %658
  %670 = add nuw nsw i64 %659, 1
  %671 = icmp eq i64 %670, 3
  br i1 %671, label %688, label %658, !llvm.loop !20

672:                                              ; preds = %660, %672
  %673 = phi i64 [ 0, %660 ], [ %686, %672 ]
  %674 = getelementptr inbounds double, ptr %603, i64 %673
  %675 = load double, ptr %674, align 8
  %676 = fmul double %662, %675
  %677 = getelementptr double, ptr %614, i64 %673
  %678 = load double, ptr %677, align 8
  %679 = fmul double %664, %678
  %680 = fadd double %676, %679
  %681 = getelementptr double, ptr %616, i64 %673
  %682 = load double, ptr %681, align 8
  %683 = fmul double %666, %682
  %684 = fadd double %680, %683
  %685 = getelementptr double, ptr %668, i64 %673
  store double %684, ptr %685, align 8
  %686 = add nuw nsw i64 %673, 1
  %687 = icmp eq i64 %686, %600
  br i1 %687, label %669, label %672, !llvm.loop !21

688:                                              ; preds = %669
  %689 = load ptr, ptr %76, align 8, !noalias !22
  %690 = getelementptr inbounds i8, ptr %689, i64 8
  %691 = load i64, ptr %690, align 8, !noalias !22
  %692 = load ptr, ptr %78, align 8, !noalias !22
  %693 = getelementptr inbounds i8, ptr %692, i64 40
  %694 = load i64, ptr %693, align 8, !noalias !22
  %695 = load ptr, ptr %273, align 8, !noalias !22
  %696 = load ptr, ptr %274, align 8, !noalias !22
  %697 = load ptr, ptr %276, align 8, !noalias !22
  %698 = load ptr, ptr %277, align 8, !noalias !22
  %699 = load ptr, ptr %278, align 8, !noalias !22
  %700 = icmp sgt i64 %694, 0
  %701 = select i1 %700, i64 10, i64 6
  %702 = icmp sgt i64 %691, 0
  %703 = fdiv double 0x400D1A48D83E731D, %398
  %704 = fdiv double 0x400572DB93E0C672, %398
  %705 = fdiv double 0xC0086747F2C3FCB6, %398
  %706 = icmp sgt i64 %691, 0
  %707 = getelementptr double, ptr %696, i64 %691
  %708 = shl i64 %691, 4
  %709 = getelementptr i8, ptr %696, i64 %708
  %710 = icmp eq i64 %694, 0
  br label %711

711:                                              ; preds = %688, %1114
  %712 = phi double [ -1.000000e+00, %688 ], [ %1113, %1114 ]
  %713 = phi double [ 0.000000e+00, %688 ], [ %1112, %1114 ]
  %714 = phi i64 [ 0, %688 ], [ %1111, %1114 ]
  %715 = phi i64 [ 0, %688 ], [ %1115, %1114 ]
  %716 = phi i64 [ %364, %688 ], [ %1108, %1114 ]
  %717 = phi i64 [ %365, %688 ], [ %1107, %1114 ]
  %718 = phi i32 [ %366, %688 ], [ %1106, %1114 ]
  %719 = phi double [ %367, %688 ], [ %1105, %1114 ]
  %720 = icmp ugt i64 %715, 5
  %721 = icmp eq i64 %714, 0
  %722 = select i1 %720, i1 %721, i1 false
  br i1 %722, label %1117, label %727

723:                                              ; preds = %749
  %724 = add nuw nsw i64 %728, 1
  %725 = icmp ugt i64 %728, 1
  %726 = icmp eq i64 %724, 3
  br i1 %726, label %772, label %727, !llvm.loop !25

727:                                              ; preds = %711, %723
  %728 = phi i64 [ %724, %723 ], [ 0, %711 ]
  %729 = phi i1 [ %725, %723 ], [ false, %711 ]
  br i1 %702, label %730, label %733

730:                                              ; preds = %727
  %731 = mul nuw nsw i64 %691, %728
  %732 = getelementptr double, ptr %695, i64 %731
  br label %758

733:                                              ; preds = %758, %727
  %734 = load ptr, ptr %83, align 8, !noalias !22
  %735 = getelementptr inbounds i8, ptr %734, i64 24
  %736 = load i64, ptr %735, align 8, !noalias !22
  %737 = add nsw i64 %736, 1
  store i64 %737, ptr %735, align 8, !noalias !22
  %738 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %728
  %739 = load double, ptr %738, align 8, !noalias !22
  %740 = fmul double %398, %739
  %741 = fadd double %362, %740
  %742 = load ptr, ptr %279, align 8, !noalias !22
  %743 = mul nsw i64 %691, %728
  %744 = getelementptr inbounds double, ptr %697, i64 %743
  %745 = load ptr, ptr %280, align 8, !noalias !22
  store double %741, ptr %745, align 8, !noalias !22
  %746 = load i64, ptr %281, align 8, !noalias !22
  %747 = icmp sgt i64 %746, 0
  br i1 %747, label %748, label %749

748:                                              ; preds = %733
  tail call fastcc void @sample(ptr noundef nonnull %76) #10, !noalias !22
  br label %749

749:                                              ; preds = %733, %748
  %750 = load ptr, ptr %76, align 8, !noalias !22
  %751 = load i64, ptr %750, align 8, !noalias !22
  %752 = load ptr, ptr %280, align 8, !noalias !22
  %753 = load ptr, ptr %283, align 8, !noalias !22
  %754 = load ptr, ptr %284, align 8, !noalias !22
  %755 = inttoptr i64 %751 to ptr
  %756 = tail call i32 %755(ptr noundef %752, ptr noundef %742, ptr noundef %753, ptr noundef %754, ptr noundef %744) #11, !noalias !22
  %757 = icmp eq i32 %756, 0
  br i1 %757, label %723, label %770

758:                                              ; preds = %730, %758
  %759 = phi i64 [ 0, %730 ], [ %768, %758 ]
  %760 = load ptr, ptr %77, align 8, !noalias !22
  %761 = getelementptr inbounds double, ptr %760, i64 %759
  %762 = load double, ptr %761, align 8, !noalias !22
  %763 = getelementptr double, ptr %732, i64 %759
  %764 = load double, ptr %763, align 8, !noalias !22
  %765 = fadd double %762, %764
  %766 = load ptr, ptr %282, align 8, !noalias !22
  %767 = getelementptr inbounds double, ptr %766, i64 %759
  store double %765, ptr %767, align 8, !noalias !22
  %768 = add nuw nsw i64 %759, 1
  %769 = icmp eq i64 %768, %691
  br i1 %769, label %733, label %758, !llvm.loop !26

770:                                              ; preds = %749
  %771 = sext i32 %756 to i64
  br label %772

772:                                              ; preds = %723, %770
  %773 = phi i1 [ %729, %770 ], [ %725, %723 ]
  %774 = phi double [ 0.000000e+00, %770 ], [ %719, %723 ]
  %775 = phi i32 [ 0, %770 ], [ %718, %723 ]
  %776 = phi i64 [ %715, %770 ], [ %717, %723 ]
  %777 = phi i64 [ %771, %770 ], [ %716, %723 ]
  %778 = phi i32 [ 1, %770 ], [ 5, %723 ]
  br i1 %773, label %779, label %1117

779:                                              ; preds = %772
  %780 = load ptr, ptr %76, align 8, !noalias !22
  %781 = getelementptr inbounds i8, ptr %780, i64 8
  %782 = load i64, ptr %781, align 8, !noalias !22
  %783 = load ptr, ptr %276, align 8, !noalias !22
  %784 = load ptr, ptr %274, align 8, !noalias !22
  %785 = load ptr, ptr %277, align 8, !noalias !22
  %786 = load ptr, ptr %278, align 8, !noalias !22
  %787 = icmp sgt i64 %782, 0
  br i1 %787, label %788, label %893

788:                                              ; preds = %779
  %789 = shl nuw nsw i64 %782, 1
  %790 = getelementptr double, ptr %783, i64 %782
  %791 = shl i64 %782, 4
  %792 = getelementptr i8, ptr %783, i64 %791
  %793 = load double, ptr %783, align 8, !noalias !22
  %794 = getelementptr inbounds double, ptr %783, i64 %782
  %795 = load double, ptr %794, align 8, !noalias !22
  %796 = fadd double %793, %795
  %797 = getelementptr inbounds double, ptr %783, i64 %789
  %798 = load double, ptr %797, align 8, !noalias !22
  %799 = fadd double %796, %798
  %800 = tail call double @llvm.fabs.f64(double %799)
  %801 = fcmp ueq double %800, 0x7FF0000000000000
  br i1 %801, label %890, label %802

802:                                              ; preds = %788
  %803 = getelementptr double, ptr %784, i64 %782
  %804 = getelementptr inbounds double, ptr %784, i64 %789
  %805 = getelementptr double, ptr %783, i64 %782
  %806 = getelementptr inbounds double, ptr %783, i64 %789
  br label %818

807:                                              ; preds = %818
  %808 = getelementptr inbounds double, ptr %783, i64 %886
  %809 = load double, ptr %808, align 8, !noalias !22
  %810 = getelementptr double, ptr %805, i64 %886
  %811 = load double, ptr %810, align 8, !noalias !22
  %812 = fadd double %809, %811
  %813 = getelementptr inbounds double, ptr %806, i64 %886
  %814 = load double, ptr %813, align 8, !noalias !22
  %815 = fadd double %812, %814
  %816 = tail call double @llvm.fabs.f64(double %815)
  %817 = fcmp ueq double %816, 0x7FF0000000000000
  br i1 %817, label %888, label %818, !llvm.loop !27

818:                                              ; preds = %802, %807
  %819 = phi double [ %809, %807 ], [ %793, %802 ]
  %820 = phi double [ %885, %807 ], [ 0.000000e+00, %802 ]
  %821 = phi i64 [ %886, %807 ], [ 0, %802 ]
  %822 = getelementptr inbounds double, ptr %783, i64 %821
  %823 = fmul double %819, 0x4010B70201A79C46
  %824 = getelementptr double, ptr %790, i64 %821
  %825 = load double, ptr %824, align 8, !noalias !22
  %826 = fmul double %825, 0x3FD4F8C15DA84E86
  %827 = fadd double %823, %826
  %828 = getelementptr double, ptr %792, i64 %821
  %829 = load double, ptr %828, align 8, !noalias !22
  %830 = fmul double %829, 0x3FE0BF7FF59D56EF
  %831 = fadd double %827, %830
  %832 = getelementptr inbounds double, ptr %784, i64 %821
  %833 = load double, ptr %832, align 8, !noalias !22
  %834 = fmul double %703, %833
  %835 = fsub double %831, %834
  %836 = getelementptr inbounds double, ptr %785, i64 %821
  store double %835, ptr %836, align 8, !noalias !22
  %837 = load double, ptr %822, align 8, !noalias !22
  %838 = fmul double %837, 0xC010B70201A79C46
  %839 = load double, ptr %824, align 8, !noalias !22
  %840 = fmul double %839, 0x3FD4F8C15DA84E86
  %841 = fsub double %838, %840
  %842 = load double, ptr %828, align 8, !noalias !22
  %843 = fmul double %842, 0x3FDE810014C55221
  %844 = fadd double %841, %843
  %845 = fmul double %837, 0x3FE017885A24A7F2
  %846 = fmul double %839, 0x4004934E6FCAA598
  %847 = fsub double %845, %846
  %848 = fmul double %842, 0x3FE312C0CF7BDFD1
  %849 = fadd double %847, %848
  %850 = getelementptr double, ptr %803, i64 %821
  %851 = load double, ptr %850, align 8, !noalias !22
  %852 = getelementptr inbounds double, ptr %804, i64 %821
  %853 = load double, ptr %852, align 8, !noalias !22
  %854 = fmul double %704, %851
  %855 = fmul double %705, %853
  %856 = fmul double %704, %853
  %857 = fmul double %705, %851
  %858 = fsub double %854, %855
  %859 = fadd double %857, %856
  %860 = fsub double %844, %858
  %861 = fsub double %849, %859
  %862 = getelementptr inbounds { double, double }, ptr %786, i64 %821
  %863 = getelementptr inbounds i8, ptr %862, i64 8
  store double %860, ptr %862, align 8, !noalias !22
  store double %861, ptr %863, align 8, !noalias !22
  %864 = load double, ptr %836, align 8, !noalias !22
  %865 = tail call double @llvm.fabs.f64(double %864)
  %866 = tail call double @llvm.fabs.f64(double %860)
  %867 = fadd double %865, %866
  %868 = tail call double @llvm.fabs.f64(double %861)
  %869 = fadd double %868, %867
  %870 = fmul double %398, %869
  %871 = load ptr, ptr %77, align 8, !noalias !22
  %872 = getelementptr inbounds double, ptr %871, i64 %821
  %873 = load double, ptr %872, align 8, !noalias !22
  %874 = load ptr, ptr %285, align 8, !noalias !22
  %875 = getelementptr inbounds double, ptr %874, i64 %821
  %876 = load double, ptr %875, align 8, !noalias !22
  %877 = load ptr, ptr %286, align 8, !noalias !22
  %878 = getelementptr inbounds double, ptr %877, i64 %821
  %879 = load double, ptr %878, align 8, !noalias !22
  %880 = tail call double @llvm.fabs.f64(double %873)
  %881 = fmul double %880, %879
  %882 = fadd double %876, %881
  %883 = fdiv double %870, %882
  %884 = fmul double %883, %883
  %885 = fadd double %820, %884
  %886 = add nuw nsw i64 %821, 1
  %887 = icmp eq i64 %886, %782
  br i1 %887, label %893, label %807, !llvm.loop !27

888:                                              ; preds = %807
  %889 = icmp slt i64 %886, %782
  br label %890

890:                                              ; preds = %888, %788
  %891 = phi i1 [ %889, %888 ], [ %787, %788 ]
  %892 = phi double [ %885, %888 ], [ 0.000000e+00, %788 ]
  br i1 %891, label %1117, label %893

893:                                              ; preds = %818, %779, %890
  %894 = phi double [ %892, %890 ], [ 0.000000e+00, %779 ], [ %885, %818 ]
  %895 = load ptr, ptr %76, align 8, !noalias !22
  %896 = getelementptr inbounds i8, ptr %895, i64 8
  %897 = load i64, ptr %896, align 8, !noalias !22
  %898 = load i64, ptr %288, align 8, !noalias !22
  %899 = load ptr, ptr %78, align 8, !noalias !22
  %900 = getelementptr inbounds i8, ptr %899, i64 40
  %901 = load i64, ptr %900, align 8, !noalias !22
  %902 = load ptr, ptr %277, align 8, !noalias !22
  %903 = load ptr, ptr %278, align 8, !noalias !22
  %904 = load ptr, ptr %289, align 8, !noalias !22
  %905 = load ptr, ptr %287, align 8, !noalias !22
  tail call fastcc void @real_solve(ptr noundef %904, i64 noundef %898, ptr noundef %905, ptr noundef %902) #10, !noalias !22
  %906 = load ptr, ptr %290, align 8, !noalias !22
  %907 = load ptr, ptr %291, align 8, !noalias !22
  tail call fastcc void @pair_solve(ptr noundef %906, i64 noundef %898, ptr noundef %907, ptr noundef %903) #10, !noalias !22
  %908 = icmp sgt i64 %901, 0
  br i1 %908, label %909, label %914

909:                                              ; preds = %893
  %910 = load ptr, ptr %289, align 8, !noalias !22
  %911 = load ptr, ptr %287, align 8, !noalias !22
  tail call fastcc void @real_solve_columns(ptr noundef %910, i64 noundef %898, ptr noundef %911, ptr noundef %902, i64 noundef %901) #10, !noalias !22
  %912 = load ptr, ptr %290, align 8, !noalias !22
  %913 = load ptr, ptr %291, align 8, !noalias !22
  tail call fastcc void @pair_solve_columns(ptr noundef %912, i64 noundef %898, ptr noundef %913, ptr noundef %903, i64 noundef %901) #10, !noalias !22
  br label %914

914:                                              ; preds = %909, %893
  %915 = icmp sgt i64 %897, 0
  br i1 %915, label %916, label %949

916:                                              ; preds = %914
  %917 = load ptr, ptr %77, align 8, !noalias !22
  %918 = load ptr, ptr %292, align 8, !noalias !22
  %919 = load ptr, ptr %293, align 8, !noalias !22
  br label %920

920:                                              ; preds = %916, %920
  %921 = phi double [ 0.000000e+00, %916 ], [ %946, %920 ]
  %922 = phi i64 [ 0, %916 ], [ %947, %920 ]
  %923 = getelementptr inbounds double, ptr %917, i64 %922
  %924 = load double, ptr %923, align 8, !noalias !22
  %925 = getelementptr inbounds double, ptr %918, i64 %922
  %926 = load double, ptr %925, align 8, !noalias !22
  %927 = getelementptr inbounds double, ptr %919, i64 %922
  %928 = load double, ptr %927, align 8, !noalias !22
  %929 = tail call double @llvm.fabs.f64(double %924)
  %930 = fmul double %929, %928
  %931 = fadd double %926, %930
  %932 = getelementptr inbounds double, ptr %902, i64 %922
  %933 = load double, ptr %932, align 8, !noalias !22
  %934 = fdiv double %933, %931
  %935 = getelementptr inbounds { double, double }, ptr %903, i64 %922
  %936 = load double, ptr %935, align 8, !noalias !22
  %937 = getelementptr inbounds i8, ptr %935, i64 8
  %938 = fdiv double %936, %931
  %939 = load double, ptr %937, align 8, !noalias !22
  %940 = fdiv double %939, %931
  %941 = fmul double %934, %934
  %942 = fmul double %938, %938
  %943 = fadd double %941, %942
  %944 = fmul double %940, %940
  %945 = fadd double %943, %944
  %946 = fadd double %921, %945
  %947 = add nuw nsw i64 %922, 1
  %948 = icmp eq i64 %947, %897
  br i1 %948, label %949, label %920, !llvm.loop !28

949:                                              ; preds = %920, %914
  %950 = phi double [ 0.000000e+00, %914 ], [ %946, %920 ]
  %951 = mul nsw i64 %897, 3
  %952 = sitofp i64 %951 to double
  %953 = fdiv double %950, %952
  %954 = tail call double @llvm.sqrt.f64(double %953)
  %955 = fcmp oeq double %954, 0.000000e+00
  %956 = fcmp ogt double %894, 0.000000e+00
  %957 = select i1 %955, i1 %956, i1 false
  br i1 %957, label %958, label %960

958:                                              ; preds = %949
  %959 = add nuw nsw i64 %715, 1
  br label %1104

960:                                              ; preds = %949
  %961 = fcmp ogt double %712, 0.000000e+00
  %962 = select i1 %961, i1 %721, i1 false
  br i1 %962, label %963, label %976

963:                                              ; preds = %960
  %964 = fdiv double %954, %712
  %965 = fcmp ult double %964, 1.000000e+00
  br i1 %965, label %966, label %974

966:                                              ; preds = %963
  %967 = sub nsw i64 5, %715
  %968 = sitofp i64 %967 to double
  %969 = tail call double @llvm.pow.f64(double %964, double %968)
  %970 = fsub double 1.000000e+00, %964
  %971 = fdiv double %969, %970
  %972 = fmul double %954, %971
  %973 = fcmp ogt double %972, %122
  br i1 %973, label %974, label %976

974:                                              ; preds = %966, %963
  %975 = add nuw nsw i64 %715, 1
  br label %1104

976:                                              ; preds = %966, %960
  %977 = phi double [ %713, %960 ], [ %964, %966 ]
  br i1 %706, label %989, label %978

978:                                              ; preds = %1007, %976
  %979 = fsub double 1.000000e+00, %977
  %980 = fdiv double %977, %979
  %981 = fmul double %954, %980
  %982 = fcmp olt double %981, %122
  %983 = select i1 %961, i1 %982, i1 false
  %984 = select i1 %955, i1 true, i1 %983
  %985 = add nuw nsw i64 %715, 1
  %986 = select i1 %984, i64 %985, i64 0
  %987 = select i1 %721, i64 %986, i64 %714
  %988 = icmp sgt i64 %987, 0
  br i1 %988, label %1030, label %1103

989:                                              ; preds = %976, %1007
  %990 = phi i64 [ %1008, %1007 ], [ 0, %976 ]
  %991 = getelementptr inbounds double, ptr %698, i64 %990
  %992 = load double, ptr %991, align 8, !noalias !22
  %993 = getelementptr inbounds double, ptr %696, i64 %990
  %994 = load double, ptr %993, align 8, !noalias !22
  %995 = fadd double %992, %994
  store double %995, ptr %993, align 8, !noalias !22
  %996 = getelementptr inbounds { double, double }, ptr %699, i64 %990
  %997 = load double, ptr %996, align 8, !noalias !22
  %998 = getelementptr inbounds i8, ptr %996, i64 8
  %999 = getelementptr double, ptr %707, i64 %990
  %1000 = load double, ptr %999, align 8, !noalias !22
  %1001 = fadd double %997, %1000
  store double %1001, ptr %999, align 8, !noalias !22
  %1002 = load double, ptr %998, align 8, !noalias !22
  %1003 = getelementptr double, ptr %709, i64 %990
  %1004 = load double, ptr %1003, align 8, !noalias !22
  %1005 = fadd double %1002, %1004
  store double %1005, ptr %1003, align 8, !noalias !22
  %1006 = getelementptr double, ptr %695, i64 %990
  br label %1010

1007:                                             ; preds = %1010
  %1008 = add nuw nsw i64 %990, 1
  %1009 = icmp eq i64 %1008, %691
  br i1 %1009, label %978, label %989, !llvm.loop !29

1010:                                             ; preds = %989, %1010
  %1011 = phi i64 [ 0, %989 ], [ %1028, %1010 ]
  %1012 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1011
  %1013 = load double, ptr %1012, align 8, !noalias !22
  %1014 = load double, ptr %993, align 8, !noalias !22
  %1015 = fmul double %1013, %1014
  %1016 = getelementptr inbounds i8, ptr %1012, i64 8
  %1017 = load double, ptr %1016, align 8, !noalias !22
  %1018 = load double, ptr %999, align 8, !noalias !22
  %1019 = fmul double %1017, %1018
  %1020 = fadd double %1015, %1019
  %1021 = getelementptr inbounds i8, ptr %1012, i64 16
  %1022 = load double, ptr %1021, align 8, !noalias !22
  %1023 = load double, ptr %1003, align 8, !noalias !22
  %1024 = fmul double %1022, %1023
  %1025 = fadd double %1020, %1024
  %1026 = mul nuw nsw i64 %691, %1011
  %1027 = getelementptr double, ptr %1006, i64 %1026
  store double %1025, ptr %1027, align 8, !noalias !22
  %1028 = add nuw nsw i64 %1011, 1
  %1029 = icmp eq i64 %1028, 3
  br i1 %1029, label %1007, label %1010, !llvm.loop !30

1030:                                             ; preds = %978
  br i1 %710, label %1104, label %1031

1031:                                             ; preds = %1030
  %1032 = load i64, ptr %294, align 8, !noalias !22
  %1033 = load ptr, ptr %78, align 8, !noalias !22
  %1034 = getelementptr inbounds i8, ptr %1033, i64 40
  %1035 = load i64, ptr %1034, align 8, !noalias !22
  %1036 = load ptr, ptr %297, align 8, !noalias !22
  %1037 = load ptr, ptr %295, align 8, !noalias !22
  %1038 = load ptr, ptr %298, align 8, !noalias !22
  %1039 = icmp sgt i64 %1035, 0
  br i1 %1039, label %1040, label %1100

1040:                                             ; preds = %1031
  %1041 = load i64, ptr %296, align 8, !noalias !22
  %1042 = icmp sgt i64 %1032, 0
  %1043 = getelementptr double, ptr %1037, i64 %1041
  %1044 = shl i64 %1041, 4
  %1045 = getelementptr i8, ptr %1037, i64 %1044
  br label %1046

1046:                                             ; preds = %1040, %1096
  %1047 = phi double [ 0.000000e+00, %1040 ], [ %1097, %1096 ]
  %1048 = phi i64 [ 0, %1040 ], [ %1098, %1096 ]
  br i1 %1042, label %1049, label %1052

1049:                                             ; preds = %1046
  %1050 = add nuw i64 %1048, %1032
  %1051 = load ptr, ptr %77, align 8, !noalias !22
  br label %1057

1052:                                             ; preds = %1057, %1046
  %1053 = phi double [ 0.000000e+00, %1046 ], [ %1089, %1057 ]
  %1054 = phi double [ 0.000000e+00, %1046 ], [ %1073, %1057 ]
  %1055 = fmul double %1047, %1053
  %1056 = fcmp ogt double %1054, %1055
  br i1 %1056, label %1092, label %1096

1057:                                             ; preds = %1049, %1057
  %1058 = phi double [ 0.000000e+00, %1049 ], [ %1073, %1057 ]
  %1059 = phi double [ 0.000000e+00, %1049 ], [ %1089, %1057 ]
  %1060 = phi i64 [ 0, %1049 ], [ %1090, %1057 ]
  %1061 = mul nuw nsw i64 %1060, %1035
  %1062 = add i64 %1050, %1061
  %1063 = getelementptr inbounds double, ptr %1036, i64 %1062
  %1064 = load double, ptr %1063, align 8, !noalias !22
  %1065 = fmul double %1064, %1064
  %1066 = getelementptr inbounds { double, double }, ptr %1038, i64 %1062
  %1067 = load double, ptr %1066, align 8, !noalias !22
  %1068 = getelementptr inbounds i8, ptr %1066, i64 8
  %1069 = load double, ptr %1068, align 8, !noalias !22
  %1070 = tail call double @hypot(double noundef %1067, double noundef %1069) #13
  %1071 = fmul double %1070, %1070
  %1072 = fadd double %1065, %1071
  %1073 = fadd double %1058, %1072
  %1074 = getelementptr inbounds double, ptr %1051, i64 %1062
  %1075 = load double, ptr %1074, align 8, !noalias !22
  %1076 = fmul double %1075, %1075
  %1077 = fadd double %1059, %1076
  %1078 = getelementptr inbounds double, ptr %1037, i64 %1062
  %1079 = load double, ptr %1078, align 8, !noalias !22
  %1080 = fmul double %1079, %1079
  %1081 = getelementptr double, ptr %1043, i64 %1062
  %1082 = load double, ptr %1081, align 8, !noalias !22
  %1083 = fmul double %1082, %1082
  %1084 = fadd double %1080, %1083
  %1085 = getelementptr double, ptr %1045, i64 %1062
  %1086 = load double, ptr %1085, align 8, !noalias !22
  %1087 = fmul double %1086, %1086
  %1088 = fadd double %1084, %1087
  %1089 = fadd double %1077, %1088
  %1090 = add nuw nsw i64 %1060, 1
  %1091 = icmp eq i64 %1090, %1032
  br i1 %1091, label %1052, label %1057, !llvm.loop !31

1092:                                             ; preds = %1052
  %1093 = fcmp ogt double %1053, 0.000000e+00
  %1094 = fdiv double %1054, %1053
  %1095 = select i1 %1093, double %1094, double 1.000000e+00
  br label %1096

1096:                                             ; preds = %1092, %1052
  %1097 = phi double [ %1095, %1092 ], [ %1047, %1052 ]
  %1098 = add nuw nsw i64 %1048, 1
  %1099 = icmp eq i64 %1098, %1035
  br i1 %1099, label %1100, label %1046, !llvm.loop !32

1100:                                             ; preds = %1096, %1031
  %1101 = phi double [ 0.000000e+00, %1031 ], [ %1097, %1096 ]
  %1102 = fcmp ugt double %1101, %299
  br i1 %1102, label %1103, label %1104

1103:                                             ; preds = %1100, %978
  br label %1104

1104:                                             ; preds = %1103, %1100, %1030, %974, %958
  %1105 = phi double [ %713, %958 ], [ %964, %974 ], [ %774, %1030 ], [ %774, %1103 ], [ %774, %1100 ]
  %1106 = phi i32 [ 0, %958 ], [ 0, %974 ], [ %775, %1030 ], [ %775, %1103 ], [ %775, %1100 ]
  %1107 = phi i64 [ %959, %958 ], [ %975, %974 ], [ %776, %1030 ], [ %776, %1103 ], [ %776, %1100 ]
  %1108 = phi i64 [ 0, %958 ], [ 0, %974 ], [ %777, %1030 ], [ %777, %1103 ], [ %777, %1100 ]
  %1109 = phi i1 [ false, %958 ], [ false, %974 ], [ false, %1030 ], [ true, %1103 ], [ false, %1100 ]
  %1110 = phi i32 [ 1, %958 ], [ 1, %974 ], [ 2, %1030 ], [ 0, %1103 ], [ 2, %1100 ]
  %1111 = phi i64 [ %714, %958 ], [ 0, %974 ], [ %987, %1030 ], [ %987, %1103 ], [ %987, %1100 ]
  %1112 = phi double [ %713, %958 ], [ %964, %974 ], [ %977, %1030 ], [ %977, %1103 ], [ %977, %1100 ]
  %1113 = phi double [ %712, %958 ], [ %712, %974 ], [ %712, %1030 ], [ %954, %1103 ], [ %712, %1100 ]
  br i1 %1109, label %1114, label %1117

1114:                                             ; preds = %1104
  %1115 = add nuw nsw i64 %715, 1
  %1116 = icmp eq i64 %1115, %701
  br i1 %1116, label %1117, label %711, !llvm.loop !33

1117:                                             ; preds = %890, %1104, %772, %711, %1114
  %1118 = phi double [ %719, %711 ], [ %1105, %1104 ], [ %774, %772 ], [ %1105, %1114 ], [ 0x7FF0000000000000, %890 ]
  %1119 = phi i32 [ %718, %711 ], [ %1106, %1104 ], [ %775, %772 ], [ %1106, %1114 ], [ 0, %890 ]
  %1120 = phi i64 [ %717, %711 ], [ %1107, %1104 ], [ %776, %772 ], [ %1107, %1114 ], [ %715, %890 ]
  %1121 = phi i64 [ %716, %711 ], [ %1108, %1104 ], [ %777, %772 ], [ %1108, %1114 ], [ 0, %890 ]
  %1122 = phi i32 [ 2, %711 ], [ %1110, %1104 ], [ %778, %772 ], [ 2, %1114 ], [ 1, %890 ]
  %1123 = phi i64 [ 0, %711 ], [ %1111, %1104 ], [ %714, %772 ], [ %1111, %1114 ], [ %714, %890 ]
  %1124 = phi double [ %713, %711 ], [ %1112, %1104 ], [ %713, %772 ], [ %1112, %1114 ], [ %713, %890 ]
  %1125 = icmp eq i32 %1122, 2
  br i1 %1125, label %1126, label %1130

1126:                                             ; preds = %1117
  %1127 = icmp sgt i64 %1123, 0
  %1128 = select i1 %1127, i64 %1123, i64 6
  %1129 = zext i1 %1127 to i32
  br label %1130

1130:                                             ; preds = %1117, %1126
  %1131 = phi double [ %1124, %1126 ], [ %1118, %1117 ]
  %1132 = phi i32 [ %1129, %1126 ], [ %1119, %1117 ]
  %1133 = phi i64 [ %1128, %1126 ], [ %1120, %1117 ]
  %1134 = phi i64 [ 0, %1126 ], [ %1121, %1117 ]
  %1135 = icmp slt i64 %1134, 0
  br i1 %1135, label %1768, label %1136

1136:                                             ; preds = %1130
  %1137 = icmp eq i32 %1132, 0
  br i1 %1137, label %1139, label %1138

1138:                                             ; preds = %1136
  br i1 %300, label %1290, label %1189

1139:                                             ; preds = %1136
  %1140 = load i64, ptr %242, align 8
  %1141 = add nsw i64 %1140, 1
  store i64 %1141, ptr %242, align 8
  %1142 = tail call double @llvm.fabs.f64(double %1131)
  %1143 = fcmp ueq double %1142, 0x7FF0000000000000
  %1144 = select i1 %1143, i64 4, i64 7
  %1145 = icmp eq i64 %1134, 0
  %1146 = select i1 %1145, i64 %1144, i64 3
  store i64 %1146, ptr %351, align 8
  %1147 = load i64, ptr %352, align 8
  %1148 = icmp eq i64 %1147, 1
  %1149 = and i1 %1145, %1148
  br i1 %1149, label %1150, label %1176

1150:                                             ; preds = %1139
  %1151 = load i64, ptr %354, align 8
  %1152 = icmp sgt i64 %1151, 0
  br i1 %1152, label %1153, label %1170

1153:                                             ; preds = %1150, %1162
  %1154 = phi i64 [ %1167, %1162 ], [ 0, %1150 ]
  %1155 = phi i32 [ %1164, %1162 ], [ 0, %1150 ]
  %1156 = icmp eq i32 %1155, 0
  br i1 %1156, label %1157, label %1162

1157:                                             ; preds = %1153
  %1158 = load ptr, ptr %353, align 8
  %1159 = getelementptr inbounds double, ptr %1158, i64 %1154
  %1160 = load double, ptr %1159, align 8
  %1161 = fcmp une double %1160, 0.000000e+00
  br label %1162

1162:                                             ; preds = %1157, %1153
  %1163 = phi i1 [ true, %1153 ], [ %1161, %1157 ]
  %1164 = zext i1 %1163 to i32
  %1165 = load ptr, ptr %353, align 8
  %1166 = getelementptr inbounds double, ptr %1165, i64 %1154
  store double 0.000000e+00, ptr %1166, align 8
  %1167 = add nuw nsw i64 %1154, 1
  %1168 = load i64, ptr %354, align 8
  %1169 = icmp slt i64 %1167, %1168
  br i1 %1169, label %1153, label %1170, !llvm.loop !34

1170:                                             ; preds = %1162, %1150
  %1171 = phi i32 [ 0, %1150 ], [ %1164, %1162 ]
  %1172 = icmp eq i32 %1171, 0
  br i1 %1172, label %1174, label %1173

1173:                                             ; preds = %1170
  store i64 0, ptr %263, align 8
  br label %1768, !llvm.loop !17

1174:                                             ; preds = %1170
  store i64 0, ptr %352, align 8
  %1175 = fmul double %398, 5.000000e-01
  br label %1176

1176:                                             ; preds = %1174, %1139
  %1177 = phi double [ %1175, %1174 ], [ %363, %1139 ]
  %1178 = load i64, ptr %352, align 8
  %1179 = icmp eq i64 %1178, 1
  %1180 = icmp ne i64 %1134, 0
  %1181 = or i1 %1180, %1179
  br i1 %1181, label %1182, label %1185

1182:                                             ; preds = %1176
  %1183 = select i1 %1145, double 5.000000e-01, double 2.500000e-01
  %1184 = fmul double %398, %1183
  store double 0.000000e+00, ptr %271, align 8
  br label %1185

1185:                                             ; preds = %1176, %1182
  %1186 = phi double [ %1184, %1182 ], [ %1177, %1176 ]
  %1187 = load i64, ptr %352, align 8
  %1188 = sub nsw i64 1, %1187
  store i64 %1188, ptr %245, align 8
  br label %1768, !llvm.loop !17

1189:                                             ; preds = %1290, %1138
  %1190 = load i64, ptr %303, align 8
  %1191 = icmp eq i64 %1190, 1
  %1192 = load ptr, ptr %76, align 8
  %1193 = getelementptr inbounds i8, ptr %1192, i64 8
  %1194 = load i64, ptr %1193, align 8
  %1195 = load i64, ptr %305, align 8
  %1196 = load ptr, ptr %306, align 8
  %1197 = load ptr, ptr %277, align 8
  %1198 = icmp sgt i64 %1194, 0
  br i1 %1198, label %1199, label %1201

1199:                                             ; preds = %1189
  %1200 = shl i64 %1194, 4
  br label %1210

1201:                                             ; preds = %1210, %1189
  %1202 = load ptr, ptr %308, align 8
  %1203 = load ptr, ptr %304, align 8
  tail call fastcc void @real_solve(ptr noundef %1202, i64 noundef %1195, ptr noundef %1203, ptr noundef %1197) #10
  %1204 = load ptr, ptr %309, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1197, ptr noundef %1204, ptr noundef nonnull %77, i64 noundef %1194) #10
  %1205 = load double, ptr %6, align 8
  %1206 = fcmp uge double %1205, 1.000000e+00
  %1207 = and i1 %1191, %1206
  br i1 %1207, label %1208, label %1286

1208:                                             ; preds = %1201
  %1209 = icmp sgt i64 %1194, 0
  br i1 %1209, label %1258, label %1235

1210:                                             ; preds = %1199, %1210
  %1211 = phi i64 [ 0, %1199 ], [ %1233, %1210 ]
  %1212 = load ptr, ptr %273, align 8
  %1213 = getelementptr inbounds double, ptr %1212, i64 %1211
  %1214 = load double, ptr %1213, align 8
  %1215 = fmul double %1214, 0x402418FD8BAFFE05
  %1216 = getelementptr double, ptr %1212, i64 %1194
  %1217 = getelementptr double, ptr %1216, i64 %1211
  %1218 = load double, ptr %1217, align 8
  %1219 = fmul double %1218, 0x3FF61D41B2D54580
  %1220 = fsub double %1219, %1215
  %1221 = getelementptr i8, ptr %1212, i64 %1200
  %1222 = getelementptr double, ptr %1221, i64 %1211
  %1223 = load double, ptr %1222, align 8
  %1224 = fmul double %1223, 0x3FD5555555555555
  %1225 = fsub double %1220, %1224
  %1226 = fdiv double %1225, %398
  %1227 = getelementptr inbounds double, ptr %1196, i64 %1211
  store double %1226, ptr %1227, align 8
  %1228 = load ptr, ptr %307, align 8
  %1229 = getelementptr inbounds double, ptr %1228, i64 %1211
  %1230 = load double, ptr %1229, align 8
  %1231 = fadd double %1230, %1226
  %1232 = getelementptr inbounds double, ptr %1197, i64 %1211
  store double %1231, ptr %1232, align 8
  %1233 = add nuw nsw i64 %1211, 1
  %1234 = icmp eq i64 %1233, %1194
  br i1 %1234, label %1201, label %1210, !llvm.loop !35

1235:                                             ; preds = %1258, %1208
  %1236 = load ptr, ptr %83, align 8
  %1237 = getelementptr inbounds i8, ptr %1236, i64 24
  %1238 = load i64, ptr %1237, align 8
  %1239 = add nsw i64 %1238, 1
  store i64 %1239, ptr %1237, align 8
  %1240 = load ptr, ptr %311, align 8
  %1241 = load ptr, ptr %276, align 8
  %1242 = load ptr, ptr %312, align 8
  store double %362, ptr %1242, align 8
  %1243 = load i64, ptr %313, align 8
  %1244 = icmp sgt i64 %1243, 0
  br i1 %1244, label %1245, label %1246

1245:                                             ; preds = %1235
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1246

1246:                                             ; preds = %1235, %1245
  %1247 = load ptr, ptr %76, align 8
  %1248 = load i64, ptr %1247, align 8
  %1249 = load ptr, ptr %312, align 8
  %1250 = load ptr, ptr %314, align 8
  %1251 = load ptr, ptr %315, align 8
  %1252 = inttoptr i64 %1248 to ptr
  %1253 = tail call i32 %1252(ptr noundef %1249, ptr noundef %1240, ptr noundef %1250, ptr noundef %1251, ptr noundef %1241) #11
  %1254 = sext i32 %1253 to i64
  %1255 = icmp eq i32 %1253, 0
  br i1 %1255, label %1256, label %1286

1256:                                             ; preds = %1246
  %1257 = icmp sgt i64 %1194, 0
  br i1 %1257, label %1275, label %1270

1258:                                             ; preds = %1208, %1258
  %1259 = phi i64 [ %1268, %1258 ], [ 0, %1208 ]
  %1260 = load ptr, ptr %77, align 8
  %1261 = getelementptr inbounds double, ptr %1260, i64 %1259
  %1262 = load double, ptr %1261, align 8
  %1263 = getelementptr inbounds double, ptr %1197, i64 %1259
  %1264 = load double, ptr %1263, align 8
  %1265 = fadd double %1262, %1264
  %1266 = load ptr, ptr %310, align 8
  %1267 = getelementptr inbounds double, ptr %1266, i64 %1259
  store double %1265, ptr %1267, align 8
  %1268 = add nuw nsw i64 %1259, 1
  %1269 = icmp eq i64 %1268, %1194
  br i1 %1269, label %1235, label %1258, !llvm.loop !36

1270:                                             ; preds = %1275, %1256
  %1271 = load ptr, ptr %308, align 8
  %1272 = load ptr, ptr %304, align 8
  tail call fastcc void @real_solve(ptr noundef %1271, i64 noundef %1195, ptr noundef %1272, ptr noundef %1197) #10
  %1273 = load ptr, ptr %309, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1197, ptr noundef %1273, ptr noundef nonnull %77, i64 noundef %1194) #10
  %1274 = load double, ptr %7, align 8
  br label %1286

1275:                                             ; preds = %1256, %1275
  %1276 = phi i64 [ %1284, %1275 ], [ 0, %1256 ]
  %1277 = load ptr, ptr %276, align 8
  %1278 = getelementptr inbounds double, ptr %1277, i64 %1276
  %1279 = load double, ptr %1278, align 8
  %1280 = getelementptr inbounds double, ptr %1196, i64 %1276
  %1281 = load double, ptr %1280, align 8
  %1282 = fadd double %1279, %1281
  %1283 = getelementptr inbounds double, ptr %1197, i64 %1276
  store double %1282, ptr %1283, align 8
  %1284 = add nuw nsw i64 %1276, 1
  %1285 = icmp eq i64 %1284, %1194
  br i1 %1285, label %1270, label %1275, !llvm.loop !37

1286:                                             ; preds = %1201, %1246, %1270
  %1287 = phi double [ %1274, %1270 ], [ %1205, %1246 ], [ %1205, %1201 ]
  %1288 = phi i64 [ 0, %1270 ], [ %1254, %1246 ], [ 0, %1201 ]
  %1289 = icmp slt i64 %1288, 0
  br i1 %1289, label %1768, label %1304

1290:                                             ; preds = %1138, %1290
  %1291 = phi i64 [ %1302, %1290 ], [ 0, %1138 ]
  %1292 = load ptr, ptr %77, align 8
  %1293 = getelementptr inbounds double, ptr %1292, i64 %1291
  %1294 = load double, ptr %1293, align 8
  %1295 = load ptr, ptr %273, align 8
  %1296 = getelementptr i8, ptr %1295, i64 %301
  %1297 = getelementptr double, ptr %1296, i64 %1291
  %1298 = load double, ptr %1297, align 8
  %1299 = fadd double %1294, %1298
  %1300 = load ptr, ptr %302, align 8
  %1301 = getelementptr inbounds double, ptr %1300, i64 %1291
  store double %1299, ptr %1301, align 8
  %1302 = add nuw nsw i64 %1291, 1
  %1303 = icmp eq i64 %1302, %92
  br i1 %1303, label %1189, label %1290, !llvm.loop !38

1304:                                             ; preds = %1286
  %1305 = add nsw i64 %1133, 12
  %1306 = sitofp i64 %1305 to double
  %1307 = fdiv double 0x4027666666666667, %1306
  %1308 = fcmp olt double %1287, 1.000000e-10
  %1309 = select i1 %1308, double 1.000000e-10, double %1287
  %1310 = tail call double @llvm.pow.f64(double %1309, double -2.500000e-01)
  %1311 = icmp eq i64 %1288, 0
  %1312 = fcmp olt double %1287, 1.000000e+00
  %1313 = select i1 %1311, i1 %1312, i1 false
  br i1 %1313, label %1329, label %1314

1314:                                             ; preds = %1304
  %1315 = load i64, ptr %242, align 8
  %1316 = add nsw i64 %1315, 1
  store i64 %1316, ptr %242, align 8
  %1317 = select i1 %1311, i64 2, i64 3
  store i64 %1317, ptr %316, align 8
  %1318 = tail call double @llvm.fabs.f64(double %1287)
  %1319 = fcmp ueq double %1318, 0x7FF0000000000000
  br i1 %1319, label %1324, label %1320

1320:                                             ; preds = %1314
  %1321 = fmul double %1307, %1310
  %1322 = fcmp ogt double %1321, 2.000000e-01
  %1323 = select i1 %1322, double %1321, double 2.000000e-01
  br label %1324

1324:                                             ; preds = %1314, %1320
  %1325 = phi double [ %1323, %1320 ], [ 2.500000e-01, %1314 ]
  %1326 = fmul double %398, %1325
  store i64 1, ptr %303, align 8
  %1327 = load i64, ptr %317, align 8
  %1328 = sub nsw i64 1, %1327
  store i64 %1328, ptr %245, align 8
  br label %1768, !llvm.loop !17

1329:                                             ; preds = %1304
  br i1 %103, label %1330, label %1345

1330:                                             ; preds = %1329
  %1331 = load ptr, ptr %309, align 8
  %1332 = load ptr, ptr %77, align 8
  %1333 = load ptr, ptr %100, align 8
  %1334 = getelementptr inbounds i8, ptr %1333, i64 56
  %1335 = load i64, ptr %1334, align 8
  %1336 = inttoptr i64 %1335 to ptr
  %1337 = tail call i64 %1336(ptr noundef %0, double noundef %399, ptr noundef %1331, ptr noundef %1332) #11
  %1338 = icmp eq i64 %1337, 0
  br i1 %1338, label %1345, label %1339

1339:                                             ; preds = %1330
  %1340 = load i64, ptr %242, align 8
  %1341 = add nsw i64 %1340, 1
  store i64 %1341, ptr %242, align 8
  store i64 6, ptr %318, align 8
  %1342 = fmul double %398, 2.500000e-01
  store i64 1, ptr %303, align 8
  %1343 = load i64, ptr %319, align 8
  %1344 = sub nsw i64 1, %1343
  store i64 %1344, ptr %245, align 8
  br label %1768, !llvm.loop !17

1345:                                             ; preds = %1330, %1329
  %1346 = load i64, ptr %241, align 8
  %1347 = add nsw i64 %1346, 1
  store i64 %1347, ptr %241, align 8
  %1348 = load double, ptr %320, align 8
  %1349 = fcmp ogt double %1348, 0.000000e+00
  br i1 %1349, label %1350, label %1359

1350:                                             ; preds = %1345
  %1351 = fdiv double %1348, %1309
  %1352 = tail call double @llvm.pow.f64(double %1351, double 2.500000e-01)
  %1353 = load double, ptr %321, align 8
  %1354 = fdiv double %398, %1353
  %1355 = fmul double %1352, %1354
  %1356 = fcmp olt double %1355, 1.000000e+00
  %1357 = select i1 %1356, double %1355, double 1.000000e+00
  %1358 = fmul double %1310, %1357
  br label %1359

1359:                                             ; preds = %1350, %1345
  %1360 = phi double [ %1358, %1350 ], [ %1310, %1345 ]
  %1361 = fmul double %1307, %1360
  %1362 = fcmp olt double %1361, 1.000000e+01
  store double %399, ptr %80, align 8
  store double %398, ptr %322, align 8
  store double %1309, ptr %320, align 8
  %1363 = load ptr, ptr %76, align 8
  %1364 = getelementptr inbounds i8, ptr %1363, i64 8
  %1365 = load i64, ptr %1364, align 8
  %1366 = load i64, ptr %323, align 8
  %1367 = load ptr, ptr %273, align 8
  %1368 = load ptr, ptr %324, align 8
  %1369 = load ptr, ptr %272, align 8
  br label %1386

1370:                                             ; preds = %1386
  %1371 = select i1 %1362, double %1361, double 1.000000e+01
  %1372 = icmp sgt i64 %1365, 0
  br i1 %1372, label %1373, label %1446

1373:                                             ; preds = %1370
  %1374 = load double, ptr %8, align 16
  %1375 = load double, ptr %325, align 8
  %1376 = getelementptr double, ptr %1367, i64 %1365
  %1377 = load double, ptr %326, align 16
  %1378 = shl i64 %1365, 4
  %1379 = getelementptr i8, ptr %1367, i64 %1378
  %1380 = load double, ptr %9, align 16
  %1381 = load double, ptr %327, align 8
  %1382 = load double, ptr %328, align 16
  %1383 = getelementptr double, ptr %1368, i64 %1366
  %1384 = shl i64 %1366, 4
  %1385 = getelementptr i8, ptr %1368, i64 %1384
  br label %1397

1386:                                             ; preds = %1359, %1386
  %1387 = phi i64 [ 0, %1359 ], [ %1395, %1386 ]
  %1388 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1387
  %1389 = getelementptr inbounds i8, ptr %1388, i64 8
  %1390 = load double, ptr %1389, align 8
  %1391 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1387
  store double %1390, ptr %1391, align 8
  %1392 = getelementptr inbounds i8, ptr %1388, i64 16
  %1393 = load double, ptr %1392, align 8
  %1394 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1387
  store double %1393, ptr %1394, align 8
  %1395 = add nuw nsw i64 %1387, 1
  %1396 = icmp eq i64 %1395, 3
  br i1 %1396, label %1370, label %1386, !llvm.loop !39

1397:                                             ; preds = %1373, %1434
  %1398 = phi i64 [ 0, %1373 ], [ %1435, %1434 ]
  %1399 = getelementptr inbounds double, ptr %1367, i64 %1398
  %1400 = load double, ptr %1399, align 8
  %1401 = fmul double %1374, %1400
  %1402 = getelementptr double, ptr %1376, i64 %1398
  %1403 = load double, ptr %1402, align 8
  %1404 = fmul double %1375, %1403
  %1405 = fadd double %1401, %1404
  %1406 = getelementptr double, ptr %1379, i64 %1398
  %1407 = load double, ptr %1406, align 8
  %1408 = fmul double %1377, %1407
  %1409 = fadd double %1405, %1408
  %1410 = fmul double %1400, %1380
  %1411 = fmul double %1403, %1381
  %1412 = fadd double %1410, %1411
  %1413 = fmul double %1407, %1382
  %1414 = fadd double %1412, %1413
  %1415 = load ptr, ptr %309, align 8
  %1416 = getelementptr inbounds double, ptr %1415, i64 %1398
  %1417 = load double, ptr %1416, align 8
  %1418 = load ptr, ptr %77, align 8
  %1419 = getelementptr inbounds double, ptr %1418, i64 %1398
  %1420 = load double, ptr %1419, align 8
  %1421 = fsub double %1417, %1420
  %1422 = getelementptr inbounds double, ptr %1368, i64 %1398
  store double %1421, ptr %1422, align 8
  %1423 = fneg double %1409
  %1424 = fsub double %1423, %1414
  %1425 = getelementptr double, ptr %1383, i64 %1398
  store double %1424, ptr %1425, align 8
  %1426 = fneg double %1414
  %1427 = getelementptr double, ptr %1385, i64 %1398
  store double %1426, ptr %1427, align 8
  %1428 = load ptr, ptr %77, align 8
  %1429 = getelementptr inbounds double, ptr %1428, i64 %1398
  %1430 = load double, ptr %1429, align 8
  %1431 = getelementptr inbounds double, ptr %1369, i64 %1398
  store double %1430, ptr %1431, align 8
  %1432 = getelementptr double, ptr %1368, i64 %1398
  %1433 = getelementptr double, ptr %1369, i64 %1398
  br label %1437

1434:                                             ; preds = %1437
  %1435 = add nuw nsw i64 %1398, 1
  %1436 = icmp eq i64 %1435, %1365
  br i1 %1436, label %1446, label %1397, !llvm.loop !40

1437:                                             ; preds = %1397, %1437
  %1438 = phi i64 [ 0, %1397 ], [ %1442, %1437 ]
  %1439 = mul nsw i64 %1366, %1438
  %1440 = getelementptr double, ptr %1432, i64 %1439
  %1441 = load double, ptr %1440, align 8
  %1442 = add nuw nsw i64 %1438, 1
  %1443 = mul nuw nsw i64 %1365, %1442
  %1444 = getelementptr double, ptr %1433, i64 %1443
  store double %1441, ptr %1444, align 8
  %1445 = icmp eq i64 %1442, 3
  br i1 %1445, label %1434, label %1437, !llvm.loop !41

1446:                                             ; preds = %1434, %1370
  store double %398, ptr %271, align 8
  %1447 = load ptr, ptr %0, align 8
  %1448 = getelementptr inbounds i8, ptr %1447, i64 24
  %1449 = load i64, ptr %1448, align 8
  %1450 = load ptr, ptr %240, align 8
  %1451 = getelementptr inbounds i8, ptr %1450, i64 8
  %1452 = load i64, ptr %1451, align 8
  %1453 = icmp eq i64 %1452, 0
  br i1 %1453, label %1500, label %1454

1454:                                             ; preds = %1446
  %1455 = load i64, ptr %1450, align 8
  %1456 = load ptr, ptr %76, align 8
  %1457 = getelementptr inbounds i8, ptr %1456, i64 8
  %1458 = load i64, ptr %1457, align 8
  %1459 = load ptr, ptr %329, align 8
  %1460 = load i64, ptr %330, align 8
  %1461 = mul nsw i64 %1460, %1455
  %1462 = getelementptr inbounds double, ptr %1459, i64 %1461
  %1463 = getelementptr inbounds double, ptr %1462, i64 %1460
  store double %362, ptr %1462, align 8
  %1464 = getelementptr inbounds i8, ptr %1462, i64 8
  store double %398, ptr %1464, align 8
  store double %399, ptr %1463, align 8
  %1465 = getelementptr inbounds i8, ptr %1463, i64 8
  store double 0.000000e+00, ptr %1465, align 8
  %1466 = icmp sgt i64 %1458, 0
  br i1 %1466, label %1467, label %1470

1467:                                             ; preds = %1454
  %1468 = getelementptr i8, ptr %1462, i64 16
  %1469 = icmp sgt i64 %1449, 0
  br label %1473

1470:                                             ; preds = %1485, %1454
  %1471 = add nsw i64 %1455, 1
  %1472 = load ptr, ptr %240, align 8
  store i64 %1471, ptr %1472, align 8
  br label %1500

1473:                                             ; preds = %1467, %1485
  %1474 = phi i64 [ 0, %1467 ], [ %1486, %1485 ]
  %1475 = load ptr, ptr %77, align 8
  %1476 = getelementptr inbounds double, ptr %1475, i64 %1474
  %1477 = load double, ptr %1476, align 8
  %1478 = add nuw nsw i64 %1474, 2
  %1479 = getelementptr inbounds double, ptr %1462, i64 %1478
  store double %1477, ptr %1479, align 8
  %1480 = load ptr, ptr %309, align 8
  %1481 = getelementptr inbounds double, ptr %1480, i64 %1474
  %1482 = load double, ptr %1481, align 8
  %1483 = getelementptr inbounds double, ptr %1463, i64 %1478
  store double %1482, ptr %1483, align 8
  %1484 = getelementptr double, ptr %1468, i64 %1474
  br i1 %1469, label %1488, label %1485

1485:                                             ; preds = %1488, %1473
  %1486 = add nuw nsw i64 %1474, 1
  %1487 = icmp eq i64 %1486, %1458
  br i1 %1487, label %1470, label %1473, !llvm.loop !42

1488:                                             ; preds = %1473, %1488
  %1489 = phi i64 [ %1496, %1488 ], [ 0, %1473 ]
  %1490 = load ptr, ptr %324, align 8
  %1491 = load i64, ptr %323, align 8
  %1492 = mul nsw i64 %1491, %1489
  %1493 = getelementptr double, ptr %1490, i64 %1492
  %1494 = getelementptr double, ptr %1493, i64 %1474
  %1495 = load double, ptr %1494, align 8
  %1496 = add nuw nsw i64 %1489, 1
  %1497 = mul nuw nsw i64 %1496, %1458
  %1498 = getelementptr double, ptr %1484, i64 %1497
  store double %1495, ptr %1498, align 8
  %1499 = icmp eq i64 %1496, %1449
  br i1 %1499, label %1485, label %1488, !llvm.loop !43

1500:                                             ; preds = %1446, %1470
  br i1 %108, label %1506, label %1501

1501:                                             ; preds = %1500
  %1502 = load i64, ptr %331, align 8
  %1503 = getelementptr inbounds double, ptr %94, i64 %1502
  %1504 = load double, ptr %1503, align 8
  %1505 = fcmp ugt double %1504, %399
  br i1 %1505, label %1718, label %1506

1506:                                             ; preds = %1501, %1500
  %1507 = load ptr, ptr %79, align 8
  br i1 %108, label %1508, label %1519

1508:                                             ; preds = %1506
  %1509 = load ptr, ptr %104, align 8
  %1510 = getelementptr inbounds i8, ptr %1509, i64 16
  %1511 = load i64, ptr %1510, align 8
  %1512 = inttoptr i64 %1511 to ptr
  %1513 = tail call i64 %1512(ptr noundef %0, double noundef %362, double noundef %398) #11
  %1514 = icmp eq i64 %1513, -6
  br i1 %1514, label %1515, label %1516

1515:                                             ; preds = %1508
  store double %362, ptr %1507, align 8
  br label %1694

1516:                                             ; preds = %1508
  %1517 = getelementptr inbounds i8, ptr %1507, i64 48
  %1518 = load double, ptr %1517, align 8
  br label %1519

1519:                                             ; preds = %1516, %1506
  %1520 = phi double [ %1518, %1516 ], [ 1.000000e+00, %1506 ]
  %1521 = phi i64 [ %1513, %1516 ], [ 0, %1506 ]
  %1522 = fcmp oeq double %1520, 1.000000e+00
  br i1 %1522, label %1523, label %1525

1523:                                             ; preds = %1519
  %1524 = load double, ptr %1507, align 8
  br label %1528

1525:                                             ; preds = %1519
  %1526 = fmul double %398, %1520
  %1527 = fadd double %362, %1526
  br label %1528

1528:                                             ; preds = %1525, %1523
  %1529 = phi double [ %1524, %1523 ], [ %1527, %1525 ]
  %1530 = icmp eq i64 %1521, -4
  %1531 = select i1 %1530, i64 -4, i64 0
  br i1 %1530, label %1589, label %1532

1532:                                             ; preds = %1528
  %1533 = fcmp olt double %1520, 1.000000e+00
  %1534 = load ptr, ptr %76, align 8
  %1535 = getelementptr inbounds i8, ptr %1534, i64 8
  %1536 = load i64, ptr %1535, align 8
  %1537 = load i64, ptr %95, align 8
  %1538 = load ptr, ptr %93, align 8
  %1539 = load ptr, ptr %83, align 8
  %1540 = getelementptr inbounds i8, ptr %1539, i64 48
  %1541 = load i64, ptr %1540, align 8
  %1542 = icmp slt i64 %1541, %1537
  br i1 %1542, label %1543, label %1585

1543:                                             ; preds = %1532, %1581
  %1544 = phi i64 [ %1582, %1581 ], [ undef, %1532 ]
  %1545 = phi i64 [ %1583, %1581 ], [ %1541, %1532 ]
  %1546 = getelementptr inbounds double, ptr %1538, i64 %1545
  %1547 = load double, ptr %1546, align 8
  %1548 = fcmp olt double %1547, %1529
  %1549 = fcmp oeq double %1547, %1529
  %1550 = and i1 %1533, %1549
  %1551 = or i1 %1548, %1550
  br i1 %1551, label %1552, label %1585

1552:                                             ; preds = %1543
  %1553 = fsub double %1547, %362
  %1554 = fdiv double %1553, %398
  %1555 = mul nsw i64 %1545, %1536
  %1556 = getelementptr inbounds double, ptr %1, i64 %1555
  %1557 = load ptr, ptr %332, align 8
  %1558 = insertelement <8 x double> poison, double %1554, i64 0
  %1559 = shufflevector <8 x double> %1558, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1559, ptr %1557, align 8
  %1560 = load ptr, ptr %77, align 8
  %1561 = load ptr, ptr %333, align 8
  %1562 = load i64, ptr %334, align 8
  %1563 = load ptr, ptr %0, align 8
  %1564 = getelementptr inbounds i8, ptr %1563, i64 24
  %1565 = load i64, ptr %1564, align 8
  %1566 = load ptr, ptr %332, align 8
  %1567 = load ptr, ptr %76, align 8
  %1568 = getelementptr inbounds i8, ptr %1567, i64 16
  %1569 = load i64, ptr %1568, align 8
  tail call fastcc void @nested(ptr noundef %1556, ptr noundef %1560, ptr noundef %1561, i64 noundef %1562, i64 noundef %1565, ptr noundef %1566, i64 noundef %1569) #10
  %1570 = load ptr, ptr %100, align 8
  %1571 = load i64, ptr %1570, align 8
  %1572 = icmp eq i64 %1571, 1
  br i1 %1572, label %1573, label %1581

1573:                                             ; preds = %1552
  %1574 = load double, ptr %1546, align 8
  %1575 = getelementptr inbounds i8, ptr %1570, i64 56
  %1576 = load i64, ptr %1575, align 8
  %1577 = inttoptr i64 %1576 to ptr
  %1578 = tail call i64 %1577(ptr noundef %0, double noundef %1574, ptr noundef %1556, ptr noundef null) #11
  %1579 = icmp eq i64 %1578, 0
  %1580 = select i1 %1579, i64 %1544, i64 %1578
  br i1 %1579, label %1581, label %1589

1581:                                             ; preds = %1573, %1552
  %1582 = phi i64 [ %1580, %1573 ], [ %1544, %1552 ]
  %1583 = add i64 %1545, 1
  %1584 = icmp eq i64 %1583, %1537
  br i1 %1584, label %1585, label %1543, !llvm.loop !44

1585:                                             ; preds = %1581, %1543, %1532
  %1586 = phi i64 [ %1541, %1532 ], [ %1537, %1581 ], [ %1545, %1543 ]
  %1587 = load ptr, ptr %83, align 8
  %1588 = getelementptr inbounds i8, ptr %1587, i64 48
  store i64 %1586, ptr %1588, align 8
  br label %1589

1589:                                             ; preds = %1573, %1585, %1528
  %1590 = phi i64 [ %1531, %1528 ], [ 0, %1585 ], [ %1580, %1573 ]
  %1591 = icmp eq i64 %1590, 0
  %1592 = icmp ne i64 %1521, 0
  %1593 = fcmp olt double %1520, 1.000000e+00
  %1594 = and i1 %1593, %1591
  %1595 = and i1 %1592, %1594
  br i1 %1595, label %1596, label %1633

1596:                                             ; preds = %1589
  %1597 = load ptr, ptr %335, align 8
  %1598 = load ptr, ptr %336, align 8
  %1599 = insertelement <8 x double> poison, double %1520, i64 0
  %1600 = shufflevector <8 x double> %1599, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1600, ptr %1598, align 8
  %1601 = load ptr, ptr %77, align 8
  %1602 = load ptr, ptr %337, align 8
  %1603 = load i64, ptr %338, align 8
  %1604 = load ptr, ptr %0, align 8
  %1605 = getelementptr inbounds i8, ptr %1604, i64 24
  %1606 = load i64, ptr %1605, align 8
  %1607 = load ptr, ptr %336, align 8
  %1608 = load ptr, ptr %76, align 8
  %1609 = getelementptr inbounds i8, ptr %1608, i64 16
  %1610 = load i64, ptr %1609, align 8
  tail call fastcc void @nested(ptr noundef %1597, ptr noundef %1601, ptr noundef %1602, i64 noundef %1603, i64 noundef %1606, ptr noundef %1607, i64 noundef %1610) #10
  %1611 = load i64, ptr %323, align 8
  %1612 = icmp sgt i64 %1611, 0
  br i1 %1612, label %1617, label %1613

1613:                                             ; preds = %1617, %1596
  %1614 = load ptr, ptr %100, align 8
  %1615 = load i64, ptr %1614, align 8
  %1616 = icmp eq i64 %1615, 1
  br i1 %1616, label %1627, label %1633

1617:                                             ; preds = %1596, %1617
  %1618 = phi i64 [ %1624, %1617 ], [ 0, %1596 ]
  %1619 = load ptr, ptr %335, align 8
  %1620 = getelementptr inbounds double, ptr %1619, i64 %1618
  %1621 = load double, ptr %1620, align 8
  %1622 = load ptr, ptr %309, align 8
  %1623 = getelementptr inbounds double, ptr %1622, i64 %1618
  store double %1621, ptr %1623, align 8
  %1624 = add nuw nsw i64 %1618, 1
  %1625 = load i64, ptr %323, align 8
  %1626 = icmp slt i64 %1624, %1625
  br i1 %1626, label %1617, label %1613, !llvm.loop !45

1627:                                             ; preds = %1613
  %1628 = load ptr, ptr %309, align 8
  %1629 = getelementptr inbounds i8, ptr %1614, i64 56
  %1630 = load i64, ptr %1629, align 8
  %1631 = inttoptr i64 %1630 to ptr
  %1632 = tail call i64 %1631(ptr noundef %0, double noundef %1529, ptr noundef %1628, ptr noundef null) #11
  br label %1633

1633:                                             ; preds = %1627, %1613, %1589
  %1634 = phi i64 [ %1632, %1627 ], [ 0, %1613 ], [ %1590, %1589 ]
  %1635 = icmp eq i64 %1634, 0
  br i1 %1635, label %1638, label %1636

1636:                                             ; preds = %1633
  store double %362, ptr %1507, align 8
  %1637 = getelementptr inbounds i8, ptr %1507, i64 8
  store double %398, ptr %1637, align 8
  br label %1694

1638:                                             ; preds = %1633
  br i1 %1522, label %1639, label %1677

1639:                                             ; preds = %1638
  %1640 = load ptr, ptr %309, align 8
  %1641 = load ptr, ptr %76, align 8
  %1642 = getelementptr inbounds i8, ptr %1641, i64 8
  %1643 = load i64, ptr %1642, align 8
  %1644 = load i64, ptr %95, align 8
  %1645 = load ptr, ptr %93, align 8
  %1646 = load ptr, ptr %83, align 8
  %1647 = getelementptr inbounds i8, ptr %1646, i64 48
  %1648 = load i64, ptr %1647, align 8
  %1649 = icmp slt i64 %1648, %1644
  br i1 %1649, label %1650, label %1673

1650:                                             ; preds = %1639
  %1651 = icmp sgt i64 %1643, 0
  br label %1652

1652:                                             ; preds = %1650, %1663
  %1653 = phi i64 [ %1648, %1650 ], [ %1664, %1663 ]
  %1654 = getelementptr inbounds double, ptr %1645, i64 %1653
  %1655 = load double, ptr %1654, align 8
  %1656 = load ptr, ptr %79, align 8
  %1657 = load double, ptr %1656, align 8
  %1658 = fcmp ugt double %1655, %1657
  br i1 %1658, label %1673, label %1659

1659:                                             ; preds = %1652
  br i1 %1651, label %1660, label %1663

1660:                                             ; preds = %1659
  %1661 = mul nsw i64 %1653, %1643
  %1662 = getelementptr double, ptr %1, i64 %1661
  br label %1666

1663:                                             ; preds = %1666, %1659
  %1664 = add i64 %1653, 1
  %1665 = icmp eq i64 %1664, %1644
  br i1 %1665, label %1673, label %1652, !llvm.loop !9

1666:                                             ; preds = %1660, %1666
  %1667 = phi i64 [ 0, %1660 ], [ %1671, %1666 ]
  %1668 = getelementptr inbounds double, ptr %1640, i64 %1667
  %1669 = load double, ptr %1668, align 8
  %1670 = getelementptr double, ptr %1662, i64 %1667
  store double %1669, ptr %1670, align 8
  %1671 = add nuw nsw i64 %1667, 1
  %1672 = icmp eq i64 %1671, %1643
  br i1 %1672, label %1663, label %1666, !llvm.loop !10

1673:                                             ; preds = %1663, %1652, %1639
  %1674 = phi i64 [ %1648, %1639 ], [ %1644, %1663 ], [ %1653, %1652 ]
  %1675 = load ptr, ptr %83, align 8
  %1676 = getelementptr inbounds i8, ptr %1675, i64 48
  store i64 %1674, ptr %1676, align 8
  br label %1677

1677:                                             ; preds = %1673, %1638
  br i1 %1592, label %1678, label %1694

1678:                                             ; preds = %1677
  %1679 = load i64, ptr %323, align 8
  %1680 = icmp sgt i64 %1679, 0
  br i1 %1680, label %1684, label %1681

1681:                                             ; preds = %1684, %1678
  store double %1529, ptr %1507, align 8
  %1682 = getelementptr inbounds i8, ptr %1507, i64 8
  store double 0.000000e+00, ptr %1682, align 8
  %1683 = load ptr, ptr %83, align 8
  store i64 0, ptr %1683, align 8
  br label %1694

1684:                                             ; preds = %1678, %1684
  %1685 = phi i64 [ %1691, %1684 ], [ 0, %1678 ]
  %1686 = load ptr, ptr %309, align 8
  %1687 = getelementptr inbounds double, ptr %1686, i64 %1685
  %1688 = load double, ptr %1687, align 8
  %1689 = load ptr, ptr %77, align 8
  %1690 = getelementptr inbounds double, ptr %1689, i64 %1685
  store double %1688, ptr %1690, align 8
  %1691 = add nuw nsw i64 %1685, 1
  %1692 = load i64, ptr %323, align 8
  %1693 = icmp slt i64 %1691, %1692
  br i1 %1693, label %1684, label %1681, !llvm.loop !46

1694:                                             ; preds = %1515, %1636, %1677, %1681
  %1695 = phi i64 [ -6, %1515 ], [ %1634, %1636 ], [ %1521, %1681 ], [ %1521, %1677 ]
  %1696 = icmp eq i64 %1695, -6
  br i1 %1696, label %1700, label %1697

1697:                                             ; preds = %1694
  %1698 = icmp ne i64 %1695, 6
  %1699 = select i1 %1698, i1 true, i1 %108
  br i1 %1699, label %1712, label %1700

1700:                                             ; preds = %1697, %1694
  %1701 = phi i64 [ %1695, %1697 ], [ 2, %1694 ]
  %1702 = load i64, ptr %241, align 8
  %1703 = add nsw i64 %1702, -1
  store i64 %1703, ptr %241, align 8
  %1704 = load ptr, ptr %240, align 8
  %1705 = load i64, ptr %1704, align 8
  %1706 = add nsw i64 %1705, -1
  store i64 %1706, ptr %1704, align 8
  store i64 1, ptr %303, align 8
  %1707 = load i64, ptr %349, align 8
  %1708 = sub nsw i64 1, %1707
  store i64 %1708, ptr %245, align 8
  store double 0.000000e+00, ptr %271, align 8
  %1709 = load i64, ptr %242, align 8
  %1710 = add nsw i64 %1709, 1
  store i64 %1710, ptr %242, align 8
  store i64 %1701, ptr %350, align 8
  %1711 = fmul double %398, 2.500000e-01
  br label %1768, !llvm.loop !17

1712:                                             ; preds = %1697
  %1713 = icmp eq i64 %1695, 0
  br i1 %1713, label %1718, label %1714

1714:                                             ; preds = %1712
  %1715 = load ptr, ptr %240, align 8
  %1716 = load i64, ptr %1715, align 8
  %1717 = add nsw i64 %1716, 1
  store i64 %1717, ptr %1715, align 8
  br label %1768

1718:                                             ; preds = %1712, %1501
  br i1 %339, label %1737, label %1719

1719:                                             ; preds = %1737, %1718
  %1720 = load i64, ptr %340, align 8
  %1721 = add nsw i64 %1720, 1
  store i64 %1721, ptr %340, align 8
  %1722 = load ptr, ptr %77, align 8
  %1723 = load ptr, ptr %341, align 8
  %1724 = load ptr, ptr %342, align 8
  store double %399, ptr %1724, align 8
  %1725 = load i64, ptr %343, align 8
  %1726 = icmp sgt i64 %1725, 0
  br i1 %1726, label %1727, label %1728

1727:                                             ; preds = %1719
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1728

1728:                                             ; preds = %1719, %1727
  %1729 = load ptr, ptr %76, align 8
  %1730 = load i64, ptr %1729, align 8
  %1731 = load ptr, ptr %342, align 8
  %1732 = load ptr, ptr %344, align 8
  %1733 = load ptr, ptr %345, align 8
  %1734 = inttoptr i64 %1730 to ptr
  %1735 = tail call i32 %1734(ptr noundef %1731, ptr noundef %1722, ptr noundef %1732, ptr noundef %1733, ptr noundef %1723) #11
  %1736 = icmp eq i32 %1735, 0
  br i1 %1736, label %1749, label %1746

1737:                                             ; preds = %1718, %1737
  %1738 = phi i64 [ %1744, %1737 ], [ 0, %1718 ]
  %1739 = load ptr, ptr %309, align 8
  %1740 = getelementptr inbounds double, ptr %1739, i64 %1738
  %1741 = load double, ptr %1740, align 8
  %1742 = load ptr, ptr %77, align 8
  %1743 = getelementptr inbounds double, ptr %1742, i64 %1738
  store double %1741, ptr %1743, align 8
  %1744 = add nuw nsw i64 %1738, 1
  %1745 = icmp eq i64 %1744, %92
  br i1 %1745, label %1719, label %1737, !llvm.loop !47

1746:                                             ; preds = %1728
  store i64 3, ptr %346, align 8
  store double %398, ptr %124, align 8
  %1747 = icmp slt i32 %1735, 0
  %1748 = select i1 %1747, i64 -4, i64 2
  br label %1768

1749:                                             ; preds = %1728
  %1750 = icmp sgt i64 %1133, 2
  %1751 = fcmp ogt double %1131, 1.000000e-03
  %1752 = select i1 %1750, i1 %1751, i1 false
  %1753 = zext i1 %1752 to i64
  store i64 %1753, ptr %245, align 8
  store i64 0, ptr %347, align 8
  store i64 0, ptr %303, align 8
  %1754 = fcmp ule double %1371, 1.000000e+00
  %1755 = fcmp uge double %1371, 1.200000e+00
  %1756 = or i1 %1754, %1755
  %1757 = select i1 %1756, i1 true, i1 %1752
  br i1 %1757, label %1758, label %1762

1758:                                             ; preds = %1749
  %1759 = fcmp ogt double %1371, 2.000000e-01
  %1760 = select i1 %1759, double %1371, double 2.000000e-01
  %1761 = fmul double %398, %1760
  br label %1762

1762:                                             ; preds = %1749, %1758
  %1763 = phi double [ %1761, %1758 ], [ %398, %1749 ]
  %1764 = load i64, ptr %348, align 8
  %1765 = load i64, ptr %95, align 8
  %1766 = icmp eq i64 %1764, %1765
  br i1 %1766, label %1767, label %1768

1767:                                             ; preds = %1762
  store double %1763, ptr %124, align 8
  br label %1768

1768:                                             ; preds = %1173, %1185, %1130, %1324, %1339, %1700, %1714, %1746, %1762, %1767, %1286, %524, %589, %405
  %1769 = phi double [ %367, %405 ], [ %367, %524 ], [ %367, %589 ], [ %1131, %1286 ], [ %1131, %1767 ], [ %1131, %1762 ], [ %1131, %1746 ], [ %1131, %1714 ], [ %1131, %1700 ], [ %1131, %1339 ], [ %1131, %1324 ], [ %1131, %1130 ], [ %1131, %1185 ], [ %1131, %1173 ]
  %1770 = phi i32 [ %366, %405 ], [ %366, %524 ], [ %366, %589 ], [ %1132, %1286 ], [ %1132, %1767 ], [ %1132, %1762 ], [ %1132, %1746 ], [ %1132, %1714 ], [ %1132, %1700 ], [ %1132, %1339 ], [ %1132, %1324 ], [ %1132, %1130 ], [ %1132, %1185 ], [ %1132, %1173 ]
  %1771 = phi i64 [ %365, %405 ], [ %365, %524 ], [ %365, %589 ], [ %1133, %1286 ], [ %1133, %1767 ], [ %1133, %1762 ], [ %1133, %1746 ], [ %1133, %1714 ], [ %1133, %1700 ], [ %1133, %1339 ], [ %1133, %1324 ], [ %1133, %1130 ], [ %1133, %1185 ], [ %1133, %1173 ]
  %1772 = phi i64 [ %364, %405 ], [ %364, %524 ], [ %364, %589 ], [ %1134, %1286 ], [ %1134, %1767 ], [ %1134, %1762 ], [ %1134, %1746 ], [ %1134, %1714 ], [ %1134, %1700 ], [ %1134, %1339 ], [ %1134, %1324 ], [ %1134, %1130 ], [ %1134, %1185 ], [ %1134, %1173 ]
  %1773 = phi double [ %363, %405 ], [ %363, %524 ], [ %592, %589 ], [ %363, %1286 ], [ %1763, %1767 ], [ %1763, %1762 ], [ %363, %1746 ], [ %363, %1714 ], [ %1711, %1700 ], [ %1342, %1339 ], [ %1326, %1324 ], [ %363, %1130 ], [ %1186, %1185 ], [ %363, %1173 ]
  %1774 = phi double [ %362, %405 ], [ %362, %524 ], [ %362, %589 ], [ %362, %1286 ], [ %399, %1767 ], [ %399, %1762 ], [ %399, %1746 ], [ %362, %1714 ], [ %362, %1700 ], [ %362, %1339 ], [ %362, %1324 ], [ %362, %1130 ], [ %362, %1185 ], [ %362, %1173 ]
  %1775 = phi i32 [ 1, %405 ], [ 1, %524 ], [ 6, %589 ], [ 1, %1286 ], [ 1, %1767 ], [ 0, %1762 ], [ 1, %1746 ], [ 1, %1714 ], [ 6, %1700 ], [ 6, %1339 ], [ 6, %1324 ], [ 1, %1130 ], [ 6, %1185 ], [ 6, %1173 ]
  %1776 = phi i64 [ 2, %405 ], [ -4, %524 ], [ %361, %589 ], [ -4, %1286 ], [ 0, %1767 ], [ %361, %1762 ], [ %1748, %1746 ], [ %1695, %1714 ], [ %361, %1700 ], [ %361, %1339 ], [ %361, %1324 ], [ -4, %1130 ], [ %361, %1185 ], [ %361, %1173 ]
  switch i32 %1775, label %1780 [
    i32 0, label %1777
    i32 6, label %1777
  ]

1777:                                             ; preds = %1768, %1768
  %1778 = load i64, ptr %86, align 8
  %1779 = icmp eq i64 %1778, 0
  br i1 %1779, label %357, label %359, !llvm.loop !17

1780:                                             ; preds = %1768, %161, %357, %380, %388, %203, %75
  %1781 = phi i64 [ -1, %75 ], [ %164, %161 ], [ -1, %357 ], [ -5, %380 ], [ 1, %388 ], [ 0, %203 ], [ %1776, %1768 ]
  ret i64 %1781
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
  br i1 %55, label %44, label %56, !llvm.loop !48

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
  br i1 %83, label %13, label %12, !llvm.loop !49
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
  br i1 %41, label %13, label %18, !llvm.loop !50
}

declare double @llvm.fabs.f64(double) #2

define internal fastcc i32 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp slt i64 %1, 1
  br i1 %4, label %76, label %8

5:                                                ; preds = %73, %50
  %6 = icmp sge i64 %16, %1
  %7 = icmp eq i64 %16, %1
  br i1 %7, label %76, label %8, !llvm.loop !51

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
  br i1 %36, label %24, label %19, !llvm.loop !52

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
  br i1 %49, label %50, label %42, !llvm.loop !53

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
  br i1 %72, label %63, label %73, !llvm.loop !54

73:                                               ; preds = %63, %54
  %74 = add nuw nsw i64 %55, 1
  %75 = icmp slt i64 %74, %1
  br i1 %75, label %54, label %5, !llvm.loop !55

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
  br i1 %7, label %127, label %8, !llvm.loop !56

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
  br i1 %40, label %26, label %21, !llvm.loop !57

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
  br i1 %57, label %58, label %46, !llvm.loop !58

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
  br i1 %123, label %104, label %124, !llvm.loop !59

124:                                              ; preds = %104, %86
  %125 = add nuw nsw i64 %87, 1
  %126 = icmp slt i64 %125, %1
  br i1 %126, label %86, label %5, !llvm.loop !60

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
  br i1 %19, label %6, label %8, !llvm.loop !61

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
  br i1 %35, label %20, label %24, !llvm.loop !62

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
  br i1 %46, label %32, label %36, !llvm.loop !63

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
  br i1 %63, label %48, label %47, !llvm.loop !64

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
  br i1 %74, label %57, label %64, !llvm.loop !65
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
  br i1 %24, label %6, label %8, !llvm.loop !66

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
  br i1 %43, label %25, label %29, !llvm.loop !67

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
  br i1 %65, label %39, label %44, !llvm.loop !68

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
  br i1 %112, label %67, label %66, !llvm.loop !69

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
  br i1 %134, label %78, label %113, !llvm.loop !70
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
  br i1 %37, label %38, label %23, !llvm.loop !71

38:                                               ; preds = %23, %14
  %39 = add nuw nsw i64 %15, 1
  %40 = icmp eq i64 %39, %1
  br i1 %40, label %10, label %14, !llvm.loop !72

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
  br i1 %57, label %49, label %41, !llvm.loop !73

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
  br i1 %73, label %74, label %64, !llvm.loop !74

74:                                               ; preds = %64, %58
  %75 = add nuw nsw i64 %59, 1
  %76 = icmp eq i64 %75, %42
  br i1 %76, label %55, label %58, !llvm.loop !75

77:                                               ; preds = %116, %89
  %78 = icmp sgt i64 %80, 1
  br i1 %78, label %79, label %88, !llvm.loop !76

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
  br i1 %112, label %113, label %103, !llvm.loop !74

113:                                              ; preds = %103, %97
  %114 = add nuw nsw i64 %98, 1
  %115 = icmp eq i64 %114, %1
  br i1 %115, label %89, label %97, !llvm.loop !77

116:                                              ; preds = %94, %116
  %117 = phi i64 [ 0, %94 ], [ %121, %116 ]
  %118 = getelementptr double, ptr %96, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fmul double %93, %119
  store double %120, ptr %118, align 8
  %121 = add nuw nsw i64 %117, 1
  %122 = icmp eq i64 %121, %4
  br i1 %122, label %77, label %116, !llvm.loop !78
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
  br i1 %42, label %43, label %23, !llvm.loop !79

43:                                               ; preds = %23, %14
  %44 = add nuw nsw i64 %15, 1
  %45 = icmp eq i64 %44, %1
  br i1 %45, label %10, label %14, !llvm.loop !80

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
  br i1 %62, label %54, label %46, !llvm.loop !81

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
  br i1 %90, label %91, label %71, !llvm.loop !82

91:                                               ; preds = %71, %63
  %92 = add nuw nsw i64 %64, 1
  %93 = icmp eq i64 %92, %47
  br i1 %93, label %60, label %63, !llvm.loop !83

94:                                               ; preds = %170, %133
  %95 = icmp sgt i64 %97, 1
  br i1 %95, label %96, label %105, !llvm.loop !84

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
  br i1 %166, label %167, label %147, !llvm.loop !82

167:                                              ; preds = %147, %139
  %168 = add nuw nsw i64 %140, 1
  %169 = icmp eq i64 %168, %1
  br i1 %169, label %106, label %139, !llvm.loop !85

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
  br i1 %183, label %94, label %170, !llvm.loop !86
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
  br i1 %31, label %20, label %19, !llvm.loop !87

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
  br i1 %43, label %32, label %24, !llvm.loop !88
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
