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
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, TypeAlias

from pydy._graph.common_zeros import common_zeros
from pydy._graph.node import Graph
from pydy._graph.rewrite import make_canonical, replaced
from pydy._graph.tuning import MOST_ARGUMENTS
from pydy._program import OPERATIONS

if TYPE_CHECKING:
    from pydy._program import Args

_SOLUTIONS = frozenset({"item", "solve", "guard", "factor"})
# Facts of a node: what it or any of its operands is.
_STATE, _INPUT, _TIME, _PARTLY_CONSTANT, _IRREGULAR, _SOLVED = 1, 2, 4, 8, 16, 32
_INHERITED = 63
# What it is itself.
_NOT_NEGATIVE, _POSITIVE = 64, 128
_OF_GROUP = {"x": _STATE, "r": _INPUT, "t": _TIME}
_COMPARISONS = frozenset({"lt", "le"})
_SWITCHES = _COMPARISONS | {"min", "max", "abs", "sign"}
# Operations with finite slopes of all orders, or steps.
_REGULAR = frozenset(
    {"const", "bool", "input", "sum", "prod", "select", "abs", "sign", "min", "max", "lt", "le"}
    | {"eq", "ne", "and", "or", "not", "sin", "cos", "exp", "tanh", "atan", "sinh", "cosh", "erf"}
)
_Row: TypeAlias = dict[int, int]
# Makes `pydy._graph.derivative.DerivativeRows`, which asks for sides in turn.
_MakeRows: TypeAlias = Callable[
    [Graph, dict[int, _Row], Callable[[int], _Row]], Callable[[int], _Row]
]
_GOLDEN = 0.5 * (5.0**0.5 - 1.0)  # its multiples differ from one another by no simple ratio


