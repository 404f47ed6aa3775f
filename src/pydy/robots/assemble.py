"""Converts a tree of links into bodies, loads and kinematics, with symbols for its numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._errors import warn_user
from pydy._names import unused_name
from pydy._rank import ROUNDED
from pydy.mechanics import Definition
from pydy.robots.tree import EqualityConstraint, Link, Motor, RobotJoint, Tendon, Tree

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, Body, Load, TimeFunction


class Place(NamedTuple):
    """The frame of a link: its axes and its origin."""

    frame: me.ReferenceFrame
    point: me.Point


class JointSymbols(NamedTuple):
    """The symbols of a joint.

    The coordinates of a free joint are its position x, y, z in the axes of the world and a
    quaternion, scalar part first; its speeds are the velocity in the axes of the world and the
    angular velocity in the axes of the link. A ball joint has only the quaternion and the angular
    velocity. The coordinate of a joint that mimics another is an expression.
    """

    coordinates: tuple[sm.Expr, ...]
    speeds: tuple[sm.Expr, ...]
    limits: tuple[float, float] | None = None
    effort: float | None = None


class TendonSymbols(NamedTuple):
    """The length of a tendon, a sum of coordinates, and its rate, the same sum of speeds."""

    length: sm.Expr
    rate: sm.Expr
    limits: tuple[float, float] | None = None


class _Step(NamedTuple):
    """From one frame of a chain to the next: ``x = offset + rotation · x_next``."""

    offset: sm.MatrixBase
    rotation: sm.MatrixBase


class _Axis(NamedTuple):
    """A hinge or slide between two bodies: its frames or points, and its speed."""

    kind: str
    vector: me.Vector
    inner: Place
    outer: Place
    coordinate: sm.Expr
    speed: sm.Expr
    reference: float  # the coordinate in the file's pose


class RobotAssembly:
    """The bodies, loads and kinematics of a tree of links.

    If `symbolic`, masses, lengths and other numbers become symbols. With a `friction_speed`, dry
    friction f acts as ``-f tanh(u / friction_speed)``.
    """

    def __init__(self, tree: Tree, symbolic: bool, friction_speed: float | None) -> None:
        self.tree, self.symbolic = tree, symbolic
        self.world, self.origin = me.ReferenceFrame("N"), me.Point("O")
        self.origin.set_vel(self.world, 0)
        self.values: dict[sm.Symbol, float] = {}
        self.joints: dict[str, JointSymbols] = {}
        self.tendons: dict[str, TendonSymbols] = {}
        self.actuators: dict[str, TimeFunction] = {}
        self.input_ranges: dict[str, tuple[float, float]] = {}
        self.link_frames = [Place(self.world, self.origin)]  # of the world, then of the links
        self._used_names: set[str] = {"t"}
        self._bodies: list[Body] = []
        self._loads: list[Load] = []
        self._energies: list[sm.Expr] = []  # potential energies of springs and actuators
        # Steps from the parent's frame to that of each link, in the order of `link_frames`.
        self._steps: list[list[_Step]] = [[]]
        self._parents: list[int | None] = [None]
        self._axes: dict[str, _Axis] = {}
        self._shares: dict[
            str, list[tuple[sm.Expr, _Axis]]
        ] = {}  # of tendons: coefficients and joints
        self._friction_speed = (
            None if friction_speed is None else self._number("creep", "", friction_speed)
        )
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
        """The frames of the world and of the links by name."""
        names = ["world", *(link.name for link in self.tree.links)]
        return dict(zip(names, self.link_frames, strict=True))

    # -- names and numbers -------------------------------------------------------------------------

    def _name(self, prefix: str, name: str) -> str:
        """Return a unique name of letters, digits and underscores."""
        clean = re.sub(r"\W+", "_", name).strip("_")
        unique = unused_name(
            f"{prefix}_{clean}" if prefix and clean else prefix or clean, self._used_names
        )
        self._used_names.add(unique)
        return unique

    def _number(self, prefix: str, name: str, value: float, factor: float = 1.0) -> sm.Expr:
        """Return a symbol for this value, times a factor, or the number; zero stays zero."""
        if not value or not factor:
            return sm.S.Zero
        if not self.symbolic:
            return _exact(value * factor)
        symbol = sm.Symbol(self._name(prefix, name))
        self.values[symbol] = float(value)
        return _exact(factor) * symbol

    def _vector(self, prefix: str, name: str, values: np.ndarray) -> list[sm.Expr]:
        return [self._number(f"{prefix}{a}", name, v) for a, v in zip("xyz", values, strict=True)]

    def _name_joints(self, joints: Sequence[RobotJoint]) -> None:
        """Create the coordinates and speeds of each joint; joints that mimic others come last."""
        t, waiting = me.dynamicsymbols._t, [j for j in joints if j.mimics is not None]
        for joint in joints:
            if joint.mimics is not None:
                continue
            turning = joint.kind in ("ball", "free")
            positions = ("x", "y", "z") if joint.kind == "free" else ()
            ends = (*positions, "e0", "e1", "e2", "e3") if turning else ("",)
            rates = (*(f"v{a}" for a in positions), "wx", "wy", "wz") if turning else ("",)
            self.joints[joint.name] = JointSymbols(
                tuple(sm.Function(self._name("q", f"{joint.name}_{e}"))(t) for e in ends),
                tuple(sm.Function(self._name("u", f"{joint.name}_{e}"))(t) for e in rates),
                joint.limits,
                joint.effort,
            )
        for joint in _mimicked_first(waiting):
            assert joint.mimics is not None
            master, factor, constant = joint.mimics
            (q,), (u,) = self.joints[master][:2]
            ratio = self._number("ratio", joint.name, abs(factor), float(np.sign(factor)))
            shift = self._number("offset", joint.name, abs(constant), float(np.sign(constant)))
            self.joints[joint.name] = JointSymbols(
                (ratio * q + shift,), (ratio * u,), joint.limits, joint.effort
            )

    def _start(self) -> dict[TimeFunction, float]:
        """Return the coordinates in the file's pose."""
        coordinates: dict[TimeFunction, float] = {}
        for link in self.tree.links:
            for joint in link.joints:
                if joint.mimics is not None:
                    continue
                symbols = self.joints[joint.name].coordinates
                values = self.tree.start.get(joint.name)
                if values is None:
                    values = np.zeros(len(symbols))
                    if joint.kind in ("ball", "free"):
                        values[-4] = 1.0
                coordinates.update((q, float(v)) for q, v in zip(symbols, values, strict=True))
        return coordinates

    # -- links -------------------------------------------------------------------------------------

    def _add_link(self, link: Link) -> None:
        frame, point = self.link_frames[link.parent + 1]
        chain: list[_Step] = []
        self._steps.append(chain)
        free = [joint.kind for joint in link.joints] == ["free"]
        self._parents.append(0 if free else link.parent + 1)  # a free joint starts from the world
        if free:
            link_frame = self._free(link.joints[0], chain)
        else:
            link_frame = self._fixed(link, frame, point, chain)
            for k, joint in enumerate(link.joints):
                last = k == len(link.joints) - 1
                link_frame = self._joint(
                    joint, link_frame, link.name if last else joint.name, chain
                )
        self.link_frames.append(link_frame)
        if link.mass or link.inertia.any():
            self._add_body(link, link_frame)

    def _fixed(
        self, link: Link, frame: me.ReferenceFrame, point: me.Point, chain: list[_Step]
    ) -> Place:
        """Return the frame of a link before the motion of its joints."""
        offset = self._vector("p", link.name, link.origin)
        rotation = sm.Matrix(3, 3, lambda i, j: _exact(float(link.rotation[i, j])))
        if (link.rotation != np.eye(3)).any():
            fixed = _new_frame(self._name("at", link.name))
            fixed.orient_explicit(frame, rotation)
        else:
            fixed = frame
        chain.append(_Step(sm.Matrix(offset), rotation))
        if any(offset):
            point = point.locatenew(self._name("at", f"{link.name}_o"), _vector_in(frame, offset))
        return Place(fixed, point)

    def _free(self, joint: RobotJoint, chain: list[_Step]) -> Place:
        coordinates, speeds, *_ = self.joints[joint.name]
        frame = _new_frame(self._name("", joint.name))
        frame.orient_quaternion(self.world, coordinates[3:])
        frame.set_ang_vel(self.world, _vector_in(frame, speeds[3:]))
        offset = _vector_in(self.world, coordinates[:3])
        point = self.origin.locatenew(self._name("", f"{joint.name}_o"), offset)
        chain.append(_Step(sm.Matrix(coordinates[:3]), frame.dcm(self.world).T))
        link_frame = Place(frame, point)
        if joint.armature:
            size = self._number("armature", joint.name, joint.armature)
            for axis, q in zip("xyz", coordinates[:3], strict=True):
                self._add_slider(f"{joint.name}, {axis}", size, q)
            self._add_rotor(joint, size, coordinates[3:], speeds[3:])
        if drag := self._damping_and_friction(joint, speeds):
            self._loads.append((point, _vector_in(self.world, drag[:3])))
            self._loads.append((frame, _vector_in(frame, drag[3:])))
        return link_frame

    def _joint(self, joint: RobotJoint, inner: Place, name: str, chain: list[_Step]) -> Place:
        coordinates, speeds, *_ = self.joints[joint.name]
        frame, point = inner
        anchor = [_exact(v) for v in joint.anchor]
        if self.symbolic:
            anchor = self._vector("a", joint.name, joint.anchor)
        if joint.kind == "slide":
            axis = [_exact(v) for v in joint.axis]
            move = coordinates[0] - _exact(joint.reference)
            vector = _vector_in(frame, axis)
            outer = Place(frame, point.locatenew(self._name("", f"{name}_o"), move * vector))
            chain.append(_Step(sm.Matrix(axis) * move, sm.eye(3)))
        else:
            rotating = _new_frame(self._name("", name))
            if joint.kind == "ball":
                rotating.orient_quaternion(frame, coordinates)
                rotating.set_ang_vel(frame, _vector_in(rotating, speeds))
                vector = None
            else:
                vector = _vector_in(frame, [_exact(v) for v in joint.axis])
                rotating.orient_axis(frame, vector, coordinates[0] - _exact(joint.reference))
                rotating.set_ang_vel(frame, speeds[0] * vector)
            rotation, anchor_vector = rotating.dcm(frame).T, sm.Matrix(anchor)
            chain.append(
                _Step(
                    anchor_vector - rotation * anchor_vector if any(anchor) else sm.zeros(3, 1),
                    rotation,
                )
            )
            if any(anchor):
                hinge = point.locatenew(self._name("at", joint.name), _vector_in(frame, anchor))
                point = hinge.locatenew(self._name("", f"{name}_o"), -_vector_in(rotating, anchor))
            outer = Place(rotating, point)
        if joint.kind == "ball":
            self._add_ball_loads(joint, inner, outer)
        else:
            joint_axis = _Axis(
                joint.kind, vector, inner, outer, coordinates[0], speeds[0], joint.reference
            )
            self._axes[joint.name] = joint_axis
            self._add_passive_loads(joint, joint_axis)
        return outer

    def _add_body(self, link: Link, link_frame: Place) -> None:
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
            inertia = (_inertia(link_frame.frame, *parts), point)
            body = me.RigidBody(link.name, point, link_frame.frame, mass, inertia)
        else:
            body = me.Particle(link.name, point, mass)
        # Only after the body is created: SymPy's class searches for a path from the mass centre to
        # itself, in a time that grows faster than the number of connected points.
        point.set_pos(link_frame.point, _vector_in(link_frame.frame, centre))
        self._bodies.append(body)
        self._add_weight(point, _exact(1.0 - link.gravity_compensation) * mass)

    # -- forces along joints -----------------------------------------------------------------------

    def _add_joint_force(self, axis: _Axis, force: sm.Expr) -> None:
        """Add a force along a joint, and its reaction on the inner body."""
        if not force:
            return
        if axis.kind == "hinge":
            self._loads += [(axis.outer.frame, force * axis.vector)]
            self._loads += [(axis.inner.frame, -force * axis.vector)]
        else:
            self._loads += [(axis.outer.point, force * axis.vector)]
            self._loads += [(axis.inner.point, -force * axis.vector)]

    def _add_passive_loads(self, joint: RobotJoint, axis: _Axis) -> None:
        """Add the passive loads of a hinge or slide: spring, damper, friction, rotor."""
        q, u, force = axis.coordinate, axis.speed, sm.S.Zero
        if joint.stiffness:
            stretch = q - _exact(joint.relaxed)
            stiffness = self._number("stiffness", joint.name, joint.stiffness)
            force -= stiffness * stretch
            self._energies.append(stiffness * stretch**2 / 2)
        force += sum(self._damping_and_friction(joint, [u]))
        self._add_joint_force(axis, force)
        if joint.armature:
            size = self._number("armature", joint.name, joint.armature)
            self._add_slider(joint.name, size, q)

    def _add_tendon(self, tendon: Tendon) -> None:
        """Add the passive loads of a tendon; at each joint it pulls with coefficient × force."""
        self._shares[tendon.name] = shares = [
            (self._factor("coef", f"{tendon.name}_{joint}", coefficient), self._axes[joint])
            for joint, coefficient in tendon.shares
        ]
        length = sm.Add(*(c * axis.coordinate for c, axis in shares))
        rate = sm.Add(*(c * axis.speed for c, axis in shares))
        self.tendons[tendon.name] = TendonSymbols(length, rate, tendon.limits)
        force = sum(self._damping_and_friction(tendon, [rate]), sm.S.Zero)
        if tendon.stiffness:
            low, high = (_exact(value) for value in tendon.relaxed)
            stretch = length - low
            if low != high:  # slack in between
                stretch = sm.Max(length - high, 0) + sm.Min(length - low, 0)
            stiffness = self._number("stiffness", tendon.name, tendon.stiffness)
            force -= stiffness * stretch
            self._energies.append(stiffness * stretch**2 / 2)
        self._add_tendon_force(tendon.name, force)
        if tendon.armature:
            size = self._number("armature", tendon.name, tendon.armature)
            self._add_slider(f"the tendon {tendon.name}", size, length)

    def _add_tendon_force(self, tendon: str, force: sm.Expr) -> None:
        for coefficient, axis in self._shares[tendon]:
            self._add_joint_force(axis, coefficient * force)

    def _factor(self, prefix: str, name: str, value: float) -> sm.Expr:
        """Return a number as `_number` does, but 1 and −1 without a symbol."""
        sign = float(np.sign(value))
        return _exact(value) if abs(value) == 1.0 else self._number(prefix, name, abs(value), sign)

    def _damping_and_friction(
        self, joint: RobotJoint | Tendon, speeds: Sequence[sm.Expr]
    ) -> list[sm.Expr]:
        """Return damping and dry friction along each axis of a joint; an empty list if none."""
        if not joint.damping and not joint.friction:
            return []
        size = self._number("damping", joint.name, joint.damping)
        forces = [-size * u for u in speeds]
        if joint.friction and self._friction_speed is None:
            kind = "joint" if isinstance(joint, RobotJoint) else "tendon"
            self.tree.left_out.append(
                f"the dry friction of the {kind} '{joint.name}' (give `friction_speed` to have it)"
            )
        elif joint.friction:
            size = self._number("friction", joint.name, joint.friction)
            forces = [
                f - size * sm.tanh(u / self._friction_speed)
                for f, u in zip(forces, speeds, strict=True)
            ]
        return forces if any(forces) else []

    def _add_ball_loads(self, joint: RobotJoint, inner: Place, outer: Place) -> None:
        coordinates, speeds, *_ = self.joints[joint.name]
        if drag := self._damping_and_friction(joint, speeds):
            torque = _vector_in(outer.frame, drag)
            self._loads += [(outer.frame, torque), (inner.frame, -torque)]
        if joint.armature:
            size = self._number("armature", joint.name, joint.armature)
            self._add_rotor(joint, size, coordinates, speeds)

    def _add_slider(self, name: str, size: sm.Expr, q: sm.Expr) -> None:
        """Add a particle that moves along an axis of the world, with a coordinate as its position.

        It has the kinetic energy of the rotor, and adds the armature to the coordinate's entry of
        the mass matrix. On a horizontal axis its weight does no work; it has a weight because
        gravity is recognised as a load that is proportional to all masses.
        """
        level = [e for e, pull in zip(self.world, self._gravity, strict=True) if not pull]
        offset = q * (level or [self.world.x])[0]
        point = self.origin.locatenew(self._name("rotor", name), offset)
        self._bodies.append(me.Particle(f"armature of {name}", point, size))
        if level:
            self._add_weight(point, size)

    def _add_weight(self, point: me.Point, mass: sm.Expr) -> None:
        if mass and any(self._gravity):
            self._loads.append((point, _vector_in(self.world, [mass * g for g in self._gravity])))

    def _add_rotor(
        self,
        joint: RobotJoint,
        size: sm.Expr,
        quaternion: Sequence[sm.Expr],
        spin: Sequence[sm.Expr],
    ) -> None:
        """Add a ball at the world's origin that rotates with the joint."""
        frame = _new_frame(self._name("rotor", joint.name))
        frame.orient_quaternion(self.world, quaternion)
        frame.set_ang_vel(self.world, _vector_in(frame, spin))
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
        gain, bias, slope, drag = (
            self._factor(prefix, motor.name, value)
            for value, prefix in (
                (motor.gain, "gain"),
                (motor.constant, "bias"),
                (-motor.stiffness, "servo_stiffness"),
                (-motor.damping, "servo_damping"),
            )
        )
        force = gain * signal + bias + slope * coordinate + drag * speed
        self._energies.append(-bias * coordinate - slope * coordinate**2 / 2)
        if motor.tendon is not None:
            self._add_tendon_force(motor.tendon, force)
        else:
            self._add_joint_force(axis, force)

    # -- equations ---------------------------------------------------------------------------------

    def _kinematic(self, joint: RobotJoint) -> Iterator[sm.Expr]:
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
        joints = [j for link in self.tree.links for j in link.joints if j.mimics is None]
        rows = [row for equality in self.tree.equalities for row in self._rows(equality)]
        for joint in joints:
            if joint.kind in (
                "ball",
                "free",
            ):  # a start that is no unit quaternion is reported and corrected
                quaternion = self.joints[joint.name].coordinates[-4:]
                rows.append(sm.Add(*(e**2 for e in quaternion)) - 1)
        symbols: set[AnySymbol] = set()
        for row in rows:
            symbols |= row.free_symbols | row.atoms(sm.core.function.AppliedUndef)
        near = {**self.values, **self.start}
        return Definition(
            self.world,
            [q for joint in joints for q in self.joints[joint.name].coordinates],
            [u for joint in joints for u in self.joints[joint.name].speeds],
            bodies=self._bodies,
            loads=self._loads,
            kinematic_equations=[e for joint in joints for e in self._kinematic(joint)],
            holonomic_constraints=rows,
            configuration={key: value for key, value in near.items() if key in symbols},
            frames=self.frames,
            values=self.values,
            potential_energy=sm.Add(*self._energies),
        )

    def _rows(self, equality: EqualityConstraint) -> Iterator[sm.Expr]:
        """Yield the residuals of an equality constraint of two links, joints or tendons."""
        if equality.kind in ("joint", "tendon"):
            second = (
                sm.S.Zero
                if equality.second is None
                else self._displacement(equality.kind, equality.second)
            )
            yield self._displacement(equality.kind, equality.first) - sum(
                (_exact(c) * second**k for k, c in enumerate(equality.polynomial) if c), sm.S.Zero
            )
            return
        name = f"{self._link_name(equality.first)}_{self._link_name(equality.second)}"
        ends = [self._vector(f"tie{k}_", name, p) for k, p in enumerate(equality.points, 1)]
        chains = [self._chain(k) for k in (equality.first, equality.second)]
        above = _shared(*chains)
        chains = [chain[above:] for chain in chains]
        at = [
            _point_in_base(chain, sm.Matrix(end)) for chain, end in zip(chains, ends, strict=True)
        ]
        yield from at[0] - at[1]
        if equality.kind == "weld":
            # Each axis of the first frame is normal to the next axis of the second.
            axes = [
                _vector_in_base(chains[0], sm.Matrix([_exact(float(v)) for v in a]))
                for a in equality.rotation.T
            ]
            second_axes = [_vector_in_base(chains[1], sm.eye(3)[:, k]) for k in range(3)]
            self._check_weld(equality, axes, second_axes)
            for a, b in ((0, 1), (1, 2), (2, 0)):
                yield axes[a].dot(second_axes[b])

    def _check_weld(
        self,
        weld: EqualityConstraint,
        axes: Sequence[sm.MatrixBase],
        second_axes: Sequence[sm.MatrixBase],
    ) -> None:
        """Warn of a weld that is more than a right angle away in the file's pose.

        The products of axes that are constrained are zero again where the frames differ by a third
        of a turn or by half a turn.
        """
        near = {**self.values, **self.start}
        trace = sum(float(a.dot(b).xreplace(near)) for a, b in zip(axes, second_axes, strict=True))
        if trace < 1.0 - ROUNDED:  # 1 + 2 cos(angle)
            angle = np.degrees(np.arccos(max((trace - 1.0) / 2.0, -1.0)))
            warn_user(
                f"In the file's pose the weld of '{self._link_name(weld.first)}' and "
                f"'{self._link_name(weld.second)}' is {angle:.0f}° away from its orientation. "
                "Beyond 90° its constraints may be satisfied in another orientation: pass "
                "`initial_conditions` near the right one to `Robot.system`."
            )

    def _displacement(self, kind: str, name: str) -> sm.Expr:
        """Return the displacement of a joint or tendon from the file's pose."""
        shares = self._shares[name] if kind == "tendon" else [(sm.S.One, self._axes[name])]
        return sm.Add(*(c * (axis.coordinate - _exact(axis.reference)) for c, axis in shares))

    def _link_name(self, k: int) -> str:
        return "world" if k < 0 else self.tree.links[k].name

    def _chain(self, link: int) -> list[_Step]:
        """Return the steps from the world to a link."""
        index: int | None = link + 1
        steps: list[_Step] = []
        while index is not None:
            steps += reversed(self._steps[index])
            index = self._parents[index]
        return steps[::-1]


