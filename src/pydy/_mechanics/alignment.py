"""The axes in which vectors are expressed, aligned with hinges; the points that stand for joints.

Frames without relative motion belong to one body: vectors and inertias in any of them are expressed
in one set of axes, once for each set of constants. These axes are chosen so that the body's own
hinge and those of its outer bodies lie along them, and rotations are plane. Between two hinges at
an angle there is one constant plane rotation, about their common normal (Denavit and Hartenberg,
Journal of Applied Mechanics 22 (1955) 215-221):

      ── q₁ about z ── W₁ ── α about x ── J ── q₂ about z ── W₂ ──

A constant rotation about the hinge itself is added to its angle. The joint point of a hinge is
moved along its axis, so that the vector to the next joint has two components instead of three
(ibid.).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from sympy.physics.mechanics import Point

from pydy._graph import Graph, linear_terms, signatures
from pydy._mechanics.components import axis_rotation, flat, identity, in_rows, product, transposed
from pydy._mechanics.frame_tree import Axes
from pydy._mechanics.kinematics import Kinematics, Parts, Vec
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.tuning import SAME_DIRECTION
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from sympy.physics.mechanics import ReferenceFrame, Vector

    from pydy._mechanics.frame_tree import AnyFrame

Matrix = list[Vec]


def hinge_axis(kinematics: Kinematics, frame: AnyFrame, before: AnyFrame | None) -> int | None:
    """Return the number of the axis about which a frame rotates in the frame before, or None."""
    k, g = kinematics, kinematics.graph
    if frame not in k.tree.frame_depth or frame is k.inertial:
        return None
    if k.frames.parent(frame) is not before or k.frames.base(frame) is not before:
        return None
    turn, spin = k.frames.step(frame), k.relative_spin(frame, frame)
    for i in range(3):
        unit = [g.one if j == i else g.zero for j in range(3)]
        components = {n for j, n in enumerate(spin) if j != i}
        if turn[i] == unit and [row[i] for row in turn] == unit and components == {g.zero}:
            return i
    return None


def in_a_plane(kinematics: Kinematics) -> bool:
    """Return whether all frames rotate about parallel axes."""
    k = kinematics
    frames = {frame for point in k.placed() for _, frame in k.parts(point)}
    frames |= {body.frame for body in k.body.bodies if is_rigid(body)}
    if not frames <= k.tree.frame_depth.keys():
        return False
    turning = {f for frame in frames for f in k.frames.path_to_inertial(frame)} - {k.inertial}
    axes = {hinge_axis(k, f, k.frames.parent(f)) for f in turning}
    return len(axes) <= 1 and None not in axes


@dataclass(frozen=True)
class _Joint:
    """A hinge at a point: the outer frame, and the axis in it and in the frame before.

    `position` leads there, in the frame `before`, from the point `base`; `shortened` is the
    component of it that is removed by moving along the axis.
    """

    frame: AnyFrame
    axis: int
    base: Point
    before: AnyFrame
    position: Vec
    direction: Vec
    shortened: int


def choose_joint_points(kinematics: Kinematics) -> None:
    """Move joint points along the axes of their hinges if that saves products."""
    k, g = kinematics, kinematics.graph
    joints = _joints(k)
    shifts: dict[Point, int] = {}
    for point in sorted(joints, key=lambda p: k.tree.frame_depth[joints[p].frame]):
        joint = joints[point]
        n = joint.shortened
        position = joint.position[n]
        if joint.base in shifts and joints[joint.base].axis == n:
            position = g.sub(position, shifts[joint.base])
        shift = g.neg(g.div(position, joint.direction[n]))
        if k.at_rest(joint.base, joint.before):
            # The position of the base is free: shorten that of the next joint.
            following = [
                j for j in joints.values() if j.base is point and j.shortened != joint.axis
            ]
            shift = following[0].position[joint.axis] if following else g.zero
        if shift != g.zero:
            shifts[point] = shift
    axis_points = {point: Point(f"{point} on its axis") for point in shifts}
    for point, axis_point in axis_points.items():
        joint = joints[point]
        offset = [g.mul(n, shifts[point]) for n in joint.direction]
        parts = [(joint.position, joint.before), (offset, joint.before)]
        base = joint.base
        if base in axis_points:
            parts.append(_back(g, joints[base], shifts[base]))
            base = axis_points[base]
        k.reroute(axis_point, base, _summed(k, parts))
    moved_points = {axis_point: k.path(axis_point) for axis_point in axis_points.values()}
    for point in k.placed():
        base, _ = k.path(point)
        if point in axis_points:
            k.reroute(point, axis_points[point], [_back(g, joints[point], shifts[point])])
        elif base in axis_points and point not in moved_points:
            parts = [*k.parts(point), _back(g, joints[base], shifts[base])]
            k.reroute(point, axis_points[base], _summed(k, parts))


def _back(graph: Graph, joint: _Joint, shift: int) -> tuple[Vec, AnyFrame]:
    """Return the vector from the moved point of an axis back to the joint."""
    zero = graph.zero
    return [graph.neg(shift) if i == joint.axis else zero for i in range(3)], joint.frame


def _summed(kinematics: Kinematics, parts: Parts) -> Parts:
    """Add vectors in the same frame, without rounding errors and zeros."""
    sums: dict[AnyFrame, Vec] = {}
    for v, frame in parts:
        sums[frame] = kinematics.plus(sums[frame], v) if frame in sums else v
    graph = kinematics.graph
    for frame, v in sums.items():
        sizes = [abs(graph.value(n) or 0.0) for n in v]
        tiny = ROUNDED * max(sizes)
        sums[frame] = [
            graph.zero if graph.ops[n] == "const" and size <= tiny else n
            for n, size in zip(v, sizes, strict=True)
        ]
    return [(v, frame) for frame, v in sums.items() if any(n != graph.zero for n in v)]


def _joints(kinematics: Kinematics) -> dict[Point, _Joint]:
    """Return the joints by the points that they are located at."""
    k = kinematics
    frames_at: dict[Point | None, set[AnyFrame | None]] = {}
    for point in k.placed():
        base, _ = k.path(point)
        frames_at.setdefault(base, set()).update(frame for _, frame in k.parts(point))
    for body in k.body.bodies:
        frame = k.frames.axes(body.frame) if is_rigid(body) else None
        frames_at.setdefault(body.masscenter, set()).add(frame)
    joints: dict[Point, _Joint] = {}
    for point, frames in frames_at.items():
        step = point and k.fixed_step(point)
        if not step or len(frames) != 1:
            continue
        base, before, position = step
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
            direction = product(k.graph, transposed(k.frames.step(inner)), direction)
            inner = k.frames.parent(inner)
        if inner is before:
            n = _shortened(k, direction, before)
            if n is not None:
                joints[point] = _Joint(frame, axis, base, before, position, direction, n)
    return joints


def _shortened(kinematics: Kinematics, direction: Vec, before: AnyFrame) -> int | None:
    """Return the component of a position to remove, in addition to that along the inner hinge.

    The shift along the axis is that component over the direction's, which must not be small:
    between nearly parallel hinges the moved point would be far away, between parallel ones at
    infinity. If the direction depends on constants this may occur for some values: return None.
    """
    g = kinematics.graph
    numbers = [g.value(n) for n in direction]
    sizes = [abs(size) for size in numbers if size is not None]
    if len(sizes) < 3:
        return None
    inner_axis = hinge_axis(kinematics, before, kinematics.frames.parent(before))
    if inner_axis is not None:
        remaining = [0.0 if i == inner_axis else size for i, size in enumerate(sizes)]
        if max(remaining) >= 1 / 16:  # a cosine to divide by: four bits are lost at most
            sizes = remaining
    return sizes.index(max(sizes))


_UNIT, _ZERO = np.eye(3), np.zeros(3)


@dataclass(frozen=True)
class _HingeRotation:
    """A rotation by an angle a about an axis: n₂ n₁ᵀ + even cos a + odd sin a, all numbers."""

    angle: int
    even: np.ndarray
    odd: np.ndarray
    before: np.ndarray  # n₁, the axis in the frame before
    own_axis: np.ndarray  # n₂, the axis in the frame itself


@dataclass(eq=False)
class _Body:
    """Frames without relative motion."""

    root: ReferenceFrame  # the first of them
    before: ReferenceFrame | None = None  # the user's frame in which it rotates
    turn: _HingeRotation | None = None
    speed: int = 0  # its angular speed about the hinge
    # Matrices that give components in the root's axes.
    frames: dict[ReferenceFrame, Matrix] = field(default_factory=dict)
    hinged: list[_Body] = field(default_factory=list)  # bodies whose hinges are on it
    weight: int = 1  # number of outer bodies, with itself


def align(kinematics: Kinematics) -> None:
    """Choose axes if a hinge is oblique in those of the user.

    The paths to points must be known, and no motion may have been computed yet.
    """
    _Alignment(kinematics).choose()


class _Alignment:
    def __init__(self, kinematics: Kinematics) -> None:
        self.kinematics, self.graph = kinematics, kinematics.graph
        g = self.graph
        self.unit = identity(g)
        self.bodies: dict[ReferenceFrame, _Body] = {}  # by frame

    def choose(self) -> None:
        k = self.kinematics
        ground = _Body(k.inertial, frames={k.inertial: self.unit})
        self.bodies[k.inertial] = ground
        order = sorted(self._needed(), key=lambda f: k.tree.frame_depth[f])
        bodies = [body for f in order if (body := self._classified(f))]
        if not any(self._oblique(body) for body in bodies):
            return
        for body in reversed(bodies):
            if body.turn:
                self.bodies[body.before].weight += body.weight
        for body in (ground, *bodies):
            if body.turn is None or not (self._by_numbers(body) or self._by_symbols(body)):
                self._write(body, body.root, self.unit)

    def _needed(self) -> list[ReferenceFrame]:
        """Return the frames of bodies, loads and positions, and all between them and the ground."""
        k = self.kinematics
        frames = {b.frame for b in k.body.bodies if hasattr(b, "frame")}
        frames |= {location for location, _ in k.loads}
        for point in k.placed():
            frames |= {f for vector in k.path(point)[1] for _, f in vector.args}
        needed: dict[ReferenceFrame, None] = {}
        for frame in sorted(frames, key=str):
            while frame in k.tree.frame_depth and frame is not k.inertial and frame not in needed:
                needed[frame] = None
                frame = k.tree.parent(frame)
        return list(needed)

    # -- bodies and hinges
    # ----------------------------------------------------------------------------

    def _classified(self, frame: ReferenceFrame) -> _Body | None:
        """Add a frame to its parent's group if it is fixed there, or return a new group."""
        k, g = self.kinematics, self.graph
        before = k.tree.parent(frame)
        body = _Body(frame, before, frames={frame: self.unit})
        if frame in k.tree.spin_depth and k.tree.turns_in(frame) is before:
            matrix = k.frames.user_rotation(frame, before)
            spin = k.tree.relative_spin(frame, before)
            if all(g.constant[n] for row in matrix for n in row) and not spin.args:
                group = self.bodies[frame] = self.bodies[before]
                group.frames[frame] = self._product(group.frames[before], transposed(matrix))
                return None
            body.turn = _turn(g, matrix)
            if body.turn and not self._turns_only(body, spin):
                body.turn = None
        self.bodies[frame] = body
        if body.turn:
            self.bodies[before].hinged.append(body)
        return body

    def _turns_only(self, body: _Body, spin: Vector) -> bool:
        """Set the angular speed of a body about its hinge; return whether that is all its spin."""
        g, turn = self.graph, body.turn
        assert turn is not None
        total: list[tuple[int, float]] = []
        for part, frame in spin.args:
            axis = {body.root: turn.own_axis, body.before: turn.before}.get(frame)
            if axis is None:
                return False
            rows = [linear_terms(g, n) for n in self.kinematics.read.all(part)]
            for node in dict.fromkeys(n for row in rows for n in row):
                v = np.array([row.get(node, 0.0) for row in rows])
                size = float(axis @ v)
                if np.abs(v - size * axis).max() > SAME_DIRECTION * abs(size):
                    return False
                total.append((node, float(_snapped(np.array(size)))))
        body.speed = g.sum(total)
        return True

    def _oblique(self, body: _Body) -> bool:
        """Return whether a hinge is oblique in the axes of the body before."""
        if body.turn is None:
            return False
        matrix = self.bodies[body.before].frames[body.before]
        return self._coordinate(matrix, body.turn.before) is None

    def _coordinate(self, matrix: Matrix, direction: np.ndarray) -> tuple[int, float] | None:
        """Return the axis and sign of a direction after multiplication by a matrix, or None."""
        g = self.graph
        components = [
            g.sum([(n, c) for n, c in zip(row, direction, strict=True)]) for row in matrix
        ]
        numbers = [g.value(n) for n in components]
        if None in numbers:
            values = signatures(g, [*components, g.const(-1.0)])
            numbers = [{0: 0.0, 1: 1.0, values[3]: -1.0}.get(value) for value in values[:3]]
        return None if None in numbers else _axis(np.array(numbers, dtype=float))

    # -- axes by numbers --------------------------------------------------------------------------

    def _by_numbers(self, body: _Body) -> bool:
        """Choose axes for a body whose frames are at numeric angles."""
        turn = body.turn
        assert turn is not None
        home, matrix_before = self.kinematics.frames.written_in(body.before)
        rotation = self._numbers(matrix_before)
        frames = {f: self._numbers(matrix) for f, matrix in body.frames.items()}
        if rotation is None or any(m is None for m in frames.values()):
            return False
        ahead = [
            matrix @ child.turn.before
            for child in sorted(body.hinged, key=lambda b: -b.weight)
            if child.turn is not None and (matrix := frames[child.before]) is not None
        ]
        ahead = [v for v in ahead if np.linalg.norm(np.cross(turn.own_axis, v)) > SAME_DIRECTION]
        bends, index, sign = _bends(rotation @ turn.before, _axis(turn.own_axis))
        for bend in bends:
            rotation = _snapped(bend @ rotation)
        rotation_to_axes = _own_axes(turn, rotation, index, sign, ahead)
        angle = _angle(
            rotation_to_axes @ turn.even @ rotation.T,
            rotation_to_axes @ turn.odd @ rotation.T,
            index,
        )
        if angle is None:
            return False
        for bend in bends:
            home = self._fixed(home, self._nodes(bend), body)
        circle = _circle(self.graph, [(turn.angle, angle[0])], angle[1])
        self._turn_about(body, home, index, circle, sign, self._nodes(rotation_to_axes))
        return True

    # -- axes of the user -----------------------------------------------------------------------

    def _by_symbols(self, body: _Body) -> bool:
        """Choose the axes of one of the frames of the body."""
        g, turn = self.graph, body.turn
        assert turn is not None
        axis = _axis(turn.before)
        if axis is None or axis != _axis(turn.own_axis):
            return False
        index, sign = axis
        hinge_angle = _angle(turn.even, turn.odd, index)
        if hinge_angle is None:
            return False
        home, matrix_before = self.kinematics.frames.written_in(body.before)
        angle_before = self._angle_of(matrix_before, index)
        tried = []
        for number, matrix in enumerate(map(transposed, body.frames.values())):
            angle = self._angle_of(matrix, index)
            if angle is not None:
                tried.append((self._score(body, matrix), -number, matrix, angle))
        _, _, rotation_to_axes, angle = max(tried, key=lambda candidate: candidate[:2])
        if angle_before is None:
            home, angle_before = self._fixed(home, transposed(matrix_before), body), g.zero
        terms = [(turn.angle, hinge_angle[0]), (angle, 1.0), (angle_before, -1.0)]
        self._turn_about(
            body, home, index, _circle(g, terms, hinge_angle[1]), sign, rotation_to_axes
        )
        return True

    def _score(self, body: _Body, rotation_to_axes: Matrix) -> int:
        """Count the hinges that lie along an axis."""
        return sum(
            self._coordinate(self._product(rotation_to_axes, body.frames[h.before]), h.turn.before)
            is not None
            for h in body.hinged
            if h.turn is not None
        )

    def _angle_of(self, matrix: Matrix, index: int) -> int | None:
        """Return the angle of a constant rotation about an axis; None for other matrices."""
        g = self.graph
        if matrix == self.unit:
            return g.zero
        j, m = (index + 1) % 3, (index + 2) % 3
        (_, c), (sign, s) = g.scaled(matrix[j][j]), g.scaled(matrix[j][m])
        if (g.ops[c], g.ops[s]) != ("cos", "sin") or g.args[c] != g.args[s]:
            return None
        terms = [(g.args[c][0], sign)]
        return g.sum(terms) if matrix == axis_rotation(g, index, *_circle(g, terms, 0.0)) else None

    # -- results ---------------------------------------------------------------------

    def _turn_about(
        self,
        body: _Body,
        home: AnyFrame,
        index: int,
        circle: tuple[int, int],
        sign: float,
        rotation_to_axes: Matrix,
    ) -> None:
        k, g = self.kinematics, self.graph
        axes = (
            body.root
            if rotation_to_axes == self.unit
            else Axes(f"{body.root} in line with its hinge")
        )
        spin = [g.zero] * 3
        spin[index] = g.sum([(body.speed, sign)])
        depth = k.tree.frame_depth[body.root]
        k.frames.insert(axes, home, axis_rotation(g, index, *circle), spin, depth)
        self._write(body, axes, rotation_to_axes)

    def _fixed(self, home: AnyFrame, matrix: Matrix, body: _Body) -> AnyFrame:
        """Return axes that are fixed relative to others."""
        if matrix == self.unit:
            return home
        k = self.kinematics
        axes = Axes(f"{body.root} before it turns")
        k.frames.insert(axes, home, matrix, None, k.tree.frame_depth[body.root])
        return axes

    def _write(self, body: _Body, axes: AnyFrame, rotation_to_axes: Matrix) -> None:
        for frame, matrix in body.frames.items():
            product = self._product(rotation_to_axes, matrix)
            self.kinematics.frames.write(frame, axes, None if product == self.unit else product)

    # -- matrices ---------------------------------------------------------------------------------

    def _numbers(self, matrix: Matrix) -> np.ndarray | None:
        values = [self.graph.value(n) for n in flat(matrix)]
        return None if None in values else np.array(values, dtype=float).reshape(3, 3)

    def _nodes(self, numbers: np.ndarray) -> Matrix:
        return [[self.graph.const(x) for x in row] for row in numbers]

    def _product(self, a: Matrix, b: Matrix) -> Matrix:
        """Return a product of rotations with exact zeros and ones."""
        g = self.graph
        product = transposed([self.kinematics.product(a, column) for column in transposed(b)])
        numbers = self._numbers(product)
        if numbers is not None:
            return self._nodes(_snapped(numbers))
        exact_values = {0: g.zero, 1: g.one, signatures(g, [g.const(-1.0)])[0]: g.const(-1.0)}
        nodes = flat(product)
        return in_rows(
            [exact_values.get(v, n) for v, n in zip(signatures(g, nodes), nodes, strict=True)]
        )


