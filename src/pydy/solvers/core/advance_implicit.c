/* Radau IIA of order 5 for stiff systems.

   E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, section IV.8: an
   embedded error estimate, and K. Gustafsson's predictive control of the step size. */

#include "newton.h"

static const double ERROR[3] = RADAU_ERROR, POLYNOMIAL[3][3] = RADAU_INTERPOLANT;

/* Return the norm of the step's error in *size; of a second, filtered estimate where that is too
   large and `first`. */
INLINE int64_t estimate(const Run *run, double t, double h, int first, double *size)
{
    const Memory *m = &run->memory;
    const Newton *w = &run->newton;
    const int64_t n = run->problem.words.at[STATES], own = w->real_order.size;
    double *guess = w->guess.at, *error = w->real_change.at;
    for (int64_t i = 0; i < n; i++) {
        guess[i] = combined(ERROR, w->stages.at, n, i) / h;
        error[i] = m->stages.at[i] + guess[i];
    }
    real_solve(w->real.at, own, w->real_order.at, error);
    *size = norm(error, m->new.at, m, n);
    if (*size < 1.0 || !first)
        return 0;
    for (int64_t i = 0; i < n; i++)
        m->trial.at[i] = m->x.at[i] + error[i];
    run->progress.counts.at[EVALUATIONS] += 1;
    const int64_t code = rates(&run->problem, t, m->trial.at, w->slopes.at);
    if (code != 0)
        return code;
    for (int64_t i = 0; i < n; i++)
        error[i] = w->slopes.at[i] + guess[i];
    real_solve(w->real.at, own, w->real_order.at, error);
    *size = norm(error, m->new.at, m, n);
    return 0;
}

/* Write the collocation polynomial in the nested form, and keep it for the next prediction. */
INLINE void set_interpolant(const Run *run)
{
    const Memory *m = &run->memory;
    const int64_t n = run->problem.words.at[STATES], length = m->x.size;
    const double *z = run->newton.stages.at;
    double *parts = m->interpolant.at, *last = run->newton.last.at;
    double second[3], third[3];
    for (int k = 0; k < 3; k++)
        second[k] = POLYNOMIAL[k][1], third[k] = POLYNOMIAL[k][2];
    for (int64_t i = 0; i < n; i++) {
        const double two = combined(second, z, n, i), three = combined(third, z, n, i);
        parts[i] = m->new.at[i] - m->x.at[i];
        parts[length + i] = -two - three;
        parts[2 * length + i] = -three;
        last[i] = m->x.at[i];
        for (int k = 0; k < 3; k++)
            last[(1 + k) * n + i] = parts[k * length + i];
    }
}

/* Tell whether events stay away from zero in the step just taken, in which states do not move CLEAR
   times as far as at the farthest of its stages. */
INLINE int stays_clear(const Run *run, double t, double h)
{
    const int64_t *words = run->watch.words.at, all = run->problem.words.at[STATES];
    double *moved = run->watch.reach.at + words[MOVES];
    const double *z = run->newton.stages.at;
    if (words[REACHER] == 0)
        return 0;
    for (int64_t i = 0; i < words[MOVING]; i++) {
        const double end = absolute(run->memory.new.at[i] - run->memory.x.at[i]);
        const double first = maximum(absolute(z[i]), absolute(z[all + i]));
        moved[i] = CLEAR * maximum(maximum(first, absolute(z[2 * all + i])), end);
    }
    return are_clear(run, t, h);
}

