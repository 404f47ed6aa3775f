"""Values at generic consistent states, by which ranks and identities are determined.

Quaternions have unit length, with or without a constraint. A user may have simplified a velocity or
a rate by a constraint, so that it is valid only where the constraint is satisfied. All symbols that
are not states count as specifieds: the search for a consistent state may change them too, since a
four-bar linkage with random lengths need not close.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from sympy.core.function import AppliedUndef

from pydy._graph import Graph, SymPyReader, jacobian, per_unit, rounding_bounds
from pydy._mechanics.equations import Equations
from pydy._mechanics.frame_tree import FrameTree, numbers_in_places
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.symbols import find_symbols, rate_of, sort_symbols
from pydy._mechanics.tuning import OMITTED_BELOW, OPEN
from pydy._rank import HALF, ROUNDED, equilibrated, or_one

if TYPE_CHECKING:
    import sympy as sm
    from numpy.typing import NDArray

    from pydy._sympy_types import AnySymbol, TimeFunction

_STEPS = 50
_NEAR = 0.03  # deviation of first guesses from a configuration, relative to its largest number

# Further samples if rows seem redundant, a count: one in six closes a three-stage lift, so that all
# of them miss it with a probability of (5/6)**60 = 2e-5.
AROUND = 60
_LOW, _HIGH = 0.3, 1.3  # generic coordinates and speeds

_STATE = ("time of the state", "state", "specifieds at the state")

Block = tuple[str, tuple[int, ...], list[int]]
Inputs = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]  # t, x, r, p


class GenericStates:
    """Expressions of a system as nodes of a graph, and their values at generic states.

    `expressions` are read in addition to the constraints and the kinematics; `what` names them in
    messages. The `inputs` are all their inputs, with time; `moving` pairs those that change in time
    with their rates: coordinates, time, and specifieds whose derivatives occur.
    """

    def __init__(self, equations: Equations, expressions: Iterable[sm.Expr], what: str) -> None:
        graph = self.graph = Graph()
        t, q, u = equations.time, equations.coordinates, equations.speeds
        states = [*q, *u]
        made_from = self._made_from = equations.mechanism or equations.multibody
        turns = [] if made_from is None else FrameTree(made_from.frame).rotation_matrices()
        kinematics, constraints = equations.kinematics, equations.constraints
        derivatives = kinematics.coordinate_derivatives
        # The rates of unknowns whose residuals contain speeds contain u': no constraint does.
        accelerations = {*kinematics.speed_rates} & {*find_symbols(derivatives)}
        defined = {*states, *kinematics.zeros, t, *kinematics.coordinate_rates, *accelerations}
        constraint_expressions = *constraints.holonomic, *constraints.velocity, *derivatives
        symbols = find_symbols((*expressions, *constraint_expressions, *turns)).keys() - defined
        symbols |= {rate_of(s, t) for s in symbols if isinstance(s, AppliedUndef)}
        free_symbols = sort_symbols(symbols)
        self.read = SymPyReader.of_inputs(graph, what, x=states, r=free_symbols, t=[t])
        atoms = self.read.atoms
        self.coordinates, self.speeds = [atoms[s] for s in q], [atoms[s] for s in u]
        self._free, time = [atoms[s] for s in free_symbols], atoms[t]
        self.inputs = [*self.coordinates, *self.speeds, *self._free, time]
        self._symbols = t, *states, *free_symbols
        self._sizes = (len(states), len(free_symbols), 0)
        atoms.update(dict.fromkeys((*kinematics.zeros, *accelerations), graph.zero))
        rates = self.read.all(derivatives)
        # These unknowns are forces, which occur in no other constraint: they are held constant.
        of_speeds = [
            k for k, e in enumerate(derivatives) if not accelerations.isdisjoint(find_symbols([e]))
        ]
        for k in of_speeds:
            rates[k] = graph.zero
        for rate, node in zip(kinematics.coordinate_rates, rates, strict=True):
            self.read.define(rate, node)
        # A prescribed motion y(t) moves a constraint through y'(t).
        self.moving = [*zip(self.coordinates, rates, strict=True), (time, graph.one)]
        self.moving += [
            (atoms[s], atoms[s.diff(t)]) for s in free_symbols if isinstance(s, AppliedUndef)
        ]
        self._moved = {node for node, _ in self.moving}
        self.holonomic = self.read.all(constraints.holonomic)
        if of_speeds:
            implicit = constraints.residuals.implicit
            start = {} if implicit is None else implicit.start
            forces = {self.coordinates[k]: start[q[k]] for k in of_speeds}
            fixed = {*forces, *self.speeds}
            rows = [
                k
                for k in constraints.residuals.rows
                if not fixed.isdisjoint(graph.reachable([self.holonomic[k]]))
            ]
            for k, (node, value) in zip(rows, forces.items(), strict=True):
                self.holonomic[k] = graph.sum([(node, 1.0)], -value)
        self.velocity = self.read.all(constraints.velocity)
        self._turning = orthogonality_residuals(turns, self.read)

    @cached_property
    def lengths_of_bodies(self) -> list[float]:
        """The magnitudes of the numbers that locate bodies, ascending."""
        source = self._made_from
        return [] if source is None else sorted(numbers_in_places(source.frame, source.bodies))

    def leave_out(self, rows: Sequence[int]) -> None:
        """Omit constraints, numbered with holonomic ones first."""
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
        near: Mapping[AnySymbol, float] | None = None,
        left_open: bool = False,
    ) -> Iterator[dict[str, np.ndarray]]:
        """Yield the values of blocks at consistent states at which all are finite.

        The search begins `near` a configuration, or with angles all `around` the circle, to find
        all assembly configurations of a linkage. All states are yielded if none is consistent, or
        if the constraints may be `left_open`.
        """
        inputs = self.consistent(trials, around=around, near=near)
        values = evaluator_of(self.graph, blocks)(*inputs)
        finite = np.full(trials, True)
        for block in values.values():
            finite &= np.isfinite(block).reshape(trials, -1).all(axis=1)
        values |= dict(zip(_STATE, inputs, strict=False))
        for k in np.flatnonzero(finite if left_open else self.closed(inputs, finite)):
            yield {name: block[k] for name, block in values.items()}

    def samples_where_zero(
        self, node: int, blocks: Sequence[Block], trials: int
    ) -> Iterator[dict[str, np.ndarray]]:
        """Yield the values at consistent states at which a node is zero as well."""
        holonomic = self.holonomic
        self.holonomic = [*holonomic, node]
        yield from self.consistent_samples(blocks, trials, around=True)
        self.holonomic = holonomic

    def consistent_samples(
        self,
        blocks: Sequence[Block],
        trials: int,
        *,
        around: bool = False,
        near: Mapping[AnySymbol, float] | None = None,
    ) -> list[dict[str, np.ndarray]]:
        """Return the `samples` that are consistent; there may be none."""
        return closed(
            list(self.samples([*blocks, *self.closing()], trials, around=around, near=near))
        )

    def uncertain(
        self, samples: Sequence[dict[str, np.ndarray]], cells: Sequence[int]
    ) -> NDArray[np.float64]:
        """Return bounds on the errors of nodes due to residuals of the constraints.

        Shape (samples, nodes). The state is uncertain by rounding errors and by the length of a
        Newton step that would remove the residuals.
        """
        t, x, r = (np.array([s[name] for s in samples]) for name in _STATE)
        free, constraint_rows = [*self.coordinates, *self._free], self._satisfied_rows()
        bounds = rounding_bounds(self.graph, constraint_rows)
        blocks = [
            ("residuals", (len(constraint_rows),), constraint_rows),
            ("bounds", (len(constraint_rows),), bounds),
            self.table("gradient", constraint_rows, free),
        ]
        at = evaluator_of(self.graph, blocks)(t, x, r, np.zeros((len(t), 0)))
        scaled, rows, columns = equilibrated(np.nan_to_num(at["gradient"]))
        # Four Newton steps bound the distance to the exact state: at a double root a step covers
        # half the distance, and the curvature may double it again.
        residuals = (4.0 * np.abs(at["residuals"]) / ROUNDED + at["bounds"])[..., None] / rows
        steps = np.abs(np.linalg.pinv(scaled, rcond=HALF)) @ residuals
        errors = {node: self.graph.input("p", k) for k, node in enumerate(free)}
        bounds = rounding_bounds(self.graph, cells, errors=errors)
        bounds_at = evaluator_of(self.graph, [("bounds", (len(cells),), bounds)])
        return ROUNDED * bounds_at(t, x, r, columns[:, 0] * steps[..., 0])["bounds"]

    def closing(self) -> list[Block]:
        """Return the constraints, and their derivatives by coordinates and by speeds."""
        residuals = [*self.holonomic, *self.velocity]
        bounds = rounding_bounds(self.graph, residuals)
        return [
            self.table("holonomic", self.holonomic, self.coordinates),
            self.table("velocity", self.velocity, self.speeds),
            ("residuals", (len(residuals),), residuals),
            ("bounds", (len(bounds),), bounds),
        ]

    def closed(self, inputs: Inputs, finite: np.ndarray) -> np.ndarray:
        """Return which of the finite states are consistent; all of them if none is.

        A search may close a loop by lengths that vanish, where values are not finite.
        """
        count = len(inputs[0])
        if not (self.holonomic or self.velocity):
            return finite
        values = evaluator_of(self.graph, self.closing())(*inputs)
        every = [{name: block[k] for name, block in values.items()} for k in range(count)]
        consistent = finite & (np.array(openness(every)) < OPEN)
        return consistent if consistent.any() else finite

    def anywhere(self, blocks: Sequence[Block], sign: float = 1.0) -> dict[str, np.ndarray]:
        """Return the values of blocks at generic states, consistent or not.

        All numbers but time have the same `sign`.
        """
        return generic_values(self.graph, blocks, self._sizes, 3, sign)

    def _satisfied_rows(self) -> list[int]:
        """Return the rows that a state must satisfy, whatever the speeds.

        Velocity constraints without speeds are conditions for the other variables.
        """
        speeds, g = set(self.speeds), self.graph
        conditions = [n for n in self.velocity if speeds.isdisjoint(g.reachable([n]))]
        return [*self.holonomic, *self._turning, *conditions]

    def _beginning(self, trials: int, around: bool, near: Mapping[AnySymbol, float]) -> Inputs:
        """Return the first guesses of the search for consistent states."""
        n = len(self.coordinates)
        inputs = generic_inputs(self._sizes, trials)
        x = inputs[1]
        if around:
            x[:, :n] = np.pi * (2.0 * (x[:, :n] - _LOW) / (_HIGH - _LOW) - 1.0)
        moved = self._symbols[1 : 1 + n]
        sizes = dict(zip(moved, self._magnitudes(moved, near), strict=True)) if near else {}
        for symbol, column in self.by_symbol(inputs).items():
            if symbol in near:
                size = _NEAR * sizes.get(symbol, 0.0)
                column[:] = near[symbol] + size * (column - 1.0)
        return inputs

    def _scale_lengths(
        self, inputs: Inputs, near: Mapping[AnySymbol, float], gradient: np.ndarray
    ) -> bool:
        """Scale free lengths from order one to the size of the mechanism.

        Next to free lengths of one metre, offsets of nanometres would vanish, and rows would seem
        redundant. The size is that of the lengths `near` which it is assembled, or of the lever
        arms of angles in the `gradient`, or of the numbers that locate bodies.
        """
        placed = max(self.lengths_of_bodies, default=0.0)
        if row_units(np.full((1, 1, 1), placed)) == 1.0 and (column_units(gradient) == 1.0).all():
            return False
        steep, sizes = self._per_unit(), np.nan_to_num(np.abs(gradient)).max(axis=0, initial=0.0)
        n = len(self.coordinates)
        free = (*self._symbols[1 : 1 + n], *self._symbols[1 + inputs[1].shape[1] :])
        long = np.array([isinstance(s, AppliedUndef) for s in free]) & (steep == 0.0)
        given_lengths = [
            abs(near[s]) for s, is_long in zip(free, long, strict=True) if is_long and s in near
        ]
        turns = steep > 0.0
        levers = (sizes[:, turns] / steep[turns]).max(axis=1, keepdims=True, initial=0.0)
        lengths = np.where(sizes > 0.0, levers / or_one(sizes), 0.0).max(axis=0, initial=0.0)
        lengths[lengths == 0.0] = lengths[long].max(initial=0.0) or placed
        if any(given_lengths):
            lengths[:] = max(given_lengths)
        units, by_symbol = row_units(lengths[None, :, None]), self.by_symbol(inputs)
        for k in np.flatnonzero(long):
            if free[k] not in near:
                by_symbol[free[k]] *= units[k]
        return True

    def _magnitudes(
        self, coordinates: Sequence[TimeFunction], near: Mapping[AnySymbol, float]
    ) -> list[float]:
        """Return the magnitude of each coordinate near a configuration, in its unit.

        Angles and quaternions are dimensionless: their magnitude is that of their largest, at least
        one, whatever the unit of the lengths.
        """
        steep = self._per_unit()[: len(coordinates)]
        numbers = np.array([abs(near.get(s, 0.0)) for s in coordinates])
        largest = max((abs(value) for value in near.values()), default=0.0)
        lengths = numbers[steep == 0.0].max(initial=0.0) or largest
        largest_number = max(float((numbers * steep).max(initial=0.0)), 1.0)
        return [min(largest, largest_number / s) if s > 0.0 else lengths for s in steep]

    def _per_unit(self) -> np.ndarray:
        """Return the natural units of coordinates and free numbers; see `per_unit`.

        Coordinates come first, then all symbols without a value.
        """
        graph, variables = self.graph, [*self.coordinates, *self._free]
        slopes = per_unit(graph, [*self.holonomic, *self.velocity], variables)
        at = self.anywhere([("slopes", (len(variables),), slopes)])
        units: np.ndarray = np.nan_to_num(at["slopes"]).max(axis=0, initial=0.0)
        turning = {*graph.reachable(self._turning)}
        units[[k for k, node in enumerate(variables) if node in turning]] = 1.0
        return units

    def by_symbol(self, inputs: Inputs) -> dict[AnySymbol, np.ndarray]:
        """Return the numbers of each symbol, as views."""
        t, x, r, _ = inputs
        return dict(zip(self._symbols, [t, *x.T, *r.T], strict=True))

    def consistent(
        self, trials: int, *, around: bool = False, near: Mapping[AnySymbol, float] | None = None
    ) -> Inputs:
        """Return states that are consistent if Newton's method converges."""
        n = len(self.coordinates)
        free = [*self.coordinates, *self._free]
        constraint_rows = self._satisfied_rows()
        blocks = [
            ("residuals", (len(constraint_rows),), constraint_rows),
            self.table("gradient", constraint_rows, free),
            ("velocity", (len(self.velocity),), self.velocity),
            self.table("slope", self.velocity, self.speeds),
        ]
        closing = evaluator_of(self.graph, blocks)
        t, x, r, p = inputs = self._beginning(trials, around, near or {})

        def residuals(rows: Sequence[int]) -> dict[str, np.ndarray]:
            return closing(t[rows], x[rows], r[rows], p[rows])

        searching, usable = list(range(trials)), list(range(trials))
        first = residuals(searching)
        if constraint_rows and self._scale_lengths(inputs, near or {}, first["gradient"]):
            first = residuals(searching)
        if near:  # the vector part of a quaternion near zero changes no row
            generic = x.copy()
            numbers = np.flatnonzero(self._per_unit()[:n])
            generic[:, numbers] = generic_inputs(self._sizes, trials)[1][:, numbers]
            first = closing(t, generic, r, p)
        units, sizes = row_units(first["gradient"]), column_units(first["gradient"])
        speeds = column_units(first["slope"])
        for least in OMITTED_BELOW:
            for _ in range(_STEPS):
                if not searching:
                    break
                values, unsatisfied = residuals(searching), []
                rows = zip(searching, values["gradient"], values["residuals"], strict=True)
                for k, gradient, residual in rows:
                    if not (np.isfinite(gradient).all() and np.isfinite(residual).all()):
                        usable.remove(k)
                    elif np.abs(residual / units).max(initial=0.0) >= ROUNDED:
                        step = -_solved(gradient, residual, least, sizes)
                        x[k, :n] += step[:n]
                        r[k] += step[n:]
                        unsatisfied.append(k)
                searching = unsatisfied
        values = residuals(usable)
        for k, slope, residual in zip(usable, values["slope"], values["velocity"], strict=True):
            if residual.size and np.isfinite(slope).all():
                x[k, n:] -= _solved(slope, residual, OMITTED_BELOW[-1], speeds)
        return t, x, r, p


