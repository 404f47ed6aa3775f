"""Auxiliary speeds in the rates of closed loops.

An auxiliary speed moves points without moving a coordinate. The derivative of a loop constraint, an
expression of the coordinates, does not contain it, so that the contribution of the loop to the
joint force would be lost. Which bodies the expression connects is not known. Its rate is compared
with the rates of all quantities that connect two points, frames or bodies:

    e·r              components of the vector r between two points, along axes e of any frame,
    e·v              components of their relative velocity,
    r·r, |r|         their distance,
    e·(ω₁ − ω₂)      the relative angular velocity of two frames,
    e₁·e₂            the cosines between their axes,
    f·v + τ·ω        a constant force and torque between two bodies: rolling, gears.

If the coefficients are equal at all states, the constraint is that quantity, and its derivative
with respect to an auxiliary speed follows from the velocities of the points and frames. If several
match with different derivatives, those that are equal to the constraint itself, not only in their
rates, take precedence; then single components; then those between ends that other rows of the loop
connect. Otherwise the contribution of the loop is unknown.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations, permutations
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Point

from pydy._graph import Graph, LinearSystem, inputs_of, jacobian, substitute
from pydy._mechanics.components import dot, flat, identity, product
from pydy._mechanics.equations import Equations
from pydy._mechanics.frame_tree import FrameTree, breadth_first
from pydy._mechanics.generic import GenericStates
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.symbols import find_symbols
from pydy._rank import HALF, ROUNDED, or_one

if TYPE_CHECKING:
    from sympy.physics.mechanics import ReferenceFrame

    from pydy._mechanics.frame_tree import AnyFrame
    from pydy._sympy_types import Location

_STATES = 4  # generic states at which rates are compared, for each of two sets of constants

# Two points, two frames, or two bodies: a mass centre and a frame; None is the ground, or no frame.
_End: TypeAlias = "Location | tuple[Point | None, ReferenceFrame | None]"


def loop_points(body: Multibody) -> dict[Point, Point | None]:
    """Return the points that constraints may connect, each with the one it is located from.

    Points of other mechanisms with the same origin depend on other functions of time.
    """
    tree = FrameTree(body.frame)
    constraints, derivatives = body.constraints, body.kinematics.coordinate_derivatives
    written = find_symbols((*constraints.holonomic, *constraints.velocity, *derivatives))
    functions_of_motion = {s for s in written if isinstance(s, AppliedUndef)} | {*body.coordinates}

    def connected(point: Point) -> list[Point]:
        return [
            neighbour
            for neighbour, offset in FrameTree.positions(point).items()
            if all(
                frame in tree.frame_depth and frame in tree.spin_depth for _, frame in offset.args
            )
            and {s for part, _ in offset.args for s in part.atoms(AppliedUndef)}
            <= functions_of_motion
        ]

    before: dict[Point, Point | None] = {}
    at_loads = [location for location, _ in body.loads if isinstance(location, Point)]
    for root in (*(b.masscenter for b in body.bodies), *at_loads):
        if root not in before:
            before |= breadth_first([root], connected)
    return before


@dataclass
class _Closures:
    """Quantities of one kind that connect two ends, all with the same number of components.

    The derivatives of their rates with respect to the speeds, at generic states, are `columns` (2
    sets of constants, quantities, components, states · speeds); `values` (2, quantities,
    components, states) are the components themselves if known. `rates` returns the rates of one as
    nodes.
    """

    ends: list[tuple[_End, _End]]
    columns: np.ndarray
    rates: Callable[..., Vec]
    values: np.ndarray | None = None
    axes: ReferenceFrame | None = None  # the frame of the components
    between_bodies: bool = False


@dataclass
class _Fit:
    """A quantity with the rate of a constraint, and its derivatives by the auxiliary speeds.

    The lower the rank, the better the match.
    """

    rank: int
    ends: frozenset[_End]
    axes: ReferenceFrame | None
    shares: Vec


class LoopShares:
    """Derivatives of loop constraints by auxiliary speeds that their expressions lack.

    The kinematics hold the auxiliary speeds and the `loop_points`; `rows` are nodes of its graph,
    linear in the speeds.
    """

    def __init__(
        self, k: Kinematics, points: dict[Point, Point | None], rows: Sequence[int]
    ) -> None:
        self.k, g = k, k.graph
        self._position: dict[Point, Vec] = {}
        self._root: dict[Point, Point] = {}
        for point, before in points.items():
            self._position[point], self._root[point] = [g.zero] * 3, point
            if before is not None:
                step = k.vector(FrameTree.positions(point)[before], k.inertial)
                self._position[point] = k.plus(self._position[before], step)
                self._root[point] = self._root[before]
        frames = [f for f in k.tree.frame_depth if f in k.tree.spin_depth]
        self._axes = {f: [k.expressed(e, f, k.inertial) for e in identity(g)] for f in frames}
        self._motion = {w: k.expressed(v, f, k.inertial) for w, (f, v) in self._moving(points)}
        self._motion |= {w: k.expressed(v, f, k.inertial) for w, (f, v) in self._moving(frames)}
        self._points, self._frames = list(points), frames
        self._rows = jacobian(g, rows, k.speeds).dense()
        self._number(k.read.all(k.body.constraints.holonomic))

    def _moving(self, items: Iterable[Location]) -> Iterator[tuple[Location, tuple[AnyFrame, Vec]]]:
        return ((item, self.k.velocity_of(item)) for item in items)

    def _number(self, holonomic: Vec) -> None:
        """Evaluate positions and axes, and derivatives of all rates by all speeds."""
        k, g, n = self.k, self.k.graph, len(self.k.speeds)
        positions = flat([*self._position.values()])
        axes = [c for row in self._axes.values() for axis in row for c in axis]
        rates = [*k.dt([*positions, *axes]), *flat([*self._motion.values()])]
        slopes = flat(jacobian(g, rates, [*k.speeds, *k.auxiliary]).dense())
        holonomic_slopes = flat(jacobian(g, k.dt(holonomic), k.speeds).dense())
        nodes = [*positions, *axes, *slopes, *flat(self._rows), *holonomic_slopes, *holonomic]
        self._states = _generic(g, [*inputs_of(g, nodes)])
        values = np.array([g.evaluator(nodes)(row, _STATES) for row in self._states])
        p, f, width = len(self._points), len(self._frames), n + len(k.auxiliary)
        shapes = [
            (p, 3), (f, 3, 3), (p, 3, width), (f, 3, 3, width), (p, 3, width), (f, 3, width),
            (len(self._rows), n), (len(holonomic), n), (len(holonomic),),
        ]  # fmt: skip
        sizes = np.cumsum([np.prod(shape, dtype=int) for shape in shapes])
        parts = [
            part.reshape(2, _STATES, *shape)
            for part, shape in zip(np.split(values, sizes[:-1], axis=2), shapes, strict=True)
        ]
        self._r, self._e, dr, de, self._v, self._w, self._slopes, constraint_rows, values = parts
        self._values = [
            _value_of_rate(row, constraint_rows, values) for row in np.moveaxis(self._slopes, 2, 0)
        ]
        self._dr, self._de = dr[..., :n], de[..., :n]
        # Points with equal positions and velocities are one; auxiliary speeds may separate them.
        motions = np.concatenate([self._r[..., None], dr, self._v], axis=-1)
        self._distinct = _unequal(np.moveaxis(motions, 2, 0))

    # -- the choice -------------------------------------------------------------------------------

    def derivatives(self, equations: Equations) -> list[Vec | None]:
        """Return the derivatives of each row by the auxiliary speeds, None if unknown."""
        g, count = self.k.graph, len(self._rows)
        fits = [self._fitting(j, self._usual()) for j in range(count)]
        for j, candidates in enumerate(fits):
            fits[j] = candidates or self._fitting(j, self._between_bodies())
        fits = [
            [f for f in candidates if f.rank == min(o.rank for o in candidates)]
            for candidates in fits
        ]
        body_frames = {None, self.k.inertial, *(b.frame for b in self.k.body.bodies if is_rigid(b))}
        votes = Counter(ends for candidates in fits for ends in {f.ends for f in candidates})
        chosen: list[Vec | None] = []
        for j, candidates in enumerate(fits):
            groups = self._alike(candidates, equations)
            if len(groups) > 1:  # frames may differ by an auxiliary speed only
                candidates = [f for f in candidates if f.axes in body_frames] or candidates
                groups = self._alike(candidates, equations)
            if len(groups) > 1:
                most = max(votes[f.ends] for f in candidates)
                candidates = [f for f in candidates if votes[f.ends] == most > 1]
                groups = self._alike(candidates, equations)
            if len(groups) == 1:
                chosen.append(groups[0])
            else:
                unmoved = not candidates and self._unmoved(j)
                chosen.append([g.zero] * len(self.k.auxiliary) if unmoved else None)
        return chosen

    def _fitting(self, j: int, kinds: Iterable[_Closures]) -> list[_Fit]:
        """Return the quantities that have the rate of a row."""
        row = self._slopes[:, :, j].reshape(2, -1)
        fits = []
        for kind in kinds:
            count = kind.columns.shape[2]
            singles = [(c,) for c in range(count)] if count > 1 else []
            untried = np.ones(len(kind.ends), dtype=bool)
            for part in (*singles, tuple(range(count))):
                columns = kind.columns[:, :, part]
                weights, fit = _combinations(columns, row)
                for index in np.flatnonzero(fit & untried):
                    columns_and_weights = columns[:, index], weights[:, index]
                    values = None if kind.values is None else kind.values[:, index][:, part]
                    candidate = self._fit(
                        j, kind, part, kind.ends[index], *columns_and_weights, values
                    )
                    if candidate is not None:
                        fits.append(candidate)
                untried &= ~fit
        return fits

    def _fit(
        self,
        j: int,
        kind: _Closures,
        part: Sequence[int],
        ends: tuple[_End, _End],
        columns: np.ndarray,
        weights: np.ndarray,
        values: np.ndarray | None,
    ) -> _Fit | None:
        g = self.k.graph
        rates = kind.rates(*ends)
        rates = [rates[c] for c in part]
        slopes = jacobian(g, rates, self.k.auxiliary).dense()
        if len(part) > 1 and not self._determined(slopes, columns[0], kind.between_bodies):
            return None
        factors = self._factors(j, rates, columns, weights)
        if factors is None:
            return None
        exact, constraint_value = False, self._values[j]
        if values is not None and constraint_value is not None:
            terms = weights[:, :, None] * values
            sizes = np.abs(terms).sum(axis=1) + np.abs(constraint_value)
            exact = bool((np.abs(terms.sum(axis=1) - constraint_value) <= HALF * sizes).all())
        rank = 2 * (not exact) + (len(part) > 1)
        shares = product(g, [*zip(*slopes, strict=True)], factors)
        return _Fit(rank, frozenset(ends), kind.axes, shares)

    def _determined(self, slopes: list[Vec], columns: np.ndarray, or_none: bool) -> bool:
        """Return whether auxiliary speeds move only directions that the speeds move.

        The force in other directions is unknown. Between bodies it counts as zero if auxiliary
        speeds move nothing else: rolling does not press a wheel onto its plane.
        """
        nodes = flat(slopes)
        values = self.k.graph.evaluator(nodes)(self._numbers(nodes), _STATES)
        auxiliary_rates = values.reshape(_STATES, len(slopes), -1)
        units = _units(columns[None, None])[0, 0]
        _, sizes, axes = np.linalg.svd((columns / units[:, None]).T)
        rank = int((sizes > HALF * sizes.max(initial=0.0)).sum())
        auxiliary_rates = auxiliary_rates / units[:, None]
        fixed_part = np.abs(np.einsum("zc,scn->szn", axes[rank:], auxiliary_rates)).max(
            axis=(0, 1), initial=0.0
        )
        moving_part = np.abs(np.einsum("zc,scn->szn", axes[:rank], auxiliary_rates)).max(
            axis=(0, 1), initial=0.0
        )
        free = fixed_part <= HALF * (fixed_part + moving_part)
        return bool((free | (moving_part <= HALF * fixed_part) if or_none else free).all())

    def _numbers(self, nodes: Sequence[int]) -> dict[int, np.ndarray]:
        """Return the first set of numbers, with zeros for inputs that it does not have."""
        numbers = self._states[0]
        zeros = np.zeros(_STATES)
        return {n: numbers.get(n, zeros) for n in inputs_of(self.k.graph, nodes)}

    def _factors(self, j: int, rates: Vec, columns: np.ndarray, weights: np.ndarray) -> Vec | None:
        """Return the coefficients of components: numbers, or expressions of constants."""
        g = self.k.graph
        row = self._slopes[:, :, j].reshape(2, -1)
        sizes, row_size = np.linalg.norm(columns, axis=2), np.linalg.norm(row, axis=1)[:, None]
        used = np.flatnonzero((np.abs(weights) * sizes > HALF * row_size).any(axis=0))
        difference = np.abs(weights[0] - weights[1]) * sizes.max(axis=0)
        factors = [g.zero] * len(rates)
        if (difference <= HALF * row_size.max()).all():
            for i in used:
                factors[i] = g.const(_half_integer(float(weights[0, i])))
            return factors
        equations = _independent(columns[0][used].T)
        if len(equations) < len(used):
            return None
        slopes = jacobian(g, [rates[i] for i in used], self.k.speeds).dense()
        matrix, right = [], []
        for equation in equations:
            state, speed = divmod(equation, len(self.k.speeds))
            nodes = [*(slope[speed] for slope in slopes), self._rows[j][speed]]
            *cells, cell = substitute(g, nodes, self._at(state))
            matrix.append(cells)
            right.append(cell)
        for i, node in zip(used, LinearSystem(g, matrix).solve(right), strict=True):
            factors[i] = node
        return factors

    def _at(self, state: int) -> dict[int, int]:
        """Return the numbers of a generic state, constants excepted, as nodes."""
        g = self.k.graph
        return {
            node: g.const(float(value[state]))
            for node, value in self._states[0].items()
            if not g.constant[node]
        }

    def _alike(self, fits: Sequence[_Fit], equations: Equations) -> list[Vec]:
        """Return the derivatives that are distinct at consistent states."""
        every = [fit.shares for fit in fits]
        k, width = self.k, len(self.k.auxiliary)
        if len({*map(tuple, every)}) <= 1:
            return [*every[:1]]
        symbols = [*k.read.constants, *k.read.specifieds]
        states = GenericStates(equations, symbols, "the loops")
        inputs = states.consistent(_STATES)
        numbers = states.by_symbol(inputs)
        nodes = flat(every)
        inputs_at = {node: numbers[s] for node, s in k.symbols().items() if s in numbers}
        inputs_at |= {n: np.zeros(_STATES) for n in inputs_of(k.graph, nodes) if n not in inputs_at}
        values = k.graph.evaluator(nodes)(inputs_at, _STATES).reshape(_STATES, -1, width)
        finite = np.array(np.isfinite(values).all(axis=(1, 2)))
        values = values[states.closed(inputs, finite)]
        sizes = np.abs(values).max(axis=(0, 1))
        distinct: list[int] = []
        for i in range(len(every)):
            differences = [
                np.abs(values[:, i] - values[:, earlier]).max(axis=0) for earlier in distinct
            ]
            if all((difference > HALF * sizes).any() for difference in differences):
                distinct.append(i)
        return [every[i] for i in distinct]

    def _unmoved(self, j: int) -> bool:
        """Return whether a row cannot connect the bodies that the auxiliary speeds move.

        Those bodies are moved by other speeds, but by none of the row's speeds.
        """
        n = len(self.k.speeds)
        used = np.abs(self._slopes[:, :, j]).max(axis=(0, 1)) > 0.0
        moving = []
        for body in self.k.body.bodies:
            motions = [self._v[:, :, self._points.index(body.masscenter)]]
            if is_rigid(body):
                motions.append(self._w[:, :, self._frames.index(body.frame)])
            moving.append(np.any([(np.abs(m) > 0.0).any(axis=(0, 1, 2)) for m in motions], axis=0))
        with_auxiliary = [m for m in moving if m[n:].any()]
        return bool(with_auxiliary) and all(
            m[:n].any() and not m[:n][used].any() for m in with_auxiliary
        )

    # -- the kinds --------------------------------------------------------------------------------

    def _usual(self) -> Iterator[_Closures]:
        n = len(self.k.speeds)
        pairs = [
            (i, j)
            for i, j in combinations(self._distinct, 2)
            if self._root[self._points[i]] is self._root[self._points[j]]
        ]
        if pairs:
            i, j = np.array(pairs).T
            ends = [(self._points[a], self._points[b]) for a, b in pairs]
            r, dr = self._r[:, :, i] - self._r[:, :, j], self._dr[:, :, i] - self._dr[:, :, j]
            v = (self._v[:, :, i] - self._v[:, :, j])[..., :n]
            for f, frame in enumerate(self._frames):
                e, de = self._e[:, :, f], self._de[:, :, f]
                translation = np.einsum("csab,cspbn->cspan", e, dr)
                turning = np.einsum("csabn,cspb->cspan", de, r)
                values = np.moveaxis(np.einsum("csab,cspb->cspa", e, r), 1, 3)
                columns = _columns(translation + turning)
                yield _Closures(ends, columns, partial(self._component_rates, frame), values, frame)
                # Velocities that the user set may differ from rates of positions: wheel contacts.
                columns = np.einsum("csab,cspbn->cspan", e, v)
                rates = partial(self._moved, frame)
                yield _Closures(ends, _columns(columns), rates, axes=frame)
            square = np.einsum("cspb,cspbn->cspn", r, dr)
            lengths = np.sqrt((r**2).sum(axis=-1))[..., None]
            yield _Closures(ends, _columns(square[:, :, :, None]), self._square)
            columns = square / or_one(lengths)
            yield _Closures(ends, _columns(columns[:, :, :, None]), self._distance)
        w = self._w[..., :n]
        for i, j in permutations(range(len(self._frames)), 2):
            a, b = self._frames[i], self._frames[j]
            spin = w[:, :, i] - w[:, :, j]
            columns = np.einsum("csab,csbn->csan", self._e[:, :, i], spin)
            yield _Closures([(a, b)], _columns(columns[:, :, None]), self._spin_components)
            if i < j:
                columns = np.einsum("csabn,csdb->csadn", self._de[:, :, i], self._e[:, :, j])
                columns = columns + np.einsum(
                    "csab,csdbn->csadn", self._e[:, :, i], self._de[:, :, j]
                )
                cells = columns.reshape(2, _STATES, 1, 9, n)
                values = np.einsum("csab,csdb->csad", self._e[:, :, i], self._e[:, :, j])
                values = np.moveaxis(values.reshape(2, _STATES, 1, 9), 1, 3)
                yield _Closures([(a, b)], _columns(cells), self._cosines, values)

    def _between_bodies(self) -> Iterator[_Closures]:
        """Yield the relative motions of pairs of bodies, or of a body and the ground.

        Six components each, the velocity of the first mass centre as seen from the second body and
        the angular velocity, in the axes of the ground and in those of the first body.
        """
        n = len(self.k.speeds)
        ends: list[tuple[int | None, int | None]] = []
        for body in self.k.body.bodies:
            frame_index = self._frames.index(body.frame) if is_rigid(body) else None
            ends.append((self._points.index(body.masscenter), frame_index))
        zero = np.zeros((2, _STATES, 3))
        no_rates = np.zeros((2, _STATES, 3, n))
        for (a, fa), (b, fb) in permutations([*ends, (None, None)], 2):
            if a is None:
                continue
            wa = no_rates if fa is None else self._w[:, :, fa, :, :n]
            wb = no_rates if fb is None else self._w[:, :, fb, :, :n]
            vb = no_rates if b is None else self._v[:, :, b, :, :n]
            arm = zero if b is None else self._r[:, :, a] - self._r[:, :, b]
            v = self._v[:, :, a, :, :n] - vb - np.cross(wb, arm[..., None], axis=2)
            first = self._points[a], None if fa is None else self._frames[fa]
            second = (
                None if b is None else self._points[b],
                None if fb is None else self._frames[fb],
            )
            for axes in dict.fromkeys((self.k.inertial, first[1] or self.k.inertial)):
                e = self._e[:, :, self._frames.index(axes)]
                parts = [np.einsum("csab,csbn->csan", e, motion) for motion in (v, wa - wb)]
                columns = np.concatenate(parts, axis=2)[:, :, None]
                rates = partial(self._twist, axes)
                yield _Closures([(first, second)], _columns(columns), rates, between_bodies=True)

    # -- their rates, auxiliary speeds included ---------------------------------------------------

    def _minus(self, a: Vec, b: Vec) -> Vec:
        return [self.k.graph.sub(x, y) for x, y in zip(a, b, strict=True)]

    def _relative(self, a: Point, b: Point) -> tuple[Vec, Vec]:
        """Return the vector between two points and the relative velocity."""
        position, motion = self._position, self._motion
        return self._minus(position[a], position[b]), self._minus(motion[a], motion[b])

    def _component_rates(self, frame: ReferenceFrame, a: Point, b: Point) -> Vec:
        k, (r, v) = self.k, self._relative(a, b)
        rate = self._minus(v, k.cross(self._motion[frame], r))
        return product(k.graph, self._axes[frame], rate)

    def _moved(self, frame: ReferenceFrame, a: Point, b: Point) -> Vec:
        return product(self.k.graph, self._axes[frame], self._relative(a, b)[1])

    def _square(self, a: Point, b: Point) -> Vec:
        return [dot(self.k.graph, *self._relative(a, b))]

    def _distance(self, a: Point, b: Point) -> Vec:
        g, (r, v) = self.k.graph, self._relative(a, b)
        return [g.div(dot(g, r, v), g.call("sqrt", dot(g, r, r)))]

    def _spin_components(self, a: ReferenceFrame, b: ReferenceFrame) -> Vec:
        spin = self._minus(self._motion[a], self._motion[b])
        return product(self.k.graph, self._axes[a], spin)

    def _cosines(self, a: ReferenceFrame, b: ReferenceFrame) -> Vec:
        k, spin = self.k, self._minus(self._motion[a], self._motion[b])
        return [dot(k.graph, spin, k.cross(x, y)) for x in self._axes[a] for y in self._axes[b]]

    def _twist(
        self,
        axes: ReferenceFrame,
        first: tuple[Point, ReferenceFrame | None],
        second: tuple[Point | None, ReferenceFrame | None],
    ) -> Vec:
        k, nothing = self.k, [self.k.graph.zero] * 3
        (a, fa), (b, fb) = first, second
        wa, wb = (nothing if f is None else self._motion[f] for f in (fa, fb))
        v = self._motion[a]
        if b is not None:
            arm, v = self._relative(a, b)
            v = self._minus(v, k.cross(wb, arm))
        return [
            *product(k.graph, self._axes[axes], v),
            *product(k.graph, self._axes[axes], self._minus(wa, wb)),
        ]


def _generic(graph: Graph, inputs: Sequence[int]) -> list[dict[int, np.ndarray]]:
    """Return numbers of inputs at generic states, with two sets of constants."""
    rng = np.random.default_rng(0)
    samples = []
    for _ in range(2):
        values = rng.uniform(0.5, 1.5, (len(inputs), _STATES))
        for k, node in enumerate(inputs):
            if graph.constant[node]:
                values[k] = values[k, 0]
        samples.append(dict(zip(inputs, values, strict=True)))
    return samples


def _value_of_rate(row: np.ndarray, rows: np.ndarray, values: np.ndarray) -> np.ndarray | None:
    """Return the values (2, states) of the constraint with the rate of a row, or None."""
    for k in range(values.shape[2]):
        if np.linalg.norm(rows[:, :, k] - row) <= HALF * np.linalg.norm(row):
            value: np.ndarray = values[:, :, k]
            return value
    return None


def _columns(rates: np.ndarray) -> np.ndarray:
    """Bring rates (2, states, ways, components, n) into the order of `_Closures`."""
    moved = np.moveaxis(rates, 1, 3)
    columns: np.ndarray = np.nan_to_num(moved.reshape(*moved.shape[:3], -1))
    return columns


def _combinations(columns: np.ndarray, row: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return least-squares coefficients (2, quantities, components), and which fit the row."""
    units = _units(columns)
    scaled = np.swapaxes(columns / units[..., None], 2, 3)
    weights = np.einsum("cpkm,cm->cpk", np.linalg.pinv(scaled, rcond=HALF), row)
    residual = np.einsum("cpmk,cpk->cpm", scaled, weights) - row[:, None]
    length = np.linalg.norm(row, axis=1)[:, None]
    fit = (np.linalg.norm(residual, axis=2) <= HALF * length) & (length > 0.0)
    return weights / units, fit.all(axis=0)


