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
from pydy._graph.derivative import DerivativeRows, residuals_of
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._graph.tuning import ANOTHER_PART, COLUMNS_TOGETHER, FROM_OPERATIONS, LESS_WORK
from pydy._program import OPERATIONS, Part, Program, Tangent, Tape

# -- One direction apart from what all share -------------------------------------------------------


class Seeds(NamedTuple):
    """The directions of a part."""

    first: int  # its columns
    stop: int
    derivatives: dict[int, int]  # from variables to their derivatives, made of inputs of its own
    inputs: dict[tuple[str, int], int]  # these inputs, and their places in the part
    sizes: tuple[int, int]  # how many of them are x and p there


def tangent(
    graph: Graph,
    outputs: Sequence[int],
    seeds: Iterable[Seeds],
    sizes: tuple[tuple[int, int, int], tuple[int, int, int]],
    columns: int,
    directions: np.ndarray | None = None,
    values: str = "",
) -> Tangent:
    """Return the derivatives of simplified nodes along directions.

    The `sizes` are numbers of states, specifieds and constants: those of the equations, and with
    the inputs of directions after them. With a name for the `values` of the nodes these come first.
    """
    (n, _, c), sizes_with_seeds = sizes
    m, parts = len(outputs), list[Seeds]()
    with collector_paused():
        cells: list[int] = []
        for part in seeds:  # one at a time, so that no node belongs to two parts
            parts.append(part)
            rows = DerivativeRows(
                graph, {node: {0: seed} for node, seed in part.derivatives.items()}
            )
            cells += [rows(node).get(0, graph.zero) for node in outputs]
        cells = cells if "factor" in graph.off else factor_sums(graph, cells)
        blocks = [(str(k), (m,), cells[k * m : (k + 1) * m]) for k in range(len(parts))]
        first = [(values, (m,), [*outputs])] if values else []
        lowered = lower(graph, sizes_with_seeds, [*first, *blocks], sizes_of_matrices=sizes[0])
        nodes_of_block = [
            (b.name, lowered.outputs[b.start : b.stop]) for b in lowered.signature.blocks
        ]
        separation = _Separation(lowered)
        parts_made = []
        for part, (_, column) in zip(parts, nodes_of_block[len(first) :], strict=True):
            program = separation.part(part.inputs, column, part.sizes)
            parts_made.append(Part(part.first, part.stop - part.first, program))
        shared = separation.shared((n, sizes_with_seeds[1], c), *nodes_of_block[: len(first)])
        return Tangent(shared, tuple(parts_made), (m, columns), directions)


