"""Directions in which nothing changes, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._rank import HALF

__all__ = ["direction_text"]


def direction_text(direction: np.ndarray, names: Sequence[str], least: float) -> str:
    """Return a direction as a sum, its largest share first of all 1.

    Parameters
    ----------
    direction : ndarray, shape (n,)
    names : sequence of str
    least : float
        What has less than this share of the largest is left out.

    Examples
    --------
    >>> direction_text(np.array([0.5, 0.0, -0.25]), "abc", 1e-6)
    'a - 0.5 c'
    """
    shares = direction / direction[np.abs(direction).argmax()]
    parts = [
        name if abs(share - 1.0) < HALF else f"{share:.3g} {name}"
        for name, share in zip(names, shares, strict=True)
        if abs(share) > least
    ]
    return " + ".join(parts).replace("+ -", "- ")
