"""Derivatives of roots at rest, in whatever form a model or a pass leaves them."""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from graphs import X, nodes_of, on_tape, values
from pydy._graph.adjoint import adjoints
from pydy._graph.derivative import jacobian
from pydy._graph.node import Graph
from pydy._graph.simplification import simplify

x, y, z, w = X
SPEED = sm.sqrt(x**2 + y**2)
HALF = sm.Rational(1, 2)
NAN = math.nan

# Expression, and its derivatives by x and y where x = y = 0, z = 0.5 and w = 2.
AT_REST = {
    "one speed": (x * sm.sqrt(x**2), (0, 0)),
    "a square": ((2 * x + y) * sm.sqrt((2 * x + y) ** 2), (0, 0)),
    "constants": (x * sm.sqrt(z * x**2 + w * y**2), (0, 0)),
    "a factor": (-y * sm.sqrt(w * (x**2 + y**2)), (0, 0)),
    "axes that are oblique": (x * sm.sqrt(x**2 + x * y * sm.cos(z) + y**2), (0, 0)),
    "a form of two factors": (x * sm.sqrt((1 + z**2) * (x**2 + x * y + y**2)), (0, 0)),
    "along a curve": (x * sm.sqrt(x**2 * (1 + z**2)), (0, 0)),
    "with a linear part": (x * (z + w * SPEED), (0.5, 0)),
    "deeper": (x * (sm.cos(z) * SPEED + z), (0.5, 0)),
    "in a function": (sm.exp(-SPEED) * x, (1, 0)),
    "two": (x * SPEED * sm.sqrt(y**2 + (x - y) ** 2), (0, 0)),
    "of the fourth order": (sm.sqrt((x**2 + y**2) ** 3), (0, 0)),
    "even": (sm.cos(SPEED), (0, 0)),
    "a power": (x * (x**2 + y**2) ** (w / 6), (0, 0)),
    "a power above one half": ((x**2 + y**2) ** (w / 3), (0, 0)),
    "a distance": (SPEED, (NAN, NAN)),
    "a distance in a product": (SPEED * (1 + z), (NAN, NAN)),
    "a power of less": (x * (x**2 + y**2) ** (z / 4), (0, 0)),
    "a root of a speed": (x * sm.sqrt(SPEED), (0, 0)),
    "a height": (y * sm.sqrt(1 - sm.cos(x)), (0, 0)),
    "a chord": (y * sm.sqrt(2 * x - x**2), (0, 0)),
    "an angle from its cosine": (x * y * sm.acos(1 - x), (0, 0)),
    "an angle from its sine": (y * sm.asin(1 - w * x / 2), (0, sm.pi / 2)),
    "an angle with a factor that stays": (z * sm.acos(1 - x), (NAN, 0)),
    "an angle in a sum": (y * (z * sm.acos(1 - x) + x + w), (0, 2)),
    "an angle in a function": (y * sm.sin(sm.acos(1 - x)), (0, 0)),
    "a root in a sum": (y * (z * sm.sqrt(x) + 3 * x * sm.asin(1 - x) + w), (0, 2)),
    "an even function of a height": (sm.cos(sm.sqrt(1 - sm.cos(x))), (0, 0)),
    "a height alone": (sm.sqrt(1 - sm.cos(x)), (NAN, 0)),
    "a root of one": (y * sm.sqrt(x), (0, 0)),
    "a step": (sm.sign(y) * sm.sqrt(x), (NAN, 0)),
    "not stationary": (sm.cos(sm.sqrt(x + y)), (NAN, NAN)),
    "two roots": (sm.sqrt(x) * sm.sqrt(z * x, evaluate=False), (NAN, 0)),
}
POINT = (0.0, 0.0, 0.5, 2.0)


