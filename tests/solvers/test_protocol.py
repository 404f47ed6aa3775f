"""The calling conventions, which are odeint's."""

import ctypes
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint

from pydy import solvers
from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.inputs import SampledInput
from pydy.solvers import dop853, radau, rk4, tsit5, vern9
from registry import ADAPTIVE, SOLVERS, has_fixed_step, step_options

Q, U, PUSH, PULL = me.dynamicsymbols("q u F G")
K, C = sm.symbols("k c")


def tight(solver):
    return step_options(solver, 1e-10, 1e-3)


def spring(x, t, k=4.0, c=0.0):
    return [x[1], -k * x[0] - c * x[1]]


def cosine(times):
    times = np.asarray(times)
    return np.stack([np.cos(2 * times), -2 * np.sin(2 * times)], axis=-1)


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_python_function_is_integrated(solver):
    times = np.linspace(0.0, 3.0, num=13)
    x = solver(spring, [1.0, 0.0], times, **tight(solver))
    assert x.shape == (13, 2)
    np.testing.assert_allclose(x, cosine(times), atol=1e-8)


@pytest.mark.parametrize("solver", SOLVERS)
def test_args_go_to_the_function(solver):
    times = np.linspace(0.0, 3.0, num=4)
    expected = odeint(spring, [1.0, 0.2], times, args=(2.5, 0.3), rtol=1e-11, atol=1e-11)
    x = solver(spring, [1.0, 0.2], times, args=(2.5, 0.3), **tight(solver))
    np.testing.assert_allclose(x, expected, atol=1e-8)


def test_a_single_argument_needs_no_tuple():
    x = dop853(spring, [1.0, 0.0], [0.0, 1.0], 4.0, rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x[1], cosine(1.0), atol=1e-8)


@pytest.mark.parametrize("solver", SOLVERS)
def test_the_first_row_is_the_initial_state(solver):
    x0 = np.array([0.1, 0.7])
    x = solver(spring, x0, [2.5, 3.0], **tight(solver))
    np.testing.assert_array_equal(x[0], x0)
    x[0] = 9.0
    np.testing.assert_array_equal(x0, [0.1, 0.7])


@pytest.mark.parametrize("solver", SOLVERS)
def test_one_time_gives_one_row(solver):
    np.testing.assert_array_equal(solver(spring, [0.1, 0.7], [2.5], **tight(solver)), [[0.1, 0.7]])


@pytest.mark.parametrize("solver", SOLVERS)
def test_repeated_times_repeat_their_rows(solver):
    times = [0.0, 0.0, 0.5, 0.5, 0.5, 1.0, 1.0]
    x = solver(spring, [1.0, 0.0], times, **tight(solver))
    np.testing.assert_allclose(x, cosine(times), atol=1e-8)
    np.testing.assert_array_equal(x[0], x[1])
    np.testing.assert_array_equal(x[2], x[4])
    np.testing.assert_array_equal(x[5], x[6])


@pytest.mark.parametrize("solver", SOLVERS)
def test_an_interval_of_no_length_gives_equal_rows(solver):
    np.testing.assert_array_equal(
        solver(spring, [1.0, 0.0], [3.0, 3.0], **tight(solver)), [[1.0, 0.0], [1.0, 0.0]]
    )


@pytest.mark.parametrize("solver", SOLVERS)
def test_intervals_may_be_as_short_as_rounding(solver):
    times = [1.0, np.nextafter(1.0, 2.0), 1.0 + 1e-12, 2.0]
    for these in (times, times[:2]):
        x = solver(spring, cosine(1.0), these, **tight(solver))
        np.testing.assert_allclose(x, cosine(these), atol=1e-8)


def test_the_function_gets_its_own_copy_of_the_state():
    def spoils(x, t):
        result = [x[1], -4.0 * x[0]]
        x[:] = np.nan
        return result

    x = dop853(spoils, [1.0, 0.0], [0.0, 1.0], rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x[1], cosine(1.0), atol=1e-8)


