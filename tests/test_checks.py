"""The checks that all arguments share: what they take, and what they say of the rest."""

from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import (
    choice,
    flag,
    integer,
    listed,
    number,
    real_array,
    shown,
    text,
    vector,
)
from pydy._files import path_of
from pydy.models import multi_mass_spring_damper

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


class Scalar:
    """A number with a unit, as pint has them: NumPy takes its number alone."""

    def __init__(self, magnitude, units="gram"):
        self._magnitude, self._units = magnitude, units

    magnitude = property(lambda self: self._magnitude)
    units = property(lambda self: self._units)

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self._magnitude, dtype)

    def __repr__(self):
        return f"<{self._magnitude} {self._units}>"


class Array(np.ndarray):
    """An array with a unit, as those of astropy."""

    unit = "mm"


@pytest.mark.parametrize("value", [Scalar(500.0), [Scalar(500.0)], np.ones(1).view(Array)])
@pytest.mark.parametrize("check", [number, real_array])
def test_units_are_refused_and_not_dropped(check, value):
    with pytest.raises(ValueError, match=r"(?s)`x` must be without units, got .*to_base_units"):
        check(value, "`x`")


def test_a_quantity_without_units_is_a_number():
    assert number(Scalar(2.0, "dimensionless"), "`x`") == 2.0


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


@pytest.mark.parametrize(
    ("value", "description"),
    [
        (np.zeros(8), "array([0., 0., 0., 0., 0., 0., 0., 0.])"),
        (np.zeros(101), "an array of the shape (101,)"),
        (np.zeros((3, 3), dtype=complex), "an array of the shape (3, 3) and the dtype complex128"),
        (np.ma.zeros(9), "a MaskedArray of the shape (9,)"),
        (sm.eye(2), "Matrix([ [1, 0], [0, 1]])"),
        ("a\n  b", r"'a\n  b'"),
    ],
)
def test_what_fills_no_line_is_described_by_its_shape(value, description):
    assert shown(value) == description


def test_a_table_is_described_by_its_shape():
    pd = pytest.importorskip("pandas")
    table = pd.DataFrame({"x": np.zeros(50), "y": np.zeros(50)})
    assert shown(table) == "a DataFrame of the shape (50, 2)"


def test_arrays_in_a_dictionary_are_cut():
    text = shown({"x": np.linspace(0.0, 1.0, 101), "y": np.zeros((50, 50))})
    assert len(text) <= 202  # with the mark of a cut
    assert "\n" not in text
    assert text.startswith("{'x': array([0.  , 0.01, ..., 0.99, 1.  ]")


def test_an_array_in_place_of_a_symbol_is_described():
    system = multi_mass_spring_damper()
    system.times = np.linspace(0.0, 1.0, 11)
    for call in (
        lambda key: system.find_periodic_orbit(1.0, moving=[key]),
        lambda key: system.linearize(inputs=[key]),
        lambda key: system.simulate()[key],
    ):
        with pytest.raises((ValueError, KeyError), match=r"`an array of the shape \(50,\)`"):
            call(np.linspace(0.0, 1.0, 50))


def test_an_integer_that_python_does_not_print_is_refused_by_its_type():
    with pytest.raises(ValueError, match="`x` must be a real number, got a list"):
        number([10**5000, 1], "`x`")


def test_a_vector_has_one_length():
    with pytest.raises(ValueError, match=r"`x` must have the shape \(3,\), got \(2,\)"):
        vector([1.0, 2.0], 3, "`x`")


@pytest.mark.parametrize("value", [True, 1, np.True_])
def test_a_flag_is_true_or_false_or_stands_for_it(value):
    assert flag(value, "`product`") is True


@pytest.mark.parametrize("value", ["no", None, 2, [], np.array([True])])
def test_what_has_a_truth_value_is_no_flag(value):
    with pytest.raises(TypeError, match="`product` must be True or False, got"):
        flag(value, "`product`")


