"""The continuous extension of a run: its steps are kept, and taken again where they are wanted."""

from __future__ import annotations

from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.entrance import (
    opened_constraints,
    opened_memory,
    opened_method,
    opened_problem,
    opened_progress,
    opened_wanted,
)
from pydy.solvers.loop.intrinsics import address_of, call_part
from pydy.solvers.loop.rates import rates
from pydy.solvers.loop.runge_kutta import interpolate, prepare_interpolant, take_step
from pydy.solvers.run.layout import (
    ACTIVE,
    DEPTH,
    KEPT,
    PROJECT,
    ROOM,
    STAGES,
    STATES,
)

__all__ = ["extend", "full", "keep_step"]


@inlined
def full(steps):
    """Tell whether there is no room for a step that an event ends."""
    return steps.words[ROOM] > 0 and steps.words[ROOM] < steps.words[KEPT] + 3


@inlined
def keep_step(steps, problem, memory, depth, t, h, after):
    """Keep an accepted step, with `depth` vectors of its interpolant, and its end."""
    if steps.words[ROOM] == 0:
        return
    k, n, rows = steps.words[KEPT], problem.words[STATES], steps.rows
    rows[k, 0], rows[k, 1], rows[k + 1, 0], rows[k + 1, 1] = t, h, after, 0.0
    for i in range(n):
        rows[k, 2 + i], rows[k + 1, 2 + i] = memory.x[i], memory.new[i]
        for j in range(depth):
            rows[k, 2 + (1 + j) * n + i] = memory.interpolant[j * memory.x.size + i]
    steps.words[KEPT] = k + 1


@inlined(pasted=True)
def _take_again(method, problem, memory, run, rows, k):
    """Compute the interpolant of a step that was kept, with the same bits as before."""
    n, length, stages = problem.words[STATES], memory.x.size, method.shape[STAGES]
    t, h = rows[k, 0], rows[k, 1]
    for i in range(n):
        memory.x[i] = rows[k, 2 + i]
    if stages == 0:
        for j in range(method.shape[DEPTH]):
            for i in range(n):
                memory.interpolant[j * length + i] = rows[k, 2 + (1 + j) * n + i]
        return 0
    code = rates(problem, t, address_of(memory.x, 0), address_of(memory.stages, 0))
    if code == 0:
        code = take_step(method, problem, memory, run, t, h)
    if code != 0:
        return code
    for i in range(n):
        memory.new[i] = rows[k + 1, 2 + i]  # after the projection
    end = address_of(memory.stages, stages * length)
    code = rates(problem, rows[k + 1, 0], address_of(memory.new, 0), end)
    if code != 0:
        return code
    return prepare_interpolant(method, problem, memory, run, t, h)


@entry("int64(int64, int64)")
def extend(table, request):
    """Write the states at some ascending times. Not zero: what the right-hand side complained."""
    method, problem, memory = opened_method(table), opened_problem(table), opened_memory(table)
    run, constraints, wanted = (
        opened_progress(table),
        opened_constraints(table),
        opened_wanted(request),
    )
    n, rows, current = problem.words[STATES], wanted.rows, -1
    for k in range(wanted.times.size):
        place, out = wanted.places[k], address_of(wanted.out, k * n)
        if rows[place, 1] == 0.0:
            for i in range(n):
                wanted.out[k * n + i] = rows[place, 2 + i]
            continue
        if place != current:
            current = place
            code = _take_again(method, problem, memory, run, rows, place)
            if code != 0:
                return code
        theta = (wanted.times[k] - rows[place, 0]) / rows[place, 1]
        interpolate(method, problem, memory, theta, out)
        if constraints.words[ACTIVE] == 1 and theta > 0.0:
            call_part(constraints.words[PROJECT], table, wanted.times[k], out)
    return 0
