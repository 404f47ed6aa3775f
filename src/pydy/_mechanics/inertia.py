"""Contributions of bodies and loads to the equations, at the components of velocities.

A body contributes a quadratic form in the components of a velocity, m v·v or ω·I·ω, and a force on
them: the load, minus the inertia force at u' = 0, m a or I α + ω × I ω.

Bodies that are fixed in one frame form a composite body, with a mass m, a first moment h and an
inertia I about a point P that is fixed in the frame: constants, which are summed in the set-up
stage. With the frame's angular velocity and acceleration in U = [α] + [ω][ω], a mass at r from P
has the acceleration a + U r, so that

    force  m a + U h,        torque about P  h × a + Σ m r × U r.

A joint does not affect part of that inertia, which is transferred to the parent body: the mass at a
point P that both bodies share; for a rotation about an axis e through P, all inertia on the axis.
For a revolute joint this removes three of the ten parameters of every body (the base inertial
parameters: Khalil, Dombre, Modeling, Identification and Control of Robots, 2002, ch. 9). The
remaining inertia has no mass, and is not that of a real body; its sum with the parent is unchanged.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from sympy.physics.mechanics import Point

from pydy._graph import signatures
from pydy._mechanics.alignment import hinge_axis
from pydy._mechanics.components import flat, in_rows, transposed, unrounded
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.reader import is_rigid

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import Vector

    from pydy._mechanics.frame_tree import AnyFrame
    from pydy._sympy_types import Body

# A frame, and the point fixed in it that is the origin of a composite body.
_Key: TypeAlias = "tuple[AnyFrame, Point]"


@dataclass(frozen=True)
class Inertia:
    """The form v·I·v: components of a velocity, or of two, and a symmetric matrix of nodes."""

    velocity: Vec
    matrix: list[Vec]


@dataclass(frozen=True)
class Load:
    """A force on the components of a velocity."""

    velocity: Vec
    force: Vec


def points_of(kinematics: Kinematics) -> list[Point]:
    """Return the points whose motion the equations need, in the order in which SymPy asks."""
    body = kinematics.body
    return [location for location, _ in body.loads if isinstance(location, Point)] + [
        b.masscenter for b in body.bodies
    ]


def loads_and_inertias(kinematics: Kinematics) -> tuple[list[Inertia], list[Load]]:
    """Return the contributions of all bodies and loads."""
    return without_rest(kinematics, *contributions(kinematics, kinematics.body.bodies))


def contributions(
    kinematics: Kinematics, bodies: Iterable[Body]
) -> tuple[list[Inertia], list[Load]]:
    """Return the contributions of the given bodies, and of all loads."""
    inertias: list[Inertia] = []
    loads: list[Load] = []
    for body in bodies:
        for law in (newton, euler):
            terms = law(kinematics, body)
            if terms is not None:
                _, velocity, inertia, needed = terms
                inertias.append(Inertia(velocity, inertia))
                loads.append(Load(velocity, [kinematics.graph.neg(x) for x in needed]))
    for location, vector in kinematics.loads:
        home, v = kinematics.velocity_of(location)
        loads.append(Load(v, kinematics.vector(vector, home)))
    return inertias, loads


def without_rest(
    kinematics: Kinematics, inertias: list[Inertia], loads: list[Load]
) -> tuple[list[Inertia], list[Load]]:
    """Replace velocities that vanish identically by zero: forces there do no work."""
    nodes = [n for a in inertias for n in a.velocity] + [n for b in loads for n in b.velocity]
    values = signatures(kinematics.graph, nodes)
    vanishing = {n for n, value in zip(nodes, values, strict=True) if not value}

    def nonvanishing(v: Vec) -> Vec:
        return [kinematics.graph.zero if n in vanishing else n for n in v]

    return (
        [Inertia(nonvanishing(part.velocity), part.matrix) for part in inertias],
        [Load(nonvanishing(part.velocity), part.force) for part in loads],
    )


# Axes, a velocity in them, its inertia, and the inertia force with opposite sign.
_Law: TypeAlias = "tuple[AnyFrame, Vec, list[Vec], Vec]"


def newton(kinematics: Kinematics, body: Body) -> _Law | None:
    """Return the velocity of a mass centre, the mass, and the force m a + m' v."""
    g = kinematics.graph
    mass = kinematics.read(body.mass)
    if mass == g.zero:
        return None
    home, v, _ = kinematics.motion(body.masscenter)
    a = kinematics.acceleration(body.masscenter)
    (change,) = kinematics.dt([mass])
    needed = [g.add(g.mul(mass, x), g.mul(change, y)) for x, y in zip(a, v, strict=True)]
    return home, v, [[mass if i == j else g.zero for j in range(3)] for i in range(3)], needed


