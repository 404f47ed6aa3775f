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

/* Return the sizes of the steps of lanes after those from t to `after`, where inputs have knots: of lanes
   whose step was `refused`, and of lanes that were trying `again`; else `next`. */
INLINE Real sizes_at_knots(const LaneProblem *p, Real t, Real after, int64_t refused, int64_t again, Real next,
    Real longest)
{
    double sizes[W];
    put(sizes, 0, next);
    SERIAL
    for (int64_t lane = 0; lane < W; lane++)
        if (refused >> lane & 1)
            sizes[lane] = size_to_knot(p, t[lane], after[lane], next[lane]);
        else if (again >> lane & 1)
            sizes[lane] = size_from_knot(p, t[lane], after[lane], next[lane], longest[lane]);
    return item(sizes, 0);
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
