"""Whether anything else than the joint that is cut joins the two sides of a cut.

A constraint is an expression of coordinates and speeds: it does not say which bodies it joins. Its
rate does. The rate of one between bodies of the same side is a combination of the velocities of
that side alone: it vanishes in all motions in which the bodies outside rest, or in all in which
those inside move as one rigid body. The rate of a constraint that joins both sides vanishes in
neither. All motions of the speeds count, also those that violate the constraints.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from pydy._graph import jacobian
from pydy._mechanics.components import numbers_of
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.reader import is_rigid
from pydy._rank import HALF, ROUNDED, or_one

if TYPE_CHECKING:
    from pydy._mechanics.kinematics import Kinematics, Vec
    from pydy._sympy_types import Body


@dataclass(frozen=True)
class Cut:
    """Two sides of a cut; the ground is outside.

    Attributes
    ----------
    inside, outside : bodies
    at_inside, at_outside : bodies
        Those that the point of the cut moves with; None is the ground.
    known : list of pairs of bodies inside, bodies outside
        Those that a point moves with where the force is known.
    """

    inside: Sequence[Body]
    outside: Sequence[Body]
    at_inside: Sequence[Body]
    at_outside: Sequence[Body | None]
    known: Sequence[tuple[Sequence[Body], Sequence[Body | None]]] = ()


def further_joints(motions: Motions, cut: Cut) -> tuple[bool, list[int]]:
    """Return whether the coordinates join the two sides elsewhere too, and constraints that do.

    Constraints that join one body to one other are the joint that is cut, or belong to it. Those
    of a joint whose force is known are left out. If the coordinates join the sides at the cut
    alone, its freedom remains when both sides are locked.
    """
    inside, outside, at_outside = cut.inside, cut.outside, cut.at_outside
    rest_outside, rigid_inside = motions.of(outside), motions.relative(inside)
    every = motions.of([*inside, *outside])
    pairs = [*product(cut.at_inside, at_outside)]
    joined = bool(pairs) and all(
        motions.locked(motions.joint(a, b), rest_outside, rigid_inside) for a, b in pairs
    )
    crossing = [
        j
        for j in range(motions.count)
        if motions.depends(j, every)  # else the velocities were simplified by constraints
        and not motions.depends(j, rest_outside)
        and not motions.depends(j, rigid_inside)
    ]
    if not at_outside:
        is_free = not outside or motions.is_free(inside, rest_outside)
        at_outside = [None, *outside] if is_free else []
    for a, b in product(cut.at_inside or inside, at_outside):
        if all(motions.depends(j, motions.joint(a, b)) for j in crossing):
            return joined, []
    for known_inside, known_outside in cut.known:
        ends = [*product(known_inside or inside, known_outside or [None, *outside])]
        crossing = [
            j for j in crossing if not any(motions.depends(j, motions.joint(a, b)) for a, b in ends)
        ]
    return joined, crossing


class Motions:
    """Velocities of bodies and rates of constraints by the speeds, at random configurations.

    `rows` are nodes of the constraints' rates, `holonomic` what is zero at consistent
    configurations.
    """

    def __init__(
        self, k: Kinematics, rows: Sequence[int], holonomic: Sequence[int], bodies: Sequence[Body]
    ) -> None:
        g, self._bodies = k.graph, list(bodies)
        velocities: Vec = []
        places: Vec = []
        for body in bodies:
            home, v = k.velocity_of(body.masscenter)
            spin = [g.zero] * 3
            if is_rigid(body):
                axes = k.frames.axes(body.frame)
                spin = k.expressed(k.spin(body.frame)[0], axes, k.inertial)
            velocities += [*k.expressed(v, home, k.inertial), *spin]
            places += k.vector(body.masscenter.pos_from(bodies[0].masscenter), k.inertial)
        slopes = jacobian(g, [*velocities, *rows], k.speeds).flat()
        zero_rows = [*orthogonality_residuals(k.tree.rotation_matrices(), k.read), *holonomic]
        values = numbers_of(g, [*places, *slopes], zero_rows)
        self._places = values[:, : len(places)].reshape(len(values), -1, 3)
        slopes_at = values[:, len(places) :].reshape(len(values), -1, len(k.speeds))
        # In units of the speeds, so that no result depends on a length.
        slopes_at = slopes_at / or_one(np.abs(slopes_at).max(axis=(0, 1)))
        count = len(velocities)
        motions = slopes_at[:, :count].reshape(len(values), -1, 2, 3, len(k.speeds))
        motions = _unrounded(motions, np.abs(motions).max(axis=(1, 3), keepdims=True))
        self._velocities = motions.reshape(len(values), -1, 6, len(k.speeds))
        self._rows = slopes_at[:, count:]
        self.count = len(rows)

    def of(self, bodies: Sequence[Body]) -> np.ndarray:
        """Return the velocities of bodies, shape (states, rows, speeds)."""
        at = [self._bodies.index(body) for body in bodies]
        states, _, _, speeds = self._velocities.shape
        return self._velocities[:, at].reshape(states, -1, speeds)

    def relative(self, bodies: Sequence[Body]) -> np.ndarray:
        """Return what is zero when bodies move as one, shape (states, rows, speeds)."""
        rigid = [body for body in bodies if is_rigid(body)]
        if not rigid:
            return self._changing_distances(bodies)
        first = self._bodies.index(rigid[0])
        v, w = np.split(self._velocities, 2, axis=2)
        parts = [np.zeros((len(v), 0, v.shape[-1]))]
        for body in bodies:
            k = self._bodies.index(body)
            ends = self._places[:, [k, first]]
            turned = np.cross((ends[:, 0] - ends[:, 1])[:, :, None], w[:, first], axis=1)
            # The arm has the rounding errors of both places, which may be far from the first body.
            reach = np.linalg.norm(ends, axis=2).sum(axis=1)[:, None, None]
            size = reach * np.linalg.norm(w[:, first], axis=1, keepdims=True)
            parts.append(_sum(v[:, k], -v[:, first], turned, size=size))
            if is_rigid(body):
                parts.append(_sum(w[:, k], -w[:, first]))
        return np.concatenate(parts, axis=1)

    def _changing_distances(self, bodies: Sequence[Body]) -> np.ndarray:
        at = [self._bodies.index(body) for body in bodies]
        v = self._velocities[:, :, :3]
        rates = [np.zeros((len(v), 0, v.shape[-1]))]
        for n, i in enumerate(at):
            for j in at[:n]:
                arm = self._places[:, i] - self._places[:, j]
                towards = [np.einsum("sa,sau->su", arm, v[:, b])[:, None] for b in (i, j)]
                reach = np.linalg.norm(self._places[:, [i, j]], axis=2).sum(axis=1)[:, None, None]
                size = reach * np.linalg.norm(v[:, [i, j]], axis=2).sum(axis=1)[:, None]
                rates.append(_sum(towards[0], -towards[1], size=size))
        return np.concatenate(rates, axis=1)

    def depends(self, j: int, velocities: np.ndarray) -> bool:
        """Return whether the rate of a constraint is a combination of velocities."""
        for row, matrix in zip(self._rows[:, j], velocities, strict=True):
            scaled = matrix / or_one(np.linalg.norm(matrix, axis=1))[:, None]
            shares = np.linalg.lstsq(scaled.T, row, rcond=HALF)[0]
            if not np.linalg.norm(row - shares @ scaled) <= HALF * np.linalg.norm(row):
                return False
        return True

    def joint(self, a: Body, b: Body | None) -> np.ndarray:
        """Return the relative velocities of a body and another, or the ground."""
        if b is None:
            return self.of([a])
        if is_rigid(a) or is_rigid(b):
            return self.relative([b, a])
        k, other = self._bodies.index(a), self._bodies.index(b)  # points, which do not turn
        return _sum(self._velocities[:, k, :3], -self._velocities[:, other, :3])

    @staticmethod
    def locked(joint: np.ndarray, *sides: np.ndarray) -> bool:
        """Return whether a joint has less freedom while the bodies on both sides do not move."""
        for motions, *parts in zip(joint, *sides, strict=True):
            free = _null_space(np.concatenate(parts))
            if _rank(motions @ free, motions) < _rank(motions, motions):
                return True
        return False

    def is_free(self, inside: Sequence[Body], outside: np.ndarray) -> bool:
        """Return whether bodies can move in all ways while those outside rest.

        These are six, or three if the whole system moves in a plane.
        """
        rows = slice(6 if any(map(is_rigid, inside)) else 3)
        at = [self._bodies.index(body) for body in inside]
        for motions, state in zip(self._velocities[:, :, rows], outside, strict=True):
            every, free = np.concatenate([*motions], axis=1), _null_space(state)
            if max(_rank(motions[k] @ free, motions[k]) for k in at) < _rank(every, every):
                return False
        return True


def _sum(*terms: np.ndarray, size: np.ndarray | float = 0.0) -> np.ndarray:
    """Return a sum of vectors (states, components, speeds), zero where that is rounding.

    `size` is that of numbers from which a term was computed, if they are larger than it.
    """
    sizes = size + sum(np.linalg.norm(term, axis=1, keepdims=True) for term in terms)
    return _unrounded(np.asarray(sum(terms)), np.asarray(sizes))


def _unrounded(values: np.ndarray, terms: np.ndarray) -> np.ndarray:
    return np.where(np.abs(values) > ROUNDED * terms, values, 0.0)


def _rank(matrix: np.ndarray, terms: np.ndarray) -> int:
    """Return the rank of a matrix that was computed from these terms."""
    sizes = np.linalg.svd(matrix, compute_uv=False)
    return int((sizes > HALF * np.linalg.norm(terms)).sum())


def _null_space(matrix: np.ndarray) -> np.ndarray:
    """Return an orthonormal basis of the motions without velocities, as columns."""
    scaled = matrix / or_one(np.linalg.norm(matrix, axis=1))[:, None]
    _, sizes, directions = np.linalg.svd(scaled)
    rank = int((sizes > HALF * sizes.max(initial=0.0)).sum())
    basis: np.ndarray = directions[rank:].T
    return basis
