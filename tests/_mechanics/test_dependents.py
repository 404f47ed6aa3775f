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


def cranks(metre, gear):
    """Two cranks that a rod joins, whose square is all that the row holds, and a gear beside."""
    q = me.dynamicsymbols("q0:3")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    first, second, wheel = (frame.orientnew(f"A{k}", "Axis", (q[k], frame.z)) for k in range(3))
    end = origin.locatenew("P", 1.1 * metre * first.y)
    other = origin.locatenew("Q", 2.7 * metre * frame.x + 1.6 * metre * second.y)
    inertia = (me.inertia(wheel, 0, 0, metre**2), origin)
    bodies = [me.Particle("p", end, 2.0), me.Particle("q", other, 2.0)]
    bodies += [me.RigidBody("wheel", origin, wheel, 1.0, inertia)]
    gap = other.pos_from(end)
    rows = [gap.dot(gap) - (3.0 * metre) ** 2, gear(q)]
    return Definition(frame, q, bodies=bodies, holonomic_constraints=rows)


@pytest.mark.parametrize("metre", [1e-10, 1e-8, 1.0, 1e7, 1e9])
@pytest.mark.parametrize(
    "gear",
    [
        lambda q: q[0] - 2 * q[2],
        lambda q: 1.3 * q[0] - 1.7 * q[2],
        lambda q: sm.sin(q[0]) - 1.5 * sm.sin(q[2]),
    ],
)
def test_a_row_of_numbers_and_one_of_squares_are_not_compared(metre, gear):
    body = cranks(metre, gear).multibody
    assert len(body.holonomic) == len(body.velocity) == 2
    assert not body.closed


@pytest.mark.parametrize("metre", [1e-8, 1.0, 1e8])
def test_what_sympy_leaves_of_axes_that_are_parallel_is_told_by_its_digits(metre):
    q = me.dynamicsymbols("q0:3")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    axis = -0.02 * frame.x + 0.85 * frame.y + 0.25 * frame.z
    link = frame.orientnew("A", "Axis", (q[0], axis))
    along = -0.02 * link.x + 0.85 * link.y + 0.25 * link.z
    after = link.orientnew("B", "Axis", (q[1], along))
    ways = [0.25 * link.y - 0.85 * link.z, -0.785 * link.x - 0.017 * link.y - 0.005 * link.z]
    hinge = -0.02 * after.x + 0.85 * after.y + 0.25 * after.z
    rows = [hinge.dot(way) for way in ways]
    assert all(row != 0 for row in rows)
    place = origin.locatenew("P", metre * (0.4 * link.x + 1.1 * link.y + q[2] * link.z))
    bodies = [me.Particle("p", place, 1.0)]
    rows += [metre * (sm.sin(q[0]) - 0.5 * sm.sin(q[1])), metre * q[2] - metre * sm.cos(q[0])]
    body = Definition(frame, q, bodies=bodies, holonomic_constraints=rows).multibody
    assert list(body.holonomic) == rows[2:]
    assert not body.closed
    assert not body.redundant


def test_of_rows_that_contradict_each_other_the_unit_does_not_tell_which_are_named():
    x, y = me.dynamicsymbols("x y")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    rows = [x, x - 1e-3, 1e-9 * (sm.cos(y) - 3.0)]
    made = Definition(
        frame, [x, y], bodies=[me.Particle("p", place, 1)], holonomic_constraints=rows
    )
    with pytest.raises(ValueError, match=r"contradict each other: .*the holonomic constraint 2,"):
        _ = made.multibody
