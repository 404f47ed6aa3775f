/* The loop around explicit Runge-Kutta steps: step size, outputs, and why it stopped. */

#include "run.h"

/* Guess the first step, with one further evaluation. */
INLINE double guess_first_size(const Run *run, double t)
{
    const Memory *m = &run->memory;
    const int64_t controlled = run->problem.words.at[CONTROLLED];
    const double largest = run->progress.state.at[LARGEST];
    double slope;
    const double trial = first_trial(m, controlled, largest, &slope);
    for (int64_t i = 0; i < run->problem.words.at[STATES]; i++)
        m->trial.at[i] = m->x.at[i] + trial * m->stages.at[i];
    run->progress.counts.at[EVALUATIONS] += 1;
    if (rates(&run->problem, t + trial, m->trial.at, m->stages.at + m->x.size) != 0)
        return SLIVER * trial;
    return first_size(m, run->method.control.at[EXPONENT], controlled, t, largest, trial, slope);
}

/* Tell whether events stay away from zero in the step just taken, in which states do not move CLEAR
   times as fast as at the fastest of its stages. */
INLINE int stays_clear(const Run *run, double t, double h)
{
    const Memory *m = &run->memory;
    const int64_t *words = run->watch.words.at, length = m->x.size;
    double *moved = run->watch.reach.at + words[MOVES];
    if (words[REACHER] == 0)
        return 0;
    for (int64_t i = 0; i < words[MOVING]; i += BLOCK) {
        Block far = sizes(load_block(m->new.at + i) - load_block(m->x.at + i));
        for (int64_t stage = 0; stage <= run->method.shape.at[STAGES]; stage++)
            far = larger(far, h * sizes(load_block(m->stages.at + stage * length + i)));
        store_block(moved + i, CLEAR * far);
    }
    return are_clear(run, t, h);
}

/* Step until the end, or until BUDGET steps are taken, or something else happens. */
INLINE int64_t step_on(const Run *run, double *flat)
{
    const Stepper stepper = STEPPER(run), *s = &stepper;
    const Memory *m = &run->memory;
    double *state = run->progress.state.at, *new = m->new.at;
    int64_t *count = run->progress.counts.at;
    if (count[BUDGET] == 0)
        return PAUSED;
    const double *times = run->progress.times.at, *control = run->method.control.at;
    const int64_t *shape = run->method.shape.at, length = m->x.size;
    const int held = run->constraints.words.at[ACTIVE] == 1, adaptive = shape[ESTIMATES] > 0;
    const int reuse = shape[END_IN_ESTIMATE] == 1, watched = run->watch.words.at[EVENTS] > 0;
    const double last = times[run->progress.times.size - 1], least = LEAST_BOUNDED * (last - times[0]);
    double *end = m->stages.at + shape[STAGES] * length;
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
        state[LAST_ERROR] = FIRST_ERROR, state[GROWTH] = control[GROW];
        if (write_reached(run, m->x.at, flat))
            return FINISHED;
        if (h == 0.0) {
            h = guess_first_size(run, t);
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
        const double wanted = h;
        const double jump = hold_inputs(&run->problem, t, 0);
        /* whole steps between outputs */
        const double goal = minimum(adaptive ? last : times[count[NEXT]], jump);
        double size = adaptive ? minimum(h, state[LARGEST]) : whole_steps(t, h, goal), after;
        limit_step(t, goal, &size, &after);
        if (!moves(t, size, after, goal)) {
            state[SIZE] = size;
            return STEP_UNDERFLOW;
        }
        code = take_step(s, t, size, &count[EVALUATIONS]);
        if (code == 0 && reuse) {
            count[EVALUATIONS] += 1;
            code = rates(&run->problem, after, new, end);
        }
        if (code < 0)
            return CALLBACK;
        double error = 0.0;
        int missed = 0;
        if (code == 0) {
            if (adaptive)
                error = error_of_step(s, least);
            else
                for (int64_t i = 0; i < length; i++)
                    error += 0.0 * new[i]; /* NaN where the state is not finite */
            if (error < 1.0 && (held || !reuse)) {
                missed = held && hold(run, after, new, adaptive ? m->x.at : 0) != 0;
                if (!missed) {
                    count[EVALUATIONS] += 1;
                    code = rates(&run->problem, after, new, end);
                    if (code < 0)
                        return CALLBACK;
                }
            }
        }
        if (missed || code != 0 || !(error < 1.0)) {
            count[REJECTED] += 1;
            const int measured = !missed && code == 0 && is_finite(error);
            count[FAILURE] = measured ? STEP_UNDERFLOW : NOT_FINITE;
            if (missed) /* a shorter step ends nearer to the constraints */
                count[FAILURE] = CONSTRAINTS_NOT_MET;
            if (code != 0)
                count[FAILURE] = SINGULAR;
            h = shorter_size(control, size, error, measured);
            if (measured)
                h = size_to_knot(&run->problem, t, after, h);
            if (!adaptive) {
                state[SIZE] = size;
                return STEP_UNDERFLOW;
            }
            state[GROWTH] = 1.0;
            continue;
        }
        count[STEPS] += 1;
        state[TIME] = after, state[LAST_SIZE] = size;
        keep_step(run, 0, t, size, after);
        const int look = watched && !stays_clear(run, t, size);
        if (!look && times[count[NEXT]] >= after)
            write_reached(run, new, flat);
        else {
            code = prepare_interpolant(s, t, size, &count[EVALUATIONS]);
            if (code != 0) {
                count[FAILURE] = SINGULAR, state[TIME] = t;
                return code < 0 ? CALLBACK : STEP_UNDERFLOW;
            }
            code = finish_step(run, s, t, size, look, flat);
            if (code == UNRESOLVED || (code == CONSTRAINTS_NOT_MET && adaptive && !watched)) {
                count[STEPS] -= 1;
                run->steps.words.at[KEPT] -= 1;
                count[REJECTED] += 1;
                count[FAILURE] = code == UNRESOLVED ? STEP_UNDERFLOW : code, state[GROWTH] = 1.0;
                h = shorter_size(control, size, error, 0);
                continue;
            }
            if (code != 0) {
                run->steps.words.at[KEPT] += 1; /* of the step that ends here, the end as well */
                return code;
            }
        }
        if (adaptive) {
            h = next_size(control, size, error, state[LAST_ERROR], state[GROWTH]);
            if (state[GROWTH] == 1.0)
                h = size_from_knot(&run->problem, t, after, h,
                    next_size(control, size, error, state[LAST_ERROR], control[GROW]));
            if (after == goal) /* shortened to end there: who goes on wants the longer one */
                h = maximum(wanted, h);
            state[LAST_ERROR] = maximum(error, FIRST_ERROR), state[GROWTH] = control[GROW];
        }
        t = after;
        for (int64_t i = 0; i < length; i++) {
            m->x.at[i] = new[i];
            m->stages.at[i] = end[i];
        }
        if (count[NEXT] == run->progress.times.size) {
            state[SIZE] = h;
            return FINISHED;
        }
        if (after == jump) {
            release_inputs(&run->problem);
            count[EVALUATIONS] += 1;
            code = rates(&run->problem, t, m->x.at, m->stages.at);
            if (code != 0) {
                count[FAILURE] = SINGULAR, state[SIZE] = h;
                return code < 0 ? CALLBACK : STEP_UNDERFLOW;
            }
        }
    }
}

/* The same through events after which nothing else is to be done. Where `fresh` is 1 an integration
   begins here; Python looks at its events at both ends only where they may happen there. */
ENTRY int64_t advance(const Run *run, double *flat, int64_t fresh)
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
