"""The single-track models of CommonRoad, with and without slip of the wheels."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import choice, positive
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import CARS, GRAVITY, STIFFNESS_PER_LOAD, DoubleTrackCar
from pydy.vehicles.chassis import Chassis

# Heights h_s (m) of the sprung masses, which both models use for the whole car, and speeds (m/s)
# from which on the power limits the acceleration.
_HEIGHTS = {"ford_escort": 0.59436, "bmw_320i": 0.61373004, "vw_vanagon": 0.804490644}
_SWITCHING_SPEEDS = {"ford_escort": 4.755, "bmw_320i": 7.319, "vw_vanagon": 7.824}
_LARGEST_ACCELERATION = 11.5  # m/s²
_LARGEST_STEERING_RATE = 0.4  # rad/s

# Coefficients of the tires, of table 7 of the source, that act without camber.
_LONGITUDINAL = {
    "cx1": 1.6411, "dx1": 1.1739, "ex1": 0.46403, "kx1": 22.303, "hx1": 0.0012297,
    "vx1": -8.8098e-06,
}  # fmt: skip
_LATERAL = {"cy1": 1.3507, "dy1": 1.0489, "ey1": -0.0074722, "ky1": -STIFFNESS_PER_LOAD}
_COMBINED_LONGITUDINAL = {
    "bx1": 13.276, "bx2": -13.778, "cx1": 1.2568, "ex1": 0.65225, "hx1": 0.0050722,
}  # fmt: skip
_COMBINED_LATERAL = {
    "by1": 7.1433, "by2": 9.1916, "by3": -0.027856, "cy1": 1.0719, "ey1": -0.27572,
    "hy1": 5.7448e-06, "vy1": -0.027825, "vy4": 12.12, "vy5": 1.9, "vy6": -10.704,
}  # fmt: skip


def commonroad_car(vehicle: str, model: str = "ST", *, speed: float = 20.0) -> System:
    """Return a single-track model of CommonRoad (ST), or the one that drifts (STD).

    Both have the steering rate δ' and the longitudinal acceleration a as inputs, which they limit
    to ±v_delta_max, and to a_max v_switch/max(v, v_switch) and −a_max. a moves load between the
    axles, F_zf = m (g b − a h)/L. ::

        ST    v' = a    I r' = a F_f − b F_r    m v (β' + r) = F_f + F_r
              F_f = C F_zf (δ − β − a r/v)      F_r = C F_zr (b r/v − β)

    STD has a tire with combined slip on each axle and wheels that spin; a becomes a torque m R a,
    of the driven axles or of the brakes, which fade where a wheel stands still. It is a
    `Definition` with the speeds u and v of the mass centre along the car's axes.

    Parameters
    ----------
    vehicle : str
        One of `CARS`: vehicles 1 to 3 of CommonRoad. The fourth, a truck, has kinematic data only.
    model : {'ST', 'STD'}, optional
    speed : float, optional
        Initial speed (m/s).

    Returns
    -------
    System
        Specifieds v_delta (rad/s) and a_long (m/s²). States of ST: x, y, delta, psi, beta, and the
        speeds v, r; of STD: x, y, psi, delta, and the speeds u, v, r, omega_f, omega_r. Outputs of
        STD: speed, beta, and the slips and forces of the axles.

    Notes
    -----
    The models hold above 1 m/s. Below 0.1 m/s (ST) and around 0.2 m/s (STD) CommonRoad changes to a
    kinematic model. Its limits of the steering angle and of the speed are not applied. Its shift
    S_vx stands inside the sine of the Magic Formula, and slip enters combined side forces with the
    sign of braking, as in its code.

    References
    ----------
    M. Althoff and G. Würsching, CommonRoad: Vehicle Models, 2020, sections 5 and 7; the package
    commonroad-vehicle-models 3.0.2.

    Examples
    --------
    >>> from pydy.vehicles import commonroad_car
    >>> system = commonroad_car('bmw_320i', 'STD', speed=15.0)
    >>> system.specifieds = {'v_delta': 0.15, 'a_long': -2.0}
    >>> motion = system.simulate()
    >>> [round(float(motion[name][-1]), 3) for name in ('speed', 'r')]
    [12.821, 0.718]
    """
    name = choice(vehicle, tuple(CARS), "`vehicle`")
    kind = choice(model, ("ST", "STD"), "`model`")
    speed = positive(speed, "`speed`", finite=True)
    make = _linear if kind == "ST" else _drifting
    return make(_Data(name), speed)


class _Data:
    """Constants that both models share, the inputs within their limits, and the axles' loads."""

    def __init__(self, name: str) -> None:
        self.car: DoubleTrackCar = CARS[name]
        names = "m I a b h g a_max v_switch v_delta_max"
        self.symbols = dict(zip(names.split(), sm.symbols(names), strict=True))
        car = self.car
        sizes = car.mass, car.yaw_inertia, car.front, car.rear, _HEIGHTS[name], GRAVITY
        limits = _LARGEST_ACCELERATION, _SWITCHING_SPEEDS[name], _LARGEST_STEERING_RATE
        self.constants = dict(zip(self.symbols.values(), (*sizes, *limits), strict=True))
        self.inputs = me.dynamicsymbols("v_delta a_long")

    def steering_rate(self) -> sm.Expr:
        """Return the input within its limits."""
        largest = self.symbols["v_delta_max"]
        return _between(-largest, self.inputs[0], largest)

    def acceleration(self, speed: sm.Expr) -> sm.Expr:
        """Return the input within its limits."""
        largest, switch = self.symbols["a_max"], self.symbols["v_switch"]
        power = largest * switch / sm.Max(speed, switch, evaluate=False)
        return _between(-largest, self.inputs[1], power)

    def loads(self, acceleration: sm.Expr) -> list[sm.Expr]:
        """Return the normal forces of the front and the rear axle."""
        m, _, a, b, h, g, *_ = self.symbols.values()
        return [m * (g * b - acceleration * h) / (a + b), m * (g * a + acceleration * h) / (a + b)]

    def system(
        self, definition: Definition, constants: Any, start: Any, outputs: dict[str, sm.Expr]
    ) -> System:
        """Return a System that drives straight ahead."""
        return System(
            definition,
            {**self.constants, **constants},
            dict.fromkeys(self.inputs, 0.0),
            "dop853",
            initial_conditions=start,
            times=np.linspace(0.0, 1.0, 101),
            outputs=outputs,
        )


def _between(least: Any, value: Any, most: Any) -> sm.Expr:
    return sm.Max(least, sm.Min(value, most, evaluate=False), evaluate=False)


def _linear(data: _Data, speed: float) -> System:
    m, inertia, a, b, *_ = data.symbols.values()
    C = sm.Symbol("C")
    x, y, delta, psi, beta, v, r = me.dynamicsymbols("x y delta psi beta v r")
    acceleration = data.acceleration(v)
    front, rear = (C * load for load in data.loads(acceleration))
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
            delta.diff() - data.steering_rate(),
            psi.diff() - r,
            beta.diff() + r - (F_f + F_r) / (m * v),
        ],
    )
    outputs = {"F_f": F_f, "F_r": F_r}
    return data.system(definition, {C: STIFFNESS_PER_LOAD}, {v: speed}, outputs)


