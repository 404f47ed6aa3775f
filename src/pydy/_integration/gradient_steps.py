"""Step sizes of motions with recorded steps: derivatives that limit or control them."""

from __future__ import annotations

from dataclasses import replace
from typing import NoReturn

import numpy as np

from pydy._assembly import CompiledModel, stored_program
from pydy._graph import SensitivityDirection, simplify
from pydy._integration.gradient_equations import GradientEquations
from pydy._integration.parameters import Parameter
from pydy._integration.sensitivities import columns_of
from pydy._integration.step_control import compiled_sensitivities, least_sizes
from pydy._kernel import Kernel, KernelCall
from pydy._motion import with_all
from pydy._program import Program
from pydy.solvers import CompiledSensitivities, ParameterSize


def with_controlled_columns(
    equations: GradientEquations,
    full_state: np.ndarray,
    columns: np.ndarray,
    options: dict[str, object],
) -> tuple[KernelCall, np.ndarray, CompiledSensitivities]:
    """Return the equations with columns of sensitivities, and the solver's options for them.

    The `columns` (n, n + w) are derivatives by states, then by the inputs `wrt`. Where they vary
    faster than the states, their errors determine the step size.
    """
    definition = equations.augmented.definition
    states = [Parameter(s, "states", k) for k, s in enumerate(definition.states)]
    inputs = [replace(p, samples=None) for p in (*equations.unsampled, *equations.sampled)]
    moving = [k for k, p in enumerate([*states, *inputs]) if p in inputs or columns[:, k].any()]
    parameters = tuple([*states, *inputs][k] for k in moving)
    augmented = replace(
        equations.augmented,
        model=equations.full_model,
        parameters=parameters,
        columns=columns_of(parameters, definition, states=len(full_state)),
    )
    compiled = compiled_sensitivities(augmented, full_state, options, controlled=True)
    values = np.zeros((len(full_state), len(moving)))
    values[: len(states)] = columns[:, moving]
    call = equations.call_full(augmented.kernel())
    return call, augmented.columns.together(full_state, values), compiled


def with_generic_direction(
    equations: GradientEquations, full_state: np.ndarray, options: dict[str, object]
) -> tuple[KernelCall, np.ndarray, CompiledSensitivities]:
    """Return the equations with one column of sensitivities, and the solver's options for it.

    The column is the derivative along a generic direction in the space of all initial conditions
    and the inputs `wrt`, each scaled by its size. Its error limits the step size: it contains modes
    that the motion itself does not excite but that the gradient depends on.
    """
    model, width = equations.full_model, len(full_state)
    direction = SensitivityDirection(width, equations.wrt)
    call = equations.call_full(direction_kernel(model, direction))
    sized = [
        ParameterSize("x", k, least=s) for k, s in enumerate(least_sizes(options, width).tolist())
    ]
    sized += [
        parameter.sized._replace(columns=1)
        for parameter in (*equations.unsampled, *equations.sampled)
    ]
    augmented, r = equations.augmented, equations.augmented.inputs.values
    sizes = ParameterSize.scales(sized, full_state, r, augmented.p, len(sized))
    parts = sizes * generic_direction(len(sized))
    column, weights = parts[:width], parts[width:]
    column[augmented.columns.states :] = 0.0  # integrals start at zero
    with_constraints = with_all(model, augmented.definition)
    compiled = CompiledSensitivities(
        width, _OF_NO_INPUT, np.ones(1), full_state, False, _of_no_event,
        lambda: direction_kernel(with_constraints, direction, "holonomic", "velocity"),
    )  # fmt: skip
    r = np.concatenate([call.inputs.values, weights])
    call = replace(call, inputs=replace(call.inputs, values=r))
    return call, np.append(full_state, column), compiled


_OF_NO_INPUT = np.array([[-1, -1]])


def _of_no_event(event: int) -> NoReturn:
    raise AssertionError("The derivatives that limit step sizes have no jumps at events.")


def generic_direction(count: int) -> np.ndarray:
    """Return the components of a fixed generic direction, of magnitude 1/2 to 1 and both signs.

    Modes of symmetric systems are sums and differences of states. Multiples of the golden ratio
    modulo 1 are evenly distributed, so few components are nearly equal.
    """
    parts = np.arange(1.0, count + 1.0) * 0.5 * (5.0**0.5 - 1.0) % 1.0
    components: np.ndarray = np.where(parts < 0.5, 0.5 + parts, -parts)
    return components


def direction_kernel(model: CompiledModel, direction: SensitivityDirection, *blocks: str) -> Kernel:
    """Return the Kernel of the directional derivatives of some blocks.

    Without blocks, it computes the rates of the states and of their directional derivatives.
    """
    assembly = model.assembly

    def make() -> Program:
        if blocks:
            graph = assembly.graph.copy()
            nodes = [node for name in blocks for node in getattr(assembly.blocks, name)]
            return direction.program(graph, simplify(graph, nodes), assembly.sizes)
        graph, rates = assembly.simplified("rates")
        return direction.program(graph, rates, assembly.sizes, "rates")

    def stored() -> Program:
        description = f"along one direction of {', '.join(blocks) or 'rates'} {direction}"
        return stored_program(assembly, description, make)

    return model.compiled_by(("along one direction", blocks, direction), stored)
