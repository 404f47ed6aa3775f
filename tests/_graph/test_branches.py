"""What nodes switch at."""

import numpy as np
import pytest

from pydy._graph.branches import Branches
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._program import run


def test_what_a_guard_chooses_by_is_no_switch():
    g = Graph()
    x, y = g.input("x", 0), g.input("x", 1)
    sound = g.call("lt", x, g.one)
    (way,) = LinearSystem(g, [[y]]).guarded([g.call("abs", x)], sound, [g.mul(x, y)])
    assert Branches(g, [way]).switches() == [x]  # of the absolute value alone
    assert len(Branches(g, [g.call("select", sound, x, y)]).switches()) == 1


@pytest.mark.parametrize(
    ("op", "above", "below"),
    [
        ("abs", [-0.5, -0.5], [-0.5, -0.5]),
        ("sign", [1.0, -1.0], [-1.0, 1.0]),
        ("lt", [5.0, 3.0], [3.0, 5.0]),
        ("max", [-0.5, 0.0], [0.0, -0.5]),
    ],
)
def test_a_switch_and_its_negative_have_the_same_sides(op, above, below):
    """Of f(x − 1) and f(1 − x): at x = 0.5 continued from above 1, at x = 1.5 from below."""
    g = Graph()
    x = g.input("x", 0)
    ahead = g.sub(x, g.one)
    nodes = []
    for argument in (ahead, g.neg(ahead)):
        node = g.call(op, argument, *([g.zero] if op in ("lt", "max") else []))
        three, five = g.const(3.0), g.const(5.0)
        nodes.append(g.call("select", node, three, five) if op == "lt" else node)
    branches = Branches(g, nodes)
    (switch,) = {g.scaled(ahead)[1], *branches.switches()}
    sides = branches.sides(switch, bends=True)
    for part, at, expected in zip(sides, (0.5, 1.5), (above, below), strict=True):
        program = lower(g, (1, 0, 0), [("values", (2,), part)])
        arguments = np.zeros(1), np.array([[at]]), np.zeros((1, 0)), np.zeros(0)
        np.testing.assert_array_equal(run(program, *arguments)[0][0], expected)
