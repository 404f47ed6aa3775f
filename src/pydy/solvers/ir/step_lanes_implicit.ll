; sources dbdfc53b176a7b61e2312d195fc0fdcf8539c086668bfc65dc7fb760482cefd5
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

135:                                              ; preds = %1728, %44
  %136 = phi i64 [ %1388, %1728 ], [ undef, %44 ]
  %137 = phi i64 [ %1389, %1728 ], [ undef, %44 ]
  %138 = phi <8 x double> [ %1390, %1728 ], [ undef, %44 ]
  %139 = phi <8 x double> [ %1391, %1728 ], [ undef, %44 ]
  %140 = phi <8 x double> [ %1392, %1728 ], [ undef, %44 ]
  %141 = phi i32 [ %1729, %1728 ], [ 1, %44 ]
  %142 = phi i64 [ %1704, %1728 ], [ 0, %44 ]
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
  switch i32 %189, label %1730 [
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
  br i1 %198, label %1730, label %199

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
  br i1 %219, label %220, label %1730

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
  br i1 %287, label %345, label %288

288:                                              ; preds = %281
  %289 = load i64, ptr %283, align 8, !noalias !16
  %290 = icmp eq i64 %289, 0
  br i1 %290, label %308, label %291

291:                                              ; preds = %288
  %292 = load ptr, ptr %64, align 8, !noalias !16
  %293 = load ptr, ptr %65, align 8, !noalias !16
  store <8 x double> %226, ptr %293, align 8, !noalias !16
  %294 = load i64, ptr %66, align 8, !noalias !16
  %295 = icmp sgt i64 %294, 0
  br i1 %295, label %296, label %297

296:                                              ; preds = %291
  call fastcc void @sample(ptr noundef nonnull %15) #10, !noalias !16
  br label %297

297:                                              ; preds = %296, %291
  %298 = load ptr, ptr %61, align 8, !noalias !16
  %299 = load i64, ptr %298, align 8, !noalias !16
  %300 = load ptr, ptr %65, align 8, !noalias !16
  %301 = load ptr, ptr %17, align 8, !noalias !16
  %302 = load ptr, ptr %67, align 8, !noalias !16
  %303 = load ptr, ptr %68, align 8, !noalias !16
  %304 = inttoptr i64 %299 to ptr
  %305 = load ptr, ptr %304, align 8, !noalias !16
  %306 = call i32 %305(ptr noundef %300, ptr noundef %301, ptr noundef %302, ptr noundef %303, ptr noundef %292) #11, !noalias !16
  %307 = sext i32 %306 to i64
  br label %308

308:                                              ; preds = %288, %297
  %309 = phi i64 [ %307, %297 ], [ 0, %288 ]
  %310 = load i64, ptr %69, align 8, !noalias !16
  %311 = icmp sgt i64 %310, 7
  br i1 %311, label %312, label %333

312:                                              ; preds = %308
  %313 = trunc i64 %286 to i8
  %314 = bitcast i8 %313 to <8 x i1>
  br label %315

315:                                              ; preds = %312, %315
  %316 = phi i64 [ 0, %312 ], [ %329, %315 ]
  %317 = load ptr, ptr %64, align 8, !noalias !16
  %318 = shl nsw i64 %316, 6
  %319 = getelementptr inbounds i8, ptr %317, i64 %318
  %320 = load <8 x double>, ptr %319, align 8, !noalias !16
  %321 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %320)
  %322 = fcmp one <8 x double> %321, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %323 = bitcast <8 x double> %320 to <8 x i64>
  %324 = select <8 x i1> %322, <8 x i64> %323, <8 x i64> zeroinitializer
  %325 = load ptr, ptr %63, align 8, !noalias !16
  %326 = getelementptr inbounds i8, ptr %325, i64 %318
  %327 = load <8 x i64>, ptr %326, align 8, !noalias !16
  %328 = select <8 x i1> %314, <8 x i64> %324, <8 x i64> %327
  store <8 x i64> %328, ptr %326, align 8, !noalias !16
  %329 = add nuw nsw i64 %316, 1
  %330 = load i64, ptr %69, align 8, !noalias !16
  %331 = sdiv i64 %330, 8
  %332 = icmp slt i64 %329, %331
  br i1 %332, label %315, label %333, !llvm.loop !19

333:                                              ; preds = %315, %308
  %334 = icmp slt i64 %309, 0
  br i1 %334, label %1387, label %335

335:                                              ; preds = %333
  %336 = xor i64 %286, -1
  %337 = load i64, ptr %284, align 8, !noalias !16
  %338 = and i64 %337, %336
  store i64 %338, ptr %284, align 8, !noalias !16
  %339 = getelementptr inbounds i8, ptr %283, i64 16
  %340 = load i64, ptr %339, align 8, !noalias !16
  %341 = or i64 %340, %286
  store i64 %341, ptr %339, align 8, !noalias !16
  %342 = getelementptr inbounds i8, ptr %283, i64 24
  %343 = load i64, ptr %342, align 8, !noalias !16
  %344 = and i64 %343, %336
  store i64 %344, ptr %342, align 8, !noalias !16
  br label %345

345:                                              ; preds = %335, %281
  %346 = load ptr, ptr %61, align 8, !noalias !16
  %347 = load ptr, ptr %70, align 8, !noalias !16
  %348 = load <8 x double>, ptr %347, align 8, !noalias !16
  %349 = fsub <8 x double> %242, %348
  %350 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %349)
  %351 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %238)
  %352 = fmul <8 x double> %351, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %353 = fcmp ogt <8 x double> %350, %352
  %354 = bitcast <8 x i1> %353 to i8
  %355 = zext i8 %354 to i64
  %356 = getelementptr inbounds i8, ptr %346, i64 24
  %357 = load i64, ptr %356, align 8, !noalias !16
  %358 = xor i64 %357, -1
  %359 = or i64 %355, %358
  %360 = and i64 %359, %222
  %361 = icmp eq i64 %360, 0
  br i1 %361, label %431, label %362

362:                                              ; preds = %345
  %363 = trunc i64 %360 to i8
  %364 = bitcast i8 %363 to <8 x i1>
  %365 = bitcast <8 x double> %348 to <8 x i64>
  %366 = select <8 x i1> %364, <8 x i64> %241, <8 x i64> %365
  store <8 x i64> %366, ptr %347, align 8, !noalias !16
  %367 = load i64, ptr %71, align 8, !noalias !16
  %368 = sdiv i64 %367, 8
  %369 = load ptr, ptr %72, align 8, !noalias !16
  %370 = load ptr, ptr %73, align 8, !noalias !16
  %371 = icmp sgt i64 %367, 7
  br i1 %371, label %372, label %405

372:                                              ; preds = %362
  %373 = bitcast <8 x i64> %366 to <8 x double>
  %374 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %373
  %375 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %373
  %376 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %373
  br label %377

377:                                              ; preds = %372, %380
  %378 = phi i64 [ 0, %372 ], [ %381, %380 ]
  %379 = mul nuw nsw i64 %378, %368
  br label %383

380:                                              ; preds = %383
  %381 = add nuw nsw i64 %378, 1
  %382 = icmp eq i64 %381, %368
  br i1 %382, label %405, label %377, !llvm.loop !20

383:                                              ; preds = %377, %383
  %384 = phi i64 [ 0, %377 ], [ %403, %383 ]
  %385 = load ptr, ptr %74, align 8, !noalias !16
  %386 = add nuw nsw i64 %384, %379
  %387 = shl nsw i64 %386, 6
  %388 = getelementptr inbounds i8, ptr %385, i64 %387
  %389 = load <8 x double>, ptr %388, align 8, !noalias !16
  %390 = fneg <8 x double> %389
  %391 = icmp eq i64 %378, %384
  %392 = fsub <8 x double> %374, %389
  %393 = select i1 %391, <8 x double> %392, <8 x double> %390
  %394 = fsub <8 x double> %375, %389
  %395 = select i1 %391, <8 x double> %394, <8 x double> %390
  %396 = getelementptr inbounds i8, ptr %369, i64 %387
  store <8 x double> %393, ptr %396, align 8, !noalias !16
  %397 = select i1 %391, <8 x double> %376, <8 x double> zeroinitializer
  %398 = shl i64 %386, 7
  %399 = shl nsw i64 %386, 7
  %400 = getelementptr inbounds i8, ptr %370, i64 %399
  store <8 x double> %395, ptr %400, align 8, !noalias !16
  %401 = or disjoint i64 %398, 64
  %402 = getelementptr inbounds i8, ptr %370, i64 %401
  store <8 x double> %397, ptr %402, align 8, !noalias !16
  %403 = add nuw nsw i64 %384, 1
  %404 = icmp eq i64 %403, %368
  br i1 %404, label %380, label %383, !llvm.loop !21

405:                                              ; preds = %380, %362
  %406 = load ptr, ptr %75, align 8, !noalias !16
  %407 = call fastcc i64 @real_factorise(ptr noundef %369, i64 noundef %368, ptr noundef %406) #10, !noalias !16
  %408 = load ptr, ptr %76, align 8, !noalias !16
  %409 = call fastcc i64 @pair_factorise(ptr noundef %370, i64 noundef %368, ptr noundef %408) #10, !noalias !16
  %410 = or i64 %409, %407
  %411 = and i64 %410, %360
  %412 = load i64, ptr %356, align 8, !noalias !16
  %413 = or i64 %412, %360
  %414 = xor i64 %411, -1
  %415 = xor i64 %411, %413
  store i64 %415, ptr %356, align 8, !noalias !16
  %416 = trunc nuw i64 %411 to i8
  %417 = bitcast i8 %416 to <8 x i1>
  %418 = select <8 x i1> %417, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>, <8 x double> <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %419 = fmul <8 x double> %242, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %420 = select <8 x i1> %417, <8 x double> %419, <8 x double> %231
  %421 = load ptr, ptr %61, align 8, !noalias !16
  %422 = getelementptr inbounds i8, ptr %421, i64 8
  %423 = load i64, ptr %422, align 8, !noalias !16
  %424 = and i64 %423, %414
  %425 = getelementptr inbounds i8, ptr %421, i64 16
  %426 = load i64, ptr %425, align 8, !noalias !16
  %427 = xor i64 %426, -1
  %428 = and i64 %411, %427
  %429 = or disjoint i64 %428, %424
  store i64 %429, ptr %422, align 8, !noalias !16
  %430 = xor i64 %411, %222
  br label %431

431:                                              ; preds = %345, %405
  %432 = phi <8 x double> [ %231, %345 ], [ %420, %405 ]
  %433 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %345 ], [ %418, %405 ]
  %434 = phi i64 [ %222, %345 ], [ %430, %405 ]
  %435 = icmp eq i64 %434, 0
  br i1 %435, label %1387, label %436

436:                                              ; preds = %431
  %437 = fcmp ogt double %282, 0x3CB0000000000000
  %438 = select i1 %437, double %282, double 0x3CB0000000000000
  %439 = fdiv double 0x3CE4000000000000, %438
  %440 = call double @llvm.sqrt.f64(double %282)
  %441 = fcmp olt double %440, 3.000000e-02
  %442 = select i1 %441, double %440, double 3.000000e-02
  %443 = fcmp ogt double %442, %439
  %444 = load ptr, ptr %70, align 8, !noalias !16
  %445 = getelementptr inbounds i8, ptr %444, i64 64
  %446 = load <8 x double>, ptr %445, align 8, !noalias !16
  %447 = load ptr, ptr %15, align 8, !noalias !16
  %448 = getelementptr inbounds i8, ptr %447, i64 8
  %449 = load i64, ptr %448, align 8, !noalias !16
  %450 = load ptr, ptr %77, align 8, !noalias !16
  %451 = load ptr, ptr %17, align 8, !noalias !16
  %452 = load ptr, ptr %78, align 8, !noalias !16
  %453 = load ptr, ptr %79, align 8, !noalias !16
  %454 = fcmp ogt <8 x double> %446, zeroinitializer
  %455 = icmp sgt i64 %449, 0
  %456 = shl i64 %449, 7
  %457 = getelementptr i8, ptr %450, i64 %456
  %458 = mul nsw i64 %449, 3
  br label %463

459:                                              ; preds = %475
  %460 = icmp sgt i64 %449, 0
  %461 = shl i64 %449, 7
  %462 = getelementptr i8, ptr %452, i64 %461
  br label %509

463:                                              ; preds = %436, %475
  %464 = phi i64 [ 0, %436 ], [ %476, %475 ]
  %465 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %464
  %466 = load double, ptr %465, align 8, !noalias !16
  %467 = insertelement <8 x double> poison, double %466, i64 0
  %468 = shufflevector <8 x double> %467, <8 x double> poison, <8 x i32> zeroinitializer
  %469 = fmul <8 x double> %468, %242
  %470 = fdiv <8 x double> %469, %446
  %471 = fadd <8 x double> %470, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  br i1 %455, label %472, label %475

472:                                              ; preds = %463
  %473 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %471
  %474 = mul nuw nsw i64 %449, %464
  br label %478

475:                                              ; preds = %478, %463
  %476 = add nuw nsw i64 %464, 1
  %477 = icmp eq i64 %476, 3
  br i1 %477, label %459, label %463, !llvm.loop !22

478:                                              ; preds = %472, %478
  %479 = phi i64 [ 0, %472 ], [ %507, %478 ]
  %480 = shl i64 %479, 6
  %481 = getelementptr i8, ptr %457, i64 %480
  %482 = load <8 x double>, ptr %481, align 8, !noalias !16
  %483 = add nuw nsw i64 %479, %458
  %484 = shl nsw i64 %483, 6
  %485 = getelementptr inbounds i8, ptr %450, i64 %484
  %486 = load <8 x double>, ptr %485, align 8, !noalias !16
  %487 = fmul <8 x double> %471, %486
  %488 = fadd <8 x double> %482, %487
  %489 = fmul <8 x double> %473, %488
  %490 = shl nsw i64 %479, 6
  %491 = getelementptr inbounds i8, ptr %450, i64 %490
  %492 = load <8 x double>, ptr %491, align 8, !noalias !16
  %493 = add nuw nsw i64 %479, %449
  %494 = shl nsw i64 %493, 6
  %495 = getelementptr inbounds i8, ptr %450, i64 %494
  %496 = load <8 x double>, ptr %495, align 8, !noalias !16
  %497 = fadd <8 x double> %496, %489
  %498 = fmul <8 x double> %471, %497
  %499 = fadd <8 x double> %492, %498
  %500 = getelementptr inbounds i8, ptr %451, i64 %490
  %501 = load <8 x double>, ptr %500, align 8, !noalias !16
  %502 = fsub <8 x double> %499, %501
  %503 = add nuw nsw i64 %479, %474
  %504 = select <8 x i1> %454, <8 x double> %502, <8 x double> zeroinitializer
  %505 = shl nsw i64 %503, 6
  %506 = getelementptr inbounds i8, ptr %452, i64 %505
  store <8 x double> %504, ptr %506, align 8, !noalias !16
  %507 = add nuw nsw i64 %479, 1
  %508 = icmp eq i64 %507, %449
  br i1 %508, label %475, label %478, !llvm.loop !23

509:                                              ; preds = %459, %525
  %510 = phi i64 [ 0, %459 ], [ %526, %525 ]
  br i1 %460, label %511, label %525

511:                                              ; preds = %509
  %512 = mul nuw nsw i64 %449, %510
  %513 = getelementptr inbounds [3 x [3 x double]], ptr @TO_WAVES, i64 0, i64 %510
  %514 = load double, ptr %513, align 8, !noalias !16
  %515 = insertelement <8 x double> poison, double %514, i64 0
  %516 = shufflevector <8 x double> %515, <8 x double> poison, <8 x i32> zeroinitializer
  %517 = getelementptr inbounds i8, ptr %513, i64 8
  %518 = load double, ptr %517, align 8, !noalias !16
  %519 = insertelement <8 x double> poison, double %518, i64 0
  %520 = shufflevector <8 x double> %519, <8 x double> poison, <8 x i32> zeroinitializer
  %521 = getelementptr inbounds i8, ptr %513, i64 16
  %522 = load double, ptr %521, align 8, !noalias !16
  %523 = insertelement <8 x double> poison, double %522, i64 0
  %524 = shufflevector <8 x double> %523, <8 x double> poison, <8 x i32> zeroinitializer
  br label %528

525:                                              ; preds = %528, %509
  %526 = add nuw nsw i64 %510, 1
  %527 = icmp eq i64 %526, 3
  br i1 %527, label %550, label %509, !llvm.loop !24

528:                                              ; preds = %511, %528
  %529 = phi i64 [ 0, %511 ], [ %548, %528 ]
  %530 = add nuw nsw i64 %529, %512
  %531 = shl nsw i64 %529, 6
  %532 = getelementptr inbounds i8, ptr %452, i64 %531
  %533 = load <8 x double>, ptr %532, align 8, !noalias !16
  %534 = fmul <8 x double> %533, %516
  %535 = add nuw nsw i64 %529, %449
  %536 = shl nsw i64 %535, 6
  %537 = getelementptr inbounds i8, ptr %452, i64 %536
  %538 = load <8 x double>, ptr %537, align 8, !noalias !16
  %539 = fmul <8 x double> %538, %520
  %540 = fadd <8 x double> %534, %539
  %541 = shl i64 %529, 6
  %542 = getelementptr i8, ptr %462, i64 %541
  %543 = load <8 x double>, ptr %542, align 8, !noalias !16
  %544 = fmul <8 x double> %543, %524
  %545 = fadd <8 x double> %540, %544
  %546 = shl nsw i64 %530, 6
  %547 = getelementptr inbounds i8, ptr %453, i64 %546
  store <8 x double> %545, ptr %547, align 8, !noalias !16
  %548 = add nuw nsw i64 %529, 1
  %549 = icmp eq i64 %548, %449
  br i1 %549, label %525, label %528, !llvm.loop !25

550:                                              ; preds = %525
  %551 = select i1 %443, double %442, double %439
  %552 = fmul double %282, %551
  %553 = load ptr, ptr %61, align 8, !noalias !26
  %554 = getelementptr inbounds i8, ptr %553, i64 40
  %555 = load i64, ptr %554, align 8, !noalias !26
  %556 = icmp sgt i64 %555, 0
  %557 = select i1 %556, i64 10, i64 6
  %558 = fdiv <8 x double> <double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672, double 0x400572DB93E0C672>, %242
  %559 = fdiv <8 x double> <double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6, double 0xC0086747F2C3FCB6>, %242
  %560 = fdiv <8 x double> <double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D, double 0x400D1A48D83E731D>, %242
  %561 = fneg <8 x double> %559
  %562 = insertelement <8 x double> poison, double %551, i64 0
  %563 = shufflevector <8 x double> %562, <8 x double> poison, <8 x i32> zeroinitializer
  %564 = fmul double %552, %552
  %565 = insertelement <8 x double> poison, double %564, i64 0
  %566 = shufflevector <8 x double> %565, <8 x double> poison, <8 x i32> zeroinitializer
  br label %570

567:                                              ; preds = %1063
  %568 = add nuw nsw i64 %574, 1
  %569 = icmp eq i64 %568, %557
  br i1 %569, label %1077, label %570, !llvm.loop !29

