/* What an integration is made of, again and again: evaluations, and combinations of stages. */

#include "equations.h"
#include "sums.h"

typedef struct { Problem problem; Method method; Numbers x, start, out, step, stages; } Work;

/* Evaluate, each time at a state that depends on all of the last result. */
int64_t chain(const Work *w, int64_t count)
{
    const Problem *p = &w->problem;
    for (int64_t k = 0; k < count; k++) {
        call_kernel(p->words.at[KERNEL], p->clock.at, w->x.at, p->r.at, p->c.at, w->out.at);
        for (int64_t i = 0; i < p->words.at[STATES]; i++)
            w->x.at[i] = w->start.at[i] + 1e-12 * w->out.at[i];
    }
    return 0;
}

/* Compute all linear combinations of `count` steps. */
int64_t combinations(const Work *w, int64_t count)
{
    const Method *m = &w->method;
    for (int64_t k = 0; k < count; k++)
        for (int64_t row = 1; row < m->shape.at[STAGES] + 1 + m->shape.at[ESTIMATES]; row++) {
            const int64_t first = m->rows.at[row], terms = m->rows.at[row + 1] - first;
            combine(w->out.at, w->start.at, w->step.at, w->stages.at, m->offsets.at + first,
                m->weights.at + first, terms - 1, 1, w->problem.words.at[BLOCKS]);
        }
    return 0;
}
