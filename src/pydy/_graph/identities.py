"""Which nodes are equal as functions, told by exact values.

Every node is evaluated in arithmetic modulo a prime (`pydy._modular`), at a random
point. The sine and cosine of an argument are a random point of the unit circle; any other function
is a random number for each value of its arguments. Angle sums and the like are so not seen, and
nothing is that does not hold.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.node import Graph
from pydy._modular import PRIME, arbitrary, inverse, residue
from pydy._program import OPERATIONS, symmetric


def signatures(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return a number for each node: equal ones for nodes that are equal wherever defined.

    It is 0 for what vanishes. Small linear systems are solved.
    """
    values, _, _ = evaluated(graph, graph.reachable(nodes), solving=True)
    return [values[node] for node in nodes]


def evaluated(
    graph: Graph, nodes: Sequence[int], *, solving: bool = False
) -> tuple[dict[int, int], dict[int, frozenset[int]], dict[int, float]]:
    """Return each node's value, its denominators and its cost written out as a tree.

    Calls of functions other than sine and cosine are among the denominators.
    """
    values: dict[int, int] = {graph.zero: 0, graph.one: 1}
    nothing: frozenset[int] = frozenset()
    poles = {graph.zero: nothing, graph.one: nothing}
    costs = {graph.zero: 0.0, graph.one: 0.0}
    residues: dict[float, int] = {}
    solutions = _Solutions(graph, values)
    for node in nodes:
        op, args = graph.ops[node], graph.args[node]
        operands = graph.operands(node)
        denominators = poles[operands[0]] if operands else nothing
        for operand in operands[1:]:
            if poles[operand] is not denominators and poles[operand]:
                denominators |= poles[operand]
        cost = 1.0 + sum(costs[n] for n in operands)
        if op == "sum":
            total = _residue(residues, args[0])
            for n, c in args[1]:
                total += values[n] if c == 1.0 else _residue(residues, c) * values[n]
            value = total % PRIME
            cost += len(args[1])
        elif op == "prod":
            value = 1
            for n, e in args:
                cost += abs(e)
                factor = values[n]
                if e < 0:
                    denominators |= {min(factor, PRIME - factor)}
                    cost += 4.0
                if e != 1:
                    zero = e < 0 and factor == 0
                    factor = arbitrary("pole", e) if zero else pow(factor, e, PRIME)
                value = value * factor % PRIME
        elif op == "const":
            value, cost = _residue(residues, args[0]), 0.0
        elif op == "input":
            value, cost = arbitrary(op, *args), 0.0
        elif op in OPERATIONS and (rule := OPERATIONS[op].modular) is not None:
            value = rule(*(values[n] for n in operands))
            cost += 8.0
        elif solving and op == "item" and (solved := solutions(args[0])) is not None:
            value = solved[args[1]]
            denominators = frozenset({arbitrary("within", value)})
        else:
            value = arbitrary(op, *_kind(op, args), *(values[n] for n in operands))
            # What a function divides by inside may be guarded by it.
            denominators = frozenset(
                {arbitrary("within", value, *sorted(denominators))} if denominators else {value}
            )
            cost += 8.0
        values[node], poles[node], costs[node] = value, denominators, cost
    return values, poles, costs


class _Solutions:
    """Solutions of linear systems modulo a prime, each found once."""

    def __init__(self, graph: Graph, values: dict[int, int]) -> None:
        self.graph, self.values = graph, values
        self._inverses: dict[tuple[int, ...], list[list[int]] | None] = {}
        self._solved: dict[int, list[int] | None] = {}

    def __call__(self, node: int) -> list[int] | None:
        """Return the solution of a `solve` or `guard`; None where it is singular or large."""
        if node not in self._solved:
            self._solved[node] = self._solve(node)
        return self._solved[node]

    def _solve(self, node: int) -> list[int] | None:
        op, args = self.graph.ops[node], self.graph.args[node]
        if op == "solve":
            kind, n, entries = self.graph.args[args[0]]
            column = args[1]
        elif op == "guard":
            _, _, _, sound, fast = args
            # It falls back always if the condition is False: a least solution has no value here.
            never = self.graph.ops[sound] == "bool" and not self.graph.args[sound][0]
            return None if never else [self.values[k] for k in fast]
        else:
            return None
        if n > 32:  # it takes n³ times 0.2 µs in Python
            return None
        if entries not in self._inverses:
            read = symmetric(n, entries) if kind == "ldl" else entries
            cells = [self.values[e] for e in read]
            self._inverses[entries] = inverse([cells[k : k + n] for k in range(0, n * n, n)])
        inverse_rows = self._inverses[entries]
        if inverse_rows is None:
            return None
        right = [self.values[e] for e in column]
        return [sum(a * b for a, b in zip(row, right, strict=True)) % PRIME for row in inverse_rows]


def _residue(residues: dict[float, int], number: float) -> int:
    if number not in residues:
        residues[number] = residue(number)
    return residues[number]


def _kind(op: str, args: tuple[object, ...]) -> tuple[object, ...]:
    """Return the arguments of a node that are not nodes."""
    if op == "factor":
        return args[:2]
    if op == "item":
        return (args[1],)
    if op == "guard":
        return args[:1]
    return args if op == "bool" else ()
