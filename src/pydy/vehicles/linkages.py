"""Double wishbones and McPherson struts, their curves and models."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import choice
from pydy.vehicles.hard_points import Coordinates, HardPoints, Position, orthogonal_to
from pydy.vehicles.suspension_curves import SuspensionCurves, curves_of
from pydy.vehicles.suspension_model import SuspensionModel, build

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame

    from pydy._sympy_types import Expression


class Suspension(HardPoints):
    """Hard points with the methods that users call."""

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
