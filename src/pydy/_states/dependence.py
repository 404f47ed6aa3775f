"""The implicit function theorem for constraints: derivatives of the dependent states.

The module `dependent_states` solves for the dependent states themselves.
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

    From c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for the dependent states d. The equations
    are solved for the coordinates first, then for the speeds. In one linear system for both, the
    rank would depend on the unit of time.

    The rows of dependent states in `values` (n, k), which must be zero, are set in place. Each
    block of constraints has a gradient (c, n) by the states and a range of `unknowns`; `moved` is
    c_i x_i' + c_θ of all blocks, concatenated.
    """
    if not (all(np.isfinite(g).all() for g in gradients) and np.isfinite(moved).all()):
        return False
    ends = np.cumsum([len(g) for g in gradients])
    blocks = np.split(moved.reshape(ends[-1], -1), ends[:-1])
    solved: list[int] = []
    for gradient, residual, kind in zip(gradients, blocks, unknowns, strict=True):
        residual = residual + gradient[:, solved] @ values[solved]
        columns_of_kind = [k for k in dependent if k in kind]
        scaled, rows, columns = equilibrated(gradient[:, kind])
        at = [k - kind.start for k in columns_of_kind]
        left_vectors, sizes, right_vectors = np.linalg.svd(scaled[:, at], full_matrices=False)
        significant = sizes > DEPENDENT
        components = left_vectors.T[significant] @ (residual / rows) / sizes[significant, None]
        values[columns_of_kind] -= columns[0, at, None] * (
            right_vectors[significant].T @ components
        )
        solved += columns_of_kind
        with np.errstate(over="ignore", invalid="ignore"):
            size = (np.abs(gradient) @ np.abs(values) + np.abs(residual)) / rows
            unsolved = (
                np.abs(residual + gradient[:, columns_of_kind] @ values[columns_of_kind]) / rows
            )
        size = size.max(axis=0, initial=0.0)
        if not ((unsolved <= DIGITS * size).all() and np.isfinite(size).all()):
            return False
    return True


def independent_columns_of(
    jacobian: np.ndarray, dependent: Sequence[int]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the columns of independent and of dependent states.

    The Jacobian (c, n) of the constraints' residuals has scaled rows and columns; its rows may be
    linearly dependent. The user's `dependent` states are used if the constraints can be solved for
    them, and completed or replaced otherwise.
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

    The columns of the Jacobian (m, c, n) are not scaled; `units` (m, n) are their units. `free` and
    `bound` are the columns of independent and dependent states.
    """
    m, _, n = jacobian.shape
    result = np.zeros((m, n, len(free)))
    result[:, free, np.arange(len(free))] = 1.0
    if len(bound):
        bound_columns, moved = jacobian[:, :, bound] * units[:, None, bound], jacobian[:, :, free]
        left_vectors, sizes, right_vectors = np.linalg.svd(bound_columns, full_matrices=False)
        smallest = sizes[:, -1]
        if not smallest.min() > DEPENDENT:
            raise _singular(int(smallest.argmin()))
        # The pseudo-inverse from the same decomposition.
        projected = left_vectors.transpose(0, 2, 1) @ moved / sizes[:, :, None]
        solved = -right_vectors.transpose(0, 2, 1) @ projected
        result[:, bound] = units[:, bound, None] * solved
    return result
