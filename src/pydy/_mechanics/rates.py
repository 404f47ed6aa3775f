"""Solution of the kinematic differential equations, linear in q', for q'.

Equations that share no q' are solved separately, in blocks that are solved in turn: in most models
each equation has one unknown, in others a few, such as the three of a body-fixed sequence of
angles. No expression is used as a pivot: it may vanish where the equations are regular.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence

import sympy as sm

from pydy._checks import describe
from pydy._graph import Graph, LinearSystem, NodeExpression, SymPyReader, signatures
from pydy._mechanics.implicit import blocks_of
from pydy._mechanics.symbols import find_symbols, replace_symbols, sort_symbols
from pydy._modular import PRIME, inverse
from pydy._names import counted


def solve_rates(
    equations: Sequence[sm.Expr], coordinate_rates: Sequence[sm.Derivative], argument: str
) -> tuple[sm.Expr, ...]:
    """Return q' from equations that are zero, linear in q'."""
    order = {rate: k for k, rate in enumerate(coordinate_rates)}
    unknowns = [[s for s in find_symbols([e]) if s in order] for e in equations]
    rates: dict[sm.Derivative, sm.Expr] = {}
    for group in connected(unknowns):
        group_rates = sorted({s for k in group for s in unknowns[k]}, key=order.__getitem__)
        rows = [equations[k] for k in group]
        if len(group_rates) != len(group):
            message = (
                f"`{argument}` must give each coordinate's derivative once, got "
                f"{counted(len(rows), 'equation')} for {describe(group_rates)}. Each equation "
                "must be zero, and contain derivatives of coordinates."
            )
            if len(group_rates) == len(group) + 1 == 4:
                length = " + ".join(f"{rate.expr.func}*{rate.expr.func}'" for rate in group_rates)
                message += f" If these are a quaternion, add {length}: its length is constant."
            raise ValueError(message)
        for numbers, columns in blocks_of(rows, group_rates):
            block = [group_rates[k] for k in columns]
            parts = [replace_symbols(rows[k], rates) for k in numbers]
            rates.update(zip(block, _solved(parts, block, argument), strict=True))
    missing = [rate for rate in coordinate_rates if rate not in rates]
    if missing:
        raise ValueError(
            f"`{argument}` do not give {describe(missing)}. Add an equation, such as "
            f"`{missing[0]} - u` with one of the speeds as u."
        )
    return tuple(rates[rate] for rate in coordinate_rates)


def connected(unknowns: Sequence[Sequence[Hashable]]) -> list[list[int]]:
    """Return the numbers of rows in groups that share unknowns, in order."""
    home: dict[Hashable, list[int]] = {}
    for k, symbols in enumerate(unknowns):
        merged = [k]
        for group in {id(home[s]): home[s] for s in symbols if s in home}.values():
            merged += group
        for j in merged:
            home.update(dict.fromkeys(unknowns[j], merged))
    groups = {id(group): sorted(group) for group in home.values()}
    return [*groups.values(), *([k] for k, symbols in enumerate(unknowns) if not symbols)]


def _solved(rows: list[sm.Expr], unknowns: list[sm.Derivative], argument: str) -> list[sm.Expr]:
    if len(unknowns) == 1:  # mostly q' minus an expression: SymPy's derivatives would be slow
        for trial in (unknowns[0] - rows[0], unknowns[0] + rows[0]):
            if unknowns[0] not in find_symbols([trial]):
                return [trial]
    matrix = [[row.diff(rate) for rate in unknowns] for row in rows]
    entries = [entry for row in matrix for entry in row]
    if any(rate in find_symbols(entries) for rate in unknowns):
        raise ValueError(
            f"`{argument}` must be linear in {describe(unknowns)}, got {describe(rows)}."
        )
    constants = [-replace_symbols(row, dict.fromkeys(unknowns, sm.S.Zero)) for row in rows]
    n, graph = len(unknowns), Graph()
    symbols = sort_symbols(find_symbols([*entries, *constants]))
    read = SymPyReader.of_inputs(graph, f"`{argument}`", p=symbols)
    nodes = read.all(entries)
    cells, values = (
        [cells_[k : k + n] for k in range(0, n * n, n)]
        for cells_ in (nodes, signatures(graph, nodes))
    )
    if inverse(values) is None:
        raise ValueError(
            f"`{argument}` cannot be solved for {describe(unknowns)}: their equations depend on "
            "each other. Give as many independent equations as coordinates."
        )
    if n <= 3:  # systems of more unknowns are solved numerically
        cofactors = _cofactors(matrix)
        size = sm.Add(*(e * c for e, c in zip(matrix[0], cofactors[0], strict=True)))
        sign = {1: 1, PRIME - 1: -1}.get(signatures(graph, [read(size)])[0], size)
        columns = zip(*cofactors, strict=True)
        return [sm.Add(*map(sm.Mul, constants, column)) / sign for column in columns]
    if all(entry.is_number for entry in entries):
        return list(sm.Matrix(matrix).LUsolve(sm.Matrix(constants)))
    symbol_of = {node: symbol for symbol, node in read.atoms.items()}
    solution = LinearSystem(graph, cells).solve(read.all(constants))
    return [
        NodeExpression.of(graph, node, symbol_of, rate)
        for node, rate in zip(solution, unknowns, strict=True)
    ]


def _cofactors(matrix: list[list[sm.Expr]]) -> list[list[sm.Expr]]:
    """Return the cofactors of a small matrix, without expanding products."""
    if len(matrix) == 1:
        return [[sm.S.One]]
    cofactors = []
    for i in range(len(matrix)):
        row = []
        for j in range(len(matrix)):
            minor = [[*r[:j], *r[j + 1 :]] for k, r in enumerate(matrix) if k != i]
            size = sm.Add(*map(sm.Mul, minor[0], _cofactors(minor)[0]))
            row.append(-size if (i + j) % 2 else size)
        cofactors.append(row)
    return cofactors


def divide_alike(values: Sequence[sm.Expr], reference: Sequence[sm.Expr]) -> bool:
    """Return whether all denominators of `values` occur in `reference`, up to sign."""
    divisors = [
        [p.base for e in part for p in sm.sympify(e).atoms(sm.Pow) if p.exp.is_negative]
        for part in (values, reference)
    ]
    graph, symbols = Graph(), sort_symbols(find_symbols([*divisors[0], *divisors[1]]))
    read = SymPyReader.of_inputs(graph, "`kd_eqs`", p=symbols)
    mine, theirs = map(read.all, divisors)
    signature = signatures(graph, [*mine, *theirs, *map(graph.neg, theirs)])
    return set(signature[: len(mine)]) <= set(signature[len(mine) :])