def closed(samples: list[dict[str, np.ndarray]]) -> list[dict[str, np.ndarray]]:
    """Return the consistent samples; they have the blocks of `closing`."""
    deviations = openness(samples) if samples else []
    return [s for s, deviation in zip(samples, deviations, strict=True) if deviation < OPEN]


def openness(samples: list[dict[str, np.ndarray]]) -> list[float]:
    """Return the largest residual of each sample, in units of the rows.

    Residuals within rounding count as zero. A row that is a plain number is what SymPy's folding
    left of numbers as large as those of the other rows.
    """
    every, deviations = units_of(samples), []
    for s in samples:
        sizes = np.abs(s["residuals"])
        rounded = ROUNDED * np.where(s["bounds"] > 0.0, s["bounds"], s["bounds"].max(initial=0.0))
        deviations.append(float(np.where(sizes <= rounded, 0.0, sizes / every).max(initial=0.0)))
    return deviations


def units_of(samples: list[dict[str, np.ndarray]]) -> np.ndarray:
    """Return the units of the constraints, holonomic ones first, by their derivatives."""
    tables = [np.array([s[name] for s in samples]) for name in ("holonomic", "velocity")]
    return np.concatenate([row_units(table) for table in tables])


def _solved(
    gradient: np.ndarray, residuals: np.ndarray, least: float, units: np.ndarray
) -> np.ndarray:
    """Return the least-norm step, in units, along directions that change the residuals."""
    gradient = gradient * units
    sizes = np.linalg.norm(gradient, axis=1)
    scale = np.where(sizes > 0.0, sizes, 1.0)
    rows, right = gradient / scale[:, None], residuals / scale
    step: np.ndarray = units * np.linalg.lstsq(rows, right, rcond=least)[0]
    return step


def row_units(tables: np.ndarray) -> np.ndarray:
    """Return the unit of each row of tables at several states, a power of 1024 like SI prefixes.

    The longest row over all states decides, since rows may vanish in singular positions.
    """
    sizes = np.linalg.norm(tables, axis=2)
    longest = np.where(np.isfinite(sizes) & (sizes > 0.0), sizes, 0.0).max(axis=0)
    units: np.ndarray = np.exp2(10.0 * np.round(np.log2(np.where(longest, longest, 1.0)) / 10.0))
    return units


def column_units(tables: np.ndarray) -> np.ndarray:
    """Return the unit of each column of tables at several states, a power of 1024.

    Without it, steps of coordinates in kilometres would be negligible next to those of angles.
    """
    sizes = np.abs(tables)
    largest = np.where(np.isfinite(sizes), sizes, 0.0).max(axis=0)
    columns = equilibrated(largest)[2][0]
    units: np.ndarray = np.exp2(10.0 * np.round(np.log2(columns) / 10.0))
    return units


def generic_inputs(sizes: tuple[int, int, int], trials: int) -> Inputs:
    """Return times, states, specifieds and constants of generic samples."""
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
