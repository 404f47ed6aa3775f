"""The forces along coordinates that a power holds, against products written by hand."""

import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.work import forces_of_power, has_quotients, may_be_exact

X, Y, Z = me.dynamicsymbols("x y z")
U, V, W = SPEEDS = me.dynamicsymbols("u v w")
K, C = sm.symbols("k c")


def test_the_forces_of_a_spring_between_neighbours_cancel_along_the_rates_before():
    powers = [-K * Z * (U + V + W), K * Z * (U + V)]
    assert forces_of_power(powers, SPEEDS) == {W: -K * Z}


def test_factors_numbers_and_nested_sums_are_collected():
    power = 2 * K * (X * (U - 3 * V) + C * (Y * U + W / 2))
    expected = {U: 2 * K * X + 2 * C * K * Y, V: -6 * K * X, W: C * K}
    assert forces_of_power([power], SPEEDS) == expected


def test_sums_of_coefficients_that_are_equal_when_multiplied_out_cancel():
    assert forces_of_power([(K + C) * X * U, -K * X * U, -C * X * U], SPEEDS) == {}


def test_powers_that_are_not_linear_in_the_speeds_have_none():
    for power in (U * V, U**2, sm.sin(U), K * X, 1 / U, (1 + U) * X):
        assert forces_of_power([power], SPEEDS) is None


def test_work_whose_forces_have_unequal_cross_derivatives_depends_on_the_path():
    powers = [K * X * Y * U, K * (Y * U + X * V)]
    assert may_be_exact([*powers, X * Y * U + X**2 * V], {U: X, V: Y}, []) == [
        True,  # only one force
        True,  # of the potential k x y
        False,  # ∂F_x/∂y = x, ∂F_y/∂x = 2 x
        False,  # the sum
    ]


def test_a_force_that_is_zero_when_multiplied_out_is_not_compared():
    """A constraint may fix the coordinate along which there is no force."""
    zero = (X + C) ** 2 - X**2 - 2 * C * X - C**2
    assert may_be_exact([K * X * Y * U + zero * V], {U: X, V: Y}, []) == [True, True]


def test_sums_in_denominators_and_roots_are_quotients():
    assert has_quotients(1 / (X + Y))
    assert has_quotients(K * sm.sqrt(X**2 + C))
    assert not has_quotients((X + Y) ** 2 + K / C + sm.sin(X + Y))
