"""Run the passes that lower the number of operations."""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.node import Graph
from pydy._graph.passes import ONCE, ROUND, Pass
from pydy._graph.rewrite import substitute


def simplify(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Return roots that cost fewer operations, by all passes that the graph does not have `off`."""
    guards = [n for n in graph.reachable(roots) if graph.ops[n] == "guard"]
    if guards:
        return _around_guards(graph, roots, guards)
    run = _Run(graph, roots)
    run.run_passes(ONCE)
    before = run.cost
    # Only new equal nodes give factors that the first round of passes did not see.
    # Where merging saves 0.8 % or more, the second round saves 1.6 % (rider-bicycle) to 4.6 %
    # (relative pendulum); where it saves less, 0.6 % at most, for a fifth of the whole build.
    if run.run_passes(ROUND) >= 0.0075 * before:
        run.run_passes(ROUND)
    _record_systems(graph, roots, run.nodes)
    return run.nodes


def _record_systems(graph: Graph, roots: Sequence[int], simplified: Sequence[int]) -> None:
    """Record which linear system each one of simplified nodes was before.

    In simplified entries constants are joined already, which residuals would join otherwise.
    """
    solves = [
        [k for k in graph.reachable(r) if graph.ops[k] == "solve"] for r in (roots, simplified)
    ]
    # Of several systems nothing says which one became which.
    if all(len(nodes) == 1 for nodes in solves):
        (before,), (after,) = solves
        graph.systems[after] = before


class _Run:
    """The nodes after the passes so far."""

    def __init__(self, graph: Graph, roots: Sequence[int]) -> None:
        self.graph = graph
        self.nodes = list(roots)
        self._counts: dict[int, int] = {}
        self.cost = operation_count(graph, roots, self._counts)
        self._results: dict[str, list[int]] = {}  # the last result of each pass

    def run_passes(self, passes: Sequence[tuple[str, Pass]]) -> int:
        """Run passes one after another, keeping cheaper results; return the savings by merging."""
        merged = 0
        for name, function in passes:
            if name in self.graph.off or self._results.get(name) == self.nodes:
                continue
            tried = function(self.graph, self.nodes)
            if tried != self.nodes:
                cost = operation_count(self.graph, tried, self._counts)
                if cost < self.cost:
                    merged += self.cost - cost if name == "merge" else 0
                    self.nodes, self.cost = tried, cost
            self._results[name] = self.nodes
        return merged


def _around_guards(graph: Graph, roots: Sequence[int], guards: Sequence[int]) -> list[int]:
    """Simplify operations of every call, but not those for guards' fallbacks."""
    away = {guard: graph.input("guard", k) for k, guard in enumerate(guards)}
    hot = [[graph.args[guard][3], *graph.args[guard][4]] for guard in guards]
    every = substitute(graph, [*roots, *(n for part in hot for n in part)], away)
    nodes = iter(simplify(graph, every))
    new_roots = [next(nodes) for _ in roots]
    back: dict[int, int] = {}
    for guard, part in zip(guards, hot, strict=True):
        n, entries, column = graph.args[guard][:3]
        sound, *fast = substitute(graph, [next(nodes) for _ in part], back)
        back[away[guard]] = graph.make("guard", (n, entries, column, sound, tuple(fast)))
    return substitute(graph, new_roots, back)


# -- What nodes cost before they are lowered -------------------------------------------------------


def operation_count(
    graph: Graph, roots: Sequence[int], counts: dict[int, int] | None = None
) -> int:
    """Estimate the operations of every call: nothing shared but whole nodes.

    Pass `counts`, the operations of single nodes, to reuse them in repeated calls.
    """
    counts = {} if counts is None else counts
    nodes = graph.reachable(roots)
    for node in nodes:
        if node not in counts:
            counts[node] = _operations_of(graph, node)
    return sum(map(counts.__getitem__, nodes))


def _operations_of(graph: Graph, node: int) -> int:
    """Estimate a node's own operations."""
    constant, op, args = graph.constant, graph.ops[node], graph.args[node]
    if constant[node] or op in ("input", "factor", "solve", "guard", "item", "kept"):
        return 0
    if op == "sum":
        c0, terms = args
        moving = [c for n, c in terms if not constant[n]]
        count: int = len(moving) - 1 + (len(moving) < len(terms) or c0 != 0.0)
        return count + sum(1 for c in moving if abs(c) != 1.0)
    if op == "prod":
        powers = [abs(e) for n, e in args if not constant[n]]
        count = len(powers) - 1 + (len(powers) < len(args))
        return count + sum(int(e).bit_length() - 1 for e in powers)
    return 1
