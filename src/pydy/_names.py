"""Names and LaTeX of symbols, for tables, files and labels."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

__all__ = ["latex_of", "latex_of_rate", "name_of", "unique_names"]


def name_of(symbol: Any) -> str:
    """Return the short name of a symbol: ``q1`` for ``q1(t)``; a string is its own name."""
    if isinstance(symbol, str):
        return symbol
    name = getattr(symbol, "name", None)
    return name if isinstance(name, str) else str(symbol)


def unique_names(symbols: Sequence[Any]) -> tuple[str, ...]:
    """Return a name for each symbol; those that would be alike are written out in full."""
    names = [name_of(s) for s in symbols]
    if len(set(names)) < len(names):
        counts = Counter(names)
        names = [str(s) if counts[n] > 1 else n for s, n in zip(symbols, names, strict=True)]
    return tuple(names)


def latex_of(symbol: Any) -> str:
    """Return the LaTeX of a symbol, without dollar signs; a name is set upright."""
    if isinstance(symbol, str):
        return r"\mathrm{" + symbol.replace("_", r"\_") + "}"
    from sympy.physics.mechanics import vlatex

    return str(vlatex(symbol))


def latex_of_rate(symbol: Any) -> str:
    """Return the LaTeX of a symbol's derivative by time: with a dot."""
    if getattr(symbol, "args", ()):  # a function of time, which says by itself where the dot goes
        return latex_of(symbol.diff(symbol.args[0]))
    return rf"\dot{{{latex_of(symbol)}}}"
