"""Radau IIA of order 5 for stiff systems, compiled by numba.

E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, section IV.8:
simplified Newton iterations in transformed variables, an embedded error estimate, and
K. Gustafsson's predictive control of the step size.
"""

from __future__ import annotations

import math

import numpy as np

from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.control import (
    bounded_first_size,
    first_trial,
    limited,
    moves,
    norm,
    unit,
    usable,
)
from pydy.solvers.loop.entrance import opened, opened_newton, opened_steps
from pydy.solvers.loop.extension import full, keep_step
from pydy.solvers.loop.finishing import finish_step, write_reached
from pydy.solvers.loop.intrinsics import address_of, call_part
from pydy.solvers.loop.newton import factorise, set_jacobian, solve, solve_columns
from pydy.solvers.loop.rates import rates
from pydy.solvers.loop.vectors import minimum
from pydy.solvers.outcome import (
    CONSTRAINTS_NOT_MET,
    FINISHED,
    NO_CONVERGENCE,
    NOT_FINITE,
    SINGULAR,
    STEP_UNDERFLOW,
    TOO_MANY_STEPS,
)
from pydy.solvers.run.layout import (
    ACTIVE,
    BUDGET,
    CALLBACK,
    COUNTED,
    DEPTH,
    EVALUATIONS,
    EVENTS,
    FACTORED,
    FACTORISATIONS,
    FACTORISED,
    FAILURE,
    FIRST,
    FRESH,
    KEPT,
    LARGEST,
    LAST_ERROR,
    LAST_SIZE,
    LIMIT,
    NEXT,
    PAUSED,
    PREDICTING,
    PROJECT,
    REJECTED,
    SIZE,
    STARTED,
    STATES,
    STEPS,
    STEPS_FULL,
    TIME,
    WANTED,
)
from pydy.solvers.tableaus.radau import COMPLEX, ERROR, INTERPOLANT, NODES, REAL, TI, T
from pydy.solvers.tuning import AFTER_FAILURE, LEAST_ERROR, ROUNDING, SLOW

__all__ = ["advance_implicit"]

_ITERATIONS = 6
_FURTHER = 4  # for sensitivities, whose equations follow the state's iterates
_NODES, _ERROR = np.array(NODES), np.array(ERROR)
_T, _TI, _P = np.array(T), np.array(TI), np.array(INTERPOLANT)
_REAL, _COMPLEX_REAL, _COMPLEX_IMAG = REAL, COMPLEX.real, COMPLEX.imag


@inlined
def _pair_over(h):
    """Return the complex eigenvalue over h: numba's own division may raise an exception."""
    return complex(_COMPLEX_REAL / h, _COMPLEX_IMAG / h)


@inlined
def _forget(newton):
    """Go on without derivatives, which are worthless near a singularity; tell if there were any."""
    there = False
    for i in range(newton.jacobian.size):
        there = there or newton.jacobian[i] != 0.0
        newton.jacobian[i] = 0.0
    return there


@inlined(pasted=True)
def _factorise_pair(newton, n, h):
    """Factorise (μ / h) I − J for both eigenvalues μ."""
    for i in range(n):
        for j in range(n):
            newton.real[i, j] = -newton.jacobian[i * n + j]
            newton.pair[i, j] = -newton.jacobian[i * n + j]
        newton.real[i, i] += _REAL / h
        newton.pair[i, i] += _pair_over(h)
    return factorise(newton.real, newton.real_order) and factorise(newton.pair, newton.pair_order)


@inlined(pasted=True)
def _predict(memory, newton, n, h, last_size):
    """Continue the last step's polynomial to the new stages; zero without one."""
    z, last = newton.stages, newton.last
    for k in range(3):
        theta = 1.0 + _NODES[k] * h / last_size if last_size > 0.0 else 0.0
        for i in range(n):
            if last_size > 0.0:
                value = (1.0 - theta) * (last[2, i] + theta * last[3, i])
                z[k, i] = last[0, i] + theta * (last[1, i] + value) - memory.x[i]
            else:
                z[k, i] = 0.0
    for k in range(3):
        for i in range(n):
            newton.waves[k, i] = _TI[k, 0] * z[0, i] + _TI[k, 1] * z[1, i] + _TI[k, 2] * z[2, i]


