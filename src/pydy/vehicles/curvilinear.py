"""Planar vehicles along a track: the arc length of its center line in place of time."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.core.function import AppliedUndef

from pydy._checks import check_mapping, instance, one_or_more, positive, shown
from pydy._errors import PyDyUserWarning
from pydy._forks import cached_property
from pydy._names import some
from pydy._rank import ROUNDED, or_one
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.system import System
from pydy.trajectory import Trajectory
from pydy.vehicles.lap import Lap
from pydy.vehicles.manoeuvres import check_name, names_of, three_names
from pydy.vehicles.planar import (
    check_expressions,
    check_symmetry,
    check_unconstrained,
    fixed_inputs,
)
from pydy.vehicles.track import Track

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol, TimeFunction
    from pydy.control import OptimalControl

_NEW = ("n", "xi", "curvature", "pace")
_NODES = 100
_GUESSED = 2001  # samples of a guess


@dataclass(frozen=True, eq=False)
class TrackSystem:
    """A planar vehicle in the curvilinear coordinates of a track.

    `along` makes it. The parts of its problem of least time, for `System.optimize_trajectory` and
    `pydy.control.OptimalControl`, are its attributes; `least_time` states and solves it.

    Attributes
    ----------
    track : Track
    system : System
        The vehicle with the arc length s (m) in the place of time: its `times` are arc lengths, and
        derivatives by s. Its specified `curvature` is that of the track, its output `pace` the time
        for each length (s/m).
    vehicle : System
        The vehicle in the plane, over time.
    n, xi : functions of time
        The coordinates: offset to the left of the center line (m), and yaw angle from the direction
        of the center line (rad).
    time : expression
        The integral of the pace: the time at the end (s), the objective of a problem of least time.
    periodic : bool
        Whether all states are the same at both ends.
    start : dict
        The states of a periodic motion, which are free; otherwise empty: they are the initial
        conditions.
    boundary : tuple of relations
        The periodic states.
    bounds : dict
        Of n, between the edges of the track, and of xi, between ±π/2.
    """

    track: Track
    system: System
    vehicle: System
    n: TimeFunction
    xi: TimeFunction
    time: sm.Expr
    periodic: bool
    start: dict[AnySymbol, None]
    boundary: tuple[sm.Basic, ...]
    bounds: dict[AnySymbol, Any]
    _position: tuple[str, str, str]
    _controls: tuple[AnySymbol, ...]
    _fixed: dict[AnySymbol, Any]  # values of the other specifieds

    def __repr__(self) -> str:
        kind = "periodic" if self.periodic else "from the initial conditions"
        return f"<TrackSystem on {self.track!r}: {len(self.system.states)} states, {kind}>"

    def guess(self) -> dict[AnySymbol, Any]:
        """Return a motion along the center line at the initial speed, where a search may begin.

        Each of its states is that of a steady turn of the vehicle, linearized straight ahead: its
        value there plus a gain times the curvature of the track.

        Returns
        -------
        dict
            From states and controls to numbers, or to samples at equal distances.
        """
        s = np.linspace(0.0, self.track.length, _GUESSED)
        curvature = np.asarray(self.track.curvature(s))
        turn = self._steady_turn
        return {self.n: 0.0, **{key: at + gain * curvature for key, (at, gain) in turn.items()}}

    @cached_property
    def _steady_turn(self) -> dict[AnySymbol, tuple[float, float]]:
        """Values straight ahead, and gains to curvature, of xi, other states and controls."""
        vehicle, controls = copy(self.vehicle), [*self._controls]
        x, y, psi = self._position
        initial = {str(k).removesuffix("(t)"): v for k, v in vehicle.initial_conditions.items()}
        vehicle.initial_conditions = {**initial, psi: 0.0}
        vehicle.specifieds = {**self._fixed, **dict.fromkeys(controls, 0.0)}
        with warnings.catch_warnings():
            # A kink, such as that of the drag at rest or of brakes, does no harm to a guess.
            warnings.simplefilter("ignore", PyDyUserWarning)
            linear = vehicle.linearize({}, inputs=controls)
        names, base = names_of(vehicle.states), vehicle.evaluate_ode()
        order = [linear.states.index(name) for name in names]
        A, B = linear.A[np.ix_(order, order)], linear.B[order]
        ix, iy, turned = (names.index(name) for name in (x, y, psi))
        speed = float(base[ix])
        inner = [k for k in range(len(names)) if k not in (ix, iy, turned)]
        # The forward speed is the initial one: what moves x is not changed.
        free = [k for k in inner if A[ix, k] == 0.0]
        slopes = np.concatenate([A[np.ix_([*inner, turned], free)], B[[*inner, turned]]], axis=1)
        columns = or_one(np.abs(slopes).max(axis=0, initial=0.0))
        rows = or_one(np.abs(slopes / columns).max(axis=1, initial=0.0))
        wanted = np.zeros((len(rows), 2))
        wanted[:-1, 0], wanted[-1] = -base[inner], (-base[turned], speed)
        scaled = slopes / columns / rows[:, None]
        found = np.linalg.lstsq(scaled, wanted / rows[:, None], rcond=None)[0]
        # A rounding error is no size of a state: the search would divide by it.
        found[np.abs(found) <= ROUNDED * np.abs(found).max(axis=0)] = 0.0
        values = found / columns[:, None]
        states = np.zeros((len(names), 2))
        states[:, 0] = [float(initial.get(name, 0.0)) for name in names]
        states[free] += values[: len(free)]
        xi = -(A[iy, inner] @ states[inner]) / speed
        pairs = {s: states[names.index(s.func.__name__)] for s in self.system.states[2:]}
        pairs |= zip(controls, values[len(free) :], strict=True)
        return {k: (float(v[0]), float(v[1])) for k, v in ({self.xi: xi} | pairs).items()}

    def problem(
        self,
        *,
        cost: sm.Expr | float = 0,
        start: Mapping[Any, Any] | None = None,
        end: Mapping[Any, Any] | None = None,
        bounds: Mapping[Any, Any] | None = None,
        path: Iterable[sm.Basic] | None = None,
        mesh: int | ArrayLike = _NODES,
        **options: Any,
    ) -> OptimalControl:
        """Return the problem of least time, to solve it several times.

        Parameters
        ----------
        cost : expression, optional
            Added to the time: a small multiple of ``sm.Integral(F**2, t)``, with
            ``t = dynamicsymbols._t`` for the arc length, smooths a control F.
        start, end, path, options
            As for `pydy.control.OptimalControl`. Of a periodic motion, `start` and `end` add to the
            conditions that both ends are the same.
        bounds : dict, optional
            Of states, controls and free constants, which add to `bounds` or replace one of them.
        mesh : int or array_like, optional
            As for `pydy.control.OptimalControl`; jumps of the curvature become nodes, too.

        Returns
        -------
        pydy.control.OptimalControl
        """
        from pydy.control import OptimalControl

        free = {**self.start, **self._by_symbol(start)}
        return OptimalControl(
            self.system,
            self.time + cost,
            self.track.length,
            start=free or None,
            end=end,
            boundary=(*self.boundary, *options.pop("boundary", ())),
            bounds={**self.bounds, **self._by_symbol(bounds)},
            path=path,
            mesh=mesh,
            **options,
        )

    def least_time(
        self,
        *,
        guess: Any = None,
        mesh_tol: float | None = None,
        options: Mapping[str, object] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
        **problem: Any,
    ) -> Lap:
        """Return the motion of least time.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            As for `pydy.control.OptimalControl.solve`: values for some symbols, which add to
            `TrackSystem.guess`, or the `motion` of a lap.
        mesh_tol, options, progress, solver
            As for `pydy.control.OptimalControl.solve`.
        **problem
            As for `problem`.

        Returns
        -------
        Lap

        Raises
        ------
        OptimizationError, AnalysisInterrupted, MissingDependencyError
            As `pydy.control.OptimalControl.solve` raises them.
        """
        begin = guess
        if guess is None or isinstance(guess, Mapping):
            begin = self.guess()
            for symbol, pair in self._by_symbol(problem.get("bounds")).items():
                numbers = isinstance(pair, (tuple, list)) and len(pair) == 2
                if symbol in begin and numbers and not any(map(np.ndim, pair)):
                    low, high = (np.nan if v is None else v for v in pair)
                    begin[symbol] = np.fmin(np.fmax(begin[symbol], low), high)
            begin |= self._by_symbol(guess)
        motion = self.problem(**problem).solve(
            begin, mesh_tol=mesh_tol, options=options, progress=progress, solver=solver
        )
        return self.lap(motion)

    def _by_symbol(self, values: Mapping[Any, Any] | None) -> dict[Any, Any]:
        """Return a dictionary with symbols in the place of names of states and controls."""
        symbols = (*self.system.states, *self._controls)
        names = {str(s).removesuffix("(t)"): s for s in symbols}
        return {names.get(k, k): v for k, v in check_mapping("values", values).items()}

    def lap(self, motion: Any) -> Lap:
        """Return a motion of `system`, such as a solution of `problem`, as a lap in the plane.

        Parameters
        ----------
        motion : Trajectory

        Returns
        -------
        Lap
        """
        instance(motion, Trajectory, "`motion`", "a Trajectory over the arc length")
        for name in (*names_of(self.system.states), "pace"):
            if name not in motion.names_of("coordinate", "speed", "output"):
                raise ValueError(
                    f"`motion` must be one of `system`, got {shown(motion)}, which has no {name}."
                )
        return Lap(self.track, self.vehicle, motion, self._position)


def along(
    track: Track,
    system: System,
    *,
    width: float = 0.0,
    periodic: bool | None = None,
    inputs: Sequence[str] | None = None,
    position: Sequence[str] = ("x", "y", "psi"),
) -> TrackSystem:
    """Return a planar vehicle in the curvilinear coordinates of a track.

    In place of the position x, y of a point and the yaw angle ψ, it has the offset n to the left of
    the center line and the angle ξ = ψ − θ; the independent variable is the arc length s of the
    center line. With the components a and b of the point's velocity along the
    center line and across it, ::

        ds/dt = a/(1 − n κ)    dn/ds = b (1 − n κ)/a    dξ/ds = ψ'(1 − n κ)/a − κ

    All other derivatives by time are divided by ds/dt, too. The track's curvature and widths are
    known at each s then, and the length of the motion is known (Perantoni and Limebeer). The
    vehicle moves forward along the track: a > 0.

    Parameters
    ----------
    track : Track
    system : System
        A vehicle on a level road, such as `pydy.vehicles.single_track` with ``free_speed=True``
        returns. What acts on it must not depend on its position and yaw angle, nor on time. It must
        have no constraints.
    width : float, optional
        Of the vehicle (m): half of it is the least distance of its point from the edges.
    periodic : bool, optional
        Whether all states are the same at both ends; by default those of a closed track are.
    inputs : sequence of str, optional
        The specifieds that are controls, by default all; others keep their values, which are
        numbers or expressions.
    position : three of str, optional
        The coordinates x and y of the point, and the yaw angle ψ.

    Returns
    -------
    TrackSystem

    References
    ----------
    G. Perantoni and D. J. N. Limebeer, Optimal control for a Formula One car with variable
    parameters, Vehicle System Dynamics 52(5), 2014, pp. 653–678.

    Examples
    --------
    >>> from pydy.vehicles import CARS, single_track
    >>> from pydy.vehicles.tracks import Track, along
    >>> car = single_track(CARS['bmw_320i'], speed=20.0, free_speed=True)
    >>> on_track = along(Track.oval(200.0, 50.0, width=10.0), car, width=1.6)
    >>> on_track.system.states
    [n(t), xi(t), u(t), v(t), r(t)]
    >>> on_track
    <TrackSystem on <Track: closed, 714.2 m, 10 to 10 m wide>: 5 states, periodic>
    """
    instance(track, Track, "`track`", "a Track, such as read_track returns")
    instance(system, System, "`system`", "a System, such as single_track returns")
    half = positive(width, "`width`", zero=True, finite=True) / 2
    if periodic is not None and not isinstance(periodic, (bool, np.bool_)):
        raise TypeError(f"`periodic` must be True, False or None, got {shown(periodic)}.")
    is_periodic = track.closed if periodic is None else bool(periodic)
    names = names_of(system.coordinates)
    for k, name in enumerate(three_names(position)):
        check_name(name, f"position[{k}]", names)
    if len({*position}) != 3:
        raise ValueError(f"`position` must be three coordinates, got {shown(position)}.")
    specifieds = names_of(system.specifieds_symbols)
    controls = sorted(specifieds) if inputs is None else one_or_more("inputs", inputs)
    for name in controls:
        check_name(name, "inputs", specifieds)
    _check_names(system)
    vehicle = _Planar(system, tuple(system.coordinates[names.index(name)] for name in position))
    check_symmetry(system, vehicle.position)
    t = me.dynamicsymbols._t
    n, xi, curvature = me.dynamicsymbols("n xi curvature")
    ahead, aside, yaw_rate = (vehicle.at(e, xi) for e in vehicle.planar_rates)
    pace = (1 - n * curvature) / ahead
    kinematics = [n.diff() - aside * pace, xi.diff() - yaw_rate * pace + curvature]
    kinematics += [q.diff() - vehicle.at(rate, xi) * pace for q, rate in vehicle.internal]
    accelerations = [vehicle.at(rate, xi) for rate in vehicle.accelerations]
    # Each speed is that of a unit mass on a line of its own, whose force is the derivative by s.
    N, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(N, 0)
    bodies, loads = [], []
    for u, rate in zip(system.speeds, accelerations, strict=True):
        point = me.Point(f"P_{u.func}")
        point.set_vel(N, u * N.x)
        bodies.append(me.Particle(f"mass_{u.func}", point, 1))
        loads.append((point, rate * pace * N.x))
    definition = Definition(
        N,
        [n, xi, *(q for q, _ in vehicle.internal)],
        list(system.speeds),
        bodies=bodies,
        loads=loads,
        kinematic_equations=kinematics,
    )
    outputs = {name: vehicle.at(e, xi) for name, e in vehicle.outputs.items()}
    outputs[sm.Symbol("pace")] = pace
    if "speed" not in map(str, [*outputs, *system.states, *specifieds]):
        outputs[sm.Symbol("speed")] = sm.sqrt(ahead**2 + aside**2)
    samples = track._line.curvature_input()
    fixed = fixed_inputs(system, controls, vehicle.position)
    controlled = tuple(s for s in system.specifieds_symbols if s not in fixed)
    on_track = System(
        definition,
        ode_solver="dop853",
        times=np.linspace(0.0, track.length, 501),
        outputs=outputs,
    )
    unknown = {*map(str, on_track.constants_symbols)}
    on_track.constants = {k: v for k, v in system.constants.items() if str(k) in unknown}
    on_track.specifieds = {**fixed, curvature: samples}
    moving = {*names_of(on_track.states)} - {"n", "xi"}
    initial = {str(k).removesuffix("(t)"): v for k, v in system.initial_conditions.items()}
    on_track.initial_conditions = {k: v for k, v in initial.items() if k in moving}
    end = track.length
    states = list(on_track.states) if is_periodic else []
    boundary = tuple(sm.Eq(s.subs(t, end), s.subs(t, 0)) for s in states)
    right, left = _offsets(track, half)
    x, y, psi = position
    return TrackSystem(
        track, on_track, system, n, xi, sm.Integral(pace, t), is_periodic, dict.fromkeys(states),
        boundary, {n: (right, left), xi: (-np.pi / 2, np.pi / 2)}, (x, y, psi), controlled,
        fixed,
    )  # fmt: skip


def _check_names(system: System) -> None:
    names = {*names_of([*system.states, *system.specifieds_symbols])}
    names |= {*map(str, [*system.constants_symbols, *system.outputs])}
    if taken := sorted(names & {*_NEW}):
        raise ValueError(
            f"`system` has {some(taken)}, but {some(_NEW)} are names of the coordinates along the "
            "track and of its curvature. Use other names in the system."
        )


def _offsets(track: Track, half: float) -> tuple[SampledInput, SampledInput]:
    """Return the least and the largest offset of a point that is `half` away from the edges."""
    s, right, left = track.breaks, track._right.values, track._left.values
    if (right + left <= 2 * half).any():
        k = int((right + left).argmin())
        raise ValueError(
            f"`width` must be less than that of the track, got {2 * half:g}; the track is "
            f"{right[k] + left[k]:g} m wide at s = {s[k]:g} m."
        )
    at = np.union1d(s, track._line.curvature_input().breaks)
    curvature = np.asarray(track.curvature(at))
    at_right, at_left = track.widths(at)
    reach = np.maximum(curvature * (at_left - half), -curvature * (at_right - half))
    if (reach >= 1.0).any():
        k = int(reach.argmax())
        raise ValueError(
            f"`track` is wider than its radius {1 / abs(curvature[k]):.4g} m at s = {at[k]:.6g} m: "
            "points beyond the center of a turn have no coordinates. Use less width at the inner "
            "side, or a center line closer to it."
        )
    return SampledInput(s, half - right), SampledInput(s, left - half)


class _Planar:
    """The equations of a vehicle whose motion depends on neither its position nor its yaw angle."""

    def __init__(self, system: System, position: tuple[Any, ...]) -> None:
        self.system, self.position = system, position
        self.x, self.y, self.psi = position
        equations = system.equations_of_motion()
        check_unconstrained(system, equations.constraint_jacobian)
        rates = dict(zip(equations.coordinates, equations.kinematics, strict=True))
        full = {q: equations.written_out(rate) for q, rate in rates.items()}
        self.planar_rates = [full[q] for q in position]
        self.internal = [(q, full[q]) for q in equations.coordinates if q not in position]
        solved = _solve(equations.mass_matrix, equations.forcing)
        self.accelerations = [equations.written_out(e) for e in solved]
        t = me.dynamicsymbols._t
        derivatives = {q.diff(t): rate for q, rate in full.items()}
        speeds = zip(equations.speeds, self.accelerations, strict=True)
        derivatives |= {u.diff(t): rate for u, rate in speeds}
        self.outputs = {}
        for name, expression in system.outputs.items():
            if isinstance(name, tuple):
                continue
            value = sm.sympify(expression).xreplace(derivatives)
            inside = value.atoms(AppliedUndef)
            if not inside & {self.x, self.y, self.psi} and name not in value.free_symbols | inside:
                self.outputs[sm.Symbol(name) if isinstance(name, str) else name] = value
        check_expressions([*full.values(), *self.accelerations], position)

    def at(self, expression: sm.Expr, xi: sm.Expr) -> sm.Expr:
        """Return an expression at a yaw angle; only speeds in the plane depend on it."""
        return expression.xreplace({self.psi: xi})


def _solve(matrix: sm.Matrix, right: sm.Matrix) -> list[sm.Expr]:
    """Solve M u' = F for a mass matrix, by elimination without pivoting, which needs none."""
    size = matrix.rows
    a = [[matrix[i, j] for j in range(size)] for i in range(size)]
    b = list(right)
    for k in range(size):
        for i in range(k + 1, size):
            if a[i][k] == 0:
                continue
            factor = a[i][k] / a[k][k]
            b[i] -= factor * b[k]
            for j in range(k, size):
                a[i][j] -= factor * a[k][j]
    solution: list[sm.Expr] = [sm.S.Zero] * size
    for k in reversed(range(size)):
        rest = sum((a[k][j] * solution[j] for j in range(k + 1, size)), sm.S.Zero)
        solution[k] = (b[k] - rest) / a[k][k]
    return solution
