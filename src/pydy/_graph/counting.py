"""What nodes cost before they are lowered."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.node import Graph

__all__ = ["operations"]


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
