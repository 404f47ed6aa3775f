"""The axes that vectors are written in, so that hinges turn about one of them; where joints are.

Frames that do not move against each other belong to one body: vectors and inertias in any of them
are turned into one set of axes, once for each set of constants. These axes are chosen so that the
body's own hinge and those of the bodies behind it lie along them, and rotations are plane. Between
two hinges at an angle there is one constant plane rotation, about their common normal (Denavit and
Hartenberg, Journal of Applied Mechanics 22 (1955) 215-221):

      ── q₁ about z ── W₁ ── α about x ── J ── q₂ about z ── W₂ ──

A constant rotation about the hinge itself is added to its angle. A body that turns about an axis is
referred to the point of the axis from which two components lead to the next joint in place of three
(ibid.).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from sympy.physics.mechanics import Point

from pydy._graph import Graph, signatures
from pydy._mechanics.components import about, flat, identity, in_rows, transposed, turned
from pydy._mechanics.kinematics import Kinematics, Parts, Vec
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.tuning import SAME_DIRECTION
from pydy._rank import ROUNDED

Matrix = list[Vec]


def hinge_axis(kinematics: Kinematics, frame: Any, before: Any) -> int | None:
    """Return which axis a frame has in common at all times with the one that it turns in."""
    k, g = kinematics, kinematics.graph
    if frame not in k.tree.frame_depth or frame is k.inertial:
        return None
    if k.frames.parent(frame) is not before or k.frames.base(frame) is not before:
        return None
    turn, spin = k.frames.step(frame), k.relative_spin(frame, frame)
    for i in range(3):
        unit = [g.one if j == i else g.zero for j in range(3)]
        others = {n for j, n in enumerate(spin) if j != i}
        if turn[i] == unit and [row[i] for row in turn] == unit and others == {g.zero}:
            return i
    return None


def in_a_plane(kinematics: Kinematics) -> bool:
    """Return whether all frames that occur turn about one axis."""
    k = kinematics
    frames = {frame for point in k.placed() for _, frame in k.parts(point)}
    frames |= {body.frame for body in k.body.bodies if is_rigid(body)}
    if not frames <= k.tree.frame_depth.keys():
        return False
    turning = {f for frame in frames for f in k.frames.way_in(frame)} - {k.inertial}
    axes = {hinge_axis(k, f, k.frames.parent(f)) for f in turning}
    return len(axes) <= 1 and None not in axes


@dataclass(frozen=True)
class _Joint:
    """A hinge at a point: the frame behind it, its axis there and in the frame before.

    `place` leads there, in the frame `before`, from the point `base`; `shortened` is the component
    of it that another point of the axis does not have.
    """

    frame: Any
    axis: int
    base: Any
    before: Any
    place: Vec
    direction: Vec
    shortened: int


def move_along_axes(kinematics: Kinematics) -> None:
    """Refer bodies on hinges to other points of their axes, where fewer products follow."""
    k, g = kinematics, kinematics.graph
    joints = _joints(k)
    shifts: dict[Any, int] = {}
    for point in sorted(joints, key=lambda p: k.tree.frame_depth[joints[p].frame]):
        joint = joints[point]
        n = joint.shortened
        own = joint.place[n]
        if joint.base in shifts and joints[joint.base].axis == n:
            own = g.sub(own, shifts[joint.base])
        shift = g.neg(g.div(own, joint.direction[n]))
        if k.at_rest(joint.base, joint.before):
            # Nothing depends on this place: the next joint's is made shorter.
            following = [
                j for j in joints.values() if j.base is point and j.shortened != joint.axis
            ]
            shift = following[0].place[joint.axis] if following else g.zero
        if shift != g.zero:
            shifts[point] = shift
    others = {point: Point(f"{point} on its axis") for point in shifts}
    for point, other in others.items():
        joint = joints[point]
        along = [g.mul(n, shifts[point]) for n in joint.direction]
        parts = [(joint.place, joint.before), (along, joint.before)]
        base = joint.base
        if base in others:
            parts.append(_back(g, joints[base], shifts[base]))
            base = others[base]
        k.lead(other, base, _joined(k, parts))
    kept = {other: k.way(other) for other in others.values()}
    for point in k.placed():
        base, _ = k.way(point)
        if point in others:
            k.lead(point, others[point], [_back(g, joints[point], shifts[point])])
        elif base in others and point not in kept:
            parts = [*k.parts(point), _back(g, joints[base], shifts[base])]
            k.lead(point, others[base], _joined(k, parts))


def _back(graph: Graph, joint: _Joint, shift: int) -> tuple[Vec, Any]:
    """Return the way back from the other point of an axis."""
    zero = graph.zero
    return [graph.neg(shift) if i == joint.axis else zero for i in range(3)], joint.frame


def _joined(kinematics: Kinematics, parts: Parts) -> Parts:
    """Add components in the same frame, without zeros."""
    found: dict[Any, Vec] = {}
    for v, frame in parts:
        found[frame] = kinematics.plus(found[frame], v) if frame in found else v
    graph = kinematics.graph
    for frame, v in found.items():
        sizes = [abs(graph.value(n) or 0.0) for n in v]
        tiny = ROUNDED * max(sizes)
        found[frame] = [
            graph.zero if graph.ops[n] == "const" and size <= tiny else n
            for n, size in zip(v, sizes, strict=True)
        ]
    return [(v, frame) for frame, v in found.items() if any(n != graph.zero for n in v)]


def _joints(kinematics: Kinematics) -> dict[Any, _Joint]:
    """Return the points that a hinge is at."""
    k = kinematics
    hung: dict[Any, set[Any]] = {}
    for point in k.placed():
        base, _ = k.way(point)
        hung.setdefault(base, set()).update(frame for _, frame in k.parts(point))
    for body in k.body.bodies:
        frame = k.frames.axes(body.frame) if is_rigid(body) else None
        hung.setdefault(body.masscenter, set()).add(frame)
    found: dict[Any, _Joint] = {}
    for point, frames in hung.items():
        step = point and k.fixed_step(point)
        if not step or len(frames) != 1:
            continue
        base, before, place = step
        (frame,) = frames
        if frame is None or frame is before or frame is k.inertial:
            continue
        if frame not in k.tree.frame_depth:
            continue
        inner = k.frames.parent(frame)
        axis = hinge_axis(k, frame, inner)
        if axis is None:
            continue
        direction = [k.graph.one if i == axis else k.graph.zero for i in range(3)]
        while k.frames.is_fixed(inner):
            direction = turned(k.graph, transposed(k.frames.step(inner)), direction)
            inner = k.frames.parent(inner)
        if inner is before:
            n = _shortened(k, direction, before)
            if n is not None:
                found[point] = _Joint(frame, axis, base, before, place, direction, n)
    return found


def _shortened(kinematics: Kinematics, direction: Vec, before: Any) -> int | None:
    """Return the component of a position to remove, in addition to that along the inner hinge.

    The way along the axis is that component over the direction's, which must not be small: between
    nearly parallel hinges the other point would be far away, and between parallel ones nowhere.
    Where the direction depends on constants it may be so for some of their values: None then.
    """
    g = kinematics.graph
    numbers = [g.value(n) for n in direction]
    sizes = [abs(size) for size in numbers if size is not None]
    if len(sizes) < 3:
        return None
    along = hinge_axis(kinematics, before, kinematics.frames.parent(before))
    if along is not None:
        others = [0.0 if i == along else size for i, size in enumerate(sizes)]
        if max(others) >= 1 / 16:  # a cosine to divide by: four bits are lost at most
            sizes = others
    return sizes.index(max(sizes))


_UNIT, _ZERO = np.eye(3), np.zeros(3)


class Axes:
    """Axes that belong to no frame of the user's."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __repr__(self) -> str:
        return self.name


