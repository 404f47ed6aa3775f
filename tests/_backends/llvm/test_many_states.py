"""Evaluations of many states: in lanes from some number on, with the same bits, without copies."""

import tracemalloc

import numpy as np
import pytest

from graphs import P, X, program_of
from pydy._backends.llvm import many_states
from pydy._backends.llvm.native import LLVMBackend, gates
from pydy.models import n_link_pendulum_on_cart


@pytest.fixture
def few(monkeypatch):
    monkeypatch.setattr(many_states, "READ_FROM", 100)
    monkeypatch.setattr(many_states, "COMPILED_FROM", 300)


@pytest.fixture
def sweeps(monkeypatch):
    """The native sweeps that are called, as their addresses."""
    gate, called = gates().sweep, []
    monkeypatch.setattr(gates(), "sweep", lambda *a: called.append(int(a[0][3])) or gate(*a))
    return called


def product(scale):
    """A Program that does much for its one result, other than those of other tests."""
    value = X[0] + scale
    for _ in range(20):
        value = value * X[1] + P[0] / value
    return program_of([value])


def arguments(program, m=100):
    x = np.random.default_rng(m).uniform(0.5, 0.9, (m, program.signature.num_states))
    return (
        np.zeros(m),
        x,
        np.zeros((1, program.signature.num_specifieds)),
        np.ones(program.signature.num_constants),
    )


def test_lanes_take_over_where_compiling_them_pays(few, sweeps, monkeypatch, tmp_path):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path))
    program = product(2.0)
    kernel, at = LLVMBackend().compile(program), arguments(program)
    results = [kernel.evaluate(*at)[0] for _ in range(5)]
    one, lanes = sweeps[0], sweeps[-1]
    assert sweeps == [one, one, lanes, lanes, lanes]
    for values in results:
        np.testing.assert_array_equal(values, results[0])
    # What is in a cache is used earlier; here it is that of another Kernel of the Program.
    sweeps.clear()
    again = LLVMBackend().compile(program)
    again.evaluate(*at)
    again.evaluate(*at)
    again.evaluate(*(a[:5] if len(a) > 1 else a for a in at[:3]), at[3])
    assert sweeps == [lanes, lanes, one]  # a few states are not worth it


def test_models_that_do_little_stay_with_the_code_for_one_state(few, sweeps):
    program = program_of([X[0] + P[0], X[1] * P[1]])
    kernel, at = LLVMBackend().compile(program), arguments(program)
    for _ in range(5):
        kernel.evaluate(*at)
    assert len(set(sweeps)) == 1


@pytest.mark.parametrize("order", ["C", "F"])
def test_a_call_allocates_its_results_and_a_mask_and_no_copy_of_the_states(order, few):
    system = n_link_pendulum_on_cart(2, cart_force=False)
    m, n = 20_000, len(system.states)
    x = np.asarray(np.random.default_rng(0).normal(0.3, 0.1, (m, n)), order=order)
    t = np.zeros(m)
    expected = system.evaluate_ode(np.ascontiguousarray(x), t)
    tracemalloc.start()
    try:
        found = system.evaluate_ode(x, t)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert found.flags.c_contiguous
    np.testing.assert_array_equal(found, expected)
    assert peak < found.nbytes + m + 20_000


def test_functions_of_the_state_have_rows_that_are_contiguous():
    system = n_link_pendulum_on_cart(1, cart_force=True)
    seen = []
    system.specifieds = {"F": lambda x, t: seen.append(x.flags.c_contiguous) or float(x.sum())}
    x = np.asfortranarray(np.random.default_rng(0).normal(0.3, 0.1, (20, len(system.states))))
    by_columns = system.evaluate_ode(x, np.zeros(20))
    assert all(seen)
    np.testing.assert_array_equal(by_columns, system.evaluate_ode(x.copy("C"), np.zeros(20)))
