"""The multi-body model of CommonRoad: a sprung mass, two axles and four wheels.

Each equation of Allen et al. 1992, (A1) to (A22), is one of a mass or an inertia along one axis:
the whole car's mass moves forward, its parts move to the side and up. Of the accelerations by the
yaw of the axes there are r v and r u, which are among the forces here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import GRAVITY
from pydy.vehicles.chassis import Chassis
from pydy.vehicles.commonroad.inputs import CarInputs
from pydy.vehicles.commonroad.suspension import Axle, SprungMass

if TYPE_CHECKING:
    from pydy._sympy_types import Body, Load

# Bodies, and the loads on them.
_Parts: TypeAlias = "tuple[list[Body], list[Load]]"


def multi_body_car(inputs: CarInputs, speed: float) -> System:
    """Return the model MB."""
    a, b, m_s, g = sm.symbols("a b m_s g")
    u, delta = me.dynamicsymbols("u delta")
    chassis = Chassis(sm.Symbol("m"), sm.Symbol("I"), u)
    body = SprungMass(chassis)
    load_per_length = m_s * g / (2 * (a + b))
    axles = [
        Axle(body, "f", a, delta, load_per_length * b),
        Axle(body, "r", -b, sm.Integer(0), load_per_length * a),
    ]
    masses = [
        _whole_car(body, axles),
        _sprung_mass(body, axles),
        *(_unsprung_mass(axle) for axle in axles),
        _wheels(inputs, body, axles),
    ]
    corners = [corner for axle in axles for corner in axle.corners]
    spins = [corner.wheel.spin for corner in corners]
    rates = {
        delta: inputs.steering_rate(),
        body.phi: body.p,
        body.theta: body.q,
        body.z: body.w,
        **{q: rate for axle in axles for q, rate in axle.rates.items()},
    }
    of_body = [u, chassis.v, chassis.r, body.p, body.q, body.w]
    of_axles = [speed for axle in axles for speed in (axle.p, axle.v, axle.w)]
    definition = Definition(
        chassis.N,
        [*chassis.coordinates, *rates],
        [*of_body, *of_axles, *spins],
        bodies=[part for bodies, _ in masses for part in bodies],
        loads=[load for _, loads in masses for load in loads],
        kinematic_equations=[
            *chassis.kinematic_equations,
            *(q.diff() - rate for q, rate in rates.items()),
        ],
    )
    outputs = {"speed": sm.sqrt(u**2 + chassis.v**2), "beta": sm.atan(chassis.v / u)}
    for corner in corners:
        outputs |= corner.outputs()
    p = inputs.values
    start = {u: speed, **dict.fromkeys(spins, speed / p["R"])}
    for axle, opposite in zip(axles, "ba", strict=True):
        share = p[opposite] / (p["a"] + p["b"])
        load = (share * p["m_s"] + p[f"m_u{axle.end}"]) * GRAVITY
        start[axle.z] = load / (2 * p["K_zt"])
    return inputs.system(definition, sorted(p.keys() - {"h_cg", "C"}), start, outputs)


def _whole_car(body: SprungMass, axles: list[Axle]) -> _Parts:
    """Return what moves forward, (A1)."""
    chassis, mass = body.chassis, body.chassis.body.mass
    ahead = chassis.B.x
    force = sm.Add(*(axle.along for axle in axles)) + mass * chassis.r * chassis.v
    point = _moving(chassis, "car", chassis.u * ahead)
    return [me.Particle("car", point, mass)], [(point, force * ahead)]


def _sprung_mass(body: SprungMass, axles: list[Axle]) -> _Parts:
    """Return what moves to the side, (A3), and down, (A5), yaws and rolls, (A2) and (A4).

    Pitch is an equation of its own, (A6); a product of inertia couples the other two angles.
    """
    chassis = body.chassis
    B = chassis.B
    mass, g, I_x, I_y, I_xz, I_z = sm.symbols("m_s g I_x I_y I_xz I")
    springs = sm.Add(*(axle.spring for axle in axles))
    joints = sm.Add(*(axle.joint for axle in axles))
    across = joints * body.cos + springs * body.sin - mass * chassis.r * chassis.u
    down = mass * g - springs * body.cos + joints * body.sin
    roll = sm.Add(*(axle.spring_moment + axle.joint_moment for axle in axles))
    yaw = sm.Add(*(axle.yaw_moment for axle in axles))
    along = sm.Add(*(axle.along for axle in axles))
    pitch = sm.Add(*(axle.forward * axle.spring for axle in axles))
    pitch += along * (body.height - body.z)

    point = _moving(chassis, "sprung_mass", chassis.v * B.y + body.w * B.z)
    rolling = _turning(chassis, "S", body.p * B.x + chassis.r * B.z)
    pitching = _turning(chassis, "P", body.q * B.y)
    inertia = me.inertia(B, I_x, 0, I_z, izx=-I_xz), point
    bodies = [
        me.RigidBody("sprung_mass", point, rolling, mass, inertia),
        me.RigidBody("pitch", point, pitching, 0, (me.inertia(B, 0, I_y, 0), point)),
    ]
    loads = [
        (point, across * B.y + down * B.z),
        (rolling, roll * B.x + yaw * B.z),
        (pitching, pitch * B.y),
    ]
    return bodies, loads


def _unsprung_mass(axle: Axle) -> _Parts:
    """Return an axle that rolls, (A17), and moves down and to the side, (A18) and (A19)."""
    body = axle.body
    chassis, R = body.chassis, body.radius
    B = chassis.B
    g, compliance = sm.symbols("g K_lt")
    across = axle.across - axle.joint * body.cos - axle.spring * body.sin
    across -= axle.mass * chassis.r * chassis.u
    load = sm.Add(*(corner.Fz for corner in axle.corners))
    down = axle.mass * g - load - axle.joint * body.sin + axle.spring * body.cos
    roll = -axle.spring_moment - axle.joint * axle.lever - axle.across * (R - axle.z)
    sin, half = sm.sin(axle.phi), axle.track / 2 * sm.cos(axle.phi)
    for corner in axle.corners:
        roll += corner.Fz * (R * sin - corner.side * half - compliance * corner.Fy)

    name = f"axle_{axle.end}"
    point = _moving(chassis, name, axle.v * B.y + axle.w * B.z)
    frame = _turning(chassis, f"U_{axle.end}", axle.p * B.x)
    inertia = me.inertia(B, axle.inertia, 0, 0), point
    bodies = [me.RigidBody(name, point, frame, axle.mass, inertia)]
    return bodies, [(point, across * B.y + down * B.z), (frame, roll * B.x)]


def _wheels(inputs: CarInputs, body: SprungMass, axles: list[Axle]) -> _Parts:
    """Return the wheels, which the drive and the brakes turn, (A55)."""
    front_drive, front_brake = sm.symbols("T_se T_sb")
    drive, brake = inputs.torques(body.chassis.u, body.radius)
    shares = (front_drive, front_brake), (1 - front_drive, 1 - front_brake)
    bodies: list[Body] = []
    loads: list[Load] = []
    for axle, (driven, braked) in zip(axles, shares, strict=True):
        for corner in axle.corners:
            wheel = corner.wheel
            torque = (driven * drive - braked * brake) / 2 - wheel.radius * corner.Fx
            bodies.append(wheel.body)
            loads.append((wheel.body.frame, _not_backward(wheel.spin, torque) * wheel.axle))
    return bodies, loads


def _not_backward(spin: sm.Expr, torque: sm.Expr) -> sm.Expr:
    """Return a torque that lets a wheel spin forward only.

    The source has no torque at all on a wheel that has stopped. Here its brake holds it as long as
    the road's force is smaller.
    """
    forward = sm.Max(torque, 0, evaluate=False)
    return sm.Piecewise((forward, spin < 0), (torque, True), evaluate=False)


def _moving(chassis: Chassis, name: str, velocity: me.Vector) -> me.Point:
    """Return a point with the velocity of a mass, of which an equation has a part only."""
    point = chassis.point(name, 0)
    point.set_vel(chassis.N, velocity)
    return point


def _turning(chassis: Chassis, name: str, rate: me.Vector) -> me.ReferenceFrame:
    """Return a frame with the angular velocity of a body, whose angles are small."""
    frame = me.ReferenceFrame(name)
    frame.orient_axis(chassis.B, chassis.B.x, 0)
    frame.set_ang_vel(chassis.N, rate)
    return frame
