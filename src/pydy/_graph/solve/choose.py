"""How linear systems are solved.

Before equations of motion are simplified, other unknowns may make them shorter. When they are
lowered, the factorisation of a matrix is written out where that is short, and else left to a loop.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from itertools import pairwise
from typing import Protocol

from pydy._graph.node import Graph
from pydy._graph.solve import ldl, lu
from pydy._program import Tape, symmetric


class Factor(Protocol):
    """A matrix that is factorised."""

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""


class LoopFactor:
    """A factorisation that the back end does in a loop."""

    def __init__(self, tape: Tape, kind: str, n: int, entries: list[int]) -> None:
        self.tape = tape
        cells = symmetric(n, entries) if kind == "ldl" else entries
        self.node = tape.make("factor", kind, n, tuple(cells))

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""
        return self.tape.make("solve", self.node, tuple(column))


def factorised(
    tape: Tape,
    kind: str,
    n: int,
    entries: list[int],
    sizes: tuple[int, int, int],
    off: Container[str],
) -> Factor:
    """Factorise a matrix of nodes of a tape, of the kind that `Graph.solve` describes.

    Its pivots are chosen at generic inputs of these sizes; a kind that is `off` is not written out.
    """
    factor: Factor | None = None
    if kind not in off and kind == "ldl":
        factor = ldl.unrolled(tape, n, entries)
    elif kind not in off:
        factor = lu.unrolled(tape, n, entries, sizes)
    return factor or LoopFactor(tape, kind, n, entries)


def solve_accelerations(
    graph: Graph,
    rows: list[list[int]],
    forcing: list[int],
    kind: str,
) -> list[int]:
    """Return the solution of the equations of motion ``M u' = F``."""
    change = kind == "ldl" and "differences" not in graph.off
    reduced = difference_basis(graph, rows, forcing) if change else None
    if reduced is None:
        return graph.solve(rows, [forcing], kind, judged=True)[0]
    y = graph.solve(reduced[0], [reduced[1]], kind, judged=True)[0]
    return [y[0], *(graph.sub(b, a) for a, b in pairwise(y))]


def difference_basis(
    graph: Graph, matrix: Sequence[Sequence[int]], column: Sequence[int]
) -> tuple[list[list[int]], list[int]] | None:
    """Return a symmetric system in differences, when at least half of its entries vanish.

    Neighbouring rows of M and b agree except for one body where each coordinate carries everything
    after it. With T the identity less the first superdiagonal, T M Tᵀ is nearly diagonal and T b
    short: ``(T M Tᵀ) y = T b`` and ``x = Tᵀ y``, that is ``x[i] = y[i] − y[i − 1]``.
    """
    n = len(matrix)
    if n < 3:
        return None
    zero = graph.zero
    if sum(entry != zero for row in matrix for entry in row) < 0.75 * n * n:
        return None
    # Symmetric, with a row and a column of zeros after the last.
    cells = [[matrix[max(i, j)][min(i, j)] for j in range(n)] + [zero] for i in range(n)]
    cells.append([zero] * (n + 1))
    terms_of_cell: dict[int, dict[int, float]] = {}

    def terms(cell: int) -> dict[int, float]:
        if cell not in terms_of_cell:
            terms_of_cell[cell] = graph.linear(cell)
        return terms_of_cell[cell]

    def difference(i: int, j: int) -> dict[int, float]:
        entry, right = cells[i][j], cells[i][j + 1]
        below, across = cells[i + 1][j], cells[i + 1][j + 1]
        if (entry, below) == (right, across) or (entry, right) == (below, across):
            return {}
        above = _minus(terms(entry), terms(below))
        return _minus(above, _minus(terms(right), terms(across)))

    # The last rows tell at little cost whether it is worth while.
    if any(difference(n - 1, j) for j in range(n - 2)):
        return None
    steps = [[difference(i, j) for j in range(i + 1)] for i in range(n)]
    filled = sum(2 * bool(step) for row in steps for step in row)
    if filled > 0.5 * n * n + n:
        return None
    rows = [[zero] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            rows[i][j] = rows[j][i] = graph.sum(steps[i][j].items())
    right = [graph.linear(b) for b in column] + [{}]
    differences = [graph.sum(_minus(right[i], right[i + 1]).items()) for i in range(n)]
    return rows, differences


def _minus(a: dict[int, float], b: dict[int, float]) -> dict[int, float]:
    result = dict(a)
    for n, c in b.items():
        coefficient = result.get(n, 0.0) - c
        if coefficient:
            result[n] = coefficient
        else:
            result.pop(n, None)
    return result
