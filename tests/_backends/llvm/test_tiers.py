"""Code that is compiled quickly first and at LLVM's best on the side."""

from __future__ import annotations

import ctypes
import gc
import pickle
import threading
import weakref

import numpy as np
import pytest

import zoo
from graphs import on_tape
from pydy._backends.llvm import background, jit
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.llvm.tiers import _repeats, tiers_of
from pydy._backends.tuning import LARGE
from pydy._graph.interpret import run
from pydy._graph.node import Graph
from pydy.models import multi_mass_spring_damper
from pydy.system import System


@pytest.fixture
def nothing_cached(monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    jit.memory.clear()


def rates_kernel(name):
    system = System(zoo.MODELS[name]().kane)
    system.generate_ode_function()
    return system.model.compiled("rates")


def sample(kernel, m=50):
    rng = np.random.default_rng(3)
    program = kernel.program
    return (
        rng.uniform(0.0, 1.0, m),
        rng.uniform(-1.0, 1.0, (m, program.num_states)),
        rng.uniform(-1.0, 1.0, (m, program.num_specifieds)),
        rng.uniform(0.5, 1.5, program.num_constants),
    )


@pytest.mark.parametrize("name", sorted(zoo.MODELS))
def test_quick_and_best_code_compute_the_same_bits(name, nothing_cached):
    kernel = rates_kernel(name)
    arguments = sample(kernel)
    quick = kernel.evaluate(*arguments)[0]
    before = kernel.cell.copy()
    kernel.settle()
    assert (kernel.cell != before).all(), "the best code did not take the quick code's place"
    np.testing.assert_array_equal(kernel.evaluate(*arguments)[0], quick)


def test_the_gate_uses_the_better_code_with_the_constants_that_are_bound(nothing_cached):
    kernel = rates_kernel("pendulum")
    t, x, r, p = sample(kernel, 1)
    out, again = np.empty(len(kernel.program.outputs)), np.empty(len(kernel.program.outputs))
    assert kernel.call(x[0], float(t[0]), r[0], p, out) == 0
    kernel.settle()
    assert kernel.call(x[0], float(t[0]), r[0], p, again) == 0
    np.testing.assert_array_equal(again, out)


def test_who_wants_the_best_code_compiles_nothing_else(nothing_cached, monkeypatch):
    quick = []
    load = jit.load_quickly
    monkeypatch.setattr(jit, "load_quickly", lambda *a: quick.append(a[0].what) or load(*a))
    kernel, other = rates_kernel("pendulum"), rates_kernel("pendulum")
    kernel.settle()
    assert kernel.entry.better is None
    kernel.evaluate(*sample(kernel))
    assert not any(what.startswith("kernel") for what in quick)
    assert kernel.entry.better is None
    jit.memory.clear()
    assert not other.entry.cell.any()  # nothing at all before it is called
    other.evaluate(*sample(other))
    assert any(what.startswith("kernel") for what in quick)


def test_a_task_is_done_once_whoever_comes_first():
    done = []
    task = background.Task(lambda compile_source: done.append(threading.current_thread().name))
    threads = [threading.Thread(target=task.run) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(done) == 1


def test_where_no_thread_can_be_started_who_needs_a_task_does_it(monkeypatch):
    # A limit on threads, or an interpreter that ends, made the first evaluation fail.
    def refuse(thread):
        raise RuntimeError("can't start new thread")

    done = []
    task = background.Task(lambda compile_source: done.append(compile_source))
    with monkeypatch.context() as patch:
        patch.setattr(background, "_thread", None)
        patch.setattr(threading.Thread, "start", refuse)
        background.submit(task)
        assert background._thread is None  # so that a later task asks again
    assert not done
    task.run()
    assert len(done) == 1


def test_code_without_fallbacks_has_none_in_another_process():
    tiers = tiers_of(rates_kernel("disc").program)
    assert tiers.short is not None
    for source in (tiers.source, tiers.short):
        assert pickle.loads(pickle.dumps(source)).text(True) == source.text(True)


def test_an_unknown_symbol_does_not_reach_the_cache(nothing_cached):
    source = Source("nonsense", lambda brief: "this is no IR", ("f",))
    with pytest.raises(RuntimeError):
        jit.load(source)
    assert jit.find(source) is None


def test_code_keeps_alive_what_it_calls(nothing_cached):
    # The caches may hold a kernel longer than any system does that brought its routines along.
    twice = "define double @twice(double %x) {\n%y = fadd double %x, %x\nret double %y\n}"
    more = "%y = call double @twice(double %x)\n%z = fadd double %y, 1.0\nret double %z"
    more = f"declare double @twice(double)\ndefine double @more(double %x) {{\n{more}\n}}"
    routines = jit.load(Source("twice", lambda brief: twice, ("twice",)))
    caller = jit.load(Source("more", lambda brief: more, ("more",)), [routines])
    alive = weakref.ref(routines)
    jit.memory.clear()
    del routines
    gc.collect()
    assert alive() is not None
    assert ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(caller.addresses["more"])(3.0) == 7.0


def test_a_long_chain_of_masses_gives_the_same_bits_side_by_side(nothing_cached):
    n = 260
    graph = Graph()
    x, v = ([graph.input("x", g * n + i) for i in range(n)] for g in range(2))
    k, m = ([graph.input("p", g * n + i) for i in range(n)] for g in range(2))
    pulls = [graph.mul(k[i], graph.sub(x[i], x[i - 1]) if i else x[0]) for i in range(n)]
    forces = [
        graph.sub(pulls[i + 1], pulls[i]) if i + 1 < n else graph.neg(pulls[i]) for i in range(n)
    ]
    rates = [
        graph.div(graph.sub(f, graph.mul(c, w)), c) for f, c, w in zip(forces, m, v, strict=True)
    ]
    program = on_tape(graph, [*v, *rates], (2 * n, 0, 2 * n))
    assert _repeats(program)
    kernel = LLVMBackend().compile(program)
    arguments = sample(kernel, 9)
    quick = kernel.evaluate(*arguments)[0]
    kernel.settle()
    np.testing.assert_array_equal(kernel.evaluate(*arguments)[0], quick)
    np.testing.assert_allclose(quick, run(program, *arguments)[0], rtol=1e-9, atol=1e-9)


def test_a_pendulum_does_not_repeat_itself(nothing_cached):
    assert not _repeats(rates_kernel("pendulum").program)


def test_many_results_are_written_out_one_by_one():
    # LLVM's search for what repeats takes the square of their number.
    program = multi_mass_spring_damper(45).model.assembly.jacobian_program("rates", "x")
    assert program.operation_count["run"].total() > LARGE
    assert not _repeats(program)
