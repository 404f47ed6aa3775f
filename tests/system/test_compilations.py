"""How many Programs are compiled for each public call, and for how many lanes.

Compiling is what a first call waits for: each counts.
"""

import numpy as np
import pytest
import sympy as sm

import zoo
from pydy._backends.llvm.native import LLVMBackend
from pydy.ensemble import model as ensembles
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event
from zoo.cases import system_of

TIMES = np.linspace(0.0, 0.1, num=5)


@pytest.fixture
def compiled(monkeypatch):
    """The lanes, the blocks and the number of outputs of every Program that is compiled."""
    found = []
    compile_it = LLVMBackend.compile

    def counted(self, program):
        names = [block.name for block in program.signature.blocks]
        found.append((self.options["lanes"], names, program.signature.num_outputs))
        return compile_it(self, program)

    monkeypatch.setattr(LLVMBackend, "compile", counted)
    monkeypatch.setattr(ensembles, "_KERNELS", {})
    return found


def fourbar(**options):
    return system_of(zoo.fourbar(), times=TIMES, **options)


def spring(**options):
    system = multi_mass_spring_damper()
    system.times = TIMES
    system.initial_conditions = {"x0": 0.5}
    for name, value in options.items():
        setattr(system, name, value)
    return system


def blocks(compiled):
    return [name for _, names, _ in compiled for name in names]


def test_the_first_integration_of_a_constrained_system_compiles_its_rates_alone(compiled):
    fourbar().integrate()
    assert blocks(compiled) == ["rates"]


def test_what_was_compiled_is_not_compiled_again(compiled):
    system = fourbar()
    system.integrate()
    system.constants = dict(system.constants)
    system.initial_conditions = dict(system.initial_conditions)
    system.ode_solver = "dop853"
    system.integrate()
    system.evaluate_ode()
    assert blocks(compiled) == ["rates"]


def test_setting_reading_and_printing_compile_nothing(compiled):
    system = fourbar(outputs={sm.Symbol("o"): zoo.fourbar().states[0]})
    system.outputs[sm.Symbol("twice")] = 2 * system.states[0]
    assert system.num_outputs == 4  # two of them constraints
    assert system.evaluate_ode_function is None
    assert "blocks" in repr(system.model)
    assert repr(system)
    assert repr(system.model.assembly)
    assert not compiled


def test_a_generated_function_is_compiled_once(compiled):
    system = spring()
    system.generate_ode_function()
    assert system.evaluate_ode_function is system.evaluate_ode_function
    system.integrate()
    assert blocks(compiled) == ["rates"]


@pytest.mark.parametrize(
    ("make", "expected"), [(spring, ["rates"]), (fourbar, ["rates", "outputs"])]
)
def test_a_simulation_compiles_nothing_empty(compiled, make, expected):
    trajectory = make().simulate()
    assert np.isfinite(trajectory.states).all()
    assert trajectory.specifieds.shape == (len(TIMES), 0)
    assert blocks(compiled) == expected
    assert all(outputs for _, _, outputs in compiled)


@pytest.mark.parametrize(
    ("make", "expected"),
    [(spring, ["rates"]), (fourbar, ["rates", "rows", "sizes", "products", "outputs"])],
)
def test_an_ensemble_compiles_eight_lanes_alone(compiled, make, expected):
    system = make()
    constant = next(iter(system.constants_symbols))
    values = float(system.constants.get(constant, 1.0)) * np.ones(2)
    system.integrate_ensemble(constants={constant: values}, times=TIMES)
    assert blocks(compiled) == expected
    assert {lanes for lanes, _, _ in compiled} == {8}


EVALUATIONS = {
    "ode": "rates",
    "outputs": "outputs",
    "constraints": "constraints",
    "holonomic_constraints": "holonomic",
    "velocity_constraints": "velocity",
    "jacobian": "jacobian",
}


@pytest.mark.parametrize("name", EVALUATIONS)
def test_each_evaluation_compiles_one_program(compiled, name):
    system = fourbar()
    evaluate = getattr(system, f"evaluate_{name}")
    evaluate()
    evaluate(np.tile(list(system.initial_conditions.values()), (3, 1)), TIMES[:3])
    assert blocks(compiled) == [EVALUATIONS[name]]


def test_three_energies_are_one_program(compiled):
    system = spring()
    system.evaluate_energy()
    assert blocks(compiled) == ["the energy"]


def test_dependent_initial_conditions_take_three(compiled):
    fourbar().set_dependent_initial_conditions()
    assert blocks(compiled) == ["holonomic", "rounding", "jacobian", "velocity"]
    assert len(compiled) == 3


def test_a_linear_model_takes_the_rates_and_their_derivatives(compiled):
    spring().linearize()
    assert blocks(compiled) == ["jacobian", "rates"]


def test_a_linear_model_with_constraints_takes_a_jacobian_more_for_each_kind(compiled):
    fourbar().linearize({})
    assert sorted(blocks(compiled)) == ["jacobian", "jacobian", "jacobian", "rates"]


def test_a_search_for_an_equilibrium_takes_the_rates_and_their_jacobian(compiled):
    spring().find_equilibrium()
    assert sorted(blocks(compiled)) == ["jacobian", "rates"]


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({}, 1),
        ({"constraints": "project"}, 2),
        ({"constraints": "baumgarte", "gain": 5.0}, 1),
    ],
)
def test_a_native_solver_takes_the_rates_and_what_holds_constraints(compiled, options, expected):
    fourbar(ode_solver="dop853").integrate(**options)
    assert len(compiled) == expected


def test_an_implicit_solver_takes_the_jacobian_too(compiled):
    spring(ode_solver="radau").integrate()
    assert sorted(blocks(compiled)) == ["jacobian", "rates"]


@pytest.mark.parametrize("number", [1, 4])
def test_events_take_as_many_programs_however_many_there_are(compiled, number):
    system = spring(ode_solver="dop853")
    q, u = system.states
    events = [Event(q - 5.0 - k, reset={u: -u}, name=f"event {k}") for k in range(number)]
    system.integrate(events=events)
    assert len(compiled) == 5  # the events' rates and rounding bounds are one
    expected = ["bounds", "rates", "rates", "reach", "resets", "the events", "values"]
    assert sorted(blocks(compiled)) == expected
