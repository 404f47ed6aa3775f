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


# Published values in SI units: M. Althoff and G. Würsching, CommonRoad: Vehicle Models, 2020,
# tables 1 and 6, with the digits of the package commonroad-vehicle-models 3.0.2, which has a larger
# v_switch of the third car, and its D_f and D_r, which are zero in the table. The names are those
# of constants of the Systems; docs/howto/handling.md explains them.
_VEHICLES = ("ford_escort", "bmw_320i", "vw_vanagon")  # numbers 1 to 3 of CommonRoad
_VALUES = {
    # The whole car.
    "m": (1225.8878467253344, 1093.2952334674046, 1478.8979637767998),
    "I": (1538.8533713561394, 1791.5995300122856, 2473.1176915564442),
    "a": (0.88392, 1.1561957064, 1.1507916024),
    "b": (1.50876, 1.4227170936, 1.3211363976),
    "h_cg": (0.557784, 0.5748689544, 0.7478167416),
    "T_f": (1.389888, 1.38684, 1.574292),
    "T_r": (1.423416, 1.36398, 1.543812),
    # The sprung mass.
    "m_s": (1094.542720290477, 965.7108098804363, 1316.6086552490374),
    "h": (0.59436, 0.61373004, 0.804490644),
    "I_x": (244.04723069965206, 207.26524557936952, 479.88430581318335),
    "I_y": (1342.2597688480864, 1565.8178787125541, 2204.322715845899),
    "I_xz": (0.0, 0.0, 0.0),
    # The unsprung masses.
    "m_uf": (65.67256321742863, 63.7921826056784, 81.14428941630796),
    "m_ur": (65.67256321742863, 63.7921826056784, 81.14428941630796),
    "I_uf": (32.53963075995361, 30.673279563178017, 50.276902138127426),
    "I_ur": (32.53963075995361, 29.670408143156248, 48.34891545742069),
    # Springs, dampers and stabilisers.
    "K_sf": (21898.332429625985, 24453.137879749014, 33577.44305875984),
    "K_sr": (21898.332429625985, 19635.504745231297, 39125.020607598424),
    "K_sdf": (1459.3902937206362, 1786.2441002440723, 2405.564099800005),
    "K_sdr": (1459.3902937206362, 1649.0833034887382, 2769.727219182409),
    "K_tsf": (-12880.270509148304, -6914.881688272133, -33948.217142834066),
    "K_tsr": (0.0, -2643.6009520155308, -7731.374238208578),
    # The joints between the masses: elastic across the car, at the roll axis.
    "K_ras": (175186.65943700788, 175186.65943700788, 175186.65943700788),
    "K_rad": (10215.732056044453, 10215.732056044453, 10215.732056044453),
    "h_raf": (0.0, 0.0, 0.0),
    "h_rar": (0.0, 0.0, 0.0),
    # Camber of the wheels in relation to the body.
    "D_f": (-0.6233595800524934, -0.39370078740157477, -0.32808398950131235),
    "D_r": (-0.20997375328083986, -0.905511811023622, -0.32808398950131235),
    "E_f": (0.0, 0.0, 0.0),
    "E_r": (0.0, 0.0, 0.0),
    # Wheels and tires.
    "R": (0.344, 0.344, 0.344),
    "J": (1.7, 1.7, 1.7),
    "K_zt": (189785.5477234252, 158294.1398119115, 212641.56722464017),
    "K_lt": (1.0278264878518764e-05, 1.6430724599974725e-05, 1.2231329122034703e-05),
    # Drive and brakes: shares of the front axle, and what the drivers can demand.
    "T_se": (1.0, 0.0, 0.0),
    "T_sb": (0.76, 0.66, 0.64),
    "v_switch": (4.755, 7.319, 7.824),
    "a_max": (11.5, 11.5, 11.5),
    "v_delta_max": (0.4, 0.4, 0.4),
}


def values_of(vehicle: str) -> dict[str, float]:
    """Return the values of a car by their names."""
    number = _VEHICLES.index(vehicle)
    return {name: values[number] for name, values in _VALUES.items()}


def _of_commonroad(vehicle: str) -> DoubleTrackCar:
    """Return a car of CommonRoad: the stiffness of an axle is 21.92/rad times its static load.

    An axle resists roll by its springs, of the stiffness K T²/2, and by its stabiliser.
    """
    p = values_of(vehicle)
    front, rear = p["a"], p["b"]
    stiffness = STIFFNESS_PER_LOAD * p["m"] * GRAVITY / (front + rear)
    roll = [p[f"K_s{end}"] * p[f"T_{end}"] ** 2 / 2 - p[f"K_ts{end}"] for end in "fr"]
    return DoubleTrackCar(
        p["m"],
        p["I"],
        front,
        rear,
        stiffness * rear,
        stiffness * front,
        p["h_cg"],
        p["T_f"],
        p["T_r"],
        wheel_radius=p["R"],
        wheel_inertia=p["J"],
        front_roll_share=roll[0] / sum(roll),
        front_drive_share=p["T_se"],
        front_brake_share=p["T_sb"],
    )


CARS: Mapping[str, DoubleTrackCar] = MappingProxyType(
    {vehicle: _of_commonroad(vehicle) for vehicle in _VEHICLES}
)
