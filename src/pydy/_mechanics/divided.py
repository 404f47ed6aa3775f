"""Dependent speeds by divisions, where few depend on each other.

The rows of a constraint matrix are taken in groups that hold as many new unknowns as rows, one to
three; each group is solved by Cramer's rule. Where a group is singular its unknowns are not finite,
as in SymPy's solutions with symbols, in place of a report that a solve failed.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import combinations

from pydy._graph.node import Graph
from pydy._mechanics.multipliers import usual_sizes
from pydy._mechanics.tuning import CLEAR

__all__ = ["Group", "divided"]

_LARGEST = 3


@dataclass(frozen=True)
class Group:
    """Unknowns that are solved for together.

    Attributes
    ----------
    unknowns : tuple of int
    determinant : node
        By minors.
    size : node
        Its absolute value, in whatever way it was found.
    """

    unknowns: tuple[int, ...]
    determinant: int
    size: int

    def clear(self, graph: Graph, spread: int | None = None) -> int:
        """Return whether the determinant is not small beside what it is at other states.

        Parameters
        ----------
        graph : Graph
        spread : node, optional
            The squares of determinants with other unknowns, in units of the square of this one, and
            one: any of them is enough for the rows to be independent.
        """
        if graph.constant[self.determinant]:
            return graph.boolean(True)
        (usual,) = usual_sizes(graph, [graph.call("abs", self.determinant)])
        size, limit = self.size, graph.sum([(usual, CLEAR)])
        if spread is not None:
            size, limit = graph.mul(size, size, spread), graph.mul(limit, limit)
        # Where there is no usual size, as at places that an expression does not reach, none is
        # small.
        return graph.call("not", graph.call("le", size, limit))


def divided(
    graph: Graph,
    matrix: Sequence[Sequence[int]],
    columns: Sequence[Sequence[int]],
    loose: Collection[int] = (),
) -> tuple[list[list[int]], list[Group]] | None:
    """Return the solutions of ``matrix · x = column``, and the groups of unknowns.

    None where larger groups hang together. Groups with `loose` unknowns are eliminated with
    pivoting: where two of three singular values are small, Cramer's rule loses the digits of both.
    """
    ordered = _groups(graph, matrix)
    if ordered is None:
        return None
    solutions: list[dict[int, int]] = [{} for _ in columns]
    groups = []
    for rows, own in ordered:
        block = [[matrix[i][j] for j in own] for i in rows]
        rests = [
            [
                graph.sum(
                    [(column[i], 1.0)]
                    + [(graph.mul(matrix[i][j], x), -1.0) for j, x in found.items()]
                )
                for i in rows
            ]
            for column, found in zip(columns, solutions, strict=True)
        ]
        determinant = _determinant(graph, block)
        size = graph.call("abs", determinant)
        if len(own) > 1 and not set(own).isdisjoint(loose):
            values, size = _eliminated(graph, block, rests)
        else:
            inverse = _inverse(graph, block)
            values = [
                [
                    graph.sum([(graph.mul(a, b), 1.0) for a, b in zip(line, rest, strict=True)])
                    for line in inverse
                ]
                for rest in rests
            ]
        for found, several in zip(solutions, values, strict=True):
            found.update(zip(own, several, strict=True))
        groups.append(Group(own, determinant, size))
    return [[found[j] for j in range(len(matrix))] for found in solutions], groups


def _eliminated(
    graph: Graph, block: Sequence[list[int]], rests: Sequence[list[int]]
) -> tuple[list[list[int]], int]:
    """Return the solutions, and the size of the determinant.

    Rows are exchanged by size of the pivot, in units of the largest entry of each.
    """
    g, n = graph, len(block)
    lines = [[*row, *(rest[i] for rest in rests)] for i, row in enumerate(block)]
    for i, row in enumerate(block):
        size = g.call("abs", row[0])
        for other in row[1:]:
            size = g.call("max", size, g.call("abs", other))
        lines[i].append(size)
    for k in range(n):
        for i in range(k + 1, n):
            one, two = lines[k], lines[i]
            here = g.mul(g.call("abs", one[k]), two[-1])
            there = g.mul(g.call("abs", two[k]), one[-1])
            swap = g.call("lt", here, there)
            lines[k], lines[i] = (
                [
                    b if place < k else g.call("select", swap, a, b)
                    for place, (a, b) in enumerate(zip(*pair, strict=True))
                ]
                for pair in ((two, one), (one, two))
            )
        for i in range(k + 1, n):
            share = g.div(lines[i][k], lines[k][k])
            for j in (*range(k + 1, n), *range(n, n + len(rests))):
                lines[i][j] = g.sub(lines[i][j], g.mul(share, lines[k][j]))
    found = [[g.zero] * n for _ in rests]
    for c, values in enumerate(found):
        for k in reversed(range(n)):
            terms = [(g.mul(lines[k][j], values[j]), -1.0) for j in range(k + 1, n)]
            values[k] = g.div(g.sum([(lines[k][n + c], 1.0), *terms]), lines[k][k])
    return found, g.call("abs", g.mul(*(lines[k][k] for k in range(n))))


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
