; sources 8757643a19bc2610319eed39097b901a3d4087e38e33a5f62c624b0b2a3e2a89
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
  br i1 %10, label %11, label %64

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
  %25 = getelementptr inbounds i8, ptr %0, i64 1032
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
  br i1 %40, label %41, label %64

41:                                               ; preds = %37
  %42 = getelementptr inbounds i8, ptr %0, i64 600
  %43 = getelementptr inbounds i8, ptr %0, i64 1056
  br label %54

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

54:                                               ; preds = %41, %54
  %55 = phi i64 [ 0, %41 ], [ %61, %54 ]
  %56 = load ptr, ptr %43, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %55
  %58 = load i64, ptr %57, align 8
  %59 = load ptr, ptr %42, align 8
  %60 = getelementptr inbounds i64, ptr %59, i64 %55
  store i64 %58, ptr %60, align 8
  %61 = add nuw nsw i64 %55, 1
  %62 = load i64, ptr %38, align 8
  %63 = icmp slt i64 %61, %62
  br i1 %63, label %54, label %64, !llvm.loop !7

64:                                               ; preds = %54, %37, %3
  %65 = getelementptr inbounds i8, ptr %0, i64 144
  %66 = getelementptr inbounds i8, ptr %0, i64 312
  %67 = getelementptr inbounds i8, ptr %0, i64 1128
  %68 = getelementptr inbounds i8, ptr %0, i64 576
  %69 = load ptr, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %0, i64 1152
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %0, i64 600
  %73 = load ptr, ptr %72, align 8
  %74 = load ptr, ptr %67, align 8
  %75 = getelementptr inbounds i8, ptr %73, i64 56
  %76 = load i64, ptr %75, align 8
  %77 = icmp eq i64 %76, 0
  br i1 %77, label %1771, label %78

78:                                               ; preds = %64
  %79 = load ptr, ptr %65, align 8
  %80 = getelementptr inbounds i8, ptr %79, i64 8
  %81 = load i64, ptr %80, align 8
  %82 = getelementptr inbounds i8, ptr %0, i64 624
  %83 = load ptr, ptr %82, align 8
  %84 = getelementptr inbounds i8, ptr %0, i64 632
  %85 = load i64, ptr %84, align 8
  %86 = getelementptr double, ptr %83, i64 %85
  %87 = getelementptr i8, ptr %86, i64 -8
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds i8, ptr %0, i64 648
  %90 = load ptr, ptr %89, align 8
  %91 = load i64, ptr %90, align 8
  %92 = icmp eq i64 %91, 1
  %93 = getelementptr inbounds i8, ptr %0, i64 720
  %94 = load ptr, ptr %93, align 8
  %95 = getelementptr inbounds i8, ptr %94, i64 8
  %96 = load i64, ptr %95, align 8
  %97 = icmp sgt i64 %96, 0
  %98 = getelementptr inbounds i8, ptr %0, i64 528
  %99 = load ptr, ptr %98, align 8
  %100 = load double, ptr %99, align 8
  %101 = icmp sgt i64 %81, 0
  br i1 %101, label %117, label %102

102:                                              ; preds = %117, %78
  %103 = phi double [ %100, %78 ], [ %123, %117 ]
  %104 = tail call double @llvm.sqrt.f64(double %103)
  %105 = fcmp olt double %104, 3.000000e-02
  %106 = select i1 %105, double %104, double 3.000000e-02
  %107 = fcmp olt double %103, 0x3CB0000000000000
  %108 = select i1 %107, double 0x3CB0000000000000, double %103
  %109 = fdiv double 0x3CE4000000000000, %108
  %110 = fcmp ogt double %106, %109
  %111 = select i1 %110, double %106, double %109
  %112 = load double, ptr %69, align 8
  %113 = getelementptr inbounds i8, ptr %69, i64 8
  %114 = load double, ptr %113, align 8
  %115 = load i64, ptr %73, align 8
  %116 = icmp eq i64 %115, 0
  br i1 %116, label %126, label %224

117:                                              ; preds = %78, %117
  %118 = phi double [ %123, %117 ], [ %100, %78 ]
  %119 = phi i64 [ %124, %117 ], [ 0, %78 ]
  %120 = getelementptr inbounds double, ptr %99, i64 %119
  %121 = load double, ptr %120, align 8
  %122 = fcmp olt double %121, %118
  %123 = select i1 %122, double %121, double %118
  %124 = add nuw nsw i64 %119, 1
  %125 = icmp eq i64 %124, %81
  br i1 %125, label %102, label %117, !llvm.loop !8

126:                                              ; preds = %102
  %127 = getelementptr inbounds i8, ptr %73, i64 24
  %128 = load i64, ptr %127, align 8
  %129 = add nsw i64 %128, 1
  store i64 %129, ptr %127, align 8
  %130 = load ptr, ptr %66, align 8
  %131 = getelementptr inbounds i8, ptr %0, i64 480
  %132 = load ptr, ptr %131, align 8
  %133 = getelementptr inbounds i8, ptr %0, i64 168
  %134 = load ptr, ptr %133, align 8
  store double %112, ptr %134, align 8
  %135 = getelementptr inbounds i8, ptr %0, i64 248
  %136 = load i64, ptr %135, align 8
  %137 = icmp sgt i64 %136, 0
  br i1 %137, label %138, label %139

138:                                              ; preds = %126
  tail call fastcc void @sample(ptr noundef nonnull %65) #10
  br label %139

139:                                              ; preds = %126, %138
  %140 = load ptr, ptr %65, align 8
  %141 = load i64, ptr %140, align 8
  %142 = load ptr, ptr %133, align 8
  %143 = getelementptr inbounds i8, ptr %0, i64 192
  %144 = load ptr, ptr %143, align 8
  %145 = getelementptr inbounds i8, ptr %0, i64 216
  %146 = load ptr, ptr %145, align 8
  %147 = inttoptr i64 %141 to ptr
  %148 = tail call i32 %147(ptr noundef %142, ptr noundef %130, ptr noundef %144, ptr noundef %146, ptr noundef %132) #11
  %149 = icmp eq i32 %148, 0
  br i1 %149, label %154, label %150

150:                                              ; preds = %139
  %151 = getelementptr inbounds i8, ptr %73, i64 72
  store i64 3, ptr %151, align 8
  %152 = icmp slt i32 %148, 0
  %153 = select i1 %152, i64 -4, i64 2
  br label %1771

154:                                              ; preds = %139
  store i64 1, ptr %73, align 8
  %155 = getelementptr inbounds i8, ptr %69, i64 24
  store double 0.000000e+00, ptr %155, align 8
  %156 = getelementptr inbounds i8, ptr %74, i64 32
  store i64 1, ptr %156, align 8
  %157 = getelementptr inbounds i8, ptr %74, i64 8
  store i64 1, ptr %157, align 8
  %158 = getelementptr inbounds i8, ptr %71, i64 8
  store double 0.000000e+00, ptr %158, align 8
  %159 = load ptr, ptr %66, align 8
  %160 = load ptr, ptr %65, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 8
  %162 = load i64, ptr %161, align 8
  %163 = load i64, ptr %84, align 8
  %164 = load ptr, ptr %82, align 8
  %165 = load ptr, ptr %72, align 8
  %166 = getelementptr inbounds i8, ptr %165, i64 48
  %167 = load i64, ptr %166, align 8
  %168 = icmp slt i64 %167, %163
  br i1 %168, label %169, label %192

169:                                              ; preds = %154
  %170 = icmp sgt i64 %162, 0
  br label %171

171:                                              ; preds = %169, %182
  %172 = phi i64 [ %167, %169 ], [ %183, %182 ]
  %173 = getelementptr inbounds double, ptr %164, i64 %172
  %174 = load double, ptr %173, align 8
  %175 = load ptr, ptr %68, align 8
  %176 = load double, ptr %175, align 8
  %177 = fcmp ugt double %174, %176
  br i1 %177, label %192, label %178

178:                                              ; preds = %171
  br i1 %170, label %179, label %182

179:                                              ; preds = %178
  %180 = mul nsw i64 %172, %162
  %181 = getelementptr double, ptr %1, i64 %180
  br label %185

182:                                              ; preds = %185, %178
  %183 = add i64 %172, 1
  %184 = icmp eq i64 %183, %163
  br i1 %184, label %192, label %171, !llvm.loop !9

185:                                              ; preds = %179, %185
  %186 = phi i64 [ 0, %179 ], [ %190, %185 ]
  %187 = getelementptr inbounds double, ptr %159, i64 %186
  %188 = load double, ptr %187, align 8
  %189 = getelementptr double, ptr %181, i64 %186
  store double %188, ptr %189, align 8
  %190 = add nuw nsw i64 %186, 1
  %191 = icmp eq i64 %190, %162
  br i1 %191, label %182, label %185, !llvm.loop !10

192:                                              ; preds = %171, %182, %154
  %193 = phi i64 [ %167, %154 ], [ %172, %171 ], [ %163, %182 ]
  %194 = load ptr, ptr %72, align 8
  %195 = getelementptr inbounds i8, ptr %194, i64 48
  store i64 %193, ptr %195, align 8
  %196 = icmp eq i64 %193, %163
  br i1 %196, label %1771, label %197

197:                                              ; preds = %192
  %198 = fcmp oeq double %114, 0.000000e+00
  br i1 %198, label %199, label %224

199:                                              ; preds = %197
  %200 = getelementptr inbounds i8, ptr %69, i64 16
  %201 = load double, ptr %200, align 8
  %202 = load ptr, ptr %66, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %202, ptr noundef %202, ptr noundef nonnull %66, i64 noundef %81) #10
  %203 = load double, ptr %4, align 8
  %204 = getelementptr inbounds i8, ptr %0, i64 480
  %205 = load ptr, ptr %204, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %205, ptr noundef %202, ptr noundef nonnull %66, i64 noundef %81) #10
  %206 = load double, ptr %5, align 8
  %207 = fcmp uge double %203, 1.000000e-05
  %208 = fcmp uge double %206, 1.000000e-05
  %209 = and i1 %207, %208
  %210 = fmul double %203, 1.000000e-02
  %211 = fdiv double %210, %206
  %212 = select i1 %209, double %211, double 0x3EB0C6F7A0B5ED8D
  %213 = fcmp olt double %201, %212
  %214 = select i1 %213, double %201, double %212
  %215 = tail call double @llvm.fabs.f64(double %112)
  %216 = fmul double %215, 0x3D30000000000000
  %217 = fcmp ogt double %216, %214
  %218 = select i1 %217, double %216, double %214
  %219 = fcmp olt double %201, %218
  %220 = select i1 %219, double %201, double %218
  %221 = tail call i1 @llvm.is.fpclass.f64(double %220, i32 639)
  br i1 %221, label %222, label %224

222:                                              ; preds = %199
  %223 = getelementptr inbounds i8, ptr %73, i64 72
  store i64 4, ptr %223, align 8
  br label %224

224:                                              ; preds = %199, %222, %197, %102
  %225 = phi double [ %114, %197 ], [ %114, %102 ], [ %220, %222 ], [ %220, %199 ]
  %226 = load i64, ptr %75, align 8
  %227 = icmp eq i64 %226, 0
  br i1 %227, label %346, label %228

