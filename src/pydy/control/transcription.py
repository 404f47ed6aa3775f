"""A motion on a mesh as a nonlinear program, and numbers of the program as a motion.

The unknowns are ordered as states by slots, controls by slots, constants, and the duration. See
`schemes` for slots; the first of them are the nodes of the mesh.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from pydy._forks import cached_property
from pydy.control.kernel import Equations, Functions, Point
from pydy.control.nlp import Nlp, Piece
from pydy.control.schemes import Points, Scheme

__all__ = ["Condition", "Instant", "Problem", "Transcription"]


@dataclass(frozen=True)
class Condition:
    """``low ≤ expression ≤ high``.

    Attributes
    ----------
    expression : SymPy expression
    low, high : float
    label : str
    """

    expression: Any
    low: float
    high: float
    label: str


@dataclass(frozen=True)
class Instant:
    """A state or control at one time.

    Attributes
    ----------
    symbol : Symbol
        What stands for it in conditions and the objective.
    kind : {'state', 'control'}
    index : int
    fraction : float
        The time, as a fraction of the duration.
    """

    symbol: Any
    kind: str
    index: int
    fraction: float


@dataclass(frozen=True, eq=False)
class Problem:
    """An optimal control problem as ordered data.

    Attributes
    ----------
    equations : Equations
    states : int
    labels : tuple of str
        Of the equations.
    constraints : tuple of str
        Labels of those of the constraints that the start has to satisfy.
    controls : tuple of int
        Places in r.
    control_bounds : ndarray, shape (c, 2)
        Low and high.
    signals : tuple of (int, callable)
        Places in r of known signals, and their values at times.
    free : tuple of int
        Places in p of constants that are unknown.
    constants, specifieds : ndarray
        p and r; those that are unknown or signals do not count.
    duration : float or None
        None if it is unknown.
    duration_symbol : Symbol or None
    symbols : mapping of symbols to (str, int)
        The constants, as ('p', place).
    running, terminal : SymPy expressions
        The objective is the integral of the first plus the second.
    instants : tuple of Instant
    boundary, path : tuple of Condition
    hessian : bool
        Whether the exact Hessian is compiled.
    """

    equations: Equations
    states: int
    labels: tuple[str, ...]
    constraints: tuple[str, ...]
    controls: tuple[int, ...]
    control_bounds: np.ndarray
    signals: tuple[tuple[int, Any], ...]
    free: tuple[int, ...]
    constants: np.ndarray
    specifieds: np.ndarray
    duration: float | None
    duration_symbol: Any
    symbols: Mapping[Any, int]
    running: Any
    terminal: Any
    instants: tuple[Instant, ...]
    boundary: tuple[Condition, ...]
    path: tuple[Condition, ...]
    hessian: bool = True
    _compiled: dict[Any, Functions] = field(default_factory=dict, repr=False)

    @property
    def algebraic(self) -> int:
        """Number of controls, slack velocities and multipliers, which have the same slots."""
        return len(self.controls) + len(self.equations.constraints)

    @property
    def numbers(self) -> np.ndarray:
        """The constants P of all points: p, r and the duration."""
        duration = np.nan if self.duration is None else self.duration
        return np.concatenate([self.constants, self.specifieds, [duration]])

    # -- machine code, for any mesh ----------------------------------------------------------------

    def at_points(self, points: Points) -> Functions:
        """Return the equations, path conditions and the objective's part of collocation points."""
        key = (points.state, points.rate)
        if key not in self._compiled:
            self._compiled[key] = self._at_points(points)
        return self._compiled[key]

    def _at_points(self, points: Points) -> Functions:
        point, n = self._point(), self.states
        values = [point.variables(n) for _ in range(len(points.slots))]
        controls = point.variables(self.algebraic)
        constants, T = self._unknown_numbers(point)
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
        at = {("t", 0): g.mul(T, fraction), ("T", 0): T}
        at |= self._inputs(point, x, constants)
        at |= {("d", k): node for k, node in enumerate(slopes)}
        own = len(self.controls)
        at |= {("r", k): node for k, node in zip(self.controls, controls[:own], strict=True)}
        at |= {("s", k): node for k, node in enumerate(controls[own:])}
        rows = point.residuals(at)
        if self.path:
            path = [c.expression for c in self.path]
            rows += point.read(path, "`path`", at, self.duration_symbol)
        cost = None
        if self.running != 0:
            integrand = point.read([self.running], "`objective`", at, self.duration_symbol)
            cost = g.mul(T, weight, integrand[0])
        return point.functions(rows, cost, hessian=self.hessian)

    def _inputs(
        self, point: Point, x: Sequence[int], constants: Sequence[int]
    ) -> dict[tuple[str, int], int]:
        """Return the nodes of states, constants and known specifieds."""
        known = len(self.constants)
        at = {("x", k): node for k, node in enumerate(x)}
        at |= {("p", k): node for k, node in enumerate(constants)}
        at |= {("r", k): point.constant(known + k) for k in range(len(self.specifieds))}
        signals = point.data(len(self.signals))
        at |= {("r", k): node for (k, _), node in zip(self.signals, signals, strict=True)}
        return at

    def at_start(self) -> Functions:
        """Return the constraints at the start."""
        if "start" not in self._compiled:
            point = self._point()
            x = point.variables(self.states)
            constants, T = self._unknown_numbers(point)
            at = {("t", 0): point.graph.zero, ("T", 0): T, **self._inputs(point, x, constants)}
            rows = point.constraints(at)
            self._compiled["start"] = point.functions(rows, None, hessian=self.hessian)
        return self._compiled["start"]

    def _point(self) -> Point:
        return Point(self.equations, len(self.constants) + len(self.specifieds) + 1)

    def _unknown_numbers(self, point: Point) -> tuple[list[int], int]:
        """Return the nodes of all constants and of the duration."""
        nodes = [point.constant(k) for k in range(len(self.constants))]
        for k, node in zip(self.free, point.variables(len(self.free)), strict=True):
            nodes[k] = node
        if self.duration is None:
            return nodes, point.variables(1)[0]
        return nodes, point.constant(len(self.constants) + len(self.specifieds))

    def at_instants(self, scheme: Scheme) -> Functions | None:
        """Return the boundary conditions and the objective's other part."""
        if not self.boundary and self.terminal == 0:
            return None
        if "boundary" not in self._compiled:
            self._compiled["boundary"] = self._at_instants(scheme)
        return self._compiled["boundary"]

    def _at_instants(self, scheme: Scheme) -> Functions:
        point = self._point()
        constants, T = self._unknown_numbers(point)
        atoms = {s: constants[k] for s, k in self.symbols.items()}
        if self.duration_symbol is not None:
            atoms[self.duration_symbol] = T
        start = np.zeros(1)
        powers = scheme.basis(start)[1].tolist()
        flat = [0] * len(scheme.control_basis(start))
        for instant in self.instants:
            own = powers if instant.kind == "state" else flat
            nodes, data = point.variables(len(own)), point.data(len(own))
            terms = [(v, [c], p) for v, c, p in zip(nodes, data, own, strict=True)]
            # Each instant has an interval of its own.
            h = point.graph.mul(T, point.data(1)[0])
            atoms[instant.symbol] = point.combined(terms, h)
        expressions = [*(c.expression for c in self.boundary), self.terminal]
        nodes = point.read_with(expressions, "`boundary` and `objective`", atoms)
        cost = None if self.terminal == 0 else nodes[-1]
        return point.functions(nodes[:-1], cost, hessian=self.hessian)


