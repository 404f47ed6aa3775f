"""Tracks against closed forms, vehicles along them against the plane, and least times."""

from copy import copy
from functools import cache

import numpy as np
import pytest
import sympy as sm
from scipy.special import fresnel
from sympy.physics.mechanics import dynamicsymbols

from gallery import definitions
from pydy.vehicles import CARS, car_trailer, commonroad_car, double_track, single_track
from pydy.vehicles.tracks import Track, along, read_track
from zoo.race_cars import friction_circle, point_mass


def circle_of_points(count, radius=100.0):
    angles = 2 * np.pi * np.arange(count) / count
    return radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


# ---- Roads ----


def test_a_spline_through_points_of_a_circle_is_that_circle():
    errors = []
    for count in (20, 40):
        track = Track.through(circle_of_points(count), 5.0, 4.0)
        s = np.linspace(0.0, 1.5 * track.length, 101)
        # The spline is of the fifth degree: its curvature has an error of the fourth order.
        errors.append(np.abs(track.curvature(s) - 0.01).max())
        assert track.length == pytest.approx(200 * np.pi, rel=1e-7)
        assert track.heading(s) == pytest.approx(np.pi / 2 + s / 100, abs=1e-5)
        expected = 98.0 * np.stack([np.cos(s / 100), np.sin(s / 100)], axis=1)
        assert track.position(s, 2.0) == pytest.approx(expected, abs=1e-3)
    assert errors[1] < errors[0] / 12
    assert errors[1] < 1e-7


def test_the_arc_length_of_a_spline_is_that_of_its_curve():
    x = np.linspace(0.0, 60.0, 61)
    track = Track.through(np.stack([x, x**2 / 60], axis=1), 3.0, 3.0, closed=False)
    slope = 2.0  # at the end of the parabola x²/60
    exact = 15.0 * (slope * np.sqrt(1 + slope**2) + np.arcsinh(slope))
    assert track.length == pytest.approx(exact, rel=1e-9)
    s = np.linspace(0.0, track.length, 40001)
    steps = np.hypot(*np.diff(track.position(s), axis=0).T)
    assert steps == pytest.approx(np.diff(s), rel=1e-6)
    assert track.curvature(30.0) == pytest.approx(
        np.interp(30.0, s, np.gradient(track.heading(s), s)), rel=1e-5
    )


def test_smoothing_removes_errors_of_measured_points():
    random, exact = np.random.default_rng(1), circle_of_points(200)
    measured = exact + random.normal(0.0, 0.05, exact.shape)
    rough, smooth = (Track.through(measured, 5.0, 5.0, smoothing=e) for e in (0.0, 0.07))
    s = np.linspace(0.0, 600.0, 601)
    off = [np.abs(track.curvature(s) - 0.01).max() for track in (rough, smooth)]
    assert off[1] < off[0] / 5


def test_a_clothoid_is_a_fresnel_integral():
    length, curvature = 40.0, 0.05
    track = Track.segments([(length, 0.0, curvature)], 2.0, 2.0, closed=False)
    s = np.linspace(0.0, length, 9)
    scale = np.sqrt(np.pi * length / curvature)
    y, x = fresnel(s / scale)
    assert track.position(s) == pytest.approx(scale * np.stack([x, y], axis=1), abs=1e-12)
    assert track.heading(s) == pytest.approx(curvature * s**2 / (2 * length), abs=1e-14)


def test_an_oval_is_straights_and_half_circles():
    track = Track.oval(200.0, 50.0, width=10.0)
    assert track.length == pytest.approx(400.0 + 100.0 * np.pi)
    top = track.position([200.0 + 25.0 * np.pi, 200.0 + 50.0 * np.pi], [0.0, 5.0])
    assert top == pytest.approx(np.array([[250.0, 50.0], [200.0, 95.0]]))
    assert track.curvature([0.0, 199.0, 200.0, 357.0, 358.0]).tolist() == [
        0.0,
        0.0,
        0.02,
        0.02,
        0.0,
    ]
    assert track.heading(3 * track.length) == pytest.approx(6 * np.pi)
    assert np.ptp(track._line.curvature_input()(np.linspace(201.0, 356.0, 9))) == 0.0


@pytest.mark.parametrize(
    "track",
    [
        Track.oval(200.0, 50.0, 10.0),
        Track.segments([(50, 0), (40, 0, 0.02), (30, 0.02), (40, 0.02, -0.01)], 4, 4, closed=False),
    ],
)
def test_points_are_located_by_their_arc_length_and_offset(track):
    s = np.linspace(0.5, track.length - 0.5, 77)
    n = 4.0 * np.sin(s)
    located = track.locate(track.position(s, n))
    assert located[0] == pytest.approx(s, abs=1e-9)
    assert located[1] == pytest.approx(n, abs=1e-9)


