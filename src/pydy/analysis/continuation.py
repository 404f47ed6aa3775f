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
from typing import Any

import numpy as np

from pydy._forks import cached_property
from pydy._names import place_of
from pydy._optional import require
from pydy._rank import DEPENDENT, HALF, ROUNDED, or_one, rank_of, unrounded
from pydy.analysis.equilibria import Sizes
from pydy.analysis.tuning import (
    ASTRAY,
    CROSSED,
    ON_BRANCH,
    STEEPEST_TURN,
)
from pydy.plot import axes_of, typeset

Function = Callable[[np.ndarray], np.ndarray]
Spectrum = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]
Measured = Callable[[np.ndarray, np.ndarray], Sizes]
Functions = tuple[Function, Function, Spectrum, Measured]  # F, its derivatives, and more

# Points, and how far they are changed, that tell of the rounding of residuals.
_ROUNDINGS, _LAST_DIGITS = 4, 4.0


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
        found = ", ".join(f"{p.kind} at {p.value:.6g}" for p in self.special) or "nothing special"
        return (
            f"{len(self.values)} equilibria, {self.parameter} from {self.values[0]:.6g} to "
            f"{self.values[-1]:.6g}: {found}{'; lost there' if self.ended == 'lost' else ''}"
        )

    __repr__ = __str__

    def __getitem__(self, unknown: Any) -> np.ndarray:
        """Return an unknown along the branch, by symbol or name."""
        return self.solutions[:, place_of(unknown, self.unknowns, "unknowns")]

    def to_xarray(self) -> Any:
        """Return an `xarray.Dataset` with the parameter and all unknowns by `point`."""
        xarray = require("xarray", "ensemble", "to_xarray()")
        columns = {self.parameter: self.values, "stable": self.stable}
        columns |= {name: self[name] for name in self.unknowns}
        return xarray.Dataset({name: (("point",), column) for name, column in columns.items()})

    def plot(self, name: str, ax: Any = None) -> Any:
        """Plot an unknown over the parameter, dashed where unstable; return the Axes."""
        ax, solution, stable, start = axes_of(ax, "a plot"), self[name], self.stable, 0
        m = len(self.values)
        for k in range(1, m + 1):
            if k == m or stable[k] != stable[start]:
                run = slice(start, min(k + 1, m))
                style = "-" if stable[start] else "--"
                ax.plot(self.values[run], solution[run], color="C0", linestyle=style)
                start = k
        for p in self.special:
            at = p.value, p.values[name]
            ax.plot(*at, "o", color="C3", markersize=4)
            ax.annotate(p.kind, at, textcoords="offset points", xytext=(4, 4), fontsize="small")
        ax.set_xlabel(typeset(self.parameter, ""))
        ax.set_ylabel(typeset(name, ""))
        return ax


@dataclass(frozen=True, eq=False)
class _Point:
    z: np.ndarray
    tangent: np.ndarray
    sign: float  # of the determinant
    spectrum: np.ndarray
    rounding: np.ndarray  # of the spectrum

    def zero(self, most: float) -> np.ndarray:
        """The parts of each eigenvalue that are zero, at most as large as that."""
        return np.minimum(most, ASTRAY * self.rounding)

    def pairs(self, zero: np.ndarray, above: np.ndarray) -> np.ndarray:
        """The upper ones of the conjugate pairs with a real part above a level."""
        return self.spectrum[(self.spectrum.imag > zero) & (self.spectrum.real > above)]


