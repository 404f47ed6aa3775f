"""The curves of a page: peaks and jumps between the pictures of a film, with their values."""

import pickle
from base64 import b64decode

import numpy as np
import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.contact import Contacts
from pydy.models import multi_mass_spring_damper
from pydy.plot import plot_energy, plot_phase
from pydy.trajectory import Trajectory
from pydy.viz import Scene, Sphere, Visual
from pydy.viz.curves import BUCKETS, UNTHINNED, TimeSeries, thinned
from pydy.viz.page import page_data
from zoo.exported_models import ball as bouncing_ball
from zoo.touching import ball, y

q = dynamicsymbols("q")
N, O = ReferenceFrame("N"), Point("O")
P = O.locatenew("P", q * N.x)
PEAK = 129.6


def floats(text):
    return np.frombuffer(b64decode(text), "<f8")


def curves_of(scene):
    """The curves in the data of a page, by label."""
    data = page_data(scene._animation, scene._settings)
    clocks = [floats(text) for text in data["clocks"]]
    return {
        entry["label"]: (clocks[entry["clock"]], floats(entry["values"]))
        for entry in data["series"]
    }


def moved(times, states, **options):
    made = Scene(N, O, Visual(Sphere(1), P), series={"3 q": 3 * q})
    return made.animate(times, states[:, None], symbols=[q], **options)


@pytest.mark.parametrize("start", [0.0, 1e9])
@pytest.mark.parametrize("count", [1_001, 100_001])
def test_a_peak_between_two_pictures_is_in_the_page_with_its_value_and_time(start, count):
    times = start + np.linspace(0.0, 1.0, count)
    values = np.zeros(count)
    values[count * 61 // 100] = PEAK
    scene = moved(times, values, series={"force": 1e9 + values})
    assert len(scene.times) < 70
    for label, low, high in (("3 q", 0.0, 3 * PEAK), ("force", 1e9, 1e9 + PEAK)):
        own, drawn = curves_of(scene)[label]
        assert (drawn.min(), drawn.max()) == (low, high)
        assert own[drawn.argmax()] == times[values.argmax()]
        assert (own[0], own[-1], len(own) <= UNTHINNED) == (times[0], times[-1], True)


def test_a_thinned_curve_covers_the_same_pixels():
    random = np.random.default_rng(3)
    times = np.sort(random.uniform(0.0, 1.0, 200_000)) ** 2
    values = random.normal(size=200_000).cumsum()
    own, drawn = thinned(TimeSeries(times, values))
    assert len(own) <= UNTHINNED

    def pixels(t, v):
        column = np.minimum((BUCKETS * (t - times[0]) / np.ptp(times)).astype(int), BUCKETS - 1)
        first = np.flatnonzero(np.diff(column, prepend=-1))
        return column[first], np.minimum.reduceat(v, first), np.maximum.reduceat(v, first), v[first]

    for whole, few in zip(pixels(times, values), pixels(own, drawn), strict=True):
        np.testing.assert_array_equal(few, whole)


@pytest.mark.parametrize("scale", [1e-300, 1.0, 1e300])
def test_jumps_and_gaps_of_a_thinned_curve_stay(scale):
    times, values = np.linspace(0.0, 1.0, 100_001), np.zeros(100_001)
    times[50_021] = times[50_020]  # within a part of the time
    values[50_021:] = -scale
    values[50_030:] = -2.0 * scale  # the value after the jump is not the lowest of its part
    values[20_000:20_007] = np.nan
    own, drawn = thinned(TimeSeries(times, values))
    (k,) = np.flatnonzero(np.diff(own) == 0.0)
    assert own[k] == times[50_020]
    assert drawn[k : k + 2].tolist() == [0.0, -scale]
    gaps = np.flatnonzero(np.isnan(drawn))
    assert len(gaps)
    assert np.abs(own[gaps] - 0.2).max() <= 1 / BUCKETS


def test_the_points_of_a_curve_are_bounded_whatever_it_does():
    times = np.repeat(np.linspace(0.0, 1.0, 100_000), 3)
    values = np.random.default_rng(4).normal(size=300_000)
    values[::5] = np.nan
    assert len(thinned(TimeSeries(times, values)).times) <= 7 * BUCKETS
    still = thinned(TimeSeries(np.zeros(300_000), values))
    assert len(still.times) <= 7
    assert np.nanmax(still.values) == np.nanmax(values)


def test_curves_with_the_same_times_share_them_on_the_page():
    times = np.linspace(0.0, 1.0, 1001)
    scene = moved(times, times, series={"other": times**2})
    data = page_data(scene._animation, scene._settings)
    assert [entry["clock"] for entry in data["series"]] == [0, 0]
    np.testing.assert_array_equal(floats(data["clocks"][0]), times)


def test_what_a_solver_does_between_the_pictures_is_drawn():
    system = multi_mass_spring_damper()
    system.constants = {"k0": 1e6, "c0": 0.0}  # 159 swings a second, of which no picture is true
    system.initial_conditions = {"x0": 1.0}
    system.times, system.ode_solver = np.linspace(0.0, 0.5, 4), "dop853"
    trajectory = system.simulate(rtol=1e-9, atol=1e-9)
    x0, v0 = trajectory.state_symbols
    scene = system.scene(series=["x0", x0**2 + (v0 / 1000) ** 2]).animate(trajectory, speed=1.0)
    assert len(scene.times) < 40
    (times, x), (_, energy) = curves_of(scene).values()
    np.testing.assert_allclose(x, np.cos(1000 * times), atol=1e-5)
    np.testing.assert_allclose(energy, 1.0, atol=1e-5)
    turns = np.round(1000 * times / np.pi)
    peaks = [np.abs(x[turns == turn]).max() for turn in range(int(turns[-1]))]
    assert min(peaks) > 0.995
    again = pickle.loads(pickle.dumps(scene))
    again.visuals[0].name = "renamed"
    np.testing.assert_array_equal(curves_of(again)["x0"], (times, x))


def jump_at(curve, time):
    """The values before and after a time, which must be there twice."""
    times, values = curve
    k = np.flatnonzero(times == time)
    assert len(k) == 2, len(k)
    return values[k]


@pytest.mark.parametrize("solver", ["dop853", "odeint"])
def test_a_speed_that_jumps_at_an_event_is_drawn_vertically(solver, tmp_path):
    system, bounce = bouncing_ball()
    trajectory = system.simulate(rtol=1e-9, atol=1e-9, events=bounce)
    if solver == "odeint":  # no solver's own interpolant is left: between the times, and a file
        trajectory = pickle.loads(pickle.dumps(trajectory))
    v = trajectory.speeds_symbols[0]
    scene = system.scene(series={"v": v, "half": v / 2}).animate(trajectory)
    curves = curves_of(scene)
    for event in trajectory.events:
        before, after = event.before[1], event.after[1]
        assert jump_at(curves["v"], event.time).tolist() == [before, after]
        assert jump_at(curves["half"], event.time).tolist() == [before / 2, after / 2]
        assert after == pytest.approx(-0.8 * before)


def test_a_contact_force_begins_and_ends_at_once():
    system, floor = ball(restitution=0.0)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 2.0, 21)
    trajectory = Contacts(system, [floor]).simulate(rtol=1e-9, atol=1e-9)
    force = f"{floor.name}_normal"
    curve = curves_of(system.scene(series=[force]).animate(trajectory))[force]
    (closes,) = (e.time for e in trajectory.events if e.name.endswith("closes"))
    weight = trajectory[force][-1]
    assert weight > 0.0
    before, after = jump_at(curve, closes)
    assert (before, after) == (0.0, pytest.approx(weight))


