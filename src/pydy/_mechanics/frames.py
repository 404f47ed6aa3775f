"""Frames as the equations see them: between them there may be axes that the user did not name."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, SymPyReader, signatures
from pydy._mechanics.components import identity, numbers_of, turned, unrounded
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.planes import plane_rotations
from pydy._mechanics.reader import InputReader
from pydy._rank import ROUNDED

Vec = list[int]


class Frames:
    """The tree of frames, with axes put between them (`pydy._mechanics.alignment`).

    Axes are put `above` others, beside which they turn as fast as `turns` tells (None: they are
    fixed). A frame's components are `written` in axes, by a matrix or as they are; `steps` are
    matrices that give components in a frame from those in its parent.
    """

    def __init__(self, graph: Graph, tree: FrameTree, read: InputReader) -> None:
        self.graph, self.tree, self.read = graph, tree, read
        self.above: dict[Any, Any] = {}
        self.turns: dict[Any, Vec | None] = {}
        self.written: dict[Any, tuple[Any, list[Vec] | None]] = {}
        self.steps: dict[Any, list[Vec]] = {}
        self._planes: dict[Any, list[list[Vec]]] = {}

    def insert(self, axes: Any, above: Any, step: list[Vec], turns: Vec | None, depth: int) -> None:
        """Add axes after others; `turns` is their angular velocity, None if fixed."""
        self.above[axes], self.steps[axes], self.turns[axes] = above, step, turns
        self.tree.frame_depth[axes] = depth

    def write(self, frame: Any, axes: Any, matrix: list[Vec] | None) -> None:
        """Write components of a frame in other axes that are fixed in it."""
        self.written[frame] = axes, matrix

    def axes(self, frame: Any) -> Any:
        """Return the axes that a frame's components are written in."""
        return self.written.get(frame, (frame, None))[0]

    def written_in(self, frame: Any) -> tuple[Any, list[Vec]]:
        """Return the axes that a frame's components are written in, and the rotation."""
        g = self.graph
        axes, matrix = self.written.get(frame, (frame, None))
        return axes, matrix or identity(g)

    def in_axes(self, v: Vec, frame: Any) -> tuple[Vec, Any]:
        """Return components in a frame as they are written, and the axes."""
        axes, matrix = self.written.get(frame, (frame, None))
        return (v if matrix is None else unrounded(self.graph, turned(self.graph, matrix, v))), axes

    def parent(self, axes: Any) -> Any:
        """Return the axes next to these on the way to the inertial frame, None for that itself."""
        return self.above.get(axes) or self.axes(self.tree.parent(axes))

    def base(self, axes: Any) -> Any:
        """Return the axes in which an angular velocity is given, None for the inertial frame."""
        return self.above.get(axes) or self.axes(self.tree.turns_in(axes))

    def way_in(self, axes: Any) -> list[Any]:
        """Return the axes on the way to the inertial frame, these first."""
        way = [axes]
        while (parent := self.parent(way[-1])) is not None:
            way.append(parent)
        return way

    def is_fixed(self, axes: Any) -> bool:
        """Return whether axes are fixed in those that they were added after."""
        return axes in self.turns and self.turns[axes] is None

    def step(self, axes: Any) -> list[Vec]:
        """Return the matrix from components in the parent to components in some axes."""
        if axes not in self.steps:
            above = self.tree.parent(axes)
            self.steps[axes] = [self.in_axes(row, above)[0] for row in self.given(axes, above)]
        return self.steps[axes]

    def planes(self, axes: Any) -> list[list[Vec]]:
        """Return rotations one after the other that together are the step to axes."""
        if axes not in self._planes:
            self._planes[axes] = plane_rotations(self.graph, self.step(axes))
        return self._planes[axes]

    def given(self, frame: Any, parent: Any) -> list[Vec]:
        """Return the user's matrix from components in the parent to those in a frame."""
        matrix = self.tree.rotation(frame, parent)
        return [self.read.all(matrix.row(i)) for i in range(3)]


def orthogonality_residuals(matrices: Iterable[Any], read: SymPyReader) -> list[int]:
    """Return the entries of Rᵀ R - 1 that do not vanish identically, of all matrices R.

    Those of a quaternion vanish at unit length only, those of angles always. A matrix with
    functions that cannot be read belongs to no body whose motion is computed.
    """
    g, rows = read.graph, []
    for matrix in matrices:
        try:
            nodes = read.all(matrix)
        except UnsupportedFunctionError:
            continue
        columns = [nodes[k::3] for k in range(3)]
        for i, j in combinations_with_replacement(range(3), 2):
            parts = [(g.mul(a, b), 1.0) for a, b in zip(columns[i], columns[j], strict=True)]
            rows.append(g.sum([*parts, (g.one, -1.0 if i == j else 0.0)]))
    # Angles give rotations as functions; a matrix of rounded numbers is one to rounding.
    rows = [row for row, value in zip(rows, signatures(g, rows), strict=True) if value]
    if not rows:
        return []
    apart = np.abs(numbers_of(g, rows)).max(axis=0)
    return [row for row, left in zip(rows, apart, strict=True) if left > ROUNDED]
