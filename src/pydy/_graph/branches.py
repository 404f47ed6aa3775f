"""Switches of nodes: expressions by whose sign other nodes take one branch or the other."""

from __future__ import annotations

import math
from collections.abc import Sequence

from pydy._graph.derivative import DerivativeRows
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute

_COMPARED = ("lt", "le", "eq", "ne")
_EXTREMES = ("max", "min")
_ROUNDINGS = ("floor", "ceil")


class Branches:
    """The branches of some nodes, and the switches between them."""

    def __init__(self, graph: Graph, nodes: Sequence[int]) -> None:
        self.graph, self.nodes = graph, nodes

    def switches(self, whole: bool = False) -> list[int]:
        """Return the nodes by whose sign others take one branch or the other.

        With `whole` also those at which floors go to the next whole number, and angles of `atan2`
        to the next turn.
        """
        graph, nodes = self.graph, self.nodes
        at_zero: set[int] = set()
        # The condition of a guard is no switch: both of its solutions have the same values.
        reached, branching = {*nodes}, {*nodes}
        for n in reversed(graph.reachable(nodes)):
            if n in reached:
                guard = graph.ops[n] == "guard"
                operands = [m for m in graph.operands(n) if not guard or m != graph.args[n][3]]
                reached.update(operands)
                # Of either sign, log|a| is the integral of a'/a: it has one branch.
                branching.update(operands if graph.ops[n] != "log" else ())
        for n in branching:
            args = graph.args[n]
            if graph.ops[n] in (*_EXTREMES, "lt", "le"):
                at_zero.add(graph.scaled(graph.sub(*args))[1])
            elif graph.ops[n] in ("abs", "sign"):
                at_zero.add(graph.scaled(args[0])[1])
            elif whole and graph.ops[n] in _ROUNDINGS:
                at_zero.add(_turning(graph, args[0]))
            elif whole and graph.ops[n] == "atan2":
                at_zero.add(graph.scaled(args[0])[1])
            elif graph.ops[n] == "pow" and graph.ops[args[0]] == "prod":
                at_zero.update(m for m, e in graph.args[args[0]] if e % 2 == 0)
        return sorted({min(n, graph.neg(n)) for n in at_zero if not graph.constant[n]})

    def sides(self, switch: int, bends: bool = False) -> tuple[list[int], list[int]]:
        """Return the nodes as they are above and below a switch, each continued beyond it.

        With `bends`, `max` and `min` are continued as well, which are continuous at a switch.
        """
        graph, nodes = self.graph, self.nodes
        above: dict[int, int] = {}
        below: dict[int, int] = {}
        for node in graph.reachable(nodes):
            op, args = graph.ops[node], graph.args[node]
            if op in _ROUNDINGS and switch in (turn := _turning(graph, args[0]), graph.neg(turn)):
                near = graph.call("floor", graph.add(args[0], graph.const(0.5)))
                floor = near if op == "floor" else graph.add(near, graph.one)
                above[node], below[node] = floor, graph.sub(floor, graph.one)
            if op == "log" and graph.ops[args[0]] == "abs":
                above[node] = below[node] = node
            extremes = _EXTREMES if bends else ()
            if op not in (*_COMPARED, *extremes, "abs", "sign", "atan2"):
                continue
            argument = graph.sub(*args) if op in (*_COMPARED, *extremes) else args[0]
            size, core = graph.scaled(argument)
            if switch not in (core, graph.neg(core)):
                continue
            for side, replacements in ((1.0, above), (-1.0, below)):
                positive = side * size * (1.0 if switch == core else -1.0) > 0.0
                if op == "atan2":  # behind, where it has its cut
                    turn = graph.const(math.pi if positive else -math.pi)
                    ahead = graph.call("atan", graph.mul(args[0], graph.powi(args[1], -1)))
                    behind = graph.call("lt", args[1], graph.zero)
                    replacements[node] = graph.call("select", behind, graph.add(ahead, turn), node)
                elif op in extremes:
                    replacements[node] = args[0] if positive == (op == "max") else args[1]
                elif op in _COMPARED:
                    replacements[node] = graph.boolean(op == "ne" or (op != "eq" and not positive))
                else:
                    slope = argument if op == "abs" else graph.one
                    replacements[node] = slope if positive else graph.neg(slope)
        return substitute(graph, nodes, above), substitute(graph, nodes, below)

    def protected_conditions(self) -> list[int]:
        """Return conditions, true at single states, by which a Piecewise avoids a singularity."""
        from pydy._graph.one_sided import sides_of  # most models do not switch

        return sides_of(self.graph, DerivativeRows).protected_conditions(self.nodes)


def _turning(graph: Graph, node: int) -> int:
    """Return a node that changes its sign where another one is a whole number."""
    return graph.call("sin", graph.mul(graph.const(math.pi), node))
