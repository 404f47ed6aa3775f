/* The adjoint of explicit Runge-Kutta steps, from the last to the first.

   With the stages k_i = f(X_i), X_i = x + h sum a_ij k_j and the step x + h sum b_i k_i, what depends
   on the state after a step through its adjoint l depends on that before it through l + sum u_i,
   where

       w_i = h (b_i l + sum a_ji u_j)        u_i = (df/dx)^T w_i

   from the last stage to the first, and on the parameters through sum (df/dp)^T w_i: the adjoint of
   the steps that were taken, not an integration of its own (E. Hairer, C. Lubich and G. Wanner,
   Geometric Numerical Integration, 2nd ed., 2006, VI.9; A. Walther, Computational Optimization and
   Applications 36 (2007) 83-108). */

#include "equations.h"
#include "sums.h"

/* Go back through all steps. Not zero: what the kernel complained. */
int64_t step_back(const WayBack *table)
{
    const Problem *p = &table->problem;
    const Backward *b = &table->backward;
    const int64_t n = p->words.at[STATES], blocks = p->words.at[BLOCKS], length = b->state.size;
    const int64_t stages = b->words.at[BACK_STAGES], further = b->words.at[BACK_FURTHER];
    const int64_t kept = b->words.at[BACK_KEPT], *rows = b->rows.at, *offsets = b->offsets.at;
    const double *coefficients = b->coefficients.at, *out = b->out.at;
    double *adjoints = b->adjoints.at, *weights = p->r.at + b->words.at[BACK_WEIGHTS];
    for (int64_t k = b->times.size - 1; k >= 0; k--) {
        const double t = b->times.at[k], h = b->sizes.at[k];
        store_block(b->step.at, (Block)(h));
        for (int64_t stage = stages - 1; stage >= 0; stage--) {
            int64_t first = rows[stage], count = rows[stage + 1] - first;
            combine(b->state.at, b->states.at + k * length, b->step.at,
                b->stages.at + k * stages * length, offsets + first, coefficients + first,
                count > 0 ? count - 1 : 0, count > 0, blocks);
            first = rows[stages + stage], count = rows[stages + stage + 1] - first;
            combine(b->weighted.at, b->zero.at, b->step.at, adjoints, offsets + first,
                coefficients + first, count, 0, blocks);
            for (int64_t i = 0; i < n; i++)
                weights[i] = b->weighted.at[i];
            const int64_t code = rates(p, t + b->nodes.at[stage] * h, b->state.at, b->out.at);
            if (code != 0) {
                b->words.at[BACK_WRONG] = k;
                return code;
            }
            for (int64_t i = 0; i < n; i++)
                adjoints[stage * length + i] = out[i];
            for (int64_t i = 0; i < further; i++)
                b->totals.at[i] += out[n + i];
            for (int64_t i = 0; i < kept; i++)
                b->kept.at[(k * stages + stage) * kept + i] = out[n + further - kept + i];
        }
        for (int64_t stage = 0; stage < stages; stage++)
            for (int64_t i = 0; i < n; i++)
                adjoints[stages * length + i] += adjoints[stage * length + i];
    }
    return 0;
}
