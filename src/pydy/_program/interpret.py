"""Evaluate a Program, or nodes of a graph, with NumPy, one operation at a time over all samples.

This is the reference that compiled code is compared with, and the 'lambdify' generator's engine.
Nodes that are needed once, at a few samples, are evaluated without lowering, which takes longer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from inspect import getsource
from typing import Any, Protocol

import numpy as np

from pydy._program.operations import OPERATIONS, OperationSequence, is_constrained, symmetric
from pydy._program.tuning import INDEPENDENT, REDUNDANT, SINGULAR, numbered


class StraightLine(OperationSequence, Protocol):
    """Operations in the order in which they are executed: a Program."""

    @property
    def outputs(self) -> Sequence[int]: ...
    @property
    def fallback(self) -> Mapping[int, Sequence[int]]: ...


def run(
    program: StraightLine, t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Evaluate a Program at m samples: t (m,), x (m, n), r (m, s), and p (k,) or (m, k).

    Return the flat outputs (m, o), NaN where they depend on a singular solve, and at which of the
    samples a linear solve met a singular matrix.
    """
    inputs = {"x": x, "t": t[:, None], "r": r, "p": p}

    def leaf(node: int) -> np.ndarray:
        group, index = program.args[node]
        return inputs[group][..., index]

    samples = SampleValues(program, leaf, len(t), program.fallback)
    deferred = {k for nodes in program.fallback.values() for k in nodes}
    order = (k for k in range(len(program.ops)) if k not in deferred)
    samples.evaluate(order, np.ones(len(t), dtype=bool))
    return samples.columns(program.outputs), samples.failed


class SampleValues:
    """Values of operations at m samples; those for guards' fallbacks on demand."""

    def __init__(
        self,
        nodes: OperationSequence,
        leaf: Callable[[int], float | np.ndarray],
        m: int,
        fallback: Mapping[int, Iterable[int]],
    ) -> None:
        self.nodes, self.leaf, self.m, self.fallback = nodes, leaf, m, fallback
        self.values: dict[int, Any] = {}
        self.failed = np.zeros(m, dtype=bool)

    def columns(self, nodes: Sequence[int]) -> np.ndarray:
        """Return values as the columns of an array."""
        return stacked([self.values[node] for node in nodes], self.m)

    def evaluate(self, order: Iterable[int], at: np.ndarray) -> None:
        """Evaluate nodes, which are needed at some of the samples."""
        with np.errstate(all="ignore"):
            for node in order:
                self.values[node] = self._value(node, at)

    def _value(self, node: int, at: np.ndarray) -> Any:
        op, args, values = self.nodes.ops[node], self.nodes.args[node], self.values
        if op in OPERATIONS:
            return OPERATIONS[op].numpy(*[values[n] for n in args])
        if op == "sum":
            total = args[0]
            for n, c in args[1]:
                total = total + values[n] * c
            return total
        if op == "prod":
            product = 1.0
            for n, e in args:
                product = product * (values[n] if e == 1 else np.power(values[n], float(e)))
            return product
        if op == "input":
            return self.leaf(node)
        if op in ("const", "bool"):
            return args[0]
        if op == "item":
            return values[args[0]][:, args[1]]
        if op == "factor":
            kind, n, entries = args
            cells = symmetric(n, entries) if kind == "ldl" else entries
            return self.columns(cells).reshape(self.m, n, n)
        if op == "solve":
            return solved(values[args[0]], self.columns(args[1]), self.failed)
        return self._guarded(node, at)

    def _guarded(self, guard: int, at: np.ndarray) -> np.ndarray:
        """Return the unrolled solution where its pivots are sound, else solve with pivoting."""
        n, entries, column, sound, fast = self.nodes.args[guard]
        solutions = self.columns(fast) if fast else np.full((self.m, len(column)), np.nan)
        weak = at & ~np.broadcast_to(self.values[sound], self.m)
        if weak.any():
            self.evaluate(self.fallback.get(guard, ()), weak)
            matrix = self.columns(entries).reshape(self.m, n, n)[weak]
            bad = np.zeros(len(matrix), dtype=bool)
            solve = constrained if is_constrained(self.nodes, entries) else solved
            solutions[weak] = solve(matrix, self.columns(column)[weak], bad)
            self.failed[weak] |= bad
        return solutions


def stacked(columns: Sequence[float | np.ndarray], m: int) -> np.ndarray:
    """Return numbers, or arrays of m, as the columns of an array."""
    out = np.empty((m, len(columns)))
    for k, column in enumerate(columns):
        out[:, k] = column
    return out


