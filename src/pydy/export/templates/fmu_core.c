/* What the interfaces of FMI 2.0 and 3.0 share: an instance of the model, its events, and the
   adaptive explicit Runge-Kutta method behind Co-Simulation. */

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "config.h"

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
    double rates[NX + 1], outputs[NY + 1], z[NE + 1], dz[NE + 1];
    int prepared_fresh, rates_fresh, outputs_fresh, running;
    int sides[NE + 1], fired[NE + 1];
    /* of the integration */
    double rtol, h, last_error, growth, last_event[NE + 1];
    int crowd[NE + 1];
    int started;
    double stages[NSTAGES + 1 + NDENSE][NX + 1], fresh[NX + 1], trial[NX + 1];
    double errors[NERRORS][NX + 1], interpolant[3 + NINTERPOLANT][NX + 1];
    double resets[NE * NX + 1], derivatives[(NX + NY) * (NX + NU) + 1];
} Model;

typedef struct {
    Model model;
    void *environment;
    void *logger;
    char *name;
    int stopped;
} Instance;

static void model_reset(Model *m)
{
    memset(m, 0, sizeof *m);
    memcpy(m->x, MODEL(initial), NX * sizeof(double));
    memcpy(m->u, MODEL(inputs), NU * sizeof(double));
    memcpy(m->p, &MODEL(defaults), NP * sizeof(double));
    m->t = START_TIME;
    m->rtol = 1e-10;
}

/* Note that the state, an input, the time or a constant is another one. */
static void changed(Model *m)
{
    m->rates_fresh = m->outputs_fresh = m->started = 0;
}

static void prepare(Model *m)
{
    if (!m->prepared_fresh) {
        MODEL(constants) constants;
        memset(&constants, 0, sizeof constants);
        memcpy(&constants, m->p, NP * sizeof(double));
        MODEL(prepare)(&constants, m->prepared);
        m->prepared_fresh = 1;
    }
}

static int rates_at(Model *m, double t, const double *x, double *out)
{
    return MODEL(rates)(t, x, m->u, m->prepared, out);
}

/* Bring the rates up to date; not zero where the mass matrix is singular. */
static int update_rates(Model *m)
{
    int failed = 0;
    prepare(m);
    if (!m->rates_fresh)
        failed = rates_at(m, m->t, m->x, m->rates);
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
    else if (vr >= AT_U && vr < AT_Y)
        m->u[vr - AT_U] = value;
    else if (vr >= AT_P && vr < AT_Z) {
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
            double value;
            if (column < 0)
                return 1;
            if (row >= 0)
                value = m->derivatives[row * (NX + NU) + column];
            else if (unknowns[i] >= AT_X && unknowns[i] < AT_DX) /* a state is an output too */
                value = unknowns[i] == knowns[j] ? 1.0 : 0.0;
            else
                return 1;
            if (transposed)
                sensitivity[j] += value * seed[i];
            else
                sensitivity[i] += value * seed[j];
        }
    return 0;
}

/* -- events ----------------------------------------------------------------------------------- */

/* Set the sign that each event has just after now; where one is zero or fired, its rate tells. */
static void take_sides(Model *m)
{
#if NE > 0
    prepare(m);
    event_values(m, m->t, m->x, m->z);
    MODEL(event_rates)(m->t, m->x, m->u, m->prepared, m->dz);
    for (int k = 0; k < NE; k++) {
        const double value = m->fired[k] || m->z[k] == 0.0 ? m->dz[k] : m->z[k];
        m->sides[k] = (value > 0.0) - (value < 0.0);
        m->fired[k] = 0;
    }
#else
    (void)m;
#endif
}

static int crossed(const Model *m, int k, double value)
{
    return (m->sides[k] < 0 && value > 0.0 && DIRECTIONS[k] >= 0)
        || (m->sides[k] > 0 && value < 0.0 && DIRECTIONS[k] <= 0);
}

/* Reset the states for the events that have fired; 1 where one of them ends the motion. */
static int act(Model *m)
{
    int ends = 0;
#if NE > 0
    for (int k = 0; k < NE; k++) {
        if (!m->fired[k])
            continue;
        if (ACTING[k]) {
            prepare(m);
            MODEL(resets)(m->t, m->x, m->u, m->prepared, m->resets);
            memcpy(m->x, m->resets + k * NX, NX * sizeof(double));
            changed(m);
        }
        ends = ends || TERMINAL[k];
        /* so many so close together that they accumulate, as of a ball that comes to rest */
        if (m->t - m->last_event[k] < 1e-11 * (fabs(m->t) + 1.0))
            m->crowd[k]++;
        else
            m->crowd[k] = 0;
        m->last_event[k] = m->t;
        ends = ends || m->crowd[k] > 100;
    }
#endif
    take_sides(m);
    return ends;
}

/* In Model Exchange: fire the events whose indicators have crossed zero since they were last seen.
   Returns 1 where one ends the motion; `moved` tells whether states were reset. */
