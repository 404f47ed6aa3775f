"""Two-wheelers: bicycles and motorcycles with wheels that roll, or with tires.

`bicycle` and `motorcycle` make Systems; `BICYCLES` and `MOTORCYCLES` have published constants.
Axes are ISO's: x forward, y to the left, z up. Lean is positive to the right, steering to the left.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydy._checks import instance, positive, shown
from pydy.system import System
from pydy.vehicles.forces import Tire
from pydy.vehicles.linear import LinearTire
from pydy.vehicles.single_track import tires_of_axles
from pydy.vehicles.two_wheeler_data import (
    BICYCLES,
    MOTORCYCLES,
    FrameBody,
    Motorcycle,
    Rider,
    TwoWheeler,
    WheelBody,
)
from pydy.vehicles.two_wheeler_model import Vehicle, WheelContacts, two_wheeler

__all__ = [
    "BICYCLES",
    "MOTORCYCLES",
    "FrameBody",
    "Motorcycle",
    "Rider",
    "TwoWheeler",
    "WheelBody",
    "bicycle",
    "motorcycle",
]
__dir__ = __all__.copy


def bicycle(
    vehicle: TwoWheeler,
    tires: Tire | Sequence[Tire] | None = None,
    *,
    speed: float = 5.0,
    vertical_stiffness: float | Sequence[float] = 1e5,
    vertical_damping: float | Sequence[float] = 500.0,
    relaxation_lengths: Sequence[float] | None = None,
    rider: Rider | None = None,
) -> System:
    """Return the System of a Carvallo–Whipple bicycle, on rigid wheels that roll or on tires.

    Two frames are hinged at the steering axis, and each holds a wheel: nothing is linearised.
    Without tires the wheels are rigid and roll without slip, as in Meijaard et al. 2007: the
    bicycle has three degrees of freedom. With tires it has nine: each wheel is a `WheelContact`
    with slip and camber, on a spring and a damper that keep it on the road. Its radius without a
    load is larger than that of the `WheelBody` by the static deflection, so that the geometry is
    the same in straight running.

    Parameters
    ----------
    vehicle : TwoWheeler
        Such as one of `BICYCLES`.
    tires : tire or pair of tires, optional
        For both wheels, or of the front and the rear one. A `LinearTire` needs a `slip_stiffness`:
        otherwise nothing makes the wheels turn with the speed.
    speed : float, optional
        Initial forward speed u (m/s); the wheels roll.
    vertical_stiffness, vertical_damping : float or pair of float, optional
        Of both tires, or of the front and the rear one (N/m and N s/m).
    relaxation_lengths : pair of float, optional
        σ (m) of the front and the rear tire: slips and camber follow over this distance, see
        `WheelContact.with_relaxation`. By default they follow at once.
    rider : Rider, optional
        An upper body that leans. By default the rider is rigid, and part of the rear frame.

    Returns
    -------
    System
        Coordinates x, y, z (m) of the rear wheel's centre, the yaw angle psi, the lean angle phi of
        the rear frame, positive to the right, its pitch angle theta, positive forward, and the
        steering angle delta, positive to the left (rad). Speeds u, v, w (m/s) forward, to the left
        and up, along the heading; r, p, q and delta_rate, the rates of these angles, and the spins
        omega_r and omega_f of the wheels in their frames (rad/s). A rider adds phi_U and p_U,
        relative to the frame. Specifieds are the steering torque T_delta, the torques T_f and T_r
        of brakes and drive on the wheels, and T_U, that leans the rider (N m). Outputs are the
        camber gamma and the forces Fx, Fy and Fz of each wheel, with tires kappa and alpha too:
        gamma_f, gamma_r, and so on.

    References
    ----------
    J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Linearized dynamics equations for
    the balance and steer of a bicycle: a benchmark and review, Proc. R. Soc. A 463 (2007)
    1955-1982.

    Examples
    --------
    The benchmark bicycle rights itself at 5 m/s:

    >>> from pydy.vehicles.two_wheelers import BICYCLES, bicycle
    >>> system = bicycle(BICYCLES['benchmark'], speed=5.0)
    >>> model = system.linearize(at={})
    >>> weave = max(model.eigenvalues, key=lambda value: value.imag)
    >>> complex(round(weave.real, 6), round(weave.imag, 6))
    (-0.775342+4.464868j)
    """
    instance(vehicle, TwoWheeler, "`vehicle`", "a TwoWheeler, such as one of BICYCLES")
    speed = positive(speed, "`speed`", zero=True, finite=True)
    stiffness = _pair(vertical_stiffness, "vertical_stiffness")
    damping = _pair(vertical_damping, "vertical_damping", zero=True)
    pair = tires_of_axles(tires)
    lengths = None
    if relaxation_lengths is not None:
        if pair is None:
            raise ValueError(
                "`relaxation_lengths` are those of tires, and `tires` is None: give tires."
            )
        lengths = _two(relaxation_lengths, "relaxation_lengths", zero=True)
    if rider is not None:
        instance(rider, Rider, "`rider`")
    equations = Vehicle(vehicle, rider)
    return two_wheeler(equations, vehicle, WheelContacts(pair, stiffness, damping, lengths), speed)


def motorcycle(
    vehicle: Motorcycle,
    tires: Tire | Sequence[Tire] | None = None,
    *,
    speed: float = 20.0,
    vertical_stiffness: float | Sequence[float] = 1.5e5,
    vertical_damping: float | Sequence[float] = 500.0,
    rider: Rider | None = None,
) -> System:
    """Return the System of a motorcycle on tires with relaxation, with a steering damper.

    This is `bicycle` with the tires, the relaxation lengths and the steering damper of a
    `Motorcycle`. Its lateral motion near straight running is that of Sharp 1971: of the weave,
    an oscillation of the whole machine at 1 to 4 Hz, the wobble, one of the steering at 7 to 10 Hz,
    and the capsize, a slow fall or rise.

    Parameters
    ----------
    vehicle : Motorcycle
        Such as one of `MOTORCYCLES`.
    tires : tire or pair of tires, optional
        For both wheels, or of the front and the rear one; a tire that was measured for one side of
        a vehicle pulls to it. By default linear tires with the stiffnesses of the motorcycle, the
        longitudinal one being the cornering stiffness.
    speed, vertical_stiffness, vertical_damping, rider : optional
        As for `bicycle`.

    Returns
    -------
    System
        As that of `bicycle`; coordinates e_x_f, e_y_f, gamma_lag_f of the front tire, and those of
        the rear one, are its relaxation. Constants are d_delta, the steering damping, sigma_f and
        sigma_r, and of linear tires C_f, C_r, C_gamma_f and C_gamma_r.

    References
    ----------
    R. S. Sharp, The stability and control of motorcycles, J. Mech. Eng. Sci. 13 (1971) 316-329.

    D. J. N. Limebeer and R. S. Sharp, Bicycles, motorcycles, and models, IEEE Control Systems
    Magazine 26(5), 2006, pp. 34-61.

    Examples
    --------
    Frequency (Hz) and real part (1/s) of the wobble at two speeds:

    >>> import numpy as np
    >>> from pydy.vehicles.two_wheelers import MOTORCYCLES, motorcycle
    >>> system = motorcycle(MOTORCYCLES['sharp_1971'], speed=20.0)
    >>> sweep = system.eigenvalues({'u': [20.0, 50.0]}, moving=['x'])
    >>> wobble = [row[(row.imag > 50.0) & (row.imag < 63.0)][0] for row in sweep.eigenvalues]
    >>> np.round([value.imag/(2*np.pi) for value in wobble], 1), np.round(np.real(wobble), 1)
    (array([8.6, 9.2]), array([-5.8, -0.9]))
    """
    instance(vehicle, Motorcycle, "`vehicle`", "a Motorcycle, such as one of MOTORCYCLES")
    speed = positive(speed, "`speed`", zero=True, finite=True)
    stiffness = _pair(vertical_stiffness, "vertical_stiffness")
    damping = _pair(vertical_damping, "vertical_damping", zero=True)
    pair = tires_of_axles(tires)
    if rider is not None:
        instance(rider, Rider, "`rider`")
    equations = Vehicle(vehicle, rider)
    equations.add_steering_damper(vehicle.steering_damping)
    if pair is None:
        pair = _linear_tires(equations, vehicle)
    lengths = (vehicle.front_relaxation, vehicle.rear_relaxation)
    return two_wheeler(equations, vehicle, WheelContacts(pair, stiffness, damping, lengths), speed)


def _linear_tires(equations: Vehicle, vehicle: Motorcycle) -> tuple[LinearTire, LinearTire]:
    """Return tires whose stiffnesses are constants of the System, at the static loads."""
    constant, loads = equations.parts.constant, equations.loads()
    tires = []
    for end, cornering, camber in (
        ("f", vehicle.front_stiffness, vehicle.front_camber_stiffness),
        ("r", vehicle.rear_stiffness, vehicle.rear_camber_stiffness),
    ):
        stiffness = constant(f"C_{end}", cornering)
        tires.append(
            LinearTire(loads[end], stiffness, stiffness, constant(f"C_gamma_{end}", camber))
        )
    return tires[0], tires[1]


def _pair(value: Any, name: str, *, zero: bool = False) -> tuple[float, float]:
    """Return a value of both wheels, or a pair of values."""
    if isinstance(value, (tuple, list)):
        return _two(value, name, zero=zero)
    both = positive(value, f"`{name}`", zero=zero, finite=True)
    return both, both


def _two(values: Any, name: str, *, zero: bool = False) -> tuple[float, float]:
    if not isinstance(values, (tuple, list)) or len(values) != 2:
        raise TypeError(
            f"`{name}` must be a pair, of the front and the rear tire, got {shown(values)}."
        )
    front, rear = (
        positive(value, f"`{name}[{k}]`", zero=zero, finite=True) for k, value in enumerate(values)
    )
    return front, rear
