/* Newton's method for the stages of Radau IIA: Jacobians, factors and iterations, in W lanes.

   E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, section IV.8:
   simplified iterations in transformed variables, one real and one complex; an embedded error
   estimate, and K. Gustafsson's predictive control of the step size.

   Lanes are told apart by bits. What is done for some of them leaves the numbers of the others as they
   are: each has the bits of a trajectory alone. */

#ifndef NEWTON_H
#define NEWTON_H

#include "step.h"

/* -- linear systems ---------------------------------------------------------------------------- */

typedef struct {
    Real re, im;
} Pair;

#define PARTS_OF(kind) (int64_t)(sizeof(kind) / sizeof(Real))

INLINE Real real_item(const double *p, int64_t i) { return item(p, i); }
INLINE void real_put(double *p, int64_t i, Real v) { put(p, i, v); }
INLINE Real real_length(Real a) { return absolute(a); }
INLINE Real real_where(Flags f, Real a, Real b) { return where(f, a, b); }
INLINE Real real_times(Real a, Real b) { return a * b; }
/* a - b c */
INLINE Real real_less(Real a, Real b, Real c) { return fused(-b, c, a); }
INLINE Real real_inverse(Real a) { return 1.0 / a; }

INLINE Pair pair_item(const double *p, int64_t i) { return (Pair){item(p, 2 * i), item(p, 2 * i + 1)}; }
INLINE void pair_put(double *p, int64_t i, Pair v) { put(p, 2 * i, v.re), put(p, 2 * i + 1, v.im); }
INLINE Real pair_length(Pair a) { return absolute(a.re) + absolute(a.im); }

INLINE Pair pair_where(Flags f, Pair a, Pair b)
{
    return (Pair){where(f, a.re, b.re), where(f, a.im, b.im)};
}

INLINE Pair pair_times(Pair a, Pair b)
{
    return (Pair){fused(a.re, b.re, -(a.im * b.im)), fused(a.re, b.im, a.im * b.re)};
}

/* Return a - b c. */
INLINE Pair pair_less(Pair a, Pair b, Pair c)
{
    const Pair product = pair_times(b, c);
    return (Pair){a.re - product.re, a.im - product.im};
}

INLINE Pair pair_inverse(Pair a)
{
    const Flags flat = absolute(a.re) >= absolute(a.im);
    const Real more = where(flat, a.re, a.im), less = where(flat, a.im, a.re), ratio = less / more;
    const Real total = more + less * ratio, one = (Real)(1.0);
    return (Pair){where(flat, one, ratio) / total, -where(flat, ratio, one) / total};
}

/* Interchange rows of so many numbers, as the pivots of each lane say. */
INLINE void interchange(double *rows, int64_t n, const double *order, int64_t width)
{
    for (int64_t k = 0; k < n; k++)
        for (int lane = 0; lane < W && bits(item(order, k) != (double)k) != 0; lane++) {
            double *one = rows + k * width * W + lane;
            double *other = rows + (int64_t)order[k * W + lane] * width * W + lane;
            SERIAL
            for (int64_t c = 0; c < width * W; c += W) {
                const double kept = one[c];
                one[c] = other[c], other[c] = kept;
            }
        }
}

#define NUMBER Real
#define OF(name) real_##name
#include "dense.h"
#define NUMBER Pair
#define OF(name) pair_##name
#include "dense.h"

/* -- the method -------------------------------------------------------------------------------- */

enum { ITERATIONS = 6, FURTHER = 4 }; /* for sensitivities, which follow the state's iterates */
static const double FROM_WAVES[3][3] = RADAU_T, TO_WAVES[3][3] = RADAU_TI;
static const double NODES[3] = RADAU_NODES, EIGENVALUE[2] = RADAU_PAIR;
static const double ERROR[3] = RADAU_ERROR, POLYNOMIAL[3][3] = RADAU_INTERPOLANT;

typedef struct {
    const Equations *equations;
    const Memory *memory;
    const Newton *newton;
    double loosest; /* the least relative tolerance */
    double least; /* the shortest step that errors which are only bounded make shorter */
} Implicit;