@inlined
def _columns_moved(memory, newton):
    """Return the largest change of a column of sensitivities, relative to it, squared."""
    n, width = newton.real_order.size, newton.words[COUNTED]
    real, pair, w = newton.real_change, newton.pair_change, newton.waves
    worst = 0.0
    for column in range(width):
        moved = size = 0.0
        for i in range(n):
            k = n + i * width + column
            moved += real[k] * real[k] + abs(pair[k]) * abs(pair[k])
            size += memory.x[k] * memory.x[k]
            size += w[0, k] * w[0, k] + w[1, k] * w[1, k] + w[2, k] * w[2, k]
        if moved > worst * size:
            worst = moved / size if size > 0.0 else 1.0
    return worst


@inlined
def _solve_stages(problem, memory, run, newton, t, h, tolerance, least):
    """Iterate to the stages: (code, converged, iterations, rate of convergence).

    Columns of sensitivities are solved for with the factors of the state. Where they need further
    iterations, to relative changes of `least`, these do not count.
    """
    n, width = problem.words[STATES], newton.words[COUNTED]
    z, w, f = newton.stages, newton.waves, newton.slopes
    real, pair = newton.real_change, newton.pair_change
    before, rate, settled = -1.0, 0.0, 0
    for iteration in range(_ITERATIONS + (_FURTHER if width > 0 else 0)):
        if iteration >= _ITERATIONS and settled == 0:
            break
        for k in range(3):
            for i in range(n):
                memory.trial[i] = memory.x[i] + z[k, i]
            run.counts[EVALUATIONS] += 1
            code = rates(
                problem,
                t + h * _NODES[k],
                address_of(memory.trial, 0),
                address_of(f, k * n),
            )
            if code != 0:
                return code, False, iteration, 0.0
        pushed = 0.0
        for i in range(n):
            if not math.isfinite(f[0, i] + f[1, i] + f[2, i]):
                return 0, False, iteration, np.inf
            real[i] = (
                _TI[0, 0] * f[0, i] + _TI[0, 1] * f[1, i] + _TI[0, 2] * f[2, i]
            ) - _REAL / h * w[0, i]
            left = _TI[1, 0] * f[0, i] + _TI[1, 1] * f[1, i] + _TI[1, 2] * f[2, i]
            right = _TI[2, 0] * f[0, i] + _TI[2, 1] * f[1, i] + _TI[2, 2] * f[2, i]
            pair[i] = complex(left, right) - _pair_over(h) * complex(w[1, i], w[2, i])
            push = h * (abs(real[i]) + abs(pair[i].real) + abs(pair[i].imag))
            push /= unit(memory, i, memory.x[i], memory.x[i])
            pushed += push * push
        solve(newton.real, newton.real_order, real)
        solve(newton.pair, newton.pair_order, pair)
        if width > 0:
            solve_columns(newton.real, newton.real_order, real, width)
            solve_columns(newton.pair, newton.pair_order, pair, width)
        total = 0.0
        for i in range(n):
            scale = unit(memory, i, memory.x[i], memory.x[i])
            a, b, c = real[i] / scale, pair[i].real / scale, pair[i].imag / scale
            total += a * a + b * b + c * c
        change = math.sqrt(total / (3 * n))
        if change == 0.0 and pushed > 0.0:  # held in place by derivatives that are far too large
            return 0, False, iteration + 1, rate
        if before > 0.0 and settled == 0:
            rate = change / before
            left_over = rate ** (_ITERATIONS - 1 - iteration) / (1.0 - rate) * change
            if rate >= 1.0 or left_over > tolerance:
                return 0, False, iteration + 1, rate
        for i in range(n):
            w[0, i] += real[i]
            w[1, i] += pair[i].real
            w[2, i] += pair[i].imag
            for k in range(3):
                z[k, i] = _T[k, 0] * w[0, i] + _T[k, 1] * w[1, i] + _T[k, 2] * w[2, i]
        if settled == 0 and (
            change == 0.0 or (before > 0.0 and rate / (1.0 - rate) * change < tolerance)
        ):
            settled = iteration + 1
        if settled > 0 and (width == 0 or _columns_moved(memory, newton) <= least * least):
            break
        before = change
    return 0, settled > 0, settled if settled > 0 else _ITERATIONS, rate


