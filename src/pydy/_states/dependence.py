"""The implicit function theorem for constraints: derivatives of the dependent states.

The dependent states themselves are solved for in `dependent_states`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy._rank import DEPENDENT, DIGITS, equilibrated, independent_columns


def follow(
    values: np.ndarray,
    gradients: Sequence[np.ndarray],
    moved: np.ndarray,
    unknowns: Sequence[range],
    dependent: Sequence[int],
) -> bool:
    """Set the derivatives of dependent states; return whether the constraints determine them.

    From c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for the dependent states d. Coordinates
    are solved for first, and enter the equations of the speeds. In one linear system for both, the
    rank would depend on the unit of time.

    The rows of dependent states in `values` (n, k), which must be zero, are set in place. Each
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


def independent_places(
    jacobian: np.ndarray, dependent: Sequence[int]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the places of independent and dependent states.

    The Jacobian (c, n) of the constraints' residuals has rows and columns in units of their own;
    rows may depend on each other. What the user called `dependent` is taken if the constraints can
    be solved for it, and completed or replaced otherwise.
    """
    rank = len(independent_columns(jacobian))
    if rank < len(dependent):
        raise _singular(0)
    chosen = np.array(sorted(dependent), dtype=np.int64)
    if len(chosen) < rank or len(independent_columns(jacobian[:, chosen])) < rank:
        chosen = np.sort(independent_columns(jacobian))
    return np.setdiff1d(np.arange(jacobian.shape[1]), chosen), chosen


def _singular(k: int) -> ValueError:
    return ValueError(
        f"The constraints cannot be solved for the dependent states at state {k} of `at`: the "
        "configuration is singular there. Linearize at a nearby state."
    )


def tangents(
    jacobian: np.ndarray, free: np.ndarray, bound: np.ndarray, units: np.ndarray
) -> np.ndarray:
    """Return T (m, n, n - rank) with J T = 0 and rows of the identity at the independent states.

    The Jacobian (m, c, n) has columns as they are; `units` (m, n) are those of its columns, `free`
    and `bound` the places of independent and dependent states.
    """
    m, _, n = jacobian.shape
    result = np.zeros((m, n, len(free)))
    result[:, free, np.arange(len(free))] = 1.0
    if len(bound):
        held, moved = jacobian[:, :, bound] * units[:, None, bound], jacobian[:, :, free]
        left, sizes, right = np.linalg.svd(held, full_matrices=False)
        smallest = sizes[:, -1]
        if not smallest.min() > DEPENDENT:
            raise _singular(int(smallest.argmin()))
        # The pseudo-inverse from the same decomposition.
        projected = left.transpose(0, 2, 1) @ moved / sizes[:, :, None]
        solved = -right.transpose(0, 2, 1) @ projected
        result[:, bound] = units[:, bound, None] * solved
    return result
