/* What the interfaces of FMI 2.0 and 3.0 share: an instance of the model, and its events. */

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define ENTRY static
#include "advance.c"
#include "scan_events.c"
#include "departure.h"

/* Of a time: closer to a switch of the rates, rounding decides on which side it is. */
#define UNDECIDED (16 * ROUNDING)

/* Value references, in this order: time, states, derivatives, inputs, outputs, constants, event
   indicators. */
enum {
    AT_X = 1,
    AT_DX = AT_X + NX,
    AT_U = AT_DX + NX,
    AT_Y = AT_U + NU,
    AT_P = AT_Y + NY,
    AT_Z = AT_P + NP,
    AT_END = AT_Z + NE
};

typedef struct {
    double t, x[NX + 1], u[NU + 1], p[NP + 1], prepared[NPREPARED];
    double rates[NX + 1], outputs[NY + 1], z[NE + 1], dz[2 * NE + 1]; /* bounds follow the rates of events */
    int prepared_fresh, switches_fresh, rates_fresh, outputs_fresh, running, starting;
    int64_t sides[NE + 1], fired[NE + 1], off[NE + 1], seen[NE + 1], led[NE + 1];
    double last_u[NU + 1], last_p[NP + 1]; /* after the last event or step of the importer */
    /* of Model Exchange: the rates of the inputs, the inputs and the time from which they were told; the time of that
       event or step, the inputs as the importer goes on from there, and how far they have jumped there */
    double slopes[NU + 1], base_u[NU + 1], base, went_on, went_on_u[NU + 1], jumps[NU + 1];
    /* the outcome with which the motion has ended or failed, and the event, if it is one's */
    int64_t outcome, event;
    /* of the integration */
    double rtol, latest[NE * CROWD + 1], state[FOUND + 1];
    int64_t counts[PROJECTIONS + 1];
    double stages[NVECTORS * NX + 1], fresh[NX + 1], trial[NX + 1], errors[2 * NX + 1];
    double interpolant[NPARTS * NX + 1], probes[PROBES * NE + 1], probe[NX + 1];
    double resets[NE * NX + 1], derivatives[(NX + NY) * (NX + NU) + 1];
    /* rows of the times at which rates switch whatever the states are, and the last time that Model Exchange
       has gone on from */
    double switches[3 * NS + 1], passed;
    int64_t switch_count;
} Model;

typedef struct {
    Model model;
    void *environment;
    void *logger;
    char *name;
} Instance;

static void model_reset(Model *m)
{
    memset(m, 0, sizeof *m);
    memcpy(m->x, MODEL(initial), NX * sizeof(double));
    memcpy(m->u, MODEL(inputs), NU * sizeof(double));
    memcpy(m->p, &MODEL(defaults), NP * sizeof(double));
    m->t = m->passed = START_TIME;
    m->rtol = TOLERANCE;
    m->starting = 1;
    m->counts[FAILURE] = STEP_UNDERFLOW;
    for (int k = 0; k < NE * CROWD; k++)
        m->latest[k] = -INFINITY;
}

static int64_t ends_with(Model *m, int64_t outcome, int64_t event)
{
    m->event = event;
    return m->outcome = outcome;
}

/* Tell whether an outcome is an end of the motion, not a failure. */
static int is_end(int64_t outcome) { return outcome == TERMINATED || outcome == EVENTS_ACCUMULATE; }

/* Note that the state, an input, the time or a constant is another one. */
static void changed(Model *m)
{
    m->rates_fresh = m->outputs_fresh = 0;
    m->counts[STARTED] = 0;
}

/* Find the times at which the rates switch whatever the states are, ascending: rows of the time, the last one
   before it and the first one after it at which rounding does not decide on which side it is. */
