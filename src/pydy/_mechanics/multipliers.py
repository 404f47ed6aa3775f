"""Accelerations by multipliers, whatever the rank of the constraints.

With M u' = F + Jᵀ λ and J u' + b = 0 the multipliers solve S λ = r, with S = J M⁻¹ Jᵀ and
r = −(J M⁻¹ F + b). Rows that are independent at generic states are enough, until a pivot of S is
small: where a mechanism passes a singular position, S of any rows is singular, but the equations
are consistent. There all rows take part. With a small diagonal D,

    (S + D) (λₖ₊₁ − λₖ) = r − S λₖ,        λ₀ = 0,

leads to the least λ: what r has along an eigenvalue σ comes nearer by D/(σ + D) each time, and what
it has along none stays zero (the proximal point algorithm: Parikh, Boyd, Proximal Algorithms, 2014,
section 4.1). The steps end where rounding would be amplified: a position that is known to ε moves
r/σ by ε/δ³ at a distance δ from the singular position, with σ ~ δ².
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._mechanics.tuning import NOTHING, SHIFT, SMALL_PIVOT, SOUND_PIVOT

__all__ = [
    "accelerations_of_held",
    "accelerations_written_out",
    "multipliers_of",
    "orthogonal",
    "solved_soundly",
    "usual_sizes",
]

_HOMOGENEOUS = {"sum", "prod", "sqrt", "abs", "pow"}
_STEPS = 6  # after the first: what is 1e-2 of the size is found to rounding
_STATES = (0.37, 0.74, 1.13)  # from here the irregular states go at which rows are measured


def accelerations_of_held(
    graph: Graph,
    matrix: list[list[int]],
    forcing: list[int],
    rows: Sequence[list[int]],
    drift: Sequence[int],
    rank: int,
) -> list[int]:
    """Return u' with M u' = F + Jᵀ λ and J u' + b = 0.

    Parameters
    ----------
    graph : Graph
    matrix, forcing : M and F for all speeds, dependent or not
        M is positive definite.
    rows, drift : J and b
        Rows may depend on each other, but must not contradict each other.
    rank : int
        So many rows, the first, are independent at generic states.
    """
    free, *moved = graph.solve(matrix, [forcing, *rows], "ldl")
    return _held(graph, matrix, (free, moved), rows, drift, rank, written=False)


def accelerations_written_out(
    graph: Graph,
    matrix: list[list[int]],
    forcing: list[int],
    rows: Sequence[list[int]],
    drift: Sequence[int],
) -> tuple[list[int], int]:
    """Return the same with eliminations written out, and whether M is positive definite.

    That is long, but may be left to a guard's fallback.
    """
    inner, definite = _Elimination(graph, matrix), graph.boolean(True)
    for k, pivot in enumerate(inner.pivots):
        limit = graph.sum([(matrix[k][k], SMALL_PIVOT)])
        definite = graph.call("and", definite, graph.call("lt", limit, pivot))
    free, *moved = (inner.solution(column) for column in (forcing, *rows))
    held = _held(graph, matrix, (free, moved), rows, drift, len(rows), written=True)
    return held, definite


def _held(
    graph: Graph,
    matrix: list[list[int]],
    by_masses: tuple[list[int], list[list[int]]],
    rows: Sequence[list[int]],
    drift: Sequence[int],
    rank: int,
    *,
    written: bool,
) -> list[int]:
    free, moved = by_masses
    weights = [graph.powi(matrix[k][k], -1) for k in range(len(free))]
    square = _products(graph, rows, moved)
    sizes = _sizes(graph, rows, weights, square)
    right = [
        graph.sum([(_dot(graph, row, free), -1.0), (b, -1.0)])
        for row, b in zip(rows, drift, strict=True)
    ]
    first = [row[:rank] for row in square[:rank]]
    some, sound = solved_soundly(graph, first, right[:rank], sizes[:rank])
    some += [graph.zero] * (len(rows) - rank)
    least = _least(graph, square, right, sizes, written=written)
    found = [graph.call("select", sound, a, b) for a, b in zip(some, least, strict=True)]
    return [
        graph.sum([(free[i], 1.0), (_dot(graph, [row[i] for row in moved], found), 1.0)])
        for i in range(len(free))
    ]


def multipliers_of(
    graph: Graph, rows: Sequence[list[int]], force: list[int], *, redundant: bool
) -> list[int]:
    """Return λ with Jᵀ λ = f, the least where rows of J depend on each other."""
    square = _products(graph, rows, rows)
    sizes = _sizes(graph, rows, [graph.one] * len(force), square)
    right = [_dot(graph, row, force) for row in rows]
    least = _least(graph, square, right, sizes)
    if redundant:
        return least
    found, sound = solved_soundly(graph, square, right, sizes)
    return [graph.call("select", sound, a, b) for a, b in zip(found, least, strict=True)]


def orthogonal(
    graph: Graph, rows: Sequence[list[int]], drift: Sequence[int]
) -> tuple[list[list[int]], list[int]]:
    """Return rows with the same solutions of J u' + b = 0, orthogonal, and their b.

    Gram and Schmidt's, each row taken twice (Giraud, Langou, Rozložník, 2005): nearly parallel rows
    have multipliers so large that they swallow F, these have none. A row of zeros remains one.
    """
    found: list[tuple[tuple[list[int], int], int]] = []
    for row, b in zip(rows, drift, strict=True):
        line = [*row, b]
        for _ in range(2):
            for (other, c), size in found:
                share = graph.div(_dot(graph, line[:-1], other), size)
                line = [
                    graph.sub(x, graph.mul(share, y))
                    for x, y in zip(line, [*other, c], strict=True)
                ]
        size = _dot(graph, line[:-1], line[:-1])
        nothing = graph.call("lt", size, graph.const(NOTHING))
        size = graph.call("select", nothing, graph.one, size)
        found.append(((line[:-1], line[-1]), size))
    return [row for (row, _), _ in found], [b for (_, b), _ in found]


def _dot(graph: Graph, a: Sequence[int], b: Sequence[int]) -> int:
    return graph.sum([(graph.mul(x, y), 1.0) for x, y in zip(a, b, strict=True)])


def _products(graph: Graph, a: Sequence[list[int]], b: Sequence[list[int]]) -> list[list[int]]:
    """Return a bᵀ, which is symmetric."""
    lower = [[_dot(graph, a[i], b[j]) for j in range(i + 1)] for i in range(len(a))]
    return [[lower[max(i, j)][min(i, j)] for j in range(len(a))] for i in range(len(a))]


class _Elimination:
    """L D Lᵀ of a symmetric matrix, written out.

    Attributes
    ----------
    pivots : list of nodes
        D.
    """

    def __init__(self, graph: Graph, square: Sequence[list[int]]) -> None:
        n = len(square)
        cell = [list(row) for row in square]
        self.graph, self.pivots = graph, [graph.zero] * n
        self._inverses = [graph.zero] * n
        self._lower = [[graph.zero] * n for _ in range(n)]
        for j in range(n):
            self.pivots[j] = cell[j][j]
            self._inverses[j] = graph.powi(cell[j][j], -1)
            for i in range(j + 1, n):
                self._lower[i][j] = graph.mul(cell[i][j], self._inverses[j])
            for i in range(j + 1, n):
                for k in range(j + 1, i + 1):
                    taken = graph.mul(self._lower[i][j], cell[k][j])
                    cell[i][k] = cell[k][i] = graph.sub(cell[i][k], taken)

    def solution(self, right: Sequence[int]) -> list[int]:
        """Return the solution for one right-hand side."""
        graph, lower = self.graph, self._lower
        n, found = len(right), list(right)
        for j in range(n):
            for i in range(j + 1, n):
                found[i] = graph.sub(found[i], graph.mul(lower[i][j], found[j]))
        found = [graph.mul(a, b) for a, b in zip(found, self._inverses, strict=True)]
        for j in reversed(range(n)):
            for i in range(j + 1, n):
                found[j] = graph.sub(found[j], graph.mul(lower[i][j], found[i]))
        return found


def solved_soundly(
    graph: Graph, square: Sequence[list[int]], right: list[int], sizes: list[int]
) -> tuple[list[int], int]:
    """Return the solution by LDLᵀ, and whether no pivot is small beside its row's size."""
    eliminated, sound = _Elimination(graph, square), graph.boolean(True)
    for pivot, size in zip(eliminated.pivots, sizes, strict=True):
        limit = graph.sum([(size, SOUND_PIVOT)])
        sound = graph.call("and", sound, graph.call("lt", limit, pivot))
    return eliminated.solution(right), sound


