"""A single-track car with a trailer."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import flag, instance, number, positive, shown
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import GRAVITY, SingleTrackCar
from pydy.vehicles.chassis import Chassis
from pydy.vehicles.forces import Tire
from pydy.vehicles.single_track import axle_forces, tires_of_axles

_AXLES = "front axle of the car", "rear axle of the car", "axle of the trailer"


def car_trailer(
    car: SingleTrackCar,
    tires: Tire | Sequence[Tire] | None = None,
    *,
    mass: float,
    yaw_inertia: float,
    hitch: float,
    length: float,
    centre: float,
    stiffness: float | None = None,
    trailer_tire: Tire | None = None,
    speed: float = 20.0,
    free_speed: bool = False,
) -> System:
    """Return the System of a single-track car that pulls a trailer with one axle.

    Side forces are −C α at each axle, with slip angles as for `single_track`, or those of tires.
    Fast cars with a trailer sway: beyond the critical speed a pair of eigenvalues has positive real
    parts.

    Parameters
    ----------
    car : SingleTrackCar
        Such as one of `CARS`.
    tires : tire or pair of tires, optional
        Of the car, as for `single_track`. The hitch bears m_t g (l − e)/l, which moves load from
        the front to the rear axle of the car.
    mass, yaw_inertia : float
        m_t (kg), and I_t (kg m²) about the trailer's mass centre.
    hitch : float
        Distance c (m) of the hitch behind the car's mass centre; negative in front of it, as for a
        semi-trailer.
    length : float
        Distance l (m) of the trailer's axle behind the hitch.
    centre : float
        Distance e (m) of the trailer's mass centre behind the hitch.
    stiffness : float, optional
        Cornering stiffness C_t (N/rad) of the trailer's axle. Pass it or `trailer_tire`.
    trailer_tire : tire, optional
        Tire of the trailer: one at the left, its mirror image at the right.
    speed : float, optional
        Forward speed u (m/s) of the car: the constant one, or the initial one if it is free.
    free_speed : bool, optional
        Whether u is a state, rather than a constant.

    Returns
    -------
    System
        Coordinates x, y, psi (rad) and phi (rad), the angle of the trailer to the car, positive to
        the left; speeds v, r and omega, the rate of phi, with u before them if it is free. The
        specified is delta (rad); if u is free, forces F_x on the rear axle of the car and F_x_t on
        that of the trailer, too (N, negative to brake). Outputs are the car's lateral acceleration
        a_y (m/s²) and sideslip angle beta, alpha_f, alpha_r, alpha_t, F_f, F_r and F_t.

    Raises
    ------
    ValueError
        Both or neither of `stiffness` and `trailer_tire`; an axle with a tire bears no load.

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
    sizes = {"mass": mass, "yaw_inertia": yaw_inertia, "length": length}
    m_t_value, I_t_value, l_value = (
        positive(value, f"`{name}`", finite=True) for name, value in sizes.items()
    )
    lengths = {"hitch": hitch, "centre": centre}
    c_value, e_value = (number(v, f"`{name}`", finite=True) for name, v in lengths.items())
    speed = positive(speed, "`speed`", finite=True)
    free_speed = flag(free_speed, "`free_speed`")
    axle_tires = tires_of_axles(tires)
    if (stiffness is None) == (trailer_tire is None):
        count = "neither" if stiffness is None else "both"
        raise ValueError(f"Pass either `stiffness` or `trailer_tire`, got {count}.")
    if trailer_tire is not None and (
        isinstance(trailer_tire, type) or not hasattr(trailer_tire, "forces")
    ):
        raise TypeError(
            f"`trailer_tire` must be a tire, such as a MagicFormula, got {shown(trailer_tire)}."
        )

    m, inertia, a, b, C_f, C_r, g = sm.symbols("m I a b C_f C_r g")
    m_t, I_t, c, e, C_t = sm.symbols("m_t I_t c e C_t")
    l = sm.Symbol("l")
    u = me.dynamicsymbols("u") if free_speed else sm.Symbol("u")
    F_x, F_x_t = me.dynamicsymbols("F_x F_x_t")
    constants = {
        m: car.mass, inertia: car.yaw_inertia, a: car.front, b: car.rear,
        m_t: m_t_value, I_t: I_t_value, c: c_value, l: l_value, e: e_value,
    }  # fmt: skip
    if not free_speed:
        constants[u] = speed
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
    hitch_load = m_t * g * (l - e) / l
    front_load = (m * g * b - hitch_load * (c - b)) / (a + b)
    loads = front_load, m * g + hitch_load - front_load, m_t * g - hitch_load
    axle_tires = (None, None) if axle_tires is None else axle_tires
    stiffnesses = (
        (C_f, car.front_stiffness),
        (C_r, car.rear_stiffness),
        (C_t, None if stiffness is None else positive(stiffness, "`stiffness`", finite=True)),
    )
    forces, moments = [], []
    for tire, slip, load, (C, value), axle_name in zip(
        (*axle_tires, trailer_tire), slips, loads, stiffnesses, _AXLES, strict=True
    ):
        if tire is None:
            assert value is not None  # either it or a tire is given, see `car_trailer`
            constants[C] = value
            forces.append(-C * slip)
            moments.append(sm.Integer(0))
        else:
            constants[g] = GRAVITY
            newtons = float(load.subs(constants))
            if newtons <= 0.0:
                raise ValueError(
                    f"The {axle_name} bears {newtons:.6g} N: a tire needs a positive load. "
                    "Change `centre`, `length` or `hitch`."
                )
            side, aligning = axle_forces(tire, slip, load)
            forces.append(side)
            moments.append(aligning)
    points = chassis.point("front", a), chassis.point("rear", -b), axle
    sideways = steered, B.y, T.y
    acting = [(p, F * side) for p, F, side in zip(points, forces, sideways, strict=True)]
    # The steered wheels turn about the vertical: the moments of both axles of the car add.
    acting += [(B, (moments[0] + moments[1]) * B.z), (T, moments[2] * T.z)]
    if free_speed:
        acting += [(points[1], F_x * B.x), (axle, F_x_t * T.x)]
    definition = Definition(
        chassis.N,
        [*chassis.coordinates, phi],
        [u, v, r, omega] if free_speed else [v, r, omega],
        bodies=[chassis.body, body],
        loads=acting,
        kinematic_equations=[*chassis.kinematic_equations, phi.diff() - omega],
    )
    names = "alpha_f", "alpha_r", "alpha_t", "F_f", "F_r", "F_t"
    return System(
        definition,
        constants,
        {delta: 0.0, F_x: 0.0, F_x_t: 0.0} if free_speed else {delta: 0.0},
        "dop853",
        initial_conditions={u: speed} if free_speed else {},
        times=np.linspace(0.0, 5.0, 501),
        outputs={
            "a_y": v.diff() + u * r,
            "beta": sm.atan(v / u),
            **dict(zip(names, (*slips, *forces), strict=True)),
        },
    )
