"""The equations of a System without numbers: what they define, their code and energies."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sm

from pydy._assembly import (
    CompiledModel,
    Definition,
    Plan,
    assemble_system,
    resolve_solver,
    solve_symbolically,
    with_compiled_inputs,
)
from pydy._checks import flag
from pydy._graph import rewriting
from pydy._mechanics import Equations, symbolic_matrices
from pydy._problem.definition import DefinitionBuilder
from pydy._problem.energy import EnergyModel
from pydy.codegen import make_backend


@dataclass(frozen=True, eq=False)
class Model:
    """Equations without numbers."""

    definition: Definition
    code: CompiledModel  # takes all specifieds as inputs
    energies: EnergyModel
    # derivatives of specifieds that the user has been warned of
    already_warned: set[Any] = field(default_factory=set)

    @staticmethod
    def of(
        equations: Equations,
        outputs: Mapping[Any, Any],
        specifieds: Mapping[Any, Any],
        *,
        constants_symbols: Iterable[Any],
        specifieds_symbols: Iterable[Any],
    ) -> Model:
        """Return the model of equations with some outputs, and expressions among `specifieds`."""
        energies = EnergyModel(equations)
        define = DefinitionBuilder(equations, energies, constants_symbols, specifieds_symbols)
        definition = define(outputs, (), specifieds)
        return Model(definition, compile_definition(definition, equations, {}), energies)

    def with_compiled_inputs(self, plan: Plan, *, perturbed: bool = False) -> CompiledModel:
        """Return the code with the expressions for specifieds compiled in.

        Derivatives by specifieds are those by what is added to them, if they are `perturbed`.
        """
        return with_compiled_inputs(self.code, self.definition, plan, perturbed=perturbed)


def compile_definition(
    definition: Definition, source: Any, options: Mapping[str, Any]
) -> CompiledModel:
    """Return a definition's code, not compiled yet, by options of `generate_ode_function`.

    The `source` is what the equations were read from.
    """
    options = dict(options)
    solver = resolve_solver(options.pop("linear_sys_solver", None))
    equations = definition.equations
    if isinstance(solver, str):
        solved = solve_symbolically(*symbolic_matrices(equations, source), solver)
        matrices = replace(
            equations.matrices,
            mass_matrix=sm.eye(len(solved)),
            forcing=tuple(solved),
            positive_definite=True,
        )
        equations = replace(equations, formed=None, matrices=matrices)
        solver = None
    off = frozenset() if flag(options.get("cse", True), "`cse`") else rewriting()
    backend = make_backend(options.pop("generator", "llvm"), options)
    layout, external = definition.layout, solver is not None
    groups, integrals = definition.outputs.groups, definition.auxiliaries
    symbols = groups, integrals, layout.specifieds, layout.constants
    assembly = assemble_system(equations, *symbols, external=external, off=off)
    return CompiledModel(layout, assembly, backend, solver, definition)
