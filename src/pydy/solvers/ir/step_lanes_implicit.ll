; sources eca84e0c24259c19e7894775b39b36680e230f5ec9cd3b6b104854aba1f15ff9
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@NODES = internal unnamed_addr constant [3 x double] [double 0x3FC3D8B64657CAEA, double 0x3FE4A36C0803A6DF, double 1.000000e+00], align 16
@TO_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x4010B70201A79C46, double 0x3FD4F8C15DA84E86, double 0x3FE0BF7FF59D56EF], [3 x double] [double 0xC010B70201A79C46, double 0xBFD4F8C15DA84E86, double 0x3FDE810014C55221], [3 x double] [double 0x3FE017885A24A7F2, double 0xC004934E6FCAA598, double 0x3FE312C0CF7BDFD1]], align 16
@FROM_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x3FB82D23845D677B, double 0xBFC214A74C403BF7, double 0x3F9EBFF91A6D688E], [3 x double] [double 0x3FD0037DE70AA1ED, double 0x3FCA20E91E20B551, double 0xBFD8821FA2A36DED], [3 x double] [double 1.000000e+00, double 1.000000e+00, double 0.000000e+00]], align 16
@POLYNOMIAL = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x402418FD8BAFFE05, double 0xC039A12CE7B30915, double 0x402F295C43B61425], [3 x double] [double 0xBFF61D41B2D54580, double 0x402497AF24BB677E, double 0xC021D406EE60BECF], [3 x double] [double 0x3FD5555555555555, double 0xC005555555555555, double 0x400AAAAAAAAAAAAB]], align 16
@scan_points = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes_implicit(ptr noundef %0) #0 {
  %2 = alloca [8 x double], align 16
  %3 = alloca [3 x double], align 16
  %4 = alloca [3 x double], align 16
  %5 = alloca [64 x double], align 16
  %6 = alloca [64 x double], align 16
  %7 = alloca [64 x double], align 16
  %8 = alloca [64 x double], align 16
  %9 = alloca [8 x double], align 16
  %10 = alloca [8 x double], align 16
  %11 = alloca [3 x <8 x double>], align 64
  %12 = alloca %struct.Stepper, align 8
  %13 = alloca [8 x double], align 16
  %14 = alloca [8 x double], align 16
  %15 = alloca [8 x double], align 16
  %16 = alloca i64, align 8
  %17 = alloca [8 x i64], align 16
  %18 = alloca i64, align 8
  store ptr %0, ptr %12, align 8
  %19 = getelementptr inbounds i8, ptr %12, i64 8
  %20 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %20, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %12, i64 16
  %22 = getelementptr inbounds i8, ptr %0, i64 432
  store ptr %22, ptr %21, align 8
  %23 = getelementptr inbounds i8, ptr %0, i64 984
  %24 = load ptr, ptr %20, align 8
  %25 = getelementptr inbounds i8, ptr %24, i64 8
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 1032
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 1040
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr double, ptr %28, i64 %30
  %32 = getelementptr i8, ptr %31, i64 -16
  %33 = load double, ptr %32, align 8
  %34 = getelementptr inbounds i8, ptr %0, i64 1008
  %35 = load ptr, ptr %34, align 8
  %36 = load double, ptr %35, align 8
  %37 = load ptr, ptr %23, align 8
  %38 = getelementptr inbounds i8, ptr %37, i64 16
  %39 = load i64, ptr %38, align 8
  %40 = getelementptr inbounds i8, ptr %0, i64 1680
  %41 = load ptr, ptr %40, align 8
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %0, i64 1272
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds i8, ptr %44, i64 8
  %46 = load i64, ptr %45, align 8
  store i64 0, ptr %16, align 8
  %47 = getelementptr inbounds i8, ptr %0, i64 936
  %48 = load ptr, ptr %47, align 8
  br label %153

49:                                               ; preds = %153
  %50 = getelementptr inbounds i8, ptr %0, i64 696
  %51 = sitofp i64 %39 to double
  %52 = icmp eq i64 %42, 1
  %53 = icmp sgt i64 %46, 0
  store i64 %161, ptr %16, align 8
  %54 = getelementptr inbounds i8, ptr %0, i64 936
  %55 = getelementptr inbounds i8, ptr %0, i64 1592
  %56 = getelementptr inbounds i8, ptr %0, i64 1224
  %57 = insertelement <8 x double> poison, double %33, i64 0
  %58 = shufflevector <8 x double> %57, <8 x double> poison, <8 x i32> zeroinitializer
  %59 = getelementptr inbounds i8, ptr %0, i64 720
  %60 = insertelement <8 x double> poison, double %36, i64 0
  %61 = shufflevector <8 x double> %60, <8 x double> poison, <8 x i32> zeroinitializer
  %62 = getelementptr inbounds i8, ptr %0, i64 840
  %63 = getelementptr inbounds i8, ptr %0, i64 864
  %64 = insertelement <8 x double> poison, double %51, i64 0
  %65 = shufflevector <8 x double> %64, <8 x double> poison, <8 x i32> zeroinitializer
  %66 = getelementptr inbounds i8, ptr %0, i64 1752
  %67 = getelementptr inbounds i8, ptr %0, i64 648
  %68 = getelementptr inbounds i8, ptr %0, i64 1824
  %69 = getelementptr inbounds i8, ptr %0, i64 1848
  %70 = getelementptr inbounds i8, ptr %0, i64 168
  %71 = getelementptr inbounds i8, ptr %0, i64 296
  %72 = getelementptr inbounds i8, ptr %0, i64 192
  %73 = getelementptr inbounds i8, ptr %0, i64 1800
  %74 = getelementptr inbounds i8, ptr %0, i64 1832
  %75 = getelementptr inbounds i8, ptr %0, i64 1776
  %76 = getelementptr inbounds i8, ptr %0, i64 1928
  %77 = getelementptr inbounds i8, ptr %0, i64 1872
  %78 = getelementptr inbounds i8, ptr %0, i64 1896
  %79 = getelementptr inbounds i8, ptr %0, i64 1824
  %80 = getelementptr inbounds i8, ptr %0, i64 1920
  %81 = getelementptr inbounds i8, ptr %0, i64 1944
  %82 = getelementptr inbounds i8, ptr %0, i64 2040
  %83 = getelementptr inbounds i8, ptr %0, i64 1968
  %84 = getelementptr inbounds i8, ptr %0, i64 1992
  %85 = getelementptr inbounds i8, ptr %0, i64 480
  %86 = getelementptr inbounds i8, ptr %0, i64 2016
  %87 = getelementptr inbounds i8, ptr %0, i64 480
  %88 = getelementptr inbounds i8, ptr %0, i64 168
  %89 = getelementptr inbounds i8, ptr %0, i64 296
  %90 = getelementptr inbounds i8, ptr %0, i64 192
  %91 = getelementptr inbounds i8, ptr %0, i64 240
  %92 = getelementptr inbounds i8, ptr %0, i64 2016
  %93 = getelementptr inbounds i8, ptr %0, i64 2064
  %94 = getelementptr inbounds i8, ptr %0, i64 2088
  %95 = getelementptr inbounds i8, ptr %0, i64 672
  %96 = getelementptr inbounds i8, ptr %0, i64 1920
  %97 = getelementptr inbounds i8, ptr %0, i64 1928
  %98 = getelementptr inbounds i8, ptr %0, i64 2064
  %99 = getelementptr inbounds i8, ptr %0, i64 2088
  %100 = getelementptr inbounds i8, ptr %0, i64 1872
  %101 = getelementptr inbounds i8, ptr %0, i64 1896
  %102 = getelementptr inbounds i8, ptr %0, i64 1944
  %103 = getelementptr inbounds i8, ptr %0, i64 672
  %104 = getelementptr inbounds i8, ptr %11, i64 64
  %105 = getelementptr inbounds i8, ptr %11, i64 128
  %106 = getelementptr inbounds i8, ptr %0, i64 1832
  %107 = getelementptr inbounds i8, ptr %0, i64 1824
  %108 = getelementptr inbounds i8, ptr %0, i64 456
  %109 = getelementptr inbounds i8, ptr %0, i64 2112
  %110 = getelementptr inbounds i8, ptr %0, i64 2064
  %111 = getelementptr inbounds i8, ptr %0, i64 600
  %112 = getelementptr inbounds i8, ptr %0, i64 1920
  %113 = getelementptr inbounds i8, ptr %0, i64 1928
  %114 = getelementptr inbounds i8, ptr %0, i64 1872
  %115 = getelementptr inbounds i8, ptr %0, i64 456
  %116 = getelementptr inbounds i8, ptr %0, i64 672
  %117 = getelementptr inbounds i8, ptr %0, i64 480
  %118 = getelementptr inbounds i8, ptr %0, i64 480
  %119 = getelementptr inbounds i8, ptr %0, i64 2016
  %120 = getelementptr inbounds i8, ptr %0, i64 168
  %121 = getelementptr inbounds i8, ptr %0, i64 296
  %122 = getelementptr inbounds i8, ptr %0, i64 192
  %123 = getelementptr inbounds i8, ptr %0, i64 240
  %124 = getelementptr inbounds i8, ptr %0, i64 672
  %125 = getelementptr inbounds i8, ptr %0, i64 888
  %126 = getelementptr inbounds i8, ptr %0, i64 456
  %127 = getelementptr inbounds i8, ptr %0, i64 440
  %128 = getelementptr inbounds i8, ptr %0, i64 1968
  %129 = getelementptr inbounds i8, ptr %0, i64 624
  %130 = getelementptr inbounds i8, ptr %0, i64 2040
  %131 = getelementptr inbounds i8, ptr %0, i64 1776
  %132 = getelementptr inbounds i8, ptr %3, i64 8
  %133 = getelementptr inbounds i8, ptr %3, i64 16
  %134 = getelementptr inbounds i8, ptr %4, i64 8
  %135 = getelementptr inbounds i8, ptr %4, i64 16
  %136 = getelementptr inbounds i8, ptr %0, i64 456
  %137 = getelementptr inbounds i8, ptr %0, i64 816
  %138 = getelementptr inbounds i8, ptr %0, i64 456
  %139 = getelementptr inbounds i8, ptr %0, i64 296
  %140 = getelementptr inbounds i8, ptr %0, i64 296
  %141 = getelementptr inbounds i8, ptr %0, i64 296
  %142 = getelementptr inbounds i8, ptr %0, i64 912
  %143 = icmp sgt i64 %26, 0
  %144 = getelementptr inbounds i8, ptr %0, i64 456
  br label %145

145:                                              ; preds = %2126, %49
  %146 = phi i64 [ %1712, %2126 ], [ undef, %49 ]
  %147 = phi i64 [ %1713, %2126 ], [ undef, %49 ]
  %148 = phi <8 x double> [ %1714, %2126 ], [ undef, %49 ]
  %149 = phi <8 x double> [ %1715, %2126 ], [ undef, %49 ]
  %150 = phi <8 x double> [ %1716, %2126 ], [ undef, %49 ]
  %151 = phi i32 [ %2127, %2126 ], [ 1, %49 ]
  %152 = phi i64 [ %2102, %2126 ], [ 0, %49 ]
  br label %164

153:                                              ; preds = %1, %153
  %154 = phi i64 [ 0, %1 ], [ %162, %153 ]
  %155 = phi i64 [ 0, %1 ], [ %161, %153 ]
  %156 = getelementptr inbounds i64, ptr %48, i64 %154
  %157 = load i64, ptr %156, align 8
  %158 = icmp sgt i64 %157, -1
  %159 = zext i1 %158 to i64
  %160 = shl nuw nsw i64 %159, %154
  %161 = or i64 %160, %155
  %162 = add nuw nsw i64 %154, 1
  %163 = icmp eq i64 %162, 8
  br i1 %163, label %49, label %153, !llvm.loop !3

164:                                              ; preds = %145, %268
  %165 = phi i32 [ 1, %268 ], [ %151, %145 ]
  %166 = phi i64 [ %204, %268 ], [ %152, %145 ]
  br label %167

167:                                              ; preds = %198, %164
  %168 = phi i32 [ %165, %164 ], [ %200, %198 ]
  %169 = phi i64 [ %166, %164 ], [ %201, %198 ]
  %170 = icmp ne i32 %168, 0
  %171 = icmp ne i64 %169, 0
  %172 = select i1 %170, i1 true, i1 %171
  br i1 %172, label %173, label %202

173:                                              ; preds = %167
  br i1 %170, label %174, label %176

174:                                              ; preds = %173
  %175 = call fastcc i64 @fill(ptr noundef %0, ptr noundef nonnull %16) #12
  br label %176

176:                                              ; preds = %173, %174
  %177 = phi i64 [ %175, %174 ], [ 0, %173 ]
  %178 = load i64, ptr %16, align 8
  %179 = icmp eq i64 %178, 0
  br i1 %179, label %198, label %180

180:                                              ; preds = %176
  %181 = or i64 %177, %169
  %182 = icmp eq i64 %181, 0
  br i1 %182, label %198, label %183

183:                                              ; preds = %180
  call fastcc void @start(ptr noundef %0, ptr noundef nonnull %12, i64 noundef %177, i64 noundef %169) #12
  br label %184

184:                                              ; preds = %183, %193
  %185 = phi i32 [ 0, %183 ], [ %195, %193 ]
  %186 = phi i64 [ 0, %183 ], [ %196, %193 ]
  %187 = icmp eq i32 %185, 0
  br i1 %187, label %188, label %193

188:                                              ; preds = %184
  %189 = load ptr, ptr %54, align 8
  %190 = getelementptr inbounds i64, ptr %189, i64 %186
  %191 = load i64, ptr %190, align 8
  %192 = icmp eq i64 %191, -1
  br label %193

193:                                              ; preds = %188, %184
  %194 = phi i1 [ true, %184 ], [ %192, %188 ]
  %195 = zext i1 %194 to i32
  %196 = add nuw nsw i64 %186, 1
  %197 = icmp eq i64 %196, 8
  br i1 %197, label %198, label %184, !llvm.loop !6

198:                                              ; preds = %193, %180, %176
  %199 = phi i32 [ 1, %176 ], [ 8, %180 ], [ 0, %193 ]
  %200 = phi i32 [ %168, %176 ], [ 0, %180 ], [ %195, %193 ]
  %201 = phi i64 [ %169, %176 ], [ %169, %180 ], [ 0, %193 ]
  switch i32 %199, label %2128 [
    i32 0, label %167
    i32 8, label %202
  ], !llvm.loop !7

202:                                              ; preds = %198, %167
  %203 = phi i32 [ %200, %198 ], [ 0, %167 ]
  %204 = phi i64 [ %201, %198 ], [ 0, %167 ]
  %205 = load ptr, ptr %23, align 8
  %206 = getelementptr inbounds i8, ptr %205, i64 8
  %207 = load i64, ptr %206, align 8
  %208 = icmp slt i64 %207, 1
  br i1 %208, label %2128, label %209

209:                                              ; preds = %202
  br i1 %53, label %210, label %230

210:                                              ; preds = %209
  %211 = load i64, ptr %55, align 8
  %212 = icmp sgt i64 %211, 0
  br i1 %212, label %213, label %227

213:                                              ; preds = %210
  %214 = load ptr, ptr %43, align 8
  %215 = getelementptr inbounds i8, ptr %214, i64 72
  %216 = load i64, ptr %215, align 8
  %217 = load ptr, ptr %56, align 8
  %218 = load i64, ptr %217, align 8
  %219 = inttoptr i64 %218 to ptr
  %220 = getelementptr inbounds i8, ptr %219, i64 1064
  %221 = load i64, ptr %220, align 8
  %222 = shl i64 %221, 4
  %223 = add i64 %216, 16
  %224 = add i64 %223, %222
  %225 = icmp sgt i64 %224, %211
  %226 = zext i1 %225 to i32
  br label %227

227:                                              ; preds = %210, %213
  %228 = phi i32 [ 0, %210 ], [ %226, %213 ]
  %229 = icmp eq i32 %228, 0
  br i1 %229, label %230, label %2128

230:                                              ; preds = %227, %209
  %231 = add nsw i64 %207, -1
  store i64 %231, ptr %206, align 8
  %232 = load i64, ptr %16, align 8
  %233 = trunc i64 %232 to i8
  %234 = bitcast i8 %233 to <8 x i1>
  %235 = load ptr, ptr %50, align 8
  %236 = load <8 x double>, ptr %235, align 8
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %15) #12
  %237 = load <8 x double>, ptr %15, align 16
  %238 = fcmp olt <8 x double> %58, %237
  %239 = select <8 x i1> %238, <8 x double> %58, <8 x double> %237
  %240 = load ptr, ptr %59, align 8
  %241 = load <8 x double>, ptr %240, align 8
  %242 = fcmp olt <8 x double> %241, %61
  %243 = select <8 x i1> %242, <8 x double> %241, <8 x double> %61
  %244 = fadd <8 x double> %236, %243
  %245 = fmul <8 x double> %243, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %246 = fsub <8 x double> %239, %245
  %247 = fcmp ogt <8 x double> %244, %246
  %248 = select <8 x i1> %247, <8 x double> %239, <8 x double> %244
  %249 = fsub <8 x double> %248, %236
  %250 = bitcast <8 x double> %249 to <8 x i64>
  %251 = select <8 x i1> %234, <8 x i64> %250, <8 x i64> zeroinitializer
  %252 = bitcast <8 x i64> %251 to <8 x double>
  %253 = load ptr, ptr %62, align 8
  %254 = load <8 x double>, ptr %253, align 8
  %255 = load ptr, ptr %63, align 8
  %256 = load <8 x double>, ptr %255, align 8
  %257 = fadd <8 x double> %254, %256
  %258 = fcmp oge <8 x double> %257, %65
  %259 = fmul <8 x double> %252, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %260 = fadd <8 x double> %236, %259
  %261 = fcmp ule <8 x double> %260, %236
  %262 = fcmp une <8 x double> %248, %239
  %263 = and <8 x i1> %261, %262
  %264 = or <8 x i1> %263, %258
  %265 = and <8 x i1> %264, %234
  %266 = bitcast <8 x i1> %265 to i8
  %267 = icmp eq i8 %266, 0
  br i1 %267, label %275, label %268

268:                                              ; preds = %230
  %269 = zext i8 %266 to i64
  %270 = bitcast <8 x i1> %258 to i8
  %271 = zext i8 %270 to i64
  %272 = and i64 %269, %271
  call fastcc void @retire(ptr noundef %0, i64 noundef %272, i64 noundef 1) #12
  %273 = xor i64 %271, -1
  %274 = and i64 %269, %273
  call fastcc void @retire(ptr noundef %0, i64 noundef %274, i64 noundef -1) #12
  br label %164, !llvm.loop !8

275:                                              ; preds = %230
  %276 = load ptr, ptr %27, align 8, !noalias !9
  %277 = load i64, ptr %29, align 8, !noalias !9
  %278 = getelementptr double, ptr %276, i64 %277
  %279 = getelementptr i8, ptr %278, i64 -16
  %280 = load double, ptr %279, align 8, !noalias !9
  %281 = load double, ptr %276, align 8, !noalias !9
  %282 = fsub double %280, %281
  %283 = fmul double %282, 0x3D70000000000000
  %284 = load ptr, ptr %67, align 8, !noalias !14
  %285 = load double, ptr %284, align 8, !noalias !14
  %286 = load ptr, ptr %20, align 8, !noalias !17
  %287 = getelementptr inbounds i8, ptr %286, i64 8
  %288 = load i64, ptr %287, align 8, !noalias !17
  %289 = icmp sgt i64 %288, 0
  br i1 %289, label %290, label %299

290:                                              ; preds = %275, %290
  %291 = phi i64 [ %297, %290 ], [ 0, %275 ]
  %292 = phi double [ %296, %290 ], [ %285, %275 ]
  %293 = getelementptr inbounds double, ptr %284, i64 %291
  %294 = load double, ptr %293, align 8, !noalias !14
  %295 = fcmp olt double %294, %292
  %296 = select i1 %295, double %294, double %292
  %297 = add nuw nsw i64 %291, 1
  %298 = icmp eq i64 %297, %288
  br i1 %298, label %299, label %290, !llvm.loop !18

299:                                              ; preds = %290, %275
  %300 = phi double [ %285, %275 ], [ %296, %290 ]
  %301 = load ptr, ptr %66, align 8, !noalias !19
  %302 = getelementptr inbounds i8, ptr %301, i64 8
  %303 = load i64, ptr %302, align 8, !noalias !19
  %304 = and i64 %303, %232
  %305 = getelementptr inbounds i8, ptr %301, i64 32
  %306 = load i64, ptr %305, align 8, !noalias !19
  %307 = and i64 %306, %232
  %308 = icmp eq i64 %304, 0
  br i1 %308, label %372, label %309

309:                                              ; preds = %299
  %310 = load i64, ptr %301, align 8, !noalias !19
  %311 = icmp eq i64 %310, 0
  br i1 %311, label %335, label %312

312:                                              ; preds = %309
  %313 = load ptr, ptr %69, align 8, !noalias !19
  %314 = load ptr, ptr %70, align 8, !noalias !19
  store <8 x double> %236, ptr %314, align 8, !noalias !19
  %315 = load ptr, ptr %20, align 8, !noalias !19
  %316 = getelementptr inbounds i8, ptr %315, i64 40
  %317 = load i64, ptr %316, align 8, !noalias !19
  %318 = icmp eq i64 %317, 0
  br i1 %318, label %320, label %319

319:                                              ; preds = %312
  call fastcc void @settle(ptr noundef nonnull %20) #12, !noalias !19
  br label %320

320:                                              ; preds = %319, %312
  %321 = load i64, ptr %71, align 8, !noalias !19
  %322 = icmp sgt i64 %321, 0
  br i1 %322, label %323, label %324

323:                                              ; preds = %320
  call fastcc void @sample(ptr noundef nonnull %20) #12, !noalias !19
  br label %324

324:                                              ; preds = %323, %320
  %325 = load ptr, ptr %66, align 8, !noalias !19
  %326 = load i64, ptr %325, align 8, !noalias !19
  %327 = load ptr, ptr %70, align 8, !noalias !19
  %328 = load ptr, ptr %22, align 8, !noalias !19
  %329 = load ptr, ptr %72, align 8, !noalias !19
  %330 = load ptr, ptr %73, align 8, !noalias !19
  %331 = inttoptr i64 %326 to ptr
  %332 = load ptr, ptr %331, align 8, !noalias !19
  %333 = call i32 %332(ptr noundef %327, ptr noundef %328, ptr noundef %329, ptr noundef %330, ptr noundef %313) #13, !noalias !19
  %334 = sext i32 %333 to i64
  br label %335