static void find_switches(Model *m)
{
    m->switch_count = 0;
#if NS > 0
    double times[NS];
    MODEL(switches)(0.0, m->x, m->u, m->prepared, times);
    for (int k = 0; k < NS; k++)
        if (isnan(times[k]))
            times[k] = INFINITY; /* never */
    for (int k = 1; k < NS; k++)
        for (int i = k; i > 0 && times[i] < times[i - 1]; i--) {
            const double later = times[i - 1];
            times[i - 1] = times[i], times[i] = later;
        }
    for (int k = 0; k < NS; k++) {
        const double width = UNDECIDED * fmax(fabs(times[k]), STOP_TIME - START_TIME);
        double *row = m->switches + 3 * m->switch_count;
        if (!isfinite(times[k]))
            continue;
        if (m->switch_count > 0 && times[k] - width <= row[-1]) {
            row[-1] = times[k] + width;
            continue;
        }
        row[0] = times[k], row[1] = times[k] - width, row[2] = times[k] + width;
        m->switch_count += 1;
    }
#endif
}

static void prepare(Model *m)
{
    if (!m->prepared_fresh) {
        MODEL(constants) constants;
        memset(&constants, 0, sizeof constants);
        memcpy(&constants, m->p, NP * sizeof(double));
        MODEL(prepare)(&constants, m->prepared);
        m->prepared_fresh = 1, m->switches_fresh = 0;
    }
    if (!m->switches_fresh) {
        find_switches(m);
        m->switches_fresh = 1;
    }
}

static int rates_at(Model *m, double t, const double *x, double *out)
{
    return MODEL(rates)(t, x, m->u, m->prepared, out);
}

/* Return the present time, or where rounding would decide whether rates have switched, one on the side from
   which the importer goes on, or to which it integrates. */
static double settled_time(const Model *m)
{
    for (int64_t k = 0; k < m->switch_count; k++) {
        const double *row = m->switches + 3 * k;
        if (row[1] < m->t && m->t < row[2])
            return m->passed > row[1] ? row[2] : row[1];
    }
    return m->t;
}

/* Return the time of the next switch, or infinity. */
static double next_switch(Model *m)
{
    prepare(m);
    for (int64_t k = 0; k < m->switch_count; k++)
        if (m->switches[3 * k + 1] >= m->t)
            return m->switches[3 * k];
    return INFINITY;
}

/* Bring the rates up to date; not zero where the mass matrix is singular. */
static int update_rates(Model *m)
{
    int failed = 0;
    prepare(m);
    if (!m->rates_fresh)
        failed = rates_at(m, settled_time(m), m->x, m->rates);
    m->rates_fresh = !failed;
    return failed;
}

static int update_outputs(Model *m)
{
    int failed = 0;
    prepare(m);
    if (!m->outputs_fresh)
        failed = MODEL(outputs)(m->t, m->x, m->u, m->prepared, m->outputs);
    m->outputs_fresh = !failed;
    return failed;
}

/* Return the constraint that the state violates most, by how often its residual exceeds what typed digits and
   rounding allow, or -1; the rule of `violations` in pydy/_judges/constraint_drift.py. */
static int violated_constraint(Model *m, double *residual, int *singular)
{
    int worst = -1;
    *residual = 0.0, *singular = 0;
#if NC > 0
    double values[3 * NC], share = 1.0;
    prepare(m);
    *singular = MODEL(start_residuals)(m->t, m->x, m->u, m->prepared, values);
    for (int k = 0; k < NC && !*singular; k++) {
        const double rounded = values[2 * NC + k];
        const double allowed = values[NC + k] + (isfinite(rounded) ? rounded : 0.0);
        const double size = fabs(values[k]);
        if (size <= allowed)
            continue;
        const double times = isnan(size) || allowed == 0.0 ? INFINITY : size / allowed;
        if (worst < 0 || times > share)
            worst = k, share = times, *residual = values[k];
    }
#else
    (void)m;
#endif
    return worst;
}

static int event_values(Model *m, double t, const double *x, double *out)
{
#if NE > 0
    prepare(m);
    return MODEL(events)(t, x, m->u, m->prepared, out);
#else
    (void)m, (void)t, (void)x, (void)out;
    return 0;
#endif
}

