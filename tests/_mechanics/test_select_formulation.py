"""The form that is chosen, what it costs, and when it takes the place of a method's equations.

Counts are gated, as for the frozen models.
"""

import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from sympy.physics.mechanics import KanesMethod, models

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))

from trees import HUMANOID, definition, rods, tree

import zoo
from pydy._assembly import assembly
from pydy._assembly.programs import block_program
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._graph.simplification import simplify
from pydy._mechanics import select_formulation as formed
from pydy._mechanics.formulations import useful_axes
from pydy._mechanics.kane import multibody_of_kane
from pydy._mechanics.select_formulation import chosen
from pydy.examples import whipple_bicycle
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from zoo import by_hand
from zoo.rolling import ball_on_a_turntable


@cache
def underived(make, n):
    """A method that has been given its bodies and loads, without equations that nobody reads."""

    def only_given(kane, bodies, loads=None):
        kane._bodylist, kane._forcelist = bodies, loads

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(KanesMethod, "kanes_equations", only_given)
        return make(n)


def links(n):
    return n_link_pendulum_on_cart(n, cart_force=True, joint_torques=False).eom_method


def pendulum(n):
    return underived(links, n)


def springs(n):
    return underived(models.multi_mass_spring_damper, n)


def revolute(parents):
    """Joints with general inertias, offset mass centres, torques; gravity on a slant."""
    return definition(tree(parents, np.random.default_rng(3), aligned=True))


def straight_arm(n):
    """The same as a chain, with each joint on the z axis of the body before."""
    made = tree(range(-1, n - 1), np.random.default_rng(3), aligned=True)
    for link in made["links"]:
        link["place"][:2] = 0.0, 0.0
    return definition(made)


def operations(found):
    graph, dynamics = found.graph, found.dynamics
    solved = dynamics.accelerations
    if solved is None:
        system = LinearSystem(graph, dynamics.matrix, "ldl")
        solved = system.solve_by_differences(dynamics.forcing)
    nodes = simplify(graph, [*found.rates, *solved])
    sizes = (len(nodes), len(found.specifieds), len(found.constants))
    program = lower(graph, sizes, [("rates", (len(nodes),), nodes)])
    return sum(program.operation_count["run"].values())


@pytest.mark.parametrize(
    ("kane", "limit"),
    [
        (lambda: pendulum(5), 229),
        (lambda: pendulum(10), 489),
        (lambda: pendulum(20), 1010),
        (lambda: springs(30), 179),
        (lambda: whipple_bicycle.derive().kane, 1118),
    ],
    ids=["pendulum-5", "pendulum-10", "pendulum-20", "springs-30", "bicycle"],
)
def test_no_model_costs_more_operations_than_it_did(kane, limit):
    assert operations(chosen(multibody_of_kane(kane()))) <= limit


@pytest.mark.parametrize(
    ("source", "limit"),
    [
        (lambda: rods(3), 596),
        (lambda: rods(5), 1229),
        (lambda: rods(10), 2788),
        (lambda: revolute(range(-1, 6)), 1395),
        (lambda: straight_arm(7), 1160),
        (lambda: revolute(HUMANOID), 7037),
        (lambda: whipple_bicycle.derive().definition, 1058),
    ],
    ids=["rods-3", "rods-5", "rods-10", "arm", "straight arm", "tree of 29 joints", "bicycle"],
)
def test_no_definition_costs_more_operations_than_it_did(source, limit):
    program = block_program(System(source()).model.assembly, "rates")
    assert sum(program.operation_count["run"].values()) <= limit


def test_a_chain_costs_the_same_for_each_link():
    costs = {n: operations(chosen(multibody_of_kane(pendulum(n)))) for n in (6, 8, 10)}
    assert costs[10] - costs[8] == costs[8] - costs[6]


def test_a_chain_is_eliminated_from_its_end():
    found = chosen(multibody_of_kane(pendulum(10)))
    assert found.dynamics.accelerations is not None


def test_few_speeds_are_solved_for_together():
    found = chosen(multibody_of_kane(by_hand.tilted_plates().kane))
    assert found.dynamics.accelerations is None


def test_the_chosen_form_is_the_one_that_is_compiled():
    kane = pendulum(10)
    program = System(kane, equations="graph").model.compiled("rates").program
    assert sum(program.operation_count["run"].values()) == operations(
        chosen(multibody_of_kane(kane))
    )


def test_what_was_simplified_to_be_counted_is_what_is_compiled(monkeypatch):
    def make_canonical(*_):
        raise AssertionError("simplified again")

    system = n_link_pendulum_on_cart(5)
    monkeypatch.setattr(assembly, "simplify", make_canonical)
    program = block_program(system.model.assembly, "rates")
    assert sum(program.operation_count["run"].values()) <= 229


def test_counted_forms_take_expressions_for_their_forces():
    system = n_link_pendulum_on_cart(5)
    x = np.linspace(0.1, 1.2, 12)
    (force,) = system.specifieds_symbols
    system.specifieds[force] = 3.0 * x[1]
    expected = system.evaluate_ode(x)
    system.specifieds[force] = 3 * system.coordinates[1]
    np.testing.assert_allclose(system.evaluate_ode(x), expected, rtol=1e-12, atol=1e-12)
    assert abs(expected).max() > 0.1


def test_what_is_integrated_beside_the_rates_is_not_lost_with_counted_forms():
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    assembly = system.model.assembly
    rates = assembly.blocks.rates
    more = replace(assembly, blocks=replace(assembly.blocks, rates=[*rates, rates[0]]))
    assert assembly.ready is not None
    assert len(more.simplified("rates")[1]) == 3


def test_only_axes_that_may_cost_less_are_tried():
    tried = {
        "planes": useful_axes(multibody_of_kane(pendulum(2))),
        "hinges in space": useful_axes(multibody_of_kane(zoo.MODELS["disc"]().kane)),
        "a thrown body": useful_axes(multibody_of_kane(zoo.MODELS["free_body"]().kane)),
    }
    assert tried == {"planes": [True, False], "hinges in space": [True], "a thrown body": [False]}


def test_nothing_is_simplified_where_there_is_one_form(monkeypatch):
    def never(*_):
        raise AssertionError("simplified")

    monkeypatch.setattr(formed, "simplify", never)
    assert chosen(multibody_of_kane(zoo.MODELS["fourbar"]().kane)).simplified is None


def test_entries_that_cancel_but_for_rounding_are_no_difference(caplog):
    with caplog.at_level("INFO", logger="pydy"):
        system = System(ball_on_a_turntable().kane)
    assert "other numbers" not in caplog.text
    assert system._equations.formed is not None
