"""Which constraints are independent, and what follows from them, whatever the units."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.dependents import Chosen, _of_full_rank
from pydy._mechanics.generic import GenericStates
from pydy._mechanics.select_formulation import kinematics_of
from pydy.mechanics import Definition
from pydy.system import System
from zoo import T, inertial_frame
from zoo.singular import defined_windows

UNITS = [1e-9, 1e-4, 1.0, 1e5, 1e9]


def carriage(metre):
    """A carriage that a crank of given motion drives, and a particle that is free."""
    x, y, a, u, v, w = me.dynamicsymbols("x y a u v w")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    rows = [x - metre * sm.sin(a), a - sm.sin(T)]
    body = me.Particle("carriage", place, 1)
    return Definition(frame, [x, y, a], [u, v, w], bodies=[body], holonomic_constraints=rows)


@pytest.mark.parametrize("metre", UNITS)
def test_no_unit_makes_a_constraint_redundant(metre):
    body = carriage(metre).multibody
    assert [str(q) for q in body.dependents.coordinates] == ["x(t)", "a(t)"]
    assert not body.constraints.redundant.holonomic
    assert not body.constraints.redundant.velocity


def yoke(metre):
    """Two cranks of which one drives a slide in two directions, the other in one."""
    x, y, a, b = me.dynamicsymbols("x y a b")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    bodies = [me.Particle("slide", place, 1.0)]
    for angle in (a, b):
        crank = frame.orientnew(f"crank {angle}", "Axis", (angle, frame.z))
        inertia = (me.inertia(crank, 0, 0, metre**2), origin)
        bodies.append(me.RigidBody(str(angle), origin, crank, 1.0, inertia))
    rows = [x - metre * sm.sin(a), x - 2 * metre * sm.sin(b), y - metre * sm.cos(a)]
    loads = [(bodies[1].frame, 5 * metre**2 * frame.z)]
    return (x, y, a, b), Definition(
        frame, [x, y, a, b], bodies=bodies, loads=loads, holonomic_constraints=rows
    )


@pytest.mark.parametrize("metre", [*UNITS, 1e-10, 1e8])
def test_a_yoke_moves_alike_in_all_units(metre):
    # Of sin b = sin a / 2 come db/da and its derivative: a'' (2 + (db/da)²) + … = 5.
    (x, y, a, b), definition = yoke(metre)
    system = System(definition)
    assert len(definition.multibody.constraints.holonomic) == 3
    angle, turn = 0.4, 1.3
    other = np.arcsin(np.sin(angle) / 2)
    slope = np.cos(angle) / (2 * np.cos(other))
    curve = (-np.sin(angle) / 2 + np.sin(other) * slope**2) / np.cos(other)
    at = {x: metre * np.sin(angle), y: metre * np.cos(angle), a: angle, b: other}
    at |= {
        x.diff(T): metre * np.cos(angle) * turn, y.diff(T): -metre * np.sin(angle) * turn,
        a.diff(T): turn, b.diff(T): slope * turn,
    }  # fmt: skip
    system.initial_conditions = at
    rates = dict(zip(system.states, system.evaluate_ode(), strict=True))
    expected = (5 - slope * curve * turn**2) / (2 + slope**2)
    assert rates[a.diff(T)] == pytest.approx(expected, rel=1e-12)
    assert rates[b.diff(T)] == pytest.approx(slope * expected + curve * turn**2, rel=1e-12)


def four_bar(metre, *, symbols):
    """Three rods and the ground, of symbols or numbers, and a row that follows from the others."""
    frame, place = inertial_frame()
    origin, bodies = place, []
    sizes = [metre * size for size in (1.0, 2.5, 1.9, 2.2)]
    named = sm.symbols("l0:4") if symbols else sizes
    for angle, long in zip(me.dynamicsymbols("a b c"), named, strict=False):
        rod = frame.orientnew(f"rod {angle}", "Axis", (angle, frame.z))
        centre = place.locatenew(f"centre {angle}", long / 2 * rod.x)
        inertia = (me.inertia(rod, 0, 0, long**2 / 12), centre)
        bodies.append(me.RigidBody(str(angle), centre, rod, 1.0, inertia))
        place = place.locatenew(f"end {angle}", long * rod.x)
    gap = place.pos_from(origin) - named[3] * frame.x
    rows = [gap.dot(e) for e in (frame.x, frame.y, frame.x + frame.y)]
    loads = [(b.masscenter, -9.81 * metre * frame.y) for b in bodies]
    made = Definition(
        frame, me.dynamicsymbols("a b c"), bodies=bodies, loads=loads, holonomic_constraints=rows
    )
    return made, dict(zip(named, sizes, strict=True)) if symbols else {}


@pytest.mark.parametrize("symbols", [False, True])
def test_a_four_bar_moves_alike_at_any_length(symbols):
    angle = 0.7
    across, up = 2.2 - np.cos(angle), -np.sin(angle)  # from the crank's end to the other pivot
    long, turn = np.hypot(across, up), np.arctan2(up, across)
    coupler = turn + np.arccos((2.5**2 + long**2 - 1.9**2) / (5.0 * long))
    rocker = np.arctan2(up - 2.5 * np.sin(coupler), across - 2.5 * np.cos(coupler))
    found = []
    for metre in (1.0, 1e-60, 1e15):
        made, constants = four_bar(metre, symbols=symbols)
        assert len(made.multibody.constraints.holonomic) == 2
        start = dict(zip("abc", (angle, coupler, rocker), strict=True))
        system = System(made, constants=constants, initial_conditions=start)
        found.append(system.evaluate_ode()[3:])
    assert np.abs(found[0]).max() > 1.0
    for other in found[1:]:
        np.testing.assert_allclose(other, found[0], rtol=1e-12)


def platform(metre, *, given):
    """A plate in a plane on three legs of given lengths, where it stands, and the legs' forces."""
    q, legs = me.dynamicsymbols("x y a"), me.dynamicsymbols("l0:3")
    frame, origin = inertial_frame()
    turned = frame.orientnew("B", "Axis", (q[2], frame.z))
    centre = origin.locatenew("G", q[0] * frame.x + q[1] * frame.y)
    feet = metre * np.array([[-1.2, 0.0], [0.4, 0.0], [1.3, 0.0]])
    tops = metre * np.array([[-0.7, -0.1], [-0.5, -0.1], [0.8, -0.2]])
    height = np.array([0.0, 1.1 * metre])
    rows = []
    for (x, y), (a, b), leg in zip(feet, tops, legs, strict=True):
        gap = centre.pos_from(origin) + a * turned.x + b * turned.y - x * frame.x - y * frame.y
        rows.append(sm.sqrt(gap.dot(gap)) - leg)
    inertia = me.inertia(turned, 0, 0, metre**2)
    start = dict(zip(q, [0.0, height[1], 0.0], strict=True))
    made = Definition(
        frame, q, bodies=[me.RigidBody("plate", centre, turned, 3.0, (inertia, centre))],
        loads=[(centre, -10 * metre * frame.y)], holonomic_constraints=rows,
        configuration=start if given else None,
    )  # fmt: skip
    along = tops + height - feet
    lengths = np.linalg.norm(along, axis=1)
    along /= lengths[:, None]
    turning = (tops[:, 0] * along[:, 1] - tops[:, 1] * along[:, 0]) / metre
    forces = np.linalg.solve([*along.T, turning], [0.0, 10 * metre, 0.0])
    return made, start, dict(zip(legs, lengths, strict=True)), forces


