"""Motions whose ends are published, of problems that other multibody codes are compared by."""

import numpy as np
import pytest
import scipy
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame
from zoo.singular import defined_windows

T = me.dynamicsymbols._t


@pytest.mark.parametrize("solver", ["dop853", "vern9", "radau"])
def test_a_pendulum_from_the_horizontal_ends_where_the_iftomm_library_says(solver):
    # A01, the simple pendulum, https://www.iftomm-multibody.org/benchmark/: the place after 10 s.
    angle, rate = me.dynamicsymbols("a ua")
    frame, origin = inertial_frame()
    bob = origin.locatenew("P", sm.cos(angle) * frame.x + sm.sin(angle) * frame.y)
    made = Definition(
        frame,
        [angle],
        [rate],
        bodies=[me.Particle("bob", bob, 1)],
        loads=[(bob, -9.81 * frame.y)],
    )
    system = System(made, initial_conditions={angle: np.pi}, ode_solver=solver)
    system.times = [0.0, 10.0]
    end = system.simulate(rtol=1e-12, atol=1e-12)["a"][-1]
    expected = [-0.275087462576, -0.961419205099]
    np.testing.assert_allclose([np.cos(end), np.sin(end)], expected, rtol=0, atol=2e-11)


def test_two_windows_end_where_their_pendulum_does():
    # A02 of the same library with two windows, through twenty singular positions. Their posts stay
    # parallel: ((N + 1)/3 + N) φ″ = ((N + 1)/2 + N) g sin φ, whose end is from 30 digits.
    made = defined_windows(2)
    system = System(made, ode_solver="vern9", constants={"m": 1.0, "l": 1.0, "g": 9.81})
    for q, u in zip(made.coordinates, made.speeds, strict=True):
        post = str(q).startswith("a")
        system.initial_conditions[q] = np.pi / 2 if post else 0.0
        system.initial_conditions[u] = -1.0 if post else 0.0
    system.times = [0.0, 10.0]
    end = system.simulate(rtol=1e-10, atol=1e-10, constraints="project")["a0"][-1]
    expected = [0.32845811154, 0.94451853818]
    np.testing.assert_allclose([np.cos(end), np.sin(end)], expected, rtol=0, atol=1e-7)


@pytest.mark.parametrize("solver", ["dop853", "vern9", "radau"])
def test_the_car_axis_ends_where_the_ivp_test_set_says(solver):
    # F. Mazzia and C. Magherini, Test Set for IVP Solvers, release 2.4, "Car axis problem": an axle
    # of a car on springs that a bumpy road moves; rheonomic constraints; eight values at t = 3.
    q = left, height, right, other = me.dynamicsymbols("xl yl xr yr")
    u = me.dynamicsymbols("u1:5")
    mass = sm.Rational(1, 100) ** 2 * 10 / 2
    bump = sm.sin(10 * T) / 10
    across = sm.sqrt(1 - bump**2)
    frame, origin = inertial_frame()
    wheel = origin.locatenew("B", across * frame.x + bump * frame.y)
    ends = [
        origin.locatenew(name, x * frame.x + y * frame.y)
        for name, x, y in (("L", left, height), ("R", right, other))
    ]
    loads = [(end, -mass * frame.y) for end in ends]
    for foot, end in zip((origin, wheel), ends, strict=True):
        spring = end.pos_from(foot)
        length = sm.sqrt(spring.dot(spring))
        loads.append((end, (sm.Rational(1, 2) - length) / length * spring))
    made = Definition(
        frame,
        q,
        u,
        bodies=[me.Particle(end.name, end, mass) for end in ends],
        loads=loads,
        holonomic_constraints=[
            left * across + height * bump,
            (left - right) ** 2 + (height - other) ** 2 - 1,
        ],
    )
    start = [0.0, 0.5, 1.0, 0.5, -0.5, 0.0, -0.5, 0.0]
    system = System(made, initial_conditions=dict(zip([*q, *u], start, strict=True)))
    system.ode_solver, system.times = solver, [0.0, 3.0]
    motion = system.simulate(rtol=1e-11, atol=1e-11, constraints="project")
    published = [
        0.493455784275402809122e-1, 0.496989460230171153861, 0.104174252488542151681e1,
        0.373911027265361256927, -0.770583684040972357970e-1, 0.744686658723778553466e-2,
        0.175568157537232222276e-1, 0.770341043779251976443,
    ]  # fmt: skip
    got = [motion[str(symbol)][-1] for symbol in (*q, *u)]
    np.testing.assert_allclose(got, published, rtol=0, atol=2e-9)


def heavy_top():
    """The equations of the body itself, with its rotation matrix; the place and spin after 1 s."""
    inertia = np.diag([15.234375, 0.46875, 15.234375])  # about the tip
    arm, weight = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, -15 * 9.81])

    def rates(t, state):
        turn, spin = state[:9].reshape(3, 3), state[9:]
        skew = np.cross(np.eye(3), spin)  # the matrix of ω ×
        torque = np.cross(arm, turn.T @ weight) - np.cross(spin, inertia @ spin)
        return np.concatenate([(turn @ skew).ravel(), np.linalg.solve(inertia, torque)])

    start = [*np.eye(3).ravel(), 0.0, 150.0, -4.61538]
    found = scipy.integrate.solve_ivp(rates, (0, 1), start, "DOP853", rtol=1e-13, atol=1e-13)
    return found.y[:9, -1].reshape(3, 3) @ arm, found.y[9:, -1]


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_the_heavy_top_of_bruls_and_cardona_moves_as_its_own_equations_say(solver):
    # O. Brüls and A. Cardona, "On the use of Lie group time integrators in multibody dynamics",
    # J. Comput. Nonlinear Dynam. 5 (2010) 031002, section 5: a fast top, by a quaternion.
    e, u = me.dynamicsymbols("e0:4"), me.dynamicsymbols("u1:4")
    frame, origin = inertial_frame()
    body = frame.orientnew("B", "Quaternion", e)
    spin = sum(w * axis for w, axis in zip(u, body, strict=True))
    body.set_ang_vel(frame, spin)
    centre = origin.locatenew("C", body.y)
    centre.v2pt_theory(origin, frame, body)
    moments = me.inertia(body, 0.234375, 0.46875, 0.234375)
    turned = sm.Matrix([
        [-e[1], -e[2], -e[3]], [e[0], -e[3], e[2]], [e[3], e[0], -e[1]], [-e[2], e[1], e[0]],
    ])  # fmt: skip
    made = Definition(
        frame,
        e,
        u,
        bodies=[me.RigidBody("top", centre, body, 15, (moments, centre))],
        loads=[(centre, -15 * 9.81 * frame.z)],
        kinematic_equations=list(sm.Matrix(e).diff(T) - turned * sm.Matrix(u) / 2),
    )
    start = dict(zip([*e, *u], [1.0, 0.0, 0.0, 0.0, 0.0, 150.0, -4.61538], strict=True))
    system = System(made, initial_conditions=start, ode_solver=solver, times=[0.0, 1.0])
    motion = system.simulate(rtol=1e-12, atol=1e-12)
    last = dict(zip(system.states, motion.states[-1], strict=True))
    place = [float(centre.pos_from(origin).dot(axis).xreplace(last)) for axis in frame]
    expected, spins = heavy_top()
    np.testing.assert_allclose(place, expected, rtol=0, atol=1e-8)
    np.testing.assert_allclose([last[w] for w in u], spins, rtol=0, atol=1e-6)
