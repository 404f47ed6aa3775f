; sources 52f3645339b926b950d5dea25032c8004a948a3c5de0df14d8ea2b5ed0c70b44
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
  %25 = getelementptr inbounds i8, ptr %0, i64 1080
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
  %43 = getelementptr inbounds i8, ptr %0, i64 1104
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
  %78 = getelementptr inbounds i8, ptr %0, i64 1176
  %79 = getelementptr inbounds i8, ptr %0, i64 576
  %80 = load ptr, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %0, i64 1200
  %82 = load ptr, ptr %81, align 8
  %83 = getelementptr inbounds i8, ptr %0, i64 600
  %84 = load ptr, ptr %83, align 8
  %85 = load ptr, ptr %78, align 8
  %86 = getelementptr inbounds i8, ptr %84, i64 56
  %87 = load i64, ptr %86, align 8
  %88 = icmp eq i64 %87, 0
  br i1 %88, label %1895, label %89

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
  br label %1895

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
  br i1 %207, label %1895, label %208

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
  br i1 %238, label %363, label %239

239:                                              ; preds = %235
  %240 = getelementptr inbounds i8, ptr %0, i64 1128
  %241 = getelementptr inbounds i8, ptr %84, i64 8
  %242 = getelementptr inbounds i8, ptr %84, i64 16
  %243 = getelementptr inbounds i8, ptr %84, i64 64
  %244 = getelementptr inbounds i8, ptr %80, i64 16
  %245 = getelementptr inbounds i8, ptr %85, i64 8
  %246 = getelementptr inbounds i8, ptr %0, i64 1248
  %247 = getelementptr inbounds i8, ptr %0, i64 168
  %248 = getelementptr inbounds i8, ptr %0, i64 248
  %249 = getelementptr inbounds i8, ptr %0, i64 168
  %250 = getelementptr inbounds i8, ptr %0, i64 192
  %251 = getelementptr inbounds i8, ptr %0, i64 1224
  %252 = getelementptr inbounds i8, ptr %0, i64 360
  %253 = getelementptr inbounds i8, ptr %0, i64 360
  %254 = getelementptr inbounds i8, ptr %0, i64 336
  %255 = getelementptr inbounds i8, ptr %0, i64 168
  %256 = getelementptr inbounds i8, ptr %0, i64 248
  %257 = getelementptr inbounds i8, ptr %0, i64 192
  %258 = getelementptr inbounds i8, ptr %0, i64 216
  %259 = getelementptr inbounds i8, ptr %0, i64 480
  %260 = getelementptr inbounds i8, ptr %0, i64 1256
  %261 = getelementptr inbounds i8, ptr %85, i64 16
  %262 = getelementptr inbounds i8, ptr %85, i64 24
  %263 = getelementptr inbounds i8, ptr %85, i64 24
  %264 = getelementptr inbounds i8, ptr %84, i64 40
  %265 = getelementptr inbounds i8, ptr %0, i64 1320
  %266 = getelementptr inbounds i8, ptr %0, i64 1328
  %267 = getelementptr inbounds i8, ptr %0, i64 1272
  %268 = getelementptr inbounds i8, ptr %0, i64 1296
  %269 = getelementptr inbounds i8, ptr %0, i64 1248
  %270 = getelementptr inbounds i8, ptr %0, i64 1344
  %271 = getelementptr inbounds i8, ptr %82, i64 8
  %272 = getelementptr inbounds i8, ptr %0, i64 1440
  %273 = getelementptr inbounds i8, ptr %0, i64 1368
  %274 = getelementptr inbounds i8, ptr %0, i64 1392
  %275 = fmul double %114, %122
  %276 = getelementptr inbounds i8, ptr %0, i64 1416
  %277 = getelementptr inbounds i8, ptr %0, i64 1464
  %278 = getelementptr inbounds i8, ptr %0, i64 1488
  %279 = getelementptr inbounds i8, ptr %0, i64 360
  %280 = getelementptr inbounds i8, ptr %0, i64 168
  %281 = getelementptr inbounds i8, ptr %0, i64 248
  %282 = getelementptr inbounds i8, ptr %0, i64 360
  %283 = getelementptr inbounds i8, ptr %0, i64 192
  %284 = getelementptr inbounds i8, ptr %0, i64 216
  %285 = getelementptr inbounds i8, ptr %0, i64 552
  %286 = getelementptr inbounds i8, ptr %0, i64 528
  %287 = getelementptr inbounds i8, ptr %0, i64 1320
  %288 = getelementptr inbounds i8, ptr %0, i64 1328
  %289 = getelementptr inbounds i8, ptr %0, i64 1272
  %290 = getelementptr inbounds i8, ptr %0, i64 1296
  %291 = getelementptr inbounds i8, ptr %0, i64 1344
  %292 = getelementptr inbounds i8, ptr %0, i64 552
  %293 = getelementptr inbounds i8, ptr %0, i64 528
  %294 = getelementptr inbounds i8, ptr %0, i64 1328
  %295 = getelementptr inbounds i8, ptr %0, i64 1392
  %296 = getelementptr inbounds i8, ptr %0, i64 1408
  %297 = getelementptr inbounds i8, ptr %0, i64 1464
  %298 = getelementptr inbounds i8, ptr %0, i64 1488
  %299 = fmul double %275, %275
  %300 = icmp sgt i64 %92, 0
  %301 = shl i64 %92, 4
  %302 = getelementptr inbounds i8, ptr %0, i64 336
  %303 = getelementptr inbounds i8, ptr %85, i64 32
  %304 = getelementptr inbounds i8, ptr %0, i64 1320
  %305 = getelementptr inbounds i8, ptr %0, i64 1328
  %306 = getelementptr inbounds i8, ptr %0, i64 1512
  %307 = getelementptr inbounds i8, ptr %0, i64 480
  %308 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %329 = getelementptr inbounds i8, ptr %0, i64 1152
  %330 = getelementptr inbounds i8, ptr %0, i64 1168
  %331 = getelementptr inbounds i8, ptr %0, i64 840
  %332 = getelementptr inbounds i8, ptr %0, i64 168
  %333 = getelementptr inbounds i8, ptr %0, i64 936
  %334 = getelementptr inbounds i8, ptr %0, i64 864
  %335 = getelementptr inbounds i8, ptr %0, i64 816
  %336 = getelementptr inbounds i8, ptr %0, i64 888
  %337 = getelementptr inbounds i8, ptr %84, i64 48
  %338 = getelementptr inbounds i8, ptr %0, i64 408
  %339 = getelementptr inbounds i8, ptr %0, i64 504
  %340 = getelementptr inbounds i8, ptr %0, i64 320
  %341 = getelementptr inbounds i8, ptr %0, i64 360
  %342 = getelementptr inbounds i8, ptr %0, i64 408
  %343 = getelementptr inbounds i8, ptr %0, i64 504
  %344 = getelementptr inbounds i8, ptr %0, i64 320
  %345 = icmp sgt i64 %92, 0
  %346 = getelementptr inbounds i8, ptr %84, i64 24
  %347 = getelementptr inbounds i8, ptr %0, i64 480
  %348 = getelementptr inbounds i8, ptr %0, i64 168
  %349 = getelementptr inbounds i8, ptr %0, i64 248
  %350 = getelementptr inbounds i8, ptr %0, i64 192
  %351 = getelementptr inbounds i8, ptr %0, i64 216
  %352 = getelementptr inbounds i8, ptr %84, i64 72
  %353 = getelementptr inbounds i8, ptr %85, i64 16
  %354 = getelementptr inbounds i8, ptr %84, i64 48
  %355 = getelementptr inbounds i8, ptr %85, i64 16
  %356 = getelementptr inbounds i8, ptr %84, i64 72
  %357 = getelementptr inbounds i8, ptr %84, i64 72
  %358 = getelementptr inbounds i8, ptr %85, i64 16
  %359 = getelementptr inbounds i8, ptr %0, i64 1248
  %360 = getelementptr inbounds i8, ptr %0, i64 1256
  %361 = getelementptr inbounds i8, ptr %84, i64 72
  %362 = getelementptr inbounds i8, ptr %85, i64 16
  br label %365

363:                                              ; preds = %1892, %235
  %364 = phi double [ %236, %235 ], [ %1888, %1892 ]
  store double %364, ptr %124, align 8
  br label %1895

365:                                              ; preds = %239, %1892
  %366 = phi i64 [ %237, %239 ], [ %1893, %1892 ]
  %367 = phi i64 [ undef, %239 ], [ %1891, %1892 ]
  %368 = phi double [ %123, %239 ], [ %1889, %1892 ]
  %369 = phi double [ %236, %239 ], [ %1888, %1892 ]
  %370 = phi i64 [ undef, %239 ], [ %1887, %1892 ]
  %371 = phi i64 [ undef, %239 ], [ %1886, %1892 ]
  %372 = phi i32 [ undef, %239 ], [ %1885, %1892 ]
  %373 = phi double [ undef, %239 ], [ %1884, %1892 ]
  %374 = load ptr, ptr %240, align 8
  %375 = getelementptr inbounds i8, ptr %374, i64 8
  %376 = load i64, ptr %375, align 8
  %377 = icmp sgt i64 %376, 0
  br i1 %377, label %378, label %383

378:                                              ; preds = %365
  %379 = load i64, ptr %374, align 8
  %380 = add nsw i64 %379, 3
  %381 = icmp slt i64 %376, %380
  %382 = zext i1 %381 to i32
  br label %383

383:                                              ; preds = %365, %378
  %384 = phi i32 [ 0, %365 ], [ %382, %378 ]
  %385 = icmp eq i32 %384, 0
  br i1 %385, label %387, label %386

386:                                              ; preds = %383
  store double %369, ptr %124, align 8
  br label %1895

387:                                              ; preds = %383
  %388 = add nsw i64 %366, -1
  store i64 %388, ptr %86, align 8
  %389 = load i64, ptr %241, align 8
  %390 = load i64, ptr %242, align 8
  %391 = add nsw i64 %390, %389
  %392 = load i64, ptr %243, align 8
  %393 = icmp slt i64 %391, %392
  br i1 %393, label %395, label %394

394:                                              ; preds = %387
  store double %369, ptr %124, align 8
  br label %1895

395:                                              ; preds = %387
  %396 = load double, ptr %244, align 8
  %397 = fcmp olt double %369, %396
  %398 = select i1 %397, double %369, double %396
  %399 = fadd double %368, %398
  %400 = fmul double %398, 1.000000e-03
  %401 = fsub double %99, %400
  %402 = fcmp ule double %399, %401
  %403 = fsub double %99, %368
  %404 = select i1 %402, double %398, double %403
  %405 = select i1 %402, double %399, double %99
  %406 = fmul double %404, 6.250000e-02
  %407 = fadd double %368, %406
  %408 = fcmp ule double %407, %368
  %409 = fcmp une double %405, %99
  %410 = and i1 %409, %408
  br i1 %410, label %411, label %412

411:                                              ; preds = %395
  store double %404, ptr %124, align 8
  br label %1883

412:                                              ; preds = %395
  %413 = load i64, ptr %245, align 8
  %414 = icmp eq i64 %413, 1
  br i1 %414, label %415, label %533

415:                                              ; preds = %412
  %416 = load ptr, ptr %83, align 8
  %417 = getelementptr inbounds i8, ptr %416, i64 32
  %418 = load i64, ptr %417, align 8
  %419 = add nsw i64 %418, 1
  store i64 %419, ptr %417, align 8
  %420 = load ptr, ptr %76, align 8
  %421 = getelementptr inbounds i8, ptr %420, i64 8
  %422 = load i64, ptr %421, align 8
  %423 = load ptr, ptr %78, align 8
  %424 = load i64, ptr %423, align 8
  %425 = icmp eq i64 %424, 0
  br i1 %425, label %426, label %428

426:                                              ; preds = %415
  %427 = icmp sgt i64 %422, 0
  br i1 %427, label %446, label %444

428:                                              ; preds = %415
  %429 = load ptr, ptr %247, align 8
  store double %368, ptr %429, align 8
  %430 = load i64, ptr %248, align 8
  %431 = icmp sgt i64 %430, 0
  br i1 %431, label %432, label %433

432:                                              ; preds = %428
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %433

433:                                              ; preds = %432, %428
  %434 = load ptr, ptr %78, align 8
  %435 = load i64, ptr %434, align 8
  %436 = load ptr, ptr %249, align 8
  %437 = load ptr, ptr %77, align 8
  %438 = load ptr, ptr %250, align 8
  %439 = load ptr, ptr %251, align 8
  %440 = load ptr, ptr %246, align 8
  %441 = inttoptr i64 %435 to ptr
  %442 = tail call i32 %441(ptr noundef %436, ptr noundef %437, ptr noundef %438, ptr noundef %439, ptr noundef %440) #11
  %443 = sext i32 %442 to i64
  br label %514

444:                                              ; preds = %446, %426
  %445 = icmp sgt i64 %422, 0
  br i1 %445, label %458, label %514

446:                                              ; preds = %426, %446
  %447 = phi i64 [ %453, %446 ], [ 0, %426 ]
  %448 = load ptr, ptr %77, align 8
  %449 = getelementptr inbounds double, ptr %448, i64 %447
  %450 = load double, ptr %449, align 8
  %451 = load ptr, ptr %252, align 8
  %452 = getelementptr inbounds double, ptr %451, i64 %447
  store double %450, ptr %452, align 8
  %453 = add nuw nsw i64 %447, 1
  %454 = icmp eq i64 %453, %422
  br i1 %454, label %444, label %446, !llvm.loop !11

455:                                              ; preds = %512
  %456 = add nuw nsw i64 %460, 1
  %457 = icmp eq i64 %456, %422
  br i1 %457, label %514, label %458, !llvm.loop !12

458:                                              ; preds = %444, %455
  %459 = phi i64 [ %513, %455 ], [ undef, %444 ]
  %460 = phi i64 [ %456, %455 ], [ 0, %444 ]
  %461 = load ptr, ptr %77, align 8
  %462 = getelementptr inbounds double, ptr %461, i64 %460
  %463 = load double, ptr %462, align 8
  %464 = tail call double @llvm.fabs.f64(double %463)
  %465 = fcmp olt double %464, 1.000000e-05
  %466 = select i1 %465, double 1.000000e-05, double %464
  %467 = fmul double %466, 1.500000e-08
  %468 = fadd double %463, %467
  %469 = load ptr, ptr %253, align 8
  %470 = getelementptr inbounds double, ptr %469, i64 %460
  store double %468, ptr %470, align 8
  %471 = load ptr, ptr %83, align 8
  %472 = getelementptr inbounds i8, ptr %471, i64 24
  %473 = load i64, ptr %472, align 8
  %474 = add nsw i64 %473, 1
  store i64 %474, ptr %472, align 8
  %475 = load ptr, ptr %253, align 8
  %476 = load ptr, ptr %254, align 8
  %477 = load ptr, ptr %255, align 8
  store double %368, ptr %477, align 8
  %478 = load i64, ptr %256, align 8
  %479 = icmp sgt i64 %478, 0
  br i1 %479, label %480, label %481

