"""What a scene shows when nobody said: shapes of bodies, the origin, which way is up."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import RigidBody
from sympy.physics.vector import ReferenceFrame, Vector

from pydy._checks import listed, real_array, shown
from pydy._mechanics.reader import breadth_first_from, given_velocity
from pydy._rank import DIGITS
from pydy.viz.shapes import Arrow, Box, Cylinder, Shape, Sphere
from pydy.viz.visuals import Visual

# A plate is drawn no thinner than this part of its greatest edge.
_THINNEST = 0.03


def default_shape(body: Any, values: Mapping[Any, float], size: float) -> Shape:
    """Return the simplest solid with a body's inertia, or a ball for a particle.

    Where all three moments are equal that is a sphere, where two are a cylinder or disc about the
    third axis, else a box. `values` are those of all symbols at the first instant, for an inertia
    may be written in a frame in which the body turns; `size` is that of the scene.
    """
    ball = Sphere(0.04 * size)
    if not isinstance(body, RigidBody):
        return ball
    numbers = {k: sm.Float(v) for k, v in values.items()}
    inertia = body.central_inertia.to_matrix(body.frame)
    try:
        moments = [float(sm.sympify(inertia[k, k]).xreplace(numbers)) for k in range(3)]
    except TypeError:  # a symbol without a value
        return ball
    try:
        mass = float(sm.sympify(body.mass).xreplace(numbers))
    except TypeError:  # it is not in the equations: its size is free, its proportions are not
        mass = 12 * max(moments) / (0.4 * size) ** 2
    # I_x = m (y² + z²) / 12 and so on, solved for the edges.
    ix, iy, iz = moments
    squares = [iy + iz - ix, iz + ix - iy, ix + iy - iz]
    if not mass > 0 or not max(squares) > 0 or not np.isfinite(squares).all():
        return ball
    round_one = _round_shape(moments, mass)
    if round_one is not None:
        return round_one
    edges = [float(np.sqrt(max(6 * s / mass, 0.0))) for s in squares]
    return Box(*(max(edge, _THINNEST * max(edges)) for edge in edges))


def _round_shape(moments: list[float], mass: float) -> Shape | None:
    """Return the sphere or cylinder of uniform density with these moments, or None for a box."""
    greatest = max(moments)
    if np.ptp(moments) <= DIGITS * greatest:
        return Sphere(float(np.sqrt(2.5 * greatest / mass)))
    for k, axis in enumerate("xyz"):
        own, (one, other) = moments[k], np.delete(moments, k)
        if abs(one - other) > DIGITS * greatest:
            continue
        # I = m r² / 2 about the axis, m (3 r² + l²) / 12 across it.
        radius = np.sqrt(2 * max(own, 0.0) / mass)
        length = np.sqrt(max(12 * one / mass - 3 * radius**2, 0.0))
        size = max(2 * radius, length)
        thick = max(length, _THINNEST * size)
        return Cylinder(float(thick), float(max(radius, _THINNEST * size / 2)), axis)
    return None


def find_origin(frame: Any, points: Iterable[Any]) -> Any:
    """Return a point that was said to rest in `frame`, connected with the given ones, or None."""
    every = breadth_first_from([*points])
    return next((p for p in every if given_velocity(p, frame) == Vector(0)), None)


def arms(joints: Iterable[Any]) -> list[tuple[Any, Any]]:
    """Return the pairs of points between which bodies reach: mass centres and joints."""
    pairs = []
    for joint in joints:
        for body, point in (
            (joint.parent, joint.parent_point),
            (joint.child, joint.child_point),
        ):
            if point.pos_from(body.masscenter) != Vector(0):
                pairs.append((body.masscenter, point))
    return pairs


def load_arrows(bodies: Iterable[Any], loads: Iterable[tuple[Any, Any]]) -> list[Visual]:
    """Return arrows for forces at their points and torques at the mass centres of their bodies."""
    centres = {getattr(body, "frame", None): body.masscenter for body in bodies}
    arrows = []
    for where, vector in loads:
        point, name, colour = where, "forces", "#c93a3a"
        if isinstance(where, ReferenceFrame):
            point, name, colour = centres.get(where), "torques", "#7d4cc4"
        if point is not None and vector != Vector(0):
            arrow = Arrow(vector, scale=None, colour=colour)
            arrows.append(Visual(arrow, point, name=name))
    return arrows


def skeleton(
    origin: Any, points: Iterable[Any], loads: Iterable[tuple[Any, Any]] = ()
) -> list[tuple[Any, Any]]:
    """Return the pairs of points that lead from the origin to the given ones.

    Two points make a pair where the position of one was given relative to the other, unless
    nothing holds them together: one floats, rolls or slides freely with respect to the other.
    """
    driven = {f for _, vector in loads for f in _functions(vector)}
    before = breadth_first_from([origin])
    pairs: dict[tuple[Any, Any], None] = {}
    for point in points:
        while (above := before.get(point)) is not None:
            moving = _functions(point.pos_from(above))
            if not moving or (len(moving) == 1 and moving <= driven):
                pairs[above, point] = None
            point = above
    return list(pairs)


def _functions(vector: Any) -> set[Any]:
    """Return the functions of time in a vector's components, whatever its frames do."""
    return {
        f
        for components, _ in vector.args
        for c in components
        for f in sm.sympify(c).atoms(AppliedUndef)
    }


