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
    found: dict[int, int | None] = {}
    for node in graph.reachable(nodes):
        found[node] = _reach(graph, node, found, moving)
    return [found[node] for node in nodes]


def _reach(
    g: Graph, node: int, found: Mapping[int, int | None], moving: Mapping[int, int]
) -> int | None:
    op, args = g.ops[node], g.args[node]
    if g.constant[node]:
        return g.zero
    if op == "input":
        return moving.get(node)
    own = [n for n in (found[operand] for operand in g.operands(node)) if n is not None]
    if len(own) < len(g.operands(node)):
        return None
    if op == "sum":
        return g.sum([(n, abs(c)) for n, (_, c) in zip(own, args[1], strict=True)])
    if op == "prod":
        return _of_product(g, args, own)
    if all(n == g.zero for n in own):
        return g.zero
    if op in _NOT_STEEP:
        return own[0]
    if op in ("min", "max"):
        return g.call("max", *own)
    if op == "select" and own[0] == g.zero:
        return g.call("select", args[0], own[1], own[2])
    if op == "sqrt":
        return _if_less(g, own[0], args[0], g.div(own[0], node))
    if op == "exp":
        return g.sum([(g.call("exp", g.add(args[0], own[0])), 1.0), (node, -1.0)])
    return None


def _of_product(g: Graph, factors: Sequence[tuple[int, int]], own: Sequence[int]) -> int:
    """Return |a| s + |b| r + r s for each further factor b, which moves by s."""
    value, moved = g.one, g.zero
    for (n, exponent), by in zip(factors, own, strict=True):
        size, factor, step = g.call("abs", n), n, by
        if exponent < 0:  # |1/(b + s) − 1/b| = s/(|b| (|b| − s))
            inside = g.sum([(size, 1.0), (by, -1.0)])
            factor = g.powi(n, -1)
            step = _if_less(g, by, size, g.div(by, g.mul(size, inside)))
        for _ in range(abs(exponent)):
            terms = [(g.mul(g.call("abs", value), step), 1.0), (g.mul(moved, step), 1.0)]
            moved = g.sum([*terms, (g.mul(moved, g.call("abs", factor)), 1.0)])
            value = g.mul(value, factor)
    return moved


def _if_less(g: Graph, a: int, b: int, value: int) -> int:
    """Return a value if a < b, else infinity."""
    return g.call("select", g.call("lt", a, b), value, g.const(math.inf))
