"""Make nodes that are equal as functions one: what hash-consing cannot see.

Equations of motion hold the same quantity in several forms: a speed beside the derivatives it was
defined by, written out; an entry of a matrix and its mirror image; the sum of a squared sine and
cosine. `pydy._graph.identities` tells which are equal.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.identities import evaluated
from pydy._graph.node import Graph
from pydy._graph.passes.expand import is_exact
from pydy._graph.rewrite import make_canonical, replaced
from pydy._modular import PRIME
from pydy._program import OPERATIONS


def merge_equal(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Return roots in which equal nodes, or opposite ones, are one: the one that costs least.

    A node is never replaced by one with other denominators or functions than its own, which may be
    undefined where the node is not, nor a product that keeps x − y by a sum in which it cancels.
    """
    nodes = _with_candidates(graph, graph.reachable(roots))
    values, poles, costs = evaluated(graph, nodes)
    best: dict[int, list[int]] = {}
    for constant in (graph.zero, graph.one):
        best[values[constant]] = [constant]
    stand_in: dict[int, int] = {}
    # Operands cost less than what is made of them.
    order = sorted(nodes, key=lambda node: (costs[node], node))
    for node in order:
        value = values[node]
        group = best.setdefault(min(value, PRIME - value), [])
        stand_in[node] = node
        if graph.ops[node] in OPERATIONS.solves or graph.ops[node] == "bool":
            continue
        for twin in group:
            if poles[twin] <= poles[node] and not _is_rougher(graph, twin, node):
                stand_in[node] = twin
                break
        else:
            group.append(node)
    if all(node == twin for node, twin in stand_in.items()):
        return list(roots)
    new: dict[int, int] = {graph.zero: graph.zero, graph.one: graph.one}
    for node in order:
        twin = stand_in[node]
        if twin == node:
            if all(new[n] == n for n in graph.operands(node)):
                new[node] = node
            else:
                new[node] = make_canonical(graph, graph.ops[node], replaced(graph, node, new))
        elif values[twin] == values[node]:
            new[node] = new[twin]
        else:
            new[node] = graph.neg(new[twin])
    return [new[root] for root in roots]


def _with_candidates(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Add candidates for equal nodes: reciprocals, and squares of sines and cosines."""
    candidates: dict[int, None] = {}
    angles: dict[int, list[int]] = {}
    for node in nodes:
        op, args = graph.ops[node], graph.args[node]
        if op == "prod":
            candidates.update((graph.powi(n, -1), None) for n, e in args if e < 0)
        elif op in OPERATIONS.angles:
            angles.setdefault(args[0], []).append(node)
    squared = [node for pair in angles.values() if len(pair) == 2 for node in pair]
    candidates.update((graph.powi(node, 2), None) for node in squared)
    members, stack = set(nodes), list(candidates)
    while stack:
        node = stack.pop()
        if node not in members:
            members.add(node)
            stack += graph.operands(node)
    return sorted(members)


def _is_rougher(graph: Graph, substitute: int, node: int) -> bool:
    """Return whether `substitute` is a sum that may cancel where `node`, a product, is exact."""
    _, product = graph.scaled(node)
    if graph.ops[product] != "prod" or graph.ops[graph.scaled(substitute)[1]] != "sum":
        return False
    return any(is_exact(graph, n) for n, _ in graph.args[product])
