"""A graph and some of its inputs."""

import pytest

from pydy._graph.node import Graph


@pytest.fixture
def graph():
    return Graph()


@pytest.fixture
def x(graph):
    return graph.input("x", 0)


@pytest.fixture
def y(graph):
    return graph.input("x", 1)