def _drifting(data: _Data, speed: float) -> System:
    car = data.car
    m, inertia, a, b, *_ = data.symbols.values()
    R, J, drive, brake = sm.symbols("R J T_se T_sb")
    u, delta = me.dynamicsymbols("u delta")
    chassis = Chassis(m, inertia, u)
    magnitude = sm.sqrt(u**2 + chassis.v**2)
    acceleration = data.acceleration(magnitude)
    wheels = [
        chassis.wheel("f", a, 0, delta, R, J),
        chassis.wheel("r", -b, 0, sm.Integer(0), R, J),
    ]
    pushing = m * R * sm.Max(acceleration, 0, evaluate=False)
    braking = -m * R * sm.Min(acceleration, 0, evaluate=False)
    shares = (drive, brake), (1 - drive, 1 - brake)
    acting: list[Any] = []
    outputs = {"speed": magnitude, "beta": sm.atan(chassis.v / u)}
    for axle, wheel, Fz, (driven, braked) in zip(
        "fr", wheels, data.loads(acceleration), shares, strict=True
    ):
        Fx, Fy = _forces(Fz, wheel.kappa, wheel.alpha)
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
        kinematic_equations=[*chassis.kinematic_equations, delta.diff() - data.steering_rate()],
    )
    sizes = {
        R: car.wheel_radius,
        J: car.wheel_inertia,
        drive: car.front_drive_share,
        brake: car.front_brake_share,
    }
    rolling = {u: speed, **dict.fromkeys(spins, speed / car.wheel_radius)}
    return data.system(definition, sizes, rolling, outputs)


def _forces(Fz: sm.Expr, kappa: sm.Expr, alpha: sm.Expr) -> tuple[sm.Expr, sm.Expr]:
    """Return F_x and F_y of a tire without camber."""
    p = _LONGITUDINAL
    angle = _angle(p["kx1"] / (p["cx1"] * p["dx1"]), p["cx1"], p["ex1"], kappa + p["hx1"])
    pure_x = p["dx1"] * Fz * sm.sin(angle + Fz * p["vx1"])
    p = _LATERAL
    angle = _angle(p["ky1"] / (p["cy1"] * p["dy1"]), p["cy1"], p["ey1"], alpha)
    pure_y = p["dy1"] * Fz * sm.sin(angle)
    r = _COMBINED_LONGITUDINAL
    steepness = r["bx1"] * sm.cos(sm.atan(r["bx2"] * kappa))
    weight_x = _weight(steepness, r["cx1"], r["ex1"], alpha, r["hx1"])
    r = _COMBINED_LATERAL
    steepness = r["by1"] * sm.cos(sm.atan(r["by2"] * (alpha - r["by3"])))
    weight_y = _weight(steepness, r["cy1"], r["ey1"], -kappa, r["hy1"])
    size = _LATERAL["dy1"] * Fz * r["vy1"] * sm.cos(sm.atan(r["vy4"] * alpha))
    side = size * sm.sin(r["vy5"] * sm.atan(-r["vy6"] * kappa))
    return pure_x * weight_x, pure_y * weight_y + side


def _angle(steepness: Any, shape: float, curvature: float, slip: Any) -> sm.Expr:
    """Return the angle of the Magic Formula, whose sine or cosine is the force or its weight."""
    x = steepness * slip
    return shape * sm.atan(x - curvature * (x - sm.atan(x)))


def _weight(steepness: Any, shape: float, curvature: float, slip: Any, shift: float) -> sm.Expr:
    """Return the share of a force that is left at the slip in the other direction."""
    at, without = (_angle(steepness, shape, curvature, s) for s in (slip + shift, shift))
    return sm.cos(at) / sm.cos(without)
