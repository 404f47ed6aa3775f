"""The loop around explicit Runge–Kutta steps: step size, outputs, and why it stopped."""

from __future__ import annotations

import math

from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.control import (
    first_size,
    first_trial,
    limited,
    moves,
    next_size,
    shorter_size,
    usable,
    whole_steps,
)
from pydy.solvers.loop.entrance import opened, opened_steps
from pydy.solvers.loop.extension import full, keep_step
from pydy.solvers.loop.finishing import finish_step, write_reached
from pydy.solvers.loop.intrinsics import address_of, call_part
from pydy.solvers.loop.rates import rates
from pydy.solvers.loop.runge_kutta import error_of_step, prepare_interpolant, take_step
from pydy.solvers.loop.vectors import maximum, minimum
from pydy.solvers.outcome import (
    CONSTRAINTS_NOT_MET,
    FINISHED,
    NOT_FINITE,
    SINGULAR,
    STEP_UNDERFLOW,
    TOO_MANY_STEPS,
)
from pydy.solvers.run.layout import (
    ACTIVE,
    BUDGET,
    CALLBACK,
    CONTROLLED,
    END_IN_ESTIMATE,
    ESTIMATES,
    EVALUATIONS,
    EVENTS,
    FAILURE,
    GROW,
    GROWTH,
    KEPT,
    LARGEST,
    LAST_ERROR,
    LAST_SIZE,
    LIMIT,
    NEXT,
    PAUSED,
    PROJECT,
    REJECTED,
    SIZE,
    STAGES,
    STARTED,
    STATES,
    STEPS,
    STEPS_FULL,
    TIME,
)
from pydy.solvers.tuning import FIRST_ERROR, SLIVER

__all__ = ["advance"]


@inlined(pasted=True)
def _first_size(method, problem, memory, run, t):
    """Guess the first step, with one further evaluation."""
    n, length, largest = problem.words[STATES], memory.x.size, run.state[LARGEST]
    controlled = problem.words[CONTROLLED]
    trial, slope = first_trial(memory, controlled, largest, t)
    for i in range(n):
        memory.trial[i] = memory.x[i] + trial * memory.stages[i]
    run.counts[EVALUATIONS] += 1
    out = address_of(memory.stages, length)
    if rates(problem, t + trial, address_of(memory.trial, 0), out) != 0:
        return SLIVER * trial
    return first_size(method, memory, controlled, t, largest, trial, slope)


@entry("int64(int64, int64, int64)")
def advance(table, states, fresh):
    """Step until the end, or until ``BUDGET`` steps are taken, or something else happens."""
    method, problem, memory, run, constraints, watch = opened(table, states, fresh)
    if run.counts[BUDGET] == 0:
        return PAUSED
    length, steps = memory.x.size, opened_steps(table)
    state, count, times, control = run.state, run.counts, run.times, method.control
    stages, held = method.shape[STAGES], constraints.words[ACTIVE] == 1
    adaptive = method.shape[ESTIMATES] > 0
    end = address_of(memory.stages, stages * length)
    last = times[times.size - 1]
    t, h = state[TIME], state[SIZE]
    if count[STARTED] == 0:
        count[EVALUATIONS] += 1
        code = rates(problem, t, address_of(memory.x, 0), address_of(memory.stages, 0))
        if code != 0:
            count[FAILURE] = SINGULAR
            return CALLBACK if code < 0 else STEP_UNDERFLOW
        count[STARTED] = 1
        state[LAST_ERROR], state[GROWTH] = FIRST_ERROR, control[GROW]
        if write_reached(problem, memory.x, run):
            return FINISHED
        if h == 0.0:
            h = _first_size(method, problem, memory, run, t)
            if not usable(h):
                count[FAILURE] = NOT_FINITE
    while True:
        if count[BUDGET] == 0:
            state[SIZE] = h
            return PAUSED
        if full(steps):
            state[SIZE] = h
            return STEPS_FULL
        count[BUDGET] -= 1
        if count[STEPS] + count[REJECTED] >= count[LIMIT]:
            state[SIZE] = h
            return TOO_MANY_STEPS
        if adaptive:
            size, goal = minimum(h, state[LARGEST]), last
        else:  # whole steps between outputs
            goal = times[count[NEXT]]
            size = whole_steps(t, h, goal)
        size, after = limited(t, size, goal)
        if not moves(t, size, after, goal):
            state[SIZE] = size
            return STEP_UNDERFLOW
        code = take_step(method, problem, memory, run, t, size)
        if code == 0 and method.shape[END_IN_ESTIMATE] == 1:
            count[EVALUATIONS] += 1
            code = rates(problem, after, address_of(memory.new, 0), end)
        if code < 0:
            return CALLBACK
        error, missed = 0.0, False
        if code == 0:
            if adaptive:
                error = error_of_step(method, problem, memory, t)
            else:
                for i in range(length):
                    error += 0.0 * memory.new[i]  # NaN where the state is not finite
            if error < 1.0 and (held or method.shape[END_IN_ESTIMATE] == 0):
                if held:
                    new = address_of(memory.new, 0)
                    missed = call_part(constraints.words[PROJECT], table, after, new) != 0
                if not missed:
                    count[EVALUATIONS] += 1
                    code = rates(problem, after, address_of(memory.new, 0), end)
                    if code < 0:
                        return CALLBACK
        if missed or code != 0 or not error < 1.0:
            count[REJECTED] += 1
            measured = not missed and code == 0 and math.isfinite(error)
            failure = STEP_UNDERFLOW if measured else NOT_FINITE
            if missed:  # a shorter step ends nearer to the constraints
                failure = CONSTRAINTS_NOT_MET
            count[FAILURE] = SINGULAR if code != 0 else failure
            h = shorter_size(method, size, error, measured)
            if not adaptive:
                state[SIZE] = size
                return STEP_UNDERFLOW
            state[GROWTH] = 1.0
            continue
        count[STEPS] += 1
        state[TIME], state[LAST_SIZE] = after, size
        keep_step(steps, problem, memory, 0, t, size, after)
        if watch.words[EVENTS] == 0 and times[count[NEXT]] >= after:
            write_reached(problem, memory.new, run)
        else:
            code = prepare_interpolant(method, problem, memory, run, t, size)
            if code != 0:
                count[FAILURE], state[TIME] = SINGULAR, t
                return CALLBACK if code < 0 else STEP_UNDERFLOW
            code = finish_step(table, method, problem, memory, run, constraints, watch, t, size)
            if code == CONSTRAINTS_NOT_MET and adaptive and watch.words[EVENTS] == 0:
                count[STEPS] -= 1
                steps.words[KEPT] -= 1
                count[REJECTED] += 1
                count[FAILURE], state[GROWTH] = CONSTRAINTS_NOT_MET, 1.0
                h = shorter_size(method, size, error, False)
                continue
            if code != 0:
                steps.words[KEPT] += 1  # of the step that ends here, the end as well
                return code
        if adaptive:
            h = next_size(method, size, error, state[LAST_ERROR], state[GROWTH])
            state[LAST_ERROR] = maximum(error, FIRST_ERROR)
            state[GROWTH] = control[GROW]
        t = after
        for i in range(length):
            memory.x[i] = memory.new[i]
            memory.stages[i] = memory.stages[stages * length + i]
        if count[NEXT] == times.size:
            state[SIZE] = h
            return FINISHED