228:                                              ; preds = %224
  %229 = getelementptr inbounds i8, ptr %0, i64 1080
  %230 = getelementptr inbounds i8, ptr %73, i64 8
  %231 = getelementptr inbounds i8, ptr %73, i64 16
  %232 = getelementptr inbounds i8, ptr %73, i64 64
  %233 = getelementptr inbounds i8, ptr %69, i64 16
  %234 = getelementptr inbounds i8, ptr %74, i64 8
  %235 = getelementptr inbounds i8, ptr %0, i64 1200
  %236 = getelementptr inbounds i8, ptr %0, i64 168
  %237 = getelementptr inbounds i8, ptr %0, i64 248
  %238 = getelementptr inbounds i8, ptr %0, i64 168
  %239 = getelementptr inbounds i8, ptr %0, i64 192
  %240 = getelementptr inbounds i8, ptr %0, i64 1176
  %241 = getelementptr inbounds i8, ptr %0, i64 360
  %242 = getelementptr inbounds i8, ptr %0, i64 360
  %243 = getelementptr inbounds i8, ptr %0, i64 336
  %244 = getelementptr inbounds i8, ptr %0, i64 168
  %245 = getelementptr inbounds i8, ptr %0, i64 248
  %246 = getelementptr inbounds i8, ptr %0, i64 192
  %247 = getelementptr inbounds i8, ptr %0, i64 216
  %248 = getelementptr inbounds i8, ptr %0, i64 480
  %249 = getelementptr inbounds i8, ptr %0, i64 1208
  %250 = getelementptr inbounds i8, ptr %74, i64 16
  %251 = getelementptr inbounds i8, ptr %74, i64 24
  %252 = getelementptr inbounds i8, ptr %74, i64 24
  %253 = getelementptr inbounds i8, ptr %73, i64 40
  %254 = getelementptr inbounds i8, ptr %0, i64 1272
  %255 = getelementptr inbounds i8, ptr %0, i64 1280
  %256 = getelementptr inbounds i8, ptr %0, i64 1224
  %257 = getelementptr inbounds i8, ptr %0, i64 1248
  %258 = getelementptr inbounds i8, ptr %0, i64 1200
  %259 = getelementptr inbounds i8, ptr %0, i64 1296
  %260 = getelementptr inbounds i8, ptr %71, i64 8
  %261 = getelementptr inbounds i8, ptr %0, i64 1392
  %262 = getelementptr inbounds i8, ptr %0, i64 1320
  %263 = getelementptr inbounds i8, ptr %0, i64 1344
  %264 = fmul double %103, %111
  %265 = getelementptr inbounds i8, ptr %0, i64 1368
  %266 = getelementptr inbounds i8, ptr %0, i64 1416
  %267 = getelementptr inbounds i8, ptr %0, i64 1440
  %268 = getelementptr inbounds i8, ptr %0, i64 360
  %269 = getelementptr inbounds i8, ptr %0, i64 168
  %270 = getelementptr inbounds i8, ptr %0, i64 248
  %271 = getelementptr inbounds i8, ptr %0, i64 360
  %272 = getelementptr inbounds i8, ptr %0, i64 192
  %273 = getelementptr inbounds i8, ptr %0, i64 216
  %274 = getelementptr inbounds i8, ptr %0, i64 552
  %275 = getelementptr inbounds i8, ptr %0, i64 528
  %276 = getelementptr inbounds i8, ptr %0, i64 1272
  %277 = getelementptr inbounds i8, ptr %0, i64 1280
  %278 = getelementptr inbounds i8, ptr %0, i64 1224
  %279 = getelementptr inbounds i8, ptr %0, i64 1248
  %280 = getelementptr inbounds i8, ptr %0, i64 1296
  %281 = getelementptr inbounds i8, ptr %0, i64 552
  %282 = getelementptr inbounds i8, ptr %0, i64 528
  %283 = getelementptr inbounds i8, ptr %0, i64 1280
  %284 = getelementptr inbounds i8, ptr %0, i64 1344
  %285 = getelementptr inbounds i8, ptr %0, i64 1360
  %286 = getelementptr inbounds i8, ptr %0, i64 1416
  %287 = getelementptr inbounds i8, ptr %0, i64 1440
  %288 = fmul double %264, %264
  %289 = icmp sgt i64 %81, 0
  %290 = shl i64 %81, 4
  %291 = getelementptr inbounds i8, ptr %0, i64 336
  %292 = getelementptr inbounds i8, ptr %74, i64 32
  %293 = getelementptr inbounds i8, ptr %0, i64 1272
  %294 = getelementptr inbounds i8, ptr %0, i64 1280
  %295 = getelementptr inbounds i8, ptr %0, i64 1464
  %296 = getelementptr inbounds i8, ptr %0, i64 480
  %297 = getelementptr inbounds i8, ptr %0, i64 1224
  %298 = getelementptr inbounds i8, ptr %0, i64 336
  %299 = getelementptr inbounds i8, ptr %0, i64 360
  %300 = getelementptr inbounds i8, ptr %0, i64 360
  %301 = getelementptr inbounds i8, ptr %0, i64 168
  %302 = getelementptr inbounds i8, ptr %0, i64 248
  %303 = getelementptr inbounds i8, ptr %0, i64 192
  %304 = getelementptr inbounds i8, ptr %0, i64 216
  %305 = getelementptr inbounds i8, ptr %73, i64 72
  %306 = getelementptr inbounds i8, ptr %74, i64 16
  %307 = getelementptr inbounds i8, ptr %73, i64 72
  %308 = getelementptr inbounds i8, ptr %74, i64 16
  %309 = getelementptr inbounds i8, ptr %69, i64 24
  %310 = getelementptr inbounds i8, ptr %69, i64 32
  %311 = getelementptr inbounds i8, ptr %69, i64 32
  %312 = getelementptr inbounds i8, ptr %0, i64 320
  %313 = getelementptr inbounds i8, ptr %0, i64 504
  %314 = getelementptr inbounds i8, ptr %8, i64 8
  %315 = getelementptr inbounds i8, ptr %8, i64 16
  %316 = getelementptr inbounds i8, ptr %9, i64 8
  %317 = getelementptr inbounds i8, ptr %9, i64 16
  %318 = getelementptr inbounds i8, ptr %0, i64 1104
  %319 = getelementptr inbounds i8, ptr %0, i64 1120
  %320 = getelementptr inbounds i8, ptr %73, i64 48
  %321 = getelementptr inbounds i8, ptr %0, i64 408
  %322 = getelementptr inbounds i8, ptr %0, i64 504
  %323 = getelementptr inbounds i8, ptr %0, i64 320
  %324 = getelementptr inbounds i8, ptr %0, i64 360
  %325 = getelementptr inbounds i8, ptr %0, i64 408
  %326 = getelementptr inbounds i8, ptr %0, i64 504
  %327 = getelementptr inbounds i8, ptr %0, i64 320
  %328 = icmp sgt i64 %81, 0
  %329 = getelementptr inbounds i8, ptr %73, i64 24
  %330 = getelementptr inbounds i8, ptr %0, i64 480
  %331 = getelementptr inbounds i8, ptr %0, i64 168
  %332 = getelementptr inbounds i8, ptr %0, i64 248
  %333 = getelementptr inbounds i8, ptr %0, i64 192
  %334 = getelementptr inbounds i8, ptr %0, i64 216
  %335 = getelementptr inbounds i8, ptr %73, i64 72
  %336 = getelementptr inbounds i8, ptr %74, i64 16
  %337 = getelementptr inbounds i8, ptr %73, i64 48
  %338 = getelementptr inbounds i8, ptr %73, i64 72
  %339 = getelementptr inbounds i8, ptr %74, i64 16
  %340 = getelementptr inbounds i8, ptr %73, i64 72
  %341 = getelementptr inbounds i8, ptr %74, i64 16
  %342 = getelementptr inbounds i8, ptr %0, i64 1200
  %343 = getelementptr inbounds i8, ptr %0, i64 1208
  %344 = getelementptr inbounds i8, ptr %73, i64 72
  %345 = getelementptr inbounds i8, ptr %74, i64 16
  br label %348

346:                                              ; preds = %1768, %224
  %347 = phi double [ %225, %224 ], [ %1764, %1768 ]
  store double %347, ptr %113, align 8
  br label %1771

348:                                              ; preds = %228, %1768
  %349 = phi i64 [ %226, %228 ], [ %1769, %1768 ]
  %350 = phi i64 [ undef, %228 ], [ %1767, %1768 ]
  %351 = phi double [ %112, %228 ], [ %1765, %1768 ]
  %352 = phi double [ %225, %228 ], [ %1764, %1768 ]
  %353 = phi i64 [ undef, %228 ], [ %1763, %1768 ]
  %354 = phi i64 [ undef, %228 ], [ %1762, %1768 ]
  %355 = phi i32 [ undef, %228 ], [ %1761, %1768 ]
  %356 = phi double [ undef, %228 ], [ %1760, %1768 ]
  %357 = load ptr, ptr %229, align 8
  %358 = getelementptr inbounds i8, ptr %357, i64 8
  %359 = load i64, ptr %358, align 8
  %360 = icmp sgt i64 %359, 0
  br i1 %360, label %361, label %366

361:                                              ; preds = %348
  %362 = load i64, ptr %357, align 8
  %363 = add nsw i64 %362, 3
  %364 = icmp slt i64 %359, %363
  %365 = zext i1 %364 to i32
  br label %366

366:                                              ; preds = %348, %361
  %367 = phi i32 [ 0, %348 ], [ %365, %361 ]
  %368 = icmp eq i32 %367, 0
  br i1 %368, label %370, label %369

369:                                              ; preds = %366
  store double %352, ptr %113, align 8
  br label %1771

370:                                              ; preds = %366
  %371 = add nsw i64 %349, -1
  store i64 %371, ptr %75, align 8
  %372 = load i64, ptr %230, align 8
  %373 = load i64, ptr %231, align 8
  %374 = add nsw i64 %373, %372
  %375 = load i64, ptr %232, align 8
  %376 = icmp slt i64 %374, %375
  br i1 %376, label %378, label %377

377:                                              ; preds = %370
  store double %352, ptr %113, align 8
  br label %1771

378:                                              ; preds = %370
  %379 = load double, ptr %233, align 8
  %380 = fcmp olt double %352, %379
  %381 = select i1 %380, double %352, double %379
  %382 = fadd double %351, %381
  %383 = fmul double %381, 1.000000e-03
  %384 = fsub double %88, %383
  %385 = fcmp ule double %382, %384
  %386 = fsub double %88, %351
  %387 = select i1 %385, double %381, double %386
  %388 = select i1 %385, double %382, double %88
  %389 = fmul double %387, 6.250000e-02
  %390 = fadd double %351, %389
  %391 = fcmp ule double %390, %351
  %392 = fcmp une double %388, %88
  %393 = and i1 %392, %391
  br i1 %393, label %394, label %395

394:                                              ; preds = %378
  store double %387, ptr %113, align 8
  br label %1759

395:                                              ; preds = %378
  %396 = load i64, ptr %234, align 8
  %397 = icmp eq i64 %396, 1
  br i1 %397, label %398, label %516

398:                                              ; preds = %395
  %399 = load ptr, ptr %72, align 8
  %400 = getelementptr inbounds i8, ptr %399, i64 32
  %401 = load i64, ptr %400, align 8
  %402 = add nsw i64 %401, 1
  store i64 %402, ptr %400, align 8
  %403 = load ptr, ptr %65, align 8
  %404 = getelementptr inbounds i8, ptr %403, i64 8
  %405 = load i64, ptr %404, align 8
  %406 = load ptr, ptr %67, align 8
  %407 = load i64, ptr %406, align 8
  %408 = icmp eq i64 %407, 0
  br i1 %408, label %409, label %411

409:                                              ; preds = %398
  %410 = icmp sgt i64 %405, 0
  br i1 %410, label %429, label %427

411:                                              ; preds = %398
  %412 = load ptr, ptr %236, align 8
  store double %351, ptr %412, align 8
  %413 = load i64, ptr %237, align 8
  %414 = icmp sgt i64 %413, 0
  br i1 %414, label %415, label %416

415:                                              ; preds = %411
  tail call fastcc void @sample(ptr noundef nonnull %65) #10
  br label %416

416:                                              ; preds = %415, %411
  %417 = load ptr, ptr %67, align 8
  %418 = load i64, ptr %417, align 8
  %419 = load ptr, ptr %238, align 8
  %420 = load ptr, ptr %66, align 8
  %421 = load ptr, ptr %239, align 8
  %422 = load ptr, ptr %240, align 8
  %423 = load ptr, ptr %235, align 8
  %424 = inttoptr i64 %418 to ptr
  %425 = tail call i32 %424(ptr noundef %419, ptr noundef %420, ptr noundef %421, ptr noundef %422, ptr noundef %423) #11
  %426 = sext i32 %425 to i64
  br label %497

427:                                              ; preds = %429, %409
  %428 = icmp sgt i64 %405, 0
  br i1 %428, label %441, label %497

429:                                              ; preds = %409, %429
  %430 = phi i64 [ %436, %429 ], [ 0, %409 ]
  %431 = load ptr, ptr %66, align 8
  %432 = getelementptr inbounds double, ptr %431, i64 %430
  %433 = load double, ptr %432, align 8
  %434 = load ptr, ptr %241, align 8
  %435 = getelementptr inbounds double, ptr %434, i64 %430
  store double %433, ptr %435, align 8
  %436 = add nuw nsw i64 %430, 1
  %437 = icmp eq i64 %436, %405
  br i1 %437, label %427, label %429, !llvm.loop !11

438:                                              ; preds = %495
  %439 = add nuw nsw i64 %443, 1
  %440 = icmp eq i64 %439, %405
  br i1 %440, label %497, label %441, !llvm.loop !12

441:                                              ; preds = %427, %438
  %442 = phi i64 [ %496, %438 ], [ undef, %427 ]
  %443 = phi i64 [ %439, %438 ], [ 0, %427 ]
  %444 = load ptr, ptr %66, align 8
  %445 = getelementptr inbounds double, ptr %444, i64 %443
  %446 = load double, ptr %445, align 8
  %447 = tail call double @llvm.fabs.f64(double %446)
  %448 = fcmp olt double %447, 1.000000e-05
  %449 = select i1 %448, double 1.000000e-05, double %447
  %450 = fmul double %449, 1.500000e-08
  %451 = fadd double %446, %450
  %452 = load ptr, ptr %242, align 8
  %453 = getelementptr inbounds double, ptr %452, i64 %443
  store double %451, ptr %453, align 8
  %454 = load ptr, ptr %72, align 8
  %455 = getelementptr inbounds i8, ptr %454, i64 24
  %456 = load i64, ptr %455, align 8
  %457 = add nsw i64 %456, 1
  store i64 %457, ptr %455, align 8
  %458 = load ptr, ptr %242, align 8
  %459 = load ptr, ptr %243, align 8
  %460 = load ptr, ptr %244, align 8
  store double %351, ptr %460, align 8
  %461 = load i64, ptr %245, align 8
  %462 = icmp sgt i64 %461, 0
  br i1 %462, label %463, label %464

463:                                              ; preds = %441
  tail call fastcc void @sample(ptr noundef nonnull %65) #10
  br label %464

464:                                              ; preds = %463, %441
  %465 = load ptr, ptr %65, align 8
  %466 = load i64, ptr %465, align 8
  %467 = load ptr, ptr %244, align 8
  %468 = load ptr, ptr %246, align 8
  %469 = load ptr, ptr %247, align 8
  %470 = inttoptr i64 %466 to ptr
  %471 = tail call i32 %470(ptr noundef %467, ptr noundef %458, ptr noundef %468, ptr noundef %469, ptr noundef %459) #11
  %472 = sext i32 %471 to i64
  %473 = icmp eq i32 %471, 0
  br i1 %473, label %474, label %495

474:                                              ; preds = %464
  %475 = fsub double %451, %446
  br label %479

476:                                              ; preds = %479
  %477 = load ptr, ptr %242, align 8
  %478 = getelementptr inbounds double, ptr %477, i64 %443
  store double %446, ptr %478, align 8
  br label %495

479:                                              ; preds = %474, %479
  %480 = phi i64 [ 0, %474 ], [ %493, %479 ]
  %481 = load ptr, ptr %243, align 8
  %482 = getelementptr inbounds double, ptr %481, i64 %480
  %483 = load double, ptr %482, align 8
  %484 = load ptr, ptr %248, align 8
  %485 = getelementptr inbounds double, ptr %484, i64 %480
  %486 = load double, ptr %485, align 8
  %487 = fsub double %483, %486
  %488 = fdiv double %487, %475
  %489 = load ptr, ptr %235, align 8
  %490 = mul nuw nsw i64 %480, %405
  %491 = getelementptr double, ptr %489, i64 %490
  %492 = getelementptr double, ptr %491, i64 %443
  store double %488, ptr %492, align 8
  %493 = add nuw nsw i64 %480, 1
  %494 = icmp eq i64 %493, %405
  br i1 %494, label %476, label %479, !llvm.loop !13

495:                                              ; preds = %476, %464
  %496 = phi i64 [ %442, %476 ], [ %472, %464 ]
  br i1 %473, label %438, label %497

497:                                              ; preds = %495, %438, %427, %416
  %498 = phi i64 [ %426, %416 ], [ 0, %427 ], [ 0, %438 ], [ %496, %495 ]
  %499 = load i64, ptr %249, align 8
  %500 = icmp sgt i64 %499, 0
  br i1 %500, label %501, label %513

501:                                              ; preds = %497, %509
  %502 = phi i64 [ %510, %509 ], [ 0, %497 ]
  %503 = load ptr, ptr %235, align 8
  %504 = getelementptr inbounds double, ptr %503, i64 %502
  %505 = load double, ptr %504, align 8
  %506 = tail call double @llvm.fabs.f64(double %505)
  %507 = fcmp ueq double %506, 0x7FF0000000000000
  br i1 %507, label %508, label %509

508:                                              ; preds = %501
  store double 0.000000e+00, ptr %504, align 8
  br label %509

509:                                              ; preds = %508, %501
  %510 = add nuw nsw i64 %502, 1
  %511 = load i64, ptr %249, align 8
  %512 = icmp slt i64 %510, %511
  br i1 %512, label %501, label %513, !llvm.loop !14

513:                                              ; preds = %509, %497
  %514 = icmp slt i64 %498, 0
  br i1 %514, label %1759, label %515

