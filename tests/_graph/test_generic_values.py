"""Conditions that are equalities in a whole region of states, also on solutions of systems."""

from random import Random

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from graphs import P, X, nodes_of, on_tape, values
from pydy._graph import LinearSystem, adjoints, jacobian, substitute
from pydy._graph.generic_values import arbitrary_number

x, y, first, second = X  # the last two are solutions of linear systems
c = P[0]
MATRIX = sm.Matrix([[2, 1], [1, 3]])


def both_derivatives(expression, right, place, constants=(0.0,)):
    """Derivatives by x and y, forward and reverse, where M (first, second) = right."""
    g, (node, *column) = nodes_of([expression, *right])
    matrix = [[g.const(float(entry)) for entry in row] for row in MATRIX.tolist()]
    solution = LinearSystem(g, matrix, "ldl").solve(column)
    solved = {g.input("x", 2 + k): n for k, n in enumerate(solution)}
    nodes, variables = substitute(g, [node], solved), [g.input("x", k) for k in range(2)]
    forward = jacobian(g, nodes, variables).flat()
    backward = adjoints(g, nodes, [g.one], variables)
    program = on_tape(g, [*forward, *backward])
    return values(program, [*place, 0.0, 0.0], constants).reshape(2, 2)


def exact_slopes(expression, right, place, constants=(0.0,)):
    """Slopes by differences with 60 digits, equal on both sides of the place."""
    solution = sm.lambdify((x, y, c), list(MATRIX.LUsolve(sm.Matrix(right))), "mpmath")
    f = sm.lambdify((x, y, c, first, second), expression, "mpmath")
    with mp.workdps(60):
        at = [mp.mpf(v) for v in (*place, *constants)]

        def value(k=0, step=0):
            beside = [v + step * (j == k) for j, v in enumerate(at)]
            return f(*beside, *solution(*beside))

        slopes, h = [], mp.mpf(10) ** -30
        for k in range(2):
            above, below = (value(k, h) - value()) / h, (value() - value(k, -h)) / h
            assert abs(above - below) < 1e-20
            slopes.append(float(above))
    return slopes


def _strictly(a, b):
    return sm.StrictLessThan(a, b, evaluate=False)


def _at_most(a, b):
    return sm.LessThan(a, b, evaluate=False)


FORCES = x * y + 1, sm.sin(x) - y
"""Right-hand sides; the first solution is positive where x and y are 0.7 and 0.3."""


@pytest.mark.parametrize("place", [(0.7, 0.3), (-0.9, 1.4), (0.2, -1.3), (-1.7, -1.1)])
@pytest.mark.parametrize(
    "condition",
    [
        _strictly(0, sm.Max(first, 0)),
        _strictly(0, sm.Max(-first, 0)),
        _at_most(sm.Max(second, 0), 0),
        _strictly(sm.Abs(first), first),
        _at_most(second, sm.Abs(second)),
        _strictly(0, first + sm.Abs(first)),
        _strictly(sm.Min(first, second), first),
        _strictly(0, sm.Heaviside(second)),
        _strictly(0, sm.floor(second / 99) + 1),
        _strictly(0, sm.sqrt(sm.Max(-first, 0)) * y),
        _strictly(1, sm.exp(sm.Max(-second, 0))),
        _strictly(0, sm.Max(sm.Min(first, x), 0)),
        _strictly(first, sm.Piecewise((first, first > 0), (first + 1, True))),
        sm.And(_strictly(0, sm.Max(first, 0)), _strictly(0, sm.Max(second, 0))),
        sm.Not(_strictly(0, sm.Max(second, 0)), evaluate=False),
    ],
    ids=str,
)
def test_a_condition_on_a_solution_is_that_at_the_point_where_it_is_an_equality(condition, place):
    """As the pull of a string, whose multiplier is above zero or not."""
    pieces = sm.Piecewise((3 * x * y, condition), (y**2 - first, True), evaluate=False)
    expected = exact_slopes(pieces, FORCES, place)
    for found in both_derivatives(pieces, FORCES, place):
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("place", [(0.7, 0.3), (-0.9, 0.4)])
@pytest.mark.parametrize(
    "condition",
    [
        _strictly(0, first),
        _at_most(0, second),
        _strictly(0, y * first),
        _strictly(0, sm.Abs(first) + sm.Max(second, 0)),
        _strictly(0, sm.sin(second)),
    ],
    ids=str,
)
def test_solutions_are_zero_in_a_region_where_nothing_acts(condition, place):
    """Accelerations of bodies whose only force is that of a contact, which is open or not."""
    forces = sm.Max(-x, 0) * (2 + y), sm.S.Zero
    pieces = sm.Piecewise((3 * x * y, condition), (y**2, True), evaluate=False)
    expected = exact_slopes(pieces, forces, place)
    for found in both_derivatives(pieces, forces, place):
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("constant", [0.0, 2.0])
def test_what_acts_may_be_a_constant_that_is_zero(constant):
    forces = sm.Max(-x, 0) + c, sm.S.Zero
    pieces = sm.Piecewise((3 * x * y, _strictly(0, first)), (y**2, True), evaluate=False)
    expected = [0.0, 0.6] if constant == 0.0 else [0.9, 2.1]
    for found in both_derivatives(pieces, forces, (0.7, 0.3), [constant]):
        np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_what_is_zero_at_one_state_alone_has_a_side():
    """Also without a slope there, as x |x|; the sides are those of Max(x, 0)."""
    for argument in (first, sm.Max(first, 0), first * sm.Abs(first)):
        pieces = sm.Max(x, 0) + sm.Piecewise((2 * y, _strictly(0, argument)), (0, True))
        for found in both_derivatives(pieces, (2 * x, x), (0.0, 0.5)):
            np.testing.assert_array_equal(found, [1.0, 2.0])


def test_arbitrary_numbers_satisfy_no_simple_equation():
    numbers = [arbitrary_number(key) for key in range(-40, 40)]
    assert len({*numbers}) == 80
    assert all(1.0 <= number < 2.0 for number in numbers)
    random = Random(0)
    for _ in range(1000):
        a, b, c, d = random.sample(numbers, 4)
        assert a + d != b + c
        assert (a + b) + c - a - b - c == 0.0  # sums have no rounding errors
    # Also those of neighbours, such as the differences of coordinates in a chain.
    assert all(a + d != b + c for a, b, c, d in zip(*(numbers[k:] for k in range(4)), strict=False))
