"""Rewriting passes that lower the number of operations.

Each pass takes the roots of a graph and returns new roots in the same graph. They reassociate
sums and products, which moves results by a few roundings.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.expand import expand_sums
from pydy._graph.factor import factor_sums
from pydy._graph.identities import merge_equal
from pydy._graph.node import Graph
from pydy._graph.passes import Passes
from pydy._graph.rewrite import substitute

__all__ = ["operations", "simplify"]


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
    factored = _factored(graph, roots, passes)
    # Among the nodes as they came there are more that are equal, and many more to look at.
    merged = merge_equal(graph, factored) if passes.merge else factored
    if merged == factored:
        return _expanded(graph, factored, passes)
    nodes = _factored(graph, merged, passes)
    much = operations(graph, nodes) < 0.9 * operations(graph, factored)
    nodes = merge_equal(graph, _expanded(graph, nodes, passes))
    if much:
        nodes = _expanded(graph, _factored(graph, nodes, passes), passes)
        nodes = merge_equal(graph, nodes)
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


def _factored(graph: Graph, roots: Sequence[int], passes: Passes) -> list[int]:
    return factor_sums(graph, roots) if passes.factor else list(roots)


def _expanded(graph: Graph, nodes: list[int], passes: Passes) -> list[int]:
    if not passes.expand:
        return nodes
    expanded = expand_sums(graph, nodes)
    less = expanded != nodes and operations(graph, expanded) < operations(graph, nodes)
    return expanded if less else nodes


def operations(graph: Graph, roots: Sequence[int]) -> int:
    """Estimate the operations of every call: nothing shared but whole nodes."""
    constant = graph.constant
    count = 0
    for node in graph.reachable(roots):
        op, args = graph.ops[node], graph.args[node]
        if constant[node] or op in ("input", "factor", "solve", "guard", "item"):
            continue
        if op == "sum":
            c0, terms = args
            moving = [c for n, c in terms if not constant[n]]
            count += len(moving) - 1 + (len(moving) < len(terms) or c0 != 0.0)
            count += sum(abs(c) != 1.0 for c in moving)
        elif op == "prod":
            powers = [abs(e) for n, e in args if not constant[n]]
            count += len(powers) - 1 + (len(powers) < len(args))
            count += sum(e.bit_length() - 1 for e in powers)
        else:
            count += 1
    return count
