"""Jacobians that are computed in parts, against differences of the equations themselves."""

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import (
    KanesMethod,
    Particle,
    Point,
    dynamicsymbols,
)

import zoo
from pydy.errors import PyDyUserWarning
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import system_of

LINKS = 7


@pytest.fixture(scope="module")
def system():
    """A chain whose first link is braked by c |u|^e, and a free mass: no force depends on it."""
    q, u = dynamicsymbols(f"q:{LINKS + 1}"), dynamicsymbols(f"u:{LINKS + 1}")
    m, g, length, c, e = sm.symbols("m g l c e")
    frame, place = inertial_frame()
    free = Point("F")
    free.set_vel(frame, u[-1] * frame.x)
    bodies, loads = [Particle("F", free, m)], [(free, m * g * frame.x)]
    for k in range(LINKS):
        link = frame.orientnew(f"A{k}", "Axis", [q[k], frame.z])
        link.set_ang_vel(frame, u[k] * frame.z)
        end = place.locatenew(f"P{k}", length * link.x)
        end.v2pt_theory(place, frame, link)
        bodies.append(Particle(f"P{k}", end, m))
        loads.append((end, m * g * frame.x))
        place = end
    brake = -c * sm.Abs(u[0]) ** e * sm.sign(u[0])
    loads.append((bodies[1].point, brake * frame.y))
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = KanesMethod(frame, q, u, rates, bodies=bodies, forcelist=loads)
    kane.kanes_equations()
    made = System(kane, constants={e: 0.5, c: 0.3, g: 9.81})
    assert "columns" in str(made.model.compiled_jacobian("rates", "x").program)
    return made


def differences(system, x, wide=1e-5):
    """Fourth-order central differences of the states' derivatives."""
    steps = wide * np.eye(len(x))
    at = np.concatenate([x + k * steps for k in (-2, -1, 1, 2)])
    a, b, c, d = system.evaluate_ode(at, np.zeros(len(at))).reshape(4, len(x), len(x))
    return ((a - 8 * b + 8 * c - d) / (12 * wide)).T


def state():
    return np.random.default_rng(4).uniform(0.3, 1.2, 2 * (LINKS + 1))


def test_a_speed_that_is_a_rate_and_nothing_else_has_its_column(system):
    x = state()
    found = system.evaluate_jacobian(x)
    assert np.allclose(found, differences(system, x), rtol=1e-7, atol=1e-7)
    assert found[LINKS, -1] == 1.0


def test_the_rolling_disc_moves_with_its_last_speed():
    disc = system_of(zoo.disc())
    x = np.full(len(disc.states), 0.4)
    found = disc.evaluate_jacobian(x)
    assert np.allclose(found, differences(disc, x), rtol=1e-7, atol=1e-7)


def test_an_infinite_derivative_leaves_other_columns_finite(system):
    states = np.tile(state(), (130, 1))
    states[:, 0] += np.linspace(0.0, 0.1, 130)
    at_rest = np.arange(130) % 2 == 0
    brake = LINKS + 1
    states[at_rest, brake] = 0.0
    with pytest.warns(PyDyUserWarning, match="not finite"):
        found = system.evaluate_jacobian(states, np.zeros(130))
    others = np.arange(states.shape[1]) != brake
    assert np.isfinite(found[:, :, others]).all()
    assert np.isfinite(found[~at_rest]).all()
    assert not np.isfinite(found[at_rest, brake:-1, brake]).any()
    for k in (0, 1, 128):
        expected = differences(system, states[k])[:, others]
        assert np.allclose(found[k][:, others], expected, rtol=1e-7, atol=1e-7)
    np.testing.assert_array_equal(system.evaluate_jacobian(states[1]), found[1])


def test_a_variable_may_have_several_columns(system):
    x, states = state(), system.states
    whole = system.evaluate_jacobian(x)
    places = [*range(len(states)), 3, 3, 9, 0]
    found = system.evaluate_jacobian(x, wrt=[states[k] for k in places])
    assert np.allclose(found, whole[:, places], rtol=1e-10, atol=1e-10)
