/* A sweep of LANES states at a time: how samples reach a kernel's lanes and results come back.

   A kernel takes a state as [item][lane]. An array whose columns are contiguous is passed as it
   lies, to the kernel's strided form; one whose rows are contiguous is turned, four columns at a
   time in registers:

       row 0 | a0 a1 a2 a3 ...          a0 b0 c0 d0 ... column 0
       row 1 | b0 b1 b2 b3 ...    ->    a1 b1 c1 d1 ... column 1
       row 2 | c0 c1 c2 c3 ...          a2 b2 c2 d2 ... column 2 */

#include "kernel.h"

#define INLINE static inline __attribute__((always_inline))
#define SERIAL _Pragma("clang loop vectorize(disable)") /* no gathers for a few numbers */
#define UNROLLED _Pragma("clang loop unroll(full)")
#define SQUARE (LANES < 4 ? LANES : 4)                  /* columns that are turned at a time */

typedef double Row __attribute__((ext_vector_type(SQUARE), aligned(8)));
typedef double Lanes __attribute__((ext_vector_type(LANES), aligned(8)));

INLINE int64_t least(int64_t a, int64_t b) { return a < b ? a : b; }

/* Turn a square of numbers in place. */
INLINE void turn(Row *v)
{
#if LANES == 2
    const Row a = v[0], b = v[1];
    v[0] = __builtin_shufflevector(a, b, 0, 2);
    v[1] = __builtin_shufflevector(a, b, 1, 3);
#else
    const Row a = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6);
    const Row b = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7);
    const Row c = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6);
    const Row d = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
    v[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    v[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    v[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    v[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
#endif
}

/* All lanes as rows of a square each, and back. What is written as a vector is read as one: the
   processor waits where parts of it are written. */
INLINE Lanes joined(const Row *v, int k)
{
#if LANES == 8
    return __builtin_shufflevector(v[k], v[k + 4], 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return v[k];
#endif
}

INLINE void split(Lanes all, Row *v, int k)
{
#if LANES == 8
    v[k + 4] = __builtin_shufflevector(all, all, 4, 5, 6, 7);
    v[k] = __builtin_shufflevector(all, all, 0, 1, 2, 3);
#else
    v[k] = all;
#endif
}

/* Turn rows of `items` numbers into [item][lane]. */
INLINE void rows_in(const double *rows, int64_t items, double *buffer)
{
    Row v[LANES];
    int64_t j = 0;
    /* The last square overlaps the one before. */
    for (; items >= SQUARE && j < items; j += SQUARE) {
        j = least(j, items - SQUARE);
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) v[lane] = *(const Row *)(rows + lane * items + j);
        UNROLLED
        for (int lane = 0; lane < LANES; lane += SQUARE) turn(v + lane);
        UNROLLED
        for (int k = 0; k < SQUARE; k++) *(Lanes *)(buffer + (j + k) * LANES) = joined(v, k);
    }
    for (; j < items; j++) {
        Lanes all;
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) all[lane] = rows[lane * items + j];
        *(Lanes *)(buffer + j * LANES) = all;
    }
}

/* The way back. */
INLINE void rows_out(const double *buffer, int64_t items, double *rows)
{
    Row v[LANES];
    int64_t j = 0;
    /* The last square overlaps the one before. */
    for (; items >= SQUARE && j < items; j += SQUARE) {
        j = least(j, items - SQUARE);
        UNROLLED
        for (int k = 0; k < SQUARE; k++) split(*(const Lanes *)(buffer + (j + k) * LANES), v, k);
        UNROLLED
        for (int lane = 0; lane < LANES; lane += SQUARE) turn(v + lane);
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) *(Row *)(rows + lane * items + j) = v[lane];
    }
    for (; j < items; j++) {
        const Lanes all = *(const Lanes *)(buffer + j * LANES);
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) rows[lane * items + j] = all[lane];
    }
}

/* Write each number into all lanes. */
INLINE void into_all(const double *numbers, int64_t count, double *buffer)
{
    for (int64_t j = 0; j < count; j++)
        for (int lane = 0; lane < LANES; lane++) buffer[j * LANES + lane] = numbers[j];
}

INLINE void report(int64_t status, uint8_t *failed, int64_t count)
{
    if (status)
        for (int64_t lane = 0; lane < count; lane++) failed[lane] = status >> lane & 1;
}

void SWEEP(
    const Words *w, const double *t, const double *x, const double *r, const double *p,
    double *out, uint8_t *failed, double *scratch)
{
    const int64_t m = w->m, last = m - LANES, alone = w->r_step == 0, by_columns = w->by_columns;
    /* Vectors that are written and read again must not lie across two lines of the cache. */
    double *all = (double *)(((uintptr_t)scratch + 63) & ~(uintptr_t)63);
    double *c = all + w->k * LANES, *ts = c + w->carried * LANES, *xs = ts + LANES;
    double *rs = xs + w->n * LANES, *outs = rs + w->s * LANES;
    if (m <= 0) return;
    into_all(p, w->k, all);
    w->prepare(all, c);
    if (alone) into_all(r, w->s, rs);
    if (m < LANES) {
        /* Filled up with copies of the last sample, which every lane can evaluate. */
        for (int64_t lane = 0; lane < LANES; lane++) {
            const int64_t i = least(lane, m - 1), step = by_columns ? m : 1;
            ts[lane] = t[i];
            SERIAL
            for (int64_t j = 0; j < w->n; j++)
                xs[j * LANES + lane] = x[i * (by_columns ? 1 : w->n) + j * step];
            SERIAL
            for (int64_t j = 0; !alone && j < w->s; j++)
                rs[j * LANES + lane] = r[i * (by_columns ? 1 : w->s) + j * step];
        }
        report(w->kernel(ts, xs, rs, c, outs), failed, m);
        for (int64_t i = 0; i < m; i++)
            SERIAL
            for (int64_t j = 0; j < w->outputs; j++)
                out[by_columns ? i + j * m : i * w->outputs + j] = outs[j * LANES + i];
    } else if (by_columns) {
        /* Columns that NumPy made begin alike: the states' second block, and with it most vectors,
           begins where a line of the cache does. What is left of the last block overlaps the one
           before; the first one that fails ends a turn. */
        const int64_t gone = (uintptr_t)x >> 3 & (LANES - 1);
        int64_t steps[5] = {m, alone ? LANES : m, m, 1, alone ? 0 : LANES};
        for (int64_t begin = 0; begin < m;) {
            const int64_t start = least(begin, last);
            if (begin) steps[3] = (m - start) / LANES;
            const double *specifieds = alone ? rs : r + start;
            const int64_t both = w->strided(t + start, x + start, specifieds, c, out + start, steps);
            const int64_t end = start + (both >> 32) * LANES;
            report((int32_t)both, failed + end - LANES, LANES);
            begin = begin == 0 && last > 0 ? LANES - gone : end;
        }
    } else {
        for (int64_t begin = 0; begin < m; begin += LANES) {
            const int64_t start = least(begin, last);
            *(Lanes *)ts = *(const Lanes *)(t + start);
            rows_in(x + start * w->n, w->n, xs);
            if (!alone) rows_in(r + start * w->s, w->s, rs);
            report(w->kernel(ts, xs, rs, c, outs), failed + start, LANES);
            rows_out(outs, w->outputs, out + start * w->outputs);
        }
    }
}
