"""A process that forks while its other threads compile: the children can compile."""

from __future__ import annotations

import gc
import os
import signal
import subprocess
import sys
import threading
import time
import warnings

import pytest
import sympy as sm
from llvmlite import binding

from oracles import optima
from pydy import _forks
from pydy._collector import collector_paused
from pydy.control import OptimalControl, ipopt
from pydy.errors import OptimizationError

if not hasattr(os, "fork"):
    pytest.skip("there is no fork", allow_module_level=True)


PATIENCE = 120.0  # seconds on a busy machine, where milliseconds are meant


def in_a_child(function, seconds=PATIENCE):
    """Return whether a function is true in a forked child, or None if it does not come back."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # Python 3.12: there are threads
        child = os.fork()
    if child == 0:
        try:
            os._exit(0 if function() else 1)
        except BaseException:  # noqa: BLE001 - nothing of pytest must run in the child
            os._exit(2)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status) == 0
        time.sleep(0.01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return None


class Holding:
    """Another thread that is within something, for so long or until the body has ended."""

    def __init__(self, thing, seconds=PATIENCE):
        begun, self._end = threading.Event(), threading.Event()

        def work():
            with thing:
                begun.set()
                self._end.wait(seconds)

        self._thread = threading.Thread(target=work)
        self._thread.start()
        assert begun.wait(PATIENCE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._end.set()
        self._thread.join()


def takes(lock):
    with lock:
        return True


def test_a_child_finds_a_lock_open_that_another_thread_holds():
    lock = _forks.Lock()
    with Holding(lock):
        assert in_a_child(lambda: takes(lock))
    assert takes(lock)


@pytest.mark.parametrize("name", ["llvmlite", "fork_lock"])
def test_a_fork_waits_for_what_is_not_sound_in_between(name):
    lock = {"llvmlite": binding.ffi.lib._lock, "fork_lock": _forks.fork_lock}[name]
    with Holding(lock, seconds=0.3):
        assert in_a_child(lambda: takes(lock))
    assert takes(lock)


def test_a_property_that_another_thread_computes_is_computed_in_the_child():
    begun, end = threading.Event(), threading.Event()

    class Slow:
        @_forks.cached_property
        def value(self):
            begun.set()
            end.wait(PATIENCE)
            return 3

    slow = Slow()
    thread = threading.Thread(target=lambda: slow.value)
    thread.start()
    assert begun.wait(PATIENCE)

    def computes():
        end.set()
        return slow.value == 3 and "value" in vars(slow)

    assert in_a_child(computes)
    end.set()
    thread.join()
    assert slow.value == 3


def test_a_child_collects_garbage_though_another_thread_had_turned_it_off():
    assert gc.isenabled()
    with Holding(collector_paused()):
        assert not gc.isenabled()
        assert in_a_child(gc.isenabled)


def test_a_child_leaves_collection_off_where_its_own_thread_has_turned_it_off():
    with collector_paused():
        assert in_a_child(lambda: not gc.isenabled())
    assert gc.isenabled()


LOOP = """
import os, signal, sys, threading, time, warnings
warnings.simplefilter("ignore")
import numpy as np
from pydy._backends.llvm import jit
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart

large = [n_link_pendulum_on_cart(n) for n in (3, 4, 5)]
small = [multi_mass_spring_damper(n) for n in (1, 2, 3)]
enough = threading.Event()

def compute(system):
    system.generate_ode_function()
    x = np.linspace(0.1, 1.0, len(system.states))
    rates, jacobian = system.evaluate_ode(x), system.evaluate_jacobian(x)
    assert all(kernel.addresses[0] for kernel in system.model._kernels.values())
    return np.isfinite(rates).all() and np.isfinite(jacobian).all()

def work():
    k = 0
    while not enough.is_set():
        jit.memory.clear()
        compute(large[k % 3])
        k += 1

thread = threading.Thread(target=work)
thread.start()
time.sleep(0.3)
ends = []
for k in range(6):
    child = os.fork()
    if child == 0:
        signal.alarm(120)  # kills it where it hangs
        try:
            os._exit(0 if compute(small[k % 3]) else 1)
        except BaseException:
            os._exit(2)
    ends.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    time.sleep(0.013 * (k % 5))
enough.set()
thread.join()
print(ends)
"""


def test_children_that_are_forked_while_a_thread_compiles_compile_and_evaluate():
    done = subprocess.run(
        [sys.executable, "-c", LOOP],
        env={**os.environ, "PYDY_CACHE_DIR": "off"},
        capture_output=True,
        text=True,
        check=True,
        timeout=1800,
    )
    assert done.stdout.strip() == str([0] * 6), done.stderr


def test_threads_that_come_first_at_once_get_the_same():
    """`functools.cache` gives each its own: code whose address one has was gone with the other."""
    everybody = threading.Barrier(4)
    made = []

    @_forks.once
    def thing(name):
        time.sleep(0.05)
        made.append(name)
        return object()

    found = []

    def come():
        everybody.wait()
        found.append((thing("a"), thing("b")))

    threads = [threading.Thread(target=come) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(found)) == 1
    assert sorted(made) == ["a", "b"]


def test_a_search_is_refused_in_a_child_that_is_forked_beside_another_one():
    pytest.importorskip("casadi")
    system, (x, v, force) = optima.double_integrator()
    problem = OptimalControl(
        system, sm.Integral(force**2, optima.T), 1.0, end={x: 1.0, v: 0.0}, mesh=4
    )

    def solves():
        return abs(problem.solve().objective - 12.0) < 1e-6

    def refused():
        with pytest.raises(
            OptimizationError, match=r"forked while a thread .* Fork before the sea"
        ):
            problem.solve()
        return True

    assert solves()
    with Holding(ipopt.solving()):
        assert solves()  # beside it, in the same process
        assert in_a_child(refused)
    assert in_a_child(solves)
