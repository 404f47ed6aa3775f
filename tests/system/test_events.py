"""Events of System.integrate and simulate."""

import re
import warnings
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint

from pydy._errors import IntegrationError, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.solvers import Event
from pydy.solvers.run.integration import Integration
from pydy.solvers.run.workspace import Workspace
from pydy.system import System
from registry import ADAPTIVE_NAMES, SOLVER_NAMES, has_fixed_step
from zoo.cases import close

T = me.dynamicsymbols._t
Z, V, PUSH = me.dynamicsymbols("z v F")
M, G = sm.symbols("m g")
ALL = SOLVER_NAMES
ADAPTIVE = ADAPTIVE_NAMES


@cache
def falling():
    """A particle that falls, pushed upwards by F."""
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, V * frame.z)
    kane = me.KanesMethod(frame, [Z], [V], kd_eqs=[Z.diff(T) - V])
    kane.kanes_equations([me.Particle("P", point, M)], [(point, (PUSH - M * G) * frame.z)])
    return kane


@cache
def oscillating():
    """A unit oscillator: z = sin t from z = 0, v = 1."""
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, V * frame.z)
    kane = me.KanesMethod(frame, [Z], [V], kd_eqs=[Z.diff(T) - V])
    kane.kanes_equations([me.Particle("P", point, sm.Integer(1))], [(point, -Z * frame.z)])
    return kane


def ball(solver="dop853", **options):
    defaults = {
        "constants": {M: 1.3, G: 9.81},
        "initial_conditions": {Z: 1.0, V: 0.0},
        "times": np.linspace(0.0, 2.0, num=41),
        "ode_solver": solver,
    }
    return System(falling(), **{**defaults, **options})


def oscillator(solver="dop853", end=10.0, **options):
    defaults = {
        "initial_conditions": {V: 1.0},
        "times": np.linspace(0.0, end, num=21),
        "ode_solver": solver,
    }
    return System(oscillating(), **{**defaults, **options})


def run(system, events, **options):
    if system.ode_solver.name == "rk4":
        options = {"step": 1e-3, **options}
    else:
        options = {"rtol": 1e-11, "atol": 1e-11, **options}
    return system.integrate(events=events, full_output=True, **options)


def moments(info, name=None):
    return np.array([r.time for r in info["events"] if name in (None, r.name)])


def bounce(factor, **options):
    return Event(Z, direction=-1, reset={V: -factor * V}, name="bounce", **options)


def impacts(factor, count, height=1.0, g=9.81):
    """When a ball dropped from some height hits the ground, each time."""
    fall = np.sqrt(2 * height / g)
    flights = 2 * fall * factor ** np.arange(1, count)
    return fall + np.concatenate([[0.0], np.cumsum(flights)])


# -- what counts as an event ----------------------------------------------------------------------


@pytest.mark.parametrize("solver", ALL)
def test_both_directions_are_seen_by_default(solver):
    _, info = run(oscillator(solver), [Event(Z)])
    close(moments(info), np.pi * np.arange(4), 1e-9)


@pytest.mark.parametrize("solver", ALL)
def test_one_direction_is_seen_if_asked_for(solver):
    _, info = run(oscillator(solver), [Event(Z, direction=1, name="up"), Event(Z, -1, name="down")])
    close(moments(info, "up"), [0.0, 2 * np.pi], 1e-9)
    close(moments(info, "down"), [np.pi, 3 * np.pi], 1e-9)


def test_times_are_found_to_a_few_units_in_the_last_place():
    # The interpolant is exact for a parabola.
    _, info = run(ball(), [Event(Z)])
    close(moments(info), [np.sqrt(2 / 9.81)], 4e-16)


def test_an_event_says_where_it_happened():
    x, info = run(oscillator(), [Event(V, name="turn")])
    record = info["events"][0]
    assert (record.name, record.index) == ("turn", 0)
    assert isinstance(record.time, float)
    close(record.before, [1.0, 0.0], 1e-9)
    np.testing.assert_array_equal(record.before, record.after)
    assert x.shape == (21, 2)


def test_watching_changes_nothing():
    system = oscillator()
    x, info = run(system, [Event(Z), Event(V - Z, name="other")])
    expected, plain = system.integrate(rtol=1e-11, atol=1e-11, full_output=True)
    np.testing.assert_array_equal(x, expected)
    assert info["steps"] == plain["steps"]


def test_records_come_in_the_order_of_time():
    _, info = run(oscillator(), [Event(Z), Event(V, name="turn"), Event(Z - V, name="equal")])
    assert [r.name for r in info["events"][:5]] == [str(Z), "equal", "turn", str(Z), "equal"]
    assert (np.diff(moments(info)) > 0.0).all()


def test_an_expression_may_hold_time_constants_rates_and_specifieds():
    system = ball(specifieds={PUSH: 0.13 * T})
    events = [
        Event(T - 0.625, name="clock"),
        Event(Z - M + 0.8, name="constant"),
        Event(Z.diff(T) + 3, name="rate"),
        Event(PUSH - 0.065, name="specified"),
    ]
    _, info = run(system, events)

    # z = 1 − g t²/2 + t³/60
    def height(t):
        return 1.0 - 9.81 * t**2 / 2 + t**3 / 60

    close(moments(info, "clock"), [0.625], 1e-14)
    close(height(moments(info, "constant")), [0.5], 1e-10)
    t = moments(info, "rate")
    close(-9.81 * t + t**2 / 20, [-3.0], 1e-9)
    close(moments(info, "specified"), [0.5], 1e-12)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_two_events_in_one_step_are_both_found(solver):
    events = [Event(Z - 0.5, name="half"), Event(Z - 0.4999999, name="a little less")]
    _, info = run(ball(solver), events)
    close(moments(info), np.sqrt(2 * np.array([0.5, 0.5000001]) / 9.81), 1e-9)


