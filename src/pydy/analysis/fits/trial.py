"""One measured motion, as a user gives it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import (
    ascending,
    check_copied,
    check_mapping,
    number,
    one_or_more,
    real_array,
    shown,
)
from pydy._names import some, text_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import ExpressionOrName, SymbolOrName


@dataclass(frozen=True, eq=False, repr=False)
class Trial:
    """One measured motion.

    Parameters
    ----------
    times : array_like, shape (m,)
        Sampling times, ascending.
    measured : dict or pandas.DataFrame
        Maps measured quantities to their samples, shape (m,), with NaN for missing ones. The
        quantities are states and outputs, by symbol or name, and expressions of states, specifieds
        and constants.
    initial_conditions, constants, specifieds : dict, optional
        Known values for this trial; all others are the System's.
    unknown : iterable of states, optional
        States whose initial conditions are estimated for this trial only; the search starts from
        `initial_conditions`.
    noise : float, array_like or dict, optional
        The standard deviation of the noise: of all quantities, or of each measured quantity, as a
        number or a value for each sample. By default it is estimated from the residuals; `priors`
        and `process_noise` need it.
    start : float, optional
        The time of the initial conditions; the first of the times by default.
    name : str, optional
        Name used in results and messages.

    Raises
    ------
    TypeError, ValueError
        Times that do not ascend, samples of another shape than the times, noise that is not
        positive, or arguments of another type. Names are compared with a System by its `fit`.

    Examples
    --------
    >>> from pydy.analysis import Trial
    >>> trial = Trial([0.0, 0.1, 0.2], {'q1': [0.3, 0.28, 0.21]}, noise=0.01)
    """

    times: ArrayLike
    measured: Mapping[ExpressionOrName, ArrayLike]
    initial_conditions: Mapping[SymbolOrName, float] = field(default_factory=dict)
    constants: Mapping[SymbolOrName, float] = field(default_factory=dict)
    specifieds: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object] = field(
        default_factory=dict
    )
    unknown: Iterable[SymbolOrName] | SymbolOrName = ()
    noise: ArrayLike | Mapping[ExpressionOrName, ArrayLike] | None = None
    start: float | None = None
    name: str = ""

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise TypeError(f"`name` of a trial must be a string, got {shown(self.name)}.")
        label = self.name or "the trial"
        if isinstance(self.times, np.ndarray):
            check_copied(self.times, f"`times` of {label}")
            object.__setattr__(self, "times", self.times.copy())
        if hasattr(self.measured, "columns"):  # a pandas.DataFrame
            columns = {key: np.array(self.measured[key]) for key in self.measured.columns}
            object.__setattr__(self, "measured", columns)
        if isinstance(self.measured, Mapping):  # whose buffers may be used again
            for key, samples in self.measured.items():
                check_copied(samples, f"`measured[{text_of(key)}]` of {label}")
            arrays = {k: v.copy() for k, v in self.measured.items() if isinstance(v, np.ndarray)}
            object.__setattr__(self, "measured", {**self.measured, **arrays})
        for argument in ("initial_conditions", "constants", "specifieds"):
            check_mapping(f"{argument} of {label}", getattr(self, argument))
        unknown = one_or_more(f"unknown of {label}", self.unknown)
        if isinstance(self.unknown, Iterator):  # which is used up
            object.__setattr__(self, "unknown", unknown)
        times, _ = instants(self, label)
        checked_samples(self, label, times)
        noise = self.noise.values() if isinstance(self.noise, Mapping) else [self.noise]
        for entry in noise if self.noise is not None else ():
            checked_noise(entry, len(times), label)

    def __repr__(self) -> str:
        times, names = np.ravel(self.times), some([text_of(key) for key in self.measured])
        return f"Trial of {names} at {len(times)} times from {times[0]} to {times[-1]}"


def instants(trial: Trial, label: str) -> tuple[np.ndarray, float]:
    """Return the times of a trial, and when it starts."""
    times = real_array(trial.times, f"`times` of {label}")
    if times.ndim != 1 or not len(times):
        raise ValueError(f"`times` of {label} must have the shape (m,), got {times.shape}.")
    ascending(times, f"`times` of {label}", strict=True)
    begin = float(times[0])
    if trial.start is not None:
        begin = number(trial.start, f"`start` of {label}", finite=True)
        if begin > times[0]:
            raise ValueError(
                f"`start` of {label} must not lie after the first of the `times`, "
                f"{float(times[0])!r}, got {begin!r}."
            )
    return times, begin


def checked_samples(trial: Trial, label: str, times: np.ndarray) -> np.ndarray:
    """Return the samples of a trial, shape (m, q)."""
    measured = check_mapping(f"measured of {label}", trial.measured)
    if not measured:
        raise ValueError(f"`measured` of {label} must hold at least one quantity.")
    columns = []
    for key, samples in measured.items():
        subject = f"`measured[{text_of(key)}]` of {label}"
        column = real_array(samples, subject)
        if column.shape != times.shape:
            raise ValueError(
                f"{subject} must have the shape {times.shape}, a sample for "
                f"each of the `times`, got {column.shape}."
            )
        if np.isinf(column).any():
            raise ValueError(f"{subject} must be finite, or NaN where a sample is missing.")
        columns.append(column)
    values = np.stack(columns, axis=1)
    if np.isnan(values).all():
        raise ValueError(
            f"`measured` of {label} must hold at least one sample that is not NaN, got none. "
            "Leave the trial out."
        )
    return values


def checked_noise(entry: object, samples: int, label: str) -> np.ndarray:
    """Return the standard deviation of a quantity's noise, a number or one for each sample."""
    column = real_array(entry, f"`noise` of {label}")
    sound = ((column > 0.0) & (column < np.inf)).all()
    if column.shape not in ((), (samples,)) or not sound:
        raise ValueError(
            f"`noise` of {label} must be positive standard deviations, a finite number or "
            f"{samples} of them for each measured quantity, got {shown(entry)}. What is not "
            "known at a time is NaN in `measured`."
        )
    return column