515:                                              ; preds = %513
  store i64 0, ptr %234, align 8
  store i64 1, ptr %250, align 8
  store i64 0, ptr %251, align 8
  br label %516

516:                                              ; preds = %515, %395
  %517 = load i64, ptr %252, align 8
  %518 = icmp eq i64 %517, 0
  br i1 %518, label %522, label %519

519:                                              ; preds = %516
  %520 = load double, ptr %71, align 8
  %521 = fcmp une double %387, %520
  br i1 %521, label %522, label %585

522:                                              ; preds = %519, %516
  %523 = load i64, ptr %253, align 8
  %524 = add nsw i64 %523, 1
  store i64 %524, ptr %253, align 8
  %525 = load i64, ptr %255, align 8
  %526 = load ptr, ptr %256, align 8
  %527 = load ptr, ptr %257, align 8
  %528 = icmp sgt i64 %525, 0
  br i1 %528, label %529, label %537

529:                                              ; preds = %522
  %530 = fdiv double 0x400D1A48D83E731D, %387
  %531 = add nuw i64 %525, 1
  %532 = fdiv double 0x400572DB93E0C672, %387
  %533 = fdiv double 0x40086747F2C3FCB6, %387
  br label %534

534:                                              ; preds = %529, %541
  %535 = phi i64 [ 0, %529 ], [ %552, %541 ]
  %536 = mul nuw nsw i64 %535, %525
  br label %554

537:                                              ; preds = %541, %522
  %538 = load ptr, ptr %254, align 8
  %539 = tail call fastcc i32 @real_factorise(ptr noundef %526, i64 noundef %525, ptr noundef %538) #10
  %540 = icmp eq i32 %539, 0
  br i1 %540, label %575, label %570

541:                                              ; preds = %554
  %542 = mul i64 %535, %531
  %543 = getelementptr inbounds double, ptr %526, i64 %542
  %544 = load double, ptr %543, align 8
  %545 = fadd double %530, %544
  store double %545, ptr %543, align 8
  %546 = getelementptr inbounds { double, double }, ptr %527, i64 %542
  %547 = load double, ptr %546, align 8
  %548 = getelementptr inbounds i8, ptr %546, i64 8
  %549 = load double, ptr %548, align 8
  %550 = fadd double %532, %547
  %551 = fsub double %549, %533
  store double %550, ptr %546, align 8
  store double %551, ptr %548, align 8
  %552 = add nuw nsw i64 %535, 1
  %553 = icmp eq i64 %552, %525
  br i1 %553, label %537, label %534, !llvm.loop !15

554:                                              ; preds = %534, %554
  %555 = phi i64 [ 0, %534 ], [ %568, %554 ]
  %556 = load ptr, ptr %258, align 8
  %557 = add nuw nsw i64 %555, %536
  %558 = getelementptr inbounds double, ptr %556, i64 %557
  %559 = load double, ptr %558, align 8
  %560 = fneg double %559
  %561 = getelementptr inbounds double, ptr %526, i64 %557
  store double %560, ptr %561, align 8
  %562 = load ptr, ptr %258, align 8
  %563 = getelementptr inbounds double, ptr %562, i64 %557
  %564 = load double, ptr %563, align 8
  %565 = fneg double %564
  %566 = getelementptr inbounds { double, double }, ptr %527, i64 %557
  %567 = getelementptr inbounds i8, ptr %566, i64 8
  store double %565, ptr %566, align 8
  store double 0.000000e+00, ptr %567, align 8
  %568 = add nuw nsw i64 %555, 1
  %569 = icmp eq i64 %568, %525
  br i1 %569, label %541, label %554, !llvm.loop !16

570:                                              ; preds = %537
  %571 = load ptr, ptr %259, align 8
  %572 = tail call fastcc i32 @pair_factorise(ptr noundef %527, i64 noundef %525, ptr noundef %571) #10
  %573 = icmp ne i32 %572, 0
  %574 = zext i1 %573 to i32
  br label %575

575:                                              ; preds = %537, %570
  %576 = phi i32 [ 0, %537 ], [ %574, %570 ]
  %577 = icmp eq i32 %576, 0
  br i1 %577, label %578, label %584

578:                                              ; preds = %575
  store i64 4, ptr %344, align 8
  %579 = load i64, ptr %231, align 8
  %580 = add nsw i64 %579, 1
  store i64 %580, ptr %231, align 8
  %581 = fmul double %387, 5.000000e-01
  %582 = load i64, ptr %345, align 8
  %583 = sub nsw i64 1, %582
  store i64 %583, ptr %234, align 8
  store i64 0, ptr %252, align 8
  br label %1759, !llvm.loop !17

584:                                              ; preds = %575
  store i64 1, ptr %252, align 8
  store double %387, ptr %71, align 8
  br label %585

585:                                              ; preds = %584, %519
  %586 = load double, ptr %260, align 8
  %587 = load ptr, ptr %65, align 8
  %588 = getelementptr inbounds i8, ptr %587, i64 8
  %589 = load i64, ptr %588, align 8
  %590 = load ptr, ptr %261, align 8
  %591 = load ptr, ptr %66, align 8
  %592 = load ptr, ptr %262, align 8
  %593 = load ptr, ptr %263, align 8
  %594 = fcmp ogt double %586, 0.000000e+00
  %595 = icmp sgt i64 %589, 0
  %596 = shl i64 %589, 4
  %597 = getelementptr i8, ptr %590, i64 %596
  %598 = mul i64 %589, 24
  %599 = getelementptr i8, ptr %590, i64 %598
  %600 = getelementptr double, ptr %590, i64 %589
  br label %606

601:                                              ; preds = %620
  %602 = icmp sgt i64 %589, 0
  %603 = getelementptr double, ptr %592, i64 %589
  %604 = shl i64 %589, 4
  %605 = getelementptr i8, ptr %592, i64 %604
  br label %647

606:                                              ; preds = %585, %620
  %607 = phi i64 [ 0, %585 ], [ %621, %620 ]
  br i1 %594, label %608, label %614

608:                                              ; preds = %606
  %609 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %607
  %610 = load double, ptr %609, align 8
  %611 = fmul double %387, %610
  %612 = fdiv double %611, %586
  %613 = fadd double %612, 1.000000e+00
  br label %614

614:                                              ; preds = %608, %606
  %615 = phi double [ %613, %608 ], [ 0.000000e+00, %606 ]
  br i1 %595, label %616, label %620

616:                                              ; preds = %614
  %617 = mul nuw nsw i64 %589, %607
  %618 = getelementptr double, ptr %592, i64 %617
  %619 = fsub double 1.000000e+00, %615
  br label %623

620:                                              ; preds = %644, %614
  %621 = add nuw nsw i64 %607, 1
  %622 = icmp eq i64 %621, 3
  br i1 %622, label %601, label %606, !llvm.loop !18

623:                                              ; preds = %616, %644
  %624 = phi i64 [ 0, %616 ], [ %645, %644 ]
  %625 = getelementptr double, ptr %618, i64 %624
  store double 0.000000e+00, ptr %625, align 8
  br i1 %594, label %626, label %644

626:                                              ; preds = %623
  %627 = getelementptr double, ptr %597, i64 %624
  %628 = load double, ptr %627, align 8
  %629 = getelementptr double, ptr %599, i64 %624
  %630 = load double, ptr %629, align 8
  %631 = fmul double %615, %630
  %632 = fadd double %628, %631
  %633 = fmul double %619, %632
  %634 = getelementptr inbounds double, ptr %590, i64 %624
  %635 = load double, ptr %634, align 8
  %636 = getelementptr double, ptr %600, i64 %624
  %637 = load double, ptr %636, align 8
  %638 = fadd double %637, %633
  %639 = fmul double %615, %638
  %640 = fadd double %635, %639
  %641 = getelementptr inbounds double, ptr %591, i64 %624
  %642 = load double, ptr %641, align 8
  %643 = fsub double %640, %642
  store double %643, ptr %625, align 8
  br label %644

644:                                              ; preds = %626, %623
  %645 = add nuw nsw i64 %624, 1
  %646 = icmp eq i64 %645, %589
  br i1 %646, label %620, label %623, !llvm.loop !19

647:                                              ; preds = %601, %658
  %648 = phi i64 [ 0, %601 ], [ %659, %658 ]
  br i1 %602, label %649, label %658

649:                                              ; preds = %647
  %650 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %648
  %651 = load double, ptr %650, align 8
  %652 = getelementptr inbounds i8, ptr %650, i64 8
  %653 = load double, ptr %652, align 8
  %654 = getelementptr inbounds i8, ptr %650, i64 16
  %655 = load double, ptr %654, align 8
  %656 = mul nuw nsw i64 %589, %648
  %657 = getelementptr double, ptr %593, i64 %656
  br label %661

658:                                              ; preds = %661, %647
  %659 = add nuw nsw i64 %648, 1
  %660 = icmp eq i64 %659, 3
  br i1 %660, label %677, label %647, !llvm.loop !20

661:                                              ; preds = %649, %661
  %662 = phi i64 [ 0, %649 ], [ %675, %661 ]
  %663 = getelementptr inbounds double, ptr %592, i64 %662
  %664 = load double, ptr %663, align 8
  %665 = fmul double %651, %664
  %666 = getelementptr double, ptr %603, i64 %662
  %667 = load double, ptr %666, align 8
  %668 = fmul double %653, %667
  %669 = fadd double %665, %668
  %670 = getelementptr double, ptr %605, i64 %662
  %671 = load double, ptr %670, align 8
  %672 = fmul double %655, %671
  %673 = fadd double %669, %672
  %674 = getelementptr double, ptr %657, i64 %662
  store double %673, ptr %674, align 8
  %675 = add nuw nsw i64 %662, 1
  %676 = icmp eq i64 %675, %589
  br i1 %676, label %658, label %661, !llvm.loop !21

677:                                              ; preds = %658
  %678 = load ptr, ptr %65, align 8, !noalias !22
  %679 = getelementptr inbounds i8, ptr %678, i64 8
  %680 = load i64, ptr %679, align 8, !noalias !22
  %681 = load ptr, ptr %67, align 8, !noalias !22
  %682 = getelementptr inbounds i8, ptr %681, i64 40
  %683 = load i64, ptr %682, align 8, !noalias !22
  %684 = load ptr, ptr %262, align 8, !noalias !22
  %685 = load ptr, ptr %263, align 8, !noalias !22
  %686 = load ptr, ptr %265, align 8, !noalias !22
  %687 = load ptr, ptr %266, align 8, !noalias !22
  %688 = load ptr, ptr %267, align 8, !noalias !22
  %689 = icmp sgt i64 %683, 0
  %690 = select i1 %689, i64 10, i64 6
  %691 = icmp sgt i64 %680, 0
  %692 = fdiv double 0x400D1A48D83E731D, %387
  %693 = fdiv double 0x400572DB93E0C672, %387
  %694 = fdiv double 0xC0086747F2C3FCB6, %387
  %695 = icmp sgt i64 %680, 0
  %696 = getelementptr double, ptr %685, i64 %680
  %697 = shl i64 %680, 4
  %698 = getelementptr i8, ptr %685, i64 %697
  %699 = icmp eq i64 %683, 0
  br label %700

700:                                              ; preds = %677, %1103
  %701 = phi double [ -1.000000e+00, %677 ], [ %1102, %1103 ]
  %702 = phi double [ 0.000000e+00, %677 ], [ %1101, %1103 ]
  %703 = phi i64 [ 0, %677 ], [ %1100, %1103 ]
  %704 = phi i64 [ 0, %677 ], [ %1104, %1103 ]
  %705 = phi i64 [ %353, %677 ], [ %1097, %1103 ]
  %706 = phi i64 [ %354, %677 ], [ %1096, %1103 ]
  %707 = phi i32 [ %355, %677 ], [ %1095, %1103 ]
  %708 = phi double [ %356, %677 ], [ %1094, %1103 ]
  %709 = icmp ugt i64 %704, 5
  %710 = icmp eq i64 %703, 0
  %711 = select i1 %709, i1 %710, i1 false
  br i1 %711, label %1106, label %716

712:                                              ; preds = %738
  %713 = add nuw nsw i64 %717, 1
  %714 = icmp ugt i64 %717, 1
  %715 = icmp eq i64 %713, 3
  br i1 %715, label %761, label %716, !llvm.loop !25

716:                                              ; preds = %700, %712
  %717 = phi i64 [ %713, %712 ], [ 0, %700 ]
  %718 = phi i1 [ %714, %712 ], [ false, %700 ]
  br i1 %691, label %719, label %722

719:                                              ; preds = %716
  %720 = mul nuw nsw i64 %680, %717
  %721 = getelementptr double, ptr %684, i64 %720
  br label %747

722:                                              ; preds = %747, %716
  %723 = load ptr, ptr %72, align 8, !noalias !22
  %724 = getelementptr inbounds i8, ptr %723, i64 24
  %725 = load i64, ptr %724, align 8, !noalias !22
  %726 = add nsw i64 %725, 1
  store i64 %726, ptr %724, align 8, !noalias !22
  %727 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %717
  %728 = load double, ptr %727, align 8, !noalias !22
  %729 = fmul double %387, %728
  %730 = fadd double %351, %729
  %731 = load ptr, ptr %268, align 8, !noalias !22
  %732 = mul nsw i64 %680, %717
  %733 = getelementptr inbounds double, ptr %686, i64 %732
  %734 = load ptr, ptr %269, align 8, !noalias !22
  store double %730, ptr %734, align 8, !noalias !22
  %735 = load i64, ptr %270, align 8, !noalias !22
  %736 = icmp sgt i64 %735, 0
  br i1 %736, label %737, label %738

737:                                              ; preds = %722
  tail call fastcc void @sample(ptr noundef nonnull %65) #10, !noalias !22
  br label %738

738:                                              ; preds = %722, %737
  %739 = load ptr, ptr %65, align 8, !noalias !22
  %740 = load i64, ptr %739, align 8, !noalias !22
  %741 = load ptr, ptr %269, align 8, !noalias !22
  %742 = load ptr, ptr %272, align 8, !noalias !22
  %743 = load ptr, ptr %273, align 8, !noalias !22
  %744 = inttoptr i64 %740 to ptr
  %745 = tail call i32 %744(ptr noundef %741, ptr noundef %731, ptr noundef %742, ptr noundef %743, ptr noundef %733) #11, !noalias !22
  %746 = icmp eq i32 %745, 0
  br i1 %746, label %712, label %759

