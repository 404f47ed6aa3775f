"""Derivatives of half-integer powers where they vanish, forward and in reverse."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame

T = me.dynamicsymbols._t
X, V = me.dynamicsymbols("x v")
M, K, G = sm.symbols("m k g")
DEPTH = sm.Max(-X, 0)
HALF = sm.Rational(1, 2)


def mass(force, place=0.0, **more):
    """A mass above a floor that pushes it."""
    frame, origin = inertial_frame()
    point = origin.locatenew("P", X * frame.y)
    point.set_vel(frame, V * frame.y)
    definition = Definition(
        frame, [X], [V], bodies=[me.Particle("p", point, M)],
        loads=[(point, (force - M * G) * frame.y)], kinematic_equations=[X.diff(T) - V],
    )  # fmt: skip
    constants = {M: 1.0, K: 1e3, G: 9.81}
    return System(definition, constants, initial_conditions={X: place}, **more)


FORCES = [
    K * DEPTH ** (3 * HALF),
    K * DEPTH ** (5 * HALF) * (1 + V),
    (K * DEPTH) ** (3 * HALF),
    K * DEPTH * sm.sqrt(DEPTH) * V,
    -K * sm.Abs(X) ** (3 * HALF) * sm.sign(X),
    K * sm.Piecewise((-X, X < 0), (0, True)) ** (3 * HALF),
]


@pytest.mark.parametrize("generator", ["llvm", "lambdify", "cython"])
def test_a_contact_at_touch_has_the_derivative_zero(generator):
    n = len(FORCES)
    x, v = me.dynamicsymbols(f"x:{n}"), me.dynamicsymbols(f"v:{n}")
    frame, origin = inertial_frame()
    masses, loads = [], []
    for k, force in enumerate(FORCES):
        point = origin.locatenew(f"P{k}", x[k] * frame.y)
        point.set_vel(frame, v[k] * frame.y)
        masses.append(me.Particle(f"p{k}", point, M))
        loads.append((point, (force.subs({X: x[k], V: v[k]}) - M * G) * frame.y))
    rates = [a.diff(T) - b for a, b in zip(x, v, strict=True)]
    definition = Definition(frame, x, v, bodies=masses, loads=loads, kinematic_equations=rates)
    system = System(definition, {M: 1.0, K: 1e3, G: 9.81}, initial_conditions=dict.fromkeys(x, 0.0))
    system.generate_ode_function(generator=generator)
    expected = np.eye(2 * n, k=n)
    np.testing.assert_array_equal(system.evaluate_jacobian(), expected)
    for one in np.eye(2 * n) if generator != "cython" else ():  # which is handed the same Programs
        np.testing.assert_array_equal(system.evaluate_jacobian_vector(one), expected @ one)
        np.testing.assert_array_equal(system.evaluate_vector_jacobian(one), one @ expected)
    assert not system.evaluate_jacobian(wrt=[K]).any()


@pytest.mark.parametrize("force", [K * DEPTH ** (3 * HALF), K * sm.sqrt(DEPTH)], ids=str)
def test_out_of_contact_derivatives_are_zero_and_within_they_are_right(force):
    out = mass(force, 0.1)
    assert out.evaluate_jacobian()[1].tolist() == [0.0, 0.0]
    assert out.evaluate_vector_jacobian([0.0, 1.0]).tolist() == [0.0, 0.0]
    depth = sm.Symbol("depth", positive=True)
    exact = float(-force.subs(DEPTH, depth).diff(depth).subs({K: 1000, depth: 0.1}))
    np.testing.assert_allclose(mass(force, -0.1).evaluate_jacobian()[1, 0], exact, rtol=1e-14)


def test_a_hertz_contact_starts_at_touch_with_radau_sensitivities_and_adjoint():
    times = np.linspace(0.0, 0.1, 5)
    system = mass(K * DEPTH ** (3 * HALF), times=times, ode_solver="radau")
    tight = {"rtol": 1e-10, "atol": 1e-10}
    implicit = system.integrate(**tight)
    system.ode_solver = "dop853"
    run = system.simulate(sensitivities=["k"], **tight)
    np.testing.assert_allclose(implicit, run.states, rtol=0, atol=1e-7)
    energy = system.evaluate_energy(run.states, run.times).kinetic
    work = -9.81 * run["x"] - 1e3 * 2.0 / 5.0 * np.maximum(-run["x"], 0.0) ** 2.5
    np.testing.assert_allclose(energy, work, atol=1e-8)
    found = np.asarray(run.sensitivity.values)[-1, 0, 0]
    ends = []
    for k in (1e3 - 0.1, 1e3 + 0.1):
        system.constants = {**system.constants, K: k}
        ends.append(system.integrate(**tight)[-1, 0])
    np.testing.assert_allclose(found, (ends[1] - ends[0]) / 0.2, rtol=1e-5)
    system.constants = {**system.constants, K: 1e3}
    gradient = system.adjoint_gradient(["k"], final=X, **tight)
    np.testing.assert_allclose(gradient.values, found, rtol=1e-6)


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("turned", [False, True])
def test_drag_of_what_is_at_rest_has_the_derivative_zero(generator, turned):
    """The drag −k |v| v of a disc that slides on a plane, along its own axes or the plane's."""
    c = sm.Symbol("c")
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    frame, body, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(frame, 0)
    body.orient_axis(frame, frame.z, q[2])
    body.set_ang_vel(frame, u[2] * frame.z)
    axes = body if turned else frame
    point = origin.locatenew("P", q[0] * frame.x + q[1] * frame.y)
    velocity = u[0] * axes.x + u[1] * axes.y
    point.set_vel(frame, velocity)
    disc = me.RigidBody("disc", point, body, M, (me.inertia(body, K, K, K), point))
    rates = [
        a.diff(T) - b
        for a, b in zip(q[:2], (velocity.dot(frame.x), velocity.dot(frame.y)), strict=True)
    ]
    definition = Definition(
        frame, q, u, bodies=[disc],
        loads=[(point, -c * sm.sqrt(velocity.dot(velocity)) * velocity)],
        kinematic_equations=[*rates, q[2].diff(T) - u[2]],
    )  # fmt: skip
    system = System(definition, {c: 0.7, M: 1.3, K: 0.2}, initial_conditions={q[2]: 0.4})
    system.generate_ode_function(generator=generator)
    expected = np.zeros((6, 6))
    expected[2, 5] = 1.0
    turn = np.cos(0.4), np.sin(0.4)
    expected[:2, 3:5] = [[turn[0], -turn[1]], [turn[1], turn[0]]] if turned else np.eye(2)
    np.testing.assert_allclose(system.evaluate_jacobian(), expected, atol=1e-16)
    for k in range(6):
        found = system.evaluate_vector_jacobian(np.eye(6)[k])
        np.testing.assert_allclose(found, expected[k], atol=1e-16)
    assert not system.evaluate_jacobian(wrt=[c]).any()
    x = np.array([0.1, 0.2, 0.4, 0.5, -0.3, 0.9])
    step = 1e-6 * np.eye(6)
    central = [(system.evaluate_ode(x + h) - system.evaluate_ode(x - h)) / 2e-6 for h in step]
    np.testing.assert_allclose(system.evaluate_jacobian(x), np.transpose(central), atol=1e-8)