/* What came of an attempt to make a step; `which` bits are those of lanes. */
typedef struct {
    int64_t good, broken; /* whose steps are accepted so far; not zero: what a callback complained */
    int64_t jacobians, factorisations; /* who needed them */
    Real evaluations;
    Real next, error; /* the size of the step to try next, and this one's error */
    Real reason; /* where it is not good: the code of what it met */
    int64_t slow; /* who converged slowly */
    int64_t again; /* who tries again */
} Attempt;

INLINE Implicit implicit_of(const Equations *equations, const Memory *memory, const Newton *newton,
    double least)
{
    double loosest = memory->rtol.at[0];
    for (int64_t i = 0; i < equations->words.at[STATES]; i++)
        loosest = memory->rtol.at[i] < loosest ? memory->rtol.at[i] : loosest;
    return (Implicit){equations, memory, newton, loosest, least};
}

/* Return component i of a combination of three vectors of n. */
INLINE Real combined(const double *weights, const double *z, int64_t n, int64_t i)
{
    return weights[0] * item(z, i) + weights[1] * item(z, n + i) + weights[2] * item(z, 2 * n + i);
}

INLINE Flags finite(Real x) { return absolute(x) < INF; }

/* Let lanes whose steps were rejected have the derivatives of their states, if they have not. */
INLINE void want(const Newton *w, int64_t which)
{
    int64_t *words = w->words.at;
    words[WANTED] = (words[WANTED] & ~which) | (which & ~words[FRESH]);
}

/* Note that the steps of some lanes were rejected. */
INLINE void refuse(const Newton *w, int64_t which)
{
    w->words.at[FIRST] |= which;
    want(w, which);
}

/* The same of steps that were good by themselves. */
INLINE void undo(const Newton *w, int64_t which)
{
    refuse(w, which);
    put(w->sizes.at, PREDICTING, where(flags(which), (Real)(0.0), item(w->sizes.at, PREDICTING)));
}

/* Begin in some lanes, with nothing known. */
INLINE void begin_newton(const Newton *w, int64_t which)
{
    w->words.at[FRESH] &= ~which;
    undo(w, which);
    put(w->sizes.at, ERROR_BEFORE, where(flags(which), (Real)(0.0), item(w->sizes.at, ERROR_BEFORE)));
}

/* -- the Jacobian ------------------------------------------------------------------------------ */

/* Write df/dx at memory.x, whose derivative the first of memory.stages is. */
INLINE int64_t evaluate_jacobian(const Implicit *s, Real t, Real *evaluations)
{
    const Equations *e = s->equations;
    const Newton *w = s->newton;
    double *out = w->latest.at;
    if (w->words.at[GRADIENT] != 0) {
        set_inputs(e, t);
        return call_kernel(w->words.at[GRADIENT], e->clock.at, s->memory->x.at, e->r.at, w->c.at, out);
    }
#if W == 1 /* lanes are there for compiled derivatives only */
    const Memory *m = s->memory;
    const int64_t n = e->words.at[STATES];
    for (int64_t i = 0; i < n; i++)
        m->trial.at[i] = m->x.at[i];
    for (int64_t j = 0; j < n; j++) {
        const double x = m->x.at[j];
        const double moved = x + DIFFERENCE * maximum(DIFFERENCE_SCALE, absolute(x));
        m->trial.at[j] = moved;
        *evaluations += 1.0;
        const int64_t code = rates(e, t, m->trial.at, m->new.at);
        if (code != 0)
            return code;
        for (int64_t i = 0; i < n; i++)
            out[i * n + j] = (m->new.at[i] - m->stages.at[i]) / (moved - x);
        m->trial.at[j] = x;
    }
#else
    (void)evaluations;
#endif
    return 0;
}

/* Take the Jacobians of some lanes. Negative: what a callback complained.

   An infinite slope, as of a square root at zero, counts as zero: the iteration then goes without
   this derivative, where dividing by infinity would keep the state where it is. */
