"""Thresholds of the System's tasks, each with its reason."""

from __future__ import annotations

__all__ = [
    "AGREED",
    "AT_REST",
    "BEGINNING",
    "BESIDE",
    "BLOCK_BYTES",
    "CANCELLED",
    "DIGITS",
    "EXCESS",
    "FIT",
    "INDEPENDENT",
    "INSTANT",
    "LARGEST_BLOCK",
    "LEAST_SPREAD",
    "LEFT",
    "LOST",
    "NEARLY_SINGULAR",
    "NEAR_SINGULAR",
    "NO_INERTIA",
    "ORBIT",
    "PULLED",
    "SMALLEST_BLOCK",
    "TRIED",
    "UNSOLVED",
]

AGREED = 1e-8
"""Differences of a Python function by two steps that agree so well are its derivative."""

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

DIGITS = 1e-5
"""A rounding of numbers that were typed to six digits."""

BESIDE = 1e-3
"""How far beside a state, relative to it, the size of a constraint's gradient is taken.

In a singular configuration itself the gradient is rounding errors; they are far below this.
"""

NO_INERTIA = 1e-12
"""The inertia of a combination of speeds, in units of what each has alone, that is none."""

INDEPENDENT = 1e-3
"""A singular value of constraints' rows of unit size that is not zero, at a state of six digits."""

UNSOLVED = 1e-8
"""What dependent speeds leave of equations that they do not solve, in units of the terms."""

CANCELLED = 1e-14
"""What coefficients that cancel leave, in units of their row and of the largest speed."""

FIT, ORBIT = 1e-9, 1e-12
"""Tolerances of the integrations of fits and of periodic orbits: their results are differenced."""

INSTANT = 1e-9
"""How long, in s, a part of a fit lasts that has a single sample, at its beginning."""

PULLED = 1e-9
"""What rounding may leave of an energy that is one of weights, in units of the energy."""

LEAST_SPREAD = 1e-2
"""The least scale of the states at which a fit joins parts, in units of their sizes."""

AT_REST = 1e-12
"""What moves by less than this, in units of its size, does not move."""

BEGINNING = 1e-3
"""An event that ends a period may be where it begins: it is looked for after this share."""

NEAR_SINGULAR = 0.05
"""How near constraints come to losing rank that the energy is looked at: steps that are far from
singular positions, beside which they are small, do not change it."""

NEARLY_SINGULAR = 1e-6
"""A singular value, in units of the largest, near which steps become ever smaller."""

BLOCK_BYTES = 8e6
"""Results in a block of an ensemble, about: it fits the cache that processors share."""

SMALLEST_BLOCK = 64
"""Samples in a block: with fewer, lanes idle at its end for too long a part of the time."""

LARGEST_BLOCK = 8192
"""Samples in a block: with more, an interrupt waits, and threads end at different times."""
