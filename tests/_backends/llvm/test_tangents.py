"""Tangents whose columns, or states, lie side by side in vector registers."""

import pickle
import threading
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

import zoo
from _backends.llvm.test_guards import by_hand, states
from graphs import on_tape
from pydy._assembly.programs import jacobian_program
from pydy._backends.llvm.native import LLVMBackend, gates
from pydy._backends.registry import compile_program
from pydy._graph.columns import SensitivityColumns
from pydy._graph.derivative import jacobian
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._graph.tangent import jacobian_tangent
from pydy._program.interpret import run
from pydy._program.tangent import Tangent
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo.cases import system_of


@cache
def assembly_of(name):
    if name == "pendulum":
        system = n_link_pendulum_on_cart(4)
    elif name == "springs":
        system = multi_mass_spring_damper(9)
    else:
        system = system_of(getattr(zoo, name)())
    system.generate_ode_function()
    return system.model.assembly


def in_parts(assembly, parts):
    graph, nodes = assembly.simplified("rates")
    places = [("x", k) for k in range(assembly.sizes[0])]
    return jacobian_tangent(graph, nodes, places, assembly.sizes, parts)


def sample(assembly, m):
    n, s, c = assembly.sizes
    rng = np.random.default_rng(1)
    x, r = rng.uniform(0.3, 1.2, (m, n)), rng.uniform(size=(m, s))
    return np.linspace(0.1, 0.3, m), x, r, rng.uniform(0.5, 1.5, c)


# Every width on one model, one division of the columns on the others.
@pytest.mark.parametrize(
    ("name", "widths"),
    [
        *(("pendulum", widths) for widths in [(), (1,), (2,), (3,), (4,), (2, 5)]),
        *((name, (2, 5)) for name in ("fourbar", "disc", "lifted", "springs")),
    ],
)
def test_columns_side_by_side_are_those_of_the_whole(name, widths):
    assembly = assembly_of(name)
    n = assembly.sizes[0]
    cuts = [0, *(w for w in widths if w <= n - 2), n]
    parts = [*pairwise(cuts)]
    arguments = sample(assembly, 3)
    program = jacobian_program(assembly, "rates", "x")
    expected, _ = LLVMBackend().compile(program).evaluate(*arguments)
    found, failed = LLVMBackend().compile(in_parts(assembly, parts)).evaluate(*arguments)
    assert not failed.any()
    assert np.allclose(found, expected, rtol=1e-10, atol=1e-9)


def test_ctrl_c_comes_through_between_states_of_a_long_series(monkeypatch):
    assembly = assembly_of("pendulum")
    tangent = in_parts(assembly, [(0, 4), (4, assembly.sizes[0])])
    arguments = sample(assembly, 50)
    whole, _ = LLVMBackend().compile(tangent).evaluate(*arguments)
    monkeypatch.setattr("pydy._backends.llvm.native.SWEPT", 1)
    gate, calls = gates().sweep, []
    monkeypatch.setattr(gates(), "sweep", lambda *a: calls.append(1) or gate(*a))
    kernel = LLVMBackend().compile(tangent)
    parts, failed = kernel.evaluate(*arguments)
    monkeypatch.undo()
    assert len(calls) >= 50 // 8  # Python heeds signals wherever it does something
    assert not failed.any()
    np.testing.assert_array_equal(parts, whole)


def test_columns_of_no_part_are_zero():
    graph = Graph()
    x = [graph.input("x", k) for k in range(7)]
    nodes = [graph.mul(x[2], x[3]), graph.call("sin", x[2])]
    places = [("x", k) for k in range(7)]
    made = jacobian_tangent(graph, nodes, places, (7, 0, 0), [(2, 4)])
    at = np.arange(7.0)
    out = np.full((1, 14), np.nan)
    LLVMBackend().compile(made).evaluate(np.zeros(1), at[None], np.empty((1, 0)), np.zeros(0), out)
    expected = np.zeros((2, 7))
    expected[0, 2:4] = 3.0, 2.0
    expected[1, 2] = np.cos(2.0)
    assert np.array_equal(out.reshape(2, 7), expected)


