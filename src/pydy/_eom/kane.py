"""Read a KanesMethod. The only module that touches its underscore attributes."""

from __future__ import annotations

from typing import Any

from sympy.physics.mechanics import KanesMethod, dynamicsymbols

from pydy._eom.classify import classify
from pydy._eom.equations import Equations
from pydy._eom.mechanism import Mechanism
from pydy._mechanics.reader import Multibody, check_bodies, read_loads

__all__ = ["equations_of_kane", "multibody_of_kane"]


def multibody_of_kane(kane: KanesMethod) -> Multibody:
    """Return what the equations of a KanesMethod are made from.

    ``kanes_equations()`` need not have been called.
    """
    rates = kane.kindiffdict()
    velocity: tuple[Any, ...] = ()
    acceleration: tuple[Any, ...] = ()
    if kane._k_nh:
        velocity = tuple(kane._k_nh * kane.u + kane._f_nh)
        # SymPy hands the same matrix on when no acceleration constraints were given.
        if kane._k_dnh is not kane._k_nh:
            acceleration = tuple(kane._k_dnh * kane._udot + kane._f_dnh)
    return Multibody(
        frame=kane._inertial,
        bodies=check_bodies(kane._bodylist or ()),
        loads=read_loads(kane._forcelist or ()),
        time=dynamicsymbols._t,
        coordinates=tuple(kane.q),
        speeds=tuple(kane.u),
        coordinate_rates=tuple(kane._qdot),
        coordinate_derivatives=tuple(rates[rate] for rate in kane._qdot),
        velocity=velocity,
        acceleration=acceleration,
        auxiliary=tuple(kane._uaux),
    )


def equations_of_kane(kane: KanesMethod) -> Equations:
    """Return the equations of a KanesMethod.

    Raises
    ------
    ValueError
        ``kanes_equations()`` has not been called yet.
    """
    if kane._fr is None or kane._frstar is None:
        raise ValueError(
            "`eom_method` holds no equations of motion yet: call its `kanes_equations(bodies, "
            "loads)` before it is handed to System."
        )
    t = dynamicsymbols._t
    rates = kane.kindiffdict()
    auxiliary = tuple(kane._uaux)
    velocity: tuple[Any, ...] = ()
    if kane._k_nh:
        velocity = tuple(kane._k_nh * kane.u + kane._f_nh)
    base = Equations(
        time=t,
        coordinates=tuple(kane.q),
        speeds=tuple(kane.u),
        coordinate_rates=tuple(kane._qdot),
        speed_rates=tuple(kane._udot),
        coordinate_derivatives=tuple(rates[rate] for rate in kane._qdot),
        mass_matrix=kane.mass_matrix,
        forcing=tuple(kane.forcing),
        positive_definite=not kane._udep,
        holonomic=tuple(kane._f_h),
        velocity=velocity,
        dependent_coordinates=tuple(kane._qdep),
        dependent_speeds=tuple(kane._udep),
        auxiliary_speeds=auxiliary,
        auxiliary_equations=tuple(kane.auxiliary_eqs) if auxiliary else (),
        # In motion the auxiliary speeds are zero at all times.
        zeros=(*auxiliary, *(u.diff(t) for u in auxiliary)),
        mechanism=Mechanism(
            kane._inertial,
            tuple(kane.bodies or ()),
            tuple((where, vector) for where, vector in kane.loads or ()),
        ),
    )
    return classify(base)