335:                                              ; preds = %309, %324
  %336 = phi i64 [ %334, %324 ], [ 0, %309 ]
  %337 = load i64, ptr %74, align 8, !noalias !19
  %338 = icmp sgt i64 %337, 7
  br i1 %338, label %339, label %360

339:                                              ; preds = %335
  %340 = trunc i64 %304 to i8
  %341 = bitcast i8 %340 to <8 x i1>
  br label %342

342:                                              ; preds = %339, %342
  %343 = phi i64 [ 0, %339 ], [ %356, %342 ]
  %344 = load ptr, ptr %69, align 8, !noalias !19
  %345 = shl nsw i64 %343, 6
  %346 = getelementptr inbounds i8, ptr %344, i64 %345
  %347 = load <8 x double>, ptr %346, align 8, !noalias !19
  %348 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %347)
  %349 = fcmp one <8 x double> %348, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %350 = bitcast <8 x double> %347 to <8 x i64>
  %351 = select <8 x i1> %349, <8 x i64> %350, <8 x i64> zeroinitializer
  %352 = load ptr, ptr %68, align 8, !noalias !19
  %353 = getelementptr inbounds i8, ptr %352, i64 %345
  %354 = load <8 x i64>, ptr %353, align 8, !noalias !19
  %355 = select <8 x i1> %341, <8 x i64> %351, <8 x i64> %354
  store <8 x i64> %355, ptr %353, align 8, !noalias !19
  %356 = add nuw nsw i64 %343, 1
  %357 = load i64, ptr %74, align 8, !noalias !19
  %358 = sdiv i64 %357, 8
  %359 = icmp slt i64 %356, %358
  br i1 %359, label %342, label %360, !llvm.loop !22

360:                                              ; preds = %342, %335
  %361 = icmp slt i64 %336, 0
  br i1 %361, label %1711, label %362

362:                                              ; preds = %360
  %363 = xor i64 %304, -1
  %364 = load i64, ptr %302, align 8, !noalias !19
  %365 = and i64 %364, %363
  store i64 %365, ptr %302, align 8, !noalias !19
  %366 = getelementptr inbounds i8, ptr %301, i64 16
  %367 = load i64, ptr %366, align 8, !noalias !19
  %368 = or i64 %367, %304
  store i64 %368, ptr %366, align 8, !noalias !19
  %369 = getelementptr inbounds i8, ptr %301, i64 24
  %370 = load i64, ptr %369, align 8, !noalias !19
  %371 = and i64 %370, %363
  store i64 %371, ptr %369, align 8, !noalias !19
  br label %372

372:                                              ; preds = %362, %299
  %373 = load ptr, ptr %66, align 8, !noalias !19
  %374 = load ptr, ptr %75, align 8, !noalias !19
  %375 = load <8 x double>, ptr %374, align 8, !noalias !19
  %376 = fsub <8 x double> %252, %375
  %377 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %376)
  %378 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %248)
  %379 = fmul <8 x double> %378, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %380 = fcmp ogt <8 x double> %377, %379
  %381 = bitcast <8 x i1> %380 to i8
  %382 = zext i8 %381 to i64
  %383 = getelementptr inbounds i8, ptr %373, i64 24
  %384 = load i64, ptr %383, align 8, !noalias !19
  %385 = xor i64 %384, -1
  %386 = or i64 %382, %385
  %387 = and i64 %386, %232
  %388 = icmp eq i64 %387, 0
  br i1 %388, label %458, label %389

389:                                              ; preds = %372
  %390 = trunc i64 %387 to i8
  %391 = bitcast i8 %390 to <8 x i1>
  %392 = bitcast <8 x double> %375 to <8 x i64>
  %393 = select <8 x i1> %391, <8 x i64> %251, <8 x i64> %392
  store <8 x i64> %393, ptr %374, align 8, !noalias !19
  %394 = load i64, ptr %76, align 8, !noalias !19
  %395 = sdiv i64 %394, 8
  %396 = load ptr, ptr %77, align 8, !noalias !19
  %397 = load ptr, ptr %78, align 8, !noalias !19
  %398 = icmp sgt i64 %394, 7
  br i1 %398, label %399, label %432

399:                                              ; preds = %389
  %400 = bitcast <8 x i64> %393 to <8 x double>
  %401 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %400
  %402 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %400
  %403 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %400
  br label %404

404:                                              ; preds = %399, %407
  %405 = phi i64 [ 0, %399 ], [ %408, %407 ]
  %406 = mul nuw nsw i64 %405, %395
  br label %410

407:                                              ; preds = %410
  %408 = add nuw nsw i64 %405, 1
  %409 = icmp eq i64 %408, %395
  br i1 %409, label %432, label %404, !llvm.loop !23

410:                                              ; preds = %404, %410
  %411 = phi i64 [ 0, %404 ], [ %430, %410 ]
  %412 = load ptr, ptr %79, align 8, !noalias !19
  %413 = add nuw nsw i64 %411, %406
  %414 = shl nsw i64 %413, 6
  %415 = getelementptr inbounds i8, ptr %412, i64 %414
  %416 = load <8 x double>, ptr %415, align 8, !noalias !19
  %417 = fneg <8 x double> %416
  %418 = icmp eq i64 %405, %411
  %419 = fsub <8 x double> %401, %416
  %420 = select i1 %418, <8 x double> %419, <8 x double> %417
  %421 = fsub <8 x double> %402, %416
  %422 = select i1 %418, <8 x double> %421, <8 x double> %417
  %423 = getelementptr inbounds i8, ptr %396, i64 %414
  store <8 x double> %420, ptr %423, align 8, !noalias !19
  %424 = select i1 %418, <8 x double> %403, <8 x double> zeroinitializer
  %425 = shl i64 %413, 7
  %426 = shl nsw i64 %413, 7
  %427 = getelementptr inbounds i8, ptr %397, i64 %426
  store <8 x double> %422, ptr %427, align 8, !noalias !19
  %428 = or disjoint i64 %425, 64
  %429 = getelementptr inbounds i8, ptr %397, i64 %428
  store <8 x double> %424, ptr %429, align 8, !noalias !19
  %430 = add nuw nsw i64 %411, 1
  %431 = icmp eq i64 %430, %395
  br i1 %431, label %407, label %410, !llvm.loop !24

432:                                              ; preds = %407, %389
  %433 = load ptr, ptr %80, align 8, !noalias !19
  %434 = call fastcc i64 @real_factorise(ptr noundef %396, i64 noundef %395, ptr noundef %433) #12, !noalias !19
  %435 = load ptr, ptr %81, align 8, !noalias !19
  %436 = call fastcc i64 @pair_factorise(ptr noundef %397, i64 noundef %395, ptr noundef %435) #12, !noalias !19
  %437 = or i64 %436, %434
  %438 = and i64 %437, %387
  %439 = load i64, ptr %383, align 8, !noalias !19
  %440 = or i64 %439, %387
  %441 = xor i64 %438, -1
  %442 = xor i64 %438, %440
  store i64 %442, ptr %383, align 8, !noalias !19
  %443 = trunc nuw i64 %438 to i8
  %444 = bitcast i8 %443 to <8 x i1>
  %445 = select <8 x i1> %444, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>, <8 x double> <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %446 = fmul <8 x double> %252, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %447 = select <8 x i1> %444, <8 x double> %446, <8 x double> %241
  %448 = load ptr, ptr %66, align 8, !noalias !19
  %449 = getelementptr inbounds i8, ptr %448, i64 8
  %450 = load i64, ptr %449, align 8, !noalias !19
  %451 = and i64 %450, %441
  %452 = getelementptr inbounds i8, ptr %448, i64 16
  %453 = load i64, ptr %452, align 8, !noalias !19
  %454 = xor i64 %453, -1
  %455 = and i64 %438, %454
  %456 = or disjoint i64 %455, %451
  store i64 %456, ptr %449, align 8, !noalias !19
  %457 = xor i64 %438, %232
  br label %458

458:                                              ; preds = %372, %432
  %459 = phi <8 x double> [ %241, %372 ], [ %447, %432 ]
  %460 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %372 ], [ %445, %432 ]
  %461 = phi i64 [ %232, %372 ], [ %457, %432 ]
  %462 = icmp eq i64 %461, 0
  br i1 %462, label %1711, label %463

463:                                              ; preds = %458
  %464 = fcmp ogt double %300, 0x3CB0000000000000
  %465 = select i1 %464, double %300, double 0x3CB0000000000000
  %466 = fdiv double 0x3CE4000000000000, %465
  %467 = call double @llvm.sqrt.f64(double %300)
  %468 = fcmp olt double %467, 3.000000e-02
  %469 = select i1 %468, double %467, double 3.000000e-02
  %470 = fcmp ogt double %469, %466
  %471 = load ptr, ptr %75, align 8, !noalias !19
  %472 = getelementptr inbounds i8, ptr %471, i64 64
  %473 = load <8 x double>, ptr %472, align 8, !noalias !19
  %474 = load ptr, ptr %20, align 8, !noalias !19
  %475 = getelementptr inbounds i8, ptr %474, i64 8
  %476 = load i64, ptr %475, align 8, !noalias !19
  %477 = load ptr, ptr %82, align 8, !noalias !19
  %478 = load ptr, ptr %22, align 8, !noalias !19
  %479 = load ptr, ptr %83, align 8, !noalias !19
  %480 = load ptr, ptr %84, align 8, !noalias !19
  %481 = fcmp ogt <8 x double> %473, zeroinitializer
  %482 = icmp sgt i64 %476, 0
  %483 = shl i64 %476, 7
  %484 = getelementptr i8, ptr %477, i64 %483
  %485 = mul nsw i64 %476, 3
  br label %490

486:                                              ; preds = %502
  %487 = icmp sgt i64 %476, 0
  %488 = shl i64 %476, 7
  %489 = getelementptr i8, ptr %479, i64 %488
  br label %536

490:                                              ; preds = %463, %502
  %491 = phi i64 [ 0, %463 ], [ %503, %502 ]
  %492 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %491
  %493 = load double, ptr %492, align 8, !noalias !19
  %494 = insertelement <8 x double> poison, double %493, i64 0
  %495 = shufflevector <8 x double> %494, <8 x double> poison, <8 x i32> zeroinitializer
  %496 = fmul <8 x double> %495, %252
  %497 = fdiv <8 x double> %496, %473
  %498 = fadd <8 x double> %497, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  br i1 %482, label %499, label %502

499:                                              ; preds = %490
  %500 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %498
  %501 = mul nuw nsw i64 %476, %491
  br label %505

502:                                              ; preds = %505, %490
  %503 = add nuw nsw i64 %491, 1
  %504 = icmp eq i64 %503, 3
  br i1 %504, label %486, label %490, !llvm.loop !25

505:                                              ; preds = %499, %505
  %506 = phi i64 [ 0, %499 ], [ %534, %505 ]
  %507 = shl i64 %506, 6
  %508 = getelementptr i8, ptr %484, i64 %507
  %509 = load <8 x double>, ptr %508, align 8, !noalias !19
  %510 = add nuw nsw i64 %506, %485
  %511 = shl nsw i64 %510, 6
  %512 = getelementptr inbounds i8, ptr %477, i64 %511
  %513 = load <8 x double>, ptr %512, align 8, !noalias !19
  %514 = fmul <8 x double> %498, %513
  %515 = fadd <8 x double> %509, %514
  %516 = fmul <8 x double> %500, %515
  %517 = shl nsw i64 %506, 6
  %518 = getelementptr inbounds i8, ptr %477, i64 %517
  %519 = load <8 x double>, ptr %518, align 8, !noalias !19
  %520 = add nuw nsw i64 %506, %476
  %521 = shl nsw i64 %520, 6
  %522 = getelementptr inbounds i8, ptr %477, i64 %521
  %523 = load <8 x double>, ptr %522, align 8, !noalias !19
  %524 = fadd <8 x double> %523, %516
  %525 = fmul <8 x double> %498, %524
  %526 = fadd <8 x double> %519, %525
  %527 = getelementptr inbounds i8, ptr %478, i64 %517
  %528 = load <8 x double>, ptr %527, align 8, !noalias !19
  %529 = fsub <8 x double> %526, %528
  %530 = add nuw nsw i64 %506, %501
  %531 = select <8 x i1> %481, <8 x double> %529, <8 x double> zeroinitializer
  %532 = shl nsw i64 %530, 6
  %533 = getelementptr inbounds i8, ptr %479, i64 %532
  store <8 x double> %531, ptr %533, align 8, !noalias !19
  %534 = add nuw nsw i64 %506, 1
  %535 = icmp eq i64 %534, %476
  br i1 %535, label %502, label %505, !llvm.loop !26

536:                                              ; preds = %486, %552
  %537 = phi i64 [ 0, %486 ], [ %553, %552 ]
  br i1 %487, label %538, label %552

538:                                              ; preds = %536
  %539 = mul nuw nsw i64 %476, %537
  %540 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %537
  %541 = load double, ptr %540, align 8, !noalias !19
  %542 = insertelement <8 x double> poison, double %541, i64 0
  %543 = shufflevector <8 x double> %542, <8 x double> poison, <8 x i32> zeroinitializer
  %544 = getelementptr inbounds i8, ptr %540, i64 8
  %545 = load double, ptr %544, align 8, !noalias !19
  %546 = insertelement <8 x double> poison, double %545, i64 0
  %547 = shufflevector <8 x double> %546, <8 x double> poison, <8 x i32> zeroinitializer
  %548 = getelementptr inbounds i8, ptr %540, i64 16
  %549 = load double, ptr %548, align 8, !noalias !19
  %550 = insertelement <8 x double> poison, double %549, i64 0
  %551 = shufflevector <8 x double> %550, <8 x double> poison, <8 x i32> zeroinitializer
  br label %555

552:                                              ; preds = %555, %536
  %553 = add nuw nsw i64 %537, 1
  %554 = icmp eq i64 %553, 3
  br i1 %554, label %577, label %536, !llvm.loop !27

555:                                              ; preds = %538, %555
  %556 = phi i64 [ 0, %538 ], [ %575, %555 ]
  %557 = add nuw nsw i64 %556, %539
  %558 = shl nsw i64 %556, 6
  %559 = getelementptr inbounds i8, ptr %479, i64 %558
  %560 = load <8 x double>, ptr %559, align 8, !noalias !19
  %561 = fmul <8 x double> %560, %543
  %562 = add nuw nsw i64 %556, %476
  %563 = shl nsw i64 %562, 6
  %564 = getelementptr inbounds i8, ptr %479, i64 %563
  %565 = load <8 x double>, ptr %564, align 8, !noalias !19
  %566 = fmul <8 x double> %565, %547
  %567 = fadd <8 x double> %561, %566
  %568 = shl i64 %556, 6
  %569 = getelementptr i8, ptr %489, i64 %568
  %570 = load <8 x double>, ptr %569, align 8, !noalias !19
  %571 = fmul <8 x double> %570, %551
  %572 = fadd <8 x double> %567, %571
  %573 = shl nsw i64 %557, 6
  %574 = getelementptr inbounds i8, ptr %480, i64 %573
  store <8 x double> %572, ptr %574, align 8, !noalias !19
  %575 = add nuw nsw i64 %556, 1
  %576 = icmp eq i64 %575, %476
  br i1 %576, label %552, label %555, !llvm.loop !28

577:                                              ; preds = %552
  %578 = select i1 %470, double %469, double %466
  %579 = fmul double %300, %578
  %580 = load ptr, ptr %66, align 8, !noalias !29
  %581 = getelementptr inbounds i8, ptr %580, i64 40
  %582 = load i64, ptr %581, align 8, !noalias !29
  %583 = icmp sgt i64 %582, 0
  %584 = select i1 %583, i64 10, i64 6
  %585 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %252
  %586 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %252
  %587 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %252
  %588 = fneg <8 x double> %586
  %589 = insertelement <8 x double> poison, double %578, i64 0
  %590 = shufflevector <8 x double> %589, <8 x double> poison, <8 x i32> zeroinitializer
  %591 = fmul double %579, %579
  %592 = insertelement <8 x double> poison, double %591, i64 0
  %593 = shufflevector <8 x double> %592, <8 x double> poison, <8 x i32> zeroinitializer
  br label %597

594:                                              ; preds = %1102
  %595 = add nuw nsw i64 %601, 1
  %596 = icmp eq i64 %595, %584
  br i1 %596, label %1116, label %597, !llvm.loop !32

597:                                              ; preds = %577, %594
  %598 = phi <8 x double> [ <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>, %577 ], [ %1114, %594 ]
  %599 = phi i64 [ %461, %577 ], [ %1113, %594 ]
  %600 = phi i64 [ 0, %577 ], [ %1112, %594 ]
  %601 = phi i64 [ 0, %577 ], [ %595, %594 ]
  %602 = phi i64 [ 0, %577 ], [ %1110, %594 ]
  %603 = phi i64 [ 0, %577 ], [ %690, %594 ]
  %604 = phi <8 x double> [ zeroinitializer, %577 ], [ %689, %594 ]
  %605 = phi <8 x double> [ zeroinitializer, %577 ], [ %1109, %594 ]
  %606 = phi <8 x double> [ zeroinitializer, %577 ], [ %1108, %594 ]
  %607 = phi <8 x double> [ %150, %577 ], [ %1107, %594 ]
  %608 = phi <8 x double> [ %149, %577 ], [ %1106, %594 ]
  %609 = phi <8 x double> [ %148, %577 ], [ %1105, %594 ]
  %610 = phi i64 [ %147, %577 ], [ %1104, %594 ]
  %611 = phi i64 [ %146, %577 ], [ %1103, %594 ]
  %612 = icmp ugt i64 %601, 5
  %613 = select i1 %612, i64 %602, i64 -1
  %614 = and i64 %599, %613
  %615 = load ptr, ptr %20, align 8, !noalias !29
  %616 = getelementptr inbounds i8, ptr %615, i64 8
  %617 = load i64, ptr %616, align 8, !noalias !29
  %618 = load ptr, ptr %83, align 8, !noalias !29
  %619 = icmp eq i64 %614, 0
  br i1 %619, label %688, label %620

620:                                              ; preds = %597
  %621 = icmp sgt i64 %617, 0
  %622 = shl i64 %617, 6
  br label %623

623:                                              ; preds = %620, %655
  %624 = phi i64 [ %614, %620 ], [ %668, %655 ]
  %625 = phi i64 [ 0, %620 ], [ %669, %655 ]
  %626 = phi i64 [ %603, %620 ], [ %666, %655 ]
  %627 = phi <8 x double> [ %604, %620 ], [ %634, %655 ]
  br i1 %621, label %628, label %630

628:                                              ; preds = %623
  %629 = mul nuw nsw i64 %625, %617
  br label %673

630:                                              ; preds = %673, %623
  %631 = trunc i64 %624 to i8
  %632 = bitcast i8 %631 to <8 x i1>
  %633 = select <8 x i1> %632, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %634 = fadd <8 x double> %627, %633
  %635 = load ptr, ptr %86, align 8, !noalias !29
  %636 = mul i64 %622, %625
  %637 = getelementptr inbounds i8, ptr %635, i64 %636
  %638 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %625
  %639 = load double, ptr %638, align 8, !noalias !29
  %640 = insertelement <8 x double> poison, double %639, i64 0
  %641 = shufflevector <8 x double> %640, <8 x double> poison, <8 x i32> zeroinitializer
  %642 = fmul <8 x double> %641, %252
  %643 = fadd <8 x double> %236, %642
  %644 = load ptr, ptr %87, align 8, !noalias !29
  %645 = load ptr, ptr %88, align 8, !noalias !29
  store <8 x double> %643, ptr %645, align 8, !noalias !29
  %646 = load ptr, ptr %20, align 8, !noalias !29
  %647 = getelementptr inbounds i8, ptr %646, i64 40
  %648 = load i64, ptr %647, align 8, !noalias !29
  %649 = icmp eq i64 %648, 0
  br i1 %649, label %651, label %650

650:                                              ; preds = %630
  call fastcc void @settle(ptr noundef nonnull %20) #12, !noalias !29
  br label %651

651:                                              ; preds = %650, %630
  %652 = load i64, ptr %89, align 8, !noalias !29
  %653 = icmp sgt i64 %652, 0
  br i1 %653, label %654, label %655

654:                                              ; preds = %651
  call fastcc void @sample(ptr noundef nonnull %20) #12, !noalias !29
  br label %655

655:                                              ; preds = %654, %651
  %656 = load ptr, ptr %20, align 8, !noalias !29
  %657 = load i64, ptr %656, align 8, !noalias !29
  %658 = load ptr, ptr %88, align 8, !noalias !29
  %659 = load ptr, ptr %90, align 8, !noalias !29
  %660 = load ptr, ptr %91, align 8, !noalias !29
  %661 = inttoptr i64 %657 to ptr
  %662 = load ptr, ptr %661, align 8, !noalias !29
  %663 = call i32 %662(ptr noundef %658, ptr noundef %644, ptr noundef %659, ptr noundef %660, ptr noundef %637) #13, !noalias !29
  %664 = sext i32 %663 to i64
  %665 = and i64 %624, %664
  %666 = or i64 %665, %626
  %667 = xor i64 %664, -1
  %668 = and i64 %624, %667
  %669 = add nuw nsw i64 %625, 1
  %670 = icmp ult i64 %625, 2
  %671 = icmp ne i64 %668, 0
  %672 = select i1 %670, i1 %671, i1 false
  br i1 %672, label %623, label %688, !llvm.loop !33

673:                                              ; preds = %628, %673
  %674 = phi i64 [ 0, %628 ], [ %686, %673 ]
  %675 = load ptr, ptr %85, align 8, !noalias !29
  %676 = load ptr, ptr %22, align 8, !noalias !29
  %677 = shl nsw i64 %674, 6
  %678 = getelementptr inbounds i8, ptr %676, i64 %677
  %679 = load <8 x double>, ptr %678, align 8, !noalias !29
  %680 = add nuw nsw i64 %674, %629
  %681 = shl nsw i64 %680, 6
  %682 = getelementptr inbounds i8, ptr %618, i64 %681
  %683 = load <8 x double>, ptr %682, align 8, !noalias !29
  %684 = fadd <8 x double> %679, %683
  %685 = getelementptr inbounds i8, ptr %675, i64 %677
  store <8 x double> %684, ptr %685, align 8, !noalias !29
  %686 = add nuw nsw i64 %674, 1
  %687 = icmp eq i64 %686, %617
  br i1 %687, label %630, label %673, !llvm.loop !34

