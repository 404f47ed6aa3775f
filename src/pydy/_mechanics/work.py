"""Generalised forces from the power of loads, by the structure of the expressions."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import sympy as sm

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, jacobian, rounding_bounds
from pydy._mechanics.components import numbers_across
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import find_symbols
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, TimeFunction

# A sum of terms, each with its number, for each speed.
_Linear: TypeAlias = "dict[AnySymbol, dict[sm.Expr, sm.Expr]]"


def forces_of_power(
    powers: Iterable[sm.Expr], speeds: Collection[AnySymbol]
) -> dict[AnySymbol, sm.Expr] | None:
    """Return the coefficient of each speed in a sum of powers, without those that are zero.

    None if a power is not recognised as linear in the speeds. Equal terms are collected on the fly:
    in a chain the velocity of each body is the sum of all rates before it, and those of two
    opposite forces cancel. SymPy's polynomials in all speeds and coordinates of n bodies would have
    n² terms of n exponents.
    """
    speed_set = {*speeds}
    total: _Linear = {}
    for power in powers:
        parts = _linear(sm.sympify(power), speed_set)
        if parts is None:
            return None
        for speed, terms in parts.items():
            _collect(total.setdefault(speed, {}), terms)
    sums = ((u, sm.Add(*(n * e for e, n in total[u].items()))) for u in speeds if u in total)
    forces = ((u, sm.expand(force)) for u, force in sums if force != 0)
    return {u: force for u, force in forces if force != 0}


def _linear(expression: sm.Expr, speeds: set[AnySymbol]) -> _Linear | None:
    if expression in speeds:
        return {expression: {sm.S.One: sm.S.One}}
    if expression.is_Add:
        total: _Linear = {}
        for term in expression.args:
            parts = _linear(term, speeds)
            if parts is None:
                return None
            for speed, terms in parts.items():
                _collect(total.setdefault(speed, {}), terms)
        return total
    if not expression.is_Mul:
        return {} if expression == 0 else None
    moving = [e for e in expression.args if not speeds.isdisjoint(find_symbols([e]))]
    parts = _linear(moving[0], speeds) if len(moving) == 1 else None
    if parts is None:
        return None
    factors = (e for e in expression.args if e is not moving[0])
    number, factor = sm.Mul(*factors).as_coeff_Mul()
    return {u: _multiplied(terms, number, factor) for u, terms in parts.items()}


def _multiplied(
    terms: dict[sm.Expr, sm.Expr], number: sm.Expr, factor: sm.Expr
) -> dict[sm.Expr, sm.Expr]:
    scaled: dict[sm.Expr, sm.Expr] = {}
    for term, share in terms.items():
        coefficient, product = (1, factor) if term is sm.S.One else (term * factor).as_coeff_Mul()
        _collect(scaled, {product: share * coefficient * number})
    return scaled


def _collect(total: dict[sm.Expr, sm.Expr], terms: dict[sm.Expr, sm.Expr]) -> None:
    for term, number in terms.items():
        total[term] = total[term] + number if term in total else number


def has_quotients(expression: sm.Expr) -> bool:
    """Return whether an expression has a sum in a denominator or under a root."""
    return any(
        p.base.has(sm.Add) and not (p.exp.is_Integer and p.exp > 0)
        for p in expression.atoms(sm.Pow)
    )


def may_be_exact(
    powers: Sequence[sm.Expr],
    coordinates: Mapping[AnySymbol, TimeFunction],
    turns: Iterable[sm.Matrix],
) -> list[bool]:
    """Return for each power, and last for their sum, whether its work may have a potential.

    The generalised forces along `coordinates`, given by their rates, must satisfy
    ∂Fᵢ/∂qⱼ = ∂Fⱼ/∂qᵢ, up to rounding. A torque of a wheel has many terms, of which none has a
    potential: this numeric test excludes them before SymPy expands and integrates them, one by one.
    Coordinates along which no force acts are not compared, since constraints may fix them.
    """
    graph = Graph()
    read = InputReader(graph, {}, ())
    undecided = [True] * (len(powers) + 1)
    try:
        nodes = read.all(powers)
        nodes.append(graph.sum([(node, 1.0) for node in nodes]))
        rates, q = read.all(coordinates), read.all(coordinates.values())
        zero_rows = orthogonality_residuals(turns, read)
    except UnsupportedFunctionError:  # SymPy may still integrate it
        return undecided
    forces = np.reshape(jacobian(graph, nodes, rates).flat(), (len(nodes), len(rates)))
    rows, pairs = [], []
    for row, force in enumerate(forces.tolist()):
        acting = [k for k, node in enumerate(force) if node != graph.zero]
        slopes = np.reshape(
            jacobian(graph, [force[k] for k in acting], [q[k] for k in acting]).flat(),
            (len(acting), len(acting)),
        )
        for i, j in combinations(range(len(acting)), 2):
            rows.append(row)
            pairs.append([slopes[i, j], slopes[j, i], force[acting[i]], force[acting[j]]])
    if not pairs:
        return undecided
    cells = [int(node) for pair in pairs for node in pair]
    with np.errstate(invalid="ignore"):
        values, bounds = (
            numbers_across(
                graph, [*cells, *rounding_bounds(graph, cells, constants=True)], nodes, zero_rows
            )
            .reshape(-1, 2, len(pairs), 4)
            .swapaxes(0, 1)
        )
        unequal = np.abs(values[..., 0] - values[..., 1]) > ROUNDED * bounds[..., :2].sum(axis=2)
        # A force may cancel although its node is not zero.
        both_act = (np.abs(values[..., 2:]) > ROUNDED * bounds[..., 2:]).all(axis=2)
    differ = (unequal & both_act).any(axis=0)
    path_dependent = {row for row, different in zip(rows, differ, strict=True) if different}
    return [row not in path_dependent for row in range(len(nodes))]
