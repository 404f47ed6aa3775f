/* The loop around steps of W trajectories at once: explicit ones, or IMPLICIT ones by Radau IIA.

   Each lane has its own time, step size and outputs. A lane that has come to its end takes the next
   sample from the queue at once; when there are no more, it repeats a neighbour's state, step size
   zero. All arithmetic goes place by place, in an order that depends on nothing but the method: a
   sample gives the same bits in any lane, beside any neighbours. */

#include "lanes.h"

#ifdef IMPLICIT
#include "newton.h"
#define step_lanes step_lanes_implicit
#else
#include "step.h"
#endif

/* For each lane among some bits. */
#define FOR_LANES(which) \
    for (int64_t left_ = (which), lane; left_ != 0 && (lane = __builtin_ctzll(left_), 1); \
        left_ &= left_ - 1)

#define OF(field) item(l->field.at, 0)
#define SET(field, which, value) put(l->field.at, 0, where(which, (Real)(value), OF(field)))
#define ADD(field, value) put(l->field.at, 0, OF(field) + (value))

/* A step that all lanes try, and what came of it. */
typedef struct {
    Real t, size, after, goal;
    int64_t working, missed, unresolved; /* who tries, misses constraints, and is too long for events */
} Trial;

/* -- what each lane does alone ---------------------------------------------------------------- */

INLINE const Run *alone_in(const LaneRun *run, int64_t lane)
{
    return (const Run *)run->alone.runs.at[lane];
}

/* Give the run of a lane the inputs of a sample, and no events yet. */
INLINE void take_alone(const LaneRun *run, int64_t sample, int64_t lane)
{
    const Alone *g = &run->alone;
    const LaneWatch *w = &run->lane_watch;
    const Run *own = alone_in(run, lane);
    const Numbers *r = &run->queue.r, *p = &run->queue.p;
    SERIAL
    for (int64_t i = 0; i < r->columns; i++)
        own->problem.r.at[i] = r->at[sample * r->columns + i];
    for (int64_t k = 0; k < g->prepared.size; k++) {
        const int64_t *row = g->prepared.at + k * g->prepared.columns;
        (*(Prepare *const *)row[0])(p->at + sample * p->columns, (double *)row[1 + lane]);
    }
    for (int64_t k = 0; k < w->words.at[EVENTS]; k++) {
        w->sides.at[k * W + lane] = (double)w->began.at[sample * w->began.columns + k];
        for (int64_t i = 0; i < CROWD; i++)
            own->watch.latest.at[k * CROWD + i] = i == 0 ? w->first.at[sample * w->first.columns + k] : -INF;
        own->watch.rests.at[2 * k] = own->watch.rests.at[2 * k + 1] = __builtin_nan("");
        w->known.at[lane] = __builtin_nan("");
    }
    own->progress.counts.at[LOGGED] = 0;
}

/* Move the log of a lane to that of all, where one is kept. */
APART void empty_log(const LaneRun *run, int64_t lane)
{
    const LaneWatch *w = &run->lane_watch;
    const Watch *own = &alone_in(run, lane)->watch;
    int64_t *number = alone_in(run, lane)->progress.counts.at + LOGGED, n = w->log_states.columns;
    for (int64_t k = 0; k < *number && w->log_times.size > 0; k++) {
        const int64_t line = w->words.at[LANES_LOGGED]++;
        w->log_samples.at[line] = run->lanes.samples.at[lane];
        w->log_times.at[line] = own->log_times.at[k];
        w->log_events.at[line] = own->log_events.at[k];
        SERIAL
        for (int64_t i = 0; i < n; i++) {
            w->log_states.at[line * n + i] = own->log_states.at[k * n + i];
            w->log_after.at[line * n + i] = own->log_after.at[k * n + i];
        }
    }
    *number = 0;
}

/* Tell whether the log of all lanes may have no room for what they may log until it is looked at. */
INLINE int log_is_full(const LaneRun *run)
{
    const LaneWatch *w = &run->lane_watch;
    return w->log_times.size > 0
        && w->words.at[LANES_LOGGED] + 2 * W * (1 + alone_in(run, 0)->watch.log_times.size) > w->log_times.size;
}

/* Note what a sample's run ends with. */
INLINE void leave_alone(const LaneRun *run, int64_t sample, int64_t lane)
{
    const LaneWatch *w = &run->lane_watch;
    for (int64_t k = 0; k < w->words.at[EVENTS]; k++) {
        w->began.at[sample * w->began.columns + k] = (int64_t)w->sides.at[k * W + lane];
        for (int64_t i = 2 * k; i < 2 * k + 2; i++)
            w->rests.at[sample * w->rests.columns + i] = alone_in(run, lane)->watch.rests.at[i];
    }
    empty_log(run, lane);
}

/* Move the states of some lanes onto their constraints; return the bits of those that missed. `ends`
   tells whether steps end there. */
APART int64_t hold_lanes(const LaneRun *run, const double *times, double *x, int64_t which, int ends)
{
    ProjectLanes *project = (ProjectLanes *)run->constraints.words.at[PROJECT];
    return project(run, times, x, ends ? run->memory.x.at : 0, which);
}

/* -- samples come and go ---------------------------------------------------------------------- */

