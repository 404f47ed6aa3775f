"""What is zero, small and dependent among computed numbers: the one place that decides it.

No decision knows a unit. A value is zero when it is within the rounding of the terms it is made of.
A matrix is judged after its rows and columns were brought to one size: a constraint in millimetres
is the same constraint, and a coordinate in nanometres the same coordinate.
"""

from __future__ import annotations

import numpy as np

ROUNDING = 2.0**-52
"""The distance from 1.0 to the next float."""

ROUNDED = 2.0**-42
"""What rounding leaves of a sum that is zero, in units of its terms: a thousand roundings.

A value passes some hundred operations on its way; each adds one rounding at most.
"""

OF_FEW = 100 * ROUNDING
"""The same of a few numbers that add up to zero, such as those of a row without variables."""

DEPENDENT = 1e-10
"""A row that is this much shorter without the directions of the others follows from them.

Rounding leaves 1e-16 times the condition of the rows before: up to a million of it, rows that
follow from others are recognised, and independent ones stay so up to 1e10.
"""

SOUND = 1e-2
"""A row of which this share is left without the directions of those before is sound to solve with.

A ratio of lengths of one row, without a unit: below it two of sixteen digits would be lost, and
others are taken, or all of them. Either way all rows hold; it decides how well, not which.
"""

HALF = 2.0**-26
"""Half the digits of a float. Two numbers for the same thing agree in more of them, even if they
were computed in different ways; numbers for different things agree in fewer."""

DIGITS = 1e-5
"""The precision of numbers that were typed to six digits."""

_SWEEPS, _EXACT = 8, 30  # the exponents' error halves at each; then pivots of one size are such


def is_zero(value: np.ndarray | float, bound: np.ndarray | float) -> np.ndarray:
    """Return whether values are within the rounding error of terms as large as `bound`."""
    return np.abs(value) <= ROUNDED * np.abs(bound)  # NaN is not


def or_one(sizes: np.ndarray) -> np.ndarray:
    """Replace zeros by ones, to divide by."""
    return np.where(sizes > 0.0, sizes, 1.0)


def unrounded(sizes: np.ndarray, units: np.ndarray | None = None) -> np.ndarray:
    """Return magnitudes of entries (..., m, k), zero where they are rounding errors of a row.

    Otherwise a column of rounding errors would be as large as the others. The numbers alone do not
    tell these from what is small in the user's units, as lengths of planets are beside angles:
    where `units` (..., k) of the columns are known, 0 being none, it is what is small in both.
    """
    small = sizes <= ROUNDED * sizes.max(axis=-1, keepdims=True, initial=0.0)
    if units is not None:
        told = sizes * or_one(units)[..., None, :]
        small &= told <= ROUNDED * told.max(axis=-1, keepdims=True, initial=0.0)
    return np.where(small, 0.0, sizes)


def equilibrated(
    matrix: np.ndarray, exact: bool = False, units: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Scale matrices (..., m, k) so that the largest entry of each row and column is near 1.

    After D. Ruiz, "A scaling algorithm to equilibrate both rows and columns norms in matrices",
    RAL-TR-2001-034. It begins with the columns in their `units`, where these are known; entries of
    rounding errors do not count, see `unrounded`.
    `exact` is for choices that no unit may decide: then it matters which entries are equal.
    Returned are ``matrix * columns / rows``, the rows (..., m, 1) and the columns (..., 1, k).
    """
    with np.errstate(invalid="ignore"):  # NaN where entries are not finite
        columns = np.ones((*matrix.shape[:-2], 1, matrix.shape[-1]))
        columns = columns if units is None else columns * or_one(units)[..., None, :]
        sizes = unrounded(np.abs(matrix), units) * columns
        rows = or_one(sizes.max(axis=-1, keepdims=True, initial=0.0))
        sizes = sizes / rows
        for _ in range(_EXACT if exact else _SWEEPS):
            tall = np.sqrt(or_one(sizes.max(axis=-2, keepdims=True, initial=0.0)))
            wide = np.sqrt(or_one(sizes.max(axis=-1, keepdims=True, initial=0.0)))
            sizes = sizes / (tall * wide)
            columns, rows = columns / tall, rows * wide
        return matrix * columns / rows, rows, columns


def rank(matrix: np.ndarray, least: float = DEPENDENT, units: np.ndarray | None = None) -> int:
    """Return how many rows of a matrix (m, k) are independent, in whatever units.

    Singular values below the share `least` of the largest are zero. For `units` see `unrounded`.
    """
    scaled = equilibrated(matrix, units=units)[0]
    return rank_of(np.linalg.svd(scaled, compute_uv=False), least)


def null_space(
    matrix: np.ndarray, units: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Return directions (k − rank, k) in which no row changes, and the units (k,) of columns.

    The directions are orthonormal in these units: ``directions * columns`` solves the homogeneous
    equations of the matrix (m, k). For `units` see `unrounded`.
    """
    scaled, _, columns = equilibrated(matrix, units=units)
    _, sizes, right = np.linalg.svd(scaled)
    return right[rank_of(sizes) :], columns[0]


def least_step(
    matrix: np.ndarray, values: np.ndarray, units: np.ndarray | None = None
) -> np.ndarray:
    """Return the least z with ``matrix @ z = values``, in units of the columns.

    For `units` see `unrounded`.
    Matrices (..., m, k) have values (..., m); a single one may have several right-hand sides (m,
    n). Where rows contradict each other, z solves them as nearly as they allow, in units of the
    rows.
    """
    scaled, rows, columns = equilibrated(matrix, units=units)
    inverse = np.linalg.pinv(scaled, rcond=DEPENDENT)
    if matrix.ndim == 2 and values.ndim == 2:
        found: np.ndarray = columns[0, :, None] * (inverse @ (values / rows))
        return found
    found = columns[..., 0, :] * (inverse @ (values[..., None] / rows))[..., 0]
    return found


def roundings(slopes: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return bounds on the residuals, due to rounding, of rows at states solved from them.

    The `slopes` (..., m, k) are the rows' derivatives by the states, the `sizes` (..., m) those of
    their terms. By elimination, errors of a row become errors of all others that hold the same
    unknowns, and those of these. A row of unknowns that are zero has no larger terms of its own.
    """
    scaled, rows, _ = equilibrated(slopes)
    # The share of a row's error that comes from another: that of the unknown that both hold.
    linked = np.minimum(np.abs(scaled) @ np.abs(scaled).swapaxes(-1, -2), 1.0)
    for _ in range(rows.shape[-2].bit_length()):
        linked = np.minimum(linked @ linked, 1.0)
    found: np.ndarray = ROUNDED * rows[..., 0] * (linked @ (sizes[..., None] / rows))[..., 0]
    return found


def independent_columns(scaled: np.ndarray) -> list[int]:
    """Return columns that the rows can be solved for, as many as there are independent rows.

    The matrix (m, k) is scaled as by `equilibrated`. By elimination with complete pivoting; of
    pivots of one size the first is taken, so that rounding does not choose.
    """
    work, found = scaled.copy(), []
    for _ in range(min(work.shape)):
        sizes = np.abs(work)
        if not sizes.max() > DEPENDENT:
            break
        i, j = np.argwhere(sizes >= (1.0 - HALF) * sizes.max())[0]
        found.append(int(j))
        work = work - np.outer(work[:, j], work[i] / work[i, j])
        work[i], work[:, j] = 0.0, 0.0
    return found


def rank_of(sizes: np.ndarray, least: float = DEPENDENT) -> int:
    """Return how many singular values of a matrix, in units of its own, are not zero."""
    return int((sizes > least * sizes.max(initial=0.0)).sum())
