"""A single-track car with a trailer."""

from __future__ import annotations

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import instance, number, positive
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import SingleTrackCar
from pydy.vehicles.chassis import Chassis


def car_trailer(
    car: SingleTrackCar,
    *,
    mass: float,
    yaw_inertia: float,
    hitch: float,
    length: float,
    centre: float,
    stiffness: float,
    speed: float = 20.0,
) -> System:
    """Return the System of a single-track car that pulls a trailer with one axle.

    The forward speed u of the car is constant. Side forces are −C α at each axle, with slip angles
    as for `single_track`. Fast cars with a trailer sway: beyond the critical speed a pair of
    eigenvalues has positive real parts.

    Parameters
    ----------
    car : SingleTrackCar
        Such as one of `CARS`.
    mass, yaw_inertia : float
        m_t (kg), and I_t (kg m²) about the trailer's mass centre.
    hitch : float
        Distance c (m) of the hitch behind the car's mass centre; negative in front of it, as for a
        semi-trailer.
    length : float
        Distance l (m) of the trailer's axle behind the hitch.
    centre : float
        Distance e (m) of the trailer's mass centre behind the hitch.
    stiffness : float
        Cornering stiffness C_t (N/rad) of the trailer's axle.
    speed : float, optional
        u (m/s).

    Returns
    -------
    System
        Coordinates x, y, psi (rad) and phi (rad), the angle of the trailer to the car, positive to
        the left; speeds v, r and omega, the rate of phi. The specified is delta (rad). Outputs are
        alpha_f, alpha_r, alpha_t, F_f, F_r and F_t.

    References
    ----------
    H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed., Butterworth-Heinemann, 2012, section 1.5.

    Examples
    --------
    A caravan that is heavy at its rear sways more and more above some speed:

    >>> from pydy.vehicles import SingleTrackCar, car_trailer
    >>> car = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
    >>> system = car_trailer(car, mass=1200, yaw_inertia=2500, hitch=2.5, length=4.0, centre=4.2,
    ...                      stiffness=70e3, speed=20.0)
    >>> bool(system.linearize().eigenvalues.real.max().round(3) > 0.0)
    False
    >>> system.constants['u'] = 40.0
    >>> bool(system.linearize().eigenvalues.real.max().round(3) > 0.0)
    True
    """
    instance(car, SingleTrackCar, "`car`", "a SingleTrackCar, such as one of CARS")
    sizes = {"mass": mass, "yaw_inertia": yaw_inertia, "length": length, "stiffness": stiffness}
    m_t_value, I_t_value, l_value, C_t_value = (
        positive(value, f"`{name}`", finite=True) for name, value in sizes.items()
    )
    lengths = {"hitch": hitch, "centre": centre}
    c_value, e_value = (number(v, f"`{name}`", finite=True) for name, v in lengths.items())
    speed = positive(speed, "`speed`", finite=True)

    m, inertia, a, b, C_f, C_r, u = sm.symbols("m I a b C_f C_r u")
    m_t, I_t, c, e, C_t = sm.symbols("m_t I_t c e C_t")
    l = sm.Symbol("l")
    phi, omega, delta = me.dynamicsymbols("phi omega delta")
    chassis = Chassis(m, inertia, u)
    B, v, r = chassis.B, chassis.v, chassis.r
    T = B.orientnew("T", "Axis", (phi, B.z))
    T.set_ang_vel(B, omega * B.z)
    joint = chassis.point("hitch", -c)
    joint.v2pt_theory(chassis.G, chassis.N, B)
    middle, axle = (joint.locatenew(n, -way * T.x) for n, way in (("G_t", e), ("axle", l)))
    for point in (middle, axle):
        point.v2pt_theory(joint, chassis.N, T)
    body = me.RigidBody("trailer", middle, T, m_t, (me.inertia(T, 0, 0, I_t), middle))
    steered = sm.cos(delta) * B.y - sm.sin(delta) * B.x
    moving = axle.vel(chassis.N)
    slips = (
        sm.atan((v + a * r) / u) - delta,
        sm.atan((v - b * r) / u),
        sm.atan(moving.dot(T.y) / moving.dot(T.x)),
    )
    forces = [-C * slip for C, slip in zip((C_f, C_r, C_t), slips, strict=True)]
    points = chassis.point("front", a), chassis.point("rear", -b), axle
    sideways = steered, B.y, T.y
    definition = Definition(
        chassis.N,
        [*chassis.coordinates, phi],
        [v, r, omega],
        bodies=[chassis.body, body],
        loads=[(p, F * side) for p, F, side in zip(points, forces, sideways, strict=True)],
        kinematic_equations=[*chassis.kinematic_equations, phi.diff() - omega],
    )
    names = "alpha_f", "alpha_r", "alpha_t", "F_f", "F_r", "F_t"
    return System(
        definition,
        {
            m: car.mass, inertia: car.yaw_inertia, a: car.front, b: car.rear,
            C_f: car.front_stiffness, C_r: car.rear_stiffness, u: speed,
            m_t: m_t_value, I_t: I_t_value, c: c_value, l: l_value, e: e_value, C_t: C_t_value,
        },
        {delta: 0.0},
        "dop853",
        times=np.linspace(0.0, 5.0, 501),
        outputs=dict(zip(names, (*slips, *forces), strict=True)),
    )  # fmt: skip
