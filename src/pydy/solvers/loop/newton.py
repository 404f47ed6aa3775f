"""Dense linear algebra and Newton's method for the stages of Radau IIA, compiled by numba."""

from __future__ import annotations

import math
from typing import Any

from numba import types
from numba.extending import overload

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.intrinsics import address_of, call_kernel
from pydy.solvers.loop.rates import rates, set_inputs
from pydy.solvers.run.layout import EVALUATIONS, GRADIENT, JACOBIANS, STATES
from pydy.solvers.tuning import DIFFERENCE, DIFFERENCE_SCALE

__all__ = ["factorise", "set_jacobian", "solve", "solve_columns"]


@inlined(pasted=True)
def set_jacobian(problem, memory, run, newton, t):
    """Evaluate ∂f/∂x at ``memory.x``, whose derivative is the first of ``memory.stages``.

    An infinite slope, as of a square root at zero, counts as zero: the iteration then goes without
    this derivative, where dividing by infinity would keep the state where it is.
    """
    run.counts[JACOBIANS] += 1
    code = _evaluate_jacobian(problem, memory, run, newton, t)
    for i in range(newton.jacobian.size):
        if not math.isfinite(newton.jacobian[i]):
            newton.jacobian[i] = 0.0
    return code


@inlined(pasted=True)
def _evaluate_jacobian(problem, memory, run, newton, t):
    n = problem.words[STATES]
    if newton.words[GRADIENT] != 0:
        set_inputs(problem, t)
        return call_kernel(
            newton.words[GRADIENT],
            address_of(problem.clock, 0),
            address_of(memory.x, 0),
            address_of(problem.r, 0),
            address_of(newton.c, 0),
            address_of(newton.jacobian, 0),
        )
    for i in range(n):
        memory.trial[i] = memory.x[i]
    for j in range(n):
        step = DIFFERENCE * max(abs(memory.x[j]), DIFFERENCE_SCALE)
        moved = memory.x[j] + step
        step = moved - memory.x[j]
        memory.trial[j] = moved
        run.counts[EVALUATIONS] += 1
        code = rates(problem, t, address_of(memory.trial, 0), address_of(memory.new, 0))
        if code != 0:
            return code
        for i in range(n):
            newton.jacobian[i * n + j] = (memory.new[i] - memory.stages[i]) / step
        memory.trial[j] = memory.x[j]
    return 0


def _quotient(a: Any, b: Any) -> Any:
    """Return a / b: numba's own division of complex numbers may raise an exception."""


@overload(_quotient, inline="always")
def _overload_quotient(a, b):
    if not isinstance(b, types.Complex):
        return lambda a, b: a / b

    def divide(a, b):
        if abs(b.real) >= abs(b.imag):
            ratio = b.imag / b.real
            total = b.real + b.imag * ratio
            return complex((a.real + a.imag * ratio) / total, (a.imag - a.real * ratio) / total)
        ratio = b.real / b.imag
        total = b.real * ratio + b.imag
        return complex((a.real * ratio + a.imag) / total, (a.imag * ratio - a.real) / total)

    return divide


@inlined
def factorise(matrix, order):
    """Factorise a square matrix in place, with row pivots; False if it is singular."""
    n = matrix.shape[0]
    for k in range(n):
        pivot, largest = k, abs(matrix[k, k])
        for i in range(k + 1, n):
            size = abs(matrix[i, k])
            if size > largest:
                pivot, largest = i, size
        order[k] = pivot
        if largest == 0.0 or largest != largest:
            return False
        if pivot != k:
            for j in range(n):
                matrix[k, j], matrix[pivot, j] = matrix[pivot, j], matrix[k, j]
        inverse = _quotient(1.0, matrix[k, k])
        for i in range(k + 1, n):
            if matrix[i, k] != 0.0:
                factor = matrix[i, k] * inverse
                matrix[i, k] = factor
                for j in range(k + 1, n):
                    matrix[i, j] -= factor * matrix[k, j]
    return True


@inlined
def solve(matrix, order, right):
    """Solve in place for one right-hand side."""
    n = matrix.shape[0]
    for k in range(n):
        pivot = order[k]
        if pivot != k:
            right[k], right[pivot] = right[pivot], right[k]
    for i in range(n):
        value = right[i]
        for j in range(i):
            value -= matrix[i, j] * right[j]
        right[i] = value
    for i in range(n - 1, -1, -1):
        value = right[i]
        for j in range(i + 1, n):
            value -= matrix[i, j] * right[j]
        right[i] = _quotient(value, matrix[i, i])


@inlined
def solve_columns(matrix, order, right, width):
    """Solve in place for the rows of some columns, which follow a first right-hand side."""
    n = matrix.shape[0]
    for k in range(n):
        pivot = order[k]
        if pivot != k:
            a, b = n + k * width, n + pivot * width
            for c in range(width):
                right[a + c], right[b + c] = right[b + c], right[a + c]
    for i in range(n):
        for j in range(i):
            factor, a, b = matrix[i, j], n + i * width, n + j * width
            for c in range(width):
                right[a + c] -= factor * right[b + c]
    for i in range(n - 1, -1, -1):
        a = n + i * width
        for j in range(i + 1, n):
            factor, b = matrix[i, j], n + j * width
            for c in range(width):
                right[a + c] -= factor * right[b + c]
        inverse = _quotient(1.0, matrix[i, i])
        for c in range(width):
            right[a + c] *= inverse
