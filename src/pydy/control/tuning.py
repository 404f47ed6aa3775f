"""Numbers of the room for optimal control, each with its reason."""

from __future__ import annotations

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

ONE_DIGIT = 0.1
"""An interval's error is known when twice as many steps change it by less than this share; where
the error of an objective is more of it, not one digit is certain, and a warning says so."""

SECANTS = 8
"""Steps towards the control that minimises the Hamiltonian, for the estimate of the objective's
error: one is exact where the control is quadratic in it, as it mostly is."""

STEP = 2.0**-13
"""The step, as a share of the control's size, that tells how its derivative bends: the root of the
rounding, about, so that half of the digits are right."""

JUMPS = 4
"""Intervals in which a control may go back and forth for another reason than a singular arc: it
jumps at both ends of an arc, where its polynomials overshoot in an interval and the next one."""

NODE_DEVIATION = 10
"""How many tolerances of a mesh a simulation from the start on may be beside a node: errors of ten
intervals that all count in full, of the hundreds that stable motions have."""

MOST_STEPS = 64
"""Steps of order 8 in an interval, at most: where these are not enough, as with a jump of a signal
inside, the error of the interval is large itself."""

MOST_PARTS = 4
"""Parts that an interval is divided into at once. A control that jumps or bends inside makes the
error fall more slowly than the order of the method tells; a next refinement then sees where."""

MOST_REFINEMENTS = 12
"""Meshes that are tried, at most. Intervals are halved at least: the last ones are 2048 times
shorter, which puts a jump of a control within that share of the motion."""

LARGEST_ORDER = 50
"""Points of an interval, at most. Derivatives at K points are of the size K², so that rounding
leaves 1e-13 of them here; each point depends on all others, which makes the Jacobian full."""

FIT_ORDER = 5
"""Radau points of an interval of a fit: errors fall with the ninth power of its length, so that
the few intervals of a smooth motion reach the accuracy of an integration."""

LEAST_FIT_ERROR = 1e-10
"""An interval's relative error that is small enough without noise too, as for the integrations of
a fit: hundreds of intervals add up to a few of their tolerances of 1e-9."""

PROXIMAL, STEADY = 1e-9, 3
"""What is added to the diagonal where the equations leave it zero, and how often the result is
corrected for that: each time reduces the effect by this share of the smallest eigenvalue that is
not zero."""

MOST_CORRECTIONS, CONVERGED_SHARE = 10, 0.03
"""How often the likelihood's slope is computed anew, at most, and the share of a standard error
by which the estimates then still move: a thirtieth adds a thousandth to the variance."""

WARM_BARRIER = 1e-6
"""The barrier with which a search begins that has the multipliers of a similar problem, and how far
from its bounds: between 0.1, which loses them, and the last one of 1e-10, from which bounds that
are no longer active are left slowly."""

PLOTTED = 8
"""Points of a plotted curve in each interval."""

WIDE = 1e6
"""Bounds that are as many times wider than what guess, ends and equations tell are no sizes: where
an unknown is a millionth of its unit, `TOLERANCE` leaves 1e-8 of the objective and 1e-4 of it."""

UNEVEN = 1e-3
"""The equations of an interval have a unit of their own where others are shorter than this share of
it. Their rates would be the unit of all, in which `TOLERANCE` is 1e-6 at most."""

LEAST_MESH_TOL = 1.5e-14
"""The least `mesh_tol`: 64 units of rounding. The integration of an interval with up to 64 steps
leaves as much, on any mesh, which would be divided for ever."""

STORED_FUNCTIONS = 16
"""Functions of points that a model keeps for further problems: a problem has at most five, of its
points, start, ends, samples and parameters, so that three in turn derive nothing anew."""

PULLS = 0.1, 1e-3
"""Standard deviations of parameters' relative changes, one over them as shares of the samples over
their noise, in searches that come before the one without: with the first one, no samples are
matched better by constants that are all zero, and after the second one the last step is small."""

SURFACE_POINTS, SURFACE_STEPS = 96, 60
"""Points from which a surface where an expression may jump is looked for, and steps of Newton's
method towards it: each step takes what a linear switch leaves of an unknown that is zero there down
by the rounding, so that some twenty are enough to underflow; others are for curved ones."""

ON_SURFACE = 4.0
"""Rounding bounds that a switch may be beside zero, and the square of it those of the difference of
both sides there: the last step of Newton's method moves a point by a few roundings."""

RESOLVED, LAYERS = 0.1, 4
"""By how much moments of a motion have to decrease from one degree to the next for the estimate of
the objective's error by multipliers: in exp(−z s), z is then 1.4, and the next degree has a
fourteenth. Of other intervals, the number that are solved anew on a finer mesh, at most."""

HALVINGS = 9
"""How often a finer mesh of one interval is halved towards both of its ends: a layer of a
five-hundredth of the interval then has an interval of its own."""
