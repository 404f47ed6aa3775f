"""Sampled data as inputs: what they hold, what they give, what they refuse."""

import copy
import pickle

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from pydy.inputs import SampledInput, jumps_of

TIMES = np.array([0.5, 1.0, 2.5, 4.0])
VALUES = np.array([[1.0, -2.0], [3.0, 0.5], [-1.0, 0.5], [0.25, 4.0]])
KINDS = ["linear", "previous", "pchip"]
INSIDE = np.linspace(0.5, 4.0, 57)


def expected(kind, t):
    """Interpolated by NumPy and SciPy, end values held."""
    t = np.clip(t, TIMES[0], TIMES[-1])
    if kind == "linear":
        return np.stack([np.interp(t, TIMES, column) for column in VALUES.T], axis=1)
    if kind == "pchip":
        return PchipInterpolator(TIMES, VALUES)(t)
    return VALUES[[max(k for k in range(4) if TIMES[k] <= i) for i in t]]


@pytest.mark.parametrize("kind", KINDS)
def test_values_between_samples_are_interpolated(kind):
    samples = SampledInput(TIMES, VALUES, interpolation=kind)
    np.testing.assert_allclose(samples(INSIDE), expected(kind, INSIDE), rtol=0, atol=1e-14)


@pytest.mark.parametrize("kind", KINDS)
def test_samples_are_met_exactly(kind):
    samples = SampledInput(TIMES, VALUES, interpolation=kind)
    np.testing.assert_array_equal(samples(TIMES), VALUES)


@pytest.mark.parametrize("kind", KINDS)
def test_end_values_are_held_outside(kind):
    samples = SampledInput(TIMES, VALUES, interpolation=kind)
    outside = np.array([-np.inf, -3.0, 0.4999, 4.0, 4.0001, 1e9, np.inf])
    np.testing.assert_array_equal(samples(outside), VALUES[[0, 0, 0, 3, 3, 3, 3]])


@pytest.mark.parametrize("kind", KINDS)
def test_one_time_and_many_times_give_the_same_bits(kind):
    samples = SampledInput(TIMES, VALUES, interpolation=kind)
    t = np.concatenate([INSIDE, TIMES, [-1.0, 9.0]])
    np.testing.assert_array_equal(samples(t), [samples(i) for i in t.tolist()])


@pytest.mark.parametrize("kind", KINDS)
def test_breaks_and_coefficients_are_all_that_is_needed(kind):
    samples = SampledInput(TIMES, VALUES, interpolation=kind)
    assert samples.coefficients.shape == (3, 4, 2)
    for t in INSIDE[:-1]:
        i = np.searchsorted(samples.breaks, t, side="right") - 1
        for j in range(2):
            value = np.polyval(samples.coefficients[i, :, j], t - samples.breaks[i])
            np.testing.assert_allclose(value, samples(t)[j], rtol=1e-14, atol=1e-14)
    np.testing.assert_array_equal(samples.first, VALUES[0])
    np.testing.assert_array_equal(samples.last, VALUES[-1])


@pytest.mark.parametrize("kind", KINDS)
def test_slopes_are_those_after_a_time(kind):
    samples, step = SampledInput(TIMES, VALUES, kind), 1e-7
    for t in [*TIMES[:-1], *INSIDE[:-1]]:
        after = (samples(t + step) - samples(t)) / step
        np.testing.assert_allclose(samples.slopes_at(t), after, atol=1e-5)
    for t in (-1.0, TIMES[-1], 9.0):  # end values are held
        np.testing.assert_array_equal(samples.slopes_at(t), [0.0, 0.0])


def test_inputs_jump_where_one_of_their_quantities_does():
    values = [[1.0, 5.0], [1.0, 6.0], [1.0, 6.0], [2.0, 6.0], [3.0, 7.0]]
    held = SampledInput([0.0, 1.0, 2.0, 3.0, 4.0], values, "previous")
    line = SampledInput([0.0, 2.5], [0.0, 1.0])
    times = np.array([1.0, 3.0, 4.0])
    expected = np.stack([times, np.nextafter(times, 0.0), times], axis=1)
    np.testing.assert_array_equal(jumps_of([(None, held), (None, line)]), expected)


def test_nan_gives_nan():
    samples = SampledInput(TIMES, VALUES)
    assert np.isnan(samples(np.nan)).all()
    assert np.isnan(samples([np.nan, 1.0])).tolist() == [[True, True], [False, False]]


def test_shapes_follow_the_values():
    one, two = SampledInput(TIMES, VALUES[:, 0]), SampledInput(TIMES, VALUES)
    assert isinstance(one(1.0), float)
    assert one([1.0, 2.0]).shape == (2,)
    assert two(1.0).shape == (2,)
    assert two([1.0, 2.0, 3.0]).shape == (3, 2)
    assert (one.size, two.size) == (1, 2)


def test_lists_and_integers_are_taken():
    samples = SampledInput([0, 1, 2], [0, 10, 0], "linear")
    assert samples(0.5) == 5.0


