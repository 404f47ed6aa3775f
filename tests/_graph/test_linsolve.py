"""Linear solves inside a Program: unrolled and in loops, interpreted and compiled."""

import numpy as np
import pytest

from graphs import on_tape, solve_program
from pydy._backends.llvm.native import LLVMBackend
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._program import OPERATIONS
from pydy._program.interpret import run

ENGINES = ["interpreted", "compiled"]
UNROLLED, LOOP = {}, {"off": frozenset({"ldl", "lu"})}
WAYS = {"unrolled ldl": ("ldl", UNROLLED), "ldl in a loop": ("ldl", LOOP), "lu": ("lu", UNROLLED)}


def solve(matrix, right, way, engine):
    """Solutions and failure flags for stacks of systems."""
    matrix, right = np.atleast_3d(np.asarray(matrix, float)), np.asarray(right, float)
    m, n = len(matrix), matrix.shape[-1]
    right = np.broadcast_to(right, (m, n))
    kind, options = WAYS[way]
    program = solve_program(n, kind, **options)
    x = np.ascontiguousarray(np.hstack([matrix.reshape(m, -1), right]))
    arguments = np.zeros(m), x, np.empty((1, 0)), np.empty(0)
    if engine == "interpreted":
        return run(program, *arguments)
    return LLVMBackend().compile(program).evaluate(*arguments)


def definite(rng, m, n):
    a = rng.normal(size=(m, n, n + 2))
    return a @ a.transpose(0, 2, 1)


def small(residual, matrix, x, right, times=64):
    """Backward error within a modest multiple of rounding: what a guard lets through."""
    n = matrix.shape[-1]
    scale = np.linalg.norm(matrix, axis=(1, 2)) * np.linalg.norm(x, axis=1)
    scale += np.linalg.norm(right, axis=1)
    assert (np.linalg.norm(residual, axis=1) <= times * n * 2.0**-53 * scale).all()


every_way = pytest.mark.parametrize("way", WAYS)
both_engines = pytest.mark.parametrize("engine", ENGINES)


@every_way
@both_engines
@pytest.mark.parametrize("n", [1, 2, 5, 9])
def test_definite_systems_are_solved_to_rounding(way, engine, n):
    rng = np.random.default_rng(n)
    matrix, right = definite(rng, 40, n), rng.normal(size=(40, n))
    x, failed = solve(matrix, right, way, engine)
    assert not failed.any()
    small((matrix @ x[:, :, None])[:, :, 0] - right, matrix, x, right)
    # The solution itself, as far as the conditioning lets it be known.
    expected = np.linalg.solve(matrix, right[:, :, None])[:, :, 0]
    limit = 100 * n * 2.0**-53 * np.linalg.cond(matrix) * np.linalg.norm(expected, axis=1)
    assert (np.linalg.norm(x - expected, axis=1) <= limit).all()


@every_way
@both_engines
@pytest.mark.parametrize("n", [2, 4, 7])
def test_indefinite_symmetric_systems_are_solved_to_rounding(way, engine, n):
    rng = np.random.default_rng(10 * n)
    matrix = rng.normal(size=(60, n, n))
    matrix = matrix + matrix.transpose(0, 2, 1)
    assert (np.linalg.eigvalsh(matrix)[:, 0] < 0).any()
    right = rng.normal(size=(60, n))
    x, failed = solve(matrix, right, way, engine)
    assert not failed.any()
    small((matrix @ x[:, :, None])[:, :, 0] - right, matrix, x, right)


@both_engines
@pytest.mark.parametrize("n", [2, 5, 11])
def test_general_systems_are_solved_to_rounding(engine, n):
    rng = np.random.default_rng(n)
    matrix, right = rng.normal(size=(50, n, n)), rng.normal(size=(50, n))
    x, failed = solve(matrix, right, "lu", engine)
    assert not failed.any()
    small((matrix @ x[:, :, None])[:, :, 0] - right, matrix, x, right)


@every_way
@both_engines
@pytest.mark.parametrize(
    "matrix",
    [[[0, 1], [1, 0]], [[0, 2, 1], [2, 0, 3], [1, 3, 0]], [[1, 1, 0], [1, 1, 1], [0, 1, 1]]],
    ids=["swap", "zero diagonal", "zero second pivot"],
)
def test_a_zero_pivot_is_no_obstacle(way, engine, matrix):
    expected = np.arange(1.0, len(matrix) + 1)
    x, failed = solve([matrix], np.array(matrix, float) @ expected, way, engine)
    assert not failed[0]
    np.testing.assert_allclose(x[0], expected, rtol=1e-14)


