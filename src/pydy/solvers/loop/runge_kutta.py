"""One step of an explicit Runge–Kutta method, its error and its interpolant."""

from __future__ import annotations

import math

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.intrinsics import address_of, combine, get, nested, put
from pydy.solvers.loop.rates import rates
from pydy.solvers.run.layout import (
    BLOCKS,
    DENSE_STAGES,
    DEPTH,
    ESTIMATES,
    EVALUATIONS,
    STAGES,
    STATES,
)

__all__ = [
    "combine_row",
    "copy_vector",
    "error_of_step",
    "interpolate",
    "prepare_interpolant",
    "take_step",
]


@inlined
def copy_vector(source, target):
    """Copy an array, without what numba's own assignment brings along to tell of wrong shapes."""
    for i in range(target.size):
        target[i] = source[i]


@inlined(always=True)
def combine_row(method, problem, memory, row, y, x):
    """Compute y = x + h · (one row of the tableau · stages); y and x are addresses."""
    first = method.rows[row]
    combine(
        y,
        x,
        address_of(memory.step, 0),
        address_of(memory.stages, 0),
        address_of(method.offsets, first),
        address_of(method.weights, first),
        method.rows[row + 1] - first,
        problem.words[BLOCKS],
    )


@inlined(fused=True)
def _combine_latest(method, problem, memory, row, y, h):
    """Compute y = x + h · (one row of the tableau · stages); y is an address.

    The latest stage comes last and number by number: a kernel has just written it so, and what is
    written in parts can be read as a whole only much later. It counts where vectors are short.
    """
    first, last = method.rows[row], method.rows[row + 1] - 1
    count = last - first
    short = problem.words[BLOCKS] == 1
    combine(
        y,
        address_of(memory.x, 0),
        address_of(memory.step, 0),
        address_of(memory.stages, 0),
        address_of(method.offsets, first),
        address_of(method.weights, first),
        count if short else count + 1,
        problem.words[BLOCKS],
    )
    if short:
        weight, source = h * method.weights[last], method.offsets[last]
        for i in range(problem.words[STATES]):
            put(y + 8 * i, get(y + 8 * i) + weight * memory.stages[source + i])


@inlined(pasted=True)
def take_step(method, problem, memory, run, t, h):
    """Compute ``memory.new`` from ``memory.x``. Not zero: what the right-hand side complained."""
    length, trial = memory.x.size, address_of(memory.trial, 0)
    for i in range(memory.step.size):
        memory.step[i] = h
    stages = method.shape[STAGES]
    for stage in range(1, stages):
        _combine_latest(method, problem, memory, stage, trial, h)
        out = address_of(memory.stages, stage * length)
        run.counts[EVALUATIONS] += 1
        code = rates(problem, t + method.nodes[stage] * h, trial, out)
        if code != 0:
            return code
    _combine_latest(method, problem, memory, stages, address_of(memory.new, 0), h)
    return 0


@inlined
def _square_sums(memory, n):
    """Sum the squares of both estimates in units of the tolerance."""
    x, new, errors, rtol, atol = memory.x, memory.new, memory.errors, memory.rtol, memory.atol
    first = second = 0.0
    length = x.size
    for i in range(n):
        weight = 1.0 / (atol[i] + rtol[i] * max(abs(x[i]), abs(new[i])))
        e = errors[i] * weight
        d = errors[length + i] * weight
        first += e * e
        second += d * d
    return first, second


@inlined(pasted=True)
def error_of_step(method, problem, memory):
    """Return the norm of the step's error: 1 is just good enough."""
    length, n = memory.x.size, problem.words[STATES]
    row = method.shape[STAGES] + 1
    zero = address_of(memory.zero, 0)
    for k in range(method.shape[ESTIMATES]):
        combine_row(method, problem, memory, row + k, address_of(memory.errors, k * length), zero)
    first, second = _square_sums(memory, n)
    if method.shape[ESTIMATES] == 2:
        if first == 0.0:
            return 0.0
        return first / math.sqrt((first + 0.01 * second) * n)
    return math.sqrt(first / n)


@inlined(pasted=True)
def prepare_interpolant(method, problem, memory, run, t, h):
    """Compute ``memory.interpolant`` for the step just taken, the end's derivative included."""
    length = memory.x.size
    x, trial = address_of(memory.x, 0), address_of(memory.trial, 0)
    stages = method.shape[STAGES]
    row = stages + 1 + method.shape[ESTIMATES]
    for k in range(method.shape[DENSE_STAGES]):
        combine_row(method, problem, memory, row, trial, x)
        stage = stages + 1 + k
        out = address_of(memory.stages, stage * length)
        run.counts[EVALUATIONS] += 1
        code = rates(problem, t + method.nodes[stage] * h, trial, out)
        if code != 0:
            return code
        row += 1
    interpolant, end = memory.interpolant, stages * length
    for i in range(length):
        increment = memory.new[i] - memory.x[i]
        first = h * memory.stages[i] - increment
        interpolant[i], interpolant[length + i] = increment, first
        interpolant[2 * length + i] = increment - first - h * memory.stages[end + i]
    zero = address_of(memory.zero, 0)
    for k in range(3, method.shape[DEPTH]):
        combine_row(method, problem, memory, row, address_of(interpolant, k * length), zero)
        row += 1
    return 0


@inlined(always=True)
def interpolate(method, problem, memory, theta, out):
    """Write the state at t + θ h to the address `out`, in whole blocks."""
    for i in range(memory.theta.size):
        memory.theta[i] = theta
    nested(
        out,
        address_of(memory.x, 0),
        address_of(memory.interpolant, 0),
        memory.x.size,
        method.shape[DEPTH],
        address_of(memory.theta, 0),
        problem.words[BLOCKS],
    )
