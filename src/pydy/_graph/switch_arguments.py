"""The signs of what switches, beside the states where it is zero, on one side for all."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.common_zeros import Pairs, Touching, common_zeros
from pydy._graph.facts import INPUT, SOLVED, STATE, NodeFacts
from pydy._graph.node import Graph
from pydy._graph.tuning import MOST_ARGUMENTS

_SWITCHES = frozenset({"lt", "le", "min", "max", "abs", "sign"})


class SwitchArguments:
    """The arguments of all switches of a graph, and their signs on the side of derivatives."""

    def __init__(self, graph: Graph, facts: NodeFacts) -> None:
        self._graph, self._facts = graph, facts
        self._signs: dict[int, float] = {}
        self._searched = 0  # nodes among which arguments were searched

    def copy(self, graph: Graph, facts: NodeFacts) -> SwitchArguments:
        """Return the same for a copy of the graph."""
        twin = SwitchArguments(graph, facts)
        twin._signs, twin._searched = self._signs.copy(), self._searched
        return twin

    def sign(self, argument: int) -> float:
        """Return the sign of an argument, or 0.0 if it is that of its slope at the state."""
        if argument not in self._signs:
            self._search(argument)
        return self._signs[argument]

    def argument(self, a: int, b: int) -> tuple[float, int]:
        """Return a factor and a node with the sign of a − b, which is the same for b − a."""
        factor, node = self._graph.scaled(self._graph.sub(a, b))
        if self._graph.ops[node] == "prod":
            odd = [n for n, e in self._graph.args[node] if e % 2]
            node = self._graph.product([(n, 1) for n in odd])
        opposite = self._graph.neg(node)
        return (factor, node) if node < opposite else (-factor, opposite)

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
            self._join(moving, *common_zeros(g, moving))

    def _join(self, nodes: Sequence[int], pairs: Pairs, touching: Touching) -> None:
        """Give nodes that are zero together signs of one side."""
        neighbours: dict[int, list[tuple[int, float]]] = {}
        for (i, j), product in pairs.items():
            neighbours.setdefault(nodes[i], []).append((nodes[j], product))
            neighbours.setdefault(nodes[j], []).append((nodes[i], product))
        reached: set[int] = set()
        own = {nodes[i]: sign for i, sign in touching.items()}
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
