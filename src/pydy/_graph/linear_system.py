"""Linear systems of nodes, solved at each evaluation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain, pairwise

from pydy._forks import cached_property
from pydy._graph.node import Graph
from pydy._graph.terms import linear_terms


@dataclass(frozen=True, eq=False)
class LinearSystem:
    """The linear systems ``matrix · x = column`` of one matrix, which is factorised once.

    The kind 'ldl' promises a symmetric positive definite matrix: only the lower triangle is used,
    and the solution falls back to LU where the promise does not hold. The other kind is 'lu'.
    """

    graph: Graph
    matrix: Sequence[Sequence[int]]
    kind: str = "lu"

    @cached_property
    def _entries(self) -> tuple[int, ...]:
        return tuple(chain.from_iterable(self.matrix))

    @cached_property
    def _factor(self) -> int:
        return self.graph.make("factor", (self.kind, len(self.matrix), self._entries))

    def solve(self, column: Sequence[int], *, judged: bool = False) -> list[int]:
        """Return the solution.

        Of a column of zeros it is zero, unless the matrix must be `judged`: where it is singular,
        nothing determines the solution.
        """
        return solve_factored(self.graph, self._factor, column, judged=judged)

    def solve_by_differences(self, column: Sequence[int]) -> list[int]:
        """Return the solution, by the differences of neighbouring unknowns where this is shorter.

        The matrix is judged.
        """
        change = self.kind == "ldl" and "differences" not in self.graph.off
        reduced = self.in_differences(column) if change else None
        if reduced is None:
            return self.solve(column, judged=True)
        system, right = reduced
        y = system.solve(right, judged=True)
        return [y[0], *(self.graph.sub(b, a) for a, b in pairwise(y))]

    def in_differences(self, column: Sequence[int]) -> tuple[LinearSystem, list[int]] | None:
        """Return a symmetric system in differences, when at least half of its entries vanish.

        Neighbouring rows of M and b agree except for one body where each coordinate carries
        everything after it. With T the identity less the first superdiagonal, T M Tᵀ is nearly
        diagonal and T b short: ``(T M Tᵀ) y = T b`` and ``x = Tᵀ y``, that is
        ``x[i] = y[i] − y[i − 1]``.
        """
        graph, matrix = self.graph, self.matrix
        n, zero = len(matrix), graph.zero
        if n < 3 or sum(entry != zero for entry in self._entries) < 0.75 * n * n:
            return None
        # Symmetric, with a row and a column of zeros after the last.
        cells = [[matrix[max(i, j)][min(i, j)] for j in range(n)] + [zero] for i in range(n)]
        cells.append([zero] * (n + 1))
        terms_of_cell: dict[int, dict[int, float]] = {}

        def terms(cell: int) -> dict[int, float]:
            if cell not in terms_of_cell:
                terms_of_cell[cell] = linear_terms(graph, cell)
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
        right = [linear_terms(graph, b) for b in column] + [{}]
        differences = [graph.sum(_minus(right[i], right[i + 1]).items()) for i in range(n)]
        return LinearSystem(graph, rows, self.kind), differences

    def guarded(self, columns: Sequence[int], sound: int, fast: Sequence[int]) -> list[int]:
        """Return the solutions for columns, one after the other, which are `fast` where `sound`.

        The fast ones are found in another way and equal the solutions; elsewhere the system is
        solved. Whatever the kind, a symmetric matrix must be positive definite, and derivatives are
        those of `fast` then. With a matrix of one, solutions are what is computed in one of two
        ways.
        """
        n = len(self.matrix)
        arguments = (n, self._entries, tuple(columns), sound, tuple(fast))
        node = self.graph.make("guard", arguments)
        return [self.graph.make("item", (node, k)) for k in range(len(columns))]


def solve_factored(
    graph: Graph, factor: int, column: Sequence[int], *, judged: bool = False
) -> list[int]:
    """Return the solution for a right-hand side of a ``factor`` node; see `LinearSystem.solve`."""
    if not judged and all(entry == graph.zero for entry in column):
        return [graph.zero] * len(column)
    vector = graph.make("solve", (factor, tuple(column)))
    return [graph.make("item", (vector, k)) for k in range(len(column))]


def _minus(a: dict[int, float], b: dict[int, float]) -> dict[int, float]:
    result = dict(a)
    for n, c in b.items():
        coefficient = result.get(n, 0.0) - c
        if coefficient:
            result[n] = coefficient
        else:
            result.pop(n, None)
    return result
