"""Nodes written as SymPy, and read again."""

import numpy as np
import pytest
import sympy as sm

from pydy._graph.from_sympy import SymPyReader
from pydy._graph.node import Graph
from pydy._mechanics.to_sympy import exact, written
from pydy._mechanics.trigonometric import Textbook, TooLongError
from pydy._program.operations import SHIPPED

A, B, C = sm.symbols("a b c")


def read(expressions):
    graph = Graph()
    reader = SymPyReader.of_inputs(graph, "the expressions", x=[A, B, C])
    nodes = reader.all(expressions)
    return graph, nodes, {node: symbol for symbol, node in reader.atoms.items()}


def name(op, expression):
    return sm.Symbol(f"{op}_{str(expression).replace(' ', '')}")


EXPRESSIONS = [
    sm.Rational(1, 12) * A * B**2 - 2.5 * C / A,
    sm.sqrt(A + B) * sm.exp(-C) + sm.atan2(A, B),
    sm.Max(A, B) - sm.Min(B, C) + sm.Abs(A - B) * sm.sign(C),
    sm.Piecewise((A, (A < B) & (C > 0)), (B**C, True)),
    sm.cos(A + B) * sm.cos(A - B) + sm.sin(A) ** 3 / (1 + sm.cos(B) ** 2),
    (sm.sin(2 * A - B) + sm.tan(C)) ** 2 * sm.sin(0.5 * A),
    sm.cos(A) * (sm.sin(B) / sm.cos(A) + C) ** 2 + 1 / (3 + (2 * sm.cos(A) + B) / sm.cos(A)),
    B / (2 * sm.Mul(sm.cos(A), 1 / (sm.cos(A) + 0 * B), evaluate=False)),
]


@pytest.mark.parametrize("textbook", [False, True])
@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_what_is_written_has_the_same_values(expression, textbook):
    graph, nodes, symbols = read([expression])
    if textbook:
        write = Textbook(graph, symbols, name)
        (found,), names = write(nodes), write.names
    else:
        (found,), names = written(graph, nodes, symbols, name)
    for symbol, meaning in reversed(names.items()):
        found = found.subs(symbol, meaning)
    numbers = dict(zip((A, B, C), (0.7, 0.4, 1.3), strict=True))
    assert float(found.subs(numbers)) == pytest.approx(float(expression.subs(numbers)), rel=1e-13)


def test_every_operation_with_a_name_in_sympy_is_written():
    graph = Graph()
    inputs = [graph.input("x", k) for k in range(3)]
    symbols = dict(zip(inputs, (A, B, C), strict=True))
    values = np.array([0.3, 0.6, 0.9])
    for op, row in SHIPPED.items():
        arguments = inputs[: row.arity]
        if not row.truth and op not in ("select", "add", "sub", "mul", "div"):
            node = graph.call(op, *arguments)
            (found,), _ = written(graph, [node], symbols)
            at = dict(zip(inputs, np.full((3, 1), values[:, None] + (op == "acosh")), strict=True))
            expected = graph.evaluator([node])(at, 1)[0, 0]
            given = dict(zip((A, B, C), values + (op == "acosh"), strict=True))
            assert float(found.subs(given)) == pytest.approx(expected, rel=1e-14), op


@pytest.mark.parametrize(
    ("expression", "shortest"),
    [
        (sm.cos(A) * sm.cos(B) - sm.sin(A) * sm.sin(B), "cos_a+b"),
        (sm.sin(A) ** 2 + sm.cos(A) ** 2 - 1, "0"),
        (C * sm.sin(A) ** 2, "c*sin_a**2"),
        (C * B - C * B * sm.cos(A) ** 2 + C, "c*(b*sin_a**2 + 1)"),
        (2 * C * sm.sin(A) * sm.cos(A), "c*sin_2*a"),
        (B * sm.cos(A) * (C / sm.cos(A) + C), "b*c*(cos_a + 1)"),
        (A * C + B * C - C**2, "a*c + b*c - c**2"),
    ],
)
def test_the_shortest_of_equal_forms_is_taken(expression, shortest):
    graph, nodes, symbols = read([expression])
    (found,) = Textbook(graph, symbols, name)(nodes)
    assert str(found) == shortest


def test_what_nobody_reads_is_refused():
    graph, nodes, symbols = read([(A + B + C + sm.cos(A) + sm.sin(B)) ** 40])
    with pytest.raises(TooLongError):
        Textbook(graph, symbols, name)(nodes)


def test_numbers_are_fractions_where_they_are_written_as_such():
    assert exact(1 / 12) == sm.Rational(1, 12)
    assert exact(0.3) == sm.Rational(3, 10)
    assert exact(0.1 + 0.2) == sm.Float("0.3")
    assert exact(9.81) == sm.Float("9.81")
    assert exact(-4.0) == sm.Integer(-4)