def chain(n, kind):
    """The solution of a tridiagonal system by its diagonal and its right-hand side, in parts."""
    graph = Graph()
    rows = [[graph.zero] * n for _ in range(n)]
    for k in range(n):
        rows[k][k] = graph.input("x", k)
        if k:
            rows[k][k - 1] = rows[k - 1][k] = graph.input("p", 0)
    right = [graph.input("x", n + k) for k in range(n)]
    solution = LinearSystem(graph, rows, kind).solve(right)
    places = [("x", k) for k in range(2 * n)]
    parts = [(0, n), (n, 2 * n)]
    return jacobian_tangent(graph, solution, places, (2 * n, 0, 1), parts)


@pytest.mark.parametrize("kind", ["ldl", "lu"])
@pytest.mark.parametrize("n", [6, 9, 30])
def test_states_that_cannot_go_the_quick_way_are_solved_by_pivoting(n, kind):
    kernel = LLVMBackend().compile(chain(n, kind))
    rng = np.random.default_rng(n)
    p = np.array([1.0])
    x = np.column_stack([rng.uniform(3, 4, (12, n)), rng.normal(size=(12, n))])
    x[::3, :n] *= rng.choice([-1.0, 1.0], (4, n))  # no longer definite
    x[4, 3] = 0.0  # a pivot of zero
    x[8, 0] = 1e-30
    found, failed = kernel.evaluate(np.zeros(12), x, np.empty((12, 0)), p)
    assert not failed.any()
    for row, state in zip(found, x, strict=True):
        matrix = np.diag(state[:n]) + np.eye(n, k=1) + np.eye(n, k=-1)
        inverse = np.linalg.inv(matrix)
        # A(d) y = b: by d_k it is −A⁻¹ e_k y_k, by b the inverse.
        expected = np.hstack([-inverse * (inverse @ state[n:]), inverse])
        assert np.allclose(row.reshape(n, 2 * n), expected, rtol=1e-8, atol=1e-8)


@pytest.mark.parametrize("n", [3, 9])
def test_guarded_solutions_have_derivatives_in_parts_wherever_they_fall_back(n):
    graph, nodes, sizes = by_hand(n)
    _, entries, column, sound, fast = graph.args[graph.args[nodes[0]][0]]
    rows = [[*entries[k * n : k * n + n]] for k in range(n)]
    rows[0][1] = graph.call("kept", rows[0][1])  # not known to be symmetric, nor definite
    more = graph.call("atan", column[0])
    nodes = LinearSystem(graph, rows).guarded([more, *column[1:]], sound, [*fast])
    places = [("x", k) for k in range(3 * n)]
    made = jacobian_tangent(graph, nodes, places, sizes, [(0, n), (n, 3 * n)])
    # No call computes what only the fallback needs, for itself or for the columns.
    assert "atan" in made.shared.ops
    assert "atan" not in made.operation_count["run"]
    x, p = states(n)
    arguments = np.zeros(19), x, np.empty((19, 0)), p
    cells = jacobian(graph, nodes, [graph.input(*place) for place in places]).flat()
    expected, _ = run(on_tape(graph, cells, sizes), *arguments)
    # The others write all columns out, and C is written for any size alike.
    for generator in ("llvm", "lambdify", *(["cython"] if n == 3 else [])):
        found, failed = compile_program(made, generator, {}).evaluate(*arguments)
        assert not failed.any()
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-11)
    assert "atan" not in made.written_out().operation_count["run"]


def test_derivatives_by_a_definite_matrix_take_nothing_but_its_elimination():
    graph, nodes, sizes = by_hand(9)
    places = [("x", k) for k in range(27)]
    by = [graph.input(*place) for place in places]
    parts = [(0, 9), (9, 27)]
    made = jacobian_tangent(graph, nodes, places, sizes, parts)
    plain = graph.args[graph.args[nodes[0]][0]][4]
    bare = jacobian_tangent(graph, plain, places, sizes, parts)
    # The judgement of the matrix: itself, and what tells where it is sound.
    judged = on_tape(graph, nodes, sizes).num_operations
    assert made.num_operations <= bare.num_operations + judged + 2 * 27
    x, p = states(9)
    arguments = np.zeros(19), x, np.empty((19, 0)), p
    found, failed = LLVMBackend().compile(made).evaluate(*arguments)
    expected, _ = run(on_tape(graph, jacobian(graph, plain, by).flat(), sizes), *arguments)
    assert not failed.any()
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-11)
    x[4, :9] = -p[0]  # of an odd number of rows
    x[4, 18:] = 0.0
    _, failed = LLVMBackend().compile(made).evaluate(*arguments)
    assert np.flatnonzero(failed).tolist() == [4]