/* Copy one lane to another. */
INLINE void copy_over(double *buffer, int64_t items, int64_t source, int64_t target)
{
    SERIAL
    for (int64_t i = 0; i < items; i++)
        buffer[i * W + target] = buffer[i * W + source];
}

/* Write a vector as the next output of some lanes, and count it. */
APART void write_outputs(const LaneRun *run, const double *values, int64_t which)
{
    const Lanes *l = &run->lanes;
    const int64_t n = run->lane_problem.words.at[STATES];
    const int64_t distance = run->queue.state.at[LANES_DISTANCE];
    FOR_LANES(which) {
        double *place = (double *)l->place.at[lane];
        l->place.at[lane] += 8;
        SERIAL
        for (int64_t i = 0; i < n; i++)
            place[i * distance] = values[i * W + lane];
        l->next.at[lane] += 1.0;
        l->due.at[lane] = run->queue.times.at[(int64_t)l->next.at[lane]];
    }
}

/* Write down how the samples of some lanes ended, and give the lanes free. A negative status: as
   their last rejected step did. */
APART void retire(const LaneRun *run, int64_t which, int64_t status)
{
    const Lanes *l = &run->lanes;
    const Queue *q = &run->queue;
    const int64_t n = run->lane_problem.words.at[STATES], distance = q->state.at[LANES_DISTANCE];
    FOR_LANES(which) {
        const int64_t sample = l->samples.at[lane];
        double *place = (double *)l->place.at[lane];
        for (int64_t k = q->times.size - 1 - (int64_t)l->next.at[lane]; k > 0; k--, place++) {
            SERIAL
            for (int64_t i = 0; i < n; i++)
                place[i * distance] = __builtin_nan("");
        }
        int64_t *counts = q->counts.at + sample * q->counts.columns;
        counts[LANES_STEPS] = (int64_t)l->steps.at[lane];
        counts[LANES_REJECTED] = (int64_t)l->rejected.at[lane];
        counts[LANES_EVALUATIONS] = (int64_t)l->evaluations.at[lane];
        counts[LANES_STATUS] = status < 0 ? (int64_t)l->reason.at[lane] : status;
        q->reached.at[sample] = l->time.at[lane];
        copy_out(seen_by(run), lane, &q->seen, sample);
        if (run->alone.runs.size > 0)
            leave_alone(run, sample, lane);
        l->samples.at[lane] = LANES_VACANT;
    }
}

/* Give vacant lanes the next samples; return the bits of these and, in *working, of all that work. */
APART int64_t fill(const LaneRun *run, int64_t *working)
{
    const Lanes *l = &run->lanes;
    const Queue *q = &run->queue;
    const LaneProblem *p = &run->lane_problem;
    const Memory *m = &run->memory;
    int64_t fresh = 0, all = 0, example = -1, *head = q->state.at + LANES_HEAD;
    for (int64_t lane = 0; lane < W; lane++) {
        while (*head < q->x.size && q->counts.at[*head * q->counts.columns + LANES_STATUS] != FINISHED)
            *head += 1; /* who has ended already is left out */
        if (l->samples.at[lane] == LANES_VACANT && *head < q->x.size) {
            const int64_t sample = *head;
            *head += 1;
            l->samples.at[lane] = sample;
            copy_in(&q->x, sample, m->x.at, lane);
            copy_in(&q->r, sample, p->r.at, lane);
            copy_in(&q->p, sample, p->p.at, lane);
            copy_in(&q->bounds, sample, m->atol.at + W * p->words.at[CONTROLLED], lane);
            copy_in(&q->seen, sample, seen_by(run), lane);
            if (run->alone.runs.size > 0)
                take_alone(run, sample, lane);
            l->time.at[lane] = q->times.at[0];
            fresh |= (int64_t)1 << lane;
        }
        if (l->samples.at[lane] >= 0) {
            all |= (int64_t)1 << lane;
            example = lane;
        }
    }
    *working = all;
    if (example < 0)
        return fresh;
    for (int64_t lane = 0; lane < W; lane++)
        if (l->samples.at[lane] == LANES_VACANT) {
            copy_over(m->x.at, p->words.at[STATES], example, lane);
            copy_over(m->stages.at, p->words.at[STATES], example, lane);
            copy_over(p->r.at, p->words.at[LANES_SPECIFIEDS], example, lane);
            copy_over(p->p.at, p->words.at[LANES_CONSTANTS], example, lane);
            copy_over(m->atol.at + W * p->words.at[CONTROLLED], q->bounds.columns, example, lane);
            l->time.at[lane] = l->time.at[example], l->size.at[lane] = 0.0;
            l->due.at[lane] = INF, l->samples.at[lane] = LANES_RESTING;
        }
    prepare(p);
    return fresh;
}

/* -- the two kinds of steps -------------------------------------------------------------------- */

/* Return the shortest step that errors which are only bounded make shorter. */
INLINE double least_step(const LaneRun *run)
{
    const Numbers *times = &run->queue.times; /* the last is infinity */
    return LEAST_BOUNDED * (times->at[times->size - 2] - times->at[0]);
}

#ifdef IMPLICIT

INLINE Implicit implicit_in(const LaneRun *run)
{
    return implicit_of(&run->lane_problem, &run->memory, &run->newton, least_step(run));
}