@dataclass(frozen=True)
class _Turn:
    """A rotation by an angle a about an axis: n₂ n₁ᵀ + even cos a + odd sin a, all numbers."""

    angle: int
    even: np.ndarray
    odd: np.ndarray
    before: np.ndarray  # n₁, the axis in the frame before
    own: np.ndarray  # n₂, in the own one


@dataclass(eq=False)
class _Body:
    """Frames that do not move against each other."""

    root: Any  # the first of them
    before: Any = None  # the user's frame in which it is hinged
    turn: _Turn | None = None
    speed: int = 0  # how fast it turns about the hinge
    # Which give components in the root's axes.
    frames: dict[Any, Matrix] = field(default_factory=dict)
    hinged: list[_Body] = field(default_factory=list)  # what is hinged on it
    weight: int = 1  # bodies that hang on it, with itself


def align(kinematics: Kinematics) -> None:
    """Choose axes where a hinge is oblique in the user's.

    The ways to points must be known, and no motion may have been asked for.
    """
    _Alignment(kinematics).choose()


class _Alignment:
    def __init__(self, kinematics: Kinematics) -> None:
        self.kinematics, self.graph = kinematics, kinematics.graph
        g = self.graph
        self.unit = identity(g)
        self.bodies: dict[Any, _Body] = {}  # by each of their frames

    def choose(self) -> None:
        k = self.kinematics
        ground = _Body(k.inertial, frames={k.inertial: self.unit})
        self.bodies[k.inertial] = ground
        order = sorted(self._needed(), key=lambda f: k.tree.frame_depth[f])
        found = [body for f in order if (body := self._classified(f))]
        if not any(self._oblique(body) for body in found):
            return
        for body in reversed(found):
            if body.turn:
                self.bodies[body.before].weight += body.weight
        for body in (ground, *found):
            if body.turn is None or not (self._by_numbers(body) or self._by_symbols(body)):
                self._write(body, body.root, self.unit)

    def _needed(self) -> list[Any]:
        """Return the frames of bodies, loads and positions, and all between them and the ground."""
        k = self.kinematics
        frames = {b.frame for b in k.body.bodies if hasattr(b, "frame")}
        frames |= {where for where, _ in k.loads}
        for point in k.placed():
            frames |= {f for vector in k.way(point)[1] for _, f in vector.args}
        found: dict[Any, None] = {}
        for frame in sorted(frames, key=str):
            while frame in k.tree.frame_depth and frame is not k.inertial and frame not in found:
                found[frame] = None
                frame = k.tree.parent(frame)
        return list(found)

    # -- what there is ----------------------------------------------------------------------------

    def _classified(self, frame: Any) -> _Body | None:
        """Add a frame to its parent's group if it is fixed there, or return a new group."""
        k, g = self.kinematics, self.graph
        before = k.tree.parent(frame)
        body = _Body(frame, before, frames={frame: self.unit})
        if frame in k.tree.spin_depth and k.tree.turns_in(frame) is before:
            matrix = k.frames.given(frame, before)
            spin = k.tree.relative_spin(frame, before)
            if all(g.constant[n] for row in matrix for n in row) and not spin.args:
                whole = self.bodies[frame] = self.bodies[before]
                whole.frames[frame] = self._product(whole.frames[before], transposed(matrix))
                return None
            body.turn = _turn(g, matrix)
            if body.turn and not self._turns_only(body, spin):
                body.turn = None
        self.bodies[frame] = body
        if body.turn:
            self.bodies[before].hinged.append(body)
        return body

    def _turns_only(self, body: _Body, spin: Any) -> bool:
        """Find how fast a body turns about its hinge; say whether that is all that it does."""
        g, turn = self.graph, body.turn
        assert turn is not None
        total: list[tuple[int, float]] = []
        for part, frame in spin.args:
            axis = {body.root: turn.own, body.before: turn.before}.get(frame)
            if axis is None:
                return False
            rows = [g.linear(n) for n in self.kinematics.read.all(part)]
            for node in dict.fromkeys(n for row in rows for n in row):
                v = np.array([row.get(node, 0.0) for row in rows])
                size = float(axis @ v)
                if np.abs(v - size * axis).max() > SAME_DIRECTION * abs(size):
                    return False
                total.append((node, float(_snapped(np.array(size)))))
        body.speed = g.sum(total)
        return True

    def _oblique(self, body: _Body) -> bool:
        """Return whether a hinge is at an angle to the axes in which the body before moves."""
        if body.turn is None:
            return False
        place = self.bodies[body.before].frames[body.before]
        return self._coordinate(place, body.turn.before) is None

    def _coordinate(self, matrix: Matrix, direction: np.ndarray) -> tuple[int, float] | None:
        """Return the axis that a direction, seen through a matrix, is or is opposite to."""
        g = self.graph
        seen = [g.sum([(n, c) for n, c in zip(row, direction, strict=True)]) for row in matrix]
        numbers = [g.value(n) for n in seen]
        if None in numbers:
            values = signatures(g, [*seen, g.const(-1.0)])
            numbers = [{0: 0.0, 1: 1.0, values[3]: -1.0}.get(value) for value in values[:3]]
        return None if None in numbers else _axis(np.array(numbers, dtype=float))

    # -- axes by numbers --------------------------------------------------------------------------

    def _by_numbers(self, body: _Body) -> bool:
        """Choose any axes for a body whose frames are at angles that are numbers."""
        turn = body.turn
        assert turn is not None
        home, held = self.kinematics.frames.written_in(body.before)
        place = self._numbers(held)
        frames = {f: self._numbers(matrix) for f, matrix in body.frames.items()}
        if place is None or any(m is None for m in frames.values()):
            return False
        ahead = [
            matrix @ child.turn.before
            for child in sorted(body.hinged, key=lambda b: -b.weight)
            if child.turn is not None and (matrix := frames[child.before]) is not None
        ]
        ahead = [v for v in ahead if np.linalg.norm(np.cross(turn.own, v)) > SAME_DIRECTION]
        bends, index, sign = _bends(place @ turn.before, _axis(turn.own))
        for bend in bends:
            place = _snapped(bend @ place)
        own = _own_axes(turn, place, index, sign, ahead)
        angle = _angle(own @ turn.even @ place.T, own @ turn.odd @ place.T, index)
        if angle is None:
            return False
        for bend in bends:
            home = self._fixed(home, self._nodes(bend), body)
        circle = _circle(self.graph, [(turn.angle, angle[0])], angle[1])
        self._turn_about(body, home, index, circle, sign, self._nodes(own))
        return True

    # -- axes of the user's -----------------------------------------------------------------------

    def _by_symbols(self, body: _Body) -> bool:
        """Choose the axes of one of the body's frames."""
        g, turn = self.graph, body.turn
        assert turn is not None
        axis = _axis(turn.before)
        if axis is None or axis != _axis(turn.own):
            return False
        index, sign = axis
        plain = _angle(turn.even, turn.odd, index)
        if plain is None:
            return False
        home, held = self.kinematics.frames.written_in(body.before)
        carried = self._angle_of(held, index)
        tried = []
        for place, matrix in enumerate(map(transposed, body.frames.values())):
            angle = self._angle_of(matrix, index)
            if angle is not None:
                tried.append((self._score(body, matrix), -place, matrix, angle))
        _, _, own, angle = max(tried, key=lambda one: one[:2])
        if carried is None:
            home, carried = self._fixed(home, transposed(held), body), g.zero
        terms = [(turn.angle, plain[0]), (angle, 1.0), (carried, -1.0)]
        self._turn_about(body, home, index, _circle(g, terms, plain[1]), sign, own)
        return True

    def _score(self, body: _Body, own: Matrix) -> int:
        """Count the hinges that lie along an axis."""
        return sum(
            self._coordinate(self._product(own, body.frames[h.before]), h.turn.before) is not None
            for h in body.hinged
            if h.turn is not None
        )

    def _angle_of(self, matrix: Matrix, index: int) -> int | None:
        """Return the angle of a constant rotation about an axis, None if it is none such."""
        g = self.graph
        if matrix == self.unit:
            return g.zero
        j, m = (index + 1) % 3, (index + 2) % 3
        (_, c), (sign, s) = g.scaled(matrix[j][j]), g.scaled(matrix[j][m])
        if (g.ops[c], g.ops[s]) != ("cos", "sin") or g.args[c] != g.args[s]:
            return None
        terms = [(g.args[c][0], sign)]
        return g.sum(terms) if matrix == about(g, index, *_circle(g, terms, 0.0)) else None

    # -- what is written down ---------------------------------------------------------------------

    def _turn_about(
        self,
        body: _Body,
        home: Any,
        index: int,
        circle: tuple[int, int],
        sign: float,
        own: Matrix,
    ) -> None:
        k, g = self.kinematics, self.graph
        axes = body.root if own == self.unit else Axes(f"{body.root} in line with its hinge")
        spin = [g.zero] * 3
        spin[index] = g.sum([(body.speed, sign)])
        depth = k.tree.frame_depth[body.root]
        k.frames.insert(axes, home, about(g, index, *circle), spin, depth)
        self._write(body, axes, own)

    def _fixed(self, home: Any, matrix: Matrix, body: _Body) -> Any:
        """Return axes that are fixed relative to others."""
        if matrix == self.unit:
            return home
        k = self.kinematics
        axes = Axes(f"{body.root} before it turns")
        k.frames.insert(axes, home, matrix, None, k.tree.frame_depth[body.root])
        return axes

    def _write(self, body: _Body, axes: Any, own: Matrix) -> None:
        for frame, matrix in body.frames.items():
            whole = self._product(own, matrix)
            self.kinematics.frames.write(frame, axes, None if whole == self.unit else whole)

    # -- matrices ---------------------------------------------------------------------------------

    def _numbers(self, matrix: Matrix) -> np.ndarray | None:
        values = [self.graph.value(n) for n in flat(matrix)]
        return None if None in values else np.array(values, dtype=float).reshape(3, 3)

    def _nodes(self, numbers: np.ndarray) -> Matrix:
        return [[self.graph.const(x) for x in row] for row in numbers]

    def _product(self, a: Matrix, b: Matrix) -> Matrix:
        """Return a product of rotations, with its zeros and ones as such."""
        g = self.graph
        found = transposed([self.kinematics.turned(a, column) for column in transposed(b)])
        numbers = self._numbers(found)
        if numbers is not None:
            return self._nodes(_snapped(numbers))
        known = {0: g.zero, 1: g.one, signatures(g, [g.const(-1.0)])[0]: g.const(-1.0)}
        nodes = flat(found)
        return in_rows([known.get(v, n) for v, n in zip(signatures(g, nodes), nodes, strict=True)])