def _shared(first: Sequence[_Step], second: Sequence[_Step]) -> int:
    """Return the number of steps from the world that two chains have in common."""
    pairs = zip(first, second, strict=False)
    return next((k for k, (a, b) in enumerate(pairs) if a is not b), min(len(first), len(second)))


def _new_frame(name: str) -> me.ReferenceFrame:
    """Return a frame with its cached direction cosines to itself.

    SymPy searches for a path to a frame, even to itself, in a time that grows faster than the
    number of connected frames, and caches the result: search before the frame is connected.
    """
    frame = me.ReferenceFrame(name)
    frame.dcm(frame)
    return frame


def _inertia(
    frame: me.ReferenceFrame,
    xx: sm.Expr,
    yy: sm.Expr,
    zz: sm.Expr,
    xy: sm.Expr,
    yz: sm.Expr,
    xz: sm.Expr,
) -> me.Dyadic:
    """Return the result of `me.inertia`, constructed directly in a fraction of the time."""
    moments = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    axes = tuple(frame)
    parts = [(moments[i][j], axes[i], axes[j]) for i in range(3) for j in range(3)]
    return me.Dyadic([part for part in parts if part[0] != 0])


def _mimicked_first(mimics: Sequence[RobotJoint]) -> list[RobotJoint]:
    """Return joints that mimic others, each after the one that it mimics."""
    waiting = {joint.name: joint for joint in mimics}
    order: list[RobotJoint] = []
    for joint in mimics:
        path: list[RobotJoint] = []
        name: str | None = joint.name
        while name in waiting:
            path.append(waiting.pop(name))
            name = path[-1].mimics[0] if path[-1].mimics else None
        order += reversed(path)
    return order


def _exact(value: float) -> sm.Number:
    """Return a number for SymPy: integers are exact, so that terms can cancel."""
    return sm.Integer(int(value)) if float(value).is_integer() else sm.Float(float(value))


def _vector_in(frame: me.ReferenceFrame, components: Sequence[sm.Expr]) -> me.Vector:
    # Constructed directly: products and sums of SymPy's vectors take four times as long.
    return me.Vector([(sm.ImmutableMatrix(3, 1, [*components]), frame)])


def _point_in_base(chain: Sequence[_Step], point: sm.MatrixBase) -> sm.MatrixBase:
    """Return a point of a chain's last frame in its first frame."""
    for step in reversed(chain):
        point = step.offset + step.rotation * point
    return point


def _vector_in_base(chain: Sequence[_Step], vector: sm.MatrixBase) -> sm.MatrixBase:
    for step in reversed(chain):
        vector = step.rotation * vector
    return vector
