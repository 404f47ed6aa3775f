"""q' from equations that are zero and linear in it.

Equations that share no q' are solved apart: in most models each holds one, and in the others a few,
such as the three of a body-fixed sequence of angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sm

from pydy._checks import describe
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.identities import signatures
from pydy._graph.node import Graph, input_nodes
from pydy._mechanics.symbols import find_symbols, replace_symbols, sort_symbols

_BY_MINORS = 3  # unknowns; Cramer's rule divides by nothing but the determinant


def solve_rates(
    equations: Sequence[Any], coordinate_rates: Sequence[Any], argument: str
) -> tuple[Any, ...]:
    """Return q' from equations that are zero, linear in q'."""
    order = {rate: k for k, rate in enumerate(coordinate_rates)}
    unknowns = [[s for s in find_symbols([e]) if s in order] for e in equations]
    found: dict[Any, Any] = {}
    for group in connected(unknowns):
        own = sorted({s for k in group for s in unknowns[k]}, key=order.__getitem__)
        rows = [equations[k] for k in group]
        if len(own) != len(group):
            raise ValueError(
                f"`{argument}` must give each coordinate's derivative once: {len(rows)} equations "
                f"hold {describe(own)}. Each equation must be zero, and contain derivatives of "
                "coordinates."
            )
        found.update(zip(own, _solved(rows, own, argument), strict=True))
    missing = [rate for rate in coordinate_rates if rate not in found]
    if missing:
        raise ValueError(
            f"`{argument}` do not give {describe(missing)}: no equation holds it. Add one, such as "
            f"`{missing[0]} - u` with one of the speeds as u."
        )
    return tuple(found[rate] for rate in coordinate_rates)


def by_minors(equations: Sequence[Any], coordinate_rates: Sequence[Any]) -> bool:
    """Return whether `solve_rates` divides by determinants alone."""
    unknowns = [[s for s in find_symbols([e]) if s in coordinate_rates] for e in equations]
    return all(len(group) <= _BY_MINORS for group in connected(unknowns))


def connected(unknowns: list[list[Any]]) -> list[list[int]]:
    """Return the places of rows in groups that share unknowns, in order."""
    home: dict[Any, list[int]] = {}
    for k, symbols in enumerate(unknowns):
        merged = [k]
        for group in {id(home[s]): home[s] for s in symbols if s in home}.values():
            merged += group
        for j in merged:
            home.update(dict.fromkeys(unknowns[j], merged))
    groups = {id(group): sorted(group) for group in home.values()}
    return [*groups.values(), *([k] for k, symbols in enumerate(unknowns) if not symbols)]


def _solved(rows: list[Any], own: list[Any], argument: str) -> list[Any]:
    if len(own) == 1:  # mostly q' less an expression, where SymPy's derivatives would take long
        for trial in (own[0] - rows[0], own[0] + rows[0]):
            if own[0] not in find_symbols([trial]):
                return [trial]
    matrix = sm.Matrix([[row.diff(rate) for rate in own] for row in rows])
    if any(rate in find_symbols(matrix) for rate in own):
        raise ValueError(f"`{argument}` must be linear in {describe(own)}, got {describe(rows)}.")
    rest = sm.Matrix([replace_symbols(row, dict.fromkeys(own, sm.S.Zero)) for row in rows])
    if len(own) > _BY_MINORS:
        _check_regular(matrix.det(method="berkowitz"), own, argument)
        return list(matrix.LUsolve(-rest))
    size = matrix.det()
    _check_regular(size, own, argument)
    if size in (1, -1):
        return list(-size * (matrix.adjugate() * rest))
    return [-part / size for part in matrix.adjugate() * rest]


def divide_alike(values: Sequence[Any], others: Sequence[Any]) -> bool:
    """Return whether all that is divided by in values is so in others, but for its sign."""
    divisors = [
        [p.base for e in part for p in sm.sympify(e).atoms(sm.Pow) if p.exp.is_negative]
        for part in (values, others)
    ]
    graph, symbols = Graph(), sort_symbols(find_symbols([*divisors[0], *divisors[1]]))
    read = SymPyReader(graph, input_nodes(graph, p=symbols), "`kd_eqs`")
    mine, theirs = map(read.all, divisors)
    found = signatures(graph, [*mine, *theirs, *map(graph.neg, theirs)])
    return set(found[: len(mine)]) <= set(found[len(mine) :])


def _check_regular(determinant: Any, own: list[Any], argument: str) -> None:
    symbols = sort_symbols(find_symbols([determinant]))
    graph = Graph()
    node = SymPyReader(graph, input_nodes(graph, p=symbols), f"`{argument}`")(determinant)
    if not signatures(graph, [node])[0]:
        raise ValueError(
            f"`{argument}` cannot be solved for {describe(own)}: their equations depend on each "
            "other. Give as many independent equations as coordinates."
        )
