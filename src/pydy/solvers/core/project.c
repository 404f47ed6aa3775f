/* Constraints held: the state is moved back onto them, by the least motion. */

#include "projection.h"

enum { ITERATIONS = 10 };

/* Note where the rows were nearest to losing rank, or first came very near to it. Rows are measured
   by the longest they have been: one that vanishes has lost its part too. Nothing is noted where a step
   is `off`: errors are larger by the inverse of nearness, and by NEAR_SINGULAR at most before the
   energy tells of them. */
INLINE int64_t watch_rank(const Held *s, Real t, const double *x, int64_t n, Real off)
{
    double *seen = s->seen;
    const Flags some = flags(s->which);
    Real nearness = (Real)(1.0), rank = (Real)(0.0);
    for (int64_t i = 0; i < s->v; i++) {
        const Real kept = item(s->scratch->kept.at, i), before = item(seen, WHERE + n + i);
        const Real longest = maximum(item(s->scratch->lengths.at, i), before);
        put(seen, WHERE + n + i, where(some, longest, before));
        rank = where(kept > 0.0, rank + 1.0, rank);
        nearness = where(kept > 0.0, minimum(kept / longest, nearness), nearness);
    }
    const Real highest = item(seen, RANK), latest = item(seen, LATEST);
    const Flags higher = some & (rank > highest);
    put(seen, RANK, where(higher, rank, highest));
    Real nearest = where(higher, (Real)(1.0), item(seen, NEARNESS));
    nearness = where(rank < highest, (Real)(0.0), nearness);
    const Real near = minimum(nearness, latest);
    put(seen, LATEST, where(some, nearness, latest));
    const Flags close = (near >= NEAR_SINGULAR) | (off * near * NEAR_SINGULAR > 1.0);
    const int64_t missed = s->which & bits((off > 1.0) & close);
    const Flags worse = flags(s->which & ~missed) & (nearness < nearest) & (nearest > NEARLY_SINGULAR);
    put(seen, NEARNESS, where(worse, nearness, nearest));
    if (bits(worse) != 0) {
        put(seen, WHEN, where(worse, t, item(seen, WHEN)));
        for (int64_t i = 0; i < n; i++)
            put(seen, WHERE + i, where(worse, item(x, i), item(seen, WHERE + i)));
    }
    return missed;
}

/* Return the largest residual in units of what errors of a step explain, which began `from` a state.

   Errors of the norm 1 in the states make |row e| <= root(n) |row unit| of a residual. A step that was
   accepted is not off by much more, unless its stages did not see how the constraints move: where
   these jump, or a pulse of their rates passed between them. */
INLINE Real in_errors(const Holder *run, const Held *s, int motions, const double *x, const double *from)
{
    const int64_t number = motions ? s->v : s->h, width = motions ? s->u : s->q, first = motions ? s->q : 0;
    const double *residuals = motions ? s->values + W * s->h : s->values;
    const double *rows = motions ? s->velocity : s->gradient;
    const int redundant = (motions ? s->motions : s->positions) < number;
    Real most = (Real)(0.0);
    for (int64_t i = 0; i < number; i++) {
        Real errors = (Real)(0.0), size = errors;
        for (int64_t k = 0; k < width; k++) {
            const Real row = item(rows, i * width + k), after = item(x, first + k);
            const Real e = row * unit(&run->memory, first + k, item(from, first + k), after);
            errors = errors + e * e, size = size + absolute(row * after);
        }
        size = (redundant ? DIGITS : ROUNDINGS * ROUNDING) * (motions ? size : item(s->rounding, i));
        const Real allowed = EXCESS * root((double)(s->q + s->u) * errors) + size;
        /* where there are no errors nothing moves it */
        most = where(errors > 0.0, maximum(absolute(item(residuals, i)) / allowed, most), most);
    }
    return most;
}

/* Move positions until their residuals are rounding: that of their terms, or that of the first
   correction, beside which the terms are nothing where coordinates are held at zero. Of rows that
   are more than their rank, those that were redundant in the last correction are not looked at:
   lengths of six digits let them hold to as many. */
