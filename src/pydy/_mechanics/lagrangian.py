"""Lagrange's equations formed on the graph: from L and the forces that it does not hold.

With the momenta p = ∂L/∂q', M = ∂p/∂q' and F = ∂L/∂q − dp/dt + Q, where dp/dt is taken at q'' = 0
and Q are the generalized forces of the loads.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from pydy._graph.collector import collector_paused
from pydy._graph.derivative import jacobian
from pydy._mechanics.dynamics import loads_and_inertias
from pydy._mechanics.elimination import composite
from pydy._mechanics.form import Formed, moving
from pydy._mechanics.reader import Multibody

__all__ = ["form_lagrangian"]


@collector_paused()
def form_lagrangian(lagrangian: Any, body: Multibody) -> Formed:
    """Return the equations of motion of a Lagrangian.

    Parameters
    ----------
    lagrangian : expression
        In the coordinates, their derivatives, time, constants and specifieds.
    body : Multibody
        With the derivatives of the coordinates as speeds, the loads, and no bodies.

    Raises
    ------
    ValueError
        The Lagrangian holds second derivatives of coordinates.
    """
    kinematics = moving(replace(body, bodies=()), in_bodies=True)
    inertias, loads = loads_and_inertias(kinematics)
    g, speeds, n = kinematics.graph, kinematics.speeds, len(body.coordinates)
    _, forces = composite(g, kinematics.rows, kinematics.groups, speeds, inertias, loads)
    node = kinematics.read(lagrangian)
    if set(kinematics.accelerations) & set(g.reachable([node])):
        raise ValueError(
            "The Lagrangian holds second derivatives of coordinates. Leave out what is a "
            "derivative by time: it does not change the equations."
        )
    coordinates = [g.input("x", k) for k in range(n)]
    (by_speed,) = jacobian(g, [node], speeds)
    momenta = [by_speed.get(k, g.zero) for k in range(n)]
    (by_coordinate,) = jacobian(g, [node], coordinates)
    rows = jacobian(g, momenta, speeds)
    # One triangle for both, so that the matrix is symmetric to the last bit.
    matrix = [[rows[max(i, j)].get(min(i, j), g.zero) for j in range(n)] for i in range(n)]
    forcing = [
        g.sum([(by_coordinate.get(k, g.zero), 1.0), (rate, -1.0), (forces[k], 1.0)])
        for k, rate in enumerate(kinematics.dt(momenta))
    ]
    read = kinematics.read
    return Formed(
        g, read.constants, read.specifieds, kinematics.rates, matrix, forcing, None, g.zero
    )
