"""What is zero, small and dependent, whatever the units."""

import numpy as np
import pytest

from pydy._rank import (
    ROUNDING,
    equilibrated,
    independent_columns,
    is_zero,
    least_step,
    null_space,
    rank,
    roundings,
)

RNG = np.random.default_rng(0)
UNITS = [1e-12, 1e-6, 1.0, 1e9]


def test_a_value_is_zero_by_its_terms_alone():
    third = 1.0 / 3.0
    left = 1e9 * (0.1 + 0.2 - 0.3)
    assert is_zero(left, 1e9)
    assert not is_zero(left, third)
    assert is_zero(np.array([0.0, np.nan]), np.array([0.0, 1.0])).tolist() == [True, False]


@pytest.mark.parametrize("row", UNITS)
@pytest.mark.parametrize("column", UNITS)
def test_ranks_do_not_depend_on_the_units_of_rows_and_columns(row, column):
    rows = RNG.uniform(-1.0, 1.0, (3, 5))
    rows = np.vstack([rows, rows[0] - rows[2]])
    rows[1] *= row
    rows[:, 3:] *= column
    assert rank(rows) == 3
    free, units = null_space(rows)
    assert free.shape == (2, 5)
    left = rows @ (free * units).T
    assert is_zero(left, np.abs(rows) @ np.abs(free * units).T).all()
    chosen = independent_columns(equilibrated(rows)[0])
    assert rank(rows[:, chosen]) == len(chosen) == 3


def test_a_column_of_rounding_errors_is_no_direction():
    rows = RNG.uniform(-1.0, 1.0, (3, 4))
    rows[:, 2] = ROUNDING * RNG.uniform(-1.0, 1.0, 3)
    assert equilibrated(rows)[2][0, 2] < 10.0
    assert rank(np.delete(rows, [0], axis=1)) == 2


@pytest.mark.parametrize("length", [1e-18, 1e-13, 1e13, 1e18])
def test_what_is_small_in_the_users_units_is_no_rounding(length):
    """x = l sin θ and y = −l cos θ, with θ = 1e-17 for a zero in the second."""
    rows = np.array([[1.0, 0.0, -length], [0.0, 1.0, -1e-17 * length]])
    units = np.array([1.0, 1.0, 1.0 / length])
    assert rank(rows, units=units) == 2
    free, columns = null_space(rows, units)
    moved = (free * columns)[0]
    np.testing.assert_allclose(moved / moved[0] / units, [1.0, 0.0, 1.0], atol=1e-16)
    rows[1, 2] = -length
    step = least_step(rows[:, 1:], length * np.array([2.0, 3.0]), units[1:])
    np.testing.assert_allclose(step, [length, -2.0], rtol=1e-12)


@pytest.mark.parametrize("unit", UNITS)
def test_steps_follow_the_units_of_unknowns(unit):
    rows, values = RNG.uniform(-1.0, 1.0, (2, 4)), RNG.uniform(-1.0, 1.0, 2)
    scale = np.array([1.0, unit, unit, 1.0])
    step = least_step(rows * scale, values)
    np.testing.assert_allclose(rows @ (scale * step), values, rtol=1e-12)
    many = least_step(rows * scale, np.stack([values, -values], axis=1))
    np.testing.assert_allclose(many, np.stack([step, -step], axis=1), rtol=1e-12)
    several = least_step(np.stack([rows, 2.0 * rows]), np.stack([values, values]))
    np.testing.assert_allclose(rows @ several[1], 0.5 * values, rtol=1e-12)


@pytest.mark.parametrize("row", UNITS)
@pytest.mark.parametrize("column", UNITS)
def test_roundings_of_a_row_are_those_of_the_rows_that_hold_its_unknowns(row, column):
    slopes = np.array([[1.0, 0.0, 0.5, 0.0], [0.0, 1.0, 2.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
    sizes = np.array([7.0, 1e-20, 1e-20])
    rows, columns = np.array([1.0, row, 1.0]), np.array([1.0, column, 1.0, 1.0])
    found = roundings(rows[:, None] * slopes * columns, rows * sizes) / rows
    assert 7.0 <= found[0] / 2.0**-42 <= 70.0
    assert 1.0 <= found[1] / 2.0**-42 <= 140.0
    assert found[2] <= 1e-30


def test_nothing_is_of_one_size_already():
    for scaled in equilibrated(np.zeros((2, 0, 3))):
        assert scaled.shape[0] == 2
    assert equilibrated(np.zeros((0, 3)))[2].tolist() == [[1.0, 1.0, 1.0]]
