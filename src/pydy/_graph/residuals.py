"""Residuals of linear systems, from which derivatives of their solutions follow.

From ``A x = b`` follows ``A x' = r'``, with the residual ``r = b − A x`` differentiated at a fixed
x. Written as one sum for each row and simplified, r often takes far fewer operations than the
entries of A and b, and so do its derivatives. Where x are accelerations it is the inverse dynamics,
which are O(n) for a chain whose mass matrix has n² entries (Featherstone, Rigid Body Dynamics
Algorithms, 2008, ch. 5; Carpentier and Mansard, "Analytical derivatives of rigid body dynamics
algorithms", Robotics: Science and Systems 2018).
"""

from __future__ import annotations

from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._graph.simplification import operation_count, simplify
from pydy._graph.tuning import MATRIX_OVER_PRODUCT
from pydy._program import symmetric


def residuals(graph: Graph, solve: int, *, open_form: bool = False) -> list[int] | None:
    """Return the nodes ``b − A x`` of a ``solve`` node, or None where they save no operations.

    They are made once for each graph. In the open form they have inputs in place of solutions.
    """
    if solve not in graph.residuals:
        graph.residuals[solve] = _residuals(graph, solve)
    forms = graph.residuals[solve]
    return forms and forms[open_form]


def _residuals(graph: Graph, solve: int) -> tuple[list[int], list[int]] | None:
    n, parts, products = _system(graph, solve)
    operations = operation_count(graph, parts)
    if products * MATRIX_OVER_PRODUCT < operations:
        return None
    # The passes see inputs in place of the solution, and of those of other systems, whose matrices
    # they would change.
    _, before, _ = _system(graph, graph.systems.get(solve, solve))
    solution = [graph.make("item", (solve, k)) for k in range(n)]
    others = [k for k in graph.reachable(before) if graph.ops[k] == "item"]
    away = {node: graph.input("solution", k) for k, node in enumerate([*solution, *others])}
    before, x = substitute(graph, before, away), [away[node] for node in solution]
    rows = []
    for i in range(n):
        terms = [(graph.mul(before[i * n + j], x[j]), -1.0) for j in range(n)]
        rows.append(graph.sum([*terms, (before[n * n + i], 1.0)]))
    rows = simplify(graph, rows)
    if operation_count(graph, rows) >= operations + products:
        return None
    return substitute(graph, rows, {twin: node for node, twin in away.items()}), rows


def _system(graph: Graph, solve: int) -> tuple[int, list[int], int]:
    """Return the number of unknowns, the entries of A and b, and the operations of A x."""
    factor, column = graph.args[solve]
    kind, n, entries = graph.args[factor]
    entries = symmetric(n, entries) if kind == "ldl" else entries
    return n, [*entries, *column], sum(2 for entry in entries if entry != graph.zero)