688:                                              ; preds = %655, %597
  %689 = phi <8 x double> [ %604, %597 ], [ %634, %655 ]
  %690 = phi i64 [ %603, %597 ], [ %666, %655 ]
  %691 = phi i64 [ %614, %597 ], [ %668, %655 ]
  %692 = icmp eq i64 %691, 0
  br i1 %692, label %693, label %697

693:                                              ; preds = %688
  %694 = or i64 %614, %600
  %695 = xor i64 %694, -1
  %696 = and i64 %602, %695
  br label %1102

697:                                              ; preds = %688
  %698 = load ptr, ptr %20, align 8, !noalias !29
  %699 = getelementptr inbounds i8, ptr %698, i64 8
  %700 = load i64, ptr %699, align 8, !noalias !29
  %701 = getelementptr inbounds i8, ptr %698, i64 24
  %702 = load i64, ptr %701, align 8, !noalias !29
  %703 = load ptr, ptr %92, align 8, !noalias !29
  %704 = load ptr, ptr %84, align 8, !noalias !29
  %705 = icmp sgt i64 %700, 0
  br i1 %705, label %706, label %796

706:                                              ; preds = %697
  %707 = shl i64 %700, 7
  br label %708

708:                                              ; preds = %706, %792
  %709 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %706 ], [ %727, %792 ]
  %710 = phi i64 [ 0, %706 ], [ %794, %792 ]
  %711 = phi <8 x double> [ zeroinitializer, %706 ], [ %793, %792 ]
  %712 = shl nsw i64 %710, 6
  %713 = getelementptr inbounds i8, ptr %703, i64 %712
  %714 = load <8 x double>, ptr %713, align 8, !noalias !29
  %715 = add nuw nsw i64 %710, %700
  %716 = shl nsw i64 %715, 6
  %717 = getelementptr inbounds i8, ptr %703, i64 %716
  %718 = load <8 x double>, ptr %717, align 8, !noalias !29
  %719 = fadd <8 x double> %714, %718
  %720 = shl i64 %710, 6
  %721 = add i64 %720, %707
  %722 = getelementptr inbounds i8, ptr %703, i64 %721
  %723 = load <8 x double>, ptr %722, align 8, !noalias !29
  %724 = fadd <8 x double> %719, %723
  %725 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %724)
  %726 = fcmp one <8 x double> %725, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %727 = select <8 x i1> %726, <8 x i64> %709, <8 x i64> zeroinitializer
  %728 = getelementptr inbounds i8, ptr %704, i64 %716
  %729 = load <8 x double>, ptr %728, align 8, !noalias !29
  %730 = getelementptr inbounds i8, ptr %704, i64 %721
  %731 = load <8 x double>, ptr %730, align 8, !noalias !29
  %732 = fmul <8 x double> %714, <double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46>
  %733 = fmul <8 x double> %718, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %734 = fsub <8 x double> %732, %733
  %735 = fmul <8 x double> %723, <double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221>
  %736 = fadd <8 x double> %734, %735
  %737 = fmul <8 x double> %714, <double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2>
  %738 = fmul <8 x double> %718, <double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598>
  %739 = fsub <8 x double> %737, %738
  %740 = fmul <8 x double> %723, <double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1>
  %741 = fadd <8 x double> %739, %740
  %742 = fmul <8 x double> %714, <double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46>
  %743 = fmul <8 x double> %718, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %744 = fadd <8 x double> %742, %743
  %745 = fmul <8 x double> %723, <double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF>
  %746 = fadd <8 x double> %744, %745
  %747 = getelementptr inbounds i8, ptr %704, i64 %712
  %748 = load <8 x double>, ptr %747, align 8, !noalias !29
  %749 = fmul <8 x double> %587, %748
  %750 = fsub <8 x double> %746, %749
  %751 = fmul <8 x double> %731, %588
  %752 = call <8 x double> @llvm.fma.v8f64(<8 x double> %585, <8 x double> %729, <8 x double> %751)
  %753 = fmul <8 x double> %586, %729
  %754 = call <8 x double> @llvm.fma.v8f64(<8 x double> %585, <8 x double> %731, <8 x double> %753)
  %755 = fsub <8 x double> %736, %752
  %756 = fsub <8 x double> %741, %754
  %757 = load ptr, ptr %93, align 8, !noalias !29
  %758 = getelementptr inbounds i8, ptr %757, i64 %712
  store <8 x double> %750, ptr %758, align 8, !noalias !29
  %759 = load ptr, ptr %94, align 8, !noalias !29
  %760 = shl i64 %710, 7
  %761 = shl nsw i64 %710, 7
  %762 = getelementptr inbounds i8, ptr %759, i64 %761
  store <8 x double> %755, ptr %762, align 8, !noalias !29
  %763 = or disjoint i64 %760, 64
  %764 = getelementptr inbounds i8, ptr %759, i64 %763
  store <8 x double> %756, ptr %764, align 8, !noalias !29
  %765 = icmp slt i64 %710, %702
  br i1 %765, label %766, label %792

766:                                              ; preds = %708
  %767 = load ptr, ptr %22, align 8, !noalias !29
  %768 = getelementptr inbounds i8, ptr %767, i64 %712
  %769 = load <8 x double>, ptr %768, align 8, !noalias !29
  %770 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %750)
  %771 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %755)
  %772 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %756)
  %773 = fadd <8 x double> %772, %771
  %774 = fadd <8 x double> %770, %773
  %775 = fmul <8 x double> %774, %252
  %776 = load ptr, ptr %95, align 8, !noalias !29
  %777 = getelementptr inbounds double, ptr %776, i64 %710
  %778 = load double, ptr %777, align 8, !noalias !29
  %779 = insertelement <8 x double> poison, double %778, i64 0
  %780 = shufflevector <8 x double> %779, <8 x double> poison, <8 x i32> zeroinitializer
  %781 = load ptr, ptr %67, align 8, !noalias !29
  %782 = getelementptr inbounds double, ptr %781, i64 %710
  %783 = load double, ptr %782, align 8, !noalias !29
  %784 = insertelement <8 x double> poison, double %783, i64 0
  %785 = shufflevector <8 x double> %784, <8 x double> poison, <8 x i32> zeroinitializer
  %786 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %769)
  %787 = fmul <8 x double> %786, %785
  %788 = fadd <8 x double> %780, %787
  %789 = fdiv <8 x double> %775, %788
  %790 = fmul <8 x double> %789, %789
  %791 = fadd <8 x double> %711, %790
  br label %792

792:                                              ; preds = %766, %708
  %793 = phi <8 x double> [ %791, %766 ], [ %711, %708 ]
  %794 = add nuw nsw i64 %710, 1
  %795 = icmp eq i64 %794, %700
  br i1 %795, label %796, label %708, !llvm.loop !35

796:                                              ; preds = %792, %697
  %797 = phi <8 x double> [ zeroinitializer, %697 ], [ %793, %792 ]
  %798 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %697 ], [ %727, %792 ]
  %799 = icmp ne <8 x i64> %798, zeroinitializer
  %800 = bitcast <8 x i1> %799 to i8
  %801 = zext i8 %800 to i64
  %802 = and i64 %691, %801
  %803 = xor i64 %802, %691
  %804 = trunc i64 %803 to i8
  %805 = bitcast i8 %804 to <8 x i1>
  %806 = load ptr, ptr %20, align 8, !noalias !29
  %807 = getelementptr inbounds i8, ptr %806, i64 24
  %808 = load i64, ptr %807, align 8, !noalias !29
  %809 = load i64, ptr %97, align 8, !noalias !29
  %810 = sdiv i64 %809, 8
  %811 = load ptr, ptr %66, align 8, !noalias !29
  %812 = getelementptr inbounds i8, ptr %811, i64 40
  %813 = load i64, ptr %812, align 8, !noalias !29
  %814 = load ptr, ptr %98, align 8, !noalias !29
  %815 = load ptr, ptr %99, align 8, !noalias !29
  %816 = load ptr, ptr %100, align 8, !noalias !29
  %817 = load ptr, ptr %96, align 8, !noalias !29
  call fastcc void @real_solve(ptr noundef %816, i64 noundef %810, ptr noundef %817, ptr noundef %814) #12, !noalias !29
  %818 = load ptr, ptr %101, align 8, !noalias !29
  %819 = load ptr, ptr %102, align 8, !noalias !29
  call fastcc void @pair_solve(ptr noundef %818, i64 noundef %810, ptr noundef %819, ptr noundef %815) #12, !noalias !29
  %820 = icmp sgt i64 %813, 0
  br i1 %820, label %821, label %830

821:                                              ; preds = %796
  %822 = load ptr, ptr %100, align 8, !noalias !29
  %823 = load ptr, ptr %96, align 8, !noalias !29
  %824 = shl nsw i64 %810, 6
  %825 = getelementptr inbounds i8, ptr %814, i64 %824
  call fastcc void @real_solve_columns(ptr noundef %822, i64 noundef %810, ptr noundef %823, ptr noundef %825, i64 noundef %813) #12, !noalias !29
  %826 = load ptr, ptr %101, align 8, !noalias !29
  %827 = load ptr, ptr %102, align 8, !noalias !29
  %828 = shl nsw i64 %810, 7
  %829 = getelementptr inbounds i8, ptr %815, i64 %828
  call fastcc void @pair_solve_columns(ptr noundef %826, i64 noundef %810, ptr noundef %827, ptr noundef %829, i64 noundef %813) #12, !noalias !29
  br label %830

830:                                              ; preds = %821, %796
  %831 = icmp sgt i64 %808, 0
  br i1 %831, label %832, label %873

832:                                              ; preds = %830
  %833 = load ptr, ptr %22, align 8, !noalias !29
  %834 = load ptr, ptr %103, align 8, !noalias !29
  %835 = load ptr, ptr %67, align 8, !noalias !29
  br label %836

836:                                              ; preds = %832, %836
  %837 = phi <8 x double> [ zeroinitializer, %832 ], [ %870, %836 ]
  %838 = phi i64 [ 0, %832 ], [ %871, %836 ]
  %839 = shl nsw i64 %838, 6
  %840 = getelementptr inbounds i8, ptr %833, i64 %839
  %841 = load <8 x double>, ptr %840, align 8, !noalias !29
  %842 = getelementptr inbounds double, ptr %834, i64 %838
  %843 = load double, ptr %842, align 8, !noalias !29
  %844 = insertelement <8 x double> poison, double %843, i64 0
  %845 = shufflevector <8 x double> %844, <8 x double> poison, <8 x i32> zeroinitializer
  %846 = getelementptr inbounds double, ptr %835, i64 %838
  %847 = load double, ptr %846, align 8, !noalias !29
  %848 = insertelement <8 x double> poison, double %847, i64 0
  %849 = shufflevector <8 x double> %848, <8 x double> poison, <8 x i32> zeroinitializer
  %850 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %841)
  %851 = fmul <8 x double> %850, %849
  %852 = fadd <8 x double> %845, %851
  %853 = getelementptr inbounds i8, ptr %814, i64 %839
  %854 = load <8 x double>, ptr %853, align 8, !noalias !29
  %855 = fdiv <8 x double> %854, %852
  %856 = shl i64 %838, 7
  %857 = shl nsw i64 %838, 7
  %858 = getelementptr inbounds i8, ptr %815, i64 %857
  %859 = load <8 x double>, ptr %858, align 8, !noalias !36
  %860 = or disjoint i64 %856, 64
  %861 = getelementptr inbounds i8, ptr %815, i64 %860
  %862 = load <8 x double>, ptr %861, align 8, !noalias !36
  %863 = fdiv <8 x double> %859, %852
  %864 = fdiv <8 x double> %862, %852
  %865 = fmul <8 x double> %855, %855
  %866 = fmul <8 x double> %863, %863
  %867 = fadd <8 x double> %865, %866
  %868 = fmul <8 x double> %864, %864
  %869 = fadd <8 x double> %868, %867
  %870 = fadd <8 x double> %837, %869
  %871 = add nuw nsw i64 %838, 1
  %872 = icmp eq i64 %871, %808
  br i1 %872, label %873, label %836, !llvm.loop !39

873:                                              ; preds = %836, %830
  %874 = phi <8 x double> [ zeroinitializer, %830 ], [ %870, %836 ]
  %875 = mul nsw i64 %808, 3
  %876 = sitofp i64 %875 to double
  %877 = insertelement <8 x double> poison, double %876, i64 0
  %878 = shufflevector <8 x double> %877, <8 x double> poison, <8 x i32> zeroinitializer
  %879 = fdiv <8 x double> %874, %878
  %880 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %879)
  %881 = fcmp oeq <8 x double> %880, zeroinitializer
  %882 = fcmp ogt <8 x double> %797, zeroinitializer
  %883 = and <8 x i1> %881, %882
  %884 = bitcast <8 x i1> %883 to i8
  %885 = zext i8 %884 to i64
  %886 = xor i64 %885, -1
  %887 = and i64 %802, %886
  %888 = xor i64 %602, -1
  %889 = and i64 %887, %888
  %890 = trunc nuw i64 %889 to i8
  %891 = bitcast i8 %890 to <8 x i1>
  %892 = fcmp ogt <8 x double> %598, zeroinitializer
  %893 = select <8 x i1> %892, <8 x i1> %891, <8 x i1> zeroinitializer
  %894 = fdiv <8 x double> %880, %598
  %895 = select <8 x i1> %805, <8 x double> <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, <8 x double> %605
  %896 = select <8 x i1> %893, <8 x double> %894, <8 x double> %895
  %897 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %896
  %898 = fdiv <8 x double> %880, %897
  %899 = icmp ult i64 %601, 5
  br i1 %899, label %1010, label %900

900:                                              ; preds = %1010, %873
  %901 = phi <8 x double> [ %898, %873 ], [ %1013, %1010 ]
  %902 = fcmp oge <8 x double> %896, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %903 = fcmp ogt <8 x double> %901, %590
  %904 = or <8 x i1> %903, %902
  %905 = select <8 x i1> %904, <8 x i1> %893, <8 x i1> zeroinitializer
  %906 = bitcast <8 x i1> %905 to i8
  %907 = zext i8 %906 to i64
  %908 = xor i64 %907, -1
  %909 = and i64 %887, %908
  %910 = xor i64 %909, -1
  %911 = and i64 %614, %910
  %912 = or i64 %911, %600
  %913 = load ptr, ptr %20, align 8, !noalias !29
  %914 = getelementptr inbounds i8, ptr %913, i64 8
  %915 = load i64, ptr %914, align 8, !noalias !29
  %916 = trunc nuw i64 %909 to i8
  %917 = bitcast i8 %916 to <8 x i1>
  %918 = load ptr, ptr %83, align 8, !noalias !29
  %919 = load ptr, ptr %84, align 8, !noalias !29
  %920 = icmp sgt i64 %915, 0
  br i1 %920, label %921, label %992

921:                                              ; preds = %900
  %922 = shl i64 %915, 7
  %923 = getelementptr i8, ptr %919, i64 %922
  br label %924

924:                                              ; preds = %921, %958
  %925 = phi i64 [ 0, %921 ], [ %959, %958 ]
  %926 = load ptr, ptr %99, align 8, !noalias !29
  %927 = shl i64 %925, 7
  %928 = shl nsw i64 %925, 7
  %929 = getelementptr inbounds i8, ptr %926, i64 %928
  %930 = load <8 x double>, ptr %929, align 8, !noalias !40
  %931 = or disjoint i64 %927, 64
  %932 = getelementptr inbounds i8, ptr %926, i64 %931
  %933 = load <8 x double>, ptr %932, align 8, !noalias !40
  %934 = load ptr, ptr %98, align 8, !noalias !29
  %935 = shl nsw i64 %925, 6
  %936 = getelementptr inbounds i8, ptr %934, i64 %935
  %937 = load <8 x double>, ptr %936, align 8, !noalias !29
  store <8 x double> %937, ptr %11, align 64, !noalias !29
  store <8 x double> %930, ptr %104, align 64, !noalias !29
  store <8 x double> %933, ptr %105, align 64, !noalias !29
  br label %945

938:                                              ; preds = %945
  %939 = getelementptr inbounds i8, ptr %919, i64 %935
  %940 = add nuw nsw i64 %925, %915
  %941 = shl nsw i64 %940, 6
  %942 = getelementptr inbounds i8, ptr %919, i64 %941
  %943 = shl i64 %925, 6
  %944 = getelementptr i8, ptr %923, i64 %943
  br label %961

945:                                              ; preds = %924, %945
  %946 = phi i64 [ 0, %924 ], [ %956, %945 ]
  %947 = mul nuw nsw i64 %915, %946
  %948 = add nuw nsw i64 %947, %925
  %949 = shl nsw i64 %948, 6
  %950 = getelementptr inbounds i8, ptr %919, i64 %949
  %951 = load <8 x double>, ptr %950, align 8, !noalias !29
  %952 = getelementptr inbounds [3 x <8 x double>], ptr %11, i64 0, i64 %946
  %953 = load <8 x double>, ptr %952, align 64, !noalias !29
  %954 = fadd <8 x double> %951, %953
  %955 = select <8 x i1> %917, <8 x double> %954, <8 x double> %951
  store <8 x double> %955, ptr %950, align 8, !noalias !29
  %956 = add nuw nsw i64 %946, 1
  %957 = icmp eq i64 %956, 3
  br i1 %957, label %938, label %945, !llvm.loop !43

958:                                              ; preds = %961
  %959 = add nuw nsw i64 %925, 1
  %960 = icmp eq i64 %959, %915
  br i1 %960, label %992, label %924, !llvm.loop !44

961:                                              ; preds = %938, %961
  %962 = phi i64 [ 0, %938 ], [ %990, %961 ]
  %963 = mul nuw nsw i64 %915, %962
  %964 = add nuw nsw i64 %963, %925
  %965 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %962
  %966 = load double, ptr %965, align 8, !noalias !29
  %967 = insertelement <8 x double> poison, double %966, i64 0
  %968 = shufflevector <8 x double> %967, <8 x double> poison, <8 x i32> zeroinitializer
  %969 = load <8 x double>, ptr %939, align 8, !noalias !29
  %970 = fmul <8 x double> %969, %968
  %971 = getelementptr inbounds i8, ptr %965, i64 8
  %972 = load double, ptr %971, align 8, !noalias !29
  %973 = insertelement <8 x double> poison, double %972, i64 0
  %974 = shufflevector <8 x double> %973, <8 x double> poison, <8 x i32> zeroinitializer
  %975 = load <8 x double>, ptr %942, align 8, !noalias !29
  %976 = fmul <8 x double> %975, %974
  %977 = fadd <8 x double> %970, %976
  %978 = getelementptr inbounds i8, ptr %965, i64 16
  %979 = load double, ptr %978, align 8, !noalias !29
  %980 = insertelement <8 x double> poison, double %979, i64 0
  %981 = shufflevector <8 x double> %980, <8 x double> poison, <8 x i32> zeroinitializer
  %982 = load <8 x double>, ptr %944, align 8, !noalias !29
  %983 = fmul <8 x double> %982, %981
  %984 = fadd <8 x double> %977, %983
  %985 = shl nsw i64 %964, 6
  %986 = getelementptr inbounds i8, ptr %918, i64 %985
  %987 = load <8 x i64>, ptr %986, align 8, !noalias !29
  %988 = bitcast <8 x double> %984 to <8 x i64>
  %989 = select <8 x i1> %917, <8 x i64> %988, <8 x i64> %987
  store <8 x i64> %989, ptr %986, align 8, !noalias !29
  %990 = add nuw nsw i64 %962, 1
  %991 = icmp eq i64 %990, 3
  br i1 %991, label %958, label %961, !llvm.loop !45

992:                                              ; preds = %958, %900
  %993 = fdiv <8 x double> %896, %897
  %994 = fmul <8 x double> %880, %993
  %995 = fcmp olt <8 x double> %994, %590
  %996 = and <8 x i1> %995, %892
  %997 = or <8 x i1> %996, %881
  %998 = bitcast <8 x i1> %997 to i8
  %999 = zext i8 %998 to i64
  %1000 = and i64 %999, %888
  %1001 = and i64 %1000, %909
  %1002 = trunc nuw i64 %1001 to i8
  %1003 = bitcast i8 %1002 to <8 x i1>
  %1004 = add nuw nsw i64 %601, 1
  %1005 = uitofp nneg i64 %1004 to double
  %1006 = insertelement <8 x double> poison, double %1005, i64 0
  %1007 = shufflevector <8 x double> %1006, <8 x double> poison, <8 x i32> zeroinitializer
  %1008 = select <8 x i1> %1003, <8 x double> %1007, <8 x double> %606
  %1009 = or i64 %1001, %602
  br i1 %583, label %1016, label %1095

1010:                                             ; preds = %873, %1010
  %1011 = phi i64 [ %1014, %1010 ], [ %601, %873 ]
  %1012 = phi <8 x double> [ %1013, %1010 ], [ %898, %873 ]
  %1013 = fmul <8 x double> %1012, %896
  %1014 = add nuw nsw i64 %1011, 1
  %1015 = icmp ult i64 %1011, 4
  br i1 %1015, label %1010, label %900, !llvm.loop !46

1016:                                             ; preds = %992
  %1017 = load i64, ptr %97, align 8, !noalias !29
  %1018 = sdiv i64 %1017, 8
  %1019 = load ptr, ptr %66, align 8, !noalias !29
  %1020 = getelementptr inbounds i8, ptr %1019, i64 40
  %1021 = load i64, ptr %1020, align 8, !noalias !29
  %1022 = load ptr, ptr %20, align 8, !noalias !29
  %1023 = getelementptr inbounds i8, ptr %1022, i64 8
  %1024 = load i64, ptr %1023, align 8, !noalias !29
  %1025 = load ptr, ptr %84, align 8, !noalias !29
  %1026 = icmp sgt i64 %1021, 0
  br i1 %1026, label %1027, label %1089

1027:                                             ; preds = %1016
  %1028 = icmp sgt i64 %1017, 7
  br label %1029

1029:                                             ; preds = %1027, %1037
  %1030 = phi <8 x double> [ zeroinitializer, %1027 ], [ %1045, %1037 ]
  %1031 = phi i64 [ 0, %1027 ], [ %1046, %1037 ]
  br i1 %1028, label %1032, label %1037

