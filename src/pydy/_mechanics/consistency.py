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
from pydy._graph import jacobian, rounding_bounds, signatures
from pydy._mechanics.components import flat, identity, numbers_of
from pydy._mechanics.equations import Equations
from pydy._mechanics.form import moving
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.inertia import points_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.rates import connected
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.symbols import find_symbols
from pydy._rank import DIGITS, ROUNDED, or_one

# What moves; its place, by components in axes; the derivatives of these, as velocities say; and
# points by which it belongs with others.
Moved = tuple[str, Vec, Vec, tuple[Any, ...]]


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
    rows = equations.constraints
    written = *body.coordinate_derivatives, *rows.holonomic, *rows.velocity
    given = find_symbols((*written, *rows.redundant.holonomic, *rows.redundant.velocity))
    functions = [s for s in functions if s not in given]
    if not functions:
        return
    bodies = body.bodies if equations.mechanism is None else equations.mechanism.bodies
    k = moving(replace(body, bodies=bodies), in_bodies=False)
    strange = {k.read(s): s for s in functions}
    held = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
    frames = [item.frame for item in bodies if is_rigid(item)]
    for where in dict.fromkeys([*(at for at, _ in k.body.loads), *points_of(k), *frames]):
        is_frame = isinstance(where, ReferenceFrame)
        if is_frame and where not in k.tree.frame_depth:
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
    slopes = jacobian(g, place, k.coordinates).flat()
    sizes = np.abs(_values(k, [*slopes, *rounding_bounds(g, slopes)], held))
    left, bounds = np.hsplit(sizes, 2)
    rows = np.reshape(left > ROUNDED * bounds, (-1, len(k.coordinates)))
    moves = {int(i) for i in np.nonzero(rows)[1]}
    for i, row in enumerate(jacobian(g, k.rates, k.speeds)):
        if i in moves and (lost := [j for j in row if j not in moved]):
            return k.body.coordinates[i], k.body.speeds[lost[0]]
    return None


def _place_of(k: Kinematics, where: Any) -> Vec:
    """Return the components that orient a frame, or locate a point from another one."""
    if isinstance(where, ReferenceFrame):
        return [*k.vector(where.x, k.inertial), *k.vector(where.y, k.inertial)]
    fixed = (way for p, way in FrameTree.positions(where).items() if k.tree.velocity(p) == 0)
    nodes = [n for way in fixed for n in k.vector(way, k.inertial)]
    while (base := k.way(where)[0]) is not None:
        nodes += [n for r, frame in k.parts(where) for n in k.expressed(r, frame, k.inertial)]
        where = base
    return nodes


def warn_of_kinematics(equations: Equations) -> None:
    """Warn if other derivatives of the coordinates fit all velocities that were given.

    Velocities that share no coordinates are looked at apart.
    """
    body, mechanism = equations.multibody, equations.mechanism
    if body is None or mechanism is None or not mechanism.bodies or body.velocity:
        return
    try:
        k = Kinematics(replace(body, bodies=mechanism.bodies), in_bodies=False)
        turns = [orthogonality_residuals([matrix], k.read) for matrix in k.tree.rotation_matrices()]
        # A quaternion's matrix has three rows: its columns' lengths are one. More are of cosines.
        every = [] if any(len(rows) > 3 for rows in turns) else [*_frames(k), *_points(k)]
    except (NotImplementedError, TypeError, ValueError):
        if equations.formed is not None:
            raise
        return  # a method's own equations may hold what cannot be formed here
    held = [row for rows in turns for row in rows]
    apart = _apart(k, every, held)
    if not any(map(np.any, apart)):
        return
    told: list[str] = []
    wrong: set[int] = set()
    for group in connected([_holds(k, *item) for item in every]):
        own, unlike = [every[i] for i in group], [apart[i] for i in group]
        if any(map(np.any, unlike)) and all(_depends_alike(k, *item) for item in own):
            others = _others(k, own, np.concatenate(unlike), held)
            wrong.update(others)
            if others:
                told += [what for (what, *_), rows in zip(own, unlike, strict=True) if rows.any()]
    if told:
        rates = [body.coordinates[i] for i in sorted(wrong)]
        warn_user(
            f"The kinematic equations do not fit the velocities: with the derivatives of "
            f"{describe(rates)} that they give, {describe(told)} would not be what was set, and "
            "with others all would. Give those (`kd_eqs` of a KanesMethod, `kinematic_equations` "
            "of a Definition; without them each coordinate's derivative is the speed at its "
            "place), or correct the velocities."
        )


