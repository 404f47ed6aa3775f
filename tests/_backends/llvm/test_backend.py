"""The LLVM back end: every operation in every lane width, solves lane by lane, the way in."""

import copy
import ctypes
import pickle
import re
from functools import cache

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from graphs import (
    BINARY,
    COMPARISONS,
    ELEMENTARY,
    UNARY,
    P,
    T,
    X,
    on_tape,
    program_of,
    solve_program,
)
from pydy._backends.llvm import ir, jit
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.llvm.text import kernel_text
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._program.interpret import run
from pydy._program.program import Program, Tape
from pydy.vehicles import commonroad_car

LANES = [1, 2, 4, 8]
NAN, INF = np.nan, np.inf
AWKWARD = [0.0, 1.0, -1.0, 0.5, -2.5, 3.0, 1e-300, 5e-324, -1e300, 710.0, 1e22, INF, -INF, NAN]
every_width = pytest.mark.parametrize("lanes", LANES)


@cache
def compiled(program_name, lanes):
    return LLVMBackend(lanes=lanes).compile(PROGRAMS[program_name]())


# -- Programs -------------------------------------------------------------------------------------


def operations(tape, a, b):
    """Every elementary operation on two values, truth values seen through `select`."""
    truths = {op: tape.make(op, a, b) for op in COMPARISONS}
    lt, ne, le = truths["lt"], truths["ne"], truths["le"]
    truths |= {"and": tape.make("and", le, ne), "or": tape.make("or", lt, ne)}
    truths |= {"not": tape.make("not", lt)}
    nodes = {op: tape.make(op, a, b) for op in ("add", "sub", "mul", "div", *BINARY)}
    nodes |= {op: tape.make(op, a) for op in ("neg", *UNARY)}
    nodes |= {op: tape.make("select", c, a, b) for op, c in truths.items()}
    assert set(nodes) == ELEMENTARY - {"select"}
    return nodes


@cache
def everything():
    """Each operation at every call, in the setup stage, and with what the setup stage carries."""
    tape = Tape()
    (x, y), (a, b) = ([tape.make("input", g, k) for k in range(2)] for g in "xp")
    blocks = [operations(tape, x, y), operations(tape, a, b), operations(tape, x, a)]
    carried = tape.make("lt", a, b)
    choice = {"carried": tape.make("select", carried, x, y)}
    blocks = [
        *blocks,
        choice,
        {k: tape.const(v) for k, v in zip("abcd", AWKWARD[-4:], strict=True)},
    ]
    table = [(str(k), (len(nodes),), list(nodes.values())) for k, nodes in enumerate(blocks)]
    return Program.from_tape(tape, (2, 0, 2), table)


@cache
def expressions():
    """Something like equations of motion: all inputs, sums of products, angles, a choice."""
    x, y, z, w = X
    a, b, c = P
    angle = sm.sin(x - y) * z**2 * a + sm.cos(x - y) * w * b
    return program_of(
        [
            angle / (a + b * sm.cos(x) ** 2) - c * sm.sin(T),
            sm.exp(-(x**2)) * sm.tanh(w) + sm.atan2(y, z),
            sm.Piecewise((sm.sqrt(x + 3), x < y), (sm.Abs(z) ** sm.Rational(3, 2), True)),
            sm.Max(x * a, y * b, sm.sinh(z)) + a * b * c,
        ]
    )


PROGRAMS = {
    "everything": everything,
    "expressions": expressions,
    "lu": cache(lambda: solve_program(3, "lu", columns=2)),
    "ldl": cache(lambda: solve_program(3, "ldl", columns=2)),
    "ldl loop": cache(lambda: solve_program(3, "ldl", columns=2, off=frozenset({"ldl"}))),
}
SOLVES = ["lu", "ldl", "ldl loop"]


def samples(name, m, seed=0):
    """m generic states (t, x, r, p) of a Program."""
    program = PROGRAMS[name]()
    rng = np.random.default_rng(seed)
    x = rng.uniform(-2.0, 2.0, (m, program.signature.num_states))
    if name in SOLVES:
        root = rng.normal(size=(m, 3, 3))
        x[:, :9] = (root @ root.transpose(0, 2, 1) + 0.1 * np.eye(3)).reshape(m, 9)
    p = rng.uniform(0.5, 2.0, program.signature.num_constants)
    return rng.uniform(0.0, 3.0, m), x, np.empty((1, program.signature.num_specifieds)), p


