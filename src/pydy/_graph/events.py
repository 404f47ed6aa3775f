"""Programs of events: what these do to derivatives of a motion, forward in time and back."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.derivative import Rows, dense_jacobian
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._graph.switches import Passes


def event_program(
    graph: Graph,
    crossing: int,
    after: Sequence[int],
    rates: Sequence[int],
    changed: Sequence[int],
    wanted: Sequence[tuple[str, int]],
    sizes: tuple[int, int, int],
    passes: Passes,
) -> Program:
    """Return the Program of an event with g = 0 and the state R after it.

    The `rates` are the states' derivatives before it, `changed` the places of the states that it
    changes, `wanted` inputs (group, index). The inputs r are followed by their derivatives by time.
    The blocks are

    ===========  ============  ==================================================================
    rate         (1,)          ġ, along the motion
    curvature    (1,)          g̈
    crossing     (n + w,)      the derivatives of g by the states, then by what is wanted
    after_rates  (n,)          Ṙ, along the motion before the event
    after        (c, n + w)    the derivatives of those states in R that are changed
    ===========  ============  ==================================================================
    """
    n, s, c = sizes
    crossing, *rest = simplify(graph, [crossing, *after, *rates], passes)
    after, rates = rest[:n], rest[n:]
    states = [graph.input("x", i) for i in range(n)]
    along = {graph.input("t", 0): {0: graph.one}}
    along.update((x, {0: rate}) for x, rate in zip(states, rates, strict=True))
    along.update((graph.input("r", i), {0: graph.input("r", s + i)}) for i in range(s))
    motion = Rows(graph, along)
    by = [*states, *(graph.input(*place) for place in wanted)]
    first = motion(crossing).get(0, graph.zero)
    parts = {
        "rate": [first],
        "curvature": [motion(first).get(0, graph.zero)],
        "crossing": dense_jacobian(graph, [crossing], by),
        "after_rates": [motion(node).get(0, graph.zero) for node in after],
        "after": dense_jacobian(graph, [after[k] for k in changed], by),
    }
    shapes = {"after": (len(changed), len(by))}
    cells = iter(factor_sums(graph, [node for part in parts.values() for node in part]))
    blocks = [
        (name, shapes.get(name, (len(part),)), [next(cells) for _ in part])
        for name, part in parts.items()
    ]
    return lower(graph, (n, 2 * s, c), blocks, passes=passes, own=sizes)
