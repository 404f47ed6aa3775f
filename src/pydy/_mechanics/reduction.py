"""Equations of the independent speeds: the reduced mass matrix, and a fallback if it is singular.

The rows of the constraint matrix are solved in groups with as many new unknowns as rows, one to
three, each by Cramer's rule. The unknowns of a singular group are not finite, as in SymPy's
symbolic solutions.

If the constraints determine the dependent speeds poorly, several independent speeds cause nearly
the same motion, and their part of the mass matrix is nearly singular. The formulation is chosen by
how often this occurs at random states; each formulation is valid everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from pydy._graph import Graph, LinearSystem, inputs_of, jacobian, substitute
from pydy._mechanics.acceleration_constraints import (
    AccelerationConstraints,
    solved_soundly,
    usual_sizes,
)
from pydy._mechanics.components import dot, identity, product
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.tuning import (
    CLEAR,
    GUARDED_UP_TO,
    LESS_OFTEN,
    LIGHT,
    LIGHTEST,
    NEARLY_DEPENDENT,
    OFTEN,
    SOUND_PIVOT,
    SOUND_SHARE,
)

if TYPE_CHECKING:
    import sympy as sm

# Of states, time, specifieds and constants: those differ from state to state too.
_RANGES = {"x": (-1.0, 1.0), "t": (0.0, 1.0), "r": (0.5, 1.5), "p": (0.5, 1.5)}


def reduced(
    kinematics: Kinematics, matrix: list[list[int]], forcing: list[int], moved: bool
) -> tuple[list[list[int]], list[int], list[int] | None]:
    """Return M, F and u' with the acceleration constraints as rows of the dependent speeds.

    With u_d' = A u_i' + b the equations of the independent speeds are
    [1; A]ᵀ M [1; A] u_i' = [1; A]ᵀ (F − M [0; b]).
    """
    g, n = kinematics.graph, len(forcing)
    d = len(kinematics.body.constraints.velocity)
    p = n - d
    rows, bias = _constraints(kinematics, kinematics.body.constraints.velocity)
    dependent_part = [row[p:] for row in rows]
    columns = [[g.neg(row[i]) for row in rows] for i in range(p)] + [[g.neg(x) for x in bias]]
    solved, determinants = solve_by_cofactors(g, dependent_part, columns) or (
        [*map(LinearSystem(g, dependent_part).solve, columns)],
        [],
    )
    null_space = [[*unit, *column] for unit, column in zip(identity(g, p), solved[:p], strict=True)]
    upper_rows = [
        [dot(g, direction, [row[j] for row in matrix]) for j in range(n)]
        for direction in null_space
    ]
    force = [dot(g, direction, forcing) for direction in null_space]
    user_rows = _given_accelerations(kinematics, rows, bias)
    lower_rows, row_bias = user_rows or (rows, bias)
    system = [*upper_rows, *lower_rows], [*force, *(g.neg(x) for x in row_bias)]
    if user_rows or moved:
        return *system, None
    bound = _all_constraints(kinematics, rows, bias)
    if kinematics.body.dependents.changing and definite(g, matrix):
        return *system, bound.accelerations(g, matrix, forcing)
    base = [g.zero] * p + solved[p]
    basis = _Basis(g, null_space, upper_rows, base, _nearly_parallel(g, matrix, rows))
    sound = g.boolean(True)
    for determinant in determinants:
        sound = g.call("and", sound, _is_clear(g, determinant))
    if len(bound.rows) > d:
        # The retained rows may lose rank on a regular path, which then requires all rows.
        sound = g.boolean(False)
    if 1 < p <= GUARDED_UP_TO:
        sizes = [
            g.zero,
            *(g.sum([(basis.projected_mass_matrix[i][i], SOUND_SHARE)]) for i in range(1, p)),
        ]
        shares, well = solved_soundly(g, basis.projected_mass_matrix, basis.right(forcing), sizes)
        sound = g.call("and", sound, well)
    else:
        shares = LinearSystem(g, basis.projected_mass_matrix, "ldl").solve(basis.right(forcing))
    for i in range(p):
        if matrix[i][i] != g.zero:
            limit = g.sum([(basis.sizes[i], LIGHT if p <= GUARDED_UP_TO else LIGHTEST)])
            sound = g.call("and", sound, g.call("not", g.call("lt", matrix[i][i], limit)))
    fast = basis.combined(shares)
    return *system, bound.accelerations_at_any_rank(g, matrix, forcing, sound, fast)


class _Basis:
    """A basis u' = z₁ c₁ + … + w of consistent accelerations, and its mass matrix.

    Nearly parallel directions, and w, are made M-orthogonal by the modified Gram–Schmidt process
    (Björck, BIT 7, 1967): the equations for all z would lose twice as many digits.
    `projected_mass_matrix` holds cᵢ·M cⱼ, `sizes` its diagonal before the process.
    """

    def __init__(
        self,
        graph: Graph,
        directions: Sequence[list[int]],
        pushed: Sequence[list[int]],
        base: list[int],
        orthogonalised: Sequence[int],
    ) -> None:
        g, p = graph, len(directions)
        self.graph = g
        self._directions, self._pushed, self._base = list(directions), list(pushed), base
        self.sizes = [g.zero] * p
        for i in range(p):
            self.sizes[i] = dot(g, directions[i], pushed[i])
        for number, i in enumerate(orthogonalised):
            size = dot(g, self._directions[i], self._pushed[i])
            for j in orthogonalised[number + 1 :]:
                share = g.div(dot(g, self._pushed[i], self._directions[j]), size)
                self._directions[j] = self._subtracted(
                    self._directions[j], share, self._directions[i]
                )
                self._pushed[j] = self._subtracted(self._pushed[j], share, self._pushed[i])
            share = g.div(dot(g, self._pushed[i], self._base), size)
            self._base = self._subtracted(self._base, share, self._directions[i])
        self.projected_mass_matrix = [
            [
                g.zero
                if i != j and i in orthogonalised and j in orthogonalised
                else dot(g, self._directions[j], self._pushed[i])
                for j in range(p)
            ]
            for i in range(p)
        ]

    def _subtracted(self, a: list[int], share: int, b: list[int]) -> list[int]:
        """Return a − share · b, protected from rewriting."""
        g = self.graph
        return [g.call("kept", g.sub(x, g.mul(share, y))) for x, y in zip(a, b, strict=True)]

    def right(self, forcing: Sequence[int]) -> list[int]:
        """Return cᵢ·(F − M w)."""
        g = self.graph
        return [
            g.sum(
                [(dot(g, direction, forcing), 1.0)]
                + [(g.mul(a, w), -1.0) for a, w in zip(pushed, self._base, strict=True)]
            )
            for direction, pushed in zip(self._directions, self._pushed, strict=True)
        ]

    def combined(self, shares: Sequence[int]) -> list[int]:
        """Return u'."""
        g = self.graph
        return [
            g.sum(
                [
                    (w, 1.0),
                    *((g.mul(z, c[k]), 1.0) for z, c in zip(shares, self._directions, strict=True)),
                ]
            )
            for k, w in enumerate(self._base)
        ]


