"""Equations in relative speeds become equations in the bodies' own, where that costs less."""

import numpy as np
import pytest

from graphs import on_tape
from pydy._graph.interpret import run
from pydy._graph.node import Graph
from pydy._graph.solve import body_basis as module
from pydy._graph.solve.body_basis import body_basis


def planar_arm(graph, links, inertia=True):
    """Mass matrix and forcing of links with relative angular speeds, in the plane.

    Each link has a mass m at its end, a length l and, with `inertia`, a moment of inertia; the
    angles x between them are relative too.
    """
    n = links
    m, length, moment = ([graph.input("p", g * n + i) for i in range(n)] for g in range(3))
    angles = [graph.sum([(graph.input("x", k), 1.0) for k in range(i + 1)]) for i in range(n)]
    speeds = [graph.sum([(graph.input("x", n + k), 1.0) for k in range(i + 1)]) for i in range(n)]

    def shared(i, j):
        """M in absolute speeds."""
        carried = graph.sum([(m[k], 1.0) for k in range(max(i, j), n)])
        between = graph.call("cos", graph.sub(angles[i], angles[j])) if i != j else graph.one
        value = graph.mul(carried, length[i], length[j], between)
        return graph.add(value, moment[i]) if i == j and inertia else value

    whole = [[shared(i, j) for j in range(n)] for i in range(n)]
    loads = [graph.mul(length[i], graph.call("sin", angles[i]), speeds[i]) for i in range(n)]

    def after(i, j):
        parts = [whole[a][b] for a in range(i, n) for b in range(j, n)]
        return graph.sum([(part, 1.0) for part in parts])

    matrix = [[after(i, j) for j in range(n)] for i in range(n)]
    column = [graph.sum([(part, 1.0) for part in loads[i:]]) for i in range(n)]
    return matrix, column, whole, loads


def numbers(n, m=5):
    rng = np.random.default_rng(n)
    return np.zeros(m), rng.normal(size=(m, 2 * n)), np.empty((1, 0)), rng.uniform(0.5, 2.0, 3 * n)


def values(graph, nodes, n):
    return run(on_tape(graph, nodes, (2 * n, 0, 3 * n)), *numbers(n))[0]


@pytest.mark.parametrize("links", [2, 3, 5])
def test_a_plane_arm_in_relative_speeds_is_one_in_absolute_speeds(links):
    graph = Graph()
    matrix, column, whole, loads = planar_arm(graph, links)
    basis = body_basis(graph, matrix, column)
    assert basis is not None
    found = [basis.matrix[i][j] for i in range(links) for j in range(i + 1)]
    expected = [whole[i][j] for i in range(links) for j in range(i + 1)]
    np.testing.assert_allclose(
        values(graph, found + basis.column, links),
        values(graph, expected + loads, links),
        rtol=1e-12,
        atol=1e-12,
    )
    # All bodies but the first were changed: no moment of inertia is outside the diagonal.
    last = graph.input("p", 3 * links - 1)
    reach = [last in graph.reachable([basis.matrix[i][j]]) for i in range(links) for j in range(i)]
    assert not any(reach)
    assert all(graph.constant[basis.matrix[i][i]] for i in range(1, links))


@pytest.mark.parametrize("most", [8, 64])
@pytest.mark.parametrize("links", [2, 4])
def test_the_given_unknowns_come_back(links, most, monkeypatch):
    # With 8, one body of 4 is left as it is.
    monkeypatch.setattr(module, "LONGEST_BODY_POLYNOMIAL", most)
    graph = Graph()
    matrix, column, _, _ = planar_arm(graph, links)
    lower = [matrix[i][j] for i in range(links) for j in range(links)]
    basis = body_basis(graph, matrix, column)
    assert basis is not None
    second = graph.input("p", 2 * links + 1)  # its moment of inertia
    left = second in graph.reachable([basis.matrix[1][0]])
    assert left is (most == 8 and links == 4)
    y = graph.solve(basis.matrix, [basis.column], "ldl")[0]
    found = values(graph, basis.given_unknowns(y), links)
    given = values(graph, lower + column, links)
    for x, row in zip(found, given, strict=True):
        a, b = row[: links**2].reshape(links, links), row[links**2 :]
        np.testing.assert_allclose(x, np.linalg.solve(a, b), rtol=1e-9)


def test_masses_without_inertia_tell_of_no_body():
    graph = Graph()
    matrix, column, _, _ = planar_arm(graph, 3, inertia=False)
    assert body_basis(graph, matrix, column) is None


def test_absolute_speeds_stay():
    graph = Graph()
    _, _, whole, loads = planar_arm(graph, 4)
    assert body_basis(graph, whole, loads) is None


def test_a_constant_matrix_stays():
    graph = Graph()
    p, zero = [graph.input("p", k) for k in range(3)], graph.zero
    rows = [[p[i] if i == j else zero for j in range(3)] for i in range(3)]
    assert body_basis(graph, rows, [graph.input("x", k) for k in range(3)]) is None
