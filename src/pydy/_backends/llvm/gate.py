"""Functions of Python's own C interface whose code is ours: a tenth of what ctypes costs a call."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from pydy._backends.llvm.jit import Code

_make = ctypes.pythonapi.PyCFunction_NewEx
_make.restype = ctypes.py_object
_make.argtypes = [ctypes.c_void_p, ctypes.py_object, ctypes.py_object]


class Gate:
    """Machine code as functions that Python calls by a `name`.

    The code, kept as long as the gate or a function of it, has the `entry` ``PyObject
    *entry(PyObject *self, PyObject *const *args, Py_ssize_t count)``.
    """

    def __init__(self, name: bytes, code: Code, entry: str) -> None:
        pointer = ctypes.cast(ctypes.c_char_p(name), ctypes.c_void_p).value
        # struct PyMethodDef: name, function, METH_FASTCALL, no doc
        self._method = (ctypes.c_void_p * 4)(pointer, code.addresses[entry], 0x0080, None)
        self._needed = name, code
        self._address = ctypes.addressof(self._method)

    def function(self, owner: Any) -> Callable[..., Any]:
        """Return the function whose `self` is `owner`."""
        # What Python takes for the function's module is an object that it keeps.
        function: Callable[..., Any] = _make(self._address, owner, self)
        return function