@pytest.mark.parametrize("given", [False, True])
@pytest.mark.parametrize("metre", [1e-9, 1.0, 1.5e11])
def test_a_plate_on_legs_of_given_lengths_stands_in_all_units(metre, given):
    # Were the legs of order one where the search begins, offsets of 1e-9 would vanish beside them.
    made, start, lengths, forces = platform(metre, given=given)
    assert len(made.multibody.constraints.holonomic) == 3
    system = System(made, initial_conditions=start, specifieds=lengths)
    system.outputs = {f"leg {k}": e for k, e in enumerate(system.constraint_forces.values())}
    rates = dict(zip(system.states, system.evaluate_ode(), strict=True))
    for q in start:
        size = 1.0 if str(q) == "a(t)" else metre
        assert rates[q.diff(T)] == pytest.approx(0.0, abs=1e-13 * size)
    assert system.evaluate_outputs()[:3] == pytest.approx(forces, rel=1e-11)


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
    scaled = np.array([rows * m * columns for m in matrices()])
    assert _of_full_rank(scaled, np.zeros_like(scaled)) == ([0], 3)
    assert len(Chosen(scaled[:1]).rows) == 3
    assert len(Chosen(scaled).rows) == 2


def test_what_is_within_its_bound_is_no_pivot():
    # What is left of the constraints at a state moves a coordinate that no row moves.
    left = np.array([[[1.0, 2e-13, 0.0], [1.0, 3e-13, 0.5]]])
    assert Chosen(left[:, :, :2], bounds=np.full((1, 2, 2), 1e-12)).columns == [0]
    assert Chosen(left[:, :, :2], bounds=np.full((1, 2, 2), 1e-15)).columns == [0, 1]
    assert Chosen(left, bounds=np.full((1, 2, 3), 1e-12)).columns == [0, 2]


