"""What users pass as numbers and arrays into floats, or an error that says what it was instead."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

__all__ = ["describe", "number", "real_array", "shown", "vector"]

_HUGE = "a number beyond the range of floats"


def describe(symbols: Sequence[Any]) -> str:
    """Return symbols as a list for a message, shortened when there are many."""
    shown = [str(s) for s in symbols[:12]]
    if len(symbols) > 12:
        shown.append(f"and {len(symbols) - 12} more")
    return ", ".join(shown) or "none"


def shown(value: Any) -> str:
    """Return the repr of a value for a message, cut where it is long."""
    try:
        text = repr(value)
    except ValueError:  # an integer of more than 4300 digits has none
        text = f"a {type(value).__name__}"
    return text if len(text) <= 200 else f"{text[:200]} …"


def number(value: Any, what: str, *, finite: bool = False) -> float:
    """Return a value as a float, or say what it was instead."""
    _refuse_masked(value, what)
    try:
        array = np.asarray(value)
        if array.dtype == object or array.size != 1 or array.dtype.kind not in "biuf":
            result = _as_float(value)
        else:
            result = float(array.reshape(()))
    except OverflowError:
        raise ValueError(f"{what} must be a real number, got {_HUGE}.") from None
    except (TypeError, ValueError):
        raise ValueError(f"{what} must be a real number, got {shown(value)}.") from None
    if finite and not np.isfinite(result):
        raise ValueError(f"{what} must be finite, got {result!r}.")
    return result


def real_array(value: Any, what: str) -> np.ndarray:
    """Return a value as a C-contiguous float array of its own shape.

    NumPy alone would turn None into NaN, read text as numbers, and drop masks and imaginary parts.
    """
    if type(value) is not np.ndarray:
        _refuse_masked(value, what)
    try:
        array = np.asarray(value)
        if array.dtype.kind == "O":
            numbers = np.array([_as_float(v) for v in array.ravel()])
            return numbers.reshape(array.shape)
    except OverflowError:
        raise ValueError(f"{what} must hold real numbers, got {_HUGE}.") from None
    except (TypeError, ValueError):
        raise ValueError(f"{what} must hold real numbers, got {shown(value)}.") from None
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{what} must hold real numbers, got {shown(value)}.")
    if array.dtype == np.float64 and array.flags.c_contiguous:
        return array
    return array.astype(float, order="C")


def vector(value: Any, size: int, what: str) -> np.ndarray:
    """Return a value as a float array of shape (size,)."""
    array = real_array(value, what)
    if array.ndim == 0 and size == 1:
        return array.reshape(1)
    if array.shape != (size,):
        raise ValueError(f"{what} must have the shape ({size},), got {array.shape}.")
    return array


def _as_float(value: Any) -> float:
    if isinstance(value, (str, bytes, bytearray, np.datetime64, np.timedelta64)):
        raise TypeError  # float() would read '1.5'
    result = float(value)
    if np.isinf(result) and getattr(value, "is_finite", False) is True:  # SymPy's
        raise OverflowError
    return result


def _refuse_masked(value: Any, what: str) -> None:
    """Refuse masked entries, under which any number may lie."""
    if isinstance(value, (list, tuple)):
        for entry in value:
            _refuse_masked(entry, what)
    elif isinstance(value, np.ma.MaskedArray) and np.ma.getmaskarray(value).any():
        raise ValueError(
            f"{what} must not have masked entries, got {shown(value)}. Leave them out, or fill "
            "them with numbers: `array.filled(...)`."
        )
