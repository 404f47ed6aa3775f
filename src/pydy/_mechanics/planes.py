"""Rotations by three angles as plane rotations, and symmetric forms under one of these.

With c = cos q, s = sin q and R = [[c, s], [-s, c]], a matrix K becomes

    Rᵀ K R = [[K₂₂ + c p, K₁₂ + s p],        p = c (K₁₁ − K₂₂) − s (K₁₂ + K₂₁),
              [K₂₁ + s p, K₁₁ − c p]]

which takes half the operations of the products. The moments and products of inertia of a body that
is hinged are such blocks, and so is what couples its turning to its translation. Three plane
rotations take 48 operations of a symmetric 3 by 3 matrix, their product takes 75. Of a vector they
take 18, the product takes 15: only the form is handed on in planes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from pydy._graph import Graph, Rows, signatures
from pydy._mechanics.components import about, flat, transposed, turned
from pydy._mechanics.tuning import SAME_DIRECTION

# The column, the sign and the node of the cosine, and of the sine.
_Parts = tuple[tuple[int, float, int], tuple[int, float, int]]


Matrix = list[list[int]]
Groups = list[list[int]]


@dataclass
class Detours:
    """Anchors between two frames, behind each of the plane rotations from one to the other."""

    # Of anchors in the second frame, by those before the last rotation.
    rows: dict[int, dict[int, int]] = field(default_factory=dict)
    # The place of the first group that was handed on between two frames, and those between.
    stages: dict[tuple[Any, Any], tuple[int, list[Groups]]] = field(default_factory=dict)

    def add(
        self,
        graph: Graph,
        rows: Rows,
        ends: tuple[Any, Any],
        places: tuple[int, list[int]],
        rotations: Sequence[Matrix],
        vectors: tuple[list[int], list[int]],
        anchored: Callable[[list[int], Groups], list[int]],
    ) -> None:
        """Let anchors be reached in plane rotations too."""
        place, group = places
        v, found = vectors
        *first, last = rotations
        _, stages = self.stages.setdefault(ends, (place, [[] for _ in first]))
        for matrix, groups in zip(first, stages, strict=True):
            v = anchored(turned(graph, matrix, v), groups)
        for n, other in zip(found, turned(graph, last, v), strict=True):
            row = rows(other)
            for core, size in rows(n).items():
                if core in group and core not in row:
                    self.rows[core] = {c: graph.mul(d, size) for c, d in row.items()}

    def arranged(self, groups: Sequence[Sequence[int]]) -> Groups:
        """Insert the groups of intermediate axes before the first group that passes them.

        What is handed on by the same rotations can then be so together.
        """
        before = dict(self.stages.values())
        found: Groups = []
        for place, group in enumerate(groups):
            found += [between for stage in before.get(place, ()) for between in stage]
            found.append(list(group))
        return found

    def paying(
        self, graph: Graph, order: Sequence[list[int]], own: Mapping[int, dict[int, int]]
    ) -> set[int]:
        """Return the anchors whose form is to be handed on in planes, with three components.

        The form of the outermost bodies is constant, and mostly diagonal: not theirs.
        """
        varied: set[int] = set()
        found: set[int] = set()
        for group in order:
            columns = {c for k in group for c in own[k]}
            if len(columns) > 2 and not varied.isdisjoint(group):
                found.update(k for k in group if k in self.rows)
            for k in group:
                varied.update(c for c, d in own[k].items() if k in varied or not graph.constant[d])
        return found


def split(
    groups: Sequence[Sequence[int]], rows: Mapping[int, dict[int, int]], turning: Collection[int]
) -> Groups:
    """Return groups with the components that turn apart from the one that does not."""
    found: Groups = []
    for group in groups:
        pair = [k for k in group if k not in turning or len(rows[k]) > 1]
        found += [pair] if pair else []
        found += [[k] for k in group if k not in pair]
    return found


def plane_rotations(graph: Graph, matrix: Matrix) -> list[Matrix]:
    """Return matrices of which the last times … times the first is a given one.

    They are rotations about coordinate axes, if there are three or two; else it is the matrix.
    Sequences of angles are recognised by the entry that holds the angle in the middle alone.
    """
    for r in range(3):
        for s in range(3):
            sign, node = graph.scaled(matrix[r][s])
            wanted = "cos" if r == s else "sin"
            if abs(sign) != 1.0 or graph.ops[node] != wanted:
                continue
            for j in {0, 1, 2} - {r, s}:
                found = _about(graph, matrix, r, j, s)
                if found is not None:
                    return found
    return [matrix]


def _about(graph: Graph, matrix: Matrix, k: int, j: int, i: int) -> list[Matrix] | None:
    """Return plane rotations about the axes i, j and k, in this order; None if it is none such.

    Rotations about k leave the row k as it is, those about i the column i: these are a row and a
    column of the rotation about j, turned by the others.
    """
    g = graph
    angle = g.args[g.scaled(matrix[k][i])[1]][0]
    c, s = g.call("cos", angle), g.call("sin", angle)
    middle = about(g, j, c, s)
    if middle[k][i] != matrix[k][i] and i != k:
        middle = about(g, j, c, g.neg(s))
    if middle[k][i] != matrix[k][i]:
        return None
    # The third axis beside j and k, and beside j and i: the plane that turns.
    along = k if i != k else 3 - i - j
    across = i if i != k else 3 - k - j
    first = _plane(g, i, along, [g.div(n, middle[k][along]) for n in matrix[k]])
    last = _plane(g, k, across, [g.div(row[i], middle[across][i]) for row in matrix])
    if first is None or last is None:
        return None
    last = transposed(last)
    found = [m for m in (first, middle, last) if any(m[n][n] != g.one for n in range(3))]
    product = found[0]
    for m in found[1:]:
        product = transposed([turned(g, m, column) for column in transposed(product)])
    values = signatures(g, [n for m in (matrix, product) for n in flat(m)])
    return found if len(found) > 1 and values[:9] == values[9:] else None


def _plane(graph: Graph, axis: int, place: int, row: list[int]) -> Matrix | None:
    """Return the rotation about an axis with a given row; None if that is none of one angle."""
    g, other = graph, 3 - axis - place
    c, s = row[place], row[other]
    one, two = g.scaled(c), g.scaled(s)
    if {g.ops[one[1]], g.ops[two[1]]} != {"cos", "sin"} or g.args[one[1]] != g.args[two[1]]:
        if (c, s) != (g.one, g.zero):
            return None
    elif abs(one[0]) != 1.0 or abs(two[0]) != 1.0:
        return None
    return about(g, axis, c, s if other == (place + 1) % 3 else g.neg(s))


@dataclass(frozen=True)
class Turn:
    """Two anchors that are two others, turned by an angle, up to signs."""

    # The others, so that the first anchor has the cosine by the first of them.
    columns: tuple[int, int]
    signs: tuple[float, float]  # of the columns: with these the rows are (c, s) and sign · (−s, c)
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


def turn_of(graph: Graph, rows: Mapping[int, dict[int, int]], pair: Sequence[int]) -> Turn | None:
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


def _by_an_angle(graph: Graph, row: dict[int, int]) -> _Parts | None:
    parts = {}
    for column, n in row.items():
        size, node = graph.scaled(n)
        if abs(size) == 1.0:
            parts[graph.ops[node]] = column, size, node
    if parts.keys() != {"cos", "sin"}:
        return None
    cosine, sine = parts["cos"], parts["sin"]
    return (cosine, sine) if graph.args[cosine[2]] == graph.args[sine[2]] else None


def _by_numbers(graph: Graph, row: dict[int, int]) -> _Parts | None:
    numbers = [graph.value(n) for n in row.values()]
    if None in numbers or abs(sum(x * x for x in numbers if x is not None) - 1.0) > SAME_DIRECTION:
        return None
    (x, c), (y, s) = row.items()
    return (x, 1.0, c), (y, 1.0, s)


def joined_turns(
    graph: Graph, order: Sequence[list[int]], rows: Mapping[int, dict[int, int]]
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
