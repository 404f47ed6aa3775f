"""Which input of the compiled code each symbol is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydy._graph.node import Graph

__all__ = ["input_nodes"]


def input_nodes(
    graph: Graph,
    time: Any,
    states: Sequence[Any],
    specifieds: Sequence[Any],
    constants: Sequence[Any],
) -> dict[Any, int]:
    """Return the input node of each symbol: time, x, r and p, which are created in the graph."""
    atoms: dict[Any, int] = {s: graph.input("p", k) for k, s in enumerate(constants)}
    atoms[time] = graph.input("t", 0)
    atoms.update((s, graph.input("r", k)) for k, s in enumerate(specifieds))
    atoms.update((s, graph.input("x", k)) for k, s in enumerate(states))
    return atoms