480:                                              ; preds = %458
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %481

481:                                              ; preds = %480, %458
  %482 = load ptr, ptr %76, align 8
  %483 = load i64, ptr %482, align 8
  %484 = load ptr, ptr %255, align 8
  %485 = load ptr, ptr %257, align 8
  %486 = load ptr, ptr %258, align 8
  %487 = inttoptr i64 %483 to ptr
  %488 = tail call i32 %487(ptr noundef %484, ptr noundef %475, ptr noundef %485, ptr noundef %486, ptr noundef %476) #11
  %489 = sext i32 %488 to i64
  %490 = icmp eq i32 %488, 0
  br i1 %490, label %491, label %512

491:                                              ; preds = %481
  %492 = fsub double %468, %463
  br label %496

493:                                              ; preds = %496
  %494 = load ptr, ptr %253, align 8
  %495 = getelementptr inbounds double, ptr %494, i64 %460
  store double %463, ptr %495, align 8
  br label %512

496:                                              ; preds = %491, %496
  %497 = phi i64 [ 0, %491 ], [ %510, %496 ]
  %498 = load ptr, ptr %254, align 8
  %499 = getelementptr inbounds double, ptr %498, i64 %497
  %500 = load double, ptr %499, align 8
  %501 = load ptr, ptr %259, align 8
  %502 = getelementptr inbounds double, ptr %501, i64 %497
  %503 = load double, ptr %502, align 8
  %504 = fsub double %500, %503
  %505 = fdiv double %504, %492
  %506 = load ptr, ptr %246, align 8
  %507 = mul nuw nsw i64 %497, %422
  %508 = getelementptr double, ptr %506, i64 %507
  %509 = getelementptr double, ptr %508, i64 %460
  store double %505, ptr %509, align 8
  %510 = add nuw nsw i64 %497, 1
  %511 = icmp eq i64 %510, %422
  br i1 %511, label %493, label %496, !llvm.loop !13

512:                                              ; preds = %493, %481
  %513 = phi i64 [ %459, %493 ], [ %489, %481 ]
  br i1 %490, label %455, label %514

514:                                              ; preds = %512, %455, %444, %433
  %515 = phi i64 [ %443, %433 ], [ 0, %444 ], [ 0, %455 ], [ %513, %512 ]
  %516 = load i64, ptr %260, align 8
  %517 = icmp sgt i64 %516, 0
  br i1 %517, label %518, label %530

518:                                              ; preds = %514, %526
  %519 = phi i64 [ %527, %526 ], [ 0, %514 ]
  %520 = load ptr, ptr %246, align 8
  %521 = getelementptr inbounds double, ptr %520, i64 %519
  %522 = load double, ptr %521, align 8
  %523 = tail call double @llvm.fabs.f64(double %522)
  %524 = fcmp ueq double %523, 0x7FF0000000000000
  br i1 %524, label %525, label %526

525:                                              ; preds = %518
  store double 0.000000e+00, ptr %521, align 8
  br label %526

526:                                              ; preds = %525, %518
  %527 = add nuw nsw i64 %519, 1
  %528 = load i64, ptr %260, align 8
  %529 = icmp slt i64 %527, %528
  br i1 %529, label %518, label %530, !llvm.loop !14

530:                                              ; preds = %526, %514
  %531 = icmp slt i64 %515, 0
  br i1 %531, label %1883, label %532

532:                                              ; preds = %530
  store i64 0, ptr %245, align 8
  store i64 1, ptr %261, align 8
  store i64 0, ptr %262, align 8
  br label %533

533:                                              ; preds = %532, %412
  %534 = load i64, ptr %263, align 8
  %535 = icmp eq i64 %534, 0
  br i1 %535, label %539, label %536

536:                                              ; preds = %533
  %537 = load double, ptr %82, align 8
  %538 = fcmp une double %404, %537
  br i1 %538, label %539, label %602

539:                                              ; preds = %536, %533
  %540 = load i64, ptr %264, align 8
  %541 = add nsw i64 %540, 1
  store i64 %541, ptr %264, align 8
  %542 = load i64, ptr %266, align 8
  %543 = load ptr, ptr %267, align 8
  %544 = load ptr, ptr %268, align 8
  %545 = icmp sgt i64 %542, 0
  br i1 %545, label %546, label %554

546:                                              ; preds = %539
  %547 = fdiv double 0x400D1A48D83E731D, %404
  %548 = add nuw i64 %542, 1
  %549 = fdiv double 0x400572DB93E0C672, %404
  %550 = fdiv double 0x40086747F2C3FCB6, %404
  br label %551

551:                                              ; preds = %546, %558
  %552 = phi i64 [ 0, %546 ], [ %569, %558 ]
  %553 = mul nuw nsw i64 %552, %542
  br label %571

554:                                              ; preds = %558, %539
  %555 = load ptr, ptr %265, align 8
  %556 = tail call fastcc i32 @real_factorise(ptr noundef %543, i64 noundef %542, ptr noundef %555) #10
  %557 = icmp eq i32 %556, 0
  br i1 %557, label %592, label %587

558:                                              ; preds = %571
  %559 = mul i64 %552, %548
  %560 = getelementptr inbounds double, ptr %543, i64 %559
  %561 = load double, ptr %560, align 8
  %562 = fadd double %547, %561
  store double %562, ptr %560, align 8
  %563 = getelementptr inbounds { double, double }, ptr %544, i64 %559
  %564 = load double, ptr %563, align 8
  %565 = getelementptr inbounds i8, ptr %563, i64 8
  %566 = load double, ptr %565, align 8
  %567 = fadd double %549, %564
  %568 = fsub double %566, %550
  store double %567, ptr %563, align 8
  store double %568, ptr %565, align 8
  %569 = add nuw nsw i64 %552, 1
  %570 = icmp eq i64 %569, %542
  br i1 %570, label %554, label %551, !llvm.loop !15

571:                                              ; preds = %551, %571
  %572 = phi i64 [ 0, %551 ], [ %585, %571 ]
  %573 = load ptr, ptr %269, align 8
  %574 = add nuw nsw i64 %572, %553
  %575 = getelementptr inbounds double, ptr %573, i64 %574
  %576 = load double, ptr %575, align 8
  %577 = fneg double %576
  %578 = getelementptr inbounds double, ptr %543, i64 %574
  store double %577, ptr %578, align 8
  %579 = load ptr, ptr %269, align 8
  %580 = getelementptr inbounds double, ptr %579, i64 %574
  %581 = load double, ptr %580, align 8
  %582 = fneg double %581
  %583 = getelementptr inbounds { double, double }, ptr %544, i64 %574
  %584 = getelementptr inbounds i8, ptr %583, i64 8
  store double %582, ptr %583, align 8
  store double 0.000000e+00, ptr %584, align 8
  %585 = add nuw nsw i64 %572, 1
  %586 = icmp eq i64 %585, %542
  br i1 %586, label %558, label %571, !llvm.loop !16

587:                                              ; preds = %554
  %588 = load ptr, ptr %270, align 8
  %589 = tail call fastcc i32 @pair_factorise(ptr noundef %544, i64 noundef %542, ptr noundef %588) #10
  %590 = icmp ne i32 %589, 0
  %591 = zext i1 %590 to i32
  br label %592

592:                                              ; preds = %554, %587
  %593 = phi i32 [ 0, %554 ], [ %591, %587 ]
  %594 = icmp eq i32 %593, 0
  br i1 %594, label %595, label %601

595:                                              ; preds = %592
  store i64 4, ptr %361, align 8
  %596 = load i64, ptr %242, align 8
  %597 = add nsw i64 %596, 1
  store i64 %597, ptr %242, align 8
  %598 = fmul double %404, 5.000000e-01
  %599 = load i64, ptr %362, align 8
  %600 = sub nsw i64 1, %599
  store i64 %600, ptr %245, align 8
  store i64 0, ptr %263, align 8
  br label %1883, !llvm.loop !17

601:                                              ; preds = %592
  store i64 1, ptr %263, align 8
  store double %404, ptr %82, align 8
  br label %602

602:                                              ; preds = %601, %536
  %603 = load double, ptr %271, align 8
  %604 = load ptr, ptr %76, align 8
  %605 = getelementptr inbounds i8, ptr %604, i64 8
  %606 = load i64, ptr %605, align 8
  %607 = load ptr, ptr %272, align 8
  %608 = load ptr, ptr %77, align 8
  %609 = load ptr, ptr %273, align 8
  %610 = load ptr, ptr %274, align 8
  %611 = fcmp ogt double %603, 0.000000e+00
  %612 = icmp sgt i64 %606, 0
  %613 = shl i64 %606, 4
  %614 = getelementptr i8, ptr %607, i64 %613
  %615 = mul i64 %606, 24
  %616 = getelementptr i8, ptr %607, i64 %615
  %617 = getelementptr double, ptr %607, i64 %606
  br label %623

618:                                              ; preds = %637
  %619 = icmp sgt i64 %606, 0
  %620 = getelementptr double, ptr %609, i64 %606
  %621 = shl i64 %606, 4
  %622 = getelementptr i8, ptr %609, i64 %621
  br label %664

623:                                              ; preds = %602, %637
  %624 = phi i64 [ 0, %602 ], [ %638, %637 ]
  br i1 %611, label %625, label %631

625:                                              ; preds = %623
  %626 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %624
  %627 = load double, ptr %626, align 8
  %628 = fmul double %404, %627
  %629 = fdiv double %628, %603
  %630 = fadd double %629, 1.000000e+00
  br label %631

631:                                              ; preds = %625, %623
  %632 = phi double [ %630, %625 ], [ 0.000000e+00, %623 ]
  br i1 %612, label %633, label %637

633:                                              ; preds = %631
  %634 = mul nuw nsw i64 %606, %624
  %635 = getelementptr double, ptr %609, i64 %634
  %636 = fsub double 1.000000e+00, %632
  br label %640

637:                                              ; preds = %661, %631
  %638 = add nuw nsw i64 %624, 1
  %639 = icmp eq i64 %638, 3
  br i1 %639, label %618, label %623, !llvm.loop !18

640:                                              ; preds = %633, %661
  %641 = phi i64 [ 0, %633 ], [ %662, %661 ]
  %642 = getelementptr double, ptr %635, i64 %641
  store double 0.000000e+00, ptr %642, align 8
  br i1 %611, label %643, label %661

643:                                              ; preds = %640
  %644 = getelementptr double, ptr %614, i64 %641
  %645 = load double, ptr %644, align 8
  %646 = getelementptr double, ptr %616, i64 %641
  %647 = load double, ptr %646, align 8
  %648 = fmul double %632, %647
  %649 = fadd double %645, %648
  %650 = fmul double %636, %649
  %651 = getelementptr inbounds double, ptr %607, i64 %641
  %652 = load double, ptr %651, align 8
  %653 = getelementptr double, ptr %617, i64 %641
  %654 = load double, ptr %653, align 8
  %655 = fadd double %654, %650
  %656 = fmul double %632, %655
  %657 = fadd double %652, %656
  %658 = getelementptr inbounds double, ptr %608, i64 %641
  %659 = load double, ptr %658, align 8
  %660 = fsub double %657, %659
  store double %660, ptr %642, align 8
  br label %661

661:                                              ; preds = %643, %640
  %662 = add nuw nsw i64 %641, 1
  %663 = icmp eq i64 %662, %606
  br i1 %663, label %637, label %640, !llvm.loop !19

664:                                              ; preds = %618, %675
  %665 = phi i64 [ 0, %618 ], [ %676, %675 ]
  br i1 %619, label %666, label %675

666:                                              ; preds = %664
  %667 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %665
  %668 = load double, ptr %667, align 8
  %669 = getelementptr inbounds i8, ptr %667, i64 8
  %670 = load double, ptr %669, align 8
  %671 = getelementptr inbounds i8, ptr %667, i64 16
  %672 = load double, ptr %671, align 8
  %673 = mul nuw nsw i64 %606, %665
  %674 = getelementptr double, ptr %610, i64 %673
  br label %678

675:                                              ; preds = %678, %664
  %676 = add nuw nsw i64 %665, 1
  %677 = icmp eq i64 %676, 3
  br i1 %677, label %694, label %664, !llvm.loop !20

678:                                              ; preds = %666, %678
  %679 = phi i64 [ 0, %666 ], [ %692, %678 ]
  %680 = getelementptr inbounds double, ptr %609, i64 %679
  %681 = load double, ptr %680, align 8
  %682 = fmul double %668, %681
  %683 = getelementptr double, ptr %620, i64 %679
  %684 = load double, ptr %683, align 8
  %685 = fmul double %670, %684
  %686 = fadd double %682, %685
  %687 = getelementptr double, ptr %622, i64 %679
  %688 = load double, ptr %687, align 8
  %689 = fmul double %672, %688
  %690 = fadd double %686, %689
  %691 = getelementptr double, ptr %674, i64 %679
  store double %690, ptr %691, align 8
  %692 = add nuw nsw i64 %679, 1
  %693 = icmp eq i64 %692, %606
  br i1 %693, label %675, label %678, !llvm.loop !21

694:                                              ; preds = %675
  %695 = load ptr, ptr %76, align 8, !noalias !22
  %696 = getelementptr inbounds i8, ptr %695, i64 8
  %697 = load i64, ptr %696, align 8, !noalias !22
  %698 = load ptr, ptr %78, align 8, !noalias !22
  %699 = getelementptr inbounds i8, ptr %698, i64 40
  %700 = load i64, ptr %699, align 8, !noalias !22
  %701 = load ptr, ptr %273, align 8, !noalias !22
  %702 = load ptr, ptr %274, align 8, !noalias !22
  %703 = load ptr, ptr %276, align 8, !noalias !22
  %704 = load ptr, ptr %277, align 8, !noalias !22
  %705 = load ptr, ptr %278, align 8, !noalias !22
  %706 = icmp sgt i64 %700, 0
  %707 = select i1 %706, i64 10, i64 6
  %708 = icmp sgt i64 %697, 0
  %709 = fdiv double 0x400D1A48D83E731D, %404
  %710 = fdiv double 0x400572DB93E0C672, %404
  %711 = fdiv double 0xC0086747F2C3FCB6, %404
  %712 = icmp sgt i64 %697, 0
  %713 = getelementptr double, ptr %702, i64 %697
  %714 = shl i64 %697, 4
  %715 = getelementptr i8, ptr %702, i64 %714
  %716 = icmp eq i64 %700, 0
  br label %717

