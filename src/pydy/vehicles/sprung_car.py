"""The double-track car on springs: a body with six degrees of freedom on four sprung wheels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from types import MappingProxyType
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import choice, instance, positive
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.aerodynamics import AIR_DENSITY, aerodynamic_loads
from pydy.vehicles.bushings import anti_roll_bar_loads
from pydy.vehicles.cars import GRAVITY, DoubleTrackCar
from pydy.vehicles.chassis import LOWEST_SPEED
from pydy.vehicles.double_track import WHEELS, linear_tires, locked_axles, two_areas
from pydy.vehicles.forces import Tire, TireForces
from pydy.vehicles.single_track import tires_of_axles
from pydy.vehicles.wheel import WheelContact

_MAY_VANISH = ("front_damping", "rear_damping", "front_bar", "rear_bar")


@dataclass(frozen=True)
class SprungAxles:
    """Constants of the suspension of a car, of `SPRUNG_AXLES` or measured.

    Parameters
    ----------
    front_spring, rear_spring : float
        Rates k_f and k_r (N/m) of a spring at the wheel.
    front_damping, rear_damping : float
        c_f and c_r (N s/m) of a damper at the wheel.
    front_bar, rear_bar : float
        Roll stiffnesses K_f and K_r (N m/rad) of the anti-roll bars, 0 for none.
    front_unsprung, rear_unsprung : float
        Masses m_uf and m_ur (kg) of the axles, both wheels together.
    roll_inertia, pitch_inertia : float
        I_x and I_y (kg m²) of the sprung mass about its center.
    tire_stiffness : float
        k_t (N/m), vertical, of each tire.

    Examples
    --------
    >>> from pydy.vehicles.suspensions import SPRUNG_AXLES
    >>> axles = SPRUNG_AXLES['bmw_320i']
    >>> round(axles.front_spring), round(axles.front_bar)
    (24453, 6915)
    """

    front_spring: float
    rear_spring: float
    front_damping: float
    rear_damping: float
    front_bar: float
    rear_bar: float
    front_unsprung: float
    rear_unsprung: float
    roll_inertia: float
    pitch_inertia: float
    tire_stiffness: float

    def __post_init__(self) -> None:
        for field in fields(self):
            value = positive(
                getattr(self, field.name),
                f"`{field.name}`",
                zero=field.name in _MAY_VANISH,
                finite=True,
            )
            object.__setattr__(self, field.name, value)


# Vehicles 1 to 3 of M. Althoff and G. Würsching, CommonRoad: Vehicle Models, 2020, with the numbers
# of the package commonroad-vehicle-models 3.0.2: K_sf and K_sr, K_sdf and K_sdr, −K_tsf and −K_tsr,
# m_uf and m_ur, I_Φs and I_ys, K_zt. The source moves each axle as one body, which tilts.
SPRUNG_AXLES: Mapping[str, SprungAxles] = MappingProxyType(
    {
        "ford_escort": SprungAxles(
            front_spring=21898.332429625985,
            rear_spring=21898.332429625985,
            front_damping=1459.3902937206362,
            rear_damping=1459.3902937206362,
            front_bar=12880.270509148304,
            rear_bar=0.0,
            front_unsprung=65.67256321742863,
            rear_unsprung=65.67256321742863,
            roll_inertia=244.04723069965206,
            pitch_inertia=1342.2597688480864,
            tire_stiffness=189785.5477234252,
        ),
        "bmw_320i": SprungAxles(
            front_spring=24453.137879749014,
            rear_spring=19635.504745231297,
            front_damping=1786.2441002440723,
            rear_damping=1649.0833034887382,
            front_bar=6914.881688272133,
            rear_bar=2643.6009520155308,
            front_unsprung=63.7921826056784,
            rear_unsprung=63.7921826056784,
            roll_inertia=207.26524557936952,
            pitch_inertia=1565.8178787125541,
            tire_stiffness=158294.1398119115,
        ),
        "vw_vanagon": SprungAxles(
            front_spring=33577.44305875984,
            rear_spring=39125.020607598424,
            front_damping=2405.564099800005,
            rear_damping=2769.727219182409,
            front_bar=33948.217142834066,
            rear_bar=7731.374238208578,
            front_unsprung=81.14428941630796,
            rear_unsprung=81.14428941630796,
            roll_inertia=479.88430581318335,
            pitch_inertia=2204.322715845899,
            tire_stiffness=212641.56722464017,
        ),
    }
)


class _Mirrored:
    """The mirror image of a tire, for the other side of the car."""

    def __init__(self, tire: Tire) -> None:
        self._tire = tire

    def forces(
        self, Fz: Any, kappa: Any, alpha: Any, gamma: Any = 0.0, **conditions: Any
    ) -> TireForces:
        """Return the forces of the tire at the opposite slip angle and camber, mirrored."""
        other = self._tire.forces(Fz, kappa, -alpha, -gamma, **conditions)
        return TireForces(other.Fx, -other.Fy, -other.Mx, other.My, -other.Mz)


class _SprungBody:
    """A car's body with the coordinates x, y, z, ψ, θ, φ of a point, and the loads on it.

    The point Q is the mass center of the whole car at rest. u and v are horizontal, forward and to
    the left of the heading.
    """

    def __init__(self, height: Any) -> None:
        x, y, z, psi, theta, phi = self.coordinates = me.dynamicsymbols("x y z psi theta phi")
        u, v, w, r, q, p = self.speeds = me.dynamicsymbols("u v w r q p")
        self.N = me.ReferenceFrame("N")
        self.H, pitched, self.B = (me.ReferenceFrame(name) for name in "HPB")
        self.H.orient_axis(self.N, self.N.z, psi)
        self.H.set_ang_vel(self.N, r * self.N.z)
        pitched.orient_axis(self.H, self.H.y, theta)
        pitched.set_ang_vel(self.H, q * self.H.y)
        self.B.orient_axis(pitched, pitched.x, phi)
        self.B.set_ang_vel(pitched, p * pitched.x)
        self.origin = me.Point("O")
        self.origin.set_vel(self.N, 0)
        place = x * self.N.x + y * self.N.y + (height + z) * self.N.z
        self.Q = self.origin.locatenew("Q", place)
        self.Q.set_vel(self.N, u * self.H.x + v * self.H.y + w * self.N.z)
        self.kinematic_equations = [
            x.diff() - u * sm.cos(psi) + v * sm.sin(psi),
            y.diff() - u * sm.sin(psi) - v * sm.cos(psi),
            *(a.diff() - b for a, b in zip((z, psi, theta, phi), (w, r, q, p), strict=True)),
        ]

    def point(self, name: str, forward: Any, left: Any, up: Any) -> me.Point:
        """Return a point of the body."""
        arm = forward * self.B.x + left * self.B.y + up * self.B.z
        point = self.Q.locatenew(name, arm)
        point.v2pt_theory(self.Q, self.N, self.B)
        return point


@dataclass(frozen=True, eq=False)
class _SprungWheel:
    """A wheel that slides along the body's vertical and spins about a steered axle."""

    body: me.RigidBody
    center: me.Point
    rotating: me.ReferenceFrame
    axle: me.Vector
    contact: WheelContact
    travel: Any
    rate: Any
    spin: Any
    seat: me.Point


