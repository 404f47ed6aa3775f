"""Detection of discontinuities in objectives and conditions as functions of the unknowns.

A search follows derivatives, which do not contain a jump: `Heaviside(F)` has the slope zero on both
sides, so that its cost is invisible. A kink, such as that of `Abs(F)`, is continuous and allowed.

Each side of a switch is extended beyond the switching surface (`sides`). If both extensions are the
same node, the expression is continuous there. Otherwise Newton's method moves points within the
bounds onto the switching surface, and the difference of the two sides is compared with its rounding
bound. Points start on both sides of all other switches, so that nested switches are tested in each
of their branches.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._errors import warn_user
from pydy._graph import (
    Branches,
    Graph,
    SymPyReader,
    inputs_of,
    jacobian,
    rounding_bounds,
    substitute,
)
from pydy._rank import HALF, ROUNDING
from pydy.control.transcription import TranscribedProblem
from pydy.control.tuning import ON_SURFACE, SURFACE_POINTS, SURFACE_STEPS

if TYPE_CHECKING:
    from pydy._assembly import Definition
    from pydy._sympy_types import AnySymbol
    from pydy.control.result import OptimalTrajectory

_DECADES = 9.0  # samples of unknowns without bounds have sizes up to this power of ten
# Functions that a message names by themselves; for others it shows the full expression.
_JUMPING = (sm.Heaviside, sm.sign, sm.floor, sm.ceiling, sm.frac, sm.Mod, sm.Piecewise, sm.atan2)


class Range(NamedTuple):
    """An unknown: its name and its bounds."""

    name: str
    low: float
    high: float


class Discontinuity(NamedTuple):
    """A discontinuity of an expression."""

    node: int  # the switch, which is zero at the discontinuity
    position: str  # the unknowns that the switch depends on, with their values
    step: float  # the size of the jump

    def text(self, part: str) -> str:
        """Return a text for a message; `part` is the discontinuous expression."""
        return f"`{part}`, which jumps by {self.step:.3g} at {self.position}"


@dataclass(frozen=True, eq=False)
class _Surfaces:
    """Samples of the unknowns, inputs ``('x', k)``, with fixed values of all other inputs."""

    graph: Graph
    ranges: Sequence[Range]
    fixed: Mapping[int, np.ndarray]  # inputs, each with values for all points

    def values(self, nodes: Sequence[int], X: np.ndarray) -> np.ndarray:
        """Return values of nodes at points X (m, n), shape (m, nodes)."""
        m = len(X)
        inputs = {self.graph.input("x", k): column for k, column in enumerate(X.T)}
        inputs |= {node: np.resize(row, m) for node, row in self.fixed.items()}
        return self.graph.evaluator(nodes)(inputs, m)

    def starts(self) -> tuple[np.ndarray, np.ndarray]:
        """Return random points within the bounds, and the scales of their entries, (m, n) each."""
        random, m = np.random.default_rng(0), SURFACE_POINTS
        columns, sizes = [], []
        together = 10.0 ** random.uniform(-_DECADES, _DECADES, m)
        for _, low, high in self.ranges:
            if np.isfinite(low) and np.isfinite(high):
                columns.append(random.uniform(low, high, m))
                sizes.append(np.full(m, high - low))
                continue
            alone = 10.0 ** random.uniform(-_DECADES, _DECADES, m)
            kinds = [np.ones(m), together, alone]
            size = np.choose(np.arange(m) % 3, kinds)
            near = low if np.isfinite(low) else high if np.isfinite(high) else 0.0
            away = random.uniform(-1.0, 1.0, m) * size
            columns.append(np.clip(near + away, low, high))
            sizes.append(size)
        return np.array(columns).T, np.array(sizes).T

    def onto(
        self, switch: int, X: np.ndarray, sizes: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Move points onto a surface; return those that converged, their scales and the slopes."""
        graph, n = self.graph, len(self.ranges)
        low, high = (np.array([getattr(r, side) for r in self.ranges]) for side in ("low", "high"))
        unknowns = [graph.input("x", k) for k in range(n)]
        nodes = [
            switch,
            *rounding_bounds(graph, [switch]),
            *jacobian(graph, [switch], unknowns).flat(),
        ]
        weights = sizes**2
        with np.errstate(all="ignore"):  # some points may diverge
            for _ in range(SURFACE_STEPS):
                values = self.values(nodes, X)
                value, slopes = values[:, 0], values[:, 2:]
                direction = weights * slopes
                move = -value[:, None] * direction / (direction * slopes).sum(axis=1, keepdims=True)
                target = X + np.where(np.isfinite(move), move, 0.0)
                moved = np.clip(target, low, high)
                weights = np.where(
                    moved == target, weights, 0.0
                )  # an unknown at its bound stays there
                if (moved == X).all():
                    break
                X = moved
            values = self.values(nodes, X)
            arrived = np.abs(values[:, 0]) <= ON_SURFACE * ROUNDING * values[:, 1]
            arrived &= np.isfinite(values).all(axis=1) & (values[:, 2:] != 0.0).any(axis=1)
        return X[arrived], sizes[arrived], values[arrived, 2:]

    def both_sides(
        self, switch: int, X: np.ndarray, sizes: np.ndarray, slopes: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return points on both sides of a surface, clipped to the bounds."""
        low, high = (np.array([getattr(r, side) for r in self.ranges]) for side in ("low", "high"))
        away = HALF * sizes * np.sign(slopes)
        return np.clip(X + away, low, high), np.clip(X - away, low, high)


def jumps_of(
    graph: Graph, node: int, ranges: Sequence[Range], fixed: Mapping[int, np.ndarray]
) -> Iterator[Discontinuity]:
    """Yield the discontinuities of a node as inputs ``('x', k)`` vary within their ranges."""
    switches = [
        s
        for s in Branches(graph, [node]).switches(whole=True)
        if "x" in inputs_of(graph, [s]).groups
    ]
    surfaces = _Surfaces(graph, ranges, fixed)
    for switch in switches:
        (above,), (below,) = Branches(graph, [node]).sides(switch)
        if above == below:
            continue
        starts = [surfaces.starts()]
        for other_switch in switches:
            if other_switch != switch:
                X, sizes, slopes = surfaces.onto(other_switch, *starts[0])
                starts += [(x, sizes) for x in surfaces.both_sides(other_switch, X, sizes, slopes)]
        X, sizes = (np.concatenate(parts) for parts in zip(*starts, strict=True))
        X, sizes, slopes = surfaces.onto(switch, X, sizes)
        if not len(X):
            continue  # the surface lies outside the bounds
        step = graph.sub(above, below)
        nodes = [node, above, below, step, *rounding_bounds(graph, [step])]
        node_values, high, low, steps, bounds = surfaces.values(nodes, X).T
        upper, lower = surfaces.both_sides(switch, X, sizes, slopes)
        with np.errstate(all="ignore"):
            # If the bounds exclude one side, compare the other one with the surface itself.
            reached = [surfaces.values([switch], x)[:, 0] for x in (upper, lower)]
            steps = np.where(reached[1] >= 0.0, high - node_values, steps)
            steps = np.where(reached[0] <= 0.0, low - node_values, steps)
            jumping = np.abs(steps) > ON_SURFACE**2 * ROUNDING * bounds
        if jumping.any():
            k = int(np.flatnonzero(jumping)[0])
            yield Discontinuity(
                switch,
                _describe_position(graph, switch, ranges, X[k], sizes[k]),
                float(abs(steps[k])),
            )


def _describe_position(
    graph: Graph, switch: int, ranges: Sequence[Range], x: np.ndarray, sizes: np.ndarray
) -> str:
    """Return the unknowns that a switch depends on, with their values."""
    inputs = set(inputs_of(graph, [switch]))
    texts = []
    for k, (name, *_) in enumerate(ranges):
        if graph.input("x", k) in inputs:
            value = 0.0 if abs(x[k]) <= ROUNDING * sizes[k] else float(x[k])
            texts.append(f"{name} = {value:.6g}")
    return ", ".join(texts)


def _switches_at(graph: Graph, node: int, switch: int) -> bool:
    """Return whether a node has two branches at a switch."""
    if switch not in Branches(graph, [node]).switches(whole=True):
        return False
    above, below = Branches(graph, [node]).sides(switch)
    return above != below


def branching(definition: Definition) -> dict[AnySymbol, sm.Expr]:
    """Return the outputs with branches, such as an absolute value, and their expressions."""
    symbols = {*definition.states, *definition.specifieds, *definition.constants}
    kinds = (sm.Abs, sm.Max, sm.Min, *_JUMPING)
    branching_outputs = {}
    for group in definition.outputs.groups:
        for name, expression in zip(group.names, group.expressions, strict=True):
            if isinstance(expression, sm.Expr) and expression.has(*kinds):
                remainder = expression.xreplace(dict.fromkeys(symbols, sm.S.One))
                strange = remainder.has(AppliedUndef, sm.Derivative)
                if remainder.free_symbols <= {definition.equations.time} and not strange:
                    branching_outputs[name] = expression
    return branching_outputs


# -- the expressions of a problem ------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Expressions:
    """Reads the expressions of a problem into a graph whose unknowns are inputs ``('x', k)``."""

    problem: TranscribedProblem
    # Names and bounds of states, their rates, controls, free constants and the duration.
    ranges: Mapping[tuple[str, int], Range]
    at_instants: Sequence[Range]  # of values at instants

    def jump(self, expression: sm.Expr, argument: str, *, instants: bool = False) -> str:
        """Describe the first discontinuity of an expression, or return ''.

        The branch cut of `atan2` is ignored: a motion on either side of it is smooth.
        """
        graph = self.problem.equations.graph.copy()
        substitutions, ranges, fixed = self._inputs(graph, instants)

        def read(part: sm.Expr) -> int:
            return substitute(graph, self._read(graph, part, argument, instants), substitutions)[0]

        node = read(expression)
        nodes = {part: read(part) for part in expression.atoms(*_JUMPING)}
        names = dict(zip((i.symbol for i in self.problem.instants), self.at_instants, strict=True))
        for discontinuity in jumps_of(graph, node, ranges, fixed):
            switching = [e for e, n in nodes.items() if _switches_at(graph, n, discontinuity.node)]
            part = min(switching or [expression], key=lambda e: (e.count_ops(), str(e)))
            if not isinstance(part, sm.atan2):
                named = {symbol: sm.Symbol(unknown.name) for symbol, unknown in names.items()}
                return discontinuity.text(str(part.xreplace(named)))
        return ""

    @property
    def switch(self) -> bool:
        """Whether the integrand or a condition of the path has branches at all."""
        p, graph = self.problem, self.problem.equations.graph.copy()
        every = [(p.running, "`objective`"), *((c.expression, "`path`") for c in p.path)]
        nodes = [n for e, argument in every for n in self._read(graph, e, argument, False)]
        return bool(Branches(graph, nodes).switches(whole=True))

    def crossing(
        self, expression: sm.Expr, argument: str, motion: OptimalTrajectory, active: np.ndarray
    ) -> str:
        """Describe the first jump of a path expression along a motion, or return ''.

        Only jumps next to a time, (m,), at which the expression is `active` count.
        """
        graph, times = self.problem.equations.graph.copy(), motion.times
        substitutions, ranges, fixed = self._inputs(
            graph, False, times / motion.duration, motion.duration
        )
        node = substitute(graph, self._read(graph, expression, argument, False), substitutions)[0]
        X = None
        for jump in jumps_of(graph, node, ranges, fixed):
            if X is None:
                X = self._unknowns_along(motion)
            surfaces = _Surfaces(graph, ranges, fixed)
            value = surfaces.values([jump.node], X)[:, 0]
            (above,), (below,) = Branches(graph, [node]).sides(jump.node)
            step = graph.sub(above, below)
            steps, bounds = surfaces.values([step, *rounding_bounds(graph, [step])], X).T
            differs = np.abs(steps) > ON_SURFACE**2 * ROUNDING * bounds
            # A point on the surface belongs to the side of the point before it.
            last = np.maximum.accumulate(np.where(value != 0.0, np.arange(len(value)), 0))
            side = np.sign(value[last])
            crossed = (side[1:] * side[:-1] < 0.0) & differs[1:] & differs[:-1]
            crossed &= active[1:] | active[:-1]
            if crossed.any():
                k = int(np.flatnonzero(crossed)[0])
                return (
                    f"`{expression}`, which jumps by {abs(steps[k]):.3g} between t = "
                    f"{times[k]:.6g} and {times[k + 1]:.6g}"
                )
        return ""

    def _unknowns_along(self, motion: OptimalTrajectory) -> np.ndarray:
        """Return the unknowns along a motion, (m, n)."""
        assert motion._model is not None
        rates = motion._model.derivatives(motion.times, motion.states)
        _, _, constants, duration = motion._transcription.split(motion.solution.z)
        controls = motion._transcription.controls_at(motion.solution.z, motion.times)
        free = dict(zip(self.problem.free, constants, strict=False))
        columns: dict[str, Callable[[int], np.ndarray]] = {
            "x": lambda k: motion.states[:, k],
            "d": lambda k: rates[:, k],
            "r": lambda k: controls[:, self.problem.controls.index(k)],
            "p": lambda k: np.full(len(motion.times), free[k]),
            "T": lambda k: np.full(len(motion.times), duration),
        }
        return np.array([columns[group](k) for group, k in self.ranges]).T

    def _read(self, graph: Graph, expression: sm.Expr, argument: str, instants: bool) -> list[int]:
        p = self.problem
        if not instants:
            return p.equations.read(graph, [expression], argument, p.named)
        atoms = {s: graph.input("p", k) for s, k in p.symbols.items()}
        atoms[p.duration_symbol] = graph.input("T", 0)
        atoms |= {i.symbol: graph.input("i", k) for k, i in enumerate(p.instants)}
        return SymPyReader(graph, atoms, argument).all([expression])

    def _inputs(
        self,
        graph: Graph,
        instants: bool,
        fractions: np.ndarray | None = None,
        duration: float | None = None,
    ) -> tuple[dict[int, int], list[Range], dict[int, np.ndarray]]:
        """Return substitutions for the inputs, the ranges of unknowns, and fixed input values.

        Fixed inputs are evaluated at `fractions` of the motion, by default random ones.
        """
        p = self.problem
        substitutions: dict[int, int] = {}
        for group, values in (("p", p.constants), ("r", p.specifieds)):
            substitutions |= {
                graph.input(group, k): graph.const(float(v)) for k, v in enumerate(values)
            }
        ranges: list[Range] = []
        further = self.at_instants if instants else ()
        instant_ranges = {("i", k): unknown for k, unknown in enumerate(further)}
        for key, unknown in {**self.ranges, **instant_ranges}.items():
            substitutions[graph.input(*key)] = graph.input("x", len(ranges))
            ranges.append(unknown)
        if fractions is None:
            fractions = np.random.default_rng(1).uniform(0.0, 1.0, SURFACE_POINTS)
        fixed: dict[int, np.ndarray] = {}
        time = graph.input("t", 0)
        if p.duration is None:
            # The duration is unknown: each point has a fixed fraction of it.
            (low, high), at = self.ranges["T", 0][1:], graph.input("r", 0)
            duration = duration or (high if np.isfinite(high) else max(low, 1.0))
            substitutions[time] = graph.mul(substitutions[graph.input("T", 0)], at)
            fixed[at] = fractions
        else:
            duration = p.duration
            substitutions[time] = graph.input("r", 0)
            substitutions[graph.input("T", 0)] = graph.const(duration)
            fixed[substitutions[time]] = duration * fractions
        for columns, samples in p.signals:
            for k, row in zip(columns.tolist(), samples.rows(duration * fractions).T, strict=True):
                substitutions[graph.input("r", k)] = node = graph.input("r", len(fixed))
                fixed[node] = row
        return substitutions, ranges, fixed


def refuse_jumps(expressions: Expressions) -> None:
    """Refuse a discontinuous objective."""
    p = expressions.problem
    for term, instants in ((p.running, False), (p.terminal, True)):
        message = expressions.jump(sm.sympify(term), "`objective`", instants=instants)
        if message:
            raise ValueError(
                f"`objective` has {message}. A search follows derivatives, which do not contain "
                "the jump: its result would be arbitrary. Use a smooth expression, such as "
                "(1 + tanh(a/w))/2 for Heaviside(a) with a small width w, keep away from the jump "
                "with `bounds`, or solve `phases` of which each lies on one side."
            )


def warn_of_crossings(expressions: Expressions, motion: OptimalTrajectory) -> None:
    """Warn if the objective or an active condition is discontinuous along a solution."""
    p = expressions.problem
    message = expressions.crossing(
        sm.sympify(p.running), "`objective`", motion, np.ones(len(motion.times), dtype=bool)
    )
    part = "`objective`"
    for condition in () if message else p.path:
        active = motion.active(condition.label)
        message = expressions.crossing(condition.expression, "`path`", motion, active)
        if message:
            part = "a condition of `path`"
            break
    if message:
        warn_user(
            f"The solution crosses a jump: {part} contains {message}. Derivatives do not contain "
            "it: this motion is the best of those that cross it near the same times; others may "
            "be better. Compare other guesses, or solve `phases` that end at the jump."
        )


def jumping_conditions(expressions: Expressions) -> str:
    """Return a hint on discontinuous path and boundary conditions, for a search that failed."""
    p = expressions.problem
    for argument, conditions in (("path", p.path), ("boundary", p.boundary)):
        for condition in conditions:
            message = expressions.jump(
                condition.expression, f"`{argument}`", instants=argument == "boundary"
            )
            if message:
                return (
                    f" The condition `{condition.label}` of `{argument}` has {message}: its "
                    "derivatives do not contain the jump, so that a search does not know on which "
                    "side of it to stay. Give a condition on what it depends on, such as "
                    "a <= 0 for Heaviside(a) <= 1/2."
                )
    return ""