717:                                              ; preds = %694, %1120
  %718 = phi double [ -1.000000e+00, %694 ], [ %1119, %1120 ]
  %719 = phi double [ 0.000000e+00, %694 ], [ %1118, %1120 ]
  %720 = phi i64 [ 0, %694 ], [ %1117, %1120 ]
  %721 = phi i64 [ 0, %694 ], [ %1121, %1120 ]
  %722 = phi i64 [ %370, %694 ], [ %1114, %1120 ]
  %723 = phi i64 [ %371, %694 ], [ %1113, %1120 ]
  %724 = phi i32 [ %372, %694 ], [ %1112, %1120 ]
  %725 = phi double [ %373, %694 ], [ %1111, %1120 ]
  %726 = icmp ugt i64 %721, 5
  %727 = icmp eq i64 %720, 0
  %728 = select i1 %726, i1 %727, i1 false
  br i1 %728, label %1123, label %733

729:                                              ; preds = %755
  %730 = add nuw nsw i64 %734, 1
  %731 = icmp ugt i64 %734, 1
  %732 = icmp eq i64 %730, 3
  br i1 %732, label %778, label %733, !llvm.loop !25

733:                                              ; preds = %717, %729
  %734 = phi i64 [ %730, %729 ], [ 0, %717 ]
  %735 = phi i1 [ %731, %729 ], [ false, %717 ]
  br i1 %708, label %736, label %739

736:                                              ; preds = %733
  %737 = mul nuw nsw i64 %697, %734
  %738 = getelementptr double, ptr %701, i64 %737
  br label %764

739:                                              ; preds = %764, %733
  %740 = load ptr, ptr %83, align 8, !noalias !22
  %741 = getelementptr inbounds i8, ptr %740, i64 24
  %742 = load i64, ptr %741, align 8, !noalias !22
  %743 = add nsw i64 %742, 1
  store i64 %743, ptr %741, align 8, !noalias !22
  %744 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %734
  %745 = load double, ptr %744, align 8, !noalias !22
  %746 = fmul double %404, %745
  %747 = fadd double %368, %746
  %748 = load ptr, ptr %279, align 8, !noalias !22
  %749 = mul nsw i64 %697, %734
  %750 = getelementptr inbounds double, ptr %703, i64 %749
  %751 = load ptr, ptr %280, align 8, !noalias !22
  store double %747, ptr %751, align 8, !noalias !22
  %752 = load i64, ptr %281, align 8, !noalias !22
  %753 = icmp sgt i64 %752, 0
  br i1 %753, label %754, label %755

754:                                              ; preds = %739
  tail call fastcc void @sample(ptr noundef nonnull %76) #10, !noalias !22
  br label %755

755:                                              ; preds = %739, %754
  %756 = load ptr, ptr %76, align 8, !noalias !22
  %757 = load i64, ptr %756, align 8, !noalias !22
  %758 = load ptr, ptr %280, align 8, !noalias !22
  %759 = load ptr, ptr %283, align 8, !noalias !22
  %760 = load ptr, ptr %284, align 8, !noalias !22
  %761 = inttoptr i64 %757 to ptr
  %762 = tail call i32 %761(ptr noundef %758, ptr noundef %748, ptr noundef %759, ptr noundef %760, ptr noundef %750) #11, !noalias !22
  %763 = icmp eq i32 %762, 0
  br i1 %763, label %729, label %776

764:                                              ; preds = %736, %764
  %765 = phi i64 [ 0, %736 ], [ %774, %764 ]
  %766 = load ptr, ptr %77, align 8, !noalias !22
  %767 = getelementptr inbounds double, ptr %766, i64 %765
  %768 = load double, ptr %767, align 8, !noalias !22
  %769 = getelementptr double, ptr %738, i64 %765
  %770 = load double, ptr %769, align 8, !noalias !22
  %771 = fadd double %768, %770
  %772 = load ptr, ptr %282, align 8, !noalias !22
  %773 = getelementptr inbounds double, ptr %772, i64 %765
  store double %771, ptr %773, align 8, !noalias !22
  %774 = add nuw nsw i64 %765, 1
  %775 = icmp eq i64 %774, %697
  br i1 %775, label %739, label %764, !llvm.loop !26

776:                                              ; preds = %755
  %777 = sext i32 %762 to i64
  br label %778

778:                                              ; preds = %729, %776
  %779 = phi i1 [ %735, %776 ], [ %731, %729 ]
  %780 = phi double [ 0.000000e+00, %776 ], [ %725, %729 ]
  %781 = phi i32 [ 0, %776 ], [ %724, %729 ]
  %782 = phi i64 [ %721, %776 ], [ %723, %729 ]
  %783 = phi i64 [ %777, %776 ], [ %722, %729 ]
  %784 = phi i32 [ 1, %776 ], [ 5, %729 ]
  br i1 %779, label %785, label %1123

785:                                              ; preds = %778
  %786 = load ptr, ptr %76, align 8, !noalias !22
  %787 = getelementptr inbounds i8, ptr %786, i64 8
  %788 = load i64, ptr %787, align 8, !noalias !22
  %789 = load ptr, ptr %276, align 8, !noalias !22
  %790 = load ptr, ptr %274, align 8, !noalias !22
  %791 = load ptr, ptr %277, align 8, !noalias !22
  %792 = load ptr, ptr %278, align 8, !noalias !22
  %793 = icmp sgt i64 %788, 0
  br i1 %793, label %794, label %899

794:                                              ; preds = %785
  %795 = shl nuw nsw i64 %788, 1
  %796 = getelementptr double, ptr %789, i64 %788
  %797 = shl i64 %788, 4
  %798 = getelementptr i8, ptr %789, i64 %797
  %799 = load double, ptr %789, align 8, !noalias !22
  %800 = getelementptr inbounds double, ptr %789, i64 %788
  %801 = load double, ptr %800, align 8, !noalias !22
  %802 = fadd double %799, %801
  %803 = getelementptr inbounds double, ptr %789, i64 %795
  %804 = load double, ptr %803, align 8, !noalias !22
  %805 = fadd double %802, %804
  %806 = tail call double @llvm.fabs.f64(double %805)
  %807 = fcmp ueq double %806, 0x7FF0000000000000
  br i1 %807, label %896, label %808

808:                                              ; preds = %794
  %809 = getelementptr double, ptr %790, i64 %788
  %810 = getelementptr inbounds double, ptr %790, i64 %795
  %811 = getelementptr double, ptr %789, i64 %788
  %812 = getelementptr inbounds double, ptr %789, i64 %795
  br label %824

813:                                              ; preds = %824
  %814 = getelementptr inbounds double, ptr %789, i64 %892
  %815 = load double, ptr %814, align 8, !noalias !22
  %816 = getelementptr double, ptr %811, i64 %892
  %817 = load double, ptr %816, align 8, !noalias !22
  %818 = fadd double %815, %817
  %819 = getelementptr inbounds double, ptr %812, i64 %892
  %820 = load double, ptr %819, align 8, !noalias !22
  %821 = fadd double %818, %820
  %822 = tail call double @llvm.fabs.f64(double %821)
  %823 = fcmp ueq double %822, 0x7FF0000000000000
  br i1 %823, label %894, label %824, !llvm.loop !27

824:                                              ; preds = %808, %813
  %825 = phi double [ %815, %813 ], [ %799, %808 ]
  %826 = phi double [ %891, %813 ], [ 0.000000e+00, %808 ]
  %827 = phi i64 [ %892, %813 ], [ 0, %808 ]
  %828 = getelementptr inbounds double, ptr %789, i64 %827
  %829 = fmul double %825, 0x4010B70201A79C46
  %830 = getelementptr double, ptr %796, i64 %827
  %831 = load double, ptr %830, align 8, !noalias !22
  %832 = fmul double %831, 0x3FD4F8C15DA84E86
  %833 = fadd double %829, %832
  %834 = getelementptr double, ptr %798, i64 %827
  %835 = load double, ptr %834, align 8, !noalias !22
  %836 = fmul double %835, 0x3FE0BF7FF59D56EF
  %837 = fadd double %833, %836
  %838 = getelementptr inbounds double, ptr %790, i64 %827
  %839 = load double, ptr %838, align 8, !noalias !22
  %840 = fmul double %709, %839
  %841 = fsub double %837, %840
  %842 = getelementptr inbounds double, ptr %791, i64 %827
  store double %841, ptr %842, align 8, !noalias !22
  %843 = load double, ptr %828, align 8, !noalias !22
  %844 = fmul double %843, 0xC010B70201A79C46
  %845 = load double, ptr %830, align 8, !noalias !22
  %846 = fmul double %845, 0x3FD4F8C15DA84E86
  %847 = fsub double %844, %846
  %848 = load double, ptr %834, align 8, !noalias !22
  %849 = fmul double %848, 0x3FDE810014C55221
  %850 = fadd double %847, %849
  %851 = fmul double %843, 0x3FE017885A24A7F2
  %852 = fmul double %845, 0x4004934E6FCAA598
  %853 = fsub double %851, %852
  %854 = fmul double %848, 0x3FE312C0CF7BDFD1
  %855 = fadd double %853, %854
  %856 = getelementptr double, ptr %809, i64 %827
  %857 = load double, ptr %856, align 8, !noalias !22
  %858 = getelementptr inbounds double, ptr %810, i64 %827
  %859 = load double, ptr %858, align 8, !noalias !22
  %860 = fmul double %710, %857
  %861 = fmul double %711, %859
  %862 = fmul double %710, %859
  %863 = fmul double %711, %857
  %864 = fsub double %860, %861
  %865 = fadd double %863, %862
  %866 = fsub double %850, %864
  %867 = fsub double %855, %865
  %868 = getelementptr inbounds { double, double }, ptr %792, i64 %827
  %869 = getelementptr inbounds i8, ptr %868, i64 8
  store double %866, ptr %868, align 8, !noalias !22
  store double %867, ptr %869, align 8, !noalias !22
  %870 = load double, ptr %842, align 8, !noalias !22
  %871 = tail call double @llvm.fabs.f64(double %870)
  %872 = tail call double @llvm.fabs.f64(double %866)
  %873 = fadd double %871, %872
  %874 = tail call double @llvm.fabs.f64(double %867)
  %875 = fadd double %874, %873
  %876 = fmul double %404, %875
  %877 = load ptr, ptr %77, align 8, !noalias !22
  %878 = getelementptr inbounds double, ptr %877, i64 %827
  %879 = load double, ptr %878, align 8, !noalias !22
  %880 = load ptr, ptr %285, align 8, !noalias !22
  %881 = getelementptr inbounds double, ptr %880, i64 %827
  %882 = load double, ptr %881, align 8, !noalias !22
  %883 = load ptr, ptr %286, align 8, !noalias !22
  %884 = getelementptr inbounds double, ptr %883, i64 %827
  %885 = load double, ptr %884, align 8, !noalias !22
  %886 = tail call double @llvm.fabs.f64(double %879)
  %887 = fmul double %886, %885
  %888 = fadd double %882, %887
  %889 = fdiv double %876, %888
  %890 = fmul double %889, %889
  %891 = fadd double %826, %890
  %892 = add nuw nsw i64 %827, 1
  %893 = icmp eq i64 %892, %788
  br i1 %893, label %899, label %813, !llvm.loop !27

894:                                              ; preds = %813
  %895 = icmp slt i64 %892, %788
  br label %896

896:                                              ; preds = %894, %794
  %897 = phi i1 [ %895, %894 ], [ %793, %794 ]
  %898 = phi double [ %891, %894 ], [ 0.000000e+00, %794 ]
  br i1 %897, label %1123, label %899

899:                                              ; preds = %824, %785, %896
  %900 = phi double [ %898, %896 ], [ 0.000000e+00, %785 ], [ %891, %824 ]
  %901 = load ptr, ptr %76, align 8, !noalias !22
  %902 = getelementptr inbounds i8, ptr %901, i64 8
  %903 = load i64, ptr %902, align 8, !noalias !22
  %904 = load i64, ptr %288, align 8, !noalias !22
  %905 = load ptr, ptr %78, align 8, !noalias !22
  %906 = getelementptr inbounds i8, ptr %905, i64 40
  %907 = load i64, ptr %906, align 8, !noalias !22
  %908 = load ptr, ptr %277, align 8, !noalias !22
  %909 = load ptr, ptr %278, align 8, !noalias !22
  %910 = load ptr, ptr %289, align 8, !noalias !22
  %911 = load ptr, ptr %287, align 8, !noalias !22
  tail call fastcc void @real_solve(ptr noundef %910, i64 noundef %904, ptr noundef %911, ptr noundef %908) #10, !noalias !22
  %912 = load ptr, ptr %290, align 8, !noalias !22
  %913 = load ptr, ptr %291, align 8, !noalias !22
  tail call fastcc void @pair_solve(ptr noundef %912, i64 noundef %904, ptr noundef %913, ptr noundef %909) #10, !noalias !22
  %914 = icmp sgt i64 %907, 0
  br i1 %914, label %915, label %920

915:                                              ; preds = %899
  %916 = load ptr, ptr %289, align 8, !noalias !22
  %917 = load ptr, ptr %287, align 8, !noalias !22
  tail call fastcc void @real_solve_columns(ptr noundef %916, i64 noundef %904, ptr noundef %917, ptr noundef %908, i64 noundef %907) #10, !noalias !22
  %918 = load ptr, ptr %290, align 8, !noalias !22
  %919 = load ptr, ptr %291, align 8, !noalias !22
  tail call fastcc void @pair_solve_columns(ptr noundef %918, i64 noundef %904, ptr noundef %919, ptr noundef %909, i64 noundef %907) #10, !noalias !22
  br label %920

920:                                              ; preds = %915, %899
  %921 = icmp sgt i64 %903, 0
  br i1 %921, label %922, label %955

922:                                              ; preds = %920
  %923 = load ptr, ptr %77, align 8, !noalias !22
  %924 = load ptr, ptr %292, align 8, !noalias !22
  %925 = load ptr, ptr %293, align 8, !noalias !22
  br label %926

926:                                              ; preds = %922, %926
  %927 = phi double [ 0.000000e+00, %922 ], [ %952, %926 ]
  %928 = phi i64 [ 0, %922 ], [ %953, %926 ]
  %929 = getelementptr inbounds double, ptr %923, i64 %928
  %930 = load double, ptr %929, align 8, !noalias !22
  %931 = getelementptr inbounds double, ptr %924, i64 %928
  %932 = load double, ptr %931, align 8, !noalias !22
  %933 = getelementptr inbounds double, ptr %925, i64 %928
  %934 = load double, ptr %933, align 8, !noalias !22
  %935 = tail call double @llvm.fabs.f64(double %930)
  %936 = fmul double %935, %934
  %937 = fadd double %932, %936
  %938 = getelementptr inbounds double, ptr %908, i64 %928
  %939 = load double, ptr %938, align 8, !noalias !22
  %940 = fdiv double %939, %937
  %941 = getelementptr inbounds { double, double }, ptr %909, i64 %928
  %942 = load double, ptr %941, align 8, !noalias !22
  %943 = getelementptr inbounds i8, ptr %941, i64 8
  %944 = fdiv double %942, %937
  %945 = load double, ptr %943, align 8, !noalias !22
  %946 = fdiv double %945, %937
  %947 = fmul double %940, %940
  %948 = fmul double %944, %944
  %949 = fadd double %947, %948
  %950 = fmul double %946, %946
  %951 = fadd double %949, %950
  %952 = fadd double %927, %951
  %953 = add nuw nsw i64 %928, 1
  %954 = icmp eq i64 %953, %903
  br i1 %954, label %955, label %926, !llvm.loop !28

