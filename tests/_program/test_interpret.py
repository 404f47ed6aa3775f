"""Nodes that are evaluated as they are have the values of Programs made of them."""

import numpy as np
import pytest

from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.passes import rewriting
from pydy._program.interpret import run
from pydy._program.tuning import INDEPENDENT


def both(graph, nodes, x):
    m, n = x.shape
    graph.off = rewriting()
    program = lower(graph, (n, 0, 0), [("all", (len(nodes),), nodes)])
    expected, _ = run(program, np.zeros(m), x, np.zeros((m, 0)), np.zeros(0))
    inputs = {graph.input("x", k): x[:, k] for k in range(n)}
    return graph.evaluator(nodes)(inputs, m), expected


def test_sums_products_and_functions():
    g = Graph()
    a, b = g.input("x", 0), g.input("x", 1)
    nodes = [
        g.sum([(a, 2.5), (g.call("sin", b), -1.0)], 0.5),
        g.product([(a, 2), (b, -1)]),
        g.call("select", g.call("lt", a, b), a, g.call("atan2", a, b)),
        g.const(3.0),
    ]
    x = np.array([[0.3, 0.7], [0.9, 0.4], [1.0, 0.0]])
    found, expected = both(g, nodes, x)
    np.testing.assert_allclose(found, expected, rtol=1e-14)
    assert found[2, 1] == np.inf


@pytest.mark.parametrize("kind", ["ldl", "lu"])
def test_solutions_of_linear_systems(kind):
    g = Graph()
    a, b = g.input("x", 0), g.input("x", 1)
    nodes = LinearSystem(g, [[a, g.zero], [b, g.one]], kind).solve([g.one, b])
    x = np.array([[2.0, 0.5], [3.0, -0.7], [0.0, 0.5]])
    found, expected = both(g, nodes, x)
    np.testing.assert_allclose(found, expected, rtol=1e-14)
    assert np.isfinite(found[:2]).all()


def test_guards_that_fall_back_at_some_samples():
    g = Graph()
    a, b = g.input("x", 0), g.input("x", 1)
    sound = g.call("lt", g.const(0.5), a)
    plain = LinearSystem(g, [[a]]).guarded([b], sound, [g.div(b, a)])
    row = g.sum([(a, 2.0**50)])  # in units of its rounding
    rows = [[g.one, g.neg(row)], [row, g.const(INDEPENDENT)]]
    held = LinearSystem(g, rows).guarded([b, g.const(2.0**50)], sound, [g.powi(a, -1), g.zero])[:1]
    x = np.array([[2.0, 0.3], [0.1, 0.4]])
    found, expected = both(g, [*plain, *held], x)
    np.testing.assert_allclose(found, expected, rtol=1e-13)
    np.testing.assert_allclose(found, [[0.15, 0.5], [4.0, 10.0]], rtol=1e-13)
