"""Numbers at generic states that keep the constraints: what ranks and identities are judged by.

Quaternions are of length one, whether a constraint says so or not. A user may have simplified a
velocity or a rate with a constraint, so that it holds only there. All symbols that are not states
count as specifieds: the search for a consistent state may move them too, since a four-bar with
lengths chosen at random need not close.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from sympy.core.function import AppliedUndef

from pydy._graph import Graph, SymPyReader, jacobian, per_unit, rounding_bounds
from pydy._mechanics.equations import Equations
from pydy._mechanics.frame_tree import FrameTree, numbers_in_places
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.symbols import find_symbols, rate_of, sort_symbols
from pydy._mechanics.tuning import FULL_STEPS, OPEN
from pydy._rank import HALF, ROUNDED, equilibrated, or_one

_STEPS = 50
_NEAR = 0.03  # of the largest number of a configuration: how far beside it samples begin

AROUND = 60  # more, where rows seem redundant: in a three-stage lift each sixth finds its shape
_LOW, _HIGH = 0.3, 1.3  # generic coordinates and speeds

_STATE = ("time of the state", "state", "specifieds at the state")

Block = tuple[str, tuple[int, ...], list[int]]
Inputs = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]  # t, x, r, p


class GenericStates:
    """Expressions of a system as nodes of a graph, and their values at generic states.

    `expressions` are read besides the constraints and the kinematics; `what` names them in
    messages. The `inputs` are all that they hold, with time; `moving` has what moves with its rate:
    coordinates, time, and specifieds whose derivatives occur.
    """

    def __init__(self, equations: Equations, expressions: Iterable[Any], what: str) -> None:
        graph = self.graph = Graph()
        t, q, u = equations.time, equations.coordinates, equations.speeds
        states = [*q, *u]
        made_from = self._made_from = equations.mechanism or equations.multibody
        turns = [] if made_from is None else FrameTree(made_from.frame).rotation_matrices()
        kinematics, constraints = equations.kinematics, equations.constraints
        derivatives = kinematics.coordinate_derivatives
        # The rates of what residuals with speeds give hold u', which moves no constraint.
        idle = {*kinematics.speed_rates} & {*find_symbols(derivatives)}
        known = {*states, *kinematics.zeros, t, *kinematics.coordinate_rates, *idle}
        said = *constraints.holonomic, *constraints.velocity, *derivatives
        found = find_symbols((*expressions, *said, *turns)).keys() - known
        found |= {rate_of(s, t) for s in found if isinstance(s, AppliedUndef)}
        others = sort_symbols(found)
        atoms = graph.input_nodes(x=states, r=others, t=[t])
        self.coordinates, self.speeds = [atoms[s] for s in q], [atoms[s] for s in u]
        self._others, time = [atoms[s] for s in others], atoms[t]
        self.inputs = [*self.coordinates, *self.speeds, *self._others, time]
        self._symbols = t, *states, *others
        self._sizes = (len(states), len(others), 0)
        atoms |= dict.fromkeys((*kinematics.zeros, *idle), graph.zero)
        self.read = SymPyReader(graph, atoms, what)
        rates = self.read.all(derivatives)
        # What residuals with speeds give are forces, which no constraint holds: they stay put.
        still = [k for k, e in enumerate(derivatives) if not idle.isdisjoint(find_symbols([e]))]
        for k in still:
            rates[k] = graph.zero
        for rate, node in zip(kinematics.coordinate_rates, rates, strict=True):
            self.read.define(rate, node)
        # A prescribed motion y(t) moves a constraint through y'(t).
        self.moving = [*zip(self.coordinates, rates, strict=True), (time, graph.one)]
        self.moving += [(atoms[s], atoms[s.diff(t)]) for s in others if isinstance(s, AppliedUndef)]
        self._moved = {node for node, _ in self.moving}
        self.holonomic = self.read.all(constraints.holonomic)
        if still:
            implicit = constraints.residuals.implicit
            start = {} if implicit is None else implicit.start
            forces = {self.coordinates[k]: start[q[k]] for k in still}
            held = {*forces, *self.speeds}
            rows = [
                k
                for k in constraints.residuals.rows
                if not held.isdisjoint(graph.reachable([self.holonomic[k]]))
            ]
            for k, (node, value) in zip(rows, forces.items(), strict=True):
                self.holonomic[k] = graph.sum([(node, 1.0)], -value)
        self.velocity = self.read.all(constraints.velocity)
        self._turning = orthogonality_residuals(turns, self.read)

    @cached_property
    def placed(self) -> list[float]:
        """The sizes of the numbers by which bodies are placed, ascending."""
        made = self._made_from
        return [] if made is None else sorted(numbers_in_places(made.frame, made.bodies))

    def leave_out(self, rows: Sequence[int]) -> None:
        """Take constraints, holonomic ones first, as satisfied."""
        split, zero = len(self.holonomic), self.graph.zero
        every = [*self.holonomic, *self.velocity]
        every = [zero if k in rows else node for k, node in enumerate(every)]
        self.holonomic, self.velocity = every[:split], every[split:]

    def changes(self, node: int) -> bool:
        """Return whether a node depends on the configuration or on time."""
        reached = self.graph.reachable([node])
        return not self._moved.isdisjoint(reached)

    def rates(self, nodes: Sequence[int]) -> list[int]:
        """Return derivatives by time."""
        g = self.graph
        rows = jacobian(g, nodes, [node for node, _ in self.moving])
        return [g.sum([(g.mul(d, self.moving[k][1]), 1.0) for k, d in r.items()]) for r in rows]

    def table(self, name: str, nodes: Sequence[int], variables: Sequence[int]) -> Block:
        """Return the block of a Jacobian."""
        return name, (len(nodes), len(variables)), jacobian(self.graph, nodes, variables).flat()

    def samples(
        self,
        blocks: Sequence[Block],
        trials: int,
        *,
        around: bool = False,
        near: Mapping[Any, float] | None = None,
        left_open: bool = False,
    ) -> Iterator[dict[str, np.ndarray]]:
        """Yield the values of blocks at states that keep the constraints, where all are finite.

        The search begins `near` a configuration, or with angles all `around` the circle to find all
        ways in which a linkage can be assembled. Where it ends at none that keeps them, and if they
        may be `left_open`, all states count.
        """
        inputs = self.consistent(trials, around=around, near=near)
        values = evaluator_of(self.graph, blocks)(*inputs)
        finite = np.full(trials, True)
        for block in values.values():
            finite &= np.isfinite(block).reshape(trials, -1).all(axis=1)
        values |= dict(zip(_STATE, inputs, strict=False))
        for k in np.flatnonzero(finite if left_open else self.closed(inputs, finite)):
            yield {name: block[k] for name, block in values.items()}

    def where(
        self, node: int, blocks: Sequence[Block], trials: int
    ) -> Iterator[dict[str, np.ndarray]]:
        """Yield the same at states at which a node is zero, too."""
        own = self.holonomic
        self.holonomic = [*own, node]
        yield from self.kept(blocks, trials, around=True)
        self.holonomic = own

    def kept(
        self, blocks: Sequence[Block], trials: int, **options: Any
    ) -> list[dict[str, np.ndarray]]:
        """Return the `samples` that keep the constraints: none where none does."""
        return closed(list(self.samples([*blocks, *self.closing()], trials, **options)))

    def uncertain(self, samples: Sequence[dict[str, np.ndarray]], cells: Sequence[int]) -> Any:
        """Return bounds on the errors of nodes due to residuals of the constraints.

        Shape (samples, nodes). Roundings add to it, and what is left of the constraints: a step of
        Newton's method takes that away, so the state is not known better than by its length.
        """
        t, x, r = (np.array([s[name] for s in samples]) for name in _STATE)
        free, held = [*self.coordinates, *self._others], self._held()
        blocks = [
            ("held", (len(held),), held),
            ("bounds", (len(held),), rounding_bounds(self.graph, held)),
            self.table("gradient", held, free),
        ]
        at = evaluator_of(self.graph, blocks)(t, x, r, np.zeros((len(t), 0)))
        scaled, rows, columns = equilibrated(np.nan_to_num(at["gradient"]))
        # A step of Newton's method bounds the way to where the constraints hold, four times over:
        # at a double root it goes half the way, and twice for the curvature on it.
        left = (4.0 * np.abs(at["held"]) / ROUNDED + at["bounds"])[..., None] / rows
        steps = np.abs(np.linalg.pinv(scaled, rcond=HALF)) @ left
        errors = {node: self.graph.input("p", k) for k, node in enumerate(free)}
        bounds = rounding_bounds(self.graph, cells, errors=errors)
        known = evaluator_of(self.graph, [("bounds", (len(cells),), bounds)])
        return ROUNDED * known(t, x, r, columns[:, 0] * steps[..., 0])["bounds"]

    def closing(self) -> list[Block]:
        """Return the constraints' derivatives by coordinates and by speeds, and values of both."""
        residuals = [*self.holonomic, *self.velocity]
        bounds = rounding_bounds(self.graph, residuals)
        return [
            self.table("holonomic", self.holonomic, self.coordinates),
            self.table("velocity", self.velocity, self.speeds),
            ("residuals", (len(residuals),), residuals),
            ("bounds", (len(bounds),), bounds),
        ]

    def closed(self, inputs: Inputs, among: np.ndarray) -> np.ndarray:
        """Return which of some states keep the constraints; where none does, all of these count.

        A search may close a loop by lengths that vanish, where values are not finite.
        """
        count = len(inputs[0])
        if not (self.holonomic or self.velocity):
            return among
        values = evaluator_of(self.graph, self.closing())(*inputs)
        every = [{name: block[k] for name, block in values.items()} for k in range(count)]
        found = among & (np.array(openness(every)) < OPEN)
        return found if found.any() else among

    def anywhere(self, blocks: Sequence[Block], sign: float = 1.0) -> dict[str, np.ndarray]:
        """Return the values of blocks at generic states that need not keep the constraints.

        All numbers but time have the same `sign`.
        """
        return generic_values(self.graph, blocks, self._sizes, 3, sign)

    def _held(self) -> list[int]:
        """Return the rows that a state keeps, whatever the speeds.

        Velocity constraints that no speed can keep are conditions for all the rest.
        """
        speeds, g = set(self.speeds), self.graph
        others = [n for n in self.velocity if speeds.isdisjoint(g.reachable([n]))]
        return [*self.holonomic, *self._turning, *others]

    def _beginning(self, trials: int, around: bool, near: Mapping[Any, float]) -> Inputs:
        """Return where the search for consistent states begins."""
        n = len(self.coordinates)
        inputs = generic_inputs(self._sizes, trials)
        x = inputs[1]
        if around:
            x[:, :n] = np.pi * (2.0 * (x[:, :n] - _LOW) / (_HIGH - _LOW) - 1.0)
        moved = self._symbols[1 : 1 + n]
        sizes = dict(zip(moved, self._beside(moved, near), strict=True)) if near else {}
        for symbol, column in self.by_symbol(inputs).items():
            if symbol in near:
                size = _NEAR * sizes.get(symbol, 0.0)
                column[:] = near[symbol] + size * (column - 1.0)
        return inputs

    def _resized(self, inputs: Inputs, near: Mapping[Any, float], gradient: np.ndarray) -> bool:
        """Scale free lengths from order one to the size of the mechanism.

        Beside legs of one metre, offsets of nanometres vanish, and rows seem to follow from others.
        The mechanism's lengths are those `near` which it is assembled, or the levers of angles, as
        the `gradient` has them, or the numbers by which bodies are placed.
        """
        placed = max(self.placed, default=0.0)
        if row_units(np.full((1, 1, 1), placed)) == 1.0 and (column_units(gradient) == 1.0).all():
            return False
        steep, sizes = self._per_unit(), np.nan_to_num(np.abs(gradient)).max(axis=0, initial=0.0)
        n = len(self.coordinates)
        free = (*self._symbols[1 : 1 + n], *self._symbols[1 + inputs[1].shape[1] :])
        long = np.array([isinstance(s, AppliedUndef) for s in free]) & (steep == 0.0)
        given = [abs(near[s]) for s, own in zip(free, long, strict=True) if own and s in near]
        turns = steep > 0.0
        turned = (sizes[:, turns] / steep[turns]).max(axis=1, keepdims=True, initial=0.0)
        found = np.where(sizes > 0.0, turned / or_one(sizes), 0.0).max(axis=0, initial=0.0)
        found[found == 0.0] = found[long].max(initial=0.0) or placed
        if any(given):
            found[:] = max(given)
        units, known = row_units(found[None, :, None]), self.by_symbol(inputs)
        for k in np.flatnonzero(long):
            if free[k] not in near:
                known[free[k]] *= units[k]
        return True

    def _beside(self, moved: Sequence[Any], near: Mapping[Any, float]) -> list[float]:
        """Return how large coordinates are near a configuration, each in its unit.

        Angles and quaternions are numbers: beside lengths in nanometres or in any other unit they
        are as large as they are among themselves, or as one.
        """
        steep = self._per_unit()[: len(moved)]
        given = np.array([abs(near.get(s, 0.0)) for s in moved])
        largest = max((abs(value) for value in near.values()), default=0.0)
        lengths = given[steep == 0.0].max(initial=0.0) or largest
        turned = max(float((given * steep).max(initial=0.0)), 1.0)
        return [min(largest, turned / s) if s > 0.0 else lengths for s in steep]

    def _per_unit(self) -> np.ndarray:
        """Return the natural units of coordinates and free numbers; see `per_unit`.

        Coordinates come first, then all symbols without a value.
        """
        graph, places = self.graph, [*self.coordinates, *self._others]
        slopes = per_unit(graph, [*self.holonomic, *self.velocity], places)
        at = self.anywhere([("slopes", (len(places),), slopes)])
        found: np.ndarray = np.nan_to_num(at["slopes"]).max(axis=0, initial=0.0)
        turning = {*graph.reachable(self._turning)}
        found[[k for k, node in enumerate(places) if node in turning]] = 1.0
        return found

    def by_symbol(self, inputs: Inputs) -> dict[Any, np.ndarray]:
        """Return the numbers of each symbol, as views."""
        t, x, r, _ = inputs
        return dict(zip(self._symbols, [t, *x.T, *r.T], strict=True))

    def consistent(
        self, trials: int, *, around: bool = False, near: Mapping[Any, float] | None = None
    ) -> Inputs:
        """Return states that keep the constraints, as far as Newton's method finds them."""
        n = len(self.coordinates)
        free = [*self.coordinates, *self._others]
        held = self._held()
        blocks = [
            ("held", (len(held),), held),
            self.table("gradient", held, free),
            ("velocity", (len(self.velocity),), self.velocity),
            self.table("slope", self.velocity, self.speeds),
        ]
        closing = evaluator_of(self.graph, blocks)
        t, x, r, p = inputs = self._beginning(trials, around, near or {})

        def residuals(rows: Sequence[int]) -> dict[str, np.ndarray]:
            return closing(t[rows], x[rows], r[rows], p[rows])

        searching, usable = list(range(trials)), list(range(trials))
        first = residuals(searching)
        if held and self._resized(inputs, near or {}, first["gradient"]):
            first = residuals(searching)
        if near:  # near zero the vector of a quaternion moves no row
            beside = x.copy()
            numbers = np.flatnonzero(self._per_unit()[:n])
            beside[:, numbers] = generic_inputs(self._sizes, trials)[1][:, numbers]
            first = closing(t, beside, r, p)
        units, sizes = row_units(first["gradient"]), column_units(first["gradient"])
        speeds = column_units(first["slope"])
        for share in FULL_STEPS:
            for _ in range(_STEPS):
                if not searching:
                    break
                now, still = residuals(searching), []
                for k, gradient, left in zip(searching, now["gradient"], now["held"], strict=True):
                    if not (np.isfinite(gradient).all() and np.isfinite(left).all()):
                        usable.remove(k)
                    elif np.abs(left / units).max(initial=0.0) >= ROUNDED:
                        step = -_solved(gradient, left, share, sizes)
                        x[k, :n] += step[:n]
                        r[k] += step[n:]
                        still.append(k)
                searching = still
        now = residuals(usable)
        for k, slope, left in zip(usable, now["slope"], now["velocity"], strict=True):
            if left.size and np.isfinite(slope).all():
                x[k, n:] -= _solved(slope, left, FULL_STEPS[-1], speeds)
        return t, x, r, p


