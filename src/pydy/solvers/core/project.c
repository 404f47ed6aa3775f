/* Constraints held: the state is moved back onto them, by the least motion. */

#include "projection.h"

enum { ITERATIONS = 10 };

/* Note where the rows were nearest to losing rank, or first came very near to it. Rows are measured
   by the longest they have been: one that vanishes has lost its part too. Nothing is noted where a step
   is `off`: errors are larger by the inverse of nearness, and by NEAR_SINGULAR at most before the
   energy tells of them. */
INLINE int64_t watch_rank(const Held *s, double t, const double *x, int64_t n, double off)
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
    const double near = minimum(nearness, seen[LATEST]);
    seen[LATEST] = nearness;
    if (off > 1.0 && (near >= NEAR_SINGULAR || off * near * NEAR_SINGULAR > 1.0))
        return CONSTRAINTS_NOT_MET;
    if (nearness < seen[NEARNESS] && seen[NEARNESS] > NEARLY_SINGULAR) {
        seen[NEARNESS] = nearness, seen[WHEN] = t;
        for (int64_t i = 0; i < n; i++)
            seen[WHERE + i] = x[i];
    }
    return 0;
}

/* Return the largest residual in units of what errors of a step explain, which began `from` a state.

   Errors of the norm 1 in the states make |row e| <= root(n) |row unit| of a residual. A step that was
   accepted is not off by much more, unless its stages did not see how the constraints move: where
   these jump, or a pulse of their rates passed between them. */
INLINE double in_errors(const Run *run, const Held *s, int motions, const double *x, const double *from)
{
    const int64_t number = motions ? s->v : s->h, width = motions ? s->u : s->q, first = motions ? s->q : 0;
    const double *residuals = motions ? s->values + s->h : s->values;
    const double *rows = motions ? s->velocity : s->gradient;
    const int redundant = (motions ? s->motions : s->positions) < number;
    double most = 0.0;
    for (int64_t i = 0; i < number; i++, rows += width) {
        double errors = 0.0, size = 0.0;
        for (int64_t k = 0; k < width; k++) {
            const double e = rows[k] * unit(&run->memory, first + k, from[first + k], x[first + k]);
            errors += e * e, size += absolute(rows[k] * x[first + k]);
        }
        size = (redundant ? DIGITS : ROUNDINGS * ROUNDING) * (motions ? size : s->rounding[i]);
        const double allowed = EXCESS * root((double)(s->q + s->u) * errors) + size;
        if (errors > 0.0) /* else nothing moves it */
            most = maximum(absolute(residuals[i]) / allowed, most);
    }
    return most;
}

/* Move positions until their residuals are rounding: that of their terms, or that of the first
   correction, beside which the terms are nothing where coordinates are held at zero. Of rows that
   are more than their rank, those that were redundant in the last correction are not looked at:
   lengths of six digits let them hold to as many. */
INLINE int64_t hold_positions(const Run *run, const Held *s, double *x, const double *from, double *off)
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
        if (iteration == 0 && from)
            *off = in_errors(run, s, 0, x, from);
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

/* Move a state onto the constraints; 0, or CONSTRAINTS_NOT_MET. If it ends a step, which began `from`
   another, it is not moved further than errors of the step explain, but where the rows nearly lose
   rank: there they are larger, and the energy tells of them. */
int64_t project(const Run *run, double t, double *x, const double *from)
{
    const Held held = held_by(run), *s = &held;
    if (!run->constraints.words.at[JUDGED])
        from = 0;
    set_inputs(&run->problem, t);
    run->progress.counts.at[PROJECTIONS] += 1;
    set_identity(s->scratch->factor.at, s->u);
    double off = 0.0;
    const int64_t code = hold_positions(run, s, x, from, &off);
    if (code != 0 || s->v == 0)
        return off > 1.0 ? CONSTRAINTS_NOT_MET : code;
    double finite = 0.0;
    for (int64_t i = 0; i < s->v; i++)
        finite += 0.0 * s->values[s->h + i];
    for (int64_t i = 0; i < s->v * s->u; i++)
        finite += 0.0 * s->velocity[i];
    if (finite != 0.0) /* NaN */
        return CONSTRAINTS_NOT_MET;
    if (from)
        off = maximum(in_errors(run, s, 1, x, from), off);
    set_factor(s);
    copy_negative(s->values + s->h, s->v, 1, s->scratch->right.at);
    move_speeds(s, x, 1);
    return watch_rank(s, t, x, run->problem.words.at[STATES], off);
}
