"""Which form of the equations of motion costs fewest operations.

Articulated bodies win for chains and trees, composite bodies for few speeds and for springs in a
row; body axes win in space, the inertial frame for links that turn in one plane. None wins
everywhere, and what simplification saves is not seen before: forms are counted.
"""

from __future__ import annotations

from pydy._graph.collector import collector_paused
from pydy._graph.identities import merge_equal
from pydy._graph.simplify import operations
from pydy._mechanics.form import Formed, form
from pydy._mechanics.reader import Multibody

__all__ = ["chosen"]


@collector_paused()
def chosen(body: Multibody) -> Formed:
    """Return the equations of motion in the form that takes fewest operations."""
    ways = [False] if body.velocity else [True, False]
    forms = [
        form(body, in_bodies=in_bodies, articulated=articulated)
        for articulated in ways
        for in_bodies in (True, False)
    ]
    return min(forms, key=_cost)


def _cost(formed: Formed) -> int:
    """Estimate the operations of u' after equal nodes have become one."""
    graph, n = formed.graph, len(formed.forcing)
    if formed.accelerations is not None:
        roots, solving = list(formed.accelerations), 0
        guards = [n for n in graph.reachable(roots) if graph.ops[n] == "guard"]
        if guards:
            roots = list(graph.args[guards[0]][4])
    else:
        roots = [formed.matrix[i][j] for i in range(n) for j in range(i + 1)] + formed.forcing
        filled = sum(formed.matrix[i][j] != graph.zero for i in range(n) for j in range(i + 1))
        # Half of what LDLᵀ takes of a matrix with so many entries: much of its structure is used.
        solving = filled * (n + 9) // 6
    nodes = merge_equal(graph, [*formed.rates, *roots])
    return operations(graph, nodes) + solving