@pytest.mark.parametrize("n", [5, 29])
def test_a_singular_matrix_is_reported(n):
    kernel = LLVMBackend().compile(chain(n, "ldl"))
    x = np.full((3, 2 * n), 3.0)
    x[1, :n] = 0.0  # of an odd number of rows
    _, failed = kernel.evaluate(np.zeros(3), x, np.empty((3, 0)), np.array([1.0]))
    assert failed.tolist() == [False, True, False]


# -- seeds that follow the states, and several states at a time -----------------------------------


def beside(name, count):
    """The derivatives of states and of columns of sensitivities by time."""
    assembly = assembly_of(name)
    n, _, c = assembly.sizes
    directions = tuple(("p", (k // 2) % c) if k % 2 else None for k in range(count))
    columns = SensitivityColumns(n, directions)
    made = columns.tangent(*assembly.simplified("rates"), assembly.sizes, "rates")
    return assembly, columns, made


@pytest.mark.parametrize(
    ("name", "count"),
    [
        *(("pendulum", count) for count in (1, 2, 3, 4, 5, 6, 9)),
        *((name, 3) for name in ("fourbar", "disc", "lifted")),
    ],
)
def test_columns_beside_states_are_those_of_one_program_in_any_lanes(name, count):
    assembly, columns, made = beside(name, count)
    t, x, r, p = sample(assembly, 11)
    values = np.random.default_rng(2).normal(size=(11, columns.states, count))
    x = columns.together(x, values)
    expected, _ = LLVMBackend().compile(made.written_out()).evaluate(t, x, r, p)
    kernel = LLVMBackend().compile(made)
    found, failed = kernel.evaluate(t, x, r, p)
    assert not failed.any()
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9)
    assert (
        kernel.program.signature.num_outputs == kernel.program.signature.num_states == columns.size
    )
    out = np.empty(columns.size)
    assert kernel.at(x[0], t[0], r[0], p, out) == 0
    np.testing.assert_array_equal(out, found[0])
    for lanes in (2, 8):
        wide = LLVMBackend(lanes=lanes).compile(made)
        for order in "CF":
            several, failed = wide.evaluate(t, np.asarray(x, order=order), r, p)
            assert not failed.any()
            np.testing.assert_array_equal(several, found)


@pytest.mark.parametrize("name", ["disc", "pendulum"])
@pytest.mark.parametrize("lanes", [2, 4, 8])
def test_jacobians_of_several_states_have_the_bits_of_one(name, lanes):
    assembly = assembly_of(name)
    n = assembly.sizes[0]
    made = in_parts(assembly, [(1, n // 2), (n // 2, n)])
    arguments = sample(assembly, 11)
    expected = LLVMBackend().compile(made).evaluate(*arguments)[0]
    found, failed = LLVMBackend(lanes=lanes).compile(made).evaluate(*arguments)
    assert not failed.any()
    np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("lanes", [2, 8])
def test_of_several_states_the_singular_one_is_reported(lanes):
    kernel = LLVMBackend(lanes=lanes).compile(chain(9, "ldl"))
    x = np.full((11, 18), 3.0)
    x[7, :9] = 0.0
    _, failed = kernel.evaluate(np.zeros(11), x, np.empty((11, 0)), np.array([1.0]))
    assert np.flatnonzero(failed).tolist() == [7]


def test_a_kernel_is_pickled_as_what_it_was_made_of():
    assembly = assembly_of("pendulum")
    kernel = LLVMBackend().compile(in_parts(assembly, [(0, 5), (5, 10)]))
    again = pickle.loads(pickle.dumps(kernel))
    assert isinstance(again.program, Tangent)
    arguments = sample(assembly, 2)
    np.testing.assert_array_equal(kernel.evaluate(*arguments)[0], again.evaluate(*arguments)[0])


def test_threads_share_a_kernel():
    assembly = assembly_of("pendulum")
    kernel = LLVMBackend().compile(in_parts(assembly, [(0, 10)]))
    arguments = sample(assembly, 200)
    expected = kernel.evaluate(*arguments)[0]
    found = {}
    threads = [
        threading.Thread(target=lambda k=k: found.update({k: kernel.evaluate(*arguments)[0]}))
        for k in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for values in found.values():
        np.testing.assert_array_equal(values, expected)
    assert len(found) == 4
