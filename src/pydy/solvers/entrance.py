"""The way from Python into compiled steppers: all their arrays as one table of addresses.

numba looks at every array of every argument at each call, which takes as long as a hundred steps of
a pendulum. A table is made once for an integration; compiled code gets its address, and opens what
it needs of it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy.solvers.compiled import inlined
from pydy.solvers.intrinsics import (
    complex_matrix,
    flattened,
    numbers,
    real_matrix,
    word_matrix,
    words,
)
from pydy.solvers.layout import STATES, Constraints, Memory, Method, Problem, Run, Watch
from pydy.solvers.newton import Newton
from pydy.solvers.problem import address
from pydy.solvers.runge_kutta import copy_vector

__all__ = [
    "opened",
    "opened_constraints",
    "opened_memory",
    "opened_method",
    "opened_newton",
    "opened_problem",
    "opened_progress",
    "opened_watch",
    "rows_of",
    "table_of",
]


def rows_of(arrays: Sequence[np.ndarray]) -> list[tuple[int, int]]:
    """Return address and length of each array; the length of a matrix is that of its first axis."""
    return [(address(array), len(array)) for array in arrays]


def table_of(*parts: Sequence[tuple[int, int]]) -> np.ndarray:
    """Return the table of all rows. Who makes it keeps the arrays alive."""
    return np.array([row for rows in parts for row in rows], dtype=np.int64)


@inlined
def opened_method(table):
    """Return the tableau."""
    return Method(
        words(table, 0),
        words(table, 1),
        words(table, 2),
        numbers(table, 3),
        numbers(table, 4),
        numbers(table, 5),
    )


@inlined
def opened_problem(table):
    """Return the right-hand side."""
    return Problem(
        words(table, 6),
        numbers(table, 7),
        numbers(table, 8),
        numbers(table, 9),
        word_matrix(table, 10, 4),
        numbers(table, 11),
        real_matrix(table, 12, 4),
    )


@inlined
def opened_memory(table):
    """Return the trajectory's numbers."""
    return Memory(
        numbers(table, 13),
        numbers(table, 14),
        numbers(table, 15),
        numbers(table, 16),
        numbers(table, 17),
        numbers(table, 18),
        numbers(table, 19),
        numbers(table, 20),
        numbers(table, 21),
        numbers(table, 22),
        numbers(table, 23),
    )


@inlined
def opened_progress(table):
    """Return ``Run.state`` and ``Run.counts``."""
    return numbers(table, 24), words(table, 25)


@inlined
def opened_constraints(table):
    """Return what the projection works with."""
    return Constraints(words(table, 28), numbers(table, 29), numbers(table, 30))


@inlined
def opened_watch(table, n):
    """Return the events."""
    return Watch(
        words(table, 31),
        numbers(table, 32),
        words(table, 33),
        words(table, 34),
        words(table, 35),
        words(table, 36),
        numbers(table, 37),
        numbers(table, 38),
        numbers(table, 39),
        words(table, 40),
        real_matrix(table, 41, n),
    )


@inlined
def opened(table, states, fresh):
    """Return all tuples of `layout`; results go to the matrix `states`.

    Where `fresh` is 1 an integration begins here, from the state in its first row.
    """
    method, problem, memory = opened_method(table), opened_problem(table), opened_memory(table)
    state, counts = opened_progress(table)
    run = Run(state, counts, numbers(table, 26), flattened(states))
    n = problem.words[STATES]
    if fresh == 1:
        for i in range(n):
            memory.x[i] = run.flat[i]
        copy_vector(numbers(table, 42), state)
        copy_vector(words(table, 43), counts)
    return method, problem, memory, run, opened_constraints(table), opened_watch(table, n)


@inlined
def opened_newton(table, n):
    """Return the arrays of an implicit step, which follow in its table."""
    return Newton(
        words(table, 44),
        numbers(table, 45),
        numbers(table, 46),
        numbers(table, 47),
        real_matrix(table, 48, n),
        complex_matrix(table, 49, n),
        words(table, 50),
        words(table, 51),
        real_matrix(table, 52, n),
        real_matrix(table, 53, n),
        real_matrix(table, 54, n),
        real_matrix(table, 55, n),
    )
