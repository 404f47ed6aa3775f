"""Derivatives at a switch: the same side for all operations that switch there.

Where x = 0, ``max(x, 0) + min(x, 0)`` and ``abs(x) sign(x)`` are x on both sides, but each of
their operations alone has a kink or a jump. Their derivatives add up to that of x only if all of
them belong to one side of x = 0. So the conditions and signs that a derivative contains are those
on the side where their argument is positive, also where it is zero.

Arguments that are multiples of one another have one sign: that of their first term is positive. The
condition that a function of the state has a value holds on no side. A branch that is not regular at
the switch, as √x or a quotient that a Piecewise protects, is not entered there. Conditions of time
stay as they are, since their sides are the times before and after, and so do those of parameters in
a Piecewise, which select an equation. The solution of a linear system is the one at the point.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.node import Graph
from pydy._graph.rewrite import make_canonical, replaced
from pydy._program import OPERATIONS, leads

_SOLUTIONS = frozenset({"item", "solve", "guard", "factor"})
# Facts of a node: what it or any of its operands is.
_STATE, _INPUT, _TIME, _PARTLY_CONSTANT, _IRREGULAR = 1, 2, 4, 8, 16
_OF_GROUP = {"x": _STATE, "r": _INPUT, "t": _TIME}
_COMPARISONS = frozenset({"lt", "le"})
# Operations with finite slopes of all orders, or steps.
_REGULAR = frozenset(
    {"const", "bool", "input", "sum", "prod", "select", "abs", "sign", "min", "max", "lt", "le"}
    | {"eq", "ne", "and", "or", "not", "sin", "cos", "exp", "tanh", "atan", "sinh", "cosh", "erf"}
)


def one_sided(g: Graph, node: int) -> int:
    """Return a node that is the same elsewhere, and where switches are zero that on one side."""
    memo, stack = g.one_sided, [node]
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
        memo[n] = result = _on_side(g, n, memo)
        memo[result] = result
    return memo[node]


def condition_on_side(g: Graph, select: int) -> int:
    """Return the condition of a ``select`` on the side that its derivative belongs to."""
    condition, yes, no = g.args[select]
    return _condition(g, one_sided(g, condition), yes, no)


def protected_conditions(g: Graph, nodes: Sequence[int]) -> list[int]:
    """Return conditions, true at single states, by which a Piecewise avoids a singular branch."""
    conditions = []
    for n in g.reachable(nodes):
        if g.ops[n] == "select" and g.ops[g.args[n][0]] in ("eq", "ne"):
            condition, yes, no = g.args[n]
            equal = g.ops[condition] == "eq"
            singular = not _is_regular(g, no if equal else yes)
            if singular and _is_isolated(g, *g.args[condition]):
                conditions.append(condition if equal else g.call("not", condition))
    return conditions


def _on_side(g: Graph, node: int, memo: dict[int, int]) -> int:
    op, args = g.ops[node], replaced(g, node, memo)
    if op == "sign":
        return _step(g, args[0])
    if op == "select":
        args = (_condition(g, *args), *args[1:])
    return node if args == g.args[node] else make_canonical(g, op, args)


def _step(g: Graph, argument: int) -> int:
    """Return 1 or −1, by the sign of an argument."""
    positive, negative = g.one, g.const(-1.0)
    if leads(g, argument, g.zero):
        return g.call("select", g.call("lt", argument, g.zero), negative, positive)
    return g.call("select", g.call("lt", g.zero, argument), positive, negative)


def _condition(g: Graph, condition: int, yes: int, no: int) -> int:
    """Return the condition of a ``select`` on one side, if the branch of that side is regular."""
    op, args = g.ops[condition], g.args[condition]
    if op in _COMPARISONS:
        side = _of_comparison(g, op, args)
        # Where its operands are equal 'lt' takes the second branch, 'le' the first.
        if side == op or not _is_regular(g, no if side == "lt" else yes):
            return condition
        return g.call(side, *args)
    if op in ("eq", "ne"):
        branch = no if op == "eq" else yes
        if _is_isolated(g, *args) and _is_regular(g, branch):
            return g.boolean(op == "ne")
        return condition
    if op in ("and", "or", "not") and _is_regular(g, yes) and _is_regular(g, no):
        return g.call(op, *(_condition(g, n, yes, no) for n in args))
    return condition


def _of_comparison(g: Graph, op: str, args: tuple[int, ...]) -> str:
    """Return 'lt' or 'le': whether a comparison holds on the side of equal operands."""
    facts = _facts(g, args[0]) | _facts(g, args[1])
    if not facts & _STATE and (facts & _TIME or not facts & _INPUT):
        return op
    return "lt" if leads(g, *args) else "le"


def _is_isolated(g: Graph, a: int, b: int) -> bool:
    """Return whether two nodes can be equal at single states only, by structure.

    Equalities of parameters and steps select an equation, and hold as long as they are not changed.
    """
    facts = 0
    for n in (a, b):
        facts |= _facts(g, g.args[n][0] if g.ops[n] == "abs" else n)
    return a != b and facts & (_STATE | _PARTLY_CONSTANT) == _STATE


def _is_regular(g: Graph, node: int) -> bool:
    return not _facts(g, node) & _IRREGULAR


def _facts(g: Graph, node: int) -> int:
    """Return the facts of a node; those of all nodes are computed once."""
    facts = g.facts
    for n in range(len(facts), node + 1):
        op, args = g.ops[n], g.args[n]
        bits = _OF_GROUP.get(args[0], 0) if op == "input" else 0
        if op in OPERATIONS.partly_constant or op in _SOLUTIONS:
            bits |= _PARTLY_CONSTANT
        if op not in _REGULAR or (op == "prod" and any(e < 0 for _, e in args)):
            bits |= _IRREGULAR
        for operand in g.operands(n):
            bits |= facts[operand]
        facts.append(bits)
    return facts[node]