def closed(samples: list[dict[str, np.ndarray]]) -> list[dict[str, np.ndarray]]:
    """Return those of some samples, with the blocks of `closing`, that keep the constraints."""
    apart = openness(samples) if samples else []
    return [s for s, left in zip(samples, apart, strict=True) if left < OPEN]


def openness(samples: list[dict[str, np.ndarray]]) -> list[float]:
    """Return how far states are from the constraints, whatever the units of the rows.

    What rounding leaves does not count. SymPy adds up numbers beforehand: a row that is a number
    is what it left of some as large as those of the other rows.
    """
    every, found = units_of(samples), []
    for s in samples:
        sizes = np.abs(s["residuals"])
        rounded = ROUNDED * np.where(s["bounds"] > 0.0, s["bounds"], s["bounds"].max(initial=0.0))
        found.append(float(np.where(sizes <= rounded, 0.0, sizes / every).max(initial=0.0)))
    return found


def units_of(samples: list[dict[str, np.ndarray]]) -> np.ndarray:
    """Return the units of the constraints, holonomic ones first, by their derivatives."""
    tables = [np.array([s[name] for s in samples]) for name in ("holonomic", "velocity")]
    return np.concatenate([row_units(table) for table in tables])


def _solved(
    gradient: np.ndarray, residuals: np.ndarray, share: float, units: np.ndarray
) -> np.ndarray:
    """Return the least step, in units, along directions that move the residuals noticeably."""
    gradient = gradient * units
    sizes = np.linalg.norm(gradient, axis=1)
    scale = np.where(sizes > 0.0, sizes, 1.0)
    rows, right = gradient / scale[:, None], residuals / scale
    step: np.ndarray = units * np.linalg.lstsq(rows, right, rcond=share)[0]
    return step


