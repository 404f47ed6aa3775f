"""Programs from SymPy expressions or bare nodes, without a mechanical system around them."""

import numpy as np
import sympy as sm

from pydy._assembly.assembly import Assembly, EquationBlocks
from pydy._assembly.programs import block_program
from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.solve.ldl import UnrolledLDL
from pydy._mechanics.equation_graph import EquationGraph
from pydy._mechanics.formulations import forms
from pydy._mechanics.multibody import Multibody
from pydy._program.interpret import run
from pydy._program.operations import OPERATIONS
from pydy._program.program import Program, Tape

__all__ = [
    "BINARY",
    "COMPARISONS",
    "ELEMENTARY",
    "UNARY",
    "P",
    "T",
    "X",
    "derivatives",
    "evaluate",
    "everything",
    "form",
    "nodes_of",
    "on_tape",
    "program_of",
    "solve_program",
    "solves",
    "values",
]

X = sm.symbols("x0:4")
P = sm.symbols("p0:3")
T = sm.Symbol("t")
SIZES = (len(X), 0, len(P))

ELEMENTARY = frozenset(OPERATIONS)
_ARITHMETIC = {"add", "sub", "mul", "div", "neg", "select"}
_FUNCTIONS = {k: row for k, row in OPERATIONS.items() if not row.truth and k not in _ARITHMETIC}
UNARY = {name: row.numpy for name, row in _FUNCTIONS.items() if row.arity == 1}
BINARY = {name: row.numpy for name, row in _FUNCTIONS.items() if row.arity == 2}
COMPARISONS = {name: OPERATIONS[name].numpy for name in ("lt", "le", "eq", "ne")}


def nodes_of(expressions, graph=None):
    """A graph and the nodes of expressions in X, P and T."""
    graph = Graph() if graph is None else graph
    return graph, SymPyReader.of_inputs(graph, "the expressions", t=[T], x=X, p=P).all(expressions)


def on_tape(graph, nodes, sizes=SIZES):
    """The Program of nodes as they are."""
    return lower(graph, sizes, [("values", (len(nodes),), nodes)])


def program_of(expressions, off=frozenset()):
    """The Program of expressions in X, P and T, on the way that a system's equations take."""
    graph, nodes = nodes_of(expressions, Graph(off))
    assembly = Assembly(graph, SIZES, EquationBlocks([], [], list(nodes)))
    return block_program(assembly, "outputs")


def values(program, x=(), p=(), t=0.0, kernel=None):
    """Outputs at one state; without a Kernel, from the interpreter."""
    sweep = (lambda *a: run(program, *a)) if kernel is None else kernel.evaluate
    x = np.resize(np.asarray(x, dtype=float), (1, program.signature.num_states)) if len(x) else None
    if x is None:
        x = np.zeros((1, program.signature.num_states))
    p = np.resize(np.asarray(p, dtype=float), program.signature.num_constants) if len(p) else None
    if p is None:
        p = np.zeros(program.signature.num_constants)
    out, _ = sweep(np.array([float(t)]), x, np.empty((1, 0)), p)
    return out[0]


def evaluate(expression, *x):
    """One expression in X at one state, from the interpreter."""
    return float(values(program_of([expression]), x)[0])


def solve_program(n, kind, columns=1, off=frozenset()):
    """The Program that solves A · X = B; A row-major, then B column by column, are the state."""
    graph = Graph(off)
    matrix = [[graph.input("x", i * n + j) for j in range(n)] for i in range(n)]
    right = [[graph.input("x", (n + c) * n + i) for i in range(n)] for c in range(columns)]
    nodes = [k for column in right for k in LinearSystem(graph, matrix, kind).solve(column)]
    return on_tape(graph, nodes, (n * (n + columns), 0, 0))


_AWKWARD = [0.1, -2.5, 3.0, 1e20, 5e-324, np.inf, -np.inf, np.nan]


def _operations(tape, a, b):
    """All elementary operations on two values."""
    compared = {op: tape.make(op, a, b) for op in COMPARISONS}
    lt, ne = compared["lt"], compared["ne"]
    logic = [tape.make("and", lt, ne), tape.make("or", lt, ne), tape.make("not", lt)]
    logic += [tape.make("and", ne, tape.make("bool", True))]
    logic += [tape.make("or", ne, tape.make("bool", False))]
    nodes = [tape.make(op, a, b) for op in ("add", "sub", "mul", "div", *BINARY)]
    nodes += [tape.make(op, a) for op in ("neg", *UNARY)]
    nodes += [tape.make("select", c, a, b) for c in (*compared.values(), *logic)]
    return nodes


def everything():
    """Each operation at both stages, and between them; every input; awkward numbers."""
    tape = Tape()
    x, r, p = ([tape.make("input", group, k) for k in range(2)] for group in "xrp")
    t = tape.make("input", "t", 0)
    numbers = [tape.make("const", c) for c in _AWKWARD]
    known = tape.make("lt", *p)  # a truth value that prepare hands to kernel
    blocks = {
        "of the state": _operations(tape, *x),
        "of the constants": _operations(tape, *p),
        "of other inputs": [tape.mul(t, x[0]), tape.sub(r[1], r[0]), *numbers],
        "mixed": [tape.make("select", known, *x), tape.make("neg", numbers[1])],
        "with numbers": [tape.make("mul", x[0], c) for c in numbers],
    }
    table = [(name, (len(nodes),), nodes) for name, nodes in blocks.items()]
    return Program.from_tape(tape, (2, 2, 2), table)


def solves():
    """One matrix, which the state holds, solved in every way a Program knows."""
    tape = Tape()
    x = [tape.make("input", "x", k) for k in range(15)]
    matrix, one, two = x[:9], tuple(x[9:12]), tuple(x[12:])
    blocks = []
    for kind in ("lu", "ldl"):
        factor = tape.make("factor", kind, 3, tuple(matrix))
        for name, column in (("one", one), ("two", two)):
            vector = tape.make("solve", factor, column)
            blocks.append((f"{kind} {name}", vector))
    unrolled = UnrolledLDL(tape, 3, matrix)
    blocks.append(("guard", unrolled.solve(list(one))))
    table = [(name, (3,), [tape.make("item", v, k) for k in range(3)]) for name, v in blocks]
    return Program.from_tape(tape, (15, 0, 0), table)


def form(body: Multibody, *, in_bodies: bool, articulated: bool) -> EquationGraph:
    """Return the equations of motion in one form."""
    return forms(body, in_bodies=in_bodies).equations[-1 if articulated else 0]


def derivatives(expressions, *point, variables=X, p=()):
    """The dense Jacobian of expressions in X, P with respect to symbols of X."""
    graph, nodes = nodes_of(expressions)
    rows = jacobian(graph, nodes, [graph.input("x", X.index(v)) for v in variables])
    cells = [row.get(k, graph.zero) for row in rows for k in range(len(variables))]
    program = on_tape(graph, cells)
    return values(program, point, p).reshape(len(nodes), len(variables))
