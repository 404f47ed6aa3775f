/* Linear systems of one kind of number, in W lanes; included once for each. NUMBER is the kind, OF(name)
   what a function is called. Numbers lie in arrays of doubles, as `item` and `put` have them. */

/* Factorise in place, with the row pivots of each lane; the diagonal is that of reciprocals. Return the
   bits of the lanes whose matrix is singular. */
APART int64_t OF(factorise)(double *a, int64_t n, double *order)
{
    Flags singular = flags(0);
    for (int64_t k = 0; k < n; k++) {
        Real pivot = (Real)((double)k), largest = OF(length)(OF(item)(a, k * n + k));
        for (int64_t i = k + 1; i < n; i++) {
            const Real size = OF(length)(OF(item)(a, i * n + k));
            const Flags more = size > largest;
            pivot = where(more, (Real)((double)i), pivot);
            largest = where(more, size, largest);
        }
        put(order, k, pivot);
        singular = singular | (largest == 0.0) | (largest != largest);
        for (int64_t i = k + 1; i < n && bits(pivot != (double)k) != 0; i++) {
            const Flags lower = pivot == (double)i;
            for (int64_t j = 0; j < n && bits(lower) != 0; j++) {
                const NUMBER one = OF(item)(a, k * n + j), other = OF(item)(a, i * n + j);
                OF(put)(a, k * n + j, OF(where)(lower, other, one));
                OF(put)(a, i * n + j, OF(where)(lower, one, other));
            }
        }
        const NUMBER inverse = OF(inverse)(OF(item)(a, k * n + k));
        OF(put)(a, k * n + k, inverse);
        for (int64_t i = k + 1; i < n; i++) {
            const NUMBER under = OF(item)(a, i * n + k);
            const Flags some = OF(length)(under) != 0.0;
            if (bits(some) == 0)
                continue;
            const NUMBER factor = OF(where)(some, OF(times)(under, inverse), under);
            OF(put)(a, i * n + k, factor);
            for (int64_t j = k + 1; j < n; j++) {
                const NUMBER x = OF(item)(a, i * n + j);
                const NUMBER y = OF(less)(x, factor, OF(item)(a, k * n + j));
                OF(put)(a, i * n + j, OF(where)(some, y, x));
            }
        }
    }
    return bits(singular);
}

/* Solve in place for one right-hand side. */
APART void OF(solve)(const double *a, int64_t n, const double *order, double *right)
{
    interchange(right, n, order, PARTS_OF(NUMBER));
    for (int64_t i = 0; i < n; i++) {
        NUMBER value = OF(item)(right, i);
        for (int64_t j = 0; j < i; j++)
            value = OF(less)(value, OF(item)(a, i * n + j), OF(item)(right, j));
        OF(put)(right, i, value);
    }
    for (int64_t i = n - 1; i >= 0; i--) {
        NUMBER value = OF(item)(right, i);
        for (int64_t j = i + 1; j < n; j++)
            value = OF(less)(value, OF(item)(a, i * n + j), OF(item)(right, j));
        OF(put)(right, i, OF(times)(value, OF(item)(a, i * n + i)));
    }
}

INLINE void OF(subtract)(double *columns, int64_t i, NUMBER factor, int64_t j, int64_t width)
{
    for (int64_t c = 0; c < width; c++) {
        const NUMBER x = OF(item)(columns, i * width + c);
        OF(put)(columns, i * width + c, OF(less)(x, factor, OF(item)(columns, j * width + c)));
    }
}

/* Solve in place for the rows of some columns. */
APART void OF(solve_columns)(const double *a, int64_t n, const double *order, double *columns, int64_t width)
{
    interchange(columns, n, order, width * PARTS_OF(NUMBER));
    for (int64_t i = 0; i < n; i++)
        for (int64_t j = 0; j < i; j++)
            OF(subtract)(columns, i, OF(item)(a, i * n + j), j, width);
    for (int64_t i = n - 1; i >= 0; i--) {
        for (int64_t j = i + 1; j < n; j++)
            OF(subtract)(columns, i, OF(item)(a, i * n + j), j, width);
        for (int64_t c = 0; c < width; c++) {
            const NUMBER value = OF(item)(columns, i * width + c);
            OF(put)(columns, i * width + c, OF(times)(value, OF(item)(a, i * n + i)));
        }
    }
}

#undef NUMBER
#undef OF