def same(actual, expected, ulps):
    """Equal NaN and infinities, and numbers within a few units of the last place."""
    assert actual.shape == expected.shape
    plain = np.isfinite(expected)
    np.testing.assert_array_equal(actual[~plain], expected[~plain])
    error = np.abs(actual[plain] - expected[plain])
    bad = error > ulps * np.spacing(np.abs(expected[plain]))
    assert not bad.any(), (actual[plain][bad], expected[plain][bad])


# -- every operation ------------------------------------------------------------------------------


@every_width
@pytest.mark.parametrize("p", [(0.75, -1.5), (NAN, 2.0), (-INF, INF), (0.0, 3.0)], ids=str)
def test_every_operation_agrees_with_the_interpreter_on_awkward_numbers(lanes, p):
    x = np.array([(a, b) for a in AWKWARD for b in AWKWARD])
    arguments = np.zeros(len(x)), x, np.empty((1, 0)), np.array(p)
    expected, _ = run(everything(), *arguments)
    out, failed = compiled("everything", lanes).evaluate(*arguments)
    same(out, expected, ulps=4)
    assert not failed.any()


@every_width
def test_every_operation_agrees_with_the_interpreter_on_plain_numbers(lanes):
    rng = np.random.default_rng(1)
    x = rng.uniform(-1.0, 1.0, (203, 2)) * 10.0 ** rng.integers(-8, 4, (203, 2))
    arguments = np.zeros(203), x, np.empty((1, 0)), np.array([0.3, 1.7])
    expected, _ = run(everything(), *arguments)
    same(compiled("everything", lanes).evaluate(*arguments)[0], expected, ulps=4)


@every_width
def test_expressions_agree_with_the_interpreter(lanes):
    arguments = samples("expressions", 101)
    expected, _ = run(expressions(), *arguments)
    out, _ = compiled("expressions", lanes).evaluate(*arguments)
    np.testing.assert_allclose(out, expected, rtol=1e-13, atol=1e-14)


def angles():
    """Generic angles up to 1e5, the doubles beside multiples of π/2, and huge ones."""
    rng = np.random.default_rng(2)
    k = rng.integers(1, 63_000, 300)
    with mp.workdps(40):
        near = np.array([float(int(i) * mp.pi / 2) for i in k])
    generic = rng.uniform(-1e5, 1e5, 300)
    small = rng.uniform(-1, 1, 100) * 10.0 ** rng.integers(-12, 2, 100)
    huge = 10.0 ** rng.uniform(5, 300, 100)
    return np.concatenate([near, np.nextafter(near, 0), -near, generic, small, huge])


@every_width
def test_sine_and_cosine_are_right_to_the_last_place(lanes):
    x = angles()
    kernel = LLVMBackend(lanes=lanes).compile(program_of([sm.sin(X[0]), sm.cos(X[0])]))
    states = np.zeros((len(x), 4))
    states[:, 0] = x
    out, _ = kernel.evaluate(np.zeros(len(x)), states, np.empty((1, 0)), np.zeros(3))
    with mp.workprec(1200):
        exact = [(mp.sin(mp.mpf(float(v))), mp.cos(mp.mpf(float(v)))) for v in x]
        ulps = [
            float(abs(mp.mpf(float(found)) - value)) / np.spacing(abs(float(value)))
            for row, values in zip(out, exact, strict=True)
            for found, value in zip(row, values, strict=True)
        ]
    assert max(ulps) <= 1.0


def arguments_of_arctangents():
    rng = np.random.default_rng(1)
    starts = np.array([7 / 16, 11 / 16, 19 / 16, 39 / 16])
    around = (starts[:, None] * (1 + np.arange(-20, 21) * 2.0**-52)).ravel()
    every_size = 10.0 ** rng.uniform(-320, 308, 400)
    return np.concatenate([around, -around, every_size, -every_size, rng.normal(size=400) * 2])


@every_width
def test_arctangents_are_right_to_the_last_place(lanes):
    x = arguments_of_arctangents()
    found = arctangents(x, lanes)
    with mp.workprec(1200):
        exact = [mp.atan(mp.mpf(float(v))) for v in x]
        ulps = [
            float(abs(mp.mpf(float(a)) - b)) / np.spacing(abs(float(b)))
            for a, b in zip(found, exact, strict=True)
        ]
    assert max(ulps) <= 1.0
    assert found.tobytes() == arctangents(x, 1).tobytes()