def gravities(expression: Any) -> list[Any]:
    """Return the symbols in an expression that are called like the acceleration of gravity."""
    return [s for s in expression.free_symbols if str(s) in ("g", "G", "gravity")]


def guess_up(
    frame: Any,
    bodies: Iterable[Any],
    loads: Sequence[tuple[Any, Any]],
    values: Mapping[Any, float],
) -> str | None:
    """Return the axis of `frame` against which the weights pull, or None.

    A weight is what a force has of a symbol `g`, or a force at a mass centre that consists of
    numbers and the mass.
    """
    masses = {body.masscenter: sm.sympify(body.mass) for body in bodies}
    pull = np.zeros(3)
    for where, vector in loads:
        try:
            components = vector.to_matrix(frame)
        except ValueError:
            continue
        for k in range(3):
            weight = sm.sympify(components[k])
            known = gravities(weight)
            if len(known) == 1:
                weight = weight.diff(known[0])
            elif where not in masses or weight.free_symbols - masses[where].free_symbols:
                continue
            number = weight.xreplace({s: sm.Float(values.get(s, 1.0)) for s in weight.free_symbols})
            pull[k] += float(number) if number.is_number else 0.0
    k = int(np.abs(pull).argmax())
    if not np.abs(pull[k]) > 10 * np.abs(np.delete(pull, k)).max():
        return None
    return ("-" if pull[k] > 0 else "") + "xyz"[k]


def unit_vector(value: Any, frame: Any, argument: str) -> np.ndarray:
    """Return an axis such as '-z', a constant vector or three numbers as a unit array."""
    direction = np.zeros(3)
    if isinstance(value, (str, bytes)):
        if isinstance(value, str) and value.lstrip("+-") in ("x", "y", "z") and len(value) <= 2:
            direction["xyz".index(value[-1])] = -1.0 if value[0] == "-" else 1.0
    else:
        try:
            numbers = value.to_matrix(frame) if isinstance(value, Vector) else value
            if not isinstance(numbers, np.ndarray):
                numbers = listed(argument, numbers, "numbers")
            direction = real_array(numbers, "")
        except (TypeError, ValueError):
            pass
    length = float(np.linalg.norm(direction)) if direction.shape == (3,) else 0.0
    if not 0 < length < np.inf:
        raise ValueError(
            f"`{argument}` must be an axis of the scene's frame such as 'z' or '-y', a constant "
            f"vector, or three numbers that are not all zero, got {shown(value)}."
        )
    return direction / length
