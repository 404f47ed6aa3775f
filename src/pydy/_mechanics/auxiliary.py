"""Auxiliary equations: the noncontributing forces that auxiliary speeds bring into evidence."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from pydy._collector import collector_paused
from pydy._graph import NodeExpression, jacobian, substitute
from pydy._mechanics.closures import LoopShares, loop_points
from pydy._mechanics.elimination import composite
from pydy._mechanics.equations import Equations
from pydy._mechanics.form import moving
from pydy._mechanics.inertia import loads_and_inertias
from pydy._mechanics.kinematics import Kinematics, Vec


@collector_paused()
def with_auxiliary(equations: Equations) -> Equations:
    """Return the equations with those of the auxiliary speeds.

    A method's own are kept where its velocity constraints leave no auxiliary speed out.
    """
    body = equations.multibody
    if body is None or not body.auxiliary:
        return equations
    k = moving(body, in_bodies=True, auxiliary=True, driven=True)
    moved = jacobian(k.graph, k.read.all(body.velocity), k.auxiliary).dense()
    loops = _leaving_out(k, equations, moved)
    if loops:
        points = loop_points(body)
        k = moving(body, in_bodies=True, auxiliary=True, driven=True, more=points)
        rows = k.read.all(body.velocity)
        moved = jacobian(k.graph, rows, k.auxiliary).dense()
        shares = LoopShares(k, points, [rows[j] for j in loops]).found(equations)
        # Whoever wrote some of the rows with auxiliary speeds wrote all with them.
        written = any(j not in loops for j in range(len(rows)) if _of_loop(equations, j))
        for j, share in zip(loops, shares, strict=True):
            if share is not None:
                moved[j] = share
            elif not written:
                loop = body.velocity[j]
                unresolved = replace(equations.auxiliary, residuals=(), unresolved_loop=loop)
                return replace(equations, auxiliary=unresolved)
        loops = [j for j in loops if any(n != k.graph.zero for n in moved[j])]
    if equations.auxiliary.residuals and not loops:
        return equations
    auxiliary = replace(equations.auxiliary, residuals=tuple(_residuals(k, moved)))
    return replace(equations, auxiliary=auxiliary)


def _leaving_out(k: Kinematics, equations: Equations, moved: list[Vec]) -> list[int]:
    """Return the rows that follow from holonomic constraints and hold no auxiliary speed."""
    still = [all(n == k.graph.zero for n in row) for row in moved]
    return [j for j, none in enumerate(still) if none and _of_loop(equations, j)]


def _of_loop(equations: Equations, j: int) -> bool:
    constraints = equations.constraints
    return not any(constraints.velocity[j] is e for e in constraints.nonholonomic)


def _residuals(k: Kinematics, moved: list[Vec]) -> list[Any]:
    """Return the residual for each auxiliary speed: its active minus its inertia force.

    The velocity constraints' derivatives by the auxiliary speeds are `moved`.
    """
    g, n, body = k.graph, len(k.speeds), k.body
    _, rest = composite(k, [], loads_and_inertias(k)[1])
    found = rest[n:]
    if body.velocity:
        nodes = k.read.all(body.velocity)
        dependent = body.dependent_columns
        held = [[row[j] for j in dependent] for row in jacobian(g, nodes, k.speeds).dense()]
        columns = [[g.neg(row[a]) for row in moved] for a in range(len(found))]
        shares = g.solve(held, columns, "lu")
        for a, share in enumerate(shares):
            terms = [(g.mul(s, rest[j]), 1.0) for s, j in zip(share, dependent, strict=True)]
            found[a] = g.sum([(found[a], 1.0), *terms])
    found = substitute(g, found, dict.fromkeys(k.auxiliary, g.zero))
    return [NodeExpression.of(g, node, k.symbols()) for node in found]
