"""What an argument must be: independent readings of values, which say what a right result is.

A kind returns the plain value that stands for what was given, or raises `RefusedError` where
nothing sensible could be meant.
"""

from __future__ import annotations

import decimal
import numbers
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sm

__all__ = [
    "Kind",
    "RefusedError",
    "anything",
    "array",
    "choice",
    "flag",
    "integer",
    "nothing",
    "real",
]


class RefusedError(Exception):
    """The value makes no sense for the argument."""


@dataclass(frozen=True)
class Kind:
    """Reads a value, and says which groups of values are worth trying.

    Attributes
    ----------
    read : callable
        From a value to the plain value; raises `RefusedError`.
    groups : tuple of str
    compare : bool
        Whether the result with the plain value must be the same.
    """

    read: Callable[[Any], Any]
    groups: tuple[str, ...]
    compare: bool = True

    def or_none(self) -> Kind:
        """Return a kind that takes None as well, for the default."""
        return Kind(lambda v: None if v is None else self.read(v), self.groups, self.compare)

    def or_(self, other: Kind) -> Kind:
        """Return a kind that takes what either takes."""

        def read(value: Any) -> Any:
            try:
                return self.read(value)
            except RefusedError:
                return other.read(value)

        groups = tuple(dict.fromkeys((*self.groups, *other.groups)))
        return Kind(read, groups, self.compare and other.compare)


def _float(value: Any) -> float:
    if isinstance(value, (str, bytes, np.str_, complex, np.complexfloating)):
        raise RefusedError
    if isinstance(value, np.ma.core.MaskedConstant):
        raise RefusedError
    if isinstance(value, (np.datetime64, np.timedelta64)):
        raise RefusedError
    known = (numbers.Real, decimal.Decimal, np.bool_)
    if isinstance(value, known) or (isinstance(value, sm.Expr) and value.is_number):
        try:
            return float(value)
        except (OverflowError, TypeError, ValueError):
            raise RefusedError from None
    raise RefusedError


def _real(value: Any) -> float:
    if isinstance(value, np.ma.MaskedArray) and np.ma.getmaskarray(value).any():
        raise RefusedError
    if isinstance(value, np.ndarray) or (hasattr(value, "shape") and hasattr(value, "values")):
        value = np.asarray(value)
        if value.size != 1:
            raise RefusedError
        value = value.reshape(-1)[0]
    if isinstance(value, (list, tuple)) and len(value) == 1:
        value = value[0]
    return _float(value)


def real(
    *,
    finite: bool = True,
    least: float = -np.inf,
    above: float = -np.inf,
    most: float = np.inf,
    below: float = np.inf,
) -> Kind:
    """Return the kind of one number."""

    def read(value: Any) -> float:
        number = _real(value)
        if finite and not np.isfinite(number):
            raise RefusedError
        if not (least <= number <= most and (above < number or above == -np.inf)):
            if np.isnan(number) and not finite and (least, above) == (-np.inf, -np.inf):
                return number
            raise RefusedError
        if not (number < below or below == np.inf):
            raise RefusedError
        return number

    return Kind(read, ("common", "numbers"))


def integer(least: int, most: float = 2.0**63 - 1024, *, floor: bool = False) -> Kind:
    """Return the kind of whole numbers from `least` on; `floor`: of a fraction, the whole part."""

    def read(value: Any) -> int:
        if isinstance(value, (bool, np.bool_)) and not floor:
            raise RefusedError
        number = _real(value)
        if floor and number == np.inf:
            return 2**62
        if not np.isfinite(number) or number < least or not (floor or number == int(number)):
            raise RefusedError
        if number > most and not floor:
            raise RefusedError
        return min(int(number), 2**62)

    return Kind(read, ("common", "numbers"))


def _entries(value: Any) -> np.ndarray:
    if isinstance(value, np.ma.MaskedArray) and np.ma.getmaskarray(value).any():
        raise RefusedError
    if isinstance(value, (str, bytes, set, frozenset, dict)):
        raise RefusedError
    if isinstance(value, sm.MatrixBase):
        value = np.array(value.tolist(), dtype=object)
    if hasattr(value, "data_vars"):
        raise RefusedError
    if isinstance(value, np.ndarray) and value.size > 2**27:
        raise RefusedError
    if isinstance(value, range) and len(value) > 2**27:
        raise RefusedError
    if isinstance(value, memoryview):
        value = np.asarray(value)
    if np.isscalar(value) or isinstance(value, (numbers.Number, decimal.Decimal, sm.Expr)):
        return np.array(_float(value))
    if hasattr(value, "__array__") and (hasattr(value, "dtype") or hasattr(value, "iloc")):
        table = np.asarray(value)
    elif isinstance(value, Sequence):
        try:
            table = np.array([_entries(v) for v in value], dtype=float)
        except (ValueError, RecursionError):
            raise RefusedError from None
        return table
    else:
        raise RefusedError
    if table.dtype.kind in "biuf":
        return table.astype(float)
    if table.dtype.kind != "O":
        raise RefusedError
    return np.array([_float(v) for v in table.ravel()]).reshape(table.shape)


def array(
    *shapes: tuple[int | None, ...], check: Callable[[np.ndarray], Any] | None = None
) -> Kind:
    """Return the kind of arrays of some shapes (None: any length) for which `check` holds."""

    def read(value: Any) -> np.ndarray:
        try:
            table = _entries(value)
        except RefusedError:
            raise
        except Exception:
            raise RefusedError from None
        for shape in shapes:
            if len(shape) == table.ndim and all(
                a is None or a == b for a, b in zip(shape, table.shape, strict=True)
            ):
                break
        else:
            if not (table.size == 1 and (1,) in shapes):
                raise RefusedError
            table = table.reshape(1)
        if check is not None and not check(table):
            raise RefusedError
        return table

    return Kind(read, ("common", "arrays"))


def _flag(value: Any) -> bool:
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    if type(value) is int and value in (0, 1):
        return bool(value)
    raise RefusedError


def flag() -> Kind:
    """Return the kind of True and False; 0, 1 and NumPy's booleans stand for them."""
    return Kind(_flag, ("common", "flags"))


def choice(*options: Any, groups: tuple[str, ...] = ("common", "texts")) -> Kind:
    """Return the kind of one of a few values."""

    def read(value: Any) -> Any:
        for option in options:
            if type(value) in (type(option), np.str_) and value == option:
                return option
        raise RefusedError

    return Kind(read, groups)


def text(groups: tuple[str, ...] = ("common", "texts")) -> Kind:
    """Return the kind of any string."""

    def read(value: Any) -> str:
        if not isinstance(value, str):
            raise RefusedError
        return str(value)

    return Kind(read, groups)


def nothing(*groups: str, allowed: Callable[[Any], bool] = lambda value: False) -> Kind:
    """Return a kind of which no value tried here is right, but for those that are `allowed`."""

    def read(value: Any) -> Any:
        if allowed(value):
            return value
        raise RefusedError

    return Kind(read, ("common", *groups), compare=False)


def anything(*groups: str) -> Kind:
    """Return the kind of arguments that take any value."""
    return Kind(lambda value: value, ("common", *groups), compare=False)
