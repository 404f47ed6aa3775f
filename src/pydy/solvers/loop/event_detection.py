"""Events, as compiled code finds them: signs are compared along the interpolant of each step."""

from __future__ import annotations

from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.entrance import (
    opened_memory,
    opened_method,
    opened_problem,
    opened_progress,
    opened_watch,
)
from pydy.solvers.loop.intrinsics import address_of, call_kernel
from pydy.solvers.loop.rates import set_inputs
from pydy.solvers.loop.runge_kutta import interpolate
from pydy.solvers.run.layout import (
    CALLBACK,
    EVENT,
    EVENTS,
    FOUND,
    LOG_FULL,
    LOGGED,
    STATES,
    WATCHER,
)
from pydy.solvers.tuning import ROUNDING

__all__ = ["scan_events"]

# A root and its return within a quarter of a step, without a sign to see, are missed.
_PARTS = 4


@inlined
def _evaluate(method, problem, memory, watch, t, h, theta, row):
    """Evaluate all event expressions at t + θ h into a row of ``watch.values``."""
    interpolate(method, problem, memory, theta, address_of(watch.trial, 0))
    set_inputs(problem, t + theta * h)
    return call_kernel(
        watch.words[WATCHER],
        address_of(problem.clock, 0),
        address_of(watch.trial, 0),
        address_of(problem.r, 0),
        address_of(watch.c, 0),
        address_of(watch.values, row * watch.words[EVENTS]),
    )


@inlined
def _crossed(side, value, direction):
    return (side < 0 and value > 0.0 and direction >= 0) or (
        side > 0 and value < 0.0 and direction <= 0
    )


@inlined
def _locate(method, problem, memory, watch, t, h, low, high, event):
    """Return the θ just past the crossing of one event between `low` and `high`, by bisection.

    Beside `low` the event may still be zero or on the wrong side, where it has just been handled:
    then a point on the right side is looked for between them, and `low` is returned without one.
    """
    side, number = watch.sides[event], watch.words[EVENTS]
    resolution = ROUNDING * max(abs(t), abs(t + h)) / h
    _evaluate(method, problem, memory, watch, t, h, low, 1)
    if watch.values[number + event] * side <= 0.0:
        start, middle = low, high
        while True:
            middle = start + 0.5 * (middle - start)
            if middle - start < resolution:
                return start
            _evaluate(method, problem, memory, watch, t, h, middle, 1)
            if watch.values[number + event] * side > 0.0:
                low = middle
                break
            high = middle
    while high - low > resolution:
        middle = low + 0.5 * (high - low)
        if middle in (low, high):
            break
        _evaluate(method, problem, memory, watch, t, h, middle, 1)
        if watch.values[number + event] * side > 0.0:
            low = middle
        else:
            high = middle
    return high


@entry("int64(int64, float64, float64)")
def scan_events(table, t, h):
    """Look for events in the step just taken.

    Returns EVENT when an acting event ends it, LOG_FULL when the log has to be emptied first,
    CALLBACK when a Python function raised something, or 0; ``state[FOUND]`` is the θ up to which
    the step counts.
    """
    method, problem, memory = opened_method(table), opened_problem(table), opened_memory(table)
    watch, progress = opened_watch(table), opened_progress(table)
    state, counts = progress.state, progress.counts
    number, n = watch.words[EVENTS], problem.words[STATES]
    values, sides = watch.values, watch.sides
    logged, left = counts[LOGGED], 0.0
    for quarter in range(1, _PARTS + 1):
        right = quarter / _PARTS
        if _evaluate(method, problem, memory, watch, t, h, right, 0) < 0:
            counts[LOGGED], state[FOUND] = logged, 1.0
            return CALLBACK
        while True:
            first = 2.0
            for event in range(number):
                watch.fired[event] = 0
                if _crossed(sides[event], values[event], watch.directions[event]):
                    theta = _locate(method, problem, memory, watch, t, h, left, right, event)
                    watch.fired[event] = 1 if theta <= left else 0
                    first = min(first, theta)
            if first > 1.0:
                break
            if _evaluate(method, problem, memory, watch, t, h, first, 1) < 0:
                counts[LOGGED], state[FOUND] = logged, 1.0
                return CALLBACK
            acting = False
            for event in range(number):
                now = values[number + event]
                here = _crossed(sides[event], now, watch.directions[event])
                if not here and _crossed(sides[event], values[event], watch.directions[event]):
                    # Exactly zero at its own root, or handled at `left` and left again.
                    here = now == 0.0 or watch.fired[event] == 1
                watch.fired[event] = 1 if here else 0
                acting = acting or (here and watch.acting[event] == 1)
            if acting:
                state[FOUND] = first
                return EVENT
            for event in range(number):
                if watch.fired[event] == 0:
                    continue
                k = counts[LOGGED]
                if k == watch.log_times.size:
                    state[FOUND] = first
                    return LOG_FULL
                watch.log_times[k] = t + first * h
                watch.log_events[k] = event
                for i in range(n):
                    watch.log_states[k, i] = watch.trial[i]
                counts[LOGGED] = k + 1
                sides[event] = -sides[event]
            left = first
        for event in range(number):
            if values[event] > 0.0:
                sides[event] = 1
            elif values[event] < 0.0:
                sides[event] = -1
        left = right
    state[FOUND] = 1.0
    return 0