def test_one_event_twice_in_one_step_is_found_where_signs_differ_between_quarters():
    # The step is as long as the whole motion; z − 0.9 is crossed at t = ±0.45 about the top.
    system = ball(initial_conditions={Z: 0.0, V: 4.2})
    _, info = run(system, [Event(Z - 0.8)], rtol=1e-3, atol=1e-3, first_step=0.85)
    close(moments(info), (4.2 + np.array([-1, 1]) * np.sqrt(4.2**2 - 2 * 9.81 * 0.8)) / 9.81, 1e-9)


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("depth", [1e-2, 1e-4, 1e-6, 1e-8, 1e-10])
def test_an_event_that_crosses_and_returns_between_quarters_is_seen(solver, depth):
    for phase in (0.3, 2.0, 5.5):
        start = {Z: np.cos(phase), V: -np.sin(phase)}
        system = oscillator(solver, end=40.0, initial_conditions=start)
        _, info = run(system, [Event(Z - 1 + sm.Float(depth))], rtol=1e-13, atol=1e-13)
        half, tops = np.arccos(1 - depth), 2 * np.pi * np.arange(1, 8)
        turns = np.sort(np.concatenate([tops - half, tops + half])) - phase
        assert len(info["events"]) == np.sum(turns < 40)
        assert [r.after[1] > 0 for r in info["events"]] == [True, False] * (
            len(info["events"]) // 2
        )


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("depth", [1e-2, 1e-3, 1e-4])
def test_an_event_that_returns_is_not_late_where_another_one_acts_meanwhile(solver, depth):
    half = float(np.arccos(1 - depth))
    stops = Event(Z - 1 + sm.Float(depth), direction=1, terminal=True, name="stops")
    for share in (-0.9, 0.0, 0.9):
        ticks = Event(T - np.pi / 2 - sm.Float(share * half), reset={V: 3}, name="ticks")
        for tolerance in (1e-7, 1e-9, 1e-11):
            system = oscillator(solver, end=3.0)
            _, info = run(system, [ticks, stops], rtol=tolerance, atol=tolerance)
            assert [r.name for r in info["events"]] == ["stops"]
            close(moments(info), [np.pi / 2 - half], 1e-4)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_of_several_that_return_within_a_quarter_each_acts_in_its_turn(solver):
    events = [
        Event(Z - 1 + sm.Float(1e-7), direction=-1, name="falls"),
        Event(Z - 1 + sm.Float(1e-6), direction=1, name="rises"),
        Event(1 - sm.Float(1e-8) - Z, direction=-1, name="stops", terminal=True),
    ]
    for order in (events, events[::-1]):
        _, info = run(oscillator(solver), order, rtol=1e-13, atol=1e-13)
        assert [r.name for r in info["events"]] == ["rises", "stops"]
        close(moments(info, "rises"), [np.pi / 2 - np.arccos(1 - 1e-6)], 1e-6)
        close(moments(info, "stops"), [np.pi / 2 - np.arccos(1 - 1e-8)], 1e-5)


def crossings(level, rate, end, lag=0.0):
    """When sin(rate t − lag) passes a level between 0 and 1, both ways."""
    turns = 2 * np.pi * np.arange(rate * end / 6 + 2)
    found = np.concatenate([np.arcsin(level) + turns, np.pi - np.arcsin(level) + turns]) + lag
    return np.sort(found[found < rate * end]) / rate


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("rate", [3.0, 24.92, 58.6])
def test_what_time_changes_beside_the_states_is_resolved(solver, rate):
    """Nothing acts on the particle: the error control alone would let its steps be of any size.

    The log of events is full several times, too, between two crossings in one quarter of a step.
    """
    at_rest = {"constants": {M: 1.3, G: 0.0}, "times": [0.0, 9.0]}
    events = [
        Event(sm.sin(rate * T) - sm.Float("0.9999"), name="high"),
        Event(Z * sm.sin(rate * T - 1) - sm.Float("0.3"), name="wall"),
    ]
    _, info = run(ball(solver, **at_rest), events)
    close(moments(info, "high"), crossings(0.9999, rate, 9.0), 1e-9)
    close(moments(info, "wall"), crossings(0.3, rate, 9.0, 1.0), 1e-9)
    assert info["steps"] + info["rejected"] < 30 * rate


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_what_a_function_of_time_changes_is_resolved(solver):
    held = ball(solver, constants={M: 1.0, G: 1.0}, times=[0.0, 2.0])
    held.specifieds = {PUSH: lambda x, t: 1.0 + 1e-9 * np.sin(40.0 * t)}
    _, info = run(held, [Event((PUSH - 1) * 10**9 - sm.Float("0.999"))])
    close(moments(info), crossings(0.999, 40.0, 2.0), 1e-6)