def _wheel(
    car: _SprungBody,
    name: str,
    seat: me.Point,
    steering: Any,
    mass: Any,
    inertia: Any,
    radius: Any,
    stiffness: Any,
) -> _SprungWheel:
    travel, rate, spin = me.dynamicsymbols(f"z_{name} w_{name} omega_{name}")
    N, B = car.N, car.B
    center = seat.locatenew(f"C_{name}", travel * B.z)
    turning = B.ang_vel_in(N)
    center.set_vel(N, seat.vel(N) + turning.cross(travel * B.z) + rate * B.z)
    # Inertias are those of a wheel straight ahead: the rate of the steering does not enter.
    unsteered = me.ReferenceFrame(f"W_{name}")
    unsteered.orient_axis(B, B.y, 0)
    unsteered.set_ang_vel(B, spin * B.y)
    body = me.RigidBody(name, center, unsteered, mass, (me.inertia(B, 0, inertia, 0), center))
    steered, rotating = (me.ReferenceFrame(f"{kind}_{name}") for kind in "SR")
    steered.orient_axis(B, B.z, steering)
    steered.set_ang_vel(B, 0)
    rotating.orient_axis(steered, steered.y, 0)
    rotating.set_ang_vel(steered, spin * steered.y)
    at_road = me.RigidBody(name, center, rotating, mass, (me.inertia(B, 0, inertia, 0), center))
    contact = WheelContact(
        at_road,
        steered.y,
        radius,
        car.origin,
        N.z,
        N,
        lambda gap, _rate: -stiffness * gap,
        low_speed=LOWEST_SPEED,
        name=f"touch {name}",
    )
    return _SprungWheel(body, center, rotating, steered.y, contact, travel, rate, spin, seat)