@pytest.mark.parametrize("metre", UNITS)
@pytest.mark.parametrize("part", [0.01, 1.0, 100.0])
def test_consistent_states_are_found_in_any_units(metre, part):
    """Where a slide must move by metres, an angle alone does not close the loop."""
    x, a, u, w = me.dynamicsymbols("x a u w")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    turned = frame.orientnew("B", "Axis", (a, frame.z))
    bodies = [
        me.Particle("slide", place, 1),
        me.RigidBody("crank", origin, turned, 1, (me.inertia(turned, 1, 1, 1), origin)),
    ]
    rows = [part * metre * (2 + sm.sin(a)) - x * (1 + sm.cos(a) ** 2)]
    made = Definition(frame, [x, a], [u, w], bodies=bodies, holonomic_constraints=rows)
    assert len(made.multibody.constraints.holonomic) == 1


@pytest.mark.parametrize("metre", UNITS)
def test_the_search_begins_near_a_configuration_in_any_units(metre):
    """Of lengths in nanometres angles told how far to go, of angles and quaternions those in km."""
    x, a, *e = me.dynamicsymbols("x a e0:4")
    u, w, *spin = me.dynamicsymbols("u w w0:3")
    frame, origin = inertial_frame()
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
    frame, origin = inertial_frame()
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
    assert len(body.constraints.holonomic) == len(body.constraints.velocity) == 2
    assert not body.constraints.redundant.holonomic


@pytest.mark.parametrize("metre", [1e-8, 1.0, 1e8])
def test_what_sympy_leaves_of_axes_that_are_parallel_is_told_by_its_digits(metre):
    q = me.dynamicsymbols("q0:3")
    frame, origin = inertial_frame()
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
    assert list(body.constraints.holonomic) == rows[2:]
    assert not body.constraints.redundant.holonomic
    assert not body.constraints.redundant.velocity


def test_of_rows_that_contradict_each_other_the_unit_does_not_tell_which_are_named():
    x, y = me.dynamicsymbols("x y")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    rows = [x, x - 1e-3, 1e-9 * (sm.cos(y) - 3.0)]
    made = Definition(
        frame, [x, y], bodies=[me.Particle("p", place, 1)], holonomic_constraints=rows
    )
    with pytest.raises(ValueError, match=r"contradict each other: .*the holonomic constraint 2,"):
        _ = made.multibody


@pytest.mark.parametrize("other", [1e-9, 1.5e11])
@pytest.mark.parametrize("ground", [False, True], ids=["alone", "and a body that is the ground"])
def test_what_else_hangs_on_the_origin_does_not_matter(other, ground):
    """Feet of another body were taken for lengths of the mechanism: no state was found."""
    x, y, a = me.dynamicsymbols("x y a")
    frame, turned, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(frame, 0)
    turned.orient_axis(frame, frame.z, a)
    elsewhere = origin.locatenew("C", x * turned.x)
    elsewhere.locatenew("foot", other * turned.x)
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    bodies = [me.Particle("p", place, 1)]
    if ground:
        inertia = me.inertia(frame, 1, 1, 1), origin
        bodies.append(me.RigidBody("ground", origin, frame, 1, inertia))
    made = Definition(frame, [x, y], bodies=bodies, holonomic_constraints=[x**2 + y**2 - 1])
    assert len(made.multibody.dependents.coordinates) == 1


