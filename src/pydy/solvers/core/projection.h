/* What the projections of a state and of its sensitivities share.

   Positions are corrected by Newton's method along the kinematics, dq = N du, where du is the least
   in the norm of the unreduced mass matrix; velocities by one linear solve in the same norm. What no
   du can mend, such as the norm of a quaternion, is mended by the least dq.

   E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd edition, section IV.4. */

#ifndef PROJECTION_H
#define PROJECTION_H

#include "step.h"

#if W > 1
typedef LaneRun Holder;
#define EQUATIONS(run) (&(run)->lane_problem)
#else
typedef Run Holder;
#define EQUATIONS(run) (&(run)->problem)
#endif

/* Constraints by their sizes, and where the parts of their kernel's values begin: residuals come
   first. What moves is what `which` has the bits of. */
typedef struct {
    const Projection *scratch;
    int64_t h, v, q, u, weighted, positions, motions; /* the last two: ranks of h, v rows */
    int64_t which;
    double *values, *gradient, *kinematics, *velocity, *mass, *rounding, *seen;
} Held;

INLINE Held held_by(const Holder *run, int64_t which)
{
    const int64_t *w = run->constraints.words.at;
    Held s = {.scratch = (const Projection *)w[SCRATCH], .h = w[HOLONOMIC], .v = w[VELOCITY],
        .q = w[COORDINATES], .u = w[SPEEDS], .weighted = w[WEIGHTED],
        .positions = w[POSITIONS], .motions = w[MOTIONS], .which = which,
        .values = run->constraints.values.at};
    s.gradient = s.values + W * (s.h + s.v);
    s.kinematics = s.gradient + W * s.h * s.q;
    s.velocity = s.kinematics + W * s.q * s.u;
    s.mass = s.velocity + W * s.v * s.u;
    s.rounding = s.mass + W * s.weighted * s.u * s.u;
    s.seen = s.rounding + W * s.h;
    return s;
}

/* -- linear algebra --------------------------------------------------------------------------- */

INLINE Real product(const double *a, const double *b, int64_t n)
{
    Real total = (Real)(0.0);
    for (int64_t k = 0; k < n; k++)
        total = total + item(a, k) * item(b, k);
    return total;
}

INLINE void set_identity(double *a, int64_t n, int64_t which)
{
    for (int64_t i = 0; i < n; i++)
        for (int64_t k = 0; k < n; k++)
            put(a, i * n + k, where(flags(which), (Real)(i == k ? 1.0 : 0.0), item(a, i * n + k)));
}

/* Replace a symmetric matrix by its Cholesky factor; by the identity where it has none. */
APART void factorise(double *a, int64_t n)
{
    int64_t good = EVERY;
    for (int64_t j = 0; j < n && good != 0; j++) {
        Real pivot = item(a, j * n + j);
        for (int64_t k = 0; k < j; k++)
            pivot = pivot - item(a, j * n + k) * item(a, j * n + k);
        good &= bits(pivot > 4.0 * (double)n * ROUNDING * item(a, j * n + j));
        pivot = root(pivot);
        put(a, j * n + j, pivot);
        for (int64_t i = j + 1; i < n; i++) {
            Real value = item(a, i * n + j);
            for (int64_t k = 0; k < j; k++)
                value = value - item(a, i * n + k) * item(a, j * n + k);
            put(a, i * n + j, value / pivot);
        }
    }
    if (good != EVERY)
        set_identity(a, n, EVERY & ~good);
}

/* Replace each of m rows a by a L^-T. */
APART void divide_rows(double *rows, int64_t m, const double *factor, int64_t n)
{
    for (int64_t row = 0; row < m; row++)
        for (int64_t i = 0; i < n; i++) {
            Real value = item(rows, row * n + i);
            for (int64_t k = 0; k < i; k++)
                value = value - item(factor, i * n + k) * item(rows, row * n + k);
            put(rows, row * n + i, value / item(factor, i * n + i));
        }
}

/* Replace y by L^-T y. */
APART void divide_transposed(const double *factor, int64_t n, double *y)
{
    for (int64_t i = n - 1; i >= 0; i--) {
        Real value = item(y, i);
        for (int64_t k = i + 1; k < n; k++)
            value = value - item(factor, k * n + i) * item(y, k);
        put(y, i, value / item(factor, i * n + i));
    }
}

/* Compute `step`, the least y with rows y = right; `right` keeps what no y can reach.

   Rows are scaled to unit length and orthogonalised, the longest first, and overwritten. `lengths`
   are those of the rows as they came, and `kept` what orthogonalisation left of them: 0 for
   redundant ones. No more than `rank` are taken, of which there are more where some were left out
   of the equations as redundant. Those come last, and take the place of others that are nearly
   dependent: beside all that hold, one that follows from them does so to the state's error only.
   Each lane has its own order of rows; `kept` stays in lanes that are none of `which`. */