1032:                                             ; preds = %1029
  %1033 = add nuw i64 %1031, %1018
  %1034 = load ptr, ptr %98, align 8, !noalias !29
  %1035 = load ptr, ptr %22, align 8, !noalias !29
  %1036 = load ptr, ptr %99, align 8, !noalias !29
  br label %1048

1037:                                             ; preds = %1073, %1029
  %1038 = phi <8 x double> [ zeroinitializer, %1029 ], [ %1086, %1073 ]
  %1039 = phi <8 x double> [ zeroinitializer, %1029 ], [ %1074, %1073 ]
  %1040 = fcmp ogt <8 x double> %1038, zeroinitializer
  %1041 = fdiv <8 x double> %1039, %1038
  %1042 = fmul <8 x double> %1030, %1038
  %1043 = fcmp ogt <8 x double> %1039, %1042
  %1044 = select <8 x i1> %1040, <8 x double> %1041, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1045 = select <8 x i1> %1043, <8 x double> %1044, <8 x double> %1030
  %1046 = add nuw nsw i64 %1031, 1
  %1047 = icmp eq i64 %1046, %1021
  br i1 %1047, label %1089, label %1029, !llvm.loop !47

1048:                                             ; preds = %1032, %1073
  %1049 = phi <8 x double> [ zeroinitializer, %1032 ], [ %1074, %1073 ]
  %1050 = phi i64 [ 0, %1032 ], [ %1075, %1073 ]
  %1051 = phi <8 x double> [ zeroinitializer, %1032 ], [ %1086, %1073 ]
  %1052 = mul nuw nsw i64 %1050, %1021
  %1053 = add i64 %1033, %1052
  %1054 = shl nsw i64 %1053, 6
  %1055 = getelementptr inbounds i8, ptr %1034, i64 %1054
  %1056 = load <8 x double>, ptr %1055, align 8, !noalias !29
  %1057 = getelementptr inbounds i8, ptr %1035, i64 %1054
  %1058 = load <8 x double>, ptr %1057, align 8, !noalias !29
  %1059 = shl i64 %1053, 7
  %1060 = shl nsw i64 %1053, 7
  %1061 = getelementptr inbounds i8, ptr %1036, i64 %1060
  %1062 = load <8 x double>, ptr %1061, align 8, !noalias !48
  %1063 = or disjoint i64 %1059, 64
  %1064 = getelementptr inbounds i8, ptr %1036, i64 %1063
  %1065 = load <8 x double>, ptr %1064, align 8, !noalias !48
  %1066 = fmul <8 x double> %1056, %1056
  %1067 = fmul <8 x double> %1062, %1062
  %1068 = fmul <8 x double> %1065, %1065
  %1069 = fadd <8 x double> %1067, %1068
  %1070 = fadd <8 x double> %1066, %1069
  %1071 = fmul <8 x double> %1058, %1058
  %1072 = fadd <8 x double> %1051, %1071
  br label %1077

1073:                                             ; preds = %1077
  %1074 = fadd <8 x double> %1049, %1070
  %1075 = add nuw nsw i64 %1050, 1
  %1076 = icmp eq i64 %1075, %1018
  br i1 %1076, label %1037, label %1048, !llvm.loop !51

1077:                                             ; preds = %1048, %1077
  %1078 = phi i64 [ 0, %1048 ], [ %1087, %1077 ]
  %1079 = phi <8 x double> [ %1072, %1048 ], [ %1086, %1077 ]
  %1080 = mul nsw i64 %1024, %1078
  %1081 = add nsw i64 %1080, %1053
  %1082 = shl nsw i64 %1081, 6
  %1083 = getelementptr inbounds i8, ptr %1025, i64 %1082
  %1084 = load <8 x double>, ptr %1083, align 8, !noalias !29
  %1085 = fmul <8 x double> %1084, %1084
  %1086 = fadd <8 x double> %1079, %1085
  %1087 = add nuw nsw i64 %1078, 1
  %1088 = icmp eq i64 %1087, 3
  br i1 %1088, label %1073, label %1077, !llvm.loop !52

1089:                                             ; preds = %1037, %1016
  %1090 = phi <8 x double> [ zeroinitializer, %1016 ], [ %1045, %1037 ]
  %1091 = fcmp ole <8 x double> %1090, %593
  %1092 = bitcast <8 x i1> %1091 to i8
  %1093 = zext i8 %1092 to i64
  %1094 = and i64 %1009, %1093
  br label %1095

1095:                                             ; preds = %1089, %992
  %1096 = phi i64 [ %1094, %1089 ], [ %1009, %992 ]
  %1097 = xor i64 %1096, -1
  %1098 = and i64 %909, %1097
  %1099 = icmp eq i64 %1098, 0
  %1100 = select i1 %1099, i32 2, i32 0
  %1101 = select i1 %1099, <8 x double> %598, <8 x double> %880
  br label %1102

1102:                                             ; preds = %1095, %693
  %1103 = phi i64 [ %696, %693 ], [ %611, %1095 ]
  %1104 = phi i64 [ %690, %693 ], [ %610, %1095 ]
  %1105 = phi <8 x double> [ %606, %693 ], [ %609, %1095 ]
  %1106 = phi <8 x double> [ %605, %693 ], [ %608, %1095 ]
  %1107 = phi <8 x double> [ %689, %693 ], [ %607, %1095 ]
  %1108 = phi <8 x double> [ %606, %693 ], [ %1008, %1095 ]
  %1109 = phi <8 x double> [ %605, %693 ], [ %896, %1095 ]
  %1110 = phi i64 [ %696, %693 ], [ %1009, %1095 ]
  %1111 = phi i32 [ 1, %693 ], [ %1100, %1095 ]
  %1112 = phi i64 [ %600, %693 ], [ %912, %1095 ]
  %1113 = phi i64 [ %614, %693 ], [ %1098, %1095 ]
  %1114 = phi <8 x double> [ %598, %693 ], [ %1101, %1095 ]
  %1115 = icmp eq i32 %1111, 0
  br i1 %1115, label %594, label %1116

1116:                                             ; preds = %1102, %594
  %1117 = phi i32 [ %1111, %1102 ], [ 2, %594 ]
  %1118 = icmp eq i32 %1117, 2
  br i1 %1118, label %1119, label %1122

1119:                                             ; preds = %1116
  %1120 = xor i64 %1112, -1
  %1121 = and i64 %1110, %1120
  br label %1122

1122:                                             ; preds = %1116, %1119
  %1123 = phi i64 [ %1121, %1119 ], [ %1103, %1116 ]
  %1124 = phi i64 [ %690, %1119 ], [ %1104, %1116 ]
  %1125 = phi <8 x double> [ %1108, %1119 ], [ %1105, %1116 ]
  %1126 = phi <8 x double> [ %1109, %1119 ], [ %1106, %1116 ]
  %1127 = phi <8 x double> [ %689, %1119 ], [ %1107, %1116 ]
  %1128 = fadd <8 x double> %1127, zeroinitializer
  %1129 = fcmp ogt <8 x double> %1125, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %1130 = fcmp ogt <8 x double> %1126, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %1131 = and <8 x i1> %1130, %1129
  %1132 = bitcast <8 x i1> %1131 to i8
  %1133 = icmp eq i64 %1123, %461
  br i1 %1133, label %1210, label %1134

1134:                                             ; preds = %1122
  %1135 = xor i64 %1123, -1
  %1136 = and i64 %461, %1135
  %1137 = load ptr, ptr %66, align 8, !noalias !19
  %1138 = getelementptr inbounds i8, ptr %1137, i64 16
  %1139 = load i64, ptr %1138, align 8, !noalias !19
  %1140 = xor i64 %1124, -1
  %1141 = and i64 %1139, %1140
  %1142 = and i64 %1141, %1136
  %1143 = trunc i64 %1136 to i8
  %1144 = bitcast i8 %1143 to <8 x i1>
  %1145 = trunc i64 %1124 to i8
  %1146 = bitcast i8 %1145 to <8 x i1>
  %1147 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1126)
  %1148 = fcmp one <8 x double> %1147, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1149 = select <8 x i1> %1148, <8 x double> <double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00>, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %1150 = select <8 x i1> %1146, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1149
  %1151 = select <8 x i1> %1144, <8 x double> %1150, <8 x double> %460
  %1152 = icmp eq i64 %1142, 0
  br i1 %1152, label %1180, label %1153

1153:                                             ; preds = %1134
  %1154 = load i64, ptr %106, align 8, !noalias !19
  %1155 = icmp sgt i64 %1154, 7
  br i1 %1155, label %1156, label %1173

1156:                                             ; preds = %1153
  %1157 = trunc i64 %1142 to i8
  %1158 = bitcast i8 %1157 to <8 x i1>
  br label %1159

1159:                                             ; preds = %1156, %1159
  %1160 = phi <8 x i64> [ zeroinitializer, %1156 ], [ %1167, %1159 ]
  %1161 = phi i64 [ 0, %1156 ], [ %1169, %1159 ]
  %1162 = load ptr, ptr %107, align 8, !noalias !19
  %1163 = shl nsw i64 %1161, 6
  %1164 = getelementptr inbounds i8, ptr %1162, i64 %1163
  %1165 = load <8 x double>, ptr %1164, align 8, !noalias !19
  %1166 = fcmp une <8 x double> %1165, zeroinitializer
  %1167 = select <8 x i1> %1166, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %1160
  %1168 = select <8 x i1> %1158, <8 x double> zeroinitializer, <8 x double> %1165
  store <8 x double> %1168, ptr %1164, align 8, !noalias !19
  %1169 = add nuw nsw i64 %1161, 1
  %1170 = load i64, ptr %106, align 8, !noalias !19
  %1171 = sdiv i64 %1170, 8
  %1172 = icmp slt i64 %1169, %1171
  br i1 %1172, label %1159, label %1173, !llvm.loop !53

1173:                                             ; preds = %1159, %1153
  %1174 = phi <8 x i64> [ zeroinitializer, %1153 ], [ %1167, %1159 ]
  %1175 = icmp ne <8 x i64> %1174, zeroinitializer
  %1176 = bitcast <8 x i1> %1175 to i8
  %1177 = zext i8 %1176 to i64
  %1178 = and i64 %1142, %1177
  %1179 = xor i64 %1178, -1
  br label %1180

1180:                                             ; preds = %1134, %1173
  %1181 = phi i64 [ -1, %1134 ], [ %1179, %1173 ]
  %1182 = and i64 %1181, %1142
  %1183 = getelementptr inbounds i8, ptr %1137, i64 24
  %1184 = load i64, ptr %1183, align 8, !noalias !19
  %1185 = and i64 %1184, %1181
  store i64 %1185, ptr %1183, align 8, !noalias !19
  %1186 = xor i64 %1182, -1
  %1187 = load i64, ptr %1138, align 8, !noalias !19
  %1188 = and i64 %1187, %1186
  store i64 %1188, ptr %1138, align 8, !noalias !19
  %1189 = trunc i64 %1182 to i8
  %1190 = bitcast i8 %1189 to <8 x i1>
  %1191 = fmul <8 x double> %252, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %1192 = select <8 x i1> %1190, <8 x double> %1191, <8 x double> %459
  %1193 = fmul <8 x double> %252, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1194 = select <8 x i1> %1146, <8 x double> %1193, <8 x double> %1192
  %1195 = load ptr, ptr %75, align 8, !noalias !19
  %1196 = getelementptr inbounds i8, ptr %1195, i64 64
  %1197 = load <8 x double>, ptr %1196, align 8, !noalias !19
  %1198 = select <8 x i1> %1146, <8 x double> zeroinitializer, <8 x double> %1197
  store <8 x double> %1198, ptr %1196, align 8, !noalias !19
  %1199 = and i64 %1181, %1136
  %1200 = load ptr, ptr %66, align 8, !noalias !19
  %1201 = getelementptr inbounds i8, ptr %1200, i64 8
  %1202 = load i64, ptr %1201, align 8, !noalias !19
  %1203 = xor i64 %1199, -1
  %1204 = and i64 %1202, %1203
  %1205 = getelementptr inbounds i8, ptr %1200, i64 16
  %1206 = load i64, ptr %1205, align 8, !noalias !19
  %1207 = xor i64 %1206, -1
  %1208 = and i64 %1199, %1207
  %1209 = or disjoint i64 %1208, %1204
  store i64 %1209, ptr %1201, align 8, !noalias !19
  br label %1210

1210:                                             ; preds = %1180, %1122
  %1211 = phi <8 x double> [ %459, %1122 ], [ %1194, %1180 ]
  %1212 = phi <8 x double> [ %460, %1122 ], [ %1151, %1180 ]
  %1213 = icmp eq i64 %1123, 0
  br i1 %1213, label %1711, label %1214

1214:                                             ; preds = %1210
  %1215 = icmp sgt i64 %288, 0
  br i1 %1215, label %1216, label %1218

1216:                                             ; preds = %1214
  %1217 = shl i64 %288, 7
  br label %1695

1218:                                             ; preds = %1695, %1214
  %1219 = load i64, ptr %305, align 8, !noalias !19
  %1220 = load ptr, ptr %20, align 8, !noalias !19
  %1221 = getelementptr inbounds i8, ptr %1220, i64 8
  %1222 = load i64, ptr %1221, align 8, !noalias !19
  %1223 = load ptr, ptr %109, align 8, !noalias !19
  %1224 = load ptr, ptr %110, align 8, !noalias !19
  %1225 = icmp sgt i64 %1222, 0
  br i1 %1225, label %1226, label %1228

1226:                                             ; preds = %1218
  %1227 = shl i64 %1222, 7
  br label %1384

1228:                                             ; preds = %1384, %1218
  %1229 = load i64, ptr %113, align 8, !noalias !19
  %1230 = sdiv i64 %1229, 8
  %1231 = load ptr, ptr %66, align 8, !noalias !19
  %1232 = getelementptr inbounds i8, ptr %1231, i64 40
  %1233 = load i64, ptr %1232, align 8, !noalias !19
  %1234 = load ptr, ptr %114, align 8, !noalias !19
  %1235 = load ptr, ptr %112, align 8, !noalias !19
  call fastcc void @real_solve(ptr noundef %1234, i64 noundef %1230, ptr noundef %1235, ptr noundef %1224) #12, !noalias !19
  %1236 = icmp sgt i64 %1233, 0
  br i1 %1236, label %1237, label %1242

1237:                                             ; preds = %1228
  %1238 = load ptr, ptr %114, align 8, !noalias !19
  %1239 = load ptr, ptr %112, align 8, !noalias !19
  %1240 = shl nsw i64 %1230, 6
  %1241 = getelementptr inbounds i8, ptr %1224, i64 %1240
  call fastcc void @real_solve_columns(ptr noundef %1238, i64 noundef %1230, ptr noundef %1239, ptr noundef %1241, i64 noundef %1233) #12, !noalias !19
  br label %1242

1242:                                             ; preds = %1228, %1237
  %1243 = load ptr, ptr %20, align 8, !noalias !19
  %1244 = getelementptr inbounds i8, ptr %1243, i64 24
  %1245 = load i64, ptr %1244, align 8, !noalias !19
  %1246 = load ptr, ptr %115, align 8, !noalias !19
  call fastcc void @norm_to(ptr noundef nonnull %9, ptr noundef %1224, ptr noundef %1246, ptr noundef nonnull %22, i64 noundef %1245) #12, !noalias !19
  %1247 = load <8 x double>, ptr %9, align 16, !noalias !19
  %1248 = getelementptr inbounds i8, ptr %1243, i64 8
  %1249 = load i64, ptr %1248, align 8, !noalias !19
  %1250 = add nsw i64 %1249, -3
  %1251 = getelementptr i8, ptr %1246, i64 64
  %1252 = getelementptr i8, ptr %1246, i64 128
  %1253 = getelementptr i8, ptr %1246, i64 192
  %1254 = icmp slt i64 %1245, %1250
  br i1 %1254, label %1262, label %1255

1255:                                             ; preds = %1262, %1242
  %1256 = phi <8 x double> [ zeroinitializer, %1242 ], [ %1272, %1262 ]
  %1257 = phi <8 x double> [ zeroinitializer, %1242 ], [ %1277, %1262 ]
  %1258 = phi <8 x double> [ zeroinitializer, %1242 ], [ %1282, %1262 ]
  %1259 = phi <8 x double> [ zeroinitializer, %1242 ], [ %1287, %1262 ]
  %1260 = phi i64 [ %1245, %1242 ], [ %1288, %1262 ]
  %1261 = icmp slt i64 %1260, %1249
  br i1 %1261, label %1290, label %1300

1262:                                             ; preds = %1242, %1262
  %1263 = phi i64 [ %1288, %1262 ], [ %1245, %1242 ]
  %1264 = phi <8 x double> [ %1287, %1262 ], [ zeroinitializer, %1242 ]
  %1265 = phi <8 x double> [ %1282, %1262 ], [ zeroinitializer, %1242 ]
  %1266 = phi <8 x double> [ %1277, %1262 ], [ zeroinitializer, %1242 ]
  %1267 = phi <8 x double> [ %1272, %1262 ], [ zeroinitializer, %1242 ]
  %1268 = shl nsw i64 %1263, 6
  %1269 = getelementptr inbounds i8, ptr %1246, i64 %1268
  %1270 = load <8 x double>, ptr %1269, align 8, !noalias !19
  %1271 = fmul <8 x double> %1270, zeroinitializer
  %1272 = fadd <8 x double> %1267, %1271
  %1273 = shl i64 %1263, 6
  %1274 = getelementptr i8, ptr %1251, i64 %1273
  %1275 = load <8 x double>, ptr %1274, align 8, !noalias !19
  %1276 = fmul <8 x double> %1275, zeroinitializer
  %1277 = fadd <8 x double> %1266, %1276
  %1278 = shl i64 %1263, 6
  %1279 = getelementptr i8, ptr %1252, i64 %1278
  %1280 = load <8 x double>, ptr %1279, align 8, !noalias !19
  %1281 = fmul <8 x double> %1280, zeroinitializer
  %1282 = fadd <8 x double> %1265, %1281
  %1283 = shl i64 %1263, 6
  %1284 = getelementptr i8, ptr %1253, i64 %1283
  %1285 = load <8 x double>, ptr %1284, align 8, !noalias !19
  %1286 = fmul <8 x double> %1285, zeroinitializer
  %1287 = fadd <8 x double> %1264, %1286
  %1288 = add nsw i64 %1263, 4
  %1289 = icmp slt i64 %1288, %1250
  br i1 %1289, label %1262, label %1255, !llvm.loop !54

1290:                                             ; preds = %1255, %1290
  %1291 = phi i64 [ %1298, %1290 ], [ %1260, %1255 ]
  %1292 = phi <8 x double> [ %1297, %1290 ], [ %1256, %1255 ]
  %1293 = shl nsw i64 %1291, 6
  %1294 = getelementptr inbounds i8, ptr %1246, i64 %1293
  %1295 = load <8 x double>, ptr %1294, align 8, !noalias !19
  %1296 = fmul <8 x double> %1295, zeroinitializer
  %1297 = fadd <8 x double> %1292, %1296
  %1298 = add nsw i64 %1291, 1
  %1299 = icmp eq i64 %1298, %1249
  br i1 %1299, label %1300, label %1290, !llvm.loop !55

1300:                                             ; preds = %1290, %1255
  %1301 = phi <8 x double> [ %1256, %1255 ], [ %1297, %1290 ]
  %1302 = fadd <8 x double> %1257, %1301
  %1303 = fadd <8 x double> %1258, %1259
  %1304 = fadd <8 x double> %1303, %1302
  %1305 = fadd <8 x double> %1247, %1304
  %1306 = getelementptr inbounds i8, ptr %1243, i64 48
  %1307 = load i64, ptr %1306, align 8, !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %7, i8 0, i64 512, i1 false), !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %8, i8 0, i64 512, i1 false), !noalias !19
  %1308 = icmp eq i64 %1307, 0
  br i1 %1308, label %1372, label %1309

1309:                                             ; preds = %1300
  %1310 = icmp slt i64 %1245, %1307
  br i1 %1310, label %1312, label %1311

1311:                                             ; preds = %1316, %1309
  br label %1363

1312:                                             ; preds = %1309
  %1313 = load ptr, ptr %22, align 8, !noalias !19
  %1314 = load ptr, ptr %116, align 8, !noalias !19
  %1315 = load ptr, ptr %67, align 8, !noalias !19
  br label %1316

1316:                                             ; preds = %1312, %1316
  %1317 = phi i64 [ %1245, %1312 ], [ %1348, %1316 ]
  %1318 = shl nsw i64 %1317, 6
  %1319 = getelementptr inbounds i8, ptr %1313, i64 %1318
  %1320 = load <8 x double>, ptr %1319, align 8, !noalias !19
  %1321 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1320)
  %1322 = getelementptr inbounds i8, ptr %1246, i64 %1318
  %1323 = load <8 x double>, ptr %1322, align 8, !noalias !19
  %1324 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1323)
  %1325 = fcmp ogt <8 x double> %1321, %1324
  %1326 = select <8 x i1> %1325, <8 x double> %1321, <8 x double> %1324
  %1327 = getelementptr inbounds i8, ptr %1314, i64 %1318
  %1328 = load <8 x double>, ptr %1327, align 8, !noalias !19
  %1329 = getelementptr inbounds double, ptr %1315, i64 %1317
  %1330 = load double, ptr %1329, align 8, !noalias !19
  %1331 = insertelement <8 x double> poison, double %1330, i64 0
  %1332 = shufflevector <8 x double> %1331, <8 x double> poison, <8 x i32> zeroinitializer
  %1333 = fmul <8 x double> %1326, %1332
  %1334 = fadd <8 x double> %1328, %1333
  %1335 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1334
  %1336 = getelementptr inbounds i8, ptr %1224, i64 %1318
  %1337 = load <8 x double>, ptr %1336, align 8, !noalias !19
  %1338 = fmul <8 x double> %1337, %1335
  %1339 = srem i64 %1317, 8
  %1340 = shl nsw i64 %1339, 6
  %1341 = getelementptr inbounds i8, ptr %7, i64 %1340
  %1342 = load <8 x double>, ptr %1341, align 16, !noalias !19
  %1343 = fmul <8 x double> %1338, %1338
  %1344 = fadd <8 x double> %1342, %1343
  store <8 x double> %1344, ptr %1341, align 16, !noalias !19
  %1345 = getelementptr inbounds i8, ptr %8, i64 %1340
  %1346 = load <8 x double>, ptr %1345, align 16, !noalias !19
  %1347 = fadd <8 x double> %1346, %1343
  store <8 x double> %1347, ptr %1345, align 16, !noalias !19
  %1348 = add nsw i64 %1317, 1
  %1349 = icmp eq i64 %1348, %1307
  br i1 %1349, label %1311, label %1316, !llvm.loop !56

