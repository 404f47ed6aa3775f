"""Events on surfaces that move as samples or functions say: their rate is part of the event's."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.solvers import Event
from zoo import inertial_frame
from zoo.cases import close

G = 9.81
y, v, floor = me.dynamicsymbols("y v floor")
g = sm.Symbol("g")
KINDS = ["linear", "pchip", "expression", "function"]
TIGHT = {"rtol": 1e-10, "atol": 1e-10}
CLOCK = np.linspace(-1.0, 3.0, 401)


def ball(kind, speed, start, times, solver="dop853"):
    """A ball that falls onto a floor, which moves at a constant speed."""
    frame, origin = inertial_frame()
    point = origin.locatenew("P", y * frame.y)
    body = me.Particle("ball", point, 1)
    definition = Definition(frame, [y], [v], bodies=[body], loads=[(point, -g * frame.y)])
    system = System(definition, {g: G}, times=times, ode_solver=solver)
    system.outputs = {"gap": y - floor}
    if kind == "expression":
        system.specifieds = {floor: speed * me.dynamicsymbols._t}
    elif kind == "function":
        system.specifieds = {floor: lambda x, t: speed * t}
    else:
        system.specifieds = {floor: SampledInput(CLOCK, speed * CLOCK, kind)}
    system.initial_conditions = dict(zip([y, v], start, strict=True))
    return system


def bounce(speed, e):
    return Event(y - floor, direction=-1, reset={v: speed - e * (v - speed)}, name="bounce")


def impacts(height, speed, e, number):
    """Return the times of impacts, in the frame of the floor: each flight is e times as long."""
    first = (-speed + np.sqrt(speed**2 + 2 * G * height)) / G
    flights = 2 * e * (G * first + speed) / G * e ** np.arange(number - 1)
    return np.append(first, first + np.cumsum(flights))


@pytest.mark.parametrize("solver", ["dop853", "radau"])
@pytest.mark.parametrize(("kind", "speed"), [(k, -2.0) for k in KINDS] + [("linear", 3.0)])
def test_no_bounce_on_a_moving_floor_is_missed(kind, speed, solver):
    # After a bounce on the floor that sinks, the ball goes down too, only more slowly.
    system = ball(kind, speed, (1.0, 0.0), [0.0, 0.5, 2.0], solver)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "`.*` stopped at t = .*: the events", PyDyUserWarning)
        records = system.simulate(events=[bounce(speed, 0.3)], **TIGHT).events
    close([r.time for r in records[:6]], impacts(1.0, speed, 0.3, 6), 1e-8)


@pytest.mark.parametrize("solver", ["dop853", "tsit5", "radau"])
@pytest.mark.parametrize("e", [0.3, 0.5, 0.8])
@pytest.mark.parametrize("speed", [-10.0, -3.0, -0.3, 1.0, 3.0])
def test_bounces_on_a_moving_floor_accumulate_and_none_leads_through_it(speed, e, solver):
    """The last rebounds are as low as roundings of the height, in which the signs say nothing."""
    for kind in KINDS:
        system = ball(kind, speed, (0.05, speed - 1.0), [0.0, 1.5], solver)
        with pytest.warns(PyDyUserWarning, match="`bounce` follow each other ever faster"):
            trajectory = system.simulate(events=[bounce(speed, e)], rtol=1e-9, atol=1e-9)
        landing = np.sqrt(1.0 + 2 * G * 0.05)  # in the frame of the floor
        end = (landing - 1.0) / G + 2 * landing / G * e / (1 - e)
        # Up to 16 roundings of 15 m, or those of the differences that give rates of functions.
        unseen = 2 / G * (1e-5 if kind == "function" else np.sqrt(2 * G * 1e-13)) / (1 - e)
        assert trajectory.statistics["time"] == pytest.approx(end, abs=unseen)
        assert all(record.after[1] - speed >= -1e-12 for record in trajectory.events)


def bounces_on_a_floor_in_steps(times, floors, lift):
    """Return the heights of a ball dropped from 1 m, and its bounces, in closed form.

    The floor leaps at the times. The ball bounces where it falls through the floor, and where the
    floor leaps above it; the reset gives the speed `lift` − v/2.
    """
    height, speed, above = 1.0, 0.0, True
    heights, bounces = [height], []
    for k in range(len(times) - 1):
        now, end = times[k], times[k + 1]
        if k > 0 and above and height < floors[k]:
            speed = lift - speed / 2
            bounces.append(now)
        above = height > floors[k]
        while True:
            roots = np.roots([-G / 2, speed, height - floors[k]])
            crossings = [r.real for r in roots if r.imag == 0.0 and 1e-12 < r.real < end - now]
            if not crossings:
                break
            height, speed, now = floors[k], speed - G * min(crossings), now + min(crossings)
            if above:
                speed = lift - speed / 2
                bounces.append(now)
            above = speed > 0.0
        left = end - now
        height, speed = height + speed * left - G * left**2 / 2, speed - G * left
        heights.append(height)
    return np.array(heights), bounces


@pytest.mark.parametrize("seed", range(12))
def test_a_ball_on_a_floor_that_leaps_bounces_before_a_leap_and_by_one(seed):
    """A fall through the floor that a leap undoes at once is a bounce, too."""
    rng = np.random.default_rng(seed)
    times = np.append(0.0, rng.uniform(0.01, 0.12, 30).cumsum())
    floors = rng.uniform(-0.3, 0.3, 31) if seed % 2 else 0.3 * np.sin(rng.uniform(2, 20) * times)
    heights, bounces = bounces_on_a_floor_in_steps(times, floors, 0.2)
    system = ball("expression", 0.0, (1.0, 0.0), times)
    system.specifieds = {floor: SampledInput(times, floors, "previous")}
    event = Event(y - floor, direction=-1, reset={v: 0.2 - v / 2}, name="bounce")
    single = system.simulate(events=[event], **TIGHT)
    many = system.integrate_ensemble(initial_conditions={y: [1.0] * 3}, events=[event], **TIGHT)
    close([record.time for record in single.events], bounces, 1e-8)
    close(single["y"], heights, 1e-7)
    close(many.y.values[1], heights, 1e-7)


@pytest.mark.parametrize("stiffness", [0.0, 4.0])
@pytest.mark.parametrize("speed", [-3.0, 1.0])
def test_bounces_on_a_body_that_moves_accumulate_too(speed, stiffness):
    """In an ensemble as in one motion; a spring may brake the body."""
    p, w = me.dynamicsymbols("p w")
    e, k = sm.symbols("e k")
    frame, origin = inertial_frame()
    points = [origin.locatenew(name, q * frame.y) for name, q in (("P", y), ("Q", p))]
    bodies = [me.Particle(point.name, point, 1) for point in points]
    loads = [(points[0], -g * frame.y), (points[1], -k * p * frame.y)]
    definition = Definition(frame, [y, p], [v, w], bodies=bodies, loads=loads)
    system = System(
        definition, {g: G, k: stiffness, e: 0.5}, constants_symbols=[g, k, e],
        times=[0.0, 0.5, 1.0], ode_solver="dop853",
        initial_conditions={y: 0.05, v: speed - 1.0, w: speed},
    )  # fmt: skip
    falls = Event(y - p, direction=-1, reset={v: w - e * (v - w)}, name="bounce")
    with pytest.warns(PyDyUserWarning, match="`bounce` follow each other ever faster"):
        single = system.simulate(events=[falls], **TIGHT)
    many = system.integrate_ensemble(constants={e: [0.5] * 5}, events=[falls], **TIGHT)
    np.testing.assert_array_equal(many.end_time, single.statistics["time"])
    if not stiffness:
        landing = np.sqrt(1.0 + 2 * G * 0.05)
        end = (landing - 1.0) / G + 2 * landing / G
        assert single.statistics["time"] == pytest.approx(end, abs=1e-6)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("speed", "rate", "happens"),
    [(-1.0, -0.5, False), (-1.0, -1.5, True), (1.0, 0.5, True), (1.0, 1.5, False)],
)
def test_a_start_on_a_moving_surface_is_judged_by_the_relative_speed(kind, speed, rate, happens):
    system = ball(kind, speed, (0.0, rate), [0.0, 0.05])
    end = Event(y - floor, direction=-1, terminal=True, name="end")
    single = system.simulate(events=[end], **TIGHT).events
    many = system.integrate_ensemble(
        initial_conditions={v: [rate] * 3}, events=[end], reduce=["events"], **TIGHT
    )
    assert [r.time for r in single] == ([0.0] if happens else [])
    np.testing.assert_array_equal(many.end_count, int(happens))
    np.testing.assert_array_equal(many.end_times[:, 0], 0.0 if happens else np.nan)


@pytest.mark.parametrize("kind", KINDS)
def test_backward_in_time_too(kind):
    # From t = 1 back the floor sinks at 1 m/s, and the ball at 0.5 m/s.
    for direction, happens in [(1, True), (-1, False)]:
        system = ball(kind, 1.0, (1.0, 0.5), [1.0, 0.95])
        end = Event(y - floor, direction=direction, terminal=True, name="end")
        records = system.simulate(events=[end], **TIGHT).events
        assert [r.time for r in records] == ([1.0] if happens else [])


@pytest.mark.parametrize("second", [1e-9, 1.0, 1e9])
def test_a_function_of_the_state_moves_a_surface_too_in_any_unit(second):
    """A paddle follows the ball at a half of its speed: the gap changes at the other half."""
    frame, origin = inertial_frame()
    point = origin.locatenew("P", y * frame.y)
    body = me.Particle("ball", point, 1)
    definition = Definition(frame, [y], [v], bodies=[body], loads=[(point, -g * frame.y)])
    times = np.array([0.0, 0.1, 0.2]) * second
    system = System(definition, {g: G / second**2}, times=times, ode_solver="dop853")
    system.outputs, system.initial_conditions = {"gap": y - floor}, {y: 1.0, v: -1.0 / second}
    system.specifieds = {floor: lambda x, t: 0.5 + 0.5 * x[0]}
    for direction, happens in ((-1, True), (1, False)):
        end = Event(y - floor, direction=direction, terminal=True, name="end")
        records = system.simulate(events=[end], rtol=1e-10, atol=1e-12).events
        assert [r.time for r in records] == ([0.0] if happens else [])
