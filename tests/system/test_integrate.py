"""integrate, the solvers it drives and the function it generates for them."""

from itertools import pairwise

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint, solve_ivp

import zoo
from oracles.oracle import oracle
from zoo.cases import Recorder, close, system_of

GENERATORS = ["llvm", "lambdify"]
F = me.dynamicsymbols("F")
A = sm.Symbol("a")


def pendulum(**options):
    model = zoo.pendulum()
    start = dict(zip(model.states, [0.1, 0.5, -0.3, 0.2, 0.1, -0.4], strict=True))
    return system_of(model, initial_conditions=start, times=np.linspace(0.0, 1.0, 6), **options)


def reference(system):
    """The trajectory from the oracle's right-hand side."""
    model = zoo.pendulum()
    x0 = [system.initial_conditions[s] for s in system.states]
    return odeint(oracle(model).xdot, x0, system.times, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("generator", GENERATORS)
def test_the_trajectory_is_that_of_sympys_equations(generator):
    system = pendulum()
    system.generate_ode_function(generator=generator)
    x = system.integrate(rtol=1e-9, atol=1e-9)
    assert x.shape == (6, 6)
    close(x, reference(system), 1e-6)


def test_integrate_generates_the_function_when_there_is_none():
    system = pendulum()
    assert system.evaluate_ode_function is None
    system.integrate()
    assert callable(system.evaluate_ode_function)


def test_times_need_not_begin_at_zero():
    model = zoo.timed()
    start = dict(zip(model.states, [0.3, 0.2], strict=True))
    system = system_of(model, initial_conditions=start, times=[1.5, 2.0])
    expected = odeint(oracle(model).xdot, [0.3, 0.2], [1.5, 2.0], rtol=1e-10, atol=1e-10)
    close(system.integrate(rtol=1e-10, atol=1e-10), expected, 1e-7)


def test_a_specified_function_drives_the_motion():
    model = zoo.pendulum()

    def push(x, t):
        return np.cos(5 * t) - x[0]

    system = pendulum(specifieds={F: push})
    x0 = [system.initial_conditions[s] for s in system.states]
    zeros = dict.fromkeys(model.specifieds, 0.0)

    def f(x, t):
        return oracle(model).xdot(x, t, zeros | {F: push(x, t)})

    expected = odeint(f, x0, system.times, rtol=1e-9, atol=1e-9)
    close(system.integrate(rtol=1e-9, atol=1e-9), expected, 1e-6)


def test_editing_in_place_between_integrations_counts():
    system = pendulum()
    system.integrate()
    system.constants[sm.Symbol("g")] = 3.3
    system.specifieds[F] = 2.2
    system.initial_conditions[system.states[0]] = 0.9
    fresh = pendulum(constants=dict(system.constants), specifieds=dict(system.specifieds))
    fresh.initial_conditions = dict(system.initial_conditions)
    close(system.integrate(), fresh.integrate(), 1e-13)


def test_extra_keywords_go_to_the_solver():
    recorder = Recorder()
    system = pendulum(ode_solver=recorder)
    system.integrate(rtol=1e-3, something="else")
    assert recorder.options == {"rtol": 1e-3, "something": "else"}


def test_what_the_solver_returns_is_returned():
    token = object()
    assert pendulum(ode_solver=lambda f, x0, t, args=(): token).integrate() is token


def test_a_wrong_keyword_is_the_solvers_own_error():
    with pytest.raises(TypeError, match="wrong_word"):
        pendulum().integrate(wrong_word=1)


def test_the_solver_receives_the_documented_arguments():
    recorder = Recorder()
    system = pendulum(ode_solver=recorder)
    system.integrate()
    close(recorder.x0, [system.initial_conditions[s] for s in system.states])
    close(recorder.times, system.times)
    assert isinstance(recorder.args, tuple)


def test_the_solver_receives_the_initial_state_with_auxiliaries():
    recorder = Recorder()
    u0 = zoo.pendulum().kane.u[0]
    system = pendulum(ode_solver=recorder, outputs={A: A - u0.diff(zoo.T)})
    system.integrate()
    assert np.shape(recorder.x0) == (7,)


def test_a_solver_may_have_no_keywords_but_args():
    def euler(f, x0, t, args=()):
        xs = [np.array(x0, dtype=float)]
        for a, b in pairwise(t):
            xs.append(xs[-1] + (b - a) * f(xs[-1], a, *args))
        return np.array(xs)

    system = pendulum(ode_solver=euler)
    x = system.integrate()
    model = zoo.pendulum()
    close(x[1], x[0] + 0.2 * oracle(model).xdot(x[0], 0.0))


LAYOUTS = {
    "float64": lambda x: x,
    "list": lambda x: [float(v) for v in x],
    "tuple": tuple,
    "strided": lambda x: np.repeat(x, 3)[::3],
    "reversed": lambda x: x[::-1].copy()[::-1],
    "fortran column": lambda x: np.asfortranarray(np.column_stack([x, x]))[:, 0],
    "row-major column": lambda x: np.column_stack([x, x])[:, 0],
    "read-only": lambda x: np.frombuffer(x.tobytes()),
    "longdouble": lambda x: x.astype(np.longdouble),
    "big-endian": lambda x: x.astype(">f8"),
    "misaligned": lambda x: np.frombuffer(b"\0" + x.tobytes(), dtype=np.uint8)[1:].view(float),
}


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", LAYOUTS)
def test_a_solver_may_pass_any_layout(name, generator):
    model = zoo.pendulum()
    recorder = Recorder()
    system = pendulum(ode_solver=recorder)
    system.generate_ode_function(generator=generator)
    system.integrate()
    x, t = model.sample()
    close(recorder.f(LAYOUTS[name](x), t, *recorder.args), oracle(model).xdot(x, t))


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.int64, np.int32, np.uint8, bool])
def test_a_solver_may_pass_any_real_type(dtype, generator):
    model = zoo.pendulum()
    recorder = Recorder()
    system = pendulum(ode_solver=recorder)
    system.generate_ode_function(generator=generator)
    system.integrate()
    x = np.array([1, 0, 1, 1, 0, 1], dtype=dtype)
    close(recorder.f(x, np.float32(0.5), *recorder.args), oracle(model).xdot(x.astype(float), 0.5))