INLINE int64_t set_jacobian(const Implicit *s, Real t, int64_t which, Real *evaluations)
{
    const Numbers *jacobian = &s->newton->jacobian, *latest = &s->newton->latest;
    const int64_t code = evaluate_jacobian(s, t, evaluations);
    for (int64_t i = 0; i < jacobian->size / W; i++) {
        const Real slope = item(latest->at, i), known = where(finite(slope), slope, (Real)(0.0));
        put(jacobian->at, i, where(flags(which), known, item(jacobian->at, i)));
    }
    return code;
}

/* Let some lanes go on without derivatives, which are worthless near a singularity; return the bits of
   those that had any. */
INLINE int64_t forget(const Newton *w, int64_t which)
{
    Flags there = flags(0);
    for (int64_t i = 0; i < w->jacobian.size / W; i++) {
        const Real slope = item(w->jacobian.at, i);
        there = there | (slope != 0.0);
        put(w->jacobian.at, i, where(flags(which), (Real)(0.0), slope));
    }
    return bits(there) & which;
}

/* Factorise (mu / h) I - J for both eigenvalues mu; return the bits of the lanes where one is singular.
   Lanes that have the step size of their factors come to these again. */
INLINE int64_t factorise_both(const Newton *w, Real h)
{
    const int64_t n = w->real_order.size / W;
    double *real = w->real.at, *pair = w->pair.at;
    for (int64_t i = 0; i < n; i++) {
        for (int64_t j = 0; j < n; j++) {
            const Real slope = -item(w->jacobian.at, i * n + j);
            const Real own = i == j ? slope + RADAU_REAL / h : slope;
            const Real re = i == j ? slope + EIGENVALUE[0] / h : slope;
            put(real, i * n + j, own);
            pair_put(pair, i * n + j, (Pair){re, i == j ? EIGENVALUE[1] / h : (Real)(0.0)});
        }
    }
    return real_factorise(real, n, w->real_order.at) | pair_factorise(pair, n, w->pair_order.at);
}

/* -- the stages -------------------------------------------------------------------------------- */

/* How iterations ended: in which lanes they converged, and the right-hand side failed; after how many
   iterations, and at which rate, infinite after slopes that are not finite. */
typedef struct {
    int64_t converged, failed, broken;
    Real iterations, rate, evaluations;
} Settled;

/* Continue the last step's polynomial to the new stages; zero without one. */
INLINE void predict(const Implicit *s, Real h, Real last_size)
{
    const int64_t n = s->equations->words.at[STATES];
    const double *last = s->newton->last.at, *x = s->memory->x.at;
    double *z = s->newton->stages.at, *waves = s->newton->waves.at;
    const Flags known = last_size > 0.0;
    for (int k = 0; k < 3; k++) {
        const Real theta = 1.0 + NODES[k] * h / last_size;
        for (int64_t i = 0; i < n; i++) {
            const Real further = (1.0 - theta) * (item(last, 2 * n + i) + theta * item(last, 3 * n + i));
            const Real value = item(last, i) + theta * (item(last, n + i) + further) - item(x, i);
            put(z, k * n + i, where(known, value, (Real)(0.0)));
        }
    }
    for (int k = 0; k < 3; k++)
        for (int64_t i = 0; i < n; i++)
            put(waves, k * n + i, combined(TO_WAVES[k], z, n, i));
}

/* Return the largest change of a column of sensitivities, relative to it, squared. */
INLINE Real columns_moved(const Implicit *s)
{
    const Newton *own = s->newton;
    const int64_t n = own->real_order.size / W, width = own->words.at[COUNTED];
    const int64_t all = s->equations->words.at[STATES];
    const double *w = own->waves.at;
    Real worst = (Real)(0.0);
    for (int64_t column = 0; column < width; column++) {
        Real moved = (Real)(0.0), size = moved;
        for (int64_t i = 0; i < n; i++) {
            const int64_t k = n + i * width + column;
            const Real real = item(own->real_change.at, k), x = item(s->memory->x.at, k);
            const Pair pair = pair_item(own->pair_change.at, k);
            moved = moved + (real * real + (pair.re * pair.re + pair.im * pair.im));
            size = size + x * x;
            for (int j = 0; j < 3; j++)
                size = size + item(w, j * all + k) * item(w, j * all + k);
        }
        const Real ratio = where(size > 0.0, moved / size, (Real)(1.0));
        worst = where(moved > worst * size, ratio, worst);
    }
    return worst;
}

