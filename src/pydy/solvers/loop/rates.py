"""The derivative of the state, with sampled inputs, as compiled code calls it."""

from __future__ import annotations

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.intrinsics import address_of, call_kernel
from pydy.solvers.run.layout import KERNEL

__all__ = ["rates", "sampled", "set_inputs"]


@inlined
def _interval_of(knots, s, guess):
    """Return the last of the ascending knots that is not after s; most often it is the guess."""
    number = knots.size
    if knots[guess] <= s and (guess == number - 1 or s < knots[guess + 1]):
        return guess
    low, high = 0, number
    while high - low > 1:
        middle = (low + high) // 2
        if knots[middle] <= s:
            low = middle
        else:
            high = middle
    return low


@inlined
def sampled(problem, k, t, guess):
    """Return input k at a time, and the interval it is in; `guess` is where it may be."""
    first, number = problem.tables[k, 1], problem.tables[k, 2]
    knots = problem.knots[first : first + number]
    s = max(t, knots[0])
    low = _interval_of(knots, s, guess)
    s -= knots[low]
    a = problem.cubics[first + low]
    return a[0] + s * (a[1] + s * (a[2] + s * a[3])), low


@inlined(apart=True)
def _sample(problem, t):
    """Set the sampled inputs of a time; their end values are held."""
    tables = problem.tables
    for k in range(tables.shape[0]):
        problem.r[tables[k, 0]], tables[k, 3] = sampled(problem, k, t, tables[k, 3])


@inlined
def set_inputs(problem, t):
    """Set the kernel's time, and the sampled inputs of that time."""
    problem.clock[0] = t
    if problem.tables.shape[0] > 0:
        _sample(problem, t)


@inlined
def rates(problem, t, x, out):
    """Evaluate the derivative; `x` and `out` are addresses. Not zero: the kernel's complaint."""
    set_inputs(problem, t)
    return call_kernel(
        problem.words[KERNEL],
        address_of(problem.clock, 0),
        x,
        address_of(problem.r, 0),
        address_of(problem.c, 0),
        out,
    )
