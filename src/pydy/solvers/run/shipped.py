"""The compiled loops, shipped as LLVM IR that is made from the C in ``core``.

Each entry is a module of its own, so that an explicit method does not wait for the implicit one.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from pydy._array_layout import FITS, address
from pydy._backends import Code, Shipped, gates, load
from pydy._forks import once

_SHIPPED = Shipped(Path(__file__).parents[1] / "ir")


@once
def _code(name: str) -> Code:
    return load(_SHIPPED.source(name))


def address_of(name: str) -> int:
    """Return the address of an entry, the name of a file in ``ir``.

    It is compiled, or loaded, at the first call.
    """
    return _code(name).addresses[name]


@cache
def function_of(name: str, python: bool = False) -> Callable[..., int]:
    """Return an entry that takes the address of a table, and further arguments.

    A projection also takes a time and an address; `extend` and `step_back` take the address of
    another table.

    It releases the interpreter's lock, unless it may call Python functions: then it raises what
    they raise.
    """
    kind = ctypes.PYFUNCTYPE if python else ctypes.CFUNCTYPE
    numbers: tuple[type, ...] = (ctypes.c_double, ctypes.c_int64, ctypes.c_int64)
    if not name.startswith("project"):
        numbers = (ctypes.c_int64,) if name in ("extend", "step_back") else ()
    return kind(ctypes.c_int64, ctypes.c_int64, *numbers)(address_of(name))


def stepper(name: str, table: int, python: bool) -> Callable[[np.ndarray, bool], int]:
    """Return an entry that steps, bound to the table at an address.

    Its arguments are the matrix of states, and whether an integration begins there. As for
    `function_of`, `python` tells whether it may call Python functions.
    """
    if FITS and not python:
        return gates().step.function(np.array([address_of(name), table], dtype=np.int64))
    kind = ctypes.PYFUNCTYPE if python else ctypes.CFUNCTYPE
    step = kind(*[ctypes.c_int64] * 4)(address_of(name))
    return lambda states, fresh: step(table, address(states), fresh)
