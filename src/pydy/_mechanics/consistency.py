"""Checks that the kinematic equations are consistent with the velocities that the user set.

Velocities with a function of time in place of a speed are refused: they would have no partial
velocity, so that inertia and loads would be lost.

Velocities that a user sets need not be the derivatives of positions: those of a rolling disc may
include its constraint, and the orientation of a symmetric rotor may be omitted. They are accepted.
But if all of them follow from other derivatives of the coordinates, the kinematic equations are
wrong; and what neither explains is wrong itself (`pydy._mechanics.set_velocities`). So is an
inertia that does not turn with its body (`pydy._mechanics.set_inertias`), and an acceleration that
is not the derivative of the velocity (`pydy._mechanics.set_accelerations`).

Not checked are orientations by nine cosines, and velocities that depend on symbols that the
positions do not have.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import ReferenceFrame

from pydy._checks import describe
from pydy._errors import warn_user
from pydy._graph import inputs_of, jacobian, rounding_bounds, signatures
from pydy._mechanics.components import consistent_numbers, finite_rows, flat, identity
from pydy._mechanics.equations import Equations
from pydy._mechanics.formulations import moving
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.inertia import points_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.rates import connected
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.symbols import find_symbols
from pydy._rank import DIGITS, ROUNDED, or_one

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, RigidBody

    from pydy._sympy_types import Location, TimeFunction

# A label; the components of a position or orientation; their derivatives according to the
# velocities; and the points that relate it to others.
Moved: TypeAlias = "tuple[str, Vec, Vec, tuple[Point, ...]]"


def check_velocities(equations: Equations) -> None:
    """Refuse velocities with a function of time in place of a speed: inertia would be lost.

    The position depends on a coordinate, but the velocity on no speed. Functions in the kinematic
    equations or constraints are prescribed motions.
    """
    body, formed = equations.multibody, equations.formed
    if body is None or formed is None:
        return
    functions = [s for s in formed.specifieds if isinstance(s, AppliedUndef)]
    if not functions:
        return
    rows = equations.constraints
    written = *body.kinematics.coordinate_derivatives, *rows.holonomic, *rows.velocity
    prescribed = find_symbols((*written, *rows.redundant.holonomic, *rows.redundant.velocity))
    functions = [s for s in functions if s not in prescribed]
    if not functions:
        return
    bodies = body.bodies if equations.mechanism is None else equations.mechanism.bodies
    k = moving(replace(body, bodies=bodies), in_bodies=False)
    functions_by_node = {k.read(s): s for s in functions}
    zero_rows = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
    frames = [item.frame for item in bodies if is_rigid(item)]
    for location in dict.fromkeys([*(at for at, _ in k.body.loads), *points_of(k), *frames]):
        is_frame = isinstance(location, ReferenceFrame)
        if is_frame and location not in k.tree.frame_depth:
            continue
        velocity = k.spin(location)[0] if is_frame else k.motion(location)[1]
        foreign = [
            functions_by_node[n] for n in k.graph.reachable(velocity) if n in functions_by_node
        ]
        unused = _unmoved(k, velocity, _position_of(k, location), zero_rows) if foreign else None
        if unused is not None:
            q, speed = unused
            raise ValueError(
                f"Inertia and loads of {location} would be lost: {location} moves with `{q}`, but "
                f"by the velocities that were set it moves with `{foreign[0]}`. That is no speed: "
                f"set velocities in the speeds, such as `{speed}`, or, if it is a prescribed "
                f"motion, constrain `{speed}` to it."
            )


def _unmoved(
    k: Kinematics, velocity: Vec, position: Vec, zero_rows: list[int]
) -> tuple[TimeFunction, TimeFunction] | None:
    """Return a coordinate that a position depends on, and its speed if no velocity has it.

    With constraints velocities may be written in some of the speeds: one speed is then enough.
    """
    g = k.graph
    moved = {j for row in jacobian(g, velocity, k.speeds) for j in row}
    if k.body.constraints.velocity and moved:
        return None
    slopes = jacobian(g, position, k.coordinates).flat()
    sized = [*slopes, *rounding_bounds(g, slopes)]
    sizes = np.abs(finite_rows(consistent_numbers(g, sized, zero_rows)))
    magnitudes, bounds = np.hsplit(sizes, 2)
    rows = np.reshape(magnitudes > ROUNDED * bounds, (-1, len(k.coordinates)))
    moving = {int(i) for i in np.nonzero(rows)[1]}
    for i, row in enumerate(jacobian(g, k.rates, k.speeds)):
        if i in moving and (unused := [j for j in row if j not in moved]):
            return k.body.coordinates[i], k.body.speeds[unused[0]]
    return None


def _position_of(k: Kinematics, location: Location) -> Vec:
    """Return the components that orient a frame, or locate a point from another one."""
    if isinstance(location, ReferenceFrame):
        return [*k.vector(location.x, k.inertial), *k.vector(location.y, k.inertial)]
    fixed = (
        offset for p, offset in FrameTree.positions(location).items() if k.tree.velocity(p) == 0
    )
    nodes = [n for offset in fixed for n in k.vector(offset, k.inertial)]
    while (base := k.path(location)[0]) is not None:
        nodes += [n for r, frame in k.parts(location) for n in k.expressed(r, frame, k.inertial)]
        location = base
    return nodes


def warn_of_kinematics(equations: Equations) -> None:
    """Warn if other derivatives of the coordinates fit all velocities that were set.

    Groups of velocities that share no coordinates are checked separately.
    """
    body, mechanism = equations.multibody, equations.mechanism
    if body is None or mechanism is None or not mechanism.bodies:
        return
    try:
        k = Kinematics(replace(body, bodies=mechanism.bodies), in_bodies=False)
        turns = [orthogonality_residuals([matrix], k.read) for matrix in k.tree.rotation_matrices()]
        # A quaternion has three rows: its columns have unit length. Nine cosines have more.
        by_cosines = any(len(rows) > 3 for rows in turns)
        frames = {} if by_cosines else dict(_frames(k))
        every = [] if by_cosines else [*frames.values(), *_points(k)]
        constraints = k.read.all((*body.constraints.holonomic, *body.constraints.velocity))
    except (NotImplementedError, TypeError, ValueError):
        if equations.formed is not None:
            raise
        return  # a method's own equations may contain functions that cannot be read here
    zero_rows = [*(row for rows in turns for row in rows), *constraints]
    differing = _differing(k, every, zero_rows)
    if not any(map(np.any, differing)):
        return
    misfits: list[str] = []
    wrong: set[int] = set()
    unexplained: list[Moved] = []
    for group in connected([_dependencies(k, *item) for item in every]):
        members, unlike = [every[i] for i in group], [differing[i] for i in group]
        if any(map(np.any, unlike)) and all(_depends_alike(k, *item) for item in members):
            affected = _wrong_coordinates(k, members, np.concatenate(unlike), zero_rows)
            wrong.update(affected)
            if affected:
                misfits += [
                    label for (label, *_), rows in zip(members, unlike, strict=True) if rows.any()
                ]
            else:
                unexplained += [m for m, rows in zip(members, unlike, strict=True) if rows.any()]
    if misfits:
        rates = [body.coordinates[i] for i in sorted(wrong)]
        warn_user(
            f"The kinematic equations do not fit the velocities: with the derivatives of "
            f"{describe(rates)} that they give, {describe(misfits)} would not be what was set, and "
            "with others all would. Give those (`kd_eqs` of a KanesMethod, `kinematic_equations` "
            "of a Definition; without them each coordinate's derivative is the speed at its "
            "place), or correct the velocities."
        )
    elif unexplained:
        from pydy._mechanics.set_velocities import warn_of_angular_velocities

        spins = {f: item[1:3] for f, item in frames.items() if item in unexplained}
        warn_of_angular_velocities(k, spins, zero_rows)


def warn_of_inertias(equations: Equations) -> None:
    """Warn of bodies whose inertia was given along axes, or about a point, not fixed in the body.

    Functions of time among its components say that it changes; those are accepted.
    """
    body, mechanism = equations.multibody, equations.mechanism
    if body is None or mechanism is None:
        return
    candidates = [item for item in mechanism.bodies if is_rigid(item) and _turns_apart(item)]
    if candidates:
        from pydy._mechanics.set_inertias import warn_of_changing_inertias

        warn_of_changing_inertias(replace(body, bodies=mechanism.bodies), candidates)


def warn_of_accelerations(equations: Equations) -> None:
    """Warn of accelerations that were set and are not the derivatives of the velocities."""
    body, mechanism = equations.multibody, equations.mechanism
    if body is None or mechanism is None:
        return
    if body.lagrangian is not None:  # whose derivatives contain no acceleration
        return
    tree = FrameTree(body.frame)
    moved = [item for item in mechanism.bodies if tree.acceleration(item.masscenter)]
    rigid = [item for item in mechanism.bodies if is_rigid(item)]
    turned = [item for item in rigid if tree.angular_acceleration(item.frame)]
    if moved or turned:
        from pydy._mechanics.set_accelerations import warn_of_set_accelerations

        warn_of_set_accelerations(replace(body, bodies=mechanism.bodies), moved, turned)


def _turns_apart(item: RigidBody) -> bool:
    given, about = item.inertia
    if about is item.masscenter and all(
        f is item.frame for _, *vectors in given.args for v in vectors for _, f in v.args
    ):
        return False
    return all(isinstance(s, sm.Symbol) for s in find_symbols(size for size, *_ in given.args))


def _frames(k: Kinematics) -> Iterator[tuple[ReferenceFrame, Moved]]:
    """Yield the frames that orient the bodies, with their parents where known."""
    visited = {k.inertial}
    for frame in (item.frame for item in k.body.bodies if is_rigid(item)):
        while frame not in visited and frame in k.tree.frame_depth:
            visited.add(frame)
            parent = k.tree.parent(frame)
            if k.tree.turns_in(frame) is parent:
                axes = k.frames.user_rotation(frame, parent)
                w = k.vector(k.tree.relative_spin(frame, parent), parent)
            else:
                axes = [k.expressed(unit, frame, k.inertial) for unit in identity(k.graph)]
                w = k.spin(frame, k.inertial)[0]
            rates = [n for axis in axes for n in k.cross(w, axis)]
            yield frame, (f"the angular velocity of {frame}", flat(axes), rates, ())
            frame = parent


def _points(k: Kinematics) -> Iterator[Moved]:
    """Yield the mass centres that are located along inertial axes from a point at rest.

    Along other axes that point may be the contact of a wheel, which is at rest for an instant.
    """
    located: dict[Point, tuple[Vec, Point]] = {}
    for point in (item.masscenter for item in k.body.bodies):
        located.update(_from_rest(k, point))
    for point, (position, base) in located.items():
        velocity = k.vector(k.tree.velocity(point), k.inertial)
        yield f"the velocity of {point}", position, velocity, (point, *({base} & located.keys()))


def _from_rest(k: Kinematics, point: Point) -> dict[Point, tuple[Vec, Point]]:
    """Return positions along inertial axes from the nearest point at rest, if there is one.

    All points on the path are returned, each with the point before it: the velocity of that one
    must fit its position too, as that of a wheel's hub does not.
    """
    before: dict[Point, Point | None] = {point: None}
    for current in (todo := [point]):
        if getattr(k.tree.velocity(current), "args", None) == []:
            break
        if k.tree.velocity(current) is not None:
            neighbours = FrameTree.positions(current).items()
            near = [p for p, offset in neighbours if {f for _, f in offset.args} <= {k.inertial}]
            todo += [p for p in near if p not in before]
            before |= {p: current for p in near if p not in before}
    else:
        return {}
    located: dict[Point, tuple[Vec, Point]] = {}
    position = [k.graph.zero] * 3
    while (after := before[current]) is not None:
        position = k.plus(position, k.vector(FrameTree.positions(after)[current], k.inertial))
        located[after] = position, current
        current = after
    return located


def _dependencies(
    k: Kinematics, label: str, position: Vec, velocity: Vec, points: tuple[Point, ...]
) -> list[int | Point]:
    """Return the numbers of coordinates, and the points, that relate a velocity to others."""
    slopes = jacobian(k.graph, position, k.coordinates)
    return [*dict.fromkeys(i for row in slopes for i in row), *points]


def _depends_alike(
    k: Kinematics, label: str, position: Vec, velocity: Vec, points: tuple[Point, ...]
) -> bool:
    """Return whether all inputs of a velocity occur in its position and in q' too."""
    g, available = k.graph, {*k.coordinates, *k.speeds}
    available |= {*g.reachable([*position, *k.dt(position)])}
    return available.issuperset(inputs_of(g, velocity))


