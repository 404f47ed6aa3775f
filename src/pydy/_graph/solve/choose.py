"""How linear systems are solved when they are lowered.

The factorisation of a matrix is written out where that is short, and else left to a loop.
"""

from __future__ import annotations

from collections.abc import Container
from typing import Protocol

from pydy._graph.solve import ldl, lu
from pydy._program import Tape, symmetric


class Factor(Protocol):
    """A matrix that is factorised."""

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""


class LoopFactor:
    """A factorisation that the back end does in a loop."""

    def __init__(self, tape: Tape, kind: str, n: int, entries: list[int]) -> None:
        self.tape = tape
        cells = symmetric(n, entries) if kind == "ldl" else entries
        self.node = tape.make("factor", kind, n, tuple(cells))

    def solve(self, column: list[int]) -> int:
        """Return the vector node of the solution."""
        return self.tape.make("solve", self.node, tuple(column))


def factorised(
    tape: Tape,
    kind: str,
    n: int,
    entries: list[int],
    sizes: tuple[int, int, int],
    off: Container[str],
) -> Factor:
    """Factorise a matrix of nodes of a tape, of the kind that `LinearSystem` describes.

    Its pivots are chosen at generic inputs of these sizes; a kind that is `off` is not written out.
    """
    factor: Factor | None = None
    if kind not in off and kind == "ldl":
        factor = ldl.unrolled(tape, n, entries)
    elif kind not in off:
        factor = lu.unrolled(tape, n, entries, sizes)
    return factor or LoopFactor(tape, kind, n, entries)
