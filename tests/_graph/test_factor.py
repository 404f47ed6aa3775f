"""Common factors are taken out of sums of products."""

from graphs import on_tape
from pydy._graph.node import Graph
from pydy._graph.simplification import simplify


def test_a_long_sum_of_running_products_becomes_horners_rule():
    n = 1100  # deeper than Python's recursion goes
    graph = Graph()
    x = [graph.input("x", k) for k in range(n)]
    product, terms = graph.one, []
    for node in x:
        product = graph.mul(product, node)
        terms.append(product)
    program = on_tape(graph, simplify(graph, [graph.add(*terms)]), (n, 0, 0))
    assert program.operation_count["run"] == {"add": n - 1, "mul": n - 1}