@every_width
def test_arctangents_of_zeros_infinities_and_no_numbers(lanes):
    x = np.array([0.0, -0.0, np.inf, -np.inf, np.nan, 5e-324, -5e-324, 1.7e308])
    assert arctangents(x, lanes).tobytes() == np.arctan(x).tobytes()


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7])
def test_arctangents_of_one_state_are_computed_together(count):
    tape = Tape()
    x = [tape.make("input", "x", k) for k in range(count)]
    inner = [tape.make("sub", a, tape.make("atan", a)) for a in x]
    outer = [tape.make("atan", a) for a in inner]
    program = Program.from_tape(tape, (count, 0, 0), [("values", (count,), outer)])
    calls = re.findall(r"call .*@atan\.lanes(\d)\(", kernel_text(program, 1))
    groups = {1: [1], 2: [2], 3: [4], 4: [4], 7: [4, 4]}[count]
    assert [int(width) for width in calls] == 2 * groups  # the inner ones, then the outer ones
    states = np.random.default_rng(2).normal(size=(16, count))
    arguments = np.zeros(16), states, np.empty((1, 0)), np.empty(0)
    alone, together = (LLVMBackend(lanes=n).compile(program).evaluate(*arguments) for n in (1, 8))
    assert alone[0].tobytes() == together[0].tobytes()
    exact = np.arctan(states - np.arctan(states))
    np.testing.assert_allclose(alone[0], exact, rtol=1e-15, atol=1e-16)


def test_the_arctangents_of_four_tires_take_a_quarter_of_the_calls():
    car = commonroad_car("ford_escort", "MB", speed=15.0)
    program = car._now().model.code.compiled("rates").program
    calls = re.findall(r"call .*@atan\.lanes(\d)\(", kernel_text(program, 1))
    assert (program.operation_count["run"]["atan"], calls) == (56, ["4"] * 14)


def arctangents(x, lanes):
    kernel = LLVMBackend(lanes=lanes).compile(program_of([sm.atan(X[0])]))
    states = np.zeros((len(x), 4))
    states[:, 0] = x
    return kernel.evaluate(np.zeros(len(x)), states, np.empty((1, 0)), np.zeros(3))[0][:, 0]


# -- lanes ----------------------------------------------------------------------------------------


@every_width
@pytest.mark.parametrize("name", PROGRAMS)
def test_the_number_of_samples_need_not_be_a_multiple_of_the_lanes(lanes, name):
    kernel = compiled(name, lanes)
    t, x, r, p = samples(name, 2 * lanes + 1)
    whole, _ = kernel.evaluate(t, x, r, p)
    for m in range(2 * lanes + 1):
        out, failed = kernel.evaluate(t[:m], np.ascontiguousarray(x[:m]), r, p)
        assert out.shape == (m, kernel.program.signature.num_outputs)
        assert failed.shape == (m,)
        np.testing.assert_array_equal(out, whole[:m])


@every_width
@pytest.mark.parametrize("name", PROGRAMS)
def test_no_result_depends_on_its_neighbours(lanes, name):
    kernel = compiled(name, lanes)
    t, x, r, p = samples(name, 3 * lanes)
    x[1::5] = NAN
    expected, flags = kernel.evaluate(t, x, r, p)
    order = np.random.default_rng(4).permutation(len(t))
    out, failed = kernel.evaluate(t[order], x[order], r, p)
    np.testing.assert_array_equal(out, expected[order])
    np.testing.assert_array_equal(failed, flags[order])


@pytest.mark.parametrize("lanes", LANES[1:])
@pytest.mark.parametrize("name", PROGRAMS)
def test_the_last_bit_is_the_same_in_every_lane_width(lanes, name):
    arguments = samples(name, 40)
    out, _ = compiled(name, lanes).evaluate(*arguments)
    np.testing.assert_array_equal(out, compiled(name, 1).evaluate(*arguments)[0])


