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
from pydy._graph.interpret import run
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._graph.switches import Passes
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
    return all(
        (abs(v) <= CANCELLING * size).all() and (size > 0.0).all()
        for v, size in _with_sizes(graph, rest)
    )


def _with_sizes(graph: Graph, nodes: Sequence[int]) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return values at random states, and what they would be if all terms had one sign."""
    leaves = _leaves(graph, nodes)
    nodes = substitute(graph, nodes, {n: graph.input("x", k) for k, n in enumerate(leaves)})
    written: list[int] = []
    terms: list[int] = []
    for n in graph.reachable(nodes):
        (written if graph.ops[n] in ("sum", "prod") else terms).append(n)
    used = {m for n in (*written, *nodes) for m in graph.operands(n)} | {*nodes}
    terms = [n for n in terms if n in used]
    program = lower(
        graph, (len(leaves), 0, 0), [("terms", (len(terms),), terms)], passes=Passes.none()
    )
    x = np.random.default_rng(0).uniform(0.5, 1.5, (_STATES, len(leaves)))
    found, _ = run(program, np.zeros(_STATES), x, np.zeros((_STATES, 0)), np.zeros(0))
    known = {n: (found[:, k], abs(found[:, k])) for k, n in enumerate(terms)}
    for n in written:
        if graph.ops[n] == "sum":
            first, rest = graph.args[n]
            values = first + sum(c * known[m][0] for m, c in rest)
            known[n] = values, abs(first) + sum(abs(c) * known[m][1] for m, c in rest)
        else:
            parts = graph.args[n]
            # Of a denominator the value counts: it is as large as it is.
            known[n] = (
                np.prod([known[m][0] ** float(e) for m, e in parts], axis=0),
                np.prod(
                    [(known[m][1] if e > 0 else abs(known[m][0])) ** float(e) for m, e in parts],
                    axis=0,
                ),
            )
    return [known[n] for n in nodes]


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
