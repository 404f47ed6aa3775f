"""generate_ode_function of a System: its options, and when it is done again."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy._errors import PyDyUserWarning
from zoo.cases import Recorder, close, system_of

F = me.dynamicsymbols("F")
A = sm.Symbol("a")


def pendulum(**options):
    model = zoo.pendulum()
    start = dict(zip(model.states, [0.1, 0.5, -0.3, 0.2, 0.1, -0.4], strict=True))
    return system_of(model, initial_conditions=start, times=np.linspace(0.0, 1.0, 6), **options)


# generate_ode_function


def counting_solver():
    calls = []

    def solve(a, b):
        calls.append(1)
        return np.linalg.solve(a, b)

    return solve, calls


def test_the_users_options_are_kept_when_outputs_change():
    solve, calls = counting_solver()
    system = pendulum()
    system.generate_ode_function(generator="lambdify", linear_sys_solver=solve)
    system.outputs = {A: system.states[0]}
    before = len(calls)
    x = system.integrate()
    assert len(calls) > before
    close(system.evaluate_outputs(x)[:, 0], x[:, 0])


def test_the_users_options_are_kept_when_the_format_changes():
    solve, calls = counting_solver()
    system = pendulum()
    system.generate_ode_function(generator="lambdify", linear_sys_solver=solve)
    system.specifieds = {"symbols": list(system.specifieds_symbols), "values": np.zeros(3)}
    before = len(calls)
    system.integrate()
    assert len(calls) > before


def test_the_users_options_are_kept_when_forces_are_named():
    solve, calls = counting_solver()
    model = zoo.skate()
    system = system_of(model, noncontributing_forces=None, times=[0.0, 0.1])
    system.generate_ode_function(generator="lambdify", linear_sys_solver=solve)
    system.noncontributing_forces = model.forces
    before = len(calls)
    assert system.integrate().shape == (2, 6)
    assert len(calls) > before


def test_a_specifieds_keyword_is_ignored_with_a_warning():
    system = pendulum()
    with pytest.warns(PyDyUserWarning, match="specifieds"):
        system.generate_ode_function(specifieds=[F])
    model = zoo.pendulum()
    x, t = model.sample()
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t))


def test_an_unknown_generator_is_not_implemented():
    with pytest.raises(NotImplementedError, match="fortran77"):
        pendulum().generate_ode_function(generator="fortran77")
    with pytest.raises(NotImplementedError, match=r"is 'LLVM', which .*Did you mean `llvm`\?"):
        pendulum().generate_ode_function(generator="LLVM")


def test_a_failed_generation_leaves_the_system_usable():
    system = pendulum()
    with pytest.raises(NotImplementedError):
        system.generate_ode_function(generator="fortran77")
    assert system.integrate().shape == (6, 6)


def test_an_unknown_option_is_refused():
    with pytest.raises(TypeError, match="wrong_word"):
        pendulum().generate_ode_function(wrong_word=1)
    with pytest.raises(TypeError, match="`time_first` must be True or False, got 'no'"):
        pendulum().generate_ode_function(time_first="no")


def test_the_default_path_warns_of_nothing():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system = pendulum()
        x = system.integrate()
    assert np.all(np.isfinite(x))


def test_the_cython_generator_copies_for_a_custom_solver_only():
    model = zoo.timed()
    x, t = model.sample()
    strided = np.repeat(x, 2)[::2]
    recorder = Recorder()
    system = system_of(model, ode_solver=recorder, times=[0.0, 0.1])
    system.generate_ode_function(generator="cython")
    system.integrate()
    close(recorder.f(strided, t, *recorder.args), oracle(model).xdot(x, t))
    rhs = system.generate_ode_function(generator="cython", force_c_contiguous=False)
    close(rhs(x, t, model.constants), oracle(model).xdot(x, t))
    with pytest.raises(ValueError, match="contiguous"):
        rhs(strided, t, model.constants)
    system.ode_solver = Recorder()  # which changes nothing in what the user said
    with pytest.raises(ValueError, match="contiguous"):
        system.evaluate_ode_function(strided, t, model.constants)


def test_a_solver_set_after_the_generation_may_pass_any_layout():
    model = zoo.timed()
    x, t = model.sample()
    strided = np.repeat(x, 2)[::2]
    system = system_of(model, times=[0.0, 0.1])
    before = system.generate_ode_function(generator="cython")
    kernel = system.model.compiled("rates")
    with pytest.raises(ValueError, match="contiguous"):
        before(strided, t, model.constants)
    system.ode_solver = recorder = Recorder()
    system.integrate()
    close(recorder.f(strided, t, *recorder.args), oracle(model).xdot(x, t))
    close(system.evaluate_ode_function(strided, t, model.constants), oracle(model).xdot(x, t))
    assert system.model.compiled("rates") is kernel  # nothing was built again
