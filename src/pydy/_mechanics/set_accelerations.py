"""A warning of accelerations that the user set, and that are not the derivatives of velocities.

The equations contain them as they were set, by `a2pt_theory` with another frame for example, or
from the contact point of a wheel, or before a velocity was changed. With constraints, positions and
velocities in them may have been shortened, so that they are compared at assembled states; u' may
not be, since the equations add what the constraints say of it. A Lagrangian's derivatives
contain no acceleration.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pydy._checks import describe
from pydy._errors import warn_user
from pydy._graph import jacobian
from pydy._mechanics.components import dot, nonzero_somewhere
from pydy._mechanics.formulations import moving
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody

    from pydy._sympy_types import Body


def warn_of_set_accelerations(
    body: Multibody, moved: Sequence[Body], turned: Sequence[RigidBody]
) -> None:
    """Warn of accelerations of mass centres and frames if the equations depend on the difference.

    Those of the mass centres of `moved`, and of the frames of `turned`, were set. The equations
    contain inertia along partial velocities alone: differences across these do no harm.
    """
    try:
        k = moving(body, in_bodies=False, further_points=[item.masscenter for item in moved])
        forces: dict[Point | ReferenceFrame, list[int]] = {}
        for item in moved:
            point = item.masscenter
            _, v, a = k.motion(point)
            forces[point] = _forces(k, v, k.acceleration(point), a)
        for item in turned:
            w, alpha = k.spin(item.frame, k.inertial)
            tensor = k.tensor(item.central_inertia.args, k.inertial)
            as_set = k.angular_acceleration(item.frame, k.inertial)
            sides = (k.product(tensor, part) for part in (as_set, alpha))
            forces[item.frame] = _forces(k, w, *sides)
    except (NotImplementedError, TypeError, ValueError):
        return  # functions that cannot be read here, as those of a method's own equations
    zero_rows = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
    zero_rows += k.read.all((*body.constraints.holonomic, *body.constraints.velocity))
    nodes = [n for of_one in forces.values() for n in of_one]
    differ = nonzero_somewhere(k.graph, nodes, zero_rows).reshape(-1, len(k.speeds))
    wrong = [where for where, along in zip(forces, differ, strict=True) if along.any()]
    if wrong:
        warn_user(
            f"The accelerations that were set for {describe(wrong)} are not the derivatives of the "
            "velocities, and the equations contain them as they are. Set none: they are derived "
            "then. (`a2pt_theory` needs points that are fixed in the frame, as the point where a "
            "wheel touches is not.)"
        )


def _forces(k: Kinematics, velocity: Vec, as_set: Vec, derived: Vec) -> list[int]:
    """Return the difference of two inertia forces, or torques, along each partial velocity.

    For a force, the accelerations stand for it: the factor, the mass, is left out.
    """
    difference = [k.graph.sub(a, b) for a, b in zip(as_set, derived, strict=True)]
    partial = jacobian(k.graph, velocity, k.speeds).dense()
    return [dot(k.graph, column, difference) for column in zip(*partial, strict=True)]
