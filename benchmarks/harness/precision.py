"""Work against precision: which tolerances reach an error, and the time it takes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


@dataclass
class Point:
    """One integration of a scan.

    Attributes
    ----------
    tolerance, error : float
    seconds : float
        Of a single repetition.
    """

    tolerance: float
    error: float
    seconds: float


def difference(state: Sequence[float], reference: Sequence[float]) -> float:
    """Return the largest difference of a component, relative to one and its size together."""
    a, b = np.asarray(state), np.asarray(reference)
    return float(np.max(np.abs(a - b) / (1.0 + np.abs(b))))


def bracket(points: Sequence[Point], target: float) -> list[Point]:
    """Return the two neighbours in a scan between whose errors the target lies.

    An error counts as the largest from this tolerance on to tighter ones: a state that is right
    by chance gains nothing. One point where the loosest tolerance is good enough already; none
    where the target is never reached.
    """
    ordered = sorted(points, key=lambda p: -p.tolerance)
    sure: list[Point] = []
    worst = 0.0
    for point in reversed(ordered):
        worst = max(worst, point.error)
        sure.insert(0, Point(point.tolerance, worst, point.seconds))
    good = [k for k, point in enumerate(sure) if point.error <= target]
    if not good:
        return []
    return sure[max(0, good[0] - 1) : good[0] + 1]


def interpolate(points: Sequence[Point], seconds: Sequence[float], target: float) -> float:
    """Return the time at which the target is met, for what `bracket` gave, log-log."""
    if len(points) == 1 or points[0].error <= target:
        return seconds[-1]
    first, last = (math.log(max(p.error, 1e-17)) for p in points)
    part = (math.log(target) - first) / (last - first)
    return math.exp((1.0 - part) * math.log(seconds[0]) + part * math.log(seconds[1]))
