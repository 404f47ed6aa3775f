/* Linear systems of one kind of number; included once for each. NUMBER is the kind, OF(name) what
   a function is called, LENGTH_OF(a) the absolute value, OVER(a, b) a quotient. */

/* Factorise in place, with row pivots; 0 if the matrix is singular. */
APART int OF(factorise)(NUMBER *a, int64_t n, int64_t *order)
{
    for (int64_t k = 0; k < n; k++) {
        int64_t pivot = k;
        double largest = LENGTH_OF(a[k * n + k]);
        for (int64_t i = k + 1; i < n; i++) {
            const double size = LENGTH_OF(a[i * n + k]);
            if (size > largest)
                pivot = i, largest = size;
        }
        order[k] = pivot;
        if (largest == 0.0 || largest != largest)
            return 0;
        if (pivot != k)
            for (int64_t j = 0; j < n; j++) {
                const NUMBER kept = a[k * n + j];
                a[k * n + j] = a[pivot * n + j];
                a[pivot * n + j] = kept;
            }
        const NUMBER inverse = OVER(1.0, a[k * n + k]);
        for (int64_t i = k + 1; i < n; i++)
            if (a[i * n + k] != 0.0) {
                const NUMBER factor = a[i * n + k] * inverse;
                a[i * n + k] = factor;
                for (int64_t j = k + 1; j < n; j++)
                    a[i * n + j] -= factor * a[k * n + j];
            }
    }
    return 1;
}

/* Solve in place for one right-hand side. */
APART void OF(solve)(const NUMBER *a, int64_t n, const int64_t *order, NUMBER *right)
{
    for (int64_t k = 0; k < n; k++) {
        const NUMBER kept = right[k];
        right[k] = right[order[k]];
        right[order[k]] = kept;
    }
    for (int64_t i = 0; i < n; i++) {
        NUMBER value = right[i];
        for (int64_t j = 0; j < i; j++)
            value -= a[i * n + j] * right[j];
        right[i] = value;
    }
    for (int64_t i = n - 1; i >= 0; i--) {
        NUMBER value = right[i];
        for (int64_t j = i + 1; j < n; j++)
            value -= a[i * n + j] * right[j];
        right[i] = OVER(value, a[i * n + i]);
    }
}

INLINE void OF(subtract)(NUMBER *row, NUMBER factor, const NUMBER *other, int64_t width)
{
    for (int64_t c = 0; c < width; c++)
        row[c] -= factor * other[c];
}

/* Solve in place for the rows of some columns, which follow a first right-hand side. */
APART void OF(solve_columns)(const NUMBER *a, int64_t n, const int64_t *order, NUMBER *right,
    int64_t width)
{
    NUMBER *columns = right + n;
    for (int64_t k = 0; k < n; k++)
        if (order[k] != k)
            for (int64_t c = 0; c < width; c++) {
                const NUMBER kept = columns[k * width + c];
                columns[k * width + c] = columns[order[k] * width + c];
                columns[order[k] * width + c] = kept;
            }
    for (int64_t i = 0; i < n; i++)
        for (int64_t j = 0; j < i; j++)
            OF(subtract)(columns + i * width, a[i * n + j], columns + j * width, width);
    for (int64_t i = n - 1; i >= 0; i--) {
        for (int64_t j = i + 1; j < n; j++)
            OF(subtract)(columns + i * width, a[i * n + j], columns + j * width, width);
        const NUMBER inverse = OVER(1.0, a[i * n + i]);
        for (int64_t c = 0; c < width; c++)
            columns[i * width + c] *= inverse;
    }
}

#undef NUMBER
#undef OF
#undef LENGTH_OF
#undef OVER