def _units(columns: np.ndarray) -> np.ndarray:
    """Return a unit for each column: one for the components of a vector and all constants."""
    sizes = np.linalg.norm(columns, axis=3).max(axis=0, keepdims=True)
    vectors = [sizes[..., k : k + 3] for k in range(0, sizes.shape[2], 3)]
    most = [np.broadcast_to(v.max(axis=2, keepdims=True), v.shape) for v in vectors]
    units: np.ndarray = or_one(np.concatenate(most, axis=2))
    return units


def _independent(matrix: np.ndarray) -> list[int]:
    """Return k independent rows of a matrix (m, k), or fewer if its rank is lower."""
    work = matrix / or_one(np.abs(matrix).max(axis=0))
    independent: list[int] = []
    for _ in range(work.shape[1]):
        row, column = np.unravel_index(int(np.abs(work).argmax()), work.shape)
        if abs(work[row, column]) <= HALF:
            break
        independent.append(int(row))
        work = work - np.outer(work[:, column] / work[row, column], work[row])
    return independent


def _unequal(items: np.ndarray) -> list[int]:
    """Return the numbers of items that differ from those before them."""
    sizes = or_one(np.abs(items).max(axis=0))
    distinct: list[int] = []
    for k, item in enumerate(items):
        if all((np.abs(item - items[earlier]) > ROUNDED * sizes).any() for earlier in distinct):
            distinct.append(k)
    return distinct


def _half_integer(value: float) -> float:
    """Round a coefficient to a multiple of 1/2 if it is one up to rounding."""
    near = round(2.0 * value) / 2.0
    return near if abs(value - near) <= HALF * abs(value) else value
