"""Names and LaTeX of symbols, for tables, files, labels and messages."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from difflib import get_close_matches
from itertools import count
from typing import Any, SupportsIndex


def name_of(symbol: Any) -> str:
    """Return the short name of a symbol: ``q1`` for ``q1(t)``; a string is its own name."""
    if isinstance(symbol, str):
        return symbol
    name = getattr(symbol, "name", None)
    return name if isinstance(name, str) else text_of(symbol)


def text_of(symbol: Any) -> str:
    """Return str(symbol), or a short description of arrays and of values nested too deeply."""
    kind = type(symbol).__name__
    try:
        text = str(symbol)
    except RecursionError:
        return f"a {kind} that is nested too deeply"
    if "\n" not in text:
        return text
    shape = getattr(symbol, "shape", None)  # of an array, or of a table
    label = "an array" if kind == "ndarray" else f"a {kind}"
    return label if shape is None else f"{label} of the shape {shape}"


def place_of(key: Any, names: Sequence[str], description: str) -> int:
    """Return the position of a symbol or name; `description` describes the names in errors."""
    name = name_of(key)
    if name not in names:
        raise KeyError(f"`{text_of(key)}` is not one of the {description}: {some(names)}.")
    return list(names).index(name)


def item_of_name(items: Sequence[Any], key: Any) -> Any:
    """Return the item with a name; keys that name no item, or several, are returned unchanged."""
    matching = [item for item in items if isinstance(key, str) and name_of(item) == key]
    return matching[0] if len(matching) == 1 else key


def unused_name(name: str, used: Container[str], separator: str = "_") -> str:
    """Return a name, with a number appended if it is already used."""
    if name not in used:
        return name
    return next(candidate for k in count(2) if (candidate := f"{name}{separator}{k}") not in used)


def unique_names(symbols: Sequence[Any]) -> tuple[str, ...]:
    """Return a distinct name for each symbol.

    Equal names are replaced by the full expressions, then by these with their assumptions, and
    numbered if they are still equal.
    """
    names = distinguished(symbols, [name_of(s) for s in symbols], str, written_out)
    used: set[str] = set()
    for k, name in enumerate(names):
        names[k] = unused_name(name, used, " ")
        used.add(names[k])
    return tuple(names)


def column_names(counts: Mapping[Any, int]) -> tuple[str, ...]:
    """Return a name for each column; symbols with several have ``F[0]``, ``F[1]`` and so on."""
    named = zip(unique_names(list(counts)), counts.values(), strict=True)
    return tuple(
        name if count == 1 else f"{name}[{j}]" for name, count in named for j in range(count)
    )


def distinguished(
    symbols: Sequence[Any], names: Sequence[str], *spellings: Callable[[Any], str]
) -> list[str]:
    """Return names of symbols; equal names are replaced by the first spelling that differs.

    The default spelling is the symbol with its assumptions.
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

    A name that differs only in upper and lower case is nearer than any other.
    """
    alike = [candidate for candidate in names if candidate.lower() == name.lower()]
    close = alike or get_close_matches(name, names, n=1)
    if not close and not or_all:
        return ""
    return f"Did you mean `{close[0]}`?" if close else f"There are {', '.join(sorted(names))}."


def no_such_quantity(key: object, names: Sequence[str]) -> str:
    """Return the message for a key that is not a quantity of a trajectory, with the remedy."""
    parts = key if isinstance(key, tuple) else (key,)
    if isinstance(key, tuple) and all(isinstance(part, str) for part in parts):
        hint = f"For several quantities use a list: `trajectory[{[*parts]}]`."
    elif all(isinstance(part, (SupportsIndex, slice)) for part in parts):
        hint = (
            "Index the arrays: `trajectory.states[k]`; `trajectory.at(t)` is the state at a time."
        )
    else:
        hint = nearest(text_of(key), names, or_all=False)
    text = f"`{text_of(key)}` is not one of the trajectory's quantities: {some(names)}. {hint}"
    return text.rstrip()


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

    true_assumptions = [name for name in _ASSUMPTIONS if getattr(symbol, f"is_{name}", None)]
    implied = {
        implied_name
        for name in true_assumptions
        for implied_name in sm.Symbol("x", **{name: True}).assumptions0
        if implied_name != name
    }
    notes = [name for name in true_assumptions if name not in implied]
    return notes if getattr(symbol, "is_commutative", True) else ["not commutative", *notes]


# -- Labels: the same name on pages, in plots and in files -----------------------------------------

_LETTERS = {
    unicodedata.name(c).split()[-1].replace("LAMDA", "LAMBDA").lower(): c
    for c in map(chr, range(ord("α"), ord("ω") + 1))
}
_VARIANTS = {"varsigma": "ς", "varepsilon": "ε", "varphi": "φ", "vartheta": "ϑ", "varrho": "ϱ",
             "varpi": "ϖ", "varkappa": "ϰ"}  # fmt: skip
GREEK = _LETTERS | {name.capitalize(): c.upper() for name, c in _LETTERS.items()} | _VARIANTS
GREEK |= {"lamda": GREEK["lambda"], "Lamda": GREEK["Lambda"]}  # as Python's users spell it
# Capitals that look like Latin ones have no command in LaTeX.
_NO_COMMAND = {*"ΑΒΕΖΗΙΚΜΝΟΡΤΧο"}
# The marks that SymPy sets over a letter, with their combining characters.
_MARKS = {"ddot": "\u0308", "dot": "\u0307", "hat": "\u0302", "bar": "\u0304", "tilde": "\u0303"}
_SYMBOL = re.compile(r"(?P<base>[A-Za-z]+?)_?(?P<index>\d+|(?<=_)[A-Za-z0-9]+)?(?P<rate>'*)")
_MARKED = re.compile(rf"(?P<letter>[A-Za-z]|{'|'.join(GREEK)})(?P<mark>{'|'.join(_MARKS)})")
_WORD = re.compile(r"[A-Za-z]\w*", re.ASCII)


def _split_label(label: str) -> tuple[str, str, str, str] | None:
    """Split a label into letter, mark, index and primes; None if it is a word or a phrase."""
    match = _SYMBOL.fullmatch(label)
    if match is None:
        return None
    letter, mark, index = match["base"], "", match["index"] or ""
    if letter not in GREEK and (marked := _MARKED.fullmatch(letter)):
        letter, mark = marked["letter"], marked["mark"]
    if letter not in GREEK and len(letter) > 2 and not index.isdigit():
        return None
    return letter, mark, index, match["rate"]


def label_parts(label: str) -> list[str]:
    """Split a label into base and index, with Greek letters; a word has no index.

    Examples
    --------
    >>> from pydy._names import label_parts
    >>> label_parts('theta_1'), label_parts("q2'"), label_parts('x_foot'), label_parts('energy')
    (['θ', '1'], ["q'", '2'], ['x', 'foot'], ['energy', ''])
    """
    parts = _split_label(label)
    if parts is None:
        return [label, ""]
    letter, mark, index, rate = parts
    return [GREEK.get(letter, letter) + _MARKS.get(mark, "") + rate, GREEK.get(index, index)]


def _latex_of_label(label: str) -> str:
    parts = _split_label(label)
    if parts is None:
        return r"\mathrm{" + label.replace("_", r"\_").replace(" ", r"\ ") + "}"
    letter, mark, index, rate = parts
    base = _latex_of_letter(letter)
    base = rf"\{mark}{{{base}}}" if mark else base
    return base + (f"_{{{_latex_of_letter(index)}}}" if index else "") + rate


def _latex_of_letter(letter: str) -> str:
    greek = GREEK.get(letter)
    if greek is None or greek in _NO_COMMAND:
        return greek or letter
    return "\\" + letter.replace("amda", "ambda")


def _is_word(symbol: Any) -> bool:
    """Return whether a symbol, or a function of time, is named by a word, such as ``length``."""
    name = getattr(symbol, "name", None)
    if not isinstance(name, str) or len(getattr(symbol, "args", ())) > 1:
        return False
    return _WORD.fullmatch(name) is not None and _split_label(name) is None


def latex_of(symbol: Any) -> str:
    """Return the LaTeX of a symbol or label, without dollar signs; a word is set upright."""
    if isinstance(symbol, str):
        return _latex_of_label(symbol)
    if _is_word(symbol):
        return _latex_of_label(symbol.name)
    from sympy.physics.mechanics import vlatex

    return str(vlatex(symbol))


def latex_of_rate(symbol: Any) -> str:
    """Return the LaTeX of a symbol's derivative by time: with a dot."""
    if getattr(symbol, "args", ()) and not _is_word(symbol):
        # A function of time: SymPy prints its derivative with a dot.
        return latex_of(symbol.diff(symbol.args[0]))
    return rf"\dot{{{latex_of(symbol)}}}"


