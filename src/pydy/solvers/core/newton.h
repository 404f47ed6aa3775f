/* Newton's method for the stages of Radau IIA: Jacobians, factors and iterations.

   E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, section IV.8:
   simplified iterations in transformed variables, one real and one complex. */

#ifndef NEWTON_H
#define NEWTON_H

#include "run.h"

typedef double _Complex Pair;

INLINE double real_of(Pair z) { return __real__ z; }
INLINE double imag_of(Pair z) { return __imag__ z; }
INLINE double length_of(Pair z) { return __builtin_hypot(real_of(z), imag_of(z)); }

INLINE Pair pair_of(double re, double im)
{
    Pair z;
    __real__ z = re, __imag__ z = im;
    return z;
}

INLINE Pair pair_over(Pair a, Pair b)
{
    const double ar = real_of(a), ai = imag_of(a), br = real_of(b), bi = imag_of(b);
    if (absolute(br) >= absolute(bi)) {
        const double ratio = bi / br, total = br + bi * ratio;
        return pair_of((ar + ai * ratio) / total, (ai - ar * ratio) / total);
    }
    const double ratio = br / bi, total = br * ratio + bi;
    return pair_of((ar * ratio + ai) / total, (ai * ratio - ar) / total);
}

#define NUMBER double
#define OF(name) real_##name
#define LENGTH_OF absolute
#define OVER(a, b) ((a) / (b))
#include "dense.h"
#define NUMBER Pair
#define OF(name) pair_##name
#define LENGTH_OF length_of
#define OVER pair_over
#include "dense.h"

enum { ITERATIONS = 6, FURTHER = 4 }; /* for sensitivities, which follow the state's iterates */
static const double FROM_WAVES[3][3] = RADAU_T, TO_WAVES[3][3] = RADAU_TI;
static const double NODES[3] = RADAU_NODES, EIGENVALUE[2] = RADAU_PAIR;

/* Return component i of a combination of three vectors of n. */
INLINE double combined(const double *weights, const double *z, int64_t n, int64_t i)
{
    return weights[0] * z[i] + weights[1] * z[n + i] + weights[2] * z[2 * n + i];
}

INLINE Pair eigenvalue_over(double h) { return pair_of(EIGENVALUE[0] / h, EIGENVALUE[1] / h); }

/* -- the Jacobian ------------------------------------------------------------------------------ */

INLINE int64_t evaluate_jacobian(const Run *run, double t)
{
    const Problem *p = &run->problem;
    const Memory *m = &run->memory;
    const Newton *w = &run->newton;
    const int64_t n = p->words.at[STATES];
    if (w->words.at[GRADIENT] != 0) {
        set_inputs(p, t);
        return call_kernel(w->words.at[GRADIENT], p->clock.at, m->x.at, p->r.at, w->c.at,
            w->jacobian.at);
    }
    for (int64_t i = 0; i < n; i++)
        m->trial.at[i] = m->x.at[i];
    for (int64_t j = 0; j < n; j++) {
        const double x = m->x.at[j];
        const double moved = x + DIFFERENCE * maximum(DIFFERENCE_SCALE, absolute(x));
        m->trial.at[j] = moved;
        run->progress.counts.at[EVALUATIONS] += 1;
        const int64_t code = rates(p, t, m->trial.at, m->new.at);
        if (code != 0)
            return code;
        for (int64_t i = 0; i < n; i++)
            w->jacobian.at[i * n + j] = (m->new.at[i] - m->stages.at[i]) / (moved - x);
        m->trial.at[j] = x;
    }
    return 0;
}

/* Evaluate df/dx at memory.x, whose derivative the first of memory.stages is.

   An infinite slope, as of a square root at zero, counts as zero: the iteration then goes without
   this derivative, where dividing by infinity would keep the state where it is. */
INLINE int64_t set_jacobian(const Run *run, double t)
{
    const Numbers *jacobian = &run->newton.jacobian;
    run->progress.counts.at[JACOBIANS] += 1;
    const int64_t code = evaluate_jacobian(run, t);
    for (int64_t i = 0; i < jacobian->size; i++)
        if (!is_finite(jacobian->at[i]))
            jacobian->at[i] = 0.0;
    return code;
}

