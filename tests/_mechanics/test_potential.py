"""Potential energies of loads, against closed forms."""

import cProfile

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.definition import equations_of_definition
from pydy._mechanics.distance import primitive
from pydy._mechanics.kane import equations_of_kane
from pydy._mechanics.potential import _PotentialSearch, find_potential
from pydy.contact import kelvin_voigt
from pydy.mechanics import Definition, Implicit
from pydy.system import System
from pydy.vehicles import WheelContact
from zoo import inertial_frame

Q, U = me.dynamicsymbols("x y"), me.dynamicsymbols("u v")
M, K, L, G, C = sm.symbols("m k l g c", positive=True)


@pytest.fixture
def plane():
    """A frame, its origin, and a particle that moves in its plane."""
    frame, origin = inertial_frame()
    place = origin.locatenew("P", Q[0] * frame.x + Q[1] * frame.y)
    place.set_vel(frame, U[0] * frame.x + U[1] * frame.y)
    return frame, origin, place


def potential(plane, loads):
    frame, _, place = plane
    rates = [a.diff() - b for a, b in zip(Q, U, strict=True)]
    body = me.Particle("P", place, M)
    kane = me.KanesMethod(frame, Q, U, kd_eqs=rates, bodies=[body], forcelist=loads)
    return find_potential(equations_of_kane(kane))


def differs_by_a_constant(found, expected):
    return all(sm.simplify((found - expected).diff(q)) == 0 for q in Q)


def test_a_constant_force_has_that_of_its_place(plane):
    frame, _, place = plane
    found = potential(plane, [(place, -M * G * frame.y + C * frame.x)])
    assert differs_by_a_constant(found.expression, M * G * Q[1] - C * Q[0])
    assert not found.unknown


def test_a_force_between_two_points_has_that_of_their_distance(plane):
    _, origin, place = plane
    way = place.pos_from(origin)
    size = way.magnitude()
    pull = -K * (size - L) * way / size
    found = potential(plane, [(place, pull), (origin, -pull)])
    assert differs_by_a_constant(found.expression, K * (size - L) ** 2 / 2)


def test_forces_of_several_laws_that_one_load_adds_up_have_the_sum_of_their_energies(plane):
    frame, origin, place = plane
    hook = origin.locatenew("hook", 3 * frame.x + 4 * frame.y)
    rope, way = place.pos_from(hook), place.pos_from(origin)
    length, distance = rope.magnitude(), way.magnitude()
    load = (
        -M * G * frame.y
        - C * way / distance**3
        - K * sm.Max(0, length - L) * rope / length
        - 5 * U[0] * frame.x  # a damper
    )
    found = potential(plane, [(place, load)])
    assert not found.unknown
    expected = M * G * Q[1] - C / distance + K * sm.Max(0, length - L) ** 2 / 2
    difference = sm.lambdify((*Q, M, G, C, K, L), found.expression - expected)
    values = [difference(*at, 2.0, 9.81, 3.0, 7.0, 2.5) for at in ((1, 1), (3, 3), (2, 5), (8, -2))]
    assert values == pytest.approx([values[0]] * 4, abs=1e-12)


@pytest.mark.parametrize(
    ("force", "energy"),
    [
        (-K * Q[0], K * Q[0] ** 2 / 2),
        (-K * sm.sin(2 * Q[0]), -K * sm.cos(2 * Q[0]) / 2),
        (K * Q[1], -K * Q[0] * Q[1]),
    ],
    ids=["linear", "sine", "coupled"],
)
def test_a_load_with_an_integral_has_that(plane, force, energy):
    frame, _, place = plane
    other = -energy.diff(Q[1])
    found = potential(plane, [(place, force * frame.x + other * frame.y)])
    assert differs_by_a_constant(found.expression, energy)
    assert not found.unknown


ONE_SIDED = {
    "power": K * sm.Max(0, -Q[1]) ** sm.Rational(3, 2),
    "linear": K * sm.Max(0, -Q[1]),
    "deep": K * sm.Max(0, -100 - Q[1]),
    "by a constant": K * sm.Max(0, -L - Q[1]),
    "piecewise": sm.Piecewise((-K * Q[1], Q[1] < 0), (0, True)),
    "step": -K * Q[1] * sm.Heaviside(-Q[1]),
    "size": K * (sm.Abs(Q[1]) - Q[1]),
    "sign": K * (1 - sm.sign(Q[1])),
    "root": K * (sm.sqrt(Q[1] ** 2) - Q[1]),
}


