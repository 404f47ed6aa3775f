"""The equations of a Problem with columns of sensitivities after the state.

The columns ∂x/∂θ are integrated with the state (`pydy._graph.columns`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from pydy._assembly import CompiledModel, Definition, stored_program
from pydy._graph import SensitivityColumns, simplify
from pydy._integration.parameters import Parameter, read_parameters, sample_weights
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._motion import with_all
from pydy._problem import Problem
from pydy._program import Program, Tangent
from pydy.codegen import SpecifiedsPlan

if TYPE_CHECKING:
    from pydy._sympy_types import SymbolOrName


@dataclass(frozen=True, eq=False)
class AugmentedSystem:
    """The equations of a Problem with columns of sensitivities after the state."""

    definition: Definition
    model: CompiledModel  # with all expressions compiled in, as it is integrated
    inputs: Inputs
    p: np.ndarray
    parameters: tuple[Parameter, ...]
    columns: SensitivityColumns  # of these parameters; see `columns_of`

    @staticmethod
    def for_parameters(
        problem: Problem,
        model: CompiledModel,
        plan: SpecifiedsPlan,
        requested: SymbolOrName | Iterable[SymbolOrName],
        argument: str = "sensitivities",
    ) -> AugmentedSystem:
        """Return the sensitivities with respect to the parameters that a user's argument has."""
        definition = problem.definition
        following = tuple(definition.states[k] for k in problem.dependent)
        parameters = read_parameters(definition, plan, requested, argument, following)
        columns = columns_of(parameters, definition)
        return AugmentedSystem(definition, model, plan.inputs, problem.p, parameters, columns)

    # -- Compiled code ----------------------------------------------------------------------------

    def kernel(self, *blocks: str) -> Kernel:
        """Return the Kernel of the derivatives of blocks by the parameters.

        By default it is that of the derivatives of the states and of their sensitivities by time.
        """
        return self.model.compiled_by(
            ("sensitivities", blocks, self.columns), lambda: self.tangent(*blocks)
        )

    def tangent(self, *blocks: str) -> Tangent:
        """Return the Tangent of `kernel`."""
        columns, assembly = self.columns, self.model.assembly

        def make() -> Tangent:
            if blocks:
                graph = assembly.graph.copy()
                nodes = [node for name in blocks for node in getattr(assembly.blocks, name)]
                return columns.tangent(graph, simplify(graph, nodes), sizes)
            graph, rates = assembly.simplified("rates")
            return columns.tangent(graph, rates, sizes, "rates")

        sizes = assembly.sizes
        return stored_program(
            assembly, f"sensitivities of {', '.join(blocks) or 'rates'} {columns}", make
        )

    def call(self) -> KernelCall:
        """Return the equations with sensitivities and their numbers, for native solvers."""
        model = self.model
        return KernelCall(
            self.kernel(),
            self.p,
            Inputs(
                np.concatenate([self.inputs.values, np.zeros(self.columns.weights)]),
                (*self.inputs.sampled, *sample_weights(self.parameters, self.definition)),
            ),
            lambda: tuple(map(str, model.layout.states)),
            lambda: model.compiled_jacobian("rates", "x"),
        )

    # -- Values along a motion --------------------------------------------------------------------

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""
        return self.columns.split(self.evaluate((), times, states, values))[1]

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""
        out = self.evaluate(("outputs",), times, states, values)
        return out.reshape(len(times), -1, self.columns.count)

    def evaluate(
        self, blocks: Sequence[str], times: np.ndarray, states: np.ndarray, values: np.ndarray
    ) -> np.ndarray:
        """Return the values of the `kernel` of blocks, at sensitivities (m, n, k) of the states."""
        augmented, call = self.columns.together(states, values), self.call()
        r = call.inputs.rows(np.empty((len(times), 0)), times)
        return self.model.evaluate(self.kernel(*blocks), times, augmented, r, self.p)


def columns_of(
    parameters: Sequence[Parameter], definition: Definition, states: int | None = None
) -> SensitivityColumns:
    """Return the columns of parameters; there may be more `states` than the Definition has."""
    s, weights = len(definition.specifieds), 0
    directions: list[tuple[str, int] | tuple[str, int, int] | None] = []
    for parameter in parameters:
        if parameter.kind == "states":
            directions.append(None)
        elif parameter.kind == "constants":
            directions.append(("p", parameter.index))
        elif parameter.samples is None:
            directions.append(("r", parameter.index))
        else:
            for _ in range(parameter.count):
                directions.append(("r", parameter.index, s + weights))
                weights += 1
    n = len(definition.states) if states is None else states
    return SensitivityColumns(n, tuple(directions), weights)


def with_all_constraints(augmented: AugmentedSystem) -> AugmentedSystem:
    """Return a copy with all constraints, as in the projection."""
    model = with_all(augmented.model, augmented.definition)
    return augmented if model is augmented.model else replace(augmented, model=model)


def written_out(augmented: AugmentedSystem, *blocks: str) -> Program:
    """Return the Program of a `kernel`: an infinite derivative affects no other column."""
    name = f"sensitivities of {', '.join(blocks)} {augmented.columns}, written out"
    return stored_program(
        augmented.model.assembly, name, lambda: augmented.tangent(*blocks).written_out()
    )