static int handle_events(Model *m, int *moved)
{
    int some = 0;
    *moved = 0;
    event_values(m, m->t, m->x, m->z);
#if NE > 0
    MODEL(event_rates)(m->t, m->x, m->u, m->prepared, m->dz);
#endif
    for (int k = 0; k < NE; k++) {
        /* importers may stop exactly at the crossing */
        const int there = m->z[k] == 0.0 && m->dz[k] * m->sides[k] < 0.0
            && DIRECTIONS[k] != m->sides[k];
        m->fired[k] = crossed(m, k, m->z[k]) || there;
        some = some || m->fired[k];
        *moved = *moved || (m->fired[k] && ACTING[k]);
    }
    if (some)
        return act(m);
    take_sides(m);
    return 0;
}

/* -- the integration -------------------------------------------------------------------------- */

/* y = x + h (row of the tableau times the stages); x may be NULL. */
static void combine(Model *m, int row, double h, const double *x, double *y)
{
    for (int i = 0; i < NX; i++) {
        double total = 0.0;
        for (int k = ROWS[row]; k < ROWS[row + 1]; k++)
            total += WEIGHTS[k] * m->stages[STAGES[k]][i];
        y[i] = (x == NULL ? 0.0 : x[i]) + h * total;
    }
}

static double weight(const Model *m, double size)
{
    return 1.0 / (m->rtol + m->rtol * size);
}

static double norm(const Model *m, const double *a, const double *b)
{
    double total = 0.0;
    for (int i = 0; i < NX; i++) {
        const double e = (a[i] - (b == NULL ? 0.0 : b[i])) * weight(m, fabs(m->x[i]));
        total += e * e;
    }
    return sqrt(total / (NX > 0 ? NX : 1));
}

/* E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.4. */
static double first_size(Model *m, double most)
{
    const double d0 = norm(m, m->x, NULL), d1 = norm(m, m->stages[0], NULL);
    double h0 = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1;
    h0 = fmin(h0, most);
    for (int i = 0; i < NX; i++)
        m->trial[i] = m->x[i] + h0 * m->stages[0][i];
    if (rates_at(m, m->t + h0, m->trial, m->stages[1]))
        return 1e-3 * h0;
    const double d2 = norm(m, m->stages[1], m->stages[0]) / h0, steepest = fmax(d1, d2);
    const double h1 = steepest > 1e-15 ? pow(0.01 / steepest, EXPONENT) : fmax(1e-6, 1e-3 * h0);
    return fmin(100.0 * h0, h1);
}

static double error_of_step(Model *m, double h)
{
    double first = 0.0, second = 0.0;
    for (int k = 0; k < NERRORS; k++)
        combine(m, NSTAGES + 1 + k, h, NULL, m->errors[k]);
    for (int i = 0; i < NX; i++) {
        const double w = weight(m, fmax(fabs(m->x[i]), fabs(m->fresh[i])));
        const double e = m->errors[0][i] * w, d = m->errors[1][i] * w;
        first += e * e;
        second += d * d;
    }
    return first == 0.0 ? 0.0 : first / sqrt((first + 0.01 * second) * NX);
}

#if NE > 0
static int prepare_interpolant(Model *m, double h)
{
    for (int k = 0; k < NDENSE; k++) {
        const int stage = NSTAGES + 1 + k;
        combine(m, NSTAGES + 1 + NERRORS + k, h, m->x, m->trial);
        if (rates_at(m, m->t + NODES[stage] * h, m->trial, m->stages[stage]))
            return 1;
    }
    for (int i = 0; i < NX; i++) {
        const double increment = m->fresh[i] - m->x[i], first = h * m->stages[0][i] - increment;
        m->interpolant[0][i] = increment;
        m->interpolant[1][i] = first;
        m->interpolant[2][i] = increment - first - h * m->stages[NSTAGES][i];
    }
    for (int k = 0; k < NINTERPOLANT; k++)
        combine(m, NSTAGES + 1 + NERRORS + NDENSE + k, h, NULL, m->interpolant[3 + k]);
    return 0;
}

/* Evaluate the events at t + theta h along the interpolant. */
static void probe(Model *m, double h, double theta, double *out)
{
    for (int i = 0; i < NX; i++) {
        double value = 0.0;
        for (int k = 2 + NINTERPOLANT; k >= 0; k--)
            value = (value + m->interpolant[k][i]) * (k % 2 ? 1.0 - theta : theta);
        m->trial[i] = m->x[i] + value;
    }
    event_values(m, m->t + theta * h, m->trial, out);
}

