"""The checks that all arguments share: what they take, and what they say of the rest."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pydy._checks import choice, flag, number, path_of, real_array, text, whole


@pytest.mark.parametrize("value", [True, 1, np.True_])
def test_a_flag_is_true_or_false_or_stands_for_it(value):
    assert flag(value, "`product`") is True


@pytest.mark.parametrize("value", ["no", None, 2, [], np.array([True])])
def test_what_has_a_truth_value_is_no_flag(value):
    with pytest.raises(TypeError, match="`product` must be True or False, got"):
        flag(value, "`product`")


@pytest.mark.parametrize("value", [3, 3.0, np.int64(3), np.float32(3.0)])
def test_whole_numbers_come_in_many_types(value):
    assert whole(value, "`workers`") == 3


@pytest.mark.parametrize("value", [0, True, 1.5, np.nan, np.inf, "3", [1, 2], None])
def test_what_is_no_whole_number_is_named(value):
    with pytest.raises(ValueError, match="`workers` must be a"):
        whole(value, "`workers`")


def test_an_option_of_any_string_type_is_found():
    assert choice(np.str_("b"), ("a", "b"), "`of`") == "b"


@pytest.mark.parametrize("value", [[], {}, np.array(["a", "b"]), np.ones((2, 2)), True, None, "c"])
def test_what_is_no_option_is_named_even_if_it_cannot_be_compared(value):
    with pytest.raises(ValueError, match="`of` must be one of 'a', 'b', 1, got"):
        choice(value, ("a", "b", 1), "`of`")


@pytest.mark.parametrize("value", [None, 5, b"title"])
def test_what_is_no_string_is_named(value):
    with pytest.raises(TypeError, match="`title` must be a string, got"):
        text(value, "`title`")


def test_paths_are_strings_or_paths():
    assert path_of("a", "`path`") == path_of(Path("a"), "`path`") == Path("a")


@pytest.mark.parametrize("value", [None, 5, b"a", "a\0b", ["a"]])
def test_what_is_no_path_is_named(value):
    with pytest.raises(TypeError, match="`path` must be a path, got"):
        path_of(value, "`path`")


@pytest.mark.parametrize("value", [np.complex64(1.0), 1 + 0j, np.array([1 + 0j])])
def test_complex_numbers_are_refused_though_their_imaginary_part_is_zero(value):
    with pytest.raises(ValueError, match="`gain` must be a real number"):
        number(value, "`gain`")
    with pytest.raises(ValueError, match="`x` must hold real numbers"):
        real_array(value, "`x`")


def test_a_list_in_itself_is_refused():
    value = []
    value.append(value)
    with pytest.raises(ValueError, match="`x` must hold real numbers"):
        real_array(value, "`x`")
