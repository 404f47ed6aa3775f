/* Events: signs of their expressions are compared along the interpolant of each step. */

#include "run.h"

enum { PARTS = 4 };

enum { BACK = 2 }; /* located, though it has the sign again that it began with */

/* The rows of watch.values: the end of a part that a dip divides, a located event, and the ends of the
   parts of the step, from its start on. Behind them is the time at which the start is known. */
enum { DIVIDED, LOCATED, QUARTERS };

enum { TRIES = 20 }; /* parabolas for a least value: a few lead to it where it is smooth */

/* Evaluate all event expressions at t + theta h into a row of watch.values. */
INLINE int64_t probe(const Run *run, const Stepper *s, double t, double h, double theta, int64_t row)
{
    const Watch *w = &run->watch;
    const Problem *p = &run->problem;
    interpolate(s, theta, w->trial.at);
    set_inputs(p, t + theta * h);
    return call_kernel(w->words.at[WATCHER], p->clock.at, w->trial.at, p->r.at, w->c.at,
        w->values.at + row * w->words.at[EVENTS]);
}

INLINE int crossed(int64_t side, double value, int64_t direction)
{
    return (side < 0 && value > 0.0 && direction >= 0) || (side > 0 && value < 0.0 && direction <= 0);
}

/* Tell whether an event that had a sign has none any more. */
INLINE int lost(int64_t side, double value) { return side != 0 && value != value; }

/* Return the theta just past the crossing of one event between `low` and `high`, or where it is NaN
   first, by bisection.

   Beside `low` the event may still be zero or on the wrong side, where it has just been handled:
   then a point on the right side is looked for between them, and `low` is returned without one. */
