"""Programs: two stages, content digests, operation counts."""

import pickle

import numpy as np
import pytest
import sympy as sm

import graphs
from graphs import P, T, X, nodes_of, on_tape, program_of, solve_program, values
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._graph.passes import rewriting

x, y, z, w = X
a, b, c = P


def total(program, stage="run"):
    return program.operation_count[stage].total()


def inputs(program, stage):
    """Input groups that operations of a stage read."""
    return {
        arguments[0]
        for op, arguments, setup in zip(program.ops, program.args, program.setup, strict=True)
        if op == "input" and setup is (stage == "setup")
    }


# -- two stages -----------------------------------------------------------------------------------


def test_what_depends_on_constants_alone_is_set_up_once():
    program = program_of([sm.exp(a) * sm.sin(b) / sm.sqrt(c)])
    assert total(program, "run") == 0
    assert total(program, "setup") >= 4


@pytest.mark.parametrize("variable", [x, T], ids=str)
def test_what_depends_on_state_or_time_is_computed_at_every_call(variable):
    program = program_of([sm.exp(variable) + sm.sin(variable)])
    assert program.operation_count["run"] == {"exp": 1, "sin": 1, "add": 1}
    assert total(program, "setup") == 0


def test_constant_factors_of_a_product_are_grouped():
    program = program_of([a * x * b * y * c])
    assert program.operation_count["setup"] == {"mul": 2}
    assert program.operation_count["run"] == {"mul": 2}


def test_constant_terms_of_a_sum_are_grouped():
    program = program_of([a + x + b + y + c])
    assert program.operation_count["setup"] == {"add": 2}
    assert program.operation_count["run"] == {"add": 2}


def test_the_setup_stage_reads_constants_only():
    program = program_of([sm.cos(a * b) * x**2 + sm.sin(T) / c])
    assert inputs(program, "setup") == {"p"}
    assert inputs(program, "run") == {"x", "t"}


def test_only_what_the_run_stage_needs_is_carried():
    program = program_of([sm.sin(sm.exp(a)) * x])
    (carried,) = program.carried
    assert program.ops[carried] == "sin"


def test_conditions_on_constants_are_decided_in_the_setup_stage():
    program = program_of([sm.Piecewise((x, a > b), (y, True))])
    assert program.operation_count["setup"] == {"lt": 1}
    assert program.operation_count["run"] == {"select": 1}


def test_operands_come_before_their_users_and_setup_never_needs_a_call():
    program = program_of([sm.atan2(a * x, b + y) ** 3, sm.Max(a, b) * x, c])
    for k, (op, arguments) in enumerate(zip(program.ops, program.args, strict=True)):
        if op not in ("const", "input"):
            assert all(j < k for j in arguments)
            assert not program.setup[k] or all(program.setup[j] for j in arguments)


# -- counts ---------------------------------------------------------------------------------------


def test_a_shared_subexpression_is_counted_once():
    shared = sm.sin(x * y)
    assert program_of([shared, shared * z, shared + z]).operation_count["run"] == {
        "mul": 2,
        "sin": 1,
        "add": 1,
    }


def test_inputs_and_numbers_cost_nothing():
    program = program_of([x, a, sm.Integer(3), T])
    assert (total(program, "run"), total(program, "setup")) == (0, 0)


def test_a_subtraction_counts_as_an_addition():
    assert program_of([x - y]).operation_count["run"] == {"add": 1}


def test_an_integer_power_costs_few_multiplications():
    assert program_of([x**8]).operation_count["run"] == {"mul": 3}


@pytest.mark.parametrize(("n", "mul"), [(3, 8 + 9), (5, 40 + 25)])
def test_an_lu_loop_counts_what_it_executes(n, mul):
    count = solve_program(n, "lu", off=frozenset({"lu"})).operation_count["run"]
    assert count["mul"] == mul
    assert count["div"] == n


def test_an_output_that_nobody_asks_for_costs_nothing():
    graph, (one, other) = nodes_of([sm.sin(x), sm.exp(sm.cos(y))])
    assert on_tape(graph, [one]).operation_count["run"] == {"sin": 1}
    assert other in graph.reachable([other])


