"""Bounds and guesses of states and controls, which may change over the motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._checks import number, real_array, shown
from pydy.inputs import SampledInput


@dataclass(frozen=True, eq=False)
class Limit:
    """A bound, or a guess, as a function of fractions of the duration."""

    values: Any  # a number, or values at equal distances over the motion, or at times
    duration: float | None = None  # of the motion, for samples at times

    def __call__(self, fractions: np.ndarray) -> np.ndarray:
        """Return the values at fractions of the duration."""
        if isinstance(self.values, SampledInput):
            assert self.duration is not None
            found: np.ndarray = self.values.rows(fractions * self.duration)[:, 0]
            return found
        if np.ndim(self.values) == 0:
            return np.full(len(fractions), float(self.values))
        even = np.linspace(0.0, 1.0, num=len(self.values))
        between: np.ndarray = np.interp(fractions, even, self.values)
        return between


def limit(value: Any, what: str, duration: float | None, *, finite: bool = False) -> Limit:
    """Return a guess, or a side of bounds, that the user gave; numbers may have to be finite."""
    if isinstance(value, SampledInput):
        if duration is None:
            raise ValueError(
                f"{what} has samples at times, and the duration is free. Give an array, whose "
                "values lie at equal distances over the motion."
            )
        if value.size != 1:
            raise ValueError(f"{what} must be samples of one value, got {value.size} a time.")
        return Limit(value, duration)
    samples = real_array(value, what)
    if samples.ndim == 0:
        return Limit(number(value, what, finite=finite))
    if samples.ndim != 1 or not len(samples) or not np.isfinite(samples).all():
        raise ValueError(
            f"{what} must be a finite number, or rows of finite numbers, got {shown(value)}."
        )
    return Limit(samples)
