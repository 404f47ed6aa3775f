"""The adjoint of explicit Runge–Kutta steps, from the last to the first.

With the stages k_i = f(X_i), X_i = x + h Σ a_ij k_j and the step x + h Σ b_i k_i, what depends on
the state after a step through its adjoint λ depends on that before it through λ + Σ u_i, where

    w_i = h (b_i λ + Σ a_ji u_j)        u_i = (∂f/∂x)ᵀ w_i

from the last stage to the first, and on the parameters through Σ (∂f/∂θ)ᵀ w_i: the adjoint of the
steps that were taken, not an integration of its own (E. Hairer, C. Lubich and G. Wanner, Geometric
Numerical Integration, 2nd ed., 2006, VI.9; A. Walther, Computational Optimization and Applications
36 (2007) 83–108).
"""

from __future__ import annotations

from pydy.solvers.adjoint.layout import (
    BACK,
    FURTHER,
    KEPT,
    STAGES,
    WEIGHTS,
    WRONG,
    Backward,
)
from pydy.solvers.loop.compiled import entry
from pydy.solvers.loop.entrance import opening
from pydy.solvers.loop.intrinsics import address_of, combine
from pydy.solvers.loop.rates import rates
from pydy.solvers.run.layout import BLOCKS, STATES, Problem

__all__ = ["step_back"]

_opened_problem = opening(BACK, Problem)
_opened_backward = opening(BACK, Backward)


@entry("int64(int64)")
def step_back(table):
    """Go back through all steps. Not zero: what the kernel complained."""
    problem, back = _opened_problem(table), _opened_backward(table)
    n, blocks = problem.words[STATES], problem.words[BLOCKS]
    stages, place = back.words[STAGES], back.words[WEIGHTS]
    further, kept = back.words[FURTHER], back.words[KEPT]
    length, adjoints = back.state.size, back.adjoints
    step, state = address_of(back.step, 0), address_of(back.state, 0)
    for k in range(back.times.size - 1, -1, -1):
        t, h = back.times[k], back.sizes[k]
        for i in range(back.step.size):
            back.step[i] = h
        before = address_of(back.states, k * length)
        known = address_of(back.stages, k * stages * length)
        for stage in range(stages - 1, -1, -1):
            first = back.rows[stage]
            count = back.rows[stage + 1] - first
            combine(
                state,
                before,
                step,
                known,
                address_of(back.offsets, first),
                address_of(back.coefficients, first),
                max(count - 1, 0),
                min(count, 1),
                blocks,
            )
            first = back.rows[stages + stage]
            combine(
                address_of(back.weighted, 0),
                address_of(back.zero, 0),
                step,
                address_of(adjoints, 0),
                address_of(back.offsets, first),
                address_of(back.coefficients, first),
                back.rows[stages + stage + 1] - first,
                0,
                blocks,
            )
            for i in range(n):
                problem.r[place + i] = back.weighted[i]
            code = rates(problem, t + back.nodes[stage] * h, state, address_of(back.out, 0))
            if code != 0:
                back.words[WRONG] = k
                return code
            for i in range(n):
                adjoints[stage * length + i] = back.out[i]
            for i in range(further):
                back.totals[i] += back.out[n + i]
            for i in range(kept):
                back.kept[k * stages + stage, i] = back.out[n + further - kept + i]
        for stage in range(stages):
            for i in range(n):
                adjoints[stages * length + i] += adjoints[stage * length + i]
    return 0
