"""What constants, initial conditions, times and the solver may be."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint

import zoo
from oracles.oracle import oracle
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper
from pydy.system import System
from zoo.cases import close, system_of

NOPE = sm.Symbol("nope")


# constants


def test_constants_show_only_what_was_set():
    m1 = sm.Symbol("m1")
    system = System(zoo.pendulum().kane, constants={m1: 2.0})
    assert system.constants == {m1: 2.0}


def test_constants_default_to_one():
    model = zoo.timed()
    x, t = model.sample()
    m = sm.Symbol("m")
    system = System(model.kane, constants={m: 2.5})
    numbers = dict.fromkeys(model.constants, 1.0) | {m: 2.5}
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t, numbers))


def test_a_constant_edited_in_place_counts():
    model = zoo.timed()
    x, t = model.sample()
    system = system_of(model)
    system.evaluate_ode(x, t)
    system.constants[sm.Symbol("k")] = 7.5
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t, {sm.Symbol("k"): 7.5}))


def test_a_constant_taken_out_in_place_is_one_again():
    model = zoo.timed()
    x, t = model.sample()
    system = system_of(model)
    system.evaluate_ode(x, t)
    del system.constants[sm.Symbol("k")]
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t, {sm.Symbol("k"): 1.0}))


@pytest.mark.parametrize("value", [3, np.float32(3.0), np.int64(3), sm.Integer(3), sm.Float(3.0)])
def test_a_constant_may_be_any_real_number(value):
    model = zoo.timed()
    x, t = model.sample()
    system = system_of(model)
    system.constants = {**model.constants, sm.Symbol("k"): value}
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t, {sm.Symbol("k"): 3.0}))


def test_an_unknown_constant_is_named_when_set():
    system = System(zoo.timed().kane)
    with pytest.raises(ValueError, match="nope"):
        system.constants = {NOPE: 1.0}
    assert system.constants == {}


def test_a_state_is_not_a_constant():
    system = System(zoo.timed().kane)
    with pytest.raises(ValueError, match=r"x\(t\)"):
        system.constants = {system.states[0]: 1.0}


@pytest.mark.parametrize("action", ["evaluate_ode", "integrate"])
def test_an_unknown_constant_put_in_the_dict_is_named_at_the_next(action):
    system = System(zoo.timed().kane, times=[0.0, 1.0])
    getattr(system, action)()
    system.constants[NOPE] = 1.0
    with pytest.raises(ValueError, match="nope"):
        getattr(system, action)()


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_a_system_without_constants_works(generator):
    model = zoo.bare()
    system = System(model.kane, times=[0.0, 0.5], initial_conditions=model.start)
    rhs = system.generate_ode_function(generator=generator)
    assert system.constants_symbols == set()
    assert repr(system.constants_symbols) == repr(set())
    expected = oracle(model).xdot(model.x0)
    close(system.evaluate_ode(), expected)
    close(rhs(model.x0, 0.0, np.array([])), expected)
    close(rhs(model.x0, 0.0, {}), expected)
    assert system.integrate().shape == (2, 2)


# initial conditions


def test_initial_conditions_default_to_zero():
    system = System(zoo.timed().kane, times=[0.0, 1.0])
    assert system.initial_conditions == {}
    x = system.states[0]
    system.initial_conditions[x] = 0.5
    close(system.integrate()[0], [0.5, 0.0])


@pytest.mark.parametrize("action", ["evaluate_ode", "integrate"])
def test_an_unknown_initial_condition_put_in_the_dict_is_named_at_the_next(action):
    system = System(zoo.timed().kane, times=[0.0, 1.0])
    getattr(system, action)()
    system.initial_conditions[NOPE] = 1.0
    with pytest.raises(ValueError, match="nope"):
        getattr(system, action)()


# times


def test_times_become_an_array_of_floats():
    system = System(zoo.timed().kane, times=[0, 1, 3])
    assert isinstance(system.times, np.ndarray)
    close(system.times, [0.0, 1.0, 3.0])


def test_integer_times_integrate_as_floats_do():
    system = system_of(zoo.timed(), times=np.arange(4))
    whole = system.integrate()
    system.times = np.arange(4.0)
    close(whole, system.integrate(), 1e-14)


def test_equal_neighbours_are_allowed_in_times():
    system = System(zoo.timed().kane, times=[0.0, 1.0, 1.0, 2.0])
    assert system.integrate().shape == (4, 2)


def test_wrong_times_are_refused_when_set():
    system = System(zoo.timed().kane, times=[0.0, 1.0])
    with pytest.raises(ValueError, match="times"):
        system.times = [0.0, 1.0, 0.5]
    close(system.times, [0.0, 1.0])


# ode_solver


def test_ode_solver_is_refused_when_set():
    system = System(zoo.timed().kane)
    with pytest.raises(ValueError, match="ode_solver"):
        system.ode_solver = [odeint]
    assert system.ode_solver is odeint


def test_constants_of_each_sample_count_however_often_nodes_are_evaluated():
    model = multi_mass_spring_damper().model
    x, p = np.array([[1.0, 2.0], [1.0, 2.0]]), np.array([[1.0, 2.0, 3.0], [1.0, 5.0, 7.0]])

    def products(assembly):  # without a guard: that is always interpreted
        graph = assembly.graph
        return {"products": [graph.mul(graph.input("x", 1), graph.input("p", 2))]}

    for _ in range(70):  # worth compiling in between
        found = model.interpreted(products, (np.zeros(2), x, np.zeros((1, 0)), p))
        np.testing.assert_array_equal(found["products"], [[6.0], [14.0]])


# what symbols are assumed to be


def pulled_by(force):
    """A particle of mass 1 on a line."""
    q, u = me.dynamicsymbols("q u")
    frame, origin = zoo.inertial_frame()
    point = origin.locatenew("P", q * frame.x)
    point.set_vel(frame, u * frame.x)
    bodies, loads = [me.Particle("P", point, 1)], [(point, force * frame.x)]
    return System(Definition(frame, [q], [u], bodies=bodies, loads=loads))


@pytest.mark.parametrize(
    ("assumption", "value", "words"),
    [
        ({"positive": True}, -4.0, "cannot be negative"),
        ({"negative": True}, 4.0, "cannot be positive"),
        ({"integer": True}, 1.5, "is an integer"),
    ],
)
def test_a_constant_that_is_not_what_its_symbol_is_assumed_to_be_is_told(assumption, value, words):
    k, q = sm.Symbol("k", **assumption), me.dynamicsymbols("q")
    system = pulled_by(-sm.sqrt(k**2) * q)
    with pytest.warns(
        PyDyUserWarning, match=f"`k` is {value:g}, .* one that {words}.* Make the sy"
    ):
        system.constants = {k: value}


def test_what_agrees_with_assumptions_and_gravity_that_is_turned_off_are_not_told():
    k, g = sm.Symbol("k", integer=True), sm.Symbol("g", positive=True)
    system = pulled_by(-k * me.dynamicsymbols("q") - g)
    system.constants = {k: 3.0, g: 0.0}
    assert np.isfinite(system.evaluate_ode(x=[1.0, 0.0])).all()