955:                                              ; preds = %926, %920
  %956 = phi double [ 0.000000e+00, %920 ], [ %952, %926 ]
  %957 = mul nsw i64 %903, 3
  %958 = sitofp i64 %957 to double
  %959 = fdiv double %956, %958
  %960 = tail call double @llvm.sqrt.f64(double %959)
  %961 = fcmp oeq double %960, 0.000000e+00
  %962 = fcmp ogt double %900, 0.000000e+00
  %963 = select i1 %961, i1 %962, i1 false
  br i1 %963, label %964, label %966

964:                                              ; preds = %955
  %965 = add nuw nsw i64 %721, 1
  br label %1110

966:                                              ; preds = %955
  %967 = fcmp ogt double %718, 0.000000e+00
  %968 = select i1 %967, i1 %727, i1 false
  br i1 %968, label %969, label %982

969:                                              ; preds = %966
  %970 = fdiv double %960, %718
  %971 = fcmp ult double %970, 1.000000e+00
  br i1 %971, label %972, label %980

972:                                              ; preds = %969
  %973 = sub nsw i64 5, %721
  %974 = sitofp i64 %973 to double
  %975 = tail call double @llvm.pow.f64(double %970, double %974)
  %976 = fsub double 1.000000e+00, %970
  %977 = fdiv double %975, %976
  %978 = fmul double %960, %977
  %979 = fcmp ogt double %978, %122
  br i1 %979, label %980, label %982

980:                                              ; preds = %972, %969
  %981 = add nuw nsw i64 %721, 1
  br label %1110

982:                                              ; preds = %972, %966
  %983 = phi double [ %719, %966 ], [ %970, %972 ]
  br i1 %712, label %995, label %984

984:                                              ; preds = %1013, %982
  %985 = fsub double 1.000000e+00, %983
  %986 = fdiv double %983, %985
  %987 = fmul double %960, %986
  %988 = fcmp olt double %987, %122
  %989 = select i1 %967, i1 %988, i1 false
  %990 = select i1 %961, i1 true, i1 %989
  %991 = add nuw nsw i64 %721, 1
  %992 = select i1 %990, i64 %991, i64 0
  %993 = select i1 %727, i64 %992, i64 %720
  %994 = icmp sgt i64 %993, 0
  br i1 %994, label %1036, label %1109

995:                                              ; preds = %982, %1013
  %996 = phi i64 [ %1014, %1013 ], [ 0, %982 ]
  %997 = getelementptr inbounds double, ptr %704, i64 %996
  %998 = load double, ptr %997, align 8, !noalias !22
  %999 = getelementptr inbounds double, ptr %702, i64 %996
  %1000 = load double, ptr %999, align 8, !noalias !22
  %1001 = fadd double %998, %1000
  store double %1001, ptr %999, align 8, !noalias !22
  %1002 = getelementptr inbounds { double, double }, ptr %705, i64 %996
  %1003 = load double, ptr %1002, align 8, !noalias !22
  %1004 = getelementptr inbounds i8, ptr %1002, i64 8
  %1005 = getelementptr double, ptr %713, i64 %996
  %1006 = load double, ptr %1005, align 8, !noalias !22
  %1007 = fadd double %1003, %1006
  store double %1007, ptr %1005, align 8, !noalias !22
  %1008 = load double, ptr %1004, align 8, !noalias !22
  %1009 = getelementptr double, ptr %715, i64 %996
  %1010 = load double, ptr %1009, align 8, !noalias !22
  %1011 = fadd double %1008, %1010
  store double %1011, ptr %1009, align 8, !noalias !22
  %1012 = getelementptr double, ptr %701, i64 %996
  br label %1016

1013:                                             ; preds = %1016
  %1014 = add nuw nsw i64 %996, 1
  %1015 = icmp eq i64 %1014, %697
  br i1 %1015, label %984, label %995, !llvm.loop !29

1016:                                             ; preds = %995, %1016
  %1017 = phi i64 [ 0, %995 ], [ %1034, %1016 ]
  %1018 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %1017
  %1019 = load double, ptr %1018, align 8, !noalias !22
  %1020 = load double, ptr %999, align 8, !noalias !22
  %1021 = fmul double %1019, %1020
  %1022 = getelementptr inbounds i8, ptr %1018, i64 8
  %1023 = load double, ptr %1022, align 8, !noalias !22
  %1024 = load double, ptr %1005, align 8, !noalias !22
  %1025 = fmul double %1023, %1024
  %1026 = fadd double %1021, %1025
  %1027 = getelementptr inbounds i8, ptr %1018, i64 16
  %1028 = load double, ptr %1027, align 8, !noalias !22
  %1029 = load double, ptr %1009, align 8, !noalias !22
  %1030 = fmul double %1028, %1029
  %1031 = fadd double %1026, %1030
  %1032 = mul nuw nsw i64 %697, %1017
  %1033 = getelementptr double, ptr %1012, i64 %1032
  store double %1031, ptr %1033, align 8, !noalias !22
  %1034 = add nuw nsw i64 %1017, 1
  %1035 = icmp eq i64 %1034, 3
  br i1 %1035, label %1013, label %1016, !llvm.loop !30

1036:                                             ; preds = %984
  br i1 %716, label %1110, label %1037

1037:                                             ; preds = %1036
  %1038 = load i64, ptr %294, align 8, !noalias !22
  %1039 = load ptr, ptr %78, align 8, !noalias !22
  %1040 = getelementptr inbounds i8, ptr %1039, i64 40
  %1041 = load i64, ptr %1040, align 8, !noalias !22
  %1042 = load ptr, ptr %297, align 8, !noalias !22
  %1043 = load ptr, ptr %295, align 8, !noalias !22
  %1044 = load ptr, ptr %298, align 8, !noalias !22
  %1045 = icmp sgt i64 %1041, 0
  br i1 %1045, label %1046, label %1106

1046:                                             ; preds = %1037
  %1047 = load i64, ptr %296, align 8, !noalias !22
  %1048 = icmp sgt i64 %1038, 0
  %1049 = getelementptr double, ptr %1043, i64 %1047
  %1050 = shl i64 %1047, 4
  %1051 = getelementptr i8, ptr %1043, i64 %1050
  br label %1052

1052:                                             ; preds = %1046, %1102
  %1053 = phi double [ 0.000000e+00, %1046 ], [ %1103, %1102 ]
  %1054 = phi i64 [ 0, %1046 ], [ %1104, %1102 ]
  br i1 %1048, label %1055, label %1058

1055:                                             ; preds = %1052
  %1056 = add nuw i64 %1054, %1038
  %1057 = load ptr, ptr %77, align 8, !noalias !22
  br label %1063

1058:                                             ; preds = %1063, %1052
  %1059 = phi double [ 0.000000e+00, %1052 ], [ %1095, %1063 ]
  %1060 = phi double [ 0.000000e+00, %1052 ], [ %1079, %1063 ]
  %1061 = fmul double %1053, %1059
  %1062 = fcmp ogt double %1060, %1061
  br i1 %1062, label %1098, label %1102

1063:                                             ; preds = %1055, %1063
  %1064 = phi double [ 0.000000e+00, %1055 ], [ %1079, %1063 ]
  %1065 = phi double [ 0.000000e+00, %1055 ], [ %1095, %1063 ]
  %1066 = phi i64 [ 0, %1055 ], [ %1096, %1063 ]
  %1067 = mul nuw nsw i64 %1066, %1041
  %1068 = add i64 %1056, %1067
  %1069 = getelementptr inbounds double, ptr %1042, i64 %1068
  %1070 = load double, ptr %1069, align 8, !noalias !22
  %1071 = fmul double %1070, %1070
  %1072 = getelementptr inbounds { double, double }, ptr %1044, i64 %1068
  %1073 = load double, ptr %1072, align 8, !noalias !22
  %1074 = getelementptr inbounds i8, ptr %1072, i64 8
  %1075 = load double, ptr %1074, align 8, !noalias !22
  %1076 = tail call double @hypot(double noundef %1073, double noundef %1075) #13
  %1077 = fmul double %1076, %1076
  %1078 = fadd double %1071, %1077
  %1079 = fadd double %1064, %1078
  %1080 = getelementptr inbounds double, ptr %1057, i64 %1068
  %1081 = load double, ptr %1080, align 8, !noalias !22
  %1082 = fmul double %1081, %1081
  %1083 = fadd double %1065, %1082
  %1084 = getelementptr inbounds double, ptr %1043, i64 %1068
  %1085 = load double, ptr %1084, align 8, !noalias !22
  %1086 = fmul double %1085, %1085
  %1087 = getelementptr double, ptr %1049, i64 %1068
  %1088 = load double, ptr %1087, align 8, !noalias !22
  %1089 = fmul double %1088, %1088
  %1090 = fadd double %1086, %1089
  %1091 = getelementptr double, ptr %1051, i64 %1068
  %1092 = load double, ptr %1091, align 8, !noalias !22
  %1093 = fmul double %1092, %1092
  %1094 = fadd double %1090, %1093
  %1095 = fadd double %1083, %1094
  %1096 = add nuw nsw i64 %1066, 1
  %1097 = icmp eq i64 %1096, %1038
  br i1 %1097, label %1058, label %1063, !llvm.loop !31

1098:                                             ; preds = %1058
  %1099 = fcmp ogt double %1059, 0.000000e+00
  %1100 = fdiv double %1060, %1059
  %1101 = select i1 %1099, double %1100, double 1.000000e+00
  br label %1102

1102:                                             ; preds = %1098, %1058
  %1103 = phi double [ %1101, %1098 ], [ %1053, %1058 ]
  %1104 = add nuw nsw i64 %1054, 1
  %1105 = icmp eq i64 %1104, %1041
  br i1 %1105, label %1106, label %1052, !llvm.loop !32

1106:                                             ; preds = %1102, %1037
  %1107 = phi double [ 0.000000e+00, %1037 ], [ %1103, %1102 ]
  %1108 = fcmp ugt double %1107, %299
  br i1 %1108, label %1109, label %1110

1109:                                             ; preds = %1106, %984
  br label %1110

1110:                                             ; preds = %1109, %1106, %1036, %980, %964
  %1111 = phi double [ %719, %964 ], [ %970, %980 ], [ %780, %1036 ], [ %780, %1109 ], [ %780, %1106 ]
  %1112 = phi i32 [ 0, %964 ], [ 0, %980 ], [ %781, %1036 ], [ %781, %1109 ], [ %781, %1106 ]
  %1113 = phi i64 [ %965, %964 ], [ %981, %980 ], [ %782, %1036 ], [ %782, %1109 ], [ %782, %1106 ]
  %1114 = phi i64 [ 0, %964 ], [ 0, %980 ], [ %783, %1036 ], [ %783, %1109 ], [ %783, %1106 ]
  %1115 = phi i1 [ false, %964 ], [ false, %980 ], [ false, %1036 ], [ true, %1109 ], [ false, %1106 ]
  %1116 = phi i32 [ 1, %964 ], [ 1, %980 ], [ 2, %1036 ], [ 0, %1109 ], [ 2, %1106 ]
  %1117 = phi i64 [ %720, %964 ], [ 0, %980 ], [ %993, %1036 ], [ %993, %1109 ], [ %993, %1106 ]
  %1118 = phi double [ %719, %964 ], [ %970, %980 ], [ %983, %1036 ], [ %983, %1109 ], [ %983, %1106 ]
  %1119 = phi double [ %718, %964 ], [ %718, %980 ], [ %718, %1036 ], [ %960, %1109 ], [ %718, %1106 ]
  br i1 %1115, label %1120, label %1123

1120:                                             ; preds = %1110
  %1121 = add nuw nsw i64 %721, 1
  %1122 = icmp eq i64 %1121, %707
  br i1 %1122, label %1123, label %717, !llvm.loop !33

1123:                                             ; preds = %896, %1110, %778, %717, %1120
  %1124 = phi double [ %725, %717 ], [ %1111, %1110 ], [ %780, %778 ], [ %1111, %1120 ], [ 0x7FF0000000000000, %896 ]
  %1125 = phi i32 [ %724, %717 ], [ %1112, %1110 ], [ %781, %778 ], [ %1112, %1120 ], [ 0, %896 ]
  %1126 = phi i64 [ %723, %717 ], [ %1113, %1110 ], [ %782, %778 ], [ %1113, %1120 ], [ %721, %896 ]
  %1127 = phi i64 [ %722, %717 ], [ %1114, %1110 ], [ %783, %778 ], [ %1114, %1120 ], [ 0, %896 ]
  %1128 = phi i32 [ 2, %717 ], [ %1116, %1110 ], [ %784, %778 ], [ 2, %1120 ], [ 1, %896 ]
  %1129 = phi i64 [ 0, %717 ], [ %1117, %1110 ], [ %720, %778 ], [ %1117, %1120 ], [ %720, %896 ]
  %1130 = phi double [ %719, %717 ], [ %1118, %1110 ], [ %719, %778 ], [ %1118, %1120 ], [ %719, %896 ]
  %1131 = icmp eq i32 %1128, 2
  br i1 %1131, label %1132, label %1136

1132:                                             ; preds = %1123
  %1133 = icmp sgt i64 %1129, 0
  %1134 = select i1 %1133, i64 %1129, i64 6
  %1135 = zext i1 %1133 to i32
  br label %1136

1136:                                             ; preds = %1123, %1132
  %1137 = phi double [ %1130, %1132 ], [ %1124, %1123 ]
  %1138 = phi i32 [ %1135, %1132 ], [ %1125, %1123 ]
  %1139 = phi i64 [ %1134, %1132 ], [ %1126, %1123 ]
  %1140 = phi i64 [ 0, %1132 ], [ %1127, %1123 ]
  %1141 = icmp slt i64 %1140, 0
  br i1 %1141, label %1883, label %1142

1142:                                             ; preds = %1136
  %1143 = icmp eq i32 %1138, 0
  br i1 %1143, label %1145, label %1144

1144:                                             ; preds = %1142
  br i1 %300, label %1296, label %1195

1145:                                             ; preds = %1142
  %1146 = load i64, ptr %242, align 8
  %1147 = add nsw i64 %1146, 1
  store i64 %1147, ptr %242, align 8
  %1148 = tail call double @llvm.fabs.f64(double %1137)
  %1149 = fcmp ueq double %1148, 0x7FF0000000000000
  %1150 = select i1 %1149, i64 4, i64 7
  %1151 = icmp eq i64 %1140, 0
  %1152 = select i1 %1151, i64 %1150, i64 3
  store i64 %1152, ptr %357, align 8
  %1153 = load i64, ptr %358, align 8
  %1154 = icmp eq i64 %1153, 1
  %1155 = and i1 %1151, %1154
  br i1 %1155, label %1156, label %1182

