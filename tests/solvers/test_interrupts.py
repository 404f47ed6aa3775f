"""Long work: the bar, Ctrl-C, and slices that leave no trace."""

import signal
import sys
import threading
import time

import numpy as np
import pytest

from oracles import solver_problems as problems
from pydy._errors import IntegrationError, IntegrationInterrupted, MissingDependencyError
from pydy._interrupts import Interrupts
from pydy.solvers import dop853, tsit5
from pydy.solvers.run import integration
from registry import SOLVERS, has_fixed_step, step_options

HUGE = 1e9  # seconds of simulated time that nobody waits for
MAX_STEP = {"max_step": 0.25}
PATIENCE = 60.0  # seconds on a busy machine, where 0.1 are meant; without Ctrl-C it takes hours


def options_of(solver):
    return step_options(solver, 1e-10, 1e-2)


class CtrlC:
    """Ctrl-C from another thread, once `ring` is called in this one."""

    def __init__(self):
        self.sent, self._due, self._wanted = None, threading.Event(), True
        self._thread = threading.Thread(target=self._send)

    def ring(self):
        self._due.set()

    def _send(self):
        self._due.wait()
        if self._wanted:
            self.sent = time.perf_counter()
            signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._wanted = self._due.is_set()
        self._due.set()
        self._thread.join()


@pytest.fixture(autouse=True)
def pythons_own_handler():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    signal.signal(signal.SIGINT, before)


def interrupted(run):
    """Have a run interrupted when it calls what it is given."""
    with CtrlC() as ctrl_c, pytest.raises(IntegrationInterrupted) as caught:
        run(ctrl_c.ring)
    assert time.perf_counter() - ctrl_c.sent < PATIENCE
    return caught.value


@pytest.mark.parametrize("solver", SOLVERS)
def test_ctrl_c_ends_compiled_work_with_what_was_computed(solver, monkeypatch):
    problem = problems.rigid_body()
    times = np.array([0.0, 5.0, 20.0, HUGE])
    options = options_of(solver)
    one_slice = integration.Integration._slice

    def run(ring):
        def ringing(self, budget):
            code = one_slice(self, budget)
            if self.progress.state[integration.at.TIME] > 20.0:
                ring()  # it arrives in one of the next slices
            return code

        monkeypatch.setattr(integration.Integration, "_slice", ringing)
        solver(problem.f, problem.x0, times, problem.args, max_steps=10**9, **options)

    error = interrupted(run)
    assert isinstance(error, KeyboardInterrupt)
    assert not isinstance(error, Exception)
    assert not isinstance(error, RuntimeError | IntegrationError)
    assert f"`{solver.name}` was interrupted at t = {error.time!r}" in str(error)
    np.testing.assert_array_equal(error.times, times[:3])
    np.testing.assert_allclose(error.states, problem.f.exact(times[:3]), atol=1e-6)
    assert 20.0 < error.time < HUGE
    assert error.info["steps"] > 100


@pytest.mark.parametrize("solver", SOLVERS)
def test_where_memory_ends_the_error_holds_what_was_computed(solver):
    times = np.array([0.0, 0.5, 1.0, 2.0])

    def f(x, t):
        if t > 1.5:
            raise MemoryError("no more")
        return [x[1], -x[0]]

    with pytest.raises(MemoryError, match="no more") as caught:
        solver(
            f,
            [1.0, 0.0],
            times,
            **options_of(solver),
            **({} if has_fixed_step(solver) else MAX_STEP),
        )
    np.testing.assert_array_equal(caught.value.times, times[:3])
    exact = np.array([np.cos(times[:3]), -np.sin(times[:3])]).T
    np.testing.assert_allclose(caught.value.states, exact, atol=1e-7)
    assert caught.value.__notes__ == [
        "What was computed until then is in the attributes of this error: times, states."
    ]


def test_ctrl_c_ends_work_in_a_python_function():
    times = np.array([0.0, 1.0, HUGE])

    def run(ring):
        def f(x, t):
            if t > 1.1:
                ring()
            return [x[1], -x[0]]

        dop853(f, [1.0, 0.0], times, max_steps=10**6)

    np.testing.assert_array_equal(interrupted(run).times, times[:2])


def test_ctrl_c_is_never_lost_on_the_way_into_a_python_function():
    # Where Python looks for signals is by chance; without care, one in ten is printed and ignored.
    for k in range(12):
        calls = iter(range(10**9))

        def run(ring, number=500 + k, calls=calls):
            def f(x, t):
                if next(calls) == number:
                    ring()
                return -x

            tsit5(f, [1.0], [0.0, HUGE], max_steps=10**6)

        interrupted(run)


@pytest.mark.parametrize("solver", SOLVERS)
def test_ctrl_c_is_heard_at_the_next_call_and_after_the_last(solver):
    calls, due = [], None

    def f(x, t):
        calls.append(t)
        if len(calls) == due:
            signal.raise_signal(signal.SIGINT)
        return -x

    run = solver.prepare(f, [1.0], [0.0, 0.1], **({"step": 0.05} if has_fixed_step(solver) else {}))
    expected = run([1.0])
    for due in range(1, len(calls) + 1):
        calls.clear()
        with pytest.raises(IntegrationInterrupted):
            run([1.0])
        assert len(calls) == due
    np.testing.assert_array_equal(run([1.0]), expected)