INLINE int is_adaptive(const LaneRun *run)
{
    (void)run;
    return 1;
}

/* Begin in some lanes, whose first steps are set where they are not `guessed`; return the bits of those
   that needed a further evaluation. */
INLINE int64_t begin_steps(const LaneRun *run, const Stepper *s, Real t, int64_t which, int64_t guessed)
{
    const Lanes *l = &run->lanes;
    const double largest = run->queue.numbers.at[LANES_LARGEST];
    Real slope;
    const Real trial = first_trial(s->memory, s->equations->words.at[STATES], largest, &slope);
    SET(size, flags(guessed), bounded_first_size(trial, t, largest));
    begin_newton(&run->newton, which);
    return 0;
}

INLINE Attempt attempt(const LaneRun *run, const Stepper *s, const Trial *trial)
{
    const Lanes *l = &run->lanes;
    const Implicit method = implicit_in(run);
    const Attempt a = try_step(&method, trial->t, OF(size), trial->size, trial->after, trial->working);
    put(s->memory->step.at, 0, trial->size);
    ADD(evaluations, a.evaluations);
    return a;
}

/* Accept the steps of some lanes, which keep their constraints; return the bits of those. */
INLINE int64_t complete(const LaneRun *run, const Stepper *s, const Trial *trial, int64_t good, Attempt *a)
{
    const Implicit method = implicit_in(run);
    (void)s;
    accept(&method, trial->size, good, a);
    return good;
}

/* Prepare for states within the step; return the bits of the lanes that failed. */
INLINE int64_t open_step(const LaneRun *run, const Stepper *s, const Trial *trial, int64_t within)
{
    (void)run, (void)s, (void)trial, (void)within;
    return 0;
}

/* Set the sizes of the next steps of all lanes, of which some were `good`, and say of the others why. */
INLINE void set_sizes(const LaneRun *run, const Trial *trial, int64_t good, const Attempt *a)
{
    const Lanes *l = &run->lanes;
    const int64_t bad = trial->working & ~good, undone = bad & (trial->missed | trial->unresolved);
    const Flags off = flags(trial->missed), some = flags(undone);
    const int64_t refused = bad & ~undone & bits((a->error >= 1.0) & finite(a->error));
    Real next = a->next;
    if (run->lane_problem.tables.size > 0)
        next = sizes_at_knots(&run->lane_problem, trial->t, trial->after, refused, good & a->again, next, next);
    Real h = where(flags(good) & (trial->after == trial->goal), maximum(OF(size), next), next);
    h = where(some, AFTER_FAILURE * trial->size, h);
    const Real reason = where(some, where(off, (Real)(CONSTRAINTS_NOT_MET), (Real)(STEP_UNDERFLOW)), a->reason);
    SET(reason, flags(bad), reason);
    undo(&run->newton, undone);
    put(l->size.at, 0, h);
}

#else

typedef struct {
    int64_t good, failed; /* whose steps are accepted so far, and whose right-hand side failed */
    Real error;
} Attempt;

INLINE int is_adaptive(const LaneRun *run) { return run->method.shape.at[ESTIMATES] > 0; }

/* Guess the first step, with one further evaluation. */
INLINE Real guess_first_size(const Stepper *s, Real t, double largest)
{
    const Memory *m = s->memory;
    const int64_t controlled = s->equations->words.at[CONTROLLED];
    Real slope;
    const Real trial = first_trial(m, controlled, largest, &slope);
    for (int64_t i = 0; i < s->equations->words.at[STATES]; i++)
        put(m->trial.at, i, item(m->x.at, i) + trial * item(m->stages.at, i));
    const int64_t failed = rates(s->equations, t + trial, m->trial.at, m->stages.at + m->x.size);
    const double exponent = s->method->control.at[EXPONENT];
    const Real size = first_size(m, exponent, controlled, t, largest, trial, slope);
    return where(flags(failed), SLIVER * trial, size);
}

/* Begin in some lanes, whose first steps are set where they are not `guessed`; return the bits of those
   that needed a further evaluation. */
INLINE int64_t begin_steps(const LaneRun *run, const Stepper *s, Real t, int64_t which, int64_t guessed)
{
    const Lanes *l = &run->lanes;
    SET(last_error, flags(which), FIRST_ERROR);
    SET(growth, flags(which), s->method->control.at[GROW]);
    if (guessed != 0)
        SET(size, flags(guessed), guess_first_size(s, t, run->queue.numbers.at[LANES_LARGEST]));
    return guessed;
}

INLINE Attempt attempt(const LaneRun *run, const Stepper *s, const Trial *trial)
{
    const Lanes *l = &run->lanes;
    const Memory *m = s->memory;
    const int64_t *shape = s->method->shape.at, n = s->equations->words.at[STATES];
    const int reuse = shape[END_IN_ESTIMATE] == 1;
    int64_t calls = 0;
    Attempt a = {.failed = take_step(s, trial->t, trial->size, &calls), .error = (Real)(0.0)};
    if (reuse)
        a.failed |= rates(s->equations, trial->after, m->new.at, m->stages.at + shape[STAGES] * m->x.size);
    if (is_adaptive(run))
        a.error = error_of_step(s, least_step(run));
    else
        for (int64_t i = 0; i < n; i++)
            a.error = a.error + 0.0 * item(m->new.at, i); /* NaN where the state is not finite */
    a.good = trial->working & bits(a.error < 1.0) & ~a.failed;
    ADD(evaluations, (double)(shape[STAGES] - 1 + reuse));
    return a;
}

