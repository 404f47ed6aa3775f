"""How far a node may come while its inputs move is no less than samples show."""

import math

import numpy as np
import pytest
import sympy as sm

from pydy._graph.from_sympy import SymPyReader
from pydy._graph.node import Graph
from pydy._graph.reachability import reach

X, Y, A, FORCE = sm.symbols("x y a force")


def bound_of(expression):
    """Return the graph, its inputs, the node and its bound."""
    g = Graph()
    inputs = {X: g.input("x", 0), Y: g.input("x", 1), A: g.input("p", 0), FORCE: g.input("r", 0)}
    moving = {inputs[X]: g.input("r", 1), inputs[Y]: g.input("r", 2)}
    (node,) = SymPyReader(g, inputs, "a test").all([expression])
    return g, inputs, moving, node, reach(g, [node], moving)[0]


@pytest.mark.parametrize(
    "expression",
    [
        A + 3 * X - Y / 2,
        X * Y,
        A * X**2 * Y**3,
        X / Y,
        A / (X**2 + Y),
        sm.cos(X) + A * sm.sin(3 * Y) * X,
        sm.sqrt(X**2 + (Y - A) ** 2) - 1,
        Y - sm.exp(-100 * (X - A) ** 2),
        sm.Max(X, Y) + sm.Min(X, A) + sm.Abs(Y),
        sm.Piecewise((X, A > 0), (Y**2, True)),
        sm.atan(5 * X) - sm.tanh(Y) + sm.asinh(X),
    ],
)
def test_no_motion_of_the_inputs_goes_beyond_the_bound(expression):
    g, inputs, moving, node, bound = bound_of(expression)
    draws, m = np.random.default_rng(3), 400
    values = g.evaluator([node, bound])
    finite = 0
    for _ in range(60):
        centre, radius = draws.normal(size=2), 10.0 ** draws.uniform(-6, 1, 2)
        at = {inputs[A]: draws.normal(), inputs[FORCE]: 0.0}
        at |= dict(zip(moving.values(), radius, strict=True))
        start = dict(zip(moving, centre, strict=True))
        value, most = values({**at, **start}, 1)[0]
        shares = draws.uniform(-1, 1, (2, m))
        shares[:, : m // 2] = np.sign(shares[:, : m // 2])  # corners
        moved = dict(zip(moving, centre[:, None] + radius[:, None] * shares, strict=True))
        found = values({**at, **moved}, m)[:, 0]
        finite += np.isfinite(most)
        assert (np.abs(found - value) <= most * (1 + 1e-12) + 1e-12 * abs(value)).all()
    assert finite > 20


def test_what_is_unknown_has_no_bound():
    for expression in (X + FORCE, sm.tan(X), sm.Piecewise((X, Y > 0), (1, True)), sm.floor(X)):
        assert bound_of(expression)[-1] is None


@pytest.mark.parametrize("expression", [sm.sqrt(X), 1 / X])
def test_a_bound_is_infinite_where_the_expression_may_become_undefined(expression):
    g, inputs, moving, _, bound = bound_of(expression)
    by = next(iter(moving.values()))
    at = g.evaluator([bound])
    assert at({inputs[X]: 1.0, by: 1.0}, 1)[0, 0] == math.inf
    assert at({inputs[X]: 1.0, by: 0.5}, 1)[0, 0] < 2.0


def test_constants_move_by_nothing():
    g, *_, bound = bound_of(A**2 + 1)
    assert bound == g.zero