/* Not zero for a value reference that does not exist, or a value that cannot be computed. */
static int get_real(Model *m, unsigned vr, double *value)
{
    int failed = 0;
    if (vr < AT_X)
        *value = m->t;
    else if (vr < AT_DX)
        *value = m->x[vr - AT_X];
    else if (vr < AT_U) {
        failed = update_rates(m);
        *value = m->rates[vr - AT_DX];
    } else if (vr < AT_Y)
        *value = m->u[vr - AT_U];
    else if (vr < AT_P) {
        failed = update_outputs(m);
        *value = m->outputs[vr - AT_Y];
    } else if (vr < AT_Z)
        *value = m->p[vr - AT_P];
    else if (vr < AT_END) {
        failed = event_values(m, m->t, m->x, m->z);
        *value = m->z[vr - AT_Z];
    } else
        failed = 1;
    return failed;
}

static int set_real(Model *m, unsigned vr, double value)
{
    if (vr >= AT_X && vr < AT_DX)
        m->x[vr - AT_X] = value;
    else if (vr >= AT_U && vr < AT_Y) {
        if (m->t == m->went_on) {
            const double jump = value - m->went_on_u[vr - AT_U];
            m->jumps[vr - AT_U] += jump, m->base_u[vr - AT_U] += jump;
            m->went_on_u[vr - AT_U] = value;
        }
        m->u[vr - AT_U] = value;
        m->switches_fresh = 0;
    } else if (vr >= AT_P && vr < AT_Z) {
        m->p[vr - AT_P] = value;
        m->prepared_fresh = 0;
    } else
        return 1;
    changed(m);
    return 0;
}

/* -- directional derivatives ------------------------------------------------------------------ */

static int row_of(unsigned vr)
{
    if (vr >= AT_DX && vr < AT_U)
        return (int)(vr - AT_DX);
    if (vr >= AT_Y && vr < AT_P)
        return (int)(NX + vr - AT_Y);
    return -1;
}

static int column_of(unsigned vr)
{
    if (vr >= AT_X && vr < AT_DX)
        return (int)(vr - AT_X);
    if (vr >= AT_U && vr < AT_Y)
        return (int)(NX + vr - AT_U);
    return -1;
}

/* sensitivity = (derivatives of the unknowns by the knowns) times seed; or, transposed, the seed
   is one of the unknowns. */
static int derivative(Model *m, const unsigned *unknowns, size_t rows, const unsigned *knowns,
    size_t columns, const double *seed, double *sensitivity, int transposed)
{
    prepare(m);
    if (MODEL(jacobian)(m->t, m->x, m->u, m->prepared, m->derivatives))
        return 1;
    for (size_t k = 0; k < (transposed ? columns : rows); k++)
        sensitivity[k] = 0.0;
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < columns; j++) {
            const int row = row_of(unknowns[i]), column = column_of(knowns[j]);
            const double along = seed[transposed ? i : j];
            double value;
            if (column < 0)
                return 1;
            if (row >= 0)
                value = m->derivatives[row * (NX + NU) + column];
            else if (unknowns[i] >= AT_X && unknowns[i] < AT_DX) /* a state is an output too */
                value = unknowns[i] == knowns[j] ? 1.0 : 0.0;
            else
                return 1;
            if (along != 0.0) /* a derivative may be infinite, and 0 * infinity is NaN */
                sensitivity[transposed ? j : i] += value * along;
        }
    return 0;
}

/* -- events ----------------------------------------------------------------------------------- */

