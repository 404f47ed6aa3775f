"""Outline of a mechanism, derived from its points, frames and loads: bars, ropes, springs, wheels.

The structure is analysed numerically at random states: two points belong to one body if the vector
between them is constant in its frame, in any unit. Only the constants have their true values.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Point, RigidBody, Vector, dynamicsymbols

from pydy._expressions import parts_of
from pydy._mechanics import FrameTree, find_symbols
from pydy._program import run
from pydy._rank import HALF, rank_of
from pydy.viz.motion import Geometry, Names, pose_program

if TYPE_CHECKING:
    from sympy.physics.mechanics import ReferenceFrame

    from pydy._sympy_types import AnySymbol, Body, Load, SymbolOrName, TimeFunction

Pair = tuple[Point, Point]

_SAMPLES = 6  # random states; as many again with the speeds zero
_JUMPS = (sm.Piecewise, sm.Max, sm.Min, sm.Heaviside, sm.sign, sm.Abs)


@dataclass
class Outline:
    """Lines between points, wheels and supports of a mechanism."""

    bars: list[tuple[RigidBody | None, Pair]] = field(default_factory=list)  # two points
    ropes: list[Pair] = field(default_factory=list)
    springs: list[Pair] = field(default_factory=list)
    dampers: list[Pair] = field(default_factory=list)
    # Radius and axis.
    wheels: dict[RigidBody, tuple[sm.Expr | float, str | None]] = field(default_factory=dict)
    supports: list[Point] = field(default_factory=list)  # points at rest on which something turns
    resting: list[RigidBody] = field(default_factory=list)  # bodies that do not move


def outline(
    frame: ReferenceFrame,
    origin: Point,
    bodies: Sequence[Body],
    loads: Sequence[Load],
    coordinates: Sequence[TimeFunction],
    names: Names,
    values: Mapping[AnySymbol, float],
    potential: sm.Expr | None = None,
    closed: bool = False,
) -> Outline:
    """Return the Outline of bodies and loads; an empty one if positions are unknown.

    Parameters
    ----------
    frame, origin : ReferenceFrame, Point
        Inertial frame, and a point at rest in it.
    bodies, loads, coordinates : sequences
    names : Names
        The states and specifieds; definitions of the rates of coordinates.
    values : mapping of symbols to float
        Constants; others are one.
    potential : expression, optional
        That of a Lagrangian, whose springs are no loads.
    closed : bool, optional
        Whether constraints close loops: points at rest may then be bearings where a loop ends.
    """
    try:
        outliner = _Outliner(frame, origin, bodies, loads, coordinates, names, values, potential)
        return outliner.outline(closed)
    except ValueError:  # a point or a frame is not connected: `animate` reports it
        return Outline()


class _Numbers:
    """Vectors and expressions, evaluated together at random states."""

    def __init__(
        self, frame: ReferenceFrame, origin: Point, frames: Iterable[ReferenceFrame]
    ) -> None:
        self.frame, self.origin, self.frames = frame, origin, tuple(dict.fromkeys(frames))
        self.vectors: dict[Hashable, Vector] = {}
        self.expressions: dict[Hashable, sm.Expr] = {}
        self.speeds: frozenset[SymbolOrName] = frozenset()  # the speeds among the states
        self.scale = 1.0  # of random states

    def evaluate(self, names: Names, values: Mapping[AnySymbol, float]) -> None:
        """Evaluate all of them; `names` and `values` as in `outline`."""
        supplied_symbols = {*names.states, *names.specifieds, *names.definitions, names.time}
        turns = (e for f in self.frames for m in FrameTree.orientations(f).values() for e in m)
        parts = [c for v in self.vectors.values() for m, _ in v.args for c in m]
        symbols = find_symbols([*parts, *self.expressions.values(), *turns])
        constants = {
            s: 1.0 for s in symbols if isinstance(s, sm.Symbol) and s not in supplied_symbols
        }
        constants |= {s: float(v) for s, v in values.items()}
        unsupplied = [
            s for s in symbols if not isinstance(s, sm.Symbol) and s not in supplied_symbols
        ]
        names = Names(
            names.states, (*names.specifieds, *unsupplied), tuple(constants), names.definitions
        )
        geometry = Geometry(
            self.frame, self.origin, self.frames, (), tuple(self.vectors.values()),
            tuple((str(k), e) for k, e in enumerate(self.expressions.values())),
        )  # fmt: skip
        program = pose_program(geometry, names)
        rng, m = np.random.default_rng(0), 2 * _SAMPLES
        states = self.scale * rng.uniform(0.3, 1.2, (m, len(names.states)))
        half = states[:_SAMPLES]
        moving = [k for k, s in enumerate(names.states) if s in self.speeds]
        states[_SAMPLES:] = half
        states[_SAMPLES:, moving] = 0.0
        times = np.tile(rng.uniform(0.3, 1.2, _SAMPLES), 2)
        inputs = np.zeros((m, len(names.specifieds)))
        for k, s in enumerate(names.specifieds):  # the same ones, whichever others there are
            by_name = np.random.default_rng([*str(s).encode()])
            inputs[:, k] = np.tile(by_name.uniform(0.3, 1.2, _SAMPLES), 2)
        rates = [k for k, s in enumerate(names.specifieds) if isinstance(s, sm.Derivative)]
        inputs[_SAMPLES:, rates] = 0.0
        with np.errstate(all="ignore"):
            out, _ = run(program, times, states, inputs, np.array([*constants.values()]))
        blocks = program.signature.by_block(out)
        self.turns = {f: blocks["rotations"][:, k] for k, f in enumerate(self.frames)}
        self._vectors = {k: blocks["vectors"][:, n] for n, k in enumerate(self.vectors)}
        self._series = {k: blocks["series"][:, n] for n, k in enumerate(self.expressions)}

    def vector(self, key: Hashable) -> np.ndarray:
        """Return a vector at all samples, (m, 3)."""
        return self._vectors[key]

    def series(self, key: Hashable) -> np.ndarray:
        """Return an expression at all samples, (m,)."""
        return self._series[key]


class _Outliner:
    """Determines the parts of an Outline in sequence."""

    def __init__(
        self,
        frame: ReferenceFrame,
        origin: Point,
        bodies: Sequence[Body],
        loads: Sequence[Load],
        coordinates: Sequence[TimeFunction],
        names: Names,
        values: Mapping[AnySymbol, float],
        potential: sm.Expr | None,
    ) -> None:
        self.frame, self.origin, self.bodies, self.names = frame, origin, bodies, names
        self.loads = [(w, v) for w, v in loads if isinstance(w, Point) and v != Vector(0)]
        self.values, self.potential = values, potential
        self.above = FrameTree.points_from([origin])
        self.centres = {body.masscenter for body in bodies}
        self.rigid = [body for body in bodies if isinstance(body, RigidBody)]
        self.groups: dict[ReferenceFrame, ReferenceFrame] = {}
        frames = [frame, *(body.frame for body in self.rigid)]
        self.numbers = _Numbers(frame, origin, frames)
        self.numbers.speeds = frozenset(names.states) - {*coordinates}
        self.result = Outline()

    def outline(self, closed: bool) -> Outline:
        """Return the Outline."""
        self.edges = [*self._edges()]
        self._prepare()
        self.numbers.evaluate(self.names, self.values)
        # Scale the states: next to lengths of a million, a coordinate of one changes nothing.
        scale = max(
            (float(np.abs(self.numbers.vector(edge)).max()) for edge in self.edges), default=1
        )
        if scale > 1.0 and np.isfinite(scale):
            self.numbers.scale = scale
            self.numbers.evaluate(self.names, self.values)
        self.pairs = [*self._force_pairs()]
        self.ground = self._reachable_from(
            self.origin, lambda a, b: self._is_fixed(a, b, self.frame)
        )
        self._find_bars()
        self._find_wheels()
        self._find_forces()
        self._find_rods_and_ropes()
        self._find_supports(closed)
        return self.result

    # -- input -----------------------------------------------------------------------------------

    def _edges(self) -> Iterator[Pair]:
        """Yield the pairs of points that lead from the origin to mass centres and forces."""
        visited: set[Point] = set()
        for point in (*(b.masscenter for b in self.bodies), *(target for target, _ in self.loads)):
            while point not in visited and (above := self.above.get(point)) is not None:
                visited.add(point)
                yield above, point
                point = above

    def _force_pairs(self) -> Iterator[tuple[Point, Point, Vector, np.ndarray]]:
        """Yield two points, the force on the second, opposite to that on the first, and numbers."""
        forces = [
            k
            for k, (target, force) in enumerate(self.loads)
            if target in self.above and _varying(force)
        ]
        self.paired: set[int] = set()
        if not forces:
            return
        rows = np.stack([self.numbers.vector(("force", k)).ravel() for k in forces])
        for i, k in enumerate(forces):
            size = np.abs(rows[i]).max()
            if k in self.paired or not size > 0:
                continue
            for j in (
                i + 1 + np.flatnonzero(np.abs(rows[i + 1 :] + rows[i]).max(axis=1) <= HALF * size)
            ).tolist():
                (start, _), (point, force) = self.loads[k], self.loads[forces[j]]
                if forces[j] not in self.paired and start is not point:
                    self.paired |= {k, forces[j]}
                    yield start, point, force, rows[j].reshape(-1, 3)
                    break

    def _prepare(self) -> None:
        vectors, expressions = self.numbers.vectors, self.numbers.expressions
        around = [(point, c) for c in self.centres for point in FrameTree.positions(c)]
        # Any point connected to the origin may belong to a body, or to another mechanism.
        every = [(a, b) for b, a in self.above.items() if a is not None]
        related = {*FrameTree(self.frame).frame_depth}
        for a, b in (*self.edges, *around, *every):
            # In SymPy, NaN times a vector has no components.
            if all(f in related and m is not sm.nan for m, f in FrameTree.positions(b)[a].args):
                vectors[a, b] = FrameTree.positions(b)[a]
        for a, b in self.edges:
            for symbol in _varying(vectors[a, b]):
                vectors[a, b, symbol] = _slope(vectors[a, b], symbol)
        for k, (_, force) in enumerate(self.loads):
            vectors["force", k] = force
            # SymPy takes minutes for derivatives of a tire's force.
            for symbol in () if _jumps(force) else _functions(force):
                vectors["stiffness", k, symbol] = _slope(force, symbol)
        for body in self.rigid:
            for point, offset in FrameTree.positions(body.masscenter).items():
                if point not in self.centres:
                    velocity = FrameTree(self.frame).velocity(body.masscenter)
                    if velocity is not None:
                        spin = body.frame.ang_vel_in(self.frame)
                        vectors["slip", body.name, point] = velocity - spin.cross(offset)
                        vectors["speed", body.name, point] = velocity
        if self.potential is not None:
            for _, b in self.edges:
                for symbol in _varying(vectors[self.above[b], b]):
                    expressions[symbol] = sm.diff(self.potential, symbol, 2)

    # -- structure -------------------------------------------------------------------------------

    def _group(self, frame: ReferenceFrame) -> ReferenceFrame:
        """Return a common frame for all frames with constant relative orientation."""
        if frame not in self.groups:
            todo = [frame]
            self.groups[frame] = frame
            while todo:
                for neighbour, matrix in FrameTree.orientations(todo.pop()).items():
                    if neighbour not in self.groups and self.names.time not in matrix.free_symbols:
                        self.groups[neighbour] = frame
                        todo.append(neighbour)
        return self.groups[frame]

    def _is_fixed(self, a: Point, b: Point, frame: ReferenceFrame) -> bool:
        """Return whether the vector from a to b is constant in a frame, by its components."""
        vector = FrameTree.positions(b)[a]
        group = self._group(frame)
        return all(self._group(f) is group for _, f in vector.args) and not any(
            self.names.time in part.free_symbols for part, _ in vector.args
        )

    def _is_fixed_in(self, body: RigidBody, a: Point, b: Point) -> bool:
        """Return whether the vector between two points is constant in a body's frame."""
        if self._is_fixed(a, b, body.frame):
            return True
        if (a, b) not in self.numbers.vectors or body.masscenter not in (a, b):
            return False
        away = np.einsum("mji,mj->mi", self.numbers.turns[body.frame], self.numbers.vector((a, b)))
        return _constant(away)

    @staticmethod
    def _reachable_from(
        start: Point, is_connected: Callable[..., bool]
    ) -> dict[Point, Point | None]:
        """Return the points connected to a start through pairs, each with its predecessor."""
        before, todo = {start: None}, [start]
        while todo:
            a = todo.pop(0)
            for b in FrameTree.positions(a):
                if b not in before and is_connected(a, b):
                    before[b] = a
                    todo.append(b)
        return before

    # -- the parts -------------------------------------------------------------------------------

    def _find_bars(self) -> None:
        self.members: dict[RigidBody, set[Point]] = {}  # the points of each body
        drawn_links: dict[tuple[ReferenceFrame, Point], RigidBody] = {}
        for body in self.rigid:
            centre = body.masscenter
            if self._group(body.frame) is self._group(self.frame) and centre in self.ground:
                self.result.resting.append(body)
                self.members[body] = {centre}
                continue
            tree = self._reachable_from(
                centre, lambda a, b, body=body: self._is_fixed_in(body, a, b)
            )
            self.members[body] = {*tree}
            if drawn_links.setdefault((self._group(body.frame), centre), body) is not body:
                continue  # two bodies on one link
            drawn_links.update({(self._group(body.frame), point): body for point in tree})
            self.result.bars += [(body, pair) for pair in self._bars_of(tree)]

    def _bars_of(self, tree: Mapping[Point, Point | None]) -> list[Pair]:
        """Return the bars between points of a body: a single one if they are collinear."""
        offsets = {point: self._offset(point, tree) for point in tree}
        rows = np.array([*offsets.values()])
        length = float(np.abs(rows).max())
        points = [*offsets]
        if not length > 0.0:
            return []
        _, sizes, directions = np.linalg.svd(rows / length)
        order = {point: k for k, point in enumerate(self.above)}  # from the origin
        if rank_of(sizes) == 1:
            positions = rows @ directions[0]
            ends = sorted(
                (int(positions.argmin()), int(positions.argmax())), key=lambda k: order[points[k]]
            )
            return [(points[ends[0]], points[ends[1]])]
        return [
            (before, point)
            for point, before in tree.items()
            if before is not None and np.abs(offsets[point] - offsets[before]).max() > HALF * length
        ]

    def _first_sample(self, a: Point, b: Point) -> np.ndarray:
        vectors = self.numbers.vectors
        if (a, b) in vectors:
            offset: np.ndarray = self.numbers.vector((a, b))[0]
            return offset
        return -self.numbers.vector((b, a))[0] if (b, a) in vectors else np.zeros(3)

    def _offset(self, point: Point, tree: Mapping[Point, Point | None]) -> np.ndarray:
        """Return the vector from a tree's root to a point at the first sample."""
        offset = np.zeros(3)
        while (before := tree[point]) is not None:
            offset += self._first_sample(before, point)
            point = before
        return offset

    def _find_wheels(self) -> None:
        """Find wheels: bodies that roll or slip on a point of another body."""
        self.touching: set[Pair] = set()
        fixed = {p for points in self.members.values() for p in points}
        for body in self.rigid:
            centre = body.masscenter
            for contact in FrameTree.positions(centre):
                if body in self.result.wheels or contact in fixed | self.centres:
                    continue
                away = self.numbers.vector((contact, centre))
                if not away.any() or not _constant(np.linalg.norm(away, axis=1)):
                    continue
                if not self._touches(body, contact):
                    continue
                in_body = np.einsum("mji,mj->mi", self.numbers.turns[body.frame], away)
                flat = np.abs(in_body).max(axis=0) <= HALF * np.abs(in_body).max()
                if flat.sum() > 1:
                    continue
                axis = "xyz"[int(flat.argmax())] if flat.any() else None
                vector = FrameTree.positions(centre)[contact]
                radius = sm.sqrt(vector.dot(vector))
                if self.names.time in radius.free_symbols:  # angles in it may cancel
                    radius = self._of_constants(radius, float(np.linalg.norm(away[0])))
                self.result.wheels[body] = radius, axis
                self.touching |= {(contact, centre), (centre, contact)}

    def _of_constants(self, length: sm.Expr, number: float) -> sm.Expr | float:
        """Return a length in which all functions cancel as an expression of constants.

        The expression is that of the length in the zero state, or in another one if it is undefined
        there. If the length is constant only for the present values, return the `number`.
        """
        functions = sorted(length.atoms(AppliedUndef), key=str)
        if length.has(sm.Derivative):
            return number
        fixed = sm.nan
        for first, step in ((0, 0), (sm.Rational(3, 7), sm.Rational(1, 11))):
            if fixed.has(sm.nan, sm.zoo, sm.oo):
                state = {f: first + k * step for k, f in enumerate(functions)}
                fixed = length.xreplace(state).xreplace({self.names.time: first})
        probe = _Numbers(self.frame, self.origin, ())
        probe.expressions = {"length": length, "fixed": fixed}
        probe.speeds, probe.scale = self.numbers.speeds, self.numbers.scale
        rng = np.random.default_rng(1)
        values = dict.fromkeys(length.free_symbols, 1.0) | dict(self.values)
        del values[self.names.time]
        probe.evaluate(self.names, {s: v * rng.uniform(0.95, 1.05) for s, v in values.items()})
        lengths = np.concatenate([probe.series("length"), probe.series("fixed")])
        return fixed if _constant(lengths) and lengths.all() else number

    def _touches(self, body: RigidBody, contact: Point) -> bool:
        """Return whether a point is a contact: it is a leaf, or the body rolls there."""
        if len(FrameTree.positions(contact)) == 1 and contact is not self.origin:
            return True
        if ("slip", body.name, contact) not in self.numbers.vectors:
            return False
        slip = self.numbers.vector(("slip", body.name, contact))
        return bool(
            np.abs(slip).max()
            <= HALF * np.abs(self.numbers.vector(("speed", body.name, contact))).max()
        )

    def _find_forces(self) -> None:
        """Find springs, dampers and actuators in opposite forces between two points."""
        self.forced: set[frozenset[Point]] = set()
        self.pulled: set[frozenset[Point]] = set()
        displacements = _Numbers(self.frame, self.origin, ())
        displacements.speeds, displacements.scale = self.numbers.speeds, self.numbers.scale
        displacements.vectors = {k: b.pos_from(a) for k, (a, b, *_) in enumerate(self.pairs)}
        if self.pairs:
            displacements.evaluate(self.names, self.values)
        for k, (a, b, force, pull) in enumerate(self.pairs):
            displacement = displacements.vector(k)
            length = np.linalg.norm(displacement, axis=1)
            size = np.linalg.norm(pull, axis=1)
            off = np.linalg.norm(np.cross(displacement, pull), axis=1)
            if not np.isfinite(pull).all() or not (length > 0).all() or _constant(length):
                continue
            if (off > HALF * length * size).any() or _jumps(force):
                continue
            static = slice(_SAMPLES, None)
            key = frozenset((a, b))
            if (size[static] <= HALF * size.max()).all():
                self.result.dampers.append((a, b))
                self.forced.add(key)
                continue
            tension = -(displacement * pull).sum(1) / length
            rising = np.diff(tension[static][np.argsort(length[static])])
            # An input that moves an end, such as the height of a road, is none of the force.
            moving = {*self.names.states, *_functions(displacements.vectors[k])}
            if {*_functions(force)} - moving or _constant(tension):
                self.pulled.add(key)  # an input: tension of a rope, or an actuator
            elif (rising >= -HALF * size.max()).all():
                self.result.springs.append((a, b))
                self.forced.add(key)
        self.result.springs = [*dict.fromkeys(self.result.springs)]
        self.result.dampers = [*dict.fromkeys(self.result.dampers)]

    def _find_rods_and_ropes(self) -> None:
        inside = [{*points} for points in self.members.values()]
        for a, b in self.edges:
            if (a, b) in self.touching or frozenset((a, b)) in self.forced:
                continue
            if (a in self.ground and b in self.ground) or any(a in s and b in s for s in inside):
                continue
            displacement = self.numbers.vector((a, b))
            length = np.linalg.norm(displacement, axis=1)
            if not (length > 0).all():
                continue
            if _constant(length):
                self.result.bars.append((None, (a, b)))
                continue
            stretch = self._stretching(a, b, displacement)
            if stretch is None:
                continue
            if self._is_held(b, stretch, self.numbers.vector((a, b, stretch))):
                self.result.springs.append((a, b))
                if self._is_damped(b, stretch):
                    self.result.dampers.append((a, b))
            elif not _constant(displacement / length[:, None]):
                self.result.ropes.append((a, b))
        drawn = {
            frozenset(p) for p in (*self.result.ropes, *(pair for _, pair in self.result.bars))
        }
        for a, b, *_ in self.pairs:
            key = frozenset((a, b))
            if key in self.pulled and key not in drawn | self.forced:
                self.result.dampers.append((a, b))
                drawn.add(key)

    def _stretching(self, a: Point, b: Point, displacement: np.ndarray) -> AnySymbol | None:
        """Return the single function that changes only the length of a vector, or None.

        Other functions may rotate it: l sin θ N.x - l cos θ N.y is stretched by l only, and
        x N.x + y N.y by none alone.
        """
        stretching = []
        length = np.linalg.norm(displacement, axis=1)
        for symbol in _varying(FrameTree.positions(b)[a]):
            slope = self.numbers.vector((a, b, symbol))
            size = np.linalg.norm(slope, axis=1) * length
            across = np.linalg.norm(np.cross(slope, displacement), axis=1)
            if (across <= HALF * size).all():
                stretching.append(symbol)
            elif (np.abs((slope * displacement).sum(1)) > HALF * size).any():
                return None
        return stretching[0] if len(stretching) == 1 else None

    def _is_held(self, point: Point, symbol: AnySymbol, stretch: np.ndarray) -> bool:
        """Return whether a force at a point, or a potential, restores a length."""
        if self.potential is not None and symbol in self.numbers.expressions:
            return bool((self.numbers.series(symbol) > 0).all())
        for k, (target, _) in enumerate(self.loads):
            key = ("stiffness", k, symbol)
            if target is point and self._is_single(k) and key in self.numbers.vectors:
                slope = (self.numbers.vector(key) * stretch).sum(1)
                if (slope < 0).all():
                    return True
        return False

    def _is_single(self, k: int) -> bool:
        """Return whether the k-th force is smooth, and its opposite acts at no other point."""
        return k not in self.paired and not _jumps(self.loads[k][1])

    def _is_damped(self, point: Point, symbol: AnySymbol) -> bool:
        rate = sm.Derivative(symbol, self.names.time)
        rates = {rate, self.names.definitions.get(rate)}
        loads_at_point = (k for k, (target, _) in enumerate(self.loads) if target is point)
        every = (self.loads[k][1] for k in loads_at_point if self._is_single(k))
        return any(rates & {*_functions(force), *_derivatives(force)} for force in every)

    def _find_supports(self, closed: bool) -> None:
        """Find the fixed points to which bars, ropes and springs are attached."""
        lines = [pair for _, pair in self.result.bars]
        lines += [*self.result.ropes, *self.result.springs, *self.result.dampers]
        ends = dict.fromkeys(p for pair in lines for p in pair if p in self.ground)
        # Bodies attached to a fixed point by a joint with a coincident point.
        for a, b in self.edges:
            if a in self.ground and b not in self.ground and self.numbers.vector((a, b)).any():
                continue
            if a in self.ground and b not in self.ground:
                ends[a] = None
        if closed:
            ends |= {
                p: None
                for p in self.ground
                if len(FrameTree.positions(p)) == 1 and p is not self.origin
            }
        offsets = [self._offset(body.masscenter, self.ground) for body in self.result.resting]
        for point in ends:  # one support for coincident points
            offset = self._offset(point, self.ground)
            if not any(
                (np.abs(offset - occupied) <= HALF * np.abs(occupied)).all() for occupied in offsets
            ):
                self.result.supports.append(point)
                offsets.append(offset)