/* Compute the changes of the transformed stages from the slopes; *pushed says whether there is
   anything to change. Return the bits of the lanes whose slopes are finite. */
INLINE int64_t set_changes(const Implicit *s, Real h, Real *pushed)
{
    const Memory *m = s->memory;
    const Newton *own = s->newton;
    const int64_t n = s->equations->words.at[STATES], controlled = s->equations->words.at[CONTROLLED];
    const double *f = own->slopes.at, *w = own->waves.at;
    const Pair eigenvalue = {EIGENVALUE[0] / h, EIGENVALUE[1] / h};
    Flags all = flags(EVERY);
    *pushed = (Real)(0.0);
    for (int64_t i = 0; i < n; i++) {
        all = all & finite(item(f, i) + item(f, n + i) + item(f, 2 * n + i));
        const Pair wave = {item(w, n + i), item(w, 2 * n + i)};
        const Pair slope = {combined(TO_WAVES[1], f, n, i), combined(TO_WAVES[2], f, n, i)};
        const Real real = combined(TO_WAVES[0], f, n, i) - RADAU_REAL / h * item(w, i);
        const Pair pair = pair_less(slope, eigenvalue, wave);
        put(own->real_change.at, i, real);
        pair_put(own->pair_change.at, i, pair);
        if (i >= controlled)
            continue;
        const Real x = item(m->x.at, i);
        const Real push = h * (absolute(real) + pair_length(pair)) / unit(m, i, x, x);
        *pushed = *pushed + push * push;
    }
    return bits(all);
}

/* Return the norm of the changes, which are solved for with the factors of the state. */
INLINE Real solve_changes(const Implicit *s)
{
    const Memory *m = s->memory;
    const Newton *w = s->newton;
    const int64_t n = s->equations->words.at[CONTROLLED], own = w->real_order.size / W;
    const int64_t width = w->words.at[COUNTED];
    double *real = w->real_change.at, *pair = w->pair_change.at;
    Real total = (Real)(0.0);
    real_solve(w->real.at, own, w->real_order.at, real);
    pair_solve(w->pair.at, own, w->pair_order.at, pair);
    if (width > 0) {
        real_solve_columns(w->real.at, own, w->real_order.at, real + own * W, width);
        pair_solve_columns(w->pair.at, own, w->pair_order.at, pair + 2 * own * W, width);
    }
    for (int64_t i = 0; i < n; i++) {
        const Real x = item(m->x.at, i), scale = unit(m, i, x, x), a = item(real, i) / scale;
        const Pair change = pair_item(pair, i);
        const Real b = change.re / scale, c = change.im / scale;
        total = total + (a * a + b * b + c * c);
    }
    return root(total / (double)(3 * n));
}

/* Move the stages of some lanes by the changes. */
INLINE void move_stages(const Implicit *s, int64_t which)
{
    const Newton *own = s->newton;
    const int64_t n = s->equations->words.at[STATES];
    const Flags some = flags(which);
    double *z = own->stages.at, *w = own->waves.at;
    for (int64_t i = 0; i < n; i++) {
        const Pair pair = pair_item(own->pair_change.at, i);
        const Real changes[3] = {item(own->real_change.at, i), pair.re, pair.im};
        for (int k = 0; k < 3; k++) {
            const Real wave = item(w, k * n + i);
            put(w, k * n + i, where(some, wave + changes[k], wave));
        }
        for (int k = 0; k < 3; k++)
            put(z, k * n + i, where(some, combined(FROM_WAVES[k], w, n, i), item(z, k * n + i)));
    }
}

/* Evaluate the derivatives at the stages, of the lanes that are `going`; return the bits of those where
   that did not fail. */
INLINE int64_t evaluate_stages(const Implicit *s, Real t, Real h, int64_t going, Settled *found)
{
    const Memory *m = s->memory;
    const int64_t n = s->equations->words.at[STATES];
    const double *z = s->newton->stages.at;
    for (int64_t k = 0; k < 3 && going != 0; k++) {
        for (int64_t i = 0; i < n; i++)
            put(m->trial.at, i, item(m->x.at, i) + item(z, k * n + i));
        found->evaluations = found->evaluations + SOME(flags(going), 1.0);
        double *out = s->newton->slopes.at + k * n * W;
        const int64_t code = rates(s->equations, t + h * NODES[k], m->trial.at, out);
        if (W == 1 && code < 0)
            found->broken = code;
        found->failed |= going & code;
        going &= ~code;
    }
    return going;
}

