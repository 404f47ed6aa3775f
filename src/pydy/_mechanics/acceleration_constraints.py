"""Accelerations by multipliers, whatever the rank of the constraints.

With M u' = F + Jᵀ λ and J u' + b = 0 the multipliers solve S λ = r, with S = J M⁻¹ Jᵀ and
r = −(J M⁻¹ F + b). Rows that are independent at generic states are enough, until a pivot of S is
small: the condition of S is the square of that of J. There the system is solved as it is, by
elimination with the largest pivots of all rows (`pydy._program.interpret.constrained`). The rows
are in units of their rounding errors: what is left of one is zero if it is below that, in any
units of length and mass, and its multiplier too. No more rows are taken than are independent at
generic states: beside these, redundant ones hold to errors of the state that are larger than
rounding.

A mechanism that passes a singular position has finite multipliers there, and does so with states
that keep the constraints to a tolerance only. With Δ, what rows that are nearly singular change of
u', these have J Δ = σ, which changes by σ' = J' Δ in time. A residual f means that the state is off
by f/σ along Δ, a residual v of velocities that they are off by v/σ: both move u' by as much as
Δ 2 (f σ'²/σ³ + v σ'/σ²). Residuals are no smaller than their rounding errors. Where that is more
than Δ, the state does not tell Δ, and rows that are nearly singular are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from pydy._graph import Graph, elimination_order, rounding_bounds, substitute
from pydy._mechanics.components import dot, identity, transposed
from pydy._mechanics.tuning import GUARDED_UP_TO, LIGHT, SOUND_PIVOT
from pydy._program import SINGULAR, constraint_mark

_HOMOGENEOUS = {"sum", "prod", "sqrt", "abs", "pow"}
_STATES = (0.37, 0.74, 1.13)  # from here the irregular states go at which rows are measured


@dataclass(frozen=True)
class AccelerationConstraints:
    """Constraints of accelerations, J u' + b = 0, with the residuals of their integrals."""

    rows: Sequence[list[int]]  # Rows may depend on each other, but must not contradict each other
    bias: Sequence[int]
    rank: int  # so many rows, the first, are independent at generic states
    # The rank at a state follows from J', the residuals J u, and those of the holonomic constraints
    # with their derivatives along the speeds.
    row_rates: Sequence[list[int]] = ()
    velocity_residuals: Sequence[int] = ()
    position_residuals: Sequence[tuple[int, list[int]]] = ()

    def accelerations(self, graph: Graph, matrix: list[list[int]], forcing: list[int]) -> list[int]:
        """Return u' with M u' = F + Jᵀ λ and J u' + b = 0; M, of all speeds, is mostly definite."""
        first, heavy = self.rows[: self.rank], graph.boolean(True)
        eliminated = _Elimination(graph, matrix)
        if eliminated.is_short:
            free, *moved = [eliminated.solution(column) for column in (forcing, *first)]
            for k, pivot in enumerate(eliminated.pivots):
                heavy = graph.call("and", heavy, _is_above(graph, pivot, matrix[k][k], LIGHT))
        else:
            # What is massless by its value moves with a mass of one, and is not sound.
            solvable = [list(line) for line in matrix]
            for k, line in enumerate(matrix):
                massless = graph.call("eq", line[k], graph.zero)
                mass = graph.call("select", massless, graph.one, graph.zero)
                solvable[k][k] = graph.add(line[k], mass)
                heavy = graph.call("and", heavy, graph.call("not", massless))
            free, *moved = graph.solve(solvable, [forcing, *first], "ldl")
        weights = _mobilities(graph, matrix)
        for row in self.rows:
            # A light speed tied to a heavy one would be a difference of large numbers.
            shares = [graph.mul(w, graph.powi(c, 2)) for w, c in zip(weights, row, strict=True)]
            for k, share in enumerate(shares):
                others = [(n, 1.0) for j, n in enumerate(shares) if j != k and n != graph.zero]
                if others and share != graph.zero:
                    is_heavy = _is_above(graph, graph.sum(others), share, LIGHT)
                    heavy = graph.call("and", heavy, is_heavy)
        square = _products(graph, first, moved)
        right = [
            graph.sum([(dot(graph, row, free), -1.0), (b, -1.0)])
            for row, b in zip(first, self.bias, strict=False)
        ]
        usual = _usual(graph, _squares(graph, self.rows, weights))
        sizes = [graph.add(square[i][i], usual[i]) for i in range(self.rank)]
        found, sound = solved_soundly(graph, square, right, sizes)
        sound = graph.call("and", heavy, sound)
        fast = [
            graph.sum([(free[i], 1.0), (dot(graph, [row[i] for row in moved], found), 1.0)])
            for i in range(len(free))
        ]
        return self.accelerations_at_any_rank(graph, matrix, forcing, sound, fast)

    def accelerations_at_any_rank(
        self,
        g: Graph,
        matrix: Sequence[list[int]],
        forcing: Sequence[int],
        sound: int | None = None,
        fast: Sequence[int] | None = None,
    ) -> list[int]:
        """Return `fast` where it is `sound`, else u' by the system of all rows; see the module."""
        sound = g.boolean(False) if sound is None else sound
        fast = [g.zero] * len(forcing) if fast is None else fast
        rows, n = self.rows, len(forcing)
        weights = _mobilities(g, matrix)
        own = _squares(g, rows, weights)
        usual = _usual(g, own)
        units = _roundings(g, matrix, rows)
        exact = _constrained(g, matrix, forcing, self, units)
        coarse = _constrained(g, matrix, forcing, self, [
            g.sum([(g.call("sqrt", g.add(size, other)), SOUND_PIVOT / (n + len(rows)))])
            for size, other in zip(own, usual, strict=True)
        ])  # fmt: skip
        change = [g.sub(a, b) for a, b in zip(exact, coarse, strict=True)]

        def largest(
            values: Sequence[int], sizes: Sequence[tuple[int, int]], *, rounded: bool = False
        ) -> int:
            """Return the largest value, in units of its row; rows of rounding errors have none."""
            found = g.zero
            bounds = rounding_bounds(g, values) if rounded else [g.zero] * len(values)
            for value, bound, (size, nothing) in zip(values, bounds, sizes, strict=True):
                whole = g.sum([(g.call("abs", value), 1.0), (bound, SINGULAR)])
                share = g.call("select", nothing, g.zero, g.div(whole, size))
                found = g.call("max", found, share)
            return found

        def sizes_of(own: Sequence[int], units: Sequence[int]) -> list[tuple[int, int]]:
            sizes = [g.call("sqrt", size) for size in own]
            limits = [g.sum([(unit, float(n))]) for unit in units]
            return [
                (size, g.call("le", size, limit)) for size, limit in zip(sizes, limits, strict=True)
            ]

        sizes, along = sizes_of(own, units), [row for _, row in self.position_residuals]
        broken = largest([dot(g, row, change) for row in rows], sizes)
        rate = largest([dot(g, row, change) for row in self.row_rates], sizes)
        motion = largest(self.velocity_residuals, sizes, rounded=True)
        sizes = sizes_of(_squares(g, along, weights), _roundings(g, matrix, along))
        place = largest([node for node, _ in self.position_residuals], sizes, rounded=True)
        uncertain = g.add(g.mul(place, g.powi(rate, 2)), g.mul(motion, rate, broken))
        # Twice the acceleration that the residuals may cause, times four since they are bounds: a
        # change that is no larger may as well be left out.
        loose = g.call("lt", g.powi(broken, 3), g.sum([(uncertain, 8.0)]))
        chosen = [g.call("select", loose, b, a) for a, b in zip(exact, coarse, strict=True)]
        return g.guard([[g.one]], chosen, sound, list(fast))


