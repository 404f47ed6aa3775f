"""The search for consistent states, whatever the units."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.formed import kinematics_of
from pydy._mechanics.generic import GenericStates
from pydy.mechanics import Definition

UNITS = [1e-9, 1e-4, 1.0, 1e5, 1e9]


@pytest.mark.parametrize("metre", UNITS)
@pytest.mark.parametrize("part", [0.01, 1.0, 100.0])
def test_consistent_states_are_found_in_any_units(metre, part):
    """Where a slide must move by metres, an angle alone does not close the loop."""
    x, a, u, w = me.dynamicsymbols("x a u w")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x)
    turned = frame.orientnew("B", "Axis", (a, frame.z))
    bodies = [
        me.Particle("slide", place, 1),
        me.RigidBody("crank", origin, turned, 1, (me.inertia(turned, 1, 1, 1), origin)),
    ]
    rows = [part * metre * (2 + sm.sin(a)) - x * (1 + sm.cos(a) ** 2)]
    made = Definition(frame, [x, a], [u, w], bodies=bodies, holonomic_constraints=rows)
    assert len(made.multibody.holonomic) == 1


@pytest.mark.parametrize("metre", UNITS)
def test_the_search_begins_near_a_configuration_in_any_units(metre):
    """Of lengths in nanometres angles told how far to go, of angles and quaternions those in km."""
    x, a, *e = me.dynamicsymbols("x a e0:4")
    u, w, *spin = me.dynamicsymbols("u w w0:3")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x)
    rod, ball = frame.orientnew("R", "Axis", (a, frame.z)), me.ReferenceFrame("B")
    ball.orient_quaternion(frame, e)
    ball.set_ang_vel(frame, sum(v * axis for v, axis in zip(spin, ball, strict=True)))
    size = metre**2
    inertia = me.inertia(ball, size, size, size)
    bodies = [
        me.RigidBody("ball", place, ball, 1, (inertia, place)),
        me.Particle("tip", place.locatenew("T", metre * rod.x), 1),
    ]
    turning = sm.Matrix([[-e[1], -e[2], -e[3]], [e[0], -e[3], e[2]], [e[3], e[0], -e[1]],
                         [-e[2], e[1], e[0]]])  # fmt: skip
    rates = turning * sm.Matrix(spin) / 2
    kinematic = [x.diff() - u, a.diff() - w, *(q.diff() - r for q, r in zip(e, rates, strict=True))]
    coordinates, row = [x, a, *e], x - metre * sm.sin(a)
    given = dict(zip(coordinates, (0.2 * metre, 0.2, 1.0, 0.0, 0.0, 0.0), strict=True))
    made = Definition(
        frame, coordinates, [u, w, *spin], bodies=bodies, kinematic_equations=kinematic,
        holonomic_constraints=[row], configuration=given,
    )  # fmt: skip
    states = GenericStates(kinematics_of(made.multibody), (), "the constraints")
    named = states.by_symbol(states.consistent(5, near=given))
    for symbol, value in given.items():
        size = metre if symbol == x else 1.0
        assert named[symbol] == pytest.approx(value, abs=0.2 * size)
    assert sum(named[q] ** 2 for q in e) == pytest.approx(1.0, abs=1e-12)
