"""Reverse accumulation against forward derivatives and 60-digit differences."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from graphs import BINARY, UNARY, P, X, nodes_of, on_tape, values
from pydy._graph.adjoint import adjoints
from pydy._graph.derivative import jacobian
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._graph.products import KINDS, derivative_program

x, y, z, w = X
POINT = (0.7, 1.3, 0.4, 1.9)


def both(graph, nodes, variables, point, p=(), weights=None):
    """Σ weight · derivative by either way."""
    weights = np.arange(1.0, len(nodes) + 1) if weights is None else weights
    backward = adjoints(graph, nodes, [graph.const(v) for v in weights], variables)
    rows = jacobian(graph, nodes, variables)
    forward = [row.get(k, graph.zero) for row in rows for k in range(len(variables))]
    k = len(variables)
    found = values(on_tape(graph, [*backward, *forward]), point, p)
    return found[:k], weights @ found[k:].reshape(-1, k)


def states(graph):
    return [graph.input("x", k) for k in range(4)]


@pytest.mark.parametrize("op", sorted(set(UNARY) - {"acosh"}))
def test_the_adjoint_of_a_function_is_its_derivative(op):
    graph = Graph()
    nodes = [graph.call(op, graph.input("x", 2))]
    backward, forward = both(graph, nodes, states(graph), POINT)
    np.testing.assert_array_equal(backward, forward)


@pytest.mark.parametrize("op", sorted(BINARY))
def test_the_adjoints_of_a_function_of_two_arguments_are_its_derivatives(op):
    graph = Graph()
    nodes = [graph.call(op, graph.input("x", 0), graph.input("x", 3))]
    backward, forward = both(graph, nodes, states(graph), POINT)
    np.testing.assert_array_equal(backward, forward)


def test_backward_is_forward_for_expressions():
    expressions = [
        3 * x - 2 * y + 5 - x,
        x**3 * y**-2 / (z + w) ** 5,
        sm.sin(x * y) ** 2 / (1 + sm.cos(z)) ** 3 + P[0] * w,
        sm.Piecewise((x**2 * y, z < 1), (sm.sin(x), True)),
        sm.Max(x, y) * sm.Abs(z - w),
        x,
        x,
    ]
    graph, nodes = nodes_of(expressions)
    backward, forward = both(graph, nodes, states(graph), POINT, (2.0, 0.0, 0.0))
    np.testing.assert_allclose(backward, forward, rtol=1e-14)


@pytest.mark.parametrize("kind", ["ldl", "lu"])
def test_backward_is_forward_through_a_linear_solve(kind):
    graph, cells = nodes_of([4 + x, x * y, x * y, 5 + y * z, sm.sin(w), x + w])
    if kind == "lu":
        cells[1] = nodes_of([y - z], graph)[1][0]
    matrix = [cells[:2], cells[2:4]]
    solution = LinearSystem(graph, matrix, kind).solve(cells[4:])
    nodes = [graph.mul(solution[0], graph.input("x", 0)), solution[1]]
    backward, forward = both(graph, nodes, states(graph), POINT)
    np.testing.assert_allclose(backward, forward, rtol=1e-13)


def test_backward_is_forward_through_a_guarded_solve():
    graph, (a, b, c, f) = nodes_of([4 + x, x * y, 5 + y * z, sm.sin(w)])
    matrix, column = [[a, b], [b, c]], [f, a]
    determinant = graph.sub(graph.mul(a, c), graph.mul(b, b))
    fast = [
        graph.div(graph.sub(graph.mul(c, f), graph.mul(b, a)), determinant),
        graph.div(graph.sub(graph.mul(a, a), graph.mul(b, f)), determinant),
    ]
    nodes = LinearSystem(graph, matrix).guarded(
        column, graph.call("lt", graph.zero, determinant), fast
    )
    backward, forward = both(graph, nodes, states(graph), POINT)
    np.testing.assert_allclose(backward, forward, rtol=1e-13)


def test_a_gradient_through_a_solve_is_that_of_60_digit_differences():
    graph, cells = nodes_of([4 + x, x * y, x * y, 5 + y * z, sm.sin(w), x + w])
    solution = LinearSystem(graph, [cells[:2], cells[2:4]], "ldl").solve(cells[4:])
    backward = adjoints(graph, solution, [graph.const(2.0), graph.const(-3.0)], states(graph))

    def exact(*at):
        a, b, c, d = at
        A = mp.matrix([[4 + a, a * b], [a * b, 5 + b * c]])
        s = mp.lu_solve(A, mp.matrix([mp.sin(d), a + d]))
        return 2 * s[0] - 3 * s[1]

    with mp.workdps(60):
        h = mp.mpf(10) ** -20
        at = [mp.mpf(v) for v in POINT]
        expected = []
        for k in range(4):
            ahead, behind = list(at), list(at)
            ahead[k] += h
            behind[k] -= h
            expected.append(float((exact(*ahead) - exact(*behind)) / (2 * h)))
    np.testing.assert_allclose(values(on_tape(graph, backward), POINT), expected, rtol=1e-14)


def test_what_does_not_depend_on_a_variable_costs_nothing():
    graph, nodes = nodes_of([sm.sin(x) * y])
    before = len(graph)
    assert adjoints(graph, nodes, [graph.one], [graph.input("x", 3)]) == [graph.zero]
    assert len(graph) == before


def test_a_gradient_costs_a_small_multiple_of_the_function():
    """Griewank's cheap gradient principle: whatever the number of variables."""
    graph = Graph()
    variables = [graph.input("x", k) for k in range(40)]
    node = graph.one
    for variable in variables:
        node = graph.call("sin", graph.add(graph.mul(node, variable), variable))
    places = [("x", k) for k in range(40)]

    def count(program):
        return sum(program.operation_count["run"].values())

    function = on_tape(graph, [node], (40, 0, 0))
    gradient = derivative_program(graph, [node], places, "gradient", (40, 0, 0))
    assert count(gradient) <= 3 * count(function)


