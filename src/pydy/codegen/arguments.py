"""Turn what users pass for constants and specifieds into ordered arrays, in one place."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

__all__ = ["ConstantsArgument", "SpecifiedsArgument", "describe", "number", "real_array"]

ARGUMENT_TYPES = ("array", "dictionary", "function")


def describe(symbols: Sequence[Any]) -> str:
    """Return symbols as a list for a message, shortened when there are many."""
    shown = [str(s) for s in symbols[:12]]
    if len(symbols) > 12:
        shown.append(f"and {len(symbols) - 12} more")
    return ", ".join(shown) or "none"


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


def _vector(value: Any, size: int, what: str) -> np.ndarray:
    """Return a value as a float array of shape (size,)."""
    array = real_array(value, what)
    if array.ndim == 0 and size == 1:
        return array.reshape(1)
    if array.shape != (size,):
        raise ValueError(f"{what} must have the shape ({size},), got {array.shape}.")
    return array


class ConstantsArgument:
    """Reads the argument p.

    Parameters
    ----------
    symbols : sequence of Symbol
        In the order of the array.
    arg_type : {None, 'array', 'dictionary'}
        None looks at each value.
    """

    def __init__(self, symbols: Sequence[Any], arg_type: str | None = None) -> None:
        _check_type("constants_arg_type", arg_type, ("array", "dictionary"))
        self.symbols = list(symbols)
        self.arg_type = arg_type

    def __call__(self, p: Any) -> np.ndarray:
        """Return p as an array of shape (k,)."""
        as_dictionary = self.arg_type == "dictionary" or (
            self.arg_type is None and isinstance(p, Mapping)
        )
        if not as_dictionary:
            return _vector(p, len(self.symbols), "`p`, the constants,")
        if not isinstance(p, Mapping):
            raise ValueError(
                f"`p` must be a dictionary, as `constants_arg_type` says, got {type(p).__name__}."
            )
        missing = [s for s in self.symbols if s not in p]
        if missing:
            raise ValueError(
                f"`p` has no value for the constants {describe(missing)}: a dictionary must give "
                "all of them."
            )
        self._refuse_unknown(p)
        return np.array([number(p[s], f"`p[{s}]`") for s in self.symbols])

    def _refuse_unknown(self, p: Mapping[Any, Any]) -> None:
        unknown = [s for s in p if s not in self.symbols]
        if unknown:
            raise ValueError(
                f"`p` has values for {describe(unknown)}, which are not constants of the "
                f"equations: {describe(self.symbols)}."
            )


class SpecifiedsArgument:
    """Reads the argument r: an array, a function, or a dictionary of numbers and functions.

    Parameters
    ----------
    symbols : sequence of functions of time
        In the order of the array.
    arg_type : {None, 'array', 'dictionary', 'function'}
        None looks at each value.
    time_first : bool
        Whether functions are called as g(t, x).
    """

    def __init__(
        self, symbols: Sequence[Any], arg_type: str | None = None, time_first: bool = False
    ) -> None:
        _check_type("specifieds_arg_type", arg_type, ARGUMENT_TYPES)
        self.symbols = list(symbols)
        self.arg_type = arg_type
        self.time_first = time_first

    def __call__(self, r: Any, x: np.ndarray, t: float) -> np.ndarray:
        """Return r at one state and time as an array of shape (s,)."""
        kind = self.arg_type
        if kind is None:
            kind = (
                "dictionary" if isinstance(r, Mapping) else "function" if callable(r) else "array"
            )
        if kind == "array":
            return _vector(r, len(self.symbols), "`r`, the specifieds,")
        if kind == "function":
            if not callable(r):
                raise ValueError(
                    "`r` must be a function, as `specifieds_arg_type` says, got "
                    f"{type(r).__name__}."
                )
            return evaluate_function(r, self.symbols, x, t, self.time_first)
        if not isinstance(r, Mapping):
            raise ValueError(
                f"`r` must be a dictionary, as `specifieds_arg_type` says, got {type(r).__name__}."
            )
        return SpecifiedsPlan(r, self.symbols, time_first=self.time_first, complete=True)(x, t)


class SpecifiedsPlan:
    """A dictionary of specifieds, checked once and then evaluated many times.

    Parameters
    ----------
    values : mapping of a symbol, or a tuple of symbols, to a number, an array or a function
    symbols : sequence of functions of time
        All specifieds, in the order of the array.
    time_first : bool
        Whether functions are called as g(t, x).
    complete : bool
        Whether every symbol must have a value; missing ones are zero otherwise.

    Attributes
    ----------
    steps : list of (indices, number, array or function, symbols)
        In the order in which they are written; a later one overwrites.
    constant : bool
        Whether no function has to be called.
    base : ndarray, shape (s,)
        The values that are numbers.
    """

    def __init__(
        self,
        values: Mapping[Any, Any],
        symbols: Sequence[Any],
        *,
        time_first: bool = False,
        complete: bool = False,
        argument: str = "r",
        what: str = "",
    ) -> None:
        self.time_first = time_first
        self.steps: list[tuple[list[int], Any, list[Any]]] = []
        place = {s: k for k, s in enumerate(symbols)}
        seen: set[Any] = set()
        for key, value in values.items():
            names = list(key) if isinstance(key, (tuple, list)) else [key]
            for name in names:
                if name not in place:
                    raise ValueError(
                        f"`{argument}` has a value for `{name}`, which is not a specified of the "
                        f"system: {describe(symbols)}."
                    )
                if name in seen:
                    raise ValueError(f"`{argument}` gives `{name}` more than once.")
                seen.add(name)
            indices = [place[n] for n in names]
            if not callable(value):
                label = what or f"`{argument}` for {describe(names)}"
                if isinstance(key, (tuple, list)):
                    value = _vector(value, len(names), label)
                else:
                    value = number(value, label)
            self.steps.append((indices, value, names))
        missing = [s for s in symbols if s not in seen]
        if complete and missing:
            raise ValueError(f"`{argument}` has no value for the specifieds {describe(missing)}.")

        self._finish(len(symbols))

    def _finish(self, size: int) -> None:
        self.constant = not any(callable(value) for _, value, _ in self.steps)
        self.base = np.zeros(size)
        for indices, value, _ in self.steps:
            if not callable(value):
                self.base[indices] = value

    def updated(self, other: SpecifiedsPlan) -> SpecifiedsPlan:
        """Return this plan with another's values in place of its own, where the other has any."""
        result = SpecifiedsPlan({}, (), time_first=self.time_first)
        result.steps = [*self.steps, *other.steps]
        result._finish(len(self.base))
        return result

    def __call__(self, x: np.ndarray, t: float) -> np.ndarray:
        """Return a fresh array of all specifieds, shape (s,)."""
        r = np.zeros(len(self.base))
        for indices, value, names in self.steps:
            if callable(value):
                value = evaluate_function(value, names, x, t, self.time_first)
            r[indices] = value
        return r


def evaluate_function(
    function: Callable[..., Any],
    symbols: Sequence[Any],
    x: np.ndarray,
    t: float,
    time_first: bool = False,
) -> np.ndarray:
    """Call a user's function for some specifieds; an exception in it keeps its own type."""
    try:
        value = function(t, x) if time_first else function(x, t)
    except Exception as error:
        error.add_note(
            f"This came from the function given for the specifieds {describe(symbols)}, "
            f"called at t = {t!r}."
        )
        raise
    what = f"The function given for the specifieds {describe(symbols)}, called at t = {t!r},"
    size = len(symbols)
    array = real_array(value, what)
    if array.shape == (size,) or (size == 1 and array.shape == ()):
        return np.ascontiguousarray(array.reshape(size))
    shapes = "a float or the shape (1,)" if size == 1 else f"the shape ({size},)"
    raise ValueError(f"{what} must return {shapes}, got the shape {array.shape}.")


def _check_type(argument: str, value: str | None, allowed: tuple[str, ...]) -> None:
    if value is not None and value not in allowed:
        raise ValueError(
            f"`{argument}` must be None or one of {', '.join(map(repr, allowed))}, got {value!r}."
        )
