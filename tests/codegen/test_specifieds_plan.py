"""What solvers outside Python learn about the specifieds, without a call of a user's function."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.codegen.arguments import SpecifiedsPlan
from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.inputs import SampledInput

A, B, C, D, E = SYMBOLS = me.dynamicsymbols("a b c d e")
K = sm.Symbol("k")
T = me.dynamicsymbols._t
X = np.array([1.0, 2.0])


def never(x, t):
    raise AssertionError("a user's function was called")


def pair(x, t):
    return np.array([x[0] + t, x[1]])


def samples(columns=1, kind="linear"):
    values = np.arange(1.0, 2 * columns + 1).reshape(2, columns)
    return SampledInput([0.0, 2.0], values, kind)


def test_the_parts_are_there_without_a_call():
    plan = SpecifiedsPlan(
        {B: 2.5, (E, A): samples(2), C: never, D: K * sm.sin(T)}, SYMBOLS, argument="specifieds"
    )
    np.testing.assert_array_equal(plan.inputs.values, [0.0, 2.5, 0.0, 0.0, 0.0])
    assert plan.inputs.values.dtype == np.float64
    ((columns, sampled),) = plan.inputs.sampled
    assert columns.dtype == np.int64
    assert columns.tolist() == [4, 0]
    assert sampled == samples(2)
    ((columns, function),) = plan.inputs.functions
    assert columns.dtype == np.int64
    assert columns.tolist() == [2]
    assert function.label == "c(t)"
    with pytest.raises(AssertionError, match="was called"):
        function(X, 0.0)
    assert plan.expressions == {D: K * sm.sin(T)}
    assert plan.given == set(SYMBOLS)
    assert not plan.inputs.constant


def test_a_function_of_the_plan_returns_checked_columns():
    plan = SpecifiedsPlan({(B, A): lambda x, t: [1, t]}, SYMBOLS)
    ((columns, function),) = plan.inputs.functions
    result = function(X, 3.0)
    assert result.dtype == np.float64
    assert (columns.tolist(), result.tolist(), function.label) == ([1, 0], [1.0, 3.0], "b(t), a(t)")
    ((_, wrong),) = SpecifiedsPlan({(B, A): lambda x, t: [1, 2, 3]}, SYMBOLS).inputs.functions
    with pytest.raises(ValueError, match=r"b\(t\), a\(t\).*\(2,\).*\(3,\)"):
        wrong(X, 0.0)


def test_functions_with_the_time_first_are_called_with_the_state_first_all_the_same():
    plan = SpecifiedsPlan({(A, B): lambda t, x: [t, x[1]]}, SYMBOLS, time_first=True)
    assert plan.inputs.functions[0][1](X, 7.0).tolist() == [7.0, 2.0]


def test_numbers_alone_are_constant():
    plan = SpecifiedsPlan({A: 1, (C, B): [3, 2], D: sm.pi, E: sm.Rational(1, 2)}, SYMBOLS)
    assert plan.inputs.constant
    assert plan.inputs.values.tolist() == [1.0, 2.0, 3.0, np.pi, 0.5]
    assert (plan.inputs.sampled, plan.inputs.functions, plan.expressions) == ((), (), {})


def test_numbers_and_expressions_may_share_a_key():
    for value in ([K * T, 2.0], (K * T, sm.Integer(2)), sm.Matrix([K * T, 2])):
        plan = SpecifiedsPlan({(A, B): value}, SYMBOLS)
        assert plan.expressions == {A: K * T}
        assert plan.inputs.values.tolist() == [0.0, 2.0, 0.0, 0.0, 0.0]


def test_one_state_and_many_rows_agree():
    plan = SpecifiedsPlan({B: 2.5, (E, A): samples(2, "pchip"), (C, D): pair}, SYMBOLS)
    rng = np.random.default_rng(1)
    x, t = rng.uniform(size=(7, 2)), np.sort(rng.uniform(0.0, 2.0, 7))
    np.testing.assert_array_equal(
        plan.inputs.rows(x, t), [plan.inputs(a, float(b)) for a, b in zip(x, t, strict=True)]
    )


def test_rows_that_are_all_alike_are_given_once():
    assert SpecifiedsPlan({A: 1.0}, SYMBOLS).inputs.rows(np.ones((9, 2)), np.arange(9.0)).shape == (
        1,
        5,
    )


UPDATES = {
    "numbers": ({A: 9.0}, [9.0, 2.0, 1.0, 2.0, 1.0]),
    "half of the samples": ({E: 9.0}, [1.5, 2.0, 1.0, 2.0, 9.0]),
    "half of the function": ({D: 9.0}, [2.0, 2.0, 1.0, 9.0, 1.0]),
    "samples over a function": ({(C, D): samples(2)}, [2.0, 2.0, 1.0, 2.0, 1.0]),
    "a function over samples": ({(A, E): pair}, [1.0, 2.0, 1.0, 2.0, 2.0]),
}


@pytest.mark.parametrize("name", UPDATES)
def test_an_update_replaces_just_what_it_gives(name):
    own = {B: 2.0, (E, A): samples(2), (C, D): pair}
    change, _ = UPDATES[name]
    flat = {s: k for k, s in enumerate(SYMBOLS)}
    plan = SpecifiedsPlan(own, SYMBOLS).updated(SpecifiedsPlan(change, SYMBOLS))
    expected = SpecifiedsPlan(own, SYMBOLS).inputs(X, 0.5)
    other = SpecifiedsPlan(change, SYMBOLS)
    for symbol in other.given:
        expected[flat[symbol]] = other.inputs(X, 0.5)[flat[symbol]]
    np.testing.assert_array_equal(plan.inputs(X, 0.5), expected)
    taken = [c for columns, *_ in (*plan.inputs.sampled, *plan.inputs.functions) for c in columns]
    assert len(taken) == len(set(taken))


def test_an_update_does_not_call_what_it_replaces():
    plan = SpecifiedsPlan({(A, B): never, C: K * T}, SYMBOLS)
    plan = plan.updated(SpecifiedsPlan({A: 1.0, B: 2.0, C: 3.0}, SYMBOLS))
    assert plan.inputs.constant
    assert not plan.expressions
    assert plan.inputs(X, 0.0).tolist() == [1.0, 2.0, 3.0, 0.0, 0.0]


REFUSED = {
    "an expression too few": ({(A, B): [K]}, r"`r` for a\(t\), b\(t\).*2 expressions.*got 1"),
    "an expression too many": ({A: [K, K]}, r"`r` for a\(t\).*1 expressions.*got 2"),
    "a truth value": ({A: T > K}, r"`r` for a\(t\).*truth value `t > k`.*Piecewise"),
    "a number that is not real": ({A: sm.I}, r"`r` for a\(t\).*real number.*I"),
    "two functions in a tuple": ({(A, B): (never, never)}, r"`r` for a\(t\), b\(t\).*key of its"),
    "samples in a tuple": ({(A, B): (samples(), 1.0)}, r"`r` for a\(t\), b\(t\).*key of its own"),
    "samples beside an expression": ({(A, B): (samples(), K)}, r"a\(t\), b\(t\).*key of its own"),
    "samples of too few": ({(A, B): samples(1)}, r"a\(t\), b\(t\).*of 2 values.*\(2, 1\)"),
    "samples of too many": ({A: samples(2)}, r"`r` for a\(t\).*of 1 values.*\(2, 2\)"),
    "a pair of arrays": ({A: ([0.0, 1.0], [2.0, 3.0])}, r"`r` for a\(t\).*SampledInput\(times"),
    "a pair of arrays for two": (
        {(A, B): (np.arange(3.0), np.ones((3, 2)))},
        r"`r` for a\(t\), b\(t\).*SampledInput\(times, values\)",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_fits_no_format_is_refused_by_name(name):
    values, message = REFUSED[name]
    with pytest.raises(ValueError, match=message):
        SpecifiedsPlan(values, SYMBOLS)


def test_times_without_samples_are_refused():
    plan = SpecifiedsPlan({A: 1.0, B: samples()}, SYMBOLS)
    plan.check_times(np.array([0.0, 2.0, 2.0 + 1e-12]), "times")
    for t in ([-0.1, 1.0], [1.0, 2.1]):
        with pytest.raises(ValueError, match=r"`times`.*b\(t\), 0.0 to 2.0, got .*add samples"):
            plan.check_times(np.array(t), "times")


# the function that generate_ode_function returns


@pytest.fixture(scope="module", params=["llvm", "lambdify"])
def rhs(request):
    return generate_ode_function(
        [A + 2 * B], [me.dynamicsymbols("y")], [], [], specifieds=[A, B], generator=request.param
    )


def test_a_generated_function_takes_samples(rhs):
    both = SampledInput([0.0, 2.0], [[1.0, 2.0], [3.0, 4.0]])
    assert rhs([0.0], 1.0, both, []) == [8.0]
    assert rhs([0.0], 1.0, {(A, B): both}, []) == [8.0]
    assert rhs([0.0], 1.0, {B: SampledInput([0, 2], [2, 4]), A: 2.0}, []) == [8.0]
    assert rhs([0.0], 9.0, both, []) == [11.0]  # held, for solvers that step past the end


def test_a_generated_function_refuses_expressions(rhs):
    with pytest.raises(ValueError, match=r"`r` gives a SymPy expression for a\(t\).*compiled"):
        rhs([0.0], 1.0, {A: sm.sin(T), B: 1.0}, [])


def test_zeros_replace_entries_of_every_kind():
    plan = SpecifiedsPlan({A: 1.0, B: 2.0, (C, D): samples(2), E: K * sm.sin(T)}, SYMBOLS)
    zeroed = plan.with_zeros((1, 3, 4))
    np.testing.assert_array_equal(zeroed.inputs(X, 0.0), [1.0, 0.0, 1.0, 0.0, 0.0])
    assert not zeroed.expressions
    np.testing.assert_array_equal(plan.inputs(X, 0.0), [1.0, 2.0, 1.0, 2.0, 0.0])
    assert plan.with_zeros(()) is plan
