"""Find, sort and replace symbols in expressions, visiting each distinct object once."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import pairwise
from operator import itemgetter
from typing import TYPE_CHECKING

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._graph import NodeExpression
from pydy._names import written_out

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, TimeFunction


def sort_symbols(symbols: Iterable[AnySymbol]) -> list[AnySymbol]:
    """Sort symbols, functions of time and their derivatives as SymPy orders them.

    SymPy has no order for symbols that differ in their assumptions alone: those follow in the
    order of their assumptions, so that no hash decides.
    """
    keyed = [(sm.default_sort_key(s), s) for s in symbols]
    keyed.sort(key=itemgetter(0))
    if any(a[0] == b[0] for a, b in pairwise(keyed)):
        keyed.sort(key=lambda pair: (pair[0], written_out(pair[1])))
    return [symbol for _, symbol in keyed]


def rate_of(symbol: TimeFunction, time: sm.Symbol) -> sm.Expr:
    """Return the derivative of a function of time, or of one of its derivatives.

    That of a function is made without SymPy's rules, which take thirty times as long.
    """
    if isinstance(symbol, AppliedUndef) and symbol.args == (time,):
        return sm.Derivative(symbol, time, evaluate=False)
    return symbol.diff(time)


def find_symbols(expressions: Iterable[sm.Expr | sm.Matrix]) -> dict[AnySymbol, None]:
    """Return the symbols, applied undefined functions and derivatives, in order of discovery.

    Undefined functions and their derivatives are taken whole: what they are of is not entered.
    SymPy's ``free_symbols`` walks the tree, which for multibody equations can be larger than the
    graph of distinct objects by orders of magnitude; this walk does not.
    """
    symbols: dict[AnySymbol, None] = {}
    visited: dict[int, object] = {}  # by identity, and with the objects: what is freed lends its id
    stack = list(expressions)
    while stack:
        expr = stack.pop()
        key = id(expr)
        if key in visited:
            continue
        visited[key] = expr
        if (derivative := NodeExpression.of_derivative(expr)) is not None:
            stack.append(derivative)
        elif isinstance(expr, (AppliedUndef, sm.Derivative, sm.Symbol)):
            symbols[expr] = None
        else:
            stack.extend(expr.args)
    return symbols


def replace_symbols(expression: sm.Expr, mapping: Mapping[AnySymbol, sm.Expr]) -> sm.Expr:
    """Replace symbols, applied undefined functions and derivatives, each taken whole.

    As with `find_symbols`, and unlike SymPy's ``xreplace`` and ``subs``, the cost is the number of
    distinct objects. Nothing is simplified beyond what SymPy does when an expression is built.
    """
    root = sm.sympify(expression)
    done: dict[int, sm.Expr] = {}
    derivatives: dict[int, sm.Expr] = {}
    stack = [(root, False)]
    while stack:
        expr, ready = stack.pop()
        key = id(expr)
        if key in done:
            continue
        if ready and key in derivatives:
            done[key] = done[id(derivatives[key])]
        elif (derivative := NodeExpression.of_derivative(expr)) is not None:
            derivatives[key] = derivative
            stack += [(expr, True), (derivative, False)]
        elif not expr.args or isinstance(expr, (AppliedUndef, sm.Derivative)):
            done[key] = mapping.get(expr, expr)
        elif ready:
            args = [done[id(a)] for a in expr.args]
            same = all(a is b for a, b in zip(args, expr.args, strict=True))
            done[key] = expr if same else expr.func(*args)
        else:
            stack.append((expr, True))
            stack.extend((a, False) for a in expr.args if id(a) not in done)
    return done[id(root)]


def function_of_time(name: str) -> AppliedUndef:
    """Return a function of time, as coordinates and outputs are."""
    return dynamicsymbols(name)
