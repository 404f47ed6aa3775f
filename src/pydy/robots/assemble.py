"""A tree of links as bodies, loads and kinematics, with symbols for its numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._names import untaken
from pydy.mechanics import Definition
from pydy.robots.tree import Joint, Link, Motor, Tendon, Tie, Tree


class Place(NamedTuple):
    """Where a link is: its axes and its origin."""

    frame: Any
    point: Any


class JointSymbols(NamedTuple):
    """The symbols of a joint.

    The coordinates of a free joint are its place x, y, z in the axes of the world and a quaternion,
    scalar part first; its speeds are the velocity in the axes of the world and the angular velocity
    in the axes of the link. A ball joint has the quaternion and the angular velocity alone. The
    coordinate of a joint that mimics another is an expression.
    """

    coordinates: tuple[Any, ...]
    speeds: tuple[Any, ...]
    limits: tuple[float, float] | None = None
    effort: float | None = None


class TendonSymbols(NamedTuple):
    """The length of a tendon, a sum of coordinates, and its rate, the same sum of speeds."""

    length: Any
    rate: Any
    limits: tuple[float, float] | None = None


class _Step(NamedTuple):
    """From one frame of a chain to the next: ``x = place + turn · x_next``."""

    place: Any
    turn: Any


class _Axis(NamedTuple):
    """A hinge or slide between two bodies: its frames or points, and its speed."""

    kind: str
    vector: Any
    inner: Place
    outer: Place
    coordinate: Any
    speed: Any
    reference: float  # the coordinate in the pose that the file shows


class Assembly:
    """The bodies, loads and kinematics of a tree of links; `symbolic` masses, lengths and the like.

    Where a `friction_speed` is given, dry friction f acts as ``-f tanh(u / friction_speed)``.
    """

    def __init__(self, tree: Tree, symbolic: bool, friction_speed: float | None) -> None:
        self.tree, self.symbolic = tree, symbolic
        self.world, self.origin = me.ReferenceFrame("N"), me.Point("O")
        self.origin.set_vel(self.world, 0)
        self.values: dict[Any, float] = {}
        self.joints: dict[str, JointSymbols] = {}
        self.tendons: dict[str, TendonSymbols] = {}
        self.actuators: dict[str, Any] = {}
        self.input_ranges: dict[str, tuple[float, float]] = {}
        self.places = [Place(self.world, self.origin)]  # the world's, then those of the links
        self._taken: set[str] = {"t"}
        self._bodies: list[Any] = []
        self._loads: list[Any] = []
        # From the parent's place to that of each link, in the order of `places`, and the parents.
        self._steps: list[list[_Step]] = [[]]
        self._parents: list[int | None] = [None]
        self._axes: dict[str, _Axis] = {}
        self._shares: dict[str, list[tuple[Any, _Axis]]] = {}  # of tendons: coefficients and joints
        self._creep = None if friction_speed is None else self._number("creep", "", friction_speed)
        self._name_joints([joint for link in tree.links for joint in link.joints])
        self._gravity = [
            self._number("g", "" if np.count_nonzero(tree.gravity) == 1 else axis, size, sign)
            for axis, size, sign in zip(
                "xyz", abs(tree.gravity), np.sign(tree.gravity), strict=True
            )
        ]
        for link in tree.links:
            self._add_link(link)
        for tendon in tree.tendons:
            self._add_tendon(tendon)
        for motor in tree.motors:
            self._add_motor(motor)
        self.start = self._start()
        self.definition = self._definition()

    @property
    def frames(self) -> dict[str, Place]:
        """The places of the world and of the links by name."""
        names = ["world", *(link.name for link in self.tree.links)]
        return dict(zip(names, self.places, strict=True))

    # -- names and numbers -------------------------------------------------------------------------

    def _name(self, prefix: str, name: str) -> str:
        """Return a name that nothing else has, of letters, digits and underscores."""
        clean = re.sub(r"\W+", "_", name).strip("_")
        wanted = untaken(f"{prefix}_{clean}" if prefix and clean else prefix or clean, self._taken)
        self._taken.add(wanted)
        return wanted

    def _number(self, prefix: str, name: str, value: float, factor: float = 1.0) -> Any:
        """Return a symbol with this value times a factor, or the number; zero stays zero."""
        if not value or not factor:
            return sm.S.Zero
        if not self.symbolic:
            return _exact(value * factor)
        symbol = sm.Symbol(self._name(prefix, name))
        self.values[symbol] = float(value)
        return _exact(factor) * symbol

    def _vector(self, prefix: str, name: str, values: np.ndarray) -> list[Any]:
        return [self._number(f"{prefix}{a}", name, v) for a, v in zip("xyz", values, strict=True)]

    def _name_joints(self, joints: Sequence[Joint]) -> None:
        """Give each joint its coordinates and speeds; joints that mimic others come last."""
        t, waiting = me.dynamicsymbols._t, [j for j in joints if j.mimics is not None]
        for joint in joints:
            if joint.mimics is not None:
                continue
            turning = joint.kind in ("ball", "free")
            places = ("x", "y", "z") if joint.kind == "free" else ()
            ends = (*places, "e0", "e1", "e2", "e3") if turning else ("",)
            rates = (*(f"v{a}" for a in places), "wx", "wy", "wz") if turning else ("",)
            self.joints[joint.name] = JointSymbols(
                tuple(sm.Function(self._name("q", f"{joint.name}_{e}"))(t) for e in ends),
                tuple(sm.Function(self._name("u", f"{joint.name}_{e}"))(t) for e in rates),
                joint.limits,
                joint.effort,
            )
        for joint in _masters_first(waiting):
            assert joint.mimics is not None
            master, factor, constant = joint.mimics
            (q,), (u,) = self.joints[master][:2]
            ratio = self._number("ratio", joint.name, abs(factor), float(np.sign(factor)))
            shift = self._number("offset", joint.name, abs(constant), float(np.sign(constant)))
            self.joints[joint.name] = JointSymbols(
                (ratio * q + shift,), (ratio * u,), joint.limits, joint.effort
            )

    def _start(self) -> dict[Any, float]:
        """Return the coordinates in the pose that the file shows."""
        found: dict[Any, float] = {}
        for link in self.tree.links:
            for joint in link.joints:
                if joint.mimics is not None:
                    continue
                symbols = self.joints[joint.name].coordinates
                given = self.tree.start.get(joint.name)
                if given is None:
                    given = np.zeros(len(symbols))
                    if joint.kind in ("ball", "free"):
                        given[-4] = 1.0
                found.update((q, float(v)) for q, v in zip(symbols, given, strict=True))
        return found

    # -- links -------------------------------------------------------------------------------------

    def _add_link(self, link: Link) -> None:
        frame, point = self.places[link.parent + 1]
        chain: list[_Step] = []
        self._steps.append(chain)
        free = [joint.kind for joint in link.joints] == ["free"]
        self._parents.append(0 if free else link.parent + 1)  # a free joint starts from the world
        if free:
            own = self._free(link.joints[0], chain)
        else:
            own = self._fixed(link, frame, point, chain)
            for k, joint in enumerate(link.joints):
                last = k == len(link.joints) - 1
                own = self._joint(joint, own, link.name if last else joint.name, chain)
        self.places.append(own)
        if link.mass or link.inertia.any():
            self._add_body(link, own)

    def _fixed(self, link: Link, frame: Any, point: Any, chain: list[_Step]) -> Place:
        """Return where a link is as long as its joints do not move."""
        place = self._vector("p", link.name, link.place)
        turn = sm.Matrix(3, 3, lambda i, j: _exact(float(link.turn[i, j])))
        if (link.turn != np.eye(3)).any():
            fixed = _new_frame(self._name("at", link.name))
            fixed.orient_explicit(frame, turn)
        else:
            fixed = frame
        chain.append(_Step(sm.Matrix(place), turn))
        if any(place):
            point = point.locatenew(self._name("at", f"{link.name}_o"), _in(frame, place))
        return Place(fixed, point)

    def _free(self, joint: Joint, chain: list[_Step]) -> Place:
        coordinates, speeds, *_ = self.joints[joint.name]
        own = _new_frame(self._name("", joint.name))
        own.orient_quaternion(self.world, coordinates[3:])
        own.set_ang_vel(self.world, _in(own, speeds[3:]))
        place = _in(self.world, coordinates[:3])
        point = self.origin.locatenew(self._name("", f"{joint.name}_o"), place)
        chain.append(_Step(sm.Matrix(coordinates[:3]), own.dcm(self.world).T))
        found = Place(own, point)
        if joint.armature:
            size = self._number("armature", joint.name, joint.armature)
            for axis, q in zip("xyz", coordinates[:3], strict=True):
                self._add_slider(f"{joint.name}, {axis}", size, q)
            self._add_rotor(joint, size, coordinates[3:], speeds[3:])
        if drag := self._drag(joint, speeds):
            self._loads.append((point, _in(self.world, drag[:3])))
            self._loads.append((own, _in(own, drag[3:])))
        return found

    def _joint(self, joint: Joint, inner: Place, name: str, chain: list[_Step]) -> Place:
        coordinates, speeds, *_ = self.joints[joint.name]
        frame, point = inner
        anchor = [_exact(v) for v in joint.anchor]
        if self.symbolic:
            anchor = self._vector("a", joint.name, joint.anchor)
        if joint.kind == "slide":
            axis = [_exact(v) for v in joint.axis]
            move = coordinates[0] - _exact(joint.reference)
            vector = _in(frame, axis)
            outer = Place(frame, point.locatenew(self._name("", f"{name}_o"), move * vector))
            chain.append(_Step(sm.Matrix(axis) * move, sm.eye(3)))
        else:
            own = _new_frame(self._name("", name))
            if joint.kind == "ball":
                own.orient_quaternion(frame, coordinates)
                own.set_ang_vel(frame, _in(own, speeds))
                vector = None
            else:
                vector = _in(frame, [_exact(v) for v in joint.axis])
                own.orient_axis(frame, vector, coordinates[0] - _exact(joint.reference))
                own.set_ang_vel(frame, speeds[0] * vector)
            turn, about = own.dcm(frame).T, sm.Matrix(anchor)
            chain.append(_Step(about - turn * about if any(anchor) else sm.zeros(3, 1), turn))
            if any(anchor):
                hinge = point.locatenew(self._name("at", joint.name), _in(frame, anchor))
                point = hinge.locatenew(self._name("", f"{name}_o"), -_in(own, anchor))
            outer = Place(own, point)
        if joint.kind == "ball":
            self._resist_ball(joint, inner, outer)
        else:
            made = _Axis(
                joint.kind, vector, inner, outer, coordinates[0], speeds[0], joint.reference
            )
            self._axes[joint.name] = made
            self._resist(joint, made)
        return outer

    def _add_body(self, link: Link, own: Place) -> None:
        mass = self._number("m", link.name, link.mass)
        centre = self._vector("c", link.name, link.centre)
        point = me.Point(self._name("", f"{link.name}_centre"))
        parts = [
            self._number(f"I{a}", link.name, abs(link.inertia[i, j]), np.sign(link.inertia[i, j]))
            for a, i, j in (
                *(("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2)),
                *(("xy", 0, 1), ("yz", 1, 2), ("xz", 0, 2)),
            )
        ]
        if any(parts):
            inertia = (_inertia(own.frame, *parts), point)
            body = me.RigidBody(link.name, point, own.frame, mass, inertia)
        else:
            body = me.Particle(link.name, point, mass)
        # After the body is made: SymPy's class looks for a path from the mass centre to itself, in
        # a time that grows faster than the number of connected points.
        point.set_pos(own.point, _in(own.frame, centre))
        self._bodies.append(body)
        self._weigh(point, _exact(1.0 - link.lightened) * mass)

    # -- forces along joints -----------------------------------------------------------------------

    def _push(self, axis: _Axis, force: Any) -> None:
        """Let a force act along a joint, and its reaction on the body within."""
        if not force:
            return
        if axis.kind == "hinge":
            self._loads += [(axis.outer.frame, force * axis.vector)]
            self._loads += [(axis.inner.frame, -force * axis.vector)]
        else:
            self._loads += [(axis.outer.point, force * axis.vector)]
            self._loads += [(axis.inner.point, -force * axis.vector)]

    def _resist(self, joint: Joint, axis: _Axis) -> None:
        """Add a hinge's or slide's own loads: spring, damper, friction, rotor."""
        q, u, force = axis.coordinate, axis.speed, sm.S.Zero
        if joint.stiffness:
            stretch = q - _exact(joint.relaxed)
            force -= self._number("stiffness", joint.name, joint.stiffness) * stretch
        force += sum(self._drag(joint, [u]))
        self._push(axis, force)
        if joint.armature:
            size = self._number("armature", joint.name, joint.armature)
            self._add_slider(joint.name, size, q)

    def _add_tendon(self, tendon: Tendon) -> None:
        """Add a tendon's own loads; it pulls at each joint with the coefficient times its force."""
        self._shares[tendon.name] = shares = [
            (self._factor("coef", f"{tendon.name}_{joint}", coefficient), self._axes[joint])
            for joint, coefficient in tendon.shares
        ]
        length = sm.Add(*(c * axis.coordinate for c, axis in shares))
        rate = sm.Add(*(c * axis.speed for c, axis in shares))
        self.tendons[tendon.name] = TendonSymbols(length, rate, tendon.limits)
        force = sum(self._drag(tendon, [rate]), sm.S.Zero)
        if tendon.stiffness:
            low, high = (_exact(value) for value in tendon.relaxed)
            stretch = length - low
            if low != high:  # slack in between
                stretch = sm.Max(length - high, 0) + sm.Min(length - low, 0)
            force -= self._number("stiffness", tendon.name, tendon.stiffness) * stretch
        self._pull(tendon.name, force)
        if tendon.armature:
            size = self._number("armature", tendon.name, tendon.armature)
            self._add_slider(f"the tendon {tendon.name}", size, length)

    def _pull(self, tendon: str, force: Any) -> None:
        for coefficient, axis in self._shares[tendon]:
            self._push(axis, coefficient * force)

    def _factor(self, prefix: str, name: str, value: float) -> Any:
        """Return a number as `_number` does, but 1 and −1 as such."""
        sign = float(np.sign(value))
        return _exact(value) if abs(value) == 1.0 else self._number(prefix, name, abs(value), sign)

    def _drag(self, joint: Joint | Tendon, speeds: Sequence[Any]) -> list[Any]:
        """Return damping and dry friction along each axis of a joint, nothing if it has neither."""
        if not joint.damping and not joint.friction:
            return []
        size = self._number("damping", joint.name, joint.damping)
        found = [-size * u for u in speeds]
        if joint.friction and self._creep is None:
            kind = "joint" if isinstance(joint, Joint) else "tendon"
            self.tree.left_out.append(
                f"the dry friction of the {kind} '{joint.name}' (give `friction_speed` to have it)"
            )
        elif joint.friction:
            size = self._number("friction", joint.name, joint.friction)
            found = [
                f - size * sm.tanh(u / self._creep) for f, u in zip(found, speeds, strict=True)
            ]
        return found if any(found) else []

    def _resist_ball(self, joint: Joint, inner: Place, outer: Place) -> None:
        coordinates, speeds, *_ = self.joints[joint.name]
        if drag := self._drag(joint, speeds):
            torque = _in(outer.frame, drag)
            self._loads += [(outer.frame, torque), (inner.frame, -torque)]
        if joint.armature:
            size = self._number("armature", joint.name, joint.armature)
            self._add_rotor(joint, size, coordinates, speeds)

    def _add_slider(self, name: str, size: Any, q: Any) -> None:
        """Add a particle that moves along an axis of the world as a coordinate does.

        It has the kinetic energy of the rotor, and adds its inertia to the coordinate's entry of
        the mass matrix. On a level axis its weight does no work, and gravity is what all masses
        have in common.
        """
        level = [e for e, pull in zip(self.world, self._gravity, strict=True) if not pull]
        way = q * (level or [self.world.x])[0]
        point = self.origin.locatenew(self._name("rotor", name), way)
        self._bodies.append(me.Particle(f"armature of {name}", point, size))
        if level:
            self._weigh(point, size)

    def _weigh(self, point: Any, mass: Any) -> None:
        if mass and any(self._gravity):
            self._loads.append((point, _in(self.world, [mass * g for g in self._gravity])))

    def _add_rotor(self, joint: Joint, size: Any, turn: Any, spin: Any) -> None:
        """Add a ball in the world that turns as the joint does."""
        frame = _new_frame(self._name("rotor", joint.name))
        frame.orient_quaternion(self.world, turn)
        frame.set_ang_vel(self.world, _in(frame, spin))
        inertia = (me.inertia(frame, size, size, size), self.origin)
        name = f"armature of {joint.name}, turning"
        self._bodies.append(me.RigidBody(name, self.origin, frame, 0, inertia))

    def _add_motor(self, motor: Motor) -> None:
        if motor.joint is not None:
            axis = self._axes[motor.joint]
            coordinate, speed = axis.coordinate, axis.speed
        else:
            assert motor.tendon is not None
            coordinate, speed, _ = self.tendons[motor.tendon]
        name = self._name("f" if motor.name == motor.joint else "", motor.name)
        signal = self.actuators[motor.name] = me.dynamicsymbols(name)
        if motor.input_range is not None:
            self.input_ranges[motor.name] = motor.input_range
        parts = (
            (motor.gain, "gain", signal),
            (motor.constant, "bias", sm.S.One),
            (-motor.stiffness, "servo_stiffness", coordinate),
            (-motor.damping, "servo_damping", speed),
        )
        force = sm.Add(*(self._factor(prefix, motor.name, v) * what for v, prefix, what in parts))
        if motor.tendon is not None:
            self._pull(motor.tendon, force)
        else:
            self._push(axis, force)

    # -- equations ---------------------------------------------------------------------------------

    def _kinematic(self, joint: Joint) -> Iterator[Any]:
        t, half = me.dynamicsymbols._t, sm.Rational(1, 2)
        coordinates, speeds, *_ = self.joints[joint.name]
        if joint.kind in ("hinge", "slide"):
            yield coordinates[0].diff(t) - speeds[0]
            return
        for q, v in zip(coordinates[:-4], speeds[:-3], strict=True):
            yield q.diff(t) - v
        e, w = coordinates[-4:], speeds[-3:]
        rates = (
            -half * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]),
            half * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]),
            half * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]),
            half * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]),
        )
        for q, rate in zip(e, rates, strict=True):
            yield q.diff(t) - rate

    def _definition(self) -> Definition:
        own = [j for link in self.tree.links for j in link.joints if j.mimics is None]
        rows = [row for tie in self.tree.ties for row in self._rows(tie)]
        for joint in own:
            if joint.kind in ("ball", "free"):  # a start that is no rotation is told, and mended
                turn = self.joints[joint.name].coordinates[-4:]
                rows.append(sm.Add(*(e**2 for e in turn)) - 1)
        known: set[Any] = set()
        for row in rows:
            known |= row.free_symbols | row.atoms(sm.core.function.AppliedUndef)
        near = {**self.values, **self.start}
        return Definition(
            self.world,
            [q for joint in own for q in self.joints[joint.name].coordinates],
            [u for joint in own for u in self.joints[joint.name].speeds],
            bodies=self._bodies,
            loads=self._loads,
            kinematic_equations=[e for joint in own for e in self._kinematic(joint)],
            holonomic_constraints=rows,
            configuration={key: value for key, value in near.items() if key in known},
            frames=self.frames,
            values=self.values,
        )

    def _rows(self, tie: Tie) -> Iterator[Any]:
        """Yield the residuals by which two links, or two coordinates, are tied together."""
        if tie.kind in ("joint", "tendon"):
            other = sm.S.Zero if tie.other is None else self._moved(tie.kind, tie.other)
            yield self._moved(tie.kind, tie.one) - sum(
                (_exact(c) * other**k for k, c in enumerate(tie.polynomial) if c), sm.S.Zero
            )
            return
        name = f"{self._link_name(tie.one)}_{self._link_name(tie.other)}"
        ends = [self._vector(f"tie{k}_", name, p) for k, p in enumerate(tie.places, 1)]
        chains = [self._chain(k) for k in (tie.one, tie.other)]
        above = _shared(*chains)
        chains = [chain[above:] for chain in chains]
        at = [_carried(chain, sm.Matrix(end)) for chain, end in zip(chains, ends, strict=True)]
        yield from at[0] - at[1]
        if tie.kind == "weld":
            # Each axis of the one is normal to the next axis of the other.
            axes = [
                _turned(chains[0], sm.Matrix([_exact(float(v)) for v in a])) for a in tie.turn.T
            ]
            others = [_turned(chains[1], sm.eye(3)[:, k]) for k in range(3)]
            for a, b in ((0, 1), (1, 2), (2, 0)):
                yield axes[a].dot(others[b])

    def _moved(self, kind: str, name: str) -> Any:
        """Return how far a joint or tendon has moved from the pose that the file shows."""
        shares = self._shares[name] if kind == "tendon" else [(sm.S.One, self._axes[name])]
        return sm.Add(*(c * (axis.coordinate - _exact(axis.reference)) for c, axis in shares))

    def _link_name(self, k: int) -> str:
        return "world" if k < 0 else self.tree.links[k].name

    def _chain(self, link: int) -> list[_Step]:
        """Return the steps from the world to a link."""
        place: int | None = link + 1
        steps: list[_Step] = []
        while place is not None:
            steps += reversed(self._steps[place])
            place = self._parents[place]
        return steps[::-1]


