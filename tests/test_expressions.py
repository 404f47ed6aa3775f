"""Symbols and values inside expressions, of which each distinct object is visited once."""

import pytest
import sympy as sm

from pydy._expressions import has_real_values


@pytest.mark.parametrize(
    "part", [sm.nan, sm.zoo, sm.I, sm.oo, -sm.oo, sm.MatrixSymbol("A", 2, 2)[0, 0]]
)
def test_an_expression_with_values_that_are_not_real_is_seen(part):
    x, y = sm.symbols("x y")
    assert has_real_values(sm.sin(x * y) + 2)
    assert not has_real_values(sm.sin(y + sm.Function("f")(x, part)))


def test_an_expression_of_shared_parts_is_visited_once():
    shared = sm.Symbol("x")
    for _ in range(200):  # a tree of 2**200 nodes
        shared = sm.Add(shared, sm.sin(shared, evaluate=False), evaluate=False)
    assert has_real_values(shared)