def test_simplification_never_costs_operations():
    expressions = [a * x * y + b * x * z + x * w, (x + y) * z + (x + y) * w, x * y * z + a * x * y]
    assert total(program_of(expressions)) < total(program_of(expressions, rewriting()))


# -- blocks ---------------------------------------------------------------------------------------


def test_blocks_lie_one_after_the_other_in_the_flat_output():
    graph, (one, two, three) = nodes_of([x, y, z])
    blocks = [("first", (1,), [three]), ("second", (1, 2), [one, two])]
    program = graphs.lower(graph, graphs.SIZES, blocks)
    second = program.signature.block("second")
    out = values(program, [1.0, 2.0, 3.0, 4.0])
    assert (second.shape, second.start, second.stop) == ((1, 2), 1, 3)
    assert list(out) == [3.0, 1.0, 2.0]


def test_a_block_whose_shape_does_not_fit_is_our_own_mistake():
    graph, (node,) = nodes_of([x])
    with pytest.raises(AssertionError, match="wrong"):
        graphs.lower(graph, graphs.SIZES, [("wrong", (2,), [node])])


# -- digests --------------------------------------------------------------------------------------

EXPRESSIONS = [a * sm.sin(x) + b * y, sm.Piecewise((x, y > 0), (2, True)), 3 * x / (1 + z**2)]


@pytest.mark.parametrize(
    "other",
    [
        [*EXPRESSIONS[:2], sm.Float(3.0000000000000004) * x / (1 + z**2)],
        [a * sm.sin(x) + c * y, *EXPRESSIONS[1:]],
        [a * sm.cos(x) + b * y, *EXPRESSIONS[1:]],
        EXPRESSIONS[::-1],
        EXPRESSIONS[:2],
    ],
    ids=["last bit of a number", "another constant", "another function", "order", "fewer outputs"],
)
def test_whatever_changes_the_result_changes_the_digest(other):
    assert program_of(other).digest != program_of(EXPRESSIONS).digest


def test_the_number_of_inputs_is_part_of_the_digest():
    graph, nodes = nodes_of([x])
    assert on_tape(graph, nodes, (4, 0, 3)).digest != on_tape(graph, nodes, (4, 1, 3)).digest


def test_the_names_of_the_blocks_are_part_of_the_digest():
    graph, (node,) = nodes_of([x])
    one, other = (graphs.lower(graph, graphs.SIZES, [(name, (1,), [node])]) for name in "ab")
    assert one.digest != other.digest


def test_the_names_of_the_symbols_are_not_part_of_the_digest():
    def build(symbol):
        graph = Graph()
        read = graphs.SymPyReader(graph, {symbol: graph.input("x", 0)})
        return on_tape(graph, [read(sm.sin(symbol) * 2)], (1, 0, 0)).digest

    assert build(sm.Symbol("alpha")) == build(sm.Symbol("zeta"))


def test_what_else_the_graph_holds_is_not_part_of_the_digest():
    graph, (node,) = nodes_of([sm.sin(x) * y])
    crowded = Graph()
    crowded.input("x", 0)
    nodes_of([x + y, sm.cos(z)], crowded)
    _, (same,) = nodes_of([sm.sin(x) * y], crowded)
    assert on_tape(graph, [node]).digest == on_tape(crowded, [same]).digest


def test_a_pickled_program_keeps_its_digest_and_its_values():
    program = program_of(EXPRESSIONS)
    copy = pickle.loads(pickle.dumps(program))
    point = [0.3, -0.4, 0.5, 0.6], [1.1, 1.2, 1.3]
    assert copy.digest == program.digest
    assert copy.operation_count == program.operation_count
    np.testing.assert_array_equal(values(copy, *point), values(program, *point))


def test_what_two_fallbacks_share_is_computed_by_each_and_by_no_call():
    g = Graph()
    shared, nodes = g.call("exp", g.input("x", 0)), []
    for k in (1, 2):
        pivot = g.input("x", k)
        nodes += LinearSystem(g, [[pivot]]).guarded([shared], g.call("lt", g.zero, pivot), [pivot])
    program = on_tape(g, nodes, (3, 0, 0))
    assert "exp" not in program.operation_count["run"]
    assert program.ops.count("exp") == 2
