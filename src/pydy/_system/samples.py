"""Samples of an input as parameters: their weights in time, and the steps that these need."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pydy.inputs import SampledInput

__all__ = ["by_samples", "marker", "mean_spacing"]


def by_samples(parameter: Any) -> SampledInput:
    """Return the derivatives of a sampled input by each of its samples."""
    samples = parameter.samples
    assert samples is not None
    return SampledInput(samples.times, np.eye(parameter.count), samples.interpolation)


def mean_spacing(parameters: Sequence[Any]) -> float | None:
    """Return the least mean distance of the samples of one parameter in time."""
    times = [p.samples.times for p in parameters if p.samples is not None and p.count > 1]
    return min((float(one[-1] - one[0]) / (len(one) - 1) for one in times), default=None)


def marker(parameters: Sequence[Any]) -> SampledInput | None:
    """Return an input with a kink or a jump at the time of every sample.

    Samples in a line, such as zeros, leave no mark in the motion, though the derivatives by each
    of them have a kink or a jump there. The integral of this input is under the error control as
    one more state, so that the steps are short enough for those.
    """
    samples = [p.samples for p in parameters if p.samples is not None]
    if not samples:
        return None
    times = np.unique(np.concatenate([one.times for one in samples]))
    smooth = all(one.interpolation == "linear" for one in samples)
    values = np.where(np.arange(len(times)) % 2, -1.0, 1.0)[:, None]
    return SampledInput(times, values, "linear" if smooth else "previous")
