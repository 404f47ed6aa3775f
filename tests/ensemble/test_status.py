"""How a sample ended: its `status`, with the codes of single integrations."""

from pathlib import Path

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.ensemble import after_end
from pydy.ensemble.model import EnsembleModel
from pydy.errors import PyDyUserWarning
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event
from pydy.solvers.outcome import Outcome
from zoo import loops
from zoo.cases import system_of
from zoo.ensemble_cases import constant, runaway

GRAVITY = 9.81


@pytest.fixture
def ball():
    """A mass that falls from a height."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    mass = constant(system, "m0")
    system.specifieds = {force: -GRAVITY * mass}
    system.constants = {constant(system, "k0"): 0.0, constant(system, "c0"): 0.0}
    system.times = np.linspace(0.0, 10.0, num=21)
    return system


def names(results):
    """The status of each sample in words, as users read it."""
    attrs = results.status.attrs
    meanings = dict(zip(attrs["flag_values"], attrs["flag_meanings"].split(), strict=True))
    return [meanings[code] for code in np.atleast_1d(results.status.values)]


def test_bounces_that_accumulate_have_a_status_and_end_at_the_accumulation_point(ball):
    height, velocity = ball.states
    bounce = Event(height, direction=-1, reset={velocity: -velocity / 2}, name="bounce")
    heights = np.array([1.0, 4.0])
    results = ball.integrate_ensemble(initial_conditions={height: heights}, events=[bounce])
    assert names(results) == ["events_accumulate", "events_accumulate"]
    accumulation = 3.0 * np.sqrt(2.0 * heights / GRAVITY)
    np.testing.assert_allclose(results.end_time, accumulation, atol=1e-6)
    for sample, end in enumerate(accumulation):
        np.testing.assert_array_equal(np.isfinite(results.x0[sample]), ball.times < end)


def test_constraints_not_met_at_the_start_have_their_own_status():
    system = system_of(zoo.fourbar(), times=[0.0, 0.1])
    good = dict(system.initial_conditions)
    angle = system.coordinates[0]
    start = {**good, angle: [good.get(angle, 0.0), good.get(angle, 0.0) + 0.2]}
    with pytest.warns(PyDyUserWarning, match="1 of 2 samples, .* each sample in `initial_cond"):
        results = system.integrate_ensemble(initial_conditions=start, constraints="project")
    assert names(results) == ["finished", "start_off_constraints"]
    np.testing.assert_array_equal(results.end_time, [0.1, 0.0])


@pytest.mark.parametrize("reduce", [None, "final", "events", ["final", ("max", "q1")]])
@pytest.mark.parametrize("terminal", [False, True])
def test_a_sample_that_left_its_constraints_is_seen_whatever_is_reduced(reduce, terminal):
    """A reduction needs few times, and an event may end the motion before the last of them."""
    system = loops.system_of("three_cranks", np.linspace(0.0, 3.0, 61), "dop853")
    symbol, value = next(iter(system.constants.items()))
    stop = Event(me.dynamicsymbols._t - 2.85, terminal=terminal, name="stop")
    results = system.integrate_ensemble(
        constants={symbol: [value, value]},
        events=stop, reduce=reduce, rtol=1e-10, atol=1e-10,
    )  # fmt: skip
    assert names(results) == ["left_constraints"] * 2
    assert (results.end_time == 1.55).all()
    if reduce == "events":
        assert (results.stop_count == 0).all()


def test_lanes_and_single_integrations_give_the_same_codes(monkeypatch):
    system, x, v, _ = runaway()
    start = {x: 0.0, v: [0.1, 1.0]}
    lanes = system.integrate_ensemble(initial_conditions=start, max_steps=1000)
    assert lanes.attrs["lanes"] == 8
    monkeypatch.setattr(EnsembleModel, "in_lanes", False)
    single = system.integrate_ensemble(initial_conditions=start, max_steps=1000)
    assert single.attrs["lanes"] == 1
    assert names(lanes) == names(single) == ["finished", "step_underflow"]


def test_an_event_that_cannot_be_looked_for_is_named_in_the_status(ball):
    height, _ = ball.states
    results = ball.integrate_ensemble(
        initial_conditions={height: [1.0, 2.0]}, events=[Event(sm.Integer(1))]
    )
    assert names(results) == ["event_constant"] * 2


def test_a_reset_that_is_not_finite_is_named_in_the_status(ball):
    height, velocity = ball.states
    landing = Event(height, direction=-1, reset={velocity: sm.log(height - 1)})
    results = ball.integrate_ensemble(initial_conditions={height: [1.0, 1e4]}, events=[landing])
    assert names(results) == ["reset_not_finite", "finished"]


def test_every_code_is_among_the_flags(ball):
    height, _ = ball.states
    results = ball.integrate_ensemble(initial_conditions={height: 1.0})
    assert repr(results.status.attrs["flag_values"]) == repr(list(range(-1, len(Outcome) - 1)))


@pytest.mark.parametrize("outcome", Outcome)
def test_the_documentation_lists_every_code(outcome):
    page = Path(__file__).parents[2] / "docs" / "ensembles.md"
    number = str(int(outcome)).replace("-", "−")
    assert f"| {number} | `{outcome.flag}` |" in page.read_text("utf-8")


def test_times_after_the_end_follow_an_event_and_no_failure(ball):
    height, velocity = ball.states
    speeds = {velocity: np.array([0.0, 9.0, -1.0])}
    landing = Event(height, direction=-1, terminal=True)
    results = ball.integrate_ensemble(
        initial_conditions={height: 1.0, **speeds}, events=[landing], max_steps=40
    )
    late = after_end(results, ball.times)
    ends = (speeds[velocity] + np.sqrt(speeds[velocity] ** 2 + 2.0 * GRAVITY)) / GRAVITY
    np.testing.assert_array_equal(late, ball.times > ends[:, None])
    failed = ball.integrate_ensemble(constants={"k0": [1e4, 2e4]}, max_steps=2)
    assert names(failed) == ["too_many_steps", "too_many_steps"]
    assert not after_end(failed, ball.times).any()
