; sources d53f13076d9b25348e1105a64a462602e3c1f3e9074e3ac713fcc9acb0b46028
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@NODES = internal unnamed_addr constant [3 x double] [double 0x3FC3D8B64657CAEA, double 0x3FE4A36C0803A6DF, double 1.000000e+00], align 16
@TO_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x4010B70201A79C46, double 0x3FD4F8C15DA84E86, double 0x3FE0BF7FF59D56EF], [3 x double] [double 0xC010B70201A79C46, double 0xBFD4F8C15DA84E86, double 0x3FDE810014C55221], [3 x double] [double 0x3FE017885A24A7F2, double 0xC004934E6FCAA598, double 0x3FE312C0CF7BDFD1]], align 16
@FROM_WAVES = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x3FB82D23845D677B, double 0xBFC214A74C403BF7, double 0x3F9EBFF91A6D688E], [3 x double] [double 0x3FD0037DE70AA1ED, double 0x3FCA20E91E20B551, double 0xBFD8821FA2A36DED], [3 x double] [double 1.000000e+00, double 1.000000e+00, double 0.000000e+00]], align 16
@POLYNOMIAL = internal unnamed_addr constant [3 x [3 x double]] [[3 x double] [double 0x402418FD8BAFFE05, double 0xC039A12CE7B30915, double 0x402F295C43B61425], [3 x double] [double 0xBFF61D41B2D54580, double 0x402497AF24BB677E, double 0xC021D406EE60BECF], [3 x double] [double 0x3FD5555555555555, double 0xC005555555555555, double 0x400AAAAAAAAAAAAB]], align 16
@PLACES = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes_implicit(ptr noundef %0) #0 {
  %2 = alloca [3 x double], align 16
  %3 = alloca [3 x double], align 16
  %4 = alloca [3 x <8 x double>], align 64
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca %struct.Stepper, align 8
  %8 = alloca [8 x double], align 16
  %9 = alloca [8 x double], align 16
  %10 = alloca [8 x double], align 16
  %11 = alloca i64, align 8
  %12 = alloca [8 x i64], align 16
  %13 = alloca i64, align 8
  store ptr %0, ptr %7, align 8
  %14 = getelementptr inbounds i8, ptr %7, i64 8
  %15 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %15, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %7, i64 16
  %17 = getelementptr inbounds i8, ptr %0, i64 432
  store ptr %17, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 984
  %19 = load ptr, ptr %15, align 8
  %20 = getelementptr inbounds i8, ptr %19, i64 8
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %0, i64 1032
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 1040
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr double, ptr %23, i64 %25
  %27 = getelementptr i8, ptr %26, i64 -16
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 1008
  %30 = load ptr, ptr %29, align 8
  %31 = load double, ptr %30, align 8
  %32 = load ptr, ptr %18, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 16
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 1656
  %36 = load ptr, ptr %35, align 8
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %0, i64 1248
  %39 = load ptr, ptr %38, align 8
  %40 = getelementptr inbounds i8, ptr %39, i64 8
  %41 = load i64, ptr %40, align 8
  store i64 0, ptr %11, align 8
  %42 = getelementptr inbounds i8, ptr %0, i64 936
  %43 = load ptr, ptr %42, align 8
  br label %143

44:                                               ; preds = %143
  %45 = getelementptr inbounds i8, ptr %0, i64 696
  %46 = sitofp i64 %34 to double
  %47 = icmp eq i64 %37, 1
  %48 = icmp sgt i64 %41, 0
  store i64 %151, ptr %11, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 936
  %50 = getelementptr inbounds i8, ptr %0, i64 1568
  %51 = getelementptr inbounds i8, ptr %0, i64 1200
  %52 = insertelement <8 x double> poison, double %28, i64 0
  %53 = shufflevector <8 x double> %52, <8 x double> poison, <8 x i32> zeroinitializer
  %54 = getelementptr inbounds i8, ptr %0, i64 720
  %55 = insertelement <8 x double> poison, double %31, i64 0
  %56 = shufflevector <8 x double> %55, <8 x double> poison, <8 x i32> zeroinitializer
  %57 = getelementptr inbounds i8, ptr %0, i64 840
  %58 = getelementptr inbounds i8, ptr %0, i64 864
  %59 = insertelement <8 x double> poison, double %46, i64 0
  %60 = shufflevector <8 x double> %59, <8 x double> poison, <8 x i32> zeroinitializer
  %61 = getelementptr inbounds i8, ptr %0, i64 1728
  %62 = getelementptr inbounds i8, ptr %0, i64 648
  %63 = getelementptr inbounds i8, ptr %0, i64 1800
  %64 = getelementptr inbounds i8, ptr %0, i64 1824
  %65 = getelementptr inbounds i8, ptr %0, i64 168
  %66 = getelementptr inbounds i8, ptr %0, i64 296
  %67 = getelementptr inbounds i8, ptr %0, i64 192
  %68 = getelementptr inbounds i8, ptr %0, i64 1776
  %69 = getelementptr inbounds i8, ptr %0, i64 1808
  %70 = getelementptr inbounds i8, ptr %0, i64 1752
  %71 = getelementptr inbounds i8, ptr %0, i64 1904
  %72 = getelementptr inbounds i8, ptr %0, i64 1848
  %73 = getelementptr inbounds i8, ptr %0, i64 1872
  %74 = getelementptr inbounds i8, ptr %0, i64 1800
  %75 = getelementptr inbounds i8, ptr %0, i64 1896
  %76 = getelementptr inbounds i8, ptr %0, i64 1920
  %77 = getelementptr inbounds i8, ptr %0, i64 2016
  %78 = getelementptr inbounds i8, ptr %0, i64 1944
  %79 = getelementptr inbounds i8, ptr %0, i64 1968
  %80 = getelementptr inbounds i8, ptr %0, i64 480
  %81 = getelementptr inbounds i8, ptr %0, i64 1992
  %82 = getelementptr inbounds i8, ptr %0, i64 480
  %83 = getelementptr inbounds i8, ptr %0, i64 168
  %84 = getelementptr inbounds i8, ptr %0, i64 296
  %85 = getelementptr inbounds i8, ptr %0, i64 192
  %86 = getelementptr inbounds i8, ptr %0, i64 240
  %87 = getelementptr inbounds i8, ptr %0, i64 1992
  %88 = getelementptr inbounds i8, ptr %0, i64 2040
  %89 = getelementptr inbounds i8, ptr %0, i64 2064
  %90 = getelementptr inbounds i8, ptr %0, i64 672
  %91 = getelementptr inbounds i8, ptr %0, i64 1896
  %92 = getelementptr inbounds i8, ptr %0, i64 1904
  %93 = getelementptr inbounds i8, ptr %0, i64 2040
  %94 = getelementptr inbounds i8, ptr %0, i64 2064
  %95 = getelementptr inbounds i8, ptr %0, i64 1848
  %96 = getelementptr inbounds i8, ptr %0, i64 1872
  %97 = getelementptr inbounds i8, ptr %0, i64 1920
  %98 = getelementptr inbounds i8, ptr %0, i64 672
  %99 = getelementptr inbounds i8, ptr %4, i64 64
  %100 = getelementptr inbounds i8, ptr %4, i64 128
  %101 = getelementptr inbounds i8, ptr %0, i64 1808
  %102 = getelementptr inbounds i8, ptr %0, i64 1800
  %103 = getelementptr inbounds i8, ptr %0, i64 456
  %104 = getelementptr inbounds i8, ptr %0, i64 1896
  %105 = getelementptr inbounds i8, ptr %0, i64 1904
  %106 = getelementptr inbounds i8, ptr %0, i64 2088
  %107 = getelementptr inbounds i8, ptr %0, i64 2040
  %108 = getelementptr inbounds i8, ptr %0, i64 600
  %109 = getelementptr inbounds i8, ptr %0, i64 1848
  %110 = getelementptr inbounds i8, ptr %0, i64 456
  %111 = getelementptr inbounds i8, ptr %0, i64 480
  %112 = getelementptr inbounds i8, ptr %0, i64 480
  %113 = getelementptr inbounds i8, ptr %0, i64 1992
  %114 = getelementptr inbounds i8, ptr %0, i64 168
  %115 = getelementptr inbounds i8, ptr %0, i64 296
  %116 = getelementptr inbounds i8, ptr %0, i64 192
  %117 = getelementptr inbounds i8, ptr %0, i64 240
  %118 = getelementptr inbounds i8, ptr %0, i64 888
  %119 = getelementptr inbounds i8, ptr %0, i64 456
  %120 = getelementptr inbounds i8, ptr %0, i64 440
  %121 = getelementptr inbounds i8, ptr %0, i64 1944
  %122 = getelementptr inbounds i8, ptr %0, i64 624
  %123 = getelementptr inbounds i8, ptr %0, i64 2016
  %124 = getelementptr inbounds i8, ptr %0, i64 1752
  %125 = getelementptr inbounds i8, ptr %2, i64 8
  %126 = getelementptr inbounds i8, ptr %2, i64 16
  %127 = getelementptr inbounds i8, ptr %3, i64 8
  %128 = getelementptr inbounds i8, ptr %3, i64 16
  %129 = getelementptr inbounds i8, ptr %0, i64 456
  %130 = getelementptr inbounds i8, ptr %0, i64 816
  %131 = getelementptr inbounds i8, ptr %0, i64 456
  %132 = getelementptr inbounds i8, ptr %0, i64 912
  %133 = icmp sgt i64 %21, 0
  %134 = getelementptr inbounds i8, ptr %0, i64 456
  br label %135

135:                                              ; preds = %1746, %44
  %136 = phi i64 [ %1406, %1746 ], [ undef, %44 ]
  %137 = phi i64 [ %1407, %1746 ], [ undef, %44 ]
  %138 = phi <8 x double> [ %1408, %1746 ], [ undef, %44 ]
  %139 = phi <8 x double> [ %1409, %1746 ], [ undef, %44 ]
  %140 = phi <8 x double> [ %1410, %1746 ], [ undef, %44 ]
  %141 = phi i32 [ %1747, %1746 ], [ 1, %44 ]
  %142 = phi i64 [ %1722, %1746 ], [ 0, %44 ]
  br label %154

143:                                              ; preds = %1, %143
  %144 = phi i64 [ 0, %1 ], [ %152, %143 ]
  %145 = phi i64 [ 0, %1 ], [ %151, %143 ]
  %146 = getelementptr inbounds i64, ptr %43, i64 %144
  %147 = load i64, ptr %146, align 8
  %148 = icmp sgt i64 %147, -1
  %149 = zext i1 %148 to i64
  %150 = shl nuw nsw i64 %149, %144
  %151 = or i64 %150, %145
  %152 = add nuw nsw i64 %144, 1
  %153 = icmp eq i64 %152, 8
  br i1 %153, label %44, label %143, !llvm.loop !3

154:                                              ; preds = %135, %258
  %155 = phi i32 [ 1, %258 ], [ %141, %135 ]
  %156 = phi i64 [ %194, %258 ], [ %142, %135 ]
  br label %157

157:                                              ; preds = %188, %154
  %158 = phi i32 [ %155, %154 ], [ %190, %188 ]
  %159 = phi i64 [ %156, %154 ], [ %191, %188 ]
  %160 = icmp ne i32 %158, 0
  %161 = icmp ne i64 %159, 0
  %162 = select i1 %160, i1 true, i1 %161
  br i1 %162, label %163, label %192

163:                                              ; preds = %157
  br i1 %160, label %164, label %166

164:                                              ; preds = %163
  %165 = call fastcc i64 @fill(ptr noundef %0, ptr noundef nonnull %11) #10
  br label %166

166:                                              ; preds = %163, %164
  %167 = phi i64 [ %165, %164 ], [ 0, %163 ]
  %168 = load i64, ptr %11, align 8
  %169 = icmp eq i64 %168, 0
  br i1 %169, label %188, label %170

170:                                              ; preds = %166
  %171 = or i64 %167, %159
  %172 = icmp eq i64 %171, 0
  br i1 %172, label %188, label %173

173:                                              ; preds = %170
  call fastcc void @start(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %167, i64 noundef %159) #10
  br label %174

174:                                              ; preds = %173, %183
  %175 = phi i32 [ 0, %173 ], [ %185, %183 ]
  %176 = phi i64 [ 0, %173 ], [ %186, %183 ]
  %177 = icmp eq i32 %175, 0
  br i1 %177, label %178, label %183

178:                                              ; preds = %174
  %179 = load ptr, ptr %49, align 8
  %180 = getelementptr inbounds i64, ptr %179, i64 %176
  %181 = load i64, ptr %180, align 8
  %182 = icmp eq i64 %181, -1
  br label %183

183:                                              ; preds = %178, %174
  %184 = phi i1 [ true, %174 ], [ %182, %178 ]
  %185 = zext i1 %184 to i32
  %186 = add nuw nsw i64 %176, 1
  %187 = icmp eq i64 %186, 8
  br i1 %187, label %188, label %174, !llvm.loop !6

188:                                              ; preds = %183, %170, %166
  %189 = phi i32 [ 1, %166 ], [ 8, %170 ], [ 0, %183 ]
  %190 = phi i32 [ %158, %166 ], [ 0, %170 ], [ %185, %183 ]
  %191 = phi i64 [ %159, %166 ], [ %159, %170 ], [ 0, %183 ]
  switch i32 %189, label %1748 [
    i32 0, label %157
    i32 8, label %192
  ], !llvm.loop !7

192:                                              ; preds = %188, %157
  %193 = phi i32 [ %190, %188 ], [ 0, %157 ]
  %194 = phi i64 [ %191, %188 ], [ 0, %157 ]
  %195 = load ptr, ptr %18, align 8
  %196 = getelementptr inbounds i8, ptr %195, i64 8
  %197 = load i64, ptr %196, align 8
  %198 = icmp slt i64 %197, 1
  br i1 %198, label %1748, label %199

199:                                              ; preds = %192
  br i1 %48, label %200, label %220

200:                                              ; preds = %199
  %201 = load i64, ptr %50, align 8
  %202 = icmp sgt i64 %201, 0
  br i1 %202, label %203, label %217

203:                                              ; preds = %200
  %204 = load ptr, ptr %38, align 8
  %205 = getelementptr inbounds i8, ptr %204, i64 72
  %206 = load i64, ptr %205, align 8
  %207 = load ptr, ptr %51, align 8
  %208 = load i64, ptr %207, align 8
  %209 = inttoptr i64 %208 to ptr
  %210 = getelementptr inbounds i8, ptr %209, i64 1064
  %211 = load i64, ptr %210, align 8
  %212 = shl i64 %211, 4
  %213 = add i64 %206, 16
  %214 = add i64 %213, %212
  %215 = icmp sgt i64 %214, %201
  %216 = zext i1 %215 to i32
  br label %217

217:                                              ; preds = %200, %203
  %218 = phi i32 [ 0, %200 ], [ %216, %203 ]
  %219 = icmp eq i32 %218, 0
  br i1 %219, label %220, label %1748

220:                                              ; preds = %217, %199
  %221 = add nsw i64 %197, -1
  store i64 %221, ptr %196, align 8
  %222 = load i64, ptr %11, align 8
  %223 = trunc i64 %222 to i8
  %224 = bitcast i8 %223 to <8 x i1>
  %225 = load ptr, ptr %45, align 8
  %226 = load <8 x double>, ptr %225, align 8
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %10) #10
  %227 = load <8 x double>, ptr %10, align 16
  %228 = fcmp olt <8 x double> %53, %227
  %229 = select <8 x i1> %228, <8 x double> %53, <8 x double> %227
  %230 = load ptr, ptr %54, align 8
  %231 = load <8 x double>, ptr %230, align 8
  %232 = fcmp olt <8 x double> %231, %56
  %233 = select <8 x i1> %232, <8 x double> %231, <8 x double> %56
  %234 = fadd <8 x double> %226, %233
  %235 = fmul <8 x double> %233, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %236 = fsub <8 x double> %229, %235
  %237 = fcmp ogt <8 x double> %234, %236
  %238 = select <8 x i1> %237, <8 x double> %229, <8 x double> %234
  %239 = fsub <8 x double> %238, %226
  %240 = bitcast <8 x double> %239 to <8 x i64>
  %241 = select <8 x i1> %224, <8 x i64> %240, <8 x i64> zeroinitializer
  %242 = bitcast <8 x i64> %241 to <8 x double>
  %243 = load ptr, ptr %57, align 8
  %244 = load <8 x double>, ptr %243, align 8
  %245 = load ptr, ptr %58, align 8
  %246 = load <8 x double>, ptr %245, align 8
  %247 = fadd <8 x double> %244, %246
  %248 = fcmp oge <8 x double> %247, %60
  %249 = fmul <8 x double> %242, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %250 = fadd <8 x double> %226, %249
  %251 = fcmp ule <8 x double> %250, %226
  %252 = fcmp une <8 x double> %238, %229
  %253 = and <8 x i1> %251, %252
  %254 = or <8 x i1> %253, %248
  %255 = and <8 x i1> %254, %224
  %256 = bitcast <8 x i1> %255 to i8
  %257 = icmp eq i8 %256, 0
  br i1 %257, label %265, label %258

258:                                              ; preds = %220
  %259 = zext i8 %256 to i64
  %260 = bitcast <8 x i1> %248 to i8
  %261 = zext i8 %260 to i64
  %262 = and i64 %259, %261
  call fastcc void @retire(ptr noundef %0, i64 noundef %262, i64 noundef 1) #10
  %263 = xor i64 %261, -1
  %264 = and i64 %259, %263
  call fastcc void @retire(ptr noundef %0, i64 noundef %264, i64 noundef -1) #10
  br label %154, !llvm.loop !8

265:                                              ; preds = %220
  %266 = load ptr, ptr %62, align 8, !noalias !9
  %267 = load double, ptr %266, align 8, !noalias !9
  %268 = load ptr, ptr %15, align 8, !noalias !14
  %269 = getelementptr inbounds i8, ptr %268, i64 8
  %270 = load i64, ptr %269, align 8, !noalias !14
  %271 = icmp sgt i64 %270, 0
  br i1 %271, label %272, label %281

272:                                              ; preds = %265, %272
  %273 = phi i64 [ %279, %272 ], [ 0, %265 ]
  %274 = phi double [ %278, %272 ], [ %267, %265 ]
  %275 = getelementptr inbounds double, ptr %266, i64 %273
  %276 = load double, ptr %275, align 8, !noalias !9
  %277 = fcmp olt double %276, %274
  %278 = select i1 %277, double %276, double %274
  %279 = add nuw nsw i64 %273, 1
  %280 = icmp eq i64 %279, %270
  br i1 %280, label %281, label %272, !llvm.loop !15

281:                                              ; preds = %272, %265
  %282 = phi double [ %267, %265 ], [ %278, %272 ]
  %283 = load ptr, ptr %61, align 8, !noalias !16
  %284 = getelementptr inbounds i8, ptr %283, i64 8
  %285 = load i64, ptr %284, align 8, !noalias !16
  %286 = and i64 %285, %222
  %287 = icmp eq i64 %286, 0
  br i1 %287, label %351, label %288

288:                                              ; preds = %281
  %289 = load i64, ptr %283, align 8, !noalias !16
  %290 = icmp eq i64 %289, 0
  br i1 %290, label %314, label %291

291:                                              ; preds = %288
  %292 = load ptr, ptr %64, align 8, !noalias !16
  %293 = load ptr, ptr %65, align 8, !noalias !16
  store <8 x double> %226, ptr %293, align 8, !noalias !16
  %294 = load ptr, ptr %15, align 8, !noalias !16
  %295 = getelementptr inbounds i8, ptr %294, i64 40
  %296 = load i64, ptr %295, align 8, !noalias !16
  %297 = icmp eq i64 %296, 0
  br i1 %297, label %299, label %298

298:                                              ; preds = %291
  call fastcc void @settle(ptr noundef nonnull %15) #10, !noalias !16
  br label %299

299:                                              ; preds = %298, %291
  %300 = load i64, ptr %66, align 8, !noalias !16
  %301 = icmp sgt i64 %300, 0
  br i1 %301, label %302, label %303

302:                                              ; preds = %299
  call fastcc void @sample(ptr noundef nonnull %15) #10, !noalias !16
  br label %303

303:                                              ; preds = %302, %299
  %304 = load ptr, ptr %61, align 8, !noalias !16
  %305 = load i64, ptr %304, align 8, !noalias !16
  %306 = load ptr, ptr %65, align 8, !noalias !16
  %307 = load ptr, ptr %17, align 8, !noalias !16
  %308 = load ptr, ptr %67, align 8, !noalias !16
  %309 = load ptr, ptr %68, align 8, !noalias !16
  %310 = inttoptr i64 %305 to ptr
  %311 = load ptr, ptr %310, align 8, !noalias !16
  %312 = call i32 %311(ptr noundef %306, ptr noundef %307, ptr noundef %308, ptr noundef %309, ptr noundef %292) #11, !noalias !16
  %313 = sext i32 %312 to i64
  br label %314

314:                                              ; preds = %288, %303
  %315 = phi i64 [ %313, %303 ], [ 0, %288 ]
  %316 = load i64, ptr %69, align 8, !noalias !16
  %317 = icmp sgt i64 %316, 7
  br i1 %317, label %318, label %339

318:                                              ; preds = %314
  %319 = trunc i64 %286 to i8
  %320 = bitcast i8 %319 to <8 x i1>
  br label %321

321:                                              ; preds = %318, %321
  %322 = phi i64 [ 0, %318 ], [ %335, %321 ]
  %323 = load ptr, ptr %64, align 8, !noalias !16
  %324 = shl nsw i64 %322, 6
  %325 = getelementptr inbounds i8, ptr %323, i64 %324
  %326 = load <8 x double>, ptr %325, align 8, !noalias !16
  %327 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %326)
  %328 = fcmp one <8 x double> %327, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %329 = bitcast <8 x double> %326 to <8 x i64>
  %330 = select <8 x i1> %328, <8 x i64> %329, <8 x i64> zeroinitializer
  %331 = load ptr, ptr %63, align 8, !noalias !16
  %332 = getelementptr inbounds i8, ptr %331, i64 %324
  %333 = load <8 x i64>, ptr %332, align 8, !noalias !16
  %334 = select <8 x i1> %320, <8 x i64> %330, <8 x i64> %333
  store <8 x i64> %334, ptr %332, align 8, !noalias !16
  %335 = add nuw nsw i64 %322, 1
  %336 = load i64, ptr %69, align 8, !noalias !16
  %337 = sdiv i64 %336, 8
  %338 = icmp slt i64 %335, %337
  br i1 %338, label %321, label %339, !llvm.loop !19

