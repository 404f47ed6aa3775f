"""Names and LaTeX of symbols, for tables, files, labels and messages."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from difflib import get_close_matches
from itertools import count
from typing import Any


def name_of(symbol: Any) -> str:
    """Return the short name of a symbol: ``q1`` for ``q1(t)``; a string is its own name."""
    if isinstance(symbol, str):
        return symbol
    name = getattr(symbol, "name", None)
    return name if isinstance(name, str) else text_of(symbol)


def text_of(symbol: Any) -> str:
    """Return how a symbol prints; what users give in place of one may be nested too deeply."""
    try:
        return str(symbol)
    except RecursionError:
        return f"a {type(symbol).__name__} that is nested too deeply"


def place_of(key: Any, names: Sequence[str], what: str) -> int:
    """Return the position of a name or of a symbol's name; `what` describes the names in errors."""
    name = name_of(key)
    if name not in names:
        raise KeyError(f"`{key}` is not one of the {what}: {some(names)}.")
    return list(names).index(name)


def untaken(name: str, taken: Container[str], between: str = "_") -> str:
    """Return a name, numbered if it is already taken."""
    if name not in taken:
        return name
    return next(one for k in count(2) if (one := f"{name}{between}{k}") not in taken)


def unique_names(symbols: Sequence[Any]) -> tuple[str, ...]:
    """Return a distinct name for each symbol.

    Those that would be alike are written out in full, then with their assumptions, and numbered
    where that does not tell them apart either.
    """
    names = told_apart(symbols, [name_of(s) for s in symbols], str, written_out)
    taken: set[str] = set()
    for k, name in enumerate(names):
        names[k] = untaken(name, taken, " ")
        taken.add(names[k])
    return tuple(names)


def column_names(counts: Mapping[Any, int]) -> tuple[str, ...]:
    """Return a name for each column; symbols with several have ``F[0]``, ``F[1]`` and so on."""
    named = zip(unique_names(list(counts)), counts.values(), strict=True)
    return tuple(
        name if count == 1 else f"{name}[{j}]" for name, count in named for j in range(count)
    )


def told_apart(
    symbols: Sequence[Any], names: Sequence[str], *spellings: Callable[[Any], str]
) -> list[str]:
    """Return names of symbols; equal names are replaced by the first spelling that differs.

    By default they are written out with their assumptions.
    """
    names = list(names)
    for spelled in spellings or (written_out,):
        counts = Counter(names)
        if len(counts) == len(names):
            break
        names = [spelled(s) if counts[n] > 1 else n for s, n in zip(symbols, names, strict=True)]
    return names


def nearest(name: str, names: Sequence[str], *, or_all: bool = True) -> str:
    """Return a sentence that suggests the nearest name, or lists all names, or ''.

    A name that differs in upper and lower case alone is nearer than any other.
    """
    alike = [other for other in names if other.lower() == name.lower()]
    close = alike or get_close_matches(name, names, n=1)
    if not close and not or_all:
        return ""
    return f"Did you mean `{close[0]}`?" if close else f"There are {', '.join(sorted(names))}."


def written_out(symbol: Any) -> str:
    """Return a symbol with its assumptions: ``m (positive)``, ``q(t) (real)``."""
    notes = _assumptions(symbol.expr if hasattr(symbol, "expr") else symbol)
    arguments = getattr(symbol, "args", ())
    for argument in arguments if isinstance(arguments, tuple) else ():
        if getattr(argument, "is_Symbol", False):
            notes += [f"{argument} {note}" for note in _assumptions(argument)]
    return f"{symbol} ({', '.join(notes)})" if notes else str(symbol)


_ASSUMPTIONS = (
    *("even", "odd", "prime", "integer", "rational", "irrational", "positive", "negative"),
    *("nonnegative", "nonpositive", "nonzero", "zero", "real", "imaginary", "finite", "complex"),
)


def _assumptions(symbol: Any) -> list[str]:
    """Return a symbol's assumptions in words, without those that follow from another."""
    import sympy as sm

    held = [name for name in _ASSUMPTIONS if getattr(symbol, f"is_{name}", None)]
    implied = {
        other
        for name in held
        for other in sm.Symbol("x", **{name: True}).assumptions0
        if other != name
    }
    notes = [name for name in held if name not in implied]
    return notes if getattr(symbol, "is_commutative", True) else ["not commutative", *notes]


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


def printable(text: str, stream: Any) -> str:
    """Replace characters that a stream's encoding lacks by escapes."""
    encoding = getattr(stream, "encoding", None) or "utf-8"
    return text.encode(encoding, "backslashreplace").decode(encoding)


def few(texts: Sequence[str], most: int = 2, between: str = "; ") -> str:
    """Join the first texts of a list, and the number of the others."""
    more = [f"and {len(texts) - most} more"] if len(texts) > most else []
    return between.join([*texts[:most], *more])


def some(names: Iterable[str]) -> str:
    """Return a list of names for a message, shortened when there are many."""
    return few([*names], 12, ", ")


def numbers_of(names: Iterable[str], values: Iterable[float], digits: int = 6) -> str:
    """Return names with values, such as a state, for a message; there may be more values."""
    return some(f"{n} = {v:.{digits}g}" for n, v in zip(names, values, strict=False))


def table_of(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table with columns as wide as their longest entry."""
    every = [heads, *rows]
    widths = [max(len(row[k]) for row in every) for k in range(len(heads))]
    return [
        "  ".join(entry.ljust(width) for entry, width in zip(row, widths, strict=True)).rstrip()
        for row in every
    ]