/* Evaluate the derivatives where the steps of some lanes end, which keep their constraints; return the
   bits of those that did not fail. */
INLINE int64_t complete(const LaneRun *run, const Stepper *s, const Trial *trial, int64_t good, Attempt *a)
{
    const Lanes *l = &run->lanes;
    const Memory *m = s->memory;
    const int64_t *shape = s->method->shape.at;
    if (good == 0 || (shape[END_IN_ESTIMATE] == 1 && run->constraints.words.at[ACTIVE] != 1))
        return good;
    a->failed |= rates(s->equations, trial->after, m->new.at, m->stages.at + shape[STAGES] * m->x.size);
    ADD(evaluations, SOME(flags(good), 1.0));
    return good & ~a->failed;
}

/* Prepare for states within the step; return the bits of the lanes that failed. */
INLINE int64_t open_step(const LaneRun *run, const Stepper *s, const Trial *trial, int64_t within)
{
    const Lanes *l = &run->lanes;
    int64_t calls = 0;
    ADD(evaluations, SOME(flags(within), s->method->shape.at[DENSE_STAGES]));
    return prepare_interpolant(s, trial->t, trial->size, &calls) & within;
}

/* Set the sizes of the next steps of all lanes, of which some were `good`, and say of the others why. */
INLINE void set_sizes(const LaneRun *run, const Trial *trial, int64_t which, const Attempt *a)
{
    const Lanes *l = &run->lanes;
    const double *control = run->method.control.at;
    const int adaptive = is_adaptive(run);
    const Flags good = flags(which), bad = flags(trial->working & ~which);
    Real h = OF(size);
    if (adaptive) {
        h = next_size(control, trial->size, a->error, OF(last_error), OF(growth));
        const int64_t again = which & bits(OF(growth) == 1.0);
        if (again != 0 && run->lane_problem.tables.size > 0)
            h = sizes_at_knots(&run->lane_problem, trial->t, trial->after, 0, again, h,
                next_size(control, trial->size, a->error, OF(last_error), (Real)(control[GROW])));
        /* shortened to end there */
        h = where(trial->after == trial->goal, maximum(OF(size), h), h);
        SET(last_error, good, maximum(a->error, (Real)(FIRST_ERROR)));
        put(l->growth.at, 0, where(bad, (Real)(1.0), (Real)(control[GROW])));
    }
    if (bits(bad) != 0) {
        const Flags singular = flags(a->failed), off = flags(trial->missed), far = flags(trial->unresolved);
        const Flags measured = (absolute(a->error) < INF) & ~singular & ~off & ~far;
        /* a step of fixed size that fails cannot be helped */
        const Real shorter =
            adaptive ? shorter_size(control, trial->size, a->error, measured) : (Real)(0.0);
        const Real reason = where(measured | far, (Real)(STEP_UNDERFLOW), (Real)(NOT_FINITE));
        h = where(bad, shorter, h);
        if (adaptive && run->lane_problem.tables.size > 0)
            h = sizes_at_knots(&run->lane_problem, trial->t, trial->after, bits(bad & measured), 0, h, h);
        SET(reason, bad, where(off, (Real)(CONSTRAINTS_NOT_MET), reason));
        SET(reason, bad, where(singular, (Real)(SINGULAR), reason));
    }
    put(l->size.at, 0, h);
}

#endif

/* -- samples begin ------------------------------------------------------------------------------ */

/* Hold the inputs of all lanes, as one trajectory's; set the times of their next jumps. */
APART void hold_all(const LaneRun *run, double *jumps)
{
    for (int64_t lane = 0; lane < W; lane++)
        jumps[lane] = hold_inputs(&run->lane_problem, run->lanes.time.at[lane], lane);
}

/* Begin with the samples that lanes have just taken, and go on after the events of others. */
APART void start(const LaneRun *run, const Stepper *s, int64_t fresh, int64_t after)
{
    const Lanes *l = &run->lanes;
    const Queue *q = &run->queue;
    const Memory *m = s->memory;
    const Flags new = flags(fresh), begin = flags(fresh | after);
    const Real t = OF(time);
    double jumps[W];
    hold_all(run, jumps);
    const int64_t failed = rates(s->equations, t, m->x.at, m->trial.at) & (fresh | after);
    for (int64_t i = 0; i < s->equations->words.at[STATES]; i++)
        put(m->stages.at, i, where(begin, item(m->trial.at, i), item(m->stages.at, i)));
    const double first = q->numbers.at[LANES_FIRST];
    /* what the user asked for is the first step alone, or all */
    int64_t guessed = first == 0.0 ? fresh | after : is_adaptive(run) ? after : 0;
    SET(size, begin, first);
    guessed = begin_steps(run, s, t, fresh | after, guessed);
    SET(steps, new, 0.0);
    SET(rejected, new, 0.0);
    SET(evaluations, new, 0.0);
    SET(reason, begin, where(usable(OF(size)), (Real)(STEP_UNDERFLOW), (Real)(NOT_FINITE)));
    FOR_LANES(fresh) {
        const int64_t before = l->samples.at[lane] * (q->times.size - 1);
        l->next.at[lane] = 0.0, l->due.at[lane] = q->times.at[0];
        l->place.at[lane] = q->state.at[LANES_PLACE] + 8 * before;
    }
    for (int64_t well = fresh & ~failed; well != 0;) { /* the first time may be asked for twice */
        write_outputs(run, m->x.at, well);
        well &= bits(OF(due) == q->times.at[0]);
    }
    const int64_t finished = (fresh | after) & ~failed & bits(OF(due) == INF);
    ADD(evaluations, SOME(begin, 1.0) + SOME(flags(guessed & ~failed & ~finished), 1.0));
    retire(run, failed, SINGULAR);
    retire(run, finished, FINISHED);
}

