"""The frames in which components are expressed, including axes that the user did not define."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING

import numpy as np

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, SymPyReader, signatures
from pydy._mechanics.components import identity, numbers_of, product, unrounded
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.planes import plane_rotations
from pydy._mechanics.reader import InputReader
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import ReferenceFrame

    from pydy._mechanics.frame_tree import AnyFrame

Vec = list[int]


class Frames:
    """The tree of frames, with additional axes between them (`pydy._mechanics.alignment`).

    Additional axes have parents, `above`, and relative angular velocities, `turns` (None: they are
    fixed). Components in a frame of the user are `written` in axes, by a matrix or unchanged;
    `steps` are matrices that give components in axes from those in their parent.
    """

    def __init__(self, graph: Graph, tree: FrameTree, read: InputReader) -> None:
        self.graph, self.tree, self.read = graph, tree, read
        self.above: dict[AnyFrame, AnyFrame] = {}
        self.turns: dict[AnyFrame, Vec | None] = {}
        self.written: dict[ReferenceFrame, tuple[AnyFrame, list[Vec] | None]] = {}
        self.steps: dict[AnyFrame, list[Vec]] = {}
        self._planes: dict[AnyFrame, list[list[Vec]]] = {}

    def insert(
        self, axes: AnyFrame, above: AnyFrame, step: list[Vec], turns: Vec | None, depth: int
    ) -> None:
        """Insert axes below others; `turns` is their angular velocity, None if fixed."""
        self.above[axes], self.steps[axes], self.turns[axes] = above, step, turns
        self.tree.frame_depth[axes] = depth

    def write(self, frame: ReferenceFrame, axes: AnyFrame, matrix: list[Vec] | None) -> None:
        """Express components of a frame in other axes that are fixed in it."""
        self.written[frame] = axes, matrix

    def axes(self, frame: ReferenceFrame | None) -> AnyFrame | None:
        """Return the axes in which the components of a frame are expressed."""
        return self.written.get(frame, (frame, None))[0]

    def written_in(self, frame: ReferenceFrame) -> tuple[AnyFrame, list[Vec]]:
        """Return the axes in which the components of a frame are expressed, and the rotation."""
        g = self.graph
        axes, matrix = self.written.get(frame, (frame, None))
        return axes, matrix or identity(g)

    def in_axes(self, v: Vec, frame: ReferenceFrame) -> tuple[Vec, AnyFrame]:
        """Return components in a frame as expressed in its axes, and the axes."""
        axes, matrix = self.written.get(frame, (frame, None))
        return (
            v if matrix is None else unrounded(self.graph, product(self.graph, matrix, v))
        ), axes

    def parent(self, axes: AnyFrame) -> AnyFrame | None:
        """Return the parent of axes; None for the inertial frame."""
        return self.above.get(axes) or self.axes(self.tree.parent(axes))

    def base(self, axes: AnyFrame) -> AnyFrame | None:
        """Return the axes in which an angular velocity is given, None for the inertial frame."""
        return self.above.get(axes) or self.axes(self.tree.turns_in(axes))

    def path_to_inertial(self, axes: AnyFrame) -> list[AnyFrame]:
        """Return the axes on the path to the inertial frame, these first."""
        path = [axes]
        while (parent := self.parent(path[-1])) is not None:
            path.append(parent)
        return path

    def is_fixed(self, axes: AnyFrame) -> bool:
        """Return whether axes were inserted and are fixed in their parent."""
        return axes in self.turns and self.turns[axes] is None

    def step(self, axes: AnyFrame) -> list[Vec]:
        """Return the matrix from components in the parent to components in axes."""
        if axes not in self.steps:
            above = self.tree.parent(axes)
            self.steps[axes] = [
                self.in_axes(row, above)[0] for row in self.user_rotation(axes, above)
            ]
        return self.steps[axes]

    def planes(self, axes: AnyFrame) -> list[list[Vec]]:
        """Return plane rotations whose product is the step to axes."""
        if axes not in self._planes:
            self._planes[axes] = plane_rotations(self.graph, self.step(axes))
        return self._planes[axes]

    def user_rotation(self, frame: ReferenceFrame, parent: ReferenceFrame) -> list[Vec]:
        """Return the user's matrix from components in the parent to those in a frame."""
        matrix = self.tree.rotation(frame, parent)
        return [self.read.all(matrix.row(i)) for i in range(3)]


def orthogonality_residuals(matrices: Iterable[sm.Matrix], read: SymPyReader) -> list[int]:
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
    largest = np.abs(numbers_of(g, rows)).max(axis=0)
    return [row for row, size in zip(rows, largest, strict=True) if size > ROUNDED]
