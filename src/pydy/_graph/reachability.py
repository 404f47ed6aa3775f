"""How far the value of a node may move while its inputs do: bounds as further nodes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from pydy._graph.node import Graph

_NOT_STEEP = frozenset(("sin", "cos", "abs", "atan", "tanh", "asinh"))  # slopes are at most one


def reach(graph: Graph, nodes: Sequence[int], moving: Mapping[int, int]) -> list[int | None]:
    """Return how far `nodes` may come from their values, as new nodes; None where that is unknown.

    `moving` has for inputs nodes that say how far these may come from their own; of those that are
    not in it, the constants alone stay what they are. No such motion makes a node undefined.
    """
    distances: dict[int, int | None] = {}
    for node in graph.reachable(nodes):
        distances[node] = _reach(graph, node, distances, moving)
    return [distances[node] for node in nodes]


def _reach(
    g: Graph, node: int, distances: Mapping[int, int | None], moving: Mapping[int, int]
) -> int | None:
    op, args = g.ops[node], g.args[node]
    if g.constant[node]:
        return g.zero
    if op == "input":
        return moving.get(node)
    of_operands = [n for n in (distances[operand] for operand in g.operands(node)) if n is not None]
    if len(of_operands) < len(g.operands(node)):
        return None
    if op == "sum":
        return g.sum([(n, abs(c)) for n, (_, c) in zip(of_operands, args[1], strict=True)])
    if op == "prod":
        return _of_product(g, args, of_operands)
    if all(n == g.zero for n in of_operands):
        return g.zero
    if op in _NOT_STEEP:
        return of_operands[0]
    if op in ("min", "max"):
        return g.call("max", *of_operands)
    if op == "select" and of_operands[0] == g.zero:
        return g.call("select", args[0], of_operands[1], of_operands[2])
    if op == "sqrt":
        return _if_less(g, of_operands[0], args[0], g.div(of_operands[0], node))
    if op == "exp":
        return g.sum([(g.call("exp", g.add(args[0], of_operands[0])), 1.0), (node, -1.0)])
    return None


def _of_product(g: Graph, factors: Sequence[tuple[int, int]], distances: Sequence[int]) -> int:
    """Return |a| s + |b| r + r s for each further factor b, which moves by s."""
    value, moved = g.one, g.zero
    for (n, exponent), distance in zip(factors, distances, strict=True):
        size, factor, step = g.call("abs", n), n, distance
        if exponent < 0:  # |1/(b + s) − 1/b| = s/(|b| (|b| − s))
            inside = g.sum([(size, 1.0), (distance, -1.0)])
            factor = g.powi(n, -1)
            step = _if_less(g, distance, size, g.div(distance, g.mul(size, inside)))
        for _ in range(abs(exponent)):
            terms = [(g.mul(g.call("abs", value), step), 1.0), (g.mul(moved, step), 1.0)]
            moved = g.sum([*terms, (g.mul(moved, g.call("abs", factor)), 1.0)])
            value = g.mul(value, factor)
    return moved


def _if_less(g: Graph, a: int, b: int, value: int) -> int:
    """Return a value if a < b, else infinity."""
    return g.call("select", g.call("lt", a, b), value, g.const(math.inf))