339:                                              ; preds = %321, %314
  %340 = icmp slt i64 %315, 0
  br i1 %340, label %1405, label %341

341:                                              ; preds = %339
  %342 = xor i64 %286, -1
  %343 = load i64, ptr %284, align 8, !noalias !16
  %344 = and i64 %343, %342
  store i64 %344, ptr %284, align 8, !noalias !16
  %345 = getelementptr inbounds i8, ptr %283, i64 16
  %346 = load i64, ptr %345, align 8, !noalias !16
  %347 = or i64 %346, %286
  store i64 %347, ptr %345, align 8, !noalias !16
  %348 = getelementptr inbounds i8, ptr %283, i64 24
  %349 = load i64, ptr %348, align 8, !noalias !16
  %350 = and i64 %349, %342
  store i64 %350, ptr %348, align 8, !noalias !16
  br label %351

351:                                              ; preds = %341, %281
  %352 = load ptr, ptr %61, align 8, !noalias !16
  %353 = load ptr, ptr %70, align 8, !noalias !16
  %354 = load <8 x double>, ptr %353, align 8, !noalias !16
  %355 = fsub <8 x double> %242, %354
  %356 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %355)
  %357 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %238)
  %358 = fmul <8 x double> %357, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %359 = fcmp ogt <8 x double> %356, %358
  %360 = bitcast <8 x i1> %359 to i8
  %361 = zext i8 %360 to i64
  %362 = getelementptr inbounds i8, ptr %352, i64 24
  %363 = load i64, ptr %362, align 8, !noalias !16
  %364 = xor i64 %363, -1
  %365 = or i64 %361, %364
  %366 = and i64 %365, %222
  %367 = icmp eq i64 %366, 0
  br i1 %367, label %437, label %368

368:                                              ; preds = %351
  %369 = trunc i64 %366 to i8
  %370 = bitcast i8 %369 to <8 x i1>
  %371 = bitcast <8 x double> %354 to <8 x i64>
  %372 = select <8 x i1> %370, <8 x i64> %241, <8 x i64> %371
  store <8 x i64> %372, ptr %353, align 8, !noalias !16
  %373 = load i64, ptr %71, align 8, !noalias !16
  %374 = sdiv i64 %373, 8
  %375 = load ptr, ptr %72, align 8, !noalias !16
  %376 = load ptr, ptr %73, align 8, !noalias !16
  %377 = icmp sgt i64 %373, 7
  br i1 %377, label %378, label %411

378:                                              ; preds = %368
  %379 = bitcast <8 x i64> %372 to <8 x double>
  %380 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %379
  %381 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %379
  %382 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %379
  br label %383

383:                                              ; preds = %378, %386
  %384 = phi i64 [ 0, %378 ], [ %387, %386 ]
  %385 = mul nuw nsw i64 %384, %374
  br label %389

386:                                              ; preds = %389
  %387 = add nuw nsw i64 %384, 1
  %388 = icmp eq i64 %387, %374
  br i1 %388, label %411, label %383, !llvm.loop !20

389:                                              ; preds = %383, %389
  %390 = phi i64 [ 0, %383 ], [ %409, %389 ]
  %391 = load ptr, ptr %74, align 8, !noalias !16
  %392 = add nuw nsw i64 %390, %385
  %393 = shl nsw i64 %392, 6
  %394 = getelementptr inbounds i8, ptr %391, i64 %393
  %395 = load <8 x double>, ptr %394, align 8, !noalias !16
  %396 = fneg <8 x double> %395
  %397 = icmp eq i64 %384, %390
  %398 = fsub <8 x double> %380, %395
  %399 = select i1 %397, <8 x double> %398, <8 x double> %396
  %400 = fsub <8 x double> %381, %395
  %401 = select i1 %397, <8 x double> %400, <8 x double> %396
  %402 = getelementptr inbounds i8, ptr %375, i64 %393
  store <8 x double> %399, ptr %402, align 8, !noalias !16
  %403 = select i1 %397, <8 x double> %382, <8 x double> zeroinitializer
  %404 = shl i64 %392, 7
  %405 = shl nsw i64 %392, 7
  %406 = getelementptr inbounds i8, ptr %376, i64 %405
  store <8 x double> %401, ptr %406, align 8, !noalias !16
  %407 = or disjoint i64 %404, 64
  %408 = getelementptr inbounds i8, ptr %376, i64 %407
  store <8 x double> %403, ptr %408, align 8, !noalias !16
  %409 = add nuw nsw i64 %390, 1
  %410 = icmp eq i64 %409, %374
  br i1 %410, label %386, label %389, !llvm.loop !21

411:                                              ; preds = %386, %368
  %412 = load ptr, ptr %75, align 8, !noalias !16
  %413 = call fastcc i64 @real_factorise(ptr noundef %375, i64 noundef %374, ptr noundef %412) #10, !noalias !16
  %414 = load ptr, ptr %76, align 8, !noalias !16
  %415 = call fastcc i64 @pair_factorise(ptr noundef %376, i64 noundef %374, ptr noundef %414) #10, !noalias !16
  %416 = or i64 %415, %413
  %417 = and i64 %416, %366
  %418 = load i64, ptr %362, align 8, !noalias !16
  %419 = or i64 %418, %366
  %420 = xor i64 %417, -1
  %421 = xor i64 %417, %419
  store i64 %421, ptr %362, align 8, !noalias !16
  %422 = trunc nuw i64 %417 to i8
  %423 = bitcast i8 %422 to <8 x i1>
  %424 = select <8 x i1> %423, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>, <8 x double> <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %425 = fmul <8 x double> %242, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %426 = select <8 x i1> %423, <8 x double> %425, <8 x double> %231
  %427 = load ptr, ptr %61, align 8, !noalias !16
  %428 = getelementptr inbounds i8, ptr %427, i64 8
  %429 = load i64, ptr %428, align 8, !noalias !16
  %430 = and i64 %429, %420
  %431 = getelementptr inbounds i8, ptr %427, i64 16
  %432 = load i64, ptr %431, align 8, !noalias !16
  %433 = xor i64 %432, -1
  %434 = and i64 %417, %433
  %435 = or disjoint i64 %434, %430
  store i64 %435, ptr %428, align 8, !noalias !16
  %436 = xor i64 %417, %222
  br label %437

437:                                              ; preds = %351, %411
  %438 = phi <8 x double> [ %231, %351 ], [ %426, %411 ]
  %439 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %351 ], [ %424, %411 ]
  %440 = phi i64 [ %222, %351 ], [ %436, %411 ]
  %441 = icmp eq i64 %440, 0
  br i1 %441, label %1405, label %442

442:                                              ; preds = %437
  %443 = fcmp ogt double %282, 0x3CB0000000000000
  %444 = select i1 %443, double %282, double 0x3CB0000000000000
  %445 = fdiv double 0x3CE4000000000000, %444
  %446 = call double @llvm.sqrt.f64(double %282)
  %447 = fcmp olt double %446, 3.000000e-02
  %448 = select i1 %447, double %446, double 3.000000e-02
  %449 = fcmp ogt double %448, %445
  %450 = load ptr, ptr %70, align 8, !noalias !16
  %451 = getelementptr inbounds i8, ptr %450, i64 64
  %452 = load <8 x double>, ptr %451, align 8, !noalias !16
  %453 = load ptr, ptr %15, align 8, !noalias !16
  %454 = getelementptr inbounds i8, ptr %453, i64 8
  %455 = load i64, ptr %454, align 8, !noalias !16
  %456 = load ptr, ptr %77, align 8, !noalias !16
  %457 = load ptr, ptr %17, align 8, !noalias !16
  %458 = load ptr, ptr %78, align 8, !noalias !16
  %459 = load ptr, ptr %79, align 8, !noalias !16
  %460 = fcmp ogt <8 x double> %452, zeroinitializer
  %461 = icmp sgt i64 %455, 0
  %462 = shl i64 %455, 7
  %463 = getelementptr i8, ptr %456, i64 %462
  %464 = mul nsw i64 %455, 3
  br label %469

465:                                              ; preds = %481
  %466 = icmp sgt i64 %455, 0
  %467 = shl i64 %455, 7
  %468 = getelementptr i8, ptr %458, i64 %467
  br label %515

469:                                              ; preds = %442, %481
  %470 = phi i64 [ 0, %442 ], [ %482, %481 ]
  %471 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %470
  %472 = load double, ptr %471, align 8, !noalias !16
  %473 = insertelement <8 x double> poison, double %472, i64 0
  %474 = shufflevector <8 x double> %473, <8 x double> poison, <8 x i32> zeroinitializer
  %475 = fmul <8 x double> %474, %242
  %476 = fdiv <8 x double> %475, %452
  %477 = fadd <8 x double> %476, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  br i1 %461, label %478, label %481

478:                                              ; preds = %469
  %479 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %477
  %480 = mul nuw nsw i64 %455, %470
  br label %484

481:                                              ; preds = %484, %469
  %482 = add nuw nsw i64 %470, 1
  %483 = icmp eq i64 %482, 3
  br i1 %483, label %465, label %469, !llvm.loop !22

484:                                              ; preds = %478, %484
  %485 = phi i64 [ 0, %478 ], [ %513, %484 ]
  %486 = shl i64 %485, 6
  %487 = getelementptr i8, ptr %463, i64 %486
  %488 = load <8 x double>, ptr %487, align 8, !noalias !16
  %489 = add nuw nsw i64 %485, %464
  %490 = shl nsw i64 %489, 6
  %491 = getelementptr inbounds i8, ptr %456, i64 %490
  %492 = load <8 x double>, ptr %491, align 8, !noalias !16
  %493 = fmul <8 x double> %477, %492
  %494 = fadd <8 x double> %488, %493
  %495 = fmul <8 x double> %479, %494
  %496 = shl nsw i64 %485, 6
  %497 = getelementptr inbounds i8, ptr %456, i64 %496
  %498 = load <8 x double>, ptr %497, align 8, !noalias !16
  %499 = add nuw nsw i64 %485, %455
  %500 = shl nsw i64 %499, 6
  %501 = getelementptr inbounds i8, ptr %456, i64 %500
  %502 = load <8 x double>, ptr %501, align 8, !noalias !16
  %503 = fadd <8 x double> %502, %495
  %504 = fmul <8 x double> %477, %503
  %505 = fadd <8 x double> %498, %504
  %506 = getelementptr inbounds i8, ptr %457, i64 %496
  %507 = load <8 x double>, ptr %506, align 8, !noalias !16
  %508 = fsub <8 x double> %505, %507
  %509 = add nuw nsw i64 %485, %480
  %510 = select <8 x i1> %460, <8 x double> %508, <8 x double> zeroinitializer
  %511 = shl nsw i64 %509, 6
  %512 = getelementptr inbounds i8, ptr %458, i64 %511
  store <8 x double> %510, ptr %512, align 8, !noalias !16
  %513 = add nuw nsw i64 %485, 1
  %514 = icmp eq i64 %513, %455
  br i1 %514, label %481, label %484, !llvm.loop !23

515:                                              ; preds = %465, %531
  %516 = phi i64 [ 0, %465 ], [ %532, %531 ]
  br i1 %466, label %517, label %531

517:                                              ; preds = %515
  %518 = mul nuw nsw i64 %455, %516
  %519 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %516
  %520 = load double, ptr %519, align 8, !noalias !16
  %521 = insertelement <8 x double> poison, double %520, i64 0
  %522 = shufflevector <8 x double> %521, <8 x double> poison, <8 x i32> zeroinitializer
  %523 = getelementptr inbounds i8, ptr %519, i64 8
  %524 = load double, ptr %523, align 8, !noalias !16
  %525 = insertelement <8 x double> poison, double %524, i64 0
  %526 = shufflevector <8 x double> %525, <8 x double> poison, <8 x i32> zeroinitializer
  %527 = getelementptr inbounds i8, ptr %519, i64 16
  %528 = load double, ptr %527, align 8, !noalias !16
  %529 = insertelement <8 x double> poison, double %528, i64 0
  %530 = shufflevector <8 x double> %529, <8 x double> poison, <8 x i32> zeroinitializer
  br label %534

531:                                              ; preds = %534, %515
  %532 = add nuw nsw i64 %516, 1
  %533 = icmp eq i64 %532, 3
  br i1 %533, label %556, label %515, !llvm.loop !24

534:                                              ; preds = %517, %534
  %535 = phi i64 [ 0, %517 ], [ %554, %534 ]
  %536 = add nuw nsw i64 %535, %518
  %537 = shl nsw i64 %535, 6
  %538 = getelementptr inbounds i8, ptr %458, i64 %537
  %539 = load <8 x double>, ptr %538, align 8, !noalias !16
  %540 = fmul <8 x double> %539, %522
  %541 = add nuw nsw i64 %535, %455
  %542 = shl nsw i64 %541, 6
  %543 = getelementptr inbounds i8, ptr %458, i64 %542
  %544 = load <8 x double>, ptr %543, align 8, !noalias !16
  %545 = fmul <8 x double> %544, %526
  %546 = fadd <8 x double> %540, %545
  %547 = shl i64 %535, 6
  %548 = getelementptr i8, ptr %468, i64 %547
  %549 = load <8 x double>, ptr %548, align 8, !noalias !16
  %550 = fmul <8 x double> %549, %530
  %551 = fadd <8 x double> %546, %550
  %552 = shl nsw i64 %536, 6
  %553 = getelementptr inbounds i8, ptr %459, i64 %552
  store <8 x double> %551, ptr %553, align 8, !noalias !16
  %554 = add nuw nsw i64 %535, 1
  %555 = icmp eq i64 %554, %455
  br i1 %555, label %531, label %534, !llvm.loop !25

556:                                              ; preds = %531
  %557 = select i1 %449, double %448, double %445
  %558 = fmul double %282, %557
  %559 = load ptr, ptr %61, align 8, !noalias !26
  %560 = getelementptr inbounds i8, ptr %559, i64 40
  %561 = load i64, ptr %560, align 8, !noalias !26
  %562 = icmp sgt i64 %561, 0
  %563 = select i1 %562, i64 10, i64 6
  %564 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %242
  %565 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %242
  %566 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %242
  %567 = fneg <8 x double> %565
  %568 = insertelement <8 x double> poison, double %557, i64 0
  %569 = shufflevector <8 x double> %568, <8 x double> poison, <8 x i32> zeroinitializer
  %570 = fmul double %558, %558
  %571 = insertelement <8 x double> poison, double %570, i64 0
  %572 = shufflevector <8 x double> %571, <8 x double> poison, <8 x i32> zeroinitializer
  br label %576

573:                                              ; preds = %1075
  %574 = add nuw nsw i64 %580, 1
  %575 = icmp eq i64 %574, %563
  br i1 %575, label %1089, label %576, !llvm.loop !29

576:                                              ; preds = %556, %573
  %577 = phi <8 x double> [ <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>, %556 ], [ %1087, %573 ]
  %578 = phi i64 [ %440, %556 ], [ %1086, %573 ]
  %579 = phi i64 [ 0, %556 ], [ %1085, %573 ]
  %580 = phi i64 [ 0, %556 ], [ %574, %573 ]
  %581 = phi i64 [ 0, %556 ], [ %1083, %573 ]
  %582 = phi i64 [ 0, %556 ], [ %669, %573 ]
  %583 = phi <8 x double> [ zeroinitializer, %556 ], [ %668, %573 ]
  %584 = phi <8 x double> [ zeroinitializer, %556 ], [ %1082, %573 ]
  %585 = phi <8 x double> [ zeroinitializer, %556 ], [ %1081, %573 ]
  %586 = phi <8 x double> [ %140, %556 ], [ %1080, %573 ]
  %587 = phi <8 x double> [ %139, %556 ], [ %1079, %573 ]
  %588 = phi <8 x double> [ %138, %556 ], [ %1078, %573 ]
  %589 = phi i64 [ %137, %556 ], [ %1077, %573 ]
  %590 = phi i64 [ %136, %556 ], [ %1076, %573 ]
  %591 = icmp ugt i64 %580, 5
  %592 = select i1 %591, i64 %581, i64 -1
  %593 = and i64 %578, %592
  %594 = load ptr, ptr %15, align 8, !noalias !26
  %595 = getelementptr inbounds i8, ptr %594, i64 8
  %596 = load i64, ptr %595, align 8, !noalias !26
  %597 = load ptr, ptr %78, align 8, !noalias !26
  %598 = icmp eq i64 %593, 0
  br i1 %598, label %667, label %599

599:                                              ; preds = %576
  %600 = icmp sgt i64 %596, 0
  %601 = shl i64 %596, 6
  br label %602

602:                                              ; preds = %599, %634
  %603 = phi i64 [ %593, %599 ], [ %647, %634 ]
  %604 = phi i64 [ 0, %599 ], [ %648, %634 ]
  %605 = phi i64 [ %582, %599 ], [ %645, %634 ]
  %606 = phi <8 x double> [ %583, %599 ], [ %613, %634 ]
  br i1 %600, label %607, label %609

607:                                              ; preds = %602
  %608 = mul nuw nsw i64 %604, %596
  br label %652

609:                                              ; preds = %652, %602
  %610 = trunc i64 %603 to i8
  %611 = bitcast i8 %610 to <8 x i1>
  %612 = select <8 x i1> %611, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %613 = fadd <8 x double> %606, %612
  %614 = load ptr, ptr %81, align 8, !noalias !26
  %615 = mul i64 %601, %604
  %616 = getelementptr inbounds i8, ptr %614, i64 %615
  %617 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %604
  %618 = load double, ptr %617, align 8, !noalias !26
  %619 = insertelement <8 x double> poison, double %618, i64 0
  %620 = shufflevector <8 x double> %619, <8 x double> poison, <8 x i32> zeroinitializer
  %621 = fmul <8 x double> %620, %242
  %622 = fadd <8 x double> %226, %621
  %623 = load ptr, ptr %82, align 8, !noalias !26
  %624 = load ptr, ptr %83, align 8, !noalias !26
  store <8 x double> %622, ptr %624, align 8, !noalias !26
  %625 = load ptr, ptr %15, align 8, !noalias !26
  %626 = getelementptr inbounds i8, ptr %625, i64 40
  %627 = load i64, ptr %626, align 8, !noalias !26
  %628 = icmp eq i64 %627, 0
  br i1 %628, label %630, label %629

629:                                              ; preds = %609
  call fastcc void @settle(ptr noundef nonnull %15) #10, !noalias !26
  br label %630

630:                                              ; preds = %629, %609
  %631 = load i64, ptr %84, align 8, !noalias !26
  %632 = icmp sgt i64 %631, 0
  br i1 %632, label %633, label %634

633:                                              ; preds = %630
  call fastcc void @sample(ptr noundef nonnull %15) #10, !noalias !26
  br label %634

634:                                              ; preds = %633, %630
  %635 = load ptr, ptr %15, align 8, !noalias !26
  %636 = load i64, ptr %635, align 8, !noalias !26
  %637 = load ptr, ptr %83, align 8, !noalias !26
  %638 = load ptr, ptr %85, align 8, !noalias !26
  %639 = load ptr, ptr %86, align 8, !noalias !26
  %640 = inttoptr i64 %636 to ptr
  %641 = load ptr, ptr %640, align 8, !noalias !26
  %642 = call i32 %641(ptr noundef %637, ptr noundef %623, ptr noundef %638, ptr noundef %639, ptr noundef %616) #11, !noalias !26
  %643 = sext i32 %642 to i64
  %644 = and i64 %603, %643
  %645 = or i64 %644, %605
  %646 = xor i64 %643, -1
  %647 = and i64 %603, %646
  %648 = add nuw nsw i64 %604, 1
  %649 = icmp ult i64 %604, 2
  %650 = icmp ne i64 %647, 0
  %651 = select i1 %649, i1 %650, i1 false
  br i1 %651, label %602, label %667, !llvm.loop !30

652:                                              ; preds = %607, %652
  %653 = phi i64 [ 0, %607 ], [ %665, %652 ]
  %654 = load ptr, ptr %80, align 8, !noalias !26
  %655 = load ptr, ptr %17, align 8, !noalias !26
  %656 = shl nsw i64 %653, 6
  %657 = getelementptr inbounds i8, ptr %655, i64 %656
  %658 = load <8 x double>, ptr %657, align 8, !noalias !26
  %659 = add nuw nsw i64 %653, %608
  %660 = shl nsw i64 %659, 6
  %661 = getelementptr inbounds i8, ptr %597, i64 %660
  %662 = load <8 x double>, ptr %661, align 8, !noalias !26
  %663 = fadd <8 x double> %658, %662
  %664 = getelementptr inbounds i8, ptr %654, i64 %656
  store <8 x double> %663, ptr %664, align 8, !noalias !26
  %665 = add nuw nsw i64 %653, 1
  %666 = icmp eq i64 %665, %596
  br i1 %666, label %609, label %652, !llvm.loop !31

667:                                              ; preds = %634, %576
  %668 = phi <8 x double> [ %583, %576 ], [ %613, %634 ]
  %669 = phi i64 [ %582, %576 ], [ %645, %634 ]
  %670 = phi i64 [ %593, %576 ], [ %647, %634 ]
  %671 = icmp eq i64 %670, 0
  br i1 %671, label %672, label %676

672:                                              ; preds = %667
  %673 = or i64 %593, %579
  %674 = xor i64 %673, -1
  %675 = and i64 %581, %674
  br label %1075

676:                                              ; preds = %667
  %677 = load ptr, ptr %15, align 8, !noalias !26
  %678 = getelementptr inbounds i8, ptr %677, i64 8
  %679 = load i64, ptr %678, align 8, !noalias !26
  %680 = load ptr, ptr %87, align 8, !noalias !26
  %681 = load ptr, ptr %79, align 8, !noalias !26
  %682 = icmp sgt i64 %679, 0
  br i1 %682, label %683, label %769

683:                                              ; preds = %676
  %684 = shl i64 %679, 7
  br label %685