def test_a_scalar_state_will_do():
    x = dop853(lambda x, t: -x, 1.0, [0.0, 1.0], rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x, [[1.0], [np.exp(-1.0)]], atol=1e-9)


@pytest.mark.parametrize("n", [1, 7, 8, 9, 17])
@pytest.mark.parametrize("solver", SOLVERS)
def test_any_number_of_states_fits_the_blocks(solver, n):
    rates, times = np.linspace(0.2, 1.0, num=n), np.array([0.0, 0.3, 0.3, 1.0])
    x = solver(lambda x, t: -rates * x, np.ones(n), times, **tight(solver))
    np.testing.assert_allclose(x, np.exp(-np.outer(times, rates)), atol=1e-8)


# -- options --------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", SOLVERS)
def test_full_output_tells_of_the_work(solver):
    calls = []

    def f(x, t):
        calls.append(t)
        return spring(x, t)

    options = {"step": 0.01} if has_fixed_step(solver) else {}
    x, info = solver(f, [1.0, 0.0], np.linspace(0.0, 1.0, num=5), full_output=True, **options)
    assert x.shape == (5, 2)
    assert info["method"] == solver.name
    assert info["status"] == "finished"
    assert info["time"] == 1.0
    assert info["evaluations"] == len(calls)
    assert info["steps"] >= 4
    assert info["rejected"] >= 0
    assert 0.0 < info["last_step"] <= 1.0
    assert (info["jacobians"] > 0) == (solver is radau)
    assert (info["factorisations"] > 0) == (solver is radau)
    assert info["projections"] == 0
    assert info["reached"] == 5
    assert info["events"] == []


def test_fixed_steps_divide_each_interval_evenly():
    _, info = rk4(spring, [1.0, 0.0], [0.0, 0.25, 1.0], step=0.1, full_output=True)
    assert info["steps"] == 3 + 8
    assert info["last_step"] == 0.75 / 8


@pytest.mark.parametrize("solver", [dop853, tsit5, vern9])
def test_a_tolerance_may_be_given_for_each_state(solver):
    def apart(x, t):  # two oscillators that know nothing of each other
        return [x[1], -x[0], x[3], -25.0 * x[2]]

    def run(rtol, atol):
        options = {"rtol": rtol, "atol": atol, "full_output": True}
        x, info = solver(apart, [1.0, 0.0, 1.0, 0.0], [0.0, 10.0], **options)
        exact = [np.cos(10.0), -np.sin(10.0), np.cos(50.0), -5 * np.sin(50.0)]
        return np.abs(x[1] - exact), info["steps"]

    loose = [1e-9, 1e-9, 1e6, 1e6]
    both, steps = run(1e-9, 1e-9)
    one, fewer = run([1e-9, 1e-9, 0.0, 0.0], loose)
    assert fewer < 0.7 * steps
    assert one[:2].max() < 1e-6
    assert one[2:].max() > 1e3 * one[:2].max()
    assert both.max() < 1e-6


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_no_step_is_longer_than_max_step(solver):
    def steps(**options):
        options |= {"rtol": 1e-3, "atol": 1e-3, "full_output": True}
        return solver(spring, [1.0, 0.0], [0.0, 1.0], **options)[1]["steps"]

    assert steps(max_step=0.01) in (99, 100, 101)
    assert steps() < 60


def test_first_step_is_taken():
    options = {"rtol": 1e-3, "atol": 1e3, "full_output": True}
    _, info = dop853(spring, [1.0, 0.0], [0.0, 1.0], first_step=0.25, max_step=0.25, **options)
    assert info["steps"] == 4


@pytest.mark.parametrize("options", [{"max_steps": 1e5}, {"max_steps": np.inf}, {"max_step": None}])
def test_limits_may_be_floats_infinite_or_none(options):
    expected = dop853(spring, [1.0, 0.0], [0.0, 1.0])
    np.testing.assert_array_equal(dop853(spring, [1.0, 0.0], [0.0, 1.0], **options), expected)


def test_fixed_steps_need_their_size():
    with pytest.raises(ValueError, match="`rk4` takes steps of fixed size: pass `step`"):
        rk4(spring, [1.0, 0.0], [0.0, 1.0])


