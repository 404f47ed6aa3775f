"""Components of vectors and tensors as nodes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._graph import Graph, jacobian
from pydy._rank import ROUNDED

_STATES = 3


def dot(graph: Graph, a: Sequence[int], b: Sequence[int], *more: tuple[int, float]) -> int:
    """Return the sum of the products of entries, and of `more` nodes with their factors."""
    zero = graph.zero
    both = [(x, y) for x, y in zip(a, b, strict=True) if x != zero != y]
    return graph.sum([*more, *((graph.mul(x, y), 1.0) for x, y in both)])


def turned(graph: Graph, matrix: Sequence[Sequence[int]], v: Sequence[int]) -> list[int]:
    """Return the product of a matrix and a vector."""
    return [dot(graph, row, v) for row in matrix]


def identity(graph: Graph, n: int = 3) -> list[list[int]]:
    """Return the matrix of n rows that changes nothing."""
    return [[graph.one if i == j else graph.zero for j in range(n)] for i in range(n)]


def in_rows(flat: Sequence[int]) -> list[list[int]]:
    """Return nine nodes as a matrix."""
    return [list(flat[k : k + 3]) for k in (0, 3, 6)]


def flat(matrix: Sequence[Sequence[int]]) -> list[int]:
    """Return the entries of a matrix, row by row."""
    return [n for row in matrix for n in row]


def about(graph: Graph, axis: int, c: int, s: int) -> list[list[int]]:
    """Return the matrix of axes that are turned about one of them, by its cosine and sine."""
    j, m = (axis + 1) % 3, (axis + 2) % 3
    found = [[graph.one if i == r == axis else graph.zero for i in range(3)] for r in range(3)]
    found[j][j] = found[m][m] = c
    found[j][m], found[m][j] = s, graph.neg(s)
    return found


def transposed(matrix: Sequence[Sequence[int]]) -> list[list[int]]:
    """Return a matrix with rows for columns."""
    return [list(column) for column in zip(*matrix, strict=True)]


def unrounded(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Drop components that are rounding errors of numeric rotations, relative to the vector."""
    rows = [graph.linear(n) for n in nodes]
    sizes: dict[int, float] = {}
    for row in rows:
        for n, c in row.items():
            sizes[n] = max(sizes.get(n, 0.0), abs(c))
    kept = [{n: c for n, c in row.items() if abs(c) > ROUNDED * sizes[n]} for row in rows]
    return [
        node if len(own) == len(row) else graph.sum(own.items())
        for node, row, own in zip(nodes, rows, kept, strict=True)
    ]


def numbers_of(
    graph: Graph, flat: Sequence[int], held: Sequence[int] = (), zeros: Sequence[int] = ()
) -> np.ndarray:
    """Return values of nodes at random states, one row for each, at which `held` are zero.

    All that these rows hold is moved: an orientation by a quaternion is one where its length is
    one, and two random lengths need not close. Inputs among `zeros` that they do not hold are zero.
    """
    inputs = graph.inputs([*flat, *held])
    x = np.random.default_rng(0).uniform(0.5, 1.5, (_STATES, len(inputs)))
    kept = {*graph.reachable(held)}
    x[:, [n in zeros and n not in kept for n in inputs]] = 0.0

    def values(nodes: Sequence[int]) -> np.ndarray:
        return graph.evaluator(nodes)(dict(zip(inputs, x.T, strict=True)), _STATES)

    if held:
        slopes = jacobian(graph, held, inputs).flat()
        for _ in range(12):  # Newton's method doubles the digits with each
            found = values([*held, *slopes])
            if not np.isfinite(found).all():
                break
            left, slope = found[:, : len(held)], found[:, len(held) :]
            for k in range(_STATES):
                matrix = slope[k].reshape(len(held), -1)
                x[k] -= np.linalg.lstsq(matrix, left[k], rcond=None)[0]
    return values(flat)
