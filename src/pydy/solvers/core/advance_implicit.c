/* Radau IIA of order 5 for stiff systems: one trajectory. */

#include "newton.h"
#include "run.h"

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
    double *state = run->progress.state.at;
    int64_t *count = run->progress.counts.at;
    if (count[BUDGET] == 0)
        return PAUSED;
    const int64_t n = run->problem.words.at[STATES];
    const double *times = run->progress.times.at, last = times[run->progress.times.size - 1];
    const double least = LEAST_BOUNDED * (last - times[0]);
    const Implicit implicit = implicit_of(&run->problem, m, newton, least), *method = &implicit;
    const int held = run->constraints.words.at[ACTIVE] == 1;
    const int watched = run->watch.words.at[EVENTS] > 0;
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
        begin_newton(newton, 1);
        if (write_reached(run, m->x.at, flat))
            return FINISHED;
        if (h == 0.0) {
            double slope;
            const double trial = first_trial(m, run->problem.words.at[CONTROLLED], state[LARGEST], &slope);
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
        const Attempt a = try_step(method, t, h, size, after, 1);
        count[EVALUATIONS] += (int64_t)a.evaluations;
        count[JACOBIANS] += a.jacobians, count[FACTORISATIONS] += a.factorisations;
        if (a.broken != 0)
            return CALLBACK;
        h = a.next;
        if (a.good == 0) {
            count[REJECTED] += 1, count[FAILURE] = (int64_t)a.reason;
            if (a.error >= 1.0 && is_finite(a.error))
                h = size_to_knot(&run->problem, t, after, h);
            continue;
        }
        if (held && hold(run, after, m->new.at, m->x.at) != 0) {
            count[REJECTED] += 1;
            count[FAILURE] = CONSTRAINTS_NOT_MET, h = AFTER_FAILURE * size;
            undo(newton, 1);
            continue;
        }
        count[STEPS] += 1;
        state[TIME] = after, state[LAST_SIZE] = size;
        accept(method, size, 1, &a);
        keep_step(run, run->method.shape.at[DEPTH], t, size, after);
        const int look = watched && !stays_clear(run, t, size);
        if (look || times[count[NEXT]] <= after) {
            code = finish_step(run, s, t, size, look, flat);
            if (code == UNRESOLVED || (code == CONSTRAINTS_NOT_MET && !watched)) {
                count[STEPS] -= 1;
                run->steps.words.at[KEPT] -= 1;
                undo(newton, 1);
                count[REJECTED] += 1;
                count[FAILURE] = code == UNRESOLVED ? STEP_UNDERFLOW : code, h = AFTER_FAILURE * size;
                continue;
            }
            if (code != 0) {
                run->steps.words.at[KEPT] += 1; /* of the step that ends here, the end as well */
                return code;
            }
        }
        if (a.again != 0)
            h = size_from_knot(&run->problem, t, after, h, h);
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
        if (after == jump) /* shortened to end there */
            h = maximum(wanted, h);
        if (count[NEXT] == run->progress.times.size) {
            state[SIZE] = h;
            return FINISHED;
        }
    }
}

/* The same through events after which nothing else is to be done. Where `fresh` is 1 an integration
   begins here; Python looks at its events at both ends only where they may happen there. */
int64_t advance_implicit(const Run *run, double *flat, int64_t fresh)
{
    int64_t code;
    if (fresh == 1 && !begin(run, flat))
        return START_EVENTS;
    do
        code = step_on(run, flat);
    while (goes_on(run, &code));
    release_inputs(&run->problem);
    return code == FINISHED && fresh == 1 && !ends_clear(run) ? END_EVENTS : code;
}
