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

/* What a sweep reads: the kernel it is for, as Python keeps it, then the arrays of one call.
   `r_step` is 0 where one row of specifieds serves all samples; `by_columns` says how x, r and out
   lie. */
typedef struct Words Words;
typedef void Sweep(
    const Words *w, const double *t, const double *x, const double *r, const double *p,
    double *out, uint8_t *failed, double *scratch);
struct Words {
    Kernel *kernel;
    Prepare *prepare;
    Strided *strided;
    Sweep *sweep;
    int64_t n, s, k, carried, outputs;
    int64_t m, r_step, by_columns;
};

#endif
