"""What a System prints of itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pydy._assembly.definition import Definition
from pydy._html import html_table
from pydy._names import name_of, unique_names

__all__ = ["as_html", "as_text", "facts"]

_MOST = 12  # symbols of a kind
Facts = list[tuple[str, str]]


def facts(
    method: str,
    definition: Definition,
    constants: Mapping[Any, Any],
    specifieds: Mapping[Any, Any],
    initial_conditions: Mapping[Any, Any],
    times: np.ndarray,
    solver: Any,
) -> Facts:
    """Return the lines of a summary: titles and texts.

    Parameters
    ----------
    method : str
        The class that the equations come from.
    definition : Definition
    constants, specifieds, initial_conditions : mapping
        What the user set.
    times : ndarray
    solver : callable
    """
    equations = definition.equations
    given = _flat(specifieds)
    lines: Facts = [
        ("equations", f"from {method}, {len(equations.coordinates)} coordinates, "
         f"{len(equations.speeds)} speeds"),
        ("states", _values(definition.states, initial_conditions, "0.0")),
        ("constants", _values(definition.constants, constants, "1.0")),
        ("specifieds", _values(definition.specifieds, given, "0.0")),
        ("constraints", _counts(equations)),
        ("outputs", _several([name_of(s) for s in definition.outputs_symbols])),
        ("times", _span(times)),
        ("solver", str(getattr(solver, "name", getattr(solver, "__name__", solver)))),
    ]  # fmt: skip
    if any(" = (" in text for _, text in lines):
        lines.append(("", "(in parentheses: defaults)"))
    return [(title, text) for title, text in lines if text]


def as_text(lines: Facts) -> str:
    """Return a summary as text."""
    width = max(len(title) for title, _ in lines)
    return "\n".join(["System", *(f"  {title:<{width}}  {text}" for title, text in lines)])


def as_html(lines: Facts) -> str:
    """Return a summary as a table in HTML."""
    return html_table("System", lines)


def _flat(specifieds: Mapping[Any, Any]) -> dict[Any, Any]:
    """Return what is given for each specified, in either format."""
    if isinstance(specifieds.get("symbols"), (tuple, list)):
        specifieds = {tuple(specifieds["symbols"]): specifieds.get("values")}
    given: dict[Any, Any] = {}
    for key, value in specifieds.items():
        several = isinstance(key, tuple)
        if several and isinstance(value, (list, tuple, np.ndarray)) and len(value) == len(key):
            given.update(zip(key, value, strict=True))
        else:
            given.update(dict.fromkeys(key if several else (key,), value))
    return given


def _values(symbols: Sequence[Any], given: Mapping[Any, Any], default: str) -> str:
    """Return names with values; defaults stand in parentheses."""
    texts = []
    for symbol, name in zip(symbols, unique_names(symbols), strict=True):
        value = given.get(symbol, given.get(name_of(symbol), given.get(str(symbol))))
        texts.append(f"{name} = ({default})" if value is None else f"{name} = {_short(value)}")
    return _several(texts)


def _short(value: Any) -> str:
    if callable(value) and not hasattr(value, "free_symbols"):
        return f"{getattr(value, '__name__', type(value).__name__)}(x, t)"
    if isinstance(value, (int, float, np.number)):
        return f"{float(value):g}"
    text = str(value).replace("\n", " ")
    return text if len(text) <= 40 else text[:37] + "..."


def _several(texts: Sequence[str]) -> str:
    more = [f"and {len(texts) - _MOST} more"] if len(texts) > _MOST else []
    return ", ".join([*texts[:_MOST], *more])


def _counts(equations: Any) -> str:
    counts = {
        "holonomic": len(equations.holonomic),
        "nonholonomic": len(equations.nonholonomic),
    }
    return ", ".join(f"{number} {kind}" for kind, number in counts.items() if number)


def _span(times: np.ndarray) -> str:
    if not len(times):
        return "none"
    return f"{times[0]:g} to {times[-1]:g}, {len(times)} of them"