def _frames(k: Kinematics) -> Iterator[Moved]:
    """Yield the frames that orient the bodies, with their parents where known."""
    seen = {k.inertial}
    for frame in (item.frame for item in k.body.bodies if is_rigid(item)):
        while frame not in seen and frame in k.tree.frame_depth:
            seen.add(frame)
            parent = k.tree.parent(frame)
            if k.tree.turns_in(frame) is parent:
                axes = k.frames.given(frame, parent)
                w = k.vector(k.tree.relative_spin(frame, parent), parent)
            else:
                axes = [k.expressed(unit, frame, k.inertial) for unit in identity(k.graph)]
                w = k.spin(frame, k.inertial)[0]
            turned = [n for axis in axes for n in k.cross(w, axis)]
            yield f"the angular velocity of {frame}", flat(axes), turned, ()
            frame = parent


def _points(k: Kinematics) -> Iterator[Moved]:
    """Yield the mass centres that are placed along inertial axes from a point at rest.

    Along other axes that point may be where a wheel touches the ground, at rest for an instant.
    """
    found: dict[Any, tuple[Vec, Any]] = {}
    for point in (item.masscenter for item in k.body.bodies):
        found.update(_from_rest(k, point))
    for point, (place, base) in found.items():
        velocity = k.vector(k.tree.velocity(point), k.inertial)
        yield f"the velocity of {point}", place, velocity, (point, *({base} & found.keys()))


def _from_rest(k: Kinematics, point: Any) -> dict[Any, tuple[Vec, Any]]:
    """Return a point's place along inertial axes from the nearest point at rest, if there is one.

    Beside it is the point before it, which must move as its own place says, as a wheel's hub does
    not: all on the way are returned. The way ends at the point at rest, which may be at rest there.
    """
    before: dict[Any, Any] = {point: None}
    for other in (todo := [point]):
        if getattr(k.tree.velocity(other), "args", None) == []:
            break
        if k.tree.velocity(other) is not None:
            ways = FrameTree.positions(other).items()
            near = [p for p, way in ways if {f for _, f in way.args} <= {k.inertial}]
            todo += [p for p in near if p not in before]
            before |= {p: other for p in near if p not in before}
    else:
        return {}
    found: dict[Any, tuple[Vec, Any]] = {}
    place = [k.graph.zero] * 3
    while (after := before[other]) is not None:
        place = k.plus(place, k.vector(FrameTree.positions(after)[other], k.inertial))
        found[after] = place, other
        other = after
    return found


def _holds(k: Kinematics, what: str, place: Vec, velocity: Vec, points: Any) -> list[Any]:
    """Return the places of coordinates, and the points, by which a velocity belongs with others."""
    moves = jacobian(k.graph, place, k.coordinates)
    return [*dict.fromkeys(i for row in moves for i in row), *points]


def _depends_alike(k: Kinematics, what: str, place: Vec, velocity: Vec, points: Any) -> bool:
    """Return whether a velocity holds no constant or specified that its place and q' have not."""
    g, known = k.graph, {*k.coordinates, *k.speeds}
    known |= {*g.reachable([*place, *k.dt(place)])}
    return known.issuperset(g.inputs(velocity))


def _values(k: Kinematics, nodes: list[int], held: list[int]) -> np.ndarray:
    """Return values at random states where all of them are finite; there may be none."""
    with np.errstate(all="ignore"):
        found = numbers_of(k.graph, nodes, held)
    values: np.ndarray = found[np.isfinite(found).all(axis=1)]
    return values


def _apart(k: Kinematics, every: Sequence[Moved], held: list[int]) -> list[np.ndarray]:
    """Return for each velocity which of its components are not how the place changes.

    They differ by more than typed digits of their terms make, at some random state.
    """
    pairs = [both for _, place, v, _ in every for both in zip(v, k.dt(place), strict=True)]
    left = [i for i, (says, follows) in enumerate(pairs) if says != follows]
    known = signatures(k.graph, [n for i in left for n in pairs[i]])
    left = [i for j, i in enumerate(left) if known[2 * j] != known[2 * j + 1]]
    found = np.zeros(len(pairs), dtype=bool)
    flat = [n for i in left for n in pairs[i]]
    with np.errstate(all="ignore"):
        values = numbers_of(k.graph, [*flat, *rounding_bounds(k.graph, flat, constants=True)], held)
    both, bounds = np.split(values.reshape(len(values), -1, 2), 2, axis=1)
    more = np.abs(both[..., 0] - both[..., 1]) > DIGITS * bounds.sum(axis=2)
    found[left] = (more & np.isfinite(bounds).all(axis=2)).any(axis=0)
    return np.split(found, np.cumsum([len(place) for _, place, *_ in every])[:-1])


def _others(
    k: Kinematics, every: Sequence[Moved], unlike: np.ndarray, held: list[int]
) -> list[int]:
    """Return the coordinates whose derivatives are others where all velocities fit, if any do.

    They are told from the components that are `unlike`.
    """
    place = [n for _, own, *_ in every for n in own]
    velocity = [n for _, _, own, _ in every for n in own]
    slopes = jacobian(k.graph, place, k.coordinates).flat()
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
        shares = np.abs(matrix * more) > DIGITS * bound[:, None]
        wrong |= shares[unlike].any(axis=0)
    return [i for i in range(n) if wrong[i]]
