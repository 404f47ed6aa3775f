"""Velocities that were set and that positions do not explain are warned of; others are not."""

import warnings

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning

q = me.dynamicsymbols("q1:4")
u = me.dynamicsymbols("u1:4")
m, g, r, length = sm.symbols("m g r length")


def system_of(frame, bodies, loads=(), count=2):
    kane = me.KanesMethod(
        frame,
        q[:count],
        u[:count],
        [a.diff() - b for a, b in zip(q[:count], u[:count], strict=True)],
    )
    kane.kanes_equations(bodies, list(loads))
    return System(kane)


def bead(velocity):
    """A bead on an arm that turns about z; `velocity` is from O, at rest, of the arm's frame A."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    A.set_ang_vel(N, u[0] * N.z)
    P = O.locatenew("P", q[1] * A.x)
    P.set_vel(N, velocity(A))
    arm = me.RigidBody("arm", O, A, m, (me.inertia(A, 0, 0, 1), O))
    return system_of(N, [me.Particle("bead", P, m), arm], [(P, -m * g * N.y)])


def test_a_wrong_sign_is_told():
    with pytest.warns(PyDyUserWarning, match=r"that were set for P are not .* from O,"):
        bead(lambda A: u[1] * A.x - q[1] * u[0] * A.y)
    with pytest.warns(PyDyUserWarning, match=r"that were set for P are not .* from O,"):
        bead(lambda A: u[1] * A.x + u[0] * A.y)
    bead(lambda A: u[1] * A.x + q[1] * u[0] * A.y)


def test_a_speed_whose_coordinate_was_omitted_is_not_told():
    """The arm's bearing travels along z, where it is does not matter."""
    bead(lambda A: u[1] * A.x + q[1] * u[0] * A.y + u[2] * A.z)


def test_a_forgotten_cross_product_is_told():
    """A plate on an arm carries a block and a slider, whose velocities were set by components."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    A.set_ang_vel(N, u[0] * N.z)
    plate = O.locatenew("P1", length * A.x)
    plate.v2pt_theory(O, N, A)
    block = plate.locatenew("P2", q[1] * A.x)
    block.set_vel(N, plate.vel(N) + u[1] * A.x)
    slider = plate.locatenew("P3", q[2] * A.y)
    slider.set_vel(N, plate.vel(N) + u[2] * A.y - q[2] * u[0] * A.x)
    bodies = [me.Particle(str(p), p, m) for p in (plate, block, slider)]
    with pytest.warns(PyDyUserWarning, match=r"that were set for P2 are not .* from P1,"):
        system_of(N, bodies, count=3)


def arm(axis, count=2):
    """Two links whose frames turn about y and z of the frames before, with the `axis` as set."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.y))
    B = A.orientnew("B", "Axis", (q[1], A.z))
    A.set_ang_vel(N, u[0] * N.y)
    B.set_ang_vel(A, u[1] * axis(N, A))
    C = O.locatenew("C", length * B.x)
    C.v2pt_theory(O, N, B)
    link = me.RigidBody("link", C, B, m, (me.inertia(B, 1, 2, 3), C))
    return system_of(N, [link], [(C, -m * g * N.y)])


def test_an_angular_velocity_about_another_axis_than_the_rotation_is_told():
    with pytest.warns(PyDyUserWarning, match=r"^The angular velocities that were set for B are"):
        arm(lambda N, A: N.z)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm(lambda N, A: A.z).evaluate_ode()