def test_a_jump_of_the_curvature_beside_a_clothoid_is_a_short_ramp():
    track = Track.segments([(50, 0), (40, 0, 0.02), (30, 0.04), (50, 0)], 4, 4, closed=False)
    samples, s = track._line.curvature_input(), np.linspace(0.0, 170.0, 399)
    assert samples(s) == pytest.approx(track.curvature(s), abs=1e-9)


def test_a_file_of_points_and_widths_is_read(tmp_path):
    points = circle_of_points(30)
    rows = "".join(
        f"{x!r}; {y!r}; 5.0; {6.0 + k / 30}\n" for k, (x, y) in enumerate(points.tolist())
    )
    file = tmp_path / "ring.csv"
    file.write_text("# x_m,y_m,w_tr_right_m,w_tr_left_m\n" + rows, encoding="utf-8")
    track = read_track(file)
    assert track.breaks.shape == (31,)
    right, left = track.widths(track.breaks[:-1])
    assert right == pytest.approx(5.0)
    assert left == pytest.approx(6.0 + np.arange(30) / 30)
    again = Track.through(np.concatenate([points, points[:1]]), 5.0, np.append(left, 6.0))
    assert again.length == track.length


@pytest.mark.parametrize("content", ["1,2,3\n", "1,2,3,x\n"])
def test_a_line_of_a_file_that_is_no_row_is_named(tmp_path, content):
    file = tmp_path / "ring.csv"
    file.write_text("#\n" + content, encoding="utf-8")
    with pytest.raises(ValueError, match=r"Line 2 of `path`.* must have the four numbers"):
        read_track(file)


def test_segments_that_do_not_close_are_refused():
    with pytest.raises(ValueError, match="gap of 5 m and a turn of 360°"):
        Track.segments([*[(95.0, 0.0), (10.0 * np.pi, 0.1)] * 2, (5.0, 0.0)], 4.0, 4.0)
    with pytest.raises(ValueError, match=r"`s` must be a finite arc length.*from 0 to 10"):
        Track.segments([(10.0, 0.0)], 1.0, 1.0, closed=False).position(11.0)


def test_repeated_and_few_points_are_refused():
    points = circle_of_points(20)
    with pytest.raises(ValueError, match="twice, from index 3 on"):
        Track.through(np.insert(points, 3, points[3], axis=0), 1.0, 1.0)
    with pytest.raises(ValueError, match="`points` must be at least 6, got 5"):
        Track.through(points[:5], 1.0, 1.0)


def test_a_track_is_plotted():
    ax = Track.oval(200.0, 50.0, 10.0).plot()
    assert len(ax.lines) == 4
    assert ax.get_xlim()[1] > 255.0


# ---- Along a track ----

