"""The coefficients, by the conditions that define them."""

from functools import cache
from math import prod

import numpy as np
import pytest

from pydy.solvers.tableaus import radau, tableau_of
from registry import EXPLICIT_NAMES, SOLVER_FACTS

METHODS = EXPLICIT_NAMES
ESTIMATES = [
    (name, which, order)
    for name, facts in SOLVER_FACTS.items()
    for which, order in enumerate(facts.estimates)
]
THETAS = np.linspace(0.0, 1.0, 9)


@cache
def partitions(n):
    """Multisets of rooted trees with n nodes together."""
    if n == 0:
        return [()]
    found = set()
    for first in range(1, n + 1):
        for tree in trees(first):
            for rest in partitions(n - first):
                found.add(tuple(sorted((tree, *rest))))
    return sorted(found)


@cache
def trees(order):
    """All rooted trees; a tree is the tuple of its branches."""
    return partitions(order - 1)


def size(tree):
    return 1 + sum(map(size, tree))


def density(tree):
    return size(tree) * prod(map(density, tree))


def full(rows, width):
    table = np.zeros((len(rows), width))
    for k, row in enumerate(rows):
        for stage, value in row.items():
            table[k, stage] = value
    return table


@cache
def matrix(name):
    """The stages, the derivative at the end of the step, and the stages of the interpolant."""
    tableau = tableau_of(name)
    rows = (*tableau.stages, tableau.weights, *tableau.dense_stages)
    return full(rows, len(rows))


def weight(A, tree):
    """The elementary weight of each stage."""
    result = np.ones(len(A))
    for branch in tree:
        result = result * (A @ weight(A, branch))
    return result


def all_trees(order):
    return [tree for n in range(1, order + 1) for tree in trees(n)]


def defects(row, A, order, theta=1.0):
    """By how much a row misses each order condition."""
    scale = np.abs(row)
    found = []
    for tree in all_trees(order):
        w = weight(A, tree)
        found.append((row @ w - theta ** size(tree) / density(tree)) / max(1.0, scale @ np.abs(w)))
    return np.abs(found)


def interpolant(name, theta):
    """The weights of the stages at θ."""
    tableau = tableau_of(name)
    step, *further = full((tableau.weights, *tableau.interpolant), len(matrix(name)))
    start, end = np.eye(len(step))[[0, len(tableau.stages)]]
    first = start - step
    rows = np.array([step, first, step - first - end, *further])
    total = np.zeros(rows.shape[1])
    for level in range(len(rows) - 1, -1, -1):
        total = (theta if level % 2 == 0 else 1.0 - theta) * (rows[level] + total)
    return total


def test_there_are_as_many_rooted_trees_as_published():
    # OEIS A000081
    assert [len(trees(n)) for n in range(1, 10)] == [1, 1, 2, 4, 9, 20, 48, 115, 286]


@pytest.mark.parametrize("name", METHODS)
def test_each_row_sums_to_its_node(name):
    np.testing.assert_allclose(matrix(name).sum(axis=1), tableau_of(name).nodes, atol=2e-14)


@pytest.mark.parametrize("name", METHODS)
def test_stages_depend_on_earlier_ones_only(name):
    assert not np.triu(matrix(name)).any()


@pytest.mark.parametrize("name", METHODS)
def test_the_step_fulfils_every_order_condition_of_its_order(name):
    tableau = tableau_of(name)
    row = full([tableau.weights], len(matrix(name)))[0]
    assert defects(row, matrix(name), tableau.order).max() < 1e-14
    assert defects(row, matrix(name), tableau.order + 1).max() > 1e-8


@pytest.mark.parametrize(("name", "which", "order"), ESTIMATES)
def test_an_estimate_vanishes_up_to_its_order_and_not_beyond(name, which, order):
    tableau = tableau_of(name)
    row = full([tableau.errors[which]], len(matrix(name)))[0]
    A = matrix(name)
    wrong = [abs(row @ weight(A, tree)) for tree in all_trees(order)]
    assert max(wrong) < 1e-14
    assert max(abs(row @ weight(A, tree)) for tree in trees(order + 1)) > 1e-8


@pytest.mark.parametrize("name", METHODS)
def test_the_interpolant_fulfils_every_order_condition_of_its_order(name):
    A, order = matrix(name), SOLVER_FACTS[name].interpolant
    for theta in THETAS:
        assert defects(interpolant(name, theta), A, order, theta).max() < 1e-13
    assert defects(interpolant(name, 0.3), A, order + 1, 0.3).max() > 1e-9


@pytest.mark.parametrize("name", METHODS)
def test_the_interpolant_begins_and_ends_where_the_step_does(name):
    tableau = tableau_of(name)
    step = full([tableau.weights], len(matrix(name)))[0]
    assert not interpolant(name, 0.0).any()
    np.testing.assert_array_equal(interpolant(name, 1.0), step)


@pytest.mark.parametrize("name", METHODS)
def test_the_interpolants_slopes_are_the_derivatives_at_both_ends(name):
    ends = np.zeros((2, len(matrix(name))))
    ends[0, 0] = ends[1, len(tableau_of(name).stages)] = 1.0
    # The derivative of a polynomial of degree at most 9, exactly, from 10 points.
    nodes = 0.5 - 0.5 * np.cos(np.pi * (np.arange(10) + 0.5) / 10)
    values = np.array([interpolant(name, theta) for theta in nodes])
    slopes = np.polynomial.polynomial.Polynomial.fit
    for k in range(values.shape[1]):
        curve = slopes(nodes, values[:, k], 9, domain=[0.0, 1.0]).deriv()
        scale = max(1.0, np.abs(values[:, k]).max())
        assert abs(curve(0.0) - ends[0, k]) < 1e-11 * scale
        assert abs(curve(1.0) - ends[1, k]) < 1e-11 * scale


def collocation_matrix():
    """Radau IIA's matrix: integrals of Lagrange's polynomials on its nodes."""
    nodes = np.array(radau.NODES)
    powers = np.vander(nodes, 3, increasing=True)
    integrals = np.array([[c ** (k + 1) / (k + 1) for k in range(3)] for c in nodes])
    return integrals @ np.linalg.inv(powers)


def test_radaus_nodes_are_those_of_its_quadrature():
    weights = collocation_matrix()[-1]
    for k in range(5):
        assert abs(weights @ np.array(radau.NODES) ** k - 1 / (k + 1)) < 1e-15


def test_radaus_transformation_makes_the_inverse_matrix_block_diagonal():
    T, TI, a, b = np.array(radau.T), np.array(radau.TI), radau.COMPLEX.real, radau.COMPLEX.imag
    blocks = np.zeros((3, 3))
    blocks[0, 0] = radau.REAL
    blocks[1:, 1:] = [[a, -b], [b, a]]
    np.testing.assert_allclose(TI @ T, np.eye(3), atol=1e-14)
    np.testing.assert_allclose(TI @ np.linalg.inv(collocation_matrix()) @ T, blocks, atol=1e-13)


def test_radaus_interpolant_goes_through_its_stages():
    powers = np.array([[c**k for k in (1, 2, 3)] for c in radau.NODES])
    np.testing.assert_allclose(powers @ np.array(radau.INTERPOLANT).T, np.eye(3), atol=1e-13)


def test_radaus_estimate_vanishes_for_cubics():
    nodes, error = np.array(radau.NODES), np.array(radau.ERROR)
    assert abs(1.0 + error @ nodes) < 1e-14
    assert abs(error @ nodes**2) < 1e-14
    assert abs(error @ nodes**3) < 1e-14
    assert abs(error @ nodes**4) > 1e-3
