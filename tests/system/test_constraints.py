"""Constraints: which there are, in which order, and what they are worth at a state."""

import numpy as np
import pytest
import sympy as sm

import zoo
from cases import close, system_of, wide
from oracle import oracle
from pydy.system import System

CONSTRAINED = ["disc", "disc_contact", "sleigh", "skate", "fourbar", "track", "track_reversed"]
CONSTRAINED += ["gyro", "lifted"]
HOLONOMIC = ["fourbar", "track", "track_reversed", "gyro", "lifted"]
MOVING = [n for n in CONSTRAINED if n != "gyro"]

# Which of the velocity rows are genuinely nonholonomic.
GENUINE = {"disc": [0, 1], "disc_contact": [0, 1], "sleigh": [0], "skate": [0], "fourbar": []}
GENUINE |= {"track": [1], "track_reversed": [0], "gyro": [], "lifted": []}


def expected(name, x, t, numbers=None):
    """Holonomic residuals, then the genuinely nonholonomic ones."""
    model = zoo.MODELS[name]()
    values = [oracle(model).holonomic(x, t, numbers)]
    if GENUINE[name]:
        values.append(oracle(model).velocity(x, t, numbers)[GENUINE[name]])
    return np.concatenate(values)


def test_an_unconstrained_system_has_an_empty_matrix():
    constraints = System(zoo.chain().kane).constraints
    assert isinstance(constraints, sm.MatrixBase)
    assert len(constraints) == 0


@pytest.mark.parametrize("name", CONSTRAINED)
def test_the_constraints_are_a_column_of_holonomic_then_nonholonomic(name):
    model = zoo.MODELS[name]()
    system = system_of(model)
    x, t = model.sample(4)
    assert isinstance(system.constraints, sm.MatrixBase)
    assert system.constraints.shape == (system.num_constraints, 1)
    close(oracle(model).evaluate(list(system.constraints), x, t), expected(name, x, t))


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("name", CONSTRAINED)
def test_evaluate_constraints_agrees_with_sympy(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model)
    system.generate_ode_function(generator=generator)
    x, t = model.sample(4)
    close(system.evaluate_constraints(wide(system, x), t), expected(name, x, t))


@pytest.mark.parametrize("name", HOLONOMIC)
def test_evaluate_holonomic_constraints_agrees_with_sympy(name):
    model = zoo.MODELS[name]()
    x, t = model.sample(5)
    close(system_of(model).evaluate_holonomic_constraints(x, t), oracle(model).holonomic(x, t))


@pytest.mark.parametrize("name", MOVING)
def test_evaluate_velocity_constraints_gives_all_rows_of_the_method(name):
    model = zoo.MODELS[name]()
    x, t = model.sample(6)
    system = system_of(model)
    got = system.evaluate_velocity_constraints(wide(system, x), t)
    close(got, oracle(model).velocity(x, t))


@pytest.mark.parametrize(
    "method",
    ["evaluate_constraints", "evaluate_holonomic_constraints", "evaluate_velocity_constraints"],
)
def test_a_series_of_states_gives_the_same_rows(method):
    model = zoo.track()
    system = system_of(model)
    xs, ts = model.sample(7, 5)
    rows = [getattr(system, method)(x, t) for x, t in zip(xs, ts, strict=True)]
    close(getattr(system, method)(xs, ts), rows, 1e-13)


@pytest.mark.parametrize("name", CONSTRAINED)
def test_the_default_is_the_initial_condition(name):
    model = zoo.MODELS[name]()
    system = system_of(model, times=[0.7, 1.0])
    close(system.evaluate_constraints(), expected(name, model.x0, 0.7))


def test_constants_count_in_the_constraints():
    model = zoo.fourbar()
    x, t = model.sample(8)
    system = system_of(model)
    system.constants[sm.Symbol("ln")] = 5.0
    numbers = {sm.Symbol("ln"): 5.0}
    close(system.evaluate_constraints(x, t), expected("fourbar", x, t, numbers))


@pytest.mark.parametrize(
    ("name", "method"),
    [
        ("chain", "evaluate_constraints"),
        ("chain", "evaluate_holonomic_constraints"),
        ("chain", "evaluate_velocity_constraints"),
        ("sleigh", "evaluate_holonomic_constraints"),
        ("gyro", "evaluate_velocity_constraints"),
    ],
)
def test_asking_for_constraints_that_are_not_there_is_a_value_error(name, method):
    kind = method.split("_")[1]
    with pytest.raises(ValueError, match=kind if kind != "constraints" else "constraint"):
        getattr(system_of(zoo.MODELS[name]()), method)()


def test_a_system_with_holonomic_constraints_only_moves_on_them():
    system = system_of(zoo.fourbar(), times=np.linspace(0.0, 1.0, 5))
    x = system.integrate(rtol=1e-11, atol=1e-11)
    close(system.evaluate_constraints(x), np.zeros((5, 2)), 1e-8)
    close(system.evaluate_velocity_constraints(x), np.zeros((5, 2)), 1e-8)


def test_a_system_with_nonholonomic_constraints_only_moves_on_them():
    system = system_of(zoo.disc(), times=np.linspace(0.0, 1.0, 5))
    x = system.integrate(rtol=1e-11, atol=1e-11)
    close(system.evaluate_constraints(x), np.zeros((5, 2)), 1e-8)


def test_a_system_with_both_moves_on_them():
    system = system_of(zoo.track(), times=np.linspace(0.0, 0.5, 5))
    x = system.integrate(rtol=1e-11, atol=1e-11)
    close(system.evaluate_constraints(x), np.zeros((5, 2)), 1e-8)