def test_a_jump_that_no_step_resolves_is_passed():
    times = np.linspace(0.0, 2.0, num=21)
    values = np.where(np.arange(21) % 2, 1e-3, 1.0)
    push = SampledInput(times, values, interpolation="previous")
    _, info = run(ball(specifieds={PUSH: push}), [Event(PUSH - sm.Float("1e-4"))])
    assert len(info["events"]) == 0
    assert info["steps"] + info["rejected"] < 30  # one a jump


def test_what_time_changes_beside_the_states_may_be_rounding():
    flat = Event((T + Z) - (Z + T) + 0 * PUSH + 1e-17 * sm.sin(40 * T) + sm.Float("1e-16"))
    _, info = run(ball(constants={M: 1.3, G: 0.0}, times=[0.0, 100.0]), [flat])
    assert info["steps"] + info["rejected"] < 3000


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_events_at_the_same_instant_all_happen(solver):
    events = [Event(Z - 0.5, name="a"), Event(2 * Z - 1, name="b"), Event(0.5 - Z, name="c")]
    _, info = run(ball(solver), events)
    assert sorted(r.name for r in info["events"]) == ["a", "b", "c"]
    close(moments(info), np.full(3, np.sqrt(1 / 9.81)), 1e-12)


def test_resets_at_the_same_instant_follow_each_other_in_the_order_given():
    events = [
        Event(Z - 0.5, reset={V: V + 1}, name="a"),
        Event(2 * Z - 1, reset={V: 2 * V}, name="b"),
    ]
    _, info = run(ball(times=[0.0, 0.4]), events)
    first, second = info["events"]
    assert first.time == second.time
    close(second.before, first.after)
    close(second.after[1], 2 * (first.before[1] + 1))


def test_an_event_that_only_touches_zero_is_not_seen():
    _, info = run(oscillator(), [Event(Z - 1), Event((Z - sm.Rational(1, 2)) ** 2, name="square")])
    assert info["events"] == []


@pytest.mark.parametrize("solver", ALL)
def test_an_event_exactly_at_the_first_time_is_reported(solver):
    x, info = run(oscillator(solver), [Event(Z)])
    record = info["events"][0]
    assert (record.time, record.name) == (0.0, "z(t)")
    np.testing.assert_array_equal(record.before, x[0])
    np.testing.assert_array_equal(record.after, x[0])


def test_a_root_at_the_start_that_is_left_backwards_counts_when_it_comes_again():
    system = oscillator(initial_conditions={V: -1.0})
    _, info = run(system, [Event(Z, direction=1)])
    close(moments(info), [np.pi, 3 * np.pi], 1e-9)


def test_an_event_at_the_first_time_counts_in_its_direction_only():
    _, info = run(oscillator(end=1.0), [Event(Z, 1, name="up"), Event(Z, -1, name="down")])
    assert [(r.time, r.name) for r in info["events"]] == [(0.0, "up")]


def test_an_event_at_the_first_time_acts_where_its_direction_points_to():
    # Let go at an apex, the ball is thrown up: its speed is zero and falls.
    events = [bounce(0.8), Event(V, direction=-1, reset={V: 5}, name="apex")]
    x, info = run(ball(times=[0.0, 0.1]), events)
    assert [(r.name, r.time) for r in info["events"]] == [("apex", 0.0)]
    np.testing.assert_array_equal(info["events"][0].before, [1.0, 0.0])
    np.testing.assert_array_equal(info["events"][0].after, [1.0, 5.0])
    np.testing.assert_array_equal(x[0], [1.0, 0.0])  # as at other events, the state before it
    close(x[1], [1.0 + 0.5 - 9.81 * 0.005, 5.0 - 0.981], 1e-9)


def test_a_terminal_event_at_the_first_time_ends_the_motion_there():
    x, info = run(ball(times=[0.0, 0.1]), [Event(V, direction=-1, terminal=True, name="apex")])
    assert (info["time"], info["status"]) == (0.0, "terminated by `apex`")
    np.testing.assert_array_equal(x, [[1.0, 0.0], [np.nan, np.nan]])


@pytest.mark.parametrize("solver", ALL)
def test_an_event_exactly_at_the_last_time_is_reported(solver):
    system = ball(solver, times=np.linspace(0.0, 1.5, 4))
    x, info = run(system, [Event(T - 1.5, name="end"), Event(T - 1.5, -1, name="other way")])
    assert [(r.name, r.time) for r in info["events"]] == [("end", 1.5)]
    assert info["status"] == "finished"
    close(info["events"][0].before, x[-1], 1e-14)


def test_an_event_a_rounding_after_the_last_time_is_reported():
    times = [0.0, 0.3]
    _, info = run(ball(times=times), [Event(T - np.nextafter(0.3, 1.0))])
    close(moments(info), [0.3])
    _, info = run(ball(times=times), [Event(T - 0.3001)])
    assert len(moments(info)) == 0


def test_a_terminal_event_at_the_last_time_ends_what_is_complete():
    x, info = run(ball(times=[0.0, 0.4]), [Event(T - 0.4, terminal=True, reset={V: 0}, name="end")])
    assert info["status"] == "terminated by `end`"
    assert info["reached"] == 2
    close(x[1, 1], -0.4 * 9.81, 1e-9)
    assert info["events"][0].after[1] == 0.0


@pytest.mark.parametrize("solver", ALL)
def test_a_reset_to_zero_at_the_last_time_is_one_event(solver):
    end = float(np.sqrt(2 / 9.81))
    _, info = run(ball(solver, times=[0.0, end + 1e-13]), [Event(Z, -1, reset={Z: 0, V: 1})])
    assert len(info["events"]) == 1


