"""Frozen models on this project's expression graph. The one module here that imports pydy."""

from __future__ import annotations

import sympy as sm
from sympy.physics.mechanics import dynamicsymbols

from harness.frozen import Model
from pydy._eom.equations import Equations
from pydy._programs import Assembly, assemble_system


def equations_of(model: Model) -> Equations:
    """Return a model as what is otherwise extracted from a KanesMethod."""
    t = dynamicsymbols._t
    n = len(model.speeds)
    return Equations(
        time=t,
        coordinates=tuple(model.coordinates),
        speeds=tuple(model.speeds),
        coordinate_rates=tuple(q.diff(t) for q in model.coordinates),
        speed_rates=tuple(u.diff(t) for u in model.speeds),
        coordinate_derivatives=tuple(model.coordinate_derivatives),
        mass_matrix=sm.Matrix(n, n, model.mass_matrix),
        forcing=tuple(model.forcing),
        positive_definite=model.positive_definite,
    )


def assembly_of(model: Model, equations: Equations | None = None) -> Assembly:
    """Read a model into a graph, as System does."""
    equations = equations or equations_of(model)
    return assemble_system(equations, (), (), model.specifieds, model.constants)
