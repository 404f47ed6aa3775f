"""Numerical parameters of optimal control, each with its reason."""

from __future__ import annotations

INPUT_SAMPLES = 129
"""Samples of a control on an interval. Linear interpolation between them has an error of 1/8 of the
spacing squared times the second derivative, which is below 1e-5."""

JUMP = 1e-6
"""The fraction of an interval over which a jump of a control at a node is spread. It changes the
motion by this fraction of the jump's effect in the interval, which is below any mesh tolerance."""

TOLERANCE = 1e-9
"""The `tol` of IPOPT for scaled programs: the relative residual of equations and of derivatives of
the Lagrangian. At each active bound the barrier changes the objective by a tenth of it, so that a
thousand active bounds change the objective by 1e-7."""

ONE_DIGIT = 0.1
"""An interval's error is accepted when doubling the steps changes it by less than this fraction. If
the relative error of an objective is larger, no digit is certain, and a warning is given."""

SECANTS = 8
"""Secant steps towards the control that minimises the Hamiltonian, for the estimate of the
objective's error. One is exact if the Hamiltonian is quadratic in the control, as is common."""

STEP = 2.0**-13
"""The step of finite differences, relative to the size of a control or state: about the square root
of the rounding unit, so that half of the digits are correct."""

JUMPS = 4
"""Intervals in which a control may oscillate without a singular arc: at the jumps at both ends of
an arc, its polynomials overshoot in an interval and in the next one."""

NODE_DEVIATION = 10
"""The largest deviation of a simulation from a node, in mesh tolerances: the sum of ten intervals'
errors. A stable motion damps the errors of earlier intervals, so that hundreds are allowed."""

MOST_STEPS = 64
"""The most steps of order 8 in an interval. If they do not suffice, as with a jump of a signal
inside, the error of the interval is large anyway."""

MOST_PARTS = 4
"""The most parts into which a refinement divides an interval. If a control jumps or bends inside,
the error falls more slowly than with the order of the method; the next refinement locates it."""

MOST_REFINEMENTS = 12
"""The most meshes that are tried. Each refinement at least halves the intervals that it divides, so
that the last ones are 2048 times shorter, which locates a jump of a control as closely."""

LARGEST_ORDER = 50
"""The most points of an interval. Derivatives at K points have the size K², so that rounding leaves
relative errors of 1e-13; each point depends on all others, which makes the Jacobian dense."""

FIT_ORDER = 5
"""Radau points of an interval of a fit. Errors are proportional to the ninth power of its length,
so that few intervals of a smooth motion reach the accuracy of an integration."""

LEAST_FIT_ERROR = 1e-10
"""The relative error of an interval that suffices without noise. The errors of hundreds of
intervals add up to a few times 1e-9, the tolerance of a fit's integrations."""

PROXIMAL, STEADY = 1e-9, 3
"""The regularisation of zero diagonal entries, and the number of iterative corrections of the
result. Each reduces the effect by the ratio of the first to the smallest nonzero eigenvalue."""

MOST_CORRECTIONS, CONVERGED_SHARE = 10, 0.03
"""The most updates of the likelihood's slope, and the largest remaining change of the estimates, in
standard errors, at which they have converged: a thirtieth adds a thousandth to the variance."""

WARM_BARRIER = 1e-6
"""The initial barrier, and the initial distance from bounds, of a search with the multipliers of a
similar problem: between 0.1, which discards them, and the final 1e-10, with which bounds that are
no longer active are left slowly."""

PLOTTED = 8
"""Points of a plotted curve in each interval."""

WIDE = 1e6
"""Bounds that exceed the sizes implied by guess, ends and equations by this factor are not used as
sizes. If an unknown is a millionth of its unit, `TOLERANCE` leaves relative errors of 1e-8 in the
objective and 1e-4 in the unknown."""

UNEVEN = 1e-3
"""The equations of intervals have separate scales if others are shorter than this fraction of their
length. Otherwise the rates of the shortest interval are the scale of all, and `TOLERANCE` is at
most 1e-6 relative to the longer ones."""

LEAST_MESH_TOL = 1.5e-14
"""The least `mesh_tol`: 64 rounding units. The integration of an interval with up to 64 steps
leaves as much on any mesh, so that a smaller tolerance would cause refinement without end."""

STORED_FUNCTIONS = 16
"""Compiled functions of points that a model stores for further problems. A problem has at most
five, of its points, start, ends, samples and parameters: three alternating problems need no new
code."""

PULLS = 0.1, 1e-3
"""Weights of a penalty on the parameters' relative changes, relative to the norm of the samples
over their noise, in searches before the one without penalty. The first keeps a fit from matching
the samples with constants that are all zero; after the second, the last step is small."""

SURFACE_POINTS, SURFACE_STEPS = 96, 60
"""Starting points of the search for a switching surface, and steps of Newton's method towards it.
For a linear switch each step reduces an unknown that is zero there by the rounding unit, so that
some twenty steps underflow; the others are for curved surfaces."""

ON_SURFACE = 4.0
"""The largest value of a switch on its surface, in rounding bounds; the square of it for the
difference of both sides. The last step of Newton's method moves a point by a few rounding units."""

RESOLVED, LAYERS = 0.1, 4
"""The largest ratio of a motion's moments of successive degrees at which multipliers estimate the
objective's error: for exp(−z s) it means z = 1.4, and the next degree has a fourteenth. Then the
most other intervals that are solved again on a finer mesh."""

HALVINGS = 9
"""The number of successive halvings of one interval towards each of its ends, for a finer mesh: a
boundary layer of a five-hundredth of the interval is then resolved by an interval."""
