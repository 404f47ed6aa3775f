"""Where several terms switch at one point, their derivatives are those of one side."""

from random import Random

import numpy as np
import pytest
import sympy as sm

from graphs import P, X, derivatives, nodes_of, on_tape, values
from pydy._graph import Graph, adjoints, jacobian

x, y = X[:2]
HEAVISIDE = sm.Heaviside(x), sm.Heaviside(-x)
SMOOTH_AT_ZERO = [
    (sm.Max(x, 0) + sm.Min(x, 0), 1.0),
    (sm.Max(0, -2 * x) + sm.Min(0, -2 * x), -2.0),
    (sm.Abs(x) * sm.sign(x), 1.0),
    (sm.tanh(3 * sm.Abs(x)) * sm.sign(x), 3.0),
    (sm.sqrt(x**2) * sm.sign(-x), -1.0),
    (sm.Max(x, 0) - sm.Abs(x) / 2, 0.5),
    (sm.Piecewise((x, x > 0), (0, True)) + sm.Piecewise((x, x < 0), (0, True)), 1.0),
    (sm.Piecewise((x, x <= 0), (0, True)) + sm.Piecewise((x, x >= 0), (0, True)), 1.0),
    (sm.Piecewise((2 * x, x <= 0), (0, True)) + 2 * sm.Max(x, 0), 2.0),
    (x * HEAVISIDE[0] + x * HEAVISIDE[1], 1.0),
    (sm.Piecewise((x, (x > 0) & (y < 1)), (0, True)) + sm.Min(x, 0), 1.0),
    (sm.exp(sm.sign(x)) * x - sm.exp(2 * sm.Heaviside(x, 0) - 1) * x, 0.0),
]
"""Expressions that are smooth in x at zero, with their slopes there."""
VANISHING_TOGETHER = [
    (sm.Abs(sm.exp(-x) - 1) * sm.sign(x), 1.0),
    (sm.Max(x, 0) + sm.Min(sm.sin(x), 0), 1.0),
    (sm.Max(1 - sm.exp(x), 0) - sm.Max(0, -sm.sin(x)), 0.0),
    (sm.Abs(x**3 + y * x) * sm.sign(sm.tan(x)), 0.5),
    (sm.Abs((y - 1) * x) * sm.sign(sm.sinh(x)), 0.5),
    (sm.Abs(x + y - sm.Rational(1, 2)) * sm.sign(sm.exp(2 * x + 2 * y - 1) - 1), 1.0),
    (sm.Abs(sm.Abs(x) * sm.sign(sm.tan(x)) + x) * sm.sign(sm.sinh(x)), 2.0),
    (sm.sign(x) * sm.Max(2 * sm.Abs(x), x**2), 2.0),
    (sm.sign(x) * sm.Min(2 * sm.Abs(x), x**2), 0.0),
    (sm.sign(x) * sm.Max(sm.Abs(2 * x), sm.Abs(sm.exp(3 * x) - 1)), 3.0),
    (sm.sign(x) * sm.Min(sm.Abs(2 * x), sm.Abs(sm.sin(3 * x))), 2.0),
    (sm.sign(x) * sm.Max(sm.Abs((y - 1) * x), sm.Abs((y + 1) * x)), 1.5),
    (sm.Abs(y * x) * sm.sign(x**3), 0.5),
    (sm.Abs(y * x) * sm.sign(x**3) + sm.Abs(x - y), -0.5),
]
"""The same of arguments that are no multiples of one another, at y = 1/2."""


def _strictly(a, b):
    return sm.StrictLessThan(a, b, evaluate=False)


def _at_most(a, b):
    return sm.LessThan(a, b, evaluate=False)


@pytest.mark.parametrize(("expression", "slope"), [*SMOOTH_AT_ZERO, *VANISHING_TOGETHER])
def test_terms_that_switch_together_have_the_slope_that_both_sides_have(expression, slope):
    assert derivatives([expression], 0.0, 0.5, variables=(x, y))[0, 0] == pytest.approx(slope)


