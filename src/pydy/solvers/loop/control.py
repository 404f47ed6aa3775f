"""Step-size control: the error norm, the first step and the size of the next one.

One source for one trajectory and for eight: every function takes floats or blocks (`vectors`), of
which `like` is an example, and both get the same bits.

E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd edition,
section II.4; K. Gustafsson's PI controller as in II, section IV.2.
"""

from __future__ import annotations

import math

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.vectors import (
    absolute,
    ceiling,
    item,
    maximum,
    minimum,
    number,
    power,
    root,
    store,
    where,
)
from pydy.solvers.run.layout import ALPHA, BETA, EXPONENT, SAFETY, SHRINK
from pydy.solvers.tuning import (
    AFTER_FAILURE,
    LEAST_ERROR,
    NEGLIGIBLE,
    NEGLIGIBLE_SLOPE,
    RESOLVED,
    SHORTEST,
    SLIVER,
    TRIAL_PART,
    TRIAL_SIZE,
    WHOLE,
)

__all__ = [
    "bounded_first_size",
    "first_size",
    "first_trial",
    "limited",
    "moves",
    "next_size",
    "norm",
    "shorter_size",
    "unit",
    "usable",
    "whole_steps",
]


# -- the norm -------------------------------------------------------------------------------------


@inlined(always=True)
def unit(memory, i, x, y):
    """Return the tolerance of component i, whose value goes from x to y."""
    return memory.atol[i] + memory.rtol[i] * maximum(absolute(x), absolute(y))


@inlined(apart=True)
def norm(a, other, memory, n, like):
    """Return the root mean square of `a` in units of the tolerance; x goes to `other`."""
    total = number(0.0, like)
    for i in range(n):
        e = item(a, i, like) / unit(memory, i, item(memory.x, i, like), item(other, i, like))
        total = total + e * e
    return root(total / float(n))


# -- the first step -------------------------------------------------------------------------------


@inlined(always=True)
def first_trial(memory, n, largest, like):
    """Return a cautious first step, a small part of the time in which x changes by itself.

    The second number is the norm of the derivative, which the first of ``memory.stages`` is.
    """
    d0 = norm(memory.x, memory.x, memory, n, like)
    d1 = norm(memory.stages, memory.x, memory, n, like)
    size = where((d0 < NEGLIGIBLE) | (d1 < NEGLIGIBLE), TRIAL_SIZE, TRIAL_PART * d0 / d1)
    return minimum(largest, size), d1


@inlined(always=True)
def first_size(method, memory, n, t, largest, trial, d1):
    """Return the first step from a trial step, after which ``f1`` is the second of the stages.

    It is overwritten.
    """
    f0, f1 = memory.stages, memory.stages[memory.x.size :]
    for i in range(n):
        store(f1, i, item(f1, i, trial) - item(f0, i, trial))
    steepest = maximum(d1, norm(f1, memory.x, memory, n, trial) / trial)
    sloping = power(TRIAL_PART / maximum(steepest, NEGLIGIBLE_SLOPE), method.control[EXPONENT])
    flat = maximum(TRIAL_SIZE, trial * SLIVER)
    size = minimum(100.0 * trial, where(steepest > NEGLIGIBLE_SLOPE, sloping, flat))
    return bounded_first_size(size, t, largest)


@inlined(always=True)
def bounded_first_size(size, t, largest):
    """Return a first step that neither vanishes beside t nor is too large; NaN stays NaN."""
    return minimum(largest, maximum(SHORTEST * absolute(t), size))


@inlined(always=True)
def usable(size):
    """Tell whether a first step is a positive number."""
    return (size > 0.0) & (size < math.inf)


# -- one step's size ------------------------------------------------------------------------------


@inlined(always=True)
def limited(t, size, goal):
    """Return a step's size and its end; it reaches the goal rather than leaving a sliver."""
    after = t + size
    near = after > goal - SLIVER * size
    return where(near, goal - t, size), where(near, goal, after)


@inlined(always=True)
def whole_steps(t, size, goal):
    """Return the largest step up to a size that a whole number of times reaches the goal."""
    return (goal - t) / ceiling((goal - t) / size * WHOLE)


@inlined(always=True)
def moves(t, size, after, goal):
    """Tell whether a step is long enough to tell its stages' times apart, or the last."""
    return (t + RESOLVED * size > t) | (after == goal)


@inlined(always=True)
def next_size(method, size, error, last_error, growth):
    """Return the size of the step after one of some error, which was accepted."""
    control = method.control
    factor = control[SAFETY] * power(maximum(error, LEAST_ERROR), -control[ALPHA])
    if control[BETA] != 0.0:
        factor = factor * power(last_error, control[BETA])
    return size * minimum(growth, maximum(factor, control[SHRINK]))


@inlined(always=True)
def shorter_size(method, size, error, measured):
    """Return the size with which a rejected step is tried again; its error may not be measured."""
    control = method.control
    factor = control[SAFETY] * power(maximum(error, LEAST_ERROR), -control[EXPONENT])
    return size * where(measured, maximum(factor, control[SHRINK]), AFTER_FAILURE)
