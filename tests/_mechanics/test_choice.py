"""The form that is chosen, and what it costs: counts are gated, as for the frozen models."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import models

import mechanisms
from pydy._graph.lower import lower
from pydy._graph.simplify import simplify
from pydy._graph.solve.choose import solve_accelerations
from pydy._graph.switches import Passes
from pydy._mechanics.choice import chosen
from pydy._mechanics.kane import multibody_of_kane
from pydy.examples import whipple_bicycle
from pydy.models import n_link_pendulum_on_cart
from pydy.system import System
from zoo import T


def pendulum(n):
    return n_link_pendulum_on_cart(n, cart_force=True, joint_torques=False).eom_method


def springs(n):
    return models.multi_mass_spring_damper(n)


def rods(n):
    """A chain of rods in space: a universal joint, then ball joints."""
    frame = above = me.ReferenceFrame("N")
    joint = me.Point("O")
    joint.set_vel(frame, 0)
    q, u, rates, bodies, loads = [], [], [], [], []
    for k in range(n):
        m, length, *inertias = sm.symbols(f"m{k} l{k} A{k} B{k} C{k}")
        own = me.ReferenceFrame(f"B{k}")
        if k:
            a, b, c = me.dynamicsymbols(f"a{k} b{k} c{k}")
            x, y, z = me.dynamicsymbols(f"u{k} v{k} w{k}")
            own.orient_body_fixed(above, (a, b, c), "123")
            own.set_ang_vel(above, x * own.x + y * own.y + z * own.z)
            across = (x * sm.cos(c) - y * sm.sin(c)) / sm.cos(b)
            rates += [across, x * sm.sin(c) + y * sm.cos(c), z - sm.sin(b) * across]
            q += [a, b, c]
            u += [x, y, z]
        else:
            a, b = me.dynamicsymbols("a0 b0")
            x, y = me.dynamicsymbols("u0 v0")
            fork = me.ReferenceFrame("F")
            fork.orient_axis(above, above.x, a)
            fork.set_ang_vel(above, x * above.x)
            own.orient_axis(fork, fork.y, b)
            own.set_ang_vel(fork, y * fork.y)
            rates += [x, y]
            q += [a, b]
            u += [x, y]
        centre = joint.locatenew(f"C{k}", -length / 2 * own.z)
        joint = joint.locatenew(f"O{k}", -length * own.z)
        bodies.append(me.RigidBody(f"rod{k}", centre, own, m, (me.inertia(own, *inertias), centre)))
        loads.append((centre, -m * sm.Symbol("g") * frame.z))
        above = own
    kd = [i.diff(T) - rate for i, rate in zip(q, rates, strict=True)]
    return me.KanesMethod(
        frame, q, u, kd_eqs=kd, bodies=bodies, forcelist=loads, kd_eqs_solver=lambda a, b: b
    )


def operations(formed):
    graph, solved = formed.graph, formed.accelerations
    if solved is None:
        solved = solve_accelerations(graph, formed.matrix, formed.forcing, "ldl", Passes())
    nodes = simplify(graph, [*formed.rates, *solved])
    sizes = (len(nodes), len(formed.specifieds), len(formed.constants))
    program = lower(graph, sizes, [("rates", (len(nodes),), nodes)])
    return sum(program.operation_count["run"].values())


@pytest.mark.parametrize(
    ("kane", "limit"),
    [
        (lambda: pendulum(10), 490),
        (lambda: pendulum(20), 1010),
        (lambda: springs(30), 179),
        (lambda: rods(3), 664),
        (lambda: rods(5), 1545),
        (lambda: whipple_bicycle.derive().kane, 1175),
    ],
    ids=["pendulum-10", "pendulum-20", "springs-30", "rods-3", "rods-5", "bicycle"],
)
def test_no_model_costs_more_operations_than_it_did(kane, limit):
    assert operations(chosen(multibody_of_kane(kane()))) <= limit


def test_a_chain_costs_the_same_for_each_link():
    costs = {n: operations(chosen(multibody_of_kane(pendulum(n)))) for n in (10, 12, 14)}
    assert costs[14] - costs[12] == costs[12] - costs[10]


def test_a_chain_is_eliminated_from_its_end():
    formed = chosen(multibody_of_kane(pendulum(10)))
    assert formed.accelerations is not None


def test_few_speeds_are_solved_for_together():
    formed = chosen(multibody_of_kane(mechanisms.tilted_plates().kane))
    assert formed.accelerations is None


def test_the_chosen_form_is_the_one_that_is_compiled():
    kane = pendulum(10)
    program = System(kane, equations="graph").model.compiled("rates").program
    assert sum(program.operation_count["run"].values()) == operations(
        chosen(multibody_of_kane(kane))
    )