@pytest.mark.parametrize(("expression", "slope"), [*SMOOTH_AT_ZERO, *VANISHING_TOGETHER])
def test_slopes_at_zero_are_the_limits_of_those_beside_it(expression, slope):
    for side in (-1e-9, 1e-9):
        near = derivatives([expression], side, 0.5, variables=(x, y))[0, 0]
        assert near == pytest.approx(slope, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("place", [0.0, 3.0, -1e-9])
@pytest.mark.parametrize(
    "condition",
    [
        lambda v: v * sm.Abs(v),
        lambda v: v * sm.sqrt(sm.Abs(v)),
        lambda v: v * sm.Abs(sm.sin(v)),
        lambda v: v**2 * sm.sign(v),
        lambda v: sm.Abs(v) ** 3 * sm.sign(v),
        lambda v: sm.sin(v) ** 3,
        lambda v: v**3 + v**5,
        lambda v: v**3 + v * sm.Abs(v),
        lambda v: y * v**3 + v * sm.Abs(v) / 3,
        lambda v: sm.Min(v, v**3),
        lambda v: v * (1 - sm.cos(v)),
        lambda v: v - sm.sin(v),
        lambda v: sm.sinh(v) - v,
        lambda v: sm.tan(v) - v,
    ],
)
def test_what_changes_its_sign_without_a_slope_is_on_the_same_side(condition, place):
    v = x - sm.Float(place, 17)
    positive = _strictly(0, condition(v))
    smooth = [
        2 * sm.Max(v, 0) + sm.Piecewise((3 * v, positive), (5 * v, True), evaluate=False),
        2 * sm.Min(v, 0) + sm.Piecewise((5 * v, positive), (3 * v, True), evaluate=False),
        sm.Abs(v) + sm.Piecewise((4 * v, positive), (6 * v, True), evaluate=False),
    ]
    found = derivatives(smooth, place, 0.5, variables=(x,))
    np.testing.assert_allclose(found, np.full((3, 1), 5.0))


def test_an_argument_of_many_states_has_a_slope_in_the_direction():
    """Whatever their places among all states are."""
    for signs in ((1, -1, -1, 1), (1, -2, 1, 0), (1, -3, 3, -1)):
        v = sum(sign * state for sign, state in zip(signs, X, strict=True))
        pulled = sm.Abs((X[0] - 1) * v) * sm.sign(sm.sinh(v))
        found = derivatives([pulled], 0.5, 0.5, 0.5, 0.5)[0]
        np.testing.assert_allclose(found, 0.5 * np.array(signs))


@pytest.mark.parametrize("place", [6371000.0, -(2.0**-28), 3e-9, 150.0])
@pytest.mark.parametrize("scale", [1e-9, 1.0])
def test_what_is_zero_together_is_so_wherever_and_however_small_it_is(place, scale):
    away = (x - sm.Float(place, 17)) / scale
    pulled = scale * sm.Abs(away) * sm.sign(sm.erfc(away) - 1)
    assert derivatives([pulled], place, 0.5, variables=(x,))[0, 0] == pytest.approx(-1.0)


c, d = P[:2]
PRESSED = sm.Max(x, 0)


@pytest.mark.parametrize("place", [-0.75, -0.3, 0.3, 0.75])
@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        (_strictly(0, PRESSED), lambda v: v > 0),
        (_strictly(0, PRESSED**2), lambda v: v > 0),
        (_strictly(0, PRESSED * y), lambda v: v > 0),
        (_strictly(0, sm.sqrt(PRESSED)), lambda v: v > 0),
        (_at_most(PRESSED, 0), lambda v: v <= 0),
        (_strictly(0, x + sm.Abs(x)), lambda v: v > 0),
        (_strictly(sm.Abs(x), x), lambda v: False),
        (_at_most(x, sm.Abs(x)), lambda v: True),
        (_strictly(sm.Min(x, 0.5), x), lambda v: v > 0.5),
        (_at_most(x, sm.Min(x, 0.5)), lambda v: v <= 0.5),
        (_strictly(x, sm.Piecewise((x, x > 0), (2 * x + 1, True))), lambda v: -1 < v <= 0),
        (_strictly(0, sm.Max(x - 0.5, 0) + sm.Min(x + 0.5, 0)), lambda v: v > 0.5),
        (_strictly(0, sm.floor(2 * x)), lambda v: v > 0.5),
        (_strictly(0, sm.Heaviside(x)), lambda v: v > 0),
        (_strictly(x, x), lambda v: False),
        (_at_most(x, x), lambda v: True),
        (sm.And(_strictly(0, PRESSED), y > 0), lambda v: v > 0),
        (sm.Not(_strictly(0, PRESSED), evaluate=False), lambda v: v <= 0),
    ],
)
def test_a_condition_that_is_an_equality_in_a_region_is_that_at_the_point(condition, holds, place):
    """There is no side to choose: a contact without a penetration, a controller below its limit."""
    pieces = sm.Piecewise((3 * x * y, condition), (y**2, True), evaluate=False)
    slopes = [1.5, 3 * place] if holds(place) else [0.0, 1.0]
    found = derivatives([pieces], place, 0.5, variables=(x, y))[0]
    np.testing.assert_allclose(found, slopes, atol=1e-15)


