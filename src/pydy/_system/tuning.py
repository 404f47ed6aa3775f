"""Thresholds of the System's tasks, each with its reason."""

from __future__ import annotations

__all__ = [
    "BEGINNING",
    "BESIDE",
    "BLOCK_BYTES",
    "EXCESS",
    "FIT",
    "INSTANT",
    "LARGEST_BLOCK",
    "LEAST_SPREAD",
    "LEFT",
    "LOST",
    "NEAR_SINGULAR",
    "ORBIT",
    "SMALLEST_BLOCK",
    "TRIED",
]

EXCESS = 3.0
"""What the errors of long steps, and of states between them, may be in units of the tolerances."""

LEFT = 1e-2
"""The share of the states that errors of a method without error control may amount to."""

LOST = 1e-5
"""The share of the kinetic energy that roundings may change: ε/δ² a distance δ from a singular
position, down to where branches can no longer be told apart."""

TRIED = 64
"""Samples of an ensemble, or states along a trajectory, whose constraints are looked at.

One is enough to warn; 64 take milliseconds, and are spread over all.
"""

BESIDE = 1e-3
"""How far beside a state, relative to it, the size of a constraint's gradient is taken.

In a singular configuration itself the gradient is rounding errors; they are far below this.
"""

FIT, ORBIT = 1e-9, 1e-12
"""Tolerances of the integrations of fits and of periodic orbits: their results are differenced.

What moves by less than the second over a period, in units of its size, does not move."""

INSTANT = 1e-9
"""How long, in s, a part of a fit lasts that has a single sample, at its beginning."""

LEAST_SPREAD = 1e-2
"""The least scale of the states at which a fit joins parts, in units of their sizes."""

BEGINNING = 1e-3
"""An event that ends a period may be where it begins: it is looked for after this share."""

NEAR_SINGULAR = 0.05
"""How near constraints come to losing rank that the energy is looked at: steps that are far from
singular positions, beside which they are small, do not change it."""

BLOCK_BYTES = 8e6
"""Results in a block of an ensemble, about: it fits the cache that processors share."""

SMALLEST_BLOCK = 64
"""Samples in a block: with fewer, lanes idle at its end for too long a part of the time."""

LARGEST_BLOCK = 8192
"""Samples in a block: with more, an interrupt waits, and threads end at different times."""
