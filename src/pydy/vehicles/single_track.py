"""The single-track car: two axles on a level road."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import flag, instance, positive, shown
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import GRAVITY, SingleTrackCar
from pydy.vehicles.forces import Tire


def single_track(
    car: SingleTrackCar,
    tires: Tire | Sequence[Tire] | None = None,
    *,
    speed: float = 20.0,
    free_speed: bool = False,
) -> System:
    """Return the System of a single-track car: two axles on a level road, steered in front.

    Slip angles are ``α_f = atan((v + a r)/u) − δ`` and ``α_r = atan((v − b r)/u)``; the road pushes
    the axles sideways by F_f and F_r. Without tires these are −C_f α_f and −C_r α_r. With tires an
    axle has one at the left and its mirror image at the right, each with half of its static load,
    and aligning moments act, too. The car neither rolls nor pitches, and moves forward: u > 0.

    Parameters
    ----------
    car : SingleTrackCar
        Such as one of `CARS`.
    tires : tire or pair of tires, optional
        For both axles, or of the front and the rear one; they replace the stiffnesses C_f and C_r.
    speed : float, optional
        Forward speed u (m/s): the constant one, or the initial one if it is free.
    free_speed : bool, optional
        Whether u is a state that changes, by the front axle's resistance in a turn and the force
        F_x that drives the rear axle, rather than a constant.

    Returns
    -------
    System
        Coordinates x, y (m) and psi (rad); speeds v (m/s, to the left) and r (rad/s), with u before
        them if it is free; constants m, I, a, b, and u if it is constant, C_f and C_r or, with
        tires, g; specifieds delta (rad), and F_x (N) if u is free. Outputs are the lateral
        acceleration a_y (m/s²), the sideslip angle beta, and alpha_f, alpha_r, F_f and F_r.

    References
    ----------
    M. Mitschke and H. Wallentowitz, Dynamik der Kraftfahrzeuge, 5th ed., Springer, 2014; for `CARS`
    M. Althoff and G. Würsching, CommonRoad: Vehicle Models, 2020.

    Examples
    --------
    >>> from pydy.vehicles import CARS, single_track
    >>> system = single_track(CARS['bmw_320i'], speed=30.0)
    >>> system.states
    [x(t), y(t), psi(t), v(t), r(t)]
    >>> system.specifieds = {'delta': 0.01}
    >>> motion = system.simulate()
    >>> [round(float(motion[name][-1]), 3) for name in ('r', 'a_y')]
    [0.116, 3.49]
    """
    instance(car, SingleTrackCar, "`car`", "a SingleTrackCar, such as one of CARS")
    speed = positive(speed, "`speed`", finite=True)
    free_speed = flag(free_speed, "`free_speed`")
    axle_tires = tires_of_axles(tires)
    x, y, psi, v, r, delta, F_x = me.dynamicsymbols("x y psi v r delta F_x")
    m, inertia, a, b, C_f, C_r, g = sm.symbols("m I a b C_f C_r g")
    u = me.dynamicsymbols("u") if free_speed else sm.Symbol("u")

    N, B, O = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    B.orient_axis(N, N.z, psi)
    B.set_ang_vel(N, r * N.z)
    wheel = B.orientnew("S", "Axis", (delta, B.z))
    O.set_vel(N, 0)
    G = O.locatenew("G", x * N.x + y * N.y)
    G.set_vel(N, u * B.x + v * B.y)
    front, rear = G.locatenew("front", a * B.x), G.locatenew("rear", -b * B.x)
    body = me.RigidBody("car", G, B, m, (me.inertia(B, 0, 0, inertia), G))

    slips = sm.atan((v + a * r) / u) - delta, sm.atan((v - b * r) / u)
    moment = sm.Integer(0)
    if axle_tires is None:
        forces = [-C_f * slips[0], -C_r * slips[1]]
    else:
        loads = m * g * b / (a + b), m * g * a / (a + b)
        axles = [axle_forces(*axle) for axle in zip(axle_tires, slips, loads, strict=True)]
        forces = [side for side, _ in axles]
        moment = sum((aligning for _, aligning in axles), moment)
    # The steered wheel turns about the vertical, so that one sum of moments acts on the car.
    acting = [(front, forces[0] * wheel.y), (rear, forces[1] * B.y), (B, moment * B.z)]
    if free_speed:
        acting.append((rear, F_x * B.x))
    kinematics = [
        x.diff() - u * sm.cos(psi) + v * sm.sin(psi),
        y.diff() - u * sm.sin(psi) - v * sm.cos(psi),
        psi.diff() - r,
    ]
    definition = Definition(
        N,
        [x, y, psi],
        [u, v, r] if free_speed else [v, r],
        bodies=[body],
        loads=acting,
        kinematic_equations=kinematics,
    )
    constants = {m: car.mass, inertia: car.yaw_inertia, a: car.front, b: car.rear}
    if axle_tires is None:
        constants |= {C_f: car.front_stiffness, C_r: car.rear_stiffness}
    else:
        constants[g] = GRAVITY
    if not free_speed:
        constants[u] = speed
    return System(
        definition,
        constants,
        {delta: 0.0, F_x: 0.0} if free_speed else {delta: 0.0},
        "dop853",
        initial_conditions={u: speed} if free_speed else {},
        times=np.linspace(0.0, 5.0, 501),
        outputs={
            "a_y": (forces[0] * sm.cos(delta) + forces[1]) / m,
            "beta": sm.atan(v / u),
            **dict(zip(("alpha_f", "alpha_r", "F_f", "F_r"), (*slips, *forces), strict=True)),
        },
    )


def tires_of_axles(tires: Any) -> tuple[Any, Any] | None:
    """Return the tires of the front and the rear axle, or None."""
    if tires is None:
        return None
    pair = (tires, tires) if hasattr(tires, "forces") else tires
    if (
        not isinstance(pair, (tuple, list))
        or len(pair) != 2
        or any(isinstance(tire, type) or not hasattr(tire, "forces") for tire in pair)
    ):
        raise TypeError(
            "`tires` must be a tire, such as a MagicFormula, or a pair for the front and the rear "
            f"axle, got {shown(tires)}."
        )
    return pair[0], pair[1]


def axle_forces(tire: Any, slip: sm.Expr, load: sm.Expr) -> tuple[Any, Any]:
    """Return the side force and the aligning moment of a tire and its mirror image."""
    one, other = (tire.forces(load / 2, 0, angle) for angle in (slip, -slip))
    return one.Fy - other.Fy, one.Mz - other.Mz
