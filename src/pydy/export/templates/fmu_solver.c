/* The solver behind Co-Simulation: the loop of pydy's native solvers (advance.c) on the arrays of an
   instance, up to the next communication point. Included by fmu_core.c. */

enum { MOST_STEPS = 10000000 }; /* in a communication step */

/* How the loop calls the model. */
static int32_t call_rates(const double *t, const double *x, const double *u, const double *c, double *out)
{
    return MODEL(rates)(*t, x, u, c, out);
}

static int32_t call_events(const double *t, const double *x, const double *u, const double *c, double *out)
{
#if NE > 0
    return MODEL(events)(*t, x, u, c, out);
#else
    return (void)t, (void)x, (void)u, (void)c, (void)out, 0;
#endif
}

static int32_t call_event_rates(const double *t, const double *x, const double *u, const double *c, double *out)
{
#if NE > 0
    return MODEL(event_rates)(*t, x, u, c, out) || MODEL(event_bounds)(*t, x, u, c, out + NE);
#else
    return (void)t, (void)x, (void)u, (void)c, (void)out, 0;
#endif
}

#define ADDRESS(function) (int64_t)(intptr_t)(function)
#define AT(array) {(void *)(array), sizeof(array) / 8, 1}
#define VECTORS(array, number) {(double *)(array), (number) * NX, 1}

/* Copy the rows of switches; those that rounding does not keep apart from the ends of a step are there, as the
   step would be as short as rounding otherwise. Return how many there are. */
static int64_t switch_rows(Model *m, double goal, double *rows)
{
    prepare(m);
    memcpy(rows, m->switches, 3 * (size_t)m->switch_count * sizeof(double));
    for (double *row = rows; row < rows + 3 * m->switch_count; row += 3) {
        if (row[1] < goal && goal < row[2])
            row[0] = goal;
        if (row[1] < m->t && m->t < row[2]) {
            row[0] = m->t;
            m->counts[STARTED] = 0; /* the rates at the end of the last step are those before the switch */
        }
    }
    return m->switch_count;
}

/* Let the events happen that inputs or constants have led across their surfaces since the last step, as a jump
   of a sampled input does: FINISHED, or the outcome with which that ends the motion. Their surfaces are left
   behind: values tell the sides, not rates. */
static int64_t act_on_leaps(Model *m)
{
    int64_t leapt[NE + 1], outcome = FINISHED;
    int some = 0;
    evaluate_events(m);
    for (int k = 0; k < NE; k++) {
        leapt[k] = m->led[k], m->led[k] = 0;
        m->fired[k] = leapt[k] && crossed(m->sides[k], m->z[k], EVENT_DIRECTIONS[k]);
        some = some || m->fired[k];
    }
    if (some)
        outcome = act(m);
    for (int k = 0; k < NE; k++)
        if (leapt[k] && m->z[k] != 0.0)
            m->sides[k] = sign_of(m->z[k]);
    return outcome;
}

/* Integrate up to the time `goal`: FINISHED, or the outcome with which the motion ends or fails before. */
static int64_t integrate(Model *m, double goal)
{
    static Kernel *const rates_at = call_rates, *const events_at = call_events;
    static Kernel *const event_rates_at = call_event_rates;
    int64_t problem[] = {ADDRESS(&rates_at), NX, NX, NX, NX, [SWITCHED] = 0, 0}, held[ACTIVE + 1] = {0};
    double jumps[3 * NS + 1], until[] = {INFINITY};
    int64_t watched[RESETTER + 1] = {ADDRESS(&events_at), NE, ADDRESS(scan_events), [RATER] = ADDRESS(&event_rates_at)};
    int64_t kinds[NE + 1] = {0}, kept[ROOM + 1] = {0};
    double clock[1], step[1], theta[1], zero[NX + 1] = {0}, row[NX + 1], tolerance[NX + 1];
    const Run run = {
        .method = {AT(METHOD_SHAPE), AT(METHOD_ROWS), AT(METHOD_OFFSETS), AT(METHOD_WEIGHTS),
            AT(METHOD_NODES), AT(METHOD_CONTROL)},
        .problem = {.words = AT(problem), .clock = AT(clock), .r = AT(m->u), .c = AT(m->prepared),
            .jumps = {jumps, switch_rows(m, goal, jumps), 3}, .until = AT(until)},
        .memory = {.x = VECTORS(m->x, 1), .new = VECTORS(m->fresh, 1), .trial = VECTORS(m->trial, 1),
            .step = AT(step), .theta = AT(theta), .zero = VECTORS(zero, 1),
            .errors = VECTORS(m->errors, 2), .stages = VECTORS(m->stages, NVECTORS),
            .interpolant = VECTORS(m->interpolant, NPARTS), .rtol = AT(tolerance),
            .atol = AT(tolerance)},
        .progress = {AT(m->state), AT(m->counts), {&goal, 1, 1}},
        .constraints = {.words = AT(held)},
        .watch = {.words = AT(watched), .c = AT(m->prepared), .directions = AT(EVENT_DIRECTIONS),
            .acting = AT(EVENT_ACTING), .kinds = AT(kinds), .sides = AT(m->sides),
            .fired = AT(m->fired),
            .values = AT(m->probes), .trial = AT(m->probe),
            .rates_c = AT(m->prepared), .told = AT(m->dz)},
        .steps = {.words = AT(kept)},
    };
    if (NX == 0)
        m->t = fmax(m->t, goal);
    for (int i = 0; i < NX; i++)
        tolerance[i] = m->rtol;
    problem[SWITCHED] = run.problem.jumps.size > 0;
    m->probes[PROBES * NE] = UNKNOWN;
    int moved = 0;
    if (m->starting)
        remember_inputs(m);
    const int64_t outcome = m->starting ? start_events(m, &moved) : act_on_leaps(m);
    if (outcome != FINISHED)
        return outcome;
    while (m->t < goal) {
        m->state[TIME] = m->t, m->state[LARGEST] = goal - m->t;
        m->counts[STEPS] = m->counts[REJECTED] = m->counts[NEXT] = 0;
        m->counts[LIMIT] = MOST_STEPS, m->counts[BUDGET] = -1;
        int64_t code = advance(&run, row, 0);
        m->t = m->state[TIME];
        m->rates_fresh = m->outputs_fresh = 0;
        if (code == EVENT) {
            changed(m);
            code = act(m);
        } else if (code != FINISHED) {
            int64_t event = 0;
            while (event < NE - 1 && !m->fired[event])
                event++;
            ends_with(m, code == STEP_UNDERFLOW ? m->counts[FAILURE] : code, event);
        }
        if (code != FINISHED)
            return m->outcome;
    }
    return FINISHED;
}
