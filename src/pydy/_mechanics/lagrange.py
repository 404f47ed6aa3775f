"""Read a LagrangesMethod. The only module that touches its underscore attributes."""

from __future__ import annotations

from typing import Any

from sympy.physics.mechanics import LagrangesMethod, ReferenceFrame, dynamicsymbols

from pydy._mechanics.equations import Equations
from pydy._mechanics.lagrangian import form_lagrangian
from pydy._mechanics.reader import Multibody, read_loads

__all__ = ["equations_of_lagrange"]


def equations_of_lagrange(method: LagrangesMethod, source: str | None = None) -> Equations:
    """Return the equations of a LagrangesMethod. The speeds are the derivatives q'.

    Parameters
    ----------
    method : LagrangesMethod
    source : {'graph', 'method'}, optional
        Whether the equations are formed from the Lagrangian, which is the default, or those of
        ``form_lagranges_equations()``.

    Raises
    ------
    ValueError
        There are constraints, loads without a frame, or no equations where the method's own are
        asked for.
    """
    if method.coneqs:
        raise ValueError(
            "`eom_method` is a LagrangesMethod with constraints, whose multipliers System does not "
            "solve for. Use a KanesMethod with `velocity_constraints`, or coordinates that satisfy "
            "the constraints."
        )
    if method.forcelist and method.inertial is None:
        raise ValueError(
            "`eom_method` has a `forcelist` but no `frame`: give LagrangesMethod the inertial "
            "frame in which velocities are taken."
        )
    t = dynamicsymbols._t
    coordinates, rates = tuple(method.q), tuple(method._qdots)
    matrix: Any = ()
    forcing: tuple[Any, ...] = ()
    formed = None
    if source == "method":
        if method.eom is None:
            raise ValueError(
                "`equations='method'` needs the equations of `eom_method`: call its "
                "`form_lagranges_equations()` before it is handed to System."
            )
        matrix, forcing = method.mass_matrix, tuple(method.forcing)
    else:
        body = Multibody(
            frame=method.inertial or ReferenceFrame("inertial"),
            bodies=(),
            loads=read_loads(method.forcelist or ()),
            time=t,
            coordinates=coordinates,
            speeds=rates,
            coordinate_rates=rates,
            coordinate_derivatives=rates,
        )
        formed = form_lagrangian(method._L[0], body)
    return Equations(
        time=t,
        coordinates=coordinates,
        speeds=rates,
        coordinate_rates=rates,
        speed_rates=tuple(method._qdoubledots),
        coordinate_derivatives=rates,
        mass_matrix=matrix,
        forcing=forcing,
        positive_definite=True,
        formed=formed,
    )
