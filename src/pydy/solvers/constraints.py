"""The constraints of a system, compiled for the projection."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from pydy._kernel import Kernel
from pydy.solvers.tuning import DEPENDENT, HALF, ROUNDING, ROUNDINGS


@dataclass(frozen=True, eq=False)
class CompiledConstraints:
    """The constraints of a system, for the projection of states onto them."""

    # Outputs, one after the other: holonomic residuals (h), velocity residuals (v), ∂h/∂q (h, q),
    # N of q' = N u (q, u), ∂v/∂u (v, u), the unreduced mass matrix (u, u) where `weighted`, and
    # bounds on the rounding errors of the holonomic residuals (h).
    kernel: Kernel
    holonomic: int
    velocity: int
    coordinates: int
    speeds: int
    dependent_speeds: tuple[int, ...]  # positions of those taken from the velocity constraints
    weighted: bool  # whether corrections are measured by the mass matrix; else by their square sum
    # Whether to reject a step whose errors do not explain its residuals: if rows depend on time or
    # on residuals. Inputs with rates of their own, such as samples, do not count: they agree only
    # as well as they were measured.
    judged: bool
    # The coordinates that the others determine: projection may change them by any amount.
    following: tuple[int, ...]
    names: Sequence[str]  # what to call the holonomic residuals, then the velocity residuals
    # How many of the holonomic, and of the velocity constraints are redundant: the last of each.
    left_out: tuple[int, int] = (0, 0)

    @staticmethod
    def satisfied(residuals: np.ndarray, bounds: np.ndarray) -> bool:
        """Return whether residuals are within their rounding errors.

        The bounds on their rounding errors are in units of 2⁻⁵²; see `pydy._graph.rounding`.
        """
        allowed = ROUNDINGS * ROUNDING * bounds + np.finfo(float).tiny  # an underflow is no error
        return bool((np.abs(residuals) <= allowed).all())

    def relative_change(self, before: np.ndarray, after: np.ndarray, span: float) -> np.ndarray:
        """Return the changes of states (..., n) relative to their scales, whatever the units.

        A state's scale is at least a rounding of the largest one of its kind, coordinate or speed;
        that of speeds is at least a rounding of the largest coordinate divided by the `span`.
        """
        first, last = self.coordinates, self.coordinates + self.speeds
        scales, change = np.abs(before), np.abs(after - before)
        far = scales[..., :first].max(axis=-1, initial=0.0, keepdims=True)
        far[far == 0.0] = 1.0
        fast = np.maximum(scales, np.abs(after))[..., first:last].max(
            axis=-1, initial=0.0, keepdims=True
        )
        fast = np.maximum(fast, HALF * far / (span or 1.0))
        scales[..., :first] += np.maximum(np.minimum(1.0, far), HALF * far)
        scales[..., first:] += np.maximum(np.minimum(1.0, fast), HALF * fast)
        change[..., list(self.following)] = 0.0
        return np.asarray(change / scales)

    def redundant(self, values: np.ndarray) -> list[str]:
        """Return the names of redundant constraints: linear combinations of earlier ones.

        Constraints already left out as redundant are not named. The values are the kernel's
        outputs in a state.
        """
        blocks = self.kernel.program.signature.by_block(values)
        gradient = blocks["gradient"].reshape(self.holonomic, self.coordinates)
        velocity = blocks["velocity_gradient"].reshape(self.velocity, self.speeds)
        dependent = _dependent(gradient) + _dependent(velocity)
        if any(dependent) and self.weighted:
            # Lengths and angles have no common unit: only the mass matrix compares them.
            by_speeds = gradient @ blocks["kinematics"].reshape(self.coordinates, self.speeds)
            weighted = _dependent(self._scaled(blocks, by_speeds))
            weighted += _dependent(self._scaled(blocks, velocity))
            dependent = [a and b for a, b in zip(dependent, weighted, strict=True)]
        indices = [k for k, is_so in enumerate(dependent) if is_so and not self._left_out(k)]
        return [self.names[k] for k in indices]  # names are printed when they are read

    def _left_out(self, k: int) -> bool:
        closed, redundant = self.left_out
        if k < self.holonomic:
            return k >= self.holonomic - closed
        return k >= self.holonomic + self.velocity - redundant

    def _scaled(self, blocks: Mapping[str, np.ndarray], rows: np.ndarray) -> np.ndarray:
        """Scale rows to the norm of corrections: the mass matrix's if it is positive definite."""
        if self.weighted:
            hessian = blocks["kinetic_hessian"].reshape(self.speeds, self.speeds)
            with suppress(np.linalg.LinAlgError):
                scaled: np.ndarray = np.linalg.solve(np.linalg.cholesky(hessian), rows.T).T
                return scaled
        return rows

    def nearness_to_rank_loss(
        self, values: np.ndarray, longest: np.ndarray, rank: int
    ) -> tuple[float, list[str]]:
        """Return how near the velocity constraints are to losing rank, and which ones are involved.

        The measure is the smallest singular value of their rows, of which `rank` are independent,
        in the norm of corrections and divided by their `longest` lengths along the motion; 1 if the
        rows are not finite. A combination of the named constraints vanishes where it is 0.
        """
        blocks = self.kernel.program.signature.by_block(values)
        rows = self._scaled(blocks, blocks["velocity_gradient"].reshape(self.velocity, self.speeds))
        if not np.isfinite(rows).all():
            return 1.0, []
        vectors, singular, _ = np.linalg.svd(rows / np.where(longest > 0.0, longest, 1.0)[:, None])
        parts = np.abs(vectors[:, rank - 1])
        names = self.names[self.holonomic :]
        return float(singular[rank - 1]), [
            name for name, part in zip(names, parts, strict=True) if part > 0.1 * parts.max()
        ]

    def determinacy(self, values: np.ndarray) -> float:
        """Return how near the velocity constraints are to not determining the dependent speeds.

        The measure is the smallest singular value of the columns of these speeds, with rows of
        length one; 1 if there are none.
        """
        blocks = self.kernel.program.signature.by_block(values)
        rows = blocks["velocity_gradient"].reshape(self.velocity, self.speeds)
        lengths = np.linalg.norm(rows, axis=1)
        if not self.dependent_speeds or not np.isfinite(rows).all() or not lengths.all():
            return 1.0
        columns = (rows / lengths[:, None])[:, list(self.dependent_speeds)]
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
