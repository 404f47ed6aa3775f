"""Make use of a mass matrix's structure before it is factorised."""

from __future__ import annotations

import numpy as np

from pydy._graph.node import Graph

__all__ = ["difference_basis", "elimination_order", "pivot_order"]


def _terms(graph: Graph, node: int) -> dict[int, float]:
    """Return a node as a linear combination, a constant under the key −1."""
    op, args = graph.ops[node], graph.args[node]
    if op == "const":
        return {-1: args[0]} if args[0] else {}
    if op == "sum":
        terms = dict(args[1])
        if args[0]:
            terms[-1] = args[0]
        return terms
    return {node: 1.0}


def _minus(a: dict[int, float], b: dict[int, float]) -> dict[int, float]:
    result = dict(a)
    for n, c in b.items():
        rest = result.get(n, 0.0) - c
        if rest:
            result[n] = rest
        else:
            result.pop(n, None)
    return result


def _node(graph: Graph, terms: dict[int, float]) -> int:
    return graph.sum([(n, c) for n, c in terms.items() if n >= 0], terms.get(-1, 0.0))


def difference_basis(
    graph: Graph, matrix: list[list[int]], column: list[int]
) -> tuple[list[list[int]], list[int]] | None:
    """Write ``M x = b`` for a chain of relative coordinates in the differences of its rows.

    Where each coordinate carries everything after it, neighbouring rows of M and b agree but for
    one body. With T the identity less the first superdiagonal, T M Tᵀ is then nearly diagonal and
    T b short: ``(T M Tᵀ) y = T b`` and ``x = Tᵀ y``, that is ``x[i] = y[i] − y[i − 1]``.

    Returns
    -------
    (matrix, column) or None
        T M Tᵀ and T b, when at least half of the matrix's entries vanish that way.
    """
    n = len(matrix)
    if n < 3:
        return None
    zero = graph.zero
    if sum(entry != zero for row in matrix for entry in row) < 0.75 * n * n:
        return None
    known: dict[int, dict[int, float]] = {}

    def terms(i: int, j: int) -> dict[int, float]:
        if i >= n or j >= n:
            return {}
        entry = matrix[max(i, j)][min(i, j)]
        if entry not in known:
            known[entry] = _terms(graph, entry)
        return known[entry]

    def difference(i: int, j: int) -> dict[int, float]:
        above = _minus(terms(i, j), terms(i + 1, j))
        return _minus(above, _minus(terms(i, j + 1), terms(i + 1, j + 1)))

    # The last rows tell at little cost whether it is worth while.
    if any(difference(n - 1, j) for j in range(n - 2)):
        return None
    cells = [[difference(i, j) for j in range(i + 1)] for i in range(n)]
    filled = sum(2 * bool(cell) for row in cells for cell in row)
    if filled > 0.5 * n * n + n:
        return None
    rows = [[zero] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            rows[i][j] = rows[j][i] = _node(graph, cells[i][j])
    right = [_terms(graph, b) for b in column] + [{}]
    return rows, [_node(graph, _minus(right[i], right[i + 1])) for i in range(n)]


def elimination_order(filled: np.ndarray, fixed: np.ndarray) -> tuple[list[int], int]:
    """Return an order of elimination with little fill, and what LDLᵀ then costs.

    Parameters
    ----------
    filled : ndarray of bool, shape (n, n)
        The symmetric pattern.
    fixed : ndarray of bool, shape (n,)
        Which diagonal entries do not depend on the state. Of equal rows these go first: a pivot
        that is still one of them is divided by only once per binding.

    Returns
    -------
    order : list of int
        By minimum degree, if that beats the given order (George & Liu, The evolution of the
        minimum degree ordering algorithm, SIAM Review 31(1), 1989).
    cost : int
        Multiply-adds of the factorisation and one solve.
    """
    n = len(filled)
    given = list(range(n))
    cost = _cost(filled, given)
    if filled.all():
        return given, cost
    pattern = filled.copy()
    np.fill_diagonal(pattern, False)
    left = np.ones(n, dtype=bool)
    order = []
    for _ in range(n):
        degree = np.where(left, 2 * pattern.sum(axis=1) + ~fixed, 2 * n + 2)
        k = int(degree.argmin())
        order.append(k)
        neighbours = pattern[k] & left
        pattern |= np.outer(neighbours, neighbours)
        np.fill_diagonal(pattern, False)
        left[k] = False
        pattern[k, :] = pattern[:, k] = False
    better = _cost(filled, order)
    return (order, better) if better < cost else (given, cost)


# A pivot must not be much smaller than the other entries of its column, at any of the samples.
_PIVOT_SHARE = 0.01


def pivot_order(samples: np.ndarray, filled: np.ndarray) -> tuple[list[int], list[int], int] | None:
    """Choose the pivots of an LU beforehand: few new entries, and sound at generic states.

    Parameters
    ----------
    samples : ndarray, shape (m, n, n)
        The matrix at m generic states.
    filled : ndarray of bool, shape (n, n)
        Its pattern.

    Returns
    -------
    (rows, columns, cost) or None
        In the order of elimination, by Markowitz' count with threshold pivoting (Duff, Erisman &
        Reid, Direct Methods for Sparse Matrices, 2nd ed., §§5.2, 7.2), and the multiply-adds of
        the factorisation and one solve. None where no entry would do at all samples.
    """
    a = samples / np.abs(samples).max(axis=2, keepdims=True).clip(1e-300)
    pattern = filled.copy()
    n = len(filled)
    rows_left, columns_left = list(range(n)), list(range(n))
    rows: list[int] = []
    columns: list[int] = []
    cost = 0
    for _ in range(n):
        best: tuple[int, int, int] | None = None
        in_row = pattern[np.ix_(rows_left, columns_left)].sum(axis=1)
        in_column = pattern[np.ix_(rows_left, columns_left)].sum(axis=0)
        size = np.abs(a[:, rows_left][:, :, columns_left])
        sound = (size >= _PIVOT_SHARE * size.max(axis=1, keepdims=True)) & (size > 1e-9)
        allowed = sound.all(axis=0) & pattern[np.ix_(rows_left, columns_left)]
        for i, j in zip(*np.nonzero(allowed), strict=True):
            rank = (int((in_row[i] - 1) * (in_column[j] - 1)), int(i), int(j))
            if best is None or rank < best:
                best = rank
        if best is None:
            return None
        row, column = rows_left.pop(best[1]), columns_left.pop(best[2])
        rows.append(row)
        columns.append(column)
        others = [i for i in rows_left if pattern[i, column]]
        across = [j for j in columns_left if pattern[row, j]]
        cost += len(others) * (len(across) + 2) + len(across) + 1
        for i in others:
            factor = a[:, i, column] / a[:, row, column]
            for j in across:
                a[:, i, j] -= factor * a[:, row, j]
                pattern[i, j] = True
    return rows, columns, cost


def _cost(filled: np.ndarray, order: list[int]) -> int:
    pattern = filled[np.ix_(order, order)].copy()
    total = 0
    for k in range(len(order)):
        below = pattern[k + 1 :, k]
        count = int(below.sum())
        total += count * (count + 3) // 2 + 2 * count
        pattern[k + 1 :, k + 1 :] |= np.outer(below, below)
    return total