def _all_constraints(
    kinematics: Kinematics, rows: list[list[int]], bias: list[int]
) -> AccelerationConstraints:
    """Return the constraints, redundant ones included, and their residuals."""
    body, read, dt = kinematics.body, kinematics.read, kinematics.dt
    constraints = body.constraints
    velocity = constraints.velocity
    if body.dependents.changing:
        redundant_rows, redundant_bias = _constraints(kinematics, constraints.redundant.velocity)
        velocity, rows, bias = (
            (*velocity, *constraints.redundant.velocity),
            [*rows, *redundant_rows],
            [*bias, *redundant_bias],
        )
    rates = [dt(row) for row in rows]
    residuals = read.all(constraints.of_positions)
    residual_rows = jacobian(kinematics.graph, dt(residuals), kinematics.speeds).dense()
    d = len(constraints.velocity)
    pairs = list(zip(residuals, residual_rows, strict=True))
    return AccelerationConstraints(rows, bias, d, rates, read.all(velocity), pairs)


def _constraints(
    kinematics: Kinematics, velocity: Sequence[sm.Expr]
) -> tuple[list[list[int]], list[int]]:
    """Return K and b of differentiated velocity constraints K u' + b = 0."""
    nodes = kinematics.read.all(velocity)
    return jacobian(kinematics.graph, nodes, kinematics.speeds).dense(), kinematics.dt(nodes)