def sprung_double_track(
    car: DoubleTrackCar,
    axles: SprungAxles,
    tires: Tire | Sequence[Tire] | None = None,
    *,
    speed: float = 20.0,
    differential: str = "open",
    drag_area: float = 0.0,
    downforce_areas: Sequence[float] = (0.0, 0.0),
) -> System:
    """Return the System of a car with 14 degrees of freedom: its body moves on four sprung wheels.

    Six of the body, the vertical travel of each wheel along the body's vertical, and the spin of
    each wheel. `double_track` has quasi-static loads in place of the body's heave, pitch and roll,
    and the same inputs. With the travels z_i, positive in bump, a spring and damper and the bar of
    an axle of track T push the left wheel from the body by ::

        F = F_0 + k z_l + c z_l' + K (z_l − z_r)/T²

    F_0 carries the sprung weight, so that all coordinates but x, y and ψ are zero at rest on a
    level road. The wheels slide without camber or steering by travel: the roll centers are on the
    road, and braking does not support the body. Torques of drive and brakes react on the body.

    Parameters
    ----------
    car : DoubleTrackCar
        Such as one of `CARS`: mass, height and yaw inertia of the whole car; `wheel_radius` is
        the height of the axles at rest. The share in the roll stiffness follows from `axles`.
    axles : SprungAxles
        Such as one of `SPRUNG_AXLES`.
    tires : tire or pair of tires, optional
        As for `double_track`.
    speed : float, optional
        Initial forward speed u (m/s); the wheels roll.
    differential : {'open', 'locked'}, optional
        Of the driven axles: both wheels have the same torque, or the same speed.
    drag_area : float, optional
        c_d A (m²), at the mass center.
    downforce_areas : pair of float, optional
        −c_l A (m²) at the front and the rear axle.

    Returns
    -------
    System
        Coordinates x, y, z (m) of the mass center, psi, theta and phi (rad): yaw, pitch (positive
        if the front is low) and roll (positive if the right side is low), and the travels z_fl,
        z_fr, z_rl, z_rr (m). Speeds u, v (m/s), forward and to the left of the heading, w, r, q, p
        of heave, yaw, pitch and roll, w_fl … of the travels, and the spins omega_fl … (rad/s).
        Specifieds are delta (rad), T_drive and T_brake (N m) as for `double_track`. Outputs are
        a_x, a_y (the forces of road and air by the mass), beta, and kappa, alpha, Fx, Fy, Fz of
        each wheel.

    References
    ----------
    R. N. Jazar, Vehicle Dynamics: Theory and Application, 2nd ed., Springer, 2014, chapters 11 and
    13, for roll and for the vertical vibrations.

    Examples
    --------
    >>> from pydy.vehicles import CARS
    >>> from pydy.vehicles.suspensions import SPRUNG_AXLES, sprung_double_track
    >>> system = sprung_double_track(CARS['bmw_320i'], SPRUNG_AXLES['bmw_320i'], speed=20.0)
    >>> system.specifieds = {'delta': 0.03, 'T_drive': 300.0, 'T_brake': 0.0}
    >>> motion = system.simulate()
    >>> round(float(motion['phi'][-1]), 3)
    0.081
    """
    instance(car, DoubleTrackCar, "`car`", "a DoubleTrackCar, such as one of CARS")
    instance(axles, SprungAxles, "`axles`", "SprungAxles, such as one of SPRUNG_AXLES")
    speed = positive(speed, "`speed`", finite=True)
    kind = choice(differential, ("open", "locked"), "`differential`")
    drag = positive(drag_area, "`drag_area`", zero=True, finite=True)
    areas = two_areas(downforce_areas)
    _check_masses(car, axles)
    kinds = tires_of_axles(tires) or linear_tires(car)

    delta, T_drive, T_brake = me.dynamicsymbols("delta T_drive T_brake")
    m, inertia, a, b, h, g, T_f, T_r, R, J = sm.symbols("m I a b h g T_f T_r R J")
    I_x, I_y, m_uf, m_ur, k_t = sm.symbols("I_x I_y m_uf m_ur k_t")
    k_f, k_r, c_f, c_r, K_f, K_r = sm.symbols("k_f k_r c_f c_r K_f K_r")
    drive, brake, rho, c_dA, c_lf, c_lr = sm.symbols("k_d k_b rho c_dA c_lA_f c_lA_r")
    body = _SprungBody(h)
    N, B = body.N, body.B
    sprung = m - m_uf - m_ur
    ahead = (m_ur * b - m_uf * a) / sprung  # of the sprung mass center, and its height above that
    above = (m_uf + m_ur) * (h - R) / sprung
    center = body.point("G", ahead, 0, above)
    # The yaw inertia is that of the whole car.
    yaw = inertia - m_uf * (a**2 + T_f**2 / 4) - m_ur * (b**2 + T_r**2 / 4)
    yaw -= sprung * ahead**2
    moments = me.inertia(B, I_x, I_y, yaw)
    bodies = [me.RigidBody("car", center, B, sprung, (moments, center))]
    loads: list[Any] = [(center, -sprung * g * N.z)]
    outputs: dict[str, Any] = {"beta": sm.atan(body.speeds[1] / body.speeds[0])}
    total = me.Vector(0)
    wheels: list[_SprungWheel] = []
    names = iter(WHEELS)
    rows = (
        (a, T_f, delta, m_uf, (b + ahead) / (a + b), k_f, c_f, K_f, drive, brake, c_lf),
        (
            -b,
            T_r,
            sm.S.Zero,
            m_ur,
            (a - ahead) / (a + b),
            k_r,
            c_r,
            K_r,
            1 - drive,
            1 - brake,
            c_lr,
        ),
    )
    for (forward, track, steering, mass, share, k, c, bar, driven, braked, lift), tire in zip(
        rows, kinds, strict=True
    ):
        preload = share * sprung * g / 2
        radius = R + (preload + mass * g / 2) / k_t
        for side in (1, -1):  # left, right
            name = next(names)
            seat = body.point(f"A_{name}", forward, side * track / 2, R - h)
            wheel = _wheel(body, name, seat, steering, mass / 2, J, radius, k_t)
            push = (preload + k * wheel.travel + c * wheel.rate) * B.z
            turning = R * wheel.spin / LOWEST_SPEED
            braking = sm.Max(-1, sm.Min(turning, 1, evaluate=False), evaluate=False)
            torque = (driven * T_drive - braked * T_brake * braking) / 2 * wheel.axle
            on_side: Any = tire if side == 1 else _Mirrored(tire)
            contact, forces = wheel.contact, wheel.contact.forces(on_side)
            loads += [
                *contact.loads(on_side),
                (wheel.center, -push),
                (seat, push),
                (wheel.center, -mass / 2 * g * N.z),
                (wheel.rotating, torque),
                (B, -torque),
            ]
            bodies.append(wheel.body)
            wheels.append(wheel)
            total += forces.Fx * contact.forward + forces.Fy * contact.left
            values = contact.kappa, contact.alpha, forces.Fx, forces.Fy, contact.normal_force
            labels = (f"{n}_{name}" for n in ("kappa", "alpha", "Fx", "Fy", "Fz"))
            outputs |= zip(labels, values, strict=True)
        left, right = wheels[-2:]
        loads += anti_roll_bar_loads(left.center, right.center, B.z, B, stiffness=bar / track**2)
        middle = body.point(f"L_{name}", forward, 0, 0)
        loads += aerodynamic_loads(
            middle, body.H.x, N.z, N, drag_area=0.0, lift_area=-lift, density=rho
        )
    ((_, air),) = aerodynamic_loads(body.Q, body.H.x, N.z, N, drag_area=c_dA, density=rho)
    loads.append((body.Q, air))
    total += air
    outputs |= {"a_x": total.dot(body.H.x) / m, "a_y": total.dot(body.H.y) / m}
    spins = [wheel.spin for wheel in wheels]
    travels, rates = [wheel.travel for wheel in wheels], [wheel.rate for wheel in wheels]
    definition = Definition(
        N,
        [*body.coordinates, *travels],
        [*body.speeds, *rates, *spins],
        bodies=bodies,
        loads=loads,
        kinematic_equations=[
            *body.kinematic_equations,
            *(z.diff() - w for z, w in zip(travels, rates, strict=True)),
        ],
        nonholonomic_constraints=locked_axles(car, spins) if kind == "locked" else (),
    )
    constants = {
        m: car.mass, inertia: car.yaw_inertia, a: car.front, b: car.rear, h: car.height, g: GRAVITY,
        T_f: car.front_track, T_r: car.rear_track, R: car.wheel_radius, J: car.wheel_inertia,
        drive: car.front_drive_share, brake: car.front_brake_share, rho: AIR_DENSITY, c_dA: drag,
        I_x: axles.roll_inertia, I_y: axles.pitch_inertia, m_uf: axles.front_unsprung,
        m_ur: axles.rear_unsprung, k_t: axles.tire_stiffness, k_f: axles.front_spring,
        k_r: axles.rear_spring, c_f: axles.front_damping, c_r: axles.rear_damping,
        K_f: axles.front_bar, K_r: axles.rear_bar, c_lf: areas[0], c_lr: areas[1],
    }  # fmt: skip
    return System(
        definition,
        constants,
        {delta: 0.0, T_drive: 0.0, T_brake: 0.0},
        "dop853",
        initial_conditions={
            body.speeds[0]: speed,
            **dict.fromkeys(spins, speed / car.wheel_radius),
        },
        times=np.linspace(0.0, 2.0, 201),
        outputs=outputs,
    )


def _check_masses(car: DoubleTrackCar, axles: SprungAxles) -> None:
    """Refuse unsprung masses that are too large for the car's mass or yaw inertia."""
    unsprung = axles.front_unsprung + axles.rear_unsprung
    if not unsprung < car.mass:
        raise ValueError(
            f"`axles` must have unsprung masses below the mass of the car, {car.mass:.4g} kg, got "
            f"{unsprung:.4g} kg."
        )
    ahead = axles.rear_unsprung * car.rear - axles.front_unsprung * car.front
    turning = axles.front_unsprung * (car.front**2 + car.front_track**2 / 4)
    turning += axles.rear_unsprung * (car.rear**2 + car.rear_track**2 / 4)
    turning += ahead**2 / (car.mass - unsprung)
    if not turning < car.yaw_inertia:
        raise ValueError(
            "`axles` must have unsprung masses whose yaw inertia is below that of the car, "
            f"{car.yaw_inertia:.4g} kg m², got {turning:.4g} kg m²."
        )
