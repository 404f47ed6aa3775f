"""Solve equations of motion ``M u' = F`` in the unknowns that cost fewest operations."""

from __future__ import annotations

from itertools import pairwise

from pydy._graph.body_basis import body_basis
from pydy._graph.node import Graph
from pydy._graph.structure import difference_basis

__all__ = ["solve_accelerations"]


def solve_accelerations(
    graph: Graph, rows: list[list[int]], forcing: list[int], kind: str, *, rebase: bool = True
) -> list[int]:
    """Return the solution of the equations of motion; see `Passes` for `rebase`."""
    if kind == "ldl" and rebase:
        if (chain := difference_basis(graph, rows, forcing)) is not None:
            y = graph.solve(chain[0], [chain[1]], kind)[0]
            return [y[0], *(graph.sub(b, a) for a, b in pairwise(y))]
        if (basis := body_basis(graph, rows, forcing)) is not None:
            return basis.given_unknowns(graph.solve(basis.matrix, [basis.column], kind)[0])
    return graph.solve(rows, [forcing], kind)[0]