def _constant(rows: np.ndarray) -> bool:
    """Return whether all rows are equal up to rounding."""
    return bool(np.ptp(rows, axis=0).max() <= HALF * np.abs(rows).max())


def _functions(vector: Vector) -> list[AnySymbol]:
    """Return the functions of time in a vector's components, without those of its frames."""
    return sorted(_inside(vector, AppliedUndef), key=str)


def _derivatives(vector: Vector) -> set[sm.Derivative]:
    return _inside(vector, sm.Derivative)


def _inside(vector: Vector, *kinds: type) -> set[Any]:
    """Return what is of some kinds in a vector's components."""
    every = (sm.sympify(c) for part, _ in vector.args for c in part)
    return {p for c in every for p in parts_of(c) if isinstance(p, kinds)}


def _varying(vector: Vector) -> list[AnySymbol]:
    """Return the functions in a vector, and the time if it occurs explicitly."""
    functions = _functions(vector)
    if dynamicsymbols._t in find_symbols([part for part, _ in vector.args]):
        functions.append(dynamicsymbols._t)
    return functions


def _slope(vector: Vector, symbol: AnySymbol) -> Vector:
    """Return the partial derivative of a vector's components with respect to a function or time."""
    hidden = {f: sm.Dummy() for f in _functions(vector)} | {
        d: sm.Dummy() for d in _derivatives(vector)
    }
    restored = {dummy: f for f, dummy in hidden.items()}
    variable = hidden.get(symbol, symbol)
    parts = [
        (part.xreplace(hidden).diff(variable).xreplace(restored), frame)
        for part, frame in vector.args
    ]
    return sum((Vector([part]) for part in parts), Vector(0))


def _jumps(vector: Vector) -> bool:
    """Return whether a force is not smooth, as those of contacts and friction."""
    return bool(_inside(vector, *_JUMPS))