def _differing(k: Kinematics, every: Sequence[Moved], zero_rows: list[int]) -> list[np.ndarray]:
    """Return for each velocity which components differ from the rate of the position.

    At some random state, with constraints at all, they differ by more than the rounding of typed
    decimals.
    """
    pairs = [sides for _, position, v, _ in every for sides in zip(v, k.dt(position), strict=True)]
    unlike = [i for i, (says, follows) in enumerate(pairs) if says != follows]
    signature = signatures(k.graph, [n for i in unlike for n in pairs[i]])
    unlike = [i for j, i in enumerate(unlike) if signature[2 * j] != signature[2 * j + 1]]
    differs = np.zeros(len(pairs), dtype=bool)
    if unlike:
        flat = [n for i in unlike for n in pairs[i]]
        bounds_of = rounding_bounds(k.graph, flat, constants=True)
        values = consistent_numbers(k.graph, [*flat, *bounds_of], zero_rows)
        sides, bounds = np.split(values.reshape(len(values), 2 * len(unlike), 2), 2, axis=1)
        exceeds = np.abs(sides[..., 0] - sides[..., 1]) > DIGITS * bounds.sum(axis=2)
        exceeds &= np.isfinite(bounds).all(axis=2)
        # Constraints may have been used to shorten the velocities, on one of their branches.
        on_all = bool(k.body.constraints.velocity) and len(exceeds)
        differs[unlike] = exceeds.all(axis=0) if on_all else exceeds.any(axis=0)
    return np.split(differs, np.cumsum([len(position) for _, position, *_ in every])[:-1])