@every_width
def test_specifieds_may_be_given_for_each_sample_or_once_for_all(lanes):
    tape = Tape()
    r = [tape.make("input", "r", k) for k in range(2)]
    x = tape.make("input", "x", 0)
    program = Program.from_tape(tape, (1, 2, 0), [("v", (2,), [tape.mul(x, r[0]), r[1]])])
    kernel = LLVMBackend(lanes=lanes).compile(program)
    x, none = np.arange(1.0, 6.0)[:, None], np.empty(0)
    table = np.arange(10.0).reshape(5, 2)
    once, _ = kernel.evaluate(np.zeros(5), x, table[2:3], none)
    np.testing.assert_array_equal(once, np.column_stack([4 * x[:, 0], np.full(5, 5.0)]))
    each, _ = kernel.evaluate(np.zeros(5), x, table, none)
    np.testing.assert_array_equal(each, np.column_stack([x[:, 0] * table[:, 0], table[:, 1]]))


@every_width
def test_a_condition_on_constants_is_known_at_both_ends_of_a_long_program(lanes):
    x, condition = X[0], P[0] > P[1]
    filling = [sm.sin(x + k) for k in range(300)]
    choices = [sm.Piecewise((f(x), condition), (x, True)) for f in (sm.exp, sm.atan)]
    program = program_of([choices[0], *filling, choices[1]])
    kernel = LLVMBackend(lanes=lanes).compile(program)
    arguments = samples("expressions", 5)
    for p in (np.array([2.0, 1.0, 0.0]), np.array([1.0, 2.0, 0.0])):
        expected, _ = run(program, *arguments[:3], p)
        same(kernel.evaluate(*arguments[:3], p)[0], expected, ulps=4)


# -- solves ---------------------------------------------------------------------------------------

SINGULAR = np.outer([1.0, 2.0, -3.0], [1.0, 2.0, -3.0]).ravel()
INDEFINITE = np.array([[0.0, 2, 1], [2, 0, 3], [1, 3, 0]]).ravel()


@every_width
@pytest.mark.parametrize("name", SOLVES)
def test_a_singular_lane_leaves_the_others_as_if_they_were_alone(lanes, name):
    kernel = compiled(name, lanes)
    t, x, r, p = samples(name, 16)
    x[3, :9] = x[8, :9] = x[9, :9] = SINGULAR
    x[5, :9] = INDEFINITE
    out, failed = kernel.evaluate(t, x, r, p)
    assert np.flatnonzero(failed).tolist() == [3, 8, 9]
    assert np.isnan(out[failed]).all()
    for k in np.flatnonzero(~failed):
        alone, flag = kernel.evaluate(t[k : k + 1], x[k : k + 1], r, p)
        assert not flag[0]
        np.testing.assert_array_equal(out[k], alone[0])


@every_width
@pytest.mark.parametrize("name", SOLVES)
def test_solves_agree_with_the_interpreter(lanes, name):
    t, x, r, p = samples(name, 33)
    x[4, :9], x[11, :9] = SINGULAR, INDEFINITE
    expected, flags = run(PROGRAMS[name](), t, x, r, p)
    out, failed = compiled(name, lanes).evaluate(t, x, r, p)
    np.testing.assert_array_equal(failed, flags)
    conditions = np.linalg.cond(x[~flags, :9].reshape(-1, 3, 3))
    error = np.abs(out - expected)[~flags].max(axis=1)
    assert (error <= 2.0**-48 * conditions * np.abs(expected[~flags]).max(axis=1)).all()
    assert np.isnan(out[flags]).all()


@pytest.mark.parametrize("name", SOLVES)
@pytest.mark.parametrize("bad", range(4))
def test_the_native_function_returns_a_bit_for_each_failed_lane(name, bad):
    lanes = 4
    kernel = compiled(name, lanes)
    _, x, _, _ = samples(name, lanes)
    x[[bad, (bad + 2) % lanes], :9] = SINGULAR
    status, out = native(kernel, x)
    assert status == (1 << bad) | (1 << (bad + 2) % lanes)
    np.testing.assert_array_equal(np.isnan(out).all(axis=1), [status >> k & 1 for k in range(4)])


def test_a_failure_in_one_of_two_solves_is_kept():
    graph = Graph()
    x = [graph.input("x", k) for k in range(4)]
    (one,), (two,) = (LinearSystem(graph, [[x[k]]], "ldl").solve([x[k + 1]]) for k in (0, 2))
    program = on_tape(graph, [one, two], (4, 0, 0))
    states = np.array([[2.0, 1, 4, 1], [0, 1, 4, 1], [2, 1, 0, 1], [0, 1, 0, 1]])
    for lanes in LANES:
        kernel = LLVMBackend(lanes=lanes).compile(program)
        out, failed = kernel.evaluate(np.zeros(4), states, np.empty((1, 0)), np.empty(0))
        assert failed.tolist() == [False, True, True, True]
        np.testing.assert_array_equal(out, [[0.5, 0.25], [NAN, 0.25], [0.5, NAN], [NAN, NAN]])


