"""Drag and downforce of the air on a vehicle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector

from pydy._checks import instance
from pydy.vehicles.forces import checked_parameters
from pydy.vehicles.wheel_arguments import check_unit

if TYPE_CHECKING:
    from pydy._sympy_types import Expression, Load

AIR_DENSITY = 1.2041  # kg/m³, at 20 °C and 101.325 kPa


def aerodynamic_loads(
    point: Point,
    forward: Vector,
    up: Vector,
    frame: ReferenceFrame,
    *,
    drag_area: Expression | float,
    lift_area: Expression | float = 0.0,
    density: Expression | float = AIR_DENSITY,
) -> list[Load]:
    """Return the load of the air on a vehicle that moves through it, by its forward speed.

    With the speed u of the point along `forward` it has the components ::

        F_forward = −½ ρ c_d A u |u|    F_up = ½ ρ c_l A u²

    Parameters
    ----------
    point : Point
        The centre of pressure, with a velocity in `frame`.
    forward, up : Vector
        Unit vectors of the vehicle.
    frame : ReferenceFrame
        In which the air is at rest.
    drag_area : number or expression
        c_d A (m²).
    lift_area : number or expression, optional
        c_l A (m²), negative for downforce.
    density : number or expression, optional
        ρ (kg/m³), by default that of dry air at 20 °C.

    Returns
    -------
    list of one
        The pair of the point and the force, for `pydy.mechanics.Definition`.

    Examples
    --------
    >>> import sympy.physics.mechanics as me
    >>> from pydy.vehicles.machines import aerodynamic_loads
    >>> u = me.dynamicsymbols('u')
    >>> N, P = me.ReferenceFrame('N'), me.Point('P')
    >>> P.set_vel(N, u*N.x)
    >>> ((_, force),) = aerodynamic_loads(P, N.x, N.z, N, drag_area=0.6, density=1.2)
    >>> force.dot(N.x).subs(u, 50.0)
    -900.000000000000
    """
    instance(point, Point, "`point`")
    check_unit("forward", forward)
    check_unit("up", up)
    instance(frame, ReferenceFrame, "`frame`")
    values = checked_parameters(
        {"drag_area": drag_area, "lift_area": lift_area, "density": density},
        positive=("density",),
        not_negative=("drag_area",),
    )
    half = sm.sympify(values["density"]) / 2
    u = point.vel(frame).dot(forward)
    drag = half * values["drag_area"] * u * sm.Abs(u)
    lift = half * values["lift_area"] * u**2
    return [(point, lift * up - drag * forward)]
