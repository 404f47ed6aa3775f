"""A warning of velocities that the user set, and that positions do not explain.

The equations contain the velocities that were set, whatever the positions are. Three kinds of them
need not be the derivatives of positions: those of a rolling wheel, whose points move as if they
turned about the point where it touches; those with a speed whose coordinate was omitted, as of a
symmetric rotor, of angles that are small, or of a position that nothing depends on; and those that
take an input, such as an angle, for constant. Of others the term ω × r was forgotten, or a sign is
wrong.

Constraints may have been used to shorten velocities, so that these are compared at states that
satisfy them. A square root among them may belong to one of several branches: a velocity that fits
at one random state is accepted.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import accumulate
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm

from pydy._checks import describe
from pydy._errors import warn_user
from pydy._graph import inputs_of
from pydy._mechanics.components import (
    consistent_numbers,
    finite_rows,
    identity,
    nonzero_somewhere,
    numbers_of,
)
from pydy._mechanics.formulations import moving
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.symbols import find_symbols
from pydy._rank import DIGITS

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody

    from pydy._mechanics.frame_tree import AnyFrame, BaseAndSteps


def warn_of_velocities(
    body: Multibody, differing: Collection[Point], unneeded: Mapping[Point, BaseAndSteps]
) -> None:
    """Warn of points whose velocity was set and is not the derivative of the position.

    The equations contain the positions of the points `differing`, not those of the points
    `unneeded`: the mapping has the point that each of these is located from, and the vectors from
    there.
    """
    bases = [base for base, _ in unneeded.values()]
    k = moving(body, in_bodies=False, fixed_honoured=differing, further_points=bases)
    for point, (base, steps) in unneeded.items():
        parts = [part for step in steps for part in step.args]
        k.reroute(point, base, [k.frames.in_axes(k.read.all(v), frame) for v, frame in parts])
    frames = dict.fromkeys(item.frame for item in body.bodies if is_rigid(item))
    spins = {k.frames.axes(frame): k.spin(frame, k.inertial)[0] for frame in frames}
    moved = [v for point in k.moved() for pair in _offsets(k, point) for v in pair]
    located = {*inputs_of(k.graph, [n for v in (*spins.values(), *moved) for n in v])}
    rows = k.read.all((*body.constraints.holonomic, *body.constraints.velocity))
    candidates = dict.fromkeys((*differing, *unneeded))
    points = [point for point in candidates if not _is_explained(k, point, spins, located, rows)]
    if points:
        origins = list(dict.fromkeys(k.path(point)[0] for point in points))
        warn_user(
            f"The velocities that were set for {describe(points)} are not the derivatives of "
            f"their positions from {describe(origins)}, and the equations "
            "contain them as they are. Use `v1pt_theory`, `v2pt_theory`, or set no velocity: it "
            "is derived then."
        )


def warn_of_angular_velocities(
    k: Kinematics, frames: Mapping[ReferenceFrame, tuple[Vec, Vec]], zero_rows: list[int]
) -> None:
    """Warn of frames whose angular velocity was set and does not follow from the orientation.

    For each frame, the components of its axes and their derivatives according to what was set.
    """
    wrong: list[ReferenceFrame] = []
    rotors: list[ReferenceFrame] = []
    for frame, (axes, rates) in frames.items():
        parent = k.tree.parent(frame)
        turn = find_symbols(k.tree.rotation(frame, parent)) if parent is not None else ()
        if all(isinstance(s, sm.Symbol) for s in turn):
            continue  # its own angles were omitted, since they are small
        flat = [*axes, *rates, *k.dt(axes)]
        values = finite_rows(consistent_numbers(k.graph, flat, zero_rows))
        if not len(values):
            continue
        turned, as_set, by_angles = np.moveaxis(values.reshape(len(values), 3, 3, 3), 1, 0)
        # Δω, of which the axes' derivatives differ by Δω × e.
        difference = np.cross(turned, as_set - by_angles).sum(axis=1) / 2.0
        in_frame = np.einsum("mij,mj->mi", turned, difference)
        bodies = [item for item in k.body.bodies if is_rigid(item) and item.frame is frame]
        if bodies:
            is_rotor = all(_is_rotor(k, item, in_frame) for item in bodies)
            (rotors if is_rotor else wrong).append(frame)
    if rotors and _along_turning_axes(k, zero_rows):
        wrong += rotors
    if wrong:
        warn_user(
            f"The angular velocities that were set for {describe(wrong)} are not those of their "
            "orientations, and the equations contain them as they are. Set the components along "
            "the axes of the rotations, or set none: an orientation gives one."
        )


def _is_rotor(k: Kinematics, item: RigidBody, difference: np.ndarray) -> bool:
    """Return whether a body may turn so without a change of its inertia: about an axis of symmetry.

    The `difference` of angular velocities is in its axes.
    """
    _, sizes, directions = np.linalg.svd(difference)
    if not sizes[1] <= DIGITS * sizes[0]:
        return False
    axis = directions[0]
    matrix = k.tensor(item.central_inertia.args, item.frame)
    moments = numbers_of(k.graph, [n for row in matrix for n in row])[0].reshape(3, 3)
    across = np.eye(3) - np.outer(axis, axis)
    transverse = across @ moments @ across
    other = np.trace(transverse) / 2.0
    size = DIGITS * np.abs(moments).max(initial=0.0)
    coupled = moments @ axis - (axis @ moments @ axis) * axis
    return bool(np.abs(transverse - other * across).max() <= size and np.abs(coupled).max() <= size)


def _along_turning_axes(k: Kinematics, zero_rows: list[int]) -> bool:
    """Return whether a body's velocity is written along axes whose angular velocity is not theirs.

    Its derivative, c' e + c ω × e for a component c along e, is wrong then, so that a rotor whose
    angle was omitted must be written along the axes of its bearing, or its own axis.
    """
    g = k.graph
    vectors = [k.tree.velocity(item.masscenter) for item in k.body.bodies]
    vectors += [item.frame.ang_vel_in(k.inertial) for item in k.body.bodies if is_rigid(item)]
    errors: dict[ReferenceFrame, list[Vec]] = {}
    totals: Vec = []
    for vector in vectors:
        total = [g.zero] * 3
        for components, frame in () if vector is None else vector.args:
            if frame not in errors:
                w = k.spin(frame, k.inertial)[0]
                axes = [k.expressed(unit, frame, k.inertial) for unit in identity(g)]
                pairs = [(k.cross(w, e), k.dt(e)) for e in axes]
                errors[frame] = [
                    [g.sub(x, y) for x, y in zip(*pair, strict=True)] for pair in pairs
                ]
            for c, error in zip(k.read.all(components), errors[frame], strict=True):
                total = k.plus(total, [g.mul(c, x) for x in error])
        totals += total
    return bool(nonzero_somewhere(g, totals, zero_rows).any())


def _is_explained(
    k: Kinematics,
    point: Point,
    spins: Mapping[AnyFrame, Vec],
    located: set[int],
    constraints: list[int],
) -> bool:
    """Return whether a velocity is that of a wheel, or has the speed of an omitted coordinate.

    That is none of the inputs of motions that follow from positions and orientations, `located`.
    Of `constraints` each is zero.
    """
    g, (base, _) = k.graph, k.path(point)
    given = k.vector(k.tree.velocity(point), k.inertial)
    if base is None:
        return True
    home, velocity, _ = k.motion(base)
    before = k.expressed(velocity, home, k.inertial)
    if not located.union(inputs_of(g, before)).issuperset(inputs_of(g, given)):
        return True
    offsets, rates = zip(*_offsets(k, point), strict=True)
    # Nothing turns with a body, or the first parts do so about the point that they start from.
    turned = list(accumulate(offsets, k.plus))
    following = [k.plus(before, *rates[j + 1 :]) for j in range(len(rates))]
    pairs = list(zip(turned, following, strict=True))
    candidates = [k.plus(before, *rates)]
    # A wheel turns relative to the axes that its centre is located along, which turn with a fork.
    below = {a for _, axes in k.parts(point) for a in k.frames.path_to_inertial(axes)[1:]}
    wheels = [w for axes, w in spins.items() if axes not in below]
    candidates += [k.plus(k.cross(w, r), rest) for w in wheels for r, rest in pairs]
    # Inputs may be taken for constant, whose rates are zero then; quaternions have unit length.
    inputs = enumerate(k.read.specifieds)
    resting = [g.input("r", i) for i, s in inputs if isinstance(s, sm.Derivative)]
    lengths = [n for m in k.tree.rotation_matrices() for n in orthogonality_residuals([m], k.read)]
    flat = [n for v in (given, before, *candidates) for n in v]
    values = finite_rows(consistent_numbers(g, flat, [*lengths, *constraints], resting))
    if not len(values):  # outside the domain of a function, or not assembled: nothing is known
        return True
    as_set, base_velocity, *others = np.moveaxis(values.reshape(len(values), -1, 3), 1, 0)
    alike = []
    for candidate in others:  # terms may cancel: a wheel is at rest where it touches
        parts = (as_set, base_velocity, candidate - base_velocity)
        size = sum(np.linalg.norm(part, axis=1) for part in parts)
        alike.append(np.linalg.norm(candidate - as_set, axis=1) <= DIGITS * size)
    # Constraints may have been used to shorten the velocities, on one of their branches.
    return bool(np.any(alike) if constraints else np.all(alike, axis=1).any())


def _offsets(k: Kinematics, point: Point) -> list[tuple[Vec, Vec]]:
    """Return the vectors to a point from the one that it is located from, and their derivatives."""
    pairs = []
    for r, frame in k.parts(point):
        rate = k.plus(k.cross(k.spin(frame)[0], r), k.dt(r))
        pairs.append((k.expressed(r, frame, k.inertial), k.expressed(rate, frame, k.inertial)))
    return pairs