747:                                              ; preds = %719, %747
  %748 = phi i64 [ 0, %719 ], [ %757, %747 ]
  %749 = load ptr, ptr %66, align 8, !noalias !22
  %750 = getelementptr inbounds double, ptr %749, i64 %748
  %751 = load double, ptr %750, align 8, !noalias !22
  %752 = getelementptr double, ptr %721, i64 %748
  %753 = load double, ptr %752, align 8, !noalias !22
  %754 = fadd double %751, %753
  %755 = load ptr, ptr %271, align 8, !noalias !22
  %756 = getelementptr inbounds double, ptr %755, i64 %748
  store double %754, ptr %756, align 8, !noalias !22
  %757 = add nuw nsw i64 %748, 1
  %758 = icmp eq i64 %757, %680
  br i1 %758, label %722, label %747, !llvm.loop !26

759:                                              ; preds = %738
  %760 = sext i32 %745 to i64
  br label %761

761:                                              ; preds = %712, %759
  %762 = phi i1 [ %718, %759 ], [ %714, %712 ]
  %763 = phi double [ 0.000000e+00, %759 ], [ %708, %712 ]
  %764 = phi i32 [ 0, %759 ], [ %707, %712 ]
  %765 = phi i64 [ %704, %759 ], [ %706, %712 ]
  %766 = phi i64 [ %760, %759 ], [ %705, %712 ]
  %767 = phi i32 [ 1, %759 ], [ 5, %712 ]
  br i1 %762, label %768, label %1106

768:                                              ; preds = %761
  %769 = load ptr, ptr %65, align 8, !noalias !22
  %770 = getelementptr inbounds i8, ptr %769, i64 8
  %771 = load i64, ptr %770, align 8, !noalias !22
  %772 = load ptr, ptr %265, align 8, !noalias !22
  %773 = load ptr, ptr %263, align 8, !noalias !22
  %774 = load ptr, ptr %266, align 8, !noalias !22
  %775 = load ptr, ptr %267, align 8, !noalias !22
  %776 = icmp sgt i64 %771, 0
  br i1 %776, label %777, label %882

777:                                              ; preds = %768
  %778 = shl nuw nsw i64 %771, 1
  %779 = getelementptr double, ptr %772, i64 %771
  %780 = shl i64 %771, 4
  %781 = getelementptr i8, ptr %772, i64 %780
  %782 = load double, ptr %772, align 8, !noalias !22
  %783 = getelementptr inbounds double, ptr %772, i64 %771
  %784 = load double, ptr %783, align 8, !noalias !22
  %785 = fadd double %782, %784
  %786 = getelementptr inbounds double, ptr %772, i64 %778
  %787 = load double, ptr %786, align 8, !noalias !22
  %788 = fadd double %785, %787
  %789 = tail call double @llvm.fabs.f64(double %788)
  %790 = fcmp ueq double %789, 0x7FF0000000000000
  br i1 %790, label %879, label %791

791:                                              ; preds = %777
  %792 = getelementptr double, ptr %773, i64 %771
  %793 = getelementptr inbounds double, ptr %773, i64 %778
  %794 = getelementptr double, ptr %772, i64 %771
  %795 = getelementptr inbounds double, ptr %772, i64 %778
  br label %807

796:                                              ; preds = %807
  %797 = getelementptr inbounds double, ptr %772, i64 %875
  %798 = load double, ptr %797, align 8, !noalias !22
  %799 = getelementptr double, ptr %794, i64 %875
  %800 = load double, ptr %799, align 8, !noalias !22
  %801 = fadd double %798, %800
  %802 = getelementptr inbounds double, ptr %795, i64 %875
  %803 = load double, ptr %802, align 8, !noalias !22
  %804 = fadd double %801, %803
  %805 = tail call double @llvm.fabs.f64(double %804)
  %806 = fcmp ueq double %805, 0x7FF0000000000000
  br i1 %806, label %877, label %807, !llvm.loop !27

807:                                              ; preds = %791, %796
  %808 = phi double [ %798, %796 ], [ %782, %791 ]
  %809 = phi double [ %874, %796 ], [ 0.000000e+00, %791 ]
  %810 = phi i64 [ %875, %796 ], [ 0, %791 ]
  %811 = getelementptr inbounds double, ptr %772, i64 %810
  %812 = fmul double %808, 0x4010B70201A79C46
  %813 = getelementptr double, ptr %779, i64 %810
  %814 = load double, ptr %813, align 8, !noalias !22
  %815 = fmul double %814, 0x3FD4F8C15DA84E86
  %816 = fadd double %812, %815
  %817 = getelementptr double, ptr %781, i64 %810
  %818 = load double, ptr %817, align 8, !noalias !22
  %819 = fmul double %818, 0x3FE0BF7FF59D56EF
  %820 = fadd double %816, %819
  %821 = getelementptr inbounds double, ptr %773, i64 %810
  %822 = load double, ptr %821, align 8, !noalias !22
  %823 = fmul double %692, %822
  %824 = fsub double %820, %823
  %825 = getelementptr inbounds double, ptr %774, i64 %810
  store double %824, ptr %825, align 8, !noalias !22
  %826 = load double, ptr %811, align 8, !noalias !22
  %827 = fmul double %826, 0xC010B70201A79C46
  %828 = load double, ptr %813, align 8, !noalias !22
  %829 = fmul double %828, 0x3FD4F8C15DA84E86
  %830 = fsub double %827, %829
  %831 = load double, ptr %817, align 8, !noalias !22
  %832 = fmul double %831, 0x3FDE810014C55221
  %833 = fadd double %830, %832
  %834 = fmul double %826, 0x3FE017885A24A7F2
  %835 = fmul double %828, 0x4004934E6FCAA598
  %836 = fsub double %834, %835
  %837 = fmul double %831, 0x3FE312C0CF7BDFD1
  %838 = fadd double %836, %837
  %839 = getelementptr double, ptr %792, i64 %810
  %840 = load double, ptr %839, align 8, !noalias !22
  %841 = getelementptr inbounds double, ptr %793, i64 %810
  %842 = load double, ptr %841, align 8, !noalias !22
  %843 = fmul double %693, %840
  %844 = fmul double %694, %842
  %845 = fmul double %693, %842
  %846 = fmul double %694, %840
  %847 = fsub double %843, %844
  %848 = fadd double %846, %845
  %849 = fsub double %833, %847
  %850 = fsub double %838, %848
  %851 = getelementptr inbounds { double, double }, ptr %775, i64 %810
  %852 = getelementptr inbounds i8, ptr %851, i64 8
  store double %849, ptr %851, align 8, !noalias !22
  store double %850, ptr %852, align 8, !noalias !22
  %853 = load double, ptr %825, align 8, !noalias !22
  %854 = tail call double @llvm.fabs.f64(double %853)
  %855 = tail call double @llvm.fabs.f64(double %849)
  %856 = fadd double %854, %855
  %857 = tail call double @llvm.fabs.f64(double %850)
  %858 = fadd double %857, %856
  %859 = fmul double %387, %858
  %860 = load ptr, ptr %66, align 8, !noalias !22
  %861 = getelementptr inbounds double, ptr %860, i64 %810
  %862 = load double, ptr %861, align 8, !noalias !22
  %863 = load ptr, ptr %274, align 8, !noalias !22
  %864 = getelementptr inbounds double, ptr %863, i64 %810
  %865 = load double, ptr %864, align 8, !noalias !22
  %866 = load ptr, ptr %275, align 8, !noalias !22
  %867 = getelementptr inbounds double, ptr %866, i64 %810
  %868 = load double, ptr %867, align 8, !noalias !22
  %869 = tail call double @llvm.fabs.f64(double %862)
  %870 = fmul double %869, %868
  %871 = fadd double %865, %870
  %872 = fdiv double %859, %871
  %873 = fmul double %872, %872
  %874 = fadd double %809, %873
  %875 = add nuw nsw i64 %810, 1
  %876 = icmp eq i64 %875, %771
  br i1 %876, label %882, label %796, !llvm.loop !27

877:                                              ; preds = %796
  %878 = icmp slt i64 %875, %771
  br label %879

879:                                              ; preds = %877, %777
  %880 = phi i1 [ %878, %877 ], [ %776, %777 ]
  %881 = phi double [ %874, %877 ], [ 0.000000e+00, %777 ]
  br i1 %880, label %1106, label %882

882:                                              ; preds = %807, %768, %879
  %883 = phi double [ %881, %879 ], [ 0.000000e+00, %768 ], [ %874, %807 ]
  %884 = load ptr, ptr %65, align 8, !noalias !22
  %885 = getelementptr inbounds i8, ptr %884, i64 8
  %886 = load i64, ptr %885, align 8, !noalias !22
  %887 = load i64, ptr %277, align 8, !noalias !22
  %888 = load ptr, ptr %67, align 8, !noalias !22
  %889 = getelementptr inbounds i8, ptr %888, i64 40
  %890 = load i64, ptr %889, align 8, !noalias !22
  %891 = load ptr, ptr %266, align 8, !noalias !22
  %892 = load ptr, ptr %267, align 8, !noalias !22
  %893 = load ptr, ptr %278, align 8, !noalias !22
  %894 = load ptr, ptr %276, align 8, !noalias !22
  tail call fastcc void @real_solve(ptr noundef %893, i64 noundef %887, ptr noundef %894, ptr noundef %891) #10, !noalias !22
  %895 = load ptr, ptr %279, align 8, !noalias !22
  %896 = load ptr, ptr %280, align 8, !noalias !22
  tail call fastcc void @pair_solve(ptr noundef %895, i64 noundef %887, ptr noundef %896, ptr noundef %892) #10, !noalias !22
  %897 = icmp sgt i64 %890, 0
  br i1 %897, label %898, label %903

898:                                              ; preds = %882
  %899 = load ptr, ptr %278, align 8, !noalias !22
  %900 = load ptr, ptr %276, align 8, !noalias !22
  tail call fastcc void @real_solve_columns(ptr noundef %899, i64 noundef %887, ptr noundef %900, ptr noundef %891, i64 noundef %890) #10, !noalias !22
  %901 = load ptr, ptr %279, align 8, !noalias !22
  %902 = load ptr, ptr %280, align 8, !noalias !22
  tail call fastcc void @pair_solve_columns(ptr noundef %901, i64 noundef %887, ptr noundef %902, ptr noundef %892, i64 noundef %890) #10, !noalias !22
  br label %903

903:                                              ; preds = %898, %882
  %904 = icmp sgt i64 %886, 0
  br i1 %904, label %905, label %938

905:                                              ; preds = %903
  %906 = load ptr, ptr %66, align 8, !noalias !22
  %907 = load ptr, ptr %281, align 8, !noalias !22
  %908 = load ptr, ptr %282, align 8, !noalias !22
  br label %909

909:                                              ; preds = %905, %909
  %910 = phi double [ 0.000000e+00, %905 ], [ %935, %909 ]
  %911 = phi i64 [ 0, %905 ], [ %936, %909 ]
  %912 = getelementptr inbounds double, ptr %906, i64 %911
  %913 = load double, ptr %912, align 8, !noalias !22
  %914 = getelementptr inbounds double, ptr %907, i64 %911
  %915 = load double, ptr %914, align 8, !noalias !22
  %916 = getelementptr inbounds double, ptr %908, i64 %911
  %917 = load double, ptr %916, align 8, !noalias !22
  %918 = tail call double @llvm.fabs.f64(double %913)
  %919 = fmul double %918, %917
  %920 = fadd double %915, %919
  %921 = getelementptr inbounds double, ptr %891, i64 %911
  %922 = load double, ptr %921, align 8, !noalias !22
  %923 = fdiv double %922, %920
  %924 = getelementptr inbounds { double, double }, ptr %892, i64 %911
  %925 = load double, ptr %924, align 8, !noalias !22
  %926 = getelementptr inbounds i8, ptr %924, i64 8
  %927 = fdiv double %925, %920
  %928 = load double, ptr %926, align 8, !noalias !22
  %929 = fdiv double %928, %920
  %930 = fmul double %923, %923
  %931 = fmul double %927, %927
  %932 = fadd double %930, %931
  %933 = fmul double %929, %929
  %934 = fadd double %932, %933
  %935 = fadd double %910, %934
  %936 = add nuw nsw i64 %911, 1
  %937 = icmp eq i64 %936, %886
  br i1 %937, label %938, label %909, !llvm.loop !28

938:                                              ; preds = %909, %903
  %939 = phi double [ 0.000000e+00, %903 ], [ %935, %909 ]
  %940 = mul nsw i64 %886, 3
  %941 = sitofp i64 %940 to double
  %942 = fdiv double %939, %941
  %943 = tail call double @llvm.sqrt.f64(double %942)
  %944 = fcmp oeq double %943, 0.000000e+00
  %945 = fcmp ogt double %883, 0.000000e+00
  %946 = select i1 %944, i1 %945, i1 false
  br i1 %946, label %947, label %949

947:                                              ; preds = %938
  %948 = add nuw nsw i64 %704, 1
  br label %1093

949:                                              ; preds = %938
  %950 = fcmp ogt double %701, 0.000000e+00
  %951 = select i1 %950, i1 %710, i1 false
  br i1 %951, label %952, label %965

952:                                              ; preds = %949
  %953 = fdiv double %943, %701
  %954 = fcmp ult double %953, 1.000000e+00
  br i1 %954, label %955, label %963

955:                                              ; preds = %952
  %956 = sub nsw i64 5, %704
  %957 = sitofp i64 %956 to double
  %958 = tail call double @llvm.pow.f64(double %953, double %957)
  %959 = fsub double 1.000000e+00, %953
  %960 = fdiv double %958, %959
  %961 = fmul double %943, %960
  %962 = fcmp ogt double %961, %111
  br i1 %962, label %963, label %965

963:                                              ; preds = %955, %952
  %964 = add nuw nsw i64 %704, 1
  br label %1093

965:                                              ; preds = %955, %949
  %966 = phi double [ %702, %949 ], [ %953, %955 ]
  br i1 %695, label %978, label %967

967:                                              ; preds = %996, %965
  %968 = fsub double 1.000000e+00, %966
  %969 = fdiv double %966, %968
  %970 = fmul double %943, %969
  %971 = fcmp olt double %970, %111
  %972 = select i1 %950, i1 %971, i1 false
  %973 = select i1 %944, i1 true, i1 %972
  %974 = add nuw nsw i64 %704, 1
  %975 = select i1 %973, i64 %974, i64 0
  %976 = select i1 %710, i64 %975, i64 %703
  %977 = icmp sgt i64 %976, 0
  br i1 %977, label %1019, label %1092

