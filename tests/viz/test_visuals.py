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


@pytest.mark.parametrize("where", [(), (B,), (B, B), (P, P), (B, P, P), (7,), (None, P)])
def test_anything_else_is_refused(where):
    with pytest.raises(TypeError, match="A Visual must be attached to"):
        Visual(Sphere(1), *where)


def test_what_is_no_shape_is_refused():
    with pytest.raises(
        TypeError, match=r"`shape` of Visual must be a shape of pydy\.viz.* float 0\.5"
    ):
        Visual(0.5, P)


def test_only_bodies_have_a_default_shape():
    with pytest.raises(TypeError, match="without a shape must be attached to a RigidBody"):
        Visual(None, P)
