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
        if constant[node] or op in ("input", "factor", "solve", "item"):
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