978:                                              ; preds = %965, %996
  %979 = phi i64 [ %997, %996 ], [ 0, %965 ]
  %980 = getelementptr inbounds double, ptr %687, i64 %979
  %981 = load double, ptr %980, align 8, !noalias !22
  %982 = getelementptr inbounds double, ptr %685, i64 %979
  %983 = load double, ptr %982, align 8, !noalias !22
  %984 = fadd double %981, %983
  store double %984, ptr %982, align 8, !noalias !22
  %985 = getelementptr inbounds { double, double }, ptr %688, i64 %979
  %986 = load double, ptr %985, align 8, !noalias !22
  %987 = getelementptr inbounds i8, ptr %985, i64 8
  %988 = getelementptr double, ptr %696, i64 %979
  %989 = load double, ptr %988, align 8, !noalias !22
  %990 = fadd double %986, %989
  store double %990, ptr %988, align 8, !noalias !22
  %991 = load double, ptr %987, align 8, !noalias !22
  %992 = getelementptr double, ptr %698, i64 %979
  %993 = load double, ptr %992, align 8, !noalias !22
  %994 = fadd double %991, %993
  store double %994, ptr %992, align 8, !noalias !22
  %995 = getelementptr double, ptr %684, i64 %979
  br label %999

996:                                              ; preds = %999
  %997 = add nuw nsw i64 %979, 1
  %998 = icmp eq i64 %997, %680
  br i1 %998, label %967, label %978, !llvm.loop !29

999:                                              ; preds = %978, %999
  %1000 = phi i64 [ 0, %978 ], [ %1017, %999 ]
  %1001 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1000
  %1002 = load double, ptr %1001, align 8, !noalias !22
  %1003 = load double, ptr %982, align 8, !noalias !22
  %1004 = fmul double %1002, %1003
  %1005 = getelementptr inbounds i8, ptr %1001, i64 8
  %1006 = load double, ptr %1005, align 8, !noalias !22
  %1007 = load double, ptr %988, align 8, !noalias !22
  %1008 = fmul double %1006, %1007
  %1009 = fadd double %1004, %1008
  %1010 = getelementptr inbounds i8, ptr %1001, i64 16
  %1011 = load double, ptr %1010, align 8, !noalias !22
  %1012 = load double, ptr %992, align 8, !noalias !22
  %1013 = fmul double %1011, %1012
  %1014 = fadd double %1009, %1013
  %1015 = mul nuw nsw i64 %680, %1000
  %1016 = getelementptr double, ptr %995, i64 %1015
  store double %1014, ptr %1016, align 8, !noalias !22
  %1017 = add nuw nsw i64 %1000, 1
  %1018 = icmp eq i64 %1017, 3
  br i1 %1018, label %996, label %999, !llvm.loop !30

1019:                                             ; preds = %967
  br i1 %699, label %1093, label %1020

1020:                                             ; preds = %1019
  %1021 = load i64, ptr %283, align 8, !noalias !22
  %1022 = load ptr, ptr %67, align 8, !noalias !22
  %1023 = getelementptr inbounds i8, ptr %1022, i64 40
  %1024 = load i64, ptr %1023, align 8, !noalias !22
  %1025 = load ptr, ptr %286, align 8, !noalias !22
  %1026 = load ptr, ptr %284, align 8, !noalias !22
  %1027 = load ptr, ptr %287, align 8, !noalias !22
  %1028 = icmp sgt i64 %1024, 0
  br i1 %1028, label %1029, label %1089

1029:                                             ; preds = %1020
  %1030 = load i64, ptr %285, align 8, !noalias !22
  %1031 = icmp sgt i64 %1021, 0
  %1032 = getelementptr double, ptr %1026, i64 %1030
  %1033 = shl i64 %1030, 4
  %1034 = getelementptr i8, ptr %1026, i64 %1033
  br label %1035

1035:                                             ; preds = %1029, %1085
  %1036 = phi double [ 0.000000e+00, %1029 ], [ %1086, %1085 ]
  %1037 = phi i64 [ 0, %1029 ], [ %1087, %1085 ]
  br i1 %1031, label %1038, label %1041

1038:                                             ; preds = %1035
  %1039 = add nuw i64 %1037, %1021
  %1040 = load ptr, ptr %66, align 8, !noalias !22
  br label %1046

1041:                                             ; preds = %1046, %1035
  %1042 = phi double [ 0.000000e+00, %1035 ], [ %1078, %1046 ]
  %1043 = phi double [ 0.000000e+00, %1035 ], [ %1062, %1046 ]
  %1044 = fmul double %1036, %1042
  %1045 = fcmp ogt double %1043, %1044
  br i1 %1045, label %1081, label %1085

1046:                                             ; preds = %1038, %1046
  %1047 = phi double [ 0.000000e+00, %1038 ], [ %1062, %1046 ]
  %1048 = phi double [ 0.000000e+00, %1038 ], [ %1078, %1046 ]
  %1049 = phi i64 [ 0, %1038 ], [ %1079, %1046 ]
  %1050 = mul nuw nsw i64 %1049, %1024
  %1051 = add i64 %1039, %1050
  %1052 = getelementptr inbounds double, ptr %1025, i64 %1051
  %1053 = load double, ptr %1052, align 8, !noalias !22
  %1054 = fmul double %1053, %1053
  %1055 = getelementptr inbounds { double, double }, ptr %1027, i64 %1051
  %1056 = load double, ptr %1055, align 8, !noalias !22
  %1057 = getelementptr inbounds i8, ptr %1055, i64 8
  %1058 = load double, ptr %1057, align 8, !noalias !22
  %1059 = tail call double @hypot(double noundef %1056, double noundef %1058) #13
  %1060 = fmul double %1059, %1059
  %1061 = fadd double %1054, %1060
  %1062 = fadd double %1047, %1061
  %1063 = getelementptr inbounds double, ptr %1040, i64 %1051
  %1064 = load double, ptr %1063, align 8, !noalias !22
  %1065 = fmul double %1064, %1064
  %1066 = fadd double %1048, %1065
  %1067 = getelementptr inbounds double, ptr %1026, i64 %1051
  %1068 = load double, ptr %1067, align 8, !noalias !22
  %1069 = fmul double %1068, %1068
  %1070 = getelementptr double, ptr %1032, i64 %1051
  %1071 = load double, ptr %1070, align 8, !noalias !22
  %1072 = fmul double %1071, %1071
  %1073 = fadd double %1069, %1072
  %1074 = getelementptr double, ptr %1034, i64 %1051
  %1075 = load double, ptr %1074, align 8, !noalias !22
  %1076 = fmul double %1075, %1075
  %1077 = fadd double %1073, %1076
  %1078 = fadd double %1066, %1077
  %1079 = add nuw nsw i64 %1049, 1
  %1080 = icmp eq i64 %1079, %1021
  br i1 %1080, label %1041, label %1046, !llvm.loop !31

1081:                                             ; preds = %1041
  %1082 = fcmp ogt double %1042, 0.000000e+00
  %1083 = fdiv double %1043, %1042
  %1084 = select i1 %1082, double %1083, double 1.000000e+00
  br label %1085

1085:                                             ; preds = %1081, %1041
  %1086 = phi double [ %1084, %1081 ], [ %1036, %1041 ]
  %1087 = add nuw nsw i64 %1037, 1
  %1088 = icmp eq i64 %1087, %1024
  br i1 %1088, label %1089, label %1035, !llvm.loop !32

1089:                                             ; preds = %1085, %1020
  %1090 = phi double [ 0.000000e+00, %1020 ], [ %1086, %1085 ]
  %1091 = fcmp ugt double %1090, %288
  br i1 %1091, label %1092, label %1093

1092:                                             ; preds = %1089, %967
  br label %1093

1093:                                             ; preds = %1092, %1089, %1019, %963, %947
  %1094 = phi double [ %702, %947 ], [ %953, %963 ], [ %763, %1019 ], [ %763, %1092 ], [ %763, %1089 ]
  %1095 = phi i32 [ 0, %947 ], [ 0, %963 ], [ %764, %1019 ], [ %764, %1092 ], [ %764, %1089 ]
  %1096 = phi i64 [ %948, %947 ], [ %964, %963 ], [ %765, %1019 ], [ %765, %1092 ], [ %765, %1089 ]
  %1097 = phi i64 [ 0, %947 ], [ 0, %963 ], [ %766, %1019 ], [ %766, %1092 ], [ %766, %1089 ]
  %1098 = phi i1 [ false, %947 ], [ false, %963 ], [ false, %1019 ], [ true, %1092 ], [ false, %1089 ]
  %1099 = phi i32 [ 1, %947 ], [ 1, %963 ], [ 2, %1019 ], [ 0, %1092 ], [ 2, %1089 ]
  %1100 = phi i64 [ %703, %947 ], [ 0, %963 ], [ %976, %1019 ], [ %976, %1092 ], [ %976, %1089 ]
  %1101 = phi double [ %702, %947 ], [ %953, %963 ], [ %966, %1019 ], [ %966, %1092 ], [ %966, %1089 ]
  %1102 = phi double [ %701, %947 ], [ %701, %963 ], [ %701, %1019 ], [ %943, %1092 ], [ %701, %1089 ]
  br i1 %1098, label %1103, label %1106

1103:                                             ; preds = %1093
  %1104 = add nuw nsw i64 %704, 1
  %1105 = icmp eq i64 %1104, %690
  br i1 %1105, label %1106, label %700, !llvm.loop !33

1106:                                             ; preds = %879, %1093, %761, %700, %1103
  %1107 = phi double [ %708, %700 ], [ %1094, %1093 ], [ %763, %761 ], [ %1094, %1103 ], [ 0x7FF0000000000000, %879 ]
  %1108 = phi i32 [ %707, %700 ], [ %1095, %1093 ], [ %764, %761 ], [ %1095, %1103 ], [ 0, %879 ]
  %1109 = phi i64 [ %706, %700 ], [ %1096, %1093 ], [ %765, %761 ], [ %1096, %1103 ], [ %704, %879 ]
  %1110 = phi i64 [ %705, %700 ], [ %1097, %1093 ], [ %766, %761 ], [ %1097, %1103 ], [ 0, %879 ]
  %1111 = phi i32 [ 2, %700 ], [ %1099, %1093 ], [ %767, %761 ], [ 2, %1103 ], [ 1, %879 ]
  %1112 = phi i64 [ 0, %700 ], [ %1100, %1093 ], [ %703, %761 ], [ %1100, %1103 ], [ %703, %879 ]
  %1113 = phi double [ %702, %700 ], [ %1101, %1093 ], [ %702, %761 ], [ %1101, %1103 ], [ %702, %879 ]
  %1114 = icmp eq i32 %1111, 2
  br i1 %1114, label %1115, label %1119

1115:                                             ; preds = %1106
  %1116 = icmp sgt i64 %1112, 0
  %1117 = select i1 %1116, i64 %1112, i64 6
  %1118 = zext i1 %1116 to i32
  br label %1119

1119:                                             ; preds = %1106, %1115
  %1120 = phi double [ %1113, %1115 ], [ %1107, %1106 ]
  %1121 = phi i32 [ %1118, %1115 ], [ %1108, %1106 ]
  %1122 = phi i64 [ %1117, %1115 ], [ %1109, %1106 ]
  %1123 = phi i64 [ 0, %1115 ], [ %1110, %1106 ]
  %1124 = icmp slt i64 %1123, 0
  br i1 %1124, label %1759, label %1125

1125:                                             ; preds = %1119
  %1126 = icmp eq i32 %1121, 0
  br i1 %1126, label %1128, label %1127

1127:                                             ; preds = %1125
  br i1 %289, label %1279, label %1178

1128:                                             ; preds = %1125
  %1129 = load i64, ptr %231, align 8
  %1130 = add nsw i64 %1129, 1
  store i64 %1130, ptr %231, align 8
  %1131 = tail call double @llvm.fabs.f64(double %1120)
  %1132 = fcmp ueq double %1131, 0x7FF0000000000000
  %1133 = select i1 %1132, i64 4, i64 7
  %1134 = icmp eq i64 %1123, 0
  %1135 = select i1 %1134, i64 %1133, i64 3
  store i64 %1135, ptr %340, align 8
  %1136 = load i64, ptr %341, align 8
  %1137 = icmp eq i64 %1136, 1
  %1138 = and i1 %1134, %1137
  br i1 %1138, label %1139, label %1165

1139:                                             ; preds = %1128
  %1140 = load i64, ptr %343, align 8
  %1141 = icmp sgt i64 %1140, 0
  br i1 %1141, label %1142, label %1159

1142:                                             ; preds = %1139, %1151
  %1143 = phi i64 [ %1156, %1151 ], [ 0, %1139 ]
  %1144 = phi i32 [ %1153, %1151 ], [ 0, %1139 ]
  %1145 = icmp eq i32 %1144, 0
  br i1 %1145, label %1146, label %1151

1146:                                             ; preds = %1142
  %1147 = load ptr, ptr %342, align 8
  %1148 = getelementptr inbounds double, ptr %1147, i64 %1143
  %1149 = load double, ptr %1148, align 8
  %1150 = fcmp une double %1149, 0.000000e+00
  br label %1151

1151:                                             ; preds = %1146, %1142
  %1152 = phi i1 [ true, %1142 ], [ %1150, %1146 ]
  %1153 = zext i1 %1152 to i32
  %1154 = load ptr, ptr %342, align 8
  %1155 = getelementptr inbounds double, ptr %1154, i64 %1143
  store double 0.000000e+00, ptr %1155, align 8
  %1156 = add nuw nsw i64 %1143, 1
  %1157 = load i64, ptr %343, align 8
  %1158 = icmp slt i64 %1156, %1157
  br i1 %1158, label %1142, label %1159, !llvm.loop !34

1159:                                             ; preds = %1151, %1139
  %1160 = phi i32 [ 0, %1139 ], [ %1153, %1151 ]
  %1161 = icmp eq i32 %1160, 0
  br i1 %1161, label %1163, label %1162

1162:                                             ; preds = %1159
  store i64 0, ptr %252, align 8
  br label %1759, !llvm.loop !17

1163:                                             ; preds = %1159
  store i64 0, ptr %341, align 8
  %1164 = fmul double %387, 5.000000e-01
  br label %1165

1165:                                             ; preds = %1163, %1128
  %1166 = phi double [ %1164, %1163 ], [ %352, %1128 ]
  %1167 = load i64, ptr %341, align 8
  %1168 = icmp eq i64 %1167, 1
  %1169 = icmp ne i64 %1123, 0
  %1170 = or i1 %1169, %1168
  br i1 %1170, label %1171, label %1174

1171:                                             ; preds = %1165
  %1172 = select i1 %1134, double 5.000000e-01, double 2.500000e-01
  %1173 = fmul double %387, %1172
  store double 0.000000e+00, ptr %260, align 8
  br label %1174

1174:                                             ; preds = %1165, %1171
  %1175 = phi double [ %1173, %1171 ], [ %1166, %1165 ]
  %1176 = load i64, ptr %341, align 8
  %1177 = sub nsw i64 1, %1176
  store i64 %1177, ptr %234, align 8
  br label %1759, !llvm.loop !17

