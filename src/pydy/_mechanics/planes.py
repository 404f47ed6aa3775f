"""Rotations by three angles as plane rotations, and symmetric forms under one of these.

With c = cos q, s = sin q and R = [[c, s], [-s, c]], a matrix K becomes

    Rᵀ K R = [[K₂₂ + c p, K₁₂ + s p],        p = c (K₁₁ − K₂₂) − s (K₁₂ + K₂₁),
              [K₂₁ + s p, K₁₁ − c p]]

which takes half the operations of the products. The moments and products of inertia of a hinged
body are such blocks, and so is the coupling of its rotation and translation. For a symmetric 3 by 3
matrix, three plane rotations take 48 operations, their product takes 75. For a vector they take 18,
the product 15: only the quadratic form is expressed in the intermediate frames.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from pydy._graph import DerivativeRows, Graph, signatures
from pydy._mechanics.components import axis_rotation, flat, product, transposed
from pydy._mechanics.tuning import SAME_DIRECTION

if TYPE_CHECKING:
    from pydy._mechanics.frame_tree import AnyFrame

# The column, the sign and the node of the cosine, and of the sine.
_Parts = tuple[tuple[int, float, int], tuple[int, float, int]]


Matrix = list[list[int]]
Groups = list[list[int]]


@dataclass
class IntermediateFrames:
    """Anchors in the frames between the plane rotations that lead from one frame to another."""

    # DerivativeRows of the anchors in the second frame, by the anchors before the last rotation.
    rows: dict[int, dict[int, int]] = field(default_factory=dict)
    # By pairs of frames: the number of the first group transferred, and the groups between.
    stages: dict[tuple[AnyFrame, AnyFrame], tuple[int, list[Groups]]] = field(default_factory=dict)

    def add(
        self,
        graph: Graph,
        rows: DerivativeRows,
        ends: tuple[AnyFrame, AnyFrame],
        first_group: tuple[int, list[int]],
        rotations: Sequence[Matrix],
        vectors: tuple[list[int], list[int]],
        anchored: Callable[[list[int], Groups], list[int]],
    ) -> None:
        """Add the anchors of intermediate frames between two groups."""
        number, group = first_group
        v, components = vectors
        *first, last = rotations
        _, stages = self.stages.setdefault(ends, (number, [[] for _ in first]))
        for matrix, groups in zip(first, stages, strict=True):
            v = anchored(product(graph, matrix, v), groups)
        for n, intermediate in zip(components, product(graph, last, v), strict=True):
            row = rows(intermediate)
            for core, size in rows(n).items():
                if core in group and core not in row:
                    self.rows[core] = {c: graph.mul(d, size) for c, d in row.items()}

    def arranged(self, groups: Sequence[Sequence[int]]) -> Groups:
        """Insert the groups of intermediate axes before the first group that passes them.

        Groups with the same rotations can then be transferred together.
        """
        before = dict(self.stages.values())
        arranged: Groups = []
        for number, group in enumerate(groups):
            arranged += [intermediate for stage in before.get(number, ()) for intermediate in stage]
            arranged.append(list(group))
        return arranged

    def paying(
        self, graph: Graph, order: Sequence[list[int]], anchor_rows: Mapping[int, dict[int, int]]
    ) -> set[int]:
        """Return the anchors whose form costs less in plane rotations: with three components.

        The form of the outermost bodies is constant and mostly diagonal, so theirs does not.
        """
        varied: set[int] = set()
        paying: set[int] = set()
        for group in order:
            columns = {c for k in group for c in anchor_rows[k]}
            if len(columns) > 2 and not varied.isdisjoint(group):
                paying.update(k for k in group if k in self.rows)
            for k in group:
                varied.update(
                    c for c, d in anchor_rows[k].items() if k in varied or not graph.constant[d]
                )
        return paying


def split(
    groups: Sequence[Sequence[int]], rows: Mapping[int, dict[int, int]], turning: Collection[int]
) -> Groups:
    """Split groups into the two components that a plane rotation changes and the third."""
    parts: Groups = []
    for group in groups:
        pair = [k for k in group if k not in turning or len(rows[k]) > 1]
        parts += [pair] if pair else []
        parts += [[k] for k in group if k not in pair]
    return parts


def plane_rotations(graph: Graph, matrix: Matrix) -> list[Matrix]:
    """Factor a matrix into rotations about coordinate axes, the first factor applied first.

    Returns two or three rotations, or the matrix itself if it is not such a product. A sequence of
    Euler angles is recognised by the entry that depends on the middle angle only.
    """
    for r in range(3):
        for s in range(3):
            sign, node = graph.scaled(matrix[r][s])
            operation = "cos" if r == s else "sin"
            if abs(sign) != 1.0 or graph.ops[node] != operation:
                continue
            for j in {0, 1, 2} - {r, s}:
                rotations = _three_rotations(graph, matrix, r, j, s)
                if rotations is not None:
                    return rotations
    return [matrix]


def _three_rotations(graph: Graph, matrix: Matrix, k: int, j: int, i: int) -> list[Matrix] | None:
    """Return rotations about the axes i, j and k in this order; None if they do not exist.

    Rotations about k leave the row k unchanged, those about i the column i: these are a row and a
    column of the rotation about j, rotated by the others.
    """
    g = graph
    angle = g.args[g.scaled(matrix[k][i])[1]][0]
    c, s = g.call("cos", angle), g.call("sin", angle)
    middle = axis_rotation(g, j, c, s)
    if middle[k][i] != matrix[k][i] and i != k:
        middle = axis_rotation(g, j, c, g.neg(s))
    if middle[k][i] != matrix[k][i]:
        return None
    # The other axes of the planes of rotation.
    first_plane = k if i != k else 3 - i - j
    last_plane = i if i != k else 3 - k - j
    first = _plane(g, i, first_plane, [g.div(n, middle[k][first_plane]) for n in matrix[k]])
    last = _plane(g, k, last_plane, [g.div(row[i], middle[last_plane][i]) for row in matrix])
    if first is None or last is None:
        return None
    last = transposed(last)
    rotations = [m for m in (first, middle, last) if any(m[n][n] != g.one for n in range(3))]
    combined = rotations[0]
    for m in rotations[1:]:
        combined = transposed([product(g, m, column) for column in transposed(combined)])
    values = signatures(g, [n for m in (matrix, combined) for n in flat(m)])
    return rotations if len(rotations) > 1 and values[:9] == values[9:] else None


def _plane(graph: Graph, axis: int, column: int, row: list[int]) -> Matrix | None:
    """Return the rotation about an axis with a given row; None if it is not of one angle."""
    g, third = graph, 3 - axis - column
    c, s = row[column], row[third]
    first, second = g.scaled(c), g.scaled(s)
    if {g.ops[first[1]], g.ops[second[1]]} != {"cos", "sin"} or g.args[first[1]] != g.args[
        second[1]
    ]:
        if (c, s) != (g.one, g.zero):
            return None
    elif abs(first[0]) != 1.0 or abs(second[0]) != 1.0:
        return None
    return axis_rotation(g, axis, c, s if third == (column + 1) % 3 else g.neg(s))


@dataclass(frozen=True)
class PlaneRotation:
    """A plane rotation that maps two anchors to two others, up to signs."""

    # The others, ordered so that the derivative of the first by the first is the cosine.
    columns: tuple[int, int]
    signs: tuple[float, float]  # of the columns: with these the rows are (c, s) and sign · (−s, c)
    sign: float
    cosine: int
    sine: int

    def transform(
        self, graph: Graph, block: Sequence[Sequence[int]], right: PlaneRotation
    ) -> list[list[int]]:
        """Return Rᵀ K R for a block of the form; the right R is that of another rotation."""

        def signed(node: int, sign: float) -> int:
            return node if sign > 0.0 else graph.neg(node)

        upper, lower = block
        k11, k12 = upper[0], signed(upper[1], right.sign)
        k21, k22 = signed(lower[0], self.sign), signed(lower[1], self.sign * right.sign)
        c, s = self.cosine, self.sine
        p = graph.sub(graph.mul(c, graph.sub(k11, k22)), graph.mul(s, graph.add(k12, k21)))
        cosine_part, sine_part = graph.mul(c, p), graph.mul(s, p)
        image = [
            [graph.add(k22, cosine_part), graph.add(k12, sine_part)],
            [graph.add(k21, sine_part), graph.sub(k11, cosine_part)],
        ]
        return [
            [
                signed(n, left_sign * right_sign)
                for n, right_sign in zip(row, right.signs, strict=True)
            ]
            for row, left_sign in zip(image, self.signs, strict=True)
        ]


def plane_rotation_of(
    graph: Graph, rows: Mapping[int, dict[int, int]], pair: Sequence[int]
) -> PlaneRotation | None:
    """Return the plane rotation that maps two anchors to two others, or None."""
    if len(pair) != 2:
        return None
    first, second = rows[pair[0]], rows[pair[1]]
    if len(first) != 2 or first.keys() != second.keys():
        return None
    parts = _by_numbers(graph, first) or _by_an_angle(graph, first)
    if parts is None:
        return None
    (x, first_sign, c), (y, second_sign, s) = parts
    for sign in (1.0, -1.0):
        if second[x] == graph.sum([(s, -sign * first_sign)]) and second[y] == graph.sum(
            [(c, sign * second_sign)]
        ):
            return PlaneRotation((x, y), (first_sign, second_sign), sign, c, s)
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


def merged_rotations(
    graph: Graph, order: Sequence[list[int]], rows: Mapping[int, dict[int, int]]
) -> list[list[int]]:
    """Merge pairs with the same rotation: the two velocities of a body."""
    groups: list[list[int]] = []
    open_turns: dict[tuple[int, int], int] = {}
    for group in order:
        turn = plane_rotation_of(graph, rows, group)
        key = turn and (turn.cosine, turn.sine)
        earlier = open_turns.pop(key, None) if key else None
        if earlier is not None:
            # Postpone the earlier pair, unless it depends on anchors in between.
            first = groups[earlier]
            later_anchors = {k for later in [*groups[earlier + 1 :], group] for k in later}
            if not later_anchors & {c for k in first for c in rows[k]}:
                group = [*first, *group]
                groups[earlier] = []
                key = None
        if key:
            open_turns[key] = len(groups)
        groups.append(group)
    return [group for group in groups if group]
