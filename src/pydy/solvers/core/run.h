/* What every stepper of one trajectory does around its steps: begin, keep the steps that dense
   output is made of, look for events, hold constraints and write the outputs due. */

#ifndef RUN_H
#define RUN_H

#include "step.h"
#include "departure.h"

#ifndef ENTRY
#define ENTRY /* what is called from outside */
#endif

#define UNKNOWN (0.0 / 0.0)
#define STEPPER(run) {&(run)->method, &(run)->problem, &(run)->memory}

/* Tell whether a step that ended with a code is followed by others: after an event that has acted. The
   code may become that with which the integration ends there. */
INLINE int goes_on(const Run *run, int64_t *code)
{
    const int64_t act = run->watch.words.at[ACT];
    if (*code != EVENT || act == 0)
        return 0;
    const int64_t told = ((Act *)act)(run);
    if (told == EVENTS_ACCUMULATE)
        *code = told;
    return told == ACTED;
}

INLINE int64_t hold(const Run *run, double t, double *x, const double *from)
{
    return ((Project *)run->constraints.words.at[PROJECT])(run, t, x, from);
}

/* Evaluate the events at the state, into the first row of watch.values, and their rates with bounds on
   roundings, into watch.told. Not where inputs or the kernel may jump at its time: Python looks there. */
INLINE int know_events(const Run *run)
{
    const Watch *w = &run->watch;
    const Problem *p = &run->problem;
    if (p->tables.size > 0 || p->words.at[SWITCHED])
        return 0;
    p->clock.at[0] = run->progress.state.at[TIME];
    call_kernel(w->words.at[WATCHER], p->clock.at, run->memory.x.at, p->r.at, w->c.at, w->values.at);
    call_kernel(w->words.at[RATER], p->clock.at, run->memory.x.at, p->r.at, w->rates_c.at, w->told.at);
    return 1;
}

/* Give the events their sides at the start; tell whether none is on its surface there, but for what turns,
   which does not happen at a start. */
INLINE int starts_clear(const Run *run)
{
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    if (number == 0)
        return 1;
    if (!know_events(run))
        return 0;
    for (int64_t k = 0; k < number; k++) {
        const double value = w->values.at[k], told = value == 0.0 ? w->told.at[k] : value;
        if (is_on_surface(value, w->told.at[number + k]) && !(w->kinds.at[k] & TURNS))
            return 0;
        w->sides.at[k] = is_finite(told) ? sign_of(told) : 0, w->fired.at[k] = 0;
    }
    return 1;
}

/* Tell whether no event happens at the end, or would be a rounding of the time later. */
INLINE int ends_clear(const Run *run)
{
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    const double near = 2.0 * ROUNDING * absolute(run->progress.state.at[TIME]);
    if (number == 0)
        return 1;
    if (!know_events(run))
        return 0;
    for (int64_t k = 0; k < number; k++) {
        const double distance = w->values.at[k] * (double)w->sides.at[k];
        if (!(distance > near * absolute(w->told.at[k]) || distance < 0.0)) /* what turns may have done so */
            return 0;
    }
    return 1;
}

/* Begin an integration, from the state in the first row of the results; tell whether it goes on without
   Python. */
INLINE int begin(const Run *run, const double *flat)
{
    for (int64_t i = 0; i < run->problem.words.at[STATES]; i++)
        run->memory.x.at[i] = flat[i];
    for (int64_t i = 0; i < run->progress.state.size; i++)
        run->progress.state.at[i] = run->beginning.state.at[i];
    for (int64_t i = 0; i < run->progress.counts.size; i++)
        run->progress.counts.at[i] = run->beginning.counts.at[i];
    if (run->watch.words.at[EVENTS] > 0)
        run->watch.values.at[PROBES * run->watch.words.at[EVENTS]] = UNKNOWN;
    return run->progress.counts.at[BUDGET] > 0 && starts_clear(run);
}

/* -- the steps that are kept ------------------------------------------------------------------- */

/* Tell whether there is no room for a step that an event ends. */
INLINE int full(const Steps *steps)
{
    const int64_t room = steps->words.at[ROOM];
    return room > 0 && room < steps->words.at[KEPT] + 3;
}