def _snapped(numbers: np.ndarray) -> np.ndarray:
    """Round numbers that are 0, 1 or -1 up to rounding."""
    near = np.rint(numbers)
    return np.where(np.abs(numbers - near) < ROUNDED, near, numbers)


def _axis(direction: np.ndarray) -> tuple[int, float] | None:
    """Return the axis that a unit vector lies along, and its sign; None if it is oblique."""
    snapped = _snapped(direction)
    (used,) = np.nonzero(snapped)
    return (int(used[0]), float(snapped[used[0]])) if len(used) == 1 else None


def _turn(graph: Graph, matrix: Matrix) -> _HingeRotation | None:
    """Return a matrix as a rotation about a numeric axis; None if it is not one."""
    parts = {"const": np.zeros((3, 3)), "cos": np.zeros((3, 3)), "sin": np.zeros((3, 3))}
    angles = set()
    for i, row in enumerate(matrix):
        for j, entry in enumerate(row):
            for node, c in linear_terms(graph, entry).items():
                op = graph.ops[node]
                if op not in parts:
                    return None
                if op != "const":
                    angles.add(graph.args[node][0])
                parts[op][i, j] = c
    if len(angles) != 1:
        return None
    constant_part = parts["const"]
    before = constant_part[np.abs(constant_part).sum(axis=1).argmax()]
    before = _snapped(before / max(np.linalg.norm(before), np.finfo(float).tiny))
    own_axis = _snapped(constant_part @ before)
    if before[np.abs(before).argmax()] < 0.0:
        before, own_axis = -before, -own_axis
    for a in (0.3, 1.7):
        rotation = np.outer(own_axis, before) + parts["cos"] * np.cos(a) + parts["sin"] * np.sin(a)
        wrong = (
            np.abs(rotation @ rotation.T - _UNIT).max()
            + np.abs(constant_part - np.outer(own_axis, before)).max()
        )
        if wrong > SAME_DIRECTION or np.linalg.det(rotation) < 0.0:
            return None
    return _HingeRotation(angles.pop(), parts["cos"], parts["sin"], before, own_axis)


