"""Programs from SymPy expressions or bare nodes, without a mechanical system around them."""

import numpy as np
import sympy as sm

from pydy._graph.from_sympy import SymPyReader
from pydy._graph.interpret import run
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.operations import OPERATIONS
from pydy._graph.passes import Passes
from pydy._programs import Assembly

__all__ = [
    "BINARY",
    "COMPARISONS",
    "ELEMENTARY",
    "UNARY",
    "P",
    "T",
    "X",
    "evaluate",
    "nodes_of",
    "on_tape",
    "program_of",
    "solve_program",
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
    atoms = {T: graph.input("t", 0)}
    atoms |= {s: graph.input("x", k) for k, s in enumerate(X)}
    atoms |= {s: graph.input("p", k) for k, s in enumerate(P)}
    return graph, SymPyReader(graph, atoms).all(expressions)


def on_tape(graph, nodes, sizes=SIZES, **options):
    """The Program of nodes as they are."""
    return lower(graph, sizes, [("values", (len(nodes),), nodes)], **options)


def program_of(expressions, passes=None):
    """The Program of expressions in X, P and T, on the way that a system's equations take."""
    graph, nodes = nodes_of(expressions)
    assembly = Assembly(graph, SIZES, [], [], list(nodes), passes=passes or Passes())
    return assembly.program("outputs")


def values(program, x=(), p=(), t=0.0, kernel=None):
    """Outputs at one state; without a Kernel, from the interpreter."""
    sweep = (lambda *a: run(program, *a)) if kernel is None else kernel.evaluate
    x = np.resize(np.asarray(x, dtype=float), (1, program.num_states)) if len(x) else None
    if x is None:
        x = np.zeros((1, program.num_states))
    p = np.resize(np.asarray(p, dtype=float), program.num_constants) if len(p) else None
    if p is None:
        p = np.zeros(program.num_constants)
    out, _ = sweep(np.array([float(t)]), x, np.empty((1, 0)), p)
    return out[0]


def evaluate(expression, *x):
    """One expression in X at one state, from the interpreter."""
    return float(values(program_of([expression]), x)[0])


def solve_program(n, kind, columns=1, **options):
    """The Program that solves A · X = B; A row-major, then B column by column, are the state."""
    graph = Graph()
    matrix = [[graph.input("x", i * n + j) for j in range(n)] for i in range(n)]
    right = [[graph.input("x", (n + c) * n + i) for i in range(n)] for c in range(columns)]
    nodes = [k for column in graph.solve(matrix, right, kind) for k in column]
    return on_tape(graph, nodes, (n * (n + columns), 0, 0), **options)