@pytest.mark.parametrize("push", ONE_SIDED.values(), ids=ONE_SIDED)
def test_a_force_on_one_side_alone_has_that_of_its_depth(plane, push):
    frame, _, place = plane
    weight = (place, -M * G * frame.y)
    found = potential(plane, [weight, (place, push * frame.y)])
    assert not found.unknown
    force = sm.lambdify((M, K, L, G, Q[1]), M * G - push)
    energy = sm.lambdify((M, K, L, G, Q[1]), found.expression)
    for y in (-103.0, -3.0, 2.0):
        at, h = (2.0, 3.0, 1.5, 9.0), 1e-4
        rise = (energy(*at, y + h) - energy(*at, y - h)) / (2 * h)
        assert rise == pytest.approx(force(*at, y), rel=1e-5, abs=1e-6)


@pytest.mark.parametrize(
    "size",
    [
        sm.Max(0, -Q[1]) * Q[0],
        sm.Max(0, -100 - Q[1]) * Q[0],
        # Beside the edge of a table its work is another on every path.
        sm.sign(Q[0]),
        Q[0] / sm.sqrt(Q[0] ** 2),
        sm.Heaviside(-Q[0]) * sm.Heaviside(-Q[1]),
        sm.Heaviside(-Q[0]) * sm.Max(0, -Q[1]),
        sm.Piecewise((-Q[1], (Q[0] < 0) & (Q[1] < 0)), (0, True)),
        sm.Piecewise((-Q[1], (Q[0] < 2) & (Q[1] < Q[0])), (0, True)),
    ],
)
def test_a_force_on_one_side_alone_whose_work_depends_on_the_path_is_named(plane, size):
    frame, _, place = plane
    found = potential(plane, [(place, -M * G * frame.y), (place, K * size * frame.y)])
    assert found.unknown


def test_a_floor_below_a_limb_has_the_energy_of_its_depth():
    (q, p), (u, v) = Q, U
    frame, origin = inertial_frame()
    one = frame.orientnew("A", "Axis", (q, frame.z))
    two = frame.orientnew("B", "Axis", (p, frame.z))
    foot = origin.locatenew("K", one.x).locatenew("F", two.x)
    height = sm.sin(q) + sm.sin(p)
    loads = [(foot, -M * G * frame.y), (foot, K * sm.Max(0, -1.7 - height) * frame.y)]
    body = me.Particle("foot", foot, M)
    definition = Definition(frame, [q, p], [u, v], bodies=[body], loads=loads)
    found = find_potential(equations_of_definition(definition))
    assert not found.unknown
    energy = sm.lambdify((M, G, K, q, p), found.expression)
    for a, b in ((1.0, 0.5), (-1.5, -1.3)):
        height = np.sin(a) + np.sin(b)
        apart = energy(2.0, 9.0, 3.0, a, b) - energy(2.0, 9.0, 3.0, 0.0, 0.0)
        assert apart == pytest.approx(18.0 * height + 1.5 * max(0.0, -1.7 - height) ** 2)


@pytest.mark.parametrize(
    ("force", "known"),
    [
        (K / Q[0], True),
        (-K * sm.tanh(Q[0]) ** 3, True),
        (-K * sm.sqrt(sm.Symbol("a") ** 2 - Q[0] ** 2), False),
    ],
)
def test_an_energy_is_real_on_both_sides_or_its_load_is_named(plane, force, known):
    frame, _, place = plane
    found = potential(plane, [(place, force * frame.x + Q[1] * frame.y)])
    assert bool(found.unknown) != known
    assert not found.expression.has(sm.I)
    if known:
        energy = sm.lambdify((K, *Q), found.expression)
        assert np.isfinite([energy(2.0, x, 0.5) for x in (-0.7, 0.7)]).all()


def test_a_force_whose_work_depends_on_the_path_is_named(plane):
    frame, _, place = plane
    found = potential(plane, [(place, K * Q[1] * frame.x)])
    assert found.expression == 0
    assert found.unknown == ["the force on the point P, `k*y(t)*N.x`"]
    assert "the same on every path" in found.advice