def test_ctrl_c_is_heard_though_the_run_fails():
    def f(x, t):
        signal.raise_signal(signal.SIGINT)
        raise ZeroDivisionError

    with pytest.raises(IntegrationInterrupted):
        dop853(f, [1.0], [0.0, 1.0])


def test_a_second_ctrl_c_ends_a_function_that_hangs(monkeypatch):
    note = Interrupts._note
    with CtrlC() as first, CtrlC() as second:

        def noted(self, *rest):
            note(self, *rest)
            second.ring()

        def f(x, t):
            first.ring()
            while True:  # a signal on the way into one long sleep would wait for its end
                time.sleep(0.01)

        monkeypatch.setattr(Interrupts, "_note", noted)
        with pytest.raises(IntegrationInterrupted):
            dop853(f, [1.0], [0.0, 1.0])


def test_a_handler_of_the_users_own_is_left_alone():
    heard = []
    signal.signal(signal.SIGINT, lambda *_: heard.append(1))

    def f(x, t):
        if not heard:
            signal.raise_signal(signal.SIGINT)
        return -x

    try:
        x = dop853(f, [1.0], [0.0, 1.0])
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    assert heard == [1]
    np.testing.assert_allclose(x[1], np.exp(-1.0), atol=1e-6)


def test_other_threads_integrate_too():
    problem, found = problems.rigid_body(), []

    def work():
        found.append(dop853(problem.f, problem.x0, [0.0, problem.end], problem.args)[-1])

    threads = [threading.Thread(target=work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 3
    np.testing.assert_array_equal(found[0], found[2])
    np.testing.assert_allclose(found[0], problem.final, atol=1e-5)


def test_a_keyboard_interrupt_of_the_function_itself_counts_as_one():
    def f(x, t):
        if t > 0.5:
            raise KeyboardInterrupt
        return -x

    with pytest.raises(IntegrationInterrupted) as caught:
        dop853(f, [1.0], [0.0, 0.25, 1.0], max_step=0.1)
    np.testing.assert_array_equal(caught.value.times, [0.0, 0.25])


# -- slices ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("budget", [1, 2, 7])
def test_the_bits_do_not_depend_on_how_the_work_is_sliced(solver, budget, monkeypatch):
    problem = problems.arenstorf()
    times = np.linspace(0.0, 5.0, num=33)

    def run():
        options = options_of(solver)
        return solver(problem.f, problem.x0, times, problem.args, full_output=True, **options)

    whole, info = run()
    monkeypatch.setattr(integration, "first_budget", lambda *_: budget)
    monkeypatch.setattr(integration, "SLICE", 1e-12)  # one step at a time after that
    sliced, other = run()
    np.testing.assert_array_equal(sliced, whole)
    assert other == info


# -- the bar --------------------------------------------------------------------------------------


class Bar:
    """What tqdm does, seen from a solver."""

    made = None

    def __init__(self, total, desc, bar_format):
        self.total, self.desc, self.n, self.moves, self.closed = total, desc, 0.0, [], False
        Bar.made = self

    def update(self, by):
        assert by >= 0.0
        self.n += by
        self.moves.append(by)

    def close(self):
        self.closed = True


@pytest.mark.parametrize("solver", SOLVERS)
def test_the_bar_goes_through_simulated_time(solver, monkeypatch):
    monkeypatch.setattr("tqdm.auto.tqdm", Bar)
    monkeypatch.setattr(integration, "first_budget", lambda *_: 10)
    problem = problems.rigid_body()
    solver(problem.f, problem.x0, [3.0, 23.0], problem.args, progress=True, **options_of(solver))
    assert Bar.made.total == 20.0
    assert Bar.made.desc == solver.name
    assert abs(Bar.made.n - 20.0) < 1e-9
    assert len(Bar.made.moves) >= 2
    assert Bar.made.closed


def test_the_bar_is_closed_after_a_failure(monkeypatch):
    monkeypatch.setattr("tqdm.auto.tqdm", Bar)
    with pytest.raises(IntegrationError):
        dop853(lambda x, t: x**2, [1.0], [0.0, 2.0], progress=True)
    assert Bar.made.closed
    assert abs(Bar.made.n - 1.0) < 1e-3


def test_tqdm_shows_the_bar(capsys):
    pytest.importorskip("tqdm")
    dop853(lambda x, t: -x, [1.0], [0.0, 2.0], progress=True)
    shown = capsys.readouterr().err
    assert "dop853: 100%" in shown
    assert "2/2 s" in shown


def test_without_tqdm_the_bar_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.raises(MissingDependencyError, match="pip install tqdm, or pass progress=False"):
        dop853(lambda x, t: -x, [1.0], [0.0, 2.0], progress=True)


def test_without_a_terminal_there_is_no_bar(monkeypatch):
    pytest.importorskip("tqdm")
    monkeypatch.setattr("sys.stderr", None)
    states = dop853(lambda x, t: -x, [1.0], [0.0, 2.0], progress=True)
    assert abs(states[-1, 0] - np.exp(-2.0)) < 1e-6