/* Iterate to the stages of some lanes. Where columns of sensitivities need further iterations, to
   relative changes of `least`, these do not count. */
INLINE Settled solve_stages(const Implicit *s, Real t, Real h, int64_t which, double tolerance,
    double least)
{
    const int64_t width = s->newton->words.at[COUNTED];
    Settled found = {0};
    Real before = (Real)(-1.0), pushed;
    int64_t going = which, lost = 0;
    found.iterations = found.rate = found.evaluations = (Real)(0.0);
    for (int64_t iteration = 0; iteration < ITERATIONS + (width > 0 ? FURTHER : 0); iteration++) {
        if (iteration >= ITERATIONS)
            going &= found.converged;
        const int64_t well = evaluate_stages(s, t, h, going, &found);
        if (well == 0)
            return found.converged &= ~(lost | going), found;
        const int64_t sound = well & set_changes(s, h, &pushed);
        found.rate = where(flags(well & ~sound), (Real)(INF), found.rate);
        const Real change = solve_changes(s);
        /* held in place by derivatives that are far too large */
        const int64_t stuck = sound & bits((change == 0.0) & (pushed > 0.0));
        const Flags judged = flags(sound & ~stuck & ~found.converged) & (before > 0.0);
        found.rate = where(judged, change / before, found.rate);
        Real further = change / (1.0 - found.rate);
        for (int64_t k = iteration; k < ITERATIONS - 1; k++)
            further = further * found.rate;
        const Flags grows = (found.rate >= 1.0) | (further > tolerance);
        const int64_t on = sound & ~stuck & ~bits(judged & grows);
        lost |= going & ~on;
        move_stages(s, on);
        const Real rest = found.rate / (1.0 - found.rate) * change;
        const Flags small = (change == 0.0) | ((before > 0.0) & (rest < tolerance));
        const int64_t settled = on & ~found.converged & bits(small);
        found.iterations = where(flags(settled), (Real)((double)(iteration + 1)), found.iterations);
        found.converged |= settled;
        going = on & ~found.converged;
        if (width > 0)
            going = on & ~(found.converged & bits(columns_moved(s) <= least * least));
        if (going == 0)
            break;
        before = change;
    }
    found.converged &= ~lost;
    return found;
}

/* -- a step ------------------------------------------------------------------------------------ */

/* Solve for a state and its sensitivities with the real factors. */
INLINE void solve_all(const Newton *w, double *right)
{
    const int64_t n = w->real_order.size / W, width = w->words.at[COUNTED];
    real_solve(w->real.at, n, w->real_order.at, right);
    if (width > 0)
        real_solve_columns(w->real.at, n, w->real_order.at, right + n * W, width);
}

/* Return the norm of an error estimate of steps to memory.new. */
INLINE Real norm_of_error(const Implicit *s, const double *error, Real h)
{
    const Memory *m = s->memory;
    const int64_t *words = s->equations->words.at, n = words[CONTROLLED];
    const Real size = norm(error, m->new.at, m, n) + not_finite(m->new.at, n, words[STATES]);
    return larger_error(m, words, error, 1, s->least, h, size);
}

/* Return the norm of the error of steps to memory.new; of a second, filtered estimate where that is too
   large and in `again`. */