/* Keep an accepted step, with `depth` vectors of its interpolant, and its end. */
INLINE void keep_step(const Run *run, int64_t depth, double t, double h, double after)
{
    const Steps *steps = &run->steps;
    const Memory *m = &run->memory;
    if (steps->words.at[ROOM] == 0)
        return;
    const int64_t k = steps->words.at[KEPT], n = run->problem.words.at[STATES];
    double *row = steps->rows.at + k * steps->rows.columns, *end = row + steps->rows.columns;
    row[0] = t, row[1] = h, end[0] = after, end[1] = 0.0;
    for (int64_t i = 0; i < n; i++) {
        row[2 + i] = m->x.at[i], end[2 + i] = m->new.at[i];
        for (int64_t j = 0; j < depth; j++)
            row[2 + (1 + j) * n + i] = m->interpolant.at[j * m->x.size + i];
    }
    steps->words.at[KEPT] = k + 1;
}

/* -- outputs ----------------------------------------------------------------------------------- */

/* Write the outputs wanted at the state's time or before; tell whether those are all. */
INLINE int write_reached(const Run *run, const double *x, double *flat)
{
    const int64_t n = run->problem.words.at[STATES], count = run->progress.times.size;
    const double *times = run->progress.times.at;
    int64_t k = run->progress.counts.at[NEXT];
    for (; k < count && times[k] <= run->progress.state.at[TIME]; k++)
        for (int64_t i = 0; i < n; i++)
            flat[k * n + i] = x[i];
    run->progress.counts.at[NEXT] = k;
    return k == count;
}

/* Write the outputs within the step, and those at the `end` if that is `inside` too. */
INLINE int64_t interpolate_outputs(const Run *run, const Stepper *s, double t, double h, double end,
    int inside, double *flat)
{
    const int64_t n = run->problem.words.at[STATES], count = run->progress.times.size;
    const double *times = run->progress.times.at;
    int64_t k = run->progress.counts.at[NEXT];
    for (; k < count && (times[k] < end || (times[k] == end && inside)); k++) {
        interpolate(s, (times[k] - t) / h, flat + k * n);
        if (run->constraints.words.at[ACTIVE] == 1) {
            const int64_t code = hold(run, times[k], flat + k * n, 0);
            if (code != 0)
                return code;
        }
    }
    run->progress.counts.at[NEXT] = k;
    return 0;
}

/* Tell whether events stay away from zero in a step in which states move by what `watch.reach` says. */
INLINE int are_clear(const Run *run, double t, double h)
{
    const Watch *w = &run->watch;
    const double *clock = run->problem.clock.at;
    const int64_t number = w->words.at[EVENTS];
    double *values = w->values.at + DIVIDED * number; /* and the row behind it */
    w->reach.at[w->words.at[MOVES] + w->words.at[MOVING]] = h, run->problem.clock.at[0] = t;
    if (call_kernel(w->words.at[REACHER], clock, run->memory.x.at, w->reach.at, w->reach_c.at, values) != 0)
        return 0;
    for (int64_t k = 0; k < number; k++)
        if (!(w->kinds.at[k] & TURNS) && !(values[k] * (double)w->sides.at[k] > values[number + k]))
            return 0;
    return 1;
}

/* `Look` for events, then write the outputs due, up to the event that ends the step if one does.

   Not zero: why the integration stops here, or the step is too long. It is ready to start again, at the event if it was
   one, where memory.x then is the state. */
INLINE int64_t finish_step(const Run *run, const Stepper *s, double t, double h, int look, double *flat)
{
    const Memory *m = &run->memory;
    double *state = run->progress.state.at, theta = 1.0;
    int64_t status = 0;
    if (look) {
        status = ((Scan *)run->watch.words.at[SCAN])(run, t, h);
        if (status == UNRESOLVED) {
            state[TIME] = t;
            return status;
        }
        theta = state[FOUND];
    }
    const double end = theta == 1.0 ? state[TIME] : t + theta * h;
    int64_t code = status == CALLBACK ? status : 0;
    if (code == 0)
        code = interpolate_outputs(run, s, t, h, end, theta < 1.0, flat);
    if (code == 0 && status != 0 && theta < 1.0) {
        interpolate(s, theta, m->trial.at);
        for (int64_t i = 0; i < m->x.size; i++)
            m->new.at[i] = m->trial.at[i];
        if (run->constraints.words.at[ACTIVE] == 1)
            code = hold(run, end, m->new.at, 0);
    }
    if (code != 0) {
        state[TIME] = t, state[SIZE] = h;
        return code;
    }
    if (theta == 1.0)
        write_reached(run, m->new.at, flat);
    if (status != 0) {
        for (int64_t i = 0; i < m->x.size; i++)
            m->x.at[i] = m->new.at[i];
        state[TIME] = end, state[SIZE] = 0.0, run->progress.counts.at[STARTED] = 0;
    }
    return status;
}

#endif
