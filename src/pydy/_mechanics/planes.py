"""Rotations by three angles, taken apart into the plane rotations that they are made of.

Three plane rotations take 48 operations of a symmetric 3 by 3 matrix (`pydy._mechanics.turns`),
their product takes 75. Of a vector they take 18, the product takes 15: only the form is handed on
in planes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from pydy._graph.derivative import Row, Rows
from pydy._graph.identities import signatures
from pydy._graph.node import Graph
from pydy._mechanics.components import transposed, turned

__all__ = ["Detours", "plane_rotations", "split"]

Matrix = list[list[int]]
Groups = list[list[int]]


@dataclass
class Detours:
    """Anchors between two frames, behind each of the plane rotations from one to the other.

    Attributes
    ----------
    rows : dict of nodes to rows
        Of anchors in the second frame, by those before the last rotation.
    stages : dict of pairs of frames to (int, list of groups for each rotation)
        The place of the first group that was handed on between two frames, and those between.
    """

    rows: dict[int, Row] = field(default_factory=dict)
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
        """Let anchors be reached in plane rotations too.

        Parameters
        ----------
        graph : Graph
        rows : Rows
        ends : pair of frames
        places : (int, group)
            Where the anchors' group is, and that.
        rotations : sequence of matrices
            Plane ones, from the one frame to the other.
        vectors : pair of lists of nodes
            Components in both frames.
        anchored : callable
            ``anchored(v, groups)`` makes anchors of components, and adds them to some groups.
        """
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
        """Return groups with those between two frames before the first that is handed on there.

        What is handed on by the same rotations can then be so together.
        """
        before = dict(self.stages.values())
        found: Groups = []
        for place, group in enumerate(groups):
            found += [between for stage in before.get(place, ()) for between in stage]
            found.append(list(group))
        return found

    def paying(self, graph: Graph, order: Sequence[list[int]], own: Mapping[int, Row]) -> set[int]:
        """Return the anchors whose form is to be handed on in planes, with three components.

        The form of the outermost bodies is constant, and mostly diagonal: not theirs.

        Parameters
        ----------
        graph : Graph
        order : sequence of groups
            The outer ones first.
        own : mapping of nodes to rows
            Of each anchor by those that it is made of, in one step.
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
    groups: Sequence[Sequence[int]], rows: Mapping[int, Row], turning: Collection[int]
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
    middle = [[g.one if a == b == j else g.zero for b in range(3)] for a in range(3)]
    a, b = (j + 1) % 3, (j + 2) % 3
    middle[a][a] = middle[b][b] = c
    middle[a][b], middle[b][a] = s, g.neg(s)
    if middle[k][i] != matrix[k][i]:
        if i == k:
            return None
        middle[a][b], middle[b][a] = g.neg(s), s
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
    values = signatures(g, [n for m in (matrix, product) for row in m for n in row])
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
    found = [[g.one if a == b == axis else g.zero for b in range(3)] for a in range(3)]
    found[place][place] = found[other][other] = c
    found[place][other], found[other][place] = s, g.neg(s)
    return found
