"""Brakes that hold: braking to rest on a slope, standing there, and starting again."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.contact import Contacts, Roll, kelvin_voigt
from pydy.errors import ContactError
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import BrushTire, WheelContact
from zoo import inertial_frame
from zoo.wheels import planar_wheel

R, M, I, G, K = 0.3, 400.0, 1.2, 9.81, 2e5
TIME = me.dynamicsymbols._t
SLOPE = np.arctan(0.1)
HEIGHT = R - M * G * np.cos(SLOPE) / K
HOLDS = M * G * np.sin(SLOPE) * HEIGHT  # the torque that holds the wheel


def braked(torque, drive=0.0, *, speed, times):
    """A wheel with a tire on a slope of 10 %, with a brake and a drive torque."""
    wheel = planar_wheel(M, I)
    u, v = me.dynamicsymbols("u v")
    (x, z, q), (vx, vz, w) = wheel.q, wheel.u
    N, O, C, W, body = wheel.N, wheel.O, wheel.C, wheel.W, wheel.body
    contact = WheelContact(
        body, N.y, R, O, N.z, N, lambda gap, rate: kelvin_voigt(gap, rate, K, 2e3)
    ).with_relaxation((0.3, 0.5), (u, v))
    tire = BrushTire(4000, stiffness=80e3, friction=0.9)
    weight = M * G * (np.sin(SLOPE) * N.x - np.cos(SLOPE) * N.z)
    coordinates, speeds = [x, z, q], [vx, vz, w]
    definition = Definition(
        N,
        [*coordinates, *contact.deflections],
        speeds,
        bodies=[body],
        loads=[(C, weight), (W, drive * N.y), *contact.loads(tire)],
        kinematic_equations=[
            *(a.diff() - b for a, b in zip(coordinates, speeds, strict=True)),
            *contact.kinematic_equations,
        ],
    )
    system = System(
        definition,
        ode_solver="radau",
        initial_conditions={z: HEIGHT, vx: speed, w: speed / HEIGHT},
        times=times,
    )
    return Contacts(system, [contact.brake(torque)]).simulate()


def ramp(start, end):
    return sm.Min(sm.Max((TIME - start) / (end - start), 0), 1)


def test_a_wheel_is_braked_to_rest_on_a_slope_stands_there_and_starts_again():
    times = np.concatenate([[0.0], np.linspace(5.0, 68.0, 127), np.linspace(68.5, 73.0, 10)])
    motion = braked(800.0 * (1 - ramp(68.0, 70.0)), speed=3.0, times=times)
    stops, starts = motion.events
    assert (stops.name, starts.name) == ("brake stops", "brake slips")
    standing = (times >= 5.0) & (times <= 68.0)
    assert np.ptp(times[standing]) > 60.0
    assert np.abs(motion["vx"][standing]).max() < 1e-8
    assert np.ptp(motion["x"][standing]) < 1e-7
    np.testing.assert_allclose(motion["brake_friction"][standing], -HOLDS, rtol=1e-9)
    # The torque falls from 800 N m to what holds in two seconds.
    assert starts.time == pytest.approx(68.0 + 2 * (1 - HOLDS / 800.0), abs=1e-6)
    acceleration = np.diff(motion["vx"][-2:]) / np.diff(times[-2:])
    expected = G * np.sin(SLOPE) / (1 + I / (M * HEIGHT**2))
    assert acceleration[0] == pytest.approx(expected, rel=1e-4)


def test_a_wheel_rolls_up_the_slope_stops_and_is_driven_on():
    times = np.concatenate([[0.0], np.linspace(5.0, 66.0, 62), np.linspace(66.5, 70.0, 8)])
    motion = braked(
        300.0 * ramp(0.0, 0.5) * (1 - ramp(66.0, 66.5)),
        -2.5 * HOLDS * ramp(65.0, 66.0),  # uphill is −x
        speed=-3.0,
        times=times,
    )
    standing = (times >= 5.0) & (times <= 65.0)
    assert np.abs(motion["vx"][standing]).max() < 1e-8
    np.testing.assert_allclose(motion["brake_friction"][standing], -HOLDS, rtol=1e-9)
    assert motion["vx"][-1] < -1.0
    assert (motion["vx"][times >= 67.0] < 0.0).all()


def test_a_brake_that_is_too_weak_slows_the_wheel_only():
    weak = 0.5 * HOLDS
    motion = braked(weak, speed=0.0, times=np.linspace(0.0, 4.0, 9))
    acceleration = np.diff(motion["vx"][-2:]) / 0.5
    expected = (G * np.sin(SLOPE) - weak / (M * HEIGHT)) / (1 + I / (M * HEIGHT**2))
    assert acceleration[0] == pytest.approx(expected, rel=1e-4)


def test_a_rigid_wheel_stands_by_friction_that_sticks():
    wheel = planar_wheel(M, I)
    (x, z, q), (vx, vz, w) = wheel.q, wheel.u
    N, O, C, body = wheel.N, wheel.O, wheel.C, wheel.body
    weight = M * G * (np.sin(SLOPE) * N.x - np.cos(SLOPE) * N.z)
    system = System(
        Definition(N, [x, z, q], [vx, vz, w], bodies=[body], loads=[(C, weight)]),
        ode_solver="dop853",
        initial_conditions={z: R, vx: 3.0, w: 3.0 / R},
        times=np.linspace(0.0, 65.0, 131),
    )
    brake = WheelContact(body, N.y, R, O, N.z, N).brake(500.0)
    road = Roll(body, R, on=O, normal=N.z, along=N.x, mu=0.9, axis=N.y, name="road")
    motion = Contacts(system, [road, brake]).simulate(rtol=1e-10, atol=1e-10)
    stop = 3.0 / ((500.0 / (M * R) - G * np.sin(SLOPE)) / (1 + I / (M * R**2)))
    assert motion.events[0].time == pytest.approx(stop, rel=1e-8)
    assert np.abs(motion["vx"][10:]).max() < 1e-14
    np.testing.assert_allclose(motion["brake_friction"][10:], -M * G * np.sin(SLOPE) * R, rtol=1e-9)


def test_a_torque_that_becomes_negative_is_named_and_its_positive_part_brakes():
    q, w = me.dynamicsymbols("q w")
    N, O = inertial_frame()
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, q)
    W.set_ang_vel(N, w * N.y)
    body = me.RigidBody("wheel", O, W, M, (me.inertia(W, 0, I, 0), O))
    plane = O.locatenew("plane", -R * N.z)
    plane.set_vel(N, 0)
    times = np.linspace(0.0, 4.0, 41)
    system = System(
        Definition(N, [q], [w], bodies=[body], loads=[]),
        ode_solver="dop853",
        initial_conditions={w: 20.0},
        times=times,
    )
    torque = 10.0 * (1 - TIME)
    wheel = WheelContact(body, N.y, R, plane, N.z, N)
    with pytest.raises(ContactError, match=r"`normal` of 'brake' became -.* Max\(0, \.\.\.\)"):
        Contacts(system, [wheel.brake(torque)]).simulate()
    motion = Contacts(system, [wheel.brake(sm.Max(0, torque))]).simulate(rtol=1e-10, atol=1e-10)
    pressed = np.minimum(times, 1.0)
    np.testing.assert_allclose(motion["w"], 20.0 - 10.0 / I * (pressed - pressed**2 / 2), rtol=1e-9)


def test_a_brake_turns_with_its_carrier():
    q, p, w, turn = me.dynamicsymbols("q p w turn")
    N, O = inertial_frame()
    A, W = me.ReferenceFrame("A"), me.ReferenceFrame("W")
    A.orient_axis(N, N.y, p)
    A.set_ang_vel(N, turn * N.y)
    W.orient_axis(A, A.y, q)
    W.set_ang_vel(A, w * A.y)
    C = O.locatenew("C", R * N.z)
    C.set_vel(N, 0)
    body = me.RigidBody("wheel", C, W, M, (me.inertia(W, 0, I, 0), C))
    contact = WheelContact(body, N.y, R, O, N.z, N)
    assert contact.brake(10.0, A).speeds(N) == (w,)
    assert sm.simplify(contact.brake(10.0).speeds(N)[0] - w - turn) == 0
    with pytest.raises(ValueError, match="`torque` must not be negative"):
        contact.brake(-1.0)
    with pytest.raises(TypeError, match="`carrier` must be a ReferenceFrame"):
        contact.brake(1.0, "axle")