1156:                                             ; preds = %1145
  %1157 = load i64, ptr %360, align 8
  %1158 = icmp sgt i64 %1157, 0
  br i1 %1158, label %1159, label %1176

1159:                                             ; preds = %1156, %1168
  %1160 = phi i64 [ %1173, %1168 ], [ 0, %1156 ]
  %1161 = phi i32 [ %1170, %1168 ], [ 0, %1156 ]
  %1162 = icmp eq i32 %1161, 0
  br i1 %1162, label %1163, label %1168

1163:                                             ; preds = %1159
  %1164 = load ptr, ptr %359, align 8
  %1165 = getelementptr inbounds double, ptr %1164, i64 %1160
  %1166 = load double, ptr %1165, align 8
  %1167 = fcmp une double %1166, 0.000000e+00
  br label %1168

1168:                                             ; preds = %1163, %1159
  %1169 = phi i1 [ true, %1159 ], [ %1167, %1163 ]
  %1170 = zext i1 %1169 to i32
  %1171 = load ptr, ptr %359, align 8
  %1172 = getelementptr inbounds double, ptr %1171, i64 %1160
  store double 0.000000e+00, ptr %1172, align 8
  %1173 = add nuw nsw i64 %1160, 1
  %1174 = load i64, ptr %360, align 8
  %1175 = icmp slt i64 %1173, %1174
  br i1 %1175, label %1159, label %1176, !llvm.loop !34

1176:                                             ; preds = %1168, %1156
  %1177 = phi i32 [ 0, %1156 ], [ %1170, %1168 ]
  %1178 = icmp eq i32 %1177, 0
  br i1 %1178, label %1180, label %1179

1179:                                             ; preds = %1176
  store i64 0, ptr %263, align 8
  br label %1883, !llvm.loop !17

1180:                                             ; preds = %1176
  store i64 0, ptr %358, align 8
  %1181 = fmul double %404, 5.000000e-01
  br label %1182

1182:                                             ; preds = %1180, %1145
  %1183 = phi double [ %1181, %1180 ], [ %369, %1145 ]
  %1184 = load i64, ptr %358, align 8
  %1185 = icmp eq i64 %1184, 1
  %1186 = icmp ne i64 %1140, 0
  %1187 = or i1 %1186, %1185
  br i1 %1187, label %1188, label %1191

1188:                                             ; preds = %1182
  %1189 = select i1 %1151, double 5.000000e-01, double 2.500000e-01
  %1190 = fmul double %404, %1189
  store double 0.000000e+00, ptr %271, align 8
  br label %1191

1191:                                             ; preds = %1182, %1188
  %1192 = phi double [ %1190, %1188 ], [ %1183, %1182 ]
  %1193 = load i64, ptr %358, align 8
  %1194 = sub nsw i64 1, %1193
  store i64 %1194, ptr %245, align 8
  br label %1883, !llvm.loop !17

1195:                                             ; preds = %1296, %1144
  %1196 = load i64, ptr %303, align 8
  %1197 = icmp eq i64 %1196, 1
  %1198 = load ptr, ptr %76, align 8
  %1199 = getelementptr inbounds i8, ptr %1198, i64 8
  %1200 = load i64, ptr %1199, align 8
  %1201 = load i64, ptr %305, align 8
  %1202 = load ptr, ptr %306, align 8
  %1203 = load ptr, ptr %277, align 8
  %1204 = icmp sgt i64 %1200, 0
  br i1 %1204, label %1205, label %1207

1205:                                             ; preds = %1195
  %1206 = shl i64 %1200, 4
  br label %1216

1207:                                             ; preds = %1216, %1195
  %1208 = load ptr, ptr %308, align 8
  %1209 = load ptr, ptr %304, align 8
  tail call fastcc void @real_solve(ptr noundef %1208, i64 noundef %1201, ptr noundef %1209, ptr noundef %1203) #10
  %1210 = load ptr, ptr %309, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1203, ptr noundef %1210, ptr noundef nonnull %77, i64 noundef %1200) #10
  %1211 = load double, ptr %6, align 8
  %1212 = fcmp uge double %1211, 1.000000e+00
  %1213 = and i1 %1197, %1212
  br i1 %1213, label %1214, label %1292

1214:                                             ; preds = %1207
  %1215 = icmp sgt i64 %1200, 0
  br i1 %1215, label %1264, label %1241

1216:                                             ; preds = %1205, %1216
  %1217 = phi i64 [ 0, %1205 ], [ %1239, %1216 ]
  %1218 = load ptr, ptr %273, align 8
  %1219 = getelementptr inbounds double, ptr %1218, i64 %1217
  %1220 = load double, ptr %1219, align 8
  %1221 = fmul double %1220, 0x402418FD8BAFFE05
  %1222 = getelementptr double, ptr %1218, i64 %1200
  %1223 = getelementptr double, ptr %1222, i64 %1217
  %1224 = load double, ptr %1223, align 8
  %1225 = fmul double %1224, 0x3FF61D41B2D54580
  %1226 = fsub double %1225, %1221
  %1227 = getelementptr i8, ptr %1218, i64 %1206
  %1228 = getelementptr double, ptr %1227, i64 %1217
  %1229 = load double, ptr %1228, align 8
  %1230 = fmul double %1229, 0x3FD5555555555555
  %1231 = fsub double %1226, %1230
  %1232 = fdiv double %1231, %404
  %1233 = getelementptr inbounds double, ptr %1202, i64 %1217
  store double %1232, ptr %1233, align 8
  %1234 = load ptr, ptr %307, align 8
  %1235 = getelementptr inbounds double, ptr %1234, i64 %1217
  %1236 = load double, ptr %1235, align 8
  %1237 = fadd double %1236, %1232
  %1238 = getelementptr inbounds double, ptr %1203, i64 %1217
  store double %1237, ptr %1238, align 8
  %1239 = add nuw nsw i64 %1217, 1
  %1240 = icmp eq i64 %1239, %1200
  br i1 %1240, label %1207, label %1216, !llvm.loop !35

1241:                                             ; preds = %1264, %1214
  %1242 = load ptr, ptr %83, align 8
  %1243 = getelementptr inbounds i8, ptr %1242, i64 24
  %1244 = load i64, ptr %1243, align 8
  %1245 = add nsw i64 %1244, 1
  store i64 %1245, ptr %1243, align 8
  %1246 = load ptr, ptr %311, align 8
  %1247 = load ptr, ptr %276, align 8
  %1248 = load ptr, ptr %312, align 8
  store double %368, ptr %1248, align 8
  %1249 = load i64, ptr %313, align 8
  %1250 = icmp sgt i64 %1249, 0
  br i1 %1250, label %1251, label %1252

1251:                                             ; preds = %1241
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1252

1252:                                             ; preds = %1241, %1251
  %1253 = load ptr, ptr %76, align 8
  %1254 = load i64, ptr %1253, align 8
  %1255 = load ptr, ptr %312, align 8
  %1256 = load ptr, ptr %314, align 8
  %1257 = load ptr, ptr %315, align 8
  %1258 = inttoptr i64 %1254 to ptr
  %1259 = tail call i32 %1258(ptr noundef %1255, ptr noundef %1246, ptr noundef %1256, ptr noundef %1257, ptr noundef %1247) #11
  %1260 = sext i32 %1259 to i64
  %1261 = icmp eq i32 %1259, 0
  br i1 %1261, label %1262, label %1292

1262:                                             ; preds = %1252
  %1263 = icmp sgt i64 %1200, 0
  br i1 %1263, label %1281, label %1276

1264:                                             ; preds = %1214, %1264
  %1265 = phi i64 [ %1274, %1264 ], [ 0, %1214 ]
  %1266 = load ptr, ptr %77, align 8
  %1267 = getelementptr inbounds double, ptr %1266, i64 %1265
  %1268 = load double, ptr %1267, align 8
  %1269 = getelementptr inbounds double, ptr %1203, i64 %1265
  %1270 = load double, ptr %1269, align 8
  %1271 = fadd double %1268, %1270
  %1272 = load ptr, ptr %310, align 8
  %1273 = getelementptr inbounds double, ptr %1272, i64 %1265
  store double %1271, ptr %1273, align 8
  %1274 = add nuw nsw i64 %1265, 1
  %1275 = icmp eq i64 %1274, %1200
  br i1 %1275, label %1241, label %1264, !llvm.loop !36

1276:                                             ; preds = %1281, %1262
  %1277 = load ptr, ptr %308, align 8
  %1278 = load ptr, ptr %304, align 8
  tail call fastcc void @real_solve(ptr noundef %1277, i64 noundef %1201, ptr noundef %1278, ptr noundef %1203) #10
  %1279 = load ptr, ptr %309, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %1203, ptr noundef %1279, ptr noundef nonnull %77, i64 noundef %1200) #10
  %1280 = load double, ptr %7, align 8
  br label %1292

1281:                                             ; preds = %1262, %1281
  %1282 = phi i64 [ %1290, %1281 ], [ 0, %1262 ]
  %1283 = load ptr, ptr %276, align 8
  %1284 = getelementptr inbounds double, ptr %1283, i64 %1282
  %1285 = load double, ptr %1284, align 8
  %1286 = getelementptr inbounds double, ptr %1202, i64 %1282
  %1287 = load double, ptr %1286, align 8
  %1288 = fadd double %1285, %1287
  %1289 = getelementptr inbounds double, ptr %1203, i64 %1282
  store double %1288, ptr %1289, align 8
  %1290 = add nuw nsw i64 %1282, 1
  %1291 = icmp eq i64 %1290, %1200
  br i1 %1291, label %1276, label %1281, !llvm.loop !37

1292:                                             ; preds = %1207, %1252, %1276
  %1293 = phi double [ %1280, %1276 ], [ %1211, %1252 ], [ %1211, %1207 ]
  %1294 = phi i64 [ 0, %1276 ], [ %1260, %1252 ], [ 0, %1207 ]
  %1295 = icmp slt i64 %1294, 0
  br i1 %1295, label %1883, label %1310

1296:                                             ; preds = %1144, %1296
  %1297 = phi i64 [ %1308, %1296 ], [ 0, %1144 ]
  %1298 = load ptr, ptr %77, align 8
  %1299 = getelementptr inbounds double, ptr %1298, i64 %1297
  %1300 = load double, ptr %1299, align 8
  %1301 = load ptr, ptr %273, align 8
  %1302 = getelementptr i8, ptr %1301, i64 %301
  %1303 = getelementptr double, ptr %1302, i64 %1297
  %1304 = load double, ptr %1303, align 8
  %1305 = fadd double %1300, %1304
  %1306 = load ptr, ptr %302, align 8
  %1307 = getelementptr inbounds double, ptr %1306, i64 %1297
  store double %1305, ptr %1307, align 8
  %1308 = add nuw nsw i64 %1297, 1
  %1309 = icmp eq i64 %1308, %92
  br i1 %1309, label %1195, label %1296, !llvm.loop !38

1310:                                             ; preds = %1292
  %1311 = add nsw i64 %1139, 12
  %1312 = sitofp i64 %1311 to double
  %1313 = fdiv double 0x4027666666666667, %1312
  %1314 = fcmp olt double %1293, 1.000000e-10
  %1315 = select i1 %1314, double 1.000000e-10, double %1293
  %1316 = tail call double @llvm.pow.f64(double %1315, double -2.500000e-01)
  %1317 = icmp eq i64 %1294, 0
  %1318 = fcmp olt double %1293, 1.000000e+00
  %1319 = select i1 %1317, i1 %1318, i1 false
  br i1 %1319, label %1335, label %1320

1320:                                             ; preds = %1310
  %1321 = load i64, ptr %242, align 8
  %1322 = add nsw i64 %1321, 1
  store i64 %1322, ptr %242, align 8
  %1323 = select i1 %1317, i64 2, i64 3
  store i64 %1323, ptr %316, align 8
  %1324 = tail call double @llvm.fabs.f64(double %1293)
  %1325 = fcmp ueq double %1324, 0x7FF0000000000000
  br i1 %1325, label %1330, label %1326

1326:                                             ; preds = %1320
  %1327 = fmul double %1313, %1316
  %1328 = fcmp ogt double %1327, 2.000000e-01
  %1329 = select i1 %1328, double %1327, double 2.000000e-01
  br label %1330

1330:                                             ; preds = %1320, %1326
  %1331 = phi double [ %1329, %1326 ], [ 2.500000e-01, %1320 ]
  %1332 = fmul double %404, %1331
  store i64 1, ptr %303, align 8
  %1333 = load i64, ptr %317, align 8
  %1334 = sub nsw i64 1, %1333
  store i64 %1334, ptr %245, align 8
  br label %1883, !llvm.loop !17

1335:                                             ; preds = %1310
  br i1 %103, label %1336, label %1351

1336:                                             ; preds = %1335
  %1337 = load ptr, ptr %309, align 8
  %1338 = load ptr, ptr %77, align 8
  %1339 = load ptr, ptr %100, align 8
  %1340 = getelementptr inbounds i8, ptr %1339, i64 56
  %1341 = load i64, ptr %1340, align 8
  %1342 = inttoptr i64 %1341 to ptr
  %1343 = tail call i64 %1342(ptr noundef %0, double noundef %405, ptr noundef %1337, ptr noundef %1338) #11
  %1344 = icmp eq i64 %1343, 0
  br i1 %1344, label %1351, label %1345

1345:                                             ; preds = %1336
  %1346 = load i64, ptr %242, align 8
  %1347 = add nsw i64 %1346, 1
  store i64 %1347, ptr %242, align 8
  store i64 6, ptr %318, align 8
  %1348 = fmul double %404, 2.500000e-01
  store i64 1, ptr %303, align 8
  %1349 = load i64, ptr %319, align 8
  %1350 = sub nsw i64 1, %1349
  store i64 %1350, ptr %245, align 8
  br label %1883, !llvm.loop !17

1351:                                             ; preds = %1336, %1335
  %1352 = load i64, ptr %241, align 8
  %1353 = add nsw i64 %1352, 1
  store i64 %1353, ptr %241, align 8
  %1354 = load double, ptr %320, align 8
  %1355 = fcmp ogt double %1354, 0.000000e+00
  br i1 %1355, label %1356, label %1365

1356:                                             ; preds = %1351
  %1357 = fdiv double %1354, %1315
  %1358 = tail call double @llvm.pow.f64(double %1357, double 2.500000e-01)
  %1359 = load double, ptr %321, align 8
  %1360 = fdiv double %404, %1359
  %1361 = fmul double %1358, %1360
  %1362 = fcmp olt double %1361, 1.000000e+00
  %1363 = select i1 %1362, double %1361, double 1.000000e+00
  %1364 = fmul double %1316, %1363
  br label %1365

