"""What a scene shows when nobody said."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from pydy.viz import Box, Cylinder, Line, Sphere
from pydy.viz.defaults import default_shape

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


def test_without_a_mass_the_proportions_are_right():
    shape = default_shape(body(sm.Symbol("m"), 5, 13, 10), {}, 1.0)
    assert shape.y / shape.x == pytest.approx(1 / 3)
    assert 0.2 < max(shape.x, shape.y, shape.z) < 1.0
    assert isinstance(default_shape(body(1, sm.Symbol("I"), 1, 1), {}, 1.0), Sphere)


def test_springs_are_lines_and_carts_hang_on_nothing():
    assert len(lines_of(multi_mass_spring_damper(2))) == 2
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
    assert scene._look.up.tolist() == [0, 0, 1]
    assert scene._look.ground is False
    assert System(kane).scene(up="y", ground=-1.0)._look.ground == -1.0


def test_joints_of_sympy_are_reached_by_arms():
    base, arm = me.RigidBody("base"), me.RigidBody("arm")
    joint = me.PinJoint("J", base, arm, q, u, child_point=2 * arm.y, joint_axis=base.z)
    multibody = me.System.from_newtonian(base)
    multibody.add_joints(joint)
    multibody.apply_uniform_gravity(-9.81 * base.y)
    ((centre, end),) = lines_of(System(multibody))
    assert centre == arm.masscenter
    assert end == joint.child_point
    system = System(multibody, times=np.linspace(0, 1, 3))
    assert system.animate().poses.shape == (3, 3, 4, 4)
