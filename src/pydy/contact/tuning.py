"""Thresholds of exact contacts. All are shares of what is compared, or counts."""

from __future__ import annotations

import math

from pydy._rank import HALF, ROUNDING

CONTACTS = 8
"""Contacts that may be closed at the same time: up to 4⁸ combinations are tried."""

SLACK = HALF
"""An inequality between forces or accelerations holds if it is missed by this share of the largest
that take part. Events are located to rounding, but in states that have errors of integration:
forces that are equal there agree in half their digits."""

WITHIN = 2.0**10
"""A gap or a sliding speed is zero within so many of its bounds on rounding errors: initial
conditions may have been computed in some hundred operations."""

RESOLUTION = 16.0 * ROUNDING
"""Events whose times differ by less, in units of the time, happen at the same instant: the solver
locates them to rounding."""

INSTANT = 64
"""Transitions that may follow each other within `RESOLUTION`: several contacts take several."""

STALLED = 100_000
"""Transitions in one simulation, beyond which it does not come to an end."""

CHECKED = 33
"""States of each part of a motion at which gaps and normal forces are looked at again."""

SETTLING = 3
"""Newton steps from a state that is off by rounding: the second changes the last digits, if any."""

TURNS = 40
"""Newton steps for the directions in which contacts begin to slide."""

TURNED = 0.5
"""The cosine of the angle by which a sliding velocity may turn before its direction is noted again:
a velocity through zero is told from one that turns round by its sign along that direction. In rad,
the most by which a Newton step turns a direction."""

RESOLVED = 2.0**-6
"""The part of the absolute tolerance below which a speed in a plane has no direction: what this
changes is as small."""

BEGUN = 2.0**-10
"""The speed from which on a body slides like any other, in units of what it would gain without
contacts: explicit methods then need some thousand steps for the whole time, where friction turns
the velocity."""

FIRST = 16.0
"""The first step of a body that begins to slide in a plane, in units of `RESOLUTION`; a dozen steps
that grow as they may lead from there to any other size."""

ERRORS = 16.0
"""Errors of many steps, in units of the tolerance of one. They have either sign and add up as the
square root of their number: of 256 steps, and motions between two transitions rarely take more."""

CUTS = round(-math.log2(ROUNDING))
"""Linear programs for the innermost forces: each plane that touches a cone halves the distance to
it or more, and so many halves lead from one to rounding."""

FEASIBLE = 1e-10
"""The tolerance of these linear programs, the finest that HiGHS takes; forces are of size one."""

TILT = FEASIBLE**0.5
"""What a unit of normal forces is worth in margins of cones, where internal forces may be as large
as one likes: as far above what the linear programs resolve as below one. Contacts with a smaller
coefficient of friction are not pressed together to hold."""

SWEEPS = 4096
"""Sweeps over the contacts until their modes are told from their forces. Errors fall as
exp(−sweeps/κ) with the condition number κ of J M⁻¹ Jᵀ: half the digits take 18 κ, so that this is
enough for κ = 200. Beyond that all combinations are tried."""

DRAWS = 32
"""Values of the constants, and of the states for each of them, at which the pieces of a gap are
compared: five times in a row occur in any order, as far as two that follow each other tell."""
