"""Dependent speeds by divisions, where few depend on each other.

The rows of a constraint matrix are taken in groups that hold as many new unknowns as rows, one to
three; each group is solved by Cramer's rule. Where a group is singular its unknowns are not finite,
as in SymPy's solutions with symbols, in place of a report that a solve failed.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from pydy._graph.node import Graph
from pydy._mechanics.multipliers import usual_sizes
from pydy._mechanics.tuning import CLEAR

__all__ = ["divided"]

_LARGEST = 3


def divided(
    graph: Graph, matrix: Sequence[Sequence[int]], columns: Sequence[Sequence[int]]
) -> tuple[list[list[int]], int] | None:
    """Return the solutions of ``matrix · x = column``, and whether no group is nearly singular.

    None where larger groups hang together.
    """
    groups = _groups(graph, matrix)
    if groups is None:
        return None
    solutions: list[list[int]] = []
    blocks = [[[matrix[i][j] for j in own] for i in rows] for rows, own in groups]
    inverses = [_inverse(graph, block) for block in blocks]
    clear = graph.boolean(True)
    for block in blocks:
        clear = graph.call("and", clear, _clear(graph, block))
    for column in columns:
        found: dict[int, int] = {}
        for (rows, own), inverse in zip(groups, inverses, strict=True):
            rest = [
                graph.sum(
                    [(column[i], 1.0)]
                    + [(graph.mul(matrix[i][j], x), -1.0) for j, x in found.items()]
                )
                for i in rows
            ]
            for j, line in zip(own, inverse, strict=True):
                terms = [(graph.mul(a, b), 1.0) for a, b in zip(line, rest, strict=True)]
                found[j] = graph.sum(terms)
        solutions.append([found[j] for j in range(len(column))])
    return solutions, clear


def _groups(
    graph: Graph, matrix: Sequence[Sequence[int]]
) -> list[tuple[tuple[int, ...], tuple[int, ...]]] | None:
    """Return rows and the unknowns that they give, in order."""
    used = {i: {j for j, n in enumerate(row) if n != graph.zero} for i, row in enumerate(matrix)}
    found = []
    while used:
        group = next(
            (
                (rows, own)
                for size in range(1, _LARGEST + 1)
                for rows in combinations(used, size)
                if len(own := set().union(*(used[i] for i in rows))) == size
            ),
            None,
        )
        if group is None:
            return None
        rows, own = group
        found.append((rows, tuple(sorted(own))))
        used = {i: columns - own for i, columns in used.items() if i not in rows}
    return found


def _determinant(graph: Graph, matrix: list[list[int]]) -> int:
    minors = [_minor(graph, matrix, 0, j) for j in range(len(matrix))]
    return graph.sum([(graph.mul(a, b), 1.0) for a, b in zip(matrix[0], minors, strict=True)])


def _clear(graph: Graph, matrix: list[list[int]]) -> int:
    """Return whether a determinant is not small beside what it is at other states."""
    node = _determinant(graph, matrix)
    if graph.constant[node]:
        return graph.boolean(True)
    size = graph.call("abs", node)
    (usual,) = usual_sizes(graph, [size])
    # Where there is no usual size, as at places that an expression does not reach, none is small.
    return graph.call("not", graph.call("le", size, graph.sum([(usual, CLEAR)])))


def _inverse(graph: Graph, matrix: list[list[int]]) -> list[list[int]]:
    n = len(matrix)
    minors = [[_minor(graph, matrix, i, j) for j in range(n)] for i in range(n)]
    inverse = graph.powi(_determinant(graph, matrix), -1)
    return [[graph.mul(minors[i][j], inverse) for i in range(n)] for j in range(n)]


def _minor(graph: Graph, matrix: list[list[int]], i: int, j: int) -> int:
    """Return a cofactor of a matrix of up to three rows."""
    n = len(matrix)
    if n == 1:
        return graph.one
    if n == 2:
        node = matrix[1 - i][1 - j]
        return node if i == j else graph.neg(node)
    (a, b), (c, d) = ((i + 1) % 3, (i + 2) % 3), ((j + 1) % 3, (j + 2) % 3)
    return graph.sub(graph.mul(matrix[a][c], matrix[b][d]), graph.mul(matrix[a][d], matrix[b][c]))