685:                                              ; preds = %683, %685
  %686 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %683 ], [ %704, %685 ]
  %687 = phi i64 [ 0, %683 ], [ %767, %685 ]
  %688 = phi <8 x double> [ zeroinitializer, %683 ], [ %766, %685 ]
  %689 = shl nsw i64 %687, 6
  %690 = getelementptr inbounds i8, ptr %680, i64 %689
  %691 = load <8 x double>, ptr %690, align 8, !noalias !26
  %692 = add nuw nsw i64 %687, %679
  %693 = shl nsw i64 %692, 6
  %694 = getelementptr inbounds i8, ptr %680, i64 %693
  %695 = load <8 x double>, ptr %694, align 8, !noalias !26
  %696 = fadd <8 x double> %691, %695
  %697 = shl i64 %687, 6
  %698 = add i64 %697, %684
  %699 = getelementptr inbounds i8, ptr %680, i64 %698
  %700 = load <8 x double>, ptr %699, align 8, !noalias !26
  %701 = fadd <8 x double> %696, %700
  %702 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %701)
  %703 = fcmp one <8 x double> %702, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %704 = select <8 x i1> %703, <8 x i64> %686, <8 x i64> zeroinitializer
  %705 = getelementptr inbounds i8, ptr %681, i64 %693
  %706 = load <8 x double>, ptr %705, align 8, !noalias !26
  %707 = getelementptr inbounds i8, ptr %681, i64 %698
  %708 = load <8 x double>, ptr %707, align 8, !noalias !26
  %709 = fmul <8 x double> %691, <double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46>
  %710 = fmul <8 x double> %695, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %711 = fsub <8 x double> %709, %710
  %712 = fmul <8 x double> %700, <double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221>
  %713 = fadd <8 x double> %711, %712
  %714 = fmul <8 x double> %691, <double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2>
  %715 = fmul <8 x double> %695, <double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598>
  %716 = fsub <8 x double> %714, %715
  %717 = fmul <8 x double> %700, <double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1>
  %718 = fadd <8 x double> %716, %717
  %719 = fmul <8 x double> %691, <double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46>
  %720 = fmul <8 x double> %695, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %721 = fadd <8 x double> %719, %720
  %722 = fmul <8 x double> %700, <double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF>
  %723 = fadd <8 x double> %721, %722
  %724 = getelementptr inbounds i8, ptr %681, i64 %689
  %725 = load <8 x double>, ptr %724, align 8, !noalias !26
  %726 = fmul <8 x double> %566, %725
  %727 = fsub <8 x double> %723, %726
  %728 = fmul <8 x double> %708, %567
  %729 = call <8 x double> @llvm.fma.v8f64(<8 x double> %564, <8 x double> %706, <8 x double> %728)
  %730 = fmul <8 x double> %565, %706
  %731 = call <8 x double> @llvm.fma.v8f64(<8 x double> %564, <8 x double> %708, <8 x double> %730)
  %732 = fsub <8 x double> %713, %729
  %733 = fsub <8 x double> %718, %731
  %734 = load ptr, ptr %88, align 8, !noalias !26
  %735 = getelementptr inbounds i8, ptr %734, i64 %689
  store <8 x double> %727, ptr %735, align 8, !noalias !26
  %736 = load ptr, ptr %89, align 8, !noalias !26
  %737 = shl i64 %687, 7
  %738 = shl nsw i64 %687, 7
  %739 = getelementptr inbounds i8, ptr %736, i64 %738
  store <8 x double> %732, ptr %739, align 8, !noalias !26
  %740 = or disjoint i64 %737, 64
  %741 = getelementptr inbounds i8, ptr %736, i64 %740
  store <8 x double> %733, ptr %741, align 8, !noalias !26
  %742 = load ptr, ptr %17, align 8, !noalias !26
  %743 = getelementptr inbounds i8, ptr %742, i64 %689
  %744 = load <8 x double>, ptr %743, align 8, !noalias !26
  %745 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %727)
  %746 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %732)
  %747 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %733)
  %748 = fadd <8 x double> %747, %746
  %749 = fadd <8 x double> %745, %748
  %750 = fmul <8 x double> %749, %242
  %751 = load ptr, ptr %90, align 8, !noalias !26
  %752 = getelementptr inbounds double, ptr %751, i64 %687
  %753 = load double, ptr %752, align 8, !noalias !26
  %754 = insertelement <8 x double> poison, double %753, i64 0
  %755 = shufflevector <8 x double> %754, <8 x double> poison, <8 x i32> zeroinitializer
  %756 = load ptr, ptr %62, align 8, !noalias !26
  %757 = getelementptr inbounds double, ptr %756, i64 %687
  %758 = load double, ptr %757, align 8, !noalias !26
  %759 = insertelement <8 x double> poison, double %758, i64 0
  %760 = shufflevector <8 x double> %759, <8 x double> poison, <8 x i32> zeroinitializer
  %761 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %744)
  %762 = fmul <8 x double> %761, %760
  %763 = fadd <8 x double> %755, %762
  %764 = fdiv <8 x double> %750, %763
  %765 = fmul <8 x double> %764, %764
  %766 = fadd <8 x double> %688, %765
  %767 = add nuw nsw i64 %687, 1
  %768 = icmp eq i64 %767, %679
  br i1 %768, label %769, label %685, !llvm.loop !32

769:                                              ; preds = %685, %676
  %770 = phi <8 x double> [ zeroinitializer, %676 ], [ %766, %685 ]
  %771 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %676 ], [ %704, %685 ]
  %772 = icmp ne <8 x i64> %771, zeroinitializer
  %773 = bitcast <8 x i1> %772 to i8
  %774 = zext i8 %773 to i64
  %775 = and i64 %670, %774
  %776 = xor i64 %775, %670
  %777 = trunc i64 %776 to i8
  %778 = bitcast i8 %777 to <8 x i1>
  %779 = load ptr, ptr %15, align 8, !noalias !26
  %780 = getelementptr inbounds i8, ptr %779, i64 8
  %781 = load i64, ptr %780, align 8, !noalias !26
  %782 = load i64, ptr %92, align 8, !noalias !26
  %783 = sdiv i64 %782, 8
  %784 = load ptr, ptr %61, align 8, !noalias !26
  %785 = getelementptr inbounds i8, ptr %784, i64 40
  %786 = load i64, ptr %785, align 8, !noalias !26
  %787 = load ptr, ptr %93, align 8, !noalias !26
  %788 = load ptr, ptr %94, align 8, !noalias !26
  %789 = load ptr, ptr %95, align 8, !noalias !26
  %790 = load ptr, ptr %91, align 8, !noalias !26
  call fastcc void @real_solve(ptr noundef %789, i64 noundef %783, ptr noundef %790, ptr noundef %787) #10, !noalias !26
  %791 = load ptr, ptr %96, align 8, !noalias !26
  %792 = load ptr, ptr %97, align 8, !noalias !26
  call fastcc void @pair_solve(ptr noundef %791, i64 noundef %783, ptr noundef %792, ptr noundef %788) #10, !noalias !26
  %793 = icmp sgt i64 %786, 0
  br i1 %793, label %794, label %803

794:                                              ; preds = %769
  %795 = load ptr, ptr %95, align 8, !noalias !26
  %796 = load ptr, ptr %91, align 8, !noalias !26
  %797 = shl nsw i64 %783, 6
  %798 = getelementptr inbounds i8, ptr %787, i64 %797
  call fastcc void @real_solve_columns(ptr noundef %795, i64 noundef %783, ptr noundef %796, ptr noundef %798, i64 noundef %786) #10, !noalias !26
  %799 = load ptr, ptr %96, align 8, !noalias !26
  %800 = load ptr, ptr %97, align 8, !noalias !26
  %801 = shl nsw i64 %783, 7
  %802 = getelementptr inbounds i8, ptr %788, i64 %801
  call fastcc void @pair_solve_columns(ptr noundef %799, i64 noundef %783, ptr noundef %800, ptr noundef %802, i64 noundef %786) #10, !noalias !26
  br label %803

803:                                              ; preds = %794, %769
  %804 = icmp sgt i64 %781, 0
  br i1 %804, label %805, label %846

805:                                              ; preds = %803
  %806 = load ptr, ptr %17, align 8, !noalias !26
  %807 = load ptr, ptr %98, align 8, !noalias !26
  %808 = load ptr, ptr %62, align 8, !noalias !26
  br label %809

809:                                              ; preds = %805, %809
  %810 = phi <8 x double> [ zeroinitializer, %805 ], [ %843, %809 ]
  %811 = phi i64 [ 0, %805 ], [ %844, %809 ]
  %812 = shl nsw i64 %811, 6
  %813 = getelementptr inbounds i8, ptr %806, i64 %812
  %814 = load <8 x double>, ptr %813, align 8, !noalias !26
  %815 = getelementptr inbounds double, ptr %807, i64 %811
  %816 = load double, ptr %815, align 8, !noalias !26
  %817 = insertelement <8 x double> poison, double %816, i64 0
  %818 = shufflevector <8 x double> %817, <8 x double> poison, <8 x i32> zeroinitializer
  %819 = getelementptr inbounds double, ptr %808, i64 %811
  %820 = load double, ptr %819, align 8, !noalias !26
  %821 = insertelement <8 x double> poison, double %820, i64 0
  %822 = shufflevector <8 x double> %821, <8 x double> poison, <8 x i32> zeroinitializer
  %823 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %814)
  %824 = fmul <8 x double> %823, %822
  %825 = fadd <8 x double> %818, %824
  %826 = getelementptr inbounds i8, ptr %787, i64 %812
  %827 = load <8 x double>, ptr %826, align 8, !noalias !26
  %828 = fdiv <8 x double> %827, %825
  %829 = shl i64 %811, 7
  %830 = shl nsw i64 %811, 7
  %831 = getelementptr inbounds i8, ptr %788, i64 %830
  %832 = load <8 x double>, ptr %831, align 8, !noalias !33
  %833 = or disjoint i64 %829, 64
  %834 = getelementptr inbounds i8, ptr %788, i64 %833
  %835 = load <8 x double>, ptr %834, align 8, !noalias !33
  %836 = fdiv <8 x double> %832, %825
  %837 = fdiv <8 x double> %835, %825
  %838 = fmul <8 x double> %828, %828
  %839 = fmul <8 x double> %836, %836
  %840 = fadd <8 x double> %838, %839
  %841 = fmul <8 x double> %837, %837
  %842 = fadd <8 x double> %841, %840
  %843 = fadd <8 x double> %810, %842
  %844 = add nuw nsw i64 %811, 1
  %845 = icmp eq i64 %844, %781
  br i1 %845, label %846, label %809, !llvm.loop !36

846:                                              ; preds = %809, %803
  %847 = phi <8 x double> [ zeroinitializer, %803 ], [ %843, %809 ]
  %848 = mul nsw i64 %781, 3
  %849 = sitofp i64 %848 to double
  %850 = insertelement <8 x double> poison, double %849, i64 0
  %851 = shufflevector <8 x double> %850, <8 x double> poison, <8 x i32> zeroinitializer
  %852 = fdiv <8 x double> %847, %851
  %853 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %852)
  %854 = fcmp oeq <8 x double> %853, zeroinitializer
  %855 = fcmp ogt <8 x double> %770, zeroinitializer
  %856 = and <8 x i1> %854, %855
  %857 = bitcast <8 x i1> %856 to i8
  %858 = zext i8 %857 to i64
  %859 = xor i64 %858, -1
  %860 = and i64 %775, %859
  %861 = xor i64 %581, -1
  %862 = and i64 %860, %861
  %863 = trunc nuw i64 %862 to i8
  %864 = bitcast i8 %863 to <8 x i1>
  %865 = fcmp ogt <8 x double> %577, zeroinitializer
  %866 = select <8 x i1> %865, <8 x i1> %864, <8 x i1> zeroinitializer
  %867 = fdiv <8 x double> %853, %577
  %868 = select <8 x i1> %778, <8 x double> <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, <8 x double> %584
  %869 = select <8 x i1> %866, <8 x double> %867, <8 x double> %868
  %870 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %869
  %871 = fdiv <8 x double> %853, %870
  %872 = icmp ult i64 %580, 5
  br i1 %872, label %983, label %873

873:                                              ; preds = %983, %846
  %874 = phi <8 x double> [ %871, %846 ], [ %986, %983 ]
  %875 = fcmp oge <8 x double> %869, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %876 = fcmp ogt <8 x double> %874, %569
  %877 = or <8 x i1> %876, %875
  %878 = select <8 x i1> %877, <8 x i1> %866, <8 x i1> zeroinitializer
  %879 = bitcast <8 x i1> %878 to i8
  %880 = zext i8 %879 to i64
  %881 = xor i64 %880, -1
  %882 = and i64 %860, %881
  %883 = xor i64 %882, -1
  %884 = and i64 %593, %883
  %885 = or i64 %884, %579
  %886 = load ptr, ptr %15, align 8, !noalias !26
  %887 = getelementptr inbounds i8, ptr %886, i64 8
  %888 = load i64, ptr %887, align 8, !noalias !26
  %889 = trunc nuw i64 %882 to i8
  %890 = bitcast i8 %889 to <8 x i1>
  %891 = load ptr, ptr %78, align 8, !noalias !26
  %892 = load ptr, ptr %79, align 8, !noalias !26
  %893 = icmp sgt i64 %888, 0
  br i1 %893, label %894, label %965

894:                                              ; preds = %873
  %895 = shl i64 %888, 7
  %896 = getelementptr i8, ptr %892, i64 %895
  br label %897

897:                                              ; preds = %894, %931
  %898 = phi i64 [ 0, %894 ], [ %932, %931 ]
  %899 = load ptr, ptr %94, align 8, !noalias !26
  %900 = shl i64 %898, 7
  %901 = shl nsw i64 %898, 7
  %902 = getelementptr inbounds i8, ptr %899, i64 %901
  %903 = load <8 x double>, ptr %902, align 8, !noalias !37
  %904 = or disjoint i64 %900, 64
  %905 = getelementptr inbounds i8, ptr %899, i64 %904
  %906 = load <8 x double>, ptr %905, align 8, !noalias !37
  %907 = load ptr, ptr %93, align 8, !noalias !26
  %908 = shl nsw i64 %898, 6
  %909 = getelementptr inbounds i8, ptr %907, i64 %908
  %910 = load <8 x double>, ptr %909, align 8, !noalias !26
  store <8 x double> %910, ptr %4, align 64, !noalias !26
  store <8 x double> %903, ptr %99, align 64, !noalias !26
  store <8 x double> %906, ptr %100, align 64, !noalias !26
  br label %918

911:                                              ; preds = %918
  %912 = getelementptr inbounds i8, ptr %892, i64 %908
  %913 = add nuw nsw i64 %898, %888
  %914 = shl nsw i64 %913, 6
  %915 = getelementptr inbounds i8, ptr %892, i64 %914
  %916 = shl i64 %898, 6
  %917 = getelementptr i8, ptr %896, i64 %916
  br label %934

918:                                              ; preds = %897, %918
  %919 = phi i64 [ 0, %897 ], [ %929, %918 ]
  %920 = mul nuw nsw i64 %888, %919
  %921 = add nuw nsw i64 %920, %898
  %922 = shl nsw i64 %921, 6
  %923 = getelementptr inbounds i8, ptr %892, i64 %922
  %924 = load <8 x double>, ptr %923, align 8, !noalias !26
  %925 = getelementptr inbounds [3 x <8 x double>], ptr %4, i64 0, i64 %919
  %926 = load <8 x double>, ptr %925, align 64, !noalias !26
  %927 = fadd <8 x double> %924, %926
  %928 = select <8 x i1> %890, <8 x double> %927, <8 x double> %924
  store <8 x double> %928, ptr %923, align 8, !noalias !26
  %929 = add nuw nsw i64 %919, 1
  %930 = icmp eq i64 %929, 3
  br i1 %930, label %911, label %918, !llvm.loop !40

931:                                              ; preds = %934
  %932 = add nuw nsw i64 %898, 1
  %933 = icmp eq i64 %932, %888
  br i1 %933, label %965, label %897, !llvm.loop !41

934:                                              ; preds = %911, %934
  %935 = phi i64 [ 0, %911 ], [ %963, %934 ]
  %936 = mul nuw nsw i64 %888, %935
  %937 = add nuw nsw i64 %936, %898
  %938 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %935
  %939 = load double, ptr %938, align 8, !noalias !26
  %940 = insertelement <8 x double> poison, double %939, i64 0
  %941 = shufflevector <8 x double> %940, <8 x double> poison, <8 x i32> zeroinitializer
  %942 = load <8 x double>, ptr %912, align 8, !noalias !26
  %943 = fmul <8 x double> %942, %941
  %944 = getelementptr inbounds i8, ptr %938, i64 8
  %945 = load double, ptr %944, align 8, !noalias !26
  %946 = insertelement <8 x double> poison, double %945, i64 0
  %947 = shufflevector <8 x double> %946, <8 x double> poison, <8 x i32> zeroinitializer
  %948 = load <8 x double>, ptr %915, align 8, !noalias !26
  %949 = fmul <8 x double> %948, %947
  %950 = fadd <8 x double> %943, %949
  %951 = getelementptr inbounds i8, ptr %938, i64 16
  %952 = load double, ptr %951, align 8, !noalias !26
  %953 = insertelement <8 x double> poison, double %952, i64 0
  %954 = shufflevector <8 x double> %953, <8 x double> poison, <8 x i32> zeroinitializer
  %955 = load <8 x double>, ptr %917, align 8, !noalias !26
  %956 = fmul <8 x double> %955, %954
  %957 = fadd <8 x double> %950, %956
  %958 = shl nsw i64 %937, 6
  %959 = getelementptr inbounds i8, ptr %891, i64 %958
  %960 = load <8 x i64>, ptr %959, align 8, !noalias !26
  %961 = bitcast <8 x double> %957 to <8 x i64>
  %962 = select <8 x i1> %890, <8 x i64> %961, <8 x i64> %960
  store <8 x i64> %962, ptr %959, align 8, !noalias !26
  %963 = add nuw nsw i64 %935, 1
  %964 = icmp eq i64 %963, 3
  br i1 %964, label %931, label %934, !llvm.loop !42

965:                                              ; preds = %931, %873
  %966 = fdiv <8 x double> %869, %870
  %967 = fmul <8 x double> %853, %966
  %968 = fcmp olt <8 x double> %967, %569
  %969 = and <8 x i1> %968, %865
  %970 = or <8 x i1> %969, %854
  %971 = bitcast <8 x i1> %970 to i8
  %972 = zext i8 %971 to i64
  %973 = and i64 %972, %861
  %974 = and i64 %973, %882
  %975 = trunc nuw i64 %974 to i8
  %976 = bitcast i8 %975 to <8 x i1>
  %977 = add nuw nsw i64 %580, 1
  %978 = uitofp nneg i64 %977 to double
  %979 = insertelement <8 x double> poison, double %978, i64 0
  %980 = shufflevector <8 x double> %979, <8 x double> poison, <8 x i32> zeroinitializer
  %981 = select <8 x i1> %976, <8 x double> %980, <8 x double> %585
  %982 = or i64 %974, %581
  br i1 %562, label %989, label %1068

983:                                              ; preds = %846, %983
  %984 = phi i64 [ %987, %983 ], [ %580, %846 ]
  %985 = phi <8 x double> [ %986, %983 ], [ %871, %846 ]
  %986 = fmul <8 x double> %985, %869
  %987 = add nuw nsw i64 %984, 1
  %988 = icmp ult i64 %984, 4
  br i1 %988, label %983, label %873, !llvm.loop !43

989:                                              ; preds = %965
  %990 = load i64, ptr %92, align 8, !noalias !26
  %991 = sdiv i64 %990, 8
  %992 = load ptr, ptr %61, align 8, !noalias !26
  %993 = getelementptr inbounds i8, ptr %992, i64 40
  %994 = load i64, ptr %993, align 8, !noalias !26
  %995 = load ptr, ptr %15, align 8, !noalias !26
  %996 = getelementptr inbounds i8, ptr %995, i64 8
  %997 = load i64, ptr %996, align 8, !noalias !26
  %998 = load ptr, ptr %79, align 8, !noalias !26
  %999 = icmp sgt i64 %994, 0
  br i1 %999, label %1000, label %1062

1000:                                             ; preds = %989
  %1001 = icmp sgt i64 %990, 7
  br label %1002

1002:                                             ; preds = %1000, %1010
  %1003 = phi <8 x double> [ zeroinitializer, %1000 ], [ %1018, %1010 ]
  %1004 = phi i64 [ 0, %1000 ], [ %1019, %1010 ]
  br i1 %1001, label %1005, label %1010

1005:                                             ; preds = %1002
  %1006 = add nuw i64 %1004, %991
  %1007 = load ptr, ptr %93, align 8, !noalias !26
  %1008 = load ptr, ptr %17, align 8, !noalias !26
  %1009 = load ptr, ptr %94, align 8, !noalias !26
  br label %1021

1010:                                             ; preds = %1046, %1002
  %1011 = phi <8 x double> [ zeroinitializer, %1002 ], [ %1059, %1046 ]
  %1012 = phi <8 x double> [ zeroinitializer, %1002 ], [ %1047, %1046 ]
  %1013 = fcmp ogt <8 x double> %1011, zeroinitializer
  %1014 = fdiv <8 x double> %1012, %1011
  %1015 = fmul <8 x double> %1003, %1011
  %1016 = fcmp ogt <8 x double> %1012, %1015
  %1017 = select <8 x i1> %1013, <8 x double> %1014, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1018 = select <8 x i1> %1016, <8 x double> %1017, <8 x double> %1003
  %1019 = add nuw nsw i64 %1004, 1
  %1020 = icmp eq i64 %1019, %994
  br i1 %1020, label %1062, label %1002, !llvm.loop !44

1021:                                             ; preds = %1005, %1046
  %1022 = phi <8 x double> [ zeroinitializer, %1005 ], [ %1047, %1046 ]
  %1023 = phi i64 [ 0, %1005 ], [ %1048, %1046 ]
  %1024 = phi <8 x double> [ zeroinitializer, %1005 ], [ %1059, %1046 ]
  %1025 = mul nuw nsw i64 %1023, %994
  %1026 = add i64 %1006, %1025
  %1027 = shl nsw i64 %1026, 6
  %1028 = getelementptr inbounds i8, ptr %1007, i64 %1027
  %1029 = load <8 x double>, ptr %1028, align 8, !noalias !26
  %1030 = getelementptr inbounds i8, ptr %1008, i64 %1027
  %1031 = load <8 x double>, ptr %1030, align 8, !noalias !26
  %1032 = shl i64 %1026, 7
  %1033 = shl nsw i64 %1026, 7
  %1034 = getelementptr inbounds i8, ptr %1009, i64 %1033
  %1035 = load <8 x double>, ptr %1034, align 8, !noalias !45
  %1036 = or disjoint i64 %1032, 64
  %1037 = getelementptr inbounds i8, ptr %1009, i64 %1036
  %1038 = load <8 x double>, ptr %1037, align 8, !noalias !45
  %1039 = fmul <8 x double> %1029, %1029
  %1040 = fmul <8 x double> %1035, %1035
  %1041 = fmul <8 x double> %1038, %1038
  %1042 = fadd <8 x double> %1040, %1041
  %1043 = fadd <8 x double> %1039, %1042
  %1044 = fmul <8 x double> %1031, %1031
  %1045 = fadd <8 x double> %1024, %1044
  br label %1050