def test_no_term_of_a_torque_without_a_potential_is_integrated(monkeypatch):
    # A leaning wheel is deflected along its own plane: its normal force depends on the gap alone,
    # but the lever arm on the camber. SymPy integrated each of the torque's terms, for minutes.
    frame, ground = inertial_frame()
    z, lean, pitch, steer = q = me.dynamicsymbols("z lean pitch steer")
    u = me.dynamicsymbols("w p r s")
    wheel_frame = frame.orientnew("W", "Body", (lean, pitch, steer), "XYZ")
    center = ground.locatenew("C", z * frame.z)
    center.set_vel(frame, u[0] * frame.z)
    wheel_frame.set_ang_vel(
        frame, wheel_frame.ang_vel_in(frame).subs(dict(zip([c.diff() for c in q], u, strict=True)))
    )
    inertia = (me.inertia(wheel_frame, 1, 2, 1), center)
    wheel = me.RigidBody("wheel", center, wheel_frame, M, inertia)
    axis = 0.6 * wheel_frame.y + 0.8 * wheel_frame.z
    contact = WheelContact(
        wheel, axis, 0.3, ground, frame.z, frame, lambda gap, rate: kelvin_voigt(gap, rate, 2e5, 0)
    )
    definition = Definition(frame, [*q], [*u], bodies=[wheel], loads=contact.loads())
    integrated = []
    monkeypatch.setattr("pydy._mechanics.potential.primitive", lambda _, x: integrated.append(x))
    found = find_potential(equations_of_definition(definition))
    assert [x.name for x in integrated] == ["z"]  # the force: constraints may fix the angles
    assert [name.split(",")[0] for name in found.unknown] == [
        "the force on the point C", "the torque on the frame W",
    ]  # fmt: skip
    assert max(map(len, found.unknown)) < 260


def test_damping_and_what_depends_on_time_have_none(plane):
    frame, _, place = plane
    loads = [(place, -C * U[0] * frame.x), (place, sm.sin(me.dynamicsymbols._t) * frame.y)]
    found = potential(plane, loads)
    assert (found.expression, found.unknown) == (0, [])


def test_what_depends_on_speeds_is_not_multiplied_out(plane):
    """Drag at the end of a chain is a product of sums; here are some with 16 million terms."""
    frame, _, place = plane
    product = sm.Mul(*(Q[0] + c for c in sm.symbols("c:24")))
    loads = [(place, -sm.sqrt(U[0]) * product * frame.x - K * (1 + U[1]) * Q[1] * frame.y)]
    found = potential(plane, loads)
    assert differs_by_a_constant(found.expression, K * Q[1] ** 2 / 2)
    assert not found.unknown


def test_energies_are_compared_where_the_constraints_hold():
    """The velocity is what it is on the constraint, which Newton's method misses from most states.

    An orientation by a quaternion of another length than one is as wrong.
    """
    frame, origin = inertial_frame()
    place = origin.locatenew("P", Q[0] * frame.x + Q[1] * frame.y)
    place.set_vel(frame, U[0] * frame.x + U[1] * Q[0] / Q[1] * frame.y)
    definition = Definition(
        frame, Q, U, bodies=[me.Particle("P", place, M)], loads=[(place, -M * G * frame.y)],
        kinematic_equations=[a.diff() - b for a, b in zip(Q, U, strict=True)],
        holonomic_constraints=[sm.atan(10 * (Q[1] - Q[0]))],
    )  # fmt: skip
    found = find_potential(System(definition)._equations)
    assert differs_by_a_constant(found.expression, M * G * Q[1])
    assert not found.unknown


def test_work_is_not_compared_along_a_coordinate_whose_forces_cancel():
    """The energy k x y z with y fixed; the forces along y are zero only when multiplied out.

    ∂F_x/∂y is not ∂F_y/∂x = 0, but no work is done along y.
    """
    frame, origin = inertial_frame()
    (x, y, z), u = q, _ = me.dynamicsymbols("x y z"), me.dynamicsymbols("u v w")
    place = origin.locatenew("P", sum((c * e for c, e in zip(q, frame, strict=True)), 0 * frame.x))
    place.set_vel(frame, sum((c * e for c, e in zip(u, frame, strict=True)), 0 * frame.x))
    zero = (x + z) ** 2 - x**2 - 2 * x * z - z**2
    force = -K * y * (z * frame.x + x * frame.z) + zero * frame.y
    definition = Definition(
        frame, q, u, bodies=[me.Particle("P", place, M)], loads=[(place, force)],
        holonomic_constraints=[y - C],
    )  # fmt: skip
    found = find_potential(equations_of_definition(definition))
    assert not found.unknown
    difference = (found.expression - K * x * y * z).subs(y, C)
    assert [sm.simplify(difference.diff(c)) for c in (x, z)] == [0, 0]


