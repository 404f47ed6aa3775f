"""Constants of bicycles and motorcycles, and published values of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from math import cos, pi, radians, sin
from types import MappingProxyType
from typing import ClassVar

from pydy._checks import instance, number, positive, shown
from pydy.vehicles.cars import GRAVITY


class _PositiveValues:
    """Fields that are finite numbers, some of them positive or not negative."""

    _POSITIVE: ClassVar[tuple[str, ...]] = ()
    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = ()

    def _check_numbers(self) -> None:
        for field in fields(self):  # type: ignore[arg-type]
            name = field.name
            value = getattr(self, name)
            if name in self._POSITIVE or name in self._NOT_NEGATIVE:
                zero = name in self._NOT_NEGATIVE
                value = positive(value, f"`{name}`", zero=zero, finite=True)
            elif field.type == "float":
                value = number(value, f"`{name}`", finite=True)
            object.__setattr__(self, name, value)


@dataclass(frozen=True)
class FrameBody(_PositiveValues):
    """Mass, mass centre and moments of inertia of the rear frame or of the front frame.

    Axes are those of the upright vehicle with straight steering: x forward from the rear contact
    point, z up from the road. Meijaard et al. 2007 have z down: there heights have the other sign,
    and products of inertia too.

    Parameters
    ----------
    mass : float
        (kg)
    x, height : float
        Coordinates x and z of the mass centre (m).
    Ixx, Iyy, Izz : float
        Moments of inertia about the mass centre (kg m²).
    Ixz : float, optional
        Component of the inertia tensor (kg m²): −∫ x z dm.

    Examples
    --------
    >>> from pydy.vehicles.two_wheelers import BICYCLES
    >>> BICYCLES['benchmark'].rear_frame.height
    0.9
    """

    mass: float
    x: float
    height: float
    Ixx: float
    Iyy: float
    Izz: float
    Ixz: float = 0.0

    _POSITIVE: ClassVar[tuple[str, ...]] = ("mass", "Ixx", "Iyy", "Izz")

    def __post_init__(self) -> None:
        self._check_numbers()
        if not self.Ixx * self.Izz > self.Ixz * self.Ixz:
            raise ValueError(
                f"`Ixz` must be smaller than the root of Ixx Izz, got {self.Ixz!r} with "
                f"Ixx = {self.Ixx!r} and Izz = {self.Izz!r}."
            )


@dataclass(frozen=True)
class WheelBody(_PositiveValues):
    """A wheel of a two-wheeler.

    Parameters
    ----------
    radius : float
        Distance of the centre to the road in straight running (m), with the tire's deflection.
    mass : float
        (kg); zero if it is part of the frame's.
    axial_inertia : float
        Moment of inertia about the axle (kg m²).
    diametral_inertia : float, optional
        About any line through the centre and across the axle (kg m²).
    crown_radius : float, optional
        Radius of the tire's cross section (m), smaller than `radius`; by default a thin disc.

    Examples
    --------
    >>> from pydy.vehicles.two_wheelers import WheelBody
    >>> WheelBody(0.3, 12.0, 0.6, 0.35, crown_radius=0.06).crown_radius
    0.06
    """

    radius: float
    mass: float
    axial_inertia: float
    diametral_inertia: float = 0.0
    crown_radius: float = 0.0

    _POSITIVE: ClassVar[tuple[str, ...]] = ("radius", "axial_inertia")
    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = ("mass", "diametral_inertia", "crown_radius")

    def __post_init__(self) -> None:
        self._check_numbers()
        if not self.crown_radius < self.radius:
            raise ValueError(
                f"`crown_radius` must be smaller than `radius`, got {self.crown_radius!r} and "
                f"{self.radius!r}."
            )


@dataclass(frozen=True, kw_only=True)
class Rider(FrameBody):
    """The upper body of a rider, who leans to the side on the rear frame.

    It turns about a line along x, with a spring and a damper that hold it upright on the frame.
    The rest of the rider belongs to the rear frame.

    Parameters
    ----------
    mass, x, height, Ixx, Iyy, Izz, Ixz : float
        As for `FrameBody`.
    hinge_height : float
        Height of the line about which the rider leans (m).
    stiffness : float
        (N m/rad)
    damping : float
        (N m s/rad)

    Examples
    --------
    >>> from pydy.vehicles.two_wheelers import Rider
    >>> Rider(45, 0.5, 1.1, 1.3, 2.1, 1.4, hinge_height=0.8, stiffness=380, damping=30).Ixz
    0.0
    """

    hinge_height: float
    stiffness: float
    damping: float

    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = ("stiffness", "damping")


@dataclass(frozen=True)
class TwoWheeler(_PositiveValues):
    """Constants of a bicycle: two frames that are hinged at the steering axis, and two wheels.

    Parameters
    ----------
    wheelbase : float
        (m)
    trail : float
        Distance (m) of the front contact point behind the steering axis, on the road.
    steer_axis_tilt : float
        Angle (rad) of the steering axis to the vertical, positive if it leans back; less than π/2.
    rear_frame, front_frame : FrameBody
        Without the wheels; the rear frame with a rider.
    rear_wheel, front_wheel : WheelBody

    Examples
    --------
    >>> from pydy.vehicles.two_wheelers import BICYCLES
    >>> front, rear = BICYCLES['benchmark'].static_loads
    >>> round(front, 3), round(rear, 3)
    (309.304, 612.836)
    """

    wheelbase: float
    trail: float
    steer_axis_tilt: float
    rear_frame: FrameBody
    front_frame: FrameBody
    rear_wheel: WheelBody
    front_wheel: WheelBody

    _POSITIVE: ClassVar[tuple[str, ...]] = ("wheelbase",)

    def __post_init__(self) -> None:
        self._check_numbers()
        if not abs(self.steer_axis_tilt) < pi / 2:
            raise ValueError(
                "`steer_axis_tilt` must be between -pi/2 and pi/2, got "
                f"{shown(self.steer_axis_tilt)}."
            )
        for name in ("rear_frame", "front_frame"):
            instance(getattr(self, name), FrameBody, f"`{name}`")
        for name in ("rear_wheel", "front_wheel"):
            instance(getattr(self, name), WheelBody, f"`{name}`")

    @property
    def static_loads(self) -> tuple[float, float]:
        """Loads (N) of the front and the rear wheel at rest, without a `Rider`; g = 9.81 m/s²."""
        parts = [(self.rear_frame.mass, self.rear_frame.x), (self.rear_wheel.mass, 0.0)]
        parts += [(self.front_frame.mass, self.front_frame.x)]
        parts += [(self.front_wheel.mass, self.wheelbase)]
        front = GRAVITY * sum(m * x for m, x in parts) / self.wheelbase
        return front, GRAVITY * sum(m for m, _ in parts) - front


@dataclass(frozen=True, kw_only=True)
class Motorcycle(TwoWheeler):
    """Constants of a motorcycle, with linear tires and a steering damper.

    Parameters
    ----------
    wheelbase, trail, steer_axis_tilt, rear_frame, front_frame, rear_wheel, front_wheel
        As for `TwoWheeler`.
    front_stiffness, rear_stiffness : float
        Cornering stiffnesses (N/rad) at the static loads.
    front_camber_stiffness, rear_camber_stiffness : float
        Side forces by camber (N/rad) at the static loads.
    front_relaxation, rear_relaxation : float
        Relaxation lengths (m); zero for side forces without a lag.
    steering_damping : float
        (N m s/rad)

    Examples
    --------
    >>> from pydy.vehicles.two_wheelers import MOTORCYCLES
    >>> machine = MOTORCYCLES['sharp_1971']
    >>> round(machine.wheelbase, 3), machine.steering_damping
    (1.414, 6.78)
    """

    front_stiffness: float
    rear_stiffness: float
    front_camber_stiffness: float
    rear_camber_stiffness: float
    front_relaxation: float
    rear_relaxation: float
    steering_damping: float

    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = (
        "front_stiffness",
        "rear_stiffness",
        "front_relaxation",
        "rear_relaxation",
        "steering_damping",
    )


def _rotated(Ixx: float, Izz: float, tilt: float) -> tuple[float, float, float]:
    """Return Ixx, Izz and Ixz of a frame whose principal axes lean back with the steering axis."""
    c, s = cos(tilt), sin(tilt)
    return c**2 * Ixx + s**2 * Izz, s**2 * Ixx + c**2 * Izz, c * s * (Ixx - Izz)


def _of_sharp() -> Motorcycle:
    """Return the motorcycle of Sharp 1971.

    Its reference point is on the road below the mass centre of the rear frame; a is the distance
    from there to the steering axis, e that of the front frame's mass centre in front of the axis,
    f that of the same point below the foot of a along the axis, t the normal trail. The wheels have
    inertia about their axles only, other inertia is part of the frames. Pitch does not occur there:
    its moments of inertia are those of flat bodies, Ixx + Izz.
    """
    tilt, a, b, e, f, t, h = radians(27), 0.9485, 0.4798, 0.0244, 0.0283, 0.1158, 0.6157
    c, s = cos(tilt), sin(tilt)
    front_x = b + (a + e) * c + f * s
    Ixx, Izz, Ixz = _rotated(1.234, 0.442, tilt)
    return Motorcycle(
        wheelbase=b + (a - t) / c,
        trail=t / c,
        steer_axis_tilt=tilt,
        rear_frame=FrameBody(217.5, b, h, 31.18, 31.18 + 21.07, 21.07, 1.735),
        front_frame=FrameBody(30.65, front_x, (a + e) * s - f * c, Ixx, Ixx + Izz, Izz, Ixz),
        rear_wheel=WheelBody(0.3048, 0.0, 1.051),
        front_wheel=WheelBody(0.3048, 0.0, 0.7186),
        front_stiffness=11174.0,
        rear_stiffness=15831.0,
        front_camber_stiffness=938.6,
        rear_camber_stiffness=1325.6,
        front_relaxation=0.2438,
        rear_relaxation=0.2438,
        steering_damping=6.78,
    )


# J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Proc. R. Soc. A 463 (2007)
# 1955-1982, table 1; exact, with the signs of axes that point to the left and up.
BICYCLES: Mapping[str, TwoWheeler] = MappingProxyType(
    {
        "benchmark": TwoWheeler(
            wheelbase=1.02,
            trail=0.08,
            steer_axis_tilt=pi / 10,
            rear_frame=FrameBody(85.0, 0.3, 0.9, 9.2, 11.0, 2.8, -2.4),
            front_frame=FrameBody(4.0, 0.9, 0.7, 0.05892, 0.06, 0.00708, 0.00756),
            rear_wheel=WheelBody(0.3, 2.0, 0.12, 0.0603),
            front_wheel=WheelBody(0.35, 3.0, 0.28, 0.1405),
        )
    }
)

# R. S. Sharp, The stability and control of motorcycles, J. Mech. Eng. Sci. 13 (1971) 316-329, from
# feet, pounds and slugs.
MOTORCYCLES: Mapping[str, Motorcycle] = MappingProxyType({"sharp_1971": _of_sharp()})
