"""States of rest or steady motion: equilibria, relative equilibria, trims.

The unknowns minimise the squares of the state derivatives and of the constraint residuals, with
exact Jacobians: `scipy.optimize.least_squares` approaches the solution within bounds, and Newton's
method with the pseudo-inverse continues to rounding accuracy. If this fails, the search is repeated
from the point that pseudo-transient continuation reaches, and then with another scaling of the
rows. Nothing depends on the user's units: rows are scaled by the terms that the unknowns contribute
to them, and unknowns by the Jacobian.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import scipy

from pydy._errors import EquilibriumError
from pydy._names import few, numbers_of, place_of, some, unique_names
from pydy._rank import DEPENDENT, DIGITS, HALF, ROUNDED, null_space, or_one, rank_of, unrounded
from pydy.analysis.directions import direction_text
from pydy.analysis.tuning import LARGEST_NONLINEARITY, SMALL_NONLINEARITY

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName

_POLISH = 20  # largest number of Newton steps
_TRIALS = 400  # largest number of implicit Euler steps
_LONGER = 3.0  # factor by which a step grows or shrinks

Bounds = tuple[np.ndarray, np.ndarray]  # the lowest and the highest values of unknowns
RootResult = tuple[np.ndarray, float, tuple[str, ...]]  # what `solve_equilibrium` returns
Function = Callable[[np.ndarray], np.ndarray]

# Smallest angular frequency: powers of smaller ones leave the range of floats.
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

    values: dict[AnySymbol, float]
    initial_conditions: dict[AnySymbol, float]
    constants: dict[AnySymbol, float]
    specifieds: dict[AnySymbol, float]
    state: np.ndarray
    residual: float
    free: tuple[str, ...] = field(default=())
    given: dict[AnySymbol, float] = field(default_factory=dict)

    def __getitem__(self, unknown: SymbolOrName) -> float:
        """Return the value of an unknown, by symbol or name."""
        values = list(self.values.values())
        return values[place_of(unknown, unique_names(list(self.values)), "unknowns")]

    def __str__(self) -> str:
        names = unique_names(list(self.values))
        assignments = numbers_of(names, self.values.values(), digits=10)
        text = f"Equilibrium at {assignments}; largest residual {self.residual:.2g}"
        return text + (f"; free: {few(self.free)}" if self.free else "")

    __repr__ = __str__


@dataclass(frozen=True, eq=False)
class RootProblem:
    """Equations of equilibrium ``residual(z) = 0``, with the sizes of rows and unknowns."""

    residual: Function  # of z (k,): shape (m,)
    jacobian: Function  # of z: shape (m, k)
    unknowns: Sequence[str]
    rows: Sequence[str]
    rates: Mapping[int, int]  # rows that are rates of an unknown → the unknown's column
    num_constraints: int  # the last rows are constraints
    sizes: Callable[[np.ndarray, np.ndarray], Sizes]  # of the Jacobian and z
    # of z: the sizes of the rows' terms due to constants, specifieds and loads
    terms: Function


class Sizes:
    """Scales of the unknowns and the rows of a Jacobian, in the user's units.

    Unknowns are compared in units of motions of one energy. In these units each unknown is at least
    as large as the `natural` sizes (an angle's is 1), or as the largest unknown if there are none.
    `inertia` contains the rows' sizes for such motions and the power of the angular frequency by
    which to multiply them: 1 for accelerations. For `rates` see `RootProblem`.

    All accelerations come from one linear solve. None is more accurate than the rounding error of
    the largest, in units of the same energy: the wheels of a bicycle at rest have accelerations
    that are rounding errors of its weight.
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
        rate_rows, columns = list(rates), list(rates.values())
        units = np.ones(slopes.shape[1])
        units[columns] = or_one(rows[rate_rows])
        rate_jacobian = (
            slopes[np.ix_(rate_rows, columns)] * units[columns] / units[columns][:, None]
        )
        speed = float(np.abs(np.linalg.eigvals(rate_jacobian)).max(initial=0.0))
        if not speed > _SMALLEST:
            speed = 1.0
        units[columns] *= speed ** (powers[rate_rows] - 1.0)
        self.rows = or_one(rows * speed**powers)  # of each row, for such motions
        self._linked = np.where(powers == 1.0, rows, 0.0)
        other_columns = np.setdiff1d(np.arange(len(units)), columns)
        steepest = np.abs(slopes[:, other_columns] / self.rows[:, None]).max(axis=0, initial=0.0)
        units[other_columns] = 1.0 / or_one(steepest)
        active = (np.abs(slopes) * units).max(axis=0, initial=0.0) > 0.0
        magnitudes = np.maximum(np.abs(z), natural)
        shares = (natural if natural[active].any() else magnitudes) / units
        self.units = np.where(active, units, or_one(magnitudes))  # for motions of one energy
        self.unknowns = np.maximum(magnitudes, shares[active].max(initial=0.0) * units)
        self.terms = np.abs(slopes) @ self.unknowns  # the unknowns' contributions to each row
        self.limit = self.rounding(self.terms)  # rounding error of each row

    def rounding(self, terms: np.ndarray) -> np.ndarray:
        """Return bounds on the rounding errors of rows with such terms."""
        linked = self._linked > 0.0
        largest = (terms[linked] / self._linked[linked]).max(initial=0.0)
        result: np.ndarray = ROUNDED * np.maximum(terms, self._linked * largest)
        return result


def solve_equilibrium(problem: RootProblem, start: np.ndarray, bounds: Bounds) -> RootResult:
    """Solve a `RootProblem` within bounds on its unknowns.

    Return the solution, its largest residual, and the combinations of unknowns that the equations
    do not determine. Raise EquilibriumError if there is none.
    """
    z = np.clip(start, *bounds)
    # What settles first may end many turns away, at a place that rounding errors decide about.
    first_error: EquilibriumError | None = None
    for attempt in ("near", "units", "settled"):
        begin = z
        with np.errstate(all="ignore"):
            if attempt == "settled":
                begin = pseudo_transient(problem, z, bounds)
            slopes = problem.jacobian(begin)
            solution, message = begin, ""
            if np.isfinite(slopes).all():
                sizes, load_terms = problem.sizes(slopes, begin), np.zeros(1)
                if attempt != "near":
                    sizes, _, load_terms = _without_noise_rows(problem, slopes, sizes, begin)
                # Terms at the start are a misleading scale if, for example, wheels are still at
                # rest there; sizes for motions of one energy are not.
                # A row of rounding errors is no equation: it is scaled like the largest row.
                limit = sizes.rounding(sizes.terms + load_terms)
                noise = sizes.terms <= limit
                terms = or_one(np.where(noise, limit / ROUNDED, sizes.terms))
                rows = sizes.rows if attempt == "units" else terms
                solution, message = _search(problem, begin, bounds, rows, sizes.units)
        try:
            accepted = _checked_solution(problem, solution, bounds, message)
        except EquilibriumError as error:
            first_error = first_error or error
            continue
        accepted = _with_initial_free_unknowns(accepted, problem, z, bounds)
        return _unwound(accepted, problem, z, bounds)
    assert first_error is not None
    raise first_error


def _without_noise_rows(
    problem: RootProblem, slopes: np.ndarray, sizes: Sizes, z: np.ndarray
) -> tuple[Sizes, np.ndarray, np.ndarray]:
    """Return sizes and slopes without rows that are rounding errors of loads, and the load terms.

    If constraints carry the full weight, accelerations are nothing but rounding errors.
    """
    load_terms = problem.terms(z)
    noise = sizes.terms <= sizes.rounding(sizes.terms + load_terms)
    slopes = np.where(noise[:, None], 0.0, slopes)
    return problem.sizes(slopes, z), slopes, load_terms


def nonzero_row(ahead: RootProblem, z: np.ndarray) -> tuple[str, float, np.ndarray] | None:
    """Return the largest nonzero row of another problem at an equilibrium z, or None.

    The problem is the same one with advanced coordinates or at another time. The result is the
    row's name, its value, and all values; None if z is an equilibrium there, too.
    """
    infinite = np.full(len(z), np.inf)
    try:
        _checked_solution(ahead, z, (-infinite, infinite), "")
    except EquilibriumError as error:
        values = error.residuals
        k = int(np.argmax(np.where(np.isfinite(values), np.abs(values), -1.0)))
        return ahead.rows[k], float(values[k]), values
    return None


def largest_departure(problem: RootProblem, z: np.ndarray) -> tuple[str, float] | None:
    """Return the rate that is farthest from zero at z, or None where all are nearly zero.

    Nearly zero are residuals of unknowns that were typed to six digits, and rounding errors.
    """
    values, slopes = problem.residual(z), problem.jacobian(z)
    if not (np.isfinite(values).all() and np.isfinite(slopes).all()):
        return None
    sizes, _, load_terms = _without_noise_rows(problem, slopes, problem.sizes(slopes, z), z)
    limit = sizes.rounding(sizes.terms + load_terms)
    count = len(values) - problem.num_constraints
    shares = np.abs(values) / or_one(limit) * (np.abs(values) > limit)
    k = int(shares[:count].argmax())
    return (problem.rows[k], float(values[k])) if shares[k] > DIGITS / ROUNDED else None


def _with_initial_free_unknowns(
    accepted: RootResult, problem: RootProblem, start: np.ndarray, bounds: Bounds
) -> RootResult:
    """Return the equilibrium with free unknowns as at the start, if that is one, too.

    The search also moves unknowns that no equation determines: a sleigh can be at rest anywhere.
    """
    solution = accepted[0]
    slopes = problem.jacobian(solution)
    free, units = null_space(slopes, problem.sizes(slopes, solution).units)
    back = free.T @ (free @ ((start - solution) / units)) * units
    if not np.abs(back).max(initial=0.0) > 0.0:
        return accepted
    with np.errstate(all="ignore"):
        begin = np.clip(solution + back, *bounds)
        slopes = problem.jacobian(begin)
        if not np.isfinite(slopes).all():
            return accepted
        sizes = problem.sizes(slopes, begin)
        polished = _newton(*_scaled(problem, sizes.rows), begin, bounds, sizes.units)
        try:
            candidate = _checked_solution(problem, polished, bounds, "")
        except EquilibriumError:
            return accepted
    nearer = np.linalg.norm((polished - start) / units) < np.linalg.norm((solution - start) / units)
    return candidate if nearer else accepted


def _unwound(
    accepted: RootResult, problem: RootProblem, start: np.ndarray, bounds: Bounds
) -> RootResult:
    """Return the equilibrium with angles within half a revolution of the start.

    Steps of a search are long where bodies are in line. An unknown counts as an angle if the
    equations hold as before without its revolutions.
    """
    turns = np.round((accepted[0] - start) / (2.0 * np.pi))
    for k in np.flatnonzero(turns):
        back = accepted[0].copy()
        back[k] -= 2.0 * np.pi * turns[k]
        with suppress(EquilibriumError):
            accepted = _checked_solution(problem, np.clip(back, *bounds), bounds, "")
    return accepted


def _scaled(problem: RootProblem, rows: np.ndarray) -> tuple[Function, Function]:
    """Return residual and Jacobian functions with each row divided by its size."""
    return lambda z: problem.residual(z) / rows, lambda z: problem.jacobian(z) / rows[:, None]


def _search(
    problem: RootProblem, z: np.ndarray, bounds: Bounds, rows: np.ndarray, units: np.ndarray
) -> tuple[np.ndarray, str]:
    """Minimise the scaled residuals; return the unknowns and the reason for the end."""
    low, high = bounds
    share, slopes = _scaled(problem, rows)
    try:
        result = scipy.optimize.least_squares(
            lambda w: share(w * units), z / units, lambda w: slopes(w * units) * units,
            (low / units, high / units), x_scale="jac",
            xtol=ROUNDED, ftol=ROUNDED, gtol=ROUNDED, max_nfev=200,
        )  # fmt: skip
    except ValueError as error:  # residuals that are not finite at the start
        return z, str(error)
    solution = np.clip(result.x * units, low, high)
    return _newton(share, slopes, solution, bounds, units), result.message


def _checked_solution(
    problem: RootProblem, z: np.ndarray, bounds: Bounds, message: str
) -> RootResult:
    """Return the result of `solve_equilibrium`; raise unless the residuals are rounding errors."""
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
        sizes, slopes, load_terms = _without_noise_rows(problem, slopes, sizes, z)
        limit = sizes.rounding(sizes.terms + load_terms)
    off = np.abs(values) > limit
    if off.any():
        order = [k for k in np.argsort(-np.abs(values)) if off[k]][:3]
        residuals = ", ".join(f"{problem.rows[k]} = {values[k]:.3g}" for k in order)
        at_bounds = [
            name
            for name, value, a, b, size in zip(
                problem.unknowns, z, low, high, sizes.unknowns, strict=True
            )
            if min(value - a, b - value) <= HALF * min(b - a, size)
        ]
        bound = f" At a bound: {some(at_bounds)}." if at_bounds else ""
        reason = f" ({' '.join(message.split())})" if message else ""
        raise EquilibriumError(
            f"No equilibrium was found. Nearest, at {numbers_of(problem.unknowns, z)}: "
            f"{residuals}.{bound} Start closer to an equilibrium, add unknowns, or list "
            f"coordinates that keep moving in `moving`.{reason}",
            z,
            values,
        )
    # Set unknowns that are rounding errors to zero: speeds of 1e-31 would violate constraints.
    cleaned = np.clip(np.where(np.abs(z) <= ROUNDED * sizes.unknowns, 0.0, z), low, high)
    if (cleaned != z).any():
        cleaned_values = problem.residual(cleaned)
        if (np.abs(cleaned_values) <= np.maximum(limit, np.abs(values))).all():
            z, values = cleaned, cleaned_values
    free = _undetermined(slopes, sizes.units, problem.unknowns)
    return z, float(np.abs(values).max(initial=0.0)), free


def solve_many(
    residuals: Function,
    slopes: Function,
    z: np.ndarray,
    measured: Callable[[np.ndarray, np.ndarray], list[Sizes]],
) -> tuple[np.ndarray, np.ndarray]:
    """Solve for all but the last column of `z` in all rows at once, by Newton's method.

    The residuals of z (m, k) and their slopes have the shapes (m, r) and (m, r, k). `measured`
    returns the sizes for some of the slopes (n, r, k - 1) and z (n, k). Return the solutions and
    whether each row converged: its residuals are rounding errors.
    """
    z = z.copy()
    best, J = residuals(z), slopes(z)
    # Scale by motions of one energy: a row of rounding errors alone is no equation.
    begin = measured(np.where(np.isfinite(J), J, 0.0)[:, :, :-1], z)
    rows, units = np.array([s.rows for s in begin]), np.array([s.units for s in begin])
    sizes = np.abs(best / rows).max(axis=1)
    active = np.arange(len(z))
    for _ in range(_POLISH):
        ready = np.isfinite(J[active]).all(axis=(1, 2)) & np.isfinite(sizes[active])
        active = active[ready & (sizes[active] > 0.0)]
        if not active.size:
            break
        after = z[active]
        scaled = J[active, :, :-1] * units[active][:, None] / rows[active][:, :, None]
        inverse = np.linalg.pinv(scaled, rcond=DEPENDENT)
        after[:, :-1] -= (
            units[active] * (inverse @ (best[active] / rows[active])[:, :, None])[:, :, 0]
        )
        values = residuals(after)
        better = np.abs(values / rows[active]).max(axis=1) < sizes[active]
        active, after, values = active[better], after[better], values[better]
        if not active.size:
            break
        z[active], best[active] = after, values
        sizes[active] = np.abs(values / rows[active]).max(axis=1)
        J[active] = slopes(after)
    sound = np.array(np.isfinite(J).all(axis=(1, 2)) & np.isfinite(best).all(axis=1))
    indices = np.flatnonzero(sound)
    final_sizes = measured(J[indices, :, :-1], z[indices]) if indices.size else []
    for k, size in zip(indices, final_sizes, strict=True):
        sound[k] = (np.abs(best[k]) <= size.limit).all()
    return z, sound


def _newton(
    residual: Function, jacobian: Function, z: np.ndarray, bounds: Bounds, units: np.ndarray
) -> np.ndarray:
    """Apply Newton's method as long as the residual decreases."""
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
    """Return the null space of the equations as text: sums of unknowns."""
    if not slopes.size:
        return tuple(unknowns)
    free, column_units = null_space(slopes, units)
    free = _row_echelon(free)
    # Small shares are dropped in units of the columns; the text is in the user's units.
    free = np.where(np.abs(free) >= DIGITS * np.abs(free).max(axis=1, keepdims=True), free, 0.0)
    return tuple(direction_text(direction, unknowns, 0.0) for direction in free * column_units)


def _row_echelon(rows: np.ndarray) -> np.ndarray:
    """Return the reduced row echelon form: each row has an entry 1 where the others have 0.

    An unknown that is free by itself is then named by itself.
    """
    rows, pivots = rows.copy(), []
    for k in range(len(rows)):
        i, j = np.unravel_index(np.abs(rows[k:]).argmax(), rows[k:].shape)
        rows[[k, k + i]] = rows[[k + i, k]]
        rows[k] /= rows[k, j]
        other_rows = np.arange(len(rows)) != k
        rows[other_rows] -= np.outer(rows[other_rows, j], rows[k])
        pivots.append(int(j))
    return rows[np.argsort(pivots)]


def scaled_step(slopes: np.ndarray, values: np.ndarray, units: np.ndarray) -> np.ndarray:
    """Return the minimum-norm z with ``slopes @ z = values``, in units of the columns.

    For `units` see `unrounded`. Rows are not rescaled: a row of rounding errors, as next to a
    singular configuration, would otherwise count like the others.
    """
    columns = 1.0 / or_one(unrounded(np.abs(slopes), units).max(axis=0, initial=0.0))
    step: np.ndarray = columns * np.linalg.lstsq(slopes * columns, values, rcond=DEPENDENT)[0]
    return step


# -- Pseudo-transient continuation -----------------------------------------------------------------
#
# Implicit Euler steps follow the equations of motion and damp all oscillations that are faster than
# a step. Steps grow until they are Newton steps (C. T. Kelley and D. E. Keyes, "Convergence
# analysis of pseudo-transient continuation", SIAM J. Numer. Anal. 35 (1998) 508-523). Constraint
# residuals are reduced in each step. A step is as long as the equations are nearly linear along it.
# All sizes are ratios of entries of the Jacobian, so that the path does not depend on units.


def pseudo_transient(problem: RootProblem, z: np.ndarray, bounds: Bounds) -> np.ndarray:
    """Return the unknowns at the end of pseudo-transient continuation, converged or not."""
    values, slopes = problem.residual(z), problem.jacobian(z)
    rate_rows, columns = list(problem.rates), list(problem.rates.values())
    hard = np.arange(len(values) - problem.num_constraints, len(values))
    soft = np.arange(len(values) - problem.num_constraints)
    rate_matrix = np.zeros_like(slopes)
    rate_matrix[rate_rows, columns] = 1.0
    fastest, length, share = 0.0, 0.0, 1.0
    for _ in range(_TRIALS):
        if not (np.isfinite(slopes).all() and np.isfinite(values).all()):
            break
        units, speed = _balanced_units(slopes, rate_rows, columns)
        if not length:
            fastest, length = speed, 1.0 / speed
        scaled = slopes * units
        sizes = or_one(np.abs(scaled).max(axis=1, initial=0.0))
        sizes[rate_rows] = units[columns] / length
        closing, tangent = _constraint_step(
            scaled[hard] / sizes[hard, None], values[hard] / sizes[hard]
        )
        step = share * closing
        euler_matrix = (rate_matrix * units / length - scaled)[soft] / sizes[soft, None]
        right = values[soft] / sizes[soft] - euler_matrix @ step
        step = step + tangent @ np.linalg.lstsq(euler_matrix @ tangent, right, rcond=None)[0]
        after = np.clip(z + units * step, *bounds)
        next_values = problem.residual(after)
        nonlinearity = np.abs((next_values - values - slopes @ (after - z)) / sizes).max(
            initial=0.0
        )
        step_size = np.abs(step).max(initial=0.0)
        if not nonlinearity <= LARGEST_NONLINEARITY * step_size:
            length, share = length / _LONGER, share / _LONGER
            continue
        z, values, slopes = after, next_values, problem.jacobian(after)
        share = min(1.0, _LONGER * share)
        if nonlinearity <= SMALL_NONLINEARITY * step_size:
            length *= _LONGER
        # Such a long implicit Euler step is a Newton step.
        if not step_size or length * fastest > 1e4:
            break
    return z


def _balanced_units(
    slopes: np.ndarray, rate_rows: list[int], columns: list[int]
) -> tuple[np.ndarray, float]:
    """Return units of the unknowns in which the rates' Jacobian is balanced, and the fastest rate.

    In units of motions of one energy instead, searches from upright chains went far away.
    """
    units, rate_jacobian = np.ones(slopes.shape[1]), slopes[np.ix_(rate_rows, columns)]
    if rate_rows:
        with np.errstate(invalid="ignore"):  # in a result that `separate` discards
            balance = scipy.linalg.matrix_balance(rate_jacobian, permute=False, separate=True)
        units[columns] = balance[1][0]
    speed = float(or_one(np.abs(np.linalg.eigvals(rate_jacobian)).max(initial=0.0)))
    rows = np.abs(slopes[:, columns] * units[columns]).max(axis=1, initial=0.0)
    rows[rate_rows] = units[columns] * speed
    other_columns = np.setdiff1d(np.arange(len(units)), columns)
    shares = slopes[:, other_columns] / np.where(rows > 0.0, rows, np.inf)[:, None]
    units[other_columns] = 1.0 / or_one(np.abs(shares).max(axis=0, initial=0.0))
    return units, speed


def _constraint_step(rows: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the minimum-norm step onto the constraints, and a basis of their null space."""
    if not len(rows):
        return np.zeros(rows.shape[1]), np.eye(rows.shape[1])
    u, singular, vt = np.linalg.svd(rows)
    rank = rank_of(singular)
    coefficients = (u.T @ values)[:rank] / singular[:rank]
    return -vt[:rank].T @ coefficients, vt[rank:].T