def both(expression, point=POINT, simplified=False):
    """Derivatives by x and y: forward and in reverse."""
    graph, nodes = nodes_of([expression])
    if simplified:
        nodes = simplify(graph, nodes)
    by = [graph.input("x", k) for k in range(2)]
    (row,) = jacobian(graph, nodes, by)
    forward = [row.get(k, graph.zero) for k in range(2)]
    found = values(on_tape(graph, [*forward, *adjoints(graph, nodes, [graph.one], by)]), point)
    return found[:2], found[2:]


@pytest.mark.parametrize("simplified", [False, True])
@pytest.mark.parametrize("name", AT_REST)
def test_derivatives_at_rest(name, simplified):
    expression, expected = AT_REST[name]
    for found in both(expression, simplified=simplified):
        expected = np.array(expected, dtype=float)
        finite = np.isfinite(expected)
        np.testing.assert_array_equal(found[finite], expected[finite])
        assert not np.isfinite(found[~finite]).any()


@pytest.mark.parametrize("name", [n for n in AT_REST if n not in ("two roots", "a step")])
def test_elsewhere_they_are_those_of_60_digit_differences(name):
    expression, point = AT_REST[name][0], (0.3, 0.2, 0.5, 2.0)
    f = sm.lambdify(X, expression, "mpmath")
    with mp.workdps(60):
        expected = [float(mp.diff(f, point, (1, 0, 0, 0))), float(mp.diff(f, point, (0, 1, 0, 0)))]
    for found in both(expression, point):
        np.testing.assert_allclose(found, expected, rtol=1e-13)


def test_second_derivatives_at_rest():
    """Of |v|³ they are zero; of |v| v they do not exist, and those of the sides cancel."""
    graph, (node,) = nodes_of([(x**2 + y**2) ** (3 * HALF)])
    by = [graph.input("x", k) for k in range(2)]
    (row,) = jacobian(graph, [node], by)
    rows = jacobian(graph, [row[0], row[1]], by)
    cells = [r.get(k, graph.zero) for r in rows for k in range(2)]
    cells += adjoints(graph, [row[0], row[1]], [graph.one, graph.one], by)
    assert not values(on_tape(graph, cells), POINT).any()


@pytest.mark.parametrize(
    ("expression", "slope"),
    [
        (sm.Piecewise((sm.sin(x) / x, sm.Ne(x, 0)), (1, True)), 0.0),
        (sm.Piecewise((sm.sqrt(x), x > 0), (w * x, True)), 2.0),
        (sm.Piecewise((x * sm.log(x), x > 0), (sm.sin(x), True)), 1.0),
        (sm.Piecewise((sm.Piecewise((1 / x, x > 0), (sm.acos(1 + x), x < 0), (x, True)), z < 1),
                      (w, True)), 1.0),
        (sm.Piecewise((sm.sin(sm.exp(sm.sqrt(x)) * z + sm.sqrt(x)), x > 0), (0, True)), 0.0),
        (sm.Max(sm.sqrt(x), z), 0.0),
    ],
    ids=str,
)  # fmt: skip
def test_what_a_switch_leaves_out_has_no_part_in_a_derivative(expression, slope):
    for found in both(expression):
        np.testing.assert_array_equal(found, [slope, 0.0])


def test_squares_leave_roots():
    graph = Graph()
    a, b, p = graph.input("x", 0), graph.input("x", 1), graph.input("p", 0)
    root = graph.call("sqrt", graph.product([(a, 2), (p, 3), (b, -4)], 9.0))
    inner = graph.call("abs", graph.product([(a, 1), (b, -2)]))
    assert root == graph.product([(inner, 1), (p, 1), (graph.call("sqrt", p), 1)], 3.0)
    for e in (-5, -3, -1, 1, 2, 3, 5):
        node = graph.call("sqrt", graph.powi(b, e))
        assert values(on_tape(graph, [node]), (1.0, 1.7))[0] == pytest.approx(1.7 ** (e / 2))
    minus = graph.call("sqrt", graph.product([(a, 2)], -1.0))
    assert math.isnan(values(on_tape(graph, [minus]), (1.0, 1.0))[0])
