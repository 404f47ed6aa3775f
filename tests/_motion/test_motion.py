"""Motions: the Problems where they begin and end, and what they know of their solver."""

import numpy as np
import pytest

from pydy._integration import SensitivityRequest, integrate, simulate
from pydy._motion import resolve_ode_solver
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event, dop853


@pytest.fixture
def problem():
    system = multi_mass_spring_damper()
    system.initial_conditions = {"x0": 1.0}
    return system._now()


def test_a_motion_goes_on_from_the_state_after_the_event_that_ended_it(problem):
    x, v = problem.definition.states
    turn = Event(x, reset={v: -v}, terminal=True)
    motion = integrate(problem, np.linspace(0.0, 10.0, 11), solver=dop853, events=[turn])
    (record,) = motion.events
    assert motion.last.t == record.time == motion.segments[-1].end
    np.testing.assert_array_equal(motion.last.x, record.after)
    np.testing.assert_array_equal(motion.first.x, problem.x)
    assert (motion.states[-1] != record.after).any()


def test_the_last_sensitivities_are_those_of_the_last_state(problem):
    times, request = np.linspace(0.0, 2.0, 5), SensitivityRequest("x0")
    motion = integrate(problem, times, solver=dop853, sensitivities=request)
    np.testing.assert_array_equal(motion.last_sensitivities, motion.sensitivities[-1])
    x, _ = problem.definition.states
    ended = integrate(
        problem, times * 5, solver=dop853, sensitivities=SensitivityRequest("x0"),
        events=[Event(x, terminal=True)],
    )  # fmt: skip
    (record,) = ended.events
    np.testing.assert_array_equal(ended.last_sensitivities, record.sensitivity_after)


def test_simulate_takes_parameters_in_place_of_a_request(problem):
    times, options = np.linspace(0.0, 2.0, 5), {"solver": dop853}
    for controlled in (False, True):
        request = SensitivityRequest(["x0", "k0"], controlled)
        asked = integrate(problem, times, sensitivities=request, **options)
        motion = simulate(
            problem, times, sensitivities=["x0", "k0"], control_sensitivities=controlled, **options
        )
        np.testing.assert_array_equal(motion.sensitivities, asked.sensitivities)
        (segment,) = motion.segments
        assert [str(p.symbol) for p in segment.augmented.parameters] == ["x0(t)", "k0"]
    with pytest.raises(TypeError, match="`control_sensitivities` must be"):
        simulate(problem, times, sensitivities="x0", control_sensitivities="yes", **options)


def test_rates_of_a_segment_are_those_of_its_equations(problem):
    motion = integrate(problem, np.linspace(0.0, 1.0, 3), solver=dop853)
    (segment,) = motion.segments
    expected = problem.at(motion.times, motion.states).rates()[-1]
    np.testing.assert_array_equal(segment.rates(1.0, motion.states[-1]), expected)
    np.testing.assert_allclose(segment.dense(np.array([0.5]))[0], motion.states[1], rtol=1e-9)


def test_a_motion_without_a_row_has_no_last_state(problem):
    """An event function of SciPy that ends the motion before the first of the times."""

    def moved(t, x):
        return x[0] - 0.9

    moved.terminal = True
    options = {"solver": resolve_ode_solver("RK45"), "events": [moved], "t_eval": [3.0]}
    motion = integrate(problem, np.linspace(0.0, 3.0, 4), **options)
    assert motion.states.shape == (0, 2)
    with pytest.raises(RuntimeError, match="ends: it ended before the first of the times"):
        _ = motion.last
