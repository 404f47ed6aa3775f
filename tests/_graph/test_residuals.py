"""Derivatives of solutions by residuals: those of the systems, in fewer operations."""

import sys
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sm

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))

from harness import frozen
from harness.program import assembly_of

from pydy._graph.columns import SensitivityColumns
from pydy._graph.derivative import directional, jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.residuals import residuals
from pydy._graph.simplification import simplify
from pydy._program.interpret import run

LINKS = 7


def chain():
    """M and F of a chain of links of unit mass and length on a hinge, and their inputs."""
    q, u = sm.symbols(f"q:{LINKS}"), sm.symbols(f"u:{LINKS}")
    c, s, rows = [*map(sm.cos, q)], [*map(sm.sin, q)], range(LINKS)
    weights = [[LINKS - max(i, j) for j in rows] for i in rows]
    matrix = sm.Matrix(LINKS, LINKS, lambda i, j: weights[i][j] * (c[i] * c[j] + s[i] * s[j]))
    forcing = sm.Matrix(
        [
            sum(weights[i][j] * (c[i] * s[j] - s[i] * c[j]) * u[j] ** 2 for j in rows)
            - 9 * weights[i][i] * s[i]
            for i in rows
        ]
    )
    return matrix, forcing, (*q, *u)


def solved(matrix, forcing, symbols):
    """A graph with the accelerations, simplified, and the inputs of the symbols."""
    graph = Graph()
    read = SymPyReader.of_inputs(graph, "the test", x=symbols)
    rows = [read.all(matrix.row(i)) for i in range(matrix.rows)]
    roots = LinearSystem(graph, rows, "ldl").solve(read.all(forcing))
    nodes = simplify(graph, roots)
    return graph, nodes, [graph.input("x", k) for k in range(len(symbols))]


def solve_of(graph, nodes):
    (solve,) = (k for k in graph.reachable(nodes) if graph.ops[k] == "solve")
    return solve


def along(graph, nodes, inputs):
    """The Program of the derivative along a direction, whose components follow the inputs."""
    n = len(inputs)
    seeds = {node: {0: graph.input("x", n + k)} for k, node in enumerate(inputs)}
    cells = directional(graph, nodes, seeds).flat()
    return lower(graph, (2 * n, 0, 0), [("cells", (len(cells),), cells)])


def test_the_derivative_by_residuals_is_exact():
    matrix, forcing, symbols = chain()
    graph, nodes, inputs = solved(matrix, forcing, symbols)
    assert residuals(graph, solve_of(graph, nodes)) is not None
    rng = np.random.default_rng(0)
    state, direction = rng.normal(size=(2, len(symbols)))
    program = along(graph, nodes, inputs)
    computed = run(program, np.zeros(1), np.append(state, direction)[None], np.zeros((1, 0)), ())
    # (M⁻¹ F)' at 40 digits, from a difference quotient whose error is of their square root's size.
    function = sm.lambdify([symbols], [matrix, forcing], "mpmath")
    with mpmath.workdps(40):

        def accelerations(step):
            m, f = function(
                [mpmath.mpf(x) + step * d for x, d in zip(state, direction, strict=True)]
            )
            return mpmath.lu_solve(m, f)

        step = mpmath.mpf(10) ** -12
        exact = (accelerations(step) - accelerations(-step)) / (2 * step)
        exact = np.array([float(x) for x in exact])
    assert np.allclose(computed[0][0], exact, rtol=1e-12, atol=1e-12 * abs(exact).max())


def test_the_residuals_vanish_at_the_solution():
    graph, nodes, inputs = solved(*chain())
    cells = residuals(graph, solve_of(graph, nodes))
    program = lower(graph, (len(inputs), 0, 0), [("cells", (len(cells),), cells)])
    states = np.random.default_rng(1).normal(size=(5, len(inputs)))
    values, _ = run(program, np.zeros(5), states, np.zeros((1, 0)), ())
    assert abs(values).max() < 1e-12


def test_nodes_of_the_solution_have_their_whole_derivatives_elsewhere():
    graph, nodes, inputs = solved(*chain())
    solve = solve_of(graph, nodes)
    # A node of the residuals with an acceleration is an output too.
    product = next(
        k
        for k in graph.reachable(residuals(graph, solve))
        if graph.ops[k] == "prod" and any(n in nodes for n, _ in graph.args[k])
    )
    seeds = {node: {k: graph.one} for k, node in enumerate(inputs)}
    outputs = [*nodes, product]
    by_residuals = directional(graph, outputs, seeds, len(inputs)).flat()
    by_system = jacobian(graph, outputs, inputs).flat()
    blocks = [("one", (len(by_residuals),), by_residuals), ("two", (len(by_system),), by_system)]
    program = lower(graph, (len(inputs), 0, 0), blocks)
    states = np.random.default_rng(2).normal(size=(3, len(inputs)))
    values, _ = run(program, np.zeros(3), states, np.zeros((1, 0)), ())
    one, two = np.split(values, 2, axis=1)
    assert np.allclose(one, two, rtol=1e-11, atol=1e-11)


def test_a_residual_that_saves_nothing_is_not_made():
    a, b, c = sm.symbols("a b c")
    graph, nodes, _ = solved(sm.Matrix([[a, b], [b, c]]), sm.Matrix([a, c]), (a, b, c))
    assert residuals(graph, solve_of(graph, nodes)) is None


def test_a_system_within_a_system_is_solved_once():
    matrix, forcing, symbols = chain()
    graph = Graph()
    read = SymPyReader.of_inputs(graph, "the test", x=symbols)
    rows = [read.all(matrix.row(i)) for i in range(LINKS)]
    first = LinearSystem(graph, rows, "ldl").solve(read.all(forcing))
    roots = LinearSystem(graph, rows, "ldl").solve(first)
    nodes = simplify(graph, roots)
    inputs = [graph.input("x", k) for k in range(len(symbols))]
    factors = {k for k in graph.reachable(nodes) if graph.ops[k] == "factor"}
    seeds = {node: {0: graph.input("x", LINKS * 2 + k)} for k, node in enumerate(inputs)}
    cells = directional(graph, nodes, seeds).flat()
    assert {k for k in graph.reachable(cells) if graph.ops[k] == "factor"} == factors


# Of the state and eight columns: operations of what all share and of one column. Columns of all
# models but the pendulums are differentiated by the systems, with residuals they take no fewer.
COLUMNS = {
    "pendulum-5": (402, 351),
    "pendulum-10": (1335, 757),
    "rods-3": (1845, 2459),
    "bicycle": (1503, 2184),
}


@pytest.mark.parametrize("name", COLUMNS)
def test_no_column_costs_more_operations_than_it_did(name):
    assembly = assembly_of(frozen.read(name))
    columns = SensitivityColumns(assembly.sizes[0], tuple(("p", k) for k in range(8)))
    made = columns.tangent(*assembly.simplified("rates"), assembly.sizes, "rates")
    (part,) = made.parts
    shared, column = (p.operation_count["run"].total() for p in (made.shared, part.program))
    assert shared <= COLUMNS[name][0]
    assert column <= COLUMNS[name][1]
