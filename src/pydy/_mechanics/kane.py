"""Read a KanesMethod. The only module that touches its underscore attributes."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from sympy.physics.mechanics import KanesMethod, dynamicsymbols

from pydy._checks import describe
from pydy._mechanics.auxiliary import with_auxiliary
from pydy._mechanics.equation_graph import EquationGraph
from pydy._mechanics.equations import Equations, Mechanism
from pydy._mechanics.formulations import without_cancelling_forces
from pydy._mechanics.implicit import Implicit
from pydy._mechanics.kinematic_constraints import DependentStates, KinematicConstraints
from pydy._mechanics.kinematic_equations import KinematicEquations
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.rates import divide_alike, solve_rates
from pydy._mechanics.reader import activation_states, check_bodies, read_loads
from pydy._mechanics.select_formulation import classify, equations_of, formed_alike, kinematics_of

if TYPE_CHECKING:
    import sympy as sm


def multibody_of_kane(kane: KanesMethod) -> Multibody:
    """Read bodies, loads and kinematics of a KanesMethod.

    ``kanes_equations()`` need not have been called.
    """
    rates, time = _rates(kane), dynamicsymbols._t
    velocity: tuple[sm.Expr, ...] = ()
    acceleration: tuple[sm.Expr, ...] = ()
    if kane._k_nh:
        velocity = tuple(kane._k_nh * kane.u + kane._f_nh)
        # SymPy hands the same matrix on when no acceleration constraints were given.
        if kane._k_dnh is not kane._k_nh:
            acceleration = tuple(kane._k_dnh * kane._udot + kane._f_dnh)
    return Multibody(
        frame=kane._inertial,
        bodies=check_bodies(kane.bodies or ()),
        loads=read_loads(kane.loads or ()),
        time=time,
        coordinates=tuple(kane.q),
        speeds=tuple(kane.u),
        kinematics=KinematicEquations.of(
            time, kane.u, kane._qdot, [rates[rate] for rate in kane._qdot], kane._uaux
        ),
        dependents=DependentStates(tuple(kane._qdep), tuple(kane._udep), tuple(kane.u)),
        constraints=KinematicConstraints(tuple(kane._f_h), velocity, acceleration),
        auxiliary=tuple(kane._uaux),
        activations=tuple(activation_states(kane.loads or (), tuple(kane.q))),
    )


def _rates(kane: KanesMethod) -> dict[sm.Derivative, sm.Expr]:
    """Return q' in terms of the states.

    SymPy divides by pivots that may vanish in some states, or in all if it did not simplify them.
    """
    rates_of_sympy, matrix = dict(kane.kindiffdict()), kane._k_kqdot_implicit
    if matrix.is_diagonal():
        return rates_of_sympy
    rows = matrix * kane._qdot + kane._k_ku_implicit * kane.u + kane._f_k_implicit
    solved = dict(zip(kane._qdot, solve_rates(list(rows), list(kane._qdot), "kd_eqs"), strict=True))
    return (
        rates_of_sympy
        if divide_alike(list(rates_of_sympy.values()), list(solved.values()))
        else solved
    )


def equations_of_kane(
    kane: KanesMethod, source: str | None = None, implicit: Implicit | None = None
) -> Equations:
    """Return the equations of a KanesMethod, formed from bodies and loads or its own.

    Without `source`, where ``kanes_equations()`` has been called, the former are taken if they give
    the same numbers.
    """
    has_equations = kane._fr is not None and kane._frstar is not None
    if source == "method" and not has_equations:
        raise ValueError(
            "`equations='method'` needs the equations of `eom_method`: call its "
            "`kanes_equations(bodies, loads)` before it is handed to System."
        )
    if source == "method" and implicit is not None:
        raise ValueError(
            "`equations='method'` is not possible with `implicit`: the method took "
            f"{describe([*implicit.residuals])} for prescribed motions. Leave it out."
        )
    forms_equations = source == "graph" or not has_equations or implicit is not None
    if forms_equations and not kane.bodies:
        raise ValueError(
            "`eom_method` holds no equations of motion yet, and no bodies to form them from: "
            "construct it with `bodies=` and `forcelist=`, or call its `kanes_equations(bodies, "
            "loads)` before it is handed to System."
        )
    if forms_equations and not kane._qdot_u_map:
        raise ValueError(
            "`eom_method` has no kinematic differential equations: construct it with `kd_eqs=`."
        )
    body = multibody_of_kane(kane)
    if implicit is not None:
        body = implicit.added_to(body)
    if forms_equations:
        return equations_of(body)
    auxiliary = tuple(kane.auxiliary_eqs) if body.auxiliary else ()
    base = kinematics_of(body)
    forcing = without_cancelling_forces(kane.forcing, auxiliary, {*body.coordinates, *body.speeds})
    base = classify(
        replace(
            base,
            matrices=replace(base.matrices, mass_matrix=kane.mass_matrix, forcing=forcing),
            auxiliary=replace(base.auxiliary, residuals=auxiliary),
            mechanism=Mechanism(body.frame, body.bodies, body.loads),
        )
    )
    if source != "method":
        base = replace(base, formed=_alike(kane, base, body))
    return with_auxiliary(base) if body.auxiliary else base


# Formed equations by method, with the equations that they were compared with: these may change.
_formed_by_method: WeakKeyDictionary[
    KanesMethod, tuple[tuple[sm.Expr, ...], EquationGraph | None]
] = WeakKeyDictionary()


def _alike(kane: KanesMethod, base: Equations, body: Multibody) -> EquationGraph | None:
    own_equations = *base.matrices.mass_matrix, *base.matrices.forcing
    equations, formed = _formed_by_method.get(kane, (None, None))
    if equations != own_equations:
        formed = formed_alike(base, body)
        _formed_by_method[kane] = own_equations, formed
    return formed