1046:                                             ; preds = %1050
  %1047 = fadd <8 x double> %1022, %1043
  %1048 = add nuw nsw i64 %1023, 1
  %1049 = icmp eq i64 %1048, %991
  br i1 %1049, label %1010, label %1021, !llvm.loop !48

1050:                                             ; preds = %1021, %1050
  %1051 = phi i64 [ 0, %1021 ], [ %1060, %1050 ]
  %1052 = phi <8 x double> [ %1045, %1021 ], [ %1059, %1050 ]
  %1053 = mul nsw i64 %997, %1051
  %1054 = add nsw i64 %1053, %1026
  %1055 = shl nsw i64 %1054, 6
  %1056 = getelementptr inbounds i8, ptr %998, i64 %1055
  %1057 = load <8 x double>, ptr %1056, align 8, !noalias !26
  %1058 = fmul <8 x double> %1057, %1057
  %1059 = fadd <8 x double> %1052, %1058
  %1060 = add nuw nsw i64 %1051, 1
  %1061 = icmp eq i64 %1060, 3
  br i1 %1061, label %1046, label %1050, !llvm.loop !49

1062:                                             ; preds = %1010, %989
  %1063 = phi <8 x double> [ zeroinitializer, %989 ], [ %1018, %1010 ]
  %1064 = fcmp ole <8 x double> %1063, %572
  %1065 = bitcast <8 x i1> %1064 to i8
  %1066 = zext i8 %1065 to i64
  %1067 = and i64 %982, %1066
  br label %1068

1068:                                             ; preds = %1062, %965
  %1069 = phi i64 [ %1067, %1062 ], [ %982, %965 ]
  %1070 = xor i64 %1069, -1
  %1071 = and i64 %882, %1070
  %1072 = icmp eq i64 %1071, 0
  %1073 = select i1 %1072, i32 2, i32 0
  %1074 = select i1 %1072, <8 x double> %577, <8 x double> %853
  br label %1075

1075:                                             ; preds = %1068, %672
  %1076 = phi i64 [ %675, %672 ], [ %590, %1068 ]
  %1077 = phi i64 [ %669, %672 ], [ %589, %1068 ]
  %1078 = phi <8 x double> [ %585, %672 ], [ %588, %1068 ]
  %1079 = phi <8 x double> [ %584, %672 ], [ %587, %1068 ]
  %1080 = phi <8 x double> [ %668, %672 ], [ %586, %1068 ]
  %1081 = phi <8 x double> [ %585, %672 ], [ %981, %1068 ]
  %1082 = phi <8 x double> [ %584, %672 ], [ %869, %1068 ]
  %1083 = phi i64 [ %675, %672 ], [ %982, %1068 ]
  %1084 = phi i32 [ 1, %672 ], [ %1073, %1068 ]
  %1085 = phi i64 [ %579, %672 ], [ %885, %1068 ]
  %1086 = phi i64 [ %593, %672 ], [ %1071, %1068 ]
  %1087 = phi <8 x double> [ %577, %672 ], [ %1074, %1068 ]
  %1088 = icmp eq i32 %1084, 0
  br i1 %1088, label %573, label %1089

1089:                                             ; preds = %1075, %573
  %1090 = phi i32 [ %1084, %1075 ], [ 2, %573 ]
  %1091 = icmp eq i32 %1090, 2
  br i1 %1091, label %1092, label %1095

1092:                                             ; preds = %1089
  %1093 = xor i64 %1085, -1
  %1094 = and i64 %1083, %1093
  br label %1095

1095:                                             ; preds = %1089, %1092
  %1096 = phi i64 [ %1094, %1092 ], [ %1076, %1089 ]
  %1097 = phi i64 [ %669, %1092 ], [ %1077, %1089 ]
  %1098 = phi <8 x double> [ %1081, %1092 ], [ %1078, %1089 ]
  %1099 = phi <8 x double> [ %1082, %1092 ], [ %1079, %1089 ]
  %1100 = phi <8 x double> [ %668, %1092 ], [ %1080, %1089 ]
  %1101 = fadd <8 x double> %1100, zeroinitializer
  %1102 = fcmp ogt <8 x double> %1098, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %1103 = fcmp ogt <8 x double> %1099, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %1104 = and <8 x i1> %1103, %1102
  %1105 = bitcast <8 x i1> %1104 to i8
  %1106 = icmp eq i64 %1096, %440
  br i1 %1106, label %1183, label %1107

1107:                                             ; preds = %1095
  %1108 = xor i64 %1096, -1
  %1109 = and i64 %440, %1108
  %1110 = load ptr, ptr %61, align 8, !noalias !16
  %1111 = getelementptr inbounds i8, ptr %1110, i64 16
  %1112 = load i64, ptr %1111, align 8, !noalias !16
  %1113 = xor i64 %1097, -1
  %1114 = and i64 %1112, %1113
  %1115 = and i64 %1114, %1109
  %1116 = trunc i64 %1109 to i8
  %1117 = bitcast i8 %1116 to <8 x i1>
  %1118 = trunc i64 %1097 to i8
  %1119 = bitcast i8 %1118 to <8 x i1>
  %1120 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1099)
  %1121 = fcmp one <8 x double> %1120, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1122 = select <8 x i1> %1121, <8 x double> <double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00>, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %1123 = select <8 x i1> %1119, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1122
  %1124 = select <8 x i1> %1117, <8 x double> %1123, <8 x double> %439
  %1125 = icmp eq i64 %1115, 0
  br i1 %1125, label %1153, label %1126

1126:                                             ; preds = %1107
  %1127 = load i64, ptr %101, align 8, !noalias !16
  %1128 = icmp sgt i64 %1127, 7
  br i1 %1128, label %1129, label %1146

1129:                                             ; preds = %1126
  %1130 = trunc i64 %1115 to i8
  %1131 = bitcast i8 %1130 to <8 x i1>
  br label %1132

1132:                                             ; preds = %1129, %1132
  %1133 = phi <8 x i64> [ zeroinitializer, %1129 ], [ %1140, %1132 ]
  %1134 = phi i64 [ 0, %1129 ], [ %1142, %1132 ]
  %1135 = load ptr, ptr %102, align 8, !noalias !16
  %1136 = shl nsw i64 %1134, 6
  %1137 = getelementptr inbounds i8, ptr %1135, i64 %1136
  %1138 = load <8 x double>, ptr %1137, align 8, !noalias !16
  %1139 = fcmp une <8 x double> %1138, zeroinitializer
  %1140 = select <8 x i1> %1139, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %1133
  %1141 = select <8 x i1> %1131, <8 x double> zeroinitializer, <8 x double> %1138
  store <8 x double> %1141, ptr %1137, align 8, !noalias !16
  %1142 = add nuw nsw i64 %1134, 1
  %1143 = load i64, ptr %101, align 8, !noalias !16
  %1144 = sdiv i64 %1143, 8
  %1145 = icmp slt i64 %1142, %1144
  br i1 %1145, label %1132, label %1146, !llvm.loop !50

1146:                                             ; preds = %1132, %1126
  %1147 = phi <8 x i64> [ zeroinitializer, %1126 ], [ %1140, %1132 ]
  %1148 = icmp ne <8 x i64> %1147, zeroinitializer
  %1149 = bitcast <8 x i1> %1148 to i8
  %1150 = zext i8 %1149 to i64
  %1151 = and i64 %1115, %1150
  %1152 = xor i64 %1151, -1
  br label %1153

1153:                                             ; preds = %1107, %1146
  %1154 = phi i64 [ -1, %1107 ], [ %1152, %1146 ]
  %1155 = and i64 %1154, %1115
  %1156 = getelementptr inbounds i8, ptr %1110, i64 24
  %1157 = load i64, ptr %1156, align 8, !noalias !16
  %1158 = and i64 %1157, %1154
  store i64 %1158, ptr %1156, align 8, !noalias !16
  %1159 = xor i64 %1155, -1
  %1160 = load i64, ptr %1111, align 8, !noalias !16
  %1161 = and i64 %1160, %1159
  store i64 %1161, ptr %1111, align 8, !noalias !16
  %1162 = trunc i64 %1155 to i8
  %1163 = bitcast i8 %1162 to <8 x i1>
  %1164 = fmul <8 x double> %242, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %1165 = select <8 x i1> %1163, <8 x double> %1164, <8 x double> %438
  %1166 = fmul <8 x double> %242, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1167 = select <8 x i1> %1119, <8 x double> %1166, <8 x double> %1165
  %1168 = load ptr, ptr %70, align 8, !noalias !16
  %1169 = getelementptr inbounds i8, ptr %1168, i64 64
  %1170 = load <8 x double>, ptr %1169, align 8, !noalias !16
  %1171 = select <8 x i1> %1119, <8 x double> zeroinitializer, <8 x double> %1170
  store <8 x double> %1171, ptr %1169, align 8, !noalias !16
  %1172 = and i64 %1154, %1109
  %1173 = load ptr, ptr %61, align 8, !noalias !16
  %1174 = getelementptr inbounds i8, ptr %1173, i64 8
  %1175 = load i64, ptr %1174, align 8, !noalias !16
  %1176 = xor i64 %1172, -1
  %1177 = and i64 %1175, %1176
  %1178 = getelementptr inbounds i8, ptr %1173, i64 16
  %1179 = load i64, ptr %1178, align 8, !noalias !16
  %1180 = xor i64 %1179, -1
  %1181 = and i64 %1172, %1180
  %1182 = or disjoint i64 %1181, %1177
  store i64 %1182, ptr %1174, align 8, !noalias !16
  br label %1183

1183:                                             ; preds = %1153, %1095
  %1184 = phi <8 x double> [ %438, %1095 ], [ %1167, %1153 ]
  %1185 = phi <8 x double> [ %439, %1095 ], [ %1124, %1153 ]
  %1186 = icmp eq i64 %1096, 0
  br i1 %1186, label %1405, label %1187

1187:                                             ; preds = %1183
  %1188 = icmp sgt i64 %270, 0
  br i1 %1188, label %1189, label %1191

1189:                                             ; preds = %1187
  %1190 = shl i64 %270, 7
  br label %1389

1191:                                             ; preds = %1389, %1187
  %1192 = getelementptr inbounds i8, ptr %283, i64 32
  %1193 = load i64, ptr %1192, align 8, !noalias !16
  %1194 = load ptr, ptr %15, align 8, !noalias !16
  %1195 = getelementptr inbounds i8, ptr %1194, i64 8
  %1196 = load i64, ptr %1195, align 8, !noalias !16
  %1197 = load i64, ptr %105, align 8, !noalias !16
  %1198 = sdiv i64 %1197, 8
  %1199 = load ptr, ptr %106, align 8, !noalias !16
  %1200 = load ptr, ptr %107, align 8, !noalias !16
  %1201 = icmp sgt i64 %1196, 0
  br i1 %1201, label %1202, label %1204

1202:                                             ; preds = %1191
  %1203 = shl i64 %1196, 7
  br label %1219

1204:                                             ; preds = %1219, %1191
  %1205 = load ptr, ptr %109, align 8, !noalias !16
  %1206 = load ptr, ptr %104, align 8, !noalias !16
  call fastcc void @real_solve(ptr noundef %1205, i64 noundef %1198, ptr noundef %1206, ptr noundef %1200) #10, !noalias !16
  %1207 = load ptr, ptr %110, align 8, !noalias !16
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %1200, ptr noundef %1207, ptr noundef nonnull %17, i64 noundef %1196) #10, !noalias !16
  %1208 = load <8 x double>, ptr %5, align 16, !noalias !16
  %1209 = fcmp olt <8 x double> %1208, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1210 = bitcast <8 x i1> %1209 to i8
  %1211 = zext i8 %1210 to i64
  %1212 = xor i64 %1211, -1
  %1213 = and i64 %1193, %1212
  %1214 = and i64 %1213, %1096
  %1215 = and i64 %1096, %1211
  %1216 = icmp eq i64 %1214, 0
  br i1 %1216, label %1319, label %1217

1217:                                             ; preds = %1204
  %1218 = icmp sgt i64 %1196, 0
  br i1 %1218, label %1279, label %1247

1219:                                             ; preds = %1202, %1219
  %1220 = phi i64 [ 0, %1202 ], [ %1245, %1219 ]
  %1221 = load ptr, ptr %78, align 8, !noalias !16
  %1222 = shl nsw i64 %1220, 6
  %1223 = getelementptr inbounds i8, ptr %1221, i64 %1222
  %1224 = load <8 x double>, ptr %1223, align 8, !noalias !16
  %1225 = fmul <8 x double> %1224, <double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05>
  %1226 = add nuw nsw i64 %1220, %1196
  %1227 = shl nsw i64 %1226, 6
  %1228 = getelementptr inbounds i8, ptr %1221, i64 %1227
  %1229 = load <8 x double>, ptr %1228, align 8, !noalias !16
  %1230 = fmul <8 x double> %1229, <double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580>
  %1231 = fsub <8 x double> %1230, %1225
  %1232 = shl i64 %1220, 6
  %1233 = getelementptr i8, ptr %1221, i64 %1203
  %1234 = getelementptr i8, ptr %1233, i64 %1232
  %1235 = load <8 x double>, ptr %1234, align 8, !noalias !16
  %1236 = fmul <8 x double> %1235, <double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555>
  %1237 = fsub <8 x double> %1231, %1236
  %1238 = fdiv <8 x double> %1237, %242
  %1239 = getelementptr inbounds i8, ptr %1199, i64 %1222
  store <8 x double> %1238, ptr %1239, align 8, !noalias !16
  %1240 = load ptr, ptr %108, align 8, !noalias !16
  %1241 = getelementptr inbounds i8, ptr %1240, i64 %1222
  %1242 = load <8 x double>, ptr %1241, align 8, !noalias !16
  %1243 = fadd <8 x double> %1242, %1238
  %1244 = getelementptr inbounds i8, ptr %1200, i64 %1222
  store <8 x double> %1243, ptr %1244, align 8, !noalias !16
  %1245 = add nuw nsw i64 %1220, 1
  %1246 = icmp eq i64 %1245, %1196
  br i1 %1246, label %1204, label %1219, !llvm.loop !51

1247:                                             ; preds = %1279, %1217
  %1248 = trunc i64 %1214 to i8
  %1249 = bitcast i8 %1248 to <8 x i1>
  %1250 = select <8 x i1> %1249, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1251 = fadd <8 x double> %1101, %1250
  %1252 = load ptr, ptr %112, align 8, !noalias !16
  %1253 = load ptr, ptr %113, align 8, !noalias !16
  %1254 = load ptr, ptr %114, align 8, !noalias !16
  store <8 x double> %226, ptr %1254, align 8, !noalias !16
  %1255 = load ptr, ptr %15, align 8, !noalias !16
  %1256 = getelementptr inbounds i8, ptr %1255, i64 40
  %1257 = load i64, ptr %1256, align 8, !noalias !16
  %1258 = icmp eq i64 %1257, 0
  br i1 %1258, label %1260, label %1259

1259:                                             ; preds = %1247
  call fastcc void @settle(ptr noundef nonnull %15) #10, !noalias !16
  br label %1260

1260:                                             ; preds = %1259, %1247
  %1261 = load i64, ptr %115, align 8, !noalias !16
  %1262 = icmp sgt i64 %1261, 0
  br i1 %1262, label %1263, label %1264

1263:                                             ; preds = %1260
  call fastcc void @sample(ptr noundef nonnull %15) #10, !noalias !16
  br label %1264

1264:                                             ; preds = %1263, %1260
  %1265 = load ptr, ptr %15, align 8, !noalias !16
  %1266 = load i64, ptr %1265, align 8, !noalias !16
  %1267 = load ptr, ptr %114, align 8, !noalias !16
  %1268 = load ptr, ptr %116, align 8, !noalias !16
  %1269 = load ptr, ptr %117, align 8, !noalias !16
  %1270 = inttoptr i64 %1266 to ptr
  %1271 = load ptr, ptr %1270, align 8, !noalias !16
  %1272 = call i32 %1271(ptr noundef %1267, ptr noundef %1252, ptr noundef %1268, ptr noundef %1269, ptr noundef %1253) #11, !noalias !16
  %1273 = zext i32 %1272 to i64
  %1274 = and i64 %1214, %1273
  %1275 = trunc i64 %1274 to i8
  %1276 = bitcast i8 %1275 to <8 x i1>
  %1277 = select <8 x i1> %1276, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1185
  %1278 = icmp sgt i64 %1196, 0
  br i1 %1278, label %1307, label %1292

1279:                                             ; preds = %1217, %1279
  %1280 = phi i64 [ %1290, %1279 ], [ 0, %1217 ]
  %1281 = load ptr, ptr %111, align 8, !noalias !16
  %1282 = load ptr, ptr %17, align 8, !noalias !16
  %1283 = shl nsw i64 %1280, 6
  %1284 = getelementptr inbounds i8, ptr %1282, i64 %1283
  %1285 = load <8 x double>, ptr %1284, align 8, !noalias !16
  %1286 = getelementptr inbounds i8, ptr %1200, i64 %1283
  %1287 = load <8 x double>, ptr %1286, align 8, !noalias !16
  %1288 = fadd <8 x double> %1285, %1287
  %1289 = getelementptr inbounds i8, ptr %1281, i64 %1283
  store <8 x double> %1288, ptr %1289, align 8, !noalias !16
  %1290 = add nuw nsw i64 %1280, 1
  %1291 = icmp eq i64 %1290, %1196
  br i1 %1291, label %1247, label %1279, !llvm.loop !52

1292:                                             ; preds = %1307, %1264
  %1293 = load ptr, ptr %109, align 8, !noalias !16
  %1294 = load ptr, ptr %104, align 8, !noalias !16
  call fastcc void @real_solve(ptr noundef %1293, i64 noundef %1198, ptr noundef %1294, ptr noundef %1200) #10, !noalias !16
  %1295 = load ptr, ptr %110, align 8, !noalias !16
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1200, ptr noundef %1295, ptr noundef nonnull %17, i64 noundef %1196) #10, !noalias !16
  %1296 = load <8 x double>, ptr %6, align 16, !noalias !16
  %1297 = xor i64 %1273, -1
  %1298 = and i64 %1214, %1297
  %1299 = fcmp olt <8 x double> %1296, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1300 = bitcast <8 x i1> %1299 to i8
  %1301 = zext i8 %1300 to i64
  %1302 = and i64 %1298, %1301
  %1303 = or i64 %1302, %1215
  %1304 = trunc i64 %1298 to i8
  %1305 = bitcast i8 %1304 to <8 x i1>
  %1306 = select <8 x i1> %1305, <8 x double> %1296, <8 x double> %1208
  br label %1319

1307:                                             ; preds = %1264, %1307
  %1308 = phi i64 [ %1317, %1307 ], [ 0, %1264 ]
  %1309 = load ptr, ptr %113, align 8, !noalias !16
  %1310 = shl nsw i64 %1308, 6
  %1311 = getelementptr inbounds i8, ptr %1309, i64 %1310
  %1312 = load <8 x double>, ptr %1311, align 8, !noalias !16
  %1313 = getelementptr inbounds i8, ptr %1199, i64 %1310
  %1314 = load <8 x double>, ptr %1313, align 8, !noalias !16
  %1315 = fadd <8 x double> %1312, %1314
  %1316 = getelementptr inbounds i8, ptr %1200, i64 %1310
  store <8 x double> %1315, ptr %1316, align 8, !noalias !16
  %1317 = add nuw nsw i64 %1308, 1
  %1318 = icmp eq i64 %1317, %1196
  br i1 %1318, label %1292, label %1307, !llvm.loop !53

1319:                                             ; preds = %1204, %1292
  %1320 = phi i64 [ %1215, %1204 ], [ %1303, %1292 ]
  %1321 = phi <8 x double> [ %1101, %1204 ], [ %1251, %1292 ]
  %1322 = phi <8 x double> [ %1185, %1204 ], [ %1277, %1292 ]
  %1323 = phi <8 x double> [ %1208, %1204 ], [ %1306, %1292 ]
  %1324 = fcmp olt <8 x double> %1323, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1325 = select <8 x i1> %1324, <8 x double> <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>, <8 x double> %1323
  %1326 = load ptr, ptr %70, align 8, !noalias !16
  %1327 = getelementptr inbounds i8, ptr %1326, i64 192
  %1328 = load <8 x double>, ptr %1327, align 8, !noalias !16
  %1329 = fadd <8 x double> %1098, <double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01>
  %1330 = fdiv <8 x double> <double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667>, %1329
  %1331 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1325)
  %1332 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1331)
  %1333 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1332
  %1334 = fmul <8 x double> %1330, %1333
  %1335 = fcmp ogt <8 x double> %1334, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1336 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1323)
  %1337 = fcmp one <8 x double> %1336, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1338 = select <8 x i1> %1335, <8 x double> %1334, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1339 = select <8 x i1> %1337, <8 x double> %1338, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1340 = fmul <8 x double> %1339, %242
  %1341 = getelementptr inbounds i8, ptr %1326, i64 128
  %1342 = load <8 x double>, ptr %1341, align 8, !noalias !16
  %1343 = fdiv <8 x double> %242, %1342
  %1344 = fdiv <8 x double> %1328, %1325
  %1345 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1344)
  %1346 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1345)
  %1347 = fmul <8 x double> %1343, %1346
  %1348 = fcmp ogt <8 x double> %1328, zeroinitializer
  %1349 = fcmp olt <8 x double> %1347, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1350 = select <8 x i1> %1348, <8 x i1> %1349, <8 x i1> zeroinitializer
  %1351 = select <8 x i1> %1350, <8 x double> %1347, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1352 = fmul <8 x double> %1334, %1351
  %1353 = fcmp olt <8 x double> %1352, <double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01>
  %1354 = bitcast <8 x double> %1352 to <8 x i64>
  %1355 = select <8 x i1> %1353, <8 x i64> %1354, <8 x i64> <i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520>
  %1356 = bitcast <8 x i64> %1355 to <8 x double>
  %1357 = fcmp ule <8 x double> %1356, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1358 = fcmp uge <8 x double> %1356, <double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00>
  %1359 = or <8 x i1> %1357, %1358
  %1360 = select <8 x i1> %1359, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %1104
  %1361 = load <8 x double>, ptr %1326, align 8, !noalias !16
  %1362 = fcmp ogt <8 x double> %1356, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1363 = bitcast <8 x i64> %1355 to <8 x double>
  %1364 = select <8 x i1> %1362, <8 x double> %1363, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1365 = fmul <8 x double> %1364, %242
  %1366 = trunc nuw i64 %1320 to i8
  %1367 = bitcast i8 %1366 to <8 x i1>
  %1368 = trunc i64 %1096 to i8
  %1369 = bitcast i8 %1368 to <8 x i1>
  %1370 = select <8 x i1> %1360, <8 x double> %1365, <8 x double> %1361
  %1371 = select <8 x i1> %1367, <8 x double> %1370, <8 x double> %1340
  %1372 = select <8 x i1> %1369, <8 x double> %1371, <8 x double> %1184
  %1373 = xor i64 %1320, -1
  %1374 = and i64 %1096, %1373
  %1375 = load ptr, ptr %61, align 8, !noalias !16
  %1376 = getelementptr inbounds i8, ptr %1375, i64 32
  %1377 = load i64, ptr %1376, align 8, !noalias !16
  %1378 = or i64 %1377, %1374
  store i64 %1378, ptr %1376, align 8, !noalias !16
  %1379 = load ptr, ptr %61, align 8, !noalias !16
  %1380 = getelementptr inbounds i8, ptr %1379, i64 8
  %1381 = load i64, ptr %1380, align 8, !noalias !16
  %1382 = xor i64 %1374, -1
  %1383 = and i64 %1381, %1382
  %1384 = getelementptr inbounds i8, ptr %1379, i64 16
  %1385 = load i64, ptr %1384, align 8, !noalias !16
  %1386 = xor i64 %1385, -1
  %1387 = and i64 %1374, %1386
  %1388 = or disjoint i64 %1387, %1383
  store i64 %1388, ptr %1380, align 8, !noalias !16
  br label %1405