def euler(kinematics: Kinematics, body: Body) -> _Law | None:
    """Return a body's angular velocity and the torque I α + ω × I ω + I' ω, as `newton` does."""
    terms = tuple(body.central_inertia.args) if is_rigid(body) else ()
    if not terms:
        return None
    home, tensor, change = inertia_seen(kinematics, body.frame, terms)
    w, _ = kinematics.spin(body.frame, home)
    alpha = kinematics.angular_acceleration(body.frame, home)
    momentum = kinematics.product(tensor, w)
    needed = kinematics.plus(
        kinematics.product(tensor, alpha),
        kinematics.cross(w, momentum),
        kinematics.product(change, w),
    )
    return home, w, tensor, needed


def inertia_seen(
    kinematics: Kinematics, frame: AnyFrame, terms: tuple[tuple[sm.Expr, Vector, Vector], ...]
) -> tuple[AnyFrame, list[Vec], list[Vec]]:
    """Return the axes for a body's rotation, its inertia in them, and the rate of the inertia.

    These are the innermost axes in which the inertia is constant. The inertia of a wheel is
    constant in the axes of the fork, where its spin angle does not occur.
    """
    zero = kinematics.graph.zero
    no_change = [[zero] * 3 for _ in range(3)]
    written = {f for _, a, b in terms for vector in (a, b) for _, f in vector.args}
    frame = kinematics.frames.axes(frame)
    home = kinematics.frames.axes(written.pop()) if len(written) == 1 else frame
    tensor = kinematics.tensor(terms, home)
    change = [kinematics.dt(row) for row in tensor]
    if home is not frame:
        # If the axes rotate by w relative to the body, the inertia changes by w × I - I × w.
        w, body_spin = kinematics.spin(home)[0], kinematics.spin(frame, home)[0]
        relative = [kinematics.graph.sub(a, b) for a, b in zip(w, body_spin, strict=True)]
        rate = transposed([kinematics.cross(relative, row) for row in tensor])
        sums = map(kinematics.plus, rate, transposed(rate))
        change = [kinematics.plus(a, b) for a, b in zip(change, sums, strict=True)]
    if any(signatures(kinematics.graph, flat(change))):
        return home, tensor, change
    while home in kinematics.tree.frame_depth:
        if (parent := kinematics.frames.parent(home)) is None:
            break
        # In the parent's axes: R' I R, with the axes here as the rows of R.
        rotation = transposed(kinematics.frames.step(home))
        half = [kinematics.product(rotation, column) for column in transposed(tensor)]
        outer = [kinematics.product(rotation, row) for row in transposed(half)]
        if not kinematics.equal(flat(tensor), flat(outer)):
            break
        home = parent
    return home, tensor, no_change


@dataclass
class _CompositeBody:
    """Mass, first moment, second moments Σ m r rᵀ and inertia about a point, in a frame's axes.

    Inertia and second moments determine each other. Both are stored because each is a sum of terms
    of one sign: computing one from the other would lose the moment of a slender body about its axis
    in rounding errors.
    """

    mass: int
    first: Vec
    second: list[Vec]
    tensor: list[Vec]


def composite_contributions(
    kinematics: Kinematics,
) -> tuple[list[Inertia], list[Load], list[Inertia]]:
    """Return the contributions of composite bodies and loads, and the inertias of all bodies.

    The latter set the scale of the pivots. Composite bodies need vectors in the axes of bodies.
    """
    if kinematics.in_bodies:
        return _CompositeBodies(kinematics).contributions()
    inertias, loads = loads_and_inertias(kinematics)
    return inertias, loads, inertias