def disc(moments):
    """A disc whose frame leans without turning with the disc; its spin is in ω alone."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    K = N.orientnew("K", "Axis", (q[0], N.x))
    L = K.orientnew("L", "Axis", (q[1], K.z))
    w = L.ang_vel_in(N).xreplace({q[0].diff(): u[0], q[1].diff(): u[1]})
    L.set_ang_vel(N, w + (u[0] + u[1]) * L.y)
    disc = me.RigidBody("disc", O, L, m, (me.inertia(L, *moments), O))
    return system_of(N, [disc])


def test_a_body_may_turn_about_its_axis_of_symmetry_without_its_frame():
    disc((1, 2, 1))
    with pytest.warns(PyDyUserWarning, match="for L are not those of their orientations"):
        disc((1, 2, 3))
    with pytest.warns(PyDyUserWarning, match="for L are not those of their orientations"):
        disc((1, 2, 1, 0.5))  # the product of inertia turns with the disc


def wheel(turning):
    """A wheel that stands upright, whose hub is located from the point that touches the ground."""
    N, C = me.ReferenceFrame("N"), me.Point("C")
    C.set_vel(N, 0)
    Y = N.orientnew("Y", "Axis", (q[0], N.z))
    R = Y.orientnew("R", "Axis", (q[1], Y.y))
    Y.set_ang_vel(N, u[0] * N.z)
    R.set_ang_vel(Y, u[1] * Y.y)
    hub = C.locatenew("H", r * Y.z)
    hub.set_vel(N, turning(R, N).cross(r * Y.z))
    rider = hub.locatenew("P", length * Y.x)
    rider.set_vel(N, hub.vel(N) + Y.ang_vel_in(N).cross(length * Y.x))
    bodies = [me.RigidBody("wheel", hub, R, m, (me.inertia(R, 1, 2, 1), hub))]
    return system_of(N, [*bodies, me.Particle("rider", rider, m)])


def test_a_wheel_moves_as_if_it_turned_about_the_point_where_it_touches():
    wheel(lambda R, N: R.ang_vel_in(N)).evaluate_ode()
    with pytest.warns(PyDyUserWarning, match="were set for H are"):
        wheel(lambda R, N: 2 * R.ang_vel_in(N)).evaluate_ode()


def test_the_disc_of_sympys_documentation_that_touches_with_auxiliary_speeds_is_not_told():
    """Its hub is located from the point of contact, whose velocity is that of the forces there."""
    aux, forces = me.dynamicsymbols("u4:7"), me.dynamicsymbols("f1:4")
    N, C = me.ReferenceFrame("N"), me.Point("C")
    Y = N.orientnew("Y", "Axis", (q[0], N.z))
    L = Y.orientnew("L", "Axis", (q[1], Y.x))
    R = L.orientnew("R", "Axis", (q[2], L.y))
    turned = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    axes = (L.x, Y.z.cross(L.x), Y.z)
    C.set_vel(N, sum(a * axis for a, axis in zip(aux, axes, strict=True)))
    hub = C.locatenew("H", r * L.z)
    hub.v2pt_theory(C, N, R)
    inertia = me.inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4)
    rates = [(R.ang_vel_in(N) - turned).dot(axis) for axis in L]
    kane = me.KanesMethod(N, q, u, rates, u_auxiliary=aux)
    contact = sum(f * axis for f, axis in zip(forces, axes, strict=True))
    body = me.RigidBody("disc", hub, R, m, (inertia, hub))
    kane.kanes_equations([body], [(hub, -m * g * Y.z), (C, contact)])
    System(kane)


@pytest.mark.parametrize("place", [sm.asin, lambda x: sm.log(x - 1), lambda x: sm.sqrt(x - 2)])
def test_velocities_that_are_not_finite_everywhere_are_not_told(place):
    """At random states some of these have no value."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    A.set_ang_vel(N, u[0] * N.z)
    P = O.locatenew("P", place(q[1]) * A.x)
    rate = place(q[1]).diff(q[1]) * u[1]
    P.set_vel(N, rate * A.x + place(q[1]) * u[0] * A.y)
    arm = me.RigidBody("arm", O, A, m, (me.inertia(A, 0, 0, 1), O))
    system_of(N, [me.Particle("bead", P, m), arm])


