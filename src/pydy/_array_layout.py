"""NumPy's array object as compiled code reads it: by offsets, looked at once whether they hold.

A call of the machine code through NumPy's or ctypes' own attributes costs ten times as much. The
offsets are those of PyArrayObject in NumPy's ndarrayobject.h, and of PyFloatObject, in CPython's
usual builds; free-threaded and tracing builds have longer heads. Where a probe shows anything else
than NumPy and CPython say themselves, everything goes by way of `ndarray.ctypes`.
"""

from __future__ import annotations

import ctypes
import sys
from typing import Any

import numpy as np

__all__ = ["DATA", "DESCR", "FLAGS", "FLOAT", "KIND", "NDIM", "SHAPE", "address", "fits"]

KIND, DATA, NDIM, SHAPE, DESCR, FLAGS = 8, 16, 24, 32, 56, 64
"""Where the type, the numbers' address, the number of dimensions, the address of the shape, the
data type and the flags lie."""
FLOAT = 16
"""Where a Python float's value lies."""


def _field(thing: Any, offset: int, kind: Any) -> Any:
    return kind.from_address(id(thing) + offset).value


def _found(array: np.ndarray) -> tuple[Any, ...]:
    """Read an array's fields, except the shape, at the assumed offsets."""
    word, whole = ctypes.c_size_t, ctypes.c_int32
    kinds = ((KIND, word), (DATA, word), (NDIM, whole), (DESCR, word), (FLAGS, whole))
    return tuple(_field(array, offset, kind) for offset, kind in kinds)


def _told(array: np.ndarray) -> tuple[Any, ...]:
    """Read the same fields through NumPy."""
    data = array.__array_interface__["data"][0]
    return id(type(array)), data, array.ndim, id(array.dtype), array.flags.num


def fits() -> bool:
    """Return whether arrays and floats here have the layout that compiled code assumes."""
    if sys.implementation.name != "cpython" or ctypes.sizeof(ctypes.c_void_p) != 8:
        return False
    if np.ndarray.__basicsize__ < FLAGS + 4 or float.__basicsize__ < FLOAT + 8:
        return False
    plane = np.zeros((3, 5))
    for array in (plane, plane[1], plane.T, plane[::2, 1:4], np.zeros(7), np.zeros(2, np.int64)):
        if _found(array) != _told(array):
            return False
        # An address is followed only where everything around it is as it should be.
        shape = (ctypes.c_ssize_t * array.ndim).from_address(_field(array, SHAPE, ctypes.c_size_t))
        if tuple(shape) != array.shape:
            return False
    value = 0.7310585786300049
    return bool(
        _field(value, KIND, ctypes.c_size_t) == id(float)
        and _field(value, FLOAT, ctypes.c_double) == value
    )


FITS = fits()


def address(array: np.ndarray) -> int:
    """Return the address of an array's data, seven times as fast as by `ndarray.ctypes`."""
    return _word_at(id(array) + DATA).value if FITS else int(array.ctypes.data)


_word_at = ctypes.c_size_t.from_address
