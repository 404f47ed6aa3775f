"""The double-track car: a body in the plane, four wheels that spin, and loads that move."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import choice, instance, positive
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.aerodynamics import AIR_DENSITY, aerodynamic_loads
from pydy.vehicles.cars import GRAVITY, DoubleTrackCar
from pydy.vehicles.chassis import Chassis, Wheel
from pydy.vehicles.forces import Tire
from pydy.vehicles.linear import LinearTire
from pydy.vehicles.single_track import tires_of_axles

WHEELS = ("fl", "fr", "rl", "rr")


def double_track(
    car: DoubleTrackCar,
    tires: Tire | Sequence[Tire] | None = None,
    *,
    speed: float = 20.0,
    differential: str = "open",
    drag_area: float = 0.0,
    downforce_areas: Sequence[float] = (0.0, 0.0),
    lag: float = 0.05,
) -> System:
    """Return the System of a car with four wheels that spin: seven degrees of freedom.

    The body moves in the plane. The normal forces of the wheels follow its accelerations with a lag
    τ, as those of a car that pitches and rolls a little; with the share φ of the front axle in the
    roll stiffness ::

        F_z,fl, F_z,fr = m (g b − a_x* h)/(2 L) ∓ φ m a_y* h/T_f        τ a_x*' = a_x − a_x*
        F_z,rl, F_z,rr = m (g a + a_x* h)/(2 L) ∓ (1 − φ) m a_y* h/T_r  τ a_y*' = a_y − a_y*

    and half of the downforce of an axle on each of its wheels. The axles roll about points on the
    road; both front wheels have one steering angle.

    Parameters
    ----------
    car : DoubleTrackCar
        Such as one of `CARS`.
    tires : tire or pair of tires, optional
        For all wheels, or of the front and the rear ones; those at the right are mirror images. By
        default linear tires with the stiffnesses C_f/2 and C_r/2 of the car, in slip too.
    speed : float, optional
        Initial forward speed u (m/s); the wheels roll.
    differential : {'open', 'locked'}, optional
        Of the driven axles: both wheels have the same torque, or the same speed.
    drag_area : float, optional
        c_d A (m²).
    downforce_areas : pair of float, optional
        −c_l A (m²) of the front and the rear axle.
    lag : float, optional
        τ (s).

    Returns
    -------
    System
        Coordinates x, y, psi, and a_x_load and a_y_load (m/s²), which the normal forces follow;
        speeds u, v, r and the spins omega_fl, omega_fr, omega_rl, omega_rr (rad/s). Specifieds are
        delta (rad), and the torques T_drive and T_brake (N m) of all wheels together, T_brake not
        negative. Outputs are a_x, a_y, beta, and kappa, alpha, Fx, Fy and Fz of each wheel.

    References
    ----------
    M. Guiggiani, The Science of Vehicle Dynamics, 2nd ed., Springer, 2018, chapter 3.

    Examples
    --------
    >>> from pydy.vehicles import CARS, double_track
    >>> system = double_track(CARS['bmw_320i'], speed=20.0)
    >>> system.specifieds = {'delta': 0.03, 'T_drive': 300.0, 'T_brake': 0.0}
    >>> motion = system.simulate()
    >>> [round(float(motion[name][-1])) for name in ('Fz_fl', 'Fz_fr')]
    [1544, 4207]
    """
    instance(car, DoubleTrackCar, "`car`", "a DoubleTrackCar, such as one of CARS")
    speed = positive(speed, "`speed`", finite=True)
    kind = choice(differential, ("open", "locked"), "`differential`")
    drag = positive(drag_area, "`drag_area`", zero=True, finite=True)
    areas = two_areas(downforce_areas)
    front_tire, rear_tire = tires_of_axles(tires) or linear_tires(car)
    lag = positive(lag, "`lag`", finite=True)

    u, delta, T_drive, T_brake = me.dynamicsymbols("u delta T_drive T_brake")
    a_x, a_y = me.dynamicsymbols("a_x_load a_y_load")
    tau = sm.Symbol("tau")
    m, inertia, a, b, h, g, T_f, T_r, R, J = sm.symbols("m I a b h g T_f T_r R J")
    roll, drive, brake, rho, c_dA, c_lf, c_lr = sm.symbols("phi k_d k_b rho c_dA c_lA_f c_lA_r")
    chassis = Chassis(m, inertia, u)
    air = rho / 2 * u**2
    axles = (
        (a, T_f, delta, m * (g * b - a_x * h) / (a + b) + c_lf * air, roll, front_tire),
        (-b, T_r, sm.Integer(0), m * (g * a + a_x * h) / (a + b) + c_lr * air, 1 - roll, rear_tire),
    )
    shares = ((drive, brake), (1 - drive, 1 - brake))
    acting: list[Any] = []
    force = me.Vector(0)
    wheels: list[Wheel] = []
    outputs: dict[str, Any] = {"beta": sm.atan(chassis.v / u)}
    names = iter(WHEELS)
    for (forward, track, steering, load, share, tire), (driven, braked) in zip(
        axles, shares, strict=True
    ):
        moved = share * m * a_y * h / track
        for side in (1, -1):  # left, right
            name = next(names)
            wheel = chassis.wheel(name, forward, side * track / 2, steering, R, J)
            Fz = load / 2 - side * moved
            at_left = tire.forces(Fz, wheel.kappa, side * wheel.alpha)
            Fx, Fy = at_left.Fx, side * at_left.Fy
            torque = driven * T_drive / 2 + wheel.brake(braked * T_brake / 2)
            acting += wheel.loads(Fx, Fy, torque + at_left.My)
            acting.append((chassis.B, side * at_left.Mz * chassis.B.z))
            force += Fx * wheel.forward + Fy * wheel.left
            wheels.append(wheel)
            values = wheel.kappa, wheel.alpha, Fx, Fy, Fz
            kinds = ("kappa", "alpha", "Fx", "Fy", "Fz")
            outputs |= zip((f"{k}_{name}" for k in kinds), values, strict=True)
    ((_, drag_force),) = aerodynamic_loads(
        chassis.G, chassis.B.x, chassis.N.z, chassis.N, drag_area=c_dA, density=rho
    )
    acting.append((chassis.G, drag_force))
    force += drag_force
    accelerations = force.dot(chassis.B.x) / m, force.dot(chassis.B.y) / m
    outputs |= zip(("a_x", "a_y"), accelerations, strict=True)
    following = [
        load.diff() - (acceleration - load) / tau
        for load, acceleration in zip((a_x, a_y), accelerations, strict=True)
    ]
    spins = [wheel.spin for wheel in wheels]
    definition = Definition(
        chassis.N,
        [*chassis.coordinates, a_x, a_y],
        [u, chassis.v, chassis.r, *spins],
        bodies=[chassis.body, *(wheel.body for wheel in wheels)],
        loads=acting,
        kinematic_equations=[*chassis.kinematic_equations, *following],
        nonholonomic_constraints=locked_axles(car, spins) if kind == "locked" else (),
    )
    constants = {
        m: car.mass, inertia: car.yaw_inertia, a: car.front, b: car.rear, h: car.height, g: GRAVITY,
        T_f: car.front_track, T_r: car.rear_track, R: car.wheel_radius, J: car.wheel_inertia,
        roll: car.front_roll_share, drive: car.front_drive_share, brake: car.front_brake_share,
        rho: AIR_DENSITY, c_dA: drag, c_lf: areas[0], c_lr: areas[1],
        tau: lag,
    }  # fmt: skip
    return System(
        definition,
        constants,
        {delta: 0.0, T_drive: 0.0, T_brake: 0.0},
        "dop853",
        initial_conditions={u: speed, **dict.fromkeys(spins, speed / car.wheel_radius)},
        times=np.linspace(0.0, 2.0, 201),
        outputs=outputs,
    )


def two_areas(areas: Any) -> list[float]:
    """Return the areas of both axles that a user gave for the downforce."""
    if not isinstance(areas, (list, tuple)) or len(areas) != 2:
        raise TypeError(
            f"`downforce_areas` must be a pair, of the front and the rear axle, got {areas!r}."
        )
    return [
        positive(area, f"`downforce_areas[{k}]`", zero=True, finite=True)
        for k, area in enumerate(areas)
    ]


def linear_tires(car: DoubleTrackCar) -> tuple[LinearTire, LinearTire]:
    """Return tires with half of the stiffnesses of an axle at their static loads."""
    per_length = car.mass * GRAVITY / car.wheelbase / 2.0
    return (
        LinearTire(per_length * car.rear, car.front_stiffness / 2, car.front_stiffness / 2),
        LinearTire(per_length * car.front, car.rear_stiffness / 2, car.rear_stiffness / 2),
    )


def locked_axles(car: DoubleTrackCar, spins: list[sm.Expr]) -> list[sm.Expr]:
    """Return the constraints of the driven axles."""
    constraints = []
    if car.front_drive_share > 0.0:
        constraints.append(spins[0] - spins[1])
    if car.front_drive_share < 1.0:
        constraints.append(spins[2] - spins[3])
    return constraints
