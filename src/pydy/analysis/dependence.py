"""Derivatives of what depends on the rest through constraints: the implicit function theorem."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy.analysis.tuning import FREE, UNSOLVED_COLUMNS

__all__ = ["follow"]


def follow(
    values: np.ndarray, gradient: np.ndarray, moved: np.ndarray, dependent: Sequence[int]
) -> bool:
    """Let dependent states follow the others; tell whether the constraints determine them.

    From c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for the dependent states d.

    Parameters
    ----------
    values : ndarray, shape (n, k)
        Derivatives of the states; those of the dependent ones, zero before, are set.
    gradient : ndarray, shape (c, n)
        Of the constraints by the states.
    moved : ndarray, shape (c, k)
        c_i x_i' + c_θ.
    dependent : sequence of int
    """
    places = list(dependent)
    if not (np.isfinite(gradient).all() and np.isfinite(moved).all()):
        return False
    solved, *_ = np.linalg.lstsq(gradient[:, places], -moved, rcond=FREE)
    values[places] += solved
    with np.errstate(over="ignore", invalid="ignore"):
        size = (np.abs(gradient) @ np.abs(values) + np.abs(moved)).max(axis=0)
        left = np.abs(gradient[:, places] @ solved + moved)
    return bool((left <= UNSOLVED_COLUMNS * size).all() and np.isfinite(size).all())
