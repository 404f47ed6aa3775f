"""Derivatives of the graph against SymPy's derivatives and 60-digit differences."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from graphs import BINARY, UNARY, P, X, derivatives, nodes_of, on_tape, values
from pydy._backends.llvm.native import LLVMBackend
from pydy._graph.adjoint import adjoints
from pydy._graph.derivative import jacobian
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph

LOOP = frozenset({"ldl", "lu"})

x, y, z, w = X


def structure(*expressions):
    """Which derivatives are there."""
    graph, nodes = nodes_of(expressions)
    return [sorted(row) for row in jacobian(graph, nodes, [graph.input("x", k) for k in range(4)])]


# -- every operation ------------------------------------------------------------------------------

POINTS = {
    "acosh": [1.5, 30.0],
    "sqrt": [0.01, 2.0, 1e6],
    "log": [0.01, 2.0, 1e6],
    "asin": [-0.75, 0.0, 0.3],
    "acos": [-0.75, 0.0, 0.3],
    "atanh": [-0.75, 0.0, 0.3],
    "floor": [-1.5, 0.5, 2.25],
    "ceil": [-1.5, 0.5, 2.25],
    "abs": [-1.5, 2.25],
    "sign": [-1.5, 2.25],
}
MPMATH = {"abs": mp.fabs, "kept": mp.mpf}


def slope(function, at):
    """Central difference in 60 digits."""
    with mp.workdps(60):
        at, h = mp.mpf(at), mp.mpf(10) ** -20
        return float((function(at + h) - function(at - h)) / (2 * h))


@pytest.mark.parametrize("op", sorted(UNARY))
def test_the_derivative_of_a_function_is_its_slope(op):
    function = MPMATH.get(op) or getattr(mp, op)
    for at in POINTS.get(op, [-1.25, -0.3, 0.0, 0.7, 2.0]):
        graph = Graph()
        variable = graph.input("x", 0)
        (row,) = jacobian(graph, [graph.call(op, variable)], [variable])
        found = values(on_tape(graph, [row.get(0, graph.zero)], (1, 0, 0)), [at])[0]
        assert found == pytest.approx(slope(function, at), rel=2e-15, abs=1e-30), at


PAIRS = {
    "pow": [(0.3, -1.7), (2.5, 0.4), (1.0, 3.0)],
    "atan2": [(0.3, -1.7), (-0.3, -1.7), (2.5, 0.4), (-1.0, 0.0)],
    "min": [(0.3, 1.7), (1.7, 0.3)],
    "max": [(0.3, 1.7), (1.7, 0.3)],
}
FUNCTIONS = {"pow": mp.power, "atan2": mp.atan2, "min": min, "max": max}


@pytest.mark.parametrize("op", sorted(BINARY))
def test_the_derivatives_of_a_function_of_two_arguments_are_its_slopes(op):
    function = FUNCTIONS[op]
    for a, b in PAIRS[op]:
        graph = Graph()
        pair = [graph.input("x", 0), graph.input("x", 1)]
        (row,) = jacobian(graph, [graph.call(op, *pair)], pair)
        cells = [row.get(k, graph.zero) for k in range(2)]
        found = values(on_tape(graph, cells, (2, 0, 0)), [a, b])
        by_a = slope(lambda v, b=b: function(v, mp.mpf(b)), a)
        by_b = slope(lambda v, a=a: function(mp.mpf(a), v), b)
        assert found[0] == pytest.approx(by_a, rel=2e-15, abs=1e-30)
        assert found[1] == pytest.approx(by_b, rel=2e-15, abs=1e-30)


@pytest.mark.parametrize(
    "expression",
    [
        3 * x - 2 * y + 5 - x,
        x * y * z / w,
        x**3 * y**-2,
        (x + y) ** 5 * (z - w) ** -1,
        sm.sqrt(x * y) ** 3,
        x ** sm.Rational(-3, 2),
        x**70,
        x**y,
        2**x,
        sm.sin(x * y) ** 2 / (1 + sm.cos(z)) ** 3,
        sm.exp(-x * sm.log(y)) * sm.tanh(z),
        sm.atan2(x * y, z + w),
        sm.sin(sm.sin(sm.sin(x + y))),
        sm.sec(x) + sm.cot(y) + sm.csch(z) + sm.acoth(3 + w),
        sm.sqrt(x**2 + y**2 + z**2),
    ],
    ids=str,
)
def test_derivatives_of_an_expression_are_what_sympy_derives(expression):
    point = (0.7, 1.3, 0.4, 1.9)
    exact = {s: sm.Rational(v) for s, v in zip(X, point, strict=True)}
    expected = [float(expression.diff(v).subs(exact).evalf(40)) for v in X]
    found = derivatives([expression], *point)[0]
    np.testing.assert_allclose(found, expected, rtol=3e-14, atol=1e-16)


def test_a_derivative_with_respect_to_constants_is_taken_too():
    graph, nodes = nodes_of([P[0] * sm.sin(P[1] * x)])
    (row,) = jacobian(graph, nodes, [graph.input("p", k) for k in range(3)])
    assert sorted(row) == [0, 1]
    found = values(on_tape(graph, [row[0], row[1]]), [0.5, 0, 0, 0], [2.0, 3.0, 0.0])
    np.testing.assert_allclose(found, [np.sin(1.5), np.cos(1.5)], rtol=1e-15)


def test_a_variable_has_derivative_one():
    np.testing.assert_array_equal(derivatives(list(X), 0.1, 0.2, 0.3, 0.4), np.eye(4))


def test_second_derivatives_come_from_differentiating_twice():
    graph, nodes = nodes_of([sm.sin(x) * y**3])
    variables = [graph.input("x", k) for k in range(2)]
    (first,) = jacobian(graph, nodes, variables)
    second = jacobian(graph, [first[0], first[1]], variables)
    cells = [second[i][j] for i in range(2) for j in range(2)]
    found = values(on_tape(graph, cells), [0.4, 1.2, 0, 0]).reshape(2, 2)
    s, c = np.sin(0.4), np.cos(0.4)
    expected = [[-s * 1.2**3, 3 * c * 1.2**2], [3 * c * 1.2**2, 6 * s * 1.2]]
    np.testing.assert_allclose(found, expected, rtol=1e-14)


# -- switches -------------------------------------------------------------------------------------

PIECES = sm.Piecewise((x**2 * y, x < 1), (sm.sin(x), True))


@pytest.mark.parametrize(
    ("at", "expected"), [(0.5, [1.0 * 3, 0.25]), (1.0, [np.cos(1.0), 0]), (2.0, [np.cos(2.0), 0])]
)
def test_a_piecewise_has_the_derivative_of_the_piece_that_is_taken(at, expected):
    found = derivatives([PIECES], at, 3.0, variables=(x, y))[0]
    np.testing.assert_allclose(found, expected, rtol=1e-15)


def test_a_piece_that_is_not_taken_does_not_spoil_the_derivative():
    expression = sm.Piecewise((0, x <= 0), (sm.sqrt(x), True))
    assert derivatives([expression], 0.0, variables=(x,))[0, 0] == 0.0


def test_the_derivative_at_the_corner_of_an_absolute_value_is_that_of_the_positive_side():
    assert derivatives([sm.Abs(x)], 0.0, variables=(x,))[0, 0] == 1.0


def test_a_power_with_zero_base_has_no_logarithm_in_its_derivative():
    found = derivatives([x**y], 0.0, 3.0, variables=(x, y))[0]
    np.testing.assert_array_equal(found, [0.0, 0.0])


def test_a_product_with_a_zero_factor_has_a_derivative():
    found = derivatives([x * y * z], 0.0, 2.0, 5.0, variables=(x, y, z))[0]
    np.testing.assert_array_equal(found, [10.0, 0.0, 0.0])


# -- structure ------------------------------------------------------------------------------------


def test_a_variable_that_does_not_occur_is_missing():
    assert structure(sm.sin(x) * z, y + 3, sm.Integer(2)) == [[0, 2], [1], []]


@pytest.mark.parametrize("step", [sm.floor(x), sm.ceiling(x), sm.sign(x)], ids=str)
def test_a_step_has_no_derivative_by_structure(step):
    assert structure(step, step * y) == [[], [1]]


def test_a_derivative_that_cancels_is_missing():
    assert structure(sm.Add(x * y, -y * x, z, evaluate=False)) == [[2]]


def test_the_condition_of_a_piecewise_is_not_differentiated():
    assert structure(sm.Piecewise((y, x < w), (z, True))) == [[1, 2]]


def test_a_jacobian_keeps_the_order_of_its_variables():
    graph, nodes = nodes_of([x + 2 * y + 3 * z])
    order = [graph.input("x", k) for k in (2, 0, 1)]
    (row,) = jacobian(graph, nodes, order)
    assert [graph.value(row[k]) for k in range(3)] == [3.0, 1.0, 2.0]


# -- the implicit rule ----------------------------------------------------------------------------

SYMMETRIC = sm.Matrix(
    [
        [3 + x**2, sm.sin(y), x * z / 5],
        [sm.sin(y), 4 + sm.cos(x), y / 3],
        [x * z / 5, y / 3, 5 + sm.exp(-z)],
    ]
)
GENERAL = sm.Matrix([[x, 3 + y**2, 1], [4 + z, x * y, sm.sin(z)], [y, sm.Rational(1, 2), 5 - x]])
RIGHT = sm.Matrix([sm.cos(x), y * z, w - x])


def solved(matrix, kind, columns):
    graph, nodes = nodes_of([*matrix, *columns])
    rows = [nodes[3 * i : 3 * i + 3] for i in range(3)]
    right = [nodes[9 + 3 * k : 12 + 3 * k] for k in range(len(columns) // 3)]
    return graph, [n for column in right for n in LinearSystem(graph, rows, kind).solve(column)]


@pytest.mark.parametrize(
    ("kind", "matrix", "off"),
    [
        ("ldl", SYMMETRIC, ()),
        ("ldl", SYMMETRIC, LOOP),
        ("lu", SYMMETRIC, ()),
        ("lu", GENERAL, ()),
        ("ldl", SYMMETRIC - 8 * sm.eye(3), ()),
    ],
    ids=["ldl", "ldl in a loop", "lu", "lu that pivots", "ldl that falls back"],
)
@pytest.mark.parametrize("backend", [None, LLVMBackend()], ids=["interpreted", "compiled"])
def test_the_derivative_of_a_solve_is_that_of_the_solution(kind, matrix, off, backend):
    point = (0.6, -0.4, 0.8, 1.1)
    exact = {s: sm.Rational(v) for s, v in zip(X, point, strict=True)}
    inverse = matrix.subs(exact).evalf(40).inv()
    solution = inverse * RIGHT.subs(exact).evalf(40)
    columns = [
        inverse * (RIGHT.diff(v).subs(exact) - matrix.diff(v).subs(exact) * solution).evalf(40)
        for v in X
    ]
    expected = np.array(sm.Matrix.hstack(*columns), dtype=float)
    graph, nodes = solved(matrix, kind, RIGHT)
    graph.off = off
    rows = jacobian(graph, nodes, [graph.input("x", k) for k in range(4)])
    program = on_tape(graph, [row.get(k, graph.zero) for row in rows for k in range(4)])
    kernel = None if backend is None else backend.compile(program)
    found = values(program, point, kernel=kernel).reshape(3, 4)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-14 * np.abs(expected).max())


def test_the_derivative_of_a_solve_uses_the_factors_that_exist():
    graph, nodes = solved(GENERAL, "lu", RIGHT)
    graph.off = LOOP
    rows = jacobian(graph, nodes, [graph.input("x", k) for k in range(4)])
    cells = [d for row in rows for d in row.values()]
    program = on_tape(graph, [*nodes, *cells])
    assert program.ops.count("factor") == 1


def test_a_solve_that_does_not_hold_a_variable_has_no_derivative_to_it():
    graph, nodes = solved(SYMMETRIC.subs(z, 1), "lu", RIGHT.subs(z, 2))
    rows = jacobian(graph, nodes, [graph.input("x", k) for k in range(4)])
    assert [sorted(row) for row in rows] == [[0, 1, 3]] * 3


def test_the_upper_triangle_of_a_definite_matrix_has_no_influence():
    spoiled = SYMMETRIC.copy()
    spoiled[0, 2] = 1000 * w
    found = []
    for matrix in (SYMMETRIC, spoiled):
        graph, nodes = solved(matrix, "ldl", RIGHT)
        rows = jacobian(graph, nodes, [graph.input("x", k) for k in range(4)])
        program = on_tape(graph, [row.get(k, graph.zero) for row in rows for k in range(4)])
        found.append(values(program, [0.6, -0.4, 0.8, 1.1]))
    np.testing.assert_array_equal(found[0], found[1])


# -- depth ----------------------------------------------------------------------------------------


def test_the_derivative_of_a_thousand_nested_functions_is_a_product_of_slopes():
    depth = 1_000
    graph = Graph()
    variable = node = graph.input("x", 0)
    for _ in range(depth):
        node = graph.call("sin", node)
    (row,) = jacobian(graph, [node], [variable])
    expected, at = 1.0, 0.3
    for _ in range(depth):
        expected, at = expected * np.cos(at), np.sin(at)
    found = values(on_tape(graph, [row[0]], (1, 0, 0)), [0.3])[0]
    assert found == pytest.approx(expected, rel=1e-12)


def test_twenty_thousand_nested_choices_are_differentiated():
    graph = Graph()
    variable = node = graph.input("x", 0)
    other = graph.input("x", 1)
    for k in range(20_000):
        condition = graph.call("lt", node, graph.const(1e6))
        node = graph.add(graph.call("select", condition, node, other), graph.const(k * 1e-6))
    (row,) = jacobian(graph, [node], [variable, other])
    cells = [row[0], row[1]]
    assert values(on_tape(graph, cells, (2, 0, 0)), [0.3, 0.5]).tolist() == [1.0, 0.0]


# -- a Piecewise without a branch -----------------------------------------------------------------


def test_where_no_branch_is_taken_derivatives_are_nan_by_either_way():
    inner = sm.Piecewise((y**2, y > 0))
    nested = sm.Piecewise((x**2, x > 1), (y**3, y > 0))
    behind = sm.Piecewise((3 * x, x > 1), (inner + x, True))
    graph, nodes = nodes_of([sm.Piecewise((x**2, x > 1)), nested, behind])
    variables = [graph.input("x", k) for k in range(2)]
    forward = jacobian(graph, nodes, variables).flat()
    weights = [[graph.const(float(i == k)) for k in range(3)] for i in range(3)]
    backward = [bar for row in weights for bar in adjoints(graph, nodes, row, variables)]
    nan = np.nan
    for point, expected in (
        ((2.0, 3.0), [4, 0, 4, 0, 3, 0]),
        ((0.5, 3.0), [nan, 0, 0, 27, 1, 6]),
        ((2.0, -3.0), [4, 0, 4, 0, 3, 0]),
        ((0.5, -3.0), [nan, 0, nan, nan, 1, nan]),
    ):
        for cells in (forward, backward):
            assert values(on_tape(graph, cells, (2, 0, 0)), point) == pytest.approx(
                expected, nan_ok=True
            )


def test_a_table_without_a_last_branch_is_differentiated_in_as_many_operations_as_it_has_rows():
    counts = []
    for rows in (50, 100):
        graph, nodes = nodes_of([sm.Piecewise(*((k * X[0] ** 2, X[0] < k) for k in range(rows)))])
        variable = graph.input("x", 0)
        adjoint = adjoints(graph, nodes, [graph.one], [variable])
        counts.append(
            [len(graph.reachable(n)) for n in (adjoint, jacobian(graph, nodes, [variable]).flat())]
        )
    assert np.all(np.array(counts[1]) < 2.2 * np.array(counts[0]))