def test_a_sign_that_is_zero_in_a_region_is_so_in_derivatives():
    pulled = sm.sign(PRESSED) * y
    np.testing.assert_array_equal(derivatives([pulled], -0.3, 0.5, variables=(x, y)), [[0, 0]])
    np.testing.assert_array_equal(derivatives([pulled], 0.3, 0.5, variables=(x, y)), [[0, 1]])


def test_at_the_edge_of_such_a_region_all_terms_are_on_one_side():
    """A spring and a damper that act while Max(x, 0) > 0 do, at x = 0, where x is positive."""
    for condition in (PRESSED > 0, _strictly(0, PRESSED**2)):
        force = 3 * PRESSED + sm.Piecewise((2 * y, condition), (0, True))
        np.testing.assert_array_equal(derivatives([force], 0.0, 0.5, variables=(x, y)), [[3, 2]])


@pytest.mark.parametrize(
    ("expression", "slopes"),
    [
        (sm.Max(c, 0) + sm.Min(c, 0), [1.0, 0.0]),
        (sm.Max(0, -2 * c) + sm.Min(0, -2 * c), [-2.0, 0.0]),
        (sm.Max(c, d) + sm.Min(c, d), [1.0, 1.0]),
        (sm.Max(d - c, 0) + sm.Min(d - c, 0), [-1.0, 1.0]),
        (sm.Max(c, -c) * sm.sign(c), [1.0, 0.0]),
        (sm.Max(c, d) - sm.Abs(c - d) / 2, [0.5, 0.5]),
    ],
)
def test_constants_that_switch_terms_together_have_the_slope_of_both_sides(expression, slopes):
    """They are zero: a backlash, a preload or a friction that a model may have."""
    g, nodes = nodes_of([expression])
    variables = [g.input("p", k) for k in range(2)]
    forward = jacobian(g, nodes, variables).flat()
    backward = adjoints(g, nodes, [g.one], variables)
    np.testing.assert_array_equal(values(on_tape(g, [*forward, *backward])), [*slopes, *slopes])


def test_a_condition_of_a_constant_selects_an_equation():
    g, nodes = nodes_of([sm.Piecewise((x, c > 0), (2 * x, True))])
    slope = jacobian(g, nodes, [g.input("x", 0)]).flat()
    np.testing.assert_array_equal(values(on_tape(g, slope)), [2.0])


def test_reverse_accumulation_takes_the_same_side():
    g = Graph()
    node = g.input("x", 0)
    switched = g.mul(g.call("abs", node), g.call("sign", node))
    positive = g.call("lt", g.zero, node)
    pieces = g.add(g.call("select", positive, node, g.zero), g.call("min", node, g.zero), switched)
    forward = jacobian(g, [pieces], [node]).flat()
    assert forward == adjoints(g, [pieces], [g.one], [node])


