"""What a solver says when it cannot go on, and what it leaves."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._errors import IntegrationError
from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.solvers import dop853, rk4
from registry import ADAPTIVE, SOLVERS, step_options

Q, U = me.dynamicsymbols("q u")
K = sm.Symbol("k")
TIMES = np.array([0.0, 0.5, 1.25, 2.0])


def options_of(solver):
    return step_options(solver, 1e-8, 1e-3)


def failure(solver, f, x0, times, args=(), **options):
    with pytest.raises(IntegrationError) as caught:
        solver(f, x0, times, args, **{**options_of(solver), **options})
    error = caught.value
    assert isinstance(error, RuntimeError)
    assert f"`{solver.name}`" in str(error)
    assert f"at t = {error.time!r} in the state" in str(error)
    assert str(error).endswith(".")
    np.testing.assert_array_equal(error.times, np.array(times)[: len(error.times)])
    assert error.states.shape == (len(error.times), len(x0))
    assert np.isfinite(error.states).all()
    assert (error.times <= error.time).all()
    assert error.info["method"] == solver.name
    assert error.info["status"] in str(error)
    return error


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_tolerances_below_rounding_are_refused(solver):
    error = failure(solver, lambda x, t: x, [1.0], [0.0, 1.0], rtol=1e-17, atol=1e-20)
    assert "cannot start with rtol = 1e-17 and atol = 1e-20" in str(error)
    assert "use an rtol of at least 2.2e-15" in str(error)
    assert len(error.times) == 0


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_absolute_tolerances_alone_are_accepted_in_any_unit(solver, unit):
    x = solver(lambda x, t: x, [unit], [0.0, 1.0], rtol=0.0, atol=1e-10 * unit)
    x = x[0] if isinstance(x, tuple) else x
    np.testing.assert_allclose(x[-1], unit * np.e, rtol=1e-8)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_absolute_tolerances_may_be_zero(solver):
    x = solver(lambda x, t: -x, [1.0], [0.0, 1.0], rtol=1e-8, atol=0.0)
    np.testing.assert_allclose(x[1], np.exp(-1.0), rtol=1e-6)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_motion_that_runs_away_in_finite_time_stops_there(solver):
    error = failure(solver, lambda x, t: x**2, [1.0], TIMES)
    assert "needs ever smaller steps with a step size of" in str(error)
    assert "The motion is not smooth there, or it diverges" in str(error)
    assert abs(error.time - 1.0) < 1e-6
    np.testing.assert_array_equal(error.times, [0.0, 0.5])
    np.testing.assert_allclose(error.states, [[1.0], [2.0]], rtol=1e-6)
    assert error.state[0] > 1e6


def test_times_far_from_zero_are_told_of_where_steps_become_as_small_as_their_digits():
    """Mathieu's equation at the seconds since 1970, of which floats have seven decimals."""
    times = np.array([0.0, 4.0])

    t = me.dynamicsymbols._t
    f = generate_ode_function([U, -(1.0 - 6.0 * sm.cos(2.0 * t)) * Q], [Q], [U])

    options = {"rtol": 1e-12, "atol": 1e-12}
    assert np.isfinite(dop853(f, [1.0, 0.0], times, ((),), **options)).all()
    error = failure(dop853, f, [1.0, 0.0], 1.7e9 + times, ((),), **options)
    assert "floats tell times apart by 2.4e-07: let `times` start nearer to zero" in str(error)


def test_fixed_steps_stop_where_the_state_is_not_finite_any_more():
    def f(x, t):
        with np.errstate(over="ignore"):
            return x**2

    error = failure(rk4, f, [1.0], TIMES)
    assert "met derivatives or errors that are not finite with a step size of 0.001" in str(error)
    assert 1.0 < error.time < 1.1


@pytest.mark.parametrize("solver", SOLVERS)
def test_derivatives_that_are_not_finite_are_named_with_time_and_state(solver):
    def f(x, t):
        return [np.sqrt(1.0 - t) if t <= 1.0 else np.nan, x[0]]

    error = failure(solver, f, [0.0, 3.0], TIMES)
    assert "met derivatives or errors that are not finite" in str(error)
    assert "division by zero or a function outside its domain" in str(error)
    assert "x[0] = 0.66" in str(error)
    assert abs(error.time - 1.0) < 2e-3
    assert len(error.times) == 2


@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.parametrize("solver", SOLVERS)
def test_derivatives_that_are_not_finite_at_the_start_are_named(solver, bad):
    error = failure(solver, lambda x, t: [bad, 1.0], [0.0, 3.0], TIMES)
    assert "met derivatives or errors that are not finite" in str(error)
    assert error.time == 0.0
    assert "nan" not in str(error)


@pytest.mark.parametrize("solver", SOLVERS)
def test_too_many_steps_are_counted_rejected_ones_included(solver):
    error = failure(solver, lambda x, t: [x[1], -900.0 * x[0]], [1.0, 0.0], TIMES, max_steps=17)
    assert "took 17 steps, `max_steps`" in str(error)
    assert "Raise `max_steps`" in str(error)
    assert error.info["steps"] + error.info["rejected"] == 17


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_singular_mass_matrix_is_named_with_the_states(solver):
    f = generate_ode_function([U, -1], [Q], [U], [K], mass_matrix=sm.diag(1, Q + K))
    error = failure(solver, f, [0.0, 0.1], TIMES, args=([0.0],))
    assert "met a singular mass matrix" in str(error)
    assert "q(t) = 0, u(t) = 0.1" in str(error)
    assert error.time == 0.0


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_mass_matrix_that_becomes_singular_stops_there(solver):
    matrix = sm.diag(1, sm.Piecewise((2, Q < 1), (0, True)))  # and q' = 1
    f = generate_ode_function([1, 1], [Q], [U], mass_matrix=matrix)
    error = failure(solver, f, [0.0, 0.0], TIMES, args=((),))
    assert "met a singular mass matrix" in str(error)
    assert abs(error.time - 1.0) < 1e-3
    np.testing.assert_allclose(error.states[1], [0.5, 0.25], atol=1e-6)


def test_many_states_are_not_all_shown():
    error = failure(dop853, lambda x, t: x**2, np.ones(20), TIMES)
    assert "x[11] = " in str(error)
    assert "x[12]" not in str(error)
    assert "and 8 more" in str(error)


@pytest.mark.parametrize("way", [copy.copy, copy.deepcopy, lambda e: pickle.loads(pickle.dumps(e))])
def test_the_error_can_be_copied_and_pickled(way):
    error = failure(dop853, lambda x, t: x**2, [1.0], TIMES)
    other = way(error)
    assert type(other) is IntegrationError
    assert str(other) == str(error)
    assert other.time == error.time
    assert other.info == error.info
    for name in ("times", "states", "state"):
        np.testing.assert_array_equal(getattr(other, name), getattr(error, name))


def test_a_second_integration_after_a_failure_is_undisturbed():
    failure(dop853, lambda x, t: x**2, [1.0], TIMES)
    x = dop853(lambda x, t: -x, [1.0], [0.0, 1.0], rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x[1], np.exp(-1.0), atol=1e-9)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_state_that_is_zero_needs_an_atol(solver):
    error = failure(solver, lambda x, t: [0.0, x[0], 0.0], [1.0, 0.0, 0.0], [0.0, 1.0], atol=0.0)
    assert "and atol = 0" in str(error)
    assert str(error).endswith("of x[1], are compared with `atol` alone: pass one above 0.")
    error = failure(solver, lambda x, t: [np.nan, x[0]], [1.0, 0.0], [0.0, 1.0], atol=0.0)
    assert "not finite" in str(error)
