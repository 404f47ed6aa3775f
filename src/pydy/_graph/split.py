"""One direction's derivatives apart from what all directions share.

A Program of a function and of its derivative along one direction becomes two. The first computes
the function and every value that the derivative needs, once. The second is linear in the direction:
a back end runs it for several directions side by side, with the shared values spread over all.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from dataclasses import dataclass

import numpy as np

from pydy._forks import cached_property
from pydy._graph.operations import TRUTHS, operands, with_operands
from pydy._graph.program import Block, Program, Tape

__all__ = ["SplitProgram", "split"]


@dataclass(frozen=True, eq=False)
class SplitProgram:
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
    def num_specifieds(self) -> int:
        """Number of inputs r."""
        return self.shared.num_specifieds

    @property
    def num_constants(self) -> int:
        """Number of constants p."""
        return self.shared.num_constants

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
        parts = (self.shared.digest, self.column.digest, repr(self.directions.tolist()))
        return hashlib.sha256("".join(parts).encode()).hexdigest()

    @property
    def operation_count(self) -> dict[str, Counter[str]]:
        """Operations of both, those of the second once for all columns side by side."""
        one, other = self.shared.operation_count, self.column.operation_count
        return {stage: one[stage] + other[stage] for stage in one}

    def __str__(self) -> str:
        return f"{self.shared}\n\nFor each of {self.columns} columns:\n{self.column}"


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
    limits = {"x": states, "p": constants}
    own: set[int] = set()  # what changes with the direction
    for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        if op == "input":
            if args[1] >= limits.get(args[0], args[1] + 1):
                own.add(k)
        elif not own.isdisjoint(operands(op, args)):
            own.add(k)
    whole, part = Tape(), Tape()
    whole.ops, whole.args = list(program.ops), list(program.args)
    whole.constant = list(program.setup)
    shared: dict[int, int] = {}  # nodes of `whole` to their places
    new: dict[int, int] = {}  # nodes of `whole` to nodes of `part`

    def spread(node: int) -> int:
        """Return a shared value as a node of `part`."""
        if node not in new:
            op, args = whole.ops[node], whole.args[node]
            if op in ("const", "bool"):
                new[node] = part.make(op, *args)
            elif op == "factor":
                new[node] = part.make(op, args[0], args[1], tuple(map(spread, args[2])))
            else:
                place = part.make("input", "r", shared.setdefault(node, len(shared)))
                truth = op in TRUTHS
                new[node] = part.make("ne", place, part.const(0.0)) if truth else place
        return new[node]

    for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        if k not in own:
            continue
        if op == "input":
            new[k] = part.make(op, args[0], args[1] - limits[args[0]])
            continue
        for other in operands(op, args):
            if other not in own:
                spread(other)
        new[k] = part.make(op, *with_operands(op, args, new))
    rates, column = (
        program.outputs[block.start : block.stop]
        for block in (program.block("rates"), program.block("column"))
    )
    cells = [new[k] if k in own else spread(k) for k in column]
    sizes = (states, program.num_specifieds, constants)
    first = Program.from_tape(
        whole, sizes, [("rates", (len(rates),), rates), ("shared", (len(shared),), [*shared])]
    )
    own_sizes = (program.num_states - states, len(shared), program.num_constants - constants)
    return first, Program.from_tape(part, own_sizes, [("column", (len(cells),), cells)])
