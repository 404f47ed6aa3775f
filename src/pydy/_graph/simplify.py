"""Run the passes that lower the number of operations."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.counting import operations
from pydy._graph.node import Graph
from pydy._graph.passes import SIMPLIFICATIONS
from pydy._graph.rewrite import substitute
from pydy._graph.switches import Passes

__all__ = ["simplify"]


def simplify(graph: Graph, roots: Sequence[int], passes: Passes | None = None) -> list[int]:
    """Return roots that cost fewer operations.

    Parameters
    ----------
    graph : Graph
    roots : sequence of nodes
    passes : Passes, optional
        All by default.
    """
    passes = Passes() if passes is None else passes
    guards = [n for n in graph.reachable(roots) if graph.ops[n] == "guard"]
    if guards:
        return _around_guards(graph, roots, guards, passes)
    nodes, cost = list(roots), operations(graph, roots)
    for name, function in SIMPLIFICATIONS:
        if name not in passes:
            continue
        tried = function(graph, nodes)
        if tried != nodes and (less := operations(graph, tried)) < cost:
            nodes, cost = tried, less
    return nodes


def _around_guards(
    graph: Graph, roots: Sequence[int], guards: Sequence[int], passes: Passes
) -> list[int]:
    """Simplify what every call computes; what only a guard's fallback needs stays as it is."""
    away = {guard: graph.input("guard", k) for k, guard in enumerate(guards)}
    hot = [[graph.args[guard][3], *graph.args[guard][4]] for guard in guards]
    every = substitute(graph, [*roots, *(n for part in hot for n in part)], away)
    nodes = iter(simplify(graph, every, passes))
    new_roots = [next(nodes) for _ in roots]
    back: dict[int, int] = {}
    for guard, part in zip(guards, hot, strict=True):
        n, entries, column = graph.args[guard][:3]
        sound, *fast = substitute(graph, [next(nodes) for _ in part], back)
        back[away[guard]] = graph.make("guard", (n, entries, column, sound, tuple(fast)))
    return substitute(graph, new_roots, back)
