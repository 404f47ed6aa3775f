"""Derivatives along directions, as Programs: of what these share, and of one direction.

The derivative of f along a direction is linear in it. A `Tangent` is a Program of every value that
all directions need, computed once, and Programs of the derivative along one direction, which a back
end runs for several directions side by side with the shared values spread over all. Unit vectors
give the columns of a Jacobian, the sensitivities S = ∂x/∂θ their derivatives by time, any vectors
products.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pydy._forks import cached_property
from pydy._program.operations import OPERATIONS
from pydy._program.program import Program, Tape
from pydy._program.signature import Signature


@dataclass(frozen=True)
class Part:
    """Columns next to each other."""

    first: int
    count: int
    # One column: x is its seed, r the shared values, p its direction in `Tangent.directions`.
    program: Program


@dataclass(frozen=True, eq=False)
class Tangent:
    """Derivatives along directions, with the attributes of a Program that kernels need."""

    shared: Program  # the values that come first among the outputs, if any, and a block 'shared'
    parts: tuple[Part, ...]  # columns of no part are zero
    shape: tuple[int, int]  # rows and columns of the derivatives
    # (d, columns): the numbers p of each column, whose seed follows the states in x, a matrix row
    # after row. None: seeds are unit vectors of each part's variables.
    directions: np.ndarray | None = None

    @property
    def values(self) -> int:
        """How many outputs come before the derivatives."""
        return self.shared.signature.blocks[-1].start

    @cached_property
    def signature(self) -> Signature:
        """The inputs, with the seeds after the states, and the values and derivatives."""
        n, s, c = self.shared.signature.sizes
        seeds = 0 if self.directions is None else self.parts[0].program.signature.num_states
        blocks = [(b.name, b.shape) for b in self.shared.signature.blocks[:-1]]
        return Signature.of((n + seeds * self.shape[1], s, c), [*blocks, ("jacobian", self.shape)])

    @property
    def num_operations(self) -> int:
        """Number of operations for all columns."""
        parts = (part.count * part.program.num_operations for part in self.parts)
        return self.shared.num_operations + sum(parts)

    @property
    def ops(self) -> tuple[str, ...]:
        """The operations of the shared part and of each other one."""
        return sum((part.program.ops for part in self.parts), self.shared.ops)

    @property
    def carried(self) -> range:
        """An upper bound on the number of values passed from the set-up to the run stage."""
        # Vectors of columns may be filled up: to less than twice as many.
        parts = (2 * part.count * len(part.program.carried) for part in self.parts)
        return range(len(self.shared.carried) + sum(parts))

    @cached_property
    def digest(self) -> str:
        """SHA-256 of everything that determines the results."""
        parts = (f"{p.first} {p.count} {p.program.digest}" for p in self.parts)
        directions = None if self.directions is None else self.directions.tolist()
        text = (self.shared.digest, *parts, repr(self.shape), repr(directions))
        return hashlib.sha256(" ".join(text).encode()).hexdigest()

    @property
    def operation_count(self) -> dict[str, Counter[str]]:
        """Operations by kind; a part counts once for every column."""
        counts = {
            stage: stage_counts.copy()
            for stage, stage_counts in self.shared.operation_count.items()
        }
        for part in self.parts:
            for stage, stage_counts in part.program.operation_count.items():
                for op, number in stage_counts.items():
                    counts[stage][op] += number * part.count
        return counts

    def written_out(self) -> Program:
        """Return the Program of all columns in turn.

        It is for back ends that do not take Tangents, and for samples in which an infinite
        derivative must not spoil other columns.
        """
        tape, n = Tape(), self.shared.signature.num_states
        values = _copied(tape, self.shared, {})
        zero = tape.const(0.0)
        cells = [[zero] * self.shape[1] for _ in range(self.shape[0])]
        for part in self.parts:
            shared = {("r", k): node for k, node in enumerate(values[self.values :])}
            for j in range(part.count):
                column, size = part.first + j, part.program.signature.num_states
                if self.directions is None:
                    inputs = {("x", i): tape.const(float(i == j)) for i in range(size)}
                else:
                    positions = (n + i * self.shape[1] + column for i in range(size))
                    inputs = {("x", i): tape.make("input", "x", k) for i, k in enumerate(positions)}
                    numbers = enumerate(self.directions[:, column])
                    inputs.update({("p", i): tape.const(number) for i, number in numbers})
                outputs = _copied(tape, part.program, shared | inputs)
                for row, node in zip(cells, outputs, strict=True):
                    row[column] = node
        first = self.shared.signature.blocks[:-1]
        blocks = [(b.name, b.shape, values[b.start : b.stop]) for b in first]
        blocks.append(("jacobian", self.shape, [node for row in cells for node in row]))
        return Program.from_tape(tape, self.signature.sizes, blocks)

    def __str__(self) -> str:
        texts = [str(self.shared)]
        for part in self.parts:
            last = part.first + part.count - 1
            texts.append(f"For each of the columns {part.first} to {last}:\n{part.program}")
        return "\n\n".join(texts)


def _copied(tape: Tape, program: Program, inputs: Mapping[tuple[str, int], int]) -> list[int]:
    """Write a Program on a tape, with nodes in place of some inputs; return its outputs."""
    new: dict[int, int] = {}
    behind = {k: guard for guard, nodes in program.fallback.items() for k in nodes}
    for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        tape.guard_of_fallback = behind.get(k)
        tape.in_every_call = k not in behind
        if op == "input":
            new[k] = inputs[args] if args in inputs else tape.make(op, *args)
        elif op == "const":
            new[k] = tape.const(*args)
        elif op in ("add", "sub", "mul", "div", "neg"):
            new[k] = getattr(tape, op)(*(new[n] for n in args))
        else:
            new[k] = tape.make(op, *OPERATIONS.with_operands(op, args, new))
    tape.guard_of_fallback, tape.in_every_call = None, True
    unit, zero = tape.const(1.0), tape.const(0.0)
    nodes = [new[k] for k in program.outputs]
    return [
        tape.make("select", k, unit, zero) if tape.ops[k] in OPERATIONS.truths else k for k in nodes
    ]
