"""Solve ``M a = F`` symbolically for peers that have no solver of their own. A zero is None.

A symmetric positive definite M is factorised as LDLᵀ, any other by elimination with pivots chosen
beforehand, at one typical state: the sparsest pivot among those of sufficient size (Markowitz).
"""

from __future__ import annotations

from typing import Any

from harness.convert import Algebra, translate
from harness.model import Model
from harness.samples import samples

Entry = Any  # a peer's expression, or None for zero


def derivatives(model: Model, algebra: Algebra, x: Any, r: Any, p: Any) -> list[Any]:
    """Return x' in a peer's expressions."""
    matrix, forcing, rates = translate(model, algebra, x, r, p)
    if model.positive_definite:
        return [*rates, *solve_definite(matrix, forcing)]
    return [*rates, *solve_general(matrix, forcing, pivots_of(model))]


def pivots_of(model: Model) -> list[tuple[int, int]]:
    """Return the order of elimination for a model, found at one typical state."""
    states, inputs, values = samples(model, 1)
    typical = translate(model, Algebra(), states[0], inputs[0], values)[0]
    return choose_pivots(typical, len(model.speeds))


def solve_definite(matrix: list[Entry], forcing: list[Any]) -> list[Any]:
    """Return the solution of a symmetric positive definite system."""
    n = len(forcing)
    a = [matrix[i * n : (i + 1) * n] for i in range(n)]
    b: list[Entry] = list(forcing)
    lower: list[dict[int, Any]] = [{} for _ in range(n)]  # by columns
    for k in range(n):
        rows = [i for i in range(k + 1, n) if a[i][k] is not None]
        for i in rows:
            lower[k][i] = a[i][k] / a[k][k]
        for i in rows:
            for j in rows:
                if j <= i:
                    a[i][j] = _minus(a[i][j], lower[k][i] * a[j][k])
            b[i] = b[i] - lower[k][i] * b[k]
    for k in reversed(range(n)):
        b[k] = b[k] / a[k][k]
        for i, factor in lower[k].items():
            b[k] = b[k] - factor * b[i]
    return b


def choose_pivots(values: list[float | None], n: int) -> list[tuple[int, int]]:
    """Return (row, column) pairs in the order of elimination, for typical values."""
    a = {(k // n, k % n): v for k, v in enumerate(values) if v is not None}
    rows, columns = set(range(n)), set(range(n))
    order = []
    while rows:
        largest = {i: max(abs(a.get((i, j), 0.0)) for j in columns) for i in rows}
        in_row = {i: sum((i, j) in a for j in columns) for i in rows}
        in_column = {j: sum((i, j) in a for i in rows) for j in columns}
        sound = [
            (i, j)
            for i in sorted(rows)
            for j in sorted(columns)
            if (i, j) in a and abs(a[i, j]) >= 0.1 * largest[i]
        ]
        i, j = min(sound, key=lambda c: (in_row[c[0]] - 1) * (in_column[c[1]] - 1))
        order.append((i, j))
        rows.remove(i)
        columns.remove(j)
        for r in rows:
            if (r, j) in a:
                for c in columns:
                    if (i, c) in a:
                        a[r, c] = a.get((r, c), 0.0) - a[r, j] / a[i, j] * a[i, c]
    return order


def solve_general(
    matrix: list[Entry], forcing: list[Any], pivots: list[tuple[int, int]]
) -> list[Any]:
    """Return the solution by elimination in a given order of pivots."""
    n = len(forcing)
    a = [matrix[i * n : (i + 1) * n] for i in range(n)]
    b = list(forcing)
    for step, (i, j) in enumerate(pivots):
        later_columns = [c for _, c in pivots[step + 1 :] if a[i][c] is not None]
        for r, _ in pivots[step + 1 :]:
            if a[r][j] is None:
                continue
            factor = a[r][j] / a[i][j]
            for c in later_columns:
                a[r][c] = _minus(a[r][c], factor * a[i][c])
            b[r] = b[r] - factor * b[i]
    solution: list[Any] = [None] * n
    for step in reversed(range(n)):
        i, j = pivots[step]
        value = b[i]
        for _, c in pivots[step + 1 :]:
            if a[i][c] is not None:
                value = value - a[i][c] * solution[c]
        solution[j] = value / a[i][j]
    return solution


def _minus(a: Entry, b: Any) -> Any:
    return -b if a is None else a - b
