/* Linear solves of LANES states: LU with partial pivoting lane by lane, LDL^T of all side by side.

   These routines are compiled once, not with every model; a kernel knows them by name. Every array
   is laid out [item][lane]. A matrix is singular when a pivot is not above n eps of its row's and
   column's scale; the lane's bit is then set and its solution is NaN. A NaN in the matrix is not a
   failure: it comes out as NaN. Products are fused with sums by name, the same on every processor. */

#include <stdint.h>

#include "layout.h"

#define AT(k) ((k) * LANES)
#define LESS(c, a, b) __builtin_fma(-(a), b, c)
#if LANES > 1
#define SERIAL _Pragma("clang loop vectorize(disable)") /* no gathers along a lane */
#else
#define SERIAL
#endif
#define NAN __builtin_nan("")
#define fabs __builtin_fabs
#define sqrt __builtin_sqrt

#include "constrained.h"
#include "lu_factor.h"
#include "lu_solve.h"

#define JOIN(a, b) a##b
#define NAMED(name, lanes) JOIN(name, lanes)

#if LANES > 1
typedef double Lanes __attribute__((ext_vector_type(LANES), aligned(8)));
typedef int64_t Flags __attribute__((ext_vector_type(LANES)));
typedef _Bool Bits __attribute__((ext_vector_type(LANES)));
#define less(c, a, b) __builtin_elementwise_fma(-(a), b, c)

static inline __attribute__((always_inline)) int32_t bits(Flags flags)
{
    const Bits each = __builtin_convertvector(flags, Bits);
    uint8_t byte;
    __builtin_memcpy(&byte, &each, 1);
    return byte & ((1 << LANES) - 1);
}
#else
typedef double Lanes;
typedef int32_t Flags;
#define less LESS
#define bits(flags) (flags)
#endif

/* Factorise (b null) or solve the lanes in `mask`; gives the mask of the singular ones. */
int32_t NAMED(pydy_lu_, LANES)(
    double *a, int64_t *pivots, double *scales, double *b, int64_t n, int32_t mask)
{
    int32_t bad = 0;
    for (int lane = 0; lane < LANES; lane++)
        if (mask >> lane & 1) {
            if (b)
                lu_solve(n, a + lane, pivots + lane, b + lane);
            else
                bad |= lu_factor(n, a + lane, pivots + lane, scales) << lane;
        }
    return bad;
}

/* Solve the lanes in `mask` in place of m numbers of right-hand sides. */
int32_t NAMED(pydy_constrained_, LANES)(
    double *a, int64_t *pivots, double *scales, double *b, int64_t m, int64_t n, int32_t mask)
{
    int32_t bad = 0;
    for (int lane = 0; lane < LANES; lane++)
        if (mask >> lane & 1)
            bad |= constrained(n, a + lane, pivots + lane, scales, m, b + lane) << lane;
    return bad;
}

/* Factorise all lanes in place, right-looking on the upper triangle, rows contiguous. Row k keeps
   d U, `inverse` gets 1/d. Gives the mask of the lanes with a pivot that is not sound. */
int32_t NAMED(pydy_ldl_factor_, LANES)(double *matrix, double *reciprocals, int64_t n)
{
    Lanes *a = (Lanes *)matrix, *inverse = (Lanes *)reciprocals;
    const Lanes tolerance = (Lanes)((double)n * SINGULAR);
    Flags weak = (Flags)0;
    for (int64_t k = 0; k < n; k++) inverse[k] = a[k * n + k] * tolerance; /* the original is the scale */
    for (int64_t k = 0; k < n; k++) {
        const Lanes pivot = a[k * n + k], *row = a + k * n;
        weak |= !(pivot > inverse[k]);
        inverse[k] = 1.0 / pivot;
        for (int64_t i = k + 1; i < n; i++) {
            const Lanes factor = row[i] * inverse[k];
            for (int64_t j = i; j < n; j++) a[i * n + j] = less(a[i * n + j], factor, row[j]);
        }
    }
    return bits(weak);
}

/* Solve all lanes in place of x. */
void NAMED(pydy_ldl_solve_, LANES)(
    const double *matrix, const double *reciprocals, double *solution, int64_t n)
{
    const Lanes *a = (const Lanes *)matrix, *inverse = (const Lanes *)reciprocals;
    Lanes *x = (Lanes *)solution;
    for (int64_t k = 0; k < n; k++) {
        const Lanes value = x[k] * inverse[k];
        for (int64_t i = k + 1; i < n; i++) x[i] = less(x[i], a[k * n + i], value);
        x[k] = value;
    }
    for (int64_t k = n - 1; k >= 0; k--) {
        Lanes total = (Lanes)0.0;
        for (int64_t i = k + 1; i < n; i++) total = less(total, a[k * n + i], x[i]);
        x[k] += total * inverse[k];
    }
}

/* Solve again, by LU, the lanes in `mask` of a symmetric system that LDL^T could not. lower: the
   lower triangle row by row; b: `count` right-hand sides, solved in place; room: n n + 3 n items, of
   which the LU uses all. Gives the mask of the singular lanes. */
int32_t NAMED(pydy_guard_, LANES)(
    const double *lower, double *b, int64_t count, double *room, int64_t n, int32_t mask)
{
    const Lanes *from = (const Lanes *)lower;
    Lanes *a = (Lanes *)room;
    for (int64_t i = 0; i < n; i++)
        for (int64_t j = 0; j <= i; j++) a[i * n + j] = a[j * n + i] = *from++;
    int64_t *pivots = (int64_t *)(a + n * n);
    double *scales = (double *)(a + n * n + n);
    const int32_t bad = NAMED(pydy_lu_, LANES)(room, pivots, scales, 0, n, mask);
    for (int64_t k = 0; k < count; k++)
        NAMED(pydy_lu_, LANES)(room, pivots, scales, b + AT(k * n), n, mask);
    return bad;
}
