/* Events: signs of their expressions are compared along the interpolant of each step. */

#include "run.h"

/* What is noted of events in watch.fired, besides 0 and 1: located, though it has the sign again that it
   began with; and on its way to its side of zero, where it has not been since it was handled. */
enum { BACK = 2, DEPARTS = -1 };

#define NOWHERE 2.0 /* a theta beyond the step */

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

/* Tell whether an event moves away from zero, to its side, by its rate at t + theta h. */
INLINE int moves_off(const Run *run, const Stepper *s, double t, double h, double theta, int64_t event)
{
    const Watch *w = &run->watch;
    const Problem *p = &run->problem;
    interpolate(s, theta, w->trial.at);
    set_inputs(p, t + theta * h);
    return call_kernel(w->words.at[RATER], p->clock.at, w->trial.at, p->r.at, w->rates_c.at, w->told.at) == 0
        && w->told.at[event] * (double)w->sides.at[event] > 0.0;
}

/* Look for a place where an event is on its side, from `low` on, and move `low` there, and `high` to
   the nearest place behind it where it is not, as at `high`. Tell whether there is one.

   Beside `low` the event may still be zero or on the wrong side, where it has just been handled. */
APART int comes_to_side(const Run *run, const Stepper *s, double t, double h, double *low, double *high,
    double resolution, int64_t event)
{
    const double side = (double)run->watch.sides.at[event], start = *low;
    const double *value = run->watch.values.at + LOCATED * run->watch.words.at[EVENTS] + event;
    probe(run, s, t, h, start, LOCATED);
    if (!(*value * side <= 0.0))
        return 1;
    for (double middle = *high;;) {
        middle = start + 0.5 * (middle - start);
        if (middle - start < resolution)
            return 0;
        probe(run, s, t, h, middle, LOCATED);
        if (*value * side > 0.0) {
            *low = middle;
            return 1;
        }
        *high = middle;
    }
}

/* Return where an event happens that is not on its side anywhere from `low` to `high`: at `low`, where
   it moves towards zero or stays there; else where it turns; NOWHERE if it moves to its side all along,
   from where rounding has left it. A crossing has a rate towards the other side, or none. */
APART double turning_place(const Run *run, const Stepper *s, double t, double h, double low, double high,
    double resolution, int64_t event)
{
    double turned = NOWHERE;
    for (double place = high;; place = low + 0.5 * (place - low)) {
        const int off = moves_off(run, s, t, h, place, event);
        if (!off)
            turned = place;
        if (0.5 * (place - low) < resolution) /* a reset where it still moves off would send it back */
            return off || moves_off(run, s, t, h, low, event) ? turned : low;
    }
}

/* Tell whether a crossing at t + theta h is one of roundings: the value there is zero as far as they tell,
   and the event moves to its side. What moves a driven event is not known here. */
INLINE int is_rounded(const Run *run, const Stepper *s, double t, double h, double theta, double value,
    int64_t event)
{
    const Watch *w = &run->watch;
    return !(w->kinds.at[event] & DRIVEN) && moves_off(run, s, t, h, theta, event)
        && is_on_surface(value, w->told.at[w->words.at[EVENTS] + event]);
}

INLINE double resolution_of(double t, double h) { return ROUNDING * maximum(absolute(t + h), absolute(t)) / h; }

/* Return the theta just past the crossing of one event between `low` and `high`, or where it is NaN
   first, by bisection; or that of `turning_place`, beyond crossings of roundings. A reset at one of these
   would send the motion back through the surface that it has just left. */
APART double locate(const Run *run, const Stepper *s, double t, double h, double low, double high,
    int64_t event)
{
    const double side = (double)run->watch.sides.at[event], resolution = resolution_of(t, h);
    const double *value = run->watch.values.at + LOCATED * run->watch.words.at[EVENTS] + event;
    const double last = high;
    if (!comes_to_side(run, s, t, h, &low, &high, resolution, event))
        return turning_place(run, s, t, h, low, last, resolution, event);
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
    probe(run, s, t, h, high, LOCATED);
    if (is_rounded(run, s, t, h, high, *value, event))
        return turning_place(run, s, t, h, high, last, resolution, event);
    return high;
}

/* Tell whether an event with a value at `high` is not on its side, but moves there from where rounding has
   left it at `low`. */
