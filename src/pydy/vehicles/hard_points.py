"""Hard points of independent suspensions, and the equations that close their loops."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Self, TypeAlias

import numpy as np

from pydy._checks import number, real_array, shown
from pydy._rank import ROUNDED

# A point in the axes of the body: forward, left and up (m).
Position: TypeAlias = "Sequence[float] | np.ndarray"
# Coordinates as floats, or as expressions in an array of objects.
Coordinates: TypeAlias = np.ndarray
_ANGLES = ("camber", "toe")


@dataclass(frozen=True, kw_only=True, eq=False)
class HardPoints(ABC):
    """An independent suspension with a lower arm, an upright and a tie rod."""

    lower_front: Position
    lower_rear: Position
    lower_outer: Position
    tie_rod_inner: Position
    tie_rod_outer: Position
    wheel_center: Position
    camber: float = 0.0
    toe: float = 0.0

    def __post_init__(self) -> None:
        for name in self._point_names():
            point = real_array(getattr(self, name), f"`{name}`")
            if point.shape != (3,) or not np.isfinite(point).all():
                raise ValueError(
                    f"`{name}` must be three finite coordinates, forward, left and up, got "
                    f"{shown(getattr(self, name))}."
                )
            object.__setattr__(self, name, point)
        for name in _ANGLES:
            angle = number(getattr(self, name), f"`{name}`", finite=True)
            if not abs(angle) < np.pi / 2:
                raise ValueError(f"`{name}` must be smaller than a right angle, got {angle!r}.")
            object.__setattr__(self, name, angle)
        if self.wheel_center[1] == 0.0:
            raise ValueError(
                "`wheel_center` must lie at the left (positive) or right (negative) of the middle "
                f"of the car, got {shown(self.wheel_center)}."
            )
        for one, other in self._separate():
            if _coincide(getattr(self, one), getattr(self, other)):
                raise ValueError(f"`{one}` and `{other}` must be different points.")
        for arm in self._arms():
            Hinge.of(self, arm)

    @classmethod
    def _point_names(cls) -> tuple[str, ...]:
        return tuple(f.name for f in fields(cls) if f.type == "Position")

    @classmethod
    def _arms(cls) -> tuple[str, ...]:
        return ("lower",)

    @classmethod
    @abstractmethod
    def _separate(cls) -> tuple[tuple[str, str], ...]:
        """Return pairs of points that a length or a direction lies between."""

    @abstractmethod
    def closure(self, outer: Coordinates, rotation: Coordinates, rack: Any = 0) -> list[Any]:
        """Return lengths (m) that vanish where the loops are closed.

        They are quadratic in the coordinates of the lower ball joint and of the rotation matrix of
        the upright, floats or expressions.
        """

    @property
    @abstractmethod
    def steering_axis_top(self) -> str:
        """Name of the upper point of the steering axis."""

    @property
    @abstractmethod
    def spring_ends(self) -> tuple[str, str, str]:
        """The part with the moving end of the spring, and the names of both ends."""

    @property
    def side(self) -> int:
        """1 at the left of the car, −1 at the right."""
        return 1 if self.wheel_center[1] > 0.0 else -1

    @property
    def axis(self) -> np.ndarray:
        """Unit vector along the wheel's axle, to the left, where the wheel does not travel."""
        s, (sin_toe, cos_toe) = self.side, (np.sin(self.toe), np.cos(self.toe))
        sin, cos = np.sin(self.camber), np.cos(self.camber)
        return np.array([s * sin_toe * cos, cos_toe * cos, -s * sin])

    def mirrored(self) -> Self:
        """Return the suspension of the other side.

        Returns
        -------
        DoubleWishbone or McPherson
        """
        flip = np.array([1.0, -1.0, 1.0])
        return replace(self, **{name: getattr(self, name) * flip for name in self._point_names()})

    def moved(self, name: str, outer: Coordinates, rotation: Coordinates) -> Coordinates:
        """Return a point of the upright, which has turned about the lower ball joint."""
        point: Coordinates = outer + rotation @ (getattr(self, name) - self.lower_outer)
        return point

    def _length_error(
        self, name: str, inner: str, outer: Coordinates, rotation: Coordinates, rack: Any = 0
    ) -> Any:
        """Return by how much the distance of a point of the upright from one of the body differs.

        It is (d² − L²)/(2 L), which is quadratic in the coordinates.
        """
        fixed = getattr(self, inner) + np.array([0, 1, 0]) * rack
        apart = self.moved(name, outer, rotation) - fixed
        length = float(np.linalg.norm(getattr(self, name) - getattr(self, inner)))
        return (sum(d * d for d in apart) - length**2) / (2 * length)


@dataclass(frozen=True)
class Hinge:
    """The hinge of an arm: the foot of its outer point on the axis, and the radius to it."""

    foot: np.ndarray
    axis: np.ndarray
    radius: np.ndarray

    @classmethod
    def of(cls, suspension: HardPoints, arm: str) -> Hinge:
        """Return the hinge of the lower or upper arm; positive angles raise the outer point."""
        front, rear, outer = (
            getattr(suspension, f"{arm}_{end}") for end in ("front", "rear", "outer")
        )
        if _coincide(front, rear):
            raise ValueError(f"`{arm}_front` and `{arm}_rear` must be different points.")
        axis = (front - rear) / np.linalg.norm(front - rear)
        foot = rear + axis * (outer - rear).dot(axis)
        if _coincide(outer, foot):
            raise ValueError(
                f"`{arm}_outer` must not lie on the line of `{arm}_front` and `{arm}_rear`, which "
                "is the hinge axis of the arm."
            )
        radius = outer - foot
        return cls(foot, axis if np.cross(axis, radius)[2] >= 0.0 else -axis, radius)

    def outer(self, cos: Any, sin: Any) -> Coordinates:
        """Return the outer point where the arm has turned."""
        point: Coordinates = self.foot + self.radius * cos
        rotated: Coordinates = point + np.cross(self.axis, self.radius) * sin
        return rotated


def orthogonal_to(direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return two unit vectors that are orthogonal to a direction and to each other."""
    along = direction / np.linalg.norm(direction)
    least = np.eye(3)[int(np.argmin(np.abs(along)))]
    first = np.cross(along, least)
    first /= np.linalg.norm(first)
    return first, np.cross(along, first)


def _coincide(one: np.ndarray, other: np.ndarray) -> bool:
    """Return whether points differ by the rounding of their coordinates alone."""
    bound = ROUNDED * max(np.abs(one).max(), np.abs(other).max())
    return bool(np.abs(one - other).max() <= bound)
