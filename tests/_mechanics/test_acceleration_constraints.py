"""Constraints in any units: accelerations of a quick-return mechanism with a gear."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._graph.node import Graph
from pydy._mechanics.acceleration_constraints import AccelerationConstraints, solved_soundly
from pydy._mechanics.definition import equations_of_definition
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame
from zoo.singular import defined_windows

T = me.dynamicsymbols._t
A, D, M, J, G = sm.symbols("a d m J g")
Q = me.dynamicsymbols("th ph r ps")
U = me.dynamicsymbols("u w v z")


def quick_return(source):
    """A crank whose pin slides in a slotted arm, at the distance r, and turns a gear.

    Constraints are lengths and angles, and one coordinate among their coefficients is a length.
    """
    (th, ph, r, ps), (u, w, v, z) = Q, U
    ground, o = inertial_frame()
    crank, arm, gear = (
        ground.orientnew(name, "Axis", (angle, ground.z))
        for name, angle in (("C", th), ("A", ph), ("D", ps))
    )
    for frame, rate in ((crank, u), (arm, w), (gear, z)):
        frame.set_ang_vel(ground, rate * ground.z)
    pin = o.locatenew("P", A * crank.x)
    pin.v2pt_theory(o, ground, crank)
    pivot = o.locatenew("Q", -D * ground.y)
    pivot.set_vel(ground, 0)
    block = pivot.locatenew("S", r * arm.x)
    block.set_vel(ground, v * arm.x + r * w * arm.y)
    places = [pin.pos_from(block).dot(e) for e in (ground.x, ground.y)] + [ps - 2 * th]
    rates = [(pin.vel(ground) - block.vel(ground)).dot(e) for e in (arm.x, arm.y)] + [z - 2 * u]
    bodies = [
        me.RigidBody(frame.name, place, frame, M, (me.inertia(frame, 0, 0, J), place))
        for frame, place in ((crank, o), (gear, o), (arm, pivot))
    ]
    bodies.append(me.Particle("block", block, M))
    loads = [(pin, -M * G * ground.y), (crank, J * sm.sin(th) * ground.z)]
    kinematic = [q.diff(T) - s for q, s in zip(Q, U, strict=True)]
    if source == "definition":
        return Definition(
            ground, Q, U, bodies=bodies, loads=loads,
            kinematic_equations=kinematic, holonomic_constraints=places,
        )  # fmt: skip
    kane = me.KanesMethod(
        ground, Q[:1], U[:1], kd_eqs=kinematic,
        q_dependent=Q[1:], u_dependent=U[1:],
        configuration_constraints=places, velocity_constraints=rates,
        constraint_solver="CRAMER",
    )  # fmt: skip
    kane.kanes_equations(bodies, loads)
    return kane


def accelerations(system, angle, metre=1.0, kilogram=1.0):
    """The accelerations where the crank is at an angle and turns at 1.3 rad/s."""
    system.constants = {
        A: metre, D: 2 * metre, M: kilogram, J: 0.375 * kilogram * metre**2, G: 9.81 * metre
    }  # fmt: skip
    place = np.array([np.cos(angle), 2.0 + np.sin(angle)])
    velocity = 1.3 * np.array([-np.sin(angle), np.cos(angle)])
    r = np.hypot(*place)
    along = place / r
    across = np.array([-along[1], along[0]])
    values = [angle, np.arctan2(*place[::-1]), r * metre, 2 * angle]
    values += [1.3, velocity @ across / r, velocity @ along * metre, 2.6]
    state = dict(zip((*Q, *U), values, strict=True))
    rates = system.evaluate_ode(np.array([state[s] for s in system.states]))
    found = dict(zip(system.states, rates, strict=True))
    return np.array([found[u] for u in U]) / [1.0, 1.0, metre, 1.0]


@pytest.mark.parametrize("source", ["kane", "definition"])
def test_small_and_large_machines_have_the_same_accelerations_to_the_last_bit(source):
    system = System(quick_return(source))
    own = System(quick_return("kane"), equations="method")
    for angle in (0.4, 1.9, -2.6):
        expected = accelerations(system, angle)
        np.testing.assert_allclose(expected, accelerations(own, angle), rtol=1e-13)
        for power in (-24, -10, -7, 10):
            found = accelerations(system, angle, 2.0**power, 2.0 ** (2 * power))
            assert found.tolist() == expected.tolist()


def test_rows_have_a_size_where_a_quaternion_is_of_another_length():
    """A mass by a speed, written for a quaternion of length one, is negative at others.

    Rows are measured at such states, too: derivatives met the root of a negative number.
    """
    g = Graph()
    e = [g.input("x", k) for k in range(4)]
    mass = g.sum([(g.powi(n, 2), -0.641) for n in e], 1.641)
    row = [g.one, g.zero]
    constraints = AccelerationConstraints([row], [g.zero], 1, [row], [g.zero], [])
    found = constraints.accelerations(g, [[mass, g.zero], [g.zero, g.one]], [g.one, e[1]])
    roots = [n for n in g.reachable(found) if g.ops[n] == "sqrt"]
    assert roots
    values = g.evaluator(roots)(dict(zip(e, (0.5, -0.5, 0.7, 0.1), strict=True)), 1)
    assert np.isfinite(values).all()


def test_a_chain_of_loops_costs_no_more_than_its_length():
    few, many = (formed_nodes(defined_windows(n)) for n in (7, 14))
    assert many < 2.2 * few  # five times with columns of M⁻¹ Jᵀ that count as full


def formed_nodes(definition):
    formed = equations_of_definition(definition).formed
    return len(formed.graph.reachable(formed.dynamics.accelerations))


def test_dense_and_sparse_matrices_are_solved_alike():
    rng, n = np.random.default_rng(3), 16
    band = np.diag(rng.uniform(4, 5, n)) + np.diag(off := rng.uniform(-1, 1, n - 1), 1)
    band += np.diag(off, -1)
    band[0, -1] = band[-1, 0] = 0.5
    graph, right = Graph(), rng.uniform(-1, 1, n)
    cells = [[graph.const(c) for c in row] for row in band.tolist()]
    found, sound = solved_soundly(graph, cells, [graph.const(c) for c in right], [graph.one] * n)
    values = graph.evaluator([*found, sound])({}, 1)[0]
    assert values[:-1] == pytest.approx(np.linalg.solve(band, right), rel=1e-13)
    assert values[-1] == 1.0
