/* The loop around explicit Runge-Kutta steps of W trajectories at once.

   Each lane has its own time, step size and outputs. A lane that has come to its end takes the next
   sample from the queue at once; when there are no more, it repeats a neighbour's state, step size
   zero. All arithmetic goes place by place, in an order that depends on nothing but the method: a
   sample gives the same bits in any lane, beside any neighbours. */

#include "lanes.h"

#include "step.h"

/* For each lane among some bits. */
#define FOR_LANES(which) \
    for (int64_t left_ = (which), lane; left_ != 0 && (lane = __builtin_ctzll(left_), 1); \
        left_ &= left_ - 1)

#define OF(field) item(l->field.at, 0)
#define SET(field, which, value) put(l->field.at, 0, where(which, (Real)(value), OF(field)))
#define ADD(field, value) put(l->field.at, 0, OF(field) + (value))
#define SOME(which, value) where(which, (Real)(value), (Real)(0.0))

/* -- constraints ------------------------------------------------------------------------------ */

typedef int64_t Project(const Run *run, double t, double *x, const double *from);

INLINE const Run *held_in(const LaneRun *run, int64_t lane)
{
    return (const Run *)run->holding.runs.at[lane];
}

INLINE double *seen_in(const LaneRun *run, int64_t lane)
{
    return held_in(run, lane)->constraints.values.at + run->holding.words.at[HOLDING_SEEN];
}

/* Give the constraints of a lane the inputs of a sample, and what was seen of them at its start. */
INLINE void take_constraints(const LaneRun *run, int64_t sample, int64_t lane)
{
    const Holding *g = &run->holding;
    const Run *own = held_in(run, lane);
    const Numbers *r = &run->queue.r, *p = &run->queue.p;
    SERIAL
    for (int64_t i = 0; i < r->columns; i++)
        own->problem.r.at[i] = r->at[sample * r->columns + i];
    ((Prepare *)g->words.at[HOLDING_PREPARE])(p->at + sample * p->columns, own->constraints.c.at);
    SERIAL
    for (int64_t i = 0; i < g->seen.columns; i++)
        seen_in(run, lane)[i] = g->seen.at[sample * g->seen.columns + i];
}

/* Move the states of some lanes onto their constraints; return the bits of those that missed. `ends`
   tells whether steps end there. */
APART int64_t hold_lanes(const LaneRun *run, const double *times, double *x, int64_t which, int ends)
{
    double *state = run->holding.state.at;
    const int64_t n = run->lane_problem.words.at[STATES];
    int64_t missed = 0;
    FOR_LANES(which) {
        const Run *own = held_in(run, lane);
        double *from = own->memory.x.at;
        SERIAL
        for (int64_t i = 0; i < n; i++)
            state[i] = x[i * W + lane], from[i] = run->memory.x.at[i * W + lane];
        if (((Project *)own->constraints.words.at[PROJECT])(own, times[lane], state, ends ? from : 0) != 0)
            missed |= (int64_t)1 << lane;
        SERIAL
        for (int64_t i = 0; i < n; i++)
            x[i * W + lane] = state[i];
    }
    return missed;
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
        SERIAL
        for (int64_t i = 0; i < run->holding.seen.columns; i++)
            run->holding.seen.at[sample * run->holding.seen.columns + i] = seen_in(run, lane)[i];
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
            if (run->holding.runs.size > 0)
                take_constraints(run, sample, lane);
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
            l->time.at[lane] = l->time.at[example], l->size.at[lane] = 0.0;
            l->due.at[lane] = INF, l->samples.at[lane] = LANES_RESTING;
        }
    prepare(p);
    return fresh;
}

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

