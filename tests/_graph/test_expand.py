"""Short sums are multiplied out where that saves operations, and only where it is harmless."""

import math

import pytest
import sympy as sm

from graphs import P, X, evaluate, nodes_of, program_of
from pydy._graph.passes.expand import expand_sums
from pydy._graph.simplification import operation_count, simplify

x, y, z, w = X
a, b, c = P


def total(expressions, *without):
    program = program_of(expressions, frozenset(without))
    return program.operation_count["run"].total()


def turning(n):
    """The centrifugal loads on a chain of n links in the plane, written with angle differences."""
    s = [sm.sin((k + 1) * x) for k in range(n)]
    k = [sm.cos((k + 1) * x) for k in range(n)]
    v = [sm.exp((k + 1) * y) for k in range(n)]
    return [sum(v[j] * (s[i] * k[j] - k[i] * s[j]) for j in range(n) if j != i) for i in range(n)]


def test_loads_of_a_chain_cost_the_same_for_each_link():
    costs = [total(turning(n)) for n in (6, 12, 18)]
    assert costs[2] - costs[1] <= 1.1 * (costs[1] - costs[0])
    assert total(turning(12), "expand") > 1.5 * costs[1]


def test_a_difference_of_two_inputs_is_left_alone():
    # z·x − z·y would lose digits where x and y nearly agree.
    graph, nodes = nodes_of([z * (x - y) + z * w * sm.sin(x) + sm.cos(y)])
    assert expand_sums(graph, nodes) == nodes
    assert evaluate(sm.sin(w) + z * (x - y), 1.0 + 2.0**-50, 1.0, 3.0, 0.0) == 3 * 2.0**-50


def test_a_sum_of_constants_is_left_alone():
    graph, nodes = nodes_of([x * (a * b + b * c) + y])
    assert expand_sums(graph, nodes) == nodes


def test_a_sum_that_is_used_often_is_left_alone():
    common = sm.sin(x) * y + sm.cos(x) * z
    graph, nodes = nodes_of([common * w + x, common * x + y, common * y + w, common * z + x])
    assert expand_sums(graph, nodes) == nodes


def test_a_factor_goes_into_a_sum_where_it_takes_a_denominator_away():
    expression = sm.cos(w) * x * (y + z * w / x)
    assert program_of([expression]).operation_count["run"]["div"] == 0
    assert evaluate(expression, 0.0, 1.0, 3.0, 0.5) == 1.5 * math.cos(0.5)


def test_rates_of_angles_have_the_one_denominator_they_need():
    """Body-fixed angles: all is regular but where the second one is a right angle."""
    c1, c2, s2 = sm.cos(x), sm.cos(y), sm.sin(y)
    second = (z + w * s2 / c2) / (c2 + s2**2 / c2)
    first = -(w * (s2**2 / c2 / (c2 + s2**2 / c2) - 1) + z * s2 / (c2 + s2**2 / c2)) / (c1 * c2)
    count = program_of([first, second]).operation_count["run"]
    assert (count["div"], count["mul"]) == (1, 4)
    right = evaluate(second, 0.3, math.pi / 2, 2.0, 0.7)
    assert right == pytest.approx(0.7 + 2.0 * math.cos(math.pi / 2), rel=1e-15)


def test_multiplying_out_is_undone_where_it_costs_operations():
    graph, nodes = nodes_of([x * (sm.sin(y) * z + sm.cos(y) * w) + y])
    assert operation_count(graph, expand_sums(graph, nodes)) >= operation_count(graph, nodes)
    assert simplify(graph, nodes) == nodes


@pytest.mark.parametrize(
    ("switch", "expressions"),
    [
        ("factor", [x * y + x * z + x * w]),
        ("expand", turning(5)),
        ("share products", [x * y * z, y * z * w]),
        ("share sums", [x - y + z, y - x + w]),
    ],
)
def test_each_pass_saves_operations_and_can_be_switched_off(switch, expressions):
    assert total(expressions) < total(expressions, switch)
