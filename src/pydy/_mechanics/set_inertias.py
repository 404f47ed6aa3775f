"""A warning of inertias that do not turn with their bodies.

The inertia of a rigid body is constant in the body. If it was given along the axes of another
frame, or about a point of another body, the equations contain one that changes as the mechanism
moves. The kinetic energy depends on ω_s · I ω_r, where ω_s and ω_r are partial angular velocities
or the angular velocity itself. In these products alone the inertia must be constant: that of a
rotor may be given along the axes of its bearing, and in planar motion any axes will do.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pydy._checks import describe
from pydy._errors import warn_user
from pydy._graph import jacobian
from pydy._mechanics.components import finite_rows, flat, numbers_of
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.multibody import Multibody
from pydy._rank import DIGITS

if TYPE_CHECKING:
    from sympy.physics.mechanics import RigidBody


def warn_of_changing_inertias(body: Multibody, candidates: Sequence[RigidBody]) -> None:
    """Warn of the bodies among `candidates` on whose change of inertia the equations depend."""
    try:
        k = Kinematics(body, in_bodies=False)
        changing = [item for item in candidates if _changes(k, item)]
    except (NotImplementedError, TypeError, ValueError):
        return  # functions that cannot be read here, as those of a method's own equations
    for item in changing:
        given, about = item.inertia
        frames = {f: None for _, *vectors in given.args for v in vectors for _, f in v.args}
        warn_user(
            f"The inertia of the body {item.name} changes in its frame {item.frame}: it is given "
            f"along the axes of {describe([*frames])} about {about}, which do not all move with "
            f"the body. Give it along axes and about a point of the body, as "
            f"`inertia({item.frame}, ...)`, or, if it does change, with functions of time as "
            "components."
        )


def _changes(k: Kinematics, item: RigidBody) -> bool:
    """Return whether the inertia differs between random states, as far as motions show it."""
    g = k.graph
    axes = k.frames.axes(item.frame)
    tensor = k.tensor(item.central_inertia.args, axes)
    w, _ = k.spin(item.frame, axes)
    partial = jacobian(g, w, k.speeds).dense()
    moving = [j for j in range(len(k.speeds)) if any(row[j] != g.zero for row in partial)]
    motions = [[row[j] for j in moving] + [n] for row, n in zip(partial, w, strict=True)]
    constants = [g.input("p", i) for i in range(len(k.read.constants))]
    lengths = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
    values = numbers_of(g, [*flat(tensor), *flat(motions)], lengths, common=constants)
    values = finite_rows(values)
    tensors = values[:, :9].reshape(-1, 3, 3)
    for i, columns in enumerate(values[:, 9:].reshape(len(values), 3, -1)):
        for other in tensors:
            difference = columns.T @ (tensors[i] - other) @ columns
            size = abs(columns).T @ (abs(tensors[i]) + abs(other)) @ abs(columns)
            if (abs(difference) > DIGITS * size).any():
                return True
    return False
