; sources 7e045d56d242161b5aaa239a6996b4e1ce82b574c695223241f21f9cdfb2fbca
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@NODES = internal unnamed_addr constant [3 x double] [double 0x3FC3D8B64657CAEA, double 0x3FE4A36C0803A6DF, double 1.000000e+00], align 16
@TO_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x4010B70201A79C46, double 0x3FD4F8C15DA84E86, double 0x3FE0BF7FF59D56EF], [3 x double] [double 0xC010B70201A79C46, double 0xBFD4F8C15DA84E86, double 0x3FDE810014C55221], [3 x double] [double 0x3FE017885A24A7F2, double 0xC004934E6FCAA598, double 0x3FE312C0CF7BDFD1]], align 16
@FROM_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x3FB82D23845D677B, double 0xBFC214A74C403BF7, double 0x3F9EBFF91A6D688E], [3 x double] [double 0x3FD0037DE70AA1ED, double 0x3FCA20E91E20B551, double 0xBFD8821FA2A36DED], [3 x double] [double 1.000000e+00, double 1.000000e+00, double 0.000000e+00]], align 16
@POLYNOMIAL = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x402418FD8BAFFE05, double 0xC039A12CE7B30915, double 0x402F295C43B61425], [3 x double] [double 0xBFF61D41B2D54580, double 0x402497AF24BB677E, double 0xC021D406EE60BECF], [3 x double] [double 0x3FD5555555555555, double 0xC005555555555555, double 0x400AAAAAAAAAAAAB]], align 16
@scan_points = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes_implicit(ptr noundef %0) #0 {
  %2 = alloca [3 x double], align 16
  %3 = alloca [3 x double], align 16
  %4 = alloca [64 x double], align 16
  %5 = alloca [64 x double], align 16
  %6 = alloca [64 x double], align 16
  %7 = alloca [64 x double], align 16
  %8 = alloca [8 x double], align 16
  %9 = alloca [8 x double], align 16
  %10 = alloca [3 x <8 x double>], align 64
  %11 = alloca %struct.Stepper, align 8
  %12 = alloca [8 x double], align 16
  %13 = alloca [8 x double], align 16
  %14 = alloca [8 x double], align 16
  %15 = alloca i64, align 8
  %16 = alloca [8 x i64], align 16
  %17 = alloca i64, align 8
  store ptr %0, ptr %11, align 8
  %18 = getelementptr inbounds i8, ptr %11, i64 8
  %19 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %19, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %11, i64 16
  %21 = getelementptr inbounds i8, ptr %0, i64 432
  store ptr %21, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %0, i64 984
  %23 = load ptr, ptr %19, align 8
  %24 = getelementptr inbounds i8, ptr %23, i64 8
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 1032
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %0, i64 1040
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr double, ptr %27, i64 %29
  %31 = getelementptr i8, ptr %30, i64 -16
  %32 = load double, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 1008
  %34 = load ptr, ptr %33, align 8
  %35 = load double, ptr %34, align 8
  %36 = load ptr, ptr %22, align 8
  %37 = getelementptr inbounds i8, ptr %36, i64 16
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %0, i64 1680
  %40 = load ptr, ptr %39, align 8
  %41 = load i64, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %0, i64 1272
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %43, i64 8
  %45 = load i64, ptr %44, align 8
  store i64 0, ptr %15, align 8
  %46 = getelementptr inbounds i8, ptr %0, i64 936
  %47 = load ptr, ptr %46, align 8
  br label %149

48:                                               ; preds = %149
  %49 = getelementptr inbounds i8, ptr %0, i64 696
  %50 = sitofp i64 %38 to double
  %51 = icmp eq i64 %41, 1
  %52 = icmp sgt i64 %45, 0
  store i64 %157, ptr %15, align 8
  %53 = getelementptr inbounds i8, ptr %0, i64 936
  %54 = getelementptr inbounds i8, ptr %0, i64 1592
  %55 = getelementptr inbounds i8, ptr %0, i64 1224
  %56 = insertelement <8 x double> poison, double %32, i64 0
  %57 = shufflevector <8 x double> %56, <8 x double> poison, <8 x i32> zeroinitializer
  %58 = getelementptr inbounds i8, ptr %0, i64 720
  %59 = insertelement <8 x double> poison, double %35, i64 0
  %60 = shufflevector <8 x double> %59, <8 x double> poison, <8 x i32> zeroinitializer
  %61 = getelementptr inbounds i8, ptr %0, i64 840
  %62 = getelementptr inbounds i8, ptr %0, i64 864
  %63 = insertelement <8 x double> poison, double %50, i64 0
  %64 = shufflevector <8 x double> %63, <8 x double> poison, <8 x i32> zeroinitializer
  %65 = getelementptr inbounds i8, ptr %0, i64 1752
  %66 = getelementptr inbounds i8, ptr %0, i64 648
  %67 = getelementptr inbounds i8, ptr %0, i64 1824
  %68 = getelementptr inbounds i8, ptr %0, i64 1848
  %69 = getelementptr inbounds i8, ptr %0, i64 168
  %70 = getelementptr inbounds i8, ptr %0, i64 296
  %71 = getelementptr inbounds i8, ptr %0, i64 192
  %72 = getelementptr inbounds i8, ptr %0, i64 1800
  %73 = getelementptr inbounds i8, ptr %0, i64 1832
  %74 = getelementptr inbounds i8, ptr %0, i64 1776
  %75 = getelementptr inbounds i8, ptr %0, i64 1928
  %76 = getelementptr inbounds i8, ptr %0, i64 1872
  %77 = getelementptr inbounds i8, ptr %0, i64 1896
  %78 = getelementptr inbounds i8, ptr %0, i64 1824
  %79 = getelementptr inbounds i8, ptr %0, i64 1920
  %80 = getelementptr inbounds i8, ptr %0, i64 1944
  %81 = getelementptr inbounds i8, ptr %0, i64 2040
  %82 = getelementptr inbounds i8, ptr %0, i64 1968
  %83 = getelementptr inbounds i8, ptr %0, i64 1992
  %84 = getelementptr inbounds i8, ptr %0, i64 480
  %85 = getelementptr inbounds i8, ptr %0, i64 2016
  %86 = getelementptr inbounds i8, ptr %0, i64 480
  %87 = getelementptr inbounds i8, ptr %0, i64 168
  %88 = getelementptr inbounds i8, ptr %0, i64 296
  %89 = getelementptr inbounds i8, ptr %0, i64 192
  %90 = getelementptr inbounds i8, ptr %0, i64 240
  %91 = getelementptr inbounds i8, ptr %0, i64 2016
  %92 = getelementptr inbounds i8, ptr %0, i64 2064
  %93 = getelementptr inbounds i8, ptr %0, i64 2088
  %94 = getelementptr inbounds i8, ptr %0, i64 672
  %95 = getelementptr inbounds i8, ptr %0, i64 1920
  %96 = getelementptr inbounds i8, ptr %0, i64 1928
  %97 = getelementptr inbounds i8, ptr %0, i64 2064
  %98 = getelementptr inbounds i8, ptr %0, i64 2088
  %99 = getelementptr inbounds i8, ptr %0, i64 1872
  %100 = getelementptr inbounds i8, ptr %0, i64 1896
  %101 = getelementptr inbounds i8, ptr %0, i64 1944
  %102 = getelementptr inbounds i8, ptr %0, i64 672
  %103 = getelementptr inbounds i8, ptr %10, i64 64
  %104 = getelementptr inbounds i8, ptr %10, i64 128
  %105 = getelementptr inbounds i8, ptr %0, i64 1832
  %106 = getelementptr inbounds i8, ptr %0, i64 1824
  %107 = getelementptr inbounds i8, ptr %0, i64 456
  %108 = getelementptr inbounds i8, ptr %0, i64 2112
  %109 = getelementptr inbounds i8, ptr %0, i64 2064
  %110 = getelementptr inbounds i8, ptr %0, i64 600
  %111 = getelementptr inbounds i8, ptr %0, i64 1920
  %112 = getelementptr inbounds i8, ptr %0, i64 1928
  %113 = getelementptr inbounds i8, ptr %0, i64 1872
  %114 = getelementptr inbounds i8, ptr %0, i64 456
  %115 = getelementptr inbounds i8, ptr %0, i64 672
  %116 = getelementptr inbounds i8, ptr %0, i64 480
  %117 = getelementptr inbounds i8, ptr %0, i64 480
  %118 = getelementptr inbounds i8, ptr %0, i64 2016
  %119 = getelementptr inbounds i8, ptr %0, i64 168
  %120 = getelementptr inbounds i8, ptr %0, i64 296
  %121 = getelementptr inbounds i8, ptr %0, i64 192
  %122 = getelementptr inbounds i8, ptr %0, i64 240
  %123 = getelementptr inbounds i8, ptr %0, i64 672
  %124 = getelementptr inbounds i8, ptr %0, i64 888
  %125 = getelementptr inbounds i8, ptr %0, i64 456
  %126 = getelementptr inbounds i8, ptr %0, i64 440
  %127 = getelementptr inbounds i8, ptr %0, i64 1968
  %128 = getelementptr inbounds i8, ptr %0, i64 624
  %129 = getelementptr inbounds i8, ptr %0, i64 2040
  %130 = getelementptr inbounds i8, ptr %0, i64 1776
  %131 = getelementptr inbounds i8, ptr %2, i64 8
  %132 = getelementptr inbounds i8, ptr %2, i64 16
  %133 = getelementptr inbounds i8, ptr %3, i64 8
  %134 = getelementptr inbounds i8, ptr %3, i64 16
  %135 = getelementptr inbounds i8, ptr %0, i64 456
  %136 = getelementptr inbounds i8, ptr %0, i64 816
  %137 = getelementptr inbounds i8, ptr %0, i64 456
  %138 = getelementptr inbounds i8, ptr %0, i64 912
  %139 = icmp sgt i64 %25, 0
  %140 = getelementptr inbounds i8, ptr %0, i64 456
  br label %141

141:                                              ; preds = %2046, %48
  %142 = phi i64 [ %1706, %2046 ], [ undef, %48 ]
  %143 = phi i64 [ %1707, %2046 ], [ undef, %48 ]
  %144 = phi <8 x double> [ %1708, %2046 ], [ undef, %48 ]
  %145 = phi <8 x double> [ %1709, %2046 ], [ undef, %48 ]
  %146 = phi <8 x double> [ %1710, %2046 ], [ undef, %48 ]
  %147 = phi i32 [ %2047, %2046 ], [ 1, %48 ]
  %148 = phi i64 [ %2022, %2046 ], [ 0, %48 ]
  br label %160

149:                                              ; preds = %1, %149
  %150 = phi i64 [ 0, %1 ], [ %158, %149 ]
  %151 = phi i64 [ 0, %1 ], [ %157, %149 ]
  %152 = getelementptr inbounds i64, ptr %47, i64 %150
  %153 = load i64, ptr %152, align 8
  %154 = icmp sgt i64 %153, -1
  %155 = zext i1 %154 to i64
  %156 = shl nuw nsw i64 %155, %150
  %157 = or i64 %156, %151
  %158 = add nuw nsw i64 %150, 1
  %159 = icmp eq i64 %158, 8
  br i1 %159, label %48, label %149, !llvm.loop !3

160:                                              ; preds = %141, %264
  %161 = phi i32 [ 1, %264 ], [ %147, %141 ]
  %162 = phi i64 [ %200, %264 ], [ %148, %141 ]
  br label %163

163:                                              ; preds = %194, %160
  %164 = phi i32 [ %161, %160 ], [ %196, %194 ]
  %165 = phi i64 [ %162, %160 ], [ %197, %194 ]
  %166 = icmp ne i32 %164, 0
  %167 = icmp ne i64 %165, 0
  %168 = select i1 %166, i1 true, i1 %167
  br i1 %168, label %169, label %198

169:                                              ; preds = %163
  br i1 %166, label %170, label %172

170:                                              ; preds = %169
  %171 = call fastcc i64 @fill(ptr noundef %0, ptr noundef nonnull %15) #11
  br label %172

172:                                              ; preds = %169, %170
  %173 = phi i64 [ %171, %170 ], [ 0, %169 ]
  %174 = load i64, ptr %15, align 8
  %175 = icmp eq i64 %174, 0
  br i1 %175, label %194, label %176

176:                                              ; preds = %172
  %177 = or i64 %173, %165
  %178 = icmp eq i64 %177, 0
  br i1 %178, label %194, label %179

179:                                              ; preds = %176
  call fastcc void @start(ptr noundef %0, ptr noundef nonnull %11, i64 noundef %173, i64 noundef %165) #11
  br label %180

180:                                              ; preds = %179, %189
  %181 = phi i32 [ 0, %179 ], [ %191, %189 ]
  %182 = phi i64 [ 0, %179 ], [ %192, %189 ]
  %183 = icmp eq i32 %181, 0
  br i1 %183, label %184, label %189

184:                                              ; preds = %180
  %185 = load ptr, ptr %53, align 8
  %186 = getelementptr inbounds i64, ptr %185, i64 %182
  %187 = load i64, ptr %186, align 8
  %188 = icmp eq i64 %187, -1
  br label %189

189:                                              ; preds = %184, %180
  %190 = phi i1 [ true, %180 ], [ %188, %184 ]
  %191 = zext i1 %190 to i32
  %192 = add nuw nsw i64 %182, 1
  %193 = icmp eq i64 %192, 8
  br i1 %193, label %194, label %180, !llvm.loop !6

194:                                              ; preds = %189, %176, %172
  %195 = phi i32 [ 1, %172 ], [ 8, %176 ], [ 0, %189 ]
  %196 = phi i32 [ %164, %172 ], [ 0, %176 ], [ %191, %189 ]
  %197 = phi i64 [ %165, %172 ], [ %165, %176 ], [ 0, %189 ]
  switch i32 %195, label %2048 [
    i32 0, label %163
    i32 8, label %198
  ], !llvm.loop !7

198:                                              ; preds = %194, %163
  %199 = phi i32 [ %196, %194 ], [ 0, %163 ]
  %200 = phi i64 [ %197, %194 ], [ 0, %163 ]
  %201 = load ptr, ptr %22, align 8
  %202 = getelementptr inbounds i8, ptr %201, i64 8
  %203 = load i64, ptr %202, align 8
  %204 = icmp slt i64 %203, 1
  br i1 %204, label %2048, label %205

205:                                              ; preds = %198
  br i1 %52, label %206, label %226

206:                                              ; preds = %205
  %207 = load i64, ptr %54, align 8
  %208 = icmp sgt i64 %207, 0
  br i1 %208, label %209, label %223

209:                                              ; preds = %206
  %210 = load ptr, ptr %42, align 8
  %211 = getelementptr inbounds i8, ptr %210, i64 72
  %212 = load i64, ptr %211, align 8
  %213 = load ptr, ptr %55, align 8
  %214 = load i64, ptr %213, align 8
  %215 = inttoptr i64 %214 to ptr
  %216 = getelementptr inbounds i8, ptr %215, i64 1064
  %217 = load i64, ptr %216, align 8
  %218 = shl i64 %217, 4
  %219 = add i64 %212, 16
  %220 = add i64 %219, %218
  %221 = icmp sgt i64 %220, %207
  %222 = zext i1 %221 to i32
  br label %223

223:                                              ; preds = %206, %209
  %224 = phi i32 [ 0, %206 ], [ %222, %209 ]
  %225 = icmp eq i32 %224, 0
  br i1 %225, label %226, label %2048

226:                                              ; preds = %223, %205
  %227 = add nsw i64 %203, -1
  store i64 %227, ptr %202, align 8
  %228 = load i64, ptr %15, align 8
  %229 = trunc i64 %228 to i8
  %230 = bitcast i8 %229 to <8 x i1>
  %231 = load ptr, ptr %49, align 8
  %232 = load <8 x double>, ptr %231, align 8
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %14) #11
  %233 = load <8 x double>, ptr %14, align 16
  %234 = fcmp olt <8 x double> %57, %233
  %235 = select <8 x i1> %234, <8 x double> %57, <8 x double> %233
  %236 = load ptr, ptr %58, align 8
  %237 = load <8 x double>, ptr %236, align 8
  %238 = fcmp olt <8 x double> %237, %60
  %239 = select <8 x i1> %238, <8 x double> %237, <8 x double> %60
  %240 = fadd <8 x double> %232, %239
  %241 = fmul <8 x double> %239, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %242 = fsub <8 x double> %235, %241
  %243 = fcmp ogt <8 x double> %240, %242
  %244 = select <8 x i1> %243, <8 x double> %235, <8 x double> %240
  %245 = fsub <8 x double> %244, %232
  %246 = bitcast <8 x double> %245 to <8 x i64>
  %247 = select <8 x i1> %230, <8 x i64> %246, <8 x i64> zeroinitializer
  %248 = bitcast <8 x i64> %247 to <8 x double>
  %249 = load ptr, ptr %61, align 8
  %250 = load <8 x double>, ptr %249, align 8
  %251 = load ptr, ptr %62, align 8
  %252 = load <8 x double>, ptr %251, align 8
  %253 = fadd <8 x double> %250, %252
  %254 = fcmp oge <8 x double> %253, %64
  %255 = fmul <8 x double> %248, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %256 = fadd <8 x double> %232, %255
  %257 = fcmp ule <8 x double> %256, %232
  %258 = fcmp une <8 x double> %244, %235
  %259 = and <8 x i1> %257, %258
  %260 = or <8 x i1> %259, %254
  %261 = and <8 x i1> %260, %230
  %262 = bitcast <8 x i1> %261 to i8
  %263 = icmp eq i8 %262, 0
  br i1 %263, label %271, label %264

264:                                              ; preds = %226
  %265 = zext i8 %262 to i64
  %266 = bitcast <8 x i1> %254 to i8
  %267 = zext i8 %266 to i64
  %268 = and i64 %265, %267
  call fastcc void @retire(ptr noundef %0, i64 noundef %268, i64 noundef 1) #11
  %269 = xor i64 %267, -1
  %270 = and i64 %265, %269
  call fastcc void @retire(ptr noundef %0, i64 noundef %270, i64 noundef -1) #11
  br label %160, !llvm.loop !8

271:                                              ; preds = %226
  %272 = load ptr, ptr %26, align 8, !noalias !9
  %273 = load i64, ptr %28, align 8, !noalias !9
  %274 = getelementptr double, ptr %272, i64 %273
  %275 = getelementptr i8, ptr %274, i64 -16
  %276 = load double, ptr %275, align 8, !noalias !9
  %277 = load double, ptr %272, align 8, !noalias !9
  %278 = fsub double %276, %277
  %279 = fmul double %278, 0x3D70000000000000
  %280 = load ptr, ptr %66, align 8, !noalias !14
  %281 = load double, ptr %280, align 8, !noalias !14
  %282 = load ptr, ptr %19, align 8, !noalias !17
  %283 = getelementptr inbounds i8, ptr %282, i64 8
  %284 = load i64, ptr %283, align 8, !noalias !17
  %285 = icmp sgt i64 %284, 0
  br i1 %285, label %286, label %295

286:                                              ; preds = %271, %286
  %287 = phi i64 [ %293, %286 ], [ 0, %271 ]
  %288 = phi double [ %292, %286 ], [ %281, %271 ]
  %289 = getelementptr inbounds double, ptr %280, i64 %287
  %290 = load double, ptr %289, align 8, !noalias !14
  %291 = fcmp olt double %290, %288
  %292 = select i1 %291, double %290, double %288
  %293 = add nuw nsw i64 %287, 1
  %294 = icmp eq i64 %293, %284
  br i1 %294, label %295, label %286, !llvm.loop !18

295:                                              ; preds = %286, %271
  %296 = phi double [ %281, %271 ], [ %292, %286 ]
  %297 = load ptr, ptr %65, align 8, !noalias !19
  %298 = getelementptr inbounds i8, ptr %297, i64 8
  %299 = load i64, ptr %298, align 8, !noalias !19
  %300 = and i64 %299, %228
  %301 = icmp eq i64 %300, 0
  br i1 %301, label %365, label %302

302:                                              ; preds = %295
  %303 = load i64, ptr %297, align 8, !noalias !19
  %304 = icmp eq i64 %303, 0
  br i1 %304, label %328, label %305

305:                                              ; preds = %302
  %306 = load ptr, ptr %68, align 8, !noalias !19
  %307 = load ptr, ptr %69, align 8, !noalias !19
  store <8 x double> %232, ptr %307, align 8, !noalias !19
  %308 = load ptr, ptr %19, align 8, !noalias !19
  %309 = getelementptr inbounds i8, ptr %308, i64 40
  %310 = load i64, ptr %309, align 8, !noalias !19
  %311 = icmp eq i64 %310, 0
  br i1 %311, label %313, label %312

312:                                              ; preds = %305
  call fastcc void @settle(ptr noundef nonnull %19) #11, !noalias !19
  br label %313

313:                                              ; preds = %312, %305
  %314 = load i64, ptr %70, align 8, !noalias !19
  %315 = icmp sgt i64 %314, 0
  br i1 %315, label %316, label %317

316:                                              ; preds = %313
  call fastcc void @sample(ptr noundef nonnull %19) #11, !noalias !19
  br label %317

317:                                              ; preds = %316, %313
  %318 = load ptr, ptr %65, align 8, !noalias !19
  %319 = load i64, ptr %318, align 8, !noalias !19
  %320 = load ptr, ptr %69, align 8, !noalias !19
  %321 = load ptr, ptr %21, align 8, !noalias !19
  %322 = load ptr, ptr %71, align 8, !noalias !19
  %323 = load ptr, ptr %72, align 8, !noalias !19
  %324 = inttoptr i64 %319 to ptr
  %325 = load ptr, ptr %324, align 8, !noalias !19
  %326 = call i32 %325(ptr noundef %320, ptr noundef %321, ptr noundef %322, ptr noundef %323, ptr noundef %306) #12, !noalias !19
  %327 = sext i32 %326 to i64
  br label %328

328:                                              ; preds = %302, %317
  %329 = phi i64 [ %327, %317 ], [ 0, %302 ]
  %330 = load i64, ptr %73, align 8, !noalias !19
  %331 = icmp sgt i64 %330, 7
  br i1 %331, label %332, label %353

332:                                              ; preds = %328
  %333 = trunc i64 %300 to i8
  %334 = bitcast i8 %333 to <8 x i1>
  br label %335

335:                                              ; preds = %332, %335
  %336 = phi i64 [ 0, %332 ], [ %349, %335 ]
  %337 = load ptr, ptr %68, align 8, !noalias !19
  %338 = shl nsw i64 %336, 6
  %339 = getelementptr inbounds i8, ptr %337, i64 %338
  %340 = load <8 x double>, ptr %339, align 8, !noalias !19
  %341 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %340)
  %342 = fcmp one <8 x double> %341, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %343 = bitcast <8 x double> %340 to <8 x i64>
  %344 = select <8 x i1> %342, <8 x i64> %343, <8 x i64> zeroinitializer
  %345 = load ptr, ptr %67, align 8, !noalias !19
  %346 = getelementptr inbounds i8, ptr %345, i64 %338
  %347 = load <8 x i64>, ptr %346, align 8, !noalias !19
  %348 = select <8 x i1> %334, <8 x i64> %344, <8 x i64> %347
  store <8 x i64> %348, ptr %346, align 8, !noalias !19
  %349 = add nuw nsw i64 %336, 1
  %350 = load i64, ptr %73, align 8, !noalias !19
  %351 = sdiv i64 %350, 8
  %352 = icmp slt i64 %349, %351
  br i1 %352, label %335, label %353, !llvm.loop !22

353:                                              ; preds = %335, %328
  %354 = icmp slt i64 %329, 0
  br i1 %354, label %1705, label %355

355:                                              ; preds = %353
  %356 = xor i64 %300, -1
  %357 = load i64, ptr %298, align 8, !noalias !19
  %358 = and i64 %357, %356
  store i64 %358, ptr %298, align 8, !noalias !19
  %359 = getelementptr inbounds i8, ptr %297, i64 16
  %360 = load i64, ptr %359, align 8, !noalias !19
  %361 = or i64 %360, %300
  store i64 %361, ptr %359, align 8, !noalias !19
  %362 = getelementptr inbounds i8, ptr %297, i64 24
  %363 = load i64, ptr %362, align 8, !noalias !19
  %364 = and i64 %363, %356
  store i64 %364, ptr %362, align 8, !noalias !19
  br label %365

365:                                              ; preds = %355, %295
  %366 = load ptr, ptr %65, align 8, !noalias !19
  %367 = load ptr, ptr %74, align 8, !noalias !19
  %368 = load <8 x double>, ptr %367, align 8, !noalias !19
  %369 = fsub <8 x double> %248, %368
  %370 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %369)
  %371 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %244)
  %372 = fmul <8 x double> %371, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %373 = fcmp ogt <8 x double> %370, %372
  %374 = bitcast <8 x i1> %373 to i8
  %375 = zext i8 %374 to i64
  %376 = getelementptr inbounds i8, ptr %366, i64 24
  %377 = load i64, ptr %376, align 8, !noalias !19
  %378 = xor i64 %377, -1
  %379 = or i64 %375, %378
  %380 = and i64 %379, %228
  %381 = icmp eq i64 %380, 0
  br i1 %381, label %451, label %382

382:                                              ; preds = %365
  %383 = trunc i64 %380 to i8
  %384 = bitcast i8 %383 to <8 x i1>
  %385 = bitcast <8 x double> %368 to <8 x i64>
  %386 = select <8 x i1> %384, <8 x i64> %247, <8 x i64> %385
  store <8 x i64> %386, ptr %367, align 8, !noalias !19
  %387 = load i64, ptr %75, align 8, !noalias !19
  %388 = sdiv i64 %387, 8
  %389 = load ptr, ptr %76, align 8, !noalias !19
  %390 = load ptr, ptr %77, align 8, !noalias !19
  %391 = icmp sgt i64 %387, 7
  br i1 %391, label %392, label %425

392:                                              ; preds = %382
  %393 = bitcast <8 x i64> %386 to <8 x double>
  %394 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %393
  %395 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %393
  %396 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %393
  br label %397

397:                                              ; preds = %392, %400
  %398 = phi i64 [ 0, %392 ], [ %401, %400 ]
  %399 = mul nuw nsw i64 %398, %388
  br label %403

400:                                              ; preds = %403
  %401 = add nuw nsw i64 %398, 1
  %402 = icmp eq i64 %401, %388
  br i1 %402, label %425, label %397, !llvm.loop !23

403:                                              ; preds = %397, %403
  %404 = phi i64 [ 0, %397 ], [ %423, %403 ]
  %405 = load ptr, ptr %78, align 8, !noalias !19
  %406 = add nuw nsw i64 %404, %399
  %407 = shl nsw i64 %406, 6
  %408 = getelementptr inbounds i8, ptr %405, i64 %407
  %409 = load <8 x double>, ptr %408, align 8, !noalias !19
  %410 = fneg <8 x double> %409
  %411 = icmp eq i64 %398, %404
  %412 = fsub <8 x double> %394, %409
  %413 = select i1 %411, <8 x double> %412, <8 x double> %410
  %414 = fsub <8 x double> %395, %409
  %415 = select i1 %411, <8 x double> %414, <8 x double> %410
  %416 = getelementptr inbounds i8, ptr %389, i64 %407
  store <8 x double> %413, ptr %416, align 8, !noalias !19
  %417 = select i1 %411, <8 x double> %396, <8 x double> zeroinitializer
  %418 = shl i64 %406, 7
  %419 = shl nsw i64 %406, 7
  %420 = getelementptr inbounds i8, ptr %390, i64 %419
  store <8 x double> %415, ptr %420, align 8, !noalias !19
  %421 = or disjoint i64 %418, 64
  %422 = getelementptr inbounds i8, ptr %390, i64 %421
  store <8 x double> %417, ptr %422, align 8, !noalias !19
  %423 = add nuw nsw i64 %404, 1
  %424 = icmp eq i64 %423, %388
  br i1 %424, label %400, label %403, !llvm.loop !24

425:                                              ; preds = %400, %382
  %426 = load ptr, ptr %79, align 8, !noalias !19
  %427 = call fastcc i64 @real_factorise(ptr noundef %389, i64 noundef %388, ptr noundef %426) #11, !noalias !19
  %428 = load ptr, ptr %80, align 8, !noalias !19
  %429 = call fastcc i64 @pair_factorise(ptr noundef %390, i64 noundef %388, ptr noundef %428) #11, !noalias !19
  %430 = or i64 %429, %427
  %431 = and i64 %430, %380
  %432 = load i64, ptr %376, align 8, !noalias !19
  %433 = or i64 %432, %380
  %434 = xor i64 %431, -1
  %435 = xor i64 %431, %433
  store i64 %435, ptr %376, align 8, !noalias !19
  %436 = trunc nuw i64 %431 to i8
  %437 = bitcast i8 %436 to <8 x i1>
  %438 = select <8 x i1> %437, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>, <8 x double> <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %439 = fmul <8 x double> %248, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %440 = select <8 x i1> %437, <8 x double> %439, <8 x double> %237
  %441 = load ptr, ptr %65, align 8, !noalias !19
  %442 = getelementptr inbounds i8, ptr %441, i64 8
  %443 = load i64, ptr %442, align 8, !noalias !19
  %444 = and i64 %443, %434
  %445 = getelementptr inbounds i8, ptr %441, i64 16
  %446 = load i64, ptr %445, align 8, !noalias !19
  %447 = xor i64 %446, -1
  %448 = and i64 %431, %447
  %449 = or disjoint i64 %448, %444
  store i64 %449, ptr %442, align 8, !noalias !19
  %450 = xor i64 %431, %228
  br label %451

451:                                              ; preds = %365, %425
  %452 = phi <8 x double> [ %237, %365 ], [ %440, %425 ]
  %453 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %365 ], [ %438, %425 ]
  %454 = phi i64 [ %228, %365 ], [ %450, %425 ]
  %455 = icmp eq i64 %454, 0
  br i1 %455, label %1705, label %456

456:                                              ; preds = %451
  %457 = fcmp ogt double %296, 0x3CB0000000000000
  %458 = select i1 %457, double %296, double 0x3CB0000000000000
  %459 = fdiv double 0x3CE4000000000000, %458
  %460 = call double @llvm.sqrt.f64(double %296)
  %461 = fcmp olt double %460, 3.000000e-02
  %462 = select i1 %461, double %460, double 3.000000e-02
  %463 = fcmp ogt double %462, %459
  %464 = load ptr, ptr %74, align 8, !noalias !19
  %465 = getelementptr inbounds i8, ptr %464, i64 64
  %466 = load <8 x double>, ptr %465, align 8, !noalias !19
  %467 = load ptr, ptr %19, align 8, !noalias !19
  %468 = getelementptr inbounds i8, ptr %467, i64 8
  %469 = load i64, ptr %468, align 8, !noalias !19
  %470 = load ptr, ptr %81, align 8, !noalias !19
  %471 = load ptr, ptr %21, align 8, !noalias !19
  %472 = load ptr, ptr %82, align 8, !noalias !19
  %473 = load ptr, ptr %83, align 8, !noalias !19
  %474 = fcmp ogt <8 x double> %466, zeroinitializer
  %475 = icmp sgt i64 %469, 0
  %476 = shl i64 %469, 7
  %477 = getelementptr i8, ptr %470, i64 %476
  %478 = mul nsw i64 %469, 3
  br label %483

479:                                              ; preds = %495
  %480 = icmp sgt i64 %469, 0
  %481 = shl i64 %469, 7
  %482 = getelementptr i8, ptr %472, i64 %481
  br label %529

483:                                              ; preds = %456, %495
  %484 = phi i64 [ 0, %456 ], [ %496, %495 ]
  %485 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %484
  %486 = load double, ptr %485, align 8, !noalias !19
  %487 = insertelement <8 x double> poison, double %486, i64 0
  %488 = shufflevector <8 x double> %487, <8 x double> poison, <8 x i32> zeroinitializer
  %489 = fmul <8 x double> %488, %248
  %490 = fdiv <8 x double> %489, %466
  %491 = fadd <8 x double> %490, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  br i1 %475, label %492, label %495

492:                                              ; preds = %483
  %493 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %491
  %494 = mul nuw nsw i64 %469, %484
  br label %498

495:                                              ; preds = %498, %483
  %496 = add nuw nsw i64 %484, 1
  %497 = icmp eq i64 %496, 3
  br i1 %497, label %479, label %483, !llvm.loop !25

498:                                              ; preds = %492, %498
  %499 = phi i64 [ 0, %492 ], [ %527, %498 ]
  %500 = shl i64 %499, 6
  %501 = getelementptr i8, ptr %477, i64 %500
  %502 = load <8 x double>, ptr %501, align 8, !noalias !19
  %503 = add nuw nsw i64 %499, %478
  %504 = shl nsw i64 %503, 6
  %505 = getelementptr inbounds i8, ptr %470, i64 %504
  %506 = load <8 x double>, ptr %505, align 8, !noalias !19
  %507 = fmul <8 x double> %491, %506
  %508 = fadd <8 x double> %502, %507
  %509 = fmul <8 x double> %493, %508
  %510 = shl nsw i64 %499, 6
  %511 = getelementptr inbounds i8, ptr %470, i64 %510
  %512 = load <8 x double>, ptr %511, align 8, !noalias !19
  %513 = add nuw nsw i64 %499, %469
  %514 = shl nsw i64 %513, 6
  %515 = getelementptr inbounds i8, ptr %470, i64 %514
  %516 = load <8 x double>, ptr %515, align 8, !noalias !19
  %517 = fadd <8 x double> %516, %509
  %518 = fmul <8 x double> %491, %517
  %519 = fadd <8 x double> %512, %518
  %520 = getelementptr inbounds i8, ptr %471, i64 %510
  %521 = load <8 x double>, ptr %520, align 8, !noalias !19
  %522 = fsub <8 x double> %519, %521
  %523 = add nuw nsw i64 %499, %494
  %524 = select <8 x i1> %474, <8 x double> %522, <8 x double> zeroinitializer
  %525 = shl nsw i64 %523, 6
  %526 = getelementptr inbounds i8, ptr %472, i64 %525
  store <8 x double> %524, ptr %526, align 8, !noalias !19
  %527 = add nuw nsw i64 %499, 1
  %528 = icmp eq i64 %527, %469
  br i1 %528, label %495, label %498, !llvm.loop !26

529:                                              ; preds = %479, %545
  %530 = phi i64 [ 0, %479 ], [ %546, %545 ]
  br i1 %480, label %531, label %545

531:                                              ; preds = %529
  %532 = mul nuw nsw i64 %469, %530
  %533 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %530
  %534 = load double, ptr %533, align 8, !noalias !19
  %535 = insertelement <8 x double> poison, double %534, i64 0
  %536 = shufflevector <8 x double> %535, <8 x double> poison, <8 x i32> zeroinitializer
  %537 = getelementptr inbounds i8, ptr %533, i64 8
  %538 = load double, ptr %537, align 8, !noalias !19
  %539 = insertelement <8 x double> poison, double %538, i64 0
  %540 = shufflevector <8 x double> %539, <8 x double> poison, <8 x i32> zeroinitializer
  %541 = getelementptr inbounds i8, ptr %533, i64 16
  %542 = load double, ptr %541, align 8, !noalias !19
  %543 = insertelement <8 x double> poison, double %542, i64 0
  %544 = shufflevector <8 x double> %543, <8 x double> poison, <8 x i32> zeroinitializer
  br label %548

545:                                              ; preds = %548, %529
  %546 = add nuw nsw i64 %530, 1
  %547 = icmp eq i64 %546, 3
  br i1 %547, label %570, label %529, !llvm.loop !27

548:                                              ; preds = %531, %548
  %549 = phi i64 [ 0, %531 ], [ %568, %548 ]
  %550 = add nuw nsw i64 %549, %532
  %551 = shl nsw i64 %549, 6
  %552 = getelementptr inbounds i8, ptr %472, i64 %551
  %553 = load <8 x double>, ptr %552, align 8, !noalias !19
  %554 = fmul <8 x double> %553, %536
  %555 = add nuw nsw i64 %549, %469
  %556 = shl nsw i64 %555, 6
  %557 = getelementptr inbounds i8, ptr %472, i64 %556
  %558 = load <8 x double>, ptr %557, align 8, !noalias !19
  %559 = fmul <8 x double> %558, %540
  %560 = fadd <8 x double> %554, %559
  %561 = shl i64 %549, 6
  %562 = getelementptr i8, ptr %482, i64 %561
  %563 = load <8 x double>, ptr %562, align 8, !noalias !19
  %564 = fmul <8 x double> %563, %544
  %565 = fadd <8 x double> %560, %564
  %566 = shl nsw i64 %550, 6
  %567 = getelementptr inbounds i8, ptr %473, i64 %566
  store <8 x double> %565, ptr %567, align 8, !noalias !19
  %568 = add nuw nsw i64 %549, 1
  %569 = icmp eq i64 %568, %469
  br i1 %569, label %545, label %548, !llvm.loop !28

570:                                              ; preds = %545
  %571 = select i1 %463, double %462, double %459
  %572 = fmul double %296, %571
  %573 = load ptr, ptr %65, align 8, !noalias !29
  %574 = getelementptr inbounds i8, ptr %573, i64 40
  %575 = load i64, ptr %574, align 8, !noalias !29
  %576 = icmp sgt i64 %575, 0
  %577 = select i1 %576, i64 10, i64 6
  %578 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %248
  %579 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %248
  %580 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %248
  %581 = fneg <8 x double> %579
  %582 = insertelement <8 x double> poison, double %571, i64 0
  %583 = shufflevector <8 x double> %582, <8 x double> poison, <8 x i32> zeroinitializer
  %584 = fmul double %572, %572
  %585 = insertelement <8 x double> poison, double %584, i64 0
  %586 = shufflevector <8 x double> %585, <8 x double> poison, <8 x i32> zeroinitializer
  br label %590

587:                                              ; preds = %1095
  %588 = add nuw nsw i64 %594, 1
  %589 = icmp eq i64 %588, %577
  br i1 %589, label %1109, label %590, !llvm.loop !32

590:                                              ; preds = %570, %587
  %591 = phi <8 x double> [ <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>, %570 ], [ %1107, %587 ]
  %592 = phi i64 [ %454, %570 ], [ %1106, %587 ]
  %593 = phi i64 [ 0, %570 ], [ %1105, %587 ]
  %594 = phi i64 [ 0, %570 ], [ %588, %587 ]
  %595 = phi i64 [ 0, %570 ], [ %1103, %587 ]
  %596 = phi i64 [ 0, %570 ], [ %683, %587 ]
  %597 = phi <8 x double> [ zeroinitializer, %570 ], [ %682, %587 ]
  %598 = phi <8 x double> [ zeroinitializer, %570 ], [ %1102, %587 ]
  %599 = phi <8 x double> [ zeroinitializer, %570 ], [ %1101, %587 ]
  %600 = phi <8 x double> [ %146, %570 ], [ %1100, %587 ]
  %601 = phi <8 x double> [ %145, %570 ], [ %1099, %587 ]
  %602 = phi <8 x double> [ %144, %570 ], [ %1098, %587 ]
  %603 = phi i64 [ %143, %570 ], [ %1097, %587 ]
  %604 = phi i64 [ %142, %570 ], [ %1096, %587 ]
  %605 = icmp ugt i64 %594, 5
  %606 = select i1 %605, i64 %595, i64 -1
  %607 = and i64 %592, %606
  %608 = load ptr, ptr %19, align 8, !noalias !29
  %609 = getelementptr inbounds i8, ptr %608, i64 8
  %610 = load i64, ptr %609, align 8, !noalias !29
  %611 = load ptr, ptr %82, align 8, !noalias !29
  %612 = icmp eq i64 %607, 0
  br i1 %612, label %681, label %613

613:                                              ; preds = %590
  %614 = icmp sgt i64 %610, 0
  %615 = shl i64 %610, 6
  br label %616

616:                                              ; preds = %613, %648
  %617 = phi i64 [ %607, %613 ], [ %661, %648 ]
  %618 = phi i64 [ 0, %613 ], [ %662, %648 ]
  %619 = phi i64 [ %596, %613 ], [ %659, %648 ]
  %620 = phi <8 x double> [ %597, %613 ], [ %627, %648 ]
  br i1 %614, label %621, label %623

621:                                              ; preds = %616
  %622 = mul nuw nsw i64 %618, %610
  br label %666

623:                                              ; preds = %666, %616
  %624 = trunc i64 %617 to i8
  %625 = bitcast i8 %624 to <8 x i1>
  %626 = select <8 x i1> %625, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %627 = fadd <8 x double> %620, %626
  %628 = load ptr, ptr %85, align 8, !noalias !29
  %629 = mul i64 %615, %618
  %630 = getelementptr inbounds i8, ptr %628, i64 %629
  %631 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %618
  %632 = load double, ptr %631, align 8, !noalias !29
  %633 = insertelement <8 x double> poison, double %632, i64 0
  %634 = shufflevector <8 x double> %633, <8 x double> poison, <8 x i32> zeroinitializer
  %635 = fmul <8 x double> %634, %248
  %636 = fadd <8 x double> %232, %635
  %637 = load ptr, ptr %86, align 8, !noalias !29
  %638 = load ptr, ptr %87, align 8, !noalias !29
  store <8 x double> %636, ptr %638, align 8, !noalias !29
  %639 = load ptr, ptr %19, align 8, !noalias !29
  %640 = getelementptr inbounds i8, ptr %639, i64 40
  %641 = load i64, ptr %640, align 8, !noalias !29
  %642 = icmp eq i64 %641, 0
  br i1 %642, label %644, label %643

643:                                              ; preds = %623
  call fastcc void @settle(ptr noundef nonnull %19) #11, !noalias !29
  br label %644

644:                                              ; preds = %643, %623
  %645 = load i64, ptr %88, align 8, !noalias !29
  %646 = icmp sgt i64 %645, 0
  br i1 %646, label %647, label %648

647:                                              ; preds = %644
  call fastcc void @sample(ptr noundef nonnull %19) #11, !noalias !29
  br label %648

648:                                              ; preds = %647, %644
  %649 = load ptr, ptr %19, align 8, !noalias !29
  %650 = load i64, ptr %649, align 8, !noalias !29
  %651 = load ptr, ptr %87, align 8, !noalias !29
  %652 = load ptr, ptr %89, align 8, !noalias !29
  %653 = load ptr, ptr %90, align 8, !noalias !29
  %654 = inttoptr i64 %650 to ptr
  %655 = load ptr, ptr %654, align 8, !noalias !29
  %656 = call i32 %655(ptr noundef %651, ptr noundef %637, ptr noundef %652, ptr noundef %653, ptr noundef %630) #12, !noalias !29
  %657 = sext i32 %656 to i64
  %658 = and i64 %617, %657
  %659 = or i64 %658, %619
  %660 = xor i64 %657, -1
  %661 = and i64 %617, %660
  %662 = add nuw nsw i64 %618, 1
  %663 = icmp ult i64 %618, 2
  %664 = icmp ne i64 %661, 0
  %665 = select i1 %663, i1 %664, i1 false
  br i1 %665, label %616, label %681, !llvm.loop !33

666:                                              ; preds = %621, %666
  %667 = phi i64 [ 0, %621 ], [ %679, %666 ]
  %668 = load ptr, ptr %84, align 8, !noalias !29
  %669 = load ptr, ptr %21, align 8, !noalias !29
  %670 = shl nsw i64 %667, 6
  %671 = getelementptr inbounds i8, ptr %669, i64 %670
  %672 = load <8 x double>, ptr %671, align 8, !noalias !29
  %673 = add nuw nsw i64 %667, %622
  %674 = shl nsw i64 %673, 6
  %675 = getelementptr inbounds i8, ptr %611, i64 %674
  %676 = load <8 x double>, ptr %675, align 8, !noalias !29
  %677 = fadd <8 x double> %672, %676
  %678 = getelementptr inbounds i8, ptr %668, i64 %670
  store <8 x double> %677, ptr %678, align 8, !noalias !29
  %679 = add nuw nsw i64 %667, 1
  %680 = icmp eq i64 %679, %610
  br i1 %680, label %623, label %666, !llvm.loop !34

681:                                              ; preds = %648, %590
  %682 = phi <8 x double> [ %597, %590 ], [ %627, %648 ]
  %683 = phi i64 [ %596, %590 ], [ %659, %648 ]
  %684 = phi i64 [ %607, %590 ], [ %661, %648 ]
  %685 = icmp eq i64 %684, 0
  br i1 %685, label %686, label %690

686:                                              ; preds = %681
  %687 = or i64 %607, %593
  %688 = xor i64 %687, -1
  %689 = and i64 %595, %688
  br label %1095

690:                                              ; preds = %681
  %691 = load ptr, ptr %19, align 8, !noalias !29
  %692 = getelementptr inbounds i8, ptr %691, i64 8
  %693 = load i64, ptr %692, align 8, !noalias !29
  %694 = getelementptr inbounds i8, ptr %691, i64 24
  %695 = load i64, ptr %694, align 8, !noalias !29
  %696 = load ptr, ptr %91, align 8, !noalias !29
  %697 = load ptr, ptr %83, align 8, !noalias !29
  %698 = icmp sgt i64 %693, 0
  br i1 %698, label %699, label %789

699:                                              ; preds = %690
  %700 = shl i64 %693, 7
  br label %701

701:                                              ; preds = %699, %785
  %702 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %699 ], [ %720, %785 ]
  %703 = phi i64 [ 0, %699 ], [ %787, %785 ]
  %704 = phi <8 x double> [ zeroinitializer, %699 ], [ %786, %785 ]
  %705 = shl nsw i64 %703, 6
  %706 = getelementptr inbounds i8, ptr %696, i64 %705
  %707 = load <8 x double>, ptr %706, align 8, !noalias !29
  %708 = add nuw nsw i64 %703, %693
  %709 = shl nsw i64 %708, 6
  %710 = getelementptr inbounds i8, ptr %696, i64 %709
  %711 = load <8 x double>, ptr %710, align 8, !noalias !29
  %712 = fadd <8 x double> %707, %711
  %713 = shl i64 %703, 6
  %714 = add i64 %713, %700
  %715 = getelementptr inbounds i8, ptr %696, i64 %714
  %716 = load <8 x double>, ptr %715, align 8, !noalias !29
  %717 = fadd <8 x double> %712, %716
  %718 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %717)
  %719 = fcmp one <8 x double> %718, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %720 = select <8 x i1> %719, <8 x i64> %702, <8 x i64> zeroinitializer
  %721 = getelementptr inbounds i8, ptr %697, i64 %709
  %722 = load <8 x double>, ptr %721, align 8, !noalias !29
  %723 = getelementptr inbounds i8, ptr %697, i64 %714
  %724 = load <8 x double>, ptr %723, align 8, !noalias !29
  %725 = fmul <8 x double> %707, <double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46>
  %726 = fmul <8 x double> %711, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %727 = fsub <8 x double> %725, %726
  %728 = fmul <8 x double> %716, <double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221>
  %729 = fadd <8 x double> %727, %728
  %730 = fmul <8 x double> %707, <double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2>
  %731 = fmul <8 x double> %711, <double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598>
  %732 = fsub <8 x double> %730, %731
  %733 = fmul <8 x double> %716, <double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1>
  %734 = fadd <8 x double> %732, %733
  %735 = fmul <8 x double> %707, <double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46>
  %736 = fmul <8 x double> %711, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %737 = fadd <8 x double> %735, %736
  %738 = fmul <8 x double> %716, <double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF>
  %739 = fadd <8 x double> %737, %738
  %740 = getelementptr inbounds i8, ptr %697, i64 %705
  %741 = load <8 x double>, ptr %740, align 8, !noalias !29
  %742 = fmul <8 x double> %580, %741
  %743 = fsub <8 x double> %739, %742
  %744 = fmul <8 x double> %724, %581
  %745 = call <8 x double> @llvm.fma.v8f64(<8 x double> %578, <8 x double> %722, <8 x double> %744)
  %746 = fmul <8 x double> %579, %722
  %747 = call <8 x double> @llvm.fma.v8f64(<8 x double> %578, <8 x double> %724, <8 x double> %746)
  %748 = fsub <8 x double> %729, %745
  %749 = fsub <8 x double> %734, %747
  %750 = load ptr, ptr %92, align 8, !noalias !29
  %751 = getelementptr inbounds i8, ptr %750, i64 %705
  store <8 x double> %743, ptr %751, align 8, !noalias !29
  %752 = load ptr, ptr %93, align 8, !noalias !29
  %753 = shl i64 %703, 7
  %754 = shl nsw i64 %703, 7
  %755 = getelementptr inbounds i8, ptr %752, i64 %754
  store <8 x double> %748, ptr %755, align 8, !noalias !29
  %756 = or disjoint i64 %753, 64
  %757 = getelementptr inbounds i8, ptr %752, i64 %756
  store <8 x double> %749, ptr %757, align 8, !noalias !29
  %758 = icmp slt i64 %703, %695
  br i1 %758, label %759, label %785

759:                                              ; preds = %701
  %760 = load ptr, ptr %21, align 8, !noalias !29
  %761 = getelementptr inbounds i8, ptr %760, i64 %705
  %762 = load <8 x double>, ptr %761, align 8, !noalias !29
  %763 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %743)
  %764 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %748)
  %765 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %749)
  %766 = fadd <8 x double> %765, %764
  %767 = fadd <8 x double> %763, %766
  %768 = fmul <8 x double> %767, %248
  %769 = load ptr, ptr %94, align 8, !noalias !29
  %770 = getelementptr inbounds double, ptr %769, i64 %703
  %771 = load double, ptr %770, align 8, !noalias !29
  %772 = insertelement <8 x double> poison, double %771, i64 0
  %773 = shufflevector <8 x double> %772, <8 x double> poison, <8 x i32> zeroinitializer
  %774 = load ptr, ptr %66, align 8, !noalias !29
  %775 = getelementptr inbounds double, ptr %774, i64 %703
  %776 = load double, ptr %775, align 8, !noalias !29
  %777 = insertelement <8 x double> poison, double %776, i64 0
  %778 = shufflevector <8 x double> %777, <8 x double> poison, <8 x i32> zeroinitializer
  %779 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %762)
  %780 = fmul <8 x double> %779, %778
  %781 = fadd <8 x double> %773, %780
  %782 = fdiv <8 x double> %768, %781
  %783 = fmul <8 x double> %782, %782
  %784 = fadd <8 x double> %704, %783
  br label %785

785:                                              ; preds = %759, %701
  %786 = phi <8 x double> [ %784, %759 ], [ %704, %701 ]
  %787 = add nuw nsw i64 %703, 1
  %788 = icmp eq i64 %787, %693
  br i1 %788, label %789, label %701, !llvm.loop !35

789:                                              ; preds = %785, %690
  %790 = phi <8 x double> [ zeroinitializer, %690 ], [ %786, %785 ]
  %791 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %690 ], [ %720, %785 ]
  %792 = icmp ne <8 x i64> %791, zeroinitializer
  %793 = bitcast <8 x i1> %792 to i8
  %794 = zext i8 %793 to i64
  %795 = and i64 %684, %794
  %796 = xor i64 %795, %684
  %797 = trunc i64 %796 to i8
  %798 = bitcast i8 %797 to <8 x i1>
  %799 = load ptr, ptr %19, align 8, !noalias !29
  %800 = getelementptr inbounds i8, ptr %799, i64 24
  %801 = load i64, ptr %800, align 8, !noalias !29
  %802 = load i64, ptr %96, align 8, !noalias !29
  %803 = sdiv i64 %802, 8
  %804 = load ptr, ptr %65, align 8, !noalias !29
  %805 = getelementptr inbounds i8, ptr %804, i64 40
  %806 = load i64, ptr %805, align 8, !noalias !29
  %807 = load ptr, ptr %97, align 8, !noalias !29
  %808 = load ptr, ptr %98, align 8, !noalias !29
  %809 = load ptr, ptr %99, align 8, !noalias !29
  %810 = load ptr, ptr %95, align 8, !noalias !29
  call fastcc void @real_solve(ptr noundef %809, i64 noundef %803, ptr noundef %810, ptr noundef %807) #11, !noalias !29
  %811 = load ptr, ptr %100, align 8, !noalias !29
  %812 = load ptr, ptr %101, align 8, !noalias !29
  call fastcc void @pair_solve(ptr noundef %811, i64 noundef %803, ptr noundef %812, ptr noundef %808) #11, !noalias !29
  %813 = icmp sgt i64 %806, 0
  br i1 %813, label %814, label %823

814:                                              ; preds = %789
  %815 = load ptr, ptr %99, align 8, !noalias !29
  %816 = load ptr, ptr %95, align 8, !noalias !29
  %817 = shl nsw i64 %803, 6
  %818 = getelementptr inbounds i8, ptr %807, i64 %817
  call fastcc void @real_solve_columns(ptr noundef %815, i64 noundef %803, ptr noundef %816, ptr noundef %818, i64 noundef %806) #11, !noalias !29
  %819 = load ptr, ptr %100, align 8, !noalias !29
  %820 = load ptr, ptr %101, align 8, !noalias !29
  %821 = shl nsw i64 %803, 7
  %822 = getelementptr inbounds i8, ptr %808, i64 %821
  call fastcc void @pair_solve_columns(ptr noundef %819, i64 noundef %803, ptr noundef %820, ptr noundef %822, i64 noundef %806) #11, !noalias !29
  br label %823

823:                                              ; preds = %814, %789
  %824 = icmp sgt i64 %801, 0
  br i1 %824, label %825, label %866

825:                                              ; preds = %823
  %826 = load ptr, ptr %21, align 8, !noalias !29
  %827 = load ptr, ptr %102, align 8, !noalias !29
  %828 = load ptr, ptr %66, align 8, !noalias !29
  br label %829

829:                                              ; preds = %825, %829
  %830 = phi <8 x double> [ zeroinitializer, %825 ], [ %863, %829 ]
  %831 = phi i64 [ 0, %825 ], [ %864, %829 ]
  %832 = shl nsw i64 %831, 6
  %833 = getelementptr inbounds i8, ptr %826, i64 %832
  %834 = load <8 x double>, ptr %833, align 8, !noalias !29
  %835 = getelementptr inbounds double, ptr %827, i64 %831
  %836 = load double, ptr %835, align 8, !noalias !29
  %837 = insertelement <8 x double> poison, double %836, i64 0
  %838 = shufflevector <8 x double> %837, <8 x double> poison, <8 x i32> zeroinitializer
  %839 = getelementptr inbounds double, ptr %828, i64 %831
  %840 = load double, ptr %839, align 8, !noalias !29
  %841 = insertelement <8 x double> poison, double %840, i64 0
  %842 = shufflevector <8 x double> %841, <8 x double> poison, <8 x i32> zeroinitializer
  %843 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %834)
  %844 = fmul <8 x double> %843, %842
  %845 = fadd <8 x double> %838, %844
  %846 = getelementptr inbounds i8, ptr %807, i64 %832
  %847 = load <8 x double>, ptr %846, align 8, !noalias !29
  %848 = fdiv <8 x double> %847, %845
  %849 = shl i64 %831, 7
  %850 = shl nsw i64 %831, 7
  %851 = getelementptr inbounds i8, ptr %808, i64 %850
  %852 = load <8 x double>, ptr %851, align 8, !noalias !36
  %853 = or disjoint i64 %849, 64
  %854 = getelementptr inbounds i8, ptr %808, i64 %853
  %855 = load <8 x double>, ptr %854, align 8, !noalias !36
  %856 = fdiv <8 x double> %852, %845
  %857 = fdiv <8 x double> %855, %845
  %858 = fmul <8 x double> %848, %848
  %859 = fmul <8 x double> %856, %856
  %860 = fadd <8 x double> %858, %859
  %861 = fmul <8 x double> %857, %857
  %862 = fadd <8 x double> %861, %860
  %863 = fadd <8 x double> %830, %862
  %864 = add nuw nsw i64 %831, 1
  %865 = icmp eq i64 %864, %801
  br i1 %865, label %866, label %829, !llvm.loop !39

866:                                              ; preds = %829, %823
  %867 = phi <8 x double> [ zeroinitializer, %823 ], [ %863, %829 ]
  %868 = mul nsw i64 %801, 3
  %869 = sitofp i64 %868 to double
  %870 = insertelement <8 x double> poison, double %869, i64 0
  %871 = shufflevector <8 x double> %870, <8 x double> poison, <8 x i32> zeroinitializer
  %872 = fdiv <8 x double> %867, %871
  %873 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %872)
  %874 = fcmp oeq <8 x double> %873, zeroinitializer
  %875 = fcmp ogt <8 x double> %790, zeroinitializer
  %876 = and <8 x i1> %874, %875
  %877 = bitcast <8 x i1> %876 to i8
  %878 = zext i8 %877 to i64
  %879 = xor i64 %878, -1
  %880 = and i64 %795, %879
  %881 = xor i64 %595, -1
  %882 = and i64 %880, %881
  %883 = trunc nuw i64 %882 to i8
  %884 = bitcast i8 %883 to <8 x i1>
  %885 = fcmp ogt <8 x double> %591, zeroinitializer
  %886 = select <8 x i1> %885, <8 x i1> %884, <8 x i1> zeroinitializer
  %887 = fdiv <8 x double> %873, %591
  %888 = select <8 x i1> %798, <8 x double> <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, <8 x double> %598
  %889 = select <8 x i1> %886, <8 x double> %887, <8 x double> %888
  %890 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %889
  %891 = fdiv <8 x double> %873, %890
  %892 = icmp ult i64 %594, 5
  br i1 %892, label %1003, label %893

893:                                              ; preds = %1003, %866
  %894 = phi <8 x double> [ %891, %866 ], [ %1006, %1003 ]
  %895 = fcmp oge <8 x double> %889, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %896 = fcmp ogt <8 x double> %894, %583
  %897 = or <8 x i1> %896, %895
  %898 = select <8 x i1> %897, <8 x i1> %886, <8 x i1> zeroinitializer
  %899 = bitcast <8 x i1> %898 to i8
  %900 = zext i8 %899 to i64
  %901 = xor i64 %900, -1
  %902 = and i64 %880, %901
  %903 = xor i64 %902, -1
  %904 = and i64 %607, %903
  %905 = or i64 %904, %593
  %906 = load ptr, ptr %19, align 8, !noalias !29
  %907 = getelementptr inbounds i8, ptr %906, i64 8
  %908 = load i64, ptr %907, align 8, !noalias !29
  %909 = trunc nuw i64 %902 to i8
  %910 = bitcast i8 %909 to <8 x i1>
  %911 = load ptr, ptr %82, align 8, !noalias !29
  %912 = load ptr, ptr %83, align 8, !noalias !29
  %913 = icmp sgt i64 %908, 0
  br i1 %913, label %914, label %985

914:                                              ; preds = %893
  %915 = shl i64 %908, 7
  %916 = getelementptr i8, ptr %912, i64 %915
  br label %917

917:                                              ; preds = %914, %951
  %918 = phi i64 [ 0, %914 ], [ %952, %951 ]
  %919 = load ptr, ptr %98, align 8, !noalias !29
  %920 = shl i64 %918, 7
  %921 = shl nsw i64 %918, 7
  %922 = getelementptr inbounds i8, ptr %919, i64 %921
  %923 = load <8 x double>, ptr %922, align 8, !noalias !40
  %924 = or disjoint i64 %920, 64
  %925 = getelementptr inbounds i8, ptr %919, i64 %924
  %926 = load <8 x double>, ptr %925, align 8, !noalias !40
  %927 = load ptr, ptr %97, align 8, !noalias !29
  %928 = shl nsw i64 %918, 6
  %929 = getelementptr inbounds i8, ptr %927, i64 %928
  %930 = load <8 x double>, ptr %929, align 8, !noalias !29
  store <8 x double> %930, ptr %10, align 64, !noalias !29
  store <8 x double> %923, ptr %103, align 64, !noalias !29
  store <8 x double> %926, ptr %104, align 64, !noalias !29
  br label %938

931:                                              ; preds = %938
  %932 = getelementptr inbounds i8, ptr %912, i64 %928
  %933 = add nuw nsw i64 %918, %908
  %934 = shl nsw i64 %933, 6
  %935 = getelementptr inbounds i8, ptr %912, i64 %934
  %936 = shl i64 %918, 6
  %937 = getelementptr i8, ptr %916, i64 %936
  br label %954

938:                                              ; preds = %917, %938
  %939 = phi i64 [ 0, %917 ], [ %949, %938 ]
  %940 = mul nuw nsw i64 %908, %939
  %941 = add nuw nsw i64 %940, %918
  %942 = shl nsw i64 %941, 6
  %943 = getelementptr inbounds i8, ptr %912, i64 %942
  %944 = load <8 x double>, ptr %943, align 8, !noalias !29
  %945 = getelementptr inbounds [3 x <8 x double>], ptr %10, i64 0, i64 %939
  %946 = load <8 x double>, ptr %945, align 64, !noalias !29
  %947 = fadd <8 x double> %944, %946
  %948 = select <8 x i1> %910, <8 x double> %947, <8 x double> %944
  store <8 x double> %948, ptr %943, align 8, !noalias !29
  %949 = add nuw nsw i64 %939, 1
  %950 = icmp eq i64 %949, 3
  br i1 %950, label %931, label %938, !llvm.loop !43

951:                                              ; preds = %954
  %952 = add nuw nsw i64 %918, 1
  %953 = icmp eq i64 %952, %908
  br i1 %953, label %985, label %917, !llvm.loop !44

954:                                              ; preds = %931, %954
  %955 = phi i64 [ 0, %931 ], [ %983, %954 ]
  %956 = mul nuw nsw i64 %908, %955
  %957 = add nuw nsw i64 %956, %918
  %958 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %955
  %959 = load double, ptr %958, align 8, !noalias !29
  %960 = insertelement <8 x double> poison, double %959, i64 0
  %961 = shufflevector <8 x double> %960, <8 x double> poison, <8 x i32> zeroinitializer
  %962 = load <8 x double>, ptr %932, align 8, !noalias !29
  %963 = fmul <8 x double> %962, %961
  %964 = getelementptr inbounds i8, ptr %958, i64 8
  %965 = load double, ptr %964, align 8, !noalias !29
  %966 = insertelement <8 x double> poison, double %965, i64 0
  %967 = shufflevector <8 x double> %966, <8 x double> poison, <8 x i32> zeroinitializer
  %968 = load <8 x double>, ptr %935, align 8, !noalias !29
  %969 = fmul <8 x double> %968, %967
  %970 = fadd <8 x double> %963, %969
  %971 = getelementptr inbounds i8, ptr %958, i64 16
  %972 = load double, ptr %971, align 8, !noalias !29
  %973 = insertelement <8 x double> poison, double %972, i64 0
  %974 = shufflevector <8 x double> %973, <8 x double> poison, <8 x i32> zeroinitializer
  %975 = load <8 x double>, ptr %937, align 8, !noalias !29
  %976 = fmul <8 x double> %975, %974
  %977 = fadd <8 x double> %970, %976
  %978 = shl nsw i64 %957, 6
  %979 = getelementptr inbounds i8, ptr %911, i64 %978
  %980 = load <8 x i64>, ptr %979, align 8, !noalias !29
  %981 = bitcast <8 x double> %977 to <8 x i64>
  %982 = select <8 x i1> %910, <8 x i64> %981, <8 x i64> %980
  store <8 x i64> %982, ptr %979, align 8, !noalias !29
  %983 = add nuw nsw i64 %955, 1
  %984 = icmp eq i64 %983, 3
  br i1 %984, label %951, label %954, !llvm.loop !45

985:                                              ; preds = %951, %893
  %986 = fdiv <8 x double> %889, %890
  %987 = fmul <8 x double> %873, %986
  %988 = fcmp olt <8 x double> %987, %583
  %989 = and <8 x i1> %988, %885
  %990 = or <8 x i1> %989, %874
  %991 = bitcast <8 x i1> %990 to i8
  %992 = zext i8 %991 to i64
  %993 = and i64 %992, %881
  %994 = and i64 %993, %902
  %995 = trunc nuw i64 %994 to i8
  %996 = bitcast i8 %995 to <8 x i1>
  %997 = add nuw nsw i64 %594, 1
  %998 = uitofp nneg i64 %997 to double
  %999 = insertelement <8 x double> poison, double %998, i64 0
  %1000 = shufflevector <8 x double> %999, <8 x double> poison, <8 x i32> zeroinitializer
  %1001 = select <8 x i1> %996, <8 x double> %1000, <8 x double> %599
  %1002 = or i64 %994, %595
  br i1 %576, label %1009, label %1088

1003:                                             ; preds = %866, %1003
  %1004 = phi i64 [ %1007, %1003 ], [ %594, %866 ]
  %1005 = phi <8 x double> [ %1006, %1003 ], [ %891, %866 ]
  %1006 = fmul <8 x double> %1005, %889
  %1007 = add nuw nsw i64 %1004, 1
  %1008 = icmp ult i64 %1004, 4
  br i1 %1008, label %1003, label %893, !llvm.loop !46

1009:                                             ; preds = %985
  %1010 = load i64, ptr %96, align 8, !noalias !29
  %1011 = sdiv i64 %1010, 8
  %1012 = load ptr, ptr %65, align 8, !noalias !29
  %1013 = getelementptr inbounds i8, ptr %1012, i64 40
  %1014 = load i64, ptr %1013, align 8, !noalias !29
  %1015 = load ptr, ptr %19, align 8, !noalias !29
  %1016 = getelementptr inbounds i8, ptr %1015, i64 8
  %1017 = load i64, ptr %1016, align 8, !noalias !29
  %1018 = load ptr, ptr %83, align 8, !noalias !29
  %1019 = icmp sgt i64 %1014, 0
  br i1 %1019, label %1020, label %1082

1020:                                             ; preds = %1009
  %1021 = icmp sgt i64 %1010, 7
  br label %1022

1022:                                             ; preds = %1020, %1030
  %1023 = phi <8 x double> [ zeroinitializer, %1020 ], [ %1038, %1030 ]
  %1024 = phi i64 [ 0, %1020 ], [ %1039, %1030 ]
  br i1 %1021, label %1025, label %1030

1025:                                             ; preds = %1022
  %1026 = add nuw i64 %1024, %1011
  %1027 = load ptr, ptr %97, align 8, !noalias !29
  %1028 = load ptr, ptr %21, align 8, !noalias !29
  %1029 = load ptr, ptr %98, align 8, !noalias !29
  br label %1041

1030:                                             ; preds = %1066, %1022
  %1031 = phi <8 x double> [ zeroinitializer, %1022 ], [ %1079, %1066 ]
  %1032 = phi <8 x double> [ zeroinitializer, %1022 ], [ %1067, %1066 ]
  %1033 = fcmp ogt <8 x double> %1031, zeroinitializer
  %1034 = fdiv <8 x double> %1032, %1031
  %1035 = fmul <8 x double> %1023, %1031
  %1036 = fcmp ogt <8 x double> %1032, %1035
  %1037 = select <8 x i1> %1033, <8 x double> %1034, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1038 = select <8 x i1> %1036, <8 x double> %1037, <8 x double> %1023
  %1039 = add nuw nsw i64 %1024, 1
  %1040 = icmp eq i64 %1039, %1014
  br i1 %1040, label %1082, label %1022, !llvm.loop !47

1041:                                             ; preds = %1025, %1066
  %1042 = phi <8 x double> [ zeroinitializer, %1025 ], [ %1067, %1066 ]
  %1043 = phi i64 [ 0, %1025 ], [ %1068, %1066 ]
  %1044 = phi <8 x double> [ zeroinitializer, %1025 ], [ %1079, %1066 ]
  %1045 = mul nuw nsw i64 %1043, %1014
  %1046 = add i64 %1026, %1045
  %1047 = shl nsw i64 %1046, 6
  %1048 = getelementptr inbounds i8, ptr %1027, i64 %1047
  %1049 = load <8 x double>, ptr %1048, align 8, !noalias !29
  %1050 = getelementptr inbounds i8, ptr %1028, i64 %1047
  %1051 = load <8 x double>, ptr %1050, align 8, !noalias !29
  %1052 = shl i64 %1046, 7
  %1053 = shl nsw i64 %1046, 7
  %1054 = getelementptr inbounds i8, ptr %1029, i64 %1053
  %1055 = load <8 x double>, ptr %1054, align 8, !noalias !48
  %1056 = or disjoint i64 %1052, 64
  %1057 = getelementptr inbounds i8, ptr %1029, i64 %1056
  %1058 = load <8 x double>, ptr %1057, align 8, !noalias !48
  %1059 = fmul <8 x double> %1049, %1049
  %1060 = fmul <8 x double> %1055, %1055
  %1061 = fmul <8 x double> %1058, %1058
  %1062 = fadd <8 x double> %1060, %1061
  %1063 = fadd <8 x double> %1059, %1062
  %1064 = fmul <8 x double> %1051, %1051
  %1065 = fadd <8 x double> %1044, %1064
  br label %1070

1066:                                             ; preds = %1070
  %1067 = fadd <8 x double> %1042, %1063
  %1068 = add nuw nsw i64 %1043, 1
  %1069 = icmp eq i64 %1068, %1011
  br i1 %1069, label %1030, label %1041, !llvm.loop !51

1070:                                             ; preds = %1041, %1070
  %1071 = phi i64 [ 0, %1041 ], [ %1080, %1070 ]
  %1072 = phi <8 x double> [ %1065, %1041 ], [ %1079, %1070 ]
  %1073 = mul nsw i64 %1017, %1071
  %1074 = add nsw i64 %1073, %1046
  %1075 = shl nsw i64 %1074, 6
  %1076 = getelementptr inbounds i8, ptr %1018, i64 %1075
  %1077 = load <8 x double>, ptr %1076, align 8, !noalias !29
  %1078 = fmul <8 x double> %1077, %1077
  %1079 = fadd <8 x double> %1072, %1078
  %1080 = add nuw nsw i64 %1071, 1
  %1081 = icmp eq i64 %1080, 3
  br i1 %1081, label %1066, label %1070, !llvm.loop !52

1082:                                             ; preds = %1030, %1009
  %1083 = phi <8 x double> [ zeroinitializer, %1009 ], [ %1038, %1030 ]
  %1084 = fcmp ole <8 x double> %1083, %586
  %1085 = bitcast <8 x i1> %1084 to i8
  %1086 = zext i8 %1085 to i64
  %1087 = and i64 %1002, %1086
  br label %1088

1088:                                             ; preds = %1082, %985
  %1089 = phi i64 [ %1087, %1082 ], [ %1002, %985 ]
  %1090 = xor i64 %1089, -1
  %1091 = and i64 %902, %1090
  %1092 = icmp eq i64 %1091, 0
  %1093 = select i1 %1092, i32 2, i32 0
  %1094 = select i1 %1092, <8 x double> %591, <8 x double> %873
  br label %1095

1095:                                             ; preds = %1088, %686
  %1096 = phi i64 [ %689, %686 ], [ %604, %1088 ]
  %1097 = phi i64 [ %683, %686 ], [ %603, %1088 ]
  %1098 = phi <8 x double> [ %599, %686 ], [ %602, %1088 ]
  %1099 = phi <8 x double> [ %598, %686 ], [ %601, %1088 ]
  %1100 = phi <8 x double> [ %682, %686 ], [ %600, %1088 ]
  %1101 = phi <8 x double> [ %599, %686 ], [ %1001, %1088 ]
  %1102 = phi <8 x double> [ %598, %686 ], [ %889, %1088 ]
  %1103 = phi i64 [ %689, %686 ], [ %1002, %1088 ]
  %1104 = phi i32 [ 1, %686 ], [ %1093, %1088 ]
  %1105 = phi i64 [ %593, %686 ], [ %905, %1088 ]
  %1106 = phi i64 [ %607, %686 ], [ %1091, %1088 ]
  %1107 = phi <8 x double> [ %591, %686 ], [ %1094, %1088 ]
  %1108 = icmp eq i32 %1104, 0
  br i1 %1108, label %587, label %1109

1109:                                             ; preds = %1095, %587
  %1110 = phi i32 [ %1104, %1095 ], [ 2, %587 ]
  %1111 = icmp eq i32 %1110, 2
  br i1 %1111, label %1112, label %1115

1112:                                             ; preds = %1109
  %1113 = xor i64 %1105, -1
  %1114 = and i64 %1103, %1113
  br label %1115

1115:                                             ; preds = %1109, %1112
  %1116 = phi i64 [ %1114, %1112 ], [ %1096, %1109 ]
  %1117 = phi i64 [ %683, %1112 ], [ %1097, %1109 ]
  %1118 = phi <8 x double> [ %1101, %1112 ], [ %1098, %1109 ]
  %1119 = phi <8 x double> [ %1102, %1112 ], [ %1099, %1109 ]
  %1120 = phi <8 x double> [ %682, %1112 ], [ %1100, %1109 ]
  %1121 = fadd <8 x double> %1120, zeroinitializer
  %1122 = fcmp ogt <8 x double> %1118, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %1123 = fcmp ogt <8 x double> %1119, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %1124 = and <8 x i1> %1123, %1122
  %1125 = bitcast <8 x i1> %1124 to i8
  %1126 = icmp eq i64 %1116, %454
  br i1 %1126, label %1203, label %1127

1127:                                             ; preds = %1115
  %1128 = xor i64 %1116, -1
  %1129 = and i64 %454, %1128
  %1130 = load ptr, ptr %65, align 8, !noalias !19
  %1131 = getelementptr inbounds i8, ptr %1130, i64 16
  %1132 = load i64, ptr %1131, align 8, !noalias !19
  %1133 = xor i64 %1117, -1
  %1134 = and i64 %1132, %1133
  %1135 = and i64 %1134, %1129
  %1136 = trunc i64 %1129 to i8
  %1137 = bitcast i8 %1136 to <8 x i1>
  %1138 = trunc i64 %1117 to i8
  %1139 = bitcast i8 %1138 to <8 x i1>
  %1140 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1119)
  %1141 = fcmp one <8 x double> %1140, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1142 = select <8 x i1> %1141, <8 x double> <double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00>, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %1143 = select <8 x i1> %1139, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1142
  %1144 = select <8 x i1> %1137, <8 x double> %1143, <8 x double> %453
  %1145 = icmp eq i64 %1135, 0
  br i1 %1145, label %1173, label %1146

1146:                                             ; preds = %1127
  %1147 = load i64, ptr %105, align 8, !noalias !19
  %1148 = icmp sgt i64 %1147, 7
  br i1 %1148, label %1149, label %1166

1149:                                             ; preds = %1146
  %1150 = trunc i64 %1135 to i8
  %1151 = bitcast i8 %1150 to <8 x i1>
  br label %1152

1152:                                             ; preds = %1149, %1152
  %1153 = phi <8 x i64> [ zeroinitializer, %1149 ], [ %1160, %1152 ]
  %1154 = phi i64 [ 0, %1149 ], [ %1162, %1152 ]
  %1155 = load ptr, ptr %106, align 8, !noalias !19
  %1156 = shl nsw i64 %1154, 6
  %1157 = getelementptr inbounds i8, ptr %1155, i64 %1156
  %1158 = load <8 x double>, ptr %1157, align 8, !noalias !19
  %1159 = fcmp une <8 x double> %1158, zeroinitializer
  %1160 = select <8 x i1> %1159, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %1153
  %1161 = select <8 x i1> %1151, <8 x double> zeroinitializer, <8 x double> %1158
  store <8 x double> %1161, ptr %1157, align 8, !noalias !19
  %1162 = add nuw nsw i64 %1154, 1
  %1163 = load i64, ptr %105, align 8, !noalias !19
  %1164 = sdiv i64 %1163, 8
  %1165 = icmp slt i64 %1162, %1164
  br i1 %1165, label %1152, label %1166, !llvm.loop !53

1166:                                             ; preds = %1152, %1146
  %1167 = phi <8 x i64> [ zeroinitializer, %1146 ], [ %1160, %1152 ]
  %1168 = icmp ne <8 x i64> %1167, zeroinitializer
  %1169 = bitcast <8 x i1> %1168 to i8
  %1170 = zext i8 %1169 to i64
  %1171 = and i64 %1135, %1170
  %1172 = xor i64 %1171, -1
  br label %1173

1173:                                             ; preds = %1127, %1166
  %1174 = phi i64 [ -1, %1127 ], [ %1172, %1166 ]
  %1175 = and i64 %1174, %1135
  %1176 = getelementptr inbounds i8, ptr %1130, i64 24
  %1177 = load i64, ptr %1176, align 8, !noalias !19
  %1178 = and i64 %1177, %1174
  store i64 %1178, ptr %1176, align 8, !noalias !19
  %1179 = xor i64 %1175, -1
  %1180 = load i64, ptr %1131, align 8, !noalias !19
  %1181 = and i64 %1180, %1179
  store i64 %1181, ptr %1131, align 8, !noalias !19
  %1182 = trunc i64 %1175 to i8
  %1183 = bitcast i8 %1182 to <8 x i1>
  %1184 = fmul <8 x double> %248, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %1185 = select <8 x i1> %1183, <8 x double> %1184, <8 x double> %452
  %1186 = fmul <8 x double> %248, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1187 = select <8 x i1> %1139, <8 x double> %1186, <8 x double> %1185
  %1188 = load ptr, ptr %74, align 8, !noalias !19
  %1189 = getelementptr inbounds i8, ptr %1188, i64 64
  %1190 = load <8 x double>, ptr %1189, align 8, !noalias !19
  %1191 = select <8 x i1> %1139, <8 x double> zeroinitializer, <8 x double> %1190
  store <8 x double> %1191, ptr %1189, align 8, !noalias !19
  %1192 = and i64 %1174, %1129
  %1193 = load ptr, ptr %65, align 8, !noalias !19
  %1194 = getelementptr inbounds i8, ptr %1193, i64 8
  %1195 = load i64, ptr %1194, align 8, !noalias !19
  %1196 = xor i64 %1192, -1
  %1197 = and i64 %1195, %1196
  %1198 = getelementptr inbounds i8, ptr %1193, i64 16
  %1199 = load i64, ptr %1198, align 8, !noalias !19
  %1200 = xor i64 %1199, -1
  %1201 = and i64 %1192, %1200
  %1202 = or disjoint i64 %1201, %1197
  store i64 %1202, ptr %1194, align 8, !noalias !19
  br label %1203

1203:                                             ; preds = %1173, %1115
  %1204 = phi <8 x double> [ %452, %1115 ], [ %1187, %1173 ]
  %1205 = phi <8 x double> [ %453, %1115 ], [ %1144, %1173 ]
  %1206 = icmp eq i64 %1116, 0
  br i1 %1206, label %1705, label %1207

1207:                                             ; preds = %1203
  %1208 = icmp sgt i64 %284, 0
  br i1 %1208, label %1209, label %1211

1209:                                             ; preds = %1207
  %1210 = shl i64 %284, 7
  br label %1689

1211:                                             ; preds = %1689, %1207
  %1212 = getelementptr inbounds i8, ptr %297, i64 32
  %1213 = load i64, ptr %1212, align 8, !noalias !19
  %1214 = load ptr, ptr %19, align 8, !noalias !19
  %1215 = getelementptr inbounds i8, ptr %1214, i64 8
  %1216 = load i64, ptr %1215, align 8, !noalias !19
  %1217 = load ptr, ptr %108, align 8, !noalias !19
  %1218 = load ptr, ptr %109, align 8, !noalias !19
  %1219 = icmp sgt i64 %1216, 0
  br i1 %1219, label %1220, label %1222

1220:                                             ; preds = %1211
  %1221 = shl i64 %1216, 7
  br label %1378

1222:                                             ; preds = %1378, %1211
  %1223 = load i64, ptr %112, align 8, !noalias !19
  %1224 = sdiv i64 %1223, 8
  %1225 = load ptr, ptr %65, align 8, !noalias !19
  %1226 = getelementptr inbounds i8, ptr %1225, i64 40
  %1227 = load i64, ptr %1226, align 8, !noalias !19
  %1228 = load ptr, ptr %113, align 8, !noalias !19
  %1229 = load ptr, ptr %111, align 8, !noalias !19
  call fastcc void @real_solve(ptr noundef %1228, i64 noundef %1224, ptr noundef %1229, ptr noundef %1218) #11, !noalias !19
  %1230 = icmp sgt i64 %1227, 0
  br i1 %1230, label %1231, label %1236

1231:                                             ; preds = %1222
  %1232 = load ptr, ptr %113, align 8, !noalias !19
  %1233 = load ptr, ptr %111, align 8, !noalias !19
  %1234 = shl nsw i64 %1224, 6
  %1235 = getelementptr inbounds i8, ptr %1218, i64 %1234
  call fastcc void @real_solve_columns(ptr noundef %1232, i64 noundef %1224, ptr noundef %1233, ptr noundef %1235, i64 noundef %1227) #11, !noalias !19
  br label %1236

1236:                                             ; preds = %1222, %1231
  %1237 = load ptr, ptr %19, align 8, !noalias !19
  %1238 = getelementptr inbounds i8, ptr %1237, i64 24
  %1239 = load i64, ptr %1238, align 8, !noalias !19
  %1240 = load ptr, ptr %114, align 8, !noalias !19
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %1218, ptr noundef %1240, ptr noundef nonnull %21, i64 noundef %1239) #11, !noalias !19
  %1241 = load <8 x double>, ptr %8, align 16, !noalias !19
  %1242 = getelementptr inbounds i8, ptr %1237, i64 8
  %1243 = load i64, ptr %1242, align 8, !noalias !19
  %1244 = add nsw i64 %1243, -3
  %1245 = getelementptr i8, ptr %1240, i64 64
  %1246 = getelementptr i8, ptr %1240, i64 128
  %1247 = getelementptr i8, ptr %1240, i64 192
  %1248 = icmp slt i64 %1239, %1244
  br i1 %1248, label %1256, label %1249

1249:                                             ; preds = %1256, %1236
  %1250 = phi <8 x double> [ zeroinitializer, %1236 ], [ %1266, %1256 ]
  %1251 = phi <8 x double> [ zeroinitializer, %1236 ], [ %1271, %1256 ]
  %1252 = phi <8 x double> [ zeroinitializer, %1236 ], [ %1276, %1256 ]
  %1253 = phi <8 x double> [ zeroinitializer, %1236 ], [ %1281, %1256 ]
  %1254 = phi i64 [ %1239, %1236 ], [ %1282, %1256 ]
  %1255 = icmp slt i64 %1254, %1243
  br i1 %1255, label %1284, label %1294

1256:                                             ; preds = %1236, %1256
  %1257 = phi i64 [ %1282, %1256 ], [ %1239, %1236 ]
  %1258 = phi <8 x double> [ %1281, %1256 ], [ zeroinitializer, %1236 ]
  %1259 = phi <8 x double> [ %1276, %1256 ], [ zeroinitializer, %1236 ]
  %1260 = phi <8 x double> [ %1271, %1256 ], [ zeroinitializer, %1236 ]
  %1261 = phi <8 x double> [ %1266, %1256 ], [ zeroinitializer, %1236 ]
  %1262 = shl nsw i64 %1257, 6
  %1263 = getelementptr inbounds i8, ptr %1240, i64 %1262
  %1264 = load <8 x double>, ptr %1263, align 8, !noalias !19
  %1265 = fmul <8 x double> %1264, zeroinitializer
  %1266 = fadd <8 x double> %1261, %1265
  %1267 = shl i64 %1257, 6
  %1268 = getelementptr i8, ptr %1245, i64 %1267
  %1269 = load <8 x double>, ptr %1268, align 8, !noalias !19
  %1270 = fmul <8 x double> %1269, zeroinitializer
  %1271 = fadd <8 x double> %1260, %1270
  %1272 = shl i64 %1257, 6
  %1273 = getelementptr i8, ptr %1246, i64 %1272
  %1274 = load <8 x double>, ptr %1273, align 8, !noalias !19
  %1275 = fmul <8 x double> %1274, zeroinitializer
  %1276 = fadd <8 x double> %1259, %1275
  %1277 = shl i64 %1257, 6
  %1278 = getelementptr i8, ptr %1247, i64 %1277
  %1279 = load <8 x double>, ptr %1278, align 8, !noalias !19
  %1280 = fmul <8 x double> %1279, zeroinitializer
  %1281 = fadd <8 x double> %1258, %1280
  %1282 = add nsw i64 %1257, 4
  %1283 = icmp slt i64 %1282, %1244
  br i1 %1283, label %1256, label %1249, !llvm.loop !54

1284:                                             ; preds = %1249, %1284
  %1285 = phi i64 [ %1292, %1284 ], [ %1254, %1249 ]
  %1286 = phi <8 x double> [ %1291, %1284 ], [ %1250, %1249 ]
  %1287 = shl nsw i64 %1285, 6
  %1288 = getelementptr inbounds i8, ptr %1240, i64 %1287
  %1289 = load <8 x double>, ptr %1288, align 8, !noalias !19
  %1290 = fmul <8 x double> %1289, zeroinitializer
  %1291 = fadd <8 x double> %1286, %1290
  %1292 = add nsw i64 %1285, 1
  %1293 = icmp eq i64 %1292, %1243
  br i1 %1293, label %1294, label %1284, !llvm.loop !55

1294:                                             ; preds = %1284, %1249
  %1295 = phi <8 x double> [ %1250, %1249 ], [ %1291, %1284 ]
  %1296 = fadd <8 x double> %1251, %1295
  %1297 = fadd <8 x double> %1252, %1253
  %1298 = fadd <8 x double> %1297, %1296
  %1299 = fadd <8 x double> %1241, %1298
  %1300 = getelementptr inbounds i8, ptr %1237, i64 48
  %1301 = load i64, ptr %1300, align 8, !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %6, i8 0, i64 512, i1 false), !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %7, i8 0, i64 512, i1 false), !noalias !19
  %1302 = icmp eq i64 %1301, 0
  br i1 %1302, label %1366, label %1303

1303:                                             ; preds = %1294
  %1304 = icmp slt i64 %1239, %1301
  br i1 %1304, label %1306, label %1305

1305:                                             ; preds = %1310, %1303
  br label %1357

1306:                                             ; preds = %1303
  %1307 = load ptr, ptr %21, align 8, !noalias !19
  %1308 = load ptr, ptr %115, align 8, !noalias !19
  %1309 = load ptr, ptr %66, align 8, !noalias !19
  br label %1310

1310:                                             ; preds = %1306, %1310
  %1311 = phi i64 [ %1239, %1306 ], [ %1342, %1310 ]
  %1312 = shl nsw i64 %1311, 6
  %1313 = getelementptr inbounds i8, ptr %1307, i64 %1312
  %1314 = load <8 x double>, ptr %1313, align 8, !noalias !19
  %1315 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1314)
  %1316 = getelementptr inbounds i8, ptr %1240, i64 %1312
  %1317 = load <8 x double>, ptr %1316, align 8, !noalias !19
  %1318 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1317)
  %1319 = fcmp ogt <8 x double> %1315, %1318
  %1320 = select <8 x i1> %1319, <8 x double> %1315, <8 x double> %1318
  %1321 = getelementptr inbounds i8, ptr %1308, i64 %1312
  %1322 = load <8 x double>, ptr %1321, align 8, !noalias !19
  %1323 = getelementptr inbounds double, ptr %1309, i64 %1311
  %1324 = load double, ptr %1323, align 8, !noalias !19
  %1325 = insertelement <8 x double> poison, double %1324, i64 0
  %1326 = shufflevector <8 x double> %1325, <8 x double> poison, <8 x i32> zeroinitializer
  %1327 = fmul <8 x double> %1320, %1326
  %1328 = fadd <8 x double> %1322, %1327
  %1329 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1328
  %1330 = getelementptr inbounds i8, ptr %1218, i64 %1312
  %1331 = load <8 x double>, ptr %1330, align 8, !noalias !19
  %1332 = fmul <8 x double> %1331, %1329
  %1333 = srem i64 %1311, 8
  %1334 = shl nsw i64 %1333, 6
  %1335 = getelementptr inbounds i8, ptr %6, i64 %1334
  %1336 = load <8 x double>, ptr %1335, align 16, !noalias !19
  %1337 = fmul <8 x double> %1332, %1332
  %1338 = fadd <8 x double> %1336, %1337
  store <8 x double> %1338, ptr %1335, align 16, !noalias !19
  %1339 = getelementptr inbounds i8, ptr %7, i64 %1334
  %1340 = load <8 x double>, ptr %1339, align 16, !noalias !19
  %1341 = fadd <8 x double> %1340, %1337
  store <8 x double> %1341, ptr %1339, align 16, !noalias !19
  %1342 = add nsw i64 %1311, 1
  %1343 = icmp eq i64 %1342, %1301
  br i1 %1343, label %1305, label %1310, !llvm.loop !56

1344:                                             ; preds = %1357
  %1345 = sub nsw i64 %1301, %1239
  %1346 = sitofp i64 %1345 to double
  %1347 = insertelement <8 x double> poison, double %1346, i64 0
  %1348 = shufflevector <8 x double> %1347, <8 x double> poison, <8 x i32> zeroinitializer
  %1349 = fdiv <8 x double> %1363, %1348
  %1350 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1349)
  %1351 = insertelement <8 x double> poison, double %279, i64 0
  %1352 = shufflevector <8 x double> %1351, <8 x double> poison, <8 x i32> zeroinitializer
  %1353 = fcmp olt <8 x double> %1352, %248
  %1354 = fcmp ogt <8 x double> %1350, %1299
  %1355 = select <8 x i1> %1353, <8 x i1> %1354, <8 x i1> zeroinitializer
  %1356 = select <8 x i1> %1355, <8 x double> %1350, <8 x double> %1299
  br label %1366

1357:                                             ; preds = %1305, %1357
  %1358 = phi i64 [ %1364, %1357 ], [ 0, %1305 ]
  %1359 = phi <8 x double> [ %1363, %1357 ], [ zeroinitializer, %1305 ]
  %1360 = shl nuw nsw i64 %1358, 6
  %1361 = getelementptr inbounds i8, ptr %6, i64 %1360
  %1362 = load <8 x double>, ptr %1361, align 16, !noalias !19
  %1363 = fadd <8 x double> %1359, %1362
  %1364 = add nuw nsw i64 %1358, 1
  %1365 = icmp eq i64 %1364, 8
  br i1 %1365, label %1344, label %1357, !llvm.loop !57

1366:                                             ; preds = %1294, %1344
  %1367 = phi <8 x double> [ %1299, %1294 ], [ %1356, %1344 ]
  %1368 = fcmp olt <8 x double> %1367, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1369 = bitcast <8 x i1> %1368 to i8
  %1370 = zext i8 %1369 to i64
  %1371 = xor i64 %1370, -1
  %1372 = and i64 %1213, %1371
  %1373 = and i64 %1372, %1116
  %1374 = and i64 %1116, %1370
  %1375 = icmp eq i64 %1373, 0
  br i1 %1375, label %1619, label %1376

1376:                                             ; preds = %1366
  %1377 = icmp sgt i64 %1216, 0
  br i1 %1377, label %1438, label %1406

1378:                                             ; preds = %1220, %1378
  %1379 = phi i64 [ 0, %1220 ], [ %1404, %1378 ]
  %1380 = load ptr, ptr %82, align 8, !noalias !19
  %1381 = shl nsw i64 %1379, 6
  %1382 = getelementptr inbounds i8, ptr %1380, i64 %1381
  %1383 = load <8 x double>, ptr %1382, align 8, !noalias !19
  %1384 = fmul <8 x double> %1383, <double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05>
  %1385 = add nuw nsw i64 %1379, %1216
  %1386 = shl nsw i64 %1385, 6
  %1387 = getelementptr inbounds i8, ptr %1380, i64 %1386
  %1388 = load <8 x double>, ptr %1387, align 8, !noalias !19
  %1389 = fmul <8 x double> %1388, <double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580>
  %1390 = fsub <8 x double> %1389, %1384
  %1391 = shl i64 %1379, 6
  %1392 = getelementptr i8, ptr %1380, i64 %1221
  %1393 = getelementptr i8, ptr %1392, i64 %1391
  %1394 = load <8 x double>, ptr %1393, align 8, !noalias !19
  %1395 = fmul <8 x double> %1394, <double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555>
  %1396 = fsub <8 x double> %1390, %1395
  %1397 = fdiv <8 x double> %1396, %248
  %1398 = getelementptr inbounds i8, ptr %1217, i64 %1381
  store <8 x double> %1397, ptr %1398, align 8, !noalias !19
  %1399 = load ptr, ptr %110, align 8, !noalias !19
  %1400 = getelementptr inbounds i8, ptr %1399, i64 %1381
  %1401 = load <8 x double>, ptr %1400, align 8, !noalias !19
  %1402 = fadd <8 x double> %1401, %1397
  %1403 = getelementptr inbounds i8, ptr %1218, i64 %1381
  store <8 x double> %1402, ptr %1403, align 8, !noalias !19
  %1404 = add nuw nsw i64 %1379, 1
  %1405 = icmp eq i64 %1404, %1216
  br i1 %1405, label %1222, label %1378, !llvm.loop !58

1406:                                             ; preds = %1438, %1376
  %1407 = trunc i64 %1373 to i8
  %1408 = bitcast i8 %1407 to <8 x i1>
  %1409 = select <8 x i1> %1408, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1410 = fadd <8 x double> %1121, %1409
  %1411 = load ptr, ptr %117, align 8, !noalias !19
  %1412 = load ptr, ptr %118, align 8, !noalias !19
  %1413 = load ptr, ptr %119, align 8, !noalias !19
  store <8 x double> %232, ptr %1413, align 8, !noalias !19
  %1414 = load ptr, ptr %19, align 8, !noalias !19
  %1415 = getelementptr inbounds i8, ptr %1414, i64 40
  %1416 = load i64, ptr %1415, align 8, !noalias !19
  %1417 = icmp eq i64 %1416, 0
  br i1 %1417, label %1419, label %1418

1418:                                             ; preds = %1406
  call fastcc void @settle(ptr noundef nonnull %19) #11, !noalias !19
  br label %1419

1419:                                             ; preds = %1418, %1406
  %1420 = load i64, ptr %120, align 8, !noalias !19
  %1421 = icmp sgt i64 %1420, 0
  br i1 %1421, label %1422, label %1423

1422:                                             ; preds = %1419
  call fastcc void @sample(ptr noundef nonnull %19) #11, !noalias !19
  br label %1423

1423:                                             ; preds = %1422, %1419
  %1424 = load ptr, ptr %19, align 8, !noalias !19
  %1425 = load i64, ptr %1424, align 8, !noalias !19
  %1426 = load ptr, ptr %119, align 8, !noalias !19
  %1427 = load ptr, ptr %121, align 8, !noalias !19
  %1428 = load ptr, ptr %122, align 8, !noalias !19
  %1429 = inttoptr i64 %1425 to ptr
  %1430 = load ptr, ptr %1429, align 8, !noalias !19
  %1431 = call i32 %1430(ptr noundef %1426, ptr noundef %1411, ptr noundef %1427, ptr noundef %1428, ptr noundef %1412) #12, !noalias !19
  %1432 = zext i32 %1431 to i64
  %1433 = and i64 %1373, %1432
  %1434 = trunc i64 %1433 to i8
  %1435 = bitcast i8 %1434 to <8 x i1>
  %1436 = select <8 x i1> %1435, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1205
  %1437 = icmp sgt i64 %1216, 0
  br i1 %1437, label %1607, label %1451

1438:                                             ; preds = %1376, %1438
  %1439 = phi i64 [ %1449, %1438 ], [ 0, %1376 ]
  %1440 = load ptr, ptr %116, align 8, !noalias !19
  %1441 = load ptr, ptr %21, align 8, !noalias !19
  %1442 = shl nsw i64 %1439, 6
  %1443 = getelementptr inbounds i8, ptr %1441, i64 %1442
  %1444 = load <8 x double>, ptr %1443, align 8, !noalias !19
  %1445 = getelementptr inbounds i8, ptr %1218, i64 %1442
  %1446 = load <8 x double>, ptr %1445, align 8, !noalias !19
  %1447 = fadd <8 x double> %1444, %1446
  %1448 = getelementptr inbounds i8, ptr %1440, i64 %1442
  store <8 x double> %1447, ptr %1448, align 8, !noalias !19
  %1449 = add nuw nsw i64 %1439, 1
  %1450 = icmp eq i64 %1449, %1216
  br i1 %1450, label %1406, label %1438, !llvm.loop !59

1451:                                             ; preds = %1607, %1423
  %1452 = load i64, ptr %112, align 8, !noalias !19
  %1453 = sdiv i64 %1452, 8
  %1454 = load ptr, ptr %65, align 8, !noalias !19
  %1455 = getelementptr inbounds i8, ptr %1454, i64 40
  %1456 = load i64, ptr %1455, align 8, !noalias !19
  %1457 = load ptr, ptr %113, align 8, !noalias !19
  %1458 = load ptr, ptr %111, align 8, !noalias !19
  call fastcc void @real_solve(ptr noundef %1457, i64 noundef %1453, ptr noundef %1458, ptr noundef %1218) #11, !noalias !19
  %1459 = icmp sgt i64 %1456, 0
  br i1 %1459, label %1460, label %1465

1460:                                             ; preds = %1451
  %1461 = load ptr, ptr %113, align 8, !noalias !19
  %1462 = load ptr, ptr %111, align 8, !noalias !19
  %1463 = shl nsw i64 %1453, 6
  %1464 = getelementptr inbounds i8, ptr %1218, i64 %1463
  call fastcc void @real_solve_columns(ptr noundef %1461, i64 noundef %1453, ptr noundef %1462, ptr noundef %1464, i64 noundef %1456) #11, !noalias !19
  br label %1465

1465:                                             ; preds = %1451, %1460
  %1466 = load ptr, ptr %19, align 8, !noalias !19
  %1467 = getelementptr inbounds i8, ptr %1466, i64 24
  %1468 = load i64, ptr %1467, align 8, !noalias !19
  %1469 = load ptr, ptr %114, align 8, !noalias !19
  call fastcc void @norm_to(ptr noundef nonnull %9, ptr noundef %1218, ptr noundef %1469, ptr noundef nonnull %21, i64 noundef %1468) #11, !noalias !19
  %1470 = load <8 x double>, ptr %9, align 16, !noalias !19
  %1471 = getelementptr inbounds i8, ptr %1466, i64 8
  %1472 = load i64, ptr %1471, align 8, !noalias !19
  %1473 = add nsw i64 %1472, -3
  %1474 = getelementptr i8, ptr %1469, i64 64
  %1475 = getelementptr i8, ptr %1469, i64 128
  %1476 = getelementptr i8, ptr %1469, i64 192
  %1477 = icmp slt i64 %1468, %1473
  br i1 %1477, label %1485, label %1478

1478:                                             ; preds = %1485, %1465
  %1479 = phi <8 x double> [ zeroinitializer, %1465 ], [ %1495, %1485 ]
  %1480 = phi <8 x double> [ zeroinitializer, %1465 ], [ %1500, %1485 ]
  %1481 = phi <8 x double> [ zeroinitializer, %1465 ], [ %1505, %1485 ]
  %1482 = phi <8 x double> [ zeroinitializer, %1465 ], [ %1510, %1485 ]
  %1483 = phi i64 [ %1468, %1465 ], [ %1511, %1485 ]
  %1484 = icmp slt i64 %1483, %1472
  br i1 %1484, label %1513, label %1523

1485:                                             ; preds = %1465, %1485
  %1486 = phi i64 [ %1511, %1485 ], [ %1468, %1465 ]
  %1487 = phi <8 x double> [ %1510, %1485 ], [ zeroinitializer, %1465 ]
  %1488 = phi <8 x double> [ %1505, %1485 ], [ zeroinitializer, %1465 ]
  %1489 = phi <8 x double> [ %1500, %1485 ], [ zeroinitializer, %1465 ]
  %1490 = phi <8 x double> [ %1495, %1485 ], [ zeroinitializer, %1465 ]
  %1491 = shl nsw i64 %1486, 6
  %1492 = getelementptr inbounds i8, ptr %1469, i64 %1491
  %1493 = load <8 x double>, ptr %1492, align 8, !noalias !19
  %1494 = fmul <8 x double> %1493, zeroinitializer
  %1495 = fadd <8 x double> %1490, %1494
  %1496 = shl i64 %1486, 6
  %1497 = getelementptr i8, ptr %1474, i64 %1496
  %1498 = load <8 x double>, ptr %1497, align 8, !noalias !19
  %1499 = fmul <8 x double> %1498, zeroinitializer
  %1500 = fadd <8 x double> %1489, %1499
  %1501 = shl i64 %1486, 6
  %1502 = getelementptr i8, ptr %1475, i64 %1501
  %1503 = load <8 x double>, ptr %1502, align 8, !noalias !19
  %1504 = fmul <8 x double> %1503, zeroinitializer
  %1505 = fadd <8 x double> %1488, %1504
  %1506 = shl i64 %1486, 6
  %1507 = getelementptr i8, ptr %1476, i64 %1506
  %1508 = load <8 x double>, ptr %1507, align 8, !noalias !19
  %1509 = fmul <8 x double> %1508, zeroinitializer
  %1510 = fadd <8 x double> %1487, %1509
  %1511 = add nsw i64 %1486, 4
  %1512 = icmp slt i64 %1511, %1473
  br i1 %1512, label %1485, label %1478, !llvm.loop !54

1513:                                             ; preds = %1478, %1513
  %1514 = phi i64 [ %1521, %1513 ], [ %1483, %1478 ]
  %1515 = phi <8 x double> [ %1520, %1513 ], [ %1479, %1478 ]
  %1516 = shl nsw i64 %1514, 6
  %1517 = getelementptr inbounds i8, ptr %1469, i64 %1516
  %1518 = load <8 x double>, ptr %1517, align 8, !noalias !19
  %1519 = fmul <8 x double> %1518, zeroinitializer
  %1520 = fadd <8 x double> %1515, %1519
  %1521 = add nsw i64 %1514, 1
  %1522 = icmp eq i64 %1521, %1472
  br i1 %1522, label %1523, label %1513, !llvm.loop !55

1523:                                             ; preds = %1513, %1478
  %1524 = phi <8 x double> [ %1479, %1478 ], [ %1520, %1513 ]
  %1525 = fadd <8 x double> %1480, %1524
  %1526 = fadd <8 x double> %1481, %1482
  %1527 = fadd <8 x double> %1526, %1525
  %1528 = fadd <8 x double> %1470, %1527
  %1529 = getelementptr inbounds i8, ptr %1466, i64 48
  %1530 = load i64, ptr %1529, align 8, !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %4, i8 0, i64 512, i1 false), !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %5, i8 0, i64 512, i1 false), !noalias !19
  %1531 = icmp eq i64 %1530, 0
  br i1 %1531, label %1595, label %1532

1532:                                             ; preds = %1523
  %1533 = icmp slt i64 %1468, %1530
  br i1 %1533, label %1535, label %1534

1534:                                             ; preds = %1539, %1532
  br label %1586

1535:                                             ; preds = %1532
  %1536 = load ptr, ptr %21, align 8, !noalias !19
  %1537 = load ptr, ptr %123, align 8, !noalias !19
  %1538 = load ptr, ptr %66, align 8, !noalias !19
  br label %1539

1539:                                             ; preds = %1535, %1539
  %1540 = phi i64 [ %1468, %1535 ], [ %1571, %1539 ]
  %1541 = shl nsw i64 %1540, 6
  %1542 = getelementptr inbounds i8, ptr %1536, i64 %1541
  %1543 = load <8 x double>, ptr %1542, align 8, !noalias !19
  %1544 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1543)
  %1545 = getelementptr inbounds i8, ptr %1469, i64 %1541
  %1546 = load <8 x double>, ptr %1545, align 8, !noalias !19
  %1547 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1546)
  %1548 = fcmp ogt <8 x double> %1544, %1547
  %1549 = select <8 x i1> %1548, <8 x double> %1544, <8 x double> %1547
  %1550 = getelementptr inbounds i8, ptr %1537, i64 %1541
  %1551 = load <8 x double>, ptr %1550, align 8, !noalias !19
  %1552 = getelementptr inbounds double, ptr %1538, i64 %1540
  %1553 = load double, ptr %1552, align 8, !noalias !19
  %1554 = insertelement <8 x double> poison, double %1553, i64 0
  %1555 = shufflevector <8 x double> %1554, <8 x double> poison, <8 x i32> zeroinitializer
  %1556 = fmul <8 x double> %1549, %1555
  %1557 = fadd <8 x double> %1551, %1556
  %1558 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1557
  %1559 = getelementptr inbounds i8, ptr %1218, i64 %1541
  %1560 = load <8 x double>, ptr %1559, align 8, !noalias !19
  %1561 = fmul <8 x double> %1560, %1558
  %1562 = srem i64 %1540, 8
  %1563 = shl nsw i64 %1562, 6
  %1564 = getelementptr inbounds i8, ptr %4, i64 %1563
  %1565 = load <8 x double>, ptr %1564, align 16, !noalias !19
  %1566 = fmul <8 x double> %1561, %1561
  %1567 = fadd <8 x double> %1565, %1566
  store <8 x double> %1567, ptr %1564, align 16, !noalias !19
  %1568 = getelementptr inbounds i8, ptr %5, i64 %1563
  %1569 = load <8 x double>, ptr %1568, align 16, !noalias !19
  %1570 = fadd <8 x double> %1569, %1566
  store <8 x double> %1570, ptr %1568, align 16, !noalias !19
  %1571 = add nsw i64 %1540, 1
  %1572 = icmp eq i64 %1571, %1530
  br i1 %1572, label %1534, label %1539, !llvm.loop !56

1573:                                             ; preds = %1586
  %1574 = sub nsw i64 %1530, %1468
  %1575 = sitofp i64 %1574 to double
  %1576 = insertelement <8 x double> poison, double %1575, i64 0
  %1577 = shufflevector <8 x double> %1576, <8 x double> poison, <8 x i32> zeroinitializer
  %1578 = fdiv <8 x double> %1592, %1577
  %1579 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1578)
  %1580 = insertelement <8 x double> poison, double %279, i64 0
  %1581 = shufflevector <8 x double> %1580, <8 x double> poison, <8 x i32> zeroinitializer
  %1582 = fcmp olt <8 x double> %1581, %248
  %1583 = fcmp ogt <8 x double> %1579, %1528
  %1584 = select <8 x i1> %1582, <8 x i1> %1583, <8 x i1> zeroinitializer
  %1585 = select <8 x i1> %1584, <8 x double> %1579, <8 x double> %1528
  br label %1595

1586:                                             ; preds = %1534, %1586
  %1587 = phi i64 [ %1593, %1586 ], [ 0, %1534 ]
  %1588 = phi <8 x double> [ %1592, %1586 ], [ zeroinitializer, %1534 ]
  %1589 = shl nuw nsw i64 %1587, 6
  %1590 = getelementptr inbounds i8, ptr %4, i64 %1589
  %1591 = load <8 x double>, ptr %1590, align 16, !noalias !19
  %1592 = fadd <8 x double> %1588, %1591
  %1593 = add nuw nsw i64 %1587, 1
  %1594 = icmp eq i64 %1593, 8
  br i1 %1594, label %1573, label %1586, !llvm.loop !57

1595:                                             ; preds = %1523, %1573
  %1596 = phi <8 x double> [ %1528, %1523 ], [ %1585, %1573 ]
  %1597 = xor i64 %1432, -1
  %1598 = and i64 %1373, %1597
  %1599 = fcmp olt <8 x double> %1596, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1600 = bitcast <8 x i1> %1599 to i8
  %1601 = zext i8 %1600 to i64
  %1602 = and i64 %1598, %1601
  %1603 = or i64 %1602, %1374
  %1604 = trunc i64 %1598 to i8
  %1605 = bitcast i8 %1604 to <8 x i1>
  %1606 = select <8 x i1> %1605, <8 x double> %1596, <8 x double> %1367
  br label %1619

1607:                                             ; preds = %1423, %1607
  %1608 = phi i64 [ %1617, %1607 ], [ 0, %1423 ]
  %1609 = load ptr, ptr %118, align 8, !noalias !19
  %1610 = shl nsw i64 %1608, 6
  %1611 = getelementptr inbounds i8, ptr %1609, i64 %1610
  %1612 = load <8 x double>, ptr %1611, align 8, !noalias !19
  %1613 = getelementptr inbounds i8, ptr %1217, i64 %1610
  %1614 = load <8 x double>, ptr %1613, align 8, !noalias !19
  %1615 = fadd <8 x double> %1612, %1614
  %1616 = getelementptr inbounds i8, ptr %1218, i64 %1610
  store <8 x double> %1615, ptr %1616, align 8, !noalias !19
  %1617 = add nuw nsw i64 %1608, 1
  %1618 = icmp eq i64 %1617, %1216
  br i1 %1618, label %1451, label %1607, !llvm.loop !60

1619:                                             ; preds = %1366, %1595
  %1620 = phi i64 [ %1374, %1366 ], [ %1603, %1595 ]
  %1621 = phi <8 x double> [ %1121, %1366 ], [ %1410, %1595 ]
  %1622 = phi <8 x double> [ %1205, %1366 ], [ %1436, %1595 ]
  %1623 = phi <8 x double> [ %1367, %1366 ], [ %1606, %1595 ]
  %1624 = fcmp olt <8 x double> %1623, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1625 = select <8 x i1> %1624, <8 x double> <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>, <8 x double> %1623
  %1626 = load ptr, ptr %74, align 8, !noalias !19
  %1627 = getelementptr inbounds i8, ptr %1626, i64 192
  %1628 = load <8 x double>, ptr %1627, align 8, !noalias !19
  %1629 = fadd <8 x double> %1118, <double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01>
  %1630 = fdiv <8 x double> <double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667>, %1629
  %1631 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1625)
  %1632 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1631)
  %1633 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1632
  %1634 = fmul <8 x double> %1630, %1633
  %1635 = fcmp ogt <8 x double> %1634, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1636 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1623)
  %1637 = fcmp one <8 x double> %1636, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1638 = select <8 x i1> %1635, <8 x double> %1634, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1639 = select <8 x i1> %1637, <8 x double> %1638, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1640 = fmul <8 x double> %1639, %248
  %1641 = getelementptr inbounds i8, ptr %1626, i64 128
  %1642 = load <8 x double>, ptr %1641, align 8, !noalias !19
  %1643 = fdiv <8 x double> %248, %1642
  %1644 = fdiv <8 x double> %1628, %1625
  %1645 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1644)
  %1646 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1645)
  %1647 = fmul <8 x double> %1643, %1646
  %1648 = fcmp ogt <8 x double> %1628, zeroinitializer
  %1649 = fcmp olt <8 x double> %1647, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1650 = select <8 x i1> %1648, <8 x i1> %1649, <8 x i1> zeroinitializer
  %1651 = select <8 x i1> %1650, <8 x double> %1647, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1652 = fmul <8 x double> %1634, %1651
  %1653 = fcmp olt <8 x double> %1652, <double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01>
  %1654 = bitcast <8 x double> %1652 to <8 x i64>
  %1655 = select <8 x i1> %1653, <8 x i64> %1654, <8 x i64> <i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520>
  %1656 = bitcast <8 x i64> %1655 to <8 x double>
  %1657 = fcmp ule <8 x double> %1656, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1658 = fcmp uge <8 x double> %1656, <double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00>
  %1659 = or <8 x i1> %1657, %1658
  %1660 = select <8 x i1> %1659, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %1124
  %1661 = load <8 x double>, ptr %1626, align 8, !noalias !19
  %1662 = fcmp ogt <8 x double> %1656, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1663 = bitcast <8 x i64> %1655 to <8 x double>
  %1664 = select <8 x i1> %1662, <8 x double> %1663, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1665 = fmul <8 x double> %1664, %248
  %1666 = trunc nuw i64 %1620 to i8
  %1667 = bitcast i8 %1666 to <8 x i1>
  %1668 = trunc i64 %1116 to i8
  %1669 = bitcast i8 %1668 to <8 x i1>
  %1670 = select <8 x i1> %1660, <8 x double> %1665, <8 x double> %1661
  %1671 = select <8 x i1> %1667, <8 x double> %1670, <8 x double> %1640
  %1672 = select <8 x i1> %1669, <8 x double> %1671, <8 x double> %1204
  %1673 = xor i64 %1620, -1
  %1674 = and i64 %1116, %1673
  %1675 = load ptr, ptr %65, align 8, !noalias !19
  %1676 = getelementptr inbounds i8, ptr %1675, i64 32
  %1677 = load i64, ptr %1676, align 8, !noalias !19
  %1678 = or i64 %1677, %1674
  store i64 %1678, ptr %1676, align 8, !noalias !19
  %1679 = load ptr, ptr %65, align 8, !noalias !19
  %1680 = getelementptr inbounds i8, ptr %1679, i64 8
  %1681 = load i64, ptr %1680, align 8, !noalias !19
  %1682 = xor i64 %1674, -1
  %1683 = and i64 %1681, %1682
  %1684 = getelementptr inbounds i8, ptr %1679, i64 16
  %1685 = load i64, ptr %1684, align 8, !noalias !19
  %1686 = xor i64 %1685, -1
  %1687 = and i64 %1674, %1686
  %1688 = or disjoint i64 %1687, %1683
  store i64 %1688, ptr %1680, align 8, !noalias !19
  br label %1705

1689:                                             ; preds = %1209, %1689
  %1690 = phi i64 [ 0, %1209 ], [ %1703, %1689 ]
  %1691 = load ptr, ptr %107, align 8, !noalias !19
  %1692 = load ptr, ptr %21, align 8, !noalias !19
  %1693 = shl nsw i64 %1690, 6
  %1694 = getelementptr inbounds i8, ptr %1692, i64 %1693
  %1695 = load <8 x double>, ptr %1694, align 8, !noalias !19
  %1696 = load ptr, ptr %82, align 8, !noalias !19
  %1697 = shl i64 %1690, 6
  %1698 = getelementptr i8, ptr %1696, i64 %1210
  %1699 = getelementptr i8, ptr %1698, i64 %1697
  %1700 = load <8 x double>, ptr %1699, align 8, !noalias !19
  %1701 = fadd <8 x double> %1695, %1700
  %1702 = getelementptr inbounds i8, ptr %1691, i64 %1693
  store <8 x double> %1701, ptr %1702, align 8, !noalias !19
  %1703 = add nuw nsw i64 %1690, 1
  %1704 = icmp eq i64 %1703, %284
  br i1 %1704, label %1211, label %1689, !llvm.loop !61

1705:                                             ; preds = %1619, %1203, %451, %353
  %1706 = phi i64 [ %142, %353 ], [ %142, %451 ], [ %1116, %1203 ], [ %1116, %1619 ]
  %1707 = phi i64 [ %143, %353 ], [ %143, %451 ], [ %1117, %1203 ], [ %1117, %1619 ]
  %1708 = phi <8 x double> [ %144, %353 ], [ %144, %451 ], [ %1118, %1203 ], [ %1118, %1619 ]
  %1709 = phi <8 x double> [ %145, %353 ], [ %145, %451 ], [ %1119, %1203 ], [ %1119, %1619 ]
  %1710 = phi <8 x double> [ %146, %353 ], [ %146, %451 ], [ %1120, %1203 ], [ %1120, %1619 ]
  %1711 = phi i8 [ 0, %353 ], [ 0, %451 ], [ %1125, %1203 ], [ %1125, %1619 ]
  %1712 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %353 ], [ %453, %451 ], [ %1205, %1203 ], [ %1622, %1619 ]
  %1713 = phi <8 x double> [ zeroinitializer, %353 ], [ zeroinitializer, %451 ], [ zeroinitializer, %1203 ], [ %1623, %1619 ]
  %1714 = phi <8 x double> [ %237, %353 ], [ %452, %451 ], [ %1204, %1203 ], [ %1672, %1619 ]
  %1715 = phi <8 x double> [ zeroinitializer, %353 ], [ zeroinitializer, %451 ], [ %1121, %1203 ], [ %1621, %1619 ]
  %1716 = phi i64 [ 0, %353 ], [ 0, %451 ], [ 0, %1203 ], [ %1620, %1619 ]
  %1717 = zext i8 %1711 to i64
  %1718 = load ptr, ptr %20, align 8, !noalias !62
  %1719 = getelementptr inbounds i8, ptr %1718, i64 72
  %1720 = load ptr, ptr %1719, align 8
  store <8 x i64> %247, ptr %1720, align 8
  %1721 = load ptr, ptr %124, align 8, !noalias !62
  %1722 = load <8 x double>, ptr %1721, align 8
  %1723 = fadd <8 x double> %1715, %1722
  store <8 x double> %1723, ptr %1721, align 8
  %1724 = icmp ne i64 %1716, 0
  %1725 = select i1 %51, i1 %1724, i1 false
  br i1 %1725, label %1726, label %1729

1726:                                             ; preds = %1705
  store <8 x double> %244, ptr %12, align 16
  %1727 = load ptr, ptr %125, align 8
  %1728 = call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef nonnull %12, ptr noundef %1727, i64 noundef %1716, i32 noundef 1) #11
  br label %1729

1729:                                             ; preds = %1726, %1705
  %1730 = phi i64 [ %1728, %1726 ], [ 0, %1705 ]
  %1731 = xor i64 %1730, -1
  %1732 = and i64 %1716, %1731
  %1733 = load ptr, ptr %19, align 8
  %1734 = getelementptr inbounds i8, ptr %1733, i64 8
  %1735 = load i64, ptr %1734, align 8
  %1736 = load i64, ptr %126, align 8
  %1737 = load ptr, ptr %127, align 8
  %1738 = trunc nuw i64 %1732 to i8
  %1739 = load ptr, ptr %128, align 8
  %1740 = load ptr, ptr %129, align 8
  %1741 = load ptr, ptr %130, align 8
  br label %1765

1742:                                             ; preds = %1765
  %1743 = bitcast i8 %1738 to <8 x i1>
  %1744 = icmp sgt i64 %1735, 0
  br i1 %1744, label %1745, label %1834

1745:                                             ; preds = %1742
  %1746 = load <2 x double>, ptr %2, align 16
  %1747 = shufflevector <2 x double> %1746, <2 x double> poison, <8 x i32> zeroinitializer
  %1748 = load <2 x double>, ptr %131, align 8
  %1749 = shufflevector <2 x double> %1748, <2 x double> poison, <8 x i32> zeroinitializer
  %1750 = load double, ptr %132, align 16
  %1751 = insertelement <8 x double> poison, double %1750, i64 0
  %1752 = shufflevector <8 x double> %1751, <8 x double> poison, <8 x i32> zeroinitializer
  %1753 = shl i64 %1735, 7
  %1754 = getelementptr i8, ptr %1737, i64 %1753
  %1755 = load <2 x double>, ptr %3, align 16
  %1756 = shufflevector <2 x double> %1755, <2 x double> poison, <8 x i32> zeroinitializer
  %1757 = load <2 x double>, ptr %133, align 8
  %1758 = shufflevector <2 x double> %1757, <2 x double> poison, <8 x i32> zeroinitializer
  %1759 = load double, ptr %134, align 16
  %1760 = insertelement <8 x double> poison, double %1759, i64 0
  %1761 = shufflevector <8 x double> %1760, <8 x double> poison, <8 x i32> zeroinitializer
  %1762 = getelementptr inbounds double, ptr %1739, i64 %1736
  %1763 = shl nsw i64 %1736, 4
  %1764 = getelementptr inbounds i8, ptr %1739, i64 %1763
  br label %1776

1765:                                             ; preds = %1729, %1765
  %1766 = phi i64 [ 0, %1729 ], [ %1774, %1765 ]
  %1767 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1766
  %1768 = getelementptr inbounds i8, ptr %1767, i64 8
  %1769 = load double, ptr %1768, align 8
  %1770 = getelementptr inbounds [3 x double], ptr %2, i64 0, i64 %1766
  store double %1769, ptr %1770, align 8
  %1771 = getelementptr inbounds i8, ptr %1767, i64 16
  %1772 = load double, ptr %1771, align 8
  %1773 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %1766
  store double %1772, ptr %1773, align 8
  %1774 = add nuw nsw i64 %1766, 1
  %1775 = icmp eq i64 %1774, 3
  br i1 %1775, label %1742, label %1765, !llvm.loop !63

1776:                                             ; preds = %1745, %1818
  %1777 = phi i64 [ 0, %1745 ], [ %1819, %1818 ]
  %1778 = shl nsw i64 %1777, 6
  %1779 = getelementptr inbounds i8, ptr %1737, i64 %1778
  %1780 = load <8 x double>, ptr %1779, align 8
  %1781 = fmul <8 x double> %1780, %1747
  %1782 = add nuw nsw i64 %1777, %1735
  %1783 = shl nsw i64 %1782, 6
  %1784 = getelementptr inbounds i8, ptr %1737, i64 %1783
  %1785 = load <8 x double>, ptr %1784, align 8
  %1786 = fmul <8 x double> %1785, %1749
  %1787 = fadd <8 x double> %1781, %1786
  %1788 = shl i64 %1777, 6
  %1789 = getelementptr i8, ptr %1754, i64 %1788
  %1790 = load <8 x double>, ptr %1789, align 8
  %1791 = fmul <8 x double> %1790, %1752
  %1792 = fadd <8 x double> %1787, %1791
  %1793 = fmul <8 x double> %1780, %1756
  %1794 = fmul <8 x double> %1785, %1758
  %1795 = fadd <8 x double> %1793, %1794
  %1796 = fmul <8 x double> %1790, %1761
  %1797 = fadd <8 x double> %1795, %1796
  %1798 = load ptr, ptr %135, align 8
  %1799 = getelementptr inbounds i8, ptr %1798, i64 %1778
  %1800 = load <8 x double>, ptr %1799, align 8
  %1801 = load ptr, ptr %21, align 8
  %1802 = getelementptr inbounds i8, ptr %1801, i64 %1778
  %1803 = load <8 x double>, ptr %1802, align 8
  %1804 = fsub <8 x double> %1800, %1803
  %1805 = getelementptr inbounds i8, ptr %1739, i64 %1778
  store <8 x double> %1804, ptr %1805, align 8
  %1806 = fneg <8 x double> %1792
  %1807 = fsub <8 x double> %1806, %1797
  %1808 = getelementptr inbounds i8, ptr %1762, i64 %1778
  store <8 x double> %1807, ptr %1808, align 8
  %1809 = fneg <8 x double> %1797
  %1810 = getelementptr inbounds i8, ptr %1764, i64 %1778
  store <8 x double> %1809, ptr %1810, align 8
  %1811 = load ptr, ptr %21, align 8
  %1812 = getelementptr inbounds i8, ptr %1811, i64 %1778
  %1813 = load <8 x i64>, ptr %1812, align 8
  %1814 = getelementptr inbounds i8, ptr %1740, i64 %1778
  %1815 = load <8 x i64>, ptr %1814, align 8
  %1816 = select <8 x i1> %1743, <8 x i64> %1813, <8 x i64> %1815
  store <8 x i64> %1816, ptr %1814, align 8
  %1817 = getelementptr i8, ptr %1739, i64 %1778
  br label %1821

1818:                                             ; preds = %1821
  %1819 = add nuw nsw i64 %1777, 1
  %1820 = icmp eq i64 %1819, %1735
  br i1 %1820, label %1834, label %1776, !llvm.loop !64

1821:                                             ; preds = %1776, %1821
  %1822 = phi i64 [ 0, %1776 ], [ %1823, %1821 ]
  %1823 = add nuw nsw i64 %1822, 1
  %1824 = mul nuw nsw i64 %1735, %1823
  %1825 = add nuw nsw i64 %1824, %1777
  %1826 = mul nsw i64 %1736, %1822
  %1827 = getelementptr double, ptr %1817, i64 %1826
  %1828 = load <8 x i64>, ptr %1827, align 8
  %1829 = shl nsw i64 %1825, 6
  %1830 = getelementptr inbounds i8, ptr %1740, i64 %1829
  %1831 = load <8 x i64>, ptr %1830, align 8
  %1832 = select <8 x i1> %1743, <8 x i64> %1828, <8 x i64> %1831
  store <8 x i64> %1832, ptr %1830, align 8
  %1833 = icmp eq i64 %1823, 3
  br i1 %1833, label %1818, label %1821, !llvm.loop !65

1834:                                             ; preds = %1818, %1742
  %1835 = fcmp olt <8 x double> %1713, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1836 = bitcast <8 x double> %1713 to <8 x i64>
  %1837 = select <8 x i1> %1835, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>, <8 x i64> %1836
  %1838 = getelementptr inbounds i8, ptr %1741, i64 64
  %1839 = load <8 x i64>, ptr %1838, align 8
  %1840 = select <8 x i1> %1743, <8 x i64> %247, <8 x i64> %1839
  store <8 x i64> %1840, ptr %1838, align 8
  %1841 = getelementptr inbounds i8, ptr %1741, i64 128
  %1842 = load <8 x i64>, ptr %1841, align 8
  %1843 = select <8 x i1> %1743, <8 x i64> %247, <8 x i64> %1842
  store <8 x i64> %1843, ptr %1841, align 8
  %1844 = getelementptr inbounds i8, ptr %1741, i64 192
  %1845 = load <8 x i64>, ptr %1844, align 8
  %1846 = select <8 x i1> %1743, <8 x i64> %1837, <8 x i64> %1845
  store <8 x i64> %1846, ptr %1844, align 8
  %1847 = load ptr, ptr %65, align 8
  %1848 = getelementptr inbounds i8, ptr %1847, i64 8
  %1849 = load i64, ptr %1848, align 8
  %1850 = xor i64 %1732, -1
  %1851 = and i64 %1849, %1850
  %1852 = and i64 %1732, %1717
  %1853 = or disjoint i64 %1851, %1852
  store i64 %1853, ptr %1848, align 8
  %1854 = load ptr, ptr %65, align 8
  %1855 = getelementptr inbounds i8, ptr %1854, i64 16
  %1856 = load i64, ptr %1855, align 8
  %1857 = and i64 %1856, %1850
  store i64 %1857, ptr %1855, align 8
  %1858 = load ptr, ptr %65, align 8
  %1859 = getelementptr inbounds i8, ptr %1858, i64 32
  %1860 = load i64, ptr %1859, align 8
  %1861 = and i64 %1860, %1850
  store i64 %1861, ptr %1859, align 8
  %1862 = icmp ne i64 %1732, 0
  %1863 = select i1 %52, i1 %1862, i1 false
  br i1 %1863, label %1864, label %1868

1864:                                             ; preds = %1834
  %1865 = call fastcc i64 @clear_lanes(ptr noundef %0) #11
  %1866 = xor i64 %1865, -1
  %1867 = and i64 %1732, %1866
  br label %1868

1868:                                             ; preds = %1834, %1864
  %1869 = phi i64 [ %1867, %1864 ], [ 0, %1834 ]
  store i64 0, ptr %17, align 8
  %1870 = load ptr, ptr %136, align 8
  %1871 = load <8 x double>, ptr %1870, align 8
  %1872 = fcmp olt <8 x double> %1871, %244
  %1873 = bitcast <8 x i1> %1872 to i8
  %1874 = zext i8 %1873 to i64
  %1875 = and i64 %1732, %1874
  %1876 = or i64 %1875, %1869
  %1877 = icmp eq i64 %1876, 0
  br i1 %1877, label %1912, label %1878

1878:                                             ; preds = %1868
  store <8 x double> %244, ptr %12, align 16
  %1879 = icmp eq i64 %1869, 0
  br i1 %1879, label %1882, label %1880

1880:                                             ; preds = %1878
  %1881 = call fastcc i64 @look_for_events(ptr noundef %0, ptr noundef nonnull %11, i64 noundef %1869, ptr noundef nonnull %12, ptr noundef nonnull %14, ptr noundef nonnull %16, ptr noundef nonnull %13, ptr noundef nonnull %17) #11
  br label %1882

1882:                                             ; preds = %1880, %1878
  %1883 = phi i64 [ %1881, %1880 ], [ 0, %1878 ]
  %1884 = load i64, ptr %17, align 8
  %1885 = xor i64 %1884, -1
  %1886 = and i64 %1876, %1885
  %1887 = icmp eq i64 %1883, 0
  %1888 = select i1 %1887, ptr null, ptr %13
  %1889 = call fastcc i64 @write_within(ptr noundef %0, ptr noundef nonnull %11, i64 noundef %1886, ptr noundef nonnull %12, ptr noundef %1888) #11
  %1890 = load <8 x double>, ptr %12, align 16
  br i1 %1887, label %1896, label %1891

1891:                                             ; preds = %1882
  %1892 = xor i64 %1889, -1
  %1893 = and i64 %1883, %1892
  %1894 = call fastcc i64 @end_within(ptr noundef %0, ptr noundef nonnull %11, i64 noundef %1893, ptr noundef nonnull %12, ptr noundef nonnull %13) #11
  %1895 = or i64 %1894, %1889
  br label %1896

1896:                                             ; preds = %1891, %1882
  %1897 = phi i64 [ %1895, %1891 ], [ %1889, %1882 ]
  %1898 = icmp ne i64 %1897, 0
  %1899 = select i1 %52, i1 %1898, i1 false
  br i1 %1899, label %1900, label %1905

1900:                                             ; preds = %1896
  call fastcc void @retire(ptr noundef %0, i64 noundef %1897, i64 noundef 6) #11
  %1901 = xor i64 %1897, -1
  %1902 = load i64, ptr %15, align 8
  %1903 = and i64 %1902, %1901
  store i64 %1903, ptr %15, align 8
  %1904 = and i64 %1883, %1901
  br label %1905

1905:                                             ; preds = %1900, %1896
  %1906 = phi i32 [ 1, %1900 ], [ %199, %1896 ]
  %1907 = phi i64 [ %1904, %1900 ], [ %1883, %1896 ]
  %1908 = or i64 %1897, %1730
  %1909 = or i64 %1897, %1884
  %1910 = xor i64 %1909, -1
  %1911 = and i64 %1732, %1910
  br label %1912

1912:                                             ; preds = %1905, %1868
  %1913 = phi <8 x double> [ %244, %1868 ], [ %1890, %1905 ]
  %1914 = phi i64 [ 0, %1868 ], [ %1884, %1905 ]
  %1915 = phi i64 [ %1730, %1868 ], [ %1908, %1905 ]
  %1916 = phi i32 [ %199, %1868 ], [ %1906, %1905 ]
  %1917 = phi i64 [ %1732, %1868 ], [ %1911, %1905 ]
  %1918 = phi i64 [ 0, %1868 ], [ %1907, %1905 ]
  %1919 = load ptr, ptr %136, align 8
  %1920 = load <8 x double>, ptr %1919, align 8
  %1921 = fcmp oeq <8 x double> %1920, %1913
  %1922 = bitcast <8 x i1> %1921 to i8
  %1923 = zext i8 %1922 to i64
  %1924 = and i64 %1917, %1923
  %1925 = icmp eq i64 %1924, 0
  br i1 %1925, label %1926, label %1985

1926:                                             ; preds = %1985, %1912
  %1927 = trunc nuw i64 %1917 to i8
  %1928 = bitcast i8 %1927 to <8 x i1>
  %1929 = load ptr, ptr %61, align 8
  %1930 = load <8 x double>, ptr %1929, align 8
  %1931 = select <8 x i1> %1928, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1932 = fadd <8 x double> %1931, %1930
  store <8 x double> %1932, ptr %1929, align 8
  %1933 = load ptr, ptr %62, align 8
  %1934 = load <8 x double>, ptr %1933, align 8
  %1935 = xor <8 x i1> %1928, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1936 = and <8 x i1> %230, %1935
  %1937 = select <8 x i1> %1936, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1938 = fadd <8 x double> %1937, %1934
  store <8 x double> %1938, ptr %1933, align 8
  %1939 = xor i64 %1917, -1
  %1940 = and i64 %228, %1939
  %1941 = or i64 %1915, %1914
  %1942 = and i64 %1940, %1941
  %1943 = trunc i64 %1915 to i8
  %1944 = bitcast i8 %1943 to <8 x i1>
  %1945 = trunc i64 %1942 to i8
  %1946 = bitcast i8 %1945 to <8 x i1>
  %1947 = fcmp oeq <8 x double> %1913, %235
  %1948 = load ptr, ptr %58, align 8
  %1949 = load <8 x double>, ptr %1948, align 8
  %1950 = fcmp ogt <8 x double> %1949, %1714
  %1951 = and <8 x i1> %1947, %1928
  %1952 = select <8 x i1> %1951, <8 x i1> %1950, <8 x i1> zeroinitializer
  %1953 = select <8 x i1> %1952, <8 x double> %1949, <8 x double> %1714
  %1954 = fmul <8 x double> %248, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1955 = select <8 x i1> %1946, <8 x double> %1954, <8 x double> %1953
  %1956 = select <8 x i1> %1944, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %1957 = bitcast <8 x double> %1712 to <8 x i64>
  %1958 = select <8 x i1> %1946, <8 x i64> %1956, <8 x i64> %1957
  %1959 = load ptr, ptr %138, align 8
  %1960 = trunc i64 %1940 to i8
  %1961 = bitcast i8 %1960 to <8 x i1>
  %1962 = load <8 x i64>, ptr %1959, align 8
  %1963 = select <8 x i1> %1961, <8 x i64> %1958, <8 x i64> %1962
  store <8 x i64> %1963, ptr %1959, align 8
  %1964 = load ptr, ptr %65, align 8
  %1965 = getelementptr inbounds i8, ptr %1964, i64 32
  %1966 = load i64, ptr %1965, align 8
  %1967 = or i64 %1966, %1942
  store i64 %1967, ptr %1965, align 8
  %1968 = load ptr, ptr %65, align 8
  %1969 = getelementptr inbounds i8, ptr %1968, i64 8
  %1970 = load i64, ptr %1969, align 8
  %1971 = xor i64 %1942, -1
  %1972 = and i64 %1970, %1971
  %1973 = getelementptr inbounds i8, ptr %1968, i64 16
  %1974 = load i64, ptr %1973, align 8
  %1975 = xor i64 %1974, -1
  %1976 = and i64 %1942, %1975
  %1977 = or disjoint i64 %1976, %1972
  store i64 %1977, ptr %1969, align 8
  %1978 = load ptr, ptr %130, align 8
  %1979 = getelementptr inbounds i8, ptr %1978, i64 64
  %1980 = load <8 x double>, ptr %1979, align 8
  %1981 = select <8 x i1> %1946, <8 x double> zeroinitializer, <8 x double> %1980
  store <8 x double> %1981, ptr %1979, align 8
  %1982 = load ptr, ptr %58, align 8
  store <8 x double> %1955, ptr %1982, align 8
  %1983 = load ptr, ptr %49, align 8
  %1984 = select <8 x i1> %1928, <8 x double> %1913, <8 x double> %232
  store <8 x double> %1984, ptr %1983, align 8
  br i1 %139, label %1997, label %1995

1985:                                             ; preds = %1912, %1985
  %1986 = phi i64 [ %1993, %1985 ], [ %1924, %1912 ]
  %1987 = load ptr, ptr %137, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %1987, i64 noundef %1986) #11
  %1988 = load ptr, ptr %136, align 8
  %1989 = load <8 x double>, ptr %1988, align 8
  %1990 = fcmp oeq <8 x double> %1989, %1913
  %1991 = bitcast <8 x i1> %1990 to i8
  %1992 = zext i8 %1991 to i64
  %1993 = and i64 %1986, %1992
  %1994 = icmp eq i64 %1993, 0
  br i1 %1994, label %1926, label %1985, !llvm.loop !66

1995:                                             ; preds = %1997, %1926
  %1996 = icmp eq i64 %1918, 0
  br i1 %1996, label %2019, label %2009

1997:                                             ; preds = %1926, %1997
  %1998 = phi i64 [ %2007, %1997 ], [ 0, %1926 ]
  %1999 = load ptr, ptr %21, align 8
  %2000 = load ptr, ptr %140, align 8
  %2001 = shl nsw i64 %1998, 6
  %2002 = getelementptr inbounds i8, ptr %2000, i64 %2001
  %2003 = load <8 x i64>, ptr %2002, align 8
  %2004 = getelementptr inbounds i8, ptr %1999, i64 %2001
  %2005 = load <8 x i64>, ptr %2004, align 8
  %2006 = select <8 x i1> %1928, <8 x i64> %2003, <8 x i64> %2005
  store <8 x i64> %2006, ptr %2004, align 8
  %2007 = add nuw nsw i64 %1998, 1
  %2008 = icmp eq i64 %2007, %25
  br i1 %2008, label %1995, label %1997, !llvm.loop !67

2009:                                             ; preds = %1995
  %2010 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %1918, ptr noundef nonnull %16) #11
  %2011 = icmp ne i32 %1916, 0
  %2012 = icmp ne i64 %2010, %1918
  %2013 = select i1 %2011, i1 true, i1 %2012
  %2014 = zext i1 %2013 to i32
  %2015 = trunc i64 %1918 to i8
  %2016 = bitcast i8 %2015 to <8 x i1>
  %2017 = xor <8 x i1> %2016, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %2018 = and <8 x i1> %2017, %1928
  br label %2019

2019:                                             ; preds = %2009, %1995
  %2020 = phi i32 [ %2014, %2009 ], [ %1916, %1995 ]
  %2021 = phi <8 x i1> [ %2018, %2009 ], [ %1928, %1995 ]
  %2022 = phi i64 [ %2010, %2009 ], [ %200, %1995 ]
  %2023 = bitcast <8 x i1> %2021 to i8
  %2024 = icmp eq i8 %2023, 0
  br i1 %2024, label %2028, label %2025

2025:                                             ; preds = %2019
  %2026 = zext i8 %2023 to i64
  %2027 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %11, i64 noundef %2026) #11
  br label %2028

2028:                                             ; preds = %2019, %2025
  %2029 = phi i64 [ %2027, %2025 ], [ 0, %2019 ]
  %2030 = icmp ne i32 %2020, 0
  %2031 = icmp ne i64 %2029, 0
  %2032 = or i1 %2030, %2031
  %2033 = zext i1 %2032 to i32
  %2034 = trunc nuw i64 %2029 to i8
  %2035 = bitcast i8 %2034 to <8 x i1>
  %2036 = xor <8 x i1> %2035, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %2037 = and <8 x i1> %2021, %2036
  %2038 = load ptr, ptr %136, align 8
  %2039 = load <8 x double>, ptr %2038, align 8
  %2040 = fcmp oeq <8 x double> %2039, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %2041 = select <8 x i1> %2040, <8 x i1> %2037, <8 x i1> zeroinitializer
  %2042 = bitcast <8 x i1> %2041 to i8
  %2043 = icmp eq i8 %2042, 0
  br i1 %2043, label %2046, label %2044

2044:                                             ; preds = %2028
  %2045 = zext i8 %2042 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %2045, i64 noundef 0) #11
  br label %2046

2046:                                             ; preds = %2044, %2028
  %2047 = phi i32 [ 1, %2044 ], [ %2033, %2028 ]
  br label %141

2048:                                             ; preds = %198, %223, %194
  %2049 = phi i64 [ 1, %194 ], [ 0, %223 ], [ 0, %198 ]
  ret i64 %2049
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 984
  %5 = getelementptr inbounds i8, ptr %0, i64 144
  %6 = getelementptr inbounds i8, ptr %0, i64 432
  %7 = load ptr, ptr %4, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 1152
  %9 = getelementptr inbounds i8, ptr %0, i64 1064
  %10 = getelementptr inbounds i8, ptr %0, i64 1056
  %11 = getelementptr inbounds i8, ptr %0, i64 936
  %12 = getelementptr inbounds i8, ptr %0, i64 1168
  %13 = getelementptr inbounds i8, ptr %0, i64 1072
  %14 = getelementptr inbounds i8, ptr %0, i64 1080
  %15 = getelementptr inbounds i8, ptr %0, i64 192
  %16 = getelementptr inbounds i8, ptr %0, i64 1096
  %17 = getelementptr inbounds i8, ptr %0, i64 1104
  %18 = getelementptr inbounds i8, ptr %0, i64 216
  %19 = getelementptr inbounds i8, ptr %0, i64 1120
  %20 = getelementptr inbounds i8, ptr %0, i64 1128
  %21 = getelementptr inbounds i8, ptr %0, i64 672
  %22 = getelementptr inbounds i8, ptr %0, i64 1144
  %23 = getelementptr inbounds i8, ptr %0, i64 1200
  %24 = getelementptr inbounds i8, ptr %0, i64 1728
  %25 = getelementptr inbounds i8, ptr %0, i64 1736
  %26 = getelementptr inbounds i8, ptr %0, i64 1216
  %27 = getelementptr inbounds i8, ptr %0, i64 1216
  %28 = getelementptr inbounds i8, ptr %0, i64 1232
  %29 = getelementptr inbounds i8, ptr %0, i64 1272
  %30 = getelementptr inbounds i8, ptr %0, i64 1224
  %31 = getelementptr inbounds i8, ptr %0, i64 1096
  %32 = getelementptr inbounds i8, ptr %0, i64 1256
  %33 = getelementptr inbounds i8, ptr %0, i64 1248
  %34 = getelementptr inbounds i8, ptr %0, i64 1264
  %35 = getelementptr inbounds i8, ptr %0, i64 1120
  %36 = getelementptr inbounds i8, ptr %0, i64 1488
  %37 = getelementptr inbounds i8, ptr %0, i64 1504
  %38 = getelementptr inbounds i8, ptr %0, i64 1440
  %39 = getelementptr inbounds i8, ptr %0, i64 1512
  %40 = getelementptr inbounds i8, ptr %0, i64 1528
  %41 = getelementptr inbounds i8, ptr %0, i64 1464
  %42 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %43

43:                                               ; preds = %2, %301
  %44 = phi i64 [ 0, %2 ], [ %311, %301 ]
  %45 = phi i64 [ 0, %2 ], [ %302, %301 ]
  %46 = phi i64 [ -1, %2 ], [ %310, %301 ]
  %47 = phi i64 [ 0, %2 ], [ %309, %301 ]
  %48 = load i64, ptr %7, align 8
  %49 = load i64, ptr %9, align 8
  %50 = icmp sge i64 %48, %49
  br i1 %50, label %83, label %51

51:                                               ; preds = %43
  %52 = load ptr, ptr %8, align 8
  %53 = load i64, ptr %12, align 8
  %54 = mul nsw i64 %53, %48
  %55 = getelementptr i64, ptr %52, i64 %54
  %56 = getelementptr i8, ptr %55, i64 24
  %57 = load i64, ptr %56, align 8
  %58 = icmp eq i64 %57, 0
  br i1 %58, label %83, label %78

59:                                               ; preds = %301
  store i64 %309, ptr %1, align 8
  %60 = icmp slt i64 %310, 0
  br i1 %60, label %434, label %61

61:                                               ; preds = %59
  %62 = getelementptr inbounds i8, ptr %0, i64 936
  %63 = getelementptr inbounds i8, ptr %0, i64 600
  %64 = getelementptr inbounds i8, ptr %0, i64 192
  %65 = getelementptr inbounds i8, ptr %0, i64 216
  %66 = getelementptr inbounds i8, ptr %0, i64 672
  %67 = getelementptr inbounds i8, ptr %0, i64 1144
  %68 = getelementptr inbounds i8, ptr %0, i64 720
  %69 = getelementptr inbounds i8, ptr %0, i64 816
  br label %336

70:                                               ; preds = %78
  %71 = load ptr, ptr %8, align 8
  %72 = load i64, ptr %12, align 8
  %73 = mul nsw i64 %72, %80
  %74 = getelementptr i64, ptr %71, i64 %73
  %75 = getelementptr i8, ptr %74, i64 24
  %76 = load i64, ptr %75, align 8
  %77 = icmp eq i64 %76, 0
  br i1 %77, label %83, label %78, !llvm.loop !68

78:                                               ; preds = %51, %70
  %79 = phi i64 [ %80, %70 ], [ %48, %51 ]
  %80 = add nsw i64 %79, 1
  store i64 %80, ptr %7, align 8
  %81 = load i64, ptr %9, align 8
  %82 = icmp sge i64 %80, %81
  br i1 %82, label %83, label %70, !llvm.loop !68

83:                                               ; preds = %78, %70, %51, %43
  %84 = phi i64 [ %48, %43 ], [ %48, %51 ], [ %80, %70 ], [ %80, %78 ]
  %85 = phi i1 [ %50, %43 ], [ %50, %51 ], [ %82, %70 ], [ %82, %78 ]
  %86 = load ptr, ptr %11, align 8
  %87 = getelementptr inbounds i64, ptr %86, i64 %44
  %88 = load i64, ptr %87, align 8
  %89 = icmp ne i64 %88, -1
  %90 = or i1 %85, %89
  br i1 %90, label %301, label %91

91:                                               ; preds = %83
  %92 = add nsw i64 %84, 1
  store i64 %92, ptr %7, align 8
  %93 = load ptr, ptr %11, align 8
  %94 = getelementptr inbounds i64, ptr %93, i64 %44
  store i64 %84, ptr %94, align 8
  %95 = load ptr, ptr %6, align 8
  %96 = load ptr, ptr %10, align 8
  %97 = load i64, ptr %13, align 8
  %98 = mul nsw i64 %97, %84
  %99 = getelementptr inbounds double, ptr %96, i64 %98
  %100 = getelementptr double, ptr %95, i64 %44
  %101 = icmp sgt i64 %97, 0
  br i1 %101, label %102, label %111

102:                                              ; preds = %91, %102
  %103 = phi i64 [ %108, %102 ], [ 0, %91 ]
  %104 = getelementptr inbounds double, ptr %99, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = shl i64 %103, 6
  %107 = getelementptr i8, ptr %100, i64 %106
  store double %105, ptr %107, align 8
  %108 = add nuw nsw i64 %103, 1
  %109 = load i64, ptr %13, align 8
  %110 = icmp slt i64 %108, %109
  br i1 %110, label %102, label %111, !llvm.loop !69

111:                                              ; preds = %102, %91
  %112 = load ptr, ptr %15, align 8
  %113 = load ptr, ptr %14, align 8
  %114 = load i64, ptr %16, align 8
  %115 = mul nsw i64 %114, %84
  %116 = getelementptr inbounds double, ptr %113, i64 %115
  %117 = getelementptr double, ptr %112, i64 %44
  %118 = icmp sgt i64 %114, 0
  br i1 %118, label %119, label %128

119:                                              ; preds = %111, %119
  %120 = phi i64 [ %125, %119 ], [ 0, %111 ]
  %121 = getelementptr inbounds double, ptr %116, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = shl i64 %120, 6
  %124 = getelementptr i8, ptr %117, i64 %123
  store double %122, ptr %124, align 8
  %125 = add nuw nsw i64 %120, 1
  %126 = load i64, ptr %16, align 8
  %127 = icmp slt i64 %125, %126
  br i1 %127, label %119, label %128, !llvm.loop !69

128:                                              ; preds = %119, %111
  %129 = load ptr, ptr %18, align 8
  %130 = load ptr, ptr %17, align 8
  %131 = load i64, ptr %19, align 8
  %132 = mul nsw i64 %131, %84
  %133 = getelementptr inbounds double, ptr %130, i64 %132
  %134 = getelementptr double, ptr %129, i64 %44
  %135 = icmp sgt i64 %131, 0
  br i1 %135, label %136, label %145

136:                                              ; preds = %128, %136
  %137 = phi i64 [ %142, %136 ], [ 0, %128 ]
  %138 = getelementptr inbounds double, ptr %133, i64 %137
  %139 = load double, ptr %138, align 8
  %140 = shl i64 %137, 6
  %141 = getelementptr i8, ptr %134, i64 %140
  store double %139, ptr %141, align 8
  %142 = add nuw nsw i64 %137, 1
  %143 = load i64, ptr %19, align 8
  %144 = icmp slt i64 %142, %143
  br i1 %144, label %136, label %145, !llvm.loop !69

145:                                              ; preds = %136, %128
  %146 = load ptr, ptr %21, align 8
  %147 = load ptr, ptr %5, align 8
  %148 = getelementptr inbounds i8, ptr %147, i64 24
  %149 = load i64, ptr %148, align 8
  %150 = shl nsw i64 %149, 6
  %151 = getelementptr inbounds i8, ptr %146, i64 %150
  %152 = load ptr, ptr %20, align 8
  %153 = load i64, ptr %22, align 8
  %154 = mul nsw i64 %153, %84
  %155 = getelementptr inbounds double, ptr %152, i64 %154
  %156 = getelementptr double, ptr %151, i64 %44
  %157 = icmp sgt i64 %153, 0
  br i1 %157, label %158, label %167

158:                                              ; preds = %145, %158
  %159 = phi i64 [ %164, %158 ], [ 0, %145 ]
  %160 = getelementptr inbounds double, ptr %155, i64 %159
  %161 = load double, ptr %160, align 8
  %162 = shl i64 %159, 6
  %163 = getelementptr i8, ptr %156, i64 %162
  store double %161, ptr %163, align 8
  %164 = add nuw nsw i64 %159, 1
  %165 = load i64, ptr %22, align 8
  %166 = icmp slt i64 %164, %165
  br i1 %166, label %158, label %167, !llvm.loop !69

167:                                              ; preds = %158, %145
  %168 = load ptr, ptr %24, align 8
  %169 = load i64, ptr %25, align 8
  %170 = getelementptr inbounds double, ptr %168, i64 %169
  %171 = load i64, ptr %26, align 8
  %172 = mul i64 %171, -64
  %173 = getelementptr inbounds i8, ptr %170, i64 %172
  %174 = load ptr, ptr %23, align 8
  %175 = mul nsw i64 %171, %84
  %176 = getelementptr inbounds double, ptr %174, i64 %175
  %177 = getelementptr double, ptr %173, i64 %44
  %178 = load i64, ptr %27, align 8
  %179 = icmp sgt i64 %178, 0
  br i1 %179, label %180, label %189

180:                                              ; preds = %167, %180
  %181 = phi i64 [ %186, %180 ], [ 0, %167 ]
  %182 = getelementptr inbounds double, ptr %176, i64 %181
  %183 = load double, ptr %182, align 8
  %184 = shl i64 %181, 6
  %185 = getelementptr i8, ptr %177, i64 %184
  store double %183, ptr %185, align 8
  %186 = add nuw nsw i64 %181, 1
  %187 = load i64, ptr %27, align 8
  %188 = icmp slt i64 %186, %187
  br i1 %188, label %180, label %189, !llvm.loop !69

189:                                              ; preds = %180, %167
  %190 = load i64, ptr %28, align 8
  %191 = icmp sgt i64 %190, 0
  br i1 %191, label %192, label %294

192:                                              ; preds = %189
  %193 = load ptr, ptr %30, align 8
  %194 = getelementptr inbounds i64, ptr %193, i64 %44
  %195 = load i64, ptr %194, align 8
  %196 = inttoptr i64 %195 to ptr
  %197 = load i64, ptr %31, align 8
  %198 = icmp sgt i64 %197, 0
  br i1 %198, label %199, label %201

199:                                              ; preds = %192
  %200 = getelementptr inbounds i8, ptr %196, i64 192
  br label %204

201:                                              ; preds = %204, %192
  %202 = load i64, ptr %32, align 8
  %203 = icmp sgt i64 %202, 0
  br i1 %203, label %225, label %217

204:                                              ; preds = %199, %204
  %205 = phi i64 [ %197, %199 ], [ %215, %204 ]
  %206 = phi i64 [ 0, %199 ], [ %214, %204 ]
  %207 = load ptr, ptr %14, align 8
  %208 = mul nsw i64 %205, %84
  %209 = getelementptr double, ptr %207, i64 %208
  %210 = getelementptr double, ptr %209, i64 %206
  %211 = load double, ptr %210, align 8
  %212 = load ptr, ptr %200, align 8
  %213 = getelementptr inbounds double, ptr %212, i64 %206
  store double %211, ptr %213, align 8
  %214 = add nuw nsw i64 %206, 1
  %215 = load i64, ptr %31, align 8
  %216 = icmp slt i64 %214, %215
  br i1 %216, label %204, label %201, !llvm.loop !71

217:                                              ; preds = %225, %201
  %218 = load ptr, ptr %29, align 8
  %219 = getelementptr inbounds i8, ptr %218, i64 8
  %220 = load i64, ptr %219, align 8
  %221 = icmp sgt i64 %220, 0
  br i1 %221, label %222, label %290

222:                                              ; preds = %217
  %223 = getelementptr inbounds i8, ptr %196, i64 1248
  %224 = getelementptr inbounds i8, ptr %196, i64 1008
  br label %245

225:                                              ; preds = %201, %225
  %226 = phi i64 [ %242, %225 ], [ 0, %201 ]
  %227 = load ptr, ptr %33, align 8
  %228 = load i64, ptr %34, align 8
  %229 = mul nsw i64 %228, %226
  %230 = getelementptr inbounds i64, ptr %227, i64 %229
  %231 = load i64, ptr %230, align 8
  %232 = inttoptr i64 %231 to ptr
  %233 = load ptr, ptr %232, align 8
  %234 = load ptr, ptr %17, align 8
  %235 = load i64, ptr %35, align 8
  %236 = mul nsw i64 %235, %84
  %237 = getelementptr inbounds double, ptr %234, i64 %236
  %238 = getelementptr i64, ptr %230, i64 %44
  %239 = getelementptr i8, ptr %238, i64 8
  %240 = load i64, ptr %239, align 8
  %241 = inttoptr i64 %240 to ptr
  tail call void %233(ptr noundef %237, ptr noundef %241) #12
  %242 = add nuw nsw i64 %226, 1
  %243 = load i64, ptr %32, align 8
  %244 = icmp slt i64 %242, %243
  br i1 %244, label %225, label %217, !llvm.loop !72

245:                                              ; preds = %222, %259
  %246 = phi i64 [ 0, %222 ], [ %268, %259 ]
  %247 = load ptr, ptr %36, align 8
  %248 = load i64, ptr %37, align 8
  %249 = mul nsw i64 %248, %84
  %250 = getelementptr i64, ptr %247, i64 %249
  %251 = getelementptr i64, ptr %250, i64 %246
  %252 = load i64, ptr %251, align 8
  %253 = sitofp i64 %252 to double
  %254 = load ptr, ptr %38, align 8
  %255 = shl i64 %246, 6
  %256 = getelementptr i8, ptr %254, i64 %255
  %257 = getelementptr double, ptr %256, i64 %44
  store double %253, ptr %257, align 8
  %258 = mul i64 %246, 800
  br label %273

259:                                              ; preds = %283
  %260 = load ptr, ptr %224, align 8
  %261 = shl nuw nsw i64 %246, 1
  %262 = or disjoint i64 %261, 1
  %263 = getelementptr inbounds double, ptr %260, i64 %262
  store double 0x7FF8000000000000, ptr %263, align 8
  %264 = load ptr, ptr %224, align 8
  %265 = getelementptr inbounds double, ptr %264, i64 %261
  store double 0x7FF8000000000000, ptr %265, align 8
  %266 = load ptr, ptr %41, align 8
  %267 = getelementptr inbounds double, ptr %266, i64 %44
  store double 0x7FF8000000000000, ptr %267, align 8
  %268 = add nuw nsw i64 %246, 1
  %269 = load ptr, ptr %29, align 8
  %270 = getelementptr inbounds i8, ptr %269, i64 8
  %271 = load i64, ptr %270, align 8
  %272 = icmp slt i64 %268, %271
  br i1 %272, label %245, label %290, !llvm.loop !73

273:                                              ; preds = %245, %283
  %274 = phi i64 [ 0, %245 ], [ %288, %283 ]
  %275 = icmp eq i64 %274, 0
  br i1 %275, label %276, label %283

276:                                              ; preds = %273
  %277 = load ptr, ptr %39, align 8
  %278 = load i64, ptr %40, align 8
  %279 = mul nsw i64 %278, %84
  %280 = getelementptr double, ptr %277, i64 %279
  %281 = getelementptr double, ptr %280, i64 %246
  %282 = load double, ptr %281, align 8
  br label %283

283:                                              ; preds = %276, %273
  %284 = phi double [ %282, %276 ], [ 0xFFF0000000000000, %273 ]
  %285 = load ptr, ptr %223, align 8
  %286 = getelementptr inbounds i8, ptr %285, i64 %258
  %287 = getelementptr inbounds double, ptr %286, i64 %274
  store double %284, ptr %287, align 8
  %288 = add nuw nsw i64 %274, 1
  %289 = icmp eq i64 %288, 100
  br i1 %289, label %259, label %273, !llvm.loop !74

290:                                              ; preds = %259, %217
  %291 = getelementptr inbounds i8, ptr %196, i64 648
  %292 = load ptr, ptr %291, align 8
  %293 = getelementptr inbounds i8, ptr %292, i64 80
  store i64 0, ptr %293, align 8
  br label %294

294:                                              ; preds = %290, %189
  %295 = load ptr, ptr %42, align 8
  %296 = load double, ptr %295, align 8
  %297 = load ptr, ptr %3, align 8
  %298 = getelementptr inbounds double, ptr %297, i64 %44
  store double %296, ptr %298, align 8
  %299 = shl nuw nsw i64 1, %44
  %300 = or i64 %299, %45
  br label %301

301:                                              ; preds = %83, %294
  %302 = phi i64 [ %300, %294 ], [ %45, %83 ]
  %303 = load ptr, ptr %11, align 8
  %304 = getelementptr inbounds i64, ptr %303, i64 %44
  %305 = load i64, ptr %304, align 8
  %306 = icmp sgt i64 %305, -1
  %307 = shl nuw nsw i64 1, %44
  %308 = select i1 %306, i64 %307, i64 0
  %309 = or i64 %308, %47
  %310 = select i1 %306, i64 %44, i64 %46
  %311 = add nuw nsw i64 %44, 1
  %312 = icmp eq i64 %311, 8
  br i1 %312, label %59, label %43, !llvm.loop !75

313:                                              ; preds = %431
  %314 = getelementptr inbounds i8, ptr %0, i64 272
  %315 = load i64, ptr %314, align 8
  %316 = icmp sgt i64 %315, 0
  br i1 %316, label %317, label %434

317:                                              ; preds = %313
  %318 = getelementptr inbounds i8, ptr %0, i64 264
  %319 = getelementptr inbounds i8, ptr %0, i64 216
  br label %320

320:                                              ; preds = %317, %320
  %321 = phi i64 [ 0, %317 ], [ %333, %320 ]
  %322 = load ptr, ptr %318, align 8
  %323 = shl nuw nsw i64 %321, 1
  %324 = getelementptr inbounds i64, ptr %322, i64 %323
  %325 = load i64, ptr %324, align 8
  %326 = inttoptr i64 %325 to ptr
  %327 = load ptr, ptr %326, align 8
  %328 = load ptr, ptr %319, align 8
  %329 = or disjoint i64 %323, 1
  %330 = getelementptr inbounds i64, ptr %322, i64 %329
  %331 = load i64, ptr %330, align 8
  %332 = inttoptr i64 %331 to ptr
  tail call void %327(ptr noundef %328, ptr noundef %332) #12
  %333 = add nuw nsw i64 %321, 1
  %334 = load i64, ptr %314, align 8
  %335 = icmp slt i64 %333, %334
  br i1 %335, label %320, label %434, !llvm.loop !76

336:                                              ; preds = %61, %431
  %337 = phi i64 [ 0, %61 ], [ %432, %431 ]
  %338 = load ptr, ptr %62, align 8
  %339 = getelementptr inbounds i64, ptr %338, i64 %337
  %340 = load i64, ptr %339, align 8
  %341 = icmp eq i64 %340, -1
  br i1 %341, label %342, label %431

342:                                              ; preds = %336
  %343 = load ptr, ptr %6, align 8
  %344 = load ptr, ptr %5, align 8
  %345 = getelementptr inbounds i8, ptr %344, i64 8
  %346 = load i64, ptr %345, align 8
  %347 = icmp sgt i64 %346, 0
  br i1 %347, label %348, label %357

348:                                              ; preds = %342, %348
  %349 = phi i64 [ %355, %348 ], [ 0, %342 ]
  %350 = shl i64 %349, 6
  %351 = getelementptr i8, ptr %343, i64 %350
  %352 = getelementptr double, ptr %351, i64 %310
  %353 = load double, ptr %352, align 8
  %354 = getelementptr double, ptr %351, i64 %337
  store double %353, ptr %354, align 8
  %355 = add nuw nsw i64 %349, 1
  %356 = icmp eq i64 %355, %346
  br i1 %356, label %357, label %348, !llvm.loop !77

357:                                              ; preds = %348, %342
  %358 = load ptr, ptr %63, align 8
  %359 = load ptr, ptr %5, align 8
  %360 = getelementptr inbounds i8, ptr %359, i64 8
  %361 = load i64, ptr %360, align 8
  %362 = icmp sgt i64 %361, 0
  br i1 %362, label %363, label %372

363:                                              ; preds = %357, %363
  %364 = phi i64 [ %370, %363 ], [ 0, %357 ]
  %365 = shl i64 %364, 6
  %366 = getelementptr i8, ptr %358, i64 %365
  %367 = getelementptr double, ptr %366, i64 %310
  %368 = load double, ptr %367, align 8
  %369 = getelementptr double, ptr %366, i64 %337
  store double %368, ptr %369, align 8
  %370 = add nuw nsw i64 %364, 1
  %371 = icmp eq i64 %370, %361
  br i1 %371, label %372, label %363, !llvm.loop !77

372:                                              ; preds = %363, %357
  %373 = load ptr, ptr %64, align 8
  %374 = load ptr, ptr %5, align 8
  %375 = getelementptr inbounds i8, ptr %374, i64 56
  %376 = load i64, ptr %375, align 8
  %377 = icmp sgt i64 %376, 0
  br i1 %377, label %378, label %387

378:                                              ; preds = %372, %378
  %379 = phi i64 [ %385, %378 ], [ 0, %372 ]
  %380 = shl i64 %379, 6
  %381 = getelementptr i8, ptr %373, i64 %380
  %382 = getelementptr double, ptr %381, i64 %310
  %383 = load double, ptr %382, align 8
  %384 = getelementptr double, ptr %381, i64 %337
  store double %383, ptr %384, align 8
  %385 = add nuw nsw i64 %379, 1
  %386 = icmp eq i64 %385, %376
  br i1 %386, label %387, label %378, !llvm.loop !77

387:                                              ; preds = %378, %372
  %388 = load ptr, ptr %65, align 8
  %389 = load ptr, ptr %5, align 8
  %390 = getelementptr inbounds i8, ptr %389, i64 64
  %391 = load i64, ptr %390, align 8
  %392 = icmp sgt i64 %391, 0
  br i1 %392, label %393, label %402

393:                                              ; preds = %387, %393
  %394 = phi i64 [ %400, %393 ], [ 0, %387 ]
  %395 = shl i64 %394, 6
  %396 = getelementptr i8, ptr %388, i64 %395
  %397 = getelementptr double, ptr %396, i64 %310
  %398 = load double, ptr %397, align 8
  %399 = getelementptr double, ptr %396, i64 %337
  store double %398, ptr %399, align 8
  %400 = add nuw nsw i64 %394, 1
  %401 = icmp eq i64 %400, %391
  br i1 %401, label %402, label %393, !llvm.loop !77

402:                                              ; preds = %393, %387
  %403 = load ptr, ptr %66, align 8
  %404 = load ptr, ptr %5, align 8
  %405 = getelementptr inbounds i8, ptr %404, i64 24
  %406 = load i64, ptr %405, align 8
  %407 = shl nsw i64 %406, 6
  %408 = getelementptr inbounds i8, ptr %403, i64 %407
  %409 = load i64, ptr %67, align 8
  %410 = icmp sgt i64 %409, 0
  br i1 %410, label %411, label %420

411:                                              ; preds = %402, %411
  %412 = phi i64 [ %418, %411 ], [ 0, %402 ]
  %413 = shl i64 %412, 6
  %414 = getelementptr i8, ptr %408, i64 %413
  %415 = getelementptr double, ptr %414, i64 %310
  %416 = load double, ptr %415, align 8
  %417 = getelementptr double, ptr %414, i64 %337
  store double %416, ptr %417, align 8
  %418 = add nuw nsw i64 %412, 1
  %419 = icmp eq i64 %418, %409
  br i1 %419, label %420, label %411, !llvm.loop !77

420:                                              ; preds = %411, %402
  %421 = load ptr, ptr %3, align 8
  %422 = getelementptr inbounds double, ptr %421, i64 %310
  %423 = load double, ptr %422, align 8
  %424 = getelementptr inbounds double, ptr %421, i64 %337
  store double %423, ptr %424, align 8
  %425 = load ptr, ptr %68, align 8
  %426 = getelementptr inbounds double, ptr %425, i64 %337
  store double 0.000000e+00, ptr %426, align 8
  %427 = load ptr, ptr %69, align 8
  %428 = getelementptr inbounds double, ptr %427, i64 %337
  store double 0x7FF0000000000000, ptr %428, align 8
  %429 = load ptr, ptr %62, align 8
  %430 = getelementptr inbounds i64, ptr %429, i64 %337
  store i64 -2, ptr %430, align 8
  br label %431

431:                                              ; preds = %336, %420
  %432 = add nuw nsw i64 %337, 1
  %433 = icmp eq i64 %432, 8
  br i1 %433, label %313, label %336, !llvm.loop !78

434:                                              ; preds = %320, %313, %59
  ret i64 %302
}

define internal fastcc void @start(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #3 {
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca [8 x double], align 16
  %8 = getelementptr inbounds i8, ptr %0, i64 696
  %9 = getelementptr inbounds i8, ptr %0, i64 984
  %10 = getelementptr inbounds i8, ptr %1, i64 16
  %11 = load ptr, ptr %10, align 8
  %12 = trunc i64 %2 to i8
  %13 = bitcast i8 %12 to <8 x i1>
  %14 = or i64 %3, %2
  %15 = trunc i64 %14 to i8
  %16 = bitcast i8 %15 to <8 x i1>
  %17 = load ptr, ptr %8, align 8
  %18 = load <8 x double>, ptr %17, align 8
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %7) #11
  %19 = getelementptr inbounds i8, ptr %1, i64 8
  %20 = load ptr, ptr %19, align 8
  %21 = load ptr, ptr %11, align 8
  %22 = getelementptr inbounds i8, ptr %11, i64 48
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %20, i64 24
  %25 = load ptr, ptr %24, align 8
  store <8 x double> %18, ptr %25, align 8
  %26 = load ptr, ptr %20, align 8
  %27 = getelementptr inbounds i8, ptr %26, i64 40
  %28 = load i64, ptr %27, align 8
  %29 = icmp eq i64 %28, 0
  br i1 %29, label %31, label %30

30:                                               ; preds = %4
  tail call fastcc void @settle(ptr noundef nonnull %20) #11
  br label %31

31:                                               ; preds = %30, %4
  %32 = getelementptr inbounds i8, ptr %20, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %20) #11
  br label %36

36:                                               ; preds = %31, %35
  %37 = load ptr, ptr %20, align 8
  %38 = load i64, ptr %37, align 8
  %39 = load ptr, ptr %24, align 8
  %40 = getelementptr inbounds i8, ptr %20, i64 48
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %20, i64 96
  %43 = load ptr, ptr %42, align 8
  %44 = inttoptr i64 %38 to ptr
  %45 = load ptr, ptr %44, align 8
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #12
  %47 = sext i32 %46 to i64
  %48 = load ptr, ptr %19, align 8
  %49 = load ptr, ptr %48, align 8
  %50 = getelementptr inbounds i8, ptr %49, i64 8
  %51 = load i64, ptr %50, align 8
  %52 = icmp sgt i64 %51, 0
  br i1 %52, label %53, label %55

53:                                               ; preds = %36
  %54 = getelementptr inbounds i8, ptr %11, i64 168
  br label %164

55:                                               ; preds = %164, %36
  %56 = getelementptr inbounds i8, ptr %0, i64 1008
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i8, ptr %57, i64 8
  %59 = load double, ptr %58, align 8
  %60 = fcmp oeq double %59, 0.000000e+00
  %61 = select i1 %60, i64 %14, i64 %3
  %62 = getelementptr inbounds i8, ptr %0, i64 720
  %63 = load ptr, ptr %62, align 8
  %64 = insertelement <8 x double> poison, double %59, i64 0
  %65 = load <8 x i64>, ptr %63, align 8
  %66 = bitcast <8 x double> %64 to <8 x i64>
  %67 = shufflevector <8 x i64> %66, <8 x i64> poison, <8 x i32> zeroinitializer
  %68 = select <8 x i1> %16, <8 x i64> %67, <8 x i64> %65
  store <8 x i64> %68, ptr %63, align 8
  %69 = load ptr, ptr %56, align 8
  %70 = load double, ptr %69, align 8
  %71 = load ptr, ptr %10, align 8
  %72 = load ptr, ptr %19, align 8
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 8
  %75 = load i64, ptr %74, align 8
  %76 = load ptr, ptr %71, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %76, ptr noundef %76, ptr noundef nonnull %71, i64 noundef %75) #11
  %77 = load <8 x double>, ptr %5, align 16
  %78 = getelementptr inbounds i8, ptr %71, i64 168
  %79 = load ptr, ptr %78, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %79, ptr noundef %76, ptr noundef nonnull %71, i64 noundef %75) #11
  %80 = load <8 x double>, ptr %6, align 16
  %81 = fcmp olt <8 x double> %77, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %82 = fcmp olt <8 x double> %80, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %83 = or <8 x i1> %82, %81
  %84 = insertelement <8 x double> poison, double %70, i64 0
  %85 = shufflevector <8 x double> %84, <8 x double> poison, <8 x i32> zeroinitializer
  %86 = fmul <8 x double> %77, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %87 = fdiv <8 x double> %86, %80
  %88 = bitcast <8 x double> %87 to <8 x i64>
  %89 = select <8 x i1> %83, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %88
  %90 = bitcast <8 x i64> %89 to <8 x double>
  %91 = fcmp olt <8 x double> %85, %90
  %92 = bitcast <8 x double> %85 to <8 x i64>
  %93 = select <8 x i1> %91, <8 x i64> %92, <8 x i64> %89
  %94 = bitcast <8 x i64> %93 to <8 x double>
  %95 = load ptr, ptr %62, align 8
  %96 = trunc i64 %61 to i8
  %97 = bitcast i8 %96 to <8 x i1>
  %98 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %18)
  %99 = fmul <8 x double> %98, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %100 = fcmp ogt <8 x double> %99, %94
  %101 = bitcast <8 x double> %99 to <8 x i64>
  %102 = select <8 x i1> %100, <8 x i64> %101, <8 x i64> %93
  %103 = bitcast <8 x i64> %102 to <8 x double>
  %104 = fcmp olt <8 x double> %85, %103
  %105 = select <8 x i1> %104, <8 x i64> %92, <8 x i64> %102
  %106 = load <8 x i64>, ptr %95, align 8
  %107 = select <8 x i1> %97, <8 x i64> %105, <8 x i64> %106
  store <8 x i64> %107, ptr %95, align 8
  %108 = getelementptr inbounds i8, ptr %0, i64 1752
  %109 = xor i64 %14, -1
  %110 = load ptr, ptr %108, align 8
  %111 = getelementptr inbounds i8, ptr %110, i64 16
  %112 = load i64, ptr %111, align 8
  %113 = and i64 %112, %109
  store i64 %113, ptr %111, align 8
  %114 = load ptr, ptr %108, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 32
  %116 = load i64, ptr %115, align 8
  %117 = or i64 %116, %14
  store i64 %117, ptr %115, align 8
  %118 = load ptr, ptr %108, align 8
  %119 = getelementptr inbounds i8, ptr %118, i64 8
  %120 = load i64, ptr %119, align 8
  %121 = and i64 %120, %109
  %122 = getelementptr inbounds i8, ptr %118, i64 16
  %123 = load i64, ptr %122, align 8
  %124 = xor i64 %123, -1
  %125 = and i64 %14, %124
  %126 = or disjoint i64 %125, %121
  store i64 %126, ptr %119, align 8
  %127 = getelementptr inbounds i8, ptr %0, i64 1776
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 64
  %130 = load <8 x double>, ptr %129, align 8
  %131 = select <8 x i1> %16, <8 x double> zeroinitializer, <8 x double> %130
  store <8 x double> %131, ptr %129, align 8
  %132 = load ptr, ptr %127, align 8
  %133 = getelementptr inbounds i8, ptr %132, i64 192
  %134 = load <8 x double>, ptr %133, align 8
  %135 = select <8 x i1> %16, <8 x double> zeroinitializer, <8 x double> %134
  store <8 x double> %135, ptr %133, align 8
  %136 = getelementptr inbounds i8, ptr %0, i64 840
  %137 = load ptr, ptr %136, align 8
  %138 = load <8 x double>, ptr %137, align 8
  %139 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %138
  store <8 x double> %139, ptr %137, align 8
  %140 = getelementptr inbounds i8, ptr %0, i64 864
  %141 = load ptr, ptr %140, align 8
  %142 = load <8 x double>, ptr %141, align 8
  %143 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %142
  store <8 x double> %143, ptr %141, align 8
  %144 = getelementptr inbounds i8, ptr %0, i64 888
  %145 = load ptr, ptr %144, align 8
  %146 = load <8 x double>, ptr %145, align 8
  %147 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %146
  store <8 x double> %147, ptr %145, align 8
  %148 = getelementptr inbounds i8, ptr %0, i64 912
  %149 = load ptr, ptr %148, align 8
  %150 = load ptr, ptr %62, align 8
  %151 = load <8 x double>, ptr %150, align 8
  %152 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %151, i32 384)
  %153 = select <8 x i1> %152, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %154 = load <8 x i64>, ptr %149, align 8
  %155 = select <8 x i1> %16, <8 x i64> %153, <8 x i64> %154
  store <8 x i64> %155, ptr %149, align 8
  %156 = icmp eq i64 %2, 0
  br i1 %156, label %205, label %157

157:                                              ; preds = %55
  %158 = getelementptr inbounds i8, ptr %0, i64 936
  %159 = getelementptr inbounds i8, ptr %0, i64 1032
  %160 = getelementptr inbounds i8, ptr %0, i64 1040
  %161 = getelementptr inbounds i8, ptr %0, i64 792
  %162 = getelementptr inbounds i8, ptr %0, i64 816
  %163 = getelementptr inbounds i8, ptr %0, i64 960
  br label %180

164:                                              ; preds = %53, %164
  %165 = phi i64 [ 0, %53 ], [ %174, %164 ]
  %166 = load ptr, ptr %54, align 8
  %167 = load ptr, ptr %22, align 8
  %168 = shl nsw i64 %165, 6
  %169 = getelementptr inbounds i8, ptr %167, i64 %168
  %170 = load <8 x i64>, ptr %169, align 8
  %171 = getelementptr inbounds i8, ptr %166, i64 %168
  %172 = load <8 x i64>, ptr %171, align 8
  %173 = select <8 x i1> %16, <8 x i64> %170, <8 x i64> %172
  store <8 x i64> %173, ptr %171, align 8
  %174 = add nuw nsw i64 %165, 1
  %175 = load ptr, ptr %19, align 8
  %176 = load ptr, ptr %175, align 8
  %177 = getelementptr inbounds i8, ptr %176, i64 8
  %178 = load i64, ptr %177, align 8
  %179 = icmp slt i64 %174, %178
  br i1 %179, label %164, label %55, !llvm.loop !79

180:                                              ; preds = %157, %180
  %181 = phi i64 [ %2, %157 ], [ %203, %180 ]
  %182 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %181, i1 true)
  %183 = load ptr, ptr %158, align 8
  %184 = getelementptr inbounds i64, ptr %183, i64 %182
  %185 = load i64, ptr %184, align 8
  %186 = load i64, ptr %160, align 8
  %187 = add nsw i64 %186, -1
  %188 = load ptr, ptr %161, align 8
  %189 = getelementptr inbounds double, ptr %188, i64 %182
  store double 0.000000e+00, ptr %189, align 8
  %190 = load ptr, ptr %159, align 8
  %191 = load double, ptr %190, align 8
  %192 = load ptr, ptr %162, align 8
  %193 = getelementptr inbounds double, ptr %192, i64 %182
  store double %191, ptr %193, align 8
  %194 = load ptr, ptr %9, align 8
  %195 = getelementptr inbounds i8, ptr %194, i64 24
  %196 = load i64, ptr %195, align 8
  %197 = shl i64 %185, 3
  %198 = mul i64 %197, %187
  %199 = add nsw i64 %196, %198
  %200 = load ptr, ptr %163, align 8
  %201 = getelementptr inbounds i64, ptr %200, i64 %182
  store i64 %199, ptr %201, align 8
  %202 = add nsw i64 %181, -1
  %203 = and i64 %202, %181
  %204 = icmp eq i64 %203, 0
  br i1 %204, label %205, label %180, !llvm.loop !80

205:                                              ; preds = %180, %55
  %206 = xor i64 %47, -1
  %207 = and i64 %206, %2
  %208 = icmp eq i64 %207, 0
  br i1 %208, label %212, label %209

209:                                              ; preds = %205
  %210 = getelementptr inbounds i8, ptr %0, i64 816
  %211 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %226

212:                                              ; preds = %226, %205
  %213 = and i64 %14, %47
  %214 = xor i64 %213, %14
  %215 = getelementptr inbounds i8, ptr %0, i64 816
  %216 = load ptr, ptr %215, align 8
  %217 = load <8 x double>, ptr %216, align 8
  %218 = fcmp oeq <8 x double> %217, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %219 = bitcast <8 x i1> %218 to i8
  %220 = zext i8 %219 to i64
  %221 = and i64 %214, %220
  %222 = load ptr, ptr %144, align 8
  %223 = load <8 x double>, ptr %222, align 8
  %224 = select <8 x i1> %16, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %225 = fadd <8 x double> %224, %223
  store <8 x double> %225, ptr %222, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %213, i64 noundef 3) #11
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %221, i64 noundef 0) #11
  ret void

226:                                              ; preds = %209, %226
  %227 = phi i64 [ %207, %209 ], [ %238, %226 ]
  %228 = load ptr, ptr %11, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %228, i64 noundef %227) #11
  %229 = load ptr, ptr %210, align 8
  %230 = load <8 x double>, ptr %229, align 8
  %231 = load ptr, ptr %211, align 8
  %232 = load double, ptr %231, align 8
  %233 = insertelement <8 x double> poison, double %232, i64 0
  %234 = shufflevector <8 x double> %233, <8 x double> poison, <8 x i32> zeroinitializer
  %235 = fcmp oeq <8 x double> %230, %234
  %236 = bitcast <8 x i1> %235 to i8
  %237 = zext i8 %236 to i64
  %238 = and i64 %227, %237
  %239 = icmp eq i64 %238, 0
  br i1 %239, label %212, label %226, !llvm.loop !81
}

define internal fastcc void @hold_all(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 392
  %5 = getelementptr inbounds i8, ptr %0, i64 384
  %6 = getelementptr inbounds i8, ptr %0, i64 408
  br label %8

7:                                                ; preds = %49
  ret void

8:                                                ; preds = %2, %49
  %9 = phi i64 [ 0, %2 ], [ %52, %49 ]
  %10 = load ptr, ptr %3, align 8
  %11 = getelementptr inbounds double, ptr %10, i64 %9
  %12 = load double, ptr %11, align 8
  %13 = load i64, ptr %4, align 8
  %14 = icmp eq i64 %13, 0
  br i1 %14, label %49, label %15

15:                                               ; preds = %8
  %16 = icmp sgt i64 %13, 0
  br i1 %16, label %17, label %32

17:                                               ; preds = %15
  %18 = load ptr, ptr %5, align 8
  br label %19

19:                                               ; preds = %17, %19
  %20 = phi i64 [ 0, %17 ], [ %30, %19 ]
  %21 = phi i64 [ %13, %17 ], [ %29, %19 ]
  %22 = add nuw nsw i64 %20, %21
  %23 = lshr i64 %22, 1
  %24 = mul i64 %23, 24
  %25 = getelementptr inbounds i8, ptr %18, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %12
  %28 = add nuw nsw i64 %23, 1
  %29 = select i1 %27, i64 %23, i64 %21
  %30 = select i1 %27, i64 %20, i64 %28
  %31 = icmp slt i64 %30, %29
  br i1 %31, label %19, label %32, !llvm.loop !82

32:                                               ; preds = %19, %15
  %33 = phi i64 [ 0, %15 ], [ %30, %19 ]
  %34 = load ptr, ptr %5, align 8
  %35 = mul i64 %33, 24
  %36 = getelementptr inbounds i8, ptr %34, i64 %35
  %37 = icmp slt i64 %33, %13
  br i1 %37, label %38, label %41

38:                                               ; preds = %32
  %39 = getelementptr inbounds i8, ptr %36, i64 8
  %40 = load double, ptr %39, align 8
  br label %41

41:                                               ; preds = %38, %32
  %42 = phi double [ %40, %38 ], [ 0x7FF0000000000000, %32 ]
  %43 = load ptr, ptr %6, align 8
  %44 = getelementptr inbounds double, ptr %43, i64 %9
  store double %42, ptr %44, align 8
  %45 = load i64, ptr %4, align 8
  %46 = icmp slt i64 %33, %45
  br i1 %46, label %47, label %49

47:                                               ; preds = %41
  %48 = load double, ptr %36, align 8
  br label %49

49:                                               ; preds = %8, %41, %47
  %50 = phi double [ 0x7FF0000000000000, %8 ], [ %48, %47 ], [ 0x7FF0000000000000, %41 ]
  %51 = getelementptr inbounds double, ptr %1, i64 %9
  store double %50, ptr %51, align 8
  %52 = add nuw nsw i64 %9, 1
  %53 = icmp eq i64 %52, 8
  br i1 %53, label %7, label %8, !llvm.loop !83
}

define internal fastcc void @retire(ptr noundef readonly %0, i64 noundef %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 696
  %5 = getelementptr inbounds i8, ptr %0, i64 984
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = load ptr, ptr %5, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 32
  %12 = load i64, ptr %11, align 8
  %13 = icmp eq i64 %1, 0
  br i1 %13, label %60, label %14

14:                                               ; preds = %3
  %15 = getelementptr inbounds i8, ptr %0, i64 936
  %16 = getelementptr inbounds i8, ptr %0, i64 960
  %17 = getelementptr inbounds i8, ptr %0, i64 1040
  %18 = getelementptr inbounds i8, ptr %0, i64 792
  %19 = icmp sgt i64 %9, 0
  %20 = getelementptr inbounds i8, ptr %0, i64 1152
  %21 = getelementptr inbounds i8, ptr %0, i64 1168
  %22 = getelementptr inbounds i8, ptr %0, i64 840
  %23 = getelementptr inbounds i8, ptr %0, i64 864
  %24 = getelementptr inbounds i8, ptr %0, i64 888
  %25 = icmp slt i64 %2, 0
  %26 = getelementptr inbounds i8, ptr %0, i64 912
  %27 = getelementptr inbounds i8, ptr %0, i64 1176
  %28 = getelementptr inbounds i8, ptr %0, i64 1728
  %29 = getelementptr inbounds i8, ptr %0, i64 1736
  %30 = getelementptr inbounds i8, ptr %0, i64 1216
  %31 = getelementptr inbounds i8, ptr %0, i64 1200
  %32 = getelementptr inbounds i8, ptr %0, i64 1216
  %33 = getelementptr inbounds i8, ptr %0, i64 1232
  %34 = getelementptr inbounds i8, ptr %0, i64 1272
  %35 = getelementptr inbounds i8, ptr %0, i64 1440
  %36 = getelementptr inbounds i8, ptr %0, i64 1488
  %37 = getelementptr inbounds i8, ptr %0, i64 1504
  %38 = getelementptr inbounds i8, ptr %0, i64 1224
  %39 = getelementptr inbounds i8, ptr %0, i64 1536
  %40 = getelementptr inbounds i8, ptr %0, i64 1552
  br label %41

41:                                               ; preds = %14, %175
  %42 = phi i64 [ %1, %14 ], [ %179, %175 ]
  %43 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %42, i1 true)
  %44 = load ptr, ptr %15, align 8
  %45 = getelementptr inbounds i64, ptr %44, i64 %43
  %46 = load i64, ptr %45, align 8
  %47 = load i64, ptr %17, align 8
  %48 = load ptr, ptr %18, align 8
  %49 = getelementptr inbounds double, ptr %48, i64 %43
  %50 = load double, ptr %49, align 8
  %51 = fptosi double %50 to i64
  %52 = xor i64 %51, -1
  %53 = add i64 %47, %52
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %64

55:                                               ; preds = %41
  %56 = load ptr, ptr %16, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %43
  %58 = load i64, ptr %57, align 8
  %59 = inttoptr i64 %58 to ptr
  br label %61

60:                                               ; preds = %175, %3
  ret void

61:                                               ; preds = %55, %83
  %62 = phi i64 [ %84, %83 ], [ %53, %55 ]
  %63 = phi ptr [ %85, %83 ], [ %59, %55 ]
  br i1 %19, label %87, label %83

64:                                               ; preds = %83, %41
  %65 = load ptr, ptr %20, align 8
  %66 = load i64, ptr %21, align 8
  %67 = mul nsw i64 %66, %46
  %68 = getelementptr inbounds i64, ptr %65, i64 %67
  %69 = load ptr, ptr %22, align 8
  %70 = getelementptr inbounds double, ptr %69, i64 %43
  %71 = load double, ptr %70, align 8
  %72 = fptosi double %71 to i64
  store i64 %72, ptr %68, align 8
  %73 = load ptr, ptr %23, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %43
  %75 = load double, ptr %74, align 8
  %76 = fptosi double %75 to i64
  %77 = getelementptr inbounds i8, ptr %68, i64 8
  store i64 %76, ptr %77, align 8
  %78 = load ptr, ptr %24, align 8
  %79 = getelementptr inbounds double, ptr %78, i64 %43
  %80 = load double, ptr %79, align 8
  %81 = fptosi double %80 to i64
  %82 = getelementptr inbounds i8, ptr %68, i64 16
  store i64 %81, ptr %82, align 8
  br i1 %25, label %93, label %98

83:                                               ; preds = %87, %61
  %84 = add nsw i64 %62, -1
  %85 = getelementptr inbounds i8, ptr %63, i64 8
  %86 = icmp sgt i64 %62, 1
  br i1 %86, label %61, label %64, !llvm.loop !84

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !85

93:                                               ; preds = %64
  %94 = load ptr, ptr %26, align 8
  %95 = getelementptr inbounds double, ptr %94, i64 %43
  %96 = load double, ptr %95, align 8
  %97 = fptosi double %96 to i64
  br label %98

98:                                               ; preds = %64, %93
  %99 = phi i64 [ %97, %93 ], [ %2, %64 ]
  %100 = getelementptr inbounds i8, ptr %68, i64 24
  store i64 %99, ptr %100, align 8
  %101 = load ptr, ptr %4, align 8
  %102 = getelementptr inbounds double, ptr %101, i64 %43
  %103 = load double, ptr %102, align 8
  %104 = load ptr, ptr %27, align 8
  %105 = getelementptr inbounds double, ptr %104, i64 %46
  store double %103, ptr %105, align 8
  %106 = load ptr, ptr %28, align 8
  %107 = load i64, ptr %29, align 8
  %108 = getelementptr inbounds double, ptr %106, i64 %107
  %109 = load i64, ptr %30, align 8
  %110 = mul i64 %109, -64
  %111 = getelementptr inbounds i8, ptr %108, i64 %110
  %112 = load ptr, ptr %31, align 8
  %113 = mul nsw i64 %109, %46
  %114 = getelementptr inbounds double, ptr %112, i64 %113
  %115 = getelementptr double, ptr %111, i64 %43
  %116 = load i64, ptr %32, align 8
  %117 = icmp sgt i64 %116, 0
  br i1 %117, label %118, label %127

118:                                              ; preds = %98, %118
  %119 = phi i64 [ %124, %118 ], [ 0, %98 ]
  %120 = shl i64 %119, 6
  %121 = getelementptr i8, ptr %115, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %114, i64 %119
  store double %122, ptr %123, align 8
  %124 = add nuw nsw i64 %119, 1
  %125 = load i64, ptr %32, align 8
  %126 = icmp slt i64 %124, %125
  br i1 %126, label %118, label %127, !llvm.loop !86

127:                                              ; preds = %118, %98
  %128 = load i64, ptr %33, align 8
  %129 = icmp sgt i64 %128, 0
  br i1 %129, label %130, label %175

130:                                              ; preds = %127
  %131 = load ptr, ptr %34, align 8
  %132 = getelementptr inbounds i8, ptr %131, i64 8
  %133 = load i64, ptr %132, align 8
  %134 = icmp sgt i64 %133, 0
  br i1 %134, label %135, label %174

135:                                              ; preds = %130, %150
  %136 = phi i64 [ %156, %150 ], [ 2, %130 ]
  %137 = phi i64 [ %151, %150 ], [ 0, %130 ]
  %138 = load ptr, ptr %35, align 8
  %139 = shl i64 %137, 6
  %140 = getelementptr i8, ptr %138, i64 %139
  %141 = getelementptr double, ptr %140, i64 %43
  %142 = load double, ptr %141, align 8
  %143 = fptosi double %142 to i64
  %144 = load ptr, ptr %36, align 8
  %145 = load i64, ptr %37, align 8
  %146 = mul nsw i64 %145, %46
  %147 = getelementptr i64, ptr %144, i64 %146
  %148 = getelementptr i64, ptr %147, i64 %137
  store i64 %143, ptr %148, align 8
  %149 = shl nuw nsw i64 %137, 1
  br label %157

150:                                              ; preds = %157
  %151 = add nuw nsw i64 %137, 1
  %152 = load ptr, ptr %34, align 8
  %153 = getelementptr inbounds i8, ptr %152, i64 8
  %154 = load i64, ptr %153, align 8
  %155 = icmp slt i64 %151, %154
  %156 = add nuw i64 %136, 2
  br i1 %155, label %135, label %174, !llvm.loop !87

157:                                              ; preds = %135, %157
  %158 = phi i64 [ %149, %135 ], [ %172, %157 ]
  %159 = load ptr, ptr %38, align 8
  %160 = getelementptr inbounds i64, ptr %159, i64 %43
  %161 = load i64, ptr %160, align 8
  %162 = inttoptr i64 %161 to ptr
  %163 = getelementptr inbounds i8, ptr %162, i64 1008
  %164 = load ptr, ptr %163, align 8
  %165 = getelementptr inbounds double, ptr %164, i64 %158
  %166 = load double, ptr %165, align 8
  %167 = load ptr, ptr %39, align 8
  %168 = load i64, ptr %40, align 8
  %169 = mul nsw i64 %168, %46
  %170 = getelementptr double, ptr %167, i64 %169
  %171 = getelementptr double, ptr %170, i64 %158
  store double %166, ptr %171, align 8
  %172 = add nuw nsw i64 %158, 1
  %173 = icmp eq i64 %172, %136
  br i1 %173, label %150, label %157, !llvm.loop !88

174:                                              ; preds = %150, %130
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %43) #11
  br label %175

175:                                              ; preds = %174, %127
  %176 = load ptr, ptr %15, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %43
  store i64 -1, ptr %177, align 8
  %178 = add nsw i64 %42, -1
  %179 = and i64 %178, %42
  %180 = icmp eq i64 %179, 0
  br i1 %180, label %60, label %41, !llvm.loop !89
}

define internal fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1680
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 56
  %9 = load i64, ptr %8, align 8
  %10 = icmp eq i32 %4, 0
  br i1 %10, label %14, label %11

11:                                               ; preds = %5
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  %13 = load ptr, ptr %12, align 8
  br label %14

14:                                               ; preds = %5, %11
  %15 = phi ptr [ %13, %11 ], [ null, %5 ]
  %16 = inttoptr i64 %9 to ptr
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #12
  ret i64 %17
}

define internal fastcc range(i64 0, 256) i64 @clear_lanes(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 432
  %3 = getelementptr inbounds i8, ptr %0, i64 1272
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 1224
  %6 = load ptr, ptr %5, align 8
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 864
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %4, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 504
  %14 = load ptr, ptr %13, align 8
  %15 = load <8 x double>, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %4, i64 24
  %17 = load i64, ptr %16, align 8
  %18 = icmp eq i64 %17, 0
  br i1 %18, label %140, label %19

19:                                               ; preds = %1
  %20 = getelementptr inbounds i8, ptr %0, i64 1376
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 1368
  %25 = getelementptr inbounds i8, ptr %0, i64 456
  %26 = getelementptr inbounds i8, ptr %0, i64 1968
  %27 = getelementptr inbounds i8, ptr %0, i64 144
  %28 = getelementptr inbounds i8, ptr %0, i64 1320
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  br label %63

30:                                               ; preds = %83, %19
  %31 = getelementptr inbounds i8, ptr %0, i64 1320
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %4, i64 32
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %4, i64 40
  %36 = load i64, ptr %35, align 8
  %37 = add nsw i64 %36, %34
  %38 = shl nsw i64 %37, 6
  %39 = getelementptr inbounds i8, ptr %32, i64 %38
  store <8 x double> %15, ptr %39, align 8
  %40 = getelementptr inbounds i8, ptr %0, i64 168
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %0, i64 696
  %43 = load ptr, ptr %42, align 8
  %44 = load <8 x double>, ptr %43, align 8
  store <8 x double> %44, ptr %41, align 8
  %45 = load i64, ptr %16, align 8
  %46 = load ptr, ptr %40, align 8
  %47 = load ptr, ptr %2, align 8
  %48 = load ptr, ptr %31, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 1344
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 1416
  %52 = load ptr, ptr %51, align 8
  %53 = inttoptr i64 %45 to ptr
  %54 = load ptr, ptr %53, align 8
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #12
  %56 = trunc i32 %55 to i8
  %57 = xor i8 %56, -1
  %58 = icmp sgt i64 %12, 0
  br i1 %58, label %59, label %111

59:                                               ; preds = %30
  %60 = bitcast i8 %57 to <8 x i1>
  %61 = sext <8 x i1> %60 to <8 x i64>
  %62 = getelementptr inbounds i8, ptr %0, i64 1440
  br label %114

63:                                               ; preds = %23, %83
  %64 = phi i64 [ 0, %23 ], [ %90, %83 ]
  %65 = load ptr, ptr %24, align 8
  %66 = getelementptr inbounds i64, ptr %65, i64 %64
  %67 = load i64, ptr %66, align 8
  %68 = load ptr, ptr %25, align 8
  %69 = shl nsw i64 %67, 6
  %70 = getelementptr inbounds i8, ptr %68, i64 %69
  %71 = load <8 x double>, ptr %70, align 8
  %72 = load ptr, ptr %2, align 8
  %73 = getelementptr inbounds i8, ptr %72, i64 %69
  %74 = load <8 x double>, ptr %73, align 8
  %75 = fsub <8 x double> %71, %74
  %76 = fneg <8 x double> %75
  %77 = fcmp ogt <8 x double> %75, zeroinitializer
  %78 = select <8 x i1> %77, <8 x double> %75, <8 x double> %76
  %79 = load ptr, ptr %26, align 8
  %80 = load ptr, ptr %27, align 8
  %81 = getelementptr inbounds i8, ptr %80, i64 8
  %82 = load i64, ptr %81, align 8
  br label %93

83:                                               ; preds = %93
  %84 = load ptr, ptr %28, align 8
  %85 = load i64, ptr %29, align 8
  %86 = add nsw i64 %85, %67
  %87 = fmul <8 x double> %105, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  %88 = shl nsw i64 %86, 6
  %89 = getelementptr inbounds i8, ptr %84, i64 %88
  store <8 x double> %87, ptr %89, align 8
  %90 = add nuw nsw i64 %64, 1
  %91 = load i64, ptr %20, align 8
  %92 = icmp slt i64 %90, %91
  br i1 %92, label %63, label %30, !llvm.loop !90

93:                                               ; preds = %63, %93
  %94 = phi i64 [ 0, %63 ], [ %106, %93 ]
  %95 = phi <8 x double> [ %78, %63 ], [ %105, %93 ]
  %96 = mul nsw i64 %82, %94
  %97 = add nsw i64 %96, %67
  %98 = shl nsw i64 %97, 6
  %99 = getelementptr inbounds i8, ptr %79, i64 %98
  %100 = load <8 x double>, ptr %99, align 8
  %101 = fneg <8 x double> %100
  %102 = fcmp ogt <8 x double> %100, zeroinitializer
  %103 = select <8 x i1> %102, <8 x double> %100, <8 x double> %101
  %104 = fcmp ogt <8 x double> %95, %103
  %105 = select <8 x i1> %104, <8 x double> %95, <8 x double> %103
  %106 = add nuw nsw i64 %94, 1
  %107 = icmp eq i64 %106, 3
  br i1 %107, label %83, label %93, !llvm.loop !91

108:                                              ; preds = %136
  %109 = icmp ne <8 x i64> %137, zeroinitializer
  %110 = bitcast <8 x i1> %109 to i8
  br label %111

111:                                              ; preds = %108, %30
  %112 = phi i8 [ %57, %30 ], [ %110, %108 ]
  %113 = zext i8 %112 to i64
  br label %140

114:                                              ; preds = %59, %136
  %115 = phi i64 [ 0, %59 ], [ %138, %136 ]
  %116 = phi <8 x i64> [ %61, %59 ], [ %137, %136 ]
  %117 = getelementptr inbounds i64, ptr %10, i64 %115
  %118 = load i64, ptr %117, align 8
  %119 = and i64 %118, 2
  %120 = icmp eq i64 %119, 0
  br i1 %120, label %121, label %136

121:                                              ; preds = %114
  %122 = load ptr, ptr %51, align 8
  %123 = shl nsw i64 %115, 6
  %124 = getelementptr inbounds i8, ptr %122, i64 %123
  %125 = load <8 x double>, ptr %124, align 8
  %126 = load ptr, ptr %62, align 8
  %127 = getelementptr inbounds i8, ptr %126, i64 %123
  %128 = load <8 x double>, ptr %127, align 8
  %129 = fmul <8 x double> %125, %128
  %130 = add nuw nsw i64 %115, %12
  %131 = shl nsw i64 %130, 6
  %132 = getelementptr inbounds i8, ptr %122, i64 %131
  %133 = load <8 x double>, ptr %132, align 8
  %134 = fcmp ogt <8 x double> %129, %133
  %135 = select <8 x i1> %134, <8 x i64> %116, <8 x i64> zeroinitializer
  br label %136

136:                                              ; preds = %114, %121
  %137 = phi <8 x i64> [ %116, %114 ], [ %135, %121 ]
  %138 = add nuw nsw i64 %115, 1
  %139 = icmp eq i64 %138, %12
  br i1 %139, label %108, label %114, !llvm.loop !92

140:                                              ; preds = %1, %111
  %141 = phi i64 [ %113, %111 ], [ 0, %1 ]
  ret i64 %141
}

define internal fastcc i64 @look_for_events(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) unnamed_addr #3 {
  br label %21

9:                                                ; preds = %21
  %10 = load <8 x double>, ptr %3, align 8
  %11 = load <8 x double>, ptr %4, align 8
  %12 = fcmp oeq <8 x double> %10, %11
  %13 = bitcast <8 x i1> %12 to i8
  %14 = zext i8 %13 to i64
  %15 = xor i64 %14, -1
  %16 = and i64 %15, %2
  %17 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %16, ptr noundef nonnull %3) #11
  %18 = xor i64 %17, -1
  %19 = and i64 %18, %2
  %20 = icmp eq i64 %19, 0
  br i1 %20, label %48, label %26

21:                                               ; preds = %8, %21
  %22 = phi i64 [ 0, %8 ], [ %24, %21 ]
  %23 = getelementptr inbounds double, ptr %6, i64 %22
  store double 1.000000e+00, ptr %23, align 8
  %24 = add nuw nsw i64 %22, 1
  %25 = icmp eq i64 %24, 8
  br i1 %25, label %9, label %21, !llvm.loop !93

26:                                               ; preds = %9, %51
  %27 = phi i64 [ %53, %51 ], [ %19, %9 ]
  %28 = phi i64 [ %46, %51 ], [ 0, %9 ]
  %29 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %27, i1 true)
  %30 = getelementptr inbounds double, ptr %3, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %6, i64 %29
  %33 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %29, double noundef %31, ptr noundef %32) #11
  %34 = getelementptr inbounds i64, ptr %5, i64 %29
  store i64 %33, ptr %34, align 8
  %35 = icmp eq i64 %33, -6
  %36 = zext i1 %35 to i64
  %37 = shl nuw i64 %36, %29
  %38 = load i64, ptr %7, align 8
  %39 = or i64 %37, %38
  store i64 %39, ptr %7, align 8
  %40 = load i64, ptr %34, align 8
  %41 = icmp ne i64 %40, 0
  %42 = icmp ne i64 %40, -6
  %43 = and i1 %41, %42
  %44 = zext i1 %43 to i64
  %45 = shl nuw i64 %44, %29
  %46 = or i64 %45, %28
  %47 = icmp eq i64 %40, -6
  br i1 %47, label %50, label %51

48:                                               ; preds = %51, %9
  %49 = phi i64 [ 0, %9 ], [ %46, %51 ]
  ret i64 %49

50:                                               ; preds = %26
  store double 1.000000e+00, ptr %32, align 8
  br label %51

51:                                               ; preds = %26, %50
  %52 = add nsw i64 %27, -1
  %53 = and i64 %52, %27
  %54 = icmp eq i64 %53, 0
  br i1 %54, label %48, label %26, !llvm.loop !94
}

define internal fastcc i64 @write_within(ptr noundef %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef %3, ptr noundef readonly %4) unnamed_addr #3 {
  %6 = alloca [8 x i64], align 16
  %7 = getelementptr inbounds i8, ptr %0, i64 696
  %8 = load ptr, ptr %7, align 8
  %9 = load <8 x double>, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 16
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 72
  %13 = load ptr, ptr %12, align 8
  %14 = load <8 x double>, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 792
  %16 = load ptr, ptr %15, align 8
  %17 = load <8 x double>, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 816
  %19 = load ptr, ptr %18, align 8
  %20 = load <8 x double>, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %11, i64 48
  %22 = load ptr, ptr %21, align 8
  %23 = load <8 x double>, ptr %3, align 8
  %24 = icmp eq ptr %4, null
  br i1 %24, label %31, label %25

25:                                               ; preds = %5
  %26 = load <8 x double>, ptr %4, align 8
  %27 = fcmp olt <8 x double> %26, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %28 = fmul <8 x double> %14, %26
  %29 = fadd <8 x double> %9, %28
  %30 = select <8 x i1> %27, <8 x double> %29, <8 x double> %23
  store <8 x double> %30, ptr %3, align 8
  br label %31

31:                                               ; preds = %25, %5
  %32 = phi <8 x double> [ %30, %25 ], [ %23, %5 ]
  %33 = phi <8 x i1> [ %27, %25 ], [ zeroinitializer, %5 ]
  %34 = getelementptr inbounds i8, ptr %0, i64 960
  %35 = load ptr, ptr %34, align 8
  br label %39

36:                                               ; preds = %39
  %37 = getelementptr inbounds i8, ptr %1, i64 8
  %38 = getelementptr inbounds i8, ptr %0, i64 1680
  br label %46

39:                                               ; preds = %31, %39
  %40 = phi i64 [ 0, %31 ], [ %44, %39 ]
  %41 = getelementptr inbounds i64, ptr %35, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %40
  store i64 %42, ptr %43, align 8
  %44 = add nuw nsw i64 %40, 1
  %45 = icmp eq i64 %44, 8
  br i1 %45, label %36, label %39, !llvm.loop !95

46:                                               ; preds = %36, %92
  %47 = phi i64 [ %59, %92 ], [ %2, %36 ]
  %48 = phi i64 [ %93, %92 ], [ 0, %36 ]
  %49 = load ptr, ptr %18, align 8
  %50 = load <8 x double>, ptr %49, align 8
  %51 = fcmp olt <8 x double> %50, %32
  %52 = fcmp oeq <8 x double> %50, %32
  %53 = select <8 x i1> %52, <8 x i1> %33, <8 x i1> zeroinitializer
  %54 = select <8 x i1> %51, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %53
  %55 = bitcast <8 x i1> %54 to i8
  %56 = zext i8 %55 to i64
  %57 = xor i64 %48, -1
  %58 = and i64 %47, %57
  %59 = and i64 %58, %56
  %60 = icmp eq i64 %59, 0
  br i1 %60, label %61, label %65

61:                                               ; preds = %46
  %62 = icmp eq i64 %48, 0
  br i1 %62, label %112, label %63

63:                                               ; preds = %61
  %64 = getelementptr inbounds i8, ptr %0, i64 960
  br label %96

65:                                               ; preds = %46
  %66 = fsub <8 x double> %50, %9
  %67 = fdiv <8 x double> %66, %14
  %68 = load ptr, ptr %10, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 96
  %70 = load ptr, ptr %69, align 8
  store <8 x double> %67, ptr %70, align 8
  %71 = load ptr, ptr %68, align 8
  %72 = getelementptr inbounds i8, ptr %68, i64 192
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds i8, ptr %68, i64 8
  %75 = load i64, ptr %74, align 8
  %76 = load ptr, ptr %1, align 8
  %77 = load ptr, ptr %76, align 8
  %78 = getelementptr inbounds i8, ptr %77, i64 24
  %79 = load i64, ptr %78, align 8
  %80 = load ptr, ptr %69, align 8
  %81 = load ptr, ptr %37, align 8
  %82 = load ptr, ptr %81, align 8
  %83 = getelementptr inbounds i8, ptr %82, i64 16
  %84 = load i64, ptr %83, align 8
  tail call fastcc void @nested(ptr noundef %22, ptr noundef %71, ptr noundef %73, i64 noundef %75, i64 noundef %79, ptr noundef %80, i64 noundef %84) #11
  %85 = load ptr, ptr %38, align 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp eq i64 %86, 1
  br i1 %87, label %88, label %92

88:                                               ; preds = %65
  %89 = load ptr, ptr %18, align 8
  %90 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %89, ptr noundef %22, i64 noundef %59, i32 noundef 0) #11
  %91 = or i64 %90, %48
  br label %92

92:                                               ; preds = %88, %65
  %93 = phi i64 [ %91, %88 ], [ %48, %65 ]
  %94 = xor i64 %93, -1
  %95 = and i64 %59, %94
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %95) #11
  br label %46, !llvm.loop !96

96:                                               ; preds = %63, %96
  %97 = phi i64 [ %48, %63 ], [ %110, %96 ]
  %98 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %97, i1 true)
  %99 = extractelement <8 x double> %17, i64 %98
  %100 = load ptr, ptr %15, align 8
  %101 = getelementptr inbounds double, ptr %100, i64 %98
  store double %99, ptr %101, align 8
  %102 = extractelement <8 x double> %20, i64 %98
  %103 = load ptr, ptr %18, align 8
  %104 = getelementptr inbounds double, ptr %103, i64 %98
  store double %102, ptr %104, align 8
  %105 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %98
  %106 = load i64, ptr %105, align 8
  %107 = load ptr, ptr %64, align 8
  %108 = getelementptr inbounds i64, ptr %107, i64 %98
  store i64 %106, ptr %108, align 8
  %109 = add nsw i64 %97, -1
  %110 = and i64 %109, %97
  %111 = icmp eq i64 %110, 0
  br i1 %111, label %112, label %96, !llvm.loop !97

112:                                              ; preds = %96, %61
  ret i64 %48
}

define internal fastcc i64 @end_within(ptr noundef %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef %3, ptr noundef readonly %4) unnamed_addr #3 {
  %6 = getelementptr inbounds i8, ptr %1, i64 16
  %7 = load ptr, ptr %6, align 8
  %8 = trunc i64 %2 to i8
  %9 = bitcast i8 %8 to <8 x i1>
  %10 = load <8 x double>, ptr %4, align 8
  %11 = fcmp olt <8 x double> %10, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %12 = and <8 x i1> %11, %9
  %13 = select <8 x i1> %12, <8 x double> %10, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %14 = getelementptr inbounds i8, ptr %7, i64 48
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %7, i64 96
  %17 = load ptr, ptr %16, align 8
  store <8 x double> %13, ptr %17, align 8
  %18 = load ptr, ptr %7, align 8
  %19 = getelementptr inbounds i8, ptr %7, i64 192
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %7, i64 8
  %22 = load i64, ptr %21, align 8
  %23 = load ptr, ptr %1, align 8
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %24, i64 24
  %26 = load i64, ptr %25, align 8
  %27 = load ptr, ptr %16, align 8
  %28 = getelementptr inbounds i8, ptr %1, i64 8
  %29 = load ptr, ptr %28, align 8
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 16
  %32 = load i64, ptr %31, align 8
  tail call fastcc void @nested(ptr noundef %15, ptr noundef %18, ptr noundef %20, i64 noundef %22, i64 noundef %26, ptr noundef %27, i64 noundef %32) #11
  %33 = load ptr, ptr %28, align 8
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %34, i64 8
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %40

38:                                               ; preds = %5
  %39 = getelementptr inbounds i8, ptr %7, i64 24
  br label %45

40:                                               ; preds = %45, %5
  %41 = getelementptr inbounds i8, ptr %0, i64 1680
  %42 = load ptr, ptr %41, align 8
  %43 = load i64, ptr %42, align 8
  %44 = icmp eq i64 %43, 1
  br i1 %44, label %61, label %69

45:                                               ; preds = %38, %45
  %46 = phi i64 [ 0, %38 ], [ %55, %45 ]
  %47 = load ptr, ptr %39, align 8
  %48 = load ptr, ptr %14, align 8
  %49 = shl nsw i64 %46, 6
  %50 = getelementptr inbounds i8, ptr %48, i64 %49
  %51 = load <8 x i64>, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %47, i64 %49
  %53 = load <8 x i64>, ptr %52, align 8
  %54 = select <8 x i1> %12, <8 x i64> %51, <8 x i64> %53
  store <8 x i64> %54, ptr %52, align 8
  %55 = add nuw nsw i64 %46, 1
  %56 = load ptr, ptr %28, align 8
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i8, ptr %57, i64 8
  %59 = load i64, ptr %58, align 8
  %60 = icmp slt i64 %55, %59
  br i1 %60, label %45, label %40, !llvm.loop !98

61:                                               ; preds = %40
  %62 = bitcast <8 x i1> %12 to i8
  %63 = icmp eq i8 %62, 0
  br i1 %63, label %69, label %64

64:                                               ; preds = %61
  %65 = zext i8 %62 to i64
  %66 = getelementptr inbounds i8, ptr %7, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %3, ptr noundef %67, i64 noundef %65, i32 noundef 0) #11
  br label %69

69:                                               ; preds = %40, %61, %64
  %70 = phi i64 [ %68, %64 ], [ 0, %61 ], [ 0, %40 ]
  ret i64 %70
}

define internal fastcc void @write_outputs(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 984
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = icmp eq i64 %2, 0
  br i1 %12, label %28, label %13

13:                                               ; preds = %3
  %14 = getelementptr inbounds i8, ptr %0, i64 960
  %15 = icmp sgt i64 %7, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 792
  %17 = getelementptr inbounds i8, ptr %0, i64 1032
  %18 = getelementptr inbounds i8, ptr %0, i64 816
  br label %19

19:                                               ; preds = %13, %29
  %20 = phi i64 [ %2, %13 ], [ %44, %29 ]
  %21 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %20, i1 true)
  %22 = load ptr, ptr %14, align 8
  %23 = getelementptr inbounds i64, ptr %22, i64 %21
  %24 = load i64, ptr %23, align 8
  %25 = inttoptr i64 %24 to ptr
  %26 = add nsw i64 %24, 8
  store i64 %26, ptr %23, align 8
  %27 = getelementptr inbounds double, ptr %1, i64 %21
  br i1 %15, label %46, label %29

28:                                               ; preds = %29, %3
  ret void

29:                                               ; preds = %46, %19
  %30 = load ptr, ptr %16, align 8
  %31 = getelementptr inbounds double, ptr %30, i64 %21
  %32 = load double, ptr %31, align 8
  %33 = fadd double %32, 1.000000e+00
  store double %33, ptr %31, align 8
  %34 = load ptr, ptr %17, align 8
  %35 = load ptr, ptr %16, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %21
  %37 = load double, ptr %36, align 8
  %38 = fptosi double %37 to i64
  %39 = getelementptr inbounds double, ptr %34, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = load ptr, ptr %18, align 8
  %42 = getelementptr inbounds double, ptr %41, i64 %21
  store double %40, ptr %42, align 8
  %43 = add nsw i64 %20, -1
  %44 = and i64 %43, %20
  %45 = icmp eq i64 %44, 0
  br i1 %45, label %28, label %19, !llvm.loop !99

46:                                               ; preds = %19, %46
  %47 = phi i64 [ %53, %46 ], [ 0, %19 ]
  %48 = shl nsw i64 %47, 6
  %49 = getelementptr inbounds i8, ptr %27, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = mul nsw i64 %47, %11
  %52 = getelementptr inbounds double, ptr %25, i64 %51
  store double %50, ptr %52, align 8
  %53 = add nuw nsw i64 %47, 1
  %54 = icmp eq i64 %53, %7
  br i1 %54, label %29, label %46, !llvm.loop !100
}

define internal fastcc i64 @act_in_lanes(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #2 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %1, 0
  br i1 %8, label %32, label %9

9:                                                ; preds = %3
  %10 = getelementptr inbounds i8, ptr %0, i64 1224
  %11 = icmp sgt i64 %7, 0
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  %13 = getelementptr inbounds i8, ptr %0, i64 696
  %14 = getelementptr inbounds i8, ptr %0, i64 1272
  %15 = getelementptr inbounds i8, ptr %0, i64 1464
  %16 = getelementptr inbounds i8, ptr %0, i64 1440
  %17 = getelementptr inbounds i8, ptr %0, i64 1392
  %18 = icmp sgt i64 %7, 0
  %19 = getelementptr inbounds i8, ptr %0, i64 432
  br label %20

20:                                               ; preds = %9, %214
  %21 = phi i64 [ 0, %9 ], [ %215, %214 ]
  %22 = phi i64 [ %1, %9 ], [ %217, %214 ]
  %23 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %22, i1 true)
  %24 = load ptr, ptr %10, align 8
  %25 = getelementptr inbounds i64, ptr %24, i64 %23
  %26 = load i64, ptr %25, align 8
  %27 = inttoptr i64 %26 to ptr
  %28 = getelementptr inbounds i64, ptr %2, i64 %23
  %29 = load i64, ptr %28, align 8
  br i1 %11, label %30, label %34

30:                                               ; preds = %20
  %31 = getelementptr inbounds i8, ptr %27, i64 360
  br label %40

32:                                               ; preds = %214, %3
  %33 = phi i64 [ 0, %3 ], [ %215, %214 ]
  ret i64 %33

34:                                               ; preds = %40, %20
  %35 = load ptr, ptr %13, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %23
  %37 = load double, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %27, i64 624
  %39 = load ptr, ptr %38, align 8
  store double %37, ptr %39, align 8
  switch i64 %29, label %156 [
    i64 -3, label %51
    i64 -2, label %52
  ]

40:                                               ; preds = %30, %40
  %41 = phi i64 [ 0, %30 ], [ %49, %40 ]
  %42 = load ptr, ptr %12, align 8
  %43 = shl nsw i64 %41, 6
  %44 = getelementptr inbounds i8, ptr %42, i64 %43
  %45 = getelementptr inbounds double, ptr %44, i64 %23
  %46 = load double, ptr %45, align 8
  %47 = load ptr, ptr %31, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %41
  store double %46, ptr %48, align 8
  %49 = add nuw nsw i64 %41, 1
  %50 = icmp eq i64 %49, %7
  br i1 %50, label %34, label %40, !llvm.loop !101

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
  br label %156

52:                                               ; preds = %34
  %53 = load ptr, ptr %10, align 8
  %54 = getelementptr inbounds i64, ptr %53, i64 %23
  %55 = load i64, ptr %54, align 8
  %56 = inttoptr i64 %55 to ptr
  %57 = getelementptr inbounds i8, ptr %56, i64 768
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 8
  %60 = load i64, ptr %59, align 8
  %61 = getelementptr inbounds i8, ptr %56, i64 144
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 8
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %56, i64 624
  %66 = getelementptr inbounds i8, ptr %56, i64 648
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 80
  %69 = load i64, ptr %68, align 8
  %70 = add i64 %60, 1
  %71 = add i64 %70, %69
  %72 = getelementptr inbounds i8, ptr %56, i64 1056
  %73 = getelementptr inbounds i8, ptr %56, i64 1064
  %74 = load i64, ptr %73, align 8
  %75 = icmp sgt i64 %71, %74
  %76 = icmp sgt i64 %60, 0
  br i1 %76, label %77, label %80

77:                                               ; preds = %52
  %78 = getelementptr inbounds i8, ptr %56, i64 960
  %79 = load ptr, ptr %78, align 8
  br label %83

80:                                               ; preds = %83, %52
  %81 = phi i64 [ 0, %52 ], [ %90, %83 ]
  %82 = phi i64 [ 0, %52 ], [ %92, %83 ]
  br i1 %75, label %95, label %96

83:                                               ; preds = %77, %83
  %84 = phi i64 [ 0, %77 ], [ %93, %83 ]
  %85 = phi i64 [ 0, %77 ], [ %92, %83 ]
  %86 = phi i64 [ 0, %77 ], [ %90, %83 ]
  %87 = getelementptr inbounds i64, ptr %79, i64 %84
  %88 = load i64, ptr %87, align 8
  %89 = icmp sgt i64 %88, 0
  %90 = select i1 %89, i64 %84, i64 %86
  %91 = zext i1 %89 to i64
  %92 = add nuw nsw i64 %85, %91
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %60
  br i1 %94, label %80, label %83, !llvm.loop !102

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
  br label %96

96:                                               ; preds = %95, %80
  %97 = icmp eq i64 %82, 1
  br i1 %97, label %98, label %140

98:                                               ; preds = %96
  %99 = getelementptr inbounds i8, ptr %56, i64 864
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds i64, ptr %100, i64 %81
  %102 = load i64, ptr %101, align 8
  %103 = and i64 %102, 8
  %104 = icmp eq i64 %103, 0
  br i1 %104, label %140, label %105

105:                                              ; preds = %98
  %106 = load ptr, ptr %65, align 8
  %107 = load double, ptr %106, align 8
  %108 = load ptr, ptr %72, align 8
  %109 = load i64, ptr %68, align 8
  %110 = getelementptr inbounds double, ptr %108, i64 %109
  store double %107, ptr %110, align 8
  %111 = getelementptr inbounds i8, ptr %56, i64 1080
  %112 = load ptr, ptr %111, align 8
  %113 = load i64, ptr %68, align 8
  %114 = getelementptr inbounds i64, ptr %112, i64 %113
  store i64 %81, ptr %114, align 8
  %115 = icmp sgt i64 %64, 0
  br i1 %115, label %116, label %120

116:                                              ; preds = %105
  %117 = getelementptr inbounds i8, ptr %56, i64 360
  %118 = getelementptr inbounds i8, ptr %56, i64 1128
  %119 = getelementptr inbounds i8, ptr %56, i64 1104
  br label %123

120:                                              ; preds = %123, %105
  %121 = load i64, ptr %68, align 8
  %122 = add nsw i64 %121, 1
  store i64 %122, ptr %68, align 8
  br label %156

123:                                              ; preds = %116, %123
  %124 = phi i64 [ 0, %116 ], [ %138, %123 ]
  %125 = load ptr, ptr %117, align 8
  %126 = getelementptr inbounds double, ptr %125, i64 %124
  %127 = load double, ptr %126, align 8
  %128 = load ptr, ptr %118, align 8
  %129 = load i64, ptr %68, align 8
  %130 = mul nsw i64 %129, %64
  %131 = getelementptr double, ptr %128, i64 %130
  %132 = getelementptr double, ptr %131, i64 %124
  store double %127, ptr %132, align 8
  %133 = load ptr, ptr %119, align 8
  %134 = load i64, ptr %68, align 8
  %135 = mul nsw i64 %134, %64
  %136 = getelementptr double, ptr %133, i64 %135
  %137 = getelementptr double, ptr %136, i64 %124
  store double %127, ptr %137, align 8
  %138 = add nuw nsw i64 %124, 1
  %139 = icmp eq i64 %138, %64
  br i1 %139, label %120, label %123, !llvm.loop !103

140:                                              ; preds = %98, %96
  %141 = load ptr, ptr %57, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 48
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %148, label %145

145:                                              ; preds = %140
  %146 = inttoptr i64 %143 to ptr
  %147 = tail call i64 %146(ptr noundef %56) #12
  br label %148

148:                                              ; preds = %145, %140
  %149 = phi i64 [ %147, %145 ], [ 0, %140 ]
  br i1 %75, label %150, label %151

150:                                              ; preds = %148
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
  br label %151

151:                                              ; preds = %150, %148
  %152 = icmp eq i64 %149, 1
  %153 = icmp eq i64 %149, 0
  %154 = select i1 %153, i64 -1, i64 %149
  %155 = select i1 %152, i64 -2, i64 %154
  br label %156

156:                                              ; preds = %151, %120, %51, %34
  %157 = phi i64 [ %29, %51 ], [ %29, %34 ], [ 5, %120 ], [ %155, %151 ]
  %158 = load ptr, ptr %10, align 8
  %159 = getelementptr inbounds i64, ptr %158, i64 %23
  %160 = load i64, ptr %159, align 8
  %161 = inttoptr i64 %160 to ptr
  %162 = load ptr, ptr %14, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 8
  %164 = load i64, ptr %163, align 8
  %165 = getelementptr inbounds i8, ptr %161, i64 984
  %166 = load ptr, ptr %165, align 8
  %167 = shl nsw i64 %164, 4
  %168 = getelementptr inbounds i8, ptr %166, i64 %167
  %169 = mul i64 %164, 88
  %170 = getelementptr inbounds i8, ptr %166, i64 %169
  %171 = load double, ptr %170, align 8
  %172 = load ptr, ptr %15, align 8
  %173 = getelementptr inbounds double, ptr %172, i64 %23
  store double %171, ptr %173, align 8
  %174 = icmp sgt i64 %164, 0
  br i1 %174, label %175, label %177

175:                                              ; preds = %156
  %176 = getelementptr inbounds i8, ptr %161, i64 936
  br label %180

177:                                              ; preds = %180, %156
  br i1 %18, label %178, label %196

178:                                              ; preds = %177
  %179 = getelementptr inbounds i8, ptr %27, i64 360
  br label %200

180:                                              ; preds = %175, %180
  %181 = phi i64 [ 0, %175 ], [ %194, %180 ]
  %182 = load ptr, ptr %176, align 8
  %183 = getelementptr inbounds i64, ptr %182, i64 %181
  %184 = load i64, ptr %183, align 8
  %185 = sitofp i64 %184 to double
  %186 = load ptr, ptr %16, align 8
  %187 = shl nsw i64 %181, 3
  %188 = add nuw nsw i64 %187, %23
  %189 = getelementptr inbounds double, ptr %186, i64 %188
  store double %185, ptr %189, align 8
  %190 = getelementptr inbounds double, ptr %168, i64 %181
  %191 = load double, ptr %190, align 8
  %192 = load ptr, ptr %17, align 8
  %193 = getelementptr inbounds double, ptr %192, i64 %188
  store double %191, ptr %193, align 8
  %194 = add nuw nsw i64 %181, 1
  %195 = icmp eq i64 %194, %164
  br i1 %195, label %177, label %180, !llvm.loop !104

196:                                              ; preds = %200, %177
  %197 = add i64 %157, 3
  %198 = icmp ult i64 %197, 2
  %199 = shl nuw i64 1, %23
  br i1 %198, label %211, label %213

200:                                              ; preds = %178, %200
  %201 = phi i64 [ 0, %178 ], [ %209, %200 ]
  %202 = load ptr, ptr %179, align 8
  %203 = getelementptr inbounds double, ptr %202, i64 %201
  %204 = load double, ptr %203, align 8
  %205 = load ptr, ptr %19, align 8
  %206 = shl nsw i64 %201, 6
  %207 = getelementptr inbounds i8, ptr %205, i64 %206
  %208 = getelementptr inbounds double, ptr %207, i64 %23
  store double %204, ptr %208, align 8
  %209 = add nuw nsw i64 %201, 1
  %210 = icmp eq i64 %209, %7
  br i1 %210, label %196, label %200, !llvm.loop !105

211:                                              ; preds = %196
  %212 = or i64 %199, %21
  br label %214

213:                                              ; preds = %196
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %199, i64 noundef %157) #11
  br label %214

214:                                              ; preds = %213, %211
  %215 = phi i64 [ %212, %211 ], [ %21, %213 ]
  %216 = add nsw i64 %22, -1
  %217 = and i64 %216, %22
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %32, label %20, !llvm.loop !106
}

define internal fastcc range(i64 0, 256) i64 @start_again(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #3 {
  %4 = getelementptr inbounds i8, ptr %0, i64 696
  %5 = getelementptr inbounds i8, ptr %1, i64 16
  %6 = load ptr, ptr %5, align 8
  %7 = trunc i64 %2 to i8
  %8 = bitcast i8 %7 to <8 x i1>
  %9 = getelementptr inbounds i8, ptr %1, i64 8
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 248
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %17

14:                                               ; preds = %3
  %15 = getelementptr inbounds i8, ptr %10, i64 264
  %16 = load ptr, ptr %15, align 8
  store <8 x double> <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, ptr %16, align 8
  br label %17

17:                                               ; preds = %3, %14
  %18 = load ptr, ptr %9, align 8
  %19 = load ptr, ptr %4, align 8
  %20 = load <8 x double>, ptr %19, align 8
  %21 = load ptr, ptr %6, align 8
  %22 = getelementptr inbounds i8, ptr %6, i64 48
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %18, i64 24
  %25 = load ptr, ptr %24, align 8
  store <8 x double> %20, ptr %25, align 8
  %26 = load ptr, ptr %18, align 8
  %27 = getelementptr inbounds i8, ptr %26, i64 40
  %28 = load i64, ptr %27, align 8
  %29 = icmp eq i64 %28, 0
  br i1 %29, label %31, label %30

30:                                               ; preds = %17
  tail call fastcc void @settle(ptr noundef nonnull %18) #11
  br label %31

31:                                               ; preds = %30, %17
  %32 = getelementptr inbounds i8, ptr %18, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %18) #11
  br label %36

36:                                               ; preds = %31, %35
  %37 = load ptr, ptr %18, align 8
  %38 = load i64, ptr %37, align 8
  %39 = load ptr, ptr %24, align 8
  %40 = getelementptr inbounds i8, ptr %18, i64 48
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %18, i64 96
  %43 = load ptr, ptr %42, align 8
  %44 = inttoptr i64 %38 to ptr
  %45 = load ptr, ptr %44, align 8
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #12
  %47 = load ptr, ptr %9, align 8
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds i8, ptr %48, i64 8
  %50 = load i64, ptr %49, align 8
  %51 = icmp sgt i64 %50, 0
  br i1 %51, label %52, label %54

52:                                               ; preds = %36
  %53 = getelementptr inbounds i8, ptr %6, i64 168
  br label %62

54:                                               ; preds = %62, %36
  %55 = sext i32 %46 to i64
  %56 = and i64 %55, %2
  %57 = getelementptr inbounds i8, ptr %0, i64 888
  %58 = load ptr, ptr %57, align 8
  %59 = load <8 x double>, ptr %58, align 8
  %60 = select <8 x i1> %8, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %61 = fadd <8 x double> %60, %59
  store <8 x double> %61, ptr %58, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %56, i64 noundef 3) #11
  ret i64 %56

62:                                               ; preds = %52, %62
  %63 = phi i64 [ 0, %52 ], [ %72, %62 ]
  %64 = load ptr, ptr %53, align 8
  %65 = load ptr, ptr %22, align 8
  %66 = shl nsw i64 %63, 6
  %67 = getelementptr inbounds i8, ptr %65, i64 %66
  %68 = load <8 x i64>, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %64, i64 %66
  %70 = load <8 x i64>, ptr %69, align 8
  %71 = select <8 x i1> %8, <8 x i64> %68, <8 x i64> %70
  store <8 x i64> %71, ptr %69, align 8
  %72 = add nuw nsw i64 %63, 1
  %73 = load ptr, ptr %9, align 8
  %74 = load ptr, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 8
  %76 = load i64, ptr %75, align 8
  %77 = icmp slt i64 %72, %76
  br i1 %77, label %62, label %54, !llvm.loop !107
}

declare i64 @llvm.cttz.i64(i64, i1 immarg) #5

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 264
  %3 = getelementptr inbounds i8, ptr %0, i64 24
  %4 = getelementptr inbounds i8, ptr %0, i64 240
  %5 = getelementptr inbounds i8, ptr %0, i64 248
  br label %7

6:                                                ; preds = %51
  ret void

7:                                                ; preds = %1, %51
  %8 = phi i64 [ 0, %1 ], [ %53, %51 ]
  %9 = load ptr, ptr %2, align 8
  %10 = getelementptr inbounds double, ptr %9, i64 %8
  %11 = load double, ptr %10, align 8
  %12 = load ptr, ptr %3, align 8
  %13 = getelementptr inbounds double, ptr %12, i64 %8
  %14 = load double, ptr %13, align 8
  %15 = fcmp olt double %14, %11
  %16 = select i1 %15, double %14, double %11
  %17 = load i64, ptr %5, align 8
  %18 = icmp sgt i64 %17, 0
  br i1 %18, label %19, label %34

19:                                               ; preds = %7
  %20 = load ptr, ptr %4, align 8
  br label %21

21:                                               ; preds = %19, %21
  %22 = phi i64 [ 0, %19 ], [ %32, %21 ]
  %23 = phi i64 [ %17, %19 ], [ %31, %21 ]
  %24 = add nuw nsw i64 %22, %23
  %25 = lshr i64 %24, 1
  %26 = mul i64 %25, 24
  %27 = getelementptr inbounds i8, ptr %20, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = fcmp ogt double %28, %16
  %30 = add nuw nsw i64 %25, 1
  %31 = select i1 %29, i64 %25, i64 %23
  %32 = select i1 %29, i64 %22, i64 %30
  %33 = icmp slt i64 %32, %31
  br i1 %33, label %21, label %34, !llvm.loop !82

34:                                               ; preds = %21, %7
  %35 = phi i64 [ 0, %7 ], [ %32, %21 ]
  %36 = load ptr, ptr %4, align 8
  %37 = mul i64 %35, 24
  %38 = getelementptr inbounds i8, ptr %36, i64 %37
  %39 = icmp eq i64 %35, 0
  br i1 %39, label %44, label %40

40:                                               ; preds = %34
  %41 = getelementptr inbounds i8, ptr %38, i64 -8
  %42 = load double, ptr %41, align 8
  %43 = fcmp olt double %16, %42
  br i1 %43, label %51, label %44

44:                                               ; preds = %40, %34
  %45 = icmp slt i64 %35, %17
  br i1 %45, label %46, label %50

46:                                               ; preds = %44
  %47 = getelementptr inbounds i8, ptr %38, i64 8
  %48 = load double, ptr %47, align 8
  %49 = fcmp ogt double %16, %48
  br i1 %49, label %51, label %50

50:                                               ; preds = %46, %44
  br label %51

51:                                               ; preds = %50, %46, %40
  %52 = phi double [ %42, %40 ], [ %16, %50 ], [ %48, %46 ]
  store double %52, ptr %13, align 8
  %53 = add nuw nsw i64 %8, 1
  %54 = icmp eq i64 %53, 8
  br i1 %54, label %6, label %7, !llvm.loop !108
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 152
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %14

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = getelementptr inbounds i8, ptr %0, i64 160
  %8 = getelementptr inbounds i8, ptr %0, i64 168
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 264
  %11 = getelementptr inbounds i8, ptr %0, i64 192
  %12 = getelementptr inbounds i8, ptr %0, i64 216
  %13 = getelementptr inbounds i8, ptr %0, i64 48
  br label %15

14:                                               ; preds = %22, %1
  ret void

15:                                               ; preds = %5, %22
  %16 = phi i64 [ 0, %5 ], [ %23, %22 ]
  %17 = load ptr, ptr %6, align 8
  %18 = load i64, ptr %7, align 8
  %19 = mul nsw i64 %18, %16
  %20 = getelementptr inbounds i64, ptr %17, i64 %19
  %21 = shl nsw i64 %16, 6
  br label %26

22:                                               ; preds = %77
  %23 = add nuw nsw i64 %16, 1
  %24 = load i64, ptr %2, align 8
  %25 = icmp slt i64 %23, %24
  br i1 %25, label %15, label %14, !llvm.loop !109

26:                                               ; preds = %15, %77
  %27 = phi i64 [ 0, %15 ], [ %104, %77 ]
  %28 = load ptr, ptr %8, align 8
  %29 = getelementptr inbounds i8, ptr %28, i64 %21
  %30 = getelementptr inbounds i64, ptr %29, i64 %27
  %31 = load ptr, ptr %9, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %27
  %33 = load double, ptr %32, align 8
  %34 = load ptr, ptr %10, align 8
  %35 = getelementptr inbounds double, ptr %34, i64 %27
  %36 = load double, ptr %35, align 8
  %37 = fcmp olt double %33, %36
  %38 = select i1 %37, double %33, double %36
  %39 = load ptr, ptr %6, align 8
  %40 = load i64, ptr %7, align 8
  %41 = mul nsw i64 %40, %16
  %42 = getelementptr inbounds i64, ptr %39, i64 %41
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %11, align 8
  %46 = getelementptr inbounds double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = fcmp ogt double %47, %38
  %49 = select i1 %48, double %47, double %38
  %50 = getelementptr inbounds i8, ptr %42, i64 16
  %51 = load i64, ptr %50, align 8
  %52 = load i64, ptr %30, align 8
  %53 = getelementptr inbounds double, ptr %46, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = fcmp ugt double %54, %49
  br i1 %55, label %63, label %56

56:                                               ; preds = %26
  %57 = add nsw i64 %51, -1
  %58 = icmp eq i64 %57, %52
  br i1 %58, label %77, label %59

59:                                               ; preds = %56
  %60 = getelementptr i8, ptr %53, i64 8
  %61 = load double, ptr %60, align 8
  %62 = fcmp ogt double %61, %49
  br i1 %62, label %77, label %63

63:                                               ; preds = %59, %26
  %64 = icmp sgt i64 %51, 1
  br i1 %64, label %65, label %77

65:                                               ; preds = %63, %65
  %66 = phi i64 [ %74, %65 ], [ %51, %63 ]
  %67 = phi i64 [ %73, %65 ], [ 0, %63 ]
  %68 = add nsw i64 %66, %67
  %69 = sdiv i64 %68, 2
  %70 = getelementptr inbounds double, ptr %46, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = fcmp ugt double %71, %49
  %73 = select i1 %72, i64 %67, i64 %69
  %74 = select i1 %72, i64 %69, i64 %66
  %75 = sub nsw i64 %74, %73
  %76 = icmp sgt i64 %75, 1
  br i1 %76, label %65, label %77, !llvm.loop !110

77:                                               ; preds = %65, %63, %56, %59
  %78 = phi i64 [ %52, %59 ], [ %52, %56 ], [ 0, %63 ], [ %73, %65 ]
  store i64 %78, ptr %30, align 8
  %79 = getelementptr inbounds double, ptr %46, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fsub double %49, %80
  %82 = load ptr, ptr %12, align 8
  %83 = add nsw i64 %78, %44
  %84 = shl nsw i64 %83, 5
  %85 = getelementptr inbounds i8, ptr %82, i64 %84
  %86 = load double, ptr %85, align 8
  %87 = getelementptr inbounds i8, ptr %85, i64 8
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds i8, ptr %85, i64 16
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds i8, ptr %85, i64 24
  %92 = load double, ptr %91, align 8
  %93 = fmul double %81, %92
  %94 = fadd double %90, %93
  %95 = fmul double %81, %94
  %96 = fadd double %88, %95
  %97 = fmul double %81, %96
  %98 = fadd double %86, %97
  %99 = load ptr, ptr %13, align 8
  %100 = load i64, ptr %20, align 8
  %101 = shl i64 %100, 6
  %102 = getelementptr i8, ptr %99, i64 %101
  %103 = getelementptr double, ptr %102, i64 %27
  store double %98, ptr %103, align 8
  %104 = add nuw nsw i64 %27, 1
  %105 = icmp eq i64 %104, 8
  br i1 %105, label %22, label %26, !llvm.loop !111
}

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #6 {
  %6 = icmp sgt i64 %4, 0
  br i1 %6, label %7, label %13

7:                                                ; preds = %5
  %8 = load ptr, ptr %3, align 8
  %9 = getelementptr inbounds i8, ptr %3, i64 240
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %3, i64 216
  %12 = load ptr, ptr %11, align 8
  br label %20

13:                                               ; preds = %20, %5
  %14 = phi <8 x double> [ zeroinitializer, %5 ], [ %46, %20 ]
  %15 = sitofp i64 %4 to double
  %16 = insertelement <8 x double> poison, double %15, i64 0
  %17 = shufflevector <8 x double> %16, <8 x double> poison, <8 x i32> zeroinitializer
  %18 = fdiv <8 x double> %14, %17
  %19 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %18)
  store <8 x double> %19, ptr %0, align 8
  ret void

20:                                               ; preds = %7, %20
  %21 = phi <8 x double> [ zeroinitializer, %7 ], [ %46, %20 ]
  %22 = phi i64 [ 0, %7 ], [ %47, %20 ]
  %23 = shl nsw i64 %22, 6
  %24 = getelementptr inbounds i8, ptr %1, i64 %23
  %25 = load <8 x double>, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %8, i64 %23
  %27 = load <8 x double>, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %2, i64 %23
  %29 = load <8 x double>, ptr %28, align 8
  %30 = getelementptr inbounds double, ptr %10, i64 %22
  %31 = load double, ptr %30, align 8
  %32 = insertelement <8 x double> poison, double %31, i64 0
  %33 = shufflevector <8 x double> %32, <8 x double> poison, <8 x i32> zeroinitializer
  %34 = getelementptr inbounds double, ptr %12, i64 %22
  %35 = load double, ptr %34, align 8
  %36 = insertelement <8 x double> poison, double %35, i64 0
  %37 = shufflevector <8 x double> %36, <8 x double> poison, <8 x i32> zeroinitializer
  %38 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %27)
  %39 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %29)
  %40 = fcmp ogt <8 x double> %38, %39
  %41 = select <8 x i1> %40, <8 x double> %38, <8 x double> %39
  %42 = fmul <8 x double> %41, %37
  %43 = fadd <8 x double> %33, %42
  %44 = fdiv <8 x double> %25, %43
  %45 = fmul <8 x double> %44, %44
  %46 = fadd <8 x double> %21, %45
  %47 = add nuw nsw i64 %22, 1
  %48 = icmp eq i64 %47, %4
  br i1 %48, label %13, label %20, !llvm.loop !112
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #5

define internal fastcc void @empty_log(ptr noundef readonly %0, i64 noundef %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 1272
  %4 = getelementptr inbounds i8, ptr %0, i64 1224
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i64, ptr %5, i64 %1
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 648
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 80
  %12 = getelementptr inbounds i8, ptr %0, i64 1632
  %13 = getelementptr inbounds i8, ptr %0, i64 1648
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 1592
  %16 = load i64, ptr %11, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %33

18:                                               ; preds = %2
  %19 = getelementptr inbounds i8, ptr %0, i64 1584
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = getelementptr inbounds i8, ptr %0, i64 1560
  %22 = getelementptr inbounds i8, ptr %8, i64 1056
  %23 = getelementptr inbounds i8, ptr %8, i64 1080
  %24 = getelementptr inbounds i8, ptr %0, i64 1608
  %25 = icmp sgt i64 %14, 0
  %26 = getelementptr inbounds i8, ptr %8, i64 1104
  %27 = getelementptr inbounds i8, ptr %8, i64 1128
  %28 = getelementptr inbounds i8, ptr %0, i64 1656
  br label %29

29:                                               ; preds = %18, %57
  %30 = phi i64 [ 0, %18 ], [ %58, %57 ]
  %31 = load i64, ptr %15, align 8
  %32 = icmp sgt i64 %31, 0
  br i1 %32, label %34, label %33

33:                                               ; preds = %29, %57, %2
  store i64 0, ptr %11, align 8
  ret void

34:                                               ; preds = %29
  %35 = load ptr, ptr %3, align 8
  %36 = getelementptr inbounds i8, ptr %35, i64 72
  %37 = load i64, ptr %36, align 8
  %38 = add nsw i64 %37, 1
  store i64 %38, ptr %36, align 8
  %39 = load ptr, ptr %20, align 8
  %40 = getelementptr inbounds i64, ptr %39, i64 %1
  %41 = load i64, ptr %40, align 8
  %42 = load ptr, ptr %21, align 8
  %43 = getelementptr inbounds i64, ptr %42, i64 %37
  store i64 %41, ptr %43, align 8
  %44 = load ptr, ptr %22, align 8
  %45 = getelementptr inbounds double, ptr %44, i64 %30
  %46 = load double, ptr %45, align 8
  %47 = load ptr, ptr %19, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %37
  store double %46, ptr %48, align 8
  %49 = load ptr, ptr %23, align 8
  %50 = getelementptr inbounds i64, ptr %49, i64 %30
  %51 = load i64, ptr %50, align 8
  %52 = load ptr, ptr %24, align 8
  %53 = getelementptr inbounds i64, ptr %52, i64 %37
  store i64 %51, ptr %53, align 8
  br i1 %25, label %54, label %57

54:                                               ; preds = %34
  %55 = mul nuw nsw i64 %30, %14
  %56 = mul nsw i64 %37, %14
  br label %61

57:                                               ; preds = %61, %34
  %58 = add nuw nsw i64 %30, 1
  %59 = load i64, ptr %11, align 8
  %60 = icmp slt i64 %58, %59
  br i1 %60, label %29, label %33, !llvm.loop !113

61:                                               ; preds = %54, %61
  %62 = phi i64 [ 0, %54 ], [ %75, %61 ]
  %63 = load ptr, ptr %26, align 8
  %64 = add nuw nsw i64 %62, %55
  %65 = getelementptr inbounds double, ptr %63, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = load ptr, ptr %12, align 8
  %68 = add nsw i64 %62, %56
  %69 = getelementptr inbounds double, ptr %67, i64 %68
  store double %66, ptr %69, align 8
  %70 = load ptr, ptr %27, align 8
  %71 = getelementptr inbounds double, ptr %70, i64 %64
  %72 = load double, ptr %71, align 8
  %73 = load ptr, ptr %28, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %68
  store double %72, ptr %74, align 8
  %75 = add nuw nsw i64 %62, 1
  %76 = icmp eq i64 %75, %14
  br i1 %76, label %57, label %61, !llvm.loop !114
}

declare double @llvm.sqrt.f64(double) #5

define internal fastcc range(i64 0, 256) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %118, %57
  %6 = icmp eq i64 %25, %1
  br i1 %6, label %7, label %13, !llvm.loop !115

7:                                                ; preds = %5
  %8 = icmp ne <8 x i64> %33, zeroinitializer
  %9 = bitcast <8 x i1> %8 to i8
  %10 = zext i8 %9 to i64
  br label %11

11:                                               ; preds = %7, %3
  %12 = phi i64 [ 0, %3 ], [ %10, %7 ]
  ret i64 %12

13:                                               ; preds = %3, %5
  %14 = phi <8 x i64> [ %33, %5 ], [ zeroinitializer, %3 ]
  %15 = phi i64 [ %25, %5 ], [ 0, %3 ]
  %16 = uitofp nneg i64 %15 to double
  %17 = insertelement <8 x double> poison, double %16, i64 0
  %18 = shufflevector <8 x double> %17, <8 x double> poison, <8 x i32> zeroinitializer
  %19 = mul nuw nsw i64 %15, %1
  %20 = add nuw nsw i64 %19, %15
  %21 = shl nsw i64 %20, 6
  %22 = getelementptr inbounds i8, ptr %0, i64 %21
  %23 = load <8 x double>, ptr %22, align 8
  %24 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %23)
  %25 = add nuw nsw i64 %15, 1
  %26 = icmp slt i64 %25, %1
  br i1 %26, label %39, label %27

27:                                               ; preds = %39, %13
  %28 = phi <8 x double> [ %24, %13 ], [ %54, %39 ]
  %29 = phi <8 x double> [ %18, %13 ], [ %53, %39 ]
  %30 = shl nsw i64 %15, 6
  %31 = getelementptr inbounds i8, ptr %2, i64 %30
  store <8 x double> %29, ptr %31, align 8
  %32 = fcmp ueq <8 x double> %28, zeroinitializer
  %33 = select <8 x i1> %32, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %14
  %34 = fcmp une <8 x double> %29, %18
  %35 = bitcast <8 x i1> %34 to i8
  %36 = icmp eq i8 %35, 0
  %37 = icmp sge i64 %25, %1
  %38 = select i1 %37, i1 true, i1 %36
  br i1 %38, label %57, label %61

39:                                               ; preds = %13, %39
  %40 = phi <8 x double> [ %53, %39 ], [ %18, %13 ]
  %41 = phi <8 x double> [ %54, %39 ], [ %24, %13 ]
  %42 = phi i64 [ %55, %39 ], [ %25, %13 ]
  %43 = mul nuw nsw i64 %42, %1
  %44 = add nuw nsw i64 %43, %15
  %45 = shl nsw i64 %44, 6
  %46 = getelementptr inbounds i8, ptr %0, i64 %45
  %47 = load <8 x double>, ptr %46, align 8
  %48 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %47)
  %49 = fcmp ogt <8 x double> %48, %41
  %50 = uitofp nneg i64 %42 to double
  %51 = insertelement <8 x double> poison, double %50, i64 0
  %52 = shufflevector <8 x double> %51, <8 x double> poison, <8 x i32> zeroinitializer
  %53 = select <8 x i1> %49, <8 x double> %52, <8 x double> %40
  %54 = select <8 x i1> %49, <8 x double> %48, <8 x double> %41
  %55 = add nuw nsw i64 %42, 1
  %56 = icmp slt i64 %55, %1
  br i1 %56, label %39, label %27, !llvm.loop !116

57:                                               ; preds = %71, %27
  %58 = load <8 x double>, ptr %22, align 8
  %59 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %58
  store <8 x double> %59, ptr %22, align 8
  %60 = icmp slt i64 %25, %1
  br i1 %60, label %90, label %5

61:                                               ; preds = %27, %71
  %62 = phi i64 [ %72, %71 ], [ %25, %27 ]
  %63 = uitofp nneg i64 %62 to double
  %64 = insertelement <8 x double> poison, double %63, i64 0
  %65 = shufflevector <8 x double> %64, <8 x double> poison, <8 x i32> zeroinitializer
  %66 = fcmp oeq <8 x double> %29, %65
  %67 = bitcast <8 x i1> %66 to i8
  %68 = icmp eq i8 %67, 0
  br i1 %68, label %71, label %69

69:                                               ; preds = %61
  %70 = mul nuw nsw i64 %62, %1
  br label %75

71:                                               ; preds = %75, %61
  %72 = add nuw nsw i64 %62, 1
  %73 = icmp sge i64 %72, %1
  %74 = select i1 %73, i1 true, i1 %36
  br i1 %74, label %57, label %61, !llvm.loop !117

75:                                               ; preds = %69, %75
  %76 = phi i64 [ 0, %69 ], [ %87, %75 ]
  %77 = add nuw nsw i64 %76, %19
  %78 = shl nsw i64 %77, 6
  %79 = getelementptr inbounds i8, ptr %0, i64 %78
  %80 = load <8 x i64>, ptr %79, align 8
  %81 = add nuw nsw i64 %76, %70
  %82 = shl nsw i64 %81, 6
  %83 = getelementptr inbounds i8, ptr %0, i64 %82
  %84 = load <8 x i64>, ptr %83, align 8
  %85 = select <8 x i1> %66, <8 x i64> %84, <8 x i64> %80
  store <8 x i64> %85, ptr %79, align 8
  %86 = select <8 x i1> %66, <8 x i64> %80, <8 x i64> %84
  store <8 x i64> %86, ptr %83, align 8
  %87 = add nuw nsw i64 %76, 1
  %88 = icmp sge i64 %87, %1
  %89 = or i1 %88, %68
  br i1 %89, label %71, label %75, !llvm.loop !118

90:                                               ; preds = %57, %118
  %91 = phi i64 [ %119, %118 ], [ %25, %57 ]
  %92 = mul nuw nsw i64 %91, %1
  %93 = add nuw nsw i64 %92, %15
  %94 = shl nsw i64 %93, 6
  %95 = getelementptr inbounds i8, ptr %0, i64 %94
  %96 = load <8 x double>, ptr %95, align 8
  %97 = fcmp une <8 x double> %96, zeroinitializer
  %98 = bitcast <8 x i1> %97 to i8
  %99 = icmp eq i8 %98, 0
  br i1 %99, label %118, label %100

100:                                              ; preds = %90
  %101 = fmul <8 x double> %59, %96
  %102 = select <8 x i1> %97, <8 x double> %101, <8 x double> %96
  store <8 x double> %102, ptr %95, align 8
  %103 = fneg <8 x double> %102
  br label %104

104:                                              ; preds = %100, %104
  %105 = phi i64 [ %25, %100 ], [ %116, %104 ]
  %106 = add nuw nsw i64 %105, %92
  %107 = shl nsw i64 %106, 6
  %108 = getelementptr inbounds i8, ptr %0, i64 %107
  %109 = load <8 x double>, ptr %108, align 8
  %110 = add nuw nsw i64 %105, %19
  %111 = shl nsw i64 %110, 6
  %112 = getelementptr inbounds i8, ptr %0, i64 %111
  %113 = load <8 x double>, ptr %112, align 8
  %114 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %103, <8 x double> %113, <8 x double> %109)
  %115 = select <8 x i1> %97, <8 x double> %114, <8 x double> %109
  store <8 x double> %115, ptr %108, align 8
  %116 = add nuw nsw i64 %105, 1
  %117 = icmp slt i64 %116, %1
  br i1 %117, label %104, label %118, !llvm.loop !119

118:                                              ; preds = %104, %90
  %119 = add nuw nsw i64 %91, 1
  %120 = icmp slt i64 %119, %1
  br i1 %120, label %90, label %5, !llvm.loop !120
}

define internal fastcc range(i64 0, 256) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %179, %69
  %6 = icmp eq i64 %31, %1
  br i1 %6, label %7, label %13, !llvm.loop !121

7:                                                ; preds = %5
  %8 = icmp ne <8 x i64> %39, zeroinitializer
  %9 = bitcast <8 x i1> %8 to i8
  %10 = zext i8 %9 to i64
  br label %11

11:                                               ; preds = %7, %3
  %12 = phi i64 [ 0, %3 ], [ %10, %7 ]
  ret i64 %12

13:                                               ; preds = %3, %5
  %14 = phi <8 x i64> [ %39, %5 ], [ zeroinitializer, %3 ]
  %15 = phi i64 [ %31, %5 ], [ 0, %3 ]
  %16 = uitofp nneg i64 %15 to double
  %17 = insertelement <8 x double> poison, double %16, i64 0
  %18 = shufflevector <8 x double> %17, <8 x double> poison, <8 x i32> zeroinitializer
  %19 = mul nuw nsw i64 %15, %1
  %20 = add nuw nsw i64 %19, %15
  %21 = shl i64 %20, 7
  %22 = shl nsw i64 %20, 7
  %23 = getelementptr inbounds i8, ptr %0, i64 %22
  %24 = load <8 x double>, ptr %23, align 8, !noalias !122
  %25 = or disjoint i64 %21, 64
  %26 = getelementptr inbounds i8, ptr %0, i64 %25
  %27 = load <8 x double>, ptr %26, align 8, !noalias !122
  %28 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %24)
  %29 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %27)
  %30 = fadd <8 x double> %28, %29
  %31 = add nuw nsw i64 %15, 1
  %32 = icmp slt i64 %31, %1
  br i1 %32, label %45, label %33

33:                                               ; preds = %45, %13
  %34 = phi <8 x double> [ %30, %13 ], [ %66, %45 ]
  %35 = phi <8 x double> [ %18, %13 ], [ %65, %45 ]
  %36 = shl nsw i64 %15, 6
  %37 = getelementptr inbounds i8, ptr %2, i64 %36
  store <8 x double> %35, ptr %37, align 8
  %38 = fcmp ueq <8 x double> %34, zeroinitializer
  %39 = select <8 x i1> %38, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %14
  %40 = fcmp une <8 x double> %35, %18
  %41 = bitcast <8 x i1> %40 to i8
  %42 = icmp eq i8 %41, 0
  %43 = icmp sge i64 %31, %1
  %44 = select i1 %43, i1 true, i1 %42
  br i1 %44, label %69, label %86

45:                                               ; preds = %13, %45
  %46 = phi <8 x double> [ %65, %45 ], [ %18, %13 ]
  %47 = phi i64 [ %67, %45 ], [ %31, %13 ]
  %48 = phi <8 x double> [ %66, %45 ], [ %30, %13 ]
  %49 = mul nuw nsw i64 %47, %1
  %50 = add nuw nsw i64 %49, %15
  %51 = shl i64 %50, 7
  %52 = shl nsw i64 %50, 7
  %53 = getelementptr inbounds i8, ptr %0, i64 %52
  %54 = load <8 x double>, ptr %53, align 8, !noalias !125
  %55 = or disjoint i64 %51, 64
  %56 = getelementptr inbounds i8, ptr %0, i64 %55
  %57 = load <8 x double>, ptr %56, align 8, !noalias !125
  %58 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %54)
  %59 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %57)
  %60 = fadd <8 x double> %58, %59
  %61 = fcmp ogt <8 x double> %60, %48
  %62 = uitofp nneg i64 %47 to double
  %63 = insertelement <8 x double> poison, double %62, i64 0
  %64 = shufflevector <8 x double> %63, <8 x double> poison, <8 x i32> zeroinitializer
  %65 = select <8 x i1> %61, <8 x double> %64, <8 x double> %46
  %66 = select <8 x i1> %61, <8 x double> %60, <8 x double> %48
  %67 = add nuw nsw i64 %47, 1
  %68 = icmp slt i64 %67, %1
  br i1 %68, label %45, label %33, !llvm.loop !128

69:                                               ; preds = %96, %33
  %70 = load <8 x double>, ptr %23, align 8, !noalias !129
  %71 = load <8 x double>, ptr %26, align 8, !noalias !129
  %72 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %70)
  %73 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %71)
  %74 = fcmp oge <8 x double> %72, %73
  %75 = select <8 x i1> %74, <8 x double> %70, <8 x double> %71
  %76 = select <8 x i1> %74, <8 x double> %71, <8 x double> %70
  %77 = fdiv <8 x double> %76, %75
  %78 = fmul <8 x double> %76, %77
  %79 = fadd <8 x double> %75, %78
  %80 = select <8 x i1> %74, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> %77
  %81 = fdiv <8 x double> %80, %79
  %82 = fneg <8 x double> %77
  %83 = select <8 x i1> %74, <8 x double> %82, <8 x double> <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %84 = fdiv <8 x double> %83, %79
  store <8 x double> %81, ptr %23, align 8
  store <8 x double> %84, ptr %26, align 8
  %85 = icmp slt i64 %31, %1
  br i1 %85, label %125, label %5

86:                                               ; preds = %33, %96
  %87 = phi i64 [ %97, %96 ], [ %31, %33 ]
  %88 = uitofp nneg i64 %87 to double
  %89 = insertelement <8 x double> poison, double %88, i64 0
  %90 = shufflevector <8 x double> %89, <8 x double> poison, <8 x i32> zeroinitializer
  %91 = fcmp oeq <8 x double> %35, %90
  %92 = bitcast <8 x i1> %91 to i8
  %93 = icmp eq i8 %92, 0
  br i1 %93, label %96, label %94

94:                                               ; preds = %86
  %95 = mul nuw nsw i64 %87, %1
  br label %100

96:                                               ; preds = %100, %86
  %97 = add nuw nsw i64 %87, 1
  %98 = icmp sge i64 %97, %1
  %99 = select i1 %98, i1 true, i1 %42
  br i1 %99, label %69, label %86, !llvm.loop !132

100:                                              ; preds = %94, %100
  %101 = phi i64 [ 0, %94 ], [ %122, %100 ]
  %102 = add nuw nsw i64 %101, %19
  %103 = shl i64 %102, 7
  %104 = shl nsw i64 %102, 7
  %105 = getelementptr inbounds i8, ptr %0, i64 %104
  %106 = load <8 x i64>, ptr %105, align 8, !noalias !133
  %107 = or disjoint i64 %103, 64
  %108 = getelementptr inbounds i8, ptr %0, i64 %107
  %109 = load <8 x i64>, ptr %108, align 8, !noalias !133
  %110 = add nuw nsw i64 %101, %95
  %111 = shl i64 %110, 7
  %112 = shl nsw i64 %110, 7
  %113 = getelementptr inbounds i8, ptr %0, i64 %112
  %114 = load <8 x i64>, ptr %113, align 8, !noalias !136
  %115 = or disjoint i64 %111, 64
  %116 = getelementptr inbounds i8, ptr %0, i64 %115
  %117 = load <8 x i64>, ptr %116, align 8, !noalias !136
  %118 = select <8 x i1> %91, <8 x i64> %114, <8 x i64> %106
  %119 = select <8 x i1> %91, <8 x i64> %117, <8 x i64> %109
  store <8 x i64> %118, ptr %105, align 8
  store <8 x i64> %119, ptr %108, align 8
  %120 = select <8 x i1> %91, <8 x i64> %106, <8 x i64> %114
  %121 = select <8 x i1> %91, <8 x i64> %109, <8 x i64> %117
  store <8 x i64> %120, ptr %113, align 8
  store <8 x i64> %121, ptr %116, align 8
  %122 = add nuw nsw i64 %101, 1
  %123 = icmp sge i64 %122, %1
  %124 = or i1 %123, %93
  br i1 %124, label %96, label %100, !llvm.loop !139

125:                                              ; preds = %69, %179
  %126 = phi i64 [ %180, %179 ], [ %31, %69 ]
  %127 = mul nuw nsw i64 %126, %1
  %128 = add nuw nsw i64 %127, %15
  %129 = shl i64 %128, 7
  %130 = shl nsw i64 %128, 7
  %131 = getelementptr inbounds i8, ptr %0, i64 %130
  %132 = load <8 x double>, ptr %131, align 8, !noalias !140
  %133 = or disjoint i64 %129, 64
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !140
  %136 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %132)
  %137 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %135)
  %138 = fadd <8 x double> %136, %137
  %139 = fcmp une <8 x double> %138, zeroinitializer
  %140 = bitcast <8 x i1> %139 to i8
  %141 = icmp eq i8 %140, 0
  br i1 %141, label %179, label %142

142:                                              ; preds = %125
  %143 = fneg <8 x double> %135
  %144 = fmul <8 x double> %84, %143
  %145 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %132, <8 x double> %81, <8 x double> %144)
  %146 = fmul <8 x double> %81, %135
  %147 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %132, <8 x double> %84, <8 x double> %146)
  %148 = select <8 x i1> %139, <8 x double> %145, <8 x double> %132
  %149 = select <8 x i1> %139, <8 x double> %147, <8 x double> %135
  store <8 x double> %148, ptr %131, align 8
  store <8 x double> %149, ptr %134, align 8
  %150 = fneg <8 x double> %149
  br label %151

151:                                              ; preds = %142, %151
  %152 = phi i64 [ %31, %142 ], [ %177, %151 ]
  %153 = add nuw nsw i64 %152, %127
  %154 = shl i64 %153, 7
  %155 = shl nsw i64 %153, 7
  %156 = getelementptr inbounds i8, ptr %0, i64 %155
  %157 = load <8 x double>, ptr %156, align 8, !noalias !143
  %158 = or disjoint i64 %154, 64
  %159 = getelementptr inbounds i8, ptr %0, i64 %158
  %160 = load <8 x double>, ptr %159, align 8, !noalias !143
  %161 = add nuw nsw i64 %152, %19
  %162 = shl i64 %161, 7
  %163 = shl nsw i64 %161, 7
  %164 = getelementptr inbounds i8, ptr %0, i64 %163
  %165 = load <8 x double>, ptr %164, align 8, !noalias !146
  %166 = or disjoint i64 %162, 64
  %167 = getelementptr inbounds i8, ptr %0, i64 %166
  %168 = load <8 x double>, ptr %167, align 8, !noalias !146
  %169 = fmul <8 x double> %168, %150
  %170 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %148, <8 x double> %165, <8 x double> %169)
  %171 = fmul <8 x double> %149, %165
  %172 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %148, <8 x double> %168, <8 x double> %171)
  %173 = fsub <8 x double> %157, %170
  %174 = fsub <8 x double> %160, %172
  %175 = select <8 x i1> %139, <8 x double> %173, <8 x double> %157
  %176 = select <8 x i1> %139, <8 x double> %174, <8 x double> %160
  store <8 x double> %175, ptr %156, align 8
  store <8 x double> %176, ptr %159, align 8
  %177 = add nuw nsw i64 %152, 1
  %178 = icmp slt i64 %177, %1
  br i1 %178, label %151, label %179, !llvm.loop !149

179:                                              ; preds = %151, %125
  %180 = add nuw nsw i64 %126, 1
  %181 = icmp slt i64 %180, %1
  br i1 %181, label %125, label %5, !llvm.loop !150
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #5

declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg) #8

define internal fastcc void @real_solve(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #7 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %16

6:                                                ; preds = %4, %24
  %7 = phi i64 [ %25, %24 ], [ 0, %4 ]
  %8 = shl nsw i64 %7, 6
  %9 = getelementptr inbounds i8, ptr %2, i64 %8
  %10 = uitofp nneg i64 %7 to double
  %11 = insertelement <8 x double> poison, double %10, i64 0
  %12 = shufflevector <8 x double> %11, <8 x double> poison, <8 x i32> zeroinitializer
  %13 = getelementptr inbounds i8, ptr %3, i64 %8
  %14 = shl nsw i64 %7, 6
  %15 = getelementptr inbounds i8, ptr %2, i64 %14
  br label %18

16:                                               ; preds = %24, %4
  %17 = icmp sgt i64 %1, 0
  br i1 %17, label %44, label %39

18:                                               ; preds = %6, %27
  %19 = phi i64 [ 0, %6 ], [ %37, %27 ]
  %20 = load <8 x double>, ptr %9, align 8
  %21 = fcmp une <8 x double> %20, %12
  %22 = bitcast <8 x i1> %21 to i8
  %23 = icmp eq i8 %22, 0
  br i1 %23, label %24, label %27

24:                                               ; preds = %18, %27
  %25 = add nuw nsw i64 %7, 1
  %26 = icmp eq i64 %25, %1
  br i1 %26, label %16, label %6, !llvm.loop !151

27:                                               ; preds = %18
  %28 = getelementptr inbounds double, ptr %13, i64 %19
  %29 = getelementptr inbounds double, ptr %15, i64 %19
  %30 = load double, ptr %29, align 8
  %31 = fptosi double %30 to i64
  %32 = shl nsw i64 %31, 6
  %33 = getelementptr inbounds i8, ptr %3, i64 %32
  %34 = getelementptr inbounds double, ptr %33, i64 %19
  %35 = load double, ptr %28, align 8
  %36 = load double, ptr %34, align 8
  store double %36, ptr %28, align 8
  store double %35, ptr %34, align 8
  %37 = add nuw nsw i64 %19, 1
  %38 = icmp eq i64 %37, 8
  br i1 %38, label %24, label %18, !llvm.loop !152

39:                                               ; preds = %52, %16
  %40 = icmp sgt i64 %1, 0
  br i1 %40, label %41, label %70

41:                                               ; preds = %39
  %42 = shl i64 %1, 6
  %43 = add i64 %42, 64
  br label %71

44:                                               ; preds = %16, %52
  %45 = phi i64 [ %54, %52 ], [ 0, %16 ]
  %46 = shl nsw i64 %45, 6
  %47 = getelementptr inbounds i8, ptr %3, i64 %46
  %48 = load <8 x double>, ptr %47, align 8
  %49 = icmp eq i64 %45, 0
  br i1 %49, label %52, label %50

50:                                               ; preds = %44
  %51 = mul nuw nsw i64 %45, %1
  br label %56

52:                                               ; preds = %56, %44
  %53 = phi <8 x double> [ %48, %44 ], [ %67, %56 ]
  store <8 x double> %53, ptr %47, align 8
  %54 = add nuw nsw i64 %45, 1
  %55 = icmp eq i64 %54, %1
  br i1 %55, label %39, label %44, !llvm.loop !153

56:                                               ; preds = %50, %56
  %57 = phi i64 [ 0, %50 ], [ %68, %56 ]
  %58 = phi <8 x double> [ %48, %50 ], [ %67, %56 ]
  %59 = add nuw nsw i64 %57, %51
  %60 = shl nsw i64 %59, 6
  %61 = getelementptr inbounds i8, ptr %0, i64 %60
  %62 = load <8 x double>, ptr %61, align 8
  %63 = shl nsw i64 %57, 6
  %64 = getelementptr inbounds i8, ptr %3, i64 %63
  %65 = load <8 x double>, ptr %64, align 8
  %66 = fneg <8 x double> %62
  %67 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %66, <8 x double> %65, <8 x double> %58)
  %68 = add nuw nsw i64 %57, 1
  %69 = icmp eq i64 %68, %45
  br i1 %69, label %52, label %56, !llvm.loop !154

70:                                               ; preds = %80, %39
  ret void

71:                                               ; preds = %41, %80
  %72 = phi i64 [ %1, %41 ], [ %73, %80 ]
  %73 = add nsw i64 %72, -1
  %74 = shl nsw i64 %73, 6
  %75 = getelementptr inbounds i8, ptr %3, i64 %74
  %76 = load <8 x double>, ptr %75, align 8
  %77 = icmp slt i64 %72, %1
  br i1 %77, label %78, label %80

78:                                               ; preds = %71
  %79 = mul nsw i64 %73, %1
  br label %87

80:                                               ; preds = %87, %71
  %81 = phi <8 x double> [ %76, %71 ], [ %98, %87 ]
  %82 = mul i64 %43, %73
  %83 = getelementptr inbounds i8, ptr %0, i64 %82
  %84 = load <8 x double>, ptr %83, align 8
  %85 = fmul <8 x double> %81, %84
  store <8 x double> %85, ptr %75, align 8
  %86 = icmp sgt i64 %72, 1
  br i1 %86, label %71, label %70, !llvm.loop !155

87:                                               ; preds = %78, %87
  %88 = phi i64 [ %72, %78 ], [ %99, %87 ]
  %89 = phi <8 x double> [ %76, %78 ], [ %98, %87 ]
  %90 = add nsw i64 %88, %79
  %91 = shl nsw i64 %90, 6
  %92 = getelementptr inbounds i8, ptr %0, i64 %91
  %93 = load <8 x double>, ptr %92, align 8
  %94 = shl nsw i64 %88, 6
  %95 = getelementptr inbounds i8, ptr %3, i64 %94
  %96 = load <8 x double>, ptr %95, align 8
  %97 = fneg <8 x double> %93
  %98 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %97, <8 x double> %96, <8 x double> %89)
  %99 = add nuw nsw i64 %88, 1
  %100 = icmp eq i64 %99, %1
  br i1 %100, label %80, label %87, !llvm.loop !156
}

define internal fastcc void @pair_solve(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3) unnamed_addr #7 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %17

6:                                                ; preds = %4, %25
  %7 = phi i64 [ %26, %25 ], [ 0, %4 ]
  %8 = shl nsw i64 %7, 6
  %9 = getelementptr inbounds i8, ptr %2, i64 %8
  %10 = uitofp nneg i64 %7 to double
  %11 = insertelement <8 x double> poison, double %10, i64 0
  %12 = shufflevector <8 x double> %11, <8 x double> poison, <8 x i32> zeroinitializer
  %13 = shl i64 %7, 7
  %14 = getelementptr inbounds i8, ptr %3, i64 %13
  %15 = shl nsw i64 %7, 6
  %16 = getelementptr inbounds i8, ptr %2, i64 %15
  br label %19

17:                                               ; preds = %25, %4
  %18 = icmp sgt i64 %1, 0
  br i1 %18, label %51, label %47

19:                                               ; preds = %6, %36
  %20 = phi i64 [ 0, %6 ], [ %37, %36 ]
  %21 = load <8 x double>, ptr %9, align 8
  %22 = fcmp une <8 x double> %21, %12
  %23 = bitcast <8 x i1> %22 to i8
  %24 = icmp eq i8 %23, 0
  br i1 %24, label %25, label %28

25:                                               ; preds = %19, %36
  %26 = add nuw nsw i64 %7, 1
  %27 = icmp eq i64 %26, %1
  br i1 %27, label %17, label %6, !llvm.loop !151

28:                                               ; preds = %19
  %29 = getelementptr inbounds double, ptr %14, i64 %20
  %30 = getelementptr inbounds double, ptr %16, i64 %20
  %31 = load double, ptr %30, align 8
  %32 = fptosi double %31 to i64
  %33 = shl i64 %32, 7
  %34 = getelementptr inbounds i8, ptr %3, i64 %33
  %35 = getelementptr inbounds double, ptr %34, i64 %20
  br label %39

36:                                               ; preds = %39
  %37 = add nuw nsw i64 %20, 1
  %38 = icmp eq i64 %37, 8
  br i1 %38, label %25, label %19, !llvm.loop !152

39:                                               ; preds = %28, %39
  %40 = phi i64 [ 0, %28 ], [ %45, %39 ]
  %41 = getelementptr inbounds double, ptr %29, i64 %40
  %42 = load double, ptr %41, align 8
  %43 = getelementptr inbounds double, ptr %35, i64 %40
  %44 = load double, ptr %43, align 8
  store double %44, ptr %41, align 8
  store double %42, ptr %43, align 8
  %45 = add nuw nsw i64 %40, 8
  %46 = icmp eq i64 %40, 0
  br i1 %46, label %39, label %36, !llvm.loop !157

47:                                               ; preds = %63, %17
  %48 = icmp sgt i64 %1, 0
  br i1 %48, label %49, label %96

49:                                               ; preds = %47
  %50 = add nuw i64 %1, 1
  br label %97

51:                                               ; preds = %17, %63
  %52 = phi i64 [ %66, %63 ], [ 0, %17 ]
  %53 = shl i64 %52, 7
  %54 = shl nsw i64 %52, 7
  %55 = getelementptr inbounds i8, ptr %3, i64 %54
  %56 = load <8 x double>, ptr %55, align 8, !noalias !158
  %57 = or disjoint i64 %53, 64
  %58 = getelementptr inbounds i8, ptr %3, i64 %57
  %59 = load <8 x double>, ptr %58, align 8, !noalias !158
  %60 = icmp eq i64 %52, 0
  br i1 %60, label %63, label %61

61:                                               ; preds = %51
  %62 = mul nuw nsw i64 %52, %1
  br label %68

63:                                               ; preds = %68, %51
  %64 = phi <8 x double> [ %56, %51 ], [ %92, %68 ]
  %65 = phi <8 x double> [ %59, %51 ], [ %93, %68 ]
  store <8 x double> %64, ptr %55, align 8
  store <8 x double> %65, ptr %58, align 8
  %66 = add nuw nsw i64 %52, 1
  %67 = icmp eq i64 %66, %1
  br i1 %67, label %47, label %51, !llvm.loop !161

68:                                               ; preds = %61, %68
  %69 = phi i64 [ 0, %61 ], [ %94, %68 ]
  %70 = phi <8 x double> [ %59, %61 ], [ %93, %68 ]
  %71 = phi <8 x double> [ %56, %61 ], [ %92, %68 ]
  %72 = add nuw nsw i64 %69, %62
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !162
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !162
  %80 = shl i64 %69, 7
  %81 = shl nsw i64 %69, 7
  %82 = getelementptr inbounds i8, ptr %3, i64 %81
  %83 = load <8 x double>, ptr %82, align 8, !noalias !165
  %84 = or disjoint i64 %80, 64
  %85 = getelementptr inbounds i8, ptr %3, i64 %84
  %86 = load <8 x double>, ptr %85, align 8, !noalias !165
  %87 = fneg <8 x double> %79
  %88 = fmul <8 x double> %86, %87
  %89 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %83, <8 x double> %88)
  %90 = fmul <8 x double> %79, %83
  %91 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %86, <8 x double> %90)
  %92 = fsub <8 x double> %71, %89
  %93 = fsub <8 x double> %70, %91
  %94 = add nuw nsw i64 %69, 1
  %95 = icmp eq i64 %94, %52
  br i1 %95, label %63, label %68, !llvm.loop !168

96:                                               ; preds = %110, %47
  ret void

97:                                               ; preds = %49, %110
  %98 = phi i64 [ %1, %49 ], [ %99, %110 ]
  %99 = add nsw i64 %98, -1
  %100 = shl i64 %99, 7
  %101 = shl nsw i64 %99, 7
  %102 = getelementptr inbounds i8, ptr %3, i64 %101
  %103 = load <8 x double>, ptr %102, align 8, !noalias !169
  %104 = or disjoint i64 %100, 64
  %105 = getelementptr inbounds i8, ptr %3, i64 %104
  %106 = load <8 x double>, ptr %105, align 8, !noalias !169
  %107 = icmp slt i64 %98, %1
  br i1 %107, label %108, label %110

108:                                              ; preds = %97
  %109 = mul nsw i64 %99, %1
  br label %127

110:                                              ; preds = %127, %97
  %111 = phi <8 x double> [ %103, %97 ], [ %151, %127 ]
  %112 = phi <8 x double> [ %106, %97 ], [ %152, %127 ]
  %113 = mul i64 %99, %50
  %114 = shl i64 %113, 7
  %115 = shl nsw i64 %113, 7
  %116 = getelementptr inbounds i8, ptr %0, i64 %115
  %117 = load <8 x double>, ptr %116, align 8, !noalias !172
  %118 = or disjoint i64 %114, 64
  %119 = getelementptr inbounds i8, ptr %0, i64 %118
  %120 = load <8 x double>, ptr %119, align 8, !noalias !172
  %121 = fneg <8 x double> %112
  %122 = fmul <8 x double> %120, %121
  %123 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %117, <8 x double> %122)
  %124 = fmul <8 x double> %112, %117
  %125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %120, <8 x double> %124)
  store <8 x double> %123, ptr %102, align 8
  store <8 x double> %125, ptr %105, align 8
  %126 = icmp sgt i64 %98, 1
  br i1 %126, label %97, label %96, !llvm.loop !175

127:                                              ; preds = %108, %127
  %128 = phi i64 [ %98, %108 ], [ %153, %127 ]
  %129 = phi <8 x double> [ %106, %108 ], [ %152, %127 ]
  %130 = phi <8 x double> [ %103, %108 ], [ %151, %127 ]
  %131 = add nsw i64 %128, %109
  %132 = shl i64 %131, 7
  %133 = shl nsw i64 %131, 7
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !176
  %136 = or disjoint i64 %132, 64
  %137 = getelementptr inbounds i8, ptr %0, i64 %136
  %138 = load <8 x double>, ptr %137, align 8, !noalias !176
  %139 = shl i64 %128, 7
  %140 = shl nsw i64 %128, 7
  %141 = getelementptr inbounds i8, ptr %3, i64 %140
  %142 = load <8 x double>, ptr %141, align 8, !noalias !179
  %143 = or disjoint i64 %139, 64
  %144 = getelementptr inbounds i8, ptr %3, i64 %143
  %145 = load <8 x double>, ptr %144, align 8, !noalias !179
  %146 = fneg <8 x double> %138
  %147 = fmul <8 x double> %145, %146
  %148 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %142, <8 x double> %147)
  %149 = fmul <8 x double> %138, %142
  %150 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %145, <8 x double> %149)
  %151 = fsub <8 x double> %130, %148
  %152 = fsub <8 x double> %129, %150
  %153 = add nuw nsw i64 %128, 1
  %154 = icmp eq i64 %153, %1
  br i1 %154, label %110, label %127, !llvm.loop !182
}

define internal fastcc void @real_solve_columns(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3, i64 noundef %4) unnamed_addr #7 {
  %6 = shl i64 %4, 6
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %23

8:                                                ; preds = %5
  %9 = shl i64 %4, 6
  %10 = shl nsw i64 %4, 3
  %11 = icmp sgt i64 %4, 0
  br label %12

12:                                               ; preds = %8, %33
  %13 = phi i64 [ 0, %8 ], [ %34, %33 ]
  %14 = shl nsw i64 %13, 6
  %15 = getelementptr inbounds i8, ptr %2, i64 %14
  %16 = mul i64 %6, %13
  %17 = uitofp nneg i64 %13 to double
  %18 = insertelement <8 x double> poison, double %17, i64 0
  %19 = shufflevector <8 x double> %18, <8 x double> poison, <8 x i32> zeroinitializer
  %20 = getelementptr inbounds i8, ptr %3, i64 %16
  %21 = shl nsw i64 %13, 6
  %22 = getelementptr inbounds i8, ptr %2, i64 %21
  br label %27

23:                                               ; preds = %33, %5
  %24 = icmp sgt i64 %1, 0
  br i1 %24, label %25, label %61

25:                                               ; preds = %23
  %26 = icmp sgt i64 %4, 0
  br label %55

27:                                               ; preds = %12, %44
  %28 = phi i64 [ 0, %12 ], [ %45, %44 ]
  %29 = load <8 x double>, ptr %15, align 8
  %30 = fcmp une <8 x double> %29, %19
  %31 = bitcast <8 x i1> %30 to i8
  %32 = icmp eq i8 %31, 0
  br i1 %32, label %33, label %36

33:                                               ; preds = %27, %44
  %34 = add nuw nsw i64 %13, 1
  %35 = icmp eq i64 %34, %1
  br i1 %35, label %23, label %12, !llvm.loop !151

36:                                               ; preds = %27
  %37 = getelementptr inbounds double, ptr %20, i64 %28
  %38 = getelementptr inbounds double, ptr %22, i64 %28
  %39 = load double, ptr %38, align 8
  %40 = fptosi double %39 to i64
  %41 = mul i64 %9, %40
  %42 = getelementptr inbounds i8, ptr %3, i64 %41
  %43 = getelementptr inbounds double, ptr %42, i64 %28
  br i1 %11, label %47, label %44

44:                                               ; preds = %47, %36
  %45 = add nuw nsw i64 %28, 1
  %46 = icmp eq i64 %45, 8
  br i1 %46, label %33, label %27, !llvm.loop !152

47:                                               ; preds = %36, %47
  %48 = phi i64 [ %53, %47 ], [ 0, %36 ]
  %49 = getelementptr inbounds double, ptr %37, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = getelementptr inbounds double, ptr %43, i64 %48
  %52 = load double, ptr %51, align 8
  store double %52, ptr %49, align 8
  store double %50, ptr %51, align 8
  %53 = add nuw nsw i64 %48, 8
  %54 = icmp slt i64 %53, %10
  br i1 %54, label %47, label %44, !llvm.loop !157

55:                                               ; preds = %25, %68
  %56 = phi i64 [ 0, %25 ], [ %69, %68 ]
  %57 = icmp eq i64 %56, 0
  br i1 %57, label %68, label %58

58:                                               ; preds = %55
  %59 = mul nuw nsw i64 %56, %1
  %60 = mul nsw i64 %56, %4
  br label %71

61:                                               ; preds = %68, %23
  %62 = icmp sgt i64 %1, 0
  br i1 %62, label %63, label %105

63:                                               ; preds = %61
  %64 = icmp sgt i64 %4, 0
  %65 = icmp sgt i64 %4, 0
  %66 = shl i64 %1, 6
  %67 = add i64 %66, 64
  br label %98

68:                                               ; preds = %93, %55
  %69 = add nuw nsw i64 %56, 1
  %70 = icmp eq i64 %69, %1
  br i1 %70, label %61, label %55, !llvm.loop !183

71:                                               ; preds = %58, %93
  %72 = phi i64 [ 0, %58 ], [ %94, %93 ]
  br i1 %26, label %73, label %93

73:                                               ; preds = %71
  %74 = add nuw nsw i64 %72, %59
  %75 = shl nsw i64 %74, 6
  %76 = getelementptr inbounds i8, ptr %0, i64 %75
  %77 = load <8 x double>, ptr %76, align 8
  %78 = mul nuw nsw i64 %72, %4
  %79 = fneg <8 x double> %77
  br label %80

80:                                               ; preds = %73, %80
  %81 = phi i64 [ 0, %73 ], [ %91, %80 ]
  %82 = add nuw nsw i64 %81, %60
  %83 = shl nsw i64 %82, 6
  %84 = getelementptr inbounds i8, ptr %3, i64 %83
  %85 = load <8 x double>, ptr %84, align 8
  %86 = add nuw nsw i64 %81, %78
  %87 = shl nsw i64 %86, 6
  %88 = getelementptr inbounds i8, ptr %3, i64 %87
  %89 = load <8 x double>, ptr %88, align 8
  %90 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %79, <8 x double> %89, <8 x double> %85)
  store <8 x double> %90, ptr %84, align 8
  %91 = add nuw nsw i64 %81, 1
  %92 = icmp eq i64 %91, %4
  br i1 %92, label %93, label %80, !llvm.loop !184

93:                                               ; preds = %80, %71
  %94 = add nuw nsw i64 %72, 1
  %95 = icmp eq i64 %94, %56
  br i1 %95, label %68, label %71, !llvm.loop !185

96:                                               ; preds = %136, %106
  %97 = icmp sgt i64 %99, 1
  br i1 %97, label %98, label %105, !llvm.loop !186

98:                                               ; preds = %63, %96
  %99 = phi i64 [ %1, %63 ], [ %100, %96 ]
  %100 = add nsw i64 %99, -1
  %101 = icmp slt i64 %99, %1
  br i1 %101, label %102, label %106

102:                                              ; preds = %98
  %103 = mul nsw i64 %100, %1
  %104 = mul nsw i64 %100, %4
  br label %111

105:                                              ; preds = %96, %61
  ret void

106:                                              ; preds = %133, %98
  br i1 %65, label %107, label %96

107:                                              ; preds = %106
  %108 = mul i64 %67, %100
  %109 = mul nsw i64 %100, %4
  %110 = getelementptr inbounds i8, ptr %0, i64 %108
  br label %136

111:                                              ; preds = %102, %133
  %112 = phi i64 [ %99, %102 ], [ %134, %133 ]
  br i1 %64, label %113, label %133

113:                                              ; preds = %111
  %114 = add nuw nsw i64 %112, %103
  %115 = shl nsw i64 %114, 6
  %116 = getelementptr inbounds i8, ptr %0, i64 %115
  %117 = load <8 x double>, ptr %116, align 8
  %118 = mul nsw i64 %112, %4
  %119 = fneg <8 x double> %117
  br label %120

120:                                              ; preds = %113, %120
  %121 = phi i64 [ 0, %113 ], [ %131, %120 ]
  %122 = add nsw i64 %121, %104
  %123 = shl nsw i64 %122, 6
  %124 = getelementptr inbounds i8, ptr %3, i64 %123
  %125 = load <8 x double>, ptr %124, align 8
  %126 = add nsw i64 %121, %118
  %127 = shl nsw i64 %126, 6
  %128 = getelementptr inbounds i8, ptr %3, i64 %127
  %129 = load <8 x double>, ptr %128, align 8
  %130 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %119, <8 x double> %129, <8 x double> %125)
  store <8 x double> %130, ptr %124, align 8
  %131 = add nuw nsw i64 %121, 1
  %132 = icmp eq i64 %131, %4
  br i1 %132, label %133, label %120, !llvm.loop !184

133:                                              ; preds = %120, %111
  %134 = add nuw nsw i64 %112, 1
  %135 = icmp eq i64 %134, %1
  br i1 %135, label %106, label %111, !llvm.loop !187

136:                                              ; preds = %107, %136
  %137 = phi i64 [ 0, %107 ], [ %144, %136 ]
  %138 = add nsw i64 %137, %109
  %139 = shl nsw i64 %138, 6
  %140 = getelementptr inbounds i8, ptr %3, i64 %139
  %141 = load <8 x double>, ptr %140, align 8
  %142 = load <8 x double>, ptr %110, align 8
  %143 = fmul <8 x double> %141, %142
  store <8 x double> %143, ptr %140, align 8
  %144 = add nuw nsw i64 %137, 1
  %145 = icmp eq i64 %144, %4
  br i1 %145, label %96, label %136, !llvm.loop !188
}

define internal fastcc void @pair_solve_columns(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2, ptr noundef %3, i64 noundef %4) unnamed_addr #7 {
  %6 = shl i64 %4, 7
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %23

8:                                                ; preds = %5
  %9 = shl i64 %4, 7
  %10 = shl nsw i64 %4, 4
  %11 = icmp sgt i64 %4, 0
  br label %12

12:                                               ; preds = %8, %33
  %13 = phi i64 [ 0, %8 ], [ %34, %33 ]
  %14 = shl nsw i64 %13, 6
  %15 = getelementptr inbounds i8, ptr %2, i64 %14
  %16 = mul i64 %6, %13
  %17 = uitofp nneg i64 %13 to double
  %18 = insertelement <8 x double> poison, double %17, i64 0
  %19 = shufflevector <8 x double> %18, <8 x double> poison, <8 x i32> zeroinitializer
  %20 = getelementptr inbounds i8, ptr %3, i64 %16
  %21 = shl nsw i64 %13, 6
  %22 = getelementptr inbounds i8, ptr %2, i64 %21
  br label %27

23:                                               ; preds = %33, %5
  %24 = icmp sgt i64 %1, 0
  br i1 %24, label %25, label %61

25:                                               ; preds = %23
  %26 = icmp sgt i64 %4, 0
  br label %55

27:                                               ; preds = %12, %44
  %28 = phi i64 [ 0, %12 ], [ %45, %44 ]
  %29 = load <8 x double>, ptr %15, align 8
  %30 = fcmp une <8 x double> %29, %19
  %31 = bitcast <8 x i1> %30 to i8
  %32 = icmp eq i8 %31, 0
  br i1 %32, label %33, label %36

33:                                               ; preds = %27, %44
  %34 = add nuw nsw i64 %13, 1
  %35 = icmp eq i64 %34, %1
  br i1 %35, label %23, label %12, !llvm.loop !151

36:                                               ; preds = %27
  %37 = getelementptr inbounds double, ptr %20, i64 %28
  %38 = getelementptr inbounds double, ptr %22, i64 %28
  %39 = load double, ptr %38, align 8
  %40 = fptosi double %39 to i64
  %41 = mul i64 %9, %40
  %42 = getelementptr inbounds i8, ptr %3, i64 %41
  %43 = getelementptr inbounds double, ptr %42, i64 %28
  br i1 %11, label %47, label %44

44:                                               ; preds = %47, %36
  %45 = add nuw nsw i64 %28, 1
  %46 = icmp eq i64 %45, 8
  br i1 %46, label %33, label %27, !llvm.loop !152

47:                                               ; preds = %36, %47
  %48 = phi i64 [ %53, %47 ], [ 0, %36 ]
  %49 = getelementptr inbounds double, ptr %37, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = getelementptr inbounds double, ptr %43, i64 %48
  %52 = load double, ptr %51, align 8
  store double %52, ptr %49, align 8
  store double %50, ptr %51, align 8
  %53 = add nuw nsw i64 %48, 8
  %54 = icmp slt i64 %53, %10
  br i1 %54, label %47, label %44, !llvm.loop !157

55:                                               ; preds = %25, %67
  %56 = phi i64 [ 0, %25 ], [ %68, %67 ]
  %57 = icmp eq i64 %56, 0
  br i1 %57, label %67, label %58

58:                                               ; preds = %55
  %59 = mul nuw nsw i64 %56, %1
  %60 = mul nsw i64 %56, %4
  br label %70

61:                                               ; preds = %67, %23
  %62 = icmp sgt i64 %1, 0
  br i1 %62, label %63, label %121

63:                                               ; preds = %61
  %64 = icmp sgt i64 %4, 0
  %65 = icmp sgt i64 %4, 0
  %66 = add nuw i64 %1, 1
  br label %114

67:                                               ; preds = %109, %55
  %68 = add nuw nsw i64 %56, 1
  %69 = icmp eq i64 %68, %1
  br i1 %69, label %61, label %55, !llvm.loop !189

70:                                               ; preds = %58, %109
  %71 = phi i64 [ 0, %58 ], [ %110, %109 ]
  %72 = add nuw nsw i64 %71, %59
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !190
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !190
  br i1 %26, label %80, label %109

80:                                               ; preds = %70
  %81 = mul nuw nsw i64 %71, %4
  %82 = fneg <8 x double> %79
  br label %83

83:                                               ; preds = %80, %83
  %84 = phi i64 [ 0, %80 ], [ %107, %83 ]
  %85 = add nuw nsw i64 %84, %60
  %86 = shl i64 %85, 7
  %87 = shl nsw i64 %85, 7
  %88 = getelementptr inbounds i8, ptr %3, i64 %87
  %89 = load <8 x double>, ptr %88, align 8, !noalias !193
  %90 = or disjoint i64 %86, 64
  %91 = getelementptr inbounds i8, ptr %3, i64 %90
  %92 = load <8 x double>, ptr %91, align 8, !noalias !193
  %93 = add nuw nsw i64 %84, %81
  %94 = shl i64 %93, 7
  %95 = shl nsw i64 %93, 7
  %96 = getelementptr inbounds i8, ptr %3, i64 %95
  %97 = load <8 x double>, ptr %96, align 8, !noalias !196
  %98 = or disjoint i64 %94, 64
  %99 = getelementptr inbounds i8, ptr %3, i64 %98
  %100 = load <8 x double>, ptr %99, align 8, !noalias !196
  %101 = fmul <8 x double> %100, %82
  %102 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %97, <8 x double> %101)
  %103 = fmul <8 x double> %79, %97
  %104 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %100, <8 x double> %103)
  %105 = fsub <8 x double> %89, %102
  %106 = fsub <8 x double> %92, %104
  store <8 x double> %105, ptr %88, align 8
  store <8 x double> %106, ptr %91, align 8
  %107 = add nuw nsw i64 %84, 1
  %108 = icmp eq i64 %107, %4
  br i1 %108, label %109, label %83, !llvm.loop !199

109:                                              ; preds = %83, %70
  %110 = add nuw nsw i64 %71, 1
  %111 = icmp eq i64 %110, %56
  br i1 %111, label %67, label %70, !llvm.loop !200

112:                                              ; preds = %173, %122
  %113 = icmp sgt i64 %115, 1
  br i1 %113, label %114, label %121, !llvm.loop !201

114:                                              ; preds = %63, %112
  %115 = phi i64 [ %1, %63 ], [ %116, %112 ]
  %116 = add nsw i64 %115, -1
  %117 = icmp slt i64 %115, %1
  br i1 %117, label %118, label %122

118:                                              ; preds = %114
  %119 = mul nsw i64 %116, %1
  %120 = mul nsw i64 %116, %4
  br label %131

121:                                              ; preds = %112, %61
  ret void

122:                                              ; preds = %170, %114
  br i1 %65, label %123, label %112

123:                                              ; preds = %122
  %124 = mul nsw i64 %116, %4
  %125 = mul i64 %116, %66
  %126 = shl i64 %125, 7
  %127 = shl nsw i64 %125, 7
  %128 = getelementptr inbounds i8, ptr %0, i64 %127
  %129 = or disjoint i64 %126, 64
  %130 = getelementptr inbounds i8, ptr %0, i64 %129
  br label %173

131:                                              ; preds = %118, %170
  %132 = phi i64 [ %115, %118 ], [ %171, %170 ]
  %133 = add nuw nsw i64 %132, %119
  %134 = shl i64 %133, 7
  %135 = shl nsw i64 %133, 7
  %136 = getelementptr inbounds i8, ptr %0, i64 %135
  %137 = load <8 x double>, ptr %136, align 8, !noalias !202
  %138 = or disjoint i64 %134, 64
  %139 = getelementptr inbounds i8, ptr %0, i64 %138
  %140 = load <8 x double>, ptr %139, align 8, !noalias !202
  br i1 %64, label %141, label %170

141:                                              ; preds = %131
  %142 = mul nsw i64 %132, %4
  %143 = fneg <8 x double> %140
  br label %144

144:                                              ; preds = %141, %144
  %145 = phi i64 [ 0, %141 ], [ %168, %144 ]
  %146 = add nsw i64 %145, %120
  %147 = shl i64 %146, 7
  %148 = shl nsw i64 %146, 7
  %149 = getelementptr inbounds i8, ptr %3, i64 %148
  %150 = load <8 x double>, ptr %149, align 8, !noalias !205
  %151 = or disjoint i64 %147, 64
  %152 = getelementptr inbounds i8, ptr %3, i64 %151
  %153 = load <8 x double>, ptr %152, align 8, !noalias !205
  %154 = add nsw i64 %145, %142
  %155 = shl i64 %154, 7
  %156 = shl nsw i64 %154, 7
  %157 = getelementptr inbounds i8, ptr %3, i64 %156
  %158 = load <8 x double>, ptr %157, align 8, !noalias !208
  %159 = or disjoint i64 %155, 64
  %160 = getelementptr inbounds i8, ptr %3, i64 %159
  %161 = load <8 x double>, ptr %160, align 8, !noalias !208
  %162 = fmul <8 x double> %161, %143
  %163 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %137, <8 x double> %158, <8 x double> %162)
  %164 = fmul <8 x double> %140, %158
  %165 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %137, <8 x double> %161, <8 x double> %164)
  %166 = fsub <8 x double> %150, %163
  %167 = fsub <8 x double> %153, %165
  store <8 x double> %166, ptr %149, align 8
  store <8 x double> %167, ptr %152, align 8
  %168 = add nuw nsw i64 %145, 1
  %169 = icmp eq i64 %168, %4
  br i1 %169, label %170, label %144, !llvm.loop !199

170:                                              ; preds = %144, %131
  %171 = add nuw nsw i64 %132, 1
  %172 = icmp eq i64 %171, %1
  br i1 %172, label %122, label %131, !llvm.loop !211

173:                                              ; preds = %123, %173
  %174 = phi i64 [ 0, %123 ], [ %190, %173 ]
  %175 = add nsw i64 %174, %124
  %176 = shl i64 %175, 7
  %177 = shl nsw i64 %175, 7
  %178 = getelementptr inbounds i8, ptr %3, i64 %177
  %179 = load <8 x double>, ptr %178, align 8, !noalias !212
  %180 = or disjoint i64 %176, 64
  %181 = getelementptr inbounds i8, ptr %3, i64 %180
  %182 = load <8 x double>, ptr %181, align 8, !noalias !212
  %183 = load <8 x double>, ptr %128, align 8, !noalias !215
  %184 = load <8 x double>, ptr %130, align 8, !noalias !215
  %185 = fneg <8 x double> %182
  %186 = fmul <8 x double> %184, %185
  %187 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %183, <8 x double> %186)
  %188 = fmul <8 x double> %182, %183
  %189 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %184, <8 x double> %188)
  store <8 x double> %187, ptr %178, align 8
  store <8 x double> %189, ptr %181, align 8
  %190 = add nuw nsw i64 %174, 1
  %191 = icmp eq i64 %190, %4
  br i1 %191, label %112, label %173, !llvm.loop !218
}

define internal fastcc range(i64 0, 256) i64 @quiet_lanes(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3) unnamed_addr #3 {
  %5 = alloca [5 x <8 x double>], align 64
  %6 = getelementptr inbounds i8, ptr %0, i64 1272
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 1224
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = getelementptr inbounds i8, ptr %13, i64 864
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 1464
  %17 = load ptr, ptr %16, align 8
  %18 = load <8 x double>, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 696
  %20 = load ptr, ptr %19, align 8
  %21 = load <8 x double>, ptr %20, align 8
  %22 = fcmp une <8 x double> %18, %21
  %23 = bitcast <8 x i1> %22 to i8
  %24 = zext i8 %23 to i64
  %25 = and i64 %24, %2
  %26 = icmp eq i64 %25, 0
  br i1 %26, label %101, label %27

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 1416
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 144
  %31 = getelementptr inbounds i8, ptr %1, i64 16
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 72
  %34 = load ptr, ptr %33, align 8
  %35 = load <8 x double>, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %32, i64 48
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %32, i64 96
  %39 = load ptr, ptr %38, align 8
  store <8 x double> zeroinitializer, ptr %39, align 8
  %40 = load ptr, ptr %32, align 8
  %41 = getelementptr inbounds i8, ptr %32, i64 192
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %32, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %1, align 8
  %46 = load ptr, ptr %45, align 8
  %47 = getelementptr inbounds i8, ptr %46, i64 24
  %48 = load i64, ptr %47, align 8
  %49 = load ptr, ptr %38, align 8
  %50 = getelementptr inbounds i8, ptr %1, i64 8
  %51 = load ptr, ptr %50, align 8
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds i8, ptr %52, i64 16
  %54 = load i64, ptr %53, align 8
  tail call fastcc void @nested(ptr noundef %37, ptr noundef %40, ptr noundef %42, i64 noundef %44, i64 noundef %48, ptr noundef %49, i64 noundef %54) #11
  %55 = fmul <8 x double> %35, zeroinitializer
  %56 = fadd <8 x double> %21, %55
  %57 = getelementptr inbounds i8, ptr %0, i64 168
  %58 = load ptr, ptr %57, align 8
  store <8 x double> %56, ptr %58, align 8
  %59 = load ptr, ptr %30, align 8
  %60 = getelementptr inbounds i8, ptr %59, i64 40
  %61 = load i64, ptr %60, align 8
  %62 = icmp eq i64 %61, 0
  br i1 %62, label %64, label %63

63:                                               ; preds = %27
  tail call fastcc void @settle(ptr noundef nonnull %30) #11
  br label %64

64:                                               ; preds = %63, %27
  %65 = getelementptr inbounds i8, ptr %0, i64 296
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %69

68:                                               ; preds = %64
  tail call fastcc void @sample(ptr noundef nonnull %30) #11
  br label %69

69:                                               ; preds = %64, %68
  %70 = load ptr, ptr %6, align 8
  %71 = load i64, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %0, i64 168
  %73 = load ptr, ptr %72, align 8
  %74 = load ptr, ptr %31, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 48
  %76 = load ptr, ptr %75, align 8
  %77 = getelementptr inbounds i8, ptr %0, i64 192
  %78 = load ptr, ptr %77, align 8
  %79 = getelementptr inbounds i8, ptr %0, i64 1296
  %80 = load ptr, ptr %79, align 8
  %81 = inttoptr i64 %71 to ptr
  %82 = load ptr, ptr %81, align 8
  %83 = tail call i32 %82(ptr noundef %73, ptr noundef %76, ptr noundef %78, ptr noundef %80, ptr noundef %29) #12
  %84 = zext i32 %83 to i64
  %85 = and i64 %84, %24
  %86 = icmp sgt i64 %9, 0
  br i1 %86, label %87, label %101

87:                                               ; preds = %69
  %88 = getelementptr inbounds i8, ptr %0, i64 1392
  br label %89

89:                                               ; preds = %87, %89
  %90 = phi i64 [ 0, %87 ], [ %99, %89 ]
  %91 = load ptr, ptr %88, align 8
  %92 = load ptr, ptr %28, align 8
  %93 = shl nsw i64 %90, 6
  %94 = getelementptr inbounds i8, ptr %92, i64 %93
  %95 = load <8 x i64>, ptr %94, align 8
  %96 = getelementptr inbounds i8, ptr %91, i64 %93
  %97 = load <8 x i64>, ptr %96, align 8
  %98 = select <8 x i1> %22, <8 x i64> %95, <8 x i64> %97
  store <8 x i64> %98, ptr %96, align 8
  %99 = add nuw nsw i64 %90, 1
  %100 = icmp eq i64 %99, %9
  br i1 %100, label %101, label %89, !llvm.loop !219

101:                                              ; preds = %89, %69, %4
  %102 = phi i64 [ 0, %4 ], [ %85, %69 ], [ %85, %89 ]
  %103 = getelementptr inbounds i8, ptr %0, i64 1392
  %104 = shl i64 %9, 6
  %105 = getelementptr inbounds i8, ptr %0, i64 144
  %106 = getelementptr inbounds i8, ptr %1, i64 16
  %107 = getelementptr inbounds i8, ptr %1, i64 8
  %108 = getelementptr inbounds i8, ptr %0, i64 168
  %109 = getelementptr inbounds i8, ptr %0, i64 296
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %126

113:                                              ; preds = %172
  %114 = xor i64 %185, -1
  %115 = and i64 %114, %2
  %116 = trunc i64 %115 to i8
  %117 = bitcast i8 %116 to <8 x i1>
  %118 = sext <8 x i1> %117 to <8 x i64>
  %119 = icmp sgt i64 %9, 0
  br i1 %119, label %120, label %188

120:                                              ; preds = %113
  %121 = getelementptr inbounds i8, ptr %0, i64 1440
  %122 = load ptr, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %0, i64 1392
  %124 = load ptr, ptr %123, align 8
  %125 = getelementptr inbounds i8, ptr %5, i64 64
  br label %195

126:                                              ; preds = %101, %172
  %127 = phi i64 [ 1, %101 ], [ %186, %172 ]
  %128 = phi i64 [ %102, %101 ], [ %185, %172 ]
  %129 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %127
  %130 = load double, ptr %129, align 8
  %131 = load ptr, ptr %103, align 8
  %132 = mul i64 %104, %127
  %133 = getelementptr inbounds i8, ptr %131, i64 %132
  %134 = load ptr, ptr %19, align 8
  %135 = load <8 x double>, ptr %134, align 8
  %136 = load ptr, ptr %106, align 8
  %137 = getelementptr inbounds i8, ptr %136, i64 72
  %138 = load ptr, ptr %137, align 8
  %139 = load <8 x double>, ptr %138, align 8
  %140 = insertelement <8 x double> poison, double %130, i64 0
  %141 = shufflevector <8 x double> %140, <8 x double> poison, <8 x i32> zeroinitializer
  %142 = getelementptr inbounds i8, ptr %136, i64 48
  %143 = load ptr, ptr %142, align 8
  %144 = getelementptr inbounds i8, ptr %136, i64 96
  %145 = load ptr, ptr %144, align 8
  store <8 x double> %141, ptr %145, align 8
  %146 = load ptr, ptr %136, align 8
  %147 = getelementptr inbounds i8, ptr %136, i64 192
  %148 = load ptr, ptr %147, align 8
  %149 = getelementptr inbounds i8, ptr %136, i64 8
  %150 = load i64, ptr %149, align 8
  %151 = load ptr, ptr %1, align 8
  %152 = load ptr, ptr %151, align 8
  %153 = getelementptr inbounds i8, ptr %152, i64 24
  %154 = load i64, ptr %153, align 8
  %155 = load ptr, ptr %144, align 8
  %156 = load ptr, ptr %107, align 8
  %157 = load ptr, ptr %156, align 8
  %158 = getelementptr inbounds i8, ptr %157, i64 16
  %159 = load i64, ptr %158, align 8
  tail call fastcc void @nested(ptr noundef %143, ptr noundef %146, ptr noundef %148, i64 noundef %150, i64 noundef %154, ptr noundef %155, i64 noundef %159) #11
  %160 = fmul <8 x double> %141, %139
  %161 = fadd <8 x double> %135, %160
  %162 = load ptr, ptr %108, align 8
  store <8 x double> %161, ptr %162, align 8
  %163 = load ptr, ptr %105, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 40
  %165 = load i64, ptr %164, align 8
  %166 = icmp eq i64 %165, 0
  br i1 %166, label %168, label %167

167:                                              ; preds = %126
  tail call fastcc void @settle(ptr noundef nonnull %105) #11
  br label %168

168:                                              ; preds = %167, %126
  %169 = load i64, ptr %109, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %168
  tail call fastcc void @sample(ptr noundef nonnull %105) #11
  br label %172

172:                                              ; preds = %168, %171
  %173 = load ptr, ptr %6, align 8
  %174 = load i64, ptr %173, align 8
  %175 = load ptr, ptr %110, align 8
  %176 = load ptr, ptr %106, align 8
  %177 = getelementptr inbounds i8, ptr %176, i64 48
  %178 = load ptr, ptr %177, align 8
  %179 = load ptr, ptr %111, align 8
  %180 = load ptr, ptr %112, align 8
  %181 = inttoptr i64 %174 to ptr
  %182 = load ptr, ptr %181, align 8
  %183 = tail call i32 %182(ptr noundef %175, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %133) #12
  %184 = zext i32 %183 to i64
  %185 = or i64 %128, %184
  %186 = add nuw nsw i64 %127, 1
  %187 = icmp eq i64 %186, 5
  br i1 %187, label %113, label %126, !llvm.loop !220

188:                                              ; preds = %316, %113
  %189 = phi <8 x i64> [ %118, %113 ], [ %318, %316 ]
  %190 = icmp sgt i64 %9, 0
  br i1 %190, label %191, label %321

191:                                              ; preds = %188
  %192 = getelementptr inbounds i8, ptr %0, i64 1392
  %193 = shl i64 %9, 8
  %194 = icmp slt <8 x i64> %189, zeroinitializer
  br label %330

195:                                              ; preds = %120, %316
  %196 = phi <8 x double> [ undef, %120 ], [ %230, %316 ]
  %197 = phi <8 x double> [ undef, %120 ], [ %225, %316 ]
  %198 = phi i64 [ 0, %120 ], [ %319, %316 ]
  %199 = phi <8 x i64> [ %118, %120 ], [ %318, %316 ]
  %200 = shl nsw i64 %198, 6
  %201 = getelementptr inbounds i8, ptr %122, i64 %200
  %202 = load <8 x double>, ptr %201, align 8
  br label %208

203:                                              ; preds = %234
  %204 = getelementptr inbounds i64, ptr %15, i64 %198
  %205 = load i64, ptr %204, align 8
  %206 = and i64 %205, 1
  %207 = icmp eq i64 %206, 0
  br i1 %207, label %238, label %250

208:                                              ; preds = %195, %234
  %209 = phi i64 [ 0, %195 ], [ %236, %234 ]
  %210 = phi <8 x double> [ %196, %195 ], [ %230, %234 ]
  %211 = phi <8 x double> [ %197, %195 ], [ %225, %234 ]
  %212 = phi <8 x i64> [ %199, %195 ], [ %235, %234 ]
  %213 = mul nuw nsw i64 %9, %209
  %214 = add nuw nsw i64 %213, %198
  %215 = shl nsw i64 %214, 6
  %216 = getelementptr inbounds i8, ptr %124, i64 %215
  %217 = load <8 x double>, ptr %216, align 8
  %218 = fmul <8 x double> %202, %217
  %219 = getelementptr inbounds [5 x <8 x double>], ptr %5, i64 0, i64 %209
  store <8 x double> %218, ptr %219, align 64
  %220 = icmp eq i64 %209, 0
  br i1 %220, label %224, label %221

221:                                              ; preds = %208
  %222 = fcmp olt <8 x double> %211, %217
  %223 = select <8 x i1> %222, <8 x double> %211, <8 x double> %217
  br label %224

224:                                              ; preds = %208, %221
  %225 = phi <8 x double> [ %217, %208 ], [ %223, %221 ]
  br i1 %220, label %229, label %226

226:                                              ; preds = %224
  %227 = fcmp ogt <8 x double> %210, %217
  %228 = select <8 x i1> %227, <8 x double> %210, <8 x double> %217
  br label %229

229:                                              ; preds = %224, %226
  %230 = phi <8 x double> [ %217, %224 ], [ %228, %226 ]
  br i1 %220, label %234, label %231

231:                                              ; preds = %229
  %232 = fcmp ogt <8 x double> %218, zeroinitializer
  %233 = select <8 x i1> %232, <8 x i64> %212, <8 x i64> zeroinitializer
  br label %234

234:                                              ; preds = %229, %231
  %235 = phi <8 x i64> [ %233, %231 ], [ %212, %229 ]
  %236 = add nuw nsw i64 %209, 1
  %237 = icmp eq i64 %236, 5
  br i1 %237, label %203, label %208, !llvm.loop !221

238:                                              ; preds = %203
  %239 = fmul <8 x double> %225, %230
  %240 = fcmp ogt <8 x double> %239, zeroinitializer
  %241 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %225)
  %242 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %230)
  %243 = fcmp olt <8 x double> %241, %242
  %244 = select <8 x i1> %243, <8 x double> %241, <8 x double> %242
  %245 = fsub <8 x double> %230, %225
  %246 = fmul <8 x double> %245, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %247 = fcmp ogt <8 x double> %244, %246
  %248 = select <8 x i1> %247, <8 x i1> %240, <8 x i1> zeroinitializer
  %249 = select <8 x i1> %248, <8 x i64> %235, <8 x i64> zeroinitializer
  br label %250

250:                                              ; preds = %238, %203
  %251 = phi <8 x i64> [ %235, %203 ], [ %249, %238 ]
  %252 = load <8 x double>, ptr %125, align 64
  %253 = load <8 x double>, ptr %5, align 64
  %254 = fsub <8 x double> %252, %253
  %255 = fdiv <8 x double> %254, <double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C>
  br label %256

256:                                              ; preds = %250, %313
  %257 = phi i64 [ 1, %250 ], [ %263, %313 ]
  %258 = phi <8 x i64> [ zeroinitializer, %250 ], [ %314, %313 ]
  %259 = phi <8 x double> [ %255, %250 ], [ %274, %313 ]
  %260 = add nsw i64 %257, -1
  %261 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %257
  %262 = load double, ptr %261, align 8
  %263 = add nuw nsw i64 %257, 1
  %264 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = getelementptr inbounds <8 x double>, ptr %5, i64 %263
  %267 = load <8 x double>, ptr %266, align 64
  %268 = getelementptr inbounds <8 x double>, ptr %5, i64 %257
  %269 = load <8 x double>, ptr %268, align 64
  %270 = fsub <8 x double> %267, %269
  %271 = fsub double %265, %262
  %272 = insertelement <8 x double> poison, double %271, i64 0
  %273 = shufflevector <8 x double> %272, <8 x double> poison, <8 x i32> zeroinitializer
  %274 = fdiv <8 x double> %270, %273
  %275 = fcmp ogt <8 x double> %274, %259
  %276 = getelementptr inbounds <8 x double>, ptr %5, i64 %260
  %277 = load <8 x double>, ptr %276, align 64
  %278 = fcmp ogt <8 x double> %277, zeroinitializer
  %279 = and <8 x i1> %275, %278
  %280 = bitcast <8 x i1> %279 to i8
  %281 = icmp eq i8 %280, 0
  br i1 %281, label %313, label %282

282:                                              ; preds = %256
  %283 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %260
  %284 = load double, ptr %283, align 8
  %285 = fsub <8 x double> %274, %259
  %286 = fsub double %265, %284
  %287 = insertelement <8 x double> poison, double %286, i64 0
  %288 = shufflevector <8 x double> %287, <8 x double> poison, <8 x i32> zeroinitializer
  %289 = fdiv <8 x double> %285, %288
  %290 = fsub double %262, %284
  %291 = insertelement <8 x double> poison, double %290, i64 0
  %292 = shufflevector <8 x double> %291, <8 x double> poison, <8 x i32> zeroinitializer
  %293 = fmul <8 x double> %292, %289
  %294 = fadd <8 x double> %259, %293
  %295 = insertelement <8 x double> poison, double %262, i64 0
  %296 = shufflevector <8 x double> %295, <8 x double> poison, <8 x i32> zeroinitializer
  %297 = fmul <8 x double> %294, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %298 = fdiv <8 x double> %297, %289
  %299 = fsub <8 x double> %296, %298
  %300 = icmp ugt i64 %257, 1
  %301 = select i1 %300, double %284, double 0xBFCE3779B97F4A7C
  %302 = icmp eq i64 %257, 3
  %303 = select i1 %302, double 0x3FF4498517A7B356, double %265
  %304 = insertelement <8 x double> poison, double %301, i64 0
  %305 = shufflevector <8 x double> %304, <8 x double> poison, <8 x i32> zeroinitializer
  %306 = fcmp oge <8 x double> %299, %305
  %307 = insertelement <8 x double> poison, double %303, i64 0
  %308 = shufflevector <8 x double> %307, <8 x double> poison, <8 x i32> zeroinitializer
  %309 = fcmp ole <8 x double> %299, %308
  %310 = and <8 x i1> %309, %306
  %311 = and <8 x i1> %310, %279
  %312 = select <8 x i1> %311, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %258
  br label %313

313:                                              ; preds = %282, %256
  %314 = phi <8 x i64> [ %312, %282 ], [ %258, %256 ]
  %315 = icmp eq i64 %263, 4
  br i1 %315, label %316, label %256, !llvm.loop !222

316:                                              ; preds = %313
  %317 = xor <8 x i64> %314, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %318 = and <8 x i64> %251, %317
  %319 = add nuw nsw i64 %198, 1
  %320 = icmp eq i64 %319, %9
  br i1 %320, label %188, label %195, !llvm.loop !223

321:                                              ; preds = %330, %188
  %322 = load ptr, ptr %16, align 8
  %323 = load <8 x i64>, ptr %3, align 8
  %324 = load <8 x i64>, ptr %322, align 8
  %325 = icmp slt <8 x i64> %189, zeroinitializer
  %326 = select <8 x i1> %325, <8 x i64> %323, <8 x i64> %324
  store <8 x i64> %326, ptr %322, align 8
  %327 = icmp ne <8 x i64> %189, zeroinitializer
  %328 = bitcast <8 x i1> %327 to i8
  %329 = zext i8 %328 to i64
  ret i64 %329

330:                                              ; preds = %191, %330
  %331 = phi i64 [ 0, %191 ], [ %341, %330 ]
  %332 = load ptr, ptr %192, align 8
  %333 = shl i64 %331, 6
  %334 = getelementptr i8, ptr %332, i64 %193
  %335 = getelementptr i8, ptr %334, i64 %333
  %336 = load <8 x i64>, ptr %335, align 8
  %337 = shl nsw i64 %331, 6
  %338 = getelementptr inbounds i8, ptr %332, i64 %337
  %339 = load <8 x i64>, ptr %338, align 8
  %340 = select <8 x i1> %194, <8 x i64> %336, <8 x i64> %339
  store <8 x i64> %340, ptr %338, align 8
  %341 = add nuw nsw i64 %331, 1
  %342 = icmp eq i64 %341, %9
  br i1 %342, label %321, label %330, !llvm.loop !224
}

define internal fastcc i64 @look_alone(ptr noundef readonly %0, i64 noundef %1, double noundef %2, ptr noundef writeonly %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1224
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i64, ptr %6, i64 %1
  %8 = load i64, ptr %7, align 8
  %9 = inttoptr i64 %8 to ptr
  %10 = getelementptr inbounds i8, ptr %0, i64 432
  %11 = getelementptr inbounds i8, ptr %9, i64 360
  %12 = getelementptr inbounds i8, ptr %0, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %24

17:                                               ; preds = %4
  %18 = getelementptr inbounds i8, ptr %0, i64 456
  %19 = getelementptr inbounds i8, ptr %9, i64 384
  %20 = getelementptr inbounds i8, ptr %0, i64 624
  %21 = getelementptr inbounds i8, ptr %0, i64 440
  %22 = getelementptr inbounds i8, ptr %9, i64 552
  %23 = getelementptr inbounds i8, ptr %9, i64 368
  br label %129

24:                                               ; preds = %147, %4
  %25 = getelementptr inbounds i8, ptr %0, i64 1272
  %26 = load ptr, ptr %5, align 8
  %27 = getelementptr inbounds i64, ptr %26, i64 %1
  %28 = load i64, ptr %27, align 8
  %29 = inttoptr i64 %28 to ptr
  %30 = load ptr, ptr %25, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 8
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %29, i64 984
  %34 = load ptr, ptr %33, align 8
  %35 = shl nsw i64 %32, 4
  %36 = getelementptr inbounds i8, ptr %34, i64 %35
  %37 = mul i64 %32, 88
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %0, i64 1464
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %1
  %42 = load double, ptr %41, align 8
  store double %42, ptr %38, align 8
  %43 = icmp sgt i64 %32, 0
  br i1 %43, label %44, label %64

44:                                               ; preds = %24
  %45 = getelementptr inbounds i8, ptr %0, i64 1440
  %46 = getelementptr inbounds i8, ptr %29, i64 936
  %47 = getelementptr inbounds i8, ptr %0, i64 1392
  br label %48

48:                                               ; preds = %44, %48
  %49 = phi i64 [ 0, %44 ], [ %62, %48 ]
  %50 = load ptr, ptr %45, align 8
  %51 = shl nsw i64 %49, 3
  %52 = add nsw i64 %51, %1
  %53 = getelementptr inbounds double, ptr %50, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = fptosi double %54 to i64
  %56 = load ptr, ptr %46, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %49
  store i64 %55, ptr %57, align 8
  %58 = load ptr, ptr %47, align 8
  %59 = getelementptr inbounds double, ptr %58, i64 %52
  %60 = load double, ptr %59, align 8
  %61 = getelementptr inbounds double, ptr %36, i64 %49
  store double %60, ptr %61, align 8
  %62 = add nuw nsw i64 %49, 1
  %63 = icmp eq i64 %62, %32
  br i1 %63, label %64, label %48, !llvm.loop !104

64:                                               ; preds = %48, %24
  %65 = getelementptr inbounds i8, ptr %9, i64 624
  %66 = load ptr, ptr %65, align 8
  store double %2, ptr %66, align 8
  %67 = getelementptr inbounds i8, ptr %0, i64 696
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %68, i64 %1
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %0, i64 408
  %72 = load ptr, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %1
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %9, i64 336
  %76 = load ptr, ptr %75, align 8
  store double %74, ptr %76, align 8
  %77 = getelementptr inbounds i8, ptr %9, i64 768
  %78 = load ptr, ptr %77, align 8
  %79 = getelementptr inbounds i8, ptr %78, i64 16
  %80 = load i64, ptr %79, align 8
  %81 = inttoptr i64 %80 to ptr
  %82 = getelementptr inbounds i8, ptr %0, i64 504
  %83 = load ptr, ptr %82, align 8
  %84 = getelementptr inbounds double, ptr %83, i64 %1
  %85 = load double, ptr %84, align 8
  %86 = tail call i64 %81(ptr noundef %9, double noundef %70, double noundef %85) #12
  %87 = load ptr, ptr %75, align 8
  store double 0x7FF0000000000000, ptr %87, align 8
  %88 = load ptr, ptr %65, align 8
  %89 = getelementptr inbounds i8, ptr %88, i64 48
  %90 = load double, ptr %89, align 8
  store double %90, ptr %3, align 8
  %91 = load ptr, ptr %5, align 8
  %92 = getelementptr inbounds i64, ptr %91, i64 %1
  %93 = load i64, ptr %92, align 8
  %94 = inttoptr i64 %93 to ptr
  %95 = load ptr, ptr %25, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = getelementptr inbounds i8, ptr %94, i64 984
  %99 = load ptr, ptr %98, align 8
  %100 = shl nsw i64 %97, 4
  %101 = getelementptr inbounds i8, ptr %99, i64 %100
  %102 = mul i64 %97, 88
  %103 = getelementptr inbounds i8, ptr %99, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = load ptr, ptr %39, align 8
  %106 = getelementptr inbounds double, ptr %105, i64 %1
  store double %104, ptr %106, align 8
  %107 = icmp sgt i64 %97, 0
  br i1 %107, label %108, label %128

108:                                              ; preds = %64
  %109 = getelementptr inbounds i8, ptr %94, i64 936
  %110 = getelementptr inbounds i8, ptr %0, i64 1440
  %111 = getelementptr inbounds i8, ptr %0, i64 1392
  br label %112

112:                                              ; preds = %108, %112
  %113 = phi i64 [ 0, %108 ], [ %126, %112 ]
  %114 = load ptr, ptr %109, align 8
  %115 = getelementptr inbounds i64, ptr %114, i64 %113
  %116 = load i64, ptr %115, align 8
  %117 = sitofp i64 %116 to double
  %118 = load ptr, ptr %110, align 8
  %119 = shl nsw i64 %113, 3
  %120 = add nsw i64 %119, %1
  %121 = getelementptr inbounds double, ptr %118, i64 %120
  store double %117, ptr %121, align 8
  %122 = getelementptr inbounds double, ptr %101, i64 %113
  %123 = load double, ptr %122, align 8
  %124 = load ptr, ptr %111, align 8
  %125 = getelementptr inbounds double, ptr %124, i64 %120
  store double %123, ptr %125, align 8
  %126 = add nuw nsw i64 %113, 1
  %127 = icmp eq i64 %126, %97
  br i1 %127, label %128, label %112, !llvm.loop !104

128:                                              ; preds = %112, %64
  ret i64 %86

129:                                              ; preds = %17, %147
  %130 = phi i64 [ 0, %17 ], [ %148, %147 ]
  %131 = load ptr, ptr %10, align 8
  %132 = shl nsw i64 %130, 3
  %133 = add nsw i64 %132, %1
  %134 = getelementptr inbounds double, ptr %131, i64 %133
  %135 = load double, ptr %134, align 8
  %136 = load ptr, ptr %11, align 8
  %137 = getelementptr inbounds double, ptr %136, i64 %130
  store double %135, ptr %137, align 8
  %138 = load ptr, ptr %18, align 8
  %139 = getelementptr inbounds double, ptr %138, i64 %133
  %140 = load double, ptr %139, align 8
  %141 = load ptr, ptr %19, align 8
  %142 = getelementptr inbounds double, ptr %141, i64 %130
  store double %140, ptr %142, align 8
  %143 = load ptr, ptr %0, align 8
  %144 = getelementptr inbounds i8, ptr %143, i64 24
  %145 = load i64, ptr %144, align 8
  %146 = icmp sgt i64 %145, 0
  br i1 %146, label %150, label %147

147:                                              ; preds = %150, %129
  %148 = add nuw nsw i64 %130, 1
  %149 = icmp eq i64 %148, %15
  br i1 %149, label %24, label %129, !llvm.loop !225

150:                                              ; preds = %129, %150
  %151 = phi i64 [ %164, %150 ], [ 0, %129 ]
  %152 = load ptr, ptr %20, align 8
  %153 = load i64, ptr %21, align 8
  %154 = mul nsw i64 %153, %151
  %155 = getelementptr double, ptr %152, i64 %154
  %156 = getelementptr double, ptr %155, i64 %132
  %157 = getelementptr double, ptr %156, i64 %1
  %158 = load double, ptr %157, align 8
  %159 = load ptr, ptr %22, align 8
  %160 = load i64, ptr %23, align 8
  %161 = mul nsw i64 %160, %151
  %162 = getelementptr double, ptr %159, i64 %161
  %163 = getelementptr double, ptr %162, i64 %130
  store double %158, ptr %163, align 8
  %164 = add nuw nsw i64 %151, 1
  %165 = load ptr, ptr %0, align 8
  %166 = getelementptr inbounds i8, ptr %165, i64 24
  %167 = load i64, ptr %166, align 8
  %168 = icmp slt i64 %164, %167
  br i1 %168, label %150, label %147, !llvm.loop !226
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
  br i1 %31, label %20, label %19, !llvm.loop !227

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
  br i1 %43, label %32, label %24, !llvm.loop !228
}

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { noinline nounwind }
attributes #7 = { noinline nounwind }
attributes #8 = { nounwind willreturn }
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
!8 = distinct !{!8, !5}
!9 = !{!10, !12}
!10 = distinct !{!10, !11, !"implicit_in: argument 0"}
!11 = distinct !{!11, !"implicit_in"}
!12 = distinct !{!12, !13, !"attempt: argument 0"}
!13 = distinct !{!13, !"attempt"}
!14 = !{!15, !12}
!15 = distinct !{!15, !16, !"implicit_of: argument 0"}
!16 = distinct !{!16, !"implicit_of"}
!17 = !{}
!18 = distinct !{!18, !4, !5}
!19 = !{!20}
!20 = distinct !{!20, !21, !"try_step: argument 0"}
!21 = distinct !{!21, !"try_step"}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = !{!30, !20}
!30 = distinct !{!30, !31, !"solve_stages: argument 0"}
!31 = distinct !{!31, !"solve_stages"}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = !{!37, !30, !20}
!37 = distinct !{!37, !38, !"pair_item: argument 0"}
!38 = distinct !{!38, !"pair_item"}
!39 = distinct !{!39, !4, !5}
!40 = !{!41, !30, !20}
!41 = distinct !{!41, !42, !"pair_item: argument 0"}
!42 = distinct !{!42, !"pair_item"}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = !{!49, !30, !20}
!49 = distinct !{!49, !50, !"pair_item: argument 0"}
!50 = distinct !{!50, !"pair_item"}
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
!62 = !{!12}
!63 = distinct !{!63, !4, !5}
!64 = distinct !{!64, !4, !5}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5, !70}
!70 = !{!"llvm.loop.vectorize.width", i32 1}
!71 = distinct !{!71, !4, !5, !70}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5, !70}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
!84 = distinct !{!84, !4, !5}
!85 = distinct !{!85, !4, !5, !70}
!86 = distinct !{!86, !4, !5, !70}
!87 = distinct !{!87, !4, !5}
!88 = distinct !{!88, !4, !5}
!89 = distinct !{!89, !4, !5}
!90 = distinct !{!90, !4, !5}
!91 = distinct !{!91, !4, !5}
!92 = distinct !{!92, !4, !5}
!93 = distinct !{!93, !4, !5}
!94 = distinct !{!94, !4, !5}
!95 = distinct !{!95, !4, !5, !70}
!96 = distinct !{!96, !5}
!97 = distinct !{!97, !4, !5}
!98 = distinct !{!98, !4, !5}
!99 = distinct !{!99, !4, !5}
!100 = distinct !{!100, !4, !5, !70}
!101 = distinct !{!101, !4, !5}
!102 = distinct !{!102, !4, !5}
!103 = distinct !{!103, !4, !5}
!104 = distinct !{!104, !4, !5, !70}
!105 = distinct !{!105, !4, !5}
!106 = distinct !{!106, !4, !5}
!107 = distinct !{!107, !4, !5}
!108 = distinct !{!108, !4, !5}
!109 = distinct !{!109, !4, !5}
!110 = distinct !{!110, !4, !5}
!111 = distinct !{!111, !4, !5}
!112 = distinct !{!112, !4, !5}
!113 = distinct !{!113, !4, !5}
!114 = distinct !{!114, !4, !5, !70}
!115 = distinct !{!115, !4, !5}
!116 = distinct !{!116, !4, !5}
!117 = distinct !{!117, !4, !5}
!118 = distinct !{!118, !4, !5}
!119 = distinct !{!119, !4, !5}
!120 = distinct !{!120, !4, !5}
!121 = distinct !{!121, !4, !5}
!122 = !{!123}
!123 = distinct !{!123, !124, !"pair_item: argument 0"}
!124 = distinct !{!124, !"pair_item"}
!125 = !{!126}
!126 = distinct !{!126, !127, !"pair_item: argument 0"}
!127 = distinct !{!127, !"pair_item"}
!128 = distinct !{!128, !4, !5}
!129 = !{!130}
!130 = distinct !{!130, !131, !"pair_item: argument 0"}
!131 = distinct !{!131, !"pair_item"}
!132 = distinct !{!132, !4, !5}
!133 = !{!134}
!134 = distinct !{!134, !135, !"pair_item: argument 0"}
!135 = distinct !{!135, !"pair_item"}
!136 = !{!137}
!137 = distinct !{!137, !138, !"pair_item: argument 0"}
!138 = distinct !{!138, !"pair_item"}
!139 = distinct !{!139, !4, !5}
!140 = !{!141}
!141 = distinct !{!141, !142, !"pair_item: argument 0"}
!142 = distinct !{!142, !"pair_item"}
!143 = !{!144}
!144 = distinct !{!144, !145, !"pair_item: argument 0"}
!145 = distinct !{!145, !"pair_item"}
!146 = !{!147}
!147 = distinct !{!147, !148, !"pair_item: argument 0"}
!148 = distinct !{!148, !"pair_item"}
!149 = distinct !{!149, !4, !5}
!150 = distinct !{!150, !4, !5}
!151 = distinct !{!151, !4, !5}
!152 = distinct !{!152, !4, !5}
!153 = distinct !{!153, !4, !5}
!154 = distinct !{!154, !4, !5}
!155 = distinct !{!155, !4, !5}
!156 = distinct !{!156, !4, !5}
!157 = distinct !{!157, !4, !5, !70}
!158 = !{!159}
!159 = distinct !{!159, !160, !"pair_item: argument 0"}
!160 = distinct !{!160, !"pair_item"}
!161 = distinct !{!161, !4, !5}
!162 = !{!163}
!163 = distinct !{!163, !164, !"pair_item: argument 0"}
!164 = distinct !{!164, !"pair_item"}
!165 = !{!166}
!166 = distinct !{!166, !167, !"pair_item: argument 0"}
!167 = distinct !{!167, !"pair_item"}
!168 = distinct !{!168, !4, !5}
!169 = !{!170}
!170 = distinct !{!170, !171, !"pair_item: argument 0"}
!171 = distinct !{!171, !"pair_item"}
!172 = !{!173}
!173 = distinct !{!173, !174, !"pair_item: argument 0"}
!174 = distinct !{!174, !"pair_item"}
!175 = distinct !{!175, !4, !5}
!176 = !{!177}
!177 = distinct !{!177, !178, !"pair_item: argument 0"}
!178 = distinct !{!178, !"pair_item"}
!179 = !{!180}
!180 = distinct !{!180, !181, !"pair_item: argument 0"}
!181 = distinct !{!181, !"pair_item"}
!182 = distinct !{!182, !4, !5}
!183 = distinct !{!183, !4, !5}
!184 = distinct !{!184, !4, !5}
!185 = distinct !{!185, !4, !5}
!186 = distinct !{!186, !4, !5}
!187 = distinct !{!187, !4, !5}
!188 = distinct !{!188, !4, !5}
!189 = distinct !{!189, !4, !5}
!190 = !{!191}
!191 = distinct !{!191, !192, !"pair_item: argument 0"}
!192 = distinct !{!192, !"pair_item"}
!193 = !{!194}
!194 = distinct !{!194, !195, !"pair_item: argument 0"}
!195 = distinct !{!195, !"pair_item"}
!196 = !{!197}
!197 = distinct !{!197, !198, !"pair_item: argument 0"}
!198 = distinct !{!198, !"pair_item"}
!199 = distinct !{!199, !4, !5}
!200 = distinct !{!200, !4, !5}
!201 = distinct !{!201, !4, !5}
!202 = !{!203}
!203 = distinct !{!203, !204, !"pair_item: argument 0"}
!204 = distinct !{!204, !"pair_item"}
!205 = !{!206}
!206 = distinct !{!206, !207, !"pair_item: argument 0"}
!207 = distinct !{!207, !"pair_item"}
!208 = !{!209}
!209 = distinct !{!209, !210, !"pair_item: argument 0"}
!210 = distinct !{!210, !"pair_item"}
!211 = distinct !{!211, !4, !5}
!212 = !{!213}
!213 = distinct !{!213, !214, !"pair_item: argument 0"}
!214 = distinct !{!214, !"pair_item"}
!215 = !{!216}
!216 = distinct !{!216, !217, !"pair_item: argument 0"}
!217 = distinct !{!217, !"pair_item"}
!218 = distinct !{!218, !4, !5}
!219 = distinct !{!219, !4, !5}
!220 = distinct !{!220, !4, !5}
!221 = distinct !{!221, !4, !5}
!222 = distinct !{!222, !4, !5}
!223 = distinct !{!223, !4, !5}
!224 = distinct !{!224, !4, !5}
!225 = distinct !{!225, !4, !5, !70}
!226 = distinct !{!226, !4, !5}
!227 = distinct !{!227, !4, !5}
!228 = distinct !{!228, !4, !5}