# -- terminal events ------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ALL)
def test_a_terminal_event_ends_the_integration(solver):
    system = ball(solver)
    x, info = run(system, [Event(Z, terminal=True, name="ground")])
    end = np.sqrt(2 / 9.81)
    assert info["status"] == "terminated by `ground`"
    assert info["time"] == info["events"][0].time == pytest.approx(end, abs=1e-12)
    reached = system.times <= end
    assert info["reached"] == reached.sum()
    close(x[reached, 0], 1 - 9.81 * system.times[reached] ** 2 / 2)
    assert np.isnan(x[~reached]).all()


def test_a_terminal_event_may_reset_too():
    _, info = run(ball(), [bounce(0.5, terminal=True)])
    record = info["events"][-1]
    close(record.after, [record.before[0], -0.5 * record.before[1]])


def test_what_happens_before_the_end_in_the_same_step_is_recorded():
    events = [Event(Z, terminal=True, name="ground"), Event(Z - 0.001, name="near")]
    _, info = run(ball(), events)
    assert [r.name for r in info["events"]] == ["near", "ground"]


# -- resets ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ALL)
def test_a_bouncing_ball_bounces_as_the_closed_form_says(solver):
    factor = 0.8
    x, info = run(ball(solver), [bounce(factor)])
    expected = impacts(factor, 30)
    expected = expected[expected < 2.0]
    close(moments(info), expected, 1e-9)
    for k, record in enumerate(info["events"]):
        speed = np.sqrt(2 * 9.81) * factor**k
        close(record.before, [0.0, -speed], 1e-9)
        close(record.after, [0.0, factor * speed], 1e-9)
    # Between two impacts it is a parabola.
    times = ball().times
    k = np.searchsorted(expected, times, side="right") - 1
    since = times - expected[k]
    up = np.sqrt(2 * 9.81) * factor ** (k + 1)
    height = np.where(k < 0, 1 - 9.81 * times**2 / 2, up * since - 9.81 * since**2 / 2)
    close(x[:, 0], height, 1e-8)


@pytest.mark.parametrize("solver", ALL)
def test_resets_in_compiled_code_are_those_of_python(solver, monkeypatch):
    own, seen, acted = Workspace._bind_event_actions, Integration._act, []

    def without_resets(workspace, events):
        (_, rater, _), rates_c, _ = own(workspace, events)
        return [0, rater, 0], rates_c, np.zeros(1)

    monkeypatch.setattr(Integration, "_act", lambda one: acted.append(one) or seen(one))
    times = np.linspace(0.0, 12.0, num=31)
    few = [bounce(0.95), Event(V, name="top"), Event(T - 5, reset={V: V + 1}, name="push")]
    found = []
    for alone in (own, without_resets):
        monkeypatch.setattr(Workspace, "_bind_event_actions", alone)
        acted.clear()
        x, info = run(ball(solver, times=times), few, dense_output=True)
        assert (len(acted) > 10) == (alone is not own)
        told = [(r.time, r.name, *r.before, *r.after) for r in info["events"]]
        dense = info["dense_output"](np.linspace(0.0, 12.0, num=999))
        found.append((x, told, dense, info["evaluations"], info["steps"], info["status"]))
    for one, other in zip(*found, strict=True):
        np.testing.assert_array_equal(one, other)


def test_more_resets_than_the_log_holds_are_all_recorded():
    system = ball(times=[0.0, 600.0])
    _, info = run(system, [bounce(1), Event(V, name="top")])
    close(moments(info, "bounce"), impacts(1.0, 664), 1e-7)
    close(moments(info, "top")[1:], (impacts(1.0, 665)[1:] + impacts(1.0, 664)) / 2, 1e-7)


def test_a_reset_that_is_no_number_is_an_error_after_others_that_were():
    first = Event(T - 0.3, reset={V: V + 1}, name="push")
    wrong = Event(Z, direction=-1, reset={V: sm.sqrt(V)}, name="wrong")
    with pytest.raises(IntegrationError, match="`wrong`") as caught:
        run(ball(), [first, wrong])
    assert [r.name for r in caught.value.info["events"]] == ["push"]


@pytest.mark.parametrize("solver", ALL)
def test_a_ball_that_loses_no_energy_bounces_for_ever(solver):
    system = ball(solver, times=np.linspace(0.0, 60.0, num=7))
    x, info = run(system, [bounce(1)])
    close(moments(info), impacts(1.0, 67)[: len(info["events"])], 1e-8)
    assert len(info["events"]) == 66
    close(9.81 * x[:, 0] + x[:, 1] ** 2 / 2, np.full(7, 9.81), 1e-8)


@pytest.mark.parametrize("solver", ALL)
def test_a_zeno_point_stops_with_a_status_and_a_warning(solver):
    system = ball(solver, times=np.linspace(0.0, 5.0, num=51))
    with pytest.warns(PyDyUserWarning, match="the events `bounce` follow each other ever faster"):
        x, info = run(system, [bounce(0.5)])
    zeno = 3 * np.sqrt(2 / 9.81)
    assert info["status"] == "events `bounce` accumulate"
    assert info["time"] == pytest.approx(zeno, abs=1e-6)
    reached = system.times <= info["time"]
    assert np.isfinite(x[reached]).all()
    assert np.isnan(x[~reached]).all()
    assert len(info["events"]) < 200