@pytest.mark.parametrize("value", [3, 3.0, np.int64(3), np.float32(3.0)])
def test_whole_numbers_come_in_many_types(value):
    assert integer(value, "`workers`") == 3


@pytest.mark.parametrize("value", [0, True, 1.5, np.nan, np.inf, "3", [1, 2], None])
def test_what_is_no_whole_number_is_named(value):
    with pytest.raises(ValueError, match="`workers` must be a"):
        integer(value, "`workers`")


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


def test_a_path_needs_the_current_folder_and_is_no_url(monkeypatch):
    with pytest.raises(ValueError, match="`store` must be a path on this computer, got the URL"):
        path_of("s3://bucket/store", "`store`")

    def removed():
        raise FileNotFoundError(2, "No such file or directory")

    monkeypatch.setattr("os.getcwd", removed)
    with pytest.raises(FileNotFoundError, match=r"`path` is 'a.c', relative .* that was removed"):
        path_of("a.c", "`path`")
    assert str(path_of("/a.c", "`path`"))


def nested():
    value = []
    for _ in range(100_000):
        value = [value]
    return value


@pytest.mark.parametrize("argument", ["constants", "initial_conditions", "specifieds"])
def test_a_list_that_is_nested_deeply_is_a_named_error(argument):
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    key = {"constants": "m0", "initial_conditions": "x0", "specifieds": "f0"}[argument]
    with pytest.raises(ValueError, match=f"`{argument}.* nested more than 64 deep"):
        setattr(system, argument, {key: nested()})
    with pytest.raises(ValueError, match="nested more than 64 deep"):
        system.times = nested()
    with pytest.raises(ValueError, match="nested too deeply"):
        system.evaluate_jacobian(wrt=nested())


def test_an_array_that_is_broadcast_to_gigabytes_is_refused_with_its_size():
    system, large = multi_mass_spring_damper(1), np.broadcast_to(1.0, 10**9)
    text = "broadcast to 1,000,000,000 numbers"
    for call in (
        lambda: setattr(system, "times", large),
        lambda: system.evaluate_ode(x=large),
        lambda: system.evaluate_ode(p=large),
        lambda: system.integrate_ensemble(constants={"m0": large}, times=[0.0, 1.0]),
    ):
        with pytest.raises(ValueError, match=text):
            call()
    with pytest.raises(ValueError, match=text):
        system.evaluate_ode(x=[large, large])
    with pytest.raises(TypeError, match=text):
        system.evaluate_jacobian(wrt=large)
    with pytest.raises(ValueError, match=r"`constants\[k0\]` must be a real number"):
        system.constants = {"m0": 1.0, "c0": 1.0, "k0": large}


def test_numbers_and_flags_out_of_range_are_named():
    system = multi_mass_spring_damper(1)
    system.times = [0.0, 1.0]
    with pytest.raises(
        ValueError, match=r"`workers` must be a whole number below 2⁶³, got 1e\+308"
    ):
        system.integrate_ensemble(workers=1e308)
    with pytest.raises(TypeError, match="`control_sensitivities` must be True or False, got 'no'"):
        system.simulate(control_sensitivities="no")


def test_time_needs_no_value():
    system, t = multi_mass_spring_damper(1, apply_external_forces=True), me.dynamicsymbols._t
    for values in ({t: 1.0}, {"t": 1.0}, {("f0", t): [1.0, 2.0]}):
        with pytest.raises(ValueError, match="`t` is the time, which is known"):
            system.specifieds = values


def test_ranges_and_arrays_of_more_than_memory_are_refused_by_their_size():
    for endless in (range(10**9), range(0, -(10**30), -1), np.broadcast_to(1.0, (10**9,))):
        with pytest.raises((TypeError, ValueError), match=r"`x` must .*(range\(|1,000,000,000)"):
            real_array(endless, "`x`")
        with pytest.raises(TypeError, match=r"`x` must be a sequence of .*(range\(|1,000,000,000)"):
            listed("x", endless)
    assert real_array(range(10, -(10**9)), "`x`").shape == (0,)
    assert listed("x", range(3)) == [0, 1, 2]
