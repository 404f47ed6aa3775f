"""The car of CommonRoad in each of its models."""

from __future__ import annotations

from pydy._checks import choice, positive
from pydy.system import System
from pydy.vehicles.cars import CARS
from pydy.vehicles.commonroad.inputs import CarInputs
from pydy.vehicles.commonroad.multi_body import multi_body_car
from pydy.vehicles.commonroad.single_track import drifting_car, linear_car

_MODELS = {"ST": linear_car, "STD": drifting_car, "MB": multi_body_car}


def commonroad_car(vehicle: str, model: str = "ST", *, speed: float = 20.0) -> System:
    """Return a model of CommonRoad: single-track (ST), drifting (STD), or multi-body (MB).

    All have the steering rate δ' and the longitudinal acceleration a as inputs, which they limit
    to ±v_delta_max, and to a_max v_switch/max(v, v_switch) and −a_max. In ST and STD a moves load
    between the axles, F_zf = m (g b − a h)/L. ::

        ST    v' = a    I r' = a F_f − b F_r    m v (β' + r) = F_f + F_r
              F_f = C F_zf (δ − β − a r/v)      F_r = C F_zr (b r/v − β)

    STD has a tire with combined slip on each axle and wheels that spin; a becomes a torque m R a,
    of the driven axles or of the brakes, which fade where a wheel stands still. It is a
    `Definition` with the speeds u and v of the mass centre along the car's axes.

    MB has 29 states: a sprung mass with six degrees of freedom, on two axles that roll, move up and
    to the side, with four wheels. Springs, dampers and stabilisers act between them, joints that
    are elastic across the car, and vertical springs in the tires, whose load, slip and camber give
    the forces. Its axes are those of its source: y points to the right and z down, and a positive
    steering angle is to the right.

    Parameters
    ----------
    vehicle : str
        One of `CARS`: vehicles 1 to 3 of CommonRoad. The fourth, a truck, has kinematic data only.
    model : {'ST', 'STD', 'MB'}, optional
    speed : float, optional
        Initial speed (m/s).

    Returns
    -------
    System
        Specifieds v_delta (rad/s) and a_long (m/s²). States of ST: x, y, delta, psi, beta, and the
        speeds v, r; of STD: x, y, psi, delta, and the speeds u, v, r, omega_f, omega_r. Outputs of
        STD: speed, beta, and the slips and forces of the axles.

        Coordinates of MB: x, y, psi, delta; roll, pitch and height phi, theta, z of the sprung
        mass; roll, height and displacement of the joint phi_f, z_f, y_f and phi_r, z_r, y_r of the
        axles. Speeds: u, v, r and p, q, w of the sprung mass, p_f, v_f, w_f and p_r, v_r, w_r, and
        omega_fl, omega_fr, omega_rl, omega_rr. Outputs: speed, beta, and kappa, alpha, gamma, Fx,
        Fy and Fz of each wheel. The initial state is that of CommonRoad, with compressed tires.

    Notes
    -----
    The models hold above 1 m/s. Below 0.1 m/s (ST, MB) and around 0.2 m/s (STD) CommonRoad changes
    to a kinematic model. Its limits of the steering angle and of the speed are not applied. Its
    shift S_vx stands inside the sine of the Magic Formula, and slip enters combined side forces
    with the sign of braking, as in its code.

    In MB, wheels spin forward only. In CommonRoad's code one that has stopped never starts again,
    here its brake holds it until the road's torque is larger. A tire's spring also pulls, as in the
    source: a negative Fz is where the wheel would lift, and the motion after it is that of the
    published equations only.

    References
    ----------
    M. Althoff and G. Würsching, CommonRoad: Vehicle Models, 2020, sections 7 to 9; the package
    commonroad-vehicle-models 3.0.2. For MB: R. W. Allen, H. T. Szostak, D. H. Klyde, T. J.
    Rosenthal and K. J. Owens, Vehicle Dynamic Stability and Rollover, NHTSA, DOT HS 807 956, 1992,
    appendix A.

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
    kind = choice(model, tuple(_MODELS), "`model`")
    speed = positive(speed, "`speed`", finite=True)
    return _MODELS[kind](CarInputs(name), speed)
