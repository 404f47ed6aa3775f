"""L U with pivots chosen beforehand, written out as elementary operations.

A guard accepts a solution by its backward error, and falls back to partial pivoting.
"""

from __future__ import annotations

import numpy as np

from pydy._graph.tuning import UNROLL_LIMIT
from pydy._program import Program, Tape, run
from pydy._rank import HALF, ROUNDING, SOUND


def unrolled(
    tape: Tape, n: int, entries: list[int], sizes: tuple[int, int, int]
) -> UnrolledLU | None:
    """Write the elimination out, unless it is too long or there is no sound order."""
    if not n or (samples := _generic(tape, n, entries, sizes)) is None:
        return None
    filled = np.array(entries).reshape(n, n) != tape.const(0.0)
    pivots = pivot_order(samples, filled)
    if pivots is None or pivots[2] > UNROLL_LIMIT:
        return None
    return UnrolledLU(tape, n, entries, *pivots[:2])


def _generic(
    tape: Tape, n: int, entries: list[int], sizes: tuple[int, int, int]
) -> np.ndarray | None:
    """Return the matrix at generic states, or None where it is hardly ever defined."""
    program = Program.from_tape(tape, sizes, [("matrix", (n * n,), entries)])
    rng = np.random.default_rng(0)
    matrices = []
    n_x, n_r, n_p = sizes
    for _ in range(4):
        # States on both sides of zero, constants of different sizes.
        t, x, r = (rng.normal(0.0, 0.5, shape) for shape in ((8,), (8, n_x), (8, n_r)))
        p = 10.0 ** rng.uniform(-1.0, 1.0, n_p)
        values, failed = run(program, t, x, r, p)
        matrices += [row for row, bad in zip(values, failed, strict=True) if not bad]
    samples = np.array([m.reshape(n, n) for m in matrices if np.isfinite(m).all()])
    return samples if len(samples) >= 16 else None


def pivot_order(samples: np.ndarray, filled: np.ndarray) -> tuple[list[int], list[int], int] | None:
    """Choose the pivots of an LU beforehand: few new entries, and sound at generic states.

    The `samples` (m, n, n) are the matrix at such states, `filled` is its pattern. The rows and
    columns are in the order of elimination, by Markowitz' count with threshold pivoting (Duff,
    Erisman & Reid, Direct Methods for Sparse Matrices, 2nd ed., §§5.2, 7.2); their cost is the
    multiply-adds of the factorisation and one solve. None is returned where no entry would do at
    all samples.
    """
    a = samples / np.abs(samples).max(axis=2, keepdims=True).clip(np.finfo(float).tiny)
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
        sound = (size >= SOUND * size.max(axis=1, keepdims=True)) & (size > HALF)
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
        rows_below = [i for i in rows_left if pattern[i, column]]
        across = [j for j in columns_left if pattern[row, j]]
        cost += len(rows_below) * (len(across) + 2) + len(across) + 1
        for i in rows_below:
            factor = a[:, i, column] / a[:, row, column]
            for j in across:
                a[:, i, j] -= factor * a[:, row, j]
                pattern[i, j] = True
    return rows, columns, cost


class UnrolledLU:
    """L U with pivots chosen beforehand, guarded by the backward error of each solution.

    A solution x is taken when no pivot has lost half of its row's digits, and every residual
    ``b − A x`` is within rounding of ``|A| |x| + |b|``: x is then the exact solution of a system
    that differs from the given one by so many roundings in each entry (Oettli & Prager, Numerische
    Mathematik 6, 1964, 405–409).
    Otherwise partial pivoting decides. Further columns are taken with the first, unless its
    solution is zero and tells nothing: what spoils a solution is the growth of the factors, which
    they have in common (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., theorem
    9.3). The factors of a matrix that is triangular in the order of its pivots are its own entries:
    there, substitution is always accurate (ibid., theorem 8.5).
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
        unit, small = tape.const(1.0), tape.const(HALF)
        sizes = [self._largest([c for c in row if c != zero]) for row in cell]
        self.lower: list[list[int]] = [[zero] * n for _ in range(n)]
        self.inverse: list[int] = []
        self.sound = tape.make("bool", True)
        self.triangular = True
        for k in range(n):
            pivot = cell[k][k]
            condition = tape.make("lt", tape.mul(small, sizes[k]), self._size(pivot))
            self.sound = self._conjunction(self.sound, condition)
            inverse = tape.make("div", unit, pivot)
            self.inverse.append(inverse)
            for i in range(k + 1, n):
                if cell[i][k] == zero:
                    continue
                factor = self.lower[i][k] = tape.mul(cell[i][k], inverse)
                for j in range(k + 1, n):
                    if cell[k][j] != zero:
                        self.triangular = False
                        cell[i][j] = tape.sub(cell[i][j], tape.mul(factor, cell[k][j]))
        self.upper = cell
        self.first_solve: tuple[int, list[int]] | None = (
            None  # (sound, solution) of the first right-hand side
        )
        self.later_sound: int | None = None  # of further right-hand sides

    def _conjunction(self, a: int, b: int) -> int:
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
            # What is known first is subtracted first: one product waits for the value before.
            for k in reversed(range(i + 1, n)):
                if zero not in (self.upper[i][k], y[k]):
                    y[i] = tape.sub(y[i], tape.mul(self.upper[i][k], y[k]))
            y[i] = tape.mul(y[i], self.inverse[i])
        fast = [0] * n
        for position, value in zip(self.columns, y, strict=True):
            fast[position] = value
        if self.triangular:
            sound = self.sound
        elif self.first_solve is None:
            sound = self._accurate(column, fast)
            self.first_solve = (sound, fast)
        else:
            sound = self._sound_with_first()
        return tape.make("guard", n, tuple(self.entries), tuple(column), sound, tuple(fast))

    def _sound_with_first(self) -> int:
        """Return whether the first solution was accurate and not zero: so are further ones."""
        assert self.first_solve is not None
        if self.later_sound is None:
            tape, (sound, x) = self.tape, self.first_solve
            total = self.zero
            for value in x:
                total = tape.add(total, self._size(value))
            self.later_sound = self._conjunction(sound, tape.make("lt", self.zero, total))
        return self.later_sound

    def _accurate(self, column: list[int], x: list[int]) -> int:
        """Return whether the residual of every row is a matter of rounding."""
        n, tape, zero = self.n, self.tape, self.zero
        # The backward error of a solution that is taken. Four in a hundred states of a bicycle are
        # beyond 4 n·eps, six in a thousand beyond 32, and a fallback holds up all lanes of a batch.
        tolerance = tape.const(32 * n * ROUNDING)
        sizes = [self._size(value) for value in x]
        sound = self.sound
        for i in range(n):
            residual, bound = column[i], self._size(column[i])
            for j in reversed(self.columns):  # in the order in which the solution is found
                entry = self.entries[i * n + j]
                if zero not in (entry, x[j]):
                    residual = tape.sub(residual, tape.mul(entry, x[j]))
                    bound = tape.add(bound, tape.mul(self._size(entry), sizes[j]))
            condition = tape.make("le", self._size(residual), tape.mul(tolerance, bound))
            sound = self._conjunction(sound, condition)
        return sound