def test_two_balls_may_accumulate_at_once():
    system = ball(times=[0.0, 5.0])
    events = [bounce(0.5), Event(2 * Z, direction=-1, reset={Z: 0}, name="other")]
    with pytest.warns(PyDyUserWarning, match="accumulate there"):
        _, info = run(system, events)
    assert "accumulate" in info["status"]


def test_a_chatter_that_does_not_slow_down_in_time_is_left_to_max_steps():
    system = oscillator(end=1e6)
    with pytest.raises(IntegrationError, match="took 2000 steps, `max_steps`") as caught:
        run(system, [Event(Z, reset={V: -V})], max_steps=2000)
    assert len(caught.value.info["events"]) > 100


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_the_same_event_may_be_at_its_root_right_after_a_reset(solver):
    _, info = run(
        ball(solver, times=[0.0, 1.0]), [Event(Z, direction=-1, reset={Z: 0, V: 3}, name="up")]
    )
    first = np.sqrt(2 / 9.81)
    expected = first + 6 / 9.81 * np.arange(10)
    close(moments(info), expected[expected <= 1.0], 1e-9)
    for record in info["events"]:
        np.testing.assert_array_equal(record.after, [0.0, 3.0])


@pytest.mark.parametrize("solver", ALL)
@pytest.mark.parametrize("height", [1e-4, 0.3])
@pytest.mark.parametrize("direction", [0, -1])
def test_a_reset_may_take_the_state_back_before_its_own_surface(solver, height, direction):
    lifted = Event(Z, direction=direction, reset={Z: height, V: -1}, name="lifted")
    _, info = run(ball(solver, times=[0.0, 0.46]), [lifted])
    fall = 2 * height / (1 + np.sqrt(1 + 2 * 9.81 * height))  # from the height, at 1 m/s
    expected = np.sqrt(2 / 9.81) + fall * np.arange(1000)
    close(moments(info), expected[expected <= 0.46], 1e-9)


@pytest.mark.parametrize("rounded", [0.1, 0.3 - 0.2, np.nextafter(0.1, 1.0)])
def test_a_reset_onto_its_own_surface_but_for_rounding_is_on_it(rounded):
    place = sm.Float(0.1)
    _, info = run(ball(times=[0.0, 1.0]), [Event(Z - place, reset={Z: rounded, V: 3}, name="up")])
    first = np.sqrt(1.8 / 9.81)
    close(moments(info), [first], 1e-9)


def test_a_reset_may_jump_over_another_event():
    events = [
        Event(Z, reset={Z: 5, V: 0}, name="lift"),
        Event(Z - 3, direction=-1, name="pass"),
        Event(Z - 3, direction=1, name="up"),
    ]
    _, info = run(ball(times=[0.0, 2.4]), events)
    # What a reset jumps over is not crossed: only the fall from 5 passes 3.
    lifts = np.sqrt(2 / 9.81) + np.sqrt(10 / 9.81) * np.arange(2)
    close(moments(info, "lift"), lifts, 1e-9)
    close(moments(info, "pass"), lifts + np.sqrt(4 / 9.81), 1e-9)
    assert len(moments(info, "up")) == 0


def test_states_that_a_reset_does_not_name_stay():
    _, info = run(ball(times=[0.0, 0.5]), [Event(Z - 0.5, reset={V: 0})])
    record = info["events"][0]
    assert record.after[0] == record.before[0]
    assert record.after[1] == 0.0


def test_a_reset_to_something_that_is_no_number_is_an_integration_error():
    with pytest.raises(IntegrationError, match=r"met the event `z\(t\)`, whose reset gave .*nan"):
        run(ball(), [Event(Z, reset={V: sm.sqrt(V)})])


def test_an_output_at_the_instant_of_a_reset_is_the_state_before_it():
    system = oscillator(times=[0.0, 1.0, 2.0])
    x, _ = run(system, [Event(T - 1, reset={Z: 10})])
    close(x[1], [np.sin(1.0), np.cos(1.0)], 1e-9)
    assert x[2, 0] > 1.0


def test_fixed_steps_stay_the_same_after_an_event():
    system = oscillator("rk4")
    _, plain = system.integrate(step=0.01, full_output=True)
    _, info = run(system, [Event(Z, reset={V: V})], step=0.01)
    assert plain["steps"] <= info["steps"] <= plain["steps"] + 60
    assert info["last_step"] == pytest.approx(0.01)


# -- constant and wrong events --------------------------------------------------------------------


@pytest.mark.parametrize("expression", [sm.Integer(1), G - 3, M * G])
def test_an_expression_that_is_constant_is_an_integration_error(expression):
    with pytest.raises(IntegrationError, match="cannot detect the event `never`, whose expressi"):
        run(ball(), [Event(expression, name="never")])


def test_a_reset_takes_names_of_states():
    by_symbol = run(ball(), [Event(Z, direction=-1, reset={V: -V})])[0]
    by_name = run(ball(), [Event(Z, direction=-1, reset={"v": -V})])[0]
    np.testing.assert_array_equal(by_name, by_symbol)


