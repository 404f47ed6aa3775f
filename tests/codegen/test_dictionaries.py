"""Dictionaries as arguments: fast where nothing changed, and checked every time all the same."""

import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.models import n_link_pendulum_on_cart

X, V, F = me.dynamicsymbols("x v f")
M, K, C = sm.symbols("m k c")
STATE = np.array([0.5, -0.25])


@pytest.fixture(params=["llvm", "lambdify"])
def rhs(request):
    side = [V, (F - K * X - C * V) / M]
    return generate_ode_function(side, [X], [V], [M, K, C], specifieds=[F], generator=request.param)


def calls(function):
    """Return how many Python functions a call runs through."""
    counted = 0

    def count(frame, event, arg):
        nonlocal counted
        counted += event == "call"

    function()
    before = sys.getprofile()
    sys.setprofile(count)
    try:
        function()
    finally:
        sys.setprofile(before)
    return counted


def test_a_dictionary_costs_no_python_call_an_entry():
    counts = {}
    for links in (1, 8):
        system = n_link_pendulum_on_cart(links, joint_torques=True)
        rhs = system.generate_ode_function()
        system.model.compiled("rates").link()
        p = dict.fromkeys(system.constants_symbols, 1.5)
        r = dict.fromkeys(reversed(list(system.specifieds_symbols)), 0.5)
        x = np.linspace(0.1, 0.2, system.num_states)

        def assign(system=system, p=p):
            system.constants = p

        counts[links] = {
            "p": calls(lambda rhs=rhs, x=x, p=p, r=r: rhs(x, 0.0, np.full(len(r), 0.5), p)),
            "r": calls(lambda rhs=rhs, x=x, p=p, r=r: rhs(x, 0.0, r, p)),
            "constants": calls(assign),
        }
    assert counts[1] == counts[8]
    assert counts[1]["r"] <= 20


def test_the_order_of_a_dictionary_does_not_matter(rhs):
    expected = rhs(STATE, 0.0, [0.3], [1.3, 2.0, 0.7])
    for p in ({M: 1.3, K: 2.0, C: 0.7}, {C: 0.7, M: 1.3, K: 2.0}, {K: 2.0, C: 0.7, M: 1.3}):
        for _ in range(2):
            assert rhs(STATE, 0.0, {F: 0.3}, p).tolist() == expected.tolist()


@pytest.mark.parametrize(
    ("p", "message"),
    [
        ({M: 1.3, K: 2.0}, "no value for .* c"),
        ({M: 1.3, K: 2.0, C: 0.7, sm.Symbol("nope"): 1.0}, "nope"),
        ({M: 1.3, K: 2.0, sm.Symbol("nope"): 1.0}, "nope"),
        ({M: 1.3, K: 2.0, C: "0.7"}, r"`p\[c\]` must be a real number, got '0.7'"),
        ({M: 1.3, K: 2.0, C: None}, r"`p\[c\]` must be a real number, got None"),
        ({M: 1.3, K: 2.0, C: np.ma.masked}, r"`p\[c\]` must not have masked"),
        ({M: 1.3, K: 2.0, C: 10**400}, r"`p\[c\]` must be a real number"),
        ({M: 1.3, K: 2.0, C: 1j}, r"`p\[c\]` must be a real number"),
    ],
)
def test_what_is_wrong_is_an_error_every_time(rhs, p, message):
    good = {M: 1.3, K: 2.0, C: 0.7}
    for _ in range(2):
        rhs(STATE, 0.0, [0.3], good)
        with pytest.raises(ValueError, match=message):
            rhs(STATE, 0.0, [0.3], p)


@pytest.mark.parametrize("r", [{}, {F: 0.3, X: 1.0}, {X: 0.3}, {F: "0.3"}])
def test_what_is_wrong_with_specifieds_is_an_error_every_time(rhs, r):
    for _ in range(2):
        rhs(STATE, 0.0, {F: 0.3}, [1.3, 2.0, 0.7])
        with pytest.raises(ValueError, match="`r`"):
            rhs(STATE, 0.0, r, [1.3, 2.0, 0.7])


def test_a_number_edited_in_place_counts(rhs):
    p = {M: 1.0, K: 2.0, C: 0.0}
    rhs(STATE, 0.0, [0.0], p)
    p[K] = 4.0
    assert rhs(STATE, 0.0, [0.0], p)[1] == -2.0


@pytest.mark.parametrize("value", [2, np.float32(2), np.array([2.0]), sm.Integer(2), np.int64(2)])
def test_any_real_number_is_taken(rhs, value):
    assert rhs(STATE, 0.0, {F: 0.0}, {M: 1.0, K: value, C: 0.0})[1] == -1.0
    assert rhs(STATE, 0.0, {F: value}, {M: 1.0, K: 0.0, C: 0.0})[1] == 2.0


def test_a_dictionary_of_one_constant_is_read():
    rhs = generate_ode_function([V, -K * X], [X], [V], [K])
    assert rhs(STATE, 0.0, {K: 4.0}).tolist() == [-0.25, -2.0]


def test_a_fixed_kind_of_argument_still_refuses_a_dictionary():
    rhs = generate_ode_function([V, -K * X], [X], [V], [K], constants_arg_type="array")
    with pytest.raises(ValueError, match="`p`, the constants, must hold real numbers"):
        rhs(STATE, 0.0, {K: 4.0})


# names


@pytest.mark.parametrize("p", [{"m": 1.3, "k": 2.0, "c": 0.7}, {"m": 1.3, K: 2.0, C: 0.7}])
@pytest.mark.parametrize("r", [{"f": 0.3}, {"f(t)": 0.3}, {("f",): [0.3]}, {"f": lambda x, t: 0.3}])
def test_a_name_stands_for_a_symbol(rhs, p, r):
    expected = rhs(STATE, 0.0, [0.3], [1.3, 2.0, 0.7])
    assert rhs(STATE, 0.0, r, p).tolist() == expected.tolist()


def test_of_a_symbol_and_its_name_the_later_value_stands(rhs):
    expected = rhs(STATE, 0.0, [0.3], [1.3, 2.0, 0.7])
    p = {"m": 9.0, M: 1.3, K: 2.0, C: 0.7}
    assert rhs(STATE, 0.0, {"f": 9.0, "f(t)": lambda x, t: 0.3}, p).tolist() == expected.tolist()


def test_a_name_of_several_symbols_is_refused_with_what_differs():
    heavy = sm.Symbol("m", positive=True)
    rhs = generate_ode_function([V, -heavy * X / M], [X], [V], [M, heavy])
    assert rhs(STATE, 0.0, {M: 2.0, heavy: 4.0})[1] == -1.0
    with pytest.raises(ValueError, match=r"'m', which several .*: m, m \(positive\)"):
        rhs(STATE, 0.0, {"m": 1.0})


def test_a_symbol_with_other_assumptions_is_named_with_them(rhs):
    with pytest.raises(ValueError, match=r"assumptions differ: got m \(positive\), known is m"):
        rhs(STATE, 0.0, [0.3], {sm.Symbol("m", positive=True): 1.0, K: 2.0, C: 0.7})
