"""The derivative of the state, with sampled inputs, as compiled code calls it."""

from __future__ import annotations

from pydy.solvers.compiled import inlined
from pydy.solvers.intrinsics import address_of, call_kernel
from pydy.solvers.layout import KERNEL

__all__ = ["rates", "set_inputs"]


@inlined
def set_inputs(problem, t):
    """Set the kernel's time, and the sampled inputs of that time; their end values are held."""
    problem.clock[0] = t
    tables, knots = problem.tables, problem.knots
    for k in range(tables.shape[0]):
        first, number, low = tables[k, 1], tables[k, 2], tables[k, 3]
        s = max(t, knots[first])
        after = low == number - 1 or s < knots[first + low + 1]
        if not (knots[first + low] <= s and after):
            low, high = 0, number
            while high - low > 1:
                middle = (low + high) // 2
                if knots[first + middle] <= s:
                    low = middle
                else:
                    high = middle
            tables[k, 3] = low  # the next evaluation is most often in the same interval
        s -= knots[first + low]
        a = problem.cubics[first + low]
        problem.r[tables[k, 0]] = a[0] + s * (a[1] + s * (a[2] + s * a[3]))


@inlined
def rates(problem, t, x, out):
    """Evaluate the derivative; `x` and `out` are addresses. Not zero: the kernel's complaint."""
    set_inputs(problem, t)
    return call_kernel(
        problem.words[KERNEL],
        address_of(problem.clock, 0),
        x,
        address_of(problem.r, 0),
        address_of(problem.c, 0),
        out,
    )
