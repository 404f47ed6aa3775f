"""The offsets at which compiled code reads NumPy's array object, and a probe that checks them.

A call of machine code through attributes of NumPy or ctypes costs ten times as much. The offsets
are those of PyArrayObject in NumPy's ndarrayobject.h, and of PyFloatObject, in usual builds of
CPython; free-threaded and tracing builds have longer headers. If the probe finds a difference from
what NumPy and CPython report, `ndarray.ctypes` is used instead.
"""

from __future__ import annotations

import ctypes
import sys
from typing import Any

import numpy as np

__all__ = ["DATA", "DESCR", "FLAGS", "FLOAT", "KIND", "NDIM", "SHAPE", "STRIDES", "address", "fits"]

KIND, DATA, NDIM, SHAPE, STRIDES, DESCR, FLAGS = 8, 16, 24, 32, 40, 56, 64
"""Offsets of the type, the address of the data, the number of dimensions, the addresses of the
shape and the strides, the data type and the flags."""
FLOAT = 16
"""Offset of a Python float's value."""


def _field(item: Any, offset: int, kind: Any) -> Any:
    return kind.from_address(id(item) + offset).value


def _probed_fields(array: np.ndarray) -> tuple[Any, ...]:
    """Read an array's fields, except shape and strides, at the assumed offsets."""
    word, int32 = ctypes.c_size_t, ctypes.c_int32
    kinds = ((KIND, word), (DATA, word), (NDIM, int32), (DESCR, word), (FLAGS, int32))
    return tuple(_field(array, offset, kind) for offset, kind in kinds)


def _reported_fields(array: np.ndarray) -> tuple[Any, ...]:
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
        if _probed_fields(array) != _reported_fields(array):
            return False
        # These addresses are dereferenced only after all other fields were verified.
        for offset, reported in ((SHAPE, array.shape), (STRIDES, array.strides)):
            numbers = ctypes.c_ssize_t * array.ndim
            if tuple(numbers.from_address(_field(array, offset, ctypes.c_size_t))) != reported:
                return False
    value = 0.7310585786300049
    return bool(
        _field(value, KIND, ctypes.c_size_t) == id(float)
        and _field(value, FLOAT, ctypes.c_double) == value
    )


FITS = fits()


def address(array: np.ndarray) -> int:
    """Return the address of an array's data, seven times as fast as `ndarray.ctypes`."""
    return _word_at(id(array) + DATA).value if FITS else int(array.ctypes.data)


_word_at = ctypes.c_size_t.from_address