def _bends(
    direction: np.ndarray, preferred: tuple[int, float] | None
) -> tuple[list[np.ndarray], int, float]:
    """Return plane rotations that align a direction with an axis, and the axis and sign."""
    target = 2 if preferred is None else preferred[0]
    rotations: list[np.ndarray] = []
    while (axis := _axis(direction)) is None:
        (zeros,) = np.nonzero(_snapped(direction) == 0.0)
        normal = int(zeros[0]) if len(zeros) else target
        j, m = (normal + 1) % 3, (normal + 2) % 3
        if m == target:
            j, m = m, j
        size = np.hypot(direction[j], direction[m])
        bend = np.eye(3)
        bend[j, j] = bend[m, m] = direction[j] / size
        bend[j, m], bend[m, j] = direction[m] / size, -direction[m] / size
        direction = _snapped(bend @ direction)
        rotations.append(bend)
    return rotations, *axis


def _own_axes(
    turn: _HingeRotation, rotation: np.ndarray, index: int, sign: float, ahead: list[np.ndarray]
) -> np.ndarray:
    """Return the matrix from components in a body's frame to those in its axes."""
    if (
        _axis(turn.own_axis) == (index, sign)
        and np.count_nonzero(_snapped(sum(ahead[:1], _ZERO))) < 3
    ):
        return _UNIT
    if not ahead:
        # Parallel to the axes before at zero angle.
        return _snapped(rotation @ (np.outer(turn.own_axis, turn.before) + turn.even).T)
    normal = np.cross(turn.own_axis, ahead[0])
    # The normal of nearly parallel axes is inaccurate: remove its component along the axis.
    normal /= np.linalg.norm(normal)
    normal -= turn.own_axis * (turn.own_axis @ normal)
    rows = np.zeros((3, 3))
    rows[index], rows[(index + 1) % 3] = sign * turn.own_axis, normal / np.linalg.norm(normal)
    rows[(index + 2) % 3] = np.cross(rows[index], rows[(index + 1) % 3])
    return _snapped(rows)


def _angle(even: np.ndarray, odd: np.ndarray, index: int) -> tuple[float, float] | None:
    """Return s and b of a rotation about an axis by s a + b, where a is the angle; or None."""
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
    """Return the cosine and sine of a sum, with multiples of 90° removed from `start`."""
    quarters = round(start / (np.pi / 2))
    start -= quarters * np.pi / 2
    phi = graph.sum(terms, 0.0 if abs(start) < ROUNDED else start)
    c, s = graph.call("cos", phi), graph.call("sin", phi)
    for _ in range(quarters % 4):
        c, s = graph.neg(s), c
    return c, s
