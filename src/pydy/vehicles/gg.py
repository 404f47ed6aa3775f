"""Diagrams of the largest accelerations of a vehicle in the directions of the plane."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.core.relational import Relational

from pydy._checks import check_mapping, instance, one_or_more, real_array, shown
from pydy._errors import OptimizationError
from pydy._names import some
from pydy._rank import HALF, or_one
from pydy.plot import axes_of
from pydy.system import System
from pydy.vehicles.curvilinear import _Planar
from pydy.vehicles.manoeuvres import check_name, names_of, three_names

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

_DIRECTIONS = 72
_ITERATIONS = 200
_PRECISION = 1e-14  # of the objective; a search ends by rounding, and HALF judges its end


@dataclass(frozen=True, eq=False)
class GGDiagram:
    """The largest accelerations of a vehicle, for k speeds and m directions.

    Attributes
    ----------
    speeds : ndarray, shape (k,)
        Of the point along its path (m/s).
    directions : ndarray, shape (m,)
        Angles of the acceleration (rad) from forward to the left.
    acceleration : ndarray, shape (k, m)
        The largest acceleration (m/s²) in each direction.
    states : ndarray, shape (k, m, n)
        States of the vehicle there, at the origin and at the yaw angle zero.
    inputs : dict
        From the name of each control to its values, of shape (k, m).
    """

    speeds: np.ndarray
    directions: np.ndarray
    acceleration: np.ndarray
    states: np.ndarray
    inputs: dict[str, np.ndarray]

    def __repr__(self) -> str:
        return f"<GGDiagram: {len(self.speeds)} speeds, {len(self.directions)} directions>"

    @property
    def longitudinal(self) -> np.ndarray:
        """The components along the path (m/s²), shape (k, m)."""
        result: np.ndarray = self.acceleration * np.cos(self.directions)
        return result

    @property
    def lateral(self) -> np.ndarray:
        """The components to the left of the path (m/s²), shape (k, m)."""
        result: np.ndarray = self.acceleration * np.sin(self.directions)
        return result

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot longitudinal over lateral accelerations, a curve for each speed.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        for speed, ahead, aside in zip(self.speeds, self.longitudinal, self.lateral, strict=True):
            ax.plot(aside, ahead, label=f"{speed:g} m/s")
        ax.set_aspect("equal")
        ax.set_xlabel("lateral acceleration (m/s²)")
        ax.set_ylabel("longitudinal acceleration (m/s²)")
        ax.grid(alpha=0.3)
        ax.legend()
        return ax


def gg_diagram(
    system: System,
    speeds: float | Sequence[float] | np.ndarray,
    *,
    directions: ArrayLike | None = None,
    path: Iterable[sm.Basic] | None = None,
    bounds: Mapping[Any, Any] | None = None,
    inputs: Sequence[str] | None = None,
    position: Sequence[str] = ("x", "y", "psi"),
) -> GGDiagram:
    """Return the largest accelerations of a planar vehicle in each direction (the g-g diagram).

    The vehicle is in a quasi-steady state: with the speed V of its point and the yaw rate r, the
    lateral acceleration is a_n = V r, the sideslip angle and all states that do not make up the
    velocity are constant, and V' = a_t. For each direction θ ::

        largest a   with   a_t = a cos θ,   a_n = a sin θ

    is solved by sequential quadratic programming (SLSQP) with exact derivatives. Wheels that spin
    have no angular acceleration here, whose torque the controls would provide.

    Parameters
    ----------
    system : System
        A vehicle with a free speed, as for `along`; it is not changed.
    speeds : float or sequence of float, shape (k,)
        V (m/s), positive.
    directions : array_like, shape (m,), optional
        θ (rad) from forward to the left; by default 73 angles from 0 to 2π.
    path : sequence of relations, optional
        Inequalities between expressions of states, controls, constants and outputs, such as a limit
        of the force that a tire bears.
    bounds : dict, optional
        Pairs of least and largest values, or None, of states and controls.
    inputs : sequence of str, optional
        The specifieds that are controls, by default all; others keep their values, which are
        numbers or expressions.
    position : three of str, optional
        The coordinates x and y of the point, and the yaw angle.

    Returns
    -------
    GGDiagram

    Raises
    ------
    OptimizationError
        There is no such state, as at a speed that the vehicle cannot keep, or nothing limits the
        acceleration. Its `trajectory` is None.

    References
    ----------
    W. F. Milliken and D. L. Milliken, Race Car Vehicle Dynamics, SAE, 1995, chapter 9; R. Lot and
    F. Biral, A curvilinear abscissa approach for the lap time optimization of racing vehicles,
    IFAC Proceedings Volumes 47(3), 2014, pp. 7559–7565.

    Examples
    --------
    >>> import sympy as sm
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from pydy.vehicles import CARS, single_track
    >>> from pydy.vehicles.tracks import gg_diagram
    >>> car = single_track(CARS['bmw_320i'], free_speed=True)
    >>> F_x, m, a_y = dynamicsymbols('F_x'), *sm.symbols('m a_y')
    >>> gg = gg_diagram(car, 20.0, directions=[0.0, 1.0], path=[(F_x/m)**2 + a_y**2 <= 64])
    >>> gg.acceleration.round(3)
    array([[8.   , 7.913]])
    """
    search = _Search(system, path, bounds, inputs, position)
    values = np.atleast_1d(real_array(speeds, "`speeds`"))
    if values.ndim != 1 or not values.size or not (np.isfinite(values) & (values > 0.0)).all():
        raise ValueError(f"`speeds` must be positive finite numbers, got {shown(speeds)}.")
    if directions is None:
        angles = 2 * np.pi * np.arange(_DIRECTIONS + 1) / _DIRECTIONS
    else:
        angles = real_array(directions, "`directions`")
        if angles.ndim != 1 or not angles.size or not np.isfinite(angles).all():
            raise ValueError(
                f"`directions` must be finite angles in one dimension, got {shown(directions)}."
            )
    points = np.array([search.at_speed(float(speed), angles) for speed in values])
    n = len(search.states)
    controls = {name: points[:, :, n + k] for k, name in enumerate(search.controls)}
    return GGDiagram(values, angles, points[:, :, -1], points[:, :, :n], controls)


class _Level(_Planar):
    """The velocity of a planar vehicle; its accelerations, which may be long, stay unwritten."""

    def __init__(self, system: System, position: tuple[Any, ...]) -> None:
        self.system = system
        self.x, self.y, self.psi = position
        equations = system.equations_of_motion()
        if equations.constraint_jacobian.rows or system.auxiliaries:
            raise NotImplementedError(
                "`system` must have no constraints and no auxiliary states; use coordinates that "
                "are independent."
            )
        rates = dict(zip(equations.coordinates, equations.kinematics, strict=True))
        self.planar_rates = [equations.written_out(rates[q]) for q in position]
        self.internal = [(q, rates[q]) for q in equations.coordinates if q not in position]
        self._check(self.planar_rates)
        self.outputs = {
            sm.Symbol(k) if isinstance(k, str) else k: sm.sympify(e)
            for k, e in system.outputs.items()
            if not isinstance(k, tuple)
        }


class _Search:
    """Quasi-steady states of a vehicle as nonlinear programs."""

    def __init__(
        self,
        system: System,
        path: Iterable[sm.Basic] | None,
        bounds: Mapping[Any, Any] | None,
        inputs: Sequence[str] | None,
        position: Sequence[str],
    ) -> None:
        instance(system, System, "`system`", "a System, such as single_track returns")
        coordinates = names_of(system.coordinates)
        for k, name in enumerate(three_names(position)):
            check_name(name, f"position[{k}]", coordinates)
        if len({*position}) != 3:
            raise ValueError(f"`position` must be three coordinates, got {shown(position)}.")
        self.specifieds = list(system.specifieds_symbols)
        known = names_of(self.specifieds)
        self.controls = sorted(known) if inputs is None else one_or_more("inputs", inputs)
        for name in self.controls:
            check_name(name, "inputs", known)
        planar = _Level(system, tuple(system.coordinates[coordinates.index(p)] for p in position))
        planar.check_symmetry()
        fixed = planar.fixed(self.controls)
        self.vehicle = copy(system)
        self.vehicle.specifieds = {**fixed, **{s: 0.0 for s in self.specifieds if s not in fixed}}
        by_name = dict(zip(known, self.specifieds, strict=True))
        self.free_inputs = [by_name[name] for name in self.controls]
        self.states = list(self.vehicle.states)
        self.names = names_of(self.states)
        self.planar = [self.names.index(name) for name in position]
        self.start = np.zeros(len(self.states))
        for key, value in system.initial_conditions.items():
            self.start[self.names.index(str(key).removesuffix("(t)"))] = float(value)
        self.start[self.planar] = 0.0
        inner = [k for k in range(len(self.states)) if k not in self.planar]
        self.columns = [*inner, *range(len(self.states), len(self.states) + len(self.controls))]
        self.symbols = [*self.states, *self.free_inputs]
        relations = self._state(planar)
        self.limits = self._read(path, planar)
        self.low, self.high = self._bounds(bounds)
        self.equalities = len(relations)
        expressions = [*relations, *self.limits]
        self.vehicle.outputs = {sm.Symbol(f"value_{k}"): e for k, e in enumerate(expressions)}

    def _state(self, planar: _Level) -> list[sm.Expr]:
        """Return V², a_t, a_n and what is zero in a quasi-steady state, as expressions."""
        t = me.dynamicsymbols._t
        ahead, aside, yaw_rate = (e.xreplace({planar.psi: sm.S.Zero}) for e in planar.planar_rates)
        # Derivatives in outputs are evaluated with the equations, which are never written out.
        rates = {q: q.diff(t) for q in (*(q for q, _ in planar.internal), *planar.system.speeds)}

        def derivative(e: sm.Expr) -> sm.Expr:
            return sm.Add(*(e.diff(q) * rate for q, rate in rates.items()))

        for e in (ahead, aside):
            if inputs := sorted(str(s) for s in self.specifieds if e.has(s)):
                raise ValueError(
                    f"`system` has a velocity that depends on {some(inputs)}. Make it a state "
                    "whose rate is the input."
                )
        turning = [q for q in rates if yaw_rate == q]
        velocity = [q for q in rates if (ahead.has(q) or aside.has(q)) and q not in turning]
        if len(velocity) not in (1, 2):
            raise ValueError(
                "`system` must have one or two states that its velocity depends on besides the yaw "
                f"rate, got {some(map(str, velocity))}. Use the `position` of such a point."
            )
        square = ahead**2 + aside**2
        forward, sideways = derivative(ahead), derivative(aside)
        along = (ahead * forward + aside * sideways) / sm.sqrt(square)
        zero = [rate for q, rate in rates.items() if q not in velocity]
        if len(velocity) == 2:
            zero.append((ahead * sideways - aside * forward) / square)
        return [sm.sqrt(square), along, sm.sqrt(square) * yaw_rate, *zero]

    def _read(self, path: Any, planar: _Level) -> list[sm.Expr]:
        """Return the inequalities as expressions that must not be negative."""
        if isinstance(path, (Relational, str, bytes, Mapping)) or not (
            path is None or isinstance(path, Iterable)
        ):
            raise TypeError(f"`path` must be a sequence of relations, got {shown(path)}.")
        allowed = {*self.symbols, *self.vehicle.constants_symbols, *self.specifieds}
        limits = []
        for relation in () if path is None else path:
            if not isinstance(relation, (sm.Le, sm.Ge, sm.Lt, sm.Gt)):
                raise TypeError(
                    f"`path` must be relations, such as F <= 1000, got {shown(relation)}."
                )
            limit = (relation.gts - relation.lts).xreplace(planar.outputs)
            unknown = {*limit.free_symbols, *limit.atoms(sm.core.function.AppliedUndef)} - allowed
            if unknown := unknown - {me.dynamicsymbols._t}:
                raise ValueError(
                    f"`path` has {some(sorted(map(str, unknown)))}, no states, specifieds, "
                    "constants or outputs that are independent of the position."
                )
            limits.append(limit)
        return limits

    def _bounds(self, bounds: Any) -> tuple[np.ndarray, np.ndarray]:
        names = [*self.names, *self.controls]
        low, high = np.full(len(names), -np.inf), np.full(len(names), np.inf)
        possible = [names[k] for k in self.columns]
        for key, pair in check_mapping("bounds", bounds).items():
            name = str(key).removesuffix("(t)")
            if name not in possible:
                raise ValueError(
                    f"`bounds` has the key {shown(key)}; it must be of {some(possible)}."
                )
            if not isinstance(pair, (tuple, list)) or len(pair) != 2:
                raise ValueError(
                    f"`bounds[{name}]` must be a pair of numbers or None, got {shown(pair)}."
                )
            ends = [
                usual if end is None else end
                for end, usual in zip(pair, (-np.inf, np.inf), strict=True)
            ]
            least, largest = real_array(ends, f"`bounds[{name}]`")
            if not least < largest:
                raise ValueError(f"`bounds[{name}]` must ascend, got {shown(pair)}.")
            k = names.index(name)
            low[k], high[k] = least, largest
        return low[self.columns], high[self.columns]

    def _values(self, z: np.ndarray) -> np.ndarray:
        full = np.append(self.start, np.zeros(len(self.controls)))
        full[self.columns] = z
        result: np.ndarray = self._evaluated(self.vehicle.evaluate_outputs, full)
        return result

    def _slopes(self, z: np.ndarray) -> np.ndarray:
        full = np.append(self.start, np.zeros(len(self.controls)))
        full[self.columns] = z
        slopes: np.ndarray = self._evaluated(
            self.vehicle.evaluate_jacobian, full, wrt=self.symbols, of="outputs"
        )
        return slopes[:, self.columns]

    def _evaluated(self, function: Any, full: np.ndarray, **options: Any) -> np.ndarray:
        n = len(self.states)
        self.vehicle.specifieds.update(zip(self.free_inputs, full[n:].tolist(), strict=True))
        result: np.ndarray = function(full[:n], 0.0, **options)
        return result

    def at_speed(self, speed: float, angles: np.ndarray) -> np.ndarray:
        """Return states, controls and acceleration for each direction, shape (m, n + …)."""
        n = len(self.states)
        begin = np.append(self.start, np.zeros(len(self.controls)))
        velocity = self._values(begin[self.columns])[0]
        moving = [self.names.index(name) for name in names_of(self.vehicle.speeds)]
        begin[moving] *= speed / velocity  # wheels roll
        neutral = np.clip(begin[self.columns], self.low, self.high)
        program = _Program(self, speed, neutral)
        rows, last = [], None
        for angle in angles.tolist():
            ends = [program.solve(angle, neutral, 0.0)]
            if last is not None:
                ends.append(program.solve(angle, *last))
            solved = [end for end in ends if end is not None]
            if not solved:
                raise OptimizationError(
                    f"No largest acceleration was found at {speed:g} m/s in the direction "
                    f"{angle:.4g} rad: {program.message}. Limit the forces of the tires and the "
                    "controls, by tires that saturate, `path` or `bounds`, or use a speed that the "
                    "vehicle can keep.",
                    None,
                )
            last = max(solved, key=lambda end: end[1])
            full = np.append(self.start, np.zeros(len(self.controls)))
            full[self.columns] = last[0]
            rows.append(np.append(full, last[1]))
        return np.array(rows).reshape(len(angles), n + len(self.controls) + 1)


class _Program:
    """The nonlinear program at one speed: the largest a in a direction, in scaled unknowns."""

    def __init__(self, search: _Search, speed: float, neutral: np.ndarray) -> None:
        self.search, self.speed = search, speed
        slopes = search._slopes(neutral)
        self.columns = 1.0 / or_one(np.abs(slopes[: search.equalities]).max(axis=0))
        scaled = np.abs(slopes * self.columns).max(axis=1)
        # A limit that is flat straight ahead, such as that of a square, is scaled by its value.
        sizes = np.where(scaled > 0.0, scaled, np.abs(search._values(neutral)))
        sizes[search.equalities :] = np.maximum(sizes, np.abs(search._values(neutral)))[
            search.equalities :
        ]
        self.rows = or_one(sizes)
        self.message = ""

    def solve(
        self, angle: float, z: np.ndarray, acceleration: float
    ) -> tuple[np.ndarray, float] | None:
        """Return unknowns and acceleration of a local optimum, or None."""
        from scipy.optimize import minimize

        count = self.search.equalities
        direction = np.zeros(count)
        direction[1:3] = np.cos(angle), np.sin(angle)
        target = np.zeros(count)
        target[0] = self.speed
        scale = self.columns

        def values(y: np.ndarray) -> np.ndarray:
            raw = self.search._values(y[:-1] * scale)
            raw[:count] -= target + direction * y[-1]
            scaled: np.ndarray = raw / self.rows
            return scaled

        def slopes(y: np.ndarray) -> np.ndarray:
            raw = self.search._slopes(y[:-1] * scale) * scale
            last = np.append(-direction, np.zeros(len(raw) - count))
            scaled: np.ndarray = np.column_stack([raw, last]) / self.rows[:, None]
            return scaled

        gradient = np.append(np.zeros(len(z)), -1.0)
        constraints = [
            {"type": "eq", "fun": lambda y: values(y)[:count], "jac": lambda y: slopes(y)[:count]}
        ]
        if self.search.limits:
            constraints.append(
                {
                    "type": "ineq",
                    "fun": lambda y: values(y)[count:],
                    "jac": lambda y: slopes(y)[count:],
                }
            )
        low = np.append(self.search.low / scale, 0.0)
        high = np.append(self.search.high / scale, np.inf)
        with np.errstate(all="ignore"):
            result = minimize(
                lambda y: -y[-1],
                np.append(z / scale, acceleration),
                jac=lambda _: gradient,
                method="SLSQP",
                bounds=np.stack([low, high], axis=1),
                constraints=constraints,
                options={"maxiter": _ITERATIONS, "ftol": _PRECISION},
            )
            residuals = values(result.x)
        if not np.isfinite(residuals).all():
            self.message = "the equations are not finite at the end of the search"
            return None
        error = np.append(np.abs(residuals[:count]), -residuals[count:]).max(initial=0.0)
        self.message = str(result.message)
        if not error <= HALF * max(1.0, abs(result.x[-1])):
            return None
        # Rounding ends many searches (status 8): whether at an optimum, the multipliers show.
        if not _is_stationary(slopes(result.x), residuals, count, result.x, low, high):
            return None
        return result.x[:-1] * scale, float(result.x[-1])


def _is_stationary(
    slopes: np.ndarray,
    residuals: np.ndarray,
    equalities: int,
    y: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
) -> bool:
    """Return whether multipliers of the right sign balance the gradient of the last unknown.

    A gradient of ε that remains changes the objective by ε², so that a quarter of the digits
    is enough for half of the digits of the objective.
    """
    from scipy.optimize import lsq_linear

    quarter = np.sqrt(HALF)
    active = np.flatnonzero(residuals[equalities:] <= quarter) + equalities
    unit, size = np.eye(len(y)), quarter * np.maximum(1.0, np.abs(y))
    edges = [*unit[y - low <= size], *-unit[high - y <= size]]
    normals = np.array([*slopes[:equalities], *slopes[active], *edges])
    least = np.append(np.full(equalities, -np.inf), np.zeros(len(normals) - equalities))
    fit = lsq_linear(normals.T, -unit[-1], (least, np.full(len(least), np.inf)), tol=_PRECISION)
    return bool(np.abs(fit.fun).max() <= quarter)
