/* What the projections of a state and of its sensitivities share.

   Positions are corrected by Newton's method along the kinematics, dq = N du, where du is the least
   in the norm of the unreduced mass matrix; velocities by one linear solve in the same norm. What no
   du can mend, such as the norm of a quaternion, is mended by the least dq.

   E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd edition, section IV.4. */

#ifndef PROJECTION_H
#define PROJECTION_H

#include "run.h"

/* Constraints by their sizes, and where the parts of their kernel's values begin: residuals come
   first. */
typedef struct {
    const Projection *scratch;
    int64_t h, v, q, u, weighted, positions, motions; /* the last two: ranks of h, v rows */
    double *values, *gradient, *kinematics, *velocity, *mass, *rounding, *seen;
} Held;

INLINE Held held_by(const Run *run)
{
    const int64_t *w = run->constraints.words.at;
    Held s = {.scratch = (const Projection *)w[SCRATCH], .h = w[HOLONOMIC], .v = w[VELOCITY],
        .q = w[COORDINATES], .u = w[SPEEDS], .weighted = w[WEIGHTED],
        .positions = w[POSITIONS], .motions = w[MOTIONS],
        .values = run->constraints.values.at};
    s.gradient = s.values + s.h + s.v;
    s.kinematics = s.gradient + s.h * s.q;
    s.velocity = s.kinematics + s.q * s.u;
    s.mass = s.velocity + s.v * s.u;
    s.rounding = s.mass + s.weighted * s.u * s.u;
    s.seen = s.rounding + s.h;
    return s;
}

/* -- linear algebra --------------------------------------------------------------------------- */

INLINE double product(const double *a, const double *b, int64_t n)
{
    double total = 0.0;
    for (int64_t k = 0; k < n; k++)
        total += a[k] * b[k];
    return total;
}

INLINE void set_identity(double *a, int64_t n)
{
    for (int64_t i = 0; i < n; i++)
        for (int64_t k = 0; k < n; k++)
            a[i * n + k] = i == k ? 1.0 : 0.0;
}

/* Replace a symmetric matrix by its Cholesky factor; by the identity where it has none. */
APART void factorise(double *a, int64_t n)
{
    for (int64_t j = 0; j < n; j++) {
        double pivot = a[j * n + j];
        for (int64_t k = 0; k < j; k++)
            pivot -= a[j * n + k] * a[j * n + k];
        if (!(pivot > 4.0 * (double)n * ROUNDING * a[j * n + j])) {
            set_identity(a, n);
            return;
        }
        a[j * n + j] = root(pivot);
        for (int64_t i = j + 1; i < n; i++) {
            double value = a[i * n + j];
            for (int64_t k = 0; k < j; k++)
                value -= a[i * n + k] * a[j * n + k];
            a[i * n + j] = value / a[j * n + j];
        }
    }
}

/* Replace each of m rows a by a L^-T. */
APART void divide_rows(double *rows, int64_t m, const double *factor, int64_t n)
{
    for (int64_t row = 0; row < m; row++)
        for (int64_t i = 0; i < n; i++) {
            double value = rows[row * n + i];
            for (int64_t k = 0; k < i; k++)
                value -= factor[i * n + k] * rows[row * n + k];
            rows[row * n + i] = value / factor[i * n + i];
        }
}

/* Replace y by L^-T y. */
APART void divide_transposed(const double *factor, int64_t n, double *y)
{
    for (int64_t i = n - 1; i >= 0; i--) {
        double value = y[i];
        for (int64_t k = i + 1; k < n; k++)
            value -= factor[k * n + i] * y[k];
        y[i] = value / factor[i * n + i];
    }
}

/* Compute `step`, the least y with rows y = right; `right` keeps what no y can reach.

   Rows are scaled to unit length and orthogonalised, the longest first, and overwritten. `lengths`
   are those of the rows as they came, and `kept` what orthogonalisation left of them: 0 for
   redundant ones. No more than `rank` are taken, of which there are more where some were left out
   of the equations as redundant. Those come last, and take the place of others that are nearly
   dependent: beside all that hold, one that follows from them does so to the state's error only. */
