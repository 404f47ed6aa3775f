"""Equations of the independent speeds: the reduced mass matrix, and what holds where it fails."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

from pydy._graph.derivative import dense_rows, jacobian
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._mechanics.divided import Group, divided
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.multipliers import (
    Constraints,
    accelerations,
    accelerations_of_held,
    solved_soundly,
)
from pydy._mechanics.spread import definite, nearly_parallel
from pydy._mechanics.tuning import GUARDED_UP_TO, LIGHT, LIGHTEST, SOUND_SHARE

__all__ = ["reduced", "slopes"]


def reduced(
    kinematics: Kinematics, matrix: list[list[int]], forcing: list[int], moved: bool
) -> tuple[list[list[int]], list[int], list[int] | None]:
    """Return M, F and u' with the dependent speeds' equations by the acceleration constraints.

    With u_d' = A u_i' + b the equations of the independent speeds are
    [1; A]ᵀ M [1; A] u_i' = [1; A]ᵀ (F − M [0; b]).
    """
    g, n = kinematics.graph, len(forcing)
    d = len(kinematics.body.velocity)
    p = n - d
    rows, drift = _constraints(kinematics, kinematics.body.velocity)
    held = [row[p:] for row in rows]
    columns = [[g.neg(row[i]) for row in rows] for i in range(p)] + [[g.neg(x) for x in drift]]
    apart, loose = nearly_parallel(g, matrix, rows)
    solved, groups = divided(g, held, columns, loose) or (g.solve(held, columns, "lu"), [])
    moves = [[*(g.one if i == j else g.zero for j in range(p)), *solved[i]] for i in range(p)]
    upper = [[_dot(g, move, [row[j] for row in matrix]) for j in range(n)] for move in moves]
    force = [_dot(g, move, forcing) for move in moves]
    given = _given_accelerations(kinematics, rows, drift)
    below, pull = given or (rows, drift)
    whole = [*upper, *below], [*force, *(g.neg(x) for x in pull)]
    if given or moved:
        return *whole, None
    bound = _held(kinematics, rows, drift)
    if kinematics.body.changing and definite(g, matrix):
        return *whole, accelerations_of_held(g, matrix, forcing, bound)
    base = [g.zero] * p + solved[p]
    basis = _Basis(g, moves, upper, base, apart)
    sound = _clear(g, groups, loose, matrix, moves)
    if 1 < p <= GUARDED_UP_TO:
        sizes = [g.zero, *(g.sum([(basis.square[i][i], SOUND_SHARE)]) for i in range(1, p))]
        shares, well = solved_soundly(g, basis.square, basis.right(forcing), sizes)
        sound = g.call("and", sound, well)
    else:
        shares = g.solve(basis.square, [basis.right(forcing)], "ldl")[0]
    for i in range(p):
        if matrix[i][i] != g.zero:
            limit = g.sum([(basis.sizes[i], LIGHT if p <= GUARDED_UP_TO else LIGHTEST)])
            sound = g.call("and", sound, g.call("not", g.call("lt", matrix[i][i], limit)))
    found = basis.combined(shares)
    return *whole, accelerations(g, matrix, forcing, bound, sound, found)


class _Basis:
    """Directions u' = z₁ c₁ + … + w in which the constraints hold, and their mass matrix.

    Directions that are nearly parallel are made orthogonal by the mass matrix, with w, as in
    Gram and Schmidt's modified process (Björck, BIT 7, 1967): the equations for all z would lose
    twice as many digits.

    Attributes
    ----------
    square : p lists of p nodes
        cᵢ·M cⱼ.
    sizes : p nodes
        What it is of each independent speed by itself.
    """

    def __init__(
        self,
        graph: Graph,
        moves: Sequence[list[int]],
        pushed: Sequence[list[int]],
        base: list[int],
        apart: Sequence[int],
    ) -> None:
        g, p = graph, len(moves)
        self.graph = g
        self._moves, self._pushed, self._base = list(moves), list(pushed), base
        self.sizes = [g.zero] * p
        for i in range(p):
            self.sizes[i] = _dot(g, moves[i], pushed[i])
        for place, i in enumerate(apart):
            size = _dot(g, self._moves[i], self._pushed[i])
            for j in apart[place + 1 :]:
                share = g.div(_dot(g, self._pushed[i], self._moves[j]), size)
                self._moves[j] = self._less(self._moves[j], share, self._moves[i])
                self._pushed[j] = self._less(self._pushed[j], share, self._pushed[i])
            share = g.div(_dot(g, self._pushed[i], self._base), size)
            self._base = self._less(self._base, share, self._moves[i])
        self.square = [
            [
                g.zero
                if i != j and i in apart and j in apart
                else _dot(g, self._moves[j], self._pushed[i])
                for j in range(p)
            ]
            for i in range(p)
        ]

    def _less(self, a: list[int], share: int, b: list[int]) -> list[int]:
        """Return a − share · b, which rewriting is to leave as it is."""
        g = self.graph
        return [g.call("kept", g.sub(x, g.mul(share, y))) for x, y in zip(a, b, strict=True)]

    def right(self, forcing: Sequence[int]) -> list[int]:
        """Return cᵢ·(F − M w)."""
        g = self.graph
        return [
            g.sum(
                [(_dot(g, move, forcing), 1.0)]
                + [(g.mul(a, w), -1.0) for a, w in zip(pushed, self._base, strict=True)]
            )
            for move, pushed in zip(self._moves, self._pushed, strict=True)
        ]

    def combined(self, shares: Sequence[int]) -> list[int]:
        """Return u'."""
        g = self.graph
        return [
            g.sum(
                [
                    (w, 1.0),
                    *((g.mul(z, c[k]), 1.0) for z, c in zip(shares, self._moves, strict=True)),
                ]
            )
            for k, w in enumerate(self._base)
        ]


