"""Thresholds of the analyses, each with what it was found by."""

from __future__ import annotations

__all__ = [
    "AT_BOUND",
    "AT_ONCE",
    "BENT",
    "BISECTED",
    "CROSSED",
    "DAMPED",
    "ENTRY",
    "FITTED",
    "LEAST_SIZE",
    "MARGIN",
    "NAMED",
    "NAMED_IN_FIT",
    "NEARLY_STRAIGHT",
    "ON_BRANCH",
    "ORBIT_CLOSED",
    "SETTLED",
    "SHORTEST_STEP",
    "SLOW",
    "SOLVABLE",
    "STEEPEST_TURN",
    "STILL",
    "TO_ROUNDING",
    "UNDETERMINED",
    "UNSOLVED_COLUMNS",
    "WHOLE_SHARE",
    "ZERO_ROOT",
]

# -- ranks and directions --------------------------------------------------------------------------

UNDETERMINED = 1e-8
"""The same for the scaled Jacobian of a fit, whose sensitivities are integrated."""

SOLVABLE = 1e-13
"""The same for a step to a periodic orbit, whose damping leaves no direction free."""

UNSOLVED_COLUMNS = 1e-6
"""What sensitivities leave of equations that they do not solve, in units of the terms."""

WHOLE_SHARE = 1e-9
"""Shares of a direction that differ by less are equal, and written without a factor."""

NAMED, NAMED_IN_FIT = 1e-6, 1e-4
"""Unknowns of which a free direction has less than this share of the most are not named; in fits
directions are known less well."""

# -- equilibria and their branches -----------------------------------------------------------------

TO_ROUNDING = 1e-14
"""Tolerances that end a search no sooner than rounding does."""

BENT, NEARLY_STRAIGHT = 0.3, 0.1
"""How far residuals may be from those of a line, in units of a step, for it to be taken, and for
the next to be longer."""

SETTLED = 1e4
"""A step of implicit Euler, in times of the fastest motion, that is one of Newton's method."""

AT_BOUND = 1e-9
"""How near to a bound a value lies at it, relative to the value."""

ON_BRANCH = 1e-11
"""Newton's last step to a point of a branch, in scaled unknowns."""

SHORTEST_STEP, STEEPEST_TURN = 1e-8, 1e-4
"""Steps along a branch, as arc length: shorter, it is lost; shorter than the second, it may turn
as it likes."""

BISECTED = 1e-13
"""The arc to which a fold, a crossing or a Hopf point is found."""

# -- eigenvalues -----------------------------------------------------------------------------------

ZERO_ROOT = 1e-7
"""Real parts along branches below this share of the largest eigenvalue are zero: those of double
roots come out at the square root of a rounding, 1e-8."""

CROSSED = 1e-6
"""The same in a sweep, whose equilibria are found one by one: those of coordinates that may be
anywhere."""

ENTRY = 1e-12
"""Entries of A below this share of the largest in their row are rounding errors."""

SLOW = 1e-6
"""Eigenvalues below this share of the largest are not drawn a Bode plot down to."""

# -- periodic orbits -------------------------------------------------------------------------------

ORBIT_CLOSED = 1e-9
"""The gap of an orbit that is closed, in units of its states, or how near the start then is to one
that closes, where unstable motion makes more of rounding: integrations are good to 1e-12."""

LEAST_SIZE = 1e-3
"""The least size of a state beside the largest one: a micrometre is closed to 1e-7 of it beside
0.1 m/s, and what a straight ride's rounding moves sideways is none."""

DAMPED = 1e-6
"""The least damping of a step that did not come nearer; ten times as much each further time."""

MARGIN = 1e-5
"""How far beyond 1 a multiplier may be computed that is 1: double ones come out at 1e-6."""

STILL = 1e-9
"""What states of an equilibrium change by in a period at their rates, in units of their sizes."""

# -- fits ------------------------------------------------------------------------------------------

FITTED = 1e-12
"""Relative changes of cost, parameters and gradient that end a fit: what integrations leave."""

# -- sweeps ----------------------------------------------------------------------------------------

AT_ONCE = 256
"""Values of a sweep between two looks at whether to go on."""
