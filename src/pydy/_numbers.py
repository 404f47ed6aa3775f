"""What users pass as numbers into floats, or an error that says what it was instead."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["number", "real_array"]


def number(value: Any, what: str, *, finite: bool = False) -> float:
    """Return a value as a float, or say what it was instead."""
    try:
        array = np.asarray(value)
        if array.dtype == object or array.size != 1 or np.iscomplexobj(array):
            result = float(value)
        else:
            result = float(array.reshape(()))
    except (TypeError, ValueError):
        raise ValueError(f"{what} must be a real number, got {value!r}.") from None
    if finite and not np.isfinite(result):
        raise ValueError(f"{what} must be finite, got {result!r}.")
    return result


def real_array(value: Any, what: str) -> np.ndarray:
    """Return a value as a C-contiguous float array of its own shape.

    NumPy alone would turn None into NaN and drop imaginary parts.
    """
    try:
        array = np.asarray(value)
        if array.dtype.kind == "O":
            numbers = np.array([float(v) for v in array.ravel()])
            return numbers.reshape(array.shape)
    except (TypeError, ValueError):
        raise ValueError(f"{what} must hold real numbers, got {value!r}.") from None
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{what} must hold real numbers, got {value!r}.")
    if array.dtype == np.float64 and array.flags.c_contiguous:
        return array
    return array.astype(float, order="C")
