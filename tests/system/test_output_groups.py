"""Output groups that are solved, their auxiliary states, and the generated function."""

import inspect

import numpy as np
import pytest
import sympy as sm

import zoo
from oracles.oracle import oracle
from zoo.cases import Recorder, close, system_of

A, B, K = sm.symbols("a b K")
T = zoo.T
GENERATORS = ["llvm", "lambdify"]


def chain_system(outputs, **options):
    return system_of(zoo.chain(), outputs=outputs, **options)


def states():
    return zoo.chain().states


def derivative(i=0):
    return zoo.chain().kane.u[i].diff(T)


# groups with their own names


@pytest.mark.parametrize("generator", GENERATORS)
def test_a_group_with_its_own_names_alone_is_solved_without_auxiliaries(generator):
    x0, x1 = states()[:2]
    system = chain_system({(A, B): (A - 2 * B + x0, x0 * A + B - 3 * x1)})
    system.generate_ode_function(generator=generator)
    x, t = zoo.chain().sample()
    expected = np.linalg.solve([[1, -2], [x[0], 1]], [-x[0], 3 * x[1]])
    close(system.evaluate_outputs(x, t), expected)
    assert system.auxiliaries == []
    assert system.num_states == 6


@pytest.mark.parametrize("generator", GENERATORS)
def test_an_acceleration_can_be_named(generator):
    model = zoo.chain()
    x, t = model.sample()
    system = chain_system({A: A - derivative()})
    system.generate_ode_function(generator=generator)
    close(system.evaluate_outputs([*x, 0.0], t), [oracle(model).xdot(x, t)[3]])


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", ["chain", "pendulum", "added_mass", "disc", "fourbar", "track"])
def test_a_group_with_names_and_accelerations_is_solved_with_them(name, generator):
    model = zoo.MODELS[name]()
    q, u = model.kane.q, model.kane.u
    c = sm.Symbol("extra")
    group = (
        A - 4 * B + c * u[0].diff(T) + 2 + q[0] * A,
        A + 3 * B - sm.cos(q[0]) * u[1].diff(T) + u[0] ** 2,
    )
    system = system_of(model, outputs={(A, B): group})
    system.constants[c] = 1.7
    system.generate_ode_function(generator=generator)
    x, t = model.sample()
    wide = [*x, 0.4, 0.5]
    plain = [e.xreplace({c: sm.Float("1.7")}) for e in group]
    expected = oracle(model).solve([A, B], plain, x, t)
    close(system.evaluate_outputs(wide, t)[:2], expected)
    close(system.evaluate_ode(wide, t), [*oracle(model).xdot(x, t), *expected])


def test_auxiliary_states_are_named_as_integrals():
    system = chain_system({(A, B): (A - derivative(), B - derivative(1) - A)})
    integrals = [sm.Symbol("∫ a dt"), sm.Symbol("∫ b dt")]
    assert system.auxiliaries == integrals
    assert system.states == [*states(), *integrals]
    assert system.num_auxiliaries == 2
    assert system.num_states == 8
    assert system.num_outputs == 2


def test_one_derivative_in_a_group_makes_all_its_names_auxiliaries():
    system = chain_system({(A, B): (A - derivative(), B - 3 * states()[0]), K: states()[0]})
    assert system.auxiliaries == [sm.Symbol("∫ a dt"), sm.Symbol("∫ b dt")]


def test_an_auxiliary_is_the_integral_of_its_output():
    times = np.linspace(0.0, 1.0, 6)
    system = chain_system({A: A - derivative()}, times=times)
    x = system.integrate(rtol=1e-11, atol=1e-11)
    assert x.shape == (6, 7)
    close(x[:, 6], x[:, 3] - x[0, 3], 1e-8)


def test_an_auxiliary_starts_at_its_initial_condition():
    integral = sm.Symbol("∫ a dt")
    system = chain_system({A: A - derivative()}, times=[0.0, 0.5])
    system.initial_conditions = {integral: 2.0}
    x = system.integrate(rtol=1e-11, atol=1e-11)
    close(x[:, 6], 2.0 + x[:, 3], 1e-8)


