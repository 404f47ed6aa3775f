/* Constraints held, with sensitivities: these are moved onto the linear constraints at the state. */

#include "projection.h"

/* Evaluate the derivatives of the residuals along the columns. Negative: Python raised something. */
APART int64_t move(const Run *run, const Tangents *tangents, const double *x)
{
    const Problem *p = &run->problem;
    return call_kernel(tangents->words.at[DIRECTIONS], p->clock.at, x, p->r.at, tangents->c.at,
        tangents->values.at);
}

/* Move a state onto the constraints, and its sensitivities onto the linear ones there.

   With c(x, p) = 0 the sensitivities S of motions that keep the constraints satisfy c_x S + c_p = 0.
   They are corrected by the least change in the norm that corrects the state. */
int64_t project_columns(const Run *run, double t, double *x, const double *from)
{
    const Tangents *tangents = (const Tangents *)run->constraints.words.at[TANGENTS];
    const int64_t code = ((Project *)tangents->words.at[OF_STATE])(run, t, x, from);
    if (code != 0)
        return code;
    const Held held = held_by(run, 1), *s = &held;
    const int64_t width = tangents->words.at[COUNT];
    const double *residuals = tangents->values.at;
    double *columns = x + run->problem.words.at[STATES] / (1 + width);
    /* what the projection of the state left there is of its last iteration */
    set_identity(s->scratch->factor.at, s->u, 1);
    set_factor(s);
    if (s->h > 0) {
        if (move(run, tangents, x) < 0)
            return CONSTRAINTS_NOT_MET;
        copy_table(s->kinematics, &s->scratch->kinematics);
        for (int64_t column = 0; column < width; column++) {
            copy_negative(residuals + column, s->h, width, s->scratch->right.at);
            move_positions(s, columns + column, width);
        }
    }
    if (s->v > 0) {
        if (move(run, tangents, x) < 0)
            return CONSTRAINTS_NOT_MET;
        for (int64_t column = 0; column < width; column++) {
            copy_negative(residuals + s->h * width + column, s->v, width, s->scratch->right.at);
            move_speeds(s, columns + column, width);
        }
    }
    return 0;
}
