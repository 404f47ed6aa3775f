/* A sweep of LANES states at a time: how samples reach a kernel's lanes and results come back.

   A kernel takes a state as [item][lane]. Tiles of an array, which stay in the cache, are copied so.
   One whose rows are contiguous is turned, four columns at a time in registers:

       row 0 | a0 a1 a2 a3 ...          a0 b0 c0 d0 ... column 0
       row 1 | b0 b1 b2 b3 ...    ->    a1 b1 c1 d1 ... column 1
       row 2 | c0 c1 c2 c3 ...          a2 b2 c2 d2 ... column 2

   Columns that do not drive one another out of the cache are passed as they lie, to the kernel's
   strided form. */

#include "kernel.h"

#define INLINE static inline __attribute__((always_inline))
#define SERIAL _Pragma("clang loop vectorize(disable)") /* no gathers for a few numbers */
#define UNROLLED _Pragma("clang loop unroll(full)")
#define SQUARE (LANES < 4 ? LANES : 4)                  /* columns that are turned at a time */

typedef double Row __attribute__((ext_vector_type(SQUARE), aligned(8)));
typedef double Lanes __attribute__((ext_vector_type(LANES), aligned(8)));
typedef int64_t Bits __attribute__((ext_vector_type(LANES), aligned(8)));

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

/* Turn rows of `items` numbers into [item][lane]; `next` is the distance of two rows. */
INLINE void rows_in(const double *rows, int64_t next, int64_t items, double *buffer)
{
    Row v[LANES];
    int64_t j = 0;
    /* The last square overlaps the one before. */
    for (; items >= SQUARE && j < items; j += SQUARE) {
        j = least(j, items - SQUARE);
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) v[lane] = *(const Row *)(rows + lane * next + j);
        UNROLLED
        for (int lane = 0; lane < LANES; lane += SQUARE) turn(v + lane);
        UNROLLED
        for (int k = 0; k < SQUARE; k++) *(Lanes *)(buffer + (j + k) * LANES) = joined(v, k);
    }
    for (; j < items; j++) {
        Lanes all;
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) all[lane] = rows[lane * next + j];
        *(Lanes *)(buffer + j * LANES) = all;
    }
}

/* The way back. */
INLINE void rows_out(const double *buffer, int64_t next, int64_t items, double *rows)
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
        for (int lane = 0; lane < LANES; lane++) *(Row *)(rows + lane * next + j) = v[lane];
    }
    for (; j < items; j++) {
        const Lanes all = *(const Lanes *)(buffer + j * LANES);
        UNROLLED
        for (int lane = 0; lane < LANES; lane++) rows[lane * next + j] = all[lane];
    }
}

/* Fetch the rows of the next block, to read or to write, while one is computed. Long ones would
   drive it out of the nearest cache. */
#define FETCH(rows, next, items, writes)                                                           \
    for (int64_t lane = 0; (items) <= 256 && lane < LANES; lane++)                                 \
        for (int64_t j = 0; j < (items); j += 8)                                                   \
            __builtin_prefetch((rows) + lane * (next) + j, writes)

/* Copy a tile, some blocks of samples by all items, into [block][item][lane]. Several blocks of a
   column lie together in memory, while columns may be so far apart that they share cache lines. */
INLINE void tile_in(
    const double *from, Distances d, int64_t items, int64_t blocks, double *buffer)
{
    if (d.item == 1)
        for (int64_t k = 0; k < blocks; k++)
            rows_in(from + k * LANES * d.sample, d.sample, items, buffer + k * items * LANES);
    else
        for (int64_t j = 0; j < items; j++)
            for (int64_t k = 0; k < blocks; k++)
                *(Lanes *)(buffer + (k * items + j) * LANES) =
                    *(const Lanes *)(from + j * d.item + k * LANES);
}

/* Copy results of the columns of a tile. */
INLINE void columns_out(
    const double *buffer, int64_t next, int64_t items, int64_t blocks, double *out)
{
    for (int64_t j = 0; j < items; j++)
        for (int64_t k = 0; k < blocks; k++)
            *(Lanes *)(out + j * next + k * LANES) =
                *(const Lanes *)(buffer + (k * items + j) * LANES);
}

/* Write each number into all lanes. */
INLINE void into_all(const double *numbers, int64_t next, int64_t count, double *buffer)
{
    for (int64_t j = 0; j < count; j++)
        for (int lane = 0; lane < LANES; lane++) buffer[j * LANES + lane] = numbers[j * next];
}

/* Combine the bits of v - v for each of [item][lane]: zero while all of them are finite. */
INLINE Bits not_finite(const double *numbers, int64_t items, Bits bits)
{
    for (int64_t j = 0; j < items; j++) {
        const Lanes v = *(const Lanes *)(numbers + j * LANES);
        bits |= (Bits)(v - v);
    }
    return bits;
}

INLINE int64_t none(Bits bits)
{
    int64_t zero = 1;
    UNROLLED
    for (int lane = 0; lane < LANES; lane++) zero &= bits[lane] == 0;
    return zero;
}

INLINE void report(int64_t status, uint8_t *failed, int64_t count)
{
    if (status)
        for (int64_t lane = 0; lane < count; lane++) failed[lane] = status >> lane & 1;
}

/* Whether columns at a distance fall into few lines of the cache, so that one drives out another:
   processors look for an address in the lines that its last 12 bits select, 8 or more of each. */