@pytest.mark.parametrize("name", ["rtol", "atol", "first_step", "max_step"])
def test_fixed_steps_have_no_options_of_error_control(name):
    with pytest.raises(TypeError, match=f"`rk4` has no option `{name}`; .* step"):
        rk4(spring, [1.0, 0.0], [0.0, 1.0], step=0.1, **{name: 0.1})


# -- functions ------------------------------------------------------------------------------------


REFUSED = [
    ([1.0], r"must have the shape \(3,\), got \(1,\)"),
    (1.0, r"must have the shape \(3,\), got \(\)"),
    ([1.0, 2.0], r"must have the shape \(3,\), got \(2,\)"),
    ([[1.0, 2.0, 3.0]], r"must have the shape \(3,\), got \(1, 3\)"),
    (np.ones((3, 1)), r"must have the shape \(3,\), got \(3, 1\)"),
    (np.ones(4), r"must have the shape \(3,\), got \(4,\)"),
    (np.array([1.0, 2.0, 3.0j]), r"must hold real numbers, got array"),
    (["1", "2", "3"], r"must hold real numbers, got \['1', '2', '3'\]"),
    (None, r"must hold real numbers, got None"),
    (np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0]), r"must not have masked entries"),
]


@pytest.mark.parametrize(("derivative", "message"), REFUSED)
@pytest.mark.parametrize("good", [0, 10])
@pytest.mark.parametrize("solver", SOLVERS)
def test_a_derivative_that_does_not_fit_the_state_is_refused(solver, good, derivative, message):
    calls = []

    def f(x, t):
        calls.append(t)
        return -x if len(calls) <= good else derivative

    with pytest.raises(ValueError, match=r"What `f\(x, t\)` returns, .*" + message):
        solver(f, [1.0, 2.0, 3.0], [0.0, 1.0], **tight(solver))
    assert len(calls) == good + 1


@pytest.mark.parametrize(
    "make", [list, tuple, np.array, lambda v: np.array(v, dtype=np.float32), lambda v: v[0]]
)
def test_derivatives_may_be_any_real_numbers(make):
    x = dop853(lambda x, t: make([2.0]), [1.0], [0.0, 1.0])
    np.testing.assert_allclose(x[1], 3.0)


def test_specifieds_and_constants_that_do_not_fit_are_refused():
    f = generate_ode_function([U, PUSH - K * Q], [Q], [U], [K], specifieds=[PUSH])
    with pytest.raises(ValueError, match=r"`r`, the specifieds, must have the shape \(1,\), got"):
        dop853(f, [1.0, 0.0], [0.0, 1.0], args=([0.0, 0.0], [4.0]))
    with pytest.raises(ValueError, match=r"`p`, the constants, must have the shape \(1,\), got"):
        dop853(f, [1.0, 0.0], [0.0, 1.0], args=([0.0], [4.0, 1.0]))


@pytest.mark.parametrize("solver", SOLVERS)
def test_an_exception_in_the_function_comes_out_as_itself(solver):
    def f(x, t):
        if t > 0.5:
            raise LookupError("at last")
        return spring(x, t)

    with pytest.raises(LookupError, match="at last"):
        solver(f, [1.0, 0.0], [0.0, 1.0], **tight(solver))


def generated(**options):
    """A driven spring: u' = −k q − c u + F + t G."""
    t = me.dynamicsymbols._t
    return generate_ode_function(
        [U, -K * Q - C * U + PUSH + t * PULL], [Q], [U], [K, C], specifieds=(PUSH, PULL), **options
    )


