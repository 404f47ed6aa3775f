"""Which constraints are independent, and what follows from them, whatever the units."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.dependents import Chosen, _of_full_rank
from pydy.mechanics import Definition
from zoo import T

UNITS = [1e-9, 1e-4, 1.0, 1e5, 1e9]


def carriage(metre):
    """A carriage that a crank of given motion drives, and a particle that is free."""
    x, y, a, u, v, w = me.dynamicsymbols("x y a u v w")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    rows = [x - metre * sm.sin(a), a - sm.sin(T)]
    body = me.Particle("carriage", place, 1)
    return Definition(frame, [x, y, a], [u, v, w], bodies=[body], holonomic_constraints=rows)


@pytest.mark.parametrize("metre", UNITS)
def test_no_unit_makes_a_constraint_redundant(metre):
    body = carriage(metre).multibody
    assert [str(q) for q in body.dependent_coordinates] == ["x(t)", "a(t)"]
    assert not body.closed
    assert not body.redundant


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


def matrices():
    """Rows at three states: sound, nearly singular, and singular, where two are parallel."""
    random = np.random.default_rng(0)
    sound = random.uniform(0.5, 1.5, (3, 5))
    found = []
    for part in (1.0, 1e-7, 0.0):
        found.append(sound.copy())
        found[-1][2] = 2 * sound[1] + part * sound[2]
    return found


@pytest.mark.parametrize("row", UNITS)
@pytest.mark.parametrize("column", UNITS)
def test_no_unit_decides_which_states_are_singular(row, column):
    rows, columns = np.array([1.0, row, 1 / row])[:, None], np.array([1.0, 1, column, 1, 1])
    scaled = [rows * m * columns for m in matrices()]
    assert [id(m) for m in _of_full_rank(scaled)] == [id(scaled[0])]
    assert len(Chosen(scaled[:1]).rows) == 3
    assert len(Chosen(scaled).rows) == 2


def test_a_row_that_vanishes_at_a_state_is_no_pivot_there():
    varied = [np.array([[size, 1e-12], [0.0, 1.0]]) for size in (1.0, 1e-9)]
    assert Chosen(varied).rows == [1]