INLINE Real estimate(const Implicit *s, Real t, Real h, int64_t which, int64_t again, Attempt *a)
{
    const Memory *m = s->memory;
    const Newton *w = s->newton;
    const int64_t n = s->equations->words.at[STATES];
    double *guess = w->guess.at, *error = w->real_change.at;
    for (int64_t i = 0; i < n; i++) {
        put(guess, i, combined(ERROR, w->stages.at, n, i) / h);
        put(error, i, item(m->stages.at, i) + item(guess, i));
    }
    solve_all(w, error);
    const Real size = norm_of_error(s, error, h);
    again &= which & ~bits(size < 1.0);
    a->good = which & bits(size < 1.0);
    if (again == 0)
        return size;
    for (int64_t i = 0; i < n; i++)
        put(m->trial.at, i, item(m->x.at, i) + item(error, i));
    a->evaluations = a->evaluations + SOME(flags(again), 1.0);
    const int64_t code = rates(s->equations, t, m->trial.at, w->slopes.at);
    if (W == 1 && code < 0)
        a->broken = code;
    a->reason = where(flags(again & code), (Real)(SINGULAR), a->reason);
    for (int64_t i = 0; i < n; i++)
        put(error, i, item(w->slopes.at, i) + item(guess, i));
    solve_all(w, error);
    const Real second = norm_of_error(s, error, h);
    a->good |= again & ~code & bits(second < 1.0);
    return where(flags(again & ~code), second, size);
}

/* Set the sizes of the next steps of lanes with a measured error. */
INLINE void set_next(const Newton *w, Real size, Real iterations, int64_t measured, Attempt *a)
{
    const Real least = maximum((Real)(LEAST_ERROR), a->error), before = item(w->sizes.at, ERROR_BEFORE);
    const Real safety = 0.9 * (2 * ITERATIONS + 1) / (2.0 * ITERATIONS + iterations);
    const Real factor = 1.0 / root(root(least)), once = maximum(safety * factor, (Real)(0.2));
    const Real shorter = size * where(finite(a->error), once, (Real)(AFTER_FAILURE));
    const Real change = size / item(w->sizes.at, SIZE_BEFORE) * root(root(before / least));
    const Real steady = where(before > 0.0, minimum(change, (Real)(1.0)), (Real)(1.0));
    const Real growth = minimum(safety * factor * steady, (Real)(10.0));
    /* the same step size spares a factorisation */
    const Flags same = (growth > 1.0) & (growth < 1.2) & ~flags(a->slow);
    const Real longer = where(same, item(w->sizes.at, FACTORED), size * maximum(growth, (Real)(0.2)));
    const Real next = where(flags(a->good), longer, shorter);
    a->next = where(flags(measured), next, a->next);
}

/* Make the factors for the steps of some lanes; return the bits of those that have them. */
INLINE int64_t set_factors(const Newton *w, Real size, Real after, int64_t which, Attempt *a)
{
    int64_t *words = w->words.at;
    const Real known = item(w->sizes.at, FACTORED);
    const int64_t other = bits(absolute(size - known) > ROUNDING * absolute(after));
    a->factorisations = which & (other | ~words[FACTORISED]);
    if (a->factorisations == 0)
        return which;
    const Real h = where(flags(a->factorisations), size, known);
    put(w->sizes.at, FACTORED, h);
    const int64_t singular = a->factorisations & factorise_both(w, h);
    words[FACTORISED] = (words[FACTORISED] | a->factorisations) & ~singular;
    a->reason = where(flags(singular), (Real)(NOT_FINITE), a->reason);
    a->next = where(flags(singular), 0.5 * size, a->next);
    want(w, singular);
    return which & ~singular;
}

/* See to lanes whose iterations did not converge. */
INLINE void lose(const Newton *w, Real size, int64_t lost, const Settled *settled, Attempt *a)
{
    int64_t *words = w->words.at;
    const int64_t failed = settled->failed, fresh = lost & words[FRESH] & ~failed;
    const Flags some = flags(lost), wrong = flags(failed);
    Real reason = where(finite(settled->rate), (Real)(NO_CONVERGENCE), (Real)(NOT_FINITE));
    reason = where(wrong, (Real)(SINGULAR), reason);
    a->reason = where(some, reason, a->reason);
    const int64_t forgotten = fresh == 0 ? 0 : forget(w, fresh), shorter = fresh & ~forgotten;
    words[FACTORISED] &= ~forgotten;
    words[FRESH] &= ~shorter; /* a shorter step has its derivatives again */
    a->next = where(flags(shorter), 0.5 * size, a->next);
    a->next = where(wrong, AFTER_FAILURE * size, a->next);
    put(w->sizes.at, PREDICTING, where(wrong, (Real)(0.0), item(w->sizes.at, PREDICTING)));
    want(w, lost & ~forgotten);
}

