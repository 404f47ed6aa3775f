"""Units of rows and columns, so that ranks and steps do not depend on those of the user."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy

from pydy._rank import DEPENDENT, is_zero, or_one

__all__ = ["scaled_step", "sizes_along", "unknown_units"]


def unknown_units(
    slopes: np.ndarray, own: Sequence[int], columns: Sequence[int]
) -> tuple[np.ndarray, float]:
    """Return units of the unknowns in which rates are balanced, and the fastest of these.

    That leaves a factor common to all, which no step depends on. The rows `own` of the slopes (m,
    k) are rates of the unknowns `columns`; the units of others follow from those of the rows that
    they are in.
    """
    k = slopes.shape[1]
    between = slopes[np.ix_(own, columns)]
    units = np.ones(k)
    if len(own):
        with np.errstate(invalid="ignore"):  # in what `separate` is not asked for
            balanced = scipy.linalg.matrix_balance(between, permute=False, separate=True)
        units[columns] = balanced[1][0]
    between = between * units[columns] / units[columns][:, None]
    speed = float(or_one(np.abs(np.linalg.eigvals(between)).max(initial=0.0)))
    others = np.setdiff1d(np.arange(k), columns)
    sizes = np.abs(slopes[:, columns] * units[columns]).max(axis=1, initial=0.0)
    sizes[own] = units[columns] * speed
    sizes = np.where(sizes > 0.0, sizes, np.inf)
    units[others] = 1.0 / or_one(np.abs(slopes[:, others] / sizes[:, None]).max(axis=0))
    return units, speed


def scaled_step(slopes: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the least z with ``slopes @ z = values``, in units of the columns.

    Rows weigh what they do: a row of rounding errors, as next to a singular configuration, would
    otherwise count like the rest.
    """
    sizes = np.abs(slopes)
    sizes[is_zero(sizes, sizes.max(axis=1, keepdims=True, initial=0.0))] = 0.0
    columns = 1.0 / or_one(sizes.max(axis=0, initial=0.0))
    step: np.ndarray = columns * np.linalg.lstsq(slopes * columns, values, rcond=DEPENDENT)[0]
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
    row, column = np.nonzero(~is_zero(sizes, sizes.max(axis=1, initial=0.0, keepdims=True)))
    table = np.zeros((len(row), m + k))
    table[np.arange(len(row)), row] = table[np.arange(len(row)), m + column] = 1.0
    logs = np.linalg.lstsq(table[:, :-1], -np.log(sizes[row, column]), rcond=None)[0]
    return np.append(np.maximum(np.abs(z[:-1]), np.exp(logs[m:])), span)