def test_a_chain_of_loops_is_not_closed_by_links_that_vanish():
    # From angles of order one the search shortens all links; around the circle it finds others.
    body = defined_windows(15).multibody
    assert len(body.constraints.holonomic) == 30 == len(body.dependents.coordinates)
    assert not body.constraints.redundant.velocity


def test_a_constraint_that_holds_for_positive_values_only_is_not_lost():
    """√(x²) = x is nothing on one side; on the other the point stands still."""
    x, y = me.dynamicsymbols("x y")
    m, g = sm.symbols("m g")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    point.set_vel(frame, x.diff() * frame.x + y.diff() * frame.y)
    row = (sm.sqrt(x**2) - x) * y.diff()

    def fallen(start, **options):
        made = Definition(
            frame, [x, y], bodies=[me.Particle("b", point, m)], loads=[(point, -m * g * frame.y)],
            nonholonomic_constraints=[row], **options,
        )  # fmt: skip
        system = System(made, constants={m: 1.0, g: 2.0}, initial_conditions={x: start})
        system.times = [0.0, 1.0]
        return system.simulate()[y][-1]

    assert fallen(1.0) == pytest.approx(-1.0, rel=1e-6)
    with pytest.raises(ValueError, match=r"rank of the velocity constraints is 1, .* it was 0"):
        fallen(-1.0)
    assert fallen(-1.0, configuration={x: -1.0}) == 0.0


@pytest.mark.parametrize("near", [True, False])
@pytest.mark.parametrize("turned", [True, False])
def test_ways_of_assembly_without_a_pivot_in_common_lose_no_constraint(turned, near):
    # Axes that are normal to each other in pairs are those of a body at rest, or each another one.
    e, w = me.dynamicsymbols("e0:4"), me.dynamicsymbols("w1:4")
    frame, body, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(frame, 0)
    body.orient_quaternion(frame, e)
    body.set_ang_vel(frame, sum(u * axis for u, axis in zip(w, body, strict=True)))
    centre = origin.locatenew("C", body.x)
    one, other = (body, frame) if turned else (frame, body)
    normal = [one.x.dot(other.y), one.y.dot(other.z), one.z.dot(other.x)]
    e0, vector, omega = e[0], sm.Matrix(e[1:]), sm.Matrix(w)
    rates = [-vector.dot(omega), *(e0 * omega + vector.cross(omega))]
    system = System(
        Definition(
            frame,
            e,
            w,
            bodies=[me.RigidBody("b", centre, body, 1, (me.inertia(body, 1, 2, 3), centre))],
            loads=[(centre, -frame.z)],
            kinematic_equations=[q.diff() - rate / 2 for q, rate in zip(e, rates, strict=True)],
            holonomic_constraints=[*normal, sum(q**2 for q in e) - 1],
            configuration={e0: 1} if near else None,
        )
    )
    assert len(system.evaluate_holonomic_constraints({e0: 1.0})) == 4
    np.testing.assert_allclose(system.evaluate_ode({e0: 1.0}), 0.0, atol=1e-14)


def test_what_rounding_leaves_of_a_row_is_no_redundant_constraint():
    """Of velocity rows beside a holonomic one, a multiple is redundant; 5.5e-17 u3 is no row."""
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    points = [origin.locatenew(f"P{k}", s * frame.x) for k, s in enumerate(q)]
    bodies = [me.Particle(point.name, point, 1) for point in points]
    row = u[1] - 2 * u[2]
    made = Definition(
        frame,
        q,
        u,
        bodies=bodies,
        holonomic_constraints=[q[0] + q[1] - 1],
        nonholonomic_constraints=[row, 5.5e-17 * u[2], 3 * row],
    )
    constraints = made.multibody.constraints
    assert constraints.velocity[1:] == (row,)
    assert [*constraints.redundant] == [(), (sm.expand(3 * row),)]
