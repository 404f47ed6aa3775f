"""Symmetric forms under a rotation in a plane, against the products written out."""

import itertools

import numpy as np
import pytest

from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._mechanics.planes import merged_rotations, plane_rotation_of
from pydy._program.interpret import run

SIGNS = list(itertools.product((1.0, -1.0), repeat=3))


def rotation(graph, angle, signs):
    """Rows of two anchors by the columns 1000 and 1001, and the same as numbers at 0.7."""
    c, s = graph.call("cos", angle), graph.call("sin", angle)
    row, one, two = signs
    values = [
        [one * np.cos(0.7), two * np.sin(0.7)],
        [-row * one * np.sin(0.7), row * two * np.cos(0.7)],
    ]
    nodes = [
        {1000: graph.sum([(c, one)]), 1001: graph.sum([(s, two)])},
        {1000: graph.sum([(s, -row * one)]), 1001: graph.sum([(c, row * two)])},
    ]
    return nodes, np.array(values)


@pytest.mark.parametrize("left", SIGNS)
@pytest.mark.parametrize("right", SIGNS)
def test_a_block_of_the_form_is_turned_on_both_sides(left, right):
    graph = Graph()
    angle = graph.input("x", 0)
    cells = [[graph.input("p", 2 * i + j) for j in range(2)] for i in range(2)]
    turns, matrices = [], []
    for signs in (left, right):
        nodes, values = rotation(graph, angle, signs)
        turns.append(plane_rotation_of(graph, dict(enumerate(nodes)), [0, 1]))
        matrices.append(values)
    image = turns[0].transform(graph, cells, turns[1])
    program = lower(graph, (1, 0, 4), [("image", (4,), [n for row in image for n in row])])
    p = np.array([1.3, -0.4, 2.2, 0.9])
    found, _ = run(program, np.zeros(1), np.array([[0.7]]), np.zeros((1, 0)), p)
    order = [turn.columns[0] - 1000 for turn in turns]
    expected = matrices[0].T @ p.reshape(2, 2) @ matrices[1]
    assert order == [0, 0]
    np.testing.assert_allclose(found.reshape(2, 2), expected, rtol=1e-14)


def test_what_is_no_rotation_has_no_turn():
    graph = Graph()
    q, other = graph.input("x", 0), graph.input("x", 1)
    c, s, wrong = graph.call("cos", q), graph.call("sin", q), graph.call("sin", other)
    for rows in (
        [{8: c, 9: s}, {8: s, 9: c}],
        [{8: c, 9: wrong}, {8: graph.neg(wrong), 9: c}],
        [{8: c, 9: graph.sum([(s, 2.0)])}, {8: graph.sum([(s, -2.0)]), 9: c}],
        [{8: c}, {8: s}],
    ):
        assert plane_rotation_of(graph, dict(enumerate(rows)), [0, 1]) is None


def test_pairs_that_turn_by_one_angle_are_joined_unless_one_is_made_of_the_other():
    graph = Graph()
    c, s = (graph.call(op, graph.input("x", 0)) for op in ("cos", "sin"))

    def pair(x, y):
        return [{x: c, y: s}, {x: graph.neg(s), y: c}]

    apart = dict(enumerate([*pair(100, 101), *pair(102, 103)]))
    assert merged_rotations(graph, [[0, 1], [2, 3]], apart) == [[0, 1, 2, 3]]
    stacked = dict(enumerate([*pair(2, 3), *pair(102, 103)]))
    assert merged_rotations(graph, [[0, 1], [2, 3]], stacked) == [[0, 1], [2, 3]]
