"""L D Lᵀ without pivoting, written out as elementary operations.

Zeros and ones of the structure disappear by themselves, and what depends on constants alone falls
into the setup stage (Golub & Van Loan, Matrix Computations, 4th ed., §4.1.2). A guard accepts a
solution by its pivots, and falls back to LU with partial pivoting.
"""

from __future__ import annotations

import numpy as np

from pydy._graph.tuning import UNROLL_LIMIT
from pydy._program import Tape, symmetric
from pydy._rank import ROUNDING


def unrolled(tape: Tape, n: int, entries: list[int]) -> UnrolledLDL | None:
    """Write the elimination out, unless it is too long."""
    filled = np.array(symmetric(n, entries)).reshape(n, n) != tape.const(0.0)
    fixed = np.array([tape.constant[k] for k in entries]).reshape(n, n)
    order, cost = elimination_order(filled, fixed.diagonal())
    long = cost > UNROLL_LIMIT * (4 if fixed.all() else 1)
    return None if long else UnrolledLDL(tape, n, entries, order)


def elimination_order(filled: np.ndarray, fixed: np.ndarray | bool = True) -> tuple[list[int], int]:
    """Return an order of elimination with little fill, and the multiply-adds of LDLᵀ and one solve.

    It is found by minimum degree, if that beats the given order (George & Liu, The evolution of the
    minimum degree ordering algorithm, SIAM Review 31(1), 1989). The symmetric pattern is `filled`.
    Diagonal entries that are `fixed` do not depend on the state. Minimum degree takes them first of
    equal rows: a pivot that is still one of them is divided by once for each set of constants.
    """
    n = len(filled)
    natural_order = list(range(n))
    cost = _cost(filled, natural_order)
    if filled.all():
        return natural_order, cost
    pattern = filled.copy()
    np.fill_diagonal(pattern, False)
    remaining = np.ones(n, dtype=bool)
    order = []
    for _ in range(n):
        degree = np.where(remaining, 2 * pattern.sum(axis=1) + np.logical_not(fixed), 2 * n + 2)
        k = int(degree.argmin())
        order.append(k)
        neighbours = pattern[k] & remaining
        pattern |= np.outer(neighbours, neighbours)
        np.fill_diagonal(pattern, False)
        remaining[k] = False
        pattern[k, :] = pattern[:, k] = False
    better = _cost(filled, order)
    return (order, better) if better < cost else (natural_order, cost)


def _cost(filled: np.ndarray, order: list[int]) -> int:
    pattern = filled[np.ix_(order, order)].copy()
    total = 0
    for k in range(len(order)):
        below = pattern[k + 1 :, k]
        count = int(below.sum())
        total += count * (count + 3) // 2 + 2 * count
        pattern[k + 1 :, k + 1 :] |= np.outer(below, below)
    return total


class UnrolledLDL:
    """L D Lᵀ of a symmetric matrix, of which the lower triangle is read, in a given order."""

    def __init__(
        self, tape: Tape, n: int, entries: list[int], order: list[int] | None = None
    ) -> None:
        self.tape = tape
        self.n = n
        order = self.order = list(range(n)) if order is None else order
        # The fallback must see a symmetric matrix too, whatever stands in the upper triangle.
        self.entries = symmetric(n, entries)
        zero = self.zero = tape.const(0.0)
        cell = [[self.entries[i * n + j] for j in order] for i in order]
        lower: list[list[int]] = [[zero] * n for _ in range(n)]
        scaled: list[list[int]] = [[zero] * n for _ in range(n)]  # L · D
        self.inverse: list[int] = []
        unit, tolerance = tape.const(1.0), tape.const(n * ROUNDING)
        self.sound = tape.make("bool", True)
        for j in range(n):
            pivot = cell[j][j]
            row = [k for k in range(j) if scaled[j][k] != zero]
            for k in row:
                pivot = self._minus(pivot, lower[j][k], scaled[j][k])
            # A pivot is judged by its own diagonal entry: units do not matter.
            limit = zero if pivot == cell[j][j] else tape.mul(tolerance, cell[j][j])
            self._require(tape.make("lt", limit, pivot))
            inverse = tape.make("div", unit, pivot)
            self.inverse.append(inverse)
            for i in range(j + 1, n):
                value = cell[i][j]
                # Of the two equal products the one that does not wait for this row's quotients.
                for k in row:
                    value = self._minus(value, scaled[i][k], lower[j][k])
                if value != zero:
                    scaled[i][j] = value
                    lower[i][j] = tape.mul(value, inverse)
        self.lower = lower

    def _require(self, condition: int) -> None:
        tape = self.tape
        first = tape.ops[self.sound] == "bool"
        self.sound = condition if first else tape.make("and", self.sound, condition)

    def _minus(self, value: int, a: int, b: int) -> int:
        if self.zero in (a, b):
            return value
        return self.tape.sub(value, self.tape.mul(a, b))

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the guarded solution."""
        n, tape = self.n, self.tape
        y = [column[i] for i in self.order]
        for i in range(n):
            for k in range(i):
                y[i] = self._minus(y[i], self.lower[i][k], y[k])
        x = [tape.mul(v, d) for v, d in zip(y, self.inverse, strict=True)]
        for i in reversed(range(n)):
            # What is known first is subtracted first: one product waits for the value before.
            for k in reversed(range(i + 1, n)):
                x[i] = self._minus(x[i], self.lower[k][i], x[k])
        fast = [0] * n
        for position, value in zip(self.order, x, strict=True):
            fast[position] = value
        return tape.make("guard", n, tuple(self.entries), tuple(column), self.sound, tuple(fast))