/* Evaluate the derivatives of some lanes anew, as after their inputs have jumped; return the bits of those
   that failed, and retire them. */
APART int64_t start_again(const LaneRun *run, const Stepper *s, int64_t which)
{
    const Lanes *l = &run->lanes;
    const Memory *m = s->memory;
    const Flags some = flags(which);
    release_inputs(s->equations);
    const int64_t failed = rates(s->equations, OF(time), m->x.at, m->trial.at) & which;
    for (int64_t i = 0; i < s->equations->words.at[STATES]; i++)
        put(m->stages.at, i, where(some, item(m->trial.at, i), item(m->stages.at, i)));
    ADD(evaluations, SOME(some, 1.0));
    retire(run, failed, SINGULAR);
    return failed;
}

/* -- events ----------------------------------------------------------------------------------- */

/* Return the bits of the lanes whose events stay away from zero in the step just taken, as
   `stays_clear` tells of one. */
APART int64_t clear_lanes(const LaneRun *run)
{
    const Memory *m = &run->memory;
    const LaneWatch *w = &run->lane_watch;
    const int64_t *words = w->words.at, *kinds = alone_in(run, 0)->watch.kinds.at;
    const int64_t number = words[EVENTS];
    const Real h = item(m->step.at, 0);
    if (words[REACHER] == 0)
        return 0;
    for (int64_t j = 0; j < w->moving.size; j++) {
        const int64_t i = w->moving.at[j];
        Real far = sizes(item(m->new.at, i) - item(m->x.at, i));
#ifdef IMPLICIT
        for (int64_t stage = 0; stage < 3; stage++)
            far = larger(far, sizes(item(run->newton.stages.at, stage * run->lane_problem.words.at[STATES] + i)));
#else
        for (int64_t stage = 0; stage <= run->method.shape.at[STAGES]; stage++)
            far = larger(far, h * sizes(item(m->stages.at + stage * m->x.size, i)));
#endif
        put(w->reach.at, words[MOVES] + i, CLEAR * far);
    }
    put(w->reach.at, words[MOVES] + words[MOVING], h);
    put(run->lane_problem.clock.at, 0, item(run->lanes.time.at, 0));
    const int64_t failed = call_kernel(words[REACHER], run->lane_problem.clock.at, m->x.at, w->reach.at,
        w->reach_c.at, w->further.at);
    Flags clear = flags(~failed & ((1 << W) - 1));
    for (int64_t k = 0; k < number; k++)
        if (!(kinds[k] & TURNS))
            clear = clear & (item(w->further.at, k) * item(w->sides.at, k) > item(w->further.at, number + k));
    return bits(clear);
}

/* Tell where the samples of an event, on its side of zero, may have a least value between them: there
   `least_place` has a closer look. */
INLINE Flags may_dip(const Real *z)
{
    Flags found = flags(0);
    Real left = (z[1] - z[0]) / (scan_points[1] - scan_points[0]);
    for (int i = 1; i < PARTS; i++) {
        const double a = scan_points[i - 1], b = scan_points[i], c = scan_points[i + 1];
        const Real right = (z[i + 1] - z[i]) / (c - b);
        const Flags bent = (right > left) & (z[i - 1] > 0.0);
        if (bits(bent) != 0) {
            const Real bend = (right - left) / (c - a), slope = left + bend * (b - a);
            const Real place = b - 0.5 * slope / bend;
            const double first = i > 1 ? a : -scan_points[1];
            const double last = i + 1 < PARTS ? c : 2.0 - scan_points[PARTS - 1];
            found = found | (bent & (place >= first) & (place <= last));
        }
        left = right;
    }
    return found;
}

/* Evaluate all event expressions at t + theta h of each lane; return the bits of those that failed. */
INLINE int64_t probe_lanes(const LaneRun *run, const Stepper *s, double theta, double *out)
{
    const LaneProblem *p = &run->lane_problem;
    const Real t = item(run->lanes.time.at, 0), h = item(s->memory->step.at, 0);
    interpolate(s, (Real)(theta), s->memory->trial.at);
    set_inputs(p, t + theta * h);
    return call_kernel(run->lane_watch.words.at[WATCHER], p->clock.at, s->memory->trial.at, p->r.at,
        run->lane_watch.c.at, out);
}

