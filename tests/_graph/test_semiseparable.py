"""Mass matrices whose rows and columns separate are solved in O(n), and as safely as any other."""

import numpy as np
import pytest

from graphs import on_tape
from pydy._backends.c.cython_ import CythonBackend
from pydy._backends.llvm.backend import LLVMBackend
from pydy._backends.numpy_ import NumPyBackend
from pydy._graph.interpret import run
from pydy._graph.node import Graph
from pydy._graph.solve.semiseparable import separate
from pydy._graph.switches import Passes

N = 14
BACKENDS = {
    "interpreter": None,
    "lambdify": NumPyBackend(),
    "llvm": LLVMBackend(),
    "llvm 8": LLVMBackend(lanes=8),
}


def parts(n=N, channels=2):
    """A graph with rows X, columns Y, a diagonal D and a right-hand side b as states."""
    graph = Graph()
    count = iter(range(n * (2 * channels + 2)))
    table = [[graph.input("x", next(count)) for _ in range(2 * channels + 2)] for _ in range(n)]
    rows = [line[:channels] for line in table]
    columns = [line[channels : 2 * channels] for line in table]
    return graph, rows, columns, [line[-2] for line in table], [line[-1] for line in table]


def matrix(graph, rows, columns, diagonal):
    n = len(rows)

    def entry(i, j):
        if i == j:
            return diagonal[i]
        i, j = sorted((i, j))
        return graph.add(*(graph.mul(x, y) for x, y in zip(rows[i], columns[j], strict=True)))

    return [[entry(i, j) for j in range(n)] for i in range(n)]


def solution(n=N, channels=2, without=()):
    graph, rows, columns, diagonal, right = parts(n, channels)
    nodes = graph.solve(matrix(graph, rows, columns, diagonal), [right], "ldl")[0]
    sizes = (n * (2 * channels + 2), 0, 0)
    return on_tape(graph, nodes, sizes, passes=Passes.without(*without))


def dense(x, n=N, channels=2):
    """The same matrix and right-hand side as arrays."""
    table = x.reshape(n, 2 * channels + 2)
    a = np.triu(table[:, :channels] @ table[:, channels : 2 * channels].T, 1)
    return a + a.T + np.diag(table[:, -2]), table[:, -1]


def pendulum(rng, masses, lengths):
    """States that make the matrix that of a chain of links at random angles."""
    n = len(masses)
    angle = rng.uniform(-np.pi, np.pi, n)
    below = np.cumsum(masses[::-1])[::-1]
    turn = np.column_stack([np.cos(angle), np.sin(angle)])
    columns = (lengths * below)[:, None] * turn
    diagonal = lengths**2 * below
    table = np.column_stack([lengths[:, None] * turn, columns, diagonal, rng.normal(size=n)])
    return table.ravel()


def evaluated(program, x, backend):
    arguments = (np.zeros(len(x)), x, np.empty((len(x), 0)), np.empty(0))
    if backend is None:
        return run(program, *arguments)
    return backend.compile(program).evaluate(arguments[0], x, np.empty((len(x), 0)), np.empty(0))


def backward_error(a, x, b):
    scale = 1 / np.sqrt(np.diag(a))  # units do not matter
    a, x, b = a * np.outer(scale, scale), x / scale, b * scale
    return np.abs(a @ x - b).max() / (np.abs(a).sum() * np.abs(x).max() + np.abs(b).max())


def total(program):
    return program.operation_count["run"].total()


def test_the_cost_grows_with_the_number_of_rows_only():
    costs = [total(solution(n)) for n in (20, 40, 60)]
    assert costs[2] - costs[1] == costs[1] - costs[0]
    assert costs[0] < total(solution(20, without=["semiseparable"])) / 2


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_chain_of_links_is_solved_to_rounding(backend):
    rng = np.random.default_rng(1)
    x = np.array([pendulum(rng, rng.uniform(0.5, 2, N), rng.uniform(0.5, 2, N)) for _ in range(9)])
    found, failed = evaluated(solution(), x, BACKENDS[backend])
    assert not failed.any()
    for row, states in zip(found, x, strict=True):
        assert backward_error(*dense(states)[:1], row, dense(states)[1]) < 1e-15


