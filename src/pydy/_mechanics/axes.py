"""Where on its axis a joint is: any point there will do, and one is nearest to the others.

A body that turns about an axis may be referred to any point on the axis. From one such point to the
next there are then two components at most in place of three (Denavit and Hartenberg, Journal of
Applied Mechanics 22 (1955) 215-221).
"""

from __future__ import annotations

from typing import Any

import sympy as sm
from sympy.physics.mechanics import Point, Vector

from pydy._mechanics.kinematics import Kinematics

__all__ = ["move_along_axes"]


def move_along_axes(kinematics: Kinematics) -> None:
    """Refer bodies on hinges to other points of their axes, where fewer products follow."""
    joints = _joints(kinematics)
    shifts: dict[Any, Any] = {}
    for point in sorted(joints, key=lambda p: kinematics.tree.oriented[joints[p][0]]):
        _, axis, base, place = joints[point]
        before = kinematics.fixed_step(point)
        assert before is not None
        own = place[axis]
        if base in shifts and joints[base][1] == axis:
            own = own - shifts[base]
        shift = -own
        if kinematics.at_rest(base, before[1]):
            # Nothing depends on this place: the next joint's is made shorter.
            following = [j for j in joints.values() if j[2] is point and j[1] != axis]
            shift = following[0][3][axis] if following else sm.S.Zero
        if shift != 0:
            shifts[point] = shift
    moved = {
        point: (Point(f"{point} on its axis"), _along(joints[point], shift))
        for point, shift in shifts.items()
    }
    for point, (other, way) in moved.items():
        _, _, base, place = joints[point]
        before = kinematics.fixed_step(point)
        assert before is not None
        start = _vector(place, before[1])
        if base in moved:
            base, back = moved[base]
            start = start - _same(back, before[1])
        kinematics.lead(other, base, start + _same(way, before[1]))
    kept = {other: kinematics.way(other) for other, _ in moved.values()}
    for point in kinematics.placed():
        base, steps = kinematics.way(point)
        if point in moved:
            other, way = moved[point]
            kinematics.lead(point, other, -way)
        elif base in moved and point not in kept:
            other, way = moved[base]
            kinematics.lead(point, other, sum(steps, Vector(0)) - way)


def _along(joint: tuple[Any, int, Any, Any], shift: Any) -> Vector:
    frame, axis = joint[:2]
    return _vector([shift if i == axis else sm.S.Zero for i in range(3)], frame)


def _vector(parts: Any, frame: Any) -> Vector:
    return Vector([(sm.Matrix(parts), frame)])


def _same(vector: Vector, frame: Any) -> Vector:
    """Return a vector along an axis that two frames have in common."""
    return Vector([(part, frame) for part, _ in vector.args])


def _joints(kinematics: Kinematics) -> dict[Any, tuple[Any, int, Any, Any]]:
    """Return for each point with a hinge: frame, axis, the point before and the way from there."""
    hung: dict[Any, set[Any]] = {}
    for point in kinematics.placed():
        base, steps = kinematics.way(point)
        frames = {frame for step in steps for _, frame in step.args}
        hung.setdefault(base, set()).update(frames)
    for body in kinematics.body.bodies:
        hung.setdefault(body.masscenter, set()).add(getattr(body, "frame", None))
    found: dict[Any, tuple[Any, int, Any, Any]] = {}
    for point, frames in hung.items():
        step = point and kinematics.fixed_step(point)
        if not step or len(frames) != 1:
            continue
        (frame,) = frames
        if frame is None or frame is step[1] or frame is kinematics.inertial:
            continue
        axis = kinematics.axis(frame, step[1])
        if axis is not None:
            parts = [sm.S.Zero] * 3
            for vector in kinematics.way(point)[1]:
                for part, _ in vector.args:
                    parts = [a + b for a, b in zip(parts, part, strict=True)]
            found[point] = frame, axis, step[0], parts
    return found
