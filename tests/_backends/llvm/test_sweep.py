"""Sweeps: every width, either order of memory, any number of samples, give the scalar results."""

import re
from pathlib import Path

import numpy as np
import pytest
import sympy as sm

from graphs import P, T, X, program_of, solve_program
from pydy._backends.llvm import native
from pydy._backends.llvm.native import LLVMBackend, gates
from pydy._program.program import Program, Tape

MODEL = program_of([X[0] * P[0] + T, X[1] - X[3], sm.sin(X[2]), X[0] / X[1], P[1] * X[3]])


def rows(count):
    rng = np.random.default_rng(count)
    return np.arange(float(count)), rng.uniform(0.5, 2.0, (count, 4)), np.array([2.0, 3.0, 5.0])


def expected(t, x, p):
    a, b, c, d = x.T
    return np.column_stack([a * p[0] + t, b - d, np.sin(c), a / b, p[1] * d])


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("lanes", [1, 2, 4, 8])
@pytest.mark.parametrize("count", [0, 1, 3, 8, 9, 15, 16, 100])
def test_any_number_of_samples_in_either_order(lanes, order, count):
    t, x, p = rows(count)
    out, failed = (
        LLVMBackend(lanes=lanes)
        .compile(MODEL)
        .evaluate(t, np.asarray(x, order=order), np.zeros((1, 0)), p)
    )
    np.testing.assert_allclose(out, expected(t, x, p), rtol=1e-15)
    assert failed.shape == (count,)
    assert not failed.any()


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("lanes", [1, 8])
def test_ctrl_c_comes_through_between_parts_which_give_the_same(lanes, order, monkeypatch):
    model, (t, x, p) = MODEL, rows(100)
    x, r = np.asarray(x, order=order), np.zeros((1, 0))
    whole, _ = LLVMBackend(lanes=lanes).compile(model).evaluate(t, x, r, p)
    monkeypatch.setattr("pydy._backends.llvm.native.SWEPT", 1)
    gate, calls = gates().sweep, []
    monkeypatch.setattr(gates(), "sweep", lambda *a: calls.append(1) or gate(*a))
    kernel = LLVMBackend(lanes=lanes).compile(model)
    parts, failed = kernel.evaluate(t, x, r, p)
    assert len(calls) >= 100 // lanes
    np.testing.assert_array_equal(parts, whole)
    assert parts.flags.f_contiguous == whole.flags.f_contiguous
    assert not failed.any()


LAYOUTS = {
    "rows": lambda x: x,
    "columns": np.asfortranarray,
    "every second row": lambda x: np.repeat(x, 2, axis=0)[::2],
    "part of rows": lambda x: np.hstack([x, x])[:, : x.shape[1]],
    "part of columns": lambda x: np.asfortranarray(np.vstack([x, x]))[: len(x)],
    "backwards": lambda x: x[::-1].copy()[::-1],
}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("near", [1, 1_000, 10**9])
@pytest.mark.parametrize("lanes", [1, 2, 4, 8])
def test_the_bits_depend_neither_on_layouts_nor_on_tiles(lanes, near, layout, monkeypatch):
    monkeypatch.setattr("pydy._backends.llvm.native.NEARBY", near)
    kernel, one = LLVMBackend(lanes=lanes).compile(MODEL), LLVMBackend().compile(MODEL)
    for count in (1, 7, 31, 32, 33, 77, 512):  # columns of 512 states share lines of the cache
        t, x, p = rows(count)
        r = np.zeros((1, 0))
        expected, _ = one.evaluate(t, x, r, p)
        orders = "CF" if lanes > 1 else "C"
        for out in [None, *(np.full(expected.shape, np.nan, order=order) for order in orders)]:
            values, failed, finite = kernel.sweep(t, LAYOUTS[layout](x), r, p, out)
            np.testing.assert_array_equal(values, expected)
            assert out is None or values is out
            assert finite is True
            assert not failed.any()


