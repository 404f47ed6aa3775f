/* Eliminate column q from all rows but p, which is divided by nothing. */
static inline void eliminate(
    int64_t n, double *a, int64_t *pivots, int64_t many, double *b, int64_t p, int64_t q)
{
    const double inverse = 1.0 / a[AT(p * n + q)];
    for (int64_t i = 0; i < n; i++) {
        const double factor = a[AT(i * n + q)] * inverse;
        if (i == p || factor == 0.0)
            continue;
        SERIAL
        for (int64_t j = 0; j < n; j++)
            a[AT(i * n + j)] = LESS(a[AT(i * n + j)], factor, a[AT(p * n + j)]);
        SERIAL
        for (int64_t j = 0; j < many; j += n)
            b[AT(j + i)] = LESS(b[AT(j + i)], factor, b[AT(j + p)]);
    }
    pivots[AT(p)] = q;
}

/* Solve M x - A^T l = f, A x = b in place of right-hand sides, so many numbers in all, by Gauss
   and Jordan's elimination, whatever the rank of A; `scales` is 2 n numbers of work space. The last
   rows, with a mark on the diagonal, are those of A in units of their rounding errors; so many are
   independent as are marked so. Pivots are the largest of A, then of the diagonal of M. Returns
   whether M is singular. */
static inline int32_t constrained(
    int64_t n, double *a, int64_t *pivots, double *scales, int64_t many, double *b)
{
    int64_t first = n, left = 0;
    int32_t singular = 0;
    double rest = 0.0, any = 0.0; /* NaN, if anything is not finite, of a or of b */
    SERIAL
    for (int64_t i = 0; i < many; i++)
        any += 0.0 * b[AT(i)];
    for (int64_t i = 0; i < n; i++) {
        pivots[AT(i)] = -1;
        SERIAL
        for (int64_t j = 0; j < n; j++)
            rest += 0.0 * a[AT(i * n + j)];
    }
    SERIAL
    for (; first; first--) {
        const double mark = a[AT(first * n - n + first - 1)];
        if (mark != INDEPENDENT && mark != REDUNDANT)
            break;
        left += mark == INDEPENDENT;
        a[AT(first * n - n + first - 1)] = 0.0;
    }
    for (int64_t j = 0; j < first; j++) {
        const double own = a[AT(j * n + j)];
        double top = 0.0;
        SERIAL
        for (int64_t i = first; i < n; i++) {
            const double size = fabs(a[AT(i * n + j)]);
            top = size > top ? size : top;
        }
        scales[j] = own > 0.0 ? 1.0 / sqrt(own) : 1.0 / (SINGULAR * (top > 0.0 ? top : 1.0));
    }
    for (int64_t k = 0; k < first; k++) {
        double best = (double)n;
        int64_t row = -1, column = -1;
        for (int64_t i = first; left && i < n; i++)
            SERIAL
            for (int64_t j = 0; j < first && pivots[AT(i)] < 0; j++) {
                if (pivots[AT(j)] >= 0)
                    continue;
                const double size = fabs(a[AT(i * n + j)]) * scales[j];
                if (size > best) {
                    best = size;
                    row = i;
                    column = j;
                }
            }
        if (row < 0) {
            left = 0;
            best = (double)n * SINGULAR;
            SERIAL
            for (int64_t j = 0; j < first; j++) {
                if (pivots[AT(j)] >= 0)
                    continue;
                const double size = fabs(a[AT(j * n + j)]) * scales[j] * scales[j];
                if (size > best) {
                    best = size;
                    row = column = j;
                }
            }
        } else
            left--;
        if (row < 0) {
            singular = rest + any == 0.0;
            rest = NAN;
            break;
        }
        eliminate(n, a, pivots, many, b, row, column);
        if (row != column)
            eliminate(n, a, pivots, many, b, column, row);
    }
    for (int64_t j = 0; j < many; j += n) {
        double added = rest;
        SERIAL
        for (int64_t i = 0; i < n; i++) {
            added += 0.0 * b[AT(j + i)];
            scales[n + i] = 0.0;
        }
        SERIAL
        for (int64_t i = 0; i < n; i++) {
            const int64_t q = pivots[AT(i)];
            if (q >= 0)
                scales[n + q] = b[AT(j + i)] / a[AT(i * n + q)];
        }
        SERIAL
        for (int64_t i = 0; i < n; i++)
            b[AT(j + i)] = scales[n + i] + added;
    }
    return singular;
}
