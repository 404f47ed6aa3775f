"""Kinematic equations beside the velocities that were set."""

import warnings

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

T = me.dynamicsymbols._t
TOLD = "The kinematic equations do not fit the velocities"


def body(turn, size=1.0):
    """A body in space with Euler angles, and components of its angular velocity as speeds."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    fixed, frame, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(fixed, 0)
    frame.orient_body_fixed(fixed, q, turn)
    follows = frame.ang_vel_in(fixed).to_matrix(frame)
    frame.set_ang_vel(fixed, sum((v * a for v, a in zip(u, frame, strict=True)), me.Vector(0)))
    centre = origin.locatenew("C", size * frame.x)
    centre.v2pt_theory(origin, fixed, frame)
    inertia = me.inertia(frame, size**2, 2 * size**2, 2 * size**2), centre
    rigid = me.RigidBody("body", centre, frame, 1, inertia)
    right = [a - b for a, b in zip(follows, u, strict=True)]
    wrong = [a.diff(T) - b for a, b in zip(q, u, strict=True)]
    return fixed, q, u, [rigid], right, wrong


@pytest.mark.parametrize("turn", ["XYZ", "ZXZ"])
@pytest.mark.parametrize("size", [1.0, 1e-9, 1e9])
def test_components_of_an_angular_velocity_are_no_rates_of_angles(turn, size):
    fixed, q, u, bodies, right, _ = body(turn, size)
    with pytest.warns(PyDyUserWarning, match=TOLD) as told:
        System(Definition(fixed, q, u, bodies=bodies))
    assert len(told) == 1
    assert "the angular velocity of B" in str(told[0].message)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, q, u, bodies=bodies, kinematic_equations=right))


def test_equations_of_kanes_method_are_compared_too():
    fixed, q, u, bodies, right, wrong = body("XYZ")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(me.KanesMethod(fixed, q, u, kd_eqs=right, bodies=bodies, forcelist=[]))
    with pytest.warns(PyDyUserWarning, match=TOLD):
        System(me.KanesMethod(fixed, q, u, kd_eqs=wrong, bodies=bodies, forcelist=[]))


def test_a_velocity_in_a_bodys_axes_is_no_rate_of_a_place():
    x, y, a, u, v, w = me.dynamicsymbols("x y a u v w")
    fixed, frame, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(fixed, 0)
    frame.orient_axis(fixed, fixed.z, a)
    frame.set_ang_vel(fixed, w * fixed.z)
    centre = origin.locatenew("C", x * fixed.x + y * fixed.y)
    centre.set_vel(fixed, u * frame.x + v * frame.y)
    car = me.RigidBody("car", centre, frame, 1, (me.inertia(frame, 1, 1, 1), centre))
    with pytest.warns(PyDyUserWarning, match=r"derivatives of x\(t\), y\(t\) .* velocity of C"):
        System(Definition(fixed, [x, y, a], [u, v, w], bodies=[car]))
    right = [
        x.diff(T) - u * sm.cos(a) + v * sm.sin(a),
        y.diff(T) - u * sm.sin(a) - v * sm.cos(a),
        a.diff(T) - w,
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, [x, y, a], [u, v, w], bodies=[car], kinematic_equations=right))


def test_a_rotor_without_an_angle_of_its_own_is_right():
    """No derivatives of the platform's angles fit the rotor's spin and the platform's."""
    fixed, q, u, bodies, right, _ = body("XYZ")
    spin = sm.Symbol("spin")
    platform, centre = bodies[0].frame, bodies[0].masscenter
    rotor = me.ReferenceFrame("R")
    rotor.orient_axis(platform, platform.z, 0)
    rotor.set_ang_vel(platform, spin * platform.z)
    inertia = me.inertia(platform, 1, 1, 2), centre
    bodies.append(me.RigidBody("rotor", centre, rotor, 1, inertia))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, q, u, bodies=bodies, kinematic_equations=right))


def test_a_wheel_that_rolls_along_a_line_needs_no_angle():
    x, v = me.dynamicsymbols("x v")
    r = sm.Symbol("r")
    fixed, frame, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(fixed, 0)
    frame.orient_axis(fixed, fixed.z, 0)
    frame.set_ang_vel(fixed, v / r * fixed.z)
    centre = origin.locatenew("C", x * fixed.x)
    wheel = me.RigidBody("wheel", centre, frame, 1, (me.inertia(fixed, 1, 1, 1), centre))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, [x], [v], bodies=[wheel]))


def test_a_frame_that_turns_with_a_speed_of_kanes_has_no_part_in_lagranges_equations():
    q, u = me.dynamicsymbols("q u")
    fixed, frame, origin = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    origin.set_vel(fixed, 0)
    frame.orient_axis(fixed, fixed.z, q)
    frame.set_ang_vel(fixed, u * fixed.z)
    centre = origin.locatenew("C", frame.x)
    centre.set_vel(fixed, q.diff(T) * frame.y)
    bar = me.RigidBody("bar", centre, frame, 1, (me.inertia(frame, 1, 1, 1), centre))
    weight = [(centre, -fixed.y)]
    method = me.LagrangesMethod(me.Lagrangian(fixed, bar), [q], weight, [bar], fixed)
    for made in (method, Definition(fixed, [q], bodies=[bar], loads=weight)):
        with pytest.warns(PyDyUserWarning, match="the angular velocity of A would not be"):
            System(made)
