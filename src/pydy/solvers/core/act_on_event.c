/* A reset by a single event, as `Integration._act` does it, without a return to Python. Lanes call it
   too, from `act_alone` of `step_lanes.c`. */

#include "run.h"
#include "departure.h"

/* Change the state at the event that has just ended a step: ACTED, or EVENTS_ACCUMULATE where it has
   followed itself ever faster, or LEFT.

   Python has to see to what is not as simple: several events at once, those that this one sets going
   from zero, and errors. Then nothing has changed. */
int64_t act_on_event(const Run *run)
{
    const Watch *w = &run->watch;
    const Problem *p = &run->problem;
    const double *times = run->progress.times.at, span = times[run->progress.times.size - 1] - times[0];
    const int64_t number = w->words.at[EVENTS], width = p->words.at[STATES];
    const int64_t n = p->words.at[CONTROLLED]; /* what only bounds the steps goes on as it is */
    const int64_t line = run->progress.counts.at[LOGGED];
    double *x = run->memory.x.at, *state = run->progress.state.at, *after = w->after.at;
    const double t = state[TIME];
    double *was = w->values.at + DIVIDED * number, *values = w->values.at + LOCATED * number;
    const double *rates = w->told.at, *bounds = rates + number;
    int64_t event = -1;
    for (int64_t k = 0; k < number; k++)
        if (w->fired.at[k] > 0) {
            if (event >= 0)
                return LEFT;
            event = k;
        }
    if (event < 0 || !(w->kinds.at[event] & RESETS) || line + 1 + number > w->log_times.size)
        return LEFT;
    const double *row = after + event * n;
    set_inputs(p, t);
    if (call_kernel(w->words.at[RESETTER], p->clock.at, x, p->r.at, w->resets_c.at, after) != 0
        || call_kernel(w->words.at[WATCHER], p->clock.at, x, p->r.at, w->c.at, was) != 0
        || call_kernel(w->words.at[WATCHER], p->clock.at, row, p->r.at, w->c.at, values) != 0
        || call_kernel(w->words.at[RATER], p->clock.at, row, p->r.at, w->rates_c.at, w->told.at) != 0)
        return LEFT;
    for (int64_t i = 0; i < n; i++)
        if (!is_finite(row[i]))
            return LEFT;
    for (int64_t k = 0; k < number; k++) {
        if (k == event)
            continue;
        if (w->sides.at[k] != 0 && values[k] != values[k])
            return LEFT;
        /* zero, and perhaps set going by this reset */
        if (w->acting.at[k] == 1 && values[k] == was[k] && rates[k] * (double)w->directions.at[k] >= 0.0
            && rates[k] != 0.0 && is_on_surface(values[k], bounds[k]))
            return LEFT;
    }
    /* whether the reset leads away from zero, or the rate tells the side */
    const double value = values[event];
    const int left = value != was[event] && !is_on_surface(value, bounds[event]);
    /* a reset that does not turn the motion back may leave it at rest on the surface */
    if (!left && w->directions.at[event] != 0 && w->kinds.at[event] & REDIRECTS && !(rates[event] * (double)w->sides.at[event] > 0.0))
        return LEFT;
    /* a rebound as low as roundings: there, a crossing does not tell when it ends */
    const double flight = t - w->latest.at[event * CROWD], lowest = LOW * ROUNDINGS * ROUNDING * bounds[event];
    if (!left && w->kinds.at[event] & REDIRECTS && absolute(rates[event]) * flight <= lowest)
        return LEFT;
    for (int64_t k = 0; k < number; k++) {
        const int stays = values[k] == was[k] || is_on_surface(values[k], bounds[k]);
        const int by_rate = values[k] == 0.0 || (k == event && !left) || (w->fired.at[k] < 0 && stays);
        const double told = by_rate ? rates[k] : values[k];
        w->sides.at[k] = is_finite(told) ? sign_of(told) : 0;
    }
    w->log_times.at[line] = t;
    w->log_events.at[line] = event;
    for (int64_t i = 0; i < n; i++) {
        w->log_states.at[line * width + i] = x[i];
        w->log_after.at[line * width + i] = x[i] = row[i];
    }
    run->progress.counts.at[LOGGED] = line + 1;
    if (run->method.shape.at[ESTIMATES] == 0)
        state[SIZE] = run->beginning.state.at[SIZE]; /* that of all steps, or the solver's own */
    double *latest = w->latest.at + event * CROWD;
    const int crowded = t - latest[0] <= NO_LATER * ROUNDING * maximum(absolute(t), span)
        || t - latest[CROWD - 2] < CROWDED * span;
    for (int64_t k = CROWD - 1; k > 0; k--)
        latest[k] = latest[k - 1];
    latest[0] = t;
    return crowded ? EVENTS_ACCUMULATE : ACTED;
}