INLINE int64_t hold_positions(const Holder *run, Held *s, double *x, const double *from, Real *off)
{
    const Equations *e = EQUATIONS(run);
    const int64_t wanted = s->which;
    int64_t missed = 0;
    Real before = (Real)(INF);
    double *mended = s->scratch->mended.at;
    for (int64_t i = 0; i < s->h; i++)
        put(mended, i, (Real)(0.0));
    for (int iteration = 0;; iteration++) {
        if (call_kernel(run->constraints.words.at[PROJECTOR], e->clock.at, x, e->r.at,
                run->constraints.c.at, s->values) < 0)
            return wanted;
        const int all = iteration == 0 || s->positions == s->h;
        Real worst = (Real)(0.0); /* in units of what rounding may make of residuals */
        Flags finite = flags(EVERY);
        for (int64_t i = 0; i < s->h; i++) {
            const Real size = absolute(item(s->values, i));
            const Real rounded = ROUNDING * maximum(item(s->rounding, i), item(mended, i));
            Flags counts = size != 0.0;
            if (!all)
                counts = counts & (item(s->scratch->kept.at, i) > 0.0);
            worst = where(counts, maximum(size / rounded, worst), worst);
            finite = finite & (size < INF);
        }
        missed |= s->which & ~bits(finite);
        if (iteration == 0 && from)
            *off = in_errors(run, s, 0, x, from);
        s->which &= ~missed & ~bits((worst <= 1.0) | ((worst >= 0.5 * before) & (worst <= ROUNDINGS)));
        if (iteration == ITERATIONS - 1)
            missed |= s->which, s->which = 0;
        if (s->which == 0)
            return missed;
        before = worst;
        set_factor(s);
        copy_table(s->kinematics, &s->scratch->kinematics);
        copy_negative(s->values, s->h, 1, s->scratch->right.at);
        move_positions(s, x, 1);
    }
}

/* Move states onto the constraints; return the bits of those that missed them. If they end steps, which
   began `from` others, they are not moved further than errors of the step explain, but where the rows
   nearly lose rank: there they are larger, and the energy tells of them. */
INLINE int64_t projected(const Holder *run, Real t, double *x, const double *from, int64_t which)
{
    Held held = held_by(run, which), *s = &held;
    if (!run->constraints.words.at[JUDGED])
        from = 0;
    set_inputs(EQUATIONS(run), t);
    set_identity(s->scratch->factor.at, s->u, EVERY);
    Real off = (Real)(0.0), finite = off;
    int64_t missed = hold_positions(run, s, x, from, &off);
    if (s->v == 0 || missed == which)
        return missed | (which & bits(off > 1.0));
    for (int64_t i = 0; i < s->v; i++)
        finite = finite + 0.0 * item(s->values, s->h + i);
    for (int64_t i = 0; i < s->v * s->u; i++)
        finite = finite + 0.0 * item(s->velocity, i);
    missed |= which & ~bits(finite == 0.0); /* NaN */
    s->which = which & ~missed;
    if (from)
        off = maximum(in_errors(run, s, 1, x, from), off);
    set_factor(s);
    copy_negative(s->values + W * s->h, s->v, 1, s->scratch->right.at);
    move_speeds(s, x, 1);
    return missed | watch_rank(s, t, x, EQUATIONS(run)->words.at[STATES], off);
}

#if W > 1
int64_t project_lanes(const LaneRun *run, const double *t, double *x, const double *from, int64_t which)
{
    return projected(run, item(t, 0), x, from, which);
}
#else
/* The same for one state: 0, or CONSTRAINTS_NOT_MET. */
int64_t project(const Run *run, double t, double *x, const double *from)
{
    run->progress.counts.at[PROJECTIONS] += 1;
    return projected(run, t, x, from, 1) == 0 ? 0 : CONSTRAINTS_NOT_MET;
}
#endif
