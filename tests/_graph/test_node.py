"""The hash-consed graph: what is one node, what is folded, what stays."""

import math

import pytest

from graphs import BINARY, COMPARISONS, UNARY, on_tape
from pydy._graph.linear_system import LinearSystem


@pytest.fixture
def z(graph):
    return graph.input("x", 2)


# -- one node for one expression ------------------------------------------------------------------


@pytest.mark.parametrize("op", ["add", "mul"])
def test_sums_and_products_do_not_depend_on_the_order_of_their_operands(graph, x, y, z, op):
    make = getattr(graph, op)
    assert make(x, y, z) == make(z, x, y)


def test_nested_products_are_flattened(graph, x, y, z):
    assert graph.mul(x, graph.mul(y, z)) == graph.mul(graph.mul(x, y), z)


def test_asking_twice_adds_no_node(graph, x, y):
    def build():
        inner = graph.add(graph.mul(x, y), graph.call("sin", x), graph.const(2.5))
        return graph.call("atan2", inner, graph.powi(y, -3))

    first, size = build(), len(graph)
    assert (build(), len(graph)) == (first, size)


def test_like_terms_are_collected(graph, x, y):
    product = graph.mul(x, y)
    assert graph.add(product, graph.mul(y, x)) == graph.product([(x, 1), (y, 1)], 2.0)


def test_terms_that_cancel_leave_zero(graph, x, y):
    assert graph.sub(graph.mul(x, y), graph.mul(y, x)) == graph.zero


def test_powers_of_one_base_are_collected(graph, x, y):
    assert graph.mul(graph.powi(x, 3), y, graph.powi(x, -2)) == graph.mul(x, y)


def test_numbers_in_a_product_become_one_coefficient(graph, x, y):
    two, three = graph.const(2.0), graph.const(3.0)
    scale, core = graph.scaled(graph.mul(two, x, three, y))
    assert (scale, core) == (6.0, graph.mul(x, y))


def test_a_difference_and_its_negative_share_one_sum_as_factors(graph, x, y, z):
    scale, core = graph.scaled(graph.mul(graph.sub(y, x), z))
    other_scale, other_core = graph.scaled(graph.mul(graph.sub(x, y), z))
    assert core == other_core
    assert scale == -other_scale


def test_an_even_power_of_a_difference_forgets_its_sign(graph, x, y):
    assert graph.powi(graph.sub(x, y), 2) == graph.powi(graph.sub(y, x), 2)


def test_a_common_coefficient_is_taken_out_of_a_sum(graph, x, y):
    scale, core = graph.scaled(graph.sum([(x, 3.0), (y, -3.0)]))
    assert (scale, core) == (3.0, graph.sub(x, y))


@pytest.mark.parametrize("op", ["sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh"])
def test_an_odd_function_of_a_negative_is_the_negative_of_the_function(graph, x, y, op):
    there, back = graph.call(op, graph.sub(x, y)), graph.call(op, graph.sub(y, x))
    assert graph.neg(there) == back


@pytest.mark.parametrize("op", ["cos", "cosh", "abs"])
def test_an_even_function_of_a_negative_is_the_function(graph, x, y, op):
    assert graph.call(op, graph.sub(x, y)) == graph.call(op, graph.sub(y, x))


@pytest.mark.parametrize("op", ["acos", "exp", "floor", "ceil"])
def test_a_function_that_is_neither_odd_nor_even_keeps_the_sign(graph, x, op):
    minus = graph.call(op, graph.neg(x))
    assert minus not in (graph.call(op, x), graph.neg(graph.call(op, x)))


def test_the_square_of_a_square_root_is_its_argument(graph, x):
    root = graph.call("sqrt", x)
    assert graph.mul(root, root) == x


@pytest.mark.parametrize(("power", "whole", "half"), [(3, 1, 1), (-3, -1, -1), (5, 2, 1)])
def test_odd_powers_of_a_square_root_keep_one_root(graph, x, power, whole, half):
    root = graph.call("sqrt", x)
    assert graph.powi(root, power) == graph.product([(x, whole), (root, half)])


def test_both_zeros_are_one_node(graph):
    assert graph.const(-0.0) == graph.const(0.0) == graph.zero


def test_all_nans_are_one_node(graph):
    assert graph.const(math.nan) == graph.const(math.inf - math.inf)


def test_a_negation_is_its_own_inverse(graph, x, y):
    total = graph.sum([(x, 2.0), (y, -1.0)], 3.0)
    assert graph.neg(graph.neg(total)) == total


# -- folding --------------------------------------------------------------------------------------


@pytest.mark.parametrize("op", sorted(UNARY))
def test_a_function_of_a_number_is_a_number(graph, op):
    argument = 1.25 if op == "acosh" else 0.4375
    assert graph.value(graph.call(op, graph.const(argument))) == UNARY[op](argument)


