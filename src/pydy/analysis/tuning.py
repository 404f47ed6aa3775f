"""Thresholds of the analyses, each with its reason."""

# -- ranks and directions --------------------------------------------------------------------------

NAMED_IN_FIT = 1e-4
"""Parameters with a smaller share of an undetermined direction are not named."""

# -- equilibria and their branches -----------------------------------------------------------------

LARGEST_NONLINEARITY, SMALL_NONLINEARITY = 0.3, 0.1
"""Largest nonlinearity of the residuals along a step, in units of the step: a step is accepted up
to the first, and the next one is longer up to the second."""

BRANCH_TOLERANCE = 1e-11
"""Largest size of the last Newton step to a point of a branch, in scaled unknowns."""

UNLIMITED_CURVATURE_STEP = 1e-4
"""Arc length of a step along a branch: the curvature along shorter steps is not limited."""

# -- eigenvalues -----------------------------------------------------------------------------------

ZERO_REAL_PART = 1e-6
"""Real parts below this share of the largest eigenvalue count as zero. Double roots, such as those
of coordinates that may be anywhere, are accurate to the square root of a rounding error, 1e-8, and
less if equilibria are computed one by one. A Bode plot ignores eigenvalues below this share."""

ZERO_EIGENVALUE_FACTOR = 4096.0
"""Largest magnitude of an eigenvalue of zero, in units of the rounding error of its matrix:
matrices at computed equilibria are accurate to 1e-11, not to 1e-15. For simple eigenvalues this is
far below ZERO_REAL_PART: slow motions are distinguished from zero beside much faster ones."""

DEPARTURE_REAL_PART = 1e-3
"""Largest real part at a computed departure from the axis, as a share of that at the next value: it
grows as a root of the distance, a cubic one if three branches meet."""

ZERO_CHECKS = 32
"""Values of a sweep at which an eigenvalue is tested: one that is zero at all of these counts as
zero at every value."""

# -- trial motions of searches ---------------------------------------------------------------------

MOST_TRIAL_STEPS = 100
"""Most steps of a trial motion, in units of those of the best one so far: those of a motion that is
a hundred times as fast, as with 10⁴ times the stiffness. One that diverges would take all of
`max_steps`, half a minute. A search that rejects a motion tries a nearer one, so that it also
reaches faster ones."""

# -- periodic orbits -------------------------------------------------------------------------------

ORBIT_TOLERANCE = 1e-12
"""Tolerances of the integrations; they are this tight because results are subtracted. A state that
moves by less over a period, in units of its size, does not move."""

SKIPPED_START = 1e-3
"""An event that ends a period may also occur at its start: this share of the period is skipped."""

LARGEST_GAP = 1e-9
"""Largest gap of a closed orbit, in units of its states; integrations are accurate to 1e-12. If
unstable motion amplifies rounding errors, it is the largest distance to a start whose orbit closes.
States that change by less in a period, at their rates, are those of an equilibrium."""

LEAST_SIZE = 1e-3
"""Smallest size of a state relative to the largest one: beside 0.1 m/s a micrometre is accurate to
1e-7, and the sideways motion of a straight ride, a rounding error, does not count."""

SMALLEST_DAMPING = 1e-6
"""Smallest damping after a step that did not reduce the gap; it grows tenfold each further time."""

MULTIPLIER_MARGIN = 1e-5
"""Largest amount by which a computed multiplier of 1 exceeds 1: double ones have errors of 1e-6."""

# -- fits ------------------------------------------------------------------------------------------

FIT_TOLERANCE = 1e-12
"""Relative changes of cost, parameters and gradient that end a fit: errors of the integrations."""

REPORT_INTERVAL = 0.1
"""Seconds between two reports of motions to a progress bar, as often as tqdm writes its own."""

# -- sweeps ----------------------------------------------------------------------------------------

VALUES_PER_PART = 256
"""Number of values of a sweep that are computed between two checks for Ctrl-C."""

LARGEST_RESIDUAL = 2.0**255
"""Largest residual, and derivative of one, that a search accepts: SciPy forms third powers."""

FALSE_ALARM_RATE = 1e-4
"""Probability of reporting white noise as correlated: one of ten thousand fits."""

THINNED_CORRELATION = 0.1
"""Correlation of the thinned samples of AR(1) noise that are recommended for a fit: computed
variances are then too small by a factor of (1 + 0.1)/(1 − 0.1), standard errors by a tenth."""

FIXED_MESH_TOLERANCE = 1e-6
"""Assumed relative tolerance of a motion that was collocated on the user's mesh, which is not
refined: three digits of its samples are assumed to be correct, see NOISE_TOLERANCE_FACTOR."""

NOISE_TOLERANCE_FACTOR = 1e3
"""Residuals count as noise above this multiple of the motion's tolerance, relative to its samples:
errors of a whole motion are some hundred times those of a step, and they are correlated."""
