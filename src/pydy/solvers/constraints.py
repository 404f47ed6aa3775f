"""Constraints to be held during an integration, as a Kernel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pydy._kernel import Kernel

__all__ = ["CompiledConstraints"]

_DEPENDENT = 1e-9


@dataclass(frozen=True, eq=False)
class CompiledConstraints:
    """What the projection needs to know of a system.

    Attributes
    ----------
    kernel : Kernel
        Outputs, one after the other: holonomic residuals (h), velocity residuals (v), ∂h/∂q
        (h, q), N of q' = N u (q, u), ∂v/∂u (v, u), and the unreduced mass matrix (u, u) where
        `weighted`.
    holonomic, velocity, coordinates, speeds : int
    weighted : bool
        Whether corrections are measured by the mass matrix; by their square sum otherwise.
    names : tuple of str
        What to call the holonomic residuals, then the velocity residuals.
    """

    kernel: Kernel
    holonomic: int
    velocity: int
    coordinates: int
    speeds: int
    weighted: bool
    names: tuple[str, ...]

    def dependent(self, values: np.ndarray) -> list[str]:
        """Return the names of the constraints that follow from those before them.

        Parameters
        ----------
        values : ndarray
            What the kernel gives at some state.
        """
        part = {b.name: values[b.start : b.stop] for b in self.kernel.program.blocks}
        rows = [
            *(_dependent(part["gradient"].reshape(self.holonomic, self.coordinates))),
            *(_dependent(part["velocity_gradient"].reshape(self.velocity, self.speeds))),
        ]
        return [name for name, found in zip(self.names, rows, strict=True) if found]


def _dependent(rows: np.ndarray) -> list[bool]:
    """Tell which rows are combinations of earlier ones, whatever their lengths."""
    basis = np.empty((0, rows.shape[1]))
    found = []
    for row in rows:
        length = np.linalg.norm(row)
        rest = row / length if length else row
        for _ in range(2):  # once more for what rounding left
            rest = rest - basis.T @ (basis @ rest)
        size = np.linalg.norm(rest)
        found.append(bool(size < _DEPENDENT))
        if not found[-1]:
            basis = np.vstack([basis, rest / size])
    return found
