/* Samples in lanes: W rows of arrays side by side. */

#ifndef LANES_H
#define LANES_H

#define W LANES
#include "equations.h"

typedef void Prepare(const double *p, double *c);

/* Copy a row of an array into a lane. */
INLINE void copy_in(const Numbers *values, int64_t row, double *buffer, int64_t lane)
{
    const double *from = values->at + row * values->columns;
    SERIAL
    for (int64_t i = 0; i < values->columns; i++)
        buffer[i * W + lane] = from[i];
}

/* Compute what kernels need of the constants of all lanes. */
INLINE void prepare(const LaneProblem *p)
{
    for (int64_t k = 0; k < p->prepared.size; k++)
        (*(Prepare *const *)p->prepared.at[2 * k])(p->p.at, (double *)p->prepared.at[2 * k + 1]);
}

#endif
