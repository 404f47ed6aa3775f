"""Lagrange's equations formed on the graph: from L and the forces that it does not hold.

With the momenta p = ∂L/∂q', M = ∂p/∂q' and F = ∂L/∂q − dp/dt + Q, where dp/dt is taken at q'' = 0
and Q are the generalized forces of the loads.
"""

from __future__ import annotations

from pydy._graph.collector import collector_paused
from pydy._graph.derivative import jacobian
from pydy._mechanics.dynamics import loads_and_inertias
from pydy._mechanics.elimination import composite
from pydy._mechanics.form import Formed, moving
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.reader import Multibody
from pydy._mechanics.reduction import reduced

__all__ = ["form_lagrangian", "lagranges_equations"]


@collector_paused()
def form_lagrangian(body: Multibody) -> Formed:
    """Return the equations of motion of a Lagrangian.

    With constraints, q'' follows from multipliers: that holds in every configuration, whatever
    speeds are dependent. M and F are reduced as Kane's.

    Parameters
    ----------
    body : Multibody
        With a Lagrangian, and the derivatives of the coordinates as speeds.

    Raises
    ------
    ValueError
        The Lagrangian holds second derivatives of coordinates.
    """
    kinematics = moving(body, in_bodies=True)
    g, read = kinematics.graph, kinematics.read
    matrix, forcing = lagranges_equations(kinematics)
    accelerations = None
    if body.velocity:
        moved = bool(set(kinematics.accelerations) & set(g.reachable(forcing)))
        matrix, forcing, accelerations = reduced(kinematics, matrix, forcing, moved)
    return Formed(
        g,
        read.constants,
        read.specifieds,
        kinematics.rates,
        matrix,
        forcing,
        accelerations,
        [g.zero] * len(forcing),
        forcing,
        g.zero,
    )


def lagranges_equations(kinematics: Kinematics) -> tuple[list[Vec], Vec]:
    """Return M and F for all speeds, dependent or not."""
    body = kinematics.body
    inertias, loads = loads_and_inertias(kinematics)
    g, speeds, n = kinematics.graph, kinematics.speeds, len(body.coordinates)
    _, forces = composite(g, kinematics.rows, kinematics.groups, speeds, inertias, loads)
    node = kinematics.read(body.lagrangian)
    if set(kinematics.accelerations) & set(g.reachable([node])):
        raise ValueError(
            "The Lagrangian holds second derivatives of coordinates. Leave out what is a "
            "derivative by time: it does not change the equations."
        )
    (by_speed,) = jacobian(g, [node], speeds)
    momenta = [by_speed.get(k, g.zero) for k in range(n)]
    # Coordinates in the order of the speeds, which are their derivatives.
    order = {rate: k for k, rate in enumerate(body.coordinate_rates)}
    coordinates = [g.input("x", order[u]) for u in body.speeds]
    (by_coordinate,) = jacobian(g, [node], coordinates)
    rows = jacobian(g, momenta, speeds)
    # One triangle for both, so that the matrix is symmetric to the last bit.
    matrix = [[rows[max(i, j)].get(min(i, j), g.zero) for j in range(n)] for i in range(n)]
    forcing = [
        g.sum([(by_coordinate.get(k, g.zero), 1.0), (rate, -1.0), (forces[k], 1.0)])
        for k, rate in enumerate(kinematics.dt(momenta))
    ]
    return matrix, forcing