/* Write the rates of events to m->dz, those with which inputs change included. */
static void rates_of_events(Model *m, const double *x)
{
#if NE > 0
    prepare(m);
    MODEL(event_rates)(m->t, x, m->u, m->prepared, m->dz);
#if NU > 0
    double both[2 * NU], added[NE];
    int varying = 0;
    memcpy(both, m->u, NU * sizeof(double)), memcpy(both + NU, m->slopes, NU * sizeof(double));
    for (int i = 0; i < NU; i++)
        varying = varying || m->slopes[i] != 0.0;
    if (!varying)
        return;
    MODEL(event_input_rates)(m->t, x, both, m->prepared, added);
    for (int k = 0; k < NE; k++)
        m->dz[k] += added[k];
#endif
#else
    (void)m, (void)x;
#endif
}

/* Begin to tell the rates of the inputs from now. */
static void begin_slopes(Model *m)
{
    memcpy(m->base_u, m->u, sizeof m->u), memcpy(m->went_on_u, m->u, sizeof m->u);
    memset(m->jumps, 0, sizeof m->jumps);
    m->base = m->went_on = m->t;
}

/* Tell the rates of the inputs after a step of the importer, by differences. Shorter steps than those over
   which roundings and curvature weigh alike (`_difference_step` of pydy/solvers/compiled_events.py) are told
   with the next one. */
static void tell_slopes(Model *m)
{
    const double step = m->t - m->base;
    for (int i = 0; i < NU; i++)
        m->last_u[i] = m->u[i] - m->jumps[i], m->jumps[i] = 0.0; /* what varies leads no event across */
    memcpy(m->went_on_u, m->u, sizeof m->u);
    m->went_on = m->t;
    if (step < HALF * fmax(STOP_TIME - START_TIME, HALF * fabs(m->t)))
        return;
    for (int i = 0; i < NU; i++)
        m->slopes[i] = (m->u[i] - m->base_u[i]) / step;
    begin_slopes(m);
}

/* Set the sign that each event has just after now; where one is zero, fired or departs, its rate tells,
   unless a reset has led off its surface. */
static void take_sides(Model *m)
{
#if NE > 0
    event_values(m, m->t, m->x, m->z);
    rates_of_events(m, m->x);
    for (int k = 0; k < NE; k++) {
        const int on = (m->fired[k] && !m->off[k]) || m->z[k] == 0.0;
        const double value = on ? m->dz[k] : m->z[k];
        m->sides[k] = (value > 0.0) - (value < 0.0);
        m->fired[k] = m->off[k] = 0;
    }
#else
    (void)m;
#endif
}

/* Reset the states for an event, and note the events from whose surfaces that leads, by more than
   rounding. */
static void reset_states(Model *m, int64_t event)
{
#if NE > 0
    double was[NE];
    event_values(m, m->t, m->x, was);
    MODEL(resets)(m->t, m->x, m->u, m->prepared, m->resets);
    memcpy(m->x, m->resets + event * NX, NX * sizeof(double));
    changed(m);
    event_values(m, m->t, m->x, m->z);
    MODEL(event_bounds)(m->t, m->x, m->u, m->prepared, m->dz);
    for (int k = 0; k < NE; k++)
        if (m->z[k] != was[k] && !is_on_surface(m->z[k], m->dz[k]))
            m->off[k] = 1;
#else
    (void)m, (void)event;
#endif
}

#if NE > 0

static double event_rate(Model *m, const double *x, int k)
{
    rates_of_events(m, x);
    return m->dz[k];
}

/* Tell whether the rate of an event is zero, as far as states are known. */
static int is_stationary(Model *m, int k)
{
    double beside[NX + 1], total = 0.0;
    const double rate = event_rate(m, m->x, k);
    for (int i = 0; i < NX && rate != 0.0; i++) {
        memcpy(beside, m->x, NX * sizeof(double));
        beside[i] += ROUNDINGS * ROUNDING * m->x[i];
        total += fabs(event_rate(m, beside, k) - rate);
    }
    return fabs(rate) <= total;
}

/* Return the sign of an event where it first exceeds its roundings, as `resolved_side` of
   pydy/solvers/run/departure.py. */
