"""Thresholds that compiled code and Python share."""

from pydy import _rank

BLOCK = 8
"""Numbers that the compiled loops process at a time; vectors are padded to whole blocks."""

LANES = BLOCK
"""Trajectories of an ensemble that are integrated at a time, on every processor."""

LARGEST_IN_LANES = 128
"""The largest number of states of an implicit step in lanes. If one lane needs a factorisation, all
lanes factorise, three times as often as alone, and larger matrices do not fit into the cache: at
240 states lanes gain only a tenth."""

ROUNDING = _rank.ROUNDING
"""The distance from 1.0 to the next float."""

HALF = _rank.HALF
"""Half of the digits."""

DIGITS = _rank.DIGITS
"""The largest residual of an implied constraint, in units of its size."""

ROUNDINGS = _rank.ROUNDINGS
"""The largest residual of a constraint that is satisfied, in units of its rounding bound."""

DEPENDENT = _rank.DEPENDENT
"""A constraint is redundant if the part of its row orthogonal to the others is below this share.

For redundant constraints this part is about 1e-15 of the length, due to rounding.
"""

SOUND = _rank.SOUND
"""A row with a smaller part of its length orthogonal to the others is replaced by one that was left
out of the equations as redundant."""

MANY_STEPS = 100_000
"""Steps of a run after which `on_many_steps` is called, once, to check its progress."""

STARTING_MOVE = 1e-3
"""The largest correction of an initial state by projection, relative to its scale: a larger one
points to a mistake rather than to rounding."""

CROWD, CROWDED = 100, 1e-9
"""This many events within this fraction of the time span are Zeno behaviour."""

NO_LATER = 16.0
"""An event that recurs within this many roundings of the time has recurred at once."""

LOW = 64.0
"""A rebound may be as low as the roundings of its event's expression where its speed times the
last flight is within 4 · 16 of them: the height of a flight is a quarter of its speed times its
length, and it is shorter than the last one, if the acceleration does not fall to a 16th."""

HALVINGS = 52
"""How often the time span is halved to find the side to which a state at rest departs, down to a
rounding of the span."""

FAR_ORIGIN = 1e3
"""At times more than this many spans from zero, steps have so few digits that a run may fail."""

NEARLY_SINGULAR = 1e-5
"""The nearness to a loss of rank below which velocity constraints do not determine the motion.

Positions are known to a rounding: crossing branches are distinguishable down to its square root,
about 1e-8.
"""

# -- step-size control, after Hairer, Nørsett, Wanner, Solving ODEs I, II.4, unless stated ---------

SAFETY, SHRINK, GROW = 0.9, 0.2, 6.0
"""The safety factor of the step size, and the smallest and largest ratio of successive steps.

HNW recommend 0.8 or 0.9, 0.2 to 0.5, and 1.5 to 5; their DOP853 allows a factor of 6.
"""

AFTER_FAILURE = 0.25
"""The factor of the next step size after a step without an error estimate or a solution."""

LEAST_ERROR = 1e-10
"""The lower bound of errors; a step with this error already grows by more than `GROW`."""

FIRST_ERROR = 1e-4
"""The previous error at the first step, and its lower bound later (DOPRI5's FACOLD)."""

NEGLIGIBLE, TRIAL_SIZE, TRIAL_PART = 1e-5, 1e-6, 0.01
"""If states or derivatives are below `NEGLIGIBLE` tolerances, the first trial step is `TRIAL_SIZE`;
otherwise it is `TRIAL_PART` of the time in which the state changes by its own size."""

NEGLIGIBLE_SLOPE = 1e-15
"""If first and second derivatives are smaller, the first step is not changed."""

SHORTEST = 2.0**-44
"""The shortest first step, in units of the time: 256 roundings, so that it can be shortened."""

SLIVER = 1e-3
"""The share by which a step may grow to reach its goal, to avoid a very short step after it."""

RESOLVED = 0.0625
"""The share of a step that must still change the time: the smallest nodes of tableaus are close."""

WHOLE = 1.0 - 1e-12
"""The factor that removes rounding errors from a number of steps: up to 10 000 roundings."""

INSTANT = 1.0 / (RESOLVED * AFTER_FAILURE)
"""The shortest step that is made shorter for an event, in roundings of the time: the next one still
changes the time."""

CLEAR = 8.0
"""An event crosses zero only once between samples if it changes by this many times its error. An
oscillation of that amplitude between samples would change it by up to 2π times the amplitude. A
state also moves less than this many times as fast between RK stages as at the fastest stage."""

STEPS_MEMORY = 2**27
"""Bytes of recorded steps above which a run discards them: 400 000 steps of 20 states."""

BOUND, BOUND_CAP = 1e3, 0.1
"""The tolerances of sensitivities that only bound the step, in units of those of their states, and
the largest relative one. If the motion excites the same directions, the control of the states keeps
these errors smaller by a factor of a hundred and more."""

LEAST_BOUNDED = 2.0**-40
"""The share of the time span below which such errors do not shorten steps: the slope of a
sensitivity may be infinite at a point."""

LEAST_TOLERANCE = 1e-300
"""Replaces an absolute tolerance of zero, with which an error would be 0 / 0."""

# -- Newton's iterations of Radau IIA, after Hairer and Wanner, Solving ODEs II, IV.8 --------------

DIFFERENCE, DIFFERENCE_SCALE = 1.5e-8, 1e-5
"""The step of a finite difference, the square root of a rounding, in units of the state's size or
of this (RADAU5 does the same)."""

SLOW = 1e-3
"""The rate of convergence above which the Jacobian is evaluated anew (RADAU5's THET)."""

EXCESS = 3.0
"""The largest residuals due to errors of long steps and of states between them, in units of the
tolerances. Residuals with Baumgarte's stabilisation reach half of it, energies a third.
Projection corrects accepted steps by less, most by a tenth of one tolerance."""

ENERGY_ROUNDING = 1e-5
"""The share of the kinetic energy that rounding errors may change: ε/δ² at a distance δ from a
singular position, down to where branches are no longer distinguishable."""

NEAR_SINGULAR = 0.05
"""The nearness to a loss of rank below which the energy is checked. Farther from singular positions
steps are comparatively small and do not change it."""

CLOSE = 2.0**-10
"""A point is close to an event if it is within this share of the distance to the next point, or of
the time. An expression that passes through zero is then farther from it by a billion roundings."""