@inlined
def _estimate(problem, memory, run, newton, t, h, first):
    """Return (code, error norm); a second, filtered estimate when the first is too large."""
    n = problem.words[STATES]
    z = newton.stages
    guess, error = newton.guess, newton.real_change
    for i in range(n):
        guess[i] = (_ERROR[0] * z[0, i] + _ERROR[1] * z[1, i] + _ERROR[2] * z[2, i]) / h
        error[i] = memory.stages[i] + guess[i]
    solve(newton.real, newton.real_order, error)
    size = norm(error, memory.new, memory, n, t)
    if size < 1.0 or not first:
        return 0, size
    for i in range(n):
        memory.trial[i] = memory.x[i] + error[i]
    run.counts[EVALUATIONS] += 1
    code = rates(problem, t, address_of(memory.trial, 0), address_of(newton.slopes, 0))
    if code != 0:
        return code, size
    for i in range(n):
        error[i] = newton.slopes[0, i] + guess[i]
    solve(newton.real, newton.real_order, error)
    return 0, norm(error, memory.new, memory, n, t)


@inlined(pasted=True)
def _set_interpolant(memory, newton, n):
    """Write the collocation polynomial in the nested form, and keep it for the next prediction."""
    z, length = newton.stages, memory.x.size
    for i in range(n):
        second = _P[0, 1] * z[0, i] + _P[1, 1] * z[1, i] + _P[2, 1] * z[2, i]
        third = _P[0, 2] * z[0, i] + _P[1, 2] * z[1, i] + _P[2, 2] * z[2, i]
        memory.interpolant[i] = memory.new[i] - memory.x[i]
        memory.interpolant[length + i] = -second - third
        memory.interpolant[2 * length + i] = -third
        newton.last[0, i] = memory.x[i]
        for k in range(3):
            newton.last[1 + k, i] = memory.interpolant[k * length + i]


