"""Jacobians column by column: what all columns share apart from the code of a few of them.

Column j of ∂f/∂v is the derivative of f along v_j. Written out, all columns make a Program that
grows with their number: its code is slow to compile and does not fit the processor's caches. Here
columns that depend on much the same make a part, whose Program is that of the derivative along any
direction of its variables: a back end runs it for several unit vectors side by side.
"""

from __future__ import annotations

import hashlib
import marshal
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import or_

from pydy._forks import cached_property
from pydy._graph.collector import collector_paused
from pydy._graph.derivative import Rows
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.operations import OPERATIONS
from pydy._graph.passes.factor import factor_sums
from pydy._graph.program import Block, Program
from pydy._graph.split import Parting, TakesApart
from pydy._graph.switches import Passes
from pydy._graph.tuning import ANOTHER_PART, COLUMNS_TOGETHER, FROM_OPERATIONS, LESS_WORK

__all__ = [
    "JacobianColumns",
    "Part",
    "columns_program",
    "parts_of",
    "supports",
    "worthwhile_parts",
]


@dataclass(frozen=True)
class Part:
    """Columns next to each other.

    Attributes
    ----------
    first : int
        The first column.
    program : Program
        One column: x is its direction in the part's variables, r the shared values.
    """

    first: int
    program: Program

    @property
    def count(self) -> int:
        """Number of columns."""
        return self.program.num_states


@dataclass(frozen=True, eq=False)
class JacobianColumns(TakesApart):
    """The Jacobian of some nodes, in parts; it has those attributes of a Program that kernels need.

    Attributes
    ----------
    shared : Program
        What all columns need.
    parts : tuple of Part
        Columns of no part are zero.
    shape : (int, int)
    """

    shared: Program
    parts: tuple[Part, ...]
    shape: tuple[int, int]

    @property
    def num_operations(self) -> int:
        """Number of operations for all columns."""
        parts = (part.count * part.program.num_operations for part in self.parts)
        return self.shared.num_operations + sum(parts)

    @property
    def num_states(self) -> int:
        """Number of states x."""
        return self.shared.num_states

    @property
    def carried(self) -> tuple[int, ...]:
        """What the setup stage leaves for the run stage."""
        return self.shared.carried

    @property
    def outputs(self) -> range:
        """The outputs, in number."""
        return range(self.shape[0] * self.shape[1])

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The one block of outputs."""
        return (Block("jacobian", self.shape, 0, len(self.outputs)),)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of everything that decides what is computed."""
        parts = (self.shared.digest, *(f"{p.first} {p.program.digest}" for p in self.parts))
        return hashlib.sha256(" ".join((*parts, repr(self.shape))).encode()).hexdigest()

    @property
    def operation_count(self) -> dict[str, Counter[str]]:
        """Operations by kind; those of a part once for every column."""
        counts = {stage: own.copy() for stage, own in self.shared.operation_count.items()}
        for part in self.parts:
            for op, number in part.program.operation_count["run"].items():
                counts["run"][op] += number * part.count
        return counts

    def to_bytes(self) -> bytes:
        """Return the Jacobian as bytes, for this version of Python."""
        parts = tuple((part.first, part.program.to_bytes()) for part in self.parts)
        return marshal.dumps((self.shared.to_bytes(), parts, self.shape))

    @classmethod
    def from_bytes(cls, data: bytes) -> JacobianColumns:
        """Return the Jacobian that `to_bytes` wrote."""
        shared, parts, shape = marshal.loads(data)
        made = tuple(Part(first, Program.from_bytes(program)) for first, program in parts)
        return cls(Program.from_bytes(shared), made, shape)

    def __str__(self) -> str:
        texts = [str(self.shared)]
        for part in self.parts:
            last = part.first + part.count - 1
            texts.append(f"For each of the columns {part.first} to {last}:\n{part.program}")
        return "\n\n".join(texts)


def supports(graph: Graph, outputs: Sequence[int], by: Sequence[int]) -> Counter[int]:
    """Estimate what a derivative costs, by who has to pay.

    Parameters
    ----------
    graph : Graph
    outputs : sequence of nodes
    by : sequence of input nodes

    Returns
    -------
    Counter
        Operations, by the set of columns that execute them; bit k stands for column k. Columns of
        none are zero.
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
    """Return the parts of a Jacobian, see `parts_of`; none where it is small or sparse.

    The parameters are those of `supports`.
    """
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
    """Return what some of the columns execute."""
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


def columns_program(
    graph: Graph,
    outputs: Sequence[int],
    variables: Sequence[tuple[str, int]],
    sizes: tuple[int, int, int],
    passes: Passes,
    parts: Sequence[tuple[int, int]],
) -> JacobianColumns:
    """Return the Jacobian of some nodes in parts.

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    outputs : sequence of m nodes
        Simplified ones.
    variables : sequence of k pairs (group, index)
    sizes : (int, int, int)
        Numbers of states, specifieds and constants.
    passes : Passes
    parts : sequence of (first, stop)
        See `parts_of`.
    """
    n, s, c = sizes
    with collector_paused():
        cells = []
        for first, stop in parts:  # one by one, so that nothing belongs to two of them
            given: dict[int, dict[int, int]] = {}
            for j in range(first, stop):
                along = given.setdefault(graph.input(*variables[j]), {})
                # A variable may have several columns.
                along[0] = graph.add(along.get(0, graph.zero), graph.input("x", n + j))
            rows = Rows(graph, given)
            cells += [rows(node).get(0, graph.zero) for node in outputs]
        cells = factor_sums(graph, cells) if "factor" in passes else cells
        whole = (n + len(variables), s, c)
        m = len(outputs)
        blocks = [(str(k), (m,), cells[k * m : (k + 1) * m]) for k in range(len(parts))]
        lowered = lower(graph, whole, blocks, passes=passes, own=sizes)
        parting = Parting(lowered)
        made = []
        for (first, stop), block in zip(parts, lowered.blocks, strict=True):
            own = {("x", n + j): j - first for j in range(first, stop)}
            column = lowered.outputs[block.start : block.stop]
            made.append(Part(first, parting.part(own, column, (stop - first, 0))))
        return JacobianColumns(parting.shared(sizes), tuple(made), (m, len(variables)))