VEHICLES = {
    "single track": lambda: single_track(CARS["bmw_320i"], free_speed=True),
    "double track": lambda: double_track(CARS["bmw_320i"], speed=20.0, drag_area=0.7),
    "CommonRoad ST": lambda: commonroad_car("bmw_320i"),
    "trailer": lambda: car_trailer(
        CARS["bmw_320i"], mass=1200.0, yaw_inertia=2500.0, length=4.0, stiffness=7e4, speed=20.0,
        hitch=2.5, centre=4.2,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", VEHICLES)
def test_derivatives_along_a_track_are_those_in_the_plane(name):
    vehicle = VEHICLES[name]()
    track = Track.segments([(30, 0.0, 0.02), (80, 0.02)], 5.0, 5.0, closed=False)
    on_track = along(track, vehicle)
    random, s = np.random.default_rng(3), 70.0
    names = [str(q.func) for q in vehicle.states]
    usual = {str(k).removesuffix("(t)"): v for k, v in vehicle.initial_conditions.items()}
    state = {k: usual.get(k, 0.0) + 0.05 * random.uniform(-1.0, 1.0) for k in names}
    n, xi = 1.5, 0.1
    (x, y), heading = track.position(s, n), track.heading(s)
    inputs = {str(f.func): 0.02 for f in vehicle.specifieds_symbols}
    plane = dict(
        zip(
            names,
            vehicle.evaluate_ode({**state, "x": x, "y": y, "psi": heading + xi}, 0.0, r=inputs),
            strict=True,
        )
    )
    ahead = plane["x"] * np.cos(heading) + plane["y"] * np.sin(heading)
    aside = plane["y"] * np.cos(heading) - plane["x"] * np.sin(heading)
    pace = (1 - n * track.curvature(s)) / ahead
    expected = {k: rate * pace for k, rate in plane.items()}
    expected |= {"n": aside * pace, "xi": plane["psi"] * pace - track.curvature(s)}
    system = on_track.system
    states = [str(q.func) for q in system.states]
    rates = system.evaluate_ode(
        {**{k: v for k, v in state.items() if k in states}, "n": n, "xi": xi},
        s,
        r={**inputs, "curvature": track.curvature(s)},
    )
    assert rates == pytest.approx(np.array([expected[k] for k in states]), rel=1e-9, abs=1e-12)


def test_what_depends_on_direction_position_or_time_is_refused():
    track, t = Track.circle(50.0, 10.0), sm.Symbol("t")
    car = single_track(CARS["bmw_320i"], free_speed=True)
    with pytest.raises(ValueError, match=r"derivative of x.t. does not turn with delta"):
        along(track, commonroad_car("bmw_320i"), position=("x", "y", "delta"))
    with pytest.raises(ValueError, match="`position` must be three coordinates"):
        along(track, car, position=("x", "x", "psi"))
    with pytest.raises(ValueError, match="`inputs` must be one of"):
        along(track, car, inputs=["steering"])
    car.specifieds = {"delta": sm.sin(t)}
    with pytest.raises(ValueError, match="depends on time itself"):
        along(track, car, inputs=["F_x"])


def test_a_track_narrower_than_the_car_or_wider_than_its_radius_is_refused():
    car = point_mass()
    with pytest.raises(ValueError, match="`width` must be less than that of the track, got 10"):
        along(Track.circle(50.0, 10.0), car, width=10.0)
    with pytest.raises(ValueError, match="wider than its radius 4 m at s = 0 m"):
        along(Track.circle(4.0, 10.0), car)


def test_specifieds_that_are_no_inputs_keep_their_values():
    car = single_track(CARS["bmw_320i"], free_speed=True)
    car.specifieds = {"F_x": 321.0}
    on_track = along(Track.circle(50.0, 10.0), car, inputs=["delta"])
    assert {str(k): v for k, v in on_track.system.specifieds.items()}["F_x(t)"] == 321.0


# ---- Least times ----


def test_a_point_mass_drives_a_ring_at_its_inner_edge():
    radius, width, largest = 50.0, 10.0, 9.0
    on_track = along(Track.circle(radius, width), point_mass(speed=18.0), width=2.0)
    lap = on_track.least_time(path=friction_circle(largest), mesh=8)
    inner = radius - width / 2 + 1.0
    assert lap.time == pytest.approx(2 * np.pi * np.sqrt(inner / largest), rel=1e-7)
    assert np.hypot(*(lap.path - [0.0, radius]).T) == pytest.approx(inner, rel=1e-6)


def test_a_right_angle_takes_the_least_time_on_a_parabola():
    # With free space a velocity changes fastest by a constant acceleration: √2 v/a for 90°, on a
    # parabola; on the road of radius R it begins and ends at the offset R − v²/(√2 a).
    radius, speed, largest = 50.0, 20.0, 10.0
    track = Track.segments([(radius * np.pi / 2, 1 / radius)], 25.0, 25.0, closed=False)
    on_track = along(track, point_mass(speed))
    lap = on_track.least_time(
        start={"n": None}, end={"xi": 0.0, "u": speed}, path=friction_circle(largest), mesh=20
    )
    assert lap.time == pytest.approx(np.sqrt(2) * speed / largest, rel=1e-6)
    distance = speed**2 / (np.sqrt(2) * largest)
    assert lap.path[[0, -1]] == pytest.approx(
        np.array([[0.0, radius - distance], [distance, radius]]), abs=0.02
    )
    t = lap.times[:, None]
    way = t * [speed, 0.0] + t**2 / 2 * largest / np.sqrt(2) * [-1.0, 1.0]
    assert lap.path - lap.path[0] == pytest.approx(way, abs=0.02)


@cache
def car_on_oval():
    car = single_track(CARS["bmw_320i"], speed=20.0, free_speed=True)
    on_track = along(Track.oval(100.0, 30.0, width=10.0), car, width=1.6)
    (F_x,) = [f for f in on_track.system.specifieds_symbols if str(f) == "F_x(t)"]
    path = [(F_x / sm.Symbol("m")) ** 2 + sm.Symbol("a_y") ** 2 <= 64.0]
    lap = on_track.least_time(path=path, bounds={"F_x": (-8e3, 4e3), "delta": (-0.5, 0.5)}, mesh=50)
    return on_track, lap


def test_a_lap_is_a_motion_of_the_vehicle_in_the_plane():
    _, lap = car_on_oval()
    car = single_track(CARS["bmw_320i"], free_speed=True)
    motion = lap.trajectory
    car.specifieds = lap.inputs()
    car.times = motion.times[motion.times <= 4.0]
    car.initial_conditions = dict(zip(car.states, motion.states[0], strict=True))
    simulated = car.simulate(rtol=1e-9, atol=1e-9)
    apart = np.hypot(*(simulated[q] - motion[q][: len(car.times)] for q in ("x", "y")))
    assert apart.max() < 0.2  # of 80 m
    assert motion["a_y"] == pytest.approx(lap.motion["a_y"], abs=1e-9)
    speed = np.hypot(*(np.gradient(motion[q], motion.times) for q in ("x", "y")))
    assert speed[5:-5] == pytest.approx(lap.motion["speed"][5:-5], rel=0.05)


def test_a_lap_ends_as_it_begins_and_stays_on_the_road():
    _, lap = car_on_oval()
    assert lap.motion.states[-1] == pytest.approx(lap.motion.states[0], abs=1e-6)
    assert np.abs(lap.motion["n"]).max() <= (5.0 - 0.8) * (1 + 1e-12)
    assert np.hypot(*(lap.path[-1] - lap.path[0])) < 1e-6
    assert lap.time == pytest.approx(lap.motion.objective, rel=1e-3)
    # Between the fastest steady turns in the middle and at the inner edge for the whole length.
    assert lap.time < (200.0 + 60.0 * np.pi) / np.sqrt(8.0 * 30.0)
    assert repr(lap).startswith("<Lap of 388.5 m: ")


def test_a_lap_is_plotted():
    on_track, lap = car_on_oval()
    ax = lap.plot()
    assert ax.collections[0].get_array().max() == pytest.approx(lap.motion["speed"].max(), rel=0.02)
    with pytest.raises(ValueError, match="`quantity` must be one of"):
        lap.plot(quantity="fuel")
    with pytest.raises(ValueError, match="`motion` must be one of `system`"):
        on_track.lap(lap.trajectory)


# ---- A published lap ----


@cache
def race_car():
    """The car and the oval of the example of dymos, before its lap is searched for."""
    return definitions("race_car_lap", before="on_track = along(")


def race_car_lap(speed, mesh):
    script, t = race_car(), sm.Symbol("t")
    delta_rate, thrust_rate = dynamicsymbols("delta_rate thrust_rate")
    (initial,) = script.car.initial_conditions
    car = copy(script.car)
    car.initial_conditions = {initial: speed}
    on_track = along(script.track, car, periodic=True)
    return on_track, on_track.least_time(
        path=[*(sm.Symbol(name) <= 1 for name in script.used), sm.Symbol("power") <= script.POWER],
        bounds={"V": (5.0, 120.0), "delta": (-0.5, 0.5), "thrust": (-3.0, 3.0)},
        cost=sm.Integral(1e-4 * delta_rate**2 + 1e-7 * thrust_rate**2, t),
        mesh=mesh,
    )


def test_the_guess_of_a_search_has_zeros_in_place_of_rounding_errors():
    script = race_car()
    guess = along(script.track, script.car, periodic=True).guess()
    guess = {str(k.func): np.atleast_1d(v) for k, v in guess.items()}
    assert not guess["a_x"].any()  # the load's lag: no acceleration ahead in a steady turn
    for name in ("lambda_", "delta", "a_y", "thrust"):
        assert np.abs(guess[name]).max() > 1e-4


def test_the_race_car_of_dymos_takes_the_published_time_from_different_guesses():
    (_, slow), (_, fast) = (race_car_lap(speed, 200) for speed in (20.0, 35.0))
    script = race_car()
    assert fast.time == pytest.approx(slow.time, rel=1e-5)
    # The tolerance is the published one, of a mesh of 50 segments.
    assert slow.time == pytest.approx(script.PUBLISHED, rel=0.01)
    assert slow.time > script.PUBLISHED  # where tires exceed their grip between the points
    fine = slow.motion.at(np.linspace(0.0, script.LENGTH, 5001))
    assert max(np.sqrt(fine[name]).max() for name in script.used) < 1.01
    assert slow.motion.states[-1] == pytest.approx(slow.motion.states[0], abs=1e-6)


def test_the_lap_of_the_race_car_is_a_motion_of_its_equations():
    _, lap = race_car_lap(30.0, 200)
    car, motion = copy(race_car().car), lap.trajectory
    car.specifieds, car.times = lap.inputs(), motion.times
    car.initial_conditions = dict(zip(car.states, motion.states[0], strict=True))
    simulated = car.simulate(rtol=1e-9, atol=1e-9)
    apart = np.hypot(*(simulated[q] - motion[q] for q in ("x", "y")))
    assert apart.max() < 0.5  # of 1245 m, without any control