static int resolved_side(Model *m, int k)
{
    double a[NX + 1], b[NX + 1], c[NX + 1], d[NX + 1], x[NX + 1], u[NU + 1], z[NE], size = STOP_TIME - START_TIME;
    int side = 0;
    for (int halved = 0; halved < HALVINGS; halved++) {
        const double middle = m->t + 0.25 * size;
        size *= 0.5;
        rates_at(m, m->t, m->x, a);
        for (int i = 0; i < NX; i++)
            x[i] = m->x[i] + 0.5 * size * a[i];
        rates_at(m, middle, x, b);
        for (int i = 0; i < NX; i++)
            x[i] = m->x[i] + 0.5 * size * b[i];
        rates_at(m, middle, x, c);
        for (int i = 0; i < NX; i++)
            x[i] = m->x[i] + size * c[i];
        rates_at(m, m->t + size, x, d);
        for (int i = 0; i < NX; i++)
            x[i] = m->x[i] + size / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        for (int i = 0; i < NU; i++)
            u[i] = m->u[i] + size * m->slopes[i];
        MODEL(events)(m->t + size, x, u, m->prepared, z);
        MODEL(event_bounds)(m->t + size, x, u, m->prepared, m->dz);
        if (fabs(z[k]) > ROUNDINGS * ROUNDING * m->dz[k])
            side = sign_of(z[k]);
    }
    return side;
}

/* Return the sign that an event has just after now, as `departure` there. */
static int departure(Model *m, int k)
{
    return is_stationary(m, k) ? resolved_side(m, k) : sign_of(event_rate(m, m->x, k));
}

/* Tell whether the rate of an event that has happened does not tell where its reset leads, as
   `is_unresolved` of pydy/solvers/run/departure.py. */
static int is_unresolved(Model *m, int k)
{
    if (is_stationary(m, k))
        return 1;
    const double speed = fabs(event_rate(m, m->x, k)), flight = m->t - m->latest[k * CROWD + 1];
    MODEL(event_bounds)(m->t, m->x, m->u, m->prepared, m->dz);
    return speed * flight <= LOW * ROUNDINGS * ROUNDING * m->dz[k] && resolved_side(m, k) * m->sides[k] < 0;
}

/* Note the time of an event. Tell whether so many have happened so close together that they accumulate, as
   of a ball that comes to rest, or as close as times are told: the rule of `act_on_event.c`. */
static int is_crowded(Model *m, int k)
{
    double *latest = m->latest + k * CROWD;
    const double span = STOP_TIME - START_TIME, t = m->t;
    const int crowded = t - latest[0] <= NO_LATER * ROUNDING * maximum(fabs(t), span)
        || t - latest[CROWD - 2] < CROWDED * span;
    for (int i = CROWD - 1; i > 0; i--)
        latest[i] = latest[i - 1];
    latest[0] = t;
    return crowded;
}

#endif

/* Reset the states for the events that have fired: FINISHED, or the outcome with which that ends the
   motion. */
static int64_t act(Model *m)
{
#if NE > 0
    int64_t origins[NE], fired[NE];
    int terminal = -1, crowded = -1;
    memcpy(origins, m->sides, sizeof origins);
    for (int k = 0; k < NE; k++) {
        fired[k] = m->fired[k] > 0; /* others depart */
        if (!fired[k])
            continue;
        if (EVENT_ACTING[k])
            reset_states(m, k);
        for (int i = 0; i < NX; i++)
            if (!isfinite(m->x[i]))
                return ends_with(m, RESET_NOT_FINITE, k);
        if (EVENT_TERMINAL[k] && terminal < 0)
            terminal = k;
        if (EVENT_ACTING[k] && is_crowded(m, k) && crowded < 0)
            crowded = k;
    }
    int64_t rests[NE];
    for (int k = 0; k < NE; k++)
        rests[k] = fired[k] > 0 && EVENT_REDIRECTS[k] && !m->off[k];
    take_sides(m);
    if (terminal >= 0)
        return ends_with(m, TERMINATED, terminal);
    for (int k = 0; k < NE; k++)
        if (origins[k] != 0 && !fired[k] && isnan(m->z[k]))
            return ends_with(m, EVENT_UNDEFINED, k);
    for (int k = 0; k < NE; k++)
        if (rests[k] && is_unresolved(m, k)) {
            m->sides[k] = resolved_side(m, k);
            if (follows_itself(m->sides[k], origins[k], EVENT_DIRECTIONS[k]))
                crowded = k;
        }
    if (crowded >= 0)
        return ends_with(m, EVENTS_ACCUMULATE, crowded);
#else
    take_sides(m);
#endif
    return FINISHED;
}