class _Curve:
    """The curve F(z) = 0 through z, in units of equations and unknowns, with free states fixed.

    The parameter is the last unknown, whose range has the `span`. The `spectrum` returns the
    eigenvalues at z and bounds on their rounding. Sizes are `measured` of slopes by the unknowns
    without the parameter, and z with it.
    """

    def __init__(
        self,
        functions: Functions,
        z: np.ndarray,
        span: float,
        names: tuple[str, ...],
    ):
        self._F, self._J, self.spectrum, measured = functions
        self.names = names
        first = self._J(z)
        # Rows that follow from the others, as accelerations do from constraints, have slopes of
        # rounding errors: these tell no size, and the row is as large as the largest.
        known = measured(first[:, :-1], z)
        noise = known.terms + np.abs(first[:, -1]) * span <= known.limit
        self._least = np.where(noise, known.limit / ROUNDED, 0.0)
        units = np.append(known.units, span)
        self.scale = sizes_along(np.where(noise[:, None], 0.0, first), z, units)
        self.scale[:-1] *= self._above_rounding(first, z)[:-1]
        self.sizes = self._rows(first)
        slopes = self.J(z)[:, :-1] * self.scale[:-1]
        _, singular, right = np.linalg.svd(slopes)
        rank = rank_of(singular)
        free = right[rank:]
        # A direction that the parameter alone moves along, such as at a fold, is not held.
        self.held = free if len(free) <= max(0, len(z) - 1 - rank) else free[:0]
        self.origin = z
        left = np.linalg.svd(self._whole(z), full_matrices=False)[0]
        self.rows = left[:, : len(z) - 1].T

    def _rows(self, slopes: np.ndarray) -> np.ndarray:
        """Return how large rows with such slopes are."""
        sizes = np.abs(slopes * self.scale).max(axis=1, initial=0.0)
        return or_one(np.maximum(sizes, self._least))

    def _above_rounding(self, slopes: np.ndarray, z: np.ndarray) -> np.ndarray:
        """Return factors of the scale with which rounding is no step of Newton's method.

        The slopes do not tell the size of unknowns that the parameter does not move, such as those
        of a symmetry. Rounding is what unknowns changed in their last digits leave of residuals.
        """
        signs = np.random.default_rng(0).choice([-1.0, 1.0], size=(_ROUNDINGS, len(z)))
        moved = z * (1.0 + _LAST_DIGITS * np.finfo(float).eps * signs)
        left = [self._F(at) - self._F(z) - slopes @ (at - z) for at in moved]
        rounding = np.abs(left).max(axis=0)
        sizes = self._rows(slopes)
        inverse = np.linalg.pinv(slopes * self.scale / sizes[:, None], rcond=DEPENDENT)
        steps = np.abs(inverse) @ (rounding / sizes)
        return np.where(steps > 0.1 * ON_BRANCH, 100.0 * steps / ON_BRANCH, 1.0)

    def F(self, z: np.ndarray) -> np.ndarray:
        residuals: np.ndarray = self._F(z) / self.sizes
        return residuals

    def J(self, z: np.ndarray) -> np.ndarray:
        slopes: np.ndarray = self._J(z) / self.sizes[:, None]
        return slopes

    def _whole(self, z: np.ndarray) -> np.ndarray:
        scaled = self.J(z) * self.scale
        held = np.hstack([self.held, np.zeros((len(self.held), 1))])
        return np.vstack([scaled, held])

    def residual(self, z: np.ndarray) -> np.ndarray:
        moved = ((z - self.origin) / self.scale)[:-1]
        return np.concatenate([self.F(z), self.held @ moved])

    def corrected(self, z: np.ndarray, tangent: np.ndarray) -> tuple[np.ndarray, int] | None:
        """Return the point of the curve in the plane through `z` normal to the tangent."""
        anchor = z
        for count in range(8):
            slopes = np.vstack([self._whole(z), tangent])
            values = np.append(self.residual(z), tangent @ ((z - anchor) / self.scale))
            if not (np.isfinite(slopes).all() and np.isfinite(values).all()):
                return None
            step = np.linalg.lstsq(slopes, values, rcond=None)[0]
            z = z - self.scale * step
            if np.abs(step).max() <= ON_BRANCH:
                # Rows that contradict each other have a least square, too: it solves none of them.
                moved = np.maximum(1.0, np.abs(slopes[:-1]).max(axis=1, initial=0.0))
                solved = (np.abs(self.residual(z)) <= ON_BRANCH * moved).all()
                return (z, count) if solved else None
        return None

    def along(self, a: _Point, arc: float) -> _Point | None:
        """Return the point some way along the tangent of another."""
        found = self.corrected(a.z + arc * self.scale * a.tangent, a.tangent)
        return None if found is None else self.point(found[0], a.tangent)

    @cached_property
    def limit(self) -> float:
        """The largest real part of an eigenvalue that is zero."""
        return CROSSED * float(np.abs(self.spectrum(self.origin)[0]).max(initial=0.0))

    def point(self, z: np.ndarray, before: np.ndarray) -> _Point:
        whole = self._whole(z)
        square = self.rows @ whole
        tangent = np.linalg.svd(square)[2][-1]
        tangent = tangent if tangent @ before >= 0.0 else -tangent
        sign = float(np.linalg.slogdet(np.vstack([square, tangent]))[0])
        return _Point(z, tangent, sign, *self.spectrum(z))


