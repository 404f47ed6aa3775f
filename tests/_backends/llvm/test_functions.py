"""Native functions: compiled when they are first called, fallbacks where a guard is not sound."""

from __future__ import annotations

import ctypes
import gc
import signal
import sys
import threading
import time
import weakref

import numpy as np
import pytest

import zoo
from graphs import on_tape
from pydy._assembly.programs import jacobian_program
from pydy._backends.llvm import functions, jit, sources
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.functions import CompleteCode
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.llvm.sources import _repeats, leaves_out_fallbacks
from pydy._backends.tuning import LARGE
from pydy._graph.columns import SensitivityColumns
from pydy._graph.node import Graph
from pydy._graph.tangent import jacobian_tangent
from pydy._program.interpret import run
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System


@pytest.fixture
def nothing_cached(monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    jit.memory.clear()
    functions._COMPLETE.clear()


@pytest.fixture
def complete_at_once(monkeypatch):
    """Return a function after which code has its fallbacks from the beginning."""

    def begin():
        jit.memory.clear()
        monkeypatch.setattr(functions, "leaves_out_fallbacks", lambda program: False)

    return begin


@pytest.fixture
def without_any_fallbacks(monkeypatch):
    """Leave out fallbacks however little of the code they are."""
    monkeypatch.setattr(sources, "MOST_WITHOUT_FALLBACKS", 2.0)


def rates_model(name):
    system = System(zoo.MODELS[name]().kane)
    system.generate_ode_function()
    return system.model


def rates_kernel(name):
    return rates_model(name).compiled("rates")


def in_two_parts(assembly):
    """Return the Jacobian of the rates by the states: whole vectors of columns, and a rest."""
    n = assembly.sizes[0]
    parts = [(0, n // 2), (n // 2, n)]
    graph, nodes = assembly.simplified("rates")
    return jacobian_tangent(graph, nodes, [("x", k) for k in range(n)], assembly.sizes, parts)


def with_sensitivities(assembly, count=3):
    """Return the rates and their derivatives along directions: of states and of constants."""
    n, _, c = assembly.sizes
    directions = tuple(("p", k // 2 % c) if k % 2 and c else None for k in range(count))
    graph, nodes = assembly.simplified("rates")
    return SensitivityColumns(n, directions).tangent(graph, nodes, assembly.sizes, "rates")


def sample(kernel, m=50):
    rng = np.random.default_rng(3)
    program = kernel.program
    return (
        rng.uniform(0.0, 1.0, m),
        rng.uniform(-1.0, 1.0, (m, program.signature.num_states)),
        rng.uniform(-1.0, 1.0, (m, program.signature.num_specifieds)),
        rng.uniform(0.5, 1.5, program.signature.num_constants),
    )


@pytest.mark.parametrize("name", sorted(zoo.MODELS))
def test_code_with_and_without_fallbacks_computes_the_same_bits(
    name, nothing_cached, complete_at_once
):
    kernel = rates_kernel(name)
    arguments = sample(kernel)
    first = kernel.evaluate(*arguments)[0]
    complete_at_once()
    np.testing.assert_array_equal(rates_kernel(name).evaluate(*arguments)[0], first)


@pytest.mark.parametrize("name", sorted(zoo.MODELS))
def test_derivatives_with_and_without_fallbacks_are_the_same_bits(
    name, nothing_cached, without_any_fallbacks, complete_at_once
):
    assembly = rates_model(name).assembly
    made = [in_two_parts(assembly), with_sensitivities(assembly)]
    backend = LLVMBackend()
    kernels = [backend.compile(tangent) for tangent in made]
    arguments = [sample(kernel, 9) for kernel in kernels]
    pairs = [*zip(kernels, arguments, strict=True)]
    first = [kernel.evaluate(*own)[0] for kernel, own in pairs]
    complete_at_once()
    for tangent, own, values in zip(made, arguments, first, strict=True):
        np.testing.assert_array_equal(backend.compile(tangent).evaluate(*own)[0], values)


def chain(mass=1.0):
    """Return a cart with five links, the third of this mass; a negative one makes guards fail."""
    system = n_link_pendulum_on_cart(5)
    system.constants = {c: mass if c.name == "m3" else 1.0 for c in system.constants_symbols}
    system.specifieds = dict.fromkeys(system.specifieds_symbols, 0.0)
    system.initial_conditions = dict(zip(system.states, np.linspace(0.1, 0.6, 12), strict=True))
    system.times, system.ode_solver = np.linspace(0.0, 0.2, 5), "vern9"
    return system


def test_a_guard_that_is_not_sound_brings_the_code_with_fallbacks(nothing_cached):
    system = chain()
    kernel = system.model.compiled("rates")
    assert leaves_out_fallbacks(kernel.program)
    x = np.linspace(0.1, 0.6, 12)
    first = system.evaluate_ode(x)
    without = kernel.addresses.copy()
    system.constants = chain(-1.2).constants
    rates = system.evaluate_ode(x)
    assert (kernel.addresses != without).all()
    p = np.array([system.constants[c] for c in system.constants_symbols])
    exact = run(kernel.program, np.zeros(1), x[None], np.zeros((1, 1)), p)[0][0]
    np.testing.assert_allclose(rates, exact, rtol=1e-12)
    system.constants = chain().constants
    np.testing.assert_array_equal(system.evaluate_ode(x), first)


@pytest.mark.parametrize("made_by", [in_two_parts, with_sensitivities])
def test_derivatives_bring_the_code_with_fallbacks_and_its_constants(
    made_by, nothing_cached, without_any_fallbacks
):
    system = chain()
    system.generate_ode_function()
    tangent = made_by(system.model.assembly)
    kernel = LLVMBackend().compile(tangent)
    t, x, r, p = sample(kernel, 3)
    x, one = x / 4 + 0.3, np.empty(kernel.program.signature.num_outputs)
    p[:] = [*system.constants.values()]
    first, failed = kernel.evaluate(t, x, r, p)
    assert not failed.any()
    assert kernel.at(x[0], t[0], r[0], p, one) == 0  # binds c without the fallbacks' constants
    without, complete = kernel.addresses.copy(), CompleteCode.shared(tangent)
    assert complete._code is None
    q = np.array([*chain(-1.2).constants.values()])
    weak, failed = kernel.evaluate(t, x, r, q)
    assert not failed.any()
    assert (kernel.addresses != without).all()
    exact = run(tangent.written_out(), t, x, r, q)[0]
    np.testing.assert_allclose(weak, exact, rtol=1e-9, atol=1e-9 * np.abs(exact).max())
    for constants, values in ((p, first), (q, weak), (p, first)):
        assert kernel.at(x[0], t[0], r[0], constants, one) == 0
        np.testing.assert_array_equal(one, values[0])
        np.testing.assert_array_equal(kernel.evaluate(t, x, r, constants)[0], values)


def test_an_implicit_run_goes_on_where_its_jacobian_needs_fallbacks(
    nothing_cached, without_any_fallbacks, complete_at_once
):
    # The third mass becomes negative with the constants; the run is bound before.
    systems = chain(), chain(-1.2)
    for system in systems:
        system.ode_solver = "radau"
    before, motion = (system.integrate() for system in systems)
    np.testing.assert_array_equal(systems[0].integrate(), before)
    complete_at_once()
    again = chain(), chain(-1.2)
    for system, values in zip(again, (before, motion), strict=True):
        system.ode_solver = "radau"
        np.testing.assert_array_equal(system.integrate(), values)


def test_a_prepared_run_and_a_gate_get_the_constants_that_fallbacks_need(
    nothing_cached, complete_at_once
):
    # Both were prepared by code that leaves these constants out.
    systems = chain(), chain(-1.2)
    before = systems[0].integrate()
    f = systems[0].generate_ode_function()
    x, p = np.linspace(0.1, 0.6, 12), np.array(list(systems[0].constants.values()))
    gate = f(x, 0.0, np.zeros(1), p).copy()
    motion = systems[1].integrate()
    assert CompleteCode.shared(systems[0].model.compiled("rates").program)._code is not None
    np.testing.assert_array_equal(systems[0].integrate(), before)
    np.testing.assert_array_equal(f(x, 0.0, np.zeros(1), p), gate)
    complete_at_once()
    np.testing.assert_array_equal(chain(-1.2).integrate(), motion)
    np.testing.assert_array_equal(chain().integrate(), before)


def test_threads_that_need_fallbacks_at_once_compile_them_once(nothing_cached, monkeypatch):
    compiled = []
    load = jit.load
    monkeypatch.setattr(jit, "load", lambda s, *a: compiled.append(s.identity) or load(s, *a))
    kernel = chain().model.compiled("rates")
    p = np.array([*chain(-1.2).constants.values()])
    found, ready = [], threading.Barrier(4)

    def work():
        x = np.tile(np.linspace(0.1, 0.6, 12), (50, 1))
        ready.wait()
        found.append(kernel.evaluate(np.zeros(50), x, np.zeros((1, 1)), p))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len([what for what in compiled if what.endswith(" 1 1")]) == 1
    assert not any(failed.any() for _, failed in found)
    for values, _ in found:
        np.testing.assert_array_equal(values, np.tile(found[0][0][0], (50, 1)))


def test_a_ctrl_c_while_fallbacks_are_compiled_is_not_lost(nothing_cached, monkeypatch):
    kernel = chain().model.compiled("rates")
    p = np.array([*chain(-1.2).constants.values()])
    assert kernel.call

    def interrupted(_self):
        raise KeyboardInterrupt

    monkeypatch.setattr(CompleteCode, "link", interrupted)

    def work():
        kernel.evaluate(np.zeros(1), np.linspace(0.1, 0.6, 12)[None], np.zeros((1, 1)), p)
        for _ in range(6000):  # `interrupt_main` does not end a sleep
            time.sleep(0.01)

    # A process in the background begins with interrupts that are ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
    finally:
        signal.signal(signal.SIGINT, before)


def test_where_fallbacks_cannot_be_compiled_no_state_is_right_and_it_is_reported(
    nothing_cached, monkeypatch
):
    # ctypes would have gone on with the status 0, and what lay in the results.
    kernel = chain().model.compiled("rates")
    p = np.array([*chain(-1.2).constants.values()])
    assert kernel.call

    def without_memory(_self):
        raise MemoryError("Compiling may need 80 MB")

    reported = []
    monkeypatch.setattr(CompleteCode, "link", without_memory)
    monkeypatch.setattr(sys, "unraisablehook", reported.append)
    x = np.linspace(0.1, 0.6, 12)[None]
    _, failed = kernel.evaluate(np.zeros(1), x, np.zeros((1, 1)), p)
    assert failed.all()
    assert [str(one.exc_value) for one in reported] == ["Compiling may need 80 MB"]


def test_nothing_is_compiled_before_the_first_call(nothing_cached):
    kernel = rates_kernel("pendulum")
    assert not kernel.functions.addresses.any()
    kernel.evaluate(*sample(kernel))
    assert kernel.functions.addresses.all()


def test_an_unknown_symbol_does_not_reach_the_cache(nothing_cached):
    source = Source("nonsense", lambda: "this is no IR", ("f",))
    with pytest.raises(RuntimeError):
        jit.load(source)
    assert jit.find(source) is None


def test_code_keeps_alive_what_it_calls(nothing_cached):
    # The caches may hold a kernel longer than any system does that brought its routines along.
    twice = "define double @twice(double %x) {\n%y = fadd double %x, %x\nret double %y\n}"
    more = "%y = call double @twice(double %x)\n%z = fadd double %y, 1.0\nret double %z"
    more = f"declare double @twice(double)\ndefine double @more(double %x) {{\n{more}\n}}"
    routines = jit.load(Source("twice", lambda: twice, ("twice",)))
    caller = jit.load(Source("more", lambda: more, ("more",)), [routines])
    alive = weakref.ref(routines)
    jit.memory.clear()
    del routines
    gc.collect()
    assert alive() is not None
    assert ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(caller.addresses["more"])(3.0) == 7.0


def test_a_long_chain_of_masses_is_computed_side_by_side(nothing_cached):
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
    np.testing.assert_allclose(
        kernel.evaluate(*arguments)[0], run(program, *arguments)[0], rtol=1e-9, atol=1e-9
    )


def test_a_pendulum_does_not_repeat_itself(nothing_cached):
    assert not _repeats(rates_kernel("pendulum").program)


def test_many_results_are_written_out_one_by_one():
    # LLVM's search for what repeats takes the square of their number.
    program = jacobian_program(multi_mass_spring_damper(45).model.assembly, "rates", "x")
    assert program.operation_count["run"].total() > LARGE
    assert not _repeats(program)
