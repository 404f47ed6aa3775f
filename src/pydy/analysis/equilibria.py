"""States of rest or steady motion: equilibria, relative equilibria, trims.

The unknowns are found by least squares on the derivatives of the states and the residuals of the
constraints, with exact Jacobians: `scipy.optimize.least_squares` finds the neighbourhood, within
bounds, and Newton's method with the pseudo-inverse continues to rounding accuracy. Where that finds
none, the search begins again where the system settles, and then with the rows as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy

from pydy._errors import EquilibriumError
from pydy._names import place_of, unique_names
from pydy.analysis.directions import direction_text
from pydy.analysis.scaling import equilibrated, scaled_step
from pydy.analysis.settling import settled
from pydy.analysis.tuning import AT_BOUND, FREE, NAMED, NEWTON_STEP, TO_ROUNDING

__all__ = ["Equilibrium", "solve_equilibrium", "solve_many"]

_EPS = float(np.finfo(float).eps)
# A residual up to so many rounding errors of the terms it is made of is zero.
_ROUNDING = 1e5
# Of the largest term of all rows, so many: what a linear solve leaves in a row that vanishes.
_SOLVED = 100.0
_POLISH = 20
# Evaluations after which least squares hardly converge any more.
_TRIED = 200


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A state in which a system remains at rest or moves steadily.

    Attributes
    ----------
    values : dict
        The unknowns, by symbol.
    initial_conditions, constants, specifieds : dict
        All states, and the constants and specifieds among the unknowns. They can be assigned to the
        System's attributes of the same names.
    state : ndarray, shape (n,)
        The states in order.
    residual : float
        The largest residual.
    free : tuple of str
        Directions in which the unknowns can change without leaving the equilibrium, to first order;
        empty if it is isolated.
    given : dict
        The constants and specifieds that were given for the search.
    """

    values: dict[Any, float]
    initial_conditions: dict[Any, float]
    constants: dict[Any, float]
    specifieds: dict[Any, float]
    state: np.ndarray
    residual: float
    free: tuple[str, ...] = field(default=())
    given: dict[Any, float] = field(default_factory=dict)

    def __getitem__(self, unknown: Any) -> float:
        """Return the value of an unknown, by symbol or name."""
        values = list(self.values.values())
        return values[place_of(unknown, unique_names(list(self.values)), "unknowns")]

    def __str__(self) -> str:
        names = unique_names(list(self.values))
        parts = zip(names, self.values.values(), strict=True)
        shown = ", ".join(f"{name} = {value:.10g}" for name, value in parts)
        text = f"Equilibrium at {shown}; largest residual {self.residual:.2g}"
        return text + (f"; free: {'; '.join(self.free)}" if self.free else "")

    __repr__ = __str__


def solve_equilibrium(
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    start: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    unknowns: Sequence[str],
    rows: Sequence[str],
    rates: Mapping[int, int],
    held: int,
) -> tuple[np.ndarray, float, tuple[str, ...]]:
    """Solve ``residual(z) = 0``.

    Parameters
    ----------
    residual : callable
        ``residual(z)``, shape (m,).
    jacobian : callable
        ``jacobian(z)``, shape (m, k).
    start : ndarray, shape (k,)
    bounds : (ndarray, ndarray), shapes (k,)
        Lowest and highest values.
    unknowns, rows : sequence of str
        Names, for messages.
    rates : mapping of int to int
        The rows that are rates of an unknown, and its place.
    held : int
        How many of the rows, the last ones, are constraints.

    Returns
    -------
    z : ndarray, shape (k,)
    largest : float
        The largest residual.
    free : tuple of str
        Combinations of unknowns that the equations do not determine.

    Raises
    ------
    EquilibriumError
        None was found.
    """
    z = np.clip(start, *bounds)
    missed: EquilibriumError | None = None
    for attempt in ("near", "settled", "plain"):
        with np.errstate(all="ignore"):
            far = attempt == "settled"
            begin = settled(residual, jacobian, z, bounds, rates, held) if far else z
        # Sizes at the start mislead where wheels do not turn yet: the rows as they are do not.
        size = np.ones(len(rows)) if attempt == "plain" else _sizes(jacobian(begin), begin)
        found, message = _search(residual, jacobian, begin, bounds, size)
        try:
            accepted = _accepted(residual, jacobian, found, bounds, unknowns, rows, message)
        except EquilibriumError as error:
            missed = missed or error
            continue
        return _as_begun(accepted, residual, jacobian, z, bounds, unknowns, rows)
    assert missed is not None
    raise missed


