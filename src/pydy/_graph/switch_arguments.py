"""The signs of what switches, beside the states where it is zero, on one side for all."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.common_zeros import CommonZeros, common_zeros
from pydy._graph.facts import INPUT, NOT_NEGATIVE, SOLVED, STATE, NodeFacts
from pydy._graph.node import Graph
from pydy._graph.tuning import MOST_ARGUMENTS

_SWITCHES = frozenset({"lt", "le", "min", "max", "abs", "sign"})


class SwitchArguments:
    """The arguments of all switches of a graph, and their signs on the side of derivatives."""

    def __init__(self, graph: Graph, facts: NodeFacts) -> None:
        self._graph, self._facts = graph, facts
        self._signs: dict[int, float] = {}
        self._with_slopes: dict[int, tuple[float, int]] = {}
        self._searched = 0  # nodes among which arguments were searched

    def copy(self, graph: Graph, facts: NodeFacts) -> SwitchArguments:
        """Return the same for a copy of the graph."""
        twin = SwitchArguments(graph, facts)
        twin._signs, twin._searched = self._signs.copy(), self._searched
        twin._with_slopes = self._with_slopes.copy()
        return twin

    def sign(self, argument: int) -> float:
        """Return the sign of an argument, or 0.0 if it is that of its slope at the state."""
        if argument not in self._signs:
            self._search(argument)
        return self._signs[argument]

    def argument(self, a: int, b: int) -> tuple[float, int]:
        """Return a factor and a node with the sign of a − b, which is the same for b − a.

        Its slope is not zero where a node is known that has the same sign and a slope.
        """
        g = self._graph
        factor, node = g.scaled(g.sub(a, b))
        while g.ops[node] in ("prod", "sign"):
            if g.ops[node] == "sign":
                product = g.args[node][0]
            else:
                odd = (n for n, e in g.args[node] if e % 2)
                odd = (n for n in odd if not self._facts.of(n) & NOT_NEGATIVE)
                product = g.product([(g.args[n][0] if g.ops[n] == "sign" else n, 1) for n in odd])
            coefficient, core = g.scaled(product)
            if core == node:
                break
            factor, node = factor * coefficient, core
        opposite = g.neg(node)
        if opposite < node:
            factor, node = -factor, opposite
        sign, node = self._with_slopes.get(node, (1.0, node))
        return factor * sign, node

    def _search(self, argument: int) -> None:
        """Find the signs of all arguments of new nodes."""
        g = self._graph
        found, first, self._searched = {argument}, self._searched, len(g)
        for n in range(first, self._searched):
            op, args = g.ops[n], g.args[n]
            if op in _SWITCHES:
                a, b = args if len(args) == 2 else (args[0], g.zero)
                found.add(self.argument(a, b)[1])
        new = sorted(n for n in found if n not in self._signs)
        self._signs.update((n, self._first_sign(n)) for n in new)
        moving = [n for n in sorted(self._signs) if self._facts.of(n) & (STATE | INPUT)]
        moving = [n for n in moving if not self._facts.of(n) & SOLVED]
        # Two inputs are not zero together.
        if any(g.ops[n] != "input" for n in moving) and 1 < len(moving) <= MOST_ARGUMENTS:
            self._join(moving, common_zeros(g, moving))

    def _join(self, nodes: Sequence[int], zeros: CommonZeros) -> None:
        """Give nodes that are zero together signs of one side."""
        neighbours: dict[int, list[tuple[int, float]]] = {}
        for (i, j), product in zeros.pairs.items():
            neighbours.setdefault(nodes[i], []).append((nodes[j], product))
            neighbours.setdefault(nodes[j], []).append((nodes[i], product))
        reached: set[int] = set()
        own = {nodes[i]: sign for i, sign in zeros.touching.items()}
        for root in [*own, *sorted(neighbours)]:
            if root in reached:
                continue
            group = [root]
            signs = {root: own.get(root, self._signs[root] or self._first_sign(root))}
            for n in group:
                for m, product in neighbours.get(n, ()):
                    if m not in signs:
                        group.append(m)
                        signs[m] = product * signs[n]
                    elif signs[m] != product * signs[n]:
                        signs[m] = 0.0
            if 0.0 in signs.values():
                signs = dict.fromkeys(signs, 0.0)
            self._signs.update(signs)
            reached.update(group)
        self._with_slopes.update(
            (nodes[i], (sign, nodes[j])) for i, (sign, j) in zeros.with_slopes.items()
        )

    def _first_sign(self, argument: int) -> float:
        """Return the sign of the first term, those with states first, then those with inputs."""
        g = self._graph
        if g.ops[argument] != "sum":
            return 1.0
        terms = g.args[argument][1]
        for fact in (STATE, INPUT):
            for n, c in terms:
                if self._facts.of(n) & fact:
                    return 1.0 if c > 0.0 else -1.0
        return 1.0