def test_a_solver_that_passes_too_short_a_state_gets_a_value_error():
    recorder = Recorder()
    pendulum(ode_solver=recorder).integrate()
    with pytest.raises(ValueError, match=r"\(5,\).*6|6.*\(5,\)"):
        recorder.f(np.zeros(5), 0.0, *recorder.args)


def rk4(copy):
    """Classical Runge-Kutta that keeps its stages, of its own or as they come."""

    def solver(f, x0, ts, args=()):
        xs = [np.array(x0, dtype=float)]
        for t, later in pairwise(ts):
            h, x, stages = later - t, xs[-1], []
            for c in (0.0, 0.5, 0.5, 1.0):
                last = stages[-1] if stages else 0.0
                stage = f(x + c * h * last, t + c * h, *args)
                stages.append(stage.copy() if copy else stage)
            xs.append(x + h / 6 * (stages[0] + 2 * stages[1] + 2 * stages[2] + stages[3]))
        return np.array(xs)

    return solver


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("outputs", [False, True], ids=["", "outputs"])
def test_a_runge_kutta_that_keeps_its_stages_is_right(generator, outputs):
    squared = {A: zoo.pendulum().states[0] ** 2} if outputs else None
    system = pendulum(outputs=squared, ode_solver=rk4(copy=True))
    system.generate_ode_function(generator=generator)
    expected = system.integrate()
    system.ode_solver = rk4(copy=False)
    np.testing.assert_array_equal(system.integrate(), expected)
    close(expected, reference(system), 2e-2)


def ivp(f, x0, ts, args=(), **options):
    return solve_ivp(
        lambda t, x: f(x, t, *args), ts[[0, -1]], x0, t_eval=ts, rtol=1e-8, atol=1e-8, **options
    ).y.T


@pytest.mark.parametrize("method", ["RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA"])
def test_every_method_of_solve_ivp_gives_the_trajectory(method):
    system = pendulum(ode_solver=ivp)
    close(system.integrate(method=method), reference(system), 1e-4)
