"""What is inside SymPy expressions, each distinct object once."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sm


def parts_of(expression: sm.Expr) -> Iterator[sm.Basic]:
    """Yield an expression and all that is in it, each distinct object once.

    SymPy's ``has`` and ``atoms`` walk the tree, which for the velocity of a wheel at the end of a
    chain is larger by orders of magnitude.
    """
    visited: dict[int, sm.Basic] = {}
    stack: list[sm.Basic] = [expression]
    while stack:
        part = stack.pop()
        if id(part) not in visited:
            visited[id(part)] = part
            yield part
            stack.extend(part.args)


def has_real_values(expression: sm.Expr) -> bool:
    """Return whether an expression has no infinity, NaN, imaginary unit or matrix in it."""
    excluded = {sm.nan, sm.zoo, sm.I, sm.oo, -sm.oo}
    return not any(
        isinstance(part, sm.MatrixSymbol) or (not part.args and part in excluded)
        for part in parts_of(expression)
    )
