"""Null directions as text."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def direction_text(direction: np.ndarray, names: Sequence[str], least: float) -> str:
    """Return a direction as a sum with the largest coefficient 1: ``a - 0.5 c``.

    Coefficients of at most `least` are omitted.
    """
    sizes = np.abs(direction)
    # The first of the coefficients that are largest to the digits shown, whatever their rounding.
    shares = direction / direction[(sizes > 0.999 * sizes.max()).argmax()]
    parts = [
        {"1": "", "-1": "-"}.get(text := f"{share:.3g}", f"{text} ") + name
        for name, share in zip(names, shares, strict=True)
        if abs(share) > least
    ]
    return " + ".join(parts).replace("+ -", "- ")
