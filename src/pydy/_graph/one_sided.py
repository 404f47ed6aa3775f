"""Derivatives at a switch: the same side for all operations that switch there.

Where x = 0, ``max(x, 0) + min(x, 0)`` and ``abs(x) sign(x)`` are x on both sides, but each of
their operations alone has a kink or a jump. Their derivatives add up to that of x only if all of
them belong to one side of x = 0. So the conditions and signs that a derivative contains are those
on the side where their argument is positive, also where it is zero: its first term that depends on
the state, if it has several.

Arguments that are zero together are on one side together, whichever form they have: beside x,
exp(−x) − 1 is negative. If two of them may change their signs alike or not, as x and (y − 1) x,
they have the sign of their slope in one direction, found as derivatives are. All weights of that
direction are positive and differ, so that neither x nor x − y is zero along it.

The condition that a function of the state has a value holds on no side. A branch that is not
regular at the switch, as √x or a quotient that a Piecewise protects, is not entered there.
Conditions of time stay as they are, since their sides are the times before and after, and so do
those of parameters in a Piecewise, which select an equation. The solution of a linear system is the
one at the point.

An argument may be zero in whole regions, as ``max(x, 0)`` where x is negative and ``min(x, 1) − x``
where x is below 1: it is flat there (`pydy._graph.generic_values`). No side is to be chosen then;
the conditions are those at the point.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from pydy._graph.facts import (
    INPUT,
    PARTLY_CONSTANT,
    SOLUTIONS,
    STATE,
    TIME,
    NodeFacts,
)
from pydy._graph.generic_values import GenericValues, arbitrary_number
from pydy._graph.node import Graph
from pydy._graph.rewrite import make_canonical, replaced
from pydy._graph.switch_arguments import SwitchArguments

_COMPARISONS = frozenset({"lt", "le"})
_Row: TypeAlias = dict[int, int]
# Makes `pydy._graph.derivative.DerivativeRows`, which asks for sides in turn.
_MakeRows: TypeAlias = Callable[
    [Graph, dict[int, _Row], Callable[[int], _Row]], Callable[[int], _Row]
]


class DerivativeSides:
    """The nodes of a graph just beside each point, in one direction.

    Attributes
    ----------
    nodes : dict
        From nodes to those that are the same elsewhere, and where switches are zero on that side.
    conditions : set
        Conditions that are on that side already.
    rows : dict
        Of nodes the slopes in the direction, of states (0) and of specifieds (1).
    facts : NodeFacts
    arguments : SwitchArguments
    generic : dict
        Nodes with arbitrary states, and with arbitrary specifieds.
    """

    def __init__(self, graph: Graph, make_rows: _MakeRows) -> None:
        self.graph, self._make_rows = graph, make_rows
        self.nodes: dict[int, int] = {}
        self.conditions: set[int] = set()
        self.rows: dict[int, _Row] = {}
        self.facts = NodeFacts(graph)
        self.arguments = SwitchArguments(graph, self.facts)
        self.generic = {v: GenericValues(graph, self.facts, self, v) for v in (STATE, INPUT)}
        self._originals: dict[int, int] = {}

    def copy(self, graph: Graph) -> DerivativeSides:
        """Return the same for a copy of the graph."""
        twin = DerivativeSides(graph, self._make_rows)
        twin.nodes, twin.conditions = self.nodes.copy(), self.conditions.copy()
        twin.rows, twin._originals = self.rows.copy(), self._originals.copy()
        twin.facts = self.facts.copy(graph)
        twin.generic = {v: g.copy(graph, twin.facts, twin) for v, g in self.generic.items()}
        twin.arguments = self.arguments.copy(graph, twin.facts)
        return twin

    def one_sided(self, node: int) -> int:
        """Return a node that is the same elsewhere, and where switches are zero on that side."""
        g, memo, stack = self.graph, self.nodes, [node]
        while stack:
            n = stack[-1]
            if n in memo:
                stack.pop()
                continue
            if g.ops[n] in SOLUTIONS:
                memo[n] = n
                continue
            missing = [m for m in g.operands(n) if m not in memo]
            if missing:
                stack += missing
                continue
            memo[n] = result = self._on_side(n)
            if result not in memo:
                memo[result] = result
                self._originals[result] = n
        return memo[node]

    def condition_on_side(self, select: int) -> int:
        """Return the condition of a ``select`` on the side that its derivative belongs to."""
        condition, yes, no = self.graph.args[select]
        return self._condition(self.one_sided(condition), yes, no)

    def protected_conditions(self, nodes: Sequence[int]) -> list[int]:
        """Return conditions, true at single states, by which a Piecewise avoids a singularity."""
        g, conditions = self.graph, []
        for n in g.reachable(nodes):
            if g.ops[n] == "select" and g.ops[g.args[n][0]] in ("eq", "ne"):
                condition, yes, no = g.args[n]
                equal = g.ops[condition] == "eq"
                singular = not self.facts.is_regular(no if equal else yes)
                if singular and self._is_isolated(*g.args[condition]):
                    conditions.append(condition if equal else g.call("not", condition))
        return conditions

    def _on_side(self, node: int) -> int:
        g = self.graph
        op, args = g.ops[node], replaced(g, node, self.nodes)
        if op == "sign":
            return self._step(args[0])
        if op == "select":
            args = (self._condition(*args), *args[1:])
        return node if args == g.args[node] else make_canonical(g, op, args)

    def _step(self, argument: int) -> int:
        """Return 1 or −1, by the sign of an argument."""
        g = self.graph
        positive, negative = g.one, g.const(-1.0)
        if self._is_below(argument, g.zero) is False:
            is_negative = self._comparison("lt", argument, g.zero)
            step = g.call("select", is_negative, negative, positive)
        else:
            is_positive = self._comparison("lt", g.zero, argument)
            step = g.call("select", is_positive, positive, negative)
        flat = self._is_flat(argument, g.zero)
        return step if flat is None else g.call("select", flat, g.zero, step)

    def _condition(self, condition: int, yes: int, no: int) -> int:
        """Return the condition of a ``select`` on one side, if its branch there is regular."""
        g = self.graph
        op, args = g.ops[condition], g.args[condition]
        if condition in self.conditions:
            return condition
        if op in _COMPARISONS:
            # Where its operands are equal 'lt' takes the second branch, 'le' the first.
            other = yes if op == "lt" else no
            return self._comparison(op, *args) if self.facts.is_regular(other) else condition
        if op in ("eq", "ne"):
            branch = no if op == "eq" else yes
            if self._is_isolated(*args) and self.facts.is_regular(branch):
                return g.boolean(op == "ne")
            return condition
        if op in ("and", "or", "not") and self.facts.is_regular(yes) and self.facts.is_regular(no):
            return g.call(op, *(self._condition(n, yes, no) for n in args))
        return condition

    def _comparison(self, op: str, a: int, b: int) -> int:
        """Return whether a < b, or a ≤ b, on the side of equal operands."""
        g, facts = self.graph, self.facts.of(a, b)
        if not facts & STATE and (facts & TIME or not facts & INPUT):
            return g.call(op, a, b)
        if g.value(g.sub(a, b)) == 0.0:  # equal everywhere
            return g.call(op, a, b)
        is_below = self._is_below(a, b)
        takes_equal = is_below
        if is_below is None:
            factor, argument = self._argument(a, b)
            growth = g.sum([(self._slope(argument, 0 if facts & STATE else 1), -factor)])
            # Without a slope the argument is positive.
            grows = g.call("lt" if factor > 0.0 else "le", g.zero, growth)
            just_below = g.call("or", g.call("lt", a, b), grows)
            comparison = g.call("and", g.call("le", a, b), just_below)
        else:
            comparison = g.call("le" if is_below else "lt", a, b)
        if takes_equal is not (op == "le") and (flat := self._is_flat(a, b)) is not None:
            if op == "le":
                comparison = g.call("or", comparison, g.call("and", g.call("le", a, b), flat))
            else:
                below = g.call("or", g.call("lt", a, b), g.call("not", flat))
                comparison = g.call("and", comparison, below)
        self.conditions.add(comparison)
        return comparison

    def _is_flat(self, a: int, b: int) -> int | None:
        """Return whether a − b is zero around a state and not there alone; None if it never is."""
        facts = self.facts.of(a, b)
        varying = STATE if facts & STATE else INPUT
        if not facts & PARTLY_CONSTANT or not facts & varying:
            return None
        flat = self.generic[varying].are_equal(*(self._originals.get(n, n) for n in (a, b)))
        return None if self.graph.ops[flat] == "bool" and not self.graph.args[flat][0] else flat

    def _is_below(self, a: int, b: int) -> bool | None:
        """Return whether a < b beside the states where they are equal; None if slopes tell."""
        factor, argument = self._argument(a, b)
        sign = self.arguments.sign(argument)
        return factor * sign < 0.0 if sign else None

    def _argument(self, a: int, b: int) -> tuple[float, int]:
        return self.arguments.argument(*(self._originals.get(n, n) for n in (a, b)))

    def _slope(self, node: int, direction: int) -> int:
        rows = self._make_rows(self.graph, self.rows, self._weight)
        return rows(node).get(direction, self.graph.zero)

    def _weight(self, node: int) -> _Row:
        """Return the component of the direction that belongs to an input."""
        group, index = self.graph.args[node]
        weight = self.graph.const(arbitrary_number(index))
        return {"x": {0: weight}, "r": {1: weight}}.get(group, {})

    def _is_isolated(self, a: int, b: int) -> bool:
        """Return whether two nodes can be equal at single states only, by structure.

        Equalities of parameters and steps select an equation, and hold as long as they are not
        changed.
        """
        g, facts = self.graph, 0
        for n in (a, b):
            facts |= self.facts.of(g.args[n][0] if g.ops[n] == "abs" else n)
        return a != b and facts & (STATE | PARTLY_CONSTANT) == STATE


def sides_of(graph: Graph, make_rows: _MakeRows) -> DerivativeSides:
    """Return the sides of a graph, which it keeps."""
    if not isinstance(graph.sides, DerivativeSides):
        graph.sides = DerivativeSides(graph, make_rows)
    return graph.sides
