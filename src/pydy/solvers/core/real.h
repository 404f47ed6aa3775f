/* Numbers of W trajectories side by side: `Real` is a double where W is 1, else a vector of W.

   What is written with them serves one trajectory and many, with the same bits: every operation
   goes place by place, in an order that depends on no neighbour. To be compiled with
   -ffp-contract=off: products are fused with sums by name only, as that depends on the processor
   elsewhere.

   Where BLOCK is 1, as in FMUs, any compiler of C99 takes it. */

#ifndef REAL_H
#define REAL_H

#include "layout.h"

#ifndef W
#define W 1
#endif
#if W != 1 && W != BLOCK
#error "each lane has its own place in a block"
#endif

/* What is rarely called, or long, is compiled APART, once. Vectors are none of its arguments: how
   those are passed depends on the processor. */
#ifdef __GNUC__
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define LIBRARY(name) __builtin_##name
#define INF __builtin_inf()
#else
#include <math.h>
#include <string.h>
#define INLINE static inline
#define APART static
#define LIBRARY(name) name
#define INF INFINITY
#endif
#ifdef __clang__
#define UNROLLED _Pragma("clang loop unroll(full)")
#define SERIAL _Pragma("clang loop vectorize(disable)") /* no scatters for a few numbers */
#else
#define UNROLLED
#define SERIAL
#endif

/* a b + c, rounded once on every processor; in FMUs, where it would be slow, twice. */
#if BLOCK > 1 || defined __FP_FAST_FMA
#define fused_one(a, b, c) LIBRARY(fma)(a, b, c)
#else
#define fused_one(a, b, c) ((a) * (b) + (c))
#endif

/* BLOCK numbers, which sums over stages are taken of at a time, whatever W is. */
#if BLOCK > 1
typedef double Block __attribute__((ext_vector_type(BLOCK)));
typedef int64_t Longs __attribute__((ext_vector_type(BLOCK)));
typedef int32_t Ints __attribute__((ext_vector_type(BLOCK)));
typedef _Bool Bits __attribute__((ext_vector_type(BLOCK)));
typedef Block Loose __attribute__((aligned(8)));
#define fused_blocks(a, b, c) __builtin_elementwise_fma(a, b, c)
#else
typedef double Block, Loose;
#define fused_blocks fused_one
#endif

INLINE Block load_block(const double *p) { return *(const Loose *)p; }
INLINE void store_block(double *p, Block v) { *(Loose *)p = v; }
INLINE Block larger(Block a, Block b) { return a > b ? a : b; }
INLINE Block sizes(Block a) { return larger(a, -a); }

#if W > 1
typedef Block Real;
typedef Longs Flags, Word;
#define fused fused_blocks
#define absolute(x) __builtin_elementwise_abs(x)
#define root(x) __builtin_elementwise_sqrt(x)
#define ceiling(x) __builtin_elementwise_ceil(x)
#define nearest(x) __builtin_elementwise_rint(x)
#define narrow(k) __builtin_convertvector(k, Ints)
#define widen(k) __builtin_convertvector(k, Longs)
#define from_int(k) __builtin_convertvector(k, Block)
#define to_int(x) __builtin_convertvector(x, Ints)

INLINE Word as_word(Real x) { return (Word)x; }
INLINE Real as_real(Word k) { return (Real)k; }

/* Conditions as an integer, bit k for lane k, and back. */
INLINE int64_t bits(Flags f)
{
    const Bits b = __builtin_convertvector(f, Bits);
    uint8_t byte;
    __builtin_memcpy(&byte, &b, 1);
    return byte & ((1 << W) - 1);
}