1350:                                             ; preds = %1363
  %1351 = sub nsw i64 %1307, %1245
  %1352 = sitofp i64 %1351 to double
  %1353 = insertelement <8 x double> poison, double %1352, i64 0
  %1354 = shufflevector <8 x double> %1353, <8 x double> poison, <8 x i32> zeroinitializer
  %1355 = fdiv <8 x double> %1369, %1354
  %1356 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1355)
  %1357 = insertelement <8 x double> poison, double %283, i64 0
  %1358 = shufflevector <8 x double> %1357, <8 x double> poison, <8 x i32> zeroinitializer
  %1359 = fcmp olt <8 x double> %1358, %252
  %1360 = fcmp ogt <8 x double> %1356, %1305
  %1361 = select <8 x i1> %1359, <8 x i1> %1360, <8 x i1> zeroinitializer
  %1362 = select <8 x i1> %1361, <8 x double> %1356, <8 x double> %1305
  br label %1372

1363:                                             ; preds = %1311, %1363
  %1364 = phi i64 [ %1370, %1363 ], [ 0, %1311 ]
  %1365 = phi <8 x double> [ %1369, %1363 ], [ zeroinitializer, %1311 ]
  %1366 = shl nuw nsw i64 %1364, 6
  %1367 = getelementptr inbounds i8, ptr %7, i64 %1366
  %1368 = load <8 x double>, ptr %1367, align 16, !noalias !19
  %1369 = fadd <8 x double> %1365, %1368
  %1370 = add nuw nsw i64 %1364, 1
  %1371 = icmp eq i64 %1370, 8
  br i1 %1371, label %1350, label %1363, !llvm.loop !57

1372:                                             ; preds = %1300, %1350
  %1373 = phi <8 x double> [ %1305, %1300 ], [ %1362, %1350 ]
  %1374 = fcmp olt <8 x double> %1373, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1375 = bitcast <8 x i1> %1374 to i8
  %1376 = zext i8 %1375 to i64
  %1377 = xor i64 %1376, -1
  %1378 = and i64 %1219, %1377
  %1379 = and i64 %1378, %1123
  %1380 = and i64 %1123, %1376
  %1381 = icmp eq i64 %1379, 0
  br i1 %1381, label %1625, label %1382

1382:                                             ; preds = %1372
  %1383 = icmp sgt i64 %1222, 0
  br i1 %1383, label %1444, label %1412

1384:                                             ; preds = %1226, %1384
  %1385 = phi i64 [ 0, %1226 ], [ %1410, %1384 ]
  %1386 = load ptr, ptr %83, align 8, !noalias !19
  %1387 = shl nsw i64 %1385, 6
  %1388 = getelementptr inbounds i8, ptr %1386, i64 %1387
  %1389 = load <8 x double>, ptr %1388, align 8, !noalias !19
  %1390 = fmul <8 x double> %1389, <double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05>
  %1391 = add nuw nsw i64 %1385, %1222
  %1392 = shl nsw i64 %1391, 6
  %1393 = getelementptr inbounds i8, ptr %1386, i64 %1392
  %1394 = load <8 x double>, ptr %1393, align 8, !noalias !19
  %1395 = fmul <8 x double> %1394, <double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580>
  %1396 = fsub <8 x double> %1395, %1390
  %1397 = shl i64 %1385, 6
  %1398 = getelementptr i8, ptr %1386, i64 %1227
  %1399 = getelementptr i8, ptr %1398, i64 %1397
  %1400 = load <8 x double>, ptr %1399, align 8, !noalias !19
  %1401 = fmul <8 x double> %1400, <double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555>
  %1402 = fsub <8 x double> %1396, %1401
  %1403 = fdiv <8 x double> %1402, %252
  %1404 = getelementptr inbounds i8, ptr %1223, i64 %1387
  store <8 x double> %1403, ptr %1404, align 8, !noalias !19
  %1405 = load ptr, ptr %111, align 8, !noalias !19
  %1406 = getelementptr inbounds i8, ptr %1405, i64 %1387
  %1407 = load <8 x double>, ptr %1406, align 8, !noalias !19
  %1408 = fadd <8 x double> %1407, %1403
  %1409 = getelementptr inbounds i8, ptr %1224, i64 %1387
  store <8 x double> %1408, ptr %1409, align 8, !noalias !19
  %1410 = add nuw nsw i64 %1385, 1
  %1411 = icmp eq i64 %1410, %1222
  br i1 %1411, label %1228, label %1384, !llvm.loop !58

1412:                                             ; preds = %1444, %1382
  %1413 = trunc i64 %1379 to i8
  %1414 = bitcast i8 %1413 to <8 x i1>
  %1415 = select <8 x i1> %1414, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1416 = fadd <8 x double> %1128, %1415
  %1417 = load ptr, ptr %118, align 8, !noalias !19
  %1418 = load ptr, ptr %119, align 8, !noalias !19
  %1419 = load ptr, ptr %120, align 8, !noalias !19
  store <8 x double> %236, ptr %1419, align 8, !noalias !19
  %1420 = load ptr, ptr %20, align 8, !noalias !19
  %1421 = getelementptr inbounds i8, ptr %1420, i64 40
  %1422 = load i64, ptr %1421, align 8, !noalias !19
  %1423 = icmp eq i64 %1422, 0
  br i1 %1423, label %1425, label %1424

1424:                                             ; preds = %1412
  call fastcc void @settle(ptr noundef nonnull %20) #12, !noalias !19
  br label %1425

1425:                                             ; preds = %1424, %1412
  %1426 = load i64, ptr %121, align 8, !noalias !19
  %1427 = icmp sgt i64 %1426, 0
  br i1 %1427, label %1428, label %1429

1428:                                             ; preds = %1425
  call fastcc void @sample(ptr noundef nonnull %20) #12, !noalias !19
  br label %1429

1429:                                             ; preds = %1428, %1425
  %1430 = load ptr, ptr %20, align 8, !noalias !19
  %1431 = load i64, ptr %1430, align 8, !noalias !19
  %1432 = load ptr, ptr %120, align 8, !noalias !19
  %1433 = load ptr, ptr %122, align 8, !noalias !19
  %1434 = load ptr, ptr %123, align 8, !noalias !19
  %1435 = inttoptr i64 %1431 to ptr
  %1436 = load ptr, ptr %1435, align 8, !noalias !19
  %1437 = call i32 %1436(ptr noundef %1432, ptr noundef %1417, ptr noundef %1433, ptr noundef %1434, ptr noundef %1418) #13, !noalias !19
  %1438 = zext i32 %1437 to i64
  %1439 = and i64 %1379, %1438
  %1440 = trunc i64 %1439 to i8
  %1441 = bitcast i8 %1440 to <8 x i1>
  %1442 = select <8 x i1> %1441, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1212
  %1443 = icmp sgt i64 %1222, 0
  br i1 %1443, label %1613, label %1457

1444:                                             ; preds = %1382, %1444
  %1445 = phi i64 [ %1455, %1444 ], [ 0, %1382 ]
  %1446 = load ptr, ptr %117, align 8, !noalias !19
  %1447 = load ptr, ptr %22, align 8, !noalias !19
  %1448 = shl nsw i64 %1445, 6
  %1449 = getelementptr inbounds i8, ptr %1447, i64 %1448
  %1450 = load <8 x double>, ptr %1449, align 8, !noalias !19
  %1451 = getelementptr inbounds i8, ptr %1224, i64 %1448
  %1452 = load <8 x double>, ptr %1451, align 8, !noalias !19
  %1453 = fadd <8 x double> %1450, %1452
  %1454 = getelementptr inbounds i8, ptr %1446, i64 %1448
  store <8 x double> %1453, ptr %1454, align 8, !noalias !19
  %1455 = add nuw nsw i64 %1445, 1
  %1456 = icmp eq i64 %1455, %1222
  br i1 %1456, label %1412, label %1444, !llvm.loop !59

1457:                                             ; preds = %1613, %1429
  %1458 = load i64, ptr %113, align 8, !noalias !19
  %1459 = sdiv i64 %1458, 8
  %1460 = load ptr, ptr %66, align 8, !noalias !19
  %1461 = getelementptr inbounds i8, ptr %1460, i64 40
  %1462 = load i64, ptr %1461, align 8, !noalias !19
  %1463 = load ptr, ptr %114, align 8, !noalias !19
  %1464 = load ptr, ptr %112, align 8, !noalias !19
  call fastcc void @real_solve(ptr noundef %1463, i64 noundef %1459, ptr noundef %1464, ptr noundef %1224) #12, !noalias !19
  %1465 = icmp sgt i64 %1462, 0
  br i1 %1465, label %1466, label %1471

1466:                                             ; preds = %1457
  %1467 = load ptr, ptr %114, align 8, !noalias !19
  %1468 = load ptr, ptr %112, align 8, !noalias !19
  %1469 = shl nsw i64 %1459, 6
  %1470 = getelementptr inbounds i8, ptr %1224, i64 %1469
  call fastcc void @real_solve_columns(ptr noundef %1467, i64 noundef %1459, ptr noundef %1468, ptr noundef %1470, i64 noundef %1462) #12, !noalias !19
  br label %1471

1471:                                             ; preds = %1457, %1466
  %1472 = load ptr, ptr %20, align 8, !noalias !19
  %1473 = getelementptr inbounds i8, ptr %1472, i64 24
  %1474 = load i64, ptr %1473, align 8, !noalias !19
  %1475 = load ptr, ptr %115, align 8, !noalias !19
  call fastcc void @norm_to(ptr noundef nonnull %10, ptr noundef %1224, ptr noundef %1475, ptr noundef nonnull %22, i64 noundef %1474) #12, !noalias !19
  %1476 = load <8 x double>, ptr %10, align 16, !noalias !19
  %1477 = getelementptr inbounds i8, ptr %1472, i64 8
  %1478 = load i64, ptr %1477, align 8, !noalias !19
  %1479 = add nsw i64 %1478, -3
  %1480 = getelementptr i8, ptr %1475, i64 64
  %1481 = getelementptr i8, ptr %1475, i64 128
  %1482 = getelementptr i8, ptr %1475, i64 192
  %1483 = icmp slt i64 %1474, %1479
  br i1 %1483, label %1491, label %1484

1484:                                             ; preds = %1491, %1471
  %1485 = phi <8 x double> [ zeroinitializer, %1471 ], [ %1501, %1491 ]
  %1486 = phi <8 x double> [ zeroinitializer, %1471 ], [ %1506, %1491 ]
  %1487 = phi <8 x double> [ zeroinitializer, %1471 ], [ %1511, %1491 ]
  %1488 = phi <8 x double> [ zeroinitializer, %1471 ], [ %1516, %1491 ]
  %1489 = phi i64 [ %1474, %1471 ], [ %1517, %1491 ]
  %1490 = icmp slt i64 %1489, %1478
  br i1 %1490, label %1519, label %1529

1491:                                             ; preds = %1471, %1491
  %1492 = phi i64 [ %1517, %1491 ], [ %1474, %1471 ]
  %1493 = phi <8 x double> [ %1516, %1491 ], [ zeroinitializer, %1471 ]
  %1494 = phi <8 x double> [ %1511, %1491 ], [ zeroinitializer, %1471 ]
  %1495 = phi <8 x double> [ %1506, %1491 ], [ zeroinitializer, %1471 ]
  %1496 = phi <8 x double> [ %1501, %1491 ], [ zeroinitializer, %1471 ]
  %1497 = shl nsw i64 %1492, 6
  %1498 = getelementptr inbounds i8, ptr %1475, i64 %1497
  %1499 = load <8 x double>, ptr %1498, align 8, !noalias !19
  %1500 = fmul <8 x double> %1499, zeroinitializer
  %1501 = fadd <8 x double> %1496, %1500
  %1502 = shl i64 %1492, 6
  %1503 = getelementptr i8, ptr %1480, i64 %1502
  %1504 = load <8 x double>, ptr %1503, align 8, !noalias !19
  %1505 = fmul <8 x double> %1504, zeroinitializer
  %1506 = fadd <8 x double> %1495, %1505
  %1507 = shl i64 %1492, 6
  %1508 = getelementptr i8, ptr %1481, i64 %1507
  %1509 = load <8 x double>, ptr %1508, align 8, !noalias !19
  %1510 = fmul <8 x double> %1509, zeroinitializer
  %1511 = fadd <8 x double> %1494, %1510
  %1512 = shl i64 %1492, 6
  %1513 = getelementptr i8, ptr %1482, i64 %1512
  %1514 = load <8 x double>, ptr %1513, align 8, !noalias !19
  %1515 = fmul <8 x double> %1514, zeroinitializer
  %1516 = fadd <8 x double> %1493, %1515
  %1517 = add nsw i64 %1492, 4
  %1518 = icmp slt i64 %1517, %1479
  br i1 %1518, label %1491, label %1484, !llvm.loop !54

1519:                                             ; preds = %1484, %1519
  %1520 = phi i64 [ %1527, %1519 ], [ %1489, %1484 ]
  %1521 = phi <8 x double> [ %1526, %1519 ], [ %1485, %1484 ]
  %1522 = shl nsw i64 %1520, 6
  %1523 = getelementptr inbounds i8, ptr %1475, i64 %1522
  %1524 = load <8 x double>, ptr %1523, align 8, !noalias !19
  %1525 = fmul <8 x double> %1524, zeroinitializer
  %1526 = fadd <8 x double> %1521, %1525
  %1527 = add nsw i64 %1520, 1
  %1528 = icmp eq i64 %1527, %1478
  br i1 %1528, label %1529, label %1519, !llvm.loop !55

1529:                                             ; preds = %1519, %1484
  %1530 = phi <8 x double> [ %1485, %1484 ], [ %1526, %1519 ]
  %1531 = fadd <8 x double> %1486, %1530
  %1532 = fadd <8 x double> %1487, %1488
  %1533 = fadd <8 x double> %1532, %1531
  %1534 = fadd <8 x double> %1476, %1533
  %1535 = getelementptr inbounds i8, ptr %1472, i64 48
  %1536 = load i64, ptr %1535, align 8, !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %5, i8 0, i64 512, i1 false), !noalias !19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %6, i8 0, i64 512, i1 false), !noalias !19
  %1537 = icmp eq i64 %1536, 0
  br i1 %1537, label %1601, label %1538

1538:                                             ; preds = %1529
  %1539 = icmp slt i64 %1474, %1536
  br i1 %1539, label %1541, label %1540

1540:                                             ; preds = %1545, %1538
  br label %1592

1541:                                             ; preds = %1538
  %1542 = load ptr, ptr %22, align 8, !noalias !19
  %1543 = load ptr, ptr %124, align 8, !noalias !19
  %1544 = load ptr, ptr %67, align 8, !noalias !19
  br label %1545

1545:                                             ; preds = %1541, %1545
  %1546 = phi i64 [ %1474, %1541 ], [ %1577, %1545 ]
  %1547 = shl nsw i64 %1546, 6
  %1548 = getelementptr inbounds i8, ptr %1542, i64 %1547
  %1549 = load <8 x double>, ptr %1548, align 8, !noalias !19
  %1550 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1549)
  %1551 = getelementptr inbounds i8, ptr %1475, i64 %1547
  %1552 = load <8 x double>, ptr %1551, align 8, !noalias !19
  %1553 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1552)
  %1554 = fcmp ogt <8 x double> %1550, %1553
  %1555 = select <8 x i1> %1554, <8 x double> %1550, <8 x double> %1553
  %1556 = getelementptr inbounds i8, ptr %1543, i64 %1547
  %1557 = load <8 x double>, ptr %1556, align 8, !noalias !19
  %1558 = getelementptr inbounds double, ptr %1544, i64 %1546
  %1559 = load double, ptr %1558, align 8, !noalias !19
  %1560 = insertelement <8 x double> poison, double %1559, i64 0
  %1561 = shufflevector <8 x double> %1560, <8 x double> poison, <8 x i32> zeroinitializer
  %1562 = fmul <8 x double> %1555, %1561
  %1563 = fadd <8 x double> %1557, %1562
  %1564 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1563
  %1565 = getelementptr inbounds i8, ptr %1224, i64 %1547
  %1566 = load <8 x double>, ptr %1565, align 8, !noalias !19
  %1567 = fmul <8 x double> %1566, %1564
  %1568 = srem i64 %1546, 8
  %1569 = shl nsw i64 %1568, 6
  %1570 = getelementptr inbounds i8, ptr %5, i64 %1569
  %1571 = load <8 x double>, ptr %1570, align 16, !noalias !19
  %1572 = fmul <8 x double> %1567, %1567
  %1573 = fadd <8 x double> %1571, %1572
  store <8 x double> %1573, ptr %1570, align 16, !noalias !19
  %1574 = getelementptr inbounds i8, ptr %6, i64 %1569
  %1575 = load <8 x double>, ptr %1574, align 16, !noalias !19
  %1576 = fadd <8 x double> %1575, %1572
  store <8 x double> %1576, ptr %1574, align 16, !noalias !19
  %1577 = add nsw i64 %1546, 1
  %1578 = icmp eq i64 %1577, %1536
  br i1 %1578, label %1540, label %1545, !llvm.loop !56

1579:                                             ; preds = %1592
  %1580 = sub nsw i64 %1536, %1474
  %1581 = sitofp i64 %1580 to double
  %1582 = insertelement <8 x double> poison, double %1581, i64 0
  %1583 = shufflevector <8 x double> %1582, <8 x double> poison, <8 x i32> zeroinitializer
  %1584 = fdiv <8 x double> %1598, %1583
  %1585 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1584)
  %1586 = insertelement <8 x double> poison, double %283, i64 0
  %1587 = shufflevector <8 x double> %1586, <8 x double> poison, <8 x i32> zeroinitializer
  %1588 = fcmp olt <8 x double> %1587, %252
  %1589 = fcmp ogt <8 x double> %1585, %1534
  %1590 = select <8 x i1> %1588, <8 x i1> %1589, <8 x i1> zeroinitializer
  %1591 = select <8 x i1> %1590, <8 x double> %1585, <8 x double> %1534
  br label %1601

1592:                                             ; preds = %1540, %1592
  %1593 = phi i64 [ %1599, %1592 ], [ 0, %1540 ]
  %1594 = phi <8 x double> [ %1598, %1592 ], [ zeroinitializer, %1540 ]
  %1595 = shl nuw nsw i64 %1593, 6
  %1596 = getelementptr inbounds i8, ptr %5, i64 %1595
  %1597 = load <8 x double>, ptr %1596, align 16, !noalias !19
  %1598 = fadd <8 x double> %1594, %1597
  %1599 = add nuw nsw i64 %1593, 1
  %1600 = icmp eq i64 %1599, 8
  br i1 %1600, label %1579, label %1592, !llvm.loop !57

1601:                                             ; preds = %1529, %1579
  %1602 = phi <8 x double> [ %1534, %1529 ], [ %1591, %1579 ]
  %1603 = xor i64 %1438, -1
  %1604 = and i64 %1379, %1603
  %1605 = fcmp olt <8 x double> %1602, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1606 = bitcast <8 x i1> %1605 to i8
  %1607 = zext i8 %1606 to i64
  %1608 = and i64 %1604, %1607
  %1609 = or i64 %1608, %1380
  %1610 = trunc i64 %1604 to i8
  %1611 = bitcast i8 %1610 to <8 x i1>
  %1612 = select <8 x i1> %1611, <8 x double> %1602, <8 x double> %1373
  br label %1625

1613:                                             ; preds = %1429, %1613
  %1614 = phi i64 [ %1623, %1613 ], [ 0, %1429 ]
  %1615 = load ptr, ptr %119, align 8, !noalias !19
  %1616 = shl nsw i64 %1614, 6
  %1617 = getelementptr inbounds i8, ptr %1615, i64 %1616
  %1618 = load <8 x double>, ptr %1617, align 8, !noalias !19
  %1619 = getelementptr inbounds i8, ptr %1223, i64 %1616
  %1620 = load <8 x double>, ptr %1619, align 8, !noalias !19
  %1621 = fadd <8 x double> %1618, %1620
  %1622 = getelementptr inbounds i8, ptr %1224, i64 %1616
  store <8 x double> %1621, ptr %1622, align 8, !noalias !19
  %1623 = add nuw nsw i64 %1614, 1
  %1624 = icmp eq i64 %1623, %1222
  br i1 %1624, label %1457, label %1613, !llvm.loop !60

