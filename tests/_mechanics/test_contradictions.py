"""Kinematics that contradict themselves or leave gaps are read as SymPy reads them."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles.oracle import Oracle
from pydy._mechanics.frame_tree import FrameTree
from pydy.system import System
from zoo import Model, T, _numbers, inertial_frame
from zoo.by_hand import derived, state
from zoo.cases import close


def ground():
    frame, origin = inertial_frame()
    return frame, origin, list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))


def agrees(frame, q, u, bodies, loads, constants, kd=None):
    kd = kd or [a.diff(T) - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=kd, bodies=bodies, forcelist=loads)
    model = Model(kane, _numbers(*constants))
    system = System(kane)
    known = system.constants_symbols
    system.constants = {k: v for k, v in model.constants.items() if k in known}
    x, t = state(model, 3)
    found = system.evaluate_ode(x, t)
    close(found, Oracle(derived(model)).xdot(x, t), 1e-12)


@pytest.mark.filterwarnings("ignore:The kinematic equations do not fit")
@pytest.mark.filterwarnings("ignore:The velocities that were set for Q")
def test_a_point_between_two_velocities_takes_the_first_of_the_nearest():
    frame, origin, q, u = ground()
    m, n, c = sm.symbols("m n c")
    arm, fork = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    arm.orient_axis(frame, frame.z, q[0])
    fork.orient_axis(arm, arm.x, q[1])
    inner = origin.locatenew("P", c * arm.x)
    middle = inner.locatenew("Q", c * fork.y + q[2] * fork.z)
    outer = middle.locatenew("R", c * fork.z + c * arm.y)
    middle.set_vel(frame, u[0] * arm.y + 2 * u[1] * fork.x + u[2] * sm.cos(q[0]) * frame.z)
    bodies = [me.Particle("p", inner, m), me.Particle("q", middle, n), me.Particle("r", outer, m)]
    agrees(frame, q, u, bodies, [(outer, q[2] * fork.x)], [m, n, c])


def test_points_take_their_velocities_from_points_that_loads_asked_for_before():
    frame, origin, q, u = ground()
    m, n, c = sm.symbols("m n c")
    arm = me.ReferenceFrame("A")
    arm.orient_axis(frame, frame.z, q[0])
    other, between = me.Point("K"), me.Point("P")
    other.set_vel(frame, u[1] * frame.x)
    between.set_pos(origin, c * frame.x + q[0] * arm.y)
    between.set_pos(other, c * arm.x + q[1] * arm.y)
    end = between.locatenew("Q", c * arm.y + q[1] * arm.z)
    bodies = [me.Particle("p", between, n), me.Particle("q", end, m)]
    agrees(frame, q[:2], u[:2], bodies, [(end, -m * frame.y), (other, u[1] * frame.x)], [m, n, c])


@pytest.mark.filterwarnings("ignore:The accelerations that were set for A")
def test_accelerations_of_the_users_hold_for_their_own_point_and_frame_alone():
    frame, origin, q, u = ground()
    m, n, c = sm.symbols("m n c")
    inertias = sm.symbols("I J K")
    arm, fork = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    arm.orient_axis(frame, frame.z, q[0])
    fork.orient_axis(arm, arm.x, q[1])
    arm.set_ang_acc(frame, (u[0].diff(T) + u[0] * u[1]) * frame.z)
    inner = origin.locatenew("P", c * arm.x)
    inner.set_acc(frame, c * q[0].diff(T, 2) * arm.y - 3 * u[0] ** 2 * arm.x)
    outer = inner.locatenew("Q", c * fork.y)
    bodies = [
        me.RigidBody("p", inner, arm, m, (me.inertia(arm, *inertias), inner)),
        me.RigidBody("q", outer, fork, n, (me.inertia(fork, *inertias), outer)),
    ]
    agrees(frame, q[:2], u[:2], bodies, [(outer, -n * frame.y)], [m, n, c, *inertias])


def test_of_equally_short_ways_to_the_inertial_frame_the_first_is_taken():
    frame, left, right, own = (me.ReferenceFrame(name) for name in "NLRB")
    u = me.dynamicsymbols("u1:5")
    left.set_ang_vel(frame, u[0] * frame.x)
    right.set_ang_vel(frame, u[1] * frame.x)
    own.set_ang_vel(right, u[2] * frame.x)
    own.set_ang_vel(left, u[3] * frame.x)
    assert own.ang_vel_in(frame) == (u[1] + u[2]) * frame.x
    assert FrameTree(frame).turns_in(own) is right


@pytest.mark.parametrize("oriented", [True, False])
def test_a_wheel_needs_no_spin_angle_where_its_inertia_is_given_in_the_fork(oriented):
    frame, _, q, u = ground()
    m, r, across, along, g = sm.symbols("m r across along g")
    yawed, fork, wheel = (me.ReferenceFrame(name) for name in "YFW")
    yawed.orient_axis(frame, frame.z, q[0])
    fork.orient_axis(yawed, yawed.x, q[1])
    if oriented:
        wheel.orient_axis(fork, fork.y, 0)
    turning = u[0] * fork.x + u[2] * fork.z
    fork.set_ang_vel(frame, turning + u[2] * sm.tan(q[1]) * fork.y)
    wheel.set_ang_vel(frame, turning + u[1] * fork.y)
    contact = me.Point("P")
    contact.set_vel(frame, 0)
    centre = contact.locatenew("C", r * fork.z)
    centre.v2pt_theory(contact, frame, wheel)
    kd = [
        q[0].diff(T) - u[2] / sm.cos(q[1]),
        q[1].diff(T) - u[0],
        q[2].diff(T) - u[1] + u[2] * sm.tan(q[1]),
    ]
    inertia = me.inertia(fork, across, along, across)
    body = me.RigidBody("wheel", centre, wheel, m, (inertia, centre))
    loads = [(centre, -m * g * frame.z)]
    agrees(frame, q, u, [body], loads, [m, r, across, along, g], kd)


@pytest.mark.filterwarnings("ignore:The inertia of the body b changes in its frame B")
def test_an_inertia_that_turns_in_its_body_changes():
    frame, origin, q, u = ground()
    m, c = sm.symbols("m c")
    inertias = sm.symbols("I1:7")
    arm, fork = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    arm.orient_axis(frame, frame.z, q[0])
    fork.orient_axis(arm, arm.x, q[1])
    centre = origin.locatenew("C", c * fork.y)
    body = me.RigidBody("b", centre, fork, m, (me.inertia(arm, *inertias), centre))
    agrees(frame, q[:2], u[:2], [body], [(centre, -m * arm.y)], [m, c, *inertias])