570:                                              ; preds = %550, %567
  %571 = phi <8 x double> [ <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>, %550 ], [ %1075, %567 ]
  %572 = phi i64 [ %434, %550 ], [ %1074, %567 ]
  %573 = phi i64 [ 0, %550 ], [ %1073, %567 ]
  %574 = phi i64 [ 0, %550 ], [ %568, %567 ]
  %575 = phi i64 [ 0, %550 ], [ %1071, %567 ]
  %576 = phi i64 [ 0, %550 ], [ %657, %567 ]
  %577 = phi <8 x double> [ zeroinitializer, %550 ], [ %656, %567 ]
  %578 = phi <8 x double> [ zeroinitializer, %550 ], [ %1070, %567 ]
  %579 = phi <8 x double> [ zeroinitializer, %550 ], [ %1069, %567 ]
  %580 = phi <8 x double> [ %140, %550 ], [ %1068, %567 ]
  %581 = phi <8 x double> [ %139, %550 ], [ %1067, %567 ]
  %582 = phi <8 x double> [ %138, %550 ], [ %1066, %567 ]
  %583 = phi i64 [ %137, %550 ], [ %1065, %567 ]
  %584 = phi i64 [ %136, %550 ], [ %1064, %567 ]
  %585 = icmp ugt i64 %574, 5
  %586 = select i1 %585, i64 %575, i64 -1
  %587 = and i64 %572, %586
  %588 = load ptr, ptr %15, align 8, !noalias !26
  %589 = getelementptr inbounds i8, ptr %588, i64 8
  %590 = load i64, ptr %589, align 8, !noalias !26
  %591 = load ptr, ptr %78, align 8, !noalias !26
  %592 = icmp eq i64 %587, 0
  br i1 %592, label %655, label %593

593:                                              ; preds = %570
  %594 = icmp sgt i64 %590, 0
  %595 = shl i64 %590, 6
  br label %596

596:                                              ; preds = %593, %622
  %597 = phi i64 [ %587, %593 ], [ %635, %622 ]
  %598 = phi i64 [ 0, %593 ], [ %636, %622 ]
  %599 = phi i64 [ %576, %593 ], [ %633, %622 ]
  %600 = phi <8 x double> [ %577, %593 ], [ %607, %622 ]
  br i1 %594, label %601, label %603

601:                                              ; preds = %596
  %602 = mul nuw nsw i64 %598, %590
  br label %640

603:                                              ; preds = %640, %596
  %604 = trunc i64 %597 to i8
  %605 = bitcast i8 %604 to <8 x i1>
  %606 = select <8 x i1> %605, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %607 = fadd <8 x double> %600, %606
  %608 = load ptr, ptr %81, align 8, !noalias !26
  %609 = mul i64 %595, %598
  %610 = getelementptr inbounds i8, ptr %608, i64 %609
  %611 = getelementptr inbounds [3 x double], ptr @NODES, i64 0, i64 %598
  %612 = load double, ptr %611, align 8, !noalias !26
  %613 = insertelement <8 x double> poison, double %612, i64 0
  %614 = shufflevector <8 x double> %613, <8 x double> poison, <8 x i32> zeroinitializer
  %615 = fmul <8 x double> %614, %242
  %616 = fadd <8 x double> %226, %615
  %617 = load ptr, ptr %82, align 8, !noalias !26
  %618 = load ptr, ptr %83, align 8, !noalias !26
  store <8 x double> %616, ptr %618, align 8, !noalias !26
  %619 = load i64, ptr %84, align 8, !noalias !26
  %620 = icmp sgt i64 %619, 0
  br i1 %620, label %621, label %622

621:                                              ; preds = %603
  call fastcc void @sample(ptr noundef nonnull %15) #10, !noalias !26
  br label %622

622:                                              ; preds = %621, %603
  %623 = load ptr, ptr %15, align 8, !noalias !26
  %624 = load i64, ptr %623, align 8, !noalias !26
  %625 = load ptr, ptr %83, align 8, !noalias !26
  %626 = load ptr, ptr %85, align 8, !noalias !26
  %627 = load ptr, ptr %86, align 8, !noalias !26
  %628 = inttoptr i64 %624 to ptr
  %629 = load ptr, ptr %628, align 8, !noalias !26
  %630 = call i32 %629(ptr noundef %625, ptr noundef %617, ptr noundef %626, ptr noundef %627, ptr noundef %610) #11, !noalias !26
  %631 = sext i32 %630 to i64
  %632 = and i64 %597, %631
  %633 = or i64 %632, %599
  %634 = xor i64 %631, -1
  %635 = and i64 %597, %634
  %636 = add nuw nsw i64 %598, 1
  %637 = icmp ult i64 %598, 2
  %638 = icmp ne i64 %635, 0
  %639 = select i1 %637, i1 %638, i1 false
  br i1 %639, label %596, label %655, !llvm.loop !30

640:                                              ; preds = %601, %640
  %641 = phi i64 [ 0, %601 ], [ %653, %640 ]
  %642 = load ptr, ptr %80, align 8, !noalias !26
  %643 = load ptr, ptr %17, align 8, !noalias !26
  %644 = shl nsw i64 %641, 6
  %645 = getelementptr inbounds i8, ptr %643, i64 %644
  %646 = load <8 x double>, ptr %645, align 8, !noalias !26
  %647 = add nuw nsw i64 %641, %602
  %648 = shl nsw i64 %647, 6
  %649 = getelementptr inbounds i8, ptr %591, i64 %648
  %650 = load <8 x double>, ptr %649, align 8, !noalias !26
  %651 = fadd <8 x double> %646, %650
  %652 = getelementptr inbounds i8, ptr %642, i64 %644
  store <8 x double> %651, ptr %652, align 8, !noalias !26
  %653 = add nuw nsw i64 %641, 1
  %654 = icmp eq i64 %653, %590
  br i1 %654, label %603, label %640, !llvm.loop !31

655:                                              ; preds = %622, %570
  %656 = phi <8 x double> [ %577, %570 ], [ %607, %622 ]
  %657 = phi i64 [ %576, %570 ], [ %633, %622 ]
  %658 = phi i64 [ %587, %570 ], [ %635, %622 ]
  %659 = icmp eq i64 %658, 0
  br i1 %659, label %660, label %664

660:                                              ; preds = %655
  %661 = or i64 %587, %573
  %662 = xor i64 %661, -1
  %663 = and i64 %575, %662
  br label %1063

664:                                              ; preds = %655
  %665 = load ptr, ptr %15, align 8, !noalias !26
  %666 = getelementptr inbounds i8, ptr %665, i64 8
  %667 = load i64, ptr %666, align 8, !noalias !26
  %668 = load ptr, ptr %87, align 8, !noalias !26
  %669 = load ptr, ptr %79, align 8, !noalias !26
  %670 = icmp sgt i64 %667, 0
  br i1 %670, label %671, label %757

671:                                              ; preds = %664
  %672 = shl i64 %667, 7
  br label %673

673:                                              ; preds = %671, %673
  %674 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %671 ], [ %692, %673 ]
  %675 = phi i64 [ 0, %671 ], [ %755, %673 ]
  %676 = phi <8 x double> [ zeroinitializer, %671 ], [ %754, %673 ]
  %677 = shl nsw i64 %675, 6
  %678 = getelementptr inbounds i8, ptr %668, i64 %677
  %679 = load <8 x double>, ptr %678, align 8, !noalias !26
  %680 = add nuw nsw i64 %675, %667
  %681 = shl nsw i64 %680, 6
  %682 = getelementptr inbounds i8, ptr %668, i64 %681
  %683 = load <8 x double>, ptr %682, align 8, !noalias !26
  %684 = fadd <8 x double> %679, %683
  %685 = shl i64 %675, 6
  %686 = add i64 %685, %672
  %687 = getelementptr inbounds i8, ptr %668, i64 %686
  %688 = load <8 x double>, ptr %687, align 8, !noalias !26
  %689 = fadd <8 x double> %684, %688
  %690 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %689)
  %691 = fcmp one <8 x double> %690, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %692 = select <8 x i1> %691, <8 x i64> %674, <8 x i64> zeroinitializer
  %693 = getelementptr inbounds i8, ptr %669, i64 %681
  %694 = load <8 x double>, ptr %693, align 8, !noalias !26
  %695 = getelementptr inbounds i8, ptr %669, i64 %686
  %696 = load <8 x double>, ptr %695, align 8, !noalias !26
  %697 = fmul <8 x double> %679, <double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46, double 0xC010B70201A79C46>
  %698 = fmul <8 x double> %683, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %699 = fsub <8 x double> %697, %698
  %700 = fmul <8 x double> %688, <double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221, double 0x3FDE810014C55221>
  %701 = fadd <8 x double> %699, %700
  %702 = fmul <8 x double> %679, <double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2, double 0x3FE017885A24A7F2>
  %703 = fmul <8 x double> %683, <double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598, double 0x4004934E6FCAA598>
  %704 = fsub <8 x double> %702, %703
  %705 = fmul <8 x double> %688, <double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1, double 0x3FE312C0CF7BDFD1>
  %706 = fadd <8 x double> %704, %705
  %707 = fmul <8 x double> %679, <double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46, double 0x4010B70201A79C46>
  %708 = fmul <8 x double> %683, <double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86, double 0x3FD4F8C15DA84E86>
  %709 = fadd <8 x double> %707, %708
  %710 = fmul <8 x double> %688, <double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF, double 0x3FE0BF7FF59D56EF>
  %711 = fadd <8 x double> %709, %710
  %712 = getelementptr inbounds i8, ptr %669, i64 %677
  %713 = load <8 x double>, ptr %712, align 8, !noalias !26
  %714 = fmul <8 x double> %560, %713
  %715 = fsub <8 x double> %711, %714
  %716 = fmul <8 x double> %696, %561
  %717 = call <8 x double> @llvm.fma.v8f64(<8 x double> %558, <8 x double> %694, <8 x double> %716)
  %718 = fmul <8 x double> %559, %694
  %719 = call <8 x double> @llvm.fma.v8f64(<8 x double> %558, <8 x double> %696, <8 x double> %718)
  %720 = fsub <8 x double> %701, %717
  %721 = fsub <8 x double> %706, %719
  %722 = load ptr, ptr %88, align 8, !noalias !26
  %723 = getelementptr inbounds i8, ptr %722, i64 %677
  store <8 x double> %715, ptr %723, align 8, !noalias !26
  %724 = load ptr, ptr %89, align 8, !noalias !26
  %725 = shl i64 %675, 7
  %726 = shl nsw i64 %675, 7
  %727 = getelementptr inbounds i8, ptr %724, i64 %726
  store <8 x double> %720, ptr %727, align 8, !noalias !26
  %728 = or disjoint i64 %725, 64
  %729 = getelementptr inbounds i8, ptr %724, i64 %728
  store <8 x double> %721, ptr %729, align 8, !noalias !26
  %730 = load ptr, ptr %17, align 8, !noalias !26
  %731 = getelementptr inbounds i8, ptr %730, i64 %677
  %732 = load <8 x double>, ptr %731, align 8, !noalias !26
  %733 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %715)
  %734 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %720)
  %735 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %721)
  %736 = fadd <8 x double> %735, %734
  %737 = fadd <8 x double> %733, %736
  %738 = fmul <8 x double> %737, %242
  %739 = load ptr, ptr %90, align 8, !noalias !26
  %740 = getelementptr inbounds double, ptr %739, i64 %675
  %741 = load double, ptr %740, align 8, !noalias !26
  %742 = insertelement <8 x double> poison, double %741, i64 0
  %743 = shufflevector <8 x double> %742, <8 x double> poison, <8 x i32> zeroinitializer
  %744 = load ptr, ptr %62, align 8, !noalias !26
  %745 = getelementptr inbounds double, ptr %744, i64 %675
  %746 = load double, ptr %745, align 8, !noalias !26
  %747 = insertelement <8 x double> poison, double %746, i64 0
  %748 = shufflevector <8 x double> %747, <8 x double> poison, <8 x i32> zeroinitializer
  %749 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %732)
  %750 = fmul <8 x double> %749, %748
  %751 = fadd <8 x double> %743, %750
  %752 = fdiv <8 x double> %738, %751
  %753 = fmul <8 x double> %752, %752
  %754 = fadd <8 x double> %676, %753
  %755 = add nuw nsw i64 %675, 1
  %756 = icmp eq i64 %755, %667
  br i1 %756, label %757, label %673, !llvm.loop !32

757:                                              ; preds = %673, %664
  %758 = phi <8 x double> [ zeroinitializer, %664 ], [ %754, %673 ]
  %759 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %664 ], [ %692, %673 ]
  %760 = icmp ne <8 x i64> %759, zeroinitializer
  %761 = bitcast <8 x i1> %760 to i8
  %762 = zext i8 %761 to i64
  %763 = and i64 %658, %762
  %764 = xor i64 %763, %658
  %765 = trunc i64 %764 to i8
  %766 = bitcast i8 %765 to <8 x i1>
  %767 = load ptr, ptr %15, align 8, !noalias !26
  %768 = getelementptr inbounds i8, ptr %767, i64 8
  %769 = load i64, ptr %768, align 8, !noalias !26
  %770 = load i64, ptr %92, align 8, !noalias !26
  %771 = sdiv i64 %770, 8
  %772 = load ptr, ptr %61, align 8, !noalias !26
  %773 = getelementptr inbounds i8, ptr %772, i64 40
  %774 = load i64, ptr %773, align 8, !noalias !26
  %775 = load ptr, ptr %93, align 8, !noalias !26
  %776 = load ptr, ptr %94, align 8, !noalias !26
  %777 = load ptr, ptr %95, align 8, !noalias !26
  %778 = load ptr, ptr %91, align 8, !noalias !26
  call fastcc void @real_solve(ptr noundef %777, i64 noundef %771, ptr noundef %778, ptr noundef %775) #10, !noalias !26
  %779 = load ptr, ptr %96, align 8, !noalias !26
  %780 = load ptr, ptr %97, align 8, !noalias !26
  call fastcc void @pair_solve(ptr noundef %779, i64 noundef %771, ptr noundef %780, ptr noundef %776) #10, !noalias !26
  %781 = icmp sgt i64 %774, 0
  br i1 %781, label %782, label %791

782:                                              ; preds = %757
  %783 = load ptr, ptr %95, align 8, !noalias !26
  %784 = load ptr, ptr %91, align 8, !noalias !26
  %785 = shl nsw i64 %771, 6
  %786 = getelementptr inbounds i8, ptr %775, i64 %785
  call fastcc void @real_solve_columns(ptr noundef %783, i64 noundef %771, ptr noundef %784, ptr noundef %786, i64 noundef %774) #10, !noalias !26
  %787 = load ptr, ptr %96, align 8, !noalias !26
  %788 = load ptr, ptr %97, align 8, !noalias !26
  %789 = shl nsw i64 %771, 7
  %790 = getelementptr inbounds i8, ptr %776, i64 %789
  call fastcc void @pair_solve_columns(ptr noundef %787, i64 noundef %771, ptr noundef %788, ptr noundef %790, i64 noundef %774) #10, !noalias !26
  br label %791

791:                                              ; preds = %782, %757
  %792 = icmp sgt i64 %769, 0
  br i1 %792, label %793, label %834

793:                                              ; preds = %791
  %794 = load ptr, ptr %17, align 8, !noalias !26
  %795 = load ptr, ptr %98, align 8, !noalias !26
  %796 = load ptr, ptr %62, align 8, !noalias !26
  br label %797

797:                                              ; preds = %793, %797
  %798 = phi <8 x double> [ zeroinitializer, %793 ], [ %831, %797 ]
  %799 = phi i64 [ 0, %793 ], [ %832, %797 ]
  %800 = shl nsw i64 %799, 6
  %801 = getelementptr inbounds i8, ptr %794, i64 %800
  %802 = load <8 x double>, ptr %801, align 8, !noalias !26
  %803 = getelementptr inbounds double, ptr %795, i64 %799
  %804 = load double, ptr %803, align 8, !noalias !26
  %805 = insertelement <8 x double> poison, double %804, i64 0
  %806 = shufflevector <8 x double> %805, <8 x double> poison, <8 x i32> zeroinitializer
  %807 = getelementptr inbounds double, ptr %796, i64 %799
  %808 = load double, ptr %807, align 8, !noalias !26
  %809 = insertelement <8 x double> poison, double %808, i64 0
  %810 = shufflevector <8 x double> %809, <8 x double> poison, <8 x i32> zeroinitializer
  %811 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %802)
  %812 = fmul <8 x double> %811, %810
  %813 = fadd <8 x double> %806, %812
  %814 = getelementptr inbounds i8, ptr %775, i64 %800
  %815 = load <8 x double>, ptr %814, align 8, !noalias !26
  %816 = fdiv <8 x double> %815, %813
  %817 = shl i64 %799, 7
  %818 = shl nsw i64 %799, 7
  %819 = getelementptr inbounds i8, ptr %776, i64 %818
  %820 = load <8 x double>, ptr %819, align 8, !noalias !33
  %821 = or disjoint i64 %817, 64
  %822 = getelementptr inbounds i8, ptr %776, i64 %821
  %823 = load <8 x double>, ptr %822, align 8, !noalias !33
  %824 = fdiv <8 x double> %820, %813
  %825 = fdiv <8 x double> %823, %813
  %826 = fmul <8 x double> %816, %816
  %827 = fmul <8 x double> %824, %824
  %828 = fadd <8 x double> %826, %827
  %829 = fmul <8 x double> %825, %825
  %830 = fadd <8 x double> %829, %828
  %831 = fadd <8 x double> %798, %830
  %832 = add nuw nsw i64 %799, 1
  %833 = icmp eq i64 %832, %769
  br i1 %833, label %834, label %797, !llvm.loop !36

834:                                              ; preds = %797, %791
  %835 = phi <8 x double> [ zeroinitializer, %791 ], [ %831, %797 ]
  %836 = mul nsw i64 %769, 3
  %837 = sitofp i64 %836 to double
  %838 = insertelement <8 x double> poison, double %837, i64 0
  %839 = shufflevector <8 x double> %838, <8 x double> poison, <8 x i32> zeroinitializer
  %840 = fdiv <8 x double> %835, %839
  %841 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %840)
  %842 = fcmp oeq <8 x double> %841, zeroinitializer
  %843 = fcmp ogt <8 x double> %758, zeroinitializer
  %844 = and <8 x i1> %842, %843
  %845 = bitcast <8 x i1> %844 to i8
  %846 = zext i8 %845 to i64
  %847 = xor i64 %846, -1
  %848 = and i64 %763, %847
  %849 = xor i64 %575, -1
  %850 = and i64 %848, %849
  %851 = trunc nuw i64 %850 to i8
  %852 = bitcast i8 %851 to <8 x i1>
  %853 = fcmp ogt <8 x double> %571, zeroinitializer
  %854 = select <8 x i1> %853, <8 x i1> %852, <8 x i1> zeroinitializer
  %855 = fdiv <8 x double> %841, %571
  %856 = select <8 x i1> %766, <8 x double> <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, <8 x double> %578
  %857 = select <8 x i1> %854, <8 x double> %855, <8 x double> %856
  %858 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %857
  %859 = fdiv <8 x double> %841, %858
  %860 = icmp ult i64 %574, 5
  br i1 %860, label %971, label %861

861:                                              ; preds = %971, %834
  %862 = phi <8 x double> [ %859, %834 ], [ %974, %971 ]
  %863 = fcmp oge <8 x double> %857, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %864 = fcmp ogt <8 x double> %862, %563
  %865 = or <8 x i1> %864, %863
  %866 = select <8 x i1> %865, <8 x i1> %854, <8 x i1> zeroinitializer
  %867 = bitcast <8 x i1> %866 to i8
  %868 = zext i8 %867 to i64
  %869 = xor i64 %868, -1
  %870 = and i64 %848, %869
  %871 = xor i64 %870, -1
  %872 = and i64 %587, %871
  %873 = or i64 %872, %573
  %874 = load ptr, ptr %15, align 8, !noalias !26
  %875 = getelementptr inbounds i8, ptr %874, i64 8
  %876 = load i64, ptr %875, align 8, !noalias !26
  %877 = trunc nuw i64 %870 to i8
  %878 = bitcast i8 %877 to <8 x i1>
  %879 = load ptr, ptr %78, align 8, !noalias !26
  %880 = load ptr, ptr %79, align 8, !noalias !26
  %881 = icmp sgt i64 %876, 0
  br i1 %881, label %882, label %953