1625:                                             ; preds = %1372, %1601
  %1626 = phi i64 [ %1380, %1372 ], [ %1609, %1601 ]
  %1627 = phi <8 x double> [ %1128, %1372 ], [ %1416, %1601 ]
  %1628 = phi <8 x double> [ %1212, %1372 ], [ %1442, %1601 ]
  %1629 = phi <8 x double> [ %1373, %1372 ], [ %1612, %1601 ]
  %1630 = fcmp olt <8 x double> %1629, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1631 = select <8 x i1> %1630, <8 x double> <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>, <8 x double> %1629
  %1632 = load ptr, ptr %75, align 8, !noalias !19
  %1633 = getelementptr inbounds i8, ptr %1632, i64 192
  %1634 = load <8 x double>, ptr %1633, align 8, !noalias !19
  %1635 = fadd <8 x double> %1125, <double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01>
  %1636 = fdiv <8 x double> <double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667>, %1635
  %1637 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1631)
  %1638 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1637)
  %1639 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1638
  %1640 = fmul <8 x double> %1636, %1639
  %1641 = fcmp ogt <8 x double> %1640, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1642 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1629)
  %1643 = fcmp one <8 x double> %1642, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1644 = select <8 x i1> %1641, <8 x double> %1640, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1645 = select <8 x i1> %1643, <8 x double> %1644, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1646 = fmul <8 x double> %1645, %252
  %1647 = getelementptr inbounds i8, ptr %1632, i64 128
  %1648 = load <8 x double>, ptr %1647, align 8, !noalias !19
  %1649 = fdiv <8 x double> %252, %1648
  %1650 = fdiv <8 x double> %1634, %1631
  %1651 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1650)
  %1652 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1651)
  %1653 = fmul <8 x double> %1649, %1652
  %1654 = fcmp ogt <8 x double> %1634, zeroinitializer
  %1655 = fcmp olt <8 x double> %1653, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1656 = select <8 x i1> %1654, <8 x i1> %1655, <8 x i1> zeroinitializer
  %1657 = select <8 x i1> %1656, <8 x double> %1653, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1658 = fmul <8 x double> %1640, %1657
  %1659 = fcmp olt <8 x double> %1658, <double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01>
  %1660 = bitcast <8 x double> %1658 to <8 x i64>
  %1661 = select <8 x i1> %1659, <8 x i64> %1660, <8 x i64> <i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520>
  %1662 = bitcast <8 x i64> %1661 to <8 x double>
  %1663 = fcmp ule <8 x double> %1662, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1664 = fcmp uge <8 x double> %1662, <double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00>
  %1665 = or <8 x i1> %1663, %1664
  %1666 = select <8 x i1> %1665, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %1131
  %1667 = load <8 x double>, ptr %1632, align 8, !noalias !19
  %1668 = fcmp ogt <8 x double> %1662, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1669 = bitcast <8 x i64> %1661 to <8 x double>
  %1670 = select <8 x i1> %1668, <8 x double> %1669, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1671 = fmul <8 x double> %1670, %252
  %1672 = trunc nuw i64 %1626 to i8
  %1673 = bitcast i8 %1672 to <8 x i1>
  %1674 = trunc i64 %1123 to i8
  %1675 = bitcast i8 %1674 to <8 x i1>
  %1676 = select <8 x i1> %1666, <8 x double> %1671, <8 x double> %1667
  %1677 = select <8 x i1> %1673, <8 x double> %1676, <8 x double> %1646
  %1678 = select <8 x i1> %1675, <8 x double> %1677, <8 x double> %1211
  %1679 = xor i64 %1626, -1
  %1680 = and i64 %1123, %1679
  %1681 = load ptr, ptr %66, align 8, !noalias !19
  %1682 = getelementptr inbounds i8, ptr %1681, i64 32
  %1683 = load i64, ptr %1682, align 8, !noalias !19
  %1684 = or i64 %1683, %1680
  store i64 %1684, ptr %1682, align 8, !noalias !19
  %1685 = load ptr, ptr %66, align 8, !noalias !19
  %1686 = getelementptr inbounds i8, ptr %1685, i64 8
  %1687 = load i64, ptr %1686, align 8, !noalias !19
  %1688 = xor i64 %1680, -1
  %1689 = and i64 %1687, %1688
  %1690 = getelementptr inbounds i8, ptr %1685, i64 16
  %1691 = load i64, ptr %1690, align 8, !noalias !19
  %1692 = xor i64 %1691, -1
  %1693 = and i64 %1680, %1692
  %1694 = or disjoint i64 %1693, %1689
  store i64 %1694, ptr %1686, align 8, !noalias !19
  br label %1711

1695:                                             ; preds = %1216, %1695
  %1696 = phi i64 [ 0, %1216 ], [ %1709, %1695 ]
  %1697 = load ptr, ptr %108, align 8, !noalias !19
  %1698 = load ptr, ptr %22, align 8, !noalias !19
  %1699 = shl nsw i64 %1696, 6
  %1700 = getelementptr inbounds i8, ptr %1698, i64 %1699
  %1701 = load <8 x double>, ptr %1700, align 8, !noalias !19
  %1702 = load ptr, ptr %83, align 8, !noalias !19
  %1703 = shl i64 %1696, 6
  %1704 = getelementptr i8, ptr %1702, i64 %1217
  %1705 = getelementptr i8, ptr %1704, i64 %1703
  %1706 = load <8 x double>, ptr %1705, align 8, !noalias !19
  %1707 = fadd <8 x double> %1701, %1706
  %1708 = getelementptr inbounds i8, ptr %1697, i64 %1699
  store <8 x double> %1707, ptr %1708, align 8, !noalias !19
  %1709 = add nuw nsw i64 %1696, 1
  %1710 = icmp eq i64 %1709, %288
  br i1 %1710, label %1218, label %1695, !llvm.loop !61

1711:                                             ; preds = %1625, %1210, %458, %360
  %1712 = phi i64 [ %146, %360 ], [ %146, %458 ], [ %1123, %1210 ], [ %1123, %1625 ]
  %1713 = phi i64 [ %147, %360 ], [ %147, %458 ], [ %1124, %1210 ], [ %1124, %1625 ]
  %1714 = phi <8 x double> [ %148, %360 ], [ %148, %458 ], [ %1125, %1210 ], [ %1125, %1625 ]
  %1715 = phi <8 x double> [ %149, %360 ], [ %149, %458 ], [ %1126, %1210 ], [ %1126, %1625 ]
  %1716 = phi <8 x double> [ %150, %360 ], [ %150, %458 ], [ %1127, %1210 ], [ %1127, %1625 ]
  %1717 = phi i8 [ 0, %360 ], [ 0, %458 ], [ %1132, %1210 ], [ %1132, %1625 ]
  %1718 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %360 ], [ %460, %458 ], [ %1212, %1210 ], [ %1628, %1625 ]
  %1719 = phi <8 x double> [ zeroinitializer, %360 ], [ zeroinitializer, %458 ], [ zeroinitializer, %1210 ], [ %1629, %1625 ]
  %1720 = phi <8 x double> [ %241, %360 ], [ %459, %458 ], [ %1211, %1210 ], [ %1678, %1625 ]
  %1721 = phi <8 x double> [ zeroinitializer, %360 ], [ zeroinitializer, %458 ], [ %1128, %1210 ], [ %1627, %1625 ]
  %1722 = phi i64 [ 0, %360 ], [ 0, %458 ], [ 0, %1210 ], [ %1626, %1625 ]
  %1723 = zext i8 %1717 to i64
  %1724 = load ptr, ptr %21, align 8, !noalias !62
  %1725 = getelementptr inbounds i8, ptr %1724, i64 72
  %1726 = load ptr, ptr %1725, align 8
  store <8 x i64> %251, ptr %1726, align 8
  %1727 = load ptr, ptr %125, align 8, !noalias !62
  %1728 = load <8 x double>, ptr %1727, align 8
  %1729 = fadd <8 x double> %1721, %1728
  store <8 x double> %1729, ptr %1727, align 8
  %1730 = icmp ne i64 %1722, 0
  %1731 = select i1 %52, i1 %1730, i1 false
  br i1 %1731, label %1732, label %1735

1732:                                             ; preds = %1711
  store <8 x double> %248, ptr %13, align 16
  %1733 = load ptr, ptr %126, align 8
  %1734 = call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef nonnull %13, ptr noundef %1733, i64 noundef %1722, i32 noundef 1) #12
  br label %1735

1735:                                             ; preds = %1732, %1711
  %1736 = phi i64 [ %1734, %1732 ], [ 0, %1711 ]
  %1737 = xor i64 %1736, -1
  %1738 = and i64 %1722, %1737
  %1739 = load ptr, ptr %20, align 8
  %1740 = getelementptr inbounds i8, ptr %1739, i64 8
  %1741 = load i64, ptr %1740, align 8
  %1742 = load i64, ptr %127, align 8
  %1743 = load ptr, ptr %128, align 8
  %1744 = trunc nuw i64 %1738 to i8
  %1745 = load ptr, ptr %129, align 8
  %1746 = load ptr, ptr %130, align 8
  %1747 = load ptr, ptr %131, align 8
  br label %1771

1748:                                             ; preds = %1771
  %1749 = bitcast i8 %1744 to <8 x i1>
  %1750 = icmp sgt i64 %1741, 0
  br i1 %1750, label %1751, label %1840

1751:                                             ; preds = %1748
  %1752 = load <2 x double>, ptr %3, align 16
  %1753 = shufflevector <2 x double> %1752, <2 x double> poison, <8 x i32> zeroinitializer
  %1754 = load <2 x double>, ptr %132, align 8
  %1755 = shufflevector <2 x double> %1754, <2 x double> poison, <8 x i32> zeroinitializer
  %1756 = load double, ptr %133, align 16
  %1757 = insertelement <8 x double> poison, double %1756, i64 0
  %1758 = shufflevector <8 x double> %1757, <8 x double> poison, <8 x i32> zeroinitializer
  %1759 = shl i64 %1741, 7
  %1760 = getelementptr i8, ptr %1743, i64 %1759
  %1761 = load <2 x double>, ptr %4, align 16
  %1762 = shufflevector <2 x double> %1761, <2 x double> poison, <8 x i32> zeroinitializer
  %1763 = load <2 x double>, ptr %134, align 8
  %1764 = shufflevector <2 x double> %1763, <2 x double> poison, <8 x i32> zeroinitializer
  %1765 = load double, ptr %135, align 16
  %1766 = insertelement <8 x double> poison, double %1765, i64 0
  %1767 = shufflevector <8 x double> %1766, <8 x double> poison, <8 x i32> zeroinitializer
  %1768 = getelementptr inbounds double, ptr %1745, i64 %1742
  %1769 = shl nsw i64 %1742, 4
  %1770 = getelementptr inbounds i8, ptr %1745, i64 %1769
  br label %1782

1771:                                             ; preds = %1735, %1771
  %1772 = phi i64 [ 0, %1735 ], [ %1780, %1771 ]
  %1773 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1772
  %1774 = getelementptr inbounds i8, ptr %1773, i64 8
  %1775 = load double, ptr %1774, align 8
  %1776 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %1772
  store double %1775, ptr %1776, align 8
  %1777 = getelementptr inbounds i8, ptr %1773, i64 16
  %1778 = load double, ptr %1777, align 8
  %1779 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %1772
  store double %1778, ptr %1779, align 8
  %1780 = add nuw nsw i64 %1772, 1
  %1781 = icmp eq i64 %1780, 3
  br i1 %1781, label %1748, label %1771, !llvm.loop !63

1782:                                             ; preds = %1751, %1824
  %1783 = phi i64 [ 0, %1751 ], [ %1825, %1824 ]
  %1784 = shl nsw i64 %1783, 6
  %1785 = getelementptr inbounds i8, ptr %1743, i64 %1784
  %1786 = load <8 x double>, ptr %1785, align 8
  %1787 = fmul <8 x double> %1786, %1753
  %1788 = add nuw nsw i64 %1783, %1741
  %1789 = shl nsw i64 %1788, 6
  %1790 = getelementptr inbounds i8, ptr %1743, i64 %1789
  %1791 = load <8 x double>, ptr %1790, align 8
  %1792 = fmul <8 x double> %1791, %1755
  %1793 = fadd <8 x double> %1787, %1792
  %1794 = shl i64 %1783, 6
  %1795 = getelementptr i8, ptr %1760, i64 %1794
  %1796 = load <8 x double>, ptr %1795, align 8
  %1797 = fmul <8 x double> %1796, %1758
  %1798 = fadd <8 x double> %1793, %1797
  %1799 = fmul <8 x double> %1786, %1762
  %1800 = fmul <8 x double> %1791, %1764
  %1801 = fadd <8 x double> %1799, %1800
  %1802 = fmul <8 x double> %1796, %1767
  %1803 = fadd <8 x double> %1801, %1802
  %1804 = load ptr, ptr %136, align 8
  %1805 = getelementptr inbounds i8, ptr %1804, i64 %1784
  %1806 = load <8 x double>, ptr %1805, align 8
  %1807 = load ptr, ptr %22, align 8
  %1808 = getelementptr inbounds i8, ptr %1807, i64 %1784
  %1809 = load <8 x double>, ptr %1808, align 8
  %1810 = fsub <8 x double> %1806, %1809
  %1811 = getelementptr inbounds i8, ptr %1745, i64 %1784
  store <8 x double> %1810, ptr %1811, align 8
  %1812 = fneg <8 x double> %1798
  %1813 = fsub <8 x double> %1812, %1803
  %1814 = getelementptr inbounds i8, ptr %1768, i64 %1784
  store <8 x double> %1813, ptr %1814, align 8
  %1815 = fneg <8 x double> %1803
  %1816 = getelementptr inbounds i8, ptr %1770, i64 %1784
  store <8 x double> %1815, ptr %1816, align 8
  %1817 = load ptr, ptr %22, align 8
  %1818 = getelementptr inbounds i8, ptr %1817, i64 %1784
  %1819 = load <8 x i64>, ptr %1818, align 8
  %1820 = getelementptr inbounds i8, ptr %1746, i64 %1784
  %1821 = load <8 x i64>, ptr %1820, align 8
  %1822 = select <8 x i1> %1749, <8 x i64> %1819, <8 x i64> %1821
  store <8 x i64> %1822, ptr %1820, align 8
  %1823 = getelementptr i8, ptr %1745, i64 %1784
  br label %1827

1824:                                             ; preds = %1827
  %1825 = add nuw nsw i64 %1783, 1
  %1826 = icmp eq i64 %1825, %1741
  br i1 %1826, label %1840, label %1782, !llvm.loop !64

1827:                                             ; preds = %1782, %1827
  %1828 = phi i64 [ 0, %1782 ], [ %1829, %1827 ]
  %1829 = add nuw nsw i64 %1828, 1
  %1830 = mul nuw nsw i64 %1741, %1829
  %1831 = add nuw nsw i64 %1830, %1783
  %1832 = mul nsw i64 %1742, %1828
  %1833 = getelementptr double, ptr %1823, i64 %1832
  %1834 = load <8 x i64>, ptr %1833, align 8
  %1835 = shl nsw i64 %1831, 6
  %1836 = getelementptr inbounds i8, ptr %1746, i64 %1835
  %1837 = load <8 x i64>, ptr %1836, align 8
  %1838 = select <8 x i1> %1749, <8 x i64> %1834, <8 x i64> %1837
  store <8 x i64> %1838, ptr %1836, align 8
  %1839 = icmp eq i64 %1829, 3
  br i1 %1839, label %1824, label %1827, !llvm.loop !65

1840:                                             ; preds = %1824, %1748
  %1841 = fcmp olt <8 x double> %1719, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1842 = bitcast <8 x double> %1719 to <8 x i64>
  %1843 = select <8 x i1> %1841, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>, <8 x i64> %1842
  %1844 = getelementptr inbounds i8, ptr %1747, i64 64
  %1845 = load <8 x i64>, ptr %1844, align 8
  %1846 = select <8 x i1> %1749, <8 x i64> %251, <8 x i64> %1845
  store <8 x i64> %1846, ptr %1844, align 8
  %1847 = getelementptr inbounds i8, ptr %1747, i64 128
  %1848 = load <8 x i64>, ptr %1847, align 8
  %1849 = select <8 x i1> %1749, <8 x i64> %251, <8 x i64> %1848
  store <8 x i64> %1849, ptr %1847, align 8
  %1850 = getelementptr inbounds i8, ptr %1747, i64 192
  %1851 = load <8 x i64>, ptr %1850, align 8
  %1852 = select <8 x i1> %1749, <8 x i64> %1843, <8 x i64> %1851
  store <8 x i64> %1852, ptr %1850, align 8
  %1853 = load ptr, ptr %66, align 8
  %1854 = getelementptr inbounds i8, ptr %1853, i64 8
  %1855 = load i64, ptr %1854, align 8
  %1856 = xor i64 %1738, -1
  %1857 = and i64 %1855, %1856
  %1858 = and i64 %1738, %1723
  %1859 = or disjoint i64 %1857, %1858
  store i64 %1859, ptr %1854, align 8
  %1860 = load ptr, ptr %66, align 8
  %1861 = getelementptr inbounds i8, ptr %1860, i64 16
  %1862 = load i64, ptr %1861, align 8
  %1863 = and i64 %1862, %1856
  store i64 %1863, ptr %1861, align 8
  %1864 = load ptr, ptr %66, align 8
  %1865 = getelementptr inbounds i8, ptr %1864, i64 32
  %1866 = load i64, ptr %1865, align 8
  %1867 = and i64 %1866, %1856
  store i64 %1867, ptr %1865, align 8
  %1868 = icmp ne i64 %1738, 0
  %1869 = select i1 %53, i1 %1868, i1 false
  br i1 %1869, label %1870, label %1874

1870:                                             ; preds = %1840
  %1871 = call fastcc i64 @clear_lanes(ptr noundef %0) #12
  %1872 = xor i64 %1871, -1
  %1873 = and i64 %1738, %1872
  br label %1874

1874:                                             ; preds = %1840, %1870
  %1875 = phi i64 [ %1873, %1870 ], [ 0, %1840 ]
  store i64 0, ptr %18, align 8
  %1876 = load ptr, ptr %137, align 8
  %1877 = load <8 x double>, ptr %1876, align 8
  %1878 = fcmp olt <8 x double> %1877, %248
  %1879 = bitcast <8 x i1> %1878 to i8
  %1880 = zext i8 %1879 to i64
  %1881 = and i64 %1738, %1880
  %1882 = or i64 %1881, %1875
  %1883 = icmp eq i64 %1882, 0
  br i1 %1883, label %1918, label %1884

1884:                                             ; preds = %1874
  store <8 x double> %248, ptr %13, align 16
  %1885 = icmp eq i64 %1875, 0
  br i1 %1885, label %1888, label %1886

1886:                                             ; preds = %1884
  %1887 = call fastcc i64 @look_for_events(ptr noundef %0, ptr noundef nonnull %12, i64 noundef %1875, ptr noundef nonnull %13, ptr noundef nonnull %15, ptr noundef nonnull %17, ptr noundef nonnull %14, ptr noundef nonnull %18) #12
  br label %1888

1888:                                             ; preds = %1886, %1884
  %1889 = phi i64 [ %1887, %1886 ], [ 0, %1884 ]
  %1890 = load i64, ptr %18, align 8
  %1891 = xor i64 %1890, -1
  %1892 = and i64 %1882, %1891
  %1893 = icmp eq i64 %1889, 0
  %1894 = select i1 %1893, ptr null, ptr %14
  %1895 = call fastcc i64 @write_within(ptr noundef %0, ptr noundef nonnull %12, i64 noundef %1892, ptr noundef nonnull %13, ptr noundef %1894) #12
  %1896 = load <8 x double>, ptr %13, align 16
  br i1 %1893, label %1902, label %1897

1897:                                             ; preds = %1888
  %1898 = xor i64 %1895, -1
  %1899 = and i64 %1889, %1898
  %1900 = call fastcc i64 @end_within(ptr noundef %0, ptr noundef nonnull %12, i64 noundef %1899, ptr noundef nonnull %13, ptr noundef nonnull %14) #12
  %1901 = or i64 %1900, %1895
  br label %1902

1902:                                             ; preds = %1897, %1888
  %1903 = phi i64 [ %1901, %1897 ], [ %1895, %1888 ]
  %1904 = icmp ne i64 %1903, 0
  %1905 = select i1 %53, i1 %1904, i1 false
  br i1 %1905, label %1906, label %1911

1906:                                             ; preds = %1902
  call fastcc void @retire(ptr noundef %0, i64 noundef %1903, i64 noundef 6) #12
  %1907 = xor i64 %1903, -1
  %1908 = load i64, ptr %16, align 8
  %1909 = and i64 %1908, %1907
  store i64 %1909, ptr %16, align 8
  %1910 = and i64 %1889, %1907
  br label %1911

1911:                                             ; preds = %1906, %1902
  %1912 = phi i32 [ 1, %1906 ], [ %203, %1902 ]
  %1913 = phi i64 [ %1910, %1906 ], [ %1889, %1902 ]
  %1914 = or i64 %1903, %1736
  %1915 = or i64 %1903, %1890
  %1916 = xor i64 %1915, -1
  %1917 = and i64 %1738, %1916
  br label %1918

1918:                                             ; preds = %1911, %1874
  %1919 = phi <8 x double> [ %248, %1874 ], [ %1896, %1911 ]
  %1920 = phi i64 [ 0, %1874 ], [ %1890, %1911 ]
  %1921 = phi i64 [ %1736, %1874 ], [ %1914, %1911 ]
  %1922 = phi i32 [ %203, %1874 ], [ %1912, %1911 ]
  %1923 = phi i64 [ %1738, %1874 ], [ %1917, %1911 ]
  %1924 = phi i64 [ 0, %1874 ], [ %1913, %1911 ]
  %1925 = load ptr, ptr %137, align 8
  %1926 = load <8 x double>, ptr %1925, align 8
  %1927 = fcmp oeq <8 x double> %1926, %1919
  %1928 = bitcast <8 x i1> %1927 to i8
  %1929 = zext i8 %1928 to i64
  %1930 = and i64 %1923, %1929
  %1931 = icmp eq i64 %1930, 0
  br i1 %1931, label %1932, label %2065

1932:                                             ; preds = %2065, %1918
  %1933 = trunc nuw i64 %1923 to i8
  %1934 = bitcast i8 %1933 to <8 x i1>
  %1935 = load ptr, ptr %62, align 8
  %1936 = load <8 x double>, ptr %1935, align 8
  %1937 = select <8 x i1> %1934, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1938 = fadd <8 x double> %1937, %1936
  store <8 x double> %1938, ptr %1935, align 8
  %1939 = load ptr, ptr %63, align 8
  %1940 = load <8 x double>, ptr %1939, align 8
  %1941 = xor <8 x i1> %1934, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1942 = and <8 x i1> %234, %1941
  %1943 = select <8 x i1> %1942, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1944 = fadd <8 x double> %1943, %1940
  store <8 x double> %1944, ptr %1939, align 8
  %1945 = xor i64 %1923, -1
  %1946 = and i64 %232, %1945
  %1947 = or i64 %1921, %1920
  %1948 = and i64 %1946, %1947
  %1949 = trunc i64 %1921 to i8
  %1950 = bitcast i8 %1949 to <8 x i1>
  %1951 = trunc i64 %1948 to i8
  %1952 = bitcast i8 %1951 to <8 x i1>
  %1953 = load i64, ptr %139, align 8
  %1954 = icmp sgt i64 %1953, 0
  br i1 %1954, label %1955, label %2025

1955:                                             ; preds = %1932
  %1956 = fcmp oge <8 x double> %1719, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1957 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1719)
  %1958 = fcmp one <8 x double> %1957, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1959 = and <8 x i1> %1958, %1956
  %1960 = bitcast <8 x i1> %1959 to i8
  %1961 = zext i8 %1960 to i64
  %1962 = xor i64 %1948, %1946
  %1963 = and i64 %1962, %1961
  %1964 = and i64 %307, %1923
  store <8 x double> %1720, ptr %2, align 16
  br label %1965

