"""Auxiliary equations: the noncontributing forces that auxiliary speeds bring into evidence."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from pydy._collector import collector_paused
from pydy._graph import LinearSystem, NodeExpression, jacobian, substitute
from pydy._mechanics.closures import LoopShares, loop_points
from pydy._mechanics.elimination import composite
from pydy._mechanics.equations import Equations
from pydy._mechanics.formulations import moving
from pydy._mechanics.inertia import loads_and_inertias
from pydy._mechanics.kinematics import Kinematics, Vec

if TYPE_CHECKING:
    import sympy as sm


@collector_paused()
def with_auxiliary(equations: Equations) -> Equations:
    """Return the equations with those of the auxiliary speeds.

    Those of the method are used if its velocity constraints contain all auxiliary speeds.
    """
    body = equations.multibody
    if body is None or not body.auxiliary:
        return equations
    k = moving(body, in_bodies=True, auxiliary=True, driven=True)
    moved = jacobian(k.graph, k.read.all(body.constraints.velocity), k.auxiliary).dense()
    loops = _leaving_out(k, equations, moved)
    if loops:
        points = loop_points(body)
        k = moving(body, in_bodies=True, auxiliary=True, driven=True, further_points=points)
        rows = k.read.all(body.constraints.velocity)
        moved = jacobian(k.graph, rows, k.auxiliary).dense()
        shares = LoopShares(k, points, [rows[j] for j in loops]).derivatives(equations)
        # If the user included auxiliary speeds in one row, they are complete in all rows.
        has_auxiliary = any(j not in loops for j in range(len(rows)) if _of_loop(equations, j))
        for j, share in zip(loops, shares, strict=True):
            if share is not None:
                moved[j] = share
            elif not has_auxiliary:
                loop = body.constraints.velocity[j]
                unresolved = replace(equations.auxiliary, residuals=(), unresolved_loop=loop)
                return replace(equations, auxiliary=unresolved)
        loops = [j for j in loops if any(n != k.graph.zero for n in moved[j])]
    if equations.auxiliary.residuals and not loops:
        return equations
    auxiliary = replace(equations.auxiliary, residuals=tuple(_residuals(k, moved)))
    return replace(equations, auxiliary=auxiliary)


def _leaving_out(k: Kinematics, equations: Equations, moved: list[Vec]) -> list[int]:
    """Return the rows that follow from holonomic constraints and have no auxiliary speed."""
    is_static = [all(n == k.graph.zero for n in row) for row in moved]
    return [j for j, none in enumerate(is_static) if none and _of_loop(equations, j)]


def _of_loop(equations: Equations, j: int) -> bool:
    constraints = equations.constraints
    return not any(constraints.velocity[j] is e for e in constraints.nonholonomic)


def _residuals(k: Kinematics, moved: list[Vec]) -> list[sm.Expr]:
    """Return the residual for each auxiliary speed: its active minus its inertia force.

    The velocity constraints' derivatives by the auxiliary speeds are `moved`.
    """
    g, n, body = k.graph, len(k.speeds), k.body
    _, forces = composite(k, [], loads_and_inertias(k)[1])
    residuals = forces[n:]
    if body.constraints.velocity:
        nodes = k.read.all(body.constraints.velocity)
        dependent = body.dependents.speed_columns
        dependent_part = [
            [row[j] for j in dependent] for row in jacobian(g, nodes, k.speeds).dense()
        ]
        columns = [[g.neg(row[a]) for row in moved] for a in range(len(residuals))]
        shares = [*map(LinearSystem(g, dependent_part).solve, columns)]
        for a, share in enumerate(shares):
            terms = [(g.mul(s, forces[j]), 1.0) for s, j in zip(share, dependent, strict=True)]
            residuals[a] = g.sum([(residuals[a], 1.0), *terms])
    residuals = substitute(g, residuals, dict.fromkeys(k.auxiliary, g.zero))
    return [NodeExpression.of(g, node, k.symbols()) for node in residuals]