def test_a_spring_between_decimal_places_has_that_of_its_length():
    """Its length's square and its pull are rounded in different ways."""
    q, u = me.dynamicsymbols("q u")
    frame, origin = inertial_frame()
    turned = frame.orientnew("B", "Axis", (q, frame.z))
    turned.set_ang_vel(frame, u * frame.z)
    place = origin.locatenew("P", 1.863 * turned.x - 0.69 * turned.y + 0.1 * turned.z)
    hook = origin.locatenew("H", 0.96 * frame.x + 2.592 * frame.y - 1.1 * frame.z)
    place.v2pt_theory(origin, frame, turned)
    hook.set_vel(frame, 0)
    spring = me.LinearSpring(0.37, me.LinearPathway(place, hook), 1.21)
    kane = me.KanesMethod(
        frame,
        [q],
        [u],
        kd_eqs=[q.diff() - u],
        bodies=[me.Particle("P", place, M)],
        forcelist=spring.to_loads(),
    )
    found = find_potential(equations_of_kane(kane))
    assert not found.unknown
    length = place.pos_from(hook).express(frame).magnitude()
    apart = sm.lambdify(q, found.expression - 0.37 * (length - 1.21) ** 2 / 2)
    assert max(abs(apart(x) - apart(0.0)) for x in (0.4, 1.3, 2.9)) < 1e-14


def test_a_constant_force_on_what_a_quaternion_turns_has_that_of_its_place():
    """No constraint says that the quaternion has the length one."""
    e, w, time = me.dynamicsymbols("e0:4"), me.dynamicsymbols("w1:4"), me.dynamicsymbols._t
    frame, turned, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(frame, 0)
    turned.orient_quaternion(frame, e)
    turned.set_ang_vel(frame, sum((s * a for s, a in zip(w, frame, strict=True)), me.Vector(0)))
    place = origin.locatenew("P", L * turned.x)
    place.v2pt_theory(origin, frame, turned)
    q1, q2, q3 = e[1:]
    rates = sm.Matrix([[-q1, -q2, -q3], [e[0], q3, -q2], [-q3, e[0], q1], [q2, -q1, e[0]]])
    definition = Definition(
        frame,
        e,
        w,
        bodies=[me.RigidBody("B", origin, turned, M, (me.inertia(turned, 1, 2, 3), origin))],
        loads=[(place, -M * G * frame.z)],
        kinematic_equations=list(sm.Matrix(e).diff(time) - rates * sm.Matrix(w) / 2),
    )
    system = System(definition, constants={M: 2.0, G: 3.0, L: 5.0})
    for x in ([1.0, 0, 0, 0, 0, 0, 0], [0.5, 0.5, -0.5, 0.5, 0, 0, 0]):
        height = 2.0 * (x[1] * x[3] - x[0] * x[2]) * 5.0
        assert system.evaluate_energy(x).potential == pytest.approx(6.0 * height, abs=1e-14)


def two_pins(loads, mixed=0):
    """Equations of two rods in a row; the second speed holds the first rate, times `mixed`."""
    frame, origin = inertial_frame()
    first, second = (me.ReferenceFrame(name) for name in "AB")
    first.orient_axis(frame, Q[0], frame.z)
    second.orient_axis(first, Q[1], first.z)
    first.set_ang_vel(frame, U[0] * frame.z)
    second.set_ang_vel(first, (U[1] - mixed * U[0]) * first.z)
    place, bodies = origin, []
    for name, own in (("a", first), ("b", second)):
        place = place.locatenew(name, own.x)
        place.set_vel(frame, place.pos_from(origin).dt(frame))
        bodies.append(me.RigidBody(name, place, own, M, (me.inertia(own, 1, 1, 1), place)))
    rates = [Q[0].diff() - U[0], Q[1].diff() + mixed * Q[0].diff() - U[1]]
    found = Definition(
        frame, Q, U, bodies=bodies, loads=loads(first, second), kinematic_equations=rates
    )
    return System(found)._equations


@pytest.mark.parametrize("mixed", [0, C, sm.cos(Q[0])], ids=["plain", "constant", "by angle"])
@pytest.mark.parametrize("kind", ["stop", "spring"])
def test_a_torque_between_two_frames_has_that_of_their_angle_with_any_speeds(kind, mixed):
    pull = -K * (Q[1] - L)
    if kind == "stop":
        pull = sm.Piecewise((pull, Q[1] > L), (0, True))

    def loads(first, second):
        resisting = (first, -K * sm.Abs(U[0]) * U[0] * first.z)
        return [(second, pull * first.z), (first, -pull * first.z), resisting]

    found = find_potential(two_pins(loads, mixed))
    assert not found.unknown
    values = [found.expression.subs({K: 3.0, L: 0.25, Q[0]: 0.4, Q[1]: q}) for q in (0.75, 0.25)]
    assert abs(values[0] - values[1] - 3.0 * 0.5**2 / 2) < 1e-15


