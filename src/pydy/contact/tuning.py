"""Thresholds of exact contacts. All are shares of what is compared, or counts."""

import math

from pydy._rank import HALF, ROUNDING
from pydy.solvers import NO_LATER

SLACK = HALF
"""An inequality between forces or accelerations holds if it is missed by this share of the largest
that take part. Events are located to rounding, but in states that have errors of integration:
forces that are equal there agree in half their digits."""

WITHIN = 2.0**10
"""A gap or a sliding speed is zero within so many of its bounds on rounding errors: initial
conditions may have been computed in some hundred operations."""

RESOLUTION = NO_LATER * ROUNDING
"""Events whose times differ by less, in units of the time, happen at the same instant: the solver
locates them to rounding."""

CHECKED = 33
"""States of each part of a motion at which gaps and normal forces are looked at again."""

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

DRAWS = 32
"""Values of the constants, and of the states for each of them, at which the pieces of a gap are
compared: five times in a row occur in any order, as far as two that follow each other tell."""
