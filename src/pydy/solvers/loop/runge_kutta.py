"""One step of an explicit Runge–Kutta method, its error and its interpolant."""

from __future__ import annotations

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.control import unit
from pydy.solvers.loop.intrinsics import address_of, combine, fused, get, nested, put
from pydy.solvers.loop.rates import rates
from pydy.solvers.loop.vectors import item, number, root, store, where
from pydy.solvers.run.layout import (
    BLOCKS,
    CONTROLLED,
    CONTROLLED_BLOCKS,
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
    "set_interpolant",
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
    _combine(method, problem.words[BLOCKS], memory, row, y, x, 1)


@inlined(always=True)
def _combine(method, blocks, memory, row, y, x, latest):
    """Compute the terms of a row of the tableau, with its last one or without it (1 or 0)."""
    first = method.rows[row]
    combine(
        y,
        x,
        address_of(memory.step, 0),
        address_of(memory.stages, 0),
        address_of(method.offsets, first),
        address_of(method.weights, first),
        method.rows[row + 1] - first - 1,
        latest,
        blocks,
    )


@inlined
def _combine_latest(method, problem, memory, row, y, h):
    """Compute y = x + h · (one row of the tableau · stages); y is an address.

    The latest stage comes last and number by number: a kernel has just written it so, and what is
    written in parts can be read as a whole only much later. It counts where vectors are short.
    """
    blocks = problem.words[BLOCKS]
    short = blocks == 1
    _combine(method, blocks, memory, row, y, address_of(memory.x, 0), 0 if short else 1)
    if short:
        last = method.rows[row + 1] - 1
        weight, source = h * method.weights[last], method.offsets[last]
        for i in range(problem.words[STATES]):
            put(y + 8 * i, fused(weight, memory.stages[source + i], get(y + 8 * i)))


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


@inlined(always=True)
def _not_finite(memory, first, last, like):
    """Return zero, or NaN if some components of the new state are not finite."""
    a, b, c, d = number(0.0, like), number(0.0, like), number(0.0, like), number(0.0, like)
    for i in range(first, last - 3, 4):  # four sums at a time: one would wait for each addition
        a, b = a + 0.0 * item(memory.new, i, like), b + 0.0 * item(memory.new, i + 1, like)
        c, d = c + 0.0 * item(memory.new, i + 2, like), d + 0.0 * item(memory.new, i + 3, like)
    for i in range(last - (last - first) % 4, last):
        a = a + 0.0 * item(memory.new, i, like)
    return a + b + (c + d)


@inlined(always=True)
def error_of_step(method, problem, memory, like):
    """Return the norm of the step's error: 1 is just good enough. `like` is a float or a block."""
    length, n, blocks = memory.x.size, problem.words[CONTROLLED], problem.words[CONTROLLED_BLOCKS]
    estimates, row = method.shape[ESTIMATES], method.shape[STAGES] + 1
    zero = address_of(memory.zero, 0)
    for k in range(estimates):
        out = address_of(memory.errors, k * length)
        _combine(method, blocks, memory, row + k, out, zero, 1)
    further = memory.errors[length:]
    first, second = number(0.0, like), number(0.0, like)
    for i in range(n):
        weight = 1.0 / unit(memory, i, item(memory.x, i, like), item(memory.new, i, like))
        e, d = item(memory.errors, i, like) * weight, item(further, i, like) * weight
        first, second = first + e * e, second + d * d
    first = first + _not_finite(memory, n, problem.words[STATES], like)
    if estimates == 2:
        return where(first == 0.0, 0.0, first / root((first + 0.01 * second) * float(n)))
    return root(first / float(n))


@inlined(pasted=True)
def prepare_interpolant(method, problem, memory, run, t, h):
    """Compute ``memory.interpolant`` for the step just taken, the end's derivative included."""
    length, stages = memory.x.size, method.shape[STAGES]
    x, trial = address_of(memory.x, 0), address_of(memory.trial, 0)
    for k in range(stages + 1, stages + 1 + method.shape[DENSE_STAGES]):
        combine_row(method, problem, memory, k + method.shape[ESTIMATES], trial, x)
        out = address_of(memory.stages, k * length)
        run.counts[EVALUATIONS] += 1
        code = rates(problem, t + method.nodes[k] * h, trial, out)
        if code != 0:
            return code
    set_interpolant(method, problem, memory, h)
    return 0


@inlined(always=True)
def set_interpolant(method, problem, memory, h):
    """Compute ``memory.interpolant`` from all stages; h is a float or a block."""
    length, n, stages = memory.x.size, problem.words[STATES], method.shape[STAGES]
    zero, end = address_of(memory.zero, 0), memory.stages[stages * length :]
    ones, twos = memory.interpolant[length:], memory.interpolant[2 * length :]
    for i in range(n):
        increment = item(memory.new, i, h) - item(memory.x, i, h)
        first = h * item(memory.stages, i, h) - increment
        store(memory.interpolant, i, increment)
        store(ones, i, first)
        store(twos, i, increment - first - h * item(end, i, h))
    row = stages + 1 + method.shape[ESTIMATES] + method.shape[DENSE_STAGES]
    for k in range(3, method.shape[DEPTH]):
        out = address_of(memory.interpolant, k * length)
        combine_row(method, problem, memory, row + k - 3, out, zero)


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