1389:                                             ; preds = %1189, %1389
  %1390 = phi i64 [ 0, %1189 ], [ %1403, %1389 ]
  %1391 = load ptr, ptr %103, align 8, !noalias !16
  %1392 = load ptr, ptr %17, align 8, !noalias !16
  %1393 = shl nsw i64 %1390, 6
  %1394 = getelementptr inbounds i8, ptr %1392, i64 %1393
  %1395 = load <8 x double>, ptr %1394, align 8, !noalias !16
  %1396 = load ptr, ptr %78, align 8, !noalias !16
  %1397 = shl i64 %1390, 6
  %1398 = getelementptr i8, ptr %1396, i64 %1190
  %1399 = getelementptr i8, ptr %1398, i64 %1397
  %1400 = load <8 x double>, ptr %1399, align 8, !noalias !16
  %1401 = fadd <8 x double> %1395, %1400
  %1402 = getelementptr inbounds i8, ptr %1391, i64 %1393
  store <8 x double> %1401, ptr %1402, align 8, !noalias !16
  %1403 = add nuw nsw i64 %1390, 1
  %1404 = icmp eq i64 %1403, %270
  br i1 %1404, label %1191, label %1389, !llvm.loop !54

1405:                                             ; preds = %1319, %1183, %437, %339
  %1406 = phi i64 [ %136, %339 ], [ %136, %437 ], [ %1096, %1183 ], [ %1096, %1319 ]
  %1407 = phi i64 [ %137, %339 ], [ %137, %437 ], [ %1097, %1183 ], [ %1097, %1319 ]
  %1408 = phi <8 x double> [ %138, %339 ], [ %138, %437 ], [ %1098, %1183 ], [ %1098, %1319 ]
  %1409 = phi <8 x double> [ %139, %339 ], [ %139, %437 ], [ %1099, %1183 ], [ %1099, %1319 ]
  %1410 = phi <8 x double> [ %140, %339 ], [ %140, %437 ], [ %1100, %1183 ], [ %1100, %1319 ]
  %1411 = phi i8 [ 0, %339 ], [ 0, %437 ], [ %1105, %1183 ], [ %1105, %1319 ]
  %1412 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %339 ], [ %439, %437 ], [ %1185, %1183 ], [ %1322, %1319 ]
  %1413 = phi <8 x double> [ zeroinitializer, %339 ], [ zeroinitializer, %437 ], [ zeroinitializer, %1183 ], [ %1323, %1319 ]
  %1414 = phi <8 x double> [ %231, %339 ], [ %438, %437 ], [ %1184, %1183 ], [ %1372, %1319 ]
  %1415 = phi <8 x double> [ zeroinitializer, %339 ], [ zeroinitializer, %437 ], [ %1101, %1183 ], [ %1321, %1319 ]
  %1416 = phi i64 [ 0, %339 ], [ 0, %437 ], [ 0, %1183 ], [ %1320, %1319 ]
  %1417 = zext i8 %1411 to i64
  %1418 = load ptr, ptr %16, align 8, !noalias !55
  %1419 = getelementptr inbounds i8, ptr %1418, i64 72
  %1420 = load ptr, ptr %1419, align 8
  store <8 x i64> %241, ptr %1420, align 8
  %1421 = load ptr, ptr %118, align 8, !noalias !55
  %1422 = load <8 x double>, ptr %1421, align 8
  %1423 = fadd <8 x double> %1415, %1422
  store <8 x double> %1423, ptr %1421, align 8
  %1424 = icmp ne i64 %1416, 0
  %1425 = select i1 %47, i1 %1424, i1 false
  br i1 %1425, label %1426, label %1429

1426:                                             ; preds = %1405
  store <8 x double> %238, ptr %8, align 16
  %1427 = load ptr, ptr %119, align 8
  %1428 = call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef nonnull %8, ptr noundef %1427, i64 noundef %1416, i32 noundef 1) #10
  br label %1429

1429:                                             ; preds = %1426, %1405
  %1430 = phi i64 [ %1428, %1426 ], [ 0, %1405 ]
  %1431 = xor i64 %1430, -1
  %1432 = and i64 %1416, %1431
  %1433 = load ptr, ptr %15, align 8
  %1434 = getelementptr inbounds i8, ptr %1433, i64 8
  %1435 = load i64, ptr %1434, align 8
  %1436 = load i64, ptr %120, align 8
  %1437 = load ptr, ptr %121, align 8
  %1438 = trunc nuw i64 %1432 to i8
  %1439 = load ptr, ptr %122, align 8
  %1440 = load ptr, ptr %123, align 8
  %1441 = load ptr, ptr %124, align 8
  br label %1465

1442:                                             ; preds = %1465
  %1443 = bitcast i8 %1438 to <8 x i1>
  %1444 = icmp sgt i64 %1435, 0
  br i1 %1444, label %1445, label %1534

1445:                                             ; preds = %1442
  %1446 = load <2 x double>, ptr %2, align 16
  %1447 = shufflevector <2 x double> %1446, <2 x double> poison, <8 x i32> zeroinitializer
  %1448 = load <2 x double>, ptr %125, align 8
  %1449 = shufflevector <2 x double> %1448, <2 x double> poison, <8 x i32> zeroinitializer
  %1450 = load double, ptr %126, align 16
  %1451 = insertelement <8 x double> poison, double %1450, i64 0
  %1452 = shufflevector <8 x double> %1451, <8 x double> poison, <8 x i32> zeroinitializer
  %1453 = shl i64 %1435, 7
  %1454 = getelementptr i8, ptr %1437, i64 %1453
  %1455 = load <2 x double>, ptr %3, align 16
  %1456 = shufflevector <2 x double> %1455, <2 x double> poison, <8 x i32> zeroinitializer
  %1457 = load <2 x double>, ptr %127, align 8
  %1458 = shufflevector <2 x double> %1457, <2 x double> poison, <8 x i32> zeroinitializer
  %1459 = load double, ptr %128, align 16
  %1460 = insertelement <8 x double> poison, double %1459, i64 0
  %1461 = shufflevector <8 x double> %1460, <8 x double> poison, <8 x i32> zeroinitializer
  %1462 = getelementptr inbounds double, ptr %1439, i64 %1436
  %1463 = shl nsw i64 %1436, 4
  %1464 = getelementptr inbounds i8, ptr %1439, i64 %1463
  br label %1476

1465:                                             ; preds = %1429, %1465
  %1466 = phi i64 [ 0, %1429 ], [ %1474, %1465 ]
  %1467 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1466
  %1468 = getelementptr inbounds i8, ptr %1467, i64 8
  %1469 = load double, ptr %1468, align 8
  %1470 = getelementptr inbounds [3 x double], ptr %2, i64 0, i64 %1466
  store double %1469, ptr %1470, align 8
  %1471 = getelementptr inbounds i8, ptr %1467, i64 16
  %1472 = load double, ptr %1471, align 8
  %1473 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %1466
  store double %1472, ptr %1473, align 8
  %1474 = add nuw nsw i64 %1466, 1
  %1475 = icmp eq i64 %1474, 3
  br i1 %1475, label %1442, label %1465, !llvm.loop !56

1476:                                             ; preds = %1445, %1518
  %1477 = phi i64 [ 0, %1445 ], [ %1519, %1518 ]
  %1478 = shl nsw i64 %1477, 6
  %1479 = getelementptr inbounds i8, ptr %1437, i64 %1478
  %1480 = load <8 x double>, ptr %1479, align 8
  %1481 = fmul <8 x double> %1480, %1447
  %1482 = add nuw nsw i64 %1477, %1435
  %1483 = shl nsw i64 %1482, 6
  %1484 = getelementptr inbounds i8, ptr %1437, i64 %1483
  %1485 = load <8 x double>, ptr %1484, align 8
  %1486 = fmul <8 x double> %1485, %1449
  %1487 = fadd <8 x double> %1481, %1486
  %1488 = shl i64 %1477, 6
  %1489 = getelementptr i8, ptr %1454, i64 %1488
  %1490 = load <8 x double>, ptr %1489, align 8
  %1491 = fmul <8 x double> %1490, %1452
  %1492 = fadd <8 x double> %1487, %1491
  %1493 = fmul <8 x double> %1480, %1456
  %1494 = fmul <8 x double> %1485, %1458
  %1495 = fadd <8 x double> %1493, %1494
  %1496 = fmul <8 x double> %1490, %1461
  %1497 = fadd <8 x double> %1495, %1496
  %1498 = load ptr, ptr %129, align 8
  %1499 = getelementptr inbounds i8, ptr %1498, i64 %1478
  %1500 = load <8 x double>, ptr %1499, align 8
  %1501 = load ptr, ptr %17, align 8
  %1502 = getelementptr inbounds i8, ptr %1501, i64 %1478
  %1503 = load <8 x double>, ptr %1502, align 8
  %1504 = fsub <8 x double> %1500, %1503
  %1505 = getelementptr inbounds i8, ptr %1439, i64 %1478
  store <8 x double> %1504, ptr %1505, align 8
  %1506 = fneg <8 x double> %1492
  %1507 = fsub <8 x double> %1506, %1497
  %1508 = getelementptr inbounds i8, ptr %1462, i64 %1478
  store <8 x double> %1507, ptr %1508, align 8
  %1509 = fneg <8 x double> %1497
  %1510 = getelementptr inbounds i8, ptr %1464, i64 %1478
  store <8 x double> %1509, ptr %1510, align 8
  %1511 = load ptr, ptr %17, align 8
  %1512 = getelementptr inbounds i8, ptr %1511, i64 %1478
  %1513 = load <8 x i64>, ptr %1512, align 8
  %1514 = getelementptr inbounds i8, ptr %1440, i64 %1478
  %1515 = load <8 x i64>, ptr %1514, align 8
  %1516 = select <8 x i1> %1443, <8 x i64> %1513, <8 x i64> %1515
  store <8 x i64> %1516, ptr %1514, align 8
  %1517 = getelementptr i8, ptr %1439, i64 %1478
  br label %1521

1518:                                             ; preds = %1521
  %1519 = add nuw nsw i64 %1477, 1
  %1520 = icmp eq i64 %1519, %1435
  br i1 %1520, label %1534, label %1476, !llvm.loop !57

1521:                                             ; preds = %1476, %1521
  %1522 = phi i64 [ 0, %1476 ], [ %1523, %1521 ]
  %1523 = add nuw nsw i64 %1522, 1
  %1524 = mul nuw nsw i64 %1435, %1523
  %1525 = add nuw nsw i64 %1524, %1477
  %1526 = mul nsw i64 %1436, %1522
  %1527 = getelementptr double, ptr %1517, i64 %1526
  %1528 = load <8 x i64>, ptr %1527, align 8
  %1529 = shl nsw i64 %1525, 6
  %1530 = getelementptr inbounds i8, ptr %1440, i64 %1529
  %1531 = load <8 x i64>, ptr %1530, align 8
  %1532 = select <8 x i1> %1443, <8 x i64> %1528, <8 x i64> %1531
  store <8 x i64> %1532, ptr %1530, align 8
  %1533 = icmp eq i64 %1523, 3
  br i1 %1533, label %1518, label %1521, !llvm.loop !58

1534:                                             ; preds = %1518, %1442
  %1535 = fcmp olt <8 x double> %1413, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1536 = bitcast <8 x double> %1413 to <8 x i64>
  %1537 = select <8 x i1> %1535, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>, <8 x i64> %1536
  %1538 = getelementptr inbounds i8, ptr %1441, i64 64
  %1539 = load <8 x i64>, ptr %1538, align 8
  %1540 = select <8 x i1> %1443, <8 x i64> %241, <8 x i64> %1539
  store <8 x i64> %1540, ptr %1538, align 8
  %1541 = getelementptr inbounds i8, ptr %1441, i64 128
  %1542 = load <8 x i64>, ptr %1541, align 8
  %1543 = select <8 x i1> %1443, <8 x i64> %241, <8 x i64> %1542
  store <8 x i64> %1543, ptr %1541, align 8
  %1544 = getelementptr inbounds i8, ptr %1441, i64 192
  %1545 = load <8 x i64>, ptr %1544, align 8
  %1546 = select <8 x i1> %1443, <8 x i64> %1537, <8 x i64> %1545
  store <8 x i64> %1546, ptr %1544, align 8
  %1547 = load ptr, ptr %61, align 8
  %1548 = getelementptr inbounds i8, ptr %1547, i64 8
  %1549 = load i64, ptr %1548, align 8
  %1550 = xor i64 %1432, -1
  %1551 = and i64 %1549, %1550
  %1552 = and i64 %1432, %1417
  %1553 = or disjoint i64 %1551, %1552
  store i64 %1553, ptr %1548, align 8
  %1554 = load ptr, ptr %61, align 8
  %1555 = getelementptr inbounds i8, ptr %1554, i64 16
  %1556 = load i64, ptr %1555, align 8
  %1557 = and i64 %1556, %1550
  store i64 %1557, ptr %1555, align 8
  %1558 = load ptr, ptr %61, align 8
  %1559 = getelementptr inbounds i8, ptr %1558, i64 32
  %1560 = load i64, ptr %1559, align 8
  %1561 = and i64 %1560, %1550
  store i64 %1561, ptr %1559, align 8
  %1562 = icmp ne i64 %1432, 0
  %1563 = select i1 %48, i1 %1562, i1 false
  br i1 %1563, label %1564, label %1568

1564:                                             ; preds = %1534
  %1565 = call fastcc i64 @clear_lanes(ptr noundef %0) #10
  %1566 = xor i64 %1565, -1
  %1567 = and i64 %1432, %1566
  br label %1568

1568:                                             ; preds = %1534, %1564
  %1569 = phi i64 [ %1567, %1564 ], [ 0, %1534 ]
  store i64 0, ptr %13, align 8
  %1570 = load ptr, ptr %130, align 8
  %1571 = load <8 x double>, ptr %1570, align 8
  %1572 = fcmp olt <8 x double> %1571, %238
  %1573 = bitcast <8 x i1> %1572 to i8
  %1574 = zext i8 %1573 to i64
  %1575 = and i64 %1432, %1574
  %1576 = or i64 %1575, %1569
  %1577 = icmp eq i64 %1576, 0
  br i1 %1577, label %1612, label %1578

1578:                                             ; preds = %1568
  store <8 x double> %238, ptr %8, align 16
  %1579 = icmp eq i64 %1569, 0
  br i1 %1579, label %1582, label %1580

1580:                                             ; preds = %1578
  %1581 = call fastcc i64 @look_for_events(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1569, ptr noundef nonnull %8, ptr noundef nonnull %10, ptr noundef nonnull %12, ptr noundef nonnull %9, ptr noundef nonnull %13) #10
  br label %1582

1582:                                             ; preds = %1580, %1578
  %1583 = phi i64 [ %1581, %1580 ], [ 0, %1578 ]
  %1584 = load i64, ptr %13, align 8
  %1585 = xor i64 %1584, -1
  %1586 = and i64 %1576, %1585
  %1587 = icmp eq i64 %1583, 0
  %1588 = select i1 %1587, ptr null, ptr %9
  %1589 = call fastcc i64 @write_within(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1586, ptr noundef nonnull %8, ptr noundef %1588) #10
  %1590 = load <8 x double>, ptr %8, align 16
  br i1 %1587, label %1596, label %1591

1591:                                             ; preds = %1582
  %1592 = xor i64 %1589, -1
  %1593 = and i64 %1583, %1592
  %1594 = call fastcc i64 @end_within(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1593, ptr noundef nonnull %8, ptr noundef nonnull %9) #10
  %1595 = or i64 %1594, %1589
  br label %1596

1596:                                             ; preds = %1591, %1582
  %1597 = phi i64 [ %1595, %1591 ], [ %1589, %1582 ]
  %1598 = icmp ne i64 %1597, 0
  %1599 = select i1 %48, i1 %1598, i1 false
  br i1 %1599, label %1600, label %1605

1600:                                             ; preds = %1596
  call fastcc void @retire(ptr noundef %0, i64 noundef %1597, i64 noundef 6) #10
  %1601 = xor i64 %1597, -1
  %1602 = load i64, ptr %11, align 8
  %1603 = and i64 %1602, %1601
  store i64 %1603, ptr %11, align 8
  %1604 = and i64 %1583, %1601
  br label %1605

1605:                                             ; preds = %1600, %1596
  %1606 = phi i32 [ 1, %1600 ], [ %193, %1596 ]
  %1607 = phi i64 [ %1604, %1600 ], [ %1583, %1596 ]
  %1608 = or i64 %1597, %1430
  %1609 = or i64 %1597, %1584
  %1610 = xor i64 %1609, -1
  %1611 = and i64 %1432, %1610
  br label %1612

1612:                                             ; preds = %1605, %1568
  %1613 = phi <8 x double> [ %238, %1568 ], [ %1590, %1605 ]
  %1614 = phi i64 [ 0, %1568 ], [ %1584, %1605 ]
  %1615 = phi i64 [ %1430, %1568 ], [ %1608, %1605 ]
  %1616 = phi i32 [ %193, %1568 ], [ %1606, %1605 ]
  %1617 = phi i64 [ %1432, %1568 ], [ %1611, %1605 ]
  %1618 = phi i64 [ 0, %1568 ], [ %1607, %1605 ]
  %1619 = load ptr, ptr %130, align 8
  %1620 = load <8 x double>, ptr %1619, align 8
  %1621 = fcmp oeq <8 x double> %1620, %1613
  %1622 = bitcast <8 x i1> %1621 to i8
  %1623 = zext i8 %1622 to i64
  %1624 = and i64 %1617, %1623
  %1625 = icmp eq i64 %1624, 0
  br i1 %1625, label %1626, label %1685

1626:                                             ; preds = %1685, %1612
  %1627 = trunc nuw i64 %1617 to i8
  %1628 = bitcast i8 %1627 to <8 x i1>
  %1629 = load ptr, ptr %57, align 8
  %1630 = load <8 x double>, ptr %1629, align 8
  %1631 = select <8 x i1> %1628, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1632 = fadd <8 x double> %1631, %1630
  store <8 x double> %1632, ptr %1629, align 8
  %1633 = load ptr, ptr %58, align 8
  %1634 = load <8 x double>, ptr %1633, align 8
  %1635 = xor <8 x i1> %1628, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1636 = and <8 x i1> %224, %1635
  %1637 = select <8 x i1> %1636, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1638 = fadd <8 x double> %1637, %1634
  store <8 x double> %1638, ptr %1633, align 8
  %1639 = xor i64 %1617, -1
  %1640 = and i64 %222, %1639
  %1641 = or i64 %1615, %1614
  %1642 = and i64 %1640, %1641
  %1643 = trunc i64 %1615 to i8
  %1644 = bitcast i8 %1643 to <8 x i1>
  %1645 = trunc i64 %1642 to i8
  %1646 = bitcast i8 %1645 to <8 x i1>
  %1647 = fcmp oeq <8 x double> %1613, %229
  %1648 = load ptr, ptr %54, align 8
  %1649 = load <8 x double>, ptr %1648, align 8
  %1650 = fcmp ogt <8 x double> %1649, %1414
  %1651 = and <8 x i1> %1647, %1628
  %1652 = select <8 x i1> %1651, <8 x i1> %1650, <8 x i1> zeroinitializer
  %1653 = select <8 x i1> %1652, <8 x double> %1649, <8 x double> %1414
  %1654 = fmul <8 x double> %242, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1655 = select <8 x i1> %1646, <8 x double> %1654, <8 x double> %1653
  %1656 = select <8 x i1> %1644, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %1657 = bitcast <8 x double> %1412 to <8 x i64>
  %1658 = select <8 x i1> %1646, <8 x i64> %1656, <8 x i64> %1657
  %1659 = load ptr, ptr %132, align 8
  %1660 = trunc i64 %1640 to i8
  %1661 = bitcast i8 %1660 to <8 x i1>
  %1662 = load <8 x i64>, ptr %1659, align 8
  %1663 = select <8 x i1> %1661, <8 x i64> %1658, <8 x i64> %1662
  store <8 x i64> %1663, ptr %1659, align 8
  %1664 = load ptr, ptr %61, align 8
  %1665 = getelementptr inbounds i8, ptr %1664, i64 32
  %1666 = load i64, ptr %1665, align 8
  %1667 = or i64 %1666, %1642
  store i64 %1667, ptr %1665, align 8
  %1668 = load ptr, ptr %61, align 8
  %1669 = getelementptr inbounds i8, ptr %1668, i64 8
  %1670 = load i64, ptr %1669, align 8
  %1671 = xor i64 %1642, -1
  %1672 = and i64 %1670, %1671
  %1673 = getelementptr inbounds i8, ptr %1668, i64 16
  %1674 = load i64, ptr %1673, align 8
  %1675 = xor i64 %1674, -1
  %1676 = and i64 %1642, %1675
  %1677 = or disjoint i64 %1676, %1672
  store i64 %1677, ptr %1669, align 8
  %1678 = load ptr, ptr %124, align 8
  %1679 = getelementptr inbounds i8, ptr %1678, i64 64
  %1680 = load <8 x double>, ptr %1679, align 8
  %1681 = select <8 x i1> %1646, <8 x double> zeroinitializer, <8 x double> %1680
  store <8 x double> %1681, ptr %1679, align 8
  %1682 = load ptr, ptr %54, align 8
  store <8 x double> %1655, ptr %1682, align 8
  %1683 = load ptr, ptr %45, align 8
  %1684 = select <8 x i1> %1628, <8 x double> %1613, <8 x double> %226
  store <8 x double> %1684, ptr %1683, align 8
  br i1 %133, label %1697, label %1695

