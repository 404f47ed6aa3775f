"""Which input of a graph stands for each symbol."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from pydy._graph.node import Graph


def input_nodes(graph: Graph, **groups: Iterable[Any]) -> dict[Any, int]:
    """Return the input node of each symbol; the graph gets them in the order of the arguments.

    Each group of inputs has its symbols in order: ``x=states, t=[time]``. A symbol in several
    groups belongs to the last.
    """
    return {s: graph.input(g, k) for g, symbols in groups.items() for k, s in enumerate(symbols)}


def input_symbols(graph: Graph, **groups: Iterable[Any]) -> dict[int, Any]:
    """Return the symbol of each input node; the groups are those of `input_nodes`."""
    return {graph.input(g, k): s for g, symbols in groups.items() for k, s in enumerate(symbols)}