@entry("int64(int64, int64, int64)")
def advance_implicit(table, states, fresh):
    """Step until the end, or until ``BUDGET`` steps are taken, or something else happens."""
    method, problem, memory, run, constraints, watch = opened(table, states, fresh)
    if run.counts[BUDGET] == 0:
        return PAUSED
    newton, steps = opened_newton(table), opened_steps(table)
    n = problem.words[STATES]
    state, count, times = run.state, run.counts, run.times
    held = constraints.words[ACTIVE] == 1
    last = times[times.size - 1]
    loosest = memory.rtol[0]
    for i in range(n):
        loosest = min(loosest, memory.rtol[i])
    tolerance = max(10.0 * ROUNDING / max(loosest, ROUNDING), min(0.03, math.sqrt(loosest)))
    x, derivative = address_of(memory.x, 0), address_of(memory.stages, 0)
    t, h = state[TIME], state[SIZE]
    words, sizes = newton.words, newton.sizes
    if count[STARTED] == 0:
        count[EVALUATIONS] += 1
        code = rates(problem, t, x, derivative)
        if code != 0:
            count[FAILURE] = SINGULAR
            return CALLBACK if code < 0 else STEP_UNDERFLOW
        count[STARTED] = 1
        state[LAST_ERROR] = 0.0
        words[WANTED] = words[FIRST] = 1
        sizes[PREDICTING] = 0.0
        if write_reached(problem, memory.x, run):
            return FINISHED
        if h == 0.0:
            h = bounded_first_size(first_trial(memory, n, state[LARGEST], t)[0], t, state[LARGEST])
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
        size, after = limited(t, minimum(h, state[LARGEST]), last)
        if not moves(t, size, after, last):
            state[SIZE] = size
            return STEP_UNDERFLOW
        if words[WANTED] == 1:
            code = set_jacobian(problem, memory, run, newton, t)
            if code < 0:
                return CALLBACK
            words[WANTED], words[FRESH], words[FACTORISED] = 0, 1, 0
        if words[FACTORISED] == 0 or size != sizes[FACTORED]:
            count[FACTORISATIONS] += 1
            if not _factorise_pair(newton, newton.real_order.size, size):
                count[FAILURE], count[REJECTED], h = NOT_FINITE, count[REJECTED] + 1, 0.5 * size
                words[WANTED], words[FACTORISED] = 1 - words[FRESH], 0
                continue
            words[FACTORISED], sizes[FACTORED] = 1, size
        _predict(memory, newton, n, size, sizes[PREDICTING])
        code, converged, iterations, rate = _solve_stages(
            problem, memory, run, newton, t, size, tolerance, tolerance * loosest
        )
        if code < 0:
            return CALLBACK
        if not converged:
            count[REJECTED] += 1
            if code != 0:
                count[FAILURE] = SINGULAR
            elif math.isfinite(rate):
                count[FAILURE] = NO_CONVERGENCE
            else:
                count[FAILURE] = NOT_FINITE
            if words[FRESH] == 1 and code == 0:
                if _forget(newton):
                    words[FACTORISED] = 0
                    continue
                words[FRESH] = 0  # a shorter step has its derivatives again
                h = 0.5 * size
            if words[FRESH] == 1 or code != 0:
                h = 0.5 * size if code == 0 else AFTER_FAILURE * size
                sizes[PREDICTING] = 0.0
            words[WANTED] = 1 - words[FRESH]
            continue
        for i in range(n):
            memory.new[i] = memory.x[i] + newton.stages[2, i]
        code, error = _estimate(problem, memory, run, newton, t, size, words[FIRST] == 1)
        if code < 0:
            return CALLBACK
        safety = 0.9 * (2 * _ITERATIONS + 1) / (2 * _ITERATIONS + iterations)
        factor = max(error, LEAST_ERROR) ** -0.25
        if code != 0 or not error < 1.0:
            count[REJECTED] += 1
            count[FAILURE] = STEP_UNDERFLOW if code == 0 else SINGULAR
            h = size * max(0.2, safety * factor) if math.isfinite(error) else AFTER_FAILURE * size
            words[FIRST], words[WANTED] = 1, 1 - words[FRESH]
            continue
        if held:
            new = address_of(memory.new, 0)
            if call_part(constraints.words[PROJECT], table, after, new) != 0:
                count[REJECTED] += 1
                count[FAILURE], h = CONSTRAINTS_NOT_MET, AFTER_FAILURE * size
                words[FIRST], words[WANTED] = 1, 1 - words[FRESH]
                continue
        count[STEPS] += 1
        if state[LAST_ERROR] > 0.0:  # the error changes as it did in the last step
            factor *= min(
                1.0, size / state[LAST_SIZE] * (state[LAST_ERROR] / max(error, LEAST_ERROR)) ** 0.25
            )
        factor = min(10.0, safety * factor)
        state[TIME], state[LAST_SIZE], state[LAST_ERROR] = after, size, max(error, LEAST_ERROR)
        _set_interpolant(memory, newton, n)
        sizes[PREDICTING] = size
        keep_step(steps, problem, memory, method.shape[DEPTH], t, size, after)
        if watch.words[EVENTS] > 0 or times[count[NEXT]] <= after:
            code = finish_step(table, method, problem, memory, run, constraints, watch, t, size)
            if code == CONSTRAINTS_NOT_MET and watch.words[EVENTS] == 0:
                count[STEPS] -= 1
                steps.words[KEPT] -= 1
                count[REJECTED] += 1
                count[FAILURE], h = CONSTRAINTS_NOT_MET, AFTER_FAILURE * size
                words[FIRST], words[WANTED], sizes[PREDICTING] = 1, 1 - words[FRESH], 0.0
                continue
            if code != 0:
                steps.words[KEPT] += 1
                return code
        t = after
        for i in range(n):
            memory.x[i] = memory.new[i]
        count[EVALUATIONS] += 1
        code = rates(problem, t, x, derivative)
        if code != 0:
            count[FAILURE] = SINGULAR
            state[SIZE] = size
            return CALLBACK if code < 0 else STEP_UNDERFLOW
        slow = iterations > 2 and rate > SLOW
        words[WANTED], words[FRESH], words[FIRST] = (1 if slow else 0), 0, 0
        # The same step size spares a factorisation.
        h = size if 1.0 < factor < 1.2 and not slow else size * max(0.2, factor)
        if count[NEXT] == times.size:
            state[SIZE] = h
            return FINISHED
