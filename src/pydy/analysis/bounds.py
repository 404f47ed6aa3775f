"""Bounds of unknowns: pairs of a lowest and a highest value."""

from __future__ import annotations

import numpy as np

from pydy._checks import real_array, shown


def limits(value: object, subject: str) -> tuple[float, float]:
    """Return the lowest and the highest value of a pair; None means unbounded."""
    pair = value
    if isinstance(value, (tuple, list)) and len(value) == 2:
        sides = zip(value, (-np.inf, np.inf), strict=True)
        pair = [end if side is None else side for side, end in sides]
    numbers = real_array(pair, subject)
    if numbers.shape != (2,) or not numbers[0] < numbers[1]:
        raise ValueError(
            f"{subject} must be a pair of the lowest and the highest value, got {shown(value)}."
        )
    return float(numbers[0]), float(numbers[1])
