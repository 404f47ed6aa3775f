"""The table of operations: one row is all that an operation needs."""

import math

import numpy as np
import pytest
import sympy as sm

from graphs import ELEMENTARY, on_tape
from pydy._backends.c.cython_ import CythonBackend
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.numpy_ import NumPyBackend
from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.identities import signatures
from pydy._graph.node import Graph
from pydy._program.of_scipy import DESCRIPTIONS
from pydy._program.operations import OPERATIONS, Operation, register


class cbrt(sm.Function):  # noqa: N801 - as SymPy names its functions
    """The real cube root, as a user would add it."""


class below(sm.Function):  # noqa: N801
    """A comparison under another name."""


@pytest.fixture
def more_operations():
    before, truths, named = dict(OPERATIONS), set(OPERATIONS.truths), dict(OPERATIONS._of_sympy)
    register(
        Operation(
            "cbrt",
            1,
            np.cbrt,
            "cbrt({0})",
            "libm cbrt",
            partials=lambda g, n, x: (g.product([(n, -2)], 1 / 3),),
            parity=-1,
            sympy="cbrt",
        )
    )
    register(
        Operation(
            "below", 2, np.less, "{0} < {1}", "comparison olt", truth=True, sympy="below"
        )
    )  # fmt: skip
    yield
    for table, old in ((OPERATIONS, before), (OPERATIONS._of_sympy, named)):
        table.clear()
        table.update(old)
    OPERATIONS.truths.intersection_update(truths)


@pytest.mark.usefixtures("more_operations")
@pytest.mark.parametrize(
    "backend", [NumPyBackend, LLVMBackend, lambda: LLVMBackend(lanes=4), CythonBackend]
)
def test_an_operation_of_one_row_is_read_differentiated_and_compiled(backend):
    x, y = sm.symbols("x y")
    graph = Graph()
    inputs = [graph.input("x", k) for k in range(2)]
    read = SymPyReader(graph, dict(zip((x, y), inputs, strict=True)))
    root = read(cbrt(x * y - 8) + cbrt(x))
    (slopes,) = jacobian(graph, [root], inputs)
    choice = graph.call("select", graph.call("below", *inputs), graph.one, inputs[1])
    program = on_tape(graph, [root, slopes[0], slopes[1], choice], (2, 0, 0))
    kernel = backend().compile(program)
    points = np.array([[1.0, 16.0], [27.0, -3.0], [0.5, 0.25], [2.0, 2.5], [1.5, 7.0]])
    values, failed = kernel.evaluate(np.zeros(5), points, np.empty((5, 0)), np.empty(0))
    a, b = points.T
    inner = np.cbrt(a * b - 8) ** -2 / 3
    assert not failed.any()
    np.testing.assert_allclose(values[:, 0], np.cbrt(a * b - 8) + np.cbrt(a), rtol=1e-14)
    np.testing.assert_allclose(values[:, 1], b * inner + np.cbrt(a) ** -2 / 3, rtol=1e-14)
    np.testing.assert_allclose(values[:, 2], a * inner, rtol=1e-14)
    np.testing.assert_array_equal(values[:, 3], np.where(a < b, 1.0, b))


@pytest.mark.usefixtures("more_operations")
def test_an_odd_function_of_a_table_lets_signs_out():
    graph = Graph()
    a, b = (graph.input("x", k) for k in range(2))
    forth, back = graph.call("cbrt", graph.sub(a, b)), graph.call("cbrt", graph.sub(b, a))
    assert back == graph.neg(forth)
    assert graph.value(graph.call("cbrt", graph.const(-8.0))) == -2.0
    assert len(set(signatures(graph, [forth, graph.call("cbrt", a)]))) == 2


@pytest.mark.parametrize(
    "backend", [NumPyBackend, LLVMBackend, lambda: LLVMBackend(lanes=4), CythonBackend]
)
def test_error_functions_are_those_of_the_c_library(backend):
    x = sm.Symbol("x")
    graph = Graph()
    node = graph.input("x", 0)
    read = SymPyReader(graph, {x: node})
    roots = [read(sm.erf(x)), read(sm.erfc(x)), read(sm.erf(-x))]
    slopes = [row[0] for row in jacobian(graph, roots[:2], [node])]
    kernel = backend().compile(on_tape(graph, [*roots, *slopes], (1, 0, 0)))
    points = np.array([-6.5, -1.0, -1e-9, 0.0, 0.3, 0.84, 2.0, 3.0, 26.0])
    times, none = np.zeros(len(points)), np.empty((len(points), 0))
    values, _ = kernel.evaluate(times, points[:, None], none, np.empty(0))
    bell = 2.0 / np.sqrt(np.pi) * np.exp(-(points**2))
    columns = [[f(v) for v in points] for f in (math.erf, math.erfc, lambda v: -math.erf(v))]
    expected = np.transpose([*columns, bell, -bell])
    np.testing.assert_allclose(values, expected, rtol=2e-15, atol=0.0)


def test_every_row_has_what_back_ends_need():
    from pydy._backends.llvm.emit import Emitter

    for name, row in OPERATIONS.items():
        assert row.name == name
        if name in DESCRIPTIONS:  # functions of SciPy that other tests have read
            continue
        assert hasattr(Emitter, f"_{row.llvm.partition(' ')[0]}")
        assert row.c.format(*"abc"[: row.arity]) != row.c
        with np.errstate(invalid="ignore"):
            result = row.numpy(*[np.full(2, 0.5)] * row.arity)
        assert result.shape == (2,)
    assert {"add", "sin", "pow", "select", "not"} <= ELEMENTARY


@pytest.mark.parametrize(
    ("op", "args", "nodes"),
    [
        ("const", (1.5,), ()),
        ("input", ("x", 3), ()),
        ("sum", (1.0, ((3, 2.0), (5, -1.0))), (3, 5)),
        ("prod", ((3, 2), (5, -1)), (3, 5)),
        ("factor", ("lu", 1, (4,)), (4,)),
        ("solve", (6, (4, 5)), (6, 4, 5)),
        ("guard", (1, (1,), (2,), 3, (4,)), (1, 2, 3, 4)),
        ("item", (6, 1), (6,)),
        ("atan2", (2, 3), (2, 3)),
    ],
)
def test_operands_are_found_and_replaced_whatever_else_the_arguments_hold(op, args, nodes):
    assert tuple(OPERATIONS.operands(op, args)) == nodes
    moved = OPERATIONS.with_operands(op, args, {n: n + 10 for n in nodes})
    assert tuple(OPERATIONS.operands(op, moved)) == tuple(n + 10 for n in nodes)
    assert OPERATIONS.with_operands(op, moved, {n + 10: n for n in nodes}) == args