# -- the native signature -------------------------------------------------------------------------


def native(kernel, x, t=0.0, p=(), shift=0):
    """Call the native functions with arrays laid out [item][lane], `shift` doubles off a line."""
    lanes, program = kernel.lanes, kernel.program
    signature = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 5)
    prepare = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 2)(int(kernel.addresses[1]))

    def place(values):
        values = np.ascontiguousarray(values, dtype=float).ravel()
        line = np.zeros(len(values) + 32)
        start = (-line.ctypes.data // 8) % 8 + shift
        part = line[start : start + len(values)]
        part[:] = values
        assert not len(part) or part.ctypes.data % 64 == 8 * shift
        return part

    constants, c = place(np.repeat(p, lanes)), place(np.zeros(kernel.size_of_c * lanes))
    prepare(constants.ctypes.data, c.ctypes.data)
    out = place(np.zeros(program.signature.num_outputs * lanes))
    arrays = [place([t] * lanes), place(x.T), place([]), c, out]
    status = signature(int(kernel.addresses[0]))(*(a.ctypes.data for a in arrays))
    return status, out.reshape(-1, lanes).T


@every_width
@pytest.mark.parametrize("name", PROGRAMS)
def test_arrays_need_no_more_than_eight_byte_alignment(lanes, name):
    kernel = compiled(name, lanes)
    t, x, r, p = samples(name, lanes)
    for shift in range(8):
        _, out = native(kernel, x, t[0], p, shift)
        expected, _ = kernel.evaluate(np.full(lanes, t[0]), x, r, p)
        np.testing.assert_array_equal(out, expected)


# -- call -----------------------------------------------------------------------------------------

GOOD = {
    "x": np.array([0.3, -0.4, 0.5, 0.6]),
    "t": 1.5,
    "r": np.empty(0),
    "p": np.array([1.1, 1.2, 1.3]),
}
WRONG = {
    "x as a list": {"x": [0.3, -0.4, 0.5, 0.6]},
    "x of integers": {"x": np.arange(4)},
    "x of another byte order": {"x": GOOD["x"].astype(GOOD["x"].dtype.newbyteorder())},
    "x in single precision": {"x": GOOD["x"].astype(np.float32)},
    "x too short": {"x": GOOD["x"][:3]},
    "x too long": {"x": np.zeros(5)},
    "x with two axes": {"x": GOOD["x"][None]},
    "x with strides": {"x": np.repeat(GOOD["x"], 2)[::2]},
    "x backwards": {"x": GOOD["x"][::-1]},
    "x of a subclass": {"x": GOOD["x"].view(np.recarray)},
    "x missing": {"x": None},
    "x not aligned": {"x": np.zeros(40, np.uint8)[1:33].view(np.float64)},
    "p too short": {"p": GOOD["p"][:2]},
    "p of integers": {"p": np.arange(3)},
    "p with strides": {"p": np.repeat(GOOD["p"], 2)[::2]},
    "p as a list": {"p": [1.1, 1.2, 1.3]},
    "r too long": {"r": np.zeros(1)},
    "r missing": {"r": None},
}


def call(kernel, out, **changes):
    given = GOOD | changes
    return kernel.call(given["x"], given["t"], given["r"], given["p"], out)


@every_width
def test_call_gives_what_the_sweep_gives(lanes):
    kernel, out = compiled("expressions", lanes), np.empty(4)
    assert call(kernel, out) == 0
    arguments = np.array([GOOD["t"]]), GOOD["x"][None], GOOD["r"][None], GOOD["p"]
    np.testing.assert_array_equal(out, kernel.evaluate(*arguments)[0][0])


def refused(lanes, name):
    out = np.full(4, 7.5)
    assert call(compiled("expressions", lanes), out, **WRONG[name]) == -1
    assert (out == 7.5).all()


@pytest.mark.parametrize("name", WRONG)
def test_call_refuses_what_it_cannot_read(name):
    refused(1, name)


# Only those whose memory is at least as large as what would be read.
@pytest.mark.parametrize("name", ["x of integers", "x with strides", "x too long", "p of integers"])
def test_call_of_a_wide_kernel_refuses_what_it_cannot_read(name):
    refused(4, name)


@pytest.mark.parametrize("t", [1, np.float64(1.5), None, "1.5"], ids=repr)
def test_call_takes_no_time_but_a_float(t):
    out = np.full(4, 7.5)
    assert call(compiled("expressions", 1), out, t=t) == -1
    assert (out == 7.5).all()


def test_call_wants_five_arguments():
    assert compiled("expressions", 1).call(GOOD["x"], 1.5) == -1


def test_call_reports_a_singular_solve():
    _, x, _, _ = samples("lu", 1)
    x[0, :9] = SINGULAR
    out, none = np.empty(6), np.empty(0)
    assert compiled("lu", 1).call(x[0], 0.0, none, none, out) == 1
    assert np.isnan(out).all()


@every_width
def test_call_follows_constants_that_change(lanes):
    kernel = compiled("expressions", lanes)
    results = []
    p = GOOD["p"].copy()
    for value in (1.1, 2.2, 1.1):
        p[0] = value  # the same array, changed in place
        out = np.empty(4)
        assert call(kernel, out, p=p) == 0
        results.append(out)
    fresh = np.empty(4)
    call(kernel, fresh, p=np.array([2.2, 1.2, 1.3]))
    np.testing.assert_array_equal(results[0], results[2])
    np.testing.assert_array_equal(results[1], fresh)
    assert (results[0] != results[1]).any()


# -- kernels --------------------------------------------------------------------------------------


@pytest.mark.parametrize("lanes", [1, 4])
def test_a_kernel_survives_pickling(lanes):
    kernel = compiled("expressions", lanes)
    again = pickle.loads(pickle.dumps(kernel))
    arguments = samples("expressions", 9)
    np.testing.assert_array_equal(again.evaluate(*arguments)[0], kernel.evaluate(*arguments)[0])
    assert (again.lanes, again.program.digest) == (lanes, kernel.program.digest)


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_a_copy_of_a_kernel_is_the_kernel(duplicate):
    kernel = compiled("expressions", 1)
    assert duplicate(kernel) is kernel


def test_two_kernels_of_one_program_do_not_share_their_constants():
    one, two = (LLVMBackend().compile(expressions()) for _ in range(2))
    first, second = np.empty(4), np.empty(4)
    call(one, first)
    call(two, second, p=2 * GOOD["p"])
    call(one, first)
    expected = run(expressions(), np.array([1.5]), GOOD["x"][None], GOOD["r"][None], GOOD["p"])
    np.testing.assert_allclose(first, expected[0][0], rtol=1e-14)
    assert (first != second).any()


def test_a_program_without_outputs_compiles():
    kernel = LLVMBackend().compile(on_tape(Graph(), []))
    out, failed = kernel.evaluate(*samples("expressions", 3))
    assert out.shape == (3, 0)
    assert not failed.any()


@pytest.mark.parametrize("lanes", [0, 3, 16, "2"])
def test_a_number_of_lanes_that_is_not_a_power_of_two_is_refused(lanes):
    with pytest.raises(ValueError, match=r"`lanes` is .*, but it must be 1, 2, 4 or 8"):
        LLVMBackend(lanes=lanes)


@every_width
def test_slots_beyond_what_a_small_stack_holds_come_from_the_heap(monkeypatch, lanes):
    program = solve_program(6, "lu")
    x = np.random.default_rng(3).uniform(0.5, 1.5, (5, program.signature.num_states))
    nothing = (
        np.zeros((1, program.signature.num_specifieds)),
        np.zeros(program.signature.num_constants),
    )
    wanted, _ = LLVMBackend(lanes=lanes).compile(program).evaluate(np.zeros(5), x, *nothing)
    monkeypatch.setattr(ir, "STACK_BYTES", 0)
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    jit.memory.clear()
    text = kernel_text(program, lanes)
    assert "call ptr @malloc(" in text
    assert text.count("call void @free(") == 2  # one for each way out
    found, _ = LLVMBackend(lanes=lanes).compile(program).evaluate(np.zeros(5), x, *nothing)
    np.testing.assert_array_equal(found, wanted)
