"""Which nodes are zero in a whole region of states, and not at single states alone.

``max(x, 0)`` is zero wherever x is negative, and ``x + |x|`` is, too; both are zero at x = 0 as
well, where ``x |x|`` is zero alone. On the branches that its switches take at a state, the first is
the number 0, the second x − x, and the last x² or −x². So a node is evaluated on those branches
with arbitrary numbers in place of the states: a result of zero is zero for all states around, since
these numbers satisfy no equation.

Functions of what varies are arbitrary numbers themselves, and so are the solutions of linear
systems. These are zero in a region if all right-hand sides are that belong to the same part of the
system: accelerations of a body without forces.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from pydy._graph.facts import PARTLY_CONSTANT, NodeFacts
from pydy._graph.node import Graph
from pydy._program import OPERATIONS, symmetric

_HOMOGENEOUS = frozenset({"abs", "min", "max"})  # each is its slopes times its operands
_BITS = 24  # of an arbitrary number: sums and products of two have no rounding errors
_MASK = 2**64 - 1


class OneSidedNodes(Protocol):
    """The nodes and conditions on the side of derivatives; see `pydy._graph.one_sided`."""

    def one_sided(self, node: int) -> int: ...
    def condition_on_side(self, select: int) -> int: ...


def arbitrary_number(key: int) -> float:
    """Return a number from 1 to 2 for a key; those of different keys satisfy no simple equation."""
    # The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014, fig. 17).
    z = (key + 1) * 0x9E3779B97F4A7C15 & _MASK
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & _MASK
    z = (z ^ z >> 27) * 0x94D049BB133111EB & _MASK
    return 1.0 + ((z ^ z >> 31) >> 64 - _BITS) / 2.0**_BITS


class GenericValues:
    """Nodes with arbitrary numbers in place of states, or of specifieds (`varying`).

    Attributes
    ----------
    nodes : dict
        From nodes to those with arbitrary numbers.
    """

    def __init__(self, graph: Graph, facts: NodeFacts, sides: OneSidedNodes, varying: int) -> None:
        self._graph, self._facts, self._sides = graph, facts, sides
        self._varying = varying
        self.nodes: dict[int, int] = {}

    def copy(self, graph: Graph, facts: NodeFacts, sides: OneSidedNodes) -> GenericValues:
        """Return the same for a copy of the graph."""
        twin = GenericValues(graph, facts, sides, self._varying)
        twin.nodes = self.nodes.copy()
        return twin

    def are_equal(self, a: int, b: int) -> int:
        """Return whether two nodes are equal in a region, as a node."""
        return self._equal(self._of(a), self._of(b))

    def _of(self, node: int) -> int:
        """Return a node with arbitrary numbers."""
        memo, stack = self.nodes, [node]
        while stack:
            n = stack[-1]
            if n in memo:
                stack.pop()
                continue
            operands = self._operands(n)
            missing = [m for m in operands if m not in memo]
            if missing:
                stack += missing
                continue
            memo[n] = self._generic(n, operands)
        return memo[node]

    def _operands(self, node: int) -> Sequence[int]:
        """Return the nodes whose arbitrary numbers that of a node is made of."""
        g, facts = self._graph, self._facts.of(node)
        op, args = g.ops[node], g.args[node]
        if not facts & self._varying:
            return ()
        if op in ("sum", "prod"):
            return g.operands(node)
        if not facts & PARTLY_CONSTANT or op in ("sign", "floor", "ceil"):
            return ()
        if op == "item":
            return self._right_hand_sides(*args)
        return args[1:] if op == "select" else g.operands(node)

    def _generic(self, node: int, operands: Sequence[int]) -> int:
        """Return a node with arbitrary numbers, made of those of its operands."""
        g, memo, facts = self._graph, self.nodes, self._facts.of(node)
        op, args = g.ops[node], g.args[node]
        if not facts & self._varying:
            return node
        if op == "sum":
            return g.sum([(memo[n], c) for n, c in args[1]], args[0])
        if op == "prod":
            return g.product([(memo[n], e) for n, e in args])
        if op in ("sign", "floor", "ceil"):
            return self._sides.one_sided(node)
        if op == "select":
            condition = self._sides.condition_on_side(node)
            return g.call("select", condition, *(memo[n] for n in operands))
        if op in _HOMOGENEOUS:
            partials = OPERATIONS[op].partials
            slope = self._sides.one_sided(partials(g, node, *args)[0]) if partials else g.one
            first = memo[args[0]]
            return self._chosen(slope, first, g.neg(first) if op == "abs" else memo[args[1]])
        number = g.const(arbitrary_number(args[1] if op == "input" else -node))
        if not operands:
            return number
        if op == "item":
            zeros = [self._is_zero(memo[n]) for n in operands]
            return g.call("select", g.call("and", *zeros), g.zero, number)
        constant = [self._equal(memo[n], n) for n in operands]
        return g.call("select", g.call("and", *constant), node, number)

    def _right_hand_sides(self, vector: int, index: int) -> list[int]:
        """Return the right-hand sides by which an item of a solution is zero; [] if it never is.

        If it is determined by rows and columns apart from others, these are its right-hand sides.
        """
        g = self._graph
        if g.ops[vector] == "solve":
            factor, column = g.args[vector]
            kind, n, entries = g.args[factor]
            entries = symmetric(n, entries) if kind == "ldl" else entries
        else:
            n, entries, column = g.args[vector][:3]
        first, unknown = index - index % n, index % n
        columns, rows, remaining = {unknown}, set[int](), [unknown]
        while remaining:
            j = remaining.pop()
            for i in range(n):
                if i not in rows and entries[i * n + j] != g.zero:
                    rows.add(i)
                    more = {k for k in range(n) if entries[i * n + k] != g.zero} - columns
                    columns |= more
                    remaining += more
        right = [column[first + i] for i in sorted(rows)]
        smooth = any(
            self._facts.of(b) & (self._varying | PARTLY_CONSTANT) == self._varying for b in right
        )
        return [] if smooth else right

    def _chosen(self, slope: int, positive: int, other: int) -> int:
        """Return what an operation is, by its slope: 1 where it is its first operand.

        |x| has the slope 0 where x is zero in a region, and −x is, too.
        """
        g = self._graph
        if g.ops[slope] == "select":
            condition, *ends = g.args[slope]
            chosen = (self._chosen(end, positive, other) for end in ends)
            return g.call("select", condition, *chosen)
        return positive if slope == g.one else other

    def _equal(self, a: int, b: int) -> int:
        """Return whether two nodes are equal, by the conditions of a select if it has numbers."""
        g = self._graph
        if g.zero in (a, b):
            return self._is_zero(a if b == g.zero else b)
        for n, other in ((a, b), (b, a)):
            if g.ops[n] == "select" and g.value(other) is not None:
                condition, *ends = g.args[n]
                if all(g.value(end) is not None for end in ends):
                    return self._either(condition, *(g.call("eq", end, other) for end in ends))
        return g.call("eq", a, b)

    def _is_zero(self, node: int) -> int:
        """Return whether a node is zero, by its factors and the branches of a select."""
        g = self._graph
        _, node = g.scaled(node)
        if g.ops[node] == "prod":
            factors = [self._is_zero(n) for n, exponent in g.args[node] if exponent > 0]
            return g.call("or", *factors)
        branches: list[tuple[int, int]] = []  # down the last branches, of which there may be many
        while g.ops[node] == "select":
            condition, yes, node = g.args[node]
            branches.append((condition, self._is_zero(yes)))
            _, node = g.scaled(node)
        result = g.call("eq", node, g.zero)
        for condition, yes in reversed(branches):
            result = self._either(condition, yes, result)
        return result

    def _either(self, condition: int, yes: int, no: int) -> int:
        """Return a select between truth values."""
        g = self._graph
        if yes == no:
            return yes
        otherwise = g.call("and", g.call("not", condition), no)
        return g.call("or", g.call("and", condition, yes), otherwise)
