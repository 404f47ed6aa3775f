"""Constraints to be held during an integration, as a Kernel."""

from __future__ import annotations

from dataclasses import dataclass

from pydy._kernel import Kernel

__all__ = ["CompiledConstraints"]


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
    """

    kernel: Kernel
    holonomic: int
    velocity: int
    coordinates: int
    speeds: int
    weighted: bool