/* Return the bits of the lanes, of those that `look`, in whose steps `scan_events` would find nothing
   without a closer look: at the ends of all parts each event is on its side, far from zero as far as
   it is not linear, and dips nowhere. */
APART int64_t quiet_lanes(const LaneRun *run, const Stepper *s, int64_t look, const double *after)
{
    const LaneWatch *w = &run->lane_watch;
    const int64_t number = w->words.at[EVENTS], *kinds = alone_in(run, 0)->watch.kinds.at;
    const Flags unknown = item(w->known.at, 0) != item(run->lanes.time.at, 0);
    int64_t failed = 0;
    if ((bits(unknown) & look) != 0) {
        failed |= probe_lanes(run, s, scan_points[0], w->further.at) & bits(unknown);
        for (int64_t k = 0; k < number; k++)
            put(w->ends.at, k, where(unknown, item(w->further.at, k), item(w->ends.at, k)));
    }
    for (int part = 1; part <= PARTS; part++)
        failed |= probe_lanes(run, s, scan_points[part], w->ends.at + part * number * W);
    Flags quiet = flags(look & ~failed);
    for (int64_t k = 0; k < number; k++) {
        const Real side = item(w->sides.at, k);
        Real z[PARTS + 1], least, most;
        for (int j = 0; j <= PARTS; j++) {
            const Real value = item(w->ends.at, j * number + k);
            z[j] = value * side;
            least = j == 0 ? value : minimum(least, value);
            most = j == 0 ? value : maximum(most, value);
            quiet = j == 0 ? quiet : quiet & (z[j] > 0.0);
        }
        if (!(kinds[k] & LINEAR))
            quiet = quiet & (least * most > 0.0) & (minimum(absolute(least), absolute(most)) > PARTS * (most - least));
        quiet = quiet & ~may_dip(z);
    }
    for (int64_t k = 0; k < number; k++)
        put(w->ends.at, k, where(quiet, item(w->ends.at, PARTS * number + k), item(w->ends.at, k)));
    put(w->known.at, 0, where(quiet, item(after, 0), item(w->known.at, 0)));
    return bits(quiet);
}

/* Copy what a lane knows of its events to its own run, or back. */
INLINE void exchange(const LaneRun *run, int64_t lane, int back)
{
    const LaneWatch *w = &run->lane_watch;
    const Watch *own = &alone_in(run, lane)->watch;
    const int64_t number = w->words.at[EVENTS];
    double *ends = own->values.at + ENDS * number, *known = own->values.at + PROBES * number;
    if (back)
        w->known.at[lane] = *known;
    else
        *known = w->known.at[lane];
    SERIAL
    for (int64_t k = 0; k < number; k++)
        if (back)
            w->sides.at[k * W + lane] = (double)own->sides.at[k], w->ends.at[k * W + lane] = ends[k];
        else
            own->sides.at[k] = (int64_t)w->sides.at[k * W + lane], ends[k] = w->ends.at[k * W + lane];
}

/* Look for events in the step of one lane as in that of one trajectory; the code is that of
   `scan_events`. */
APART int64_t look_alone(const LaneRun *run, int64_t lane, double after, double *theta)
{
    const Run *own = alone_in(run, lane);
    const Memory *m = &run->memory, *to = &own->memory;
    const int64_t n = run->lane_problem.words.at[STATES];
    SERIAL
    for (int64_t i = 0; i < n; i++) {
        to->x.at[i] = m->x.at[i * W + lane], to->new.at[i] = m->new.at[i * W + lane];
        for (int64_t j = 0; j < run->method.shape.at[DEPTH]; j++)
            to->interpolant.at[j * to->x.size + i] = m->interpolant.at[j * m->x.size + i * W + lane];
    }
    exchange(run, lane, 0);
    own->progress.state.at[TIME] = after;
    const double t = run->lanes.time.at[lane];
    own->problem.until.at[0] = run->lane_problem.until.at[lane];
    const int64_t code = ((Scan *)own->watch.words.at[SCAN])(own, t, m->step.at[lane]);
    own->problem.until.at[0] = INF;
    *theta = own->progress.state.at[FOUND];
    exchange(run, lane, 1);
    return code;
}

/* Look for events in the steps of some lanes, with a code for each, and the theta up to which each
   step counts; at `jumps` inputs jump. Return the bits of those that end at events; others may be too long. */
APART int64_t look_for_events(const LaneRun *run, const Stepper *s, int64_t look, const double *after,
    const double *jumps, int64_t *codes, double *theta, int64_t *unresolved)
{
    int64_t stopped = 0;
    for (int64_t lane = 0; lane < W; lane++)
        theta[lane] = 1.0;
    look &= ~quiet_lanes(run, s, look & ~bits(item(after, 0) == item(jumps, 0)), after);
    FOR_LANES(look) {
        codes[lane] = look_alone(run, lane, after[lane], theta + lane);
        *unresolved |= (int64_t)(codes[lane] == UNRESOLVED) << lane;
        stopped |= (int64_t)(codes[lane] != 0 && codes[lane] != UNRESOLVED) << lane;
        if (codes[lane] == UNRESOLVED)
            theta[lane] = 1.0;
    }
    return stopped;
}