def _shared(one: Sequence[_Step], other: Sequence[_Step]) -> int:
    """Return how many steps from the world two chains have in common."""
    pairs = zip(one, other, strict=False)
    return next((k for k, (a, b) in enumerate(pairs) if a is not b), min(len(one), len(other)))


def _new_frame(name: str) -> Any:
    """Return a frame that knows its cosines with itself.

    SymPy looks for a path to a frame, itself too, in a time that grows faster than the number of
    connected frames, and keeps what it found: look while the frame is alone.
    """
    frame = me.ReferenceFrame(name)
    frame.dcm(frame)
    return frame


def _inertia(frame: Any, xx: Any, yy: Any, zz: Any, xy: Any, yz: Any, xz: Any) -> Any:
    """Return what `me.inertia` does, made at once, in a fraction of the time."""
    moments = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    axes = tuple(frame)
    parts = [(moments[i][j], axes[i], axes[j]) for i in range(3) for j in range(3)]
    return me.Dyadic([part for part in parts if part[0] != 0])


def _masters_first(mimics: Sequence[Joint]) -> list[Joint]:
    """Return joints that mimic others in the order given, but each after the one it mimics."""
    waiting = {joint.name: joint for joint in mimics}
    order: list[Joint] = []
    for joint in mimics:
        path: list[Joint] = []
        name: str | None = joint.name
        while name in waiting:
            path.append(waiting.pop(name))
            name = path[-1].mimics[0] if path[-1].mimics else None
        order += reversed(path)
    return order


def _exact(value: float) -> Any:
    """Return a number for SymPy: whole ones as such, which lets terms vanish."""
    return sm.Integer(int(value)) if float(value).is_integer() else sm.Float(float(value))


def _in(frame: Any, components: Sequence[Any]) -> Any:
    # Made at once: the products and sums of SymPy's vectors take four times as long.
    return me.Vector([(sm.ImmutableMatrix(3, 1, [*components]), frame)])


def _carried(chain: Sequence[_Step], place: Any) -> Any:
    """Return a place in the frame that a chain starts from."""
    for step in reversed(chain):
        place = step.place + step.turn * place
    return place


def _turned(chain: Sequence[_Step], vector: Any) -> Any:
    for step in reversed(chain):
        vector = step.turn * vector
    return vector
