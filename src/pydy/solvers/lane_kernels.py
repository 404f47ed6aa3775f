"""Kernels of eight lanes, as compiled code calls them."""

from __future__ import annotations

import numpy as np

from pydy.solvers.compiled import compiled, inlined
from pydy.solvers.intrinsics import BLOCK, address_of, call_kernel, call_prepare, get, put
from pydy.solvers.lane_layout import KERNEL, PREPARE, STATES
from pydy.solvers.rates import interval_of
from pydy.solvers.vectors import splat, store

__all__ = ["copy_in", "evaluate_lanes", "rates_of_lanes"]


@inlined
def _set_inputs(problem):
    """Set the sampled inputs of each lane at its own time."""
    for k in range(problem.tables.shape[0]):
        column, first, number = problem.tables[k]
        knots = problem.knots[first : first + number]
        for lane in range(BLOCK):
            s = max(problem.clock[lane], knots[0])
            low = interval_of(knots, s, problem.intervals[k, lane])
            problem.intervals[k, lane] = low
            s -= knots[low]
            a = problem.cubics[first + low]
            value = a[0] + s * (a[1] + s * (a[2] + s * a[3]))
            problem.r[column * BLOCK + lane] = value


@inlined(always=True)
def rates_of_lanes(problem, clock, x, out):
    """Evaluate; `x` and `out` are addresses. The bits of the lanes whose solve failed."""
    store(problem.clock, 0, clock)
    if problem.tables.shape[0] > 0:
        _set_inputs(problem)
    return np.int64(
        call_kernel(
            problem.words[KERNEL],
            address_of(problem.clock, 0),
            x,
            address_of(problem.r, 0),
            address_of(problem.c, 0),
            out,
        )
    )


@inlined(always=True)
def copy_in(values, row, buffer, lane):
    """Copy a row of an array into a lane."""
    place = address_of(buffer, lane)
    for i in range(values.shape[1]):
        put(place + 8 * BLOCK * i, values[row, i])


@compiled
def evaluate_lanes(problem, x, buffer, r, p, times, states, steps, out):
    """Evaluate a kernel at all states (n, m, times); write (outputs, m, times).

    `states` is the address of the first, `steps` the distances along the three axes. NaN states
    give NaN; so does a linear solve that fails.
    """
    n, m = problem.words[STATES], out.shape[1]
    for first in range(0, m, BLOCK):
        for lane in range(BLOCK):
            sample = min(first + lane, m - 1)
            copy_in(r, sample, problem.r, lane)
            copy_in(p, sample, problem.p, lane)
        call_prepare(problem.words[PREPARE], address_of(problem.p, 0), address_of(problem.c, 0))
        for k in range(times.size):
            for lane in range(BLOCK):
                sample = min(first + lane, m - 1)
                place = states + 8 * (sample * steps[1] + k * steps[2])
                for i in range(n):
                    x[i * BLOCK + lane] = get(place + 8 * i * steps[0])
            clock = splat(times[k])
            failed = rates_of_lanes(problem, clock, address_of(x, 0), address_of(buffer, 0))
            for lane in range(min(BLOCK, m - first)):
                bad = (failed >> lane) & 1 == 1 or (n > 0 and x[lane] != x[lane])
                for j in range(out.shape[0]):
                    value = buffer[j * BLOCK + lane]
                    out[j, first + lane, k] = np.nan if bad else value
