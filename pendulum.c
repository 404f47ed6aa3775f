/* pendulum: exported by pydy 1.0.0. */

#ifndef PYDY_PENDULUM_H
#define PYDY_PENDULUM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    PENDULUM_STATES = 6,
    PENDULUM_INPUTS = 1,
    PENDULUM_CONSTANTS = 6,
    PENDULUM_OUTPUTS = 0,
    PENDULUM_EVENTS = 0,
    PENDULUM_PREPARED = 36
};

typedef struct {
    double g;
    double l0;
    double l1;
    double m0;
    double m1;
    double m2;
} pendulum_constants;

extern const pendulum_constants pendulum_defaults;
extern const double pendulum_initial[]; /* states at the start */
extern const double pendulum_inputs[]; /* inputs at the start */
extern const char *const pendulum_state_names[];
extern const char *const pendulum_input_names[];
extern const char *const pendulum_constant_names[];
extern const char *const pendulum_output_names[];

/* Compute what all calls with the same constants share: an array of so many numbers. */
void pendulum_prepare(const pendulum_constants *constants, double *prepared);

/* Write the derivatives of the states. Returns 1 where the mass matrix is singular. */
int32_t pendulum_rates(double t, const double *x, const double *r,
    const double *prepared, double *out);

/* Write the outputs. Returns 1 where the mass matrix is singular. */
int32_t pendulum_outputs(double t, const double *x, const double *r,
    const double *prepared, double *out);

/* Write the derivatives of rates and outputs by states and inputs, row by row. Returns 1 where the mass matrix is singular. */
int32_t pendulum_jacobian(double t, const double *x, const double *r,
    const double *prepared, double *out);

#ifdef __cplusplus
}
#endif

#endif

#include <math.h>
#include <stdint.h>

#if defined(_MSC_VER) || defined(__cplusplus)
#define RESTRICT __restrict
#else
#define RESTRICT restrict
#endif

#define AT(k) (k)
#define LESS(c, a, b) ((c) - (a) * (b))
#define SERIAL

/* Factorise the n by n matrix a in place by LU with partial pivoting; `scales` is 2 n numbers of
   work space, the reciprocal sizes of the rows and then of the columns. Returns whether a is
   singular. */
static inline int32_t lu_factor(int64_t n, double *a, int64_t *pivots, double *scales)
{
    const double tolerance = (double)n * 2.220446049250313e-16;
    int32_t singular = 0;
    for (int64_t i = 0; i < n; i++) {
        double top = 0.0;
        SERIAL
        for (int64_t j = 0; j < n; j++) {
            const double size = fabs(a[AT(i * n + j)]);
            top = size > top ? size : top;
        }
        scales[i] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int64_t j = 0; j < n; j++) {
        double top = 0.0;
        SERIAL
        for (int64_t i = 0; i < n; i++) {
            const double size = fabs(a[AT(i * n + j)]) * scales[i];
            top = size > top ? size : top;
        }
        scales[n + j] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int64_t k = 0; k < n; k++) {
        int64_t pivot = k;
        double best = fabs(a[AT(k * n + k)]) * scales[k];
        SERIAL
        for (int64_t i = k + 1; i < n; i++) {
            const double size = fabs(a[AT(i * n + k)]) * scales[i];
            if (size > best) {
                best = size;
                pivot = i;
            }
        }
        if (best * scales[n + k] <= tolerance)
            singular = 1;
        pivots[AT(k)] = pivot;
        if (pivot != k) {
            SERIAL
            for (int64_t j = 0; j < n; j++) {
                const double swapped = a[AT(k * n + j)];
                a[AT(k * n + j)] = a[AT(pivot * n + j)];
                a[AT(pivot * n + j)] = swapped;
            }
            const double swapped = scales[k];
            scales[k] = scales[pivot];
            scales[pivot] = swapped;
        }
        const double inverse = 1.0 / a[AT(k * n + k)];
        for (int64_t i = k + 1; i < n; i++) {
            const double factor = a[AT(i * n + k)] * inverse;
            a[AT(i * n + k)] = factor;
            SERIAL
            for (int64_t j = k + 1; j < n; j++)
                a[AT(i * n + j)] = LESS(a[AT(i * n + j)], factor, a[AT(k * n + j)]);
        }
    }
    if (singular)
        a[AT(n * n - 1)] = NAN; /* so that every solution is NaN */
    return singular;
}