1365:                                             ; preds = %1356, %1351
  %1366 = phi double [ %1364, %1356 ], [ %1316, %1351 ]
  %1367 = fmul double %1313, %1366
  %1368 = fcmp olt double %1367, 1.000000e+01
  store double %405, ptr %80, align 8
  store double %404, ptr %322, align 8
  store double %1315, ptr %320, align 8
  %1369 = load ptr, ptr %76, align 8
  %1370 = getelementptr inbounds i8, ptr %1369, i64 8
  %1371 = load i64, ptr %1370, align 8
  %1372 = load i64, ptr %323, align 8
  %1373 = load ptr, ptr %273, align 8
  %1374 = load ptr, ptr %324, align 8
  %1375 = load ptr, ptr %272, align 8
  br label %1392

1376:                                             ; preds = %1392
  %1377 = select i1 %1368, double %1367, double 1.000000e+01
  %1378 = icmp sgt i64 %1371, 0
  br i1 %1378, label %1379, label %1452

1379:                                             ; preds = %1376
  %1380 = load double, ptr %8, align 16
  %1381 = load double, ptr %325, align 8
  %1382 = getelementptr double, ptr %1373, i64 %1371
  %1383 = load double, ptr %326, align 16
  %1384 = shl i64 %1371, 4
  %1385 = getelementptr i8, ptr %1373, i64 %1384
  %1386 = load double, ptr %9, align 16
  %1387 = load double, ptr %327, align 8
  %1388 = load double, ptr %328, align 16
  %1389 = getelementptr double, ptr %1374, i64 %1372
  %1390 = shl i64 %1372, 4
  %1391 = getelementptr i8, ptr %1374, i64 %1390
  br label %1403

1392:                                             ; preds = %1365, %1392
  %1393 = phi i64 [ 0, %1365 ], [ %1401, %1392 ]
  %1394 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1393
  %1395 = getelementptr inbounds i8, ptr %1394, i64 8
  %1396 = load double, ptr %1395, align 8
  %1397 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %1393
  store double %1396, ptr %1397, align 8
  %1398 = getelementptr inbounds i8, ptr %1394, i64 16
  %1399 = load double, ptr %1398, align 8
  %1400 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %1393
  store double %1399, ptr %1400, align 8
  %1401 = add nuw nsw i64 %1393, 1
  %1402 = icmp eq i64 %1401, 3
  br i1 %1402, label %1376, label %1392, !llvm.loop !39

1403:                                             ; preds = %1379, %1440
  %1404 = phi i64 [ 0, %1379 ], [ %1441, %1440 ]
  %1405 = getelementptr inbounds double, ptr %1373, i64 %1404
  %1406 = load double, ptr %1405, align 8
  %1407 = fmul double %1380, %1406
  %1408 = getelementptr double, ptr %1382, i64 %1404
  %1409 = load double, ptr %1408, align 8
  %1410 = fmul double %1381, %1409
  %1411 = fadd double %1407, %1410
  %1412 = getelementptr double, ptr %1385, i64 %1404
  %1413 = load double, ptr %1412, align 8
  %1414 = fmul double %1383, %1413
  %1415 = fadd double %1411, %1414
  %1416 = fmul double %1406, %1386
  %1417 = fmul double %1409, %1387
  %1418 = fadd double %1416, %1417
  %1419 = fmul double %1413, %1388
  %1420 = fadd double %1418, %1419
  %1421 = load ptr, ptr %309, align 8
  %1422 = getelementptr inbounds double, ptr %1421, i64 %1404
  %1423 = load double, ptr %1422, align 8
  %1424 = load ptr, ptr %77, align 8
  %1425 = getelementptr inbounds double, ptr %1424, i64 %1404
  %1426 = load double, ptr %1425, align 8
  %1427 = fsub double %1423, %1426
  %1428 = getelementptr inbounds double, ptr %1374, i64 %1404
  store double %1427, ptr %1428, align 8
  %1429 = fneg double %1415
  %1430 = fsub double %1429, %1420
  %1431 = getelementptr double, ptr %1389, i64 %1404
  store double %1430, ptr %1431, align 8
  %1432 = fneg double %1420
  %1433 = getelementptr double, ptr %1391, i64 %1404
  store double %1432, ptr %1433, align 8
  %1434 = load ptr, ptr %77, align 8
  %1435 = getelementptr inbounds double, ptr %1434, i64 %1404
  %1436 = load double, ptr %1435, align 8
  %1437 = getelementptr inbounds double, ptr %1375, i64 %1404
  store double %1436, ptr %1437, align 8
  %1438 = getelementptr double, ptr %1374, i64 %1404
  %1439 = getelementptr double, ptr %1375, i64 %1404
  br label %1443

1440:                                             ; preds = %1443
  %1441 = add nuw nsw i64 %1404, 1
  %1442 = icmp eq i64 %1441, %1371
  br i1 %1442, label %1452, label %1403, !llvm.loop !40

1443:                                             ; preds = %1403, %1443
  %1444 = phi i64 [ 0, %1403 ], [ %1448, %1443 ]
  %1445 = mul nsw i64 %1372, %1444
  %1446 = getelementptr double, ptr %1438, i64 %1445
  %1447 = load double, ptr %1446, align 8
  %1448 = add nuw nsw i64 %1444, 1
  %1449 = mul nuw nsw i64 %1371, %1448
  %1450 = getelementptr double, ptr %1439, i64 %1449
  store double %1447, ptr %1450, align 8
  %1451 = icmp eq i64 %1448, 3
  br i1 %1451, label %1440, label %1443, !llvm.loop !41

1452:                                             ; preds = %1440, %1376
  store double %404, ptr %271, align 8
  %1453 = load ptr, ptr %0, align 8
  %1454 = getelementptr inbounds i8, ptr %1453, i64 24
  %1455 = load i64, ptr %1454, align 8
  %1456 = load ptr, ptr %240, align 8
  %1457 = getelementptr inbounds i8, ptr %1456, i64 8
  %1458 = load i64, ptr %1457, align 8
  %1459 = icmp eq i64 %1458, 0
  br i1 %1459, label %1506, label %1460

1460:                                             ; preds = %1452
  %1461 = load i64, ptr %1456, align 8
  %1462 = load ptr, ptr %76, align 8
  %1463 = getelementptr inbounds i8, ptr %1462, i64 8
  %1464 = load i64, ptr %1463, align 8
  %1465 = load ptr, ptr %329, align 8
  %1466 = load i64, ptr %330, align 8
  %1467 = mul nsw i64 %1466, %1461
  %1468 = getelementptr inbounds double, ptr %1465, i64 %1467
  %1469 = getelementptr inbounds double, ptr %1468, i64 %1466
  store double %368, ptr %1468, align 8
  %1470 = getelementptr inbounds i8, ptr %1468, i64 8
  store double %404, ptr %1470, align 8
  store double %405, ptr %1469, align 8
  %1471 = getelementptr inbounds i8, ptr %1469, i64 8
  store double 0.000000e+00, ptr %1471, align 8
  %1472 = icmp sgt i64 %1464, 0
  br i1 %1472, label %1473, label %1476

1473:                                             ; preds = %1460
  %1474 = getelementptr i8, ptr %1468, i64 16
  %1475 = icmp sgt i64 %1455, 0
  br label %1479

1476:                                             ; preds = %1491, %1460
  %1477 = add nsw i64 %1461, 1
  %1478 = load ptr, ptr %240, align 8
  store i64 %1477, ptr %1478, align 8
  br label %1506

1479:                                             ; preds = %1473, %1491
  %1480 = phi i64 [ 0, %1473 ], [ %1492, %1491 ]
  %1481 = load ptr, ptr %77, align 8
  %1482 = getelementptr inbounds double, ptr %1481, i64 %1480
  %1483 = load double, ptr %1482, align 8
  %1484 = add nuw nsw i64 %1480, 2
  %1485 = getelementptr inbounds double, ptr %1468, i64 %1484
  store double %1483, ptr %1485, align 8
  %1486 = load ptr, ptr %309, align 8
  %1487 = getelementptr inbounds double, ptr %1486, i64 %1480
  %1488 = load double, ptr %1487, align 8
  %1489 = getelementptr inbounds double, ptr %1469, i64 %1484
  store double %1488, ptr %1489, align 8
  %1490 = getelementptr double, ptr %1474, i64 %1480
  br i1 %1475, label %1494, label %1491

1491:                                             ; preds = %1494, %1479
  %1492 = add nuw nsw i64 %1480, 1
  %1493 = icmp eq i64 %1492, %1464
  br i1 %1493, label %1476, label %1479, !llvm.loop !42

1494:                                             ; preds = %1479, %1494
  %1495 = phi i64 [ %1502, %1494 ], [ 0, %1479 ]
  %1496 = load ptr, ptr %324, align 8
  %1497 = load i64, ptr %323, align 8
  %1498 = mul nsw i64 %1497, %1495
  %1499 = getelementptr double, ptr %1496, i64 %1498
  %1500 = getelementptr double, ptr %1499, i64 %1480
  %1501 = load double, ptr %1500, align 8
  %1502 = add nuw nsw i64 %1495, 1
  %1503 = mul nuw nsw i64 %1502, %1464
  %1504 = getelementptr double, ptr %1490, i64 %1503
  store double %1501, ptr %1504, align 8
  %1505 = icmp eq i64 %1502, %1455
  br i1 %1505, label %1491, label %1494, !llvm.loop !43

1506:                                             ; preds = %1452, %1476
  br i1 %108, label %1507, label %1614

1507:                                             ; preds = %1506
  %1508 = load ptr, ptr %104, align 8
  %1509 = load ptr, ptr %76, align 8
  %1510 = getelementptr inbounds i8, ptr %1509, i64 8
  %1511 = load i64, ptr %1510, align 8
  %1512 = load ptr, ptr %331, align 8
  %1513 = getelementptr inbounds i8, ptr %1508, i64 32
  %1514 = load i64, ptr %1513, align 8
  %1515 = getelementptr inbounds double, ptr %1512, i64 %1514
  %1516 = load ptr, ptr %273, align 8
  %1517 = getelementptr inbounds i8, ptr %1508, i64 24
  %1518 = load i64, ptr %1517, align 8
  %1519 = icmp eq i64 %1518, 0
  br i1 %1519, label %1611, label %1520

1520:                                             ; preds = %1507
  %1521 = getelementptr inbounds i8, ptr %1508, i64 40
  %1522 = load i64, ptr %1521, align 8
  %1523 = icmp sgt i64 %1522, 0
  br i1 %1523, label %1524, label %1528

1524:                                             ; preds = %1520
  %1525 = getelementptr double, ptr %1516, i64 %1511
  %1526 = shl i64 %1511, 4
  %1527 = getelementptr i8, ptr %1516, i64 %1526
  br label %1581

1528:                                             ; preds = %1581, %1520
  %1529 = load ptr, ptr %332, align 8
  %1530 = load ptr, ptr %104, align 8
  %1531 = getelementptr inbounds i8, ptr %1530, i64 8
  %1532 = load i64, ptr %1531, align 8
  %1533 = load ptr, ptr %333, align 8
  %1534 = load ptr, ptr %331, align 8
  %1535 = getelementptr inbounds i8, ptr %1530, i64 32
  %1536 = load i64, ptr %1535, align 8
  %1537 = getelementptr inbounds i8, ptr %1530, i64 40
  %1538 = load i64, ptr %1537, align 8
  %1539 = getelementptr double, ptr %1534, i64 %1536
  %1540 = getelementptr double, ptr %1539, i64 %1538
  store double %404, ptr %1540, align 8
  %1541 = load ptr, ptr %332, align 8
  store double %368, ptr %1541, align 8
  %1542 = load ptr, ptr %104, align 8
  %1543 = getelementptr inbounds i8, ptr %1542, i64 24
  %1544 = load i64, ptr %1543, align 8
  %1545 = load ptr, ptr %77, align 8
  %1546 = load ptr, ptr %331, align 8
  %1547 = load ptr, ptr %334, align 8
  %1548 = inttoptr i64 %1544 to ptr
  %1549 = tail call i32 %1548(ptr noundef %1529, ptr noundef %1545, ptr noundef %1546, ptr noundef %1547, ptr noundef %1533) #11
  %1550 = icmp eq i32 %1549, 0
  br i1 %1550, label %1551, label %1611

1551:                                             ; preds = %1528
  %1552 = icmp slt i64 %1532, 1
  br i1 %1552, label %1578, label %1553

1553:                                             ; preds = %1551
  %1554 = load ptr, ptr %335, align 8
  %1555 = getelementptr double, ptr %1533, i64 %1532
  br label %1556

1556:                                             ; preds = %1553, %1574
  %1557 = phi i1 [ %1552, %1553 ], [ %1576, %1574 ]
  %1558 = phi i64 [ 0, %1553 ], [ %1575, %1574 ]
  %1559 = getelementptr inbounds i64, ptr %1554, i64 %1558
  %1560 = load i64, ptr %1559, align 8
  %1561 = and i64 %1560, 2
  %1562 = icmp eq i64 %1561, 0
  br i1 %1562, label %1563, label %1574

1563:                                             ; preds = %1556
  %1564 = getelementptr inbounds double, ptr %1533, i64 %1558
  %1565 = load double, ptr %1564, align 8
  %1566 = load ptr, ptr %336, align 8
  %1567 = getelementptr inbounds i64, ptr %1566, i64 %1558
  %1568 = load i64, ptr %1567, align 8
  %1569 = sitofp i64 %1568 to double
  %1570 = fmul double %1565, %1569
  %1571 = getelementptr double, ptr %1555, i64 %1558
  %1572 = load double, ptr %1571, align 8
  %1573 = fcmp ogt double %1570, %1572
  br i1 %1573, label %1574, label %1578

1574:                                             ; preds = %1563, %1556
  %1575 = add nuw nsw i64 %1558, 1
  %1576 = icmp sge i64 %1575, %1532
  %1577 = icmp eq i64 %1575, %1532
  br i1 %1577, label %1578, label %1556, !llvm.loop !44

1578:                                             ; preds = %1574, %1563, %1551
  %1579 = phi i1 [ %1552, %1551 ], [ %1576, %1574 ], [ %1557, %1563 ]
  %1580 = zext i1 %1579 to i32
  br label %1611