SAMPLES = SampledInput([0.0, 1.0, 2.0], [[0.0, 1.0], [1.0, 0.5], [-1.0, 0.25]])
INPUTS = {
    "array": (np.array([0.3, -0.2]), lambda t: (0.3, -0.2)),
    "dict": ({PULL: -0.2, PUSH: 0.3}, lambda t: (0.3, -0.2)),
    "dict of a tuple": ({(PULL, PUSH): [-0.2, 0.3]}, lambda t: (0.3, -0.2)),
    "samples": (SAMPLES, lambda t: tuple(SAMPLES.at(t))),
    "dict of samples": (
        {PULL: SampledInput([0.0, 2.0], [1.0, 3.0]), PUSH: 0.3},
        lambda t: (0.3, 1.0 + t),
    ),
    "dict of a function": ({PULL: lambda x, t: np.sin(t), PUSH: 0.3}, lambda t: (0.3, np.sin(t))),
    "function": (lambda x, t: np.array([0.3, np.sin(t)]), lambda t: (0.3, np.sin(t))),
}


@pytest.mark.parametrize("kind", INPUTS)
@pytest.mark.parametrize("solver", SOLVERS)
def test_a_generated_function_takes_every_kind_of_specifieds(solver, kind):
    r, at = INPUTS[kind]
    times = [0.0, 0.7, 1.0, 1.8]

    def f(x, t):
        push, pull = at(t)
        return [x[1], -4.0 * x[0] - 0.3 * x[1] + push + t * pull]

    expected = odeint(f, [0.5, 0.1], times, rtol=1e-11, atol=1e-11, tcrit=[1.0])
    for p in (np.array([4.0, 0.3]), {C: 0.3, K: 4.0}):
        x = solver(generated(), [0.5, 0.1], times, args=(r, p), **tight(solver))
        np.testing.assert_allclose(x, expected, atol=1e-7)


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("solver", SOLVERS)
def test_generators_give_the_same_trajectory(solver, generator):
    times = [0.0, 0.7, 1.8]
    args = (SAMPLES, np.array([4.0, 0.3]))
    expected = solver(generated(), [0.5, 0.1], times, args=args, **tight(solver))
    f = generated(generator=generator)
    x = solver(f, [0.5, 0.1], times, args=args, **tight(solver))
    np.testing.assert_allclose(x, expected, atol=1e-9)


def test_a_generated_function_is_not_called_through_python():
    f = generated()
    call = f.native((np.zeros(2), np.array([4.0, 0.3])))
    assert call.kernel.addresses is not None
    assert call.inputs.constant


def test_a_state_of_the_wrong_length_for_a_generated_function_is_a_value_error():
    with pytest.raises(ValueError, match="`x0` must have 2 values, one for each state, got 3"):
        dop853(generated(), np.zeros(3), [0.0, 1.0], args=(np.zeros(2), np.ones(2)))


def test_a_generated_function_with_time_first_or_outputs_is_called_as_it_is():
    f = generate_ode_function([U, -4 * Q], [Q], [U], time_first=True)
    assert f.native(((),)) is None
    x = dop853(lambda x, t: f(t, x, ()), [1.0, 0.0], [0.0, 1.0], rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(x[1], cosine(1.0), atol=1e-8)


@pytest.mark.parametrize("solver", SOLVERS)
def test_solvers_pickle_as_themselves_and_name_themselves(solver):
    assert pickle.loads(pickle.dumps(solver)) is solver
    assert repr(solver) == f"pydy.solvers.{solver.name}"
    assert getattr(solvers, solver.name) is solver


def test_a_prepared_run_goes_on_in_code_that_takes_the_others_place():
    f = generated()
    args = (np.zeros(2), np.array([4.0, 0.3]))
    run = dop853.prepare(f, [0.5, 0.1], [0.0, 1.0], args=args)
    before = run(np.array([0.5, 0.1])).copy()
    kernel = f.native(args).kernel

    @ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.POINTER(ctypes.c_double)] * 5)
    def at_rest(_t, _x, _r, _c, out):
        out[0] = out[1] = 0.0
        return 0

    own = (int(kernel.addresses[0]), int(kernel.addresses[1]))
    kernel.functions.replace((ctypes.cast(at_rest, ctypes.c_void_p).value, own[1]), at_rest)
    try:
        np.testing.assert_array_equal(run(np.array([0.5, 0.1]))[-1], [0.5, 0.1])
    finally:
        kernel.functions.replace(own, None)
    np.testing.assert_array_equal(run(np.array([0.5, 0.1])), before)