@pytest.mark.parametrize("op", sorted(BINARY))
def test_a_function_of_two_numbers_is_a_number(graph, op):
    node = graph.call(op, graph.const(0.75), graph.const(-1.5))
    assert graph.value(node) == BINARY[op](0.75, -1.5)


@pytest.mark.parametrize("op", sorted(COMPARISONS))
@pytest.mark.parametrize("a", [-1.0, 0.5, 2.0])
def test_a_comparison_of_two_numbers_is_decided(graph, op, a):
    node = graph.call(op, graph.const(a), graph.const(0.5))
    assert node == graph.boolean(COMPARISONS[op](a, 0.5))


@pytest.mark.parametrize(
    ("op", "argument"), [("sqrt", -1.0), ("log", -1.0), ("asin", 1.5), ("acosh", 0.5)]
)
def test_folding_outside_a_domain_gives_nan(graph, op, argument):
    assert math.isnan(graph.value(graph.call(op, graph.const(argument))))


@pytest.mark.parametrize(
    ("op", "argument", "expected"),
    [("exp", 1e4, math.inf), ("cosh", -1e4, math.inf), ("log", 0.0, -math.inf)],
)
def test_folding_beyond_the_range_gives_infinity(graph, op, argument, expected):
    assert graph.value(graph.call(op, graph.const(argument))) == expected


def test_an_odd_function_overflows_to_the_side_of_its_argument(graph):
    assert graph.value(graph.call("sinh", graph.const(-1e4))) == -math.inf


@pytest.mark.parametrize("op", ["floor", "ceil"])
def test_rounding_minus_infinity_leaves_it(graph, op):
    assert graph.value(graph.call(op, graph.const(-math.inf))) == -math.inf


@pytest.mark.parametrize("end", [-1.0, 1.0])
def test_folding_a_pole_of_atanh_gives_what_the_machine_gives(graph, end):
    assert graph.value(graph.call("atanh", graph.const(end))) == end * math.inf


def test_a_product_with_the_number_zero_is_zero(graph, x, y):
    assert graph.mul(x, graph.zero, graph.powi(y, -1)) == graph.zero


def test_a_power_of_zero_is_one(graph, x):
    assert graph.powi(x, 0) == graph.one


# -- conditions -----------------------------------------------------------------------------------


@pytest.mark.parametrize(("truth", "chosen"), [(True, "x"), (False, "y")])
def test_a_decided_condition_selects_at_once(graph, x, y, truth, chosen):
    node = graph.call("select", graph.boolean(truth), x, y)
    assert node == {"x": x, "y": y}[chosen]


def test_equal_branches_need_no_condition(graph, x, y):
    assert graph.call("select", graph.call("lt", x, y), y, y) == y


def test_the_least_of_one_thing_is_that_thing(graph, x):
    assert graph.call("min", x, x) == x


@pytest.mark.parametrize("op", ["and", "or"])
def test_a_neutral_truth_value_drops_out(graph, x, y, op):
    condition = graph.call("lt", x, y)
    assert graph.call(op, condition, graph.boolean(op == "and")) == condition


@pytest.mark.parametrize("op", ["and", "or"])
def test_a_dominant_truth_value_decides(graph, x, y, op):
    condition = graph.call("lt", x, y)
    assert graph.call(op, graph.boolean(op == "or"), condition) == graph.boolean(op == "or")


def test_an_unknown_operation_is_our_own_mistake(graph, x):
    with pytest.raises(KeyError, match="gamma"):
        graph.call("gamma", x, x)


# -- walks ----------------------------------------------------------------------------------------


def test_a_walk_gives_operands_before_their_users(graph, x, y, z):
    root = graph.call("select", graph.call("lt", x, y), graph.mul(x, z), graph.add(y, z))
    order = graph.reachable([root])
    place = {node: k for k, node in enumerate(order)}
    pairs = [(place[n], place[o]) for n in order for o in graph.operands(n)]
    assert pairs
    assert all(operand < node for node, operand in pairs)


def test_a_walk_leaves_out_what_the_roots_do_not_need(graph, x, y):
    wanted, unwanted = graph.call("sin", x), graph.call("cos", y)
    order = graph.reachable([wanted])
    assert wanted in order
    assert unwanted not in order
    assert y not in order


def test_a_solve_for_zeros_is_no_solve(graph, x, y):
    assert LinearSystem(graph, [[x, y], [y, x]]).solve([graph.zero] * 2) == [graph.zero] * 2


# -- depth and size -------------------------------------------------------------------------------


def test_squaring_sixty_times_costs_sixty_multiplications(graph, x):
    node = x
    for _ in range(60):
        node = graph.mul(node, node)
    program = on_tape(graph, [node], (1, 0, 0))
    assert program.operation_count["run"] == {"mul": 60}
