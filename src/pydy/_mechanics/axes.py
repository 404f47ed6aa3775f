"""Where on its axis a joint is: any point there will do, and one is nearest to the others.

A body that turns about an axis may be referred to any point on the axis. From one such point to the
next there are then two components at most in place of three (Denavit and Hartenberg, Journal of
Applied Mechanics 22 (1955) 215-221).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sympy.physics.mechanics import Point

from pydy._graph.node import Graph
from pydy._mechanics.components import transposed, turned
from pydy._mechanics.kinematics import Kinematics, Parts, Vec
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.tuning import SAME_AXES

__all__ = ["hinge_axis", "in_a_plane", "move_along_axes"]


def hinge_axis(kinematics: Kinematics, frame: Any, before: Any) -> int | None:
    """Return which axis a frame has in common at all times with the one that it turns in."""
    k, g = kinematics, kinematics.graph
    if frame not in k.tree.oriented or frame is k.inertial:
        return None
    if k.frames.parent(frame) is not before or k.frames.base(frame) is not before:
        return None
    turn, spin = k.frames.step(frame), k.relative_spin(frame, frame)
    for i in range(3):
        unit = [g.one if j == i else g.zero for j in range(3)]
        others = {n for j, n in enumerate(spin) if j != i}
        if turn[i] == unit and [row[i] for row in turn] == unit and others == {g.zero}:
            return i
    return None


def in_a_plane(kinematics: Kinematics) -> bool:
    """Return whether all frames that occur turn about one axis."""
    k = kinematics
    frames = {frame for point in k.placed() for _, frame in k.parts(point)}
    frames |= {body.frame for body in k.body.bodies if is_rigid(body)}
    if not frames <= k.tree.oriented.keys():
        return False
    turning = {f for frame in frames for f in k.frames.way_in(frame)} - {k.inertial}
    axes = {hinge_axis(k, f, k.frames.parent(f)) for f in turning}
    return len(axes) <= 1 and None not in axes


@dataclass(frozen=True)
class _Joint:
    """A hinge at a point: the frame behind it, its axis there and in the frame before.

    `place` leads there, in the frame `before`, from the point `base`; `shortened` is the component
    of it that another point of the axis does not have.
    """

    frame: Any
    axis: int
    base: Any
    before: Any
    place: Vec
    direction: Vec
    shortened: int


def move_along_axes(kinematics: Kinematics) -> None:
    """Refer bodies on hinges to other points of their axes, where fewer products follow."""
    k, g = kinematics, kinematics.graph
    joints = _joints(k)
    shifts: dict[Any, int] = {}
    for point in sorted(joints, key=lambda p: k.tree.oriented[joints[p].frame]):
        joint = joints[point]
        n = joint.shortened
        own = joint.place[n]
        if joint.base in shifts and joints[joint.base].axis == n:
            own = g.sub(own, shifts[joint.base])
        shift = g.neg(g.div(own, joint.direction[n]))
        if k.at_rest(joint.base, joint.before):
            # Nothing depends on this place: the next joint's is made shorter.
            following = [
                j for j in joints.values() if j.base is point and j.shortened != joint.axis
            ]
            shift = following[0].place[joint.axis] if following else g.zero
        if shift != g.zero:
            shifts[point] = shift
    others = {point: Point(f"{point} on its axis") for point in shifts}
    for point, other in others.items():
        joint = joints[point]
        along = [g.mul(n, shifts[point]) for n in joint.direction]
        parts = [(joint.place, joint.before), (along, joint.before)]
        base = joint.base
        if base in others:
            parts.append(_back(g, joints[base], shifts[base]))
            base = others[base]
        k.lead(other, base, _joined(k, parts))
    kept = {other: k.way(other) for other in others.values()}
    for point in k.placed():
        base, _ = k.way(point)
        if point in others:
            k.lead(point, others[point], [_back(g, joints[point], shifts[point])])
        elif base in others and point not in kept:
            parts = [*k.parts(point), _back(g, joints[base], shifts[base])]
            k.lead(point, others[base], _joined(k, parts))


def _back(graph: Graph, joint: _Joint, shift: int) -> tuple[Vec, Any]:
    """Return the way back from the other point of an axis."""
    zero = graph.zero
    return [graph.neg(shift) if i == joint.axis else zero for i in range(3)], joint.frame


def _joined(kinematics: Kinematics, parts: Parts) -> Parts:
    """Add components in the same frame; leave out what is zero."""
    found: dict[Any, Vec] = {}
    for v, frame in parts:
        found[frame] = kinematics.plus(found[frame], v) if frame in found else v
    graph = kinematics.graph
    for frame, v in found.items():
        sizes = [abs(graph.value(n) or 0.0) for n in v]
        tiny = SAME_AXES * max(sizes)
        found[frame] = [
            graph.zero if graph.ops[n] == "const" and size <= tiny else n
            for n, size in zip(v, sizes, strict=True)
        ]
    return [(v, frame) for frame, v in found.items() if any(n != graph.zero for n in v)]


def _joints(kinematics: Kinematics) -> dict[Any, _Joint]:
    """Return the points that a hinge is at."""
    k = kinematics
    hung: dict[Any, set[Any]] = {}
    for point in k.placed():
        base, _ = k.way(point)
        hung.setdefault(base, set()).update(frame for _, frame in k.parts(point))
    for body in k.body.bodies:
        frame = k.frames.axes(body.frame) if is_rigid(body) else None
        hung.setdefault(body.masscenter, set()).add(frame)
    found: dict[Any, _Joint] = {}
    for point, frames in hung.items():
        step = point and k.fixed_step(point)
        if not step or len(frames) != 1:
            continue
        base, before, place = step
        (frame,) = frames
        if frame is None or frame is before or frame is k.inertial:
            continue
        if frame not in k.tree.oriented:
            continue
        inner = k.frames.parent(frame)
        axis = hinge_axis(k, frame, inner)
        if axis is None:
            continue
        direction = [k.graph.one if i == axis else k.graph.zero for i in range(3)]
        while k.frames.is_fixed(inner):
            direction = turned(k.graph, transposed(k.frames.step(inner)), direction)
            inner = k.frames.parent(inner)
        if inner is before:
            n = _shortened(k, direction, before)
            found[point] = _Joint(frame, axis, base, before, place, direction, n)
    return found


def _shortened(kinematics: Kinematics, direction: Vec, before: Any) -> int:
    """Return the component of a place that is taken off, beside that along the hinge before."""
    g = kinematics.graph
    along = hinge_axis(kinematics, before, kinematics.frames.parent(before))
    sizes = [abs(g.value(n) or 0.0) for n in direction]
    if None in [g.value(n) for n in direction]:
        # By symbols: what is no number is not zero in general.
        sizes = [float(n != g.zero) for n in direction]
    if along is not None and sum(size > 0.0 for size in sizes) > 1:
        sizes[along] = 0.0
    return sizes.index(max(sizes))
