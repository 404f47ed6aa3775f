"""A warning of accelerations that the user set, and that are not the derivatives of velocities.

The equations contain them as they were set, by `a2pt_theory` with another frame for example, or
from the contact point of a wheel, or before a velocity was changed. Not checked are mechanisms with
constraints, which may have been used to shorten them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import describe
from pydy._errors import warn_user
from pydy._graph import rounding_bounds
from pydy._mechanics.components import consistent_numbers, finite_rows
from pydy._mechanics.formulations import moving
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._rank import DIGITS

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame


def warn_of_set_accelerations(
    body: Multibody, points: Sequence[Point], frames: Sequence[ReferenceFrame]
) -> None:
    """Warn of the accelerations of points, and angular accelerations of frames, that were set.

    There must be no velocity constraints.
    """
    try:
        k = moving(body, in_bodies=False, further_points=points)
        pairs: dict[Point | ReferenceFrame, tuple[Vec, Vec]] = {}
        for point in dict.fromkeys(points):
            pairs[point] = k.acceleration(point), k.motion(point)[2]
        for frame in dict.fromkeys(frames):
            derived = k.spin(frame, k.inertial)[1]
            pairs[frame] = k.angular_acceleration(frame, k.inertial), derived
    except (NotImplementedError, TypeError, ValueError):
        return  # functions that cannot be read here, as those of a method's own equations
    zero_rows = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
    wrong = [item for item, sides in pairs.items() if _differ(k, *sides, zero_rows)]
    if wrong:
        warn_user(
            f"The accelerations that were set for {describe(wrong)} are not the derivatives of the "
            "velocities, and the equations contain them as they are. Set none: they are derived "
            "then. (`a2pt_theory` needs points that are fixed in the frame, as the point where a "
            "wheel touches is not.)"
        )


def _differ(k: Kinematics, as_set: Vec, derived: Vec, zero_rows: list[int]) -> bool:
    differences = [k.graph.sub(a, b) for a, b in zip(as_set, derived, strict=True)]
    bounds = rounding_bounds(k.graph, differences, constants=True)
    values = finite_rows(consistent_numbers(k.graph, [*differences, *bounds], zero_rows))
    sizes, magnitudes = np.split(np.abs(values), 2, axis=1)
    return bool((sizes > DIGITS * magnitudes).any())