def _clear(
    g: Graph,
    groups: Sequence[Group],
    loose: Collection[int],
    matrix: Sequence[list[int]],
    moves: Sequence[list[int]],
) -> int:
    """Return whether no group of dependent speeds is nearly singular.

    The determinant with an independent speed j in place of a dependent one k is a share du_k'/du_j'
    of what it is; speeds are in units of what has equal energy.
    """
    p = len(moves)
    found = g.boolean(True)
    for group in groups:
        others = [
            (g.mul(matrix[p + k][p + k], g.powi(move[p + k], 2), g.powi(matrix[j][j], -1)), 1.0)
            for k in sorted(set(group.unknowns) & set(loose))
            for j, move in enumerate(moves)
            if matrix[j][j] != g.zero
        ]
        clear = group.clear(g, g.sum(others, 1.0) if others else None)
        found = g.call("and", found, clear)
    return found


def _held(kinematics: Kinematics, rows: list[list[int]], drift: list[int]) -> Constraints:
    """Return the constraints with the redundant ones, and their residuals."""
    body, read, dt = kinematics.body, kinematics.read, kinematics.dt
    velocity = body.velocity
    if body.changing:
        more, pull = _constraints(kinematics, body.redundant)
        velocity, rows, drift = (*velocity, *body.redundant), [*rows, *more], [*drift, *pull]
    rates = [dt(row) for row in rows]
    places = read.all([*body.holonomic, *body.closed])
    along = slopes(kinematics.graph, dt(places), kinematics.speeds)
    d = len(body.velocity)
    pairs = list(zip(places, along, strict=True))
    return Constraints(rows, drift, d, rates, read.all(velocity), pairs)


def _constraints(
    kinematics: Kinematics, velocity: Sequence[Any]
) -> tuple[list[list[int]], list[int]]:
    """Return K and b of differentiated velocity constraints K u' + b = 0."""
    nodes = kinematics.read.all(velocity)
    return slopes(kinematics.graph, nodes, kinematics.speeds), kinematics.dt(nodes)


def _given_accelerations(
    kinematics: Kinematics, rows: list[list[int]], drift: list[int]
) -> tuple[list[list[int]], list[int]] | None:
    """Return K and b of the user's acceleration constraints, unless they are those of `rows`."""
    g, body = kinematics.graph, kinematics.body
    if not body.acceleration:
        return None
    nodes = kinematics.read.all(body.acceleration)
    table = slopes(g, nodes, kinematics.accelerations)
    rest = substitute(g, nodes, dict.fromkeys(kinematics.accelerations, g.zero))
    flat = [n for row in (*table, rest) for n in row]
    own = [n for row in (*rows, drift) for n in row]
    return None if kinematics.equal(flat, own) else (table, rest)


def slopes(graph: Graph, nodes: Sequence[int], by: Sequence[int]) -> list[list[int]]:
    return dense_rows(graph, jacobian(graph, nodes, by), len(by))


def _dot(graph: Graph, a: Sequence[int], b: Sequence[int]) -> int:
    return graph.sum([(graph.mul(x, y), 1.0) for x, y in zip(a, b, strict=True)])
