"""Linear solves as part of a Program.

A symmetric positive definite matrix is factorised as L D Lᵀ without pivoting, unrolled into
elementary operations: zeros and ones of the structure disappear by themselves and what depends on
constants alone falls into the setup stage (Golub & Van Loan, Matrix Computations, 4th ed., §4.1.2).
A guard watches the pivots and falls back to LU with partial pivoting. Everything else, and large
matrices, go to a loop in the back end.
"""

from __future__ import annotations

from pydy._graph.program import Tape

__all__ = ["LoopFactor", "UnrolledLDL"]


def symmetric(n: int, entries: list[int]) -> list[int]:
    """Return the matrix that the lower triangle stands for, whatever the upper one holds."""
    return [entries[max(i, j) * n + min(i, j)] for i in range(n) for j in range(n)]


class LoopFactor:
    """A factorisation that the back end does in a loop."""

    def __init__(self, tape: Tape, kind: str, n: int, entries: list[int]) -> None:
        self.tape = tape
        if kind == "ldl":
            entries = symmetric(n, entries)
        self.node = tape.make("factor", kind, n, tuple(entries))

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""
        return self.tape.make("solve", self.node, tuple(column))


class UnrolledLDL:
    """L D Lᵀ of a symmetric matrix, of which the lower triangle is read."""

    def __init__(self, tape: Tape, n: int, entries: list[int]) -> None:
        self.tape = tape
        self.n = n
        self.entries = symmetric(n, entries)
        zero = tape.const(0.0)
        self.zero = zero
        lower: list[list[int]] = [[zero] * n for _ in range(n)]
        scaled: list[list[int]] = [[zero] * n for _ in range(n)]  # L · D
        self.pivots: list[int] = []
        self.inverse: list[int] = []
        one = tape.const(1.0)
        for j in range(n):
            pivot = entries[j * n + j]
            for k in range(j):
                pivot = self._minus(pivot, lower[j][k], scaled[j][k])
            self.pivots.append(pivot)
            inverse = tape.make("div", one, pivot)
            self.inverse.append(inverse)
            for i in range(j + 1, n):
                value = entries[i * n + j]
                for k in range(j):
                    value = self._minus(value, lower[i][k], scaled[j][k])
                scaled[i][j] = value
                lower[i][j] = tape.mul(value, inverse)
        self.lower = lower

    def _minus(self, value: int, a: int, b: int) -> int:
        if self.zero in (a, b):
            return value
        return self.tape.sub(value, self.tape.mul(a, b))

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the guarded solution."""
        n, tape = self.n, self.tape
        y = list(column)
        for i in range(n):
            for k in range(i):
                y[i] = self._minus(y[i], self.lower[i][k], y[k])
        x = [tape.mul(v, d) for v, d in zip(y, self.inverse, strict=True)]
        for i in reversed(range(n)):
            for k in range(i + 1, n):
                x[i] = self._minus(x[i], self.lower[k][i], x[k])
        return tape.make(
            "guard", n, tuple(self.entries), tuple(column), tuple(self.pivots), tuple(x)
        )
