"""Where a wheel touches a plane: a thin disc, a torus, or a cylinder with a flat tread."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sm
from sympy.physics.mechanics import Vector

from pydy.vehicles.algebra import Operand
from pydy.vehicles.tuning import SMALLEST_DEFLECTION
from pydy.vehicles.vectors import cross, dot

if TYPE_CHECKING:
    from pydy._sympy_types import Expression


@dataclass(frozen=True)
class WheelMotion:
    """A wheel above a plane: its place and its motion relative to the plane.

    Attributes
    ----------
    position : Vector
        Of the centre, from a point of the plane.
    velocity, rotation : Vector
        Of the wheel relative to the plane, and in the inertial frame.
    axis, normal, turning : Vector
        Of the axle, of the plane, and the time derivative of the plane's normal.
    """

    position: Vector
    velocity: Vector
    rotation: Vector
    axis: Vector
    normal: Vector
    turning: Vector | None

    @property
    def lean(self) -> Expression:
        """Sine of the camber angle, positive if the top leans to the right."""
        return dot(self.axis, self.normal)

    @property
    def lean_rate(self) -> Expression:
        """Time derivative of the lean."""
        rate = dot(cross(self.rotation, self.axis), self.normal)
        return rate if self.turning is None else rate + dot(self.axis, self.turning)

    def rate_of(self, offset: Vector) -> Expression:
        """Return the rate of the distance of the lowest point, which is at an offset."""
        rate = dot(self.velocity + cross(self.rotation, offset), self.normal)
        return rate if self.turning is None else rate + dot(self.position + offset, self.turning)


@dataclass(frozen=True)
class Touch:
    """The gap of a wheel, its rate, and the contact point C from the centre.

    `rim` is the point that C becomes where the wheel is not deflected. `clearance` is the height of
    the lowest point of the undeformed wheel: it crosses zero with a slope where the wheel touches,
    while the mean deflection of a cambered tread begins with the square.
    """

    gap: Expression
    rate: Expression
    contact: Vector
    rim: Vector
    clearance: Expression


def touch_of_torus(
    wheel: WheelMotion, radius: Operand, crown: Operand, upright: Expression, down: Vector
) -> Touch:
    """Return where a torus touches; a thin disc is one with the crown radius 0.

    The deflection is along the wheel plane: C lies on the ground at any camber.
    """
    height = dot(wheel.position, wheel.normal)
    gap = height - (radius - crown) * upright - crown
    lowest = (radius - crown) * down - crown * wheel.normal
    return Touch(gap, wheel.rate_of(lowest), lowest + gap / upright * down, lowest, gap)


def touch_of_cylinder(
    wheel: WheelMotion, radius: Operand, width: Operand, upright: Expression, down: Vector
) -> Touch:
    """Return where a cylinder touches, with the mean of its deflection over the width.

    Across the tread the deflection is −gap₀ − y sin γ: a trapezoid, or a triangle if an edge lifts.
    C is in its centroid.
    """
    lean, height = wheel.lean, dot(wheel.position, wheel.normal)
    slope = sm.Abs(lean, evaluate=False)
    side = sm.sign(lean, evaluate=False)
    middle = height - radius * upright
    middle_rate = wheel.rate_of(radius * down)
    # The deflection of the edge that is deeper.
    edge = slope * width / 2 - middle
    slope_rate = side * wheel.lean_rate
    edge_rate = slope_rate * width / 2 - middle_rate
    whole = sm.Ge(edge, slope * width, evaluate=False)
    touching = sm.Gt(edge, 0, evaluate=False)

    def chosen(full: Expression, partial: Expression, lifted: Expression) -> Expression:
        return sm.Piecewise((full, whole), (partial, touching), (lifted, True), evaluate=False)

    shallow = SMALLEST_DEFLECTION * radius
    share = edge / sm.Max(slope * width, shallow, evaluate=False)
    share = sm.Min(sm.Max(share, 0, evaluate=False), 1, evaluate=False)  # of the width that touches
    gap = chosen(middle, -share * edge / 2, -edge)
    rate = chosen(middle_rate, share * (share * slope_rate * width / 2 - edge_rate), -edge_rate)
    across = chosen(
        -lean * width**2 / (12 * sm.Max(-middle, shallow, evaluate=False)),
        side * width * (share / 3 - sm.S.Half),
        -side * width / 2,
    )
    touched = radius * down + across * wheel.axis
    contact = touched + (middle + across * lean) / upright * down
    return Touch(gap, rate, contact, touched, -edge)