def test_a_velocity_with_the_turn_of_a_frame_below_is_told():
    """The arm B turns relative to A; its end does not move as if it were fixed in A."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    B = A.orientnew("B", "Axis", (q[1], A.x))
    A.set_ang_vel(N, u[0] * N.z)
    B.set_ang_vel(A, u[1] * A.x)
    P = O.locatenew("P", length * B.y)
    P.set_vel(N, A.ang_vel_in(N).cross(P.pos_from(O)))
    bodies = [me.RigidBody(str(f), O, f, m, (me.inertia(f, 1, 2, 3), O)) for f in (A, B)]
    with pytest.warns(PyDyUserWarning, match=r"that were set for P are not .* from O,"):
        system_of(N, [*bodies, me.Particle("end", P, m)])


def four_bar(coupler_velocity=None, coupler_spin=lambda rates: u[1]):
    """A four-bar linkage whose angles are absolute; the second bar is the coupler."""
    lengths = sm.symbols("l1:5")
    t = me.dynamicsymbols._t
    N, A = me.ReferenceFrame("N"), me.Point("A")
    A.set_vel(N, 0)
    frames = [N.orientnew(name, "Axis", (a, N.z)) for name, a in zip("abc", q, strict=True)]
    loop = sum((s * f.x for s, f in zip(lengths, frames, strict=False)), -lengths[3] * N.x)
    constraints = [loop.dot(N.x), loop.dot(N.y)]
    rates = [
        c.diff(t).xreplace({a.diff(): b for a, b in zip(q, u, strict=True)}) for c in constraints
    ]
    for frame, speed in zip(frames, (u[0], coupler_spin(rates), u[2]), strict=True):
        frame.set_ang_vel(N, speed * N.z)
    B = A.locatenew("B", lengths[0] * frames[0].x)
    C = B.locatenew("C", lengths[1] * frames[1].x)
    B.v2pt_theory(A, N, frames[0])
    C.v2pt_theory(B, N, frames[1])
    G = B.locatenew("G", lengths[1] / 2 * frames[1].x)
    if coupler_velocity is None:
        G.v2pt_theory(B, N, frames[1])
    else:
        G.set_vel(N, coupler_velocity(B.vel(N), C.vel(N), lengths[1] / 2, frames[1].y))
    kane = me.KanesMethod(
        N,
        q[:1],
        u[:1],
        [a.diff() - b for a, b in zip(q, u, strict=True)],
        q_dependent=q[1:],
        configuration_constraints=constraints,
        u_dependent=u[1:],
        velocity_constraints=rates,
    )
    coupler = me.RigidBody("coupler", G, frames[1], m, (me.inertia(frames[1], 0, 0, 1), G))
    kane.kanes_equations([coupler, me.Particle("B", B, m), me.Particle("C", C, m)], [])
    return System(kane)


def test_velocities_in_a_closed_loop_are_checked_at_assembled_states():
    with pytest.warns(PyDyUserWarning, match=r"that were set for G are not .* from B,"):
        four_bar(lambda b, c, half, along: b + half * (u[1] - u[0]) * along)
    with pytest.warns(PyDyUserWarning, match=r"that were set for G are not .* from B,"):
        four_bar(lambda b, c, half, along: half * u[1] * along + (b + c) / 3)
    four_bar(lambda b, c, half, along: (b + c) / 2)
    four_bar()


def test_angular_velocities_in_a_closed_loop_are_checked_at_assembled_states():
    with pytest.warns(PyDyUserWarning, match="angular velocity of b would not be what was set"):
        four_bar(coupler_spin=lambda rates: u[0] + u[1])
    # The loop gives the coupler's speed in terms of the crank's.
    four_bar(coupler_spin=lambda rates: sm.solve(rates, u[1:])[u[1]])


@pytest.mark.parametrize("shortened", ["by the constraint", "by its root", "wrongly"])
def test_velocities_may_be_shortened_by_constraints(shortened):
    """A ladder from x on the floor to the wall at x = 0, at the angle q1 to the floor."""
    x, v = q[1], u[1]
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    A.set_ang_vel(N, u[0] * N.z)
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, v * N.x)
    G = P.locatenew("G", -length / 2 * A.x)
    height = {
        "by the constraint": length * sm.sin(q[0]),
        "by its root": sm.sqrt(length**2 - x**2),
        "wrongly": -2 * v / u[0],
    }[shortened]
    G.set_vel(N, -height / 2 * u[0] * N.x - length / 2 * sm.cos(q[0]) * u[0] * N.y)
    kane = me.KanesMethod(
        N,
        q[:1],
        u[:1],
        [a.diff() - b for a, b in zip(q[:2], u[:2], strict=True)],
        q_dependent=[x],
        configuration_constraints=[x - length * sm.cos(q[0])],
        u_dependent=[v],
        velocity_constraints=[v + length * sm.sin(q[0]) * u[0]],
    )
    kane.kanes_equations([me.RigidBody("ladder", G, A, m, (me.inertia(A, 0, 0, 1), G))], [])
    if shortened == "wrongly":
        with pytest.warns(PyDyUserWarning, match=r"that were set for G are not .* from P,"):
            System(kane)
    else:
        System(kane)


@pytest.mark.parametrize("axes", ["of the rod", "of the rotations"])
def test_a_rod_whose_velocities_are_written_along_axes_that_turn_otherwise_is_told(axes):
    """Its turn about itself, -u1 sin(q2), has no inertia, but turns the axes of the velocities."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Body", (q[0], 0, q[1]), "XYZ")
    of_the_rod = axes == "of the rod"
    A.set_ang_vel(N, u[0] * (A.x if of_the_rod else N.x) + u[1] * A.z)
    C = O.locatenew("C", length * A.y)
    C.v2pt_theory(O, N, A)
    rod = me.RigidBody("rod", C, A, m, (me.inertia(A, r, 0, r), C))
    share = sm.cos(q[1]) if of_the_rod else 1
    kane = me.KanesMethod(N, q[:2], u[:2], [share * q[0].diff() - u[0], q[1].diff() - u[1]])
    kane.kanes_equations([rod], [])
    if of_the_rod:
        with pytest.warns(PyDyUserWarning, match="angular velocities that were set for A are not"):
            System(kane)
    else:
        System(kane)
