"""Thresholds that compiled code and Python share."""

from __future__ import annotations

__all__ = ["BLOCK", "LANES", "NEARLY_SINGULAR", "ROUNDINGS"]

BLOCK = 8
"""Numbers that the compiled loops work on side by side; vectors are padded to whole blocks."""

LANES = BLOCK
"""Trajectories of an ensemble that are integrated side by side, on every processor."""

ROUNDINGS = 8.0
"""The largest residual of a constraint that is satisfied, in units of its rounding bound."""

NEARLY_SINGULAR = 1e-5
"""How near to losing rank the rows of velocity constraints no longer tell the way on.

Positions, which are known to a rounding, tell two branches that cross apart down to its square
root, about 1e-8.
"""
