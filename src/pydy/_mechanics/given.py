"""Velocities that the user set for points, beside those that follow from their places."""

from __future__ import annotations

from typing import Any

from pydy._graph.identities import signatures
from pydy._mechanics.components import same_numbers
from pydy._mechanics.kinematics import Kinematics

__all__ = ["disagreeing"]


def disagreeing(kinematics: Kinematics) -> list[Any]:
    """Return the points whose given velocity is not that of their place, innermost ones."""
    k = kinematics
    points = [p for p in k.moved() if k.base(p) is not None and k.tree.velocity(p) is not None]
    nodes: list[int] = []
    for point in points:
        home, v, _ = k.motion(point)
        nodes += [*v, *k.vector(k.tree.velocity(point), home)]
    values = signatures(k.graph, nodes) if nodes else []
    unequal = {
        point: (nodes[i : i + 3], nodes[i + 3 : i + 6])
        for i, point in zip(range(0, len(nodes), 6), points, strict=True)
        if values[i : i + 3] != values[i + 3 : i + 6]
    }
    same = same_numbers(k.graph, list(unequal.values()))
    bad = {point for point, near in zip(unequal, same, strict=True) if not near}
    return [p for p in points if p in bad and not _leads_to(k, p, bad)]


def _leads_to(kinematics: Kinematics, point: Any, others: set[Any]) -> bool:
    while (point := kinematics.base(point)) is not None:
        if point in others:
            return True
    return False
