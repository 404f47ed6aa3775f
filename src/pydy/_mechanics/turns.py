"""Symmetric forms under a rotation in a plane.

With c = cos q, s = sin q and R = [[c, s], [-s, c]], a matrix K becomes

    Rᵀ K R = [[K₂₂ + c p, K₁₂ + s p],        p = c (K₁₁ − K₂₂) − s (K₁₂ + K₂₁),
              [K₂₁ + s p, K₁₁ − c p]]

which takes half the operations of the products. The moments and products of inertia of a body that
is hinged are such blocks, and so is what couples its turning to its translation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from pydy._graph.derivative import Row
from pydy._graph.node import Graph
from pydy._mechanics.tuning import SAME_DIRECTION

__all__ = ["Turn", "joined_turns", "turn_of"]


@dataclass(frozen=True)
class Turn:
    """Two anchors that are two others, turned by an angle, up to signs.

    Attributes
    ----------
    columns : pair of nodes
        The others, so that the first anchor has the cosine by the first of them.
    signs : pair of floats
        Of the columns: with these the rows are (c, s) and sign · (−s, c).
    sign : float
    cosine, sine : node
    """

    columns: tuple[int, int]
    signs: tuple[float, float]
    sign: float
    cosine: int
    sine: int

    def of(self, graph: Graph, block: Sequence[Sequence[int]], other: Turn) -> list[list[int]]:
        """Return Rᵀ K R for a block of the form; the right R is that of another turn."""

        def signed(node: int, sign: float) -> int:
            return node if sign > 0.0 else graph.neg(node)

        upper, lower = block
        k11, k12 = upper[0], signed(upper[1], other.sign)
        k21, k22 = signed(lower[0], self.sign), signed(lower[1], self.sign * other.sign)
        c, s = self.cosine, self.sine
        p = graph.sub(graph.mul(c, graph.sub(k11, k22)), graph.mul(s, graph.add(k12, k21)))
        along, across = graph.mul(c, p), graph.mul(s, p)
        image = [
            [graph.add(k22, along), graph.add(k12, across)],
            [graph.add(k21, across), graph.sub(k11, along)],
        ]
        return [
            [signed(n, one * two) for n, two in zip(row, other.signs, strict=True)]
            for row, one in zip(image, self.signs, strict=True)
        ]


def turn_of(graph: Graph, rows: Mapping[int, Row], pair: Sequence[int]) -> Turn | None:
    """Return how two anchors are two others, turned by an angle; None if they are not."""
    if len(pair) != 2:
        return None
    first, second = rows[pair[0]], rows[pair[1]]
    if len(first) != 2 or first.keys() != second.keys():
        return None
    parts = _by_numbers(graph, first) or _by_an_angle(graph, first)
    if parts is None:
        return None
    (x, one, c), (y, two, s) = parts
    for sign in (1.0, -1.0):
        if second[x] == graph.sum([(s, -sign * one)]) and second[y] == graph.sum([(c, sign * two)]):
            return Turn((x, y), (one, two), sign, c, s)
    return None


# The column, the sign and the node of the cosine, and of the sine.
_Parts = tuple[tuple[int, float, int], tuple[int, float, int]]


def _by_an_angle(graph: Graph, row: Row) -> _Parts | None:
    parts = {}
    for column, n in row.items():
        size, node = graph.scaled(n)
        if abs(size) == 1.0:
            parts[graph.ops[node]] = column, size, node
    if parts.keys() != {"cos", "sin"}:
        return None
    cosine, sine = parts["cos"], parts["sin"]
    return (cosine, sine) if graph.args[cosine[2]] == graph.args[sine[2]] else None


def _by_numbers(graph: Graph, row: Row) -> _Parts | None:
    numbers = [graph.value(n) for n in row.values()]
    if None in numbers or abs(sum(x * x for x in numbers if x is not None) - 1.0) > SAME_DIRECTION:
        return None
    (x, c), (y, s) = row.items()
    return (x, 1.0, c), (y, 1.0, s)


def joined_turns(
    graph: Graph, order: Sequence[list[int]], rows: Mapping[int, Row]
) -> list[list[int]]:
    """Return groups in which pairs that turn by one angle are together: a body's two velocities."""
    groups: list[list[int]] = []
    open_turns: dict[tuple[int, int], int] = {}
    for group in order:
        turn = turn_of(graph, rows, group)
        key = turn and (turn.cosine, turn.sine)
        place = open_turns.pop(key, None) if key else None
        if place is not None:
            # The earlier pair waits for this one, unless what comes between is made of it.
            first = groups[place]
            between = {k for other in [*groups[place + 1 :], group] for k in other}
            if not between & {c for k in first for c in rows[k]}:
                group = [*first, *group]
                groups[place] = []
                key = None
        if key:
            open_turns[key] = len(groups)
        groups.append(group)
    return [group for group in groups if group]
