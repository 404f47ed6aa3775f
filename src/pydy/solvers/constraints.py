"""What projection onto the constraints needs of a system, as a Kernel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from pydy._kernel import Kernel
from pydy.solvers.tuning import DEPENDENT, HALF, ROUNDING, ROUNDINGS


@dataclass(frozen=True, eq=False)
class CompiledConstraints:
    """The constraints of a system as the projection needs them."""

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
    # Whether a step whose errors do not explain its residuals is rejected: where rows depend on
    # time or on residuals, but for inputs that have rates of their own, such as samples, which
    # agree as well as they were measured.
    judged: bool
    # The coordinates that follow from the others at once: they may be moved as far as it takes.
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

    def moved(self, before: np.ndarray, after: np.ndarray, span: float) -> np.ndarray:
        """Return how far states (..., n) have moved, in units of what they are beside their kind.

        In any units: what is rounding beside the largest of its kind is noise, and so are speeds
        beside one by which coordinates would change as much as they are over the whole `span`.
        """
        first, last = self.coordinates, self.coordinates + self.speeds
        size, moved = np.abs(before), np.abs(after - before)
        far = size[..., :first].max(axis=-1, initial=0.0, keepdims=True)
        far[far == 0.0] = 1.0
        fast = np.maximum(size, np.abs(after))[..., first:last].max(
            axis=-1, initial=0.0, keepdims=True
        )
        fast = np.maximum(fast, HALF * far / (span or 1.0))
        size[..., :first] += np.maximum(np.minimum(1.0, far), HALF * far)
        size[..., first:] += np.maximum(np.minimum(1.0, fast), HALF * fast)
        moved[..., list(self.following)] = 0.0
        return np.asarray(moved / size)

    def dependent(self, values: np.ndarray) -> list[str]:
        """Return the names of redundant constraints: linear combinations of earlier ones.

        Constraints already left out as redundant are not named. The values are the kernel's at some
        state.
        """
        part = self.kernel.program.by_block(values)
        gradient = part["gradient"].reshape(self.holonomic, self.coordinates)
        velocity = part["velocity_gradient"].reshape(self.velocity, self.speeds)
        found = _dependent(gradient) + _dependent(velocity)
        if any(found) and self.weighted:
            # Lengths beside angles have no common unit: only the masses compare them.
            reach = gradient @ part["kinematics"].reshape(self.coordinates, self.speeds)
            alike = _dependent(self._measured(part, reach))
            alike += _dependent(self._measured(part, velocity))
            found = [a and b for a, b in zip(found, alike, strict=True)]
        told = [k for k, own in enumerate(found) if own and not self._left_out(k)]
        return [self.names[k] for k in told]  # printed if told

    def _left_out(self, k: int) -> bool:
        closed, redundant = self.left_out
        if k < self.holonomic:
            return k >= self.holonomic - closed
        return k >= self.holonomic + self.velocity - redundant

    def _measured(self, part: Mapping[str, np.ndarray], rows: np.ndarray) -> np.ndarray:
        """Scale rows to the norm of corrections: the mass matrix's if it is positive definite."""
        if self.weighted:
            hessian = part["kinetic_hessian"].reshape(self.speeds, self.speeds)
            with suppress(np.linalg.LinAlgError):
                measured: np.ndarray = np.linalg.solve(np.linalg.cholesky(hessian), rows.T).T
                return measured
        return rows

    def combination(
        self, values: np.ndarray, longest: np.ndarray, rank: int
    ) -> tuple[float, list[str]]:
        """Return how near the velocity constraints are to losing rank, and which ones are involved.

        That is the least singular value of their rows in units of the `longest` that they are
        elsewhere, in the norm of corrections, where they have this rank; 1 where the rows are not
        finite. The combination of the constraints that are named then vanishes.
        """
        part = self.kernel.program.by_block(values)
        rows = self._measured(part, part["velocity_gradient"].reshape(self.velocity, self.speeds))
        if not np.isfinite(rows).all():
            return 1.0, []
        left, sizes, _ = np.linalg.svd(rows / np.where(longest > 0.0, longest, 1.0)[:, None])
        parts = np.abs(left[:, rank - 1])
        names = self.names[self.holonomic :]
        return float(sizes[rank - 1]), [
            name for name, size in zip(names, parts, strict=True) if size > 0.1 * parts.max()
        ]

    def determinacy(self, values: np.ndarray) -> float:
        """Return how near the velocity constraints are to not determining the dependent speeds.

        That is the least singular value of their rows' part that belongs to these speeds, in units
        of the rows' lengths; 1 where there are none.
        """
        part = self.kernel.program.by_block(values)
        rows = part["velocity_gradient"].reshape(self.velocity, self.speeds)
        lengths = np.linalg.norm(rows, axis=1)
        if not self.dependent_speeds or not np.isfinite(rows).all() or not lengths.all():
            return 1.0
        given = (rows / lengths[:, None])[:, list(self.dependent_speeds)]
        return float(np.linalg.svd(given, compute_uv=False)[-1])


def _dependent(rows: np.ndarray) -> list[bool]:
    """Return which rows are linear combinations of earlier ones, regardless of their lengths."""
    basis = np.empty((0, rows.shape[1]))
    found = []
    for row in rows:
        length = np.linalg.norm(row)
        rest = row / length if length else row
        for _ in range(2):  # once more for what rounding left
            rest = rest - basis.T @ (basis @ rest)
        size = np.linalg.norm(rest)
        found.append(bool(size < DEPENDENT))
        if not found[-1]:
            basis = np.vstack([basis, rest / size])
    return found
