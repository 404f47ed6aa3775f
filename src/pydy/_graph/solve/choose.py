"""How linear systems are solved: two ordered lists of strategies.

Before equations of motion are simplified, other unknowns may make them shorter (`UNKNOWNS`). When
they are lowered, whatever factorises the matrix for fewest operations does (`FACTORISATIONS`).
"""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from typing import Any

from pydy._graph.node import Graph
from pydy._graph.program import Tape
from pydy._graph.solve import ldl, lu, semiseparable
from pydy._graph.solve.differences import difference_basis
from pydy._graph.solve.matrix import Factor, Matrix, Proposal, symmetric


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


# Takes a graph, a symmetric matrix and a column; gives None or a system with `matrix`, `column` and
# `given_unknowns(solution)`.
_Change = Callable[[Graph, Sequence[Sequence[int]], Sequence[int]], Any]

UNKNOWNS: list[tuple[str, _Change]] = [
    ("differences", difference_basis),
]
"""Names (switches in `Passes`) and changes of unknowns: the first that is offered is taken."""

FACTORISATIONS: list[tuple[str, Callable[[Matrix], Proposal | None]]] = [
    ("semiseparable", semiseparable.propose),
    ("ldl", ldl.propose),
    ("lu", lu.propose),
]
"""Names and strategies; the cheapest proposal is taken, and a loop where there is none."""


def solve_accelerations(
    graph: Graph,
    rows: list[list[int]],
    forcing: list[int],
    kind: str,
    passes: Container[str],
) -> list[int]:
    """Return the solution of the equations of motion ``M u' = F``."""
    for name, change in UNKNOWNS if kind == "ldl" else ():
        if name in passes and (found := change(graph, rows, forcing)) is not None:
            solution = graph.solve(found.matrix, [found.column], kind, judged=True)[0]
            unknowns: list[int] = found.given_unknowns(solution)
            return unknowns
    return graph.solve(rows, [forcing], kind, judged=True)[0]


def factorised(matrix: Matrix, passes: Container[str]) -> Factor:
    """Factorise a matrix in the way that takes fewest operations."""
    proposals = [propose(matrix) for name, propose in FACTORISATIONS if name in passes]
    found = [proposal for proposal in proposals if proposal is not None]
    if not found:
        return LoopFactor(matrix)
    return min(found, key=lambda proposal: proposal[0])[1]()
