"""Velocities that the user set for points, beside those that follow from their places."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pydy._graph.identities import signatures
from pydy._mechanics.components import numbers_of
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.tuning import SAME_DIRECTION

__all__ = ["disagreeing"]


def disagreeing(kinematics: Kinematics) -> list[Any]:
    """Return the points whose given velocity is not what follows from their place.

    That is, if those that they are reached from move as they are said to, each with the given
    velocity if it is one of the points returned.
    """
    k = kinematics
    points = [p for p in k.moved() if k.base(p) is not None and k.tree.velocity(p) is not None]
    nodes: list[int] = []
    for point in points:
        home, v, _ = k.motion(point)
        nodes += [*v, *k.vector(k.tree.velocity(point), home)]
    values = signatures(k.graph, nodes) if nodes else []
    unequal = {
        point: nodes[i : i + 6]
        for i, point in zip(range(0, len(nodes), 6), points, strict=True)
        if values[i : i + 3] != values[i + 3 : i + 6]
    }
    return _honoured(k, points, unequal) if unequal else []


def _honoured(
    kinematics: Kinematics, points: Sequence[Any], unequal: Mapping[Any, Sequence[int]]
) -> list[Any]:
    """Return the points whose velocities are given, from the inner ones to the outer ones.

    A point that is reached from one whose velocity is given moves by the same difference from what
    follows from its place. Directions that are given by numbers are rounded: products of them that
    are equal are not so modulo a prime, but at random states.
    """
    k = kinematics
    ways = {p: k.frames.way_in(k.motion(p)[0])[:-1] for p in unequal}
    frames = list(dict.fromkeys(f for way in ways.values() for f in way))
    steps = [n for f in frames for row in k.frames.step(f) for n in row]
    values = numbers_of(k.graph, [*steps, *(n for six in unequal.values() for n in six)])
    states = len(values)
    turned = values[:, : len(steps)].reshape(states, -1, 3, 3)
    step = {f: turned[:, i] for i, f in enumerate(frames)}
    apart: dict[Any, np.ndarray] = {}
    sizes: dict[Any, np.ndarray] = {}
    pairs = values[:, len(steps) :].reshape(states, -1, 2, 3)
    for i, p in enumerate(unequal):
        difference = pairs[:, i, 1] - pairs[:, i, 0]
        for f in ways[p]:  # into the inertial frame
            difference = np.einsum("sij,si->sj", step[f], difference)
        apart[p], sizes[p] = difference, np.linalg.norm(pairs[:, i], axis=-1).sum(axis=-1)
    found: dict[Any, None] = {}
    nothing = np.zeros((states, 3))
    for p in sorted(points, key=lambda p: len(_inner(k, p))):
        inner = next((q for q in _inner(k, p) if q in found), None)
        left = apart.get(p, nothing) - apart.get(inner, nothing)
        size = sizes.get(p, 0.0) + sizes.get(inner, 0.0)
        # What a singular solve gives is not a number, and equal to nothing.
        if not (np.linalg.norm(left, axis=-1) <= SAME_DIRECTION * size).all():
            found[p] = None
    return list(found)


def _inner(kinematics: Kinematics, point: Any) -> list[Any]:
    """Return the points that a point is reached from, the nearest one first."""
    found = []
    while (point := kinematics.base(point)) is not None:
        found.append(point)
    return found
