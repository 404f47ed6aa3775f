"""Thresholds of the System's tasks, each with its reason."""

from __future__ import annotations

__all__ = [
    "BESIDE",
    "BLOCK_BYTES",
    "DIGITS",
    "LARGEST_BLOCK",
    "NEARLY_SINGULAR",
    "NO_INERTIA",
    "SMALLEST_BLOCK",
    "TRIED",
]

TRIED = 64
"""Samples of an ensemble, or states along a trajectory, whose constraints are looked at.

One is enough to warn; 64 take milliseconds, and are spread over all.
"""

DIGITS = 1e-5
"""The part of each state by which it may miss the constraints: numbers are typed to six digits."""

BESIDE = 1e-3
"""How far beside a state, relative to it, the size of a constraint's gradient is taken.

In a singular configuration itself the gradient is rounding errors; they are far below this.
"""

NO_INERTIA = 1e-12
"""The inertia of a combination of speeds, in units of what each has alone, that is none."""

NEARLY_SINGULAR = 1e-6
"""A singular value, in units of the largest, near which steps become ever smaller."""

BLOCK_BYTES = 8e6
"""Results in a block of an ensemble, about: it fits the cache that processors share."""

SMALLEST_BLOCK = 64
"""Samples in a block: with fewer, lanes idle at its end for too long a part of the time."""

LARGEST_BLOCK = 8192
"""Samples in a block: with more, an interrupt waits, and threads end at different times."""
