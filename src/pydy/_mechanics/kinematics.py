"""Angular velocities, velocities and accelerations on the graph.

Each frame's motion follows from that of the frame its angular velocity is given in, each point's
from that of a point beside it. Vectors are three nodes, components in a frame that is said beside
them; direction cosines are multiplied along the way between two frames.

The components of every velocity are *anchors*: places where derivatives stop. The derivatives of an
anchor by those that it is made of are few; those of a velocity by all speeds are their product, and
are never multiplied out (`pydy._mechanics.form`). Accelerations are those at u' = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from sympy.physics.mechanics import Point

from pydy._graph import Graph, Rows, signatures
from pydy._mechanics.components import flat, in_rows, transposed, turned, unrounded
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.frames import Frames
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.planes import Detours
from pydy._mechanics.reader import InputReader, checked_vector

Vec = list[int]
# The frame of the components, velocity, acceleration at u' = 0.
Motion = tuple[Any, Vec, Vec]
# Components of a vector, a frame for each three.
Parts = list[tuple[Vec, Any]]


class Kinematics:
    """Motion of frames and points in the inertial frame.

    Velocities of points are written `in_bodies`, in the frames of these, or else in the inertial
    frame. The `auxiliary` speeds are inputs or else zero. Accelerations are those at u' = 0, at the
    u' of `start` if `referred`, or at u' that are inputs if `driven`. Points are `honoured` whose
    velocity, the user's, is not the derivative of their place. In place of `loads`, `pull` is taken
    off the accelerations of points (`pydy._mechanics.form`).
    """

    def __init__(
        self,
        body: Multibody,
        *,
        in_bodies: bool,
        auxiliary: bool = False,
        referred: bool = False,
        driven: bool = False,
        honoured: Iterable[Any] = (),
    ) -> None:
        self.body, self.in_bodies, self.honoured = body, in_bodies, frozenset(honoured)
        g = self.graph = Graph()
        self.inertial = body.frame
        states = [*body.coordinates, *body.speeds]
        atoms = g.input_nodes(x=states, t=[body.time])
        time = atoms[body.time]
        coordinates = self.coordinates = [atoms[s] for s in body.coordinates]
        self.speeds = [atoms[s] for s in body.speeds]
        self.accelerations = [g.input("a", k) for k in range(len(self.speeds))]
        atoms.update(zip(body.speed_rates, self.accelerations, strict=True))
        self.auxiliary = [g.input("aux", k) for k in range(len(body.auxiliary) if auxiliary else 0)]
        for k, s in enumerate(body.auxiliary):
            atoms[s] = self.auxiliary[k] if auxiliary else g.zero
            atoms[s.diff(body.time)] = g.zero
        self.read = InputReader(g, atoms, states)
        self.read.second = self._second
        self.rates = self.read.all(body.coordinate_derivatives)
        for symbol, node in zip(body.coordinate_rates, self.rates, strict=True):
            self.read.define(symbol, node)
        self._dots = Rows(
            g,
            {n: {0: d} if d != g.zero else {} for n, d in zip(coordinates, self.rates, strict=True)}
            | {time: {0: g.one}},
            self._rate_of_input,
        )
        if driven:
            moved = zip(self.speeds, self.accelerations, strict=True)
            self._dots.known.update((speed, {0: rate}) for speed, rate in moved)
        variables = [*self.speeds, *self.auxiliary]
        self.rows = Rows(g, {n: {n: g.one} for n in variables})
        self.groups: list[list[int]] = []
        self.detours = Detours()
        self._referred = referred
        self.tree = FrameTree(body.frame)
        self.frames = Frames(g, self.tree, self.read)
        self._cosines: dict[Any, list[Vec]] = {}
        self._spins: dict[Any, tuple[Vec, Vec]] = {}
        self._motions: dict[Any, Motion] = {}
        self._moved: dict[Any, tuple[Vec, Vec]] = {}
        self._ways: dict[Any, tuple[Any, tuple[Any, ...]]] = {}
        self._turnings: dict[Any, list[Vec]] = {}
        self._parts: dict[Any, Parts] = {}
        self.loads: tuple[tuple[Any, Any], ...] = body.loads
        self.pull: Vec | None = None

    # -- time -------------------------------------------------------------------------------------

    def _rate_of_input(self, node: int) -> dict[int, int]:
        group, index = self.graph.args[node]
        if group != "r":
            return {}
        rate = self.read(self.read.specifieds[index].diff(self.body.time))
        return {0: rate} if rate != self.graph.zero else {}

    def _second(self, symbol: Any) -> int | None:
        """Return a coordinate's second derivative, at u' = 0, where accelerations are read."""
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
        """Return the u' of accelerations: where speeds allow, joints then have no angular one."""
        return self.dt(self.speeds)

    def symbols(self) -> dict[int, Any]:
        """Return the symbol of each input node, except auxiliary speeds."""
        body, read, g = self.body, self.read, self.graph
        states = (*body.coordinates, *body.speeds)
        return g.input_symbols(
            t=[body.time], x=states, a=body.speed_rates, p=read.constants, r=read.specifieds
        )

    # -- vectors ----------------------------------------------------------------------------------

    def turned(self, matrix: Sequence[Sequence[int]], v: Sequence[int]) -> Vec:
        """Return the product of a matrix and a vector."""
        return turned(self.graph, matrix, v)

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
        """Whether nothing had to be expressed in another frame so far."""
        return not self.frames.steps

    def _cosine(self, frame: Any) -> list[Vec]:
        """Return the matrix from components in the inertial frame to those in a frame."""
        if frame not in self._cosines:
            parent, own = self.frames.parent(frame), self.frames.step(frame)
            if parent is not self.inertial:
                outer = transposed(self._cosine(parent))
                own = [self.turned(outer, row) for row in own]
            self._cosines[frame] = own
        return self._cosines[frame]

    def expressed(self, v: Sequence[int], frame: Any, to: Any) -> Vec:
        """Return the components in another frame."""
        if frame is to or all(n == self.graph.zero for n in v):
            return list(v)
        if frame is self.inertial:
            return self.turned(self._cosine(to), v)
        if to is self.inertial:
            return self.turned(transposed(self._cosine(frame)), v)
        up, down = self.frames.way_in(frame), self.frames.way_in(to)
        while up and down and up[-1] is down[-1]:
            up.pop()
            down.pop()
        for f in up:
            v = self.turned(transposed(self.frames.step(f)), v)
        for f in reversed(down):
            v = self.turned(self.frames.step(f), v)
        return list(v)

    def vector(self, vector: Any, to: Any) -> Vec:
        """Return the components of a SymPy vector in a frame."""
        total = [self.graph.zero] * 3
        for part, frame in checked_vector(vector, "A position, velocity or load").args:
            total = self.plus(
                total, self.expressed(*self.frames.in_axes(self.read.all(part), frame), to)
            )
        return total

    def tensor(self, terms: Iterable[tuple[Any, Any, Any]], to: Any) -> list[Vec]:
        """Return the components of a dyadic in a frame."""
        g = self.graph
        cells: list[list[list[tuple[int, float]]]] = [[[] for _ in range(3)] for _ in range(3)]
        for size, left, right in terms:
            s, a, b = self.read(size), self.vector(left, to), self.vector(right, to)
            for i in range(3):
                for j in range(3):
                    cells[i][j].append((g.mul(s, a[i], b[j]), 1.0))
        found = [[g.sum(cell) for cell in row] for row in cells]
        if not self.frames.written:
            return found
        return in_rows(unrounded(g, flat(found)))

    def equal(self, a: Sequence[int], b: Sequence[int]) -> bool:
        """Return whether nodes are equal as functions."""
        values = signatures(self.graph, [*a, *b])
        return values[: len(a)] == values[len(a) :]

    # -- anchors ----------------------------------------------------------------------------------

    def anchored(self, v: Vec, groups: list[list[int]] | None = None) -> Vec:
        """Let derivatives stop at the components of a velocity; add them to the groups."""
        g, known, group = self.graph, self.rows.known, []
        for n in v:
            c, core = g.scaled(n)
            if g.ops[core] == "sum" and g.args[core][1][0][1] < 0.0:
                c, core = -c, g.neg(core)
            if g.ops[core] in ("const", "input") or known.get(core) == {core: g.one}:
                continue
            known[core] = {core: g.one}
            for node, size in ((n, c), (g.neg(core), -1.0)):
                if node != core:
                    known[node] = {core: g.const(size)}
            group.append(core)
        if group:
            (self.groups if groups is None else groups).append(group)
        return v

    def _handed(self, v: Vec, frame: Any, to: Any) -> Vec:
        """Return a velocity's components in another frame, as anchors."""
        count = len(self.groups)
        found = self.anchored(self.expressed(v, frame, to))
        direct = self.inertial not in (frame, to) and self.frames.parent(to) is frame
        if direct and len(self.groups) > count and len(planes := self.frames.planes(to)) > 1:
            parts = (self.graph, self.rows, (frame, to), (count, self.groups[count]), planes)
            self.detours.add(*parts, (v, found), self.anchored)
        return found

    # -- frames -----------------------------------------------------------------------------------

    def spin(self, frame: Any, home: Any = None) -> tuple[Vec, Vec]:
        """Return a frame's angular velocity and acceleration, in its own axes or another's."""
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

    def relative_spin(self, frame: Any, home: Any) -> Vec:
        """Return a frame's angular velocity in its base, in some axes."""
        if frame not in self.frames.turns:
            return self.vector(self.tree.relative_spin(frame, self.tree.turns_in(frame)), home)
        turns = self.frames.turns[frame] or [self.graph.zero] * 3
        # It turns about an axis that both have in common.
        return turns if home is self.frames.above[frame] else self.expressed(turns, frame, home)

    def _spun(self, frame: Any, base: Any, home: Any) -> tuple[Vec, Vec]:
        while home is not frame and home is not base and self.frames.is_fixed(base):
            base = self.frames.above[base]
        w, alpha = self.spin(base)
        own = self.relative_spin(frame, home)
        carried = self._handed(w, base, home)
        whole = self.plus(carried, own)
        # d/dt of `own` in the inertial frame takes the angular velocity of the axes it is in.
        turning = whole if home is frame else carried if home is base else self.spin(home)[0]
        alpha = self.plus(self.expressed(alpha, base, home), self.cross(turning, own))
        chosen = self._compensated(own, alpha) if self._referred else ()
        alpha = self.plus(alpha, self.dt(own))
        alpha = [self.graph.zero if i in chosen else n for i, n in enumerate(alpha)]
        return self.anchored(whole), alpha

    def _compensated(self, own: Vec, alpha: Vec) -> set[int]:
        """Choose u' that make components of an angular acceleration zero; return which.

        Only of speeds that are one component of a joint's own, and were not asked for before.
        """
        g, known = self.graph, self._dots.known
        found: set[int] = set()
        for i, n in enumerate(own):
            size, speed = g.scaled(n)
            others = g.reachable([m for j, m in enumerate(own) if j != i])
            alone = abs(size) == 1.0 and speed in self.speeds and speed not in others
            if alone and speed not in known and alpha[i] != g.zero:
                known[speed] = {0: g.sum([(alpha[i], -size)])}
                found.add(i)
        return found

    def turning(self, frame: Any) -> list[Vec]:
        """Return [α] + [ω][ω] in a frame's axes, which gives accelerations of positions."""
        if frame not in self._turnings:
            g, (w, alpha) = self.graph, self.spin(frame)
            matrix = [[g.zero] * 3 for _ in range(3)]
            for i in range(3):
                j, m = (i + 1) % 3, (i + 2) % 3
                matrix[i][i] = g.sum([(g.powi(w[j], 2), -1.0), (g.powi(w[m], 2), -1.0)])
                both = g.mul(w[j], w[m])
                matrix[j][m] = g.sub(both, alpha[i])
                matrix[m][j] = g.add(both, alpha[i])
            self._turnings[frame] = matrix
        return self._turnings[frame]

    def angular_acceleration(self, frame: Any, home: Any) -> Vec:
        """Return a frame's angular acceleration, the user's own where it is set."""
        alpha = self.spin(frame, home)[1]
        return self._users(self.tree.angular_acceleration(frame), alpha, home)

    def acceleration(self, point: Any) -> Vec:
        """Return a point's acceleration, the user's own where it is set.

        As in SymPy, that of other points does not follow from it.
        """
        home, _, a = self.motion(point)
        return self._users(self.tree.acceleration(point), a, home, self.pull)

    def _users(self, given: Any, derived: Vec, home: Any, pull: Vec | None = None) -> Vec:
        if given is None:
            return derived
        theirs = self._falling(self._accelerating(given, home), home, pull)
        return derived if self.equal(derived, theirs) else theirs

    def _falling(self, a: Vec, home: Any, pull: Vec | None) -> Vec:
        """Return an acceleration relative to free fall."""
        if pull is None:
            return a
        own = self.expressed(pull, self.inertial, home)
        return [self.graph.sub(x, y) for x, y in zip(a, own, strict=True)]

    def _accelerating(self, vector: Any, home: Any) -> Vec:
        """Return an acceleration that the user wrote, at the u' of `start`."""
        read = self.read
        known = dict(zip(self.body.speed_rates, self.accelerations, strict=True))
        for symbol, node in zip(known, self.start(), strict=True):
            read.define(symbol, node)
        self._at_rest = True
        parts = self.vector(vector, home)
        self._at_rest = False
        for symbol in self.body.coordinates:
            read.atoms.pop(symbol.diff(self.body.time, 2), None)
        for symbol, node in known.items():
            read.define(symbol, node)
        return parts

    # -- points -----------------------------------------------------------------------------------

    def place(self, points: Iterable[Any]) -> None:
        """Connect points by their positions; points whose motion is wanted must be there."""
        roles = {where: "which a load acts at" for where, _ in self.body.loads}
        roles |= {b.masscenter: f"the mass centre of the body {b.name}" for b in self.body.bodies}
        self._ways, self._parts = self.tree.paths(points, roles), {}

    def moved(self) -> list[Any]:
        """Return the points whose motion has been asked for."""
        return list(self._motions)

    def placed(self) -> list[Any]:
        """Return the points whose ways are known."""
        return list(self._ways)

    def way(self, point: Any) -> tuple[Any, tuple[Any, ...]]:
        """Return the point from which another is reached, None for a root, and the vectors."""
        return self._ways[point]

    def parts(self, point: Any) -> Parts:
        """Return the components of the way to a point from the one that it is reached from."""
        if point not in self._parts:
            given = [part for step in self._ways[point][1] for part in step.args]
            self._parts[point] = [
                self.frames.in_axes(self.read.all(v), frame) for v, frame in given
            ]
        return self._parts[point]

    def lead(self, point: Any, base: Any, parts: Parts) -> None:
        """Let a point be reached in another way."""
        self._ways[point], self._parts[point] = (base, ()), parts

    def at_rest(self, point: Any, frame: Any) -> bool:
        """Return whether a point does not move, nor the frame that it is fixed in."""
        zero = self.graph.zero
        return frame is self.inertial and all(n == zero for n in self.motion(point)[1])

    def motion(self, point: Any) -> Motion:
        """Return the frame of the components, velocity and acceleration of a point."""
        chain = [point]
        while chain[-1] not in self._motions and (base := self.base(chain[-1])) is not None:
            chain.append(base)
        for item in reversed(chain):
            if item not in self._motions:
                self._motions[item] = self._moving(item)
        return self._motions[point]

    def base(self, point: Any) -> Any:
        """Return the point that another's motion follows from, None where it is given."""
        return None if point in self.honoured else self._ways[point][0]

    def _moving(self, point: Any) -> Motion:
        base = self.base(point)
        if base is None:
            return self._given(point)
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
                else self.turned(self.turning(frame), r)
            )
            to = frame if self.in_bodies else self.inertial
            v, a = self._carried(base, home, v, a, to)
            v = self.anchored(self.plus(v, self.expressed(own_v, frame, to)))
            a = self.plus(a, self.expressed(own_a, frame, to))
            home, base = to, None
        return home, v, a

    def _carried(self, base: Any, home: Any, v: Vec, a: Vec, to: Any) -> tuple[Vec, Vec]:
        if home is to:
            return v, a
        key = (base, to)
        if base is None or key not in self._moved:
            above = self.frames.above.get(to)
            if above is not None and above is not home and self.frames.is_fixed(above):
                # The plane rotations between two hinges, one after the other.
                v, a = self._carried(base, home, v, a, above)
                home = above
            moved = self._handed(v, home, to), self.expressed(a, home, to)
            if base is None:
                return moved
            self._moved[key] = moved
        return self._moved[key]

    def motion_in(self, point: Any, frame: Any) -> tuple[Vec, Vec]:
        """Return a point's velocity and acceleration in the axes of a body's frame."""
        home, v, a = self.motion(point)
        return self._carried(point, home, v, a, frame)

    def first_there(self, point: Any) -> Any:
        """Return the first of the points that are at one place at all times."""
        while self.base(point) is not None and not self.parts(point):
            point = self.base(point)
        return point

    def fixed_step(self, point: Any) -> tuple[Any, Any, Vec] | None:
        """Return a point, the frame in which another is fixed to it, and the vector between.

        None where the point's own velocity is given, or the way is none of constants in one frame.
        """
        base = self.base(point)
        frames = list(dict.fromkeys(frame for _, frame in self.parts(point)))
        if base is None or len(frames) != 1:
            return None
        place = self.plus(*(part for part, _ in self.parts(point)))
        constant = all(self.graph.constant[n] for n in place)
        return (base, frames[0], place) if constant else None

    def _given(self, point: Any) -> Motion:
        """Return the motion of a point by the velocity that the user set."""
        velocity = self.tree.velocity(point)
        frames = [frame for _, frame in velocity.args]
        home = self.frames.axes(frames[-1]) if self.in_bodies and frames else self.inertial
        v = self.vector(velocity, home)
        a = self.plus(self.dt(v), self.cross(self.spin(home)[0], v))
        return home, self.anchored(v), self._falling(a, home, self.pull)

    def at(self, where: Any) -> tuple[Any, Vec]:
        """Return the frame and the components of the velocity of a point, or of a frame's spin."""
        if isinstance(where, Point):
            home, v, _ = self.motion(where)
            return home, v
        return self.frames.axes(where), self.spin(where)[0]
