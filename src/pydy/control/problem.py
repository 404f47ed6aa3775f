"""OptimalControl: what a user asks, checked and normalised, solved on a mesh."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import sympy as sm

from pydy._assembly.specifieds import followed
from pydy._checks import (
    Places,
    check_mapping,
    choice,
    flag,
    listed,
    number,
    real_array,
    shown,
    whole,
)
from pydy._errors import AnalysisInterrupted, OptimizationError, warn_user
from pydy._names import unique_names
from pydy._optional import progress_of
from pydy._rank import DIGITS, or_one, rank
from pydy.codegen.arguments import checked_expression
from pydy.control.expressions import Reader
from pydy.control.ipopt import SOLVED, Iteration, Solution, solve
from pydy.control.kernel import Equations
from pydy.control.nlp import Nlp
from pydy.control.refine import Moved, interval_errors, refined
from pydy.control.result import OptimalTrajectory
from pydy.control.schemes import METHODS, scheme_of
from pydy.control.transcription import Problem, Transcription
from pydy.control.tuning import MOST_REFINEMENTS
from pydy.inputs import SampledInput
from pydy.trajectory import Trajectory

__all__ = ["OptimalControl"]

_OPEN = (-np.inf, np.inf)


class OptimalControl:
    """The motion of a system that minimises an objective, by direct collocation.

    Specifieds of the system without a value are the controls: they are found, with the states.
    Those with a value (a number, a SymPy expression or a `pydy.inputs.SampledInput`) are known
    signals. Symbols may be given by themselves or by name.

    Parameters
    ----------
    system : System
        Its constants, specifieds and initial conditions are read now.
    objective : SymPy expression
        What is minimised: integrals over the motion, ``sm.Integral(T**2, t)``, values at instants,
        ``q.subs(t, tf)``, constants, and the duration. Integrals may be multiplied with constants
        and with the duration.
    duration : float or Symbol
        In s. The motion begins at t = 0. A Symbol is found, between its `bounds`.
    start, end : dict, optional
        From states to numbers, pairs (low, high), or None for free ones. At the start, states that
        are not given have the system's initial conditions; but with `start`, dependent states that
        it leaves out follow from the constraints. At the end, those not given are free.
    boundary : sequence of relations, optional
        Between values at instants: ``sm.Eq(u.subs(t, tf), u.subs(t, 0))``,
        ``q.subs(t, tf/2) <= 2``.
    path : sequence of relations, optional
        Of states, controls, accelerations, outputs, constants and time, which hold at every
        collocation point.
    bounds : dict, optional
        From states, controls, free constants and the duration to pairs (low, high); None is
        no bound.
    free : sequence of constants, optional
        Constants that are found. The search begins at the system's values.
    mesh : int or array_like, optional
        The number of equal intervals, or ascending nodes, which are scaled to the duration.
    method : {'radau', 'hermite-simpson', 'midpoint', 'backward-euler'}, optional
        Radau has `order` points an interval, and converges with the order 2 `order` − 1 in the
        length of the intervals; the others have the orders 4, 2 and 1.
    order : int, optional
        Of Radau.

    Raises
    ------
    TypeError, ValueError
        An argument is not what it should be; the message names it.
    NotImplementedError
        The system has constraints, and the method is not Radau's, or the system has no bodies; or
        samples are given for a free duration.

    Examples
    --------
    A mass moves one metre in one second with the least ∫ F² dt, which is 12:

    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.control import OptimalControl
    >>> from pydy.mechanics import Definition
    >>> x, v, F = me.dynamicsymbols('x v F')
    >>> t = me.dynamicsymbols._t
    >>> ground, rest = me.ReferenceFrame('N'), me.Point('O')
    >>> rest.set_vel(ground, 0)
    >>> mass = rest.locatenew('P', x*ground.x)
    >>> system = System(Definition(ground, [x], [v], bodies=[me.Particle('mass', mass, 1)],
    ...                            loads=[(mass, F*ground.x)]))
    >>> problem = OptimalControl(system, sm.Integral(F**2, t), 1.0, end={x: 1.0, v: 0.0})
    >>> solution = problem.solve()
    >>> round(solution.objective, 6), solution[F][[0, -1]].round(6).tolist()
    (12.0, [6.0, -6.0])
    """

    def __init__(
        self,
        system: Any,
        objective: Any,
        duration: Any,
        *,
        start: Mapping[Any, Any] | None = None,
        end: Mapping[Any, Any] | None = None,
        boundary: Iterable[Any] = (),
        path: Iterable[Any] | None = None,
        bounds: Mapping[Any, Any] | None = None,
        free: Iterable[Any] = (),
        mesh: Any = 20,
        method: str = "radau",
        order: int = 3,
    ) -> None:
        if not hasattr(system, "_now"):
            raise TypeError(f"`system` must be a pydy.system.System, got {shown(system)}.")
        self._now = now = system._now()
        definition, plan = now.definition, now.plan
        equations, time = definition.equations, definition.equations.time
        if plan.functions:
            raise ValueError(
                f"`specifieds` gives a Python function for {plan.functions[0][2]}, which has no "
                "derivatives. Give an expression of time and states, or a SampledInput; a "
                "specified without a value is a control."
            )
        self._method = choice(method, METHODS, "`method`")
        if equations.constrained and self._method not in ("radau", "backward-euler"):
            raise NotImplementedError(
                f"`method` is {self._method!r}, which does not treat systems with constraints: the "
                "points of such methods do not include the ends of intervals only. Use 'radau'."
            )
        self._scheme = scheme_of(self._method, whole(order, "`order`"))
        self._mesh = _checked_mesh(mesh)
        given = plan.given | followed(definition, plan)
        self._controls = tuple(s for s in definition.specifieds if s not in given)
        constants = definition.places["constants"]
        self._free = tuple(
            constants.symbols[k] for k in constants.columns(listed("free", free), "free")
        )
        self._symbol = duration if isinstance(duration, sm.Symbol) else None
        self._duration = None if self._symbol is not None else _positive(duration)
        if self._symbol is not None and self._symbol in (*definition.constants, time):
            raise ValueError(
                f"`duration` is `{duration}`, which the equations hold already. Give the duration "
                "a symbol of its own."
            )
        if self._duration is None and plan.sampled:
            names = ", ".join(str(definition.specifieds[k]) for k in plan.sampled[0][0])
            raise NotImplementedError(
                f"`specifieds` gives samples for {names}, and the duration is free: samples are "
                "taken at known times. Give an expression of time, or a number as `duration`."
            )
        if plan.sampled:
            plan.check_times(np.array([0.0, self._duration]), "duration")
        last = () if self._symbol is None else (self._symbol,)
        self._unknown = Places(
            (*definition.states, *self._controls, *self._free, *last), "unknowns of the problem"
        )
        self._start = self._limits("start", start, definition.states)
        self._end = self._limits("end", end, definition.states)
        self._bounds = self._limits("bounds", bounds, self._unknown.symbols)
        # Those that follow from the constraints, where `start` changes others.
        dependent = {*equations.dependent_coordinates, *equations.dependent_speeds}
        left = dependent - {*self._start} if self._start else ()
        self._following = tuple(s for s in definition.states if s in left)
        for s, value in zip(definition.states, now.x.tolist(), strict=True):
            self._start.setdefault(s, _OPEN if s in self._following else (value, value))
        known = {*definition.constants, *last}
        reader = Reader(time, definition.states, self._controls, known, duration)
        running, terminal = reader.objective(checked_expression(objective, "`objective`"))
        conditions = reader.conditions("boundary", listed("boundary", boundary, "relations"))
        path = listed("path", () if path is None else path, "relations")
        if equations.velocity and equations.constraint_forces is None:
            raise NotImplementedError(
                "The system has constraints, and equations without bodies. Optimal control of "
                "constrained systems needs the bodies and loads: give them to the method, and "
                "leave out `equations='method'`."
            )
        made = Equations.of(now)
        if made.are_of(made.constraints, [definition.specifieds.index(s) for s in self._controls]):
            raise NotImplementedError(
                "The constraints hold a control, which has no value at the start. Give that "
                "specified a value, or make it a state whose derivative is the control."
            )
        labels = _labels(definition)
        held = _constraint_labels(equations)
        self._fixed = all(low == high for low, high in self._start.values())
        self._problem = Problem(
            equations=made,
            states=len(definition.states),
            labels=labels,
            constraints=() if self._fixed else tuple(f"{label} at the start" for label in held),
            controls=tuple(definition.specifieds.index(s) for s in self._controls),
            control_bounds=np.array(
                [self._bounds.get(s, _OPEN) for s in self._controls], dtype=float
            ).reshape(-1, 2),
            signals=tuple(
                (int(column), _signal(samples, k))
                for columns, samples in plan.sampled
                for k, column in enumerate(columns)
            ),
            free=tuple(definition.constants.index(s) for s in self._free),
            constants=now.p,
            specifieds=plan.values,
            duration=self._duration,
            duration_symbol=self._symbol,
            symbols={s: k for k, s in enumerate(definition.constants)},
            running=running,
            terminal=terminal,
            instants=tuple(reader.instants),
            boundary=conditions,
            path=reader.path("path", path),
        )

    def __repr__(self) -> str:
        unknown = ", ".join(unique_names(self._controls)) or "none"
        return (
            f"<OptimalControl: {self._problem.states} states, controls {unknown}, "
            f"{self._method} on {len(self._mesh) - 1} intervals>"
        )

    def _limits(self, argument: str, given: Any, symbols: Any) -> dict[Any, tuple[float, float]]:
        """Return pairs of numbers by symbol."""
        places = Places(tuple(symbols), "unknowns of the problem")
        values = check_mapping(argument, given)
        columns = places.columns(values, argument)
        found = {}
        for k, (key, value) in zip(columns, values.items(), strict=True):
            found[places.symbols[k]] = _pair(value, f"`{argument}[{key}]`", argument != "bounds")
        return found

    # -- before the search ------------------------------------------------------------------------

    def check(self, guess: Any = None) -> None:
        """Raise what is wrong with the problem before it is solved.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            As for `solve`.

        Raises
        ------
        ValueError
            Ends that contradict bounds, a guess outside of bounds, a free duration without bounds
            and guess, or fewer unknowns than equations.
        """
        self._prepared(Transcription(self._problem, self._scheme, self._mesh), guess)

    def _prepared(self, made: Transcription, guess: Any) -> tuple[Nlp, np.ndarray]:
        """Return the program and where to start."""
        lower, upper = self._bounds_of(made)
        z = self._guess(made, guess, lower, upper)
        nlp = made.nlp(lower, upper, self._sizes(made, z, lower, upper))
        self._check_start(made, z)
        low, high = nlp.row_bounds
        equal, unknown = int((low == high).sum()), int((lower < upper).sum())
        if equal > unknown:
            raise ValueError(
                f"The problem has {equal} equations for {unknown} unknowns on this mesh: there is "
                "nothing left to choose. Free some of the `start` or `end`, or leave a specified "
                "without a value, which makes it a control."
            )
        return nlp.in_own_units(z), z

    def _check_start(self, made: Transcription, z: np.ndarray) -> None:
        """Refuse a start that violates the constraints, or that they do not determine."""
        if not self._problem.equations.constraints:
            return
        begin = made.beginning()
        rows, states = np.empty((begin.rows, 1)), self._now.definition.states
        X, P, f = z[begin.at], self._problem.numbers, begin.functions
        f("rows", X, begin.data, P, rows)
        J = np.zeros((begin.rows, len(X)))
        slopes = np.empty((len(f.jacobian_at), 1))
        f("jacobian", X, begin.data, P, slopes)
        J[tuple(f.jacobian_at.T)] = slopes[:, 0]
        sizes = self._sizes(made, z, *self._bounds_of(made))[begin.at[:, 0]]
        terms = np.abs(J) @ sizes
        if self._fixed and (np.abs(rows[:, 0]) > DIGITS * terms).any():
            at = int(np.argmax(np.abs(rows[:, 0]) - DIGITS * terms))
            raise ValueError(
                f"The start does not satisfy the constraints: `{begin.labels[at]}` is "
                f"{rows[at, 0]:.3g}. Call `system.set_dependent_initial_conditions`, or free "
                "states that follow from others: start={symbol: None}."
            )
        columns = [k for k, s in enumerate(states) if s in self._following]
        if columns and rank(J[:, columns] * sizes[columns]) < len(columns):
            names = ", ".join(str(states[k]) for k in columns)
            raise ValueError(
                f"`start` leaves out {names}, which the constraints do not determine there: the "
                "configuration is singular for them. Give all states in `start`."
            )

    def _bounds_of(self, made: Transcription) -> tuple[np.ndarray, np.ndarray]:
        """Return the bounds of the unknowns."""
        states, controls = self._now.definition.states, self._controls
        slots, own = len(made.places[0]), len(made.control_places)
        M, slopes = made.intervals, made.places[1]
        sides = []
        for side, pick in ((0, max), (1, min)):
            x, u = (
                np.empty((len(states), slots)),
                np.full((self._problem.algebraic, own), _OPEN[side]),
            )
            for k, s in enumerate(states):
                limit = self._bounds.get(s, _OPEN)[side]
                x[k] = np.where(slopes, _OPEN[side], limit)
                x[k, 0] = pick(limit, self._start[s][side])
                x[k, M] = pick(limit, self._end.get(s, _OPEN)[side])
            for k, s in enumerate(controls):
                u[k] = self._bounds.get(s, _OPEN)[side]
            constants = [self._bounds.get(s, _OPEN)[side] for s in self._free]
            least = self._bounds.get(self._symbol, _OPEN)[side]
            sides.append(made.joined(x, u, constants, least if side else max(least, 0.0)))
        lower, upper = sides
        for k, s in enumerate(states):
            for place, end in ((0, "start"), (M, "end")):
                if lower[k * slots + place] > upper[k * slots + place]:
                    given = (self._start if end == "start" else self._end)[s]
                    raise ValueError(
                        f"`{end}[{s}]` is {_shown_pair(given)}, which the `bounds` "
                        f"{_shown_pair(self._bounds[s])} exclude."
                    )
        return lower, upper

    def _guess(
        self, made: Transcription, given: Any, lower: np.ndarray, upper: np.ndarray
    ) -> np.ndarray:
        """Return where to start: what is given, else straight lines between the ends."""
        guess = _Guess(self, given)
        duration = guess.duration(self._bounds.get(self._symbol, _OPEN))
        places, slopes = made.places
        x = np.empty((self._problem.states, len(places)))
        for k, s in enumerate(self._now.definition.states):
            values = guess.values(s, places, duration)
            if values is None:
                first = _middle(self._start[s], float(self._now.x[k]))
                last = _middle(self._end.get(s, _OPEN), first)
                values = np.interp(places, [0.0, 1.0], [first, last])
            x[k] = values
            if slopes.any():
                x[k, slopes] = np.gradient(x[k, ~slopes], made.mesh * duration)
        u = np.zeros((self._problem.algebraic, len(made.control_places)))
        for k, s in enumerate(self._controls):
            values = guess.values(s, made.control_places, duration)
            u[k] = 0.0 if values is None else values
        constants = [
            guess.number(s, self._problem.constants[k])
            for s, k in zip(self._free, self._problem.free, strict=True)
        ]
        z = made.joined(x, u, constants, duration)
        guess.check_bounds(made, z, lower, upper)
        begin: np.ndarray = np.clip(z, lower, upper)
        return begin

    def _sizes(
        self, made: Transcription, z: np.ndarray, lower: np.ndarray, upper: np.ndarray
    ) -> np.ndarray:
        """Return how large each unknown becomes, by what is known of it.

        That is its guess, its ends and bounds. What is zero everywhere gets the size at which it
        decides one of the equations, whose terms are then of known size: the speed that covers a
        known distance in the duration, the force that brings it about.
        """
        known = [np.where(np.isfinite(v), np.abs(v), 0.0) for v in (z, lower, upper)]
        parts = [made.split(value) for value in known]
        x = np.max([p[0].max(axis=1, where=~made.places[1], initial=0.0) for p in parts], axis=0)
        u = np.max([p[1].max(axis=1, initial=0.0) for p in parts], axis=0)
        c = np.max([p[2] for p in parts], axis=0)
        duration = made.split(z)[3]
        x, u = self._inferred(z, made, x, u, or_one(c), duration)
        slopes = np.where(made.places[1], 1.0 / duration, 1.0)
        return made.joined(
            x[:, None] * slopes, np.repeat(u[:, None], len(made.control_places), 1), or_one(c),
            duration,
        )  # fmt: skip

    def _inferred(
        self, z: np.ndarray, made: Transcription, x: np.ndarray, u: np.ndarray, c: np.ndarray,
        duration: float,
    ) -> tuple[np.ndarray, np.ndarray]:  # fmt: skip
        """Return sizes of states and controls where zeros are found from the equations."""
        sizes = np.concatenate([x, u])
        if (sizes > 0.0).all():
            return x, u
        # The equations of a single interval: its derivatives are changes in the whole duration.
        whole = Transcription(self._problem, self._scheme, np.array([0.0, 1.0]))
        times = [whole.places[0], whole.control_places]
        _, _, constants, _ = made.split(z)
        states = np.where(whole.places[1], 0.0, made.states_at(z, times[0] * duration).T)
        controls = np.zeros((self._problem.algebraic, len(times[1])))
        controls[: len(self._controls)] = made.controls_at(z, times[1] * duration).T
        one = whole.joined(states, controls, constants, duration)
        everywhere = np.full(len(one), np.inf)
        nlp = whole.nlp(-everywhere, everywhere, np.ones(len(one)))
        values = np.empty(len(nlp.jacobian_at[0]))
        nlp.jacobian(one, values)
        n, width = self._problem.states, len(sizes)
        owner = np.concatenate([np.repeat(np.arange(n), len(times[0])),
                                n + np.repeat(np.arange(width - n), len(times[1]))])  # fmt: skip
        owner = np.append(owner, np.full(len(one) - len(owner), width))
        slope = np.tile(whole.places[1], n)
        table = np.zeros((nlp.rows, width + 1))
        rows, columns = nlp.jacobian_at
        weights = np.ones(len(one))
        weights[: len(slope)][slope] = 1.0 / duration
        entries = np.abs(np.nan_to_num(values)) * weights[columns]
        np.maximum.at(table, (rows, owner[columns]), entries)
        table = table[:, :width]
        for _ in range(width):
            reach = (table * sizes).max(axis=1, initial=0.0)
            need = np.where((table > 0.0) & (reach[:, None] > 0.0),
                            reach[:, None] / np.where(table > 0.0, table, 1.0), np.inf)  # fmt: skip
            found = need.min(axis=0, initial=np.inf)
            new = (sizes == 0.0) & np.isfinite(found)
            if not new.any():
                break
            sizes = np.where(new, found, sizes)
        sizes = or_one(sizes)
        return sizes[:n], sizes[n:]

    # -- the search -------------------------------------------------------------------------------

    def solve(
        self,
        guess: Any = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, Any] | None = None,
        progress: bool = False,
    ) -> OptimalTrajectory:
        """Find the motion.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            Where the search begins: from states, controls, free constants and the duration to
            numbers, to arrays of samples at equal distances over the motion, or to SampledInputs;
            or a motion, such as a simulation or the solution of a similar problem. By default
            states lie on straight lines between the ends, and controls are zero.
        mesh_tol : float, optional
            The mesh is refined until the `error` of each interval is below it. By default the mesh
            stays as it is.
        options : dict, optional
            Options of IPOPT, such as ``{'max_iter': 500, 'tol': 1e-10}``.
        progress : bool, optional
            Whether to show the iterations; requires tqdm.

        Returns
        -------
        OptimalTrajectory

        Raises
        ------
        OptimizationError
            The search did not converge; the error holds the motion where it ended.
        AnalysisInterrupted
            The user interrupted it; the error holds the motion of the latest iteration.
        ValueError
            What `check` raises.
        MissingDependencyError
            IPOPT is not installed: ``pip install 'pydy[optimal]'``.
        """
        own = check_mapping("options", options)
        tolerance = None if mesh_tol is None else _positive(mesh_tol, "`mesh_tol`")
        mesh = self._mesh
        with progress_of(flag(progress, "`progress`"), " iterations") as told:
            for _ in range(MOST_REFINEMENTS):
                found = self._solved(mesh, guess, own, told)
                worst = float(found.error.max())
                if tolerance is None or worst <= tolerance:
                    return found
                order = self._scheme.convergence
                mesh, guess = refined(mesh, found.error, tolerance, order), found
        warn_user(
            f"After {MOST_REFINEMENTS} refinements the mesh of {len(found.mesh) - 1} intervals "
            f"has an error of {worst:.2g}, above `mesh_tol` = {tolerance:g}. Where controls jump, "
            "nodes of `mesh` near the jumps help; so does a larger `mesh_tol`."
        )
        return found

    def _solved(
        self, mesh: np.ndarray, guess: Any, options: dict[str, Any], told: Any
    ) -> OptimalTrajectory:
        """Return the motion on a mesh."""
        made = Transcription(self._problem, self._scheme, mesh)
        nlp, z = self._prepared(made, guess)

        def watch(iteration: Iteration) -> None:
            told(1, objective=f"{iteration.objective:.6g}", gap=f"{iteration.violation:.2g}")

        solution = solve(nlp, z, options=options, watch=watch)
        trajectory = self._trajectory(made, nlp, solution)
        if solution.interrupted:
            raise AnalysisInterrupted(
                "The search for an optimal trajectory was interrupted. Its latest iteration is in "
                "the attribute `results` of this error.",
                trajectory,
            )
        if solution.status not in SOLVED:
            raise OptimizationError(
                f"The search for an optimal trajectory ended after {len(solution.history) - 1} "
                f"iterations: {trajectory.message}. {_worst(nlp, solution, trajectory)}",
                trajectory,
            )
        return trajectory

    def _trajectory(self, made: Transcription, nlp: Nlp, solution: Solution) -> OptimalTrajectory:
        now = self._now
        p = now.p.copy()
        p[list(self._problem.free)] = made.split(solution.z)[2]
        moved = Moved(now.driven.compiled("rates"), now.plan, p)
        sizes = made.split(nlp.sizes)[0][:, 0]
        error = interval_errors(moved, made, solution.z, sizes)
        return OptimalTrajectory(now, made, self._controls, self._free, nlp, solution, error)


class _Guess:
    """Where a search begins, as the user gives it."""

    def __init__(self, problem: OptimalControl, given: Any) -> None:
        self._problem = problem
        self._motion: Trajectory | None = None
        self._values: dict[Any, Any] = {}
        if isinstance(given, Trajectory):
            self._motion = given
        else:
            values = check_mapping("guess", given)
            columns = problem._unknown.columns(values, "guess")
            symbols = [problem._unknown.symbols[k] for k in columns]
            self._values = dict(zip(symbols, values.values(), strict=True))

    def duration(self, bounds: tuple[float, float]) -> float:
        """Return the duration to begin with."""
        problem = self._problem
        if problem._duration is not None:
            return problem._duration
        symbol = problem._symbol
        if self._motion is not None:
            return float(self._motion.times[-1] - self._motion.times[0])
        if symbol in self._values:
            return _positive(self._values[symbol], f"`guess[{symbol}]`")
        if not np.isfinite(bounds).all():
            raise ValueError(
                f"The duration `{symbol}` is free: give `bounds` for it, {{{symbol}: (low, high)}},"
                f" or where the search begins, guess={{{symbol}: ...}}."
            )
        return float(np.mean(bounds))

    def values(self, symbol: Any, fractions: np.ndarray, duration: float) -> np.ndarray | None:
        """Return a state or control at some times, or None."""
        if self._motion is not None:
            if symbol not in self._motion:
                return None
            first, last = self._motion.times[[0, -1]]
            order = np.argsort(fractions, kind="stable")
            times = np.clip(first + fractions[order] * (last - first), first, last)
            found = np.empty(len(fractions))
            found[order] = self._motion.at(times)[symbol]
            return found
        if symbol not in self._values:
            return None
        value = self._values[symbol]
        what = f"`guess[{symbol}]`"
        if isinstance(value, SampledInput):
            if value.size != 1:
                raise ValueError(f"{what} must be samples of one value, got {value.size} a time.")
            samples: np.ndarray = value.rows(fractions * duration)[:, 0]
            return samples
        samples = np.atleast_1d(real_array(value, what))
        if samples.ndim != 1 or not len(samples) or not np.isfinite(samples).all():
            raise ValueError(
                f"{what} must be a finite number, or a row of them, got {shown(value)}."
            )
        even = np.linspace(0.0, 1.0, num=len(samples))
        between: np.ndarray = np.interp(fractions, even, samples)
        return between

    def number(self, symbol: Any, known: float) -> float:
        """Return a free constant to begin with."""
        if self._motion is not None:
            return float(self._motion.constants.get(symbol, known))
        return number(self._values.get(symbol, known), f"`guess[{symbol}]`", finite=True)

    def check_bounds(
        self, made: Transcription, z: np.ndarray, lower: np.ndarray, upper: np.ndarray
    ) -> None:
        """Refuse what is given and lies outside of bounds, between the ends."""
        parts = [made.split(value) for value in (z, lower, upper)]
        problem, M = self._problem, made.intervals
        states = problem._now.definition.states
        inner = ~made.places[1]
        inner[[0, M]] = False  # the ends are where `start` and `end` say
        rows: list[tuple[Any, list[np.ndarray]]] = []
        rows += [(s, [p[0][k][inner] for p in parts]) for k, s in enumerate(states)]
        rows += [(s, [p[1][k] for p in parts]) for k, s in enumerate(problem._controls)]
        rows += [(s, [p[2][k : k + 1] for p in parts]) for k, s in enumerate(problem._free)]
        rows.append((problem._symbol, [np.array([p[3]]) for p in parts]))
        for symbol, (values, low, high) in rows:
            outside = (values < low) | (values > high)
            if symbol in self._values and outside.any():
                raise ValueError(
                    f"`guess[{symbol}]` must lie within its `bounds`, "
                    f"{_shown_pair(problem._bounds.get(symbol, _OPEN))}, got "
                    f"{float(values[outside][0])!r}."
                )


def _positive(value: Any, what: str = "`duration`") -> float:
    result = number(value, what, finite=True)
    if not result > 0.0:
        hint = ", or a Symbol for one that is found" if what == "`duration`" else ""
        raise ValueError(f"{what} must be positive{hint}, got {result!r}.")
    return result


def _checked_mesh(mesh: Any) -> np.ndarray:
    """Return the nodes as fractions."""
    if np.ndim(mesh) == 0:
        return np.linspace(0.0, 1.0, num=whole(mesh, "`mesh`") + 1)
    nodes = real_array(mesh, "`mesh`")
    if nodes.ndim != 1 or len(nodes) < 2 or not np.isfinite(nodes).all():
        raise ValueError(
            "`mesh` must be a number of intervals, or at least two finite nodes, got "
            f"{shown(mesh)}."
        )
    if (np.diff(nodes) <= 0.0).any():
        at = int(np.flatnonzero(np.diff(nodes) <= 0.0)[0]) + 1
        raise ValueError(
            f"`mesh` must ascend, got {float(nodes[at])} after {float(nodes[at - 1])}."
        )
    fractions: np.ndarray = (nodes - nodes[0]) / (nodes[-1] - nodes[0])
    return fractions


def _pair(value: Any, what: str, single: bool) -> tuple[float, float]:
    """Return bounds, of which None is none; a single number is both where that is allowed."""
    if value is None:
        return _OPEN
    if not isinstance(value, (tuple, list)) and not (
        isinstance(value, np.ndarray) and value.ndim == 1
    ):
        if not single:
            raise ValueError(f"{what} must be a pair (low, high), got {shown(value)}.")
        both = number(value, what, finite=True)
        return both, both
    if len(value) != 2:
        raise ValueError(f"{what} must be a pair (low, high), got {shown(value)}.")
    low, high = (
        end if entry is None else number(entry, what)
        for entry, end in zip(value, _OPEN, strict=True)
    )
    if not low <= high or low == np.inf or high == -np.inf:
        raise ValueError(f"{what} must be a pair with low <= high, got {shown(value)}.")
    return low, high


def _middle(limits: tuple[float, float], otherwise: float) -> float:
    """Return the middle of limits, or the value nearest to another where one is missing."""
    low, high = limits
    if np.isfinite(low) and np.isfinite(high):
        return 0.5 * (low + high)
    return min(max(otherwise, low), high)


def _shown_pair(limits: tuple[float, float]) -> str:
    low, high = (None if np.isinf(value) else value for value in limits)
    return repr(low) if low == high else f"({low!r}, {high!r})"


def _signal(samples: SampledInput, column: int) -> Any:
    return lambda times: samples.rows(times)[:, column]


def _labels(definition: Any) -> tuple[str, ...]:
    """Return what to call the equation of each state."""
    equations = definition.equations
    coordinates, speeds, others = (
        unique_names(part)
        for part in (equations.coordinates, equations.speeds, definition.auxiliaries)
    )
    return (
        *(f"kinematics of {name}" for name in coordinates),
        *(f"motion of {name}" for name in speeds),
        *(f"integral {name}" for name in others),
        *_constraint_labels(equations),
    )


def _constraint_labels(equations: Any) -> tuple[str, ...]:
    """Return what to call the constraints, those of positions first."""
    return (
        *(f"constraint {k} of positions" for k in equations.enforced),
        *(f"constraint {k} of velocities" for k in range(len(equations.velocity))),
    )


def _worst(nlp: Nlp, solution: Solution, trajectory: OptimalTrajectory) -> str:
    """Name the equations that are violated most, in units of their sizes."""
    y = solution.z / nlp.sizes
    values = np.empty(nlp.rows)
    nlp.values(y, values)
    low, high = (side / nlp.row_sizes for side in nlp.row_bounds)
    violated = np.nan_to_num(np.maximum(np.maximum(low - values, values - high), 0.0), nan=np.inf)
    found, start = [], 0
    for piece in nlp.pieces:
        for label in piece.labels:
            part = violated[start : start + piece.points]
            start += piece.points
            at = int(part.argmax())
            when = piece.fractions[at] * trajectory.duration
            place = "" if np.isnan(when) else f" at t = {when:.6g}"
            found.append((float(part[at]), f"{label}{place}, by {part[at]:.2g}"))
    found.sort(key=lambda pair: -pair[0])
    return (
        "Violated most, in units of each equation's size: "
        + "; ".join(text for _, text in found[:3])
        + ". Another `guess`, wider `bounds` or a finer `mesh` may help."
    )
