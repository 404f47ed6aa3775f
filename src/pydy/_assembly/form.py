"""Expressions in one of the forms of `generate_ode_function` into an `Assembly`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydy._assembly.assembly import Assembly, Depending
from pydy._graph.collector import collector_paused
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.node import Graph
from pydy._graph.switches import Passes
from pydy._graph.symbols import input_nodes

__all__ = ["assemble_form"]


@collector_paused()
def assemble_form(
    right_hand_side: Sequence[Any],
    coordinates: Sequence[Any],
    speeds: Sequence[Any],
    constants: Sequence[Any],
    specifieds: Sequence[Any],
    mass_matrix: Any,
    coordinate_derivatives: Sequence[Any] | None,
    outputs: Sequence[Any],
    time: Any,
    *,
    external: bool = False,
    passes: Passes | None = None,
) -> Assembly:
    """Assemble equations in one of the forms [1] x' = F, [2] M x' = F, [3] M u' = F with q' = G."""
    graph = Graph()
    states = [*coordinates, *speeds]
    atoms = input_nodes(graph, p=constants, t=[time], r=specifieds, x=states)
    read = SymPyReader(graph, atoms, "the right-hand side")
    first: list[int] = []
    if coordinate_derivatives is not None:
        read.what = "`coordinate_derivatives`"
        first = read.all(coordinate_derivatives)
        for symbol, node in zip(coordinates, first, strict=True):
            read.define(symbol.diff(time), node)
        read.what = "the right-hand side"
    forcing = read.all(right_hand_side)
    matrix: list[int] = []
    sizes = (len(states), len(specifieds), len(constants))
    n = len(forcing)
    if mass_matrix is None:
        rates = opened = forcing
    else:
        read.what = "`mass_matrix`"
        matrix = read.all(mass_matrix)
        rows = [matrix[i * n : (i + 1) * n] for i in range(n)]
        rates = [*first, *graph.solve(rows, [forcing], "lu")[0]]
        opened = [*first, *(graph.input("a", k) for k in range(n))]
    read.what = "`outputs`"

    def depending(derivatives: list[int]) -> Depending:
        own = SymPyReader(graph, dict(read.atoms), read.what)
        for symbol, node in zip(states, derivatives, strict=True):
            own.define(symbol.diff(time), node)
        values = own.all(outputs)
        return Depending(derivatives, values, values)

    return Assembly(
        graph,
        sizes,
        *depending(rates),
        mass_matrix=matrix,
        forcing=forcing,
        passes=passes or Passes(),
        open=depending(opened)._asdict() if external else {},
    )
