"""Whether the kinematic equations give the motion that the velocities say.

Velocities that hold some function of time where a speed belongs are refused: they move nothing, so
that inertia and loads would be lost.

Velocities that a user sets need not follow from places: those of a disc that rolls may hold its
constraint, and a symmetric rotor's orientation may be left out. They are honoured. But where other
derivatives of the coordinates would make all of them follow, the kinematic equations are wrong.

What cannot be told is left alone: mechanisms with constraints, where velocities may hold on one
branch only, orientations by nine cosines, and velocities that depend on what the places do not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import ReferenceFrame

from pydy._checks import describe
from pydy._errors import warn_user
from pydy._graph.derivative import dense_jacobian, jacobian
from pydy._graph.rounding import rounding_bounds
from pydy._mechanics.components import numbers_of
from pydy._mechanics.equations import Equations
from pydy._mechanics.form import moving
from pydy._mechanics.frames import orientation_rows, rotations
from pydy._mechanics.inertia import points_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.reader import is_rigid, places
from pydy._mechanics.symbols import find_symbols
from pydy._rank import DIGITS, ROUNDED, or_one

# What moves; its place, by components in axes; and the derivatives of these, as velocities say.
Moved = tuple[str, Vec, Vec]
# A quaternion's matrix has three orthogonal columns, whose lengths are one: rows more are cosines'.
_LENGTHS = 3


def check_velocities(equations: Equations) -> None:
    """Refuse velocities with some function of time in place of a speed: inertia would be lost.

    What they are of moves with a coordinate, but by no speed. Functions that the kinematic
    equations or constraints hold are prescribed motions, as that coordinate's may be.
    """
    body, formed = equations.multibody, equations.formed
    if body is None or formed is None:
        return
    functions = [s for s in formed.specifieds if isinstance(s, AppliedUndef)]
    if not functions:
        return
    said = (*body.coordinate_derivatives, *equations.holonomic, *equations.velocity)
    given = find_symbols((*said, *(e for part in equations.left_out for e in part)))
    functions = [s for s in functions if s not in given]
    if not functions:
        return
    bodies = body.bodies if equations.mechanism is None else equations.mechanism.bodies
    k = moving(replace(body, bodies=bodies), in_bodies=False)
    strange = {k.read(s): s for s in functions}
    held = orientation_rows(rotations(body.frame), k.read)
    frames = [item.frame for item in bodies if is_rigid(item)]
    for where in dict.fromkeys([*(at for at, _ in k.body.loads), *points_of(k), *frames]):
        is_frame = isinstance(where, ReferenceFrame)
        if is_frame and where not in k.tree.oriented:
            continue
        velocity = k.spin(where)[0] if is_frame else k.motion(where)[1]
        found = [strange[n] for n in k.graph.reachable(velocity) if n in strange]
        if found and (lost := _unmoved(k, velocity, _place_of(k, where), held)):
            q, speed = lost
            raise ValueError(
                f"Inertia and loads of {where} would be lost: {where} moves with `{q}`, but by "
                f"the velocities that were set it moves with `{found[0]}`. That is no speed: set "
                f"velocities in the speeds, such as `{speed}`, or, if it is a prescribed motion, "
                f"constrain `{speed}` to it."
            )


def _unmoved(k: Kinematics, velocity: Vec, place: Vec, held: list[int]) -> tuple[Any, Any] | None:
    """Return a coordinate that a place moves with, and its speed, by which no velocity does.

    With constraints velocities may be written in some of the speeds: there none must be held.
    """
    g = k.graph
    moved = {j for row in jacobian(g, velocity, k.speeds) for j in row}
    if k.body.velocity and moved:
        return None
    slopes = dense_jacobian(g, place, k.coordinates)
    sizes = np.abs(_values(k, [*slopes, *rounding_bounds(g, slopes)], held))
    left, bounds = np.hsplit(sizes, 2)
    rows = np.reshape(left > ROUNDED * bounds, (-1, len(k.coordinates)))
    moves = {int(i) for i in np.nonzero(rows)[1]}
    for i, row in enumerate(jacobian(g, k.rates, k.speeds)):
        if i in moves and (lost := [j for j in row if j not in moved]):
            return k.body.coordinates[i], k.body.speeds[lost[0]]
    return None


def _place_of(k: Kinematics, where: Any) -> Vec:
    """Return components of what turns a frame, or leads to a point from one that may be fixed."""
    if isinstance(where, ReferenceFrame):
        return [*k.vector(where.x, k.inertial), *k.vector(where.y, k.inertial)]
    fixed = (way for p, way in places(where).items() if k.tree.velocity(p) == 0)
    nodes = [n for way in fixed for n in k.vector(way, k.inertial)]
    while (base := k.way(where)[0]) is not None:
        nodes += [n for r, frame in k.parts(where) for n in k.expressed(r, frame, k.inertial)]
        where = base
    return nodes


def warn_of_kinematics(equations: Equations) -> None:
    """Warn if other derivatives of the coordinates fit all velocities that were given."""
    body, mechanism = equations.multibody, equations.mechanism
    if equations.formed is None or body is None or mechanism is None or not mechanism.bodies:
        return
    if body.velocity:
        return
    kinematics = Kinematics(replace(body, bodies=mechanism.bodies), in_bodies=False)
    matrices = rotations(body.frame)
    turns = [orientation_rows([matrix], kinematics.read) for matrix in matrices]
    if any(len(rows) > _LENGTHS for rows in turns):
        return
    held = [row for rows in turns for row in rows]
    every = [*_frames(kinematics), *_points(kinematics)]
    if not all(_depends_alike(kinematics, place, velocity) for _, place, velocity in every):
        return
    agree = _agree(kinematics, every, held)
    unlike = [what for (what, *_), well in zip(every, agree, strict=True) if not well]
    if unlike and (wrong := _others(kinematics, every, held)):
        warn_user(
            f"The kinematic equations do not fit the velocities: with the derivatives of "
            f"{describe(wrong)} that they give, {describe(unlike)} would not be what was set, and "
            "with others all would. Give those (`kd_eqs` of a KanesMethod, `kinematic_equations` "
            "of a Definition; without them each coordinate's derivative is the speed at its "
            "place), or correct the velocities."
        )


def _frames(k: Kinematics) -> Iterator[Moved]:
    """Yield the frames by which bodies are oriented, beside their parents where that is known."""
    seen = {k.inertial}
    for frame in (item.frame for item in k.body.bodies if is_rigid(item)):
        while frame not in seen and frame in k.tree.oriented:
            seen.add(frame)
            parent, g = k.tree.parent(frame), k.graph
            if k.tree.turns_in(frame) is parent:
                axes = k.frames.given(frame, parent)
                w = k.vector(k.tree.relative_spin(frame, parent), parent)
            else:
                units = [[g.one if i == j else g.zero for j in range(3)] for i in range(3)]
                axes = [k.expressed(unit, frame, k.inertial) for unit in units]
                w = k.spin(frame, k.inertial)[0]
            turned = [n for axis in axes for n in k.cross(w, axis)]
            yield f"the angular velocity of {frame}", [n for axis in axes for n in axis], turned
            frame = parent


def _points(k: Kinematics) -> Iterator[Moved]:
    """Yield the mass centres that are placed along inertial axes from a point at rest.

    Along other axes that point may be where a wheel touches the ground, at rest for an instant.
    """
    for point in (item.masscenter for item in k.body.bodies):
        for origin, way in places(point).items():
            rests = getattr(k.tree.velocity(origin), "args", None) == []
            velocity = k.tree.velocity(point)
            if rests and velocity is not None and {f for _, f in way.args} <= {k.inertial}:
                given = k.vector(way, k.inertial), k.vector(velocity, k.inertial)
                yield f"the velocity of {point}", *given
                break


def _depends_alike(k: Kinematics, place: Vec, velocity: Vec) -> bool:
    """Return whether a velocity holds no constant or specified that its place and q' have not."""
    g, known = k.graph, {*k.coordinates, *k.speeds}
    known |= {*g.reachable([*place, *k.dt(place)])}
    return all(n in known for n in g.reachable(velocity) if g.ops[n] == "input")