class Sides:
    """The nodes of a graph just beside each point, in one direction.

    Attributes
    ----------
    nodes : dict
        From nodes to those that are the same elsewhere, and where switches are zero on that side.
    conditions : set
        Conditions that are on that side already.
    signs : dict
        From arguments that are zero at switches to their signs on that side, or 0 if these are the
        signs of their slopes.
    rows : dict
        Of nodes the slopes in the direction, of states (0) and of specifieds (1).
    facts : bytearray
    """

    def __init__(self, graph: Graph, make_rows: _MakeRows) -> None:
        self.graph, self._make_rows = graph, make_rows
        self.nodes: dict[int, int] = {}
        self.conditions: set[int] = set()
        self.signs: dict[int, float] = {}
        self._searched = 0  # nodes among which arguments were searched
        self._originals: dict[int, int] = {}
        self.rows: dict[int, _Row] = {}
        self.facts = bytearray()

    def copy(self, graph: Graph) -> Sides:
        """Return the same for a copy of the graph."""
        twin = Sides(graph, self._make_rows)
        twin.nodes, twin.conditions = self.nodes.copy(), self.conditions.copy()
        twin.rows, twin.facts = self.rows.copy(), self.facts.copy()
        twin.signs, twin._searched = self.signs.copy(), self._searched
        twin._originals = self._originals.copy()
        return twin

    def one_sided(self, node: int) -> int:
        """Return a node that is the same elsewhere, and where switches are zero on that side."""
        g, memo, stack = self.graph, self.nodes, [node]
        while stack:
            n = stack[-1]
            if n in memo:
                stack.pop()
                continue
            if g.ops[n] in _SOLUTIONS:
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
                singular = not self._is_regular(no if equal else yes)
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
            return g.call("select", is_negative, negative, positive)
        is_positive = self._comparison("lt", g.zero, argument)
        return g.call("select", is_positive, positive, negative)

    def _condition(self, condition: int, yes: int, no: int) -> int:
        """Return the condition of a ``select`` on one side, if its branch there is regular."""
        g = self.graph
        op, args = g.ops[condition], g.args[condition]
        if condition in self.conditions:
            return condition
        if op in _COMPARISONS:
            # Where its operands are equal 'lt' takes the second branch, 'le' the first.
            other = yes if op == "lt" else no
            return self._comparison(op, *args) if self._is_regular(other) else condition
        if op in ("eq", "ne"):
            branch = no if op == "eq" else yes
            if self._is_isolated(*args) and self._is_regular(branch):
                return g.boolean(op == "ne")
            return condition
        if op in ("and", "or", "not") and self._is_regular(yes) and self._is_regular(no):
            return g.call(op, *(self._condition(n, yes, no) for n in args))
        return condition

    def _comparison(self, op: str, a: int, b: int) -> int:
        """Return whether a < b, or a ≤ b, on the side of equal operands."""
        g, facts = self.graph, self._facts(a) | self._facts(b)
        if not facts & _STATE and (facts & _TIME or not facts & _INPUT):
            return g.call(op, a, b)
        is_below = self._is_below(a, b)
        if is_below is None:
            direction = 0 if facts & _STATE else 1
            growth = g.sub(*(self._slope(n, direction) for n in (b, a)))
            just_below = g.call("or", g.call("lt", a, b), g.call("lt", g.zero, growth))
            comparison = g.call("and", g.call("le", a, b), just_below)
        else:
            comparison = g.call("le" if is_below else "lt", a, b)
        self.conditions.add(comparison)
        return comparison

    def _is_below(self, a: int, b: int) -> bool | None:
        """Return whether a < b beside the states where they are equal; None if slopes tell."""
        a, b = (self._originals.get(n, n) for n in (a, b))
        factor, argument = self._argument(a, b)
        if argument not in self.signs:
            self._search(argument)
        sign = self.signs[argument]
        return factor * sign < 0.0 if sign else None

    def _argument(self, a: int, b: int) -> tuple[float, int]:
        """Return a − b as a factor and a node, which is the same for b − a."""
        factor, node = self.graph.scaled(self.graph.sub(a, b))
        opposite = self.graph.neg(node)
        return (factor, node) if node < opposite else (-factor, opposite)

    def _search(self, argument: int) -> None:
        """Find the signs of all arguments of new nodes."""
        g = self.graph
        found, first, self._searched = {argument}, self._searched, len(g)
        for n in range(first, self._searched):
            op, args = g.ops[n], g.args[n]
            if op in _SWITCHES:
                a, b = args if len(args) == 2 else (args[0], g.zero)
                found.add(self._argument(a, b)[1])
        new = sorted(n for n in found if n not in self.signs)
        self.signs.update((n, self._first_sign(n)) for n in new)
        moving = [n for n in sorted(self.signs) if self._facts(n) & (_STATE | _INPUT)]
        moving = [n for n in moving if not self._facts(n) & _SOLVED]
        # Two inputs are not zero together.
        if any(g.ops[n] != "input" for n in moving) and 1 < len(moving) <= MOST_ARGUMENTS:
            self._join(moving, common_zeros(g, moving))

    def _join(self, nodes: Sequence[int], pairs: Mapping[tuple[int, int], float]) -> None:
        """Give nodes that are zero together signs of one side."""
        neighbours: dict[int, list[tuple[int, float]]] = {}
        for (i, j), product in pairs.items():
            neighbours.setdefault(nodes[i], []).append((nodes[j], product))
            neighbours.setdefault(nodes[j], []).append((nodes[i], product))
        reached: set[int] = set()
        for root in sorted(neighbours):
            if root in reached:
                continue
            group = [root]
            signs = {root: self.signs[root] or self._first_sign(root)}
            for n in group:
                for m, product in neighbours[n]:
                    if m not in signs:
                        group.append(m)
                        signs[m] = product * signs[n]
                    elif signs[m] != product * signs[n]:
                        signs[m] = 0.0
            if 0.0 in signs.values():
                signs = dict.fromkeys(signs, 0.0)
            self.signs.update(signs)
            reached.update(group)

    def _first_sign(self, argument: int) -> float:
        """Return the sign of the first term, those with states first, then those with inputs."""
        g = self.graph
        if g.ops[argument] != "sum":
            return 1.0
        terms = g.args[argument][1]
        for fact in (_STATE, _INPUT):
            for n, c in terms:
                if self._facts(n) & fact:
                    return 1.0 if c > 0.0 else -1.0
        return 1.0

    def _slope(self, node: int, direction: int) -> int:
        rows = self._make_rows(self.graph, self.rows, self._weight)
        return rows(node).get(direction, self.graph.zero)

    def _weight(self, node: int) -> _Row:
        """Return the component of the direction that belongs to an input."""
        group, index = self.graph.args[node]
        weight = self.graph.const(1.0 + index * _GOLDEN % 1.0)
        return {"x": {0: weight}, "r": {1: weight}}.get(group, {})

    def _is_isolated(self, a: int, b: int) -> bool:
        """Return whether two nodes can be equal at single states only, by structure.

        Equalities of parameters and steps select an equation, and hold as long as they are not
        changed.
        """
        g, facts = self.graph, 0
        for n in (a, b):
            facts |= self._facts(g.args[n][0] if g.ops[n] == "abs" else n)
        return a != b and facts & (_STATE | _PARTLY_CONSTANT) == _STATE

    def _is_regular(self, node: int) -> bool:
        return not self._facts(node) & _IRREGULAR

    def _facts(self, node: int) -> int:
        """Return the facts of a node; those of all nodes are computed once."""
        g, facts = self.graph, self.facts
        for n in range(len(facts), node + 1):
            op, args = g.ops[n], g.args[n]
            bits = _OF_GROUP.get(args[0], 0) if op == "input" else 0
            if op in OPERATIONS.partly_constant or op in _SOLUTIONS:
                bits |= _PARTLY_CONSTANT
            if op in _SOLUTIONS:
                bits |= _SOLVED
            if op not in _REGULAR or (op == "prod" and self._may_divide_by_zero(args)):
                bits |= _IRREGULAR
            for operand in g.operands(n):
                bits |= facts[operand] & _INHERITED
            facts.append(bits | self._sign_facts(op, args))
        return facts[node]

    def _may_divide_by_zero(self, factors: Sequence[tuple[int, int]]) -> bool:
        """Return whether a product divides by what moves and is not positive by structure.

        Constants are no reason: where they are zero, nothing is finite.
        """
        moves = _STATE | _INPUT | _TIME
        return any(
            e < 0 and self.facts[n] & moves and not self.facts[n] & _POSITIVE for n, e in factors
        )

    def _sign_facts(self, op: str, args: Args) -> int:
        """Return whether a node is positive, or not negative, by structure."""
        facts = self.facts
        if op in ("exp", "cosh"):
            return _POSITIVE | _NOT_NEGATIVE
        if op in ("abs", "sqrt"):
            return _NOT_NEGATIVE | (facts[args[0]] & _POSITIVE if op == "sqrt" else 0)
        if op == "max":
            return (facts[args[0]] | facts[args[1]]) & (_POSITIVE | _NOT_NEGATIVE)
        if op == "const":
            return (_NOT_NEGATIVE if args[0] >= 0.0 else 0) | (_POSITIVE if args[0] > 0.0 else 0)
        if op == "prod":
            both = _POSITIVE | _NOT_NEGATIVE
            for n, e in args:
                both &= facts[n] | (_NOT_NEGATIVE if e % 2 == 0 else 0)
            return both
        if op == "sum":
            c0, terms = args
            if c0 >= 0.0 and all(c > 0.0 and facts[n] & _NOT_NEGATIVE for n, c in terms):
                is_positive = c0 > 0.0 or any(facts[n] & _POSITIVE for n, _ in terms)
                return _NOT_NEGATIVE | (_POSITIVE if is_positive else 0)
        return 0


def sides_of(graph: Graph, make_rows: _MakeRows) -> Sides:
    """Return the sides of a graph, which it keeps."""
    if not isinstance(graph.sides, Sides):
        graph.sides = Sides(graph, make_rows)
    return graph.sides
