/* Step-size control: the error norm, the first step and the size of the next one.

   E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd edition,
   section II.4; K. Gustafsson's PI controller as in II, section IV.2. */

#ifndef CONTROL_H
#define CONTROL_H

#include "real.h"

/* -- the norm --------------------------------------------------------------------------------- */

/* Return the tolerance of component i, whose value goes from x to y. */
INLINE Real unit(const Memory *m, int64_t i, Real x, Real y)
{
    return m->atol.at[i] + m->rtol.at[i] * maximum(absolute(x), absolute(y));
}

APART void norm_to(double *result, const double *a, const double *other, const Memory *m, int64_t n)
{
    Real total = (Real)(0.0);
    for (int64_t i = 0; i < n; i++) {
        const Real e = item(a, i) / unit(m, i, item(m->x.at, i), item(other, i));
        total = total + e * e;
    }
    put(result, 0, root(total / (double)n));
}

/* Return the root mean square of `a` in units of the tolerance; x goes to `other`. */
INLINE Real norm(const double *a, const double *other, const Memory *m, int64_t n)
{
    double result[W];
    norm_to(result, a, other, m, n);
    return item(result, 0);
}

/* -- the first step --------------------------------------------------------------------------- */

/* Return a cautious first step, a small part of the time in which x changes by itself; *slope is
   the norm of the derivative, which the first of the stages is. */
INLINE Real first_trial(const Memory *m, int64_t n, double largest, Real *slope)
{
    const Real d0 = norm(m->x.at, m->x.at, m, n), d1 = norm(m->stages.at, m->x.at, m, n);
    const Flags little = (d0 < NEGLIGIBLE) | (d1 < NEGLIGIBLE);
    *slope = d1;
    return minimum((Real)(largest), where(little, (Real)(TRIAL_SIZE), TRIAL_PART * d0 / d1));
}

/* Return a first step that neither vanishes beside t nor is too large; NaN stays NaN. */
INLINE Real bounded_first_size(Real size, Real t, double largest)
{
    return minimum((Real)(largest), maximum(SHORTEST * absolute(t), size));
}

/* Return the first step from a trial step, after which the derivative is the second of the stages.
   That one is overwritten. */
INLINE Real first_size(const Memory *m, double exponent, int64_t n, Real t, double largest,
    Real trial, Real slope)
{
    double *f0 = m->stages.at, *f1 = f0 + m->x.size;
    for (int64_t i = 0; i < n; i++)
        put(f1, i, item(f1, i) - item(f0, i));
    const Real steepest = maximum(slope, norm(f1, m->x.at, m, n) / trial);
    const Real sloping = power(TRIAL_PART / maximum(steepest, (Real)(NEGLIGIBLE_SLOPE)), exponent);
    const Real flat = maximum((Real)(TRIAL_SIZE), trial * SLIVER);
    const Real size = minimum(100.0 * trial, where(steepest > NEGLIGIBLE_SLOPE, sloping, flat));
    return bounded_first_size(size, t, largest);
}

/* Tell whether a first step is a positive number. */
INLINE Flags usable(Real size) { return (size > 0.0) & (size < INF); }

/* -- one step's size -------------------------------------------------------------------------- */

/* Set a step's end; it reaches the goal rather than leaving a sliver. */
INLINE void limit_step(Real t, Real goal, Real *size, Real *after)
{
    const Real end = t + *size;
    const Flags near = end > goal - SLIVER * *size;
    *after = where(near, goal, end);
    *size = *after - t; /* what the rounded times are apart: far from zero a clock would drift */
}

/* Return the largest step up to a size that a whole number of times reaches the goal. */
INLINE Real whole_steps(Real t, Real size, Real goal)
{
    return (goal - t) / ceiling((goal - t) / size * WHOLE);
}

/* Tell whether a step is long enough to tell its stages' times apart, or the last. */
INLINE Flags moves(Real t, Real size, Real after, Real goal)
{
    return (t + RESOLVED * size > t) | (after == goal);
}

/* Return the size of the step after one of some error, which was accepted. */
INLINE Real next_size(const double *control, Real size, Real error, Real last_error, Real growth)
{
    const Real least = maximum(error, (Real)(LEAST_ERROR));
    Real factor = control[SAFETY] * power(least, -control[ALPHA]);
    if (control[BETA] != 0.0)
        factor = factor * power(last_error, control[BETA]);
    return size * minimum(growth, maximum(factor, (Real)(control[SHRINK])));
}

/* Return the size with which a rejected step is tried again; its error may not be measured. */
INLINE Real shorter_size(const double *control, Real size, Real error, Flags measured)
{
    const Real least = maximum(error, (Real)(LEAST_ERROR));
    const Real factor = control[SAFETY] * power(least, -control[EXPONENT]);
    const Real shorter = maximum(factor, (Real)(control[SHRINK]));
    return size * where(measured, shorter, (Real)(AFTER_FAILURE));
}

#endif
