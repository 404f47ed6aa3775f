"""Constants of cars, and published values of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from types import MappingProxyType

from pydy._checks import number, positive

GRAVITY = 9.81  # m/s², as in the source of `CARS`


@dataclass(frozen=True)
class SingleTrackCar:
    """Constants of a single-track car: the wheels of an axle are one, in the middle.

    Parameters
    ----------
    mass : float
        m (kg).
    yaw_inertia : float
        I (kg m²), about the vertical axis through the mass centre.
    front, rear : float
        Distances a and b (m) of the axles from the mass centre.
    front_stiffness, rear_stiffness : float
        Cornering stiffnesses C_f and C_r (N/rad) of the axles, both wheels together.

    Examples
    --------
    >>> from pydy.vehicles import SingleTrackCar
    >>> SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3).wheelbase
    2.7
    """

    mass: float
    yaw_inertia: float
    front: float
    rear: float
    front_stiffness: float
    rear_stiffness: float

    def __post_init__(self) -> None:
        for field in fields(self):
            check = _share if field.name.endswith("_share") else _size
            value = check(getattr(self, field.name), f"`{field.name}`")
            object.__setattr__(self, field.name, value)

    @property
    def wheelbase(self) -> float:
        """The distance a + b (m) of the axles."""
        return self.front + self.rear


@dataclass(frozen=True)
class DoubleTrackCar(SingleTrackCar):
    """Constants of a car with four wheels; its cornering stiffnesses are those of a linear tire.

    Parameters
    ----------
    mass, yaw_inertia, front, rear, front_stiffness, rear_stiffness : float
        As for `SingleTrackCar`.
    height : float
        h (m) of the mass centre above the road.
    front_track, rear_track : float
        Track widths T_f and T_r (m).
    wheel_radius, wheel_inertia : float
        R (m), and J (kg m²) of a wheel about its axle, with what turns with it.
    front_roll_share : float
        Share of the front axle in the roll stiffness, from 0 to 1.
    front_drive_share, front_brake_share : float
        Shares of the front axle in the torques of the drive and the brakes, from 0 to 1.

    Examples
    --------
    >>> from pydy.vehicles import CARS
    >>> CARS['bmw_320i'].front_drive_share, CARS['bmw_320i'].front_brake_share
    (0.0, 0.66)
    """

    height: float
    front_track: float
    rear_track: float
    wheel_radius: float
    wheel_inertia: float
    front_roll_share: float
    front_drive_share: float
    front_brake_share: float


def _size(value: object, label: str) -> float:
    return positive(value, label, finite=True)


def _share(value: object, label: str) -> float:
    share = number(value, label)
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"{label} must be a number from 0 to 1, got {share!r}.")
    return share


STIFFNESS_PER_LOAD = 21.92  # −p_ky1 (1/rad) of the tires of `CARS`


def _of_commonroad(
    mass: float,
    yaw_inertia: float,
    axles: tuple[float, float],
    height: float,
    tracks: tuple[float, float],
    springs: tuple[float, float],
    torsion: tuple[float, float],
    drive: float,
    brake: float,
) -> DoubleTrackCar:
    """Return a car of CommonRoad: the stiffness of an axle is 21.92/rad times its static load.

    An axle resists roll by its springs, of the stiffness K T²/2, and by its stabiliser.
    """
    front, rear = axles
    stiffness = STIFFNESS_PER_LOAD * mass * GRAVITY / (front + rear)
    roll = [K * T**2 / 2 - K_t for K, T, K_t in zip(springs, tracks, torsion, strict=True)]
    return DoubleTrackCar(
        mass,
        yaw_inertia,
        front,
        rear,
        stiffness * rear,
        stiffness * front,
        height,
        *tracks,
        wheel_radius=0.344,
        wheel_inertia=1.7,
        front_roll_share=roll[0] / sum(roll),
        front_drive_share=drive,
        front_brake_share=brake,
    )


# Vehicles 1 to 3 of M. Althoff and G. Würsching, CommonRoad: Vehicle Models, 2020, with the numbers
# of the package commonroad-vehicle-models 3.0.2: m, I_z, a and b, h_cg, T_f and T_r, K_sf and K_sr,
# K_tsf and K_tsr, T_se, T_sb.
CARS: Mapping[str, DoubleTrackCar] = MappingProxyType(
    {
        "ford_escort": _of_commonroad(
            1225.8878467253344,
            1538.8533713561394,
            (0.88392, 1.50876),
            0.557784,
            (1.389888, 1.423416),
            (21898.332429625985, 21898.332429625985),
            (-12880.270509148304, 0.0),
            1.0,
            0.76,
        ),
        "bmw_320i": _of_commonroad(
            1093.2952334674046,
            1791.5995300122856,
            (1.1561957064, 1.4227170936),
            0.5748689544,
            (1.38684, 1.36398),
            (24453.137879749014, 19635.504745231297),
            (-6914.881688272133, -2643.6009520155308),
            0.0,
            0.66,
        ),
        "vw_vanagon": _of_commonroad(
            1478.8979637767998,
            2473.1176915564442,
            (1.1507916024, 1.3211363976),
            0.7478167416,
            (1.574292, 1.543812),
            (33577.44305875984, 39125.020607598424),
            (-33948.217142834066, -7731.374238208578),
            0.0,
            0.64,
        ),
    }
)
