"""What nodes cost before they are lowered."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.node import Graph


def operations(graph: Graph, roots: Sequence[int], known: dict[int, int] | None = None) -> int:
    """Estimate the operations of every call: nothing shared but whole nodes.

    Counts of single nodes are `known` to those who count again and again.
    """
    known = {} if known is None else known
    nodes = graph.reachable(roots)
    for node in nodes:
        if node not in known:
            known[node] = _own(graph, node)
    return sum(map(known.__getitem__, nodes))


def _own(graph: Graph, node: int) -> int:
    """Estimate a node's own operations."""
    constant, op, args = graph.constant, graph.ops[node], graph.args[node]
    if constant[node] or op in ("input", "factor", "solve", "guard", "item", "kept"):
        return 0
    if op == "sum":
        c0, terms = args
        moving = [c for n, c in terms if not constant[n]]
        count: int = len(moving) - 1 + (len(moving) < len(terms) or c0 != 0.0)
        return count + sum(1 for c in moving if abs(c) != 1.0)
    if op == "prod":
        powers = [abs(e) for n, e in args if not constant[n]]
        count = len(powers) - 1 + (len(powers) < len(args))
        return count + sum(int(e).bit_length() - 1 for e in powers)
    return 1
