"""Motions with recorded steps: what a backward pass repeats."""

import numpy as np
import pytest

from pydy._integration import GradientEquations, integrate_recorded
from pydy._motion import prepare
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event, dop853


def recorded(integral=None, **options):
    system = multi_mass_spring_damper()
    system.initial_conditions = {"x0": 1.0}
    problem, times = system._now(), np.linspace(0.0, 5.0, 6)
    ready, times = prepare(problem, times, dop853, options)
    equations = GradientEquations.for_parameters(problem, ready.code, "k0", None, integral)
    return integrate_recorded(problem, dop853, ready, times, equations)


def test_steps_follow_one_another_from_the_start_to_the_end():
    recording = recorded(rtol=1e-9, atol=1e-9)
    steps = recording.steps
    assert len(steps.starts) > 5
    np.testing.assert_array_equal(steps.starts[1:], steps.ends[:-1])
    assert steps.starts[0] == 0.0
    assert steps.ends[-1] == steps.end == 5.0
    assert not steps.stopped
    np.testing.assert_array_equal(steps.states[0], recording.motion.problem.x)
    np.testing.assert_array_equal(steps.end_state, recording.motion.states[-1])


def test_steps_have_the_integral_after_the_states():
    position, _ = multi_mass_spring_damper().states
    recording = recorded(integral=position)
    assert recording.steps.states.shape[1] == 3
    assert recording.motion.states.shape[1] == 2
    end_state = recording.steps.end_state
    assert recording.rates(end_state, recording.steps.end)[2] == end_state[0]


def test_an_event_ends_a_step_early_and_has_derivatives():
    position, _ = multi_mass_spring_damper().states
    recording = recorded(events=[Event(position, terminal=True)])
    (record,) = recording.steps.events
    assert recording.steps.stopped
    assert recording.steps.ends[-1] == record.time == recording.steps.end
    derivatives = recording.event_derivatives(record)
    assert derivatives.changed == ()
    assert derivatives.time[0] == pytest.approx(-1.0 / record.before[1])