APART int departs(const Run *run, const Stepper *s, double t, double h, double low, double high,
    double value, int64_t event)
{
    return value * (double)run->watch.sides.at[event] < 0.0
        && locate(run, s, t, h, low, high, event) == NOWHERE;
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
        w->log_states.at[line * n + i] = w->log_after.at[line * n + i] = w->trial.at[i];
    run->progress.counts.at[LOGGED] = line + 1;
}

/* Note a stretch in which an event is zero, where it goes on from the one that is known, or is longer. */
INLINE void note_rest(const Watch *w, int64_t event, double from, double to)
{
    if (w->rests.size == 0)
        return;
    double *known = w->rests.at + 2 * event;
    if (known[1] == from)
        known[1] = to;
    else if (!(known[1] - known[0] >= to - from))
        known[0] = from, known[1] = to;
}

/* Note which events that happen at `first` are zero close to it too, unlike a crossing; or CALLBACK. */
INLINE int64_t note_rests(const Run *run, const Stepper *s, double t, double h, double first, double right)
{
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    const double *located = w->values.at + LOCATED * number, *beside = w->values.at + MIDDLES * number;
    const double *times = run->progress.times.at, span = times[run->progress.times.size - 1] - times[0];
    int zero = 0;
    for (int64_t k = 0; k < number; k++)
        zero = zero || (w->fired.at[k] > 0 && located[k] == 0.0);
    /* on shorter ways rounding is what is seen */
    if (!zero || (right - first) * h <= CLOSE * maximum(absolute(t + h), span))
        return 0;
    if (probe(run, s, t, h, first + CLOSE * (right - first), MIDDLES) < 0)
        return CALLBACK;
    for (int64_t k = 0; k < number; k++)
        if (w->fired.at[k] > 0 && located[k] == 0.0 && beside[k] == 0.0)
            note_rest(w, k, t + first * h, t + first * h);
    return 0;
}

/* Return the polynomial through the samples of an event at the ends of the parts. */
INLINE double fit(const double *samples, int64_t apart, double place)
{
    double value = 0.0;
    for (int k = 0; k <= PARTS; k++) {
        double weight = 1.0;
        for (int i = 0; i <= PARTS; i++)
            weight *= i == k ? 1.0 : (place - scan_points[i]) / (scan_points[k] - scan_points[i]);
        value += weight * samples[k * apart];
    }
    return value;
}

/* Tell whether an event is so near to zero that what it changes by within the step matters. */
INLINE int is_near(const double *samples, int64_t apart)
{
    double least = samples[0], most = samples[0];
    for (int j = 1; j <= PARTS; j++) {
        least = minimum(least, samples[j * apart]);
        most = maximum(most, samples[j * apart]);
    }
    return least * most <= 0.0 || minimum(absolute(least), absolute(most)) <= PARTS * (most - least);
}

/* Tell whether samples hide a crossing of zero: as far as an event is known, to `error`, it may have one
   between samples near zero and near each other, and a further one beside one that is seen. */
INLINE int may_hide(const double *samples, double error)
{
    for (int j = 1; j <= 2 * PARTS; j++) {
        const double a = samples[j - 1], b = samples[j], change = absolute(a - b);
        const double nearest = minimum(absolute(a), absolute(b));
        if (a * b < 0.0 ? change < CLEAR * error : nearest <= error && change <= 2.0 * error)
            return 1;
    }
    return 0;
}

/* Evaluate all event expressions at the end of the step, beside the state by what the solver tells of it:
   by shares that no expression is likely to cancel. */
INLINE int64_t probe_shifted(const Run *run, const Stepper *s, double t, double h)
{
    const Watch *w = &run->watch;
    const Problem *p = &run->problem;
    const Memory *m = &run->memory;
    interpolate(s, 1.0, w->trial.at);
    for (int64_t i = 0; i < p->words.at[STATES]; i++) {
        const double size = m->atol.at[i] + m->rtol.at[i] * absolute(w->trial.at[i]);
        w->trial.at[i] += (i % 2 ? -1.0 : 1.0) * (1.0 + 0.6180339887498949 * (double)(i % 3)) * size;
    }
    set_inputs(p, t + h);
    return call_kernel(w->words.at[WATCHER], p->clock.at, w->trial.at, p->r.at, w->c.at,
        w->values.at + LOCATED * w->words.at[EVENTS]);
}

/* Tell whether the step is too long to see the crossings of all events: UNRESOLVED, or CALLBACK, or 0.

   The error control sees the states alone. It lets a step of free flight be as long as one likes above
   a floor that oscillates. How well a step resolves an event that is not linear is told by samples in
   the middle of the parts, beside what the tolerance of the states makes of it. A jump is not resolved
   by any step, and passes once the step is as short as times can be told. */
