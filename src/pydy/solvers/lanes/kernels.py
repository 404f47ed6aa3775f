"""Kernels of eight lanes, as compiled code calls them."""

from __future__ import annotations

import numpy as np

from pydy.solvers.lanes.layout import (
    EVALUATION,
    ORIGIN,
    PER_SAMPLE,
    PER_STATE,
    PER_TIME,
    PREPARE,
    Evaluation,
    LaneProblem,
)
from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.entrance import opening
from pydy.solvers.loop.intrinsics import address_of, call_kernel, call_prepare, get, put
from pydy.solvers.loop.rates import sampled
from pydy.solvers.loop.vectors import splat, store
from pydy.solvers.run.layout import KERNEL, STATES
from pydy.solvers.tuning import LANES

__all__ = ["copy_in", "evaluate_lanes", "rates_of_lanes"]


@inlined(apart=True)
def _set_inputs(problem):
    """Set the sampled inputs of each lane at its own time."""
    for k in range(problem.tables.shape[0]):
        for lane in range(LANES):
            value, low = sampled(problem, k, problem.clock[lane], problem.intervals[k, lane])
            problem.intervals[k, lane] = low
            problem.r[problem.tables[k, 0] * LANES + lane] = value


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
        put(place + 8 * LANES * i, values[row, i])


_opened_problem = opening(EVALUATION, LaneProblem)
_opened_evaluation = opening(EVALUATION, Evaluation)


@entry("int64(int64)")
def evaluate_lanes(table):
    """Evaluate a kernel at all states (n, m, times); write (outputs, m, times).

    NaN states give NaN; so does a linear solve that fails.
    """
    problem, evaluation = _opened_problem(table), _opened_evaluation(table)
    x, buffer, places = evaluation.x, evaluation.buffer, evaluation.places
    times, out = evaluation.times, evaluation.out
    n, m, count = problem.words[STATES], len(evaluation.r), times.size
    outputs = buffer.size // LANES
    for first in range(0, m, LANES):
        for lane in range(LANES):
            sample = min(first + lane, m - 1)
            copy_in(evaluation.r, sample, problem.r, lane)
            copy_in(evaluation.p, sample, problem.p, lane)
        call_prepare(problem.words[PREPARE], address_of(problem.p, 0), address_of(problem.c, 0))
        for k in range(count):
            for lane in range(LANES):
                sample = min(first + lane, m - 1)
                place = places[ORIGIN] + 8 * (sample * places[PER_SAMPLE] + k * places[PER_TIME])
                for i in range(n):
                    x[i * LANES + lane] = get(place + 8 * i * places[PER_STATE])
            clock = splat(times[k])
            failed = rates_of_lanes(problem, clock, address_of(x, 0), address_of(buffer, 0))
            for lane in range(min(LANES, m - first)):
                bad = (failed >> lane) & 1 == 1 or (n > 0 and x[lane] != x[lane])
                for j in range(outputs):
                    value = buffer[j * LANES + lane]
                    out[(j * m + first + lane) * count + k] = np.nan if bad else value
    return 0
