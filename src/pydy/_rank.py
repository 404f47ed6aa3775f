"""Decide which computed numbers are zero and which rows are linearly dependent.

All decisions are independent of units. A value is zero if it is within the rounding error of its
terms. The rank of a matrix is determined after its rows and columns were scaled to equal size, so
that it does not matter whether a constraint is in millimetres or a coordinate in nanometres.
"""

from __future__ import annotations

import numpy as np

ROUNDING = 2.0**-52
"""The distance from 1.0 to the next float."""

ROUNDED = 2.0**-42
"""The largest rounding error of a sum that should be zero, relative to its terms: 1000 roundings.

A value results from some hundred operations, each of which adds at most one rounding.
"""

ROUNDINGS = 8.0
"""The largest residual of a constraint that is satisfied, in units of its rounding bound."""

OF_FEW = 100 * ROUNDING
"""The same for a sum of a few numbers, such as a row without variables."""

DEPENDENT = 1e-10
"""A row depends on others if its part orthogonal to them is below this share of its length.

Rounding errors are 1e-16 times the condition number of the rows before. Dependent rows are
recognised up to a condition number of a million, independent ones up to 1e10.
"""

SOUND = 1e-2
"""A row is well conditioned if its part orthogonal to the rows before exceeds this share of it.

Below this dimensionless ratio two of sixteen digits would be lost, and other rows are selected, or
all of them. All rows are satisfied in either case; the choice affects only the accuracy.
"""

HALF = 2.0**-26
"""Half the digits of a float. Two numbers for the same thing agree in more of them, even if they
were computed in different ways; numbers for different things agree in fewer."""

DIGITS = 1e-5
"""The precision of numbers that were typed to six digits."""

# The error of the exponents halves in each sweep; after 30, equal pivots are equal to rounding.
_SWEEPS, _EXACT = 8, 30


def is_zero(value: np.ndarray | float, bound: np.ndarray | float) -> np.ndarray:
    """Return whether values are within the rounding error of terms as large as `bound`."""
    return np.abs(value) <= ROUNDED * np.abs(bound)  # NaN is not


def within_rounding(residuals: np.ndarray, bounds: np.ndarray) -> bool:
    """Return whether residuals are within their rounding errors.

    The bounds on their rounding errors are in units of 2⁻⁵²; see `pydy._graph.rounding`.
    """
    allowed = ROUNDINGS * ROUNDING * bounds + np.finfo(float).tiny  # an underflow is no error
    return bool((np.abs(residuals) <= allowed).all())


def or_one(sizes: np.ndarray) -> np.ndarray:
    """Replace zeros by ones, to divide by."""
    return np.where(sizes > 0.0, sizes, 1.0)


def unrounded(sizes: np.ndarray, units: np.ndarray | None = None) -> np.ndarray:
    """Return magnitudes of entries (..., m, k), zero where they are rounding errors of a row.

    Otherwise scaling would make a column of rounding errors as large as the others. Entries may
    also be small because of the user's units, as angles are compared with lengths of planets: if
    `units` (..., k) of the columns are given (0 means unknown), entries must be small in both.
    """
    small = sizes <= ROUNDED * sizes.max(axis=-1, keepdims=True, initial=0.0)
    if units is not None:
        scaled = sizes * or_one(units)[..., None, :]
        small &= scaled <= ROUNDED * scaled.max(axis=-1, keepdims=True, initial=0.0)
    return np.where(small, 0.0, sizes)


def equilibrated(
    matrix: np.ndarray, exact: bool = False, units: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Scale matrices (..., m, k) so that the largest entry of each row and column is near 1.

    After D. Ruiz, "A scaling algorithm to equilibrate both rows and columns norms in matrices",
    RAL-TR-2001-034. The initial scales of columns are their `units`, if known. Rounding errors are
    ignored, see `unrounded`. With `exact`, the scaling converges fully, so that no choice depends
    on units.
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
    """Return the number of independent rows of a matrix (m, k), independently of units.

    Singular values below the share `least` of the largest are zero. For `units` see `unrounded`.
    """
    scaled = equilibrated(matrix, units=units)[0]
    return rank_of(np.linalg.svd(scaled, compute_uv=False), least)


def null_space(
    matrix: np.ndarray, units: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Return the null space (k − rank, k) of a matrix, and the units (k,) of its columns.

    The directions are orthonormal in these units: ``directions * columns`` solves the homogeneous
    equations of the matrix (m, k). For `units` see `unrounded`.
    """
    scaled, _, columns = equilibrated(matrix, units=units)
    _, sizes, right = np.linalg.svd(scaled)
    return right[rank_of(sizes) :], columns[0]


def least_step(
    matrix: np.ndarray, values: np.ndarray, units: np.ndarray | None = None
) -> np.ndarray:
    """Return the minimum-norm solution z of ``matrix @ z = values``, in units of the columns.

    Matrices (..., m, k) have values (..., m); a single one may have several right-hand sides
    (m, n). If rows contradict each other, z is the least-squares solution, in units of the rows.
    For `units` see `unrounded`.
    """
    scaled, rows, columns = equilibrated(matrix, units=units)
    inverse = np.linalg.pinv(scaled, rcond=DEPENDENT)
    if matrix.ndim == 2 and values.ndim == 2:
        step: np.ndarray = columns[0, :, None] * (inverse @ (values / rows))
        return step
    step = columns[..., 0, :] * (inverse @ (values[..., None] / rows))[..., 0]
    return step


def roundings(slopes: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return bounds on the residuals, due to rounding, of rows at states solved from them.

    The `slopes` (..., m, k) are the rows' derivatives by the states, the `sizes` (..., m) those of
    their terms. Elimination propagates errors of a row to all rows that share unknowns with it,
    directly or through other rows; a row whose unknowns are zero has no larger terms itself.
    """
    scaled, rows, _ = equilibrated(slopes)
    # The share of a row's error that another row contributes: that of their common unknown.
    linked = np.minimum(np.abs(scaled) @ np.abs(scaled).swapaxes(-1, -2), 1.0)
    for _ in range(rows.shape[-2].bit_length()):
        linked = np.minimum(linked @ linked, 1.0)
    bounds: np.ndarray = ROUNDED * rows[..., 0] * (linked @ (sizes[..., None] / rows))[..., 0]
    return bounds


def independent_columns(scaled: np.ndarray) -> list[int]:
    """Return columns for which the rows can be solved, as many as there are independent rows.

    The matrix (m, k) is scaled as by `equilibrated`. The method is elimination with complete
    pivoting; of equal pivots the first is selected, so that rounding does not decide.
    """
    work, columns = scaled.copy(), []
    for _ in range(min(work.shape)):
        sizes = np.abs(work)
        if not sizes.max() > DEPENDENT:
            break
        i, j = np.argwhere(sizes >= (1.0 - HALF) * sizes.max())[0]
        columns.append(int(j))
        work = work - np.outer(work[:, j], work[i] / work[i, j])
        work[i], work[:, j] = 0.0, 0.0
    return columns


def rank_of(sizes: np.ndarray, least: float = DEPENDENT) -> int:
    """Return the number of nonzero singular values of a scaled matrix."""
    return int((sizes > least * sizes.max(initial=0.0)).sum())