@pytest.mark.parametrize("stored", [False, True])
def test_plots_draw_jumps_at_their_events(stored, tmp_path):
    plt = pytest.importorskip("matplotlib.pyplot")
    pytest.importorskip("xarray")
    system, bounce = bouncing_ball()
    trajectory = system.simulate(rtol=1e-9, atol=1e-9, events=bounce)
    energy = trajectory.energy
    if stored:
        trajectory.save(tmp_path / "motion.nc")
        trajectory = Trajectory.load(tmp_path / "motion.nc")
    lines = [trajectory.plot(["v"]).lines[0]]
    (phase,), (kinetic, *_) = (
        [line for line in ax.lines if len(line.get_xdata()) > 1]
        for ax in (plot_phase(trajectory, "v"), plot_energy(trajectory))
    )
    plt.close("all")
    for event in trajectory.events:
        before, after = event.before[1], event.after[1]
        assert jump_at(lines[0].get_data(), event.time).tolist() == [before, after]
        if not stored:  # a file knows energies at its times alone
            found = jump_at(kinetic.get_data(), event.time)
            assert found == pytest.approx([0.1 * before**2, 0.1 * after**2])
    np.testing.assert_allclose(phase.get_ydata(), -9.81, rtol=1e-12)
    assert len(kinetic.get_xdata()) == len(lines[0].get_xdata())
    assert np.nanmax(kinetic.get_ydata()) >= energy[:, 0].max()