/* Set the states in which the steps of some lanes end before their time; return the bits of those whose
   constraints were missed there. */
APART int64_t end_within(const LaneRun *run, const Stepper *s, int64_t stopped, const double *ends,
    const double *theta)
{
    const Memory *m = s->memory;
    const Flags inside = flags(stopped) & (item(theta, 0) < 1.0);
    interpolate(s, where(inside, item(theta, 0), (Real)(1.0)), m->trial.at);
    for (int64_t i = 0; i < s->equations->words.at[STATES]; i++)
        put(m->new.at, i, where(inside, item(m->trial.at, i), item(m->new.at, i)));
    if (run->constraints.words.at[ACTIVE] != 1 || bits(inside) == 0)
        return 0;
    return hold_lanes(run, ends, m->new.at, bits(inside), 0);
}

/* Act on an event that has ended the step of a run. The code says how its integration ends, or that
   it goes on: EVENT. What is not as simple is left to Python. */
INLINE int64_t act_alone(const LaneRun *run, int64_t lane)
{
    const Run *own = alone_in(run, lane);
    const Watch *w = &own->watch;
    const int64_t number = w->words.at[EVENTS], n = own->problem.words.at[STATES];
    int64_t *logged = own->progress.counts.at + LOGGED, fired = 0, event = 0;
    const int full = *logged + 1 + number > w->log_times.size;
    for (int64_t k = 0; k < number; k++)
        if (w->fired.at[k] > 0)
            fired += 1, event = k;
    if (full)
        empty_log(run, lane);
    if (fired == 1 && w->kinds.at[event] & STOPS) {
        w->log_times.at[*logged] = own->progress.state.at[TIME], w->log_events.at[*logged] = event;
        for (int64_t i = 0; i < n; i++)
            w->log_states.at[*logged * n + i] = w->log_after.at[*logged * n + i] = own->memory.x.at[i];
        *logged += 1;
        return TERMINATED;
    }
    const int64_t told = w->words.at[ACT] == 0 ? LEFT : ((Act *)w->words.at[ACT])(own);
    if (full) /* as Python does, after which the log is empty */
        empty_log(run, lane);
    return told == ACTED ? EVENT : told == LEFT ? NOT_COMPUTED : told;
}

/* See to what has ended the steps of some lanes; return the bits of those that go on. */
APART int64_t act_in_lanes(const LaneRun *run, int64_t which, const int64_t *codes)
{
    const int64_t n = run->lane_problem.words.at[STATES];
    int64_t going_on = 0;
    FOR_LANES(which) {
        const Run *own = alone_in(run, lane);
        int64_t code = codes[lane];
        for (int64_t i = 0; i < n; i++)
            own->memory.x.at[i] = run->memory.x.at[i * W + lane];
        own->progress.state.at[TIME] = run->lanes.time.at[lane];
        if (code == LOG_FULL)
            empty_log(run, lane);
        if (code == EVENT)
            code = act_alone(run, lane);
        exchange(run, lane, 1);
        for (int64_t i = 0; i < n; i++)
            run->memory.x.at[i * W + lane] = own->memory.x.at[i];
        if (code == EVENT || code == LOG_FULL)
            going_on |= (int64_t)1 << lane;
        else
            retire(run, (int64_t)1 << lane, code);
    }
    return going_on;
}

/* -- steps ------------------------------------------------------------------------------------ */

/* Write the outputs due within the step of some lanes, in turns; return the bits of those whose
   constraints were missed there, with nothing written. An event within ends the step at a `theta`,
   with the outputs due there. */
APART int64_t write_within(const LaneRun *run, const Stepper *s, int64_t within, double *after,
    const double *theta)
{
    const Lanes *l = &run->lanes;
    const Real t = OF(time), size = item(s->memory->step.at, 0), next = OF(next), due = OF(due);
    double *trial = s->memory->trial.at;
    int64_t missed = 0, place[W];
    Real end = item(after, 0);
    Flags inside = flags(0);
    if (theta != 0) {
        inside = item(theta, 0) < 1.0;
        end = where(inside, t + item(theta, 0) * size, end);
        put(after, 0, end);
    }
    SERIAL
    for (int64_t lane = 0; lane < W; lane++)
        place[lane] = l->place.at[lane];
    for (int64_t left = within;;) {
        left &= bits((OF(due) < end) | (inside & (OF(due) == end))) & ~missed;
        if (left == 0)
            break;
        interpolate(s, (OF(due) - t) / size, trial);
        if (run->constraints.words.at[ACTIVE] == 1)
            missed |= hold_lanes(run, l->due.at, trial, left, 0);
        write_outputs(run, trial, left & ~missed);
    }
    FOR_LANES(missed) {
        l->next.at[lane] = next[lane], l->due.at[lane] = due[lane];
        l->place.at[lane] = place[lane];
    }
    return missed;
}

