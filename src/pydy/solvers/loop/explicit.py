"""The loop around explicit Runge–Kutta steps: step size, outputs, and why it stopped."""

from __future__ import annotations

import math

from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.entrance import opened
from pydy.solvers.loop.finishing import finish_step, write_reached
from pydy.solvers.loop.intrinsics import address_of, call_part
from pydy.solvers.loop.rates import rates
from pydy.solvers.loop.runge_kutta import error_of_step, prepare_interpolant, take_step
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
    ALPHA,
    BETA,
    BUDGET,
    CALLBACK,
    END_IN_ESTIMATE,
    ESTIMATES,
    EVALUATIONS,
    EVENTS,
    EXPONENT,
    FAILURE,
    GROW,
    GROWTH,
    LARGEST,
    LAST_ERROR,
    LAST_SIZE,
    LIMIT,
    NEXT,
    PAUSED,
    PROJECT,
    REJECTED,
    SAFETY,
    SHORTEST,
    SHRINK,
    SIZE,
    STAGES,
    STARTED,
    STATES,
    STEPS,
    TIME,
)

__all__ = ["advance"]


@inlined(apart=True)
def _norm(a, b, memory, n):
    """Return the root mean square of a − b in units of the tolerance at ``memory.x``."""
    total = 0.0
    for i in range(n):
        e = (a[i] - b[i]) / (memory.atol[i] + memory.rtol[i] * abs(memory.x[i]))
        total += e * e
    return math.sqrt(total / n)


@inlined(pasted=True)
def _first_size(method, problem, memory, run, t):
    """Guess the first step: Hairer, Nørsett, Wanner, Solving ODEs I, II.4."""
    n = problem.words[STATES]
    x, trial, f0 = memory.x, memory.trial, memory.stages
    length = x.size
    d0 = _norm(x, memory.zero, memory, n)
    d1 = _norm(f0, memory.zero, memory, n)
    h0 = 1e-6 if d0 < 1e-5 or d1 < 1e-5 else 0.01 * d0 / d1
    h0 = min(h0, run.state[LARGEST])
    for i in range(n):
        trial[i] = x[i] + h0 * f0[i]
    run.counts[EVALUATIONS] += 1
    f1 = memory.stages[length:]
    if rates(problem, t + h0, address_of(trial, 0), address_of(f1, 0)) != 0:
        return h0 * 1e-3
    d2 = _norm(f1, f0, memory, n) / h0
    steepest = max(d1, d2)
    h1 = max(1e-6, h0 * 1e-3)
    if steepest > 1e-15:
        h1 = (0.01 / steepest) ** method.control[EXPONENT]
    h = min(100.0 * h0, h1)
    if h < SHORTEST * abs(t):
        h = SHORTEST * abs(t)
    return min(h, run.state[LARGEST])


@entry("int64(int64, int64, int64)")
def advance(table, states, fresh):
    """Step until the end, or until ``BUDGET`` steps are taken, or something else happens."""
    method, problem, memory, run, constraints, watch = opened(table, states, fresh)
    if run.counts[BUDGET] == 0:
        return PAUSED
    length = memory.x.size
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
        state[LAST_ERROR], state[GROWTH] = 1e-4, control[GROW]
        if write_reached(problem, memory.x, run):
            return FINISHED
        if h == 0.0:
            h = _first_size(method, problem, memory, run, t)
            if not 0.0 < h < math.inf:
                count[FAILURE] = NOT_FINITE
    while True:
        if count[BUDGET] == 0:
            state[SIZE] = h
            return PAUSED
        count[BUDGET] -= 1
        if count[STEPS] + count[REJECTED] >= count[LIMIT]:
            state[SIZE] = h
            return TOO_MANY_STEPS
        if adaptive:
            size = min(h, state[LARGEST])
            goal = last
        else:  # whole steps between outputs
            goal = times[count[NEXT]]
            size = (goal - t) / math.ceil((goal - t) / h * (1.0 - 1e-12))
        after = t + size
        if after > goal - 1e-3 * size:
            size, after = goal - t, goal
        if not (t + 0.0625 * size > t or after == goal):
            state[SIZE] = size
            return STEP_UNDERFLOW
        code = take_step(method, problem, memory, run, t, size)
        if code == 0 and method.shape[END_IN_ESTIMATE] == 1:
            count[EVALUATIONS] += 1
            code = rates(problem, after, address_of(memory.new, 0), end)
        if code < 0:
            return CALLBACK
        error = 0.0
        if code == 0:
            if adaptive:
                error = error_of_step(method, problem, memory)
            else:
                for i in range(length):
                    error += 0.0 * memory.new[i]  # NaN where the state is not finite
            if error < 1.0 and (held or method.shape[END_IN_ESTIMATE] == 0):
                if held:
                    new = address_of(memory.new, 0)
                    if call_part(constraints.words[PROJECT], table, after, new) != 0:
                        state[SIZE] = size
                        return CONSTRAINTS_NOT_MET
                count[EVALUATIONS] += 1
                code = rates(problem, after, address_of(memory.new, 0), end)
                if code < 0:
                    return CALLBACK
        if code != 0 or not error < 1.0:
            count[REJECTED] += 1
            if code != 0:
                count[FAILURE], h = SINGULAR, 0.25 * size
            elif math.isfinite(error):
                count[FAILURE] = STEP_UNDERFLOW
                h = size * max(control[SHRINK], control[SAFETY] * error ** -control[EXPONENT])
            else:
                count[FAILURE], h = NOT_FINITE, 0.25 * size
            if not adaptive:
                state[SIZE] = size
                return STEP_UNDERFLOW
            state[GROWTH] = 1.0
            continue
        count[STEPS] += 1
        state[TIME], state[LAST_SIZE] = after, size
        if times[count[NEXT]] == after and watch.words[EVENTS] == 0 and not held:
            write_reached(problem, memory.new, run)
        elif watch.words[EVENTS] > 0 or times[count[NEXT]] <= after:
            code = prepare_interpolant(method, problem, memory, run, t, size)
            if code != 0:
                count[FAILURE] = SINGULAR
                return CALLBACK if code < 0 else STEP_UNDERFLOW
            code = finish_step(table, method, problem, memory, run, constraints, watch, t, size)
            if code != 0:
                return code
        if adaptive:
            error = max(error, 1e-10)
            factor = control[SAFETY] * error ** -control[ALPHA]
            if control[BETA] != 0.0:
                factor *= state[LAST_ERROR] ** control[BETA]
            h = size * min(state[GROWTH], max(control[SHRINK], factor))
            state[LAST_ERROR] = max(error, 1e-4)
            state[GROWTH] = control[GROW]
        t = after
        for i in range(length):
            memory.x[i] = memory.new[i]
            memory.stages[i] = memory.stages[stages * length + i]
        if count[NEXT] == times.size:
            state[SIZE] = h
            return FINISHED
