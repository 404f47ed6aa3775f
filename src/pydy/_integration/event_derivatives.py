"""The derivatives of an event: of its time, and of the state after it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pydy._assembly import CompiledModel
from pydy._graph import DerivativeRows, factor_sums, jacobian, lower, simplify
from pydy._kernel import Kernel
from pydy._program import Program
from pydy.solvers import Event

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol


def changed_by(event: Event, states: Sequence[AnySymbol]) -> tuple[int, ...]:
    """Return the columns of the states that an event changes."""
    return tuple(k for k, state in enumerate(states) if state in event.reset)


def program_of_event(
    model: CompiledModel, event: Event, inputs: Sequence[tuple[str, int]]
) -> Program:
    """Return the Program of an event with g = 0 and the state R after it.

    The inputs r are followed by their time derivatives. There are w `inputs` (group, index) to
    differentiate by, and c states that the event changes. The blocks are

    ===========  ============  ==================================================================
    rate         (1,)          ġ, along the motion
    curvature    (1,)          g̈
    crossing     (n + w,)      the derivatives of g by the states, then by the `inputs`
    after_rates  (n,)          Ṙ, along the motion before the event
    after        (c, n + w)    the derivatives of those states in R that are changed
    ===========  ============  ==================================================================
    """
    fork, symbols = model.assembly.fork(), model.layout.states
    graph, (n, s, c) = fork.graph, fork.sizes
    after = [event.reset.get(state, state) for state in symbols]
    read = fork.read([event.expression, *after], f"the event `{event.name}`")
    crossing, *nodes = simplify(graph, [*read, *fork.blocks.rates])
    after, rates = nodes[:n], nodes[n:]
    states = [graph.input("x", i) for i in range(n)]
    tangents = {graph.input("t", 0): {0: graph.one}}
    tangents.update((x, {0: rate}) for x, rate in zip(states, rates, strict=True))
    tangents.update((graph.input("r", i), {0: graph.input("r", s + i)}) for i in range(s))
    motion = DerivativeRows(graph, tangents)
    variables = [*states, *(graph.input(*input_key) for input_key in inputs)]
    first = motion(crossing).get(0, graph.zero)
    changed = [after[k] for k in changed_by(event, symbols)]
    parts = {
        "rate": [first],
        "curvature": [motion(first).get(0, graph.zero)],
        "crossing": jacobian(graph, [crossing], variables).flat(),
        "after_rates": [motion(node).get(0, graph.zero) for node in after],
        "after": jacobian(graph, changed, variables).flat(),
    }
    shapes = {"after": (len(changed), len(variables))}
    cells = iter(factor_sums(graph, [node for part in parts.values() for node in part]))
    blocks = [
        (name, shapes.get(name, (len(part),)), [next(cells) for _ in part])
        for name, part in parts.items()
    ]
    return lower(graph, (n, 2 * s, c), blocks, sizes_of_matrices=fork.sizes)


def compiled_event(
    model: CompiledModel, event: Event, inputs: tuple[tuple[str, int], ...]
) -> tuple[Kernel, tuple[int, ...]]:
    """Return the Kernel of an event's effect on derivatives, and the states it changes."""
    key = ("the event", event.expression, *event.reset.items(), inputs)
    kernel = model.compiled_by(key, lambda: program_of_event(model, event, inputs))
    return kernel, changed_by(event, model.layout.states)