/* Begin with the samples that lanes have just taken. */
APART void start(const LaneRun *run, const Stepper *s, int64_t fresh)
{
    const Lanes *l = &run->lanes;
    const Queue *q = &run->queue;
    const Memory *m = s->memory;
    const Flags new = flags(fresh);
    const Real t = OF(time);
    const int64_t failed = rates(s->equations, t, m->x.at, m->trial.at) & fresh;
    for (int64_t i = 0; i < s->equations->words.at[STATES]; i++)
        put(m->stages.at, i, where(new, item(m->trial.at, i), item(m->stages.at, i)));
    const double first = q->numbers.at[LANES_FIRST], largest = q->numbers.at[LANES_LARGEST];
    const Real size = first == 0.0 ? guess_first_size(s, t, largest) : (Real)(first);
    SET(size, new, size);
    SET(last_error, new, FIRST_ERROR);
    SET(growth, new, s->method->control.at[GROW]);
    SET(steps, new, 0.0);
    SET(rejected, new, 0.0);
    SET(evaluations, new, first == 0.0 ? 2.0 : 1.0);
    SET(reason, new, where(usable(size), (Real)(STEP_UNDERFLOW), (Real)(NOT_FINITE)));
    FOR_LANES(fresh) {
        const int64_t before = l->samples.at[lane] * (q->times.size - 1);
        l->next.at[lane] = 0.0, l->due.at[lane] = q->times.at[0];
        l->place.at[lane] = q->state.at[LANES_PLACE] + 8 * before;
    }
    for (int64_t well = fresh & ~failed; well != 0;) { /* the first time may be asked for twice */
        write_outputs(run, m->x.at, well);
        well &= bits(OF(due) == q->times.at[0]);
    }
    retire(run, failed, SINGULAR);
    retire(run, fresh & ~failed & bits(OF(due) == INF), FINISHED);
}

/* -- steps ------------------------------------------------------------------------------------ */

/* Write the outputs due within the step of some lanes, in turns; return the bits of those whose
   constraints were missed there, with nothing written. */
