"""Transcription of a motion on a mesh to a nonlinear program, and of its unknowns to a motion.

The unknowns are ordered as states by slots, controls by slots, constants, and the duration. See
`schemes` for slots; the first of them are the nodes of the mesh.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypeVar

import numpy as np

from pydy._collector import collector_paused
from pydy._forks import cached_property
from pydy._rank import or_one
from pydy.control.kernel import ImplicitEquations, PointBuilder, PointFunctions
from pydy.control.nlp import Nlp, PointGroup, cubics_at
from pydy.control.schemes import Points, Scheme, Slots
from pydy.control.tuning import JUMP, TOLERANCE, WIDE

if TYPE_CHECKING:
    import sympy as sm
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol
    from pydy.inputs import SampledInput

Compiled = TypeVar("Compiled")
# A lower or upper bound, as a function of fractions of the duration.
Bound: TypeAlias = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Condition:
    """``low ≤ expression ≤ high``."""

    expression: sm.Expr
    low: float
    high: float
    label: str


@dataclass(frozen=True)
class Instant:
    """A state or control at one time."""

    symbol: sm.Dummy  # its symbol in conditions and the objective
    kind: str  # 'state' or 'control'
    index: int
    fraction: float  # the time, as a fraction of the duration


@dataclass(frozen=True)
class Lifted:
    """An unknown that replaces a kink of the objective, a maximum or minimum of several parts.

    Its conditions, one for each part, are ``sign · (symbol − part) ≥ 0``; see `kinks`.
    """

    symbol: sm.Dummy
    sign: int
    parts: int


@dataclass(frozen=True, eq=False)
class TranscribedProblem:
    """An optimal control problem as ordered data."""

    equations: ImplicitEquations
    states: int
    labels: tuple[str, ...]  # of the equations
    # Labels of the constraints that the start must satisfy: the last ones of all constraints.
    constraints: tuple[str, ...]
    controls: tuple[int, ...]  # indices in r
    # Lower and upper bound of each control, as functions of fractions of the duration; for states,
    # see `state_bounds`.
    control_bounds: tuple[tuple[Bound, Bound], ...]
    signals: tuple[tuple[np.ndarray, SampledInput], ...]  # the indices in r of each
    free: tuple[int, ...]  # indices in (p, r) of constants that are unknown
    # The values p and r; entries that are unknowns or signals are not used.
    constants: np.ndarray
    specifieds: np.ndarray
    duration: float | None  # None if it is unknown
    duration_symbol: sm.Symbol | None = None
    symbols: Mapping[AnySymbol, int] = field(default_factory=dict)  # indices of the constants in p
    # SymPy expressions: the objective is the integral of `running` plus `terminal`.
    running: sm.Expr | int = 0
    terminal: sm.Expr | int = 0
    instants: tuple[Instant, ...] = ()
    boundary: tuple[Condition, ...] = ()
    path: tuple[Condition, ...] = ()
    # Which second derivatives are compiled: 'exact', 'gauss-newton' or None.
    hessian: str | None = "exact"
    # SymPy expressions: `running` and `terminal` as sums of factor · residual².
    squares: tuple[tuple[sm.Expr, sm.Expr], ...] = ()
    terminal_squares: tuple[tuple[sm.Expr, sm.Expr], ...] = ()
    begin: float = 0.0  # the time at which the motion begins
    # Intensities of white noise: the controls are then added to the given values of these
    # specifieds, and ½ ∫ Σ (control / intensity)² dt to the objective.
    noise: tuple[float, ...] = ()
    # States and outputs that `Transcription.samples` compares with samples.
    measured: tuple[AnySymbol, ...] = ()
    state_bounds: tuple[tuple[Bound, Bound], ...] = ()
    # (states,), the weights with which slack velocities move coordinates; see `metric_of`.
    metric: np.ndarray | float = 1.0
    # Unknowns that replace kinks: functions of time in `running`, with their conditions at the end
    # of `path`, and numbers in `terminal`, with their conditions at the end of `boundary`.
    lifted: tuple[Lifted, ...] = ()
    lifted_numbers: tuple[Lifted, ...] = ()
    _compiled: dict[Hashable, Any] = field(default_factory=dict, repr=False)

    @property
    def algebraic(self) -> int:
        """Number of controls, slack velocities, multipliers and kinks, in the same slots."""
        return len(self.controls) + len(self.equations.constraints) + len(self.lifted)

    @property
    def named(self) -> dict[sm.Symbol, tuple[str, int]]:
        """The inputs of further symbols in the objective and path conditions."""
        inputs = {lifted.symbol: ("e", k) for k, lifted in enumerate(self.lifted)}
        return (
            inputs if self.duration_symbol is None else {**inputs, self.duration_symbol: ("T", 0)}
        )

    @property
    def numbers(self) -> np.ndarray:
        """The constants P of all points: p, r, the metric, the duration and the initial time."""
        duration = np.nan if self.duration is None else self.duration
        metric = np.broadcast_to(self.metric, self.states)
        return np.concatenate([self.constants, self.specifieds, metric, [duration, self.begin]])

    # -- machine code, for any mesh ----------------------------------------------------------------

    def at_points(self, points: Points) -> PointFunctions:
        """Return the functions of collocation points: equations, path conditions and integrand."""
        key = (points.state, points.rate, points.rows)
        return self.once(key, lambda: self._at_points(points))

    def labels_at(self, points: Points) -> tuple[str, ...]:
        """Return the names of the collocation points' rows, without path conditions."""
        constraint_count = len(self.equations.constraints)
        first = len(self.labels) - constraint_count
        if points.rows == "constraints":
            return self.labels[first:]
        rates = tuple(f"rate of {name} at the start" for name in self.labels[first:])
        further = {"all": self.labels[first:], "motion": (), "start": rates}
        return (*self.labels[:first], *further[points.rows])

    def once(self, key: Hashable, make: Callable[[], Compiled]) -> Compiled:
        """Return the code that is compiled once for all meshes and numbers.

        Copies of the problem by `replace` share it: the key holds everything that `make` reads
        besides the problem's equations, sizes and expressions.
        """
        if key not in self._compiled:
            with collector_paused():  # the graph is freed before it could become an old object
                self._compiled[key] = make()
        compiled: Compiled = self._compiled[key]
        return compiled

    def _at_points(self, points: Points) -> PointFunctions:
        point, n = self._point(), self.states
        values = [point.variables(n) for _ in range(len(points.slots))]
        controls = point.variables(self.algebraic)
        numbers, T = self.unknown_numbers(point)
        fraction, length, weight = point.data(3)
        g = point.graph
        h = g.mul(T, length)
        forms = []
        for terms in (points.state, points.rate):
            coefficients = [[point.data(1)[0]] if c is None else c for _, c, _ in terms]
            rows = []
            for k in range(n):
                parts = zip(terms, coefficients, strict=True)
                rows.append(point.combined([(values[y][k], c, p) for (y, _, p), c in parts], h))
            forms.append(rows)
        x, slopes = forms
        time = self._time(point, T, fraction)
        at = {("T", 0): T, **self._inputs(point, time, x, numbers, controls)}
        at |= {("d", k): node for k, node in enumerate(slopes)}
        control_count, constraint_count = len(self.controls), len(self.equations.constraints)
        at |= {
            ("s", k): node
            for k, node in enumerate(controls[control_count : control_count + constraint_count])
        }
        at |= {
            ("e", k): node for k, node in enumerate(controls[control_count + constraint_count :])
        }
        rows = point.residuals(at, points.rows)
        if points.rows == "constraints":
            return point.functions(rows, None, hessian=self.hessian)
        if self.path:
            path = [c.expression for c in self.path]
            rows += point.read(path, "`path`", at, self.named)
        cost, squares = None, []
        if self.running != 0:
            expressions = [self.running, *(e for pair in self.squares for e in pair)]
            nodes = point.read(expressions, "`objective`", at, self.named)
            cost = g.mul(T, weight, nodes[0])
            factors = [g.mul(T, weight, factor) for factor in nodes[1::2]]
            squares = [*zip(factors, nodes[2::2], strict=True)]
        if self.noise:
            pairs = zip(controls[:control_count], self.noise, strict=True)
            cost = g.mul(T, weight, g.sum([(g.powi(c, 2), 0.5 / s**2) for c, s in pairs]))
        return point.functions(rows, cost, hessian=self.hessian, squares=squares)

    def _time(self, point: PointBuilder, T: int, fraction: int) -> int:
        """Return the node of the time."""
        begin = point.constant(point.constants - 1)
        return point.graph.add(begin, point.graph.mul(T, fraction))

    def _inputs(
        self, point: PointBuilder, time: int, x: Sequence[int], numbers: Sequence[int],
        controls: Sequence[int] = (),
    ) -> dict[tuple[str, int], int]:  # fmt: skip
        """Return the nodes of time, states, constants and specifieds."""
        constant_count = len(self.constants)
        at = {("t", 0): time}
        at |= {("x", k): node for k, node in enumerate(x)}
        at |= {("p", k): node for k, node in enumerate(numbers[:constant_count])}
        at |= {("r", k): node for k, node in enumerate(numbers[constant_count:])}
        at |= {("w", k): point.constant(len(numbers) + k) for k in range(self.states)}
        for columns, _ in self.signals:
            at |= {("r", k): self._signal(point, time) for k in columns.tolist()}
        for k, node in zip(self.controls, controls, strict=False):
            at["r", k] = point.graph.add(at["r", k], node) if self.noise else node
        return at

    def _signal(self, point: PointBuilder, time: int) -> int:
        """Return the node of a known signal, computed from the rows of `signals_at`."""
        if self.duration is not None:
            return point.data(1)[0]
        g, (knot, *cubic) = point.graph, point.data(5)
        since, value = g.sub(time, knot), cubic[3]
        for coefficient in cubic[2::-1]:
            value = g.add(coefficient, g.mul(since, value))
        return value

    def signals_at(self, times: np.ndarray, middles: np.ndarray | None = None) -> list[np.ndarray]:
        """Return the data of known signals; with an unknown duration, coefficients of cubics.

        If the `middles` of intervals are given, a signal that jumps at a node is evaluated on the
        side of the middle.
        """
        if self.duration is None:
            return cubics_at(self.signals, times)
        side_times = times if middles is None else inside(times, middles)
        rows = [
            s.rows(side_times if s.interpolation == "previous" else times) for _, s in self.signals
        ]
        return [column for row in rows for column in row.T]

    def at_start(self, count: int) -> PointFunctions:
        """Return the last `count` of the constraints at the start."""
        return self.once(("start", count), lambda: self._at_start(count))

    def _at_start(self, count: int) -> PointFunctions:
        point = self._point()
        x = point.variables(self.states)
        numbers, T = self.unknown_numbers(point)
        time = self._time(point, T, point.graph.zero)
        at = {("T", 0): T, **self._inputs(point, time, x, numbers)}
        rows = point.residuals(at, "constraints")
        return point.functions(rows[len(rows) - count :], None, hessian=self.hessian)

    def _point(self) -> PointBuilder:
        return PointBuilder(self.equations, len(self.numbers))

    def unknown_numbers(self, point: PointBuilder) -> tuple[list[int], int]:
        """Return the nodes of (p, r), those of `lifted_numbers` after them, and the duration."""
        count = len(self.constants) + len(self.specifieds)
        nodes = [point.constant(k) for k in range(count)]
        for k, node in zip(self.free, point.variables(len(self.free)), strict=True):
            nodes[k] = node
        nodes += point.variables(len(self.lifted_numbers))
        if self.duration is None:
            return nodes, point.variables(1)[0]
        return nodes, point.constant(point.constants - 2)

    def of_parameters(self) -> PointFunctions:
        """Return ½ (factor · (parameter − mean))² + slope · parameter, of these three data."""
        return self.once("parameters", self._of_parameters)

    def _of_parameters(self) -> PointFunctions:
        point = PointBuilder(self.equations, 0)
        (parameter,), (mean, factor, slope), g = point.variables(1), point.data(3), point.graph
        deviation = g.powi(g.mul(factor, g.sub(parameter, mean)), 2)
        cost = g.sum([(deviation, 0.5), (g.mul(slope, parameter), 1.0)])
        return point.functions([], cost, hessian=self.hessian)

    def at_samples(self, scheme: Scheme) -> tuple[PointFunctions, PointFunctions]:
        """Return half the sum of squared residuals of a sample, and the residuals as rows."""
        return self.once(("samples", scheme), lambda: self._at_samples(scheme))

    def _at_samples(self, scheme: Scheme) -> tuple[PointFunctions, PointFunctions]:
        point = self._point()
        g = point.graph
        counts = self.states, len(self.controls)
        powers = [kind.basis(np.zeros(1))[1].tolist() for kind in (scheme.states, scheme.controls)]
        slots = [
            [point.variables(n) for _ in exponents]
            for n, exponents in zip(counts, powers, strict=True)
        ]
        numbers, T = self.unknown_numbers(point)
        fraction, length = point.data(2)
        bases = [point.data(len(exponents)) for exponents in powers]
        h = g.mul(T, length)
        x, c = (
            [
                point.combined(
                    [(row[k], [b], p) for row, b, p in zip(rows, basis, exponents, strict=True)], h
                )
                for k in range(n)
            ]
            for n, rows, basis, exponents in zip(counts, slots, bases, powers, strict=True)
        )
        time = self._time(point, T, fraction)
        at = {("T", 0): T, **self._inputs(point, time, x, numbers, c)}
        model = point.read(self.measured, "`measured`", at)
        samples, weights = point.data(len(model)), point.data(len(model))
        rows = [g.mul(w, g.sub(m, y)) for m, y, w in zip(model, samples, weights, strict=True)]
        cost = g.sum([(g.powi(row, 2), 0.5) for row in rows])
        return (
            point.functions([], cost, hessian=self.hessian),
            point.functions(rows, None, hessian=None),
        )

    def at_instants(self, scheme: Scheme) -> PointFunctions | None:
        """Return the boundary conditions and the objective's terms at instants."""
        if not self.boundary and self.terminal == 0:
            return None
        return self.once(("boundary", scheme), lambda: self._at_instants(scheme))

    def _at_instants(self, scheme: Scheme) -> PointFunctions:
        point = self._point()
        constants, T = self.unknown_numbers(point)
        atoms = {s: constants[k] for s, k in self.symbols.items()}
        first = len(constants) - len(self.lifted_numbers)
        atoms |= {
            lifted.symbol: constants[first + k] for k, lifted in enumerate(self.lifted_numbers)
        }
        if self.duration_symbol is not None:
            atoms[self.duration_symbol] = T
        for instant in self.instants:
            kind = scheme.states if instant.kind == "state" else scheme.controls
            powers = kind.basis(np.zeros(1))[1].tolist()
            nodes, data = point.variables(len(powers)), point.data(len(powers))
            terms = [(v, [c], p) for v, c, p in zip(nodes, data, powers, strict=True)]
            # Each instant lies in another interval, with its length.
            h = point.graph.mul(T, point.data(1)[0])
            atoms[instant.symbol] = point.combined(terms, h)
        count = len(self.boundary)
        expressions = [*(c.expression for c in self.boundary), self.terminal]
        expressions += [e for pair in self.terminal_squares for e in pair]
        nodes = point.read_with(expressions, "`boundary` and `objective`", atoms)
        cost = None if self.terminal == 0 else nodes[count]
        squares = [*zip(nodes[count + 1 :: 2], nodes[count + 2 :: 2], strict=True)]
        return point.functions(nodes[:count], cost, hessian=self.hessian, squares=squares)