1178:                                             ; preds = %1279, %1127
  %1179 = load i64, ptr %292, align 8
  %1180 = icmp eq i64 %1179, 1
  %1181 = load ptr, ptr %65, align 8
  %1182 = getelementptr inbounds i8, ptr %1181, i64 8
  %1183 = load i64, ptr %1182, align 8
  %1184 = load i64, ptr %294, align 8
  %1185 = load ptr, ptr %295, align 8
  %1186 = load ptr, ptr %266, align 8
  %1187 = icmp sgt i64 %1183, 0
  br i1 %1187, label %1188, label %1190

1188:                                             ; preds = %1178
  %1189 = shl i64 %1183, 4
  br label %1199

1190:                                             ; preds = %1199, %1178
  %1191 = load ptr, ptr %297, align 8
  %1192 = load ptr, ptr %293, align 8
  tail call fastcc void @real_solve(ptr noundef %1191, i64 noundef %1184, ptr noundef %1192, ptr noundef %1186) #10
  %1193 = load ptr, ptr %298, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1186, ptr noundef %1193, ptr noundef nonnull %66, i64 noundef %1183) #10
  %1194 = load double, ptr %6, align 8
  %1195 = fcmp uge double %1194, 1.000000e+00
  %1196 = and i1 %1180, %1195
  br i1 %1196, label %1197, label %1275

1197:                                             ; preds = %1190
  %1198 = icmp sgt i64 %1183, 0
  br i1 %1198, label %1247, label %1224

1199:                                             ; preds = %1188, %1199
  %1200 = phi i64 [ 0, %1188 ], [ %1222, %1199 ]
  %1201 = load ptr, ptr %262, align 8
  %1202 = getelementptr inbounds double, ptr %1201, i64 %1200
  %1203 = load double, ptr %1202, align 8
  %1204 = fmul double %1203, 0x402418FD8BAFFE05
  %1205 = getelementptr double, ptr %1201, i64 %1183
  %1206 = getelementptr double, ptr %1205, i64 %1200
  %1207 = load double, ptr %1206, align 8
  %1208 = fmul double %1207, 0x3FF61D41B2D54580
  %1209 = fsub double %1208, %1204
  %1210 = getelementptr i8, ptr %1201, i64 %1189
  %1211 = getelementptr double, ptr %1210, i64 %1200
  %1212 = load double, ptr %1211, align 8
  %1213 = fmul double %1212, 0x3FD5555555555555
  %1214 = fsub double %1209, %1213
  %1215 = fdiv double %1214, %387
  %1216 = getelementptr inbounds double, ptr %1185, i64 %1200
  store double %1215, ptr %1216, align 8
  %1217 = load ptr, ptr %296, align 8
  %1218 = getelementptr inbounds double, ptr %1217, i64 %1200
  %1219 = load double, ptr %1218, align 8
  %1220 = fadd double %1219, %1215
  %1221 = getelementptr inbounds double, ptr %1186, i64 %1200
  store double %1220, ptr %1221, align 8
  %1222 = add nuw nsw i64 %1200, 1
  %1223 = icmp eq i64 %1222, %1183
  br i1 %1223, label %1190, label %1199, !llvm.loop !35

1224:                                             ; preds = %1247, %1197
  %1225 = load ptr, ptr %72, align 8
  %1226 = getelementptr inbounds i8, ptr %1225, i64 24
  %1227 = load i64, ptr %1226, align 8
  %1228 = add nsw i64 %1227, 1
  store i64 %1228, ptr %1226, align 8
  %1229 = load ptr, ptr %300, align 8
  %1230 = load ptr, ptr %265, align 8
  %1231 = load ptr, ptr %301, align 8
  store double %351, ptr %1231, align 8
  %1232 = load i64, ptr %302, align 8
  %1233 = icmp sgt i64 %1232, 0
  br i1 %1233, label %1234, label %1235

1234:                                             ; preds = %1224
  tail call fastcc void @sample(ptr noundef nonnull %65) #10
  br label %1235

1235:                                             ; preds = %1224, %1234
  %1236 = load ptr, ptr %65, align 8
  %1237 = load i64, ptr %1236, align 8
  %1238 = load ptr, ptr %301, align 8
  %1239 = load ptr, ptr %303, align 8
  %1240 = load ptr, ptr %304, align 8
  %1241 = inttoptr i64 %1237 to ptr
  %1242 = tail call i32 %1241(ptr noundef %1238, ptr noundef %1229, ptr noundef %1239, ptr noundef %1240, ptr noundef %1230) #11
  %1243 = sext i32 %1242 to i64
  %1244 = icmp eq i32 %1242, 0
  br i1 %1244, label %1245, label %1275

1245:                                             ; preds = %1235
  %1246 = icmp sgt i64 %1183, 0
  br i1 %1246, label %1264, label %1259

1247:                                             ; preds = %1197, %1247
  %1248 = phi i64 [ %1257, %1247 ], [ 0, %1197 ]
  %1249 = load ptr, ptr %66, align 8
  %1250 = getelementptr inbounds double, ptr %1249, i64 %1248
  %1251 = load double, ptr %1250, align 8
  %1252 = getelementptr inbounds double, ptr %1186, i64 %1248
  %1253 = load double, ptr %1252, align 8
  %1254 = fadd double %1251, %1253
  %1255 = load ptr, ptr %299, align 8
  %1256 = getelementptr inbounds double, ptr %1255, i64 %1248
  store double %1254, ptr %1256, align 8
  %1257 = add nuw nsw i64 %1248, 1
  %1258 = icmp eq i64 %1257, %1183
  br i1 %1258, label %1224, label %1247, !llvm.loop !36

1259:                                             ; preds = %1264, %1245
  %1260 = load ptr, ptr %297, align 8
  %1261 = load ptr, ptr %293, align 8
  tail call fastcc void @real_solve(ptr noundef %1260, i64 noundef %1184, ptr noundef %1261, ptr noundef %1186) #10
  %1262 = load ptr, ptr %298, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1186, ptr noundef %1262, ptr noundef nonnull %66, i64 noundef %1183) #10
  %1263 = load double, ptr %7, align 8
  br label %1275

1264:                                             ; preds = %1245, %1264
  %1265 = phi i64 [ %1273, %1264 ], [ 0, %1245 ]
  %1266 = load ptr, ptr %265, align 8
  %1267 = getelementptr inbounds double, ptr %1266, i64 %1265
  %1268 = load double, ptr %1267, align 8
  %1269 = getelementptr inbounds double, ptr %1185, i64 %1265
  %1270 = load double, ptr %1269, align 8
  %1271 = fadd double %1268, %1270
  %1272 = getelementptr inbounds double, ptr %1186, i64 %1265
  store double %1271, ptr %1272, align 8
  %1273 = add nuw nsw i64 %1265, 1
  %1274 = icmp eq i64 %1273, %1183
  br i1 %1274, label %1259, label %1264, !llvm.loop !37

1275:                                             ; preds = %1190, %1235, %1259
  %1276 = phi double [ %1263, %1259 ], [ %1194, %1235 ], [ %1194, %1190 ]
  %1277 = phi i64 [ 0, %1259 ], [ %1243, %1235 ], [ 0, %1190 ]
  %1278 = icmp slt i64 %1277, 0
  br i1 %1278, label %1759, label %1293

1279:                                             ; preds = %1127, %1279
  %1280 = phi i64 [ %1291, %1279 ], [ 0, %1127 ]
  %1281 = load ptr, ptr %66, align 8
  %1282 = getelementptr inbounds double, ptr %1281, i64 %1280
  %1283 = load double, ptr %1282, align 8
  %1284 = load ptr, ptr %262, align 8
  %1285 = getelementptr i8, ptr %1284, i64 %290
  %1286 = getelementptr double, ptr %1285, i64 %1280
  %1287 = load double, ptr %1286, align 8
  %1288 = fadd double %1283, %1287
  %1289 = load ptr, ptr %291, align 8
  %1290 = getelementptr inbounds double, ptr %1289, i64 %1280
  store double %1288, ptr %1290, align 8
  %1291 = add nuw nsw i64 %1280, 1
  %1292 = icmp eq i64 %1291, %81
  br i1 %1292, label %1178, label %1279, !llvm.loop !38

1293:                                             ; preds = %1275
  %1294 = add nsw i64 %1122, 12
  %1295 = sitofp i64 %1294 to double
  %1296 = fdiv double 0x4027666666666667, %1295
  %1297 = fcmp olt double %1276, 1.000000e-10
  %1298 = select i1 %1297, double 1.000000e-10, double %1276
  %1299 = tail call double @llvm.pow.f64(double %1298, double -2.500000e-01)
  %1300 = icmp eq i64 %1277, 0
  %1301 = fcmp olt double %1276, 1.000000e+00
  %1302 = select i1 %1300, i1 %1301, i1 false
  br i1 %1302, label %1318, label %1303

1303:                                             ; preds = %1293
  %1304 = load i64, ptr %231, align 8
  %1305 = add nsw i64 %1304, 1
  store i64 %1305, ptr %231, align 8
  %1306 = select i1 %1300, i64 2, i64 3
  store i64 %1306, ptr %305, align 8
  %1307 = tail call double @llvm.fabs.f64(double %1276)
  %1308 = fcmp ueq double %1307, 0x7FF0000000000000
  br i1 %1308, label %1313, label %1309

1309:                                             ; preds = %1303
  %1310 = fmul double %1296, %1299
  %1311 = fcmp ogt double %1310, 2.000000e-01
  %1312 = select i1 %1311, double %1310, double 2.000000e-01
  br label %1313

1313:                                             ; preds = %1303, %1309
  %1314 = phi double [ %1312, %1309 ], [ 2.500000e-01, %1303 ]
  %1315 = fmul double %387, %1314
  store i64 1, ptr %292, align 8
  %1316 = load i64, ptr %306, align 8
  %1317 = sub nsw i64 1, %1316
  store i64 %1317, ptr %234, align 8
  br label %1759, !llvm.loop !17

1318:                                             ; preds = %1293
  br i1 %92, label %1319, label %1333

1319:                                             ; preds = %1318
  %1320 = load ptr, ptr %298, align 8
  %1321 = load ptr, ptr %89, align 8
  %1322 = getelementptr inbounds i8, ptr %1321, i64 56
  %1323 = load i64, ptr %1322, align 8
  %1324 = inttoptr i64 %1323 to ptr
  %1325 = tail call i64 %1324(ptr noundef %0, double noundef %388, ptr noundef %1320) #11
  %1326 = icmp eq i64 %1325, 0
  br i1 %1326, label %1333, label %1327

1327:                                             ; preds = %1319
  %1328 = load i64, ptr %231, align 8
  %1329 = add nsw i64 %1328, 1
  store i64 %1329, ptr %231, align 8
  store i64 6, ptr %307, align 8
  %1330 = fmul double %387, 2.500000e-01
  store i64 1, ptr %292, align 8
  %1331 = load i64, ptr %308, align 8
  %1332 = sub nsw i64 1, %1331
  store i64 %1332, ptr %234, align 8
  br label %1759, !llvm.loop !17

1333:                                             ; preds = %1319, %1318
  %1334 = load i64, ptr %230, align 8
  %1335 = add nsw i64 %1334, 1
  store i64 %1335, ptr %230, align 8
  %1336 = load double, ptr %309, align 8
  %1337 = fcmp ogt double %1336, 0.000000e+00
  br i1 %1337, label %1338, label %1347

1338:                                             ; preds = %1333
  %1339 = fdiv double %1336, %1298
  %1340 = tail call double @llvm.pow.f64(double %1339, double 2.500000e-01)
  %1341 = load double, ptr %310, align 8
  %1342 = fdiv double %387, %1341
  %1343 = fmul double %1340, %1342
  %1344 = fcmp olt double %1343, 1.000000e+00
  %1345 = select i1 %1344, double %1343, double 1.000000e+00
  %1346 = fmul double %1299, %1345
  br label %1347

1347:                                             ; preds = %1338, %1333
  %1348 = phi double [ %1346, %1338 ], [ %1299, %1333 ]
  %1349 = fmul double %1296, %1348
  %1350 = fcmp olt double %1349, 1.000000e+01
  store double %388, ptr %69, align 8
  store double %387, ptr %311, align 8
  store double %1298, ptr %309, align 8
  %1351 = load ptr, ptr %65, align 8
  %1352 = getelementptr inbounds i8, ptr %1351, i64 8
  %1353 = load i64, ptr %1352, align 8
  %1354 = load i64, ptr %312, align 8
  %1355 = load ptr, ptr %262, align 8
  %1356 = load ptr, ptr %313, align 8
  %1357 = load ptr, ptr %261, align 8
  br label %1374

1358:                                             ; preds = %1374
  %1359 = select i1 %1350, double %1349, double 1.000000e+01
  %1360 = icmp sgt i64 %1353, 0
  br i1 %1360, label %1361, label %1434

1361:                                             ; preds = %1358
  %1362 = load double, ptr %8, align 16
  %1363 = load double, ptr %314, align 8
  %1364 = getelementptr double, ptr %1355, i64 %1353
  %1365 = load double, ptr %315, align 16
  %1366 = shl i64 %1353, 4
  %1367 = getelementptr i8, ptr %1355, i64 %1366
  %1368 = load double, ptr %9, align 16
  %1369 = load double, ptr %316, align 8
  %1370 = load double, ptr %317, align 16
  %1371 = getelementptr double, ptr %1356, i64 %1354
  %1372 = shl i64 %1354, 4
  %1373 = getelementptr i8, ptr %1356, i64 %1372
  br label %1385

1374:                                             ; preds = %1347, %1374
  %1375 = phi i64 [ 0, %1347 ], [ %1383, %1374 ]
  %1376 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1375
  %1377 = getelementptr inbounds i8, ptr %1376, i64 8
  %1378 = load double, ptr %1377, align 8
  %1379 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1375
  store double %1378, ptr %1379, align 8
  %1380 = getelementptr inbounds i8, ptr %1376, i64 16
  %1381 = load double, ptr %1380, align 8
  %1382 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1375
  store double %1381, ptr %1382, align 8
  %1383 = add nuw nsw i64 %1375, 1
  %1384 = icmp eq i64 %1383, 3
  br i1 %1384, label %1358, label %1374, !llvm.loop !39