882:                                              ; preds = %861
  %883 = shl i64 %876, 7
  %884 = getelementptr i8, ptr %880, i64 %883
  br label %885

885:                                              ; preds = %882, %919
  %886 = phi i64 [ 0, %882 ], [ %920, %919 ]
  %887 = load ptr, ptr %94, align 8, !noalias !26
  %888 = shl i64 %886, 7
  %889 = shl nsw i64 %886, 7
  %890 = getelementptr inbounds i8, ptr %887, i64 %889
  %891 = load <8 x double>, ptr %890, align 8, !noalias !37
  %892 = or disjoint i64 %888, 64
  %893 = getelementptr inbounds i8, ptr %887, i64 %892
  %894 = load <8 x double>, ptr %893, align 8, !noalias !37
  %895 = load ptr, ptr %93, align 8, !noalias !26
  %896 = shl nsw i64 %886, 6
  %897 = getelementptr inbounds i8, ptr %895, i64 %896
  %898 = load <8 x double>, ptr %897, align 8, !noalias !26
  store <8 x double> %898, ptr %4, align 64, !noalias !26
  store <8 x double> %891, ptr %99, align 64, !noalias !26
  store <8 x double> %894, ptr %100, align 64, !noalias !26
  br label %906

899:                                              ; preds = %906
  %900 = getelementptr inbounds i8, ptr %880, i64 %896
  %901 = add nuw nsw i64 %886, %876
  %902 = shl nsw i64 %901, 6
  %903 = getelementptr inbounds i8, ptr %880, i64 %902
  %904 = shl i64 %886, 6
  %905 = getelementptr i8, ptr %884, i64 %904
  br label %922

906:                                              ; preds = %885, %906
  %907 = phi i64 [ 0, %885 ], [ %917, %906 ]
  %908 = mul nuw nsw i64 %876, %907
  %909 = add nuw nsw i64 %908, %886
  %910 = shl nsw i64 %909, 6
  %911 = getelementptr inbounds i8, ptr %880, i64 %910
  %912 = load <8 x double>, ptr %911, align 8, !noalias !26
  %913 = getelementptr inbounds [3 x <8 x double>], ptr %4, i64 0, i64 %907
  %914 = load <8 x double>, ptr %913, align 64, !noalias !26
  %915 = fadd <8 x double> %912, %914
  %916 = select <8 x i1> %878, <8 x double> %915, <8 x double> %912
  store <8 x double> %916, ptr %911, align 8, !noalias !26
  %917 = add nuw nsw i64 %907, 1
  %918 = icmp eq i64 %917, 3
  br i1 %918, label %899, label %906, !llvm.loop !40

919:                                              ; preds = %922
  %920 = add nuw nsw i64 %886, 1
  %921 = icmp eq i64 %920, %876
  br i1 %921, label %953, label %885, !llvm.loop !41

922:                                              ; preds = %899, %922
  %923 = phi i64 [ 0, %899 ], [ %951, %922 ]
  %924 = mul nuw nsw i64 %876, %923
  %925 = add nuw nsw i64 %924, %886
  %926 = getelementptr inbounds [3 x [3 x double]], ptr @FROM_WAVES, i64 0, i64 %923
  %927 = load double, ptr %926, align 8, !noalias !26
  %928 = insertelement <8 x double> poison, double %927, i64 0
  %929 = shufflevector <8 x double> %928, <8 x double> poison, <8 x i32> zeroinitializer
  %930 = load <8 x double>, ptr %900, align 8, !noalias !26
  %931 = fmul <8 x double> %930, %929
  %932 = getelementptr inbounds i8, ptr %926, i64 8
  %933 = load double, ptr %932, align 8, !noalias !26
  %934 = insertelement <8 x double> poison, double %933, i64 0
  %935 = shufflevector <8 x double> %934, <8 x double> poison, <8 x i32> zeroinitializer
  %936 = load <8 x double>, ptr %903, align 8, !noalias !26
  %937 = fmul <8 x double> %936, %935
  %938 = fadd <8 x double> %931, %937
  %939 = getelementptr inbounds i8, ptr %926, i64 16
  %940 = load double, ptr %939, align 8, !noalias !26
  %941 = insertelement <8 x double> poison, double %940, i64 0
  %942 = shufflevector <8 x double> %941, <8 x double> poison, <8 x i32> zeroinitializer
  %943 = load <8 x double>, ptr %905, align 8, !noalias !26
  %944 = fmul <8 x double> %943, %942
  %945 = fadd <8 x double> %938, %944
  %946 = shl nsw i64 %925, 6
  %947 = getelementptr inbounds i8, ptr %879, i64 %946
  %948 = load <8 x i64>, ptr %947, align 8, !noalias !26
  %949 = bitcast <8 x double> %945 to <8 x i64>
  %950 = select <8 x i1> %878, <8 x i64> %949, <8 x i64> %948
  store <8 x i64> %950, ptr %947, align 8, !noalias !26
  %951 = add nuw nsw i64 %923, 1
  %952 = icmp eq i64 %951, 3
  br i1 %952, label %919, label %922, !llvm.loop !42

953:                                              ; preds = %919, %861
  %954 = fdiv <8 x double> %857, %858
  %955 = fmul <8 x double> %841, %954
  %956 = fcmp olt <8 x double> %955, %563
  %957 = and <8 x i1> %956, %853
  %958 = or <8 x i1> %957, %842
  %959 = bitcast <8 x i1> %958 to i8
  %960 = zext i8 %959 to i64
  %961 = and i64 %960, %849
  %962 = and i64 %961, %870
  %963 = trunc nuw i64 %962 to i8
  %964 = bitcast i8 %963 to <8 x i1>
  %965 = add nuw nsw i64 %574, 1
  %966 = uitofp nneg i64 %965 to double
  %967 = insertelement <8 x double> poison, double %966, i64 0
  %968 = shufflevector <8 x double> %967, <8 x double> poison, <8 x i32> zeroinitializer
  %969 = select <8 x i1> %964, <8 x double> %968, <8 x double> %579
  %970 = or i64 %962, %575
  br i1 %556, label %977, label %1056

971:                                              ; preds = %834, %971
  %972 = phi i64 [ %975, %971 ], [ %574, %834 ]
  %973 = phi <8 x double> [ %974, %971 ], [ %859, %834 ]
  %974 = fmul <8 x double> %973, %857
  %975 = add nuw nsw i64 %972, 1
  %976 = icmp ult i64 %972, 4
  br i1 %976, label %971, label %861, !llvm.loop !43

977:                                              ; preds = %953
  %978 = load i64, ptr %92, align 8, !noalias !26
  %979 = sdiv i64 %978, 8
  %980 = load ptr, ptr %61, align 8, !noalias !26
  %981 = getelementptr inbounds i8, ptr %980, i64 40
  %982 = load i64, ptr %981, align 8, !noalias !26
  %983 = load ptr, ptr %15, align 8, !noalias !26
  %984 = getelementptr inbounds i8, ptr %983, i64 8
  %985 = load i64, ptr %984, align 8, !noalias !26
  %986 = load ptr, ptr %79, align 8, !noalias !26
  %987 = icmp sgt i64 %982, 0
  br i1 %987, label %988, label %1050

988:                                              ; preds = %977
  %989 = icmp sgt i64 %978, 7
  br label %990

990:                                              ; preds = %988, %998
  %991 = phi <8 x double> [ zeroinitializer, %988 ], [ %1006, %998 ]
  %992 = phi i64 [ 0, %988 ], [ %1007, %998 ]
  br i1 %989, label %993, label %998

993:                                              ; preds = %990
  %994 = add nuw i64 %992, %979
  %995 = load ptr, ptr %93, align 8, !noalias !26
  %996 = load ptr, ptr %17, align 8, !noalias !26
  %997 = load ptr, ptr %94, align 8, !noalias !26
  br label %1009

998:                                              ; preds = %1034, %990
  %999 = phi <8 x double> [ zeroinitializer, %990 ], [ %1047, %1034 ]
  %1000 = phi <8 x double> [ zeroinitializer, %990 ], [ %1035, %1034 ]
  %1001 = fcmp ogt <8 x double> %999, zeroinitializer
  %1002 = fdiv <8 x double> %1000, %999
  %1003 = fmul <8 x double> %991, %999
  %1004 = fcmp ogt <8 x double> %1000, %1003
  %1005 = select <8 x i1> %1001, <8 x double> %1002, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1006 = select <8 x i1> %1004, <8 x double> %1005, <8 x double> %991
  %1007 = add nuw nsw i64 %992, 1
  %1008 = icmp eq i64 %1007, %982
  br i1 %1008, label %1050, label %990, !llvm.loop !44

1009:                                             ; preds = %993, %1034
  %1010 = phi <8 x double> [ zeroinitializer, %993 ], [ %1035, %1034 ]
  %1011 = phi i64 [ 0, %993 ], [ %1036, %1034 ]
  %1012 = phi <8 x double> [ zeroinitializer, %993 ], [ %1047, %1034 ]
  %1013 = mul nuw nsw i64 %1011, %982
  %1014 = add i64 %994, %1013
  %1015 = shl nsw i64 %1014, 6
  %1016 = getelementptr inbounds i8, ptr %995, i64 %1015
  %1017 = load <8 x double>, ptr %1016, align 8, !noalias !26
  %1018 = getelementptr inbounds i8, ptr %996, i64 %1015
  %1019 = load <8 x double>, ptr %1018, align 8, !noalias !26
  %1020 = shl i64 %1014, 7
  %1021 = shl nsw i64 %1014, 7
  %1022 = getelementptr inbounds i8, ptr %997, i64 %1021
  %1023 = load <8 x double>, ptr %1022, align 8, !noalias !45
  %1024 = or disjoint i64 %1020, 64
  %1025 = getelementptr inbounds i8, ptr %997, i64 %1024
  %1026 = load <8 x double>, ptr %1025, align 8, !noalias !45
  %1027 = fmul <8 x double> %1017, %1017
  %1028 = fmul <8 x double> %1023, %1023
  %1029 = fmul <8 x double> %1026, %1026
  %1030 = fadd <8 x double> %1028, %1029
  %1031 = fadd <8 x double> %1027, %1030
  %1032 = fmul <8 x double> %1019, %1019
  %1033 = fadd <8 x double> %1012, %1032
  br label %1038

1034:                                             ; preds = %1038
  %1035 = fadd <8 x double> %1010, %1031
  %1036 = add nuw nsw i64 %1011, 1
  %1037 = icmp eq i64 %1036, %979
  br i1 %1037, label %998, label %1009, !llvm.loop !48

1038:                                             ; preds = %1009, %1038
  %1039 = phi i64 [ 0, %1009 ], [ %1048, %1038 ]
  %1040 = phi <8 x double> [ %1033, %1009 ], [ %1047, %1038 ]
  %1041 = mul nsw i64 %985, %1039
  %1042 = add nsw i64 %1041, %1014
  %1043 = shl nsw i64 %1042, 6
  %1044 = getelementptr inbounds i8, ptr %986, i64 %1043
  %1045 = load <8 x double>, ptr %1044, align 8, !noalias !26
  %1046 = fmul <8 x double> %1045, %1045
  %1047 = fadd <8 x double> %1040, %1046
  %1048 = add nuw nsw i64 %1039, 1
  %1049 = icmp eq i64 %1048, 3
  br i1 %1049, label %1034, label %1038, !llvm.loop !49

1050:                                             ; preds = %998, %977
  %1051 = phi <8 x double> [ zeroinitializer, %977 ], [ %1006, %998 ]
  %1052 = fcmp ole <8 x double> %1051, %566
  %1053 = bitcast <8 x i1> %1052 to i8
  %1054 = zext i8 %1053 to i64
  %1055 = and i64 %970, %1054
  br label %1056

1056:                                             ; preds = %1050, %953
  %1057 = phi i64 [ %1055, %1050 ], [ %970, %953 ]
  %1058 = xor i64 %1057, -1
  %1059 = and i64 %870, %1058
  %1060 = icmp eq i64 %1059, 0
  %1061 = select i1 %1060, i32 2, i32 0
  %1062 = select i1 %1060, <8 x double> %571, <8 x double> %841
  br label %1063

1063:                                             ; preds = %1056, %660
  %1064 = phi i64 [ %663, %660 ], [ %584, %1056 ]
  %1065 = phi i64 [ %657, %660 ], [ %583, %1056 ]
  %1066 = phi <8 x double> [ %579, %660 ], [ %582, %1056 ]
  %1067 = phi <8 x double> [ %578, %660 ], [ %581, %1056 ]
  %1068 = phi <8 x double> [ %656, %660 ], [ %580, %1056 ]
  %1069 = phi <8 x double> [ %579, %660 ], [ %969, %1056 ]
  %1070 = phi <8 x double> [ %578, %660 ], [ %857, %1056 ]
  %1071 = phi i64 [ %663, %660 ], [ %970, %1056 ]
  %1072 = phi i32 [ 1, %660 ], [ %1061, %1056 ]
  %1073 = phi i64 [ %573, %660 ], [ %873, %1056 ]
  %1074 = phi i64 [ %587, %660 ], [ %1059, %1056 ]
  %1075 = phi <8 x double> [ %571, %660 ], [ %1062, %1056 ]
  %1076 = icmp eq i32 %1072, 0
  br i1 %1076, label %567, label %1077

1077:                                             ; preds = %1063, %567
  %1078 = phi i32 [ %1072, %1063 ], [ 2, %567 ]
  %1079 = icmp eq i32 %1078, 2
  br i1 %1079, label %1080, label %1083

1080:                                             ; preds = %1077
  %1081 = xor i64 %1073, -1
  %1082 = and i64 %1071, %1081
  br label %1083

1083:                                             ; preds = %1077, %1080
  %1084 = phi i64 [ %1082, %1080 ], [ %1064, %1077 ]
  %1085 = phi i64 [ %657, %1080 ], [ %1065, %1077 ]
  %1086 = phi <8 x double> [ %1069, %1080 ], [ %1066, %1077 ]
  %1087 = phi <8 x double> [ %1070, %1080 ], [ %1067, %1077 ]
  %1088 = phi <8 x double> [ %656, %1080 ], [ %1068, %1077 ]
  %1089 = fadd <8 x double> %1088, zeroinitializer
  %1090 = fcmp ogt <8 x double> %1086, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %1091 = fcmp ogt <8 x double> %1087, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %1092 = and <8 x i1> %1091, %1090
  %1093 = bitcast <8 x i1> %1092 to i8
  %1094 = icmp eq i64 %1084, %434
  br i1 %1094, label %1171, label %1095

1095:                                             ; preds = %1083
  %1096 = xor i64 %1084, -1
  %1097 = and i64 %434, %1096
  %1098 = load ptr, ptr %61, align 8, !noalias !16
  %1099 = getelementptr inbounds i8, ptr %1098, i64 16
  %1100 = load i64, ptr %1099, align 8, !noalias !16
  %1101 = xor i64 %1085, -1
  %1102 = and i64 %1100, %1101
  %1103 = and i64 %1102, %1097
  %1104 = trunc i64 %1097 to i8
  %1105 = bitcast i8 %1104 to <8 x i1>
  %1106 = trunc i64 %1085 to i8
  %1107 = bitcast i8 %1106 to <8 x i1>
  %1108 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1087)
  %1109 = fcmp one <8 x double> %1108, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1110 = select <8 x i1> %1109, <8 x double> <double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00, double 7.000000e+00>, <8 x double> <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %1111 = select <8 x i1> %1107, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1110
  %1112 = select <8 x i1> %1105, <8 x double> %1111, <8 x double> %433
  %1113 = icmp eq i64 %1103, 0
  br i1 %1113, label %1141, label %1114

1114:                                             ; preds = %1095
  %1115 = load i64, ptr %101, align 8, !noalias !16
  %1116 = icmp sgt i64 %1115, 7
  br i1 %1116, label %1117, label %1134

1117:                                             ; preds = %1114
  %1118 = trunc i64 %1103 to i8
  %1119 = bitcast i8 %1118 to <8 x i1>
  br label %1120

1120:                                             ; preds = %1117, %1120
  %1121 = phi <8 x i64> [ zeroinitializer, %1117 ], [ %1128, %1120 ]
  %1122 = phi i64 [ 0, %1117 ], [ %1130, %1120 ]
  %1123 = load ptr, ptr %102, align 8, !noalias !16
  %1124 = shl nsw i64 %1122, 6
  %1125 = getelementptr inbounds i8, ptr %1123, i64 %1124
  %1126 = load <8 x double>, ptr %1125, align 8, !noalias !16
  %1127 = fcmp une <8 x double> %1126, zeroinitializer
  %1128 = select <8 x i1> %1127, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %1121
  %1129 = select <8 x i1> %1119, <8 x double> zeroinitializer, <8 x double> %1126
  store <8 x double> %1129, ptr %1125, align 8, !noalias !16
  %1130 = add nuw nsw i64 %1122, 1
  %1131 = load i64, ptr %101, align 8, !noalias !16
  %1132 = sdiv i64 %1131, 8
  %1133 = icmp slt i64 %1130, %1132
  br i1 %1133, label %1120, label %1134, !llvm.loop !50

1134:                                             ; preds = %1120, %1114
  %1135 = phi <8 x i64> [ zeroinitializer, %1114 ], [ %1128, %1120 ]
  %1136 = icmp ne <8 x i64> %1135, zeroinitializer
  %1137 = bitcast <8 x i1> %1136 to i8
  %1138 = zext i8 %1137 to i64
  %1139 = and i64 %1103, %1138
  %1140 = xor i64 %1139, -1
  br label %1141

1141:                                             ; preds = %1095, %1134
  %1142 = phi i64 [ -1, %1095 ], [ %1140, %1134 ]
  %1143 = and i64 %1142, %1103
  %1144 = getelementptr inbounds i8, ptr %1098, i64 24
  %1145 = load i64, ptr %1144, align 8, !noalias !16
  %1146 = and i64 %1145, %1142
  store i64 %1146, ptr %1144, align 8, !noalias !16
  %1147 = xor i64 %1143, -1
  %1148 = load i64, ptr %1099, align 8, !noalias !16
  %1149 = and i64 %1148, %1147
  store i64 %1149, ptr %1099, align 8, !noalias !16
  %1150 = trunc i64 %1143 to i8
  %1151 = bitcast i8 %1150 to <8 x i1>
  %1152 = fmul <8 x double> %242, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %1153 = select <8 x i1> %1151, <8 x double> %1152, <8 x double> %432
  %1154 = fmul <8 x double> %242, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1155 = select <8 x i1> %1107, <8 x double> %1154, <8 x double> %1153
  %1156 = load ptr, ptr %70, align 8, !noalias !16
  %1157 = getelementptr inbounds i8, ptr %1156, i64 64
  %1158 = load <8 x double>, ptr %1157, align 8, !noalias !16
  %1159 = select <8 x i1> %1107, <8 x double> zeroinitializer, <8 x double> %1158
  store <8 x double> %1159, ptr %1157, align 8, !noalias !16
  %1160 = and i64 %1142, %1097
  %1161 = load ptr, ptr %61, align 8, !noalias !16
  %1162 = getelementptr inbounds i8, ptr %1161, i64 8
  %1163 = load i64, ptr %1162, align 8, !noalias !16
  %1164 = xor i64 %1160, -1
  %1165 = and i64 %1163, %1164
  %1166 = getelementptr inbounds i8, ptr %1161, i64 16
  %1167 = load i64, ptr %1166, align 8, !noalias !16
  %1168 = xor i64 %1167, -1
  %1169 = and i64 %1160, %1168
  %1170 = or disjoint i64 %1169, %1165
  store i64 %1170, ptr %1162, align 8, !noalias !16
  br label %1171

