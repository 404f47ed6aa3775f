/* Samples begin on their constraints. */

#include "lanes.h"

/* Move the beginnings of all samples onto their constraints, each as `project` moves one; NaN where that
   does not converge. What is noted of them is that of these states. */
int64_t begin_lanes(const LaneRun *run)
{
    const Queue *q = &run->queue;
    const LaneProblem *p = &run->lane_problem;
    const int64_t n = q->x.columns, m = q->x.size;
    ProjectLanes *project = (ProjectLanes *)run->constraints.words.at[PROJECT];
    double *x = run->memory.x.at, *seen = seen_by(run), times[W];
    for (int64_t first = 0; first < m; first += W) {
        const int64_t here = m - first < W ? m - first : W;
        for (int64_t lane = 0; lane < W; lane++) {
            const int64_t sample = first + (lane < here ? lane : here - 1);
            times[lane] = q->times.at[0];
            copy_in(&q->x, sample, x, lane);
            copy_in(&q->r, sample, p->r.at, lane);
            copy_in(&q->p, sample, p->p.at, lane);
            copy_in(&q->seen, sample, seen, lane);
        }
        prepare(p);
        const int64_t missed = project(run, times, x, 0, ((int64_t)1 << here) - 1);
        for (int64_t lane = 0; lane < here; lane++) {
            copy_out(seen, lane, &q->seen, first + lane);
            copy_out(x, lane, &q->x, first + lane);
            for (int64_t i = 0; i < n && (missed >> lane & 1); i++)
                q->x.at[(first + lane) * n + i] = __builtin_nan("");
        }
    }
    return 0;
}
