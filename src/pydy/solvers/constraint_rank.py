"""Which constraints are independent in one state, and how nearly they are not."""

from __future__ import annotations

from contextlib import suppress

import numpy as np

from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.tuning import DEPENDENT


class ConstraintRank:
    """The gradients of constraints in one state, where the Kernel's outputs are `values`.

    Lengths and angles have no common unit. Rows are compared in the norm of corrections: that of
    the mass matrix, if corrections are weighted by it and it is positive definite.
    """

    def __init__(self, constraints: CompiledConstraints, values: np.ndarray) -> None:
        h, v, q, u = constraints.sizes
        self._constraints = constraints
        self._blocks = blocks = constraints.kernel.program.signature.by_block(values)
        self._gradient = blocks["gradient"].reshape(h, q)
        self._velocity = blocks["velocity_gradient"].reshape(v, u)
        self._kinematics = blocks["kinematics"].reshape(q, u)

    def redundant(self) -> list[str]:
        """Return the names of redundant constraints: linear combinations of earlier ones.

        Constraints already left out as redundant are not named.
        """
        names = self._constraints.names
        dependent = _dependent(self._gradient) + _dependent(self._velocity)
        if any(dependent) and self._constraints.weighted:
            weighted = _dependent(self._scaled(self._gradient @ self._kinematics))
            weighted += _dependent(self._scaled(self._velocity))
            dependent = [a and b for a, b in zip(dependent, weighted, strict=True)]
        indices = [k for k, is_so in enumerate(dependent) if is_so and not self._left_out(k)]
        return [names[k] for k in indices]  # names are printed when they are read

    def _left_out(self, k: int) -> bool:
        (h, v, *_), (closed, redundant) = self._constraints.sizes, self._constraints.left_out
        return k >= h - closed if k < h else k >= h + v - redundant

    def _scaled(self, rows: np.ndarray) -> np.ndarray:
        """Scale rows to the norm of corrections."""
        if self._constraints.weighted:
            u = self._constraints.sizes.speeds
            hessian = self._blocks["kinetic_hessian"].reshape(u, u)
            with suppress(np.linalg.LinAlgError):
                scaled: np.ndarray = np.linalg.solve(np.linalg.cholesky(hessian), rows.T).T
                return scaled
        return rows

    def nearness_to_rank_loss(self, longest: np.ndarray, rank: int) -> tuple[float, list[str]]:
        """Return how near the velocity constraints are to losing rank, and which ones are involved.

        The measure is the smallest singular value of their rows, of which `rank` are independent,
        in the norm of corrections and divided by their `longest` lengths along the motion; 1 if the
        rows are not finite. A combination of the named constraints vanishes where it is 0.
        """
        rows = self._scaled(self._velocity)
        if not np.isfinite(rows).all():
            return 1.0, []
        vectors, singular, _ = np.linalg.svd(rows / np.where(longest > 0.0, longest, 1.0)[:, None])
        parts = np.abs(vectors[:, rank - 1])
        names = self._constraints.names[self._constraints.sizes.holonomic :]
        return float(singular[rank - 1]), [
            name for name, part in zip(names, parts, strict=True) if part > 0.1 * parts.max()
        ]

    def determinacy(self) -> float:
        """Return how near the velocity constraints are to not determining the dependent speeds.

        The measure is the smallest singular value of the columns of these speeds, with rows of
        length one; 1 if there are none.
        """
        rows, dependent = self._velocity, list(self._constraints.dependent_speeds)
        lengths = np.linalg.norm(rows, axis=1)
        if not dependent or not np.isfinite(rows).all() or not lengths.all():
            return 1.0
        columns = (rows / lengths[:, None])[:, dependent]
        return float(np.linalg.svd(columns, compute_uv=False)[-1])


def _dependent(rows: np.ndarray) -> list[bool]:
    """Return which rows are linear combinations of earlier ones, regardless of their lengths."""
    basis = np.empty((0, rows.shape[1]))
    dependent = []
    for row in rows:
        length = np.linalg.norm(row)
        residual = row / length if length else row
        for _ in range(2):  # Gram–Schmidt, repeated because of rounding
            residual = residual - basis.T @ (basis @ residual)
        size = np.linalg.norm(residual)
        dependent.append(bool(size < DEPENDENT))
        if not dependent[-1]:
            basis = np.vstack([basis, residual / size])
    return dependent