1581:                                             ; preds = %1524, %1581
  %1582 = phi i64 [ 0, %1524 ], [ %1608, %1581 ]
  %1583 = load ptr, ptr %309, align 8
  %1584 = getelementptr inbounds double, ptr %1583, i64 %1582
  %1585 = load double, ptr %1584, align 8
  %1586 = load ptr, ptr %77, align 8
  %1587 = getelementptr inbounds double, ptr %1586, i64 %1582
  %1588 = load double, ptr %1587, align 8
  %1589 = fsub double %1585, %1588
  %1590 = tail call double @llvm.fabs.f64(double %1589)
  %1591 = getelementptr inbounds double, ptr %1516, i64 %1582
  %1592 = load double, ptr %1591, align 8
  %1593 = tail call double @llvm.fabs.f64(double %1592)
  %1594 = getelementptr double, ptr %1525, i64 %1582
  %1595 = load double, ptr %1594, align 8
  %1596 = tail call double @llvm.fabs.f64(double %1595)
  %1597 = fcmp ogt double %1593, %1596
  %1598 = select i1 %1597, double %1593, double %1596
  %1599 = getelementptr double, ptr %1527, i64 %1582
  %1600 = load double, ptr %1599, align 8
  %1601 = tail call double @llvm.fabs.f64(double %1600)
  %1602 = fcmp ogt double %1598, %1601
  %1603 = select i1 %1602, double %1598, double %1601
  %1604 = fcmp ogt double %1603, %1590
  %1605 = select i1 %1604, double %1603, double %1590
  %1606 = fmul double %1605, 8.000000e+00
  %1607 = getelementptr inbounds double, ptr %1515, i64 %1582
  store double %1606, ptr %1607, align 8
  %1608 = add nuw nsw i64 %1582, 1
  %1609 = load i64, ptr %1521, align 8
  %1610 = icmp slt i64 %1608, %1609
  br i1 %1610, label %1581, label %1528, !llvm.loop !45

1611:                                             ; preds = %1578, %1528, %1507
  %1612 = phi i32 [ 0, %1507 ], [ 0, %1528 ], [ %1580, %1578 ]
  %1613 = icmp eq i32 %1612, 0
  br label %1614

1614:                                             ; preds = %1611, %1506
  %1615 = phi i1 [ false, %1506 ], [ %1613, %1611 ]
  br i1 %1615, label %1621, label %1616

1616:                                             ; preds = %1614
  %1617 = load i64, ptr %337, align 8
  %1618 = getelementptr inbounds double, ptr %94, i64 %1617
  %1619 = load double, ptr %1618, align 8
  %1620 = fcmp ugt double %1619, %405
  br i1 %1620, label %1833, label %1621

1621:                                             ; preds = %1616, %1614
  %1622 = load ptr, ptr %79, align 8
  br i1 %1615, label %1623, label %1634

1623:                                             ; preds = %1621
  %1624 = load ptr, ptr %104, align 8
  %1625 = getelementptr inbounds i8, ptr %1624, i64 16
  %1626 = load i64, ptr %1625, align 8
  %1627 = inttoptr i64 %1626 to ptr
  %1628 = tail call i64 %1627(ptr noundef %0, double noundef %368, double noundef %404) #11
  %1629 = icmp eq i64 %1628, -6
  br i1 %1629, label %1630, label %1631

1630:                                             ; preds = %1623
  store double %368, ptr %1622, align 8
  br label %1809

1631:                                             ; preds = %1623
  %1632 = getelementptr inbounds i8, ptr %1622, i64 48
  %1633 = load double, ptr %1632, align 8
  br label %1634

1634:                                             ; preds = %1631, %1621
  %1635 = phi double [ %1633, %1631 ], [ 1.000000e+00, %1621 ]
  %1636 = phi i64 [ %1628, %1631 ], [ 0, %1621 ]
  %1637 = fcmp oeq double %1635, 1.000000e+00
  br i1 %1637, label %1638, label %1640

1638:                                             ; preds = %1634
  %1639 = load double, ptr %1622, align 8
  br label %1643

1640:                                             ; preds = %1634
  %1641 = fmul double %404, %1635
  %1642 = fadd double %368, %1641
  br label %1643

1643:                                             ; preds = %1640, %1638
  %1644 = phi double [ %1639, %1638 ], [ %1642, %1640 ]
  %1645 = icmp eq i64 %1636, -4
  %1646 = select i1 %1645, i64 -4, i64 0
  br i1 %1645, label %1704, label %1647

1647:                                             ; preds = %1643
  %1648 = fcmp olt double %1635, 1.000000e+00
  %1649 = load ptr, ptr %76, align 8
  %1650 = getelementptr inbounds i8, ptr %1649, i64 8
  %1651 = load i64, ptr %1650, align 8
  %1652 = load i64, ptr %95, align 8
  %1653 = load ptr, ptr %93, align 8
  %1654 = load ptr, ptr %83, align 8
  %1655 = getelementptr inbounds i8, ptr %1654, i64 48
  %1656 = load i64, ptr %1655, align 8
  %1657 = icmp slt i64 %1656, %1652
  br i1 %1657, label %1658, label %1700

1658:                                             ; preds = %1647, %1696
  %1659 = phi i64 [ %1697, %1696 ], [ undef, %1647 ]
  %1660 = phi i64 [ %1698, %1696 ], [ %1656, %1647 ]
  %1661 = getelementptr inbounds double, ptr %1653, i64 %1660
  %1662 = load double, ptr %1661, align 8
  %1663 = fcmp olt double %1662, %1644
  %1664 = fcmp oeq double %1662, %1644
  %1665 = and i1 %1648, %1664
  %1666 = or i1 %1663, %1665
  br i1 %1666, label %1667, label %1700

1667:                                             ; preds = %1658
  %1668 = fsub double %1662, %368
  %1669 = fdiv double %1668, %404
  %1670 = mul nsw i64 %1660, %1651
  %1671 = getelementptr inbounds double, ptr %1, i64 %1670
  %1672 = load ptr, ptr %338, align 8
  %1673 = insertelement <8 x double> poison, double %1669, i64 0
  %1674 = shufflevector <8 x double> %1673, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1674, ptr %1672, align 8
  %1675 = load ptr, ptr %77, align 8
  %1676 = load ptr, ptr %339, align 8
  %1677 = load i64, ptr %340, align 8
  %1678 = load ptr, ptr %0, align 8
  %1679 = getelementptr inbounds i8, ptr %1678, i64 24
  %1680 = load i64, ptr %1679, align 8
  %1681 = load ptr, ptr %338, align 8
  %1682 = load ptr, ptr %76, align 8
  %1683 = getelementptr inbounds i8, ptr %1682, i64 16
  %1684 = load i64, ptr %1683, align 8
  tail call fastcc void @nested(ptr noundef %1671, ptr noundef %1675, ptr noundef %1676, i64 noundef %1677, i64 noundef %1680, ptr noundef %1681, i64 noundef %1684) #10
  %1685 = load ptr, ptr %100, align 8
  %1686 = load i64, ptr %1685, align 8
  %1687 = icmp eq i64 %1686, 1
  br i1 %1687, label %1688, label %1696

1688:                                             ; preds = %1667
  %1689 = load double, ptr %1661, align 8
  %1690 = getelementptr inbounds i8, ptr %1685, i64 56
  %1691 = load i64, ptr %1690, align 8
  %1692 = inttoptr i64 %1691 to ptr
  %1693 = tail call i64 %1692(ptr noundef %0, double noundef %1689, ptr noundef %1671, ptr noundef null) #11
  %1694 = icmp eq i64 %1693, 0
  %1695 = select i1 %1694, i64 %1659, i64 %1693
  br i1 %1694, label %1696, label %1704

1696:                                             ; preds = %1688, %1667
  %1697 = phi i64 [ %1695, %1688 ], [ %1659, %1667 ]
  %1698 = add i64 %1660, 1
  %1699 = icmp eq i64 %1698, %1652
  br i1 %1699, label %1700, label %1658, !llvm.loop !46

1700:                                             ; preds = %1696, %1658, %1647
  %1701 = phi i64 [ %1656, %1647 ], [ %1652, %1696 ], [ %1660, %1658 ]
  %1702 = load ptr, ptr %83, align 8
  %1703 = getelementptr inbounds i8, ptr %1702, i64 48
  store i64 %1701, ptr %1703, align 8
  br label %1704

1704:                                             ; preds = %1688, %1700, %1643
  %1705 = phi i64 [ %1646, %1643 ], [ 0, %1700 ], [ %1695, %1688 ]
  %1706 = icmp eq i64 %1705, 0
  %1707 = icmp ne i64 %1636, 0
  %1708 = fcmp olt double %1635, 1.000000e+00
  %1709 = and i1 %1708, %1706
  %1710 = and i1 %1707, %1709
  br i1 %1710, label %1711, label %1748

1711:                                             ; preds = %1704
  %1712 = load ptr, ptr %341, align 8
  %1713 = load ptr, ptr %342, align 8
  %1714 = insertelement <8 x double> poison, double %1635, i64 0
  %1715 = shufflevector <8 x double> %1714, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1715, ptr %1713, align 8
  %1716 = load ptr, ptr %77, align 8
  %1717 = load ptr, ptr %343, align 8
  %1718 = load i64, ptr %344, align 8
  %1719 = load ptr, ptr %0, align 8
  %1720 = getelementptr inbounds i8, ptr %1719, i64 24
  %1721 = load i64, ptr %1720, align 8
  %1722 = load ptr, ptr %342, align 8
  %1723 = load ptr, ptr %76, align 8
  %1724 = getelementptr inbounds i8, ptr %1723, i64 16
  %1725 = load i64, ptr %1724, align 8
  tail call fastcc void @nested(ptr noundef %1712, ptr noundef %1716, ptr noundef %1717, i64 noundef %1718, i64 noundef %1721, ptr noundef %1722, i64 noundef %1725) #10
  %1726 = load i64, ptr %323, align 8
  %1727 = icmp sgt i64 %1726, 0
  br i1 %1727, label %1732, label %1728

1728:                                             ; preds = %1732, %1711
  %1729 = load ptr, ptr %100, align 8
  %1730 = load i64, ptr %1729, align 8
  %1731 = icmp eq i64 %1730, 1
  br i1 %1731, label %1742, label %1748

1732:                                             ; preds = %1711, %1732
  %1733 = phi i64 [ %1739, %1732 ], [ 0, %1711 ]
  %1734 = load ptr, ptr %341, align 8
  %1735 = getelementptr inbounds double, ptr %1734, i64 %1733
  %1736 = load double, ptr %1735, align 8
  %1737 = load ptr, ptr %309, align 8
  %1738 = getelementptr inbounds double, ptr %1737, i64 %1733
  store double %1736, ptr %1738, align 8
  %1739 = add nuw nsw i64 %1733, 1
  %1740 = load i64, ptr %323, align 8
  %1741 = icmp slt i64 %1739, %1740
  br i1 %1741, label %1732, label %1728, !llvm.loop !47

1742:                                             ; preds = %1728
  %1743 = load ptr, ptr %309, align 8
  %1744 = getelementptr inbounds i8, ptr %1729, i64 56
  %1745 = load i64, ptr %1744, align 8
  %1746 = inttoptr i64 %1745 to ptr
  %1747 = tail call i64 %1746(ptr noundef %0, double noundef %1644, ptr noundef %1743, ptr noundef null) #11
  br label %1748

1748:                                             ; preds = %1742, %1728, %1704
  %1749 = phi i64 [ %1747, %1742 ], [ 0, %1728 ], [ %1705, %1704 ]
  %1750 = icmp eq i64 %1749, 0
  br i1 %1750, label %1753, label %1751

1751:                                             ; preds = %1748
  store double %368, ptr %1622, align 8
  %1752 = getelementptr inbounds i8, ptr %1622, i64 8
  store double %404, ptr %1752, align 8
  br label %1809

1753:                                             ; preds = %1748
  br i1 %1637, label %1754, label %1792

1754:                                             ; preds = %1753
  %1755 = load ptr, ptr %309, align 8
  %1756 = load ptr, ptr %76, align 8
  %1757 = getelementptr inbounds i8, ptr %1756, i64 8
  %1758 = load i64, ptr %1757, align 8
  %1759 = load i64, ptr %95, align 8
  %1760 = load ptr, ptr %93, align 8
  %1761 = load ptr, ptr %83, align 8
  %1762 = getelementptr inbounds i8, ptr %1761, i64 48
  %1763 = load i64, ptr %1762, align 8
  %1764 = icmp slt i64 %1763, %1759
  br i1 %1764, label %1765, label %1788

1765:                                             ; preds = %1754
  %1766 = icmp sgt i64 %1758, 0
  br label %1767

1767:                                             ; preds = %1765, %1778
  %1768 = phi i64 [ %1763, %1765 ], [ %1779, %1778 ]
  %1769 = getelementptr inbounds double, ptr %1760, i64 %1768
  %1770 = load double, ptr %1769, align 8
  %1771 = load ptr, ptr %79, align 8
  %1772 = load double, ptr %1771, align 8
  %1773 = fcmp ugt double %1770, %1772
  br i1 %1773, label %1788, label %1774

1774:                                             ; preds = %1767
  br i1 %1766, label %1775, label %1778

1775:                                             ; preds = %1774
  %1776 = mul nsw i64 %1768, %1758
  %1777 = getelementptr double, ptr %1, i64 %1776
  br label %1781

1778:                                             ; preds = %1781, %1774
  %1779 = add i64 %1768, 1
  %1780 = icmp eq i64 %1779, %1759
  br i1 %1780, label %1788, label %1767, !llvm.loop !9

1781:                                             ; preds = %1775, %1781
  %1782 = phi i64 [ 0, %1775 ], [ %1786, %1781 ]
  %1783 = getelementptr inbounds double, ptr %1755, i64 %1782
  %1784 = load double, ptr %1783, align 8
  %1785 = getelementptr double, ptr %1777, i64 %1782
  store double %1784, ptr %1785, align 8
  %1786 = add nuw nsw i64 %1782, 1
  %1787 = icmp eq i64 %1786, %1758
  br i1 %1787, label %1778, label %1781, !llvm.loop !10

1788:                                             ; preds = %1778, %1767, %1754
  %1789 = phi i64 [ %1763, %1754 ], [ %1759, %1778 ], [ %1768, %1767 ]
  %1790 = load ptr, ptr %83, align 8
  %1791 = getelementptr inbounds i8, ptr %1790, i64 48
  store i64 %1789, ptr %1791, align 8
  br label %1792

1792:                                             ; preds = %1788, %1753
  br i1 %1707, label %1793, label %1809

1793:                                             ; preds = %1792
  %1794 = load i64, ptr %323, align 8
  %1795 = icmp sgt i64 %1794, 0
  br i1 %1795, label %1799, label %1796

1796:                                             ; preds = %1799, %1793
  store double %1644, ptr %1622, align 8
  %1797 = getelementptr inbounds i8, ptr %1622, i64 8
  store double 0.000000e+00, ptr %1797, align 8
  %1798 = load ptr, ptr %83, align 8
  store i64 0, ptr %1798, align 8
  br label %1809

