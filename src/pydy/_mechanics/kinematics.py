"""Angular velocities, velocities and accelerations on the graph.

The motion of a frame follows from that of the frame in which its angular velocity is given, the
motion of a point from that of a neighbouring point. Vectors are three nodes, the components in a
frame that is passed along; direction cosines are multiplied along the path between two frames.

The components of every velocity are *anchors*, at which differentiation stops. An anchor has few
derivatives with respect to the anchors that it depends on; those of a velocity with respect to all
speeds are their product, which is never multiplied out. Accelerations are those at u' = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, TypeAlias

from sympy.physics.mechanics import Point

from pydy._graph import DerivativeRows, Graph, signatures
from pydy._mechanics.components import flat, in_rows, product, transposed, unrounded
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.frames import Frames
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.planes import IntermediateFrames
from pydy._mechanics.reader import InputReader, checked_vector

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import ReferenceFrame, Vector

    from pydy._mechanics.frame_tree import AnyFrame, BaseAndSteps
    from pydy._sympy_types import AnySymbol, Load, Location

Vec = list[int]
# The frame of the components, velocity, acceleration at u' = 0.
Motion: TypeAlias = "tuple[AnyFrame, Vec, Vec]"
# Components of a vector, a frame for each three.
Parts: TypeAlias = "list[tuple[Vec, AnyFrame]]"


class Kinematics:
    """Motion of frames and points in the inertial frame.

    Velocities of points are expressed in the frames of bodies if `in_bodies`, else in the inertial
    frame. The `auxiliary` speeds are inputs, or zero. Accelerations are those at u' = 0, at the u'
    of `start` if `referred`, or at u' that are inputs if `driven`. Points are `honoured` if the
    velocity that the user set is not the derivative of their position. Instead of weights among
    the `loads`, `pull` is subtracted from the accelerations of points.
    """

    def __init__(
        self,
        body: Multibody,
        *,
        in_bodies: bool,
        auxiliary: bool = False,
        referred: bool = False,
        driven: bool = False,
        honoured: Iterable[Point] = (),
    ) -> None:
        self.body, self.in_bodies, self.honoured = body, in_bodies, frozenset(honoured)
        g = self.graph = Graph()
        self.inertial = body.frame
        states = [*body.coordinates, *body.speeds]
        atoms: dict[AnySymbol, int] = {s: g.input("x", k) for k, s in enumerate(states)}
        atoms[body.time] = time = g.input("t", 0)
        coordinates = self.coordinates = [atoms[s] for s in body.coordinates]
        self.speeds = [atoms[s] for s in body.speeds]
        self.accelerations = [g.input("a", k) for k in range(len(self.speeds))]
        atoms.update(zip(body.kinematics.speed_rates, self.accelerations, strict=True))
        self.auxiliary = [g.input("aux", k) for k in range(len(body.auxiliary) if auxiliary else 0)]
        for k, s in enumerate(body.auxiliary):
            atoms[s] = self.auxiliary[k] if auxiliary else g.zero
            atoms[s.diff(body.time)] = g.zero
        self.read = InputReader(g, atoms, states)
        self.read.second = self._second
        self.rates = self.read.all(body.kinematics.coordinate_derivatives)
        for symbol, node in zip(body.kinematics.coordinate_rates, self.rates, strict=True):
            self.read.define(symbol, node)
        self._dots = DerivativeRows(
            g,
            {n: {0: d} if d != g.zero else {} for n, d in zip(coordinates, self.rates, strict=True)}
            | {time: {0: g.one}},
            self._rate_of_input,
        )
        if driven:
            moved = zip(self.speeds, self.accelerations, strict=True)
            self._dots.stored.update((speed, {0: rate}) for speed, rate in moved)
        variables = [*self.speeds, *self.auxiliary]
        self.rows = DerivativeRows(g, {n: {n: g.one} for n in variables})
        self.groups: list[list[int]] = []
        self.intermediate_frames = IntermediateFrames()
        self._referred = referred
        self.tree = FrameTree(body.frame)
        self.frames = Frames(g, self.tree, self.read)
        self._cosines: dict[AnyFrame, list[Vec]] = {}
        self._spins: dict[tuple[AnyFrame, AnyFrame], tuple[Vec, Vec]] = {}
        self._motions: dict[Point, Motion] = {}
        self._moved: dict[tuple[Point, AnyFrame], tuple[Vec, Vec]] = {}
        self._paths: dict[Point, BaseAndSteps] = {}
        self._turnings: dict[AnyFrame, list[Vec]] = {}
        self._parts: dict[Point, Parts] = {}
        self.loads: tuple[Load, ...] = body.loads
        self.pull: Vec | None = None

    # -- time -------------------------------------------------------------------------------------

    def _rate_of_input(self, node: int) -> dict[int, int]:
        group, index = self.graph.args[node]
        if group != "r":
            return {}
        rate = self.read(self.read.specifieds[index].diff(self.body.time))
        return {0: rate} if rate != self.graph.zero else {}

    def _second(self, symbol: sm.Derivative) -> int | None:
        """Return a coordinate's second derivative at u' = 0 while accelerations are read."""
        if not self._at_rest or symbol.derivative_count != 2:
            return None
        if symbol.expr not in self.body.coordinates:
            return None
        return self.dt([self.rates[self.body.coordinates.index(symbol.expr)]])[0]

    _at_rest = False

    def dt(self, nodes: Sequence[int]) -> Vec:
        """Return derivatives by time at the u' of `start`."""
        zero = self.graph.zero
        return [self._dots(n).get(0, zero) for n in nodes]

    def start(self) -> Vec:
        """Return the u' at which angular accelerations of joints vanish, as far as speeds allow."""
        return self.dt(self.speeds)

    def symbols(self) -> dict[int, AnySymbol]:
        """Return the symbol of each input node, except auxiliary speeds."""
        body, read, g = self.body, self.read, self.graph
        states = (*body.coordinates, *body.speeds)
        groups = {"t": [body.time], "x": states, "a": body.kinematics.speed_rates}
        groups |= {"p": read.constants, "r": read.specifieds}
        return {g.input(group, k): s for group, part in groups.items() for k, s in enumerate(part)}

    # -- vectors ----------------------------------------------------------------------------------

    def product(self, matrix: Sequence[Sequence[int]], v: Sequence[int]) -> Vec:
        """Return the product of a matrix and a vector."""
        return product(self.graph, matrix, v)

    def cross(self, a: Sequence[int], b: Sequence[int]) -> Vec:
        """Return the vector product."""
        g = self.graph
        return [g.sub(g.mul(a[i], b[j]), g.mul(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]

    def plus(self, *vectors: Sequence[int]) -> Vec:
        """Return the sum of vectors."""
        return [self.graph.add(*parts) for parts in zip(*vectors, strict=True)]

    # -- components -------------------------------------------------------------------------------

    @property
    def in_one_frame(self) -> bool:
        """Whether no vector has been expressed in another frame so far."""
        return not self.frames.steps

    def _cosine(self, frame: AnyFrame) -> list[Vec]:
        """Return the matrix from components in the inertial frame to those in a frame."""
        if frame not in self._cosines:
            parent, matrix = self.frames.parent(frame), self.frames.step(frame)
            if parent is not self.inertial:
                outer = transposed(self._cosine(parent))
                matrix = [self.product(outer, row) for row in matrix]
            self._cosines[frame] = matrix
        return self._cosines[frame]

    def expressed(self, v: Sequence[int], frame: AnyFrame, target: AnyFrame) -> Vec:
        """Return the components in another frame."""
        if frame is target or all(n == self.graph.zero for n in v):
            return list(v)
        if frame is self.inertial:
            return self.product(self._cosine(target), v)
        if target is self.inertial:
            return self.product(transposed(self._cosine(frame)), v)
        inwards, outwards = (
            self.frames.path_to_inertial(frame),
            self.frames.path_to_inertial(target),
        )
        while inwards and outwards and inwards[-1] is outwards[-1]:
            inwards.pop()
            outwards.pop()
        for f in inwards:
            v = self.product(transposed(self.frames.step(f)), v)
        for f in reversed(outwards):
            v = self.product(self.frames.step(f), v)
        return list(v)

    def vector(self, vector: Vector, target: AnyFrame) -> Vec:
        """Return the components of a SymPy vector in a frame."""
        total = [self.graph.zero] * 3
        for part, frame in checked_vector(vector, "A position, velocity or load").args:
            total = self.plus(
                total, self.expressed(*self.frames.in_axes(self.read.all(part), frame), target)
            )
        return total

    def tensor(
        self, terms: Iterable[tuple[sm.Expr, Vector, Vector]], target: AnyFrame
    ) -> list[Vec]:
        """Return the components of a dyadic in a frame."""
        g = self.graph
        cells: list[list[list[tuple[int, float]]]] = [[[] for _ in range(3)] for _ in range(3)]
        for size, first, second in terms:
            s, a, b = self.read(size), self.vector(first, target), self.vector(second, target)
            for i in range(3):
                for j in range(3):
                    cells[i][j].append((g.mul(s, a[i], b[j]), 1.0))
        matrix = [[g.sum(cell) for cell in row] for row in cells]
        if not self.frames.written:
            return matrix
        return in_rows(unrounded(g, flat(matrix)))

    def equal(self, a: Sequence[int], b: Sequence[int]) -> bool:
        """Return whether nodes are equal as functions."""
        values = signatures(self.graph, [*a, *b])
        return values[: len(a)] == values[len(a) :]

    # -- anchors ----------------------------------------------------------------------------------

    def anchored(self, v: Vec, groups: list[list[int]] | None = None) -> Vec:
        """Make the components of a velocity anchors, and add them to the groups."""
        g, derivatives, group = self.graph, self.rows.stored, []
        for n in v:
            c, core = g.scaled(n)
            if g.ops[core] == "sum" and g.args[core][1][0][1] < 0.0:
                c, core = -c, g.neg(core)
            if g.ops[core] in ("const", "input") or derivatives.get(core) == {core: g.one}:
                continue
            derivatives[core] = {core: g.one}
            for node, size in ((n, c), (g.neg(core), -1.0)):
                if node != core:
                    derivatives[node] = {core: g.const(size)}
            group.append(core)
        if group:
            (self.groups if groups is None else groups).append(group)
        return v

    def _anchored_in(self, v: Vec, frame: AnyFrame, target: AnyFrame) -> Vec:
        """Return a velocity's components in another frame, as anchors."""
        count = len(self.groups)
        components = self.anchored(self.expressed(v, frame, target))
        direct = self.inertial not in (frame, target) and self.frames.parent(target) is frame
        if direct and len(self.groups) > count and len(planes := self.frames.planes(target)) > 1:
            parts = (self.graph, self.rows, (frame, target), (count, self.groups[count]), planes)
            self.intermediate_frames.add(*parts, (v, components), self.anchored)
        return components

    # -- frames -----------------------------------------------------------------------------------

    def spin(self, frame: AnyFrame, home: AnyFrame | None = None) -> tuple[Vec, Vec]:
        """Return the angular velocity and acceleration of a frame, by default in its own axes."""
        frame = self.frames.axes(frame)
        home = frame if home is None else home
        key = (frame, home)
        if key not in self._spins:
            g, base = self.graph, self.frames.base(frame)
            if base is None:
                self._spins[key] = [g.zero] * 3, [g.zero] * 3
            else:
                self._spins[key] = self._spun(frame, base, home)
        return self._spins[key]

    def relative_spin(self, frame: AnyFrame, home: AnyFrame) -> Vec:
        """Return a frame's angular velocity in its base, in some axes."""
        if frame not in self.frames.turns:
            return self.vector(self.tree.relative_spin(frame, self.tree.turns_in(frame)), home)
        turns = self.frames.turns[frame] or [self.graph.zero] * 3
        # The rotation axis is common to both.
        return turns if home is self.frames.above[frame] else self.expressed(turns, frame, home)

    def _spun(self, frame: AnyFrame, base: AnyFrame, home: AnyFrame) -> tuple[Vec, Vec]:
        """Return the spin of a frame from that of its `base`, with components in the axes `home`.

        ω = ω_base + ω_rel and α = α_base + ω_axes × ω_rel + dω_rel/dt, with ω_axes those of `home`.
        """
        while home is not frame and home is not base and self.frames.is_fixed(base):
            base = self.frames.above[base]
        w, alpha = self.spin(base)
        relative = self.relative_spin(frame, home)
        base_spin = self._anchored_in(w, base, home)
        spin = self.plus(base_spin, relative)
        # The derivative in the inertial frame needs the angular velocity of the axes of `relative`.
        axes_spin = spin if home is frame else base_spin if home is base else self.spin(home)[0]
        alpha = self.plus(self.expressed(alpha, base, home), self.cross(axes_spin, relative))
        chosen = self._compensated(relative, alpha) if self._referred else ()
        alpha = self.plus(alpha, self.dt(relative))
        alpha = [self.graph.zero if i in chosen else n for i, n in enumerate(alpha)]
        return self.anchored(spin), alpha

    def _compensated(self, relative: Vec, alpha: Vec) -> set[int]:
        """Choose u' that cancel components of an angular acceleration; return these components.

        Only speeds that are one component of the joint's angular velocity and are still free count.
        """
        g, derivatives = self.graph, self._dots.stored
        compensated: set[int] = set()
        for i, n in enumerate(relative):
            size, speed = g.scaled(n)
            other_inputs = g.reachable([m for j, m in enumerate(relative) if j != i])
            alone = abs(size) == 1.0 and speed in self.speeds and speed not in other_inputs
            if alone and speed not in derivatives and alpha[i] != g.zero:
                derivatives[speed] = {0: g.sum([(alpha[i], -size)])}
                compensated.add(i)
        return compensated

    def turning(self, frame: AnyFrame) -> list[Vec]:
        """Return [α] + [ω][ω] in a frame's axes, which gives accelerations of positions."""
        if frame not in self._turnings:
            g, (w, alpha) = self.graph, self.spin(frame)
            matrix = [[g.zero] * 3 for _ in range(3)]
            for i in range(3):
                j, m = (i + 1) % 3, (i + 2) % 3
                matrix[i][i] = g.sum([(g.powi(w[j], 2), -1.0), (g.powi(w[m], 2), -1.0)])
                product = g.mul(w[j], w[m])
                matrix[j][m] = g.sub(product, alpha[i])
                matrix[m][j] = g.add(product, alpha[i])
            self._turnings[frame] = matrix
        return self._turnings[frame]

    def angular_acceleration(self, frame: ReferenceFrame, home: AnyFrame) -> Vec:
        """Return a frame's angular acceleration, as the user set it if so."""
        alpha = self.spin(frame, home)[1]
        return self._users(self.tree.angular_acceleration(frame), alpha, home)

    def acceleration(self, point: Point) -> Vec:
        """Return a point's acceleration, as the user set it if so.

        As in SymPy, it does not affect the accelerations of other points.
        """
        home, _, a = self.motion(point)
        return self._users(self.tree.acceleration(point), a, home, self.pull)

    def _users(
        self, user_value: Vector | None, derived: Vec, home: AnyFrame, pull: Vec | None = None
    ) -> Vec:
        if user_value is None:
            return derived
        user_components = self._falling(self._accelerating(user_value, home), home, pull)
        return derived if self.equal(derived, user_components) else user_components

    def _falling(self, a: Vec, home: AnyFrame, pull: Vec | None) -> Vec:
        """Return an acceleration relative to free fall."""
        if pull is None:
            return a
        free_fall = self.expressed(pull, self.inertial, home)
        return [self.graph.sub(x, y) for x, y in zip(a, free_fall, strict=True)]

    def _accelerating(self, vector: Vector, home: AnyFrame) -> Vec:
        """Return an acceleration that the user wrote, at the u' of `start`."""
        read = self.read
        symbols = dict(zip(self.body.kinematics.speed_rates, self.accelerations, strict=True))
        for symbol, node in zip(symbols, self.start(), strict=True):
            read.define(symbol, node)
        self._at_rest = True
        parts = self.vector(vector, home)
        self._at_rest = False
        for symbol in self.body.coordinates:
            read.atoms.pop(symbol.diff(self.body.time, 2), None)
        for symbol, node in symbols.items():
            read.define(symbol, node)
        return parts

    # -- points -----------------------------------------------------------------------------------

    def connect(self, points: Iterable[Point]) -> None:
        """Connect points by their positions, before the motion of any of them is computed."""
        roles = {location: "which a load acts at" for location, _ in self.body.loads}
        roles |= {b.masscenter: f"the mass centre of the body {b.name}" for b in self.body.bodies}
        self._paths, self._parts = self.tree.paths(points, roles), {}

    def moved(self) -> list[Point]:
        """Return the points whose motion has been computed."""
        return list(self._motions)

    def placed(self) -> list[Point]:
        """Return the points that are connected."""
        return list(self._paths)

    def path(self, point: Point) -> BaseAndSteps:
        """Return the point from which a point is located, None for a root, and the vectors."""
        return self._paths[point]

    def parts(self, point: Point) -> Parts:
        """Return the components of the vectors to a point from the one that it is located from."""
        if point not in self._parts:
            vectors = [part for step in self._paths[point][1] for part in step.args]
            self._parts[point] = [
                self.frames.in_axes(self.read.all(v), frame) for v, frame in vectors
            ]
        return self._parts[point]

    def reroute(self, point: Point, base: Point, parts: Parts) -> None:
        """Locate a point from another base."""
        self._paths[point], self._parts[point] = (base, ()), parts

    def at_rest(self, point: Point, frame: AnyFrame) -> bool:
        """Return whether a point is at rest and `frame` is inertial."""
        zero = self.graph.zero
        return frame is self.inertial and all(n == zero for n in self.motion(point)[1])

    def motion(self, point: Point) -> Motion:
        """Return the frame of the components, velocity and acceleration of a point."""
        chain = [point]
        while chain[-1] not in self._motions and (base := self.base(chain[-1])) is not None:
            chain.append(base)
        for item in reversed(chain):
            if item not in self._motions:
                self._motions[item] = self._moving(item)
        return self._motions[point]

    def base(self, point: Point) -> Point | None:
        """Return the point from which a motion is derived; None if it is given."""
        return None if point in self.honoured else self._paths[point][0]

    def _moving(self, point: Point) -> Motion:
        base = self.base(point)
        if base is None:
            return self._motion_by_user(point)
        home, v, a = self._motions[base]
        for r, frame in self.parts(point):
            w, alpha = self.spin(frame)
            rate = self.dt(r)
            own_v = self.plus(self.cross(w, r), rate)
            own_a = (
                self.plus(
                    self.cross(alpha, r), self.dt(rate), self.cross(w, self.plus(own_v, rate))
                )
                if any(n != self.graph.zero for n in rate)
                else self.product(self.turning(frame), r)
            )
            target = frame if self.in_bodies else self.inertial
            v, a = self._motion_in_axes(base, home, v, a, target)
            v = self.anchored(self.plus(v, self.expressed(own_v, frame, target)))
            a = self.plus(a, self.expressed(own_a, frame, target))
            home, base = target, None
        return home, v, a

    def _motion_in_axes(
        self, base: Point | None, home: AnyFrame, v: Vec, a: Vec, target: AnyFrame
    ) -> tuple[Vec, Vec]:
        if home is target:
            return v, a
        key = (base, target)
        if base is None or key not in self._moved:
            above = self.frames.above.get(target)
            if above is not None and above is not home and self.frames.is_fixed(above):
                # Apply the plane rotations between two hinges one after the other.
                v, a = self._motion_in_axes(base, home, v, a, above)
                home = above
            moved = self._anchored_in(v, home, target), self.expressed(a, home, target)
            if base is None:
                return moved
            self._moved[key] = moved
        return self._moved[key]

    def motion_in(self, point: Point, frame: AnyFrame) -> tuple[Vec, Vec]:
        """Return a point's velocity and acceleration in the axes of a body's frame."""
        home, v, a = self.motion(point)
        return self._motion_in_axes(point, home, v, a, frame)

    def first_there(self, point: Point) -> Point:
        """Return the innermost of the points that always coincide."""
        while self.base(point) is not None and not self.parts(point):
            point = self.base(point)
        return point

    def fixed_step(self, point: Point) -> tuple[Point, AnyFrame, Vec] | None:
        """Return the base of a point, the frame in which both are fixed, and the vector between.

        None if the velocity of the point is given, or the vector is not constant in one frame.
        """
        base = self.base(point)
        frames = list(dict.fromkeys(frame for _, frame in self.parts(point)))
        if base is None or len(frames) != 1:
            return None
        offset = self.plus(*(part for part, _ in self.parts(point)))
        constant = all(self.graph.constant[n] for n in offset)
        return (base, frames[0], offset) if constant else None

    def _motion_by_user(self, point: Point) -> Motion:
        """Return the motion of a point with the velocity that the user set."""
        velocity = self.tree.velocity(point)
        assert velocity is not None
        frames = [frame for _, frame in velocity.args]
        home = self.frames.axes(frames[-1]) if self.in_bodies and frames else self.inertial
        v = self.vector(velocity, home)
        a = self.plus(self.dt(v), self.cross(self.spin(home)[0], v))
        return home, self.anchored(v), self._falling(a, home, self.pull)

    def velocity_of(self, item: Location) -> tuple[AnyFrame, Vec]:
        """Return axes and components of a point's velocity or a frame's angular velocity."""
        if isinstance(item, Point):
            home, v, _ = self.motion(item)
            return home, v
        return self.frames.axes(item), self.spin(item)[0]