/* Return theta just past the crossing of event k between `low` and `high`, by bisection. */
static double locate(Model *m, double h, double low, double high, int k)
{
    const double resolution = 2.220446049250313e-16 * fmax(fabs(m->t), fabs(m->t + h)) / h;
    probe(m, h, low, m->dz);
    if (m->dz[k] * m->sides[k] <= 0.0) {
        const double start = low;
        double middle = high;
        for (;;) {
            middle = start + 0.5 * (middle - start);
            if (middle - start <= resolution)
                return start;
            probe(m, h, middle, m->dz);
            if (m->dz[k] * m->sides[k] > 0.0) {
                low = middle;
                break;
            }
            high = middle;
        }
    }
    while (high - low > resolution) {
        const double middle = low + 0.5 * (high - low);
        if (middle <= low || middle >= high)
            break;
        probe(m, h, middle, m->dz);
        if (m->dz[k] * m->sides[k] > 0.0)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* Look for events in the step just taken: theta where one of them acts, else 1 with `acting` 0. */
static double scan(Model *m, double h, int *acting)
{
    double left = 0.0;
    *acting = 0;
    for (int quarter = 1; quarter <= 4; quarter++) {
        const double right = 0.25 * quarter;
        probe(m, h, right, m->z);
        for (;;) {
            double first = 2.0;
            for (int k = 0; k < NE; k++) {
                m->fired[k] = 0;
                if (crossed(m, k, m->z[k])) {
                    const double theta = locate(m, h, left, right, k);
                    m->fired[k] = theta <= left;
                    first = fmin(first, theta);
                }
            }
            if (first > 1.0)
                break;
            probe(m, h, first, m->dz);
            for (int k = 0; k < NE; k++) {
                m->fired[k] = crossed(m, k, m->dz[k])
                    || (crossed(m, k, m->z[k]) && (m->dz[k] == 0.0 || m->fired[k]));
                *acting = *acting || (m->fired[k] && ACTING[k]);
            }
            if (*acting)
                return first;
            for (int k = 0; k < NE; k++)
                if (m->fired[k])
                    m->sides[k] = -m->sides[k];
            left = first;
        }
        for (int k = 0; k < NE; k++) {
            if (m->z[k] != 0.0)
                m->sides[k] = m->z[k] > 0.0 ? 1 : -1;
            m->fired[k] = 0;
        }
        left = right;
    }
    return 1.0;
}
#endif

enum { REACHED, ENDED, FAILED };

/* Integrate up to the time `goal`. */
static int integrate(Model *m, double goal)
{
    prepare(m);
    for (long steps = 0; m->t < goal; steps++) {
        if (!m->started) {
            if (rates_at(m, m->t, m->x, m->stages[0]))
                return FAILED;
            m->started = 1;
            m->last_error = 1e-4;
            m->growth = GROW;
            if (m->h == 0.0)
                m->h = first_size(m, goal - m->t);
            if (!(m->h > 0.0 && m->h < INFINITY))
                return FAILED;
        }
        if (steps > 10000000L)
            return FAILED;
        double size = m->h, after = m->t + size, error = 0.0;
        const int clipped = after > goal - 1e-3 * size;
        if (clipped) {
            size = goal - m->t;
            after = goal;
        }
        if (!(m->t + 0.0625 * size > m->t || clipped))
            return FAILED;
        int failed = 0;
        for (int stage = 1; stage < NSTAGES && !failed; stage++) {
            combine(m, stage, size, m->x, m->trial);
            failed = rates_at(m, m->t + NODES[stage] * size, m->trial, m->stages[stage]);
        }
        if (!failed) {
            combine(m, NSTAGES, size, m->x, m->fresh);
            error = error_of_step(m, size);
            if (error < 1.0)
                failed = rates_at(m, after, m->fresh, m->stages[NSTAGES]);
        }
        if (failed || !(error < 1.0)) {
            if (failed || !(error < INFINITY))
                m->h = 0.25 * size;
            else
                m->h = size * fmax(SHRINK, SAFETY * pow(error, -EXPONENT));
            m->growth = 1.0;
            continue;
        }
#if NE > 0
        int acting;
        if (prepare_interpolant(m, size))
            return FAILED;
        const double theta = scan(m, size, &acting);
        if (acting) {
            if (theta < 1.0) {
                probe(m, size, theta, m->dz);
                memcpy(m->x, m->trial, NX * sizeof(double));
                m->t += theta * size;
            } else {
                memcpy(m->x, m->fresh, NX * sizeof(double));
                m->t = after;
            }
            changed(m);
            m->h = 0.0;
            if (act(m))
                return ENDED;
            continue;
        }
#endif
        error = fmax(error, 1e-10);
        double factor = SAFETY * pow(error, -ALPHA);
        if (BETA != 0.0)
            factor *= pow(m->last_error, BETA);
        const double next = size * fmin(m->growth, fmax(SHRINK, factor));
        m->h = clipped ? fmax(m->h, next) : next;
        m->last_error = fmax(error, 1e-4);
        m->growth = GROW;
        m->t = after;
        memcpy(m->x, m->fresh, NX * sizeof(double));
        memcpy(m->stages[0], m->stages[NSTAGES], NX * sizeof(double));
        m->rates_fresh = m->outputs_fresh = 0;
    }
    return REACHED;
}

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