def _given_accelerations(
    kinematics: Kinematics, rows: list[list[int]], derived_bias: list[int]
) -> tuple[list[list[int]], list[int]] | None:
    """Return K and b of the user's acceleration constraints, unless they equal those of `rows`."""
    g, body = kinematics.graph, kinematics.body
    if not body.constraints.acceleration:
        return None
    nodes = kinematics.read.all(body.constraints.acceleration)
    table = jacobian(g, nodes, kinematics.accelerations).dense()
    bias = substitute(g, nodes, dict.fromkeys(kinematics.accelerations, g.zero))
    flat = [n for row in (*table, bias) for n in row]
    derived = [n for row in (*rows, derived_bias) for n in row]
    return None if kinematics.equal(flat, derived) else (table, bias)


# -- dependent speeds by cofactors -----------------------------------------------------------------


def _is_clear(graph: Graph, determinant: int) -> int:
    """Return whether a determinant is not small compared to its size at other states."""
    if graph.constant[determinant]:
        return graph.boolean(True)
    size = graph.call("abs", determinant)
    (usual,) = usual_sizes(graph, [size])
    # If the usual size is not finite or zero, no determinant counts as small.
    return graph.call("not", graph.call("le", size, graph.sum([(usual, CLEAR)])))


def solve_by_cofactors(
    graph: Graph,
    matrix: Sequence[Sequence[int]],
    columns: Sequence[Sequence[int]],
) -> tuple[list[list[int]], list[int]] | None:
    """Return the solutions of ``matrix · x = column``, and determinants of groups of unknowns.

    None if more than three unknowns are coupled.
    """
    ordered = _groups(graph, matrix)
    if ordered is None:
        return None
    solutions: list[dict[int, int]] = [{} for _ in columns]
    determinants = []
    for rows, unknowns in ordered:
        block = [[matrix[i][j] for j in unknowns] for i in rows]
        right_sides = [
            [
                graph.sum(
                    [(column[i], 1.0)]
                    + [(graph.mul(matrix[i][j], x), -1.0) for j, x in solution.items()]
                )
                for i in rows
            ]
            for column, solution in zip(columns, solutions, strict=True)
        ]
        inverse = _inverse(graph, block)
        values = [product(graph, inverse, right_side) for right_side in right_sides]
        for solution, several in zip(solutions, values, strict=True):
            solution.update(zip(unknowns, several, strict=True))
        determinants.append(_determinant(graph, block))
    return [[solution[j] for j in range(len(matrix))] for solution in solutions], determinants


def _groups(
    graph: Graph, matrix: Sequence[Sequence[int]]
) -> list[tuple[tuple[int, ...], tuple[int, ...]]] | None:
    """Return groups of rows and the unknowns that they determine, in order."""
    used = {i: {j for j, n in enumerate(row) if n != graph.zero} for i, row in enumerate(matrix)}
    groups = []
    while used:
        group = next(
            (
                (rows, unknowns)
                for size in range(1, 4)
                for rows in combinations(used, size)
                if len(unknowns := set().union(*(used[i] for i in rows))) == size
            ),
            None,
        )
        if group is None:
            return None
        rows, unknowns = group
        groups.append((rows, tuple(sorted(unknowns))))
        used = {i: columns - unknowns for i, columns in used.items() if i not in rows}
    return groups


def _determinant(graph: Graph, matrix: list[list[int]]) -> int:
    minors = [_minor(graph, matrix, 0, j) for j in range(len(matrix))]
    return dot(graph, matrix[0], minors)


def _inverse(graph: Graph, matrix: list[list[int]]) -> list[list[int]]:
    n = len(matrix)
    minors = [[_minor(graph, matrix, i, j) for j in range(n)] for i in range(n)]
    inverse = graph.powi(_determinant(graph, matrix), -1)
    return [[graph.mul(minors[i][j], inverse) for i in range(n)] for j in range(n)]


def _minor(graph: Graph, matrix: list[list[int]], i: int, j: int) -> int:
    """Return a cofactor of a matrix of up to three rows."""
    n = len(matrix)
    if n == 1:
        return graph.one
    if n == 2:
        node = matrix[1 - i][1 - j]
        return node if i == j else graph.neg(node)
    (a, b), (c, d) = ((i + 1) % 3, (i + 2) % 3), ((j + 1) % 3, (j + 2) % 3)
    return graph.sub(graph.mul(matrix[a][c], matrix[b][d]), graph.mul(matrix[a][d], matrix[b][c]))


