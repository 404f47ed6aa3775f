/* One step of an explicit Runge-Kutta method, its error and its interpolant, for W trajectories. */

#ifndef STEP_H
#define STEP_H

#include "control.h"
#include "equations.h"
#include "sums.h"

#define SOME(which, value) where(which, (Real)(value), (Real)(0.0))

/* Fractions of a step at which events are evaluated. */
static const double scan_points[] = SCAN_POINTS;

/* The rows of watch.values: the end of a part that a dip divides, a located event, and the ends of the
   parts of the step, from its start on, and their middles. Behind them is the time at which the start is
   known. */
enum { DIVIDED, LOCATED, ENDS, MIDDLES = ENDS + PARTS + 1 };

/* Parts that are compiled apart, and called by their addresses. */
typedef int64_t Project(const Run *run, double t, double *x, const double *from);
typedef int64_t Scan(const Run *run, double t, double h);
typedef int64_t Act(const Run *run);

typedef struct {
    const Method *method;
    const Equations *equations;
    const Memory *memory;
} Stepper;

INLINE void combine_row(const Stepper *s, int64_t row, int64_t blocks, double *y, const double *x,
    int64_t latest)
{
    const Method *m = s->method;
    const int64_t first = m->rows.at[row], count = m->rows.at[row + 1] - first - 1;
    combine(y, x, s->memory->step.at, s->memory->stages.at, m->offsets.at + first,
        m->weights.at + first, count, latest, blocks);
}

/* Compute y = x + h (a row of the tableau, times the stages). With one trajectory's short vectors
   the latest stage comes last and number by number: a kernel has just written it so, and what is
   written in parts can be read as a whole only much later. */
INLINE void combine_latest(const Stepper *s, int64_t row, double *y, Real h)
{
    const double *x = s->memory->x.at;
    const int64_t blocks = s->equations->words.at[BLOCKS];
#if W > 1
    (void)h;
    combine_row(s, row, blocks, y, x, 1);
#else
    combine_row(s, row, blocks, y, x, blocks > 1);
    if (blocks == 1) {
        const int64_t last = s->method->rows.at[row + 1] - 1;
        const double weight = h * s->method->weights.at[last];
        const double *stage = s->memory->stages.at + s->method->offsets.at[last];
        for (int64_t i = 0; i < s->equations->words.at[STATES]; i++)
            y[i] = fused(weight, stage[i], y[i]);
    }
#endif
}

/* Write a value to every place of a block. */
INLINE void spread(double *block, Real value)
{
#if W > 1
    put(block, 0, value);
#else
    store_block(block, (Block)(value));
#endif
}

/* Compute memory.new from memory.x. Not zero: what the right-hand side complained, after which one
   trajectory needs no further stages. */
INLINE int64_t take_step(const Stepper *s, Real t, Real h, int64_t *evaluations)
{
    const Memory *m = s->memory;
    const int64_t stages = s->method->shape.at[STAGES];
    int64_t failed = 0;
    spread(m->step.at, h);
    for (int64_t stage = 1; stage < stages; stage++) {
        combine_latest(s, stage, m->trial.at, h);
        double *out = m->stages.at + stage * m->x.size;
        *evaluations += 1;
        failed |= rates(s->equations, t + s->method->nodes.at[stage] * h, m->trial.at, out);
        if (W == 1 && failed)
            return failed;
    }
    combine_latest(s, stages, m->new.at, h);
    return failed;
}

/* Return zero, or NaN if some components are not finite. */
INLINE Real not_finite(const double *x, int64_t first, int64_t last)
{
    Real a = (Real)(0.0), b = a, c = a, d = a;
    int64_t i = first;
    for (; i < last - 3; i += 4) { /* four sums: one would wait for each addition */
        a = a + 0.0 * item(x, i);
        b = b + 0.0 * item(x, i + 1);
        c = c + 0.0 * item(x, i + 2);
        d = d + 0.0 * item(x, i + 3);
    }
    for (; i < last; i++)
        a = a + 0.0 * item(x, i);
    return a + b + (c + d);
}

/* Return the norm of n errors from the sums of the squares of one or two estimates. */
INLINE Real norm_of_sums(Real first, Real second, int64_t n, int64_t estimates)
{
    if (estimates == 2) {
        const Real size = first / root((first + 0.01 * second) * (double)n);
        return where(first == 0.0, (Real)(0.0), size);
    }
    return root(first / (double)n);
}

/* Add the squares of two estimates of the errors of components from `first` on, in units of their
   tolerances, to BLOCK sums each, in turn: a block at a time where vectors are whole blocks. */
