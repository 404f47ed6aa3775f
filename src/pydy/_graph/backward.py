"""Programs that go back through a motion: of what events do to the adjoint of a state.

`pydy._graph.columns` has their like for sensitivities forward in time.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.adjoint import adjoints
from pydy._graph.derivative import Rows
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._graph.switches import Passes

__all__ = ["event_program"]


def event_program(
    graph: Graph,
    crossing: int,
    after: Sequence[int],
    rates: Sequence[int],
    wanted: Sequence[tuple[str, int]],
    sizes: tuple[int, int, int],
    passes: Passes,
) -> Program:
    """Return the Program of an event, for the adjoint of the state after it.

    Its inputs r are followed by their derivatives by time, then by the adjoint λ of the state after
    the event. With f the states' derivatives before it, its blocks are

    ==========  =============================================================================
    rate        ġ of the expression g that is zero there, along the motion
    curvature   g̈
    crossing    the derivatives of g by the states, then by what is wanted
    turned      those of λ · R, where R is the state after the event
    after_rate  λ · Ṙ, along the motion before the event
    ==========  =============================================================================

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    crossing : node
        g.
    after, rates : sequence of n nodes
        R and f.
    wanted : sequence of (group, index)
        Inputs.
    sizes : (int, int, int)
        Numbers of states, specifieds and constants.
    passes : Passes
    """
    n, s, c = sizes
    crossing, *rest = simplify(graph, [crossing, *after, *rates], passes)
    after, rates = rest[: len(after)], rest[len(after) :]
    states = [graph.input("x", i) for i in range(n)]
    along = {graph.input("t", 0): {0: graph.one}}
    along.update((x, {0: rate}) for x, rate in zip(states, rates, strict=True))
    along.update((graph.input("r", i), {0: graph.input("r", s + i)}) for i in range(s))
    motion = Rows(graph, along)
    by = [*states, *(graph.input(*place) for place in wanted)]
    weights = [graph.input("r", 2 * s + i) for i in range(n)]
    first = motion(crossing).get(0, graph.zero)
    moved = [motion(node).get(0, graph.zero) for node in after]
    total = graph.sum([(graph.mul(w, m), 1.0) for w, m in zip(weights, moved, strict=True)])
    parts = {
        "rate": [first],
        "curvature": [motion(first).get(0, graph.zero)],
        "crossing": adjoints(graph, [crossing], [graph.one], by),
        "turned": adjoints(graph, after, weights, by),
        "after_rate": [total],
    }
    cells = iter(factor_sums(graph, [node for part in parts.values() for node in part]))
    blocks = [(name, (len(part),), [next(cells) for _ in part]) for name, part in parts.items()]
    return lower(graph, (n, 2 * s + n, c), blocks, passes=passes, own=sizes)
