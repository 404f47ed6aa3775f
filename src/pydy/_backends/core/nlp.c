/* The functions of a nonlinear program, as IPOPT's C interface calls them.

   The program has pieces, each of which is evaluated at points. A *part* is one function of one
   piece: its kernel, which unknowns the points' variables are, and their units. Variables are
   gathered and results lie as [item][point], which sweeps by columns take and leave. Results of all
   pieces follow each other in the solver's own memory; they are divided by their units there. */

#include "kernel.h"

typedef struct {
    Words words;
    const int64_t *at;      /* [variable][point]: places of unknowns */
    const double *units;    /* as many */
    double *data;           /* [item][point]; of Hessians, weights of the rows and the cost last */
    const double *numbers;
    double *x, *results, *scratch;
    uint8_t *failed;
    const int64_t *to;      /* of gradients, [result][point]: places of unknowns */
    int64_t rows, costs;    /* of Hessians: how many weights there are */
    /* Known signals, if the duration is the last variable: how many, their first item of data,
       [signal][place in r, first knot, number of knots, 0], and the cubics from each knot on. */
    int64_t signals, first;
    const int64_t *tables;
    const double *knots, *cubics;
    /* Runs of as many points each: the first place where the others follow it, else -1. */
    int64_t length;
    const int64_t *runs;
} Part;

enum { COST, ROWS, GRADIENT, JACOBIAN, HESSIAN, KINDS };

typedef struct {
    int64_t n, m, counts[KINDS];
    const Part *parts[KINDS];
    const double *row_sizes, *gradient_units, *jacobian_units, *hessian_units;
    double *sums; /* n */
    double cost_size;
    const int32_t *places[4]; /* rows and columns of the Jacobian, then of the Hessian */
    int64_t entries[2];
} Nlp;

/* Arrays do not overlap; what is read from a struct once is not read again after each result. */
typedef double *restrict Out;
typedef const double *restrict In;

#define SERIAL _Pragma("clang loop vectorize(disable)") /* which gathers more slowly */

static int finite(double value) { return value - value == 0.0; }

/* Write the data of known signals: the knot before each point's time, and the cubic from there on,
   of which kernels make values and derivatives. The first and last cubic go on outside. */
static void look_up(const Part *a)
{
    const int64_t m = a->words.m;
    const double begin = a->numbers[a->words.k - 1];
    In durations = a->x + (a->words.n - 1) * m, fractions = a->data;
    for (int64_t k = 0; k < a->signals; k++) {
        const int64_t first = a->tables[4 * k + 1], number = a->tables[4 * k + 2];
        In knots = a->knots + first, cubics = a->cubics + 4 * first;
        Out rows = a->data + (a->first + 5 * k) * m;
        for (int64_t j = 0; j < m; j++) {
            const double t = begin + durations[j] * fractions[j];
            int64_t low = 0, high = number - 1;
            while (high - low > 1) {
                const int64_t middle = (low + high) / 2;
                if (knots[middle] <= t)
                    low = middle;
                else
                    high = middle;
            }
            rows[j] = knots[low];
            for (int64_t i = 0; i < 4; i++) rows[(1 + i) * m + j] = cubics[4 * low + i];
        }
    }
}

/* Evaluate a part; gives whether no linear solve failed. */
static int evaluated(const Part *a, const double *y, double *out)
{
    const int64_t m = a->words.m, length = a->length;
    uint8_t *restrict failed = a->failed;
    for (int64_t i = 0; i * length < a->words.n * m; i++) {
        const int64_t first = a->runs[i], *restrict at = a->at + i * length;
        In unknowns = first < 0 ? y : y + first, units = a->units + i * length;
        Out x = a->x + i * length;
        if (first < 0) {
            SERIAL
            for (int64_t k = 0; k < length; k++) x[k] = unknowns[at[k]] * units[k];
        } else
            for (int64_t k = 0; k < length; k++) x[k] = unknowns[k] * units[k];
    }
    for (int64_t k = 0; k < m; k++) failed[k] = 0;
    if (a->signals) look_up(a);
    /* Kernels do not read the time. */
    a->words.sweep(&a->words, a->x, a->x, a->data, a->numbers, out, a->failed, a->scratch);
    int any = 0;
    for (int64_t k = 0; k < m; k++) any |= failed[k];
    return !any;
}

/* By halves, and in blocks by eight partial sums: rounding grows with the logarithm of the count. */
static double sum(const double *v, int64_t count)
{
    if (count > 128) {
        const int64_t half = count / 2 - count / 2 % 8;
        return sum(v, half) + sum(v + half, count - half);
    }
    if (count < 8) {
        double total = 0.0;
        for (int64_t k = 0; k < count; k++) total += v[k];
        return total;
    }
    double s[8];
    int64_t k;
    for (k = 0; k < 8; k++) s[k] = v[k];
    for (; k < count - count % 8; k++) s[k % 8] += v[k];
    double total = ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
    for (; k < count; k++) total += v[k];
    return total;
}

