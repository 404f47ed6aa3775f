"""What users hold on to comes back from a pickle and does the same."""

import pickle

import numpy as np
import pytest

from pydy.models import n_link_pendulum_on_cart
from pydy.solvers import dop853
from pydy.system import System


def swing(t_and_x, t):
    return np.array([t_and_x[1], -t_and_x[0]])


@pytest.fixture(scope="module")
def system() -> System:
    system = n_link_pendulum_on_cart(2)
    system.initial_conditions = {"q1": 0.5}
    system.times = np.linspace(0.0, 1.0, num=5)
    system.ode_solver = "dop853"
    return system


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def test_a_scene_before_and_after_it_is_animated(system):
    trajectory = system.simulate()
    scene = system.scene()
    animated = system.scene().animate(trajectory)
    assert again(scene).animate(trajectory).html() == animated.html()
    assert again(animated).html(live={"g": (1, 20)}) == animated.html(live={"g": (1, 20)})


def test_a_gradient_takes_its_motion_along(system):
    gradient = system.adjoint_gradient(["m0"], final=system.coordinates[1] ** 2)
    found = again(gradient)
    assert (found.value, found["m0"], found.names) == (gradient.value, gradient["m0"], ("m0",))
    np.testing.assert_array_equal(found.trajectory.states, gradient.trajectory.states)


def test_a_prepared_integration_is_prepared_anew():
    times = np.linspace(0.0, 2.0, num=5)
    prepared = dop853.prepare(swing, [1.0, 0.0], times, rtol=1e-10, atol=1e-10)
    found = again(prepared)([0.0, 3.0])
    assert found[:, 0] == pytest.approx(3.0 * np.sin(times), abs=1e-8)
    np.testing.assert_array_equal(found, prepared([0.0, 3.0]))
