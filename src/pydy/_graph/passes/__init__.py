"""Rewriting passes that lower the number of operations, as an ordered list.

A pass takes a graph and roots and returns new roots in the same graph. They reassociate sums and
products, which moves results by a few roundings. A result is taken where it costs fewer operations
(`pydy._graph.simplification`). To add one is to `register` it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from pydy._graph.node import Graph
from pydy._graph.passes.expand import expand_sums
from pydy._graph.passes.factor import factor_sums
from pydy._graph.passes.merge import merge_equal

Pass = Callable[[Graph, Sequence[int]], list[int]]

ONCE: list[tuple[str, Pass]] = [("factor", factor_sums), ("merge", merge_equal)]
"""Names and passes that run first, in this order.

Common factors first: among the nodes as they come there are more that are equal, and many more to
look at.
"""

ROUND: list[tuple[str, Pass]] = [
    ("factor", factor_sums),
    ("expand", expand_sums),
    ("merge", merge_equal),
]
"""Names and passes that run next, in this order, and again while it pays."""

SHARING = ("share products", "share sums")
"""In which order factors are multiplied and terms added: decided as they are lowered (`share`)."""


def names() -> list[str]:
    """Return what a Graph may have `off`: passes, and ways to solve (`pydy._graph.solve`)."""
    rewriting = [name for name, _ in [*ONCE, *ROUND]]
    return list(dict.fromkeys(["differences", *rewriting, *SHARING, "ldl", "lu"]))


def rewriting() -> frozenset[str]:
    """Return these names without plain elimination, which rewrites nothing."""
    return frozenset(names()) - {"ldl", "lu"}


def passes_are_shipped() -> bool:
    """Return whether all passes are those of the package, none a user's."""
    return all(f.__module__.startswith("pydy.") for _, f in (*ONCE, *ROUND))


def register(name: str, function: Pass, after: str = "merge") -> None:
    """Add a pass; it runs in each round, after the one named `after`."""
    names = [name_of_pass for name_of_pass, _ in ROUND]
    ROUND.insert(names.index(after) + 1, (name, function))