SINGULAR = {
    "zero": np.zeros((2, 2)),
    "rank one": np.outer([1.0, 2.0, -3.0], [1.0, 2.0, -3.0]),
    "rank two": np.array([[1.0, 2, 3], [2, 5, 8], [3, 8, 13]]),
    "zero row": np.array([[2.0, 0, 1], [0, 0, 0], [1, 0, 3]]),
    "singular to rounding": np.array([[1.0, 1 / 3], [1 / 3, 1 / 9 * (1 + 2.0**-53)]]),
    "scaled down": 1e-200 * np.outer([1.0, 2.0], [1.0, 2.0]),
    "scaled up": 1e200 * np.outer([1.0, 2.0], [1.0, 2.0]),
}


@every_way
@both_engines
@pytest.mark.parametrize("name", SINGULAR)
def test_a_singular_system_is_flagged_and_gives_nan(way, engine, name):
    matrix = SINGULAR[name]
    x, failed = solve([matrix], np.ones(len(matrix)), way, engine)
    assert failed.tolist() == [True]
    assert np.isnan(x).all()


@every_way
@both_engines
def test_a_singular_system_is_flagged_even_when_it_has_solutions(way, engine):
    x, failed = solve([[[1.0, 1.0], [1.0, 1.0]]], [2.0, 2.0], way, engine)
    assert failed.tolist() == [True]
    assert np.isnan(x).all()


@every_way
@both_engines
def test_a_singular_system_leaves_its_neighbours_untouched(way, engine):
    rng = np.random.default_rng(3)
    matrix, right = definite(rng, 9, 3), rng.normal(size=(9, 3))
    matrix[[2, 7]] = SINGULAR["rank two"]
    x, failed = solve(matrix, right, way, engine)
    assert np.flatnonzero(failed).tolist() == [2, 7]
    for k in np.flatnonzero(~failed):
        np.testing.assert_array_equal(x[k], solve(matrix[k : k + 1], right[k], way, engine)[0][0])


NAN_MATRICES = {
    "first": [[np.nan, 0], [0, 2]],
    "last": [[2, 0], [0, np.nan]],
    "coupled": [[np.nan, 1], [1, 2]],
    "off the diagonal": [[2, np.nan], [np.nan, 2]],
    "everywhere": [[np.nan, np.nan], [np.nan, np.nan]],
}


def nan_comes_out(name, way, engine):
    x, failed = solve([NAN_MATRICES[name]], [1.0, 1.0], way, engine)
    assert failed.tolist() == [False]
    wanted = [0] if name == "first" else [1] if name == "last" else [0, 1]
    assert np.isnan(x[0, wanted]).all()


@every_way
@pytest.mark.parametrize("name", NAN_MATRICES)
def test_a_nan_in_the_matrix_is_not_a_failure_and_comes_out_as_nan(way, name):
    nan_comes_out(name, way, "compiled")


@every_way
@pytest.mark.parametrize("name", [n for n in NAN_MATRICES if n != "coupled"])
def test_a_nan_in_the_matrix_comes_out_of_the_interpreter_as_nan(way, name):
    nan_comes_out(name, way, "interpreted")


@every_way
def test_a_nan_in_the_matrix_reaches_every_unknown_that_depends_on_it(way):
    nan_comes_out("coupled", way, "interpreted")


@every_way
def test_the_interpreter_does_not_raise_for_a_nan_beside_a_zero(way):
    x, _ = solve([[[np.nan, 0], [0, 0]]], [1.0, 1.0], way, "interpreted")
    assert np.isnan(x).any()


@every_way
@both_engines
def test_a_nan_on_the_right_is_not_a_failure(way, engine):
    x, failed = solve([[[2.0, 1.0], [1.0, 2.0]]], [np.nan, 1.0], way, engine)
    assert failed.tolist() == [False]
    assert np.isnan(x).all()


@every_way
@both_engines
@pytest.mark.parametrize(
    "diagonal", [[1e12, 1e-12], [1e-150, 1e150], [1e-12, 1.0, 1e12], [3e-200]], ids=str
)
def test_units_do_not_make_a_matrix_singular(way, engine, diagonal):
    x, failed = solve([np.diag(diagonal)], np.ones(len(diagonal)), way, engine)
    assert not failed[0]
    np.testing.assert_allclose(x[0], 1 / np.array(diagonal), rtol=1e-15)


@every_way
@both_engines
@pytest.mark.parametrize("power", [-40, 40])
def test_scaling_rows_and_columns_by_powers_of_two_scales_the_solution_exactly(way, engine, power):
    rng = np.random.default_rng(8)
    matrix, right = definite(rng, 5, 4), rng.normal(size=(5, 4))
    scale = 2.0 ** (power * np.array([0, 1, -1, 2]))
    x, _ = solve(matrix, right, way, engine)
    y, failed = solve(matrix * scale[:, None] * scale, right * scale, way, engine)
    assert not failed.any()
    np.testing.assert_allclose(y * scale, x, rtol=1e-12)