1171:                                             ; preds = %1141, %1083
  %1172 = phi <8 x double> [ %432, %1083 ], [ %1155, %1141 ]
  %1173 = phi <8 x double> [ %433, %1083 ], [ %1112, %1141 ]
  %1174 = icmp eq i64 %1084, 0
  br i1 %1174, label %1387, label %1175

1175:                                             ; preds = %1171
  %1176 = icmp sgt i64 %270, 0
  br i1 %1176, label %1177, label %1179

1177:                                             ; preds = %1175
  %1178 = shl i64 %270, 7
  br label %1371

1179:                                             ; preds = %1371, %1175
  %1180 = getelementptr inbounds i8, ptr %283, i64 32
  %1181 = load i64, ptr %1180, align 8, !noalias !16
  %1182 = load ptr, ptr %15, align 8, !noalias !16
  %1183 = getelementptr inbounds i8, ptr %1182, i64 8
  %1184 = load i64, ptr %1183, align 8, !noalias !16
  %1185 = load i64, ptr %105, align 8, !noalias !16
  %1186 = sdiv i64 %1185, 8
  %1187 = load ptr, ptr %106, align 8, !noalias !16
  %1188 = load ptr, ptr %107, align 8, !noalias !16
  %1189 = icmp sgt i64 %1184, 0
  br i1 %1189, label %1190, label %1192

1190:                                             ; preds = %1179
  %1191 = shl i64 %1184, 7
  br label %1207

1192:                                             ; preds = %1207, %1179
  %1193 = load ptr, ptr %109, align 8, !noalias !16
  %1194 = load ptr, ptr %104, align 8, !noalias !16
  call fastcc void @real_solve(ptr noundef %1193, i64 noundef %1186, ptr noundef %1194, ptr noundef %1188) #10, !noalias !16
  %1195 = load ptr, ptr %110, align 8, !noalias !16
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %1188, ptr noundef %1195, ptr noundef nonnull %17, i64 noundef %1184) #10, !noalias !16
  %1196 = load <8 x double>, ptr %5, align 16, !noalias !16
  %1197 = fcmp olt <8 x double> %1196, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1198 = bitcast <8 x i1> %1197 to i8
  %1199 = zext i8 %1198 to i64
  %1200 = xor i64 %1199, -1
  %1201 = and i64 %1181, %1200
  %1202 = and i64 %1201, %1084
  %1203 = and i64 %1084, %1199
  %1204 = icmp eq i64 %1202, 0
  br i1 %1204, label %1301, label %1205

1205:                                             ; preds = %1192
  %1206 = icmp sgt i64 %1184, 0
  br i1 %1206, label %1261, label %1235

1207:                                             ; preds = %1190, %1207
  %1208 = phi i64 [ 0, %1190 ], [ %1233, %1207 ]
  %1209 = load ptr, ptr %78, align 8, !noalias !16
  %1210 = shl nsw i64 %1208, 6
  %1211 = getelementptr inbounds i8, ptr %1209, i64 %1210
  %1212 = load <8 x double>, ptr %1211, align 8, !noalias !16
  %1213 = fmul <8 x double> %1212, <double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05, double 0x402418FD8BAFFE05>
  %1214 = add nuw nsw i64 %1208, %1184
  %1215 = shl nsw i64 %1214, 6
  %1216 = getelementptr inbounds i8, ptr %1209, i64 %1215
  %1217 = load <8 x double>, ptr %1216, align 8, !noalias !16
  %1218 = fmul <8 x double> %1217, <double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580, double 0x3FF61D41B2D54580>
  %1219 = fsub <8 x double> %1218, %1213
  %1220 = shl i64 %1208, 6
  %1221 = getelementptr i8, ptr %1209, i64 %1191
  %1222 = getelementptr i8, ptr %1221, i64 %1220
  %1223 = load <8 x double>, ptr %1222, align 8, !noalias !16
  %1224 = fmul <8 x double> %1223, <double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555, double 0x3FD5555555555555>
  %1225 = fsub <8 x double> %1219, %1224
  %1226 = fdiv <8 x double> %1225, %242
  %1227 = getelementptr inbounds i8, ptr %1187, i64 %1210
  store <8 x double> %1226, ptr %1227, align 8, !noalias !16
  %1228 = load ptr, ptr %108, align 8, !noalias !16
  %1229 = getelementptr inbounds i8, ptr %1228, i64 %1210
  %1230 = load <8 x double>, ptr %1229, align 8, !noalias !16
  %1231 = fadd <8 x double> %1230, %1226
  %1232 = getelementptr inbounds i8, ptr %1188, i64 %1210
  store <8 x double> %1231, ptr %1232, align 8, !noalias !16
  %1233 = add nuw nsw i64 %1208, 1
  %1234 = icmp eq i64 %1233, %1184
  br i1 %1234, label %1192, label %1207, !llvm.loop !51

1235:                                             ; preds = %1261, %1205
  %1236 = trunc i64 %1202 to i8
  %1237 = bitcast i8 %1236 to <8 x i1>
  %1238 = select <8 x i1> %1237, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1239 = fadd <8 x double> %1089, %1238
  %1240 = load ptr, ptr %112, align 8, !noalias !16
  %1241 = load ptr, ptr %113, align 8, !noalias !16
  %1242 = load ptr, ptr %114, align 8, !noalias !16
  store <8 x double> %226, ptr %1242, align 8, !noalias !16
  %1243 = load i64, ptr %115, align 8, !noalias !16
  %1244 = icmp sgt i64 %1243, 0
  br i1 %1244, label %1245, label %1246

1245:                                             ; preds = %1235
  call fastcc void @sample(ptr noundef nonnull %15) #10, !noalias !16
  br label %1246

1246:                                             ; preds = %1245, %1235
  %1247 = load ptr, ptr %15, align 8, !noalias !16
  %1248 = load i64, ptr %1247, align 8, !noalias !16
  %1249 = load ptr, ptr %114, align 8, !noalias !16
  %1250 = load ptr, ptr %116, align 8, !noalias !16
  %1251 = load ptr, ptr %117, align 8, !noalias !16
  %1252 = inttoptr i64 %1248 to ptr
  %1253 = load ptr, ptr %1252, align 8, !noalias !16
  %1254 = call i32 %1253(ptr noundef %1249, ptr noundef %1240, ptr noundef %1250, ptr noundef %1251, ptr noundef %1241) #11, !noalias !16
  %1255 = zext i32 %1254 to i64
  %1256 = and i64 %1202, %1255
  %1257 = trunc i64 %1256 to i8
  %1258 = bitcast i8 %1257 to <8 x i1>
  %1259 = select <8 x i1> %1258, <8 x double> <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>, <8 x double> %1173
  %1260 = icmp sgt i64 %1184, 0
  br i1 %1260, label %1289, label %1274

1261:                                             ; preds = %1205, %1261
  %1262 = phi i64 [ %1272, %1261 ], [ 0, %1205 ]
  %1263 = load ptr, ptr %111, align 8, !noalias !16
  %1264 = load ptr, ptr %17, align 8, !noalias !16
  %1265 = shl nsw i64 %1262, 6
  %1266 = getelementptr inbounds i8, ptr %1264, i64 %1265
  %1267 = load <8 x double>, ptr %1266, align 8, !noalias !16
  %1268 = getelementptr inbounds i8, ptr %1188, i64 %1265
  %1269 = load <8 x double>, ptr %1268, align 8, !noalias !16
  %1270 = fadd <8 x double> %1267, %1269
  %1271 = getelementptr inbounds i8, ptr %1263, i64 %1265
  store <8 x double> %1270, ptr %1271, align 8, !noalias !16
  %1272 = add nuw nsw i64 %1262, 1
  %1273 = icmp eq i64 %1272, %1184
  br i1 %1273, label %1235, label %1261, !llvm.loop !52

1274:                                             ; preds = %1289, %1246
  %1275 = load ptr, ptr %109, align 8, !noalias !16
  %1276 = load ptr, ptr %104, align 8, !noalias !16
  call fastcc void @real_solve(ptr noundef %1275, i64 noundef %1186, ptr noundef %1276, ptr noundef %1188) #10, !noalias !16
  %1277 = load ptr, ptr %110, align 8, !noalias !16
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %1188, ptr noundef %1277, ptr noundef nonnull %17, i64 noundef %1184) #10, !noalias !16
  %1278 = load <8 x double>, ptr %6, align 16, !noalias !16
  %1279 = xor i64 %1255, -1
  %1280 = and i64 %1202, %1279
  %1281 = fcmp olt <8 x double> %1278, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1282 = bitcast <8 x i1> %1281 to i8
  %1283 = zext i8 %1282 to i64
  %1284 = and i64 %1280, %1283
  %1285 = or i64 %1284, %1203
  %1286 = trunc i64 %1280 to i8
  %1287 = bitcast i8 %1286 to <8 x i1>
  %1288 = select <8 x i1> %1287, <8 x double> %1278, <8 x double> %1196
  br label %1301

1289:                                             ; preds = %1246, %1289
  %1290 = phi i64 [ %1299, %1289 ], [ 0, %1246 ]
  %1291 = load ptr, ptr %113, align 8, !noalias !16
  %1292 = shl nsw i64 %1290, 6
  %1293 = getelementptr inbounds i8, ptr %1291, i64 %1292
  %1294 = load <8 x double>, ptr %1293, align 8, !noalias !16
  %1295 = getelementptr inbounds i8, ptr %1187, i64 %1292
  %1296 = load <8 x double>, ptr %1295, align 8, !noalias !16
  %1297 = fadd <8 x double> %1294, %1296
  %1298 = getelementptr inbounds i8, ptr %1188, i64 %1292
  store <8 x double> %1297, ptr %1298, align 8, !noalias !16
  %1299 = add nuw nsw i64 %1290, 1
  %1300 = icmp eq i64 %1299, %1184
  br i1 %1300, label %1274, label %1289, !llvm.loop !53

1301:                                             ; preds = %1192, %1274
  %1302 = phi i64 [ %1203, %1192 ], [ %1285, %1274 ]
  %1303 = phi <8 x double> [ %1089, %1192 ], [ %1239, %1274 ]
  %1304 = phi <8 x double> [ %1173, %1192 ], [ %1259, %1274 ]
  %1305 = phi <8 x double> [ %1196, %1192 ], [ %1288, %1274 ]
  %1306 = fcmp olt <8 x double> %1305, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1307 = select <8 x i1> %1306, <8 x double> <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>, <8 x double> %1305
  %1308 = load ptr, ptr %70, align 8, !noalias !16
  %1309 = getelementptr inbounds i8, ptr %1308, i64 192
  %1310 = load <8 x double>, ptr %1309, align 8, !noalias !16
  %1311 = fadd <8 x double> %1086, <double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01, double 1.200000e+01>
  %1312 = fdiv <8 x double> <double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667, double 0x4027666666666667>, %1311
  %1313 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1307)
  %1314 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1313)
  %1315 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1314
  %1316 = fmul <8 x double> %1312, %1315
  %1317 = fcmp ogt <8 x double> %1316, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1318 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1305)
  %1319 = fcmp one <8 x double> %1318, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1320 = select <8 x i1> %1317, <8 x double> %1316, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1321 = select <8 x i1> %1319, <8 x double> %1320, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1322 = fmul <8 x double> %1321, %242
  %1323 = getelementptr inbounds i8, ptr %1308, i64 128
  %1324 = load <8 x double>, ptr %1323, align 8, !noalias !16
  %1325 = fdiv <8 x double> %242, %1324
  %1326 = fdiv <8 x double> %1310, %1307
  %1327 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1326)
  %1328 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1327)
  %1329 = fmul <8 x double> %1325, %1328
  %1330 = fcmp ogt <8 x double> %1310, zeroinitializer
  %1331 = fcmp olt <8 x double> %1329, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1332 = select <8 x i1> %1330, <8 x i1> %1331, <8 x i1> zeroinitializer
  %1333 = select <8 x i1> %1332, <8 x double> %1329, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1334 = fmul <8 x double> %1316, %1333
  %1335 = fcmp olt <8 x double> %1334, <double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01, double 1.000000e+01>
  %1336 = bitcast <8 x double> %1334 to <8 x i64>
  %1337 = select <8 x i1> %1335, <8 x i64> %1336, <8 x i64> <i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520, i64 4621819117588971520>
  %1338 = bitcast <8 x i64> %1337 to <8 x double>
  %1339 = fcmp ule <8 x double> %1338, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1340 = fcmp uge <8 x double> %1338, <double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00, double 1.200000e+00>
  %1341 = or <8 x i1> %1339, %1340
  %1342 = select <8 x i1> %1341, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %1092
  %1343 = load <8 x double>, ptr %1308, align 8, !noalias !16
  %1344 = fcmp ogt <8 x double> %1338, <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1345 = bitcast <8 x i64> %1337 to <8 x double>
  %1346 = select <8 x i1> %1344, <8 x double> %1345, <8 x double> <double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01, double 2.000000e-01>
  %1347 = fmul <8 x double> %1346, %242
  %1348 = trunc nuw i64 %1302 to i8
  %1349 = bitcast i8 %1348 to <8 x i1>
  %1350 = trunc i64 %1084 to i8
  %1351 = bitcast i8 %1350 to <8 x i1>
  %1352 = select <8 x i1> %1342, <8 x double> %1347, <8 x double> %1343
  %1353 = select <8 x i1> %1349, <8 x double> %1352, <8 x double> %1322
  %1354 = select <8 x i1> %1351, <8 x double> %1353, <8 x double> %1172
  %1355 = xor i64 %1302, -1
  %1356 = and i64 %1084, %1355
  %1357 = load ptr, ptr %61, align 8, !noalias !16
  %1358 = getelementptr inbounds i8, ptr %1357, i64 32
  %1359 = load i64, ptr %1358, align 8, !noalias !16
  %1360 = or i64 %1359, %1356
  store i64 %1360, ptr %1358, align 8, !noalias !16
  %1361 = load ptr, ptr %61, align 8, !noalias !16
  %1362 = getelementptr inbounds i8, ptr %1361, i64 8
  %1363 = load i64, ptr %1362, align 8, !noalias !16
  %1364 = xor i64 %1356, -1
  %1365 = and i64 %1363, %1364
  %1366 = getelementptr inbounds i8, ptr %1361, i64 16
  %1367 = load i64, ptr %1366, align 8, !noalias !16
  %1368 = xor i64 %1367, -1
  %1369 = and i64 %1356, %1368
  %1370 = or disjoint i64 %1369, %1365
  store i64 %1370, ptr %1362, align 8, !noalias !16
  br label %1387

1371:                                             ; preds = %1177, %1371
  %1372 = phi i64 [ 0, %1177 ], [ %1385, %1371 ]
  %1373 = load ptr, ptr %103, align 8, !noalias !16
  %1374 = load ptr, ptr %17, align 8, !noalias !16
  %1375 = shl nsw i64 %1372, 6
  %1376 = getelementptr inbounds i8, ptr %1374, i64 %1375
  %1377 = load <8 x double>, ptr %1376, align 8, !noalias !16
  %1378 = load ptr, ptr %78, align 8, !noalias !16
  %1379 = shl i64 %1372, 6
  %1380 = getelementptr i8, ptr %1378, i64 %1178
  %1381 = getelementptr i8, ptr %1380, i64 %1379
  %1382 = load <8 x double>, ptr %1381, align 8, !noalias !16
  %1383 = fadd <8 x double> %1377, %1382
  %1384 = getelementptr inbounds i8, ptr %1373, i64 %1375
  store <8 x double> %1383, ptr %1384, align 8, !noalias !16
  %1385 = add nuw nsw i64 %1372, 1
  %1386 = icmp eq i64 %1385, %270
  br i1 %1386, label %1179, label %1371, !llvm.loop !54

1387:                                             ; preds = %1301, %1171, %431, %333
  %1388 = phi i64 [ %136, %333 ], [ %136, %431 ], [ %1084, %1171 ], [ %1084, %1301 ]
  %1389 = phi i64 [ %137, %333 ], [ %137, %431 ], [ %1085, %1171 ], [ %1085, %1301 ]
  %1390 = phi <8 x double> [ %138, %333 ], [ %138, %431 ], [ %1086, %1171 ], [ %1086, %1301 ]
  %1391 = phi <8 x double> [ %139, %333 ], [ %139, %431 ], [ %1087, %1171 ], [ %1087, %1301 ]
  %1392 = phi <8 x double> [ %140, %333 ], [ %140, %431 ], [ %1088, %1171 ], [ %1088, %1301 ]
  %1393 = phi i8 [ 0, %333 ], [ 0, %431 ], [ %1093, %1171 ], [ %1093, %1301 ]
  %1394 = phi <8 x double> [ <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>, %333 ], [ %433, %431 ], [ %1173, %1171 ], [ %1304, %1301 ]
  %1395 = phi <8 x double> [ zeroinitializer, %333 ], [ zeroinitializer, %431 ], [ zeroinitializer, %1171 ], [ %1305, %1301 ]
  %1396 = phi <8 x double> [ %231, %333 ], [ %432, %431 ], [ %1172, %1171 ], [ %1354, %1301 ]
  %1397 = phi <8 x double> [ zeroinitializer, %333 ], [ zeroinitializer, %431 ], [ %1089, %1171 ], [ %1303, %1301 ]
  %1398 = phi i64 [ 0, %333 ], [ 0, %431 ], [ 0, %1171 ], [ %1302, %1301 ]
  %1399 = zext i8 %1393 to i64
  %1400 = load ptr, ptr %16, align 8, !noalias !55
  %1401 = getelementptr inbounds i8, ptr %1400, i64 72
  %1402 = load ptr, ptr %1401, align 8
  store <8 x i64> %241, ptr %1402, align 8
  %1403 = load ptr, ptr %118, align 8, !noalias !55
  %1404 = load <8 x double>, ptr %1403, align 8
  %1405 = fadd <8 x double> %1397, %1404
  store <8 x double> %1405, ptr %1403, align 8
  %1406 = icmp ne i64 %1398, 0
  %1407 = select i1 %47, i1 %1406, i1 false
  br i1 %1407, label %1408, label %1411

1408:                                             ; preds = %1387
  store <8 x double> %238, ptr %8, align 16
  %1409 = load ptr, ptr %119, align 8
  %1410 = call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef nonnull %8, ptr noundef %1409, i64 noundef %1398, i32 noundef 1) #10
  br label %1411

1411:                                             ; preds = %1408, %1387
  %1412 = phi i64 [ %1410, %1408 ], [ 0, %1387 ]
  %1413 = xor i64 %1412, -1
  %1414 = and i64 %1398, %1413
  %1415 = load ptr, ptr %15, align 8
  %1416 = getelementptr inbounds i8, ptr %1415, i64 8
  %1417 = load i64, ptr %1416, align 8
  %1418 = load i64, ptr %120, align 8
  %1419 = load ptr, ptr %121, align 8
  %1420 = trunc nuw i64 %1414 to i8
  %1421 = load ptr, ptr %122, align 8
  %1422 = load ptr, ptr %123, align 8
  %1423 = load ptr, ptr %124, align 8
  br label %1447

1424:                                             ; preds = %1447
  %1425 = bitcast i8 %1420 to <8 x i1>
  %1426 = icmp sgt i64 %1417, 0
  br i1 %1426, label %1427, label %1516