def test_a_branch_that_is_singular_at_the_switch_is_not_entered():
    root = sm.Piecewise((0, x <= 0), (sm.sqrt(x), True))
    quotient = sm.Piecewise((0, sm.Eq(x, 0)), (sm.sin(x**3) / x**2, True))
    np.testing.assert_array_equal(derivatives([root, quotient], 0.0, variables=(x,)), [[0], [0]])


def test_an_equality_of_parameters_selects_an_equation():
    expression = sm.Piecewise((2 * x, sm.Eq(y, 1)), (3 * x, True))
    graph = Graph()
    state, mode = graph.input("x", 0), graph.input("p", 0)
    chosen = graph.call("eq", mode, graph.one)
    node = graph.call("select", chosen, graph.sum([(state, 2.0)]), graph.sum([(state, 3.0)]))
    slope = jacobian(graph, [node], [state])[0][0]
    assert graph.ops[slope] == "select"
    assert derivatives([expression], 0.5, 2.0, variables=(x,))[0, 0] == 3.0


def test_a_plateau_is_no_single_point():
    expression = sm.Piecewise((2 * x, sm.Eq(sm.Max(x, 0), 0)), (3 * x, True))
    assert derivatives([expression], -1.0, variables=(x,))[0, 0] == 2.0


# -- random ties -----------------------------------------------------------------------------------


def vanishing(v):
    """Expressions that are zero where v is, of which none is a multiple of another."""
    of_itself = [
        v,
        -v,
        sm.sin(v),
        sm.exp(v) - 1,
        1 - sm.exp(-v),
        v**3 + v,
        sm.tanh(v),
        sm.sinh(2 * v),
        v * sm.Abs(v),
        v**3 + v * sm.Abs(v),
    ]
    of_others = [
        v * (1 + y**2),
        v * (y - 2),
        c * v,
        v * sm.cos(y),
        v / (1 + y**2),
        v * (2 + sm.sin(c)),
    ]
    return of_itself + of_others


def switched(random, v):
    """A sum of terms that switch where v = 0."""
    a, b = random.sample(vanishing(v), 2)
    kinds = [
        lambda: sm.Max(a, 0) + sm.Min(b, 0),
        lambda: sm.Abs(a) * sm.sign(b),
        lambda: sm.Max(a, b),
        lambda: sm.Piecewise((a, b > 0), (b, True)),
        lambda: sm.Piecewise((a, b <= 0), (0, True)),
    ]
    return random.choice([1, 2, -1, sm.Rational(1, 2)]) * random.choice(kinds)()


@pytest.mark.parametrize("seed", range(60))
def test_at_a_random_tie_derivatives_are_those_of_one_side(seed):
    random = Random(seed)
    v = random.choice([x, x - y, x + 2 * y, x - c, x + y - c])
    terms = sum(switched(random, v) for _ in range(random.randint(2, 3)))
    other, constant = random.choice([0.5, -1.3, 0.0, 3.0]), random.choice([1.0, -0.7, 2.0])
    place = {
        x: 0.0,
        x - y: other,
        x + 2 * y: -2 * other,
        x - c: constant,
        x + y - c: constant - other,
    }
    g, nodes = nodes_of([terms])
    variables = [g.input("x", k) for k in range(2)]
    forward, backward = (
        on_tape(g, slopes)
        for slopes in (jacobian(g, nodes, variables).flat(), adjoints(g, nodes, [g.one], variables))
    )

    def slopes(program, beside=0.0):
        return values(program, [place[v] + beside, other, 0.0, 0.0], [constant])

    here, sides = slopes(forward), [slopes(forward, h) for h in (-1e-7, 1e-7)]
    assert any(side == pytest.approx(here, rel=1e-5, abs=1e-5) for side in sides), terms
    assert slopes(backward) == pytest.approx(here, rel=1e-12, abs=1e-12)
