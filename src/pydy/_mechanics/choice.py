"""Which form of the equations of motion costs fewest operations.

Articulated bodies win for chains and trees, composite bodies for few speeds and for springs in a
row; body axes win in space, the inertial frame for links that turn in one plane. None wins
everywhere, and what simplification saves is not seen before: forms are counted.
"""

from __future__ import annotations

from dataclasses import replace

from pydy._graph.collector import collector_paused
from pydy._graph.counting import operations
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.passes.merge import merge_equal
from pydy._graph.simplify import simplify
from pydy._graph.solve.choose import solve_accelerations
from pydy._graph.solve.differences import difference_basis
from pydy._graph.switches import Passes
from pydy._mechanics.form import Formed, forms, in_a_plane
from pydy._mechanics.reader import Multibody
from pydy._mechanics.tuning import FORMS_COUNTED_UP_TO, NEAR_ESTIMATES

__all__ = ["chosen", "counted", "estimated"]


@collector_paused()
def chosen(body: Multibody) -> Formed:
    """Return the equations of motion in the form that takes fewest operations.

    Beyond a dozen speeds vectors are in the inertial frame where all bodies turn about one axis,
    else in the bodies' axes, and estimates decide between articulated and composite bodies.
    """
    many = len(body.speeds) > FORMS_COUNTED_UP_TO
    tried = [not in_a_plane(body)] if many else [True, False]
    found = [forms(body, in_bodies=tried[0])]
    if len(tried) > 1 and not found[0][0].in_one_frame:
        honoured = found[0][0].honoured
        found.append(forms(body, in_bodies=tried[1], honoured=honoured))
    best: list[Formed] = []
    costs: list[int] = []
    for same in zip(*found, strict=True):  # of each kind
        own = [estimated(formed, merged=not many) for formed in same]
        costs.append(min(own))
        best.append(same[own.index(costs[-1])])
    if len(best) == 2 and not many and max(costs) < NEAR_ESTIMATES * min(costs):
        best = [replace(formed, simplified=_simplified(formed)) for formed in best]
        costs = [counted(formed) for formed in best]
    return best[costs.index(min(costs))]


def estimated(formed: Formed, *, merged: bool = True) -> int:
    """Estimate the operations of q' and u': those of a graph, in which equal nodes may be one."""
    graph, n = formed.graph, len(formed.rest)
    if formed.accelerations is not None:
        roots, solving = list(formed.accelerations), 0
        guards = [k for k in graph.reachable(roots) if graph.ops[k] == "guard"]
        if guards:
            roots = list(graph.args[guards[0]][4])
    else:
        matrix, column = formed.matrix, formed.rest
        if (chain := difference_basis(graph, matrix, column)) is not None:
            matrix, column = chain.matrix, chain.column
        lower = [matrix[i][j] for i in range(n) for j in range(i + 1)]
        filled = sum(node != graph.zero for node in lower) - n
        # What LDLᵀ takes of a matrix with so many entries, less what its structure saves: half.
        solving = filled * (filled // n + 9) // 3
        roots = [*lower, *column]
    roots = [*formed.rates, *formed.start, *roots]
    return operations(graph, merge_equal(graph, roots) if merged else roots) + solving


def counted(formed: Formed) -> int:
    """Count the operations of q' and u' as they are compiled."""
    graph, nodes = formed.simplified or _simplified(formed)
    sizes = (len(nodes), len(formed.specifieds), len(formed.constants))
    program = lower(graph.copy(), sizes, [("rates", (len(nodes),), nodes)])
    return sum(program.operation_count["run"].values())


def _simplified(formed: Formed) -> tuple[Graph, list[int]]:
    """Simplify q' and u' in a graph of their own."""
    graph = formed.graph.copy()
    solved = formed.accelerations
    if solved is None:
        beyond = solve_accelerations(graph, formed.matrix, formed.rest, "ldl", Passes())
        solved = [graph.add(*parts) for parts in zip(formed.start, beyond, strict=True)]
    return graph, simplify(graph, [*formed.rates, *solved])
