"""The way from Python into compiled steppers: all their arrays as one table of addresses.

numba looks at every array of every argument at each call, which takes as long as a hundred steps of
a pendulum. A table is made once for an integration, and opened by compiled code.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pydy.solvers.compiled import inlined
from pydy.solvers.intrinsics import complex_matrix, real_matrix, word_matrix
from pydy.solvers.layout import Constraints, Memory, Method, Problem, Run, Watch
from pydy.solvers.newton import Newton
from pydy.solvers.problem import address

__all__ = ["PLACES", "opened", "opened_newton", "rows_of", "table_of"]

_PARTS = (Method, Problem, Memory, Run, Constraints, Watch)
_FIRST = np.cumsum([0, *(len(part._fields) for part in _PARTS)])
# Where in a table each part lies.
PLACES = {part: slice(*_FIRST[k : k + 2]) for k, part in enumerate(_PARTS)}


def rows_of(arrays: Sequence[np.ndarray]) -> list[tuple[int, int]]:
    """Return address and length of each array; the length of a matrix is that of its first axis."""
    return [(address(array), len(array)) for array in arrays]


def table_of(*parts: Sequence[tuple[int, int]]) -> np.ndarray:
    """Return the table of all rows. Who makes it keeps the arrays alive."""
    return np.array([row for rows in parts for row in rows], dtype=np.int64)


@inlined
def opened(table, flat):
    """Return the tuples of `layout`; `flat` is the array of a `Run` that results go to."""
    method = Method(
        word_matrix(table[0, 0], 1, table[0, 1])[0],
        word_matrix(table[1, 0], 1, table[1, 1])[0],
        word_matrix(table[2, 0], 1, table[2, 1])[0],
        real_matrix(table[3, 0], 1, table[3, 1])[0],
        real_matrix(table[4, 0], 1, table[4, 1])[0],
        real_matrix(table[5, 0], 1, table[5, 1])[0],
    )
    problem = Problem(
        word_matrix(table[6, 0], 1, table[6, 1])[0],
        real_matrix(table[7, 0], 1, table[7, 1])[0],
        real_matrix(table[8, 0], 1, table[8, 1])[0],
        real_matrix(table[9, 0], 1, table[9, 1])[0],
        word_matrix(table[10, 0], table[10, 1], 4),
        real_matrix(table[11, 0], 1, table[11, 1])[0],
        real_matrix(table[12, 0], table[12, 1], 4),
    )
    memory = Memory(
        real_matrix(table[13, 0], 1, table[13, 1])[0],
        real_matrix(table[14, 0], 1, table[14, 1])[0],
        real_matrix(table[15, 0], 1, table[15, 1])[0],
        real_matrix(table[16, 0], 1, table[16, 1])[0],
        real_matrix(table[17, 0], 1, table[17, 1])[0],
        real_matrix(table[18, 0], 1, table[18, 1])[0],
        real_matrix(table[19, 0], 1, table[19, 1])[0],
        real_matrix(table[20, 0], 1, table[20, 1])[0],
        real_matrix(table[21, 0], 1, table[21, 1])[0],
        real_matrix(table[22, 0], 1, table[22, 1])[0],
        real_matrix(table[23, 0], 1, table[23, 1])[0],
    )
    run = Run(
        real_matrix(table[24, 0], 1, table[24, 1])[0],
        word_matrix(table[25, 0], 1, table[25, 1])[0],
        real_matrix(table[26, 0], 1, table[26, 1])[0],
        flat,
    )
    constraints = Constraints(
        word_matrix(table[28, 0], 1, table[28, 1])[0],
        real_matrix(table[29, 0], 1, table[29, 1])[0],
        real_matrix(table[30, 0], 1, table[30, 1])[0],
    )
    n = problem.words[1]
    watch = Watch(
        word_matrix(table[31, 0], 1, table[31, 1])[0],
        real_matrix(table[32, 0], 1, table[32, 1])[0],
        word_matrix(table[33, 0], 1, table[33, 1])[0],
        word_matrix(table[34, 0], 1, table[34, 1])[0],
        word_matrix(table[35, 0], 1, table[35, 1])[0],
        word_matrix(table[36, 0], 1, table[36, 1])[0],
        real_matrix(table[37, 0], 1, table[37, 1])[0],
        real_matrix(table[38, 0], 1, table[38, 1])[0],
        real_matrix(table[39, 0], 1, table[39, 1])[0],
        word_matrix(table[40, 0], 1, table[40, 1])[0],
        real_matrix(table[41, 0], table[41, 1], n),
    )
    return method, problem, memory, run, constraints, watch


@inlined
def opened_newton(table, n):
    """Return the arrays of an implicit step."""
    return Newton(
        word_matrix(table[0, 0], 1, table[0, 1])[0],
        real_matrix(table[1, 0], 1, table[1, 1])[0],
        real_matrix(table[2, 0], 1, table[2, 1])[0],
        real_matrix(table[3, 0], 1, table[3, 1])[0],
        real_matrix(table[4, 0], n, n),
        complex_matrix(table[5, 0], n, n),
        word_matrix(table[6, 0], 1, table[6, 1])[0],
        word_matrix(table[7, 0], 1, table[7, 1])[0],
        real_matrix(table[8, 0], 3, n),
        real_matrix(table[9, 0], 3, n),
        real_matrix(table[10, 0], 3, n),
        real_matrix(table[11, 0], 4, n),
    )