@pytest.mark.parametrize("layout", [*LAYOUTS][:-1])
def test_states_are_copied_nowhere_but_in_tiles(layout, monkeypatch):
    t, x, p = rows(1000)
    x, seen = LAYOUTS[layout](x), []
    monkeypatch.setattr("pydy._backends.llvm.native.SWEPT", 1000)
    gate = gates().sweep
    monkeypatch.setattr(gates(), "sweep", lambda *a: seen.append(a) or gate(*a))
    out, failed = LLVMBackend(lanes=8).compile(MODEL).evaluate(t, x, np.zeros((1, 0)), p)
    assert len(seen) > 4  # between which Python heeds a Ctrl-C
    for _, times, states, _, _, results, failures, _ in seen:
        assert np.shares_memory(times, t)
        assert np.shares_memory(states, x)
        assert np.shares_memory(results, out)
        assert np.shares_memory(failures, failed)


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("lanes", [1, 8])
@pytest.mark.parametrize("count", [5, 50])
@pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan])
def test_a_sweep_says_whether_all_results_are_finite(lanes, order, count, value):
    t, x, p = rows(count)
    kernel, r = LLVMBackend(lanes=lanes).compile(MODEL), np.zeros((1, 0))
    for k in (0, count // 2, count - 1):
        wrong = np.array(x, order=order)
        wrong[k, 3] = value
        assert kernel.sweep(t, wrong, r, p)[2] is False
    assert kernel.sweep(t, np.array(x, order=order), r, p)[2] is True


@pytest.mark.parametrize("specifieds", [0, 1, 2])
@pytest.mark.parametrize("lanes", [2, 4, 8])
def test_columns_are_read_where_they_lie_and_seen_to_be_finite_there(
    lanes, specifieds, monkeypatch
):
    # One column of specifieds is rows as well.
    tape = Tape()
    total = tape.mul(tape.make("input", "x", 0), tape.make("input", "p", 0))
    for k in range(specifieds):
        total = tape.add(total, tape.make("input", "r", k))
    results = [total, tape.make("sin", tape.make("input", "x", 1))]
    model = Program.from_tape(tape, (2, specifieds, 1), [("v", (2,), results)])
    seen, gate = [], gates().sweep

    def watched(*arguments):
        arguments[-1].fill(np.nan)
        seen.append((gate(*arguments), np.count_nonzero(~np.isnan(arguments[-1]))))
        return seen[-1][0]

    monkeypatch.setattr(gates(), "sweep", watched)
    x, r = np.ones((100, 2), order="F"), np.ones((100, specifieds), order="F")
    kernel = LLVMBackend(lanes=lanes).compile(model)
    out = np.empty((100, 2), order="F")
    kernel.evaluate(np.zeros(100), x, r, np.array([2.0]), out)
    np.testing.assert_allclose(out[:, 0], 2.0 + specifieds, rtol=1e-15)
    # Only the constants, and what is computed of them, are in the memory of the sweep.
    assert seen == [(1, lanes * (1 + kernel.size_of_c))]


@pytest.mark.parametrize("lanes", [1, 2, 4, 8])
def test_rows_that_are_not_contiguous_are_taken_as_they_are(lanes):
    t, x, p = rows(21)
    spaced = np.repeat(x, 2, axis=1)[:, ::2]
    out, _ = LLVMBackend(lanes=lanes).compile(MODEL).evaluate(t, spaced, np.zeros((1, 0)), p)
    np.testing.assert_allclose(out, expected(t, x, p), rtol=1e-15)


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("lanes", [1, 2, 4, 8])
@pytest.mark.parametrize("size", [2, 8])
def test_samples_that_fail_are_reported_and_the_others_are_not_disturbed(lanes, order, size):
    # Two unknowns are few enough for the loop over blocks, eight are not.
    program = solve_program(size, "ldl")
    rng = np.random.default_rng(size)
    x = rng.normal(size=(61, program.signature.num_states))
    for k, row in enumerate(x):
        a = row[: size * size].reshape(size, size)
        a[:] = a @ a.T + np.eye(size)
        if k in (0, 3, 17, 18, 40, 60):
            a[:] = 1.0  # all rows the same
    out, failed = (
        LLVMBackend(lanes=lanes)
        .compile(program)
        .evaluate(np.zeros(61), np.asarray(x, order=order), np.zeros((1, 0)), np.zeros(0))
    )
    assert np.flatnonzero(failed).tolist() == [0, 3, 17, 18, 40, 60]
    assert np.isnan(out[failed]).all()
    for k in np.flatnonzero(~failed):
        a, b = x[k, : size * size].reshape(size, size), x[k, size * size :]
        np.testing.assert_allclose(out[k], np.linalg.solve(a, b), rtol=1e-10)


@pytest.mark.parametrize("lanes", [1, 2, 4, 8])
def test_one_row_of_specifieds_may_be_a_row_of_columns(lanes):
    tape = Tape()
    r = [tape.make("input", "r", k) for k in range(2)]
    x = [tape.make("input", "x", k) for k in range(2)]
    nodes = [tape.mul(a, b) for a, b in zip(x, r, strict=True)]
    program = Program.from_tape(tape, (2, 2, 0), [("v", (2,), nodes)])
    states = np.asfortranarray(np.arange(40.0).reshape(20, 2))
    rows = np.asfortranarray(np.arange(10.0).reshape(5, 2))
    kernel = LLVMBackend(lanes=lanes).compile(program)
    out, _ = kernel.evaluate(np.zeros(20), states, rows[3:4], np.zeros(0))
    np.testing.assert_array_equal(out, states * rows[3])


def test_a_sweep_has_as_many_words_as_its_gate_copies():
    core = Path(native.__file__).parents[1] / "core" / "gates.ll"
    gate = core.read_text("utf-8").split("@sweep_gate(")[1]
    copied = int(re.search(r"memcpy[^\n]* i64 (\d+), i1 false", gate)[1])
    words, _ = native._sweep_words(program_of([X[0]]), 8, [0, 0, 0, 0])
    assert words.nbytes == copied