def _snapped(numbers: np.ndarray) -> np.ndarray:
    """Return numbers with the rounding of 0, 1 and -1 taken off."""
    near = np.rint(numbers)
    return np.where(np.abs(numbers - near) < ROUNDED, near, numbers)


def _axis(direction: np.ndarray) -> tuple[int, float] | None:
    """Return the axis that a unit vector lies along, and whether it points the same way."""
    snapped = _snapped(direction)
    (used,) = np.nonzero(snapped)
    return (int(used[0]), float(snapped[used[0]])) if len(used) == 1 else None


def _turn(graph: Graph, matrix: Matrix) -> _Turn | None:
    """Return a matrix as a rotation about an axis of numbers, None if it is none."""
    parts = {"const": np.zeros((3, 3)), "cos": np.zeros((3, 3)), "sin": np.zeros((3, 3))}
    angles = set()
    for i, row in enumerate(matrix):
        for j, entry in enumerate(row):
            for node, c in graph.linear(entry).items():
                op = graph.ops[node]
                if op not in parts:
                    return None
                if op != "const":
                    angles.add(graph.args[node][0])
                parts[op][i, j] = c
    if len(angles) != 1:
        return None
    still = parts["const"]
    before = still[np.abs(still).sum(axis=1).argmax()]
    before = _snapped(before / max(np.linalg.norm(before), np.finfo(float).tiny))
    own = _snapped(still @ before)
    if before[np.abs(before).argmax()] < 0.0:
        before, own = -before, -own
    for a in (0.3, 1.7):
        whole = np.outer(own, before) + parts["cos"] * np.cos(a) + parts["sin"] * np.sin(a)
        wrong = np.abs(whole @ whole.T - _UNIT).max() + np.abs(still - np.outer(own, before)).max()
        if wrong > SAME_DIRECTION or np.linalg.det(whole) < 0.0:
            return None
    return _Turn(angles.pop(), parts["cos"], parts["sin"], before, own)