def test_a_torque_that_another_angle_changes_is_named_with_any_speeds():
    def loads(first, second):
        return [(second, K * Q[0] * first.z), (first, -K * Q[0] * first.z)]

    found = find_potential(two_pins(loads, sm.cos(Q[0])))
    assert "the torque on the frame B, `k*x(t)*A.z`" in found.unknown


def test_a_force_is_opposite_to_its_negative_up_to_rounding(plane):
    """Components that are added up and rounded in another order, as SymPy's actuators have them."""
    frame, origin, place = plane
    other = origin.locatenew("R", (Q[1] + 0.1) * frame.x + 0.3 * frame.y)
    other.set_vel(frame, U[1] * frame.x)
    way = other.pos_from(place)
    pull = -K * (way.magnitude() - L) * way / way.magnitude()
    found = potential(plane, [(place, -1.0000000000000002 * pull), (other, pull)])
    assert differs_by_a_constant(found.expression, K * (way.magnitude() - L) ** 2 / 2)
    assert not found.unknown


@pytest.mark.parametrize(
    ("pull", "energy"),
    [
        (lambda r: K * r / (r**2 + L**2) ** sm.Rational(3, 2), lambda r: -K / sm.sqrt(r**2 + L**2)),
        (
            lambda r: K * r * (1 + r**2 / L**2) ** sm.Rational(-5, 2),
            lambda r: -K * L**2 / 3 * (1 + r**2 / L**2) ** sm.Rational(-3, 2),
        ),
        (lambda r: K * sm.exp(-r) * (1 + r) / r**2, lambda r: -K * sm.exp(-r) / r),
        (
            lambda r: 2 * K * C * sm.exp(-C * (r - L)) * (1 - sm.exp(-C * (r - L))),
            lambda r: K * (1 - sm.exp(-C * (r - L))) ** 2,
        ),
        (lambda r: K * r / (9 - r**2), lambda r: -K / 2 * sm.log(9 - r**2)),
        (lambda r: K * sm.Max(r - L, 0), lambda r: K / 2 * sm.Max(r - L, 0) ** 2),
    ],
    ids=["softened", "Plummer", "Yukawa", "Morse", "FENE", "rope"],
)
def test_any_law_of_a_distance_with_an_integral_has_that(pull, energy):
    """Along coordinates SymPy takes minutes for these, and finds none."""
    q = me.dynamicsymbols("q:6")
    frame, origin = inertial_frame()
    ends = [
        origin.locatenew(name, sum(c * axis for c, axis in zip(own, frame, strict=True)))
        for name, own in (("A", q[:3]), ("B", q[3:]))
    ]
    way = ends[0].pos_from(ends[1])
    distance = sm.sqrt(way.dot(way))
    force = pull(distance) * way / distance
    bodies = [me.Particle(str(end), end, M) for end in ends]
    definition = Definition(frame, q, bodies=bodies, loads=[(ends[0], -force), (ends[1], force)])
    found = find_potential(System(definition)._equations)
    assert not found.unknown
    apart = sm.lambdify([*q, K, L, C], found.expression - energy(distance))
    here, there = (0.3, -0.4, 1.1, 0.2, 0.9, -0.6), (0.1, 0.2, 0.9, 0.0, -0.2, 0.3)
    values = [apart(*place, 1.3, 0.7, 1.7) for place in (here, there)]
    assert values[0] == pytest.approx(values[1], abs=1e-14)


def test_a_rotation_may_be_given_as_a_matrix_that_could_change(plane):
    # SymPy keeps what `orient_explicit` is given, a mutable matrix too.
    frame, origin, _ = plane
    tilted, own = me.ReferenceFrame("T"), me.ReferenceFrame("A")
    tilted.orient_explicit(frame, sm.Matrix([[1, 0, 0], [0, 0.6, -0.8], [0, 0.8, 0.6]]))
    own.orient_axis(tilted, tilted.z, Q[0])
    place = origin.locatenew("P", L * own.x)
    loads = [(place, -M * G * frame.z), (own, -K * Q[0] * own.z)]
    body = me.Particle("P", place, M)
    system = System(Definition(frame, [Q[0]], [U[0]], bodies=[body], loads=loads))
    expected = M * G * L * 0.8 * sm.sin(Q[0]) + K * Q[0] ** 2 / 2
    assert differs_by_a_constant(system.potential_energy, expected)


