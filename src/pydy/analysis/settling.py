"""Where a system settles: what it moves to if every swing dies out, from however far away.

Steps of implicit Euler follow the equations of motion; what swings within a step is damped, so that
steps grow until they are Newton's (pseudo-transient continuation: C. T. Kelley and D. E. Keyes,
SIAM J. Numer. Anal. 35 (1998) 508-523). Constraints are closed on the way. A step is as long as the
equations are nearly linear along it. All sizes are ratios of entries of the Jacobian, so that the
way does not depend on units.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
import scipy

from pydy._rank import or_one, rank_of
from pydy.analysis.tuning import BENT, NEARLY_STRAIGHT, SETTLED

_TRIALS = 400
_LONGER = 3.0


def settled(
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    rates: Mapping[int, int],
    held: int,
) -> np.ndarray:
    """Return where the unknowns settle, or have come to when this was given up.

    The parameters are parts of a `Problem`, where to begin, and bounds.
    """
    values, slopes = residual(z), jacobian(z)
    own, columns = list(rates), list(rates.values())
    hard = np.arange(len(values) - held, len(values))
    soft = np.arange(len(values) - held)
    moves = np.zeros_like(slopes)
    moves[own, columns] = 1.0
    fastest, length, share = 0.0, 0.0, 1.0
    for _ in range(_TRIALS):
        if not (np.isfinite(slopes).all() and np.isfinite(values).all()):
            break
        units, speed = unknown_units(slopes, own, columns)
        if not length:
            fastest, length = speed, 1.0 / speed
        scaled = slopes * units
        sizes = or_one(np.abs(scaled).max(axis=1, initial=0.0))
        sizes[own] = units[columns] / length
        closing, along = _constrained(scaled[hard] / sizes[hard, None], values[hard] / sizes[hard])
        step = share * closing
        whole = (moves * units / length - scaled)[soft] / sizes[soft, None]
        right = values[soft] / sizes[soft] - whole @ step
        step = step + along @ np.linalg.lstsq(whole @ along, right, rcond=None)[0]
        after = np.clip(z + units * step, *bounds)
        found = residual(after)
        bent = np.abs((found - values - slopes @ (after - z)) / sizes).max(initial=0.0)
        moved = np.abs(step).max(initial=0.0)
        if not bent <= BENT * moved:
            length, share = length / _LONGER, share / _LONGER
            continue
        z, values, slopes = after, found, jacobian(after)
        share = min(1.0, _LONGER * share)
        if bent <= NEARLY_STRAIGHT * moved:
            length *= _LONGER
        if not moved or length * fastest > SETTLED:
            break
    return z


def _constrained(rows: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the least step that closes the constraints, and the directions that keep them."""
    if not len(rows):
        return np.zeros(rows.shape[1]), np.eye(rows.shape[1])
    left, singular, right = np.linalg.svd(rows)
    rank = rank_of(singular)
    solved = (left.T @ values)[:rank] / singular[:rank]
    return -right[:rank].T @ solved, right[rank:].T


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