def _as_begun(
    accepted: tuple[np.ndarray, float, tuple[str, ...]],
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    start: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    unknowns: Sequence[str],
    rows: Sequence[str],
) -> tuple[np.ndarray, float, tuple[str, ...]]:
    """Return the same equilibrium with what is free as it was at the start, where that is one too.

    The search moves what no equation tells of as well: a sleigh comes to rest anywhere.
    """
    found = accepted[0]
    free, columns = _free(jacobian(found))
    back = free.T @ (free @ ((start - found) / columns)) * columns
    if not np.abs(back).max(initial=0.0) > 0.0:
        return accepted
    with np.errstate(all="ignore"):
        there = _polished(residual, jacobian, np.clip(found + back, *bounds), *bounds)
        try:
            again = _accepted(residual, jacobian, there, bounds, unknowns, rows, "")
        except EquilibriumError:
            return accepted
    nearer = np.linalg.norm((there - start) / columns) < np.linalg.norm((found - start) / columns)
    return again if nearer else accepted


def _search(
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    size: np.ndarray,
) -> tuple[np.ndarray, str]:
    """Return what is found with each row in units of its size, and why it is no better."""
    low, high = bounds

    def share(z: np.ndarray) -> np.ndarray:
        shares: np.ndarray = residual(z) / size
        return shares

    def slopes(z: np.ndarray) -> np.ndarray:
        shares: np.ndarray = jacobian(z) / size[:, None]
        return shares

    with np.errstate(all="ignore"):
        near = _quickly(share, slopes, z, low, high)
        if near is not None:
            return near, ""
        try:
            found = scipy.optimize.least_squares(
                share, z, slopes, bounds, x_scale="jac",
                xtol=TO_ROUNDING, ftol=TO_ROUNDING, gtol=TO_ROUNDING,
                max_nfev=_TRIED,
            )  # fmt: skip
        except ValueError as error:  # residuals that are not finite at the start
            return z, str(error)
    return _polished(share, slopes, found.x, low, high), found.message


