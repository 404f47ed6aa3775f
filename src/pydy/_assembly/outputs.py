"""Outputs beside the equations of motion, in groups, of which some are linear equations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from pydy._graph.derivative import dense_rows, jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._mechanics.equations import Equations
from pydy._mechanics.symbols import find_symbols

__all__ = ["Group", "auxiliary_groups", "evaluate_groups"]


@dataclass(frozen=True)
class Group:
    """Outputs that are given together.

    Attributes
    ----------
    names : tuple of symbols or functions of time
    expressions : tuple of expressions
        Values, or equations that are zero, when they contain the names themselves.
    """

    names: tuple[Any, ...]
    expressions: tuple[Any, ...]


def auxiliary_groups(equations: Equations, groups: Sequence[Group]) -> list[bool]:
    """Tell which groups are integrated: those with their own names and derivatives of speeds."""
    rates = set(equations.speed_rates)
    flags = []
    for group in groups:
        found = find_symbols(group.expressions)
        flags.append(any(n in found for n in group.names) and any(s in rates for s in found))
    return flags


def evaluate_groups(
    graph: Graph, read: SymPyReader, groups: Sequence[Group], known: dict[int, int]
) -> list[list[int]]:
    """Return the values of each group, solving those that are given as linear equations."""
    own: list[list[int]] = []
    count = 0
    for group in groups:
        own.append([graph.input("y", count + k) for k in range(len(group.names))])
        count += len(group.names)
        for name, node in zip(group.names, own[-1], strict=True):
            read.define(name, node)
    formulas = [read.all(group.expressions) for group in groups]
    values: list[list[int] | None] = [None] * len(groups)
    owner = {node: k for k, nodes in enumerate(own) for node in nodes}
    known = dict(known)
    waiting = list(range(len(groups)))
    while waiting:
        ready = []
        for k in waiting:
            needs = {owner[n] for n in graph.reachable(formulas[k]) if n in owner} - {k}
            if all(values[j] is not None for j in needs):
                ready.append(k)
        if not ready:
            names = ", ".join(str(n) for k in waiting for n in groups[k].names)
            raise ValueError(
                f"Circular definition in `outputs`: {names} refer to each other. Give them as one "
                "group, a tuple of names mapped to as many equations."
            )
        for k in ready:
            nodes = substitute(graph, formulas[k], known)
            solved = _solve_group(graph, groups[k], nodes, own[k])
            values[k] = solved
            known.update(zip(own[k], solved, strict=True))
            waiting.remove(k)
    return [v for v in values if v is not None]


def _solve_group(graph: Graph, group: Group, nodes: list[int], own: list[int]) -> list[int]:
    if not set(own) & set(graph.reachable(nodes)):
        return nodes
    n = len(own)
    rows = jacobian(graph, nodes, own)
    names = ", ".join(map(str, group.names))
    if set(own) & set(graph.reachable([d for row in rows for d in row.values()])):
        raise ValueError(
            f"`outputs` for {names} are nonlinear in {names}. Equations that contain their own "
            "names must be linear in them; solve them for the names first."
        )
    for k in range(n):
        if not rows[k] or not any(k in row for row in rows):
            raise ValueError(
                f"`outputs` for {names} cannot be solved for {names}: there must be as many "
                "independent equations as names."
            )
    rest = substitute(graph, nodes, dict.fromkeys(own, graph.zero))
    right = [graph.neg(node) for node in rest]
    # One unknown an equation, with a number before it, needs no solve.
    if all(len(row) == 1 and graph.value(next(iter(row.values()))) for row in rows):
        places = {next(iter(row)): i for i, row in enumerate(rows)}
        if len(places) == n:
            return [graph.div(right[places[k]], rows[places[k]][k]) for k in range(n)]
    return graph.solve(dense_rows(graph, rows, n), [right], "lu")[0]