APART void minimum_norm(const Numbers *matrix, const Projection *p, int64_t rank, int64_t which)
{
    const int64_t m = matrix->size, n = matrix->columns / W;
    double *rows = matrix->at, *y = p->step.at, *right = p->right.at, *scale = p->scale.at;
    double *lengths = p->lengths.at, *kept = p->kept.at, *best = p->best.at;
    Flags going = flags(which);
    Real turns = (Real)(0.0);
    for (int64_t k = 0; k < n; k++)
        put(y, k, (Real)(0.0));
    for (int64_t i = 0; i < m; i++) {
        double *row = rows + i * n * W;
        const Real norm = product(row, row, n), length = root(norm);
        const Real by = where(norm > 0.0, 1.0 / length, (Real)(1.0));
        put(lengths, i, where(norm > 0.0, length, (Real)(0.0)));
        put(kept, i, where(going, (Real)(0.0), item(kept, i)));
        put(scale, i, by);
        put(right, i, item(right, i) * by);
        for (int64_t k = 0; k < n; k++)
            put(row, k, item(row, k) * by);
    }
    for (int64_t turn = 0; turn < rank; turn++) {
        Real pivot = (Real)(-1.0), longest = (Real)(DEPENDENT * DEPENDENT), z = (Real)(0.0);
        Flags open = going;
        for (int64_t i = 0; i < m; i++) {
            if (i == rank)
                open = open & (longest <= SOUND * SOUND);
            const Flags left = open & (item(kept, i) == 0.0);
            if (bits(left) != 0) {
                const Real norm = product(rows + i * n * W, rows + i * n * W, n);
                const Flags longer = left & (norm > longest);
                pivot = where(longer, (Real)((double)i), pivot);
                longest = where(longer, norm, longest);
            }
        }
        going = going & (pivot >= 0.0);
        if (bits(going) == 0)
            break;
        turns = where(going, turns + 1.0, turns);
        const Real length = root(longest);
        for (int64_t i = 0; i < m; i++) {
            const Flags here = going & (pivot == (double)i);
            if (bits(here) == 0)
                continue;
            z = where(here, item(right, i) / length, z);
            put(right, i, where(here, (Real)(0.0), item(right, i)));
            put(kept, i, where(here, length * item(lengths, i), item(kept, i)));
            for (int64_t k = 0; k < n; k++)
                put(best, k, where(here, item(rows, i * n + k) / length, item(best, k)));
        }
        for (int64_t k = 0; k < n; k++)
            put(y, k, where(going, item(y, k) + z * item(best, k), item(y, k)));
        for (int64_t i = 0; i < m; i++) {
            double *row = rows + i * n * W;
            const Flags left = going & (item(kept, i) == 0.0);
            if (bits(left) == 0)
                continue;
            const Real along = product(row, best, n);
            put(right, i, where(left, item(right, i) - along * z, item(right, i)));
            for (int64_t k = 0; k < n; k++)
                put(row, k, where(left, item(row, k) - along * item(best, k), item(row, k)));
        }
    }
    const Flags enough = turns == (double)(rank < m ? rank : -1);
    for (int64_t i = 0; i < m; i++)
        put(right, i, where(enough, (Real)(0.0), item(right, i) / item(scale, i)));
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
        put(to, i, -item(from, i * width));
}

/* Compute the rows of (dh/dq) N. */
APART void set_rows(const Held *s)
{
    const Projection *p = s->scratch;
    for (int64_t i = 0; i < s->h; i++)
        for (int64_t k = 0; k < s->u; k++) {
            Real total = (Real)(0.0), size = total;
            for (int64_t j = 0; j < s->q; j++) {
                const Real term = item(p->gradient.at, i * s->q + j) * item(p->kinematics.at, j * s->u + k);
                total = total + term;
                size = size + absolute(term);
            }
            /* nothing but rounding, as in the norm of a quaternion */
            const Flags rounding = absolute(total) <= 4.0 * (double)s->q * ROUNDING * size;
            put(p->holonomic.at, i * s->u + k, where(rounding, (Real)(0.0), total));
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
    const double *step = p->step.at;
    copy_table(s->gradient, &p->gradient);
    set_rows(s);
    divide_rows(p->holonomic.at, s->h, p->factor.at, s->u);
    minimum_norm(&p->holonomic, p, s->positions, s->which);
    const Real norm = root(product(step, step, s->u));
    for (int64_t i = 0; i < s->h; i++) {
        const Real before = item(p->mended.at, i);
        put(p->mended.at, i, where(before == 0.0, item(p->lengths.at, i) * norm, before));
    }
    divide_transposed(p->factor.at, s->u, p->step.at);
    for (int64_t j = 0; j < s->q; j++) {
        Real place = item(x, j * width);
        for (int64_t k = 0; k < s->u; k++)
            place = place + item(p->kinematics.at, j * s->u + k) * item(step, k);
        put(x, j * width, where(flags(s->which), place, item(x, j * width)));
    }
    Real rest = (Real)(0.0);
    for (int64_t i = 0; i < s->h; i++)
        rest = maximum(absolute(item(p->right.at, i)), rest);
    const int64_t more = s->which & bits(rest > 0.0);
    if (more != 0) { /* rows that no speed reaches, and redundant ones */
        minimum_norm(&p->gradient, p, s->positions, more);
        for (int64_t j = 0; j < s->q; j++) {
            const Real place = item(x, j * width);
            put(x, j * width, where(flags(more), place + item(step, j), place));
        }
    }
}

/* Move speeds in the same way. */
APART void move_speeds(const Held *s, double *x, int64_t width)
{
    const Projection *p = s->scratch;
    copy_table(s->velocity, &p->velocity);
    divide_rows(p->velocity.at, s->v, p->factor.at, s->u);
    minimum_norm(&p->velocity, p, s->motions, s->which);
    divide_transposed(p->factor.at, s->u, p->step.at);
    for (int64_t k = 0; k < s->u; k++) {
        const Real speed = item(x, (s->q + k) * width);
        put(x, (s->q + k) * width, where(flags(s->which), speed + item(p->step.at, k), speed));
    }
}

#endif
