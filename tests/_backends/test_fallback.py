"""What a compiled solve does where its quick way fails, for sparse matrices large and small."""

import numpy as np
import pytest

from graphs import on_tape
from pydy._backends.llvm.native import LLVMBackend
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._program.interpret import run

every_width = pytest.mark.parametrize("lanes", [1, 2, 8])


def chain(n, kind):
    """A tridiagonal matrix with states, constants and numbers among its entries."""
    graph = Graph()
    zero = graph.zero
    rows = [[zero] * n for _ in range(n)]
    for k in range(n):
        rows[k][k] = (graph.input("x", k), graph.input("p", 0), graph.const(2.5))[k % 3]
        if k:
            rows[k][k - 1] = rows[k - 1][k] = graph.input("p", 1)
    right = [graph.input("x", n + k) for k in range(n)]
    return on_tape(graph, LinearSystem(graph, rows, kind).solve(right), (2 * n, 0, 2))


def dense(x, p, n):
    diagonal = np.array([(x[k], p[0], 2.5)[k % 3] for k in range(n)])
    return np.diag(diagonal) + p[1] * (np.eye(n, k=1) + np.eye(n, k=-1)), x[n:]


@every_width
@pytest.mark.parametrize("kind", ["ldl", "lu"])
@pytest.mark.parametrize("n", [9, 30, 80])
def test_lanes_that_cannot_go_the_quick_way_are_solved_by_pivoting(n, kind, lanes):
    program = chain(n, kind)
    rng = np.random.default_rng(n)
    p = np.array([3.0, 1.0])
    x = np.column_stack([rng.uniform(3, 4, (19, n)), rng.normal(size=(19, n))])
    x[::3, :n] *= rng.choice([-1.0, 1.0], (7, n))  # no longer definite
    x[4, 3] = 0.0  # a pivot of zero
    x[8, 0] = 1e-30
    t, r = np.zeros(19), np.empty((19, 0))
    found, failed = LLVMBackend(lanes=lanes).compile(program).evaluate(t, x, r, p)
    assert not failed.any()
    for row, states in zip(found, x, strict=True):
        a, b = dense(states, p, n)
        np.testing.assert_allclose(row, np.linalg.solve(a, b), rtol=1e-8)
    np.testing.assert_allclose(found, run(program, t, x, r, p)[0], rtol=1e-8)


def test_a_sweep_over_three_hundred_unknowns_needs_no_large_stack():
    n = 300
    program = chain(n, "ldl")
    x = np.column_stack([np.full((8, n), -4.0), np.ones((8, n))])
    p = np.array([3.0, 1.0])
    kernel = LLVMBackend(lanes=8).compile(program)
    found, failed = kernel.evaluate(np.zeros(8), x, np.empty((8, 0)), p)
    assert not failed.any()
    np.testing.assert_allclose(found[0], np.linalg.solve(*dense(x[0], p, n)), rtol=1e-8)