1385:                                             ; preds = %1361, %1422
  %1386 = phi i64 [ 0, %1361 ], [ %1423, %1422 ]
  %1387 = getelementptr inbounds double, ptr %1355, i64 %1386
  %1388 = load double, ptr %1387, align 8
  %1389 = fmul double %1362, %1388
  %1390 = getelementptr double, ptr %1364, i64 %1386
  %1391 = load double, ptr %1390, align 8
  %1392 = fmul double %1363, %1391
  %1393 = fadd double %1389, %1392
  %1394 = getelementptr double, ptr %1367, i64 %1386
  %1395 = load double, ptr %1394, align 8
  %1396 = fmul double %1365, %1395
  %1397 = fadd double %1393, %1396
  %1398 = fmul double %1388, %1368
  %1399 = fmul double %1391, %1369
  %1400 = fadd double %1398, %1399
  %1401 = fmul double %1395, %1370
  %1402 = fadd double %1400, %1401
  %1403 = load ptr, ptr %298, align 8
  %1404 = getelementptr inbounds double, ptr %1403, i64 %1386
  %1405 = load double, ptr %1404, align 8
  %1406 = load ptr, ptr %66, align 8
  %1407 = getelementptr inbounds double, ptr %1406, i64 %1386
  %1408 = load double, ptr %1407, align 8
  %1409 = fsub double %1405, %1408
  %1410 = getelementptr inbounds double, ptr %1356, i64 %1386
  store double %1409, ptr %1410, align 8
  %1411 = fneg double %1397
  %1412 = fsub double %1411, %1402
  %1413 = getelementptr double, ptr %1371, i64 %1386
  store double %1412, ptr %1413, align 8
  %1414 = fneg double %1402
  %1415 = getelementptr double, ptr %1373, i64 %1386
  store double %1414, ptr %1415, align 8
  %1416 = load ptr, ptr %66, align 8
  %1417 = getelementptr inbounds double, ptr %1416, i64 %1386
  %1418 = load double, ptr %1417, align 8
  %1419 = getelementptr inbounds double, ptr %1357, i64 %1386
  store double %1418, ptr %1419, align 8
  %1420 = getelementptr double, ptr %1356, i64 %1386
  %1421 = getelementptr double, ptr %1357, i64 %1386
  br label %1425

1422:                                             ; preds = %1425
  %1423 = add nuw nsw i64 %1386, 1
  %1424 = icmp eq i64 %1423, %1353
  br i1 %1424, label %1434, label %1385, !llvm.loop !40

1425:                                             ; preds = %1385, %1425
  %1426 = phi i64 [ 0, %1385 ], [ %1430, %1425 ]
  %1427 = mul nsw i64 %1354, %1426
  %1428 = getelementptr double, ptr %1420, i64 %1427
  %1429 = load double, ptr %1428, align 8
  %1430 = add nuw nsw i64 %1426, 1
  %1431 = mul nuw nsw i64 %1353, %1430
  %1432 = getelementptr double, ptr %1421, i64 %1431
  store double %1429, ptr %1432, align 8
  %1433 = icmp eq i64 %1430, 3
  br i1 %1433, label %1422, label %1425, !llvm.loop !41

1434:                                             ; preds = %1422, %1358
  store double %387, ptr %260, align 8
  %1435 = load ptr, ptr %0, align 8
  %1436 = getelementptr inbounds i8, ptr %1435, i64 24
  %1437 = load i64, ptr %1436, align 8
  %1438 = load ptr, ptr %229, align 8
  %1439 = getelementptr inbounds i8, ptr %1438, i64 8
  %1440 = load i64, ptr %1439, align 8
  %1441 = icmp eq i64 %1440, 0
  br i1 %1441, label %1488, label %1442

1442:                                             ; preds = %1434
  %1443 = load i64, ptr %1438, align 8
  %1444 = load ptr, ptr %65, align 8
  %1445 = getelementptr inbounds i8, ptr %1444, i64 8
  %1446 = load i64, ptr %1445, align 8
  %1447 = load ptr, ptr %318, align 8
  %1448 = load i64, ptr %319, align 8
  %1449 = mul nsw i64 %1448, %1443
  %1450 = getelementptr inbounds double, ptr %1447, i64 %1449
  %1451 = getelementptr inbounds double, ptr %1450, i64 %1448
  store double %351, ptr %1450, align 8
  %1452 = getelementptr inbounds i8, ptr %1450, i64 8
  store double %387, ptr %1452, align 8
  store double %388, ptr %1451, align 8
  %1453 = getelementptr inbounds i8, ptr %1451, i64 8
  store double 0.000000e+00, ptr %1453, align 8
  %1454 = icmp sgt i64 %1446, 0
  br i1 %1454, label %1455, label %1458

1455:                                             ; preds = %1442
  %1456 = getelementptr i8, ptr %1450, i64 16
  %1457 = icmp sgt i64 %1437, 0
  br label %1461

1458:                                             ; preds = %1473, %1442
  %1459 = add nsw i64 %1443, 1
  %1460 = load ptr, ptr %229, align 8
  store i64 %1459, ptr %1460, align 8
  br label %1488

1461:                                             ; preds = %1455, %1473
  %1462 = phi i64 [ 0, %1455 ], [ %1474, %1473 ]
  %1463 = load ptr, ptr %66, align 8
  %1464 = getelementptr inbounds double, ptr %1463, i64 %1462
  %1465 = load double, ptr %1464, align 8
  %1466 = add nuw nsw i64 %1462, 2
  %1467 = getelementptr inbounds double, ptr %1450, i64 %1466
  store double %1465, ptr %1467, align 8
  %1468 = load ptr, ptr %298, align 8
  %1469 = getelementptr inbounds double, ptr %1468, i64 %1462
  %1470 = load double, ptr %1469, align 8
  %1471 = getelementptr inbounds double, ptr %1451, i64 %1466
  store double %1470, ptr %1471, align 8
  %1472 = getelementptr double, ptr %1456, i64 %1462
  br i1 %1457, label %1476, label %1473

1473:                                             ; preds = %1476, %1461
  %1474 = add nuw nsw i64 %1462, 1
  %1475 = icmp eq i64 %1474, %1446
  br i1 %1475, label %1458, label %1461, !llvm.loop !42

1476:                                             ; preds = %1461, %1476
  %1477 = phi i64 [ %1484, %1476 ], [ 0, %1461 ]
  %1478 = load ptr, ptr %313, align 8
  %1479 = load i64, ptr %312, align 8
  %1480 = mul nsw i64 %1479, %1477
  %1481 = getelementptr double, ptr %1478, i64 %1480
  %1482 = getelementptr double, ptr %1481, i64 %1462
  %1483 = load double, ptr %1482, align 8
  %1484 = add nuw nsw i64 %1477, 1
  %1485 = mul nuw nsw i64 %1484, %1446
  %1486 = getelementptr double, ptr %1472, i64 %1485
  store double %1483, ptr %1486, align 8
  %1487 = icmp eq i64 %1484, %1437
  br i1 %1487, label %1473, label %1476, !llvm.loop !43

1488:                                             ; preds = %1434, %1458
  br i1 %97, label %1494, label %1489

1489:                                             ; preds = %1488
  %1490 = load i64, ptr %320, align 8
  %1491 = getelementptr inbounds double, ptr %83, i64 %1490
  %1492 = load double, ptr %1491, align 8
  %1493 = fcmp ugt double %1492, %388
  br i1 %1493, label %1709, label %1494

1494:                                             ; preds = %1489, %1488
  %1495 = load ptr, ptr %68, align 8
  %1496 = load ptr, ptr %93, align 8
  %1497 = getelementptr inbounds i8, ptr %1496, i64 8
  %1498 = load i64, ptr %1497, align 8
  %1499 = icmp sgt i64 %1498, 0
  br i1 %1499, label %1500, label %1510

1500:                                             ; preds = %1494
  %1501 = getelementptr inbounds i8, ptr %1496, i64 16
  %1502 = load i64, ptr %1501, align 8
  %1503 = inttoptr i64 %1502 to ptr
  %1504 = tail call i64 %1503(ptr noundef %0, double noundef %351, double noundef %387) #11
  %1505 = icmp eq i64 %1504, -6
  br i1 %1505, label %1506, label %1507

1506:                                             ; preds = %1500
  store double %351, ptr %1495, align 8
  br label %1685

1507:                                             ; preds = %1500
  %1508 = getelementptr inbounds i8, ptr %1495, i64 48
  %1509 = load double, ptr %1508, align 8
  br label %1510

1510:                                             ; preds = %1507, %1494
  %1511 = phi double [ %1509, %1507 ], [ 1.000000e+00, %1494 ]
  %1512 = phi i64 [ %1504, %1507 ], [ 0, %1494 ]
  %1513 = fcmp oeq double %1511, 1.000000e+00
  br i1 %1513, label %1514, label %1516

1514:                                             ; preds = %1510
  %1515 = load double, ptr %1495, align 8
  br label %1519

1516:                                             ; preds = %1510
  %1517 = fmul double %387, %1511
  %1518 = fadd double %351, %1517
  br label %1519

1519:                                             ; preds = %1516, %1514
  %1520 = phi double [ %1515, %1514 ], [ %1518, %1516 ]
  %1521 = icmp eq i64 %1512, -4
  %1522 = select i1 %1521, i64 -4, i64 0
  br i1 %1521, label %1580, label %1523

1523:                                             ; preds = %1519
  %1524 = fcmp olt double %1511, 1.000000e+00
  %1525 = load ptr, ptr %65, align 8
  %1526 = getelementptr inbounds i8, ptr %1525, i64 8
  %1527 = load i64, ptr %1526, align 8
  %1528 = load i64, ptr %84, align 8
  %1529 = load ptr, ptr %82, align 8
  %1530 = load ptr, ptr %72, align 8
  %1531 = getelementptr inbounds i8, ptr %1530, i64 48
  %1532 = load i64, ptr %1531, align 8
  %1533 = icmp slt i64 %1532, %1528
  br i1 %1533, label %1534, label %1576

1534:                                             ; preds = %1523, %1572
  %1535 = phi i64 [ %1573, %1572 ], [ undef, %1523 ]
  %1536 = phi i64 [ %1574, %1572 ], [ %1532, %1523 ]
  %1537 = getelementptr inbounds double, ptr %1529, i64 %1536
  %1538 = load double, ptr %1537, align 8
  %1539 = fcmp olt double %1538, %1520
  %1540 = fcmp oeq double %1538, %1520
  %1541 = and i1 %1524, %1540
  %1542 = or i1 %1539, %1541
  br i1 %1542, label %1543, label %1576

1543:                                             ; preds = %1534
  %1544 = fsub double %1538, %351
  %1545 = fdiv double %1544, %387
  %1546 = mul nsw i64 %1536, %1527
  %1547 = getelementptr inbounds double, ptr %1, i64 %1546
  %1548 = load ptr, ptr %321, align 8
  %1549 = insertelement <8 x double> poison, double %1545, i64 0
  %1550 = shufflevector <8 x double> %1549, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1550, ptr %1548, align 8
  %1551 = load ptr, ptr %66, align 8
  %1552 = load ptr, ptr %322, align 8
  %1553 = load i64, ptr %323, align 8
  %1554 = load ptr, ptr %0, align 8
  %1555 = getelementptr inbounds i8, ptr %1554, i64 24
  %1556 = load i64, ptr %1555, align 8
  %1557 = load ptr, ptr %321, align 8
  %1558 = load ptr, ptr %65, align 8
  %1559 = getelementptr inbounds i8, ptr %1558, i64 16
  %1560 = load i64, ptr %1559, align 8
  tail call fastcc void @nested(ptr noundef %1547, ptr noundef %1551, ptr noundef %1552, i64 noundef %1553, i64 noundef %1556, ptr noundef %1557, i64 noundef %1560) #10
  %1561 = load ptr, ptr %89, align 8
  %1562 = load i64, ptr %1561, align 8
  %1563 = icmp eq i64 %1562, 1
  br i1 %1563, label %1564, label %1572

1564:                                             ; preds = %1543
  %1565 = load double, ptr %1537, align 8
  %1566 = getelementptr inbounds i8, ptr %1561, i64 56
  %1567 = load i64, ptr %1566, align 8
  %1568 = inttoptr i64 %1567 to ptr
  %1569 = tail call i64 %1568(ptr noundef %0, double noundef %1565, ptr noundef %1547) #11
  %1570 = icmp eq i64 %1569, 0
  %1571 = select i1 %1570, i64 %1535, i64 %1569
  br i1 %1570, label %1572, label %1580

1572:                                             ; preds = %1564, %1543
  %1573 = phi i64 [ %1571, %1564 ], [ %1535, %1543 ]
  %1574 = add i64 %1536, 1
  %1575 = icmp eq i64 %1574, %1528
  br i1 %1575, label %1576, label %1534, !llvm.loop !44

1576:                                             ; preds = %1572, %1534, %1523
  %1577 = phi i64 [ %1532, %1523 ], [ %1528, %1572 ], [ %1536, %1534 ]
  %1578 = load ptr, ptr %72, align 8
  %1579 = getelementptr inbounds i8, ptr %1578, i64 48
  store i64 %1577, ptr %1579, align 8
  br label %1580

1580:                                             ; preds = %1564, %1576, %1519
  %1581 = phi i64 [ %1522, %1519 ], [ 0, %1576 ], [ %1571, %1564 ]
  %1582 = icmp eq i64 %1581, 0
  %1583 = icmp ne i64 %1512, 0
  %1584 = fcmp olt double %1511, 1.000000e+00
  %1585 = and i1 %1584, %1582
  %1586 = and i1 %1583, %1585
  br i1 %1586, label %1587, label %1624

1587:                                             ; preds = %1580
  %1588 = load ptr, ptr %324, align 8
  %1589 = load ptr, ptr %325, align 8
  %1590 = insertelement <8 x double> poison, double %1511, i64 0
  %1591 = shufflevector <8 x double> %1590, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1591, ptr %1589, align 8
  %1592 = load ptr, ptr %66, align 8
  %1593 = load ptr, ptr %326, align 8
  %1594 = load i64, ptr %327, align 8
  %1595 = load ptr, ptr %0, align 8
  %1596 = getelementptr inbounds i8, ptr %1595, i64 24
  %1597 = load i64, ptr %1596, align 8
  %1598 = load ptr, ptr %325, align 8
  %1599 = load ptr, ptr %65, align 8
  %1600 = getelementptr inbounds i8, ptr %1599, i64 16
  %1601 = load i64, ptr %1600, align 8
  tail call fastcc void @nested(ptr noundef %1588, ptr noundef %1592, ptr noundef %1593, i64 noundef %1594, i64 noundef %1597, ptr noundef %1598, i64 noundef %1601) #10
  %1602 = load i64, ptr %312, align 8
  %1603 = icmp sgt i64 %1602, 0
  br i1 %1603, label %1608, label %1604

1604:                                             ; preds = %1608, %1587
  %1605 = load ptr, ptr %89, align 8
  %1606 = load i64, ptr %1605, align 8
  %1607 = icmp eq i64 %1606, 1
  br i1 %1607, label %1618, label %1624

1608:                                             ; preds = %1587, %1608
  %1609 = phi i64 [ %1615, %1608 ], [ 0, %1587 ]
  %1610 = load ptr, ptr %324, align 8
  %1611 = getelementptr inbounds double, ptr %1610, i64 %1609
  %1612 = load double, ptr %1611, align 8
  %1613 = load ptr, ptr %298, align 8
  %1614 = getelementptr inbounds double, ptr %1613, i64 %1609
  store double %1612, ptr %1614, align 8
  %1615 = add nuw nsw i64 %1609, 1
  %1616 = load i64, ptr %312, align 8
  %1617 = icmp slt i64 %1615, %1616
  br i1 %1617, label %1608, label %1604, !llvm.loop !45

