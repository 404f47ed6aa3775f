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