/* Go on without derivatives, which are worthless near a singularity; tell if there were any. */
INLINE int forget(const Newton *w)
{
    int there = 0;
    for (int64_t i = 0; i < w->jacobian.size; i++) {
        there = there || w->jacobian.at[i] != 0.0;
        w->jacobian.at[i] = 0.0;
    }
    return there;
}

/* Factorise (mu / h) I - J for both eigenvalues mu. */
INLINE int factorise_both(const Newton *w, double h)
{
    const int64_t n = w->real_order.size;
    double *real = w->real.at;
    Pair *pair = w->pair.at;
    for (int64_t i = 0; i < n; i++) {
        for (int64_t j = 0; j < n; j++) {
            real[i * n + j] = -w->jacobian.at[i * n + j];
            pair[i * n + j] = pair_of(-w->jacobian.at[i * n + j], 0.0);
        }
        real[i * n + i] += RADAU_REAL / h;
        pair[i * n + i] += eigenvalue_over(h);
    }
    return real_factorise(real, n, w->real_order.at) && pair_factorise(pair, n, w->pair_order.at);
}

/* -- the stages -------------------------------------------------------------------------------- */

/* How an iteration ended: a complaint of the right-hand side, and otherwise whether it converged,
   after how many iterations and at which rate. */
typedef struct {
    int64_t code, iterations;
    int converged;
    double rate;
} Settled;

/* Continue the last step's polynomial to the new stages; zero without one. */
INLINE void predict(const Run *run, double h, double last_size)
{
    const int64_t n = run->problem.words.at[STATES];
    const double *last = run->newton.last.at, *x = run->memory.x.at;
    double *z = run->newton.stages.at, *waves = run->newton.waves.at;
    for (int k = 0; k < 3; k++) {
        const double theta = last_size > 0.0 ? 1.0 + NODES[k] * h / last_size : 0.0;
        for (int64_t i = 0; i < n; i++) {
            z[k * n + i] = 0.0;
            if (last_size > 0.0) {
                const double value = (1.0 - theta) * (last[2 * n + i] + theta * last[3 * n + i]);
                z[k * n + i] = last[i] + theta * (last[n + i] + value) - x[i];
            }
        }
    }
    for (int k = 0; k < 3; k++)
        for (int64_t i = 0; i < n; i++)
            waves[k * n + i] = combined(TO_WAVES[k], z, n, i);
}

/* Return the largest change of a column of sensitivities, relative to it, squared. */
INLINE double columns_moved(const Memory *m, const Newton *s)
{
    const int64_t n = s->real_order.size, width = s->words.at[COUNTED], all = s->waves.columns;
    const double *real = s->real_change.at, *w = s->waves.at;
    const Pair *pair = s->pair_change.at;
    double worst = 0.0;
    for (int64_t column = 0; column < width; column++) {
        double moved = 0.0, size = 0.0;
        for (int64_t i = 0; i < n; i++) {
            const int64_t k = n + i * width + column;
            moved += real[k] * real[k] + length_of(pair[k]) * length_of(pair[k]);
            size += m->x.at[k] * m->x.at[k];
            size += w[k] * w[k] + w[all + k] * w[all + k] + w[2 * all + k] * w[2 * all + k];
        }
        if (moved > worst * size)
            worst = size > 0.0 ? moved / size : 1.0;
    }
    return worst;
}

/* Compute the changes of the transformed stages from the slopes; *pushed says whether there is
   anything to change. Not finite: NaN. */
INLINE int set_changes(const Run *run, double h, double *pushed)
{
    const Memory *m = &run->memory;
    const Newton *s = &run->newton;
    const int64_t n = run->problem.words.at[STATES];
    const double *f = s->slopes.at, *w = s->waves.at;
    double *real = s->real_change.at;
    Pair *pair = s->pair_change.at;
    *pushed = 0.0;
    for (int64_t i = 0; i < n; i++) {
        if (!is_finite(f[i] + f[n + i] + f[2 * n + i]))
            return 0;
        real[i] = combined(TO_WAVES[0], f, n, i) - RADAU_REAL / h * w[i];
        pair[i] = pair_of(combined(TO_WAVES[1], f, n, i), combined(TO_WAVES[2], f, n, i))
            - eigenvalue_over(h) * pair_of(w[n + i], w[2 * n + i]);
        double push = h * (absolute(real[i]) + absolute(real_of(pair[i])) + absolute(imag_of(pair[i])));
        push /= unit(m, i, m->x.at[i], m->x.at[i]);
        *pushed += push * push;
    }
    return 1;
}

