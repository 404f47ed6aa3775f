"""Events whose expressions become NaN: nobody can say whether they cross zero from there on."""

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import dynamicsymbols

from pydy._errors import IntegrationError
from pydy.solvers import Event
from pydy.solvers.outcome import Outcome
from registry import SOLVER_NAMES
from zoo.ball import bouncing_ball

ALL = SOLVER_NAMES
T = dynamicsymbols._t
Z, V = dynamicsymbols("q u")
FALL = float(np.sqrt(2.0 * 0.05 / 9.81))  # from z = 1 to 0.95
ROOT = sm.sqrt(Z - sm.Rational(19, 20))


def ball(solver="dop853", **options):
    system, _ = bouncing_ball()
    system.initial_conditions, system.times = {Z: 1.0, V: 0.0}, np.linspace(0.0, 2.0, num=41)
    system.ode_solver = solver
    for name, value in options.items():
        setattr(system, name, value)
    return system


def run(system, events, **options):
    accurate = {"step": 1e-3} if system.ode_solver.name == "rk4" else {"rtol": 1e-11, "atol": 1e-11}
    return system.integrate(events=events, full_output=True, **accurate, **options)


def error_of(system, events, **options):
    with pytest.raises(
        IntegrationError, match=r"becomes NaN there, at t = .* both sides"
    ) as caught:
        run(system, events, **options)
    assert caught.value.info["code"] == Outcome.EVENT_UNDEFINED
    return caught.value


@pytest.mark.parametrize("terminal", [True, False])
@pytest.mark.parametrize("solver", ALL)
def test_the_run_ends_where_the_expression_becomes_nan(solver, terminal):
    error = error_of(ball(solver), [Event(ROOT, terminal=terminal, name="low")])
    assert "`low`" in str(error)
    assert error.time == pytest.approx(FALL, abs=1e-13)
    np.testing.assert_allclose(error.state, [0.95, -9.81 * FALL], rtol=1e-12)
    np.testing.assert_array_equal(error.times, [0.0, 0.05, 0.1])
    np.testing.assert_allclose(error.states[:, 0], 1.0 - 9.81 / 2.0 * error.times**2, rtol=1e-12)


def test_crossings_before_that_are_events_in_their_direction():
    shallow = ROOT - sm.Rational(1, 1000)
    for direction, count in ((0, 1), (-1, 1), (1, 0)):
        error = error_of(ball(), [Event(shallow, direction=direction)])
        assert error.time == pytest.approx(FALL, abs=1e-13)
        (*times,) = (record.time for record in error.info["events"])
        np.testing.assert_allclose(times, [np.sqrt(2.0 * (0.05 - 1e-6) / 9.81)] * count, rtol=1e-11)


def test_an_expression_that_is_zero_at_its_last_number_has_not_crossed():
    error = error_of(ball(), [Event(sm.sqrt(1 - T))])
    assert error.time == pytest.approx(1.0, abs=1e-15)


def test_a_terminal_event_at_or_before_that_ends_the_run_as_ever():
    for end in (sm.Rational(19, 20), sm.Rational(24, 25)):
        _, info = run(ball(), [Event(ROOT), Event(Z - end, terminal=True)])
        assert info["code"] == Outcome.TERMINATED


def test_a_reset_into_nan_is_told():
    jump = Event(Z - sm.Rational(24, 25), reset={Z: sm.Rational(9, 10)}, name="jump")
    error = error_of(ball(), [Event(ROOT, name="low"), jump])
    assert "`low`" in str(error)
    assert [record.name for record in error.info["events"]] == ["jump"]


def test_an_expression_that_is_nan_at_first_is_watched_once_it_is_a_number():
    system = ball(initial_conditions={Z: 0.9, V: 2.0}, times=[0.0, 0.1])
    _, info = run(system, [Event(ROOT - 0.1)], max_step=1e-3)
    (record,) = info["events"]
    assert record.before[0] == pytest.approx(0.96, rel=1e-12)


def test_in_an_ensemble_each_sample_has_its_status():
    system = ball(times=np.linspace(0.0, 0.12, num=5))
    heights = [1.0, 2.0, 1.0]
    found = system.integrate_ensemble(initial_conditions={Z: heights}, events=[Event(ROOT)])
    np.testing.assert_array_equal(
        found.status, [Outcome.EVENT_UNDEFINED, Outcome.FINISHED, Outcome.EVENT_UNDEFINED]
    )
    np.testing.assert_allclose(found.end_time, [FALL, 0.12, FALL], rtol=1e-8)


def test_sensitivities_and_gradients_end_there_too():
    system = ball()
    with pytest.raises(IntegrationError, match="becomes NaN there"):
        system.simulate(sensitivities=["g"], events=[Event(ROOT)])
    with pytest.raises(IntegrationError, match="becomes NaN there"):
        system.adjoint_gradient(["g"], final=Z, events=[Event(ROOT)])


def test_an_error_hands_over_the_events_before_it():
    passed = Event(Z - sm.Rational(97, 100), name="passed")
    error = error_of(ball(), [Event(ROOT), passed])
    assert [record.name for record in error.info["events"]] == ["passed"]
    limit = {"max_step": 1e-3, "max_steps": 200}
    with pytest.raises(IntegrationError, match="max_steps") as caught:
        run(ball(), [passed], **limit)
    assert [record.name for record in caught.value.info["events"]] == ["passed"]
