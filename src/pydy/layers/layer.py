"""A Layer: functions of a system that another library differentiates through.

On this side a function takes and returns NumPy arrays, with products of its Jacobian and vectors.
On the other side stand the arrays of a library. A Layer only reads arguments, so that each library
takes one file.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from pydy._checks import describe, merged

KINDS = {"x": "states", "r": "specifieds", "p": "constants"}
"""The kinds of symbols that the arrays of arguments hold."""


@dataclass(frozen=True)
class Part:
    """Which entries of x, t, r or p are arguments of a function."""

    group: str  # 'x', 't', 'r' or 'p'
    places: tuple[int, ...]
    counts: tuple[int, ...]  # how many numbers each is: samples of an input are several
    whole: bool = False  # all of the group, as one array

    @property
    def size(self) -> int:
        """The number of entries."""
        return sum(self.counts)


Given = tuple[np.ndarray, ...]


class Function(Protocol):
    """A function of some float64 arrays, and its derivatives, shape (…, *shape).

    All arrays have the same leading axes, one cell of them a sample; ``given[i]`` has one more,
    of the length of part i.
    """

    shape: tuple[int, ...]  # of a value
    parts: tuple[Part, ...]

    def value(self, *given: np.ndarray) -> np.ndarray:
        """Return the values."""

    def forward(self, wanted: tuple[int, ...], given: Given, along: Given) -> np.ndarray:
        """Return the derivatives along directions of the wanted arguments."""

    def backward(self, wanted: tuple[int, ...], given: Given, weights: np.ndarray) -> Given:
        """Return the derivatives of the weighted sum of the values by the wanted arguments."""


class Layer:
    """Functions of a system for another library; see `System.as_jax` and `System.as_torch`.

    They are of the system as it was when the Layer was made. Arguments that are not given have the
    values of then. A dictionary gives some entries, by symbol or name. Arrays may have further axes
    in front, which are broadcast against each other: each cell of these is a sample.
    """

    # The `functions` of a system as it was; the `arrays` of a library, as `JaxArrays` are.
    def __init__(self, functions: Any, arrays: Any, library: str) -> None:
        self._functions, self._arrays, self._library = functions, arrays, library

    def __repr__(self) -> str:
        names = describe(self._functions.places("x").symbols)
        return f"Layer for {self._library} of the states {names}"

    def ode(self, x: Any = None, t: Any = None, r: Any = None, p: Any = None) -> Any:
        """Return the derivatives of the states, as `System.evaluate_ode` does.

        Parameters
        ----------
        x : array, shape (…, n), or dict, optional
            States.
        t : array, shape (…), or float, optional
            Time.
        r : array, shape (…, s), or dict, optional
            Specifieds. An array stands for all of them, also those that the system has as
            expressions, samples or functions.
        p : array, shape (…, k), or dict, optional
            Constants.

        Returns
        -------
        array, shape (…, n)
        """
        return self._call("ode", x=x, t=t, r=r, p=p)

    def outputs(self, x: Any = None, t: Any = None, r: Any = None, p: Any = None) -> Any:
        """Return the outputs, as `System.evaluate_outputs` does.

        Parameters
        ----------
        x, t, r, p
            As in `ode`.

        Returns
        -------
        array, shape (…, o)
        """
        return self._call("outputs", x=x, t=t, r=r, p=p)

    def simulate(self, x: Any = None, r: Any = None, p: Any = None) -> Any:
        """Return the states at all times of the system.

        The derivatives are the sensitivities along the motion: their cost grows with the number of
        entries that are differentiated by.

        Parameters
        ----------
        x : array, shape (…, n), or dict, optional
            Initial conditions.
        r : array, shape (…, s), or dict, optional
            Specifieds that are numbers. In a dictionary a specified that the system has as a
            SampledInput is an array of its samples, shape (…, m).
        p : array, shape (…, k), or dict, optional
            Constants.

        Returns
        -------
        array, shape (…, m, n)
            NaN after a terminal event.
        """
        return self._call("simulate", x=x, r=r, p=p)

    def final(self, x: Any = None, r: Any = None, p: Any = None) -> Any:
        """Return the state at the end of the motion.

        Reverse derivatives are those of `System.adjoint_gradient`: their cost hardly depends on the
        number of entries.

        Parameters
        ----------
        x, r, p
            As in `simulate`.

        Returns
        -------
        array, shape (…, n)
        """
        return self._call("final", x=x, r=r, p=p)

    def _call(self, kind: str, **arguments: Any) -> Any:
        if all(value is None for value in arguments.values()):
            arguments["x"] = self._functions.start()
        parts, given = [], []
        for group, value in arguments.items():
            if value is not None:
                part, array = self._read(kind, group, value)
                parts.append(part)
                given.append(array)
        function = self._functions.function(kind, tuple(parts))
        try:
            alike = self._arrays.alike(given)
        except ValueError:
            shapes = [
                f"`{part.group}` {tuple(array.shape[:-1])}"
                for part, array in zip(parts, given, strict=True)
            ]
            raise ValueError(
                "The axes in front of arguments must be broadcast against each other, got "
                f"{', '.join(shapes)}."
            ) from None
        return self._arrays.call(function, alike)

    def _read(self, kind: str, group: str, value: Any) -> tuple[Part, Any]:
        if group == "t":
            return Part("t", (0,), (1,), True), self._arrays.array(value, "`t`")[..., None]
        places = self._functions.places(group)
        if not isinstance(value, Mapping):
            array, n = self._arrays.array(value, f"`{group}`"), len(places)
            if array.ndim == 0 or array.shape[-1] != n:
                raise ValueError(
                    f"`{group}` must have the shape (…, {n}), one entry for each of "
                    f"{describe(places.symbols)}, got {tuple(array.shape)}."
                )
            return Part(group, (*range(n),), (1,) * n, True), array
        if not value:
            raise ValueError(f"`{group}` must have at least one entry, got an empty dictionary.")
        value = merged(value)
        found = tuple(places.columns(value, group).tolist())
        counts = self._functions.counts(kind, group, found)
        columns = []
        for (key, entry), count in zip(value.items(), counts, strict=True):
            column = self._arrays.array(entry, f"`{group}[{key}]`")
            if count == 1:
                column = column[..., None]
            elif column.ndim == 0 or column.shape[-1] != count:
                raise ValueError(
                    f"`{group}[{key}]` must have the shape (…, {count}), one entry for each of its "
                    f"samples, got {tuple(column.shape)}."
                )
            columns.append(column)
        return Part(group, found, counts), self._arrays.together(columns)
