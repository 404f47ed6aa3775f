/* The right-hand side x' = f(t, x; r(t), c), with inputs that are sampled in time. */

#ifndef EQUATIONS_H
#define EQUATIONS_H

#include "real.h"

#if W > 1
typedef LaneProblem Equations;
#else
typedef Problem Equations;
#endif

typedef int32_t Kernel(const double *t, const double *x, const double *r, const double *c, double *out);

/* The word is where the kernel's address stands, which better code may replace at any time. */
INLINE int64_t call_kernel(int64_t place, const double *t, const double *x, const double *r,
    const double *c, double *out)
{
    return (*(Kernel *const *)place)(t, x, r, c, out);
}

/* Return the last of the ascending knots that is not after s; most often it is the guess. */
INLINE int64_t interval_of(const double *knots, int64_t number, double s, int64_t guess)
{
    if (knots[guess] <= s && (guess == number - 1 || s < knots[guess + 1]))
        return guess;
    int64_t low = 0, high = number;
    while (high - low > 1) {
        const int64_t middle = (low + high) / 2;
        if (knots[middle] <= s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Return input k at a time; *interval is where it may be, and then is. End values are held. */
INLINE double sampled(const Equations *e, int64_t k, double t, int64_t *interval)
{
    const int64_t *row = e->tables.at + k * e->tables.columns, first = row[1];
    const double *knots = e->knots.at + first;
    double s = knots[0] > t ? knots[0] : t;
    *interval = interval_of(knots, row[2], s, *interval);
    s -= knots[*interval];
    const double *a = e->cubics.at + 4 * (first + *interval);
    return a[0] + s * (a[1] + s * (a[2] + s * a[3]));
}

/* -- knots ---------------------------------------------------------------------------------------

   Between two knots inputs are polynomials. Whether a kink matters, the error of a step across it tells: a
   step that was rejected is tried again up to a knot, and so is the next one. */

/* Return the first knot of inputs after a time, or INF: one nearer than the shortest step has passed. */
APART double knot_after(const Equations *e, double t)
{
    const double now = t + INSTANT * ROUNDING * LIBRARY(fabs)(t);
    double first = INF;
    for (int64_t k = 0; k < e->tables.size; k++) {
        const int64_t *row = e->tables.at + k * e->tables.columns;
        const double *knots = e->knots.at + row[1];
        const int64_t next = knots[0] > now ? 0 : interval_of(knots, row[2], now, 0) + 1;
        if (next < row[2] && knots[next] < first)
            first = knots[next];
    }
    return first;
}

/* Tell whether a step from t has no knot within it: one as near to its end as a step may be stretched to
   reach a goal is at its end. */
INLINE int is_smooth(double first_knot, double t, double after)
{
    return !(first_knot < after - SLIVER * (after - t) - INSTANT * ROUNDING * LIBRARY(fabs)(after));
}

/* Return the size with which a step from t to `after` is tried again after an error that asks for a size
   `shorter`: up to the first knot, if that is the only one this size reaches, or is farther. Where knots
   are dense, none of them is the cause. */
INLINE double size_to_knot(const Equations *e, double t, double after, double shorter)
{
    if (e->tables.size == 0)
        return shorter;
    const double first = knot_after(e, t);
    if (is_smooth(first, t, after) || knot_after(e, first) <= t + shorter)
        return shorter;
    return first - t;
}

/* Return the size of the step after one from t to `after` that was tried again: `next`; or, where that one
   went up to the first knot, up to the following knot, or `longest`. */
INLINE double size_from_knot(const Equations *e, double t, double after, double next, double longest)
{
    if (e->tables.size == 0)
        return next;
    const double first = knot_after(e, t);
    if (!is_smooth(first, t, after) || first > after + INSTANT * ROUNDING * LIBRARY(fabs)(after))
        return next;
    const double size = knot_after(e, after) - after;
    return size < longest ? size : longest;
}

/* -- jumps, and values ---------------------------------------------------------------------------- */

/* Return how many jumps are not after t. */
INLINE int64_t jumps_by(const Equations *e, double t)
{
    int64_t low = 0, high = e->jumps.size;
    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (e->jumps.at[3 * middle] > t)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Let the inputs of a lane be those before the first of their jumps after t, to which a step from t
   goes at the farthest, until they are released; return the time of that jump. */
INLINE double hold_inputs(const Equations *e, double t, int64_t lane)
{
    if (e->jumps.size == 0)
        return INF;
    const int64_t next = jumps_by(e, t);
    const double *row = e->jumps.at + 3 * next;
    e->until.at[lane] = next < e->jumps.size ? row[1] : INF;
    return next < e->jumps.size ? row[0] : INF;
}

INLINE void release_inputs(const Equations *e)
{
    if (e->jumps.size > 0)
        put(e->until.at, 0, (Real)(INF));
}

/* Set the sampled inputs, those of each lane at its own time. */
APART void sample(const Equations *e)
{
    for (int64_t k = 0; k < e->tables.size; k++) {
        int64_t *row = e->tables.at + k * e->tables.columns;
        for (int lane = 0; lane < W; lane++) {
#if W > 1
            int64_t *interval = e->intervals.at + k * W + lane;
#else
            int64_t *interval = row + 3;
#endif
            const double t = e->clock.at[lane], until = e->until.at[lane];
            e->r.at[row[0] * W + lane] = sampled(e, k, t < until ? t : until, interval);
        }
    }
}

/* Move the kernel's time away from those at which rounding decides whether it has switched: to the side
   of a switch on which the step is. */
APART void settle(const Equations *e)
{
    for (int lane = 0; lane < W; lane++) {
        const double until = e->until.at[lane], now = e->clock.at[lane];
        const double t = now < until ? now : until;
        const int64_t next = jumps_by(e, t);
        const double *row = e->jumps.at + 3 * next;
        if (next > 0 && t < row[-1])
            e->clock.at[lane] = row[-1];
        else
            e->clock.at[lane] = next < e->jumps.size && t > row[1] ? row[1] : t;
    }
}

/* Set the kernel's time, and the sampled inputs of that time. */
INLINE void set_inputs(const Equations *e, Real t)
{
    put(e->clock.at, 0, t);
    if (e->words.at[SWITCHED])
        settle(e);
    if (e->tables.size > 0)
        sample(e);
}

/* Evaluate the derivative. Not zero: the kernel's complaint, the bits of the lanes it is about. */
INLINE int64_t rates(const Equations *e, Real t, const double *x, double *out)
{
    set_inputs(e, t);
    return call_kernel(e->words.at[KERNEL], e->clock.at, x, e->r.at, e->c.at, out);
}

#endif
