"""Rounding bounds as nodes."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from pydy._graph.from_sympy import SymPyReader
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.rounding import rounding_bounds, sizes_of_terms
from pydy._program.interpret import run

EPS = 2.0**-52
X = sm.symbols("x y z")
P = sm.symbols("a b")
x, y, z = X
a, b = P

EXPRESSIONS = [
    x**2 + (y - a) ** 2 - a**2,
    sm.sqrt(x**2 + (y - a) ** 2) - a,
    sm.sin(x) * sm.cos(y) - sm.sin(x + z) + b,
    (x - y) / (z + a) - x / z,
    x**3 - 3 * x**2 * y + 3 * x * y**2 - y**3,
    sm.atan2(x, y) - sm.exp(z / 7) + sm.log(x + a),
    sm.Abs(x - y) + sm.Min(x, z) - sm.Max(y, b),
    sm.Piecewise((x**2 - y, x < y), (x - y**2, True)),
    x ** sm.Rational(5, 2) * b - z**b,
    (sm.sqrt(x) - sm.sqrt(y)) * (x + z),
    z * (x * (sm.sqrt(y) - sm.sqrt(x)) * y - x * sm.sqrt(z)),
]


def bounded(expression):
    """Functions of x and p: the value, and its bound in units of 2⁻⁵²."""
    graph = Graph()
    atoms = {s: graph.input("x", k) for k, s in enumerate(X)}
    atoms |= {s: graph.input("p", k) for k, s in enumerate(P)}
    nodes = SymPyReader(graph, atoms, "the test").all([expression])
    nodes += rounding_bounds(graph, nodes)
    program = lower(graph, (len(X), 0, len(P)), [("all", (2,), nodes)])
    return lambda x, p: run(program, np.zeros(1), x[None], np.zeros((1, 0)), p)[0][0]


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_errors_of_evaluation_and_of_rounded_states_are_within_the_bound(expression):
    f = bounded(expression)
    exact = sm.lambdify([*X, *P], expression, "mpmath")
    rng = np.random.default_rng(0)
    with mp.workdps(40):
        for _ in range(100):
            state = rng.uniform(0.2, 3.0, 3) * 10.0 ** rng.integers(-3, 4, 3)
            p = rng.uniform(0.2, 3.0, 2) * 10.0 ** rng.integers(0, 3, 2)
            p[1] = rng.uniform(0.5, 2.0)
            value, bound = f(state, p)
            assert abs(exact(*map(mp.mpf, [*state, *p])) - value) <= EPS * bound
            # Half a unit in the last place of the states.
            units = [mp.mpf(sign) * mp.mpf(2) ** -53 for sign in (1, -1, 1)]
            moved = [mp.mpf(v) * (1 + unit) for v, unit in zip(state, units, strict=True)]
            assert abs(exact(*moved, *map(mp.mpf, p)) - value) <= EPS * bound


def test_a_bound_grows_with_the_terms_that_cancel_not_with_the_value():
    f = bounded(x**2 + (y - a) ** 2 - a**2)
    small, large = (f(np.array([1.0, 0.5 / r, 0.0]), np.array([r, 1.0]))[1] for r in (1e2, 1e6))
    assert 1e12 < large < 1e13
    assert 1e4 < small < 1e5


def test_constants_time_specifieds_and_steps_are_exact():
    graph = Graph()
    nodes = [graph.input("p", 0), graph.input("t", 0), graph.input("r", 0)]
    nodes += [graph.call("sign", graph.input("x", 0)), graph.call("sin", nodes[0])]
    assert rounding_bounds(graph, nodes) == [graph.zero] * 5


def test_a_state_is_uncertain_by_its_own_rounding():
    graph = Graph()
    state = graph.input("x", 1)
    assert rounding_bounds(graph, [state]) == [graph.call("abs", state)]


def test_terms_that_cancel_are_as_large_as_each_of_them():
    graph = Graph()
    a, b = graph.input("x", 0), graph.input("x", 1)
    node = graph.mul(a, graph.sum([(a, 1.0), (b, -2.0)], 3.0))
    chosen = graph.call("select", graph.call("lt", a, b), node, b)
    values = graph.evaluator(sizes_of_terms(graph, [node, chosen, graph.sum([(node, -1.0)])]))
    assert values({a: -2.0, b: -4.0}, 1)[0].tolist() == [26.0, 4.0, 26.0]
    assert values({a: -5.0, b: -4.0}, 1)[0].tolist() == [80.0, 80.0, 80.0]


def test_products_of_sums_within_sums_take_no_longer_than_they_are_large():
    """Each holds the one before twice: as many as sixty would be 2⁶⁰ ways through them."""
    g = Graph()
    node, factor = g.input("x", 0), g.input("x", 1)
    for _ in range(60):
        once = g.sum([(node, 1.0), (g.mul(node, factor), 0.3)], 1.0)
        node = g.mul(factor, once, g.sum([(node, 1.0)], 2.0))
    assert len(rounding_bounds(g, [node])) == 1