/* Step until the end, or until BUDGET steps are taken, or something else happens. */
INLINE int64_t step_on(const Run *run, double *flat)
{
    const Stepper stepper = STEPPER(run), *s = &stepper;
    const Newton *newton = &run->newton;
    const Memory *m = &run->memory;
    double *state = run->progress.state.at, *sizes = newton->sizes.at;
    int64_t *count = run->progress.counts.at, *words = newton->words.at;
    if (count[BUDGET] == 0)
        return PAUSED;
    const int64_t n = run->problem.words.at[STATES];
    const double *times = run->progress.times.at, last = times[run->progress.times.size - 1];
    const int held = run->constraints.words.at[ACTIVE] == 1;
    const int watched = run->watch.words.at[EVENTS] > 0;
    double loosest = m->rtol.at[0];
    for (int64_t i = 0; i < n; i++)
        loosest = minimum(m->rtol.at[i], loosest);
    const double tolerance =
        maximum(minimum(root(loosest), 0.03), 10.0 * ROUNDING / maximum(ROUNDING, loosest));
    double t = state[TIME], h = state[SIZE];
    int64_t code;
    if (count[STARTED] == 0) {
        hold_inputs(&run->problem, t, 0);
        count[EVALUATIONS] += 1;
        code = rates(&run->problem, t, m->x.at, m->stages.at);
        if (code != 0) {
            count[FAILURE] = SINGULAR;
            return code < 0 ? CALLBACK : STEP_UNDERFLOW;
        }
        count[STARTED] = 1;
        state[LAST_ERROR] = 0.0;
        words[WANTED] = words[FIRST] = 1;
        sizes[PREDICTING] = 0.0;
        if (write_reached(run, m->x.at, flat))
            return FINISHED;
        if (h == 0.0) {
            double slope;
            const double trial = first_trial(m, n, state[LARGEST], &slope);
            h = bounded_first_size(trial, t, state[LARGEST]);
            if (!usable(h))
                count[FAILURE] = NOT_FINITE;
        }
    }
    for (;;) {
        if (count[BUDGET] == 0) {
            state[SIZE] = h;
            return PAUSED;
        }
        if (full(&run->steps)) {
            state[SIZE] = h;
            return STEPS_FULL;
        }
        count[BUDGET] -= 1;
        if (count[STEPS] + count[REJECTED] >= count[LIMIT]) {
            state[SIZE] = h;
            return TOO_MANY_STEPS;
        }
        const double wanted = h, jump = hold_inputs(&run->problem, t, 0), goal = minimum(last, jump);
        double size = minimum(h, state[LARGEST]), after;
        limit_step(t, goal, &size, &after);
        if (!moves(t, size, after, goal)) {
            state[SIZE] = size;
            return STEP_UNDERFLOW;
        }
        if (words[WANTED] == 1) {
            if (set_jacobian(run, t) < 0)
                return CALLBACK;
            words[WANTED] = 0, words[FRESH] = 1, words[FACTORISED] = 0;
        }
        const double rounded = ROUNDING * absolute(after);
        if (words[FACTORISED] == 0 || absolute(size - sizes[FACTORED]) > rounded) {
            count[FACTORISATIONS] += 1;
            if (!factorise_both(newton, size)) {
                count[FAILURE] = NOT_FINITE, count[REJECTED] += 1, h = 0.5 * size;
                words[WANTED] = 1 - words[FRESH], words[FACTORISED] = 0;
                continue;
            }
            words[FACTORISED] = 1, sizes[FACTORED] = size;
        }
        predict(run, size, sizes[PREDICTING]);
        const Settled settled = solve_stages(run, t, size, tolerance, tolerance * loosest);
        if (settled.code < 0)
            return CALLBACK;
        if (!settled.converged) {
            count[REJECTED] += 1;
            count[FAILURE] = is_finite(settled.rate) ? NO_CONVERGENCE : NOT_FINITE;
            if (settled.code != 0)
                count[FAILURE] = SINGULAR;
            if (words[FRESH] == 1 && settled.code == 0) {
                if (forget(newton)) {
                    words[FACTORISED] = 0;
                    continue;
                }
                words[FRESH] = 0; /* a shorter step has its derivatives again */
                h = 0.5 * size;
            }
            if (words[FRESH] == 1 || settled.code != 0) {
                h = settled.code == 0 ? 0.5 * size : AFTER_FAILURE * size;
                sizes[PREDICTING] = 0.0;
            }
            words[WANTED] = 1 - words[FRESH];
            continue;
        }
        for (int64_t i = 0; i < n; i++)
            m->new.at[i] = m->x.at[i] + newton->stages.at[2 * n + i];
        double error;
        code = estimate(run, t, size, words[FIRST] == 1, &error);
        if (code < 0)
            return CALLBACK;
        const double most = 2 * ITERATIONS + 1, taken = (double)(2 * ITERATIONS + settled.iterations);
        const double safety = 0.9 * most / taken, least = maximum(LEAST_ERROR, error);
        double factor = __builtin_pow(least, -0.25);
        if (code != 0 || !(error < 1.0)) {
            count[REJECTED] += 1;
            count[FAILURE] = code == 0 ? STEP_UNDERFLOW : SINGULAR;
            h = is_finite(error) ? size * maximum(safety * factor, 0.2) : AFTER_FAILURE * size;
            words[FIRST] = 1, words[WANTED] = 1 - words[FRESH];
            continue;
        }
        if (held && hold(run, after, m->new.at, m->x.at) != 0) {
            count[REJECTED] += 1;
            count[FAILURE] = CONSTRAINTS_NOT_MET, h = AFTER_FAILURE * size;
            words[FIRST] = 1, words[WANTED] = 1 - words[FRESH];
            continue;
        }
        count[STEPS] += 1;
        if (state[LAST_ERROR] > 0.0) { /* the error changes as it did in the last step */
            const double change = __builtin_pow(state[LAST_ERROR] / least, 0.25);
            factor *= minimum(size / state[LAST_SIZE] * change, 1.0);
        }
        factor = minimum(safety * factor, 10.0);
        state[TIME] = after, state[LAST_SIZE] = size, state[LAST_ERROR] = least;
        set_interpolant(run);
        sizes[PREDICTING] = size;
        keep_step(run, run->method.shape.at[DEPTH], t, size, after);
        const int look = watched && !stays_clear(run, t, size);
        if (look || times[count[NEXT]] <= after) {
            code = finish_step(run, s, t, size, look, flat);
            if (code == UNRESOLVED || (code == CONSTRAINTS_NOT_MET && !watched)) {
                count[STEPS] -= 1;
                run->steps.words.at[KEPT] -= 1;
                words[FIRST] = 1, words[WANTED] = 1 - words[FRESH], sizes[PREDICTING] = 0.0;
                count[REJECTED] += 1;
                count[FAILURE] = code == UNRESOLVED ? STEP_UNDERFLOW : code, h = AFTER_FAILURE * size;
                continue;
            }
            if (code != 0) {
                run->steps.words.at[KEPT] += 1; /* of the step that ends here, the end as well */
                return code;
            }
        }
        t = after;
        for (int64_t i = 0; i < n; i++)
            m->x.at[i] = m->new.at[i];
        release_inputs(&run->problem);
        count[EVALUATIONS] += 1;
        code = rates(&run->problem, t, m->x.at, m->stages.at);
        if (code != 0) {
            count[FAILURE] = SINGULAR;
            state[SIZE] = size;
            return code < 0 ? CALLBACK : STEP_UNDERFLOW;
        }
        const int slow = settled.iterations > 2 && settled.rate > SLOW;
        words[WANTED] = slow, words[FRESH] = 0, words[FIRST] = 0;
        /* the same step size spares a factorisation */
        const int same = 1.0 < factor && factor < 1.2 && !slow;
        h = same ? sizes[FACTORED] : size * maximum(factor, 0.2);
        if (after == jump) /* shortened to end there */
            h = maximum(wanted, h);
        if (count[NEXT] == run->progress.times.size) {
            state[SIZE] = h;
            return FINISHED;
        }
    }
}

/* The same through events after which nothing else is to be done. Where `fresh` is 1 an integration
   begins here. */
int64_t advance_implicit(const Run *run, double *flat, int64_t fresh)
{
    int64_t code;
    if (fresh == 1)
        begin(run, flat);
    do
        code = step_on(run, flat);
    while (goes_on(run, &code));
    release_inputs(&run->problem);
    return code;
}
