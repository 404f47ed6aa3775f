"""Accelerations that were set and are not the derivatives of velocities are warned of."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning

q = me.dynamicsymbols("q1:4")
u = me.dynamicsymbols("u1:4")
m, g, r, length = sm.symbols("m g r length")


def double_pendulum(accelerate, moment=1):
    """`accelerate` sets accelerations: of (A, B), the links' frames, and (O, P, Q), their ends."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    B = N.orientnew("B", "Axis", (q[1], N.z))
    for frame, speed in zip((A, B), u, strict=False):
        frame.set_ang_vel(N, speed * N.z)
    P = O.locatenew("P", length * A.x)
    Q = P.locatenew("Q", length * B.x)
    P.v2pt_theory(O, N, A)
    Q.v2pt_theory(P, N, B)
    accelerate(N, (A, B), (O, P, Q))
    kane = me.KanesMethod(N, q[:2], u[:2], [a.diff() - b for a, b in zip(q, u, strict=True)][:2])
    link = me.RigidBody("link", Q, B, m, (me.inertia(B, 0, 0, moment), Q))
    kane.kanes_equations([me.Particle("P", P, m), link], [(Q, -m * g * N.y)])
    return System(kane)


def test_the_acceleration_of_another_frame_is_told():
    def accelerate(N, frames, points):
        O, P, Q = points
        P.a2pt_theory(O, N, frames[0])
        Q.a2pt_theory(P, N, frames[0])

    with pytest.warns(PyDyUserWarning, match="accelerations that were set for Q are not"):
        double_pendulum(accelerate)


def test_a_wrong_angular_acceleration_is_told():
    def accelerate(N, frames, points):
        frames[1].set_ang_acc(N, (u[1].diff() + u[0] * u[1]) * N.z)

    with pytest.warns(PyDyUserWarning, match="accelerations that were set for B are not"):
        double_pendulum(accelerate)


def test_right_accelerations_are_not_told():
    def accelerate(N, frames, points):
        O, P, Q = points
        P.a2pt_theory(O, N, frames[0])
        Q.a2pt_theory(P, N, frames[1])
        frames[1].set_ang_acc(N, u[1].diff() * N.z)

    double_pendulum(accelerate)


@pytest.mark.parametrize("right", [True, False])
def test_accelerations_in_a_closed_loop_are_checked(right):
    """A crank and its rod, whose end Q slides along x."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    B = N.orientnew("B", "Axis", (q[1], N.z))
    for frame, speed in zip((A, B), u, strict=False):
        frame.set_ang_vel(N, speed * N.z)
    P, Q = O.locatenew("P", r * A.x), me.Point("Q")
    Q.set_pos(P, length * B.x)
    P.v2pt_theory(O, N, A)
    P.a2pt_theory(O, N, A)
    Q.v2pt_theory(P, N, B)
    Q.a2pt_theory(P, N, B if right else A)
    kane = me.KanesMethod(
        N,
        q[:1],
        u[:1],
        [a.diff() - b for a, b in zip(q[:2], u[:2], strict=True)],
        q_dependent=q[1:2],
        configuration_constraints=[Q.pos_from(O).dot(N.y)],
        u_dependent=u[1:2],
        velocity_constraints=[Q.vel(N).dot(N.y)],
    )
    kane.kanes_equations([me.Particle(str(p), p, m) for p in (P, Q)], [(Q, -m * g * N.x)])
    if right:
        System(kane)
    else:
        with pytest.warns(PyDyUserWarning, match="accelerations that were set for Q are not"):
            System(kane)


def test_accelerations_across_all_partial_velocities_are_not_told():
    """The link's ends move in a plane; constraint forces hold them there."""

    def accelerate(N, frames, points):
        acceleration = points[1].vel(N).dt(N)
        points[1].set_acc(N, acceleration + u[0] * u[1] * N.z)

    double_pendulum(accelerate)


def test_an_angular_acceleration_without_inertia_is_not_told():
    def accelerate(N, frames, points):
        frames[1].set_ang_acc(N, (u[1].diff() + u[0] * u[1]) * N.z)

    double_pendulum(accelerate, moment=0)


def test_a_lagrangian_contains_no_accelerations():
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", q[0] * N.x)
    P.set_acc(N, q[0] * N.y)
    P.set_vel(N, q[0].diff() * N.x)
    bead = me.Particle("P", P, m)
    method = me.LagrangesMethod(me.Lagrangian(N, bead), q[:1], bodies=[bead], frame=N)
    method.form_lagranges_equations()
    System(method)


@pytest.mark.parametrize("right", [True, False])
def test_accelerations_are_compared_with_velocities_that_were_set(right):
    """A disc rolls, so that its centre moves as if it turned about the point of contact."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    Y = N.orientnew("Y", "Axis", (q[0], N.z))
    L = Y.orientnew("L", "Axis", (q[1], Y.x))
    R = L.orientnew("R", "Axis", (q[2], L.y))
    by_angles = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    R.set_ang_acc(N, R.ang_vel_in(N).dt(N))
    O.set_vel(N, 0)
    C = O.locatenew("C", r * L.z)
    C.v2pt_theory(O, N, R)
    if right:
        C.set_acc(N, C.vel(N).dt(N))
    else:
        C.set_acc(N, C.pos_from(O).dt(N).dt(N))
    rates = [(R.ang_vel_in(N) - by_angles).dot(axis) for axis in L]
    kane = me.KanesMethod(N, q, u, rates)
    disc = me.RigidBody(
        "disc", C, R, m, (me.inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4), C)
    )
    kane.kanes_equations([disc], [(C, -m * g * Y.z)])
    if right:
        System(kane)
    else:
        with pytest.warns(PyDyUserWarning, match="accelerations that were set for C are not"):
            System(kane)
