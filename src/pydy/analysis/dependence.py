"""Derivatives of what depends on the rest through constraints: the implicit function theorem."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._rank import DEPENDENT, DIGITS, equilibrated

__all__ = ["follow"]


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

    Parameters
    ----------
    values : ndarray, shape (n, k)
        Derivatives of the states; those of the dependent ones, zero before, are set.
    gradients : sequence of ndarray, shape (c, n)
        Of each block of constraints by the states.
    moved : ndarray, shape (sum of c times k,)
        c_i x_i' + c_θ of all blocks.
    unknowns : sequence of range
        The places of the states that each block is solved for: those of its own kind.
    dependent : sequence of int
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
