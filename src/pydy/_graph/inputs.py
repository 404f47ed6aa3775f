"""The inputs that nodes depend on."""

from __future__ import annotations

from collections.abc import Iterable

from pydy._graph.node import Graph


class InputsOfNodes(dict[int, tuple[str, int]]):
    """Input nodes, in topological order, each with its group and its index there."""

    @property
    def groups(self) -> set[str]:
        """The groups, such as 't', 'x' and 'p'."""
        return {group for group, _ in self.values()}

    @property
    def moving(self) -> list[int]:
        """The nodes of those that are no constants."""
        return [node for node, (group, _) in self.items() if group != "p"]


def inputs_of(graph: Graph, roots: Iterable[int]) -> InputsOfNodes:
    """Return the inputs that the roots depend on."""
    ops, args = graph.ops, graph.args
    return InputsOfNodes({n: args[n] for n in graph.reachable(roots) if ops[n] == "input"})
