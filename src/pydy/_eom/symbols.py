"""Which symbols occur in expressions: one walk, each distinct object once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef

__all__ = ["find_symbols", "sort_symbols"]


def sort_symbols(symbols: Iterable[Any]) -> list[Any]:
    """Sort symbols, functions of time and their derivatives as SymPy orders them."""
    return sorted(symbols, key=sm.default_sort_key)


def find_symbols(expressions: Iterable[Any]) -> dict[Any, None]:
    """Return the symbols, applied undefined functions and derivatives, in order of discovery.

    Derivatives and undefined functions are taken whole: what they are of is not entered.
    SymPy's ``free_symbols`` walks the tree, which for multibody equations can be larger than the
    graph of distinct objects by orders of magnitude; this walk does not.
    """
    found: dict[Any, None] = {}
    seen: set[int] = set()
    stack = list(expressions)
    while stack:
        expr = stack.pop()
        key = id(expr)
        if key in seen:
            continue
        seen.add(key)
        if isinstance(expr, (AppliedUndef, sm.Derivative, sm.Symbol)):
            found[expr] = None
        else:
            stack.extend(expr.args)
    return found
