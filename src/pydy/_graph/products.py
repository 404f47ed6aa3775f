"""Programs of derivatives: Jacobians, their products with vectors, gradients, Hessian products.

Each is made from the function's own nodes as they were simplified, so that one Program computes
what function and derivatives have in common once. Derivatives of what is simplified need no more
than common factors taken out.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._collector import collector_paused
from pydy._graph.adjoint import adjoints
from pydy._graph.derivative import directional, jacobian
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.passes.factor import factor_sums
from pydy._program import Program

KINDS = ("jacobian", "jacobian-vector", "vector-jacobian", "gradient", "hessian-vector")


def derivative_program(
    graph: Graph,
    outputs: Sequence[int],
    variables: Sequence[tuple[str, int]],
    kind: str,
    sizes: tuple[int, int, int],
    vectors: int = 1,
) -> Program:
    """Return the Program of derivatives of some nodes.

    The outputs are m simplified nodes, one for gradients and Hessians, and the variables k pairs
    (group, index). The kind says what is computed, with the shape of the only block:

    ==================  ==============  =================================================
    jacobian            (m, k)          ∂f/∂v
    jacobian-vector     (m, vectors)    ∂f/∂v · d, with d of k components
    vector-jacobian     (k, vectors)    ∂(w · f)/∂v, with w of m components
    gradient            (k + 1,)        the value f, then ∂f/∂v
    hessian-vector      (k, vectors)    ∂²f/∂v² · d
    ==================  ==============  =================================================

    The `vectors` d or w are inputs at the end of r, as a matrix in C order with a column for each.
    """
    n, s, c = sizes
    with collector_paused():
        g, nodes = graph, outputs
        variable_nodes = [g.input(*variable) for variable in variables]
        m, k = len(nodes), len(variable_nodes)

        def components(row: int) -> dict[int, int]:
            return {d: g.input("r", s + row * vectors + d) for d in range(vectors)}

        if kind == "jacobian":
            shape: tuple[int, ...] = (m, k)
            cells = jacobian(g, nodes, variable_nodes).flat()
            extra = 0
        elif kind == "jacobian-vector":
            shape, extra = (m, vectors), k * vectors
            seeds = {node: components(i) for i, node in enumerate(variable_nodes)}
            cells = directional(g, nodes, seeds, vectors).flat()
        elif kind == "vector-jacobian":
            shape, extra = (k, vectors), m * vectors
            weights = [components(i) for i in range(m)]
            columns = [
                adjoints(g, nodes, [w[d] for w in weights], variable_nodes) for d in range(vectors)
            ]
            cells = [column[i] for i in range(k) for column in columns]
        elif kind == "gradient":
            shape, extra = (k + 1,), 0
            cells = [nodes[0], *adjoints(g, nodes, [g.one], variable_nodes)]
        else:
            shape, extra = (k, vectors), k * vectors
            first = adjoints(g, nodes, [g.one], variable_nodes)
            first = first if "factor" in g.off else factor_sums(g, first)
            seeds = {node: components(i) for i, node in enumerate(variable_nodes)}
            cells = directional(g, first, seeds, vectors).flat()
        cells = cells if "factor" in g.off else factor_sums(g, cells)
        return lower(g, (n, s + extra, c), [(kind, shape, cells)])
