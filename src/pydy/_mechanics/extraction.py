"""Read the `Equations` of a method object, by its type."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import singledispatch
from typing import TYPE_CHECKING, Any

from sympy import Derivative
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Particle,
    RigidBody,
    System,
)
from sympy.physics.mechanics.jointsmethod import JointsMethod

from pydy._mechanics.consistency import (
    check_velocities,
    warn_of_accelerations,
    warn_of_inertias,
    warn_of_kinematics,
)
from pydy._mechanics.definition import Definition, equations_of_definition
from pydy._mechanics.equations import Equations
from pydy._mechanics.implicit import Implicit
from pydy._mechanics.kane import equations_of_kane
from pydy._mechanics.lagrange import equations_of_lagrange
from pydy._mechanics.reader import activation_dynamics
from pydy._mechanics.wrapping import warn_of_reversed_forces

if TYPE_CHECKING:
    import sympy as sm

    from pydy._mechanics.definition import EomMethod
    from pydy._sympy_types import Body


def equations_of_system(
    system: System, source: str | None = None, implicit: Implicit | None = None
) -> Equations:
    """Return the equations of a System of SymPy.

    Where ``form_eoms()`` was called, they are those of its method. Else they are formed from its
    bodies: by Kane's equations, or, where its speeds are the derivatives of its coordinates, which
    KanesMethod refuses, by Lagrange's.

    Its method knows nothing of activations and fibre lengths of musculotendons: where there are
    some, Kane's equations are formed from the bodies, and they are coordinates without a speed.
    """
    readers = (lambda: _definition(system), lambda: _lagrange(system))
    dynamics = activation_dynamics(system.actuators)
    formed = system.eom_method
    if dynamics and source != "method" and isinstance(formed, KanesMethod):
        formed = None
    read = _read(formed, source, implicit, *readers)
    if missing := tuple(s for s in dynamics if s not in read.coordinates):
        body = read.multibody
        read = replace(read, multibody=body and replace(body, activations=missing))
    if read.mechanism is None:
        return read
    return replace(read, mechanism=replace(read.mechanism, joints=tuple(system.joints)))


def equations_of_joints(
    method: JointsMethod, source: str | None = None, implicit: Implicit | None = None
) -> Equations:
    """Return the equations of a JointsMethod, read like those of a SymPy System."""
    bodies = [_as_standard_body(body) for body in method.bodies]

    def definition() -> Definition:
        return Definition(
            method.frame,
            list(method.q),
            list(method.u),
            bodies=bodies,
            loads=method.loads,
            kinematic_equations=list(method.kdes),
        )

    def lagrange() -> LagrangesMethod:
        energy = Lagrangian(method.frame, *bodies)
        return LagrangesMethod(energy, method.q, method.loads, bodies, method.frame)

    return _read(method.method, source, implicit, definition, lagrange)


def _read(
    formed: KanesMethod | LagrangesMethod | None,
    source: str | None,
    implicit: Implicit | None,
    definition: Callable[[], Definition],
    lagrange: Callable[[], LagrangesMethod],
) -> Equations:
    if isinstance(formed, KanesMethod):
        return equations_of_kane(formed, source, implicit)
    if isinstance(formed, LagrangesMethod):
        return equations_of_lagrange(formed, source, implicit)
    if source == "method":
        raise ValueError(
            "`equations='method'` needs the equations of `eom_method`: call its `form_eoms()` "
            "before it is handed to System."
        )
    body = definition()
    if not any(isinstance(u, Derivative) for u in body.speeds):
        return equations_of_definition(body, None, implicit)
    other_speeds = [u for u in body.speeds if not isinstance(u, Derivative)]
    if other_speeds:
        raise ValueError(
            "Some speeds of `eom_method` are derivatives of coordinates, but "
            f"{other_speeds[0]} is not. "
            "Kane's equations need speeds that are functions of time, Lagrange's the derivatives "
            "of the coordinates: give all joints speeds of one kind."
        )
    with warnings.catch_warnings():
        # SymPy derives velocities that were not set, and warns if the result is ambiguous.
        warnings.simplefilter("ignore", UserWarning)
        return equations_of_lagrange(lagrange(), None, implicit)


def _definition(system: System) -> Definition:
    dynamics = activation_dynamics(system.actuators)
    if any(isinstance(u, Derivative) for u in system.u):
        dynamics = {}  # Lagrange's equations have a speed for each coordinate
    states = [s for s in dynamics if s not in tuple(system.q)]
    return Definition(
        system.frame,
        [*system.q, *states],
        list(system.u),
        bodies=system.bodies,
        loads=[*system.loads, *system.actuators],
        kinematic_equations=[*system.kdes, *(s.diff() - dynamics[s] for s in states)],
        holonomic_constraints=list(system.holonomic_constraints),
        velocity_constraints=list(system.velocity_constraints),
        dependent_coordinates=list(system.q_dep) or None,
        dependent_speeds=list(system.u_dep) or None,
        auxiliary_speeds=list(system.u_aux),
    )


def _lagrange(system: System) -> LagrangesMethod:
    loads = [*system.loads, *(load for a in system.actuators for load in a.to_loads())]
    return LagrangesMethod(
        Lagrangian(system.frame, *system.bodies),
        system.q,
        loads,
        system.bodies,
        system.frame,
        system.holonomic_constraints,
        system.nonholonomic_constraints,
    )


def _as_standard_body(body: Body) -> Body:
    """Return a Particle or RigidBody for a body of the deprecated class that is either."""
    if getattr(body, "is_rigidbody", isinstance(body, RigidBody)):
        inertia = (body.central_inertia, body.masscenter)
        copy: Body = RigidBody(body.name, body.masscenter, body.frame, body.mass, inertia)
    else:
        copy = Particle(body.name, body.masscenter, body.mass)
    copy.potential_energy = body.potential_energy
    return copy


@singledispatch
def extract(
    eom_method: object, source: str | None = None, implicit: Implicit | None = None
) -> Equations:
    """Return the equations of a method object, or those formed from its bodies and loads.

    The unknowns of `implicit` are added to the coordinates.
    """
    raise TypeError(
        "`eom_method` must be a KanesMethod, LagrangesMethod or System of sympy.physics.mechanics, "
        f"or a pydy.mechanics.Definition, got an object of type {type(eom_method).__name__}."
    )


def _checked(read: Callable[..., Equations]) -> Callable[..., Equations]:
    """Wrap the reader of a user's object with checks for contradictions."""

    def reader(*args: Any) -> Equations:
        equations = read(*args)
        check_velocities(equations)
        warn_of_kinematics(equations)
        warn_of_inertias(equations)
        warn_of_accelerations(equations)
        # Those of a System that has no equations yet were among the loads that were read.
        formed = isinstance(args[0], System) and args[0].eom_method is not None
        warn_of_reversed_forces(equations, args[0].actuators if formed else ())
        return equations

    return reader


extract.register(KanesMethod, _checked(equations_of_kane))
extract.register(LagrangesMethod, _checked(equations_of_lagrange))
extract.register(Definition, _checked(equations_of_definition))
extract.register(System, _checked(equations_of_system))
extract.register(JointsMethod, _checked(equations_of_joints))


def method_of(eom_method: EomMethod) -> EomMethod:
    """Return the object that a System shows as its `eom_method`."""
    return eom_method.method if isinstance(eom_method, Definition) else eom_method


def symbolic_matrices(
    equations: Equations, eom_method: EomMethod
) -> tuple[sm.Matrix, tuple[sm.Expr, ...]]:
    """Return the mass matrix and forcing as SymPy's expressions."""
    if equations.formed is not None and not len(equations.matrices.mass_matrix):
        try:
            equations = extract(method_of(eom_method), "method")
        except ValueError:
            raise NotImplementedError(
                "`linear_sys_solver='sympy'` needs a mass matrix in SymPy, but the equations of "
                "motion were formed from the bodies. Call `kanes_equations()` of a KanesMethod "
                "and hand that to System."
            ) from None
    return equations.matrices.mass_matrix, equations.matrices.forcing
