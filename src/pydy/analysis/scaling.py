"""Units of rows and columns, so that ranks and steps do not depend on those of the user."""

from __future__ import annotations

import numpy as np

from pydy.analysis.tuning import NOTHING

__all__ = ["equilibrated", "scaled_step", "sizes_along"]

_SWEEPS = 8  # the exponents' error halves at each


def equilibrated(slopes: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return Jacobians with the largest entry of each row and column near 1.

    After D. Ruiz, "A scaling algorithm to equilibrate both rows and columns norms in matrices",
    RAL-TR-2001-034. What rounding leaves of zeros does not count: else a column of nothing else
    would be as large as the others.

    Parameters
    ----------
    slopes : ndarray, shape (..., m, k)

    Returns
    -------
    scaled : ndarray, shape (..., m, k)
        ``slopes * columns / rows``.
    rows : ndarray, shape (..., m, 1)
    columns : ndarray, shape (..., 1, k)
    """
    sizes = np.abs(slopes)
    rows = _or_one(sizes.max(axis=-1, keepdims=True, initial=0.0))
    sizes = sizes / rows
    sizes[sizes <= NOTHING] = 0.0
    columns = np.ones_like(sizes[..., :1, :])
    for _ in range(_SWEEPS):
        tall = np.sqrt(_or_one(sizes.max(axis=-2, keepdims=True, initial=0.0)))
        wide = np.sqrt(_or_one(sizes.max(axis=-1, keepdims=True, initial=0.0)))
        sizes = sizes / (tall * wide)
        columns, rows = columns / tall, rows * wide
    return slopes * columns / rows, rows, columns


def scaled_step(slopes: np.ndarray, values: np.ndarray, rank: float) -> np.ndarray:
    """Return the least z with ``slopes @ z = values``, in units of the columns.

    Rows weigh what they do: a row of rounding errors, as next to a singular configuration, would
    otherwise count like the rest.

    Parameters
    ----------
    slopes : ndarray, shape (m, k)
    values : ndarray, shape (m,)
    rank : float
        Singular values below this share of the largest are zero.
    """
    sizes = np.abs(slopes)
    sizes[sizes <= NOTHING * sizes.max(axis=1, keepdims=True, initial=0.0)] = 0.0
    columns = 1.0 / _or_one(sizes.max(axis=0, initial=0.0))
    step: np.ndarray = columns * np.linalg.lstsq(slopes * columns, values, rcond=rank)[0]
    return step


def sizes_along(slopes: np.ndarray, z: np.ndarray, span: float) -> np.ndarray:
    """Return sizes of the unknowns; of the parameter, which is the last, its span.

    Unknowns that the parameter moves are as large as what it moves them by, or as they are: with
    each entry of the Jacobian times the size of its column as large as its row, as far as least
    squares of logarithms allow (Curtis and Reid, J. Inst. Maths Applics 10 (1972) 118-124). That
    does not depend on the units that a user works in. What nothing tells of has the size 1.
    """
    m, k = slopes.shape
    sizes = np.abs(slopes)
    sizes[:, -1] *= span
    row, column = np.nonzero(sizes > NOTHING * sizes.max(axis=1, initial=0.0, keepdims=True))
    table = np.zeros((len(row), m + k))
    table[np.arange(len(row)), row] = table[np.arange(len(row)), m + column] = 1.0
    logs = np.linalg.lstsq(table[:, :-1], -np.log(sizes[row, column]), rcond=None)[0]
    return np.append(np.maximum(np.abs(z[:-1]), np.exp(logs[m:])), span)


def _or_one(sizes: np.ndarray) -> np.ndarray:
    known: np.ndarray = np.where(sizes > 0.0, sizes, 1.0)
    return known
