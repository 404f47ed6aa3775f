"""The single-track models of CommonRoad, with and without slip of the wheels."""

from __future__ import annotations

from typing import Any

import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.chassis import Chassis
from pydy.vehicles.commonroad.inputs import CarInputs
from pydy.vehicles.commonroad.tires import tire_forces

_CONSTANTS = ("m", "I", "a", "b", "h", "g", "a_max", "v_switch", "v_delta_max")


def _loads_of_axles(acceleration: sm.Expr) -> list[sm.Expr]:
    """Return the normal forces of the front and the rear axle."""
    m, a, b, h, g = sm.symbols("m a b h g")
    return [m * (g * b - acceleration * h) / (a + b), m * (g * a + acceleration * h) / (a + b)]


def linear_car(inputs: CarInputs, speed: float) -> System:
    """Return the model ST."""
    m, inertia, a, b, C = sm.symbols("m I a b C")
    x, y, delta, psi, beta, v, r = me.dynamicsymbols("x y delta psi beta v r")
    acceleration = inputs.acceleration(v)
    front, rear = (C * load for load in _loads_of_axles(acceleration))
    F_f = front * (delta - beta - a * r / v)
    F_r = rear * (b * r / v - beta)

    N, B, O = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    B.orient_axis(N, N.z, psi)
    B.set_ang_vel(N, r * N.z)
    O.set_vel(N, 0)
    G = O.locatenew("G", x * N.x + y * N.y)
    along = sm.cos(beta) * B.x + sm.sin(beta) * B.y
    G.set_vel(N, v * along)
    body = me.RigidBody("car", G, B, m, (me.inertia(B, 0, 0, inertia), G))
    definition = Definition(
        N,
        [x, y, delta, psi, beta],
        [v, r],
        bodies=[body],
        # The forces across the path are in the rate of β, a coordinate.
        loads=[(G, m * acceleration * along), (B, (a * F_f - b * F_r) * B.z)],
        kinematic_equations=[
            x.diff() - v * sm.cos(psi + beta),
            y.diff() - v * sm.sin(psi + beta),
            delta.diff() - inputs.steering_rate(),
            psi.diff() - r,
            beta.diff() + r - (F_f + F_r) / (m * v),
        ],
    )
    outputs = {"F_f": F_f, "F_r": F_r}
    return inputs.system(definition, (*_CONSTANTS, "C"), {v: speed}, outputs)


def drifting_car(inputs: CarInputs, speed: float) -> System:
    """Return the model STD."""
    m, inertia, a, b, R, J, drive, brake = sm.symbols("m I a b R J T_se T_sb")
    u, delta = me.dynamicsymbols("u delta")
    chassis = Chassis(m, inertia, u)
    magnitude = sm.sqrt(u**2 + chassis.v**2)
    wheels = [
        chassis.wheel("f", a, 0, delta, R, J),
        chassis.wheel("r", -b, 0, sm.Integer(0), R, J),
    ]
    pushing, braking = inputs.torques(magnitude, R)
    loads = _loads_of_axles(inputs.acceleration(magnitude))
    shares = (drive, brake), (1 - drive, 1 - brake)
    acting: list[Any] = []
    outputs = {"speed": magnitude, "beta": sm.atan(chassis.v / u)}
    for axle, wheel, Fz, (driven, braked) in zip("fr", wheels, loads, shares, strict=True):
        Fx, Fy = tire_forces(Fz, wheel.kappa, wheel.alpha)
        acting += wheel.loads(Fx, Fy, driven * pushing + wheel.brake(braked * braking))
        values = wheel.kappa, wheel.alpha, Fx, Fy
        names = (f"{name}_{axle}" for name in ("kappa", "alpha", "Fx", "Fy"))
        outputs |= zip(names, values, strict=True)
    spins = [wheel.spin for wheel in wheels]
    definition = Definition(
        chassis.N,
        [*chassis.coordinates, delta],
        [u, chassis.v, chassis.r, *spins],
        bodies=[chassis.body, *(wheel.body for wheel in wheels)],
        loads=acting,
        kinematic_equations=[*chassis.kinematic_equations, delta.diff() - inputs.steering_rate()],
    )
    rolling = {u: speed, **dict.fromkeys(spins, speed / inputs.values["R"])}
    constants = (*_CONSTANTS, "R", "J", "T_se", "T_sb")
    return inputs.system(definition, constants, rolling, outputs)