def row_units(tables: np.ndarray) -> np.ndarray:
    """Return the unit of each row of tables at several states: a power of 1024, as SI's prefixes.

    It is that of the longest, since rows may vanish in singular positions.
    """
    sizes = np.linalg.norm(tables, axis=2)
    longest = np.where(np.isfinite(sizes) & (sizes > 0.0), sizes, 0.0).max(axis=0)
    found: np.ndarray = np.exp2(10.0 * np.round(np.log2(np.where(longest, longest, 1.0)) / 10.0))
    return found


def column_units(tables: np.ndarray) -> np.ndarray:
    """Return the unit of each column of tables at several states, a power of 1024 too.

    What moves by kilometres would stand still beside angles, which close no loop alone.
    """
    sizes = np.abs(tables)
    largest = np.where(np.isfinite(sizes), sizes, 0.0).max(axis=0)
    columns = equilibrated(largest)[2][0]
    found: np.ndarray = np.exp2(10.0 * np.round(np.log2(columns) / 10.0))
    return found


def generic_inputs(sizes: tuple[int, int, int], trials: int) -> Inputs:
    """Return times, states, specifieds and constants of samples, all nothing particular."""
    n, s, k = sizes
    rngs = [np.random.default_rng(seed) for seed in range(trials)]
    x = np.array([rng.uniform(_LOW, _HIGH, n) for rng in rngs])
    r = np.array([rng.uniform(0.5, 1.5, s) for rng in rngs])
    t = np.array([rng.uniform(0.1, 1.0) for rng in rngs])
    return t, x, r, np.array([rng.uniform(0.5, 1.5, k) for rng in rngs])