/* Write the results of all parts of a kind one after the other. */
static int written(const Nlp *p, int kind, const double *y, double *out)
{
    int fine = 1;
    double *next = out;
    for (int64_t j = 0; j < p->counts[kind]; j++) {
        const Part *a = p->parts[kind] + j;
        fine &= evaluated(a, y, next);
        next += a->words.outputs * a->words.m;
    }
    return fine;
}

_Bool nlp_cost(int32_t n, const double *y, _Bool fresh, double *out, const Nlp *p)
{
    (void)n, (void)fresh;
    double total = 0.0;
    for (int64_t j = 0; j < p->counts[COST]; j++) {
        const Part *a = p->parts[COST] + j;
        total += evaluated(a, y, a->results) ? sum(a->results, a->words.m) : __builtin_nan("");
    }
    *out = total / p->cost_size;
    return finite(*out);
}

_Bool nlp_rows(int32_t n, const double *y, _Bool fresh, int32_t m, double *out, const Nlp *p)
{
    (void)n, (void)fresh;
    int fine = written(p, ROWS, y, out);
    Out rows = out;
    In sizes = p->row_sizes;
    for (int32_t i = 0; i < m; i++) rows[i] /= sizes[i];
    for (int32_t i = 0; i < m; i++) fine &= finite(rows[i]);
    return fine;
}

_Bool nlp_gradient(int32_t n, const double *y, _Bool fresh, double *out, const Nlp *p)
{
    (void)fresh;
    int fine = 1;
    Out slopes = out, sums = p->sums;
    In units = p->gradient_units;
    for (int32_t i = 0; i < n; i++) slopes[i] = 0.0;
    for (int64_t j = 0; j < p->counts[GRADIENT]; j++) {
        const Part *a = p->parts[GRADIENT] + j;
        const int64_t count = a->words.outputs * a->words.m, *restrict to = a->to;
        fine &= evaluated(a, y, a->results);
        In results = a->results;
        /* A piece's own sums first: they are of the same size. */
        for (int32_t i = 0; i < n; i++) sums[i] = 0.0;
        for (int64_t k = 0; k < count; k++) sums[to[k]] += results[k];
        for (int32_t i = 0; i < n; i++) slopes[i] += sums[i];
    }
    for (int32_t i = 0; i < n; i++) slopes[i] *= units[i];
    return fine;
}

static void told(const Nlp *p, int which, int32_t *rows, int32_t *columns)
{
    SERIAL
    for (int64_t k = 0; k < p->entries[which]; k++) {
        rows[k] = p->places[2 * which][k];
        columns[k] = p->places[2 * which + 1][k];
    }
}

_Bool nlp_jacobian(
    int32_t n, const double *y, _Bool fresh, int32_t m, int32_t count, int32_t *rows,
    int32_t *columns, double *out, const Nlp *p)
{
    (void)n, (void)fresh, (void)m;
    if (!out) {
        told(p, 0, rows, columns);
        return 1;
    }
    const int fine = written(p, JACOBIAN, y, out);
    Out entries = out;
    In units = p->jacobian_units;
    for (int32_t k = 0; k < count; k++) entries[k] *= units[k];
    return fine;
}

_Bool nlp_hessian(
    int32_t n, const double *y, _Bool fresh, double weight, int32_t m, const double *multipliers,
    _Bool again, int32_t count, int32_t *rows, int32_t *columns, double *out, const Nlp *p)
{
    (void)n, (void)fresh, (void)m, (void)again;
    if (!out) {
        told(p, 1, rows, columns);
        return 1;
    }
    int64_t first = 0;
    for (int64_t j = 0; j < p->counts[HESSIAN]; j++) {
        const Part *a = p->parts[HESSIAN] + j;
        const int64_t points = a->words.m;
        const int64_t own = a->rows * points, all = own + a->costs * points;
        Out weights = a->data + a->words.s * points - all;
        In given = multipliers + first, sizes = p->row_sizes + first;
        const double last = weight / p->cost_size;
        for (int64_t k = 0; k < own; k++) weights[k] = given[k] / sizes[k];
        for (int64_t k = own; k < all; k++) weights[k] = last;
        first += own;
    }
    const int fine = written(p, HESSIAN, y, out);
    Out entries = out;
    In units = p->hessian_units;
    for (int32_t k = 0; k < count; k++) entries[k] *= units[k];
    return fine;
}
