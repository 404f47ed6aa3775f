"""Numbers of the room for optimal control, each with its reason."""

from __future__ import annotations

__all__ = [
    "INPUT_SAMPLES",
    "JUMP",
    "LARGEST_ORDER",
    "MOST_PARTS",
    "MOST_REFINEMENTS",
    "MOST_STEPS",
    "SURE",
    "TOLERANCE",
]

INPUT_SAMPLES = 129
"""Samples of a control on an interval. Even straight lines between them would be off by no more
than 1e-5 of how far the control bends there, 1/8 of the spacing squared."""

JUMP = 1e-6
"""The share of an interval in which a control that jumps at a node moves on: it changes the motion
by this share of what the jump does in the interval, which is below any tolerance of a mesh."""

TOLERANCE = 1e-9
"""The `tol` of IPOPT, for a program in units of its own: equations hold, and derivatives of the
Lagrangian vanish, to this share of their sizes. The barrier leaves a tenth of it of the objective
at each active bound, so that a thousand of them change the objective by 1e-7."""

SURE = 0.1
"""An interval's error is known when twice as many steps change it by less than this share."""

MOST_STEPS = 64
"""Steps of order 8 in an interval, at most: where these are not enough, as with a jump of a signal
inside, the error of the interval is large itself."""

MOST_PARTS = 4
"""Parts that an interval is divided into at once. A control that jumps or bends inside makes the
error fall more slowly than the order of the method tells; a next refinement then sees where."""

MOST_REFINEMENTS = 12
"""How often a mesh is refined, at most. Intervals are halved at least: they have then become 4096
times shorter, which puts a jump of a control within that share of the motion."""

LARGEST_ORDER = 50
"""Points of an interval, at most. Derivatives at K points are of the size K², so that rounding
leaves 1e-13 of them here; each point depends on all others, which makes the Jacobian full."""