APART int64_t resolve(const Run *run, const Stepper *s, double t, double h)
{
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    const double *times = run->progress.times.at, span = times[run->progress.times.size - 1] - times[0];
    int sampled = 0, shifted = 0;
    if (h <= INSTANT * ROUNDING * maximum(absolute(t + h), span))
        return 0;
    for (int64_t k = 0; k < number; k++) {
        const double *ends = w->values.at + ENDS * number + k, *middles = ends + (PARTS + 1) * number;
        if (w->kinds.at[k] & LINEAR || !is_near(ends, number))
            continue;
        for (; sampled < PARTS; sampled++)
            if (probe(run, s, t, h, 0.5 * (scan_points[sampled] + scan_points[sampled + 1]), MIDDLES + sampled) < 0)
                return CALLBACK;
        double samples[2 * PARTS + 1], size = absolute(ends[0]), error = 0.0;
        samples[0] = ends[0];
        for (int j = 0; j < PARTS; j++) {
            samples[2 * j + 1] = middles[j * number], samples[2 * j + 2] = ends[(j + 1) * number];
            const double guess = fit(ends, number, 0.5 * (scan_points[j] + scan_points[j + 1]));
            error = maximum(error, 2.0 * absolute(samples[2 * j + 1] - guess));
            size = maximum(size, maximum(absolute(samples[2 * j + 1]), absolute(samples[2 * j + 2])));
        }
        if (!(error > HALF * size && may_hide(samples, error)))
            continue;
        for (; !shifted; shifted = 1)
            if (probe_shifted(run, s, t, h) < 0)
                return CALLBACK;
        if (error > absolute(w->values.at[LOCATED * number + k] - ends[PARTS * number]))
            return UNRESOLVED;
    }
    return 0;
}

/* Return a place between ends of parts, around that of the number `i`, at which an event is positive
   times `side`, where it is not, or 2, or CALLBACK: its least value is sought by parabolas, until it is
   surely positive. Where that is negative by a rounding of the samples, it only touches zero. The least
   value must be in the part that ends at the number `part`, as far as the samples tell.

   References: R. P. Brent, Algorithms for minimization without derivatives, 1973, chapter 5. */