INLINE Flags flags(int64_t which)
{
    const uint8_t byte = (uint8_t)which;
    Bits b;
    __builtin_memcpy(&b, &byte, 1);
    return __builtin_convertvector(b, Longs) != 0;
}
#else
typedef double Real;
typedef int Flags;
typedef int64_t Word;
#define fused fused_one
#define absolute(x) LIBRARY(fabs)(x)
#define root(x) LIBRARY(sqrt)(x)
#define ceiling(x) LIBRARY(ceil)(x)
#define nearest(x) LIBRARY(rint)(x)
#define narrow(k) ((int32_t)(k))
#define widen(k) ((int64_t)(k))
#define from_int(k) ((double)(k))
#define to_int(x) ((int32_t)(x))

INLINE Word as_word(Real x) { Word k; LIBRARY(memcpy)(&k, &x, 8); return k; }
INLINE Real as_real(Word k) { Real x; LIBRARY(memcpy)(&x, &k, 8); return x; }
INLINE int64_t bits(Flags f) { return f; }
INLINE Flags flags(int64_t which) { return (int)which; }
#endif

#define EVERY (((int64_t)1 << W) - 1) /* the bits of all lanes */

/* Item i of a vector: W numbers. */
INLINE Real item(const double *p, int64_t i)
{
#if W > 1
    return load_block(p + W * i);
#else
    return p[i];
#endif
}

INLINE void put(double *p, int64_t i, Real v)
{
#if W > 1
    store_block(p + W * i, v);
#else
    p[i] = v;
#endif
}

INLINE Real where(Flags f, Real x, Real y) { return f ? x : y; }
INLINE Real maximum(Real x, Real y) { return where(x > y, x, y); } /* y where either is NaN */
INLINE Real minimum(Real x, Real y) { return where(x < y, x, y); }
INLINE int is_finite(double x) { return LIBRARY(fabs)(x) < INF; }

/* 2 / (k ln 2), of artanh in z^2, and (ln 2)^k / k! */
#define LN2 0x1.62e42fefa39efp-1
#define ARTANH(k) ((Real)(2.0 / LN2 / (k)))
#define EXPONENT_UP ((int64_t)1 << 52) /* by which to multiply: negative numbers are not shifted */

/* x to a power, to eight digits, for positive and normal x: a step size needs no more, and the
   library's function takes longer than a whole step. With x = 2^k m, sqrt(1/2) <= m < sqrt(2), and
   z = (m - 1) / (m + 1), log2 x = k + 2 artanh(z) / ln 2. */
INLINE Real power(Real x, double exponent)
{
    const Word as_bits = as_word(x);
    const Word k = (as_bits - 0x3FE6A09E667F3BCD) >> 52; /* less the bits of sqrt(1/2) */
    const Real m = as_real(as_bits - k * EXPONENT_UP), z = (m - 1.0) / (m + 1.0), zz = z * z;
    Real sum = ARTANH(9.0);
    sum = fused(sum, zz, ARTANH(7.0));
    sum = fused(sum, zz, ARTANH(5.0));
    sum = fused(sum, zz, ARTANH(3.0));
    sum = fused(sum, zz, ARTANH(1.0));
    Real y = (from_int(narrow(k)) + sum * z) * exponent;
    y = minimum(maximum(y, (Real)(-1000.0)), (Real)(1000.0));
    const Real whole = nearest(y), rest = y - whole;
    Real fraction = (Real)(0x1.ffcbfc588b0c5p-17);
    fraction = fused(fraction, rest, (Real)(0x1.430912f86c786p-13));
    fraction = fused(fraction, rest, (Real)(0x1.5d87fe78a6730p-10));
    fraction = fused(fraction, rest, (Real)(0x1.3b2ab6fba4e77p-7));
    fraction = fused(fraction, rest, (Real)(0x1.c6b08d704a0bfp-5));
    fraction = fused(fraction, rest, (Real)(0x1.ebfbdff82c58ep-3));
    fraction = fused(fraction, rest, (Real)(LN2));
    fraction = fused(fraction, rest, (Real)(1.0));
    return as_real(as_word(fraction) + widen(to_int(whole)) * EXPONENT_UP);
}

#endif
