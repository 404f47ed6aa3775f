"""Solve with a matrix whose rows and columns separate, in O(n).

Where coordinates are measured against the ground, as the angles of a pendulum's links may be, an
entry above the diagonal is ``M[i, j] = Σ_c X[i, c] · Y[j, c]``: a sum, over a few channels, of
something that belongs to row i times something that belongs to column j (a semiseparable matrix:
Vandebril, Van Barel & Mastronardi, Matrix Computations and Semiseparable Matrices I, 2008, ch. 4).
Eliminating row k keeps the form, so that LDLᵀ needs no entry beside the diagonal::

    v = X[k] − P Y[k]        d[k] = M[k, k] − Y[k]ᵀ P Y[k]        P += v vᵀ / d[k]

starting from P = 0, where ``L[i, k] = v · Y[i] / d[k]``. For a chain this is the articulated-body
algorithm, and P the mobility of the joint.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from pydy._graph.node import Graph
from pydy._graph.program import Tape
from pydy._graph.solve.ldl import elimination_order
from pydy._graph.solve.matrix import Matrix, Part, Proposal, symmetric
from pydy._graph.tuning import (
    CANCELLATION,
    LONGEST_ENTRY,
    SINGULAR,
)

# What multiplies a column's part in each row: {row: {part: coefficient}}.
_Rows = dict[int, dict[Part, float]]


def propose(matrix: Matrix) -> Proposal | None:
    """Offer an elimination by generators, if the matrix has them and is not constant."""
    if matrix.kind != "ldl" or matrix.fixed.all():
        return None
    dense = elimination_order(matrix.filled, matrix.fixed.diagonal())[1]
    found = separate(matrix.graph, matrix.n, matrix.entries, dense)
    if found is None:
        return None
    tape, n, cells, value = matrix.tape, matrix.n, matrix.cells, matrix.value
    return found.cost, lambda: SemiseparableLDL(tape, n, cells, found, value)


@dataclass(frozen=True)
class Generators:
    """The parts of rows and columns, by channel."""

    # X as ``rows[i][c]``: parts with their coefficients, whose sum it is
    rows: tuple[tuple[dict[Part, float], ...], ...]
    columns: tuple[tuple[dict[Part, float], ...], ...]  # Y in the same way

    @property
    def cost(self) -> int:
        """Multiply-adds of the factorisation and one solve."""
        return _cost(len(self.rows), len(self.rows[0]))


def _cost(n: int, channels: int) -> int:
    return n * (channels * (channels + 1) * 3 // 2 + 8 * channels + 2)


def separate(
    graph: Graph, n: int, entries: Sequence[int], most: float = float("inf")
) -> Generators | None:
    """Return generators of a symmetric matrix of nodes, None where it has none of this form.

    Only the lower triangle is read. As many channels as other rows separate nothing; nor are
    generators wanted that cost as much as `most`.
    """
    if _cost(n, 1) >= most:
        return None
    owners: dict[int, set[int]] = {}
    terms: dict[tuple[int, int], list[tuple[Part, float]]] = {}
    for j in range(n):
        for i in range(j + 1):
            found = _multiplied_out(graph, entries[j * n + i])
            if i == j:
                found = found or []  # on the diagonal anything goes
            if found is None:
                return None
            terms[i, j] = found
            for part, _ in found:
                for node, _ in part:
                    owner = owners.setdefault(node, {i, j})
                    if i != j:
                        owner &= {i, j}
                        if not owner:
                            return None
    channels: list[tuple[_Rows, dict[int, tuple[Part, float]]]] = []
    for j in reversed(range(1, n)):
        above: dict[Part, _Rows] = defaultdict(lambda: defaultdict(lambda: defaultdict(float)))
        unclear = []
        for i in range(j):
            for part, coefficient in terms[i, j]:
                row = tuple(power for power in part if j not in owners[power[0]])
                own = tuple(power for power in part if i not in owners[power[0]])
                if len(row) + len(own) == len(part):
                    above[own][i][row] += coefficient
                else:
                    unclear.append((i, part, row, own, coefficient))
        # What stands in one entry alone may belong to its row or its column: to the row if the rest
        # is known of the column, or to the column if the rest is known of the row.
        for i, part, row, own, coefficient in unclear:
            if own not in above and any(row in rows.get(i, {}) for rows, _ in channels):
                own = tuple(power for power in part if power not in row)
            else:
                row = tuple(power for power in part if power not in own)
            above[own][i][row] += coefficient
        free = list(range(len(channels)))
        for own, rows in above.items():
            rows, scale = _scaled(rows)
            for c in free:
                if {i: row for i, row in channels[c][0].items() if i < j} == rows:
                    free.remove(c)
                    break
            else:
                c = len(channels)
                channels.append((rows, {}))
            channels[c][1][j] = (own, scale)
        if len(channels) >= n - 1 or _cost(n, len(channels)) >= most:
            return None
    if not channels:
        return None
    return Generators(
        tuple(tuple(rows.get(i, {}) for rows, _ in channels) for i in range(n)),
        tuple(tuple(dict([at[j]]) if j in at else {} for _, at in channels) for j in range(n)),
    )


def _scaled(rows: _Rows) -> tuple[_Rows, float]:
    """Return rows with the first coefficient made 1, and what it was."""
    scale = next(iter(next(iter(rows.values())).values()))
    return {i: {p: c / scale for p, c in row.items()} for i, row in rows.items()}, scale


def _multiplied_out(graph: Graph, node: int) -> list[tuple[Part, float]] | None:
    """Return a node as a few products; sums of constants stay whole."""
    done: dict[Part, float] = defaultdict(float)
    waiting: list[tuple[dict[int, int], float]] = [({node: 1}, 1.0)]
    while waiting:
        powers, coefficient = waiting.pop()
        inner = None
        for n, e in powers.items():
            scale, core = graph.scaled(n)
            whole = graph.constant[core] or graph.ops[core] != "sum"
            if graph.ops[n] in ("const", "prod") or scale != 1.0 or (e == 1 and not whole):
                inner = n
                break
        if inner is None:
            done[tuple(sorted(powers.items()))] += coefficient
            if len(done) > LONGEST_ENTRY:
                return None
            continue
        exponent = powers.pop(inner)
        op, args = graph.ops[inner], graph.args[inner]
        if op == "const":
            if args[0]:
                waiting.append((powers, coefficient * args[0] ** exponent))
            continue
        if op == "prod":
            products = [(args, 1.0)]
        else:
            c0, pairs = args
            if exponent != 1:  # a scaled node
                products = [(((pairs[0][0], 1),), pairs[0][1])]
            else:
                products = [(((n, 1),), c) for n, c in pairs]
                products += [((), c0)] if c0 else []
        if len(products) + len(waiting) > 4 * LONGEST_ENTRY:
            return None
        for factors, c in products:
            joined = dict(powers)
            for n, e in factors:
                joined[n] = joined.get(n, 0) + e * exponent
            waiting.append(({n: e for n, e in joined.items() if e}, coefficient * c**exponent))
    return [(part, c) for part, c in done.items() if c]


class SemiseparableLDL:
    """L D Lᵀ from generators.

    The terms of ``Yᵀ P Y`` are bounded by the diagonal of P. A guard tests that none is much larger
    than the diagonal entry it goes into: rounding is then as harmless as in any LDLᵀ. (For chains
    of bodies it always holds.) Where it fails, or a pivot is not positive, LU decides.
    """

    def __init__(
        self,
        tape: Tape,
        n: int,
        entries: list[int],
        generators: Generators,
        value: Callable[[dict[Part, float]], int],
    ) -> None:
        self.tape = tape
        self.n = n
        self.entries = symmetric(n, entries)
        zero, one = tape.const(0.0), tape.const(1.0)
        tolerance, limit = tape.const(n * SINGULAR), tape.const(CANCELLATION)
        count = len(generators.rows[0])
        self.columns = [[value(part) for part in column] for column in generators.columns]
        self.inverse: list[int] = []
        self.shares: list[list[int]] = []  # v / d
        self.sound = tape.make("bool", True)
        mobility = [[zero] * count for _ in range(count)]
        for k in range(n):
            diagonal = entries[k * n + k]
            row = [value(part) for part in generators.rows[k]]
            y = self.columns[k]
            moved = [self._dot(mobility[c], y) for c in range(count)]
            pivot = tape.sub(diagonal, self._dot(y, moved))
            if pivot == diagonal:
                self._require(zero, pivot)
            else:
                self._require(tape.mul(tolerance, diagonal), pivot)
                squares = [tape.mul(mobility[c][c], tape.mul(y[c], y[c])) for c in range(count)]
                self._require(self._sum(squares), tape.mul(limit, diagonal))
            inverse = tape.make("div", one, pivot)
            v = [tape.sub(a, b) for a, b in zip(row, moved, strict=True)]
            share = [tape.mul(c, inverse) for c in v]
            for a in range(count):
                for b in range(a + 1):
                    more = tape.add(mobility[a][b], tape.mul(v[a], share[b]))
                    mobility[a][b] = mobility[b][a] = more
            self.inverse.append(inverse)
            self.shares.append(share)

    def _require(self, small: int, large: int) -> None:
        condition = self.tape.make("lt", small, large)
        first = self.tape.ops[self.sound] == "bool"
        self.sound = condition if first else self.tape.make("and", self.sound, condition)

    def _sum(self, values: Sequence[int]) -> int:
        total = self.tape.const(0.0)
        for value in values:
            total = self.tape.add(total, value)
        return total

    def _dot(self, a: Sequence[int], b: Sequence[int]) -> int:
        return self._sum([self.tape.mul(p, q) for p, q in zip(a, b, strict=True)])

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the guarded solution."""
        tape, n = self.tape, self.n
        carried = [tape.const(0.0)] * len(self.columns[0])
        forward = []
        for k in range(n):
            value = tape.sub(column[k], self._dot(self.columns[k], carried))
            forward.append(value)
            carried = [
                tape.add(z, tape.mul(s, value))
                for z, s in zip(carried, self.shares[k], strict=True)
            ]
        carried = [tape.const(0.0)] * len(self.columns[0])
        fast = [0] * n
        for k in reversed(range(n)):
            value = tape.sub(
                tape.mul(forward[k], self.inverse[k]), self._dot(self.shares[k], carried)
            )
            fast[k] = value
            carried = [
                tape.add(w, tape.mul(y, value))
                for w, y in zip(carried, self.columns[k], strict=True)
            ]
        entries = tuple(self.entries)
        return tape.make("guard", n, entries, tuple(column), self.sound, tuple(fast))