/* Act on the events on whose surfaces the motion starts: FINISHED, or the outcome with which that ends
   the motion. `moved` tells whether states were reset. */
static int64_t start_events(Model *m, int *moved)
{
    int some = 0;
    m->starting = 0;
    take_sides(m);
#if NE > 0
    double bounds[NE];
    MODEL(event_bounds)(m->t, m->x, m->u, m->prepared, bounds);
    for (int k = 0; k < NE; k++) {
        if (!is_on_surface(m->z[k], bounds[k]))
            continue;
        const int side = departure(m, k);
        m->sides[k] = side;
        if (!EVENT_ACTING[k] || !acts_at_start(side, EVENT_DIRECTIONS[k], is_stationary(m, k)))
            continue;
        m->fired[k] = some = *moved = 1;
        m->sides[k] = 0; /* where the motion came from is not known */
    }
#endif
    return some ? act(m) : FINISHED;
}

/* -- Model Exchange: the importer looks for events -------------------------------------------------

   It stops a little late, so that the state is beyond the surface after a reset too, on the other side
   than the one the motion leaves to (`sides`). Where the motion comes back before the importer has seen
   it on that side, no indicator changes its sign. */

enum { UNSEEN, SEEN, SEEN_AT_STEP };

/* Note which events the importer sees on their sides, from the indicators in m->z. */
static void note_seen(Model *m, int64_t how)
{
    for (int k = 0; k < NE; k++)
        if (m->z[k] * (double)m->sides[k] > 0.0 && m->seen[k] < how)
            m->seen[k] = how;
}

static void remember_inputs(Model *m)
{
    memcpy(m->last_u, m->u, sizeof m->u);
    memcpy(m->last_p, m->p, sizeof m->p);
}

/* Note the events that inputs or constants have led across their surfaces since the last event or step of
   the importer: with their former values, the state would be on the side. */
static void note_led(Model *m)
{
    double u[NU + 1], p[NP + 1], z[NE + 1];
    const int tuned = memcmp(m->p, m->last_p, NP * sizeof(double)) != 0;
    if (NE == 0 || (!tuned && memcmp(m->u, m->last_u, NU * sizeof(double)) == 0))
        return;
    memcpy(u, m->u, sizeof u), memcpy(p, m->p, sizeof p);
    memcpy(m->u, m->last_u, sizeof u), memcpy(m->p, m->last_p, sizeof p);
    m->prepared_fresh = m->prepared_fresh && !tuned;
    event_values(m, m->t, m->x, z);
    memcpy(m->u, u, sizeof u), memcpy(m->p, p, sizeof p);
    m->prepared_fresh = m->prepared_fresh && !tuned, m->switches_fresh = 0;
    for (int k = 0; k < NE; k++)
        if (z[k] * (double)m->sides[k] > 0.0 && m->z[k] * (double)m->sides[k] < 0.0)
            m->led[k] = 1;
    remember_inputs(m);
}

/* Tell, from m->z and m->dz, whether an event moves to the side that it has left to, where it is not: it
   has not been there since it was handled, or a reset that turns motions back would turn that one away.
   What an input has led across was on its side. */
