"""From a definition and a user's options to its CompiledModel and generated function."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sm

from pydy._assembly.definition import Definition
from pydy._assembly.external import resolve_solver, solve_symbolically
from pydy._assembly.model import CompiledModel
from pydy._checks import flag
from pydy._errors import warn_user
from pydy._graph.switches import Passes
from pydy._mechanics.extract import symbolic_matrices
from pydy.codegen.ode_function_generators import make_function
from pydy.codegen.right_hand_side import RightHandSide, make_backend

__all__ = ["Generated", "checked_options", "generate"]

_ARGUMENTS = ("constants_arg_type", "specifieds_arg_type", "time_first")
_REFUSED = {
    "right_hand_side", "coordinates", "speeds", "constants", "mass_matrix",
    "coordinate_derivatives", "outputs",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Generated:
    """What was generated for a definition.

    Attributes
    ----------
    definition : Definition
    model : CompiledModel
    arguments : mapping
        How the function reads r and p, and in which order.
    """

    definition: Definition
    model: CompiledModel
    arguments: Mapping[str, Any]
    _functions: dict[bool, Any] = field(default_factory=dict)

    def function(self, *, any_layout: bool) -> Any:
        """Return the function that users call; made once for each way to take arrays.

        Parameters
        ----------
        any_layout : bool
            Whether states that are not contiguous are copied, where the back end leaves it open.
        """
        side = RightHandSide(self.model, any_layout=any_layout, **self.arguments)
        if side.refuse_strided not in self._functions:
            self._functions[side.refuse_strided] = make_function(side)
        return self._functions[side.refuse_strided]


def checked_options(options: dict[str, Any]) -> dict[str, Any]:
    """Return the options of `System.generate_ode_function`, without what the System decides."""
    if "specifieds" in options:
        warn_user(
            "`specifieds` is ignored by System.generate_ode_function: the System takes care of "
            "them. Set `system.specifieds` for their values."
        )
        options = {k: v for k, v in options.items() if k != "specifieds"}
    refused = sorted(_REFUSED & set(options))
    if refused:
        raise TypeError(
            f"generate_ode_function() got `{refused[0]}`, which the System takes from its own "
            "equations. Options are linear_sys_solver, constants_arg_type, "
            "specifieds_arg_type, time_first, generator and those of the generator."
        )
    return options


def generate(definition: Definition, eom_method: Any, options: Mapping[str, Any]) -> Generated:
    """Return the model of a definition; nothing is compiled as yet.

    Parameters
    ----------
    definition : Definition
    eom_method : object
        Has the mass matrix, for a symbolic solution.
    options : mapping
        Of `generate_ode_function`.
    """
    options = dict(options)
    solver = resolve_solver(options.pop("linear_sys_solver", None))
    equations = definition.equations
    if isinstance(solver, str):
        solved = solve_symbolically(*symbolic_matrices(equations, eom_method), solver)
        equations = replace(
            equations,
            formed=None,
            mass_matrix=sm.eye(len(solved)),
            forcing=tuple(solved),
            positive_definite=True,
        )
        solver = None
    passes = Passes() if flag(options.get("cse", True), "`cse`") else Passes.none()
    arguments = {k: options.pop(k) for k in _ARGUMENTS if k in options}
    backend = make_backend(options.pop("generator", "llvm"), options)
    assembly = definition.assemble(equations, external=solver is not None, passes=passes)
    model = CompiledModel(definition.layout, assembly, backend, solver, definition)
    return Generated(definition, model, arguments)