def test_auxiliaries_do_not_change_the_motion():
    times = np.linspace(0.0, 1.0, 6)
    plain = system_of(zoo.pendulum(), times=times)
    system = system_of(zoo.pendulum(), times=times, outputs={A: A - plain.speeds[0].diff(T)})
    options = {"rtol": 1e-11, "atol": 1e-11}
    close(system.integrate(**options)[:, :-1], plain.integrate(**options), 1e-8)


def test_outputs_taken_away_take_their_states_along():
    system = chain_system({A: A - derivative()}, times=[0.0, 0.5])
    assert system.integrate().shape == (2, 7)
    system.outputs = {}
    assert system.auxiliaries == []
    assert system.integrate().shape == (2, 6)


@pytest.mark.parametrize("equation", [lambda: A**2 - derivative(), lambda: sm.sin(A) - 1])
def test_a_group_nonlinear_in_its_names_is_refused(equation):
    with pytest.raises((ValueError, NotImplementedError), match=r"linear"):
        chain_system({A: equation()}).evaluate_outputs()


# the generated function


@pytest.mark.parametrize("generator", GENERATORS)
def test_without_outputs_the_generated_function_returns_the_derivatives(generator):
    model = zoo.timed()
    x, t = model.sample()
    rhs = system_of(model).generate_ode_function(generator=generator)
    p = [model.constants[s] for s in sm.ordered(model.constants)]
    got = rhs(x, t, p)
    assert isinstance(got, np.ndarray)
    close(got, oracle(model).xdot(x, t))


@pytest.mark.parametrize("generator", GENERATORS)
def test_with_ordinary_outputs_it_returns_both(generator):
    model = zoo.track()
    x, t = model.sample()
    q = model.states[0]
    system = system_of(model, outputs={A: q, B: B - model.kane.u[0].diff(T)})
    rhs = system.generate_ode_function(generator=generator)
    xdot, y = rhs(np.append(x, 0.3), t, dict(model.constants))
    rates = oracle(model).xdot(x, t)
    close(xdot, [*rates, rates[3]])
    close(y, [x[0], *system.evaluate_constraints(np.append(x, 0.3), t)])


@pytest.mark.parametrize("generator", GENERATORS)
def test_with_auxiliary_outputs_alone_it_returns_the_derivatives(generator):
    model = zoo.timed()
    x, t = model.sample()
    system = system_of(model, outputs={A: A - model.kane.u[0].diff(T)})
    got = system.generate_ode_function(generator=generator)(np.append(x, 0.3), t, model.constants)
    assert isinstance(got, np.ndarray)
    assert got.shape == (3,)


@pytest.mark.parametrize("generator", GENERATORS)
def test_both_arrays_are_fresh_at_every_call(generator):
    model = zoo.track()
    xs, ts = model.sample(0, 2)
    rhs = system_of(model).generate_ode_function(generator=generator)
    first = rhs(xs[0], ts[0], model.constants)
    kept = [a.copy() for a in first]
    second = rhs(xs[1], ts[1], model.constants)
    for old, copy, new in zip(first, kept, second, strict=True):
        assert old is not new
        assert not np.shares_memory(old, new)
        np.testing.assert_array_equal(old, copy)
        assert np.any(old != new)


def test_the_docstring_lists_the_ordinary_outputs():
    model = zoo.track()
    system = system_of(model, outputs={A: model.states[0], B: B - model.kane.u[0].diff(T)})
    text = inspect.getdoc(system.generate_ode_function())
    assert "y : ndarray, shape(3,)" in text
    assert [line.strip() for line in text.splitlines()[-3:]] == ["- y0(t)", "- y1(t)", "- y2(t)"]
    assert "- ∫ b dt" in text


def test_a_solver_receives_the_derivatives_alone():
    model = zoo.track()
    recorder = Recorder()
    system = system_of(model, outputs={A: model.states[0]}, ode_solver=recorder, times=[0.0, 0.1])
    system.integrate()
    got = recorder.f(model.x0, 0.0, *recorder.args)
    assert isinstance(got, np.ndarray)
    close(got, oracle(model).xdot(model.x0))
