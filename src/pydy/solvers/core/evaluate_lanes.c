/* Kernels of W lanes, evaluated along trajectories. */

#include "lanes.h"

/* Evaluate a kernel at all states (n, m, times); write (outputs, m, times). NaN states give NaN; so
   does a linear solve that fails. */
int64_t evaluate_lanes(const LaneEvaluation *table)
{
    const LaneProblem *p = &table->lane_problem;
    const Evaluation *e = &table->evaluation;
    const int64_t n = p->words.at[STATES], m = e->r.size, count = e->times.size;
    const int64_t outputs = e->buffer.size / W, *places = e->places.at;
    const double *buffer = e->buffer.at, *origin = (const double *)places[LANES_ORIGIN];
    for (int64_t first = 0; first < m; first += W) {
        const int64_t here = m - first < W ? m - first : W;
        for (int64_t lane = 0; lane < W; lane++) {
            const int64_t sample = first + (lane < here ? lane : here - 1);
            copy_in(&e->r, sample, p->r.at, lane);
            copy_in(&e->p, sample, p->p.at, lane);
        }
        prepare(p);
        for (int64_t k = 0; k < count; k++) {
            for (int64_t lane = 0; lane < W; lane++) {
                const int64_t sample = first + (lane < here ? lane : here - 1);
                const double *x =
                    origin + sample * places[LANES_PER_SAMPLE] + k * places[LANES_PER_TIME];
                SERIAL
                for (int64_t i = 0; i < n; i++)
                    e->x.at[i * W + lane] = x[i * places[LANES_PER_STATE]];
            }
            const int64_t failed = rates(p, (Real)(e->times.at[k]), e->x.at, e->buffer.at);
            for (int64_t lane = 0; lane < here; lane++) {
                const int bad = (failed >> lane & 1) || (n > 0 && e->x.at[lane] != e->x.at[lane]);
                SERIAL
                for (int64_t j = 0; j < outputs; j++)
                    e->out.at[(j * m + first + lane) * count + k] =
                        bad ? __builtin_nan("") : buffer[j * W + lane];
            }
        }
    }
    return 0;
}