def _wrong_coordinates(
    k: Kinematics, every: Sequence[Moved], unlike: np.ndarray, zero_rows: list[int]
) -> list[int]:
    """Return the coordinates whose derivatives must change so that all velocities fit, if possible.

    They are identified by the components that are `unlike`.
    """
    position = [n for _, components, *_ in every for n in components]
    velocity = [n for _, _, components, _ in every for n in components]
    slopes = jacobian(k.graph, position, k.coordinates).flat()
    m, n = len(position), len(k.coordinates)
    nodes = [*slopes, *velocity, *k.dt(position)]
    values = finite_rows(consistent_numbers(k.graph, nodes, zero_rows))
    wrong = np.zeros(n, dtype=bool)
    for row in values:
        matrix, says, follows = row[: m * n].reshape(m, n), row[m * n : -m], row[-m:]
        tall = or_one(np.abs(matrix).max(axis=1))[:, None]
        wide = or_one(np.abs(matrix / tall).max(axis=0))
        corrections = np.linalg.lstsq(matrix / tall / wide, (says - follows) / tall[:, 0])[0] / wide
        bound = np.abs(says) + np.abs(follows) + np.abs(matrix) @ np.abs(corrections)
        if not (np.abs(says - follows - matrix @ corrections) <= DIGITS * bound).all():
            return []
        shares = np.abs(matrix * corrections) > DIGITS * bound[:, None]
        wrong |= shares[unlike].any(axis=0)
    return [i for i in range(n) if wrong[i]]
