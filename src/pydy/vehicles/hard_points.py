"""Hard points of independent suspensions, and the equations that close their loops."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Self, TypeAlias

import numpy as np

from pydy._checks import choice, number, real_array, shown
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame

    from pydy._sympy_types import Expression
    from pydy.vehicles.suspension_curves import SuspensionCurves
    from pydy.vehicles.suspension_model import SuspensionModel

# A point in the axes of the body: forward, left and up (m).
Position: TypeAlias = "Sequence[float] | np.ndarray"
# Coordinates as floats, or as expressions in an array of objects.
Coordinates: TypeAlias = np.ndarray
_ANGLES = ("camber", "toe")


@dataclass(frozen=True, kw_only=True, eq=False)
class Suspension(ABC):
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

    def curves(
        self, travel: float | Sequence[float], radius: float, *, rack: float = 0.0
    ) -> SuspensionCurves:
        """Return the kinematic curves over the travel of the wheel, relative to a fixed body.

        Parameters
        ----------
        travel : float or sequence of float
            Vertical displacements (m) of the wheel's center, positive in bump.
        radius : float
            Distance (m) from the wheel's center to the road, within the wheel plane.
        rack : float, optional
            Displacement (m) of the steering rack, to the left.

        Returns
        -------
        SuspensionCurves

        Raises
        ------
        ValueError
            The suspension does not reach a travel.
        """
        from pydy.vehicles.suspension_curves import curves_of

        return curves_of(self, travel, radius, rack)

    def build(
        self,
        body: ReferenceFrame,
        origin: Point,
        frame: ReferenceFrame,
        *,
        name: str,
        upright_mass: Expression | float,
        upright_inertia: Sequence[Expression | float],
        wheel_mass: Expression | float,
        wheel_inertia: Sequence[Expression | float],
        force: Callable[[Expression, Expression], Expression | float] | None = None,
        arm_masses: Sequence[Expression | float] = (0.0, 0.0),
        rack: Expression | float = 0.0,
    ) -> SuspensionModel:
        """Return bodies, joints, constraints and loads for a `pydy.mechanics.Definition`.

        The lower arm turns in the body, the upright turns on its ball joint; further joints are
        holonomic constraints. All coordinates are zero in the position of the hard points.

        Parameters
        ----------
        body : ReferenceFrame
            The car's body: x forward, y to the left, z up.
        origin : Point
            Point of the body that the hard points are measured from, with a velocity in `frame`.
        frame : ReferenceFrame
            The inertial frame.
        name : str
            Begins the names of coordinates, bodies and frames.
        upright_mass : number or expression
            (kg), with its center at the wheel's center; 0 for none.
        upright_inertia : three numbers or expressions
            Moments of inertia (kg m²) about the axes of the body.
        wheel_mass : number or expression
            (kg).
        wheel_inertia : pair of numbers or expressions
            Moments of inertia (kg m²) about the axle and about a diameter.
        force : callable, optional
            ``force(deflection, rate)`` returns the force (N) by which spring and damper push their
            ends apart, from the compression (m) since the position of the hard points and its rate
            (m/s). By default there is none.
        arm_masses : pair of numbers or expressions, optional
            Of the lower and the upper arm (kg), as thin plates between their three points. A
            McPherson strut has no upper arm.
        rack : number or expression, optional
            Displacement (m) of the steering rack, to the left: of time and coordinates.

        Returns
        -------
        SuspensionModel
        """
        from pydy.vehicles.suspension_model import build

        return build(
            self,
            body,
            origin,
            frame,
            name=name,
            upright=(upright_mass, upright_inertia),
            wheel=(wheel_mass, wheel_inertia),
            force=force,
            arm_masses=arm_masses,
            rack=rack,
        )

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


@dataclass(frozen=True, kw_only=True, eq=False)
class DoubleWishbone(Suspension):
    """A double wishbone: two arms, an upright between their ball joints, and a tie rod.

    Points are in the axes of the body, x forward, y to the left and z up, from any origin in the
    middle of the car. Those of a right wheel have negative y.

    Parameters
    ----------
    lower_front, lower_rear : three floats
        On the hinge axis of the lower arm in the body (m).
    lower_outer : three floats
        The ball joint of the lower arm and the upright.
    upper_front, upper_rear, upper_outer : three floats
        The same of the upper arm.
    tie_rod_inner, tie_rod_outer : three floats
        Ends of the tie rod at the body or the rack, and at the upright.
    spring_inner, spring_outer : three floats
        Ends of spring and damper at the body, and at the moving part.
    wheel_center : three floats
    camber, toe : float, optional
        Static angles (rad) of the wheel: camber is positive if the top leans outwards, toe if the
        front points inwards.
    spring_on : {'lower_arm', 'upright'}, optional
        The part that carries `spring_outer`.

    References
    ----------
    W. F. Milliken, D. L. Milliken, Race Car Vehicle Dynamics, SAE, 1995, chapter 17.

    Examples
    --------
    Parallel arms of one length keep the camber, and the roll center is on the road:

    >>> from pydy.vehicles.suspensions import DoubleWishbone
    >>> left = DoubleWishbone(
    ...     lower_front=(0.15, 0.3, 0.2), lower_rear=(-0.15, 0.3, 0.2), lower_outer=(0, 0.7, 0.2),
    ...     upper_front=(0.15, 0.3, 0.45), upper_rear=(-0.15, 0.3, 0.45),
    ...     upper_outer=(0, 0.7, 0.45), tie_rod_inner=(-0.1, 0.3, 0.25),
    ...     tie_rod_outer=(-0.1, 0.7, 0.25), wheel_center=(0, 0.75, 0.32),
    ...     spring_inner=(0, 0.45, 0.6), spring_outer=(0, 0.55, 0.2))
    >>> curves = left.curves([-0.05, 0.0, 0.05], radius=0.32)
    >>> bool(abs(curves.camber).max() < 1e-12), float(curves.roll_center_height[1].round(9))
    (True, 0.0)
    >>> float(curves.motion_ratio[1].round(4))
    0.6063
    """

    upper_front: Position
    upper_rear: Position
    upper_outer: Position
    spring_inner: Position
    spring_outer: Position
    spring_on: str = "lower_arm"

    def __post_init__(self) -> None:
        super().__post_init__()
        carrier = choice(self.spring_on, ("lower_arm", "upright"), "`spring_on`")
        object.__setattr__(self, "spring_on", carrier)

    @classmethod
    def _arms(cls) -> tuple[str, ...]:
        return ("lower", "upper")

    @classmethod
    def _separate(cls) -> tuple[tuple[str, str], ...]:
        return (
            ("tie_rod_inner", "tie_rod_outer"),
            ("spring_inner", "spring_outer"),
            ("lower_outer", "upper_outer"),
        )

    @property
    def steering_axis_top(self) -> str:
        """Name of the upper point of the steering axis."""
        return "upper_outer"

    @property
    def spring_ends(self) -> tuple[str, str, str]:
        """The part with the moving end of the spring, and the names of both ends."""
        return self.spring_on, "spring_outer", "spring_inner"

    def closure(self, outer: Coordinates, rotation: Coordinates, rack: Any = 0) -> list[Any]:
        """Return by how much the lengths of the upper arm's sides and of the tie rod differ."""
        return [
            self._length_error("upper_outer", "upper_front", outer, rotation),
            self._length_error("upper_outer", "upper_rear", outer, rotation),
            self._length_error("tie_rod_outer", "tie_rod_inner", outer, rotation, rack),
        ]


