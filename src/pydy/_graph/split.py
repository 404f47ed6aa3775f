"""One direction's derivatives apart from what all directions share.

A Program of a function and of its derivative along one direction becomes two. The first computes
the function and every value that the derivative needs, once. The second is linear in the direction:
a back end runs it for several directions side by side, with the shared values spread over all.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pydy._forks import cached_property
from pydy._graph.operations import TRUTHS, operands, with_operands
from pydy._graph.program import Block, Program, Tape

__all__ = ["Parting", "SplitProgram", "TakesApart", "split"]


class TakesApart:
    """The inputs of what is taken apart: they are those of the shared part."""

    shared: Program

    @property
    def num_specifieds(self) -> int:
        """Number of specifieds r."""
        return self.shared.num_specifieds

    @property
    def num_constants(self) -> int:
        """Number of constants p."""
        return self.shared.num_constants


@dataclass(frozen=True, eq=False)
class SplitProgram(TakesApart):
    """The derivatives of states and of their sensitivities, apart; see `columns.Columns`.

    It has those attributes of a Program that say what goes in and what comes out.

    Attributes
    ----------
    shared : Program
        Blocks 'rates', the derivatives of the states, and 'shared'.
    column : Program
        The derivatives of one column: x are its sensitivities, r the shared values, and p its
        direction in the inputs.
    directions : ndarray, shape (d, K)
        p of each column.
    """

    shared: Program
    column: Program
    directions: np.ndarray

    @property
    def columns(self) -> int:
        """Number of columns, K."""
        number: int = self.directions.shape[1]
        return number

    @property
    def num_states(self) -> int:
        """Number of states and sensitivities."""
        number: int = self.shared.num_states * (1 + self.columns)
        return number

    @property
    def carried(self) -> range:
        """What the setup stage leaves for the run stage, in number."""
        return range(len(self.shared.carried) + self.columns * len(self.column.carried))

    @property
    def outputs(self) -> range:
        """The outputs, in number."""
        return range(self.num_states)

    @property
    def ops(self) -> tuple[str, ...]:
        """The operations of both."""
        return (*self.shared.ops, *self.column.ops)

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The one block of outputs."""
        return (Block("rates", (self.num_states,), 0, self.num_states),)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of everything that decides what is computed."""
        # The shape too: by initial conditions alone there are no rows, however many columns.
        directions = self.directions.shape, self.directions.tolist()
        parts = (self.shared.digest, self.column.digest, repr(directions))
        return hashlib.sha256("".join(parts).encode()).hexdigest()

    @property
    def operation_count(self) -> dict[str, Counter[str]]:
        """Operations of both, those of the second once for all columns side by side."""
        one, other = self.shared.operation_count, self.column.operation_count
        return {stage: one[stage] + other[stage] for stage in one}

    def __str__(self) -> str:
        return f"{self.shared}\n\nFor each of {self.columns} columns:\n{self.column}"


class Parting:
    """Takes a Program that is linear in some of its inputs apart.

    Parameters
    ----------
    program : Program
    """

    def __init__(self, program: Program) -> None:
        self._program = program
        self._whole = Tape()
        self._whole.ops, self._whole.args = list(program.ops), list(program.args)
        self._whole.constant = list(program.setup)
        self._places: dict[int, int] = {}  # of shared values
        self._behind = {k: guard for guard, nodes in program.fallback.items() for k in nodes}

    def part(
        self, own: Mapping[tuple[str, int], int], outputs: Sequence[int], sizes: tuple[int, int]
    ) -> Program:
        """Return the Program of some outputs that takes shared values as its inputs r.

        Parameters
        ----------
        own : mapping of (group, index) to index
            The inputs that the part keeps; what depends on none of them is shared. Nothing depends
            on inputs of several parts.
        outputs : sequence of nodes
        sizes : (int, int)
            Numbers of the part's inputs x and p.
        """
        program, whole, places = self._program, self._whole, self._places
        part = Tape()
        new: dict[int, int] = {}  # nodes of the whole to nodes of the part

        def spread(node: int) -> int:
            """Return a shared value as a node of the part."""
            if node not in new:
                op, args = whole.ops[node], whole.args[node]
                if op in ("const", "bool"):
                    new[node] = part.make(op, *args)
                elif op == "factor":
                    new[node] = part.make(op, args[0], args[1], tuple(map(spread, args[2])))
                else:
                    place = part.make("input", "r", places.setdefault(node, len(places)))
                    truth = op in TRUTHS
                    new[node] = part.make("ne", place, part.const(0.0)) if truth else place
            return new[node]

        moved: set[int] = set()  # what changes with the part's inputs
        for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
            if op == "input":
                if args in own:
                    moved.add(k)
                    new[k] = part.make(op, args[0], own[args])
                continue
            others = operands(op, args)
            if moved.isdisjoint(others):
                continue
            moved.add(k)
            for other in others:
                if other not in moved:
                    spread(other)
            new[k] = part.make(op, *with_operands(op, args, new))
        cells = [new[k] if k in moved else spread(k) for k in outputs]
        return Program.from_tape(
            part, (sizes[0], len(places), sizes[1]), [("column", (len(cells),), cells)]
        )

    def shared(self, sizes: tuple[int, int, int], *blocks: tuple[str, Sequence[int]]) -> Program:
        """Return the Program of further blocks and of all that the parts so far share."""
        parts = [*blocks, ("shared", self._put_off())]
        return Program.from_tape(
            self._whole, sizes, [(name, (len(nodes),), nodes) for name, nodes in parts]
        )

    def _put_off(self) -> list[int]:
        """Return the shared values; what only fallbacks need is behind guards here too."""
        whole, groups = self._whole, dict[int, list[int]]()
        for node in self._places:
            guard = node
            while guard in self._behind:
                guard = self._behind[guard]
            if guard != node:
                groups.setdefault(whole.args[guard][3], []).append(node)
        new: dict[int, int] = {}
        one, zero = whole.const(1.0), whole.const(0.0)
        for sound, nodes in groups.items():
            numbers = [
                whole.make("select", k, one, zero) if whole.ops[k] in TRUTHS else k for k in nodes
            ]
            made = whole.make("guard", 1, (one,), tuple(numbers), sound, ())
            new.update((k, whole.make("item", made, i)) for i, k in enumerate(nodes))
        return [new.get(node, node) for node in self._places]


def split(program: Program, states: int, constants: int) -> tuple[Program, Program]:
    """Return the Programs of what is shared and of one column.

    Parameters
    ----------
    program : Program
        With the blocks 'rates', which the direction does not change, and 'column', which is linear
        in it.
    states, constants : int
        How many of the inputs x and p come before the direction's.
    """
    own = {("x", k): k - states for k in range(states, program.num_states)}
    own.update({("p", k): k - constants for k in range(constants, program.num_constants)})
    rates, column = (
        program.outputs[block.start : block.stop]
        for block in (program.block("rates"), program.block("column"))
    )
    parting = Parting(program)
    sizes = (program.num_states - states, program.num_constants - constants)
    part = parting.part(own, column, sizes)
    shared = parting.shared((states, program.num_specifieds, constants), ("rates", rates))
    return shared, part
