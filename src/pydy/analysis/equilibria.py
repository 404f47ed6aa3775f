"""States of rest or steady motion: equilibria, relative equilibria, trims.

The unknowns are found by least squares on the derivatives of the states and the residuals of the
constraints, with exact Jacobians: `scipy.optimize.least_squares` finds the neighbourhood, within
bounds, and Newton's method with the pseudo-inverse continues to rounding accuracy. Where that finds
none, the search begins again where the system settles, and then with rows in units of their own.
Nothing depends on the user's units: rows are compared with what the unknowns make of them, and
unknowns with each other by the Jacobian.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy

from pydy._errors import EquilibriumError
from pydy._names import few, numbers_of, place_of, some, unique_names
from pydy._rank import DEPENDENT, DIGITS, HALF, ROUNDED, null_space, or_one, rank_of, unrounded
from pydy.analysis.directions import direction_text
from pydy.analysis.tuning import BENT, NEARLY_STRAIGHT

_POLISH = 20  # steps of Newton's method
_TRIALS = 400  # steps of implicit Euler
_LONGER = 3.0  # than the step before, or shorter

Bounds = tuple[np.ndarray, np.ndarray]  # the lowest and the highest values of unknowns
Found = tuple[np.ndarray, float, tuple[str, ...]]  # what `solve_equilibrium` returns
Function = Callable[[np.ndarray], np.ndarray]

# Nothing moves so slowly: its powers would leave the range of floats.
_SMALLEST = float(np.finfo(float).tiny ** 0.25)


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
        shown = numbers_of(names, self.values.values(), digits=10)
        text = f"Equilibrium at {shown}; largest residual {self.residual:.2g}"
        return text + (f"; free: {few(self.free)}" if self.free else "")

    __repr__ = __str__


@dataclass(frozen=True, eq=False)
class RootProblem:
    """Equations of equilibrium ``residual(z) = 0``, with the sizes of rows and unknowns."""

    residual: Function  # of z (k,): shape (m,)
    jacobian: Function  # of z: shape (m, k)
    unknowns: Sequence[str]
    rows: Sequence[str]
    rates: Mapping[int, int]  # the rows that are rates of an unknown, and its place
    held: int  # how many of the rows, the last ones, are constraints
    sizes: Callable[[np.ndarray, np.ndarray], Sizes]  # of the Jacobian and z
    # of z: the sizes of what constants, specifieds and loads make of the rows
    terms: Function


class Sizes:
    """How large the unknowns and the rows of a Jacobian are, in the units that the user works in.

    An unknown is at least as large as those that are large by themselves, as `natural` says, or
    else as the largest, in units of motions of one energy. The `inertia` says how large the rows
    are for such motions, and by which power of an angular frequency that is to be multiplied: 1 for
    accelerations. For `rates` see `RootProblem`.

    Accelerations come from one linear solve, so that none is more exact than a rounding error of
    the largest, in units of the same energy: a bicycle's wheels at rest are moved by what is left
    of its weight, and a bead at the bottom of a hoop by what the hoop's force leaves.
    """

    def __init__(
        self,
        slopes: np.ndarray,
        z: np.ndarray,
        natural: np.ndarray,
        rates: Mapping[int, int],
        inertia: tuple[np.ndarray, np.ndarray],
    ) -> None:
        rows, powers = inertia
        own, columns = list(rates), list(rates.values())
        units = np.ones(slopes.shape[1])
        units[columns] = or_one(rows[own])
        between = slopes[np.ix_(own, columns)] * units[columns] / units[columns][:, None]
        speed = float(np.abs(np.linalg.eigvals(between)).max(initial=0.0))
        if not speed > _SMALLEST:
            speed = 1.0
        units[columns] *= speed ** (powers[own] - 1.0)
        self.rows = or_one(rows * speed**powers)  # what such motions make of each row
        self._linked = np.where(powers == 1.0, rows, 0.0)
        others = np.setdiff1d(np.arange(len(units)), columns)
        steepest = np.abs(slopes[:, others] / self.rows[:, None]).max(axis=0, initial=0.0)
        units[others] = 1.0 / or_one(steepest)
        acts = (np.abs(slopes) * units).max(axis=0, initial=0.0) > 0.0
        known = np.maximum(np.abs(z), natural)
        shares = (natural if natural[acts].any() else known) / units
        self.units = np.where(acts, units, or_one(known))  # of motions of one energy
        self.unknowns = np.maximum(known, shares[acts].max(initial=0.0) * units)
        self.terms = np.abs(slopes) @ self.unknowns  # what the unknowns make of each row
        self.limit = self.rounding(self.terms)  # what rounding may leave of each row

    def rounding(self, terms: np.ndarray) -> np.ndarray:
        """Return bounds on the rounding errors of rows with such terms."""
        linked = self._linked > 0.0
        largest = (terms[linked] / self._linked[linked]).max(initial=0.0)
        result: np.ndarray = ROUNDED * np.maximum(terms, self._linked * largest)
        return result


def solve_equilibrium(problem: RootProblem, start: np.ndarray, bounds: Bounds) -> Found:
    """Solve a `RootProblem` between the lowest and the highest values of its unknowns.

    Return the solution, its largest residual, and the combinations of unknowns that the equations
    do not determine. Where there is none, raise EquilibriumError.
    """
    z = np.clip(start, *bounds)
    missed: EquilibriumError | None = None
    for attempt in ("near", "settled", "units"):
        begin = z
        with np.errstate(all="ignore"):
            if attempt == "settled":
                begin = settled(problem, z, bounds)
            slopes = problem.jacobian(begin)
            found, message = begin, ""
            if np.isfinite(slopes).all():
                sizes, more = problem.sizes(slopes, begin), np.zeros(1)
                if attempt != "near":
                    sizes, _, more = _beyond_noise(problem, slopes, sizes, begin)
                # Terms at the start mislead where wheels do not turn yet: units do not.
                # A row of rounding errors is no equation: it weighs what the largest row does.
                limit = sizes.rounding(sizes.terms + more)
                noise = sizes.terms <= limit
                terms = or_one(np.where(noise, limit / ROUNDED, sizes.terms))
                rows = sizes.rows if attempt == "units" else terms
                found, message = _search(problem, begin, bounds, rows, sizes.units)
        try:
            accepted = _accepted(problem, found, bounds, message)
        except EquilibriumError as error:
            missed = missed or error
            continue
        return _as_begun(accepted, problem, z, bounds)
    assert missed is not None
    raise missed


def _beyond_noise(
    problem: RootProblem, slopes: np.ndarray, sizes: Sizes, z: np.ndarray
) -> tuple[Sizes, np.ndarray, np.ndarray]:
    """Return sizes and slopes without rows that are rounding errors of loads, and of these terms.

    Where constraints carry all weight, nothing but rounding is left of accelerations.
    """
    more = problem.terms(z)
    noise = sizes.terms <= sizes.rounding(sizes.terms + more)
    slopes = np.where(noise[:, None], 0.0, slopes)
    return problem.sizes(slopes, z), slopes, more


def left_ahead(ahead: RootProblem, z: np.ndarray) -> tuple[str, float, np.ndarray] | None:
    """Return a row that is not zero `ahead`, with its value and all, where coordinates moved on.

    None where the equilibrium is one there, too.
    """
    infinite = np.full(len(z), np.inf)
    try:
        _accepted(ahead, z, (-infinite, infinite), "")
    except EquilibriumError as error:
        values = error.residuals
        k = int(np.argmax(np.where(np.isfinite(values), np.abs(values), -1.0)))
        return ahead.rows[k], float(values[k]), values
    return None


def _as_begun(accepted: Found, problem: RootProblem, start: np.ndarray, bounds: Bounds) -> Found:
    """Return the equilibrium with free states as at the start, if that is an equilibrium too.

    The search moves what no equation tells of as well: a sleigh comes to rest anywhere.
    """
    found = accepted[0]
    slopes = problem.jacobian(found)
    free, columns = null_space(slopes, problem.sizes(slopes, found).units)
    back = free.T @ (free @ ((start - found) / columns)) * columns
    if not np.abs(back).max(initial=0.0) > 0.0:
        return accepted
    with np.errstate(all="ignore"):
        begin = np.clip(found + back, *bounds)
        slopes = problem.jacobian(begin)
        if not np.isfinite(slopes).all():
            return accepted
        sizes = problem.sizes(slopes, begin)
        there = _polished(*_scaled(problem, sizes.rows), begin, bounds, sizes.units)
        try:
            again = _accepted(problem, there, bounds, "")
        except EquilibriumError:
            return accepted
    nearer = np.linalg.norm((there - start) / columns) < np.linalg.norm((found - start) / columns)
    return again if nearer else accepted


def _scaled(problem: RootProblem, rows: np.ndarray) -> tuple[Function, Function]:
    """Return residuals and Jacobian with each row in units of its size."""
    return lambda z: problem.residual(z) / rows, lambda z: problem.jacobian(z) / rows[:, None]


def _search(
    problem: RootProblem, z: np.ndarray, bounds: Bounds, rows: np.ndarray, units: np.ndarray
) -> tuple[np.ndarray, str]:
    """Search with rows and unknowns in the given units; return the result and why it ended."""
    low, high = bounds
    share, slopes = _scaled(problem, rows)
    try:
        found = scipy.optimize.least_squares(
            lambda w: share(w * units), z / units, lambda w: slopes(w * units) * units,
            (low / units, high / units), x_scale="jac",
            xtol=ROUNDED, ftol=ROUNDED, gtol=ROUNDED, max_nfev=200,
        )  # fmt: skip
    except ValueError as error:  # residuals that are not finite at the start
        return z, str(error)
    found_z = np.clip(found.x * units, low, high)
    return _polished(share, slopes, found_z, bounds, units), found.message


def _accepted(problem: RootProblem, z: np.ndarray, bounds: Bounds, message: str) -> Found:
    """Return the result of `solve_equilibrium` if the residuals are rounding errors, else None."""
    low, high = bounds
    values, slopes = problem.residual(z), problem.jacobian(z)
    if not (np.isfinite(values).all() and np.isfinite(slopes).all()):
        raise EquilibriumError(
            "No equilibrium was found: the equations are not finite near "
            f"{numbers_of(problem.unknowns, z)}. Choose initial conditions closer to one.",
            z,
            values,
        )
    sizes = problem.sizes(slopes, z)
    limit = sizes.limit
    if (np.abs(values) > limit).any():
        sizes, slopes, more = _beyond_noise(problem, slopes, sizes, z)
        limit = sizes.rounding(sizes.terms + more)
    off = np.abs(values) > limit
    if off.any():
        order = [k for k in np.argsort(-np.abs(values)) if off[k]][:3]
        left = ", ".join(f"{problem.rows[k]} = {values[k]:.3g}" for k in order)
        at_bounds = [
            name
            for name, value, a, b, size in zip(
                problem.unknowns, z, low, high, sizes.unknowns, strict=True
            )
            if min(value - a, b - value) <= HALF * min(b - a, size)
        ]
        bound = f" At a bound: {some(at_bounds)}." if at_bounds else ""
        why = f" ({' '.join(message.split())})" if message else ""
        raise EquilibriumError(
            f"No equilibrium was found. Nearest, at {numbers_of(problem.unknowns, z)}: "
            f"{left}.{bound} Start closer to an equilibrium, add unknowns, or list coordinates "
            f"that keep moving in `moving`.{why}",
            z,
            values,
        )
    # What is rounding beside its size is nothing: speeds of 1e-31 at rest keep no constraint.
    still = np.clip(np.where(np.abs(z) <= ROUNDED * sizes.unknowns, 0.0, z), low, high)
    if (still != z).any():
        there = problem.residual(still)
        if (np.abs(there) <= np.maximum(limit, np.abs(values))).all():
            z, values = still, there
    free = _undetermined(slopes, sizes.units, problem.unknowns)
    return z, float(np.abs(values).max(initial=0.0)), free


def solve_many(
    residuals: Function,
    slopes: Function,
    z: np.ndarray,
    measured: Callable[[np.ndarray, np.ndarray], list[Sizes]],
) -> tuple[np.ndarray, np.ndarray]:
    """Solve for all but the last column of `z` in each row at once, by Newton's method.

    The residuals of z (m, k) and their slopes have the shapes (m, r) and (m, r, k); sizes are
    `measured` of some of the slopes (n, r, k - 1) and z (n, k). Return also which rows are sound:
    those where the residuals are rounding errors.
    """
    z = z.copy()
    best, J = residuals(z), slopes(z)
    # In units of motions: a row of rounding errors alone is no equation.
    begin = measured(np.where(np.isfinite(J), J, 0.0)[:, :, :-1], z)
    rows, units = np.array([s.rows for s in begin]), np.array([s.units for s in begin])
    sizes = np.abs(best / rows).max(axis=1)
    left = np.arange(len(z))
    for _ in range(_POLISH):
        ready = np.isfinite(J[left]).all(axis=(1, 2)) & np.isfinite(sizes[left])
        left = left[ready & (sizes[left] > 0.0)]
        if not left.size:
            break
        after = z[left]
        scaled = J[left, :, :-1] * units[left][:, None] / rows[left][:, :, None]
        inverse = np.linalg.pinv(scaled, rcond=DEPENDENT)
        after[:, :-1] -= units[left] * (inverse @ (best[left] / rows[left])[:, :, None])[:, :, 0]
        values = residuals(after)
        better = np.abs(values / rows[left]).max(axis=1) < sizes[left]
        left, after, values = left[better], after[better], values[better]
        if not left.size:
            break
        z[left], best[left] = after, values
        sizes[left] = np.abs(values / rows[left]).max(axis=1)
        J[left] = slopes(after)
    sound = np.array(np.isfinite(J).all(axis=(1, 2)) & np.isfinite(best).all(axis=1))
    places = np.flatnonzero(sound)
    found = measured(J[places, :, :-1], z[places]) if places.size else []
    for k, own in zip(places, found, strict=True):
        sound[k] = (np.abs(best[k]) <= own.limit).all()
    return z, sound


def _polished(
    residual: Function, jacobian: Function, z: np.ndarray, bounds: Bounds, units: np.ndarray
) -> np.ndarray:
    """Go on by Newton's method as long as the residual falls."""
    best = residual(z)
    for _ in range(_POLISH):
        slopes = jacobian(z)
        if not (np.isfinite(slopes).all() and np.isfinite(best).all()) or not best.any():
            break
        step = scaled_step(slopes, best, units)
        after = np.clip(z - step, *bounds)
        values = residual(after)
        if not np.abs(values).max() < np.abs(best).max():
            break
        z, best = after, values
    return z


