"""The terms of a node that is a sum."""

from __future__ import annotations

from pydy._graph.node import Graph


def linear_terms(graph: Graph, node: int) -> dict[int, float]:
    """Split a node into terms with coefficients; the number c is c times one."""
    op, args = graph.ops[node], graph.args[node]
    if op == "const":
        return {graph.one: args[0]} if args[0] else {}
    if op != "sum":
        return {node: 1.0}
    return {graph.one: args[0], **dict(args[1])} if args[0] else dict(args[1])