def test_later_changes_of_the_users_arrays_do_not_matter():
    times, values = TIMES.copy(), VALUES.copy()
    samples = SampledInput(times, values)
    times[:] = values[:] = 0.0
    np.testing.assert_array_equal(samples(TIMES), VALUES)


@pytest.mark.parametrize("name", ["breaks", "coefficients", "times", "values", "first", "last"])
def test_its_arrays_cannot_be_changed(name):
    with pytest.raises(ValueError, match="read-only"):
        getattr(SampledInput(TIMES, VALUES), name)[0] = 1.0


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("way", [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_copy_is_equal_and_gives_the_same(way, kind):
    samples = SampledInput(TIMES, VALUES, kind)
    twin = way(samples)
    assert twin == samples
    assert hash(twin) == hash(samples)
    np.testing.assert_array_equal(twin(INSIDE), samples(INSIDE))


def test_equality_is_by_data():
    samples = SampledInput(TIMES, VALUES)
    assert samples == SampledInput(TIMES.tolist(), VALUES.tolist())
    assert samples != SampledInput(TIMES, VALUES, "previous")
    assert samples != SampledInput(TIMES, VALUES + 1e-12)
    assert samples != SampledInput(TIMES + 1.0, VALUES)
    assert samples != SampledInput(TIMES, VALUES[:, 0])
    assert samples != 3.0


def test_its_repr_says_what_it_holds():
    assert repr(SampledInput(TIMES, VALUES[:, 0])) == (
        "SampledInput(4 samples from t = 0.5 to 4.0, interpolation='linear')"
    )
    assert "4 samples of 2 values" in repr(SampledInput(TIMES, VALUES))


REFUSED = {
    "no times": (([], []), r"`times`.*at least two.*\(0,\)"),
    "one time": (([1.0], [2.0]), r"`times`.*at least two.*\(1,\).*give the number"),
    "times in a table": (([[0.0, 1.0]], [1.0, 2.0]), r"`times`.*one-dimensional.*\(1, 2\)"),
    "descending times": (([0.0, 2.0, 1.0], [1, 2, 3]), r"ascending, got 1.0 after 2.0 at index 2"),
    "repeated times": (([0.0, 1.0, 1.0], [1, 2, 3]), r"got 1.0 after 1.0 at index 2.*'previous'"),
    "a NaN time": (([0.0, np.nan], [1, 2]), r"`times`.*finite, got nan at index 1"),
    "times that are no numbers": ((["a", "b"], [1, 2]), r"`times`.*real numbers"),
    "a NaN value": (([0, 1], [1.0, np.nan]), r"`values`.*finite, got nan at index 1.*Drop"),
    "an infinite value": (([0, 1], [[1, 2], [3, np.inf]]), r"got inf at index \(1, 1\)"),
    "too few values": (([0, 1, 2], [1, 2]), r"`values`.*\(3,\) or \(3, k\).*\(2,\)"),
    "values across": (([0, 1, 2], np.ones((2, 3))), r"`values`.*\(3,\) or \(3, k\).*\(2, 3\)"),
    "no columns": (([0, 1], np.ones((2, 0))), r"`values`.*\(2, 0\)"),
    "a scalar value": (([0, 1], 3.0), r"`values`.*\(\)"),
    "complex values": (([0, 1], [1j, 2]), r"`values`.*real numbers"),
    "another kind": (([0, 1], [1, 2], "cubic"), r"`interpolation`.*'pchip', got 'cubic'"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_makes_no_sense_is_refused(name):
    arguments, message = REFUSED[name]
    with pytest.raises(ValueError, match=message):
        SampledInput(*arguments)


@pytest.mark.parametrize("interpolation", ["linear", "pchip"])
def test_slopes_beyond_the_range_of_floats_are_refused(interpolation):
    with pytest.raises(ValueError, match=r"slope of a SampledInput between times 0\.0 and 1e-320"):
        SampledInput([0.0, 1e-320, 3.0], [1.0, 2.0, 3.0], interpolation)


@pytest.mark.parametrize("values", [[-1e308, 1e308], [3.5e307, -8.9e307, 1.6e308, -1.2e308]])
def test_curves_beyond_the_range_of_floats_are_refused(values):
    """The slopes between the samples are finite, but not what the cubics add up."""
    times = 3.0 * np.arange(len(values))
    with pytest.raises(ValueError, match="beyond the range of floats"):
        SampledInput(times, values, "pchip")
    assert np.isfinite(
        SampledInput(times, np.divide(values, 100.0), "pchip")(np.linspace(0, 3))
    ).all()


def test_times_that_rounding_moves_off_the_ends_are_covered_however_far_they_are_from_zero():
    for start in (0.0, 1.7e9, -1e15):
        samples = SampledInput(start + np.array([0.0, 1.0, 2.0]), [0.0, 1.0, 0.0])
        assert samples.covers(np.nextafter(samples.times[[0, -1]], [-np.inf, np.inf]))
        assert not samples.covers(samples.times[-1:] + max(1.0, 1e-12 * abs(start)))
