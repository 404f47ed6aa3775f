"""Dispatch from a method object to its `Equations`, by type."""

from __future__ import annotations

from functools import singledispatch
from typing import Any

from sympy.physics.mechanics import KanesMethod, LagrangesMethod, System
from sympy.physics.mechanics.jointsmethod import JointsMethod

from pydy._mechanics.definition import Definition, equations_of_definition
from pydy._mechanics.equations import Equations
from pydy._mechanics.joints import equations_of_joints, equations_of_system
from pydy._mechanics.kane import equations_of_kane
from pydy._mechanics.lagrange import equations_of_lagrange

__all__ = ["extract", "method_of", "symbolic_matrices"]


@singledispatch
def extract(eom_method: Any, source: str | None = None) -> Equations:
    """Return the equations that a method object holds, or that its bodies and loads give.

    Parameters
    ----------
    eom_method : object
    source : {'graph', 'method'}, optional
        See `pydy.system.System`.

    Raises
    ------
    TypeError
        There is no reader for an object of this type.
    """
    raise TypeError(
        "`eom_method` must be a KanesMethod, LagrangesMethod or System of sympy.physics.mechanics, "
        f"or a pydy.mechanics.Definition, got an object of type {type(eom_method).__name__}."
    )


extract.register(KanesMethod, equations_of_kane)
extract.register(LagrangesMethod, equations_of_lagrange)
extract.register(Definition, equations_of_definition)
extract.register(System, equations_of_system)
extract.register(JointsMethod, equations_of_joints)


def method_of(eom_method: Any) -> Any:
    """Return the object that a System shows as its `eom_method`."""
    return eom_method.method if isinstance(eom_method, Definition) else eom_method


def symbolic_matrices(equations: Equations, eom_method: Any) -> tuple[Any, Any]:
    """Return the mass matrix and forcing as SymPy's expressions.

    Raises
    ------
    NotImplementedError
        The equations were formed on a graph, and the method has none of its own.
    """
    if equations.formed is not None and not len(equations.mass_matrix):
        try:
            equations = extract(method_of(eom_method), "method")
        except ValueError:
            raise NotImplementedError(
                "`linear_sys_solver='sympy'` needs a mass matrix in SymPy, but the equations of "
                "motion were formed from the bodies. Call `kanes_equations()` of a KanesMethod "
                "and hand that to System."
            ) from None
    return equations.mass_matrix, equations.forcing