def test_numbers_that_rounding_adds_up_hide_no_potential(plane):
    # 2 √2 less 3 √2 / 2 and √2 / 2 is no zero in floats.
    frame, origin, _ = plane
    along = (frame.y - frame.z).normalize()
    place = origin.locatenew("P", Q[0] * along)
    place.set_vel(frame, Q[0].diff() * along)
    body = me.Particle("P", place, M)
    load = (place, -8 * frame.x - 3 * frame.y + frame.z)
    system = System(me.LagrangesMethod(M * Q[0].diff() ** 2 / 2, [Q[0]], [load], [body], frame))
    assert differs_by_a_constant(system.potential_energy, 2 * sm.sqrt(2) * Q[0])


def test_weights_ask_for_no_second_point(plane, monkeypatch):
    """Each pair of points was tried, for 40 four-bars in a row a minute of them."""
    monkeypatch.setattr(_PotentialSearch, "_recognise_central_force", None)
    frame, _, place = plane
    found = potential(plane, [(place, -M * G * frame.y)])
    assert differs_by_a_constant(found.expression, M * G * Q[1])


def test_a_spring_between_bodies_with_quaternions_has_that_of_its_length():
    """Lengths are none where a quaternion's is not one: the spring was not seen to be one."""
    frame, origin = inertial_frame()
    q, u, rates, bodies, ends, rows = [], [], [], [], [], []
    for k in range(2):
        own, e = me.ReferenceFrame(f"B{k}"), me.dynamicsymbols(f"e{k}_0:4")
        x, v, w = (me.dynamicsymbols(f"{name}{k}_0:3") for name in "xvw")
        own.orient_quaternion(frame, e)
        own.set_ang_vel(frame, w[0] * own.x + w[1] * own.y + w[2] * own.z)
        centre = origin.locatenew(f"C{k}", x[0] * frame.x + x[1] * frame.y + x[2] * frame.z)
        centre.set_vel(frame, v[0] * frame.x + v[1] * frame.y + v[2] * frame.z)
        end = centre.locatenew(f"E{k}", 0.7 * own.x - 1.3 * own.y + 0.4 * own.z)
        end.v2pt_theory(centre, frame, own)
        inertia = me.inertia(own, 1, 2, 3), centre
        bodies.append(me.RigidBody(f"body{k}", centre, own, M, inertia))
        ends.append(end)
        q, u = [*q, *x, *e], [*u, *v, *w]
        rates += [a.diff() - b for a, b in zip(x, v, strict=True)]
        rates += [
            e[0].diff() + (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]) / 2,
            e[1].diff() - (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]) / 2,
            e[2].diff() - (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]) / 2,
            e[3].diff() - (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]) / 2,
        ]
        rows.append(sum(i**2 for i in e) - 1)
    spring = me.LinearSpring(3.0, me.LinearPathway(*ends), 1.1)
    definition = Definition(
        frame, q, u, bodies=bodies, loads=spring.to_loads(),
        kinematic_equations=rates, holonomic_constraints=rows,
    )  # fmt: skip
    found = find_potential(System(definition)._equations)
    assert not found.unknown
    assert differs_by_a_constant(found.expression, 1.5 * (spring.pathway.length - 1.1) ** 2)