def generic_values(
    graph: Graph,
    blocks: Sequence[Block],
    sizes: tuple[int, int, int],
    trials: int,
    sign: float = 1.0,
) -> dict[str, np.ndarray]:
    """Return the values of blocks at `generic_inputs`; all inputs but time are of one sign."""
    t, x, r, p = generic_inputs(sizes, trials)
    return evaluator_of(graph, blocks)(t, sign * x, sign * r, sign * p)


def evaluator_of(
    graph: Graph, blocks: Sequence[Block]
) -> Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], dict[str, np.ndarray]]:
    """Return a function that evaluates blocks of nodes at several states."""
    nodes_at = graph.evaluator([n for _, _, nodes in blocks for n in nodes])
    ends = np.cumsum([len(nodes) for _, _, nodes in blocks])[:-1]

    def values(t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray) -> dict[str, np.ndarray]:
        parts = np.split(nodes_at(columns_of(graph, t, x, r, p), len(t)), ends, axis=1)
        return {
            name: part.reshape(len(t), *shape)
            for (name, shape, _), part in zip(blocks, parts, strict=True)
        }

    return values


def columns_of(
    graph: Graph, t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
) -> dict[int, np.ndarray]:
    """Return the numbers of each input node of a graph."""
    groups = {"t": t[:, None], "x": x, "r": r, "p": p}
    return {
        graph.input(group, k): values[:, k]
        for group, values in groups.items()
        for k in range(values.shape[1])
    }