@both_engines
@pytest.mark.parametrize("column", range(4))
def test_the_guard_does_not_depend_on_the_units_of_an_unknown(engine, column):
    # A residual that is small beside the largest unknown may be all of another one.
    rng = np.random.default_rng(5)
    n = 4
    matrix, right = rng.normal(size=(4000, n, n)), rng.normal(size=(4000, n))
    matrix[:, :, column] *= 2.0**20
    x, failed = solve(matrix, right, "lu", engine)
    assert not failed.any()
    residual = (matrix @ x[:, :, None])[:, :, 0] - right
    scale = (np.abs(matrix) @ np.abs(x)[:, :, None])[:, :, 0] + np.abs(right)
    assert (np.abs(residual) <= 64 * n * 2.0**-53 * scale).all()


@every_way
@both_engines
def test_several_right_hand_sides_share_one_factorisation(way, engine):
    kind, options = WAYS[way]
    program = solve_program(3, kind, columns=2, **options)
    rng = np.random.default_rng(5)
    matrix, right = definite(rng, 1, 3)[0], rng.normal(size=(2, 3))
    x = np.concatenate([matrix.ravel(), right.ravel()])[None]
    arguments = np.zeros(1), x, np.empty((1, 0)), np.empty(0)
    out, _ = (
        run(program, *arguments)
        if engine == "interpreted"
        else (LLVMBackend().compile(program).evaluate(*arguments))
    )
    np.testing.assert_allclose(out.reshape(2, 3), np.linalg.solve(matrix, right.T).T, rtol=1e-12)
    assert program.ops.count("factor") <= 1