APART void minimum_norm(const Numbers *matrix, const Projection *p, int64_t rank)
{
    const int64_t m = matrix->size, n = matrix->columns;
    double *rows = matrix->at, *y = p->step.at, *right = p->right.at, *scale = p->scale.at;
    double *lengths = p->lengths.at, *kept = p->kept.at;
    int64_t *left = p->left.at;
    for (int64_t k = 0; k < n; k++)
        y[k] = 0.0;
    for (int64_t i = 0; i < m; i++) {
        double *row = rows + i * n;
        const double norm = product(row, row, n);
        scale[i] = 1.0, left[i] = 1, lengths[i] = 0.0, kept[i] = 0.0;
        if (norm > 0.0) {
            lengths[i] = root(norm);
            scale[i] = 1.0 / lengths[i];
            right[i] *= scale[i];
            for (int64_t k = 0; k < n; k++)
                row[k] *= scale[i];
        }
    }
    int64_t turn = 0;
    for (; turn < rank; turn++) {
        int64_t pivot = -1;
        double longest = DEPENDENT * DEPENDENT;
        for (int64_t i = 0; i < m; i++) {
            if (i == rank && longest > SOUND * SOUND)
                break;
            if (left[i] == 1) {
                const double norm = product(rows + i * n, rows + i * n, n);
                if (norm > longest)
                    pivot = i, longest = norm;
            }
        }
        if (pivot < 0)
            break;
        const double length = root(longest), z = right[pivot] / length;
        double *best = rows + pivot * n;
        left[pivot] = 0, right[pivot] = 0.0;
        kept[pivot] = length * lengths[pivot];
        for (int64_t k = 0; k < n; k++) {
            best[k] /= length;
            y[k] += z * best[k];
        }
        for (int64_t i = 0; i < m; i++)
            if (left[i] == 1) {
                const double along = product(rows + i * n, best, n);
                right[i] -= along * z;
                for (int64_t k = 0; k < n; k++)
                    rows[i * n + k] -= along * best[k];
            }
    }
    for (int64_t i = 0; i < m; i++)
        right[i] = turn == rank && rank < m ? 0.0 : right[i] / scale[i];
}

/* -- corrections ------------------------------------------------------------------------------ */

INLINE void copy_table(const double *from, const Numbers *table)
{
    for (int64_t i = 0; i < table->size * table->columns; i++)
        table->at[i] = from[i];
}

/* Copy m numbers that lie `width` apart. */
INLINE void copy_negative(const double *from, int64_t m, int64_t width, double *to)
{
    for (int64_t i = 0; i < m; i++)
        to[i] = -from[i * width];
}

/* Compute the rows of (dh/dq) N. */
APART void set_rows(const Numbers *kinematics, const double *gradient, const Numbers *rows)
{
    const int64_t q = kinematics->size, u = kinematics->columns;
    for (int64_t i = 0; i < rows->size; i++)
        for (int64_t k = 0; k < u; k++) {
            double total = 0.0, size = 0.0;
            for (int64_t j = 0; j < q; j++) {
                const double term = gradient[i * q + j] * kinematics->at[j * u + k];
                total += term;
                size += absolute(term);
            }
            /* nothing but rounding, as in the norm of a quaternion */
            const int rounding = absolute(total) <= 4.0 * (double)q * ROUNDING * size;
            rows->at[i * u + k] = rounding ? 0.0 : total;
        }
}

/* Set the norm of corrections. */
INLINE void set_factor(const Held *s)
{
    if (s->weighted == 1) {
        copy_table(s->mass, &s->scratch->factor);
        factorise(s->scratch->factor.at, s->u);
    }
}

/* Move positions, which lie `width` numbers apart, by what scratch.right asks for. */
APART void move_positions(const Held *s, double *x, int64_t width)
{
    const Projection *p = s->scratch;
    copy_table(s->gradient, &p->gradient);
    set_rows(&p->kinematics, p->gradient.at, &p->holonomic);
    divide_rows(p->holonomic.at, s->h, p->factor.at, s->u);
    minimum_norm(&p->holonomic, p, s->positions);
    const double norm = root(product(p->step.at, p->step.at, s->u));
    for (int64_t i = 0; i < s->h; i++)
        if (p->mended.at[i] == 0.0)
            p->mended.at[i] = p->lengths.at[i] * norm;
    divide_transposed(p->factor.at, s->u, p->step.at);
    for (int64_t j = 0; j < s->q; j++)
        for (int64_t k = 0; k < s->u; k++)
            x[j * width] += p->kinematics.at[j * s->u + k] * p->step.at[k];
    double rest = 0.0;
    for (int64_t i = 0; i < s->h; i++)
        rest = maximum(absolute(p->right.at[i]), rest);
    if (rest > 0.0) { /* rows that no speed reaches, and redundant ones */
        minimum_norm(&p->gradient, p, s->positions);
        for (int64_t j = 0; j < s->q; j++)
            x[j * width] += p->step.at[j];
    }
}

/* Move speeds in the same way. */
APART void move_speeds(const Held *s, double *x, int64_t width)
{
    const Projection *p = s->scratch;
    copy_table(s->velocity, &p->velocity);
    divide_rows(p->velocity.at, s->v, p->factor.at, s->u);
    minimum_norm(&p->velocity, p, s->motions);
    divide_transposed(p->factor.at, s->u, p->step.at);
    for (int64_t k = 0; k < s->u; k++)
        x[(s->q + k) * width] += p->step.at[k];
}

#endif
