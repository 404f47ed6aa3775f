"""Gravity as an acceleration of the inertial frame."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.formulations import moving
from pydy._mechanics.kane import multibody_of_kane
from zoo import inertial_frame

m, other, g = sm.symbols("m other g")


def two_particles(weights, place=None):
    """Two particles that slide along x and y, with forces along z; at one point if `place` is 0."""
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q:2"), me.dynamicsymbols("u:2")
    first = origin.locatenew("A", q[0] * frame.x)
    second = first if place == 0 else first.locatenew("B", q[1] * frame.y)
    bodies = [me.Particle("a", first, m), me.Particle("b", second, other)]
    loads = [(point, w * frame.z) for point, w in zip((first, second), weights, strict=True) if w]
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=rates, bodies=bodies, forcelist=loads)
    return moving(multibody_of_kane(kane), in_bodies=True, gravity_as_acceleration=True)


def test_weights_of_all_bodies_become_an_acceleration():
    kinematics = two_particles([-m * g, -other * g])
    assert kinematics.loads == ()
    read = kinematics.read
    assert kinematics.pull == [kinematics.graph.zero] * 2 + [read(-g)]
    body = kinematics.body.bodies[0]
    assert kinematics.acceleration(body.masscenter)[2] == read(g)


@pytest.mark.parametrize("weights", [(-m * g, None), (-m * g, -other * g / 6), (None, None)])
def test_forces_that_do_not_pull_all_masses_alike_stay_loads(weights):
    kinematics = two_particles(weights)
    assert kinematics.pull is None
    assert len(kinematics.loads) == sum(w is not None for w in weights)


def test_a_force_at_a_point_with_two_bodies_is_the_weight_of_one():
    kinematics = two_particles([-m * g, None], place=0)
    assert kinematics.pull is None


def test_weights_that_are_numbers_may_be_rounded():
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q:3"), me.dynamicsymbols("u:3")
    bodies, loads, point = [], [], origin
    for k, mass in enumerate((0.1, 0.7, 1.3)):
        point = point.locatenew(f"P{k}", q[k] * frame.z)
        bodies.append(me.Particle(f"p{k}", point, mass))
        loads.append((point, -mass * 9.81 * frame.z))
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=rates, bodies=bodies, forcelist=loads)
    assert moving(multibody_of_kane(kane), in_bodies=True, gravity_as_acceleration=True).loads == ()
