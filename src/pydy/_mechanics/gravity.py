"""Gravity as an acceleration of the inertial frame.

Where it pulls all masses alike, the forces m g are left out of the loads and all points'
accelerations are less g. That is one vector on its way outwards in place of a force at each body.
"""

from __future__ import annotations

from typing import Any

from pydy._graph.node import Graph
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.tuning import ALIKE

__all__ = ["take_gravity_off"]


def take_gravity_off(kinematics: Kinematics) -> None:
    """Turn weights into an acceleration, where every body with a mass has one.

    No point's motion may have been asked for.
    """
    weights: list[dict[int, Vec]] = []
    for body in kinematics.body.bodies:
        mass = kinematics.read(body.mass)
        if mass != kinematics.graph.zero:
            weights.append(_pulls(kinematics, body.masscenter, mass))
    for pull in weights[0].values() if weights else ():
        spent = [_place(kinematics.graph, pull, own) for own in weights]
        if None not in spent and len(set(spent)) == len(spent):
            kinematics.loads = tuple(x for k, x in enumerate(kinematics.loads) if k not in spent)
            kinematics.pull = pull
            return


def _pulls(kinematics: Kinematics, point: Any, mass: int) -> dict[int, Vec]:
    """Return force over mass of the loads at a point that are written in the inertial frame."""
    found = {}
    for k, (where, vector) in enumerate(kinematics.loads):
        if where is point and all(frame is kinematics.inertial for _, frame in vector.args):
            parts = kinematics.vector(vector, kinematics.inertial)
            found[k] = [kinematics.graph.div(n, mass) for n in parts]
    return found


def _place(graph: Graph, pull: Vec, own: dict[int, Vec]) -> int | None:
    """Return which of a body's loads pulls it like that."""
    return next((k for k, other in own.items() if _alike(graph, pull, other)), None)


def _alike(graph: Graph, a: Vec, b: Vec) -> bool:
    """Return whether vectors are equal up to the rounding of numbers."""
    for x, y in zip(a, b, strict=True):
        one, two = _split(graph, x), _split(graph, y)
        if one[1] != two[1] or abs(one[0] - two[0]) > ALIKE * abs(one[0]):
            return False
    return True


def _split(graph: Graph, node: int) -> tuple[float, int]:
    """Return a number and what it multiplies."""
    value = graph.value(node)
    return graph.scaled(node) if value is None else (value, graph.one)