INLINE int crowded(int64_t next, int64_t columns)
{
    const int64_t bytes = 8 * next, power = bytes & -bytes;
    const int64_t lines = 4096 / (power < 64 ? 64 : least(power, 4096));
    return columns > 4 * lines;
}

/* Evaluate columns in place, and give whether all results are finite. Columns that NumPy made begin
   alike: the states' second block, and with it most vectors, begins where a line of the cache
   does. What is left of the last block overlaps the one before; the first one that fails ends a
   turn. */
INLINE int64_t in_place(
    const Words *w, const double *t, const double *x, const double *r, const double *c,
    double *out, uint8_t *failed)
{
    const int64_t m = w->m, last = m - LANES, gone = (uintptr_t)x >> 3 & (LANES - 1);
    const int64_t r_block = w->r.sample ? LANES : 0;
    int64_t steps[5] = {w->x.item, w->r.sample ? w->r.item : LANES, w->out.item, 1, r_block};
    Bits bits = {0};
    for (int64_t begin = 0; begin < m;) {
        const int64_t start = least(begin, last);
        if (begin) steps[3] = (m - start) / LANES;
        const double *specifieds = w->r.sample ? r + start : r;
        const int64_t both = w->strided(t + start, x + start, specifieds, c, out + start, steps);
        const int64_t end = start + (both >> 32) * LANES;
        report((int32_t)both, failed + end - LANES, LANES);
        for (int64_t j = 0; j < w->outputs; j++)
            bits = not_finite(out + j * w->out.item + start, both >> 32, bits);
        begin = begin == 0 && last > 0 ? LANES - gone : end;
    }
    return none(bits);
}

int64_t SWEEP(
    const Words *w, const double *t, const double *x, const double *r, const double *p,
    double *out, uint8_t *failed, double *scratch)
{
    const int64_t m = w->m, n = w->n, s = w->s, outputs = w->outputs;
    const int64_t alone = !w->r.sample || !s, out_rows = w->out.item == 1;
    /* Vectors that are written and read again must not lie across two lines of the cache. */
    double *all = (double *)(((uintptr_t)scratch + 63) & ~(uintptr_t)63);
    double *c = all + w->k * LANES, *ts = c + w->carried * LANES, *xs = ts + LANES;
    double *rs = xs + w->blocks * n * LANES, *outs = rs + w->blocks * s * LANES;
    if (m <= 0) return 1;
    into_all(p, 1, w->k, all);
    w->prepare(all, c);
    if (alone) into_all(r, w->r.item, s, rs);
    if (m < LANES) {
        /* Filled up with copies of the last sample, which every lane can evaluate. */
        for (int64_t lane = 0; lane < LANES; lane++) {
            const int64_t i = least(lane, m - 1);
            ts[lane] = t[i];
            SERIAL
            for (int64_t j = 0; j < n; j++)
                xs[j * LANES + lane] = x[i * w->x.sample + j * w->x.item];
            SERIAL
            for (int64_t j = 0; !alone && j < s; j++)
                rs[j * LANES + lane] = r[i * w->r.sample + j * w->r.item];
        }
        report(w->kernel(ts, xs, rs, c, outs), failed, m);
        for (int64_t i = 0; i < m; i++)
            SERIAL
            for (int64_t j = 0; j < outputs; j++)
                out[i * w->out.sample + j * w->out.item] = outs[j * LANES + i];
        return 0;
    }
    /* An array of one column is rows as well. */
    const int64_t columns = w->x.sample == 1 && w->out.sample == 1 && (alone || w->r.sample == 1);
    const int64_t near = m <= w->in_place || !crowded(w->x.item, n + s + outputs);
    if (w->strided && columns && near)
        return in_place(w, t, x, alone ? rs : r, c, out, failed);
    const int64_t rows = w->x.item == 1 && out_rows && (alone || w->r.item == 1);
    const int64_t most = rows ? 1 : w->blocks;
    Bits bits = {0};
    for (int64_t begin = 0, blocks; begin < m; begin += blocks * LANES) {
        blocks = least(most, (m - begin) / LANES);
        if (!blocks) { /* What is left overlaps the block before. */
            begin = m - LANES;
            blocks = 1;
        }
        tile_in(x + begin * w->x.sample, w->x, n, blocks, xs);
        if (!alone) tile_in(r + begin * w->r.sample, w->r, s, blocks, rs);
        for (int64_t k = 0; k < blocks; k++) {
            const int64_t start = begin + k * LANES;
            const double *specifieds = alone ? rs : rs + k * s * LANES;
            double *results = out_rows ? outs : outs + k * outputs * LANES;
            if (out_rows && start + 2 * LANES <= m) {
                const int64_t next = start + LANES;
                if (w->x.item == 1) FETCH(x + next * w->x.sample, w->x.sample, n, 0);
                FETCH(out + next * w->out.sample, w->out.sample, outputs, 1);
            }
            report(w->kernel(t + start, xs + k * n * LANES, specifieds, c, results),
                   failed + start, LANES);
            bits = not_finite(results, outputs, bits);
            if (out_rows) rows_out(outs, w->out.sample, outputs, out + start * w->out.sample);
        }
        if (!out_rows) columns_out(outs, w->out.item, outputs, blocks, out + begin);
    }
    return none(bits);
}
