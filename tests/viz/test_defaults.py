"""What a scene shows when nobody said."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from pydy.viz import Bar, Box, Cube, Cylinder, Damper, Line, Sphere, Spring, Visual
from pydy.viz.defaults import default_shape, guess_up
from pydy.viz.shapes import Support
from zoo import pictured

q, u = me.dynamicsymbols("q, u")
N, O = me.ReferenceFrame("N"), me.Point("O")


def body(mass, *moments):
    return me.RigidBody("body", O, N, mass, (me.inertia(N, *moments), O))


def lines_of(system):
    return [v.shape.points for v in system.scene().visuals if isinstance(v.shape, Line)]


def test_an_axisymmetric_inertia_is_a_cylinder_about_its_axis():
    # m r² / 2 and m (3 r² + l²) / 12 for m = 12, r = 2 and l = 3.
    for axis, moments in (("x", (24, 21, 21)), ("y", (21, 24, 21)), ("z", (21, 21, 24))):
        shape = default_shape(body(12, *moments), {}, 1.0)
        assert isinstance(shape, Cylinder)
        assert (shape.length, shape.radius, shape.axis) == (
            pytest.approx(3),
            pytest.approx(2),
            axis,
        )


def test_a_disc_and_a_rod_have_some_thickness():
    disc, rod = (default_shape(body(4, *m), {}, 1.0) for m in ((1, 2, 1), (3, 0, 3)))
    assert (disc.radius, disc.length) == pytest.approx((1.0, 0.06))
    assert (rod.length, rod.radius) == pytest.approx((3.0, 0.045))


def test_equal_moments_are_a_ball_and_others_a_box():
    assert default_shape(body(5, 2, 2, 2), {}, 1.0).radius == pytest.approx(1.0)
    assert isinstance(default_shape(body(12, 5, 13, 10), {}, 1.0), Box)


def test_the_ball_on_a_short_bar_does_not_hide_it():
    link = body(1, 0, 0, 0.1)  # planar: no solid has this inertia
    for arm, radius in ((5.0, 0.022), (0.02, 0.01)):  # the usual one; half of the way to a joint
        arms = [np.array([sign * arm, 0.0, 0.0]) for sign in (1.0, -1.0)]
        assert default_shape(link, {}, 1.0, arms).radius == pytest.approx(radius)


def test_without_a_mass_the_proportions_are_right():
    shape = default_shape(body(sm.Symbol("m"), 5, 13, 10), {}, 1.0)
    assert shape.y / shape.x == pytest.approx(1 / 3)
    assert 0.2 < max(shape.x, shape.y, shape.z) < 1.0
    assert isinstance(default_shape(body(1, sm.Symbol("I"), 1, 1), {}, 1.0), Sphere)


def test_springs_hang_one_on_the_other_and_carts_hang_on_nothing():
    visuals = multi_mass_spring_damper(2).scene().visuals
    for kind in (Spring, Damper):
        pairs = [v.shape.points for v in visuals if type(v.shape) is kind]
        assert [[p.name for p in pair] for pair in pairs] == [["O", "P0"], ["P0", "P1"]]
    names = [[p.name for p in pair] for pair in lines_of(n_link_pendulum_on_cart(2))]
    assert names == [["P0", "P1"], ["P1", "P2"]]


def test_a_free_body_is_not_tied_to_the_origin_and_without_gravity_z_is_up():
    x, y, v, w = me.dynamicsymbols("x, y, v, w")
    point, origin = me.Point("P"), me.Point("O")
    origin.set_vel(N, 0)
    point.set_pos(origin, x * N.x + y * N.y)
    point.set_vel(N, v * N.x + w * N.y)
    kane = me.KanesMethod(N, [x, y], [v, w], [x.diff() - v, y.diff() - w])
    kane.kanes_equations([me.Particle("puck", point, sm.Symbol("m"))], [])
    scene = System(kane).scene()
    assert len(scene.visuals) == 1
    assert scene._settings.up_axis.tolist() == [0, 0, 1]
    assert scene._settings.ground is False
    assert System(kane).scene(up="y", ground=-1.0)._settings.ground == -1.0


@pytest.mark.parametrize("sign", [1, -1])
def test_a_weight_in_the_axes_of_a_turning_body_tells_what_is_up(sign):
    # Its components in N are sums of squares of sines and cosines, which SymPy leaves as they are.
    a, b, ua, ub = me.dynamicsymbols("a, b, u_a, u_b")
    m, g, l = sm.symbols("m, g, l")
    A = N.orientnew("A", "Axis", (a, N.x))
    B = A.orientnew("B", "Axis", (b, A.y))
    hinge = me.Point("H")
    hinge.set_vel(N, 0)
    bob = hinge.locatenew("P", l * B.x)
    weight = (sign * m * g * N.z).express(B) + b * B.y
    bodies = [me.Particle("bob", bob, m)]
    system = System(Definition(N, [a, b], [ua, ub], bodies=bodies, loads=[(bob, weight)]))
    assert system.scene()._settings.up_axis.tolist() == [0, 0, -sign]


def test_joints_of_sympy_are_reached_by_arms():
    base, arm = me.RigidBody("base"), me.RigidBody("arm")
    joint = me.PinJoint("J", base, arm, q, u, child_point=2 * arm.y, joint_axis=base.z)
    multibody = me.System.from_newtonian(base)
    multibody.add_joints(joint)
    multibody.apply_uniform_gravity(-9.81 * base.y)
    (ends,) = lines_of(System(multibody))
    assert {*ends} == {arm.masscenter, joint.child_point}
    system = System(multibody, times=np.linspace(0, 1, 3))
    assert system.animate().poses.shape == (3, 3, 4, 4)


# -- What points and frames show: bars, ropes, springs, wheels, supports ---------------------------


def items_of(scene, kind):
    return [item for item in scene._moving().items if isinstance(item.shape, kind)]


def ends_of(item):
    return [p.name for p in item.shape.points]


def lengths_of(item):
    return np.linalg.norm(item.points[:, 1] - item.points[:, 0], axis=1)


def test_planar_links_are_bars_between_their_joints():
    scene = pictured.animated("Four-bar linkage of planar links")
    bars = items_of(scene, Bar)
    assert [ends_of(bar) for bar in bars] == [["O", "E0"], ["E0", "E1"], ["E1", "E2"]]
    for bar, length in zip(bars, (1.0, 3.0, 2.0), strict=True):
        assert lengths_of(bar) == pytest.approx(length)
        assert bar.shape.radius < 0.05
    # Both bearings stand on the ground; of the inertias, which no body has, no disc is drawn.
    assert [i.visual.point.name for i in items_of(scene, Cube)] == ["O", "D"]
    assert not items_of(scene, Cylinder)
    assert all(i.shape.radius < 0.1 for i in items_of(scene, Sphere))


def test_a_rope_of_varying_length_follows_its_two_points():
    scene = pictured.animated("Crane with a winch")
    (rope,) = items_of(scene, Line)
    assert ends_of(rope) == ["T", "L"]
    trolley, load = (scene.poses[:, k, :3, 3] for k in (0, 1))
    assert rope.points[:, 0] == pytest.approx(trolley)
    assert rope.points[:, 1] == pytest.approx(load)
    assert np.ptp(lengths_of(rope)) > 0.01


def test_a_rod_may_be_written_in_fixed_axes():
    (rod,) = items_of(pictured.animated("Pendulum in fixed axes, by Lagrange"), Bar)
    assert ends_of(rod) == ["O", "P"]
    assert lengths_of(rod) == pytest.approx(1.0)


def test_springs_and_dampers_connect_the_points_of_opposite_forces():
    scene = pictured.animated("Quarter of a car")
    assert [ends_of(i) for i in items_of(scene, Spring)] == [["A", "B"], ["O", "A"]]
    assert [ends_of(i) for i in items_of(scene, Damper)] == [["A", "B"]]
    spring, damper = items_of(scene, Spring)[0], items_of(scene, Damper)[0]
    axle, car = (scene.poses[:, k, 1, 3] for k in (0, 1))
    assert lengths_of(spring) == pytest.approx(car - axle)
    assert damper.tube == pytest.approx(0.6 * (car - axle).min())


def test_a_spring_to_a_road_whose_height_is_an_input_is_one():
    (z, h), (v, tension) = me.dynamicsymbols("z h"), me.dynamicsymbols("v f")
    origin = me.Point("O")
    origin.set_vel(N, 0)
    hub, road = origin.locatenew("H", (z + 1) * N.y), origin.locatenew("R", h * N.y)
    path, wheel = me.LinearPathway(hub, road), me.Particle("wheel", hub, 40)
    actuators = {
        Spring: me.LinearSpring(sm.Symbol("k"), path, equilibrium_length=sm.Symbol("l")),
        Damper: me.LinearDamper(sm.Symbol("c"), path),
        Line: me.ForceActuator(tension, path),
    }
    for kind, actuator in actuators.items():
        system = System(Definition(N, [z], [v], bodies=[wheel], loads=[actuator]))
        lines = [type(i.shape) for i in system.scene().visuals if isinstance(i.shape, Line)]
        assert lines == [Damper if kind is Line else kind]


def test_a_spring_of_a_lagrangian_is_one_and_weight_is_none():
    theta, r = me.dynamicsymbols("theta r")
    origin, own = me.Point("O"), N.orientnew("A", "Axis", [theta, N.z])
    origin.set_vel(N, 0)
    bob = origin.locatenew("P", -r * own.y)
    bob.set_vel(N, bob.pos_from(origin).dt(N))
    for stiffness, kind in ((50, Spring), (0, Line)):
        particle = me.Particle("bob", bob, 1)
        height = -r * sm.cos(theta)
        particle.potential_energy = sm.Rational(981, 100) * height + stiffness * (r - 1) ** 2 / 2
        method = me.LagrangesMethod(
            me.Lagrangian(N, particle), [theta, r], bodies=[particle], frame=N
        )
        method.form_lagranges_equations()
        shapes = [v.shape for v in System(method).scene().visuals if isinstance(v.shape, Line)]
        assert [type(shape) for shape in shapes] == [kind]


def test_gravity_between_two_points_is_no_spring():
    x, y, v, w = me.dynamicsymbols("x y v w")
    origin = me.Point("O")
    origin.set_vel(N, 0)
    sun, earth = origin.locatenew("S", x * N.x), origin.locatenew("E", y * N.y)
    bodies = [me.Particle("sun", sun, 5), me.Particle("earth", earth, 1)]
    way = earth.pos_from(sun)
    for law, count in ((way.magnitude() ** -3, 0), (sm.S.One, 1)):
        loads = [(sun, law * way), (earth, -law * way)]
        system = System(Definition(N, [x, y], [v, w], bodies=bodies, loads=loads))
        assert len([s for s in system.scene().visuals if isinstance(s.shape, Spring)]) == count


@pytest.mark.parametrize(
    "title", ["Rolling disc of SymPy's documentation", "Wheel on a level road"]
)
def test_a_wheel_reaches_to_the_point_where_it_touches(title):
    scene = pictured.animated(title)
    (wheel,) = items_of(scene, Cylinder)
    assert wheel.shape.radius == pytest.approx(pictured.system_of(title).constants["r"])
    assert wheel.shape.axis == {"R": "y", "W": "z"}[wheel.visual.frame.name]
    assert not items_of(scene, Line)


def test_both_wheels_of_a_bicycle_have_their_radii():
    wheels = items_of(pictured.animated("Whipple's bicycle"), Cylinder)
    assert [w.shape.radius for w in wheels] == pytest.approx([0.3, 0.35])
    assert [w.shape.axis for w in wheels] == ["y", "y"]


def test_the_radius_of_a_wheel_follows_the_constants_with_which_it_is_shown():
    title = "Whipple's bicycle"
    system = pictured.system_of(title)
    scene = system.scene(**pictured.OPTIONS[title])
    scene.animate(system.simulate(), constants={"r_F": 0.7, "r_R": 0.2})
    assert [w.shape.radius for w in items_of(scene, Cylinder)] == pytest.approx([0.2, 0.7])


def wheel_radius(down):
    """The radius of a wheel, turned by q, whose contact point is where `down(W, a, b)` says."""
    origin, centre = me.Point("O"), me.Point("G")
    origin.set_vel(N, 0)
    own = N.orientnew("W", "Axis", (q, N.z))
    place, speed = me.dynamicsymbols("z v")
    centre.set_pos(origin, place * N.x)
    lengths = sm.symbols("a b", positive=True)
    contact = centre.locatenew("C", down(own, *lengths))
    wheel = me.RigidBody("wheel", centre, own, 1, (me.inertia(own, 1, 1, 2), centre))
    loads = [(contact, sum(lengths) * N.x)]
    definition = Definition(N, [q, place], [u, speed], bodies=[wheel], loads=loads)
    system = System(definition, dict.fromkeys(lengths, 2.0))
    return next(v.shape.radius for v in system.scene().visuals if isinstance(v.shape, Cylinder))


def test_a_radius_whose_angles_cancel_is_one_of_constants():
    a, b = sm.symbols("a b", positive=True)
    x, y = me.dynamicsymbols("x y")
    turning = wheel_radius(lambda W, a, b: a * (sm.sin(q) * W.x + sm.cos(q) * W.y))
    assert sm.simplify(turning - a) == 0
    # Zero over zero where both functions are zero.
    way = (x * N.x + y * N.y) / sm.sqrt(x**2 + y**2)
    shared = wheel_radius(lambda W, a, b: (a + b) * way)
    assert sm.simplify(shared - a - b) == 0
    # An ellipse of equal axes is a circle with these constants alone.
    ellipse = wheel_radius(lambda W, a, b: a * sm.sin(q) * W.x + b * sm.cos(q) * W.y)
    assert ellipse == pytest.approx(2.0)


# A frame that turns by the first coordinate, and a mass centre that moves in the inertial frame.
@pytest.mark.parametrize(
    ("title", "turning"),
    [
        ("Planar double pendulum", True),
        ("Furuta pendulum", True),
        ("Crane with a winch", False),
        ("Masses and springs", False),
    ],
)
def test_a_picture_seen_from_a_moving_body_has_the_same_parts(title, turning):
    system = pictured.system_of(title)
    usual = system.animate()
    body = system.eom_method.bodies[0]
    frame = body.frame if turning else usual.reference_frame
    moving = system.animate(reference_frame=frame, origin=body.masscenter)

    def parts(scene):
        return [(type(v.shape), v.name, v.point) for v in scene.visuals]

    assert parts(moving) == parts(usual)
    # A pose in the usual scene, as seen from the body's.
    base = usual.poses[:, 0].copy()
    if not turning:
        base[:, :3, :3] = np.eye(3)
    expected = np.linalg.inv(base)[:, None] @ usual.poses
    found = moving.poses
    np.testing.assert_allclose(found[..., :3, 3], expected[..., :3, 3], atol=1e-12)
    turned = [k for k, v in enumerate(moving.visuals) if v.frame is not None]
    np.testing.assert_allclose(found[:, turned], expected[:, turned], atol=1e-12)
    grounds = [k for k, v in enumerate(moving.visuals) if v.name == "ground"]
    assert {*grounds} <= {*turned} or not turning


def test_without_a_point_at_rest_nothing_is_drawn_as_the_ground():
    # Two masses that a spring connects are thrown: their own points are all that is known.
    x, y, v, w = me.dynamicsymbols("x y v w")
    first = me.Point("A")
    first.set_vel(N, v * N.x)
    second = first.locatenew("B", y * N.y)
    bodies = [me.Particle("a", first, 1), me.Particle("b", second, 1)]
    loads = [(first, y * N.y), (second, -y * N.y)]
    system = System(Definition(N, [x, y], [v, w], bodies=bodies, loads=loads))
    shapes = [type(s.shape) for s in system.scene(origin=first).visuals]
    assert shapes.count(Spring) == 1
    assert Support not in shapes


def test_a_flywheel_at_the_end_of_an_arm_does_not_reach_to_the_bearing():
    theta, phi, w, s = me.dynamicsymbols("theta phi w s")
    origin = me.Point("O")
    origin.set_vel(N, 0)
    arm, own = N.orientnew("A", "Axis", [theta, N.z]), N.orientnew("B", "Axis", [phi, N.z])
    centre = origin.locatenew("G", 2 * arm.x)
    wheel = me.RigidBody("wheel", centre, own, 1, (me.inertia(own, 1, 1, 2), centre))
    system = System(Definition(N, [theta, phi], [w, s], bodies=[wheel]), times=[0, 1])
    scene = system.animate()
    assert [ends_of(bar) for bar in items_of(scene, Bar)] == [["O", "G"]]
    (disc,) = items_of(scene, Cylinder)
    assert disc.shape.radius == pytest.approx(2.0)  # m r² / 2 = 2


@pytest.mark.parametrize("unit", [1e-9, 1e9])
def test_the_picture_is_the_same_in_every_unit(unit):
    def drawn(system, size):
        for item in system.animate()._animation.items:
            lengths = [getattr(item.shape, name) for name in item.shape.lengths]
            points = item.points if item.points is not None else item.positions
            yield type(item.shape), np.array(lengths) / size, points[0] / size

    for make in (pictured.planar_double_pendulum, pictured.rolling_wheel):
        small, usual = [*drawn(make(unit), unit)], [*drawn(make(), 1.0)]
        assert [kind for kind, *_ in small] == [kind for kind, *_ in usual]
        for (_, lengths, points), (_, expected, where) in zip(small, usual, strict=True):
            assert lengths == pytest.approx(expected, rel=1e-6)
            assert points == pytest.approx(where, rel=1e-6, abs=1e-6)


def test_shapes_that_are_given_are_the_only_ones():
    system = pictured.system_of("Four-bar linkage of planar links")
    link = system.eom_method.bodies[0]
    scene = system.scene(Visual(Box(1, 0.1, 0.2), link))
    assert [v.shape for v in scene.visuals] == [Box(1, 0.1, 0.2)]


def test_a_body_that_hangs_on_nothing_keeps_the_solid_of_its_inertia():
    (box,) = items_of(pictured.animated("Gyroscope"), Box)
    assert len(pictured.animated("Gyroscope").visuals) == 1
    assert box.shape.x > 0


def test_a_plane_body_without_another_point_is_a_plate_that_hides_nothing():
    shape = default_shape(body(1, 0, 0, 1), {}, 0.1, alone=False)
    assert (shape.radius, shape.axis) == (pytest.approx(0.008), "z")
    # With nothing else to compare with, it is a disc with that moment: m r² / 2.
    assert default_shape(body(1, 0, 0, 2), {}, 1.0).radius == pytest.approx(2.0)


def test_a_solid_is_drawn_on_bars_where_it_is_small_beside_them():
    heavy = body(5, 2, 2, 2)  # a ball of radius 1
    assert default_shape(heavy, {}, 1.0, [np.array([3.0, 0.0, 0.0])]).radius == pytest.approx(1.0)
    assert default_shape(heavy, {}, 1.0, [np.array([1.5, 0.0, 0.0])]).radius < 0.1


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_the_hub_of_arms_that_span_space_is_drawn_smaller(metre):
    """A satellite's bus was three thin bars between the drums of its wheels."""
    bus = body(6, 3 * metre**2, 4 * metre**2, 5 * metre**2)  # edges √6, 2, √2
    arms = [*(2.0 * metre * np.eye(3))]
    hub = default_shape(bus, {}, metre, arms)
    edges = np.array([hub.x, hub.y, hub.z]) / metre
    assert edges == pytest.approx(np.sqrt([6.0, 4.0, 2.0]) / np.sqrt(3.0))
    assert np.linalg.norm(edges) == pytest.approx(2.0)  # the diagonal, of a radius of half an arm
    assert default_shape(bus, {}, metre, arms[:2]).radius < 0.1 * metre


def test_only_loads_that_may_be_weights_are_expressed_in_the_frame_of_the_scene(monkeypatch):
    q = me.dynamicsymbols("q")
    N, P, Q = me.ReferenceFrame("N"), me.Point("P"), me.Point("Q")
    A = N.orientnew("A", "Axis", (q, N.x))
    m, g, k = sm.symbols("m g k")
    expressed = []
    to_matrix = me.Vector.to_matrix

    def counted(vector, frame):
        expressed.append(vector)
        return to_matrix(vector, frame)

    monkeypatch.setattr(me.Vector, "to_matrix", counted)
    weight, tire = -m * g * N.y, k * q * A.x
    assert guess_up(N, [me.Particle("p", P, m)], [(P, weight), (Q, tire)], {}) == "y"
    assert expressed == [weight]