def printable(text: str, stream: Any) -> str:
    """Replace characters that a stream's encoding lacks by escapes."""
    encoding = getattr(stream, "encoding", None) or "utf-8"
    return text.encode(encoding, "backslashreplace").decode(encoding)


def few(texts: Sequence[str], most: int = 2, separator: str = "; ") -> str:
    """Join the first `most` texts of a list, and append the number of the others."""
    remainder = [f"and {len(texts) - most} more"] if len(texts) > most else []
    return separator.join([*texts[:most], *remainder])


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, in the plural unless it is one: ``1 link``, ``2 links``."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def some(names: Iterable[str]) -> str:
    """Return a list of names for a message, shortened when there are many."""
    return few([*names], 12, ", ")


def numbers_of(names: Iterable[str], values: Iterable[float], digits: int = 6) -> str:
    """Return names with values, such as a state, for a message; surplus values are ignored."""
    return some(f"{n} = {v:.{digits}g}" for n, v in zip(names, values, strict=False))


def table_of(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table with columns as wide as their longest entry."""
    every = [heads, *rows]
    widths = [max(len(row[k]) for row in every) for k in range(len(heads))]
    return [
        "  ".join(entry.ljust(width) for entry, width in zip(row, widths, strict=True)).rstrip()
        for row in every
    ]
