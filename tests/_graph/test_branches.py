"""What nodes switch at."""

from pydy._graph.branches import Branches
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph


def test_what_a_guard_chooses_by_is_no_switch():
    g = Graph()
    x, y = g.input("x", 0), g.input("x", 1)
    sound = g.call("lt", x, g.one)
    (way,) = LinearSystem(g, [[y]]).guarded([g.call("abs", x)], sound, [g.mul(x, y)])
    assert Branches(g, [way]).switches() == [x]  # of the absolute value alone
    assert len(Branches(g, [g.call("select", sound, x, y)]).switches()) == 1
