"""Noncontributing forces, brought into evidence by auxiliary speeds."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy.system import System
from zoo.cases import close, system_of

GENERATORS = ["llvm", "lambdify"]
NAMES = ["disc_contact", "skate"]


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", NAMES)
def test_the_forces_agree_with_sympy(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model)
    system.generate_ode_function(generator=generator)
    x, t = model.sample()
    wide = [*x, *[0.1] * len(model.forces)]
    expected = oracle(model).forces(x, t)
    close(system.evaluate_outputs(wide, t)[-len(model.forces) :], expected)
    close(system.evaluate_ode(wide, t), [*oracle(model).xdot(x, t), *expected])


@pytest.mark.parametrize("name", NAMES)
def test_the_motion_is_that_without_naming_the_forces(name):
    model = zoo.MODELS[name]()
    x, t = model.sample()
    system = system_of(model, noncontributing_forces=None)
    assert system.num_auxiliaries == 0
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t))


def test_the_contact_forces_of_the_disc_obey_newton():
    model = zoo.disc_contact()
    m, r, g = (model.constants[s] for s in sm.symbols("m r g"))
    system = system_of(model, times=np.linspace(0.0, 0.4, 401))
    x = system.integrate(rtol=1e-11, atol=1e-11)
    force = system.evaluate_outputs(x)[:, -2:]
    yaw, lean = x[:, 0], x[:, 1]
    height = r * np.cos(lean)
    along = x[:, 3] + r * np.sin(lean) * np.sin(yaw)
    step = 1e-3
    for position, load in ((along, force[:, 0]), (height, force[:, 1] - m * g)):
        second = (position[2:] - 2 * position[1:-1] + position[:-2]) / step**2
        np.testing.assert_allclose(m * second, load[1:-1], atol=2e-3)


def test_the_side_force_of_the_skate_obeys_newton():
    model = zoo.skate()
    m, inertia, c, d, delta = (model.constants[s] for s in sm.symbols("m I c d delta"))
    system = system_of(model)
    _, _, _, v, w = model.x0
    *_, dv, dw, side = system.evaluate_ode([*model.x0, 0.0])
    # The front blade pushes across itself; moments about the centre of mass give its force.
    front = (inertia * dw + c * side) / ((d - c) * np.cos(delta))
    close(m * (dv - c * w**2), -front * np.sin(delta) - v)
    close(m * (c * dw + v * w), side + front * np.cos(delta))


def test_forces_that_depend_on_accelerations_have_auxiliaries():
    model = zoo.disc_contact()
    system = system_of(model)
    assert system.num_auxiliaries == 2
    assert system.noncontributing_forces == list(model.forces)
    assert system.outputs_symbols[-2:] == list(model.forces)


def test_forces_can_be_set_later_and_taken_away():
    model = zoo.skate()
    system = system_of(model, noncontributing_forces=None, times=[0.0, 0.1])
    assert system.integrate().shape == (2, 5)
    system.noncontributing_forces = model.forces
    assert system.integrate().shape == (2, 6)
    system.noncontributing_forces = None
    assert system.integrate().shape == (2, 5)


def test_the_names_may_come_in_any_order():
    model = zoo.disc_contact()
    x, t = model.sample()
    system = system_of(model, noncontributing_forces=model.forces[::-1])
    close(system.evaluate_outputs([*x, 0, 0], t)[-2:], oracle(model).forces(x, t)[::-1])


@pytest.mark.parametrize("count", [1, 3])
def test_a_wrong_number_of_names_is_a_value_error(count):
    model = zoo.disc_contact()
    names = [*model.forces, me.dynamicsymbols("Fy")][:count]
    with pytest.raises(ValueError, match=f"2.*{count}|{count}.*2"):
        System(model.kane, noncontributing_forces=names)


def test_a_method_without_auxiliary_equations_is_a_runtime_error():
    with pytest.raises(RuntimeError, match="auxiliary"):
        System(zoo.disc().kane, noncontributing_forces=[me.dynamicsymbols("Fz")])


def test_a_name_that_is_not_in_the_auxiliary_equations_is_named():
    model = zoo.disc_contact()
    with pytest.raises(ValueError, match="nope"):
        System(model.kane, noncontributing_forces=[model.forces[0], me.dynamicsymbols("nope")])


def test_a_force_that_stays_in_the_equations_of_motion_is_named():
    model = zoo.rubbing_skate()
    with pytest.raises(ValueError, match=r"Fs\(t\)"):
        System(model.kane, noncontributing_forces=model.forces)


def test_a_force_that_stays_in_the_equations_is_a_specified_when_not_named():
    model = zoo.rubbing_skate()
    assert System(model.kane).specifieds_symbols == set(model.forces)