WRONG = [
    (Z, TypeError, r"`events` must be a list of Event, got .* Use `Event\(z\(t\)\)`"),
    ([Z], TypeError, r"`events` must hold objects of pydy.solvers.Event, got.* `Event\(.*\)`"),
    ([Event(Z, reset={G: 1})], ValueError, r"has a value for `g`, which is no state .*z\(t\)"),
    ([Event(Z, reset={V: 1, "v": 2})], ValueError, r"gives `v\(t\)` more than once"),
    (
        [Event(Z), Event(Z)],
        ValueError,
        r"must have different names, got `z\(t\)` twice.*`Event\(\.\.\., name",
    ),
]


@pytest.mark.parametrize(("events", "kind", "message"), WRONG)
def test_wrong_events_say_what_they_must_be(events, kind, message):
    with pytest.raises(kind, match=message):
        run(ball(), events)


@pytest.mark.parametrize(
    ("condition", "remedy"),
    [(Z > 0.1, r"z\(t\) - 0\.1"), (Z < 2, r"2 - z\(t\)"), (sm.Eq(Z, V), r"-v\(t\) \+ z\(t\)")],
)
def test_an_inequality_is_refused_with_the_expression_that_crosses_zero(condition, remedy):
    with pytest.raises(ValueError, match=f"`expression` must cross zero, .* Pass `{remedy}`"):
        Event(condition)


@pytest.mark.parametrize("solver", [odeint, "RK45", "dop853"])
def test_an_expression_is_no_event_whatever_the_solver(solver):
    with pytest.raises(TypeError, match=r"pydy.solvers.Event, got .* Use `Event\(z\(t\) - 0.1\)`"):
        ball(solver=solver).integrate(events=[Z - 0.1])


def test_events_need_a_native_solver():
    with pytest.raises(ValueError, match=r"`events` needs a native solver: set `system.ode_solver"):
        ball(solver=odeint).integrate(events=[Event(Z)])


@pytest.mark.parametrize(("events", "count"), [(None, 0), ([], 0), (Event(Z), 1)])
def test_none_and_a_single_event_will_do(events, count):
    assert len(run(ball(), events)[1]["events"]) == count


# -- many events, and what else is going on -------------------------------------------------------


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_more_events_than_the_log_holds_are_all_kept(solver):
    end = 1000.25 * np.pi
    system = oscillator(solver, end=end)
    x, info = run(system, [Event(Z), Event(V, name="turn")], rtol=1e-9, atol=1e-9)
    close(moments(info, str(Z)), np.pi * np.arange(1001), 1e-6)
    close(moments(info, "turn"), np.pi * (np.arange(1000) + 0.5), 1e-6)
    close(x[:, 0], np.sin(system.times), 1e-4)


def test_many_events_in_one_step_are_all_kept():
    # The log is emptied in the middle of a step, where hundreds of marks are yet to come.
    heights = np.arange(949, 49, -3)
    marks = [Event(Z - 0.001 * int(k), name=str(k)) for k in heights[::-1]]
    _, info = run(ball(times=[0.0, 0.45]), marks, rtol=1e-6, atol=1e-6)
    assert [r.name for r in info["events"]] == [str(k) for k in heights]
    close(moments(info), np.sqrt(2 * (1 - 0.001 * heights) / 9.81), 1e-9)


INPUTS = {
    "number": 1.3 * 9.81 + 2.6,
    "function": lambda x, t: 1.3 * 9.81 + 2.6,
    "expression": M * G + 2 * M,
    "samples": SampledInput([0.0, 5.0], [1.3 * 9.81 + 2.6] * 2),
}


@pytest.mark.parametrize("kind", INPUTS)
@pytest.mark.parametrize("solver", ALL)
def test_events_see_specifieds_of_every_kind(solver, kind):
    # The push lifts it with 2 m/s².
    system = ball(solver, specifieds={PUSH: INPUTS[kind]}, times=[0.0, 1.5])
    events = [Event(Z - PUSH / 10, name="height"), Event(Z - 2, reset={V: -PUSH}, name="stop")]
    _, info = run(system, events, **({"step": 5e-3} if has_fixed_step(solver) else {}))
    push = 1.3 * 9.81 + 2.6
    height, stop = info["events"][:2]
    close(height.time, np.sqrt(push / 10 - 1), 1e-8)
    close(stop.time, 1.0, 1e-8)
    close(stop.after[1], -push, 1e-10)


@pytest.mark.parametrize("linear", ["numpy", "sympy"])
@pytest.mark.parametrize("kind", INPUTS)
def test_events_see_specifieds_under_an_external_linear_solver(kind, linear):
    system = ball(specifieds={PUSH: INPUTS[kind]}, times=[0.0, 1.5])
    system.generate_ode_function(linear_sys_solver=linear)
    _, info = run(system, [Event(Z - PUSH / 10)], rtol=1e-8, atol=1e-8)
    close(moments(info), [np.sqrt((1.3 * 9.81 + 2.6) / 10 - 1)], 1e-6)


def test_events_work_with_a_generator_that_makes_no_machine_code():
    system = ball(specifieds={PUSH: 0.5})
    system.generate_ode_function(generator="lambdify")
    _, info = run(system, [bounce(0.8)], rtol=1e-8, atol=1e-8)
    g = 9.81 - 0.5 / 1.3
    expected = impacts(0.8, 30, g=g)
    close(moments(info), expected[expected < 2.0], 1e-6)


def test_an_exception_of_a_function_comes_out_of_an_event_as_itself():
    def push(x, t):
        if t > 0.3:
            raise LookupError("no push")
        return 0.0

    with pytest.raises(LookupError, match="no push"):
        run(ball(specifieds={PUSH: push}), [Event(Z - PUSH)])


