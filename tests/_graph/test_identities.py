"""Nodes that are equal as functions become one node."""

from __future__ import annotations

import numpy as np
import pytest

from graphs import on_tape
from pydy._graph import signatures
from pydy._graph.passes.merge import merge_equal


def test_a_squared_sine_and_cosine_are_one(graph, x, y):
    s, c = graph.call("sin", x), graph.call("cos", x)
    circle = graph.add(graph.powi(s, 2), graph.powi(c, 2))
    assert merge_equal(graph, [graph.mul(circle, y)]) == [y]


def test_speeds_written_out_by_derivatives_become_speeds(graph, x, y):
    # u and v turned by an angle, and turned back.
    u, v = y, graph.input("x", 2)
    s, c = graph.call("sin", x), graph.call("cos", x)
    a = graph.sub(graph.mul(c, u), graph.mul(s, v))
    b = graph.add(graph.mul(s, u), graph.mul(c, v))
    back = graph.add(graph.mul(c, a), graph.mul(s, b))
    across = graph.sub(graph.mul(s, a), graph.mul(c, b))
    assert merge_equal(graph, [back, across]) == [u, graph.neg(v)]


def test_a_denominator_that_is_a_reciprocal_becomes_a_factor(graph, x, y):
    # What a linear solver makes of the rates of angles: c + s²/c is 1/c.
    sine, cosine = graph.call("sin", x), graph.call("cos", x)
    below = graph.add(cosine, graph.product([(sine, 2), (cosine, -1)]))
    assert merge_equal(graph, [graph.div(y, below)]) == [graph.mul(y, cosine)]


def test_squares_that_no_node_holds_yet_are_found(graph, x, y):
    sine, cosine = graph.call("sin", x), graph.call("cos", x)
    rest = graph.add(graph.const(-1.0), graph.powi(sine, 2))
    assert merge_equal(graph, [rest, cosine]) == [graph.neg(graph.powi(cosine, 2)), cosine]


def test_what_vanishes_everywhere_is_zero(graph, x, y):
    terms = [(graph.powi(x, 2), -1.0), (graph.mul(x, y), -2.0), (graph.powi(y, 2), -1.0)]
    difference = graph.sum([(graph.powi(graph.add(x, y), 2), 1.0), *terms])
    assert merge_equal(graph, [difference]) == [graph.zero]


def test_the_cheaper_of_two_forms_stands_for_both(graph, x, y):
    short = graph.mul(x, graph.add(x, y))
    long = graph.add(graph.powi(x, 2), graph.mul(x, y))
    assert merge_equal(graph, [long, short]) == [short, short]


def test_no_form_with_a_denominator_of_its_own_is_taken(graph, x, y):
    # (x⁵ − y⁵) / (x − y) costs less than the sum it equals, which is defined where x = y.
    powers = [graph.mul(graph.powi(x, 4 - k), graph.powi(y, k)) for k in range(5)]
    whole = graph.add(*powers)
    short = graph.div(graph.sub(graph.powi(x, 5), graph.powi(y, 5)), graph.sub(x, y))
    assert merge_equal(graph, [whole, short])[0] == whole


def test_functions_that_agree_in_places_only_stay_apart(graph, x):
    root = graph.call("sqrt", graph.powi(x, 2))
    nodes = [x, root, graph.call("abs", x), graph.call("asin", graph.call("sin", x))]
    assert merge_equal(graph, nodes) == nodes


def test_functions_of_equal_arguments_are_equal(graph, x, y):
    a = graph.call("sqrt", graph.add(graph.powi(x, 2), graph.mul(x, y)))
    b = graph.call("sqrt", graph.mul(x, graph.add(x, y)))
    first, second = merge_equal(graph, [a, b])
    assert first == second


def test_numbers_are_exact(graph, x):
    tenths = graph.sum([(x, 0.1), (graph.powi(x, 2), 1.0)])
    nearly = graph.sum([(x, np.nextafter(0.1, 1.0)), (graph.powi(x, 2), 1.0)])
    assert merge_equal(graph, [tenths, nearly]) == [tenths, nearly]


@pytest.mark.parametrize("power", [-1074, -122, -61, -60, -52, 61, 122, 1000])
def test_powers_of_two_are_not_taken_for_each_other(graph, x, power):
    small = graph.const(2.0**power)
    assert merge_equal(graph, [graph.call("max", x, small)]) == [graph.call("max", x, small)]
    nodes = [graph.sum([(x, 2.0**power)], 1.0), graph.sum([(x, 2.0 ** (power % 61))], 1.0)]
    if nodes[0] != nodes[1]:
        assert merge_equal(graph, nodes) == nodes


@pytest.mark.parametrize("guard", ["select", "atan"])
def test_a_denominator_that_a_function_guards_is_not_one_of_the_node(graph, x, y, guard):
    quotient = graph.div(graph.one, graph.sub(x, y))
    if guard == "select":
        factor = graph.call("select", graph.call("eq", x, y), graph.zero, quotient)
    else:
        factor = graph.call("atan", quotient)
    powers = [graph.mul(graph.powi(x, 4 - k), graph.powi(y, k)) for k in range(5)]
    short = graph.div(graph.sub(graph.powi(x, 5), graph.powi(y, 5)), graph.sub(x, y))
    whole = graph.mul(factor, graph.add(*powers))
    assert merge_equal(graph, [whole, graph.mul(factor, short)])[0] == whole


def test_a_product_that_keeps_a_difference_is_not_summed_up(graph, x, y):
    kept = graph.mul(graph.sub(x, y), graph.sum([(x, 1.0), (y, 1.0)]), graph.add(x, graph.one))
    terms = [(3, 0, 1.0), (2, 0, 1.0), (1, 2, -1.0), (0, 2, -1.0)]
    spread = graph.sum([(graph.mul(graph.powi(x, a), graph.powi(y, b)), c) for a, b, c in terms])
    assert merge_equal(graph, [kept, spread])[0] == kept


def test_functions_of_functions_are_remembered_once_each(graph, x, y):
    node = x
    for _ in range(3000):  # what each may be undefined for would grow with the square of this
        node = graph.call("tanh", graph.add(node, y))
    assert merge_equal(graph, [node]) == [node]


def test_a_quotient_by_zero_is_left_to_the_machine(graph, x):
    nothing = graph.sub(graph.powi(graph.add(x, graph.one), 2), graph.powi(x, 2))
    nothing = graph.sum([(nothing, 1.0), (x, -2.0)], -1.0)
    program = on_tape(graph, merge_equal(graph, [graph.div(x, nothing)]), (1, 0, 0))
    assert program.outputs


def test_deep_graphs_need_no_recursion(graph, x, y):
    node = x
    for _ in range(1100):
        node = graph.call("sin", graph.add(node, y))
    assert merge_equal(graph, [node]) == [node]


@pytest.mark.parametrize("accurate", [True, False])
def test_a_solution_that_is_always_accurate_vanishes_with_its_right_side(graph, x, accurate):
    """Of a constant matrix it is known beforehand; where it never is, a fallback is no value."""
    difference = graph.sub(graph.mul(x, x), graph.powi(x, 2))
    condition = graph.make("bool", (accurate,))
    solution = graph.make("guard", (1, (graph.one,), (difference,), condition, (difference,)))
    (value,) = signatures(graph, [graph.make("item", (solution, 0))])
    assert (value == 0) == accurate
