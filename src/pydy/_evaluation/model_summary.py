"""The text of a printed System."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm

from pydy._assembly import Definition
from pydy._checks import merged
from pydy._names import counted, name_of, some, unique_names

if TYPE_CHECKING:
    from pydy._mechanics import Equations
    from pydy._sympy_types import AnySymbol, SymbolOrName


def summary(
    definition: Definition,
    method: str,
    solver: object,
    times: np.ndarray,
    values: Mapping[str, Mapping[SymbolOrName, object]],
    event_constants: Iterable[AnySymbol],
) -> list[tuple[str, str]]:
    """Return the titles and texts of a summary of the user's settings.

    The `values` are those of the initial conditions, constants and specifieds. Constants outside
    the definition, of events or energies, are listed as 'elsewhere'.
    """
    constants = merged(values["constants"])
    equations, t = definition.equations, times
    in_definition = {n for s in definition.constants for n in (s, name_of(s))}
    further = (s for s in (*event_constants, *constants) if s not in in_definition)
    other_constants = {name_of(s): s for s in further}
    lines = [
        ("equations", f"from {method}, {counted(len(equations.coordinates), 'coordinate')}, "
         f"{counted(len(equations.speeds), 'speed')}"),
        ("states", _values(definition.states, merged(values["initial_conditions"]), "0.0")),
        ("constants", _values(definition.constants, constants, "1.0")),
        ("elsewhere", _values([*other_constants.values()], constants, "1.0")),
        ("specifieds", _values(definition.specifieds, _flat(values["specifieds"]), "0.0")),
        ("constraints", _counts(equations)),
        ("outputs", some([name_of(s) for s in definition.outputs.symbols])),
        ("times", f"{t[0]:g} to {t[-1]:g}, {len(t)} of them" if len(t) else "none"),
        ("solver", str(getattr(solver, "name", getattr(solver, "__name__", solver)))),
    ]  # fmt: skip
    if any(" = (" in text for _, text in lines):
        lines.append(("", "(in parentheses: defaults)"))
    return [(title, text) for title, text in lines if text]


def _flat(specifieds: Mapping[Any, Any]) -> dict[SymbolOrName, object]:
    """Return the value of each specified, given in either format."""
    if isinstance(specifieds.get("symbols"), (tuple, list)):
        specifieds = {tuple(specifieds["symbols"]): specifieds.get("values")}
    values: dict[SymbolOrName, object] = {}
    for key, value in merged(specifieds).items():
        several = isinstance(key, tuple)
        if several and isinstance(value, (list, tuple, np.ndarray)) and len(value) == len(key):
            values.update(zip(key, value, strict=True))
        else:
            values.update(dict.fromkeys(key if several else (key,), value))
    return values


def _values(
    symbols: Sequence[AnySymbol], values: Mapping[SymbolOrName, object], default: str
) -> str:
    """Return names with values; defaults are in parentheses."""

    def value_of(symbol: AnySymbol) -> object:
        return values.get(symbol, values.get(name_of(symbol), values.get(str(symbol))))

    texts = []
    for symbol, name in zip(symbols, unique_names(symbols), strict=True):
        value = value_of(symbol)
        text = f"({default})" if value is None else shortened(value)
        if value is None and isinstance(symbol, sm.Derivative):
            motion = value_of(symbol.expr)
            if getattr(motion, "free_symbols", None):
                text = f"(from the expression for {name_of(symbol.expr)})"
        texts.append(f"{name} = {text}")
    return some(texts)


def shortened(value: object) -> str:
    if callable(value) and not hasattr(value, "free_symbols"):
        return f"{getattr(value, '__name__', type(value).__name__)}(x, t)"
    if isinstance(value, (int, float, np.number)):
        return f"{float(value):g}"
    text = str(value).replace("\n", " ")
    return text if len(text) <= 40 else text[:37] + "..."


def _counts(equations: Equations) -> str:
    constraints = equations.constraints
    counts = {
        "holonomic": len(constraints.holonomic),
        "nonholonomic": len(constraints.nonholonomic),
    }
    return ", ".join(f"{number} {kind}" for kind, number in counts.items() if number)