def _bends(
    direction: np.ndarray, wanted: tuple[int, float] | None
) -> tuple[list[np.ndarray], int, float]:
    """Return plane rotations after which a direction lies along an axis, and that with its sign."""
    target = 2 if wanted is None else wanted[0]
    found: list[np.ndarray] = []
    while (axis := _axis(direction)) is None:
        (zeros,) = np.nonzero(_snapped(direction) == 0.0)
        about = int(zeros[0]) if len(zeros) else target
        j, m = (about + 1) % 3, (about + 2) % 3
        if m == target:
            j, m = m, j
        size = np.hypot(direction[j], direction[m])
        bend = np.eye(3)
        bend[j, j] = bend[m, m] = direction[j] / size
        bend[j, m], bend[m, j] = direction[m] / size, -direction[m] / size
        direction = _snapped(bend @ direction)
        found.append(bend)
    return found, *axis


def _own_axes(
    turn: _Turn, place: np.ndarray, index: int, sign: float, ahead: list[np.ndarray]
) -> np.ndarray:
    """Return the matrix from components in a body's frame to those in its axes."""
    if _axis(turn.own) == (index, sign) and np.count_nonzero(_snapped(sum(ahead[:1], _ZERO))) < 3:
        return _UNIT
    if not ahead:
        # As the axes before, where the angle is zero.
        return _snapped(place @ (np.outer(turn.own, turn.before) + turn.even).T)
    normal = np.cross(turn.own, ahead[0])
    # Of nearly parallel axes little is left but rounding: what is along the axis is taken off.
    normal /= np.linalg.norm(normal)
    normal -= turn.own * (turn.own @ normal)
    rows = np.zeros((3, 3))
    rows[index], rows[(index + 1) % 3] = sign * turn.own, normal / np.linalg.norm(normal)
    rows[(index + 2) % 3] = np.cross(rows[index], rows[(index + 1) % 3])
    return _snapped(rows)


def _angle(even: np.ndarray, odd: np.ndarray, index: int) -> tuple[float, float] | None:
    """Return s and b if a rotation about an axis by the angle a is one by s a + b."""
    j, m = (index + 1) % 3, (index + 2) % 3
    c, s = even[j, j], even[j, m]
    sign = float(np.rint(odd[j, m] * c - odd[j, j] * s))
    expected = np.zeros((2, 3, 3))
    expected[:, j, j] = expected[:, m, m] = c, -sign * s
    expected[:, j, m] = s, sign * c
    expected[:, m, j] = -expected[:, j, m]
    if np.abs(np.array([even, odd]) - expected).max() > SAME_DIRECTION:
        return None
    return sign, float(_snapped(np.arctan2(s, c)))


def _circle(graph: Graph, terms: list[tuple[int, float]], start: float) -> tuple[int, int]:
    """Return cosine and sine of a sum, of which right angles are taken out."""
    quarters = round(start / (np.pi / 2))
    start -= quarters * np.pi / 2
    phi = graph.sum(terms, 0.0 if abs(start) < ROUNDED else start)
    c, s = graph.call("cos", phi), graph.call("sin", phi)
    for _ in range(quarters % 4):
        c, s = graph.neg(s), c
    return c, s