def trace(
    functions: Functions,
    names: tuple[str, ...],
    start: np.ndarray,
    ends: tuple[float, float],
    step: float,
    most: int,
    told: Callable[[float], None],
) -> tuple[np.ndarray, np.ndarray, list[SpecialPoint], str, BaseException | None]:
    """Follow F(z) = 0 from a solution; also say which points are stable, and how it ended.

    If Ctrl-C or the end of memory stopped it, that is returned last.

    The parameter stays between the `ends`, and goes to the second at first; a `step` is at most
    such a share of their distance, and there are at `most` so many points. `told` is called with
    the parameter at each further one.
    """
    bounds = min(ends), max(ends)
    curve = _Curve(functions, start, bounds[1] - bounds[0], names)
    towards = np.zeros(len(start))
    towards[-1] = 1.0 if ends[1] > ends[0] else -1.0
    points = [curve.point(start, towards)]
    if points[0].tangent[-1] * towards[-1] < 0.0:
        raise AssertionError("the tangent points the other way")
    special: list[SpecialPoint] = []
    stopped: BaseException | None = None
    try:
        ended = _followed(curve, points, special, bounds, step, most, told)
    except (KeyboardInterrupt, MemoryError) as stop:
        ended, stopped = "interrupted", stop
    limit = CROSSED * max(float(np.abs(p.spectrum).max(initial=0.0)) for p in points)
    stable = np.array([(p.spectrum.real <= p.zero(limit)).all() for p in points])
    return np.array([p.z for p in points]), stable, special, ended, stopped


def _followed(
    curve: _Curve,
    points: list[_Point],
    special: list[SpecialPoint],
    bounds: tuple[float, float],
    step: float,
    most: int,
    told: Callable[[float], None],
) -> str:
    """Add points and the special points between them; return why the branch ended."""
    (low, high), length = bounds, step / 4.0
    while len(points) < most:
        point = points[-1]
        found = curve.corrected(point.z + length * curve.scale * point.tangent, point.tangent)
        near = (
            found is not None and np.linalg.norm((found[0] - point.z) / curve.scale) <= 1.5 * length
        )
        if found is None or not near:
            length *= 0.5
            if length < HALF:
                return "lost"
            continue
        z, count = found
        new = curve.point(z, point.tangent)
        if new.tangent @ point.tangent < 0.8 and length > STEEPEST_TURN:
            length *= 0.5
            continue
        seen = _between(curve, point, new, length, len(points) - 1)
        if not low <= z[-1] <= high:
            edge = low if z[-1] < low else high
            last = _at(curve, point.z, z, edge)
            end = [] if last is None else [curve.point(last, point.tangent)]
            special += [p for p in seen if low <= p.value <= high]
            points += end
            return "bounds"
        special += seen
        points.append(new)
        told(float(z[-1]))
        if len(points) > 10 and np.linalg.norm((z - points[0].z) / curve.scale) < 0.5 * length:
            return "closed"
        length = min(step, length * (1.5 if count <= 4 else 0.8))
    return "steps"


def _at(curve: _Curve, a: np.ndarray, b: np.ndarray, edge: float) -> np.ndarray | None:
    """Return the point of the curve with the parameter at the edge, between a and b."""
    share = (edge - a[-1]) / (b[-1] - a[-1])
    normal = np.zeros(len(a))
    normal[-1] = 1.0
    found = curve.corrected(a + share * (b - a), normal)
    return None if found is None else found[0]


