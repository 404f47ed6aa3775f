/* Kernels, as sweeps and gates call them, and what says which one. */

#ifndef KERNEL_H
#define KERNEL_H

#include <stdint.h>

typedef int32_t Kernel(
    const double *t, const double *x, const double *r, const double *c, double *out);
typedef void Prepare(const double *p, double *c);
/* For items at any distance: of x, r and out, how many blocks of lanes follow each other, and from
   one block of r to the next. Gives how many blocks are done, and the status of the last one. */
typedef int64_t Strided(
    const double *t, const double *x, const double *r, const double *c, double *out,
    const int64_t *steps);

/* How many numbers lie between two samples of an array, and between two items of a sample. */
typedef struct { int64_t sample, item; } Distances;

/* What a sweep reads: the kernel it is for, as Python keeps it, then the arrays of one call. Of
   each array the items or the samples follow one another; `r.sample` is 0 where one row of
   specifieds serves all samples. At most `blocks` of LANES samples are copied together; columns of
   up to `in_place` samples never are. A sweep gives 1 if it has seen that all results are
   finite, else 0. */
typedef struct Words Words;
typedef int64_t Sweep(
    const Words *w, const double *t, const double *x, const double *r, const double *p,
    double *out, uint8_t *failed, double *scratch);
struct Words {
    Kernel *kernel;
    Prepare *prepare;
    Strided *strided;
    Sweep *sweep;
    int64_t n, s, k, carried, outputs, blocks, in_place;
    int64_t m;
    Distances x, r, out;
};

#endif
