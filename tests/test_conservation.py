"""Energy, momenta and constraints are conserved along tightly integrated trajectories."""

import numpy as np
import pytest
import sympy as sm

import zoo
from zoo.cases import system_of

TIMES = np.linspace(0.0, 1.0, 5)
TIGHT = {"rtol": 1e-11, "atol": 1e-11, "mxstep": 5000}


def along(model, expressions, x):
    """Values of expressions in states and constants at every row, with NumPy."""
    f = sm.lambdify(model.states, [sm.sympify(e).xreplace(model.constants) for e in expressions])
    return np.array([f(*row[: len(model.states)]) for row in x], dtype=float)


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("name", zoo.CONSERVATIVE)
def test_energy_and_momenta_are_conserved(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model, times=TIMES)
    system.generate_ode_function(generator=generator)
    x = system.integrate(**TIGHT)
    values = along(model, [model.energy, *model.momenta], x)
    scale = max(1.0, np.max(np.abs(values[0])))
    np.testing.assert_allclose(values, np.tile(values[0], (5, 1)), rtol=0, atol=1e-8 * scale)
    assert np.max(np.abs(x[-1] - x[0])) > 0.1


@pytest.mark.parametrize("name", ["disc", "disc_contact", "sleigh", "fourbar", "track", "gyro"])
def test_constraints_hold_along_the_way(name):
    model = zoo.MODELS[name]()
    system = system_of(model, times=TIMES)
    x = system.integrate(**TIGHT)
    np.testing.assert_allclose(system.evaluate_constraints(x), 0.0, atol=1e-8)


def test_energy_as_an_output_is_conserved():
    model = zoo.free_pendulum()
    energy = sm.Symbol("E")
    system = system_of(model, times=TIMES, outputs={energy: model.energy})
    values = system.evaluate_outputs(system.integrate(**TIGHT))[:, 0]
    np.testing.assert_allclose(values, values[0], rtol=1e-9)


def test_the_work_of_a_force_is_the_gain_of_energy():
    """The integral of the power, as an auxiliary state beside the motion, is the gain."""
    model = zoo.undamped_chain()
    m1, m2, v1 = sm.Symbol("m1", positive=True), sm.Symbol("m2", positive=True), model.states[2]
    _, v2 = model.kane.u
    power = sm.Symbol("P")
    t = zoo.T
    kinetic = m1 * v1 * v1.diff(t) + m2 * v2 * v2.diff(t)
    system = system_of(model, times=TIMES, outputs={power: power - kinetic})
    x = system.integrate(**TIGHT)
    values = along(model, [m1 * v1**2 / 2 + m2 * v2**2 / 2], x)[:, 0]
    np.testing.assert_allclose(x[:, 4], values - values[0], atol=1e-9)
