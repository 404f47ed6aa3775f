/* Factorise the n by n matrix a in place by LU with partial pivoting; `scales` is 2 n numbers of
   work space, the reciprocal sizes of the rows and then of the columns. Returns whether a is
   singular. */
static inline int32_t lu_factor(int64_t n, double *a, int64_t *pivots, double *scales)
{
    const double tolerance = (double)n * SINGULAR;
    int32_t singular = 0;
    for (int64_t i = 0; i < n; i++) {
        double top = 0.0;
        SERIAL
        for (int64_t j = 0; j < n; j++) {
            const double size = fabs(a[AT(i * n + j)]);
            top = size > top ? size : top;
        }
        scales[i] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int64_t j = 0; j < n; j++) {
        double top = 0.0;
        SERIAL
        for (int64_t i = 0; i < n; i++) {
            const double size = fabs(a[AT(i * n + j)]) * scales[i];
            top = size > top ? size : top;
        }
        scales[n + j] = 1.0 / (top > 0.0 ? top : 1.0);
    }
    for (int64_t k = 0; k < n; k++) {
        int64_t pivot = k;
        double best = fabs(a[AT(k * n + k)]) * scales[k];
        SERIAL
        for (int64_t i = k + 1; i < n; i++) {
            const double size = fabs(a[AT(i * n + k)]) * scales[i];
            if (size > best) {
                best = size;
                pivot = i;
            }
        }
        if (best * scales[n + k] <= tolerance)
            singular = 1;
        pivots[AT(k)] = pivot;
        if (pivot != k) {
            SERIAL
            for (int64_t j = 0; j < n; j++) {
                const double swapped = a[AT(k * n + j)];
                a[AT(k * n + j)] = a[AT(pivot * n + j)];
                a[AT(pivot * n + j)] = swapped;
            }
            const double swapped = scales[k];
            scales[k] = scales[pivot];
            scales[pivot] = swapped;
        }
        const double inverse = 1.0 / a[AT(k * n + k)];
        for (int64_t i = k + 1; i < n; i++) {
            const double factor = a[AT(i * n + k)] * inverse;
            a[AT(i * n + k)] = factor;
            SERIAL
            for (int64_t j = k + 1; j < n; j++)
                a[AT(i * n + j)] = LESS(a[AT(i * n + j)], factor, a[AT(k * n + j)]);
        }
    }
    if (singular)
        a[AT(n * n - 1)] = NAN; /* so that every solution is NaN */
    return singular;
}
