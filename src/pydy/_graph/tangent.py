"""Make Tangents: separate what all directions share from the code of one of them.

Written out, all columns of a Jacobian make a Program that grows with their number: its code is slow
to compile and does not fit the processor's caches. Columns that depend on much the same make a part
of it, with a Program of its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import reduce
from operator import or_
from typing import NamedTuple

import numpy as np

from pydy._collector import collector_paused
from pydy._graph.derivative import Rows
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._graph.tuning import ANOTHER_PART, COLUMNS_TOGETHER, FROM_OPERATIONS, LESS_WORK
from pydy._program import OPERATIONS, Part, Program, Tangent, Tape

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
                    truth = op in OPERATIONS.truths
                    new[node] = part.make("ne", place, part.const(0.0)) if truth else place
            return new[node]

        moved: set[int] = set()  # what changes with the part's inputs
        for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
            if op == "input":
                if args in own:
                    moved.add(k)
                    new[k] = part.make(op, args[0], own[args])
                continue
            others = OPERATIONS.operands(op, args)
            if moved.isdisjoint(others):
                continue
            moved.add(k)
            for other in others:
                if other not in moved:
                    spread(other)
            new[k] = part.make(op, *OPERATIONS.with_operands(op, args, new))
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
                whole.make("select", k, one, zero) if whole.ops[k] in OPERATIONS.truths else k
                for k in nodes
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
    parts: Sequence[tuple[int, int]] | None = None,
) -> Tangent | None:
    """Return the Jacobian of simplified nodes in parts.

    The `parts` are pairs of columns, the first and the one after the last. By default they are
    chosen (`worthwhile_parts`), and the result is None where the Jacobian is small or sparse.
    """
    n, s, c = sizes
    if parts is None:
        parts = worthwhile_parts(graph, outputs, [graph.input(*place) for place in variables])
        if not parts:
            return None

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