@dataclass(frozen=True, kw_only=True, eq=False)
class McPherson(Suspension):
    """A McPherson strut: a lower arm, an upright with a sliding strut, and a tie rod.

    The axis of the strut is fixed in the upright and passes through its mount in the body; spring
    and damper act along it. Points are those of `DoubleWishbone`.

    Parameters
    ----------
    lower_front, lower_rear : three floats
        On the hinge axis of the lower arm in the body (m).
    lower_outer : three floats
        The ball joint of the lower arm and the upright.
    strut_top, strut_bottom : three floats
        The mount of the strut in the body, and the point of the upright at its lower end.
    tie_rod_inner, tie_rod_outer : three floats
        Ends of the tie rod at the body or the rack, and at the upright.
    wheel_center : three floats
    camber, toe : float, optional
        As for `DoubleWishbone`.

    References
    ----------
    J. Reimpell, H. Stoll, J. W. Betzler, The Automotive Chassis: Engineering Principles, 2nd ed.,
    Butterworth-Heinemann, 2001, sections 1.4 and 3.4.

    Examples
    --------
    >>> from pydy.vehicles.suspensions import McPherson
    >>> left = McPherson(
    ...     lower_front=(0.15, 0.35, 0.2), lower_rear=(-0.15, 0.35, 0.2),
    ...     lower_outer=(0, 0.7, 0.18), strut_top=(-0.02, 0.58, 0.85),
    ...     strut_bottom=(0, 0.64, 0.4), tie_rod_inner=(-0.12, 0.38, 0.26),
    ...     tie_rod_outer=(-0.12, 0.68, 0.25), wheel_center=(0, 0.75, 0.3))
    >>> left.curves([0.0], radius=0.3).motion_ratio.round(3)
    array([0.962])
    """

    strut_top: Position
    strut_bottom: Position

    @classmethod
    def _separate(cls) -> tuple[tuple[str, str], ...]:
        return (("tie_rod_inner", "tie_rod_outer"), ("strut_top", "strut_bottom"))

    @property
    def steering_axis_top(self) -> str:
        """Name of the upper point of the steering axis."""
        return "strut_top"

    @property
    def spring_ends(self) -> tuple[str, str, str]:
        """The part with the moving end of the spring, and the names of both ends."""
        return "upright", "strut_bottom", "strut_top"

    def closure(self, outer: Coordinates, rotation: Coordinates, rack: Any = 0) -> list[Any]:
        """Return distances of the mount from the strut's axis, and the error of the tie rod."""
        top = np.asarray(self.strut_top)
        normals = orthogonal_to(top - np.asarray(self.strut_bottom))
        apart = top - self.moved("strut_bottom", outer, rotation)
        return [
            *((rotation @ normal) @ apart for normal in normals),
            self._length_error("tie_rod_outer", "tie_rod_inner", outer, rotation, rack),
        ]


@dataclass(frozen=True)
class Hinge:
    """The hinge of an arm: the foot of its outer point on the axis, and the radius to it."""

    foot: np.ndarray
    axis: np.ndarray
    radius: np.ndarray

    @classmethod
    def of(cls, suspension: Suspension, arm: str) -> Hinge:
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