/* Step until the queue is empty, or BUDGET steps are taken. */
int64_t step_lanes(const LaneRun *run)
{
    const Stepper stepper = {&run->method, &run->lane_problem, &run->memory}, *s = &stepper;
    const Memory *m = &run->memory;
    const Lanes *l = &run->lanes;
    const Queue *q = &run->queue;
    const int64_t n = run->lane_problem.words.at[STATES];
    const double last = q->times.at[q->times.size - 2], largest = q->numbers.at[LANES_LARGEST];
    const double limit = (double)q->state.at[LANES_LIMIT];
    const int adaptive = is_adaptive(run), held = run->constraints.words.at[ACTIVE] == 1;
    const int watched = run->lane_watch.words.at[EVENTS] > 0;
    double reached[W], theta[W], jumps[W];
    int64_t working = 0, acted = 0, stopped = 0, codes[W];
    for (int64_t lane = 0; lane < W; lane++)
        working |= (int64_t)(l->samples.at[lane] >= 0) << lane;
    for (int vacant = 1;;) {
        while (vacant || acted != 0) {
            const int64_t fresh = vacant ? fill(run, &working) : 0;
            if (working == 0)
                return LANES_EMPTY;
            vacant = 0;
            if ((fresh | acted) == 0)
                break;
            start(run, s, fresh, acted);
            acted = 0;
            for (int64_t lane = 0; lane < W; lane++)
                vacant = vacant || l->samples.at[lane] == LANES_VACANT;
        }
        if (q->state.at[LANES_BUDGET] <= 0 || (watched && log_is_full(run)))
            return LANES_PAUSED;
        q->state.at[LANES_BUDGET] -= 1;

        const Flags active = flags(working);
        const Real t = OF(time);
        hold_all(run, jumps);
        /* whole steps between outputs */
        const Real goal = minimum(adaptive ? (Real)(last) : OF(due), item(jumps, 0));
        Real size = adaptive ? minimum(OF(size), (Real)(largest)) : whole_steps(t, OF(size), goal), after;
        limit_step(t, goal, &size, &after);
        size = where(active, size, (Real)(0.0));
        const Flags tired = OF(steps) + OF(rejected) >= limit;
        const int64_t over = bits((tired | ~moves(t, size, after, goal)) & active);
        if (over != 0) {
            retire(run, over & bits(tired), TOO_MANY_STEPS);
            retire(run, over & ~bits(tired), -1);
            vacant = 1;
            continue;
        }

        Trial trial = {t, size, after, goal, working, 0, 0};
        Attempt made = attempt(run, s, &trial);
        int64_t well = made.good;
        if (held && well != 0) {
            put(reached, 0, after);
            trial.missed = hold_lanes(run, reached, m->new.at, well, adaptive);
        }
        well = complete(run, s, &trial, well & ~trial.missed, &made);

        int64_t look = watched && well != 0 ? well & ~clear_lanes(run) : 0, unresolved = 0;
        int64_t within = (well & bits(OF(due) < after)) | look;
        if (within != 0) {
            const int64_t broken = open_step(run, s, &trial, within);
            if (broken != 0) {
                retire(run, broken, SINGULAR);
                working &= ~broken;
                vacant = 1;
                look &= ~broken;
            }
            put(reached, 0, after);
            if (look != 0)
                stopped = look_for_events(run, s, look, reached, jumps, codes, theta, &unresolved);
            within &= ~(broken | unresolved);
            int64_t off = write_within(run, s, within, reached, stopped == 0 ? 0 : theta);
            after = item(reached, 0);
            if (stopped != 0)
                off |= end_within(run, s, stopped & ~off, reached, theta);
            if (watched && off != 0) { /* events have been noted: no step is taken again */
                retire(run, off, CONSTRAINTS_NOT_MET);
                working &= ~off, stopped &= ~off;
                vacant = 1;
            }
            trial.missed |= off, trial.unresolved = unresolved, trial.after = after;
            well &= ~(broken | unresolved | off);
        }
        for (int64_t at_end = well & bits(OF(due) == after); at_end != 0;) {
            write_outputs(run, m->new.at, at_end);
            at_end &= bits(OF(due) == after);
        }

        Flags good = flags(well);
        ADD(steps, SOME(good, 1.0));
        ADD(rejected, SOME(active & ~good, 1.0));
        set_sizes(run, &trial, well, &made);
        put(l->time.at, 0, where(good, after, t));
        for (int64_t i = 0; i < n; i++)
            put(m->x.at, i, where(good, item(m->new.at, i), item(m->x.at, i)));
#ifndef IMPLICIT
        const double *slopes = m->stages.at + s->method->shape.at[STAGES] * m->x.size;
        for (int64_t i = 0; i < n; i++)
            put(m->stages.at, i, where(good, item(slopes, i), item(m->stages.at, i)));
#endif
        if (stopped != 0) {
            acted = act_in_lanes(run, stopped, codes);
            vacant = vacant || acted != stopped;
            good = good & ~flags(stopped);
            stopped = 0;
        }
#ifdef IMPLICIT
        const int64_t wrong = bits(good) == 0 ? 0 : start_again(run, s, bits(good));
        vacant = vacant || wrong != 0;
        good = good & ~flags(wrong);
#endif
        const int64_t finished = bits(good & (OF(due) == INF));
        if (finished != 0) {
            retire(run, finished, FINISHED);
            vacant = 1;
        }
#ifndef IMPLICIT
        const int64_t jumped = bits(good & (after == item(jumps, 0))) & ~finished;
        if (jumped != 0 && start_again(run, s, jumped) != 0)
            vacant = 1;
#endif
    }
}
