"""Dependent speeds by divisions, against NumPy."""

import numpy as np
import pytest

from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._mechanics.reduction import solve_by_cofactors
from pydy._program.interpret import run

PATTERNS = {
    "one": ["1"],
    "full": ["111", "111", "111"],
    "triangular": ["100", "110", "111"],
    "in no order": ["0110", "1000", "1110", "1001"],
    "two loops": ["11000", "11000", "01111", "00111", "00111"],
}


def solved(pattern, a, b):
    """Solve for the columns of b; what fails is said beside."""
    n = len(pattern)
    g = Graph()
    matrix = [
        [g.input("x", n * i + j) if pattern[i][j] == "1" else g.zero for j in range(n)]
        for i in range(n)
    ]
    columns = [[g.input("x", n * n + n * k + i) for i in range(n)] for k in range(b.shape[1])]
    found = solve_by_cofactors(g, matrix, columns)
    if found is None:
        return None
    x = np.concatenate([a.ravel(), b.T.ravel()])
    nodes = [node for column in found[0] for node in column]
    program = lower(g, (len(x), 0, 0), [("solutions", (len(nodes),), nodes)])
    values, failed = run(program, np.zeros(1), x[None], np.zeros((1, 0)), np.zeros(0))
    assert not failed.any()
    return values.reshape(b.shape[1], n).T


@pytest.mark.parametrize("name", PATTERNS)
def test_solutions_are_those_of_the_system(name):
    pattern, rng = PATTERNS[name], np.random.default_rng(4)
    n = len(pattern)
    a = rng.normal(size=(n, n)) * np.array([[c == "1" for c in row] for row in pattern])
    b = rng.normal(size=(n, 2))
    np.testing.assert_allclose(solved(pattern, a, b), np.linalg.solve(a, b), rtol=1e-12)


def test_four_that_hang_together_are_left_to_a_solve():
    ring = ["1100", "0110", "0011", "1001"]
    assert solved(ring, np.eye(4), np.ones((4, 1))) is None


def test_where_it_is_singular_the_unknowns_are_not_finite_and_nothing_fails():
    a = np.array([[1.0, 2.0], [2.0, 4.0]])
    assert not np.isfinite(solved(["11", "11"], a, np.ones((2, 1)))).any()