def _undetermined(
    slopes: np.ndarray, units: np.ndarray, unknowns: Sequence[str]
) -> tuple[str, ...]:
    """Return the directions in which no equation changes, as sums of unknowns."""
    if not slopes.size:
        return tuple(unknowns)
    free, columns = null_space(slopes, units)
    free = _reduced(free)
    # What takes part is told in units of the columns, and how far it moves in the user's.
    free = np.where(np.abs(free) >= DIGITS * np.abs(free).max(axis=1, keepdims=True), free, 0.0)
    return tuple(direction_text(direction, unknowns, 0.0) for direction in free * columns)


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


def scaled_step(slopes: np.ndarray, values: np.ndarray, units: np.ndarray) -> np.ndarray:
    """Return the least z with ``slopes @ z = values``, in units of the columns.

    For `units` see `unrounded`. Rows weigh what they do: a row of rounding errors, as next to a
    singular configuration, would otherwise count like the rest.
    """
    columns = 1.0 / or_one(unrounded(np.abs(slopes), units).max(axis=0, initial=0.0))
    step: np.ndarray = columns * np.linalg.lstsq(slopes * columns, values, rcond=DEPENDENT)[0]
    return step


# -- Where a system settles: what it moves to if every swing dies out ------------------------------
#
# Steps of implicit Euler follow the equations of motion; what swings within a step is damped, so
# that steps grow until they are Newton's (pseudo-transient continuation: C. T. Kelley and D. E.
# Keyes, SIAM J. Numer. Anal. 35 (1998) 508-523). Constraints are closed on the way. A step is as
# long as the equations are nearly linear along it. All sizes are ratios of entries of the Jacobian,
# so that the way does not depend on units.


