"""The bicycle, as the largest system with everything in it, against SymPy."""

from functools import cache

import numpy as np
import pytest

import zoo
from oracles.oracle import oracle
from pydy.examples import whipple_bicycle
from zoo.cases import close, system_of

GENERATORS = ["llvm", "lambdify"]


@cache
def bicycle():
    """The bicycle of the examples as a model of the zoo."""
    made = whipple_bicycle.derive()
    made.kane.kanes_equations(made.bodies, made.kane.loads)  # for the oracle
    return zoo.Model(
        made.kane,
        whipple_bicycle.benchmark_parameters(made),
        {made.push: 3.0, made.roll_torque: 0.7, made.steer_torque: -0.4},
        forces=made.contact_forces,
        start=whipple_bicycle.equilibrium(made, 4.6),
    )


@pytest.mark.parametrize("generator", GENERATORS)
def test_derivatives_and_contact_forces_agree_with_sympy(generator):
    model = bicycle()
    system = system_of(model, equations="graph")
    system.generate_ode_function(generator=generator)
    x, t = model.sample()
    x *= 0.3
    wide = [*x, 0.1, 0.2]
    forces = oracle(model).forces(x, t)
    close(system.evaluate_ode(wide, t), [*oracle(model).xdot(x, t), *forces], 1e-9)
    close(system.evaluate_outputs(wide, t)[-2:], forces, 1e-9)
    close(system.evaluate_holonomic_constraints(wide, t), oracle(model).holonomic(x, t))
    close(system.evaluate_velocity_constraints(wide, t), oracle(model).velocity(x, t))


def test_the_counts_are_those_of_the_bicycle():
    system = system_of(bicycle(), equations="graph")
    assert system.num_holonomic_constraints == 1
    assert system.num_velocity_constraints == 5
    assert system.num_nonholonomic_constraints == 4
    assert system.num_constraints == 5
    assert system.num_auxiliaries == 2


def test_a_leaning_bicycle_gets_a_consistent_state():
    model = bicycle()
    start = {s: v for s, v in model.start.items() if s.name not in {"u_psi", "omega_F", "u_x"}}
    system = system_of(model, initial_conditions=start)
    lean, steer = (s for s in model.states if s.name in {"phi", "delta"})
    system.initial_conditions.update({lean: 0.2, steer: 0.3})
    system.set_dependent_initial_conditions(use_jac=True)
    close(system.evaluate_holonomic_constraints(), [0.0], 1e-10)
    close(system.evaluate_velocity_constraints(), np.zeros(5), 1e-10)


def test_the_wheels_of_a_bicycle_at_rest_carry_its_weight():
    model = bicycle()
    system = system_of(model, specifieds={})
    weight = 9.81 * sum(v for s, v in model.constants.items() if s.name.startswith("m_"))
    close(sum(system.evaluate_outputs()[-2:]), weight)


@pytest.mark.parametrize("lean", [0.0, 0.2])
def test_the_forces_under_the_wheels_need_no_auxiliary_speeds(lean):
    model = bicycle()
    start = {s: v for s, v in model.start.items() if s.name not in {"u_psi", "omega_F", "u_x"}}
    system = system_of(model, initial_conditions=start)
    rolling = {s.name: s for s in model.states}
    system.initial_conditions |= {rolling["phi"]: lean, rolling["delta"]: lean / 2}
    system.set_dependent_initial_conditions(use_jac=True)
    points = {load[0].name: load[0] for load in model.kane.loads}
    system.outputs = system.reaction(model.kane.bodies, points["P"]).outputs("ground")
    values = dict(zip(map(str, system.outputs_symbols), system.evaluate_outputs(), strict=True))
    close(-values["ground_Fz"], values["N_r(t)"] + values["N_f(t)"], 1e-12)
    if not lean:  # the front wheel's share by its lever, the wheelbase
        wheelbase = next(v for s, v in model.constants.items() if s.name == "w")
        close(values["ground_Ty"], values["N_f(t)"] * wheelbase, 1e-12)