def _mobilities(graph: Graph, matrix: Sequence[list[int]]) -> list[int]:
    """Return each speed's change per unit of impulse on it alone; zero where it moves no mass."""
    found = []
    for k, line in enumerate(matrix):
        massless = graph.call("eq", line[k], graph.zero)
        found.append(graph.call("select", massless, graph.zero, graph.powi(line[k], -1)))
    return found


def _is_above(graph: Graph, node: int, size: int, share: float) -> int:
    """Return whether a node is more than a share of a size."""
    return graph.call("lt", graph.sum([(size, share)]), node)


def _roundings(
    graph: Graph, matrix: Sequence[list[int]], rows: Sequence[Sequence[int]]
) -> list[int]:
    """Return how large rounding errors of rows are, columns in units of equal energy."""
    bounds = iter(rounding_bounds(graph, [c for row in rows for c in row]))
    weights, units = _mobilities(graph, matrix), []
    for row in rows:
        squares = [graph.powi(graph.add(graph.call("abs", c), next(bounds)), 2) for c in row]
        heavy = [
            (graph.mul(x, weight), 1.0)
            for x, weight in zip(squares, weights, strict=True)
            if graph.zero not in (x, weight)
        ]
        size = graph.call("sqrt", graph.sum(heavy or [(x, 1.0) for x in squares]))
        units.append(graph.sum([(size, SINGULAR)]))
    return units