# -- motions that are nearly parallel --------------------------------------------------------------


def _nearly_parallel(
    graph: Graph, matrix: Sequence[Sequence[int]], rows: Sequence[Sequence[int]]
) -> list[int]:
    """Return the independent speeds whose directions must be orthogonalised."""
    n, d = len(matrix), len(rows)
    p = n - d
    if not 1 < p <= GUARDED_UP_TO:
        return []
    values = _at_states(graph, [*(e for row in matrix for e in row), *(e for r in rows for e in r)])
    if values is None:
        return []
    masses = values[:, : n * n].reshape(-1, n, n)
    constraint_rows = values[:, n * n :].reshape(-1, d, n)
    with np.errstate(all="ignore"):
        try:
            dependent_part = np.linalg.solve(constraint_rows[:, :, p:], -constraint_rows[:, :, :p])
        except np.linalg.LinAlgError:
            return []
        unit = np.broadcast_to(np.eye(p), (len(values), p, p))
        null_space = np.concatenate([unit, dependent_part], axis=1)
        square = np.swapaxes(null_space, 1, 2) @ masses @ null_space
        chosen: list[int] = []
        share = _weak(square, chosen)
        while share > OFTEN and len(chosen) < p:
            # Start with pairs: a single direction leaves the basis unchanged.
            tried = [
                [*chosen, *added]
                for added in combinations(
                    [k for k in range(p) if k not in chosen], 1 if chosen else 2
                )
            ]
            shares = [_weak(square, group) for group in tried]
            if min(shares) > LESS_OFTEN * share:
                break
            share, chosen = min(zip(shares, tried, strict=True))
    return sorted(chosen)


def definite(graph: Graph, matrix: Sequence[Sequence[int]]) -> bool:
    """Return whether the mass matrix is positive definite at most states, up to rounding.

    Decimal coefficients of a singular matrix leave rounding errors as pivots.
    """
    n = len(matrix)
    values = _at_states(graph, [e for row in matrix for e in row])
    if values is None or not len(values):
        return False
    masses = values.reshape(-1, n, n)
    roots = np.sqrt(np.abs(np.diagonal(masses, axis1=1, axis2=2)))
    roots[roots == 0.0] = 1.0
    shares = masses / (roots[:, :, None] * roots[:, None, :])
    least = np.linalg.svd(shares, compute_uv=False)[:, -1]
    return bool(np.median(least) > NEARLY_DEPENDENT[0])


def _weak(square: np.ndarray, orthogonalised: Sequence[int]) -> float:
    """Return the share of states with a small pivot if some directions are orthogonalised."""
    work = square.copy()
    for number, i in enumerate(orthogonalised):
        for j in orthogonalised[number + 1 :]:
            ratio = (work[:, i, j] / work[:, i, i])[:, None]
            work[:, j] -= ratio * work[:, i]
            work[:, :, j] -= ratio * work[:, :, i]
            work[:, i, j] = work[:, j, i] = 0.0
    sizes = np.diagonal(work, axis1=1, axis2=2).copy()
    least = np.ones(len(work))
    for k in range(work.shape[1]):
        least = np.fmin(least, work[:, k, k] / sizes[:, k])
        work[:, k + 1 :] -= (
            work[:, k + 1 :, k : k + 1] * work[:, k : k + 1] / work[:, k : k + 1, k : k + 1]
        )
    return float(np.mean(least < SOUND_PIVOT * SOUND_SHARE)) if len(work) else 0.0


def _at_states(graph: Graph, nodes: Sequence[int]) -> np.ndarray | None:
    """Return the values of nodes at random states; None if they have other inputs."""
    inputs = inputs_of(graph, nodes)
    if not inputs.groups <= _RANGES.keys():
        return None
    rng = np.random.default_rng(0)
    at = {n: rng.uniform(*_RANGES[group], 512) for n, (group, _) in inputs.items()}
    values = graph.evaluator(nodes)(at, 512)
    finite: np.ndarray = values[np.isfinite(values).all(axis=1)]
    return finite