1427:                                             ; preds = %1424
  %1428 = load <2 x double>, ptr %2, align 16
  %1429 = shufflevector <2 x double> %1428, <2 x double> poison, <8 x i32> zeroinitializer
  %1430 = load <2 x double>, ptr %125, align 8
  %1431 = shufflevector <2 x double> %1430, <2 x double> poison, <8 x i32> zeroinitializer
  %1432 = load double, ptr %126, align 16
  %1433 = insertelement <8 x double> poison, double %1432, i64 0
  %1434 = shufflevector <8 x double> %1433, <8 x double> poison, <8 x i32> zeroinitializer
  %1435 = shl i64 %1417, 7
  %1436 = getelementptr i8, ptr %1419, i64 %1435
  %1437 = load <2 x double>, ptr %3, align 16
  %1438 = shufflevector <2 x double> %1437, <2 x double> poison, <8 x i32> zeroinitializer
  %1439 = load <2 x double>, ptr %127, align 8
  %1440 = shufflevector <2 x double> %1439, <2 x double> poison, <8 x i32> zeroinitializer
  %1441 = load double, ptr %128, align 16
  %1442 = insertelement <8 x double> poison, double %1441, i64 0
  %1443 = shufflevector <8 x double> %1442, <8 x double> poison, <8 x i32> zeroinitializer
  %1444 = getelementptr inbounds double, ptr %1421, i64 %1418
  %1445 = shl nsw i64 %1418, 4
  %1446 = getelementptr inbounds i8, ptr %1421, i64 %1445
  br label %1458

1447:                                             ; preds = %1411, %1447
  %1448 = phi i64 [ 0, %1411 ], [ %1456, %1447 ]
  %1449 = getelementptr inbounds [3 x [3 x double]], ptr @POLYNOMIAL, i64 0, i64 %1448
  %1450 = getelementptr inbounds i8, ptr %1449, i64 8
  %1451 = load double, ptr %1450, align 8
  %1452 = getelementptr inbounds [3 x double], ptr %2, i64 0, i64 %1448
  store double %1451, ptr %1452, align 8
  %1453 = getelementptr inbounds i8, ptr %1449, i64 16
  %1454 = load double, ptr %1453, align 8
  %1455 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %1448
  store double %1454, ptr %1455, align 8
  %1456 = add nuw nsw i64 %1448, 1
  %1457 = icmp eq i64 %1456, 3
  br i1 %1457, label %1424, label %1447, !llvm.loop !56

1458:                                             ; preds = %1427, %1500
  %1459 = phi i64 [ 0, %1427 ], [ %1501, %1500 ]
  %1460 = shl nsw i64 %1459, 6
  %1461 = getelementptr inbounds i8, ptr %1419, i64 %1460
  %1462 = load <8 x double>, ptr %1461, align 8
  %1463 = fmul <8 x double> %1462, %1429
  %1464 = add nuw nsw i64 %1459, %1417
  %1465 = shl nsw i64 %1464, 6
  %1466 = getelementptr inbounds i8, ptr %1419, i64 %1465
  %1467 = load <8 x double>, ptr %1466, align 8
  %1468 = fmul <8 x double> %1467, %1431
  %1469 = fadd <8 x double> %1463, %1468
  %1470 = shl i64 %1459, 6
  %1471 = getelementptr i8, ptr %1436, i64 %1470
  %1472 = load <8 x double>, ptr %1471, align 8
  %1473 = fmul <8 x double> %1472, %1434
  %1474 = fadd <8 x double> %1469, %1473
  %1475 = fmul <8 x double> %1462, %1438
  %1476 = fmul <8 x double> %1467, %1440
  %1477 = fadd <8 x double> %1475, %1476
  %1478 = fmul <8 x double> %1472, %1443
  %1479 = fadd <8 x double> %1477, %1478
  %1480 = load ptr, ptr %129, align 8
  %1481 = getelementptr inbounds i8, ptr %1480, i64 %1460
  %1482 = load <8 x double>, ptr %1481, align 8
  %1483 = load ptr, ptr %17, align 8
  %1484 = getelementptr inbounds i8, ptr %1483, i64 %1460
  %1485 = load <8 x double>, ptr %1484, align 8
  %1486 = fsub <8 x double> %1482, %1485
  %1487 = getelementptr inbounds i8, ptr %1421, i64 %1460
  store <8 x double> %1486, ptr %1487, align 8
  %1488 = fneg <8 x double> %1474
  %1489 = fsub <8 x double> %1488, %1479
  %1490 = getelementptr inbounds i8, ptr %1444, i64 %1460
  store <8 x double> %1489, ptr %1490, align 8
  %1491 = fneg <8 x double> %1479
  %1492 = getelementptr inbounds i8, ptr %1446, i64 %1460
  store <8 x double> %1491, ptr %1492, align 8
  %1493 = load ptr, ptr %17, align 8
  %1494 = getelementptr inbounds i8, ptr %1493, i64 %1460
  %1495 = load <8 x i64>, ptr %1494, align 8
  %1496 = getelementptr inbounds i8, ptr %1422, i64 %1460
  %1497 = load <8 x i64>, ptr %1496, align 8
  %1498 = select <8 x i1> %1425, <8 x i64> %1495, <8 x i64> %1497
  store <8 x i64> %1498, ptr %1496, align 8
  %1499 = getelementptr i8, ptr %1421, i64 %1460
  br label %1503

1500:                                             ; preds = %1503
  %1501 = add nuw nsw i64 %1459, 1
  %1502 = icmp eq i64 %1501, %1417
  br i1 %1502, label %1516, label %1458, !llvm.loop !57

1503:                                             ; preds = %1458, %1503
  %1504 = phi i64 [ 0, %1458 ], [ %1505, %1503 ]
  %1505 = add nuw nsw i64 %1504, 1
  %1506 = mul nuw nsw i64 %1417, %1505
  %1507 = add nuw nsw i64 %1506, %1459
  %1508 = mul nsw i64 %1418, %1504
  %1509 = getelementptr double, ptr %1499, i64 %1508
  %1510 = load <8 x i64>, ptr %1509, align 8
  %1511 = shl nsw i64 %1507, 6
  %1512 = getelementptr inbounds i8, ptr %1422, i64 %1511
  %1513 = load <8 x i64>, ptr %1512, align 8
  %1514 = select <8 x i1> %1425, <8 x i64> %1510, <8 x i64> %1513
  store <8 x i64> %1514, ptr %1512, align 8
  %1515 = icmp eq i64 %1505, 3
  br i1 %1515, label %1500, label %1503, !llvm.loop !58

1516:                                             ; preds = %1500, %1424
  %1517 = fcmp olt <8 x double> %1395, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1518 = bitcast <8 x double> %1395 to <8 x i64>
  %1519 = select <8 x i1> %1517, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>, <8 x i64> %1518
  %1520 = getelementptr inbounds i8, ptr %1423, i64 64
  %1521 = load <8 x i64>, ptr %1520, align 8
  %1522 = select <8 x i1> %1425, <8 x i64> %241, <8 x i64> %1521
  store <8 x i64> %1522, ptr %1520, align 8
  %1523 = getelementptr inbounds i8, ptr %1423, i64 128
  %1524 = load <8 x i64>, ptr %1523, align 8
  %1525 = select <8 x i1> %1425, <8 x i64> %241, <8 x i64> %1524
  store <8 x i64> %1525, ptr %1523, align 8
  %1526 = getelementptr inbounds i8, ptr %1423, i64 192
  %1527 = load <8 x i64>, ptr %1526, align 8
  %1528 = select <8 x i1> %1425, <8 x i64> %1519, <8 x i64> %1527
  store <8 x i64> %1528, ptr %1526, align 8
  %1529 = load ptr, ptr %61, align 8
  %1530 = getelementptr inbounds i8, ptr %1529, i64 8
  %1531 = load i64, ptr %1530, align 8
  %1532 = xor i64 %1414, -1
  %1533 = and i64 %1531, %1532
  %1534 = and i64 %1414, %1399
  %1535 = or disjoint i64 %1533, %1534
  store i64 %1535, ptr %1530, align 8
  %1536 = load ptr, ptr %61, align 8
  %1537 = getelementptr inbounds i8, ptr %1536, i64 16
  %1538 = load i64, ptr %1537, align 8
  %1539 = and i64 %1538, %1532
  store i64 %1539, ptr %1537, align 8
  %1540 = load ptr, ptr %61, align 8
  %1541 = getelementptr inbounds i8, ptr %1540, i64 32
  %1542 = load i64, ptr %1541, align 8
  %1543 = and i64 %1542, %1532
  store i64 %1543, ptr %1541, align 8
  %1544 = icmp ne i64 %1414, 0
  %1545 = select i1 %48, i1 %1544, i1 false
  br i1 %1545, label %1546, label %1550

1546:                                             ; preds = %1516
  %1547 = call fastcc i64 @clear_lanes(ptr noundef %0) #10
  %1548 = xor i64 %1547, -1
  %1549 = and i64 %1414, %1548
  br label %1550

1550:                                             ; preds = %1516, %1546
  %1551 = phi i64 [ %1549, %1546 ], [ 0, %1516 ]
  store i64 0, ptr %13, align 8
  %1552 = load ptr, ptr %130, align 8
  %1553 = load <8 x double>, ptr %1552, align 8
  %1554 = fcmp olt <8 x double> %1553, %238
  %1555 = bitcast <8 x i1> %1554 to i8
  %1556 = zext i8 %1555 to i64
  %1557 = and i64 %1414, %1556
  %1558 = or i64 %1557, %1551
  %1559 = icmp eq i64 %1558, 0
  br i1 %1559, label %1594, label %1560

1560:                                             ; preds = %1550
  store <8 x double> %238, ptr %8, align 16
  %1561 = icmp eq i64 %1551, 0
  br i1 %1561, label %1564, label %1562

1562:                                             ; preds = %1560
  %1563 = call fastcc i64 @look_for_events(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1551, ptr noundef nonnull %8, ptr noundef nonnull %10, ptr noundef nonnull %12, ptr noundef nonnull %9, ptr noundef nonnull %13) #10
  br label %1564

1564:                                             ; preds = %1562, %1560
  %1565 = phi i64 [ %1563, %1562 ], [ 0, %1560 ]
  %1566 = load i64, ptr %13, align 8
  %1567 = xor i64 %1566, -1
  %1568 = and i64 %1558, %1567
  %1569 = icmp eq i64 %1565, 0
  %1570 = select i1 %1569, ptr null, ptr %9
  %1571 = call fastcc i64 @write_within(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1568, ptr noundef nonnull %8, ptr noundef %1570) #10
  %1572 = load <8 x double>, ptr %8, align 16
  br i1 %1569, label %1578, label %1573

1573:                                             ; preds = %1564
  %1574 = xor i64 %1571, -1
  %1575 = and i64 %1565, %1574
  %1576 = call fastcc i64 @end_within(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1575, ptr noundef nonnull %8, ptr noundef nonnull %9) #10
  %1577 = or i64 %1576, %1571
  br label %1578

1578:                                             ; preds = %1573, %1564
  %1579 = phi i64 [ %1577, %1573 ], [ %1571, %1564 ]
  %1580 = icmp ne i64 %1579, 0
  %1581 = select i1 %48, i1 %1580, i1 false
  br i1 %1581, label %1582, label %1587

1582:                                             ; preds = %1578
  call fastcc void @retire(ptr noundef %0, i64 noundef %1579, i64 noundef 6) #10
  %1583 = xor i64 %1579, -1
  %1584 = load i64, ptr %11, align 8
  %1585 = and i64 %1584, %1583
  store i64 %1585, ptr %11, align 8
  %1586 = and i64 %1565, %1583
  br label %1587

1587:                                             ; preds = %1582, %1578
  %1588 = phi i32 [ 1, %1582 ], [ %193, %1578 ]
  %1589 = phi i64 [ %1586, %1582 ], [ %1565, %1578 ]
  %1590 = or i64 %1579, %1412
  %1591 = or i64 %1579, %1566
  %1592 = xor i64 %1591, -1
  %1593 = and i64 %1414, %1592
  br label %1594

1594:                                             ; preds = %1587, %1550
  %1595 = phi <8 x double> [ %238, %1550 ], [ %1572, %1587 ]
  %1596 = phi i64 [ 0, %1550 ], [ %1566, %1587 ]
  %1597 = phi i64 [ %1412, %1550 ], [ %1590, %1587 ]
  %1598 = phi i32 [ %193, %1550 ], [ %1588, %1587 ]
  %1599 = phi i64 [ %1414, %1550 ], [ %1593, %1587 ]
  %1600 = phi i64 [ 0, %1550 ], [ %1589, %1587 ]
  %1601 = load ptr, ptr %130, align 8
  %1602 = load <8 x double>, ptr %1601, align 8
  %1603 = fcmp oeq <8 x double> %1602, %1595
  %1604 = bitcast <8 x i1> %1603 to i8
  %1605 = zext i8 %1604 to i64
  %1606 = and i64 %1599, %1605
  %1607 = icmp eq i64 %1606, 0
  br i1 %1607, label %1608, label %1667

1608:                                             ; preds = %1667, %1594
  %1609 = trunc nuw i64 %1599 to i8
  %1610 = bitcast i8 %1609 to <8 x i1>
  %1611 = load ptr, ptr %57, align 8
  %1612 = load <8 x double>, ptr %1611, align 8
  %1613 = select <8 x i1> %1610, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1614 = fadd <8 x double> %1613, %1612
  store <8 x double> %1614, ptr %1611, align 8
  %1615 = load ptr, ptr %58, align 8
  %1616 = load <8 x double>, ptr %1615, align 8
  %1617 = xor <8 x i1> %1610, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1618 = and <8 x i1> %224, %1617
  %1619 = select <8 x i1> %1618, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %1620 = fadd <8 x double> %1619, %1616
  store <8 x double> %1620, ptr %1615, align 8
  %1621 = xor i64 %1599, -1
  %1622 = and i64 %222, %1621
  %1623 = or i64 %1597, %1596
  %1624 = and i64 %1622, %1623
  %1625 = trunc i64 %1597 to i8
  %1626 = bitcast i8 %1625 to <8 x i1>
  %1627 = trunc i64 %1624 to i8
  %1628 = bitcast i8 %1627 to <8 x i1>
  %1629 = fcmp oeq <8 x double> %1595, %229
  %1630 = load ptr, ptr %54, align 8
  %1631 = load <8 x double>, ptr %1630, align 8
  %1632 = fcmp ogt <8 x double> %1631, %1396
  %1633 = and <8 x i1> %1629, %1610
  %1634 = select <8 x i1> %1633, <8 x i1> %1632, <8 x i1> zeroinitializer
  %1635 = select <8 x i1> %1634, <8 x double> %1631, <8 x double> %1396
  %1636 = fmul <8 x double> %242, <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1637 = select <8 x i1> %1628, <8 x double> %1636, <8 x double> %1635
  %1638 = select <8 x i1> %1626, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %1639 = bitcast <8 x double> %1394 to <8 x i64>
  %1640 = select <8 x i1> %1628, <8 x i64> %1638, <8 x i64> %1639
  %1641 = load ptr, ptr %132, align 8
  %1642 = trunc i64 %1622 to i8
  %1643 = bitcast i8 %1642 to <8 x i1>
  %1644 = load <8 x i64>, ptr %1641, align 8
  %1645 = select <8 x i1> %1643, <8 x i64> %1640, <8 x i64> %1644
  store <8 x i64> %1645, ptr %1641, align 8
  %1646 = load ptr, ptr %61, align 8
  %1647 = getelementptr inbounds i8, ptr %1646, i64 32
  %1648 = load i64, ptr %1647, align 8
  %1649 = or i64 %1648, %1624
  store i64 %1649, ptr %1647, align 8
  %1650 = load ptr, ptr %61, align 8
  %1651 = getelementptr inbounds i8, ptr %1650, i64 8
  %1652 = load i64, ptr %1651, align 8
  %1653 = xor i64 %1624, -1
  %1654 = and i64 %1652, %1653
  %1655 = getelementptr inbounds i8, ptr %1650, i64 16
  %1656 = load i64, ptr %1655, align 8
  %1657 = xor i64 %1656, -1
  %1658 = and i64 %1624, %1657
  %1659 = or disjoint i64 %1658, %1654
  store i64 %1659, ptr %1651, align 8
  %1660 = load ptr, ptr %124, align 8
  %1661 = getelementptr inbounds i8, ptr %1660, i64 64
  %1662 = load <8 x double>, ptr %1661, align 8
  %1663 = select <8 x i1> %1628, <8 x double> zeroinitializer, <8 x double> %1662
  store <8 x double> %1663, ptr %1661, align 8
  %1664 = load ptr, ptr %54, align 8
  store <8 x double> %1637, ptr %1664, align 8
  %1665 = load ptr, ptr %45, align 8
  %1666 = select <8 x i1> %1610, <8 x double> %1595, <8 x double> %226
  store <8 x double> %1666, ptr %1665, align 8
  br i1 %133, label %1679, label %1677

1667:                                             ; preds = %1594, %1667
  %1668 = phi i64 [ %1675, %1667 ], [ %1606, %1594 ]
  %1669 = load ptr, ptr %131, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %1669, i64 noundef %1668) #10
  %1670 = load ptr, ptr %130, align 8
  %1671 = load <8 x double>, ptr %1670, align 8
  %1672 = fcmp oeq <8 x double> %1671, %1595
  %1673 = bitcast <8 x i1> %1672 to i8
  %1674 = zext i8 %1673 to i64
  %1675 = and i64 %1668, %1674
  %1676 = icmp eq i64 %1675, 0
  br i1 %1676, label %1608, label %1667, !llvm.loop !59

1677:                                             ; preds = %1679, %1608
  %1678 = icmp eq i64 %1600, 0
  br i1 %1678, label %1701, label %1691

1679:                                             ; preds = %1608, %1679
  %1680 = phi i64 [ %1689, %1679 ], [ 0, %1608 ]
  %1681 = load ptr, ptr %17, align 8
  %1682 = load ptr, ptr %134, align 8
  %1683 = shl nsw i64 %1680, 6
  %1684 = getelementptr inbounds i8, ptr %1682, i64 %1683
  %1685 = load <8 x i64>, ptr %1684, align 8
  %1686 = getelementptr inbounds i8, ptr %1681, i64 %1683
  %1687 = load <8 x i64>, ptr %1686, align 8
  %1688 = select <8 x i1> %1610, <8 x i64> %1685, <8 x i64> %1687
  store <8 x i64> %1688, ptr %1686, align 8
  %1689 = add nuw nsw i64 %1680, 1
  %1690 = icmp eq i64 %1689, %21
  br i1 %1690, label %1677, label %1679, !llvm.loop !60

1691:                                             ; preds = %1677
  %1692 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %1600, ptr noundef nonnull %12) #10
  %1693 = icmp ne i32 %1598, 0
  %1694 = icmp ne i64 %1692, %1600
  %1695 = select i1 %1693, i1 true, i1 %1694
  %1696 = zext i1 %1695 to i32
  %1697 = trunc i64 %1600 to i8
  %1698 = bitcast i8 %1697 to <8 x i1>
  %1699 = xor <8 x i1> %1698, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1700 = and <8 x i1> %1699, %1610
  br label %1701

1701:                                             ; preds = %1691, %1677
  %1702 = phi i32 [ %1696, %1691 ], [ %1598, %1677 ]
  %1703 = phi <8 x i1> [ %1700, %1691 ], [ %1610, %1677 ]
  %1704 = phi i64 [ %1692, %1691 ], [ %194, %1677 ]
  %1705 = bitcast <8 x i1> %1703 to i8
  %1706 = icmp eq i8 %1705, 0
  br i1 %1706, label %1710, label %1707

1707:                                             ; preds = %1701
  %1708 = zext i8 %1705 to i64
  %1709 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %7, i64 noundef %1708) #10
  br label %1710

