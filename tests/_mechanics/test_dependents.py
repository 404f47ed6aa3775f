"""The search for consistent states, whatever the units."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

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