def _constrained(
    graph: Graph,
    matrix: Sequence[list[int]],
    forcing: Sequence[int],
    constraints: AccelerationConstraints,
    units: Sequence[int],
    sound: int | None = None,
    fast: Sequence[int] | None = None,
) -> list[int]:
    """Return `fast` where it is sound, else the solution with rows scaled by their rounding."""
    n, d = len(forcing), len(constraints.rows)
    zero, one = graph.zero, graph.one
    shares = [
        graph.call("select", graph.call("eq", unit, zero), one, graph.powi(unit, -1))
        for unit in units
    ]
    scaled = [
        [graph.mul(c, share) for c in row]
        for row, share in zip(constraints.rows, shares, strict=True)
    ]
    system = [
        *([*line, *(graph.neg(row[i]) for row in scaled)] for i, line in enumerate(matrix)),
        *([*row, *[zero] * d] for row in scaled),
    ]
    for k in range(d):
        system[n + k][n + k] = graph.const(constraint_mark(independent=k < constraints.rank))
    bias = zip(constraints.bias, shares, strict=True)
    pull = [graph.sum([(graph.mul(b, c), -1.0)]) for b, c in bias]
    sound = graph.boolean(False) if sound is None else sound
    fast = [*(fast or [zero] * n), *[zero] * d]
    return graph.guard(system, [*forcing, *pull], sound, fast)[:n]


def multipliers_of(
    graph: Graph, rows: Sequence[list[int]], force: list[int], rank: int
) -> list[int]:
    """Return λ with Jᵀ λ = f, the least where rows of J depend on each other."""
    m = len(rows)
    fast = sound = None
    if m == rank:
        square = _products(graph, rows, rows)
        usual = _usual(graph, [square[i][i] for i in range(m)])
        sizes = [graph.add(square[i][i], usual[i]) for i in range(m)]
        right = [dot(graph, row, force) for row in rows]
        fast, sound = solved_soundly(graph, square, right, sizes)
    columns = transposed(rows)
    unit = identity(graph, m)
    constraints = AccelerationConstraints(columns, [graph.neg(f) for f in force], rank)
    units = _roundings(graph, unit, columns)
    return _constrained(graph, unit, [graph.zero] * m, constraints, units, sound, fast)


def _products(graph: Graph, a: Sequence[list[int]], b: Sequence[list[int]]) -> list[list[int]]:
    """Return a bᵀ, which is symmetric."""
    lower = [[dot(graph, a[i], b[j]) for j in range(i + 1)] for i in range(len(a))]
    return [[lower[max(i, j)][min(i, j)] for j in range(len(a))] for i in range(len(a))]


@cache
def _work_of_dense(n: int) -> int:
    return elimination_order(np.ones((n, n), dtype=bool))[1]


