"""A Layer: functions of a system that another library differentiates through.

A `LayerFunction` takes and returns NumPy arrays, and computes products of its Jacobian with
vectors. An adapter (`JaxArrays`, `TorchArrays`) connects it to the arrays of a library, one file
for each library. A Layer reads the arguments and calls the adapter.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from pydy._checks import describe, merged

KINDS = {"x": "states", "r": "specifieds", "p": "constants"}
"""The kinds of symbols in the arrays of arguments."""


@dataclass(frozen=True)
class ArgumentPart:
    """The entries of x, t, r or p that are an argument of a function."""

    group: str  # 'x', 't', 'r' or 'p'
    indices: tuple[int, ...]
    counts: tuple[int, ...]  # numbers per entry: a sampled input has one for each sample
    is_full: bool = False  # True if the argument is the array of the complete group

    @property
    def size(self) -> int:
        """The number of entries."""
        return sum(self.counts)


def replaced_specifieds(parts: Sequence[ArgumentPart]) -> tuple[int, ...]:
    """Return the indices of the specifieds that an argument gives."""
    return next((part.indices for part in parts if part.group == "r"), ())


Arrays = tuple[np.ndarray, ...]


class LayerFunction(Protocol):
    """A function of some float64 arrays, and its derivatives, shape (…, *shape).

    All arrays have the same leading axes, which are those of samples. ``arrays[i]`` has one more
    axis, of the size of part i. `wrt` lists the arguments to differentiate by, as indices of parts.
    """

    shape: tuple[int, ...]  # of a value
    parts: tuple[ArgumentPart, ...]

    def value(self, *arrays: np.ndarray) -> np.ndarray:
        """Return the values."""

    def forward(self, wrt: tuple[int, ...], arrays: Arrays, directions: Arrays) -> np.ndarray:
        """Return the Jacobian-vector product, with a direction for each argument of `wrt`."""

    def backward(self, wrt: tuple[int, ...], arrays: Arrays, weights: np.ndarray) -> Arrays:
        """Return the vector-Jacobian products of the weights, one for each argument of `wrt`."""


class Layer:
    """Functions of a system for another library; see `System.as_jax` and `System.as_torch`.

    The Layer uses the system's equations and values from the time of its creation. These values are
    the defaults of all arguments. A dictionary replaces some entries, by symbol or name. Arrays may
    have additional leading axes, which are broadcast against each other and number samples.
    """

    # `functions`: `LayerFunctions`; `arrays`: the adapter of a library, such as `JaxArrays`.
    def __init__(self, functions: Any, arrays: Any, library: str) -> None:
        self._functions, self._arrays, self._library = functions, arrays, library

    def __repr__(self) -> str:
        names = describe(self._functions.symbols("x"))
        return f"Layer for {self._library} of the states {names}"

    def ode(self, x: object = None, t: object = None, r: object = None, p: object = None) -> Any:
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

    def outputs(
        self, x: object = None, t: object = None, r: object = None, p: object = None
    ) -> Any:
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

    def simulate(self, x: object = None, r: object = None, p: object = None) -> Any:
        """Return the states at all times of the system.

        The derivatives are the sensitivities along the motion: their cost grows with the number of
        entries that are differentiated by.

        Parameters
        ----------
        x : array, shape (…, n), or dict, optional
            Initial conditions. A dictionary names all of them, or independent ones: dependent ones
            that the system solved for are solved for again.
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

    def final(self, x: object = None, r: object = None, p: object = None) -> Any:
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

    def _call(self, kind: str, **arguments: object) -> Any:
        if all(value is None for value in arguments.values()):
            arguments["x"] = self._functions.start()
        parts, arrays = [], []
        for group, value in arguments.items():
            if value is not None:
                part, array = self._read(kind, group, value)
                parts.append(part)
                arrays.append(array)
        function = self._functions.function(kind, tuple(parts))
        try:
            same_shape = self._arrays.broadcast(arrays)
        except ValueError:
            shapes = [
                f"`{part.group}` {tuple(array.shape[:-1])}"
                for part, array in zip(parts, arrays, strict=True)
            ]
            raise ValueError(
                "The axes in front of arguments must be broadcast against each other, got "
                f"{', '.join(shapes)}."
            ) from None
        return self._arrays.call(function, same_shape)

    def _read(self, kind: str, group: str, value: object) -> tuple[ArgumentPart, Any]:
        if group == "t":
            return ArgumentPart("t", (0,), (1,), True), self._arrays.array(value, "`t`")[..., None]
        if not isinstance(value, Mapping):
            symbols = self._functions.symbols(group)
            array, n = self._arrays.array(value, f"`{group}`"), len(symbols)
            if array.ndim == 0 or array.shape[-1] != n:
                raise ValueError(
                    f"`{group}` must have the shape (…, {n}), one entry for each of "
                    f"{describe(symbols)}, got {tuple(array.shape)}."
                )
            return ArgumentPart(group, (*range(n),), (1,) * n, True), array
        if not value:
            raise ValueError(f"`{group}` must have at least one entry, got an empty dictionary.")
        value = merged(value)
        indices = self._functions.columns(group, value)
        counts = self._functions.counts(kind, group, indices)
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
        return ArgumentPart(group, indices, counts), self._arrays.concatenate(columns)
