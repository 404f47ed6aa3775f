"""Kinematic equations beside the velocities that were set."""

import warnings

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame

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


def silent(place, speed):
    """Make a System of a particle with one coordinate; nothing may be told."""
    x, u = me.dynamicsymbols("x u")
    fixed, origin = inertial_frame()
    point = origin.locatenew("P", place(x) * fixed.x)
    point.set_vel(fixed, speed(x, u) * fixed.x)
    bodies = [me.Particle("p", point, 1)]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return System(Definition(fixed, [x], [u], bodies=bodies))


def test_places_that_are_no_numbers_at_random_states_are_left_alone():
    """The pin of a slider-crank has a root that is none for most lengths."""
    r, length = sm.symbols("r l")

    def place(q):
        return r * sm.cos(q) + sm.sqrt(length**2 - r**2 * sm.sin(q) ** 2)

    system = silent(place, lambda q, u: place(q).diff(q) * u)
    system.constants = {length: 3.0}
    assert system.evaluate_ode([0.3, 1.0])[1] == pytest.approx(-3.1654163684)
    silent(lambda x: sm.exp(2000 * x), lambda x, u: 2000 * sm.exp(2000 * x) * u)


def test_velocities_that_depend_on_more_than_places_are_left_alone():
    way, rate = me.dynamicsymbols("f vf")
    silent(lambda x: x + way, lambda x, u: u + rate)
    silent(lambda x: x, lambda x, u: u + sm.Symbol("belt"))


def test_typed_digits_are_no_disagreement():
    silent(lambda x: x / 3, lambda x, u: 0.333333 * u)


def test_orientations_by_cosines_are_left_alone():
    """A random matrix may be a reflection, for which angular velocities have another sign."""
    c, w = me.dynamicsymbols("c1:10"), me.dynamicsymbols("w1:4")
    fixed, frame, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(fixed, 0)
    cosines = sm.Matrix(3, 3, c)
    frame.orient_explicit(fixed, cosines)
    frame.set_ang_vel(fixed, w[0] * frame.x + w[1] * frame.y + w[2] * frame.z)
    cross = sm.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
    rates = [a.diff(T) - b for a, b in zip(c, cosines * cross, strict=True)]
    rigid = me.RigidBody("body", origin, frame, 1, (me.inertia(frame, 1, 2, 3), origin))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, c, w, bodies=[rigid], kinematic_equations=rates))


def test_a_velocity_on_one_branch_of_a_constraint_is_left_alone():
    x, y, u, v = me.dynamicsymbols("x y u v")
    length = sm.Symbol("l")
    fixed, origin = inertial_frame()
    bob = origin.locatenew("P", x * fixed.x + y * fixed.y)
    bob.set_vel(fixed, u * fixed.x + x * u / sm.sqrt(length**2 - x**2) * fixed.y)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(
            Definition(
                fixed, [x, y], [u, v], bodies=[me.Particle("bob", bob, 1)],
                holonomic_constraints=[x**2 + y**2 - length**2],
                configuration={x: 0.5, y: -1.9, length: 2.0},
            )
        )  # fmt: skip


def arm(speed, second=None, method=Definition, **more):
    """Two hinges in a row; the outer link's velocities are set in `second`."""
    q, u = me.dynamicsymbols("q1:3"), [speed(k) for k in range(2)]
    fixed, origin = inertial_frame()
    bodies, base, frame = [], origin, fixed
    for k, rate in enumerate([u[0], u[1] if second is None else second]):
        link = me.ReferenceFrame(f"L{k}")
        link.orient_axis(frame, frame.z, q[k])
        link.set_ang_vel(frame, u[k] * frame.z)
        centre, tip = base.locatenew(f"C{k}", link.x), base.locatenew(f"P{k}", 2 * link.x)
        centre.v2pt_theory(base, fixed, link)
        tip.v2pt_theory(base, fixed, link)
        link.set_ang_vel(frame, rate * frame.z)
        inertia = me.inertia(link, 0, 0, 1), centre
        bodies.append(me.RigidBody(f"link {k}", centre, link, 1, inertia))
        base, frame = tip, link
    if method is me.LagrangesMethod:
        return method(me.Lagrangian(fixed, *bodies), q, bodies=bodies, frame=fixed, **more)
    if method is me.KanesMethod:
        more["kd_eqs"] = [a.diff(T) - b for a, b in zip(q, u, strict=True)]
    return method(fixed, q, u, bodies=bodies, **more)


def rate(k):
    return me.dynamicsymbols(f"q{k + 1}", 1)


def own(k):
    return me.dynamicsymbols(f"u{k + 1}")


@pytest.mark.parametrize(
    ("method", "speed"),
    [(me.LagrangesMethod, rate), (Definition, rate), (Definition, own), (me.KanesMethod, own)],
)
def test_inertia_is_not_lost_to_a_function_that_is_no_speed(method, speed):
    """The outer link turned as `w` said, whatever its angle did: nothing of it resisted q2."""
    System(arm(speed, method=method))
    with pytest.raises(ValueError, match=r"with `q2\(t\)`, but .* with `w\(t\)`\. That is no"):
        System(arm(speed, me.dynamicsymbols("w"), method))


def test_a_prescribed_motion_is_no_speed_either():
    """By its kinematic equation or by a constraint, as the model says."""
    w = me.dynamicsymbols("w")
    System(arm(rate, w, nonholonomic_constraints=[rate(1) - w]))
    q, u = me.dynamicsymbols("q1:3"), own(0)
    found = arm(own, w)
    rates = [q[0].diff(T) - u, q[1].diff(T) - w]
    System(Definition(found.frame, q, [u], bodies=found.bodies, kinematic_equations=rates))


