"""What every stepper does after an accepted step: look for events and write the outputs due."""

from __future__ import annotations

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.intrinsics import address_of, call_part
from pydy.solvers.loop.runge_kutta import copy_vector, interpolate
from pydy.solvers.run.layout import (
    ACTIVE,
    CALLBACK,
    EVENTS,
    FOUND,
    NEXT,
    PROJECT,
    SCAN,
    SIZE,
    STARTED,
    STATES,
    TIME,
)

__all__ = ["finish_step", "write_reached"]


@inlined
def write_reached(problem, x, run):
    """Write the outputs wanted at the time of the state x or before; tell whether those are all."""
    n, times = problem.words[STATES], run.times
    k = run.counts[NEXT]
    while k < times.size and times[k] <= run.state[TIME]:
        for i in range(n):
            run.flat[k * n + i] = x[i]
        k += 1
    run.counts[NEXT] = k
    return k == times.size


@inlined(pasted=True)
def _interpolate_outputs(table, method, problem, memory, run, constraints, t, h, end, inside):
    """Write the outputs within the step, and those at the `end` if that is `inside` too."""
    n, times = problem.words[STATES], run.times
    held = constraints.words[ACTIVE] == 1
    k = run.counts[NEXT]
    while k < times.size and (times[k] < end or (times[k] == end and inside)):
        interpolate(method, problem, memory, (times[k] - t) / h, address_of(run.flat, k * n))
        if held:
            row = address_of(run.flat, k * n)
            code = call_part(constraints.words[PROJECT], table, times[k], row)
            if code != 0:
                return code
        k += 1
    run.counts[NEXT] = k
    return 0


@inlined(pasted=True)
def finish_step(table, method, problem, memory, run, constraints, watch, t, h):
    """Look for events, then write the outputs due, up to the event that ends the step if one does.

    Not zero: why the integration stops here. It is ready to start again, at the event if it was
    one, where ``memory.x`` then is the state.
    """
    theta, status = 1.0, 0
    if watch.words[EVENTS] > 0:
        status = call_part(watch.words[SCAN], table, t, h)
        theta = run.state[FOUND]
    end = run.state[TIME] if theta == 1.0 else t + theta * h
    code = status if status == CALLBACK else 0
    if code == 0:
        code = _interpolate_outputs(
            table, method, problem, memory, run, constraints, t, h, end, theta < 1.0
        )
    if code == 0 and status != 0 and theta < 1.0:
        interpolate(method, problem, memory, theta, address_of(memory.trial, 0))
        copy_vector(memory.trial, memory.new)
        if constraints.words[ACTIVE] == 1:
            new = address_of(memory.new, 0)
            code = call_part(constraints.words[PROJECT], table, end, new)
    if code != 0:
        run.state[TIME], run.state[SIZE] = t, h
        return code
    if theta == 1.0:
        write_reached(problem, memory.new, run)
    if status != 0:
        copy_vector(memory.new, memory.x)
        run.state[TIME], run.state[SIZE], run.counts[STARTED] = end, 0.0, 0
    return status
