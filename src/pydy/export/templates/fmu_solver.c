/* The adaptive explicit Runge-Kutta method behind Co-Simulation, with events: the loop of pydy's
   native solvers, with the same first step, error norm, controller and interpolant. Included by
   fmu_core.c. */

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
