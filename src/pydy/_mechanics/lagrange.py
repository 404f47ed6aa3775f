"""Read a LagrangesMethod. The only module that touches its underscore attributes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from sympy.physics.mechanics import LagrangesMethod, ReferenceFrame, dynamicsymbols

from pydy._mechanics.dependents import constrained
from pydy._mechanics.equations import Equations, Mechanism
from pydy._mechanics.formulations import form_lagrangian
from pydy._mechanics.implicit import Implicit
from pydy._mechanics.kinematic_constraints import DependentStates
from pydy._mechanics.kinematic_equations import KinematicEquations
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import activation_states, check_bodies, is_rigid, read_loads
from pydy._mechanics.select_formulation import classify, kinematics_of

if TYPE_CHECKING:
    import sympy as sm


def equations_of_lagrange(
    method: LagrangesMethod, source: str | None = None, implicit: Implicit | None = None
) -> Equations:
    """Return the equations of a LagrangesMethod. The speeds are the derivatives q'.

    Constraints are solved for dependent coordinates and speeds, which stay in their places.
    """
    if implicit is not None:
        raise ValueError(
            "`implicit` needs the bodies and loads: a Lagrangian's derivatives by the coordinates "
            "would miss what follows them. Use KanesMethod or pydy.mechanics.Definition in place "
            "of LagrangesMethod."
        )
    if method.loads and method.inertial is None:
        raise ValueError(
            "`eom_method` has a `forcelist` but no `frame`: give LagrangesMethod the inertial "
            "frame in which velocities are taken."
        )
    coordinates, rates, time = tuple(method.q), tuple(method._qdots), dynamicsymbols._t
    holonomic = tuple(_named(method, "holonomic_constraints", "_hol_coneqs"))
    velocity = tuple(_named(method, "velocity_constraints", "coneqs"))
    body = Multibody(
        frame=method.inertial or ReferenceFrame("inertial"),
        bodies=(),
        loads=read_loads(method.loads or ()),
        time=time,
        coordinates=coordinates,
        speeds=rates,
        kinematics=KinematicEquations.of(time, rates, rates, rates),
        dependents=DependentStates(all_speeds=rates),
        lagrangian=method._L[0],
        activations=tuple(activation_states(method.loads or (), coordinates)),
    )
    if source == "method":
        if velocity:
            raise ValueError(
                "`equations='method'` is not possible with a LagrangesMethod that has constraints: "
                "its equations hold the multipliers as unknowns. Leave it out."
            )
        if method.eom is None:
            raise ValueError(
                "`equations='method'` needs the equations of `eom_method`: call its "
                "`form_lagranges_equations()` before it is handed to System."
            )
        base = replace(kinematics_of(body), mechanism=_mechanism(method, body))
        mass_matrix, forcing = method.mass_matrix, tuple(method.forcing)
        matrices = replace(base.matrices, mass_matrix=mass_matrix, forcing=forcing)
        return replace(base, matrices=matrices)
    if velocity:
        body = constrained(body, holonomic, velocity)
    base = replace(kinematics_of(body), mechanism=_mechanism(method, body))
    return classify(replace(base, formed=form_lagrangian(body)))


def _named(method: LagrangesMethod, name: str, before: str) -> Iterable[sm.Expr]:
    """Return an attribute by its name since SymPy 1.15, or by the one that it had before."""
    expressions: Iterable[sm.Expr] = getattr(method, name if hasattr(method, name) else before)
    return expressions


def _mechanism(method: LagrangesMethod, body: Multibody) -> Mechanism | None:
    """Return the bodies that a method was given, for energies and scenes; None without motion."""
    if not method.bodies or method.inertial is None:
        return None
    bodies = check_bodies(method.bodies)
    try:
        for item in bodies:
            item.masscenter.vel(body.frame)
            if is_rigid(item):
                item.frame.ang_vel_in(body.frame)
    except ValueError:
        return None
    return Mechanism(body.frame, bodies, body.loads, lagrangian=body.lagrangian)