def test_events_are_on_the_trajectory():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        trajectory = ball().simulate(events=[bounce(0.8)], rtol=1e-10, atol=1e-10)
    assert len(trajectory.times) == 41
    expected = impacts(0.8, 30)
    close([e.time for e in trajectory.events], expected[expected < 2.0], 1e-9)
    assert {e.name for e in trajectory.events} == {"bounce"}
    # Resets are nodes of the interpolation.
    near = trajectory.at([expected[0] - 1e-6, expected[0] + 1e-6])
    assert near["v"][0] < 0.0 < near["v"][1]


@pytest.mark.parametrize("full_output", [True, False])
def test_a_trajectory_ends_where_an_event_ended_it(full_output):
    trajectory = ball().simulate(events=[Event(Z, terminal=True)], full_output=full_output)
    assert len(trajectory.times) == 10
    assert np.isfinite(trajectory.states).all()


def test_aggregated_states_go_on_through_events():
    a = sm.Symbol("a")
    system = ball(outputs={a: a - V.diff(T)})
    x, info = run(system, [bounce(0.8)])
    assert x.shape == (41, 3)
    close(x[:, 2], -9.81 * system.times, 1e-9)
    assert info["events"][0].after.shape == (3,)


@pytest.mark.parametrize("solver", ["dop853", "rk4", "radau"])
def test_a_jump_of_an_input_makes_an_event_happen_once(solver):
    # A floor leaps from −1 to 5 at t = 0.3, above the ball, and throws it up.
    floor = SampledInput([0.0, 0.3, 2.0], [-1.0, 5.0, 5.0], "previous")
    system = ball(solver, specifieds={PUSH: floor}, times=[0.0, 0.3, 0.5])
    leap = Event(Z - PUSH, direction=-1, reset={V: 2.0}, name="leap")
    x, info = run(
        system, [leap], **({"step": 5e-3} if has_fixed_step(solver) else {"max_step": 0.05})
    )
    assert moments(info) == [0.3]
    close(x[-1, 1], 2.0 - 0.2 * (9.81 - 5.0 / 1.3), 1e-6)


PLATEAU = sm.Piecewise((Z - 0.5, Z > 0.5), (0, Z > 0.45), (Z - 0.45, True))


GROUND = 0.45152364098573097  # when it is reached


@pytest.mark.parametrize("solver", ["dop853", "radau", "rk4"])
@pytest.mark.parametrize("times", [np.linspace(0.0, 2.0, 41), [0.0, 2.0]])
@pytest.mark.parametrize(
    ("expression", "first", "last"),
    [
        (sm.Max(0, Z), GROUND, 2.0),
        (sm.Max(0, -1e-9 * Z), 0.0, GROUND),
        (sm.Abs(V) + V, 0.0, 2.0),
        (PLATEAU, 0.31928, 0.33487),  # while Z is between 0.5 and 0.45
    ],
)
def test_an_event_that_stays_at_zero_is_told(solver, times, expression, first, last):
    events = [Event(Z - 0.1), Event(expression, name="rests")]
    with pytest.warns(PyDyUserWarning, match="the event `rests` is exactly zero") as caught:
        run(ball(solver, times=times), events, **({"step": 0.05} if has_fixed_step(solver) else {}))
    [told] = [str(w.message) for w in caught]
    found = [float(n) for n in re.findall(r"(?:t =|to) (\d+(?:\.\d+)?)", told)]
    assert first - 1e-5 <= found[0] <= found[-1] <= last + 1e-5
    if expression is not PLATEAU:
        assert found[-1] - found[0] > 0.7 * (last - first)


def test_samples_of_an_ensemble_with_an_event_that_stays_at_zero_are_told_once():
    rests = Event(sm.Max(0, Z), name="rests")
    for reduce in (None, "final", "events"):
        with pytest.warns(PyDyUserWarning, match="`rests` is exactly zero from t = ") as caught:
            ball().integrate_ensemble(
                initial_conditions={Z: np.linspace(1.0, 2.0, 20)}, events=rests, reduce=reduce
            )
        assert len(caught) == 1


def test_a_sampled_signal_that_stays_at_zero_is_told():
    samples = SampledInput([0.0, 0.5, 1.0, 2.0], [0.0, 0.0, 1.0, -1.0])
    system = ball(specifieds={PUSH: samples})
    with pytest.warns(PyDyUserWarning, match=r"`push` is exactly zero from t = 0 to 0\.5"):
        run(system, Event(PUSH, name="push"))
    samples = SampledInput([0.0, 1.0, 2.0], [0.0, 1.0, -1.0])
    run(ball(specifieds={PUSH: samples}), Event(PUSH, name="push"))


def test_single_zeros_and_touches_are_no_stretches():
    system = ball(initial_conditions={Z: 0.0, V: 1.0}, constants={M: 1.0, G: 0.0}, ode_solver="rk4")
    system.times = np.linspace(0.0, 3.0, 4)  # Z is exactly 0, 1, 2 and 3
    zeros = sm.Abs(Z * (Z - 1) * (Z - 2) * (Z - 3))
    kinds = [
        zeros,
        sm.Max(zeros, -1),
        sm.Abs(Z - 1),
        sm.Min(Z - 1, 7),
        sm.Max(sm.Min(Z - 2, 1), -1),
    ]
    system.integrate(events=[Event(e, name=str(k)) for k, e in enumerate(kinds)], step=0.25)
    still = ball(constants={M: 1.0, G: 0.0}, initial_conditions={Z: 0.0, V: 0.0})
    run(still, Event(Z))  # the motion rests, and not the expression