@dataclass(frozen=True, eq=False)
class Transcription:
    """A problem on a mesh.

    Attributes
    ----------
    problem : Problem
    scheme : Scheme
    mesh : ndarray, shape (M + 1,)
        The nodes as fractions of the duration, from 0 to 1.
    """

    problem: Problem
    scheme: Scheme
    mesh: np.ndarray

    # -- where the unknowns are -------------------------------------------------------------------

    @cached_property
    def places(self) -> tuple[np.ndarray, np.ndarray]:
        """The times of the states' slots as fractions, and whether they are slopes."""
        return self.scheme.places(self.mesh)

    @cached_property
    def control_places(self) -> np.ndarray:
        """The times of the controls' slots as fractions."""
        return self.scheme.control_places(self.mesh)

    @property
    def intervals(self) -> int:
        """Number of intervals."""
        return len(self.mesh) - 1

    @property
    def sizes(self) -> tuple[int, int, int, int]:
        """Numbers of unknowns: of states, controls, constants and the duration."""
        p = self.problem
        states, controls = len(self.places[0]), len(self.control_places)
        return (p.states * states, p.algebraic * controls, len(p.free), p.duration is None)

    def split(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
        """Return states (n, slots), controls (c, slots), free constants and the duration.

        Slack velocities and multipliers of constraints follow the controls.
        """
        p = self.problem
        states, controls, constants, duration = np.split(z, np.cumsum(self.sizes)[:3])
        return (
            states.reshape(p.states, len(self.places[0])),
            controls.reshape(p.algebraic, len(self.control_places)),
            constants,
            float(duration[0]) if p.duration is None else p.duration,
        )

    def joined(
        self, states: np.ndarray, controls: np.ndarray, constants: Any, duration: Any
    ) -> np.ndarray:
        """Return the unknowns, of what `split` returns."""
        last = [duration] if self.problem.duration is None else []
        parts = (np.ravel(states), np.ravel(controls), np.asarray(constants, float), last)
        return np.concatenate(parts).astype(float)

    def _numbers_at(self, count: int) -> np.ndarray:
        """Return the places of constants and duration, for each of some points."""
        first, total = sum(self.sizes[:2]), sum(self.sizes)
        return np.repeat(np.arange(first, total)[:, None], count, axis=1)

    # -- the program ------------------------------------------------------------------------------

    def nlp(self, lower: np.ndarray, upper: np.ndarray, sizes: np.ndarray) -> Nlp:
        """Return the program; bounds and sizes are those of the unknowns."""
        return Nlp(self.pieces, self.problem.numbers, lower, upper, sizes)

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The functions of the program with their unknowns."""
        made = [self._piece(points) for points in self.scheme.points(self.mesh)]
        if self.problem.constraints:
            made.append(self.beginning())
        ends = self._ends()
        return tuple(made) if ends is None else (*made, ends)

    def _piece(self, points: Points) -> Piece:
        p, n = self.problem, self.problem.states
        slots, own = len(self.places[0]), len(self.control_places)
        count = len(points.fractions)
        states = [k * slots + row for row in points.slots for k in range(n)]
        first = self.sizes[0]
        controls = [first + k * own + points.controls for k in range(p.algebraic)]
        times = points.fractions * (1.0 if p.duration is None else p.duration)
        signals = [signal(times) for _, signal in p.signals]
        data = [points.fractions, points.lengths, points.weights, *points.coefficients, *signals]
        return Piece(
            p.at_points(points),
            np.concatenate([np.array([*states, *controls]), self._numbers_at(count)]),
            np.ascontiguousarray(data),
            *_limits(len(p.labels), p.path),
            (*p.labels, *(c.label for c in p.path)),
            points.fractions,
            True,
        )

    def beginning(self) -> Piece:
        """Return the constraints at the start."""
        p = self.problem
        count = len(p.equations.constraints)
        states = np.arange(p.states) * len(self.places[0])
        signals = [signal(np.zeros(1)) for _, signal in p.signals]
        return Piece(
            p.at_start(),
            np.concatenate([states, self._numbers_at(1)[:, 0]])[:, None],
            np.array(signals, dtype=float).reshape(-1, 1),
            *_limits(count, ()),
            p.constraints or tuple(p.labels[-count:]),
            np.zeros(1),
            False,
        )

    def _ends(self) -> Piece | None:
        p = self.problem
        functions = p.at_instants(self.scheme)
        if functions is None:
            return None
        at, data = [self._numbers_at(1)[:, 0]], []
        for instant in p.instants:
            slots, values, h = self.located(instant.kind, instant.fraction)
            first, own = (0, len(self.places[0])) if instant.kind == "state" else (
                self.sizes[0], len(self.control_places))  # fmt: skip
            at.append(first + instant.index * own + slots)
            data += [values, [h]]
        fractions = {i.fraction for i in p.instants}
        return Piece(
            functions,
            np.concatenate(at)[:, None],
            np.concatenate([[], *data])[:, None],
            *_limits(0, p.boundary),
            tuple(c.label for c in p.boundary),
            np.array([fractions.pop() if len(fractions) == 1 else np.nan]),
            False,
        )

    def located(self, kind: str, fraction: float) -> tuple[np.ndarray, np.ndarray, float]:
        """Return slots, their coefficients and the interval's length for a time."""
        k = int(np.clip(np.searchsorted(self.mesh, fraction, "right") - 1, 0, self.intervals - 1))
        h = float(self.mesh[k + 1] - self.mesh[k])
        s = np.array([(fraction - self.mesh[k]) / h])
        if kind == "state":
            return (
                self.scheme.interval_slots(self.intervals)[:, k],
                self.scheme.basis(s)[0][:, 0],
                h,
            )
        slots = self.scheme.control_slots(self.intervals)[:, k]
        return slots, self.scheme.control_basis(s)[:, 0], h

    # -- between the points -----------------------------------------------------------------------

    def states_at(self, z: np.ndarray, times: np.ndarray) -> np.ndarray:
        """Return the states at m times by the collocation polynomials, shape (m, n)."""
        values, _, _, duration = self.split(z)
        k, s = self._local(times / duration)
        basis, powers = self.scheme.basis(s)
        h = np.diff(self.mesh)[k] * duration
        slots = self.scheme.interval_slots(self.intervals)[:, k]
        weights = basis * h ** powers[:, None]
        found: np.ndarray = np.einsum("nym,ym->mn", values[:, slots], weights)
        return found

    def controls_at(self, z: np.ndarray, times: np.ndarray) -> np.ndarray:
        """Return the controls at m times, shape (m, c), those of the interval before at a node."""
        return self.controls_in(z, *self._local(times / self.split(z)[3], "left"))

    def controls_in(self, z: np.ndarray, k: np.ndarray, s: np.ndarray) -> np.ndarray:
        """Return the controls at fractions s of intervals k, shape (m, c).

        A polynomial that leaves the bounds between its points is held at them.
        """
        slots = self.scheme.control_slots(self.intervals)[:, k]
        basis = self.scheme.control_basis(s)
        values = self.split(z)[1][: len(self.problem.controls)]
        found = np.einsum("cym,ym->mc", values[:, slots], basis)
        within: np.ndarray = np.clip(found, *self.problem.control_bounds.T)
        return within

    def _local(
        self, fractions: np.ndarray, side: Literal["left", "right"] = "right"
    ) -> tuple[np.ndarray, np.ndarray]:
        k = np.clip(np.searchsorted(self.mesh, fractions, side) - 1, 0, self.intervals - 1)
        return k, (fractions - self.mesh[k]) / np.diff(self.mesh)[k]


def _limits(equations: int, conditions: Sequence[Condition]) -> tuple[np.ndarray, np.ndarray]:
    """Return the bounds of equations, which are zero, and of conditions after them."""
    zeros = [0.0] * equations
    low, high = ([getattr(c, side) for c in conditions] for side in ("low", "high"))
    return np.array([*zeros, *low]), np.array([*zeros, *high])
