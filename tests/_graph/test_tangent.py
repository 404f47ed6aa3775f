"""Tangents: Jacobians in parts, which columns make one, and that they are those of the whole."""

from collections import Counter

import numpy as np
import pytest

import zoo
from pydy._assembly.programs import jacobian_program
from pydy._graph.node import Graph
from pydy._graph.tangent import jacobian_tangent, parts_of, supports, worthwhile_parts
from pydy._graph.tuning import COLUMNS_TOGETHER, FROM_OPERATIONS
from pydy._program.interpret import run
from pydy._program.program import Program
from pydy._program.serialization import program_from_bytes, program_to_bytes
from pydy._program.tangent import Tangent
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo.cases import system_of


def assembly_of(system):
    system.generate_ode_function()
    return system.model.assembly


def in_parts(assembly, parts=None):
    n = assembly.sizes[0]
    graph, nodes = assembly.simplified("rates")
    if parts is None:
        parts = worthwhile_parts(graph, nodes, [graph.input("x", k) for k in range(n)])
    places = [("x", k) for k in range(n)]
    return jacobian_tangent(graph, nodes, places, assembly.sizes, parts)


def evaluated(jacobian, t, x, r, p):
    """The columns of all parts by the interpreter, along one unit vector after the other."""
    out = np.zeros(jacobian.shape)
    values, _ = run(jacobian.shared, t, x, r, p)
    for part in jacobian.parts:
        for j, unit in enumerate(np.eye(part.count)):
            column = run(part.program, t, unit[None], values, np.zeros(0))[0][0]
            out[:, part.first + j] = column
    return out


@pytest.mark.parametrize("name", ["fourbar", "disc", "gyro", "sleigh", "lifted"])
@pytest.mark.parametrize("cut", [None, 2])
def test_columns_in_parts_are_those_of_the_whole(name, cut):
    assembly = assembly_of(system_of(getattr(zoo, name)()))
    n, s, c = assembly.sizes
    parts = [(0, n)] if cut is None else [(0, cut), (cut, n)]
    rng = np.random.default_rng(3)
    arguments = (
        np.array([0.3]),
        rng.uniform(0.3, 1.2, (1, n)),
        rng.uniform(size=(1, s)),
        rng.uniform(0.5, 1.5, c),
    )
    expected = run(jacobian_program(assembly, "rates", "x"), *arguments)[0].reshape(n, n)
    made = in_parts(assembly, parts)
    assert np.allclose(evaluated(made, *arguments), expected, rtol=1e-10, atol=1e-10)
    out = run(made.written_out(), *arguments)[0].reshape(n, n)
    assert np.allclose(out, expected, rtol=1e-10, atol=1e-10)


def test_columns_that_depend_on_nothing_belong_to_no_part():
    parts = parts_of(Counter({0b0111100: 3, 0b0011000: 2}), 9)
    assert parts == [(2, 6)]


def test_a_part_has_whole_vectors():
    assert parts_of(Counter({0b100000000: 7}), 9) == [(9 - COLUMNS_TOGETHER, 9)]
    assert parts_of(Counter({0b1: 7}), 9) == [(0, COLUMNS_TOGETHER)]
    assert parts_of(Counter(), 9) == []


def test_columns_that_execute_much_less_are_a_part_of_their_own():
    left, both = 0b1111, 0b11111111
    assert parts_of(Counter({left: 1000, both: 10}), 8) == [(0, 4), (4, 8)]
    assert parts_of(Counter({left: 10, both: 1000}), 8) == [(0, 8)]


def test_the_cost_of_columns_is_counted_for_those_that_pay():
    graph = Graph()
    a, b, c = (graph.input("x", k) for k in range(3))
    angle = graph.call("sin", graph.mul(a, b))
    cost = supports(graph, [graph.add(angle, c)], [a, b, c])
    # a·b by a, by b; sin by both; the sum by both and by c
    assert cost == {0b001: 1, 0b010: 1, 0b011: 2, 0b100: 1}


def test_a_variable_that_is_an_output_itself_has_a_column():
    graph = Graph()
    x = [graph.input("x", k) for k in range(6)]
    cost = supports(graph, [x[0], x[5], graph.mul(x[1], x[2])], x)
    assert cost == {0b000001: 1, 0b000010: 1, 0b000100: 1, 0b100000: 1}


def test_small_jacobians_are_not_divided():
    graph = Graph()
    x = [graph.input("x", k) for k in range(8)]
    assert worthwhile_parts(graph, [graph.product([(k, 1) for k in x])], x) == []
    assert FROM_OPERATIONS > 8


def test_columns_that_share_nothing_are_not_divided():
    graph = Graph()
    x = [graph.input("x", k) for k in range(8)]
    nodes = x
    for _ in range(FROM_OPERATIONS):
        nodes = [graph.call("sin", node) for node in nodes]
    assert worthwhile_parts(graph, nodes, x) == []


def test_a_long_chain_takes_a_fraction_of_the_code():
    """Operations to compile, those of each part once, and operations of all columns."""
    assembly = assembly_of(n_link_pendulum_on_cart(20))
    made = in_parts(assembly)
    code = [p.program.operation_count["run"].total() for p in made.parts]
    shared = made.shared.operation_count["run"].total()
    whole = jacobian_program(assembly, "rates", "x").operation_count["run"].total()
    assert 2.3 * (shared + sum(code)) < whole
    blocks = [-(-part.count // COLUMNS_TOGETHER) for part in made.parts]
    assert 1.8 * (shared + np.dot(code, blocks)) < whole


def test_the_code_for_a_row_of_masses_grows_in_proportion():
    code = {}
    for n in (20, 40):
        made = in_parts(assembly_of(multi_mass_spring_damper(n)))
        code[n] = sum(p.program.operation_count["run"].total() for p in made.parts)
    assert code[40] <= 2.5 * code[20]


def test_a_jacobian_is_written_and_read_again():
    made = in_parts(assembly_of(n_link_pendulum_on_cart(3)))
    restored = program_from_bytes(program_to_bytes(made))
    assert isinstance(restored, Tangent)
    assert restored.digest == made.digest
    assert restored.signature == made.signature
    assert restored.shape == (8, 8)
    assert isinstance(restored.shared, Program)


def test_all_parts_are_printed_and_counted():
    made = in_parts(assembly_of(n_link_pendulum_on_cart(3)))
    text = str(made)
    for part in made.parts:
        assert f"For each of the columns {part.first} to {part.first + part.count - 1}:" in text
    own = [part.count * part.program.operation_count["run"].total() for part in made.parts]
    shared = made.shared.operation_count["run"].total()
    assert made.operation_count["run"].total() == shared + sum(own)
