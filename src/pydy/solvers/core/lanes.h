/* Samples in lanes: W rows of arrays side by side. */

#ifndef LANES_H
#define LANES_H

#define W LANES
#include "equations.h"

typedef void Prepare(const double *p, double *c);
typedef int64_t ProjectLanes(
    const LaneRun *run, const double *t, double *x, const double *from, int64_t which);

/* Copy a row of an array into a lane. */
INLINE void copy_in(const Numbers *values, int64_t row, double *buffer, int64_t lane)
{
    const double *from = values->at + row * values->columns;
    SERIAL
    for (int64_t i = 0; i < values->columns; i++)
        buffer[i * W + lane] = from[i];
}

/* Copy a lane into a row of an array. */
INLINE void copy_out(const double *buffer, int64_t lane, const Numbers *values, int64_t row)
{
    double *to = values->at + row * values->columns;
    SERIAL
    for (int64_t i = 0; i < values->columns; i++)
        to[i] = buffer[i * W + lane];
}

/* What the projection notes, in all lanes. */
INLINE double *seen_by(const LaneRun *run)
{
    return run->constraints.values.at + run->constraints.values.size - W * run->queue.seen.columns;
}

/* Compute what kernels need of the constants of all lanes. */
INLINE void prepare(const LaneProblem *p)
{
    for (int64_t k = 0; k < p->prepared.size; k++)
        (*(Prepare *const *)p->prepared.at[2 * k])(p->p.at, (double *)p->prepared.at[2 * k + 1]);
}

#endif