1965:                                             ; preds = %1955, %2020
  %1966 = phi i64 [ 0, %1955 ], [ %2021, %2020 ]
  %1967 = shl nuw nsw i64 1, %1966
  %1968 = and i64 %1963, %1967
  %1969 = icmp eq i64 %1968, 0
  br i1 %1969, label %1991, label %1970

1970:                                             ; preds = %1965
  %1971 = extractelement <8 x double> %236, i64 %1966
  %1972 = extractelement <8 x double> %1720, i64 %1966
  %1973 = load i64, ptr %140, align 8
  %1974 = icmp eq i64 %1973, 0
  br i1 %1974, label %2017, label %1975

1975:                                             ; preds = %1970
  %1976 = extractelement <8 x double> %1919, i64 %1966
  %1977 = call fastcc double @knot_after(ptr noundef nonnull %20, double noundef %1971) #12
  %1978 = fsub double %1976, %1971
  %1979 = fmul double %1978, 1.000000e-03
  %1980 = fsub double %1976, %1979
  %1981 = call double @llvm.fabs.f64(double %1976)
  %1982 = fmul double %1981, 0x3D10000000000000
  %1983 = fsub double %1980, %1982
  %1984 = fcmp ogt double %1983, %1977
  br i1 %1984, label %1985, label %2017

1985:                                             ; preds = %1975
  %1986 = call fastcc double @knot_after(ptr noundef nonnull %20, double noundef %1977) #12
  %1987 = fadd double %1971, %1972
  %1988 = fcmp ugt double %1986, %1987
  br i1 %1988, label %1989, label %2017

1989:                                             ; preds = %1985
  %1990 = fsub double %1977, %1971
  br label %2017

1991:                                             ; preds = %1965
  %1992 = and i64 %1964, %1967
  %1993 = icmp eq i64 %1992, 0
  br i1 %1993, label %2020, label %1994

1994:                                             ; preds = %1991
  %1995 = extractelement <8 x double> %1919, i64 %1966
  %1996 = extractelement <8 x double> %1720, i64 %1966
  %1997 = load i64, ptr %141, align 8
  %1998 = icmp eq i64 %1997, 0
  br i1 %1998, label %2017, label %1999

1999:                                             ; preds = %1994
  %2000 = extractelement <8 x double> %236, i64 %1966
  %2001 = call fastcc double @knot_after(ptr noundef nonnull %20, double noundef %2000) #12
  %2002 = fsub double %1995, %2000
  %2003 = fmul double %2002, 1.000000e-03
  %2004 = fsub double %1995, %2003
  %2005 = call double @llvm.fabs.f64(double %1995)
  %2006 = fmul double %2005, 0x3D10000000000000
  %2007 = fsub double %2004, %2006
  %2008 = fcmp ogt double %2007, %2001
  %2009 = fadd double %1995, %2006
  %2010 = fcmp ogt double %2001, %2009
  %2011 = select i1 %2008, i1 true, i1 %2010
  br i1 %2011, label %2017, label %2012

2012:                                             ; preds = %1999
  %2013 = call fastcc double @knot_after(ptr noundef nonnull %20, double noundef %1995) #12
  %2014 = fsub double %2013, %1995
  %2015 = fcmp olt double %2014, %1996
  %2016 = select i1 %2015, double %2014, double %1996
  br label %2017

2017:                                             ; preds = %2012, %1999, %1994, %1989, %1985, %1975, %1970
  %2018 = phi double [ %1972, %1970 ], [ %1990, %1989 ], [ %1972, %1985 ], [ %1972, %1975 ], [ %1996, %1994 ], [ %2016, %2012 ], [ %1996, %1999 ]
  %2019 = getelementptr inbounds [8 x double], ptr %2, i64 0, i64 %1966
  store double %2018, ptr %2019, align 8
  br label %2020

2020:                                             ; preds = %2017, %1991
  %2021 = add nuw nsw i64 %1966, 1
  %2022 = icmp eq i64 %2021, 8
  br i1 %2022, label %2023, label %1965, !llvm.loop !66

2023:                                             ; preds = %2020
  %2024 = load <8 x double>, ptr %2, align 16
  br label %2025

2025:                                             ; preds = %1932, %2023
  %2026 = phi <8 x double> [ %2024, %2023 ], [ %1720, %1932 ]
  %2027 = fcmp oeq <8 x double> %1919, %239
  %2028 = load ptr, ptr %59, align 8
  %2029 = load <8 x double>, ptr %2028, align 8
  %2030 = fcmp ogt <8 x double> %2029, %2026
  %2031 = and <8 x i1> %2027, %1934
  %2032 = select <8 x i1> %2031, <8 x i1> %2030, <8 x i1> zeroinitializer
  %2033 = select <8 x i1> %2032, <8 x double> %2029, <8 x double> %2026
  %2034 = fmul <8 x double> %252, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %2035 = select <8 x i1> %1952, <8 x double> %2034, <8 x double> %2033
  %2036 = select <8 x i1> %1950, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %2037 = bitcast <8 x double> %1718 to <8 x i64>
  %2038 = select <8 x i1> %1952, <8 x i64> %2036, <8 x i64> %2037
  %2039 = load ptr, ptr %142, align 8
  %2040 = trunc i64 %1946 to i8
  %2041 = bitcast i8 %2040 to <8 x i1>
  %2042 = load <8 x i64>, ptr %2039, align 8
  %2043 = select <8 x i1> %2041, <8 x i64> %2038, <8 x i64> %2042
  store <8 x i64> %2043, ptr %2039, align 8
  %2044 = load ptr, ptr %66, align 8
  %2045 = getelementptr inbounds i8, ptr %2044, i64 32
  %2046 = load i64, ptr %2045, align 8
  %2047 = or i64 %2046, %1948
  store i64 %2047, ptr %2045, align 8
  %2048 = load ptr, ptr %66, align 8
  %2049 = getelementptr inbounds i8, ptr %2048, i64 8
  %2050 = load i64, ptr %2049, align 8
  %2051 = xor i64 %1948, -1
  %2052 = and i64 %2050, %2051
  %2053 = getelementptr inbounds i8, ptr %2048, i64 16
  %2054 = load i64, ptr %2053, align 8
  %2055 = xor i64 %2054, -1
  %2056 = and i64 %1948, %2055
  %2057 = or disjoint i64 %2056, %2052
  store i64 %2057, ptr %2049, align 8
  %2058 = load ptr, ptr %131, align 8
  %2059 = getelementptr inbounds i8, ptr %2058, i64 64
  %2060 = load <8 x double>, ptr %2059, align 8
  %2061 = select <8 x i1> %1952, <8 x double> zeroinitializer, <8 x double> %2060
  store <8 x double> %2061, ptr %2059, align 8
  %2062 = load ptr, ptr %59, align 8
  store <8 x double> %2035, ptr %2062, align 8
  %2063 = load ptr, ptr %50, align 8
  %2064 = select <8 x i1> %1934, <8 x double> %1919, <8 x double> %236
  store <8 x double> %2064, ptr %2063, align 8
  br i1 %143, label %2077, label %2075

2065:                                             ; preds = %1918, %2065
  %2066 = phi i64 [ %2073, %2065 ], [ %1930, %1918 ]
  %2067 = load ptr, ptr %138, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %2067, i64 noundef %2066) #12
  %2068 = load ptr, ptr %137, align 8
  %2069 = load <8 x double>, ptr %2068, align 8
  %2070 = fcmp oeq <8 x double> %2069, %1919
  %2071 = bitcast <8 x i1> %2070 to i8
  %2072 = zext i8 %2071 to i64
  %2073 = and i64 %2066, %2072
  %2074 = icmp eq i64 %2073, 0
  br i1 %2074, label %1932, label %2065, !llvm.loop !68

2075:                                             ; preds = %2077, %2025
  %2076 = icmp eq i64 %1924, 0
  br i1 %2076, label %2099, label %2089

2077:                                             ; preds = %2025, %2077
  %2078 = phi i64 [ %2087, %2077 ], [ 0, %2025 ]
  %2079 = load ptr, ptr %22, align 8
  %2080 = load ptr, ptr %144, align 8
  %2081 = shl nsw i64 %2078, 6
  %2082 = getelementptr inbounds i8, ptr %2080, i64 %2081
  %2083 = load <8 x i64>, ptr %2082, align 8
  %2084 = getelementptr inbounds i8, ptr %2079, i64 %2081
  %2085 = load <8 x i64>, ptr %2084, align 8
  %2086 = select <8 x i1> %1934, <8 x i64> %2083, <8 x i64> %2085
  store <8 x i64> %2086, ptr %2084, align 8
  %2087 = add nuw nsw i64 %2078, 1
  %2088 = icmp eq i64 %2087, %26
  br i1 %2088, label %2075, label %2077, !llvm.loop !69

2089:                                             ; preds = %2075
  %2090 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %1924, ptr noundef nonnull %17) #12
  %2091 = icmp ne i32 %1922, 0
  %2092 = icmp ne i64 %2090, %1924
  %2093 = select i1 %2091, i1 true, i1 %2092
  %2094 = zext i1 %2093 to i32
  %2095 = trunc i64 %1924 to i8
  %2096 = bitcast i8 %2095 to <8 x i1>
  %2097 = xor <8 x i1> %2096, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %2098 = and <8 x i1> %2097, %1934
  br label %2099

2099:                                             ; preds = %2089, %2075
  %2100 = phi i32 [ %2094, %2089 ], [ %1922, %2075 ]
  %2101 = phi <8 x i1> [ %2098, %2089 ], [ %1934, %2075 ]
  %2102 = phi i64 [ %2090, %2089 ], [ %204, %2075 ]
  %2103 = bitcast <8 x i1> %2101 to i8
  %2104 = icmp eq i8 %2103, 0
  br i1 %2104, label %2108, label %2105

2105:                                             ; preds = %2099
  %2106 = zext i8 %2103 to i64
  %2107 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %12, i64 noundef %2106) #12
  br label %2108

2108:                                             ; preds = %2099, %2105
  %2109 = phi i64 [ %2107, %2105 ], [ 0, %2099 ]
  %2110 = icmp ne i32 %2100, 0
  %2111 = icmp ne i64 %2109, 0
  %2112 = or i1 %2110, %2111
  %2113 = zext i1 %2112 to i32
  %2114 = trunc nuw i64 %2109 to i8
  %2115 = bitcast i8 %2114 to <8 x i1>
  %2116 = xor <8 x i1> %2115, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %2117 = and <8 x i1> %2101, %2116
  %2118 = load ptr, ptr %137, align 8
  %2119 = load <8 x double>, ptr %2118, align 8
  %2120 = fcmp oeq <8 x double> %2119, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %2121 = select <8 x i1> %2120, <8 x i1> %2117, <8 x i1> zeroinitializer
  %2122 = bitcast <8 x i1> %2121 to i8
  %2123 = icmp eq i8 %2122, 0
  br i1 %2123, label %2126, label %2124

2124:                                             ; preds = %2108
  %2125 = zext i8 %2122 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %2125, i64 noundef 0) #12
  br label %2126

2126:                                             ; preds = %2124, %2108
  %2127 = phi i32 [ 1, %2124 ], [ %2113, %2108 ]
  br label %145

2128:                                             ; preds = %202, %227, %198
  %2129 = phi i64 [ 1, %198 ], [ 0, %227 ], [ 0, %202 ]
  ret i64 %2129
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
  br i1 %77, label %83, label %78, !llvm.loop !70

78:                                               ; preds = %51, %70
  %79 = phi i64 [ %80, %70 ], [ %48, %51 ]
  %80 = add nsw i64 %79, 1
  store i64 %80, ptr %7, align 8
  %81 = load i64, ptr %9, align 8
  %82 = icmp sge i64 %80, %81
  br i1 %82, label %83, label %70, !llvm.loop !70

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
  br i1 %110, label %102, label %111, !llvm.loop !71

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
  br i1 %127, label %119, label %128, !llvm.loop !71

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
  br i1 %144, label %136, label %145, !llvm.loop !71

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
  br i1 %166, label %158, label %167, !llvm.loop !71

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
  br i1 %188, label %180, label %189, !llvm.loop !71

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
  br i1 %216, label %204, label %201, !llvm.loop !72

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
  tail call void %233(ptr noundef %237, ptr noundef %241) #13
  %242 = add nuw nsw i64 %226, 1
  %243 = load i64, ptr %32, align 8
  %244 = icmp slt i64 %242, %243
  br i1 %244, label %225, label %217, !llvm.loop !73

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
  br i1 %272, label %245, label %290, !llvm.loop !74

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
  br i1 %289, label %259, label %273, !llvm.loop !75

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
  br i1 %312, label %59, label %43, !llvm.loop !76

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
  tail call void %327(ptr noundef %328, ptr noundef %332) #13
  %333 = add nuw nsw i64 %321, 1
  %334 = load i64, ptr %314, align 8
  %335 = icmp slt i64 %333, %334
  br i1 %335, label %320, label %434, !llvm.loop !77

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
  br i1 %356, label %357, label %348, !llvm.loop !78

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
  br i1 %371, label %372, label %363, !llvm.loop !78

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
  br i1 %386, label %387, label %378, !llvm.loop !78

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
  br i1 %401, label %402, label %393, !llvm.loop !78

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
  br i1 %419, label %420, label %411, !llvm.loop !78

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
  br i1 %433, label %313, label %336, !llvm.loop !79

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
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %7) #12
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
  tail call fastcc void @settle(ptr noundef nonnull %20) #12
  br label %31

31:                                               ; preds = %30, %4
  %32 = getelementptr inbounds i8, ptr %20, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %20) #12
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
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #13
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
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %76, ptr noundef %76, ptr noundef nonnull %71, i64 noundef %75) #12
  %77 = load <8 x double>, ptr %5, align 16
  %78 = getelementptr inbounds i8, ptr %71, i64 168
  %79 = load ptr, ptr %78, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %79, ptr noundef %76, ptr noundef nonnull %71, i64 noundef %75) #12
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
  br i1 %179, label %164, label %55, !llvm.loop !80

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
  br i1 %204, label %205, label %180, !llvm.loop !81

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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %213, i64 noundef 3) #12
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %221, i64 noundef 0) #12
  ret void

226:                                              ; preds = %209, %226
  %227 = phi i64 [ %207, %209 ], [ %238, %226 ]
  %228 = load ptr, ptr %11, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %228, i64 noundef %227) #12
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
  br i1 %239, label %212, label %226, !llvm.loop !82
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
  br i1 %31, label %19, label %32, !llvm.loop !83

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
  br i1 %53, label %7, label %8, !llvm.loop !84
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
  br i1 %86, label %61, label %64, !llvm.loop !85

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !86

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
  br i1 %126, label %118, label %127, !llvm.loop !87

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
  br i1 %155, label %135, label %174, !llvm.loop !88

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
  br i1 %173, label %150, label %157, !llvm.loop !89

174:                                              ; preds = %150, %130
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %43) #12
  br label %175

175:                                              ; preds = %174, %127
  %176 = load ptr, ptr %15, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %43
  store i64 -1, ptr %177, align 8
  %178 = add nsw i64 %42, -1
  %179 = and i64 %178, %42
  %180 = icmp eq i64 %179, 0
  br i1 %180, label %60, label %41, !llvm.loop !90
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
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #13
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
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #13
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
  br i1 %92, label %63, label %30, !llvm.loop !91

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
  br i1 %107, label %83, label %93, !llvm.loop !92

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
  br i1 %139, label %108, label %114, !llvm.loop !93

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
  %17 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %16, ptr noundef nonnull %3) #12
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
  br i1 %25, label %9, label %21, !llvm.loop !94

26:                                               ; preds = %9, %51
  %27 = phi i64 [ %53, %51 ], [ %19, %9 ]
  %28 = phi i64 [ %46, %51 ], [ 0, %9 ]
  %29 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %27, i1 true)
  %30 = getelementptr inbounds double, ptr %3, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %6, i64 %29
  %33 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %29, double noundef %31, ptr noundef %32) #12
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
  br i1 %54, label %48, label %26, !llvm.loop !95
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
  br i1 %45, label %36, label %39, !llvm.loop !96

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
  tail call fastcc void @nested(ptr noundef %22, ptr noundef %71, ptr noundef %73, i64 noundef %75, i64 noundef %79, ptr noundef %80, i64 noundef %84) #12
  %85 = load ptr, ptr %38, align 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp eq i64 %86, 1
  br i1 %87, label %88, label %92

88:                                               ; preds = %65
  %89 = load ptr, ptr %18, align 8
  %90 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %89, ptr noundef %22, i64 noundef %59, i32 noundef 0) #12
  %91 = or i64 %90, %48
  br label %92

92:                                               ; preds = %88, %65
  %93 = phi i64 [ %91, %88 ], [ %48, %65 ]
  %94 = xor i64 %93, -1
  %95 = and i64 %59, %94
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %95) #12
  br label %46, !llvm.loop !97

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
  br i1 %111, label %112, label %96, !llvm.loop !98

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
  tail call fastcc void @nested(ptr noundef %15, ptr noundef %18, ptr noundef %20, i64 noundef %22, i64 noundef %26, ptr noundef %27, i64 noundef %32) #12
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
  br i1 %60, label %45, label %40, !llvm.loop !99

61:                                               ; preds = %40
  %62 = bitcast <8 x i1> %12 to i8
  %63 = icmp eq i8 %62, 0
  br i1 %63, label %69, label %64

64:                                               ; preds = %61
  %65 = zext i8 %62 to i64
  %66 = getelementptr inbounds i8, ptr %7, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %3, ptr noundef %67, i64 noundef %65, i32 noundef 0) #12
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
  br i1 %45, label %28, label %19, !llvm.loop !100

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
  br i1 %54, label %29, label %46, !llvm.loop !101
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
  br i1 %50, label %34, label %40, !llvm.loop !102

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #12
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
  br i1 %94, label %80, label %83, !llvm.loop !103

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #12
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
  br i1 %139, label %120, label %123, !llvm.loop !104

140:                                              ; preds = %98, %96
  %141 = load ptr, ptr %57, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 48
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %148, label %145

145:                                              ; preds = %140
  %146 = inttoptr i64 %143 to ptr
  %147 = tail call i64 %146(ptr noundef %56) #13
  br label %148

148:                                              ; preds = %145, %140
  %149 = phi i64 [ %147, %145 ], [ 0, %140 ]
  br i1 %75, label %150, label %151

150:                                              ; preds = %148
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #12
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
  br i1 %195, label %177, label %180, !llvm.loop !105

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
  br i1 %210, label %196, label %200, !llvm.loop !106

211:                                              ; preds = %196
  %212 = or i64 %199, %21
  br label %214

213:                                              ; preds = %196
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %199, i64 noundef %157) #12
  br label %214

214:                                              ; preds = %213, %211
  %215 = phi i64 [ %212, %211 ], [ %21, %213 ]
  %216 = add nsw i64 %22, -1
  %217 = and i64 %216, %22
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %32, label %20, !llvm.loop !107
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
  tail call fastcc void @settle(ptr noundef nonnull %18) #12
  br label %31

31:                                               ; preds = %30, %17
  %32 = getelementptr inbounds i8, ptr %18, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %18) #12
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
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #13
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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %56, i64 noundef 3) #12
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
  br i1 %77, label %62, label %54, !llvm.loop !108
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
  br i1 %33, label %21, label %34, !llvm.loop !83

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
  br i1 %54, label %6, label %7, !llvm.loop !109
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
  br i1 %25, label %15, label %14, !llvm.loop !110

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
  br i1 %76, label %65, label %77, !llvm.loop !111

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
  br i1 %105, label %22, label %26, !llvm.loop !112
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
  br i1 %48, label %13, label %20, !llvm.loop !113
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
  br i1 %60, label %29, label %33, !llvm.loop !114

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
  br i1 %76, label %57, label %61, !llvm.loop !115
}

declare double @llvm.sqrt.f64(double) #5

define internal fastcc range(i64 0, 256) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %118, %57
  %6 = icmp eq i64 %25, %1
  br i1 %6, label %7, label %13, !llvm.loop !116

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
  br i1 %56, label %39, label %27, !llvm.loop !117

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
  br i1 %74, label %57, label %61, !llvm.loop !118

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
  br i1 %89, label %71, label %75, !llvm.loop !119

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
  br i1 %117, label %104, label %118, !llvm.loop !120

118:                                              ; preds = %104, %90
  %119 = add nuw nsw i64 %91, 1
  %120 = icmp slt i64 %119, %1
  br i1 %120, label %90, label %5, !llvm.loop !121
}

define internal fastcc range(i64 0, 256) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %179, %69
  %6 = icmp eq i64 %31, %1
  br i1 %6, label %7, label %13, !llvm.loop !122

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
  %24 = load <8 x double>, ptr %23, align 8, !noalias !123
  %25 = or disjoint i64 %21, 64
  %26 = getelementptr inbounds i8, ptr %0, i64 %25
  %27 = load <8 x double>, ptr %26, align 8, !noalias !123
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
  %54 = load <8 x double>, ptr %53, align 8, !noalias !126
  %55 = or disjoint i64 %51, 64
  %56 = getelementptr inbounds i8, ptr %0, i64 %55
  %57 = load <8 x double>, ptr %56, align 8, !noalias !126
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
  br i1 %68, label %45, label %33, !llvm.loop !129

69:                                               ; preds = %96, %33
  %70 = load <8 x double>, ptr %23, align 8, !noalias !130
  %71 = load <8 x double>, ptr %26, align 8, !noalias !130
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
  br i1 %99, label %69, label %86, !llvm.loop !133

100:                                              ; preds = %94, %100
  %101 = phi i64 [ 0, %94 ], [ %122, %100 ]
  %102 = add nuw nsw i64 %101, %19
  %103 = shl i64 %102, 7
  %104 = shl nsw i64 %102, 7
  %105 = getelementptr inbounds i8, ptr %0, i64 %104
  %106 = load <8 x i64>, ptr %105, align 8, !noalias !134
  %107 = or disjoint i64 %103, 64
  %108 = getelementptr inbounds i8, ptr %0, i64 %107
  %109 = load <8 x i64>, ptr %108, align 8, !noalias !134
  %110 = add nuw nsw i64 %101, %95
  %111 = shl i64 %110, 7
  %112 = shl nsw i64 %110, 7
  %113 = getelementptr inbounds i8, ptr %0, i64 %112
  %114 = load <8 x i64>, ptr %113, align 8, !noalias !137
  %115 = or disjoint i64 %111, 64
  %116 = getelementptr inbounds i8, ptr %0, i64 %115
  %117 = load <8 x i64>, ptr %116, align 8, !noalias !137
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
  br i1 %124, label %96, label %100, !llvm.loop !140

