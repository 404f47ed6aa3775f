"""Frozen models on this project's expression graph. The one module here that imports pydy."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import dynamicsymbols

from harness.model import Model
from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Layout
from pydy._assembly.model import CompiledModel
from pydy._assembly.system import assemble_system
from pydy._kernel import Kernel
from pydy._mechanics.equations import Equations, MassAndForcing
from pydy._mechanics.kinematic_equations import KinematicEquations
from pydy.codegen.arguments import SpecifiedsPlan
from pydy.codegen.right_hand_side import make_backend, rates_function


def equations_of(model: Model) -> Equations:
    """Return a model as what is otherwise extracted from a KanesMethod."""
    t = dynamicsymbols._t
    n = len(model.speeds)
    return Equations(
        time=t,
        coordinates=tuple(model.coordinates),
        speeds=tuple(model.speeds),
        kinematics=KinematicEquations(
            coordinate_rates=tuple(q.diff(t) for q in model.coordinates),
            speed_rates=tuple(u.diff(t) for u in model.speeds),
            coordinate_derivatives=tuple(model.coordinate_derivatives),
        ),
        matrices=MassAndForcing(
            mass_matrix=sm.Matrix(n, n, model.mass_matrix),
            forcing=tuple(model.forcing),
            positive_definite=model.positive_definite,
        ),
    )


def assembly_of(
    model: Model, equations: Equations | None = None, off: frozenset[str] = frozenset()
) -> Assembly:
    """Read a model into a graph, as System does."""
    equations = equations or equations_of(model)
    return assemble_system(equations, (), (), model.specifieds, model.constants, off=off)


def compiled_model_of(model: Model) -> CompiledModel:
    """Return a model's code, as System makes it."""
    layout = Layout(
        (*model.coordinates, *model.speeds), tuple(model.specifieds), tuple(model.constants)
    )
    return CompiledModel(layout, assembly_of(model), make_backend("llvm", {}))


def compiled_jacobian(assembly: Assembly, block: str, by: str) -> Kernel:
    """Return the Kernel of a Jacobian, as System makes it."""
    layout = Layout((), (), ())
    return CompiledModel(layout, assembly, make_backend("llvm", {})).compiled_jacobian(block, by)


def solver_function(
    model: Model, inputs: np.ndarray
) -> tuple[Callable[..., Any], tuple[np.ndarray, np.ndarray]]:
    """Return f and args that System hands to its `ode_solver`; the code is compiled."""
    compiled = compiled_model_of(model)
    symbols = tuple(model.specifieds)
    plan = SpecifiedsPlan(dict(zip(symbols, inputs, strict=True)), symbols)
    function = rates_function(compiled, plan.inputs)
    compiled.compiled("rates").link()
    return function, (plan.inputs.values, np.array(model.values))