APART double least_place(const Run *run, const Stepper *s, double t, double h, int64_t event, double side,
    int i, int part)
{
    const int64_t number = run->watch.words.at[EVENTS];
    const double *value = run->watch.values.at + DIVIDED * number + event;
    const double *samples = run->watch.values.at + (ENDS + i) * number + event;
    double a = scan_points[i - 1], b = scan_points[i], c = scan_points[i + 1], error = 1.0 / 0.0;
    double za = side * samples[-number], zb = side * samples[0], zc = side * samples[number];
    const double rounding = ROUNDINGS * ROUNDING * maximum(za, maximum(zb, zc));
    if (!(za > 0.0 && zb > 0.0 && zc > 0.0))
        return 2.0;
    for (int tries = 0; tries < TRIES; tries++) {
        const double left = (zb - za) / (b - a), right = (zc - zb) / (c - b);
        const double bend = (right - left) / (c - a), slope = left + bend * (b - a);
        double place = b - 0.5 * slope / bend;
        if (!(bend > 0.0 && zb + 0.5 * slope * (place - b) <= 2.0 * error))
            return 2.0;
        /* beyond an end of the step it may err by a part */
        const double first = part > 1 ? scan_points[part - 1] : -scan_points[1];
        const double last = part < PARTS ? scan_points[part] : 2.0 - scan_points[PARTS - 1];
        if (tries == 0 && !(place >= first && place <= last))
            return 2.0;
        if (place <= a || place >= c)
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
   both ends of it, or 2, or CALLBACK. */
INLINE double find_dip(const Run *run, const Stepper *s, double t, double h, double left, int part)
{
    const Watch *w = &run->watch;
    const int64_t number = w->words.at[EVENTS];
    double first = 2.0;
    for (int64_t k = 0; k < number; k++) {
        const double side = (double)w->sides.at[k];
        for (int i = part < 2 ? 1 : part - 1; i <= part && i < PARTS; i++) {
            const double found = least_place(run, s, t, h, k, side, i, part);
            if (found == CALLBACK)
                return CALLBACK;
            if (found > left && found < minimum(first, scan_points[part]))
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
    double *ends = w->values.at + ENDS * number, *known = w->values.at + PROBES * number;
    const double *located = w->values.at + LOCATED * number;
    for (int part = *known == t; part <= PARTS; part++)
        if (probe(run, s, t, h, scan_points[part], ENDS + part) < 0)
            return called_back(run, logged);
    for (int64_t k = 0; k < number && *known != t; k++) /* what turns is not looked at everywhere */
        if (w->kinds.at[k] & TURNS && ends[k] != 0.0)
            sides[k] = ends[k] > 0.0 ? 1 : -1;
    const int64_t code = resolve(run, s, t, h);
    if (code != 0)
        return code == CALLBACK ? called_back(run, logged) : code;
    *known = UNKNOWN;
    /* an event may happen by a jump at the end, which no step resolves: a last part without a length */
    const int parts = run->problem.jumps.size > 0 ? PARTS + 1 : PARTS;
    for (int part = 1; part <= parts; part += left == scan_points[part < PARTS ? part : PARTS]) {
        double right = scan_points[part < PARTS ? part : PARTS];
        const double *values = ends + (part < PARTS ? part : PARTS) * number;
        if (part > PARTS) {
            release_inputs(&run->problem);
            if (probe(run, s, t, h, 1.0, ENDS + PARTS) < 0)
                return called_back(run, logged);
            left = maximum(0.0, 1.0 - INSTANT * resolution_of(t, h)); /* just before the jump */
        }
        const double dip = part > PARTS ? 2.0 : find_dip(run, s, t, h, left, part);
        if (dip < 0.0)
            return called_back(run, logged);
        if (dip < right) {
            right = dip, values = w->values.at + DIVIDED * number;
            if (probe(run, s, t, h, right, DIVIDED) < 0)
                return called_back(run, logged);
        }
        for (;;) {
            double first = NOWHERE;
            int64_t earliest = -1, undefined = -1;
            for (int64_t k = 0; k < number; k++) {
                fired[k] = 0;
                if (crossed(sides[k], values[k], directions[k]) || lost(sides[k], values[k])) {
                    const double theta = locate(run, s, t, h, left, right, k);
                    fired[k] = theta == NOWHERE ? DEPARTS : theta <= left;
                    if (theta < first)
                        first = theta, earliest = k;
                }
            }
            if (first > 1.0)
                break;
            if (probe(run, s, t, h, first, LOCATED) < 0)
                return called_back(run, logged);
            /* by then another may have crossed that is back at `right`, or not have come to its side */
            for (int64_t k = 0; k < number; k++) {
                if (k == earliest || fired[k] != 0 || !((double)sides[k] * located[k] < 0.0))
                    continue;
                if (departs(run, s, t, h, left, first, located[k], k))
                    fired[k] = DEPARTS;
                else if (crossed(sides[k], located[k], directions[k])
                    && !crossed(sides[k], values[k], directions[k])) {
                    const double theta = locate(run, s, t, h, left, first, k);
                    if (theta > left)
                        first = theta, fired[k] = BACK;
                }
                if (probe(run, s, t, h, first, LOCATED) < 0)
                    return called_back(run, logged);
            }
            int acting = 0;
            for (int64_t k = 0; k < number; k++) {
                const double now = located[k];
                if (fired[k] == DEPARTS)
                    continue;
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
                return note_rests(run, s, t, h, first, right) == CALLBACK ? called_back(run, logged) : EVENT;
            }
            for (int64_t k = 0; k < number; k++) {
                if (fired[k] <= 0)
                    continue;
                log_event(run, t + first * h, k);
                sides[k] = -sides[k];
            }
            if (note_rests(run, s, t, h, first, right) == CALLBACK)
                return called_back(run, logged);
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
            if (values[k] * (double)sides[k] < 0.0 && !departs(run, s, t, h, left, right, values[k], k))
                sides[k] = -sides[k];
            else if (sides[k] == 0)
                sides[k] = values[k] > 0.0 ? 1 : values[k] < 0.0 ? -1 : 0;
            if (part <= PARTS && right == scan_points[part] && ends[(part - 1) * number + k] == 0.0
                && ends[part * number + k] == 0.0)
                note_rest(w, k, t + scan_points[part - 1] * h, t + right * h);
        }
        left = right;
    }
    for (int64_t k = 0; k < number; k++)
        ends[k] = ends[PARTS * number + k];
    *known = state[TIME];
    state[FOUND] = 1.0;
    return 0;
}