1710:                                             ; preds = %1701, %1707
  %1711 = phi i64 [ %1709, %1707 ], [ 0, %1701 ]
  %1712 = icmp ne i32 %1702, 0
  %1713 = icmp ne i64 %1711, 0
  %1714 = or i1 %1712, %1713
  %1715 = zext i1 %1714 to i32
  %1716 = trunc nuw i64 %1711 to i8
  %1717 = bitcast i8 %1716 to <8 x i1>
  %1718 = xor <8 x i1> %1717, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1719 = and <8 x i1> %1703, %1718
  %1720 = load ptr, ptr %130, align 8
  %1721 = load <8 x double>, ptr %1720, align 8
  %1722 = fcmp oeq <8 x double> %1721, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1723 = select <8 x i1> %1722, <8 x i1> %1719, <8 x i1> zeroinitializer
  %1724 = bitcast <8 x i1> %1723 to i8
  %1725 = icmp eq i8 %1724, 0
  br i1 %1725, label %1728, label %1726

1726:                                             ; preds = %1710
  %1727 = zext i8 %1724 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %1727, i64 noundef 0) #10
  br label %1728

1728:                                             ; preds = %1726, %1710
  %1729 = phi i32 [ 1, %1726 ], [ %1715, %1710 ]
  br label %135

1730:                                             ; preds = %192, %217, %188
  %1731 = phi i64 [ 1, %188 ], [ 0, %217 ], [ 0, %192 ]
  ret i64 %1731
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
  %348 = getelementptr inbounds i8, ptr %347, i64 40
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
  %363 = getelementptr inbounds i8, ptr %362, i64 48
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
  %26 = getelementptr inbounds i8, ptr %20, i64 152
  %27 = load i64, ptr %26, align 8
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %29, label %30

29:                                               ; preds = %4
  tail call fastcc void @sample(ptr noundef %20) #10
  br label %30

30:                                               ; preds = %4, %29
  %31 = load ptr, ptr %20, align 8
  %32 = load i64, ptr %31, align 8
  %33 = load ptr, ptr %24, align 8
  %34 = getelementptr inbounds i8, ptr %20, i64 48
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %20, i64 96
  %37 = load ptr, ptr %36, align 8
  %38 = inttoptr i64 %32 to ptr
  %39 = load ptr, ptr %38, align 8
  %40 = tail call i32 %39(ptr noundef %33, ptr noundef %21, ptr noundef %35, ptr noundef %37, ptr noundef %23) #11
  %41 = sext i32 %40 to i64
  %42 = load ptr, ptr %19, align 8
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %43, i64 8
  %45 = load i64, ptr %44, align 8
  %46 = icmp sgt i64 %45, 0
  br i1 %46, label %47, label %49

47:                                               ; preds = %30
  %48 = getelementptr inbounds i8, ptr %11, i64 168
  br label %158

49:                                               ; preds = %158, %30
  %50 = getelementptr inbounds i8, ptr %0, i64 1008
  %51 = load ptr, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 8
  %53 = load double, ptr %52, align 8
  %54 = fcmp oeq double %53, 0.000000e+00
  %55 = select i1 %54, i64 %14, i64 %3
  %56 = getelementptr inbounds i8, ptr %0, i64 720
  %57 = load ptr, ptr %56, align 8
  %58 = insertelement <8 x double> poison, double %53, i64 0
  %59 = load <8 x i64>, ptr %57, align 8
  %60 = bitcast <8 x double> %58 to <8 x i64>
  %61 = shufflevector <8 x i64> %60, <8 x i64> poison, <8 x i32> zeroinitializer
  %62 = select <8 x i1> %16, <8 x i64> %61, <8 x i64> %59
  store <8 x i64> %62, ptr %57, align 8
  %63 = load ptr, ptr %50, align 8
  %64 = load double, ptr %63, align 8
  %65 = load ptr, ptr %10, align 8
  %66 = load ptr, ptr %19, align 8
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 8
  %69 = load i64, ptr %68, align 8
  %70 = load ptr, ptr %65, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %70, ptr noundef %70, ptr noundef nonnull %65, i64 noundef %69) #10
  %71 = load <8 x double>, ptr %5, align 16
  %72 = getelementptr inbounds i8, ptr %65, i64 168
  %73 = load ptr, ptr %72, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %73, ptr noundef %70, ptr noundef nonnull %65, i64 noundef %69) #10
  %74 = load <8 x double>, ptr %6, align 16
  %75 = fcmp olt <8 x double> %71, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %76 = fcmp olt <8 x double> %74, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %77 = or <8 x i1> %76, %75
  %78 = insertelement <8 x double> poison, double %64, i64 0
  %79 = shufflevector <8 x double> %78, <8 x double> poison, <8 x i32> zeroinitializer
  %80 = fmul <8 x double> %71, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %81 = fdiv <8 x double> %80, %74
  %82 = bitcast <8 x double> %81 to <8 x i64>
  %83 = select <8 x i1> %77, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %82
  %84 = bitcast <8 x i64> %83 to <8 x double>
  %85 = fcmp olt <8 x double> %79, %84
  %86 = bitcast <8 x double> %79 to <8 x i64>
  %87 = select <8 x i1> %85, <8 x i64> %86, <8 x i64> %83
  %88 = bitcast <8 x i64> %87 to <8 x double>
  %89 = load ptr, ptr %56, align 8
  %90 = trunc i64 %55 to i8
  %91 = bitcast i8 %90 to <8 x i1>
  %92 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %18)
  %93 = fmul <8 x double> %92, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %94 = fcmp ogt <8 x double> %93, %88
  %95 = bitcast <8 x double> %93 to <8 x i64>
  %96 = select <8 x i1> %94, <8 x i64> %95, <8 x i64> %87
  %97 = bitcast <8 x i64> %96 to <8 x double>
  %98 = fcmp olt <8 x double> %79, %97
  %99 = select <8 x i1> %98, <8 x i64> %86, <8 x i64> %96
  %100 = load <8 x i64>, ptr %89, align 8
  %101 = select <8 x i1> %91, <8 x i64> %99, <8 x i64> %100
  store <8 x i64> %101, ptr %89, align 8
  %102 = getelementptr inbounds i8, ptr %0, i64 1728
  %103 = xor i64 %14, -1
  %104 = load ptr, ptr %102, align 8
  %105 = getelementptr inbounds i8, ptr %104, i64 16
  %106 = load i64, ptr %105, align 8
  %107 = and i64 %106, %103
  store i64 %107, ptr %105, align 8
  %108 = load ptr, ptr %102, align 8
  %109 = getelementptr inbounds i8, ptr %108, i64 32
  %110 = load i64, ptr %109, align 8
  %111 = or i64 %110, %14
  store i64 %111, ptr %109, align 8
  %112 = load ptr, ptr %102, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 8
  %114 = load i64, ptr %113, align 8
  %115 = and i64 %114, %103
  %116 = getelementptr inbounds i8, ptr %112, i64 16
  %117 = load i64, ptr %116, align 8
  %118 = xor i64 %117, -1
  %119 = and i64 %14, %118
  %120 = or disjoint i64 %119, %115
  store i64 %120, ptr %113, align 8
  %121 = getelementptr inbounds i8, ptr %0, i64 1752
  %122 = load ptr, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %122, i64 64
  %124 = load <8 x double>, ptr %123, align 8
  %125 = select <8 x i1> %16, <8 x double> zeroinitializer, <8 x double> %124
  store <8 x double> %125, ptr %123, align 8
  %126 = load ptr, ptr %121, align 8
  %127 = getelementptr inbounds i8, ptr %126, i64 192
  %128 = load <8 x double>, ptr %127, align 8
  %129 = select <8 x i1> %16, <8 x double> zeroinitializer, <8 x double> %128
  store <8 x double> %129, ptr %127, align 8
  %130 = getelementptr inbounds i8, ptr %0, i64 840
  %131 = load ptr, ptr %130, align 8
  %132 = load <8 x double>, ptr %131, align 8
  %133 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %132
  store <8 x double> %133, ptr %131, align 8
  %134 = getelementptr inbounds i8, ptr %0, i64 864
  %135 = load ptr, ptr %134, align 8
  %136 = load <8 x double>, ptr %135, align 8
  %137 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %136
  store <8 x double> %137, ptr %135, align 8
  %138 = getelementptr inbounds i8, ptr %0, i64 888
  %139 = load ptr, ptr %138, align 8
  %140 = load <8 x double>, ptr %139, align 8
  %141 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %140
  store <8 x double> %141, ptr %139, align 8
  %142 = getelementptr inbounds i8, ptr %0, i64 912
  %143 = load ptr, ptr %142, align 8
  %144 = load ptr, ptr %56, align 8
  %145 = load <8 x double>, ptr %144, align 8
  %146 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %145, i32 384)
  %147 = select <8 x i1> %146, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %148 = load <8 x i64>, ptr %143, align 8
  %149 = select <8 x i1> %16, <8 x i64> %147, <8 x i64> %148
  store <8 x i64> %149, ptr %143, align 8
  %150 = icmp eq i64 %2, 0
  br i1 %150, label %199, label %151

151:                                              ; preds = %49
  %152 = getelementptr inbounds i8, ptr %0, i64 936
  %153 = getelementptr inbounds i8, ptr %0, i64 1032
  %154 = getelementptr inbounds i8, ptr %0, i64 1040
  %155 = getelementptr inbounds i8, ptr %0, i64 792
  %156 = getelementptr inbounds i8, ptr %0, i64 816
  %157 = getelementptr inbounds i8, ptr %0, i64 960
  br label %174

158:                                              ; preds = %47, %158
  %159 = phi i64 [ 0, %47 ], [ %168, %158 ]
  %160 = load ptr, ptr %48, align 8
  %161 = load ptr, ptr %22, align 8
  %162 = shl nsw i64 %159, 6
  %163 = getelementptr inbounds i8, ptr %161, i64 %162
  %164 = load <8 x i64>, ptr %163, align 8
  %165 = getelementptr inbounds i8, ptr %160, i64 %162
  %166 = load <8 x i64>, ptr %165, align 8
  %167 = select <8 x i1> %16, <8 x i64> %164, <8 x i64> %166
  store <8 x i64> %167, ptr %165, align 8
  %168 = add nuw nsw i64 %159, 1
  %169 = load ptr, ptr %19, align 8
  %170 = load ptr, ptr %169, align 8
  %171 = getelementptr inbounds i8, ptr %170, i64 8
  %172 = load i64, ptr %171, align 8
  %173 = icmp slt i64 %168, %172
  br i1 %173, label %158, label %49, !llvm.loop !72

174:                                              ; preds = %151, %174
  %175 = phi i64 [ %2, %151 ], [ %197, %174 ]
  %176 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %175, i1 true)
  %177 = load ptr, ptr %152, align 8
  %178 = getelementptr inbounds i64, ptr %177, i64 %176
  %179 = load i64, ptr %178, align 8
  %180 = load i64, ptr %154, align 8
  %181 = add nsw i64 %180, -1
  %182 = load ptr, ptr %155, align 8
  %183 = getelementptr inbounds double, ptr %182, i64 %176
  store double 0.000000e+00, ptr %183, align 8
  %184 = load ptr, ptr %153, align 8
  %185 = load double, ptr %184, align 8
  %186 = load ptr, ptr %156, align 8
  %187 = getelementptr inbounds double, ptr %186, i64 %176
  store double %185, ptr %187, align 8
  %188 = load ptr, ptr %9, align 8
  %189 = getelementptr inbounds i8, ptr %188, i64 24
  %190 = load i64, ptr %189, align 8
  %191 = shl i64 %179, 3
  %192 = mul i64 %191, %181
  %193 = add nsw i64 %190, %192
  %194 = load ptr, ptr %157, align 8
  %195 = getelementptr inbounds i64, ptr %194, i64 %176
  store i64 %193, ptr %195, align 8
  %196 = add nsw i64 %175, -1
  %197 = and i64 %196, %175
  %198 = icmp eq i64 %197, 0
  br i1 %198, label %199, label %174, !llvm.loop !73

199:                                              ; preds = %174, %49
  %200 = xor i64 %41, -1
  %201 = and i64 %200, %2
  %202 = icmp eq i64 %201, 0
  br i1 %202, label %206, label %203

203:                                              ; preds = %199
  %204 = getelementptr inbounds i8, ptr %0, i64 816
  %205 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %220

206:                                              ; preds = %220, %199
  %207 = and i64 %14, %41
  %208 = xor i64 %207, %14
  %209 = getelementptr inbounds i8, ptr %0, i64 816
  %210 = load ptr, ptr %209, align 8
  %211 = load <8 x double>, ptr %210, align 8
  %212 = fcmp oeq <8 x double> %211, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %213 = bitcast <8 x i1> %212 to i8
  %214 = zext i8 %213 to i64
  %215 = and i64 %208, %214
  %216 = load ptr, ptr %138, align 8
  %217 = load <8 x double>, ptr %216, align 8
  %218 = select <8 x i1> %16, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %219 = fadd <8 x double> %218, %217
  store <8 x double> %219, ptr %216, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %207, i64 noundef 3) #10
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %215, i64 noundef 0) #10
  ret void

220:                                              ; preds = %203, %220
  %221 = phi i64 [ %201, %203 ], [ %232, %220 ]
  %222 = load ptr, ptr %11, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %222, i64 noundef %221) #10
  %223 = load ptr, ptr %204, align 8
  %224 = load <8 x double>, ptr %223, align 8
  %225 = load ptr, ptr %205, align 8
  %226 = load double, ptr %225, align 8
  %227 = insertelement <8 x double> poison, double %226, i64 0
  %228 = shufflevector <8 x double> %227, <8 x double> poison, <8 x i32> zeroinitializer
  %229 = fcmp oeq <8 x double> %224, %228
  %230 = bitcast <8 x i1> %229 to i8
  %231 = zext i8 %230 to i64
  %232 = and i64 %221, %231
  %233 = icmp eq i64 %232, 0
  br i1 %233, label %206, label %220, !llvm.loop !74
}

define internal fastcc void @hold_all(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 384
  %5 = getelementptr inbounds i8, ptr %0, i64 392
  %6 = getelementptr inbounds i8, ptr %0, i64 408
  br label %8

7:                                                ; preds = %49
  ret void

8:                                                ; preds = %2, %49
  %9 = phi i64 [ 0, %2 ], [ %52, %49 ]
  %10 = load ptr, ptr %3, align 8
  %11 = getelementptr inbounds double, ptr %10, i64 %9
  %12 = load double, ptr %11, align 8
  %13 = load ptr, ptr %4, align 8
  %14 = load i64, ptr %5, align 8
  %15 = icmp eq i64 %14, 0
  br i1 %15, label %49, label %16

16:                                               ; preds = %8
  %17 = icmp sgt i64 %14, 0
  br i1 %17, label %18, label %31

18:                                               ; preds = %16, %18
  %19 = phi i64 [ %29, %18 ], [ %14, %16 ]
  %20 = phi i64 [ %28, %18 ], [ 0, %16 ]
  %21 = add nuw nsw i64 %19, %20
  %22 = lshr i64 %21, 1
  %23 = and i64 %21, -2
  %24 = getelementptr inbounds double, ptr %13, i64 %23
  %25 = load double, ptr %24, align 8
  %26 = fcmp ogt double %25, %12
  %27 = add nuw nsw i64 %22, 1
  %28 = select i1 %26, i64 %20, i64 %27
  %29 = select i1 %26, i64 %22, i64 %19
  %30 = icmp slt i64 %28, %29
  br i1 %30, label %18, label %31, !llvm.loop !75

31:                                               ; preds = %18, %16
  %32 = phi i64 [ 0, %16 ], [ %28, %18 ]
  %33 = icmp slt i64 %32, %14
  br i1 %33, label %34, label %39

34:                                               ; preds = %31
  %35 = shl nuw nsw i64 %32, 1
  %36 = or disjoint i64 %35, 1
  %37 = getelementptr inbounds double, ptr %13, i64 %36
  %38 = load double, ptr %37, align 8
  br label %39

39:                                               ; preds = %34, %31
  %40 = phi double [ %38, %34 ], [ 0x7FF0000000000000, %31 ]
  %41 = load ptr, ptr %6, align 8
  %42 = getelementptr inbounds double, ptr %41, i64 %9
  store double %40, ptr %42, align 8
  %43 = load i64, ptr %5, align 8
  %44 = icmp slt i64 %32, %43
  br i1 %44, label %45, label %49

45:                                               ; preds = %39
  %46 = shl nsw i64 %32, 4
  %47 = getelementptr inbounds i8, ptr %13, i64 %46
  %48 = load double, ptr %47, align 8
  br label %49

49:                                               ; preds = %8, %39, %45
  %50 = phi double [ 0x7FF0000000000000, %8 ], [ %48, %45 ], [ 0x7FF0000000000000, %39 ]
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
  %26 = getelementptr inbounds i8, ptr %18, i64 152
  %27 = load i64, ptr %26, align 8
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %29, label %30

29:                                               ; preds = %17
  tail call fastcc void @sample(ptr noundef %18) #10
  br label %30

30:                                               ; preds = %17, %29
  %31 = load ptr, ptr %18, align 8
  %32 = load i64, ptr %31, align 8
  %33 = load ptr, ptr %24, align 8
  %34 = getelementptr inbounds i8, ptr %18, i64 48
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %18, i64 96
  %37 = load ptr, ptr %36, align 8
  %38 = inttoptr i64 %32 to ptr
  %39 = load ptr, ptr %38, align 8
  %40 = tail call i32 %39(ptr noundef %33, ptr noundef %21, ptr noundef %35, ptr noundef %37, ptr noundef %23) #11
  %41 = load ptr, ptr %9, align 8
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %48

46:                                               ; preds = %30
  %47 = getelementptr inbounds i8, ptr %6, i64 168
  br label %56

48:                                               ; preds = %56, %30
  %49 = sext i32 %40 to i64
  %50 = and i64 %49, %2
  %51 = getelementptr inbounds i8, ptr %0, i64 888
  %52 = load ptr, ptr %51, align 8
  %53 = load <8 x double>, ptr %52, align 8
  %54 = select <8 x i1> %8, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %55 = fadd <8 x double> %54, %53
  store <8 x double> %55, ptr %52, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %50, i64 noundef 3) #10
  ret i64 %50

56:                                               ; preds = %46, %56
  %57 = phi i64 [ 0, %46 ], [ %66, %56 ]
  %58 = load ptr, ptr %47, align 8
  %59 = load ptr, ptr %22, align 8
  %60 = shl nsw i64 %57, 6
  %61 = getelementptr inbounds i8, ptr %59, i64 %60
  %62 = load <8 x i64>, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %58, i64 %60
  %64 = load <8 x i64>, ptr %63, align 8
  %65 = select <8 x i1> %8, <8 x i64> %62, <8 x i64> %64
  store <8 x i64> %65, ptr %63, align 8
  %66 = add nuw nsw i64 %57, 1
  %67 = load ptr, ptr %9, align 8
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 8
  %70 = load i64, ptr %69, align 8
  %71 = icmp slt i64 %66, %70
  br i1 %71, label %56, label %48, !llvm.loop !100
}

declare i64 @llvm.cttz.i64(i64, i1 immarg) #5

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
  br i1 %25, label %15, label %14, !llvm.loop !101

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
  br i1 %76, label %65, label %77, !llvm.loop !102

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
  br i1 %105, label %22, label %26, !llvm.loop !103
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
  br i1 %48, label %13, label %20, !llvm.loop !104
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
  br i1 %60, label %29, label %33, !llvm.loop !105

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
  br i1 %76, label %57, label %61, !llvm.loop !106
}

declare double @llvm.sqrt.f64(double) #5

