/* The adjoint of explicit Runge-Kutta steps, from the last to the first.

   With the stages k_i = f(X_i), X_i = x + h sum a_ij k_j and the step x + h sum b_i k_i, what depends
   on the state after a step through its adjoint l depends on that before it through l + sum u_i,
   where

       w_i = h (b_i l + sum a_ji u_j)        u_i = (df/dx)^T w_i

   from the last stage to the first, and on the parameters through sum (df/dp)^T w_i: the adjoint of
   the steps that were taken, not an integration of its own (E. Hairer, C. Lubich and G. Wanner,
   Geometric Numerical Integration, 2nd ed., 2006, VI.9; A. Walther, Computational Optimization and
   Applications 36 (2007) 83-108). */

#include "run.h"

/* Go back through all steps, each of which is taken again. Not zero: what a kernel complained. */
int64_t step_back(const Run *run, const WayBack *table)
{
    const Problem *p = &table->problem;
    const Backward *b = &table->backward;
    const Memory *m = &run->memory;
    const Stepper stepper = STEPPER(run), *s = &stepper;
    const int64_t n = p->words.at[STATES], blocks = p->words.at[BLOCKS], length = m->x.size;
    const int64_t stages = run->method.shape.at[STAGES], further = b->words.at[BACK_FURTHER];
    const int64_t kept = b->words.at[BACK_KEPT], *rows = b->rows.at, *offsets = b->offsets.at;
    const double *nodes = run->method.nodes.at, *coefficients = b->coefficients.at, *out = b->out.at;
    double *adjoints = b->adjoints.at, *weights = p->r.at + b->words.at[BACK_WEIGHTS];
    for (int64_t k = b->times.size - 1; k >= 0; k--) {
        const double t = b->times.at[k], h = b->sizes.at[k];
        for (int64_t i = 0; i < n; i++)
            m->x.at[i] = b->states.at[k * n + i];
        hold_inputs(&run->problem, t, 0);
        hold_inputs(p, t, 0);
        int64_t code = rates(&run->problem, t, m->x.at, m->stages.at);
        if (code == 0)
            code = take_step(s, t, h, &run->progress.counts.at[EVALUATIONS]);
        for (int64_t stage = stages - 1; stage >= 0 && code == 0; stage--) {
            combine_row(s, stage, blocks, m->trial.at, m->x.at, 1);
            const int64_t first = rows[stage], count = rows[stage + 1] - first;
            combine(m->new.at, m->zero.at, m->step.at, adjoints, offsets + first,
                coefficients + first, count, 0, blocks);
            for (int64_t i = 0; i < n; i++)
                weights[i] = m->new.at[i];
            code = rates(p, t + nodes[stage] * h, m->trial.at, b->out.at);
            for (int64_t i = 0; i < n; i++)
                adjoints[stage * length + i] = out[i];
            for (int64_t i = 0; i < further; i++)
                b->totals.at[i] += out[n + i];
            for (int64_t i = 0; i < kept; i++)
                b->kept.at[(k * stages + stage) * kept + i] = out[n + further - kept + i];
        }
        if (code != 0) {
            b->words.at[BACK_WRONG] = k;
            return code;
        }
        for (int64_t stage = 0; stage < stages; stage++)
            for (int64_t i = 0; i < n; i++)
                adjoints[stages * length + i] += adjoints[stage * length + i];
    }
    return 0;
}