1618:                                             ; preds = %1604
  %1619 = load ptr, ptr %298, align 8
  %1620 = getelementptr inbounds i8, ptr %1605, i64 56
  %1621 = load i64, ptr %1620, align 8
  %1622 = inttoptr i64 %1621 to ptr
  %1623 = tail call i64 %1622(ptr noundef %0, double noundef %1520, ptr noundef %1619) #11
  br label %1624

1624:                                             ; preds = %1618, %1604, %1580
  %1625 = phi i64 [ %1623, %1618 ], [ 0, %1604 ], [ %1581, %1580 ]
  %1626 = icmp eq i64 %1625, 0
  br i1 %1626, label %1629, label %1627

1627:                                             ; preds = %1624
  store double %351, ptr %1495, align 8
  %1628 = getelementptr inbounds i8, ptr %1495, i64 8
  store double %387, ptr %1628, align 8
  br label %1685

1629:                                             ; preds = %1624
  br i1 %1513, label %1630, label %1668

1630:                                             ; preds = %1629
  %1631 = load ptr, ptr %298, align 8
  %1632 = load ptr, ptr %65, align 8
  %1633 = getelementptr inbounds i8, ptr %1632, i64 8
  %1634 = load i64, ptr %1633, align 8
  %1635 = load i64, ptr %84, align 8
  %1636 = load ptr, ptr %82, align 8
  %1637 = load ptr, ptr %72, align 8
  %1638 = getelementptr inbounds i8, ptr %1637, i64 48
  %1639 = load i64, ptr %1638, align 8
  %1640 = icmp slt i64 %1639, %1635
  br i1 %1640, label %1641, label %1664

1641:                                             ; preds = %1630
  %1642 = icmp sgt i64 %1634, 0
  br label %1643

1643:                                             ; preds = %1641, %1654
  %1644 = phi i64 [ %1639, %1641 ], [ %1655, %1654 ]
  %1645 = getelementptr inbounds double, ptr %1636, i64 %1644
  %1646 = load double, ptr %1645, align 8
  %1647 = load ptr, ptr %68, align 8
  %1648 = load double, ptr %1647, align 8
  %1649 = fcmp ugt double %1646, %1648
  br i1 %1649, label %1664, label %1650

1650:                                             ; preds = %1643
  br i1 %1642, label %1651, label %1654

1651:                                             ; preds = %1650
  %1652 = mul nsw i64 %1644, %1634
  %1653 = getelementptr double, ptr %1, i64 %1652
  br label %1657

1654:                                             ; preds = %1657, %1650
  %1655 = add i64 %1644, 1
  %1656 = icmp eq i64 %1655, %1635
  br i1 %1656, label %1664, label %1643, !llvm.loop !9

1657:                                             ; preds = %1651, %1657
  %1658 = phi i64 [ 0, %1651 ], [ %1662, %1657 ]
  %1659 = getelementptr inbounds double, ptr %1631, i64 %1658
  %1660 = load double, ptr %1659, align 8
  %1661 = getelementptr double, ptr %1653, i64 %1658
  store double %1660, ptr %1661, align 8
  %1662 = add nuw nsw i64 %1658, 1
  %1663 = icmp eq i64 %1662, %1634
  br i1 %1663, label %1654, label %1657, !llvm.loop !10

1664:                                             ; preds = %1654, %1643, %1630
  %1665 = phi i64 [ %1639, %1630 ], [ %1635, %1654 ], [ %1644, %1643 ]
  %1666 = load ptr, ptr %72, align 8
  %1667 = getelementptr inbounds i8, ptr %1666, i64 48
  store i64 %1665, ptr %1667, align 8
  br label %1668

1668:                                             ; preds = %1664, %1629
  br i1 %1583, label %1669, label %1685

1669:                                             ; preds = %1668
  %1670 = load i64, ptr %312, align 8
  %1671 = icmp sgt i64 %1670, 0
  br i1 %1671, label %1675, label %1672

1672:                                             ; preds = %1675, %1669
  store double %1520, ptr %1495, align 8
  %1673 = getelementptr inbounds i8, ptr %1495, i64 8
  store double 0.000000e+00, ptr %1673, align 8
  %1674 = load ptr, ptr %72, align 8
  store i64 0, ptr %1674, align 8
  br label %1685

1675:                                             ; preds = %1669, %1675
  %1676 = phi i64 [ %1682, %1675 ], [ 0, %1669 ]
  %1677 = load ptr, ptr %298, align 8
  %1678 = getelementptr inbounds double, ptr %1677, i64 %1676
  %1679 = load double, ptr %1678, align 8
  %1680 = load ptr, ptr %66, align 8
  %1681 = getelementptr inbounds double, ptr %1680, i64 %1676
  store double %1679, ptr %1681, align 8
  %1682 = add nuw nsw i64 %1676, 1
  %1683 = load i64, ptr %312, align 8
  %1684 = icmp slt i64 %1682, %1683
  br i1 %1684, label %1675, label %1672, !llvm.loop !46

1685:                                             ; preds = %1506, %1627, %1668, %1672
  %1686 = phi i64 [ -6, %1506 ], [ %1625, %1627 ], [ %1512, %1672 ], [ %1512, %1668 ]
  %1687 = icmp eq i64 %1686, -6
  br i1 %1687, label %1691, label %1688

1688:                                             ; preds = %1685
  %1689 = icmp ne i64 %1686, 6
  %1690 = select i1 %1689, i1 true, i1 %97
  br i1 %1690, label %1703, label %1691

1691:                                             ; preds = %1688, %1685
  %1692 = phi i64 [ %1686, %1688 ], [ 2, %1685 ]
  %1693 = load i64, ptr %230, align 8
  %1694 = add nsw i64 %1693, -1
  store i64 %1694, ptr %230, align 8
  %1695 = load ptr, ptr %229, align 8
  %1696 = load i64, ptr %1695, align 8
  %1697 = add nsw i64 %1696, -1
  store i64 %1697, ptr %1695, align 8
  %1698 = load i64, ptr %231, align 8
  %1699 = add nsw i64 %1698, 1
  store i64 %1699, ptr %231, align 8
  store i64 %1692, ptr %338, align 8
  %1700 = fmul double %387, 2.500000e-01
  store i64 1, ptr %292, align 8
  %1701 = load i64, ptr %339, align 8
  %1702 = sub nsw i64 1, %1701
  store i64 %1702, ptr %234, align 8
  store double 0.000000e+00, ptr %260, align 8
  br label %1759, !llvm.loop !17

1703:                                             ; preds = %1688
  %1704 = icmp eq i64 %1686, 0
  br i1 %1704, label %1709, label %1705

1705:                                             ; preds = %1703
  %1706 = load ptr, ptr %229, align 8
  %1707 = load i64, ptr %1706, align 8
  %1708 = add nsw i64 %1707, 1
  store i64 %1708, ptr %1706, align 8
  br label %1759

1709:                                             ; preds = %1703, %1489
  br i1 %328, label %1728, label %1710

1710:                                             ; preds = %1728, %1709
  %1711 = load i64, ptr %329, align 8
  %1712 = add nsw i64 %1711, 1
  store i64 %1712, ptr %329, align 8
  %1713 = load ptr, ptr %66, align 8
  %1714 = load ptr, ptr %330, align 8
  %1715 = load ptr, ptr %331, align 8
  store double %388, ptr %1715, align 8
  %1716 = load i64, ptr %332, align 8
  %1717 = icmp sgt i64 %1716, 0
  br i1 %1717, label %1718, label %1719

1718:                                             ; preds = %1710
  tail call fastcc void @sample(ptr noundef nonnull %65) #10
  br label %1719

1719:                                             ; preds = %1710, %1718
  %1720 = load ptr, ptr %65, align 8
  %1721 = load i64, ptr %1720, align 8
  %1722 = load ptr, ptr %331, align 8
  %1723 = load ptr, ptr %333, align 8
  %1724 = load ptr, ptr %334, align 8
  %1725 = inttoptr i64 %1721 to ptr
  %1726 = tail call i32 %1725(ptr noundef %1722, ptr noundef %1713, ptr noundef %1723, ptr noundef %1724, ptr noundef %1714) #11
  %1727 = icmp eq i32 %1726, 0
  br i1 %1727, label %1740, label %1737

1728:                                             ; preds = %1709, %1728
  %1729 = phi i64 [ %1735, %1728 ], [ 0, %1709 ]
  %1730 = load ptr, ptr %298, align 8
  %1731 = getelementptr inbounds double, ptr %1730, i64 %1729
  %1732 = load double, ptr %1731, align 8
  %1733 = load ptr, ptr %66, align 8
  %1734 = getelementptr inbounds double, ptr %1733, i64 %1729
  store double %1732, ptr %1734, align 8
  %1735 = add nuw nsw i64 %1729, 1
  %1736 = icmp eq i64 %1735, %81
  br i1 %1736, label %1710, label %1728, !llvm.loop !47

1737:                                             ; preds = %1719
  store i64 3, ptr %335, align 8
  store double %387, ptr %113, align 8
  %1738 = icmp slt i32 %1726, 0
  %1739 = select i1 %1738, i64 -4, i64 2
  br label %1759

1740:                                             ; preds = %1719
  %1741 = icmp sgt i64 %1122, 2
  %1742 = fcmp ogt double %1120, 1.000000e-03
  %1743 = select i1 %1741, i1 %1742, i1 false
  %1744 = zext i1 %1743 to i64
  store i64 %1744, ptr %234, align 8
  store i64 0, ptr %336, align 8
  store i64 0, ptr %292, align 8
  %1745 = fcmp ule double %1359, 1.000000e+00
  %1746 = fcmp uge double %1359, 1.200000e+00
  %1747 = or i1 %1745, %1746
  %1748 = select i1 %1747, i1 true, i1 %1743
  br i1 %1748, label %1749, label %1753

1749:                                             ; preds = %1740
  %1750 = fcmp ogt double %1359, 2.000000e-01
  %1751 = select i1 %1750, double %1359, double 2.000000e-01
  %1752 = fmul double %387, %1751
  br label %1753

1753:                                             ; preds = %1740, %1749
  %1754 = phi double [ %1752, %1749 ], [ %387, %1740 ]
  %1755 = load i64, ptr %337, align 8
  %1756 = load i64, ptr %84, align 8
  %1757 = icmp eq i64 %1755, %1756
  br i1 %1757, label %1758, label %1759

1758:                                             ; preds = %1753
  store double %1754, ptr %113, align 8
  br label %1759

1759:                                             ; preds = %1162, %1174, %1119, %1313, %1327, %1691, %1705, %1737, %1753, %1758, %1275, %513, %578, %394
  %1760 = phi double [ %356, %394 ], [ %356, %513 ], [ %356, %578 ], [ %1120, %1275 ], [ %1120, %1758 ], [ %1120, %1753 ], [ %1120, %1737 ], [ %1120, %1705 ], [ %1120, %1691 ], [ %1120, %1327 ], [ %1120, %1313 ], [ %1120, %1119 ], [ %1120, %1174 ], [ %1120, %1162 ]
  %1761 = phi i32 [ %355, %394 ], [ %355, %513 ], [ %355, %578 ], [ %1121, %1275 ], [ %1121, %1758 ], [ %1121, %1753 ], [ %1121, %1737 ], [ %1121, %1705 ], [ %1121, %1691 ], [ %1121, %1327 ], [ %1121, %1313 ], [ %1121, %1119 ], [ %1121, %1174 ], [ %1121, %1162 ]
  %1762 = phi i64 [ %354, %394 ], [ %354, %513 ], [ %354, %578 ], [ %1122, %1275 ], [ %1122, %1758 ], [ %1122, %1753 ], [ %1122, %1737 ], [ %1122, %1705 ], [ %1122, %1691 ], [ %1122, %1327 ], [ %1122, %1313 ], [ %1122, %1119 ], [ %1122, %1174 ], [ %1122, %1162 ]
  %1763 = phi i64 [ %353, %394 ], [ %353, %513 ], [ %353, %578 ], [ %1123, %1275 ], [ %1123, %1758 ], [ %1123, %1753 ], [ %1123, %1737 ], [ %1123, %1705 ], [ %1123, %1691 ], [ %1123, %1327 ], [ %1123, %1313 ], [ %1123, %1119 ], [ %1123, %1174 ], [ %1123, %1162 ]
  %1764 = phi double [ %352, %394 ], [ %352, %513 ], [ %581, %578 ], [ %352, %1275 ], [ %1754, %1758 ], [ %1754, %1753 ], [ %352, %1737 ], [ %352, %1705 ], [ %1700, %1691 ], [ %1330, %1327 ], [ %1315, %1313 ], [ %352, %1119 ], [ %1175, %1174 ], [ %352, %1162 ]
  %1765 = phi double [ %351, %394 ], [ %351, %513 ], [ %351, %578 ], [ %351, %1275 ], [ %388, %1758 ], [ %388, %1753 ], [ %388, %1737 ], [ %351, %1705 ], [ %351, %1691 ], [ %351, %1327 ], [ %351, %1313 ], [ %351, %1119 ], [ %351, %1174 ], [ %351, %1162 ]
  %1766 = phi i32 [ 1, %394 ], [ 1, %513 ], [ 6, %578 ], [ 1, %1275 ], [ 1, %1758 ], [ 0, %1753 ], [ 1, %1737 ], [ 1, %1705 ], [ 6, %1691 ], [ 6, %1327 ], [ 6, %1313 ], [ 1, %1119 ], [ 6, %1174 ], [ 6, %1162 ]
  %1767 = phi i64 [ 2, %394 ], [ -4, %513 ], [ %350, %578 ], [ -4, %1275 ], [ 0, %1758 ], [ %350, %1753 ], [ %1739, %1737 ], [ %1686, %1705 ], [ %350, %1691 ], [ %350, %1327 ], [ %350, %1313 ], [ -4, %1119 ], [ %350, %1174 ], [ %350, %1162 ]
  switch i32 %1766, label %1771 [
    i32 0, label %1768
    i32 6, label %1768
  ]

1768:                                             ; preds = %1759, %1759
  %1769 = load i64, ptr %75, align 8
  %1770 = icmp eq i64 %1769, 0
  br i1 %1770, label %346, label %348, !llvm.loop !17

1771:                                             ; preds = %1759, %150, %346, %369, %377, %192, %64
  %1772 = phi i64 [ -1, %64 ], [ %153, %150 ], [ -1, %346 ], [ -5, %369 ], [ 1, %377 ], [ 0, %192 ], [ %1767, %1759 ]
  ret i64 %1772
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
