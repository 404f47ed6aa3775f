"""Random road profiles of ISO 8608: PSD, RMS and expressions; profiles of samples."""

import numpy as np
import pytest
import sympy as sm
from scipy.signal import welch

from pydy.vehicles import RoadProfile, iso_road

# ISO 8608, Table C.1: limits of G_d(n₀) in 10⁻⁶ m³; A has no lower limit, H no upper one.
LIMITS = {
    "A": (8, 32), "B": (32, 128), "C": (128, 512), "D": (512, 2048), "E": (2048, 8192),
    "F": (8192, 32768), "G": (32768, 131072), "H": (131072, 524288),
}  # fmt: skip


@pytest.mark.parametrize("road_class", LIMITS)
def test_the_psd_by_welch_is_that_of_the_class(road_class):
    length, count = 400.0, 4000
    x = np.arange(count) * length / count
    lower, upper = LIMITS[road_class]
    expected = np.sqrt(lower * upper) * 1e-6
    profile = iso_road(road_class, length, shortest=1.0, seed=3)
    n, density = welch(profile.height(x), fs=count / length, nperseg=1000, window="hann")
    normalised = density * (n / 0.1) ** 2 / expected
    # Of one random road, averaged over bands; the limits of the class are 0.5 and 2.
    for low, high in ((0.05, 0.15), (0.1, 0.3), (0.3, 0.9)):
        band = (n > low) & (n < high)
        assert normalised[band].mean() == pytest.approx(1.0, abs=0.35)
    assert density[n > 1.2].max() < 1e-3 * density[n > 0.05].max()


def test_the_periodogram_over_the_length_is_the_psd_at_each_frequency():
    length, count = 100.0, 1000
    profile = iso_road("B", length, longest=50.0, shortest=0.5, seed=0)
    z = profile.height(np.arange(count) * length / count)
    density = 2 * np.abs(np.fft.rfft(z)) ** 2 / count**2 * length
    n = np.arange(len(density)) / length
    inside = slice(10, 199)
    # The mean of the PSD over the band of a frequency, 1/(n² − Δn²/4).
    expected = 64e-6 * 0.1**2 / (n[inside] ** 2 - 0.25 / length**2)
    np.testing.assert_allclose(density[inside], expected, rtol=1e-9)
    assert density[:2].max() < 1e-25
    assert density[201:].max() < 1e-25


@pytest.mark.parametrize(("longest", "shortest"), [(100.0, 0.5), (90.9, 0.353), (30.0, 7.0)])
def test_the_rms_is_the_integral_of_the_psd(longest, shortest):
    profile = iso_road("D", 200.0, longest=longest, shortest=shortest, seed=7)
    expected = 0.1 * np.sqrt(1024e-6 * (longest - shortest))
    assert profile.rms == pytest.approx(expected, rel=1e-12)
    z = profile.height(np.linspace(0.0, 200.0, 4000, endpoint=False))
    assert z.std() == pytest.approx(expected, rel=1e-6)


