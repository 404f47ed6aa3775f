"""Elastic elements between bodies: bushings and anti-roll bars."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector

from pydy._checks import instance, shown
from pydy.vehicles.forces import checked_parameters
from pydy.vehicles.wheel_arguments import check_unit

if TYPE_CHECKING:
    from pydy._sympy_types import Expression, Load

_NONE = (0.0, 0.0, 0.0)


def bushing_loads(
    first: tuple[ReferenceFrame, Point],
    second: tuple[ReferenceFrame, Point],
    frame: ReferenceFrame,
    *,
    stiffness: Sequence[Expression | float] = _NONE,
    damping: Sequence[Expression | float] = _NONE,
    torsional_stiffness: Sequence[Expression | float] = _NONE,
    torsional_damping: Sequence[Expression | float] = _NONE,
) -> list[Load]:
    """Return the loads of a bushing, an elastic element with six degrees of freedom.

    Displacements d are those of the second point from the first one, along the axes x, y, z of the
    first frame. Angles φ are the Cardan angles of the second frame: about the first frame's x, the
    new y, and the second frame's z. The second body has the force and the moments ::

        F_i = −k_i d_i − c_i d_i'    M_i = −κ_i φ_i − γ_i φ_i'

    where M_i has the power M_i φ_i'. The first body has their opposites, at the second point: both
    momenta are balanced, and without damping the energy Σ k_i d_i²/2 + Σ κ_i φ_i²/2 is stored, also
    at large displacements and angles. Preloads are forces and moments to add.

    Parameters
    ----------
    first, second : pair of ReferenceFrame and Point
        Axes and centre of the bushing in each body, with velocities in `frame`. Without a load the
        points coincide and the frames are parallel.
    frame : ReferenceFrame
        The inertial frame.
    stiffness, damping : three numbers or expressions, optional
        k (N/m) and c (N s/m).
    torsional_stiffness, torsional_damping : three numbers or expressions, optional
        κ (N m/rad) and γ (N m s/rad).

    Returns
    -------
    list of pairs
        Of points and forces, and of frames and torques, for `pydy.mechanics.Definition`.

    Notes
    -----
    Cardan angles are singular where the second one is a right angle.

    References
    ----------
    W. Schiehlen, P. Eberhard, Applied Dynamics, Springer, 2014, section 2.1, for Cardan angles.

    M. Blundell, D. Harty, The Multibody Systems Approach to Vehicle Dynamics, 2nd ed.,
    Butterworth-Heinemann, 2015, section 3.2.5, for bushings.

    Examples
    --------
    A rod turns by 0.1 rad in a bushing of 200 N m/rad about its axis:

    >>> import sympy.physics.mechanics as me
    >>> from pydy.vehicles.machines import bushing_loads
    >>> q = me.dynamicsymbols('q')
    >>> N, B, O = me.ReferenceFrame('N'), me.ReferenceFrame('B'), me.Point('O')
    >>> O.set_vel(N, 0)
    >>> B.orient_axis(N, N.x, q)
    >>> loads = bushing_loads((N, O), (B, O), N, stiffness=[1e6, 1e6, 1e5],
    ...                       torsional_stiffness=[200, 4000, 4000])
    >>> torque = dict(loads)[B]
    >>> round(float(torque.dot(N.x).subs(q, 0.1)), 9)
    -20.0
    """
    (A, P), (B, Q) = _fixed(first, "first"), _fixed(second, "second")
    instance(frame, ReferenceFrame, "`frame`")
    triples = {
        "stiffness": stiffness,
        "damping": damping,
        "torsional_stiffness": torsional_stiffness,
        "torsional_damping": torsional_damping,
    }
    k, c, kappa, gamma = (_triple(value, name) for name, value in triples.items())
    apart = Q.pos_from(P)
    rate = Q.vel(frame) - P.vel(frame) - A.ang_vel_in(frame).cross(apart)
    force = Vector(0)
    for axis, spring, damper in zip(A, k, c, strict=True):
        force -= (spring * apart.dot(axis) + damper * rate.dot(axis)) * axis
    torque = _torque(A, B, kappa, gamma)
    return [
        (Q, force),
        (P, -force),
        (B, torque),
        (A, -torque - apart.cross(force)),
    ]


def _torque(
    A: ReferenceFrame, B: ReferenceFrame, stiffness: list[Any], damping: list[Any]
) -> Vector:
    """Return the torque on B whose power with each rate of a Cardan angle is that of its moment."""
    if not any(stiffness) and not any(damping):
        return Vector(0)
    along = A.x.dot(B.z)  # sin φ_2
    square = 1 - along**2
    angles = (
        sm.atan2(-A.y.dot(B.z), A.z.dot(B.z)),
        sm.asin(along),
        sm.atan2(-A.x.dot(B.y), A.x.dot(B.x)),
    )
    # Dual to the axes of rotation, A.x, the line of nodes and B.z, the first and last of which are
    # not orthogonal.
    dual = (
        (A.x - along * B.z) / square,
        B.z.cross(A.x) / sm.sqrt(square),
        (B.z - along * A.x) / square,
    )
    turning = B.ang_vel_in(A)
    torque = Vector(0)
    for axis, angle, spring, damper in zip(dual, angles, stiffness, damping, strict=True):
        moment = spring * angle + (damper * turning.dot(axis) if damper else 0)
        if moment != 0:
            torque -= moment * axis
    return torque


def anti_roll_bar_loads(
    left: Point,
    right: Point,
    up: Vector,
    body: ReferenceFrame,
    *,
    stiffness: Expression | float,
) -> list[Load]:
    """Return the loads of an anti-roll bar between two wheels, which turns in its body.

    The left end has the force −k (z_l − z_r) and the right one its opposite, along `up`, with the
    heights z of the ends in the body. The body has the couple that balances them. When both wheels
    move alike there is no load.

    Parameters
    ----------
    left, right : Point
        Ends of the drop links, at the wheel carriers or arms, level when the bar has no load.
    up : Vector
        Unit vector, fixed in the body.
    body : ReferenceFrame
        The frame of the body that carries the bar.
    stiffness : number or expression
        k (N/m), such as that of `torsion_bar_stiffness`. On a track T it resists roll with the
        stiffness k T² (N m/rad), if the ends are at the wheels.

    Returns
    -------
    list of pairs
        Of both points and their forces, and of the body's frame and the torque.

    References
    ----------
    J. Reimpell, H. Stoll, J. W. Betzler, The Automotive Chassis: Engineering Principles, 2nd ed.,
    Butterworth-Heinemann, 2001, section 5.3.

    Examples
    --------
    >>> import sympy.physics.mechanics as me
    >>> from pydy.vehicles.machines import anti_roll_bar_loads
    >>> N, O = me.ReferenceFrame('N'), me.Point('O')
    >>> left, right = O.locatenew('L', 0.7*N.y + 0.02*N.z), O.locatenew('R', -0.7*N.y)
    >>> anti_roll_bar_loads(left, right, N.z, N, stiffness=2e4)[2]
    (N, 560.0*N.x)
    """
    instance(left, Point, "`left`")
    instance(right, Point, "`right`")
    check_unit("up", up)
    instance(body, ReferenceFrame, "`body`")
    k = checked_parameters({"stiffness": stiffness}, not_negative=("stiffness",))["stiffness"]
    apart = left.pos_from(right)
    force = k * apart.dot(up) * up
    return [(left, -force), (right, force), (body, apart.cross(force))]


def torsion_bar_stiffness(
    diameter: Expression | float,
    length: Expression | float,
    arm: Expression | float,
    *,
    shear_modulus: Expression | float = 79e9,
    inner_diameter: Expression | float = 0.0,
) -> Expression | float:
    """Return the stiffness of an anti-roll bar at its ends: a round bar with rigid arms.

    A difference z of the heights of the ends twists the bar by z/a, and each end has the force
    k z, with k = G π (d⁴ − d_i⁴)/(32 L a²).

    Parameters
    ----------
    diameter, inner_diameter : number or expression
        d and d_i (m), the latter of a tube.
    length : number or expression
        L (m), of the part that is twisted.
    arm : number or expression
        a (m), of both arms.
    shear_modulus : number or expression, optional
        G (Pa), by default that of steel.

    Returns
    -------
    number or expression
        k (N/m).

    References
    ----------
    R. G. Budynas, J. K. Nisbett, Shigley's Mechanical Engineering Design, 10th ed., McGraw-Hill,
    2015, section 3-12.

    Examples
    --------
    >>> from pydy.vehicles.machines import torsion_bar_stiffness
    >>> round(torsion_bar_stiffness(0.02, 1.0, 0.25))
    19855
    """
    values = checked_parameters(
        {
            "diameter": diameter,
            "length": length,
            "arm": arm,
            "shear_modulus": shear_modulus,
            "inner_diameter": inner_diameter,
        },
        positive=("diameter", "length", "arm", "shear_modulus"),
        not_negative=("inner_diameter",),
    )
    d, L, a, G, hole = values.values()
    if isinstance(d, float) and isinstance(hole, float) and not hole < d:
        raise ValueError(
            f"`inner_diameter` must be smaller than `diameter`, got {hole!r} and {d!r}."
        )
    area_moment = (sm.pi if isinstance(d, sm.Basic) else float(sm.pi)) * (d**4 - hole**4) / 32
    return G * area_moment / (L * a**2)


def _fixed(pair: Any, name: str) -> tuple[ReferenceFrame, Point]:
    if not (
        isinstance(pair, tuple)
        and len(pair) == 2
        and isinstance(pair[0], ReferenceFrame)
        and isinstance(pair[1], Point)
    ):
        raise TypeError(
            f"`{name}` must be a pair of a ReferenceFrame and a Point, got {shown(pair)}."
        )
    return pair


def _triple(values: Any, name: str) -> list[Any]:
    if not isinstance(values, (list, tuple)) or len(values) != 3:
        raise TypeError(
            f"`{name}` must be three numbers or expressions, along x, y and z, got {shown(values)}."
        )
    named = {f"{name}[{i}]": value for i, value in enumerate(values)}
    return [
        sm.sympify(0) if value == 0 else value
        for value in checked_parameters(named, not_negative=tuple(named)).values()
    ]