APART double locate(const Run *run, const Stepper *s, double t, double h, double low, double high,
    int64_t event)
{
    const double side = (double)run->watch.sides.at[event];
    const double *value = run->watch.values.at + LOCATED * run->watch.words.at[EVENTS] + event;
    const double resolution = ROUNDING * maximum(absolute(t + h), absolute(t)) / h;
    probe(run, s, t, h, low, LOCATED);
    if (*value * side <= 0.0) {
        const double start = low;
        for (double middle = high;;) {
            middle = start + 0.5 * (middle - start);
            if (middle - start < resolution)
                return start;
            probe(run, s, t, h, middle, LOCATED);
            if (*value * side > 0.0) {
                low = middle;
                break;
            }
            high = middle;
        }
    }
    while (high - low > resolution) {
        const double middle = low + 0.5 * (high - low);
        if (middle == low || middle == high)
            break;
        probe(run, s, t, h, middle, LOCATED);
        if (*value * side > 0.0)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* Stop for a Python function that raised something: the step's events are looked for again. */
INLINE int64_t called_back(const Run *run, int64_t logged)
{
    run->progress.counts.at[LOGGED] = logged, run->progress.state.at[FOUND] = 1.0;
    return CALLBACK;
}

/* Note an event, where a log is kept. */
INLINE void log_event(const Run *run, double t, int64_t event)
{
    const Watch *w = &run->watch;
    const int64_t line = run->progress.counts.at[LOGGED], n = run->problem.words.at[STATES];
    if (w->log_times.size == 0)
        return;
    w->log_times.at[line] = t;
    w->log_events.at[line] = event;
    for (int64_t i = 0; i < n; i++)
        w->log_states.at[line * w->log_states.columns + i] = w->trial.at[i];
    run->progress.counts.at[LOGGED] = line + 1;
}

/* Where an expression is fitted, at quarters of a step, and where it is compared with the fit between
   them: no oscillation looks slow at all of these, whose ratios are irrational. */
static const double PLACES[SAMPLES] = {0.0, 0.25 * 0.3819660112501051, 0.25, 0.25 * 1.4142135623730951, 0.5,
    0.25 * 2.4494897427831781, 0.75, 0.25 * 3.6457513110645906, 1.0};

/* Return the polynomial through the samples at quarters. */
INLINE double fit(const double *samples, int64_t apart, double place)
{
    double value = 0.0;
    for (int k = 0; k < SAMPLES; k += 2) {
        double weight = 1.0;
        for (int i = 0; i < SAMPLES; i += 2)
            if (i != k)
                weight *= (place - PLACES[i]) / (PLACES[k] - PLACES[i]);
        value += weight * samples[k * apart];
    }
    return value;
}

/* Tell whether an expression may cross zero and return within a quarter of the step.

   As far as it is known, to `error`, it may between samples that are near zero and near each other. It
   does where it has another sign than at the quarters around, beyond `rounding`. */
INLINE int may_return(const double *samples, int64_t apart, double error, double rounding)
{
    for (int j = 1; j < SAMPLES; j++) {
        const double a = samples[(j - 1) * apart], b = samples[j * apart];
        const double nearest = minimum(absolute(a), absolute(b));
        if (a * b >= 0.0 && error > rounding && nearest <= error && absolute(a - b) <= 2.0 * error)
            return 1;
        if (j + 1 == SAMPLES)
            return 0;
        const double c = samples[(j + 1) * apart], side = a + c < 0.0 ? -1.0 : 1.0;
        if (j % 2 && a * c >= 0.0 && side * b < -rounding)
            return 1;
    }
    return 0;
}

/* Tell whether the step is too long for what time changes beside the states: the error control,
   which sees these alone, lets a step of free flight be as long as one likes above a floor that
   oscillates.

   A jump is not resolved by any step, and passes once the step is as short as times can be told. */
APART int64_t unresolved(const Run *run, const Stepper *s, double t, double h)
{
    const Watch *w = &run->watch;
    const Problem *p = &run->problem;
    const int64_t apart = w->driven.columns, number = apart / 2;
    const double span = run->progress.times.at[run->progress.times.size - 1] - run->progress.times.at[0];
    if (h <= INSTANT * ROUNDING * maximum(absolute(t + h), span))
        return 0;
    for (int j = 0; j < SAMPLES; j++) {
        interpolate(s, PLACES[j], w->trial.at);
        set_inputs(p, t + PLACES[j] * h);
        if (call_kernel(w->words.at[DRIVER], p->clock.at, w->trial.at, p->r.at, w->driven_c.at,
                w->driven.at + j * apart)
            < 0)
            return CALLBACK;
    }
    for (int64_t k = 0; k < number; k++) {
        const double *samples = w->driven.at + k;
        double size = 0.0, bound = 0.0, error = 0.0;
        for (int j = 0; j < SAMPLES; j++) {
            size = maximum(size, absolute(samples[j * apart]));
            bound = maximum(bound, samples[j * apart + number]);
            if (j % 2)
                error = maximum(error, absolute(samples[j * apart] - fit(samples, apart, PLACES[j])));
        }
        const double rounding = ROUNDINGS * ROUNDING * bound;
        if (may_return(samples, apart, error > HALF * size ? 2.0 * error : 0.0, rounding))
            return UNRESOLVED;
    }
    return 0;
}

/* Return a place between three, at which an event is positive times `side`, where it is not, or 2, or
   CALLBACK: its least value is sought by parabolas, until it is surely positive. Where that is
   negative by a rounding of the three, it only touches zero.

   References: R. P. Brent, Algorithms for minimization without derivatives, 1973, chapter 5. */
APART double least_place(const Run *run, const Stepper *s, double t, double h, int64_t event, double side,
    double a, const double *values)
{
    const double *value = run->watch.values.at + DIVIDED * run->watch.words.at[EVENTS] + event;
    double b = a + 1.0 / PARTS, c = b + 1.0 / PARTS, za = values[0], zb = values[1], zc = values[2];
    double error = 1.0 / 0.0;
    const double rounding = ROUNDINGS * ROUNDING * maximum(za, maximum(zb, zc));
    for (int tries = 0; tries < TRIES; tries++) {
        const double left = (zb - za) / (b - a), right = (zc - zb) / (c - b);
        const double bend = (right - left) / (c - a), slope = left + bend * (b - a);
        double place = b - 0.5 * slope / bend;
        if (!(bend > 0.0 && zb + 0.5 * slope * (place - b) <= 2.0 * error))
            return 2.0;
        if (place <= a || place >= c) /* near an end of the step, as far as is known */
            place = 0.5 * (b + (place <= a ? a : c));
        const double guess = zb + (slope + bend * (place - b)) * (place - b);
        if (!(place > a && place < c) || place == b)
            return 2.0;
        if (probe(run, s, t, h, place, DIVIDED) < 0)
            return CALLBACK;
        const double z = side * *value;
        if (z < 0.0)
            return z < -rounding ? place : 2.0;
        error = absolute(z - guess);
        if (place < b && z <= zb)
            c = b, zc = zb, b = place, zb = z;
        else if (place < b)
            a = place, za = z;
        else if (z <= zb)
            a = b, za = zb, b = place, zb = z;
        else
            c = place, zc = z;
    }
    return 2.0;
}

/* Return the first place beyond `left` in a part of the step where an event has another sign than at
   both ends of it, or 2, or CALLBACK: but not where it has that sign still when one happens that acts, as the
   direction of a velocity changes when this passes zero. */
INLINE double find_dip(const Run *run, const Stepper *s, double t, double h, double left, int part)
{
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    const double *divided = w->values.at + DIVIDED * number, *ends = divided + (QUARTERS + part) * number;
    double first = 2.0, acts = 2.0;
    for (int64_t k = 0; k < number; k++) {
        const double *values = w->values.at + QUARTERS * number + k, side = (double)w->sides.at[k];
        for (int i = part < 2 ? 1 : part - 1; i <= part && i < PARTS; i++) {
            double z[3], middle = (double)i / PARTS;
            for (int j = 0; j < 3; j++)
                z[j] = side * values[(i - 1 + j) * number];
            if (!(z[0] > 0.0 && z[1] > 0.0 && z[2] > 0.0))
                continue;
            const double slope = 0.5 * (z[2] - z[0]), bend = z[2] - 2.0 * z[1] + z[0];
            const double place = PARTS * middle - slope / bend; /* in parts; beyond an end it may err */
            if (!(bend > 0.0 && place >= part - 1 - (part == 1) && place <= part + (part == PARTS)))
                continue;
            const double found = least_place(run, s, t, h, k, side, middle - 1.0 / PARTS, z);
            if (found == CALLBACK)
                return CALLBACK;
            if (!(found > left && found < minimum(first, (double)part / PARTS)))
                continue;
            for (int64_t l = 0; l < number; l++)
                if (w->acting.at[l] == 1 && crossed(w->sides.at[l], ends[l], w->directions.at[l]))
                    acts = minimum(acts, locate(run, s, t, h, left, (double)part / PARTS, l));
            if (acts <= 1.0 && probe(run, s, t, h, acts, DIVIDED) < 0)
                return CALLBACK;
            if (acts > 1.0 || side * divided[k] > 0.0)
                first = found;
        }
    }
    return first;
}

/* Look for events in the step just taken.

   Returns EVENT when an acting event ends it, LOG_FULL when the log has to be emptied, CALLBACK
   when a Python function raised something, EVENT_UNDEFINED where an expression that had a sign becomes
   NaN, UNRESOLVED when the step has to be shorter, or 0; state[FOUND] is the theta up to which the step
   counts. */
ENTRY int64_t scan_events(const Run *run, double t, double h)
{
    const Stepper stepper = STEPPER(run), *s = &stepper;
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    const int64_t *directions = w->directions.at;
    int64_t *sides = w->sides.at, *fired = w->fired.at, *counts = run->progress.counts.at;
    const int64_t logged = counts[LOGGED];
    double left = 0.0, *state = run->progress.state.at;
    double *quarters = w->values.at + QUARTERS * number, *known = w->values.at + PROBES * number;
    const double *located = w->values.at + LOCATED * number;
    if (w->driven.size > 0) {
        const int64_t code = unresolved(run, s, t, h);
        if (code == CALLBACK)
            return called_back(run, logged);
        if (code != 0)
            return code;
    }
    for (int part = *known == t; part <= PARTS; part++)
        if (probe(run, s, t, h, (double)part / PARTS, QUARTERS + part) < 0)
            return called_back(run, logged);
    *known = UNKNOWN;
    for (int part = 1; part <= PARTS; part += left == (double)part / PARTS) {
        double right = (double)part / PARTS;
        const double *values = quarters + part * number, dip = find_dip(run, s, t, h, left, part);
        if (dip < 0.0)
            return called_back(run, logged);
        if (dip < right) {
            right = dip, values = w->values.at + DIVIDED * number;
            if (probe(run, s, t, h, right, DIVIDED) < 0)
                return called_back(run, logged);
        }
        for (;;) {
            double first = 2.0;
            int ends = 0; /* whether the first event acts */
            for (int64_t k = 0; k < number; k++) {
                fired[k] = 0;
                if (crossed(sides[k], values[k], directions[k]) || lost(sides[k], values[k])) {
                    const double theta = locate(run, s, t, h, left, right, k);
                    fired[k] = theta <= left;
                    if (theta < first)
                        ends = 0;
                    if (theta <= first)
                        ends = ends || w->acting.at[k] == 1;
                    first = minimum(theta, first);
                }
            }
            if (first > 1.0)
                break;
            if (probe(run, s, t, h, first, LOCATED) < 0)
                return called_back(run, logged);
            /* where one is noted, another may have crossed that is back at `right` */
            for (int64_t k = 0; k < number && !ends; k++)
                if (crossed(sides[k], located[k], directions[k])
                    && !crossed(sides[k], values[k], directions[k])) {
                    const double theta = locate(run, s, t, h, left, first, k);
                    if (theta > left)
                        first = theta, fired[k] = BACK;
                    if (probe(run, s, t, h, first, LOCATED) < 0)
                        return called_back(run, logged);
                }
            int acting = 0;
            int64_t undefined = -1;
            for (int64_t k = 0; k < number; k++) {
                const double now = located[k];
                int here = crossed(sides[k], now, directions[k]);
                /* exactly zero at its own root, or handled at `left` and left again */
                if (!here && crossed(sides[k], values[k], directions[k]))
                    here = now == 0.0 || fired[k] == 1;
                here = here || (fired[k] == BACK && now == 0.0);
                if (!here && lost(sides[k], values[k])) {
                    if ((double)sides[k] * now < 0.0) /* first it crosses as nobody asked for */
                        sides[k] = -sides[k];
                    else if (now == 0.0 || now != now)
                        undefined = k;
                }
                fired[k] = here;
                acting = acting || (here && w->acting.at[k] == 1);
            }
            if (acting) {
                state[FOUND] = first;
                return EVENT;
            }
            for (int64_t k = 0; k < number; k++) {
                if (fired[k] == 0)
                    continue;
                log_event(run, t + first * h, k);
                sides[k] = -sides[k];
            }
            if (undefined >= 0) {
                for (int64_t k = 0; k < number; k++)
                    fired[k] = k == undefined;
                state[FOUND] = first;
                return EVENT_UNDEFINED;
            }
            if (w->log_times.size > 0 && counts[LOGGED] + number > w->log_times.size) {
                state[FOUND] = first;
                return LOG_FULL;
            }
            left = first;
        }
        for (int64_t k = 0; k < number; k++) {
            if (values[k] > 0.0)
                sides[k] = 1;
            else if (values[k] < 0.0)
                sides[k] = -1;
        }
        left = right;
    }
    for (int64_t k = 0; k < number; k++)
        quarters[k] = quarters[PARTS * number + k];
    *known = state[TIME];
    state[FOUND] = 1.0;
    return 0;
}