class _Separation:
    """Separates a Program that is linear in some of its inputs from values that are shared."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._full = Tape()
        self._full.ops, self._full.args = list(program.ops), list(program.args)
        self._full.constant = list(program.setup)
        self._position_of: dict[int, int] = {}  # of shared values
        self._guard_of = {k: guard for guard, nodes in program.fallback.items() for k in nodes}

    def part(
        self, inputs: Mapping[tuple[str, int], int], outputs: Sequence[int], sizes: tuple[int, int]
    ) -> Program:
        """Return the Program of some outputs that takes shared values as its inputs r.

        It has the given `inputs` of its own, x and p of these sizes. Values that depend on none of
        them are shared.
        """
        program, full, position_of = self._program, self._full, self._position_of
        part = Tape()
        new: dict[int, int] = {}  # nodes of the whole to nodes of the part

        def shared_value(node: int) -> int:
            """Return a shared value as a node of the part."""
            if node not in new:
                op, args = full.ops[node], full.args[node]
                if op in ("const", "bool"):
                    new[node] = part.make(op, *args)
                elif op == "factor":
                    new[node] = part.make(op, args[0], args[1], tuple(map(shared_value, args[2])))
                else:
                    value = part.make("input", "r", position_of.setdefault(node, len(position_of)))
                    truth = op in OPERATIONS.truths
                    new[node] = part.make("ne", value, part.const(0.0)) if truth else value
            return new[node]

        varying: set[int] = set()  # operations that depend on the part's inputs
        for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
            if op == "input":
                if args in inputs:
                    varying.add(k)
                    new[k] = part.make(op, args[0], inputs[args])
                continue
            arguments = OPERATIONS.operands(op, args)
            if varying.isdisjoint(arguments):
                continue
            varying.add(k)
            for operand in arguments:
                if operand not in varying:
                    shared_value(operand)
            new[k] = part.make(op, *OPERATIONS.with_operands(op, args, new))
        cells = [new[k] if k in varying else shared_value(k) for k in outputs]
        return Program.from_tape(
            part, (sizes[0], len(position_of), sizes[1]), [("column", (len(cells),), cells)]
        )

    def shared(self, sizes: tuple[int, int, int], *blocks: tuple[str, Sequence[int]]) -> Program:
        """Return the Program of further blocks and of all that the parts so far share."""
        parts = [*blocks, ("shared", self._shared_values())]
        return Program.from_tape(
            self._full, sizes, [(name, (len(nodes),), nodes) for name, nodes in parts]
        )

    def _shared_values(self) -> list[int]:
        """Return the shared values; those that only fallbacks need are computed behind guards."""
        full, groups = self._full, dict[int, list[int]]()
        for node in self._position_of:
            guard = node
            while guard in self._guard_of:
                guard = self._guard_of[guard]
            if guard != node:
                groups.setdefault(full.args[guard][3], []).append(node)
        new: dict[int, int] = {}
        unit, zero = full.const(1.0), full.const(0.0)
        for sound, nodes in groups.items():
            # The system 1 · x = number, solved only where not sound; elsewhere nothing reads it.
            numbers = [
                full.make("select", k, unit, zero) if full.ops[k] in OPERATIONS.truths else k
                for k in nodes
            ]
            guarded = full.make("guard", 1, (unit,), tuple(numbers), sound, ())
            new.update((k, full.make("item", guarded, i)) for i, k in enumerate(nodes))
        return [new.get(node, node) for node in self._position_of]


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
        parts = worthwhile_parts(graph, outputs, [graph.input(*variable) for variable in variables])
        if not parts:
            return None

    def seeds() -> Iterator[Seeds]:
        for first, stop in parts:
            derivatives: dict[int, int] = {}
            for j in range(first, stop):  # a variable may have several columns
                node, seed = graph.input(*variables[j]), graph.input("x", n + j)
                derivatives[node] = graph.add(derivatives.get(node, graph.zero), seed)
            inputs = {("x", n + j): j - first for j in range(first, stop)}
            yield Seeds(first, stop, derivatives, inputs, (stop - first, 0))

    sizes_with_seeds = (n + len(variables), s, c)
    return tangent(graph, outputs, seeds(), (sizes, sizes_with_seeds), len(variables))


def supports(graph: Graph, outputs: Sequence[int], variables: Sequence[int]) -> Counter[int]:
    """Count the operations of a derivative by inputs, by the set of columns that execute them.

    Bit k stands for column k. Columns of no operation are zero.
    """
    bits: dict[int, int] = {}
    for k, node in enumerate(variables):
        bits[node] = bits.get(node, 0) | 1 << k
    cost: Counter[int] = Counter()
    never = graph.boolean(False)

    def paid(nodes: Iterable[int]) -> int:
        """Count an operation for each operand that varies; return the columns that execute it."""
        all_columns = 0
        for node in nodes:
            columns = bits[node]
            if columns:
                cost[columns] += 1
                all_columns |= columns
        return all_columns

    for node in _differentiated(graph, outputs):
        op, args = graph.ops[node], graph.args[node]
        if node in bits:  # one of the variables
            continue
        if op == "item":
            vector, k = args
            if graph.ops[vector] == "guard" and graph.args[vector][3] != never:
                vector = graph.args[vector][4][k]
            bits[node] = bits[vector]
        elif op == "solve" and (residual := residuals_of(graph, node, open_form=True)):
            bits[node] = reduce(or_, (bits[k] for k in residual))
            cost[bits[node]] += len(residual) ** 2
        elif op == "solve" or (op == "guard" and args[3] == never):
            # Ȧ x, and a solve with the factors that there are; see `pydy._graph.derivative`.
            (_, n, entries), column = (
                (graph.args[args[0]], args[1]) if op == "solve" else (("", *args[:2]), args[2])
            )
            bits[node] = paid((*entries, *column))
            cost[bits[node]] += n * n
        else:
            row = OPERATIONS.get(op)
            has_derivative = op in ("sum", "prod", "select") or (row is not None and row.partials)
            bits[node] = paid(graph.operands(node)) if has_derivative else 0
    del cost[0]
    # An output that is a variable itself takes no operation, but its column is not zero.
    executing = _union(cost)
    for node in outputs:
        if bits[node] & ~executing:
            cost[bits[node]] += 1
            executing |= bits[node]
    return cost


def _differentiated(graph: Graph, outputs: Sequence[int]) -> list[int]:
    """Return the nodes whose derivatives are formed, operands first.

    Of a system with residuals these take the place of its entries.
    """
    never = graph.boolean(False)
    order: list[int] = []
    done: set[int] = set()
    stack = list(outputs)
    while stack:
        node = stack.pop()
        if node < 0:
            order.append(~node)
        elif node not in done:
            done.add(node)
            needs: Sequence[int] = graph.operands(node)
            if graph.ops[node] == "solve":
                needs = residuals_of(graph, node, open_form=True) or needs
            elif graph.ops[node] == "guard" and graph.args[node][3] != never:
                needs = (graph.args[node][3], *graph.args[node][4])
            stack += [~node, *(k for k in needs if k not in done)]
    return order


def _union(cost: Iterable[int]) -> int:
    """Return the columns that execute any operation."""
    return reduce(or_, cost, 0)


def worthwhile_parts(
    graph: Graph, outputs: Sequence[int], variables: Sequence[int]
) -> list[tuple[int, int]]:
    """Return the parts of a Jacobian, see `parts_of`; none where it is small or sparse."""
    cost = supports(graph, outputs, variables)
    written_out = sum(columns.bit_count() * operations for columns, operations in cost.items())
    if written_out < FROM_OPERATIONS or len(variables) < COLUMNS_TOGETHER:
        return []
    parts = parts_of(cost, len(variables))
    vectors = sum(_turns(b - a) * _restricted(cost, a, b).total() for a, b in parts)
    return parts if vectors * LESS_WORK < written_out else []


def parts_of(cost: Counter[int], columns: int) -> list[tuple[int, int]]:
    """Return the ranges of columns that get a Program each, as pairs (first, stop).

    A part is split where this saves more operations than the additional code costs.
    """
    union = _union(cost)
    if not union:
        return []
    first, stop = (union & -union).bit_length() - 1, union.bit_length()
    # Full vectors, with columns of zeros added if necessary.
    stop = min(max(stop, first + COLUMNS_TOGETHER), columns)
    first = max(min(first, stop - COLUMNS_TOGETHER), 0)
    return _split(cost, first, stop)


def _turns(columns: int) -> int:
    """Return how many vectors of columns a part has."""
    return -(-columns // COLUMNS_TOGETHER)


def _restricted(cost: Counter[int], first: int, stop: int) -> Counter[int]:
    """Return the operations that the columns from `first` to `stop` execute."""
    mask = (1 << stop) - (1 << first)
    restricted: Counter[int] = Counter()
    for bits, operations in cost.items():
        if bits & mask:
            restricted[bits & mask] += operations
    return restricted


def _split(cost: Counter[int], first: int, stop: int) -> list[tuple[int, int]]:
    width = stop - first
    work_left, work_right = [0] * (width + 1), [0] * (width + 1)
    for columns, operations in cost.items():
        low, high = (columns & -columns).bit_length() - 1 - first, columns.bit_length() - 1 - first
        work_left[low + 1] += operations  # executed left of any cut above the lowest column
        work_right[high] += operations  # executed right of any cut up to the highest
    for k in range(width):
        work_left[k + 1] += work_left[k]
        work_right[width - k - 1] += work_right[width - k]

    def price(cut: int) -> float:
        halves = (cut, work_left[cut]), (width - cut, work_right[cut])
        return sum((_turns(columns) + ANOTHER_PART) * work for columns, work in halves if columns)

    cuts = range(COLUMNS_TOGETHER, width - COLUMNS_TOGETHER + 1)
    best = min((width, *cuts), key=price)
    if best == width:
        return [(first, stop)]
    sides = ((first, first + best), (first + best, stop))
    parts = [(a, b, _restricted(cost, a, b)) for a, b in sides]
    return [part for a, b, part_cost in parts if part_cost for part in _split(part_cost, a, b)]
