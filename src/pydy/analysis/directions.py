"""Directions in which nothing changes, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def direction_text(direction: np.ndarray, names: Sequence[str], least: float) -> str:
    """Return a direction as a sum, its largest share 1: ``a - 0.5 c``.

    What has less than the `least` share of the largest is left out.
    """
    sizes = np.abs(direction)
    # The first of those that are as large to the digits shown: rounding decides nothing.
    shares = direction / direction[(sizes > 0.999 * sizes.max()).argmax()]
    parts = [
        {"1": "", "-1": "-"}.get(text := f"{share:.3g}", f"{text} ") + name
        for name, share in zip(names, shares, strict=True)
        if abs(share) > least
    ]
    return " + ".join(parts).replace("+ -", "- ")