def solved(matrix: np.ndarray, columns: np.ndarray, failed: np.ndarray) -> np.ndarray:
    """Solve sample by sample with partial pivoting.

    The right-hand sides, (m, k n), follow each other. Where the matrix is singular, `failed` gets
    True and the solution is NaN.
    """
    m, n = len(matrix), matrix.shape[-1]
    x = np.empty(columns.shape)
    if n == 0:
        return x
    bad = singular(matrix)
    # LAPACK passes over a NaN that it does not meet as a pivot.
    good = ~bad & np.isfinite(matrix).all(axis=(1, 2))
    right = columns.reshape(m, columns.shape[1] // n, n).swapaxes(1, 2)
    if good.all():
        x[:] = np.linalg.solve(matrix, right).swapaxes(1, 2).reshape(columns.shape)
        return x
    solutions = np.linalg.solve(matrix[good], right[good])
    x[good] = solutions.swapaxes(1, 2).reshape(len(solutions), columns.shape[1])
    x[~good] = np.nan
    failed |= bad
    return x


def singular(matrix: np.ndarray) -> np.ndarray:
    """Return which of the stacked matrices have a pivot below n·eps in the equilibrated sense."""
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


def constrained(matrix: np.ndarray, columns: np.ndarray, failed: np.ndarray) -> np.ndarray:
    """Solve M x − Aᵀ λ = f, A x = b sample by sample, whatever the rank of A; see `solved`.

    Gauss-Jordan elimination. The first pivots are the largest entries of A, with columns scaled to
    equal energy, and each eliminates a multiplier too. Rows of A are in units of their rounding
    errors: entries below n are zero, and so is the row's multiplier. The remaining pivots are on
    the diagonal of the reduced M. No M⁻¹ is formed, so that no condition number is squared.

    The last rows, marked on the diagonal, are those of A. At most as many are independent as are
    marked `INDEPENDENT`.
    """
    x = np.empty_like(columns)
    for k, (a, b) in enumerate(zip(matrix, columns, strict=True)):
        x[k] = constrained_sample(a.copy(), b.reshape(-1, len(a)).T.copy()).T.ravel()
        failed[k] |= np.isnan(x[k]).any() and np.isfinite(a).all() and np.isfinite(b).all()
    return x


def constrained_sample(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Solve one of the systems of `constrained`, in place of columns b; NaN if M is singular."""
    n = first = len(b)
    num_independent = 0
    if not np.isfinite(a).all():
        return np.full(b.shape, np.nan)
    while first and a[first - 1, first - 1] in (INDEPENDENT, REDUNDANT):
        first -= 1
        num_independent += a[first, first] == INDEPENDENT
        a[first, first] = 0.0
    largest = np.abs(a[first:, :first]).max(axis=0, initial=0.0)
    massless = 1.0 / (SINGULAR * np.where(largest > 0.0, largest, 1.0))
    mass = a.diagonal()[:first].copy()
    scales = np.where(mass > 0.0, 1.0 / np.sqrt(np.where(mass > 0.0, mass, 1.0)), massless)
    free, unused_rows = np.ones(first, dtype=bool), np.ones(n - first, dtype=bool)
    pivots: dict[int, int] = {}

    def eliminate(row: int, column: int) -> None:
        factors = a[:, column] / a[row, column]
        factors[row] = 0.0
        a[:] -= factors[:, None] * a[row]
        b[:] -= factors[:, None] * b[row]
        pivots[column] = row

    while free.any():
        sizes = np.abs(a[first:, :first]) * (scales * free) * unused_rows[:, None]
        i, j = divmod(int(sizes.argmax()), first) if sizes.size else (0, 0)
        if num_independent and sizes.size and sizes[i, j] > n:
            eliminate(first + i, j)
            eliminate(j, first + i)
            unused_rows[i], num_independent = False, num_independent - 1
        else:
            num_independent = 0
            diagonal = np.abs(a.diagonal()[:first]) * scales**2 * free
            j = int(diagonal.argmax())
            if not diagonal[j] > n * SINGULAR:
                return np.full(b.shape, np.nan)
            eliminate(j, j)
        free[j] = False
    x = np.zeros(b.shape)
    for k, row in pivots.items():
        x[k] = b[row] / a[row, k]
    return np.where(np.isfinite(b).all(axis=0), x, np.nan)


def solver_sources() -> dict[str, str]:
    """Return the Python of `singular` and `constrained_sample` by name, with numbers for names."""
    return {f.__name__: numbered(getsource(f)) for f in (singular, constrained_sample)}
