"""What a Python function raises inside compiled code arrives: also on the way into the function."""

import signal
import sys
import time

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.solvers import Event, dop853, radau, rk4
from pydy.system import System
from registry import SOLVERS, has_fixed_step, step_options
from zoo.cases import system_of


class AlarmError(Exception):
    pass


def ring(*_):
    raise AlarmError


@pytest.fixture(autouse=True)
def alarm(uncollected):
    before = signal.signal(signal.SIGALRM, ring)
    with np.errstate():  # an alarm on the way out of one inside keeps what that has set
        yield
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    signal.signal(signal.SIGALRM, before)


def storm(run, number, seed=0):
    """Interrupt a run at random moments: it raises the alarm, or was right before it rang."""
    expected = run()
    rng, arrived, lasts = np.random.default_rng(seed), 0, np.inf
    while arrived < number:
        start = time.perf_counter()
        run()
        lasts = min(lasts, time.perf_counter() - start)  # other processes may have stopped this one
        try:
            signal.setitimer(signal.ITIMER_REAL, rng.uniform(0.02, 0.8) * lasts)
            found = run()
            left = signal.setitimer(signal.ITIMER_REAL, 0.0)[0]
        except AlarmError:
            arrived += 1
            continue
        assert left > 0.0, "the alarm rang, and was lost"
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("solver", [rk4, dop853, radau], ids=repr)
def test_what_a_run_frees_calls_no_python_where_an_alarm_would_be_lost(solver):
    options = {"step": 1e-2} if has_fixed_step(solver) else {}
    called = set()

    def note(frame, what, _):
        if what == "call" and "weakref" in frame.f_code.co_filename:
            called.add(frame.f_code.co_qualname)

    def run():
        solver(lambda x, t: [x[1], -x[0]], [1.0, 0.0], [0.0, 1.0], **options)

    run()
    sys.setprofile(note)
    try:
        run()
    finally:
        sys.setprofile(None)
    assert not called


@pytest.mark.parametrize("solver", SOLVERS, ids=repr)
def test_an_alarm_always_arrives_from_a_python_right_hand_side(solver):
    options = step_options(solver, 1e-9, 1e-2)
    times = np.linspace(0.0, 4.0, num=20)
    storm(lambda: solver(lambda x, t: [x[1], -x[0]], [1.0, 0.0], times, **options), 40)


@pytest.mark.parametrize("solver", [rk4, dop853, radau], ids=repr)
def test_an_alarm_always_arrives_from_a_python_specified_with_events(solver):
    q, v = me.dynamicsymbols("q v")
    force, m = me.dynamicsymbols("F"), sm.Symbol("m")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, v * frame.x)
    method = me.KanesMethod(frame, [q], [v], [q.diff() - v])
    method.kanes_equations([me.Particle("P", point, m)], [(point, force * frame.x)])
    system = System(method, constants={m: 1.0}, initial_conditions={q: 1.0})
    system.specifieds = {force: lambda x, t: -x[0] - x[0] ** 3}
    system.times = np.linspace(0.0, 1.0, num=20)
    system.ode_solver = solver
    options = step_options(solver, 1e-9, 2e-2)
    events = [Event(q), Event(q - 0.8, reset={v: 0.9 * v})]
    storm(lambda: system.integrate(events=events, **options), 40)


def test_an_alarm_always_arrives_from_a_linear_solver_under_projection_and_events():
    system = system_of(zoo.track(), times=np.linspace(0.0, 0.3, num=5), ode_solver=dop853)
    system.generate_ode_function(linear_sys_solver=np.linalg.solve)
    event = Event(system.speeds[0])
    storm(lambda: system.integrate(constraints="project", events=[event]), 40)


def test_an_alarm_always_arrives_from_the_way_back_of_an_adjoint():
    system = system_of(zoo.pendulum(), times=np.linspace(0.0, 0.1, num=3), ode_solver=dop853)
    system.generate_ode_function(generator="lambdify")
    (wanted, *_), (final, *_) = system.constants_symbols, system.states
    storm(lambda: system.adjoint_gradient([wanted], final=final).values, 20)
