"""Noncontributing forces that a method's equations of motion are written with, but do not need."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.identities import signatures
from pydy._graph.node import Graph
from pydy._graph.symbols import input_nodes
from pydy._mechanics.symbols import find_symbols, replace_symbols

__all__ = ["without_idle"]


def without_idle(
    forcing: Sequence[Any], auxiliary_equations: Iterable[Any], states: Collection[Any]
) -> tuple[Any, ...]:
    """Return the forcing without the forces of the auxiliary equations that cancel in it.

    A method does not simplify: with dependent speeds a contact force may be left as r R − r R.
    """
    held = find_symbols(forcing)
    forces = [
        s
        for s in find_symbols(auxiliary_equations)
        if isinstance(s, AppliedUndef) and s in held and s not in states
    ]
    if not forces:
        return tuple(forcing)
    graph = Graph()
    atoms = input_nodes(graph, x=held)
    nodes = SymPyReader(graph, atoms, "the equations of motion").all(forcing)
    slopes: dict[int, list[int]] = {k: [] for k in range(len(forces))}
    for row in jacobian(graph, nodes, [atoms[s] for s in forces]):
        for k, node in row.items():
            slopes[k].append(node)
    idle = [
        f for f, own in zip(forces, slopes.values(), strict=True) if not any(signatures(graph, own))
    ]
    nothing = dict.fromkeys(idle, sm.S.Zero)
    return tuple(replace_symbols(e, nothing) for e in forcing) if idle else tuple(forcing)
