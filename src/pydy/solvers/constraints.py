"""The constraints of a system, compiled for the projection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pydy._kernel import Kernel
from pydy.solvers.tuning import HALF


class ConstraintSizes(NamedTuple):
    """Numbers of constraints, and of what they hold."""

    holonomic: int
    velocity: int
    coordinates: int
    speeds: int


@dataclass(frozen=True, eq=False)
class CompiledConstraints:
    """The constraints of a system, for the projection of states onto them."""

    # Outputs, one after the other: holonomic residuals (h), velocity residuals (v), ∂h/∂q (h, q),
    # N of q' = N u (q, u), ∂v/∂u (v, u), the unreduced mass matrix (u, u) where `weighted`, and
    # bounds on the rounding errors of the holonomic residuals (h).
    kernel: Kernel
    sizes: ConstraintSizes  # h, v, q, u
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

    def relative_change(self, before: np.ndarray, after: np.ndarray, span: float) -> np.ndarray:
        """Return the changes of states (..., n) relative to their scales, whatever the units.

        A state's scale is at least a rounding of the largest one of its kind, coordinate or speed;
        that of speeds is at least a rounding of the largest coordinate divided by the `span`.
        """
        first, last = self.sizes.coordinates, self.sizes.coordinates + self.sizes.speeds
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
