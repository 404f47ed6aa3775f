"""Evaluate a Program with NumPy, one operation at a time over all samples.

This is the reference that compiled code is compared with, the 'lambdify' generator's engine, and
what small one-off evaluations use, where compiling would not pay.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from pydy._graph.operations import OPERATIONS
from pydy._graph.program import Program
from pydy._graph.tuning import SINGULAR

__all__ = ["run", "solved", "stacked"]

Values = list[Any]


def run(
    program: Program, t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Evaluate a Program at m samples.

    Parameters
    ----------
    program : Program
    t : ndarray, shape (m,)
    x : ndarray, shape (m, n)
    r : ndarray, shape (m, s)
    p : ndarray, shape (k,)

    Returns
    -------
    out : ndarray, shape (m, o)
        The flat outputs; NaN where they depend on a singular solve.
    failed : ndarray of bool, shape (m,)
        Where a linear solve met a singular matrix.
    """
    m = len(t)
    inputs: dict[str, Callable[[int], Any]] = {
        "x": lambda i: x[:, i],
        "t": lambda i: t,
        "r": lambda i: r[:, i],
        "p": lambda i: p[i],
    }
    values: Values = [None] * len(program.ops)
    failed = np.zeros(m, dtype=bool)
    with np.errstate(all="ignore"):
        for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
            if op in ("const", "bool"):
                values[k] = args[0]
            elif op == "input":
                values[k] = inputs[args[0]](args[1])
            elif op == "factor":
                values[k] = _columns(values, args[2], m).reshape(m, args[1], args[1])
            elif op == "solve":
                values[k] = solved(values[args[0]], _columns(values, args[1], m), failed)
            elif op == "guard":
                values[k] = _guard(values, args, m, failed)
            elif op == "item":
                values[k] = values[args[0]][:, args[1]]
            else:
                values[k] = OPERATIONS[op].numpy(*(values[a] for a in args))
        return _columns(values, program.outputs, m), failed


def _columns(values: Values, nodes: tuple[int, ...], m: int) -> np.ndarray:
    return stacked([values[node] for node in nodes], m)


def stacked(columns: Sequence[Any], m: int) -> np.ndarray:
    """Return numbers, or arrays of m, as the columns of an array."""
    out = np.empty((m, len(columns)))
    for k, column in enumerate(columns):
        out[:, k] = column
    return out


def _guard(values: Values, args: tuple[Any, ...], m: int, failed: np.ndarray) -> np.ndarray:
    """Take the unrolled solution where its pivots are sound, and pivot where they are not."""
    n, entries, column, sound, fast = args
    x = _columns(values, fast, m)
    weak = ~np.broadcast_to(values[sound], m)
    if weak.any():
        matrix = _columns(values, entries, m).reshape(m, n, n)[weak]
        bad = np.zeros(len(matrix), dtype=bool)
        x[weak] = solved(matrix, _columns(values, column, m)[weak], bad)
        failed[weak] |= bad
    return x


def solved(matrix: np.ndarray, column: np.ndarray, failed: np.ndarray) -> np.ndarray:
    """Solve sample by sample with partial pivoting.

    Parameters
    ----------
    matrix : ndarray, shape (m, n, n)
    column : ndarray, shape (m, n)
    failed : ndarray of bool, shape (m,)
        Gets True where the matrix is singular; the solution is NaN there.
    """
    m, n = column.shape
    x = np.empty((m, n))
    if n == 0:
        return x
    bad = singular(matrix)
    # LAPACK passes over a NaN that it does not meet as a pivot.
    good = ~bad & np.isfinite(matrix).all(axis=(1, 2))
    if good.all():
        x[:] = np.linalg.solve(matrix, column[:, :, None])[:, :, 0]
        return x
    x[good] = np.linalg.solve(matrix[good], column[good][:, :, None])[:, :, 0]
    x[~good] = np.nan
    failed |= bad
    return x


def singular(matrix: np.ndarray) -> np.ndarray:
    """Tell which of the stacked matrices have a pivot below n·eps in the equilibrated sense."""
    n = matrix.shape[-1]
    magnitude = np.abs(matrix)
    rows = magnitude.max(axis=2, keepdims=True)
    rows[~(rows > 0.0)] = 1.0
    columns = (magnitude / rows).max(axis=1, keepdims=True)
    columns[~(columns > 0.0)] = 1.0
    a = matrix / rows / columns
    bad = np.zeros(len(matrix), dtype=bool)
    index = np.arange(len(matrix))
    for k in range(n):
        pivot = k + np.argmax(np.abs(a[:, k:, k]), axis=1)
        a[index, k], a[index, pivot] = a[index, pivot].copy(), a[index, k].copy()
        bad |= np.abs(a[:, k, k]) <= n * SINGULAR
        factors = a[:, k + 1 :, k : k + 1] / a[:, k : k + 1, k : k + 1]
        a[:, k + 1 :] -= factors * a[:, k : k + 1]
    return bad