def _between(curve: _Curve, a: _Point, b: _Point, length: float, place: int) -> list[SpecialPoint]:
    """Return the special points between two points."""
    found = []
    if a.tangent[-1] * b.tangent[-1] < 0.0:
        arc = _bisected(curve, a, length, lambda p: p.tangent[-1])[1]
        found.append(("fold", arc, 0.0))
    if a.sign * b.sign < 0.0:
        arc = _bisected(curve, a, length, lambda p: p.sign)[1]
        found.append(("branch point", arc, 0.0))
    oscillation = _oscillation(curve, a, b, length)
    if oscillation is not None:
        found.append(("Hopf", *oscillation))
    result = []
    for kind, arc, frequency in found:
        point = curve.along(a, arc)
        if point is None:
            continue
        if kind == "Hopf":
            pairs = point.spectrum[point.spectrum.imag > point.zero(curve.limit)].imag
            frequency = float(pairs[np.abs(pairs - frequency).argmin()])
        values = dict(zip(curve.names[:-1], point.z[:-1].tolist(), strict=True))
        result.append(SpecialPoint(kind, float(point.z[-1]), values, frequency, place))
    return result


def _oscillation(curve: _Curve, a: _Point, b: _Point, length: float) -> tuple[float, float] | None:
    """Return the arc to a Hopf point between two points, and about its frequency.

    Without damping real parts are zero up to rounding until two frequencies meet. Those that a
    little damping leaves are told from rounding by its bounds.
    """
    zero = [p.zero(curve.limit) for p in (a, b)]
    before, after = (len(p.pairs(limit, limit)) for p, limit in zip((a, b), zero, strict=True))
    unstable = [int((p.spectrum.real > limit).sum()) for p, limit in zip((a, b), zero, strict=True)]
    if before == after or abs(unstable[1] - unstable[0] - 2 * (after - before)) > 1:
        return None  # or a pair became real
    told = all(
        len(p.pairs(limit, p.rounding)) == n
        for p, limit, n in zip((a, b), zero, (before, after), strict=True)
    )
    middle = 0.5 * (before + after)

    def new(p: _Point) -> np.ndarray:
        limit = p.zero(curve.limit)
        return p.pairs(limit, p.rounding if told else limit)

    ends = _bisected(curve, a, length, lambda p: len(new(p)) - middle)
    beyond = curve.along(a, ends[int(after > before)])
    pairs = np.empty(0) if beyond is None else new(beyond)
    return (ends[1], float(pairs[pairs.real.argmin()].imag)) if pairs.size else None


def _bisected(
    curve: _Curve, a: _Point, length: float, function: Callable[[_Point], float]
) -> tuple[float, float]:
    """Return arcs from `a`, one before and one after a function changes its sign on a step."""
    low, high, first = 0.0, length, function(a)
    for _ in range(60):
        middle = 0.5 * (low + high)
        point = curve.along(a, middle)
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
    """Return sizes of the unknowns; of the parameter, the last one, its span: that of the units.

    Unknowns that the parameter moves are as large as what it moves them by, or as they are: with
    each entry of the Jacobian times the size of its column as large as its row, as far as least
    squares of logarithms allow (Curtis and Reid, J. Inst. Maths Applics 10 (1972) 118-124). That
    does not depend on the units that a user works in. What nothing tells of has the size 1.
    """
    m, k = slopes.shape
    sizes = np.abs(slopes)
    sizes[:, -1] *= units[-1]
    row, column = np.nonzero(unrounded(sizes, np.append(units[:-1], 1.0)))
    table = np.zeros((len(row), m + k))
    table[np.arange(len(row)), row] = table[np.arange(len(row)), m + column] = 1.0
    logs = np.linalg.lstsq(table[:, :-1], -np.log(sizes[row, column]), rcond=None)[0]
    return np.append(np.maximum(np.abs(z[:-1]), np.exp(logs[m:])), units[-1])
