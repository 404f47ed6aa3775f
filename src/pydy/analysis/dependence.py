"""Derivatives of what depends on the rest through constraints: the implicit function theorem."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._rank import DEPENDENT, DIGITS, equilibrated


def follow(
    values: np.ndarray,
    gradients: Sequence[np.ndarray],
    moved: np.ndarray,
    unknowns: Sequence[range],
    dependent: Sequence[int],
) -> bool:
    """Let dependent states follow the others; tell whether the constraints determine them.

    From c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for the dependent states d. Coordinates
    first: in one system with the speeds, units of time would decide what its rank is.

    Of the derivatives `values` (n, k), those of the dependent states, zero before, are set. Each
    block of constraints has a gradient (c, n) by the states, and is solved for `unknowns`, those of
    its own kind; `moved` is c_i x_i' + c_θ of all blocks, one after the other.
    """
    if not (all(np.isfinite(g).all() for g in gradients) and np.isfinite(moved).all()):
        return False
    ends = np.cumsum([len(g) for g in gradients])
    blocks = np.split(moved.reshape(ends[-1], -1), ends[:-1])
    solved: list[int] = []
    for gradient, rest, kind in zip(gradients, blocks, unknowns, strict=True):
        rest = rest + gradient[:, solved] @ values[solved]
        places = [k for k in dependent if k in kind]
        scaled, rows, columns = equilibrated(gradient[:, kind])
        at = [k - kind.start for k in places]
        left, sizes, right = np.linalg.svd(scaled[:, at], full_matrices=False)
        kept = sizes > DEPENDENT
        along = left.T[kept] @ (rest / rows) / sizes[kept, None]
        values[places] -= columns[0, at, None] * (right[kept].T @ along)
        solved += places
        with np.errstate(over="ignore", invalid="ignore"):
            size = (np.abs(gradient) @ np.abs(values) + np.abs(rest)) / rows
            unsolved = np.abs(rest + gradient[:, places] @ values[places]) / rows
        size = size.max(axis=0, initial=0.0)
        if not ((unsolved <= DIGITS * size).all() and np.isfinite(size).all()):
            return False
    return True
