/* The continuous extension of a run: its steps were kept, and are taken again where wanted. */

#include "run.h"

/* Compute the interpolant of a step that was kept, with the same bits as before. */
INLINE int64_t take_again(const Run *run, const Stepper *s, const double *row, const double *end)
{
    const Memory *m = &run->memory;
    const int64_t n = run->problem.words.at[STATES], length = m->x.size;
    const int64_t stages = run->method.shape.at[STAGES];
    const double t = row[0], h = row[1];
    int64_t *evaluations = &run->progress.counts.at[EVALUATIONS];
    for (int64_t i = 0; i < n; i++)
        m->x.at[i] = row[2 + i];
    if (stages == 0) {
        for (int64_t j = 0; j < run->method.shape.at[DEPTH]; j++)
            for (int64_t i = 0; i < n; i++)
                m->interpolant.at[j * length + i] = row[2 + (1 + j) * n + i];
        return 0;
    }
    hold_inputs(&run->problem, t, 0);
    int64_t code = rates(&run->problem, t, m->x.at, m->stages.at);
    if (code == 0)
        code = take_step(s, t, h, evaluations);
    if (code != 0)
        return code;
    for (int64_t i = 0; i < n; i++)
        m->new.at[i] = end[2 + i]; /* after the projection */
    code = rates(&run->problem, end[0], m->new.at, m->stages.at + stages * length);
    if (code != 0)
        return code;
    return prepare_interpolant(s, t, h, evaluations);
}

/* Write the states at some ascending times. Not zero: what the right-hand side complained. */
int64_t extend(const Run *run, const Wanted *wanted)
{
    const Stepper stepper = STEPPER(run), *s = &stepper;
    const int64_t n = run->problem.words.at[STATES], width = wanted->rows.columns;
    int64_t current = -1;
    for (int64_t k = 0; k < wanted->times.size; k++) {
        const int64_t place = wanted->places.at[k];
        const double *row = wanted->rows.at + place * width, t = wanted->times.at[k];
        double *out = wanted->out.at + k * n;
        if (row[1] == 0.0) {
            for (int64_t i = 0; i < n; i++)
                out[i] = row[2 + i];
            continue;
        }
        if (place != current) {
            current = place;
            const int64_t code = take_again(run, s, row, row + width);
            if (code != 0)
                return code;
        }
        const double theta = (t - row[0]) / row[1];
        interpolate(s, theta, out);
        if (run->constraints.words.at[ACTIVE] == 1 && theta > 0.0)
            hold(run, t, out, 0);
    }
    return 0;
}