static int departed(const Model *m, int k)
{
    const double side = (double)m->sides[k];
    return m->z[k] * side < 0.0 && m->dz[k] * side > 0.0 && !m->led[k]
        && (m->seen[k] == UNSEEN || (EVENT_REDIRECTS[k] && crossed(m->sides[k], m->z[k], EVENT_DIRECTIONS[k])));
}

static int is_across(const Model *m, int k)
{
    return crossed(m->sides[k], m->z[k], EVENT_DIRECTIONS[k]) && !departed(m, k);
}

static void evaluate_events(Model *m)
{
    event_values(m, m->t, m->x, m->z);
    note_led(m);
    rates_of_events(m, m->x);
}

/* After a step of the importer: tell in `waits` whether an event is to be handled that indicators at the
   ends of steps do not tell of. FINISHED, or the outcome where one has happened again before it could be
   seen: the importer's step has passed over events. */
static int64_t complete_step(Model *m, int *waits)
{
    int64_t outcome = FINISHED;
    tell_slopes(m);
    evaluate_events(m);
    *waits = 0;
    for (int k = 0; k < NE; k++) {
        m->led[k] = m->led[k] && m->z[k] * (double)m->sides[k] < 0.0;
        if (EVENT_ACTING[k] && (m->led[k] || m->seen[k] < SEEN_AT_STEP) && is_across(m, k)) {
            *waits = 1;
            if (m->seen[k] == UNSEEN && !m->led[k] && m->latest[k * CROWD] > -INFINITY)
                outcome = ends_with(m, EVENTS_ACCUMULATE, k);
        }
    }
    note_seen(m, SEEN_AT_STEP);
    return outcome;
}

/* Fire the events whose indicators have crossed zero since they were last seen: FINISHED, or the outcome
   with which that ends the motion. `moved` tells whether states were reset. */
static int64_t handle_events(Model *m, int *moved)
{
    int some = 0;
    int64_t outcome = FINISHED;
    double was[NE + 1];
    int64_t sides[NE + 1];
    *moved = 0;
    const int starting = m->starting;
    m->passed = m->t; /* the importer goes on from here, beyond a switch */
    m->rates_fresh = 0;
    if (starting)
        begin_slopes(m);
    else
        tell_slopes(m);
    evaluate_events(m);
    for (int k = 0; k < NE && !starting; k++) {
        const double side = (double)m->sides[k];
        /* importers may stop exactly at the crossing */
        const int there = m->z[k] == 0.0 && m->dz[k] * side < 0.0 && EVENT_DIRECTIONS[k] != m->sides[k];
        m->fired[k] = departed(m, k) ? DEPARTS : is_across(m, k) || there;
        was[k] = m->z[k];
        sides[k] = m->fired[k] == DEPARTS ? m->sides[k] : 0;
        some = some || m->fired[k] > 0;
        *moved = *moved || (m->fired[k] > 0 && EVENT_ACTING[k]);
    }
    if (starting)
        outcome = start_events(m, moved);
    else if (some)
        outcome = act(m);
    else
        take_sides(m);
    for (int k = 0; k < NE; k++) {
        if (!starting && sides[k] != 0 && m->z[k] == was[k])
            m->sides[k] = sides[k];
        m->seen[k] = UNSEEN, m->led[k] = 0; /* the importer begins anew */
    }
    note_seen(m, SEEN_AT_STEP);
    return outcome;
}

#include "fmu_solver.c"

/* -- instances -------------------------------------------------------------------------------- */

static Instance *make_instance(const char *name, void *environment, void *logger)
{
    Instance *instance = calloc(1, sizeof *instance);
    if (instance == NULL)
        return NULL;
    instance->name = malloc(strlen(name) + 1);
    if (instance->name == NULL) {
        free(instance);
        return NULL;
    }
    strcpy(instance->name, name);
    instance->environment = environment;
    instance->logger = logger;
    model_reset(&instance->model);
    return instance;
}

static void free_instance(Instance *instance)
{
    if (instance != NULL) {
        free(instance->name);
        free(instance);
    }
}
