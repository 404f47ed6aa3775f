"""A linear system's matrix, as the strategies that factorise it see it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from pydy._graph.node import Graph
from pydy._graph.program import Tape

Part = tuple[tuple[int, int], ...]
"""A product of powers of nodes of a graph."""


class Factor(Protocol):
    """A matrix that is factorised."""

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""


Proposal = tuple[int, Callable[[], Factor]]
"""The multiply-adds of the factorisation and one solve, and what writes it."""


@dataclass(frozen=True)
class Matrix:
    """A square matrix."""

    tape: Tape  # receives the operations
    # 'ldl': symmetric and positive definite, of which the lower triangle is read; or 'lu': any
    kind: str
    n: int
    cells: list[int]  # the entries on the tape, row by row
    graph: Graph
    entries: Sequence[int]  # the same in the graph
    sizes: tuple[int, int, int]  # of the Program
    # writes a sum of products of nodes of the graph on the tape, given ``{part: coefficient}``
    value: Callable[[dict[Part, float]], int]

    @cached_property
    def filled(self) -> np.ndarray:
        """Which entries are not structurally zero."""
        cells = symmetric(self.n, self.cells) if self.kind == "ldl" else self.cells
        filled: np.ndarray = np.array(cells).reshape(self.n, self.n) != self.tape.const(0.0)
        return filled

    @cached_property
    def fixed(self) -> np.ndarray:
        """Which entries depend on constants alone."""
        return np.array([self.tape.constant[c] for c in self.cells]).reshape(self.n, self.n)


def symmetric(n: int, entries: list[int]) -> list[int]:
    """Return the matrix that the lower triangle stands for, whatever the upper one holds."""
    rows = ((entries[i * n : i * n + i], entries[i * n + i :: n]) for i in range(n))
    return [entry for before, below in rows for entry in (*before, *below)]