/* Solve in place of the right-hand side b, with the factors from lu_factor. */
static inline void lu_solve(int64_t n, const double *a, const int64_t *pivots, double *b)
{
    SERIAL
    for (int64_t k = 0; k < n; k++) {
        const int64_t pivot = pivots[AT(k)];
        const double swapped = b[AT(k)];
        b[AT(k)] = b[AT(pivot)];
        b[AT(pivot)] = swapped;
    }
    for (int64_t i = 0; i < n; i++)
        SERIAL
        for (int64_t k = 0; k < i; k++)
            b[AT(i)] = LESS(b[AT(i)], a[AT(i * n + k)], b[AT(k)]);
    for (int64_t i = n - 1; i >= 0; i--) {
        SERIAL
        for (int64_t k = i + 1; k < n; k++)
            b[AT(i)] = LESS(b[AT(i)], a[AT(i * n + k)], b[AT(k)]);
        b[AT(i)] /= a[AT(i * n + i)];
    }
}

#undef AT
#undef LESS
#undef SERIAL

static void pendulum_rates_prepare(const double *RESTRICT p, double *RESTRICT c)
{
    (void)p; (void)c;
    const double v11 = p[2] * p[5];
    const double v31 = p[1] * p[4];
    const double v47 = p[4] + p[5];
    const double v48 = p[3] + v47;
    const int v49 = 0.0 < v48;
    const double v50 = p[1] * p[1];
    const double v51 = v47 * v50;
    const double v53 = v51 * 6.661338147750939e-16;
    const double v54 = p[1] * v47;
    const double v57 = 1.0 / v48;
    const double v63 = p[2] * p[2];
    const double v64 = p[5] * v63;
    const double v65 = v64 * 6.661338147750939e-16;
    const double v69 = p[1] * p[2];
    const double v70 = p[5] * v69;
    c[0] = p[2];
    c[1] = p[5];
    c[2] = v11;
    c[3] = p[1];
    c[4] = p[0];
    c[5] = p[4];
    c[6] = v31;
    c[7] = v48;
    c[8] = v49;
    c[9] = v51;
    c[10] = v53;
    c[11] = v54;
    c[12] = v57;
    c[13] = v64;
    c[14] = v65;
    c[15] = v70;
}

static int32_t pendulum_rates_kernel(
    const double *RESTRICT t, const double *RESTRICT x, const double *RESTRICT r,
    const double *RESTRICT c, double *RESTRICT out)
{
    (void)t; (void)x; (void)r; (void)c; (void)out;
    int32_t status = 0;
    const double v2 = cos(x[1]);
    const double v3 = sin(x[1]);
    const double v4 = cos(x[2]);
    const double v5 = sin(x[2]);
    const double v13 = x[4] * x[4];
    const double v14 = c[3] * v13;
    const double v15 = v3 * v14;
    const double v16 = x[5] * x[5];
    const double v17 = c[0] * v16;
    const double v18 = v5 * v17;
    const double v19 = v15 + v18;
    const double v20 = v4 * v19;
    const double v21 = v2 * v14;
    const double v22 = v4 * v17;
    const double v23 = v21 + v22;
    const double v25 = v23 - c[4];
    const double v26 = v5 * v25;
    const double v27 = v20 - v26;
    const double v28 = c[2] * v27;
    const double v29 = v19 * c[1];
    const double v32 = v3 * c[6];
    const double v33 = v13 * v32;
    const double v34 = v33 + v29;
    const double v35 = v2 * v34;
    const double v36 = c[1] * v25;
    const double v37 = v21 - c[4];
    const double v38 = c[5] * v37;
    const double v39 = v36 + v38;
    const double v40 = v3 * v39;
    const double v41 = v35 - v40;
    const double v42 = c[3] * v41;
    const double v44 = r[0] - v34;
    const double v55 = v2 * c[11];
    const double v58 = v55 * c[12];
    const double v59 = v55 * v58;
    const double v60 = c[9] - v59;
    const int v61 = c[10] < v60;
    const int v62 = (c[8] != 0.0) & v61;
    const double v66 = v2 * v4;
    const double v67 = v3 * v5;
    const double v68 = v66 + v67;
    const double v71 = v68 * c[15];
    const double v72 = v4 * c[2];
    const double v73 = v72 * v58;
    const double v74 = v71 - v73;
    const double v75 = 1.0 / v60;
    const double v76 = v75 * v74;
    const double v77 = v74 * v76;
    const double v78 = v72 * c[12];
    const double v79 = v72 * v78;
    const double v80 = c[13] - v79;
    const double v81 = v80 - v77;
    const int v82 = c[14] < v81;
    const int v83 = v62 & v82;
    const double v84 = 1.0 / v81;
    const double v85 = v44 * v58;
    const double v86 = v42 + v85;
    const double v87 = v76 * v86;
    const double v88 = v44 * v78;
    const double v89 = v28 + v88;
    const double v90 = v89 - v87;
    const double v91 = v84 * v90;
    const double v92 = v76 * v91;
    const double v93 = v75 * v86;
    const double v94 = v93 - v92;
    const double v95 = v58 * v94;
    const double v96 = v44 * c[12];
    const double v97 = v96 + v95;
    const double v98 = v78 * v91;
    const double v99 = v97 + v98;
    double v102[3] = {v99, v94, v91};
    if (!(v83)) {
        const double v100 = -v55;
        const double v101 = -v72;
        v102[0] = v44;
        v102[1] = v42;
        v102[2] = v28;
        double v102_a[] = {c[7], v100, v101, v100, c[9], v71, v101, v71, c[13]};
        int64_t v102_pivots[3 + 1];
        double v102_scales[2 * 3 + 1];
        status |= lu_factor(3, v102_a, v102_pivots, v102_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v102_a, v102_pivots, v102 + k);
    }
    out[0] = x[3];
    out[1] = x[4];
    out[2] = x[5];
    out[3] = v102[0];
    out[4] = v102[1];
    out[5] = v102[2];
    return status;
}