def weights_of(kinematics: Kinematics, fall: Vec) -> list[Load]:
    """Return the weights of all bodies in free fall with an acceleration in the inertial frame."""
    return _CompositeBodies(kinematics).weights(fall)


class _CompositeBodies:
    def __init__(self, kinematics: Kinematics) -> None:
        self.kinematics, self.graph = kinematics, kinematics.graph
        self.composites: dict[_Key, _CompositeBody] = {}
        self.inertias: list[Inertia] = []
        self.loads: list[Load] = []
        self.body_inertias: list[Inertia] = []

    def contributions(self) -> tuple[list[Inertia], list[Load], list[Inertia]]:
        k = self.kinematics
        separate = [body for body in k.body.bodies if not self._add_body(body)]
        inertias, loads = contributions(k, separate)
        self.body_inertias += inertias
        self.inertias += inertias
        self.loads += loads
        for (frame, point), composite in self.composites.items():
            self.body_inertias.append(self._inertia(frame, point, composite))
        self._transfer_all()
        for (frame, point), composite in self.composites.items():
            self._add_contributions(frame, point, composite)
        inertias, self.loads = without_rest(k, self.inertias, self.loads)
        return inertias, self.loads, without_rest(k, self.body_inertias, [])[0]

    def weights(self, fall: Vec) -> list[Load]:
        k, g, loads = self.kinematics, self.graph, []
        for body in k.body.bodies:
            if not self._add_body(body):
                home, v, _ = k.motion(body.masscenter)
                down, mass = k.expressed(fall, k.inertial, home), k.read(body.mass)
                loads.append(Load(v, [g.mul(mass, x) for x in down]))
        self._transfer_all()
        for (frame, point), composite in self.composites.items():
            down = k.expressed(fall, k.inertial, frame)
            loads.append(
                Load(k.motion_in(point, frame)[0], [g.mul(composite.mass, x) for x in down])
            )
            loads.append(Load(k.spin(frame)[0], k.cross(composite.first, down)))
        return loads

    # -- bodies -----------------------------------------------------------------------------------

    def _add_body(self, body: Body) -> bool:
        """Add a body to the composite body of its frame, unless it must stay separate."""
        k, g = self.kinematics, self.graph
        if not is_rigid(body) or body.frame is k.inertial:
            return False
        mass = k.read(body.mass)
        terms = tuple(body.central_inertia.args)
        frame = k.frames.axes(body.frame)
        home, tensor, change = inertia_seen(k, frame, terms)
        a = k.acceleration(body.masscenter)
        if (
            not all(g.constant[n] for n in (mass, *flat(tensor)))
            or any(n != g.zero for n in flat(change))
            or a is not k.motion(body.masscenter)[2]
            or k.angular_acceleration(body.frame, home) is not k.spin(frame, home)[1]
            or home is k.inertial
        ):
            return False
        if home is not frame and not self._separate_spin(frame, home, tensor):
            return False
        while k.frames.is_fixed(home):
            tensor, home = self._in_outer_axes(tensor, home), k.frames.parent(home)
        point, position = self._root(body.masscenter, home)
        composite = self._at(home, point)
        self._add(
            composite, _CompositeBody(mass, [g.zero] * 3, self._second(tensor), tensor), position
        )
        return True

    def _separate_spin(self, frame: AnyFrame, home: AnyFrame, tensor: list[Vec]) -> bool:
        """Separate the spin of a wheel from a body whose axes turn about one axis of `home`.

        Its `tensor`, in the axes of `home`, becomes that of a body without spin, in place. Return
        False if the body is not symmetric about that axis.
        """
        k, g = self.kinematics, self.graph
        spin, alpha = k.spin(frame, home)
        relative = [g.sub(a, b) for a, b in zip(spin, k.spin(home)[0], strict=True)]
        moved = [i for i in range(3) if relative[i] != g.zero]
        if len(moved) != 1:
            return False
        (i,) = moved
        j, m = (i + 1) % 3, (i + 2) % 3
        symmetric = tensor[j][j] == tensor[m][m]
        if not symmetric or any(
            tensor[r][c] != g.zero for r in range(3) for c in range(3) if r != c
        ):
            return False
        size = tensor[i][i]
        momentum = g.mul(size, spin[i])
        torque = [g.zero] * 3
        torque[i] = g.mul(size, alpha[i])
        torque[j] = g.mul(momentum, spin[m])
        torque[m] = g.neg(g.mul(momentum, spin[j]))
        matrix = [[g.zero] * 3 for _ in range(3)]
        matrix[i][i] = size
        part = Inertia(spin, matrix)
        self.inertias.append(part)
        self.body_inertias.append(part)
        self.loads.append(Load(spin, [g.neg(x) for x in torque]))
        tensor[i] = [g.zero] * 3
        return True

    def _root(self, point: Point, frame: AnyFrame) -> tuple[Point, Vec]:
        """Return the innermost point fixed in a frame together with a point, and the vector."""
        k, g = self.kinematics, self.graph
        position = [g.zero] * 3
        point = k.first_there(point)
        while (step := k.fixed_step(point)) is not None and step[1] is frame:
            point, position = k.first_there(step[0]), k.plus(position, step[2])
        return point, position

    def _at(self, frame: AnyFrame, point: Point) -> _CompositeBody:
        zero = self.graph.zero
        return self.composites.setdefault(
            (frame, point), _CompositeBody(zero, [zero] * 3, *_empty(zero))
        )

    def _second(self, tensor: list[Vec]) -> list[Vec]:
        """Return Σ m r rᵀ of an inertia: half its trace, minus the inertia."""
        g = self.graph
        trace = [(tensor[i][i], 0.5) for i in range(3)]
        return [
            [g.sum([*(trace if i == j else ()), (tensor[i][j], -1.0)]) for j in range(3)]
            for i in range(3)
        ]

    def _add(self, composite: _CompositeBody, part: _CompositeBody, position: Vec) -> None:
        """Add inertia whose origin is at `position`."""
        g, axes = self.graph, range(3)
        moved = [g.sum([(part.first[i], 1.0), (g.mul(part.mass, position[i]), 1.0)]) for i in axes]
        composite.second = [
            [
                g.add(
                    composite.second[i][j],
                    part.second[i][j],
                    g.mul(position[i], part.first[j]),
                    g.mul(moved[i], position[j]),
                )
                for j in axes
            ]
            for i in axes
        ]
        composite.tensor = [
            [
                g.add(
                    composite.tensor[i][j],
                    part.tensor[i][j],
                    self._steiner(part, moved, position, i, j),
                )
                for j in axes
            ]
            for i in axes
        ]
        composite.first = [g.add(a, b) for a, b in zip(composite.first, moved, strict=True)]
        composite.mass = g.add(composite.mass, part.mass)

    def _steiner(self, part: _CompositeBody, moved: Vec, position: Vec, i: int, j: int) -> int:
        """Return the parallel-axis term of an inertia whose origin is at `position`."""
        g = self.graph

        def moment(a: int, b: int) -> int:
            return g.add(g.mul(position[a], part.first[b]), g.mul(moved[a], position[b]))

        if i != j:
            return g.neg(moment(i, j))
        return g.add(*(moment(a, a) for a in range(3) if a != i))

    # -- joints -----------------------------------------------------------------------------------

    def _transfer_all(self) -> None:
        turns = self.kinematics.tree.frame_depth
        for key in sorted(self.composites, key=lambda key: -turns.get(key[0], 0)):
            self._transfer_to_parent(*key)

    def _transfer_to_parent(self, frame: AnyFrame, point: Point) -> None:
        """Move the inertia that a joint does not affect to the parent body."""
        k, g = self.kinematics, self.graph
        inner = before = k.frames.parent(frame) if frame in k.tree.frame_depth else None
        while k.frames.is_fixed(before):
            before = k.frames.parent(before)
        host = before
        if (before, point) in self.composites:
            origin, position = point, [g.zero] * 3
        elif before is not k.inertial or not k.at_rest(point, before):
            step = k.fixed_step(point)
            if step is None:
                return
            before = step[1]
            origin, position = self._root(point, before)
            if (before, origin) not in self.composites and not k.at_rest(origin, before):
                return
        else:
            origin = point
        target = self.composites.get((before, origin))
        composite, zero = self.composites[frame, point], g.zero
        part = _CompositeBody(composite.mass, [zero] * 3, *_empty(zero))
        composite.mass = zero
        axis = hinge_axis(k, frame, inner) if before is host else None
        if axis is not None:
            part.first[axis], composite.first[axis] = composite.first[axis], zero
            size = composite.second[axis][axis]
            part.second[axis][axis], composite.second[axis][axis] = size, zero
            for i in {0, 1, 2} - {axis}:
                part.tensor[i][i] = size
                composite.tensor[i][i] = g.sub(composite.tensor[i][i], size)
        while k.frames.is_fixed(inner) and axis is not None:
            part.second, part.tensor = (
                self._in_outer_axes(part.second, inner),
                self._in_outer_axes(part.tensor, inner),
            )
            part.first = unrounded(g, k.product(transposed(k.frames.step(inner)), part.first))
            inner = k.frames.parent(inner)
        if target is not None:
            self._add(target, part, position)

    def _in_outer_axes(self, tensor: list[Vec], axes: AnyFrame) -> list[Vec]:
        """Return a constant tensor in the axes in which `axes` are fixed."""
        k = self.kinematics
        turn = transposed(k.frames.step(axes))
        half = [k.product(turn, row) for row in tensor]
        rotated = [k.product(turn, row) for row in transposed(half)]
        return in_rows(unrounded(self.graph, flat(rotated)))

    # -- contributions ----------------------------------------------------------------------------

    def _inertia(self, frame: AnyFrame, point: Point, composite: _CompositeBody) -> Inertia:
        """Return the form in the velocity of the point and the angular velocity of the frame."""
        k, g, axes, zero = self.kinematics, self.graph, range(3), self.graph.zero
        v, _ = k.motion_in(point, frame)
        matrix = [[zero] * 6 for _ in range(6)]
        for i in axes:
            j, m = (i + 1) % 3, (i + 2) % 3
            matrix[i][i] = composite.mass
            for r, c, n in ((j, m, g.neg(composite.first[i])), (m, j, composite.first[i])):
                matrix[3 + r][c] = matrix[c][3 + r] = n
            matrix[3 + i][3:] = composite.tensor[i]
        return Inertia([*v, *k.spin(frame)[0]], matrix)

    def _add_contributions(self, frame: AnyFrame, point: Point, composite: _CompositeBody) -> None:
        k, g, axes = self.kinematics, self.graph, range(3)
        self.inertias.append(self._inertia(frame, point, composite))
        v, a = k.motion_in(point, frame)
        turning = k.turning(frame)
        force = [
            g.sum(
                [(g.mul(composite.mass, a[i]), -1.0)]
                + [(g.mul(turning[i][j], composite.first[j]), -1.0) for j in axes]
            )
            for i in axes
        ]
        torque = [g.neg(self._torque(turning, composite.second, i)) for i in axes]
        torque = k.plus(torque, k.cross(a, composite.first))
        self.loads.append(Load(v, force))
        self.loads.append(Load(k.spin(frame)[0], torque))

    def _torque(self, turning: Sequence[Vec], second: Sequence[Vec], i: int) -> int:
        """Return a component of Σ m r × U r."""
        g = self.graph
        j, m = (i + 1) % 3, (i + 2) % 3
        return g.sum(
            [
                (g.mul(second[i][j], turning[m][i]), 1.0),
                (g.mul(second[i][m], turning[j][i]), -1.0),
                (g.mul(second[j][j], turning[m][j]), 1.0),
                (g.mul(second[m][m], turning[j][m]), -1.0),
                (g.mul(second[j][m], g.sub(turning[m][m], turning[j][j])), 1.0),
            ]
        )


def _empty(zero: int) -> tuple[list[Vec], list[Vec]]:
    return [[zero] * 3 for _ in range(3)], [[zero] * 3 for _ in range(3)]
