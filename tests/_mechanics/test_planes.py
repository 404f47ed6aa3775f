"""Plane rotations that a rotation is made of, and what is handed on by them."""

import itertools

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._graph.from_sympy import SymPyReader
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._mechanics.planes import IntermediateFrames, plane_rotations, split
from pydy._program.interpret import run

SEQUENCES = ["".join(s) for s in itertools.product("123", repeat=3) if s[0] != s[1] != s[2]]
Q = me.dynamicsymbols("q:3")


def read(matrix):
    graph = Graph()
    reader = SymPyReader.of_inputs(graph, "the matrix", x=Q)
    return graph, [[reader(matrix[i, j]) for j in range(3)] for i in range(3)]


def values(graph, matrices):
    nodes = [n for m in matrices for row in m for n in row]
    program = lower(graph, (3, 0, 0), [("all", (len(nodes),), nodes)])
    found, _ = run(
        program, np.zeros(1), np.array([[0.3, 1.1, -0.7]]), np.zeros((1, 0)), np.zeros(0)
    )
    return found.reshape(-1, 3, 3)


@pytest.mark.parametrize("kind", ["body", "space"])
@pytest.mark.parametrize("sequence", SEQUENCES)
def test_a_rotation_by_three_angles_is_three_plane_ones(kind, sequence):
    inner, outer = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    getattr(outer, f"orient_{kind}_fixed")(inner, Q, sequence)
    graph, matrix = read(outer.dcm(inner))
    first, middle, last = plane_rotations(graph, matrix)
    whole, one, two, three = values(graph, [matrix, first, middle, last])
    np.testing.assert_allclose(three @ two @ one, whole, atol=1e-15)
    for plane in (one, two, three):
        assert sorted(np.count_nonzero(plane, axis=0)) == [1, 2, 2]


def test_two_hinges_in_a_row_are_two_plane_rotations():
    inner, middle, outer = map(me.ReferenceFrame, "ABC")
    middle.orient_axis(inner, inner.x, Q[0])
    outer.orient_axis(middle, middle.y, Q[1])
    graph, matrix = read(outer.dcm(inner))
    found = plane_rotations(graph, matrix)
    assert len(found) == 2
    whole, one, two = values(graph, [matrix, *found])
    np.testing.assert_allclose(two @ one, whole, atol=1e-15)


@pytest.mark.parametrize(
    "matrix",
    [
        sm.Matrix(3, 3, lambda i, j: sm.sin(Q[0]) if (i, j) == (2, 0) else Q[1] + i * j),
        sm.Matrix([[1, 0, 0], [0, sm.cos(Q[0]), sm.sin(Q[0])], [0, -sm.sin(Q[0]), sm.cos(Q[0])]]),
        sm.eye(3),
    ],
    ids=["no rotation", "a hinge", "none"],
)
def test_other_matrices_are_left_as_they_are(matrix):
    graph, nodes = read(matrix)
    assert plane_rotations(graph, nodes) == [nodes]


def test_only_what_is_made_of_changing_anchors_with_three_components_is_handed_on_in_planes():
    graph = Graph()
    changing, constant = graph.input("x", 0), graph.input("p", 0)
    outer = {1: {11: changing, 12: changing, 13: changing}}
    inner = {11: {21: constant, 22: constant, 23: constant}, 12: {24: constant}}
    intermediate_frames = IntermediateFrames(rows={key: {} for key in (1, 11, 12)})
    assert intermediate_frames.paying(graph, [[1], [11], [12]], outer | inner) == {11}


def test_groups_are_split_into_what_turns_and_what_does_not():
    rows = {1: {7: 0, 8: 0}, 2: {7: 0, 8: 0}, 3: {9: 0}, 4: {9: 0}}
    assert split([[1, 2, 3], [4]], rows, {1, 2, 3}) == [[1, 2], [3], [4]]


def test_groups_between_two_frames_come_before_the_first_that_is_handed_on_there():
    intermediate_frames = IntermediateFrames(stages={("A", "B"): (1, [[[5], [6]], [[7]]])})
    assert intermediate_frames.arranged([[1], [2], [3]]) == [[1], [5], [6], [7], [2], [3]]