def test_masses_of_very_different_size_do_not_harm():
    rng = np.random.default_rng(2)
    x = np.array(
        [pendulum(rng, 10.0 ** rng.uniform(-6, 6, N), 10.0 ** rng.uniform(-2, 2, N))]
        + [pendulum(rng, 10.0 ** np.linspace(a, -a, N), np.ones(N)) for a in (-6, 6)]
    )
    for states in x:
        found, failed = evaluated(solution(), states[None], None)
        assert not failed.any()
        a, b = dense(states)
        assert backward_error(a, found[0], b) < 1e-15


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_matrix_that_is_not_positive_definite_falls_back_to_lu_lane_by_lane(backend):
    rng = np.random.default_rng(3)
    good = [pendulum(rng, np.ones(N), np.ones(N)) for _ in range(9)]
    x = np.array([rng.normal(size=good[0].size) if k % 3 == 1 else s for k, s in enumerate(good)])
    found, failed = evaluated(solution(), x, BACKENDS[backend])
    assert not failed.any()
    for row, states in zip(found, x, strict=True):
        np.testing.assert_allclose(row, np.linalg.solve(*dense(states)), rtol=1e-9)


def test_cancellation_between_channels_falls_back_to_lu():
    # Row 0 is huge in both channels, with opposite signs, and every column sums the channels. All
    # entries of the matrix are exact; the mobility of the first row is 2**46 in every direction but
    # the columns' own.
    table = np.zeros((N, 6))
    table[:, 2:4] = 1 + np.arange(N)[:, None] / 16
    table[0, :2] = 2.0**23, -(2.0**23)
    table[:, 4:] = 1.0
    table[3, 2] += 2.0**-25
    expected, _ = evaluated(solution(without=["semiseparable"]), table.reshape(1, -1), None)
    found, failed = evaluated(solution(), table.reshape(1, -1), None)
    assert not failed.any()
    np.testing.assert_allclose(found, expected, rtol=1e-15)
    a, b = dense(table.ravel())
    assert backward_error(a, found[0], b) < 1e-15


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_singular_matrix_is_reported(backend):
    x = np.array([pendulum(np.random.default_rng(5), np.ones(N), np.ones(N))] * 3)
    x[1].reshape(N, 6)[4] = 0.0
    _, failed = evaluated(solution(), x, BACKENDS[backend])
    assert failed.tolist() == [False, True, False]


def test_two_columns_share_the_factors():
    graph, rows, columns, diagonal, right = parts()
    a = matrix(graph, rows, columns, diagonal)
    other = [graph.mul(b, b) for b in right]
    nodes = [k for x in graph.solve(a, [right, other], "ldl") for k in x]
    program = on_tape(graph, nodes, (6 * N, 0, 0))
    x = pendulum(np.random.default_rng(6), np.ones(N), np.ones(N))
    m, b = dense(x)
    expected = np.linalg.solve(m, np.column_stack([b, b**2])).T.ravel()
    for backend in BACKENDS.values():
        found, _ = evaluated(program, x[None], backend)
        np.testing.assert_allclose(found[0], expected, rtol=1e-9)


def test_the_c_code_of_the_cython_generator_agrees():
    x = np.array([pendulum(np.random.default_rng(7), np.ones(N), np.ones(N))])
    expected, _ = evaluated(solution(), x, None)
    found, _ = evaluated(solution(), x, CythonBackend())
    np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_what_does_not_separate_is_left_alone():
    graph = Graph()
    entries = [[graph.input("x", 9 * max(i, j) + min(i, j)) for j in range(9)] for i in range(9)]
    assert separate(graph, 9, [e for row in entries for e in row]) is None


def test_parts_that_rows_below_do_not_have_get_a_channel_of_their_own():
    graph, rows, columns, diagonal, _ = parts(5, 1)
    a = matrix(graph, rows, columns, diagonal)
    a[2][1] = a[1][2] = graph.add(a[1][2], graph.mul(diagonal[1], diagonal[2]))
    found = separate(graph, 5, [e for row in a for e in row])
    assert len(found.rows[0]) == 2
