"""The compiled loops: LLVM IR that the package ships, compiled here for the processor at hand.

``tools/solvers_ir.py`` makes the IR from the modules that are written for numba, which nobody needs
who does not change them. Each entry is a module of its own, so that an explicit method does not
wait for the implicit one; machine code is kept with that of kernels.
"""

from __future__ import annotations

import ctypes
import hashlib
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path

import numpy as np

from pydy import _forks
from pydy._array_layout import DATA, FITS, address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import target_lines
from pydy._backends.llvm.gate import Gate

__all__ = ["address_of", "function_of", "stepper"]

_FOLDER = Path(__file__).parents[1] / "ir"
_LOCK = _forks.Lock()
_OF_TABLE = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64)
_OF_RUN = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)


@cache
def _code(name: str) -> jit.Code:
    text = (_FOLDER / f"{name}.ll").read_text(encoding="utf-8")
    what = f"solver {hashlib.sha256(text.encode()).hexdigest()}"
    with _LOCK:  # whoever comes second finds what the first one compiled
        return jit.load(jit.Source(what, partial(_finished, text), (name,), loops=True))


def _finished(text: str, brief: bool) -> str:
    return target_lines() + text


def address_of(name: str) -> int:
    """Return the address of an entry; it is compiled, or loaded, when this is first asked for.

    Parameters
    ----------
    name : str
        Of a file in ``ir``.
    """
    return _code(name).addresses[name]


@cache
def function_of(name: str) -> Callable[[int], int]:
    """Return an entry that takes the address of a table; it releases the interpreter's lock."""
    return _OF_TABLE(address_of(name))


def stepper(name: str, place: int) -> Callable[[np.ndarray, bool], int]:
    """Return an entry that steps, bound to the table at an address.

    Its arguments are the matrix of states, and whether an integration begins there. It releases the
    interpreter's lock.
    """
    if FITS:
        return _gate().function(np.array([address_of(name), place], dtype=np.int64))
    step = _OF_RUN(address_of(name))
    return lambda states, fresh: step(place, address(states), fresh)


@cache
def _gate() -> Gate:
    code = jit.load(jit.Source(f"solver gate {_GATE}", _gate_text, ("gate",)))
    return Gate(b"native_step", code, "gate")


def _gate_text(brief: bool) -> str:
    return _GATE


# step(states, fresh): `self` is an array of the entry's address and the table's.
_GATE = f"""
@_Py_TrueStruct = external global i8
declare ptr @PyEval_SaveThread()
declare void @PyEval_RestoreThread(ptr)
declare ptr @PyLong_FromLongLong(i64)

define ptr @gate(ptr %self, ptr %args, i64 %count) nounwind {{
  %words.at = getelementptr i8, ptr %self, i64 {DATA}
  %words = load ptr, ptr %words.at
  %entry = load ptr, ptr %words
  %table.at = getelementptr i64, ptr %words, i64 1
  %table = load i64, ptr %table.at
  %states = load ptr, ptr %args
  %data.at = getelementptr i8, ptr %states, i64 {DATA}
  %data = load i64, ptr %data.at
  %flag.at = getelementptr ptr, ptr %args, i64 1
  %flag = load ptr, ptr %flag.at
  %true = icmp eq ptr %flag, @_Py_TrueStruct
  %fresh = zext i1 %true to i64
  %thread = call ptr @PyEval_SaveThread()
  %code = call i64 %entry(i64 %table, i64 %data, i64 %fresh)
  call void @PyEval_RestoreThread(ptr %thread)
  %result = call ptr @PyLong_FromLongLong(i64 %code)
  ret ptr %result
}}
"""
