"""Bodies joined with their frames, and what a joint hands on to the body before."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from graphs import form
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._mechanics.formulations import moving
from pydy._mechanics.inertia import composite_contributions
from pydy._mechanics.kane import multibody_of_kane
from pydy._program.interpret import run
from zoo import inertial_frame


def arm(places, axes="zx", inertias=None):
    """Bodies on hinges, the axes named, in turn; places of the joints in the frames before."""
    frame, origin = inertial_frame()
    n = len(places)
    q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")
    above, joint, bodies, loads = frame, origin, [], []
    for k, place in enumerate(places):
        own, axis = me.ReferenceFrame(f"B{k}"), getattr(above, axes[k % len(axes)])
        own.orient_axis(above, axis, q[k])
        own.set_ang_vel(above, u[k] * axis)
        joint = joint.locatenew(f"J{k}", vector(place, above))
        centre = joint.locatenew(f"C{k}", vector(sm.symbols(f"c{k}x c{k}y c{k}z"), own))
        size = sm.symbols(f"I{k}xx I{k}yy I{k}zz I{k}xy I{k}yz I{k}zx")
        mass = sm.Symbol(f"m{k}")
        bodies.append(me.RigidBody(f"b{k}", centre, own, mass, (me.inertia(own, *size), centre)))
        loads.append((centre, -mass * sm.Symbol("g") * frame.z))
        above = own
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=rates, bodies=bodies, forcelist=loads)
    return multibody_of_kane(kane)


def vector(parts, frame):
    return sum((sm.sympify(c) * e for c, e in zip(parts, frame, strict=True)), me.Vector(0))


def accelerations(body, seed, **way):
    """u' in one form, and the operations at every call."""
    formed = form(body, **way)
    rng = np.random.default_rng(seed)
    values = {s: rng.uniform(0.5, 1.5) for s in sorted(formed.constants, key=str)}
    p = np.array([values[s] for s in formed.constants])
    graph, dynamics = formed.graph, formed.dynamics
    n, solved = 2 * len(dynamics.forcing), dynamics.accelerations
    if solved is None:
        solved = LinearSystem(graph, dynamics.matrix, "ldl").solve(dynamics.forcing)
    program = lower(graph, (n, 0, len(p)), [("accelerations", (n // 2,), solved)])
    found, failed = run(program, np.zeros(1), rng.normal(size=(1, n)), np.zeros((1, 0)), p)
    assert not failed.any()
    return found[0], sum(program.operation_count["run"].values())


PLACES = [(0, 0, 0), (1, 2, 3), sm.symbols("l d b"), (0, 0.5, 0), (0, 0, 2)]


@pytest.mark.parametrize("articulated", [True, False])
@pytest.mark.parametrize("axes", ["z", "zx", "xyz", "zzy"])
def test_accelerations_are_those_of_bodies_taken_one_by_one(axes, articulated):
    body = arm(PLACES, axes)
    for seed in (1, 2):
        expected, _ = accelerations(body, seed, in_bodies=False, articulated=False)
        found, _ = accelerations(body, seed, in_bodies=True, articulated=articulated)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * abs(expected).max())


def test_what_is_left_of_a_hinged_body_has_no_mass_and_nothing_along_its_axis():
    kinematics = moving(arm([(0, 0, 0), (1, 2, 3)]), in_bodies=True, gravity_as_acceleration=True)
    inertias, _, plain = composite_contributions(kinematics)
    zero = kinematics.graph.zero
    for part, whole, axis in zip(inertias, plain, (2, 0), strict=True):
        matrix = part.matrix
        assert [matrix[i][i] for i in range(3)] == [zero] * 3
        others = [i for i in range(3) if i != axis]
        # The first moment along the axis couples the two other directions.
        assert matrix[others[0]][3 + others[1]] == zero
        assert whole.matrix[others[0]][3 + others[1]] != zero


def test_where_on_its_axis_a_joint_is_costs_nothing():
    way = {"in_bodies": True, "articulated": True}
    length, away = sm.symbols("l d")
    _, least = accelerations(arm([(0, 0, 0), (length, 0, 0), (0, length, 0)], "zyx"), 1, **way)
    _, moved = accelerations(arm([(0, 0, 0), (length, away, 0), (3, length, 0)], "zyx"), 1, **way)
    assert moved <= 1.01 * least


def test_a_pivot_that_vanishes_is_seen_though_the_body_before_holds_the_mass():
    # A bob at the centre of its own hinge moves nothing: M is singular.
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q:2"), me.dynamicsymbols("u:2")
    one, two = frame.orientnew("A", "axis", (q[0], frame.z)), me.ReferenceFrame("B")
    two.orient_axis(one, one.x, q[1])
    one.set_ang_vel(frame, u[0] * frame.z)
    two.set_ang_vel(one, u[1] * one.x)
    tip = origin.locatenew("P", one.y)
    m, r = sm.symbols("m r")
    bob = tip.locatenew("C", r * two.y)
    bodies = [
        me.RigidBody("arm", tip, one, m, (me.inertia(one, 1, 1, 1), tip)),
        me.RigidBody("bob", bob, two, m, (me.inertia(two, 0, 0, 0), bob)),
    ]
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=rates, bodies=bodies)
    formed = form(multibody_of_kane(kane), in_bodies=True, articulated=True)
    program = lower(formed.graph, (4, 0, 2), [("u'", (2,), formed.dynamics.accelerations)])
    for length, singular in ((0.3, False), (0.0, True)):
        values = {m: 1.0, r: length}
        p = np.array([values[s] for s in formed.constants])
        _, failed = run(program, np.zeros(1), np.full((1, 4), 0.4), np.zeros((1, 0)), p)
        assert bool(failed.any()) is singular