def _values(k: Kinematics, nodes: list[int], held: list[int]) -> np.ndarray:
    """Return values at random states, those where all are numbers; there may be none."""
    with np.errstate(all="ignore"):
        found = numbers_of(k.graph, nodes, held)
    values: np.ndarray = found[np.isfinite(found).all(axis=1)]
    return values


def _agree(k: Kinematics, every: Sequence[Moved], held: list[int]) -> list[bool]:
    """Return whether velocities are how places change, at random states."""
    nodes = [n for _, place, velocity in every for n in (*velocity, *k.dt(place))]
    values, found, first = _values(k, nodes, held), [], 0
    for _, place, _ in every:
        n = len(place)
        says, follows = values[:, first : first + n], values[:, first + n : first + 2 * n]
        size = np.linalg.norm(says, axis=1) + np.linalg.norm(follows, axis=1)
        found.append(bool((np.linalg.norm(says - follows, axis=1) <= DIGITS * size).all()))
        first += 2 * n
    return found


def _others(k: Kinematics, every: Sequence[Moved], held: list[int]) -> list[Any]:
    """Return the coordinates whose derivatives are others where all velocities fit, if any do."""
    place = [n for _, own, _ in every for n in own]
    velocity = [n for _, _, own in every for n in own]
    slopes = dense_jacobian(k.graph, place, k.coordinates)
    m, n = len(place), len(k.coordinates)
    values = _values(k, [*slopes, *velocity, *k.dt(place)], held)
    wrong = np.zeros(n, dtype=bool)
    for row in values:
        matrix, says, follows = row[: m * n].reshape(m, n), row[m * n : -m], row[-m:]
        tall = or_one(np.abs(matrix).max(axis=1))[:, None]
        wide = or_one(np.abs(matrix / tall).max(axis=0))
        more = np.linalg.lstsq(matrix / tall / wide, (says - follows) / tall[:, 0])[0] / wide
        bound = np.abs(says) + np.abs(follows) + np.abs(matrix) @ np.abs(more)
        if not (np.abs(says - follows - matrix @ more) <= DIGITS * bound).all():
            return []
        wrong |= np.abs(matrix * more).max(axis=0) > DIGITS * bound.max()
    return [symbol for symbol, other in zip(k.body.coordinates, wrong, strict=True) if other]