def test_a_seed_gives_the_same_road_again():
    first, again, other = (iso_road("C", 100.0, seed=seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(first.phases, again.phases)
    assert not np.allclose(first.phases, other.phases)
    assert first.height(0.0) == pytest.approx(first.height(100.0))
    assert not first.phases.flags.writeable


def test_numbers_arrays_and_expressions_agree():
    profile = iso_road("E", 50.0, longest=50.0, shortest=5.0, seed=4)
    x = sm.Symbol("x")
    places = np.array([0.0, 3.0, 17.5])
    expression = profile.height(x)
    numbers = [profile.height(p) for p in places]
    assert isinstance(numbers[0], float)
    np.testing.assert_allclose(profile.height(places), numbers, rtol=1e-13)
    np.testing.assert_allclose([float(expression.subs(x, p)) for p in places], numbers, rtol=1e-12)
    slopes = [float(expression.diff(x).subs(x, p)) for p in places]
    np.testing.assert_allclose(profile.slope(places), slopes, rtol=1e-12)
    assert float(profile.slope(x).subs(x, 3.0)) == pytest.approx(slopes[1])


@pytest.mark.parametrize("count", [4, 5, 32, 33])
def test_a_profile_of_samples_passes_through_them(count):
    x = 2.0 + 0.25 * np.arange(count)
    z = np.random.default_rng(5).normal(size=count)
    profile = RoadProfile.from_samples(x, z)
    np.testing.assert_allclose(profile.height(x), z, atol=1e-12)
    # A smooth one is met between its samples too.
    wave = RoadProfile.from_samples(x, 1.0 + 0.1 * x + np.cos(2 * np.pi * x / (x[-1] - x[0])))
    between = np.linspace(x[0], x[-1], 50)
    expected = 1.0 + 0.1 * between + np.cos(2 * np.pi * between / (x[-1] - x[0]))
    np.testing.assert_allclose(wave.height(between), expected, atol=1e-12)
    assert len(wave.frequencies) < 3 or count < 5


def test_a_profile_of_equal_samples_is_flat():
    flat = RoadProfile.from_samples([0.0, 1.0, 2.0], [0.3, 0.3, 0.3])
    assert (flat.height(0.7), flat.slope(0.7), flat.rms) == (0.3, 0.0, 0.0)


@pytest.mark.parametrize(("step", "decimals"), [(1 / 3, 3), (1 / 7, 4), (0.25, 2), (25.4e-3, 15)])
def test_samples_at_places_of_few_digits_are_even(step, decimals):
    count = 22
    x = np.round(3.0 + step * np.arange(count), decimals)
    z = np.random.default_rng(6).normal(size=count)
    profile = RoadProfile.from_samples(x, z)
    even = np.linspace(x[0], x[-1], count)
    np.testing.assert_allclose(profile.height(even), z, atol=1e-12)


@pytest.mark.parametrize("x", [[0, 1, 3], [0, 0.333, 0.670, 1], [0, 0.333, 0.6671, 1], [0, 1, 2.1]])
def test_samples_that_are_not_even_within_their_digits_are_refused(x):
    with pytest.raises(ValueError, match="`x` must be ascending and evenly spaced"):
        RoadProfile.from_samples(x, np.zeros(len(x)))


def test_a_short_road_has_no_waves_that_are_longer():
    assert iso_road("C", 50.0, seed=1).rms == pytest.approx(
        iso_road("C", 50.0, longest=50.0, seed=1).rms, rel=1e-15
    )
    assert iso_road("C", 300.0, seed=1).rms == pytest.approx(
        0.1 * np.sqrt(256e-6 * (100.0 - 0.5)), rel=1e-12
    )


def test_a_band_beside_half_a_wave_number_has_a_wave():
    # 2.5 waves fit the length, and the band is as narrow as numbers allow.
    short = 0.95
    profile = iso_road("C", 2.5 * short, longest=np.nextafter(short, 3.0), shortest=short, seed=1)
    assert len(profile.frequencies) == 1
    assert profile.rms < 1e-6


def test_arguments_are_checked():
    with pytest.raises(ValueError, match="`road_class` must be"):
        iso_road("I", 100.0)
    with pytest.raises(ValueError, match="`longest` must be above `shortest`"):
        iso_road("A", 100.0, longest=200.0)
    with pytest.raises(ValueError, match="`length` must be at most 1048576 times `shortest`"):
        iso_road("A", 1e9)
    with pytest.raises(ValueError, match="`seed` must be"):
        iso_road("A", 100.0, seed=-1)
    with pytest.raises(ValueError, match="`x` must be ascending and evenly spaced"):
        RoadProfile.from_samples([0.0, 1.0, 3.0], [0.0, 0.0, 0.0])
    with pytest.raises(ValueError, match="`heights` must hold as many"):
        RoadProfile.from_samples([0.0, 1.0, 2.0], [0.0, 0.0])
    with pytest.raises(ValueError, match="`phases` must have as many values as `frequencies`"):
        RoadProfile([1.0, 2.0], [0.1, 0.1], [0.0])
