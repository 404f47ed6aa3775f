"""The compiled loops: LLVM IR that the package ships, compiled here for the processor at hand.

``tools/solvers_ir.py`` makes the IR from the C in ``core``, with a compiler that nobody needs who
does not change it. Each entry is a module of its own, so that an explicit method does not wait for
the implicit one; machine code is kept with that of kernels.
"""

from __future__ import annotations

import ctypes
import hashlib
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from pydy import _forks
from pydy._array_layout import DATA, FITS, address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source, target_lines
from pydy._backends.llvm.gate import Gate

__all__ = ["address_of", "callback_address", "function_of", "stepper"]

# Read with the modules that lay out what the loops work on: the package may be replaced meanwhile.
_TEXTS = {
    path.stem: path.read_text(encoding="utf-8")
    for path in (Path(__file__).parents[1] / "ir").glob("*.ll")
}
_LOCK = _forks.Lock()


@cache
def _code(name: str) -> jit.Code:
    text = _TEXTS[name]
    what = f"solver {hashlib.sha256(text.encode()).hexdigest()}"
    with _LOCK:  # whoever comes second finds what the first one compiled
        return jit.load(Source(what, partial(_finished, text), (name,), loops=True))


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
def function_of(name: str, python: bool = False) -> Callable[..., int]:
    """Return an entry that takes the address of a table, and further arguments.

    A projection also takes a time and an address; `extend` takes the address of another table.

    It releases the interpreter's lock, unless it may call Python functions: then it raises what
    they raise.
    """
    kind = ctypes.PYFUNCTYPE if python else ctypes.CFUNCTYPE
    numbers: tuple[Any, ...] = (ctypes.c_double, ctypes.c_int64)
    if not name.startswith("project"):
        numbers = (ctypes.c_int64,) if name == "extend" else ()
    return kind(ctypes.c_int64, ctypes.c_int64, *numbers)(address_of(name))


def stepper(name: str, place: int, python: bool) -> Callable[[np.ndarray, bool], int]:
    """Return an entry that steps, bound to the table at an address.

    Its arguments are the matrix of states, and whether an integration begins there. As for
    `function_of`, `python` tells whether it may call Python functions.
    """
    if FITS and not python:
        return _gate().function(np.array([address_of(name), place], dtype=np.int64))
    kind = ctypes.PYFUNCTYPE if python else ctypes.CFUNCTYPE
    step = kind(*[ctypes.c_int64] * 4)(address_of(name))
    return lambda states, fresh: step(place, address(states), fresh)


@cache
def _callbacks() -> jit.Code:
    source = Source(f"solver callback {_CALLBACK}", lambda brief: _CALLBACK, ("call_python",))
    return jit.load(source)


def callback_address() -> int:
    """Return the address of the kernel that calls a Python object, whose constants name it."""
    return _callbacks().addresses["call_python"]


# Constants: the object, a buffer, and how many numbers of it are states and results. Called with
# the interpreter's lock held. With an exception set, Python must not be entered again.
_CALLBACK = """
declare ptr @PyErr_Occurred()
declare ptr @PyObject_CallNoArgs(ptr)
declare void @Py_DecRef(ptr)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)

define i32 @call_python(ptr %t, ptr %x, ptr %r, ptr %c, ptr %out) nounwind {
  %before = call ptr @PyErr_Occurred()
  %well = icmp eq ptr %before, null
  br i1 %well, label %ask, label %failed
ask:
  %object = load ptr, ptr %c
  %buffer.at = getelementptr i64, ptr %c, i64 1
  %buffer = load ptr, ptr %buffer.at
  %states.at = getelementptr i64, ptr %c, i64 2
  %states = load i64, ptr %states.at
  %results.at = getelementptr i64, ptr %c, i64 3
  %results = load i64, ptr %results.at
  %time = load double, ptr %t
  store double %time, ptr %buffer
  %state = getelementptr double, ptr %buffer, i64 1
  %values = getelementptr double, ptr %state, i64 %states
  %states.size = shl i64 %states, 3
  %results.size = shl i64 %results, 3
  call void @llvm.memcpy.p0.p0.i64(ptr %state, ptr %x, i64 %states.size, i1 false)
  %answer = call ptr @PyObject_CallNoArgs(ptr %object)
  %raised = icmp eq ptr %answer, null
  br i1 %raised, label %failed, label %done
done:
  call void @Py_DecRef(ptr %answer)
  call void @llvm.memcpy.p0.p0.i64(ptr %out, ptr %values, i64 %results.size, i1 false)
  ret i32 0
failed:
  ret i32 -1
}
"""


@cache
def _gate() -> Gate:
    code = jit.load(Source(f"solver gate {_GATE}", _gate_text, ("gate",)))
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
