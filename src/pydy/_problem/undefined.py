"""The first expression of the equations that is not finite at a state: a 0/0, say."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._assembly import Assembly
from pydy._checks import shown
from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, inputs_of
from pydy._mechanics import written
from pydy._names import numbers_of
from pydy._problem.state_samples import StateSamples
from pydy._program import OPERATIONS

_SCALARS = {"sum", "prod", "const", "input", *OPERATIONS}


def first_undefined(at: StateSamples, outputs: bool) -> str | None:
    """Describe the first expression that is not finite although all that it holds is.

    That is one of q', loads, masses and constraints, before accelerations are solved for, else of
    `outputs`.
    """
    assembly, layout = at.model.assembly, at.definition.layout
    graph = assembly.graph
    groups = {"x": at.x[0], "p": np.atleast_2d(at.p)[0], "r": at.r[0], "t": at.t[:1]}
    names = {"t": [at.definition.equations.time], "x": layout.states}
    names |= {"p": layout.constants, "r": layout.specifieds}
    symbols = {graph.input(g, k): s for g, part in names.items() for k, s in enumerate(part)}
    for roots in (_unsolved(assembly), assembly.blocks.outputs if outputs else ()):
        nodes = [n for n in graph.reachable(roots, fallbacks=False) if graph.ops[n] in _SCALARS]
        inputs = inputs_of(graph, nodes)
        if any(group not in groups for group, _ in inputs.values()):
            continue  # what holds accelerations
        known = {n: groups[group][k] for n, (group, k) in inputs.items()}
        with np.errstate(all="ignore"):
            values = dict(zip(nodes, graph.evaluator(nodes)(known, 1)[0], strict=True))
        for node in nodes:
            if not np.isfinite(values[node]) and _defined(graph, node, values):
                return _described(graph, node, values, symbols)
    return None


def _unsolved(assembly: Assembly) -> list[int]:
    """Return what the equations are made of, or the rates where there is nothing to solve."""
    speeds, blocks = assembly.speeds, assembly.blocks
    if not speeds or len(blocks.forcing) != len(speeds):
        return blocks.rates
    first = assembly.graph.args[speeds[0]][1]
    return [*blocks.rates[:first], *blocks.forcing, *blocks.mass_matrix, *blocks.velocity]


def _defined(graph: Graph, node: int, values: dict[int, float]) -> bool:
    """Return whether all operands have values, which are finite."""
    return all(np.isfinite(values.get(n, np.nan)) for n in graph.operands(node))


def _described(
    graph: Graph, node: int, values: dict[int, float], symbols: dict[int, Any]
) -> str | None:
    inputs = inputs_of(graph, [node])
    try:
        (expression,), _ = written(graph, [node], symbols)
    except (KeyError, UnsupportedFunctionError):
        return None
    value = f"{values[node]:g}"
    if graph.ops[node] == "prod":
        factors = graph.args[node]
        over = float(np.prod([values[n] ** e for n, e in factors if e > 0]))
        if any(values[n] == 0.0 for n, e in factors if e < 0):
            value = f"{over:g}/0"
    at = numbers_of([symbols[n] for n in inputs], [values[n] for n in inputs])
    example = ": divide a slip by `sqrt(v**2 + eps**2)` in place of v" * (value == "0/0")
    return (
        f"The first expression that is not finite is `{shown(expression)}` = {value}, at {at}. "
        f"Start where it is finite, or write one that is finite there too{example}."
    )
