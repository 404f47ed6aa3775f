/* Constraints held: the state is moved back onto them, by the least motion. */

#include "projection.h"

enum { ITERATIONS = 10 };

/* Note where the rows were nearest to losing rank, or first came very near to it. Rows are measured
   by the longest they have been: one that vanishes has lost its part too. */
INLINE void watch_rank(const Held *s, double t, const double *x, int64_t n)
{
    const double *lengths = s->scratch->lengths.at, *kept = s->scratch->kept.at;
    double *seen = s->seen, *longest = seen + WHERE + n, nearness = 1.0;
    int64_t rank = 0;
    for (int64_t i = 0; i < s->v; i++) {
        longest[i] = maximum(lengths[i], longest[i]);
        if (kept[i] > 0.0) {
            rank += 1;
            nearness = minimum(kept[i] / longest[i], nearness);
        }
    }
    if ((double)rank > seen[RANK])
        seen[RANK] = (double)rank, seen[NEARNESS] = 1.0;
    else if ((double)rank < seen[RANK])
        nearness = 0.0;
    if (nearness < seen[NEARNESS] && seen[NEARNESS] > NEARLY_SINGULAR) {
        seen[NEARNESS] = nearness, seen[WHEN] = t;
        for (int64_t i = 0; i < n; i++)
            seen[WHERE + i] = x[i];
    }
}

/* Move positions until their residuals are rounding: that of their terms, or that of the first
   correction, beside which the terms are nothing where coordinates are held at zero. Of rows that
   are more than their rank, those that were redundant in the last correction are not looked at:
   lengths of six digits let them hold to as many. */
INLINE int64_t hold_positions(const Run *run, const Held *s, double *x)
{
    const Problem *p = &run->problem;
    double before = INF, *mended = s->scratch->mended.at;
    for (int64_t i = 0; i < s->h; i++)
        mended[i] = 0.0;
    for (int iteration = 0;; iteration++) {
        if (call_kernel(run->constraints.words.at[PROJECTOR], p->clock.at, x, p->r.at,
                run->constraints.c.at, s->values) < 0)
            return CONSTRAINTS_NOT_MET;
        double worst = 0.0; /* in units of what rounding may make of residuals */
        for (int64_t i = 0; i < s->h; i++) {
            const int all = iteration == 0 || s->positions == s->h;
            const double size = absolute(s->values[i]);
            if (size != 0.0 && (all || s->scratch->kept.at[i] > 0.0))
                worst = maximum(size / (ROUNDING * maximum(s->rounding[i], mended[i])), worst);
            if (!is_finite(size))
                return CONSTRAINTS_NOT_MET;
        }
        if (worst <= 1.0 || (worst >= 0.5 * before && worst <= ROUNDINGS))
            return 0;
        if (iteration == ITERATIONS - 1)
            return CONSTRAINTS_NOT_MET;
        before = worst;
        set_factor(s);
        copy_table(s->kinematics, &s->scratch->kinematics);
        copy_negative(s->values, s->h, 1, s->scratch->right.at);
        move_positions(s, x, 1);
    }
}

/* Move a state onto the constraints; 0, or CONSTRAINTS_NOT_MET. */
int64_t project(const Run *run, double t, double *x)
{
    const Held held = held_by(run), *s = &held;
    set_inputs(&run->problem, t);
    run->progress.counts.at[PROJECTIONS] += 1;
    set_identity(s->scratch->factor.at, s->u);
    const int64_t code = hold_positions(run, s, x);
    if (code != 0 || s->v == 0)
        return code;
    double finite = 0.0;
    for (int64_t i = 0; i < s->v; i++)
        finite += 0.0 * s->values[s->h + i];
    for (int64_t i = 0; i < s->v * s->u; i++)
        finite += 0.0 * s->velocity[i];
    if (finite != 0.0) /* NaN */
        return CONSTRAINTS_NOT_MET;
    set_factor(s);
    copy_negative(s->values + s->h, s->v, 1, s->scratch->right.at);
    move_speeds(s, x, 1);
    watch_rank(s, t, x, run->problem.words.at[STATES]);
    return 0;
}
