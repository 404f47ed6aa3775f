/* Sums over stages, and the polynomial between two steps, in blocks. */

#ifndef SUMS_H
#define SUMS_H

#include "real.h"

enum { TOGETHER = 4 }; /* sums that grow side by side hide each other's latency */

INLINE void add_term(Block *total, int number, Block weight, const double *stage)
{
    UNROLLED
    for (int k = 0; k < number; k++)
        total[k] = fused_blocks(weight, load_block(stage + BLOCK * k), total[k]);
}

INLINE void combine_some(double *y, const double *x, Block step, const double *stages,
    const int64_t *offsets, const double *weights, int64_t count, int64_t further, int number)
{
    Block total[TOGETHER];
    UNROLLED
    for (int k = 0; k < number; k++)
        total[k] = (Block)(0.0);
    int64_t j = 0;
    for (; j < count; j++)
        add_term(total, number, (Block)(weights[j]), stages + offsets[j]);
    UNROLLED
    for (int k = 0; k < number; k++)
        total[k] = fused_blocks(step, total[k], load_block(x + BLOCK * k));
    for (; j < count + further; j++)
        add_term(total, number, step * weights[j], stages + offsets[j]);
    UNROLLED
    for (int k = 0; k < number; k++)
        store_block(y + BLOCK * k, total[k]);
}

/* Compute y = x + h (sum of `count` terms, each a weight times the stage at its offset); `further`
   terms, each times h, are added to y afterwards. h is one block. */
APART void combine(double *y, const double *x, const double *h, const double *stages,
    const int64_t *offsets, const double *weights, int64_t count, int64_t further, int64_t blocks)
{
    const Block step = load_block(h);
    int64_t at = 0;
    for (; at + TOGETHER * BLOCK <= blocks * BLOCK; at += TOGETHER * BLOCK)
        combine_some(y + at, x + at, step, stages + at, offsets, weights, count, further, TOGETHER);
    for (; at < blocks * BLOCK; at += BLOCK)
        combine_some(y + at, x + at, step, stages + at, offsets, weights, count, further, 1);
}

/* Compute y = x + theta (F0 + (1 - theta)(F1 + theta (F2 + ...))); the `depth` vectors F lie
   `length` numbers apart, and theta is one block. */
APART void nested(double *y, const double *x, const double *parts, int64_t length, int64_t depth,
    const double *theta, int64_t blocks)
{
    const Block near = load_block(theta), far = (Block)(1.0) - near;
    for (int64_t at = 0; at < blocks * BLOCK; at += BLOCK) {
        const double *part = parts + at + (depth - 1) * length;
        Block total = load_block(part);
        for (int64_t level = depth - 2; level >= 0; level--) {
            part -= length;
            total = fused_blocks(level & 1 ? near : far, total, load_block(part));
        }
        store_block(y + at, fused_blocks(near, total, load_block(x + at)));
    }
}

#endif
