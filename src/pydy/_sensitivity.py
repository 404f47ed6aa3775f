"""Sensitivities along a trajectory, with their names."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from pydy._names import name_of, unique_names


class SensitivityModel(Protocol):
    """What sensitivities may ask of the model they come from.

    At times (m,), states (m, n) and sensitivities of the states (m, n, k).
    """

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""


class Sensitivity:
    """Partial derivatives of a trajectory's quantities with respect to parameters.

    `System.simulate` finds them if its argument `sensitivities` names the parameters; they are the
    trajectory's attribute `sensitivity`. ``sensitivity['q1', 'm1']`` is ∂q1/∂m1 at all times, shape
    (m,), and ``sensitivity['q1']`` the derivatives of q1 by all parameters, shape (m, k). The
    quantities are the states and the outputs. A parameter that is a state's symbol is its initial
    condition. A specified that is given by samples has a column for each sample:
    ``sensitivity['q1', 'F']`` has the shape (m, samples).

    Parameters
    ----------
    values : ndarray, shape (m, n, k)
        Derivatives of the states.
    parameters : mapping of symbols to int
        The parameters, and their numbers of columns.
    states, outputs : sequence of symbols
    evaluate : callable
        Gives the derivatives of the outputs, shape (m, o, k), when they are first asked for.

    Attributes
    ----------
    values : ndarray, shape (m, n, k)
    counts : dict
        The parameters, with their numbers of columns.
    names : tuple of str
        Of the columns: those of the parameters; ``F[0]``, ``F[1]``, … for samples.
    """

    def __init__(
        self,
        values: np.ndarray,
        parameters: Mapping[Any, int],
        states: Sequence[Any],
        outputs: Sequence[Any],
        evaluate: Callable[[], np.ndarray],
    ) -> None:
        self.values = values
        self.counts = dict(parameters)
        names = unique_names(list(self.counts))
        self.names = tuple(
            name if count == 1 else f"{name}[{j}]"
            for name, count in zip(names, self.counts.values(), strict=True)
            for j in range(count)
        )
        self._columns: dict[Any, slice | int] = {name: k for k, name in enumerate(self.names)}
        start = 0
        for name, (symbol, count) in zip(names, self.counts.items(), strict=True):
            self._columns[name] = start if count == 1 else slice(start, start + count)
            self._columns[symbol] = self._columns[name]
            start += count
        symbols = (*states, *outputs)
        self.quantities = unique_names(symbols)
        self._places: dict[Any, int] = {str(symbol): k for k, symbol in enumerate(symbols)}
        self._places.update((name, k) for k, name in enumerate(self.quantities))
        self._places.update((symbol, k) for k, symbol in enumerate(symbols))
        self._evaluate = evaluate
        self._outputs: np.ndarray | None = None

    @property
    def parameters(self) -> tuple[Any, ...]:
        """The parameters, in the order of the columns."""
        return tuple(self.counts)

    @property
    def outputs(self) -> np.ndarray:
        """Derivatives of the outputs, shape (m, o, k), evaluated when first asked for."""
        if self._outputs is None:
            self._outputs = self._evaluate()
        return self._outputs

    def __getitem__(self, key: Any) -> np.ndarray:
        """Return the derivatives of a quantity, by one parameter or by all."""
        quantity, *parameter = key if isinstance(key, tuple) else (key,)
        k = _place(self._places, quantity, "states and outputs", self.quantities)
        n = self.values.shape[1]
        table = self.values[:, k] if k < n else self.outputs[:, k - n]
        for one in parameter:
            table = table[:, _place(self._columns, one, "parameters", self.names)]
        return table

    def table(self) -> np.ndarray:
        """Return the derivatives of all states and outputs, shape (m, n + o, k)."""
        return np.concatenate([self.values, self.outputs], axis=1)

    def __repr__(self) -> str:
        m, n, _ = self.values.shape
        return f"Sensitivity of {n} states to {', '.join(self.names)} at {m} times"


def _place(places: Mapping[Any, Any], key: Any, what: str, names: Sequence[str]) -> Any:
    place = places.get(key)
    if place is None:
        place = places.get(name_of(key))
    if place is None:
        raise KeyError(
            f"`{key}` is not one of the {what} of the sensitivities: {', '.join(names)}."
        )
    return place
