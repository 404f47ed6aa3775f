"""Generalised forces from the power of loads, by the structure of the expressions."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING, TypeAlias

import sympy as sm

from pydy._mechanics.symbols import find_symbols

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol

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
