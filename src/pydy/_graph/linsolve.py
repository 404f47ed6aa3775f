"""Linear solves as part of a Program.

A symmetric positive definite matrix is factorised as L D Lᵀ without pivoting, unrolled into
elementary operations: zeros and ones of the structure disappear by themselves and what depends on
constants alone falls into the setup stage (Golub & Van Loan, Matrix Computations, 4th ed., §4.1.2).
Any other matrix is factorised as L U with pivots chosen beforehand. A guard accepts a solution by
its pivots, or its backward error, and falls back to LU with partial pivoting. Large matrices go to
a loop in the back end.
"""

from __future__ import annotations

from pydy._graph.program import Tape

__all__ = ["LoopFactor", "UnrolledLDL", "UnrolledLU", "symmetric"]


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
        one, tolerance = tape.const(1.0), tape.const(n * 2.0**-52)
        self.sound = tape.make("bool", True)
        for j in range(n):
            pivot = cell[j][j]
            row = [k for k in range(j) if scaled[j][k] != zero]
            for k in row:
                pivot = self._minus(pivot, lower[j][k], scaled[j][k])
            # A pivot is judged by its own diagonal entry: units do not matter.
            limit = zero if pivot == cell[j][j] else tape.mul(tolerance, cell[j][j])
            self._require(tape.make("lt", limit, pivot))
            inverse = tape.make("div", one, pivot)
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
            for k in range(i + 1, n):
                x[i] = self._minus(x[i], self.lower[k][i], x[k])
        fast = [0] * n
        for place, value in zip(self.order, x, strict=True):
            fast[place] = value
        return tape.make("guard", n, tuple(self.entries), tuple(column), self.sound, tuple(fast))


# A pivot smaller than this share of its row leaves the decision, singular or not, to the fallback.
_SMALL_PIVOT = 1e-9
# The backward error of a solution that is taken, in units of n·eps. Four in a hundred states of a
# bicycle are beyond 4, six in a thousand beyond 32, and a fallback holds up all lanes of a batch.
_BACKWARD_ERROR = 32


class UnrolledLU:
    """L U with pivots chosen beforehand, guarded by the backward error of each solution.

    A solution x is taken when no pivot is small and every residual ``b − A x`` is within rounding
    of ``|A| |x| + |b|``: x is then the exact solution of a system that differs from the given one
    by so many roundings in each entry (Oettli & Prager, Numerische Mathematik 6, 1964, 405–409).
    Otherwise partial pivoting decides. Further columns are taken with the first, unless its
    solution is zero and tells nothing: what spoils a solution is the growth of the factors, which
    they have in common (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., theorem
    9.3).
    """

    def __init__(
        self, tape: Tape, n: int, entries: list[int], rows: list[int], columns: list[int]
    ) -> None:
        self.tape = tape
        self.n = n
        self.entries = entries
        self.rows = rows
        self.columns = columns
        zero = self.zero = tape.const(0.0)
        cell = [[entries[i * n + j] for j in columns] for i in rows]
        one, small = tape.const(1.0), tape.const(_SMALL_PIVOT)
        sizes = [self._largest([c for c in row if c != zero]) for row in cell]
        self.lower: list[list[int]] = [[zero] * n for _ in range(n)]
        self.inverse: list[int] = []
        self.sound = tape.make("bool", True)
        for k in range(n):
            pivot = cell[k][k]
            condition = tape.make("lt", tape.mul(small, sizes[k]), self._size(pivot))
            self.sound = self._both(self.sound, condition)
            inverse = tape.make("div", one, pivot)
            self.inverse.append(inverse)
            for i in range(k + 1, n):
                if cell[i][k] == zero:
                    continue
                factor = self.lower[i][k] = tape.mul(cell[i][k], inverse)
                for j in range(k + 1, n):
                    if cell[k][j] != zero:
                        cell[i][j] = tape.sub(cell[i][j], tape.mul(factor, cell[k][j]))
        self.upper = cell
        self.first: tuple[int, list[int]] | None = None  # its soundness and solution
        self.later: int | None = None

    def _both(self, a: int, b: int) -> int:
        return b if self.tape.ops[a] == "bool" else self.tape.make("and", a, b)

    def _size(self, value: int) -> int:
        constant = self.tape.value(value)
        return self.tape.make("abs", value) if constant is None else self.tape.const(abs(constant))

    def _largest(self, values: list[int]) -> int:
        # Not "max": a NaN fails the comparisons that follow, and this is one instruction.
        tape = self.tape
        result = self.zero
        for value in values:
            size = self._size(value)
            if result == self.zero:
                result = size
            else:
                result = tape.make("select", tape.make("lt", result, size), size, result)
        return result

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the guarded solution."""
        n, tape, zero = self.n, self.tape, self.zero
        y = [column[i] for i in self.rows]
        for i in range(n):
            for k in range(i):
                if zero not in (self.lower[i][k], y[k]):
                    y[i] = tape.sub(y[i], tape.mul(self.lower[i][k], y[k]))
        for i in reversed(range(n)):
            for k in range(i + 1, n):
                if zero not in (self.upper[i][k], y[k]):
                    y[i] = tape.sub(y[i], tape.mul(self.upper[i][k], y[k]))
            y[i] = tape.mul(y[i], self.inverse[i])
        fast = [0] * n
        for place, value in zip(self.columns, y, strict=True):
            fast[place] = value
        if self.first is None:
            sound = self._accurate(column, fast)
            self.first = (sound, fast)
        else:
            sound = self._as_first()
        return tape.make("guard", n, tuple(self.entries), tuple(column), sound, tuple(fast))

    def _as_first(self) -> int:
        """Return whether the first solution was accurate, and not zero."""
        assert self.first is not None
        if self.later is None:
            tape, (sound, x) = self.tape, self.first
            total = self.zero
            for value in x:
                total = tape.add(total, self._size(value))
            self.later = self._both(sound, tape.make("lt", self.zero, total))
        return self.later

    def _accurate(self, column: list[int], x: list[int]) -> int:
        """Return whether the residual of every row is a matter of rounding."""
        n, tape, zero = self.n, self.tape, self.zero
        tolerance = tape.const(_BACKWARD_ERROR * n * 2.0**-52)
        sizes = [self._size(value) for value in x]
        sound = self.sound
        for i in range(n):
            residual, bound = column[i], self._size(column[i])
            for j in range(n):
                entry = self.entries[i * n + j]
                if zero not in (entry, x[j]):
                    residual = tape.sub(residual, tape.mul(entry, x[j]))
                    bound = tape.add(bound, tape.mul(self._size(entry), sizes[j]))
            condition = tape.make("le", self._size(residual), tape.mul(tolerance, bound))
            sound = self._both(sound, condition)
        return sound
