"""Rebuild a graph from its leaves with some nodes replaced."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from pydy._graph.node import Graph
from pydy._program import OPERATIONS

if TYPE_CHECKING:
    from pydy._program import Args


def rebuild(
    graph: Graph,
    roots: Sequence[int],
    rule: Callable[[int, str, Args], int],
) -> list[int]:
    """Return the roots with every node replaced by the result of ``rule(node, op, args)``.

    The operands in `args` are already replaced.
    """
    new: dict[int, int] = {}
    for node in graph.reachable(roots):
        args = graph.args[node]
        if any(new[n] != n for n in graph.operands(node)):
            args = replaced(graph, node, new)
        new[node] = rule(node, graph.ops[node], args)
    return [new[r] for r in roots]


def substitute(
    graph: Graph, roots: Sequence[int], mapping: Mapping[int, int], into: Graph | None = None
) -> list[int]:
    """Replace input nodes by other nodes, which may be those of another graph.

    With `into` the roots are copied into that graph, and all of their inputs must be replaced.
    """
    if into is not None:
        return _transplanted(graph, roots, into, mapping)
    if not set(mapping) & set(graph.reachable(roots)):
        return list(roots)

    def rule(node: int, op: str, args: Args) -> int:
        if node in mapping:
            return mapping[node]
        return node if args == graph.args[node] else make_canonical(graph, op, args)

    return rebuild(graph, roots, rule)


def replaced(graph: Graph, node: int, new: dict[int, int]) -> Args:
    """Return the arguments of `node` with its operands looked up in `new`."""
    return OPERATIONS.with_operands(graph.ops[node], graph.args[node], new)


def make_canonical(graph: Graph, op: str, args: Args) -> int:
    """Make `op` on `args` with the graph's own rules (folding, collecting, ordering)."""
    if op == "sum":
        return graph.sum(args[1], args[0])
    if op == "prod":
        return graph.product(args)
    return graph.call(op, *args) if op in OPERATIONS else graph.make(op, args)


def _transplanted(
    source: Graph, roots: Sequence[int], graph: Graph, inputs: Mapping[int, int]
) -> list[int]:
    """Return copies of nodes in another graph, with nodes of that graph for their inputs."""
    new: dict[int, int] = {}
    for node in source.reachable(roots):
        new[node] = (
            inputs[node]
            if node in inputs
            else make_canonical(graph, source.ops[node], replaced(source, node, new))
        )
    return [new[r] for r in roots]