1685:                                             ; preds = %1612, %1685
  %1686 = phi i64 [ %1693, %1685 ], [ %1624, %1612 ]
  %1687 = load ptr, ptr %131, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %1687, i64 noundef %1686) #10
  %1688 = load ptr, ptr %130, align 8
  %1689 = load <8 x double>, ptr %1688, align 8
  %1690 = fcmp oeq <8 x double> %1689, %1613
  %1691 = bitcast <8 x i1> %1690 to i8
  %1692 = zext i8 %1691 to i64
  %1693 = and i64 %1686, %1692
  %1694 = icmp eq i64 %1693, 0
  br i1 %1694, label %1626, label %1685, !llvm.loop !59

1695:                                             ; preds = %1697, %1626
  %1696 = icmp eq i64 %1618, 0
  br i1 %1696, label %1719, label %1709

1697:                                             ; preds = %1626, %1697
  %1698 = phi i64 [ %1707, %1697 ], [ 0, %1626 ]
  %1699 = load ptr, ptr %17, align 8
  %1700 = load ptr, ptr %134, align 8
  %1701 = shl nsw i64 %1698, 6
  %1702 = getelementptr inbounds i8, ptr %1700, i64 %1701
  %1703 = load <8 x i64>, ptr %1702, align 8
  %1704 = getelementptr inbounds i8, ptr %1699, i64 %1701
  %1705 = load <8 x i64>, ptr %1704, align 8
  %1706 = select <8 x i1> %1628, <8 x i64> %1703, <8 x i64> %1705
  store <8 x i64> %1706, ptr %1704, align 8
  %1707 = add nuw nsw i64 %1698, 1
  %1708 = icmp eq i64 %1707, %21
  br i1 %1708, label %1695, label %1697, !llvm.loop !60

1709:                                             ; preds = %1695
  %1710 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %1618, ptr noundef nonnull %12) #10
  %1711 = icmp ne i32 %1616, 0
  %1712 = icmp ne i64 %1710, %1618
  %1713 = select i1 %1711, i1 true, i1 %1712
  %1714 = zext i1 %1713 to i32
  %1715 = trunc i64 %1618 to i8
  %1716 = bitcast i8 %1715 to <8 x i1>
  %1717 = xor <8 x i1> %1716, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1718 = and <8 x i1> %1717, %1628
  br label %1719

1719:                                             ; preds = %1709, %1695
  %1720 = phi i32 [ %1714, %1709 ], [ %1616, %1695 ]
  %1721 = phi <8 x i1> [ %1718, %1709 ], [ %1628, %1695 ]
  %1722 = phi i64 [ %1710, %1709 ], [ %194, %1695 ]
  %1723 = bitcast <8 x i1> %1721 to i8
  %1724 = icmp eq i8 %1723, 0
  br i1 %1724, label %1728, label %1725

1725:                                             ; preds = %1719
  %1726 = zext i8 %1723 to i64
  %1727 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1726) #10
  br label %1728

1728:                                             ; preds = %1719, %1725
  %1729 = phi i64 [ %1727, %1725 ], [ 0, %1719 ]
  %1730 = icmp ne i32 %1720, 0
  %1731 = icmp ne i64 %1729, 0
  %1732 = or i1 %1730, %1731
  %1733 = zext i1 %1732 to i32
  %1734 = trunc nuw i64 %1729 to i8
  %1735 = bitcast i8 %1734 to <8 x i1>
  %1736 = xor <8 x i1> %1735, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1737 = and <8 x i1> %1721, %1736
  %1738 = load ptr, ptr %130, align 8
  %1739 = load <8 x double>, ptr %1738, align 8
  %1740 = fcmp oeq <8 x double> %1739, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1741 = select <8 x i1> %1740, <8 x i1> %1737, <8 x i1> zeroinitializer
  %1742 = bitcast <8 x i1> %1741 to i8
  %1743 = icmp eq i8 %1742, 0
  br i1 %1743, label %1746, label %1744

1744:                                             ; preds = %1728
  %1745 = zext i8 %1742 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %1745, i64 noundef 0) #10
  br label %1746

1746:                                             ; preds = %1744, %1728
  %1747 = phi i32 [ 1, %1744 ], [ %1733, %1728 ]
  br label %135

1748:                                             ; preds = %192, %217, %188
  %1749 = phi i64 [ 1, %188 ], [ 0, %217 ], [ 0, %192 ]
  ret i64 %1749
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 984
  %5 = getelementptr inbounds i8, ptr %0, i64 432
  %6 = load ptr, ptr %4, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 1128
  %8 = getelementptr inbounds i8, ptr %0, i64 1064
  %9 = getelementptr inbounds i8, ptr %0, i64 1056
  %10 = getelementptr inbounds i8, ptr %0, i64 936
  %11 = getelementptr inbounds i8, ptr %0, i64 1144
  %12 = getelementptr inbounds i8, ptr %0, i64 1072
  %13 = getelementptr inbounds i8, ptr %0, i64 1080
  %14 = getelementptr inbounds i8, ptr %0, i64 192
  %15 = getelementptr inbounds i8, ptr %0, i64 1096
  %16 = getelementptr inbounds i8, ptr %0, i64 1104
  %17 = getelementptr inbounds i8, ptr %0, i64 216
  %18 = getelementptr inbounds i8, ptr %0, i64 1120
  %19 = getelementptr inbounds i8, ptr %0, i64 1176
  %20 = getelementptr inbounds i8, ptr %0, i64 1704
  %21 = getelementptr inbounds i8, ptr %0, i64 1712
  %22 = getelementptr inbounds i8, ptr %0, i64 1192
  %23 = getelementptr inbounds i8, ptr %0, i64 1192
  %24 = getelementptr inbounds i8, ptr %0, i64 1208
  %25 = getelementptr inbounds i8, ptr %0, i64 1248
  %26 = getelementptr inbounds i8, ptr %0, i64 1200
  %27 = getelementptr inbounds i8, ptr %0, i64 1096
  %28 = getelementptr inbounds i8, ptr %0, i64 1232
  %29 = getelementptr inbounds i8, ptr %0, i64 1224
  %30 = getelementptr inbounds i8, ptr %0, i64 1240
  %31 = getelementptr inbounds i8, ptr %0, i64 1120
  %32 = getelementptr inbounds i8, ptr %0, i64 1464
  %33 = getelementptr inbounds i8, ptr %0, i64 1480
  %34 = getelementptr inbounds i8, ptr %0, i64 1416
  %35 = getelementptr inbounds i8, ptr %0, i64 1488
  %36 = getelementptr inbounds i8, ptr %0, i64 1504
  %37 = getelementptr inbounds i8, ptr %0, i64 1440
  %38 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %39

39:                                               ; preds = %2, %274
  %40 = phi i64 [ 0, %2 ], [ %284, %274 ]
  %41 = phi i64 [ 0, %2 ], [ %275, %274 ]
  %42 = phi i64 [ -1, %2 ], [ %283, %274 ]
  %43 = phi i64 [ 0, %2 ], [ %282, %274 ]
  %44 = load i64, ptr %6, align 8
  %45 = load i64, ptr %8, align 8
  %46 = icmp sge i64 %44, %45
  br i1 %46, label %78, label %47

47:                                               ; preds = %39
  %48 = load ptr, ptr %7, align 8
  %49 = load i64, ptr %11, align 8
  %50 = mul nsw i64 %49, %44
  %51 = getelementptr i64, ptr %48, i64 %50
  %52 = getelementptr i8, ptr %51, i64 24
  %53 = load i64, ptr %52, align 8
  %54 = icmp eq i64 %53, 0
  br i1 %54, label %78, label %73

55:                                               ; preds = %274
  %56 = getelementptr inbounds i8, ptr %0, i64 144
  store i64 %282, ptr %1, align 8
  %57 = icmp slt i64 %283, 0
  br i1 %57, label %389, label %58

58:                                               ; preds = %55
  %59 = getelementptr inbounds i8, ptr %0, i64 936
  %60 = getelementptr inbounds i8, ptr %0, i64 600
  %61 = getelementptr inbounds i8, ptr %0, i64 192
  %62 = getelementptr inbounds i8, ptr %0, i64 216
  %63 = getelementptr inbounds i8, ptr %0, i64 720
  %64 = getelementptr inbounds i8, ptr %0, i64 816
  br label %309

65:                                               ; preds = %73
  %66 = load ptr, ptr %7, align 8
  %67 = load i64, ptr %11, align 8
  %68 = mul nsw i64 %67, %75
  %69 = getelementptr i64, ptr %66, i64 %68
  %70 = getelementptr i8, ptr %69, i64 24
  %71 = load i64, ptr %70, align 8
  %72 = icmp eq i64 %71, 0
  br i1 %72, label %78, label %73, !llvm.loop !61

73:                                               ; preds = %47, %65
  %74 = phi i64 [ %75, %65 ], [ %44, %47 ]
  %75 = add nsw i64 %74, 1
  store i64 %75, ptr %6, align 8
  %76 = load i64, ptr %8, align 8
  %77 = icmp sge i64 %75, %76
  br i1 %77, label %78, label %65, !llvm.loop !61

78:                                               ; preds = %73, %65, %47, %39
  %79 = phi i64 [ %44, %39 ], [ %44, %47 ], [ %75, %65 ], [ %75, %73 ]
  %80 = phi i1 [ %46, %39 ], [ %46, %47 ], [ %77, %65 ], [ %77, %73 ]
  %81 = load ptr, ptr %10, align 8
  %82 = getelementptr inbounds i64, ptr %81, i64 %40
  %83 = load i64, ptr %82, align 8
  %84 = icmp ne i64 %83, -1
  %85 = or i1 %80, %84
  br i1 %85, label %274, label %86

86:                                               ; preds = %78
  %87 = add nsw i64 %79, 1
  store i64 %87, ptr %6, align 8
  %88 = load ptr, ptr %10, align 8
  %89 = getelementptr inbounds i64, ptr %88, i64 %40
  store i64 %79, ptr %89, align 8
  %90 = load ptr, ptr %5, align 8
  %91 = load ptr, ptr %9, align 8
  %92 = load i64, ptr %12, align 8
  %93 = mul nsw i64 %92, %79
  %94 = getelementptr inbounds double, ptr %91, i64 %93
  %95 = getelementptr double, ptr %90, i64 %40
  %96 = icmp sgt i64 %92, 0
  br i1 %96, label %97, label %106

97:                                               ; preds = %86, %97
  %98 = phi i64 [ %103, %97 ], [ 0, %86 ]
  %99 = getelementptr inbounds double, ptr %94, i64 %98
  %100 = load double, ptr %99, align 8
  %101 = shl i64 %98, 6
  %102 = getelementptr i8, ptr %95, i64 %101
  store double %100, ptr %102, align 8
  %103 = add nuw nsw i64 %98, 1
  %104 = load i64, ptr %12, align 8
  %105 = icmp slt i64 %103, %104
  br i1 %105, label %97, label %106, !llvm.loop !62

106:                                              ; preds = %97, %86
  %107 = load ptr, ptr %14, align 8
  %108 = load ptr, ptr %13, align 8
  %109 = load i64, ptr %15, align 8
  %110 = mul nsw i64 %109, %79
  %111 = getelementptr inbounds double, ptr %108, i64 %110
  %112 = getelementptr double, ptr %107, i64 %40
  %113 = icmp sgt i64 %109, 0
  br i1 %113, label %114, label %123

114:                                              ; preds = %106, %114
  %115 = phi i64 [ %120, %114 ], [ 0, %106 ]
  %116 = getelementptr inbounds double, ptr %111, i64 %115
  %117 = load double, ptr %116, align 8
  %118 = shl i64 %115, 6
  %119 = getelementptr i8, ptr %112, i64 %118
  store double %117, ptr %119, align 8
  %120 = add nuw nsw i64 %115, 1
  %121 = load i64, ptr %15, align 8
  %122 = icmp slt i64 %120, %121
  br i1 %122, label %114, label %123, !llvm.loop !62

123:                                              ; preds = %114, %106
  %124 = load ptr, ptr %17, align 8
  %125 = load ptr, ptr %16, align 8
  %126 = load i64, ptr %18, align 8
  %127 = mul nsw i64 %126, %79
  %128 = getelementptr inbounds double, ptr %125, i64 %127
  %129 = getelementptr double, ptr %124, i64 %40
  %130 = icmp sgt i64 %126, 0
  br i1 %130, label %131, label %140

131:                                              ; preds = %123, %131
  %132 = phi i64 [ %137, %131 ], [ 0, %123 ]
  %133 = getelementptr inbounds double, ptr %128, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = shl i64 %132, 6
  %136 = getelementptr i8, ptr %129, i64 %135
  store double %134, ptr %136, align 8
  %137 = add nuw nsw i64 %132, 1
  %138 = load i64, ptr %18, align 8
  %139 = icmp slt i64 %137, %138
  br i1 %139, label %131, label %140, !llvm.loop !62

140:                                              ; preds = %131, %123
  %141 = load ptr, ptr %20, align 8
  %142 = load i64, ptr %21, align 8
  %143 = getelementptr inbounds double, ptr %141, i64 %142
  %144 = load i64, ptr %22, align 8
  %145 = mul i64 %144, -64
  %146 = getelementptr inbounds i8, ptr %143, i64 %145
  %147 = load ptr, ptr %19, align 8
  %148 = mul nsw i64 %144, %79
  %149 = getelementptr inbounds double, ptr %147, i64 %148
  %150 = getelementptr double, ptr %146, i64 %40
  %151 = load i64, ptr %23, align 8
  %152 = icmp sgt i64 %151, 0
  br i1 %152, label %153, label %162

153:                                              ; preds = %140, %153
  %154 = phi i64 [ %159, %153 ], [ 0, %140 ]
  %155 = getelementptr inbounds double, ptr %149, i64 %154
  %156 = load double, ptr %155, align 8
  %157 = shl i64 %154, 6
  %158 = getelementptr i8, ptr %150, i64 %157
  store double %156, ptr %158, align 8
  %159 = add nuw nsw i64 %154, 1
  %160 = load i64, ptr %23, align 8
  %161 = icmp slt i64 %159, %160
  br i1 %161, label %153, label %162, !llvm.loop !62

162:                                              ; preds = %153, %140
  %163 = load i64, ptr %24, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %267

165:                                              ; preds = %162
  %166 = load ptr, ptr %26, align 8
  %167 = getelementptr inbounds i64, ptr %166, i64 %40
  %168 = load i64, ptr %167, align 8
  %169 = inttoptr i64 %168 to ptr
  %170 = load i64, ptr %27, align 8
  %171 = icmp sgt i64 %170, 0
  br i1 %171, label %172, label %174

172:                                              ; preds = %165
  %173 = getelementptr inbounds i8, ptr %169, i64 192
  br label %177

174:                                              ; preds = %177, %165
  %175 = load i64, ptr %28, align 8
  %176 = icmp sgt i64 %175, 0
  br i1 %176, label %198, label %190

177:                                              ; preds = %172, %177
  %178 = phi i64 [ %170, %172 ], [ %188, %177 ]
  %179 = phi i64 [ 0, %172 ], [ %187, %177 ]
  %180 = load ptr, ptr %13, align 8
  %181 = mul nsw i64 %178, %79
  %182 = getelementptr double, ptr %180, i64 %181
  %183 = getelementptr double, ptr %182, i64 %179
  %184 = load double, ptr %183, align 8
  %185 = load ptr, ptr %173, align 8
  %186 = getelementptr inbounds double, ptr %185, i64 %179
  store double %184, ptr %186, align 8
  %187 = add nuw nsw i64 %179, 1
  %188 = load i64, ptr %27, align 8
  %189 = icmp slt i64 %187, %188
  br i1 %189, label %177, label %174, !llvm.loop !64

190:                                              ; preds = %198, %174
  %191 = load ptr, ptr %25, align 8
  %192 = getelementptr inbounds i8, ptr %191, i64 8
  %193 = load i64, ptr %192, align 8
  %194 = icmp sgt i64 %193, 0
  br i1 %194, label %195, label %263

195:                                              ; preds = %190
  %196 = getelementptr inbounds i8, ptr %169, i64 1248
  %197 = getelementptr inbounds i8, ptr %169, i64 1008
  br label %218

198:                                              ; preds = %174, %198
  %199 = phi i64 [ %215, %198 ], [ 0, %174 ]
  %200 = load ptr, ptr %29, align 8
  %201 = load i64, ptr %30, align 8
  %202 = mul nsw i64 %201, %199
  %203 = getelementptr inbounds i64, ptr %200, i64 %202
  %204 = load i64, ptr %203, align 8
  %205 = inttoptr i64 %204 to ptr
  %206 = load ptr, ptr %205, align 8
  %207 = load ptr, ptr %16, align 8
  %208 = load i64, ptr %31, align 8
  %209 = mul nsw i64 %208, %79
  %210 = getelementptr inbounds double, ptr %207, i64 %209
  %211 = getelementptr i64, ptr %203, i64 %40
  %212 = getelementptr i8, ptr %211, i64 8
  %213 = load i64, ptr %212, align 8
  %214 = inttoptr i64 %213 to ptr
  tail call void %206(ptr noundef %210, ptr noundef %214) #11
  %215 = add nuw nsw i64 %199, 1
  %216 = load i64, ptr %28, align 8
  %217 = icmp slt i64 %215, %216
  br i1 %217, label %198, label %190, !llvm.loop !65

218:                                              ; preds = %195, %232
  %219 = phi i64 [ 0, %195 ], [ %241, %232 ]
  %220 = load ptr, ptr %32, align 8
  %221 = load i64, ptr %33, align 8
  %222 = mul nsw i64 %221, %79
  %223 = getelementptr i64, ptr %220, i64 %222
  %224 = getelementptr i64, ptr %223, i64 %219
  %225 = load i64, ptr %224, align 8
  %226 = sitofp i64 %225 to double
  %227 = load ptr, ptr %34, align 8
  %228 = shl i64 %219, 6
  %229 = getelementptr i8, ptr %227, i64 %228
  %230 = getelementptr double, ptr %229, i64 %40
  store double %226, ptr %230, align 8
  %231 = mul i64 %219, 800
  br label %246

232:                                              ; preds = %256
  %233 = load ptr, ptr %197, align 8
  %234 = shl nuw nsw i64 %219, 1
  %235 = or disjoint i64 %234, 1
  %236 = getelementptr inbounds double, ptr %233, i64 %235
  store double 0x7FF8000000000000, ptr %236, align 8
  %237 = load ptr, ptr %197, align 8
  %238 = getelementptr inbounds double, ptr %237, i64 %234
  store double 0x7FF8000000000000, ptr %238, align 8
  %239 = load ptr, ptr %37, align 8
  %240 = getelementptr inbounds double, ptr %239, i64 %40
  store double 0x7FF8000000000000, ptr %240, align 8
  %241 = add nuw nsw i64 %219, 1
  %242 = load ptr, ptr %25, align 8
  %243 = getelementptr inbounds i8, ptr %242, i64 8
  %244 = load i64, ptr %243, align 8
  %245 = icmp slt i64 %241, %244
  br i1 %245, label %218, label %263, !llvm.loop !66

246:                                              ; preds = %218, %256
  %247 = phi i64 [ 0, %218 ], [ %261, %256 ]
  %248 = icmp eq i64 %247, 0
  br i1 %248, label %249, label %256

249:                                              ; preds = %246
  %250 = load ptr, ptr %35, align 8
  %251 = load i64, ptr %36, align 8
  %252 = mul nsw i64 %251, %79
  %253 = getelementptr double, ptr %250, i64 %252
  %254 = getelementptr double, ptr %253, i64 %219
  %255 = load double, ptr %254, align 8
  br label %256

256:                                              ; preds = %249, %246
  %257 = phi double [ %255, %249 ], [ 0xFFF0000000000000, %246 ]
  %258 = load ptr, ptr %196, align 8
  %259 = getelementptr inbounds i8, ptr %258, i64 %231
  %260 = getelementptr inbounds double, ptr %259, i64 %247
  store double %257, ptr %260, align 8
  %261 = add nuw nsw i64 %247, 1
  %262 = icmp eq i64 %261, 100
  br i1 %262, label %232, label %246, !llvm.loop !67

263:                                              ; preds = %232, %190
  %264 = getelementptr inbounds i8, ptr %169, i64 648
  %265 = load ptr, ptr %264, align 8
  %266 = getelementptr inbounds i8, ptr %265, i64 80
  store i64 0, ptr %266, align 8
  br label %267

267:                                              ; preds = %263, %162
  %268 = load ptr, ptr %38, align 8
  %269 = load double, ptr %268, align 8
  %270 = load ptr, ptr %3, align 8
  %271 = getelementptr inbounds double, ptr %270, i64 %40
  store double %269, ptr %271, align 8
  %272 = shl nuw nsw i64 1, %40
  %273 = or i64 %272, %41
  br label %274

274:                                              ; preds = %78, %267
  %275 = phi i64 [ %273, %267 ], [ %41, %78 ]
  %276 = load ptr, ptr %10, align 8
  %277 = getelementptr inbounds i64, ptr %276, i64 %40
  %278 = load i64, ptr %277, align 8
  %279 = icmp sgt i64 %278, -1
  %280 = shl nuw nsw i64 1, %40
  %281 = select i1 %279, i64 %280, i64 0
  %282 = or i64 %281, %43
  %283 = select i1 %279, i64 %40, i64 %42
  %284 = add nuw nsw i64 %40, 1
  %285 = icmp eq i64 %284, 8
  br i1 %285, label %55, label %39, !llvm.loop !68