def test_what_is_zero_twice_but_not_between_is_no_stretch():
    # Z = t (1 − t) + t/2 crosses t/2 at 0 and 1: their chords are the same.
    system = ball(constants={M: 1.0, G: 2.0}, initial_conditions={Z: 0.0, V: 1.5})
    system.times = np.array([0.0, 1.0, 2.0])
    run(system, [Event(sm.Max(Z - T / 2, -9), name="line"), Event(sm.Abs(Z - T / 2), name="arc")])


@pytest.mark.parametrize("solver", ["dop853", "vern9", "tsit5"])
def test_a_linear_event_that_is_far_costs_no_evaluation(solver):
    system = System(oscillating(), ode_solver=solver, times=[0.0, 100.0])
    system.initial_conditions = {Z: 0.0, V: 1.0}
    far, none = (
        system.simulate(events=events, rtol=1e-8, atol=1e-8).statistics
        for events in ([Event(Z + V / 2 - T / 50 - 2000)], ())
    )
    # The first step has no values at its start, and is looked at as any other.
    assert 0 <= far["evaluations"] - none["evaluations"] <= 10
    assert far["steps"] == none["steps"] > 20


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("level", [0.1, 0.9, 0.999, 1.0 - 1e-6])
@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_linear_events_are_seen_however_far_they_were(solver, level, unit):
    """z = sin t at a level, from afar and near, in any unit and beside one that stays away."""
    system = System(oscillating(), ode_solver=solver, times=[0.0, 40.0])
    system.initial_conditions = {Z: 0.0, V: unit}
    events = [Event(Z - level * unit), Event(3 * V + Z / 7 - 1e3 * unit)]
    found = [e.time for e in system.simulate(events=events, rtol=1e-10, atol=1e-10 * unit).events]
    rise, turn = np.arcsin(level), 2 * np.pi * np.arange(7)
    expected = np.sort(np.concatenate([rise + turn, np.pi - rise + turn]))
    expected = expected[expected < 40.0]
    assert len(found) == len(expected)
    close(found, expected, 1e-5 if level > 0.9999 else 1e-7)


# -- noncontributing forces ------------------------------------------------------------------------

Q, U, TENSION, OUTWARD = me.dynamicsymbols("q u S u_r")
LENGTH = sm.Symbol("l")


def swinging(**options):
    """A pendulum that is thrown upwards, with the tension of its rope as an output."""
    frame, pivot = me.ReferenceFrame("N"), me.Point("O")
    rope = frame.orientnew("R", "Axis", (Q, frame.z))
    rope.set_ang_vel(frame, U * frame.z)
    pivot.set_vel(frame, 0)
    bob = pivot.locatenew("B", -LENGTH * rope.y)
    bob.set_vel(frame, LENGTH * U * rope.x - OUTWARD * rope.y)
    kane = me.KanesMethod(frame, [Q], [U], [Q.diff(T) - U], u_auxiliary=[OUTWARD])
    loads = [(bob, -M * G * frame.y + TENSION * rope.y)]
    kane.kanes_equations([me.Particle("bob", bob, M)], loads)
    defaults = {
        "constants": {M: 1.3, G: 9.81, LENGTH: 0.7}, "initial_conditions": {U: 6.5},
        "times": np.linspace(0.0, 0.6, num=11), "ode_solver": "dop853",
    }  # fmt: skip
    return System(kane, **{**defaults, **options})


def test_an_event_of_a_noncontributing_force_is_where_the_force_is():
    # m l u² + m g cos q = 0 with l u² = l u0² - 2 g (1 - cos q)
    slack = np.arccos((2.0 - 0.7 * 6.5**2 / 9.81) / 3.0)
    system = swinging(noncontributing_forces=[TENSION])
    event = Event(TENSION, direction=-1, terminal=True, name="slack")
    options = {"rtol": 1e-11, "atol": 1e-11}
    motion = system.simulate(events=[event], sensitivities=["g"], **options)
    close(motion.events[-1].before[0], slack, 1e-9)
    # The angle is a function of g, which moves the time and the motion up to it.
    last = motion.events[-1]
    moved = float(last.sensitivity_before[0, 0] + last.before[1] * last.time_sensitivity[0])
    close(moved, -(0.7 * 6.5**2 / 9.81**2) / 3.0 / np.sin(slack), 1e-7)


def test_lanes_have_the_events_of_noncontributing_forces():
    system = swinging(noncontributing_forces=[TENSION])
    events = [Event(TENSION, direction=-1, reset={U: -U}, name="slack")]
    ends = system.integrate_ensemble(constants={"l": [0.7, 0.65]}, events=events, reduce="final")
    for k, length in enumerate((0.7, 0.65)):
        system.constants[LENGTH] = length
        motion = system.simulate(events=events)
        assert len(motion.events) == 1
        np.testing.assert_array_equal(ends["q"][k], motion["q"][-1])


def test_an_event_of_a_force_that_is_not_computed_says_how_to_compute_it():
    with pytest.raises(ValueError, match=r"`S\(t\)`, a non.*Name it in `noncontributing_forces`"):
        swinging().simulate(events=[Event(TENSION)])