@dataclass(frozen=True, eq=False)
class Transcription:
    """A problem on a mesh."""

    problem: TranscribedProblem
    scheme: Scheme
    mesh: np.ndarray  # (M + 1,), the nodes as fractions of the duration, from 0 to 1

    # -- order of the unknowns --------------------------------------------------------------------

    @cached_property
    def state_slots(self) -> tuple[np.ndarray, np.ndarray]:
        """The times of the states' slots as fractions, and whether they are slopes."""
        return self.scheme.states.times_on(self.mesh)

    @cached_property
    def control_times(self) -> np.ndarray:
        """The times of the controls' slots as fractions."""
        return self.scheme.controls.times_on(self.mesh)[0]

    @property
    def intervals(self) -> int:
        """Number of intervals."""
        return len(self.mesh) - 1

    @cached_property
    def sizes(self) -> tuple[int, int, int, int]:
        """Numbers of unknowns: of states, controls, constants and the duration."""
        p = self.problem
        states, controls = len(self.state_slots[0]), len(self.control_times)
        numbers = len(p.free) + len(p.lifted_numbers)
        return (p.states * states, p.algebraic * controls, numbers, p.duration is None)

    def split(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
        """Return states (n, slots), controls (c, slots), free constants and the duration.

        Slack velocities, multipliers of constraints and kinks follow the controls; kinks of values
        at instants follow the constants.
        """
        p, (states, controls, constants, _) = self.problem, self.sizes
        return (
            z[:states].reshape(p.states, len(self.state_slots[0])),
            z[states : states + controls].reshape(p.algebraic, len(self.control_times)),
            z[states + controls : states + controls + constants],
            float(z[-1]) if p.duration is None else p.duration,
        )

    def unknowns_of(
        self, states: np.ndarray, controls: np.ndarray, constants: ArrayLike, duration: float
    ) -> np.ndarray:
        """Join the parts that `split` returns into the unknowns."""
        last = [duration] if self.problem.duration is None else []
        parts = (np.ravel(states), np.ravel(controls), np.asarray(constants, float), last)
        return np.concatenate(parts).astype(float)

    def _numbers_at(self, count: int) -> np.ndarray:
        """Return the indices of constants and duration, repeated for `count` points."""
        first, total = sum(self.sizes[:2]), sum(self.sizes)
        return np.repeat(np.arange(first, total)[:, None], count, axis=1)

    # -- the program ------------------------------------------------------------------------------

    def nlp(self, lower: np.ndarray, upper: np.ndarray, sizes: np.ndarray) -> Nlp:
        """Return the nonlinear program, given bounds and sizes of the unknowns."""
        return Nlp(self.groups, lower, upper, sizes, estimated=self.problem.hessian is None)

    @cached_property
    def single_interval(self) -> Transcription:
        """The problem on a single interval: its derivatives are changes over the full duration."""
        return Transcription(self.problem, self.scheme, np.array([0.0, 1.0]))

    @cached_property
    def points(self) -> tuple[Points, ...]:
        """The collocation points; the first entries of `groups` are their functions."""
        constrained = bool(self.problem.equations.constraints)
        return self.scheme.points(self.mesh, constrained=constrained)

    @cached_property
    def groups(self) -> tuple[PointGroup, ...]:
        """The functions of the program with their unknowns."""
        groups = [self._point_group(points) for points in self.points]
        if self.problem.constraints:
            groups.append(self.beginning())
        ends = self._ends()
        return tuple(groups) if ends is None else (*groups, ends)

    def _point_group(self, points: Points) -> PointGroup:
        p, n = self.problem, self.problem.states
        slots, control_slots = len(self.state_slots[0]), len(self.control_times)
        count = len(points.fractions)
        states = [k * slots + row for row in points.slots for k in range(n)]
        first = self.sizes[0]
        controls = [first + k * control_slots + points.controls for k in range(p.algebraic)]
        times = p.begin + points.fractions * (1.0 if p.duration is None else p.duration)
        middles = None
        # Radau's points at nodes belong to one interval; those of `constraints_at` to none.
        if self.scheme.name == "radau" and points.rows != "constraints":
            centre = (self.mesh[:-1] + self.mesh[1:]) / 2
            centre = np.tile(centre, self.scheme.order)
            middles = p.begin + centre * (1.0 if p.duration is None else p.duration)
        signals = p.signals_at(times, middles)
        data = [points.fractions, points.lengths, points.weights, *points.coefficients, *signals]
        labels, path = p.labels_at(points), () if points.rows == "constraints" else p.path
        return PointGroup(
            p.at_points(points),
            np.concatenate([np.array([*states, *controls]), self._numbers_at(count)]),
            np.ascontiguousarray(data),
            p.numbers,
            (*labels, *(c.label for c in path)),
            points.fractions,
            *_limits(len(labels), path),
            collocated=points.rows != "constraints",
            signals=p.signals if p.duration is None else (),
        )

    def beginning(self) -> PointGroup:
        """Return the constraints at the start; all of them if it is not required to satisfy any."""
        p = self.problem
        count = len(p.constraints) or len(p.equations.constraints)
        states = np.arange(p.states) * len(self.state_slots[0])
        signals = p.signals_at(np.full(1, p.begin))
        return PointGroup(
            p.at_start(count),
            np.concatenate([states, self._numbers_at(1)[:, 0]])[:, None],
            np.array(signals, dtype=float).reshape(-1, 1),
            p.numbers,
            p.constraints or tuple(p.labels[-count:]),
            np.zeros(1),
        )

    def constraints_at(self, slots: np.ndarray) -> PointGroup:
        """Return the constraints at some slots of states."""
        count = len(slots)
        return self._point_group(
            Points(
                ((0, 1.0, 0),), (), slots[None], np.zeros(count, dtype=int), np.empty((0, count)),
                self.state_slots[0][slots], np.ones(count), np.zeros(count), "constraints",
            )
        )  # fmt: skip

    def _ends(self) -> PointGroup | None:
        p = self.problem
        functions = p.at_instants(self.scheme)
        if functions is None:
            return None
        at, data = [self._numbers_at(1)[:, 0]], []
        for instant in p.instants:
            slots, values, h = self.located(instant.kind, instant.fraction)
            first, width = (0, len(self.state_slots[0])) if instant.kind == "state" else (
                self.sizes[0], len(self.control_times))  # fmt: skip
            at.append(first + instant.index * width + slots)
            data += [values, [h]]
        fractions = {i.fraction for i in p.instants}
        return PointGroup(
            functions,
            np.concatenate(at)[:, None],
            np.concatenate([[], *data])[:, None],
            p.numbers,
            tuple(c.label for c in p.boundary),
            np.array([fractions.pop() if len(fractions) == 1 else np.nan]),
            *_limits(0, p.boundary),
        )

    def samples(
        self, times: np.ndarray, values: np.ndarray, weights: np.ndarray
    ) -> tuple[PointGroup, PointGroup]:
        """Return the samples' terms of the objective, and their residuals as rows.

        The times (m,) count from the same zero as `TranscribedProblem.begin`. Residuals are the
        `weights` times the difference of model and `values` (m, q).
        """
        p = self.problem
        assert p.duration is not None
        k, s = self._local((times - p.begin) / p.duration)
        at, bases, scheme = [], [], self.scheme
        for slots, count, first, width in (
            (scheme.states, p.states, 0, len(self.state_slots[0])),
            (scheme.controls, len(p.controls), self.sizes[0], len(self.control_times)),
        ):
            interval_slots = slots.of_intervals(self.intervals)[:, k]
            at += [first + j * width + row for row in interval_slots for j in range(count)]
            bases += [*slots.basis(s)[0]]
        signals = p.signals_at(times)
        lengths = np.diff(self.mesh)[k]
        fractions = (times - p.begin) / p.duration
        rows = [fractions, lengths, *bases, *signals, *values.T, *weights.T]
        data, (cost, residuals) = np.ascontiguousarray(rows), p.at_samples(self.scheme)
        names = tuple(str(symbol) for symbol in p.measured)
        unknowns = np.concatenate([np.array(at), self._numbers_at(len(times))])
        return (
            PointGroup(cost, unknowns, data, p.numbers, (), fractions),
            PointGroup(residuals, unknowns, data, p.numbers, names, fractions),
        )

    def tightened(self, z: np.ndarray) -> np.ndarray:
        """Return z with the unknowns that replace kinks set to the kinks' values.

        A solver leaves them off by its tolerance, and the objective with them.
        """
        p, tightened = self.problem, z.copy()
        first = self.sizes[0] + (p.algebraic - len(p.lifted)) * len(self.control_times)
        sites = [
            (p.lifted, group, first, len(self.control_times), points.controls)
            for group, points in zip(self.groups, self.points, strict=False)
            if group.collocated
        ]
        numbers = sum(self.sizes[:2]) + len(p.free)
        sites.append((p.lifted_numbers, self.groups[-1], numbers, 1, np.zeros(1, dtype=int)))
        for lifted, group, begin, width, slots in sites:
            if lifted:
                rows = group.evaluate("rows", z)
                row = len(rows) - sum(unknown.parts for unknown in lifted)
            for k, unknown in enumerate(lifted):
                excess = rows[row : row + unknown.parts].min(axis=0)
                tightened[begin + k * width + slots] -= unknown.sign * excess
                row += unknown.parts
        return tightened

    def numbers(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the constants p and the specifieds r, including free ones at their solution."""
        p = self.problem
        numbers = np.concatenate([p.constants, p.specifieds])
        numbers[list(p.free)] = self.split(z)[2][: len(p.free)]
        return numbers[: len(p.constants)], numbers[len(p.constants) :]

    def located(self, kind: str, fraction: float) -> tuple[np.ndarray, np.ndarray, float]:
        """Return slots, their coefficients and the interval's length for a time."""
        (k,), s = self._local(np.array([fraction]))
        h = float(np.diff(self.mesh)[k])
        slots = self.scheme.states if kind == "state" else self.scheme.controls
        return slots.of_intervals(self.intervals)[:, k], slots.basis(s)[0][:, 0], h

    # -- between the points -----------------------------------------------------------------------

    def states_at(self, z: np.ndarray, times: np.ndarray) -> np.ndarray:
        """Return the states at m times by the collocation polynomials, shape (m, n)."""
        values, _, _, duration = self.split(z)
        k, s = self._local(times / duration)
        return self._interpolated(values, self.scheme.states, k, s, duration)

    def _interpolated(
        self, values: np.ndarray, slots: Slots, k: np.ndarray, s: np.ndarray, duration: float
    ) -> np.ndarray:
        """Return values (n, slots) at fractions s of intervals k, shape (m, n)."""
        basis, powers = slots.basis(s)
        weights = basis * (np.diff(self.mesh)[k] * duration) ** powers[:, None]
        slot_values = values[:, slots.of_intervals(self.intervals)[:, k]]
        interpolated: np.ndarray = np.einsum("nym,ym->mn", slot_values, weights)
        return interpolated

    def controls_at(self, z: np.ndarray, times: np.ndarray) -> np.ndarray:
        """Return the controls at m times, shape (m, c); at a node, those of the interval before."""
        return self.controls_in(z, *self._local(times / self.split(z)[3], "left"))

    def controls_in(self, z: np.ndarray, k: np.ndarray, s: np.ndarray) -> np.ndarray:
        """Return the controls at fractions s of intervals k, shape (m, c).

        A polynomial that leaves the bounds between its points is clipped to them.
        """
        if not self.problem.controls:
            return np.empty((len(k), 0))
        _, controls, _, duration = self.split(z)
        values = controls[: len(self.problem.controls)]
        sampled = self._interpolated(values, self.scheme.controls, k, s, duration)
        fractions = self.mesh[k] + s * np.diff(self.mesh)[k]
        for column, (low, high) in zip(sampled.T, self.problem.control_bounds, strict=True):
            np.clip(column, low(fractions), high(fractions), out=column)
        return sampled

    def _local(
        self, fractions: np.ndarray, side: Literal["left", "right"] = "right"
    ) -> tuple[np.ndarray, np.ndarray]:
        k = np.clip(np.searchsorted(self.mesh, fractions, side) - 1, 0, self.intervals - 1)
        return k, (fractions - self.mesh[k]) / np.diff(self.mesh)[k]


def inside(times: np.ndarray, middles: np.ndarray) -> np.ndarray:
    """Return times moved towards the middles of their intervals, by more than rounding."""
    shift = np.maximum(JUMP * np.abs(middles - times), 4 * np.spacing(np.abs(times)))
    shifted: np.ndarray = times + np.sign(middles - times) * shift
    return shifted


def _limits(equations: int, conditions: Sequence[Condition]) -> tuple[np.ndarray, np.ndarray]:
    """Return the bounds of equations, which are zero, and of conditions after them."""
    zeros = [0.0] * equations
    low, high = ([getattr(c, side) for c in conditions] for side in ("low", "high"))
    return np.array([*zeros, *low]), np.array([*zeros, *high])


# -- scaling: the sizes of the unknowns ------------------------------------------------------------


def sizes_of(
    transcription: Transcription, z: np.ndarray, lower: np.ndarray, upper: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the sizes of all unknowns (n,), and the sizes of the states in the guess.

    A size is the largest absolute value in guess, ends and bounds. An unknown that is zero in all
    of them gets the size at which it balances the other terms of an equation: the speed that covers
    a given distance in the duration, the force that causes it. Bounds that are much wider than all
    other information are ignored. The size of a state that varies little, far from zero, is its
    variation: a tolerance relative to its distance from zero could exceed the variation.
    """
    states, first, finite = transcription.split(z)[0], np.zeros_like(z), np.isfinite
    nodes = states[:, ~transcription.state_slots[1]]
    low, high, far = nodes.min(axis=1), nodes.max(axis=1), np.abs(nodes).max(axis=1)
    narrow = (low < high) & (high - low < 1e-3 * far)
    shift = np.where(narrow, 0.5 * (low + high), 0.0)
    transcription.split(first)[0][:, ~transcription.state_slots[1]] = shift[:, None]
    distances = [np.where(finite(v), np.abs(v - first), 0.0) for v in (z, lower, upper)]
    parts = [transcription.split(value) for value in distances]
    # The rounding error at that distance from zero must be below the tolerance.
    least = np.where(narrow, 8 * np.finfo(float).eps / TOLERANCE * far, 0.0)
    x = np.array(
        [p[0].max(axis=1, where=~transcription.state_slots[1], initial=0.0) for p in parts]
    )
    u = np.array([p[1].max(axis=1, initial=0.0) for p in parts])
    c = np.array([p[2] for p in parts])
    x[0] = np.maximum(x[0], least)
    duration = transcription.split(z)[3]
    xu, n = np.concatenate([x, u], axis=1), x.shape[1]
    sizes, guessed = xu.max(axis=0), xu[0]
    if (xu[1:] > WIDE * guessed).any() or not guessed.all():
        table = _slopes(transcription, z, xu.shape[1])
        guessed = _propagated_sizes(table, guessed)
        _leave_out_wide(xu, guessed)
        sizes = _propagated_sizes(table, xu.max(axis=0))
    _leave_out_wide(c, c[0])
    x, u, c = or_one(sizes[:n]), or_one(sizes[n:]), c.max(axis=0)
    slopes = np.where(transcription.state_slots[1], 1.0 / duration, 1.0)
    units = transcription.unknowns_of(
        x[:, None] * slopes, np.repeat(u[:, None], len(transcription.control_times), 1), or_one(c),
        duration,
    )  # fmt: skip
    return units, or_one(guessed[:n])


def metric_of(sizes: np.ndarray) -> np.ndarray:
    """Return the weights with which slack velocities move states of the given sizes."""
    units = or_one(sizes)
    metric: np.ndarray = (units / units.max(initial=0.0)) ** 2
    return metric


def _leave_out_wide(sizes: np.ndarray, guessed: np.ndarray) -> None:
    """Set bounds, the second and third row, to zero where they far exceed the guessed sizes."""
    sizes[1:][(sizes[1:] > WIDE * guessed) & (guessed > 0.0)] = 0.0


def _slopes(transcription: Transcription, z: np.ndarray, width: int) -> np.ndarray:
    """Return how much each equation changes with each state and control, shape (rows, width)."""
    interval, n = transcription.single_interval, transcription.problem.states
    times = [interval.state_slots[0], interval.control_times]
    _, _, constants, duration = transcription.split(z)
    # Evaluate along the motion, and as if it remained at its start or its end: in the middle of a
    # motion, an arm may be level, where the derivative of its weight's torque vanishes.
    variants = (times, *([0 * t + end for t in times] for end in (0.0, 1.0)))
    states, controls = (np.concatenate(parts) for parts in zip(*variants, strict=True))
    x = np.split(transcription.states_at(z, states * duration).T, len(variants), axis=1)
    u = np.zeros((transcription.problem.algebraic, len(controls)))
    u[: len(transcription.problem.controls)] = transcription.controls_at(z, controls * duration).T
    at = [
        interval.unknowns_of(
            np.where(interval.state_slots[1], 0.0, x_variant), c, constants, duration
        )
        for x_variant, c in zip(x, np.split(u, len(variants), axis=1), strict=True)
    ]
    owner = np.concatenate([np.repeat(np.arange(n), len(times[0])),
                            n + np.repeat(np.arange(width - n), len(times[1]))])  # fmt: skip
    owner = np.append(owner, np.full(len(at[0]) - len(owner), width))
    weights = np.ones(len(owner))
    weights[: n * len(times[0])][np.tile(interval.state_slots[1], n)] = 1.0 / duration
    tables = [np.empty((0, width + 1))]
    for group in interval.groups:
        f, points = group.functions, group.points
        X = np.concatenate([unknown_vector[group.at] for unknown_vector in at], axis=1)
        data = np.tile(group.data_at(at[0]), len(variants))  # all variants have the same duration
        entries = np.abs(np.nan_to_num(f("jacobian", X, data, group.constants)))
        rows, variables = f.jacobian_at.T
        unknowns = group.at[variables]
        largest = entries.reshape(len(rows), len(variants), points).max(axis=1) * weights[unknowns]
        table = np.zeros((group.rows * points, width + 1))
        np.maximum.at(table, (rows[:, None] * points + np.arange(points), owner[unknowns]), largest)
        tables.append(table)
    return np.concatenate(tables)[:, :width]


def _propagated_sizes(table: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Replace sizes of zero by sizes that the equations imply, as far as they imply any."""
    for _ in range(len(sizes)):
        reach = (table * sizes).max(axis=1, initial=0.0)
        need = np.where((table > 0.0) & (reach[:, None] > 0.0),
                        reach[:, None] / np.where(table > 0.0, table, 1.0), np.inf)  # fmt: skip
        implied = need.min(axis=0, initial=np.inf)
        new = (sizes == 0.0) & np.isfinite(implied)
        if not new.any():
            break
        sizes = np.where(new, implied, sizes)
    return sizes