define internal fastcc range(i64 0, 256) i64 @real_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %118, %57
  %6 = icmp eq i64 %25, %1
  br i1 %6, label %7, label %13, !llvm.loop !107

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
  br i1 %56, label %39, label %27, !llvm.loop !108

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
  br i1 %74, label %57, label %61, !llvm.loop !109

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
  br i1 %89, label %71, label %75, !llvm.loop !110

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
  br i1 %117, label %104, label %118, !llvm.loop !111

118:                                              ; preds = %104, %90
  %119 = add nuw nsw i64 %91, 1
  %120 = icmp slt i64 %119, %1
  br i1 %120, label %90, label %5, !llvm.loop !112
}

define internal fastcc range(i64 0, 256) i64 @pair_factorise(ptr noundef %0, i64 noundef %1, ptr noundef writeonly %2) unnamed_addr #7 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %13, label %11

5:                                                ; preds = %179, %69
  %6 = icmp eq i64 %31, %1
  br i1 %6, label %7, label %13, !llvm.loop !113

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
  %24 = load <8 x double>, ptr %23, align 8, !noalias !114
  %25 = or disjoint i64 %21, 64
  %26 = getelementptr inbounds i8, ptr %0, i64 %25
  %27 = load <8 x double>, ptr %26, align 8, !noalias !114
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
  %54 = load <8 x double>, ptr %53, align 8, !noalias !117
  %55 = or disjoint i64 %51, 64
  %56 = getelementptr inbounds i8, ptr %0, i64 %55
  %57 = load <8 x double>, ptr %56, align 8, !noalias !117
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
  br i1 %68, label %45, label %33, !llvm.loop !120

69:                                               ; preds = %96, %33
  %70 = load <8 x double>, ptr %23, align 8, !noalias !121
  %71 = load <8 x double>, ptr %26, align 8, !noalias !121
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
  br i1 %99, label %69, label %86, !llvm.loop !124

100:                                              ; preds = %94, %100
  %101 = phi i64 [ 0, %94 ], [ %122, %100 ]
  %102 = add nuw nsw i64 %101, %19
  %103 = shl i64 %102, 7
  %104 = shl nsw i64 %102, 7
  %105 = getelementptr inbounds i8, ptr %0, i64 %104
  %106 = load <8 x i64>, ptr %105, align 8, !noalias !125
  %107 = or disjoint i64 %103, 64
  %108 = getelementptr inbounds i8, ptr %0, i64 %107
  %109 = load <8 x i64>, ptr %108, align 8, !noalias !125
  %110 = add nuw nsw i64 %101, %95
  %111 = shl i64 %110, 7
  %112 = shl nsw i64 %110, 7
  %113 = getelementptr inbounds i8, ptr %0, i64 %112
  %114 = load <8 x i64>, ptr %113, align 8, !noalias !128
  %115 = or disjoint i64 %111, 64
  %116 = getelementptr inbounds i8, ptr %0, i64 %115
  %117 = load <8 x i64>, ptr %116, align 8, !noalias !128
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
  br i1 %124, label %96, label %100, !llvm.loop !131

125:                                              ; preds = %69, %179
  %126 = phi i64 [ %180, %179 ], [ %31, %69 ]
  %127 = mul nuw nsw i64 %126, %1
  %128 = add nuw nsw i64 %127, %15
  %129 = shl i64 %128, 7
  %130 = shl nsw i64 %128, 7
  %131 = getelementptr inbounds i8, ptr %0, i64 %130
  %132 = load <8 x double>, ptr %131, align 8, !noalias !132
  %133 = or disjoint i64 %129, 64
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !132
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
  %157 = load <8 x double>, ptr %156, align 8, !noalias !135
  %158 = or disjoint i64 %154, 64
  %159 = getelementptr inbounds i8, ptr %0, i64 %158
  %160 = load <8 x double>, ptr %159, align 8, !noalias !135
  %161 = add nuw nsw i64 %152, %19
  %162 = shl i64 %161, 7
  %163 = shl nsw i64 %161, 7
  %164 = getelementptr inbounds i8, ptr %0, i64 %163
  %165 = load <8 x double>, ptr %164, align 8, !noalias !138
  %166 = or disjoint i64 %162, 64
  %167 = getelementptr inbounds i8, ptr %0, i64 %166
  %168 = load <8 x double>, ptr %167, align 8, !noalias !138
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
  br i1 %178, label %151, label %179, !llvm.loop !141

179:                                              ; preds = %151, %125
  %180 = add nuw nsw i64 %126, 1
  %181 = icmp slt i64 %180, %1
  br i1 %181, label %125, label %5, !llvm.loop !142
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
  br i1 %26, label %16, label %6, !llvm.loop !143

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
  br i1 %38, label %24, label %18, !llvm.loop !144

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
  br i1 %55, label %39, label %44, !llvm.loop !145

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
  br i1 %69, label %52, label %56, !llvm.loop !146

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
  br i1 %86, label %71, label %70, !llvm.loop !147

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
  br i1 %100, label %80, label %87, !llvm.loop !148
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
  br i1 %27, label %17, label %6, !llvm.loop !143

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
  br i1 %38, label %25, label %19, !llvm.loop !144

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
  br i1 %46, label %39, label %36, !llvm.loop !149

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
  %56 = load <8 x double>, ptr %55, align 8, !noalias !150
  %57 = or disjoint i64 %53, 64
  %58 = getelementptr inbounds i8, ptr %3, i64 %57
  %59 = load <8 x double>, ptr %58, align 8, !noalias !150
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
  br i1 %67, label %47, label %51, !llvm.loop !153

68:                                               ; preds = %61, %68
  %69 = phi i64 [ 0, %61 ], [ %94, %68 ]
  %70 = phi <8 x double> [ %59, %61 ], [ %93, %68 ]
  %71 = phi <8 x double> [ %56, %61 ], [ %92, %68 ]
  %72 = add nuw nsw i64 %69, %62
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !154
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !154
  %80 = shl i64 %69, 7
  %81 = shl nsw i64 %69, 7
  %82 = getelementptr inbounds i8, ptr %3, i64 %81
  %83 = load <8 x double>, ptr %82, align 8, !noalias !157
  %84 = or disjoint i64 %80, 64
  %85 = getelementptr inbounds i8, ptr %3, i64 %84
  %86 = load <8 x double>, ptr %85, align 8, !noalias !157
  %87 = fneg <8 x double> %79
  %88 = fmul <8 x double> %86, %87
  %89 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %83, <8 x double> %88)
  %90 = fmul <8 x double> %79, %83
  %91 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %76, <8 x double> %86, <8 x double> %90)
  %92 = fsub <8 x double> %71, %89
  %93 = fsub <8 x double> %70, %91
  %94 = add nuw nsw i64 %69, 1
  %95 = icmp eq i64 %94, %52
  br i1 %95, label %63, label %68, !llvm.loop !160

96:                                               ; preds = %110, %47
  ret void

97:                                               ; preds = %49, %110
  %98 = phi i64 [ %1, %49 ], [ %99, %110 ]
  %99 = add nsw i64 %98, -1
  %100 = shl i64 %99, 7
  %101 = shl nsw i64 %99, 7
  %102 = getelementptr inbounds i8, ptr %3, i64 %101
  %103 = load <8 x double>, ptr %102, align 8, !noalias !161
  %104 = or disjoint i64 %100, 64
  %105 = getelementptr inbounds i8, ptr %3, i64 %104
  %106 = load <8 x double>, ptr %105, align 8, !noalias !161
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
  %117 = load <8 x double>, ptr %116, align 8, !noalias !164
  %118 = or disjoint i64 %114, 64
  %119 = getelementptr inbounds i8, ptr %0, i64 %118
  %120 = load <8 x double>, ptr %119, align 8, !noalias !164
  %121 = fneg <8 x double> %112
  %122 = fmul <8 x double> %120, %121
  %123 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %117, <8 x double> %122)
  %124 = fmul <8 x double> %112, %117
  %125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %111, <8 x double> %120, <8 x double> %124)
  store <8 x double> %123, ptr %102, align 8
  store <8 x double> %125, ptr %105, align 8
  %126 = icmp sgt i64 %98, 1
  br i1 %126, label %97, label %96, !llvm.loop !167

127:                                              ; preds = %108, %127
  %128 = phi i64 [ %98, %108 ], [ %153, %127 ]
  %129 = phi <8 x double> [ %106, %108 ], [ %152, %127 ]
  %130 = phi <8 x double> [ %103, %108 ], [ %151, %127 ]
  %131 = add nsw i64 %128, %109
  %132 = shl i64 %131, 7
  %133 = shl nsw i64 %131, 7
  %134 = getelementptr inbounds i8, ptr %0, i64 %133
  %135 = load <8 x double>, ptr %134, align 8, !noalias !168
  %136 = or disjoint i64 %132, 64
  %137 = getelementptr inbounds i8, ptr %0, i64 %136
  %138 = load <8 x double>, ptr %137, align 8, !noalias !168
  %139 = shl i64 %128, 7
  %140 = shl nsw i64 %128, 7
  %141 = getelementptr inbounds i8, ptr %3, i64 %140
  %142 = load <8 x double>, ptr %141, align 8, !noalias !171
  %143 = or disjoint i64 %139, 64
  %144 = getelementptr inbounds i8, ptr %3, i64 %143
  %145 = load <8 x double>, ptr %144, align 8, !noalias !171
  %146 = fneg <8 x double> %138
  %147 = fmul <8 x double> %145, %146
  %148 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %142, <8 x double> %147)
  %149 = fmul <8 x double> %138, %142
  %150 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %135, <8 x double> %145, <8 x double> %149)
  %151 = fsub <8 x double> %130, %148
  %152 = fsub <8 x double> %129, %150
  %153 = add nuw nsw i64 %128, 1
  %154 = icmp eq i64 %153, %1
  br i1 %154, label %110, label %127, !llvm.loop !174
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
  br i1 %35, label %23, label %12, !llvm.loop !143

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
  br i1 %46, label %33, label %27, !llvm.loop !144

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
  br i1 %54, label %47, label %44, !llvm.loop !149

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
  br i1 %70, label %61, label %55, !llvm.loop !175

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
  br i1 %92, label %93, label %80, !llvm.loop !176

93:                                               ; preds = %80, %71
  %94 = add nuw nsw i64 %72, 1
  %95 = icmp eq i64 %94, %56
  br i1 %95, label %68, label %71, !llvm.loop !177

96:                                               ; preds = %136, %106
  %97 = icmp sgt i64 %99, 1
  br i1 %97, label %98, label %105, !llvm.loop !178

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
  br i1 %132, label %133, label %120, !llvm.loop !176

133:                                              ; preds = %120, %111
  %134 = add nuw nsw i64 %112, 1
  %135 = icmp eq i64 %134, %1
  br i1 %135, label %106, label %111, !llvm.loop !179

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
  br i1 %145, label %96, label %136, !llvm.loop !180
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
  br i1 %35, label %23, label %12, !llvm.loop !143

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
  br i1 %46, label %33, label %27, !llvm.loop !144

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
  br i1 %54, label %47, label %44, !llvm.loop !149

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
  br i1 %69, label %61, label %55, !llvm.loop !181

70:                                               ; preds = %58, %109
  %71 = phi i64 [ 0, %58 ], [ %110, %109 ]
  %72 = add nuw nsw i64 %71, %59
  %73 = shl i64 %72, 7
  %74 = shl nsw i64 %72, 7
  %75 = getelementptr inbounds i8, ptr %0, i64 %74
  %76 = load <8 x double>, ptr %75, align 8, !noalias !182
  %77 = or disjoint i64 %73, 64
  %78 = getelementptr inbounds i8, ptr %0, i64 %77
  %79 = load <8 x double>, ptr %78, align 8, !noalias !182
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
  %89 = load <8 x double>, ptr %88, align 8, !noalias !185
  %90 = or disjoint i64 %86, 64
  %91 = getelementptr inbounds i8, ptr %3, i64 %90
  %92 = load <8 x double>, ptr %91, align 8, !noalias !185
  %93 = add nuw nsw i64 %84, %81
  %94 = shl i64 %93, 7
  %95 = shl nsw i64 %93, 7
  %96 = getelementptr inbounds i8, ptr %3, i64 %95
  %97 = load <8 x double>, ptr %96, align 8, !noalias !188
  %98 = or disjoint i64 %94, 64
  %99 = getelementptr inbounds i8, ptr %3, i64 %98
  %100 = load <8 x double>, ptr %99, align 8, !noalias !188
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
  br i1 %108, label %109, label %83, !llvm.loop !191

109:                                              ; preds = %83, %70
  %110 = add nuw nsw i64 %71, 1
  %111 = icmp eq i64 %110, %56
  br i1 %111, label %67, label %70, !llvm.loop !192

112:                                              ; preds = %173, %122
  %113 = icmp sgt i64 %115, 1
  br i1 %113, label %114, label %121, !llvm.loop !193

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
  %137 = load <8 x double>, ptr %136, align 8, !noalias !194
  %138 = or disjoint i64 %134, 64
  %139 = getelementptr inbounds i8, ptr %0, i64 %138
  %140 = load <8 x double>, ptr %139, align 8, !noalias !194
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
  %150 = load <8 x double>, ptr %149, align 8, !noalias !197
  %151 = or disjoint i64 %147, 64
  %152 = getelementptr inbounds i8, ptr %3, i64 %151
  %153 = load <8 x double>, ptr %152, align 8, !noalias !197
  %154 = add nsw i64 %145, %142
  %155 = shl i64 %154, 7
  %156 = shl nsw i64 %154, 7
  %157 = getelementptr inbounds i8, ptr %3, i64 %156
  %158 = load <8 x double>, ptr %157, align 8, !noalias !200
  %159 = or disjoint i64 %155, 64
  %160 = getelementptr inbounds i8, ptr %3, i64 %159
  %161 = load <8 x double>, ptr %160, align 8, !noalias !200
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
  br i1 %169, label %170, label %144, !llvm.loop !191

170:                                              ; preds = %144, %131
  %171 = add nuw nsw i64 %132, 1
  %172 = icmp eq i64 %171, %1
  br i1 %172, label %122, label %131, !llvm.loop !203

173:                                              ; preds = %123, %173
  %174 = phi i64 [ 0, %123 ], [ %190, %173 ]
  %175 = add nsw i64 %174, %124
  %176 = shl i64 %175, 7
  %177 = shl nsw i64 %175, 7
  %178 = getelementptr inbounds i8, ptr %3, i64 %177
  %179 = load <8 x double>, ptr %178, align 8, !noalias !204
  %180 = or disjoint i64 %176, 64
  %181 = getelementptr inbounds i8, ptr %3, i64 %180
  %182 = load <8 x double>, ptr %181, align 8, !noalias !204
  %183 = load <8 x double>, ptr %128, align 8, !noalias !207
  %184 = load <8 x double>, ptr %130, align 8, !noalias !207
  %185 = fneg <8 x double> %182
  %186 = fmul <8 x double> %184, %185
  %187 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %183, <8 x double> %186)
  %188 = fmul <8 x double> %182, %183
  %189 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> %184, <8 x double> %188)
  store <8 x double> %187, ptr %178, align 8
  store <8 x double> %189, ptr %181, align 8
  %190 = add nuw nsw i64 %174, 1
  %191 = icmp eq i64 %190, %4
  br i1 %191, label %112, label %173, !llvm.loop !210
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
  br i1 %26, label %95, label %27

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 1392
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %1, i64 16
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %31, i64 72
  %33 = load ptr, ptr %32, align 8
  %34 = load <8 x double>, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %31, i64 48
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr inbounds i8, ptr %31, i64 96
  %38 = load ptr, ptr %37, align 8
  store <8 x double> zeroinitializer, ptr %38, align 8
  %39 = load ptr, ptr %31, align 8
  %40 = getelementptr inbounds i8, ptr %31, i64 192
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %31, i64 8
  %43 = load i64, ptr %42, align 8
  %44 = load ptr, ptr %1, align 8
  %45 = load ptr, ptr %44, align 8
  %46 = getelementptr inbounds i8, ptr %45, i64 24
  %47 = load i64, ptr %46, align 8
  %48 = load ptr, ptr %37, align 8
  %49 = getelementptr inbounds i8, ptr %1, i64 8
  %50 = load ptr, ptr %49, align 8
  %51 = load ptr, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 16
  %53 = load i64, ptr %52, align 8
  tail call fastcc void @nested(ptr noundef %36, ptr noundef %39, ptr noundef %41, i64 noundef %43, i64 noundef %47, ptr noundef %48, i64 noundef %53) #10
  %54 = fmul <8 x double> %34, zeroinitializer
  %55 = fadd <8 x double> %21, %54
  %56 = getelementptr inbounds i8, ptr %0, i64 168
  %57 = load ptr, ptr %56, align 8
  store <8 x double> %55, ptr %57, align 8
  %58 = getelementptr inbounds i8, ptr %0, i64 296
  %59 = load i64, ptr %58, align 8
  %60 = icmp sgt i64 %59, 0
  br i1 %60, label %61, label %63

61:                                               ; preds = %27
  %62 = getelementptr inbounds i8, ptr %0, i64 144
  tail call fastcc void @sample(ptr noundef nonnull %62) #10
  br label %63

63:                                               ; preds = %27, %61
  %64 = load ptr, ptr %6, align 8
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 168
  %67 = load ptr, ptr %66, align 8
  %68 = load ptr, ptr %30, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 48
  %70 = load ptr, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %0, i64 192
  %72 = load ptr, ptr %71, align 8
  %73 = getelementptr inbounds i8, ptr %0, i64 1272
  %74 = load ptr, ptr %73, align 8
  %75 = inttoptr i64 %65 to ptr
  %76 = load ptr, ptr %75, align 8
  %77 = tail call i32 %76(ptr noundef %67, ptr noundef %70, ptr noundef %72, ptr noundef %74, ptr noundef %29) #11
  %78 = zext i32 %77 to i64
  %79 = and i64 %78, %24
  %80 = icmp sgt i64 %9, 0
  br i1 %80, label %81, label %95

81:                                               ; preds = %63
  %82 = getelementptr inbounds i8, ptr %0, i64 1368
  br label %83

83:                                               ; preds = %81, %83
  %84 = phi i64 [ 0, %81 ], [ %93, %83 ]
  %85 = load ptr, ptr %82, align 8
  %86 = load ptr, ptr %28, align 8
  %87 = shl nsw i64 %84, 6
  %88 = getelementptr inbounds i8, ptr %86, i64 %87
  %89 = load <8 x i64>, ptr %88, align 8
  %90 = getelementptr inbounds i8, ptr %85, i64 %87
  %91 = load <8 x i64>, ptr %90, align 8
  %92 = select <8 x i1> %22, <8 x i64> %89, <8 x i64> %91
  store <8 x i64> %92, ptr %90, align 8
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %9
  br i1 %94, label %95, label %83, !llvm.loop !211

95:                                               ; preds = %83, %63, %4
  %96 = phi i64 [ 0, %4 ], [ %79, %63 ], [ %79, %83 ]
  %97 = getelementptr inbounds i8, ptr %0, i64 1368
  %98 = shl i64 %9, 6
  %99 = getelementptr inbounds i8, ptr %1, i64 16
  %100 = getelementptr inbounds i8, ptr %1, i64 8
  %101 = getelementptr inbounds i8, ptr %0, i64 168
  %102 = getelementptr inbounds i8, ptr %0, i64 296
  %103 = getelementptr inbounds i8, ptr %0, i64 144
  %104 = getelementptr inbounds i8, ptr %0, i64 168
  %105 = getelementptr inbounds i8, ptr %0, i64 192
  %106 = getelementptr inbounds i8, ptr %0, i64 1272
  br label %120