@pytest.mark.parametrize("kind", KINDS)
def test_programs_of_derivatives_agree_with_the_jacobian(kind):
    expressions = [x**2 * y * sm.exp(z), sm.sin(x * w) + z**3]
    if kind in ("gradient", "hessian-vector"):
        expressions = expressions[:1]
    graph, nodes = nodes_of(expressions)
    places = [("x", 2), ("x", 0), ("p", 1)]
    program = derivative_program(graph, nodes, places, kind, (4, 0, 3), 2)
    vectors = np.array([[0.3, -1.0], [2.0, 0.5], [1.0, 1.0]])
    exact = dict(zip(X, map(sm.Rational, POINT), strict=True))
    by = [z, x, P[1]]
    J = np.array([[float(e.diff(v).subs(exact)) for v in by] for e in expressions])
    H = np.array([[float(expressions[0].diff(a, b).subs(exact)) for a in by] for b in by])
    expected = {
        "jacobian": lambda: J,
        "jacobian-vector": lambda: J @ vectors,
        "vector-jacobian": lambda: J.T @ vectors[:2],
        "gradient": lambda: np.append(float(expressions[0].subs(exact)), J[0]),
        "hessian-vector": lambda: H @ vectors,
    }[kind]()
    given = {"vector-jacobian": vectors[:2], "jacobian": None, "gradient": None}.get(kind, vectors)
    from pydy._program.interpret import run

    r = np.empty((1, 0)) if given is None else given.reshape(1, -1)
    out, _ = run(program, np.zeros(1), np.array([POINT]), r, np.array([2.0, 3.0, 4.0]))
    assert program.signature.blocks[0].shape == expected.shape
    np.testing.assert_allclose(out[0].reshape(expected.shape), expected, rtol=1e-14, atol=1e-15)
