"""Floors and walls of contacts in scenes."""

import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.contact import Contacts, Unilateral
from pydy.mechanics import Definition
from pydy.system import System
from pydy.viz import Box, Plane, Sphere, Visual

R = 0.1
x, y, a, vx, vy, w = me.dynamicsymbols("x y a v_x v_y w")
slope = sm.Symbol("slope")


def thrown(is_box=False):
    """Return a System of a body in a plane, its frames and its mass centre."""
    N, O, B = me.ReferenceFrame("N"), me.Point("O"), me.ReferenceFrame("B")
    O.set_vel(N, 0)
    B.orient_axis(N, N.z, a)
    B.set_ang_vel(N, w * N.z)
    C = O.locatenew("C", x * N.x + y * N.y)
    C.set_vel(N, vx * N.x + vy * N.y)
    body = me.RigidBody("body", C, B, 1, (me.inertia(B, 0, 0, 0.4 * R**2), C))
    g = sm.Symbol("g")
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, -g * N.y)]),
        {g: 9.81},
        ode_solver="dop853",
        initial_conditions={y: 0.5, vx: 1.0},
        times=np.linspace(0.0, 0.6, 31),
    )
    shape = Box(2 * R, 2 * R, 2 * R) if is_box else Sphere(R)
    return system, Visual(shape, body)


def planes_of(scene):
    """Return the points and unit normals of the planes that a scene draws."""
    items = [i for i in scene._animation.items if isinstance(i.shape, Plane)]
    return {i.visual.name: (i.positions[0], i.rotations[0][:, 2]) for i in items}


def test_a_horizontal_floor_is_the_ground():
    system, ball = thrown()
    contacts = Contacts(system, [Unilateral(y - R - 0.2, name="floor")])
    scene = system.animate(ball, contacts=contacts)
    assert scene._animation.ground == pytest.approx(0.2, abs=1e-12)
    assert not planes_of(scene)
    chosen = system.animate(ball, contacts=contacts, ground=-1.0)
    assert chosen._animation.ground is None


def test_a_floor_is_below_all_shapes_at_a_point():
    system, ball = thrown()
    contacts = Contacts(system, [Unilateral(y - R - 0.2, name="floor")])
    for core in (0.5 * R, 1.5 * R):
        scene = system.animate(
            ball, Visual(Sphere(core), ball.frame, ball.point), contacts=contacts
        )
        lowest = 0.2 + R - max(R, core)
        assert scene._animation.ground == pytest.approx(lowest, abs=1e-12)


def test_a_wall_is_beside_all_places_of_the_ball():
    system, ball = thrown()
    system.initial_conditions = {x: 3.0, y: 0.5, vx: 1.0}
    wall = Unilateral(5.0 - x - R, name="wall")
    motion = Contacts(system, [wall]).simulate()
    scene = system.scene(ball).animate(motion)
    (item,) = [i for i in scene._animation.items if isinstance(i.shape, Plane)]
    places = np.stack([motion["x"], motion["y"], np.zeros(len(motion.times))], axis=1)
    along, across, _ = np.abs((places - item.positions[0]) @ item.rotations[0]).T
    margin = item.shape.length - np.ptp(motion["y"])
    assert 0.0 < margin < 2.0
    assert along.max() == pytest.approx(np.ptp(motion["y"]) / 2)  # y is the steepest direction
    assert across.max() == pytest.approx(0.0, abs=1e-12)
    assert item.shape.width == pytest.approx(margin)


def test_a_slope_and_a_wall_are_planes_that_the_ball_touches():
    system, ball = thrown()
    gaps = [
        Unilateral(x * sm.sin(slope) + y * sm.cos(slope) - R, name="hill"),
        Unilateral(0.5 - x - R, restitution=0.5, name="wall"),
    ]
    contacts = Contacts(system, gaps, {slope: 0.3})
    motion = contacts.simulate()
    scene = system.scene(ball).animate(motion)
    planes = planes_of(scene)
    point, normal = planes["hill"]
    np.testing.assert_allclose(normal, [np.sin(0.3), np.cos(0.3), 0.0], atol=1e-12)
    assert point @ normal == pytest.approx(0.0, abs=1e-12)  # it contains the origin
    point, normal = planes["wall"]
    np.testing.assert_allclose(normal, [-1.0, 0.0, 0.0], atol=1e-12)
    assert point[0] == pytest.approx(0.5, abs=1e-12)
    assert scene._animation.ground is None
    system.constants[slope] = 0.2
    scene.animate(contacts.simulate(), compare={"steeper": pickle.loads(pickle.dumps(motion))})
    point, normal = planes_of(scene)["hill"]  # that of the run itself
    np.testing.assert_allclose(normal, [np.sin(0.2), np.cos(0.2), 0.0], atol=1e-12)


def test_a_floor_under_a_corner_goes_through_the_corner():
    system, box = thrown(is_box=True)
    corner = y - R * sm.cos(a) - R * sm.sin(a)
    system.initial_conditions = {y: 0.5, a: 0.3}
    scene = system.animate(box, contacts=Contacts(system, [Unilateral(corner, name="floor")]))
    assert scene._animation.ground == pytest.approx(0.0, abs=1e-12)


def test_gaps_that_are_no_distances_from_planes_draw_nothing():
    system, ball = thrown()
    t = me.dynamicsymbols._t
    gaps = [
        Unilateral(sm.sqrt(x**2 + (y + 3) ** 2) - R, name="globe"),
        Unilateral(y - R + 0.1 * sm.sin(t), name="shaker"),
        Unilateral(a + 10, name="stop"),
    ]
    scene = system.animate(ball, contacts=Contacts(system, gaps))
    assert not planes_of(scene)
    assert scene._animation.ground is None
