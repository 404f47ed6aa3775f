/* Solve in place of the right-hand side b, with the factors from lu_factor. */
static inline void lu_solve(int64_t n, const double *a, const int64_t *pivots, double *b)
{
    SERIAL
    for (int64_t k = 0; k < n; k++) {
        const int64_t pivot = pivots[AT(k)];
        const double swapped = b[AT(k)];
        b[AT(k)] = b[AT(pivot)];
        b[AT(pivot)] = swapped;
    }
    for (int64_t i = 0; i < n; i++)
        SERIAL
        for (int64_t k = 0; k < i; k++)
            b[AT(i)] = LESS(b[AT(i)], a[AT(i * n + k)], b[AT(k)]);
    for (int64_t i = n - 1; i >= 0; i--) {
        SERIAL
        for (int64_t k = i + 1; k < n; k++)
            b[AT(i)] = LESS(b[AT(i)], a[AT(i * n + k)], b[AT(k)]);
        b[AT(i)] /= a[AT(i * n + i)];
    }
}
