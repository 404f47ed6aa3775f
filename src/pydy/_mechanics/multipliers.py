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

from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._mechanics.tuning import SHIFT, SOUND_PIVOT

__all__ = ["accelerations_of_held", "multipliers_of", "solved_soundly"]

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
    weights = [graph.powi(matrix[k][k], -1) for k in range(len(free))]
    square = _products(graph, rows, moved)
    sizes = _sizes(graph, rows, weights, square)
    right = [
        graph.sum([(_dot(graph, row, free), -1.0), (b, -1.0)])
        for row, b in zip(rows, drift, strict=True)
    ]
    first = [row[:rank] for row in square[:rank]]
    some, sound = solved_soundly(graph, first, right[:rank], sizes)
    some += [graph.zero] * (len(rows) - rank)
    least = _least(graph, square, right, sizes)
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


def _dot(graph: Graph, a: Sequence[int], b: Sequence[int]) -> int:
    return graph.sum([(graph.mul(x, y), 1.0) for x, y in zip(a, b, strict=True)])


def _products(graph: Graph, a: Sequence[list[int]], b: Sequence[list[int]]) -> list[list[int]]:
    """Return a bᵀ, which is symmetric."""
    lower = [[_dot(graph, a[i], b[j]) for j in range(i + 1)] for i in range(len(a))]
    return [[lower[max(i, j)][min(i, j)] for j in range(len(a))] for i in range(len(a))]


def solved_soundly(
    graph: Graph, square: Sequence[list[int]], right: list[int], sizes: list[int]
) -> tuple[list[int], int]:
    """Return the solution by LDLᵀ, and whether no pivot is small beside its row's size."""
    n, sound = len(right), graph.boolean(True)
    cell, found = [list(row) for row in square], list(right)
    share = [[graph.zero] * n for _ in range(n)]
    for j in range(n):
        limit = graph.sum([(sizes[j], SOUND_PIVOT)])
        sound = graph.call("and", sound, graph.call("lt", limit, cell[j][j]))
        inverse = graph.powi(cell[j][j], -1)
        for i in range(j + 1, n):
            share[i][j] = graph.mul(cell[i][j], inverse)
            found[i] = graph.sub(found[i], graph.mul(share[i][j], found[j]))
        for i in range(j + 1, n):
            for k in range(j + 1, i + 1):
                cell[i][k] = graph.sub(cell[i][k], graph.mul(share[i][j], cell[k][j]))
                cell[k][i] = cell[i][k]
        found[j] = graph.mul(found[j], inverse)
    for j in reversed(range(n)):
        for i in range(j + 1, n):
            found[j] = graph.sub(found[j], graph.mul(share[i][j], found[i]))
    return found, sound


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
    moving = [
        n for n in graph.reachable(nodes) if graph.ops[n] == "input" and not graph.constant[n]
    ]
    states = [
        {n: graph.const((start + 0.618 * k) % 1.0 + 0.2) for k, n in enumerate(moving)}
        for start in _STATES
    ]
    elsewhere = zip(*(substitute(graph, nodes, state) for state in states), strict=True)
    mean = graph.sum([(square[i][i], 1.0 / len(rows)) for i in range(len(rows))])
    found = []
    for i, several in enumerate(elsewhere):
        usual = graph.sum([(n, 1.0 / len(several)) for n in several])
        found.append(graph.add(square[i][i], graph.call("min", mean, usual)))
    return found


def _least(
    graph: Graph, square: Sequence[list[int]], right: list[int], sizes: list[int]
) -> list[int]:
    """Return the least solution."""
    count = range(len(right))
    shifted = [list(row) for row in square]
    for i in count:
        shifted[i][i] = graph.sum([(square[i][i], 1.0), (sizes[i], SHIFT)])
    factor = graph.make("factor", ("ldl", len(right), tuple(e for row in shifted for e in row)))
    found = graph.solve_factored(factor, right)
    for _ in range(_STEPS):
        left = [
            graph.sum(
                [(right[i], 1.0), *((graph.mul(square[i][j], found[j]), -1.0) for j in count)]
            )
            for i in count
        ]
        more = graph.solve_factored(factor, left)
        found = [graph.add(a, b) for a, b in zip(found, more, strict=True)]
    return found