def _sizes(slopes: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return the units to search in: of each row what its terms are of at the start.

    In SI units accelerations under some load are a million times what is left of a constraint,
    which a search on both as they are would hardly see.
    """
    with np.errstate(all="ignore"):
        terms = _terms(slopes, z)
    return np.where(np.isfinite(terms) & (terms > 0.0), terms, 1.0)


def _quickly(
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
) -> np.ndarray | None:
    """Return what Newton's method finds if it converges from the start, at least tenfold a step.

    Else the neighbourhood has to be found first: None.
    """
    values = residual(z)
    for _ in range(_POLISH):
        size = np.abs(values).max(initial=0.0)
        slopes = jacobian(z)
        if not (np.isfinite(size) and np.isfinite(slopes).all()):
            return None
        step = scaled_step(slopes, values, FREE)
        if (np.abs(step) <= NEWTON_STEP * np.maximum(1.0, np.abs(z))).all():
            return _polished(residual, jacobian, z, low, high)
        z = z - step
        if (z < low).any() or (z > high).any():
            return None
        values = residual(z)
        if not np.abs(values).max(initial=0.0) <= 0.1 * size:
            return None
    return None


def _accepted(
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
    bounds: tuple[np.ndarray, np.ndarray],
    unknowns: Sequence[str],
    rows: Sequence[str],
    message: str,
) -> tuple[np.ndarray, float, tuple[str, ...]]:
    """Return what `solve_equilibrium` does, if the residuals are rounding errors."""
    low, high = bounds
    values, slopes = residual(z), jacobian(z)
    if not (np.isfinite(values).all() and np.isfinite(slopes).all()):
        raise EquilibriumError(
            "No equilibrium was found: the equations are not finite near "
            f"{_named(unknowns, z)}. Choose initial conditions closer to one.",
            z,
            values,
        )
    limit = _ROUNDING * _EPS * _scale(slopes, z, values)
    worst = np.abs(values) / np.maximum(limit, np.finfo(float).tiny)
    if (worst > 1.0).any():
        order = [k for k in np.argsort(-np.abs(values)) if worst[k] > 1.0][:3]
        left = ", ".join(f"{rows[k]} = {values[k]:.3g}" for k in order)
        at_bounds = [
            name
            for name, value, a, b in zip(unknowns, z, low, high, strict=True)
            if min(value - a, b - value) <= AT_BOUND * (min(b - a, 1.0) + abs(value))
        ]
        bound = f" At a bound: {', '.join(at_bounds)}." if at_bounds else ""
        why = f" ({' '.join(message.split())})" if message else ""
        raise EquilibriumError(
            f"No equilibrium was found. Nearest, at {_named(unknowns, z)}: {left}.{bound} "
            "Start closer to an equilibrium, add unknowns, or list coordinates that keep moving in "
            f"`moving`.{why}",
            z,
            values,
        )
    return z, float(np.abs(values).max(initial=0.0)), _undetermined(slopes, unknowns)


def solve_many(
    residuals: Callable[[np.ndarray], np.ndarray],
    slopes: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Solve for all but the last column of `z` in each row at once, by Newton's method.

    Parameters
    ----------
    residuals, slopes : callable
        Of z (m, k): shapes (m, r) and (m, r, k).
    z : ndarray, shape (m, k)
        Where to start.

    Returns
    -------
    z : ndarray, shape (m, k)
    sound : ndarray of bool, shape (m,)
        Where the residuals are rounding errors.
    """
    z = z.copy()
    best = residuals(z)
    sizes = np.abs(best).max(axis=1)
    left = np.arange(len(z))
    J = slopes(z)
    for _ in range(_POLISH):
        ready = np.isfinite(J[left]).all(axis=(1, 2)) & np.isfinite(sizes[left])
        left = left[ready & (sizes[left] > 0.0)]
        if not left.size:
            break
        steps = np.linalg.pinv(J[left, :, :-1], rcond=FREE) @ best[left, :, None]
        after = z[left]
        after[:, :-1] -= steps[:, :, 0]
        values = residuals(after)
        better = np.abs(values).max(axis=1) < sizes[left]
        left, after, values = left[better], after[better], values[better]
        if not left.size:
            break
        z[left], best[left], sizes[left] = after, values, np.abs(values).max(axis=1)
        J[left] = slopes(after)
    limit = _ROUNDING * _EPS * _scale(J, z, best)
    with np.errstate(invalid="ignore"):
        return z, (np.abs(best) <= np.maximum(limit, np.finfo(float).tiny)).all(axis=1)


def _scale(J: np.ndarray, z: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the size of the terms that residuals are made of.

    Accelerations come from one linear solve, so that none is more exact than a rounding error of
    the largest, a few times over: a bicycle's wheels at rest are moved by what is left of its
    weight, and a bead at the bottom of a hoop by what the hoop's force leaves.
    """
    terms = _terms(J, z)
    least = terms.max(axis=-1, initial=0.0, keepdims=True) * (_SOLVED / _ROUNDING)
    own = terms + np.abs(values).max(axis=-1, initial=0.0, keepdims=True) * _EPS
    result: np.ndarray = np.maximum(own, least)
    return result


def _terms(J: np.ndarray, z: np.ndarray) -> np.ndarray:
    terms: np.ndarray = (np.abs(J) @ np.maximum(np.abs(z), 1.0)[..., None])[..., 0]
    return terms


def _polished(
    residual: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
) -> np.ndarray:
    """Go on by Newton's method as long as the residual falls."""
    best = residual(z)
    for _ in range(_POLISH):
        slopes = jacobian(z)
        if not (np.isfinite(slopes).all() and np.isfinite(best).all()) or not best.any():
            break
        step = scaled_step(slopes, best, FREE)
        after = np.clip(z - step, low, high)
        values = residual(after)
        if not np.abs(values).max() < np.abs(best).max():
            break
        z, best = after, values
    return z


def _named(names: Sequence[str], values: np.ndarray) -> str:
    parts = [f"{name} = {value:.6g}" for name, value in zip(names, values, strict=True)][:6]
    return ", ".join(parts + (["..."] if len(names) > 6 else []))


def _undetermined(slopes: np.ndarray, unknowns: Sequence[str]) -> tuple[str, ...]:
    """Return the directions in which no equation changes, as sums of unknowns."""
    if not slopes.size:
        return tuple(unknowns)
    free, columns = _free(slopes)
    free = _reduced(free)
    # What takes part is told in units of the columns, and how far it moves in the user's.
    free = np.where(np.abs(free) >= NAMED * np.abs(free).max(axis=1, keepdims=True), free, 0.0)
    return tuple(direction_text(direction, unknowns, 0.0) for direction in free * columns)


def _free(slopes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return orthonormal directions in which no equation changes, in units that come with them."""
    if not slopes.size:
        return np.eye(slopes.shape[1]), np.ones(slopes.shape[1])
    scaled, _, columns = equilibrated(slopes)
    _, singular, right = np.linalg.svd(scaled)
    rank = int((singular > FREE * max(singular.max(initial=0.0), np.finfo(float).tiny)).sum())
    return right[rank:], columns[0]


def _reduced(rows: np.ndarray) -> np.ndarray:
    """Return rows that span the same, each with an entry 1 where the others have 0.

    So unknowns that are free by themselves are named by themselves.
    """
    rows, pivots = rows.copy(), []
    for k in range(len(rows)):
        i, j = np.unravel_index(np.abs(rows[k:]).argmax(), rows[k:].shape)
        rows[[k, k + i]] = rows[[k + i, k]]
        rows[k] /= rows[k, j]
        others = np.arange(len(rows)) != k
        rows[others] -= np.outer(rows[others, j], rows[k])
        pivots.append(int(j))
    return rows[np.argsort(pivots)]