def settled(problem: RootProblem, z: np.ndarray, bounds: Bounds) -> np.ndarray:
    """Return where the unknowns settle, or have come to when this was given up."""
    values, slopes = problem.residual(z), problem.jacobian(z)
    own, columns = list(problem.rates), list(problem.rates.values())
    hard = np.arange(len(values) - problem.held, len(values))
    soft = np.arange(len(values) - problem.held)
    moves = np.zeros_like(slopes)
    moves[own, columns] = 1.0
    fastest, length, share = 0.0, 0.0, 1.0
    for _ in range(_TRIALS):
        if not (np.isfinite(slopes).all() and np.isfinite(values).all()):
            break
        units, speed = _balanced(slopes, own, columns)
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
        found = problem.residual(after)
        bent = np.abs((found - values - slopes @ (after - z)) / sizes).max(initial=0.0)
        moved = np.abs(step).max(initial=0.0)
        if not bent <= BENT * moved:
            length, share = length / _LONGER, share / _LONGER
            continue
        z, values, slopes = after, found, problem.jacobian(after)
        share = min(1.0, _LONGER * share)
        if bent <= NEARLY_STRAIGHT * moved:
            length *= _LONGER
        # Such a step of implicit Euler is one of Newton's method.
        if not moved or length * fastest > 1e4:
            break
    return z