@both_engines
@pytest.mark.parametrize("first", [np.zeros(3), np.array([1.0, -2.0, 0.5])])
def test_later_right_hand_sides_are_solved_to_rounding_where_the_chosen_pivots_are_bad(
    engine, first
):
    program = solve_program(3, "lu", columns=3)
    rng = np.random.default_rng(2)
    matrix = rng.normal(size=(200, 3, 3))
    k = np.arange(100)
    matrix[k, k % 3, k // 3 % 3] = 10.0 ** -rng.uniform(3, 16, 100)
    right = np.concatenate([np.broadcast_to(first, (200, 1, 3)), rng.normal(size=(200, 2, 3))], 1)
    x = np.hstack([matrix.reshape(200, -1), right.reshape(200, -1)])
    arguments = np.zeros(200), x, np.empty((1, 0)), np.empty(0)
    engine_of = {"interpreted": run, "compiled": LLVMBackend().compile(program).evaluate}
    call = engine_of[engine]
    out, failed = call(program, *arguments) if engine == "interpreted" else call(*arguments)
    assert not failed.any()
    for column in (1, 2):
        found = out.reshape(200, 3, 3)[:, column]
        residual = np.einsum("mij,mj->mi", matrix, found) - right[:, column]
        small(residual, matrix, found, right[:, column], times=2000)


@both_engines
@pytest.mark.parametrize(
    "way",
    [
        "unrolled ldl",
        "ldl in a loop",
    ],
)
def test_the_upper_triangle_of_a_definite_system_is_not_read(way, engine):
    x, failed = solve([[[2.0, 100.0], [1.0, 3.0]]], [1.0, 1.0], way, engine)
    assert not failed[0]
    np.testing.assert_allclose(x[0], [0.4, 0.2], rtol=1e-15)


# -- structure ------------------------------------------------------------------------------------


def tridiagonal(n):
    """Operations at every call of an LDLᵀ solve with a tridiagonal matrix."""
    graph = Graph()
    cell = {}
    for i in range(n):
        cell[i, i] = graph.input("x", i)
        if i:
            cell[i, i - 1] = cell[i - 1, i] = graph.input("x", n + i)
    rows = [[cell.get((i, j), graph.zero) for j in range(n)] for i in range(n)]
    x = LinearSystem(graph, rows, "ldl").solve([graph.input("x", 2 * n + i) for i in range(n)])
    program = on_tape(graph, x, (3 * n, 0, 0))
    return program.operation_count["run"].total()


def test_zeros_of_the_structure_cost_nothing():
    a, b, c = tridiagonal(6), tridiagonal(12), tridiagonal(18)
    assert b - a == c - b  # the cost of one more row is flat
    assert c <= 18 * 12


def test_a_diagonal_matrix_costs_one_division_and_one_product_a_row():
    graph = Graph()
    n = 5
    rows = [[graph.input("x", i) if i == j else graph.zero for j in range(n)] for i in range(n)]
    x = LinearSystem(graph, rows, "ldl").solve([graph.input("x", n + i) for i in range(n)])
    count = on_tape(graph, x, (2 * n, 0, 0)).operation_count["run"]
    assert (count["div"], count["mul"], count["add"]) == (n, n, 0)


def longest_chain(program):
    """How many operations on the way to the solution wait for one another."""
    lengths = []
    for op, args in zip(program.ops, program.args, strict=True):
        operands = {"guard": lambda a: a[4], "item": lambda a: a[:1]}.get(
            op, lambda a, op=op: OPERATIONS.operands(op, a)
        )(args)
        counts = op not in ("input", "const", "bool", "item", "guard")
        lengths.append(max((lengths[k] for k in operands), default=0) + counts)
    return max(lengths[k] for k in program.outputs)


@pytest.mark.parametrize(("kind", "each"), [("ldl", 6), ("lu", 7)])
def test_one_more_unknown_makes_the_longest_chain_of_a_solve_no_longer_than_its_own_steps(
    kind, each
):
    # Reciprocal, quotient, and product and difference in the elimination; product and difference
    # in the substitution back, and with LU a product with the reciprocal.
    chains = [longest_chain(solve_program(n, kind)) for n in range(2, 9)]
    np.testing.assert_array_equal(np.diff(chains), each)


def test_a_definite_matrix_of_constants_is_factorised_once():
    graph = Graph()
    n = 4
    cell = [[graph.input("p", max(i, j) * n + min(i, j)) for j in range(n)] for i in range(n)]
    x = LinearSystem(graph, cell, "ldl").solve([graph.input("x", i) for i in range(n)])
    program = on_tape(graph, x, (n, 0, n * n))
    assert program.operation_count["run"].get("div", 0) == 0
    assert program.operation_count["setup"]["div"] == n


def test_a_block_that_is_diagonal_and_constant_goes_first():
    """The last body of a chain, with its angular velocity as speeds: three of nine unknowns."""
    graph = Graph()
    n, last = 9, 6

    def cell(i, j):
        if j >= last:
            return graph.input("p", i) if i == j else graph.zero
        return graph.input("x", i * n + j)

    rows = [[cell(max(i, j), min(i, j)) for j in range(n)] for i in range(n)]
    x = LinearSystem(graph, rows, "ldl").solve([graph.input("x", n * n + i) for i in range(n)])
    program = on_tape(graph, x, (n * n + n, 0, n))
    count = program.operation_count["run"]
    assert count["div"] == last  # the others are divided by once per binding
    assert count["mul"] <= 212  # 242 in the given order

    rng = np.random.default_rng(2)
    matrix = np.diag(rng.uniform(2.0, 3.0, n))
    matrix[:last, :last] += definite(rng, 1, last)[0]
    matrix[last:, :last] = rng.normal(0.0, 0.3, (n - last, last))
    matrix[:last, last:] = matrix[last:, :last].T
    right = rng.normal(size=n)
    state = np.concatenate([matrix.ravel(), right])[None]
    found, failed = run(program, np.zeros(1), state, np.empty((1, 0)), matrix.diagonal().copy())
    assert not failed[0]
    np.testing.assert_allclose(found[0], np.linalg.solve(matrix, right), rtol=1e-12)


@both_engines
def test_a_triangular_system_needs_no_check_of_its_residual(engine):
    graph = Graph()
    cells = [graph.input("x", k) for k in range(10)]
    (a, b, c, d, e, f), right = cells[:6], cells[6:9]
    zero = graph.zero
    # Triangular once rows and columns are ordered.
    matrix = [[b, c, zero], [d, e, f], [a, zero, zero]]
    solution = LinearSystem(graph, matrix).solve(right)
    program = on_tape(graph, solution, (10, 0, 0))
    assert "le" not in program.operation_count["run"]
    x = np.random.default_rng(5).normal(size=(200, 10))
    x[0, 0] = 0.0
    arguments = np.zeros(200), x, np.empty((1, 0)), np.empty(0)
    evaluate = run if engine == "interpreted" else LLVMBackend().compile(program).evaluate
    found, failed = evaluate(*(arguments if engine != "interpreted" else (program, *arguments)))
    assert failed.nonzero()[0].tolist() == [0]
    whole = np.zeros((200, 3, 3))
    whole[:, 0, 0], whole[:, 0, 1], whole[:, 2, 0] = x[:, 1], x[:, 2], x[:, 0]
    whole[:, 1] = x[:, 3:6]
    residual = (whole @ found[:, :, None])[:, :, 0] - x[:, 6:9]
    small(residual[1:], whole[1:], found[1:], x[1:, 6:9])
