"""What a visual can be attached to."""

import pytest
from sympy.physics.mechanics import Particle, Point, ReferenceFrame

from pydy.viz import Line, Sphere, Visual

B, P = ReferenceFrame("B"), Point("P")


def test_frame_and_point_come_in_any_order():
    assert Visual(Sphere(1), B, P).frame is Visual(Sphere(1), P, B).frame is B


def test_names_come_from_the_argument_the_shape_the_body_or_the_point():
    bob = Particle("bob", P, 1)
    assert Visual(Sphere(1, name="ball"), bob, name="mine").name == "mine"
    assert Visual(Sphere(1, name="ball"), bob).name == "ball"
    assert Visual(Sphere(1), bob).name == "bob"
    assert Visual(Line([P, Point("Q")])).name == "P"
    with pytest.raises(TypeError, match="`name` of Visual must be a string"):
        Visual(Sphere(1), P, name=7)


def test_only_bodies_have_a_default_shape():
    with pytest.raises(TypeError, match="without a shape must be attached to a RigidBody"):
        Visual(None, P)
