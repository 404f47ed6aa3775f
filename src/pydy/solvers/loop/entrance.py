"""The way from Python into compiled code: arrays are opened from a table of addresses.

numba looks at every array of every argument at each call, which takes as long as a hundred steps of
a pendulum. A table (see `table`) is made once for an integration; compiled code gets its address.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, get_type_hints

import numpy as np
from numba import from_dtype, types

from pydy.solvers.loop.compiled import inlined
from pydy.solvers.loop.intrinsics import array_of_row, intrinsic, numbers_at
from pydy.solvers.loop.runge_kutta import copy_vector
from pydy.solvers.run.layout import (
    ALONG,
    EXTENSION,
    PROJECTION,
    RUN,
    STATES,
    Beginning,
    Constraints,
    Memory,
    Method,
    Newton,
    Numbers,
    Problem,
    Progress,
    Projection,
    Steps,
    Tangents,
    Wanted,
    Watch,
    Words,
    first_row,
)

__all__ = [
    "opened",
    "opened_constraints",
    "opened_memory",
    "opened_method",
    "opened_newton",
    "opened_problem",
    "opened_progress",
    "opened_projection",
    "opened_steps",
    "opened_tangents",
    "opened_wanted",
    "opened_watch",
    "opening",
]


def opening(parts: Sequence[Any], kind: Any) -> Any:
    """Return the compiled function that opens one part of a table, given the table's address.

    Parameters
    ----------
    parts : sequence of named tuples
        All parts of the table.
    kind : named tuple
        The one to open.
    """
    first = first_row(parts, kind)
    hints = get_type_hints(kind, include_extras=True)
    kinds = [hints[name].__metadata__ for name in kind._fields]
    arrays = [types.Array(from_dtype(np.dtype(number)), ndim, "C") for number, ndim in kinds]
    result = types.NamedTuple(arrays, kind)

    @intrinsic
    def opened_part(typingctx, table):
        def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            items = [
                array_of_row(array, arguments[0], first + k, context, builder)
                for k, array in enumerate(arrays)
            ]
            return context.make_tuple(builder, result, items)

        return result(types.int64), codegen

    return opened_part


opened_method = opening(RUN, Method)
opened_problem = opening(RUN, Problem)
opened_memory = opening(RUN, Memory)
opened_progress = opening(RUN, Progress)
opened_constraints = opening(RUN, Constraints)
opened_watch = opening(RUN, Watch)
opened_newton = opening(RUN, Newton)
opened_steps = opening(RUN, Steps)
opened_wanted = opening(EXTENSION, Wanted)
opened_projection = opening(PROJECTION, Projection)
opened_tangents = opening(ALONG, Tangents)
_opened_beginning = opening(RUN, Beginning)


class Run(NamedTuple):
    """`Progress`, and the matrix of results."""

    state: Numbers
    counts: Words
    times: Numbers
    flat: Numbers  # row after row and a block more: rows are written in whole blocks


@inlined
def opened(table, states, fresh):
    """Return all tuples of `layout`; results go to the matrix at the address `states`.

    Where `fresh` is 1 an integration begins here, from the state in its first row.
    """
    method, problem, memory = opened_method(table), opened_problem(table), opened_memory(table)
    progress, n = opened_progress(table), problem.words[STATES]
    flat = numbers_at(states, progress.times.size * n)
    run = Run(progress.state, progress.counts, progress.times, flat)
    if fresh == 1:
        beginning = _opened_beginning(table)
        for i in range(n):
            memory.x[i] = run.flat[i]
        copy_vector(beginning.state, run.state)
        copy_vector(beginning.counts, run.counts)
    return method, problem, memory, run, opened_constraints(table), opened_watch(table)