class _Elimination:
    """L D Lᵀ of a symmetric matrix, written out where cells are not zero; `pivots` are D.

    It `is_short` if it takes no more than that of a dense matrix that is written out. Beyond such
    sizes the order is one with little fill: what is coupled as the windows of a chain of loops then
    costs no more than its length.
    """

    def __init__(self, graph: Graph, square: Sequence[list[int]]) -> None:
        n = len(square)
        self.graph, self.pivots = graph, [graph.zero] * n
        self._inverses = [graph.zero] * n
        # Below the diagonal, both ways: what is zero there may be another sum above.
        cells: list[dict[int, int]] = [{} for _ in square]
        for i, row in enumerate(square):
            for k, c in enumerate(row[: i + 1]):
                if c != graph.zero:
                    cells[i][k] = cells[k][i] = c
        self._cells = cells
        filled = np.array([k in row for row in cells for k in range(n)], dtype=bool).reshape(n, n)
        order, work = elimination_order(filled)
        self._order = list(range(n)) if n <= GUARDED_UP_TO else order
        self.is_short = work <= _work_of_dense(GUARDED_UP_TO)

    @cached_property
    def _lower(self) -> dict[int, dict[int, int]]:
        """The columns of L by pivots, in their order."""
        graph, cell = self.graph, self._cells
        found: dict[int, dict[int, int]] = {}
        for j in self._order:
            pivot = self.pivots[j] = cell[j].pop(j, graph.zero)
            self._inverses[j] = graph.powi(pivot, -1)
            below, found[j] = sorted(cell[j]), {}
            for i in below:
                del cell[i][j]
                found[j][i] = graph.mul(cell[j][i], self._inverses[j])
            for a, i in enumerate(below):
                for k in below[: a + 1]:
                    taken = graph.mul(found[j][i], cell[j][k])
                    cell[i][k] = cell[k][i] = graph.sub(cell[i].get(k, graph.zero), taken)
        return found

    def solution(self, right: Sequence[int]) -> list[int]:
        """Return the solution for one right-hand side."""
        graph, found = self.graph, list(right)
        for j, column in self._lower.items():
            for i, share in column.items():
                found[i] = graph.sub(found[i], graph.mul(share, found[j]))
        found = [graph.mul(a, b) for a, b in zip(found, self._inverses, strict=True)]
        for j in reversed(self._lower):
            for i, share in self._lower[j].items():
                found[j] = graph.sub(found[j], graph.mul(share, found[i]))
        return found


def solved_soundly(
    graph: Graph, square: Sequence[list[int]], right: list[int], sizes: list[int]
) -> tuple[list[int], int]:
    """Return the solution by LDLᵀ, and whether no pivot is small relative to its row."""
    eliminated, sound = _Elimination(graph, square), graph.boolean(True)
    found = eliminated.solution(right)
    for pivot, size in zip(eliminated.pivots, sizes, strict=True):
        sound = graph.call("and", sound, _is_above(graph, pivot, size, SOUND_PIVOT))
    return found, sound


def _usual(graph: Graph, own: Sequence[int]) -> list[int]:
    """Return the usual squared sizes of rows, where a row of J may be about to vanish.

    That is no more than the mean of all rows and than what the row would be at other states: rows
    in different units are compared with themselves. A square may be negative at states that are
    none, where quaternions are of any length and masses by speeds are written for those of one.
    """
    mean = graph.sum([(size, 1.0 / len(own)) for size in own])
    elsewhere = usual_sizes(graph, [graph.call("abs", size) for size in own])
    return [graph.call("min", mean, size) for size in elsewhere]


def _squares(graph: Graph, rows: Sequence[list[int]], weights: Sequence[int]) -> list[int]:
    return [dot(graph, [graph.powi(c, 2) for c in row], weights) for row in rows]


def usual_sizes(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return the means of some nodes at irregular states, which depend on constants.

    Angles are of order one. Coordinates that are used outside of trigonometric functions may be in
    any unit: theirs is the length of them together.
    """
    moving = graph.inputs(nodes, moving=True)
    lengths = _used_as_they_are(graph, nodes) & {n for n in moving if graph.args[n][0] != "t"}
    unit = graph.one
    if lengths:
        squares = graph.sum([(graph.powi(n, 2), 1.0) for n in sorted(lengths)])
        unit = graph.call("sqrt", squares)
    numbers = [[(start + 0.618 * k) % 1.0 + 0.2 for k in range(len(moving))] for start in _STATES]
    states = [
        {
            n: graph.sum([(unit if n in lengths else graph.one, number)])
            for n, number in zip(moving, several, strict=True)
        }
        for several in numbers
    ]
    elsewhere = zip(*(substitute(graph, nodes, state) for state in states), strict=True)
    return [graph.sum([(n, 1.0 / len(several)) for n in several]) for several in elsewhere]


def _used_as_they_are(graph: Graph, nodes: Sequence[int]) -> set[int]:
    """Return the inputs on which nodes depend other than through functions like the sine."""
    found: set[int] = set()
    ahead = list(nodes)
    while ahead:
        if (node := ahead.pop()) not in found:
            found.add(node)
            if graph.ops[node] in _HOMOGENEOUS:
                ahead += graph.operands(node)
    return found
