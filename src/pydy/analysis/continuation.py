"""Branches of equilibria along a parameter, around folds, by pseudo-arclength continuation.

The unknowns z, parameter included, are followed along F(z) = 0: a step along the tangent, and
Newton's method in the plane normal to it (H. B. Keller, "Numerical solution of bifurcation and
nonlinear eigenvalue problems", 1977). The parameter may turn back at a fold. At a branch point the
determinant of F' with the tangent below it changes its sign (Allgower & Georg, Introduction to
Numerical Continuation Methods, §8.1); at a Hopf point a conjugate pair of eigenvalues crosses the
imaginary axis.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._axes import axes_of, typeset, units_by_name, with_unit
from pydy._forks import cached_property
from pydy._names import name_of, place_of
from pydy._optional import require
from pydy._rank import DEPENDENT, HALF, ROUNDED, or_one, rank_of, unrounded
from pydy.analysis.equilibria import Sizes
from pydy.analysis.tuning import (
    BRANCH_TOLERANCE,
    UNLIMITED_CURVATURE_STEP,
    ZERO_EIGENVALUE_FACTOR,
    ZERO_REAL_PART,
)

if TYPE_CHECKING:
    from xarray import Dataset

    from pydy._axes import Units
    from pydy._sympy_types import SymbolOrName

Function = Callable[[np.ndarray], np.ndarray]
Spectrum = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]
Measured = Callable[[np.ndarray, np.ndarray], Sizes]
Functions = tuple[Function, Function, Spectrum, Measured]  # F, its Jacobian, spectrum, sizes

# Number and size (in eps) of the perturbations that estimate the rounding errors of residuals.
_ROUNDINGS, _LAST_DIGITS = 4, 4.0

# Distance from a fold, in scaled unknowns, at which its direction is told from free ones: its slope
# grows with the distance, far above rounding, and what the curve bends with the square.
_BESIDE = 1e-3


@dataclass(frozen=True)
class SpecialPoint:
    """A fold, a branch point or a Hopf point on a branch of equilibria.

    Attributes
    ----------
    kind : {'fold', 'branch point', 'Hopf'}
        Where the parameter turns back, another branch crosses, or an oscillation begins.
    value : float
        Of the parameter.
    values : dict
        The unknowns, by name.
    frequency : float
        Frequency of the oscillation in rad/s; 0 for other kinds.
    place : int
        The point lies between points `place` and `place` + 1 of the branch.
    """

    kind: str
    value: float
    values: dict[str, float]
    frequency: float
    place: int


@dataclass(frozen=True, eq=False)
class EquilibriumBranch:
    """Equilibria along a parameter.

    Attributes
    ----------
    parameter : str
    values : ndarray, shape (m,)
        Values of the parameter; they turn back at folds.
    unknowns : tuple of str
    solutions : ndarray, shape (m, k)
        The unknowns.
    states : ndarray, shape (m, n)
        All states.
    stable : ndarray of bool, shape (m,)
        Whether no eigenvalue of the linear model has a positive real part.
    special : tuple of SpecialPoint
        In the order along the branch.
    ended : str
        Why the branch ends: ``'bounds'``, ``'steps'``, ``'closed'``, ``'lost'`` or
        ``'interrupted'``.
    """

    parameter: str
    values: np.ndarray
    unknowns: tuple[str, ...]
    solutions: np.ndarray
    states: np.ndarray
    stable: np.ndarray
    special: tuple[SpecialPoint, ...]
    ended: str

    def __str__(self) -> str:
        special = ", ".join(f"{p.kind} at {p.value:.6g}" for p in self.special) or "nothing special"
        return (
            f"{len(self.values)} equilibria, {self.parameter} from {self.values[0]:.6g} to "
            f"{self.values[-1]:.6g}: {special}{'; lost there' if self.ended == 'lost' else ''}"
        )

    __repr__ = __str__

    def __getitem__(self, unknown: SymbolOrName) -> np.ndarray:
        """Return an unknown, or the parameter, along the branch, by symbol or name."""
        if name_of(unknown) == self.parameter:
            return self.values
        return self.solutions[:, place_of(unknown, self.unknowns, "unknowns")]

    def to_xarray(self) -> Dataset:
        """Return an `xarray.Dataset` with the parameter and all unknowns by `point`."""
        xarray = require("xarray", "ensemble", "to_xarray()")
        columns = {self.parameter: self.values, "stable": self.stable}
        columns |= {name: self[name] for name in self.unknowns}
        dataset: Dataset = xarray.Dataset(
            {name: (("point",), column) for name, column in columns.items()}
        )
        return dataset

    def plot(self, name: SymbolOrName, ax: Any = None, *, units: Units = None) -> Any:
        """Plot an unknown over the parameter, dashed where unstable; return the Axes.

        Parameters
        ----------
        name : symbol or str
            The unknown.
        ax : matplotlib Axes, optional
        units : mapping of symbols or str to str or (str, float), optional
            Units of the unknown and of the parameter, as for `pydy.plot.plot_coordinates`.
        """
        name = self.unknowns[place_of(name, self.unknowns, "unknowns")]
        by_name = units_by_name(units, self.unknowns)
        unit, factor = by_name.get(name, ("", 1.0))
        parameter_unit, parameter_factor = by_name.get(self.parameter, ("", 1.0))
        values, solution = parameter_factor * self.values, factor * self[name]
        ax, stable, start = axes_of(ax, "a plot"), self.stable, 0
        m = len(values)
        for k in range(1, m + 1):
            if k == m or stable[k] != stable[start]:
                run = slice(start, min(k + 1, m))
                style = "-" if stable[start] else "--"
                ax.plot(values[run], solution[run], color="C0", linestyle=style)
                start = k
        labels: dict[tuple[float, float], list[str]] = {}
        near = HALF * np.array([np.ptp(values), np.ptp(solution)])
        for p in self.special:  # a fold may be a branch point, too: one label says both
            at = parameter_factor * p.value, factor * p.values[name]
            drawn = (d for d in labels if (np.abs(np.subtract(d, at)) <= near).all())
            labels.setdefault(next(drawn, at), []).append(p.kind)
        for at, kinds in labels.items():
            label = ", ".join(dict.fromkeys(kinds))
            ax.plot(*at, "o", color="C3", markersize=4)
            ax.annotate(label, at, textcoords="offset points", xytext=(4, 4), fontsize="small")
        ax.set_xlabel(with_unit(typeset(self.parameter, ""), parameter_unit))
        ax.set_ylabel(with_unit(typeset(name, ""), unit))
        return ax


@dataclass(frozen=True, eq=False)
class _BranchPoint:
    z: np.ndarray
    tangent: np.ndarray
    sign: float  # of the determinant
    spectrum: np.ndarray
    rounding: np.ndarray  # of the spectrum

    def zero(self, most: float) -> np.ndarray:
        """Largest parts of each eigenvalue that count as zero, limited to `most`."""
        return np.minimum(most, ZERO_EIGENVALUE_FACTOR * self.rounding)

    def pairs(self, zero: np.ndarray, above: np.ndarray) -> np.ndarray:
        """The upper ones of the conjugate pairs with a real part above a level."""
        return self.spectrum[(self.spectrum.imag > zero) & (self.spectrum.real > above)]


class _BranchCurve:
    """The curve F(z) = 0 through z, scaled in equations and unknowns, with free states fixed.

    The parameter is the last unknown; `span` is the length of its range. `spectrum` returns the
    eigenvalues at z and bounds on their rounding errors. `measured` returns the sizes for slopes by
    the unknowns without the parameter, and z with it.
    """

    def __init__(
        self,
        functions: Functions,
        z: np.ndarray,
        span: float,
        names: tuple[str, ...],
        known_free: np.ndarray | None = None,
    ):
        self.functions, self.span, self.names = functions, span, names
        self._F, self._J, self.spectrum, measured = functions
        first = self._J(z)
        # Rows that follow from the others, as accelerations do from constraints, have slopes that
        # are rounding errors. Such a row is scaled like the largest.
        sizes = measured(first[:, :-1], z)
        noise = sizes.terms + np.abs(first[:, -1]) * span <= sizes.limit
        self._least = np.where(noise, sizes.limit / ROUNDED, 0.0)
        units = np.append(sizes.units, span)
        self.scale = sizes_along(np.where(noise[:, None], 0.0, first), z, units)
        self.scale[:-1] *= self._above_rounding(first, z)[:-1]
        self.sizes = self._rows(first)
        self.origin = z
        free, symmetries = self._free_at(z)
        # The slope by the parameter adds to the rank at a fold alone, where the curve itself leaves
        # along a free direction. That direction is not fixed.
        if len(free) > symmetries and known_free is not None:
            free = np.linalg.qr((known_free / self.scale[:-1]).T)[0].T
        elif len(free) > symmetries:
            free = self._free_beside(free, symmetries)
        self.free_directions = free
        u = np.linalg.svd(self._jacobian_with_free_rows(z), full_matrices=False)[0]
        self.rows = u[:, : len(z) - 1].T

    def scaled_anew(self, point: _BranchPoint) -> tuple[_BranchCurve, _BranchPoint]:
        """Return the curve with the sizes of one of its points, and the point on it."""
        known = self.free_directions * self.scale[:-1]
        curve = _BranchCurve(self.functions, point.z, self.span, self.names, known)
        return curve, curve.point(point.z, point.tangent * self.scale / curve.scale)

    def _free_at(self, z: np.ndarray) -> tuple[np.ndarray, int]:
        """Return the directions (k, n − 1) that the slopes leave free, and how many beside a fold.

        At a fold there is one more.
        """
        slopes = self.J(z) * self.scale
        _, singular, vt = np.linalg.svd(slopes[:, :-1])
        least = len(z) - 1 - rank_of(np.linalg.svd(slopes, compute_uv=False))
        return vt[rank_of(singular) :], least

    def _free_beside(self, free: np.ndarray, count: int) -> np.ndarray:
        """Return the directions that stay free beside a fold, of those that are free at it.

        First derivatives at the fold do not tell them from the direction of the curve. The
        solutions near it form a surface with the free directions as coordinates.
        """
        if count <= 0:
            return free[:0]
        rows = np.hstack([free, np.zeros((len(free), 1))])
        for direction in free:
            z = self.origin.copy()
            z[:-1] += _BESIDE * self.scale[:-1] * direction
            for _ in range(8):
                slopes = np.vstack([self.J(z) * self.scale, rows])
                offset = ((z - self.origin) / self.scale)[:-1] - _BESIDE * direction
                values = np.append(self.F(z), free @ offset)
                if not (np.isfinite(slopes).all() and np.isfinite(values).all()):
                    break
                z = z - self.scale * np.linalg.lstsq(slopes, values, rcond=None)[0]
            else:
                beside, _ = self._free_at(z)
                if len(beside) == count:
                    return beside
        raise ValueError(
            f"The branch starts at a fold at {self.names[-1]} = {self.origin[-1]:.6g} in which "
            f"{count + 1} unknowns are free, and which of them the branch follows is not "
            f"determined. Start at another value of {self.names[-1]}, or name as `unknowns` only "
            "those that the equations determine."
        )

    def is_at(self, point: _BranchPoint, z: np.ndarray, scale: np.ndarray) -> bool:
        """Return whether the curve near a point passes through z, in units of a scale."""
        arc = point.tangent @ ((z - point.z) / self.scale)
        correction = self.correct(point.z + arc * self.scale * point.tangent, point.tangent)
        if correction is None:
            return False
        allowed = HALF * max(1.0, (self.scale / scale).max())  # the accuracy is that of this scale
        return bool(np.abs((correction[0] - z) / scale).max() <= allowed)

    def outgrown(self, z: np.ndarray) -> bool:
        """Return whether an unknown is more than twice its size, so that steps became short."""
        return bool((np.abs(z[:-1]) > 2.0 * self.scale[:-1]).any())

    def _rows(self, slopes: np.ndarray) -> np.ndarray:
        """Return the sizes of rows with such slopes."""
        sizes = np.abs(slopes * self.scale).max(axis=1, initial=0.0)
        return or_one(np.maximum(sizes, self._least))

    def _above_rounding(self, slopes: np.ndarray, z: np.ndarray) -> np.ndarray:
        """Return factors that enlarge the scale until rounding errors are no Newton steps.

        The slopes do not determine the size of unknowns that the parameter does not change, such as
        those of a symmetry. The rounding errors are the nonlinear changes of the residuals when the
        unknowns change in their last digits.
        """
        signs = np.random.default_rng(0).choice([-1.0, 1.0], size=(_ROUNDINGS, len(z)))
        perturbed = z * (1.0 + _LAST_DIGITS * np.finfo(float).eps * signs)
        errors = [self._F(at) - self._F(z) - slopes @ (at - z) for at in perturbed]
        rounding = np.abs(errors).max(axis=0)
        sizes = self._rows(slopes)
        inverse = np.linalg.pinv(slopes * self.scale / sizes[:, None], rcond=DEPENDENT)
        steps = np.abs(inverse) @ (rounding / sizes)
        return np.where(steps > 0.1 * BRANCH_TOLERANCE, 100.0 * steps / BRANCH_TOLERANCE, 1.0)

    def F(self, z: np.ndarray) -> np.ndarray:
        residuals: np.ndarray = self._F(z) / self.sizes
        return residuals

    def J(self, z: np.ndarray) -> np.ndarray:
        slopes: np.ndarray = self._J(z) / self.sizes[:, None]
        return slopes

    def _jacobian_with_free_rows(self, z: np.ndarray) -> np.ndarray:
        scaled = self.J(z) * self.scale
        free_rows = np.hstack([self.free_directions, np.zeros((len(self.free_directions), 1))])
        return np.vstack([scaled, free_rows])

    def residual(self, z: np.ndarray) -> np.ndarray:
        offset = ((z - self.origin) / self.scale)[:-1]
        return np.concatenate([self.F(z), self.free_directions @ offset])

    def correct(self, z: np.ndarray, tangent: np.ndarray) -> tuple[np.ndarray, int] | None:
        """Return the curve's point in the plane through `z` normal to the tangent, and the count.

        The count is that of the Newton steps before the last one. None if they do not converge.
        """
        anchor = z
        for count in range(8):
            slopes = np.vstack([self._jacobian_with_free_rows(z), tangent])
            values = np.append(self.residual(z), tangent @ ((z - anchor) / self.scale))
            if not (np.isfinite(slopes).all() and np.isfinite(values).all()):
                return None
            step = np.linalg.lstsq(slopes, values, rcond=None)[0]
            z = z - self.scale * step
            if np.abs(step).max() <= BRANCH_TOLERANCE:
                # Contradictory rows have a least-squares solution, too, but it satisfies none.
                row_sizes = np.maximum(1.0, np.abs(slopes[:-1]).max(axis=1, initial=0.0))
                solved = (np.abs(self.residual(z)) <= BRANCH_TOLERANCE * row_sizes).all()
                return (z, count) if solved else None
        return None

    def step_along(self, a: _BranchPoint, arc: float) -> _BranchPoint | None:
        """Return the corrected point at an arc length along the tangent of another."""
        correction = self.correct(a.z + arc * self.scale * a.tangent, a.tangent)
        return None if correction is None else self.point(correction[0], a.tangent)

    @cached_property
    def limit(self) -> float:
        """Largest real part of an eigenvalue that counts as zero."""
        return ZERO_REAL_PART * float(np.abs(self.spectrum(self.origin)[0]).max(initial=0.0))

    def point(self, z: np.ndarray, before: np.ndarray) -> _BranchPoint:
        jacobian = self._jacobian_with_free_rows(z)
        square = self.rows @ jacobian
        tangent = np.linalg.svd(square)[2][-1]
        tangent = tangent if tangent @ before >= 0.0 else -tangent
        sign = float(np.linalg.slogdet(np.vstack([square, tangent]))[0])
        return _BranchPoint(z, tangent, sign, *self.spectrum(z))


def trace(
    functions: Functions,
    names: tuple[str, ...],
    start: np.ndarray,
    ends: tuple[float, float],
    step: float,
    most: int,
    report: Callable[[float], None],
) -> tuple[np.ndarray, np.ndarray, list[SpecialPoint], str, BaseException | None]:
    """Follow F(z) = 0 from a solution.

    Return the points, their stability, the special points, why the branch ended, and the exception
    if Ctrl-C or a lack of memory stopped it.

    The parameter stays between the `ends` and moves towards the second one first. `step` is the
    largest arc length as a share of their distance, `most` the largest number of points. `report`
    is called with the parameter at each new point.
    """
    bounds = min(ends), max(ends)
    curve = _BranchCurve(functions, start, bounds[1] - bounds[0], names)
    towards = np.zeros(len(start))
    towards[-1] = 1.0 if ends[1] > ends[0] else -1.0
    points = [curve.point(start, towards)]
    if points[0].tangent[-1] * towards[-1] < 0.0:
        raise AssertionError("the tangent points the other way")
    special: list[SpecialPoint] = []
    stopped: BaseException | None = None
    try:
        ended = _trace_points(curve, points, special, bounds, step, most, report)
    except (KeyboardInterrupt, MemoryError) as stop:
        ended, stopped = "interrupted", stop
    limit = ZERO_REAL_PART * max(float(np.abs(p.spectrum).max(initial=0.0)) for p in points)
    stable = np.array([(p.spectrum.real <= p.zero(limit)).all() for p in points])
    return np.array([p.z for p in points]), stable, special, ended, stopped


def _trace_points(
    curve: _BranchCurve,
    points: list[_BranchPoint],
    special: list[SpecialPoint],
    bounds: tuple[float, float],
    step: float,
    most: int,
    report: Callable[[float], None],
) -> str:
    """Add points and the special points between them; return why the branch ended."""
    (low, high), length, first_scale = bounds, step / 4.0, curve.scale
    while len(points) < most:
        if curve.outgrown(points[-1].z):
            curve, points[-1] = curve.scaled_anew(points[-1])
        point = points[-1]
        correction = curve.correct(point.z + length * curve.scale * point.tangent, point.tangent)
        near = (
            correction is not None
            and np.linalg.norm((correction[0] - point.z) / curve.scale) <= 1.5 * length
        )
        if correction is None or not near:
            length *= 0.5
            if length < HALF:
                return "lost"
            continue
        z, count = correction
        new = curve.point(z, point.tangent)
        if new.tangent @ point.tangent < 0.8 and length > UNLIMITED_CURVATURE_STEP:
            length *= 0.5
            continue
        new_special = _special_between(curve, point, new, length, len(points) - 1)
        if not low <= z[-1] <= high:
            edge = low if z[-1] < low else high
            last = _point_at_bound(curve, point.z, z, edge)
            end = [] if last is None else [curve.point(last, point.tangent)]
            special += [p for p in new_special if low <= p.value <= high]
            points += end
            return "bounds"
        special += new_special
        points.append(new)
        report(float(z[-1]))
        start = points[0].z
        is_near = np.linalg.norm((z - start) / curve.scale) < length
        if len(points) > 10 and is_near and curve.is_at(new, start, first_scale):
            return "closed"
        length = min(step, length * (1.5 if count <= 4 else 0.8))
    return "steps"


def _point_at_bound(
    curve: _BranchCurve, a: np.ndarray, b: np.ndarray, edge: float
) -> np.ndarray | None:
    """Return the point of the curve between a and b at which the parameter is at its bound."""
    share = (edge - a[-1]) / (b[-1] - a[-1])
    normal = np.zeros(len(a))
    normal[-1] = 1.0
    correction = curve.correct(a + share * (b - a), normal)
    return None if correction is None else correction[0]


def _special_between(
    curve: _BranchCurve, a: _BranchPoint, b: _BranchPoint, length: float, index: int
) -> list[SpecialPoint]:
    """Return the special points between two points."""
    candidates = []
    if a.tangent[-1] * b.tangent[-1] < 0.0:
        arc = _bisected(curve, a, length, lambda p: p.tangent[-1])[1]
        candidates.append(("fold", arc, 0.0))
    if a.sign * b.sign < 0.0:
        arc = _bisected(curve, a, length, lambda p: p.sign)[1]
        candidates.append(("branch point", arc, 0.0))
    oscillation = _oscillation(curve, a, b, length)
    if oscillation is not None:
        candidates.append(("Hopf", *oscillation))
    result = []
    for kind, arc, frequency in candidates:
        point = curve.step_along(a, arc)
        if point is None:
            continue
        if kind == "Hopf":
            pairs = point.spectrum[point.spectrum.imag > point.zero(curve.limit)].imag
            frequency = float(pairs[np.abs(pairs - frequency).argmin()])
        values = dict(zip(curve.names[:-1], point.z[:-1].tolist(), strict=True))
        result.append(SpecialPoint(kind, float(point.z[-1]), values, frequency, index))
    return result


def _oscillation(
    curve: _BranchCurve, a: _BranchPoint, b: _BranchPoint, length: float
) -> tuple[float, float] | None:
    """Return the arc length to a Hopf point between two points, and its approximate frequency.

    Without damping, real parts are rounding errors until two frequencies coincide. Real parts due
    to light damping are distinguished from these by the bounds on the rounding errors.
    """
    zero = [p.zero(curve.limit) for p in (a, b)]
    before, after = (len(p.pairs(limit, limit)) for p, limit in zip((a, b), zero, strict=True))
    unstable = [int((p.spectrum.real > limit).sum()) for p, limit in zip((a, b), zero, strict=True)]
    if before == after or abs(unstable[1] - unstable[0] - 2 * (after - before)) > 1:
        return None  # or a pair became real
    resolved = all(
        len(p.pairs(limit, p.rounding)) == n
        for p, limit, n in zip((a, b), zero, (before, after), strict=True)
    )
    middle = 0.5 * (before + after)

    def new(p: _BranchPoint) -> np.ndarray:
        limit = p.zero(curve.limit)
        return p.pairs(limit, p.rounding if resolved else limit)

    ends = _bisected(curve, a, length, lambda p: len(new(p)) - middle)
    end_point = curve.step_along(a, ends[int(after > before)])
    pairs = np.empty(0) if end_point is None else new(end_point)
    return (ends[1], float(pairs[pairs.real.argmin()].imag)) if pairs.size else None


def _bisected(
    curve: _BranchCurve, a: _BranchPoint, length: float, function: Callable[[_BranchPoint], float]
) -> tuple[float, float]:
    """Return arc lengths from `a` just before and after a function changes its sign."""
    low, high, first = 0.0, length, function(a)
    for _ in range(60):
        middle = 0.5 * (low + high)
        point = curve.step_along(a, middle)
        if point is None:
            break
        if function(point) * first > 0.0:
            low = middle
        else:
            high = middle
        if high - low < ROUNDED:
            break
    return low, high


def sizes_along(slopes: np.ndarray, z: np.ndarray, units: np.ndarray) -> np.ndarray:
    """Return sizes of the unknowns; that of the parameter, the last one, is its span.

    The sizes equilibrate the Jacobian in the least-squares sense of the logarithms of its entries
    (A. R. Curtis and J. K. Reid, J. Inst. Maths Applics 10 (1972) 118-124), and are at least the
    unknowns' magnitudes. They do not depend on the user's units. Unknowns without entries have the
    size 1.
    """
    m, k = slopes.shape
    sizes = np.abs(slopes)
    sizes[:, -1] *= units[-1]
    row, column = np.nonzero(unrounded(sizes, np.append(units[:-1], 1.0)))
    table = np.zeros((len(row), m + k))
    table[np.arange(len(row)), row] = table[np.arange(len(row)), m + column] = 1.0
    logs = np.linalg.lstsq(table[:, :-1], -np.log(sizes[row, column]), rcond=None)[0]
    return np.append(np.maximum(np.abs(z[:-1]), np.exp(logs[m:])), units[-1])
