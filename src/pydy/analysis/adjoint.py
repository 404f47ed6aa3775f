"""The gradient of a scalar of a motion with respect to many parameters.

`System.adjoint_gradient` returns an `AdjointGradient`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._forks import cached_property
from pydy._names import column_names, name_of, some, unique_names


@dataclass(frozen=True, eq=False)
class AdjointGradient:
    """A scalar of a motion and its derivatives.

    ``gradient['m1']``, or with the symbol, is the derivative with respect to one parameter; for the
    samples of a specified it is an array with one entry for each.

    Attributes
    ----------
    value : float
        The sum of the final term and the integral.
    values : ndarray, shape (k,)
        Its derivatives with respect to all parameters, with one entry for each sample.
    counts : dict
        The parameters, with their numbers of columns.
    by_state : ndarray, shape (n,)
        Its derivatives with respect to the initial states, each varied independently: the adjoint
        there. NaN where several contacts close at one instant, which such variations part.
    time : float
        Where the motion ended: the last of the times, or a terminal event.
    statistics : dict
        Statistics of the integration; ``'steps'`` is the number of steps in the gradient.
    """

    value: float
    values: np.ndarray
    counts: Mapping[Any, int]
    by_state: np.ndarray
    time: float
    statistics: dict[str, Any]
    _motion: Callable[[], Any]

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters' names: ``F[0]``, ``F[1]``, … for samples."""
        return column_names(self.counts)

    @cached_property
    def trajectory(self) -> Any:
        """The motion at the System's times, as `System.simulate` returns it."""
        return self._motion()

    def __getitem__(self, parameter: Any) -> Any:
        """Return the derivative with respect to a parameter, given by symbol or name."""
        start, named = 0, unique_names(list(self.counts))
        for (symbol, count), name in zip(self.counts.items(), named, strict=True):
            if parameter == symbol or name_of(parameter) == name:
                part = self.values[start : start + count]
                return part.copy() if count > 1 else float(part[0])
            start += count
        if parameter in self.names:  # one sample
            return float(self.values[self.names.index(parameter)])
        raise KeyError(f"`{parameter}` is not one of the parameters: {some(self.names)}.")

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "trajectory": self.trajectory, "_motion": None}

    def __str__(self) -> str:
        shown = some(f"{n} {v:.6g}" for n, v in zip(self.names, self.values, strict=True))
        return f"Gradient of {self.value:.10g} by {shown}"

    __repr__ = __str__
