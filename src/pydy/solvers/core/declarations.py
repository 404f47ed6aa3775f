"""The header ``layout.h`` of the loops in C, written from the tuples and numbers of Python.

A table of addresses (`pydy.solvers.layout`) *is* a C struct: for each array its address, its
length, and its number of columns. What the arrays hold is said where the tuples are defined.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import chain
from pathlib import Path
from types import ModuleType
from typing import Any, get_type_hints

import numpy as np

from pydy.solvers import layout, tuning
from pydy.solvers.outcome import Outcome
from pydy.solvers.tableaus import radau

FOLDER = Path(__file__).parent

_ARRAYS = {np.int64: "Words", np.float64: "Numbers"}
_ITEMS = {"Words": "int64_t", "Numbers": "double"}
_TABLES: dict[str, Sequence[Any]] = {
    "Run": layout.RUN,
    "LaneRun": layout.STEPPING,
    "LaneEvaluation": layout.EVALUATION,
    "WayBack": layout.BACK,
}
_BEGIN = """\
/* Written by pydy.solvers.core.declarations. */
#ifndef LAYOUT_H
#define LAYOUT_H

#include <stdint.h>
"""


def included(*names: str, folder: Path | None = None) -> dict[str, str]:
    """Return the texts of C files and of their includes, except ``layout.h``."""
    found: dict[str, str] = {}
    left = [*names]
    while left:
        name = left.pop()
        if name in found or name == "layout.h":
            continue
        found[name] = text = ((folder or FOLDER) / name).read_text(encoding="utf-8")
        left += re.findall(r'^#include "(.*)"$', text, re.MULTILINE)
    return dict(sorted(found.items()))


def layout_header(text: str | None = None, plain: bool = False) -> str:
    """Write ``layout.h``: all constants and structs, or those that a `text` uses.

    A `plain` header is for any C99 compiler: blocks of one number, and explicit methods only.
    """
    tables: dict[str, Sequence[Any]] = {"Run": layout.RUN[:-1]} if plain else _TABLES
    parts = [*tables.values()] + (
        [] if plain else [layout.EXTENSION, layout.PROJECTION, layout.ALONG]
    )
    kinds: dict[Any, None] = dict.fromkeys(chain.from_iterable(parts))
    structs = [*map(_struct, kinds)]
    items = {name: item for name, item in _ITEMS.items() if any(name in s for s in structs)}
    numbers = {**dict(_numbers()), **({"BLOCK": "1"} if plain else {})}
    named = numbers.keys() if text is None else set(re.findall(r"\w+", text))
    lines = [f"#define {name} {value}" for name, value in numbers.items() if name in named]
    for name, item in items.items():
        lines.append(f"typedef struct {{ {item} *at; int64_t size, columns; }} {name};")
    lines += [*structs, *(_table(name, parts) for name, parts in tables.items())]
    return "\n".join([_BEGIN, *lines, "", "#endif", ""])


def _numbers() -> Iterator[tuple[str, str]]:
    """Yield the constants: codes, thresholds, and indices of array elements."""
    places = _named(layout)
    # Thresholds of that name reach C in the array that has a place for them.
    thresholds = {name: x for name, x in _named(tuning).items() if name not in places}
    outcomes = {outcome.name: int(outcome) for outcome in Outcome}
    for numbers in (thresholds, outcomes, places):
        for name, value in numbers.items():
            yield name, _exact(value)
    for name in ("T", "TI", "NODES", "ERROR", "REAL", "INTERPOLANT"):
        yield f"RADAU_{name}", _exact(getattr(radau, name))
    yield "RADAU_PAIR", _exact((radau.COMPLEX.real, radau.COMPLEX.imag))


def _named(module: ModuleType) -> dict[str, int | float]:
    """Return the numeric constants of a module: names in capitals."""
    found = vars(module).items()
    return {name: x for name, x in found if name.isupper() and isinstance(x, int | float)}


def _exact(value: Any) -> str:
    """Write a number in C with all its bits, or an initialiser of several."""
    if isinstance(value, Sequence):
        return "{" + ", ".join(map(_exact, value)) + "}"
    return f"({value})" if isinstance(value, int) else f"({float(value).hex()})"


def _struct(kind: Any) -> str:
    """Write a named tuple of arrays as a C struct."""
    hints = get_type_hints(kind, include_extras=True)
    fields = [f"{_ARRAYS[hints[name].__metadata__[0]]} {name};" for name in kind._fields]
    return f"typedef struct {{ {' '.join(fields)} }} {kind.__name__};"


def _table(name: str, parts: Sequence[Any]) -> str:
    """Write a table of named tuples as a C struct, with their names in small letters."""
    names = [part.__name__ for part in parts]
    fields = [f"{kind} {re.sub(r'(?<=[a-z])(?=[A-Z])', '_', kind).lower()};" for kind in names]
    return f"typedef struct {{ {' '.join(fields)} }} {name};"
