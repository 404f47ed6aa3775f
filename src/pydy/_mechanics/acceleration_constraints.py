"""Accelerations by multipliers, whatever the rank of the constraints.

With M u' = F + Jᵀ λ and J u' + b = 0 the multipliers solve S λ = r, with S = J M⁻¹ Jᵀ and r = −(J
M⁻¹ F + b). Rows that are independent at generic states suffice unless a pivot of S is small: the
condition number of S is the square of that of J. In that case the full system is solved, by
elimination with the largest pivots of all rows (`pydy._graph.interpret.constrained`). The rows are
scaled by their rounding errors: a remainder below that counts as zero, in any units of length and
mass, and so does its multiplier. At most as many rows are used as are independent at generic
states: redundant ones are satisfied only up to errors of the state, which are larger than rounding.

A mechanism that passes a singular position has finite multipliers there, although its states
satisfy the constraints to a tolerance only. Let Δ be the part of u' that is due to nearly singular
rows, with J Δ = σ, which changes at the rate σ' = J' Δ. A residual f means that the state has an
error f/σ along Δ, a velocity residual v an error v/σ of the speeds: together they change u' by up
to Δ 2 (f σ'²/σ³ + v σ'/σ²). Residuals are at least their rounding errors. If this exceeds Δ, the
state does not determine Δ, and nearly singular rows are omitted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from pydy._graph import (
    Graph,
    LinearSystem,
    elimination_order,
    inputs_of,
    rounding_bounds,
    substitute,
)
from pydy._mechanics.components import dot, identity, transposed
from pydy._mechanics.tuning import GUARDED_UP_TO, LIGHT, SOUND_PIVOT
from pydy._program import constraint_mark
from pydy._rank import ROUNDING

_HOMOGENEOUS = {"sum", "prod", "sqrt", "abs", "pow"}
_STATES = (0.37, 0.74, 1.13)  # seeds of the generic states at which rows are measured


@dataclass(frozen=True)
class AccelerationConstraints:
    """Constraints of accelerations, J u' + b = 0, with the residuals of their integrals."""

    rows: Sequence[list[int]]  # rows may be redundant, but not contradictory
    bias: Sequence[int]
    rank: int  # this many rows, the first ones, are independent at generic states
    # The rank at a state follows from J', the residuals J u, and those of the holonomic constraints
    # with their derivatives along the speeds.
    row_rates: Sequence[list[int]] = ()
    velocity_residuals: Sequence[int] = ()
    position_residuals: Sequence[tuple[int, list[int]]] = ()

    def accelerations(self, graph: Graph, matrix: list[list[int]], forcing: list[int]) -> list[int]:
        """Return u' with M u' = F + Jᵀ λ and J u' + b = 0, for an M that is mostly definite."""
        first, heavy = self.rows[: self.rank], graph.boolean(True)
        eliminated = _Elimination(graph, matrix)
        if eliminated.is_short:
            free, *moved = [eliminated.solution(column) for column in (forcing, *first)]
            for k, pivot in enumerate(eliminated.pivots):
                heavy = graph.call("and", heavy, _is_above(graph, pivot, matrix[k][k], LIGHT))
        else:
            # Speeds whose mass is zero by value get a mass of one, and the result is not sound.
            solvable = [list(line) for line in matrix]
            for k, line in enumerate(matrix):
                massless = graph.call("eq", line[k], graph.zero)
                mass = graph.call("select", massless, graph.one, graph.zero)
                solvable[k][k] = graph.add(line[k], mass)
                heavy = graph.call("and", heavy, graph.call("not", massless))
            free, *moved = map(LinearSystem(graph, solvable, "ldl").solve, [forcing, *first])
        weights = _mobilities(graph, matrix)
        for row in self.rows:
            # A light speed tied to a heavy one would be a difference of large numbers.
            shares = [graph.mul(w, graph.powi(c, 2)) for w, c in zip(weights, row, strict=True)]
            for k, share in enumerate(shares):
                other_shares = [
                    (n, 1.0) for j, n in enumerate(shares) if j != k and n != graph.zero
                ]
                if other_shares and share != graph.zero:
                    is_heavy = _is_above(graph, graph.sum(other_shares), share, LIGHT)
                    heavy = graph.call("and", heavy, is_heavy)
        square = _products(graph, first, moved)
        right = [
            graph.sum([(dot(graph, row, free), -1.0), (b, -1.0)])
            for row, b in zip(first, self.bias, strict=False)
        ]
        usual = _usual(graph, _squares(graph, self.rows, weights))
        sizes = [graph.add(square[i][i], usual[i]) for i in range(self.rank)]
        multipliers, sound = solved_soundly(graph, square, right, sizes)
        sound = graph.call("and", heavy, sound)
        fast = [
            graph.sum([(free[i], 1.0), (dot(graph, [row[i] for row in moved], multipliers), 1.0)])
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
        squares = _squares(g, rows, weights)
        usual = _usual(g, squares)
        units = _roundings(g, matrix, rows)
        exact = _constrained(g, matrix, forcing, self, units)
        coarse = _constrained(g, matrix, forcing, self, [
            g.sum([(g.call("sqrt", g.add(size, usual_square)), SOUND_PIVOT / (n + len(rows)))])
            for size, usual_square in zip(squares, usual, strict=True)
        ])  # fmt: skip
        change = [g.sub(a, b) for a, b in zip(exact, coarse, strict=True)]

        def largest(
            values: Sequence[int], sizes: Sequence[tuple[int, int]], *, rounded: bool = False
        ) -> int:
            """Return the largest value, in units of its row; rows of rounding errors have none."""
            maximum = g.zero
            bounds = rounding_bounds(g, values) if rounded else [g.zero] * len(values)
            for value, bound, (size, nothing) in zip(values, bounds, sizes, strict=True):
                total = g.sum([(g.call("abs", value), 1.0), (bound, ROUNDING)])
                share = g.call("select", nothing, g.zero, g.div(total, size))
                maximum = g.call("max", maximum, share)
            return maximum

        def sizes_of(squares: Sequence[int], units: Sequence[int]) -> list[tuple[int, int]]:
            sizes = [g.call("sqrt", size) for size in squares]
            limits = [g.sum([(unit, float(n))]) for unit in units]
            return [
                (size, g.call("le", size, limit)) for size, limit in zip(sizes, limits, strict=True)
            ]

        sizes, position_rows = sizes_of(squares, units), [row for _, row in self.position_residuals]
        acceleration_change = largest([dot(g, row, change) for row in rows], sizes)
        rate = largest([dot(g, row, change) for row in self.row_rates], sizes)
        velocity_error = largest(self.velocity_residuals, sizes, rounded=True)
        sizes = sizes_of(_squares(g, position_rows, weights), _roundings(g, matrix, position_rows))
        position_error = largest([node for node, _ in self.position_residuals], sizes, rounded=True)
        uncertain = g.add(
            g.mul(position_error, g.powi(rate, 2)), g.mul(velocity_error, rate, acceleration_change)
        )
        # Twice the acceleration that the residuals may cause, times four since they are bounds: a
        # change that is no larger may as well be left out.
        negligible = g.call("lt", g.powi(acceleration_change, 3), g.sum([(uncertain, 8.0)]))
        chosen = [g.call("select", negligible, b, a) for a, b in zip(exact, coarse, strict=True)]
        return LinearSystem(g, [[g.one]]).guarded(chosen, sound, list(fast))


def _mobilities(graph: Graph, matrix: Sequence[list[int]]) -> list[int]:
    """Return the inverse of each diagonal entry of M; zero for massless speeds."""
    mobilities = []
    for k, line in enumerate(matrix):
        massless = graph.call("eq", line[k], graph.zero)
        mobilities.append(graph.call("select", massless, graph.zero, graph.powi(line[k], -1)))
    return mobilities


def _is_above(graph: Graph, node: int, size: int, share: float) -> int:
    """Return whether a node exceeds a fraction of a size."""
    return graph.call("lt", graph.sum([(size, share)]), node)


def _roundings(
    graph: Graph, matrix: Sequence[list[int]], rows: Sequence[Sequence[int]]
) -> list[int]:
    """Return the size of the rounding errors of rows, with columns in units of equal energy."""
    bounds = iter(rounding_bounds(graph, [c for row in rows for c in row]))
    weights, units = _mobilities(graph, matrix), []
    for row in rows:
        squares = [graph.powi(graph.add(graph.call("abs", c), next(bounds)), 2) for c in row]
        size = graph.call("sqrt", _square(graph, squares, weights))
        units.append(graph.sum([(size, ROUNDING)]))
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
    return LinearSystem(graph, system).guarded([*forcing, *pull], sound, fast)[:n]


def multipliers_of(
    graph: Graph, rows: Sequence[list[int]], force: list[int], rank: int
) -> list[int]:
    """Return λ with Jᵀ λ = f, of least norm if rows of J are redundant."""
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
    """Sparse symbolic L D Lᵀ of a symmetric matrix; `pivots` are D.

    It `is_short` if it takes no more operations than a dense matrix that would be written out.
    Beyond such sizes the order is one with little fill-in, so that the cost of a chain of loops is
    proportional to its length.
    """

    def __init__(self, graph: Graph, square: Sequence[list[int]]) -> None:
        n = len(square)
        self.graph, self.pivots = graph, [graph.zero] * n
        self._inverses = [graph.zero] * n
        # Both triangles from the lower one: structural zeros there may be unsimplified sums above.
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
        columns: dict[int, dict[int, int]] = {}
        for j in self._order:
            pivot = self.pivots[j] = cell[j].pop(j, graph.zero)
            self._inverses[j] = graph.powi(pivot, -1)
            below, columns[j] = sorted(cell[j]), {}
            for i in below:
                del cell[i][j]
                columns[j][i] = graph.mul(cell[j][i], self._inverses[j])
            for a, i in enumerate(below):
                for k in below[: a + 1]:
                    update = graph.mul(columns[j][i], cell[j][k])
                    cell[i][k] = cell[k][i] = graph.sub(cell[i].get(k, graph.zero), update)
        return columns

    def solution(self, right: Sequence[int]) -> list[int]:
        """Return the solution for one right-hand side."""
        graph, solution = self.graph, list(right)
        for j, column in self._lower.items():
            for i, share in column.items():
                solution[i] = graph.sub(solution[i], graph.mul(share, solution[j]))
        solution = [graph.mul(a, b) for a, b in zip(solution, self._inverses, strict=True)]
        for j in reversed(self._lower):
            for i, share in self._lower[j].items():
                solution[j] = graph.sub(solution[j], graph.mul(share, solution[i]))
        return solution


def solved_soundly(
    graph: Graph, square: Sequence[list[int]], right: list[int], sizes: list[int]
) -> tuple[list[int], int]:
    """Return the solution by LDLᵀ, and whether no pivot is small relative to its row."""
    eliminated, sound = _Elimination(graph, square), graph.boolean(True)
    solution = eliminated.solution(right)
    for pivot, size in zip(eliminated.pivots, sizes, strict=True):
        sound = graph.call("and", sound, _is_above(graph, pivot, size, SOUND_PIVOT))
    return solution, sound


def _usual(graph: Graph, squares: Sequence[int]) -> list[int]:
    """Return the usual squared sizes of rows, as scales for rows of J that may vanish.

    They are at most the mean of all rows and the size of the row at other states, so that rows in
    different units are compared with themselves. A square may be negative at these states, where
    quaternions do not have unit length.
    """
    mean = graph.sum([(size, 1.0 / len(squares)) for size in squares])
    elsewhere = usual_sizes(graph, [graph.call("abs", size) for size in squares])
    return [graph.call("min", mean, size) for size in elsewhere]


def _squares(graph: Graph, rows: Sequence[list[int]], weights: Sequence[int]) -> list[int]:
    """Return the squared sizes of rows, with columns in units of equal energy."""
    return [_square(graph, [graph.powi(c, 2) for c in row], weights) for row in rows]


def _square(graph: Graph, squares: Sequence[int], weights: Sequence[int]) -> int:
    """Return the weighted sum of the squares of a row's entries.

    A row of massless speeds alone has no energy: the plain sum is that of no other row, but not 0.
    """
    heavy = [
        (graph.mul(x, weight), 1.0)
        for x, weight in zip(squares, weights, strict=True)
        if graph.zero not in (x, weight)
    ]
    return graph.sum(heavy or [(x, 1.0) for x in squares])


def usual_sizes(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return the means of nodes over generic states, as functions of the constants.

    Angles are of order one. Coordinates outside of trigonometric functions may have any unit: they
    are scaled by their Euclidean norm.
    """
    moving = inputs_of(graph, nodes).moving
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
    visited: set[int] = set()
    stack = list(nodes)
    while stack:
        if (node := stack.pop()) not in visited:
            visited.add(node)
            if graph.ops[node] in _HOMOGENEOUS:
                stack += graph.operands(node)
    return visited