1799:                                             ; preds = %1793, %1799
  %1800 = phi i64 [ %1806, %1799 ], [ 0, %1793 ]
  %1801 = load ptr, ptr %309, align 8
  %1802 = getelementptr inbounds double, ptr %1801, i64 %1800
  %1803 = load double, ptr %1802, align 8
  %1804 = load ptr, ptr %77, align 8
  %1805 = getelementptr inbounds double, ptr %1804, i64 %1800
  store double %1803, ptr %1805, align 8
  %1806 = add nuw nsw i64 %1800, 1
  %1807 = load i64, ptr %323, align 8
  %1808 = icmp slt i64 %1806, %1807
  br i1 %1808, label %1799, label %1796, !llvm.loop !48

1809:                                             ; preds = %1630, %1751, %1792, %1796
  %1810 = phi i64 [ -6, %1630 ], [ %1749, %1751 ], [ %1636, %1796 ], [ %1636, %1792 ]
  %1811 = icmp eq i64 %1810, -6
  br i1 %1811, label %1815, label %1812

1812:                                             ; preds = %1809
  %1813 = icmp ne i64 %1810, 6
  %1814 = select i1 %1813, i1 true, i1 %108
  br i1 %1814, label %1827, label %1815

1815:                                             ; preds = %1812, %1809
  %1816 = phi i64 [ %1810, %1812 ], [ 2, %1809 ]
  %1817 = load i64, ptr %241, align 8
  %1818 = add nsw i64 %1817, -1
  store i64 %1818, ptr %241, align 8
  %1819 = load ptr, ptr %240, align 8
  %1820 = load i64, ptr %1819, align 8
  %1821 = add nsw i64 %1820, -1
  store i64 %1821, ptr %1819, align 8
  store i64 1, ptr %303, align 8
  %1822 = load i64, ptr %355, align 8
  %1823 = sub nsw i64 1, %1822
  store i64 %1823, ptr %245, align 8
  store double 0.000000e+00, ptr %271, align 8
  %1824 = load i64, ptr %242, align 8
  %1825 = add nsw i64 %1824, 1
  store i64 %1825, ptr %242, align 8
  store i64 %1816, ptr %356, align 8
  %1826 = fmul double %404, 2.500000e-01
  br label %1883, !llvm.loop !17

1827:                                             ; preds = %1812
  %1828 = icmp eq i64 %1810, 0
  br i1 %1828, label %1833, label %1829

1829:                                             ; preds = %1827
  %1830 = load ptr, ptr %240, align 8
  %1831 = load i64, ptr %1830, align 8
  %1832 = add nsw i64 %1831, 1
  store i64 %1832, ptr %1830, align 8
  br label %1883

1833:                                             ; preds = %1827, %1616
  br i1 %345, label %1852, label %1834

1834:                                             ; preds = %1852, %1833
  %1835 = load i64, ptr %346, align 8
  %1836 = add nsw i64 %1835, 1
  store i64 %1836, ptr %346, align 8
  %1837 = load ptr, ptr %77, align 8
  %1838 = load ptr, ptr %347, align 8
  %1839 = load ptr, ptr %348, align 8
  store double %405, ptr %1839, align 8
  %1840 = load i64, ptr %349, align 8
  %1841 = icmp sgt i64 %1840, 0
  br i1 %1841, label %1842, label %1843

1842:                                             ; preds = %1834
  tail call fastcc void @sample(ptr noundef nonnull %76) #10
  br label %1843

1843:                                             ; preds = %1834, %1842
  %1844 = load ptr, ptr %76, align 8
  %1845 = load i64, ptr %1844, align 8
  %1846 = load ptr, ptr %348, align 8
  %1847 = load ptr, ptr %350, align 8
  %1848 = load ptr, ptr %351, align 8
  %1849 = inttoptr i64 %1845 to ptr
  %1850 = tail call i32 %1849(ptr noundef %1846, ptr noundef %1837, ptr noundef %1847, ptr noundef %1848, ptr noundef %1838) #11
  %1851 = icmp eq i32 %1850, 0
  br i1 %1851, label %1864, label %1861

1852:                                             ; preds = %1833, %1852
  %1853 = phi i64 [ %1859, %1852 ], [ 0, %1833 ]
  %1854 = load ptr, ptr %309, align 8
  %1855 = getelementptr inbounds double, ptr %1854, i64 %1853
  %1856 = load double, ptr %1855, align 8
  %1857 = load ptr, ptr %77, align 8
  %1858 = getelementptr inbounds double, ptr %1857, i64 %1853
  store double %1856, ptr %1858, align 8
  %1859 = add nuw nsw i64 %1853, 1
  %1860 = icmp eq i64 %1859, %92
  br i1 %1860, label %1834, label %1852, !llvm.loop !49

1861:                                             ; preds = %1843
  store i64 3, ptr %352, align 8
  store double %404, ptr %124, align 8
  %1862 = icmp slt i32 %1850, 0
  %1863 = select i1 %1862, i64 -4, i64 2
  br label %1883

1864:                                             ; preds = %1843
  %1865 = icmp sgt i64 %1139, 2
  %1866 = fcmp ogt double %1137, 1.000000e-03
  %1867 = select i1 %1865, i1 %1866, i1 false
  %1868 = zext i1 %1867 to i64
  store i64 %1868, ptr %245, align 8
  store i64 0, ptr %353, align 8
  store i64 0, ptr %303, align 8
  %1869 = fcmp ule double %1377, 1.000000e+00
  %1870 = fcmp uge double %1377, 1.200000e+00
  %1871 = or i1 %1869, %1870
  %1872 = select i1 %1871, i1 true, i1 %1867
  br i1 %1872, label %1873, label %1877

1873:                                             ; preds = %1864
  %1874 = fcmp ogt double %1377, 2.000000e-01
  %1875 = select i1 %1874, double %1377, double 2.000000e-01
  %1876 = fmul double %404, %1875
  br label %1877

1877:                                             ; preds = %1864, %1873
  %1878 = phi double [ %1876, %1873 ], [ %404, %1864 ]
  %1879 = load i64, ptr %354, align 8
  %1880 = load i64, ptr %95, align 8
  %1881 = icmp eq i64 %1879, %1880
  br i1 %1881, label %1882, label %1883

1882:                                             ; preds = %1877
  store double %1878, ptr %124, align 8
  br label %1883

1883:                                             ; preds = %1179, %1191, %1136, %1330, %1345, %1882, %1877, %1861, %1829, %1815, %1292, %530, %595, %411
  %1884 = phi double [ %373, %411 ], [ %373, %530 ], [ %373, %595 ], [ %1137, %1292 ], [ %1137, %1815 ], [ %1137, %1829 ], [ %1137, %1861 ], [ %1137, %1877 ], [ %1137, %1882 ], [ %1137, %1345 ], [ %1137, %1330 ], [ %1137, %1136 ], [ %1137, %1191 ], [ %1137, %1179 ]
  %1885 = phi i32 [ %372, %411 ], [ %372, %530 ], [ %372, %595 ], [ %1138, %1292 ], [ %1138, %1815 ], [ %1138, %1829 ], [ %1138, %1861 ], [ %1138, %1877 ], [ %1138, %1882 ], [ %1138, %1345 ], [ %1138, %1330 ], [ %1138, %1136 ], [ %1138, %1191 ], [ %1138, %1179 ]
  %1886 = phi i64 [ %371, %411 ], [ %371, %530 ], [ %371, %595 ], [ %1139, %1292 ], [ %1139, %1815 ], [ %1139, %1829 ], [ %1139, %1861 ], [ %1139, %1877 ], [ %1139, %1882 ], [ %1139, %1345 ], [ %1139, %1330 ], [ %1139, %1136 ], [ %1139, %1191 ], [ %1139, %1179 ]
  %1887 = phi i64 [ %370, %411 ], [ %370, %530 ], [ %370, %595 ], [ %1140, %1292 ], [ %1140, %1815 ], [ %1140, %1829 ], [ %1140, %1861 ], [ %1140, %1877 ], [ %1140, %1882 ], [ %1140, %1345 ], [ %1140, %1330 ], [ %1140, %1136 ], [ %1140, %1191 ], [ %1140, %1179 ]
  %1888 = phi double [ %369, %411 ], [ %369, %530 ], [ %598, %595 ], [ %369, %1292 ], [ %1826, %1815 ], [ %369, %1829 ], [ %369, %1861 ], [ %1878, %1877 ], [ %1878, %1882 ], [ %1348, %1345 ], [ %1332, %1330 ], [ %369, %1136 ], [ %1192, %1191 ], [ %369, %1179 ]
  %1889 = phi double [ %368, %411 ], [ %368, %530 ], [ %368, %595 ], [ %368, %1292 ], [ %368, %1815 ], [ %368, %1829 ], [ %405, %1861 ], [ %405, %1877 ], [ %405, %1882 ], [ %368, %1345 ], [ %368, %1330 ], [ %368, %1136 ], [ %368, %1191 ], [ %368, %1179 ]
  %1890 = phi i32 [ 1, %411 ], [ 1, %530 ], [ 6, %595 ], [ 1, %1292 ], [ 6, %1815 ], [ 1, %1829 ], [ 1, %1861 ], [ 0, %1877 ], [ 1, %1882 ], [ 6, %1345 ], [ 6, %1330 ], [ 1, %1136 ], [ 6, %1191 ], [ 6, %1179 ]
  %1891 = phi i64 [ 2, %411 ], [ -4, %530 ], [ %367, %595 ], [ -4, %1292 ], [ %367, %1815 ], [ %1810, %1829 ], [ %1863, %1861 ], [ %367, %1877 ], [ 0, %1882 ], [ %367, %1345 ], [ %367, %1330 ], [ -4, %1136 ], [ %367, %1191 ], [ %367, %1179 ]
  switch i32 %1890, label %1895 [
    i32 0, label %1892
    i32 6, label %1892
  ]

1892:                                             ; preds = %1883, %1883
  %1893 = load i64, ptr %86, align 8
  %1894 = icmp eq i64 %1893, 0
  br i1 %1894, label %363, label %365, !llvm.loop !17

1895:                                             ; preds = %1883, %161, %363, %386, %394, %203, %75
  %1896 = phi i64 [ -1, %75 ], [ %164, %161 ], [ -1, %363 ], [ -5, %386 ], [ 1, %394 ], [ 0, %203 ], [ %1891, %1883 ]
  ret i64 %1896
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
  br i1 %55, label %44, label %56, !llvm.loop !50

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
  br i1 %83, label %13, label %12, !llvm.loop !51
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
  br i1 %41, label %13, label %18, !llvm.loop !52
}

declare double @llvm.fabs.f64(double) #2

define internal fastcc i32 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #5 {
  %4 = icmp slt i64 %1, 1
  br i1 %4, label %76, label %8

5:                                                ; preds = %73, %50
  %6 = icmp sge i64 %16, %1
  %7 = icmp eq i64 %16, %1
  br i1 %7, label %76, label %8, !llvm.loop !53

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
  br i1 %36, label %24, label %19, !llvm.loop !54

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
  br i1 %49, label %50, label %42, !llvm.loop !55

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
  br i1 %72, label %63, label %73, !llvm.loop !56

73:                                               ; preds = %63, %54
  %74 = add nuw nsw i64 %55, 1
  %75 = icmp slt i64 %74, %1
  br i1 %75, label %54, label %5, !llvm.loop !57

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
  br i1 %7, label %127, label %8, !llvm.loop !58

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
  br i1 %40, label %26, label %21, !llvm.loop !59

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
  br i1 %57, label %58, label %46, !llvm.loop !60

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
  br i1 %123, label %104, label %124, !llvm.loop !61

124:                                              ; preds = %104, %86
  %125 = add nuw nsw i64 %87, 1
  %126 = icmp slt i64 %125, %1
  br i1 %126, label %86, label %5, !llvm.loop !62

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
  br i1 %19, label %6, label %8, !llvm.loop !63

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
  br i1 %35, label %20, label %24, !llvm.loop !64

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
  br i1 %46, label %32, label %36, !llvm.loop !65

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
  br i1 %63, label %48, label %47, !llvm.loop !66

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
  br i1 %74, label %57, label %64, !llvm.loop !67
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
  br i1 %24, label %6, label %8, !llvm.loop !68

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
  br i1 %43, label %25, label %29, !llvm.loop !69

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
  br i1 %65, label %39, label %44, !llvm.loop !70

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
  br i1 %112, label %67, label %66, !llvm.loop !71

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
  br i1 %134, label %78, label %113, !llvm.loop !72
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
  br i1 %37, label %38, label %23, !llvm.loop !73

38:                                               ; preds = %23, %14
  %39 = add nuw nsw i64 %15, 1
  %40 = icmp eq i64 %39, %1
  br i1 %40, label %10, label %14, !llvm.loop !74

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
  br i1 %57, label %49, label %41, !llvm.loop !75

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
  br i1 %73, label %74, label %64, !llvm.loop !76

74:                                               ; preds = %64, %58
  %75 = add nuw nsw i64 %59, 1
  %76 = icmp eq i64 %75, %42
  br i1 %76, label %55, label %58, !llvm.loop !77

77:                                               ; preds = %116, %89
  %78 = icmp sgt i64 %80, 1
  br i1 %78, label %79, label %88, !llvm.loop !78

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
  br i1 %112, label %113, label %103, !llvm.loop !76

113:                                              ; preds = %103, %97
  %114 = add nuw nsw i64 %98, 1
  %115 = icmp eq i64 %114, %1
  br i1 %115, label %89, label %97, !llvm.loop !79

116:                                              ; preds = %94, %116
  %117 = phi i64 [ 0, %94 ], [ %121, %116 ]
  %118 = getelementptr double, ptr %96, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fmul double %93, %119
  store double %120, ptr %118, align 8
  %121 = add nuw nsw i64 %117, 1
  %122 = icmp eq i64 %121, %4
  br i1 %122, label %77, label %116, !llvm.loop !80
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
  br i1 %42, label %43, label %23, !llvm.loop !81

43:                                               ; preds = %23, %14
  %44 = add nuw nsw i64 %15, 1
  %45 = icmp eq i64 %44, %1
  br i1 %45, label %10, label %14, !llvm.loop !82

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
  br i1 %62, label %54, label %46, !llvm.loop !83

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
  br i1 %90, label %91, label %71, !llvm.loop !84

91:                                               ; preds = %71, %63
  %92 = add nuw nsw i64 %64, 1
  %93 = icmp eq i64 %92, %47
  br i1 %93, label %60, label %63, !llvm.loop !85

94:                                               ; preds = %170, %133
  %95 = icmp sgt i64 %97, 1
  br i1 %95, label %96, label %105, !llvm.loop !86

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
  br i1 %166, label %167, label %147, !llvm.loop !84

167:                                              ; preds = %147, %139
  %168 = add nuw nsw i64 %140, 1
  %169 = icmp eq i64 %168, %1
  br i1 %169, label %106, label %139, !llvm.loop !87

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
  br i1 %183, label %94, label %170, !llvm.loop !88
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
  br i1 %31, label %20, label %19, !llvm.loop !89

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
  br i1 %43, label %32, label %24, !llvm.loop !90
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
