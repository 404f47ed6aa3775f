"""q' from equations that are zero and linear in it.

Equations that share no q' are solved apart, and those that follow from others after these: in most
models each holds one, and in the others a few, such as the three of a body-fixed sequence of
angles. No expression is a pivot: it may vanish where the equations are sound.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sm

from pydy._checks import describe
from pydy._graph import Graph, NodeExpression, SymPyReader, signatures
from pydy._mechanics.implicit import blocks_of
from pydy._mechanics.symbols import find_symbols, replace_symbols, sort_symbols
from pydy._modular import PRIME, inverse


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
        for places, columns in blocks_of(rows, own):
            block = [own[k] for k in columns]
            parts = [replace_symbols(rows[k], found) for k in places]
            found.update(zip(block, _solved(parts, block, argument), strict=True))
    missing = [rate for rate in coordinate_rates if rate not in found]
    if missing:
        raise ValueError(
            f"`{argument}` do not give {describe(missing)}: no equation holds it. Add one, such as "
            f"`{missing[0]} - u` with one of the speeds as u."
        )
    return tuple(found[rate] for rate in coordinate_rates)


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
    matrix = [[row.diff(rate) for rate in own] for row in rows]
    entries = [entry for row in matrix for entry in row]
    if any(rate in find_symbols(entries) for rate in own):
        raise ValueError(f"`{argument}` must be linear in {describe(own)}, got {describe(rows)}.")
    rest = [-replace_symbols(row, dict.fromkeys(own, sm.S.Zero)) for row in rows]
    n, graph = len(own), Graph()
    atoms = graph.input_nodes(p=sort_symbols(find_symbols([*entries, *rest])))
    read = SymPyReader(graph, atoms, f"`{argument}`")
    nodes = read.all(entries)
    cells, values = (
        [found[k : k + n] for k in range(0, n * n, n)]
        for found in (nodes, signatures(graph, nodes))
    )
    if inverse(values) is None:
        raise ValueError(
            f"`{argument}` cannot be solved for {describe(own)}: their equations depend on each "
            "other. Give as many independent equations as coordinates."
        )
    if n <= 3:  # more unknowns are solved where numbers are known
        cofactors = _cofactors(matrix)
        size = sm.Add(*(e * c for e, c in zip(matrix[0], cofactors[0], strict=True)))
        sign = {1: 1, PRIME - 1: -1}.get(signatures(graph, [read(size)])[0], size)
        columns = zip(*cofactors, strict=True)
        return [sm.Add(*map(sm.Mul, rest, column)) / sign for column in columns]
    if all(entry.is_number for entry in entries):
        return list(sm.Matrix(matrix).LUsolve(sm.Matrix(rest)))
    symbols = {node: symbol for symbol, node in atoms.items()}
    solution = graph.solve(cells, [read.all(rest)], "lu")[0]
    return [
        NodeExpression.of(graph, node, symbols, rate)
        for node, rate in zip(solution, own, strict=True)
    ]


def _cofactors(matrix: list[list[Any]]) -> list[list[Any]]:
    """Return the cofactors of a small matrix, of which nothing is multiplied out."""
    if len(matrix) == 1:
        return [[sm.S.One]]
    found = []
    for i in range(len(matrix)):
        row = []
        for j in range(len(matrix)):
            minor = [[*r[:j], *r[j + 1 :]] for k, r in enumerate(matrix) if k != i]
            size = sm.Add(*map(sm.Mul, minor[0], _cofactors(minor)[0]))
            row.append(-size if (i + j) % 2 else size)
        found.append(row)
    return found


def divide_alike(values: Sequence[Any], others: Sequence[Any]) -> bool:
    """Return whether all denominators of some values occur in others, up to sign."""
    divisors = [
        [p.base for e in part for p in sm.sympify(e).atoms(sm.Pow) if p.exp.is_negative]
        for part in (values, others)
    ]
    graph, symbols = Graph(), sort_symbols(find_symbols([*divisors[0], *divisors[1]]))
    read = SymPyReader(graph, graph.input_nodes(p=symbols), "`kd_eqs`")
    mine, theirs = map(read.all, divisors)
    found = signatures(graph, [*mine, *theirs, *map(graph.neg, theirs)])
    return set(found[: len(mine)]) <= set(found[len(mine) :])
