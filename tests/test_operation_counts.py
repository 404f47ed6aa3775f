"""Operation counts are deterministic, so they are gated: a change that raises one must say why.

The expressions are frozen with the benchmarks, so that a release of SymPy cannot move the counts.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

from harness import frozen
from harness.program import assembly_of

from pydy._graph import accelerations
from pydy._graph.passes import Passes

# Operations at every call in M and F, and with the solve for the accelerations; the last column
# is what sympy.cse leaves of M and F.
LIMITS = {
    "pendulum-1": (9, 21, 16),
    "pendulum-5": (143, 304, 416),
    "pendulum-10": (398, 670, 2161),
    "pendulum-20": (1208, 1390, 12457),
    "rods-3": (1028, 707, 2291),
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
    found = operations(assembly.program("mass_matrix", "forcing"))
    assert found <= matrices
    assert found <= cse
    assert operations(assembly.program("rates")) <= whole


# Operations at every call in the Jacobian of the derivatives by the states.
JACOBIANS = {
    "pendulum-5": 1230,
    "pendulum-10": 5061,
    "rods-3": 5916,
    "bicycle": 6217,
}


@pytest.mark.parametrize("name", sorted(JACOBIANS))
def test_no_jacobian_costs_more_operations_than_it_did(name):
    program = assembly_of(frozen.read(name)).jacobian_program("rates", "x")
    assert operations(program) <= JACOBIANS[name]


def test_function_and_jacobian_are_simplified_once(monkeypatch):
    from pydy._assembly import assembly as module

    assembly = assembly_of(frozen.read("pendulum-5"))
    calls = []
    real = module.simplify
    monkeypatch.setattr(module, "simplify", lambda *args: calls.append(1) or real(*args))
    assembly.program("rates")
    assembly.jacobian_program("rates", "x")
    assembly.jacobian_program("rates", "p")
    assert len(calls) == 1


def test_a_chain_of_masses_costs_the_same_for_each_mass():
    from pydy.models import multi_mass_spring_damper

    costs = {}
    for n in (10, 20, 40):
        system = multi_mass_spring_damper(n, apply_gravity=True, apply_external_forces=True)
        system.generate_ode_function()
        costs[n] = operations(system._current().compiled("rates").program)
    assert (costs[40] - costs[20]) / 20 == pytest.approx((costs[20] - costs[10]) / 10, rel=0.05)


@pytest.mark.parametrize("name", ["rods-3", "springs-100-stretch"])
def test_the_change_of_unknowns_can_be_switched_off(name, monkeypatch):
    model = frozen.read(name)
    assert assembly_of(model).mass_matrix not in solved_matrices(assembly_of(model))

    def never(*_):
        raise AssertionError("the unknowns were changed")

    monkeypatch.setattr(accelerations, "body_basis", never)
    monkeypatch.setattr(accelerations, "difference_basis", never)
    for passes in (Passes(rebase=False), Passes.none()):
        assembly = assembly_of(model, passes=passes)
        assert assembly.mass_matrix in solved_matrices(assembly)


def solved_matrices(assembly):
    """The entries of all matrices that are factored, each as a list."""
    graph = assembly.graph
    nodes = graph.reachable(assembly.rates)
    return [list(graph.args[n][2]) for n in nodes if graph.ops[n] == "factor"]
