"""The C sources of the loops, and their header ``layout.h``, written from Python's definitions.

A table of addresses (`pydy.solvers.layout`) *is* a C struct: for each array its address, its
length, and its number of columns. The tuples' definitions say what the arrays hold.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import chain
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias, get_type_hints

import numpy as np

from pydy.solvers import layout, tuning
from pydy.solvers.outcome import Outcome
from pydy.solvers.tableaus import radau

FOLDER = Path(__file__).parent

# Numbers of C, and arrays of them.
Constant: TypeAlias = "float | Sequence[Constant]"

_ARRAYS = {np.int64: "Words", np.float64: "Numbers"}
_ITEMS = {"Words": "int64_t", "Numbers": "double"}
_TABLES: dict[str, Sequence[type]] = {
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
    texts: dict[str, str] = {}
    pending = [*names]
    while pending:
        name = pending.pop()
        if name in texts or name == "layout.h":
            continue
        texts[name] = text = ((folder or FOLDER) / name).read_text(encoding="utf-8")
        pending += re.findall(r'^#include "(.*)"$', text, re.MULTILINE)
    return dict(sorted(texts.items()))


def portable_sources(*names: str, texts: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return C files with their includes and ``layout.h``, for any C99 compiler.

    Other `texts` that use the header come first.
    """
    sources = {**(texts or {}), **included(*names)}
    return {**sources, "layout.h": layout_header("\n".join(sources.values()), portable=True)}


def layout_header(text: str | None = None, portable: bool = False) -> str:
    """Write ``layout.h``: all constants and structs, or only the constants that a `text` uses.

    A `portable` header is for any C99 compiler: blocks of one number, and explicit methods only.
    """
    tables: dict[str, Sequence[Any]] = {"Run": layout.RUN[:-1]} if portable else _TABLES
    parts = [*tables.values()] + (
        [] if portable else [layout.EXTENSION, layout.PROJECTION, layout.ALONG]
    )
    kinds: dict[type, None] = dict.fromkeys(chain.from_iterable(parts))
    structs = [*map(_struct, kinds)]
    items = {name: item for name, item in _ITEMS.items() if any(name in s for s in structs)}
    constants = {name: _exact(value) for name, value in native_constants().items()}
    if portable:
        constants["BLOCK"] = "1"
    used = constants.keys() if text is None else set(re.findall(r"\w+", text))
    lines = [f"#define {name} {value}" for name, value in constants.items() if name in used]
    for name, item in items.items():
        lines.append(f"typedef struct {{ {item} *at; int64_t size, columns; }} {name};")
    lines += [*structs, *(_table(name, parts) for name, parts in tables.items())]
    return "\n".join([_BEGIN, *lines, "", "#endif", ""])


def native_constants() -> dict[str, Constant]:
    """Return the constants of the loops: thresholds, outcomes, and indices of array elements."""
    indices = _numeric(layout)
    # A threshold with the name of an index reaches C as that element of an array.
    thresholds = {name: x for name, x in _numeric(tuning).items() if name not in indices}
    outcomes = {outcome.name: int(outcome) for outcome in Outcome}
    names = ("T", "TI", "NODES", "ERROR", "REAL", "INTERPOLANT")
    method = {f"RADAU_{name}": getattr(radau, name) for name in names}
    method["RADAU_PAIR"] = (radau.COMPLEX.real, radau.COMPLEX.imag)
    points = {"SCAN_POINTS": layout.SCAN_POINTS}
    return {**thresholds, **outcomes, **indices, **points, **method}


def _numeric(module: ModuleType) -> dict[str, int | float]:
    """Return the numeric constants of a module: names in capitals."""
    constants = vars(module).items()
    return {name: x for name, x in constants if name.isupper() and isinstance(x, int | float)}


def _exact(value: Constant) -> str:
    """Write a number in C with all its bits, or an initialiser of several."""
    if isinstance(value, Sequence):
        return "{" + ", ".join(map(_exact, value)) + "}"
    return f"({value})" if isinstance(value, int) else f"({float(value).hex()})"


def _struct(kind: Any) -> str:
    """Write a named tuple of arrays as a C struct."""
    hints = get_type_hints(kind, include_extras=True)
    fields = [f"{_ARRAYS[hints[name].__metadata__[0]]} {name};" for name in kind._fields]
    return f"typedef struct {{ {' '.join(fields)} }} {kind.__name__};"


def _table(name: str, parts: Sequence[type]) -> str:
    """Write a table of named tuples as a C struct, with their names in small letters."""
    names = [part.__name__ for part in parts]
    fields = [f"{kind} {re.sub(r'(?<=[a-z])(?=[A-Z])', '_', kind).lower()};" for kind in names]
    return f"typedef struct {{ {' '.join(fields)} }} {name};"
