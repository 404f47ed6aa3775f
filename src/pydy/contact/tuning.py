"""Thresholds of exact contacts. All are relative to the compared quantities, or counts."""

import math

from pydy._rank import HALF, ROUNDING
from pydy.solvers import NO_LATER

SLACK = HALF
"""Relative violation up to which an inequality between forces or accelerations is satisfied. Events
are located to rounding, but the states have integration errors: forces that are equal in theory
agree in half their digits."""

ROUNDING_MARGIN = 2.0**10
"""A gap or a sliding speed is zero within this multiple of its rounding bound: initial conditions
may have been computed in some hundred operations."""

RESOLUTION = NO_LATER * ROUNDING
"""Events whose times differ by less, relative to the time, are simultaneous: the solver locates
them to rounding."""

CHECKED = 33
"""Number of states of each segment at which gaps and normal forces are checked afterwards."""

TURN_LIMIT = 0.5
"""The cosine of the angle by which a sliding velocity may turn before its reference direction is
updated: its sign along that direction distinguishes a passage through zero from a turn. Also the
limit, in rad, of the rotation in a Newton step for a direction."""

RESOLVED = 2.0**-6
"""The fraction of the absolute tolerance below which a speed in a plane has no direction; the
resulting error is as small."""

BEGUN = 2.0**-10
"""The speed at which a sliding onset ends, relative to the speed gained without contact forces.
From there explicit methods need some thousand steps for the total time where friction turns the
velocity."""

ERRORS = 16.0
"""Error of a segment relative to the tolerance of one step. Errors of random sign grow as the
square root of the number of steps, here 256; segments rarely take more."""

CUTS = round(-math.log2(ROUNDING))
"""Limit of linear programs for the innermost forces. Each tangent plane at least halves the
distance to a cone; this many halvings lead from one to rounding."""

FEASIBLE = 1e-10
"""The tolerance of these linear programs, the finest that HiGHS takes; forces are of size one."""

TILT = FEASIBLE**0.5
"""Cost of a unit of normal force relative to a unit of cone margin, which bounds internal forces.
It is the geometric mean of one and the tolerance of the linear programs. Contacts with a smaller
coefficient of friction are not pressed together by internal forces."""

DRAWS = 32
"""Number of random values of the constants, and of states for each, at which the pieces of a gap
are compared. With this many, five switching times occur in all orders that matter for
neighbours."""