@pytest.mark.parametrize("power", [1, 3])
def test_a_spring_around_pegs_has_that_of_its_whole_length(power):
    """Along two segments that change and two that do not, by a law of all of them."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    fixed, base, bodies, ends = me.ReferenceFrame("N"), me.Point("O"), [], []
    base.set_vel(fixed, 0)
    frame = fixed
    for k, name in enumerate("zzx"):
        link, axis = me.ReferenceFrame(f"L{k}"), getattr(frame, name)
        link.orient_axis(frame, axis, q[k])
        link.set_ang_vel(frame, u[k] * axis)
        for n, (x, y) in enumerate([(1, 2), (3, 1)]):
            peg = base.locatenew(f"E{k}{n}", (x * link.x + y * link.y) / 5)
            peg.v2pt_theory(base, fixed, link)
            ends.append(peg)
        tip = base.locatenew(f"P{k}", link.x)
        tip.v2pt_theory(base, fixed, link)
        bodies.append(me.RigidBody(f"b{k}", tip, link, M, (me.inertia(link, 1, 2, 3), tip)))
        base, frame = tip, link
    path = me.ObstacleSetPathway(*ends)
    spring = me.ForceActuator(-K * (path.length - L) ** power, path)
    system = System(Definition(fixed, q, u, bodies=bodies, loads=[spring]), {M: 1.0, K: 3, L: 0.5})
    states = [[0.3, 0.4, 0.2, 0, 0, 0], [-0.5, 0.7, 1.1, 0, 0, 0]]
    found = [system.evaluate_energy(x).potential for x in states]
    lengths = [float(path.length.subs(dict(zip(q, x, strict=False)))) for x in states]
    a, b = (3 * (length - 0.5) ** (power + 1) / (power + 1) for length in lengths)
    assert found[0] - found[1] == pytest.approx(a - b, rel=1e-12)


def test_rates_are_looked_at_once_for_all_loads(monkeypatch):
    """Torques that align two bodies have very many terms; each took new derivatives of all q'."""
    q, u = me.dynamicsymbols("q1:7"), me.dynamicsymbols("u1:7")
    fixed, origin = inertial_frame()
    frames, rates, bodies = [], [], []
    for k in (0, 3):
        frame = me.ReferenceFrame(f"B{k}")
        frame.orient_body_fixed(fixed, q[k : k + 3], "XYZ")
        follows = frame.ang_vel_in(fixed)
        frame.set_ang_vel(
            fixed, sum((a * b for a, b in zip(u[k:], frame, strict=False)), 0 * frame.x)
        )
        rates += [follows.dot(a) - b for a, b in zip(frame, u[k:], strict=False)]
        inertia = me.inertia(frame, 1, 2, 3), origin
        bodies.append(me.RigidBody(f"b{k}", origin, frame, 1, inertia))
        frames.append(frame)
    torque = K * frames[0].x.cross(frames[1].x)
    loads = [(frames[0], torque), (frames[1], -torque)]
    definition = Definition(fixed, q, u, bodies=bodies, loads=loads, kinematic_equations=rates)
    made = []

    def spied(*args):
        made.append(args)
        return sm.Matrix(*args)

    monkeypatch.setattr("pydy._mechanics.potential.sm", _With(sm, Matrix=spied))
    assert find_potential(equations_of_definition(definition)).unknown
    assert len(made) == 3


class _With:
    """A module with some names of one's own."""

    def __init__(self, module, **own):
        self.__dict__.update(vars(module) | own)


@pytest.mark.parametrize(
    ("force", "known"),
    [
        (-K * (Q[0] - 1) / sm.Abs(Q[0] - 1), False),  # SymPy's integral jumps, and is NaN there
        (-K * Q[0] / sm.Abs(Q[0]), True),
        (-K * sm.sign(Q[0]) / Q[0] ** 2, True),  # infinite there, on both sides
        (-K * Q[0] / sm.Abs(Q[0] - 1), True),
        (-K * sm.Abs(sm.sin(Q[0])), False),  # SymPy's integral holds for one turn
        (-K * sm.Piecewise((sm.sin(Q[0]), sm.sin(Q[0]) > 0), (0, True)), False),
        (-K * sm.Max(0, Q[0] - 9), True),
    ],
)
def test_an_energy_may_be_infinite_at_a_switch_but_not_jump_there(plane, force, known):
    frame, _, place = plane
    assert bool(potential(plane, [(place, force * frame.x)]).unknown) != known


def test_an_anchor_that_was_given_no_velocity_stands_still_where_it_is_placed():
    """Its spring's work was handed to SymPy, which integrated it for minutes."""
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q1:7"), me.dynamicsymbols("u1:7")
    turned = frame.orientnew("A", "Body", q[3:], "ZXZ")
    centre = origin.locatenew("P", q[0] * frame.x + q[1] * frame.y + q[2] * frame.z)
    body = me.RigidBody("b", centre, turned, 1, (me.inertia(turned, 1, 2, 3), centre))
    end = centre.locatenew("Q", 0.3 * turned.x + 0.1 * turned.y)
    wall = frame.orientnew("W", "Axis", (0.5, frame.z))
    anchor = origin.locatenew("G", 0.5 * wall.x).locatenew("H", 1.5 * frame.x)
    line = end.pos_from(anchor)
    length = sm.sqrt(line.dot(line))
    force = -3 * (length - sm.Rational(7, 10)) / length * line
    definition = Definition(frame, q, u, bodies=[body], loads=[(end, force)])
    found = find_potential(equations_of_definition(definition))
    assert not found.unknown
    at = dict(zip(q, (1.0, 0.2, 0.3, 0.4, 0.5, 0.6), strict=True))
    long = float(length.subs(at))
    energy = 3 * (long**2 / 2 - 0.7 * long)
    assert float(found.expression.subs(at)) == pytest.approx(energy, rel=1e-12)