107:                                              ; preds = %160
  %108 = xor i64 %173, -1
  %109 = and i64 %108, %2
  %110 = trunc i64 %109 to i8
  %111 = bitcast i8 %110 to <8 x i1>
  %112 = sext <8 x i1> %111 to <8 x i64>
  %113 = icmp sgt i64 %9, 0
  br i1 %113, label %114, label %176

114:                                              ; preds = %107
  %115 = getelementptr inbounds i8, ptr %0, i64 1416
  %116 = load ptr, ptr %115, align 8
  %117 = getelementptr inbounds i8, ptr %0, i64 1368
  %118 = load ptr, ptr %117, align 8
  %119 = getelementptr inbounds i8, ptr %5, i64 64
  br label %183

120:                                              ; preds = %95, %160
  %121 = phi i64 [ 1, %95 ], [ %174, %160 ]
  %122 = phi i64 [ %96, %95 ], [ %173, %160 ]
  %123 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = load ptr, ptr %97, align 8
  %126 = mul i64 %98, %121
  %127 = getelementptr inbounds i8, ptr %125, i64 %126
  %128 = load ptr, ptr %19, align 8
  %129 = load <8 x double>, ptr %128, align 8
  %130 = load ptr, ptr %99, align 8
  %131 = getelementptr inbounds i8, ptr %130, i64 72
  %132 = load ptr, ptr %131, align 8
  %133 = load <8 x double>, ptr %132, align 8
  %134 = insertelement <8 x double> poison, double %124, i64 0
  %135 = shufflevector <8 x double> %134, <8 x double> poison, <8 x i32> zeroinitializer
  %136 = getelementptr inbounds i8, ptr %130, i64 48
  %137 = load ptr, ptr %136, align 8
  %138 = getelementptr inbounds i8, ptr %130, i64 96
  %139 = load ptr, ptr %138, align 8
  store <8 x double> %135, ptr %139, align 8
  %140 = load ptr, ptr %130, align 8
  %141 = getelementptr inbounds i8, ptr %130, i64 192
  %142 = load ptr, ptr %141, align 8
  %143 = getelementptr inbounds i8, ptr %130, i64 8
  %144 = load i64, ptr %143, align 8
  %145 = load ptr, ptr %1, align 8
  %146 = load ptr, ptr %145, align 8
  %147 = getelementptr inbounds i8, ptr %146, i64 24
  %148 = load i64, ptr %147, align 8
  %149 = load ptr, ptr %138, align 8
  %150 = load ptr, ptr %100, align 8
  %151 = load ptr, ptr %150, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 16
  %153 = load i64, ptr %152, align 8
  tail call fastcc void @nested(ptr noundef %137, ptr noundef %140, ptr noundef %142, i64 noundef %144, i64 noundef %148, ptr noundef %149, i64 noundef %153) #10
  %154 = fmul <8 x double> %135, %133
  %155 = fadd <8 x double> %129, %154
  %156 = load ptr, ptr %101, align 8
  store <8 x double> %155, ptr %156, align 8
  %157 = load i64, ptr %102, align 8
  %158 = icmp sgt i64 %157, 0
  br i1 %158, label %159, label %160

159:                                              ; preds = %120
  tail call fastcc void @sample(ptr noundef nonnull %103) #10
  br label %160

160:                                              ; preds = %120, %159
  %161 = load ptr, ptr %6, align 8
  %162 = load i64, ptr %161, align 8
  %163 = load ptr, ptr %104, align 8
  %164 = load ptr, ptr %99, align 8
  %165 = getelementptr inbounds i8, ptr %164, i64 48
  %166 = load ptr, ptr %165, align 8
  %167 = load ptr, ptr %105, align 8
  %168 = load ptr, ptr %106, align 8
  %169 = inttoptr i64 %162 to ptr
  %170 = load ptr, ptr %169, align 8
  %171 = tail call i32 %170(ptr noundef %163, ptr noundef %166, ptr noundef %167, ptr noundef %168, ptr noundef %127) #11
  %172 = zext i32 %171 to i64
  %173 = or i64 %122, %172
  %174 = add nuw nsw i64 %121, 1
  %175 = icmp eq i64 %174, 5
  br i1 %175, label %107, label %120, !llvm.loop !212

176:                                              ; preds = %304, %107
  %177 = phi <8 x i64> [ %112, %107 ], [ %306, %304 ]
  %178 = icmp sgt i64 %9, 0
  br i1 %178, label %179, label %309

179:                                              ; preds = %176
  %180 = getelementptr inbounds i8, ptr %0, i64 1368
  %181 = shl i64 %9, 8
  %182 = icmp slt <8 x i64> %177, zeroinitializer
  br label %318

183:                                              ; preds = %114, %304
  %184 = phi <8 x double> [ undef, %114 ], [ %218, %304 ]
  %185 = phi <8 x double> [ undef, %114 ], [ %213, %304 ]
  %186 = phi i64 [ 0, %114 ], [ %307, %304 ]
  %187 = phi <8 x i64> [ %112, %114 ], [ %306, %304 ]
  %188 = shl nsw i64 %186, 6
  %189 = getelementptr inbounds i8, ptr %116, i64 %188
  %190 = load <8 x double>, ptr %189, align 8
  br label %196

191:                                              ; preds = %222
  %192 = getelementptr inbounds i64, ptr %15, i64 %186
  %193 = load i64, ptr %192, align 8
  %194 = and i64 %193, 1
  %195 = icmp eq i64 %194, 0
  br i1 %195, label %226, label %238

196:                                              ; preds = %183, %222
  %197 = phi i64 [ 0, %183 ], [ %224, %222 ]
  %198 = phi <8 x double> [ %184, %183 ], [ %218, %222 ]
  %199 = phi <8 x double> [ %185, %183 ], [ %213, %222 ]
  %200 = phi <8 x i64> [ %187, %183 ], [ %223, %222 ]
  %201 = mul nuw nsw i64 %9, %197
  %202 = add nuw nsw i64 %201, %186
  %203 = shl nsw i64 %202, 6
  %204 = getelementptr inbounds i8, ptr %118, i64 %203
  %205 = load <8 x double>, ptr %204, align 8
  %206 = fmul <8 x double> %190, %205
  %207 = getelementptr inbounds [5 x <8 x double>], ptr %5, i64 0, i64 %197
  store <8 x double> %206, ptr %207, align 64
  %208 = icmp eq i64 %197, 0
  br i1 %208, label %212, label %209

209:                                              ; preds = %196
  %210 = fcmp olt <8 x double> %199, %205
  %211 = select <8 x i1> %210, <8 x double> %199, <8 x double> %205
  br label %212

212:                                              ; preds = %196, %209
  %213 = phi <8 x double> [ %205, %196 ], [ %211, %209 ]
  br i1 %208, label %217, label %214

214:                                              ; preds = %212
  %215 = fcmp ogt <8 x double> %198, %205
  %216 = select <8 x i1> %215, <8 x double> %198, <8 x double> %205
  br label %217

217:                                              ; preds = %212, %214
  %218 = phi <8 x double> [ %205, %212 ], [ %216, %214 ]
  br i1 %208, label %222, label %219

219:                                              ; preds = %217
  %220 = fcmp ogt <8 x double> %206, zeroinitializer
  %221 = select <8 x i1> %220, <8 x i64> %200, <8 x i64> zeroinitializer
  br label %222

222:                                              ; preds = %217, %219
  %223 = phi <8 x i64> [ %221, %219 ], [ %200, %217 ]
  %224 = add nuw nsw i64 %197, 1
  %225 = icmp eq i64 %224, 5
  br i1 %225, label %191, label %196, !llvm.loop !213

226:                                              ; preds = %191
  %227 = fmul <8 x double> %213, %218
  %228 = fcmp ogt <8 x double> %227, zeroinitializer
  %229 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %213)
  %230 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %218)
  %231 = fcmp olt <8 x double> %229, %230
  %232 = select <8 x i1> %231, <8 x double> %229, <8 x double> %230
  %233 = fsub <8 x double> %218, %213
  %234 = fmul <8 x double> %233, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %235 = fcmp ogt <8 x double> %232, %234
  %236 = select <8 x i1> %235, <8 x i1> %228, <8 x i1> zeroinitializer
  %237 = select <8 x i1> %236, <8 x i64> %223, <8 x i64> zeroinitializer
  br label %238

238:                                              ; preds = %226, %191
  %239 = phi <8 x i64> [ %223, %191 ], [ %237, %226 ]
  %240 = load <8 x double>, ptr %119, align 64
  %241 = load <8 x double>, ptr %5, align 64
  %242 = fsub <8 x double> %240, %241
  %243 = fdiv <8 x double> %242, <double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C>
  br label %244

244:                                              ; preds = %238, %301
  %245 = phi i64 [ 1, %238 ], [ %251, %301 ]
  %246 = phi <8 x i64> [ zeroinitializer, %238 ], [ %302, %301 ]
  %247 = phi <8 x double> [ %243, %238 ], [ %262, %301 ]
  %248 = add nsw i64 %245, -1
  %249 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %245
  %250 = load double, ptr %249, align 8
  %251 = add nuw nsw i64 %245, 1
  %252 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %251
  %253 = load double, ptr %252, align 8
  %254 = getelementptr inbounds <8 x double>, ptr %5, i64 %251
  %255 = load <8 x double>, ptr %254, align 64
  %256 = getelementptr inbounds <8 x double>, ptr %5, i64 %245
  %257 = load <8 x double>, ptr %256, align 64
  %258 = fsub <8 x double> %255, %257
  %259 = fsub double %253, %250
  %260 = insertelement <8 x double> poison, double %259, i64 0
  %261 = shufflevector <8 x double> %260, <8 x double> poison, <8 x i32> zeroinitializer
  %262 = fdiv <8 x double> %258, %261
  %263 = fcmp ogt <8 x double> %262, %247
  %264 = getelementptr inbounds <8 x double>, ptr %5, i64 %248
  %265 = load <8 x double>, ptr %264, align 64
  %266 = fcmp ogt <8 x double> %265, zeroinitializer
  %267 = and <8 x i1> %263, %266
  %268 = bitcast <8 x i1> %267 to i8
  %269 = icmp eq i8 %268, 0
  br i1 %269, label %301, label %270

270:                                              ; preds = %244
  %271 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %248
  %272 = load double, ptr %271, align 8
  %273 = fsub <8 x double> %262, %247
  %274 = fsub double %253, %272
  %275 = insertelement <8 x double> poison, double %274, i64 0
  %276 = shufflevector <8 x double> %275, <8 x double> poison, <8 x i32> zeroinitializer
  %277 = fdiv <8 x double> %273, %276
  %278 = fsub double %250, %272
  %279 = insertelement <8 x double> poison, double %278, i64 0
  %280 = shufflevector <8 x double> %279, <8 x double> poison, <8 x i32> zeroinitializer
  %281 = fmul <8 x double> %280, %277
  %282 = fadd <8 x double> %247, %281
  %283 = insertelement <8 x double> poison, double %250, i64 0
  %284 = shufflevector <8 x double> %283, <8 x double> poison, <8 x i32> zeroinitializer
  %285 = fmul <8 x double> %282, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %286 = fdiv <8 x double> %285, %277
  %287 = fsub <8 x double> %284, %286
  %288 = icmp ugt i64 %245, 1
  %289 = select i1 %288, double %272, double 0xBFCE3779B97F4A7C
  %290 = icmp eq i64 %245, 3
  %291 = select i1 %290, double 0x3FF4498517A7B356, double %253
  %292 = insertelement <8 x double> poison, double %289, i64 0
  %293 = shufflevector <8 x double> %292, <8 x double> poison, <8 x i32> zeroinitializer
  %294 = fcmp oge <8 x double> %287, %293
  %295 = insertelement <8 x double> poison, double %291, i64 0
  %296 = shufflevector <8 x double> %295, <8 x double> poison, <8 x i32> zeroinitializer
  %297 = fcmp ole <8 x double> %287, %296
  %298 = and <8 x i1> %297, %294
  %299 = and <8 x i1> %298, %267
  %300 = select <8 x i1> %299, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %246
  br label %301

301:                                              ; preds = %270, %244
  %302 = phi <8 x i64> [ %300, %270 ], [ %246, %244 ]
  %303 = icmp eq i64 %251, 4
  br i1 %303, label %304, label %244, !llvm.loop !214

304:                                              ; preds = %301
  %305 = xor <8 x i64> %302, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %306 = and <8 x i64> %239, %305
  %307 = add nuw nsw i64 %186, 1
  %308 = icmp eq i64 %307, %9
  br i1 %308, label %176, label %183, !llvm.loop !215

309:                                              ; preds = %318, %176
  %310 = load ptr, ptr %16, align 8
  %311 = load <8 x i64>, ptr %3, align 8
  %312 = load <8 x i64>, ptr %310, align 8
  %313 = icmp slt <8 x i64> %177, zeroinitializer
  %314 = select <8 x i1> %313, <8 x i64> %311, <8 x i64> %312
  store <8 x i64> %314, ptr %310, align 8
  %315 = icmp ne <8 x i64> %177, zeroinitializer
  %316 = bitcast <8 x i1> %315 to i8
  %317 = zext i8 %316 to i64
  ret i64 %317

318:                                              ; preds = %179, %318
  %319 = phi i64 [ 0, %179 ], [ %329, %318 ]
  %320 = load ptr, ptr %180, align 8
  %321 = shl i64 %319, 6
  %322 = getelementptr i8, ptr %320, i64 %181
  %323 = getelementptr i8, ptr %322, i64 %321
  %324 = load <8 x i64>, ptr %323, align 8
  %325 = shl nsw i64 %319, 6
  %326 = getelementptr inbounds i8, ptr %320, i64 %325
  %327 = load <8 x i64>, ptr %326, align 8
  %328 = select <8 x i1> %182, <8 x i64> %324, <8 x i64> %327
  store <8 x i64> %328, ptr %326, align 8
  %329 = add nuw nsw i64 %319, 1
  %330 = icmp eq i64 %329, %9
  br i1 %330, label %309, label %318, !llvm.loop !216
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
  br i1 %149, label %24, label %129, !llvm.loop !217

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
  br i1 %168, label %150, label %147, !llvm.loop !218
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
  br i1 %31, label %20, label %19, !llvm.loop !219

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
  br i1 %43, label %32, label %24, !llvm.loop !220
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
!106 = distinct !{!106, !4, !5, !63}
!107 = distinct !{!107, !4, !5}
!108 = distinct !{!108, !4, !5}
!109 = distinct !{!109, !4, !5}
!110 = distinct !{!110, !4, !5}
!111 = distinct !{!111, !4, !5}
!112 = distinct !{!112, !4, !5}
!113 = distinct !{!113, !4, !5}
!114 = !{!115}
!115 = distinct !{!115, !116, !"pair_item: argument 0"}
!116 = distinct !{!116, !"pair_item"}
!117 = !{!118}
!118 = distinct !{!118, !119, !"pair_item: argument 0"}
!119 = distinct !{!119, !"pair_item"}
!120 = distinct !{!120, !4, !5}
!121 = !{!122}
!122 = distinct !{!122, !123, !"pair_item: argument 0"}
!123 = distinct !{!123, !"pair_item"}
!124 = distinct !{!124, !4, !5}
!125 = !{!126}
!126 = distinct !{!126, !127, !"pair_item: argument 0"}
!127 = distinct !{!127, !"pair_item"}
!128 = !{!129}
!129 = distinct !{!129, !130, !"pair_item: argument 0"}
!130 = distinct !{!130, !"pair_item"}
!131 = distinct !{!131, !4, !5}
!132 = !{!133}
!133 = distinct !{!133, !134, !"pair_item: argument 0"}
!134 = distinct !{!134, !"pair_item"}
!135 = !{!136}
!136 = distinct !{!136, !137, !"pair_item: argument 0"}
!137 = distinct !{!137, !"pair_item"}
!138 = !{!139}
!139 = distinct !{!139, !140, !"pair_item: argument 0"}
!140 = distinct !{!140, !"pair_item"}
!141 = distinct !{!141, !4, !5}
!142 = distinct !{!142, !4, !5}
!143 = distinct !{!143, !4, !5}
!144 = distinct !{!144, !4, !5}
!145 = distinct !{!145, !4, !5}
!146 = distinct !{!146, !4, !5}
!147 = distinct !{!147, !4, !5}
!148 = distinct !{!148, !4, !5}
!149 = distinct !{!149, !4, !5, !63}
!150 = !{!151}
!151 = distinct !{!151, !152, !"pair_item: argument 0"}
!152 = distinct !{!152, !"pair_item"}
!153 = distinct !{!153, !4, !5}
!154 = !{!155}
!155 = distinct !{!155, !156, !"pair_item: argument 0"}
!156 = distinct !{!156, !"pair_item"}
!157 = !{!158}
!158 = distinct !{!158, !159, !"pair_item: argument 0"}
!159 = distinct !{!159, !"pair_item"}
!160 = distinct !{!160, !4, !5}
!161 = !{!162}
!162 = distinct !{!162, !163, !"pair_item: argument 0"}
!163 = distinct !{!163, !"pair_item"}
!164 = !{!165}
!165 = distinct !{!165, !166, !"pair_item: argument 0"}
!166 = distinct !{!166, !"pair_item"}
!167 = distinct !{!167, !4, !5}
!168 = !{!169}
!169 = distinct !{!169, !170, !"pair_item: argument 0"}
!170 = distinct !{!170, !"pair_item"}
!171 = !{!172}
!172 = distinct !{!172, !173, !"pair_item: argument 0"}
!173 = distinct !{!173, !"pair_item"}
!174 = distinct !{!174, !4, !5}
!175 = distinct !{!175, !4, !5}
!176 = distinct !{!176, !4, !5}
!177 = distinct !{!177, !4, !5}
!178 = distinct !{!178, !4, !5}
!179 = distinct !{!179, !4, !5}
!180 = distinct !{!180, !4, !5}
!181 = distinct !{!181, !4, !5}
!182 = !{!183}
!183 = distinct !{!183, !184, !"pair_item: argument 0"}
!184 = distinct !{!184, !"pair_item"}
!185 = !{!186}
!186 = distinct !{!186, !187, !"pair_item: argument 0"}
!187 = distinct !{!187, !"pair_item"}
!188 = !{!189}
!189 = distinct !{!189, !190, !"pair_item: argument 0"}
!190 = distinct !{!190, !"pair_item"}
!191 = distinct !{!191, !4, !5}
!192 = distinct !{!192, !4, !5}
!193 = distinct !{!193, !4, !5}
!194 = !{!195}
!195 = distinct !{!195, !196, !"pair_item: argument 0"}
!196 = distinct !{!196, !"pair_item"}
!197 = !{!198}
!198 = distinct !{!198, !199, !"pair_item: argument 0"}
!199 = distinct !{!199, !"pair_item"}
!200 = !{!201}
!201 = distinct !{!201, !202, !"pair_item: argument 0"}
!202 = distinct !{!202, !"pair_item"}
!203 = distinct !{!203, !4, !5}
!204 = !{!205}
!205 = distinct !{!205, !206, !"pair_item: argument 0"}
!206 = distinct !{!206, !"pair_item"}
!207 = !{!208}
!208 = distinct !{!208, !209, !"pair_item: argument 0"}
!209 = distinct !{!209, !"pair_item"}
!210 = distinct !{!210, !4, !5}
!211 = distinct !{!211, !4, !5}
!212 = distinct !{!212, !4, !5}
!213 = distinct !{!213, !4, !5}
!214 = distinct !{!214, !4, !5}
!215 = distinct !{!215, !4, !5}
!216 = distinct !{!216, !4, !5}
!217 = distinct !{!217, !4, !5, !63}
!218 = distinct !{!218, !4, !5}
!219 = distinct !{!219, !4, !5}
!220 = distinct !{!220, !4, !5}