def test_a_moving_base_takes_no_speed_from_what_hangs_on_it():
    v = me.dynamicsymbols("v")
    q = me.dynamicsymbols("q")
    fixed, rod, base = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    base.set_vel(fixed, v * fixed.x)
    rod.orient_axis(fixed, fixed.z, q)
    bob = base.locatenew("P", rod.x)
    bob.v2pt_theory(base, fixed, rod)
    bodies = [me.Particle("base", base, 1), me.Particle("bob", bob, 1)]
    System(Definition(fixed, [q], bodies=bodies))


def carried(first, second):
    """Two masses in space, the second placed from the first; their velocities as given."""
    q, u = me.dynamicsymbols("x1 x2 y2"), me.dynamicsymbols("u1:4")
    fixed, origin = inertial_frame()
    one = origin.locatenew("P1", q[0] * fixed.x)
    two = one.locatenew("P2", q[1] * fixed.x + q[2] * fixed.y)
    one.set_vel(fixed, first(u) * fixed.x)
    two.set_vel(fixed, sum((a * b for a, b in zip(second(u), fixed, strict=False)), me.Vector(0)))
    bodies = [me.Particle(str(p), p, 1) for p in (one, two)]
    return fixed, q, u, bodies


def test_a_chain_of_places_is_followed_to_the_point_at_rest():
    """Speeds that are absolute are no rates of relative places."""
    fixed, q, u, bodies = carried(lambda u: u[0], lambda u: (u[1], u[2]))
    with pytest.warns(PyDyUserWarning, match=r"derivatives of x2\(t\) .* the velocity of P2"):
        System(Definition(fixed, q, u, bodies=bodies))
    right = [q[0].diff(T) - u[0], q[1].diff(T) - u[1] + u[0], q[2].diff(T) - u[2]]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, q, u, bodies=bodies, kinematic_equations=right))
        fixed, q, u, bodies = carried(lambda u: u[0], lambda u: (u[0] + u[1], u[2]))
        System(Definition(fixed, q, u, bodies=bodies))


def test_a_small_component_is_compared_by_itself():
    small = sm.Float(1e-7)
    fixed, q, u, bodies = carried(lambda u: u[0], lambda u: (u[0] + u[1], small * u[2]))
    bodies[1].masscenter.set_pos(bodies[0].masscenter, q[1] * fixed.x + 2 * small * q[2] * fixed.y)
    with pytest.warns(PyDyUserWarning, match=r"derivatives of y2\(t\) .* the velocity of P2"):
        System(Definition(fixed, q, u, bodies=bodies))


@pytest.mark.parametrize("beside", ["rotor", "belt"])
def test_what_cannot_be_told_hides_nothing_that_it_shares_no_coordinate_with(beside):
    fixed, q, u, bodies, _, _ = body("XYZ")
    x, v = me.dynamicsymbols("x v")
    origin, frame = me.Point("A"), me.ReferenceFrame("R")
    origin.set_vel(fixed, 0)
    centre = origin.locatenew("D", x * fixed.x)
    centre.set_vel(fixed, (v if beside == "rotor" else v + sm.Symbol("belt")) * fixed.x)
    frame.orient_axis(fixed, fixed.z, 0)
    frame.set_ang_vel(fixed, v * fixed.z)
    bodies.append(me.RigidBody("rotor", centre, frame, 1, (me.inertia(fixed, 1, 1, 1), centre)))
    with pytest.warns(PyDyUserWarning, match="the angular velocity of B"):
        System(Definition(fixed, [*q, x], [*u, v], bodies=bodies))


def test_the_equations_of_a_method_have_the_same_kinematics():
    fixed, q, u, bodies, _, wrong = body("XYZ")
    method = me.KanesMethod(fixed, q, u, kd_eqs=wrong, bodies=bodies, forcelist=[])
    method.kanes_equations()
    with pytest.warns(PyDyUserWarning, match=TOLD):
        System(method, equations="method")


def test_what_moves_along_a_rolling_cart_is_left_alone():
    """The wheel touches the ground in a point at rest, which no place of the hub follows from."""
    s, u, w = me.dynamicsymbols("s u w")
    fixed, contact = me.ReferenceFrame("N"), me.Point("Q")
    contact.set_vel(fixed, 0)
    hub = contact.locatenew("C", fixed.y)
    hub.set_vel(fixed, w * fixed.x)
    load = hub.locatenew("P", s * fixed.x)
    load.set_vel(fixed, (w + u) * fixed.x)
    bodies = [me.Particle(str(p), p, 1) for p in (hub, load)]
    right = [s.diff(T) - u]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        System(Definition(fixed, [s], [u, w], bodies=bodies, kinematic_equations=right))


def test_a_sign_beside_a_constraint_is_told():
    """A yo-yo falls by y, and its string unwinds by r theta."""
    y, theta, v, omega = me.dynamicsymbols("y theta v omega")
    m, r, g = sm.symbols("m r g")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (theta, N.z))
    A.set_ang_vel(N, omega * N.z)
    G = O.locatenew("G", -y * N.y)
    disc = me.RigidBody("disc", G, A, m, (me.inertia(A, 0, 0, m * r**2), G))
    for velocity, told in ((-v, False), (v, True)):
        G.set_vel(N, velocity * N.y)
        rates = [y.diff() - v, theta.diff() - omega]
        kane = me.KanesMethod(
            N, [y, theta], [v], rates, u_dependent=[omega], velocity_constraints=[v - r * omega]
        )
        kane.kanes_equations([disc], [(G, -m * g * N.y)])
        if told:
            with pytest.warns(PyDyUserWarning, match="the velocity of G would not be what was set"):
                System(kane)
        else:
            System(kane)
