"""Thresholds of the analyses, each with what it was found by."""

# -- ranks and directions --------------------------------------------------------------------------

NAMED_IN_FIT = 1e-4
"""Parameters with less than this share of an undetermined direction are not named."""

# -- equilibria and their branches -----------------------------------------------------------------

BENT, NEARLY_STRAIGHT = 0.3, 0.1
"""How far residuals may be from those of a line, in units of a step, for it to be taken, and for
the next to be longer."""

ON_BRANCH = 1e-11
"""Newton's last step to a point of a branch, in scaled unknowns."""

STEEPEST_TURN = 1e-4
"""A step along a branch, as arc length: along shorter ones it may turn as it likes."""

# -- eigenvalues -----------------------------------------------------------------------------------

CROSSED = 1e-6
"""Real parts below this share of the largest eigenvalue are zero: those of double roots come out at
the square root of a rounding, 1e-8, and at more where equilibria are found one by one: those of
coordinates that may be anywhere. A Bode plot is not drawn down to such."""

ASTRAY = 4096.0
"""How much further from zero than by rounding of its matrix an eigenvalue of zero may be: matrices
at equilibria that are found are good to 1e-11, not to 1e-15. For simple eigenvalues this is far
below CROSSED: slow motions are told from none beside much faster ones."""

LEFT_AXIS = 1e-3
"""The real part, as a share of that at the next value, of a branch that just left the axis: it
grows as a root of the distance, a cubic one where three meet."""

LOOKED_AT = 32
"""Values of a sweep at which an eigenvalue is zero that is taken as zero at all of them."""

# -- periodic orbits -------------------------------------------------------------------------------

ORBIT = 1e-12
"""Tolerances of the integrations: their results are differenced. What moves by less over a period,
in units of its size, does not move."""

BEGINNING = 1e-3
"""An event that ends a period may be where it begins: it is looked for after this share."""

ORBIT_CLOSED = 1e-9
"""The gap of an orbit that is closed, in units of its states, or how near the start then is to one
that closes, where unstable motion makes more of rounding: integrations are good to 1e-12. States
that change by less in a period, at their rates, are those of an equilibrium."""

LEAST_SIZE = 1e-3
"""The least size of a state beside the largest one: a micrometre is closed to 1e-7 of it beside
0.1 m/s, and what a straight ride's rounding moves sideways is none."""

DAMPED = 1e-6
"""The least damping of a step that did not come nearer; ten times as much each further time."""

MARGIN = 1e-5
"""How far beyond 1 a multiplier may be computed that is 1: double ones come out at 1e-6."""

# -- fits ------------------------------------------------------------------------------------------

FITTED = 1e-12
"""Relative changes of cost, parameters and gradient that end a fit: what integrations leave."""

# -- sweeps ----------------------------------------------------------------------------------------

AT_ONCE = 256
"""Values of a sweep between two looks at whether to go on."""

LARGEST_RESIDUAL = 2.0**255
"""The largest residual, and derivative of one, that a search takes: SciPy forms third powers."""

CHANCE = 1e-4
"""How often residuals of white noise are taken for correlated: in one of ten thousand fits."""

THINNED = 0.1
"""The correlation that samples of AR(1) noise have which are taken from all for a fit: variances
are then by (1 + 0.1)/(1 − 0.1) too small at most, standard errors by a tenth."""

ON_GIVEN_MESH = 1e-6
"""What counts as the tolerance of a motion that was collocated on a mesh of the user's own, which
is not refined: three digits of it are taken to be right."""

ABOVE_TOLERANCE = 1e3
"""Tolerances of a motion, relative to its samples, that the residuals have to exceed to be noise:
errors of a whole motion are some hundred times those of a step, and they are correlated."""
