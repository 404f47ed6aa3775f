"""Operation counts are deterministic, so they are gated: a change that raises one must say why.

The expressions are frozen with the benchmarks, so that a release of SymPy cannot move the counts.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
import sympy as sm
import sympy.physics.mechanics as me

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

from harness import frozen
from harness.models import spring_chain
from harness.program import assembly_of

import zoo
from pydy._assembly.programs import block_program, jacobian_in_parts, jacobian_program
from pydy._graph.passes import names, rewriting
from pydy._graph.tuning import COLUMNS_TOGETHER
from pydy._program.program import Program
from pydy.system import System

# Operations at every call in M and F that were written out, and with the solve for the
# accelerations; the last column is what sympy.cse leaves of M and F. Models formed from bodies are
# the reference set for what a pass earns: see `FORMED` and
# `tests/_mechanics/test_select_formulation.py`.
LIMITS = {
    "pendulum-1": (9, 20, 16),
    "pendulum-5": (143, 302, 416),
    "pendulum-10": (398, 1142, 2161),
    "pendulum-20": (1208, 5397, 12457),
    "rods-3": (1076, 1501, 2291),
    "bicycle": (934, 1378, 1498),
    "rider-bicycle": (7100, 8413, 12216),
    "springs-100-absolute": (797, 897, 1299),
    "springs-100-stretch": (599, 798, 1100),
}


def operations(program):
    return sum(program.operation_count["run"].values())


@pytest.mark.parametrize("name", sorted(LIMITS))
def test_no_model_costs_more_operations_than_it_did(name):
    matrices, whole, cse = LIMITS[name]
    assembly = assembly_of(frozen.read(name))
    found = operations(block_program(assembly, "mass_matrix", "forcing"))
    assert found <= matrices
    assert found <= cse
    assert operations(block_program(assembly, "rates")) <= whole


# Operations at every call of the right-hand sides that are formed from the bodies of the zoo.
FORMED = {
    "added_mass": 55,
    "bare": 3,
    "chain": 22,
    "disc": 76,
    "disc_contact": 76,
    "fourbar": 118,
    "free_body": 53,
    "free_pendulum": 126,
    "gyro": 32,
    "lifted": 25,
    "pendulum": 73,
    "shaken": 24,
    "skate": 13,
    "sleigh": 61,
    "timed": 14,
    "track": 31,
    "track_reversed": 31,
    "undamped_chain": 7,
}


@pytest.mark.parametrize("name", zoo.MODELS)
def test_no_model_formed_from_bodies_costs_more_operations_than_it_did(name):
    system = System(zoo.MODELS[name]().kane, equations="graph")
    assert operations(system.model.compiled("rates").program) <= FORMED.get(name, 0)


# Operations at every call in the Jacobian of the derivatives by the states.
JACOBIANS = {
    "pendulum-5": 1230,
    "pendulum-10": 6780,
    "rods-3": 10682,
    "bicycle": 6217,
}


@pytest.mark.parametrize("name", sorted(JACOBIANS))
def test_no_jacobian_costs_more_operations_than_it_did(name):
    program = jacobian_program(assembly_of(frozen.read(name)), "rates", "x")
    assert operations(program) <= JACOBIANS[name]


# The same in parts: operations to compile, and vectors of operations to execute.
IN_PARTS = {
    "pendulum-5": (750, 919),
    "pendulum-10": (3144, 3473),
    "rods-3": (5626, 6093),
    "quadrotor": (1279, 1279),
}


@pytest.mark.parametrize("name", sorted(IN_PARTS))
def test_no_jacobian_in_parts_costs_more_operations_than_it_did(name):
    made = jacobian_in_parts(assembly_of(frozen.read(name)), "rates", "x")
    code, run = (operations(made.shared),) * 2
    for part in made.parts:
        own = operations(part.program)
        code, run = code + own, run + own * -(-part.count // COLUMNS_TOGETHER)
    assert code <= IN_PARTS[name][0]
    assert run <= IN_PARTS[name][1]


def test_a_jacobian_that_gains_nothing_in_parts_is_one_program():
    made = jacobian_in_parts(assembly_of(frozen.read("bicycle")), "rates", "x")
    assert isinstance(made, Program)


def test_function_and_jacobian_are_simplified_once(monkeypatch):
    from pydy._assembly import assembly as module

    assembly = assembly_of(frozen.read("pendulum-5"))
    calls = []
    real = module.simplify
    monkeypatch.setattr(module, "simplify", lambda *args: calls.append(1) or real(*args))
    block_program(assembly, "rates")
    jacobian_program(assembly, "rates", "x")
    jacobian_program(assembly, "rates", "p")
    assert len(calls) == 1


def test_a_chain_of_masses_costs_the_same_for_each_mass():
    from pydy.models import multi_mass_spring_damper

    costs = {}
    for n in (10, 20, 40):
        system = multi_mass_spring_damper(n, apply_gravity=True, apply_external_forces=True)
        system.generate_ode_function()
        costs[n] = operations(system.model.compiled("rates").program)
    assert (costs[40] - costs[20]) / 20 == pytest.approx((costs[20] - costs[10]) / 10, rel=0.05)


# For each pass and strategy a model that takes so many times the operations without it. What gives
# less than 3 % on every model is not kept.
WORTH = {
    "differences": ("springs-20-stretch", 5.0),
    "factor": ("pendulum-10", 1.5),
    "merge": ("rods-3", 1.15),
    "expand": ("pendulum-10", 1.18),
    "share products": ("bicycle", 1.07),
    "share sums": ("springs-100-stretch", 1.1),
    "ldl": ("quadrotor", 1.3),
    "lu": ("rider-bicycle", 1.15),
}


def test_every_pass_and_strategy_is_measured_below():
    assert set(WORTH) == set(names())


@pytest.mark.parametrize("switch", sorted(WORTH))
def test_each_pass_and_strategy_is_worth_its_lines_and_really_off_without(switch):
    name, times = WORTH[switch]
    model = spring_chain(20, absolute=False) if "springs-20" in name else frozen.read(name)
    without = block_program(assembly_of(model, off=frozenset({switch})), "rates")
    assert operations(without) >= times * operations(block_program(assembly_of(model), "rates"))


def test_pendulums_on_one_cart_are_eliminated_before_it():
    # In the given order the cart goes first and joins them all: 827 operations.
    n, frame, origin = 10, me.ReferenceFrame("N"), me.Point("O")
    q, u = me.dynamicsymbols(f"q0:{n + 1}"), me.dynamicsymbols(f"u0:{n + 1}")
    m, length, g = sm.symbols("m l g")
    origin.set_vel(frame, 0)
    cart = origin.locatenew("C", q[0] * frame.x)
    cart.set_vel(frame, u[0] * frame.x)
    bodies, loads = [me.Particle("cart", cart, m)], []
    for k in range(1, n + 1):
        arm = frame.orientnew(f"A{k}", "axis", (q[k], frame.z))
        arm.set_ang_vel(frame, u[k] * frame.z)
        tip = cart.locatenew(f"P{k}", -length * arm.y)
        tip.v2pt_theory(cart, frame, arm)
        bodies.append(me.Particle(f"bob{k}", tip, m))
        loads.append((tip, -m * g * frame.y))
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=rates, bodies=bodies, forcelist=loads)
    kane.kanes_equations()
    assert operations(System(kane).model.compiled("rates").program) <= 167


def test_the_matrix_is_solved_as_given_where_no_unknowns_are_changed():
    model = frozen.read("springs-100-stretch")
    assert assembly_of(model).blocks.mass_matrix not in solved_matrices(assembly_of(model))
    for off in (frozenset({"differences"}), rewriting()):
        assembly = assembly_of(model, off=off)
        assert assembly.blocks.mass_matrix in solved_matrices(assembly)


def solved_matrices(assembly):
    """The entries of all matrices that are factored, each as a list."""
    graph = assembly.graph
    nodes = graph.reachable(assembly.blocks.rates)
    return [list(graph.args[n][2]) for n in nodes if graph.ops[n] == "factor"]
