"""Native solvers with descending times, called directly."""

import pickle

import numpy as np
import pytest

from pydy.errors import IntegrationError
from pydy.inputs import SampledInput
from pydy.solvers import dop853, rk4
from pydy.solvers.reflection import reflected_samples
from registry import SOLVERS

TIMES = np.array([2.0, 1.5, 1.5, 0.0, -1.0])


def decay(x, t):
    return [-x[0] * (1.0 + np.cos(t))]


def exact(times):
    return np.exp(-(times - 2.0) - np.sin(times) + np.sin(2.0))


def options(solver):
    return {"step": 1e-3} if solver is rk4 else {"rtol": 1e-11, "atol": 1e-12}


@pytest.mark.parametrize("solver", SOLVERS, ids=lambda s: s.name)
def test_growth_backward_follows_its_closed_form(solver):
    x, info = solver(decay, [1.0], TIMES, full_output=True, **options(solver))
    np.testing.assert_allclose(x[:, 0], exact(TIMES), rtol=1e-8)
    assert info["time"] == -1.0
    assert info["last_step"] > 0.0


@pytest.mark.parametrize("solver", SOLVERS, ids=lambda s: s.name)
def test_dense_output_takes_times_in_either_order(solver):
    more = {"full_output": True, "dense_output": True, **options(solver)}
    dense = solver(decay, [1.0], [2.0, -1.0], **more)[1]["dense_output"]
    at = np.linspace(-1.0, 2.0, num=31)
    np.testing.assert_allclose(dense(at)[:, 0], exact(at), rtol=1e-7)
    np.testing.assert_array_equal(dense(at[::-1]), dense(at)[::-1])
    assert dense(np.array([2.0]))[0, 0] == 1.0


def test_a_prepared_integration_has_the_users_times_and_is_pickled():
    prepared = dop853.prepare(decay, [1.0], TIMES, rtol=1e-9)
    np.testing.assert_array_equal(prepared.times, TIMES)
    again = pickle.loads(pickle.dumps(prepared))
    np.testing.assert_array_equal(again([2.0]), prepared([2.0]))


@pytest.mark.parametrize("kind", ["linear", "pchip", "previous"])
def test_reflected_samples_have_the_values_at_the_opposite_time(kind):
    values = np.array([[1.0, 0.0], [-2.0, 3.0], [0.5, 0.5], [4.0, 1.0]])
    samples = SampledInput([-1.0, 0.0, 0.7, 2.0], values, kind)
    other = reflected_samples(samples)
    between = np.linspace(-0.99, 1.99, num=200)
    np.testing.assert_allclose(other(-between), samples(between), atol=1e-14)
    # at a jump, what holds on the way on: in reversed time the sample before
    expected = values[[0, 1]] if kind == "previous" else values[[1, 2]]
    np.testing.assert_allclose(other([0.0, -0.7]), expected, atol=1e-14)


def test_what_a_function_raises_or_returns_wrongly_is_told_as_forward():
    with pytest.raises(ValueError, match=r"What `f\(x, t\)` returns, one derivative"):
        dop853(lambda x, t: [1.0, 2.0], [1.0], [1.0, 0.0])
    with pytest.raises(ZeroDivisionError):
        dop853(lambda x, t: 1 / 0, [1.0], [1.0, 0.0])
    with pytest.raises(IntegrationError, match="at t = ") as told:
        dop853(lambda x, t: [x[0] ** 2], [-1.0], [1.0, 0.5, -1.0])  # x = −1/t
    np.testing.assert_array_equal(told.value.times, [1.0, 0.5])
    assert abs(told.value.time) < 1e-6


def test_times_that_turn_back_are_refused():
    with pytest.raises(ValueError, match=r"got 3\.0 after 1\.0 at index 2 of descending ones"):
        dop853(decay, [1.0], [4.0, 1.0, 3.0, 0.0])
