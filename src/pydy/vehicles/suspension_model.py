"""The bodies, joints, loop constraints and loads of a suspension."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody, Vector

from pydy._checks import instance, shown, text
from pydy.vehicles.algebra import checked_quantity
from pydy.vehicles.forces import checked_parameters
from pydy.vehicles.hard_points import HardPoints, Hinge, orthogonal_to

if TYPE_CHECKING:
    from pydy._sympy_types import Expression, Load, TimeFunction


@dataclass(frozen=True, eq=False)
class SuspensionModel:
    """A suspension as the parts of a `pydy.mechanics.Definition`.

    Attributes
    ----------
    name : str
    coordinates, speeds : list of functions of time
        Each coordinate's derivative is the speed of the same index: the angle of the lower arm, of
        the upper one if it has a mass, three angles of the upright (about z, x, y), and the spin of
        the wheel. All are zero in the position of the hard points.
    holonomic_constraints : list of expressions
        They close the loops and leave one degree of freedom, besides the spin.
    bodies : list of RigidBody and Particle
        Upright, wheel, and arms that have masses.
    loads : list of pairs
        Of the spring and the damper, on both ends.
    wheel : RigidBody
        For `WheelContact`, with `axis`.
    axis : Vector
        Unit vector along the axle, to the left.
    upright, lower_arm : ReferenceFrame
    points : dict of names to Point
        The hard points where they are, with velocities: those of the body, of the lower arm, of the
        upright, and of an upper arm that has a mass.
    spring_length, spring_rate, spring_force : expression
        Length (m) of the spring, its time derivative, and the force (N) that pushes its ends apart.
    travel : expression
        Height of the wheel's center in the body (m), relative to that of the hard points.
    """

    name: str
    coordinates: list[TimeFunction]
    speeds: list[TimeFunction]
    holonomic_constraints: list[Expression]
    bodies: list[Any]
    loads: list[Load]
    wheel: RigidBody
    axis: Vector
    upright: ReferenceFrame
    lower_arm: ReferenceFrame
    points: dict[str, Point]
    spring_length: Expression
    spring_rate: Expression
    spring_force: Expression
    travel: Expression

    def __repr__(self) -> str:
        return (
            f"<SuspensionModel {self.name}: {len(self.bodies)} bodies, {len(self.coordinates)} "
            f"coordinates, {len(self.holonomic_constraints)} constraints>"
        )

    @property
    def kinematic_equations(self) -> list[Expression]:
        """Expressions that are zero: derivatives of the coordinates without the speeds."""
        return [q.diff() - u for q, u in zip(self.coordinates, self.speeds, strict=True)]

    @property
    def configuration(self) -> dict[TimeFunction, float]:
        """Zero for each coordinate: roughly how the suspension is assembled."""
        return dict.fromkeys(self.coordinates, 0.0)


def build(
    suspension: HardPoints,
    body: ReferenceFrame,
    origin: Point,
    frame: ReferenceFrame,
    *,
    name: str,
    upright: tuple[Any, Any],
    wheel: tuple[Any, Any],
    force: Callable[[Expression, Expression], Expression | float] | None,
    arm_masses: Any,
    rack: Any,
) -> SuspensionModel:
    """Return the model of a suspension in a body that moves."""
    instance(body, ReferenceFrame, "`body`")
    instance(origin, Point, "`origin`")
    instance(frame, ReferenceFrame, "`frame`")
    name = text(name, "`name`", empty=False)
    if "\0" in name:
        raise ValueError(f"`name` must be text without null characters, got {shown(name)}.")
    if not (force is None or callable(force)):
        raise TypeError(f"`force` must be a function or None, got {shown(force)}.")
    masses = _amounts(arm_masses, "arm_masses", 2)
    if "upper_outer" in suspension._point_names():
        with_upper_arm = masses[1] != 0
    elif masses[1] != 0:
        raise ValueError(
            f"`arm_masses[1]` must be 0, because a McPherson strut has no upper arm, got "
            f"{shown(masses[1])}."
        )
    else:
        with_upper_arm = False
    shift = sm.sympify(checked_quantity(rack, "`rack`", arrays=False))
    parts = _Parts(suspension, body, origin, frame, name)
    lower = parts.arm("lower", masses[0])
    upright_frame = parts.upright()
    outer = parts.components(parts.points["lower_outer"])
    rotation = np.array(body.dcm(upright_frame))
    constraints = suspension.closure(outer, rotation, shift)
    if with_upper_arm:
        parts.arm("upper", masses[1])
        apart = parts.components(parts.points["upper_outer"]) - suspension.moved(
            "upper_outer", outer, rotation
        )
        # The arm replaces the rods from its ends to the ball joint.
        constraints = [*apart, constraints[-1]]
    else:
        parts.on_upright(*({"upper_outer"} & set(suspension._point_names())))
    parts.on_upright("wheel_center", "tie_rod_outer")
    axis = parts.wheel(*upright, *wheel)
    carrier, moving, fixed = suspension.spring_ends
    if carrier == "lower_arm":
        parts.points[moving] = parts.fixed_in(lower, "lower_outer", moving)
    else:
        parts.on_upright(moving)
    parts.in_body(fixed)
    spring = _SpringOfSuspension.between(parts.points[moving], parts.points[fixed], frame)
    ends = np.linalg.norm(getattr(suspension, moving) - getattr(suspension, fixed))
    pushing = _force(force, float(ends) - spring.length, -spring.rate)
    loads = (
        []
        if force is None
        else [
            (parts.points[moving], pushing * spring.away),
            (parts.points[fixed], -pushing * spring.away),
        ]
    )
    height = parts.components(parts.points["wheel_center"])[2]
    return SuspensionModel(
        name=name,
        coordinates=parts.coordinates,
        speeds=parts.speeds,
        holonomic_constraints=[sm.sympify(row) for row in constraints],
        bodies=parts.bodies,
        loads=loads,
        wheel=parts.bodies[-1],
        axis=axis,
        upright=upright_frame,
        lower_arm=lower,
        points=parts.points,
        spring_length=spring.length,
        spring_rate=spring.rate,
        spring_force=pushing,
        travel=height - suspension.wheel_center[2],
    )


class _Parts:
    """What a suspension is assembled of, in the order of the joints."""

    def __init__(
        self,
        suspension: HardPoints,
        body: ReferenceFrame,
        origin: Point,
        frame: ReferenceFrame,
        name: str,
    ) -> None:
        self.hard, self.body, self.frame, self.name = suspension, body, frame, name
        self.origin = origin
        self.coordinates: list[TimeFunction] = []
        self.speeds: list[TimeFunction] = []
        self.bodies: list[Any] = []
        self.points: dict[str, Point] = {}
        self._components: dict[Point, np.ndarray] = {}

    def coordinate(self, kind: str) -> tuple[TimeFunction, TimeFunction]:
        """Return a new coordinate and its speed."""
        q, u = me.dynamicsymbols(f"{self.name}_{kind} {self.name}_{kind}_rate")
        self.coordinates.append(q)
        self.speeds.append(u)
        return q, u

    def in_body(self, name: str) -> Point:
        """Add a hard point that is fixed in the body."""
        return self._fixed(name, self.origin, self.body, getattr(self.hard, name))

    def on_upright(self, *names: str) -> None:
        """Add hard points that are fixed in the upright."""
        for name in names:
            arm = getattr(self.hard, name) - self.hard.lower_outer
            self._fixed(name, self.points["lower_outer"], self._upright, arm)

    def _fixed(self, name: str, start: Point, frame: ReferenceFrame, arm: np.ndarray) -> Point:
        point = start.locatenew(f"{self.name}_{name}", _vector(arm, frame))
        point.v2pt_theory(start, self.frame, frame)
        self.points[name] = point
        return point

    def arm(self, arm: str, mass: Any) -> ReferenceFrame:
        """Add an arm that turns in the body, and its outer point."""
        hinge = Hinge.of(self.hard, arm)
        q, u = self.coordinate(f"{arm}_arm")
        radius = np.linalg.norm(hinge.radius)
        rows = np.array([hinge.axis, hinge.radius / radius])
        # Frames at rest with x along the hinge and y along the arm keep the rotation simple.
        rest = ReferenceFrame(f"{self.name}_{arm}_rest")
        rest.orient_explicit(self.body, _matrix([*rows, np.cross(*rows)]).T)
        frame = ReferenceFrame(f"{self.name}_{arm}_arm")
        frame.orient_axis(rest, rest.x, q)
        frame.set_ang_vel(rest, u * rest.x)
        foot = self._fixed(f"{arm}_foot", self.origin, self.body, hinge.foot)
        outer = foot.locatenew(f"{self.name}_{arm}_outer", float(radius) * frame.y)
        outer.v2pt_theory(foot, self.frame, frame)
        self.points[f"{arm}_outer"] = outer
        if arm == "lower":
            self._lower_rest = rest
        self._set_components(outer, hinge, q)
        if mass != 0:
            self._add_plate(arm, mass, frame, rest, hinge)
        return frame

    def _set_components(self, outer: Point, hinge: Hinge, angle: TimeFunction) -> None:
        self._components[outer] = hinge.outer(sm.cos(angle), sm.sin(angle))

    def components(self, point: Point) -> np.ndarray:
        """Return the coordinates of a point in the body."""
        if point not in self._components:
            vector = point.pos_from(self.origin).to_matrix(self.body)
            self._components[point] = np.array(vector).ravel()
        return self._components[point]

    def fixed_in(self, frame: ReferenceFrame, joint: str, name: str) -> Point:
        """Return a hard point that is fixed in the lower arm."""
        apart = getattr(self.hard, name) - getattr(self.hard, joint)
        rest = np.array(self._lower_rest.dcm(self.body), float)
        return self._fixed(name, self.points[joint], frame, rest @ apart)

    def _add_plate(
        self, arm: str, mass: Any, frame: ReferenceFrame, rest: ReferenceFrame, hinge: Hinge
    ) -> None:
        """Add the mass of an arm: a thin triangular plate between its three points.

        A triangular plate has the mass center and the inertia of three equal particles in the
        middles of its sides.
        """
        turned = np.array(rest.dcm(self.body), float)
        corners = [
            turned @ (getattr(self.hard, f"{arm}_{end}") - hinge.foot)
            for end in ("front", "rear", "outer")
        ]
        centre = sum(corners) / 3
        matrix = np.zeros((3, 3))
        for k in range(3):
            middle = (corners[k] + corners[k - 1]) / 2 - centre
            matrix += (middle @ middle * np.eye(3) - np.outer(middle, middle)) / 3
        foot = self.points[f"{arm}_foot"]
        point = foot.locatenew(f"{self.name}_{arm}_center", _vector(centre, frame))
        point.v2pt_theory(foot, self.frame, frame)
        entries = [mass * float(matrix[i, j]) for i, j in _ENTRIES]
        inertia = (me.inertia(frame, *entries), point)
        self.bodies.append(RigidBody(f"{self.name}_{arm}_arm", point, frame, mass, inertia))

    def upright(self) -> ReferenceFrame:
        """Add the upright, which turns about the lower ball joint."""
        frame = ReferenceFrame(f"{self.name}_upright")
        pairs = [self.coordinate(kind) for kind in ("steer", "lean", "pitch")]
        frame.orient_body_fixed(self.body, [q for q, _ in pairs], "zxy")
        turning = frame.ang_vel_in(self.body)
        frame.set_ang_vel(self.body, turning.subs({q.diff(): u for q, u in pairs}))
        self._upright = frame
        return frame

    def wheel(self, mass: Any, inertia: Any, wheel_mass: Any, wheel_inertia: Any) -> Vector:
        """Add the masses of upright and wheel, and return the axle."""
        centre = self.points["wheel_center"]
        (weight,) = _amounts([mass], "upright_mass", None)
        moments = _amounts(inertia, "upright_inertia", 3)
        if weight != 0 or any(moment != 0 for moment in moments):
            frame = self._upright
            about = (me.inertia(frame, *moments), centre)
            self.bodies.append(RigidBody(f"{self.name}_upright", centre, frame, weight, about))
        axle = self.hard.axis
        hub = self._upright
        if axle[1] != 1.0:
            ahead, _above = orthogonal_to(axle)
            hub = ReferenceFrame(f"{self.name}_hub")
            hub.orient_explicit(self._upright, _matrix([ahead, axle, np.cross(ahead, axle)]).T)
        q, u = self.coordinate("spin")
        frame = ReferenceFrame(f"{self.name}_wheel")
        frame.orient_axis(hub, hub.y, q)
        frame.set_ang_vel(hub, u * hub.y)
        (weight,) = _amounts([wheel_mass], "wheel_mass", None)
        axial, diametral = _amounts(wheel_inertia, "wheel_inertia", 2)
        about = (me.inertia(hub, diametral, axial, diametral), centre)
        self.bodies.append(RigidBody(f"{self.name}_wheel", centre, frame, weight, about))
        axis: Vector = hub.y
        return axis


@dataclass(frozen=True)
class _SpringOfSuspension:
    """A line between two points: its length, the rate of it, and the direction to the first one."""

    length: Expression
    rate: Expression
    away: Vector

    @classmethod
    def between(cls, one: Point, other: Point, frame: ReferenceFrame) -> _SpringOfSuspension:
        apart = one.pos_from(other)
        length = sm.sqrt(apart.dot(apart))
        away = apart / length
        return cls(length, (one.vel(frame) - other.vel(frame)).dot(away), away)


_ENTRIES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))


def _vector(components: Any, frame: ReferenceFrame) -> Vector:
    return sum((float(c) * e for c, e in zip(components, frame, strict=True)), Vector(0))


def _matrix(rows: Any) -> sm.Matrix:
    return sm.Matrix(np.array(rows, float).tolist())


def _amounts(values: Any, name: str, count: int | None) -> list[Any]:
    """Return amounts that are not negative, numbers or expressions."""
    if count is not None and (not isinstance(values, (list, tuple)) or len(values) != count):
        raise TypeError(f"`{name}` must be {count} numbers or expressions, got {shown(values)}.")
    named = {name if count is None else f"{name}[{i}]": value for i, value in enumerate(values)}
    return list(checked_parameters(named, not_negative=tuple(named)).values())


def _force(
    law: Callable[[Expression, Expression], Expression | float] | None,
    deflection: Expression,
    rate: Expression,
) -> Expression:
    if law is None:
        return sm.S.Zero
    try:
        result = law(deflection, rate)
    except Exception as error:
        error.add_note("This was raised by `force(deflection, rate)`, called with expressions.")
        raise
    return sm.sympify(checked_quantity(result, "`force(deflection, rate)`", arrays=False))