286:                                              ; preds = %386
  %287 = getelementptr inbounds i8, ptr %0, i64 272
  %288 = load i64, ptr %287, align 8
  %289 = icmp sgt i64 %288, 0
  br i1 %289, label %290, label %389

290:                                              ; preds = %286
  %291 = getelementptr inbounds i8, ptr %0, i64 264
  %292 = getelementptr inbounds i8, ptr %0, i64 216
  br label %293

293:                                              ; preds = %290, %293
  %294 = phi i64 [ 0, %290 ], [ %306, %293 ]
  %295 = load ptr, ptr %291, align 8
  %296 = shl nuw nsw i64 %294, 1
  %297 = getelementptr inbounds i64, ptr %295, i64 %296
  %298 = load i64, ptr %297, align 8
  %299 = inttoptr i64 %298 to ptr
  %300 = load ptr, ptr %299, align 8
  %301 = load ptr, ptr %292, align 8
  %302 = or disjoint i64 %296, 1
  %303 = getelementptr inbounds i64, ptr %295, i64 %302
  %304 = load i64, ptr %303, align 8
  %305 = inttoptr i64 %304 to ptr
  tail call void %300(ptr noundef %301, ptr noundef %305) #11
  %306 = add nuw nsw i64 %294, 1
  %307 = load i64, ptr %287, align 8
  %308 = icmp slt i64 %306, %307
  br i1 %308, label %293, label %389, !llvm.loop !69

309:                                              ; preds = %58, %386
  %310 = phi i64 [ 0, %58 ], [ %387, %386 ]
  %311 = load ptr, ptr %59, align 8
  %312 = getelementptr inbounds i64, ptr %311, i64 %310
  %313 = load i64, ptr %312, align 8
  %314 = icmp eq i64 %313, -1
  br i1 %314, label %315, label %386

315:                                              ; preds = %309
  %316 = load ptr, ptr %5, align 8
  %317 = load ptr, ptr %56, align 8
  %318 = getelementptr inbounds i8, ptr %317, i64 8
  %319 = load i64, ptr %318, align 8
  %320 = icmp sgt i64 %319, 0
  br i1 %320, label %321, label %330

321:                                              ; preds = %315, %321
  %322 = phi i64 [ %328, %321 ], [ 0, %315 ]
  %323 = shl i64 %322, 6
  %324 = getelementptr i8, ptr %316, i64 %323
  %325 = getelementptr double, ptr %324, i64 %283
  %326 = load double, ptr %325, align 8
  %327 = getelementptr double, ptr %324, i64 %310
  store double %326, ptr %327, align 8
  %328 = add nuw nsw i64 %322, 1
  %329 = icmp eq i64 %328, %319
  br i1 %329, label %330, label %321, !llvm.loop !70

330:                                              ; preds = %321, %315
  %331 = load ptr, ptr %60, align 8
  %332 = load ptr, ptr %56, align 8
  %333 = getelementptr inbounds i8, ptr %332, i64 8
  %334 = load i64, ptr %333, align 8
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %336, label %345

336:                                              ; preds = %330, %336
  %337 = phi i64 [ %343, %336 ], [ 0, %330 ]
  %338 = shl i64 %337, 6
  %339 = getelementptr i8, ptr %331, i64 %338
  %340 = getelementptr double, ptr %339, i64 %283
  %341 = load double, ptr %340, align 8
  %342 = getelementptr double, ptr %339, i64 %310
  store double %341, ptr %342, align 8
  %343 = add nuw nsw i64 %337, 1
  %344 = icmp eq i64 %343, %334
  br i1 %344, label %345, label %336, !llvm.loop !70

345:                                              ; preds = %336, %330
  %346 = load ptr, ptr %61, align 8
  %347 = load ptr, ptr %56, align 8
  %348 = getelementptr inbounds i8, ptr %347, i64 48
  %349 = load i64, ptr %348, align 8
  %350 = icmp sgt i64 %349, 0
  br i1 %350, label %351, label %360

351:                                              ; preds = %345, %351
  %352 = phi i64 [ %358, %351 ], [ 0, %345 ]
  %353 = shl i64 %352, 6
  %354 = getelementptr i8, ptr %346, i64 %353
  %355 = getelementptr double, ptr %354, i64 %283
  %356 = load double, ptr %355, align 8
  %357 = getelementptr double, ptr %354, i64 %310
  store double %356, ptr %357, align 8
  %358 = add nuw nsw i64 %352, 1
  %359 = icmp eq i64 %358, %349
  br i1 %359, label %360, label %351, !llvm.loop !70

360:                                              ; preds = %351, %345
  %361 = load ptr, ptr %62, align 8
  %362 = load ptr, ptr %56, align 8
  %363 = getelementptr inbounds i8, ptr %362, i64 56
  %364 = load i64, ptr %363, align 8
  %365 = icmp sgt i64 %364, 0
  br i1 %365, label %366, label %375

366:                                              ; preds = %360, %366
  %367 = phi i64 [ %373, %366 ], [ 0, %360 ]
  %368 = shl i64 %367, 6
  %369 = getelementptr i8, ptr %361, i64 %368
  %370 = getelementptr double, ptr %369, i64 %283
  %371 = load double, ptr %370, align 8
  %372 = getelementptr double, ptr %369, i64 %310
  store double %371, ptr %372, align 8
  %373 = add nuw nsw i64 %367, 1
  %374 = icmp eq i64 %373, %364
  br i1 %374, label %375, label %366, !llvm.loop !70

375:                                              ; preds = %366, %360
  %376 = load ptr, ptr %3, align 8
  %377 = getelementptr inbounds double, ptr %376, i64 %283
  %378 = load double, ptr %377, align 8
  %379 = getelementptr inbounds double, ptr %376, i64 %310
  store double %378, ptr %379, align 8
  %380 = load ptr, ptr %63, align 8
  %381 = getelementptr inbounds double, ptr %380, i64 %310
  store double 0.000000e+00, ptr %381, align 8
  %382 = load ptr, ptr %64, align 8
  %383 = getelementptr inbounds double, ptr %382, i64 %310
  store double 0x7FF0000000000000, ptr %383, align 8
  %384 = load ptr, ptr %59, align 8
  %385 = getelementptr inbounds i64, ptr %384, i64 %310
  store i64 -2, ptr %385, align 8
  br label %386

386:                                              ; preds = %309, %375
  %387 = add nuw nsw i64 %310, 1
  %388 = icmp eq i64 %387, 8
  br i1 %388, label %286, label %309, !llvm.loop !71

389:                                              ; preds = %293, %286, %55
  ret i64 %275
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
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %7) #10
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
  tail call fastcc void @settle(ptr noundef nonnull %20) #10
  br label %31

31:                                               ; preds = %30, %4
  %32 = getelementptr inbounds i8, ptr %20, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %20) #10
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
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #11
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
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %76, ptr noundef %76, ptr noundef nonnull %71, i64 noundef %75) #10
  %77 = load <8 x double>, ptr %5, align 16
  %78 = getelementptr inbounds i8, ptr %71, i64 168
  %79 = load ptr, ptr %78, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %79, ptr noundef %76, ptr noundef nonnull %71, i64 noundef %75) #10
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
  %108 = getelementptr inbounds i8, ptr %0, i64 1728
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
  %127 = getelementptr inbounds i8, ptr %0, i64 1752
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
  br i1 %179, label %164, label %55, !llvm.loop !72

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
  br i1 %204, label %205, label %180, !llvm.loop !73

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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %213, i64 noundef 3) #10
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %221, i64 noundef 0) #10
  ret void

226:                                              ; preds = %209, %226
  %227 = phi i64 [ %207, %209 ], [ %238, %226 ]
  %228 = load ptr, ptr %11, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %228, i64 noundef %227) #10
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
  br i1 %239, label %212, label %226, !llvm.loop !74
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
  br i1 %31, label %19, label %32, !llvm.loop !75

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
  br i1 %53, label %7, label %8, !llvm.loop !76
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
  %20 = getelementptr inbounds i8, ptr %0, i64 1128
  %21 = getelementptr inbounds i8, ptr %0, i64 1144
  %22 = getelementptr inbounds i8, ptr %0, i64 840
  %23 = getelementptr inbounds i8, ptr %0, i64 864
  %24 = getelementptr inbounds i8, ptr %0, i64 888
  %25 = icmp slt i64 %2, 0
  %26 = getelementptr inbounds i8, ptr %0, i64 912
  %27 = getelementptr inbounds i8, ptr %0, i64 1152
  %28 = getelementptr inbounds i8, ptr %0, i64 1704
  %29 = getelementptr inbounds i8, ptr %0, i64 1712
  %30 = getelementptr inbounds i8, ptr %0, i64 1192
  %31 = getelementptr inbounds i8, ptr %0, i64 1176
  %32 = getelementptr inbounds i8, ptr %0, i64 1192
  %33 = getelementptr inbounds i8, ptr %0, i64 1208
  %34 = getelementptr inbounds i8, ptr %0, i64 1248
  %35 = getelementptr inbounds i8, ptr %0, i64 1416
  %36 = getelementptr inbounds i8, ptr %0, i64 1464
  %37 = getelementptr inbounds i8, ptr %0, i64 1480
  %38 = getelementptr inbounds i8, ptr %0, i64 1200
  %39 = getelementptr inbounds i8, ptr %0, i64 1512
  %40 = getelementptr inbounds i8, ptr %0, i64 1528
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
  br i1 %86, label %61, label %64, !llvm.loop !77

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !78

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
  br i1 %126, label %118, label %127, !llvm.loop !79

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
  br i1 %155, label %135, label %174, !llvm.loop !80

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
  br i1 %173, label %150, label %157, !llvm.loop !81

174:                                              ; preds = %150, %130
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %43) #10
  br label %175

175:                                              ; preds = %174, %127
  %176 = load ptr, ptr %15, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %43
  store i64 -1, ptr %177, align 8
  %178 = add nsw i64 %42, -1
  %179 = and i64 %178, %42
  %180 = icmp eq i64 %179, 0
  br i1 %180, label %60, label %41, !llvm.loop !82
}

define internal fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1656
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
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #11
  ret i64 %17
}

define internal fastcc range(i64 0, 256) i64 @clear_lanes(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 432
  %3 = getelementptr inbounds i8, ptr %0, i64 1248
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 1200
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
  %20 = getelementptr inbounds i8, ptr %0, i64 1352
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 1344
  %25 = getelementptr inbounds i8, ptr %0, i64 456
  %26 = getelementptr inbounds i8, ptr %0, i64 1944
  %27 = getelementptr inbounds i8, ptr %0, i64 144
  %28 = getelementptr inbounds i8, ptr %0, i64 1296
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  br label %63

30:                                               ; preds = %83, %19
  %31 = getelementptr inbounds i8, ptr %0, i64 1296
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
  %49 = getelementptr inbounds i8, ptr %0, i64 1320
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 1392
  %52 = load ptr, ptr %51, align 8
  %53 = inttoptr i64 %45 to ptr
  %54 = load ptr, ptr %53, align 8
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #11
  %56 = trunc i32 %55 to i8
  %57 = xor i8 %56, -1
  %58 = icmp sgt i64 %12, 0
  br i1 %58, label %59, label %111

59:                                               ; preds = %30
  %60 = bitcast i8 %57 to <8 x i1>
  %61 = sext <8 x i1> %60 to <8 x i64>
  %62 = getelementptr inbounds i8, ptr %0, i64 1416
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
  br i1 %92, label %63, label %30, !llvm.loop !83

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
  br i1 %107, label %83, label %93, !llvm.loop !84

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
  br i1 %139, label %108, label %114, !llvm.loop !85

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
  %17 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %16, ptr noundef nonnull %3) #10
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
  br i1 %25, label %9, label %21, !llvm.loop !86

26:                                               ; preds = %9, %51
  %27 = phi i64 [ %53, %51 ], [ %19, %9 ]
  %28 = phi i64 [ %46, %51 ], [ 0, %9 ]
  %29 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %27, i1 true)
  %30 = getelementptr inbounds double, ptr %3, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %6, i64 %29
  %33 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %29, double noundef %31, ptr noundef %32) #10
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
  br i1 %54, label %48, label %26, !llvm.loop !87
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
  %38 = getelementptr inbounds i8, ptr %0, i64 1656
  br label %46

39:                                               ; preds = %31, %39
  %40 = phi i64 [ 0, %31 ], [ %44, %39 ]
  %41 = getelementptr inbounds i64, ptr %35, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %40
  store i64 %42, ptr %43, align 8
  %44 = add nuw nsw i64 %40, 1
  %45 = icmp eq i64 %44, 8
  br i1 %45, label %36, label %39, !llvm.loop !88

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
  tail call fastcc void @nested(ptr noundef %22, ptr noundef %71, ptr noundef %73, i64 noundef %75, i64 noundef %79, ptr noundef %80, i64 noundef %84) #10
  %85 = load ptr, ptr %38, align 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp eq i64 %86, 1
  br i1 %87, label %88, label %92

88:                                               ; preds = %65
  %89 = load ptr, ptr %18, align 8
  %90 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %89, ptr noundef %22, i64 noundef %59, i32 noundef 0) #10
  %91 = or i64 %90, %48
  br label %92

92:                                               ; preds = %88, %65
  %93 = phi i64 [ %91, %88 ], [ %48, %65 ]
  %94 = xor i64 %93, -1
  %95 = and i64 %59, %94
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %95) #10
  br label %46, !llvm.loop !89

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
  br i1 %111, label %112, label %96, !llvm.loop !90

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
  tail call fastcc void @nested(ptr noundef %15, ptr noundef %18, ptr noundef %20, i64 noundef %22, i64 noundef %26, ptr noundef %27, i64 noundef %32) #10
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
  %41 = getelementptr inbounds i8, ptr %0, i64 1656
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
  br i1 %60, label %45, label %40, !llvm.loop !91

61:                                               ; preds = %40
  %62 = bitcast <8 x i1> %12 to i8
  %63 = icmp eq i8 %62, 0
  br i1 %63, label %69, label %64

64:                                               ; preds = %61
  %65 = zext i8 %62 to i64
  %66 = getelementptr inbounds i8, ptr %7, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %3, ptr noundef %67, i64 noundef %65, i32 noundef 0) #10
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
  br i1 %45, label %28, label %19, !llvm.loop !92

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
  br i1 %54, label %29, label %46, !llvm.loop !93
}

define internal fastcc i64 @act_in_lanes(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #2 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %1, 0
  br i1 %8, label %32, label %9

9:                                                ; preds = %3
  %10 = getelementptr inbounds i8, ptr %0, i64 1200
  %11 = icmp sgt i64 %7, 0
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  %13 = getelementptr inbounds i8, ptr %0, i64 696
  %14 = getelementptr inbounds i8, ptr %0, i64 1248
  %15 = getelementptr inbounds i8, ptr %0, i64 1440
  %16 = getelementptr inbounds i8, ptr %0, i64 1416
  %17 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %50, label %34, label %40, !llvm.loop !94

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  %89 = icmp ne i64 %88, 0
  %90 = select i1 %89, i64 %84, i64 %86
  %91 = zext i1 %89 to i64
  %92 = add nuw nsw i64 %85, %91
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %60
  br i1 %94, label %80, label %83, !llvm.loop !95

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  br i1 %139, label %120, label %123, !llvm.loop !96

140:                                              ; preds = %98, %96
  %141 = load ptr, ptr %57, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 48
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %148, label %145

145:                                              ; preds = %140
  %146 = inttoptr i64 %143 to ptr
  %147 = tail call i64 %146(ptr noundef %56) #11
  br label %148

148:                                              ; preds = %145, %140
  %149 = phi i64 [ %147, %145 ], [ 0, %140 ]
  br i1 %75, label %150, label %151

150:                                              ; preds = %148
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  br i1 %195, label %177, label %180, !llvm.loop !97

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
  br i1 %210, label %196, label %200, !llvm.loop !98

211:                                              ; preds = %196
  %212 = or i64 %199, %21
  br label %214

213:                                              ; preds = %196
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %199, i64 noundef %157) #10
  br label %214

214:                                              ; preds = %213, %211
  %215 = phi i64 [ %212, %211 ], [ %21, %213 ]
  %216 = add nsw i64 %22, -1
  %217 = and i64 %216, %22
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %32, label %20, !llvm.loop !99
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
  tail call fastcc void @settle(ptr noundef nonnull %18) #10
  br label %31

31:                                               ; preds = %30, %17
  %32 = getelementptr inbounds i8, ptr %18, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %18) #10
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
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #11
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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %56, i64 noundef 3) #10
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
  br i1 %77, label %62, label %54, !llvm.loop !100
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
  br i1 %33, label %21, label %34, !llvm.loop !75

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
  br i1 %54, label %6, label %7, !llvm.loop !101
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
  br i1 %25, label %15, label %14, !llvm.loop !102

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
  br i1 %76, label %65, label %77, !llvm.loop !103

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
  br i1 %105, label %22, label %26, !llvm.loop !104
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
  br i1 %48, label %13, label %20, !llvm.loop !105
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #5

define internal fastcc void @empty_log(ptr noundef readonly %0, i64 noundef %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 1248
  %4 = getelementptr inbounds i8, ptr %0, i64 1200
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i64, ptr %5, i64 %1
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 648
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 80
  %12 = getelementptr inbounds i8, ptr %0, i64 1608
  %13 = getelementptr inbounds i8, ptr %0, i64 1624
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 1568
  %16 = load i64, ptr %11, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %33

18:                                               ; preds = %2
  %19 = getelementptr inbounds i8, ptr %0, i64 1560
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = getelementptr inbounds i8, ptr %0, i64 1536
  %22 = getelementptr inbounds i8, ptr %8, i64 1056
  %23 = getelementptr inbounds i8, ptr %8, i64 1080
  %24 = getelementptr inbounds i8, ptr %0, i64 1584
  %25 = icmp sgt i64 %14, 0
  %26 = getelementptr inbounds i8, ptr %8, i64 1104
  %27 = getelementptr inbounds i8, ptr %8, i64 1128
  %28 = getelementptr inbounds i8, ptr %0, i64 1632
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
  br i1 %60, label %29, label %33, !llvm.loop !106

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
  br i1 %76, label %57, label %61, !llvm.loop !107
}

declare double @llvm.sqrt.f64(double) #5

define internal fastcc range(i64 0, 256) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %118, %57
  %6 = icmp eq i64 %25, %1
  br i1 %6, label %7, label %13, !llvm.loop !108

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
  br i1 %56, label %39, label %27, !llvm.loop !109

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
  br i1 %74, label %57, label %61, !llvm.loop !110

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
  br i1 %89, label %71, label %75, !llvm.loop !111

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
  br i1 %117, label %104, label %118, !llvm.loop !112

118:                                              ; preds = %104, %90
  %119 = add nuw nsw i64 %91, 1
  %120 = icmp slt i64 %119, %1
  br i1 %120, label %90, label %5, !llvm.loop !113
}

define internal fastcc range(i64 0, 256) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %179, %69
  %6 = icmp eq i64 %31, %1
  br i1 %6, label %7, label %13, !llvm.loop !114

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
  %24 = load <8 x double>, ptr %23, align 8, !noalias !115
  %25 = or disjoint i64 %21, 64
  %26 = getelementptr inbounds i8, ptr %0, i64 %25
  %27 = load <8 x double>, ptr %26, align 8, !noalias !115
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
  %54 = load <8 x double>, ptr %53, align 8, !noalias !118
  %55 = or disjoint i64 %51, 64
  %56 = getelementptr inbounds i8, ptr %0, i64 %55
  %57 = load <8 x double>, ptr %56, align 8, !noalias !118
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
  br i1 %68, label %45, label %33, !llvm.loop !121

69:                                               ; preds = %96, %33
  %70 = load <8 x double>, ptr %23, align 8, !noalias !122
  %71 = load <8 x double>, ptr %26, align 8, !noalias !122
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
  br i1 %99, label %69, label %86, !llvm.loop !125

100:                                              ; preds = %94, %100
  %101 = phi i64 [ 0, %94 ], [ %122, %100 ]
  %102 = add nuw nsw i64 %101, %19
  %103 = shl i64 %102, 7
  %104 = shl nsw i64 %102, 7
  %105 = getelementptr inbounds i8, ptr %0, i64 %104
  %106 = load <8 x i64>, ptr %105, align 8, !noalias !126
  %107 = or disjoint i64 %103, 64
  %108 = getelementptr inbounds i8, ptr %0, i64 %107
  %109 = load <8 x i64>, ptr %108, align 8, !noalias !126
  %110 = add nuw nsw i64 %101, %95
  %111 = shl i64 %110, 7
  %112 = shl nsw i64 %110, 7
  %113 = getelementptr inbounds i8, ptr %0, i64 %112
  %114 = load <8 x i64>, ptr %113, align 8, !noalias !129
  %115 = or disjoint i64 %111, 64
  %116 = getelementptr inbounds i8, ptr %0, i64 %115
  %117 = load <8 x i64>, ptr %116, align 8, !noalias !129
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
  br i1 %124, label %96, label %100, !llvm.loop !132

125:                                              ; preds = %69, %179
  %126 = phi i64 [ %180, %179 ], [ %31, %69 ]
  %127 = mul nuw nsw i64 %126, %1
  %128 = add nuw nsw i64 %127, %15
  %129 = shl i64 %128, 7
  %130 = shl nsw i64 %128, 7
  %131 = getelementptr inbounds i8, ptr %0, i64 %130
  %132 = load <8 x double>, ptr %131, align 8, !noalias !133
  %133 = or disjoint i64 %129, 64
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !133
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
  %157 = load <8 x double>, ptr %156, align 8, !noalias !136
  %158 = or disjoint i64 %154, 64
  %159 = getelementptr inbounds i8, ptr %0, i64 %158
  %160 = load <8 x double>, ptr %159, align 8, !noalias !136
  %161 = add nuw nsw i64 %152, %19
  %162 = shl i64 %161, 7
  %163 = shl nsw i64 %161, 7
  %164 = getelementptr inbounds i8, ptr %0, i64 %163
  %165 = load <8 x double>, ptr %164, align 8, !noalias !139
  %166 = or disjoint i64 %162, 64
  %167 = getelementptr inbounds i8, ptr %0, i64 %166
  %168 = load <8 x double>, ptr %167, align 8, !noalias !139
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
  br i1 %178, label %151, label %179, !llvm.loop !142