def _balanced(slopes: np.ndarray, own: list[int], columns: list[int]) -> tuple[np.ndarray, float]:
    """Return units of the unknowns in which rates are balanced, and the fastest rate.

    In units of motions of one energy, upright chains were left for places far away.
    """
    units, between = np.ones(slopes.shape[1]), slopes[np.ix_(own, columns)]
    if own:
        with np.errstate(invalid="ignore"):  # in what `separate` is not asked for
            found = scipy.linalg.matrix_balance(between, permute=False, separate=True)
        units[columns] = found[1][0]
    speed = float(or_one(np.abs(np.linalg.eigvals(between)).max(initial=0.0)))
    rows = np.abs(slopes[:, columns] * units[columns]).max(axis=1, initial=0.0)
    rows[own] = units[columns] * speed
    others = np.setdiff1d(np.arange(len(units)), columns)
    shares = slopes[:, others] / np.where(rows > 0.0, rows, np.inf)[:, None]
    units[others] = 1.0 / or_one(np.abs(shares).max(axis=0, initial=0.0))
    return units, speed


def _constrained(rows: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the least step that closes the constraints, and the directions that keep them."""
    if not len(rows):
        return np.zeros(rows.shape[1]), np.eye(rows.shape[1])
    left, singular, right = np.linalg.svd(rows)
    rank = rank_of(singular)
    solved = (left.T @ values)[:rank] / singular[:rank]
    return -right[:rank].T @ solved, right[rank:].T
