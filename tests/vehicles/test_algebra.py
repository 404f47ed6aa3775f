"""The functions of the equations of tires, of expressions against those of numbers."""

import math

import pytest
import sympy as sm

from pydy.vehicles.algebra import SymbolicAlgebra, is_symbolic

x, y = sm.symbols("x y")


@pytest.mark.parametrize("inverse", [sm.atan, sm.asin, sm.acos])
@pytest.mark.parametrize("name", ["sin", "cos", "tan"])
def test_functions_of_inverse_functions_need_no_function(name, inverse):
    expression = getattr(SymbolicAlgebra(), name)(inverse(x, evaluate=False))
    assert not expression.atoms(sm.Function)
    expected = getattr(math, name)(float(inverse(0.3)))
    assert float(expression.subs(x, 0.3)) == pytest.approx(expected, rel=1e-15)


def test_the_larger_of_expressions_has_its_arguments_in_the_order_given():
    m = SymbolicAlgebra()
    larger, smaller = m.maximum(x + y, 1), m.minimum(y, x)
    assert (type(larger), larger.args) == (sm.Max, (x + y, 1))
    assert (type(smaller), smaller.args) == (sm.Min, (y, x))
    assert larger.subs({x: 2, y: 3}) == 5
    assert larger.xreplace({x: sm.S(2), y: sm.S(-3)}) == 1
    assert larger.diff(x).subs({x: 2, y: 3}) == 1
    assert m.maximum(x, x) == x
    assert m.maximum(2, 3) == 3


def test_an_expression_is_recognised_without_a_walk_through_it(monkeypatch):
    monkeypatch.setattr(sm.Basic, "free_symbols", property(lambda self: pytest.fail("a walk")))
    assert is_symbolic(x + y)
    assert not is_symbolic(2.0)
    assert not is_symbolic(sm.S.One)