125:                                              ; preds = %69, %179
  %126 = phi i64 [ %180, %179 ], [ %31, %69 ]
  %127 = mul nuw nsw i64 %126, %1
  %128 = add nuw nsw i64 %127, %15
  %129 = shl i64 %128, 7
  %130 = shl nsw i64 %128, 7
  %131 = getelementptr inbounds i8, ptr %0, i64 %130
  %132 = load <8 x double>, ptr %131, align 8, !noalias !141
  %133 = or disjoint i64 %129, 64
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !141
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
  %157 = load <8 x double>, ptr %156, align 8, !noalias !144
  %158 = or disjoint i64 %154, 64
  %159 = getelementptr inbounds i8, ptr %0, i64 %158
  %160 = load <8 x double>, ptr %159, align 8, !noalias !144
  %161 = add nuw nsw i64 %152, %19
  %162 = shl i64 %161, 7
  %163 = shl nsw i64 %161, 7
  %164 = getelementptr inbounds i8, ptr %0, i64 %163
  %165 = load <8 x double>, ptr %164, align 8, !noalias !147
  %166 = or disjoint i64 %162, 64
  %167 = getelementptr inbounds i8, ptr %0, i64 %166
  %168 = load <8 x double>, ptr %167, align 8, !noalias !147
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
  br i1 %178, label %151, label %179, !llvm.loop !150

179:                                              ; preds = %151, %125
  %180 = add nuw nsw i64 %126, 1
  %181 = icmp slt i64 %180, %1
  br i1 %181, label %125, label %5, !llvm.loop !151
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
  br i1 %26, label %16, label %6, !llvm.loop !152

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
  br i1 %38, label %24, label %18, !llvm.loop !153

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
  br i1 %55, label %39, label %44, !llvm.loop !154

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
  br i1 %69, label %52, label %56, !llvm.loop !155

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
  br i1 %86, label %71, label %70, !llvm.loop !156

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
  br i1 %100, label %80, label %87, !llvm.loop !157
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
  br i1 %27, label %17, label %6, !llvm.loop !152

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
  br i1 %38, label %25, label %19, !llvm.loop !153

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
  br i1 %46, label %39, label %36, !llvm.loop !158

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
  %56 = load <8 x double>, ptr %55, align 8, !noalias !159
  %57 = or disjoint i64 %53, 64
  %58 = getelementptr inbounds i8, ptr %3, i64 %57
  %59 = load <8 x double>, ptr %58, align 8, !noalias !159
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
  br i1 %67, label %47, label %51, !llvm.loop !162

68:                                               ; preds = %61, %68
  %69 = phi i64 [ 0, %61 ], [ %94, %68 ]
  %70 = phi <8 x double> [ %59, %61 ], [ %93, %68 ]
  %71 = phi <8 x double> [ %56, %61 ], [ %92, %68 ]
  %72 = add nuw nsw i64 %69, %62
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !163
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !163
  %80 = shl i64 %69, 7
  %81 = shl nsw i64 %69, 7
  %82 = getelementptr inbounds i8, ptr %3, i64 %81
  %83 = load <8 x double>, ptr %82, align 8, !noalias !166
  %84 = or disjoint i64 %80, 64
  %85 = getelementptr inbounds i8, ptr %3, i64 %84
  %86 = load <8 x double>, ptr %85, align 8, !noalias !166
  %87 = fneg <8 x double> %79
  %88 = fmul <8 x double> %86, %87
  %89 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %83, <8 x double> %88)
  %90 = fmul <8 x double> %79, %83
  %91 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %86, <8 x double> %90)
  %92 = fsub <8 x double> %71, %89
  %93 = fsub <8 x double> %70, %91
  %94 = add nuw nsw i64 %69, 1
  %95 = icmp eq i64 %94, %52
  br i1 %95, label %63, label %68, !llvm.loop !169

96:                                               ; preds = %110, %47
  ret void

97:                                               ; preds = %49, %110
  %98 = phi i64 [ %1, %49 ], [ %99, %110 ]
  %99 = add nsw i64 %98, -1
  %100 = shl i64 %99, 7
  %101 = shl nsw i64 %99, 7
  %102 = getelementptr inbounds i8, ptr %3, i64 %101
  %103 = load <8 x double>, ptr %102, align 8, !noalias !170
  %104 = or disjoint i64 %100, 64
  %105 = getelementptr inbounds i8, ptr %3, i64 %104
  %106 = load <8 x double>, ptr %105, align 8, !noalias !170
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
  %117 = load <8 x double>, ptr %116, align 8, !noalias !173
  %118 = or disjoint i64 %114, 64
  %119 = getelementptr inbounds i8, ptr %0, i64 %118
  %120 = load <8 x double>, ptr %119, align 8, !noalias !173
  %121 = fneg <8 x double> %112
  %122 = fmul <8 x double> %120, %121
  %123 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %117, <8 x double> %122)
  %124 = fmul <8 x double> %112, %117
  %125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %120, <8 x double> %124)
  store <8 x double> %123, ptr %102, align 8
  store <8 x double> %125, ptr %105, align 8
  %126 = icmp sgt i64 %98, 1
  br i1 %126, label %97, label %96, !llvm.loop !176

127:                                              ; preds = %108, %127
  %128 = phi i64 [ %98, %108 ], [ %153, %127 ]
  %129 = phi <8 x double> [ %106, %108 ], [ %152, %127 ]
  %130 = phi <8 x double> [ %103, %108 ], [ %151, %127 ]
  %131 = add nsw i64 %128, %109
  %132 = shl i64 %131, 7
  %133 = shl nsw i64 %131, 7
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !177
  %136 = or disjoint i64 %132, 64
  %137 = getelementptr inbounds i8, ptr %0, i64 %136
  %138 = load <8 x double>, ptr %137, align 8, !noalias !177
  %139 = shl i64 %128, 7
  %140 = shl nsw i64 %128, 7
  %141 = getelementptr inbounds i8, ptr %3, i64 %140
  %142 = load <8 x double>, ptr %141, align 8, !noalias !180
  %143 = or disjoint i64 %139, 64
  %144 = getelementptr inbounds i8, ptr %3, i64 %143
  %145 = load <8 x double>, ptr %144, align 8, !noalias !180
  %146 = fneg <8 x double> %138
  %147 = fmul <8 x double> %145, %146
  %148 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %142, <8 x double> %147)
  %149 = fmul <8 x double> %138, %142
  %150 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %145, <8 x double> %149)
  %151 = fsub <8 x double> %130, %148
  %152 = fsub <8 x double> %129, %150
  %153 = add nuw nsw i64 %128, 1
  %154 = icmp eq i64 %153, %1
  br i1 %154, label %110, label %127, !llvm.loop !183
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
  br i1 %35, label %23, label %12, !llvm.loop !152

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
  br i1 %46, label %33, label %27, !llvm.loop !153

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
  br i1 %54, label %47, label %44, !llvm.loop !158

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
  br i1 %70, label %61, label %55, !llvm.loop !184

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
  br i1 %92, label %93, label %80, !llvm.loop !185

93:                                               ; preds = %80, %71
  %94 = add nuw nsw i64 %72, 1
  %95 = icmp eq i64 %94, %56
  br i1 %95, label %68, label %71, !llvm.loop !186

96:                                               ; preds = %136, %106
  %97 = icmp sgt i64 %99, 1
  br i1 %97, label %98, label %105, !llvm.loop !187

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
  br i1 %132, label %133, label %120, !llvm.loop !185

133:                                              ; preds = %120, %111
  %134 = add nuw nsw i64 %112, 1
  %135 = icmp eq i64 %134, %1
  br i1 %135, label %106, label %111, !llvm.loop !188

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
  br i1 %145, label %96, label %136, !llvm.loop !189
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
  br i1 %35, label %23, label %12, !llvm.loop !152

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
  br i1 %46, label %33, label %27, !llvm.loop !153

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
  br i1 %54, label %47, label %44, !llvm.loop !158

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
  br i1 %69, label %61, label %55, !llvm.loop !190

70:                                               ; preds = %58, %109
  %71 = phi i64 [ 0, %58 ], [ %110, %109 ]
  %72 = add nuw nsw i64 %71, %59
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !191
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !191
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
  %89 = load <8 x double>, ptr %88, align 8, !noalias !194
  %90 = or disjoint i64 %86, 64
  %91 = getelementptr inbounds i8, ptr %3, i64 %90
  %92 = load <8 x double>, ptr %91, align 8, !noalias !194
  %93 = add nuw nsw i64 %84, %81
  %94 = shl i64 %93, 7
  %95 = shl nsw i64 %93, 7
  %96 = getelementptr inbounds i8, ptr %3, i64 %95
  %97 = load <8 x double>, ptr %96, align 8, !noalias !197
  %98 = or disjoint i64 %94, 64
  %99 = getelementptr inbounds i8, ptr %3, i64 %98
  %100 = load <8 x double>, ptr %99, align 8, !noalias !197
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
  br i1 %108, label %109, label %83, !llvm.loop !200

109:                                              ; preds = %83, %70
  %110 = add nuw nsw i64 %71, 1
  %111 = icmp eq i64 %110, %56
  br i1 %111, label %67, label %70, !llvm.loop !201

112:                                              ; preds = %173, %122
  %113 = icmp sgt i64 %115, 1
  br i1 %113, label %114, label %121, !llvm.loop !202

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
  %137 = load <8 x double>, ptr %136, align 8, !noalias !203
  %138 = or disjoint i64 %134, 64
  %139 = getelementptr inbounds i8, ptr %0, i64 %138
  %140 = load <8 x double>, ptr %139, align 8, !noalias !203
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
  %150 = load <8 x double>, ptr %149, align 8, !noalias !206
  %151 = or disjoint i64 %147, 64
  %152 = getelementptr inbounds i8, ptr %3, i64 %151
  %153 = load <8 x double>, ptr %152, align 8, !noalias !206
  %154 = add nsw i64 %145, %142
  %155 = shl i64 %154, 7
  %156 = shl nsw i64 %154, 7
  %157 = getelementptr inbounds i8, ptr %3, i64 %156
  %158 = load <8 x double>, ptr %157, align 8, !noalias !209
  %159 = or disjoint i64 %155, 64
  %160 = getelementptr inbounds i8, ptr %3, i64 %159
  %161 = load <8 x double>, ptr %160, align 8, !noalias !209
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
  br i1 %169, label %170, label %144, !llvm.loop !200

170:                                              ; preds = %144, %131
  %171 = add nuw nsw i64 %132, 1
  %172 = icmp eq i64 %171, %1
  br i1 %172, label %122, label %131, !llvm.loop !212

173:                                              ; preds = %123, %173
  %174 = phi i64 [ 0, %123 ], [ %190, %173 ]
  %175 = add nsw i64 %174, %124
  %176 = shl i64 %175, 7
  %177 = shl nsw i64 %175, 7
  %178 = getelementptr inbounds i8, ptr %3, i64 %177
  %179 = load <8 x double>, ptr %178, align 8, !noalias !213
  %180 = or disjoint i64 %176, 64
  %181 = getelementptr inbounds i8, ptr %3, i64 %180
  %182 = load <8 x double>, ptr %181, align 8, !noalias !213
  %183 = load <8 x double>, ptr %128, align 8, !noalias !216
  %184 = load <8 x double>, ptr %130, align 8, !noalias !216
  %185 = fneg <8 x double> %182
  %186 = fmul <8 x double> %184, %185
  %187 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %183, <8 x double> %186)
  %188 = fmul <8 x double> %182, %183
  %189 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %184, <8 x double> %188)
  store <8 x double> %187, ptr %178, align 8
  store <8 x double> %189, ptr %181, align 8
  %190 = add nuw nsw i64 %174, 1
  %191 = icmp eq i64 %190, %4
  br i1 %191, label %112, label %173, !llvm.loop !219
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
  tail call fastcc void @nested(ptr noundef %37, ptr noundef %40, ptr noundef %42, i64 noundef %44, i64 noundef %48, ptr noundef %49, i64 noundef %54) #12
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
  tail call fastcc void @settle(ptr noundef nonnull %30) #12
  br label %64

64:                                               ; preds = %63, %27
  %65 = getelementptr inbounds i8, ptr %0, i64 296
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %69

68:                                               ; preds = %64
  tail call fastcc void @sample(ptr noundef nonnull %30) #12
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
  %83 = tail call i32 %82(ptr noundef %73, ptr noundef %76, ptr noundef %78, ptr noundef %80, ptr noundef %29) #13
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
  br i1 %100, label %101, label %89, !llvm.loop !220

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
  tail call fastcc void @nested(ptr noundef %143, ptr noundef %146, ptr noundef %148, i64 noundef %150, i64 noundef %154, ptr noundef %155, i64 noundef %159) #12
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
  tail call fastcc void @settle(ptr noundef nonnull %105) #12
  br label %168

168:                                              ; preds = %167, %126
  %169 = load i64, ptr %109, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %168
  tail call fastcc void @sample(ptr noundef nonnull %105) #12
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
  %183 = tail call i32 %182(ptr noundef %175, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %133) #13
  %184 = zext i32 %183 to i64
  %185 = or i64 %128, %184
  %186 = add nuw nsw i64 %127, 1
  %187 = icmp eq i64 %186, 5
  br i1 %187, label %113, label %126, !llvm.loop !221

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
  br i1 %237, label %203, label %208, !llvm.loop !222

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
  br i1 %315, label %316, label %256, !llvm.loop !223

316:                                              ; preds = %313
  %317 = xor <8 x i64> %314, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %318 = and <8 x i64> %251, %317
  %319 = add nuw nsw i64 %198, 1
  %320 = icmp eq i64 %319, %9
  br i1 %320, label %188, label %195, !llvm.loop !224

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
  br i1 %342, label %321, label %330, !llvm.loop !225
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
  br i1 %63, label %64, label %48, !llvm.loop !105

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
  %86 = tail call i64 %81(ptr noundef %9, double noundef %70, double noundef %85) #13
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
  br i1 %127, label %128, label %112, !llvm.loop !105

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
  br i1 %149, label %24, label %129, !llvm.loop !226

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
  br i1 %168, label %150, label %147, !llvm.loop !227
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
  br i1 %31, label %20, label %19, !llvm.loop !228

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
  br i1 %43, label %32, label %24, !llvm.loop !229
}

define internal fastcc double @knot_after(ptr noundef readonly %0, double noundef %1) unnamed_addr #9 {
  %3 = tail call double @llvm.fabs.f64(double %1)
  %4 = fmul double %3, 0x3D10000000000000
  %5 = fadd double %4, %1
  %6 = getelementptr inbounds i8, ptr %0, i64 152
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %16

9:                                                ; preds = %2
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 160
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 192
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
  br i1 %54, label %43, label %55, !llvm.loop !111

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
  br i1 %71, label %16, label %18, !llvm.loop !230
}

declare double @llvm.fabs.f64(double) #5

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #10

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { noinline nounwind }
attributes #7 = { noinline nounwind }
attributes #8 = { nounwind willreturn }
attributes #9 = { noinline nounwind }
attributes #10 = { nounwind willreturn memory(none) }
attributes #11 = { nounwind }
attributes #12 = { nounwind }
attributes #13 = { nounwind }


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
!66 = distinct !{!66, !4, !5, !67}
!67 = !{!"llvm.loop.vectorize.width", i32 1}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5, !67}
!72 = distinct !{!72, !4, !5, !67}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5, !67}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
!84 = distinct !{!84, !4, !5}
!85 = distinct !{!85, !4, !5}
!86 = distinct !{!86, !4, !5, !67}
!87 = distinct !{!87, !4, !5, !67}
!88 = distinct !{!88, !4, !5}
!89 = distinct !{!89, !4, !5}
!90 = distinct !{!90, !4, !5}
!91 = distinct !{!91, !4, !5}
!92 = distinct !{!92, !4, !5}
!93 = distinct !{!93, !4, !5}
!94 = distinct !{!94, !4, !5}
!95 = distinct !{!95, !4, !5}
!96 = distinct !{!96, !4, !5, !67}
!97 = distinct !{!97, !5}
!98 = distinct !{!98, !4, !5}
!99 = distinct !{!99, !4, !5}
!100 = distinct !{!100, !4, !5}
!101 = distinct !{!101, !4, !5, !67}
!102 = distinct !{!102, !4, !5}
!103 = distinct !{!103, !4, !5}
!104 = distinct !{!104, !4, !5}
!105 = distinct !{!105, !4, !5, !67}
!106 = distinct !{!106, !4, !5}
!107 = distinct !{!107, !4, !5}
!108 = distinct !{!108, !4, !5}
!109 = distinct !{!109, !4, !5}
!110 = distinct !{!110, !4, !5}
!111 = distinct !{!111, !4, !5}
!112 = distinct !{!112, !4, !5}
!113 = distinct !{!113, !4, !5}
!114 = distinct !{!114, !4, !5}
!115 = distinct !{!115, !4, !5, !67}
!116 = distinct !{!116, !4, !5}
!117 = distinct !{!117, !4, !5}
!118 = distinct !{!118, !4, !5}
!119 = distinct !{!119, !4, !5}
!120 = distinct !{!120, !4, !5}
!121 = distinct !{!121, !4, !5}
!122 = distinct !{!122, !4, !5}
!123 = !{!124}
!124 = distinct !{!124, !125, !"pair_item: argument 0"}
!125 = distinct !{!125, !"pair_item"}
!126 = !{!127}
!127 = distinct !{!127, !128, !"pair_item: argument 0"}
!128 = distinct !{!128, !"pair_item"}
!129 = distinct !{!129, !4, !5}
!130 = !{!131}
!131 = distinct !{!131, !132, !"pair_item: argument 0"}
!132 = distinct !{!132, !"pair_item"}
!133 = distinct !{!133, !4, !5}
!134 = !{!135}
!135 = distinct !{!135, !136, !"pair_item: argument 0"}
!136 = distinct !{!136, !"pair_item"}
!137 = !{!138}
!138 = distinct !{!138, !139, !"pair_item: argument 0"}
!139 = distinct !{!139, !"pair_item"}
!140 = distinct !{!140, !4, !5}
!141 = !{!142}
!142 = distinct !{!142, !143, !"pair_item: argument 0"}
!143 = distinct !{!143, !"pair_item"}
!144 = !{!145}
!145 = distinct !{!145, !146, !"pair_item: argument 0"}
!146 = distinct !{!146, !"pair_item"}
!147 = !{!148}
!148 = distinct !{!148, !149, !"pair_item: argument 0"}
!149 = distinct !{!149, !"pair_item"}
!150 = distinct !{!150, !4, !5}
!151 = distinct !{!151, !4, !5}
!152 = distinct !{!152, !4, !5}
!153 = distinct !{!153, !4, !5}
!154 = distinct !{!154, !4, !5}
!155 = distinct !{!155, !4, !5}
!156 = distinct !{!156, !4, !5}
!157 = distinct !{!157, !4, !5}
!158 = distinct !{!158, !4, !5, !67}
!159 = !{!160}
!160 = distinct !{!160, !161, !"pair_item: argument 0"}
!161 = distinct !{!161, !"pair_item"}
!162 = distinct !{!162, !4, !5}
!163 = !{!164}
!164 = distinct !{!164, !165, !"pair_item: argument 0"}
!165 = distinct !{!165, !"pair_item"}
!166 = !{!167}
!167 = distinct !{!167, !168, !"pair_item: argument 0"}
!168 = distinct !{!168, !"pair_item"}
!169 = distinct !{!169, !4, !5}
!170 = !{!171}
!171 = distinct !{!171, !172, !"pair_item: argument 0"}
!172 = distinct !{!172, !"pair_item"}
!173 = !{!174}
!174 = distinct !{!174, !175, !"pair_item: argument 0"}
!175 = distinct !{!175, !"pair_item"}
!176 = distinct !{!176, !4, !5}
!177 = !{!178}
!178 = distinct !{!178, !179, !"pair_item: argument 0"}
!179 = distinct !{!179, !"pair_item"}
!180 = !{!181}
!181 = distinct !{!181, !182, !"pair_item: argument 0"}
!182 = distinct !{!182, !"pair_item"}
!183 = distinct !{!183, !4, !5}
!184 = distinct !{!184, !4, !5}
!185 = distinct !{!185, !4, !5}
!186 = distinct !{!186, !4, !5}
!187 = distinct !{!187, !4, !5}
!188 = distinct !{!188, !4, !5}
!189 = distinct !{!189, !4, !5}
!190 = distinct !{!190, !4, !5}
!191 = !{!192}
!192 = distinct !{!192, !193, !"pair_item: argument 0"}
!193 = distinct !{!193, !"pair_item"}
!194 = !{!195}
!195 = distinct !{!195, !196, !"pair_item: argument 0"}
!196 = distinct !{!196, !"pair_item"}
!197 = !{!198}
!198 = distinct !{!198, !199, !"pair_item: argument 0"}
!199 = distinct !{!199, !"pair_item"}
!200 = distinct !{!200, !4, !5}
!201 = distinct !{!201, !4, !5}
!202 = distinct !{!202, !4, !5}
!203 = !{!204}
!204 = distinct !{!204, !205, !"pair_item: argument 0"}
!205 = distinct !{!205, !"pair_item"}
!206 = !{!207}
!207 = distinct !{!207, !208, !"pair_item: argument 0"}
!208 = distinct !{!208, !"pair_item"}
!209 = !{!210}
!210 = distinct !{!210, !211, !"pair_item: argument 0"}
!211 = distinct !{!211, !"pair_item"}
!212 = distinct !{!212, !4, !5}
!213 = !{!214}
!214 = distinct !{!214, !215, !"pair_item: argument 0"}
!215 = distinct !{!215, !"pair_item"}
!216 = !{!217}
!217 = distinct !{!217, !218, !"pair_item: argument 0"}
!218 = distinct !{!218, !"pair_item"}
!219 = distinct !{!219, !4, !5}
!220 = distinct !{!220, !4, !5}
!221 = distinct !{!221, !4, !5}
!222 = distinct !{!222, !4, !5}
!223 = distinct !{!223, !4, !5}
!224 = distinct !{!224, !4, !5}
!225 = distinct !{!225, !4, !5}
!226 = distinct !{!226, !4, !5, !67}
!227 = distinct !{!227, !4, !5}
!228 = distinct !{!228, !4, !5}
!229 = distinct !{!229, !4, !5}
!230 = distinct !{!230, !4, !5}
