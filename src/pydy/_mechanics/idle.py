"""Noncontributing forces that equations of motion are written with, but do not depend on.

They cancel, but nobody simplifies: with dependent speeds a contact force may be left as r R − r R.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.identities import signatures
from pydy._graph.interpret import evaluator
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._graph.rounding import rounding_bounds
from pydy._graph.symbols import input_nodes
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._mechanics.tuning import CANCELLING

__all__ = ["idle_inputs", "without_idle"]

_STATES = 2
# Functions that are the same everywhere if they are so at random states; min, max and roots are
# not, and stand for themselves.
_MEROMORPHIC = frozenset(("sum", "prod", "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"))


def without_idle(
    forcing: Sequence[Any], auxiliary_equations: Iterable[Any], states: Collection[Any]
) -> tuple[Any, ...]:
    """Return the forcing without the forces of the auxiliary equations that cancel in it."""
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
    idle = set(idle_inputs(graph, nodes, [atoms[s] for s in forces]))
    nothing = {s: sm.S.Zero for s in forces if atoms[s] in idle}
    return tuple(replace_symbols(e, nothing) for e in forcing) if nothing else tuple(forcing)


def idle_inputs(graph: Graph, forcing: Sequence[int], inputs: Sequence[int]) -> list[int]:
    """Return the inputs that are in the forcing, which does not change with them."""
    slopes: dict[int, list[int]] = {n: [] for n in inputs}
    for row in jacobian(graph, forcing, inputs):
        for k, node in row.items():
            slopes[inputs[k]].append(node)
    return [n for n, own in slopes.items() if _vanish(graph, own)]


def _vanish(graph: Graph, nodes: Sequence[int]) -> bool:
    """Return whether nodes are zero as functions."""
    rest = [n for n in nodes if n != graph.zero]
    if not rest or not any(signatures(graph, rest)):
        return True
    # Identities of angles are not seen modulo a prime.
    leaves = _leaves(graph, rest)
    inputs = [graph.input("x", k) for k in range(len(leaves))]
    rest = substitute(graph, rest, dict(zip(leaves, inputs, strict=True)))
    values_at = evaluator(graph, [*rest, *rounding_bounds(graph, rest)])
    x = np.random.default_rng(0).uniform(0.5, 1.5, (len(leaves), _STATES))
    found = values_at(dict(zip(inputs, x, strict=True)), _STATES)
    left, bounds = np.hsplit(np.abs(found), 2)
    return bool(((left <= CANCELLING * bounds) & (bounds > 0.0)).all())


def _leaves(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return the inputs, and what is looked at as if it were one."""
    found: dict[int, None] = {}
    seen, left = set(nodes), list(nodes)
    while left:
        n = left.pop()
        if graph.ops[n] in _MEROMORPHIC:
            new = [m for m in graph.operands(n) if m not in seen]
            seen.update(new)
            left += new
        elif graph.ops[n] != "const":
            found[n] = None
    return list(found)
