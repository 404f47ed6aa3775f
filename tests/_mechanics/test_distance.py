"""Which expressions may depend on a distance alone, against ones written by hand."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.distance import may_depend_on

X, Y, V = MOVING = me.dynamicsymbols("x y v")
K, L = sm.symbols("k l", positive=True)


@pytest.mark.parametrize("unit", [1e-9, 1, 1e9])
def test_laws_of_the_distance_alone_are_told_from_others_in_any_unit(unit):
    square = (unit * (X + Y)) ** 2 + (unit * X) ** 2
    distance = sm.sqrt(square)
    for law in (K * (distance - unit * L) / distance, K / square**2, sm.exp(-K * distance / unit)):
        assert may_depend_on(law, square, MOVING)
        for other in (X, V, 1e-3 * Y):
            assert not may_depend_on(law * (1 + other), square, MOVING)


def test_a_distance_that_was_rounded_in_another_way_is_the_same():
    square = (0.1 * X + 0.3 * Y) ** 2
    assert may_depend_on(K * (0.1 * (X + 3.0000000000000004 * Y)) ** 2, square, MOVING)


def test_a_force_between_neighbours_does_not_depend_on_the_distance_from_the_ground():
    assert not may_depend_on(K * Y / (X + Y), (X + Y) ** 2, MOVING)
