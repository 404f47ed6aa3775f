"""What passes for a number, and for an array of them."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sm

from pydy._checks import number, real_array, vector

MASKED = np.ma.array([1.0, 2.0], mask=[False, True])


@pytest.mark.parametrize(
    "value",
    [2, 2.0, np.float32(2), np.array([2.0]), sm.Integer(2), Decimal(2), Fraction(2), True + 1],
)
def test_every_kind_of_real_number_is_taken(value):
    assert number(value, "`x`") == 2.0


@pytest.mark.parametrize("value", ["1.5", b"1.5", np.str_("1.5"), np.array(["1"], dtype=object)])
@pytest.mark.parametrize("check", [number, real_array])
def test_text_is_not_a_number(check, value):
    with pytest.raises(ValueError, match=r"`x` must .*real number.*, got .*1"):
        check(value, "`x`")


@pytest.mark.parametrize("value", [10**400, sm.Integer(10) ** 400, [1.0, -(10**400)]])
def test_a_number_beyond_the_range_of_floats_is_refused(value):
    with pytest.raises(ValueError, match=r"`x` .* beyond the range of floats"):
        real_array(value, "`x`")
    if not isinstance(value, list):
        with pytest.raises(ValueError, match=r"`x` .* beyond the range of floats"):
            number(value, "`x`")


@pytest.mark.parametrize(
    "value", [MASKED, np.ma.masked, [1.0, np.ma.masked], [[1.0, np.ma.masked]]]
)
@pytest.mark.parametrize("check", [number, real_array])
def test_masked_entries_are_refused(check, value):
    with pytest.raises(ValueError, match=r"(?s)`x` must not have masked entries.*filled"):
        check(value, "`x`")


def test_a_masked_array_without_masked_entries_is_an_array():
    assert real_array(np.ma.array([1.0, 2.0]), "`x`").tolist() == [1.0, 2.0]


def test_infinity_of_sympy_stays_infinity():
    assert number(sm.oo, "`x`") == np.inf


@pytest.mark.parametrize("value", [np.datetime64("2020-01-01"), 1j, None, {}, [[1.0], [1.0, 2.0]]])
@pytest.mark.parametrize("check", [number, real_array])
def test_what_is_no_number_is_refused(check, value):
    with pytest.raises(ValueError, match="`x` must"):
        check(value, "`x`")


def test_a_long_value_is_cut_in_the_message():
    with pytest.raises(ValueError, match="…") as info:
        number(list(range(500)), "`x`")
    assert len(str(info.value)) < 300


def test_an_integer_that_python_does_not_print_is_refused_by_its_type():
    with pytest.raises(ValueError, match="`x` must be a real number, got a list"):
        number([10**5000, 1], "`x`")


def test_a_vector_has_one_length():
    with pytest.raises(ValueError, match=r"`x` must have the shape \(3,\), got \(2,\)"):
        vector([1.0, 2.0], 3, "`x`")