179:                                              ; preds = %151, %125
  %180 = add nuw nsw i64 %126, 1
  %181 = icmp slt i64 %180, %1
  br i1 %181, label %125, label %5, !llvm.loop !143
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #5

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
  br i1 %26, label %16, label %6, !llvm.loop !144

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
  br i1 %38, label %24, label %18, !llvm.loop !145

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
  br i1 %55, label %39, label %44, !llvm.loop !146

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
  br i1 %69, label %52, label %56, !llvm.loop !147

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
  br i1 %86, label %71, label %70, !llvm.loop !148

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
  br i1 %100, label %80, label %87, !llvm.loop !149
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
  br i1 %27, label %17, label %6, !llvm.loop !144

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
  br i1 %38, label %25, label %19, !llvm.loop !145

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
  br i1 %46, label %39, label %36, !llvm.loop !150

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
  %56 = load <8 x double>, ptr %55, align 8, !noalias !151
  %57 = or disjoint i64 %53, 64
  %58 = getelementptr inbounds i8, ptr %3, i64 %57
  %59 = load <8 x double>, ptr %58, align 8, !noalias !151
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
  br i1 %67, label %47, label %51, !llvm.loop !154

68:                                               ; preds = %61, %68
  %69 = phi i64 [ 0, %61 ], [ %94, %68 ]
  %70 = phi <8 x double> [ %59, %61 ], [ %93, %68 ]
  %71 = phi <8 x double> [ %56, %61 ], [ %92, %68 ]
  %72 = add nuw nsw i64 %69, %62
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !155
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !155
  %80 = shl i64 %69, 7
  %81 = shl nsw i64 %69, 7
  %82 = getelementptr inbounds i8, ptr %3, i64 %81
  %83 = load <8 x double>, ptr %82, align 8, !noalias !158
  %84 = or disjoint i64 %80, 64
  %85 = getelementptr inbounds i8, ptr %3, i64 %84
  %86 = load <8 x double>, ptr %85, align 8, !noalias !158
  %87 = fneg <8 x double> %79
  %88 = fmul <8 x double> %86, %87
  %89 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %83, <8 x double> %88)
  %90 = fmul <8 x double> %79, %83
  %91 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %86, <8 x double> %90)
  %92 = fsub <8 x double> %71, %89
  %93 = fsub <8 x double> %70, %91
  %94 = add nuw nsw i64 %69, 1
  %95 = icmp eq i64 %94, %52
  br i1 %95, label %63, label %68, !llvm.loop !161

96:                                               ; preds = %110, %47
  ret void

97:                                               ; preds = %49, %110
  %98 = phi i64 [ %1, %49 ], [ %99, %110 ]
  %99 = add nsw i64 %98, -1
  %100 = shl i64 %99, 7
  %101 = shl nsw i64 %99, 7
  %102 = getelementptr inbounds i8, ptr %3, i64 %101
  %103 = load <8 x double>, ptr %102, align 8, !noalias !162
  %104 = or disjoint i64 %100, 64
  %105 = getelementptr inbounds i8, ptr %3, i64 %104
  %106 = load <8 x double>, ptr %105, align 8, !noalias !162
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
  %117 = load <8 x double>, ptr %116, align 8, !noalias !165
  %118 = or disjoint i64 %114, 64
  %119 = getelementptr inbounds i8, ptr %0, i64 %118
  %120 = load <8 x double>, ptr %119, align 8, !noalias !165
  %121 = fneg <8 x double> %112
  %122 = fmul <8 x double> %120, %121
  %123 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %117, <8 x double> %122)
  %124 = fmul <8 x double> %112, %117
  %125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %120, <8 x double> %124)
  store <8 x double> %123, ptr %102, align 8
  store <8 x double> %125, ptr %105, align 8
  %126 = icmp sgt i64 %98, 1
  br i1 %126, label %97, label %96, !llvm.loop !168

127:                                              ; preds = %108, %127
  %128 = phi i64 [ %98, %108 ], [ %153, %127 ]
  %129 = phi <8 x double> [ %106, %108 ], [ %152, %127 ]
  %130 = phi <8 x double> [ %103, %108 ], [ %151, %127 ]
  %131 = add nsw i64 %128, %109
  %132 = shl i64 %131, 7
  %133 = shl nsw i64 %131, 7
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !169
  %136 = or disjoint i64 %132, 64
  %137 = getelementptr inbounds i8, ptr %0, i64 %136
  %138 = load <8 x double>, ptr %137, align 8, !noalias !169
  %139 = shl i64 %128, 7
  %140 = shl nsw i64 %128, 7
  %141 = getelementptr inbounds i8, ptr %3, i64 %140
  %142 = load <8 x double>, ptr %141, align 8, !noalias !172
  %143 = or disjoint i64 %139, 64
  %144 = getelementptr inbounds i8, ptr %3, i64 %143
  %145 = load <8 x double>, ptr %144, align 8, !noalias !172
  %146 = fneg <8 x double> %138
  %147 = fmul <8 x double> %145, %146
  %148 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %142, <8 x double> %147)
  %149 = fmul <8 x double> %138, %142
  %150 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %145, <8 x double> %149)
  %151 = fsub <8 x double> %130, %148
  %152 = fsub <8 x double> %129, %150
  %153 = add nuw nsw i64 %128, 1
  %154 = icmp eq i64 %153, %1
  br i1 %154, label %110, label %127, !llvm.loop !175
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
  br i1 %35, label %23, label %12, !llvm.loop !144

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
  br i1 %46, label %33, label %27, !llvm.loop !145

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
  br i1 %54, label %47, label %44, !llvm.loop !150

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
  br i1 %70, label %61, label %55, !llvm.loop !176

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
  br i1 %92, label %93, label %80, !llvm.loop !177

93:                                               ; preds = %80, %71
  %94 = add nuw nsw i64 %72, 1
  %95 = icmp eq i64 %94, %56
  br i1 %95, label %68, label %71, !llvm.loop !178

96:                                               ; preds = %136, %106
  %97 = icmp sgt i64 %99, 1
  br i1 %97, label %98, label %105, !llvm.loop !179

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
  br i1 %132, label %133, label %120, !llvm.loop !177

133:                                              ; preds = %120, %111
  %134 = add nuw nsw i64 %112, 1
  %135 = icmp eq i64 %134, %1
  br i1 %135, label %106, label %111, !llvm.loop !180

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
  br i1 %145, label %96, label %136, !llvm.loop !181
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
  br i1 %35, label %23, label %12, !llvm.loop !144

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
  br i1 %46, label %33, label %27, !llvm.loop !145

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
  br i1 %54, label %47, label %44, !llvm.loop !150

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
  br i1 %69, label %61, label %55, !llvm.loop !182

70:                                               ; preds = %58, %109
  %71 = phi i64 [ 0, %58 ], [ %110, %109 ]
  %72 = add nuw nsw i64 %71, %59
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !183
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !183
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
  %89 = load <8 x double>, ptr %88, align 8, !noalias !186
  %90 = or disjoint i64 %86, 64
  %91 = getelementptr inbounds i8, ptr %3, i64 %90
  %92 = load <8 x double>, ptr %91, align 8, !noalias !186
  %93 = add nuw nsw i64 %84, %81
  %94 = shl i64 %93, 7
  %95 = shl nsw i64 %93, 7
  %96 = getelementptr inbounds i8, ptr %3, i64 %95
  %97 = load <8 x double>, ptr %96, align 8, !noalias !189
  %98 = or disjoint i64 %94, 64
  %99 = getelementptr inbounds i8, ptr %3, i64 %98
  %100 = load <8 x double>, ptr %99, align 8, !noalias !189
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
  br i1 %108, label %109, label %83, !llvm.loop !192

109:                                              ; preds = %83, %70
  %110 = add nuw nsw i64 %71, 1
  %111 = icmp eq i64 %110, %56
  br i1 %111, label %67, label %70, !llvm.loop !193

112:                                              ; preds = %173, %122
  %113 = icmp sgt i64 %115, 1
  br i1 %113, label %114, label %121, !llvm.loop !194

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
  %137 = load <8 x double>, ptr %136, align 8, !noalias !195
  %138 = or disjoint i64 %134, 64
  %139 = getelementptr inbounds i8, ptr %0, i64 %138
  %140 = load <8 x double>, ptr %139, align 8, !noalias !195
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
  %150 = load <8 x double>, ptr %149, align 8, !noalias !198
  %151 = or disjoint i64 %147, 64
  %152 = getelementptr inbounds i8, ptr %3, i64 %151
  %153 = load <8 x double>, ptr %152, align 8, !noalias !198
  %154 = add nsw i64 %145, %142
  %155 = shl i64 %154, 7
  %156 = shl nsw i64 %154, 7
  %157 = getelementptr inbounds i8, ptr %3, i64 %156
  %158 = load <8 x double>, ptr %157, align 8, !noalias !201
  %159 = or disjoint i64 %155, 64
  %160 = getelementptr inbounds i8, ptr %3, i64 %159
  %161 = load <8 x double>, ptr %160, align 8, !noalias !201
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
  br i1 %169, label %170, label %144, !llvm.loop !192

170:                                              ; preds = %144, %131
  %171 = add nuw nsw i64 %132, 1
  %172 = icmp eq i64 %171, %1
  br i1 %172, label %122, label %131, !llvm.loop !204

173:                                              ; preds = %123, %173
  %174 = phi i64 [ 0, %123 ], [ %190, %173 ]
  %175 = add nsw i64 %174, %124
  %176 = shl i64 %175, 7
  %177 = shl nsw i64 %175, 7
  %178 = getelementptr inbounds i8, ptr %3, i64 %177
  %179 = load <8 x double>, ptr %178, align 8, !noalias !205
  %180 = or disjoint i64 %176, 64
  %181 = getelementptr inbounds i8, ptr %3, i64 %180
  %182 = load <8 x double>, ptr %181, align 8, !noalias !205
  %183 = load <8 x double>, ptr %128, align 8, !noalias !208
  %184 = load <8 x double>, ptr %130, align 8, !noalias !208
  %185 = fneg <8 x double> %182
  %186 = fmul <8 x double> %184, %185
  %187 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %183, <8 x double> %186)
  %188 = fmul <8 x double> %182, %183
  %189 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %184, <8 x double> %188)
  store <8 x double> %187, ptr %178, align 8
  store <8 x double> %189, ptr %181, align 8
  %190 = add nuw nsw i64 %174, 1
  %191 = icmp eq i64 %190, %4
  br i1 %191, label %112, label %173, !llvm.loop !211
}

define internal fastcc range(i64 0, 256) i64 @quiet_lanes(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3) unnamed_addr #3 {
  %5 = alloca [5 x <8 x double>], align 64
  %6 = getelementptr inbounds i8, ptr %0, i64 1248
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 1200
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = getelementptr inbounds i8, ptr %13, i64 864
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 1440
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
  %28 = getelementptr inbounds i8, ptr %0, i64 1392
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
  tail call fastcc void @nested(ptr noundef %37, ptr noundef %40, ptr noundef %42, i64 noundef %44, i64 noundef %48, ptr noundef %49, i64 noundef %54) #10
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
  tail call fastcc void @settle(ptr noundef nonnull %30) #10
  br label %64

64:                                               ; preds = %63, %27
  %65 = getelementptr inbounds i8, ptr %0, i64 296
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %69

68:                                               ; preds = %64
  tail call fastcc void @sample(ptr noundef nonnull %30) #10
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
  %79 = getelementptr inbounds i8, ptr %0, i64 1272
  %80 = load ptr, ptr %79, align 8
  %81 = inttoptr i64 %71 to ptr
  %82 = load ptr, ptr %81, align 8
  %83 = tail call i32 %82(ptr noundef %73, ptr noundef %76, ptr noundef %78, ptr noundef %80, ptr noundef %29) #11
  %84 = zext i32 %83 to i64
  %85 = and i64 %84, %24
  %86 = icmp sgt i64 %9, 0
  br i1 %86, label %87, label %101

87:                                               ; preds = %69
  %88 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %100, label %101, label %89, !llvm.loop !212

101:                                              ; preds = %89, %69, %4
  %102 = phi i64 [ 0, %4 ], [ %85, %69 ], [ %85, %89 ]
  %103 = getelementptr inbounds i8, ptr %0, i64 1368
  %104 = shl i64 %9, 6
  %105 = getelementptr inbounds i8, ptr %0, i64 144
  %106 = getelementptr inbounds i8, ptr %1, i64 16
  %107 = getelementptr inbounds i8, ptr %1, i64 8
  %108 = getelementptr inbounds i8, ptr %0, i64 168
  %109 = getelementptr inbounds i8, ptr %0, i64 296
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %121 = getelementptr inbounds i8, ptr %0, i64 1416
  %122 = load ptr, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %0, i64 1368
  %124 = load ptr, ptr %123, align 8
  %125 = getelementptr inbounds i8, ptr %5, i64 64
  br label %195

126:                                              ; preds = %101, %172
  %127 = phi i64 [ 1, %101 ], [ %186, %172 ]
  %128 = phi i64 [ %102, %101 ], [ %185, %172 ]
  %129 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %127
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
  tail call fastcc void @nested(ptr noundef %143, ptr noundef %146, ptr noundef %148, i64 noundef %150, i64 noundef %154, ptr noundef %155, i64 noundef %159) #10
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
  tail call fastcc void @settle(ptr noundef nonnull %105) #10
  br label %168

168:                                              ; preds = %167, %126
  %169 = load i64, ptr %109, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %168
  tail call fastcc void @sample(ptr noundef nonnull %105) #10
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
  %183 = tail call i32 %182(ptr noundef %175, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %133) #11
  %184 = zext i32 %183 to i64
  %185 = or i64 %128, %184
  %186 = add nuw nsw i64 %127, 1
  %187 = icmp eq i64 %186, 5
  br i1 %187, label %113, label %126, !llvm.loop !213

188:                                              ; preds = %316, %113
  %189 = phi <8 x i64> [ %118, %113 ], [ %318, %316 ]
  %190 = icmp sgt i64 %9, 0
  br i1 %190, label %191, label %321

191:                                              ; preds = %188
  %192 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %237, label %203, label %208, !llvm.loop !214

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
  %261 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %257
  %262 = load double, ptr %261, align 8
  %263 = add nuw nsw i64 %257, 1
  %264 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %263
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
  %283 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %260
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
  br i1 %315, label %316, label %256, !llvm.loop !215

316:                                              ; preds = %313
  %317 = xor <8 x i64> %314, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %318 = and <8 x i64> %251, %317
  %319 = add nuw nsw i64 %198, 1
  %320 = icmp eq i64 %319, %9
  br i1 %320, label %188, label %195, !llvm.loop !216

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
  br i1 %342, label %321, label %330, !llvm.loop !217
}

define internal fastcc i64 @look_alone(ptr noundef readonly %0, i64 noundef %1, double noundef %2, ptr noundef writeonly %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1200
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
  %25 = getelementptr inbounds i8, ptr %0, i64 1248
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
  %39 = getelementptr inbounds i8, ptr %0, i64 1440
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %1
  %42 = load double, ptr %41, align 8
  store double %42, ptr %38, align 8
  %43 = icmp sgt i64 %32, 0
  br i1 %43, label %44, label %64

44:                                               ; preds = %24
  %45 = getelementptr inbounds i8, ptr %0, i64 1416
  %46 = getelementptr inbounds i8, ptr %29, i64 936
  %47 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %63, label %64, label %48, !llvm.loop !97

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
  %86 = tail call i64 %81(ptr noundef %9, double noundef %70, double noundef %85) #11
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
  %110 = getelementptr inbounds i8, ptr %0, i64 1416
  %111 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %127, label %128, label %112, !llvm.loop !97

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
  br i1 %149, label %24, label %129, !llvm.loop !218

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
  br i1 %168, label %150, label %147, !llvm.loop !219
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
  br i1 %31, label %20, label %19, !llvm.loop !220

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
  br i1 %43, label %32, label %24, !llvm.loop !221
}

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #8

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { noinline nounwind }
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
!8 = distinct !{!8, !5}
!9 = !{!10, !12}
!10 = distinct !{!10, !11, !"implicit_of: argument 0"}
!11 = distinct !{!11, !"implicit_of"}
!12 = distinct !{!12, !13, !"attempt: argument 0"}
!13 = distinct !{!13, !"attempt"}
!14 = !{}
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
!26 = !{!27, !17}
!27 = distinct !{!27, !28, !"solve_stages: argument 0"}
!28 = distinct !{!28, !"solve_stages"}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = !{!34, !27, !17}
!34 = distinct !{!34, !35, !"pair_item: argument 0"}
!35 = distinct !{!35, !"pair_item"}
!36 = distinct !{!36, !4, !5}
!37 = !{!38, !27, !17}
!38 = distinct !{!38, !39, !"pair_item: argument 0"}
!39 = distinct !{!39, !"pair_item"}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = !{!46, !27, !17}
!46 = distinct !{!46, !47, !"pair_item: argument 0"}
!47 = distinct !{!47, !"pair_item"}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5}
!54 = distinct !{!54, !4, !5}
!55 = !{!12}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5}
!60 = distinct !{!60, !4, !5}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5, !63}
!63 = !{!"llvm.loop.vectorize.width", i32 1}
!64 = distinct !{!64, !4, !5, !63}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5, !63}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5, !63}
!79 = distinct !{!79, !4, !5, !63}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
!84 = distinct !{!84, !4, !5}
!85 = distinct !{!85, !4, !5}
!86 = distinct !{!86, !4, !5}
!87 = distinct !{!87, !4, !5}
!88 = distinct !{!88, !4, !5, !63}
!89 = distinct !{!89, !5}
!90 = distinct !{!90, !4, !5}
!91 = distinct !{!91, !4, !5}
!92 = distinct !{!92, !4, !5}
!93 = distinct !{!93, !4, !5, !63}
!94 = distinct !{!94, !4, !5}
!95 = distinct !{!95, !4, !5}
!96 = distinct !{!96, !4, !5}
!97 = distinct !{!97, !4, !5, !63}
!98 = distinct !{!98, !4, !5}
!99 = distinct !{!99, !4, !5}
!100 = distinct !{!100, !4, !5}
!101 = distinct !{!101, !4, !5}
!102 = distinct !{!102, !4, !5}
!103 = distinct !{!103, !4, !5}
!104 = distinct !{!104, !4, !5}
!105 = distinct !{!105, !4, !5}
!106 = distinct !{!106, !4, !5}
!107 = distinct !{!107, !4, !5, !63}
!108 = distinct !{!108, !4, !5}
!109 = distinct !{!109, !4, !5}
!110 = distinct !{!110, !4, !5}
!111 = distinct !{!111, !4, !5}
!112 = distinct !{!112, !4, !5}
!113 = distinct !{!113, !4, !5}
!114 = distinct !{!114, !4, !5}
!115 = !{!116}
!116 = distinct !{!116, !117, !"pair_item: argument 0"}
!117 = distinct !{!117, !"pair_item"}
!118 = !{!119}
!119 = distinct !{!119, !120, !"pair_item: argument 0"}
!120 = distinct !{!120, !"pair_item"}
!121 = distinct !{!121, !4, !5}
!122 = !{!123}
!123 = distinct !{!123, !124, !"pair_item: argument 0"}
!124 = distinct !{!124, !"pair_item"}
!125 = distinct !{!125, !4, !5}
!126 = !{!127}
!127 = distinct !{!127, !128, !"pair_item: argument 0"}
!128 = distinct !{!128, !"pair_item"}
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
!139 = !{!140}
!140 = distinct !{!140, !141, !"pair_item: argument 0"}
!141 = distinct !{!141, !"pair_item"}
!142 = distinct !{!142, !4, !5}
!143 = distinct !{!143, !4, !5}
!144 = distinct !{!144, !4, !5}
!145 = distinct !{!145, !4, !5}
!146 = distinct !{!146, !4, !5}
!147 = distinct !{!147, !4, !5}
!148 = distinct !{!148, !4, !5}
!149 = distinct !{!149, !4, !5}
!150 = distinct !{!150, !4, !5, !63}
!151 = !{!152}
!152 = distinct !{!152, !153, !"pair_item: argument 0"}
!153 = distinct !{!153, !"pair_item"}
!154 = distinct !{!154, !4, !5}
!155 = !{!156}
!156 = distinct !{!156, !157, !"pair_item: argument 0"}
!157 = distinct !{!157, !"pair_item"}
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
!176 = distinct !{!176, !4, !5}
!177 = distinct !{!177, !4, !5}
!178 = distinct !{!178, !4, !5}
!179 = distinct !{!179, !4, !5}
!180 = distinct !{!180, !4, !5}
!181 = distinct !{!181, !4, !5}
!182 = distinct !{!182, !4, !5}
!183 = !{!184}
!184 = distinct !{!184, !185, !"pair_item: argument 0"}
!185 = distinct !{!185, !"pair_item"}
!186 = !{!187}
!187 = distinct !{!187, !188, !"pair_item: argument 0"}
!188 = distinct !{!188, !"pair_item"}
!189 = !{!190}
!190 = distinct !{!190, !191, !"pair_item: argument 0"}
!191 = distinct !{!191, !"pair_item"}
!192 = distinct !{!192, !4, !5}
!193 = distinct !{!193, !4, !5}
!194 = distinct !{!194, !4, !5}
!195 = !{!196}
!196 = distinct !{!196, !197, !"pair_item: argument 0"}
!197 = distinct !{!197, !"pair_item"}
!198 = !{!199}
!199 = distinct !{!199, !200, !"pair_item: argument 0"}
!200 = distinct !{!200, !"pair_item"}
!201 = !{!202}
!202 = distinct !{!202, !203, !"pair_item: argument 0"}
!203 = distinct !{!203, !"pair_item"}
!204 = distinct !{!204, !4, !5}
!205 = !{!206}
!206 = distinct !{!206, !207, !"pair_item: argument 0"}
!207 = distinct !{!207, !"pair_item"}
!208 = !{!209}
!209 = distinct !{!209, !210, !"pair_item: argument 0"}
!210 = distinct !{!210, !"pair_item"}
!211 = distinct !{!211, !4, !5}
!212 = distinct !{!212, !4, !5}
!213 = distinct !{!213, !4, !5}
!214 = distinct !{!214, !4, !5}
!215 = distinct !{!215, !4, !5}
!216 = distinct !{!216, !4, !5}
!217 = distinct !{!217, !4, !5}
!218 = distinct !{!218, !4, !5, !63}
!219 = distinct !{!219, !4, !5}
!220 = distinct !{!220, !4, !5}
!221 = distinct !{!221, !4, !5}