/* Return the norm of the changes, which are solved for with the factors of the state. */
INLINE double solve_changes(const Run *run)
{
    const Memory *m = &run->memory;
    const Newton *s = &run->newton;
    const int64_t n = run->problem.words.at[STATES], own = s->real_order.size;
    const int64_t width = s->words.at[COUNTED];
    double *real = s->real_change.at, total = 0.0;
    Pair *pair = s->pair_change.at;
    real_solve(s->real.at, own, s->real_order.at, real);
    pair_solve(s->pair.at, own, s->pair_order.at, pair);
    if (width > 0) {
        real_solve_columns(s->real.at, own, s->real_order.at, real, width);
        pair_solve_columns(s->pair.at, own, s->pair_order.at, pair, width);
    }
    for (int64_t i = 0; i < n; i++) {
        const double scale = unit(m, i, m->x.at[i], m->x.at[i]), a = real[i] / scale;
        const double b = real_of(pair[i]) / scale, c = imag_of(pair[i]) / scale;
        total += a * a + b * b + c * c;
    }
    return root(total / (double)(3 * n));
}

/* Iterate to the stages. Where columns of sensitivities need further iterations, to relative changes
   of `least`, these do not count. */
INLINE Settled solve_stages(const Run *run, double t, double h, double tolerance, double least)
{
    const Memory *m = &run->memory;
    const Newton *s = &run->newton;
    const int64_t n = run->problem.words.at[STATES], width = s->words.at[COUNTED];
    double *z = s->stages.at, *w = s->waves.at, *f = s->slopes.at;
    const double *real = s->real_change.at;
    const Pair *pair = s->pair_change.at;
    double before = -1.0, rate = 0.0, pushed;
    int64_t settled = 0;
    for (int64_t iteration = 0; iteration < ITERATIONS + (width > 0 ? FURTHER : 0); iteration++) {
        if (iteration >= ITERATIONS && settled == 0)
            break;
        for (int k = 0; k < 3; k++) {
            for (int64_t i = 0; i < n; i++)
                m->trial.at[i] = m->x.at[i] + z[k * n + i];
            run->progress.counts.at[EVALUATIONS] += 1;
            const int64_t code = rates(&run->problem, t + h * NODES[k], m->trial.at, f + k * n);
            if (code != 0)
                return (Settled){code, iteration, 0, 0.0};
        }
        if (!set_changes(run, h, &pushed))
            return (Settled){0, iteration, 0, INF};
        const double change = solve_changes(run);
        if (change == 0.0 && pushed > 0.0) /* held in place by derivatives that are far too large */
            return (Settled){0, iteration + 1, 0, rate};
        if (before > 0.0 && settled == 0) {
            rate = change / before;
            const double further = __builtin_pow(rate, (double)(ITERATIONS - 1 - iteration));
            if (rate >= 1.0 || further / (1.0 - rate) * change > tolerance)
                return (Settled){0, iteration + 1, 0, rate};
        }
        for (int64_t i = 0; i < n; i++) {
            w[i] += real[i];
            w[n + i] += real_of(pair[i]);
            w[2 * n + i] += imag_of(pair[i]);
            for (int k = 0; k < 3; k++)
                z[k * n + i] = combined(FROM_WAVES[k], w, n, i);
        }
        const int small = before > 0.0 && rate / (1.0 - rate) * change < tolerance;
        if (settled == 0 && (change == 0.0 || small))
            settled = iteration + 1;
        if (settled > 0 && (width == 0 || columns_moved(m, s) <= least * least))
            break;
        before = change;
    }
    return (Settled){0, settled > 0 ? settled : ITERATIONS, settled > 0, rate};
}

#endif
