"""OptimalControl: a user's problem, checked and normalised, and its solution on a mesh."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._assembly import Definition, followed
from pydy._checks import (
    SymbolIndex,
    check_mapping,
    choice,
    describe,
    instance,
    integer,
    listed,
    number,
    shown,
)
from pydy._errors import OptimizationError
from pydy._judges import warn_of_missing_derivatives
from pydy._names import counted, some, unique_names
from pydy._problem import with_settings
from pydy._rank import DIGITS, rank
from pydy.codegen import SpecifiedsPlan, checked_expression
from pydy.control.expressions import ExpressionReader, bends
from pydy.control.guess import Guess, Limit, follow_constraints, limit, shown_pair
from pydy.control.ipopt import NlpSolution
from pydy.control.jumps import (
    Expressions,
    Range,
    branching,
    jumping_conditions,
    refuse_jumps,
    warn_of_crossings,
)
from pydy.control.kernel import ImplicitEquations, violated
from pydy.control.kinks import epigraph, split
from pydy.control.nlp import Nlp
from pydy.control.phases import Phases
from pydy.control.refine import (
    RateFunction,
    checked_mesh,
    interval_errors,
    knots,
    propagated_errors,
    refined,
    refuse_singular,
    refuse_unsolvable,
)
from pydy.control.result import OptimalTrajectory
from pydy.control.schemes import METHODS, scheme_of
from pydy.control.search import ModelledSystem, TrajectorySearch
from pydy.control.transcription import TranscribedProblem, Transcription
from pydy.control.tuning import LARGEST_ORDER
from pydy.inputs import SampledInput

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol, SymbolOrName

_OPEN = (-np.inf, np.inf)
_FREE = (Limit(-np.inf), Limit(np.inf))


class OptimalControl(TrajectorySearch[OptimalTrajectory]):
    """The motion of a system that minimises an objective, by direct collocation.

    Specifieds of the system without a value are the controls, which are solved for with the states.
    Those with a value (a number, a SymPy expression or a `pydy.inputs.SampledInput`) are known
    signals; samples must cover the longest duration allowed. Names may stand in place of symbols.

    Parameters
    ----------
    system : System
        Its constants, specifieds and initial conditions are read now.
    objective : SymPy expression
        The objective to minimise, of integrals over the motion, ``sm.Integral(T**2, t)``, values at
        instants, ``q.subs(t, tf)``, constants, and the duration. Integrals may be multiplied with
        constants and with the duration.
    duration : float or Symbol
        In s. The motion begins at t = 0. A Symbol is an unknown, with `bounds`.
    start, end : dict, optional
        From states to numbers, pairs (low, high), or None for free ones. At the start, other states
        have the system's initial conditions; but if `start` is given, the constraints determine
        dependent states that it omits. At the end, other states are free.
    boundary : sequence of relations, optional
        Between values at instants: ``sm.Eq(u.subs(t, tf), u.subs(t, 0))``,
        ``q.subs(t, tf/2) <= 2``.
    path : sequence of relations, optional
        Of states, controls, accelerations, outputs, constants and time, to be satisfied at every
        collocation point.
    bounds : dict, optional
        From states, controls, free constants and the duration to pairs (low, high); None means
        unbounded. Bounds of states and controls may be arrays of values at equal distances over the
        motion, or `pydy.inputs.SampledInput`.
    free : sequence of constants, optional
        Constants that are unknowns, with the system's values as a guess. The guess of a symbol that
        occurs only in the objective and the conditions is 1, or the middle of its `bounds`.
    mesh : int or array_like, optional
        The number of equal intervals, or ascending nodes, which are scaled to the duration.
        Instants of `objective` and `boundary` inside the motion become nodes too, and so do up to
        four jumps of known inputs an interval.
    method : {'radau', 'hermite-simpson', 'midpoint', 'backward-euler'}, optional
        Radau has `order` points an interval, and converges with the order 2 `order` − 1 in the
        length of the intervals; the others have the orders 4, 2 and 1.
    order : int, optional
        Of Radau.
    hessian : {'exact', 'gauss-newton', 'lbfgs'}, optional
        Second derivatives: exact; approximated from first derivatives, for an objective that is a
        sum of squares, without the curvature of the equations; or estimated during the search. The
        last two need more iterations, but compile faster.

    Raises
    ------
    TypeError, ValueError
        An argument is invalid; the message names it.
    NotImplementedError
        The system has constraints and no bodies.

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

    _latest: Transcription | None = None

    def __init__(
        self,
        system: ModelledSystem,
        objective: sm.Expr,
        duration: float | sm.Symbol,
        *,
        start: Mapping[Any, object] | None = None,
        end: Mapping[Any, object] | None = None,
        boundary: Iterable[sm.Basic] = (),
        path: Iterable[sm.Basic] | None = None,
        bounds: Mapping[Any, object] | None = None,
        free: Iterable[SymbolOrName] = (),
        mesh: int | ArrayLike = 20,
        method: str = "radau",
        order: int = 3,
        hessian: str = "exact",
    ) -> None:
        if not hasattr(system, "_now"):
            raise TypeError(f"`system` must be a pydy.system.System, got {shown(system)}.")
        free, boundary = listed("free", free), listed("boundary", boundary, "relations")
        path = listed("path", () if path is None else path, "relations")
        self._extra_constants = _extra_constants(
            system._now().definition, free, (objective, *boundary, *path), duration
        )
        self._snapshot = snapshot = system._now(further=self._extra_constants)
        warn_of_missing_derivatives(snapshot)
        definition, plan = snapshot.definition, snapshot.plan
        self._method = choice(method, METHODS, "`method`")
        points = integer(order, "`order`")
        if points > LARGEST_ORDER:
            raise ValueError(
                f"`order` must be at most {LARGEST_ORDER}, got {points}. Use more intervals."
            )
        self._scheme = scheme_of(self._method, points)
        self._mesh = checked_mesh(mesh)
        self._controls = _controls_of(definition, plan)
        constants = definition.places["constants"]
        self._free = tuple(constants.chosen(free, "free"))
        self._duration, self._symbol = _duration_of(duration, definition)
        last = () if self._symbol is None else (self._symbol,)
        self._unknown = SymbolIndex(
            (*definition.states, *self._controls, *self._free, *last), "unknowns of the problem"
        )
        self._start = self._limits("start", start, definition.states)
        self._end = self._limits("end", end, definition.states)
        self._bounds = self._read_bounds(bounds)
        if not (lengths := self._bounds_at(self._symbol))[1] > 0.0:
            raise ValueError(
                f"`bounds[{self._symbol}]` must allow a positive duration, got "
                f"{shown_pair(lengths)}."
            )
        self._bends = self._check_samples(plan)
        self._begins = frozenset(self._start)
        # Dependent states that the constraints determine, if `start` changes others.
        equations = definition.equations
        dependent = {*equations.dependents.coordinates, *equations.dependents.speeds}
        unspecified = dependent - {*self._start} if self._start else ()
        self._following = tuple(s for s in definition.states if s in unspecified)
        for s, value in zip(definition.states, snapshot.x.tolist(), strict=True):
            self._start.setdefault(s, _OPEN if s in self._following else (value, value))
        states, numbers = definition.states, {*definition.constants, *last}
        reader = ExpressionReader(equations.time, states, self._controls, numbers, duration)
        self._problem = self._read(reader, objective, boundary, path, hessian)
        self._as_written = self._problem
        refuse_jumps(expressions := self._expressions())
        self._switches = expressions.switch
        self._lift_kinks()
        # Costates jump at instants, and rates where known inputs jump: both must be nodes.
        breaks = [i.fraction for i in self._problem.instants if 0.0 < i.fraction < 1.0]
        jumping = tuple(s for s in self._problem.signals if s[1].interpolation == "previous")
        initial = Transcription(replace(self._problem, signals=jumping), self._scheme, self._mesh)
        breaks += knots(initial, np.full(initial.intervals, np.inf), 0.0).tolist()
        self._mesh = refined(self._mesh, np.zeros(initial.intervals), 1.0, 1, breaks)

    def _read(
        self, reader: ExpressionReader, objective: sm.Expr, boundary: Sequence[sm.Basic],
        path: Sequence[sm.Basic], hessian: str,
    ) -> TranscribedProblem:  # fmt: skip
        """Return the problem as data."""
        snapshot, definition, plan = self._snapshot, self._snapshot.definition, self._snapshot.plan
        position = definition.specifieds.index
        objective = checked_expression(objective, "`objective`").xreplace(branching(definition))
        instance(objective, sm.Expr, "`objective`", "an expression or a number")
        running, terminal = reader.objective(objective)
        second = choice(hessian, ("exact", "gauss-newton", "lbfgs"), "`hessian`")
        squares = [reader.squares(e) for e in (running, terminal) if second == "gauss-newton"]
        if squares and not any(squares):
            raise ValueError(
                "`hessian` is 'gauss-newton', but `objective` has no squares. Use 'exact', or "
                "'lbfgs'."
            )
        conditions = reader.boundary(boundary)
        implicit = ImplicitEquations.from_snapshot(snapshot)
        inequalities = reader.path("path", path)
        reader.check_functions("`path`", [c.expression for c in inequalities], implicit.atoms)
        reader.check_functions("`objective`", [running], implicit.atoms)
        if implicit.depend_on(implicit.constraints, map(position, self._controls)):
            raise NotImplementedError(
                "The constraints hold a control, which has no value at the start. Give that "
                "specified a value, or make it a state whose derivative is the control."
            )
        labels, constraint_labels = labels_of(definition)
        self._fixed = all(low == high for low, high in self._start.values())
        self._start_constraints = tuple(f"{label} at the start" for label in constraint_labels)
        return TranscribedProblem(
            equations=implicit,
            states=len(definition.states),
            labels=labels,
            constraints=() if self._fixed else self._start_constraints,
            controls=tuple(map(position, self._controls)),
            control_bounds=tuple(self._bounds.get(s, _FREE) for s in self._controls),
            state_bounds=tuple(self._bounds.get(s, _FREE) for s in definition.states),
            signals=plan.inputs.sampled,
            free=tuple(map(definition.constants.index, self._free)),
            constants=snapshot.p,
            specifieds=plan.inputs.values,
            duration=self._duration,
            duration_symbol=self._symbol,
            symbols={s: k for k, s in enumerate(definition.constants)},
            running=running,
            terminal=terminal,
            instants=tuple(reader.instants),
            boundary=conditions,
            path=inequalities,
            hessian=None if second == "lbfgs" else second,
            squares=squares[0] if squares else (),
            terminal_squares=squares[1] if squares else (),
        )

    def __repr__(self) -> str:
        unknown = some(unique_names(self._controls)) or "none"
        return (
            f"<OptimalControl: {self._problem.states} states, controls {unknown}, "
            f"{self._method} on {len(self._mesh) - 1} intervals>"
        )

    @property
    def _problems(self) -> list[OptimalControl]:  # type: ignore[override]
        return [self]

    def _expressions(self) -> Expressions:
        """Return the problem's expressions with the bounds of their unknowns."""
        definition, p = self._snapshot.definition, self._as_written
        numbers = len(definition.constants)
        ranges = {}
        for k, s in enumerate(definition.states):
            ranges["x", k] = Range(str(s), *self._reach(s))
            ranges["d", k] = Range(str(s.diff(definition.equations.time)), *_OPEN)
        for s, k in zip(self._controls, p.controls, strict=True):
            ranges["r", k] = Range(str(s), *self._reach(s))
        for s, k in zip(self._free, p.free, strict=True):
            ranges["p" if k < numbers else "r", k] = Range(str(s), *self._reach(s))
        if self._symbol is not None:
            low, high = self._reach(self._symbol)
            ranges["T", 0] = Range(str(self._symbol), max(low, 0.0), high)
        instants = []
        for i in p.instants:
            symbol = (definition.states if i.kind == "state" else self._controls)[i.index]
            low, high = self._bounds_at(symbol, i.fraction)
            limits = {0.0: self._start, 1.0: self._end}.get(i.fraction, {}) if (
                i.kind == "state") else {}  # fmt: skip
            least, most = limits.get(symbol, _OPEN)
            time = sm.Float(i.fraction, 6) * (self._duration or self._symbol)
            name = str(symbol.subs(definition.equations.time, sm.nsimplify(time)))
            instants.append(Range(name, max(low, least), min(high, most)))
        return Expressions(p, ranges, instants)

    def _lift_kinks(self) -> None:
        """Replace kinks of objective and conditions by smooth conditions, if that is equivalent."""
        p, definition = self._as_written, self._snapshot.definition
        moving = {*self._controls, *self._free, self._symbol, *(i.symbol for i in p.instants)}
        moving |= {*definition.states, *definition.equations.kinematics.speed_rates}
        moving |= {*definition.outputs.symbols}

        def varies(kink: sm.Expr) -> bool:
            return not kink.atoms(sm.Symbol, AppliedUndef, sm.Derivative).isdisjoint(moving)

        constants = zip(definition.constants, self._snapshot.p.tolist(), strict=True)
        values = {s: v for s, v in constants if s not in self._free}
        running, terminal = (epigraph(e, varies, values) for e in (p.running, p.terminal))
        self._bends = bends(running.expression + terminal.expression) or self._bends
        self._kinks = terminal.kinks
        path, boundary = (
            tuple(smooth for c in conditions for smooth in split(c, varies, values))
            for conditions in (p.path, p.boundary)
        )
        self._problem = p
        if running.unknown or terminal.unknown or (path, boundary) != (p.path, p.boundary):
            self._problem = replace(
                p,
                running=running.expression,
                terminal=terminal.expression,
                path=(*path, *running.conditions),
                boundary=(*boundary, *terminal.conditions),
                lifted=running.unknown,
                lifted_numbers=terminal.unknown,
                _compiled={},
            )

    def _at_guess(self, transcription: Transcription, z: np.ndarray) -> list[float]:
        """Return the values of the kinks at instants, at a guess."""
        if not self._kinks:
            return []
        states, controls, free, duration = transcription.split(z)
        values = self._snapshot.constants | dict(zip(self._free, free, strict=False))
        if self._symbol is not None:
            values[self._symbol] = duration
        for i in self._problem.instants:
            slots, weights, h = transcription.located(i.kind, i.fraction)
            scheme, is_state = transcription.scheme, i.kind == "state"
            powers = (scheme.states if is_state else scheme.controls).basis(np.zeros(1))[1]
            slot_values = (states if is_state else controls)[i.index, slots]
            values[i.symbol] = float(slot_values @ (weights * (h * duration) ** powers))
        return [float(kink.subs(values)) for kink in self._kinks]

    def _reach(self, symbol: AnySymbol) -> tuple[float, float]:
        """Return the widest bounds that an unknown has along the motion."""
        low, high = self._bounds.get(symbol, _FREE)
        return low.extremes[0], high.extremes[1]

    @property
    def _hint(self) -> str:
        """A hint for the message of a search that failed."""
        return self._bends or jumping_conditions(self._expressions())

    def _check_samples(self, plan: SpecifiedsPlan) -> str:
        """Refuse samples that do not cover the motion, or that jump while its duration is unknown.

        Returns a hint on samples that bend, for a search that failed.
        """
        if self._duration is not None:
            plan.check_times(np.array([0.0, self._duration]), "duration")
            return ""
        longest = self._bounds_at(self._symbol)[1]
        plan.check_times(np.array([0.0, longest]), f"bounds[{self._symbol}]")
        kinds = {samples.interpolation: columns for columns, samples in plan.inputs.sampled}
        names = {kind: describe([plan.symbols[k] for k in at]) for kind, at in kinds.items()}
        if "previous" in names:
            raise ValueError(
                f"`specifieds` has samples with interpolation='previous' for {names['previous']}, "
                "and the duration is free: which of them a collocation point meets would jump as "
                "the search changes it. Use 'linear' or 'pchip', with two samples close to each "
                "other where the signal jumps, or `phases` that end there."
            )
        return "" if "linear" not in names else (
            f" The samples for {names['linear']} bend: a search that ends where a collocation "
            "point meets one of them finds no minimum. Use interpolation='pchip'."
        )  # fmt: skip

    def _read_bounds(self, bounds: object) -> dict[AnySymbol, tuple[Limit, Limit]]:
        """Return the bounds by symbol."""
        entries, limits = check_mapping("bounds", bounds), {}
        symbols = self._unknown.chosen(entries, "bounds")
        moving = (*self._snapshot.definition.states, *self._controls)
        for symbol, (key, pair) in zip(symbols, entries.items(), strict=True):
            argument = f"`bounds[{key}]`"
            sides = pair if isinstance(pair, (tuple, list)) and len(pair) == 2 else ()
            if all(map(_constant, sides)):
                low, high = map(Limit, _pair(pair, argument, False))
            elif symbol not in moving:
                raise ValueError(f"{argument} must be a pair of numbers, got {shown(pair)}.")
            else:
                low, high = (
                    end if side is None else limit(side, argument, self._duration)
                    for side, end in zip(sides, _FREE, strict=True)
                )
            limits[symbol] = low, high
        return limits

    def _bounds_at(self, symbol: AnySymbol, fraction: float = 0.0) -> tuple[float, float]:
        """Return the bounds of an unknown at a fraction of the motion."""
        low, high = (float(side[0]) for side in self._pair_at(symbol, np.array([fraction])))
        return low, high

    def _pair_at(self, symbol: AnySymbol, fractions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        low, high = self._bounds.get(symbol, _FREE)
        return low(fractions), high(fractions)

    def _limits(
        self, argument: str, entries: object, symbols: Sequence[AnySymbol]
    ) -> dict[AnySymbol, tuple[float, float]]:
        """Return pairs of numbers by symbol."""
        symbol_index = SymbolIndex(tuple(symbols), "unknowns of the problem")
        values = check_mapping(argument, entries)
        pairs = zip(symbol_index.chosen(values, argument), values.items(), strict=True)
        return {s: _pair(value, f"`{argument}[{key}]`", True) for s, (key, value) in pairs}

    @staticmethod
    def phases(problems: Iterable[OptimalControl], links: Iterable[object] | None = None) -> Phases:
        """Join problems to one motion in phases, as of a hopper: flight, impact, stance.

        The sum of the objectives is minimised. Each phase has its own time, from 0 on, system, mesh
        and conditions. The link determines the initial values of linked states: conditions in
        `start` hold in addition, the system's initial conditions do not. Free constants and
        durations with the same symbol are one unknown.

        Parameters
        ----------
        problems : sequence of OptimalControl
        links : sequence of dict, optional
            For each junction, a dictionary from states of the later phase to expressions of states,
            at the end, and constants of the phase before; None removes a link. Other states are
            continuous.

        Returns
        -------
        Phases
            Its method `solve` takes a list of guesses, and `mesh_tol`, `options` and `progress`; it
            returns a `PhasedTrajectory`, the sequence of the phases' motions. `check` takes such a
            list and raises errors of the problem before a search.

        Examples
        --------
        A mass runs against a wall and comes back with half of its speed, all with the least ∫ F²:

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
        >>> effort = sm.Integral(F**2, t)
        >>> there = OptimalControl(system, effort, 1.0, end={x: 1.0})
        >>> back = OptimalControl(system, effort, 1.0, end={x: 0.0, v: 0.0})
        >>> found = OptimalControl.phases([there, back], [{v: -v/2}]).solve()
        >>> round(found.objective, 6), (found[1][v][0] / found[0][v][-1]).round(6)
        (7.8, np.float64(-0.5))
        """
        checked = listed("problems", problems, "OptimalControl")
        for k, problem in enumerate(checked):
            if not isinstance(problem, OptimalControl):
                raise TypeError(
                    f"`problems` must hold OptimalControl objects, got {shown(problem)} at {k}."
                )
        if len(checked) < 2:
            raise ValueError(f"`problems` must hold at least two phases, got {len(checked)}.")
        return Phases(checked, [{}] * (len(checked) - 1) if links is None else links)

    # -- before the search ------------------------------------------------------------------------

    def _on(self, mesh: np.ndarray) -> Transcription:
        """Return the transcription on a mesh; the latest one is cached for the next search."""
        latest = self._latest
        if latest is None or latest.problem is not self._problem or latest.mesh is not mesh:
            latest = self._latest = Transcription(self._problem, self._scheme, mesh)
        return latest

    def _check_start(self, transcription: Transcription, z: np.ndarray, sizes: np.ndarray) -> None:
        """Refuse a start that violates the constraints, or that they leave undetermined."""
        states = self._snapshot.definition.states
        if self._fixed and not self._free:
            start = np.array([[self._start[s][0] for s in states]])
            for k, value in violated(self._snapshot.at(np.zeros(1), start)).items():
                raise ValueError(
                    f"The start does not satisfy the constraints: constraint {k} of positions is "
                    f"{value:.3g}."
                )
        if not self._problem.equations.constraints:
            if self._following:
                raise ValueError(
                    f"`start` leaves out {describe(self._following)}, but what would give them is "
                    "kept by the motion alone. Give all states in `start`."
                )
            return
        begin = transcription.beginning()
        rows, J = begin.evaluate("rows", z)[:, 0], np.zeros((begin.rows, len(begin.at)))
        J[tuple(begin.functions.jacobian_at.T)] = begin.evaluate("jacobian", z)[:, 0]
        sizes = sizes[begin.at[:, 0]]
        terms = np.abs(J) @ sizes
        if self._fixed and (np.abs(rows) > DIGITS * terms).any():
            at = int(np.argmax(np.abs(rows) - DIGITS * terms))
            raise ValueError(
                f"The start does not satisfy the constraints: `{begin.labels[at]}` is "
                f"{rows[at]:.3g}. Call `system.set_dependent_initial_conditions`, or free "
                "states that follow from others: start={symbol: None}."
            )
        columns = [k for k, s in enumerate(states) if s in self._following]
        if columns and rank(J[:, columns] * sizes[columns]) < len(columns):
            names = describe([states[k] for k in columns])
            raise ValueError(
                f"`start` leaves out {names}, which the constraints do not determine there: the "
                "configuration is singular for them. Give all states in `start`."
            )

    def _bounds_of(self, transcription: Transcription) -> tuple[np.ndarray, np.ndarray]:
        """Return the lower and upper bounds of all unknowns: `bounds`, narrowed by both ends."""
        states, controls = self._snapshot.definition.states, self._controls
        (slot_times, slopes), M = transcription.state_slots, transcription.intervals
        x = np.empty((2, len(states), len(slot_times)))
        u = np.empty((2, self._problem.algebraic, len(transcription.control_times)))
        u[0], u[1] = _OPEN
        for s, fractions, rows in (
            *((s, slot_times, x[:, k]) for k, s in enumerate(states)),
            *((s, transcription.control_times, u[:, k]) for k, s in enumerate(controls)),
        ):
            rows[:] = low, high = self._pair_at(s, fractions)
            if (low > high).any():
                k = int(np.flatnonzero(low > high)[0])
                raise ValueError(
                    f"`bounds[{s}]` must have low <= high everywhere, got {float(low[k])!r} and "
                    f"{float(high[k])!r} after {float(fractions[k]):.6g} of the motion."
                )
        sides = []
        for side, pick in ((0, max), (1, min)):
            x[side][:, slopes] = _OPEN[side]
            for k, s in enumerate(states):
                x[side, k, 0] = pick(x[side, k, 0], self._start[s][side])
                x[side, k, M] = pick(x[side, k, M], self._end.get(s, _OPEN)[side])
            constants = [self._bounds_at(s)[side] for s in self._free]
            constants += [_OPEN[side]] * len(self._kinks)  # unknowns that replace kinks
            limit = self._bounds_at(self._symbol)[side]
            duration = limit if side else max(limit, 0.0)
            sides.append(transcription.unknowns_of(x[side], u[side], constants, duration))
        lower, upper = sides
        for k, s in enumerate(states):
            for slot, end in ((0, "start"), (M, "end")):
                if x[0, k, slot] > x[1, k, slot]:
                    limits = (self._start if end == "start" else self._end)[s]
                    raise ValueError(
                        f"`{end}[{s}]` is {shown_pair(limits)}, which the `bounds` "
                        f"{shown_pair(self._bounds_at(s, slot_times[slot]))} exclude."
                    )
        return lower, upper

    def _guess(
        self, transcription: Transcription, user_guess: object, lower: np.ndarray, upper: np.ndarray
    ) -> np.ndarray:
        """Return the user's guess, completed by linear interpolation between the ends."""
        guess = Guess(user_guess, self._unknown, self._duration, self._symbol)
        duration = guess.duration(self._bounds_at(self._symbol))
        slot_times, slopes = transcription.state_slots
        inner = ~slopes
        inner[[0, transcription.intervals]] = False  # the ends are where `start` and `end` say
        x = np.empty((self._problem.states, len(slot_times)))
        equations = self._snapshot.definition.equations
        moving = []  # coordinates with neither a guess nor a value at the end
        for k, s in enumerate(self._snapshot.definition.states):
            values = guess.values(s, slot_times, duration)
            if values is None:
                first = _middle(self._start[s], float(self._snapshot.x[k]))
                last = _middle(self._end.get(s, _OPEN), first)
                values = np.interp(slot_times, [0.0, 1.0], [first, last])
                moving += [k] if s in equations.coordinates and s not in self._end else []
            guess.check_bounds(s, values[inner], self._pair_at(s, slot_times[inner]))
            x[k] = values
        u = np.zeros((self._problem.algebraic, len(transcription.control_times)))
        for k, s in enumerate(self._controls):
            values = guess.values(s, transcription.control_times, duration)
            u[k] = 0.0 if values is None else values
            guess.check_bounds(s, u[k], self._pair_at(s, transcription.control_times))
        constants = []
        for s, k in zip(self._free, self._problem.free, strict=True):
            default = self._problem.constants[k]
            if s in self._extra_constants:
                default = _middle(self._bounds_at(s), default)
            constants.append(guess.number(s, default))
            guess.check_bounds(s, np.array(constants[-1:]), self._bounds_at(s))
        guess.check_bounds(self._symbol, np.array([duration]), self._bounds_at(self._symbol))
        kinks = [0.0] * len(self._kinks)
        z = transcription.unknowns_of(x, u, [*constants, *kinks], duration)
        if kinks:
            kinks = self._at_guess(transcription, z)
            z = transcription.unknowns_of(x, u, [*constants, *kinks], duration)
        index = self._snapshot.definition.states.index
        dependent = [*map(index, equations.dependents.coordinates)]
        if dependent and set(dependent) <= set(moving):
            moving = dependent  # the others retain their linear interpolation
        if equations.constraints.enforced_holonomic and moving:
            count = len(equations.constraints.enforced_holonomic)
            follow_constraints(transcription, z, moving, count)
        x = transcription.split(z)[0]  # which is a view
        for row in x if slopes.any() else ():
            row[slopes] = np.gradient(row[~slopes], transcription.mesh * duration)
        clipped: np.ndarray = np.clip(z, lower, upper)
        return clipped

    def _with(self, columns: Sequence[int], numbers: Sequence[float]) -> OptimalControl:
        """Return the problem with other values of constants; it shares the machine code."""
        copied = copy(self)
        p = self._snapshot.p.copy()
        p[list(columns)] = numbers
        constants = dict(zip(self._snapshot.definition.constants, p.tolist(), strict=True))
        copied._snapshot = with_settings(self._snapshot, constants=constants)
        copied._problem = replace(self._problem, constants=p)
        copied._as_written = replace(self._as_written, constants=p)
        if self._switches:
            refuse_jumps(copied._expressions())
        if (np.sign(p) != np.sign(self._snapshot.p)).any():  # other kinks may be convex
            copied._lift_kinks()
        return copied

    def _trajectory(
        self, transcription: Transcription, nlp: Nlp, state_sizes: np.ndarray, solution: NlpSolution
    ) -> OptimalTrajectory:
        """Return the trajectory; `state_sizes` are the sizes of the states in the guess."""
        snapshot, duration = self._snapshot, transcription.split(solution.z)[3]
        if not duration > 0.0:  # solvers let unknowns pass their bounds by a tolerance
            raise OptimizationError(
                f"The search ended at a duration of zero after "
                f"{counted(solution.iterations, 'iteration')}: the objective favours a motion of "
                f"no length. Give `bounds[{self._symbol}]` a positive lower limit.",
                None,
            )
        rate_function = RateFunction(snapshot.code.compiled("rates"), snapshot.inputs)
        limits = {s: self._bounds_at(s) for s in self._free}
        refuse_singular(rate_function, transcription, snapshot.x, solution.z, nlp.sizes, limits)
        if solution.solved:
            symbols = snapshot.definition.constants
            refuse_unsolvable(rate_function, transcription, solution.z, symbols)
        error = interval_errors(rate_function, transcription, solution.z, state_sizes)
        trajectory = OptimalTrajectory(
            snapshot, transcription, self._controls, self._free, nlp, solution, error
        )
        trajectory._sizes = state_sizes
        return trajectory

    def _warn_of_crossings(self, motion: OptimalTrajectory) -> None:
        """Warn if the objective or a path condition is discontinuous along a solution."""
        if self._switches:
            warn_of_crossings(self._expressions(), motion)

    def _propagated_errors(self, motion: OptimalTrajectory, tolerance: float) -> np.ndarray:
        """Return which intervals make a simulation miss the nodes; see `propagated_errors`."""
        rate_function = RateFunction(self._snapshot.code.compiled("rates"), self._snapshot.inputs)
        transcription, z = motion._transcription, motion.solution.z
        return propagated_errors(rate_function, transcription, z, motion._sizes, tolerance)


def _controls_of(definition: Definition, plan: SpecifiedsPlan) -> tuple[AnySymbol, ...]:
    """Return the controls: the specifieds without a value."""
    if plan.inputs.functions:
        raise ValueError(
            f"`specifieds` gives a Python function for {plan.inputs.functions[0][1].label}, which "
            "has no derivatives. Give an expression of time and states, or a SampledInput; a "
            "specified without a value is a control."
        )
    assigned = plan.given | followed(definition, plan)
    controls = tuple(s for s in definition.specifieds if s not in assigned)
    for s in controls:
        lower = [d for d in definition.lower_derivatives.get(s, ()) if d in definition.specifieds]
        if lower:
            raise NotImplementedError(
                f"The equations hold `{s}` and `{lower[0]}`, and the first has no value: as a "
                "control it would not be the derivative of the second. Make the second a "
                "state, or give the first a value."
            )
    return controls


def _extra_constants(
    definition: Definition, free: Sequence[object], expressions: Iterable[object], duration: object
) -> set[sm.Symbol]:
    """Return the free symbols that occur in the objective or the conditions only."""
    reserved = {*definition.states, *definition.specifieds, *definition.constants}
    reserved |= {duration} if isinstance(duration, sm.Symbol) else set()
    reserved |= {*definition.outputs.symbols, definition.equations.time}
    symbols = {s for e in expressions for s in getattr(e, "free_symbols", ()) if s.is_Symbol}
    return {s for s in symbols - reserved if s in free or s.name in free}


def _duration_of(duration: object, definition: Definition) -> tuple[float | None, sm.Symbol | None]:
    """Return the duration and None, or None and the symbol of an unknown duration."""
    if not isinstance(duration, sm.Symbol):
        value = number(duration, "`duration`", finite=True)
        if not value > 0.0:
            raise ValueError(
                f"`duration` must be positive, or a Symbol for one that is found, got {value!r}."
            )
        if not 0.0 < value * value < np.inf:  # accelerations are scaled with it
            raise ValueError(
                f"`duration` must have a square within the range of floats, got {value!r}. Choose "
                "another unit of time."
            )
        return value, None
    if duration in (*definition.constants, definition.equations.time):
        raise ValueError(
            f"`duration` is `{duration}`, which the equations hold already. Give the duration "
            "a symbol of its own."
        )
    return None, duration


def _constant(side: SampledInput | Sequence[float] | np.ndarray | float | None) -> bool:
    """Return whether a bound is constant over the motion."""
    if side is None or isinstance(side, (SampledInput, list, tuple, range)):
        return side is None
    try:
        return np.ndim(side) == 0
    except (TypeError, ValueError):  # `limit` raises a better error
        return False


def _pair(value: object, argument: str, single: bool) -> tuple[float, float]:
    """Return bounds, where None means unbounded; a `single` number may stand for both."""
    if value is None:
        return _OPEN
    if not isinstance(value, (tuple, list)) and not (
        isinstance(value, np.ndarray) and value.ndim == 1
    ):
        if not single:
            raise ValueError(f"{argument} must be a pair (low, high), got {shown(value)}.")
        exact = number(value, argument, finite=True)
        return exact, exact
    if len(value) != 2:
        raise ValueError(f"{argument} must be a pair (low, high), got {shown(value)}.")
    low, high = (
        end if entry is None else number(entry, argument)
        for entry, end in zip(value, _OPEN, strict=True)
    )
    if not low <= high or low == np.inf or high == -np.inf:
        raise ValueError(f"{argument} must be a pair with low <= high, got {shown(value)}.")
    return low, high


def _middle(limits: tuple[float, float], otherwise: float) -> float:
    """Return the middle of limits; if one is infinite, the value nearest to `otherwise`."""
    low, high = limits
    if np.isfinite(low) and np.isfinite(high):
        return 0.5 * (low + high)
    return min(max(otherwise, low), high)


def labels_of(definition: Definition) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the names of all equations, and of the constraints among them."""
    equations = definition.equations
    coordinates, speeds = unique_names(equations.coordinates), unique_names(equations.speeds)
    constraints = (
        *(f"constraint {k} of positions" for k in equations.constraints.enforced_holonomic),
        *(f"constraint {k} of velocities" for k in range(len(equations.constraints.velocity))),
    )
    labels = (
        *(f"kinematics of {name}" for name in coordinates),
        *(f"motion of {name}" for name in speeds),
        *(f"integral {name}" for name in unique_names(definition.auxiliaries)),
        *constraints,
    )
    return labels, constraints