INLINE void add_errors(const Memory *m, const double *errors, const double *further, int64_t first,
    int64_t last, double *sums, double *others)
{
    int64_t i = first;
#if W > 1
    const int64_t alone = last;
#else
    const int64_t whole = (first + BLOCK - 1) / BLOCK * BLOCK, alone = whole < last ? whole : last;
#endif
    for (; i < alone; i++) {
        const Real x = maximum(absolute(item(m->x.at, i)), absolute(item(m->new.at, i)));
        const Real weight = 1.0 / (item(m->atol.at, i) + m->rtol.at[i] * x);
        const Real e = item(errors, i) * weight, d = item(further, i) * weight;
        put(sums, i % BLOCK, item(sums, i % BLOCK) + e * e);
        put(others, i % BLOCK, item(others, i % BLOCK) + d * d);
    }
#if W == 1
    Block total = load_block(sums), other = load_block(others);
    for (; i < last; i += BLOCK) {
        const Block x = larger(sizes(load_block(m->x.at + i)), sizes(load_block(m->new.at + i)));
        const Block weight = 1.0 / (load_block(m->atol.at + i) + load_block(m->rtol.at + i) * x);
        const Block e = load_block(errors + i) * weight, d = load_block(further + i) * weight;
        total = total + e * e;
        other = other + d * d;
    }
    store_block(sums, total), store_block(others, other);
#endif
}

/* Return an error, or that of the components whose error is only bounded if it is larger and known.
   Slopes of these may be infinite at a point: they make no step shorter than `least`. */
INLINE Real larger_error(const Memory *m, const int64_t *words, const double *errors,
    int64_t estimates, double least, Real size, Real error)
{
    const int64_t n = words[CONTROLLED], last = words[BOUNDED];
    double sums[BLOCK * W] = {0}, others[BLOCK * W] = {0};
    Real first = (Real)(0.0), second = first;
    if (last == 0)
        return error;
    add_errors(m, errors, errors + (estimates == 2 ? m->x.size : 0), n, last, sums, others);
    for (int64_t k = 0; k < BLOCK; k++) {
        first = first + item(sums, k);
        second = second + item(others, k);
    }
    const Real bounded = norm_of_sums(first, second, last - n, estimates);
    return where(size > least, maximum(bounded, error), error);
}

/* Return the norm of the step's error: 1 is just good enough. */
INLINE Real error_of_step(const Stepper *s, double least)
{
    const Memory *m = s->memory;
    const int64_t *words = s->equations->words.at, *shape = s->method->shape.at;
    const int64_t n = words[CONTROLLED], estimates = shape[ESTIMATES];
    const double *further = m->errors.at + m->x.size;
    for (int64_t k = 0; k < estimates; k++)
        combine_row(s, shape[STAGES] + 1 + k, words[ESTIMATED_BLOCKS],
            m->errors.at + k * m->x.size, m->zero.at, 1);
    Real first = (Real)(0.0), second = first;
    for (int64_t i = 0; i < n; i++) {
        const Real weight = 1.0 / unit(m, i, item(m->x.at, i), item(m->new.at, i));
        const Real e = item(m->errors.at, i) * weight, d = item(further, i) * weight;
        first = first + e * e;
        second = second + d * d;
    }
    first = first + not_finite(m->new.at, n, words[STATES]);
    const Real error = norm_of_sums(first, second, n, estimates);
    return larger_error(m, words, m->errors.at, estimates, least, item(m->step.at, 0), error);
}

/* Compute memory.interpolant of the step just taken, the end's derivative included. Not zero: what
   the right-hand side complained. */
INLINE int64_t prepare_interpolant(const Stepper *s, Real t, Real h, int64_t *evaluations)
{
    const Memory *m = s->memory;
    const int64_t *shape = s->method->shape.at, blocks = s->equations->words.at[BLOCKS];
    const int64_t stages = shape[STAGES], length = m->x.size;
    const double *end = m->stages.at + stages * length;
    double *parts = m->interpolant.at;
    int64_t failed = 0;
    for (int64_t k = stages + 1; k < stages + 1 + shape[DENSE_STAGES]; k++) {
        combine_row(s, k + shape[ESTIMATES], blocks, m->trial.at, m->x.at, 1);
        double *out = m->stages.at + k * length;
        *evaluations += 1;
        failed |= rates(s->equations, t + s->method->nodes.at[k] * h, m->trial.at, out);
        if (W == 1 && failed)
            return failed;
    }
    for (int64_t i = 0; i < s->equations->words.at[STATES]; i++) {
        const Real increment = item(m->new.at, i) - item(m->x.at, i);
        const Real first = h * item(m->stages.at, i) - increment;
        put(parts, i, increment);
        put(parts + length, i, first);
        put(parts + 2 * length, i, increment - first - h * item(end, i));
    }
    const int64_t row = stages + 1 + shape[ESTIMATES] + shape[DENSE_STAGES];
    for (int64_t k = 3; k < shape[DEPTH]; k++)
        combine_row(s, row + k - 3, blocks, parts + k * length, m->zero.at, 1);
    return failed;
}

/* Write the state at t + theta h, in whole blocks. */
INLINE void interpolate(const Stepper *s, Real theta, double *out)
{
    const Memory *m = s->memory;
    spread(m->theta.at, theta);
    nested(out, m->x.at, m->interpolant.at, m->x.size, s->method->shape.at[DEPTH], m->theta.at,
        s->equations->words.at[BLOCKS]);
}

#endif