INLINE int64_t write_within(const LaneRun *run, const Stepper *s, int64_t within, Real after)
{
    const Lanes *l = &run->lanes;
    const Real t = OF(time), size = item(s->memory->step.at, 0), next = OF(next), due = OF(due);
    double *trial = s->memory->trial.at;
    int64_t missed = 0, place[W];
    SERIAL
    for (int64_t lane = 0; lane < W; lane++)
        place[lane] = l->place.at[lane];
    for (int64_t left = within; left != 0; left &= bits(OF(due) < after) & ~missed) {
        interpolate(s, (OF(due) - t) / size, trial);
        if (run->holding.runs.size > 0)
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
    const int64_t n = run->lane_problem.words.at[STATES], *shape = run->method.shape.at;
    const double last = q->times.at[q->times.size - 2], largest = q->numbers.at[LANES_LARGEST];
    const double limit = (double)q->state.at[LANES_LIMIT], *control = run->method.control.at;
    const int adaptive = shape[ESTIMATES] > 0, reuse = shape[END_IN_ESTIMATE] == 1;
    const int held = run->holding.runs.size > 0, again = held || !reuse;
    double *end = m->stages.at + shape[STAGES] * m->x.size, reached[W];
    int64_t working = 0, calls = 0;
    for (int64_t lane = 0; lane < W; lane++)
        working |= (int64_t)(l->samples.at[lane] >= 0) << lane;
    for (int vacant = 1;;) {
        while (vacant) {
            const int64_t fresh = fill(run, &working);
            if (working == 0)
                return LANES_EMPTY;
            if (fresh == 0)
                break;
            start(run, s, fresh);
            vacant = 0;
            for (int64_t lane = 0; lane < W; lane++)
                vacant = vacant || l->samples.at[lane] == LANES_VACANT;
        }
        if (q->state.at[LANES_BUDGET] <= 0)
            return LANES_PAUSED;
        q->state.at[LANES_BUDGET] -= 1;

        const Flags active = flags(working);
        const Real t = OF(time);
        const Real goal = adaptive ? (Real)(last) : OF(due); /* whole steps between outputs */
        Real h = OF(size), after;
        Real size = adaptive ? minimum(h, (Real)(largest)) : whole_steps(t, h, goal);
        limit_step(t, goal, &size, &after);
        size = where(active, size, (Real)(0.0));
        const Flags tired = OF(steps) + OF(rejected) >= limit;
        const int64_t stopped = bits((tired | ~moves(t, size, after, goal)) & active);
        if (stopped != 0) {
            retire(run, stopped & bits(tired), TOO_MANY_STEPS);
            retire(run, stopped & ~bits(tired), -1);
            vacant = 1;
            continue;
        }

        int64_t failed = take_step(s, t, size, &calls);
        if (reuse)
            failed |= rates(s->equations, after, m->new.at, end);
        Real error = (Real)(0.0);
        if (adaptive)
            error = error_of_step(s);
        else
            for (int64_t i = 0; i < n; i++)
                error = error + 0.0 * item(m->new.at, i); /* NaN where the state is not finite */
        Flags good = active & (error < 1.0) & ~flags(failed);
        int64_t missed = 0;
        if (held && bits(good) != 0) {
            put(reached, 0, after);
            missed = hold_lanes(run, reached, m->new.at, bits(good), adaptive);
            good = good & ~flags(missed);
        }
        const Flags tried = good;
        if (again && bits(good) != 0) {
            failed |= rates(s->equations, after, m->new.at, end);
            good = good & ~flags(failed);
        }
        ADD(evaluations, (double)(shape[STAGES] - 1 + reuse) + SOME(tried, again));

        Flags within = good & (OF(due) < after);
        if (bits(within) != 0) {
            const int64_t broken = prepare_interpolant(s, t, size, &calls) & bits(within);
            ADD(evaluations, SOME(within, shape[DENSE_STAGES]));
            if (broken != 0) {
                retire(run, broken, SINGULAR);
                working &= ~broken;
                vacant = 1;
                good = good & flags(working);
                within = within & good;
            }
            const int64_t off = write_within(run, s, bits(within), after);
            missed |= off;
            good = good & ~flags(off);
        }
        for (int64_t at_end = bits(good & (OF(due) == after)); at_end != 0;) {
            write_outputs(run, m->new.at, at_end);
            at_end &= bits(OF(due) == after);
        }

        const Flags bad = active & ~good;
        ADD(steps, SOME(good, 1.0));
        if (adaptive) {
            const Real before = OF(last_error);
            h = next_size(control, size, error, before, OF(growth));
            SET(last_error, good, maximum(error, (Real)(FIRST_ERROR)));
            put(l->growth.at, 0, where(bad, (Real)(1.0), (Real)(control[GROW])));
        }
        if (bits(bad) != 0) {
            const Flags singular = flags(failed), off = flags(missed);
            const Flags measured = (absolute(error) < INF) & ~singular & ~off;
            /* a step of fixed size that fails cannot be helped */
            const Real shorter =
                adaptive ? shorter_size(control, size, error, measured) : (Real)(0.0);
            const Real reason = where(measured, (Real)(STEP_UNDERFLOW), (Real)(NOT_FINITE));
            h = where(bad, shorter, h);
            SET(reason, bad, where(off, (Real)(CONSTRAINTS_NOT_MET), reason));
            SET(reason, bad, where(singular, (Real)(SINGULAR), reason));
            ADD(rejected, SOME(bad, 1.0));
        }
        put(l->size.at, 0, h);
        put(l->time.at, 0, where(good, after, t));
        for (int64_t i = 0; i < n; i++) {
            put(m->x.at, i, where(good, item(m->new.at, i), item(m->x.at, i)));
            put(m->stages.at, i, where(good, item(end, i), item(m->stages.at, i)));
        }
        const int64_t finished = bits(good & (OF(due) == INF));
        if (finished != 0) {
            retire(run, finished, FINISHED);
            vacant = 1;
        }
    }
}