static void pendulum_outputs_prepare(const double *RESTRICT p, double *RESTRICT c)
{
    (void)p; (void)c;
}

static int32_t pendulum_outputs_kernel(
    const double *RESTRICT t, const double *RESTRICT x, const double *RESTRICT r,
    const double *RESTRICT c, double *RESTRICT out)
{
    (void)t; (void)x; (void)r; (void)c; (void)out;
    int32_t status = 0;
    return status;
}

static void pendulum_jacobian_prepare(const double *RESTRICT p, double *RESTRICT c)
{
    (void)p; (void)c;
    const double v11 = p[1] * p[2];
    const double v12 = p[5] * v11;
    const double v13 = p[2] * p[5];
    const double v34 = p[1] * p[4];
    const double v49 = p[4] + p[5];
    const double v50 = p[3] + v49;
    const int v51 = 0.0 < v50;
    const double v52 = p[1] * p[1];
    const double v53 = v49 * v52;
    const double v55 = v53 * 6.661338147750939e-16;
    const double v56 = p[1] * v49;
    const double v58 = 1.0 / v50;
    const double v64 = p[2] * p[2];
    const double v65 = p[5] * v64;
    const double v66 = v65 * 6.661338147750939e-16;
    const double v193 = v12 * 2.0;
    const double v197 = v56 * 2.0;
    const double v220 = v13 * 2.0;
    c[0] = p[5];
    c[1] = p[1];
    c[2] = p[2];
    c[3] = v12;
    c[4] = v13;
    c[5] = p[0];
    c[6] = p[4];
    c[7] = v34;
    c[8] = v49;
    c[9] = v50;
    c[10] = v51;
    c[11] = v53;
    c[12] = v55;
    c[13] = v56;
    c[14] = v58;
    c[15] = v65;
    c[16] = v66;
    c[17] = v193;
    c[18] = v197;
    c[19] = v220;
}

