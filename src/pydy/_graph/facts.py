"""What is known of nodes by structure: what they depend on, and whether they are regular."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pydy._program import OPERATIONS

if TYPE_CHECKING:
    from pydy._graph.node import Graph
    from pydy._program import Args

SOLUTIONS = frozenset({"item", "solve", "guard", "factor"})
# What a node or any of its operands is.
STATE, INPUT, TIME, PARTLY_CONSTANT, IRREGULAR, SOLVED = 1, 2, 4, 8, 16, 32
_INHERITED = 63
# What it is itself.
NOT_NEGATIVE, _POSITIVE = 64, 128
_OF_GROUP = {"x": STATE, "r": INPUT, "t": TIME}
# Operations with finite slopes of all orders, or steps.
_REGULAR = frozenset(
    {"const", "bool", "input", "sum", "prod", "select", "abs", "sign", "min", "max", "lt", "le"}
    | {"eq", "ne", "and", "or", "not", "sin", "cos", "exp", "tanh", "atan", "sinh", "cosh", "erf"}
)


class NodeFacts:
    """The facts of a graph's nodes, each found once."""

    def __init__(self, graph: Graph) -> None:
        self._graph, self._facts = graph, bytearray()

    def copy(self, graph: Graph) -> NodeFacts:
        """Return the same for a copy of the graph."""
        twin = NodeFacts(graph)
        twin._facts = self._facts.copy()
        return twin

    def of(self, *nodes: int) -> int:
        """Return the facts of nodes, taken together."""
        facts = 0
        for node in nodes:
            facts |= self._of(node)
        return facts

    def is_regular(self, node: int) -> bool:
        """Return whether a node is finite with all of its slopes where its inputs are."""
        return not self._of(node) & IRREGULAR

    def _of(self, node: int) -> int:
        g, facts = self._graph, self._facts
        for n in range(len(facts), node + 1):
            op, args = g.ops[n], g.args[n]
            bits = _OF_GROUP.get(args[0], 0) if op == "input" else 0
            if op in OPERATIONS.partly_constant or op in SOLUTIONS:
                bits |= PARTLY_CONSTANT
            if op in SOLUTIONS:
                bits |= SOLVED
            if op not in _REGULAR or (op == "prod" and self._may_divide_by_zero(args)):
                bits |= IRREGULAR
            for operand in g.operands(n):
                bits |= facts[operand] & _INHERITED
            facts.append(bits | self._sign_facts(op, args))
        return facts[node]

    def _may_divide_by_zero(self, factors: Sequence[tuple[int, int]]) -> bool:
        """Return whether a product divides by what moves and is not positive by structure.

        Constants are no reason: where they are zero, nothing is finite.
        """
        moves = STATE | INPUT | TIME
        return any(
            e < 0 and self._facts[n] & moves and not self._facts[n] & _POSITIVE for n, e in factors
        )

    def _sign_facts(self, op: str, args: Args) -> int:
        """Return whether a node is positive, or not negative, by structure."""
        facts = self._facts
        if op in ("exp", "cosh"):
            return _POSITIVE | NOT_NEGATIVE
        if op in ("abs", "sqrt"):
            return NOT_NEGATIVE | (facts[args[0]] & _POSITIVE if op == "sqrt" else 0)
        if op == "max":
            return (facts[args[0]] | facts[args[1]]) & (_POSITIVE | NOT_NEGATIVE)
        if op == "const":
            return (NOT_NEGATIVE if args[0] >= 0.0 else 0) | (_POSITIVE if args[0] > 0.0 else 0)
        if op == "prod":
            both = _POSITIVE | NOT_NEGATIVE
            for n, e in args:
                both &= facts[n] | (NOT_NEGATIVE if e % 2 == 0 else 0)
            return both
        if op == "sum":
            c0, terms = args
            if c0 >= 0.0 and all(c > 0.0 and facts[n] & NOT_NEGATIVE for n, c in terms):
                is_positive = c0 > 0.0 or any(facts[n] & _POSITIVE for n, _ in terms)
                return NOT_NEGATIVE | (_POSITIVE if is_positive else 0)
        return 0
