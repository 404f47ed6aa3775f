"""Directions in which nothing changes, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._rank import HALF


def direction_text(direction: np.ndarray, names: Sequence[str], least: float) -> str:
    """Return a direction as a sum, its largest share first of all 1: ``a - 0.5 c``.

    What has less than the `least` share of the largest is left out.
    """
    shares = direction / direction[np.abs(direction).argmax()]
    parts = [
        name if abs(share - 1.0) < HALF else f"{share:.3g} {name}"
        for name, share in zip(names, shares, strict=True)
        if abs(share) > least
    ]
    return " + ".join(parts).replace("+ -", "- ")