static int32_t pendulum_jacobian_kernel(
    const double *RESTRICT t, const double *RESTRICT x, const double *RESTRICT r,
    const double *RESTRICT c, double *RESTRICT out)
{
    (void)t; (void)x; (void)r; (void)c; (void)out;
    int32_t status = 0;
    const double v2 = cos(x[1]);
    const double v3 = sin(x[1]);
    const double v4 = cos(x[2]);
    const double v5 = sin(x[2]);
    const double v15 = x[4] * x[4];
    const double v16 = c[1] * v15;
    const double v17 = v3 * v16;
    const double v19 = x[5] * x[5];
    const double v20 = c[2] * v19;
    const double v21 = v5 * v20;
    const double v22 = v17 + v21;
    const double v23 = v4 * v22;
    const double v24 = v2 * v16;
    const double v25 = v4 * v20;
    const double v26 = v24 + v25;
    const double v28 = v26 - c[5];
    const double v29 = v5 * v28;
    const double v30 = v23 - v29;
    const double v31 = c[4] * v30;
    const double v32 = v22 * c[0];
    const double v35 = v3 * c[7];
    const double v36 = v15 * v35;
    const double v37 = v36 + v32;
    const double v38 = v2 * v37;
    const double v39 = c[0] * v28;
    const double v40 = v24 - c[5];
    const double v41 = c[6] * v40;
    const double v42 = v39 + v41;
    const double v43 = v3 * v42;
    const double v44 = v38 - v43;
    const double v45 = c[1] * v44;
    const double v47 = r[0] - v37;
    const double v57 = v2 * c[13];
    const double v59 = v57 * c[14];
    const double v60 = v57 * v59;
    const double v61 = c[11] - v60;
    const int v62 = c[12] < v61;
    const int v63 = (c[10] != 0.0) & v62;
    const double v67 = v2 * v4;
    const double v68 = v3 * v5;
    const double v69 = v67 + v68;
    const double v70 = v69 * c[3];
    const double v71 = v4 * c[4];
    const double v72 = v71 * v59;
    const double v73 = v70 - v72;
    const double v74 = 1.0 / v61;
    const double v75 = v74 * v73;
    const double v76 = v73 * v75;
    const double v77 = v71 * c[14];
    const double v78 = v71 * v77;
    const double v79 = c[15] - v78;
    const double v80 = v79 - v76;
    const int v81 = c[16] < v80;
    const int v82 = v63 & v81;
    const double v83 = 1.0 / v80;
    const double v84 = v47 * v59;
    const double v85 = v45 + v84;
    const double v86 = v75 * v85;
    const double v87 = v47 * v77;
    const double v88 = v31 + v87;
    const double v89 = v88 - v86;
    const double v90 = v83 * v89;
    const double v91 = v75 * v90;
    const double v92 = v74 * v85;
    const double v93 = v92 - v91;
    const double v94 = v59 * v93;
    const double v95 = v47 * c[14];
    const double v96 = v95 + v94;
    const double v97 = v77 * v90;
    const double v98 = v96 + v97;
    const double v99 = -v57;
    const double v100 = -v71;
    double v101[3] = {v98, v93, v90};
    if (!(v82)) {
        v101[0] = v47;
        v101[1] = v45;
        v101[2] = v31;
        double v101_a[] = {c[9], v99, v100, v99, c[11], v70, v100, v70, c[15]};
        int64_t v101_pivots[3 + 1];
        double v101_scales[2 * 3 + 1];
        status |= lu_factor(3, v101_a, v101_pivots, v101_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v101_a, v101_pivots, v101 + k);
    }
    const double v103 = v3 * v4;
    const double v104 = v2 * v5;
    const double v105 = v103 - v104;
    const double v106 = v101[1] * v105;
    const double v107 = v15 * v69;
    const double v108 = v107 + v106;
    const double v109 = c[3] * v108;
    const double v111 = v3 * c[8];
    const double v112 = v101[0] * v111;
    const double v113 = v2 * v42;
    const double v114 = v15 * c[13];
    const double v115 = v3 * v3;
    const double v116 = v114 * v115;
    const double v117 = v113 - v116;
    const double v118 = v3 * v37;
    const double v119 = v2 * v2;
    const double v120 = v114 * v119;
    const double v121 = v118 - v120;
    const double v122 = v117 + v121;
    const double v123 = v122 + v112;
    const double v125 = v101[2] * v105;
    const double v126 = c[4] * v125;
    const double v127 = v123 - v126;
    const double v128 = c[1] * v127;
    const double v129 = -v128;
    const double v130 = v3 * v101[1];
    const double v131 = v2 * v15;
    const double v132 = v131 + v130;
    const double v133 = c[13] * v132;
    const double v135 = v77 * v133;
    const double v136 = v109 - v135;
    const double v137 = v59 * v133;
    const double v138 = v129 - v137;
    const double v139 = v75 * v138;
    const double v140 = v136 - v139;
    const double v141 = v83 * v140;
    const double v142 = v75 * v141;
    const double v143 = v74 * v138;
    const double v144 = v143 - v142;
    const double v145 = v59 * v144;
    const double v146 = c[14] * v133;
    const double v147 = v145 - v146;
    const double v148 = v77 * v141;
    const double v149 = v147 + v148;
    double v150[3] = {v149, v144, v141};
    if (!(v82)) {
        const double v134 = -v133;
        v150[0] = v134;
        v150[1] = v129;
        v150[2] = v109;
        double v150_a[] = {c[9], v99, v100, v99, c[11], v70, v100, v70, c[15]};
        int64_t v150_pivots[3 + 1];
        double v150_scales[2 * 3 + 1];
        status |= lu_factor(3, v150_a, v150_pivots, v150_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v150_a, v150_pivots, v150 + k);
    }
    const double v152 = v5 * v101[0];
    const double v153 = c[1] * v106;
    const double v154 = v4 * v28;
    const double v155 = v5 * v5;
    const double v156 = v20 * v155;
    const double v157 = v154 - v156;
    const double v158 = v5 * v22;
    const double v159 = v4 * v4;
    const double v160 = v20 * v159;
    const double v161 = v158 - v160;
    const double v162 = v157 + v161;
    const double v163 = v162 + v153;
    const double v164 = v152 + v163;
    const double v165 = c[4] * v164;
    const double v166 = -v165;
    const double v167 = v19 * v69;
    const double v168 = v167 - v125;
    const double v169 = c[3] * v168;
    const double v170 = v5 * v101[2];
    const double v171 = v4 * v19;
    const double v172 = v171 + v170;
    const double v173 = c[4] * v172;
    const double v175 = v77 * v173;
    const double v176 = v166 - v175;
    const double v177 = v59 * v173;
    const double v178 = v169 - v177;
    const double v179 = v75 * v178;
    const double v180 = v176 - v179;
    const double v181 = v83 * v180;
    const double v182 = v75 * v181;
    const double v183 = v74 * v178;
    const double v184 = v183 - v182;
    const double v185 = v59 * v184;
    const double v186 = c[14] * v173;
    const double v187 = v185 - v186;
    const double v188 = v77 * v181;
    const double v189 = v187 + v188;
    double v190[3] = {v189, v184, v181};
    if (!(v82)) {
        const double v174 = -v173;
        v190[0] = v174;
        v190[1] = v169;
        v190[2] = v166;
        double v190_a[] = {c[9], v99, v100, v99, c[11], v70, v100, v70, c[15]};
        int64_t v190_pivots[3 + 1];
        double v190_scales[2 * 3 + 1];
        status |= lu_factor(3, v190_a, v190_pivots, v190_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v190_a, v190_pivots, v190 + k);
    }
    const double v194 = v105 * c[17];
    const double v195 = x[4] * v194;
    const double v196 = x[4] * v3;
    const double v198 = v196 * c[18];
    const double v200 = v77 * v198;
    const double v201 = v195 - v200;
    const double v202 = v59 * v198;
    const double v203 = v75 * v202;
    const double v204 = v201 + v203;
    const double v205 = v83 * v204;
    const double v206 = v75 * v205;
    const double v207 = v74 * v202;
    const double v208 = -v207;
    const double v209 = v208 - v206;
    const double v210 = v59 * v209;
    const double v211 = c[14] * v198;
    const double v212 = v210 - v211;
    const double v213 = v77 * v205;
    const double v214 = v212 + v213;
    double v215[3] = {v214, v209, v205};
    if (!(v82)) {
        const double v199 = -v198;
        v215[0] = v199;
        v215[1] = 0.0;
        v215[2] = v195;
        double v215_a[] = {c[9], v99, v100, v99, c[11], v70, v100, v70, c[15]};
        int64_t v215_pivots[3 + 1];
        double v215_scales[2 * 3 + 1];
        status |= lu_factor(3, v215_a, v215_pivots, v215_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v215_a, v215_pivots, v215 + k);
    }
    const double v217 = x[5] * v194;
    const double v218 = -v217;
    const double v219 = x[5] * v5;
    const double v221 = v219 * c[19];
    const double v223 = v59 * v221;
    const double v224 = v218 - v223;
    const double v225 = v75 * v224;
    const double v226 = v77 * v221;
    const double v227 = -v226;
    const double v228 = v227 - v225;
    const double v229 = v83 * v228;
    const double v230 = v75 * v229;
    const double v231 = v74 * v224;
    const double v232 = v231 - v230;
    const double v233 = v59 * v232;
    const double v234 = c[14] * v221;
    const double v235 = v233 - v234;
    const double v236 = v77 * v229;
    const double v237 = v235 + v236;
    double v238[3] = {v237, v232, v229};
    if (!(v82)) {
        const double v222 = -v221;
        v238[0] = v222;
        v238[1] = v218;
        v238[2] = 0.0;
        double v238_a[] = {c[9], v99, v100, v99, c[11], v70, v100, v70, c[15]};
        int64_t v238_pivots[3 + 1];
        double v238_scales[2 * 3 + 1];
        status |= lu_factor(3, v238_a, v238_pivots, v238_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v238_a, v238_pivots, v238 + k);
    }
    const double v240 = v59 * v75;
    const double v241 = v77 - v240;
    const double v242 = v83 * v241;
    const double v243 = v75 * v242;
    const double v244 = v59 * v74;
    const double v245 = v244 - v243;
    const double v246 = v59 * v245;
    const double v247 = c[14] + v246;
    const double v248 = v77 * v242;
    const double v249 = v247 + v248;
    double v250[3] = {v249, v245, v242};
    if (!(v82)) {
        v250[0] = 1.0;
        v250[1] = 0.0;
        v250[2] = 0.0;
        double v250_a[] = {c[9], v99, v100, v99, c[11], v70, v100, v70, c[15]};
        int64_t v250_pivots[3 + 1];
        double v250_scales[2 * 3 + 1];
        status |= lu_factor(3, v250_a, v250_pivots, v250_scales);
        for (int k = 0; k < 3; k += 3)
            lu_solve(3, v250_a, v250_pivots, v250 + k);
    }
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 1.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 1.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = 1.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = v150[0];
    out[23] = v190[0];
    out[24] = 0.0;
    out[25] = v215[0];
    out[26] = v238[0];
    out[27] = v250[0];
    out[28] = 0.0;
    out[29] = v150[1];
    out[30] = v190[1];
    out[31] = 0.0;
    out[32] = v215[1];
    out[33] = v238[1];
    out[34] = v250[1];
    out[35] = 0.0;
    out[36] = v150[2];
    out[37] = v190[2];
    out[38] = 0.0;
    out[39] = v215[2];
    out[40] = v238[2];
    out[41] = v250[2];
    return status;
}

