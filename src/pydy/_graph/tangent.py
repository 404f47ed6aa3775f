"""Derivatives along directions: what these share, apart from the code of one of them.

The derivative of f along a direction is linear in it. A `Tangent` is a Program of every value that
all directions need, computed once, and Programs of the derivative along one direction, which a back
end runs for several directions side by side with the shared values spread over all. Unit vectors
give the columns of a Jacobian, the sensitivities S = ∂x/∂θ their derivatives by time, any vectors
products.

Written out, all columns of a Jacobian make a Program that grows with their number: its code is slow
to compile and does not fit the processor's caches. Columns that depend on much the same make a part
of it, with a Program of its own.
"""

from __future__ import annotations

import hashlib
import marshal
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import or_
from typing import NamedTuple

import numpy as np

from pydy._forks import cached_property
from pydy._graph.collector import collector_paused
from pydy._graph.derivative import Rows
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.operations import OPERATIONS, TRUTHS, operands, with_operands
from pydy._graph.passes.factor import factor_sums
from pydy._graph.program import Block, Program, Tape
from pydy._graph.tuning import ANOTHER_PART, COLUMNS_TOGETHER, FROM_OPERATIONS, LESS_WORK

_MARK = b"tangent"


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
        return self.shared.blocks[-1].start

    @property
    def num_states(self) -> int:
        """Number of states x, with the seeds."""
        seeds = 0 if self.directions is None else self.parts[0].program.num_states
        return self.shared.num_states + seeds * self.shape[1]

    @property
    def num_specifieds(self) -> int:
        """Number of specifieds r."""
        return self.shared.num_specifieds

    @property
    def num_constants(self) -> int:
        """Number of constants p."""
        return self.shared.num_constants

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

    @property
    def outputs(self) -> range:
        """The outputs, in number."""
        return range(self.values + self.shape[0] * self.shape[1])

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The values, and the derivatives."""
        columns = Block("jacobian", self.shape, self.values, len(self.outputs))
        return (*self.shared.blocks[:-1], columns)

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
        counts = {stage: own.copy() for stage, own in self.shared.operation_count.items()}
        for part in self.parts:
            for stage, own in part.program.operation_count.items():
                for op, number in own.items():
                    counts[stage][op] += number * part.count
        return counts

    def written_out(self) -> Program:
        """Return the Program of all columns in turn, for back ends that do not take Tangents."""
        tape, n = Tape(), self.shared.num_states
        values = _copied(tape, self.shared, {})
        zero = tape.const(0.0)
        cells = [[zero] * self.shape[1] for _ in range(self.shape[0])]
        for part in self.parts:
            shared = {("r", k): node for k, node in enumerate(values[self.values :])}
            for j in range(part.count):
                column, size = part.first + j, part.program.num_states
                if self.directions is None:
                    given = {("x", i): tape.const(float(i == j)) for i in range(size)}
                else:
                    places = (n + i * self.shape[1] + column for i in range(size))
                    given = {("x", i): tape.make("input", "x", k) for i, k in enumerate(places)}
                    numbers = enumerate(self.directions[:, column])
                    given.update({("p", i): tape.const(number) for i, number in numbers})
                outputs = _copied(tape, part.program, shared | given)
                for row, node in zip(cells, outputs, strict=True):
                    row[column] = node
        sizes = (self.num_states, self.num_specifieds, self.num_constants)
        blocks = [(b.name, b.shape, values[b.start : b.stop]) for b in self.shared.blocks[:-1]]
        blocks.append(("jacobian", self.shape, [node for row in cells for node in row]))
        return Program.from_tape(tape, sizes, blocks)

    def to_bytes(self) -> bytes:
        """Return the Tangent as bytes, for this version of Python."""
        parts = tuple((part.first, part.count, part.program.to_bytes()) for part in self.parts)
        table = self.directions
        directions = None if table is None else (table.shape, table.tobytes())
        return _MARK + marshal.dumps((self.shared.to_bytes(), parts, self.shape, directions))

    @classmethod
    def from_bytes(cls, data: bytes) -> Tangent:
        """Return the Tangent that `to_bytes` wrote."""
        shared, parts, shape, table = marshal.loads(data[len(_MARK) :])
        made = tuple(Part(first, count, Program.from_bytes(one)) for first, count, one in parts)
        directions = None if table is None else np.frombuffer(table[1]).reshape(table[0])
        return cls(Program.from_bytes(shared), made, shape, directions)

    def __str__(self) -> str:
        texts = [str(self.shared)]
        for part in self.parts:
            last = part.first + part.count - 1
            texts.append(f"For each of the columns {part.first} to {last}:\n{part.program}")
        return "\n\n".join(texts)


def program_from_bytes(data: bytes) -> Program | Tangent:
    """Return the Program or Tangent whose `to_bytes` wrote this."""
    return (Tangent if data.startswith(_MARK) else Program).from_bytes(data)


def _copied(tape: Tape, program: Program, given: Mapping[tuple[str, int], int]) -> list[int]:
    """Write a Program on a tape, with nodes in place of some inputs; return its outputs."""
    new: dict[int, int] = {}
    behind = {k: guard for guard, nodes in program.fallback.items() for k in nodes}
    for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        tape.behind = behind.get(k)
        tape.called = k not in behind
        if op == "input":
            new[k] = given[args] if args in given else tape.make(op, *args)
        elif op == "const":
            new[k] = tape.const(*args)
        elif op in ("add", "sub", "mul", "div", "neg"):
            new[k] = getattr(tape, op)(*(new[n] for n in args))
        else:
            new[k] = tape.make(op, *with_operands(op, args, new))
    tape.behind, tape.called = None, True
    one, zero = tape.const(1.0), tape.const(0.0)
    nodes = [new[k] for k in program.outputs]
    return [tape.make("select", k, one, zero) if tape.ops[k] in TRUTHS else k for k in nodes]


# -- One direction apart from what all share -------------------------------------------------------


class Along(NamedTuple):
    """The directions of a part."""

    first: int  # its columns
    stop: int
    along: dict[int, int]  # from variables to their derivatives, made of inputs of its own
    own: dict[tuple[str, int], int]  # these inputs, and their places in the part
    sizes: tuple[int, int]  # how many of them are x and p there


def tangent(
    graph: Graph,
    outputs: Sequence[int],
    wanted: Iterable[Along],
    sizes: tuple[tuple[int, int, int], tuple[int, int, int]],
    columns: int,
    directions: np.ndarray | None = None,
    values: str = "",
) -> Tangent:
    """Return the derivatives of simplified nodes along directions.

    The `sizes` are numbers of states, specifieds and constants: those of the equations, and with
    the inputs of directions after them. With a name for the `values` of the nodes these come first.
    """
    (n, _, c), whole = sizes
    m, parts = len(outputs), list[Along]()
    with collector_paused():
        cells: list[int] = []
        for part in wanted:  # one by one, so that nothing belongs to two of them
            parts.append(part)
            rows = Rows(graph, {node: {0: seed} for node, seed in part.along.items()})
            cells += [rows(node).get(0, graph.zero) for node in outputs]
        cells = cells if "factor" in graph.off else factor_sums(graph, cells)
        blocks = [(str(k), (m,), cells[k * m : (k + 1) * m]) for k in range(len(parts))]
        first = [(values, (m,), [*outputs])] if values else []
        lowered = lower(graph, whole, [*first, *blocks], own=sizes[0])
        found = [(b.name, lowered.outputs[b.start : b.stop]) for b in lowered.blocks]
        parting = _Parting(lowered)
        made = []
        for part, (_, column) in zip(parts, found[len(first) :], strict=True):
            one = parting.part(part.own, column, part.sizes)
            made.append(Part(part.first, part.stop - part.first, one))
        shared = parting.shared((n, whole[1], c), *found[: len(first)])
        return Tangent(shared, tuple(made), (m, columns), directions)


class _Parting:
    """Takes a Program that is linear in some of its inputs apart."""

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

        Of inputs it keeps its `own`, of these sizes: what depends on none of them is shared.
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
        """Return the shared values; values for fallbacks alone stay behind guards."""
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


# -- Jacobians: which columns make a part ----------------------------------------------------------


def jacobian_tangent(
    graph: Graph,
    outputs: Sequence[int],
    variables: Sequence[tuple[str, int]],
    sizes: tuple[int, int, int],
    parts: Sequence[tuple[int, int]],
) -> Tangent:
    """Return the Jacobian of simplified nodes in parts, see `parts_of`."""
    n, s, c = sizes

    def wanted() -> Iterator[Along]:
        for first, stop in parts:
            along: dict[int, int] = {}
            for j in range(first, stop):  # a variable may have several columns
                node, seed = graph.input(*variables[j]), graph.input("x", n + j)
                along[node] = graph.add(along.get(node, graph.zero), seed)
            own = {("x", n + j): j - first for j in range(first, stop)}
            yield Along(first, stop, along, own, (stop - first, 0))

    whole = (n + len(variables), s, c)
    return tangent(graph, outputs, wanted(), (sizes, whole), len(variables))


def supports(graph: Graph, outputs: Sequence[int], by: Sequence[int]) -> Counter[int]:
    """Count the operations of a derivative by inputs, by the set of columns that execute them.

    Bit k stands for column k. Columns of no operation are zero.
    """
    bits: dict[int, int] = {}
    for k, node in enumerate(by):
        bits[node] = bits.get(node, 0) | 1 << k
    cost: Counter[int] = Counter()
    never = graph.boolean(False)

    def paid(nodes: Iterable[int]) -> int:
        """Count an operation for each of some operands that moves; return who pays."""
        every = 0
        for node in nodes:
            own = bits[node]
            if own:
                cost[own] += 1
                every |= own
        return every

    for node in graph.reachable(outputs, fallbacks=False):
        op, args = graph.ops[node], graph.args[node]
        if node in bits:  # one of the variables
            continue
        if op == "item":
            vector, k = args
            if graph.ops[vector] == "guard" and graph.args[vector][3] != never:
                vector = graph.args[vector][4][k]
            bits[node] = bits[vector]
        elif op == "solve" or (op == "guard" and args[3] == never):
            # Ȧ x, and a solve with the factors that there are; see `pydy._graph.derivative`.
            (_, n, entries), column = (
                (graph.args[args[0]], args[1]) if op == "solve" else (("", *args[:2]), args[2])
            )
            bits[node] = paid((*entries, *column))
            cost[bits[node]] += n * n
        else:
            row = OPERATIONS.get(op)
            moves = op in ("sum", "prod", "select") or (row is not None and row.partials)
            bits[node] = paid(graph.operands(node)) if moves else 0
    del cost[0]
    # An output that is a variable itself takes no operation, but its column is not zero.
    known = _union(cost)
    for node in outputs:
        if bits[node] & ~known:
            cost[bits[node]] += 1
            known |= bits[node]
    return cost


def _union(cost: Iterable[int]) -> int:
    """Return the columns that execute anything."""
    return reduce(or_, cost, 0)


def worthwhile_parts(
    graph: Graph, outputs: Sequence[int], by: Sequence[int]
) -> list[tuple[int, int]]:
    """Return the parts of a Jacobian, see `parts_of`; none where it is small or sparse."""
    cost = supports(graph, outputs, by)
    whole = sum(own.bit_count() * operations for own, operations in cost.items())
    if whole < FROM_OPERATIONS or len(by) < COLUMNS_TOGETHER:
        return []
    parts = parts_of(cost, len(by))
    vectors = sum(_turns(b - a) * _within(cost, a, b).total() for a, b in parts)
    return parts if vectors * LESS_WORK < whole else []


def parts_of(cost: Counter[int], columns: int) -> list[tuple[int, int]]:
    """Return which columns, from first to last, have a Program of their own.

    A part is divided where its columns then execute so much less that it pays for the further code.
    """
    union = _union(cost)
    if not union:
        return []
    first, stop = (union & -union).bit_length() - 1, union.bit_length()
    # Whole vectors: with columns of zeros beside them if need be.
    stop = min(max(stop, first + COLUMNS_TOGETHER), columns)
    first = max(min(first, stop - COLUMNS_TOGETHER), 0)
    return _divided(cost, first, stop)


def _turns(columns: int) -> int:
    """Return how often the code of a part is run."""
    return -(-columns // COLUMNS_TOGETHER)


def _within(cost: Counter[int], first: int, stop: int) -> Counter[int]:
    """Return the operations that some of the columns execute."""
    mask = (1 << stop) - (1 << first)
    own: Counter[int] = Counter()
    for bits, operations in cost.items():
        if bits & mask:
            own[bits & mask] += operations
    return own


def _divided(cost: Counter[int], first: int, stop: int) -> list[tuple[int, int]]:
    width = stop - first
    left, right = [0] * (width + 1), [0] * (width + 1)
    for own, operations in cost.items():
        low, high = (own & -own).bit_length() - 1 - first, own.bit_length() - 1 - first
        left[low + 1] += operations  # executed left of a cut that is above the lowest column
        right[high] += operations  # executed right of one that is not above the highest
    for k in range(width):
        left[k + 1] += left[k]
        right[width - k - 1] += right[width - k]

    def price(cut: int) -> float:
        sides = (cut, left[cut]), (width - cut, right[cut])
        return sum((_turns(columns) + ANOTHER_PART) * work for columns, work in sides if columns)

    cuts = range(COLUMNS_TOGETHER, width - COLUMNS_TOGETHER + 1)
    best = min((width, *cuts), key=price)
    if best == width:
        return [(first, stop)]
    sides = ((first, first + best), (first + best, stop))
    parts = [(a, b, _within(cost, a, b)) for a, b in sides]
    return [found for a, b, own in parts if own for found in _divided(own, a, b)]