/* Try steps of some size in some lanes, from t to `after`; `h` was wanted at first. */
INLINE Attempt try_step(const Implicit *s, Real t, Real h, Real size, Real after, int64_t which)
{
    const Memory *m = s->memory;
    const Newton *w = s->newton;
    const int64_t n = s->equations->words.at[STATES], wanted = w->words.at[WANTED] & which;
    int64_t *words = w->words.at;
    Attempt a = {.next = h, .reason = (Real)(STEP_UNDERFLOW), .jacobians = wanted};
    a.again = words[FIRST] & which;
    a.evaluations = a.error = (Real)(0.0);
    if (wanted != 0) {
        if (set_jacobian(s, t, wanted, &a.evaluations) < 0)
            return a.broken = 1, a;
        words[WANTED] &= ~wanted, words[FRESH] |= wanted, words[FACTORISED] &= ~wanted;
    }
    const int64_t trying = set_factors(w, size, after, which, &a);
    if (trying == 0)
        return a;
    const double loosest = s->loosest, sharp = 10.0 * ROUNDING / (loosest > ROUNDING ? loosest : ROUNDING);
    const double usual = LIBRARY(sqrt)(loosest) < 0.03 ? LIBRARY(sqrt)(loosest) : 0.03;
    const double tolerance = usual > sharp ? usual : sharp;
    predict(s, size, item(w->sizes.at, PREDICTING));
    const Settled settled = solve_stages(s, t, size, trying, tolerance, tolerance * loosest);
    a.evaluations = a.evaluations + settled.evaluations;
    a.broken = settled.broken, a.slow = bits((settled.iterations > 2.0) & (settled.rate > SLOW));
    if (settled.converged != trying)
        lose(w, size, trying & ~settled.converged, &settled, &a);
    if (settled.converged == 0 || a.broken != 0)
        return a;
    for (int64_t i = 0; i < n; i++)
        put(m->new.at, i, item(m->x.at, i) + item(w->stages.at, 2 * n + i));
    a.error = estimate(s, t, size, settled.converged, words[FIRST], &a);
    set_next(w, size, settled.iterations, settled.converged, &a);
    refuse(w, settled.converged & ~a.good);
    return a;
}

/* Accept the steps of some lanes: write the collocation polynomial in the nested form, and keep what the
   next step needs. */
INLINE void accept(const Implicit *s, Real size, int64_t which, const Attempt *a)
{
    const Memory *m = s->memory;
    const Newton *w = s->newton;
    const int64_t n = s->equations->words.at[STATES], length = m->x.size;
    const double *z = w->stages.at;
    const Flags some = flags(which);
    double *parts = m->interpolant.at, *last = w->last.at, *sizes = w->sizes.at;
    double second[3], third[3];
    for (int k = 0; k < 3; k++)
        second[k] = POLYNOMIAL[k][1], third[k] = POLYNOMIAL[k][2];
    for (int64_t i = 0; i < n; i++) {
        const Real two = combined(second, z, n, i), three = combined(third, z, n, i);
        put(parts, i, item(m->new.at, i) - item(m->x.at, i));
        put(parts + length, i, -two - three);
        put(parts + 2 * length, i, -three);
        put(last, i, where(some, item(m->x.at, i), item(last, i)));
        for (int k = 0; k < 3; k++)
            put(last, (1 + k) * n + i, where(some, item(parts + k * length, i), item(last, (1 + k) * n + i)));
    }
    const Real error = maximum((Real)(LEAST_ERROR), a->error);
    put(sizes, PREDICTING, where(some, size, item(sizes, PREDICTING)));
    put(sizes, SIZE_BEFORE, where(some, size, item(sizes, SIZE_BEFORE)));
    put(sizes, ERROR_BEFORE, where(some, error, item(sizes, ERROR_BEFORE)));
    w->words.at[WANTED] = (w->words.at[WANTED] & ~which) | (which & a->slow);
    w->words.at[FRESH] &= ~which, w->words.at[FIRST] &= ~which;
}

#endif