const pendulum_constants pendulum_defaults = {9.81, 0.7, 1.0, 1.0, 1.0, 1.0};
const double pendulum_initial[] = {0.0, 0.4, 0.0, 0.0, 0.0, 0.0};
const double pendulum_inputs[] = {0.0};
const char *const pendulum_state_names[] = {"q0", "q1", "q2", "u0", "u1", "u2"};
const char *const pendulum_input_names[] = {"F"};
const char *const pendulum_constant_names[] = {"g", "l0", "l1", "m0", "m1", "m2"};
const char *const pendulum_output_names[] = {""};

void pendulum_prepare(const pendulum_constants *constants, double *prepared)
{
    const double p[] = {constants->g, constants->l0, constants->l1, constants->m0, constants->m1, constants->m2};
    (void)constants;
    pendulum_rates_prepare(p, prepared + 0);
    pendulum_outputs_prepare(p, prepared + 16);
    pendulum_jacobian_prepare(p, prepared + 16);
}

int32_t pendulum_rates(double t, const double *x, const double *r,
    const double *prepared, double *out)
{
    return pendulum_rates_kernel(&t, x, r, prepared + 0, out);
}

int32_t pendulum_outputs(double t, const double *x, const double *r,
    const double *prepared, double *out)
{
    return pendulum_outputs_kernel(&t, x, r, prepared + 16, out);
}

int32_t pendulum_jacobian(double t, const double *x, const double *r,
    const double *prepared, double *out)
{
    return pendulum_jacobian_kernel(&t, x, r, prepared + 16, out);
}