def _sizes(
    graph: Graph,
    rows: Sequence[list[int]],
    weights: Sequence[int],
    square: Sequence[list[int]],
) -> list[int]:
    """Return what is usual on the diagonal of S, where a row of J may be about to vanish.

    That is what is there, and no more than the mean of all rows and than what the row would be at
    other states: rows in different units are compared with themselves.
    """
    nodes = [_dot(graph, [graph.powi(c, 2) for c in row], weights) for row in rows]
    mean = graph.sum([(square[i][i], 1.0 / len(rows)) for i in range(len(rows))])
    return [
        graph.add(square[i][i], graph.call("min", mean, usual))
        for i, usual in enumerate(usual_sizes(graph, nodes))
    ]


def usual_sizes(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return the means of some nodes at irregular states, which depend on constants.

    Angles are of order one. Coordinates that are used outside of trigonometric functions may be in
    any unit: theirs is the length of them together.
    """
    moving = [
        n for n in graph.reachable(nodes) if graph.ops[n] == "input" and not graph.constant[n]
    ]
    lengths = _used_as_they_are(graph, nodes) & {n for n in moving if graph.args[n][0] != "t"}
    unit = graph.one
    if lengths:
        squares = graph.sum([(graph.powi(n, 2), 1.0) for n in sorted(lengths)])
        unit = graph.call("sqrt", squares)
    numbers = [[(start + 0.618 * k) % 1.0 + 0.2 for k in range(len(moving))] for start in _STATES]
    states = [
        {
            n: graph.sum([(unit if n in lengths else graph.one, number)])
            for n, number in zip(moving, several, strict=True)
        }
        for several in numbers
    ]
    elsewhere = zip(*(substitute(graph, nodes, state) for state in states), strict=True)
    return [graph.sum([(n, 1.0 / len(several)) for n in several]) for several in elsewhere]


def _used_as_they_are(graph: Graph, nodes: Sequence[int]) -> set[int]:
    """Return what nodes depend on other than through functions like the sine."""
    found: set[int] = set()
    ahead = list(nodes)
    while ahead:
        if (node := ahead.pop()) not in found:
            found.add(node)
            if graph.ops[node] in _HOMOGENEOUS:
                ahead += graph.operands(node)
    return found


def _least(
    graph: Graph,
    square: Sequence[list[int]],
    right: list[int],
    sizes: list[int],
    *,
    written: bool = False,
) -> list[int]:
    """Return the least solution."""
    count = range(len(right))
    shifted = [list(row) for row in square]
    for i in count:
        shifted[i][i] = graph.sum([(square[i][i], 1.0), (sizes[i], SHIFT)])
    if written:
        solution = _Elimination(graph, shifted).solution
    else:
        cells = tuple(e for row in shifted for e in row)
        solution = partial(graph.solve_factored, graph.make("factor", ("ldl", len(right), cells)))
    found = solution(right)
    for _ in range(_STEPS):
        left = [
            graph.sum(
                [(right[i], 1.0), *((graph.mul(square[i][j], found[j]), -1.0) for j in count)]
            )
            for i in count
        ]
        found = [graph.add(a, b) for a, b in zip(found, solution(left), strict=True)]
    return found