def test_what_residuals_give_from_speeds_has_no_potential():
    # The law of drag D + c D³ = v: D is no constant force.
    x, v, drag = me.dynamicsymbols("x v D")
    k, c = sm.symbols("k c")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    body, pull = me.Particle("p", place, 1), (place, (-k * x - drag) * frame.x)
    definition = Definition(frame, [x], [v], bodies=[body], loads=[pull])
    system = System(definition, {k: 4.0}, implicit=Implicit({drag: drag + c * drag**3 - v}))
    system.initial_conditions = {x: 1.0, v: 3.0}
    assert system.evaluate_energy().potential == pytest.approx(2.0)


def test_loads_that_do_no_work_need_no_potential():
    (x, y), (u, v) = me.dynamicsymbols("x y"), me.dynamicsymbols("u v")
    frame, origin = inertial_frame()
    one = origin.locatenew("one", x * frame.x)
    two = one.locatenew("two", y * frame.x)
    bodies = [me.Particle("m", one, M), me.Particle("n", two, M)]
    across, against = K * x * y * frame.y, K * y * frame.x
    loads = [(one, across), (two, against), (two, -against)]
    definition = Definition(frame, [x, y], [u, v], bodies=bodies, loads=loads)
    found = find_potential(equations_of_definition(definition))
    assert (found.expression, found.unknown) == (0, [])


def potential_of_chain(n):
    """Return the potential of springs in a row, in relative coordinates, and all calls it took."""
    k, x, v = sm.symbols(f"k:{n}"), me.dynamicsymbols(f"x:{n}"), me.dynamicsymbols(f"v:{n}")
    frame, point = inertial_frame()
    bodies, loads = [], []
    for i in range(n):
        point = point.locatenew(f"P{i}", x[i] * frame.x)
        pull = sum((k[j] * x[j] for j in range(i + 1, min(i + 2, n))), -k[i] * x[i])
        bodies.append(me.Particle(f"m{i}", point, M))
        loads.append((point, pull * frame.x))
    equations = equations_of_definition(Definition(frame, x, v, bodies=bodies, loads=loads))
    profile = cProfile.Profile()
    found = profile.runcall(find_potential, equations)
    expected = sm.Add(*(a * b**2 / 2 for a, b in zip(k, x, strict=True)))
    return found, expected, sum(entry.callcount for entry in profile.getstats())


def test_sines_that_cancel_do_not_make_a_spring_infinite():
    x, root = sm.Symbol("x", real=True), sm.sqrt(2)
    sine, cosine = 3 * sm.sin(x) / 2, 3 * sm.cos(x) / 2
    # The sum is 2 √5. SymPy alone divides by its derivative, which is zero.
    products = (root - 1) * (sine - sm.sqrt(5)) + (root + 1) * (cosine + sm.sqrt(5))
    number = products - 3 * root * (sm.sin(x) + sm.cos(x)) / 2 + sine - cosine
    assert primitive(x * number, x) == sm.sqrt(5) * x**2


def test_springs_of_a_long_chain_in_relative_coordinates_take_no_cubic_time():
    potential_of_chain(2)  # what is done once
    calls = []
    for n in (5, 10, 20):
        found, expected, many = potential_of_chain(n)
        assert found.expression == expected
        assert not found.unknown
        calls.append(many)
    few, twice, four_times = calls
    assert twice < 3 * few  # each doubling of n² would be 4, of n³ 8
    assert four_times < 3 * twice


@pytest.mark.parametrize("of_weight", [0, 1])
@pytest.mark.parametrize("shift", [0, 3])
def test_a_given_potential_is_used_if_the_power_of_the_loads_agrees(plane, of_weight, shift):
    frame, _, place = plane
    spring, weight = K * (Q[0] - 2 * Q[1]) ** 2 / 2, M * G * Q[1]
    loads = [
        (place, sum((-spring.diff(q) * e for q, e in zip(Q, frame, strict=False)), 0 * frame.x))
    ]
    definition = Definition(
        frame,
        Q,
        U,
        bodies=[me.Particle("P", place, M)],
        loads=[*loads, (place, -M * G * frame.y)],
        potential_energy=spring + of_weight * weight + shift * Q[0],
    )
    found = find_potential(equations_of_definition(definition))
    assert not found.unknown
    assert sm.expand(found.expression - spring - weight) == 0  # not expanded, as it was given
    assert found.expression.has((Q[0] - 2 * Q[1]) ** 2) == (not shift)


def test_a_given_potential_must_be_an_expression(plane):
    frame, _, place = plane
    with pytest.raises(ValueError, match="`potential_energy`, an expression or a number, must be"):
        Definition(frame, Q, U, bodies=[me.Particle("P", place, M)], potential_energy="k")
