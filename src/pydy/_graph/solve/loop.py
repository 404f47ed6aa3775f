"""A factorisation in a loop of the back end, for matrices that are too large to write out."""

from __future__ import annotations

from pydy._graph.program import Tape
from pydy._graph.solve.matrix import Matrix, symmetric


class LoopFactor:
    """A factorisation that the back end does in a loop."""

    def __init__(self, matrix: Matrix) -> None:
        self.tape: Tape = matrix.tape
        lower = matrix.kind == "ldl"
        cells = symmetric(matrix.n, matrix.cells) if lower else matrix.cells
        self.node = self.tape.make("factor", matrix.kind, matrix.n, tuple(cells))

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""
        return self.tape.make("solve", self.node, tuple(column))
